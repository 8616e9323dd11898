/* The starts: their numbers, and what is random in them. */
#include "unit.h"

#include "line/start.h"

#include <float.h>

static struct start filled(struct start_request request)
{
    struct start s;
    UNIT_MUST(start_fill(&s, &request));
    return s;
}

#define FILLED(...) filled((struct start_request){__VA_ARGS__})

static double energy(const struct start *s, size_t from, size_t to)
{
    double sum = 0;
    for (size_t i = from; i < to; ++i)
        sum += s->mass[i] * s->v[i] * s->v[i] / 2;
    return sum;
}

static double mass(const struct start *s, size_t from, size_t to)
{
    double sum = 0;
    for (size_t i = from; i < to; ++i)
        sum += s->mass[i];
    return sum;
}

/* Every kind, at its usual size and others: from left to right inside the
   walls with room for the radii, masses above 0, a time to run. */
TEST(test_every_kind, "every start is in order")
{
    for (int kind = 0; kind < START_KINDS; ++kind)
        for (size_t movers = 0; movers < 40; ++movers)
            for (uint64_t seed = 0; seed < 5; ++seed) {
                if (!start_allows(kind, movers))
                    continue;
                FREED(start)
                s = FILLED(.kind = kind, .movers = movers, .seed = seed);
                double last = s.wall[0], room = 0;
                UNIT_TRUE(movers == 0 || s.movers == movers);
                UNIT_TRUE(s.until > 0);
                for (size_t i = 0; i < s.movers; ++i) {
                    UNIT_TRUE(s.x[i] - last >= room + s.radius[i] &&
                              s.mass[i] > 0 && isfinite(s.v[i]) &&
                              s.radius[i] >= 0);
                    last = s.x[i];
                    room = s.radius[i];
                }
                UNIT_TRUE(s.wall[1] - last >= room);
            }
}

TEST(test_four, "four: 10 n + 1.23 kg and 518.45 J")
{
    FREED(start) s = FILLED(.kind = START_FOUR);
    for (size_t i = 0; i < 4; ++i) {
        const double k = (double)i + 1;
        UNIT_NEAR(s.mass[i], 10 * k + 1.23, 0);
        UNIT_TRUE(s.x[i] == k && s.v[i] == k && s.radius[i] == 0.1);
    }
    UNIT_NEAR(energy(&s, 0, 4), 518.45, 1e-12);
}

TEST(test_mixed_and_cradle, "mixed and cradle")
{
    static const double im[] = {1.1, 1, 0.9, 1};
    static const double v[] = {2, 2.21, 2.621, 2, -0.2, -0.27, -0.37, -0.2};
    FREED(start) s = FILLED(.kind = START_MIXED);
    for (size_t i = 0; i < 8; ++i) {
        UNIT_NEAR(s.mass[i] * im[i % 4], i < 4 ? 9 : 1, 9 * DBL_EPSILON);
        UNIT_TRUE(s.x[i] == (double)i + 2 && s.v[i] == v[i]);
    }
    UNIT_NEAR(energy(&s, 0, 8), 90.84, 0.005);
    start_free(&s);
    s = FILLED(.kind = START_CRADLE);
    UNIT_TRUE(s.mass[0] == 4.123 && s.mass[1] == 9.0123);
    UNIT_NEAR(mass(&s, 2, 8), 6, 0);
    UNIT_NEAR(energy(&s, 0, 8), 26.27, 0.005);
    UNIT_EQUAL(energy(&s, 2, 8), 0);
}

/* Eleven: 40 kg and 20 J in the middle, all at 1 m/s, with three quarters
   of the energy; ten masses of 4/3 kg, ten per cent up or down. */
TEST(test_piston, "the piston has three quarters of the energy")
{
    for (uint64_t seed = 1; seed < 20; ++seed) {
        FREED(start) s = FILLED(.kind = START_PISTON, .seed = seed);
        UNIT_TRUE(s.mass[5] == 40 && s.x[5] == 6);
        UNIT_NEAR(mass(&s, 0, 5), 20.0 / 3, 20 * DBL_EPSILON);
        UNIT_NEAR(mass(&s, 6, 11), 20.0 / 3, 20 * DBL_EPSILON);
        UNIT_NEAR(energy(&s, 5, 6) / energy(&s, 0, 11), 0.75,
                  10 * DBL_EPSILON);
        for (size_t i = 0; i < 11; ++i) {
            UNIT_EQUAL(s.v[i], 1);
            if (i != 5)
                UNIT_NEAR(s.mass[i], 4 / 3.0, 0.1001 * 4 / 3);
            for (size_t k = 0; k < i; ++k) {
                const bool middle = i % 6 == 2 && k % 6 == 2;
                UNIT_TRUE(s.mass[i] != s.mass[k] || middle);
            }
        }
    }
}

