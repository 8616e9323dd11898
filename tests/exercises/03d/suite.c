/* The suite of exercise 03d: blocks of one value, a series done by hand,
   one that alternates, values left over, a long memory, a large offset,
   what cannot be cut into two, and series drawn. */

#include "examiner/check.h"
#include "toolbox/random.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency);

struct series {
    const char *name;
    size_t n;
    const double *x;
    size_t length;
};

/* What the student's function answers; untouched places read as NaN. */
struct answer {
    bool told;
    double error, g;
};

static struct answer answer(struct series s)
{
    struct answer a = {false, NAN, NAN};
    a.told = error_by_blocks(s.n, s.x, s.length, &a.error, &a.g);
    return a;
}

static const char *input(struct series s)
{
    return check_text("%s: %zu values, blocks of length %zu", s.name, s.n,
                      s.length);
}

/* The square of the standard error of the mean of the first n values, each
   taken as independent. */
static double naive(const double x[], size_t n)
{
    double mean = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; ++i)
        mean += (x[i] - mean) / (double)(i + 1);
    for (size_t i = 0; i < n; ++i)
        squares += (x[i] - mean) * (x[i] - mean);
    return squares / ((double)n * (double)(n - 1));
}

enum { MOST = 4096 };

/* The means of the blocks; with the rest, the values left over make one of
   their own. */
static size_t cut(struct series s, bool with_rest, double means[])
{
    size_t blocks = 0;
    for (size_t from = 0; from < s.n; from += s.length) {
        const size_t left = s.n - from;
        const size_t many = left < s.length ? left : s.length;
        double mean = 0.0;
        for (size_t i = 0; i < many; ++i)
            mean += (s.x[from + i] - mean) / (double)(i + 1);
        if (many == s.length || with_rest)
            means[blocks++] = mean;
    }
    return blocks;
}

static double by_blocks(struct series s, bool with_rest)
{
    static double means[MOST];
    const size_t blocks = cut(s, with_rest, means);
    return sqrt(naive(means, blocks));
}

/* Every deviation is known to an epsilon of the largest value, and sums of
   n numbers add up to n roundings. */
static double largest(struct series s)
{
    double most = 0.0;
    for (size_t i = 0; i < s.n; ++i)
        most = fmax(most, fabs(s.x[i]));
    return most;
}

static double tolerance(struct series s, double expected)
{
    return 4.0 * DBL_EPSILON * ((double)s.n * expected + largest(s));
}

static const char because[] =
    "4 epsilons of the largest value, and of the result for each value "
    "summed";

static bool check_told(struct series s)
{
    return CHECK_NEAR(answer(s).told ? 1.0 : 0.0,
                      .quantity = "what is returned: can an error be told? "
                                  "(1 true, 0 false)",
                      .input = input(s), .expected = 1.0, .tolerance = 0.0,
                      .because = "yes or no", .equation = "eq:block",
                      .question = "There are two blocks and more. Which of "
                                  "your tests turns this series away?");
}

static bool check_error(struct series s, double expected,
                        const char *question)
{
    const double blocks = (double)(s.n / s.length);
    const double all = blocks * (double)s.length;
    return CHECK_NEAR(
        answer(s).error, .quantity = "standard error of the mean",
        .input = input(s), .expected = expected,
        .tolerance = tolerance(s, expected), .because = because,
        .equation = "eq:block", .question = question,
        .mistakes = {
            {"blocks-forgotten", sqrt(naive(s.x, (size_t)all)),
             "This is the error of as many independent values. These hang "
             "together. What are the blocks for?"},
            {"deviation-of-the-blocks", expected * sqrt(blocks),
             "So far does a single block mean scatter. How far does the "
             "mean of them all?"},
            {"divided-by-all", expected * sqrt(blocks / all),
             "The scatter of the block means was divided by the root of "
             "the number of values. How many independent numbers are "
             "there?"},
            {"n-for-n-minus-1", expected * sqrt((blocks - 1.0) / blocks),
             "A little too small: the scatter is taken about a mean that "
             "was made from the same blocks. What stands in the "
             "denominator of the variance then?"},
            {"sums-for-means", expected * (double)s.length,
             "Too large by the length of a block. Is what you compare the "
             "sum of a block or its mean?"},
            {"rest-taken-for-a-block", by_blocks(s, true),
             "The values left over have become a block of their own, and a "
             "shorter one. Does its mean scatter as the others do?"},
            {"variance-for-error", expected * expected,
             "This is the square of the error. Which unit should an error "
             "have, when the values are metres?"},
            {"left-empty", NAN,
             "Not a number. Was something put into *error, and not the "
             "root of a negative number?"}});
}

