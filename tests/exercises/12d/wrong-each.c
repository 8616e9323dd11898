/* mistake: each-kind-for-itself */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3];
    int v[3];
};

static bool fit(int a, int b, int c, int along[3])
{
    long long x = a, y = b, z = c;
    if (!along[0] && !along[1] && !along[2]) {
        along[0] = a;
        along[1] = b;
        along[2] = c;
    }
    return x * along[1] == y * along[0] && y * along[2] == z * along[1] &&
           z * along[0] == x * along[2];
}

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    int way[3] = {0}, k;
    for (k = 0; k < 3; k++)
        along[k] = 0;
    bool ok = fit(weight[0], weight[1], weight[2], along);
    for (size_t i = 0; i < n; i++)
        if (!fit(body[i].x[0] - body[0].x[0], body[i].x[1] - body[0].x[1],
                 body[i].x[2] - body[0].x[2], along) ||
            !fit(body[i].v[0], body[i].v[1], body[i].v[2], way))
            ok = false;
    for (k = 0; k < 3 && !along[0] && !along[1] && !along[2]; k++)
        along[k] = way[k];
    return ok;
}
