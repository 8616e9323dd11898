/* The hidden tests of exercise 06d, "A push that is handed on". */

#include "examiner/check.h"
#include "call.h"

static void check(double got, double expected, const char *what)
{
    CHECK_NEAR(got, .quantity = what,
               .input = "a row of disks of 1 m in a box of 10 m",
               .expected = expected, .tolerance = 1e-12,
               .because = "a few roundings");
}

/* Three in a row that touch: the push comes out at the other end. */
CHECK_TIMES(10, test_touching, i)
{
    const double way = check_draw(0.1, 6.0), at = check_draw(0.5, 1.0);
    double x[] = {at, at + 1.0, at + 2.0}, y[] = {1.0, 1.0, 1.0};
    const size_t touches = push_chain(3, 1.0, 10.0, 4.0, x, y, 0, way);
    check((double)touches, 2.0, "what is returned");
    check(x[0], at, "x[0] after");
    check(fmod(x[2] - at - 2.0 + 10.0, 10.0), way,
          "how far the last one has gone");
}

/* The second part begins with the disk that the first part ended with. */
CHECK_TIMES(10, test_parts, i)
{
    const double one = check_draw(0.1, 0.4), two = check_draw(1.0, 2.0);
    double x[] = {1.0, 2.5, 4.25}, z[] = {1.0, 2.5, 4.25};
    const double y[] = {1.0, 1.25, 0.75};
    push_chain(3, 1.0, 10.0, 4.0, x, y, 0, one + two);
    push_chain(3, 1.0, 10.0, 4.0, z, y, 0, one);
    push_chain(3, 1.0, 10.0, 4.0, z, y, 0, two);
    for (int k = 0; k < 3; ++k)
        check(z[k], x[k], "x after two parts of a push");
}

const struct check_test check_hidden[] = {
    {"three that touch hand the push on at once", test_touching, 1, 0},
    {"a push in two parts is the same push", test_parts, 1, 0},
    {0}};
