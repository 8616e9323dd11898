/* From chapters/02-bonkers.nw: edit there, then run make tangle. */
/* checksum 3407825685 of the lines below */
/* Simulates ten beads on a wire between two stops, event by event. */
#include "line/collide.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { BEADS = 10, DIGITS = 10 };

/* The bodies from left to right, with a stop at each end; kg, m, m/s. */
static double mass[BEADS + 2] = {INFINITY, 9.3, 2.1, 5.2, 0.9, 3.4,
                                 1.2,      4.3, 0.8, 2.6, 1.4, INFINITY};
static double x[BEADS + 2] = {0,   0.5, 4.6, 5.3,  6.2,  6.9,
                              7.8, 8.5, 9.4, 10.2, 11.1, 12};
static double v[BEADS + 2] = {0, 2};

/* Returns the time (s) until gap i closes (2.3, eq:gap-time). */
static double wait_for(int i)
{
    const double gap = x[i + 1] - x[i];
    const double approach = v[i] - v[i + 1];
    if (approach > 0)
        return gap > 0 ? gap / approach : 0;
    return INFINITY;
}

/* Returns the gap that closes first. */
static int next_gap(void)
{
    int first = 0;
    for (int i = 1; i <= BEADS; ++i)
        if (wait_for(i) < wait_for(first))
            first = i;
    return first;
}

/* Moves all beads freely for the time `wait` (2.1, eq:flight). */
static void move_all(double wait)
{
    for (int i = 1; i <= BEADS; ++i)
        x[i] += v[i] * wait;
}

/* Prints one row: time, energy, position and velocity of every bead. */
static void print_row(double now)
{
    double energy = 0;
    for (int i = 1; i <= BEADS; ++i)
        energy += mass[i] * v[i] * v[i] / 2;
    printf("%g %.*g", now, DIGITS, energy);
    for (int i = 1; i <= BEADS; ++i)
        printf(" %.*g %.*g", DIGITS, x[i], DIGITS, v[i]);
    printf("\n");
}

int main(int argc, char *argv[])
{
    const double every = argc > 1 ? atof(argv[1]) : 1; /* between rows, s */
    const int rows = argc > 2 ? atoi(argv[2]) : 10;
    double now = 0;
    int collisions = 0;
    for (int i = 1; argc > 3 && i <= BEADS + 1; ++i)
        if (scanf("%lf%lf%lf", &mass[i], &x[i], &v[i]) != 3) {
            fprintf(stderr, "bonkers0: line %d: expected mass x v\n", i);
            return 2;
        }
    for (int k = 0; k <= rows; ++k) {
        const double clock = k * every;
        int i = next_gap();
        for (; now + wait_for(i) <= clock; i = next_gap()) {
            const double wait = wait_for(i);
            move_all(wait);
            now += wait;
            collide(&v[i], &v[i + 1], 1 / mass[i], 1 / mass[i + 1], 1);
            ++collisions;
        }
        move_all(clock - now);
        now = clock;
        print_row(now);
    }
    printf("# collisions %d\n", collisions);
    return 0;
}
