/* The hidden tests of exercise 12a, "The Pareto front". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 400 };

/* All different in both numbers. */
static size_t draw_choices(struct choice choice[])
{
    const size_t n = (size_t)check_draw_whole(1, 60);
    for (size_t i = 0; i < n; ++i)
        choice[i] = (struct choice){check_draw(0.1, 9.0) + 1e-7 * i,
                                    check_draw(0.1, 9.0) + 1e-7 * i};
    return n;
}

static void check(size_t n, const char *what, double got, double expected,
                  const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input = check_text("%zu choices, %s", n, what),
               .expected = expected,
               .because = "a number of things is exact");
}

/* The same front as before, from the other end. */
CHECK_TIMES(40, test_exchanged, i)
{
    struct choice choice[MOST + 1] = {{0.0, 0.0}}, other[MOST + 1];
    size_t front[MOST + 1] = {0}, back[MOST + 1] = {0};
    const size_t n = draw_choices(choice);
    for (size_t k = 0; k <= n; ++k)
        other[k] = (struct choice){choice[k].error, choice[k].cost};
    const size_t count = pareto_front(n, choice, front);
    const size_t again = pareto_front(n, other, back);
    check(n, "cost and error exchanged", (double)again, (double)count,
          "how many are on the front");
    check(n, "drawn", count >= 1 && count <= n, 1.0,
          "is that from 1 to n? (1 yes, 0 no)");
    for (size_t k = 0; k < count; ++k)
        check(n, "cost and error exchanged", (double)back[count - 1 - k],
              (double)front[k], "a place of the front");
}

CHECK_TIMES(40, test_units, i)
{
    struct choice choice[MOST + 1] = {{0.0, 0.0}}, other[MOST + 1];
    size_t front[MOST + 1] = {0}, same[MOST + 1] = {0};
    const size_t n = draw_choices(choice);
    const double s = ldexp(1.0, check_draw_whole(-300, 300));
    const double m = ldexp(1.0, check_draw_whole(-300, 300));
    for (size_t k = 0; k <= n; ++k)
        other[k] = (struct choice){s * choice[k].cost, m * choice[k].error};
    const size_t count = pareto_front(n, choice, front);
    const size_t again = pareto_front(n, other, same);
    check(n, "in other units", (double)again, (double)count,
          "how many are on the front");
    for (size_t k = 0; k < count && k < n; ++k)
        check(n, "in other units", (double)same[k], (double)front[k],
              "a place of the front");
}

/* A hyperbola of choices that nobody beats, out of order; then every third
   one errs as much as the next cheaper one. */
static void test_many(void)
{
    struct choice choice[MOST + 1] = {{0.0, 0.0}};
    size_t front[MOST + 1],
        stride = (size_t)check_draw_whole(1, 99) * 2 + 1;
    while (stride % 5 == 0)
        stride += 2;
    for (size_t k = 0; k < MOST; ++k) {
        const size_t i = k * stride % MOST;
        choice[i] = (struct choice){k + 1.0, 1.0 / (k + 1.0)};
        if (k % 3 == 1)
            choice[i].error = 1.0 / k;
    }
    const size_t count = pareto_front(MOST, choice, front);
    check(MOST, "a third of them beaten", (double)count,
          MOST - (MOST + 1) / 3, "how many are on the front");
    for (size_t k = 0, j = 0; k < MOST; ++k)
        if (k % 3 != 1)
            check(MOST, "a third of them beaten", (double)front[j++],
                  (double)(k * stride % MOST), "a place of the front");
}

const struct check_test check_hidden[] = {
    {"cost and error exchanged", test_exchanged, 2, 0},
    {"costs and errors in any unit", test_units, 1, 0},
    {"four hundred choices", test_many, 1, 0},
    {0}};