static bool check_g(struct series s, double expected, const char *question)
{
    const double all = (double)(s.n / s.length * s.length);
    const double scale = tolerance(s, 1.0) / sqrt(naive(s.x, (size_t)all));
    return CHECK_NEAR(
        answer(s).g, .quantity = "inefficiency g", .input = input(s),
        .expected = expected,
        .tolerance =
            4.0 * scale * (expected + sqrt(expected)) + 8.0 * DBL_EPSILON,
        .because = "that of the error, relative to the naive one",
        .equation = "eq:inefficiency", .question = question,
        .mistakes = {
            {"root-of-g", sqrt(expected),
             "This is the ratio of the two errors. The inefficiency counts "
             "values, and the error goes with the root of their number. "
             "What does g compare, then?"},
            {"upside-down", 1.0 / expected,
             "This is what one value is worth. How many values are worth "
             "one?"},
            {"length-forgotten", expected / (double)s.length,
             "The variance of the block means was divided by that of the "
             "values. By what is either divided to give the square of an "
             "error?"},
            {"rest-in-the-naive",
             expected * naive(s.x, (size_t)all) / naive(s.x, s.n),
             "The values left over have got into the naive error. Are the "
             "two errors then those of the same series?"},
            {"left-empty", NAN,
             "Not a number. Was something put into *inefficiency, and not "
             "0/0?"}});
}

static bool check_both(struct series s, double error, double g,
                       const char *question)
{
    return check_told(s) && check_error(s, error, question) &&
           check_g(s, g, question);
}

static void test_single(void)
{
    const double x[] = {2, 4, 4, 4, 5, 5, 7, 9};
    check_both((struct series){"{2, 4, 4, 4, 5, 5, 7, 9}", 8, x, 1},
               sqrt(4.0 / 7.0), 1.0,
               "With blocks of one value there is nothing but the ordinary "
               "error. What is it for these eight numbers, on paper?");
}

static void test_by_hand(void)
{
    static const char question[] =
        "What are the block means here, and what is their variance, on "
        "paper?";
    const double x[] = {1, 1, 4, 4, 1, 1};
    const double y[] = {0, 0, 3, 2, 2, 5, 3, 3, 3, 1, 1, 1};
    (void)(check_both((struct series){"{1, 1, 4, 4, 1, 1}", 6, x, 2}, 1.0,
                      2.5, question) &&
           check_both(
               (struct series){"{0, 0, 3, 2, 2, 5, 3, 3, 3, 1, 1, 1}", 12,
                               y, 3},
               sqrt(1.0 / 3.0), 11.0 / 6.0, question));
}

static void test_alternating(void)
{
    const double x[] = {1, -1, 1, -1, 1, -1, 1, -1};
    check_both((struct series){"{1, -1, 1, -1, ...}", 8, x, 2}, 0.0, 0.0,
               "Each value makes up for the one before. What are the means "
               "of blocks of two, and how certain is the mean?");
}

