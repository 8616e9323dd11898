/* mistake: rounding-refused */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct state {
    double x, y, vx, vy;
};

static double at(double x, double v, double size, double t)
{
    double turns = floor((x + v * t) / size);
    double rest = x + v * t - turns * size;
    return fmod(turns, 2.0) != 0.0 ? size - rest : rest;
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    struct state s = {0.3 * width, 0.4 * height, 0.83 * width,
                      0.57 * height},
                 kept[300];
    double tick = 0.31;
    int i;
    run(s, tick, 300, kept);
    for (i = 0; i < 300; i++) {
        double x = at(s.x, s.vx, width, (i + 1) * tick);
        double y = at(s.y, s.vy, height, (i + 1) * tick);
        if (kept[i].x != x || kept[i].y != y)
            return false;
    }
    return true;
}
