/* What crosses the border of exercise 05d: see examiner/border.h. With the
   list comes what stands behind it: the suite has put something there. */
/* place: wall_z z 2 */

#include "examiner/border.h"
#include <stdlib.h>
#include <string.h>

enum wall { LEFT, RIGHT, BOTTOM, TOP };

struct wall_hit {
    double t;
    enum wall wall;
    double mass, v;
};

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2]);

/* The arguments but for the list and z. */
struct call {
    size_t n, disks;
    double size[2], energy, from, until;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_sizes(&c->disks, 1);
    border_doubles(c->size, 2);
    border_doubles(&c->energy, 1);
    border_doubles(&c->from, 1);
    border_doubles(&c->until, 1);
}

static void move_hits(struct wall_hit hits[], size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        int wall = (int)hits[i].wall;
        border_doubles(&hits[i].t, 1);
        border_ints(&wall, 1);
        border_doubles(&hits[i].mass, 1);
        border_doubles(&hits[i].v, 1);
        hits[i].wall = (enum wall)wall;
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double size[2] = {c.size[0], c.size[1]};
    const size_t count = c.n + 1;
    struct wall_hit *hits = border_array(count, sizeof *hits);
    memset(hits, 0, count * sizeof *hits);
    move_hits(hits, count);
    double *z = border_place_doubles("z", 2);
    wall_z(c.n, hits, size, c.disks, c.energy, c.from, c.until, z);
    free(hits);
    border_reply();
    border_doubles(z, 2);
}

#else

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    struct call c = {n, disks, {size[0], size[1]}, energy, from, until};
    const size_t count = n + 1;
    struct wall_hit *copy = border_array(count, sizeof *copy);
    memcpy(copy, hits, count * sizeof *copy);
    border_call();
    move_arguments(&c);
    move_hits(copy, count);
    free(copy);
    border_doubles(z, 2);
    border_wait();
    border_doubles(z, 2);
}

#endif
