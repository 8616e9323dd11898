/* Live figure of chapter 5: four disks, a right clock and a wrong one. */
#include "box/loop.h"
#include "box/means.h"
#include "box/sampling.h"
#include "page/page.h"

#include <math.h>

/* A bin is a hundredth of the box wide. The bins extend from one radius to
   the middle of the box; FIRST is the radius in bins. */
enum { DISKS = 4, FIRST = 15, BINS = 35 };

/* Parameters: the `offset` of the article's loop (box/loop.h), or 0 for
   the correct loop; the tick, s; the seed. The wrong loops of the
   hard-disk article look right, even in films. So the script shows what
   reveals the error: the density of positions compared with direct
   sampling, the pressure, and how deeply the disks overlap. */
double page_number[PAGE_NUMBERS];

static struct loop loop;
static struct means density;
static double tick, overlap, records;
static double seen[8 + 2 * DISKS + 2 * BINS];

/* Places four disks on a lattice and gives them velocities, as the programs
   disks and disks-studies do. */
static bool begin_disks(struct disks *d)
{
    struct random r;
    if (!disks_create(d, 2, DISKS))
        return false;
    d->box[0] = d->box[1] = 1;
    for (size_t i = 0; i < DISKS; ++i)
        d->disk[i].radius = 0.15;
    random_seed(&r, (uint64_t)page_number[2]);
    disks_set_speed(d, 1, &r);
    return disks_place_lattice(d);
}

bool page_begin(void)
{
    disks_free(&loop.d);
    means_free(&density);
    loop = (struct loop){.offset = page_number[0]};
    tick = page_number[1];
    overlap = records = 0;
    if (!begin_disks(&loop.d) || !means_create(&density, BINS))
        return false;
    loop.next = disks_next(&loop.d);
    return true;
}

/* Adds a record: counts the distances of all disks from the nearer wall,
   along both axes. Each bin covers two hundredths of the box, one at each
   wall. So each of the 8 distances counts 1 / (8 * 0.02) = 100 / 16. A disk
   that touches a wall is at the edge of a bin; without the 1e-9 a rounding
   error would decide which bin counts it. The means compare blocks of
   records, so their errors allow for correlations between neighbouring
   records. */
static void sample(void)
{
    for (size_t i = 0; i < DISKS; ++i) {
        double place[DISKS_AXES];
        disks_position(&loop.d, i, place);
        for (size_t k = 0; k < 2; ++k) {
            const double distance = fmin(place[k], 1 - place[k]);
            const double bin = floor(100 * distance + 1e-9) - FIRST;
            if (bin >= 0 && bin < BINS)
                means_add(&density, (size_t)bin, 100.0 / 16);
        }
    }
    means_next(&density);
    overlap = fmax(overlap, loop_overlap(&loop));
    ++records;
}

/* Runs the disks; an event is a record. The article's loop also makes a
   record at each event of the disks, and counts its next tick from that
   time. The right loop makes records only at multiples of the tick. */
double page_run(double until, double events)
{
    const double before = records;
    while (records - before < events) {
        const double next =
            loop.offset == 0 ? (records + 1) * tick : loop.t + tick;
        if (next > until)
            break;
        if (loop.offset == 0)
            loop_go_to(&loop, next);
        else
            loop_turn(&loop, tick);
        sample();
    }
    return records - before;
}

/* Returns the time, the number of records, the numbers of collisions
   between disks and with walls, P V/(N kT), the deepest overlap and the
   energy; then x and y of each disk; then the density and its error in each
   bin. */
const double *page_look(void)
{
    const struct disks *d = &loop.d;
    const double push = d->impulse[0] + d->impulse[1];
    const double NkT = DISKS * disks_temperature(d);
    double *next = seen, place[DISKS_AXES];
    *next++ = loop.t;
    *next++ = records;
    *next++ = (double)d->collisions;
    *next++ = (double)d->wall_collisions;
    *next++ = loop.t > 0 ? push / (4 * loop.t * NkT) : 0;
    *next++ = overlap;
    *next++ = disks_energy(d);
    for (size_t i = 0; i < DISKS; ++i, next += 2) {
        disks_position(d, i, place);
        next[0] = place[0];
        next[1] = place[1];
    }
    for (size_t b = 0; b < BINS; ++b) {
        *next++ = means_mean(&density, b);
        *next++ = means_error(&density, b);
    }
    return seen;
}
