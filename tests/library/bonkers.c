/* The engines: against each other bit for bit, and against what is known
   exactly. Numbers without a derivation beside them are reference values
   computed for this book. */
#include "unit.h"

#include "line/bonkers.h"
#include "line/collide.h"
#include "toolbox/random.h"

#include <float.h>

enum { LARGEST = 100002 };

static const enum bonkers_engine fast[] = {BONKERS_HEAP, BONKERS_SLAB};

/* What a test runs: bodies 0 to movers + 1. */
static struct bonkers_body body[LARGEST];
static double radius[LARGEST];

static void begin(struct bonkers *b, size_t movers, double restitution,
                  enum bonkers_engine engine, bool rods)
{
    UNIT_MUST(bonkers_create(b, movers, restitution, engine));
    memcpy(b->body, body, (movers + 2) * sizeof body[0]);
    const size_t wrong = bonkers_start(b, rods ? radius : NULL);
    UNIT_EQUAL(wrong, (double)movers + 1);
}

/* Points, or rods of up to 0.3 m in their place, with masses from 1 to 9,
   in a box of movers + 1 metres, and of the lengths of the rods. */
static void fill_random(size_t movers, uint64_t seed, bool rods)
{
    SEEDED(r, seed);
    double shift = 0;
    MADE(start, s,
         start_fill(&s, &(struct start_request){.kind = START_RANDOM,
                                                .movers = movers,
                                                .seed = seed}));
    memset(radius, 0, (movers + 2) * sizeof radius[0]);
    memset(body, 0, (movers + 2) * sizeof body[0]);
    for (size_t i = 1; i <= movers; ++i) {
        radius[i] = rods ? random_between(&r, 0, 0.15) : 0;
        body[i] = (struct bonkers_body){s.x[i - 1] + shift + radius[i],
                                        s.v[i - 1], 0, 1 / s.mass[i - 1]};
        shift += 2 * radius[i];
    }
    body[movers + 1].x = s.wall[1] + shift;
}

static double state[2][2][LARGEST];

/* Says what differs between two runs: the state at the clock's time, the
   clock, or the count; NULL when no bit does. */
static const char *differs(struct bonkers *a, struct bonkers *b)
{
    const size_t size = (a->gaps + 1) * sizeof(double);
    bonkers_state(a, state[0][0], state[0][1]);
    bonkers_state(b, state[1][0], state[1][1]);
    return a->collisions != b->collisions            ? "the count"
           : memcmp(&a->now, &b->now, sizeof a->now) ? "the clock"
           : memcmp(state[0][0], state[1][0], size)  ? "a position"
           : memcmp(state[0][1], state[1][1], size)  ? "a velocity"
           : a->restitution == 1 && a->disorder + b->disorder > 0
               ? "the order"
               : NULL;
}

/* A stop: at a time or at a collision, whichever comes first. */
struct stop {
    double until;
    uint64_t collisions;
};

/* Runs the scan and the others from stop to stop, and compares them at
   each; a time that has passed is now. Returns the last reason to stop. */
static enum bonkers_stop compare(size_t movers, double restitution,
                                 bool rods, const struct stop stops[],
                                 size_t n, const char *what)
{
    enum bonkers_stop last = BONKERS_TIME;
    for (size_t e = 0; e < sizeof fast / sizeof fast[0]; ++e) {
        FREED(bonkers) scan, other;
        const char *difference = NULL;
        begin(&scan, movers, restitution, BONKERS_SCAN, rods);
        begin(&other, movers, restitution, fast[e], rods);
        for (size_t k = 0; k < n && !difference; ++k) {
            const double now = scan.now;
            const double until = fmax(stops[k].until, now);
            last = bonkers_run(&scan, until, stops[k].collisions);
            const enum bonkers_stop stop =
                bonkers_run(&other, until, stops[k].collisions);
            difference = stop != last     ? "the stop"
                         : scan.now < now ? "a time that runs backwards"
                                          : differs(&scan, &other);
            if (difference)
                printf("# %s, %zu movers, e = %g: scan and %s differ in "
                       "%s at stop %zu, %llu collisions, t = %g\n",
                       what, movers, restitution,
                       bonkers_engine_names[fast[e]], difference, k,
                       (unsigned long long)scan.collisions, scan.now);
            if (last == BONKERS_STILL || last == BONKERS_COLLAPSE)
                break;
        }
        UNIT_TRUE(difference == NULL);
    }
    return last;
}

enum { STOPS = 12 };

/* Stops that are reached in turn by the time and by the count: about
   `collisions` in all, at half a collision per mover and second. */
static void choose_stops(struct stop stops[STOPS], size_t movers,
                         double collisions, uint64_t seed)
{
    SEEDED(r, seed);
    const double length = collisions / (0.5 * (double)movers);
    for (int k = 0; k < STOPS; ++k) {
        const double part = (k + random_uniform(&r)) / STOPS;
        stops[k] =
            k % 3 == 2
                ? (struct stop){INFINITY, 1 + (uint64_t)(collisions * part)}
                : (struct stop){length * part, UINT64_MAX};
    }
}

TEST(test_engines_agree, "scan, heap and slab give the same bits")
{
    static const struct {
        size_t movers;
        double collisions;
        int seeds;
    } runs[] = {{1, 200, 6},     {2, 2000, 10},    {3, 2000, 10},
                {7, 3000, 10},   {33, 5000, 8},    {100, 8000, 6},
                {1000, 8000, 3}, {20000, 15000, 1}};
    for (size_t k = 0; k < sizeof runs / sizeof runs[0]; ++k)
        for (int seed = 1; seed <= runs[k].seeds; ++seed)
            for (int rods = 0; rods < 2; ++rods) {
                struct stop stops[STOPS];
                choose_stops(stops, runs[k].movers, runs[k].collisions,
                             (uint64_t)seed);
                fill_random(runs[k].movers, (uint64_t)seed, rods);
                UNIT_TRUE(compare(runs[k].movers, 1, rods, stops, STOPS,
                                  "random") <= BONKERS_COLLISIONS);
            }
}

/* Restitution below one: until the time 100, the collision 3000, all at
   rest, or a collapse, as it comes. */
TEST(test_inelastic_engines_agree, "so they do with restitution below one")
{
    static const size_t movers[] = {1, 2, 3, 7, 33, 100, 1000};
    static const double restitution[] = {0.95, 0.5, 0.1, 0};
    int seen[BONKERS_COLLAPSE + 1] = {0};
    for (size_t n = 0; n < sizeof movers / sizeof movers[0]; ++n)
        for (int e = 0; e < 4; ++e)
            for (uint64_t seed = 1; seed <= 6; ++seed) {
                const struct stop stops[] = {
                    {0.3, UINT64_MAX}, {INFINITY, movers[n] + seed},
                    {20, UINT64_MAX},  {INFINITY, 5 * movers[n]},
                    {100, 3000},       {INFINITY, 40000}};
                fill_random(movers[n], seed, seed % 2);
                ++seen[compare(movers[n], restitution[e], seed % 2, stops,
                               n < 6 ? 6 : 4, "inelastic")];
            }
    UNIT_TRUE(seen[BONKERS_COLLAPSE] > 10);
    UNIT_TRUE(seen[BONKERS_COLLISIONS] > 10);
}

TEST(test_large_collapse, "and with 20000 of low restitution")
{
    const struct stop stops[] = {{0.5, UINT64_MAX}, {0.7, 3000}};
    fill_random(20000, 5, false);
    compare(20000, 0.1, false, stops, 2, "large inelastic");
}

/* A lattice with velocities of +1 and -1 in turn: many gaps close at one
   time, over and over, and all numbers are exact. */
static void fill_lattice(size_t movers, const double masses[2])
{
    memset(body, 0, (movers + 2) * sizeof body[0]);
    for (size_t i = 1; i <= movers; ++i)
        body[i] = (struct bonkers_body){(double)i, i % 2 ? 1 : -1, 0,
                                        1 / masses[i % 2]};
    body[movers + 1].x = (double)movers + 1;
}

