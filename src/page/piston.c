/* From chapters/works/A-page.nw: edit there, then run make tangle. */
/* checksum 3166663845 of the lines below */
/* A piston between two gases of beads, and one between two springs. */
#include "line/bonkers.h"
#include "line/piston.h"
#include "page/page.h"

#include <math.h>

enum { MOST = 401 };
#define STEP 0.01 /* of the model, s */

/* The kind of start; how many movers; the mass ratio; the seed. */
double page_number[PAGE_NUMBERS];

static struct start start;
static struct bonkers beads;
static struct piston model;
static struct piston_state swing;
static double swung, seen[9 + 2 * (MOST + 2)];

static double kinetic(size_t from, size_t to, double *mass)
{
    double sum = 0;
    for (size_t i = from; i < to; ++i) {
        sum += start.mass[i] * start.v[i] * start.v[i] / 2;
        *mass += start.mass[i];
    }
    return sum;
}

static void begin_model(void)
{
    const size_t n = start.movers / 2;
    model = (struct piston){.mass = start.mass[n],
                            .length = start.wall[1] - start.wall[0]};
    model.left.length = start.x[n] - start.wall[0];
    model.right.length = start.wall[1] - start.x[n];
    model.left.energy = kinetic(0, n, &model.left.mass);
    model.right.energy = kinetic(n + 1, start.movers, &model.right.mass);
    swing = (struct piston_state){start.x[n], start.v[n]};
    swung = 0;
}

bool page_begin(void)
{
    const struct start_wish wish = {.kind = (enum start_kind)page_number[0],
                                    .movers = (size_t)page_number[1],
                                    .ratio = page_number[2],
                                    .seed = (uint64_t)page_number[3]};
    size_t wrong;
    bonkers_free(&beads);
    start_free(&start);
    if (wish.movers > MOST || !start_allows(wish.kind, wish.movers) ||
        !start_fill(&start, &wish) ||
        !bonkers_begin(&beads, &start, 1, BONKERS_HEAP, &wrong))
        return false;
    begin_model();
    return true;
}

double page_run(double until, double events)
{
    const uint64_t before = beads.collisions;
    bonkers_run(&beads, until, before + (uint64_t)events);
    for (; swung + STEP <= beads.now; swung += STEP)
        if (!piston_step(&model, &swing, STEP))
            break;
    return (double)(beads.collisions - before);
}

/* The time, collisions, bodies; kinetic energies of the left gas, the
   right one, the piston; the model's place; the energies that its gases
   have there; all x, all v. */
const double *page_look(void)
{
    const size_t bodies = beads.gaps + 1, middle = bodies / 2;
    double *x = seen + 9, *v = x + bodies;
    bonkers_state(&beads, x, v);
    for (size_t k = 0; k < 9; ++k)
        seen[k] = 0;
    seen[0] = beads.now;
    seen[1] = (double)beads.collisions;
    seen[2] = (double)bodies;
    for (size_t i = 1; i < beads.gaps; ++i) {
        const size_t part = i < middle ? 3 : i > middle ? 4 : 5;
        seen[part] += start.mass[i - 1] * v[i] * v[i] / 2;
    }
    seen[6] = swing.x;
    seen[7] = piston_gas_energy(&model.left, swing.x);
    seen[8] = piston_gas_energy(&model.right, model.length - swing.x);
    return seen;
}
