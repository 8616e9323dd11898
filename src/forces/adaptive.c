/* Adaptive steps of an embedded 5(4) pair and of Radau's method. */
#include "forces/adaptive.h"

#include "forces/largest.h"
#include "toolbox/aligned.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STAGES = 7, MOST_ROUNDS = 12 };

/* Weights computed from a method's coefficients, for a step of length 1. */
struct adaptive_weights {
    /* For an embedded pair: c[i] is the sum of row i of a[], and a2,
       error2 and dense2 are the products of a, error and dense with a. */
    double c[STAGES], a2[STAGES][STAGES];
    double error2[STAGES], dense2[STAGES];
    /* For Radau's method: what the coefficient g_(k+1) = 1 contributes at
       node i + 1, whose time is c. The displacement is c^2 x[i][k], and
       the change of velocity is c v[i][k]. */
    double x[STAGES][STAGES], v[STAGES][STAGES];
    double gap[STAGES][STAGES]; /* 1 / (c_(i+1) - c_j) */
    double last[STAGES];        /* 1 / (1 - c_(j+1)) */
    double amplified; /* largest change of g_8 if each force changes by 1 */
    double power[STAGES][STAGES];  /* coefficient of s^(m+1) in N_(k+1) */
    double newton[STAGES][STAGES]; /* coefficient of N_(m+1) in s^(k+1) */
    double binomial[STAGES][STAGES];
};

static double power_of(double z, int n)
{
    double power = 1;
    for (int k = 0; k < n; ++k)
        power *= z;
    return power;
}

/* Returns the n-th root of z > 0, with a relative error of at most a few
   millionths. Newton's method uses only + - * /, so the result is the same
   on every machine. The last bit of a library function depends on the
   machine and would change all later steps. The iteration starts above the
   root and decreases towards it. */
static double root(double z, int n)
{
    double y = z > 1 ? z : 1, down;
    do {
        down = (y - z / power_of(y, n - 1)) / n;
        y -= down;
    } while (down > 1e-3 * y);
    return y;
}

#define SAFETY 0.75
#define LEAST 0.2
#define MOST 5.0

/* Returns the ratio of the next step to the last one: (8.16, eq:stretch).
   `error` is the error of the last step divided by the allowed error. It is
   proportional to the n-th power of the step length. */
static double stretch(double error, int n)
{
    if (error <= power_of(SAFETY / MOST, n))
        return MOST;
    if (!(error < power_of(SAFETY / LEAST, n)))
        return LEAST;
    return SAFETY / root(error, n);
}

static void evaluate(struct adaptive *s, const double x[], const double v[],
                     double a[])
{
    s->forces.accelerate(s->forces.what, x, v, a);
    ++s->evaluations;
}

/* Returns whether the method chooses the length of its steps. */
static bool is_free(const struct adaptive *s)
{
    return s->tolerance > 0;
}

/* Computes to = from + by as a compensated sum: `carry` has the old
   rounding errors, and `owed` receives the new ones. With few, large steps,
   these sums would otherwise be the main source of rounding errors. */
static void add(double *restrict to, double *restrict owed,
                const double *restrict from, const double *restrict carry,
                const double *restrict by, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const double more = by[i] + carry[i];
        to[i] = from[i] + more;
        owed[i] = more - (to[i] - from[i]);
    }
}

/* Computes the end of a trial step, s->to plus the changes place[] and
   speed[]. Writes it over s->from, the beginning of the last step, which
   is no longer needed because the requested time is after that step. */
static void arrive(struct adaptive *s)
{
    const size_t n = s->forces.size;
    struct adaptive_state *const end = &s->from;
    add(end->x, end->carry, s->to.x, s->to.carry, s->place, n);
    add(end->v, end->carry + n, s->to.v, s->to.carry + n, s->speed, n);
}

static void measure_pair(struct adaptive *s)
{
    const struct stepping_method *const m = s->method;
    struct adaptive_weights *const w = s->weights;
    const size_t n = m->stages;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j) {
            const double a = m->a[i * n + j];
            w->c[i] += a;
            w->error2[j] += m->error[i] * a;
            w->dense2[j] += m->dense[i] * a;
            for (size_t k = 0; k < n; ++k)
                w->a2[i][k] += a * m->a[j * n + k];
        }
}

/* Returns the sum, weighted with by[], of the accelerations of coordinate k
   at the first `stages` stages. */
static double mix(const struct adaptive *s, const double by[],
                  size_t stages, size_t k)
{
    double sum = 0;
    for (size_t j = 0; j < stages; ++j)
        sum += by[j] * s->stage[j * s->forces.size + k];
    return sum;
}