TEST(test_ties, "and where many gaps close at one time")
{
    static const double masses[][2] = {{1, 1}, {1, 3}, {4, 1}, {1, 2.7}};
    static const size_t movers[] = {2, 3, 6, 7, 32, 33, 100, 1001};
    for (size_t n = 0; n < sizeof movers / sizeof movers[0]; ++n)
        for (int m = 0; m < 4; ++m)
            for (int e = 0; e < 2; ++e) {
                struct stop stops[40];
                fill_lattice(movers[n], masses[m]);
                for (uint64_t k = 0; k < 40; ++k)
                    stops[k] =
                        k % 4 == 3
                            ? (struct stop){(double)(k + 1) / 4, UINT64_MAX}
                            : (struct stop){INFINITY,
                                            1 + k * movers[n] / 9};
                if (!e || movers[n] < 50)
                    compare(movers[n], e ? 0.75 : 1, false, stops, 40,
                            "lattice");
            }
}

TEST(test_every_collision, "and after every single collision")
{
    for (size_t movers = 1; movers <= 40; movers += 13)
        for (int k = 0; k < 2; ++k) {
            static struct stop stops[2000];
            for (uint64_t c = 0; c < 2000; ++c)
                stops[c] = (struct stop){INFINITY, c + 1};
            if (k)
                fill_lattice(movers, (double[]){1, 3});
            else
                fill_random(movers, 4, false);
            compare(movers, 1, false, stops, 2000, "one by one");
        }
}

TEST(test_collision_number,
     "collision number C is the same on any way there")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
        for (uint64_t c = 1; c < 400; c += 7) {
            fill_lattice(101, (double[]){1, 3});
            MADE(bonkers, a, begin(&a, 101, 1, e, false));
            MADE(bonkers, b, begin(&b, 101, 1, BONKERS_SCAN, false));
            UNIT_TRUE(bonkers_run(&a, INFINITY, c) == BONKERS_COLLISIONS);
            while (b.collisions < c)
                bonkers_run(&b, INFINITY, b.collisions + 1);
            UNIT_TRUE(differs(&a, &b) == NULL);
            UNIT_TRUE(bonkers_run(&a, INFINITY, c) == BONKERS_COLLISIONS);
            UNIT_TRUE(bonkers_run(&a, INFINITY, 0) == BONKERS_COLLISIONS);
            UNIT_TRUE(differs(&a, &b) == NULL);
        }
}

/* Rods that touch, at rest, in the middle of a wider box. */
static void fill_row(size_t movers, bool random_masses)
{
    SEEDED(r, 11);
    memset(body, 0, (movers + 2) * sizeof body[0]);
    memset(radius, 0, (movers + 2) * sizeof radius[0]);
    for (size_t i = 1; i <= movers; ++i) {
        body[i] = (struct bonkers_body){
            (double)i + 2, 0, 0,
            random_masses ? random_between(&r, 0.2, 1) : 1};
        radius[i] = 0.5;
    }
    body[movers + 1].x = (double)movers + 6;
}

TEST(test_touching_rows, "and in touching rows")
{
    static const size_t movers[] = {2, 5, 40, 300};
    for (size_t n = 0; n < 4; ++n)
        for (int masses = 0; masses < 2; ++masses)
            for (int struck = 0; struck < 3; ++struck) {
                const uint64_t many = movers[n];
                const struct stop stops[] = {
                    {INFINITY, many / 2 + 1}, {INFINITY, many},
                    {2.5, UINT64_MAX},        {INFINITY, 3 * many},
                    {30, 20 * many},          {40, 30 * many + 5000}};
                if (masses && many > 40)
                    continue; /* collisions at one time without number */
                fill_row(movers[n], masses);
                if (struck != 1)
                    body[1].v = 1;
                if (struck != 0)
                    body[movers[n]].v = -1;
                compare(movers[n], 1, true, stops, 6, "row");
            }
}

/* One end of 100000 touching bodies is struck: 99999 collisions at one
   time, then the last one flies to the wall and back, for 4 s. */
TEST(test_long_row, "a touching row of 100000 is struck")
{
    enum { ROW = 100000 };
    fill_row(ROW, false);
    body[1].v = 1;
    MADE(bonkers, heap, begin(&heap, ROW, 1, BONKERS_HEAP, true));
    MADE(bonkers, slab, begin(&slab, ROW, 1, BONKERS_SLAB, true));
    for (int k = 1; k <= 8; ++k) {
        bonkers_run(&heap, k, UINT64_MAX);
        bonkers_run(&slab, k, UINT64_MAX);
        UNIT_TRUE(differs(&heap, &slab) == NULL);
        if (k == 1) {
            UNIT_EQUAL(slab.collisions, ROW - 1);
            UNIT_EQUAL(slab.body[ROW].v, 1);
            UNIT_EQUAL(slab.body[1].v, 0);
        }
    }
}

/* Points all in one place: pairs that approach collide, pairs that part
   do not, whatever their gap. */
TEST(test_one_place, "and from one place")
{
    for (uint64_t seed = 1; seed <= 10; ++seed) {
        const struct stop stops[] = {{0, UINT64_MAX},
                                     {INFINITY, 100},
                                     {2, UINT64_MAX},
                                     {INFINITY, 3000}};
        fill_random(30, seed, false);
        for (size_t i = 1; i <= 30; ++i)
            body[i].x = 10;
        compare(30, 1, false, stops, 4, "one place");
    }
}

/* A light body between heavy ones: bursts of many collisions in a short
   time, in the middle of others. */
TEST(test_bursts, "and in bursts between heavy bodies")
{
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const size_t movers = seed % 2 ? 6 : 200;
        struct stop stops[STOPS];
        fill_random(movers, seed, seed % 3 == 0);
        for (size_t i = 1; i <= movers; i += 4)
            body[i].im = seed % 4 ? 1e-6 : 1e-4;
        for (int k = 0; k < STOPS; ++k)
            stops[k] =
                k % 2 ? (struct stop){INFINITY, 2000 * (uint64_t)(k + 1)}
                      : (struct stop){0.05 * (k + 1), UINT64_MAX};
        compare(movers, 1, seed % 3 == 0, stops, movers == 6 ? STOPS : 2,
                "burst");
    }
}

/* A burst of 314159 collisions, more than a slab holds, with others on both
   sides; it is cut in its middle. */
TEST(test_long_burst, "and in a burst longer than a slab")
{
    const struct stop stops[] = {{0.5, UINT64_MAX},  {INFINITY, 120000},
                                 {INFINITY, 120001}, {INFINITY, 300000},
                                 {3, 330000},        {4, 400000}};
    for (size_t movers = 2; movers < 60; movers += 19) {
        fill_random(movers, 8, false);
        for (size_t i = 1; i <= movers; ++i) {
            body[i].x = (double)i;
            body[i].v = i == 2 ? -0.6 : 0.01 * (double)(i % 7);
        }
        body[1].im = 1;
        body[2].im = 1e-10;
        compare(movers, 1, false, stops, 6, "long burst");
    }
}

/* Fast bodies among many at rest: what each sets going in a slab is longer
   than what a slab has to itself when others are under way. */
TEST(test_long_waves, "and in waves longer than slabs under way")
{
    enum { MOVERS = 4000 };
    const struct stop stops[] = {{0.3, UINT64_MAX},
                                 {INFINITY, 9000},
                                 {INFINITY, 40000},
                                 {20, UINT64_MAX}};
    for (size_t fast = 1; fast <= 5; fast += 2) {
        fill_random(MOVERS, fast, false);
        for (size_t i = 1; i <= MOVERS; ++i) {
            const bool flies = i % (MOVERS / fast) == MOVERS / 2 / fast;
            body[i].im = 1;
            body[i].v = flies ? i % 3 ? 100 : -100 : 0;
        }
        compare(MOVERS, 1, false, stops, 4, "long waves");
    }
}

