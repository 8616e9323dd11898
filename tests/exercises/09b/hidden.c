/* The hidden tests of exercise 09b, "Speeds for a circle". */

#include "examiner/check.h"
#include "call.h"

static void check(double got, double expected, const char *quantity,
                  const char *input, const char *equation)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = 4e-12 * fabs(expected),
               .because = "4 times what was asked for a speed",
               .equation = equation);
}

/* On circles the kinetic energy is half of minus the potential energy, and
   the total momentum is zero. */
CHECK_TIMES(30, test_virial, i)
{
    const double k2 = pow(10.0, check_draw(-8.0, 8.0));
    const double m1 = pow(10.0, check_draw(-8.0, 8.0));
    const double m2 = pow(10.0, check_draw(-8.0, 8.0));
    const double d = pow(10.0, check_draw(-8.0, 8.0));
    double v1 = NAN, v2 = NAN;
    const char *input =
        check_text("k2 = %g m^3/(kg s^2), m1 = %g kg, m2 = %g kg, d = %g m",
                   k2, m1, m2, d);
    binary_speeds(k2, m1, m2, d, &v1, &v2);
    check(m1 * v1 * v1 + m2 * v2 * v2, k2 * m1 * m2 / d,
          "twice the kinetic energy", input, "eq:binary-speeds");
    check(m1 * v1, m2 * v2, "the momentum of the first", input,
          "eq:binary-speeds");
}

/* Twice the masses, or half the radius: faster by a root of 2. */
CHECK_TIMES(20, test_units, i)
{
    const size_t n = (size_t)check_draw_whole(2, 300);
    const double k2 = check_draw(0.1, 9.0), m = check_draw(0.1, 9.0);
    const double r = check_draw(0.1, 9.0);
    const double unit = ldexp(1.0, 2 * check_draw_whole(-40, 40));
    const double v = choreography_speed(k2, n, m, r);
    const char *input =
        check_text("k2 = %g m^3/(kg s^2), n = %zu, %g kg each, radius %g m",
                   k2, n, m, r);
    check(choreography_speed(k2, n, unit * m, r), sqrt(unit) * v,
          "the speed with other masses", input, "eq:choreography-speed");
    check(choreography_speed(k2, n, m, r / unit), sqrt(unit) * v,
          "the speed on another circle", input, "eq:choreography-speed");
    check(choreography_speed(unit * k2, n, m, r), sqrt(unit) * v,
          "the speed with another k2", input, "eq:choreography-speed");
}

/* Of twice as many bodies every other one belongs to the ring of n. The
   odd ones add 1/sin of the odd parts of the circle. */
CHECK_TIMES(10, test_twice_as_many, i)
{
    const double quarter = atan(1.0);
    const size_t n = (size_t)check_draw_whole(1, 200);
    const double k2 = check_draw(0.1, 9.0), m = check_draw(0.1, 9.0);
    const double r = check_draw(0.1, 9.0);
    const double few = choreography_speed(k2, n, m, r);
    const double many = choreography_speed(k2, 2 * n, m, r);
    double odd = 0.0;
    for (size_t j = 0; j < n; ++j) {
        const size_t part = 2 * j + 1 < n ? 2 * j + 1 : 2 * (n - j) - 1;
        odd += 1.0 / sin(2.0 * quarter * (double)part / (double)n);
    }
    check(4.0 * r * (many * many - few * few) / (k2 * m), odd,
          "what n further bodies between the others add to 4 R v^2/(k2 m)",
          check_text("k2 = %g m^3/(kg s^2), n = %zu and %zu, %g kg each, "
                     "radius %g m",
                     k2, n, 2 * n, m, r),
          "eq:choreography-speed");
}

const struct check_test check_hidden[] = {
    {"energy and momentum of a binary", test_virial, 2, 0},
    {"kilograms and tons", test_units, 1, 0},
    {"twice as many bodies", test_twice_as_many, 1, 0},
    {0}};
