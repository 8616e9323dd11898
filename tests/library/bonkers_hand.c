/* Runs of so few bodies, or such regular ones, that each collision is known
   by hand: when the last one is, and how many there are until a run ends.
   And what the slab engine does twice. */
#include "unit.h"

#include "line/bonkers.h"
#include "line/collide.h"

#include <float.h>

/* Movers of 1 kg, at these places and velocities, between two walls. */
static void begin(struct bonkers *b, size_t movers, const double x[],
                  const double v[], double restitution,
                  enum bonkers_engine engine)
{
    UNIT_MUST(bonkers_create(b, movers, restitution, engine));
    for (size_t i = 0; i <= b->gaps; ++i)
        b->body[i].x = x[i];
    for (size_t i = 1; i <= movers; ++i) {
        b->body[i].v = v[i];
        b->body[i].im = 1;
    }
    UNIT_EQUAL(bonkers_start(b, NULL), b->gaps);
}

/* 2 m/s for 1 m and then for 2 m: when nothing more comes, the clock stands
   at the last collision, and goes on when it is told to. */
TEST(test_last_collision, "the clock stands at the last collision")
{
    static const double x[] = {-INFINITY, 0, 1, 3, INFINITY};
    static const double v[] = {0, 2, 0, 0, 0};
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        MADE(bonkers, b, begin(&b, 3, x, v, 1, e));
        UNIT_TRUE(!bonkers_is_still(&b));
        UNIT_TRUE(bonkers_run(&b, INFINITY, 2) == BONKERS_COLLISIONS);
        UNIT_TRUE(bonkers_is_still(&b));
        UNIT_TRUE(bonkers_run(&b, INFINITY, 3) == BONKERS_STILL);
        UNIT_EQUAL(b.collisions, 2);
        UNIT_EQUAL(b.now, 1.5);
        UNIT_TRUE(bonkers_run(&b, 4, 3) == BONKERS_TIME);
        UNIT_EQUAL(b.now, 4);
        UNIT_TRUE(bonkers_run(&b, INFINITY, 3) == BONKERS_STILL);
        UNIT_EQUAL(b.now, 4);
        UNIT_EQUAL(bonkers_energy(&b), 2);
    }
}

/* Two that stick between a wall and each other: the first collision is at
   1 s, and from 3 s on the two gaps close in turn, at one time, with half
   the speed each time. The count of the left one begins with collision 2,
   and is one more with every second: at 100 and one for each gap, up to 200
   of them, it is a collapse. (The naive engine has one clock for all, and
   counts the third collision, where the right one comes from afar, too.) */
TEST(test_patience, "how many collisions at one time are a collapse")
{
    static const size_t movers[] = {2, 10, 149, 198, 199, 200, 1000};
    static double x[1002], v[1002];
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        for (size_t k = 0; k < sizeof movers / sizeof movers[0]; ++k) {
            const size_t n = movers[k];
            for (size_t i = 0; i <= n + 1; ++i)
                x[i] = i < 3 ? (double)i : 10 + (double)i;
            v[2] = -1;
            MADE(bonkers, b, begin(&b, n, x, v, 0, e));
            const double patience = 100 + (n < 200 ? (double)n + 1 : 200);
            UNIT_TRUE(bonkers_run(&b, INFINITY, UINT64_MAX) ==
                      BONKERS_COLLAPSE);
            UNIT_EQUAL(b.collisions,
                       2 * patience + (e == BONKERS_NAIVE ? 1 : 2));
            UNIT_EQUAL(b.now, 3);
            UNIT_TRUE(!bonkers_is_cold(&b));
        }
}

/* A body that is reflected at half its speed: the 452nd time it comes at
   2^-451 m/s, which is too slow for numbers. */
TEST(test_cold, "a body too slow for numbers ends a run")
{
    static const double x[] = {0, 1, 2}, v[] = {0, 1, 0};
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        MADE(bonkers, b, begin(&b, 1, x, v, 0.5, e));
        UNIT_TRUE(bonkers_run(&b, INFINITY, 451) == BONKERS_COLLISIONS);
        UNIT_EQUAL(fabs(b.body[1].v), 0x1p-451);
        UNIT_TRUE(bonkers_run(&b, INFINITY, 1000) == BONKERS_COLLAPSE);
        UNIT_EQUAL(b.collisions, 452);
        UNIT_TRUE(bonkers_is_cold(&b));
    }
}

TEST(test_energy, "energies above a floor and without")
{
    CREATED(bonkers, b, 2, 1, BONKERS_SCAN);
    b.gravity = 10;
    b.body[0].x = 1;
    b.body[1] = (struct bonkers_body){3, 3, 0, 0.5};
    b.body[2] = (struct bonkers_body){5, -1, 0, 0.25};
    b.body[3] = (struct bonkers_body){9, 0, 0, 0};
    /* 2 kg: 9 + 40; 4 kg: 2 + 160 */
    UNIT_EQUAL(bonkers_energy(&b), 211);
    b.body[0].x = -INFINITY;
    UNIT_EQUAL(bonkers_energy(&b), 211 + 60);
    b.gravity = 0;
    UNIT_EQUAL(bonkers_energy(&b), 11);
}

