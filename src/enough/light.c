/* From chapters/12-models.nw: edit there, then run make tangle. */
/* checksum 3475827645 of the lines below */
/* Who is light, from the nearest outwards; Jacobi's coordinates. */
#include "enough/light.h"

#include <math.h>
#include <stdlib.h>

/* The mean of q, along axis k, over the heavy bodies. */
static double middle(const struct light *l, const struct scene *s,
                     const double q[], size_t k)
{
    double sum = 0, mass = 0;
    for (size_t j = 0; j < l->heavy; ++j) {
        const size_t i = l->source[j];
        sum += s->mass[i] * q[k * l->bodies + i];
        mass += s->mass[i];
    }
    return sum / mass;
}

int light_compare(const void *one, const void *other)
{
    const struct light_place *a = one, *b = other;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return a->body < b->body ? -1 : a->body > b->body;
}

static bool sort_lights(struct light *l, const struct scene *s)
{
    struct light_place *place = calloc(l->lights + 1, sizeof *place);
    const size_t n = l->bodies;
    if (!place)
        return false;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double centre = middle(l, s, s->position, k);
        for (size_t j = 0; j < l->lights; ++j) {
            const double d = s->position[k * n + l->order[j]] - centre;
            place[j].body = l->order[j];
            place[j].key += d * d;
        }
    }
    qsort(place, l->lights, sizeof *place, light_compare);
    for (size_t j = 0; j < l->lights; ++j)
        l->order[j] = (uint32_t)place[j].body;
    free(place);
    return true;
}

static void add_masses(struct light *l, const struct scene *s)
{
    double heavy = 0;
    for (size_t j = 0; j < l->heavy; ++j)
        heavy += s->mass[l->source[j]];
    double mass = heavy;
    for (size_t i = 0; i < l->bodies; ++i)
        l->share[i] = 1;
    for (size_t j = 0; j < l->lights; ++j) {
        mass += s->mass[l->order[j]];
        l->inner[j] = l->moving ? mass : heavy;
        l->share[l->order[j]] = l->inner[j] / heavy;
    }
}

static void find_centre(struct light *l, const struct scene *s)
{
    const size_t n = l->bodies;
    double mass = 0;
    for (size_t i = 0; i < n; ++i) {
        mass += s->mass[i];
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            l->centre[k] += s->mass[i] * s->position[k * n + i];
            l->drift[k] += s->mass[i] * s->velocity[k * n + i];
        }
    }
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        l->centre[k] /= mass;
        l->drift[k] /= mass;
        for (size_t i = 0; i < n; ++i)
            if (s->freedom[k * n + i])
                l->fall[k] = s->gravity[k];
    }
}

bool light_create(struct light *l, const struct scene *s,
                  const bool is_heavy[], bool moving)
{
    const size_t n = s->bodies;
    *l = (struct light){.bodies = n, .moving = moving};
    l->source = malloc((n + 1) * sizeof *l->source);
    l->order = malloc((n + 1) * sizeof *l->order);
    l->share = malloc((n + 1) * sizeof *l->share);
    l->inner = malloc((n + 1) * sizeof *l->inner);
    const bool roomy = l->source && l->order && l->share && l->inner;
    for (size_t i = 0; roomy && i < n; ++i)
        if (is_heavy[i])
            l->source[l->heavy++] = (uint32_t)i;
        else
            l->order[l->lights++] = (uint32_t)i;
    if (!roomy || !sort_lights(l, s)) {
        light_free(l);
        return false;
    }
    add_masses(l, s);
    find_centre(l, s);
    return true;
}

void light_free(struct light *l)
{
    free(l->source);
    free(l->order);
    free(l->share);
    free(l->inner);
    *l = (struct light){0};
}

static void enter(const struct light *l, const struct scene *s, double q[],
                  size_t k)
{
    const double heavy = middle(l, s, q, k);
    double centre = heavy;
    for (size_t j = 0; j < l->lights; ++j) {
        const size_t i = l->order[j];
        const double way = q[k * l->bodies + i] - centre;
        centre += s->mass[i] / l->inner[j] * way;
        q[k * l->bodies + i] = heavy + way;
    }
}

void light_enter(const struct light *l, const struct scene *s, double x[],
                 double v[])
{
    for (size_t k = 0; l->moving && k < SCENE_AXES; ++k) {
        enter(l, s, x, k);
        enter(l, s, v, k);
    }
}

/* From the outermost light, whose centre with all others is known. */
static void leave(const struct light *l, const struct scene *s, double q[],
                  size_t k, double centre)
{
    const double heavy = middle(l, s, q, k);
    for (size_t j = l->lights; j-- > 0;) {
        const size_t i = l->order[j];
        const double way = q[k * l->bodies + i] - heavy;
        centre -= s->mass[i] / l->inner[j] * way;
        q[k * l->bodies + i] = centre + way;
    }
    for (size_t j = 0; j < l->heavy; ++j)
        q[k * l->bodies + l->source[j]] += centre - heavy;
}

void light_leave(const struct light *l, const struct scene *s, double t,
                 double x[], double v[])
{
    for (size_t k = 0; l->moving && k < SCENE_AXES; ++k) {
        const double fall = l->fall[k];
        leave(l, s, x, k, l->centre[k] + (l->drift[k] + fall / 2 * t) * t);
        leave(l, s, v, k, l->drift[k] + fall * t);
    }
}
