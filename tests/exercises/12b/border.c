/* What crosses the border of exercise 12b: see examiner/border.h. The step
   stays with the judge; the box asks for it. */
/* place: apart end 1 */

#include "examiner/border.h"

struct world {
    double g, k, q;
};

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end);

/* The constants, the step, and a place with a velocity. */
struct call {
    struct world w;
    double h, x, v;
};

static void move_call(struct call *c)
{
    border_doubles(&c->w.g, 1);
    border_doubles(&c->w.k, 1);
    border_doubles(&c->w.q, 1);
    border_doubles(&c->h, 1);
    border_doubles(&c->x, 1);
    border_doubles(&c->v, 1);
}

#ifdef BORDER_INSIDE

static void step(struct world w, double h, double *x, double *v)
{
    struct call c = {w, h, *x, *v};
    border_ask(0);
    move_call(&c);
    border_hear();
    border_doubles(x, 1);
    border_doubles(v, 1);
}

void border_answer(void)
{
    struct call c;
    int n;
    move_call(&c);
    border_ints(&n, 1);
    double *end = border_place_doubles("end", 1);
    double far = apart(step, c.w, c.h, n, c.x, c.v, end);
    border_reply();
    border_doubles(&far, 1);
    border_doubles(end, 1);
}

#else

static void (*taken)(struct world w, double h, double *x, double *v);

void border_heed(int which)
{
    struct call c;
    (void)which;
    move_call(&c);
    taken(c.w, c.h, &c.x, &c.v);
    border_tell();
    border_doubles(&c.x, 1);
    border_doubles(&c.v, 1);
}

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    struct call c = {w, h, x, v};
    double far;
    taken = step;
    border_call();
    move_call(&c);
    border_ints(&n, 1);
    border_doubles(end, 1);
    border_wait();
    border_doubles(&far, 1);
    border_doubles(end, 1);
    return far;
}

#endif
