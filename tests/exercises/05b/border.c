/* What crosses the border of exercise 05b: see examiner/border.h. */
/* place: falling_pair_time height 1 */

#include "examiner/border.h"

struct thrown {
    double x, y, vx, vy, radius;
};

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height);

/* The arguments; the height follows. */
struct call {
    double g;
    struct thrown a, b;
};

static void move_disk(struct thrown *d)
{
    border_doubles(&d->x, 1);
    border_doubles(&d->y, 1);
    border_doubles(&d->vx, 1);
    border_doubles(&d->vy, 1);
    border_doubles(&d->radius, 1);
}

static void move_arguments(struct call *c)
{
    border_doubles(&c->g, 1);
    move_disk(&c->a);
    move_disk(&c->b);
}

static void move_answer(double *time, double *height)
{
    border_doubles(time, 1);
    border_doubles(height, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const struct thrown a = c.a, b = c.b;
    double *height = border_place_doubles("height", 1);
    double time = falling_pair_time(c.g, &a, &b, height);
    border_reply();
    move_answer(&time, height);
}

#else

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    struct call c = {g, *a, *b};
    double time;
    border_call();
    move_arguments(&c);
    border_doubles(height, 1);
    border_wait();
    move_answer(&time, height);
    return time;
}

#endif
