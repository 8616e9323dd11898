/* The remote calls of exercise 05d: see examiner/remote.h. With the
   list comes what stands behind it: the suite has put something there. */
/* output: wall_z z 2 */

#include "examiner/remote.h"
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
    remote_sizes(&c->n, 1);
    remote_sizes(&c->disks, 1);
    remote_doubles(c->size, 2);
    remote_doubles(&c->energy, 1);
    remote_doubles(&c->from, 1);
    remote_doubles(&c->until, 1);
}

static void move_hits(struct wall_hit hits[], size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        int wall = (int)hits[i].wall;
        remote_doubles(&hits[i].t, 1);
        remote_ints(&wall, 1);
        remote_doubles(&hits[i].mass, 1);
        remote_doubles(&hits[i].v, 1);
        hits[i].wall = (enum wall)wall;
    }
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const double size[2] = {c.size[0], c.size[1]};
    const size_t count = c.n + 1;
    struct wall_hit *hits = remote_array(count, sizeof *hits);
    memset(hits, 0, count * sizeof *hits);
    move_hits(hits, count);
    double *z = remote_output_doubles("z", 2);
    wall_z(c.n, hits, size, c.disks, c.energy, c.from, c.until, z);
    free(hits);
    remote_reply();
    remote_doubles(z, 2);
}

#else

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    struct call c = {n, disks, {size[0], size[1]}, energy, from, until};
    const size_t count = n + 1;
    struct wall_hit *copy = remote_array(count, sizeof *copy);
    memcpy(copy, hits, count * sizeof *copy);
    remote_call();
    move_arguments(&c);
    move_hits(copy, count);
    free(copy);
    remote_doubles(z, 2);
    remote_wait();
    remote_doubles(z, 2);
}

#endif
