/* Measures integration methods on small systems, for chapter 8. */
#include "forces/adaptive.h"
#include "forces/largest.h"
#include "forces/reference.h"
#include "forces/stepping.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define PROGRAM "step-studies"

static struct {
    uint64_t orbits; /* number of orbits of the planet in study_energy and
                        study_rounding */
} own = {.orbits = 1000};

enum { CHAIN = 32, MOST = CHAIN };

/* A small system: an oscillator, a pendulum, a planet, or a chain of CHAIN
   masses and springs between two walls. `friction` points to the friction
   coefficient c (in 1/s) of the acceleration -c v. */
struct system {
    size_t size;
    void (*accelerate)(void *friction, const double x[], const double v[],
                       double a[]);
    double (*energy)(const double x[], const double v[]);
    double x[3 * 2], v[2]; /* initial values; others are 0 */
};

static void oscillator_force(void *friction, const double x[],
                             const double v[], double a[])
{
    a[0] = -x[0] - *(double *)friction * v[0];
}

static double oscillator_energy(const double x[], const double v[])
{
    return (v[0] * v[0] + x[0] * x[0]) / 2;
}

/* Returns the sine of x, computed with + - * / only. The last bit of the C
   library's sine may differ between machines, which would eventually change
   the tables. The angle is reduced to the range from -pi/2 to pi/2, where
   twelve terms of the series suffice. */
static double sine(double x)
{
    const double pi = 3.14159265358979324;
    double y = x - 2 * pi * floor(x / (2 * pi) + 0.5), sum = 0;
    y = y > pi / 2 ? pi - y : y < -pi / 2 ? -pi - y : y;
    for (int k = 23; k > 1; k -= 2)
        sum = (1 - sum) * y * y / (k * (k - 1));
    return y * (1 - sum);
}

static void pendulum_force(void *friction, const double x[],
                           const double v[], double a[])
{
    a[0] = -sine(x[0]) - *(double *)friction * v[0];
}

/* Returns v^2/2 + 1 - cos x, written as v^2/2 + 2 sin^2(x/2) to avoid
   cancellation. */
static double pendulum_energy(const double x[], const double v[])
{
    const double s = sine(x[0] / 2);
    return v[0] * v[0] / 2 + 2 * s * s;
}

static void orbit_force(void *friction, const double x[], const double v[],
                        double a[])
{
    const double r2 = x[0] * x[0] + x[1] * x[1];
    const double f = -1 / (r2 * sqrt(r2));
    for (int k = 0; k < 2; ++k)
        a[k] = f * x[k] - *(double *)friction * v[k];
}

static double orbit_energy(const double x[], const double v[])
{
    return (v[0] * v[0] + v[1] * v[1]) / 2 -
           1 / sqrt(x[0] * x[0] + x[1] * x[1]);
}

/* Computes the accelerations of a harmonic chain. Its highest angular
   frequency is slightly below 2/s. */
static void chain_force(void *friction, const double x[], const double v[],
                        double a[])
{
    for (size_t i = 0; i < CHAIN; ++i) {
        const double left = i ? x[i - 1] : 0;
        const double right = i + 1 < CHAIN ? x[i + 1] : 0;
        a[i] = (left - x[i]) + (right - x[i]) - *(double *)friction * v[i];
    }
}

/* Returns the energy, including the springs at the walls. */
static double chain_energy(const double x[], const double v[])
{
    double sum = x[0] * x[0] + x[CHAIN - 1] * x[CHAIN - 1];
    for (size_t i = 0; i < CHAIN; ++i) {
        const double d = i ? x[i] - x[i - 1] : 0;
        sum += v[i] * v[i] + d * d;
    }
    return sum / 2;
}

/* The systems and their initial states. The orbit starts at the pericentre
   of an ellipse with eccentricity 1/2 and semi-major axis 1, at speed
   sqrt(3). Its energy is -1/2 and its period is 2 pi. The initial state of
   the chain is computed in start(). */
static const struct system oscillator = {
    1, oscillator_force, oscillator_energy, {1}, {0}};
static const struct system pendulum = {
    1, pendulum_force, pendulum_energy, {1.5}, {0.2}};
static const struct system orbit = {
    2, orbit_force, orbit_energy, {0.5, 0}, {0, 1.7320508075688772}};
static const struct system chain = {
    CHAIN, chain_force, chain_energy, {0}, {0}};
static const double period = 6.283185307179586;

/* A run of a system by one method. */
struct run {
    const struct system *system;
    double x[MOST], v[MOST], friction, energy;
    struct stepping s;
};

/* Sets x and v to the initial state of a system. The chain is at rest and
   plucked at a third of its length. */
static void start(const struct system *y, double x[MOST], double v[MOST])
{
    memcpy(x, y->x, sizeof y->x);
    memcpy(v, y->v, sizeof y->v);
    for (size_t i = 0; y == &chain && i < CHAIN; ++i)
        x[i] = i < 11 ? (double)(i + 1) / 11 : (double)(CHAIN - i) / 22;
}

static void begin_or_exit(struct run *c, const struct system *y,
                          const char *method, double dt, double friction)
{
    *c = (struct run){.system = y, .friction = friction};
    const struct stepping_forces f = {y->size, friction != 0, y->accelerate,
                                      &c->friction};
    start(y, c->x, c->v);
    c->energy = y->energy(c->x, c->v);
    program_memory(
        stepping_begin(&c->s, stepping_find(method), f, dt, c->x, c->v),
        NULL);
}

