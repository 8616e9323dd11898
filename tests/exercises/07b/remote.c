/* The remote calls of exercise 07b: see examiner/remote.h. With the
   list comes what stands behind it: the suite has put something there. */
/* output: compressibility pressure 1 */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

struct collision {
    double mass[2];
    double apart[3];
    double first[3];
    double second[3];
};

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure);

/* The arguments but for the list and the pressure. */
struct call {
    int dimensions;
    size_t n, count;
    double box[3], energy, time;
};

static void move_arguments(struct call *c)
{
    remote_ints(&c->dimensions, 1);
    remote_sizes(&c->n, 1);
    remote_sizes(&c->count, 1);
    remote_doubles(c->box, 3);
    remote_doubles(&c->energy, 1);
    remote_doubles(&c->time, 1);
}

static void move_collisions(struct collision c[], size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        remote_doubles(c[i].mass, 2);
        remote_doubles(c[i].apart, 3);
        remote_doubles(c[i].first, 3);
        remote_doubles(c[i].second, 3);
    }
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    const double box[3] = {c.box[0], c.box[1], c.box[2]};
    const size_t length = c.count + 1;
    struct collision *list = remote_array(length, sizeof *list);
    move_collisions(list, length);
    double *pressure = remote_output_doubles("pressure", 1);
    double z = compressibility(c.dimensions, box, c.n, c.energy, c.time,
                               c.count, list, pressure);
    remote_reply();
    remote_doubles(&z, 1);
    remote_doubles(pressure, 1);
    free(list);
}

#else

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    struct call c = {dimensions, n,   count, {box[0], box[1], box[2]},
                     energy,     time};
    const size_t length = count + 1;
    struct collision *copy = remote_array(length, sizeof *copy);
    double z;
    memcpy(copy, collisions, length * sizeof *copy);
    remote_call();
    move_arguments(&c);
    move_collisions(copy, length);
    free(copy);
    remote_doubles(pressure, 1);
    remote_wait();
    remote_doubles(&z, 1);
    remote_doubles(pressure, 1);
    return z;
}

#endif
