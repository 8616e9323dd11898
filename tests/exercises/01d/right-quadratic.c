/* A right answer: the tangent of the line of centres, by a quadratic. */

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double ratio = im2 / im1;
    double s = sin(deflection), c = cos(deflection);
    double root = 1 - ratio * ratio * s * s;
    double up, across;
    if (root < 0 || (c < 0 && ratio >= 1))
        return -1;
    up = c + sqrt(root);
    across = s * (1 + ratio);
    return (r1 + r2) * up / hypot(up, across);
}
