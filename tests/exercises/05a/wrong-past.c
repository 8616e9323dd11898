/* mistake: time-in-the-past */

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    double s = box - radius;
    double a = v[0] * v[0] + v[1] * v[1];
    double b = r[0] * v[0] + r[1] * v[1];
    double c = r[0] * r[0] + r[1] * r[1] - s * s;
    double d = b * b - a * c;
    if (a == 0)
        return INFINITY;
    if (d < 0)
        d = 0;
    return (sqrt(d) - b) / a;
}
