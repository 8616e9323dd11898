/* Samplers in boxes with so few disks that lines, chains and shares are
   known by hand. */
#include "unit.h"

#include "box/means.h"
#include "box/sampling.h"

#include <float.h>

static void box(struct sampling *s, size_t dimensions,
                enum disks_boundary boundary, double side, size_t count,
                double radius, const double places[][3])
{
    const double sides[] = {side, side, side};
    UNIT_MUST(sampling_create(s, dimensions, boundary, sides, count, radius,
                              0, 0));
    for (size_t i = 0; places && i < count; ++i)
        memcpy(s->disks.disk[i].position, places[i], sizeof places[i]);
}

/* Three disks, one behind the other, the middle one 0.6 m to the side: they
   touch 0.8, 0.8 and 1 m behind each other. Pushed by 5 m in all, from any
   of them. */
TEST(test_chain, "a chain of three, by hand")
{
    static const double places[][3] = {{1, 5, 0}, {3, 5.6, 0}, {7, 5, 0}};
    static const struct {
        double lifts, gained, x[3];
    } ends[] = {{2, 1.6, {2.2, 6.2, 7.6}},
                {1, 0.8, {1, 6.2, 8.8}},
                {2, 1.8, {2.2, 3.8, 0}}};
    int seen = 0;
    for (size_t axis = 0; axis < 3; ++axis)
        for (uint64_t seed = 1; seed <= 16; ++seed) {
            /* The row stands in the middle, or across the seam. */
            const double aside = seed % 2 ? 0 : 4.75;
            SEEDED(r, seed);
            double gained = 0;
            MADE(sampling, s, box(&s, 3, DISKS_PERIODIC, 10, 3, 0.5, NULL));
            for (size_t i = 0; i < 3; ++i)
                for (size_t k = 0; k < 3; ++k)
                    s.disks.disk[i].position[(k + axis) % 3] =
                        k == 1 ? fmod(places[i][k] + aside, 10)
                               : places[i][k];
            const uint64_t lifts = sampling_chain(&s, axis, 5, &r, &gained);
            random_seed(&r, seed);
            const size_t first = random_below(&r, 3);
            seen |= 1 << first;
            UNIT_EQUAL(lifts, ends[first].lifts);
            UNIT_NEAR(gained, ends[first].gained, 1e-14);
            for (size_t i = 0; i < 3; ++i) {
                const double *at = s.disks.disk[i].position;
                UNIT_NEAR(at[axis], ends[first].x[i], 1e-14);
                UNIT_EQUAL(at[(axis + 1) % 3],
                           fmod(places[i][1] + aside, 10));
                UNIT_EQUAL(at[(axis + 2) % 3], places[i][2]);
            }
        }
    UNIT_EQUAL(seen, 7);
}

/* Two side by side that touch, the one a hair behind the other: that is not
   in its way, but on its way once round the box. Tenths of a metre leave
   them too near by a rounding. */
TEST(test_hair_behind, "what is a hair behind is not in the way")
{
    static const double places[][3] = {{.5, .4, 0}, {.5 - 1e-10, .7, 0}};
    int tried = 0;
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        SEEDED(r, seed);
        double gained = 0;
        if (random_below(&r, 2) != 0)
            continue;
        ++tried;
        random_seed(&r, seed);
        MADE(sampling, s, box(&s, 2, DISKS_PERIODIC, 1, 2, 0.15, places));
        UNIT_TRUE(0.7 - 0.4 < 0.15 + 0.15);
        UNIT_EQUAL(sampling_chain(&s, 0, 0.25, &r, &gained), 0);
        UNIT_EQUAL(s.disks.disk[0].position[0], 0.75);
        UNIT_EQUAL(gained, 0);
    }
    UNIT_TRUE(tried > 1);
}

/* One that is touched by its side alone is not pushed. */
TEST(test_grazing, "what is grazed is not pushed")
{
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        static const double places[][3] = {{1, 5, 0}, {3, 6, 0}};
        SEEDED(r, seed);
        double gained = 0, before, after;
        MADE(sampling, s, box(&s, 2, DISKS_PERIODIC, 10, 2, 0.5, places));
        before = s.disks.disk[0].position[0] + s.disks.disk[1].position[0];
        UNIT_EQUAL(sampling_chain(&s, 0, 5, &r, &gained), 0);
        after = s.disks.disk[0].position[0] + s.disks.disk[1].position[0];
        UNIT_EQUAL(after - before, 5);
        UNIT_EQUAL(gained, 0);
    }
}

