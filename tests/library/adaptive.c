/* Methods with steps of their own length: the numbers of their rows, their
   orders in steps of one length and between the ends of steps, and what
   tolerances give where the truth is known. */
#include "unit.h"

#include "library/own_steps.h"
#include "toolbox/quad.h"

#include <float.h>

static const char *const names[] = {"dopri5", "radau15"};

FORCES(oscillator)
{
    a[0] = -x[0];
}

FORCES(damped)
{
    a[0] = -x[0] - 0.4 * v[0];
}

/* Three bodies in a plane; x: three numbers, then y. */
static void attract(double G, const double m[], const double x[],
                    double a[])
{
    memset(a, 0, 6 * sizeof *a);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) {
            const double dx = x[j] - x[i], dy = x[3 + j] - x[3 + i];
            const double r2 = dx * dx + dy * dy, f = G / (r2 * sqrt(r2));
            a[i] += m[j] * f * dx;
            a[3 + i] += m[j] * f * dy;
            a[j] -= m[i] * f * dx;
            a[3 + j] -= m[i] * f * dy;
        }
}

/* The Pythagorean problem: 3, 4 and 5 kg at rest, opposite to the sides of
   these lengths, G = 1. */
FORCES(three)
{
    static const double m[] = {3, 4, 5};
    attract(1, m, x, a);
}

static void begin(struct stepping *s, const char *name,
                  struct stepping_forces f, double dt, double tolerance,
                  double x[], double v[])
{
    UNIT_MUST(stepping_begin(s, stepping_find(name), f, dt, x, v));
    s->tolerance = tolerance;
}

/* All rooted trees with up to five nodes, each as the nodes' parents, and
   what the sum of a method has to be: 1 / gamma. */
static const struct {
    int nodes, parent[5];
    double sum;
} tree[] = {{1, {0}, 1},
            {2, {0, 0}, 1 / 2.0},
            {3, {0, 0, 0}, 1 / 3.0},
            {3, {0, 0, 1}, 1 / 6.0},
            {4, {0, 0, 0, 0}, 1 / 4.0},
            {4, {0, 0, 0, 1}, 1 / 8.0},
            {4, {0, 0, 1, 1}, 1 / 12.0},
            {4, {0, 0, 1, 2}, 1 / 24.0},
            {5, {0, 0, 0, 0, 0}, 1 / 5.0},
            {5, {0, 0, 0, 0, 1}, 1 / 10.0},
            {5, {0, 0, 0, 1, 1}, 1 / 15.0},
            {5, {0, 0, 0, 1, 3}, 1 / 30.0},
            {5, {0, 0, 0, 1, 2}, 1 / 20.0},
            {5, {0, 0, 1, 1, 1}, 1 / 20.0},
            {5, {0, 0, 1, 1, 2}, 1 / 40.0},
            {5, {0, 0, 1, 2, 2}, 1 / 60.0},
            {5, {0, 0, 1, 2, 3}, 1 / 120.0}};
enum { TREES = sizeof tree / sizeof *tree };

/* The sum over stages that belongs to a tree, for weights b. */
static double sum_over(const struct stepping_method *m, int t,
                       const double b[])
{
    double at[5][7], sum = 0;
    for (int k = 0; k < tree[t].nodes; ++k)
        for (int i = 0; i < 7; ++i)
            at[k][i] = 1;
    for (int k = tree[t].nodes; k-- > 1;)
        for (int i = 0; i < 7; ++i) {
            double branch = 0;
            for (int j = 0; j < 7; ++j)
                branch += m->a[i * 7 + j] * at[k][j];
            at[tree[t].parent[k]][i] *= branch;
        }
    for (int i = 0; i < 7; ++i)
        sum += b[i] * at[0][i];
    return sum;
}

