/* The suite of exercise 03b: independent samples, samples that hang
   together, a dimple, the law's own scatter, an inefficiency below one,
   counts without end, what cannot be judged, and bins of all kinds drawn.
 */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z);

/* What a histogram shows, and what is known about it. */
struct bin {
    size_t count, samples;
    double p, g;
};

/* What the student's function answers; an untouched place reads as NaN. */
struct answer {
    bool judged;
    double z;
};

static struct answer answer(struct bin b)
{
    struct answer a = {false, NAN};
    a.judged = bin_surprise(b.count, b.samples, b.p, b.g, &a.z);
    return a;
}

static const char *input(struct bin b)
{
    return check_text("count = %zu of samples = %zu, probability = %.10g, "
                      "inefficiency = %g",
                      b.count, b.samples, b.p, b.g);
}

static double surplus(struct bin b)
{
    return (double)b.count - (double)b.samples * b.p;
}

/* The standard deviation of a count that n samples with the inefficiency g
   would have, each in the bin with probability p. */
static double deviation(double n, double p, double g)
{
    return sqrt(n * p * (1.0 - p) * g);
}

/* The surplus is a difference: its error is an epsilon of what is
   subtracted. */
static double tolerance(struct bin b, double expected)
{
    const double n = (double)b.samples;
    return 8.0 * DBL_EPSILON *
           (fabs(expected) + n / deviation(n, b.p, 1.0));
}

static const char because[] =
    "8 epsilons of z, and of the number of samples divided by the standard "
    "deviation";

static bool check_judged(struct bin b, const char *question)
{
    return CHECK_NEAR(
        answer(b).judged ? 1.0 : 0.0,
        .quantity = "what is returned: can this be judged? (1 true, 0 "
                    "false)",
        .input = input(b), .expected = 1.0, .tolerance = 0.0,
        .because = "yes or no", .equation = "eq:zscore",
        .question = question);
}

/* The size is right: is it the sign of every z, or that of a lack? */
static bool check_sign(struct bin b, double expected)
{
    static const char reversed[] =
        "The bin has more samples than the law expects. Should z be "
        "positive then?";
    static const char lost[] =
        "A dimple and a bump look the same to you. Which sign has z when "
        "there are too few?";
    const char *why = expected > 0.0 ? reversed : lost;
    return CHECK_NEAR(
        answer(b).z, .quantity = "z, the surplus in standard deviations",
        .unit = "", .input = input(b), .expected = expected,
        .tolerance = tolerance(b, expected), .because = because,
        .equation = "eq:zscore", .question = why,
        .mistakes = {
            {"expected-minus-observed",
             expected > 0.0 ? -expected : expected, reversed},
            {"sign-lost", expected < 0.0 ? -expected : expected, lost}});
}

static bool check_z(struct bin b, double expected, const char *question)
{
    const double n = (double)b.samples, p = b.p, g = b.g;
    const double share = (double)b.count / n;
    if (fabs(answer(b).z + expected) <= tolerance(b, expected))
        return check_sign(b, expected);
    return CHECK_NEAR(
        answer(b).z, .quantity = "z, the surplus in standard deviations",
        .unit = "", .input = input(b), .expected = expected,
        .tolerance = tolerance(b, expected), .because = because,
        .equation = "eq:zscore", .question = question,
        .mistakes = {
            {"not-independent", surplus(b) / deviation(n, p, 1.0),
             "This would be right for independent samples. How many "
             "independent ones are these worth?"},
            {"g-not-rooted", surplus(b) / deviation(n, p, 1.0) / g,
             "The inefficiency makes the scatter larger, and here it does "
             "so too much. Does g multiply the standard deviation or the "
             "variance?"},
            {"g-the-wrong-way", surplus(b) / deviation(n, p, 1.0 / g),
             "Neighbours that are alike make you more certain here. Are "
             "samples that hang together worth more than they are, or "
             "less?"},
            {"count-with-n-eff",
             ((double)b.count - n / g * p) / deviation(n / g, p, 1.0),
             "The count is one of all samples, and here it is compared "
             "with what the independent ones alone would give. Which share "
             "of the samples was observed, and which is expected?"},
            {"root-of-the-expected", surplus(b) / sqrt(n * p * g),
             "The square root of the expected count is the scatter of rare "
             "events. A sample can only be in the bin or outside it: what "
             "is the variance of such a yes or no?"},
            {"error-from-the-count", surplus(b) / deviation(n, share, g),
             "The scatter is taken from the observed share. The question "
             "is what the law can do: whose probability belongs into the "
             "scatter, and what would an empty bin get?"},
            {"variance-for-deviation",
             surplus(b) / (deviation(n, p, g) * deviation(n, p, g)),
             "The difference was divided by a variance. Which unit would z "
             "have then, if counts had one?"},
            {"whole-number-division", -p * n / deviation(n, p, g),
             "Your share of the bin is zero. What is 3/4 in C when both "
             "are whole numbers?"}});
}

