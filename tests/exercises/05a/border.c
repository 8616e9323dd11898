/* What crosses the border of exercise 05a: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2]);

struct call {
    double box, radius, r[2], v[2];
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->box, 1);
    border_doubles(&c->radius, 1);
    border_doubles(c->r, 2);
    border_doubles(c->v, 2);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double r[2] = {c.r[0], c.r[1]}, v[2] = {c.v[0], c.v[1]};
    double time = round_wall_time(c.box, c.radius, r, v);
    border_reply();
    border_doubles(&time, 1);
}

#else

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    struct call c = {box, radius, {r[0], r[1]}, {v[0], v[1]}};
    double time;
    border_call();
    move_arguments(&c);
    border_wait();
    border_doubles(&time, 1);
    return time;
}

#endif
