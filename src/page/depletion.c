/* Live figure of chapter 6: the force between two large disks. */
#include "box/means.h"
#include "box/sampling.h"
#include "page/page.h"

#include <math.h>

enum { LARGE = 2, MOST = 400 };
#define SIDE 5.0   /* side of the periodic box, m */
#define SHELL 0.05 /* width of the contact shell / small radius */

/* Parameters: the number of small disks; their radius, m; the step of the
   large disks (in m), or 0 to keep them in place; the seed; the x and y
   (in m) to which page_make moves a large disk. The small disks may
   overlap each other. The radius of the large disks is 1 m. */
double page_number[PAGE_NUMBERS];

static struct sampling box;
static struct random dice;
static struct means force;
static double tries, seen[10 + 2 * (LARGE + MOST)];

/* Begins a run as the program sample does. */
bool page_begin(void)
{
    const double sides[] = {SIDE, SIDE};
    sampling_free(&box);
    means_free(&force);
    tries = 0;
    if (page_number[0] > MOST ||
        !sampling_create(&box, 2, DISKS_PERIODIC, sides, LARGE, 1,
                         (size_t)page_number[0], page_number[1]) ||
        !means_create(&force, 1))
        return false;
    random_seed(&dice, (uint64_t)page_number[3]);
    return sampling_start(&box, &dice);
}

/* Returns the gap (in m) between disks i and j, and sets `apart` to the
   vector from i to j. */
static double gap(size_t i, size_t j, double apart[])
{
    const struct disk *a = &box.disks.disk[i], *b = &box.disks.disk[j];
    disks_separation(&box.disks, a->position, b->position, apart);
    return sqrt(apart[0] * apart[0] + apart[1] * apart[1]) - a->radius -
           b->radius;
}

/* Moves each small disk that overlaps a large disk to random places until
   it fits. */
static void scatter(void)
{
    double apart[DISKS_AXES];
    for (size_t i = LARGE; i < box.disks.count; ++i)
        while (gap(0, i, apart) < 0 || gap(1, i, apart) < 0)
            for (size_t k = 0; k < 2; ++k)
                box.disks.disk[i].position[k] =
                    random_between(&dice, 0, SIDE);
}

/* Moves large disk `which` to the position of the mouse. Returns false if
   the other large disk is in the way. Discards the force measured so far,
   because it was measured at another distance. */
bool page_make(double which)
{
    struct disk *hand = &box.disks.disk[(size_t)which];
    double apart[DISKS_AXES], old[2];
    for (size_t k = 0; k < 2; ++k) {
        old[k] = hand->position[k];
        hand->position[k] = page_number[4 + k];
    }
    disks_fold(&box.disks, hand->position);
    const bool fits = gap(0, 1, apart) >= 0;
    for (size_t k = 0; !fits && k < 2; ++k)
        hand->position[k] = old[k];
    if (!fits)
        return false;
    scatter();
    means_free(&force);
    return means_create(&force, 1);
}

/* Returns the force between the large disks in units of kT per metre,
   negative if it pushes them together. The pressure of an ideal gas on a
   surface is n kT, where n is the density at the surface. So each small
   disk within a shell of width d around a large disk pushes it with kT/d
   along the line between their centres. Only the component along the line
   between the large disks counts. At contact the centres are `reach`
   apart. If they are s apart, the shell is larger by the factor s / reach,
   so the push is multiplied by reach / s. */
static double sample_force(void)
{
    double line[DISKS_AXES], apart[DISKS_AXES], sum = 0;
    const double width = SHELL * page_number[1];
    const double r = gap(0, 1, line) + 2;
    for (size_t large = 0; large < LARGE; ++large)
        for (size_t i = LARGE; i < box.disks.count; ++i) {
            const double distance = gap(large, i, apart);
            const double reach = 1 + page_number[1], s = distance + reach;
            const double along = apart[0] * line[0] + apart[1] * line[1];
            if (distance < width)
                sum += (large == 0 ? 1 : -1) * along / (r * s) * reach / s;
        }
    return sum / (2 * width);
}

/* Runs the Markov chain; an event is an attempted move. Samples the force
   once in N attempts, where N is the number of disks. */
double page_run(double until, double events)
{
    const double before = tries, all = (double)box.disks.count;
    while (tries + 1 <= until && tries - before < events) {
        sampling_try(&box, page_number[2], &dice);
        if (fmod(++tries, all) != 0)
            continue;
        means_add(&force, 0, sample_force());
        means_next(&force);
    }
    return tries - before;
}

/* Returns the exact force at the distance r, in kT per metre. It is the
   length of the common chord of the two excluded zones, times the density
   of small disks in the area left to them. This is the derivative of (6.14,
   eq:lens). */
static double exact_force(double r)
{
    const double pi = 3.14159265358979324, reach = 1 + page_number[1];
    const double lens = sampling_overlap(2, reach, r);
    const double room = SIDE * SIDE - 2 * pi * reach * reach + lens;
    const double half = reach * reach - r * r / 4;
    return half > 0 ? -page_number[0] / room * 2 * sqrt(half) : 0;
}

/* Returns the number of tries, the number of disks, the distance of the
   large disks, the force, its error, the exact force and the number of
   samples; then x and y of each disk. */
const double *page_look(void)
{
    double apart[DISKS_AXES], *next = seen + 10;
    const double r = gap(0, 1, apart) + 2;
    seen[0] = tries;
    seen[1] = (double)box.disks.count;
    seen[2] = r;
    seen[3] = means_mean(&force, 0);
    seen[4] = means_error(&force, 0);
    seen[5] = exact_force(r);
    seen[6] = (double)(force.blocks * force.length + force.filled);
    for (size_t i = 0; i < box.disks.count; ++i)
        for (size_t k = 0; k < 2; ++k)
            *next++ = box.disks.disk[i].position[k];
    return seen;
}

/* Returns the exact force at 100 distances from contact to `most`, for the
   line in the plot. */
const double *page_array(double most)
{
    static double line[100];
    for (int k = 0; k < 100; ++k)
        line[k] = exact_force(2 + (most - 2) * k / 99);
    return line;
}