static bool check(struct bin b, double expected, const char *question)
{
    return check_judged(b, "Here five and more independent samples are "
                           "expected in the bin and outside it. Which of "
                           "your tests turns this away?") &&
           check_z(b, expected, question);
}

static void test_independent(void)
{
    static const char question[] =
        "A fair coin was thrown so many times. What is the standard "
        "deviation of the number of heads?";
    (void)(check((struct bin){60, 100, 0.5, 1.0}, 2.0, question) &&
           check((struct bin){1700, 2500, 0.64, 1.0}, 100.0 / 24.0,
                 question));
}

static void test_effective(void)
{
    static const char question[] =
        "The samples hang together: g of them are worth one. By what "
        "factor does the scatter grow?";
    (void)(check((struct bin){240, 400, 0.5, 4.0}, 2.0, question) &&
           check((struct bin){2000, 2500, 0.64, 9.0}, 400.0 / 72.0,
                 question) &&
           check((struct bin){340, 1600, 0.2, 1.5625}, 1.0, question));
}

/* Among eight movers |u| < 0.1 has the expected share 0.202. */
static void test_dimple(void)
{
    static const char question[] =
        "This bin has too few samples. Work out the standard deviation on "
        "paper: is it a dimple, or bad luck?";
    const struct bin b = {7650, 40000, 0.202, 50.0};
    const double z =
        (7650.0 - 40000.0 * 0.202) / deviation(40000.0, 0.202, 50.0);
    (void)(check(b, z, question) &&
           check((struct bin){20, 400, 0.2, 4.0}, -3.75, question));
}

static void test_empty_bin(void)
{
    check((struct bin){0, 800, 0.1, 8.0}, -10.0 / 3.0,
          "Nothing is in the bin. Is its expected scatter nothing too?");
}

static void test_below_one(void)
{
    static const char question[] =
        "What was to be done with an inefficiency below 1?";
    static const char why[] =
        "The walls turn a velocity round, so its mean gains by looking at "
        "neighbours. Does a bin gain, which does not ask for the sign? "
        "What was to be done with an inefficiency below 1?";
    const struct bin some[] = {{60, 100, 0.5, 0.25}, {60, 100, 0.5, 0.0}};
    for (size_t i = 0; i < sizeof some / sizeof some[0]; ++i)
        if (!check_judged(some[i], question) ||
            !CHECK_NEAR(
                answer(some[i]).z,
                .quantity = "z, the surplus in standard deviations",
                .unit = "", .input = input(some[i]), .expected = 2.0,
                .tolerance = tolerance(some[i], 2), .because = because,
                .equation = "eq:inefficiency", .question = question,
                .mistakes = {{"g-below-one", 2.0 / sqrt(some[i].g), why}}))
            return;
}

static void test_large(void)
{
    check((struct bin){2000100000, 4000000000, 0.5, 10.0}, 1.0,
          "There are more samples than an int can count. Does a step of "
          "yours go through one?");
}

static bool check_refused(struct bin b, const char *mistake,
                          const char *why)
{
    return CHECK_NEAR(
        answer(b).judged ? 1.0 : 0.0,
        .quantity = "what is returned: can this be judged? (1 true, 0 "
                    "false)",
        .input = input(b), .expected = 0.0, .tolerance = 0.0,
        .because = "yes or no", .equation = "eq:zscore", .question = why,
        .mistakes = {{mistake, 1.0, why}});
}

static void test_certain(void)
{
    static const char why[] =
        "The law allows no scatter at all here. What does your formula "
        "divide by?";
    (void)(check_refused((struct bin){0, 1000, 0.0, 1.0}, "never-refuses",
                         why) &&
           check_refused((struct bin){1000, 1000, 1.0, 1.0},
                         "never-refuses", why) &&
           check_refused((struct bin){10, 1000, -0.1, 1.0}, "never-refuses",
                         "A negative probability?") &&
           check_refused((struct bin){10, 1000, NAN, 1.0}, "never-refuses",
                         "This probability is not a number. Which "
                         "comparisons with it are true?"));
}

