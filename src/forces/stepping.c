/* Allocates memory, takes steps, and checks that all numbers are finite. */
#include "forces/stepping.h"

#include "forces/adaptive.h"
#include "forces/steps.h"
#include "toolbox/aligned.h"

#include <stdlib.h>
#include <string.h>

static double *take(double **next, size_t n)
{
    double *const part = *next;
    *next += n;
    return part;
}

/* Divides one block of memory into arrays: first those that every method
   uses, then those that only one family of methods uses. For other families
   the latter have length 0. */
static void divide_memory(struct stepping *s, double *next)
{
    struct stepping_work *const w = s->part;
    const size_t n = s->forces.size, k = s->method->stages;
    s->carry = take(&next, 2 * n);
    s->acceleration = take(&next, n);
    w->x = take(&next, n);
    w->v = take(&next, n);
    w->drift = take(&next, s->method->drifts);
    w->kick = take(&next, s->method->drifts + 1);
    w->stage = take(&next, k * n);
    w->guess = take(&next, k * n);
    w->c = take(&next, k);
    w->a = take(&next, k * k);
    w->a2 = take(&next, k * k);
    w->b = take(&next, k);
    w->b2 = take(&next, k);
}

/* Returns the total length of the arrays of divide_memory. */
static size_t room(const struct stepping *s)
{
    const size_t n = s->forces.size, k = s->method->stages;
    return (5 + 2 * k) * n + 2 * s->method->drifts + 1 + 2 * k * k + 3 * k;
}

/* Multiplies the kicks and drifts of a splitting by dt. */
static void measure_kicks(struct stepping *s)
{
    const struct stepping_method *const m = s->method;
    for (size_t k = 0; k < m->drifts; ++k)
        s->part->drift[k] = m->drift[k] * s->dt;
    for (size_t k = 0; k <= m->drifts; ++k) {
        const double before = k ? m->drift[k - 1] : 0;
        const double after = k < m->drifts ? m->drift[k] : 0;
        s->part->kick[k] =
            (m->kick ? m->kick[k] : (before + after) / 2) * s->dt;
    }
}

/* Multiplies a tableau by dt and its square by dt^2: (8.10, eq:stage). */
static void measure_tableau(struct stepping *s)
{
    const struct stepping_method *const m = s->method;
    struct stepping_work *const w = s->part;
    const size_t n = m->stages;
    memset(w->c, 0, (2 * n + 3) * n * sizeof *w->c); /* all arrays from c to
                                                        b2 */
    for (size_t i = 0; i < n; ++i) {
        w->b[i] = m->b[i] * s->dt;
        for (size_t j = 0; j < n; ++j) {
            w->a[i * n + j] = m->a[i * n + j] * s->dt;
            w->c[i] += w->a[i * n + j];
        }
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j) {
            w->b2[j] += w->b[i] * w->a[i * n + j];
            for (size_t k = 0; k < n; ++k)
                w->a2[i * n + k] += w->a[i * n + j] * w->a[j * n + k];
        }
}

static void measure(struct stepping *s)
{
    if (s->method->family == STEPPING_SPLITTING)
        measure_kicks(s);
    else
        measure_tableau(s);
}

bool stepping_begin(struct stepping *s, const struct stepping_method *m,
                    struct stepping_forces f, double dt, double x[],
                    double v[])
{
    *s = (struct stepping){
        .method = m, .forces = f, .dt = dt, .x = x, .v = v};
    s->work = aligned_doubles(room(s));
    s->part = calloc(1, sizeof *s->part);
    if (!s->work || !s->part) {
        stepping_free(s);
        return false;
    }
    divide_memory(s, s->work);
    if (m->adaptive)
        s->own = adaptive_create(m, f);
    else
        measure(s);
    if (!m->adaptive || s->own)
        return true;
    stepping_free(s);
    return false;
}

void stepping_free(struct stepping *s)
{
    if (s->part) {
        free(s->part->matrix);
        free(s->part->pivot);
    }
    free(s->part);
    free(s->work);
    adaptive_free(s->own);
    *s = (struct stepping){0};
}

void stepping_resume(struct stepping *s, uint64_t steps,
                     const double carry[], const double acceleration[])
{
    const size_t n = s->forces.size;
    s->steps = steps;
    if (carry)
        memcpy(s->carry, carry, 2 * n * sizeof *carry);
    s->fresh = acceleration != NULL;
    if (acceleration)
        memcpy(s->acceleration, acceleration, n * sizeof *acceleration);
}

void stepping_disturb(struct stepping *s)
{
    s->fresh = false;
    if (s->own)
        s->own->begun = false;
}