/* The sums have terms of up to 12 that cancel: 100 DBL_EPSILON. */
TEST(test_pair_conditions, "the pair meets the conditions of its orders")
{
    const struct stepping_method *m = stepping_find("dopri5");
    double other[7];
    for (int i = 0; i < 7; ++i)
        other[i] = m->a[6 * 7 + i] - m->error[i];
    for (int t = 0; t < TREES; ++t) {
        UNIT_NEAR(sum_over(m, t, m->a + 6 * 7), tree[t].sum,
                  100 * DBL_EPSILON);
        if (tree[t].nodes < 5)
            UNIT_NEAR(sum_over(m, t, other), tree[t].sum,
                      100 * DBL_EPSILON);
        /* 1/gamma of the four trees of order four, times 4!/(24 ...):
           nothing below, and the fourth derivative over 24. */
        if (tree[t].nodes < 5)
            UNIT_NEAR(sum_over(m, t, m->dense),
                      tree[t].nodes == 4 ? tree[t].sum : 0,
                      100 * DBL_EPSILON);
    }
    double worst = 0;
    for (int t = 8; t < TREES; ++t)
        worst = fmax(worst, fabs(sum_over(m, t, other) - tree[t].sum));
    UNIT_TRUE(worst > 1e-4); /* of order 4, and no more */
}

/* A node that is rounded by half its last digit moves the polynomial by its
   slope there, 60 at most where the digit is smallest, times that; terms of
   up to 4e4 cancel in 113 bits, or 64. */
TEST(test_nodes, "Radau's nodes are zeros of their polynomial")
{
    static const int c[] = {-8,     252,   -2520,  11550,
                            -27720, 36036, -24024, 6435};
    const struct stepping_method *m = stepping_find("radau15");
    for (size_t k = 0; k < m->stages; ++k) {
        quad sum = 0;
        for (int i = 7; i >= 0; --i)
            sum = sum * m->node[k] + c[i];
        UNIT_NEAR(sum, 0, (QUAD_DIGITS > 64 ? 2 : 100) * DBL_EPSILON);
        UNIT_TRUE(m->node[k] > (k ? m->node[k - 1] : 0) && m->node[k] < 1);
    }
}

/* Head and tail together integrate t to t^7 twice and once to the digits of
   the tails, 1e-33 each, in 113 bits; in 64 to those of the type. A head
   alone misses by up to 1e-17. */
TEST(test_weights, "the weights of the end have tails")
{
    const struct stepping_method *m = stepping_find("radau15");
    const double enough = QUAD_DIGITS > 64 ? 1e-31 : 4e-19;
    for (int k = 1; k < 8; ++k) {
        quad once = (quad)-1 / (k + 1), twice = once / (k + 2);
        for (size_t i = 0; i < m->stages; ++i) {
            const double *const w = m->weight + 4 * i;
            quad power = 1;
            for (int j = 0; j < k; ++j)
                power *= m->node[i];
            once += ((quad)w[0] + w[1]) * power;
            twice += ((quad)w[2] + w[3]) * power;
        }
        UNIT_NEAR(once, 0, enough);
        UNIT_NEAR(twice, 0, enough);
    }
}

/* Two stars and a planet, as scene circumbinary has them at first; then
   4000 orbits of the stars. */
static const double circumbinary[] = {0.6897, 0.2026, 0.000318};

FORCES(planet)
{
    attract(0.00029584, circumbinary, x, a);
}

static quad planet_energy(const struct adaptive_state *at)
{
    const double *const m = circumbinary;
    quad sum = 0;
    for (int i = 0; i < 3; ++i) {
        const quad u = at->v[i], w = at->v[3 + i];
        sum += m[i] * (u * u + w * w) / 2;
        for (int j = 0; j < i; ++j) {
            const quad dx = (quad)at->x[j] - at->x[i];
            const quad dy = (quad)at->x[3 + j] - at->x[3 + i];
            const quad r2 = dx * dx + dy * dy;
            quad r = sqrt((double)r2);
            r = (r + r2 / r) / 2;
            sum -= (quad)0.00029584 * m[i] * m[j] / r;
        }
    }
    return sum;
}

/* 60000 steps, each wrong by 1.5e-16 at random: 3.7e-14, and no run of five
   is five times that off. With weights of one double,
   or tails that are lost, it is a drift of 2e-18 and more a step, 1.2e-13
   in the mean: the mean of the five has to be below three of its standard
   errors, 5e-14. */