/* The run of the seed's length: 400 samples, eight of them independent. */
static void test_few(void)
{
    static const char why[] =
        "So many samples, but how many INDEPENDENT ones does the law "
        "expect in this bin?";
    static const char outside[] =
        "In the bin there are enough. How many independent samples are "
        "expected outside it?";
    (void)(check_refused((struct bin){61, 400, 0.202, 50.0},
                         "all-samples-counted", why) &&
           check_refused((struct bin){3, 16, 0.25, 1.0},
                         "all-samples-counted", why) &&
           check_refused((struct bin){2300, 2400, 0.95, 25.0},
                         "outside-forgotten", outside) &&
           check_judged((struct bin){3, 20, 0.25, 1.0},
                        "Just five are expected in this bin. Were five too "
                        "few?") &&
           check_judged((struct bin){30, 80, 0.5, 8.0},
                        "Just five independent ones are expected in this "
                        "bin and outside. Were five too few?"));
}

/* A bin that expects so many independent samples, in it or outside it,
   whichever are fewer, and a count that is off by a few deviations. */
static struct bin draw_bin(double low, double high)
{
    struct bin b;
    b.p = check_draw(0.02, 0.98);
    b.g = check_draw_whole(0, 2) ? check_draw(1.0, 60.0)
                                 : check_draw(0.05, 0.95);
    const double worth = fmax(b.g, 1.0), rarer = fmin(b.p, 1.0 - b.p);
    const double n = check_draw(low, high) * worth / rarer;
    b.samples = (size_t)n;
    const double off = check_draw(-4.0, 4.0) * deviation(n, b.p, worth);
    b.count = (size_t)fmin(fmax(floor(n) * b.p + off, 0.0), floor(n));
    return b;
}

/* Pearson's way: the squares of what bin and rest have too many, each
   divided by what is expected, add up to the square of z. */
static double by_squares(struct bin b)
{
    const long double n = (long double)b.samples, p = b.p;
    const long double in = n * p, out = n - n * p;
    const long double off = (long double)b.count - in;
    const long double square = off * off / in + off * off / out;
    const double size = (double)sqrtl(square / fmaxl(b.g, 1.0L));
    return off < 0.0L ? -size : size;
}

static void test_drawn(void)
{
    for (int i = 0; i < 40; ++i) {
        const struct bin b = draw_bin(6.0, 400.0);
        if (!check(b, by_squares(b),
                   "What does the law expect in this bin, and with which "
                   "standard deviation? Is z the one divided by the "
                   "other?"))
            return;
    }
}

/* Too few by a tenth and more, or enough by as much. */
static void test_drawn_limit(void)
{
    static const char enough[] =
        "A few more than five independent samples are expected in the bin "
        "and outside it. Which of your tests turns this away?";
    static const char rarer[] =
        "How many independent samples does the law expect in the bin, and "
        "how many outside it? An inefficiency below 1 counts as 1.";
    for (int i = 0; i < 40; ++i) {
        const struct bin few = draw_bin(1.0, 4.5),
                         more = draw_bin(5.6, 7.0);
        const bool outside = few.p > 0.5;
        if (!(check_refused(few,
                            outside ? "outside-forgotten"
                                    : "all-samples-counted",
                            rarer) &&
              check_judged(more, enough)))
            return;
    }
}

const struct check_suite check_suite = {
    .file = "03b-dimple.c",
    .title = "Is the dimple real?",
    .minutes = 25,
    .tests =
        {{"independent samples scatter as coins do", test_independent, 1,
          0},
         {"samples that hang together scatter more", test_effective, 2, 0},
         {"a dimple is a negative surplus", test_dimple, 1, 0},
         {"the law's own scatter is asked for, also by an empty bin",
          test_empty_bin, 1, 0},
         {"an inefficiency below one counts as one", test_below_one, 1, 0},
         {"four thousand million samples can be judged", test_large, 1, 0},
         {"a law that leaves no choice is refused", test_certain, 1, 0},
         {"too few independent samples are refused", test_few, 2, 0},
         {"bins of all kinds agree with Pearson's sum", test_drawn, 3, 3},
         {"bins of all kinds are judged when they can be", test_drawn_limit,
          2, 2},
         {0}},
    .idle = {test_certain},
};
