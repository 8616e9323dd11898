/* What crosses the border of exercise 04a: see examiner/border.h. */
/* place: piston_slopes slope 2 */

#include "examiner/border.h"

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2]);

/* The arguments; the slopes follow. */
struct call {
    int f;
    double length, mass, gas;
    double energy[2], state[2];
};

static void move_arguments(struct call *c)
{
    border_ints(&c->f, 1);
    border_doubles(&c->length, 1);
    border_doubles(&c->mass, 1);
    border_doubles(&c->gas, 1);
    border_doubles(c->energy, 2);
    border_doubles(c->state, 2);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double energy[2] = {c.energy[0], c.energy[1]};
    const double state[2] = {c.state[0], c.state[1]};
    double *slope = border_place_doubles("slope", 2);
    piston_slopes(c.f, c.length, c.mass, c.gas, energy, state, slope);
    border_reply();
    border_doubles(slope, 2);
}

#else

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    struct call c = {
        f, length, mass, gas, {energy[0], energy[1]}, {state[0], state[1]}};
    border_call();
    move_arguments(&c);
    border_doubles(slope, 2);
    border_wait();
    border_doubles(slope, 2);
}

#endif
