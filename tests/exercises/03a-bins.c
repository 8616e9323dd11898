/* The suite of exercise 03a: an even law, a law turned round by hand, the
   arcsine, a law far from zero, shares without a formula, a single bin,
   flat pieces, and a law so steep that the last digit counts. */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

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

/* Nothing up to 1/4, two equal lumps to 3/8 and from 5/8, nothing from 3/4
   on. */
static double lumps_below(double x)
{
    const double first = fmin(fmax(4.0 * (x - 0.25), 0.0), 0.5);
    return first + fmin(fmax(4.0 * (x - 0.625), 0.0), 0.5);
}

/* Three powers mixed: no formula for the place. */
static double mixed_below(double x)
{
    const double y = 0.5 * (x + 3.0);
    return 0.25 * y + 0.25 * y * y + 0.5 * y * y * y * y * y;
}

static void answer(const struct law *l, size_t bins, double edge[])
{
    for (size_t k = 0; k <= MOST; ++k)
        edge[k] = NAN;
    equal_bins(l->below, l->low, l->high, bins, edge);
}

static const char *input(const struct law *l, size_t bins)
{
    return check_text("the law %s, from %g to %g, %zu bins", l->name,
                      l->low, l->high, bins);
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
static bool check_end(const struct law *l, size_t bins, bool last,
                      double got)
{
    static const char searched[] =
        "So near, and not the end itself. Its place was given: why search "
        "for it?";
    const double end = last ? l->high : l->low, off = got - end;
    const char *quantity =
        last ? "the last edge, edge[bins]" : "the first edge, edge[0]";
    static const char because[] = "the ends are given, not computed";
    if (off != 0.0 && fabs(off) < 0.01 * (l->high - l->low))
        return CHECK_NEAR(
            off,
            .quantity =
                check_text("%s, minus %s", quantity, last ? "high" : "low"),
            .input = input(l, bins), .expected = 0.0, .tolerance = 0.0,
            .because = because, .equation = "eq:equal-bins",
            .question = searched,
            .mistakes = {{"ends-searched-for", off, searched}});
    return CHECK_NEAR(
        got, .quantity = quantity, .input = input(l, bins), .expected = end,
        .tolerance = 0.0, .because = because, .equation = "eq:equal-bins",
        .question = "Where do the bins begin, and where do they end?",
        .mistakes = {
            {"left-empty", NAN, check_text(empty, bins)},
            {"from-the-top", last ? l->low : l->high, turned_round},
            {"bins-miscounted",
             last ? l->place((double)bins / ((double)bins + 1.0)) : end,
             miscounted}});
}

/* An inner edge. Bisection ends within an epsilon of the larger end; the
   roundings of the distribution function, divided by its slope, come on
   top. */
static bool check_edge(const struct law *l, size_t bins, size_t k,
                       double got, const char *question)
{
    const double b = (double)bins, p = (double)k / b;
    const double expected = l->place(p);
    const double larger = fmax(fabs(l->low), fabs(l->high));
    const double tolerance =
        8.0 * DBL_EPSILON * (larger + 1.0 / l->density(expected));
    static const char because[] =
        "8 epsilons of the larger end, and of the probability divided by "
        "the density";
    const char *quantity = check_text("edge[%zu]", k);
    const double off = got - expected;
    if (fabs(off) > tolerance && fabs(off) < 1e-4 * (l->high - l->low))
        return CHECK_NEAR(
            off, .quantity = check_text("%s, minus its place", quantity),
            .input = input(l, bins), .expected = 0.0,
            .tolerance = tolerance, .because = because,
            .equation = "eq:equal-bins", .question = question,
            .mistakes = {
                {"stops-early", off,
                 "Your search is on the right way and stops too early. "
                 "What makes it stop? Can it go on until no number is left "
                 "between the two ends?"}});
    return CHECK_NEAR(
        got, .quantity = quantity, .input = input(l, bins),
        .expected = expected, .tolerance = tolerance, .because = because,
        .equation = "eq:equal-bins", .question = question,
        .mistakes = {
            {"equal-widths", l->low + (l->high - l->low) * p,
             "These bins are equally wide. What is the probability of the "
             "first of them, and what should it be?"},
            {"from-the-top", l->place(1.0 - p), turned_round},
            {"bins-miscounted", l->place((double)k / (b + 1.0)),
             miscounted},
            {"middles-of-bins", l->place(p - 0.5 / b),
             "This is where half of a bin's probability lies to the left. "
             "Is an edge in the middle of a bin?"},
            {"between-0-and-1", fmin(fmax(expected, 0.0), 1.0),
             "Your search looks between 0 and 1 only. That is where the "
             "probabilities lie; where do the places lie?"},
            {"left-empty", NAN, check_text(empty, bins)}});
}

static bool check_law(const struct law *l, size_t bins,
                      const char *question)
{
    double edge[MOST + 1];
    answer(l, bins, edge);
    bool passed = check_end(l, bins, false, edge[0]) &&
                  check_end(l, bins, true, edge[bins]);
    for (size_t k = 1; passed && k < bins; ++k)
        passed = check_edge(l, bins, k, edge[k], question);
    return passed;
}

static void test_even(void)
{
    check_law(&even, 4,
              "Here every piece of the same length has the same "
              "probability. How wide is a quarter of it?");
}

static void test_by_hand(void)
{
    static const char question[] =
        "Here distribution(x) is x squared. For which x is it k/bins?";
    (void)(check_law(&ramp, 4, question) && check_law(&ramp, 9, question));
}

static void test_arcsine(void)
{
    static const char question[] =
        "Two movers are most often found near their greatest speed. Where "
        "must the narrow bins lie, then?";
    (void)(check_law(&arcsine, 3, question) &&
           check_law(&arcsine, 12, question));
}

static void test_anywhere(void)
{
    check_law(&fall, 20,
              "This law begins at 5 and has a long tail. Does your search "
              "know where the law begins and where it ends?");
}

static void test_shares(void)
{
    const struct law mixed = {
        "a mixture of powers", mixed_below, NULL, NULL, -3.0, -1.0};
    const size_t bins = 7;
    double edge[MOST + 1];
    answer(&mixed, bins, edge);
    for (size_t k = 0; k < bins; ++k)
        if (!CHECK_NEAR(
                mixed_below(edge[k + 1]) - mixed_below(edge[k]),
                .quantity = check_text("probability of bin %zu", k),
                .input = input(&mixed, bins), .expected = 1.0 / 7.0,
                .tolerance = 32.0 * DBL_EPSILON,
                .because = "32 epsilons: the places are known to an "
                           "epsilon of 3, and the density is below 2",
                .equation = "eq:equal-bins",
                .question = "Every bin should have one seventh. Which of "
                            "its two edges is at fault?"))
            return;
}

static void test_one_bin(void)
{
    check_law(&fall, 1, "How many edges has a single bin?");
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
        if (!CHECK_NEAR(
                edge[k], .quantity = check_text("edge[%zu]", k),
                .input = input(&lumps, 4), .expected = 0.25 * (double)k,
                .tolerance = 0.0,
                .because = "the ends are given, not computed",
                .equation = "eq:equal-bins", .question = searched,
                .mistakes = {{"ends-searched-for", 0.25, searched},
                             {"ends-searched-for", 0.75, searched}}))
            return;
    for (size_t k = 1; k < 4; ++k)
        if (!CHECK_NEAR(
                lumps_below(edge[k]),
                .quantity = check_text("probability below edge[%zu]", k),
                .input = input(&lumps, 4), .expected = 0.25 * (double)k,
                .tolerance = 16.0 * DBL_EPSILON,
                .because = "16 epsilons: the density is 4",
                .equation = "eq:equal-bins",
                .question = "A flat piece has many places with the same "
                            "probability below. Does your search come to "
                            "one of them?"))
            return;
}

static void test_steep(void)
{
    check_law(&steep, 8,
              "Here all edges lie within a few thousand-millionths. How "
              "does your search know when it is near enough?");
}

const struct check_suite check_suite = {
    .exercise = "03a",
    .title = "Bins of equal probability",
    .minutes = 15,
    .tests = {{"an even law has bins of equal width", test_even, 1, 0},
              {"a rising law has the bins worked out by hand", test_by_hand,
               1, 0},
              {"the law of two movers has narrow bins at its ends",
               test_arcsine, 1, 0},
              {"the law may lie anywhere on the axis", test_anywhere, 1, 0},
              {"every bin has the same probability", test_shares, 1, 0},
              {"a single bin reaches from end to end", test_one_bin, 1, 0},
              {"flat pieces do not move the ends", test_flat, 1, 0},
              {"a steep law needs the last digit", test_steep, 1, 0},
              {0}},
};
