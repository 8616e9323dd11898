/* mistake: left-empty */

static double search(double (*f)(double x), double a, double b,
                     double target)
{
    int i;
    for (i = 0; i < 100; i++) {
        double c = (a + b) / 2;
        if (f(c) < target)
            a = c;
        else
            b = c;
    }
    return (a + b) / 2;
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    edge[0] = low;
    for (k = 1; k < bins; k++)
        edge[k] = search(distribution, low, high, (double)k / (double)bins);
}