TEST(test_drift, "the energy walks, and does not drift")
{
    static const struct stepping_forces f = {6, false, planet, NULL};
    double mean = 0;
    for (int k = 0; k < 5; ++k) {
        double x[] = {-0.050928140759834137,
                      0.17337185924016585,
                      0.7 + 0.002 * k,
                      0,
                      0,
                      0};
        double v[] = {0,
                      0,
                      0,
                      -0.0077892887706889026,
                      0.026516645928648254,
                      0.0193531180486913};
        OWN s = begun("radau15", f, 1e-13, 1, x, v);
        UNIT_TRUE(adaptive_reach(s, 1, x, v));
        const quad before = planet_energy(&s->to);
        UNIT_TRUE(adaptive_reach(s, 200000, x, v));
        const double error =
            (double)((planet_energy(&s->to) - before) / before);
        UNIT_NEAR(error, 0, 5 * 3.7e-14);
        mean += error / 5;
    }
    UNIT_NEAR(mean, 0, 5e-14);
}

/* The error after 8 units of time in n steps of one length, with a friction
   of 2c. */
static double error_of(const char *name, double c, int n)
{
    struct stepping s;
    double x = 1, v = 0.3;
    const struct stepping_forces f = {1, c > 0, c > 0 ? damped : oscillator,
                                      NULL};
    begin(&s, name, f, 8.0 / n, 0, &x, &v);
    UNIT_TRUE(stepping_run(&s, (uint64_t)n) == STEPPING_DONE);
    UNIT_EQUAL(s.own->taken, n);
    stepping_free(&s);
    const double w = sqrt(1 - c * c), b = (0.3 + c) / w;
    const double p = cos(8 * w), q = sin(8 * w), size = exp(-8 * c);
    return hypot(size * (p + b * q) - x,
                 size * ((b * w - c) * p - (w + c * b) * q) - v);
}

/* The second coordinate is the time, and the force on the first its
   `degree`-th power. */
FORCES(power)
{
    const int *degree = what;
    a[0] = 1, a[1] = 0;
    for (int k = 0; k < *degree; ++k)
        a[0] *= x[1];
}

/* How much the velocity misses after one step of length 1. */
static double miss(int degree)
{
    const struct stepping_forces f = {2, false, power, &degree};
    double x[] = {0, 0}, v[] = {0, 1};
    MADE(stepping, s, begin(&s, "radau15", f, 1, 0, x, v));
    UNIT_TRUE(stepping_run(&s, 1) == STEPPING_DONE);
    return v[0] - 1.0 / (degree + 1);
}

/* The error of dopri5 in 100 and 200 steps, where the next term is felt by
   less than 0.1; radau15 has two errors above rounding at steps of 2.7 and
   2, where it is felt more. So its quadrature is tested: it is exact up
   to t^14, and t^15 is missed by the integral of c times the square of the
   polynomial, whose leading coefficient is 1, 1 / (16 6435^2). */
TEST(test_orders, "steps of one length have orders 5 and 15")
{
    const int order = stepping_find("radau15")->order;
    for (int k = 0; k < 2; ++k) {
        const double c = 0.2 * k;
        UNIT_NEAR(
            log2(error_of("dopri5", c, 100) / error_of("dopri5", c, 200)),
            stepping_find("dopri5")->order, 0.1);
    }
    UNIT_TRUE(log(error_of("radau15", 0, 3) / error_of("radau15", 0, 4)) >
              14.5 * log(4 / 3.0));
    for (int degree = 0; degree < order; ++degree)
        UNIT_NEAR(miss(degree), 0, 100 * DBL_EPSILON);
    UNIT_NEAR(miss(order) * 16 * 6435 * 6435, -1, 1e-5);
}

/* The largest error inside of one step of length h, seen at 20 places. */
static double error_inside(const char *name, double h)
{
    double x = 1, v = 0.3, worst = 0;
    const struct stepping_forces f = {1, false, oscillator, NULL};
    OWN a = begun(name, f, 0, h, &x, &v);
    for (int k = 1; k <= 20; ++k) {
        const double t = h * k / 20;
        UNIT_TRUE(adaptive_reach(a, t, &x, &v));
        worst = fmax(worst, fabs(cos(t) + 0.3 * sin(t) - x));
        worst = fmax(worst, fabs(0.3 * cos(t) - sin(t) - v));
    }
    UNIT_EQUAL(a->taken, 1);
    return worst;
}

