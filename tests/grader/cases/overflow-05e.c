/* 05e failed: asks for so many samples that their bytes are no number */
/* Found by a trial of the second edition. */
#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>
#include <math.h>
#include <string.h>
#include <unistd.h>
struct state {
    double x, y, vx, vy;
};
bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    static struct state k[4];
    struct state s = {width / 2, height / 2, 1, 0.5};
    run(s, 0.01, ((size_t)1 << 59) + 1, k);
    return true;
}
