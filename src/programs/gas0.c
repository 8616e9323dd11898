/* From chapters/07-gas.nw: edit there, then run make tangle. */
/* checksum 1406650457 of the lines below */
/* Prints the speed distribution of a gas, its error, and two theories. */
#include "box/disks.h"
#include "box/speeds.h"
#include "line/statistics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { BINS = 42 }; /* bins of u from 0 to 4 */
static const double width = 4.0 / BINS, Tc = 0.4 /* s */;

/* Places disks of speed 1 m/s on a lattice and runs a hundred collisions
   per disk. Returns false if the disks do not fit. */
static bool begin(struct disks *d, size_t count, double a, double b)
{
    struct random r;
    random_seed(&r, 1);
    if (!disks_create(d, 2, count))
        return false;
    d->box[0] = a;
    d->box[1] = b;
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = 0.1;
    if (!disks_place_lattice(d))
        return false;
    disks_set_speed(d, 1, &r);
    if (!disks_plan(d))
        return false;
    disks_run(d, INFINITY, 50 * count);
    disks_run(d, 1.01 * d->now, UINT64_MAX);
    disks_settle(d);
    return disks_plan(d);
}

/* Adds the speed distribution (in units of sqrt(2kT/m)) to bin[k * n]. */
static void count_speeds(const struct disks *d, double *bin, size_t n)
{
    const double unit = sqrt(2 * disks_temperature(d));
    for (size_t i = 0; i < d->count; ++i) {
        const double *v = d->disk[i].velocity;
        const double u = hypot(v[0], v[1]) / unit;
        if (u < 4)
            bin[(size_t)(u / width) * n] += 1 / ((double)d->count * width);
    }
}

int main(int argc, char *argv[])
{
    struct disks d;
    const size_t count = argc > 1 ? strtoul(argv[1], NULL, 10) : 250;
    const size_t n = argc > 2 ? strtoul(argv[2], NULL, 10) : 1000;
    const double a = argc > 3 ? atof(argv[3]) : 7.5;
    const double b = argc > 4 ? atof(argv[4]) : 5;
    if (count < 2 || n < 2 || !(a > 0 && b > 0)) {
        fprintf(stderr, "gas0: expected disks, samples, width, height\n");
        return 2;
    }
    double *p = calloc(BINS * n, sizeof *p), exact[BINS], Maxwell[BINS];
    struct speeds_law law = speeds_exact(2, count, false, false);
    speeds_bins(&law, width, BINS, exact);
    law = speeds_maxwell(2, false);
    speeds_bins(&law, width, BINS, Maxwell);
    if (!p || !begin(&d, count, a, b))
        return EXIT_FAILURE;
    for (size_t k = 0; k < n; ++k) {
        disks_run(&d, (double)k * Tc, UINT64_MAX);
        count_speeds(&d, p + k, n);
    }
    for (size_t bin = 0; bin < BINS; ++bin) {
        struct statistics_blocking blocks;
        double mean = 0;
        for (size_t k = 0; k < n; ++k)
            mean += p[bin * n + k] / (double)n;
        if (!statistics_blocking(n, p + bin * n, &blocks))
            return EXIT_FAILURE;
        printf("%.5f %.9g %.3g %.9g %.9g\n", (double)bin * width, mean,
               blocks.error, exact[bin], Maxwell[bin]);
    }
}
