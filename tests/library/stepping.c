/* The methods of stepping: orders, laws of energy, reversibility, areas,
   and bits that do not depend on how a run is cut or resumed. Reference
   numbers were computed for this book by a program of its own, in
   quadruple precision. */
#include "unit.h"

#include "library/forces.h"
#include "forces/stepping.h"
#include "library/methods.h"
#include "toolbox/quad.h"

#include <float.h>

enum { MOST = 6 };

FORCES(pendulum)
{
    a[0] = -sin(x[0]);
}

FORCES(oscillator)
{
    const double *w = what;
    a[0] = -w[0] * w[0] * x[0];
}

/* Two coordinates, a friction that depends on place, nothing symmetric. */
FORCES(rough)
{
    a[0] = -sin(x[0]) + 0.2 * x[1] - 0.3 * v[0] * (1 + 0.2 * x[1]);
    a[1] = -x[1] + 0.2 * x[0] - 0.1 * v[1];
}

static double one = 1;
static const struct stepping_forces pendulum_forces = {1, false, pendulum,
                                                       NULL};
static const struct stepping_forces oscillator_forces = {1, false,
                                                         oscillator, &one};
static const struct stepping_forces rough_forces = {2, true, rough, NULL};
static const struct stepping_forces orbit_forces = {2, false, orbit, NULL};

static void begin(struct stepping *s, const struct stepping_method *m,
                  struct stepping_forces f, double dt, double x[],
                  double v[])
{
    UNIT_MUST(stepping_begin(s, m, f, dt, x, v));
}

/* x and v of one coordinate after so many steps. */
static void go(const char *name, struct stepping_forces f, double dt,
               uint64_t steps, double *x, double *v)
{
    MADE(stepping, s, begin(&s, stepping_find(name), f, dt, x, v));
    UNIT_TRUE(stepping_run(&s, steps) == STEPPING_DONE);
}

/* |dq| + |dp| of the pendulum q = 1.5, p = 0.2 at t = 3 */
static double pendulum_error(const char *name, uint64_t steps)
{
    double x = 1.5, v = 0.2;
    go(name, pendulum_forces, 3.0 / (double)steps, steps, &x, &v);
    return fabs(x + 1.14790170017933) + fabs(v + 0.8481327619737);
}

/* The last halving of the step before rounding counts says the order, to
   0.1; the errors have to have become small until then. */
static void check_orders(const struct stepping_method *m)
{
    double far = pendulum_error(m->name, 8), order = NAN;
    for (uint64_t n = 16; n <= 1024; n *= 2) {
        const double near = pendulum_error(m->name, n);
        if (near < 1e3 * DBL_EPSILON)
            break;
        order = log2(far / near);
        far = near;
    }
    UNIT_NEAR(order, m->order, 0.1);
    UNIT_TRUE(far < 0.1);
}

TEST(test_orders, "every method has the order of its row")
{
    each_method(check_orders);
}

/* Four digits each of the reference. */
TEST(test_errors, "errors of the pendulum are the reference's")
{
    static const struct {
        const char *name;
        double at50, at100;
    } known[] = {{"symplectic-euler", 0.02867, 0.0144},
                 {"leapfrog", 7.55e-4, 1.888e-4},
                 {"yoshida4", 1.818e-6, 1.138e-7},
                 {"yoshida6", 6.835e-10, 1.069e-11},
                 {"pefrl", 2.777e-8, 1.736e-9}};
    for (int k = 0; k < 5; ++k) {
        /* half a unit of the last digit, and of 1e-11 the reference's own
           fourteen digits */
        UNIT_NEAR(pendulum_error(known[k].name, 50) / known[k].at50, 1,
                  5e-4);
        UNIT_NEAR(pendulum_error(known[k].name, 100) / known[k].at100, 1,
                  2e-3);
    }
}

/* Kahan and Li's order in quadruple precision: the energy of x'' = -x^3
   needs no functions. */
