/* A middle of its own, and the mean of the two velocities. */

static void leap(int n, double *x, double *v, double dt)
{
    double middle[60] = {0}, a[60], old;
    int i;
    for (i = 0; i < n; i++)
        middle[i] = x[i] + v[i] * dt / 2;
    acceleration(middle, a);
    for (i = 0; i < n; i++) {
        old = v[i];
        v[i] = old + a[i] * dt;
        x[i] += (old + v[i]) / 2 * dt;
    }
}

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    if (steps > 0) {
        leap((int)n, x, v, dt);
        drift_kick_drift(n, x, v, dt, steps - 1);
    }
}
