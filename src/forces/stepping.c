/* From chapters/08-stepping.nw: edit there, then run make tangle. */
/* checksum 1508378213 of the lines below */
/* Steps by kicks and drifts and by Runge-Kutta stages. */
#include "forces/stepping.h"

#include "forces/adaptive.h"
#include "forces/largest.h"
#include "toolbox/room.h"
#include "toolbox/vector.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double leapfrog[] = {1};
static const double symplectic_euler_drift[] = {1};
static const double symplectic_euler_kick[] = {1, 0};

/* 1 / (2 - cbrt(2)), and 1 minus twice that: (8.8, eq:triple-jump). */
static const double yoshida4[] = {1.3512071919596576340476878,
                                  -1.7024143839193152680953756,
                                  1.3512071919596576340476878};

/* Solution A of Yoshida (1990), with the digits of Hairer, Lubich and
   Wanner (2006). */
static const double yoshida6[] = {
    0.78451361047755726381949763,  0.23557321335935813368479318,
    -1.17767998417887100694641568, 1.31518632068391121888424973,
    -1.17767998417887100694641568, 0.23557321335935813368479318,
    0.78451361047755726381949763};

/* Omelyan, Mryglod and Folk (2002). */
#define XI 0.1786178958448091
#define LAMBDA (-0.2123418310626054)
#define CHI (-0.06626458266981849)
static const double pefrl_drift[] = {XI, CHI, 1 - 2 * (CHI + XI), CHI, XI};
static const double pefrl_kick[] = {0,      0.5 - LAMBDA, LAMBDA,
                                    LAMBDA, 0.5 - LAMBDA, 0};

/* Kahan and Li (1997), s17odr8a. */
static const double kahan_li8[] = {
    0.13020248308889008087881763,  0.56116298177510838456196441,
    -0.38947496264484728640807860, 0.15884190655515560089621075,
    -0.39590389413323757733623154, 0.18453964097831570709183254,
    0.25837438768632204729397911,  0.29501172360931029887096624,
    -0.60550853383003451169892108, 0.29501172360931029887096624,
    0.25837438768632204729397911,  0.18453964097831570709183254,
    -0.39590389413323757733623154, 0.15884190655515560089621075,
    -0.38947496264484728640807860, 0.56116298177510838456196441,
    0.13020248308889008087881763};

/* Laskar and Robutel (2001), SBAB4: 1/2 - sqrt(3/28), sqrt(3/28). */
static const double sbab4_drift[] = {
    0.17267316464601142810085377, 0.32732683535398857189914623,
    0.32732683535398857189914623, 0.17267316464601142810085377};
static const double sbab4_kick[] = {0.05, 49.0 / 180, 16.0 / 45, 49.0 / 180,
                                    0.05};

static const double euler_a[] = {0}, euler_b[] = {1};
static const double rk4_a[] = {0, 0,   0, 0, 0.5, 0, 0, 0,
                               0, 0.5, 0, 0, 0,   0, 1, 0};
