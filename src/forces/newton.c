/* Solves for the stages of an implicit step by Newton's method. */
#include "forces/newton.h"

#include "forces/largest.h"
#include "forces/steps.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    DENSE = 1024, /* largest number of unknowns */
    MOST_CORRECTIONS = 50
};

/* Allocates the matrix at its first use, since most runs need none. Returns
   false if memory runs out or there are too many unknowns. */
static bool prepare(struct stepping *s)
{
    struct stepping_work *const w = s->part;
    const size_t n = s->method->stages * s->forces.size;
    if (n > DENSE)
        return false;
    if (!w->matrix)
        w->matrix = malloc((n * n + s->forces.size) * sizeof *w->matrix);
    if (!w->pivot)
        w->pivot = malloc((n + 1) * sizeof *w->pivot);
    if (w->matrix)
        w->slope = w->matrix + n * n;
    return w->matrix && w->pivot;
}

/* Exchanges row k with the row at or below it that has the largest
   absolute value in column k, so that elimination never divides by a
   needlessly small number. Returns the index of that row. */
static size_t fetch_pivot(double m[], size_t n, size_t k)
{
    size_t best = k;
    for (size_t i = k + 1; i < n; ++i)
        if (fabs(m[i * n + k]) > fabs(m[best * n + k]))
            best = i;
    for (size_t j = 0; j < n && best != k; ++j) {
        const double other = m[k * n + j];
        m[k * n + j] = m[best * n + j];
        m[best * n + j] = other;
    }
    return best;
}

/* Replaces the n x n matrix m by its factors L and U. row[k] becomes the
   index that fetch_pivot returned for k. Returns false if m is singular. */
static bool factor(double m[], size_t n, size_t row[])
{
    for (size_t k = 0; k < n; ++k) {
        row[k] = fetch_pivot(m, n, k);
        if (!(fabs(m[k * n + k]) > 0))
            return false;
        for (size_t i = k + 1; i < n; ++i) {
            const double f = m[i * n + k] /= m[k * n + k];
            for (size_t j = k + 1; f != 0 && j < n; ++j)
                m[i * n + j] -= f * m[k * n + j];
        }
    }
    return true;
}

/* Replaces y by the solution z of m z = y, with m and row[] from factor. */
static void substitute(const double m[], size_t n, const size_t row[],
                       double y[])
{
    for (size_t k = 0; k < n; ++k) {
        const double other = y[row[k]];
        y[row[k]] = y[k];
        y[k] = other;
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < i; ++j)
            y[i] -= m[i * n + j] * y[j];
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; ++j)
            y[i] -= m[i * n + j] * y[j];
        y[i] /= m[i * n + i];
    }
}

/* Subtracts from the matrix the derivatives of the accelerations at stage i
   with respect to q, which is coordinate k or its velocity. q has been
   displaced by d. by[i * stages + j] is the weight of the acceleration of
   stage j in q. */
static void add_slope(struct stepping *s, size_t i, size_t k,
                      const double by[], double d)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size, stages = s->method->stages;
    const size_t all = n * stages;
    evaluate(s, w->x, w->v, w->slope);
    for (size_t r = 0; r < n; ++r) {
        const double slope = (w->slope[r] - w->guess[i * n + r]) / d;
        for (size_t j = 0; j < stages; ++j)
            w->matrix[(i * n + r) * all + j * n + k] -=
                slope * by[i * stages + j];
    }
}

/* Enters into the matrix the derivatives at stage i with respect to
   coordinate k, which is displaced by dx. If the forces depend on
   velocities, also enters the derivatives with respect to the velocity of
   coordinate k. */
static void displace(struct stepping *s, size_t i, size_t k, double dx)
{
    const struct stepping_work *const w = s->part;
    const double x = w->x[k], v = w->v[k], dv = dx / fabs(s->dt);
    w->x[k] = x + dx;
    add_slope(s, i, k, w->a2, w->x[k] - x);
    w->x[k] = x;
    if (s->forces.damped) {
        w->v[k] = v + dv;
        add_slope(s, i, k, w->a, w->v[k] - v);
        w->v[k] = v;
    }
}

/* Computes the matrix of Newton's method, (8.12, eq:newton), at the current
   stages, and factors it. The displacements are 2^-26 of the size of the
   system, about the square root of the rounding error. Half of the digits
   of the derivatives are then correct. This suffices because the matrix
   affects only the speed of convergence. */
static bool linearize(struct stepping *s)
{
    struct stepping_work *const w = s->part;
    const size_t n = s->forces.size, all = s->method->stages * n;
    memset(w->matrix, 0, all * all * sizeof *w->matrix);
    sweep(s);
    for (size_t i = 0; i < s->method->stages; ++i) {
        go_to_stage(s, i);
        const double reach =
            largest(w->x, n) + largest(w->v, n) * fabs(s->dt);
        for (size_t k = 0; k < n; ++k) {
            displace(s, i, k, (reach > 0 ? reach : 1) * 0x1p-26);
            w->matrix[(i * n + k) * (all + 1)] += 1;
        }
    }
    return factor(w->matrix, all, w->pivot);
}

/* Corrects all accelerations once. Returns the largest component of the
   correction. */
static double correct(struct stepping *s)
{
    struct stepping_work *const w = s->part;
    const size_t all = s->method->stages * s->forces.size;
    sweep(s);
    for (size_t i = 0; i < all; ++i)
        w->guess[i] -= w->stage[i];
    substitute(w->matrix, all, w->pivot, w->guess);
    add(w->stage, 1, w->guess, all);
    return largest(w->guess, all);
}

/* Keeps the matrix as long as each correction is less than a tenth of the
   previous one. The solution is accepted once corrections have stopped
   decreasing and are as small as rounding errors.

   `rounding` bounds these errors where forces cancel, as near an
   equilibrium, so that the accelerations themselves are no measure of them.
   An error of eps |x| in the positions changes the solution by up to J eps
   |x|/(1 + J dt^2/12), where J is the stiffness per mass. This is less than
   12 eps |x|/dt^2. */
bool newton_solve(struct stepping *s)
{
    double last = INFINITY, change = INFINITY;
    const double rounding =
        64 * DBL_EPSILON * largest(s->x, s->forces.size) / (s->dt * s->dt);
    if (!prepare(s))
        return false;
    for (int k = 0; k < MOST_CORRECTIONS; ++k) {
        if (!(change < last / 10) && !linearize(s))
            return false;
        last = change;
        change = correct(s);
        if (settled(s, change, last) ||
            (change > last / 2 && change <= rounding))
            return true;
    }
    return false;
}