/* Pairs that all meet at one time, and then with their other neighbours:
   more wait in an island than a slab has room for. */
TEST(test_crowd, "and in a crowd that a slab has no room for")
{
    enum { MOVERS = 9000 };
    const struct stop stops[] = {{0.6, UINT64_MAX},
                                 {INFINITY, 11000},
                                 {1.6, UINT64_MAX},
                                 {INFINITY, 20000}};
    fill_random(MOVERS, 1, false);
    body[0].x = 0;
    body[MOVERS + 1].x = MOVERS + 1;
    for (size_t i = 1; i <= MOVERS; ++i) {
        body[i].x = (double)i;
        body[i].im = 1;
        body[i].v = i % 2 ? 1 : -1;
    }
    compare(MOVERS, 1, false, stops, 4, "crowd");
}

/* Without walls, or with one, the run ends when all fly apart: the clock
   stands at the last collision, or goes on to the time asked for. */
TEST(test_open_ends, "and with open ends")
{
    static const size_t movers[] = {1, 2, 5, 50, 400};
    for (size_t n = 0; n < 5; ++n)
        for (int e = 0; e < 2; ++e)
            for (int walls = 0; walls < 4; ++walls) {
                const struct stop stops[] = {{0.7, UINT64_MAX},
                                             {INFINITY, movers[n]},
                                             {20, UINT64_MAX},
                                             {1e6, 3 * movers[n]},
                                             {INFINITY, 3000000}};
                fill_random(movers[n], n + 1, false);
                if (walls & 1)
                    body[0].x = -INFINITY;
                if (walls & 2)
                    body[movers[n] + 1].x = INFINITY;
                if (e && walls != 3 && movers[n] > 50)
                    continue;
                const enum bonkers_stop stop =
                    compare(movers[n], e ? 0.97 : 1, false, stops,
                            walls ? 5 : 4, "open");
                if (walls && !e)
                    UNIT_TRUE(stop == BONKERS_STILL);
            }
}

TEST(test_cuts_change_no_bit, "no cut and no look changes a bit")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
        for (uint64_t seed = 1; seed <= 12; ++seed) {
            const size_t movers = 3 * seed * seed;
            FREED(bonkers) whole, cut;
            struct random r;
            static double x[LARGEST], v[LARGEST];
            const double restitution = seed % 3 ? 1 : 0.99;
            const double length = 3000.0 / (double)movers;
            random_seed(&r, seed);
            fill_random(movers, seed, seed % 2);
            begin(&whole, movers, restitution, e, seed % 2);
            begin(&cut, movers, restitution, e, seed % 2);
            while (cut.now < length) {
                const double step =
                    random_log_uniform(&r, 1e-6, length / 3);
                const uint64_t more = random_below(&r, 100);
                bonkers_run(&cut, fmin(length, cut.now + step),
                            cut.collisions + more);
                bonkers_state(&cut, x, v);
            }
            bonkers_run(&whole, length, UINT64_MAX);
            UNIT_TRUE(whole.collisions > 100);
            UNIT_TRUE(differs(&whole, &cut) == NULL);
        }
}

/* The engines differ from the naive one by rounding only. Each collision
   of either engine errs by a few eps in a velocity and by a few eps
   (L + v t) in a position, v t for the rounding of the clock; an error of
   a velocity moves a position by as much times t. A collision is a
   reflection in scaled velocities, so errors are not magnified, but may be
   handed from the heaviest to the lightest, sqrt(9) = 3 times as large. n
   collisions, 2 engines, 4 roundings each: 24 n eps (L + 2 v t), where the
   largest v is below sqrt(2 E / 1) = sqrt(N). */
TEST(test_naive_agrees, "the naive engine differs by rounding")
{
    static const size_t movers[] = {1, 2, 3, 7, 33};
    for (size_t n = 0; n < 5; ++n)
        for (uint64_t seed = 1; seed <= 6; ++seed) {
            FREED(bonkers) naive, scan;
            const double t = 200.0 / (double)movers[n], size = t / 10;
            double worst = 0;
            fill_random(movers[n], seed, seed % 2);
            begin(&naive, movers[n], 1, BONKERS_NAIVE, seed % 2);
            begin(&scan, movers[n], 1, BONKERS_SCAN, seed % 2);
            for (int k = 1; k <= 10; ++k) {
                UNIT_TRUE(bonkers_run(&naive, k * size, UINT64_MAX) ==
                          BONKERS_TIME);
                bonkers_run(&scan, k * size, UINT64_MAX);
                UNIT_EQUAL(naive.collisions, scan.collisions);
                differs(&naive, &scan);
                for (size_t i = 0; i <= naive.gaps; ++i)
                    worst =
                        fmax(worst, fabs(state[0][0][i] - state[1][0][i]));
            }
            UNIT_NEAR(worst, 0,
                      24 * (double)scan.collisions * DBL_EPSILON *
                          (body[movers[n] + 1].x +
                           2 * sqrt((double)movers[n]) * t));
        }
}

/* Left and right exchanged, or all units changed by powers of two: every
   bit stays. */
TEST(test_symmetries, "mirrored and in other units, every bit is the same")
{
    static const size_t movers[] = {2, 7, 33, 150};
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
        for (size_t n = 0; n < 4; ++n) {
            const size_t last = movers[n] + 1;
            size_t same = 0;
            fill_random(movers[n], 21, false);
            MADE(bonkers, a, begin(&a, movers[n], 1, e, false));
            for (size_t i = 0; i <= last; ++i) {
                body[i].x = a.body[i].x * 1024;
                body[i].v *= 0.25;
                body[i].im *= 8;
            }
            MADE(bonkers, scaled, begin(&scaled, movers[n], 1, e, false));
            for (size_t i = 0; i <= last; ++i)
                body[i] = (struct bonkers_body){-a.body[last - i].x,
                                                -a.body[last - i].v, 0,
                                                a.body[last - i].im};
            MADE(bonkers, mirror, begin(&mirror, movers[n], 1, e, false));
            bonkers_run(&a, 40, UINT64_MAX);
            bonkers_run(&mirror, 40, UINT64_MAX);
            bonkers_run(&scaled, 40 * 4096.0, UINT64_MAX);
            bonkers_state(&mirror, state[1][0], state[1][1]);
            for (size_t i = 0; i <= last; ++i) {
                const struct bonkers_body *p = &a.body[i];
                const struct bonkers_body *q = &mirror.body[last - i];
                const struct bonkers_body *s = &scaled.body[i];
                same += p->x == -q->x && p->v == -q->v &&
                        p->since == q->since && p->x * 1024 == s->x &&
                        p->v == 4 * s->v && p->since * 4096 == s->since;
            }
            UNIT_TRUE(a.collisions > 20);
            UNIT_EQUAL(same, (double)last + 1);
        }
}

/* In no row is a body left of its neighbour, and both walls stand where
   they stood. Rods may overlap by the rounding of a position and a shift:
   2 eps of a number up to 2 L. */
TEST(test_order_and_walls, "bodies stay in order and walls stand")
{
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const size_t movers = 2 + 5 * seed, rods = seed % 2;
        double *x = state[0][0], *v = state[0][1];
        size_t crossed = 0;
        fill_random(movers, seed, rods);
        if (seed % 3 == 0)
            for (size_t i = 1; i <= movers; i += 3)
                body[i].im = 1e-5;
        MADE(bonkers, b, begin(&b, movers, 1, BONKERS_AUTO, rods));
        const double length = body[movers + 1].x;
        for (int k = 1; k <= 4000; ++k) {
            if (k % 2)
                bonkers_run(&b, b.now + 0.01 * (double)seed, UINT64_MAX);
            else
                bonkers_run(&b, INFINITY, b.collisions + 1 + seed);
            bonkers_state(&b, x, v);
            crossed += x[0] != 0 || x[movers + 1] != length || v[0] != 0 ||
                       v[movers + 1] != 0;
            for (size_t i = 0; i <= movers; ++i)
                crossed += x[i + 1] - x[i] <
                           radius[i] + radius[i + 1] -
                               (rods ? 4 * DBL_EPSILON * length : 0);
        }
        UNIT_EQUAL(crossed, 0);
        UNIT_EQUAL(b.disorder, 0);
    }
}

