/* From chapters/08-stepping.nw: edit there, then run make tangle. */
/* checksum 3764979606 of the lines below */
/* The steps of the methods: kicks and drifts, leapfrog, Runge-Kutta. */
#ifndef STEPS_H
#define STEPS_H

#include "forces/largest.h"
#include "forces/newton.h"
#include "forces/stepping.h"
#include "forces/sums.h"
#include "toolbox/vector.h"

#include <math.h>
#include <string.h>

/* A method's coefficients times dt, and memory for its steps. */
struct stepping_work {
    double *drift, *kick;        /* of a splitting, times dt, s */
    double *c, *a, *a2, *b, *b2; /* of a tableau, times dt or dt^2 */
    double *stage;               /* [stages * size] accelerations */
    double *guess;               /* [stages * size] new accelerations in an
                                    iteration */
    double *x, *v;               /* [size] state at a stage */
    double *matrix, *slope;      /* of Newton's method */
    size_t *pivot;
};

static inline void evaluate(struct stepping *s, const double x[],
                            const double v[], double a[])
{
    s->forces.accelerate(s->forces.what, x, v, a);
    ++s->evaluations;
}

/* Computes s->acceleration at the current positions, unless it is known. */
static inline void refresh(struct stepping *s)
{
    if (!s->fresh)
        evaluate(s, s->x, s->v, s->acceleration);
    s->fresh = true;
}

/* Kicks by h under friction. Half a kick predicts the velocity in the
   middle of the kick. The forces at this velocity are used for the whole
   kick. */
static inline void kick_damped(struct stepping *s, double h)
{
    double *const middle = s->part->v;
    evaluate(s, s->x, s->v, s->acceleration);
    for (size_t i = 0; i < s->forces.size; ++i)
        middle[i] = s->v[i] + h / 2 * s->acceleration[i];
    evaluate(s, s->x, middle, s->acceleration);
    push_v(s, h, s->acceleration);
}

static inline void kick(struct stepping *s, double h)
{
    if (h == 0)
        return;
    if (s->forces.damped) {
        kick_damped(s, h);
        return;
    }
    refresh(s);
    push_v(s, h, s->acceleration);
}

static inline void drift(struct stepping *s, double h)
{
    if (s->flow)
        s->flow(s->forces.what, h, s->x, s->v);
    else
        push_x(s, h, s->v);
    s->fresh = false;
}

/* Does kick number k, and the drift after it unless it is the last kick. */
static inline void kick_and_drift(struct stepping *s, size_t k)
{
    const struct stepping_work *const w = s->part;
    const bool drifts = k < s->method->drifts;
    if (w->kick[k] != 0 && !s->forces.damped && !s->flow &&
        s->forces.size < MANY) {
        refresh(s);
        advance(s, w->kick[k], drifts ? w->drift + k : NULL);
        s->fresh = !drifts;
        return;
    }
    kick(s, w->kick[k]);
    if (drifts)
        drift(s, w->drift[k]);
}

static inline void splitting_step(struct stepping *s)
{
    for (size_t k = 0; k <= s->method->drifts; ++k)
        kick_and_drift(s, k);
}

/* Does half a kick and the drift of n coordinates. If `owing` is true,
   first does the second half of the last kick. Under friction, writes the
   velocities predicted for the end of the next kick into ahead. */
static inline void move_as(size_t n, double *restrict x, double *restrict v,
                           double *restrict ahead, const double *restrict a,
                           const struct stepping_work *w, bool owing,
                           bool damped)
{
    const double h = w->kick[0], dt = w->drift[0];
    for (size_t i = 0; i < n; ++i) {
        const double half = h * a[i];
        if (owing)
            v[i] += half;
        v[i] += half;
        x[i] += dt * v[i];
        if (damped)
            ahead[i] = v[i] + half;
    }
}

/* Moves n coordinates, from number `from` on, by move_as. */
static inline void move(const struct stepping *s, size_t from, size_t n,
                        bool owing)
{
    const struct stepping_work *const w = s->part;
    double *const x = s->x + from, *const v = s->v + from;
    double *const ahead = w->v + from, *const a = s->acceleration + from;
    if (owing && s->forces.damped)
        move_as(n, x, v, ahead, a, w, true, true);
    else if (owing)
        move_as(n, x, v, ahead, a, w, true, false);
    else if (s->forces.damped)
        move_as(n, x, v, ahead, a, w, false, true);
    else
        move_as(n, x, v, ahead, a, w, false, false);
}

VECTOR_LOOP static void move_many(const struct stepping *s, size_t from,
                                  size_t n, bool owing)
{
    move(s, from, n, owing);
}

