/* A right answer: the disk is moved, and put back where it may not be; the
   average is kept up to date by the change of one disk. */

static double far(double x, double y)
{
    return x * x + y * y;
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    double now = 0, mean = 0;
    size_t t, k;
    for (k = 0; k < n; k++)
        now += far(x[k], y[k]) / (double)n;
    *accepted = tries;
    for (t = 1; t <= tries; t++) {
        size_t i = (size_t)((double)n * uniform());
        double old_x = x[i], old_y = y[i];
        int bad;
        x[i] += step * (2 * uniform() - 1);
        y[i] += step * (2 * uniform() - 1);
        bad = far(x[i], y[i]) > (dish - radius) * (dish - radius);
        for (k = 0; k < n; k++)
            if (k != i &&
                far(x[i] - x[k], y[i] - y[k]) < 4 * radius * radius)
                bad = 1;
        if (bad) {
            x[i] = old_x;
            y[i] = old_y;
            --*accepted;
        } else {
            now += (far(x[i], y[i]) - far(old_x, old_y)) / (double)n;
        }
        mean += (now - mean) / (double)t;
    }
    return mean;
}
