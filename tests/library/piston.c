/* The adiabatic springs against exact values and against each other.
   Reference values computed for this book by a program of its own. */
#include "unit.h"

#include "line/piston.h"

#include <float.h>

static const struct piston eleven = {
    40, 12, {10.0 / 3, 6, 0}, {10.0 / 3, 6, 0}};
static const struct piston heavy_gas = {
    40, 12, {10.0 / 3, 6, 20.0 / 3}, {10.0 / 3, 6, 20.0 / 3}};
/* Nothing about it is symmetric. */
static const struct piston lopsided = {7, 5, {2, 1, 0.6}, {1.5, 3, 1.2}};

static double tau(void)
{
    return 2 * acos(-1);
}

static double period_at(const struct piston *p, double velocity)
{
    const struct piston_state s = {6, velocity};
    return piston_period(p, piston_energy(p, &s), 64);
}

/* Exact in few roundings: K l^2 = 120, at a third of the length ninefold.
 */
TEST(test_adiabat, "K l^2 is constant")
{
    const struct piston_gas gas = {10.0 / 3, 6, 0};
    UNIT_NEAR(piston_gas_energy(&gas, 6), 10.0 / 3, 4 * DBL_EPSILON);
    UNIT_NEAR(piston_gas_energy(&gas, 2), 30, 60 * DBL_EPSILON);
    UNIT_NEAR(piston_gas_energy(&gas, 12), 10.0 / 12, 2 * DBL_EPSILON);
}

/* A force of 2K/l from either side; -dU/dx by a symmetric difference of
   1e-5, whose error is U'''/6 1e-10 < 2e-9 here, and rounding of U below
   1e-14 over the difference 2e-5: 1e-9. */
TEST(test_force, "the force is minus the slope of the energy")
{
    UNIT_EQUAL(piston_force(&eleven, 6), 0);
    UNIT_NEAR(piston_force(&eleven, 4), 2 * 7.5 / 4 - 2 * 1.875 / 8, 1e-14);
    for (double x = 1; x < 4.5; x += 0.25) {
        const double d = 1e-5;
        const double slope = (piston_potential(&lopsided, x + d) -
                              piston_potential(&lopsided, x - d)) /
                             (2 * d);
        const double third = 24 * (2 / pow(x, 5) + 13.5 / pow(5 - x, 5));
        UNIT_NEAR(piston_force(&lopsided, x), -slope, third * d * d + 2e-9);
    }
}

/* w0^2 = 12 K_s/(M h^2) = 1/36; with a third of 40/3 kg it is 1/40. */
TEST(test_small_swings, "small swings have their exact frequency")
{
    UNIT_NEAR(piston_rest(&eleven), 6, 1e-14);
    UNIT_NEAR(piston_frequency(&eleven), 1.0 / 6, 1e-15);
    UNIT_NEAR(piston_inertia(&heavy_gas), 400.0 / 9, 1e-13);
    UNIT_NEAR(piston_frequency(&heavy_gas), sqrt(1.0 / 40), 1e-15);
    UNIT_NEAR(tau() / piston_frequency(&eleven), 37.69911, 5e-6);
}

/* The rest is where the force vanishes, and the stiffness there is
   -dF/dx, by a symmetric difference: error below F''' d^2/6 ~ 1e-8. */
TEST(test_lopsided_rest, "unequal gases balance where the force is zero")
{
    const double x = piston_rest(&lopsided), d = 1e-5;
    const double stiffness =
        -(piston_force(&lopsided, x + d) - piston_force(&lopsided, x - d)) /
        (2 * d);
    UNIT_TRUE(x > 1 && x < 4);
    UNIT_NEAR(piston_force(&lopsided, x), 0, 1e-14);
    UNIT_NEAR(pow(piston_frequency(&lopsided), 2) *
                  piston_inertia(&lopsided),
              stiffness, 1e-7);
}

/* Periods given to the digits printed here, and where the piston turns. */
TEST(test_large_swings, "large swings have their reference periods")
{
    double low, high;
    const struct piston_state start = {6, 1};
    UNIT_NEAR(period_at(&eleven, 1), 20.20642, 5e-6);
    UNIT_NEAR(period_at(&eleven, 0.1), 37.23662, 5e-6);
    UNIT_NEAR(period_at(&eleven, 1e-4), tau() * 6, 1e-4);
    UNIT_TRUE(piston_turning_points(&eleven, piston_energy(&eleven, &start),
                                    &low, &high));
    UNIT_NEAR(high, 9.82746, 5e-6);
    UNIT_NEAR(low + high, 12, 1e-13);
}

