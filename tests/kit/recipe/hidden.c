/* The hidden tests of exercise 01f: seen from a train. */

#include "examiner/check.h"

double energy_at_stake(double u1, double u2, double im1, double im2);

/* What can be lost is the same for whoever passes by. The velocities are
   whole numbers of sixteenths, so that the train's is added without a
   rounding. */
static void test_train(void)
{
    for (int i = 0; i < 20; ++i) {
        const double u1 = check_draw_whole(1, 80) / 16.0;
        const double u2 = check_draw_whole(-80, 0) / 16.0;
        const double train = check_draw_whole(-160, 160) / 16.0;
        const double im1 = check_draw(0.25, 2.0);
        const double im2 = check_draw(0.25, 2.0);
        const double fast = fmax(u1, -u2) + fabs(train);
        const double all = 0.5 * fast * fast * (1.0 / im1 + 1.0 / im2);
        const double here = energy_at_stake(u1, u2, im1, im2);
        CHECK_NEAR(
            energy_at_stake(u1 + train, u2 + train, im1, im2),
            .quantity = "the loss, seen from a train", .unit = "J",
            .input = check_text("u1 = %g m/s, u2 = %g m/s, train at %g m/s",
                                u1, u2, -train),
            .expected = here, .tolerance = 32.0 * DBL_EPSILON * all,
            .because = "32 epsilons of the energy in play",
            .question = "Can a passer-by change what is lost?");
    }
}

const struct check_test check_hidden[] = {
    {"whoever passes by sees the same loss", test_train, 2, 0}, {0}};