static const double rk4_b[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
#define ROOT 0.28867513459481288225457439 /* sqrt(3) / 6 */
static const double gauss4_a[] = {0.25, 0.25 - ROOT, 0.25 + ROOT, 0.25};
static const double gauss4_b[] = {0.5, 0.5};
static const double midpoint_a[] = {0.5}, midpoint_b[] = {1};

/* Dormand and Prince (1980): order 5, and 4 less the errors; dense weights
   of Shampine's, as Hairer, Norsett and Wanner have them. */
static const double dopri5_a[] = {
    /* 1 */
    0, 0, 0, 0, 0, 0, 0,
    /* 2 */
    1.0 / 5, 0, 0, 0, 0, 0, 0,
    /* 3 */
    3.0 / 40, 9.0 / 40, 0, 0, 0, 0, 0,
    /* 4 */
    44.0 / 45, -56.0 / 15, 32.0 / 9, 0, 0, 0, 0,
    /* 5 */
    19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729, 0, 0, 0,
    /* 6 */
    9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656,
    0, 0,
    /* 7: where the step ends */
    35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0};
static const double dopri5_error[] = {
    71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
    -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
static const double dopri5_dense[] = {
    -12715105075.0 / 11282082432.0,  0,
    87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0};

static const double radau15_node[] = {
    0.056262560536922146465652191, 0.18024069173689236498757994,
    0.35262471711316963737390777,  0.54715362633055538300144856,
    0.73421017721541053152321061,  0.88532094683909576809035976,
    0.9775206135612875018911745};
static const double radau15_weight[] = {
    0.092679077401489687,  -6.9250597277834874e-19,
    0.08746471519868225,   1.2569814901812666e-18,
    0.15206531032339249,   -8.8887147275770614e-18,
    0.12465695360151906,   -3.2610478412430061e-18,
    0.18825877269455937,   7.3918563114457673e-18,
    0.12187407622906785,   -1.4568205914722731e-18,
    0.19578608372624673,   -6.629769515866781e-18,
    0.088661018030373115,  -2.849144709811723e-19,
    0.17350739781725066,   -5.6404902537018522e-18,
    0.046116500517662307,  -1.7533680008796797e-18,
    0.1248239506649325,    2.4388028082745613e-18,
    0.014314692474057891,  -2.5942757406741163e-22,
    0.057254407372128585,  1.0940827035134911e-18,
    0.0012870439486375449, -1.824978039945946e-20};

#define LENGTH(list) (sizeof(list) / sizeof *(list))
#define COMPOSED(m)                                                        \
    .family = STEPPING_SPLITTING, .drifts = LENGTH(m),                     \
    .stages = LENGTH(m), .drift = m
#define SPLITTING(m)                                                       \
    .family = STEPPING_SPLITTING, .drifts = LENGTH(m##_drift),             \
    .drift = m##_drift, .kick = m##_kick
#define EXPLICIT(m)                                                        \
    .family = STEPPING_EXPLICIT, .stages = LENGTH(m##_b), .a = m##_a,      \
    .b = m##_b
#define IMPLICIT(m)                                                        \
    .family = STEPPING_IMPLICIT, .stages = LENGTH(m##_b), .a = m##_a,      \
    .b = m##_b
#define PAIR(m)                                                            \
    .family = STEPPING_PAIR, .stages = LENGTH(m##_error), .a = m##_a,      \
    .error = m##_error, .dense = m##_dense, .adaptive = true
#define RADAU(m)                                                           \
    .family = STEPPING_RADAU, .stages = LENGTH(m##_node),                  \
    .node = m##_node, .weight = m##_weight, .adaptive = true

const struct stepping_method stepping_methods[STEPPING_MOST + 1] = {
    {"euler", "straight on, and outwards", EXPLICIT(euler), .order = 1,
     .limit = 0},
    {"symplectic-euler", "a kick, then a drift",
     SPLITTING(symplectic_euler), .order = 1, .symplectic = true,
     .stages = 1, .limit = 2},
    {"leapfrog", "a drift between half kicks", COMPOSED(leapfrog),
     .order = 2, .symmetric = true, .symplectic = true, .limit = 2,
     .raced = true},
    {"rk4", "Runge and Kutta's", EXPLICIT(rk4), .order = 4,
     .limit = 2.8284271247461901},
    {"yoshida4", "leapfrogs, the triple jump", COMPOSED(yoshida4),
     .order = 4, .symmetric = true, .symplectic = true,
     .limit = 1.5734019474345401},
    {"yoshida6", "seven leapfrogs", COMPOSED(yoshida6), .order = 6,
     .symmetric = true, .symplectic = true, .limit = 2.2690579963976594,
     .raced = true},
    {"pefrl", "four kicks, small errors", SPLITTING(pefrl), .order = 4,
     .symmetric = true, .symplectic = true, .stages = 4,
     .limit = 2.9894495459067291, .raced = true},
    {"kahan-li8", "seventeen leapfrogs", COMPOSED(kahan_li8), .order = 8,
     .symmetric = true, .symplectic = true, .limit = 3.0964386800007322,
     .raced = true},
    {"implicit-midpoint", "for stiff springs", IMPLICIT(midpoint),
     .order = 2, .symmetric = true, .symplectic = true, .limit = INFINITY},
    {"gauss4", "for stiff springs, finer", IMPLICIT(gauss4), .order = 4,
     .symmetric = true, .symplectic = true, .limit = INFINITY},
    {"wisdom-holman", "leapfrog along ellipses", COMPOSED(leapfrog),
     .order = 2, .symmetric = true, .symplectic = true, .limit = 2,
     .orbits = true, .raced = true},
    {"sbab4", "the same, for small masses", SPLITTING(sbab4), .order = 2,
     .symmetric = true, .symplectic = true, .stages = 4,
     .limit = 2.9971371204864101, .orbits = true, .raced = true},
    {"dopri5", "steps of its own length", PAIR(dopri5), .order = 5,
     .raced = true},
    {"radau15", "such steps, to the last digits", RADAU(radau15),
     .order = 15, .raced = true}};

const struct stepping_method *stepping_find(const char *name)
{
    const struct stepping_method *m = stepping_methods;
    while (m->name && strcmp(m->name, name))
        ++m;
    return m->name ? m : NULL;
}

const struct stepping_method *stepping_next(const struct stepping_method *m)
{
    m = m ? m + 1 : stepping_methods;
    while (m->name && (m->orbits || m->adaptive))
        ++m;
    return m->name ? m : NULL;
}

enum { DENSE = 1024 }; /* unknowns for which Newton's method is tried */

/* What the methods work with. */
struct stepping_work {
    double *drift, *kick;        /* of a splitting, s */
    double *c, *a, *a2, *b, *b2; /* of a tableau, times dt or dt^2 */
    double *stage;               /* [stages * size] their accelerations */
    double *guess;               /* [stages * size] the next ones */
    double *x, *v;               /* [size] at a stage */
    double *matrix, *slope;      /* of Newton's method */
    size_t *pivot;
};

/* How many of the n doubles at *next: they are passed over. */
static double *take(double **next, size_t n)
{
    double *const part = *next;
    *next += n;
    return part;
}

static void share_out(struct stepping *s, double *next)
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

static size_t room(const struct stepping *s)
{
    const size_t n = s->forces.size, k = s->method->stages;
    return (5 + 2 * k) * n + 2 * s->method->drifts + 1 + 2 * k * k + 3 * k;
}

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

static void measure_tableau(struct stepping *s)
{
    const struct stepping_method *const m = s->method;
    struct stepping_work *const w = s->part;
    const size_t n = m->stages;
    memset(w->c, 0, (2 * n + 3) * n * sizeof *w->c); /* up to b2 */
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
    s->work = room_doubles(room(s));
    s->part = calloc(1, sizeof *s->part);
    if (!s->work || !s->part) {
        stepping_free(s);
        return false;
    }
    share_out(s, s->work);
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

/* Newton's method needs room of its own, and few systems do. */
static bool prepare_newton(struct stepping *s)
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

static void evaluate(struct stepping *s, const double x[], const double v[],
                     double a[])
{
    s->forces.accelerate(s->forces.what, x, v, a);
    ++s->evaluations;
}

static void refresh(struct stepping *s)
{
    if (!s->fresh)
        evaluate(s, s->x, s->v, s->acceleration);
    s->fresh = true;
}

/* Adds h by[i] to to[i]. */
static inline void add(double *restrict to, double h,
                       const double *restrict by, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        to[i] += h * by[i];
}

/* Adds `by` and what the sum owes, (8.14, eq:compensated); returns the
   sum. */
static inline double add_one(double *to, double *carry, double by)
{
    const double old = *to, more = by + *carry, sum = old + more;
    *carry = more - (sum - old);
    return *to = sum;
}

static inline void add_carried(double *restrict to, double *restrict carry,
                               double h, const double *restrict by,
                               size_t n)
{
    for (size_t i = 0; i < n; ++i)
        add_one(to + i, carry + i, h * by[i]);
}

enum { MANY = 64 }; /* coordinates */

VECTOR_LOOP static void add_many(double *restrict to, double *carry,
                                 double h, const double *restrict by,
                                 size_t n)
{
    if (carry)
        add_carried(to, carry, h, by, n);
    else
        add(to, h, by, n);
}

/* carry: NULL, or what the sums owe. */
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

static void push_x(struct stepping *s, double h, const double by[])
{
    push(s->x, s->compensated ? s->carry : NULL, h, by, s->forces.size);
}

static void push_v(struct stepping *s, double h, const double by[])
{
    const size_t n = s->forces.size;
    push(s->v, s->compensated ? s->carry + n : NULL, h, by, n);
}

/* Half the kick finds the velocity that the other evaluation needs. */
static void kick_damped(struct stepping *s, double h)
{
    double *const middle = s->part->v;
    evaluate(s, s->x, s->v, s->acceleration);
    for (size_t i = 0; i < s->forces.size; ++i)
        middle[i] = s->v[i] + h / 2 * s->acceleration[i];
    evaluate(s, s->x, middle, s->acceleration);
    push_v(s, h, s->acceleration);
}

static void kick(struct stepping *s, double h)
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

static void drift(struct stepping *s, double h)
{
    if (s->flow)
        s->flow(s->forces.what, h, s->x, s->v);
    else
        push_x(s, h, s->v);
    s->fresh = false;
}

#ifdef VECTOR_CLONES
typedef double four __attribute__((vector_size(32), aligned(8), may_alias));

/* add_one for four; *by becomes the sums. */
static inline void add_four(double *to, double *carry, four *by)
{
    const four old = *(four *)to, more = *by + *(four *)carry;
    *by = old + more;
    *(four *)carry = more - (*by - old);
    *(four *)to = *by;
}
#endif

/* Kicks by h, and drifts by *dt unless that is NULL, with what the sums
   owe. */
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

static void advance(struct stepping *s, double h, const double *dt)
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

/* Kick number k and the drift behind it, but for the last kick. */
static void kick_and_drift(struct stepping *s, size_t k)
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

static void splitting_step(struct stepping *s)
{
    for (size_t k = 0; k <= s->method->drifts; ++k)
        kick_and_drift(s, k);
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

/* Half a kick and the drift of n coordinates; first the half kick that is
   owing. */
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

/* The same from coordinate number `from` on. */
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

static void set_out(void *stepping, size_t from, size_t n, bool owing)
{
    if (n < MANY)
        move(stepping, from, n, owing);
    else
        move_many(stepping, from, n, owing);
}

/* Steps of leapfrog, (8.4, eq:verlet), to the bits of splitting_step; under
   friction those of (8.13, eq:leapfrog-damped). */
static void leap(struct stepping *s, uint64_t steps)
{
    const double *const v = s->forces.damped ? s->part->v : s->v;
    refresh(s);
    if (s->sweep) {
        s->sweep(s->forces.what, s->x, v, s->acceleration,
                 &(struct stepping_ahead){set_out, s}, steps);
        s->evaluations += steps;
    } else
        for (uint64_t k = 0; k < steps; ++k) {
            set_out(s, 0, s->forces.size, k > 0);
            evaluate(s, s->x, v, s->acceleration);
        }
    add(s->v, s->part->kick[0], s->acceleration, s->forces.size);
}

/* A step under friction, compensated. */
static void leap_carried(struct stepping *s)
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

/* Where stage i is, (8.10, eq:stage): x and v of the work. */
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

/* The step itself, once the stages are known. */
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

static void explicit_step(struct stepping *s)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i) {
        go_to_stage(s, i);
        evaluate(s, w->x, w->v, w->stage + i * n);
    }
    close_step(s);
}

/* Brings the row with the largest number of column k, at or below row k, to
   row k; returns where it was. */
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

/* Finds the factors L and U of m, n by n, in its place; row[k] is where
   the k-th pivot was. False: there is none. */
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

/* Replaces y by the solution of m z = y. */
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

enum { MOST_SWEEPS = 100, MOST_CORRECTIONS = 50 };

/* The forces at all stages, into guess. */
static void sweep(struct stepping *s)
{
    const struct stepping_work *const w = s->part;
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i) {
        go_to_stage(s, i);
        evaluate(s, w->x, w->v, w->guess + i * n);
    }
}

/* Whether a change is the last: none, or as small as rounding makes them
   and no longer falling. */
static bool settled(const struct stepping *s, double change, double last)
{
    const size_t n = s->forces.size;
    const double scale = largest(s->part->stage, s->method->stages * n) +
                         largest(s->v, n) / fabs(s->dt);
    return change == 0 || (change > last / 2 && change <= 1e-10 * scale);
}

/* All stages begin with the acceleration before the step. */
static void guess_stages(struct stepping *s)
{
    const size_t n = s->forces.size;
    for (size_t i = 0; i < s->method->stages; ++i)
        memcpy(s->part->stage + i * n, s->acceleration,
               n * sizeof *s->acceleration);
}

/* Puts what the forces are at the stages in the place of what they were
   thought to be, again and again. False: that does not lead anywhere. */
static bool iterate(struct stepping *s)
{
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

/* Adds to the matrix what coordinate k of stage i, displaced by d, does:
   `by` for each stage j is how much of acceleration j goes there. */
static void enter_slope(struct stepping *s, size_t i, size_t k,
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

/* Displaces coordinate k of stage i, and its velocity if that counts. */
static void displace(struct stepping *s, size_t i, size_t k, double dx)
{
    const struct stepping_work *const w = s->part;
    const double x = w->x[k], v = w->v[k], dv = dx / fabs(s->dt);
    w->x[k] = x + dx;
    enter_slope(s, i, k, w->a2, w->x[k] - x);
    w->x[k] = x;
    if (s->forces.damped) {
        w->v[k] = v + dv;
        enter_slope(s, i, k, w->a, w->v[k] - v);
        w->v[k] = v;
    }
}

/* The matrix of Newton's method, (8.12, eq:newton), at the stages as they
   are now. */
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

/* One correction; returns the largest part of it. */
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

/* Solves for the stages by Newton's method. Corrections that no longer
   become smaller are rounding. Where forces cancel, as near a place of
   rest, the stages are no measure of it: an error of eps |x| in the places
   changes the solution by up to J eps |x|/(1 + J dt^2/12), J being the
   stiffness per mass; that is less than 12 eps |x|/dt^2. */
static bool newton(struct stepping *s)
{
    double last = INFINITY, change = INFINITY;
    const double rounding =
        64 * DBL_EPSILON * largest(s->x, s->forces.size) / (s->dt * s->dt);
    if (!prepare_newton(s))
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

static bool implicit_step(struct stepping *s)
{
    evaluate(s, s->x, s->v, s->acceleration);
    guess_stages(s);
    if (!iterate(s)) {
        guess_stages(s);
        if (!newton(s))
            return false;
    }
    close_step(s);
    return true;
}

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

/* Zero times a number is zero if the number is finite. */
static bool is_finite(const struct stepping *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->forces.size; ++i)
        sum += 0 * s->x[i] + 0 * s->v[i];
    return sum == 0;
}

/* Steps up to the next look at the numbers, or fewer. False: stuck. */
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

static enum stepping_end run_own(struct stepping *s, uint64_t steps)
{
    struct adaptive *const own = s->own;
    const double t = s->start + (double)(s->steps + steps) * s->dt;
    const uint64_t before = own->evaluations;
    stepping_anew(s);
    const bool came = adaptive_reach(own, t, s->x, s->v);
    s->evaluations += own->evaluations - before;
    if (!came)
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

double stepping_time(const struct stepping *s)
{
    return s->start + (double)s->steps * s->dt;
}

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