/* A disk that slides from wall to wall: 0.8 m less what others take. */
TEST(test_wall_density, "a disk that slides from wall to wall")
{
    static const struct {
        size_t count;
        double x[4], y[4], expected;
        double small; /* the radius of the second, unless it is 0.1 m */
    } lines[] = {
        {1, {.5}, {.5}, 2 / (2 * .8), 0},
        {2, {.2, .5}, {.5, .5}, 2 / (2 * .4), 0},
        {2, {.8, .15}, {.5, .5}, 1 / (2 * .55), 0},
        {2, {.2, .85}, {.5, .5}, 1 / (2 * .55), 0},
        /* 0.16 m to the side: 0.12 m on either side */
        {2, {.2, .5}, {.5, .66}, 2 / (2 * .56), 0},
        {2, {.2, .5}, {.5, .2}, 2 / (2 * .8), 0}, /* beside the line */
        /* a small one, 0.12 m to the side: 0.05 m on either side */
        {2, {.2, .5}, {.5, .62}, 2 / (2 * .7), .03},
        /* 0.28 to 0.52 and 0.3 to 0.7 */
        {3, {.2, .4, .5}, {.5, .66, .5}, 2 / (2 * .38), 0},
        {3, {.2, .5, .4}, {.5, .5, .34}, 2 / (2 * .38), 0},
        /* 0.09 to 0.49, 0.4 to 0.8, 0.55 to 0.95 */
        {4, {.5, .29, .6, .75}, {.5, .5, .5, .5}, 0, 0}};
    for (size_t n = 0; n < sizeof lines / sizeof lines[0]; ++n)
        for (size_t axis = 0; axis < 2; ++axis) {
            FREED(sampling) s;
            box(&s, 2, DISKS_WALLS, 1, lines[n].count, 0.1, NULL);
            if (lines[n].small > 0)
                s.disks.disk[1].radius = lines[n].small;
            for (size_t i = 0; i < lines[n].count; ++i) {
                s.disks.disk[i].position[axis] = lines[n].x[i];
                s.disks.disk[i].position[1 - axis] = lines[n].y[i];
            }
            UNIT_NEAR(sampling_wall_density(&s, 0, axis), lines[n].expected,
                      1e-13);
        }
}

/* Slid away from another, to a wall or, in a periodic box, half round it:
   the integral of t or t^2 from contact on, without what a third takes. */
TEST(test_pair_density, "a disk that slides away from another")
{
    for (size_t D = 2; D <= 3; ++D)
        for (size_t axis = 0; axis < D; ++axis)
            for (int round = 0; round < 2; ++round)
                for (int way = 0; way < 8; ++way) {
                    static const double at[] = {0, 0.75, 0.65, 0.59};
                    const int third = way % 4, small = way / 4;
                    const double p = (double)D;
                    MADE(sampling, s,
                         box(&s, D, round ? DISKS_PERIODIC : DISKS_WALLS, 1,
                             third ? 3 : 2, 0.1, NULL));
                    if (third && small)
                        s.disks.disk[2].radius = 0.05;
                    for (size_t i = 0; i < s.disks.count; ++i)
                        for (size_t k = 0; k < D; ++k)
                            s.disks.disk[i].position[k] = k != axis ? 0.5
                                                          : i == 0  ? 0.55
                                                          : i == 1
                                                              ? 0.2
                                                              : at[third];
                    /* from 0.2 on, to 0.7 or to 0.5 */
                    const double end = round ? 0.5 : 0.7;
                    double part = pow(end, p) - pow(0.2, p);
                    const double reach = small ? 0.15 : 0.2;
                    const double from = at[third] - 0.2 - reach,
                                 to = from + 2 * reach;
                    if (third)
                        part -= pow(fmin(to, end), p) - pow(from, p);
                    UNIT_NEAR(sampling_pair_density(&s, 0, 1),
                              third == 3 && !small
                                  ? 0
                                  : p * pow(0.2, p - 1) / part,
                              1e-12);
                }
}

/* How many of the throws that placed i disks had room for the next, as the
   same throws tell; where fewer than ten did, the last share counts. */
TEST(test_acceptance, "shares of throws, as they are counted")
{
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        enum { COUNT = 7, THROWS = 300 };
        FREED(sampling) s;
        struct random r;
        double expected = 0, last = 0;
        size_t reached[COUNT + 1] = {0};
        box(&s, 2, DISKS_WALLS, 1, COUNT, seed % 2 ? 0.12 : 0.15, NULL);
        random_seed(&r, seed);
        for (int k = 0; k < THROWS; ++k) {
            const size_t n = sampling_throw(&s, &r);
            for (size_t i = 0; i <= n; ++i)
                ++reached[i];
            /* Those that were placed fit, and the next one does not. */
            for (size_t i = 0; i < n; ++i)
                for (size_t j = 0; j < i; ++j)
                    UNIT_TRUE(!disks_clash(&s.disks, i, j));
            bool clash = n == COUNT;
            for (size_t j = 0; j < n && n < COUNT; ++j)
                clash = clash || disks_clash(&s.disks, n, j);
            UNIT_TRUE(clash);
        }
        for (size_t i = 0; i < COUNT; ++i) {
            if (reached[i + 1] >= 10)
                last = log((double)reached[i + 1] / (double)reached[i]);
            expected += last;
        }
        random_seed(&r, seed);
        UNIT_NEAR(sampling_log_acceptance(&s, THROWS, &r), expected, 1e-13);
    }
}