/* The quadrature converges faster than any power: each doubling of the
   points squares the error, roughly, until 1e-13 is left. */
TEST(test_quadrature, "a few points give the period")
{
    const struct piston_state start = {2, 1};
    const double energy = piston_energy(&lopsided, &start);
    const double exact = piston_period(&lopsided, energy, 400);
    UNIT_NEAR(piston_period(&lopsided, energy, 4), exact, 1e-3 * exact);
    UNIT_NEAR(piston_period(&lopsided, energy, 8), exact, 1e-6 * exact);
    UNIT_NEAR(piston_period(&lopsided, energy, 32), exact, 1e-13 * exact);
    UNIT_NEAR(period_at(&eleven, 1), piston_period(&eleven, 80.0 / 3, 16),
              1e-12 * 20);
}

TEST(test_turning_points,
     "turning points exist at every energy above the rest")
{
    double low = -1, high = -1;
    const double x = piston_rest(&lopsided);
    const double least = piston_potential(&lopsided, x);
    UNIT_TRUE(
        !piston_turning_points(&lopsided, least * 0.999, &low, &high));
    UNIT_TRUE(!piston_turning_points(&lopsided, NAN, &low, &high));
    UNIT_TRUE(low == -1 && high == -1);
    UNIT_TRUE(isnan(piston_period(&lopsided, least / 2, 64)));
    UNIT_TRUE(isnan(piston_period(&lopsided, 2 * least, 0)));
    for (double factor = 1 + 1e-12; factor < 1e9; factor *= 10) {
        const double energy = factor * least;
        UNIT_TRUE(piston_turning_points(&lopsided, energy, &low, &high));
        UNIT_TRUE(0 < low && low <= x && x <= high && high < 5);
        UNIT_NEAR(piston_potential(&lopsided, low) / energy, 1, 1e-12);
    }
    /* At the bottom the period is that of small swings. */
    UNIT_NEAR(piston_period(&lopsided, least * (1 + 1e-10), 64) *
                  piston_frequency(&lopsided),
              tau(), 1e-6);
}

/* With any energy above that at rest the piston turns before the place of
   rest, even where only a few numbers lie between this and the wall, and
   Newton's steps come to them by rounding. */
TEST(test_turns_before_rest, "and lie before the rest")
{
    for (int i = 1; i <= 400; ++i) {
        const struct piston p = {1, 3, {1, 1, 0}, {1e-45 * i, 1, 0}};
        const double rest = piston_rest(&p);
        double energy = piston_potential(&p, rest), low, high;
        for (int above = 1; above < 4; ++above) {
            energy = nextafter(energy, INFINITY);
            UNIT_TRUE(piston_turning_points(&p, energy, &low, &high));
            UNIT_TRUE(0 < low && low < rest);
        }
    }
}

/* One swing of either stepper, from the middle to the middle. */
static double worst_energy(bool step(const struct piston *,
                                     struct piston_state *, double),
                           double dt, struct piston_state *s)
{
    const double energy = piston_energy(&eleven, s);
    double worst = 0;
    for (double t = 0; t < 20; t += dt) {
        UNIT_TRUE(step(&eleven, s, dt));
        worst = fmax(worst, fabs(piston_energy(&eleven, s) / energy - 1));
    }
    return worst;
}

/* Halving the step divides the error by 4 and by 16 (32 where the energy
   error of the fourth order is of the fifth); a third of that is
   allowed either way. */
TEST(test_orders, "steps have the second and the fourth order")
{
    struct piston_state a = {6, 1}, b = a, c = a, d = a;
    const double second = worst_energy(piston_step, 0.02, &a) /
                          worst_energy(piston_step, 0.01, &b);
    const double fourth = worst_energy(piston_step_rk4, 0.1, &c) /
                          worst_energy(piston_step_rk4, 0.05, &d);
    UNIT_NEAR(second, 4, 0.3);
    UNIT_TRUE(fourth > 11 && fourth < 43);
    UNIT_NEAR(b.x, d.x, 2e-3);
    UNIT_NEAR(b.v, d.v, 2e-3);
}

/* The leapfrog run backwards comes home, to the rounding of a thousand
   steps. */
