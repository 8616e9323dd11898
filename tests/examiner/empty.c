/* A suite whose second test checks nothing. */
#include "examiner/check.h"
#include <stddef.h>

double twice(double x);

static void test_one(void)
{
    CHECK_NEAR(twice(1), .expected = 2);
}

static void test_nothing(void)
{
    twice(2);
}

const struct check_suite check_suite = {
    .file = "99b-twice.c",
    .title = "Nothing",
    .minutes = 5,
    .tests = {{"twice one is two", test_one, 1, 0},
              {"nothing is checked", test_nothing, 1, 0},
              {0}},
};