TEST(test_rods, "points and rods")
{
    for (size_t with = 0; with <= 3; ++with) {
        FREED(bonkers) b;
        size_t wrong = 99;
        double x[5], v[5];
        CREATED(start, s, 3);
        for (size_t i = 0; i < 3; ++i) {
            s.x[i] = 2 + 2 * (double)i;
            s.v[i] = (double)i;
            s.mass[i] = (double)(1 << i);
        }
        s.wall[0] = 1;
        s.wall[1] = 8;
        s.gravity = 0.25;
        if (with < 3)
            s.radius[with] = 0.5;
        UNIT_TRUE(bonkers_begin(&b, &s, 1, BONKERS_HEAP, &wrong));
        UNIT_EQUAL(wrong, 4);
        UNIT_TRUE((b.shift == NULL) == (with == 3));
        UNIT_EQUAL(b.gravity, 0.25);
        UNIT_EQUAL(b.extent, 8);
        bonkers_state(&b, x, v);
        for (size_t i = 0; i < 5; ++i) {
            const double taken = i < with + 1 ? 0 : i == with + 1 ? 0.5 : 1;
            UNIT_EQUAL(x[i], i == 0 ? 1 : i == 4 ? 8 : 2 * (double)i);
            UNIT_EQUAL(b.body[i].x, x[i] - (with < 3 ? taken : 0));
            UNIT_EQUAL(v[i], i % 4 ? (double)i - 1 : 0);
            UNIT_EQUAL(b.body[i].im, i % 4 ? 1.0 / (1 << (i - 1)) : 0);
        }
    }
}

/* Three that fall together from rest for 100 s, at 1 m/s2: rounding may
   misplace each by eight epsilons of 5000 m and of 100 m/s for 100 s. Two
   that are in the wrong order by less are put right, by more are counted.
 */
TEST(test_falling_order, "order in a fall, but for rounding")
{
    static const double x[] = {-INFINITY, 1, 2, 3, INFINITY};
    static const double v[] = {0, 0, 0, 0, 0};
    for (int more = 0; more < 2; ++more) {
        double at[5], u[5];
        MADE(bonkers, b, begin(&b, 3, x, v, 1, BONKERS_SCAN));
        b.gravity = 1;
        bonkers_start(&b, NULL);
        UNIT_TRUE(bonkers_run(&b, 100, UINT64_MAX) == BONKERS_TIME);
        const double allowed = 8 * DBL_EPSILON * 2 * (5000 + 100 * 100);
        b.body[2].x = 1 - (more ? 1.1 : 0.9) * allowed;
        bonkers_state(&b, at, u);
        UNIT_EQUAL(b.disorder, more);
        UNIT_EQUAL(at[2], at[1]);
        UNIT_NEAR(at[1], 1 - 5000, 1e-11);
        UNIT_EQUAL(u[1], -100);
    }
}

/* Where islands meet, or slabs, some collisions are done twice: 3 to 5 in a
   hundred of them, however many bodies there are. If there were more, the
   slabs would not be worth it; if there were none, there would be none. */
TEST(test_done_twice, "little is done twice")
{
    static const size_t movers[] = {200, 1000, 5000};
    for (size_t k = 0; k < 3; ++k)
        for (uint64_t seed = 1; seed <= 3; ++seed) {
            FREED(start) s;
            FREED(bonkers) b;
            size_t wrong;
            UNIT_MUST(
                start_fill(&s, &(struct start_request){.kind = START_RANDOM,
                                                       .movers = movers[k],
                                                       .seed = seed}) &&
                bonkers_begin(&b, &s, 1, BONKERS_SLAB, &wrong));
            bonkers_run(&b, 5 + 20000.0 / (double)movers[k], UINT64_MAX);
            UNIT_TRUE(b.collisions > 6000);
            UNIT_NEAR((double)b.redone / (double)b.collisions, 0.04, 0.02);
        }
}

/* Of two equal masses the right one counts as the heavier, as in collide:
   its part is rounded, and the left one's is the rest. It shows in the last
   bit that there is alone. */
TEST(test_last_bit, "equal masses, in the last bit")
{
    static const double x[] = {0, 1, 1, 2}, v[] = {0, 0x1p-1074, 0, 0};
    double left = v[1], right = v[2];
    UNIT_TRUE(collide(&left, &right, 1, 1, 0));
    UNIT_EQUAL(left, 0);
    UNIT_EQUAL(right, 0);
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        MADE(bonkers, b, begin(&b, 2, x, v, 0, e));
        bonkers_run(&b, INFINITY, 1);
        UNIT_EQUAL(b.collisions, 1);
        UNIT_EQUAL(b.body[1].v, 0);
        UNIT_EQUAL(b.body[2].v, 0);
    }
}
