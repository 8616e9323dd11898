/* A right answer in plain C, with which wrong.diff begins. */

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double x = v * v / (n * mean_square), m = mean_square;
    *fourth = 2.0 * n / (n + 1) * m * m;
    if (v <= 0)
        return 0;
    if (x >= 1)
        return 1;
    return -expm1((n - 1) * log1p(-x));
}
