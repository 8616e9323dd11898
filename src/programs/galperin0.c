/* From chapters/01-collide.nw: edit there, then run make tangle. */
/* checksum 3957324858 of the lines below */
/* Counts the collisions of a heavy ball, a light ball and a wall. */
#include "line/collide.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char *argv[])
{
    const double ratio = argc == 2 ? atof(argv[1]) : 0; /* heavy / light */
    double x1 = 0.42, v1 = 0, x2 = 0.77, v2 = -1; /* light, heavy: m, m/s */
    long n = 0;
    if (!(ratio > 0)) {
        fprintf(stderr, "galperin0: expected the ratio of the masses\n");
        return 2;
    }
    for (;; ++n) {
        printf("%.9g %.9g\n", sqrt(ratio) * x2, x1); /* scaled */
        const bool blow = v1 > v2, end = !blow && !(v1 < 0);
        const double wait = end    ? 1
                            : blow ? (x2 - x1) / (v1 - v2)
                                   : -x1 / v1;
        x1 += v1 * wait;
        x2 += v2 * wait;
        if (end) {
            printf("%.9g %.9g\n", sqrt(ratio) * x2, x1);
            break;
        }
        if (blow)
            collide(&v1, &v2, 1, 1 / ratio, 1);
        else
            collide(&v1, &(double){0}, 1, 0, 1);
    }
    printf("# collisions %ld\n", n);
    return 0;
}
