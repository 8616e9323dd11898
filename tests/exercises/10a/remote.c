/* The remote calls of exercise 10a: see examiner/remote.h. */
/* output: dashpot on_a 3 */
/* output: dashpot on_b 3 */

#include "examiner/remote.h"

struct body {
    double x[3];
    double v[3];
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3]);

/* The arguments; the two forces follow. */
struct call {
    double c;
    struct body a, b;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->c, 1);
    remote_doubles(c->a.x, 3);
    remote_doubles(c->a.v, 3);
    remote_doubles(c->b.x, 3);
    remote_doubles(c->b.v, 3);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const struct body a = c.a, b = c.b;
    double *on_a = remote_output_doubles("on_a", 3);
    double *on_b = remote_output_doubles("on_b", 3);
    double heat = dashpot(c.c, &a, &b, on_a, on_b);
    remote_reply();
    remote_doubles(&heat, 1);
    remote_doubles(on_a, 3);
    remote_doubles(on_b, 3);
}

#else

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    struct call call = {c, *a, *b};
    double heat;
    remote_call();
    move_arguments(&call);
    remote_doubles(on_a, 3);
    remote_doubles(on_b, 3);
    remote_wait();
    remote_doubles(&heat, 1);
    remote_doubles(on_a, 3);
    remote_doubles(on_b, 3);
    return heat;
}

#endif
