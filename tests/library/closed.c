/* The closed forms: the exponential against the library's in long double,
   friction and weight against series and steps, the oscillator against
   values of 16 digits, equal points against chapter 2's engine. */
#include "unit.h"

#include "line/bonkers.h"
#include "choosing/closed.h"
#include "library/oscillator.h"
#include "toolbox/random.h"

#include <float.h>

/* Fourteen sums and products, of which only the last two are not small:
   measured 2.9 units in the last place. */
TEST(test_exponential, "the exponential is right to its last bits")
{
    double worst = 0;
    for (double x = -700; x < 700; x += 0.1234567) {
        const long double right = expl(x);
        worst = fmax(worst, (double)fabsl((closed_exp(x) - right) / right));
    }
    UNIT_NEAR(worst, 0, 4 * DBL_EPSILON);
    UNIT_EQUAL(closed_exp(0), 1);
    UNIT_EQUAL(closed_exp(-1000), 0);
    UNIT_EQUAL(closed_exp(-INFINITY), 0);
    UNIT_TRUE(closed_exp(1000) == INFINITY);
    UNIT_TRUE(isnan(closed_exp(NAN)));
    /* where numbers have fewer digits: a unit in their last place */
    UNIT_NEAR(closed_exp(-740), 4.2e-322, 5e-323);
}

/* v e^(-kt) + g (1 - e^(-kt))/k, and its integral, in long double. */
TEST(test_flight, "flight under weight and friction")
{
    static const double rates[] = {0, 1e-12, 1e-5, 0.3, 1, 1.0000001, 20};
    for (size_t i = 0; i < sizeof rates / sizeof *rates; ++i)
        for (double t = 0.25; t < 10; t *= 2) {
            const long double k = rates[i], z = k * t;
            const long double p1 = k > 0 ? -expm1l(-z) / k : t;
            long double p2 = 0, term = (long double)t * t / 2;
            for (int n = 3; n < 60 && z < 3; ++n, term *= -z / (n - 1))
                p2 += term;
            if (!(z < 3))
                p2 = (t - p1) / k;
            double x = 2, v = -3;
            closed_fly(t, rates[i], 1.5, &x, &v);
            UNIT_NEAR(x, 2 - 3 * p1 + 1.5L * p2,
                      1e-15 * (2 + 3 * t + 1.5 * t * t));
            UNIT_NEAR(v, -3 * expl(-z) + 1.5L * p1, 1e-15 * (3 + 1.5 * t));
        }
    /* a million times its time, and it is v / rate away: 1 + 8.6e-11 if the
       series' way is gone backwards */
    double x = 0, v = 1;
    closed_fly(1000003.7, 1, 0, &x, &v);
    UNIT_NEAR(x, 1, 4e-16);
    UNIT_NEAR(v, 0, 0);
}

/* 2e-15 is a few roundings of numbers below 2. */
TEST(test_oscillator,
     "the oscillator of 18 known places, near-critical too")
{
    for (size_t i = 0; i < 6; ++i)
        for (size_t k = 0; k < 3; ++k) {
            const double *known = oscillator_known[i];
            double y = 1, v = 0;
            closed_oscillate(oscillator_times[k], 1, 2 * known[0], &y, &v);
            UNIT_NEAR(y, known[1 + k], 2e-15);
        }
}

/* In two parts it is the same as in one; a rate of zero keeps the energy;
   a stiffness of zero is friction alone; long times are no trouble. */
