/* Adds gravity: the line is a vertical wire, with a floor as left wall. */

/* Two falling bodies collide at the same time as they would without
   gravity. Only a collision with a body at rest, a floor or a roof, needs a
   square root (chapter 5, section Weight). Nothing else in the engines
   changes. A run without gravity does not call these functions. */
#include "line/weight.h"

#include "line/collide.h"
#include "line/engine.h"
#include "line/fall.h"
#include "line/gap.h"

#include <float.h>
#include <math.h>

/* Returns whether a body does not fall because it is a wall or lies on the
   floor. The radii have been subtracted, so all bodies of a pile at rest
   are at the position of the floor with velocity 0. */
static bool rests(const struct bonkers *b, const struct bonkers_body *a)
{
    return a->im == 0 || (a->v == 0 && a->x <= b->body[0].x);
}

struct bonkers_body weight_body_at(const struct bonkers *b, size_t i,
                                   double t)
{
    struct bonkers_body a = b->body[i];
    const double wait = t - a.since, g = b->gravity;
    if (!rests(b, &a)) {
        a.x += (a.v - g * wait / 2) * wait;
        a.v -= g * wait;
    }
    a.since = t;
    return a;
}

/* The positions and velocities of both bodies are computed for the later of
   their two times, as in time_of_gap. Gravity does not change the relative
   velocity of two falling bodies (exercise 05b). A body at rest is a floor
   or a roof for the other body. */
double weight_time_of_gap(const struct bonkers *b, size_t i)
{
    const double t = fmax(b->body[i].since, b->body[i + 1].since);
    const struct bonkers_body left = weight_body_at(b, i, t);
    const struct bonkers_body right = weight_body_at(b, i + 1, t);
    const bool held = rests(b, &b->body[i]);
    const double gap = right.x - left.x, approach = left.v - right.v;
    if (held != rests(b, &b->body[i + 1]))
        return t + (held ? fall_to_floor(gap, right.v, b->gravity)
                         : fall_to_roof(gap, left.v, b->gravity));
    if (!(approach > 0))
        return INFINITY;
    return gap > 0 ? t + gap / approach : t;
}

/* Moves the bodies of gap i, one of which rests, into contact at the time
   t, s. The clock is rounded, so a body reaches the floor a little early or
   late. So its velocity there is computed from its energy and not from the
   time. A bounce then conserves the energy up to rounding. */
static void land(struct bonkers *b, size_t i, double t)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double gap = right->x - left->x;
    if (rests(b, left)) {
        right->v = -fall_speed(gap, right->v, b->gravity);
        right->x = left->x;
    } else {
        left->v = fall_speed(-gap, left->v, b->gravity);
        left->x = right->x;
    }
    left->since = right->since = t;
}

/* For bodies in a pile, the limit on collisions at the same clock reading
   is PILE times higher. Each bounce of an upper body sets all bodies below
   it in motion, and these must come to rest first. With restitution 1/2 one
   ball needs fifty bounces, two balls need hundreds, and three need
   thousands, many of them at the same clock reading. With nine balls no
   factor would be enough. */
enum { PILE = 1000 };

/* Returns whether a body is at the floor, up to rounding. */
static bool is_low(const struct bonkers *b, const struct bonkers_body *a)
{
    return fabs(a->x - b->body[0].x) <= 4 * DBL_EPSILON * b->extent;
}

/* Stops a body on the floor if its next bounce would be shorter than the
   clock can resolve. */
static void stop_bouncing(const struct bonkers *b, struct bonkers_body *a)
{
    const double flight = 2 * fabs(a->v) / b->gravity;
    if (b->restitution < 1 && is_low(b, a) &&
        same_time(a->since, a->since + flight)) {
        a->x = b->body[0].x;
        a->v = 0;
    }
}

/* The clock is rounded, so two falling bodies collide a little late, when
   they overlap, or a little early, when they do not yet touch. collide_gap
   moves both to the same position. Under gravity this would change the
   energy, since moving a body lifts or lowers it. The errors would add up
   in a random walk: to 2e-9 of the energy in ten million collisions, or to
   1e-11 if the position is the centre of mass. However, the overlap shows
   how late the collision is. So each body is moved to the position that it
   would have if it had turned at the right moment. This does not move the
   centre of mass, and makes the positions eighty times more accurate. */
bool weight_collide_gap(struct bonkers *b, size_t i)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double t = b->due[i];
    const bool stands =
        same_time(left->since, t) && same_time(right->since, t);
    if (rests(b, left) != rests(b, right)) {
        land(b, i, t);
    } else {
        *left = weight_body_at(b, i, t);
        *right = weight_body_at(b, i + 1, t);
    }
    const double v = left->v, w = right->v;
    const double late = v > w ? (left->x - right->x) / (v - w) : 0;
    collide(&left->v, &right->v, left->im, right->im, b->restitution);
    left->x += (left->v - v) * late;
    right->x += (right->v - w) * late;
    stop_bouncing(b, left);
    stop_bouncing(b, right);
    b->now = t;
    const bool pile = is_low(b, right); /* then the left body is low, too */
    return count_repeat(b, i, stands, INFINITY) &&
           (!pile || b->repeats[i] >= PILE * most_repeats(b));
}

enum bonkers_stop weight_run_naive(struct bonkers *b, double until,
                                   uint64_t limit)
{
    for (;;) {
        for (size_t i = 0; i < b->gaps; ++i)
            b->due[i] = weight_time_of_gap(b, i);
        const size_t i = schedule_scan(b->due, b->gaps);
        const double t = fmin(b->due[i], until);
        for (size_t k = 0; k <= b->gaps && t < INFINITY; ++k)
            b->body[k] = weight_body_at(b, k, t);
        if (b->due[i] > until || b->due[i] == INFINITY)
            return engine_idle(b, until);
        const bool collapse = weight_collide_gap(b, i);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}
