/* Steps two bodies under gravity, with their coordinates in registers. */
#include "forces/twobody.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* A pair of adjacent numbers, one for each body, such as a coordinate. The
   operations and their order are those of the loops for many bodies, but
   here the numbers stay in registers. Passing them through memory would
   take a sixth of the time of a step, since a step of two bodies is little
   more than a square root and a division, one after the other. */
typedef double pair __attribute__((vector_size(16), aligned(8), may_alias));

/* The motion of both bodies along one axis: coordinates, velocities,
   accelerations, durations of half a kick (0 for a body fixed along this
   axis), and uniform gravity. */
struct axis {
    pair x, v, a, kick, weight;
};

/* Does the first half of the next kick and the drift, as in steps.h. If
   `owing` is true, first does the second half of the last kick. Returns the
   difference of the bodies' coordinates twice, as a pair. */
static inline pair move(struct axis *k, double dt, bool owing)
{
    const pair half = k->kick * k->a;
    if (owing)
        k->v += half;
    k->v += half;
    k->x += dt * k->v;
    return (pair){k->x[1], k->x[1]} - (pair){k->x[0], k->x[0]};
}

/* Takes steps of leapfrog, with the forces of add_pairs in pull.h. If
   `plain` is true (see is_plain), omits the three operations that only add
   0. A step is a chain of sixteen operations, each of which waits for the
   one before, so this saves an eighth of the time. */
static void run_two(const struct gravity *g, double dt, uint64_t steps,
                    struct axis axis[3], bool plain)
{
    const double k2 = g->k2, least = g->softening * g->softening;
    const pair mass = {g->mass[1], -g->mass[0]};
    struct axis z = axis[2], y = axis[1], x = axis[0];
    for (uint64_t k = 0; k < steps; ++k) {
        const pair dx = move(&x, dt, k > 0), dy = move(&y, dt, k > 0);
        pair dz, square = dx * dx + dy * dy;
        if (!plain) {
            dz = move(&z, dt, k > 0);
            square = square + dz * dz + least;
        }
        const double s = square[0], w = k2 / (s * sqrt(s));
        const pair pull = w * mass;
        x.a = pull * dx;
        y.a = pull * dy;
        if (!plain) {
            z.a = z.weight + pull * dz;
            x.a += x.weight;
            y.a += y.weight;
        }
    }
    if (plain) {
        x.a += x.weight;
        y.a += y.weight;
    }
    axis[0] = x;
    axis[1] = y;
    axis[2] = z;
}

/* Returns whether both numbers are +0. */
static bool is_nothing(pair p)
{
    return memcmp(&p, &(pair){0, 0}, sizeof p) == 0;
}

static bool has_minus_zero(pair p)
{
    return (p[0] == 0 && signbit(p[0])) || (p[1] == 0 && signbit(p[1]));
}

/* Returns whether the bodies are in the plane z = 0, without softening and
   uniform gravity, so that run_two may omit the additions of 0. Such an
   addition changes no bits except those of -0, which it turns into +0.
   Velocities must therefore not begin as -0, and they never become -0
   later. For the accelerations, 0 is added after the loop. */
static bool is_plain(const struct gravity *g, const struct axis axis[3])
{
    const struct axis *x = axis, *y = axis + 1, *z = axis + 2;
    return g->softening == 0 && is_nothing(x->weight) &&
           is_nothing(y->weight) && is_nothing(z->weight) &&
           is_nothing(z->x) && is_nothing(z->v) && is_nothing(z->a) &&
           !has_minus_zero(x->v) && !has_minus_zero(y->v);
}

void twobody_sweep(const struct gravity *g, const struct stepping *s,
                   const double weight[3], const size_t held[],
                   size_t fixed, double a[], uint64_t steps)
{
    const double half = s->dt / 2;
    double kick[] = {half, half, half, half, half, half};
    struct axis axis[3];
    for (size_t j = 0; j < fixed; ++j)
        kick[held[j]] = 0;
    for (size_t k = 0; k < 3; ++k)
        axis[k] = (struct axis){*(const pair *)(s->x + 2 * k),
                                *(const pair *)(s->v + 2 * k),
                                *(pair *)(a + 2 * k),
                                *(pair *)(kick + 2 * k),
                                {weight[k], weight[k]}};
    run_two(g, s->dt, steps, axis, is_plain(g, axis));
    for (size_t k = 0; k < 3; ++k) {
        *(pair *)(s->x + 2 * k) = axis[k].x;
        *(pair *)(s->v + 2 * k) = axis[k].v;
        *(pair *)(a + 2 * k) = axis[k].a;
    }
    for (size_t j = 0; j < fixed; ++j)
        a[held[j]] = 0;
}