static quad quartic_error(const struct stepping_method *m, int steps)
{
    quad x = 1, v = 0.5;
    for (int n = 0; n < steps; ++n)
        for (size_t k = 0; k <= m->drifts; ++k) {
            const quad before = k ? (quad)m->drift[k - 1] : 0;
            const quad after = k < m->drifts ? (quad)m->drift[k] : 0;
            v -= (before + after) / 2 * 3 / steps * x * x * x;
            x += after * 3 / steps * v;
        }
    return v * v / 2 + x * x * x * x / 4 - (quad)0.375;
}

TEST(test_kahan_li, "Kahan and Li's weights have order 8")
{
    const struct stepping_method *m = stepping_find("kahan-li8");
    /* The weights of the row are doubles, so that the order ends at errors
       of 1e-16. */
    for (int n = 20; n <= 40; n *= 2)
        UNIT_NEAR(log2(fabs((double)(quartic_error(m, n) /
                                     quartic_error(m, 2 * n)))),
                  8, 0.05);
    long double sum[4] = {0};
    for (size_t k = 0; k < 17; ++k)
        for (int p = 0; p < 4; ++p)
            sum[p] += powl(m->drift[k], 2 * p + 1);
    UNIT_NEAR(sum[0], 1, 4 * DBL_EPSILON);
    for (int p = 1; p < 4; ++p)
        UNIT_NEAR(sum[p], 0, 4 * DBL_EPSILON);
}

/* Does each stage of a tableau need only what the ones before it said? */
static bool is_explicit(const struct stepping_method *m)
{
    for (size_t i = 0; i < m->stages; ++i)
        for (size_t j = i; j < m->stages; ++j)
            if (m->a[i * m->stages + j] != 0)
                return false;
    return true;
}

/* What a row must satisfy, whatever its method: consistency, symmetry, and
   the conditions of its order for a tableau. */
static void check_row(const struct stepping_method *m)
{
    double kicks = 0, drifts = 0, b = 0, bc = 0, bc2 = 0, bac = 0;
    UNIT_TRUE(stepping_find(m->name) == m);
    UNIT_TRUE(m->about != NULL && m->about[0] != '\0');
    UNIT_TRUE(!m->adaptive);
    UNIT_TRUE((m->drift != NULL) == (m->family == STEPPING_SPLITTING));
    UNIT_TRUE((m->b != NULL) == (m->family != STEPPING_SPLITTING));
    UNIT_TRUE(!m->b || is_explicit(m) == (m->family == STEPPING_EXPLICIT));
    for (size_t k = 0; k < m->drifts; ++k) {
        drifts += m->drift[k];
        if (m->symmetric)
            UNIT_EQUAL(m->drift[k], m->drift[m->drifts - 1 - k]);
    }
    for (size_t k = 0; m->kick && k <= m->drifts; ++k)
        kicks += m->kick[k];
    for (size_t i = 0; m->b && i < m->stages; ++i) {
        double c = 0, ac = 0;
        for (size_t j = 0; j < m->stages; ++j) {
            double cj = 0;
            for (size_t k = 0; k < m->stages; ++k)
                cj += m->a[j * m->stages + k];
            c += m->a[i * m->stages + j];
            ac += m->a[i * m->stages + j] * cj;
        }
        b += m->b[i];
        bc += m->b[i] * c;
        bc2 += m->b[i] * c * c;
        bac += m->b[i] * ac;
    }
    if (m->drift)
        UNIT_NEAR(drifts, 1, 4 * DBL_EPSILON);
    if (m->kick)
        UNIT_NEAR(kicks, 1, 4 * DBL_EPSILON);
    if (m->b)
        UNIT_NEAR(b, 1, 4 * DBL_EPSILON);
    if (m->b && m->order >= 2)
        UNIT_NEAR(bc, 0.5, 4 * DBL_EPSILON);
    if (m->b && m->order >= 3) {
        UNIT_NEAR(bc2, 1.0 / 3, 4 * DBL_EPSILON);
        UNIT_NEAR(bac, 1.0 / 6, 4 * DBL_EPSILON);
    }
}