/* Computes the displacements and the changes of velocity from the beginning
   of a step of length h to its stage i: (8.10, eq:stage). */
static void move_to_stage(struct adaptive *s, size_t i, double h)
{
    const struct adaptive_weights *const w = s->weights;
    const double *const a = s->method->a + i * s->method->stages;
    for (size_t k = 0; k < s->forces.size; ++k) {
        s->place[k] =
            w->c[i] * h * s->to.v[k] + h * h * mix(s, w->a2[i], i, k);
        s->speed[k] = h * mix(s, a, i, k);
    }
}

/* Returns the estimated relative error of a trial step: (8.15,
   eq:embedded). It is the error of the positions or that of the velocities,
   whichever is larger. */
static double error_of_pair(const struct adaptive *s, double h)
{
    const size_t n = s->forces.size, stages = s->method->stages;
    const double x = larger(largest(s->to.x, n), largest(s->from.x, n));
    const double v = larger(largest(s->to.v, n), largest(s->from.v, n));
    double dx = 0, dv = 0;
    for (size_t k = 0; k < n; ++k) {
        dx = larger(dx, fabs(mix(s, s->weights->error2, stages, k)));
        dv = larger(dv, fabs(mix(s, s->method->error, stages, k)));
    }
    return larger(dx == 0 ? 0 : h * h * dx / x, dv == 0 ? 0 : h * dv / v);
}

/* Tries a step of length h and returns its error divided by the tolerance.
   The first stage is the beginning of the step, already computed as the end
   of the last step. The last stage is the end of the step. */
static double try_pair(struct adaptive *s, double h)
{
    const size_t n = s->forces.size, last = s->method->stages - 1;
    memcpy(s->stage, s->to.a, n * sizeof *s->stage);
    for (size_t i = 1; i < last; ++i) {
        move_to_stage(s, i, h);
        for (size_t k = 0; k < n; ++k) {
            s->place[k] += s->to.x[k];
            s->speed[k] += s->to.v[k];
        }
        evaluate(s, s->place, s->speed, s->stage + i * n);
    }
    move_to_stage(s, last, h);
    arrive(s);
    evaluate(s, s->from.x, s->from.v, s->from.a);
    memcpy(s->stage + last * n, s->from.a, n * sizeof *s->stage);
    return error_of_pair(s, h) / s->tolerance;
}

/* Returns the value of a coordinate at the fraction r of a step: (8.17,
   eq:dense). p and q are the values at the two ends of the step, dp and dq
   the derivatives there times the step length. `mixed` is the contribution
   of the stages. */
static double look_between(double r, double p, double q, double dp,
                           double dq, double mixed)
{
    const double rest = 1 - r, d = q - p;
    return p + r * (d + rest * (rest * (dp - d) - r * (dq - d) +
                                r * rest * mixed));
}

/* Computes positions and velocities at the fraction r of the last step. */
static void look_in_pair(const struct adaptive *s, double r, double x[],
                         double v[])
{
    const struct adaptive_state *const p = &s->from, *const q = &s->to;
    const size_t stages = s->method->stages;
    const double h = s->h;
    for (size_t k = 0; k < s->forces.size; ++k) {
        x[k] = look_between(r, p->x[k], q->x[k], h * p->v[k], h * q->v[k],
                            h * h * mix(s, s->weights->dense2, stages, k));
        v[k] = look_between(r, p->v[k], q->v[k], h * p->a[k], h * q->a[k],
                            h * mix(s, s->method->dense, stages, k));
    }
}

/* Returns node c_i as a fraction of the step. c_0 is 0; the method lists
   c_1 to c_7.

   Radau's method writes the acceleration during a step as a_0 + sum g_k
   N_k(s), k = 1 to 7, where s is the fraction of the step. The Newton
   polynomial N_k = s (s - c_1) ... (s - c_(k-1)) is zero at all nodes
   before node k. The force at node k therefore determines g_k without
   changing the values at earlier nodes. */
static double node(const struct adaptive *s, size_t i)
{
    return i > 0 ? s->method->node[i - 1] : 0;
}

/* Computes power[][] from N_(k+1) = (s - c_k) N_k, and newton[][] from s
   N_k = N_(k+1) + c_k N_k. Sets binomial[k][m] to the binomial coefficient
   "k + 1 choose m + 1". */
