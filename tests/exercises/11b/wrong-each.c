/* mistake: each-pair-once */

size_t cradle(size_t n, const double mass[], double v[])
{
    double x[100], top = 0;
    size_t i, k, count = 0;
    for (i = 0; i < n; i++) {
        x[i] = i;
        top = fmax(top, fabs(v[i]));
    }
    for (;;) {
        double first = INFINITY, t, a, b, m, M;
        k = n;
        for (i = 1; i < n; i++)
            if (v[i - 1] - v[i] > 1e-9 * top) {
                t = (x[i] - x[i - 1]) / (v[i - 1] - v[i]);
                if (t < first) {
                    first = t;
                    k = i;
                }
            }
        if (k == n || count + 1 == n)
            return count;
        for (i = 0; i < n; i++)
            x[i] += v[i] * first;
        a = v[k - 1];
        b = v[k];
        m = mass[k - 1];
        M = mass[k];
        v[k - 1] = a + 2 * M * (b - a) / (m + M);
        v[k] = b - 2 * m * (b - a) / (m + M);
        count++;
    }
}