/* Returns the energy error relative to the initial energy. */
static double energy_error(const struct run *c)
{
    return (c->system->energy(c->x, c->v) - c->energy) / fabs(c->energy);
}

/* Returns the largest difference between the run and the state x, v, over
   all coordinates and velocities. */
static double distance(const struct run *c, const double x[],
                       const double v[])
{
    const size_t n = c->system->size;
    return larger(largest_difference(c->x, x, n),
                  largest_difference(c->v, v, n));
}

/* Returns the number of steps for `budget` force evaluations, so that
   methods can be compared at equal cost. Assumes that an implicit step
   takes eight iterations. */
static double steps_for(const struct stepping_method *m, double budget)
{
    const double rounds = m->family == STEPPING_IMPLICIT ? 8 : 1;
    return budget / (double)m->stages / rounds;
}

static void study_methods(struct study *s)
{
    table_print(s->out, "# method           order  stages  limit  "
                        "keeps\n");
    for (const struct stepping_method *m = stepping_methods; m->name; ++m) {
        char limit[16] = "none";
        if (m->adaptive)
            strcpy(limit, "-");
        else if (isfinite(m->limit))
            snprintf(limit, sizeof limit, "%.3f", m->limit);
        table_print(s->out, "%-18s %5d  %6zu  %5s  %s%s%s%s\n", m->name,
                    m->order, m->stages, limit,
                    m->symplectic ? "areas" : "",
                    m->symplectic && m->symmetric ? ", " : "",
                    m->symmetric    ? "the way back"
                    : m->symplectic ? ""
                    : m->adaptive   ? "its error"
                                    : "-",
                    m->orbits ? ", ellipses" : "");
    }
}

static const char *const four[] = {"euler", "symplectic-euler", "leapfrog",
                                   "rk4"};

/* Writes paths of the pendulum in the phase plane for four methods, with
   four amplitudes each. */
static void study_portrait(struct study *s)
{
    TABLE_COLUMNS(s->out, {"x", "", "angle"},
                  {"v", "1/s", "angular velocity"});
    for (int k = 0; k < 4; ++k)
        for (int j = 1; j <= 4; ++j) {
            struct run c;
            begin_or_exit(&c, &pendulum, four[k], 0.5, 0);
            c.x[0] = 0.6 * j;
            c.v[0] = 0;
            for (int n = 0; n <= (k ? 400 : 14); ++n) {
                TABLE_ROW(s->out, c.x[0], c.v[0]);
                stepping_run(&c.s, 1);
            }
            table_print(s->out, "\n\n");
            stepping_free(&c.s);
        }
}

/* Writes the energy of an oscillator after each step of four methods. */
static void study_laws(struct study *s)
{
    struct run c[4];
    table_column(s->out, "n", "", "steps");
    for (int k = 0; k < 4; ++k) {
        begin_or_exit(&c[k], &oscillator, four[k], 0.5, 0);
        table_column(s->out, four[k], "", "energy, in units of the first");
    }
    for (int n = 0; n <= 60; ++n) {
        double row[5] = {n};
        for (int k = 0; k < 4; ++k) {
            row[k + 1] = 1 + energy_error(&c[k]);
            if (n < 60)
                stepping_run(&c[k].s, 1);
        }
        table_row(s->out, 5, row);
    }
    for (int k = 0; k < 4; ++k) {
        table_real(s->summary, four[k], 1 + energy_error(&c[k]));
        stepping_free(&c[k].s);
    }
}

enum { RIM = 2000 };

static double area(double p[RIM][2])
{
    double sum = 0;
    for (int i = 0; i < RIM; ++i) {
        const double *a = p[i], *b = p[(i + 1) % RIM];
        sum += a[0] * b[1] - a[1] * b[0];
    }
    return fabs(sum) / 2;
}

/* Advances the points p by `steps` steps. Each point is the state of a
   pendulum. */
static void step_rim(double p[RIM][2], const char *method, uint64_t steps)
{
    struct run c;
    begin_or_exit(&c, &pendulum, method, 0.5, 0);
    for (int i = 0; i < RIM; ++i) {
        c.x[0] = p[i][0];
        c.v[0] = p[i][1];
        stepping_disturb(&c.s);
        stepping_run(&c.s, steps);
        p[i][0] = c.x[0];
        p[i][1] = c.v[0];
    }
    stepping_free(&c.s);
}

/* Writes the rim of a disk in phase space after 0, 3, 6 and 9 steps. The
   summary gets the ratio of the final to the initial area. */
static void study_area(struct study *s)
{
    static const char *const names[] = {"euler", "leapfrog", "rk4"};
    TABLE_COLUMNS(s->out, {"x", "", "angle"},
                  {"v", "1/s", "angular velocity"});
    for (int k = 0; k < 3; ++k) {
        double p[RIM][2], before;
        for (int i = 0; i < RIM; ++i) {
            const double turn = period * i / RIM;
            p[i][0] = 1.2 + 0.5 * sine(turn + period / 4);
            p[i][1] = 0.5 * sine(turn);
        }
        before = area(p);
        for (int steps = 0; steps <= 9; steps += 3) {
            if (steps)
                step_rim(p, names[k], 3);
            for (int i = 0; i <= RIM; i += 10)
                table_row(s->out, 2, p[i % RIM]);
            table_print(s->out, "\n\n");
        }
        table_real(s->summary, names[k], area(p) / before);
    }
}

