/* A right answer in plain C, with which wrong.diff begins. */

static int hits(size_t i, size_t j, const double r[], const double x[],
                const double y[])
{
    double dx = x[i] - x[j], dy = y[i] - y[j];
    return dx * dx + dy * dy < (r[i] + r[j]) * (r[i] + r[j]);
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t i = 0, j, throws = 1;
    while (i < n) {
        x[i] = radius[i] + (width - 2 * radius[i]) * uniform();
        y[i] = radius[i] + (height - 2 * radius[i]) * uniform();
        for (j = 0; j < i; j++)
            if (hits(i, j, radius, x, y))
                break;
        if (j < i) {
            throws++;
            i = 0;
        } else
            i++;
    }
    return throws;
}