static void measure_polynomials(struct adaptive *s)
{
    struct adaptive_weights *const w = s->weights;
    w->power[0][0] = w->newton[0][0] = 1;
    for (size_t k = 0; k + 1 < STAGES; ++k)
        for (size_t m = 0; m <= k + 1; ++m) {
            const double c = node(s, k + 1), d = node(s, m + 1);
            w->power[k + 1][m] = (m > 0 ? w->power[k][m - 1] : 0) -
                                 (m <= k ? c * w->power[k][m] : 0);
            w->newton[k + 1][m] = (m > 0 ? w->newton[k][m - 1] : 0) +
                                  (m <= k ? d * w->newton[k][m] : 0);
        }
    for (size_t k = 0; k < STAGES; ++k)
        for (size_t m = 0; m <= k; ++m)
            w->binomial[k][m] = m == 0 ? (double)k + 1
                                       : w->binomial[k][m - 1] *
                                             (double)(k + 1 - m) /
                                             (double)(m + 1);
}

/* Returns the product of the distances of node i from all other nodes,
   where node 8 is the end of the step. If the force at node i changes by d,
   g_8 changes by d divided by this product. */
static double product_of_gaps(const struct adaptive *s, size_t i)
{
    double product = 1;
    for (size_t j = 0; j <= STAGES + 1; ++j)
        if (j != i)
            product *= fabs((i > STAGES ? 1 : node(s, i)) -
                            (j > STAGES ? 1 : node(s, j)));
    return product;
}

/* Computes the weights of Radau's method by integrating each N_k once and
   twice from 0 to each node. The two integrals of s^(m+1) are s^(m+2) /
   (m+2) and s^(m+3) / ((m+2) (m+3)). */
static void measure_radau(struct adaptive *s)
{
    struct adaptive_weights *const w = s->weights;
    measure_polynomials(s);
    for (size_t i = 0; i < STAGES; ++i) {
        const double c = node(s, i + 1);
        for (size_t k = 0; k < STAGES; ++k) {
            double power = 1;
            for (size_t m = 0; m <= k; ++m) {
                const double n = (double)m;
                power *= c;
                w->v[i][k] += w->power[k][m] * power / (n + 2);
                w->x[i][k] += w->power[k][m] * power / ((n + 2) * (n + 3));
            }
            if (k <= i)
                w->gap[i][k] = 1 / (c - node(s, k));
        }
        w->last[i] = 1 / (1 - c);
    }
    for (size_t i = 0; i <= STAGES + 1; ++i)
        w->amplified += 1 / product_of_gaps(s, i);
}

/* Returns the displacement of a body during the time `part`. v and a are
   its velocity and acceleration at the beginning. change * part^2 is the
   change of the acceleration, integrated twice. Small terms are added
   first. A rounded constant c^2 / 2 is avoided because it would cause the
   same error in all steps. */
static inline double way(double part, double v, double a, double change)
{
    return part * (v + part * (a / 2 + change));
}

/* Computes the displacements and the changes of velocity in a part of a
   step from the coefficients g. With scalar code, an 81-node membrane
   spent nine tenths of its run in these sums. Vector code more than halves
   the time of a step. */
VECTOR_LOOP static void lead(double *restrict place, double *restrict speed,
                             const double *restrict g,
                             const struct adaptive_state *start,
                             const double x[], const double v[],
                             double part, size_t n)
{
    const double *const restrict sv = start->v;
    const double *const restrict sa = start->a;
    for (size_t k = 0; k < n; ++k) {
        double dx = x[STAGES - 1] * g[(STAGES - 1) * n + k];
        double dv = v[STAGES - 1] * g[(STAGES - 1) * n + k];
        for (size_t j = STAGES - 1; j-- > 0;) {
            dx += x[j] * g[j * n + k];
            dv += v[j] * g[j * n + k];
        }
        place[k] = way(part, sv[k], sa[k], dx);
        speed[k] = part * (sa[k] + dv);
    }
}

static void move_to_node(struct adaptive *s, size_t i, double h)
{
    lead(s->place, s->speed, s->g, &s->to, s->weights->x[i],
         s->weights->v[i], h * node(s, i + 1), s->forces.size);
}

/* Sets by = from + (owed + by), where `owed` has the rounding errors of the
   compensated sums. Without `owed`, all forces of a step would be computed
   at rounded positions. */
VECTOR_LOOP static void start_from(double *restrict by,
                                   const double *restrict from,
                                   const double *restrict owed, size_t n)
{
    for (size_t k = 0; k < n; ++k)
        by[k] = from[k] + (owed[k] + by[k]);
}

/* Sets d = (d - g) * gap, one step of a table of divided differences. */
VECTOR_LOOP static void divide(double *restrict d, const double *restrict g,
                               double gap, size_t n)
{
    for (size_t k = 0; k < n; ++k)
        d[k] = (d[k] - g[k]) * gap;
}

