/* What crosses the border of exercise 10c: see examiner/border.h. With the
   places for the frequencies comes one behind them: the suite looks there.
 */
/* place: membrane_modes omega (g->nx-2)*(g->ny-2) suite */

#include "examiner/border.h"

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
    border_ints(&g->nx, 1);
    border_ints(&g->ny, 1);
    border_doubles(&g->mass, 1);
    border_doubles(&g->stiffness, 1);
    border_doubles(&g->dx, 1);
    border_doubles(&g->dy, 1);
    border_doubles(&g->restx, 1);
    border_doubles(&g->resty, 1);
}

static size_t places(const struct grid *g)
{
    return (size_t)(g->nx - 2) * (size_t)(g->ny - 2) + 1;
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct grid g;
    move_grid(&g);
    const size_t count = places(&g);
    double *omega = border_place_doubles("omega", count);
    double step = membrane_modes(&g, omega);
    border_reply();
    border_doubles(&step, 1);
    border_doubles(omega, count);
}

#else

double membrane_modes(const struct grid *g, double omega[])
{
    struct grid copy = *g;
    double step;
    border_call();
    move_grid(&copy);
    border_doubles(omega, places(g));
    border_wait();
    border_doubles(&step, 1);
    border_doubles(omega, places(g));
    return step;
}

#endif
