/* The hidden tests of exercise 11c, "Going back". */

#include "examiner/check.h"
#include "call.h"

static void draw(struct sphere *a, struct sphere *b)
{
    *a =
        (struct sphere){check_draw(0.1, 3.0),
                        check_draw(0.4, 0.6),
                        {0.0, 0.0, 0.0},
                        {check_draw(0.5, 1.0), check_draw(-0.2, 0.2), 0.1}};
    *b = (struct sphere){
        check_draw(0.1, 3.0),
        check_draw(0.4, 0.6),
        {0.7, check_draw(-0.2, 0.2), check_draw(-0.2, 0.2)},
        {check_draw(-1.0, -0.5), 0.1, check_draw(-0.2, 0.2)}};
}

static void check(double got, double expected, const char *what)
{
    CHECK_NEAR(got, .quantity = what,
               .input = "two spheres, drawn, that overlap",
               .expected = expected, .tolerance = 1e-12,
               .because = "a handful of roundings, of numbers near 1");
}

CHECK_TIMES(20, test_train, i)
{
    struct sphere a, b, c, d;
    draw(&a, &b);
    c = a;
    d = b;
    c.v[1] += 3.0;
    d.v[1] += 3.0;
    const double t = go_back(&a, &b, 1.0);
    check(t > 0.0 ? 1.0 : 0.0, 1.0, "is it some time ago? (1 yes, 0 no)");
    check(go_back(&c, &d, 1.0), t, "time ago, from a train");
    check(c.v[0], a.v[0], "velocity along x, from a train");
    check(d.v[1] - 3.0, b.v[1], "velocity along y, from a train");
}

CHECK_TIMES(20, test_exchanged, i)
{
    struct sphere a, b, c, d;
    draw(&a, &b);
    c = a;
    d = b;
    const double t = go_back(&a, &b, 1.0);
    check(go_back(&d, &c, 1.0), t, "time ago, exchanged");
    check(c.x[0], a.x[0], "place, exchanged");
    check(d.v[1], b.v[1], "velocity, exchanged");
}

const struct check_test check_hidden[] = {
    {"from a train it is the same", test_train, 1, 0},
    {"exchanged it is the same", test_exchanged, 1, 0},
    {0}};