/* With radii and places that are whole multiples of 2^-20 nothing is
   rounded when the radii are taken out: rods are points in a smaller box,
   to the last bit. */
TEST(test_rods_are_points, "rods are points in a smaller box")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
        for (size_t movers = 1; movers < 200; movers = 3 * movers + 1) {
            SEEDED(r, movers);
            double shift[LARGEST / 100], sum = 0;
            size_t same = 0;
            fill_random(movers, movers, false);
            for (size_t i = 0; i <= movers + 1; ++i)
                body[i].x = round(body[i].x * 0x1p20) * 0x1p-20;
            MADE(bonkers, points, begin(&points, movers, 1, e, false));
            for (size_t i = 0; i <= movers + 1; ++i) {
                const bool wall = i == 0 || i == movers + 1;
                radius[i] =
                    wall ? 0 : (double)random_below(&r, 1 << 20) * 0x1p-20;
                shift[i] = sum + radius[i];
                body[i].x += shift[i];
                sum += 2 * radius[i];
            }
            MADE(bonkers, rods, begin(&rods, movers, 1, e, true));
            bonkers_run(&points, 30, UINT64_MAX);
            bonkers_run(&rods, 30, UINT64_MAX);
            UNIT_EQUAL(rods.collisions, points.collisions);
            UNIT_TRUE(rods.collisions > 5);
            differs(&points, &rods);
            for (size_t i = 0; i <= movers + 1; ++i)
                same += state[1][0][i] == state[0][0][i] + shift[i] &&
                        state[1][1][i] == state[0][1][i];
            UNIT_EQUAL(same, (double)movers + 2);
        }
}

/* Starts that are their own mirror image, so that three bodies meet in the
   middle at one time but for rounding, which may put them in the wrong
   order. No clock runs backwards, no row is out of order, even a last bit
   before or after a collision; none is lost, so the energy and the
   symmetry stay. */
TEST(test_threes, "three that meet at once stay in order")
{
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        const size_t half = 1 + seed % 5, movers = 2 * half + 1;
        const struct stop stops[] = {{3.3, UINT64_MAX},
                                     {INFINITY, 200},
                                     {INFINITY, 700},
                                     {40, UINT64_MAX}};
        struct bonkers b, ahead;
        double *x = state[0][0], *v = state[0][1];
        size_t wrong = 0;
        fill_random(movers, seed, false);
        const double length = body[movers + 1].x + 0.1 * (double)seed;
        body[movers + 1].x = length;
        body[half + 1].x = length / 2;
        body[half + 1].v = 0;
        for (size_t i = 1; i <= half; ++i) {
            body[i].x *= 0.3;
            body[movers + 1 - i] = (struct bonkers_body){
                length - body[i].x, -body[i].v, 0, body[i].im};
        }
        const double offset = seed % 2 ? 0 : 1000;
        for (size_t i = 0; i <= movers + 1; ++i)
            body[i].x += offset;
        const double right = body[movers + 1].x;
        compare(movers, 1, false, stops, 4, "threes");
        /* so many meetings of three are no collapse */
        UNIT_TRUE(compare(movers, 0.9999, false, stops, 4, "threes") !=
                  BONKERS_COLLAPSE);
        begin(&b, movers, 1, BONKERS_SCAN, false);
        begin(&ahead, movers, 1, BONKERS_SCAN, false);
        const double energy = bonkers_energy(&b);
        for (int k = 0; k < 1500; ++k) {
            const double now = ahead.now;
            bonkers_run(&ahead, INFINITY, ahead.collisions + 1);
            wrong += ahead.now < now;
            for (int look = 0; look < 2; ++look) {
                const double t =
                    look == 0 ? nextafter(ahead.now, 0) : ahead.now;
                if (t < b.now)
                    continue;
                bonkers_run(&b, t, UINT64_MAX);
                bonkers_state(&b, x, v);
                for (size_t i = 0; i <= movers; ++i)
                    wrong += x[i + 1] < x[i];
                wrong += x[0] != offset || x[movers + 1] != right;
            }
        }
        UNIT_EQUAL(wrong, 0);
        UNIT_EQUAL(b.disorder, 0);
        /* a random walk of 1500 steps of eps/2, and ten times as much */
        UNIT_NEAR(bonkers_energy(&b) / energy, 1, 200 * DBL_EPSILON);
        bonkers_free(&b);
        bonkers_free(&ahead);
        begin(&b, movers, 1, BONKERS_NAIVE, false);
        wrong = 0;
        for (int k = 0; k < 300; ++k) {
            const double now = b.now;
            bonkers_run(&b, INFINITY, b.collisions + 1);
            wrong += b.now < now;
        }
        UNIT_EQUAL(wrong, 0);
        bonkers_free(&b);
    }
}

/* Equal masses pass velocities on: the bodies are ghosts that fly through
   each other, folded at the walls. A collision places two
   ghosts by the slower one, and shifts the other by its speed of approach
   times the error of the time, which is at most eps t, and by the rounding
   of two positions, eps L; and changes each speed by two roundings of
   2 v. A ghost meets each of the others, and a wall, at most once in the
   time 2 L / v each: n / N * 2 collisions on average, and surely fewer
   than n. The position of a ghost with a wrong speed is wrong by t times
   as much: 2 n eps (3 v t + L) is a bound, and a hundred times what is
   found. */
TEST(test_equal_masses, "equal masses are ghosts")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
        for (size_t movers = 2; movers <= 10; movers += 4) {
            double ghost[10], speed[2][10], fastest = 0, worst = 0;
            const double length = (double)movers + 1;
            fill_random(movers, 31 + movers, false);
            for (size_t i = 1; i <= movers; ++i) {
                body[i].im = 1 / 0.7;
                speed[0][i - 1] = fabs(body[i].v);
                fastest = fmax(fastest, fabs(body[i].v));
            }
            qsort(speed[0], movers, sizeof(double), unit_rising);
            MADE(bonkers, b, begin(&b, movers, 1, e, false));
            for (double t = 0.1; t < 2e4; t *= 10) {
                bonkers_run(&b, t, UINT64_MAX);
                bonkers_state(&b, state[0][0], state[0][1]);
                for (size_t i = 1; i <= movers; ++i) {
                    double y = fmod(body[i].x + body[i].v * t, 2 * length);
                    y = y < 0 ? y + 2 * length : y;
                    ghost[i - 1] = y > length ? 2 * length - y : y;
                    speed[1][i - 1] = fabs(state[0][1][i]);
                }
                qsort(ghost, movers, sizeof(double), unit_rising);
                qsort(speed[1], movers, sizeof(double), unit_rising);
                const double n = (double)b.collisions + 1;
                const double tolerance =
                    2 * n * DBL_EPSILON * (3 * fastest * t + length);
                for (size_t i = 0; i < movers; ++i) {
                    UNIT_NEAR(state[0][0][i + 1], ghost[i], tolerance);
                    UNIT_NEAR(speed[1][i], speed[0][i],
                              2 * n * DBL_EPSILON * fastest);
                    worst =
                        fmax(worst, fabs(state[0][0][i + 1] - ghost[i]));
                }
            }
            UNIT_TRUE(b.collisions > 1000);
            UNIT_TRUE(worst < 1e-5); /* of gaps of 1 m */
        }
}

/* Five balls in free space, one metre apart or touching: what flies away,
   and after how many collisions. */
