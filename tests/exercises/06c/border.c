/* What crosses the border of exercise 06c: see examiner/border.h. */
/* place: depletion overlap 1 */

#include "examiner/border.h"

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap);

/* The arguments; the overlap follows. */
struct call {
    int dimensions;
    double R1, R2, small, density, r;
};

static void move_arguments(struct call *c)
{
    border_ints(&c->dimensions, 1);
    border_doubles(&c->R1, 1);
    border_doubles(&c->R2, 1);
    border_doubles(&c->small, 1);
    border_doubles(&c->density, 1);
    border_doubles(&c->r, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *overlap = border_place_doubles("overlap", 1);
    double potential = depletion(c.dimensions, c.R1, c.R2, c.small,
                                 c.density, c.r, overlap);
    border_reply();
    border_doubles(&potential, 1);
    border_doubles(overlap, 1);
}

#else

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    struct call c = {dimensions, R1, R2, small, density, r};
    double potential;
    border_call();
    move_arguments(&c);
    border_doubles(overlap, 1);
    border_wait();
    border_doubles(&potential, 1);
    border_doubles(overlap, 1);
    return potential;
}

#endif