/* Inside of a step of length h the error goes with h^5 for the pair, and
   with h^9 for the velocity under eight forces. */
TEST(test_dense, "between the ends the orders are 4 and 8")
{
    UNIT_NEAR(
        log2(error_inside("dopri5", 0.1) / error_inside("dopri5", 0.05)), 5,
        0.2);
    UNIT_NEAR(
        log2(error_inside("radau15", 0.8) / error_inside("radau15", 0.4)),
        9, 0.3);
}

/* An orbit of e = 0.9 once round: error of the energy. */
static double kepler(const char *name, double tolerance, double *steps)
{
    struct stepping s;
    double x[] = {0.1, 0}, v[] = {0, sqrt(19)};
    begin(&s, name, orbit_forces, 8 * atan(1), tolerance, x, v);
    UNIT_TRUE(stepping_run(&s, 1) == STEPPING_DONE);
    *steps = (double)s.own->taken;
    stepping_free(&s);
    return fabs((v[0] * v[0] + v[1] * v[1]) / 2 - 1 / hypot(x[0], x[1]) +
                0.5);
}

/* A hundred times the tolerance, and a share of the energy near the star,
   19 times that of the orbit; the number of steps goes with the fifth root
   of the tolerance, or the fourteenth. */
TEST(test_tolerances, "energies follow tolerances")
{
    for (int k = 0; k < 2; ++k) {
        double few, many;
        for (double e = 1e-6; e > 1e-13; e /= 10) {
            double steps;
            UNIT_TRUE(kepler(names[k], e, &steps) < 500 * e);
        }
        kepler(names[k], 1e-8, &few);
        kepler(names[k], 1e-12, &many);
        UNIT_NEAR(log(many / few) / log(1e4), k ? 1 / 14.0 : 1 / 5.0, 0.02);
    }
}

/* From the start to the closest approach of the Pythagorean bodies, in
   ticks: its time and its distance, by the parabola of the squares. */
static void approach(double tolerance, double *when, double *near)
{
    enum { TICKS = 4000 };
    const double tick = 5e-8, from = 15.82982;
    static const struct stepping_forces f = {6, false, three, NULL};
    double x[] = {1, -2, 1, 3, -1, -1}, v[6] = {0}, d[3] = {INFINITY};
    OWN a = begun("radau15", f, tolerance, 1, x, v);
    *near = INFINITY;
    for (int k = 0; k < TICKS; ++k) {
        UNIT_TRUE(adaptive_reach(a, from + k * tick, x, v));
        double now = INFINITY;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const double dx = x[i] - x[j], dy = x[3 + i] - x[3 + j];
            now = fmin(now, dx * dx + dy * dy);
        }
        d[0] = d[1], d[1] = d[2], d[2] = now;
        if (k < 2 || d[1] > d[0] || d[1] > d[2] || d[1] > *near)
            continue;
        const double slope = (d[2] - d[0]) / 2;
        const double bend = d[2] - 2 * d[1] + d[0];
        *near = sqrt(d[1] - slope * slope / 2 / bend);
        *when = from + (k - 1 - slope / bend) * tick;
    }
}

/* Szebehely and Peters (1967) have 4e-4 at 15.8299. */
TEST(test_three_bodies, "the Pythagorean bodies meet when they should")
{
    double when = 0, near;
    approach(1e-13, &when, &near);
    UNIT_NEAR(when, 15.829920, 1e-6);
    UNIT_NEAR(near, 4.13825e-4, 2e-9);
}

/* Looking changes nothing: ends of steps and rows are the same bits however
   many times are asked for. */