enum { BUDGET = 400 }; /* evaluations of the forces per orbit */

/* Writes the largest energy error so far at a series of times, each at
   least 10 % later than the one before. */
static void record_energy(struct study *s, const struct stepping_method *m)
{
    struct run c;
    const double steps = steps_for(m, BUDGET);
    double worst = 0, next = 0.1;
    begin_or_exit(&c, &orbit, m->name, period / steps, 0);
    table_print(s->out, "# %s\n", m->name);
    while ((double)c.s.steps < steps * (double)own.orbits &&
           !progress_signal() && stepping_run(&c.s, 1) == STEPPING_DONE) {
        const double orbits = stepping_time(&c.s) / period;
        worst = fmax(worst, fabs(energy_error(&c)));
        if (orbits < next)
            continue;
        TABLE_ROW(s->out, orbits, worst);
        next = orbits * 1.1;
    }
    table_real(s->summary, m->name, worst);
    table_print(s->out, "\n\n");
    stepping_free(&c.s);
}

static void study_energy(struct study *s)
{
    TABLE_COLUMNS(s->out, {"t", "orbits", "time"},
                  {"dE/E", "", "largest error of the energy so far"});
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));)
        record_energy(s, m);
}

/* Computes the acceleration of an oscillator. `what` points to the squared
   frequency and the friction coefficient. */
static void linear_force(void *what, const double x[], const double v[],
                         double a[])
{
    const double *const constants = what;
    a[0] = -constants[0] * x[0] - constants[1] * v[0];
}

/* Sets column k of the matrix to the result of a step from the k-th unit
   vector. The step has length 1, and the system is an oscillator with
   frequency w and friction c. Its state consists of x, v and the
   acceleration saved from the previous step, which only leapfrog with
   friction uses. */
static void step_matrix(const struct stepping_method *m, double w, double c,
                        double matrix[3][3])
{
    double constants[] = {w * w, c};
    for (int k = 0; k < 3; ++k) {
        double x = k == 0, v = k == 1, a = k == 2;
        struct stepping s;
        const struct stepping_forces f = {1, c != 0, linear_force,
                                          constants};
        program_memory(stepping_begin(&s, m, f, 1, &x, &v), NULL);
        stepping_resume(&s, 0, NULL, c != 0 && m->drifts ? &a : NULL);
        stepping_run(&s, 1);
        matrix[0][k] = x;
        matrix[1][k] = v;
        matrix[2][k] = c != 0 && m->drifts == 1 ? s.acceleration[0] : 0;
        stepping_free(&s);
    }
}

/* Returns the spectral radius of m, the largest modulus of its eigenvalues.
   In the long run each step multiplies the length of the state by this
   factor. It is computed as the 2^30-th root of the norm of m^(2^30), by
   squaring m 30 times. Each square is divided by its largest element, which
   avoids overflow. */
static double growth(double m[3][3])
{
    double exponent = 0;
    for (int k = 0; k < 30; ++k) {
        double square[3][3] = {{0}}, most = 0;
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 3; ++j)
                square[i / 3][i % 3] += m[i / 3][j] * m[j][i % 3];
        for (int i = 0; i < 9; ++i)
            most = fmax(most, fabs(square[i / 3][i % 3]));
        if (!(most > 0))
            return most;
        for (int i = 0; i < 9; ++i)
            m[i / 3][i % 3] = square[i / 3][i % 3] / most;
        exponent += log(most) * ldexp(1, -k - 1);
    }
    return exp(exponent);
}

/* Writes the growth per step on a grid in the complex plane of lambda dt.
   The oscillators have the friction c = -2 Re(lambda) and the frequency w =
   |lambda|. */
static void study_stability(struct study *s)
{
    TABLE_COLUMNS(s->out, {"re", "", "real part of lambda dt"},
                  {"im", "", "imaginary part of lambda dt"},
                  {"growth", "", "of the state in a step"});
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));) {
        table_print(s->out, "# %s\n", m->name);
        for (int i = 0; i <= 90; ++i) {
            for (int j = 0; j <= 70; ++j) {
                const double re = -4 + 0.05 * i, im = 0.05 * j;
                double matrix[3][3];
                step_matrix(m, sqrt(re * re + im * im), -2 * re, matrix);
                TABLE_ROW(s->out, re, im, growth(matrix));
            }
            table_print(s->out, "\n");
        }
        table_print(s->out, "\n");
    }
}

/* Returns half the trace of the step matrix without friction. The method is
   unstable if the modulus of this value exceeds 1. */
static double half_trace(const struct stepping_method *m, double step)
{
    double matrix[3][3];
    step_matrix(m, step, 0, matrix);
    return (matrix[0][0] + matrix[1][1]) / 2;
}

/* Writes the values of omega dt, up to 6, at which half the trace leaves
   the interval from -1 to 1, returns to it, and leaves it again. Also
   writes the largest amount by which its modulus exceeds 1 between the
   first two values. */
static void find_edges(const struct study *s,
                       const struct stepping_method *m)
{
    static const char *const keys[] = {"leaves", "returns", "leaves_again"};
    enum { EDGES = 3, PLACES = 6000 };
    double beyond = 0;
    for (int i = 1, found = 0; i <= PLACES && found < EDGES; ++i) {
        const bool outside = found % 2;
        double low = (i - 1) / 1000.0, high = i / 1000.0;
        const double out = fabs(half_trace(m, high)) - 1;
        if (found == 1)
            beyond = fmax(beyond, out);
        if ((out > 0) == outside)
            continue;
        while (high - low > 1e-12) {
            const double middle = (low + high) / 2;
            *((fabs(half_trace(m, middle)) > 1) == outside ? &low : &high) =
                middle;
        }
        table_keyed(s->summary, high, "%s_%s", keys[found++], m->name);
    }
    table_keyed(s->summary, beyond, "beyond_%s", m->name);
}

