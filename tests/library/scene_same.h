/* Says whether two scenes are the same to the last bit, and sums up the
   bits of one. */
#ifndef SCENE_SAME_H
#define SCENE_SAME_H

#include "scenes/scene.h"
#include "toolbox/table.h"

#include <string.h>

static inline bool same_double(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

#define SAME_LIST(a, b, count, list)                                       \
    (memcmp((a)->list, (b)->list, (count) * sizeof *(a)->list) == 0)

static inline bool same_kinds(const struct scene *a, const struct scene *b)
{
    bool good = a->kinds == b->kinds && a->springs == b->springs;
    for (size_t i = 0; good && i < a->kinds; ++i)
        good = memcmp(&a->kind[i], &b->kind[i], sizeof a->kind[i]) == 0;
    for (size_t i = 0; good && i < a->springs; ++i) {
        const struct scene_spring *p = &a->spring[i], *q = &b->spring[i];
        good = p->a == q->a && p->b == q->b && p->kind == q->kind &&
               same_double(p->rest, q->rest);
    }
    return good;
}

static inline bool scene_same(const struct scene *a, const struct scene *b)
{
    const size_t n = a->bodies;
    return n == b->bodies && SAME_LIST(a, b, n, mass) &&
           SAME_LIST(a, b, n, charge) && SAME_LIST(a, b, n, radius) &&
           SAME_LIST(a, b, 3 * n, position) &&
           SAME_LIST(a, b, 3 * n, velocity) &&
           SAME_LIST(a, b, 3 * n, freedom) &&
           SAME_LIST(a, b, 3 * n, colour) && SAME_LIST(a, b, n, species) &&
           !a->carry == !b->carry &&
           (!a->carry || SAME_LIST(a, b, 6 * n, carry)) &&
           !a->kept == !b->kept &&
           (!a->kept || SAME_LIST(a, b, 3 * n, kept)) && same_kinds(a, b) &&
           SAME_LIST(a, b, 3, gravity) && same_double(a->k2, b->k2) &&
           same_double(a->softening, b->softening) &&
           same_double(a->damping, b->damping) &&
           same_double(a->dt, b->dt) && same_double(a->time, b->time) &&
           a->axial == b->axial && a->contact == b->contact &&
           same_double(a->restitution, b->restitution) &&
           a->law == b->law && same_double(a->stiffness, b->stiffness) &&
           same_double(a->dashpot, b->dashpot) &&
           SAME_LIST(a, b, 3, wall) && SAME_LIST(a, b, 3, low) &&
           SAME_LIST(a, b, 3, high);
}

/* Fowler, Noll and Vo's sum of all numbers of a scene that is not under
   way, bit by bit. */
static inline uint64_t scene_sum(const struct scene *s)
{
    const size_t n = s->bodies;
    const double one[] = {
        (double)n,     (double)s->kinds, (double)s->springs,
        s->k2,         s->softening,     s->damping,
        s->dt,         s->time,          s->axial,
        s->contact,    s->restitution,   s->law,
        s->stiffness,  s->dashpot,       s->gravity[0],
        s->gravity[1], s->gravity[2]};
    uint64_t sum = table_sum(TABLE_NOTHING, (const char *)one, sizeof one);
#define SUM_LIST(list, count)                                              \
    sum = table_sum(sum, (const char *)(list), (count) * sizeof *(list))
    SUM_LIST(s->mass, n);
    SUM_LIST(s->charge, n);
    SUM_LIST(s->radius, n);
    SUM_LIST(s->position, 3 * n);
    SUM_LIST(s->velocity, 3 * n);
    SUM_LIST(s->freedom, 3 * n);
    SUM_LIST(s->colour, 3 * n);
    SUM_LIST(s->species, n);
    SUM_LIST(s->low, 3);
    SUM_LIST(s->high, 3);
    for (size_t k = 0; k < 3; ++k)
        SUM_LIST((double[]){s->wall[k]}, (size_t)1);
    for (size_t i = 0; i < s->kinds; ++i)
        SUM_LIST((&(double[]){s->kind[i].stiffness, s->kind[i].damping,
                              s->kind[i].colour[0], s->kind[i].colour[1],
                              s->kind[i].colour[2]}),
                 (size_t)1);
    for (size_t i = 0; i < s->springs; ++i)
        SUM_LIST((&(double[]){s->spring[i].a, s->spring[i].b,
                              s->spring[i].kind, s->spring[i].rest}),
                 (size_t)1);
#undef SUM_LIST
    return sum;
}

#endif
