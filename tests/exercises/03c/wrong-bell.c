/* mistake: bell-for-the-law */

double velocity_below(int n, double u)
{
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    return 0.5 * erfc(-u * sqrt(n / 2.0));
}