/* Writes half the trace of the step matrix against omega dt for five
   splitting methods. */
static void study_trace(struct study *s)
{
    static const char *const names[] = {"leapfrog", "yoshida4", "pefrl",
                                        "yoshida6", "kahan-li8"};
    table_column(s->out, "w dt", "", "frequency times step");
    for (int k = 0; k < 5; ++k)
        table_column(s->out, names[k], "", "half the trace");
    for (int i = 1; i <= 350; ++i) {
        double row[6] = {i / 100.0};
        for (int k = 0; k < 5; ++k)
            row[k + 1] = half_trace(stepping_find(names[k]), row[0]);
        table_row(s->out, 6, row);
    }
    for (int k = 0; k < 5; ++k)
        find_edges(s, stepping_find(names[k]));
}

/* Makes `steps` steps to the time `until`. Returns the largest difference
   from the state x, v, or INFINITY if the run failed. */
static double error_of(const struct system *y, const char *method,
                       double until, uint64_t steps, double friction,
                       const double x[], const double v[])
{
    struct run c;
    begin_or_exit(&c, y, method, until / (double)steps, friction);
    const enum stepping_end end = stepping_run(&c.s, steps);
    const double error = distance(&c, x, v);
    stepping_free(&c.s);
    return end == STEPPING_DONE ? error : INFINITY;
}

/* Returns the order of a method, estimated from the errors with n and 2 n
   steps. Doubles n while the errors are at least a thousand times the
   rounding error. Sets *error to the last of these errors. */
static double order_of(const char *method, double friction, double x,
                       double v, double *error)
{
    double order = 0, now = 0, last = 0;
    for (uint64_t n = 8; n <= 2048; n *= 2) {
        now = error_of(&pendulum, method, 3, n, friction, &x, &v);
        if (now < 1e3 * DBL_EPSILON)
            break;
        order = log2(last / now);
        last = *error = now;
    }
    return order;
}

/* Computes the pendulum's state after 3 s, using gauss4 with 4096 steps and
   compensated sums. */
static void reference(double friction, double *x, double *v)
{
    struct run c;
    begin_or_exit(&c, &pendulum, "gauss4", 3.0 / 4096, friction);
    c.s.compensated = true;
    stepping_run(&c.s, 4096);
    *x = c.x[0];
    *v = c.v[0];
    stepping_free(&c.s);
}

/* Writes the order of each method without and with friction. The summary
   gets the errors without friction for 50 steps. */
static void study_order(struct study *s)
{
    double x, v, xc, vc;
    reference(0, &x, &v);
    reference(0.5, &xc, &vc);
    table_print(s->out, "# method            order  with friction\n");
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));) {
        double error;
        const double order = order_of(m->name, 0, x, v, &error);
        const double damped = order_of(m->name, 0.5, xc, vc, &error);
        table_print(s->out, "%-18s %6.2f  %6.2f\n", m->name, order, damped);
        table_real(s->summary, m->name,
                   error_of(&pendulum, m->name, 3, 50, 0, &x, &v));
    }
}

/* Returns the largest c dt for which the state of an oscillator with
   frequency w and friction c does not grow. w may be 0. Searches in
   increments of 0.01 and then by bisection. */
static double friction_limit(const struct stepping_method *m, double w)
{
    double matrix[3][3], low = 0, high = 0;
    do {
        low = high;
        high += 0.01;
        step_matrix(m, w, high, matrix);
    } while (growth(matrix) < 1 + 1e-7 && high < 20);
    while (high - low > 1e-9) {
        const double middle = (low + high) / 2;
        step_matrix(m, w, middle, matrix);
        if (growth(matrix) < 1 + 1e-7)
            low = middle;
        else
            high = middle;
    }
    return high < 20 ? low : INFINITY;
}

/* Returns the sum of |y|. For the drifts of a splitting method this is the
   total length of all forward and backward moves in a step. */
static double sum_of_moduli(const double y[], size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; ++k)
        sum += fabs(y[k]);
    return sum;
}

static void study_damping(struct study *s)
{
    table_print(s->out, "# method            sum|drift|  c dt\n");
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));)
        table_print(s->out, "%-18s %9.3f  %6.3f\n", m->name,
                    sum_of_moduli(m->drift, m->drifts),
                    friction_limit(m, 0));
}

/* Writes the factor by which a step changes a velocity if only friction
   acts. The position, whose eigenvalue is 1, is removed from the matrix. */
static void study_friction(struct study *s)
{
    table_column(s->out, "c dt", "", "friction times step");
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));)
        table_column(s->out, m->name, "", "growth of the velocity");
    for (int i = 1; i <= 120; ++i) {
        double row[STEPPING_MOST + 1] = {i * 0.05}, matrix[3][3];
        size_t columns = 1;
        for (const struct stepping_method *m = stepping_next(NULL); m;
             m = stepping_next(m)) {
            step_matrix(m, 0, row[0], matrix);
            for (int k = 0; k < 3; ++k)
                matrix[0][k] = matrix[k][0] = 0;
            row[columns++] = growth(matrix);
        }
        table_row(s->out, columns, row);
    }
}

