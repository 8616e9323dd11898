/* The remote calls of exercise 05a: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2]);

struct call {
    double box, radius, r[2], v[2];
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->box, 1);
    remote_doubles(&c->radius, 1);
    remote_doubles(c->r, 2);
    remote_doubles(c->v, 2);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const double r[2] = {c.r[0], c.r[1]}, v[2] = {c.v[0], c.v[1]};
    double time = round_wall_time(c.box, c.radius, r, v);
    remote_reply();
    remote_doubles(&time, 1);
}

#else

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    struct call c = {box, radius, {r[0], r[1]}, {v[0], v[1]}};
    double time;
    remote_call();
    move_arguments(&c);
    remote_wait();
    remote_doubles(&time, 1);
    return time;
}

#endif
