/* Further tests of exercise 12d, for the lecturer: the same scene with its
   axes exchanged, seen in a mirror, elsewhere, with its bodies in another
   order, and many bodies. */

#include "examiner/check.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3];
    int v[3];
};

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3]);

enum { MOST = 200, LARGE = 1000000000 };

struct scene {
    size_t n;
    struct body body[MOST + 1];
    int weight[3];
};

static bool check(const struct scene *s, const char *what, double got,
                  double expected, const char *quantity)
{
    return CHECK_NEAR(got, .quantity = quantity,
                      .input =
                          check_text("%zu bodies, drawn, %s", s->n, what),
                      .expected = expected, .tolerance = 0.0,
                      .because = "whole numbers leave no doubt",
                      .equation = "eq:one-line",
                      .question = "Is there an axis, a body or a place in "
                                  "your program that counts for more than "
                                  "others?");
}

static const char on_line[] = "is the scene on one line? (1 yes, 0 no)";

/* The vector (p, q, r) from one body to another and the vector v are
   parallel when v is a multiple of it. So all is made of multiples, of
   which `wrong` says which body, if any, has a velocity that is none. */
static struct scene draw_scene(size_t n, size_t wrong)
{
    struct scene s = {.n = n};
    const int along[3] = {check_draw_whole(1, 999),
                          check_draw_whole(-999, -1),
                          check_draw_whole(1, 999)};
    const int weight = check_draw_whole(-99, 99);
    for (size_t i = 0; i < n; ++i) {
        const int where = i == 0 ? 500 : check_draw_whole(-499, 499);
        const int fast = check_draw_whole(-499, 499);
        for (int k = 0; k < 3; ++k) {
            s.body[i].x[k] = 1000 * k + where * along[k];
            s.body[i].v[k] = fast * along[k];
        }
    }
    for (int k = 0; k < 3; ++k)
        s.weight[k] = weight * along[k];
    if (wrong < n)
        s.body[wrong].v[check_draw_whole(0, 2)] += 1;
    return s;
}

static bool asked(const struct scene *s)
{
    int along[3] = {-99, 7, 13};
    return one_line(s->n, s->body, s->weight, along);
}

static void exchange(int v[3], int j, int k)
{
    const int other = v[j];
    v[j] = v[k];
    v[k] = other;
}

static void test_axes(void)
{
    for (int i = 0; i < 40; ++i) {
        const size_t n = (size_t)check_draw_whole(2, 9);
        const size_t wrong =
            i % 2 ? n : (size_t)check_draw_whole(0, (int)n - 1);
        struct scene s = draw_scene(n, wrong);
        const int j = check_draw_whole(0, 2), k = (j + 1) % 3;
        if (!check(&s, "as it is", asked(&s), wrong == n, on_line))
            return;
        for (size_t b = 0; b < n; ++b) {
            exchange(s.body[b].x, j, k);
            exchange(s.body[b].v, j, k);
        }
        exchange(s.weight, j, k);
        if (!check(&s, "two axes exchanged", asked(&s), wrong == n,
                   on_line))
            return;
        for (size_t b = 0; b < n; ++b) {
            s.body[b].x[j] = -s.body[b].x[j];
            s.body[b].v[j] = -s.body[b].v[j];
        }
        s.weight[j] = -s.weight[j];
        if (!check(&s, "seen in a mirror", asked(&s), wrong == n, on_line))
            return;
    }
}

static void test_elsewhere(void)
{
    for (int i = 0; i < 40; ++i) {
        const size_t n = (size_t)check_draw_whole(2, 9);
        const size_t wrong =
            i % 2 ? n : (size_t)check_draw_whole(0, (int)n - 1);
        struct scene s = draw_scene(n, wrong);
        for (int k = 0; k < 3; ++k) {
            const int far =
                check_draw_whole(-LARGE + 1000000, LARGE - 1000000);
            for (size_t b = 0; b < n; ++b)
                s.body[b].x[k] += far;
        }
        const struct body last = s.body[n - 1];
        if (!check(&s, "far from the origin", asked(&s), wrong == n,
                   on_line))
            return;
        s.body[n - 1] = s.body[0];
        s.body[0] = last;
        if (!check(&s, "in another order", asked(&s), wrong == n, on_line))
            return;
    }
}

/* Many bodies on a line, and then one of them is off it. */
static void test_many(void)
{
    for (int i = 0; i < 10; ++i) {
        struct scene s = draw_scene(MOST, MOST);
        int along[3] = {-99, 7, 13};
        const size_t which = (size_t)check_draw_whole(1, MOST - 1);
        const bool line = one_line(s.n, s.body, s.weight, along);
        const double p =
            (double)along[0] * (s.body[1].x[1] - s.body[0].x[1]);
        const double q =
            (double)along[1] * (s.body[1].x[0] - s.body[0].x[0]);
        if (!check(&s, "as it is", line, 1.0, on_line) ||
            !check(&s, "as it is", p - q, 0.0,
                   "what along and the way from the first body to the "
                   "second have for the last number of their cross "
                   "product"))
            return;
        s.body[which].x[check_draw_whole(0, 2)] -= 1;
        if (!check(&s, "one of them off by one", asked(&s), 0.0, on_line))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"axes exchanged and reversed", test_axes, 1, 0},
    {"elsewhere and in another order", test_elsewhere, 2, 0},
    {"two hundred bodies", test_many, 1, 0},
    {0}};
