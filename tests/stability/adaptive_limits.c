/* Where steps of their own length fail: energies in the long run,
   stiffness, and forces that jump. */
#include "unit.h"

#include "library/own_steps.h"

FORCES(springs)
{
    const double *stiff = what;
    a[0] = -x[0];
    a[1] = -*stiff * x[1];
}

FORCES(jumps)
{
    a[0] = x[0] > 0 ? -1 : 1;
}

/* The error of the energy after so many orbits of e = 0.5. */
static double lost(const char *name, double orbits)
{
    double x[] = {0.5, 0}, v[] = {0, sqrt(3)};
    OWN a = begun(name, orbit_forces, 1e-6, 1, x, v);
    UNIT_TRUE(adaptive_reach(a, orbits * 8 * atan(1), x, v));
    return fabs((v[0] * v[0] + v[1] * v[1]) / 2 - 1 / hypot(x[0], x[1]) +
                0.5);
}

/* The orbit shrinks by less than 1 % on the way. */
TEST(test_drift, "a pair loses energy in proportion to the orbits")
{
    const double few = lost("dopri5", 30), many = lost("dopri5", 300);
    UNIT_NEAR(many / few, 10, 0.2);
    UNIT_TRUE(many > 1e-4);
}

/* Steps of dopri5 in 10 s. */
static double steps(double stiff, double tolerance)
{
    const struct stepping_forces f = {2, false, springs, &stiff};
    double x[] = {1, 1e-12}, v[] = {0, 0};
    OWN a = begun("dopri5", f, tolerance, 1, x, v);
    UNIT_TRUE(adaptive_reach(a, 10, x, v));
    return (double)a->taken;
}

/* At most 1.2 of its radians fit into a step, however rough a result is
   asked for. */
TEST(test_stiff, "a stiff spring at rest holds the steps at its limit")
{
    UNIT_TRUE(steps(1, 1e-4) < 100);
    for (double e = 1e-4; e > 1e-9; e /= 100)
        UNIT_TRUE(steps(1e6, e) > 1e4 / 1.2);
}

TEST(test_jumps, "edges cost steps and digits")
{
    const struct stepping_forces f = {1, false, jumps, NULL};
    double x = 0.5, v = 0;
    OWN a = begun("dopri5", f, 1e-9, 1, &x, &v);
    UNIT_TRUE(adaptive_reach(a, 400, &x, &v));
    UNIT_TRUE(a->refused > 200 * 10);
    UNIT_TRUE(fabs(fabs(x) + v * v / 2 - 0.5) > 1e-7);
}
