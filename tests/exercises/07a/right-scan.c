/* A right answer: every cell of the box is asked whether it is near. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

static long own(double x, double side, size_t n)
{
    long k;
    while (x < 0) {
        if (x + side == side)
            return (long)n - 1;
        x += side;
    }
    while (x >= side)
        x -= side;
    k = (long)(x / (side / n));
    return k == (long)n ? k - 1 : k;
}

static bool is_near(size_t a, long b, size_t n)
{
    long d = labs((long)a - b);
    return d <= 1 || d >= (long)n - 1;
}

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    long column = own(at[0], box[0], cells[0]);
    long row = own(at[1], box[1], cells[1]);
    size_t k, count = 0;
    for (k = 0; k < cells[0] * cells[1]; k++)
        if (is_near(k % cells[0], column, cells[0]) &&
            is_near(k / cells[0], row, cells[1]))
            around[count++] = k;
    return count;
}
