/* From chapters/06-room.nw: edit there, then run make tangle. */
/* checksum 1296477690 of the lines below */
/* Samples the distance between two big disks among ideal small ones. */
#include "toolbox/random.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double L = 5, step = 0.3, r[] = {1, 0.2}; /* m */
static int D = 2, N = 2 + 72; /* axes; 2 big and 72 small disks */
static double x[402][3];      /* m */

static double distance(const double a[], const double b[])
{
    double square = 0;
    for (int k = 0; k < D; ++k) {
        const double way = b[k] - a[k], to = way - L * round(way / L);
        square += to * to;
    }
    return sqrt(square);
}

/* Tries to move disk i: a big one by a step, a small one to a random place.
   Returns whether it moved. */
static bool try_move(int i, struct random *dice)
{
    double place[3] = {0};
    for (int k = 0; k < D; ++k)
        place[k] = i > 1 ? random_between(dice, 0, L)
                         : x[i][k] + random_between(dice, -step, step);
    for (int j = 0; j < (i < 2 ? N : 2); ++j)
        if (j != i && distance(place, x[j]) < r[i > 1] + r[j > 1])
            return false;
    memcpy(x[i], place, sizeof place);
    return true;
}

int main(int argc, char *argv[])
{
    const long sweeps = argc > 1 ? atol(argv[1]) : 10;
    struct random dice;
    random_seed(&dice, 1);
    if (argc > 2)
        D = 3, N = 2 + 400;
    x[1][0] = x[1][D - 1] = L / 2;
    for (int i = 2; i < N; ++i)
        while (!try_move(i, &dice))
            ;
    for (long k = 1 - sweeps / 10 * N; k <= sweeps * N; ++k) {
        const int from = random_below(&dice, 2) == 0 ? 0 : 2;
        try_move(from + (int)random_below(&dice, from ? N - 2 : 2), &dice);
        if (k > 0 && k % N == 0)
            printf("%.6f\n", distance(x[1], x[0]));
    }
}
