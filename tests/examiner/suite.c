/* The suite of an exercise that is none of the book's: twice(x) is 2 x. */
#include "examiner/check.h"
#include <stddef.h>

double twice(double x);

static void check_twice(double x)
{
    CHECK_NEAR(twice(x), .quantity = "twice the length", .unit = "m",
               .input = check_text("x = %g m", x), .expected = 2 * x,
               .tolerance = 1e-12, .because = "nothing is rounded",
               .equation = "eq:twice",
               .question = "How much is one and one?",
               .mistakes = {{"squared", x * x, "Twice is not squared."},
                            {"once", x, "Once is not twice."}});
}

static void test_one(void)
{
    check_twice(1);
}

static void test_three(void)
{
    check_twice(3);
}

static void test_below_zero(void)
{
    check_twice(-5);
}

const struct check_suite check_suite = {
    .file = "99a-twice.c",
    .title = "Twice",
    .minutes = 5,
    .tests = {{"twice one is two", test_one, 1, 0},
              {"twice three is six", test_three, 1, 0},
              {"twice a negative number is negative", test_below_zero, 1,
               0},
              {0}},
    .idle = {test_below_zero},
};
