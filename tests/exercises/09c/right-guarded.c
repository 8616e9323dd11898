/* Newton's rule for what is added to M, from the middle; whenever it leaves
   what is known, the interval is halved instead. */

double eccentric_anomaly(double e, double mean)
{
    double a = -e, b = e, d = 0, turns = floor(mean / 6.283185307179586);
    double m = mean - turns * 6.283185307179586;
    for (int left = 300; left > 0 && b > a; left--) {
        const double rest = d - e * sin(m + d);
        const double newton = d - rest / (1 - e * cos(m + d));
        if (fabs(newton - d) <= 0)
            return mean + newton;
        *(rest > 0 ? &b : &a) = d;
        d = newton > a && newton < b ? newton : a + 0.5 * (b - a);
    }
    return mean + d;
}
