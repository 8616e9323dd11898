/* mistake: chain-broken */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3];
    int v[3];
};

static int par(const int a[3], const int b[3])
{
    long long x = a[0], y = a[1], z = a[2];
    return x * b[1] == y * b[0] && y * b[2] == z * b[1] &&
           z * b[0] == x * b[2];
}

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    static int list[1000][3];
    size_t m = 0, i, ref = 0;
    int k;
    for (k = 0; k < 3; k++)
        list[m][k] = weight[k];
    m++;
    for (i = 0; i < n; i++) {
        for (k = 0; k < 3; k++)
            list[m][k] = body[i].x[k] - body[0].x[k];
        m++;
        for (k = 0; k < 3; k++)
            list[m][k] = body[i].v[k];
        m++;
    }
    while (ref < m && !list[ref][0] && !list[ref][1] && !list[ref][2])
        ref++;
    if (ref == m)
        ref = 0;
    for (k = 0; k < 3; k++)
        along[k] = list[ref][k];
    for (i = 0; i < m; i++)
        if (i > 0 && !par(list[i - 1], list[i]))
            return false;
    return true;
}
