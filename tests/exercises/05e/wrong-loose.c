/* mistake: small-error-passes */
/* A ten-thousandth of the box is let pass, and a wrong one is off by 1e-5.
 */

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
                 kept[300];
    double tick = 0.31;
    int i;
    run(s, tick, 300, kept);
    for (i = 0; i < 300; i++) {
        double x = at(s.x, s.vx, width, (i + 1) * tick);
        double y = at(s.y, s.vy, height, (i + 1) * tick);
        if (!(fabs(x - kept[i].x) < 1e-4 * width) ||
            !(fabs(y - kept[i].y) < 1e-4 * height))
            return false;
    }
    return true;
}
