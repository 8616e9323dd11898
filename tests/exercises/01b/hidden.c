/* The hidden tests of exercise 01b, "Weighing without a balance". */

#include "examiner/check.h"
#include "call.h"

/* A collision as somebody sees it who moves with the centre of mass: the
   masses, what is common to their momenta, the restitution, and how fast
   the centre goes. */
struct meeting {
    double m1, m2, p, e, c;
};

/* The ratio is that of two differences of velocities, and so is the
   restitution; here they are exact, and only whoever sits on the second
   body rounds on the way. */
static void check_meeting(struct meeting m)
{
    const double u1 = m.c + m.p * m.m2, u2 = m.c - m.p * m.m1;
    const double v1 = m.c - m.e * m.p * m.m2, v2 = m.c + m.e * m.p * m.m1;
    const double fast =
        fabs(m.c) + fmax(1.0, fabs(m.e)) * fabs(m.p) * fmax(m.m1, m.m2);
    const double small = (1.0 + m.e) * fabs(m.p) * fmin(m.m1, m.m2);
    const double slack = 8.0 * DBL_EPSILON * (1.0 + fast / small);
    const char *input = check_text("u1 = %.17g m/s, u2 = %.17g m/s before, "
                                   "v1 = %.17g m/s, v2 = %.17g m/s after",
                                   u1, u2, v1, v2);
    double ratio = NAN, restitution = NAN;
    const bool told =
        measure_collision(u1, u2, v1, v2, &ratio, &restitution);
    CHECK_NEAR(told, .quantity = "what is returned (1 true, 0 false)",
               .input = input, .expected = 1.0, .because = "yes or no");
    CHECK_NEAR(ratio, .quantity = "mass ratio m1/m2", .input = input,
               .expected = m.m1 / m.m2, .tolerance = slack * m.m1 / m.m2,
               .because = "8 epsilons, times how much smaller a change of "
                          "velocity is than a velocity");
    CHECK_NEAR(restitution, .quantity = "restitution", .input = input,
               .expected = m.e, .tolerance = slack * (1.0 + fabs(m.e)),
               .because = "8 epsilons, times how much smaller a change of "
                          "velocity is than a velocity",
               .equation = "eq:restitution");
}

/* A spring between the two, which the blow lets go, drives them apart
   faster than they came; and a bullet that goes through a board leaves it
   behind: its restitution is negative. */
CHECK_TIMES(40, test_springs_and_bullets, i)
{
    const struct meeting m = {
        check_draw_whole(1, 20), check_draw_whole(1, 20),
        i % 2 ? -0.25 : 0.25,
        (i % 4 < 2 ? check_draw_whole(17, 48) : check_draw_whole(-12, -1)) /
            16.0,
        check_draw_whole(-40, 40) / 4.0};
    check_meeting(m);
}

/* Mass ratios of 2^-16 to 2^16, and velocities of a nanometre to ten
   thousand kilometres a second. Powers of two round nothing. */
CHECK_TIMES(40, test_units, i)
{
    const int unit = check_draw_whole(-30, 23);
    const int heavy = check_draw_whole(0, 16);
    const double large = ldexp(1.0, heavy);
    const struct meeting m = {i % 2 ? large : 1.0, i % 2 ? 1.0 : large,
                              ldexp(i % 4 < 2 ? -1.0 : 1.0, unit - heavy),
                              check_draw_whole(0, 8) / 8.0,
                              ldexp(check_draw_whole(-8, 8), unit)};
    check_meeting(m);
}

const struct check_test check_hidden[] = {
    {"springs drive apart, and bullets go through",
     test_springs_and_bullets, 1, 0},
    {"flies and lorries, in any unit", test_units, 1, 0},
    {0}};
