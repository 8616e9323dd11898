/* The hidden tests of exercise 01c, "A stack of balls is dropped". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 60 };

static const char *input(size_t n, const double masses[], double speed,
                         double restitution)
{
    return check_text("%zu balls, the lowest of %g kg, the top one of %g "
                      "kg, speed = %g m/s, restitution = %g",
                      n, masses[0], masses[n - 1], speed, restitution);
}

/* Seen from the falling stack, the share that a ball gives on has the sum
   of two neighbours below the line and the lower one above. On its head a
   stack has the same sums, and the same masses above the line but for the
   top one: the momentum of the top ball is the same. */
CHECK_TIMES(40, test_on_its_head, i)
{
    const size_t n = (size_t)check_draw_whole(2, 12);
    const double speed = check_draw(0.5, 20.0);
    const double e = check_draw(0.0, 1.0);
    double masses[MOST], turned[MOST];
    for (size_t k = 0; k < n; ++k)
        turned[n - 1 - k] = masses[k] = check_draw(0.01, 10.0);
    const double up = top_velocity(n, masses, speed, e) + speed;
    const double down = top_velocity(n, turned, speed, e) + speed;
    CHECK_NEAR(masses[n - 1] * up,
               .quantity =
                   "momentum of the top ball, seen from the falling stack",
               .unit = "kg m/s", .input = input(n, masses, speed, e),
               .expected = turned[n - 1] * down,
               .tolerance = 16.0 * (double)n * DBL_EPSILON *
                            (masses[n - 1] * (fabs(up) + speed) +
                             turned[n - 1] * (fabs(down) + speed)),
               .because = "16 epsilons for each ball, of both momenta");
}

/* Of equal elastic balls the upper one takes all of the velocity; of a ball
   3 times as heavy as the one below it a half, and 7 times as heavy a
   quarter. A tower of equal balls, with such a step here and there: its top
   is as fast as a power of two says, and powers of two round nothing. */
CHECK_TIMES(20, test_towers, i)
{
    const size_t n = (size_t)check_draw_whole(20, MOST);
    const double grams = ldexp(1.0, check_draw_whole(-90, 40));
    const double speed = ldexp(1.0, check_draw_whole(-40, 40));
    int halved = -1; /* the floor doubles */
    double masses[MOST] = {grams};
    for (size_t k = 1; k < n; ++k) {
        const int power =
            check_draw_whole(0, 14) == 0 ? check_draw_whole(1, 2) : 0;
        masses[k] = masses[k - 1] * (ldexp(2.0, power) - 1.0);
        halved += power;
    }
    const double expected = (ldexp(1.0, -halved) - 1.0) * speed;
    CHECK_NEAR(top_velocity(n, masses, speed, 1.0),
               .quantity = "velocity of the top ball, upwards",
               .unit = "m/s", .input = input(n, masses, speed, 1.0),
               .expected = expected,
               .tolerance = 4.0 * (double)n * DBL_EPSILON * speed,
               .because = "4 epsilons for each ball, of the speed");
}

const struct check_test check_hidden[] = {
    {"a stack on its head gives its top ball the same momentum",
     test_on_its_head, 2, 0},
    {"tall towers, in any unit", test_towers, 1, 0},
    {0}};
