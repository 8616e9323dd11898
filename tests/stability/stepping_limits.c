/* Where stepping fails, and that it fails there: the limits of the step on
   an oscillator, from both sides, growth and decay that nobody ordered,
   and friction. The limits were computed apart from this program,
   but for Kahan and Li's, which is from the trace of a step (8,
   eq:stability-limit). */
#include "unit.h"

#include "library/forces.h"
#include "forces/stepping.h"
#include "library/methods.h"

/* x'' = -w^2 x - c v */
struct linear {
    double w, c;
};

FORCES(force)
{
    const struct linear *l = what;
    a[0] = -l->w * l->w * x[0] - l->c * v[0];
}

/* The largest of |x| and |v| in the last of so many steps of 1 s. */
static double size_after(const struct stepping_method *m, double w,
                         double c, uint64_t steps)
{
    struct linear l = {w, c};
    const struct stepping_forces f = {1, c != 0, force, &l};
    double x = 1, v = 0.3, most = 0;
    FREED(stepping) s;
    UNIT_MUST(stepping_begin(&s, m, f, 1, &x, &v));
    stepping_run(&s, steps);
    for (int k = 0; k < 100; ++k) {
        if (stepping_run(&s, 1) != STEPPING_DONE)
            most = INFINITY;
        most = fmax(most, fmax(fabs(x), fabs(v)));
    }
    return most;
}

static double size_by(const char *name, double w, double c, uint64_t steps)
{
    return size_after(stepping_find(name), w, c, steps);
}

/* The matrix of a step of 1 s of an oscillator of frequency w, for x and
   v / w: by its trace and its determinant. */
struct step {
    double trace, determinant;
};

static struct step step_of(const struct stepping_method *m, double w)
{
    struct linear l = {w, 0};
    const struct stepping_forces f = {1, false, force, &l};
    double x[] = {1, 0}, v[] = {0, w};
    for (int k = 0; k < 2; ++k) {
        FREED(stepping) s;
        UNIT_MUST(stepping_begin(&s, m, f, 1, &x[k], &v[k]));
        stepping_run(&s, 1);
    }
    return (struct step){x[0] + v[1] / w, (x[0] * v[1] - x[1] * v[0]) / w};
}

/* Is no eigenvalue beyond 1? Of rounding there is some 1e-15 in a step, and
   the growth of an explicit one at omega dt = 0.05 is of the order of
   1e-10. Implicit ones are asked up to 1000, and their equations are solved
   to a rounding of its square. */
static bool is_stable(const struct stepping_method *m, double w)
{
    const struct step s = step_of(m, w);
    const double slack = m->family == STEPPING_IMPLICIT ? 1e-9 : 1e-12;
    return s.determinant <= 1 + slack &&
           fabs(s.trace) <= 1 + s.determinant + slack;
}

/* The largest omega dt up to which all are stable: on a grid, then by
   halving. INFINITY: those up to 1000 are. */
