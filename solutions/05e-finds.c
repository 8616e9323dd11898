/* Exercise 05e, worked: a check that finds the clock.

   The energy of a disk is its speed, and a wall changes no speed wherever
   the disk is when it turns round. So look at what belongs to a time: the
   place. One disk alone has no secrets. On each axis it goes to and fro,
   and unfolded, into a row of boxes of which every second one is a mirror
   image, it goes straight on. Where is it after k ticks? Where x + v k T
   is, with the row folded up again.

   Which runs? The velocities are such that the walls are met at all times
   of a tick, sometimes twice between two, sometimes not at all, and that
   both axes have bounces. With whole numbers a bounce could fall on a tick,
   where one may wonder who is right. And in units of the box, for who knows
   how large it is.

   How near? A right program is within 1e-10 of the way. The way here has
   some 500 boxes, so 1e-7 of a box is far beyond its roundings, and a
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

enum { TICKS = 600 };

/* A row of boxes and mirrored boxes, folded up: x/size in units of a box.
 */
static double folded(double boxes)
{
    return fabs(boxes - 2.0 * round(boxes / 2.0));
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    const struct state s = {0.31 * width, 0.77 * height, 0.8137 * width,
                            -0.5371 * height};
    static struct state kept[TICKS];
    for (double tick = 0.1731; tick < 4.0; tick *= 2.37) {
        run(s, tick, TICKS, kept);
        for (int k = TICKS; k-- > 0;) {
            const double t = (k + 1) * tick;
            const double x = width * folded((s.x + s.vx * t) / width);
            const double y = height * folded((s.y + s.vy * t) / height);
            if (!(fabs(kept[k].x - x) <= 1e-7 * width) ||
                !(fabs(kept[k].y - y) <= 1e-7 * height))
                return false;
        }
    }
    return true;
}
