/* Circles and their periods; for the choreography the pull of each body,
   part by part. */

#define PI 3.14159265358979323846

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    double period = 2 * PI * sqrt(d * d * d / (k2 * (m1 + m2)));
    double r1 = d * m2 / (m1 + m2), r2 = d * m1 / (m1 + m2);
    *v1 = 2 * PI * r1 / period;
    *v2 = 2 * PI * r2 / period;
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    double inwards = 0;
    size_t j;
    for (j = 1; j < n; j++) {
        size_t near = 2 * j > n ? n - j : j;
        double chord = 2 * radius * sin(PI * near / n);
        inwards += k2 * mass / (chord * chord) * (chord / 2 / radius);
    }
    return sqrt(inwards * radius);
}
