/* From chapters/works/A-page.nw: edit there, then run make tangle. */
/* checksum 2009912413 of the lines below */
/* A gas of disks that all begin with one speed. */
#include "box/cells.h"
#include "box/disks.h"
#include "box/speeds.h"
#include "page/page.h"

#include <math.h>

enum { MOST = 2000, BINS = 30 }; /* disks; bins of u = v sqrt(m/(2kT)) */
#define WIDTH 0.1                /* of a bin */

/* How many, the share of the box they fill, the seed, 1: periodic. */
double page_number[PAGE_NUMBERS];

static struct disks gas;
static struct cells cells;
static bool fast; /* by cells */
static double density[BINS];
static double seen[9 + 2 * BINS + 3 * MOST];

static bool place_gas(struct disks *d, size_t count)
{
    const double pi = 3.14159265358979324;
    if (!disks_create(d, 2, count))
        return false;
    d->boundary = page_number[3] != 0 ? DISKS_PERIODIC : DISKS_WALLS;
    d->box[0] = 7.5;
    d->box[1] = 5;
    const double room = page_number[1] * d->box[0] * d->box[1];
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = sqrt(room / pi / (double)count);
    return disks_place_lattice(d);
}

bool page_begin(void)
{
    const size_t count = (size_t)page_number[0];
    const bool resting = page_number[3] != 0;
    struct random r;
    cells_free(&cells);
    disks_free(&gas);
    if (count > MOST || !place_gas(&gas, count))
        return false;
    random_seed(&r, (uint64_t)page_number[2]);
    disks_set_speed(&gas, 1, &r);
    const struct speeds_law law = speeds_exact(2, count, resting, false);
    speeds_bins(&law, WIDTH, BINS, density);
    fast = cells_suit(&gas);
    return fast ? cells_create(&cells, &gas) : disks_plan(&gas);
}

double page_run(double until, double events)
{
    const uint64_t before = gas.collisions;
    const uint64_t most = before + (uint64_t)events;
    if (fast)
        cells_run(&cells, until, most);
    else
        disks_run(&gas, until, most);
    return (double)(gas.collisions - before);
}

static double count_speeds(double share[BINS])
{
    const double N = (double)gas.count;
    const double scale = 1 / (2 * disks_temperature(&gas));
    double two = 0, four = 0;
    for (size_t i = 0; i < gas.count; ++i) {
        const double *v = gas.disk[i].velocity;
        const double u2 = scale * (v[0] * v[0] + v[1] * v[1]);
        const size_t bin = (size_t)(sqrt(u2) / WIDTH);
        if (bin < BINS)
            share[bin] += 1 / (N * WIDTH);
        two += u2 / N;
        four += u2 * u2 / N;
    }
    return four / (two * two);
}

/* The time, collisions, with walls, kT, energy, the ratio, how many, the
   radius, bins; their shares, the law; x, y, v. */
const double *page_look(void)
{
    double *share = seen + 9, *law = share + BINS, *next = law + BINS;
    for (size_t b = 0; b < BINS; ++b) {
        share[b] = 0;
        law[b] = density[b];
    }
    seen[0] = gas.now;
    seen[1] = (double)gas.collisions;
    seen[2] = (double)gas.wall_collisions;
    seen[3] = disks_temperature(&gas);
    seen[4] = disks_energy(&gas);
    seen[5] = count_speeds(share);
    seen[6] = (double)gas.count;
    seen[7] = gas.disk[0].radius;
    seen[8] = BINS;
    for (size_t i = 0; i < gas.count; ++i, next += 3) {
        double place[DISKS_AXES];
        const double *v = gas.disk[i].velocity;
        disks_position(&gas, i, place);
        disks_fold(&gas, place);
        next[0] = place[0];
        next[1] = place[1];
        next[2] = sqrt(v[0] * v[0] + v[1] * v[1]);
    }
    return seen;
}