static void test_rest(void)
{
    static const char question[] =
        "The last values fill no block. Where do they still come in?";
    const double x[] = {1, 1, 4, 4, 1, 1, 100};
    const double y[] = {0, 4, 2, 2, 2, 8, -50, 60};
    (void)(check_both((struct series){"{1, 1, 4, 4, 1, 1, 100}", 7, x, 2},
                      1.0, 2.5, question) &&
           check_both(
               (struct series){"{0, 4, 2, 2, 2, 8, -50, 60}", 8, y, 3}, 1.0,
               1.0 / (38.0 / 30.0), question));
}

/* Each value is 0.9 times the one before, and something new; rounded to
   1/1024, so that adding a whole number is exact. */
static void remember(double x[], double offset)
{
    struct random r;
    random_seed(&r, 3);
    double value = 0.0;
    for (size_t i = 0; i < MOST; ++i) {
        value = 0.9 * value + random_normal(&r);
        x[i] = offset + floor(1024.0 * value) / 1024.0;
    }
}

static void test_memory(void)
{
    static double x[MOST];
    const size_t lengths[] = {1, 2, 16, 100, 256, 1500};
    remember(x, 0.0);
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; ++i) {
        const struct series s = {
            "each value 0.9 times the last, plus noise", MOST, x,
            lengths[i]};
        const double error = by_blocks(s, false);
        const size_t used = MOST / lengths[i] * lengths[i];
        if (!check_both(s, error, error * error / naive(x, used),
                        "For long blocks g should come near to 19 here, "
                        "and is uncertain when they are few. Do the "
                        "blocks lie end to end from the first value "
                        "on?"))
            return;
    }
}

/* The same series, lifted. Whoever is right without the offset and wrong
   with it has lost digits. */
static void test_offset(void)
{
    static const char why[] =
        "The series of the test before, lifted by 1e9, and the error has "
        "changed. Do you subtract two numbers near 1e18 somewhere? What "
        "could be subtracted before squaring?";
    static double x[MOST], lifted[MOST];
    remember(x, 0.0);
    remember(lifted, 1e9);
    const struct series low = {"the series", MOST, x, 64};
    const struct series high = {"the same series, each value plus 1e9",
                                MOST, lifted, 64};
    const double error = by_blocks(low, false);
    const double g = error * error / naive(x, MOST);
    const struct answer a = answer(high);
    (void)(check_both(low, error, g, why) && check_told(high) &&
           CHECK_NEAR(a.error, .quantity = "standard error of the mean",
                      .input = input(high), .expected = error,
                      .tolerance = tolerance(high, error),
                      .because = because, .equation = "eq:block",
                      .question = why,
                      .mistakes = {{"digits-cancelled", a.error, why}}) &&
           CHECK_NEAR(a.g, .quantity = "inefficiency g",
                      .input = input(high), .expected = g,
                      .tolerance = 8.0 * g * tolerance(high, error) /
                                   sqrt(naive(x, MOST)),
                      .because =
                          "that of the error, relative to the naive one",
                      .equation = "eq:inefficiency", .question = why,
                      .mistakes = {{"digits-cancelled", a.g, why}}));
}

static bool check_refused(struct series s)
{
    static const char why[] =
        "There are not two blocks here. How would one number tell how far "
        "such numbers scatter?";
    return CHECK_NEAR(answer(s).told ? 1.0 : 0.0,
                      .quantity = "what is returned: can an error be told? "
                                  "(1 true, 0 false)",
                      .input = input(s), .expected = 0.0, .tolerance = 0.0,
                      .because = "yes or no", .equation = "eq:block",
                      .question = why,
                      .mistakes = {{"never-refuses", 1.0, why}});
}

static void test_refused(void)
{
    const double x[] = {2, 4, 4, 4, 5, 5, 7, 9, 1};
    (void)(check_refused((struct series){"nine numbers", 9, x, 5}) &&
           check_refused((struct series){"nine numbers", 9, x, 9}) &&
           check_refused((struct series){"nine numbers", 9, x, 10}) &&
           check_refused((struct series){"nine numbers", 9, x, 0}) &&
           check_told((struct series){"nine numbers", 9, x, 4}));
}

