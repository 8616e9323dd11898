/* Exercise 05e, worked: a check that finds the clock.

   The energy of a disk is its speed, and a wall changes no speed wherever
   the disk is when it turns round. So look at what belongs to a time: the
   place. One disk alone has no secrets. On each axis it goes to and fro,
   and unfolded, into a row of boxes of which every second one is a mirror
   image, it goes straight on. Where is it after k ticks? Where x + v k T
   is, with the row folded up again.

   Which run? The velocities are such that the walls are met at all times
   of a tick, sometimes twice between two, sometimes not at all, and that
   both axes have bounces. With whole numbers a bounce could fall on a tick,
   where one may wonder who is right. And in units of the box, for who knows
   how large it is.

   How near? A right program is within 1e-10 of the way. The way here has
   some 450 boxes, so 1e-7 of a box is far beyond its roundings, and a
   hundred times less than what a wrong one is off by.

   The pressure would do as well for most of these clocks: blows in a time,
   with a known mean. It needs long runs for a loss of a thousandth. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct state {
    double x, y, vx, vy;
};

/* The run, in boxes and seconds. */
static const struct state start = {0.31, 0.77, 0.8137, -0.5371};
static const double tick = 0.9173, near_enough = 1e-7;

enum { TICKS = 600 };

/* Whether a disk is there, in a row of boxes and mirrored boxes that is
   folded up. */
static bool is_there(double place, double boxes)
{
    const double folded = fabs(boxes - 2.0 * round(boxes / 2.0));
    return fabs(place - folded) <= near_enough;
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    static struct state kept[TICKS];
    run((struct state){start.x * width, start.y * height, start.vx * width,
                       start.vy * height},
        tick, TICKS, kept);
    for (int k = TICKS; k-- > 0;) {
        const double t = (k + 1) * tick;
        if (!is_there(kept[k].x / width, start.x + start.vx * t) ||
            !is_there(kept[k].y / height, start.y + start.vy * t))
            return false;
    }
    return true;
}
