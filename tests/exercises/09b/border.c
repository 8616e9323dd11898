/* What crosses the border of exercise 09b: see examiner/border.h. */
/* place: binary_speeds v1 1 */
/* place: binary_speeds v2 1 */

#include "examiner/border.h"

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2);
double choreography_speed(double k2, size_t n, double mass, double radius);

/* Which function is called, and its arguments: k2, m1, m2, d; or k2, mass,
   radius. The two speeds, or what stands in their place, follow. */
enum { BINARY, CHOREOGRAPHY };

struct call {
    int which;
    size_t n;
    double number[4];
};

static void move_arguments(struct call *c)
{
    border_ints(&c->which, 1);
    border_sizes(&c->n, 1);
    border_doubles(c->number, 4);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double *x = c.number;
    double *v1 = border_place_doubles("v1", 1);
    double *v2 = border_place_doubles("v2", 1);
    if (c.which == BINARY)
        binary_speeds(x[0], x[1], x[2], x[3], v1, v2);
    else
        *v1 = choreography_speed(x[0], c.n, x[1], x[2]);
    border_reply();
    border_doubles(v1, 1);
    border_doubles(v2, 1);
}

#else

static void call(struct call *c, double *v1, double *v2)
{
    border_call();
    move_arguments(c);
    border_doubles(v1, 1);
    border_doubles(v2, 1);
    border_wait();
    border_doubles(v1, 1);
    border_doubles(v2, 1);
}

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    struct call c = {BINARY, 0, {k2, m1, m2, d}};
    call(&c, v1, v2);
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    struct call c = {CHOREOGRAPHY, n, {k2, mass, radius}};
    double speed = 0.0, none = 0.0;
    call(&c, &speed, &none);
    return speed;
}

#endif
