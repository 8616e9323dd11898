/* A right answer: the exponent bit by bit, and never 1 minus it. */

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double s = v / sqrt(mean_square) * (v / sqrt(mean_square)) / n;
    double b = 0;
    int bit, k = n - 1;
    *fourth = mean_square * mean_square * (2 - 2 / (n + 1.0));
    if (!(v > 0))
        return 0;
    if (s > 1)
        return 1;
    for (bit = 1 << 30; bit > 0; bit /= 2) {
        b = b * (2 - b);
        if (k & bit)
            b += s * (1 - b);
    }
    return b;
}