/* Two gases of 200, each of 20/3 kg and 10/3 J, and the same piston. */
TEST(test_adiabatic, "two warm gases and a piston")
{
    for (uint64_t seed = 1; seed < 6; ++seed) {
        FREED(start) s = FILLED(.kind = START_ADIABATIC, .seed = seed);
        UNIT_TRUE(s.mass[200] == 40 && s.x[200] == 6 && s.v[200] == 0.1);
        /* sums of 200 numbers, a rounding each */
        UNIT_NEAR(energy(&s, 0, 200), 10.0 / 3,
                  10 / 3.0 * 400 * DBL_EPSILON);
        UNIT_NEAR(energy(&s, 201, 401), 10.0 / 3,
                  10 / 3.0 * 400 * DBL_EPSILON);
        UNIT_NEAR(mass(&s, 0, 200) + mass(&s, 201, 401), 40.0 / 3,
                  40 / 3.0 * 400 * DBL_EPSILON);
    }
    /* The piston is so many times as heavy as the mean of the others. */
    FREED(start)
    s = FILLED(.kind = START_ADIABATIC, .movers = 21, .ratio = 30,
               .seed = 1);
    UNIT_NEAR(s.mass[10] * 20, 30 * (mass(&s, 0, 21) - s.mass[10]), 1e-11);
    UNIT_NEAR(energy(&s, 0, 10), 10.0 / 3, 1e-14);
}

/* Half near 1, half near 4, ten per cent up or down; N/2 J. */
TEST(test_thermal, "light and heavy share alike")
{
    double sum = 0, square = 0;
    enum { SEEDS = 400 };
    for (uint64_t seed = 1; seed <= SEEDS; ++seed) {
        FREED(start) s = FILLED(.kind = START_THERMAL, .seed = seed);
        UNIT_NEAR(energy(&s, 0, 10), 5, 5 * 20 * DBL_EPSILON);
        for (size_t i = 0; i < 10; ++i)
            UNIT_NEAR(s.mass[i], i < 5 ? 1 : 4, i < 5 ? 0.1 : 0.4);
        const double share = energy(&s, 0, 5) / 5;
        sum += share;
        square += share * share;
    }
    /* Each mover has the same share on average, whatever its mass: that of
       five of ten has the law Beta(5/2, 5/2), of mean 1/2 and variance
       1/24. Four standard errors; that of the variance is sqrt(2/400) of
       it, or less. */
    const double mean = sum / SEEDS;
    UNIT_NEAR(mean, 0.5, 4 * sqrt(1 / 24.0 / SEEDS));
    UNIT_NEAR(square / SEEDS - mean * mean, 1 / 24.0,
              4 * sqrt(2.0 / SEEDS) / 24);
}

/* Points thrown at random: x_k of N between 0 and N + 1 has the mean k and
   the variance k (N + 1 - k) / (N + 2). */
TEST(test_random_places, "thrown points have the right mean and variance")
{
    enum { SEEDS = 2000, N = 4 };
    double sum[N] = {0}, square[N] = {0};
    for (uint64_t seed = 1; seed <= SEEDS; ++seed) {
        FREED(start)
        s = FILLED(.kind = START_RANDOM, .movers = N, .seed = seed);
        for (size_t i = 0; i < N; ++i) {
            sum[i] += s.x[i];
            square[i] += s.x[i] * s.x[i];
        }
        UNIT_NEAR(energy(&s, 0, N), N / 2.0, N * 10 * DBL_EPSILON);
    }
    for (size_t i = 0; i < N; ++i) {
        const double k = (double)i + 1, mean = sum[i] / SEEDS;
        const double variance = k * (N + 1 - k) / (N + 2);
        UNIT_NEAR(mean, k, 4 * sqrt(variance / SEEDS));
        UNIT_NEAR(square[i] / SEEDS - mean * mean, variance,
                  4 * variance * sqrt(2.0 / SEEDS));
    }
}