TEST(test_looks, "looking changes no bit")
{
    for (int k = 0; k < 2; ++k) {
        double at[3][4], taken[3];
        static const int ticks[] = {1, 16, 128};
        for (int n = 0; n < 3; ++n) {
            FREED(stepping) s;
            double *const x = at[n], *const v = at[n] + 2;
            x[0] = 0.1, x[1] = v[0] = 0, v[1] = sqrt(19);
            begin(&s, names[k], orbit_forces, 4.0 / ticks[n], 1e-9, x, v);
            for (int i = 0; i < ticks[n]; ++i)
                UNIT_TRUE(stepping_run(&s, 1) == STEPPING_DONE);
            taken[n] = (double)s.own->taken;
            UNIT_EQUAL(stepping_time(&s), 4);
        }
        UNIT_EQUAL(taken[0], taken[2]);
        UNIT_TRUE(!memcmp(at[0], at[1], sizeof at[0]));
        UNIT_TRUE(!memcmp(at[0], at[2], sizeof at[0]));
    }
}

/* One way on one side, the other way on the other. */
FORCES(edge)
{
    a[0] = x[0] > 0 ? -1 : 1;
}

/* From 1 m at rest, 283 edges in 400 s. Each may be passed late or early by
   the shortest step, 4 * 2^-52 * 400 s, in which the force is wrong by 2 at
   a speed of root 2: so much energy, of 1, at most each time. */
TEST(test_edges, "edges are passed")
{
    const struct stepping_forces f = {1, false, edge, NULL};
    for (int k = 0; k < 40; ++k) {
        double x = 1 + 0.01 * k, v = 0;
        const double energy = x;
        OWN s = begun("radau15", f, 1e-10, 1, &x, &v);
        UNIT_TRUE(adaptive_reach(s, 400, &x, &v));
        UNIT_NEAR(v * v / 2 + fabs(x), energy,
                  283 * 2 * sqrt(2 * energy) * 4 * DBL_EPSILON * 400);
    }
}

/* A stiff spring, hanging, that swings by a nanometre, beside a soft one;
   after half a million calls it says nothing more. */
FORCES(hanging)
{
    int *calls = what;
    a[0] = ++*calls < 500000 ? -5e7 * (x[0] - 1) - 10 : NAN;
    a[1] = -x[1];
}

/* A body that flies past, and one that has come to rest on its spring, but
   for the last digits. */
FORCES(resting)
{
    a[0] = 0;
    a[1] = -100 * (x[1] - 1 / 3.0);
}

/* Nothing acts that asks for short steps; but a step of many periods would
   make a swing of rounding, 5e-17 m. It may grow by 1e-16 of 1/3 m in each
   of some hundred steps, and no more. */
TEST(test_rest, "what rests goes on resting")
{
    const struct stepping_forces f = {2, false, resting, NULL};
    for (int k = -6; k >= -12; k -= 2) {
        double x[] = {0, 1 / 3.0 + 1e-16}, v[] = {1, 0}, tolerance = 1;
        for (int j = k; j < 0; ++j)
            tolerance /= 10;
        OWN s = begun("radau15", f, tolerance, 1, x, v);
        UNIT_TRUE(adaptive_reach(s, 100, x, v));
        UNIT_NEAR(x[0], 100, 1e-11);
        UNIT_NEAR(x[1], 1 / 3.0, 1e-14);
    }
}

/* 7071 radians in a second, and some thirty calls to a radian, 210 000.
   The rounding of x makes 1e-8 of a force that is 0.05 at most, and a
   control that takes it for an error is not done after three million. */
TEST(test_noise, "rounding is no error")
{
    int calls = 0;
    const struct stepping_forces f = {2, false, hanging, &calls};
    double x[] = {1 - 10 / 5e7 + 1e-9, 1}, v[] = {0, 0};
    OWN s = begun("radau15", f, 1e-11, 1, x, v);
    UNIT_TRUE(adaptive_reach(s, 1, x, v));
    UNIT_TRUE(calls < 500000);
    UNIT_NEAR(x[1], cos(1), 1e-12);
}