static inline void move_ahead(void *stepping, size_t from, size_t n,
                              bool owing)
{
    if (n < MANY)
        move(stepping, from, n, owing);
    else
        move_many(stepping, from, n, owing);
}

/* Takes steps of leapfrog, (8.4, eq:verlet), with the same bits as
   splitting_step. Under friction, takes steps of (8.13,
   eq:leapfrog-damped). */
static inline void leap(struct stepping *s, uint64_t steps)
{
    const double *const v = s->forces.damped ? s->part->v : s->v;
    refresh(s);
    if (s->sweep) {
        s->sweep(s->forces.what, s->x, v, s->acceleration,
                 &(struct stepping_ahead){move_ahead, s}, steps);
        s->evaluations += steps;
    } else
        for (uint64_t k = 0; k < steps; ++k) {
            move_ahead(s, 0, s->forces.size, k > 0);
            evaluate(s, s->x, v, s->acceleration);
        }
    add(s->v, s->part->kick[0], s->acceleration, s->forces.size);
}

/* Takes a leapfrog step under friction, perhaps with compensated sums. */
static inline void leap_carried(struct stepping *s)
{
    const double h = s->part->kick[0];
    refresh(s);
    push_v(s, h, s->acceleration);
    push_x(s, s->part->drift[0], s->v);
    for (size_t i = 0; i < s->forces.size; ++i)
        s->part->v[i] = s->v[i] + h * s->acceleration[i];
    evaluate(s, s->x, s->part->v, s->acceleration);
    push_v(s, h, s->acceleration);
}

/* Computes w->x and w->v, the state at stage i: (8.10, eq:stage). */
static void go_to_stage(struct stepping *s, size_t i)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size, stages = s->method->stages;
    memcpy(w->x, s->x, n * sizeof *w->x);
    memcpy(w->v, s->v, n * sizeof *w->v);
    add(w->x, w->c[i], s->v, n);
    for (size_t j = 0; j < stages; ++j) {
        const double a = w->a[i * stages + j], a2 = w->a2[i * stages + j];
        if (a != 0)
            add(w->v, a, w->stage + j * n, n);
        if (a2 != 0)
            add(w->x, a2, w->stage + j * n, n);
    }
}

static void close_step(struct stepping *s)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size, stages = s->method->stages;
    for (size_t i = 0; i < n; ++i) {
        double dx = s->dt * s->v[i], dv = 0;
        for (size_t j = 0; j < stages; ++j) {
            dx += w->b2[j] * w->stage[j * n + i];
            dv += w->b[j] * w->stage[j * n + i];
        }
        w->x[i] = dx;
        w->v[i] = dv;
    }
    push_x(s, 1, w->x);
    push_v(s, 1, w->v);
}

static inline void explicit_step(struct stepping *s)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i) {
        go_to_stage(s, i);
        evaluate(s, w->x, w->v, w->stage + i * n);
    }
    close_step(s);
}

static inline void guess_stages(struct stepping *s)
{
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i)
        memcpy(s->part->stage + i * n, s->acceleration,
               n * sizeof *s->acceleration);
}

/* Computes the accelerations at all stages and stores them in guess. */
static inline void sweep(struct stepping *s)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i) {
        go_to_stage(s, i);
        evaluate(s, w->x, w->v, w->guess + i * n);
    }
}

/* Returns whether an iteration has converged: the change is 0, or it is as
   small as rounding errors and has stopped decreasing. */
static inline bool settled(const struct stepping *s, double change,
                           double last)
{
    const size_t n = s->forces.size;
    const double scale = largest(s->part->stage, s->method->stages * n) +
                         largest(s->v, n) / fabs(s->dt);
    return change == 0 || (change > last / 2 && change <= 1e-10 * scale);
}

/* Repeatedly replaces the accelerations at the stages by the accelerations
   computed with them. Returns false if this does not converge. */
static inline bool iterate(struct stepping *s)
{
    enum { MOST_SWEEPS = 100 };
    struct stepping_work *const w = s->part;
    const size_t n = s->method->stages * s->forces.size;
    double last = INFINITY;
    for (int k = 0; k < MOST_SWEEPS; ++k) {
        double change = 0;
        sweep(s);
        for (size_t i = 0; i < n; ++i) {
            change = larger(change, fabs(w->guess[i] - w->stage[i]));
            w->stage[i] = w->guess[i];
        }
        if (settled(s, change, last))
            return true;
        if (!(change < last / 2))
            return false;
        last = change;
    }
    return false;
}

static inline bool implicit_step(struct stepping *s)
{
    evaluate(s, s->x, s->v, s->acceleration);
    guess_stages(s);
    if (!iterate(s)) {
        guess_stages(s);
        if (!newton_solve(s))
            return false;
    }
    close_step(s);
    return true;
}

#endif
