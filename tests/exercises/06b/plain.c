/* A right answer in plain C, with which wrong.diff begins. */

static int allowed(size_t n, double radius, double dish, const double x[],
                   const double y[], size_t i, double a, double b)
{
    double room = dish - radius;
    size_t k;
    if (a * a + b * b > room * room)
        return 0;
    for (k = 0; k < n; k++)
        if (k != i && (a - x[k]) * (a - x[k]) + (b - y[k]) * (b - y[k]) <
                          4 * radius * radius)
            return 0;
    return 1;
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    double sum = 0;
    size_t t, k;
    *accepted = 0;
    for (t = 0; t < tries; t++) {
        size_t i = (size_t)((double)n * uniform());
        double a = x[i] + step * (2 * uniform() - 1);
        double b = y[i] + step * (2 * uniform() - 1);
        if (allowed(n, radius, dish, x, y, i, a, b)) {
            x[i] = a;
            y[i] = b;
            ++*accepted;
        }
        for (k = 0; k < n; k++)
            sum += x[k] * x[k] + y[k] * y[k];
    }
    return sum / ((double)n * (double)tries);
}