TEST(test_rows, "every row is consistent")
{
    each_method(check_row);
    UNIT_TRUE(stepping_find("leap") == NULL);
}

/* Exact laws on the oscillator; 1e4 steps round by 1e4 DBL_EPSILON at most
   for each of the few operations of a step. */
TEST(test_laws, "energies follow their laws")
{
    static const double h = 0.3;
    const int n = 10000;
    const double rounding = 8.0 * n * DBL_EPSILON;
    double x = 1, v = 0;
    go("euler", oscillator_forces, h, 1000, &x, &v);
    UNIT_NEAR((x * x + v * v) / pow(1 + h * h, 1000), 1, rounding);
    x = 1, v = 0;
    go("rk4", oscillator_forces, h, (uint64_t)n, &x, &v);
    UNIT_NEAR((x * x + v * v) /
                  pow(1 - pow(h, 6) / 72 + pow(h, 8) / 576, n),
              1, rounding);
    x = 1, v = 0;
    go("leapfrog", oscillator_forces, h, (uint64_t)n, &x, &v);
    const double slack = 1 - h * h / 4;
    UNIT_NEAR((v * v + slack * x * x) / slack, 1, rounding);
    UNIT_NEAR(x, cos(n * 2 * asin(h / 2)), 4 * rounding);
    x = 1, v = 0;
    go("implicit-midpoint", oscillator_forces, h, (uint64_t)n, &x, &v);
    UNIT_NEAR(x * x + v * v, 1, rounding);
    UNIT_NEAR(x, cos(n * 2 * atan(h / 2)), 4 * rounding);
    x = 1, v = 0;
    go("gauss4", oscillator_forces, h, (uint64_t)n, &x, &v);
    UNIT_NEAR(x * x + v * v, 1, rounding);
    UNIT_NEAR(x, cos(n * 2 * atan(h / 2 / (1 - h * h / 12))), 4 * rounding);
}

/* Implicit steps far longer than the period: the energy stays, and each
   step turns by the angle of the law. */
TEST(test_long_implicit_steps, "implicit steps may be long")
{
    double w = 50;
    const struct stepping_forces f = {1, false, oscillator, &w};
    double x = 1, v = 0;
    go("implicit-midpoint", f, 1, 1000, &x, &v);
    UNIT_NEAR(x * x + v * v / (w * w), 1, 1e-9);
    UNIT_NEAR(x, cos(1000 * 2 * atan(w / 2)), 1e-7);
    x = 1, v = 0;
    go("gauss4", f, 1, 1000, &x, &v);
    UNIT_NEAR(x * x + v * v / (w * w), 1, 1e-9);
}

/* Two springs that hang, and are displaced by a billionth: forces of some
   newtons cancel to five millionths, and rounding is a millionth of those.
 */
FORCES(hanging)
{
    a[0] = -5000 * x[0] + 5 * (x[1] - x[0] + 1) - 1.8;
    a[1] = -5 * (x[1] - x[0] + 1) - 1.8;
}

TEST(test_implicit_at_rest, "implicit steps near a place of rest")
{
    const char *const name[] = {"implicit-midpoint", "gauss4"};
    const double rest[2] = {-3.6 / 5000, -3.6 / 5000 - 1 - 1.8 / 5};
    for (int m = 0; m < 2; ++m)
        for (double dt = 0.03; dt < 1; dt *= 1.5) {
            FREED(stepping) s;
            const struct stepping_forces f = {2, false, hanging, NULL};
            double x[2] = {rest[0] + 1e-9, rest[1]}, v[2] = {0, 0};
            begin(&s, stepping_find(name[m]), f, dt, x, v);
            UNIT_EQUAL(stepping_run(&s, 400), STEPPING_DONE);
            /* the energy of the fast mode is kept, and gives the reach */
            UNIT_LIST(x, 1.1e-9, rest[0], rest[1]);
        }
}

/* A stiff, strongly nonlinear spring: what midpoint promises is its own
   equation, v1 - v0 = dt a((x0 + x1) / 2). */
