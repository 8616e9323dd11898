/* mistake: order-of-the-row */

size_t cradle(size_t n, const double mass[], double v[])
{
    size_t i, k, count = 0;
    double top = 0;
    for (i = 0; i < n; i++)
        top = fmax(top, fabs(v[i]));
    for (k = 0; k < 10000; k++)
        for (i = 0; i + 1 < n; i++)
            if (v[i] - v[i + 1] > 1e-9 * top) {
                double m = mass[i], M = mass[i + 1], a = v[i], b = v[i + 1];
                v[i] = ((m - M) * a + 2 * M * b) / (m + M);
                v[i + 1] = ((M - m) * b + 2 * m * a) / (m + M);
                count++;
            }
    return count;
}
