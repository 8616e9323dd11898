/* Half drifts that meet are one. */

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    double a[60], h = dt / 2;
    size_t s, i;
    if (steps == 0)
        return;
    for (i = 0; i < n; i++)
        x[i] += h * v[i];
    for (s = 1;; s++) {
        acceleration(x, a);
        for (i = 0; i < n; i++) {
            v[i] += dt * a[i];
            x[i] += (s < steps ? dt : h) * v[i];
        }
        if (s == steps)
            return;
    }
}
