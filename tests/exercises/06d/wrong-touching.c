/* mistake: touching-passed-by */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    size_t moving = first, next, pushes = 0;
    for (;;) {
        double least = length;
        next = n;
        for (size_t j = 0; j < n; ++j) {
            double dy = fabs(y[j] - y[moving]);
            dy = fmin(dy, height - dy);
            if (j == moving || dy >= sigma)
                continue;
            double way = x[j] - x[moving] - sqrt(sigma * sigma - dy * dy);
            if (way < 0)
                way += width;
            if (way < least) {
                least = way;
                next = j;
            }
        }
        x[moving] += least;
        x[moving] -= width * floor(x[moving] / width);
        if (next == n)
            return pushes;
        length -= least;
        moving = next;
        ++pushes;
    }
}
