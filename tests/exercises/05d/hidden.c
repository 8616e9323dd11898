/* The hidden tests of exercise 05d, "Pressure from a list of wall hits". */

#include "examiner/check.h"
#include "call.h"

enum { HITS = 30 };

/* A list of hits, and one place behind it. */
struct list {
    double size[2], energy, from, until;
    size_t disks;
    struct wall_hit hit[HITS + 1];
};

/* Hits of any kind, in the order of time. */
static struct list draw_list(void)
{
    struct list l = {.size = {check_draw(1.0, 9.0), check_draw(1.0, 9.0)},
                     .energy = check_draw(1.0, 50.0),
                     .from = check_draw(0.0, 5.0),
                     .until = check_draw(15.0, 20.0),
                     .disks = (size_t)check_draw_whole(2, 40)};
    double t = 0.0;
    for (int i = 0; i <= HITS; ++i) {
        const enum wall wall = (enum wall)check_draw_whole(LEFT, TOP);
        const double v = check_draw(0.1, 3.0);
        t += check_draw(0.3, 1.5);
        l.hit[i] = (struct wall_hit){t, wall, check_draw(0.1, 9.0),
                                     wall == RIGHT || wall == TOP ? v : -v};
    }
    return l;
}

static double answer(const struct list *l, double from, double until, int k)
{
    double z[2] = {NAN, NAN};
    wall_z(HITS, l->hit, l->size, l->disks, l->energy, from, until, z);
    return z[k];
}

/* From the push outwards on the two walls across axis k: a wall at the
   right or at the top is hit by a positive velocity. The force over
   the length of both walls, times the area, is the force times half the
   length of the box along the axis. */
static double exact(const struct list *l, double from, double until, int k)
{
    const struct wall_hit *h = l->hit;
    long double push[4] = {0.0L};
    while (!(h->t > from))
        ++h;
    for (; h->t <= until && h != l->hit + HITS; ++h)
        push[h->wall] += 2.0L * h->mass * h->v;
    return (double)((push[2 * k + 1] - push[2 * k]) / (until - from) *
                    l->size[k] / 2.0L / l->energy);
}

/* There is a rounding for each hit and a dozen for the rest. */
static void check(double got, double expected, const char *quantity,
                  const struct list *l)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input = check_text("%d drawn hits, from %g s until %g s, "
                                   "box %g m by %g m, N = %zu, %g J",
                                   HITS, l->from, l->until, l->size[0],
                                   l->size[1], l->disks, l->energy),
               .expected = expected,
               .tolerance =
                   4.0 * (HITS + 16) * DBL_EPSILON * fabs(expected),
               .because = "4 epsilons for each hit, and 64 for the rest");
}

/* Lengths, times and masses in other units: Z has none. */
CHECK_TIMES(10, test_units, i)
{
    const struct list l = draw_list();
    const double m = ldexp(1.0, check_draw_whole(-30, 30));
    const double s = ldexp(1.0, check_draw_whole(-30, 30));
    const double kg = ldexp(1.0, check_draw_whole(-30, 30));
    struct list other = l;
    for (int h = 0; h <= HITS; ++h) {
        other.hit[h].t *= s;
        other.hit[h].v *= m / s;
        other.hit[h].mass *= kg;
    }
    other.size[0] *= m;
    other.size[1] *= m;
    other.energy *= kg * m * m / (s * s);
    for (int k = 0; k < 2; ++k)
        check(answer(&other, l.from * s, l.until * s, k),
              exact(&l, l.from, l.until, k),
              k ? "z[1] in other units" : "z[0] in other units", &l);
}

/* Left is bottom now, and right is top. */
CHECK_TIMES(10, test_on_its_side, i)
{
    const struct list l = draw_list();
    struct list side = l;
    for (int h = 0; h <= HITS; ++h)
        side.hit[h].wall = (enum wall)((l.hit[h].wall + 2) % 4);
    side.size[0] = l.size[1];
    side.size[1] = l.size[0];
    for (int k = 0; k < 2; ++k)
        check(answer(&side, l.from, l.until, k),
              exact(&l, l.from, l.until, 1 - k),
              k ? "z[1] with the box on its side"
                : "z[0] with the box on its side",
              &l);
}

/* Cut at the moment of a hit: time times Z is a sum, and the hit is in just
   one of the two parts. */
CHECK_TIMES(20, test_cut, i)
{
    const struct list l = draw_list();
    const double cut = l.hit[check_draw_whole(6, 9)].t;
    const int k = check_draw_whole(0, 1);
    const double until = l.hit[check_draw_whole(20, HITS - 1)].t;
    const double from = l.hit[check_draw_whole(0, 3)].t;
    check((answer(&l, from, cut, k) * (cut - from) +
           answer(&l, cut, until, k) * (until - cut)) /
              (until - from),
          exact(&l, from, until, k),
          "Z of two times that follow each other, cut at a hit", &l);
}

/* A list without hits; or with none in the time between two of them. */
CHECK_TIMES(10, test_quiet, i)
{
    const struct list l = draw_list();
    const int last = check_draw_whole(0, HITS - 2);
    const double from = l.hit[last].t;
    const double until = 0.5 * (from + l.hit[last + 1].t);
    double z[2] = {NAN, NAN};
    wall_z(0, l.hit, l.size, l.disks, l.energy, from, l.until, z);
    for (int k = 0; k < 2; ++k) {
        check(z[k], 0.0, "Z from a list without hits", &l);
        check(answer(&l, from, until, k), 0.0,
              "Z of a time between two hits", &l);
    }
}

const struct check_test check_hidden[] = {
    {"Z has no unit", test_units, 1, 0},
    {"a box may lie on its side", test_on_its_side, 1, 0},
    {"a time that is cut at a hit is the sum of its parts", test_cut, 2, 0},
    {"an empty list of hits leaves the wall in peace", test_quiet, 1, 0},
    {0}};
