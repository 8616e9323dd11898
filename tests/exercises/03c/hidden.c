/* The hidden tests of exercise 03c, "The exact law of the velocities". */

#include "examiner/check.h"
#include "call.h"

/* Velocity times distribution function, over an angle whose sine is the
   velocity: there the function has no corner at its ends. */
static double weighed(int n, double angle)
{
    return sin(angle) * cos(angle) * velocity_below(n, sin(angle));
}

/* From the lowest velocity to the largest, by Gauss's rule of five
   points. */
static double integral(int n)
{
    enum { STRIPS = 30 };
    const double root = 2.0 * sqrt(10.0 / 7.0), seventy = sqrt(70.0);
    const double near = sqrt(5.0 - root) / 3.0;
    const double far = sqrt(5.0 + root) / 3.0;
    const double heavy = (322.0 + 13.0 * seventy) / 900.0;
    const double light = (322.0 - 13.0 * seventy) / 900.0;
    const double h = acos(-1.0) / (2 * STRIPS);
    double sum = 0.0;
    for (int i = -STRIPS + 1; i < STRIPS; i += 2)
        sum += 128.0 / 225.0 * weighed(n, i * h) +
               heavy * weighed(n, (i - near) * h) +
               heavy * weighed(n, (i + near) * h) +
               light * weighed(n, (i - far) * h) +
               light * weighed(n, (i + far) * h);
    return h * sum;
}

/* In units of the largest velocity the squares of all n add up to 1. */
CHECK_TIMES(3, test_energy, i)
{
    const int n = check_draw_whole(2, 40);
    CHECK_NEAR(1.0 - 2.0 * integral(n),
               .quantity = "mean square velocity under your law",
               .input = check_text("n = %d movers", n), .expected = 1.0 / n,
               .tolerance = 1e-9, .because = "an integral in 30 strips");
}

/* The probability of more than 1 - e: an odd number of movers has a
   polynomial for it, which all but begins with its highest power. */
static double tail(int n, double e)
{
    const double u = 1.0 - e;
    switch (n) {
    case 2: return acos(u) / acos(-1.0);
    case 3: return e / 2.0;
    case 5: return e * e * (2.0 + u) / 4.0;
    case 7: return e * e * e * (8.0 + (9.0 + 3.0 * u) * u) / 16.0;
    default:
        return e * e * e * e * (16.0 + (29.0 + (20.0 + 5.0 * u) * u) * u) /
               32.0;
    }
}

/* The arcsine is steep at its end, where a rounding of u counts: not
   nearer than 1e-5. */
CHECK_TIMES(40, test_tails, i)
{
    static const int movers[] = {2, 3, 5, 7, 9};
    const int n = movers[i % 5];
    const double u = 1.0 - check_draw(1e-5, i % 2 ? 1e-3 : 0.2);
    const double side = i % 4 < 2 ? 1.0 : -1.0;
    const double past = tail(n, 1.0 - u);
    CHECK_NEAR(velocity_below(n, side * u),
               .quantity = "probability below u",
               .input = check_text("n = %d movers, u = %.10g", n, side * u),
               .expected = side > 0.0 ? 1.0 - past : past,
               .tolerance = 1e-13, .because = "what was asked for");
}

const struct check_test check_hidden[] = {
    {"the movers share the energy evenly", test_energy, 2, 0},
    {"hardly any velocity is near the largest", test_tails, 2, 0},
    {0}};