/* Computes the forces at node i. Sets the coefficients of node i in g from
   the divided differences of all forces up to this node. Returns the
   largest change of a coefficient. */
static double correct_node(struct adaptive *s, size_t i)
{
    const double *const gap = s->weights->gap[i];
    const size_t n = s->forces.size;
    const struct adaptive_state *const p = &s->to;
    double *const d = s->difference, *const g = s->g + i * n;
    start_from(s->place, p->x, p->carry, n);
    start_from(s->speed, p->v, p->carry + n, n);
    evaluate(s, s->place, s->speed, s->stage + i * n);
    memcpy(d, s->stage + i * n, n * sizeof *d);
    divide(d, p->a, gap[0], n);
    for (size_t j = 0; j < i; ++j)
        divide(d, s->g + j * n, gap[j + 1], n);
    const double most = largest_difference(d, g, n);
    memcpy(g, d, n * sizeof *g);
    return most;
}

/* Writes into to[] coefficient m of a polynomial in a new basis: the sum,
   over all k >= m, of the old coefficient k times by[k][m]. */
VECTOR_LOOP static void turn_one(double *restrict to,
                                 const double *restrict from,
                                 double by[STAGES][STAGES], size_t m,
                                 size_t n)
{
    for (size_t i = 0; i < n; ++i)
        to[i] = 0;
    for (size_t k = STAGES; k-- > m;)
        for (size_t i = 0; i < n; ++i)
            to[i] += by[k][m] * from[k * n + i];
}

static void turn(double to[], const double from[],
                 double by[STAGES][STAGES], size_t n)
{
    for (size_t m = 0; m < STAGES; ++m)
        turn_one(to + m * n, from, by, m, n);
}

VECTOR_LOOP static void guess_one(double *restrict new_b,
                                  double *restrict new_guess,
                                  const double *restrict b,
                                  const double *restrict guess,
                                  double power, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        new_guess[i] *= power;
        new_b[i] = new_guess[i] + (b[i] - guess[i]);
    }
}

/* Guesses the force in the next step, of length h, by extrapolating the
   polynomial of the last step. q is the ratio of the two lengths. The
   fraction s of the new step is the fraction 1 + q s of the old step, so
   the new coefficient of s^m is q^m sum_k binomial(k, m) b_k. The error of
   the last guess is added because the new error is likely to be similar. */
static void guess_force(struct adaptive *s, double h)
{
    const size_t n = s->forces.size;
    const double q = s->whole > 0 ? h / s->whole : 0;
    double power = 1;
    turn(s->new_guess, s->b, s->weights->binomial, n);
    for (size_t m = 0; m < STAGES; ++m) {
        power *= q;
        guess_one(s->new_b + m * n, s->new_guess + m * n, s->b + m * n,
                  s->guess + m * n, power, n);
    }
    turn(s->g, s->new_b, s->weights->newton, n);
}

#define RADAU_SCALE 50 /* found by experiment, not derived */

/* Returns whether the iteration may end: the change of g_7 is less than the
   tolerance or has stopped decreasing. The seventh difference amplifies
   rounding errors of the force about a thousandfold, so any change below
   1e-11 counts as rounding. */
static bool settled(const struct adaptive *s, double change, double last)
{
    return change <= 1e-11 + s->tolerance || !(change < last);
}

/* Sets *to = from + by + small, and *owed to its rounding error. `small`
   contains the old rounding error and the contribution of the second
   doubles of the weights (methods.c). It is less than the last digit of the
   sum and would be lost in every step, so it is first added to the rounding
   error of from + by. The formula for this error is exact whichever term is
   larger. */
static void add_tail(double *to, double *owed, double from, double by,
                     double small)
{
    const double sum = from + by, added = sum - from;
    small += (from - (sum - added)) + (by - added);
    *to = sum + small;
    *owed = small - (*to - sum);
}

/* Computes the state at the end of the whole step from the weighted sums of
   the forces. For the circumbinary planet with a tolerance of 1e-14, the
   energy then changes by only about 1e-19 per step on average. The rounding
   of the forces adds a random change of 1.5e-16 per step. */
static void move_to_end(struct adaptive *s, double h)
{
    const struct adaptive_state *const p = &s->to, *const q = &s->from;
    const size_t n = s->forces.size;
    for (size_t k = 0; k < n; ++k) {
        size_t i = STAGES;
        double x = 0, v = 0, dx = 0, dv = 0;
        while (i-- > 0) {
            const double *const w = s->method->weight + 4 * i;
            const double a = s->stage[i * n + k] - p->a[k];
            v += w[0] * a, dv += w[1] * a;
            x += w[2] * a, dx += w[3] * a;
        }
        add_tail(&q->x[k], &q->carry[k], p->x[k],
                 way(h, p->v[k], p->a[k], x), p->carry[k] + h * (h * dx));
        add_tail(&q->v[k], &q->carry[n + k], p->v[k], h * (p->a[k] + v),
                 p->carry[n + k] + h * dv);
    }
}

