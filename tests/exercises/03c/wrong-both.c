/* mistake: both-sides */

static double law(int n, double u)
{
    double pi = acos(-1), w = 1 - u * u, f, t;
    int k = 4 + n % 2;
    if (n % 2 == 0) {
        f = 0.5 + asin(u) / pi;
        t = u * sqrt(w) / pi;
    } else {
        f = (1 + u) / 2;
        t = u * w / 4;
    }
    for (; k <= n; k += 2) {
        f += t;
        t *= w * (k - 2) / (k - 1);
    }
    return f;
}

double velocity_below(int n, double u)
{
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    return 2 * law(n, u) - 1;
}
