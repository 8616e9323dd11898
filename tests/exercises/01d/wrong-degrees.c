/* mistake: degrees-for-radians */

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double d = deflection * acos(-1.0) / 180;
    double ratio = im2 / im1;
    double s = ratio * sin(d);
    if (s > 1 || (ratio >= 1 && deflection > 90))
        return -1;
    return (r1 + r2) * cos((d + asin(s)) / 2);
}
