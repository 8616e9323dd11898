/* A right answer in plain C, with which wrong.diff begins. */

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    double m = m1 + m2, v = sqrt(k2 * m / d);
    *v1 = v * m2 / m;
    *v2 = v * m1 / m;
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    double s = 0, pi = acos(-1.0);
    size_t j;
    for (j = 1; j < n; j++)
        s += 1 / sin(pi * (2 * j > n ? n - j : j) / n);
    return sqrt(k2 * mass * s / radius) / 2;
}
