/* mistake: stops-early */

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    edge[0] = low;
    edge[bins] = high;
    for (k = 1; k < bins; k++) {
        double a = low, b = high;
        while (b - a > 1e-8) {
            double c = (a + b) / 2;
            if (distribution(c) < (double)k / (double)bins)
                a = c;
            else
                b = c;
        }
        edge[k] = a;
    }
}
