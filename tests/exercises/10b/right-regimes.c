/* A right answer: one formula for each regime, and a series between. */

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    double w = sqrt(o->stiffness / o->mass);
    double z = o->damping / (2 * sqrt(o->stiffness * o->mass));
    double a = o->x, b = o->v / w, T = w * t, even, odd;
    double y = (z - 1) * (z + 1);
    if (fabs(y) * T * T < 0.01) {
        double q = y * T * T, e = exp(-z * T);
        even =
            e *
            (1 +
             q / 2 *
                 (1 + q / 12 * (1 + q / 30 * (1 + q / 56 * (1 + q / 90)))));
        odd =
            e * T *
            (1 + q / 6 *
                     (1 + q / 20 *
                              (1 + q / 42 * (1 + q / 72 * (1 + q / 110)))));
    } else if (y < 0) {
        double n = sqrt(-y);
        even = exp(-z * T) * cos(n * T);
        odd = exp(-z * T) * sin(n * T) / n;
    } else {
        double n = sqrt(y), fast = exp(-(z + n) * T), slow;
        slow = exp(-T / (z + n));
        even = slow / 2 + fast / 2;
        odd = (slow / 2 - fast / 2) / n;
    }
    *velocity = w * (b * even - (z * b + a) * odd);
    return a * even + (b + z * a) * odd;
}
