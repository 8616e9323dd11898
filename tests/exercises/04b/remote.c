/* The remote calls of exercise 04b: see examiner/remote.h. A sort is
   four numbers. */
/* output: rain_force friction 1 */

#include "examiner/remote.h"
#include <stdlib.h>

struct sort {
    double m, v, left, right;
};

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction);

/* The numbers among the arguments; the sorts and the place follow. */
struct call {
    size_t n;
    double im, V;
};

static void move_arguments(struct call *c)
{
    remote_sizes(&c->n, 1);
    remote_doubles(&c->im, 1);
    remote_doubles(&c->V, 1);
}

static void move_sorts(struct sort rain[], size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        remote_doubles(&rain[i].m, 1);
        remote_doubles(&rain[i].v, 1);
        remote_doubles(&rain[i].left, 1);
        remote_doubles(&rain[i].right, 1);
    }
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    struct sort *rain = remote_array(c.n, sizeof *rain);
    move_sorts(rain, c.n);
    double *friction = remote_output_doubles("friction", 1);
    double force = rain_force(c.n, rain, c.im, c.V, friction);
    remote_reply();
    remote_doubles(&force, 1);
    remote_doubles(friction, 1);
    free(rain);
}

#else

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    struct call c = {n, im, V};
    double force;
    remote_call();
    move_arguments(&c);
    move_sorts((struct sort *)rain, n); /* which only reads on this side */
    remote_doubles(friction, 1);
    remote_wait();
    remote_doubles(&force, 1);
    remote_doubles(friction, 1);
    return force;
}

#endif
