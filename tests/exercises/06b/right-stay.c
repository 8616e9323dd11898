/* A right answer: each placing is weighed with the tries that it lasts. */

static double squares(size_t n, const double x[], const double y[])
{
    double all = 0;
    while (n-- > 0)
        all += x[n] * x[n] + y[n] * y[n];
    return all;
}

static bool in_the_way(size_t n, double d, const double x[],
                       const double y[], size_t i, double a, double b)
{
    size_t k;
    for (k = 0; k < n; k++)
        if (k != i && hypot(x[k] - a, y[k] - b) < d)
            return true;
    return false;
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    double sum = 0;
    size_t stay = 0, moves = 0, left;
    for (left = tries; left > 0; left--) {
        size_t i = (size_t)(uniform() * (double)n);
        double a = x[i] - step + 2 * step * uniform();
        double b = y[i] - step + 2 * step * uniform();
        if (hypot(a, b) > dish - radius ||
            in_the_way(n, 2 * radius, x, y, i, a, b)) {
            stay++;
            continue;
        }
        sum += (double)stay * squares(n, x, y);
        x[i] = a;
        y[i] = b;
        moves++;
        stay = 1;
    }
    *accepted = moves;
    sum += (double)stay * squares(n, x, y);
    return sum / (double)n / (double)tries;
}
