/* What crosses the border of exercise 11a: see examiner/border.h. */
/* place: part_spheres a 1 */
/* place: part_spheres b 1 */

#include "examiner/border.h"

struct sphere {
    double mass;
    double radius;
    double x[3];
};

double part_spheres(struct sphere *a, struct sphere *b);

static void move_sphere(struct sphere *s)
{
    border_doubles(&s->mass, 1);
    border_doubles(&s->radius, 1);
    border_doubles(s->x, 3);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct sphere *a = border_place("a", sizeof *a);
    struct sphere *b = border_place("b", sizeof *b);
    move_sphere(a);
    move_sphere(b);
    double depth = part_spheres(a, b);
    border_reply();
    border_doubles(&depth, 1);
    move_sphere(a);
    move_sphere(b);
}

#else

double part_spheres(struct sphere *a, struct sphere *b)
{
    double depth;
    border_call();
    move_sphere(a);
    move_sphere(b);
    border_wait();
    border_doubles(&depth, 1);
    move_sphere(a);
    move_sphere(b);
    return depth;
}

#endif
