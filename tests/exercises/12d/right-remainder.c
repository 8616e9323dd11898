/* Products of doubles, and what is rounded off them. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3];
    int v[3];
};

static bool equal_products(double a, double b, double c, double d)
{
    return a * b == c * d && fma(a, b, -(a * b)) == fma(c, d, -(c * d));
}

static bool parallel(const double a[3], const double b[3])
{
    return equal_products(a[0], b[1], a[1], b[0]) &&
           equal_products(a[1], b[2], a[2], b[1]) &&
           equal_products(a[2], b[0], a[0], b[2]);
}

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    double line[3] = {weight[0], weight[1], weight[2]};
    for (bool look = true, go = true; go; go = look, look = false)
        for (size_t i = 2 * n + 1; i-- > 0;) {
            double w[3];
            for (int k = 2; k >= 0; --k)
                w[k] = i == 2 * n ? weight[k]
                       : i % 2    ? body[i / 2].v[k]
                                  : (double)body[i / 2].x[k] - body[0].x[k];
            if (look && line[0] == 0 && line[1] == 0 && line[2] == 0)
                for (int k = 2; k >= 0; --k)
                    line[k] = w[k];
            if (!look && !parallel(line, w))
                return false;
        }
    for (int k = 2; k >= 0; --k)
        along[k] = (int)line[k];
    return true;
}
