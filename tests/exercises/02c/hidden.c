/* The hidden tests of exercise 02c, "A million seconds, no collision". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 200 };

struct gas {
    size_t n;
    double length, x[MOST], v[MOST];
};

static struct gas answer(const struct gas *g, double t)
{
    struct gas a = {.n = g->n, .length = g->length};
    for (size_t k = 0; k < MOST; ++k)
        a.x[k] = a.v[k] = NAN;
    positions_at(g->n, g->length, g->x, g->v, t, a.x, a.v);
    return a;
}

static void check_body(const struct gas *a, const struct gas *expected,
                       size_t k, double t, double tolerance)
{
    const char *input =
        check_text("%zu bodies in %g m, t = %g s", a->n, a->length, t);
    CHECK_NEAR(a->x[k], .quantity = check_text("x[%zu]", k), .unit = "m",
               .input = input, .expected = expected->x[k],
               .tolerance = tolerance,
               .because = "4 epsilons of the length and of the way at top "
                          "speed, each time");
    CHECK_NEAR(a->v[k], .quantity = check_text("v[%zu]", k), .unit = "m/s",
               .input = input, .expected = expected->v[k],
               .because = "a velocity is never computed");
}

/* When each ghost has gone an odd number of lengths, it is in the mirror of
   the place where it began, and on its way back: the whole box is turned
   round, in any unit. All of it without a rounding. */
CHECK_TIMES(30, test_half_period, i)
{
    const double metre = ldexp(1.0, check_draw_whole(-40, 40));
    const double second = ldexp(1.0, check_draw_whole(-40, 40));
    struct gas g = {.n = (size_t)check_draw_whole(1, MOST)};
    double place = 0.0;
    for (size_t k = 0; k < g.n; ++k) {
        place += check_draw_whole(1, 64) / 64.0;
        g.x[k] = place * metre;
    }
    g.length = (ceil(place) + 1.0) * metre;
    for (size_t k = 0; k < g.n; ++k)
        g.v[k] = (2.0 * check_draw_whole(-9, 8) + 1.0) * g.length / second;
    struct gas turned = g;
    for (size_t k = 0; k < g.n; ++k) {
        turned.x[k] = g.length - g.x[g.n - 1 - k];
        turned.v[k] = -g.v[g.n - 1 - k];
    }
    const struct gas a = answer(&g, second);
    for (size_t k = 0; k < g.n; ++k)
        check_body(&a, &turned, k, second,
                   4.0 * DBL_EPSILON * 18.0 * g.length);
}

/* Whether any two bodies, or a body and a wall, nearly touch; so does what
   is not a number. */
static bool touches(const struct gas *g)
{
    double before = 0.0;
    for (size_t k = 0; k < g->n; ++k) {
        if (!(g->x[k] - before > 1e-9))
            return true;
        before = g->x[k];
    }
    return !(g->length - before > 1e-9);
}

/* To look twice is as good as to look once. Where two bodies nearly touch,
   at either time, we do not look. */
CHECK_TIMES(40, test_two_parts, i)
{
    struct gas g = {.n = (size_t)check_draw_whole(1, 40)};
    for (size_t k = 0; k < g.n; ++k) {
        g.x[k] = g.length + check_draw(0.1, 1.0);
        g.length = g.x[k] + 0.5;
        g.v[k] = check_draw(-3.0, 3.0);
    }
    const double t1 = check_draw(0.0, 500.0);
    const double t2 = check_draw(0.0, 500.0);
    const struct gas half = answer(&g, t1);
    const struct gas whole = answer(&g, t1 + t2);
    if (touches(&half) || touches(&whole))
        return;
    const struct gas a = answer(&half, t2);
    for (size_t k = 0; k < g.n; ++k)
        check_body(&a, &whole, k, t1 + t2,
                   8.0 * DBL_EPSILON * (2.0 * g.length + 3.0 * (t1 + t2)));
}

const struct check_test check_hidden[] = {
    {"half a period turns the box round", test_half_period, 2, 0},
    {"two parts of a time are as good as one", test_two_parts, 1, 0},
    {0}};
