/* The virial theorem: on circles, twice the kinetic energy is minus the
   potential energy. */

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    double total = m1 + m2;
    *v1 = m2 * sqrt(k2 / (total * d));
    *v2 = m1 * sqrt(k2 / total / d);
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    long double pairs = 0, pi = acosl(-1);
    for (size_t j = n; j-- > 1;)
        pairs += 1 / (2 * radius * sinl(pi * j / n));
    return (double)sqrtl(k2 * mass * pairs / 2);
}
