/* The remote calls of exercise 04a: see examiner/remote.h. */
/* output: piston_slopes slope 2 */

#include "examiner/remote.h"

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
    remote_ints(&c->f, 1);
    remote_doubles(&c->length, 1);
    remote_doubles(&c->mass, 1);
    remote_doubles(&c->gas, 1);
    remote_doubles(c->energy, 2);
    remote_doubles(c->state, 2);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const double energy[2] = {c.energy[0], c.energy[1]};
    const double state[2] = {c.state[0], c.state[1]};
    double *slope = remote_output_doubles("slope", 2);
    piston_slopes(c.f, c.length, c.mass, c.gas, energy, state, slope);
    remote_reply();
    remote_doubles(slope, 2);
}

#else

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    struct call c = {
        f, length, mass, gas, {energy[0], energy[1]}, {state[0], state[1]}};
    remote_call();
    move_arguments(&c);
    remote_doubles(slope, 2);
    remote_wait();
    remote_doubles(slope, 2);
}

#endif
