/* mistake: cosine-for-sine */

double eccentric_anomaly(double e, double mean)
{
    double pi = acos(-1.0), a = mean - e, b = mean + e, c = mean;
    int i;
    for (i = 0; i < 200; i++) {
        c = (a + b) / 2;
        if (c - e * cos(c) < mean)
            a = c;
        else
            b = c;
    }
    return c + 0 * pi;
}
