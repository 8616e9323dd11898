/* From chapters/works/A-page.nw: edit there, then run make tangle. */
/* checksum 2377032995 of the lines below */
/* Four disks, sampled by a clock that is right, or by the article's. */
#include "box/loop.h"
#include "box/sampling.h"
#include "page/page.h"

#include <math.h>

enum { DISKS = 4, FIRST = 15, BINS = 35 }; /* hundredths from a wall */

/* The slip of the article's loop, 0 for ours; the tick, s; the seed. */
double page_number[PAGE_NUMBERS];

static struct loop loop;
static struct sampling_means density;
static double every, overlap, records;
static double seen[8 + 2 * DISKS + 2 * BINS];

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
    sampling_means_free(&density);
    loop = (struct loop){.slip = page_number[0]};
    every = page_number[1];
    overlap = records = 0;
    if (!begin_disks(&loop.d) || !sampling_means_create(&density, BINS))
        return false;
    loop.next = disks_next(&loop.d);
    return true;
}

static void sample(void)
{
    for (size_t i = 0; i < DISKS; ++i) {
        double place[DISKS_AXES];
        disks_position(&loop.d, i, place);
        for (size_t k = 0; k < 2; ++k) {
            const double off = fmin(place[k], 1 - place[k]);
            const double bin = floor(100 * off + 1e-9) - FIRST;
            if (bin >= 0 && bin < BINS)
                sampling_means_add(&density, (size_t)bin, 100.0 / 16);
        }
    }
    sampling_means_next(&density);
    overlap = fmax(overlap, loop_overlap(&loop));
    ++records;
}

double page_run(double until, double events)
{
    const double before = records;
    while (records - before < events) {
        const double tick =
            loop.slip == 0 ? (records + 1) * every : loop.t + every;
        if (tick > until)
            break;
        if (loop.slip == 0)
            loop_go_to(&loop, tick);
        else
            loop_turn(&loop, every);
        sample();
    }
    return records - before;
}

/* The time, records, collisions of disks and with walls, P V/(N kT), the
   deepest overlap, the energy; x and y; density and error. */
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
        *next++ = sampling_means_mean(&density, b);
        *next++ = sampling_means_error(&density, b);
    }
    return seen;
}
