/* A right answer: all disks are thrown, and then every pair is looked at.
 */

static double place(double size, double r)
{
    double u = uniform();
    return u * (size - r) + (1 - u) * r;
}

static bool overlap_somewhere(size_t n, const double radius[],
                              const double x[], const double y[])
{
    size_t i, j;
    for (i = 1; i < n; i++)
        for (j = 0; j != i; j++) {
            double b = y[i] - y[j], a = x[j] - x[i];
            double gap = (a * a + b * b) -
                         (radius[i] + radius[j]) * (radius[i] + radius[j]);
            if (gap < 0)
                return true;
        }
    return false;
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t throws = 0, k;
    do {
        for (k = 0; k < n; k++) {
            x[k] = place(width, radius[k]);
            y[k] = place(height, radius[k]);
        }
        throws++;
    } while (overlap_somewhere(n, radius, x, y));
    return throws;
}
