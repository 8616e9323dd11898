/* What crosses the border of exercise 07b: see examiner/border.h. With the
   list comes what stands behind it: the suite has put something there. */
/* place: compressibility pressure 1 */

#include "examiner/border.h"
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
    border_ints(&c->dimensions, 1);
    border_sizes(&c->n, 1);
    border_sizes(&c->count, 1);
    border_doubles(c->box, 3);
    border_doubles(&c->energy, 1);
    border_doubles(&c->time, 1);
}

static void move_collisions(struct collision c[], size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        border_doubles(c[i].mass, 2);
        border_doubles(c[i].apart, 3);
        border_doubles(c[i].first, 3);
        border_doubles(c[i].second, 3);
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double box[3] = {c.box[0], c.box[1], c.box[2]};
    const size_t length = c.count + 1;
    struct collision *list = border_array(length, sizeof *list);
    move_collisions(list, length);
    double *pressure = border_place_doubles("pressure", 1);
    double z = compressibility(c.dimensions, box, c.n, c.energy, c.time,
                               c.count, list, pressure);
    border_reply();
    border_doubles(&z, 1);
    border_doubles(pressure, 1);
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
    struct collision *copy = border_array(length, sizeof *copy);
    double z;
    memcpy(copy, collisions, length * sizeof *copy);
    border_call();
    move_arguments(&c);
    move_collisions(copy, length);
    free(copy);
    border_doubles(pressure, 1);
    border_wait();
    border_doubles(&z, 1);
    border_doubles(pressure, 1);
    return z;
}

#endif
