/* The adaptive method from outside against what is known exactly. */
#include "unit.h"

#include "library/forces.h"
#include "oscillator.h"
#include "forces/reference.h"

#include <gsl/gsl_version.h>

/* Ten orbits of eccentricity 1/2, in pieces: an error of the tolerance in
   some 60 steps an orbit, and errors grow with the square of the time. */
static double orbit_error(double tolerance, int pieces)
{
    const double period = 2 * acos(-1);
    double x[] = {0.5, 0}, v[] = {0, sqrt(3)};
    FREED(reference) r;
    UNIT_TRUE(reference_begin(
        &r, (struct stepping_forces){2, false, orbit, NULL}, tolerance));
    for (int k = 0; k < pieces; ++k)
        UNIT_TRUE(reference_step(&r, 10 * period / pieces, x, v));
    UNIT_TRUE(r.evaluations > 1000);
    return hypot(x[0] - 0.5, x[1]);
}

TEST(test_orbit, "an orbit")
{
    UNIT_TRUE(reference_available);
    UNIT_TRUE(orbit_error(1e-13, 1) < 1e-10);
    UNIT_TRUE(orbit_error(1e-13, 40) < 1e-10);
    UNIT_TRUE(orbit_error(1e-6, 1) > 1e-6);
}

FORCES(friction)
{
    a[0] = -x[0] - 0.2 * v[0];
}

/* A tenth of the critical damping: oscillator_known[0]. */
TEST(test_friction, "an oscillator with friction")
{
    double x = 1, v = 0;
    FREED(reference) r;
    reference_begin(&r, (struct stepping_forces){1, true, friction, NULL},
                    1e-14);
    UNIT_TRUE(reference_step(&r, 5, &x, &v));
    UNIT_NEAR(x, oscillator_known[0][2], 1e-13);
    UNIT_TRUE(reference_step(&r, 5, &x, &v));
    UNIT_NEAR(x, oscillator_known[0][3], 1e-13);
}

FORCES(nowhere)
{
    a[0] = x[0] > 1 ? NAN : 1;
}

TEST(test_gives_up, "it says when it gives up")
{
    double x = 0, v = 0;
    FREED(reference) r;
    reference_begin(&r, (struct stepping_forces){1, false, nowhere, NULL},
                    1e-10);
    UNIT_TRUE(!reference_step(&r, 5, &x, &v));
}
