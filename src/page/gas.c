/* Live figure of chapter 7: a gas of disks that all start at one speed. */
#include "box/cells.h"
#include "box/disks.h"
#include "box/speeds.h"
#include "page/page.h"

#include <math.h>

enum { MOST = 2000, BINS = 30 }; /* disks; bins of u = v sqrt(m/(2kT)) */
#define WIDTH 0.1                /* width of a bin, in u */

/* Parameters: the number of disks; the fraction of the box that they fill;
   the seed; 1 for a periodic box, 0 for walls. The sides of the box are 7.5
   m and 5 m. */
double page_number[PAGE_NUMBERS];

static struct disks gas;
static struct cells cells;
static bool fast; /* whether cells_run is used instead of disks_run */
static double law_of_bin[BINS];
static double seen[9 + 2 * BINS + 3 * MOST];

/* Places the disks on a lattice. This needs no random numbers, so the first
   random numbers give the directions of the velocities, as in the program
   disks. */
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

/* Starts the gas. The line in the histogram is the law for this number of
   disks, (7.3, eq:speed-law), not Maxwell's law. The difference is
   invisible for a thousand disks and visible for ten. Cells are not used if
   a few large disks leave no space for three cells along an axis. */
bool page_begin(void)
{
    const size_t count = (size_t)page_number[0];
    const bool at_rest = page_number[3] != 0;
    struct random r;
    cells_free(&cells);
    disks_free(&gas);
    if (count > MOST || !place_gas(&gas, count))
        return false;
    random_seed(&r, (uint64_t)page_number[2]);
    disks_set_speed(&gas, 1, &r);
    const struct speeds_law law = speeds_exact(2, count, at_rest, false);
    speeds_bins(&law, WIDTH, BINS, law_of_bin);
    fast = cells_suit(&gas);
    return fast ? cells_create(&cells, &gas) : disks_plan(&gas);
}

/* Runs the gas; an event is a collision. */
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

/* Adds the histogram of u = v sqrt(m/(2kT)) to density[]. Returns
   <v^4> / <v^2>^2, which is 1 at the start and 2 in equilibrium. */
static double count_speeds(double density[BINS])
{
    const double N = (double)gas.count;
    const double scale = 1 / (2 * disks_temperature(&gas));
    double two = 0, four = 0;
    for (size_t i = 0; i < gas.count; ++i) {
        const double *v = gas.disk[i].velocity;
        const double u2 = scale * (v[0] * v[0] + v[1] * v[1]);
        const size_t bin = (size_t)(sqrt(u2) / WIDTH);
        if (bin < BINS)
            density[bin] += 1 / (N * WIDTH);
        two += u2 / N;
        four += u2 * u2 / N;
    }
    return four / (two * two);
}

/* Returns the time, the numbers of collisions between disks and with walls,
   kT, the energy, <v^4>/<v^2>^2, the number of disks, their radius and the
   number of bins; then the density in each bin, and the law in each bin;
   then, for each disk, x and y, folded back into a periodic box, and the
   speed. */
const double *page_look(void)
{
    double *density = seen + 9, *law = density + BINS, *next = law + BINS;
    for (size_t b = 0; b < BINS; ++b) {
        density[b] = 0;
        law[b] = law_of_bin[b];
    }
    seen[0] = gas.now;
    seen[1] = (double)gas.collisions;
    seen[2] = (double)gas.wall_collisions;
    seen[3] = disks_temperature(&gas);
    seen[4] = disks_energy(&gas);
    seen[5] = count_speeds(density);
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
