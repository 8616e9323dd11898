/* Live figure of chapter 2: beads on a wire, collision by collision. */
#include "line/bonkers.h"
#include "page/page.h"

#include <string.h>

enum { MOST = 16, WAVE = START_KINDS };

/* Parameters: the kind of start, or WAVE; the seed; the number of masses
   that follow; these masses (kg), which replace the first masses of the
   start. To change a mass, the script starts the run again and continues to
   the time already reached, so that the whole past is drawn again. */
double page_number[PAGE_NUMBERS];

static struct start start;
static struct bonkers beads;
static double seen[4 + 3 * (MOST + 2)];

/* Makes the start that the figure of world lines uses. The program bonkers
   has no such start, because the book describes it by a list of options. */
static bool start_wave(struct start *s)
{
    static const double mass[] = {9.3, 2.1, 5.2, 0.9, 3.4,
                                  1.2, 4.3, 0.8, 2.6, 1.4};
    static const double x[] = {0.5, 4.6, 5.3, 6.2,  6.9,
                               7.8, 8.5, 9.4, 10.2, 11.1};
    if (!start_create(s, sizeof mass / sizeof mass[0]))
        return false;
    memcpy(s->mass, mass, sizeof mass);
    memcpy(s->x, x, sizeof x);
    s->v[0] = 2;
    s->wall[1] = 12;
    return true;
}

static bool choose_start(struct start *s)
{
    const double kind = page_number[0];
    const struct start_request request = {.kind = (enum start_kind)kind,
                                          .seed = (uint64_t)page_number[1]};
    if (!(kind == WAVE ? start_wave(s) : start_fill(s, &request)))
        return false;
    for (size_t i = 0; i < (size_t)page_number[2] && i < s->movers; ++i)
        s->mass[i] = page_number[3 + i];
    return s->movers <= MOST;
}

bool page_begin(void)
{
    size_t wrong;
    bonkers_free(&beads);
    start_free(&start);
    return choose_start(&start) &&
           bonkers_begin(&beads, &start, 1, BONKERS_AUTO, &wrong) &&
           wrong == beads.gaps;
}

/* Runs the beads; an event is a collision. */
double page_run(double until, double events)
{
    const uint64_t before = beads.collisions;
    bonkers_run(&beads, until, before + (uint64_t)events);
    return (double)(beads.collisions - before);
}

/* Returns the time, the number of collisions, the energy and the number of
   bodies, then all x, all v and all masses. The first and last bodies are
   walls. */
const double *page_look(void)
{
    const size_t bodies = beads.gaps + 1;
    double *x = seen + 4, *v = x + bodies, *mass = v + bodies;
    bonkers_state(&beads, x, v);
    seen[0] = beads.now;
    seen[1] = (double)beads.collisions;
    seen[2] = bonkers_energy(&beads);
    seen[3] = (double)bodies;
    for (size_t i = 0; i < start.movers; ++i)
        mass[i + 1] = start.mass[i];
    return seen;
}
