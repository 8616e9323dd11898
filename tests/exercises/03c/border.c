/* What crosses the border of exercise 03c: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"

double velocity_below(int n, double u);

static void move_arguments(int *n, double *u)
{
    border_ints(n, 1);
    border_doubles(u, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    int n;
    double u;
    move_arguments(&n, &u);
    double below = velocity_below(n, u);
    border_reply();
    border_doubles(&below, 1);
}

#else

double velocity_below(int n, double u)
{
    double below;
    border_call();
    move_arguments(&n, &u);
    border_wait();
    border_doubles(&below, 1);
    return below;
}

#endif