FORCES(stiff)
{
    const double r = sqrt(x[0] * x[0] + x[1] * x[1]);
    for (int k = 0; k < 2; ++k)
        a[k] = -5000 * (r - 1) * x[k] / r;
    a[1] -= 1.8;
}

TEST(test_newton, "and stiff springs bend no equation")
{
    const struct stepping_forces f = {2, false, stiff, NULL};
    const double dt = 0.1;
    double x[] = {0.6, -0.8}, v[] = {0, 0};
    FREED(stepping) s;
    begin(&s, stepping_find("implicit-midpoint"), f, dt, x, v);
    for (int n = 0; n < 200; ++n) {
        const double x0[] = {x[0], x[1]}, v0[] = {v[0], v[1]};
        double a[2];
        UNIT_TRUE(stepping_run(&s, 1) == STEPPING_DONE);
        stiff(NULL, (double[]){(x0[0] + x[0]) / 2, (x0[1] + x[1]) / 2}, v,
              a);
        for (int k = 0; k < 2; ++k) {
            UNIT_NEAR(v[k] - v0[k], dt * a[k], 1e-11);
            UNIT_NEAR(x[k] - x0[k], dt * (v0[k] + v[k]) / 2, 1e-14);
        }
    }
}

/* There and back: symmetric methods return but for rounding, the others
   keep twice their error. Steps are long, so that it is seen of high orders
   as well. */
static void check_reversal(const struct stepping_method *m)
{
    double x = 1.5, v = 0.2;
    go(m->name, pendulum_forces, 0.25, 40, &x, &v);
    go(m->name, pendulum_forces, -0.25, 40, &x, &v);
    const double miss = fabs(x - 1.5) + fabs(v - 0.2);
    UNIT_TRUE(miss < 1e-12 || miss > 1e-10);
    UNIT_TRUE(m->symmetric == (miss < 1e-12));
}

TEST(test_reversal, "symmetric methods come back")
{
    each_method(check_reversal);
}

/* The derivatives of the state after five steps of an orbit by the state
   before, by symmetric differences of 1e-5: their error is of the order
   of 1e-7, and that of rounding 1e-10. */
static void jacobian(const char *name, double j[4][4])
{
    for (int k = 0; k < 4; ++k) {
        double y[2][4];
        for (int side = 0; side < 2; ++side) {
            double state[] = {0.5, 0.1, 0.1, 1.7};
            state[k] += side ? 1e-5 : -1e-5;
            go(name, orbit_forces, 0.1, 5, state, state + 2);
            memcpy(y[side], state, sizeof state);
        }
        for (int i = 0; i < 4; ++i)
            j[i][k] = (y[1][i] - y[0][i]) / 2e-5;
    }
}

/* The sum of the areas of two displacements in the planes (x, v): what a
   symplectic step keeps for every pair. */
static double worst_area(double j[4][4])
{
    double worst = 0;
    for (int p = 0; p < 4; ++p)
        for (int q = 0; q < 4; ++q) {
            const double sum = j[0][p] * j[2][q] - j[2][p] * j[0][q] +
                               j[1][p] * j[3][q] - j[3][p] * j[1][q];
            const double before = q == p + 2 ? 1 : p == q + 2 ? -1 : 0;
            worst = fmax(worst, fabs(sum - before));
        }
    return worst;
}

/* The determinant of a step of the oscillator: 1 for a symplectic one. */
static double determinant(const struct stepping_method *m)
{
    double x[] = {1, 0}, v[] = {0, 1};
    go(m->name, oscillator_forces, 0.7, 1, &x[0], &v[0]);
    go(m->name, oscillator_forces, 0.7, 1, &x[1], &v[1]);
    return x[0] * v[1] - x[1] * v[0];
}

/* Symplectic methods keep the areas of the orbit, as far as differences can
   tell, and of the oscillator, but for rounding; of the others one at least
   shows that they do not. */