/* Sets size[] to the amplitude of an oscillator with frequency w before and
   after each of 60 steps of length 1. If there is friction c, w must be 0,
   and size[] contains the modulus of the velocity instead. */
static void record_size(const char *method, double w, double c,
                        double size[61])
{
    double constants[] = {w * w, c}, x = c != 0 ? 0 : 1, v = c != 0 ? 1 : 0;
    const struct stepping_forces f = {1, c != 0, linear_force, constants};
    struct stepping s;
    program_memory(stepping_begin(&s, stepping_find(method), f, 1, &x, &v),
                   NULL);
    for (int n = 0; n <= 60; ++n) {
        size[n] = c != 0 ? fabs(v) : sqrt(x * x + v * v / (w * w));
        stepping_run(&s, 1);
    }
    stepping_free(&s);
}

/* Writes amplitudes for steps that exceed the stability limits of their
   methods. */
static void study_fails(struct study *s)
{
    static const struct {
        const char *method;
        double w, c;
    } runs[] = {{"leapfrog", 1.8, 0}, {"yoshida4", 1.8, 0},
                {"rk4", 2.5, 0},      {"rk4", 0, 2.5},
                {"yoshida4", 0, 2.5}, {"leapfrog", 0, 1.2}};
    double size[6][61];
    table_column(s->out, "n", "", "steps");
    for (int k = 0; k < 6; ++k) {
        record_size(runs[k].method, runs[k].w, runs[k].c, size[k]);
        table_column(s->out, runs[k].method, "", "size of the oscillator");
    }
    for (int n = 0; n <= 60; ++n) {
        double row[7] = {n};
        for (int k = 0; k < 6; ++k)
            row[k + 1] = size[k][n];
        table_row(s->out, 7, row);
    }
}

/* The number of slightly different orbits whose errors are averaged. The
   energy error of a single orbit is a random walk, which may be small by
   chance. */
enum { STARTS = 16 };

/* Continues all orbits up to `steps` steps. Returns the root mean square of
   their energy errors. */
static double error_after(struct run c[STARTS], uint64_t steps)
{
    double sum = 0;
    for (int k = 0; k < STARTS; ++k) {
        stepping_run(&c[k].s, steps - c[k].s.steps);
        sum += pow(energy_error(&c[k]), 2);
    }
    return sqrt(sum / STARTS);
}

static void record_rounding(struct study *s, double steps_of_orbit,
                            bool compensated)
{
    static struct run c[STARTS];
    char key[24];
    snprintf(key, sizeof key, "%s_%g", compensated ? "carried" : "plain",
             steps_of_orbit);
    for (int k = 0; k < STARTS; ++k) {
        begin_or_exit(&c[k], &orbit, "kahan-li8", period / steps_of_orbit,
                      0);
        c[k].v[1] *= 1 - k / 256.0;
        c[k].energy = orbit_energy(c[k].x, c[k].v);
        c[k].s.compensated = compensated;
    }
    for (uint64_t n = 1; n <= own.orbits && !progress_signal(); n *= 2) {
        const double error = error_after(c, n * (uint64_t)steps_of_orbit);
        TABLE_ROW(s->out, (double)n, error);
        if (n > own.orbits / 2)
            table_real(s->summary, key, error);
    }
    table_print(s->out, "\n\n");
    for (int k = 0; k < STARTS; ++k)
        stepping_free(&c[k].s);
}

static void study_rounding(struct study *s)
{
    TABLE_COLUMNS(s->out, {"n", "", "orbits"},
                  {"dE/E", "", "error of the energy, rms"});
    record_rounding(s, 100, false);
    record_rounding(s, 100, true);
    record_rounding(s, 400, false);
    record_rounding(s, 400, true);
}

/* The cost and error of a run. `seconds` is processor time. */
struct outcome {
    double evaluations, error, seconds;
};

/* A system and its exact state at the time `until`. */
struct task {
    const struct system *system;
    double until, x[MOST], v[MOST];
};

/* Runs a task in `steps` steps. Only study_cost uses the processor time,
   because tables that are recreated by every build must not contain
   times. */
static struct outcome work_of(const struct task *k, const char *method,
                              uint64_t steps)
{
    struct outcome o = {0};
    struct run c;
    begin_or_exit(&c, k->system, method, k->until / (double)steps, 0);
    const double start = bench_seconds();
    const enum stepping_end end = stepping_run(&c.s, steps);
    o.seconds = bench_seconds() - start;
    o.evaluations = (double)c.s.evaluations;
    o.error = end == STEPPING_DONE ? distance(&c, k->x, k->v) : INFINITY;
    stepping_free(&c.s);
    return o;
}

static struct outcome work_of_reference(const struct task *k,
                                        double tolerance)
{
    struct outcome o = {.error = INFINITY};
    struct run c = {.system = k->system};
    const struct stepping_forces f = {k->system->size, false,
                                      k->system->accelerate, &c.friction};
    struct reference r;
    if (!reference_begin(&r, f, tolerance))
        return o;
    start(k->system, c.x, c.v);
    const double start = bench_seconds();
    const bool well = reference_step(&r, k->until, c.x, c.v);
    o.seconds = bench_seconds() - start;
    o.evaluations = (double)r.evaluations;
    if (well)
        o.error = distance(&c, k->x, k->v);
    reference_free(&r);
    return o;
}

