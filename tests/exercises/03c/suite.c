/* The suite of exercise 03c, "The exact law of the velocities". */

#include "examiner/check.h"
#include "call.h"

/* limit: 1e-13 */
static const double tolerance = 1e-13;
static const char because[] = "what was asked for";

static double pi(void)
{
    return acos(-1.0);
}

static const char *input(int n, double u)
{
    return check_text("n = %d movers, u = %.10g", n, u);
}

/* The constant of the law, and its density. */
static double constant(int n)
{
    return exp(lgamma(0.5 * n) - lgamma(0.5 * n - 0.5)) / sqrt(pi());
}

static double density(int n, double u)
{
    return constant(n) * pow((1.0 - u) * (1.0 + u), 0.5 * n - 1.5);
}

/* The distribution function to ten digits, to know mistakes by: with u the
   sine of an angle the density is a power of the cosine, and Simpson's rule
   is good. */
static double roughly(int n, double u)
{
    enum { PANELS = 400 };
    const double h = asin(u) / PANELS;
    double sum = 1.0 + pow(cos(asin(u)), n - 2);
    for (int i = 1; i < PANELS; ++i)
        sum += (i % 2 ? 4.0 : 2.0) * pow(cos(i * h), n - 2);
    return 0.5 + constant(n) * h / 3.0 * sum;
}

/* Right in the first digits only? Near its infinite ends the law of two
   movers is harder to sum up than the others. */
static bool nearly(int n, double off)
{
    return fabs(off) > tolerance && fabs(off) < (n == 2 ? 0.02 : 0.001);
}

static void check_digits(int n, double u, double off)
{
    static const char lost[] =
        "The first digits are right, the last are not. Is a constant, such "
        "as pi, given to a few digits only? Or does the answer come from "
        "many small steps, or from large terms of alternating signs? Is "
        "there a way with a few terms of the same sign?";
    CHECK_NEAR(off, .quantity = "probability below u, minus the exact one",
               .input = input(n, u), .tolerance = tolerance,
               .because = because, .equation = "eq:velocity-cdf",
               .mistakes = {{"digits-lost", off, lost}});
}

/* One of the laws known at sight, with n = 2 or 3. */
static void check_first(int n, double u, double expected)
{
    const double got = velocity_below(n, u);
    if (nearly(n, got - expected)) {
        check_digits(n, u, got - expected);
        return;
    }
    CHECK_NEAR(
        got, .quantity = "probability below u", .input = input(n, u),
        .expected = expected, .tolerance = tolerance, .because = because,
        .mistakes = {
            {"density-for-distribution", density(n, u),
             "This is the density at u. What was asked for is all that "
             "lies below u: which operation leads from the one to the "
             "other?"},
            {"from-the-middle", expected - 0.5,
             "This counts what lies between 0 and u. Where do the "
             "velocities below u begin?"},
            {"both-sides", 2.0 * expected - 1.0,
             "This is the probability of a speed below u. What about the "
             "velocities that point the other way?"},
            {"not-normalised", expected / constant(n),
             "The integral is right. How large does it become up to u = 1, "
             "and how large should it?"},
            {"bell-for-the-law", 0.5 * erfc(-u * sqrt(0.5 * n)),
             "This is the bell curve with the right width, which the law "
             "comes near to for many movers. How many are there here?"},
            {"law-of-one-more", roughly(n + 1, u),
             "This is right for one mover more. What is the exponent in "
             "the density for n = 3?"},
            {"law-of-two-more", roughly(n + 2, u),
             "This is right for two movers more. For how many movers is "
             "nothing to be added to the law known at sight?"}});
}