/* Returns the scale of the accelerations in a step: the largest at its
   start or, if this is almost zero, as in the middle of an oscillation, the
   largest along the step. */
static double scale_of(double start, double along)
{
    const double scale = start > 1e-6 * along ? start : along;
    return scale > 0 ? scale : 1;
}

/* Returns the largest g_8, the coefficient obtained by using the end of the
   step as an eighth node. In a smooth step it is smaller than g_7. Without
   g_8, step control may miss a jump of the force after the seventh node,
   which is at 0.977 of the step. The force of a spring jumps when its ends
   pass through each other; about one in fifty such jumps was missed. */
static double beyond(struct adaptive *s)
{
    const size_t n = s->forces.size;
    double *const d = s->difference;
    memcpy(d, s->from.a, n * sizeof *d);
    divide(d, s->to.a, 1, n);
    for (size_t j = 0; j < STAGES; ++j)
        divide(d, s->g + j * n, s->weights->last[j], n);
    return largest(d, n);
}

/* Tries a step of length h, usually in three iterations. Returns its error
   divided by the largest error that the tolerance allows. If the tolerance
   is 0, the result has no meaning. */
static double try_radau(struct adaptive *s, double h)
{
    const size_t n = s->forces.size, last = STAGES - 1;
    const double start = largest(s->to.a, n);
    double change = INFINITY, along = 0, scale = 1, before;
    guess_force(s, h);
    for (int round = 0; round < MOST_ROUNDS; ++round) {
        before = change;
        for (size_t i = 0; i < STAGES; ++i) {
            move_to_node(s, i, h);
            change = correct_node(s, i);
            along = fmax(along, largest(s->stage + i * n, n));
        }
        scale = scale_of(start, along);
        change /= scale;
        if (settled(s, change, round > 1 ? before : INFINITY))
            break;
    }
    turn(s->new_b, s->g, s->weights->power, n);
    move_to_end(s, h);
    evaluate(s, s->from.x, s->from.v, s->from.a);
    const double off = larger(largest(s->g + last * n, n), beyond(s));
    return (off - s->noise) / scale / (RADAU_SCALE * sqrt(s->tolerance));
}

/* At every sixteenth step, measures how much rounding errors contribute to
   g_8 (see beyond).

   The force of a stiff spring that is hardly stretched is its stiffness
   times a small difference of two positions. With 5e7 N/m and a total
   acceleration of 10 m/s^2, a change in the last bit of a position changes
   the force by 1e-9 of its value, and the seven differences amplify this a
   thousandfold. Shorter steps do not reduce this noise, so step control
   would shorten them endlessly.

   The forces are therefore computed once more, with the last bits of
   positions and velocities changed alternately up and down. This costs less
   than half a per cent of all evaluations.

   The noise is stored as an acceleration, not as a fraction of the total
   acceleration. For a body at rest on its spring, that fraction would be
   large, so the steps would become too long and the body would
   oscillate. */
static void measure_noise(struct adaptive *s)
{
    const size_t n = s->forces.size;
    if (s->method->family != STEPPING_RADAU || !is_free(s) ||
        s->taken % 16 != 0)
        return;
    for (size_t k = 0; k < n; ++k) {
        const double by = 1 + (k % 2 ? 0x1p-52 : -0x1p-52);
        s->place[k] = s->to.x[k] * by;
        s->speed[k] = s->to.v[k] * by;
    }
    evaluate(s, s->place, s->speed, s->difference);
    s->noise = s->weights->amplified *
               largest_difference(s->difference, s->to.a, n);
}

/* Returns whether a step of the shortest possible length h may be accepted
   although it exceeds the tolerance. This is so if its forces change the
   velocities by at most 1e-9 of the largest velocity: the force then jumps
   here, and the step may cross the jump. Where two bodies fall into each
   other, the change is larger, and the run ends. */
static bool is_edge(const struct adaptive *s, double h)
{
    const size_t n = s->forces.size;
    const double a = larger(largest(s->from.a, n), largest(s->to.a, n));
    return h * a <= 1e-9 * largest(s->to.v, n);
}

/* Computes positions and velocities at the fraction r of the last step of
   Radau's method, by Horner's rule. */