/* Sets a task of ten orbits, which return the planet to its start. */
static void set_orbit_task(struct task *k)
{
    *k = (struct task){.system = &orbit, .until = 10 * period};
    start(&orbit, k->x, k->v);
}

/* Writes the cost and error of an adaptive method for tolerances from 0.01
   to 1e-15. Each tolerance is a quarter of the previous one. Each run is a
   single call of stepping_run. */
static void record_adaptive(struct study *s, const struct task *k,
                            const char *method)
{
    table_print(s->out, "# %s\n", method);
    for (double e = 1e-2; e > 1e-15; e /= 4) {
        struct run c;
        begin_or_exit(&c, k->system, method, k->until, 0);
        c.s.tolerance = e;
        stepping_run(&c.s, 1);
        const double error = distance(&c, k->x, k->v);
        if (error < 10)
            TABLE_ROW(s->out, (double)c.s.evaluations, error);
        stepping_free(&c.s);
    }
    table_print(s->out, "\n\n");
}

/* Writes the cost and error of all methods. From one row to the next, the
   number of evaluations grows by a factor of sqrt(2). For adaptive methods
   and rk8pd the tolerance is divided by 4 instead. Runs with an error above
   10 are left out. */
static void record_work(struct study *s, const struct task *k)
{
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));) {
        table_print(s->out, "# %s\n", m->name);
        for (double budget = 500; budget < 1e6 && !progress_signal();
             budget *= sqrt(2)) {
            const struct outcome o =
                work_of(k, m->name, (uint64_t)steps_for(m, budget));
            if (o.error < 10)
                TABLE_ROW(s->out, o.evaluations, o.error);
        }
        table_print(s->out, "\n\n");
    }
    for (const struct stepping_method *m = stepping_methods; m->name; ++m)
        if (m->adaptive)
            record_adaptive(s, k, m->name);
    table_print(s->out, "# rk8pd\n");
    for (double e = 1e-2; e > 1e-15; e /= 4) {
        const struct outcome o = work_of_reference(k, e);
        if (o.error < 10)
            TABLE_ROW(s->out, o.evaluations, o.error);
    }
    table_print(s->out, "\n\n");
}

static void study_work(struct study *s)
{
    struct task k;
    TABLE_COLUMNS(s->out, {"n", "", "evaluations of the forces"},
                  {"error", "", "of the end, largest coordinate"});
    set_orbit_task(&k);
    record_work(s, &k);
    /* kahan-li8 with short steps gives the chain's exact state. */
    struct run c;
    k = (struct task){.system = &chain, .until = 200};
    begin_or_exit(&c, &chain, "kahan-li8", k.until / 4000, 0);
    c.s.compensated = true;
    stepping_run(&c.s, 4000);
    memcpy(k.x, c.x, sizeof c.x);
    memcpy(k.v, c.v, sizeof c.v);
    stepping_free(&c.s);
    record_work(s, &k);
}

/* Returns the cost and error of method m with `effort` evaluations. If m is
   NULL, runs GSL's rk8pd with tolerance 1 / effort instead. The time is the
   mean over repeated runs, which together take 10 ms. */
static struct outcome time_run(const struct task *k,
                               const struct stepping_method *m,
                               double effort)
{
    struct outcome o = {0};
    double seconds = 0;
    int runs = 0;
    for (; seconds < 0.01; ++runs) {
        o = m ? work_of(k, m->name, (uint64_t)steps_for(m, effort))
              : work_of_reference(k, 1 / effort);
        seconds += o.seconds;
    }
    o.seconds = seconds / runs;
    return o;
}

/* Writes a row with the median time of BENCH_ROUNDS runs after a warm-up.
   Writes nothing if the error is above 10. */
static void record_cost(struct study *s, const struct task *k,
                        const struct stepping_method *m, double effort,
                        int row)
{
    double seconds[BENCH_ROUNDS];
    const struct outcome o = time_run(k, m, effort);
    for (int round = 0; round < BENCH_ROUNDS; ++round)
        seconds[round] = time_run(k, m, effort).seconds;
    if (o.error < 10)
        TABLE_ROW(s->out, row, o.evaluations,
                  bench_median(seconds, BENCH_ROUNDS), o.error);
}

/* Times ten orbits. From one row to the next, the number of evaluations is
   doubled, or the tolerance of rk8pd is divided by 16. */
static void study_cost(struct study *s)
{
    struct task k;
    const struct stepping_method *m = stepping_next(NULL);
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"row", "", "method, times 100, and effort"},
                  {"n", "", "evaluations of the forces"},
                  {"t", "s", "processor time"},
                  {"error", "", "of the end, largest coordinate"});
    set_orbit_task(&k);
    for (int row = 0, last = 0; !last && !progress_signal(); ++row) {
        last = !m;
        table_print(s->out, "# %s\n", last ? "rk8pd" : m->name);
        for (int step = 0; step < 11; ++step) {
            const double effort =
                (m ? 500 : 10) * pow(2, m ? step : 4 * step);
            record_cost(s, &k, m, effort, 100 * row + step);
        }
        m = last ? NULL : stepping_next(m);
        table_print(s->out, "\n\n");
    }
}

/* The Pythagorean three-body problem. Masses of 3, 4 and 5 start at rest at
   the corners of a triangle with sides of lengths 3, 4 and 5, each opposite
   the side whose length equals the mass. The energy is -12 49/60. */
enum { BODIES = 3 };

static const double masses[BODIES] = {3, 4, 5};

