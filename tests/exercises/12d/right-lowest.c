/* Each direction in lowest terms, and the first number of it positive. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3];
    int v[3];
};

static int divisor(int a, int b)
{
    while (b != 0) {
        int c = a % b;
        a = b;
        b = c;
    }
    return a < 0 ? -a : a;
}

static bool same(int x, int y, int z, int along[3])
{
    int g = divisor(divisor(x, y), z);
    if (g == 0)
        return true;
    if (x < 0 || (x == 0 && (y < 0 || (y == 0 && z < 0))))
        g = -g;
    x /= g;
    y /= g;
    z /= g;
    if (along[0] == 0 && along[1] == 0 && along[2] == 0) {
        along[2] = z;
        along[1] = y;
        along[0] = x;
    }
    return along[0] == x && along[1] == y && along[2] == z;
}

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    const struct body *b;
    for (int k = 0; k < 3; k++)
        along[k] = 0;
    for (b = body; b < body + n; b++) {
        const int *v = b->v;
        if (!same(v[0], v[1], v[2], along) ||
            !same(b->x[0] - body->x[0], b->x[1] - body->x[1],
                  b->x[2] - body->x[2], along))
            return false;
    }
    return same(weight[0], weight[1], weight[2], along);
}