/* The square of the standard error of the mean of n numbers by way of
   their differences: the squares of those of all pairs, divided by n^2 and
   n - 1. With whole numbers this is exact up to the division. */
static double by_pairs(size_t n, const double x[])
{
    const double count = (double)n;
    double squares = 0.0;
    for (size_t i = 1; i < n; ++i)
        for (size_t j = 0; j < i; ++j)
            squares += (x[i] - x[j]) * (x[i] - x[j]);
    return squares / (count * count * (count - 1.0));
}

enum { DRAWN = 30 };

/* Sums of blocks, in place of means: whole numbers too. */
static size_t add_up(struct series s, double sums[])
{
    const size_t blocks = s.n / s.length;
    for (size_t k = 0; k < blocks; ++k) {
        sums[k] = 0.0;
        for (size_t i = 0; i < s.length; ++i)
            sums[k] += s.x[k * s.length + i] - s.x[0];
    }
    return blocks;
}

/* Whole numbers, each near the one before; sometimes far from zero. The
   first block stands out, so that no error is zero. */
static struct series draw_series(double x[])
{
    struct series s = {NULL, (size_t)check_draw_whole(4, DRAWN), x, 0};
    s.length = (size_t)check_draw_whole(1, (int)s.n / 2);
    const int lift = check_draw_whole(0, 2) ? 0 : 100000000;
    x[0] = check_draw_whole(-9, 9) + lift;
    for (size_t i = 1; i < s.n; ++i)
        x[i] = x[i - 1] + check_draw_whole(-4, 4);
    double sums[DRAWN];
    if (by_pairs(add_up(s, sums), sums) < 0.5)
        x[1] += 7.0;
    const char *list = check_text("{%.10g", x[0]);
    for (size_t i = 1; i < s.n; ++i)
        list = check_text("%s, %.10g", list, x[i]);
    s.name = check_text("%s}", list);
    return s;
}

static void test_drawn(void)
{
    double x[DRAWN], sums[DRAWN];
    for (int i = 0; i < 40; ++i) {
        const struct series s = draw_series(x);
        const size_t blocks = add_up(s, sums);
        const double length = (double)s.length;
        const double square = by_pairs(blocks, sums) / (length * length);
        if (!check_both(s, sqrt(square),
                        square / by_pairs(blocks * s.length, x),
                        "Cut this series on paper. Which values make a "
                        "block, and how far do the block means "
                        "scatter?"))
            return;
    }
}

/* One block and what is left, or two just full. */
static void test_drawn_refused(void)
{
    double x[DRAWN];
    for (int i = 0; i < 20; ++i) {
        struct series s = draw_series(x);
        const int half = (int)s.n / 2;
        s.length = (size_t)check_draw_whole(half + 1, 2 * DRAWN);
        if (!check_refused(s))
            return;
        s.length = (size_t)half;
        if (!check_told(s))
            return;
    }
}

const struct check_suite check_suite = {
    .file = "03d-blocks.c",
    .title = "Block errors on a correlated series",
    .minutes = 30,
    .tests =
        {{"blocks of one value give the ordinary error", test_single, 1, 0},
         {"two short series are as worked out by hand", test_by_hand, 2, 0},
         {"values that alternate have a certain mean", test_alternating, 1,
          0},
         {"values left over are used for nothing", test_rest, 2, 0},
         {"a long memory is cut into blocks of any length", test_memory, 2,
          0},
         {"an offset of a thousand million changes nothing", test_offset, 2,
          0},
         {"fewer than two blocks tell nothing", test_refused, 1, 0},
         {"series drawn agree with the differences of all pairs",
          test_drawn, 3, 3},
         {"series drawn are cut in two at least", test_drawn_refused, 1, 1},
         {0}},
};