static void check_areas(const struct stepping_method *m)
{
    double j[4][4];
    jacobian(m->name, j);
    const double orbits = worst_area(j), one = fabs(determinant(m) - 1);
    UNIT_TRUE(m->symplectic == (orbits < 1e-6 && one < 1e-14));
    UNIT_TRUE(m->symplectic || orbits > 1e-5 || one > 1e-12);
}

TEST(test_areas, "symplectic methods keep areas")
{
    each_method(check_areas);
}

TEST(test_leapfrog_is_a_splitting,
     "leapfrog's own code is that of a splitting")
{
    static const double kick[] = {0.5, 0.5};
    struct stepping_method general = *stepping_find("leapfrog");
    general.kick = kick;
    double x[2][2], v[2][2];
    for (int k = 0; k < 2; ++k) {
        PUT(x[k], 0.5, 0.1);
        PUT(v[k], 0.1, 1.5);
        MADE(stepping, s,
             begin(&s, k ? &general : stepping_find("leapfrog"),
                   orbit_forces, 0.03, x[k], v[k]));
        stepping_run(&s, 200);
    }
    UNIT_TRUE(!memcmp(x[0], x[1], sizeof x[0]) &&
              !memcmp(v[0], v[1], sizeof v[0]));
}

/* As many pendulums as *what says. */
FORCES(pendulums)
{
    for (size_t i = 0; i < *(const size_t *)what; ++i)
        a[i] = -sin(x[i]);
}

/* Pendulums from `from` on, 20 steps: the last angles and velocities. */
static void swing(const struct stepping_method *m, bool compensated,
                  size_t from, size_t n, double x[], double v[])
{
    for (size_t i = 0; i < n; ++i) {
        x[i] = 0.1 * (double)(from + i + 1);
        v[i] = 1 / (double)(from + i + 1);
    }
    MADE(stepping, s,
         begin(&s, m, (struct stepping_forces){n, false, pendulums, &n},
               0.1, x, v));
    s.compensated = compensated;
    UNIT_TRUE(stepping_run(&s, 20) == STEPPING_DONE);
}

/* Several at a time, four by four with three left over, and as many as an
   instruction takes, have the bits of each alone. */
TEST(test_lanes, "many have the bits of one alone")
{
    enum { LANES = 71 };
    double x[LANES], v[LANES], lone_x, lone_v;
    const struct stepping_method *m = NULL;
    while ((m = stepping_next(m)) != NULL)
        for (int way = 0; way < 4; ++way) {
            const size_t n = way & 1 ? LANES : 11;
            if (m->family == STEPPING_IMPLICIT)
                continue; /* all are iterated until the last has settled */
            swing(m, way & 2, 0, n, x, v);
            for (size_t i = 0; i < n; ++i) {
                swing(m, way & 2, i, 1, &lone_x, &lone_v);
                UNIT_TRUE(x[i] == lone_x && v[i] == lone_v);
            }
        }
}

/* Evaluations in the first step, and in 100 more. */
static void count(const struct stepping_method *m, struct stepping_forces f,
                  double *first, double *more)
{
    double x[] = {0.5, 0.1}, v[] = {0.1, 1.5};
    MADE(stepping, s, begin(&s, m, f, 0.01, x, v));
    stepping_run(&s, 1);
    *first = (double)s.evaluations;
    stepping_run(&s, 100);
    *more = (double)s.evaluations - *first;
}

/* A step asks as often as its row says, the first one perhaps once more;
   with friction leapfrog does as well, and other splittings ask twice for
   each kick. An implicit step asks in rounds. */
static void check_evaluations(const struct stepping_method *m)
{
    const double stages = (double)m->stages;
    double first, more, kicks = (double)m->drifts + 1;
    for (size_t k = 0; m->kick && k <= m->drifts; ++k)
        kicks -= m->kick[k] == 0;
    count(m, orbit_forces, &first, &more);
    if (m->family == STEPPING_IMPLICIT) {
        UNIT_TRUE(more > 100 * stages && more < 3000 * stages);
        return;
    }
    UNIT_EQUAL(more, 100 * stages);
    UNIT_TRUE(first == stages || (m->drift && first == stages + 1));
    count(m, rough_forces, &first, &more);
    UNIT_EQUAL(more, m->drift && !stepping_is_leapfrog(m) ? 200 * kicks
                                                          : 100 * stages);
}

