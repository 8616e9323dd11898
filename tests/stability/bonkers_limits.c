/* Where a line of bodies fails, chapter 2: the way back, two balls that
   never mix, and the engine that feels when it is looked at. */
#include "unit.h"

#include "line/bonkers.h"
#include "toolbox/random.h"

#include <float.h>

static void begin(struct bonkers *b, struct start_request request,
                  enum bonkers_engine engine)
{
    FREED(start) s;
    size_t wrong = 0;
    UNIT_MUST(start_fill(&s, &request) &&
              bonkers_begin(b, &s, 1, engine, &wrong));
    UNIT_EQUAL(wrong, b->gaps);
}

/* How far the bodies miss their starting places after n collisions forth
   and as much time back, m. */
static double miss(struct start_request request, enum bonkers_engine engine,
                   uint64_t n)
{
    double worst = 0;
    MADE(bonkers, b, begin(&b, request, engine));
    MADE(bonkers, start, begin(&start, request, engine));
    bonkers_run(&b, INFINITY, n);
    const double t = b.now;
    bonkers_settle(&b);
    for (size_t i = 0; i <= b.gaps; ++i)
        b.body[i].v = -b.body[i].v;
    UNIT_EQUAL(bonkers_start(&b, NULL), b.gaps);
    bonkers_run(&b, t, UINT64_MAX);
    bonkers_settle(&b);
    for (size_t i = 0; i <= b.gaps; ++i)
        worst = fmax(worst, fabs(b.body[i].x - start.body[i].x));
    return worst;
}

enum { STARTS = 24 };

/* The mean of the logarithm of the miss, over starts of eight bodies. */
static double mean_miss(enum bonkers_engine engine, uint64_t n)
{
    double sum = 0;
    for (uint64_t seed = 1; seed <= STARTS; ++seed)
        sum += log10(miss((struct start_request){.kind = START_RANDOM,
                                                 .movers = 8,
                                                 .seed = seed},
                          engine, n));
    return sum / STARTS;
}

/* Velocities walk at random, sqrt n, and places are their integral,
   n^(3/2): a factor of 1000 from 10^3 to 10^5 collisions, 3 in the
   logarithm. The largest of eight random errors scatters by less than a
   factor of two, 0.3, at either end, so the mean over 24 starts by
   0.3 sqrt(2/24) = 0.09; four of these. An error that a bias makes, n^2,
   is at 4; one that chaos makes would have lost its way. */
TEST(test_way_back, "the way back is missed as n^(3/2)")
{
    const double slope =
        mean_miss(BONKERS_SCAN, 100000) - mean_miss(BONKERS_SCAN, 1000);
    UNIT_NEAR(slope, 3, 0.36);
    UNIT_TRUE(mean_miss(BONKERS_SCAN, 1000) < -11);
}

TEST(test_way_back_of_every_engine, "every engine misses it alike")
{
    const struct start_request request = {
        .kind = START_RANDOM, .movers = 40, .seed = 5};
    const double scan = miss(request, BONKERS_SCAN, 20000);
    UNIT_EQUAL(miss(request, BONKERS_HEAP, 20000), scan);
    UNIT_EQUAL(miss(request, BONKERS_SLAB, 20000), scan);
    UNIT_TRUE(scan > 0 && scan < 1e-8);
}

/* Distinct pairs of velocities at 40000 clock times, in steps of 1e-6. */
static size_t count_pairs(double ratio)
{
    enum { TIMES = 40000, MANY = 1000 };
    static double seen[MANY][2];
    size_t count = 0;
    MADE(bonkers, b,
         begin(&b,
               (struct start_request){.kind = START_TWO, .ratio = ratio},
               BONKERS_AUTO));
    for (int k = 1; k <= TIMES && count < MANY; ++k) {
        double x[4], v[4];
        size_t i = 0;
        bonkers_run(&b, 0.37 * k, UINT64_MAX);
        bonkers_state(&b, x, v);
        while (i < count && (fabs(seen[i][0] - v[1]) > 1e-6 ||
                             fabs(seen[i][1] - v[2]) > 1e-6))
            ++i;
        if (i == count) {
            seen[count][0] = v[1];
            seen[count++][1] = v[2];
        }
    }
    return count;
}

/* Mirrors at an angle pi/6 or pi/3 make 12 images, at pi/4 8. Other angles
   make them without end, but few at a time: the angle only walks to and
   fro. */
TEST(test_two_balls, "two balls of mass ratio 3 know 12 velocity pairs")
{
    UNIT_EQUAL(count_pairs(3), 12);
    UNIT_EQUAL(count_pairs(1 / 3.0), 12);
    UNIT_EQUAL(count_pairs(1), 8);
    UNIT_TRUE(count_pairs(9) > 24);
    UNIT_TRUE(count_pairs(1.6180339887498949) > 100);
}

/* The largest difference between a run and the same run looked at every
   0.01 s. */
