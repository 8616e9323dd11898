/* A right answer: each law from the one before, called by name. */

static double constant(int n)
{
    return exp(lgamma(0.5 * n) - lgamma(0.5 * n - 0.5)) / sqrt(acos(-1));
}

double velocity_below(int n, double u)
{
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    if (n == 2)
        return 1 - acos(u) / acos(-1);
    if (n == 3)
        return (u + 1) / 2;
    return velocity_below(n - 2, u) +
           constant(n) * u * pow(1 - u * u, (n - 3) / 2.0) / (n - 2);
}
