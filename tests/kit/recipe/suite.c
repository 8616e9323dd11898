/* The suite of exercise 01f: a known value, a wall, and drawn numbers. */

#include "examiner/check.h"

double energy_at_stake(double u1, double u2, double im1, double im2);

static void check_stake(double u1, double u2, double im1, double im2,
                        double expected, double scale)
{
    const double whole = scale;
    CHECK_NEAR(
        energy_at_stake(u1, u2, im1, im2),
        .quantity = "the largest energy that can be lost", .unit = "J",
        .input = check_text("u1 = %g m/s, u2 = %g m/s, im1 = %g /kg, "
                            "im2 = %g /kg",
                            u1, u2, im1, im2),
        .expected = expected, .tolerance = 16.0 * DBL_EPSILON * scale,
        .because = "16 epsilons of the energy in play: a handful of "
                   "roundings, doubled by squaring",
        .question = "When they stick together, which motion is left, and "
                    "how much energy is in it?",
        .mistakes = {
            {"all-of-it", whole,
             "This is all their energy. But the centre of mass goes on "
             "moving whatever happens. How much of it stays there?"},
            {"half-forgotten", 2.0 * expected,
             "Twice too much. What stands in front of m v^2?"},
            {"sum-of-velocities", 0.5 * (u1 + u2) * (u1 + u2) / (im1 + im2),
             "Here the two are as bad as if they ran the same way. Does "
             "only the difference of the velocities count, or its sign "
             "too?"}});
}

static void test_known(void)
{
    check_stake(2.0, -1.0, 0.5, 1.0, 3.0, 4.5);
}

static void test_wall(void)
{
    check_stake(3.0, 1.0, 0.25, 0.0, 8.0, 18.0);
}

/* All energy, less what the centre of mass keeps. */
static void test_drawn(void)
{
    for (int i = 0; i < 20; ++i) {
        const double u1 = check_draw(0.5, 2.0), u2 = check_draw(-2.0, 0.0);
        const double m1 = check_draw(0.5, 4.0), m2 = check_draw(0.5, 4.0);
        const double im1 = 1.0 / m1, im2 = 1.0 / m2;
        const double all = 0.5 * (m1 * u1 * u1 + m2 * u2 * u2);
        const double p = m1 * u1 + m2 * u2;
        check_stake(u1, u2, im1, im2, all - 0.5 * p * p / (m1 + m2), all);
    }
}

const struct check_suite check_suite = {
    .file = "01f-stake.c",
    .title = "What a collision can cost at most",
    .minutes = 10,
    .equation = "eq:energy-loss",
    .tests = {{"a pair worked out by hand", test_known, 2, 0},
              {"a body runs into a wall", test_wall, 1, 0},
              {"any pair", test_drawn, 2, 3},
              {0}},
};
