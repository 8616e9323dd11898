/* The suite of exercise 03a, "Bins of equal probability". */

#include "examiner/check.h"

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[]);

enum { MOST = 24 };

/* A law: its distribution function, that turned round, and the density. */
struct law {
    const char *name;
    double (*below)(double x);
    double (*place)(double p);
    double (*density)(double x);
    double low, high;
};

static double pi(void)
{
    return acos(-1.0);
}

static double even_below(double x)
{
    return x;
}

static double even_density(double x)
{
    (void)x;
    return 1.0;
}

static const struct law even = {
    "the same everywhere", even_below, even_below, even_density, 0.0, 1.0};

static double ramp_below(double x)
{
    return x * x;
}

static double ramp_density(double x)
{
    return 2.0 * x;
}

static const struct law ramp = {
    "distribution(x) = x^2", ramp_below, sqrt, ramp_density, 0.0, 1.0};

static double arcsine_below(double x)
{
    return x <= -1.0 ? 0.0 : x >= 1.0 ? 1.0 : 1.0 - acos(x) / pi();
}

static double arcsine_place(double p)
{
    return -cos(pi() * p);
}

static double arcsine_density(double x)
{
    return 1.0 / (pi() * sqrt((1.0 - x) * (1.0 + x)));
}

static const struct law arcsine = {"two movers, the arcsine law",
                                   arcsine_below,
                                   arcsine_place,
                                   arcsine_density,
                                   -1.0,
                                   1.0};

/* A falling exponential between 5 and 25. */
static double fall_below(double x)
{
    return x >= 25.0 ? 1.0 : expm1(5.0 - x) / expm1(-20.0);
}

static double fall_place(double p)
{
    return 5.0 - log1p(p * expm1(-20.0));
}

static double fall_density(double x)
{
    return -exp(5.0 - x) / expm1(-20.0);
}

static const struct law fall = {
    "falling as exp(-x)", fall_below, fall_place, fall_density, 5.0, 25.0};

/* Nearly a step at 0.3, a thousand-millionth wide. */
enum { STEEP = 1000000000 };

static double steep_angle(double x)
{
    return atan((x - 0.3) * STEEP);
}

static double steep_below(double x)
{
    const double first = steep_angle(-1.0), last = steep_angle(1.0);
    return x >= 1.0 ? 1.0 : (steep_angle(x) - first) / (last - first);
}

static double steep_place(double p)
{
    const double first = steep_angle(-1.0), last = steep_angle(1.0);
    return 0.3 + tan(first + p * (last - first)) / STEEP;
}

static double steep_density(double x)
{
    const double y = (x - 0.3) * STEEP;
    return STEEP / (pi() * (1.0 + y * y));
}

static const struct law steep = {
    "nearly a step at 0.3", steep_below, steep_place,
    steep_density,          -1.0,        1.0};

/* So crowded at 0 that one half of it lies below 2e-10, and a third below
   5e-16: to its last digit an edge takes some ninety halvings. */
static double crowded_below(double x)
{
    return sqrt(sqrt(sqrt(sqrt(sqrt(x)))));
}

static double crowded_place(double p)
{
    return pow(p, 32.0);
}

static double crowded_density(double x)
{
    return crowded_below(x) / (32.0 * x);
}

static const struct law crowded = {
    "the 32nd root of x", crowded_below, crowded_place,
    crowded_density,      0.0,           1.0};

/* Nothing up to 1/4, two equal lumps to 3/8 and from 5/8, nothing from 3/4
   on. */
static double lumps_below(double x)
{
    const double first = fmin(fmax(4.0 * (x - 0.25), 0.0), 0.5);
    return first + fmin(fmax(4.0 * (x - 0.625), 0.0), 0.5);
}

/* Three powers mixed in whole parts: no formula for the place. */
static int part[3];
static double mixed_low, mixed_width;

static double mixed_below(double x)
{
    const double y = (x - mixed_low) / mixed_width;
    return (part[0] * y + part[1] * y * y + part[2] * y * y * y * y * y) /
           (part[0] + part[1] + part[2]);
}