static const struct {
    double mass[5], v[5], after[5];
    int collisions;
} cradle[] = {
    {{1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}, {0, 0, 0, 0, 1}, 4},
    {{1, 1, 1, 1, 1}, {1, 1, 0, 0, 0}, {0, 0, 0, 1, 1}, 6},
    {{1, 1, 1, 1, 1}, {1, 1, 1, 0, 0}, {0, 0, 1, 1, 1}, 6},
    {{1, 1, 1, 1, 1}, {1, 0, 0, 0, -1}, {-1, 0, 0, 0, 1}, 7},
    {{2, 1, 1, 1, 1},
     {1, 0, 0, 0, 0},
     {1 / 81.0, 4 / 81.0, 4 / 27.0, 4 / 9.0, 4 / 3.0},
     10},
    {{3, 1, 1, 1, 1},
     {1, 0, 0, 0, 0},
     {1 / 16.0, 3 / 16.0, 3 / 8.0, 3 / 4.0, 3 / 2.0},
     10},
    {{0.5, 1, 1, 1, 1}, {1, 0, 0, 0, 0}, {-1 / 3.0, 0, 0, 0, 2 / 3.0}, 4},
    {{1, 1, 1, 1, 2}, {1, 0, 0, 0, 0}, {-1 / 3.0, 0, 0, 0, 2 / 3.0}, 7},
};

TEST(test_cradle, "Newton's cradle")
{
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        for (size_t k = 0; k < sizeof cradle / sizeof cradle[0]; ++k)
            for (int touching = 0; touching < 2; ++touching) {
                for (size_t i = 0; i <= 6; ++i) {
                    body[i] = (struct bonkers_body){(double)i, 0, 0, 0};
                    radius[i] = i > 0 && i < 6 ? 0.5 : 0;
                }
                for (size_t i = 0; i < 5; ++i) {
                    body[i + 1].v = cradle[k].v[i];
                    body[i + 1].im = 1 / cradle[k].mass[i];
                }
                body[0].x = -INFINITY;
                body[6].x = INFINITY;
                MADE(bonkers, b, begin(&b, 5, 1, e, touching));
                UNIT_TRUE(bonkers_run(&b, INFINITY, UINT64_MAX) ==
                          BONKERS_STILL);
                UNIT_EQUAL(b.collisions, cradle[k].collisions);
                /* 10 collisions, 4 roundings of a number up to 2 each */
                for (size_t i = 0; i < 5; ++i)
                    UNIT_NEAR(b.body[i + 1].v, cradle[k].after[i],
                              40 * DBL_EPSILON);
                UNIT_TRUE(b.body[0].x == -INFINITY &&
                          b.body[6].x == INFINITY);
            }
}

/* Galperin: the digits of pi, and other ratios, by every engine. */
TEST(test_galperin, "Galperin's counts")
{
    static const struct {
        double ratio, count;
    } runs[] = {{1, 3},    {100, 31},   {1e4, 314},  {1e6, 3141},
                {2, 5},    {3, 5},      {10, 10},    {16, 12},
                {256, 50}, {4096, 201}, {65536, 804}};
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        for (size_t k = 0; k < sizeof runs / sizeof runs[0]; ++k) {
            FREED(bonkers) b;
            size_t wrong = 0;
            MADE(start, s,
                 start_fill(
                     &s, &(struct start_request){.kind = START_GALPERIN,
                                                 .ratio = runs[k].ratio}));
            UNIT_TRUE(bonkers_begin(&b, &s, 1, e, &wrong));
            UNIT_EQUAL(wrong, 3);
            UNIT_TRUE(bonkers_run(&b, INFINITY, UINT64_MAX) ==
                      BONKERS_STILL);
            UNIT_EQUAL(b.collisions, runs[k].count);
        }
}

/* A million collisions of eight bodies. Rounding is a random walk, 0.3 eps
   sqrt(n) = 7e-14 of standard deviation, and a bias of about 5e-4 eps n =
   1e-13 for these masses: 1e-12 is more than ten of either, and a
   hundredth of the drift of a biased collision, 1e-10. */
TEST(test_energy, "a million collisions keep the energy")
{
    FREED(start) s;
    size_t wrong;
    start_fill(&s, &(struct start_request){.kind = START_MIXED});
    MADE(bonkers, b, bonkers_begin(&b, &s, 1, BONKERS_AUTO, &wrong));
    const double before = bonkers_energy(&b);
    UNIT_NEAR(before, 90.84, 0.01);
    UNIT_TRUE(bonkers_run(&b, INFINITY, 1000000) == BONKERS_COLLISIONS);
    UNIT_NEAR(bonkers_energy(&b) / before, 1, 1e-12);
    UNIT_TRUE(bonkers_energy(&b) != before);
}

/* A ball at rest between a wall and one that comes in, of equal masses. */
static enum bonkers_stop collapse(struct bonkers *b, double e,
                                  enum bonkers_engine engine)
{
    memset(body, 0, 4 * sizeof body[0]);
    body[1] = (struct bonkers_body){1, 0, 0, 1};
    body[2] = (struct bonkers_body){2, -1, 0, 1};
    body[3].x = INFINITY;
    begin(b, 2, e, engine, false);
    return bonkers_run(b, INFINITY, UINT64_MAX);
}

/* Below 3 - 2 sqrt 2 = 0.1716 there is no end. Above it the count of
   collisions is 31 at 0.174 and 9 at 0.2, by exact fractions. */
TEST(test_collapse, "two balls and a wall collapse below 0.1716")
{
    static const double without_end[] = {0,     0.001, 0.05, 0.1,
                                         0.168, 0.17,  0.171};
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        FREED(bonkers) b;
        for (int k = 0; k < 7; ++k) {
            UNIT_TRUE(collapse(&b, without_end[k], e) == BONKERS_COLLAPSE);
            UNIT_TRUE(isfinite(b.now) && b.collisions < 1000);
            bonkers_free(&b);
        }
        UNIT_TRUE(collapse(&b, 0.174, e) == BONKERS_STILL);
        UNIT_EQUAL(b.collisions, 31);
        bonkers_free(&b);
        UNIT_TRUE(collapse(&b, 0.2, e) == BONKERS_STILL);
        UNIT_EQUAL(b.collisions, 9);
    }
}

/* After a collapse the clock stands, however often one asks. */
TEST(test_after_a_collapse, "a collapse lasts")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e) {
        MADE(bonkers, b, collapse(&b, 0.1, e));
        const double now = b.now;
        for (int k = 1; k < 4; ++k)
            UNIT_TRUE(bonkers_run(&b, now + 10 * k, UINT64_MAX) ==
                      BONKERS_COLLAPSE);
        UNIT_EQUAL(b.now, now);
    }
}

TEST(test_collapse_in_company, "a collapse is seen among a thousand")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e) {
        enum { OTHERS = 998 };
        memset(body, 0, (OTHERS + 4) * sizeof body[0]);
        body[1] = (struct bonkers_body){1, 0, 0, 1};
        body[2] = (struct bonkers_body){2, -1, 0, 1};
        for (size_t i = 3; i <= OTHERS + 2; ++i)
            body[i] = (struct bonkers_body){(double)i + 10, 0, 0, 1};
        body[OTHERS + 3].x = OTHERS + 20;
        MADE(bonkers, b, begin(&b, OTHERS + 2, 0.168, e, false));
        UNIT_TRUE(bonkers_run(&b, 1000, UINT64_MAX) == BONKERS_COLLAPSE);
    }
}

/* A row of touching bodies that loses energy has many collisions at one
   time, some between the same two, and no collapse. */
TEST(test_row_is_no_collapse, "a struck row is no collapse")
{
    for (enum bonkers_engine e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e) {
        fill_row(40, false);
        body[0].x = -INFINITY;
        body[41].x = INFINITY;
        body[1].v = 1;

        MADE(bonkers, b, begin(&b, 40, 0.99, e, true));
        UNIT_TRUE(bonkers_run(&b, INFINITY, UINT64_MAX) == BONKERS_STILL);
        UNIT_TRUE(b.collisions > 38);
    }
}