static void look_in_radau(const struct adaptive *s, double r, double x[],
                          double v[])
{
    const size_t n = s->forces.size;
    const struct adaptive_state *const p = &s->from;
    const double part = s->whole * r;
    for (size_t i = 0; i < n; ++i) {
        double dx = 0, dv = 0;
        for (int k = STAGES - 1; k >= 0; --k) {
            const double b = s->b[(size_t)k * n + i];
            dx = (dx + b / ((k + 2) * (k + 3))) * r;
            dv = (dv + b / (k + 2)) * r;
        }
        x[i] = p->x[i] + way(part, p->v[i], p->a[i], dx);
        v[i] = p->v[i] + part * (p->a[i] + dv);
    }
}

static void swap(double **a, double **b)
{
    double *const other = *a;
    *a = *b;
    *b = other;
}

/* Accepts a trial step of length h as the last step. The time, too, is a
   compensated sum. Otherwise the rounding errors of many short steps near a
   star would add up. */
static void accept(struct adaptive *s, double h)
{
    const struct adaptive_state end = s->from;
    const double more = h + s->owed, t = s->t + more;
    s->past = s->t;
    s->past_owed = s->owed;
    s->from = s->to;
    s->to = end;
    swap(&s->b, &s->new_b);
    swap(&s->guess, &s->new_guess);
    s->owed = more - (t - s->t);
    s->t = t;
    s->h = s->whole = h;
    ++s->taken;
    if (!is_free(s))
        s->t = s->start + (double)(s->taken - s->before) * s->dt;
    if (s->shortest == 0 || h < s->shortest)
        s->shortest = h;
}

/* Limits the next step to `most` (in s). Neither this limit nor the first
   step depends on the tolerance, so runs with different tolerances might
   take equal steps. If two such runs are to be compared, set s->slack in
   one of them. */
static void bound(struct adaptive *s, double most)
{
    s->next = fmin(s->next, (1 - s->slack) * most);
}

/* Takes a step. Returns false if even the shortest step that changes t
   exceeds the tolerance, or if s->evaluations already exceeds s->most. */
static bool step(struct adaptive *s)
{
    const bool radau = s->method->family == STEPPING_RADAU,
               free = is_free(s);
    const double least = 4 * 0x1p-52 * fabs(s->t);
    if (s->most > 0 && s->evaluations > s->most)
        return false;
    if (s->longest)
        bound(s, s->longest(s->with, s->to.x, s->to.v, s->to.a));
    measure_noise(s);
    for (bool again = false;; again = true, ++s->refused) {
        const double h = free ? fmax(s->next, least) : s->dt;
        if (!(s->t + h > s->t))
            return false;
        const double error = radau ? try_radau(s, h) : try_pair(s, h);
        const double by = stretch(error, radau ? 7 : 5);
        s->next = h * (again && by > 1 ? 1 : by);
        if (!free || error <= 1 || (h <= least && is_edge(s, h))) {
            accept(s, h);
            return true;
        }
        if (h <= least)
            return false;
    }
}

/* Returns a guess of the first step (in s), which step control will adapt.
   It is a hundredth of the smallest of x/v, sqrt(x/a) and v/a, where x, v
   and a are the largest coordinate, velocity and acceleration. */
static double first_length(const struct adaptive *s)
{
    const size_t n = s->forces.size;
    const double x = largest(s->to.x, n), v = largest(s->to.v, n);
    const double a = largest(s->to.a, n);
    double h = s->dt;
    if (x > 0 && v > 0)
        h = x / v;
    if (x > 0 && a > 0 && !(h * h * a < x))
        h = sqrt(x / a);
    if (v > 0 && a > 0 && !(h * a < v))
        h = v / a;
    return h / 100;
}

/* Computes the first forces and proposes a first step, unless the run has
   already begun. */
static void set_out(struct adaptive *s)
{
    if (s->begun)
        return;
    evaluate(s, s->to.x, s->to.v, s->to.a);
    s->next = (1 - s->slack) * first_length(s);
    s->begun = true;
}

void adaptive_look(const struct adaptive *s, double t, double x[],
                   double v[])
{
    const size_t size = s->forces.size * sizeof *x;
    const double back = s->t - t;
    if (back == 0 || s->h == 0) {
        memcpy(x, s->to.x, size);
        memcpy(v, s->to.v, size);
    } else if (s->method->family == STEPPING_RADAU)
        look_in_radau(s, (s->h - back) / s->whole, x, v);
    else
        look_in_pair(s, (s->h - back) / s->h, x, v);
}

