/* A right answer: a hundred halvings of the whole range for each edge. */

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    int i;
    for (k = 0; k <= bins; k++) {
        double a = low, b = high;
        for (i = 0; i < 100; i++) {
            double c = (a + b) / 2;
            if (distribution(c) * (double)bins > (double)k)
                b = c;
            else
                a = c;
        }
        edge[k] = (a + b) / 2;
    }
    edge[0] = low;
    edge[bins] = high;
}
