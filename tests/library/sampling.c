/* Samplers of hard disks against closed forms and against each other;
   statistical tests allow four standard errors, with fixed seeds. Two and
   four disks against reference runs are in
   tests/programs/sample_answers.sh. */
#include "unit.h"

#include "box/means.h"
#include "box/sampling.h"

#include <float.h>

static void box(struct sampling *s, size_t dimensions,
                enum disks_boundary boundary, const double sides[],
                size_t count, double radius)
{
    UNIT_TRUE(sampling_create(s, dimensions, boundary, sides, count, radius,
                              0, 0));
}

static const double unit[] = {1, 1, 1};

/* R = 1, d = 0.2: computed with 12 digits and by 2e7 random points. */
TEST(test_overlaps, "lenses and segments")
{
    UNIT_NEAR(sampling_overlap(2, 1.2, 2), 0.360124449, 1e-9);
    UNIT_NEAR(sampling_overlap(2, 1.2, 2.2), 0.128994108, 1e-9);
    UNIT_NEAR(sampling_overlap(3, 1.2, 2), 0.284837734, 1e-9);
    UNIT_NEAR(sampling_overlap(3, 1.2, 2.2), 0.073303829, 1e-9);
    UNIT_NEAR(sampling_segment(2, 1.2, 0.8), 0.495597133, 1e-9);
    UNIT_NEAR(sampling_segment(2, 1.2, 1), 0.180062225, 1e-9);
    UNIT_NEAR(sampling_segment(3, 1.2, 0.8), 0.536165146, 1e-9);
    UNIT_NEAR(sampling_segment(3, 1.2, 1), 0.142418867, 1e-9);
}

/* One on the other, touching, and apart; the lens of (6.15, eq:lens3). */
TEST(test_overlap_limits, "lenses and segments at their limits")
{
    const double pi = acos(-1);
    UNIT_NEAR(sampling_overlap(2, 1.5, 0), pi * 2.25, 1e-14);
    UNIT_NEAR(sampling_overlap(3, 1.5, 0), 4 * pi / 3 * 3.375, 1e-13);
    UNIT_EQUAL(sampling_overlap(2, 1.5, 3), 0);
    UNIT_EQUAL(sampling_overlap(3, 1.5, 7), 0);
    UNIT_NEAR(sampling_segment(2, 1, 0), pi / 2, 1e-15);
    for (double s = 0; s < 2.4; s += 0.1)
        UNIT_NEAR(sampling_overlap(3, 1.2, s),
                  4 * pi / 3 * 1.728 *
                      (1 - 0.75 * s / 1.2 + s * s * s / (16 * 1.728)),
                  1e-13);
    /* A wall attracts root 2 times and twice as strongly, for tiny ones;
       q = 0.01: 1.4121 and 1.9934. */
    UNIT_NEAR(sampling_segment(2, 1.01, 0.99) /
                  sampling_overlap(2, 1.01, 2),
              1.4121, 1e-4);
    UNIT_NEAR(sampling_segment(3, 1.01, 0.99) /
                  sampling_overlap(3, 1.01, 2),
              1.9934, 1e-4);
}

/* Two big ones among ideal small ones: the shares of distances in five
   parts of 2 to 2.5 against (6.11, eq:canonical). */
TEST(test_depletion, "Asakura and Oosawa's law of distances")
{
    const double sides[] = {5, 5, 5};
    enum { PARTS = 5 };
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions) {
        const size_t small = dimensions == 2 ? 72 : 150;
        const double volume = dimensions == 2
                                  ? 25 - 2 * acos(-1) * 1.44
                                  : 125 - 8 * acos(-1) / 3 * 1.728;
        double law[PARTS] = {0}, total = 0, all = 0;
        SEEDED(r, 5);
        CREATED(means, m, PARTS);
        CREATED(sampling, s, dimensions, DISKS_PERIODIC, sides, 2, 1, small,
                0.2);
        UNIT_TRUE(sampling_start(&s, &r));
        for (int n = 0; n < 20000; ++n) {
            double apart[DISKS_AXES];
            for (int k = 0; k < 60; ++k)
                sampling_try(&s, 0.3, &r);
            disks_separation(&s.disks, s.disks.disk[0].position,
                             s.disks.disk[1].position, apart);
            const double distance =
                sqrt(apart[0] * apart[0] + apart[1] * apart[1] +
                     apart[2] * apart[2]);
            if (distance < 2.5)
                means_add(&m, (size_t)((distance - 2) * 2 * PARTS), 1);
            means_next(&m);
        }
        for (int n = 0; n < 1000 * PARTS; ++n) {
            const double at = 2 + (n + 0.5) * 0.5 / (1000 * PARTS);
            const double room =
                1 + sampling_overlap(dimensions, 1.2, at) / volume;
            law[n / 1000] +=
                pow(at, (double)dimensions - 1) * pow(room, (double)small);
        }
        for (size_t p = 0; p < PARTS; ++p) {
            total += law[p];
            all += means_mean(&m, p);
        }
        for (size_t p = 0; p < PARTS; ++p)
            UNIT_NEAR(means_mean(&m, p) / all, law[p] / total,
                      4 * means_error(&m, p) / all);
        UNIT_TRUE(dimensions == 3 || law[0] > law[PARTS - 1]);
        UNIT_TRUE(means_error(&m, 0) / all < 0.02);
    }
}

