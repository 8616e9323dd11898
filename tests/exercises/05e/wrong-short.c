/* mistake: small-error-passes */
/* It looks at two ticks, in which a little lost time does not add up. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct state {
    double x, y, vx, vy;
};

static double at(double x, double v, double size, double t)
{
    double boxes = fmod(fabs(x + v * t) / size, 2);
    return size * (boxes > 1 ? 2 - boxes : boxes);
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    struct state s = {0.3 * width, 0.4 * height, 3.83 * width,
                      2.57 * height},
                 kept[2];
    double tick = 0.31;
    int i;
    run(s, tick, 2, kept);
    for (i = 0; i < 2; i++) {
        double x = at(s.x, s.vx, width, (i + 1) * tick);
        double y = at(s.y, s.vy, height, (i + 1) * tick);
        if (!(fabs(x - kept[i].x) < 8e-3 * width) ||
            !(fabs(y - kept[i].y) < 8e-3 * height))
            return false;
    }
    return true;
}
