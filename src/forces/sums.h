/* Adds to many coordinates or velocities at once, compensated or not. */
#ifndef SUMS_H
#define SUMS_H

#include "forces/stepping.h"
#include "toolbox/vector.h"

#include <stddef.h>

/* Adds h * by[i] to each to[i]. */
static inline void add(double *restrict to, double h,
                       const double *restrict by, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        to[i] += h * by[i];
}

/* Adds `by` to a compensated sum and returns the sum: (8.14,
   eq:compensated). The rounding error is stored in *carry and added the
   next time. */
static inline double add_one(double *to, double *carry, double by)
{
    const double old = *to, more = by + *carry, sum = old + more;
    *carry = more - (sum - old);
    return *to = sum;
}

/* Like add, but with compensated sums. */
static inline void add_carried(double *restrict to, double *restrict carry,
                               double h, const double *restrict by,
                               size_t n)
{
    for (size_t i = 0; i < n; ++i)
        add_one(to + i, carry + i, h * by[i]);
}

enum { MANY = 64 }; /* fewest coordinates for which vectors save time */

/* Like add, or like add_carried if carry is not NULL; vectorised. */
VECTOR_LOOP static void add_many(double *restrict to, double *carry,
                                 double h, const double *restrict by,
                                 size_t n)
{
    if (carry)
        add_carried(to, carry, h, by, n);
    else
        add(to, h, by, n);
}

/* Like add_many, for any number of coordinates. */
static inline void push(double *to, double *carry, double h,
                        const double by[], size_t n)
{
    if (n >= MANY)
        add_many(to, carry, h, by, n);
    else if (carry)
        add_carried(to, carry, h, by, n);
    else
        add(to, h, by, n);
}

/* Add h * by[] to the positions or velocities of s, with compensated sums
   if s->compensated is true. */
static void push_x(struct stepping *s, double h, const double by[])
{
    push(s->x, s->compensated ? s->carry : NULL, h, by, s->forces.size);
}

static void push_v(struct stepping *s, double h, const double by[])
{
    const size_t n = s->forces.size;
    push(s->v, s->compensated ? s->carry + n : NULL, h, by, n);
}

#ifdef VECTOR_CLONES
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));

/* Like add_one, but adds to four sums at once and sets *by to the sums.
   Each sum is rounded separately, so the bits are those of add_one. */
static inline void add_four(double *to, double *carry, four *by)
{
    const four old = *(four *)to, more = *by + *(four *)carry;
    *by = old + more;
    *(four *)carry = more - (*by - old);
    *(four *)to = *by;
}
#endif

/* Kicks by h and, unless dt is NULL, drifts by *dt, with compensated sums.
   The accelerations have just been stored one by one, and loading four at
   once would wait about eleven cycles for these stores. The array is
   therefore volatile, so that each acceleration is loaded alone. */
VECTOR_LOOP static void advance_carried(struct stepping *s, double h,
                                        const double *dt)
{
    const size_t n = s->forces.size;
    double *const x = s->x, *const v = s->v;
    double *const owed_x = s->carry, *const owed_v = s->carry + n;
    const volatile double *const a = s->acceleration;
    size_t i = 0;
#ifdef VECTOR_CLONES
    for (; i + 3 < n; i += 4) {
        four by = h * (four){a[i], a[i + 1], a[i + 2], a[i + 3]};
        add_four(v + i, owed_v + i, &by);
        if (dt) {
            by *= *dt;
            add_four(x + i, owed_x + i, &by);
        }
    }
#endif
    for (; i < n; ++i) {
        const double now = add_one(v + i, owed_v + i, h * a[i]);
        if (dt)
            add_one(x + i, owed_x + i, *dt * now);
    }
}

/* Kicks by h and, unless dt is NULL, drifts by *dt, in one pass. For three
   bodies the forces take about 130 cycles, and a second pass would take
   another ten. */
static inline void advance(struct stepping *s, double h, const double *dt)
{
    const size_t n = s->forces.size;
    double *restrict const x = s->x, *restrict const v = s->v;
    if (s->compensated) {
        advance_carried(s, h, dt);
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        v[i] += h * s->acceleration[i];
        if (dt)
            x[i] += *dt * v[i];
    }
}

#endif
