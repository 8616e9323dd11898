/* From chapters/07-gas.nw: edit there, then run make tangle. */
/* checksum 1972643245 of the lines below */
/* Averages speed distributions over bins, alike on every machine. */
#include "box/speeds.h"

#include <math.h>

struct speeds_law speeds_exact(size_t dimensions, size_t disks,
                               bool resting, bool component)
{
    const size_t n = dimensions * (disks - resting);
    const double part = resting ? 1 - 1 / (double)disks : 1;
    const double most = (double)n / 2 * part;
    return component ? (struct speeds_law){0, n - 3, most}
                     : (struct speeds_law){dimensions - 1,
                                           n - dimensions - 2, most};
}

struct speeds_law speeds_maxwell(size_t dimensions, bool component)
{
    return (struct speeds_law){component ? 0 : dimensions - 1, 0, 0};
}
/* Returns x^(halves / 2). */
static double half_power(double x, size_t halves)
{
    double root = sqrt(x), power = 1;
    for (; halves > 0; halves /= 2, root *= root)
        if (halves % 2)
            power *= root;
    return power;
}

/* Returns exp(-x) for 0 <= x < 100, with a relative error of 1e-11. */
static double decay(double x)
{
    double term = 1, sum = 1;
    for (int n = 1; n < 12; ++n)
        sum += term *= -x / 1024 / n;
    for (int n = 0; n < 10; ++n)
        sum *= sum;
    return sum;
}

static double law_at(const struct speeds_law *l, double u)
{
    const double left = 1 - u * u / l->most;
    const double front = half_power(u, 2 * l->rise);
    if (l->most == 0)
        return front * decay(u * u);
    return left > 0 ? front * half_power(left, l->halves) : 0;
}

double speeds_bins(const struct speeds_law *l, double width, size_t bins,
                   double density[])
{
    double all = 0, mean = 0;
    for (size_t bin = 0; bin < 2 * bins; ++bin) {
        double sum = 0;
        enum { STEPS = 64 };
        for (size_t k = 0; k <= STEPS; ++k) {
            const double u = ((double)bin + (double)k / STEPS) * width;
            const double weight = k % STEPS == 0 ? 1 : k % 2 ? 4 : 2;
            sum += weight * law_at(l, u);
            mean += weight * u * law_at(l, u);
        }
        all += sum;
        if (bin < bins)
            density[bin] = sum / width;
    }
    for (size_t bin = 0; bin < bins; ++bin)
        density[bin] /= all;
    return mean / all;
}
double speeds_fourth(const struct speeds_law *l)
{
    const double D = (double)l->rise + 1;
    const double n = (double)l->halves + D + 2;
    return l->most == 0 ? D * (D + 2) / 4
                        : l->most * l->most * D * (D + 2) / (n * (n + 2));
}
