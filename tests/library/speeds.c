/* The laws of speed: closed forms, moments, and limits. */
#include "unit.h"

#include "box/speeds.h"

enum { BINS = 42 };
static const double width = 2.0 / 21;

/* In the plane with walls: P(less than u) = 1 - (1 - u^2 / N)^(N - 1). */
TEST(test_plane, "the law in the plane is its closed form")
{
    for (size_t N = 2; N < 2000; N += 1 + N / 2) {
        const struct speeds_law law = speeds_exact(2, N, false, false);
        double density[BINS], below = 0;
        speeds_bins(&law, width, BINS, density);
        UNIT_EQUAL(law.most, N);
        for (size_t bin = 0; bin < BINS; ++bin) {
            const double u = (double)(bin + 1) * width;
            const double left = fmax(0, 1 - u * u / (double)N);
            below += density[bin] * width;
            /* two disks: the law is cut off within a bin */
            UNIT_NEAR(below, 1 - pow(left, (double)N - 1),
                      N == 2   ? 5e-3
                      : N == 4 ? 1e-5
                               : 1e-8);
        }
    }
}

TEST(test_maxwell, "Maxwell's laws are theirs")
{
    double speed[BINS], part[BINS], space[BINS], low = 0, one = 0,
                                                 three = 0;
    struct speeds_law law = speeds_maxwell(2, false);
    UNIT_NEAR(speeds_bins(&law, width, BINS, speed), sqrt(acos(-1)) / 2,
              1e-9);
    law = speeds_maxwell(2, true);
    UNIT_NEAR(speeds_bins(&law, width, BINS, part), 1 / sqrt(acos(-1)),
              1e-9);
    law = speeds_maxwell(3, false);
    UNIT_NEAR(speeds_bins(&law, width, BINS, space), 2 / sqrt(acos(-1)),
              1e-9);
    for (size_t bin = 0; bin < BINS; ++bin) {
        const double u = (double)(bin + 1) * width;
        low += speed[bin] * width;
        one += part[bin] * width;
        three += space[bin] * width;
        UNIT_NEAR(low, 1 - exp(-u * u), 1e-9);
        UNIT_NEAR(one, erf(u), 1e-9);
        UNIT_NEAR(three, erf(u) - 2 * u * exp(-u * u) / sqrt(acos(-1)),
                  1e-9);
    }
}

/* <u^2> = D/2 (1 - 1/N at rest is in kT), <u^4> in closed form, and both
   from the bins. */
TEST(test_moments, "the moments are those of the bins")
{
    for (size_t D = 2; D <= 3; ++D)
        for (size_t resting = 0; resting < 2; ++resting)
            for (size_t N = 12; N < 500; N *= 3) {
                const struct speeds_law law =
                    speeds_exact(D, N, resting, false);
                double density[400], two = 0, four = 0;
                speeds_bins(&law, 0.02, 400, density);
                for (size_t bin = 0; bin < 400; ++bin) {
                    const double u = ((double)bin + 0.5) * 0.02;
                    two += density[bin] * 0.02 * u * u;
                    four += density[bin] * 0.02 * u * u * u * u;
                }
                const double share = resting ? 1 - 1 / (double)N : 1;
                UNIT_NEAR(two, (double)D / 2 * share, 1e-3);
                UNIT_NEAR(four, speeds_fourth(&law), 2e-3);
            }
    const struct speeds_law gas = speeds_exact(2, 250, false, false);
    UNIT_NEAR(speeds_fourth(&gas), 500.0 / 251, 1e-14);
    const struct speeds_law bath = speeds_maxwell(3, false);
    UNIT_EQUAL(speeds_fourth(&bath), 3.75);
}