/* A line bent at drawn corners, between which it always rises by the same:
   the corners are the edges of as many bins. */
enum { CORNERS = 8 };
static double corner[CORNERS];
static size_t pieces, asked_outside;

static double bent_below(double x)
{
    size_t k = 0;
    asked_outside += !(x >= corner[0] && x <= corner[pieces]);
    while (k + 1 < pieces && x > corner[k + 1])
        ++k;
    return ((double)k + (x - corner[k]) / (corner[k + 1] - corner[k])) /
           (double)pieces;
}

static double bent_place(double p)
{
    const double along = p * (double)pieces;
    const size_t k = (size_t)fmin(along, (double)pieces - 1.0);
    return corner[k] + (along - (double)k) * (corner[k + 1] - corner[k]);
}

/* That of the widest piece: the least there is. */
static double bent_density(double x)
{
    double widest = 0.0;
    (void)x;
    for (size_t k = 0; k < pieces; ++k)
        widest = fmax(widest, corner[k + 1] - corner[k]);
    return 1.0 / (widest * (double)pieces);
}

/* Corners in eighths, which a report shows whole. */
static const char *draw_corners(void)
{
    pieces = (size_t)check_draw_whole(3, CORNERS - 1);
    corner[0] = check_draw_whole(-400, 400) / 8.0;
    const char *list = check_text("straight from {%g", corner[0]);
    for (size_t k = 0; k < pieces; ++k) {
        corner[k + 1] = corner[k] + check_draw_whole(1, 60) / 8.0;
        list = check_text("%s, %g", list, corner[k + 1]);
    }
    return check_text("%s} to the next, rising by 1/%zu each", list,
                      pieces);
}

static void answer(const struct law *l, size_t bins, double edge[])
{
    check_about(check_text("the law %s, from %g to %g, %zu bins", l->name,
                           l->low, l->high, bins));
    for (size_t k = 0; k <= MOST; ++k)
        edge[k] = CHECK_EMPTY;
    equal_bins(l->below, l->low, l->high, bins, edge);
}

static const char empty[] =
    "Not a number: nothing was ever put into this place. How many edges "
    "have %zu bins, the two ends included?";

static const char turned_round[] =
    "Your edges fall from high to low. Is distribution(x) the probability "
    "below x or above it?";

static const char miscounted[] =
    "This place has the probability k/(bins + 1) below it. How many bins "
    "are there, and how many edges?";

/* The first and the last edge must be what was given, to the last bit. */
static void check_end(const struct law *l, size_t bins, bool last,
                      double got)
{
    static const char searched[] = "So near, and not the end itself. Its "
                                   "place was given: why search for it?";
    const double end = last ? l->high : l->low, off = got - end;
    const char *quantity =
        last ? "the last edge, edge[bins]" : "the first edge, edge[0]";
    static const char because[] = "the ends are given, not computed";
    if (off != 0.0 && fabs(off) < 0.01 * (l->high - l->low))
        CHECK_NEAR(off,
                   .quantity = check_text("%s, minus %s", quantity,
                                          last ? "high" : "low"),
                   .because = because, .question = searched,
                   .mistakes = {{"ends-searched-for", off, searched}});
    CHECK_NEAR(
        got, .quantity = quantity, .expected = end, .because = because,
        .question = "Where do the bins begin, and where do they end?",
        .mistakes = {
            {"left-empty", CHECK_EMPTY, check_text(empty, bins)},
            {"from-the-top", last ? l->low : l->high, turned_round},
            {"bins-miscounted",
             last ? l->place((double)bins / ((double)bins + 1.0)) : end,
             miscounted}});
}

/* An inner edge. Bisection ends within an epsilon of the larger end; the
   roundings of the distribution function, divided by its slope, come on
   top. A function that is computed to a few epsilons of itself, not of 1,
   gives an edge near zero all its digits. */
