/* A right answer in plain C, with which wrong.diff begins. */

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    double a[60], h = 0.5 * dt;
    size_t i, s;
    for (s = 0; s < steps; s++) {
        for (i = 0; i < n; i++)
            x[i] += h * v[i];
        acceleration(x, a);
        for (i = 0; i < n; i++)
            v[i] += dt * a[i];
        for (i = 0; i < n; i++)
            x[i] += h * v[i];
    }
}
