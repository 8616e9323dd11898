/* mistake: own-cell-forgotten */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

static int place(double x, double side, int n)
{
    int c;
    x -= side * floor(x / side);
    c = (int)(x / side * n);
    if (c > n - 1)
        c = n - 1;
    return c;
}

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    int nx = (int)cells[0], ny = (int)cells[1];
    int cx = place(at[0], box[0], nx), cy = place(at[1], box[1], ny);
    size_t count = 0, found, i, k;
    int dx, dy;
    for (dy = -1; dy <= 1; dy++)
        for (dx = -1; dx <= 1; dx++) {
            if (dx == 0 && dy == 0)
                continue;
            found =
                (size_t)((cy + dy + ny) % ny * nx + (cx + dx + nx) % nx);
            for (i = 0; i < count && around[i] < found; i++)
                ;
            if (i < count && around[i] == found)
                continue;
            for (k = count++; k > i; k--)
                around[k] = around[k - 1];
            around[i] = found;
        }
    return count;
}