TEST(test_oscillator_parts,
     "an oscillation in parts, without spring, for long")
{
    for (double rate = 0; rate < 6; rate += 0.37) {
        double y = 0.7, v = -0.2, y2 = y, v2 = v;
        closed_oscillate(1.3, 2, rate, &y, &v);
        closed_oscillate(0.4, 2, rate, &y2, &v2);
        closed_oscillate(0.9, 2, rate, &y2, &v2);
        UNIT_NEAR(y2, y, 3e-15);
        UNIT_NEAR(v2, v, 3e-15);
    }
    double y = 1, v = 0, x = 1, w = 3;
    closed_oscillate(1e6, 1, 0, &y, &v);
    UNIT_NEAR(y, cos(1e6), 3e-10); /* the angle is rounded to 1e-10 */
    UNIT_NEAR(y * y + v * v, 1, 1e-14);
    y = 1, v = 0; /* creeps: e^(-t/2e6), and 1/(4 * 1e12) of it */
    closed_oscillate(2e6, 1, 2e6, &y, &v);
    UNIT_NEAR(y, exp(-1.0), 1e-12);
    y = 1, v = 3;
    closed_oscillate(2, 0, 0.5, &y, &v);
    closed_fly(2, 0.5, 0, &x, &w);
    UNIT_NEAR(y, x, 1e-14);
    UNIT_NEAR(v, w, 1e-14);
}

enum { MOST = 40 };
static double place[MOST + 2], speed[MOST + 2], x[MOST], v[MOST];

/* Makes of points on a line what they are later, in x and v. */
static void relabel(double low, double high, size_t n, const double at[],
                    const double with[], double t)
{
    memcpy(x, at, n * sizeof *x);
    memcpy(v, with, n * sizeof *v);
    UNIT_TRUE(closed_relabel(low, high, n, x, v, t));
}

/* Walls on no side, one side or both; times between collisions, where the
   exact answers are unique. Rounding of places grows with the way flown. */
TEST(test_relabel,
     "equal points are those of chapter 2, and so are their meetings")
{
    SEEDED(r, 12);
    uint64_t all = 0;
    for (int round = 0; round < 400; ++round) {
        const size_t n = 1 + random_below(&r, MOST);
        const bool left = round & 1, right = round & 2;
        const double t = random_between(&r, 0, 20);
        FREED(bonkers) b;
        size_t wrong;
        CREATED(start, start, n);
        for (size_t i = 0; i < n; ++i) {
            start.x[i] = (double)i + random_between(&r, 0.1, 0.9);
            start.v[i] = random_between(&r, -1, 1);
        }
        start.wall[0] = left ? 0 : -INFINITY;
        start.wall[1] = right ? (double)n : INFINITY;
        UNIT_TRUE(bonkers_begin(&b, &start, 1, BONKERS_SCAN, &wrong));
        UNIT_EQUAL(bonkers_run(&b, t, UINT64_MAX), BONKERS_TIME);
        bonkers_state(&b, place, speed);
        relabel(start.wall[0], start.wall[1], n, start.x, start.v, t);
        for (size_t i = 0; i < n; ++i) {
            UNIT_NEAR(x[i], place[i + 1], 1e-12);
            UNIT_NEAR(v[i], speed[i + 1], 1e-15);
        }
        all += b.collisions;
        UNIT_EQUAL(closed_meetings(start.wall[0], start.wall[1], n, start.x,
                                   start.v, t),
                   b.collisions);
    }
    UNIT_TRUE(all > 10000);
}

/* A collision at the very time has taken place, as in chapter 2. */
TEST(test_relabel_at_once, "what happens at the very time has happened")
{
    const double at[] = {1, 3}, with[] = {1, -1};
    relabel(-INFINITY, INFINITY, 2, at, with, 1);
    UNIT_LIST(x, 0, 2, 2);
    UNIT_LIST(v, 0, -1, 1);
    relabel(0, INFINITY, 2, at, with, 3);
    UNIT_EQUAL(x[0], 0);
    UNIT_EQUAL(v[0], 1);
    relabel(-INFINITY, 4, 2, at, (double[]){1, -1}, 3);
    UNIT_LIST(x, 0, 0, 4);
    UNIT_LIST(v, 0, -1, -1);
    relabel(0, 4, 2, at, with, 3);
    UNIT_EQUAL(x[0], 0);
    UNIT_EQUAL(v[0], 1);
    UNIT_EQUAL(x[1], 4);
    UNIT_EQUAL(v[1], -1);
    UNIT_EQUAL(closed_meetings(0, 4, 2, at, with, 3), 3);
    UNIT_TRUE(closed_meetings(0, 4, 2, at, (double[]){0, 1e21}, 3) ==
              UINT64_MAX); /* more than there are numbers for */
}
