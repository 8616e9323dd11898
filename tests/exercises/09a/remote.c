/* The remote calls of exercise 09a: see examiner/remote.h. With the
   potentials comes the place behind them: the suite has put something
   there. */
/* output: potential_energy potential n */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[]);

/* The arguments but for the arrays. */
struct call {
    size_t n;
    double k2, softening;
};

static void move_arguments(struct call *c)
{
    remote_sizes(&c->n, 1);
    remote_doubles(&c->k2, 1);
    remote_doubles(&c->softening, 1);
}

#ifdef REMOTE_SERVER

static double *take_doubles(size_t count)
{
    double *x = remote_array(count, sizeof *x);
    remote_doubles(x, count);
    return x;
}

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *mass = take_doubles(c.n), *x = take_doubles(3 * c.n);
    double *potential = remote_output_doubles("potential", c.n + 1);
    double energy =
        potential_energy(c.n, mass, x, c.k2, c.softening, potential);
    remote_reply();
    remote_doubles(&energy, 1);
    remote_doubles(potential, c.n + 1);
    free(mass);
    free(x);
}

#else

static void give_doubles(const double x[], size_t count)
{
    double *copy = remote_array(count, sizeof *copy);
    memcpy(copy, x, count * sizeof *copy);
    remote_doubles(copy, count);
    free(copy);
}

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    struct call c = {n, k2, softening};
    double energy;
    remote_call();
    move_arguments(&c);
    give_doubles(mass, n);
    give_doubles(x, 3 * n);
    remote_doubles(potential, n + 1);
    remote_wait();
    remote_doubles(&energy, 1);
    remote_doubles(potential, n + 1);
    return energy;
}

#endif