static void three_force(void *friction, const double x[], const double v[],
                        double a[])
{
    (void)friction, (void)v;
    memset(a, 0, 2 * BODIES * sizeof *a);
    for (int i = 0; i < BODIES; ++i)
        for (int j = 0; j < i; ++j) {
            const double dx = x[j] - x[i], dy = x[3 + j] - x[3 + i];
            const double r2 = dx * dx + dy * dy, f = 1 / (r2 * sqrt(r2));
            a[i] += masses[j] * f * dx;
            a[3 + i] += masses[j] * f * dy;
            a[j] -= masses[i] * f * dx;
            a[3 + j] -= masses[i] * f * dy;
        }
}

static double three_energy(const double x[], const double v[])
{
    double sum = 0;
    for (int i = 0; i < BODIES; ++i) {
        sum += masses[i] * (v[i] * v[i] + v[3 + i] * v[3 + i]) / 2;
        for (int j = 0; j < i; ++j) {
            const double dx = x[j] - x[i], dy = x[3 + j] - x[3 + i];
            sum -= masses[i] * masses[j] / sqrt(dx * dx + dy * dy);
        }
    }
    return sum;
}

static const struct system three = {
    6, three_force, three_energy, {1, -2, 1, 3, -1, -1}, {0}};

/* Computes the accelerations of two independent oscillators, one with a
   soft and one with a stiff spring. The stiff one starts almost at rest. */
static void stiff_force(void *friction, const double x[], const double v[],
                        double a[])
{
    (void)friction, (void)v;
    a[0] = -x[0];
    a[1] = -1e6 * x[1];
}

/* Computes a discontinuous acceleration: -1 for x > 0 and 1 otherwise. The
   potential is |x|, so a body released at x = 1/2 returns there every 4
   s. */
static void jump_force(void *friction, const double x[], const double v[],
                       double a[])
{
    (void)friction, (void)v;
    a[0] = x[0] > 0 ? -1 : 1;
}

static double jump_energy(const double x[], const double v[])
{
    return fabs(x[0]) + v[0] * v[0] / 2;
}

static const struct system stiff = {
    2, stiff_force, oscillator_energy, {1, 1e-8}, {0}};
static const struct system jump = {1, jump_force, jump_energy, {0.5}, {0}};

/* Begins a run with variable steps. `tick` is the time between outputs,
   s. */
static void begin_adaptive(struct run *c, const struct system *y,
                           const char *method, double tick,
                           double tolerance)
{
    begin_or_exit(c, y, method, tick, 0);
    c->s.tolerance = tolerance;
}

static void record_tracks(struct study *s)
{
    struct run c;
    begin_adaptive(&c, &three, "radau15", 0.02, 1e-13);
    table_print(s->out, "# tracks: t, x, y of each\n");
    for (int k = 0; k <= 800; ++k) {
        TABLE_ROW(s->out, stepping_time(&c.s), c.x[0], c.x[3], c.x[1],
                  c.x[4], c.x[2], c.x[5]);
        stepping_run(&c.s, 1);
    }
    stepping_free(&c.s);
}

/* Returns the squared distance of bodies i and j. Sets at[] to their
   positions relative to their centre of mass. */
static double relative_to_centre(const struct run *c, int i, int j,
                                 double at[4])
{
    const double sum = masses[i] + masses[j];
    const double dx = c->x[j] - c->x[i], dy = c->x[3 + j] - c->x[3 + i];
    at[0] = -masses[j] / sum * dx;
    at[1] = -masses[j] / sum * dy;
    at[2] = masses[i] / sum * dx;
    at[3] = masses[i] / sum * dy;
    return dx * dx + dy * dy;
}

/* Writes the closest approach of two bodies. The run advances in ticks of
   50 ns and writes every fourth state. The distance and the time of the
   approach come from a parabola through three squared distances near their
   minimum. */
static void record_approach(struct study *s)
{
    enum { TICKS = 1200 };
    const double tick = 5e-8, from = 15.82992 - TICKS / 2 * tick;
    struct run c;
    double d[3] = {INFINITY, INFINITY, INFINITY}, at[4], when = 0, near = 0;
    begin_adaptive(&c, &three, "radau15", tick, 1e-13);
    stepping_run(&c.s, (uint64_t)(from / tick + 0.5));
    table_print(s->out, "\n\n# approach: x, y of either\n");
    for (int k = 0; k < TICKS; ++k) {
        d[0] = d[1], d[1] = d[2], d[2] = relative_to_centre(&c, 1, 2, at);
        if (k % 4 == 0)
            table_row(s->out, 4, at);
        if (d[1] < d[0] && d[1] <= d[2]) {
            const double slope = (d[2] - d[0]) / 2;
            const double bend = d[2] - 2 * d[1] + d[0];
            near = sqrt(d[1] - slope * slope / 2 / bend);
            when = stepping_time(&c.s) - (1 + slope / bend) * tick;
        }
        stepping_run(&c.s, 1);
    }
    TABLE_RESULTS(s->summary, {"near", near}, {"when", when});
    stepping_free(&c.s);
}

/* Writes all steps of a method up to t = 20 and the results of the run.
   Each call asks the method for a time just after the end of the previous
   step, so that it takes exactly one step. */
