/* What crosses the border of exercise 01e: see examiner/border.h. The
   function that is tried stays with the judge; the box asks for it,
   collision by collision. */
/* place: none */

#include "examiner/border.h"

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2));

#ifdef BORDER_INSIDE

static void collide(double m1, double m2, double *v1, double *v2)
{
    border_ask(0);
    border_doubles(&m1, 1);
    border_doubles(&m2, 1);
    border_doubles(v1, 1);
    border_doubles(v2, 1);
    border_hear();
    border_doubles(v1, 1);
    border_doubles(v2, 1);
}

void border_answer(void)
{
    bool right = passes(collide);
    border_reply();
    border_bools(&right, 1);
}

#else

static void (*tried)(double m1, double m2, double *v1, double *v2);

void border_heed(int which)
{
    double m1, m2, v1, v2;
    (void)which;
    border_doubles(&m1, 1);
    border_doubles(&m2, 1);
    border_doubles(&v1, 1);
    border_doubles(&v2, 1);
    tried(m1, m2, &v1, &v2);
    border_tell();
    border_doubles(&v1, 1);
    border_doubles(&v2, 1);
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    bool right;
    tried = collide;
    border_anew();
    border_call();
    border_wait();
    border_bools(&right, 1);
    return right;
}

#endif
