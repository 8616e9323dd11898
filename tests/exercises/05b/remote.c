/* The remote calls of exercise 05b: see examiner/remote.h. */
/* output: falling_pair_time height 1 */

#include "examiner/remote.h"

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
    remote_doubles(&d->x, 1);
    remote_doubles(&d->y, 1);
    remote_doubles(&d->vx, 1);
    remote_doubles(&d->vy, 1);
    remote_doubles(&d->radius, 1);
}

static void move_arguments(struct call *c)
{
    remote_doubles(&c->g, 1);
    move_disk(&c->a);
    move_disk(&c->b);
}

static void move_answer(double *time, double *height)
{
    remote_doubles(time, 1);
    remote_doubles(height, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const struct thrown a = c.a, b = c.b;
    double *height = remote_output_doubles("height", 1);
    double time = falling_pair_time(c.g, &a, &b, height);
    remote_reply();
    move_answer(&time, height);
}

#else

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    struct call c = {g, *a, *b};
    double time;
    remote_call();
    move_arguments(&c);
    remote_doubles(height, 1);
    remote_wait();
    move_answer(&time, height);
    return time;
}

#endif