static void record_lengths(struct study *s, const char *method,
                           double tolerance)
{
    struct run c;
    double longest = 0;
    begin_adaptive(&c, &three, method, 0.01, tolerance);
    stepping_run(&c.s, 1);
    table_print(s->out, "\n\n# steps of %s: t, length\n", method);
    for (struct adaptive *const track = c.s.own; track->t < 20;) {
        if (!adaptive_reach(track, nextafter(track->t, INFINITY), c.x, c.v))
            break;
        adaptive_reach(track, track->t, c.x, c.v);
        TABLE_ROW(s->out, track->t, track->h);
        longest = fmax(longest, track->h);
    }
    TABLE_RESULTS_OF(s->summary, method, {"steps", (double)c.s.own->taken},
                     {"asked", (double)c.s.own->evaluations},
                     {"ratio", longest / c.s.own->shortest},
                     {"energy", fabs(energy_error(&c))});
    stepping_free(&c.s);
}

/* For comparison, measures the energy error of equal steps, with about as
   many evaluations. */
static void record_fixed(struct study *s)
{
    struct run c;
    begin_or_exit(&c, &three, "kahan-li8", 20.0 / 1500, 0);
    c.s.compensated = true;
    stepping_run(&c.s, 1500);
    table_real(s->summary, "energy_fixed", fabs(energy_error(&c)));
    stepping_free(&c.s);
}

static void record_drift(struct study *s)
{
    struct run c;
    begin_adaptive(&c, &orbit, "dopri5", period, 1e-6);
    stepping_run(&c.s, 100);
    table_real(s->summary, "drift_100", fabs(energy_error(&c)));
    stepping_run(&c.s, 900);
    TABLE_RESULTS(s->summary, {"drift_1000", fabs(energy_error(&c))},
                  {"asked_drift", (double)c.s.evaluations / 1000});
    stepping_free(&c.s);
}

/* Counts the steps of an adaptive method for a soft oscillator, a stiff
   system and a system with a discontinuous force. */
static void record_trouble(struct study *s)
{
    static const struct {
        const struct system *system;
        const char *name;
        double until, tolerance;
    } runs[] = {{&oscillator, "steps_soft", 100, 1e-6},
                {&stiff, "steps_stiff", 100, 1e-6},
                {&jump, "steps_jump", 400, 1e-9}};
    for (int k = 0; k < 3; ++k) {
        struct run c;
        begin_adaptive(&c, runs[k].system, "dopri5", runs[k].until,
                       runs[k].tolerance);
        stepping_run(&c.s, 1);
        table_count(s->summary, runs[k].name, c.s.own->taken);
        if (runs[k].system == &jump)
            TABLE_RESULTS(s->summary,
                          {"refused_jump", (double)c.s.own->refused},
                          {"energy_jump", fabs(energy_error(&c))});
        stepping_free(&c.s);
    }
}

static void study_lengths(struct study *s)
{
    record_tracks(s);
    record_approach(s);
    record_lengths(s, "radau15", 1e-13);
    record_lengths(s, "dopri5", 1e-10);
    record_fixed(s);
    record_drift(s);
    record_trouble(s);
}

static const struct study_entry studies[] = {
    {"methods", study_methods, "what their rows promise", NULL},
    {"portrait", study_portrait, "four methods in the phase plane", NULL},
    {"laws", study_laws, "of their energies",
     STUDY_KEYS({"<method>", "1", "energy after 60 steps / at the start"})},
    {"area", study_area, "of a disk of starts",
     STUDY_KEYS({"<method>", "1", "area after 9 steps / at the start"})},
    {"energy", study_energy, "of a planet, in the long run",
     STUDY_KEYS({"<method>", "1", "largest relative error"})},
    {"stability", study_stability, "friction and a spring together", NULL},
    {"trace", study_trace, "a spring without friction",
     STUDY_KEYS(
         {"leaves_<method>", "1", "where the curve leaves the strip"},
         {"returns_<method>", "1", "where it comes back"},
         {"leaves_again_<method>", "1", "where it leaves once more"},
         {"beyond_<method>", "1",
          "how far outside between the first two"})},
    {"order", study_order, "the slope of the error",
     STUDY_KEYS({"<method>", "1", "error after 3 s in 50 steps"})},
    {"damping", study_damping, "the limits under friction alone", NULL},
    {"friction", study_friction, "what it makes of a velocity", NULL},
    {"fails", study_fails, "three ways to fail", NULL},
    {"rounding", study_rounding, "carried along or not",
     STUDY_KEYS(
         {"plain_<steps>", "1", "rms error of the energy, steps an orbit"},
         {"carried_<steps>", "1", "the same, rounding carried along"})},
    {"work", study_work, "error against evaluations", NULL},
    {"cost", study_cost, "error against processor time", NULL},
    {"lengths", study_lengths, "steps that choose their own",
     STUDY_KEYS({"near", "m", "closest approach of the three bodies"},
                {"when", "s", "its time"},
                {"steps_<what>", "1", "steps taken"},
                {"asked_<what>", "1", "evaluations of the forces"},
                {"ratio_<method>", "1", "longest to shortest step"},
                {"energy_<what>", "1", "relative error of the energy"},
                {"drift_<orbits>", "1", "of dopri5, to 1e-6"},
                {"refused_jump", "1", "steps taken in vain"})},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study energy, rounding"},
    {"orbits", 'n', "N", "how many (1000)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    if (letter == 'n')
        own.orbits = options_count(o, 1, 1000000000);
}

STUDY_MAIN(.name = PROGRAM, .purpose = "Measure the methods of stepping.",
           .events = "steps", .studies = studies, .options = entries,
           .take = take_option)