static double find_limit(const struct stepping_method *m)
{
    double low = 0.05, high;
    if (!is_stable(m, low))
        return 0;
    for (high = low; is_stable(m, high); high += low < 20 ? 1e-3 : 1) {
        low = high;
        if (low > 1000)
            return INFINITY;
    }
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        if (is_stable(m, middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void check_limit(const struct stepping_method *m)
{
    const double limit = find_limit(m);
    if (isinf(limit))
        UNIT_TRUE(isinf(m->limit));
    else
        UNIT_NEAR(limit, m->limit, 1e-10);
}

TEST(test_limits, "every method has the limit of its row")
{
    each_method(check_limit);
}

/* And in long runs. A share d below its limit a splitting turns in the
   phase plane on a long ellipse, at most 1/sqrt(d) = 1000 long; a share d
   beyond it grows by some sqrt(d) = 1e-3 a step, in 1e5 steps by e^100. The
   factor of a Runge-Kutta method is 1 + C d with a C of 2.5 for RK4: in
   1e5 steps e^25 for d = 1e-4. */
static void check_long_runs(const struct stepping_method *m)
{
    const double d = m->family == STEPPING_EXPLICIT ? 1e-4 : 1e-6;
    if (!(m->limit > 0) || isinf(m->limit))
        return;
    UNIT_TRUE(size_after(m, m->limit * (1 - d), 0, 100000) < 1e4);
    UNIT_TRUE(size_after(m, m->limit * (1 + d), 0, 100000) > 1e8);
}

TEST(test_long_runs, "in long runs, from both sides")
{
    each_method(check_long_runs);
}

/* Those that were computed apart from this program. */
TEST(test_known_limits, "known limits are what they were")
{
    static const struct {
        const char *name;
        double limit;
    } known[] = {{"symplectic-euler", 2},     {"leapfrog", 2},
                 {"yoshida4", 1.57340194743}, {"yoshida6", 2.2690579964},
                 {"pefrl", 2.98944954591},    {"kahan-li8", 3.09643868000},
                 {"rk4", 2.82842712475}};
    for (int k = 0; k < 7; ++k)
        UNIT_NEAR(stepping_find(known[k].name)->limit, known[k].limit,
                  1e-10);
    /* Euler grows at any step: by (1 + h^2)^(n / 2). */
    UNIT_NEAR(log(size_by("euler", 0.01, 0, 399900) / 30.0), 20, 3);
    UNIT_TRUE(size_by("rk4", 2.828427 * (1 - 1e-4), 0, 100000) < 1e-8);
}

/* A method without a limit keeps what moves within its size. */
static void check_no_limit(const struct stepping_method *m)
{
    static const double ws[] = {1.9, 2.1, 10, 1000};
    for (int k = 0; isinf(m->limit) && k < 4; ++k)
        UNIT_TRUE(size_after(m, ws[k], 0, 1000) < 1.1 * ws[k]);
}

TEST(test_no_limit, "without a limit nothing grows")
{
    each_method(check_no_limit);
    /* Friction of 100 a step, and a spring as strong. */
    UNIT_TRUE(size_by("implicit-midpoint", 0, 100, 1000) < 1.1);
    UNIT_TRUE(size_by("gauss4", 10, 100, 1000) < 1.1);
}

/* The method of higher order is the first to fail: Forest and Ruth's, our
   yoshida4, lies below leapfrog. */
TEST(test_higher_is_not_safer, "Forest and Ruth fail before leapfrog")
{
    UNIT_TRUE(size_by("leapfrog", 1.8, 0, 1000) < 10);
    UNIT_TRUE(size_by("yoshida4", 1.8, 0, 1000) > 1e100);
}

/* The other failure, without a sound: at 2.5 RK4 swallows a mode whole. */
TEST(test_rk4_swallows, "RK4 damps a stiff mode silently")
{
    const double h = 2.5,
                 factor = sqrt(1 - pow(h, 6) / 72 + pow(h, 8) / 576);
    UNIT_TRUE(factor < 0.8);
    UNIT_TRUE(size_by("rk4", h, 0, 1000) < pow(factor, 1000) * 10);
}

/* More rows: an undamped oscillator grows under Heun's method (RK2) by
   1 + h^4/4 a step in the square, and under Fehlberg's of order 4 a
   little. */
static const double heun_a[] = {0, 0, 1, 0}, heun_b[] = {0.5, 0.5};
static const struct stepping_method heun = {.name = "heun",
                                            .family = STEPPING_EXPLICIT,
                                            .order = 2,
                                            .stages = 2,
                                            .a = heun_a,
                                            .b = heun_b};
static const double fehlberg_a[] = {0,
                                    0,
                                    0,
                                    0,
                                    0,
                                    1.0 / 4,
                                    0,
                                    0,
                                    0,
                                    0,
                                    3.0 / 32,
                                    9.0 / 32,
                                    0,
                                    0,
                                    0,
                                    1932.0 / 2197,
                                    -7200.0 / 2197,
                                    7296.0 / 2197,
                                    0,
                                    0,
                                    439.0 / 216,
                                    -8,
                                    3680.0 / 513,
                                    -845.0 / 4104,
                                    0};
static const double fehlberg_b[] = {25.0 / 216, 0, 1408.0 / 2565,
                                    2197.0 / 4104, -1.0 / 5};
static const struct stepping_method fehlberg = {.name = "rkf4",
                                                .family = STEPPING_EXPLICIT,
                                                .order = 4,
                                                .stages = 5,
                                                .a = fehlberg_a,
                                                .b = fehlberg_b};

TEST(test_more_rows, "Heun's and Fehlberg's methods grow")
{
    const double h = 0.2, grown = size_after(&heun, h, 0, 100000);
    UNIT_NEAR(log(grown) / (100000 * log(1 + pow(h, 4) / 4) / 2), 1, 0.1);
    UNIT_TRUE(size_after(&fehlberg, 0.5, 0, 100000) > 20);
    UNIT_TRUE(size_after(&fehlberg, 0.8, 0, 100000) > 1e10);
}

/* With friction alone a splitting's kicks stop working when c dt is too
   large, and the higher order needs more evaluations to get no further. */
TEST(test_friction_limits, "friction has limits too")
{
    static const struct {
        const char *name;
        double limit;
    } known[] = {{"leapfrog", 1},
                 {"euler", 2},
                 {"yoshida4", 2.3396},
                 {"pefrl", 2.1489},
                 {"rk4", 2.7853}};
    for (int k = 0; k < 5; ++k) {
        const double c = known[k].limit;
        UNIT_TRUE(size_by(known[k].name, 0, c * 0.99, 10000) < 100);
        UNIT_TRUE(size_by(known[k].name, 0, c * 1.01, 10000) > 1e20);
    }
}