TEST(test_moves, "a try moves one disk or none")
{
    SEEDED(r, 6);
    size_t moved = 0, a, b;
    MADE(sampling, s, box(&s, 2, DISKS_WALLS, unit, 4, 0.2));
    UNIT_TRUE(sampling_start(&s, &r));
    for (int n = 0; n < 20000; ++n) {
        struct disk before[4];
        size_t changed = 0;
        double longest = 0;
        memcpy(before, s.disks.disk, sizeof before);
        const bool said = sampling_try(&s, 0.05, &r);
        for (size_t i = 0; i < 4; ++i) {
            const double *old = before[i].position;
            const double *now = s.disks.disk[i].position;
            changed += old[0] != now[0] || old[1] != now[1];
            longest = fmax(longest, fmax(fabs(old[0] - now[0]),
                                         fabs(old[1] - now[1])));
        }
        UNIT_TRUE(changed == said && longest <= 0.05);
        UNIT_TRUE(disks_fit(&s.disks, &a, &b));
        moved += said;
    }
    UNIT_TRUE(moved > 5000 && moved < 15000);
}

/* Where no lattice fits they grow; where nothing fits there is no start. */
TEST(test_starts, "starts are found, or not")
{
    SEEDED(r, 7);
    size_t a, b;
    MADE(sampling, s, box(&s, 2, DISKS_WALLS, unit, 4, 0.24));
    UNIT_TRUE(sampling_start(&s, &r));
    UNIT_TRUE(disks_fit(&s.disks, &a, &b));
    UNIT_EQUAL(s.disks.disk[3].radius, 0.24);
    sampling_free(&s);
    for (int periodic = 0; periodic < 2; ++periodic) {
        box(&s, 2, periodic ? DISKS_PERIODIC : DISKS_WALLS, unit, 4, 0.251);
        UNIT_TRUE(!sampling_start(&s, &r));
        sampling_free(&s);
    }
    UNIT_TRUE(sampling_create(&s, 2, DISKS_WALLS, unit, 1, 0.3, 500, 0.1));
    UNIT_TRUE(sampling_start(&s, &r));
}

/* Four disks: ln 0.036555; thirty in a box of four times the area: no
   throw comes near, but the guess is far below any patience. */
TEST(test_guess, "hopeless throws are known beforehand")
{
    const double sides[] = {2, 2};
    SEEDED(r, 8);
    MADE(sampling, s, box(&s, 2, DISKS_WALLS, unit, 4, 0.15));
    UNIT_NEAR(sampling_log_acceptance(&s, 100000, &r), log(0.0365551596),
              0.1);
    sampling_free(&s);
    box(&s, 2, DISKS_WALLS, sides, 30, 0.15);
    const double guess = sampling_log_acceptance(&s, 100000, &r);
    UNIT_TRUE(guess < -25 && guess > -60);
}

/* Disks stay apart, the touches and the jumps say the same pressure, and a
   row that is full goes nowhere. */
TEST(test_long_chains, "chains of many keep all disks apart")
{
    static const double sides[] = {13, 13};
    SEEDED(r, 1);
    double gained = 0, touches = 0;
    size_t a, b;
    MADE(sampling, s, box(&s, 2, DISKS_PERIODIC, sides, 64, 0.5));
    UNIT_TRUE(sampling_start(&s, &r));
    for (size_t n = 0; n < 20000; ++n)
        touches += (double)sampling_chain(
            &s, n % 2, 2 + 0.1 * (double)(n % 7), &r, &gained);
    UNIT_TRUE(disks_fit(&s.disks, &a, &b));
    /* The jumps scatter by 0.22 of a diameter. */
    UNIT_NEAR(gained / touches, acos(-1) / 4, 4 * 0.22 / sqrt(touches));
    sampling_free(&s);
    box(&s, 2, DISKS_PERIODIC, (double[]){2, 2}, 2, 0.5);
    s.disks.disk[0].position[0] = 0.5;
    s.disks.disk[1].position[0] = 1.5;
    sampling_chain(&s, 0, 1, &r, &gained);
    UNIT_EQUAL(s.disks.disk[0].position[0], 0.5);
    sampling_chain(&s, 1, 0.75, &r, &gained);
    UNIT_EQUAL(s.disks.disk[0].position[1] + s.disks.disk[1].position[1],
               0.75);
}
