/* The remote calls of exercise 09b: see examiner/remote.h. */
/* output: binary_speeds v1 1 */
/* output: binary_speeds v2 1 */

#include "examiner/remote.h"

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
    remote_ints(&c->which, 1);
    remote_sizes(&c->n, 1);
    remote_doubles(c->number, 4);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const double *x = c.number;
    double *v1 = remote_output_doubles("v1", 1);
    double *v2 = remote_output_doubles("v2", 1);
    if (c.which == BINARY)
        binary_speeds(x[0], x[1], x[2], x[3], v1, v2);
    else
        *v1 = choreography_speed(x[0], c.n, x[1], x[2]);
    remote_reply();
    remote_doubles(v1, 1);
    remote_doubles(v2, 1);
}

#else

static void call(struct call *c, double *v1, double *v2)
{
    remote_call();
    move_arguments(c);
    remote_doubles(v1, 1);
    remote_doubles(v2, 1);
    remote_wait();
    remote_doubles(v1, 1);
    remote_doubles(v2, 1);
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
