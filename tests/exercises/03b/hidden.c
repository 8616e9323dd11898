/* What the grader also asks of exercise 03b: the bin and the rest, and
   samples that were written down several times. */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z);

struct bin {
    size_t count, samples;
    double p, g;
};

/* From 20 to 2000 independent samples in the bin and in the rest; about as
   many as expected. */
static struct bin draw_bin(void)
{
    struct bin b = {0, 0, check_draw(0.05, 0.95), check_draw(1.0, 40.0)};
    const double rarer = fmin(b.p, 1.0 - b.p);
    b.samples = (size_t)(check_draw(20.0, 2000.0) * b.g / rarer);
    b.count =
        (size_t)((double)b.samples * (b.p + rarer * check_draw(-.5, .5)));
    return b;
}

static const char *input(struct bin b)
{
    return check_text("count = %zu of samples = %zu, probability = %g, "
                      "inefficiency = %g",
                      b.count, b.samples, b.p, b.g);
}

/* NaN where it cannot be judged: every bin here can. */
static double surprise(struct bin b)
{
    double z = NAN;
    return bin_surprise(b.count, b.samples, b.p, b.g, &z) ? z : NAN;
}

/* A difference of numbers near the count: an epsilon of all samples,
   divided by the standard deviation of independent ones. */
static bool check_same(const char *quantity, struct bin b, double got,
                       double expected)
{
    const double n = (double)b.samples;
    return CHECK_NEAR(
        got, .quantity = quantity, .input = input(b), .expected = expected,
        .tolerance = 16.0 * DBL_EPSILON *
                     (fabs(expected) + sqrt(n / (b.p * (1.0 - b.p)))),
        .because = "16 epsilons of z, and of the number of samples divided "
                   "by the standard deviation",
        .equation = "eq:zscore",
        .question = "The same samples, counted in two ways, give two "
                    "answers. Which of the numbers that go into z changes, "
                    "and should it?");
}

/* So many samples more in the bin are so many more deviations. */
static bool check_more(struct bin b)
{
    const int many = check_draw_whole(1, 5);
    const struct bin more = {b.count + (size_t)many, b.samples, b.p, b.g};
    const double n = (double)b.samples;
    return check_same(check_text("by how much z grows with %d more in the "
                                 "bin",
                                 many),
                      b, surprise(more) - surprise(b),
                      many / sqrt(b.g * n * (b.p - b.p * b.p)));
}

static void test_rest(void)
{
    for (int i = 0; i < 40; ++i) {
        const struct bin b = draw_bin();
        if (!check_more(b))
            return;
        const struct bin rest = {b.samples - b.count, b.samples, 1.0 - b.p,
                                 b.g};
        if (!check_same("z of all that is not in the bin", b,
                        surprise(rest), -surprise(b)))
            return;
    }
}

static void test_copies(void)
{
    for (int i = 0; i < 40; ++i) {
        const struct bin b = draw_bin();
        const int times = check_draw_whole(2, 5000);
        const struct bin copies = {b.count * (size_t)times,
                                   b.samples * (size_t)times, b.p,
                                   b.g * times};
        if (!check_same(
                check_text("z when each sample is written down %d times "
                           "and the inefficiency is as many times larger",
                           times),
                copies, surprise(copies), surprise(b)))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"what the bin has too many, the rest has too few", test_rest, 2, 0},
    {"samples written down again tell nothing new", test_copies, 2, 0},
    {0}};