TEST(test_evaluations, "the forces are asked as often as promised")
{
    each_method(check_evaluations);
}

/* Carried sums: Kahan and Li with short steps on a circle, where the
   energy's error is rounding alone. */
static double circle_error(bool compensated)
{
    double x[] = {1, 0}, v[] = {0, 1};
    FREED(stepping) s;
    begin(&s, stepping_find("kahan-li8"), orbit_forces, 0.02, x, v);
    s.compensated = compensated;
    double sum = 0;
    for (int n = 0; n < 100; ++n) {
        stepping_run(&s, 1000);
        const double energy = (v[0] * v[0] + v[1] * v[1]) / 2 -
                              1 / sqrt(x[0] * x[0] + x[1] * x[1]);
        sum += fabs(energy + 0.5);
    }
    return sum / 100;
}

TEST(test_compensation, "carried sums keep the energy")
{
    const double plain = circle_error(false), carried = circle_error(true);
    UNIT_TRUE(carried < plain / 5);
    UNIT_TRUE(carried < 2e-15);
}

/* A part as long as a step has its bits; after one of another length steps
   are what they were; and what was noted comes back, with what the sums owe
   and whether the acceleration is known. */
static void check_parts(const struct stepping_method *m)
{
    for (int way = 0; way < 4; ++way) {
        const struct stepping_forces f =
            way & 1 ? rough_forces : orbit_forces;
        double x[] = {0.5, 0.1}, v[] = {0.1, 1.5}, y[2], u[2], note[11];
        MADE(stepping, s, begin(&s, m, f, 0.03, x, v));
        s.compensated = way & 2;
        stepping_run(&s, 5);
        stepping_note(&s, note);
        const uint64_t before = s.evaluations;
        stepping_run(&s, 3);
        const uint64_t three = s.evaluations - before;
        memcpy(y, x, sizeof y);
        memcpy(u, v, sizeof u);
        UNIT_EQUAL(stepping_part(&s, 0.011), STEPPING_DONE);
        UNIT_TRUE(x[0] != y[0]);
        UNIT_EQUAL(s.steps, 8);
        stepping_recall(&s, note);
        const uint64_t then = s.evaluations;
        stepping_run(&s, 3);
        UNIT_TRUE(!memcmp(y, x, sizeof y) && !memcmp(u, v, sizeof u));
        UNIT_EQUAL(s.evaluations - then, three);
        MADE(stepping, t, begin(&t, m, f, 0.03, y, u));
        t.compensated = way & 2;
        memcpy(y, note, sizeof y);
        memcpy(u, note + 2, sizeof u);
        stepping_resume(&t, 5, note + 4, note[10] != 0 ? note + 8 : NULL);
        for (int k = 0; k < 3; ++k)
            UNIT_EQUAL(stepping_part(&t, 0.03), STEPPING_DONE);
        UNIT_EQUAL(t.steps, 5);
        /* Leapfrog under friction has a way of its own for many steps. */
        UNIT_TRUE((!memcmp(y, x, sizeof y) && !memcmp(u, v, sizeof u)) ||
                  stepping_keeps(&t));
    }
}

TEST(test_parts, "parts of steps, and what is noted")
{
    each_method(check_parts);
}

/* Two stiff springs, coupled, with friction. */
FORCES(stiff_linear)
{
    a[0] = -2500 * x[0] + 700 * x[1] - 30 * v[0] + 10 * v[1];
    a[1] = 300 * x[0] - 900 * x[1] + 20 * v[0] - 50 * v[1];
}

