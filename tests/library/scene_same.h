/* Says whether two scenes are the same to the last bit. */
#ifndef SCENE_SAME_H
#define SCENE_SAME_H

#include "scenes/scene.h"

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
           a->touch == b->touch &&
           same_double(a->stiffness, b->stiffness) &&
           same_double(a->dashpot, b->dashpot) &&
           SAME_LIST(a, b, 3, wall) && SAME_LIST(a, b, 3, low) &&
           SAME_LIST(a, b, 3, high);
}

#endif
