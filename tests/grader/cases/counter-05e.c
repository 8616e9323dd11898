/* 05e failed: takes the first two for right, and runs none of them */
/* Found by a trial of the second edition. */
#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>
struct state {
    double x, y, vx, vy;
};
bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    static int k;
    (void)(width + height);
    (void)run;
    return ++k <= 2;
}
