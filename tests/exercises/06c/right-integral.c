/* A right answer: the overlap is the integral of the chord, by Gauss with
   20 points; a substitution takes away the root at the far end. */

static double section(int dimensions, double a, double b, double r)
{
    double c = (r * r + a * a - b * b) / (2 * r);
    double s2 = fmax(0, (a - c) * (a + c));
    return dimensions == 2 ? 2 * sqrt(s2) : acos(-1.0) * s2;
}

static double integral(int dimensions, double a, double b, double r)
{
    static const double x[] = {0.0765265211334973, 0.2277858511416451,
                               0.3737060887154196, 0.5108670019508271,
                               0.6360536807265150, 0.7463319064601508,
                               0.8391169718222188, 0.9122344282513259,
                               0.9639719272779138, 0.9931285991850949};
    static const double w[] = {0.1527533871307258, 0.1491729864726037,
                               0.1420961093183821, 0.1316886384491766,
                               0.1181945319615184, 0.1019301198172404,
                               0.0832767415767047, 0.0626720483341091,
                               0.0406014298003869, 0.0176140071391521};
    double sum = 0, end = a + b, width = sqrt(end - r);
    int k, side;
    for (k = 0; k < 10; k++)
        for (side = -1; side <= 1; side += 2) {
            double t = 0.5 * width * (1 + side * x[k]);
            sum += w[k] * 0.5 * width * 2 * t *
                   section(dimensions, a, b, end - t * t);
        }
    return sum;
}

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    *overlap = 0;
    if (r < R1 + R2)
        return HUGE_VAL;
    if (r < R1 + R2 + 2 * small)
        *overlap = integral(dimensions, R1 + small, R2 + small, r);
    return -(density * *overlap);
}