bool adaptive_reach(struct adaptive *s, double t, double x[], double v[])
{
    set_out(s);
    while (s->t < t)
        if (!step(s))
            return false;
    adaptive_look(s, t, x, v);
    return true;
}

void adaptive_begin(struct adaptive *s, double tolerance, double dt,
                    double t, const double x[], const double v[])
{
    const size_t n = s->forces.size, all = n * s->method->stages;
    s->tolerance = tolerance;
    s->dt = dt;
    s->t = s->start = t;
    s->before = s->taken;
    s->owed = s->h = s->whole = 0;
    s->begun = false;
    memcpy(s->to.x, x, n * sizeof *x);
    memcpy(s->to.v, v, n * sizeof *v);
    memset(s->to.carry, 0, 2 * n * sizeof *x);
    memset(s->b, 0, all * sizeof *x);
    memset(s->guess, 0, all * sizeof *x);
}

enum { NOTED = 14 }; /* how many numbers precede the arrays in note[] */

size_t adaptive_notes(const struct adaptive *s)
{
    const size_t lists = s->method->family == STEPPING_RADAU ? 2 : 1;
    return NOTED + (8 + lists * s->method->stages) * s->forces.size;
}

/* Copies n numbers from own[] to note[] or, if `back` is true, from note[]
   to own[]. Returns the address after these numbers in note[]. */
static double *pass(double *note, double *own, size_t n, bool back)
{
    memcpy(back ? own : note, back ? note : own, n * sizeof *note);
    return note + n;
}

/* Copies the arrays of the state to note[] or, if `back` is true, from
   note[]. Both ends of the last step are copied, since the next requested
   time may lie within this step. An embedded pair also needs its stages.
   Radau's method also needs its polynomial and the last guess of it, from
   which it guesses the next polynomial. */
static void pass_lists(const struct adaptive *s, double *note, bool back)
{
    const size_t n = s->forces.size, all = n * s->method->stages;
    const struct adaptive_state *const p = &s->from, *const q = &s->to;
    double *const list[] = {p->x, p->v, p->a, q->x, q->v, q->a};
    for (size_t k = 0; k < sizeof list / sizeof *list; ++k)
        note = pass(note, list[k], n, back);
    note = pass(note, q->carry, 2 * n, back);
    if (s->method->family == STEPPING_RADAU)
        pass(pass(note, s->b, all, back), s->guess, all, back);
    else
        pass(note, s->stage, all, back);
}

void adaptive_note(const struct adaptive *s, double note[])
{
    const double counts[] = {(double)s->taken, (double)s->refused,
                             (double)s->evaluations};
    const double own[] = {s->tolerance,      s->dt,    s->t,    s->h,
                          s->shortest,       s->start, s->owed, s->next,
                          (double)s->before, s->noise};
    note[0] = s->begun;
    memcpy(note + 1, counts, sizeof counts);
    memcpy(note + 4, own, sizeof own);
    pass_lists(s, note + NOTED, false);
}

void adaptive_recall(struct adaptive *s, const double note[])
{
    s->begun = note[0] != 0;
    s->taken = (uint64_t)note[1], s->refused = (uint64_t)note[2];
    s->evaluations = (uint64_t)note[3];
    s->tolerance = note[4], s->dt = note[5];
    s->t = note[6], s->h = note[7], s->shortest = note[8];
    s->start = note[9], s->owed = note[10], s->next = note[11];
    s->before = (uint64_t)note[12];
    s->noise = note[13];
    s->whole = s->h;
    pass_lists(s, (double *)note + NOTED, true);
}

static double *take(double **next, size_t n)
{
    double *const part = *next;
    *next += n;
    return part;
}

static struct adaptive_state take_state(double **next, size_t n)
{
    return (struct adaptive_state){take(next, n), take(next, n),
                                   take(next, n), take(next, 2 * n)};
}

static void divide_memory(struct adaptive *s, double *next)
{
    const size_t n = s->forces.size, all = n * s->method->stages;
    s->from = take_state(&next, n);
    s->to = take_state(&next, n);
    s->place = take(&next, n);
    s->speed = take(&next, n);
    s->difference = take(&next, n);
    s->stage = take(&next, all);
    s->g = take(&next, all);
    s->b = take(&next, all);
    s->guess = take(&next, all);
    s->new_b = take(&next, all);
    s->new_guess = take(&next, all);
}

struct adaptive *adaptive_create(const struct stepping_method *m,
                                 struct stepping_forces f)
{
    struct adaptive *const s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->method = m;
    s->forces = f;
    s->work = aligned_doubles((13 + 6 * m->stages) * f.size);
    s->weights = calloc(1, sizeof *s->weights);
    if (!s->work || !s->weights) {
        adaptive_free(s);
        return NULL;
    }
    divide_memory(s, s->work);
    if (m->family == STEPPING_RADAU)
        measure_radau(s);
    else
        measure_pair(s);
    return s;
}

