/* The suite of exercise 09e, "The small ones count". */

#include "examiner/check.h"
#include <stdint.h>
#include <stdlib.h>
#include "call.h"

enum { MOST = 20002 };

static double plain(size_t n, const double part[])
{
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i)
        sum += part[i];
    return sum;
}

static int by_size(const void *a, const void *b)
{
    const double x = fabs(*(const double *)a), y = fabs(*(const double *)b);
    return (x > y) - (x < y);
}

static double sorted(size_t n, const double part[])
{
    static double copy[MOST];
    for (size_t i = 0; i < n; ++i)
        copy[i] = part[i];
    qsort(copy, n, sizeof copy[0], by_size);
    return plain(n, copy);
}

static double in_pairs(size_t n, const double part[])
{
    return n < 2
               ? plain(n, part)
               : in_pairs(n / 2, part) + in_pairs(n - n / 2, part + n / 2);
}

/* What is owed is found as if the sum were always the larger one, and is
   given back with the next number. */
static double owing(size_t n, const double part[])
{
    double sum = 0.0, owed = 0.0;
    for (size_t i = 0; i < n; ++i) {
        const double next = part[i] + owed, before = sum;
        sum = before + next;
        owed = next - (sum - before);
    }
    return sum;
}

/* limit: 2 epsilons */
static void check(size_t n, const double part[], const char *what,
                  double expected)
{
    double sizes = 0.0;
    for (size_t i = 0; i < n; ++i)
        sizes += fabs(part[i]);
    const double twice = (double)n * DBL_EPSILON;
    CHECK_NEAR(
        sum_up(n, part), .quantity = "sum", .input = what,
        .expected = expected,
        .tolerance = isinf(expected) ? 0.0
                                     : 2.0 * DBL_EPSILON * fabs(expected) +
                                           twice * twice * sizes,
        .because = "what was asked for",
        .mistakes = {
            {"one-after-another", n > 9 ? plain(n, part) : expected,
             "This is what one addition after another gives, each rounded. "
             "What does the sum lose when a small number is added to a "
             "large one?"},
            {"sorted-first", sorted(n, part),
             "Sorted by size, the small ones come together first. Then "
             "come two large ones of opposite signs: what is left of the "
             "small ones after the first of these?"},
            {"in-pairs", in_pairs(n, part),
             "In pairs fewer additions follow each other, and each of them "
             "rounds as before. Where is what they have lost?"},
            {"larger-newcomer", owing(n, part),
             "A small number was lost when a large one came after it. What "
             "is lost when the new number is the larger of the two? (A "
             "type with more digits only moves the trouble.)"}});
}

static void test_easy(void)
{
    static const double some[] = {1.5, -2.25, 3.0, 0.75};
    check_ask("These have no roundings at all. Which ones are added?");
    check(4, some, "{1.5, -2.25, 3, 0.75}", 3.0);
    check(1, some, "{1.5}", 1.5);
    check_ask("What is the sum of no numbers?");
    check(0, some, "no number", 0.0);
}

static void test_dust(void)
{
    static double part[MOST];
    part[0] = 1.0;
    part[MOST - 1] = -1.0;
    for (size_t i = 1; i + 1 < MOST; ++i)
        part[i] = ldexp(1.0, -54);
    check_ask("Not one of the small ones can change the 1 alone. Where do "
              "they go?");
    check(MOST, part, "1, 20000 times 2^-54, and -1",
          20000.0 * ldexp(1.0, -54));
}

static void test_late(void)
{
    const double large = ldexp(1.0, 70);
    const double first[] = {large, -large, 1.0, 4.0};
    const double late[] = {1.0, large, -large, 4.0};
    check_ask("One addition after another is right here. What have you "
              "done to the order?");
    check(4, first, "{2^70, -2^70, 1, 4}", 5.0);
    check_ask("The second number is larger than the sum so far. What is "
              "lost there, the new number or the sum?");
    check(4, late, "{1, 2^70, -2^70, 4}", 5.0);
}

static void test_cancel(void)
{
    const double large = ldexp(1.0, 70);
    const double some[] = {1.0,         large, -large,
                           2.0 * large, 4.0,   -2.0 * large};
    check_ask("The large ones cancel. What have you kept of the small ones "
              "until then?");
    check(6, some, "{1, 2^70, -2^70, 2^71, 4, -2^71}", 5.0);
}

static void test_infinite(void)
{
    for (int sign = -1; sign < 2; sign += 2) {
        const double some[] = {1.0, sign * INFINITY, 2.0, -3.0};
        static const char why[] =
            "A body has got lost, and the sum is no number at all. Which "
            "of your differences is infinity minus infinity?";
        CHECK_NEAR(sum_up(4, some), .quantity = "sum",
                   .input = check_text("{1, %g, 2, -3}", some[1]),
                   .expected = some[1], .because = "infinite, and exact",
                   .question = why,
                   .mistakes = {{"infinity-lost", CHECK_NAN, why}});
    }
}

/* Whole numbers of up to 61 bits have an exact sum in an int64_t, but not
   in a double: half of them are large and cancel in part, all in a drawn
   order. */
CHECK_TIMES(40, test_drawn, i)
{
    enum { N = 60 };
    check_ask("The exact sum is known in whole numbers. Which of your "
              "roundings is not given back?");
    double part[N];
    int64_t exact = 0;
    for (size_t k = 0; k < N; ++k) {
        const int64_t small = check_draw_whole(-1000000, 1000000);
        int64_t whole = small;
        if (k % 2)
            whole = small * ((int64_t)1 << 35) + (small & 1023);
        if (k % 4 == 1 && k > 4)
            whole = -(int64_t)part[k - 4];
        part[k] = (double)whole;
        exact += (int64_t)part[k];
    }
    for (size_t k = N - 1; k > 0; --k) {
        const size_t other = (size_t)check_draw_whole(0, (int)k);
        const double swap = part[k];
        part[k] = part[other];
        part[other] = swap;
    }
    check(N, part, "60 whole numbers, drawn, of 20 and of 55 bits",
          (double)exact);
}

const struct check_suite check_suite = {
    .file = "09e-small.c",
    .title = "The small ones count",
    .minutes = 25,
    .equation = "eq:compensated",
    .tests = {{"a few easy numbers are added up", test_easy, 1, 0},
              {"twenty thousand grains count", test_dust, 2, 0},
              {"a large number may come late", test_late, 2, 0},
              {"large numbers that cancel leave the small ones",
               test_cancel, 2, 0},
              {"an infinity stays one", test_infinite, 1, 0},
              {"forty drawn sums agree with whole numbers", test_drawn, 2,
               2},
              {0}},
};
