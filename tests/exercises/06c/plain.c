/* A right answer in plain C, with which wrong.diff begins. */

static double piece(int dimensions, double z, double c)
{
    if (dimensions == 2)
        return z * z * acos(c / z) - c * sqrt(z * z - c * c);
    return 3.14159265358979323846 * (z - c) * (z - c) * (2 * z + c) / 3;
}

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    double a = R1 + small, b = R2 + small, c, d;
    if (r < R1 + R2)
        return INFINITY;
    if (r >= a + b)
        return *overlap = 0;
    c = (r * r + a * a - b * b) / (2 * r);
    d = r - c;
    *overlap = piece(dimensions, a, c) + piece(dimensions, b, d);
    return -density * *overlap;
}
