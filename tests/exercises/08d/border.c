/* What crosses the border of exercise 08d: see examiner/border.h. The
   method stays outside and its steps are asked for. */
/* place: none */

#include "examiner/border.h"

void step(double h, double y[2]);
double stability_limit(double most);

#ifdef BORDER_INSIDE

void step(double h, double y[2])
{
    border_ask(0);
    border_doubles(&h, 1);
    border_doubles(y, 2);
    border_hear();
    border_doubles(y, 2);
}

void border_answer(void)
{
    double most, limit;
    border_doubles(&most, 1);
    limit = stability_limit(most);
    border_reply();
    border_doubles(&limit, 1);
}

#else

void border_heed(int which)
{
    double h, y[2];
    (void)which;
    border_doubles(&h, 1);
    border_doubles(y, 2);
    step(h, y);
    border_tell();
    border_doubles(y, 2);
}

double stability_limit(double most)
{
    double limit;
    border_call();
    border_doubles(&most, 1);
    border_wait();
    border_doubles(&limit, 1);
    return limit;
}

#endif