/* On linear forces Newton's method is right at once: what differences of
   2^-26 leave of the matrix' error falls by some 1e7 in each correction. So
   a step takes the acceleration before it, two rounds that lead nowhere,
   one for the matrix with two displacements of each coordinate, and at most
   eight corrections: two that count, and while rounding falls. */
TEST(test_linear, "Newton's method is right at once on linear forces")
{
    for (const struct stepping_method *m = stepping_next(NULL); m;
         m = stepping_next(m)) {
        if (m->family != STEPPING_IMPLICIT)
            continue;
        double x[] = {0.3, -1.1}, v[] = {4, 0.7};
        MADE(stepping, s,
             begin(&s, m,
                   (struct stepping_forces){2, true, stiff_linear, NULL},
                   0.5, x, v));
        UNIT_EQUAL(stepping_run(&s, 10), STEPPING_DONE);
        const double n = (double)m->stages;
        UNIT_TRUE((double)s.evaluations <=
                  10 * (1 + 2 * n + n + 4 * n + 8 * n));
    }
}

/* A body that its place repels: in steps of 2 s the midpoint's
   equation for a = x is s = x + v + s. It has no solution, which the
   matrix says, 1 - 1: after the acceleration before the step, two rounds
   and two evaluations for the matrix. */
FORCES(repelled)
{
    a[0] = x[0];
}

TEST(test_singular, "a matrix that has no inverse")
{
    const struct stepping_forces f = {1, false, repelled, NULL};
    double x = 0.5, v = 0.25;
    FREED(stepping) s;
    begin(&s, stepping_find("implicit-midpoint"), f, 2, &x, &v);
    UNIT_EQUAL(stepping_run(&s, 1), STEPPING_STUCK);
    UNIT_EQUAL(x, 0.5);
    UNIT_EQUAL(v, 0.25);
    UNIT_EQUAL(s.evaluations, 5);
}

FORCES(grow)
{
    a[0] = x[0] * x[0] * x[0];
}

TEST(test_infinite, "what is not finite is noticed")
{
    const struct stepping_forces f = {1, false, grow, NULL};
    for (const struct stepping_method *m = fixed_row(stepping_methods);
         m->name; m = fixed_row(m + 1)) {
        uint64_t ends[2];
        for (int cut = 0; cut < 2; ++cut) {
            double x = 2, v = 2;
            enum stepping_end end = STEPPING_DONE;
            MADE(stepping, s, begin(&s, m, f, 0.1, &x, &v));
            while (end == STEPPING_DONE && s.steps < 1000)
                end = stepping_run(&s, cut ? 64 : 1000);
            UNIT_TRUE(end == (m->family == STEPPING_IMPLICIT
                                  ? STEPPING_STUCK
                                  : STEPPING_INFINITE));
            UNIT_TRUE(end != STEPPING_STUCK || x - x == 0);
            ends[cut] = s.steps;
        }
        UNIT_EQUAL(ends[0], ends[1]);
    }
}

/* With friction all methods but Euler's two have order 2 at least. */
TEST(test_friction, "orders with friction")
{
    double exact[2], state[2][4];
    for (const struct stepping_method *m = fixed_row(stepping_methods);
         m->name; m = fixed_row(m + 1)) {
        double error[2];
        double x[] = {1, 0.5}, v[] = {0, -1};
        go("gauss4", rough_forces, 1.0 / 1024, 2048, x, v);
        memcpy(exact, x, sizeof exact);
        for (int k = 0; k < 2; ++k) {
            const double start[] = {1, 0.5, 0, -1};
            memcpy(state[k], start, sizeof start);
            const uint64_t n = m->order > 4 ? 32 << k : 128 << k;
            go(m->name, rough_forces, 2.0 / (double)n, n, state[k],
               state[k] + 2);
            error[k] =
                fabs(state[k][0] - exact[0]) + fabs(state[k][1] - exact[1]);
        }
        const int order =
            m->family == STEPPING_SPLITTING && m->order > 2 ? 2 : m->order;
        UNIT_NEAR(log2(error[0] / error[1]), order, 0.1);
    }
}
