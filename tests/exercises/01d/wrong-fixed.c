/* mistake: target-held-fast */

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double ratio = im2 / im1;
    double s = ratio * sin(deflection);
    double chi;
    if (s > 1 || (ratio >= 1 && cos(deflection) < 0))
        return -1;
    chi = deflection;
    return (r1 + r2) * cos(chi / 2);
}