TEST(test_reversal, "the leapfrog runs backwards")
{
    struct piston_state s = {1.3, 0.8};
    for (int i = 0; i < 1000; ++i)
        UNIT_TRUE(piston_step(&lopsided, &s, 0.01));
    UNIT_TRUE(fabs(s.x - 1.3) > 0.01 || fabs(s.v - 0.8) > 0.01);
    for (int i = 0; i < 1000; ++i)
        UNIT_TRUE(piston_step(&lopsided, &s, -0.01));
    UNIT_NEAR(s.x, 1.3, 1e-12);
    UNIT_NEAR(s.v, 0.8, 1e-12);
}

TEST(test_sound, "sound slows the piston as the formula says")
{
    const double w = piston_frequency_acoustic(&heavy_gas);
    UNIT_NEAR(tau() / w, 39.77915, 5e-6);
    /* w M = 2 rho c cot(w h/c), rho = 10/9, c^2 = 3. */
    UNIT_NEAR(w * 40, 20.0 / 9 * sqrt(3) / tan(w * 6 / sqrt(3)), 1e-12);
    UNIT_NEAR(piston_frequency_acoustic(&eleven), 1.0 / 6, 1e-15);
    /* Next to a very light gas the added mass is the whole truth. */
    struct piston light = heavy_gas;
    light.left.mass = light.right.mass = 1e-3;
    UNIT_NEAR(piston_frequency_acoustic(&light) / piston_frequency(&light),
              1, 1e-9);
    /* Next to a heavy one it is the wave that swings: below the pole. */
    light.left.mass = light.right.mass = 1e6;
    UNIT_NEAR(piston_frequency_acoustic(&light) * 6 / sqrt(20.0 / 1e6),
              acos(-1) / 2, 1e-3);
    UNIT_TRUE(piston_frequency_acoustic(&lopsided) <
              piston_frequency(&lopsided));
}

/* The first root of w M = sum of m c / l cot(w l / c), before either gas
   swings by itself, whatever the two are; a gas without mass is a spring.
 */
TEST(test_sound_of_unequal_gases, "whatever the gases are")
{
    static const double masses[][2] = {
        {0.5, 2}, {30, 2},  {2, 30},  {500, 2}, {2, 500},  {0, 7},
        {7, 0},   {0, 500}, {500, 0}, {0, 0},   {1e6, 1e6}};
    for (size_t k = 0; k < sizeof masses / sizeof masses[0]; ++k) {
        struct piston p = lopsided;
        p.left.mass = masses[k][0];
        p.right.mass = masses[k][1];
        const double w = piston_frequency_acoustic(&p);
        const double x = piston_rest(&p);
        double force = 0;
        for (int side = 0; side < 2; ++side) {
            const struct piston_gas *gas = side ? &p.right : &p.left;
            const double l = side ? p.length - x : x;
            const double K = piston_gas_energy(gas, l), m = gas->mass;
            const double c = sqrt(6 * K / m);
            force +=
                m > 0 ? m * c / l / tan(w * l / c) : 6 * K / (l * l) / w;
            UNIT_TRUE(m == 0 || w * l / c < acos(-1));
        }
        /* Near a pole a last bit of w is much of the force. */
        UNIT_NEAR(force / (w * p.mass), 1,
                  masses[k][0] > 1e3 ? 1e-7 : 1e-10);
    }
}

/* A step that would leave the box is refused and changes nothing, also one
   that would end at a wall. */
TEST(test_refused_steps, "steps out of the box are refused")
{
    static const struct {
        double x, v;
    } states[] = {{0.25, -1}, {4.75, 1}};
    const struct piston free = {.mass = 1, .length = 5};
    for (int k = 0; k < 2; ++k)
        for (int far = 0; far < 3; ++far) {
            struct piston_state s = {states[k].x, states[k].v}, t = s;
            const double dt = far == 0 ? 0.125 : far == 1 ? 0.25 : 0.375;
            UNIT_TRUE(piston_step(&free, &s, dt) == (far == 0));
            UNIT_TRUE(piston_step_rk4(&free, &t, dt) == (far == 0));
            const double x = states[k].x + (far ? 0 : states[k].v * dt);
            UNIT_EQUAL(s.x, x);
            UNIT_EQUAL(t.x, x);
            UNIT_EQUAL(s.v, states[k].v);
            UNIT_EQUAL(t.v, states[k].v);
        }
}
