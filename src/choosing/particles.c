/* Sorts light bodies outwards and converts their Jacobi coordinates. */
#include "choosing/particles.h"

#include <stdlib.h>

/* Replaces the heavy bodies by their centre of mass. It is computed as a
   running mean, so that a single heavy body keeps its exact coordinates. */
void particles_gather(const struct particles *l, const struct scene *s,
                      const double x[], double q[])
{
    const size_t n = l->jacobi.bodies;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double *const from = x + k * l->bodies;
        double mass = 0, centre = 0;
        for (size_t j = 0; j < l->heavy; ++j) {
            mass += s->mass[l->order[j]];
            centre +=
                s->mass[l->order[j]] / mass * (from[l->order[j]] - centre);
        }
        q[k * n] = centre;
        for (size_t j = 1; j < n; ++j)
            q[k * n + j] = from[l->order[l->heavy + j - 1]];
    }
}

int particles_compare(const void *one, const void *other)
{
    const struct particles_place *a = one, *b = other;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return a->body < b->body ? -1 : a->body > b->body;
}

/* Sorts the light bodies by their distance from the centre of mass of the
   heavy bodies at the start. Bodies at equal distances are sorted by
   number, so the result does not depend on qsort. Returns false if memory
   runs out. */
static bool sort_by_distance(struct particles *l, const struct scene *s)
{
    const size_t n = l->jacobi.bodies;
    struct particles_place *place = malloc(n * sizeof *place);
    const double *const q = l->work;
    if (!place)
        return false;
    particles_gather(l, s, s->position, l->work);
    for (size_t j = 1; j < n; ++j) {
        const double d[] = {q[j] - q[0], q[n + j] - q[n],
                            q[2 * n + j] - q[2 * n]};
        place[j - 1] = (struct particles_place){d[0] * d[0] + d[1] * d[1] +
                                                    d[2] * d[2],
                                                l->order[l->heavy + j - 1]};
    }
    qsort(place, n - 1, sizeof *place, particles_compare);
    for (size_t j = 1; j < n; ++j)
        l->order[l->heavy + j - 1] = (uint32_t)place[j - 1].body;
    free(place);
    return true;
}

bool particles_is_light(const struct scene *s, size_t i, double heaviest)
{
    return s->mass[i] * 100 < heaviest;
}

/* Separates the heavy bodies from the light ones, and sorts the latter.
   Returns false if memory runs out. */
static bool split(struct particles *l, const struct scene *s,
                  double heaviest, size_t centre)
{
    const size_t n = s->bodies;
    l->order = malloc((n + 1) * sizeof *l->order);
    l->factor = malloc((n + 1) * sizeof *l->factor);
    l->mass = calloc(7 * (n + 1), sizeof *l->mass);
    if (!l->order || !l->factor || !l->mass)
        return false;
    l->work = l->mass + n + 1;
    size_t lights = n;
    for (size_t i = 0; i < n; ++i)
        if (i == centre || !particles_is_light(s, i, heaviest)) {
            l->order[l->heavy++] = (uint32_t)i;
            l->mass[0] += s->mass[i];
        } else
            l->order[--lights] = (uint32_t)i;
    l->jacobi.bodies = 1 + n - lights;
    return sort_by_distance(l, s);
}

/* In Jacobi coordinates the acceleration of light body i towards the heavy
   bodies has the factor M_i/M_0. M_0 is the mass of the heavy bodies, and
   M_i also includes the masses of the light bodies up to i (12.3,
   eq:light-ellipse).

   If a body is fixed or another force acts, momentum is not conserved, and
   these coordinates cannot be used. Then each light body moves around the
   heavy bodies as if it were the only one and had no mass. */
bool particles_create(struct particles *l, const struct scene *s,
                      double heaviest, size_t centre, bool moving)
{
    *l = (struct particles){.bodies = s->bodies, .moving = moving};
    const bool parted = split(l, s, heaviest, centre);
    const size_t n = l->jacobi.bodies;
    for (size_t j = 1; parted && j < n; ++j)
        l->mass[j] = moving ? s->mass[l->order[l->heavy + j - 1]] : 0;
    if (!parted || !jacobi_create(&l->jacobi, n, l->mass, s->k2)) {
        particles_free(l);
        return false;
    }
    for (size_t j = 0; j < l->heavy; ++j)
        l->factor[l->order[j]] = 1;
    for (size_t j = 1; j < n; ++j)
        l->factor[l->order[l->heavy + j - 1]] =
            l->jacobi.mu[j] / l->jacobi.mu[0];
    return true;
}

void particles_free(struct particles *l)
{
    free(l->order);
    free(l->factor);
    free(l->mass);
    jacobi_free(&l->jacobi);
    *l = (struct particles){0};
}

/* Converts positions or velocities x to Jacobi coordinates by (12.2,
   eq:light-jacobi), if l->moving. In any case sets `centre` to the centre
   of mass of all bodies. */
static void to_jacobi(const struct particles *l, const struct scene *s,
                      double x[], double centre[])
{
    const size_t n = l->jacobi.bodies;
    double heavy[SCENE_AXES], *const q = l->work;
    particles_gather(l, s, x, q);
    for (size_t k = 0; k < SCENE_AXES; ++k)
        heavy[k] = q[k * n];
    jacobi_enter(&l->jacobi, q, q);
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        centre[k] = q[k * n];
        for (size_t j = 1; l->moving && j < n; ++j)
            x[k * l->bodies + l->order[l->heavy + j - 1]] =
                heavy[k] + q[k * n + j];
    }
}

void particles_to_jacobi(struct particles *l, const struct scene *s,
                         double x[], double v[])
{
    to_jacobi(l, s, x, l->centre);
    to_jacobi(l, s, v, l->drift);
}

/* Converts Jacobi coordinates x back to positions or velocities. `centre`
   is the centre of mass of all bodies, or its velocity. All heavy bodies
   are shifted by the same distance. */
static void from_jacobi(const struct particles *l, const struct scene *s,
                        double x[], const double centre[])
{
    const size_t n = l->jacobi.bodies;
    double *const q = l->work, heavy[SCENE_AXES];
    particles_gather(l, s, x, q);
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        heavy[k] = q[k * n];
        for (size_t j = 1; j < n; ++j)
            q[k * n + j] -= heavy[k];
        q[k * n] = centre[k];
    }
    jacobi_leave(&l->jacobi, q, q);
    for (size_t k = 0; k < SCENE_AXES; ++k)
        for (size_t j = 0; j < l->bodies; ++j) {
            double *const to = x + k * l->bodies + l->order[j];
            *to = j < l->heavy ? *to + (q[k * n] - heavy[k])
                               : q[k * n + j - l->heavy + 1];
        }
}

/* The centre of mass falls along axes on which the bodies are free, and
   moves uniformly along the others. */
void particles_from_jacobi(const struct particles *l, const struct scene *s,
                           double t, double x[], double v[])
{
    double centre[SCENE_AXES], drift[SCENE_AXES];
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const bool falls = s->freedom[k * l->bodies + l->order[0]];
        const double fall = falls ? s->gravity[k] * t : 0;
        centre[k] = l->centre[k] + (l->drift[k] + fall / 2) * t;
        drift[k] = l->drift[k] + fall;
    }
    if (l->moving) {
        from_jacobi(l, s, x, centre);
        from_jacobi(l, s, v, drift);
    }
}
