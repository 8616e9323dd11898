/* The hidden tests of exercise 05c, "Mend the clock". */

#include "examiner/check.h"

/* As in the suite, which makes the disk fly and knows where it must be. */
struct alone {
    double length[2], radius, x[2], v[2], tick;
    size_t samples;
};

void clock_check_alone(const struct alone *a);

/* Lengths and times in other units. */
static struct alone in_units(double m, double s)
{
    struct alone a = {.radius = check_draw(0.1, 0.8) * m,
                      .tick = check_draw(0.05, 2.5) * s,
                      .samples = 30};
    for (int k = 0; k < 2; ++k) {
        a.length[k] = check_draw(2.0, 9.0) * m;
        a.x[k] = 0.5 * a.length[k];
        a.v[k] = check_draw(-3.0, 3.0) * m / s;
    }
    return a;
}

static void test_units(void)
{
    static const double unit[][2] = {
        {1e3, 1.0}, {1e-6, 1.0}, {1.0, 1e-6}, {1e-9, 1e-12}, {1e6, 1e3}};
    for (size_t i = 0; i < sizeof unit / sizeof unit[0]; ++i) {
        const struct alone a = in_units(unit[i][0], unit[i][1]);
        clock_check_alone(&a);
    }
}

/* No collision at all, or none across two of the walls: box_next says
   INFINITY, or keeps to one axis. */
static void test_rest(void)
{
    for (int still = 1; still <= 3; ++still) {
        struct alone a = in_units(1.0, 1.0);
        for (int k = 0; k < 2; ++k)
            if (still & 1 << k)
                a.v[k] = 0.0;
        clock_check_alone(&a);
    }
}

/* The disk begins at a wall, moving into it, and is at a wall again at each
   tick, or at each second or third collision. All numbers are sums of a few
   powers of two, so that nothing is rounded and time and tick are equal. */
CHECK_TIMES(20, test_ties, i)
{
    const double free = 0.25 * check_draw_whole(2, 12);
    const double speed = ldexp(1.0, check_draw_whole(-3, 3));
    const int side = check_draw_whole(0, 1);
    struct alone a = {.radius = 0.125 * check_draw_whole(1, 4),
                      .samples = 24};
    for (int k = 0; k < 2; ++k) {
        a.length[k] = free + 2.0 * a.radius;
        a.x[k] = side ? a.length[k] - a.radius : a.radius;
        a.v[k] = side ? speed : -speed;
    }
    a.tick = check_draw_whole(1, 3) * free / speed;
    clock_check_alone(&a);
}

const struct check_test check_hidden[] = {
    {"in other units the clock is as right", test_units, 1, 0},
    {"a disk at rest is recorded, too", test_rest, 1, 0},
    {"collisions fall on the ticks and on the start", test_ties, 2, 0},
    {0}};