/* A law that needs steps of two. */
static void check_later(int n, double u, double expected)
{
    const double got = velocity_below(n, u);
    if (nearly(n, got - expected)) {
        check_digits(n, u, got - expected);
        return;
    }
    const double start = roughly(n % 2 ? 3 : 2, u);
    const double other = roughly(n % 2 ? 2 : 3, u);
    CHECK_NEAR(
        got, .quantity = "probability below u", .input = input(n, u),
        .expected = expected, .tolerance = tolerance, .because = because,
        .equation = "eq:velocity-cdf",
        .mistakes = {
            {"law-of-two-fewer", roughly(n - 2, u),
             "This is right for two movers fewer. How many terms does your "
             "loop add for n = 4, and how many should it?"},
            {"law-of-two-more", roughly(n + 2, u),
             "This is right for two movers more. How many terms does your "
             "loop add for n = 4, and how many should it?"},
            {"law-of-one-more", roughly(n + 1, u),
             "This is right for one mover more. What is the exponent in "
             "the density for this n?"},
            {"wrong-start", expected + other - start,
             "The terms are right, and they were added to the wrong law. "
             "Steps of two lead to an odd n from which of the two that are "
             "known at sight?"},
            {"not-normalised", expected / constant(n),
             "The integral is right. How large does it become up to u = 1, "
             "and how large should it?"}});
}

static void test_three(void)
{
    check_ask("For three movers every u is equally likely. What share of "
              "the way from -1 to 1 lies below this one?");
    check_first(3, 0.2, 0.6);
    check_first(3, -0.6, 0.2);
}

/* limit: 2 movers */
static void test_two(void)
{
    check_ask("Two movers: the density is 1/(pi sqrt(1 - u^2)). Of which "
              "function is it the derivative?");
    check_first(2, 0.5, 2.0 / 3.0);
    check_first(2, -sqrt(0.5), 0.25);
}

static void test_by_hand(void)
{
    const double sector = 2.0 / 3.0 + 0.25 * sqrt(3.0) / pi();
    check_ask("Five movers: the density is a parabola. What is its "
              "integral, and what is added to the straight line?");
    check_later(5, 0.5, 0.84375);
    check_later(5, -0.5, 0.15625);
    check_ask("Four movers: the density is half a circle. Work its area "
              "out on paper; what is added to the arcsine?");
    check_later(4, 0.5, sector);
    check_later(4, -0.5, 1.0 - sector);
}

/* A value from a hypergeometric function, in 40 digits. */
struct known {
    int n;
    double u, below;
};

static void test_table(void)
{
    static const struct known table[] = {{6, 0.5, 0.87341500244983868523},
                                         {7, -0.5, 0.103515625},
                                         {8, 0.5, 0.91476466960647308895},
                                         {9, 0.75, 0.9937610626220703125},
                                         {10, -0.25, 0.22922182694989377}};
    check_ask("How does the term for n follow from that for n - 2? Try n = "
              "6 from n = 4 on paper.");
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
        check_later(table[i].n, table[i].u, table[i].below);
}

/* The third derivative of the distribution function of seven movers is at
   most 7.5, so the difference quotient errs by 7.5 h^2/6 and the rounding
   of the values, 1e-13, divided by h. */
static void test_slope(void)
{
    const double h = 1e-4;
    const int n = 7;
    for (double u = -0.8; u < 0.9; u += 0.4)
        CHECK_NEAR(
            (velocity_below(n, u + h) - velocity_below(n, u - h)) /
                (2.0 * h),
            .quantity =
                "slope of your function, from u - 0.0001 to u + 0.0001",
            .input = input(n, u), .expected = density(n, u),
            .tolerance = 1.25 * h * h + 1e-13 / h,
            .because = "that of a difference quotient",
            .question = "The slope of a distribution function is the "
                        "density. Is yours too steep or too flat?");
}

static void test_mirror(void)
{
    for (int n = 2; n <= 20; n += 3)
        CHECK_NEAR(velocity_below(n, -0.3) + velocity_below(n, 0.3),
                   .quantity = "probability below -u, plus that below u",
                   .input = input(n, 0.3), .expected = 1.0,
                   .tolerance = 2.0 * tolerance, .because = because,
                   .question = "Left and right are alike, so what lies "
                               "below -u lies above u too. Which of your "
                               "terms does not change its sign with u?");
}

/* limit: 100 movers */
static void test_many(void)
{
    static const struct known table[] = {
        {51, 0.125, 0.81136729456441066178},
        {77, 0.3125, 0.99732767830518390774},
        {99, -0.0625, 0.2683712003268998358},
        {100, 0.25, 0.99415503414906092351},
        {100, -0.25, 0.0058449658509390764944},
        {99, 0.9375, 1.0},
        {100, -0.9375, 0.0}};
    check_ask("It is right for a few movers. What grows, or nearly "
              "cancels, when there are many?");
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
        check_later(table[i].n, table[i].u, table[i].below);
}

