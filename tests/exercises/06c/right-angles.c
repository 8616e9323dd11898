/* A right answer: two sectors less a kite; two balls by one formula. */

static double flat(double a, double b, double r)
{
    double u = (r * r + a * a - b * b) / (2 * r * a);
    double v = (r * r + b * b - a * a) / (2 * r * b);
    double alpha = acos(u), beta = acos(v);
    return a * a * (alpha - 0.5 * sin(2 * alpha)) +
           b * b * (beta - 0.5 * sin(2 * beta));
}

static double round_one(double a, double b, double r)
{
    double t = a + b - r;
    return acos(-1.0) * t * t *
           (r * r + 2 * r * (a + b) - 3 * (a - b) * (a - b)) / (12 * r);
}

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    double a = R1 + small, b = R2 + small;
    if (r < R1 + R2)
        return 1 / 0.0;
    if (r < a + b)
        *overlap = dimensions == 3 ? round_one(a, b, r) : flat(a, b, r);
    else
        *overlap = 0;
    return *overlap * -density;
}
