/* A right answer: find the edge in the middle, then do the same on either
   side of it; false position where it pays, halving where it does not. */

static double (*law)(double x);
static double share;

static double find(double a, double b, double target)
{
    double fa = law(a) - target, fb = law(b) - target;
    int turn = 0;
    while (nextafter(a, b) < b) {
        double c = (a + b) / 2, f;
        if (turn++ % 2 == 0 && fb > fa) {
            double guess = a - (b - a) * fa / (fb - fa);
            if (a < guess && guess < b)
                c = guess;
        }
        f = law(c) - target;
        if (f == 0)
            return c;
        if (f > 0) {
            b = c;
            fb = f;
        } else {
            a = c;
            fa = f;
        }
    }
    return -fa < fb ? a : b;
}

static void between(double edge[], size_t first, size_t last)
{
    size_t middle = first + (last - first) / 2;
    if (last - first < 2)
        return;
    edge[middle] = find(edge[first], edge[last], (double)middle * share);
    between(edge, first, middle);
    between(edge, middle, last);
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    law = distribution;
    share = 1 / (double)bins;
    edge[0] = low;
    edge[bins] = high;
    between(edge, 0, bins);
}
