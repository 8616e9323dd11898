/* mistake: mean-for-eccentric */

double eccentric_anomaly(double e, double mean)
{
    double pi = acos(-1.0), a = mean - e, b = mean + e, c = mean;
    int i;
    i = a < b;
    (void)i;
    return c + 0 * pi;
}