bool stepping_is_leapfrog(const struct stepping_method *m)
{
    return m->family == STEPPING_SPLITTING && m->drifts == 1 && !m->kick &&
           !m->orbits;
}

bool stepping_keeps(const struct stepping *s)
{
    return s->forces.damped && stepping_is_leapfrog(s->method);
}

/* Takes a step of a method that is not adaptive. Returns false if the
   equations of an implicit step could not be solved. */
static bool step(struct stepping *s)
{
    switch (s->method->family) {
    case STEPPING_EXPLICIT: explicit_step(s); return true;
    case STEPPING_IMPLICIT: return implicit_step(s);
    default:
        if (stepping_keeps(s))
            leap_carried(s);
        else
            splitting_step(s);
        return true;
    }
}

/* Returns whether all coordinates and velocities are finite. Zero times a
   number is zero only if the number is finite. */
static bool is_finite(const struct stepping *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->forces.size; ++i)
        sum += 0 * s->x[i] + 0 * s->v[i];
    return sum == 0;
}

/* Takes at most *left steps, and subtracts them from *left. Stops where the
   state is next checked for infinite numbers. Returns false if the
   equations of a step could not be solved. */
static bool run_until_watch(struct stepping *s, uint64_t *left)
{
    const uint64_t most = STEPPING_WATCH - s->steps % STEPPING_WATCH;
    const uint64_t steps = *left < most ? *left : most;
    if (stepping_is_leapfrog(s->method) && !s->compensated) {
        leap(s, steps);
        s->steps += steps;
        *left -= steps;
        return true;
    }
    for (uint64_t k = 0; k < steps; ++k) {
        if (!step(s))
            return false;
        ++s->steps;
        --*left;
    }
    return true;
}

bool stepping_anew(struct stepping *s)
{
    const bool anew = !s->own->begun;
    if (anew)
        adaptive_begin(s->own, s->tolerance, s->dt, stepping_time(s), s->x,
                       s->v);
    return anew;
}

/* Lets an adaptive method take its own steps until `steps` intervals of dt
   have passed. dt only determines the times at which states are needed. */
static enum stepping_end run_own(struct stepping *s, uint64_t steps)
{
    struct adaptive *const own = s->own;
    const double t = s->start + (double)(s->steps + steps) * s->dt;
    const uint64_t before = own->evaluations;
    stepping_anew(s);
    const bool reached = adaptive_reach(own, t, s->x, s->v);
    s->evaluations += own->evaluations - before;
    if (!reached)
        return STEPPING_STUCK;
    s->steps += steps;
    return is_finite(s) ? STEPPING_DONE : STEPPING_INFINITE;
}

enum stepping_end stepping_run(struct stepping *s, uint64_t steps)
{
    if (s->own && steps > 0)
        return run_own(s, steps);
    while (steps > 0) {
        if (!run_until_watch(s, &steps))
            return is_finite(s) ? STEPPING_STUCK : STEPPING_INFINITE;
        if (!is_finite(s))
            return STEPPING_INFINITE;
    }
    return STEPPING_DONE;
}

/* Multiplies dt by the number of steps, because adding dt a million times
   would add a million rounding errors. */
double stepping_time(const struct stepping *s)
{
    return s->start + (double)s->steps * s->dt;
}

/* Copies carry and acceleration together, since they are adjacent in
   memory. */
void stepping_note(const struct stepping *s, double note[])
{
    const size_t n = s->forces.size;
    memcpy(note, s->x, n * sizeof *note);
    memcpy(note + n, s->v, n * sizeof *note);
    memcpy(note + 2 * n, s->carry, 3 * n * sizeof *note);
    note[5 * n] = s->fresh;
}

void stepping_recall(struct stepping *s, const double note[])
{
    const size_t n = s->forces.size;
    memcpy(s->x, note, n * sizeof *note);
    memcpy(s->v, note + n, n * sizeof *note);
    memcpy(s->carry, note + 2 * n, 3 * n * sizeof *note);
    s->fresh = note[5 * n] != 0;
}

/* Computes the coefficients, which contain the factor dt, for a step of
   length h. Afterwards computes them again for dt. */
enum stepping_end stepping_part(struct stepping *s, double h)
{
    const double dt = s->dt;
    s->dt = h;
    if (h != dt)
        measure(s);
    const bool good = step(s);
    s->dt = dt;
    if (h != dt)
        measure(s);
    if (!is_finite(s))
        return STEPPING_INFINITE;
    return good ? STEPPING_DONE : STEPPING_STUCK;
}
