/* From chapters/02-bonkers.nw: edit there, then run make tangle. */
/* checksum 727686578 of the lines below */
/* A gap between two bodies: the time when it closes, and the collision. */
#ifndef GAP_H
#define GAP_H

#include "line/bonkers.h"
#include "line/weight.h"

#include <float.h>
#include <math.h>

static inline double position(const struct bonkers_body *a, double t)
{
    return a->x + a->v * (t - a->since);
}

/* Returns the time (in s) at which the gap to the right of a body closes,
   or INFINITY if it does not (2.3, eq:gap-time). */
static inline double time_of_gap(const struct bonkers_body *left)
{
    const struct bonkers_body *right = left + 1;
    const double approach = left->v - right->v;
    const double t =
        left->since > right->since ? left->since : right->since;
    const double gap = position(right, t) - position(left, t);
    const double due[] = {INFINITY, t + (gap > 0 ? gap : 0) / approach};
    return due[approach > 0];
}

static inline double time_due(const struct bonkers *b, size_t i)
{
    return b->gravity > 0 ? weight_time_of_gap(b, i)
                          : time_of_gap(&b->body[i]);
}

/* Returns the state of body i at the time t, if the body does not collide
   before then. */
static inline struct bonkers_body body_at(const struct bonkers *b, size_t i,
                                          double t)
{
    struct bonkers_body a = b->body[i];
    if (b->gravity > 0)
        return weight_body_at(b, i, t);
    a.x = position(&a, t);
    a.since = t;
    return a;
}

/* Returns whether t is later than `before` by at most a rounding error. */
static inline bool same_time(double before, double t)
{
    return t - before <= 4 * DBL_EPSILON * t;
}

/* Returns how many collisions of a gap at the same clock reading count as a
   collapse. */
static inline uint32_t most_repeats(const struct bonkers *b)
{
    return BONKERS_REPEATS + (b->gaps < 200 ? (uint32_t)b->gaps : 200);
}

/* Counts a collision of gap i if the clock did not advance (`stands`), and
   otherwise resets the count. Returns true if the count is too high, or if
   the clock advanced but the bodies approach each other more slowly than
   BONKERS_SLOWEST. */
static inline bool count_repeat(struct bonkers *b, size_t i, bool stands,
                                double approach)
{
    if (!b->repeats)
        return false;
    b->repeats[i] = stands ? b->repeats[i] + 1 : 0;
    return b->repeats[i] >= most_repeats(b) ||
           (!stands && approach < BONKERS_SLOWEST);
}

/* Returns the fraction f of (1.12, eq:smaller), or NaN for two bodies of
   infinite mass. */
static inline double fraction(const struct bonkers *b, size_t i)
{
    const double left = b->body[i].im, right = b->body[i + 1].im;
    const double sum = left + right;
    return sum <= DBL_MAX ? (left < right ? left : right) / sum : NAN;
}

/* Changes the velocities of the bodies of gap i as collide does. */
static inline void exchange(struct bonkers *b, size_t i)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double f = b->fraction ? b->fraction[i] : fraction(b, i);
    const double change = (1 + b->restitution) * (left->v - right->v);
    const bool heavier = left->im >= right->im;
    double part[2];
    if (!(f >= 0))
        return;
    part[heavier] = change * f;
    part[!heavier] = change - part[heavier];
    left->v -= part[0];
    right->v += part[1];
}

/* Collides the bodies of gap i at the time when it closes. Returns whether
   the run ends as BONKERS_COLLAPSE. */
static inline bool collide_gap(struct bonkers *b, size_t i)
{
    if (b->gravity > 0)
        return weight_collide_gap(b, i);
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double t = b->due[i];
    const double l = position(left, t), r = position(right, t);
    const bool stands =
        same_time(left->since, t) && same_time(right->since, t);
    const double place[] = {r, l}, approach = left->v - right->v;
    left->x = right->x = place[fabs(left->v) < fabs(right->v)];
    left->since = right->since = b->now = t;
    exchange(b, i);
    return count_repeat(b, i, stands, approach);
}

/* Sets *low and *high to the first and last gap whose closing times change
   when gap i closes. */
static inline void find_changed(const struct bonkers *b, size_t i,
                                size_t *low, size_t *high)
{
    *low = i > 0 ? i - 1 : 0;
    *high = i + 1 < b->gaps ? i + 1 : i;
}

static inline void renew(struct bonkers *b, size_t i)
{
    size_t low, high;
    find_changed(b, i, &low, &high);
    for (size_t k = low; k <= high; ++k)
        b->due[k] = time_due(b, k);
}

#endif
