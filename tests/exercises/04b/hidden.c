/* The hidden tests of exercise 04b, "One blow at a time". */

#include "examiner/check.h"
#include "call.h"

static void draw_sort(struct sort *s)
{
    s->m = check_draw(0.01, 5.0);
    s->v = check_draw(1.0, 50.0) * (check_draw_whole(0, 1) ? 1.0 : -1.0);
    s->left = check_draw(0.0, 9.0);
    s->right = check_draw(0.0, 9.0);
}

static void check_same(double got, double expected, const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity, .input = "a rain drawn",
               .expected = expected,
               .tolerance = 100.0 * DBL_EPSILON * fabs(expected),
               .because = "a hundred epsilons: a few roundings");
}

/* In grams and kilometres: factors of 2, which round nothing. */
CHECK_TIMES(30, test_units, i)
{
    struct sort s, t;
    double a = NAN, b = NAN;
    const double im = check_draw(0.0, 2.0), V = check_draw(-0.1, 0.1);
    draw_sort(&s);
    if (s.v < 0.0)
        s.right += 1.0;
    else
        s.left += 1.0;
    t = (struct sort){ldexp(s.m, -10), ldexp(s.v, 7), ldexp(s.left, 3),
                      ldexp(s.right, 3)};
    const double f = rain_force(1, &s, im, V, &a);
    const double g = rain_force(1, &t, ldexp(im, 10), ldexp(V, 7), &b);
    check_same(g, ldexp(f, 7), "mean force in other units");
    check_same(b, a, "friction in other units");
}

/* A sort in two halves, one of them listed last, is the same rain. */
CHECK_TIMES(30, test_halves, i)
{
    struct sort s[3];
    double a = NAN, b = NAN;
    const double im = check_draw(0.0, 2.0);
    draw_sort(&s[0]);
    draw_sort(&s[1]);
    s[0].v = fabs(s[0].v);
    s[1].v = fabs(s[1].v);
    s[0].left += 1.0;
    s[2] = s[0];
    s[2].left *= 0.25;
    const double f = rain_force(2, s, im, 0.01, &a);
    s[0].left *= 0.75;
    const double g = rain_force(3, s, im, 0.01, &b);
    check_same(g, f, "mean force of three sorts");
    check_same(b, a, "friction of three sorts");
}

const struct check_test check_hidden[] = {
    {"grams and other units press alike", test_units, 1, 0},
    {"a sort in two halves is the same rain", test_halves, 1, 0},
    {0}};
