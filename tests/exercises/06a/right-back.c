/* A right answer: one loop, and back to the first disk at an overlap. */

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t i = 0, j, throws = 0;
    while (i < n) {
        double r = radius[i];
        if (i == 0)
            throws++;
        x[i] = uniform() * (width - r - r) + r;
        y[i] = uniform() * (height - r - r) + r;
        for (j = 0; j < i; j++)
            if (hypot(x[j] - x[i], y[j] - y[i]) < radius[j] + r)
                break;
        i = j < i ? 0 : i + 1;
    }
    return throws;
}
