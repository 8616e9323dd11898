/* The remote calls of exercise 01b: see examiner/remote.h. */
/* output: measure_collision mass_ratio 1 */
/* output: measure_collision restitution 1 */

#include "examiner/remote.h"

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution);

/* The arguments; the two places follow. */
struct call {
    double u1, u2, v1, v2;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->u1, 1);
    remote_doubles(&c->u2, 1);
    remote_doubles(&c->v1, 1);
    remote_doubles(&c->v2, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *mass_ratio = remote_output_doubles("mass_ratio", 1);
    double *restitution = remote_output_doubles("restitution", 1);
    bool told =
        measure_collision(c.u1, c.u2, c.v1, c.v2, mass_ratio, restitution);
    remote_reply();
    remote_bools(&told, 1);
    remote_doubles(mass_ratio, 1);
    remote_doubles(restitution, 1);
}

#else

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    struct call c = {u1, u2, v1, v2};
    bool told = false;
    remote_call();
    move_arguments(&c);
    remote_doubles(mass_ratio, 1);
    remote_doubles(restitution, 1);
    remote_wait();
    remote_bools(&told, 1);
    remote_doubles(mass_ratio, 1);
    remote_doubles(restitution, 1);
    return told;
}

#endif