static void check_edge(const struct law *l, size_t bins, size_t k,
                       double got)
{
    const double b = (double)bins, p = (double)k / b;
    const double expected = l->place(p);
    const double larger = fmax(fabs(l->low), fabs(l->high));
    const bool near_zero = l == &crowded;
    const double tolerance =
        8.0 * DBL_EPSILON *
        (near_zero ? expected + p / l->density(expected)
                   : larger + 1.0 / l->density(expected));
    const char *because = near_zero
                              ? "8 epsilons of the edge, and of the "
                                "probability divided by the density"
                              : "8 epsilons of the larger end, and of the "
                                "probability divided by the density";
    const char *quantity = check_text("edge[%zu]", k);
    const double off = got - expected;
    if (fabs(off) > tolerance && fabs(off) < 1e-4 * (l->high - l->low))
        CHECK_NEAR(
            off, .quantity = check_text("%s, minus its place", quantity),
            .tolerance = tolerance, .because = because,
            .mistakes = {{"stops-early", off,
                          "Your search is on the right way and stops too "
                          "early. What makes it stop? Can it go on until "
                          "no number is left between the two ends?"}});
    CHECK_NEAR(got, .quantity = quantity, .expected = expected,
               .tolerance = tolerance, .because = because,
               .mistakes = {
                   {"equal-widths", l->low + (l->high - l->low) * p,
                    "These bins are equally wide. What is the probability "
                    "of the first of them, and what should it be?"},
                   {"from-the-top", l->place(1.0 - p), turned_round},
                   {"bins-miscounted", l->place((double)k / (b + 1.0)),
                    miscounted},
                   {"middles-of-bins", l->place(p - 0.5 / b),
                    "This is where half of a bin's probability lies to the "
                    "left. Is an edge in the middle of a bin?"},
                   {"between-0-and-1", fmin(fmax(expected, 0.0), 1.0),
                    "Your search looks between 0 and 1 only. That is where "
                    "the probabilities lie; where do the places lie?"},
                   {"left-empty", CHECK_EMPTY, check_text(empty, bins)}});
}

static void check_law(const struct law *l, size_t bins)
{
    double edge[MOST + 1];
    answer(l, bins, edge);
    check_end(l, bins, false, edge[0]);
    check_end(l, bins, true, edge[bins]);
    for (size_t k = 1; k < bins; ++k)
        check_edge(l, bins, k, edge[k]);
}

static void test_even(void)
{
    check_ask("Here every piece of the same length has the same "
              "probability. How wide is a quarter of it?");
    check_law(&even, 4);
}

static void test_by_hand(void)
{
    check_ask(
        "Here distribution(x) is x squared. For which x is it k/bins?");
    check_law(&ramp, 4);
    check_law(&ramp, 9);
}

static void test_arcsine(void)
{
    check_ask("Two movers are most often found near their greatest speed. "
              "Where must the narrow bins lie, then?");
    check_law(&arcsine, 3);
    check_law(&arcsine, 12);
}

static void test_anywhere(void)
{
    check_ask("This law begins at 5 and has a long tail. Does your search "
              "know where the law begins and where it ends?");
    check_law(&fall, 20);
}

static void check_shares(const struct law *l, size_t bins)
{
    const double larger = fmax(fabs(l->low), fabs(l->high));
    double edge[MOST + 1];
    answer(l, bins, edge);
    for (size_t k = 0; k < bins; ++k)
        CHECK_NEAR(l->below(edge[k + 1]) - l->below(edge[k]),
                   .quantity = check_text("probability of bin %zu", k),
                   .expected = 1.0 / (double)bins,
                   .tolerance = 8.0 * DBL_EPSILON *
                                (1.0 + 5.0 * larger / mixed_width),
                   .because = "8 epsilons, and of the larger end times the "
                              "density, which is at most 5 over the width",
                   .question = "Every bin should have the same. Which of "
                               "its two edges is at fault?");
}

