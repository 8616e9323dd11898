/* What crosses the border of exercise 09a: see examiner/border.h. With the
   potentials comes the place behind them: the suite has put something
   there. */
/* place: potential_energy potential n */

#include "examiner/border.h"
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
    border_sizes(&c->n, 1);
    border_doubles(&c->k2, 1);
    border_doubles(&c->softening, 1);
}

#ifdef BORDER_INSIDE

static double *take_doubles(size_t count)
{
    double *x = border_array(count, sizeof *x);
    border_doubles(x, count);
    return x;
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *mass = take_doubles(c.n), *x = take_doubles(3 * c.n);
    double *potential = border_place_doubles("potential", c.n + 1);
    double energy =
        potential_energy(c.n, mass, x, c.k2, c.softening, potential);
    border_reply();
    border_doubles(&energy, 1);
    border_doubles(potential, c.n + 1);
    free(mass);
    free(x);
}

#else

static void give_doubles(const double x[], size_t count)
{
    double *copy = border_array(count, sizeof *copy);
    memcpy(copy, x, count * sizeof *copy);
    border_doubles(copy, count);
    free(copy);
}

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    struct call c = {n, k2, softening};
    double energy;
    border_call();
    move_arguments(&c);
    give_doubles(mass, n);
    give_doubles(x, 3 * n);
    border_doubles(potential, n + 1);
    border_wait();
    border_doubles(&energy, 1);
    border_doubles(potential, n + 1);
    return energy;
}

#endif