/* Half of the tries are for large ones, which go no farther than the step,
   and half for small ones, which go anywhere. All stay inside. */
TEST(test_tries, "half of the tries are for large ones")
{
    enum { TRIES = 4000 };
    const double sides[] = {10, 10};
    SEEDED(r, 3);
    int large = 0, moved = 0;
    double farthest = 0, widest = 0;
    CREATED(sampling, s, 2, DISKS_WALLS, sides, 2, 0.5, 3, 0.01);
    UNIT_TRUE(sampling_start(&s, &r));
    for (int n = 0; n < TRIES; ++n) {
        struct disk before[5];
        memcpy(before, s.disks.disk, sizeof before);
        moved += sampling_try(&s, 0.25, &r);
        for (size_t i = 0; i < 5; ++i)
            for (size_t k = 0; k < 2; ++k) {
                const double a = s.disks.disk[i].radius;
                const double x = s.disks.disk[i].position[k];
                const double way = fabs(x - before[i].position[k]);
                UNIT_TRUE(x >= a && x <= 10 - a);
                large += i < 2 && k == 0 && way > 0;
                if (i < 2)
                    farthest = fmax(farthest, way);
                else
                    widest = fmax(widest, way);
            }
    }
    UNIT_NEAR(large, TRIES / 2.0, 4 * sqrt(TRIES / 4.0) + TRIES - moved);
    UNIT_TRUE(farthest <= 0.25 && farthest > 0.24);
    UNIT_TRUE(widest > 9);
}

/* Means of 1, 2, 3, ... and of what comes once: blocks are joined when
   there are 128, and the sums of an unfinished one count. */
TEST(test_joined, "means and blocks of known numbers")
{
    CREATED(means, m, 2);
    UNIT_TRUE(isnan(means_mean(&m, 1)));
    UNIT_TRUE(isnan(means_error(&m, 1)));
    for (int n = 1; n <= 600; ++n) {
        means_add(&m, 0, n);
        if (n == 3)
            means_add(&m, 1, 5);
        means_next(&m);
        const int length = n < 128 ? 1 : n < 256 ? 2 : n < 512 ? 4 : 8;
        UNIT_EQUAL(m.length, length);
        UNIT_EQUAL(m.blocks, n / length);
        UNIT_EQUAL(m.filled, n % length);
        UNIT_NEAR(means_mean(&m, 0), (n + 1) / 2.0, 1e-12 * n);
        UNIT_NEAR(means_mean(&m, 1), n < 3 ? 0 : 5.0 / n, 1e-15);
        if (n < 2) {
            UNIT_TRUE(isnan(means_error(&m, 0)));
            continue;
        }
        /* Blocks of equal steps: b (b^2 - 1) / 12 squares. */
        const double b = n / length;
        UNIT_NEAR(means_error(&m, 0), length * sqrt((b + 1) / 12),
                  1e-11 * n);
    }
}

/* In a periodic box a third disk stands 0.45 m to each side against the
   way, so that it is its image 0.55 m ahead that ends the slide; on each of
   the 8 or 26 ways along sides and diagonals. */
TEST(test_images, "images end a slide in every direction")
{
    for (size_t D = 2; D <= 3; ++D)
        for (int way = 0; way < (D == 2 ? 9 : 27); ++way) {
            const double to[] = {way % 3 - 1, way / 3 % 3 - 1,
                                 D == 2 ? 0 : way / 9 - 1};
            const double length =
                sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
            if (length == 0)
                continue;
            MADE(sampling, s, box(&s, D, DISKS_PERIODIC, 1, 3, 0.1, NULL));
            for (size_t k = 0; k < D; ++k) {
                s.disks.disk[1].position[k] = 0.3;
                s.disks.disk[0].position[k] = 0.3 + 0.25 * to[k] / length;
                s.disks.disk[2].position[k] = 0.3 - 0.45 * to[k];
            }
            const double p = (double)D, end = 0.55 * length - 0.2;
            UNIT_NEAR(sampling_pair_density(&s, 0, 1),
                      p * pow(0.2, p - 1) / (pow(end, p) - pow(0.2, p)),
                      1e-11);
        }
}

TEST(test_ideal, "small ones do not see each other")
{
    const double sides[] = {10, 10};
    SEEDED(r, 3);
    int moves[4] = {0};
    CREATED(sampling, s, 2, DISKS_WALLS, sides, 1, 0.1, 3, 3);
    UNIT_TRUE(sampling_start(&s, &r));
    for (int n = 0; n < 400; ++n) {
        struct disk before[4];
        memcpy(before, s.disks.disk, sizeof before);
        sampling_try(&s, 0.1, &r);
        for (size_t i = 0; i < 4; ++i)
            moves[i] +=
                memcmp(&before[i], &s.disks.disk[i], sizeof before[i]) != 0;
        for (size_t i = 1; i < 4; ++i)
            UNIT_TRUE(!disks_clash(&s.disks, 0, i));
    }
    for (size_t i = 0; i < 4; ++i)
        UNIT_TRUE(moves[i] > 5);
}
