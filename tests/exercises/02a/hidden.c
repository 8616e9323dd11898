/* The hidden tests of exercise 02a, "The next collision on a ring". */

#include "examiner/check.h"
#include "call.h"

enum { BEADS = 300 };

struct ring {
    size_t n;
    double length, x[BEADS], v[BEADS];
};

static const char *input(const struct ring *r, double unit)
{
    return check_text("ring of %g m with %zu beads, the first at %g m (%g "
                      "m/s), the last at %g m (%g m/s); unit %g m",
                      r->length, r->n, r->x[0], r->v[0], r->x[r->n - 1],
                      r->v[r->n - 1], unit);
}

/* The first bead is the fastest of all, so that somebody meets. */
static struct ring draw_ring(void)
{
    struct ring r = {.n = (size_t)check_draw_whole(2, BEADS)};
    for (size_t i = 0; i < r.n; ++i) {
        r.x[i] = r.length;
        r.v[i] = i == 0 ? 3.5 : check_draw(-3.0, 3.0);
        r.length += check_draw(0.1, 4.0) * check_draw(1.0, 1.1);
    }
    return r;
}

/* The gap to the right of a bead when all have flown for a time. */
static double gap_after(const struct ring *r, size_t k, double time)
{
    const size_t right = k + 1 < r->n ? k + 1 : 0;
    const double there = r->x[right] + (right > 0 ? 0.0 : r->length);
    return there + r->v[right] * time - (r->x[k] + r->v[k] * time);
}

/* Let all beads fly for the time that was found. Nobody may have come
   through a neighbour, and the two that were named must be at one place. */
CHECK_TIMES(30, test_flown, i)
{
    const struct ring r = draw_ring();
    size_t left = r.n;
    const double time = next_meeting(r.n, r.length, r.x, r.v, &left);
    double smallest = INFINITY;
    for (size_t k = 0; k < r.n; ++k)
        smallest = fmin(smallest, gap_after(&r, k, time));
    const double gaps[] = {smallest,
                           left < r.n ? gap_after(&r, left, time) : NAN};
    for (int k = 0; k < 2; ++k)
        CHECK_NEAR(gaps[k],
                   .quantity =
                       k ? "gap of the two that you named, after the time "
                           "that you returned"
                         : "smallest gap after the time that you returned",
                   .unit = "m", .input = input(&r, 1.0),
                   .tolerance = 8.0 * DBL_EPSILON * (r.length + 3.5 * time),
                   .because = "8 epsilons of the length and of the way");
}

/* Whether two pairs meet at nearly the same time. */
static bool is_tie(const struct ring *r, double time)
{
    int near = 0;
    for (size_t k = 0; k < r->n; ++k)
        near += fabs(gap_after(r, k, time)) < 1e-7;
    return near > 1;
}

/* A ring in a mirror: the order of the beads and all velocities turn round,
   and the times stay. In other units it is the same ring, too. */
CHECK_TIMES(30, test_mirror, i)
{
    const struct ring r = draw_ring();
    const double unit = ldexp(1.0, check_draw_whole(-60, 60));
    const double edge = 0.5 * (r.length + r.x[r.n - 1]);
    struct ring m = {.n = r.n, .length = r.length * unit};
    for (size_t k = 0; k < r.n; ++k) {
        m.x[k] = (edge - r.x[r.n - 1 - k]) * unit;
        m.v[k] = -r.v[r.n - 1 - k] * unit;
    }
    size_t left = r.n, mirrored = r.n;
    const double time = next_meeting(r.n, r.length, r.x, r.v, &left);
    const double again = next_meeting(m.n, m.length, m.x, m.v, &mirrored);
    if (is_tie(&r, time))
        return;
    CHECK_NEAR(again, .quantity = "time in the mirror", .unit = "s",
               .input = input(&m, unit), .expected = time,
               .tolerance = 1e-9 * time,
               .because =
                   "a billionth: the places in the mirror are rounded");
    CHECK_NEAR((double)mirrored, .quantity = "*left in the mirror",
               .input = input(&m, unit),
               .expected = (double)((2 * r.n - 2 - left) % r.n),
               .because = "a number of a bead is exact");
}

const struct check_test check_hidden[] = {
    {"until then nobody has come through a neighbour", test_flown, 2, 0},
    {"a ring in a mirror, in any unit", test_mirror, 1, 0},
    {0}};
