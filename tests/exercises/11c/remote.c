/* The remote calls of exercise 11c: see examiner/remote.h. A sphere
   is eight numbers. */
/* output: go_back a 1 */
/* output: go_back b 1 */

#include "examiner/remote.h"

struct sphere {
    double im, r, x[3], v[3];
};

double go_back(struct sphere *a, struct sphere *b, double dt);

static void move_sphere(struct sphere *s)
{
    remote_doubles(&s->im, 1);
    remote_doubles(&s->r, 1);
    remote_doubles(s->x, 3);
    remote_doubles(s->v, 3);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    double dt;
    remote_doubles(&dt, 1);
    struct sphere *a = remote_output("a", sizeof *a);
    move_sphere(a);
    struct sphere *b = remote_output("b", sizeof *b);
    move_sphere(b);
    double ago = go_back(a, b, dt);
    remote_reply();
    remote_doubles(&ago, 1);
    move_sphere(a);
    move_sphere(b);
}

#else

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    double ago;
    remote_call();
    remote_doubles(&dt, 1);
    move_sphere(a);
    move_sphere(b);
    remote_wait();
    remote_doubles(&ago, 1);
    move_sphere(a);
    move_sphere(b);
    return ago;
}

#endif
