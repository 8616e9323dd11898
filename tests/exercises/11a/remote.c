/* The remote calls of exercise 11a: see examiner/remote.h. */
/* output: part_spheres a 1 */
/* output: part_spheres b 1 */

#include "examiner/remote.h"

struct sphere {
    double mass;
    double radius;
    double x[3];
};

double part_spheres(struct sphere *a, struct sphere *b);

static void move_sphere(struct sphere *s)
{
    remote_doubles(&s->mass, 1);
    remote_doubles(&s->radius, 1);
    remote_doubles(s->x, 3);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct sphere *a = remote_output("a", sizeof *a);
    struct sphere *b = remote_output("b", sizeof *b);
    move_sphere(a);
    move_sphere(b);
    double depth = part_spheres(a, b);
    remote_reply();
    remote_doubles(&depth, 1);
    move_sphere(a);
    move_sphere(b);
}

#else

double part_spheres(struct sphere *a, struct sphere *b)
{
    double depth;
    remote_call();
    move_sphere(a);
    move_sphere(b);
    remote_wait();
    remote_doubles(&depth, 1);
    move_sphere(a);
    move_sphere(b);
    return depth;
}

#endif
