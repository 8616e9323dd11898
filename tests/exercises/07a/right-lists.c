/* A right answer: a list of columns, a list of rows, and all pairs. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

static size_t near(double x, double side, size_t n, size_t list[3])
{
    double part = x / side;
    size_t c, i;
    part -= floor(part);
    c = (size_t)fmin(floor(part * n), n - 1.0);
    if (n <= 3) {
        for (i = 0; i < n; i++)
            list[i] = i;
        return n;
    }
    list[0] = c > 0 ? c - 1 : 0;
    list[1] = c > 0 ? c : 1;
    list[2] = c > 0 ? c + 1 : n - 1;
    if (c == n - 1) {
        list[0] = 0;
        list[1] = n - 2;
        list[2] = n - 1;
    }
    return 3;
}

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    size_t columns[3], rows[3], count = 0, i, j;
    size_t nc = near(at[0], box[0], cells[0], columns);
    size_t nr = near(at[1], box[1], cells[1], rows);
    for (j = 0; j < nr; j++)
        for (i = 0; i < nc; i++)
            around[count++] = rows[j] * cells[0] + columns[i];
    return count;
}
