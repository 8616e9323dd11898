/* The hidden tests of exercise 03a, "Bins of equal probability". */

#include "examiner/check.h"

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[]);

enum { MOST = 24 };

/* A law of two parts, one even and one with a hump in its middle; drawn. */
static double low, high, hump;
static double unit = 1.0; /* places are given in such units */

static double below(double x)
{
    const double y = (x * unit - low) / (high - low);
    return (1.0 - hump) * y + hump * y * y * (3.0 - 2.0 * y);
}

static double mirrored(double x)
{
    return 1.0 - below(-x);
}

static void draw_law(void)
{
    low = check_draw_whole(-80, 80) / 8.0;
    high = low + check_draw_whole(4, 80) / 8.0;
    hump = check_draw(0.1, 0.9);
}

static const char *input(size_t bins)
{
    return check_text("the law %g y + %g (3 y^2 - 2 y^3), y from 0 to 1 "
                      "between x = %g and %g; %zu bins",
                      1.0 - hump, hump, low, high, bins);
}

/* Both edges compared may err by as much. */
static double tolerance(void)
{
    return 16.0 * DBL_EPSILON *
           (fmax(fabs(low), fabs(high)) + (high - low) / (1.0 - hump));
}

static void check_edge(const char *quantity, size_t bins, double got,
                       double expected)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input(bins),
               .expected = expected, .tolerance = tolerance(),
               .because = "16 epsilons of the larger end, and of the "
                          "probability divided by the density");
}

CHECK_TIMES(3, test_mirror, i)
{
    draw_law();
    const size_t bins = (size_t)check_draw_whole(2, MOST / 2);
    double edge[MOST + 1], other[MOST + 1];
    equal_bins(below, low, high, bins, edge);
    equal_bins(mirrored, -high, -low, bins, other);
    const size_t one = (size_t)check_draw_whole(0, (int)bins - 1);
    const double more = below(edge[one + 1]) - below(edge[one]);
    CHECK_NEAR(more, .quantity = check_text("probability of bin %zu", one),
               .input = input(bins), .expected = 1.0 / (double)bins,
               .tolerance =
                   2.0 * tolerance() / (high - low) * (1.0 + 0.5 * hump),
               .because = "that of two edges, times the density");
    for (size_t k = 0; k <= bins; ++k)
        check_edge(check_text("edge[%zu] of the law in a mirror", k), bins,
                   other[k], -edge[bins - k]);
}

/* In micrometres and in megametres the edges are the same places. */
CHECK_TIMES(2, test_units, i)
{
    static const double units[] = {1e-6, 1e6};
    draw_law();
    const size_t bins = (size_t)check_draw_whole(2, MOST / 2);
    double edge[MOST + 1], other[MOST + 1];
    equal_bins(below, low, high, bins, edge);
    unit = units[i];
    equal_bins(below, low / unit, high / unit, 2 * bins, other);
    for (size_t k = 0; k <= bins; ++k)
        check_edge(
            check_text("edge[%zu] of twice as many bins, in units of %g",
                       2 * k, unit),
            bins, other[2 * k] * unit, edge[k]);
    unit = 1.0;
}

const struct check_test check_hidden[] = {
    {"the mirror image of a law has the mirrored edges", test_mirror, 2, 0},
    {"other units and bins cut in two keep the edges", test_units, 2, 0},
    {0}};
