/* A right answer: each planet asks all others. */

static void pulls(size_t n, const double gm[], double sun, double t,
                  double x[][3], double v[][3])
{
    size_t i, j;
    int k;
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            double s = 0;
            if (j == i)
                continue;
            for (k = 0; k < 3; k++)
                s += pow(x[i][k] - x[j][k], 2);
            for (k = 0; k < 3; k++)
                v[i][k] -= t * gm[j] * (x[i][k] - x[j][k]) / (s * sqrt(s));
        }
    (void)sun;
}

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    size_t i;
    pulls(n, gm, sun, dt / 2, x, v);
    for (i = 0; i < n; i++)
        drift(sun, dt, x[i], v[i]);
    pulls(n, gm, sun, dt / 2, x, v);
}