/* Masses from 1 to 9, evenly spaced, all different, in random order. */
TEST(test_random_masses, "random masses from 1 to 9 are all different")
{
    int first_is_lightest = 0;
    enum { SEEDS = 200, N = 10 };
    for (uint64_t seed = 0; seed < SEEDS; ++seed) {
        int seen[N] = {0}, all = 1;
        FREED(start) s = FILLED(.kind = START_RANDOM, .seed = seed);
        for (size_t i = 0; i < N; ++i) {
            const double place = (s.mass[i] - 1) * (N - 1) / 8;
            const int k = (int)round(place);
            UNIT_NEAR(place, k, 1e-13);
            if (k >= 0 && k < N)
                ++seen[k];
        }
        for (int k = 0; k < N; ++k)
            all = all && seen[k] == 1;
        UNIT_TRUE(all);
        first_is_lightest += s.mass[0] == 1;
    }
    /* a tenth of 200, four standard deviations of sqrt(200 * 0.09) */
    UNIT_NEAR(first_is_lightest, 20, 17);
    FREED(start) s = FILLED(.kind = START_RANDOM, .movers = 1, .seed = 1);
    UNIT_EQUAL(s.mass[0], 1);
}

static bool same(const struct start *a, const struct start *b)
{
    return memcmp(a->mass, b->mass, 4 * a->movers * sizeof(double)) == 0;
}

/* Equal seeds give equal starts; other seeds do not, where the seed
   matters. */
TEST(test_seeds, "seeds")
{
    static const bool drawn[START_KINDS] = {[START_THERMAL] = true,
                                            [START_PISTON] = true,
                                            [START_ADIABATIC] = true,
                                            [START_RANDOM] = true};
    for (int kind = 0; kind < START_KINDS; ++kind)
        for (uint64_t seed = 0; seed < 20; ++seed) {
            struct start_request request = {.kind = kind, .seed = seed};
            FREED(start) a = filled(request), b = filled(request);
            request.seed = seed + 1;
            FREED(start) c = filled(request);
            UNIT_TRUE(same(&a, &b));
            UNIT_TRUE(same(&a, &c) != drawn[kind]);
        }
}

TEST(test_two_and_galperin, "two and galperin take a mass ratio")
{
    FREED(start) s = FILLED(.kind = START_TWO, .ratio = 0.25);
    UNIT_TRUE(s.mass[0] == 1 && s.mass[1] == 0.25);
    start_free(&s);
    s = FILLED(.kind = START_GALPERIN, .ratio = 1e6);
    UNIT_TRUE(s.mass[0] == 1 && s.mass[1] == 1e6);
}

TEST(test_walls, "walls that are given stand")
{
    for (int kind = 0; kind < START_KINDS; ++kind) {
        FREED(start)
        s = FILLED(.kind = kind, .walls = true, .wall = {-3, 50},
                   .seed = 3);
        UNIT_TRUE(s.wall[0] == -3 && s.wall[1] == 50);
        if (kind == START_RANDOM)
            UNIT_TRUE(s.x[s.movers - 1] > 20);
        if (kind == START_PISTON)
            UNIT_EQUAL(s.x[5], 23.5);
        start_free(&s);
    }
}

/* Of each kind numbers that are allowed, and others; 0 ends a list. */
TEST(test_allows, "which numbers of movers are allowed")
{
    static const struct {
        enum start_kind kind;
        size_t good[5], bad[5];
    } cases[] = {{START_FOUR, {1, 10000000}, {10000001}},
                 {START_MIXED, {8}, {7}},
                 {START_CRADLE, {8}, {9}},
                 {START_THERMAL, {2, 10000000}, {1, 10000001}},
                 {START_PISTON, {3, 101, 9999999}, {1, 10, 10000001}},
                 {START_ADIABATIC, {3, 9999999}, {400, 10000001}},
                 {START_TWO, {2}, {1, 3}},
                 {START_RANDOM, {1, 10000000}, {10000001}},
                 {START_GALPERIN, {2}, {3}}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k)
        for (int n = 0; n < 5; ++n) {
            const size_t good = cases[k].good[n], bad = cases[k].bad[n];
            UNIT_TRUE(!good || start_allows(cases[k].kind, good));
            UNIT_TRUE(!bad || !start_allows(cases[k].kind, bad));
        }
    for (int kind = 0; kind < START_KINDS; ++kind)
        UNIT_TRUE(start_allows(kind, 0));
    UNIT_SAYS(start_names[START_GALPERIN], "galperin");
    UNIT_SAYS(start_names[START_FOUR], "four");
    UNIT_TRUE(start_names[START_KINDS] == NULL);
}