/* A power by squares: powl is as good to an epsilon or two of the long
   double, and half of what this suite costs. */
static long double raised(long double x, int power)
{
    long double product = 1.0L;
    for (; power > 0; power /= 2, x *= x)
        if (power % 2)
            product *= x;
    return product;
}

/* The integral of the cosine to this power from 0 to an angle, by Gauss's
   rule of three points in many strips. */
static long double gauss(int power, double to)
{
    enum { STRIPS = 400 };
    const long double h = 0.5L * to / STRIPS, off = h * sqrtl(0.6L);
    long double sum = 0.0L;
    for (int i = 0; i < STRIPS; ++i) {
        const long double middle = (2 * i + 1) * h;
        sum += 5.0L * raised(cosl(middle - off), power) +
               8.0L * raised(cosl(middle), power) +
               5.0L * raised(cosl(middle + off), power);
    }
    return h * sum / 9.0L;
}

/* The distribution function as a share of areas: with u the sine of an
   angle the density is a power of the cosine. */
static double by_area(int n, double u)
{
    const long double half = gauss(n - 2, asin(1.0));
    return (double)(0.5L + 0.5L * gauss(n - 2, asin(u)) / half);
}

CHECK_TIMES(24, test_drawn, i)
{
    const int n = i < 16 ? i / 2 + 2 : check_draw_whole(10, 100);
    const double u = check_draw(-0.99, 0.99);
    const double expected = by_area(n, u);
    if (n < 4) {
        check_ask("Which law is known at sight here?");
        check_first(n, u, expected);
    } else {
        check_ask("From which law do your steps of two start here, and how "
                  "many are there?");
        check_later(n, u, expected);
    }
}

static void check_outside(int n, double u, double expected)
{
    static const char why[] = "No velocity is larger than the largest. How "
                              "much of them lies below this u?";
    const double straight = 0.5 + 0.5 * u;
    const double parabola = straight + 0.25 * u * (1.0 - u * u);
    CHECK_NEAR(
        velocity_below(n, u), .quantity = "probability below u",
        .input = input(n, u), .expected = expected,
        .tolerance = fabs(u) > 1.0 ? 0.0 : tolerance,
        .because =
            fabs(u) > 1.0 ? "nothing is to be computed here" : because,
        .equation = "eq:velocity-cdf", .question = why,
        .mistakes = {{"not-clamped", CHECK_NAN, why},
                     {"not-clamped", n == 5 ? parabola : straight, why}});
}

/* limit: 1 (and -1, and beyond) */
static void test_outside(void)
{
    for (int n = 2; n <= 5; ++n) {
        check_outside(n, 1.0, 1.0);
        check_outside(n, -1.0, 0.0);
        check_outside(n, 1.5, 1.0);
        check_outside(n, -1.5, 0.0);
        check_outside(n, INFINITY, 1.0);
        check_outside(n, -INFINITY, 0.0);
    }
    for (int i = 0; i < 20; ++i) {
        const int n = check_draw_whole(2, 100);
        const double u = check_draw(1.001, 4.0);
        check_outside(n, u, 1.0);
        check_outside(n, -u, 0.0);
    }
}

const struct check_suite check_suite = {
    .file = "03c-velocity.c",
    .title = "The exact law of the velocities",
    .minutes = 30,
    .equation = "eq:velocity-law",
    .tests =
        {{"three movers: every velocity is equally likely", test_three, 1,
          0},
         {"two movers: the arcsine", test_two, 1, 0},
         {"four and five movers are as worked out by hand", test_by_hand, 2,
          0},
         {"six to ten movers agree with a table", test_table, 2, 0},
         {"the slope is the density of the velocities", test_slope, 1, 0},
         {"left and right are alike", test_mirror, 1, 0},
         {"a hundred movers keep all digits", test_many, 2, 0},
         {"nothing lies beyond the largest velocity", test_outside, 1, 1},
         {"laws and velocities drawn agree with an area", test_drawn, 3, 3},
         {0}},
};
