/* Where the springs break: steps into a wall, and the edges of the
   quadrature. */
#include "unit.h"

#include "line/piston.h"

#include <float.h>

static const struct piston eleven = {
    40, 12, {10.0 / 3, 6, 0}, {10.0 / 3, 6, 0}};

typedef bool stepper(const struct piston *, struct piston_state *, double);
static stepper *const steppers[] = {piston_step, piston_step_rk4};

TEST(test_walls, "a step into a wall is refused")
{
    const struct {
        double x, v, dt;
    } cases[] = {{6, 1000, 0.1},   {6, -1000, 0.1},  {11.99, 1, 0.1},
                 {0.01, -1, 0.05}, {6, 12, 1},       {6, 1000, -0.1},
                 {6, NAN, 0.1},    {6, INFINITY, 1}, {1e-9, 0, 1}};
    for (size_t k = 0; k < 2; ++k)
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
            struct piston_state s = {cases[i].x, cases[i].v};
            UNIT_TRUE(!steppers[k](&eleven, &s, cases[i].dt));
            UNIT_EQUAL(s.x, cases[i].x);
            UNIT_TRUE(s.v == cases[i].v || isnan(cases[i].v));
        }
}

TEST(test_inside, "no step ends outside the box")
{
    size_t taken = 0, refused = 0;
    for (size_t k = 0; k < 2; ++k)
        for (double v = -40; v <= 40; v += 0.25)
            for (double dt = 0.01; dt < 1; dt *= 1.05) {
                struct piston_state s = {6, v};
                if (steppers[k](&eleven, &s, dt)) {
                    UNIT_TRUE(s.x > 0 && s.x < 12);
                    ++taken;
                } else {
                    ++refused;
                }
            }
    UNIT_TRUE(taken > 10000 && refused > 10000);
}

/* At 10 m/s a step of 0.01 s gets through, but the energy shows what it
   is worth; a tenth of it is a hundred times better (second order), give
   or take a third. */
static double energy_error(double dt)
{
    struct piston_state s = {6, 10};
    const double energy = piston_energy(&eleven, &s);
    double worst = 0;
    for (double t = 0; t < 20; t += dt) {
        UNIT_TRUE(piston_step(&eleven, &s, dt));
        worst = fmax(worst, fabs(piston_energy(&eleven, &s) / energy - 1));
    }
    return worst;
}

TEST(test_near_miss, "a near miss shows in the energy")
{
    const double coarse = energy_error(0.01), fine = energy_error(0.001);
    UNIT_TRUE(coarse > 0.01 && coarse < 0.1);
    UNIT_TRUE(coarse / fine > 67 && coarse / fine < 150);
}

/* A piston so fast that the gases are hard walls: it runs to and fro, at
   its speed, over the box less two turning lengths h sqrt(U/E). The
   points must be more, and then the quadrature still holds: 1e-3 is the
   next order in the turning length 6/1000. */
TEST(test_hard_walls, "a very fast piston sees hard walls")
{
    const struct piston_state s = {6, 1000};
    const double energy = piston_energy(&eleven, &s);
    const double exact = piston_period(&eleven, energy, 1 << 16);
    UNIT_NEAR(exact, 2 * 12.0 / 1000, 1e-3 * exact);
    UNIT_TRUE(fabs(piston_period(&eleven, energy, 16) / exact - 1) > 1e-6);
    UNIT_NEAR(piston_period(&eleven, energy, 1 << 14), exact, 1e-6 * exact);
}

/* At the very bottom, where Newton's method divides zero by zero. */
TEST(test_bottom, "turning points meet at the bottom")
{
    double low, high;
    for (double ratio = 0.01; ratio < 101; ratio *= 1.01) {
        struct piston p = eleven;
        p.left.energy *= ratio;
        const double x = piston_rest(&p);
        const double energy = piston_potential(&p, x);
        UNIT_TRUE(piston_turning_points(&p, energy, &low, &high));
        UNIT_NEAR(low, x, 1e-6); /* root of the rounding error */
        UNIT_NEAR(high, x, 1e-6);
    }
}

/* A gas a million times weaker than the other one. */
TEST(test_weak_gas, "a weak gas is pushed to its wall")
{
    struct piston p = eleven;
    p.left.energy = 1e-6;
    const double x = piston_rest(&p);
    UNIT_TRUE(x > 0 && x < 1);
    UNIT_NEAR(piston_force(&p, x) / (2 * piston_gas_energy(&p.left, x) / x),
              0, 1e-12);
    const double energy = piston_potential(&p, x) * (1 + 1e-9);
    UNIT_NEAR(piston_period(&p, energy, 64) * piston_frequency(&p),
              2 * acos(-1), 1e-6);
}