void adaptive_free(struct adaptive *s)
{
    if (s) {
        free(s->weights);
        free(s->work);
    }
    free(s);
}
bool adaptive_step(struct adaptive *s, double most)
{
    set_out(s);
    bound(s, most);
    return step(s);
}

/* Writes the control points q[] of the path of coordinate i along a step of
   Radau's method. The path is a polynomial in u, the fraction of the step.
   Its term with u^m contributes to the control points j >= m with the
   weight binomial(j, m) / binomial(9, m). */
static void path_of_radau(const struct adaptive *s, size_t i, double q[])
{
    enum { DEGREE = ADAPTIVE_DEGREE };
    const size_t n = s->forces.size;
    const double h = s->h, part = h / s->whole;
    double power[DEGREE + 1] = {s->from.x[i], h * s->from.v[i],
                                h * h * s->from.a[i] / 2};
    double scale = h * h;
    for (size_t m = 0; m < STAGES; ++m) {
        scale *= part;
        power[m + 3] =
            scale * s->b[m * n + i] / (double)((m + 2) * (m + 3));
    }
    for (size_t j = 0; j <= DEGREE; ++j) {
        double weight = 1;
        q[j] = 0;
        for (size_t m = 0; m <= j; ++m) {
            q[j] += weight * power[m];
            weight *= (double)(j - m) / (double)(DEGREE - m);
        }
    }
}

/* Writes the control points q[] of the path of coordinate i along a step of
   an embedded pair: (8.17, eq:dense). The path is the cubic Hermite
   polynomial, written with degree 4. The weights for dense output correct
   its middle control point. */
static void path_of_pair(const struct adaptive *s, size_t i, double q[])
{
    const double h = s->h, *weights = s->weights->dense2;
    const double p[] = {s->from.x[i], s->from.x[i] + h * s->from.v[i] / 3,
                        s->to.x[i] - h * s->to.v[i] / 3, s->to.x[i]};
    q[0] = p[0];
    q[1] = (p[0] + 3 * p[1]) / 4;
    q[2] = (p[1] + p[2]) / 2 +
           h * h * mix(s, weights, s->method->stages, i) / 6;
    q[3] = (3 * p[2] + p[3]) / 4;
    q[4] = p[3];
}

size_t adaptive_path(const struct adaptive *s, double control[])
{
    const bool radau = s->method->family == STEPPING_RADAU;
    for (size_t i = 0; i < s->forces.size; ++i) {
        double *const q = control + (ADAPTIVE_DEGREE + 1) * i;
        if (radau)
            path_of_radau(s, i, q);
        else
            path_of_pair(s, i, q);
    }
    return radau ? ADAPTIVE_DEGREE : 4;
}

/* Exchanges the ends of the last step, to repeat it from its beginning. */
static void turn_round(struct adaptive *s)
{
    const struct adaptive_state end = s->to;
    s->to = s->from;
    s->from = end;
}

/* Copies s->to to s->from, as after a step of length 0. */
static void stay(struct adaptive *s)
{
    const size_t size = s->forces.size * sizeof *s->to.x;
    memcpy(s->from.x, s->to.x, size);
    memcpy(s->from.v, s->to.v, size);
    memcpy(s->from.a, s->to.a, size);
    memcpy(s->from.carry, s->to.carry, 2 * size);
}

void adaptive_again(struct adaptive *s, double h, double x[], double v[])
{
    const double more = h + s->past_owed;
    turn_round(s);
    if (!(h > 0))
        stay(s);
    else if (s->method->family == STEPPING_RADAU)
        try_radau(s, h);
    else
        try_pair(s, h);
    turn_round(s);
    s->h = h;
    s->t = s->past + more;
    s->owed = more - (s->t - s->past);
    memcpy(x, s->to.x, s->forces.size * sizeof *x);
    memcpy(v, s->to.v, s->forces.size * sizeof *v);
}

/* Starts again from x and v, but keeps the proposed length of the next
   step. The force of the last step is not used for a guess, since it cannot
   be extrapolated across a jump in velocity. */
void adaptive_turn(struct adaptive *s, const double x[], const double v[])
{
    const double t = s->t, next = s->next;
    adaptive_begin(s, s->tolerance, s->dt, t, x, v);
    evaluate(s, s->to.x, s->to.v, s->to.a);
    s->next = next;
    s->begun = true;
}