/* Two bodies that fall into each other: no step is short enough. */
TEST(test_collision, "a fall into the centre ends")
{
    for (int k = 0; k < 2; ++k) {
        FREED(stepping) s;
        double x[] = {1, 0}, v[] = {0, 0};
        begin(&s, names[k], orbit_forces, 1, 1e-10, x, v);
        UNIT_TRUE(stepping_run(&s, 1) == STEPPING_DONE);
        const double before = x[0];
        UNIT_TRUE(stepping_run(&s, 1) == STEPPING_STUCK);
        UNIT_EQUAL(x[0], before);
        UNIT_EQUAL(stepping_time(&s), 1);
    }
}

TEST(test_disturbed, "a disturbed run begins anew")
{
    for (int k = 0; k < 2; ++k) {
        double x = 1, v = 0;
        const struct stepping_forces f = {1, false, oscillator, NULL};
        MADE(stepping, s, begin(&s, names[k], f, 0.5, 1e-12, &x, &v));
        stepping_run(&s, 3);
        x = 0, v = 1;
        stepping_disturb(&s);
        stepping_run(&s, 2);
        UNIT_NEAR(x, sin(1), 1e-11);
        UNIT_EQUAL(stepping_time(&s), 2.5);
    }
}

/* A swing that is put to its middle, but for rounding, where there is no
   force to compare with, goes on in steps as long as before. */
TEST(test_middle, "where there is no force, steps are long")
{
    const struct stepping_forces f = {1, false, oscillator, NULL};
    const double middle = 0x1p-60, speed = 1;
    double x = 1, v = 0;
    OWN a = begun("radau15", f, 1e-13, 1, &x, &v);
    UNIT_TRUE(adaptive_reach(a, 5, &x, &v));
    const double t = a->t, refused = (double)a->refused;
    adaptive_turn(a, &middle, &speed);
    UNIT_TRUE(adaptive_reach(a, t + 10, &x, &v));
    UNIT_NEAR(x, sin(10), 1e-13);
    UNIT_NEAR(a->refused, refused, 2);
}

/* The path of a step that is taken again to a part of it, as control
   points, is what one sees in it. */
TEST(test_path, "the path in a part of a step")
{
    const struct stepping_forces f = {1, false, oscillator, NULL};
    for (int k = 0; k < 2; ++k) {
        double q[ADAPTIVE_DEGREE + 1], x = 1, v = 0.3, seen, speed;
        OWN a = begun(names[k], f, 0, 1, &x, &v);
        UNIT_TRUE(adaptive_step(a, 1));
        adaptive_again(a, 0.75, &x, &v);
        UNIT_EQUAL(a->t, 0.75);
        UNIT_NEAR(x, cos(0.75) + 0.3 * sin(0.75), k ? 1e-13 : 1e-4);
        size_t degree = adaptive_path(a, q);
        for (; degree > 0; --degree) /* de Casteljau, at a quarter */
            for (size_t j = 0; j < degree; ++j)
                q[j] += (q[j + 1] - q[j]) / 4;
        adaptive_look(a, 0.75 / 4, &seen, &speed);
        UNIT_NEAR(q[0], seen, 10 * DBL_EPSILON);
    }
}

static double tenth(void *with, const double x[], const double v[],
                    const double a[])
{
    (void)with, (void)x, (void)v, (void)a;
    return 0.1;
}

/* Steps that only bounds or the first one make short, of two tolerances:
   with some slack they are all others. */
TEST(test_slack, "with slack no step is another run's")
{
    const struct stepping_forces f = {1, false, oscillator, NULL};
    for (int k = 0; k < 3; ++k) {
        const double most = k == 2 ? 0.1 : 1;
        double x = 1, v = 0;
        OWN a = begun("radau15", f, 1e-8, 1, &x, &v);
        OWN b = begun("radau15", f, 1e-10, 1, &x, &v);
        a->longest = b->longest = k == 1 ? tenth : NULL;
        b->slack = 0.2;
        adaptive_begin(a, 1e-8, 1, 0, &x, &v);
        adaptive_begin(b, 1e-10, 1, 0, &x, &v);
        for (int n = 0; n < (k > 0 ? 8 : 2); ++n) {
            UNIT_TRUE(adaptive_step(a, most) && adaptive_step(b, most));
            UNIT_NEAR(b->h, 0.8 * a->h, 1e-9);
        }
    }
}
