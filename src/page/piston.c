/* Live figure of chapter 4: a piston between two gases, and its model. */
#include "line/bonkers.h"
#include "line/piston.h"
#include "page/page.h"

enum { MOST = 401 };
#define STEP 0.01 /* time step of the model, s */

/* The model treats the two gases as springs (line/piston.h). At the start
   it gets the energies and masses of the gases and the position and
   velocity of the piston. After that it runs by itself. */

/* Parameters: the kind of start; the number of movers; the mass ratio; the
   seed. */
double page_number[PAGE_NUMBERS];

static struct start start;
static struct bonkers beads;
static struct piston model;
static struct piston_state model_state;
static double model_time, seen[9 + 2 * (MOST + 2)];

/* Returns the kinetic energy of the movers from index `from` to `to` - 1,
   and adds their mass to *mass. */
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
    model_state = (struct piston_state){start.x[n], start.v[n]};
    model_time = 0;
}

/* Begins a run with the heap, the fastest engine for short intervals with
   many beads. */
bool page_begin(void)
{
    const struct start_request request = {
        .kind = (enum start_kind)page_number[0],
        .movers = (size_t)page_number[1],
        .ratio = page_number[2],
        .seed = (uint64_t)page_number[3]};
    size_t wrong;
    bonkers_free(&beads);
    start_free(&start);
    if (request.movers > MOST ||
        !start_allows(request.kind, request.movers) ||
        !start_fill(&start, &request) ||
        !bonkers_begin(&beads, &start, 1, BONKERS_HEAP, &wrong))
        return false;
    begin_model();
    return true;
}

/* Runs the beads; an event is a collision. The model follows in whole time
   steps. */
double page_run(double until, double events)
{
    const uint64_t before = beads.collisions;
    bonkers_run(&beads, until, before + (uint64_t)events);
    for (; model_time + STEP <= beads.now; model_time += STEP)
        if (!piston_step(&model, &model_state, STEP))
            break;
    return (double)(beads.collisions - before);
}

/* Returns the time and the numbers of collisions and bodies; the kinetic
   energies of the left gas, the right gas and the piston; in the model, the
   position of the piston and the energies of the left and the right gas;
   then all x and all v. */
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
    seen[6] = model_state.x;
    seen[7] = piston_gas_energy(&model.left, model_state.x);
    seen[8] = piston_gas_energy(&model.right, model.length - model_state.x);
    return seen;
}
