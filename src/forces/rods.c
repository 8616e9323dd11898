/* Corrects the lengths and velocities of rods, one by one, in each step. */
#include "forces/rods.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void rods_free(struct rods *p)
{
    free(p->rod);
    free(p->weight);
    *p = (struct rods){0};
}

/* Gives fixed coordinates the inverse mass 0, so no rod moves them. A body
   without mass also gets 0, and no rod may be attached to it. The length of
   a rod is the initial length of its spring, not the rest length. */
bool rods_create(struct rods *p, const struct scene *s,
                 const struct scene_spring spring[], size_t count,
                 struct stepping_forces forces)
{
    const size_t n = s->bodies;
    *p = (struct rods){.bodies = n, .count = count, .forces = forces};
    p->rod = malloc((count + 1) * sizeof *p->rod);
    p->weight = calloc(12 * n + 1, sizeof *p->weight);
    if (!p->rod || !p->weight) {
        rods_free(p);
        return false;
    }
    p->acceleration = p->weight + 3 * n;
    p->before = p->weight + 6 * n;
    p->last = p->weight + 9 * n;
    for (size_t c = 0; c < 3 * n; ++c)
        p->weight[c] =
            s->freedom[c] && s->mass[c % n] > 0 ? 1 / s->mass[c % n] : 0;
    for (size_t j = 0; j < count; ++j) {
        double square = 0;
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const double *x = s->position + k * n;
            const double d = x[spring[j].b] - x[spring[j].a];
            square += d * d;
        }
        p->rod[j] = (struct rods_rod){spring[j].a, spring[j].b, square};
    }
    return true;
}

/* Shifts the ends of a rod in opposite directions along `way` (in m): adds
   lambda * way / m to q of the first end and subtracts it from q of the
   other end, where m is the mass of the end in question. lambda is in kg if
   q are positions, and in kg/s if q are velocities. */
static void shift_ends(const struct rods *p, const struct rods_rod *r,
                       const double way[3], double lambda, double q[])
{
    for (size_t k = 0; k < 3; ++k) {
        const size_t from = k * p->bodies + r->a, to = k * p->bodies + r->b;
        q[from] += lambda * p->weight[from] * way[k];
        q[to] -= lambda * p->weight[to] * way[k];
    }
}

/* `way` is the vector (in m) between a rod's ends before the step. a, b and
   c are the coefficients of (12.7, eq:rods-shake). */
struct rods_way {
    double way[3], a, b, c;
    double far; /* largest coordinate of the ends, m */
};

static struct rods_way measure(const struct rods *p,
                               const struct rods_rod *r, const double x[])
{
    struct rods_way w = {.c = -r->square};
    for (size_t k = 0; k < 3; ++k) {
        const size_t from = k * p->bodies + r->a, to = k * p->bodies + r->b;
        const double d = x[to] - x[from];
        w.way[k] = p->before[to] - p->before[from];
        w.far = fmax(w.far, fmax(fabs(x[from]), fabs(x[to])));
        const double moved = (p->weight[from] + p->weight[to]) * w.way[k];
        w.a += moved * moved;
        w.b += moved * d;
        w.c += d * d;
    }
    return w;
}

/* Corrects the length of rod r after a drift over dt from p->before to x:
   (12.7, eq:rods-shake). Returns whether it corrected an error beyond the
   rounding of coordinates. Sets *broken if such an error cannot be
   corrected. */
static bool mend_length(struct rods *p, const struct rods_rod *r, double dt,
                        double x[], double v[], bool *broken)
{
    const struct rods_way w = measure(p, r, x);
    const double root = w.b * w.b - w.a * w.c;
    if (fabs(w.c) <= 1e-14 * r->square + 2e-15 * w.far * sqrt(r->square))
        return false;
    if (!(w.b > 0 && root >= 0)) {
        *broken = true;
        return false;
    }
    const double lambda = w.c / (w.b + sqrt(root));
    shift_ends(p, r, w.way, lambda, x);
    shift_ends(p, r, w.way, lambda / dt, v);
    ++p->corrections;
    return true;
}

enum { MOST_ROUNDS = 4000 };

/* Corrects the lengths of all rods in turn until none is wrong. A single
   rod needs only one correction. Returns whether all lengths are right. */
static bool mend_lengths(struct rods *p, double dt, double x[], double v[])
{
    bool broken = false, wrong = true;
    for (int k = 0; k < MOST_ROUNDS && wrong && !broken; ++k) {
        wrong = false;
        for (size_t j = 0; j < p->count; ++j)
            wrong |= mend_length(p, &p->rod[j], dt, x, v, &broken);
        wrong = wrong && p->count > 1;
    }
    return !broken && !wrong;
}

/* Removes the relative velocity along a rod: (12.8, eq:rods-rattle).
   Returns whether this velocity exceeded the rounding error of the largest
   speed. */
static bool mend_velocity(struct rods *p, const struct rods_rod *r,
                          const double x[], double v[])
{
    double way[3], rate = 0, weight = 0, speed = 0;
    for (size_t k = 0; k < 3; ++k) {
        const size_t from = k * p->bodies + r->a, to = k * p->bodies + r->b;
        way[k] = x[to] - x[from];
        rate += way[k] * (v[to] - v[from]);
        speed = fmax(speed, fmax(fabs(v[from]), fabs(v[to])));
        weight += way[k] * way[k] * (p->weight[from] + p->weight[to]);
    }
    if (fabs(rate) <= 1e-14 * speed * sqrt(r->square) || weight == 0)
        return false;
    shift_ends(p, r, way, rate / weight, v);
    ++p->corrections;
    return true;
}

bool rods_project(struct rods *p, const double x[], double v[])
{
    bool wrong = true;
    for (int k = 0; k < MOST_ROUNDS && wrong; ++k) {
        wrong = false;
        for (size_t j = 0; j < p->count; ++j)
            wrong |= mend_velocity(p, &p->rod[j], x, v);
        wrong = wrong && p->count > 1;
    }
    return !wrong;
}

/* Computes the accelerations at x, unless the last ones were computed at
   the same positions. This is checked because a contact may have moved
   bodies since then. */
static void look(struct rods *p, const double x[], const double v[])
{
    const size_t bytes = 3 * p->bodies * sizeof *x;
    if (p->fresh && memcmp(x, p->last, bytes) == 0)
        return;
    p->forces.accelerate(p->forces.what, x, v, p->acceleration);
    ++p->evaluations;
    memcpy(p->last, x, bytes);
    p->fresh = true;
}

static void kick(const struct rods *p, double h, double v[])
{
    for (size_t c = 0; c < 3 * p->bodies; ++c)
        v[c] += h * p->acceleration[c];
}

/* Takes a step: kick, drift, correct lengths, kick, correct velocities.
   Lengths are corrected once, since only the drift changes them.
   Velocities are also corrected at the beginning, which is necessary in
   the first step and after contacts. */
bool rods_step(void *rods, double dt, double x[], double v[])
{
    struct rods *p = rods;
    const size_t size = 3 * p->bodies;
    look(p, x, v);
    if (!rods_project(p, x, v))
        return false;
    memcpy(p->before, x, size * sizeof *x);
    kick(p, dt / 2, v);
    for (size_t c = 0; c < size; ++c)
        x[c] += dt * v[c];
    if (!mend_lengths(p, dt, x, v))
        return false;
    look(p, x, v);
    kick(p, dt / 2, v);
    return rods_project(p, x, v);
}
