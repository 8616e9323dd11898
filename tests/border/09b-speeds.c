/* What crosses the border of exercise 09b: see examiner/border.h. */

#include "examiner/border.h"

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2);
double choreography_speed(double k2, size_t n, double mass, double radius);

/* Which function is called, and its arguments: k2, m1, m2, d, and the
   places for the speeds as they are before; or k2, mass, radius. */
enum { BINARY, CHOREOGRAPHY };

struct call {
    int which;
    size_t n;
    double number[6];
};

static void move_arguments(struct call *c)
{
    border_ints(&c->which, 1);
    border_sizes(&c->n, 1);
    border_doubles(c->number, 6);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *x = c.number;
    if (c.which == BINARY)
        binary_speeds(x[0], x[1], x[2], x[3], &x[4], &x[5]);
    else
        x[4] = choreography_speed(x[0], c.n, x[1], x[2]);
    border_reply();
    border_doubles(&x[4], 2);
}

#else

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    struct call c = {BINARY, 0, {k2, m1, m2, d, *v1, *v2}};
    border_call();
    move_arguments(&c);
    border_wait();
    border_doubles(&c.number[4], 2);
    *v1 = c.number[4];
    *v2 = c.number[5];
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    struct call c = {CHOREOGRAPHY, n, {k2, mass, radius}};
    border_call();
    move_arguments(&c);
    border_wait();
    border_doubles(&c.number[4], 2);
    return c.number[4];
}

#endif