CHECK_TIMES(3, test_shares, i)
{
    for (int k = 0; k < 3; ++k)
        part[k] = check_draw_whole(1, 9);
    mixed_low = check_draw_whole(-36, 36) / 4.0;
    mixed_width = check_draw_whole(8, 80) / 4.0;
    const struct law mixed = {
        check_text(
            "(%d y + %d y^2 + %d y^5)/%d with y = (x - low)/(high - low)",
            part[0], part[1], part[2], part[0] + part[1] + part[2]),
        mixed_below,
        NULL,
        NULL,
        mixed_low,
        mixed_low + mixed_width};
    check_shares(&mixed, (size_t)check_draw_whole(2, 12));
}

/* limit: 1 (bin) */
static void test_one_bin(void)
{
    check_ask("How many edges has a single bin?");
    check_law(&fall, 1);
}

static void test_flat(void)
{
    static const char searched[] =
        "From here on the law is flat, so every place has the same "
        "probability below it. Which of them was given as the end?";
    const struct law lumps = {"two lumps with nothing between and beside",
                              lumps_below,
                              NULL,
                              NULL,
                              0.0,
                              1.0};
    double edge[MOST + 1];
    answer(&lumps, 4, edge);
    for (size_t k = 0; k <= 4; k += 4)
        CHECK_NEAR(edge[k], .quantity = check_text("edge[%zu]", k),
                   .expected = 0.25 * (double)k,
                   .because = "the ends are given, not computed",
                   .question = searched,
                   .mistakes = {{"ends-searched-for", 0.25, searched},
                                {"ends-searched-for", 0.75, searched}});
    for (size_t k = 1; k < 4; ++k)
        CHECK_NEAR(
            lumps_below(edge[k]),
            .quantity = check_text("probability below edge[%zu]", k),
            .expected = 0.25 * (double)k, .tolerance = 16.0 * DBL_EPSILON,
            .because = "16 epsilons: the density is 4",
            .question =
                "A flat piece has many places with the same probability "
                "below. Does your search come to one of them?");
}

/* limit: 1e-6 (a tolerance, and any other: 1e-15, or sixty halvings) */
static void test_steep(void)
{
    check_ask("Here all edges lie within a few thousand-millionths. How "
              "does your search know when it is near enough?");
    check_law(&steep, 8);
    check_ask("Here an edge lies near 0, where a double has more digits "
              "behind the point than anywhere else. How does your search "
              "know when none is left?");
    check_law(&crowded, 2);
    check_law(&crowded, 3);
}

static void test_drawn(void)
{
    check_ask("This law rises by the same from corner to corner. In which "
              "piece must this edge lie?");
    asked_outside = 0;
    for (int i = 0; i < 5; ++i) {
        const char *name = draw_corners();
        const struct law bent = {name,         bent_below, bent_place,
                                 bent_density, corner[0],  corner[pieces]};
        const size_t many = (size_t)check_draw_whole(1, MOST / 2);
        check_law(&bent, pieces);
        check_law(&bent, many);
        CHECK_NEAR(
            (double)asked_outside,
            .quantity =
                "how often distribution() was asked outside low to high",
            .because = "it is given from low to high",
            .question = "Between which two places must an edge lie, "
                        "whatever the law is?");
    }
}

const struct check_suite check_suite = {
    .file = "03a-bins.c",
    .title = "Bins of equal probability",
    .minutes = 15,
    .equation = "eq:equal-bins",
    .tests = {{"an even law has bins of equal width", test_even, 1, 0},
              {"a rising law has the bins worked out by hand", test_by_hand,
               1, 0},
              {"the law of two movers has narrow bins at its ends",
               test_arcsine, 2, 0},
              {"the law may lie anywhere on the axis", test_anywhere, 1, 0},
              {"every bin has the same probability", test_shares, 2, 2},
              {"a single bin reaches from end to end", test_one_bin, 1, 0},
              {"flat pieces do not move the ends", test_flat, 1, 0},
              {"a steep law needs the last digit", test_steep, 2, 0},
              {"a law of straight pieces has its corners for edges",
               test_drawn, 3, 3},
              {0}},
};