static double effect_of_looking(enum bonkers_engine engine)
{
    FREED(bonkers) a, b;
    double worst = 0, x[10], v[10], y[10];
    begin(&a, (struct start_request){.kind = START_MIXED}, engine);
    begin(&b, (struct start_request){.kind = START_MIXED}, engine);
    for (int k = 1; k <= 5000; ++k)
        bonkers_run(&b, k / 100.0, UINT64_MAX);
    bonkers_run(&a, 50, UINT64_MAX);
    bonkers_state(&a, x, v);
    bonkers_state(&b, y, v);
    for (size_t i = 0; i < 10; ++i)
        worst = fmax(worst, fabs(x[i] - y[i]));
    return worst;
}

/* The naive engine moves everybody whenever it is looked at, and rounds:
   it is off by rounding. The others know nothing of it. */
TEST(test_looking, "only the naive engine feels when it is looked at")
{
    UNIT_TRUE(effect_of_looking(BONKERS_NAIVE) > 0);
    UNIT_NEAR(effect_of_looking(BONKERS_NAIVE), 0, 1e-9);
    UNIT_EQUAL(effect_of_looking(BONKERS_SCAN), 0);
    UNIT_EQUAL(effect_of_looking(BONKERS_HEAP), 0);
    UNIT_EQUAL(effect_of_looking(BONKERS_SLAB), 0);
}

/* After a clock of 10^9 s a place is known to 10^9 eps v = 10^-7 m only:
   bodies still stay in order, none is lost, and the energy is kept. */
TEST(test_late_clock, "a clock of 10^9 s leaves all in order")
{
    for (int e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e) {
        double x[42], v[42];
        size_t crossed = 0;
        MADE(bonkers, b,
             begin(
                 &b,
                 (struct start_request){.kind = START_RANDOM, .movers = 40},
                 (enum bonkers_engine)e));
        for (size_t i = 1; i < b.gaps; ++i)
            b.body[i].since = 1e9;
        b.body[0].since = b.body[b.gaps].since = b.now = 1e9;
        UNIT_EQUAL(bonkers_start(&b, NULL), 41);
        const double before = bonkers_energy(&b);
        for (int k = 1; k <= 1000; ++k) {
            bonkers_run(&b, 1e9 + k * 0.5, UINT64_MAX);
            bonkers_state(&b, x, v);
            for (size_t i = 0; i < b.gaps; ++i)
                crossed += x[i] > x[i + 1];
        }
        UNIT_TRUE(b.collisions > 5000);
        UNIT_EQUAL(crossed + b.disorder, 0);
        /* a random walk of eps/2 and a bias, see tests/library/bonkers.c */
        UNIT_NEAR(bonkers_energy(&b) / before, 1, 1e-12);
    }
}

/* A ball that keeps the part e of its speed has bounced infinitely often
   after (1 + e) / (1 - e) times the time of its fall: when the clock
   stands, it rests. Each of the bounces that are seen is late by a rounding
   of the clock. */
TEST(test_comes_to_rest,
     "a ball comes to rest when the sum of its bounces says")
{
    for (int k = 0; k < 10; ++k) {
        const double e = k / 10.0, g = 9.81, h = 1;
        CREATED(bonkers, b, 1, e, BONKERS_SCAN);
        b.gravity = g;
        b.body[1] = (struct bonkers_body){h, 0, 0, 1};
        b.body[2].x = INFINITY;
        bonkers_start(&b, NULL);
        const enum bonkers_stop stop = bonkers_run(&b, INFINITY, 1000000);
        UNIT_TRUE(stop == BONKERS_STILL);
        UNIT_NEAR(b.now, sqrt(2 * h / g) * (1 + e) / (1 - e), 1e-12);
        UNIT_EQUAL(b.body[1].x, 0);
        UNIT_EQUAL(b.body[1].v, 0);
        UNIT_TRUE(b.collisions < 500); /* log(1e-15) / log(e), or so */
    }
}

/* Three that fall on each other come to rest too, however heavy the upper
   ones. Nine do not: before the tenth bounce of one those below it have
   bounced until they rest, and so on downwards. */
TEST(test_pile, "three that fall come to rest, nine do not")
{
    for (int k = 0; k < 27; ++k) {
        const double e = k % 9 / 10.0;
        const size_t n = k < 18 ? 3 : 9;
        CREATED(bonkers, b, n, e, BONKERS_SCAN);
        b.gravity = 9.81;
        for (size_t i = 1; i <= n; ++i)
            b.body[i] = (struct bonkers_body){0.3 * (double)i, 0, 0,
                                              k < 9 ? 1 : 1 / (double)i};
        b.body[n + 1].x = INFINITY;
        bonkers_start(&b, NULL);
        const enum bonkers_stop stop = bonkers_run(&b, INFINITY, 1000000);
        if (n == 3) {
            UNIT_TRUE(stop == BONKERS_STILL && bonkers_is_still(&b));
            UNIT_EQUAL(bonkers_energy(&b), 0);
        } else if (e <= 0.5) {
            UNIT_TRUE(stop == BONKERS_COLLAPSE);
        }
    }
}
