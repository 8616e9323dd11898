/* Pushes overlapping bodies apart, by linear springs or Hertz's law. */
#include "forces/soft.h"

#include <math.h>
#include <stdlib.h>

bool soft_create(struct soft *t, const struct scene *s)
{
    *t = (struct soft){.scene = s, .near = malloc(sizeof *t->near)};
    if (t->near && spheres_create(t->near, s, SPHERES_ALL))
        return true;
    free(t->near);
    return false;
}

void soft_free(struct soft *t)
{
    spheres_free(t->near);
    free(t->near);
    *t = (struct soft){0};
}

/* Returns the force (in N) between two bodies: (11.11, eq:touch). depth is
   their overlap (in m), and rate is the rate at which it grows (in m/s). */
static double push(const struct scene *s, double depth, double rate)
{
    if (s->law == SCENE_HERTZ)
        return s->stiffness * depth * sqrt(depth);
    return s->stiffness * depth + s->dashpot * rate;
}

/* Returns the distance of a and b (in m), and writes the vector from a to b
   (in m) into d. */
static double distance(const struct scene *s, size_t a, size_t b,
                       const double x[], double d[])
{
    double square = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        d[k] = spheres_way(s, x, a, b, k);
        square += d[k] * d[k];
    }
    return sqrt(square);
}

/* Adds the accelerations of two overlapping bodies along the line between
   their centres. Bodies at the same position get no force. */
static void push_apart(const struct scene *s, size_t i, size_t j,
                       const double x[], const double v[], double a[])
{
    const size_t n = s->bodies;
    double d[SPHERES_AXES], parting = 0;
    const double far = distance(s, i, j, x, d);
    for (size_t k = 0; k < SPHERES_AXES && far > 0; ++k)
        parting += d[k] / far * (v[k * n + j] - v[k * n + i]);
    const double depth = s->radius[i] + s->radius[j] - far;
    const double force = push(s, depth, -parting);
    for (size_t k = 0; k < SPHERES_AXES && far > 0; ++k) {
        a[k * n + i] -= force * d[k] / far / s->mass[i];
        a[k * n + j] += force * d[k] / far / s->mass[j];
    }
}

/* Returns the depth (in m) by which body i overlaps the lower wall (side
   -1) or the upper wall (side 1) normal to axis k. */
static double wall_depth(const struct scene *s, const double x[], size_t i,
                         size_t k, int side)
{
    const double place = x[k * s->bodies + i];
    return side > 0 ? place + s->radius[i] - s->high[k]
                    : s->low[k] - (place - s->radius[i]);
}

/* Adds the acceleration of body i due to a wall that it overlaps. The wall
   acts as a body that cannot move. */
static void push_off(const struct scene *s, size_t i, size_t k, int side,
                     const double x[], const double v[], double a[])
{
    const size_t c = k * s->bodies + i;
    const double depth = wall_depth(s, x, i, k, side);
    if (depth > 0)
        a[c] -= side * push(s, depth, side * v[c]) / s->mass[i];
}

/* Adds the forces of walls first, then the forces of pairs in ascending
   order, so that the rounding errors are always the same. */
void soft_add(struct soft *t, const double x[], const double v[],
              double a[])
{
    const struct scene *s = t->scene;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t i = 0; s->wall[k] == SCENE_HARD && i < s->bodies; ++i) {
            push_off(s, i, k, -1, x, v, a);
            push_off(s, i, k, 1, x, v, a);
        }
    const size_t pairs = spheres_overlaps(t->near, x);
    for (size_t j = 0; j < pairs; ++j)
        push_apart(s, t->near->pair[j].a, t->near->pair[j].b, x, v, a);
}

/* Returns the elastic energy of an overlap (in J), the integral of the
   force. */
static double stored(const struct scene *s, double depth)
{
    if (!(depth > 0))
        return 0;
    if (s->law == SCENE_HERTZ)
        return 0.4 * s->stiffness * depth * depth * sqrt(depth);
    return s->stiffness * depth * depth / 2;
}

double soft_potential(const struct soft *t, const double x[])
{
    const struct scene *s = t->scene;
    double sum = 0, d[SPHERES_AXES];
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t i = 0; s->wall[k] == SCENE_HARD && i < s->bodies; ++i)
            sum += stored(s, wall_depth(s, x, i, k, -1)) +
                   stored(s, wall_depth(s, x, i, k, 1));
    const size_t pairs = spheres_overlaps(t->near, x);
    for (size_t j = 0; j < pairs; ++j) {
        const struct spheres_pair p = t->near->pair[j];
        sum += stored(s, s->radius[p.a] + s->radius[p.b] -
                             distance(s, p.a, p.b, x, d));
    }
    return sum;
}
