/* What crosses the border of exercise 04b: see examiner/border.h. A sort is
   four numbers. */
/* place: rain_force friction 1 */

#include "examiner/border.h"
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
    border_sizes(&c->n, 1);
    border_doubles(&c->im, 1);
    border_doubles(&c->V, 1);
}

static void move_sorts(struct sort rain[], size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        border_doubles(&rain[i].m, 1);
        border_doubles(&rain[i].v, 1);
        border_doubles(&rain[i].left, 1);
        border_doubles(&rain[i].right, 1);
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    struct sort *rain = border_array(c.n, sizeof *rain);
    move_sorts(rain, c.n);
    double *friction = border_place_doubles("friction", 1);
    double force = rain_force(c.n, rain, c.im, c.V, friction);
    border_reply();
    border_doubles(&force, 1);
    border_doubles(friction, 1);
    free(rain);
}

#else

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    struct call c = {n, im, V};
    double force;
    border_call();
    move_arguments(&c);
    move_sorts((struct sort *)rain, n); /* which only reads on this side */
    border_doubles(friction, 1);
    border_wait();
    border_doubles(&force, 1);
    border_doubles(friction, 1);
    return force;
}

#endif
