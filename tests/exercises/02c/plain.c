/* A right answer in plain C, with which wrong.diff begins. */

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    size_t i, j;

    for (i = 0; i < n; i++) {
        double y = x0[i] + v0[i] * t, w = v0[i];
        y = fmod(y, 2 * length);
        if (y < 0)
            y += 2 * length;
        if (y > length) {
            y = 2 * length - y;
            w = -w;
        }
        x[i] = y;
        v[i] = w;
    }
    for (i = 1; i < n; i++)
        for (j = i; j > 0 && x[j] < x[j - 1]; j--) {
            double a = x[j];
            x[j] = x[j - 1];
            x[j - 1] = a;
            a = v[j];
            v[j] = v[j - 1];
            v[j - 1] = a;
        }
}