TEST(test_sticking, "sticking bodies move as one")
{
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        for (size_t i = 0; i <= 3; ++i)
            body[i] = (struct bonkers_body){(double)i, 0, 0, 1 / 3.0};
        body[0] = (struct bonkers_body){-INFINITY, 0, 0, 0};
        body[3] = (struct bonkers_body){INFINITY, 0, 0, 0};
        body[1].v = 1;
        MADE(bonkers, b, begin(&b, 2, 0, e, false));
        UNIT_TRUE(bonkers_run(&b, INFINITY, UINT64_MAX) == BONKERS_STILL);
        UNIT_NEAR(b.body[1].v, 0.5, 2 * DBL_EPSILON);
        UNIT_NEAR(b.body[2].v, 0.5, 2 * DBL_EPSILON);
    }
}

TEST(test_start, "starts are checked")
{
    MADE(bonkers, b, bonkers_create(&b, 3, 1, BONKERS_AUTO));
    static const struct {
        double x[5], radius;
        size_t wrong;
    } starts[] = {
        {{0, 1, 2, 3, 4}, 0, 4},
        {{0, 1, 1, 1, 4}, 0, 4},
        {{0, 1, 0.5, 3, 4}, 0, 1},
        {{0, -1, 2, 3, 4}, 0, 0},
        {{0, 1, 2, 5, 4}, 0, 3},
        {{0, 1, 2, 3, 4}, 0.5, 4},
        {{0, 1, 2, 3, 4}, 0.6, 1},
        {{0, 0.4, 2, 3, 4}, 0.5, 0},
        {{0, 1, 2, 3.6, 4}, 0.5, 3},
        {{0, NAN, 2, 3, 4}, 0, 0},
        {{0, 1, 2, NAN, 4}, 0, 2},
        {{0, 0, 0, 0, 0}, 0, 4},
        {{0, 1, 2, INFINITY, INFINITY}, 0, 3},
    };
    for (size_t k = 0; k < sizeof starts / sizeof starts[0]; ++k) {
        double a[5] = {0};
        for (size_t i = 0; i < 5; ++i) {
            b.body[i] = (struct bonkers_body){starts[k].x[i], 0, 0,
                                              i > 0 && i < 4 ? 1 : 0};
            a[i] = i > 0 && i < 4 ? starts[k].radius : 0;
        }
        free(b.shift);
        b.shift = malloc(5 * sizeof *b.shift);
        UNIT_EQUAL(bonkers_start(&b, a), starts[k].wrong);
    }
    bonkers_free(&b);
    /* tenths do not add up, but touch: 0.1 + 0.2 is not 0.3 */
    fill_row(30, false);
    for (size_t i = 1; i <= 30; ++i) {
        body[i].x = 0.2 * (double)i - 0.1;
        radius[i] = 0.1;
    }
    body[31].x = 0.2 * 30;
    begin(&b, 30, 1, BONKERS_AUTO, true);
    UNIT_TRUE(bonkers_run(&b, 10, UINT64_MAX) == BONKERS_TIME);
    UNIT_EQUAL(b.collisions, 0);
}

/* The scan for a few movers, slabs for more. */
TEST(test_auto, "the engine chosen")
{
    struct bonkers b;
    bonkers_create(&b, BONKERS_SCANNED, 1, BONKERS_AUTO);
    UNIT_TRUE(b.engine == BONKERS_SCAN);
    bonkers_free(&b);
    bonkers_create(&b, BONKERS_SCANNED + 1, 1, BONKERS_AUTO);
    UNIT_TRUE(b.engine == BONKERS_SLAB);
    bonkers_free(&b);
    bonkers_free(&b); /* twice is harmless */
    UNIT_SAYS(bonkers_engine_names[BONKERS_SLAB], "slab");
    UNIT_TRUE(bonkers_engine_names[BONKERS_ENGINES] == NULL);
}

TEST(test_exact_end, "a collision exactly at the end takes place")
{
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e) {
        double x[4], v[4];
        memset(body, 0, 4 * sizeof body[0]);
        body[1] = (struct bonkers_body){1, 1, 0, 1};
        body[2] = (struct bonkers_body){3, -1, 0, 1};
        body[3].x = 4;
        MADE(bonkers, b, begin(&b, 2, 1, e, false));
        bonkers_run(&b, 1, UINT64_MAX);
        UNIT_EQUAL(b.collisions, 1);
        bonkers_free(&b);
        begin(&b, 2, 1, e, false);
        bonkers_run(&b, nextafter(1, 0), UINT64_MAX);
        UNIT_EQUAL(b.collisions, 0);
        UNIT_TRUE(bonkers_run(&b, 1, UINT64_MAX) == BONKERS_TIME);
        UNIT_EQUAL(b.collisions, 1);
        bonkers_state(&b, x, v);
        UNIT_TRUE(x[1] == 2 && x[2] == 2 && v[1] == -1 && v[2] == 1);
        UNIT_EQUAL(b.now, 1);
        UNIT_EQUAL(bonkers_energy(&b), 1);
    }
}

