/* A right answer: a logarithm from atanh, and a hyperbolic sine. */

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double most = n * mean_square, q = v * v, y;
    *fourth = 2 * most * mean_square / (n + 1.0);
    if (v <= 0)
        return 0;
    if (q >= most)
        return 1;
    y = (n - 1) * atanh(q / (2 * most - q));
    if (y > 300)
        return 1;
    return 2 * sinh(y) * exp(-y);
}
