/* The remote calls of exercise 10c: see examiner/remote.h. With the
   places for the frequencies comes one behind them: the suite looks there.
 */
/* output: membrane_modes omega (g->nx-2)*(g->ny-2) suite */

#include "examiner/remote.h"

struct grid {
    int nx, ny;
    double mass;
    double stiffness;
    double dx, dy;
    double restx, resty;
};

double membrane_modes(const struct grid *g, double omega[]);

static void move_grid(struct grid *g)
{
    remote_ints(&g->nx, 1);
    remote_ints(&g->ny, 1);
    remote_doubles(&g->mass, 1);
    remote_doubles(&g->stiffness, 1);
    remote_doubles(&g->dx, 1);
    remote_doubles(&g->dy, 1);
    remote_doubles(&g->restx, 1);
    remote_doubles(&g->resty, 1);
}

static size_t places(const struct grid *g)
{
    return (size_t)(g->nx - 2) * (size_t)(g->ny - 2) + 1;
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct grid g;
    move_grid(&g);
    const size_t count = places(&g);
    double *omega = remote_output_doubles("omega", count);
    double step = membrane_modes(&g, omega);
    remote_reply();
    remote_doubles(&step, 1);
    remote_doubles(omega, count);
}

#else

double membrane_modes(const struct grid *g, double omega[])
{
    struct grid copy = *g;
    double step;
    remote_call();
    move_grid(&copy);
    remote_doubles(omega, places(g));
    remote_wait();
    remote_doubles(&step, 1);
    remote_doubles(omega, places(g));
    return step;
}

#endif
