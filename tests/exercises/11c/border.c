/* What crosses the border of exercise 11c: see examiner/border.h. A sphere
   is eight numbers. */
/* place: go_back a 1 */
/* place: go_back b 1 */

#include "examiner/border.h"

struct sphere {
    double im, r, x[3], v[3];
};

double go_back(struct sphere *a, struct sphere *b, double dt);

static void move_sphere(struct sphere *s)
{
    border_doubles(&s->im, 1);
    border_doubles(&s->r, 1);
    border_doubles(s->x, 3);
    border_doubles(s->v, 3);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    double dt;
    border_doubles(&dt, 1);
    struct sphere *a = border_place("a", sizeof *a);
    move_sphere(a);
    struct sphere *b = border_place("b", sizeof *b);
    move_sphere(b);
    double ago = go_back(a, b, dt);
    border_reply();
    border_doubles(&ago, 1);
    move_sphere(a);
    move_sphere(b);
}

#else

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    double ago;
    border_call();
    border_doubles(&dt, 1);
    move_sphere(a);
    move_sphere(b);
    border_wait();
    border_doubles(&ago, 1);
    move_sphere(a);
    move_sphere(b);
    return ago;
}

#endif