TEST(test_settle, "a settled run goes on")
{
    for (enum bonkers_engine e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        for (int rods = 0; rods < 2; ++rods) {
            fill_random(20, 77, rods);
            MADE(bonkers, a, begin(&a, 20, 1, e, rods));
            MADE(bonkers, b, begin(&b, 20, 1, e, rods));
            bonkers_run(&a, 5, UINT64_MAX);
            bonkers_run(&b, 5, UINT64_MAX);
            bonkers_settle(&b);
            UNIT_TRUE(b.now == 0 && b.collisions == 0);
            UNIT_EQUAL(bonkers_start(&b, rods ? radius : NULL), 21);
            differs(&a, &b);
            double worst = 0;
            for (size_t i = 0; i <= 21; ++i)
                worst = fmax(worst, fabs(state[0][0][i] - state[1][0][i]));
            UNIT_NEAR(worst, 0, 4 * DBL_EPSILON * body[21].x);
            bonkers_run(&a, 10, UINT64_MAX);
            bonkers_run(&b, 5, UINT64_MAX);
            differs(&a, &b);
            for (size_t i = 0; i <= 21; ++i)
                worst = fmax(worst, fabs(state[0][0][i] - state[1][0][i]));
            /* about 200 collisions; see test_naive_agrees */
            UNIT_NEAR(worst, 0,
                      24 * 400 * DBL_EPSILON *
                          (body[21].x + 2 * sqrt(20) * 10));
        }
}

/* Bodies put into the wrong order by hand, far apart and by a last bit:
   the report has them in order, and counts only what is no rounding. */
TEST(test_disorder, "what is out of order is put right and counted")
{
    double x[5], v[5];
    CREATED(bonkers, b, 3, 1, BONKERS_SCAN);
    b.body[4].x = 4;
    for (int i = 1; i <= 3; ++i)
        b.body[i] = (struct bonkers_body){i, 0, 0, 1};
    UNIT_EQUAL(bonkers_start(&b, NULL), 4);
    b.body[2].x = 1 - DBL_EPSILON / 2;
    bonkers_state(&b, x, v);
    UNIT_EQUAL(b.disorder, 0);
    UNIT_EQUAL(x[2], 1);
    b.body[2].x = 0.5;
    b.body[3].x = 4 + 8 * DBL_EPSILON;
    bonkers_state(&b, x, v);
    UNIT_EQUAL(b.disorder, 1);
    UNIT_LIST(x + 2, 0, 1, 4);
    UNIT_EQUAL(b.body[2].x, 0.5); /* the run is not touched */
}

/* ---- under gravity */

static const double g = 9.81;

/* Points of these heights and velocities over a floor at 0, with masses 1
   and no roof. */
static void fall(struct bonkers *b, size_t movers, const double x[],
                 const double v[], double restitution,
                 enum bonkers_engine engine)
{
    UNIT_TRUE(bonkers_create(b, movers, restitution, engine));
    b->gravity = g;
    for (size_t i = 0; i < movers; ++i)
        b->body[i + 1] = (struct bonkers_body){x[i], v[i], 0, 1};
    b->body[movers + 1].x = INFINITY;
    UNIT_EQUAL(bonkers_start(b, NULL), (double)movers + 1);
}

/* The height at time t of an elastic ball thrown from x with velocity v. */
static double thrown(double x, double v, double t)
{
    const double s = sqrt(v * v + 2 * g * x);
    const double phase = fmod((s - v) / g + t, 2 * s / g);
    return phase * (s - g * phase / 2);
}

TEST(test_bouncing_ball, "a bouncing ball")
{
    const double x = 1, v = 0.3, s = sqrt(v * v + 2 * g * x);
    MADE(bonkers, b, fall(&b, 1, &x, &v, 1, BONKERS_AUTO));
    const double energy = bonkers_energy(&b);
    UNIT_NEAR(energy, 0.3 * 0.3 / 2 + g, 4e-15);
    for (int n = 1; n <= 10000; ++n) {
        const double t = (v + s) / g + (n - 1) * (2 * s / g);
        UNIT_TRUE(bonkers_run(&b, INFINITY, (uint64_t)n) ==
                  BONKERS_COLLISIONS);
        /* each bounce rounds the clock by half an epsilon */
        if (n == 1 || n % 1000 == 0)
            UNIT_NEAR(b.now, t, DBL_EPSILON * t * (4 + n / 2.0));
        if (n == 1 || n % 1000 == 0)
            UNIT_EQUAL(b.body[1].x, 0);
    }
    UNIT_NEAR(bonkers_energy(&b), energy, 4 * DBL_EPSILON * energy);
}

TEST(test_roof, "a roof, and one out of reach")
{
    struct bonkers b;
    const double x = 0, v = 6; /* 1.83 m high */
    for (int low = 0; low < 2; ++low) {
        const double roof = low ? 1.5 : 2;
        const double up = 2 * roof / (v + sqrt(v * v - 2 * g * roof));
        fall(&b, 1, &x, &v, 1, BONKERS_SCAN);
        b.body[2].x = roof;
        bonkers_start(&b, NULL);
        bonkers_run(&b, INFINITY, 1001);
        const double t = low ? 1001 * up : 1001 * 2 * v / g;
        UNIT_NEAR(b.now, t, 1e-12 * t);
        UNIT_EQUAL(b.body[1].x, low ? 1.5 : 0);
        bonkers_free(&b);
    }
}

/* Ten equal beads are bouncing balls that pass through each other. */
TEST(test_sorted_balls, "equal beads that fall are sorted balls")
{
    SEEDED(r, 1);
    double x[10], v[10], got[12], u[12], worst = 0;
    for (int i = 0; i < 10; ++i) {
        x[i] = 0.1 + 0.2 * i;
        v[i] = random_between(&r, -2, 2);
    }
    MADE(bonkers, b, fall(&b, 10, x, v, 1, BONKERS_HEAP));
    for (int k = 1; k <= 60; ++k) {
        double expected[10];
        bonkers_run(&b, 2.0 * k, UINT64_MAX);
        bonkers_state(&b, got, u);
        for (int i = 0; i < 10; ++i)
            expected[i] = thrown(x[i], v[i], 2.0 * k);
        qsort(expected, 10, sizeof expected[0], unit_rising);
        for (int i = 0; i < 10; ++i)
            worst = fmax(worst, fabs(got[i + 1] - expected[i]));
    }
    UNIT_TRUE(b.collisions > 10000 && b.disorder == 0);
    UNIT_NEAR(worst, 0, 1e-11); /* some 1e-12; 1e-10 without [[late]] */
}

/* Bodies of masses from 1 to 9 over a floor; each height is drawn. */
static void begin_fall(struct bonkers *b, enum bonkers_engine engine,
                       double restitution)
{
    SEEDED(r, 7);
    UNIT_TRUE(bonkers_create(b, 9, restitution, engine));
    b->gravity = g;
    for (int i = 1; i <= 9; ++i)
        b->body[i] = (struct bonkers_body){
            0.2 * i + random_between(&r, 0, 0.1), 0, 0, 1.0 / i};
    b->body[10].x = 4;
    bonkers_start(b, NULL);
}

static void same(struct bonkers *a, struct bonkers *b)
{
    const char *what = differs(a, b);
    if (what)
        printf("# %s\n", what);
    UNIT_TRUE(!what);
}

/* Bodies of drawn masses over a floor, or equal ones from heights that
   are alike, for which many gaps close at one time. */
static void begin_column(struct bonkers *b, enum bonkers_engine engine,
                         int movers, double restitution, bool alike)
{
    SEEDED(r, 3);
    UNIT_TRUE(bonkers_create(b, (size_t)movers, restitution, engine));
    b->gravity = 8;
    for (int i = 1; i <= movers; ++i)
        b->body[i] = alike ? (struct bonkers_body){0.5 * i, 0, 0, 1}
                           : (struct bonkers_body){
                                 0.3 * i + random_between(&r, 0, 0.2),
                                 random_between(&r, -1, 1), 0,
                                 1 / random_between(&r, 1, 10)};
    b->body[movers + 1].x = INFINITY;
    bonkers_start(b, NULL);
}

/* Long columns, and short ones that come to rest; the slab in pieces. */
TEST(test_falling_slab, "and the slab, in columns that come to rest")
{
    static const double restitutions[] = {1, 0.999, 0.9, 0.4, 0};
    static const int movers[] = {1, 2, 3, 40, 3000};
    for (int k = 0; k < 50; ++k) {
        struct bonkers b[3];
        const int n = movers[k / 10];
        const enum bonkers_engine engine[] = {BONKERS_SCAN, BONKERS_HEAP,
                                              BONKERS_SLAB};
        const double end = n > 40 ? 0.5 : 4;
        for (int i = 0; i < 3; ++i) {
            begin_column(&b[i], engine[i], n, restitutions[k / 2 % 5],
                         k % 2);
            const int pieces = i < 2 ? 1 : 20;
            enum bonkers_stop stop = BONKERS_TIME;
            for (int j = 1; j <= pieces && stop == BONKERS_TIME; ++j)
                stop = bonkers_run(&b[i], end * j / pieces, 20000);
        }
        same(&b[0], &b[1]);
        same(&b[0], &b[2]);
        UNIT_TRUE(b[2].engine == BONKERS_SLAB);
        for (int i = 0; i < 3; ++i)
            bonkers_free(&b[i]);
    }
}

TEST(test_falling_engines, "scan and heap fall alike, the naive nearly")
{
    for (int k = 0; k < 2; ++k) {
        FREED(bonkers) naive;
        double x[2][11], v[2][11], worst = 0;
        MADE(bonkers, scan, begin_fall(&scan, BONKERS_SCAN, k ? 0.99 : 1));
        MADE(bonkers, heap, begin_fall(&heap, BONKERS_HEAP, k ? 0.99 : 1));
        MADE(bonkers, slab, begin_fall(&slab, BONKERS_SLAB, k ? 0.99 : 1));
        begin_fall(&naive, BONKERS_NAIVE, k ? 0.99 : 1);
        for (int n = 1; n <= 30; ++n) /* cut in pieces */
            bonkers_run(&scan, n / 10.0, UINT64_MAX);
        bonkers_run(&heap, 3, UINT64_MAX);
        bonkers_run(&naive, 0.5, UINT64_MAX);
        bonkers_run(&slab, 0.5, UINT64_MAX);
        UNIT_TRUE(heap.collisions > 100);
        same(&scan, &heap);
        bonkers_state(&naive, x[0], v[0]);
        bonkers_state(&slab, x[1], v[1]);
        for (int i = 0; i <= 10; ++i)
            worst = fmax(worst, fabs(x[0][i] - x[1][i]));
        UNIT_NEAR(worst, 0, 1e-11);
        bonkers_settle(&slab);
        bonkers_start(&slab, NULL);
        bonkers_run(&slab, 1, UINT64_MAX);
        bonkers_run(&naive, 1.5, UINT64_MAX);
        bonkers_state(&naive, x[0], v[0]);
        bonkers_state(&slab, x[1], v[1]);
        for (int i = 0; i <= 10; ++i)
            worst = fmax(worst, fabs(v[0][i] - v[1][i]));
        UNIT_NEAR(worst, 0, 1e-7);
    }
}

/* With M_j the mass above gap j, the law of equal shares says that the mean
   of m v^2/2 is E/(3N) for every body, and that of M_j g times the gap
   2E/(3N). Blocks of 500 s are independent. */
TEST(test_upright_shares, "upright, all bodies have equal shares")
{
    enum { BLOCKS = 40, ROWS = 1000 };
    static double mean[18][BLOCKS];
    double x[11], v[11];
    MADE(bonkers, b, begin_fall(&b, BONKERS_AUTO, 1));
    b.body[10].x = INFINITY;
    bonkers_start(&b, NULL);
    const double energy = bonkers_energy(&b);
    for (int k = 0; k < BLOCKS * ROWS; ++k) {
        double above = 45;
        bonkers_run(&b, 0.5 * (k + 1), UINT64_MAX);
        bonkers_state(&b, x, v);
        for (int i = 1; i <= 9; ++i) {
            mean[i - 1][k / ROWS] += i * v[i] * v[i] / 2 / ROWS;
            mean[i + 8][k / ROWS] += above * g * (x[i] - x[i - 1]) / ROWS;
            above -= i;
        }
    }
    for (int what = 0; what < 18; ++what) {
        double sum = 0, square = 0;
        for (int k = 0; k < BLOCKS; ++k) {
            sum += mean[what][k] / BLOCKS;
            square += mean[what][k] * mean[what][k] / BLOCKS;
        }
        const double error = sqrt((square - sum * sum) / (BLOCKS - 1));
        const double share = energy / 27 * (what < 9 ? 1 : 2);
        UNIT_TRUE(error < 0.02 * share);
        UNIT_NEAR(sum, share, 4 * error);
    }
    /* whole masses have exact halves to round: section sec:coin */
    UNIT_NEAR(bonkers_energy(&b) / energy, 1, 1e-11);
}

TEST(test_pile, "what lies on the floor is part of it")
{
    const double x[] = {0, 0, 1}, v[] = {0, 0, 0};
    double got[5], u[5];
    MADE(bonkers, b, fall(&b, 2, x, v, 1, BONKERS_SCAN));
    UNIT_TRUE(bonkers_is_still(&b));
    UNIT_TRUE(bonkers_run(&b, INFINITY, 10) == BONKERS_STILL);
    bonkers_free(&b);
    fall(&b, 3, x, v, 1, BONKERS_SCAN);
    UNIT_TRUE(!bonkers_is_still(&b));
    bonkers_run(&b, 100, UINT64_MAX);
    bonkers_state(&b, got, u);
    UNIT_LIST(got + 1, 0, 0, 0);
    UNIT_NEAR(got[3], thrown(1, 0, 100), 1e-12);
    UNIT_TRUE(b.collisions > 5 * 100);
}

/* Two that stick in the air, at the moment in which they neither rise nor
   fall, are not on the floor yet. */
TEST(test_no_rest_in_the_air, "and what stands still in the air is not")
{
    const double x[] = {1, 2}, v[] = {5, 3};
    double got[4], u[4];
    MADE(bonkers, b, fall(&b, 2, x, v, 0, BONKERS_SCAN));
    b.gravity = 8;
    bonkers_start(&b, NULL);
    UNIT_TRUE(bonkers_run(&b, 1, UINT64_MAX) == BONKERS_TIME);
    bonkers_state(&b, got, u);
    for (int i = 1; i <= 2; ++i) {
        UNIT_EQUAL(got[i], 1.5);
        UNIT_EQUAL(u[i], -4);
    }
}

/* 3 kg on the floor, and 1 kg that falls on them: twice they are hit, come
   down, and what is left of their velocity is nothing or a rounding, too
   little for the clock. Returns of how many heights they still fly a moment
   later; a longer one has some ten millions of hops. */
static int count_fliers(double restitution, enum bonkers_engine engine)
{
    int fly = 0;
    for (int k = 1; k <= 20; ++k) {
        const double x[] = {0, 0.1 * k}, v[] = {0, 0};
        MADE(bonkers, b, fall(&b, 2, x, v, restitution, engine));
        b.body[1].im = 1.0 / 3;
        bonkers_run(&b, 2.005 * sqrt(2 * x[1] / g), UINT64_MAX);
        UNIT_NEAR(b.body[1].v, 0, 1e-7);
        fly += b.body[1].v != 0;
    }
    return fly;
}

TEST(test_no_rest_without_loss, "nor does an elastic body come to rest")
{
    static const enum bonkers_engine engine[] = {BONKERS_SCAN,
                                                 BONKERS_HEAP};
    for (int e = 0; e < 2; ++e) {
        UNIT_EQUAL(count_fliers(1 - 0x1p-52, engine[e]), 0);
        UNIT_TRUE(count_fliers(1, engine[e]) > 0);
    }
}

TEST(test_free_fall, "without a floor weight changes nothing")
{
    FREED(bonkers) b, c;
    double x[2][8], v[2][8];
    for (int k = 0; k < 2; ++k) {
        struct bonkers *which = k ? &c : &b;
        UNIT_TRUE(bonkers_create(which, 6, 1, BONKERS_SCAN));
        which->gravity = k ? 2 : 0;
        for (int i = 1; i <= 6; ++i)
            which->body[i] =
                (struct bonkers_body){i, (i * 5 % 7) - 3.0, 0, 1.0 / i};
        which->body[0].x = -INFINITY;
        which->body[7].x = INFINITY;
        bonkers_start(which, NULL);
        UNIT_TRUE(bonkers_run(which, 8, UINT64_MAX) == BONKERS_TIME);
        bonkers_state(which, x[k], v[k]);
    }
    UNIT_EQUAL(b.collisions, c.collisions);
    UNIT_TRUE(b.collisions > 5);
    for (int i = 1; i <= 6; ++i) {
        UNIT_NEAR(x[1][i], x[0][i] - 64, 1e-12);
        UNIT_NEAR(v[1][i], v[0][i] - 16, 1e-12);
    }
}

/* When a gap closes, as the chapter has it. */
static double closing_time(const struct bonkers_body *a)
{
    const struct bonkers_body *b = a + 1;
    const double t = a->since > b->since ? a->since : b->since;
    const double gap =
        b->x + b->v * (t - b->since) - (a->x + a->v * (t - a->since));
    if (!(a->v > b->v))
        return INFINITY;
    return gap > 0 ? t + gap / (a->v - b->v) : t;
}

/* What engines compute in their own way has the bits of the chapters: the
   velocities those of collide, and all times those of above. */
TEST(test_own_ways, "they are the bits of the chapters")
{
    static const enum bonkers_engine all[] = {BONKERS_SCAN, BONKERS_HEAP,
                                              BONKERS_SLAB};
    for (uint64_t seed = 0; seed < 60; ++seed) {
        const double restitution = seed % 2 ? 0.7 : 1;
        FREED(bonkers) b;
        fill_random(9, 700 + seed, seed % 4 < 2);
        for (size_t k = 3; k < 9; k += 2) /* bursts, and gaps below zero */
            body[k].im *= seed % 5 ? 1e-6 : 1;
        begin(&b, 9, restitution, all[seed % 3], seed % 4 < 2);
        bool same = true;
        for (uint64_t n = 1; same && n <= 2000; ++n) {
            const size_t i = schedule_scan(b.due, b.gaps);
            double v = b.body[i].v, w = b.body[i + 1].v;
            collide(&v, &w, b.body[i].im, b.body[i + 1].im, restitution);
            if (bonkers_run(&b, INFINITY, n) != BONKERS_COLLISIONS)
                break;
            same = v == b.body[i].v && w == b.body[i + 1].v;
            for (size_t k = 0; k < b.gaps; ++k)
                same = same && b.due[k] == closing_time(&b.body[k]);
        }
        UNIT_TRUE(same);
    }
}
