/* A right answer: u is the sine of an angle, and Simpson does the rest. */

enum { PANELS = 20000 };

static double simpson(int power, double to)
{
    double h = to / PANELS, odd = 0, even = 0;
    int i;
    for (i = 1; i < PANELS; i += 2)
        odd += pow(cos(i * h), power);
    for (i = 2; i < PANELS; i += 2)
        even += pow(cos(i * h), power);
    return h / 3 * (1 + 4 * odd + 2 * even + pow(cos(to), power));
}

double velocity_below(int n, double u)
{
    if (u >= 1)
        return 1;
    if (u <= -1)
        return 0;
    return 0.5 + 0.5 * simpson(n - 2, asin(u)) / simpson(n - 2, acos(0.0));
}