TEST(test_all_numbers, "all that is fixed of each kind")
{
    static const struct {
        double movers, until, wall[2];
    } usual[START_KINDS] = {{4, 50, {0, 5}},
                            {8, 30, {1, 10}},
                            {8, 100, {0, 35}},
                            {10, 100, {0, 11}},
                            {11, 200, {0, 12}},
                            {401, 200, {0, 12}},
                            {2, 100, {0, 3}},
                            {10, 100, {0, 11}},
                            {2, INFINITY, {0, INFINITY}}};
    for (int kind = 0; kind < START_KINDS; ++kind) {
        FREED(start) s = FILLED(.kind = kind);
        UNIT_EQUAL(s.movers, usual[kind].movers);
        UNIT_TRUE(s.until == usual[kind].until);
        UNIT_EQUAL(s.wall[0], usual[kind].wall[0]);
        UNIT_TRUE(s.wall[1] == usual[kind].wall[1]);
        UNIT_EQUAL(s.gravity, 0);
        for (size_t i = 0; i < s.movers; ++i)
            UNIT_EQUAL(s.radius[i], kind == START_FOUR ? 0.1 : 0);
    }
    FREED(start) s = FILLED(.kind = START_CRADLE);
    for (size_t i = 0; i < 8; ++i) {
        UNIT_EQUAL(s.x[i], 14 + (double)i);
        UNIT_EQUAL(s.v[i], i < 2 ? -2 : 0);
    }
    start_free(&s);
    s = FILLED(.kind = START_TWO);
    UNIT_TRUE(s.x[0] == 1 && s.x[1] == 2 && s.v[0] == 1 && s.v[1] == -0.3);
    UNIT_TRUE(s.mass[0] == 1 && s.mass[1] == 9);
    start_free(&s);
    s = FILLED(.kind = START_GALPERIN);
    UNIT_TRUE(s.x[0] == 1 && s.x[1] == 2 && s.v[0] == 0 && s.v[1] == -1);
    UNIT_TRUE(s.mass[0] == 1 && s.mass[1] == 100);
    start_free(&s);
    /* From the wall to the piston ten per cent less to ten per cent more,
       or eight the other way; at the smallest size one on either side. */
    for (int kind = START_PISTON; kind <= START_ADIABATIC; ++kind)
        for (size_t n = 1; n <= 5; n += 4) {
            s = FILLED(.kind = kind, .movers = 2 * n + 1, .seed = 4);
            for (size_t i = 0; i < n; ++i) {
                const double place = n > 1 ? (double)i / 2 - 1 : 0;
                const double mean = 20 / (3 * (double)n);
                UNIT_NEAR(s.mass[i], mean * (1 + 0.1 * place), 1e-14);
                UNIT_NEAR(s.mass[n + 1 + i], mean * (1 - 0.08 * place),
                          1e-14);
                UNIT_TRUE(s.x[i] < 6 && s.x[n + 1 + i] > 6);
            }
            UNIT_EQUAL(s.v[n], kind == START_PISTON ? 1 : 0.1);
            start_free(&s);
        }
    /* Masses within ten per cent, evenly: 2000 of each half. */
    double light = 0, heavy = 0, least = 9, most = 0;
    for (uint64_t seed = 1; seed <= 400; ++seed) {
        s = FILLED(.kind = START_THERMAL, .seed = seed);
        light += mass(&s, 0, 5) / 2000;
        heavy += mass(&s, 5, 10) / 2000;
        for (size_t i = 0; i < 5; ++i) {
            least = fmin(least, fmin(s.mass[i], s.mass[5 + i] / 4));
            most = fmax(most, fmax(s.mass[i], s.mass[5 + i] / 4));
        }
        start_free(&s);
    }
    UNIT_NEAR(light, 1, 4 * 0.2 / sqrt(12 * 2000));
    UNIT_NEAR(heavy, 4, 16 * 0.2 / sqrt(12 * 2000));
    UNIT_TRUE(least >= 0.9 && least < 0.901);
    UNIT_TRUE(most <= 1.1 && most > 1.099);
}

TEST(test_create, "room for a start")
{
    CREATED(start, s, 3);
    UNIT_EQUAL(s.movers, 3);
    for (size_t i = 0; i < 3; ++i) {
        UNIT_EQUAL(s.mass[i], 1);
        UNIT_EQUAL(s.x[i], 0);
        UNIT_EQUAL(s.v[i], 0);
        UNIT_EQUAL(s.radius[i], 0);
    }
    UNIT_TRUE(s.wall[0] == 0 && s.wall[1] == 0 && s.gravity == 0);
}
