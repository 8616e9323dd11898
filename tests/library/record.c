/* Two bodies that pass; runs whose rows end in the middle of a step; and
   what watched runs find, pair by pair. */
#include "library/plans.h"
#include "scenes/pair.h"
#include "enough/record.h"
#include "toolbox/random.h"
#include "unit.h"

#include <stdlib.h>

static struct record_order order(const struct scene *s, const char *text,
                                 double until, size_t rows)
{
    return (struct record_order){.scene = s,
                                 .plan = plan(text),
                                 .every = until / (double)rows,
                                 .rows = rows,
                                 .limit = INFINITY};
}

static struct record recorded(struct record_view *v,
                              const struct record_order *o)
{
    struct record r;
    UNIT_TRUE(record_run(&r, v, o));
    UNIT_TRUE(r.end == MODELS_DONE && r.reached == o->rows);
    return r;
}

/* A body at (3, 4) that flies with (-2, 0) passes the origin in 1.5 units
   of time, at 4. */
static void test_pair(void)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 2));
    s.position[1] = 3;
    s.position[3] = 4;
    UNIT_TRUE(!pair_passes(&(struct pair){.r2 = 25}, 1));
    s.velocity[1] = -2;
    const struct pair before = pair_of(&s, 0, 1);
    UNIT_EQUAL(before.r2, 25);
    UNIT_EQUAL(before.rv, -6);
    UNIT_TRUE(pair_passes(&before, 1.5) && !pair_passes(&before, 1.4999));
    UNIT_EQUAL(pair_nearest2(&before), 16);
    s.position[1] = -1;
    s.velocity[3] = 0.25;
    const struct pair after = pair_of(&s, 0, 1);
    const struct pair way = pair_way(&before, &after);
    UNIT_EQUAL(pair_nearest2(&way), 16);
    UNIT_EQUAL(way.rv / way.v2, -0.75);
    UNIT_EQUAL(pair_changed(&before, &after), 0.25);
    s.position[3] = s.velocity[3] = 0;
    const struct pair straight = pair_of(&s, 0, 1);
    UNIT_EQUAL(pair_nearest2(&straight), 0);
    scene_free(&s);
}

/* A ball that falls on a held one from 1.25 m, as in the misleading scene
   row-end. */
static struct scene falling(void)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 2));
    s.position[2] = 1.45;
    s.radius[0] = s.radius[1] = 0.1;
    s.freedom[1] = s.freedom[3] = s.freedom[5] = 0;
    s.gravity[1] = -10;
    s.contact = true;
    return s;
}

/* Leapfrog follows a parabola exactly, with whole steps and with halves:
   all rows are those of the parabola, but for some hundred roundings. */
static void test_parabola(void)
{
    struct scene s = falling();
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 0.48));
    struct record_order o = order(&s, "leapfrog:7", 0.48, 16);
    o.halfway = true;
    struct record r = recorded(&v, &o);
    for (size_t k = 0; k <= 16; ++k) {
        const double t = 0.03 * (double)k;
        UNIT_NEAR(r.value[k * v.columns + 1], 1.45 - 5 * t * t, 1e-13);
        UNIT_NEAR(r.value[k * v.columns + 4], -10 * t, 1e-13);
    }
    /* half a step, 16 * 7 - 1 whole ones, and a half for each row; a run
       of k steps asks for forces k + 1 times */
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 2 + 16 * 7 + 16 * 2);
    UNIT_EQUAL(r.cost, models_cost(r.work));
    record_free(&r);
    record_look_away(&v);
    scene_free(&s);
}

/* A contact just before a row's end is equally late with 128 and with 641
   steps; halfway it is found half a step earlier or later, and what leaves
   is faster by twice g times that, so by g times the step. In other units
   it is the same. */
static void test_late(void)
{
    struct scene s = falling();
    struct record_view v;
    const double until = 1.0000625;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, until));
    const size_t last = 16 * v.columns + 4;
    struct record_order o = order(&s, "leapfrog:128", until, 16);
    struct record a = recorded(&v, &o);
    o.plan.steps = 641;
    struct record b = recorded(&v, &o);
    UNIT_TRUE(record_apart(&v, &a, &b, 1, 16) < 1e-11);
    o.halfway = true;
    struct record c = recorded(&v, &o);
    UNIT_NEAR(c.value[last] - b.value[last], 10 * until / 16 / 641, 1e-11);
    UNIT_TRUE(record_apart(&v, &b, &c, 1, 7) < 1e-11);
    o.converted = true;
    struct record d = recorded(&v, &o);
    UNIT_TRUE(record_apart(&v, &c, &d, 1, 16) < 1e-11);
    record_free(&a);
    record_free(&b);
    record_free(&c);
    record_free(&d);
    record_look_away(&v);
    scene_free(&s);
}

/* The time and the collisions of a row that is looked at aside, in a scene
   that begins at 3. Two roundings of times below 4 and some of times below
   1 are 7e-16. */
static void test_asked(void)
{
    struct scene s = falling();
    struct record_view v;
    struct observables asked;
    char message[OBSERVABLES_MESSAGE];
    s.time = 3;
    UNIT_TRUE(observables_read(&asked, "t,collisions", 2, message));
    UNIT_TRUE(record_look(&v, "record", &s, &asked, 0.52));
    struct record_order o = order(&s, "leapfrog:1", 0.52, 26);
    o.halfway = true;
    struct record r = recorded(&v, &o);
    for (size_t k = 0; k <= 26; ++k) {
        UNIT_NEAR(r.value[k * v.columns], 3 + 0.02 * (double)k, 1e-15);
        UNIT_EQUAL(r.value[k * v.columns + 1], k >= 25);
    }
    record_free(&r);
    record_look_away(&v);
    scene_free(&s);
}

/* On an orbit halfway runs have the order of their method: an error four
   times as small in half the step, to the next order, 1/36 of it here. */
static void test_order(void)
{
    struct scene s = light_orbit(1, 1.1);
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 8));
    struct record_order o = order(&s, "kahan-li8:100", 8, 16);
    struct record truth = recorded(&v, &o);
    double error[2];
    o.halfway = true;
    for (size_t k = 0; k < 2; ++k) {
        o.plan = plan(k ? "leapfrog:12" : "leapfrog:6");
        struct record r = recorded(&v, &o);
        error[k] = record_apart(&v, &r, &truth, 1, 16);
        record_free(&r);
    }
    UNIT_NEAR(error[0] / error[1], 4, 0.15);
    record_free(&truth);
    record_look_away(&v);
    scene_free(&s);
}

/* Many balls that fly at random, so small that none of them overlaps
   another one at the end. */
static struct scene shots(size_t n, enum scene_wall walls)
{
    struct scene s;
    struct random random;
    random_seed(&random, 5);
    UNIT_TRUE(scene_create(&s, n));
    for (size_t k = 0; k < 2; ++k) {
        s.high[k] = 1;
        s.wall[k] = walls;
        for (size_t i = 0; i < n; ++i) {
            s.radius[i] = 2e-4;
            s.position[k * n + i] = random_uniform(&random);
            s.velocity[k * n + i] = random_between(&random, -0.4, 0.4);
        }
    }
    s.contact = true;
    return s;
}

/* How many pairs pass through each other in a unit of time, one by one. */
static uint64_t passing(const struct scene *s, bool images)
{
    uint64_t count = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = 0; j < i; ++j) {
            const struct pair p = pair_of(s, i, j);
            double r2 = 0, rv = 0;
            for (size_t k = 0; k < 3; ++k) {
                const double r =
                    p.r[k] - (images ? floor(p.r[k] + 0.5) : 0);
                r2 += r * r;
                rv += r * p.v[k];
            }
            count += rv < 0 && -rv < p.v2 && r2 - rv * rv / p.v2 < 1.6e-7;
        }
    return count;
}

/* What the sweep finds is what there is, in the open and across the sides
   of a box; it asks fewer pairs than there are, and that is no part of what
   the run costs. */
static void test_sweep(void)
{
    enum { BALLS = 600 };
    for (int periodic = 0; periodic < 2; ++periodic) {
        struct scene s =
            shots(BALLS, periodic ? SCENE_PERIODIC : SCENE_OPEN);
        struct record_view v;
        UNIT_TRUE(record_look(&v, "record", &s, NULL, 1));
        struct record_order o = order(&s, "leapfrog:1", 1, 1);
        struct record plain = recorded(&v, &o);
        o.watched = true;
        struct record r = recorded(&v, &o);
        const uint64_t count = passing(&s, periodic);
        UNIT_TRUE(count > 10);
        UNIT_EQUAL((double)r.missed, (double)count);
        UNIT_EQUAL(r.cost, plain.cost);
        UNIT_EQUAL(plain.watching, 0);
        UNIT_TRUE(r.watching > 1e-9 * BALLS * 19 &&
                  r.watching < 1e-9 * BALLS * BALLS / 2 * 4.5);
        record_free(&plain);
        record_free(&r);
        record_look_away(&v);
        scene_free(&s);
    }
}

/* What watching costs counts against the limit. */
static void test_limit(void)
{
    struct scene s = shots(100, SCENE_OPEN);
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 1));
    struct record_order o = order(&s, "leapfrog:4", 1, 16);
    o.watched = true;
    struct record r = recorded(&v, &o);
    UNIT_TRUE(r.watching > 0.2 * r.cost);
    o.limit = r.cost + r.watching / 2;
    record_free(&r);
    UNIT_TRUE(record_run(&r, &v, &o));
    UNIT_TRUE(r.end == MODELS_COSTLY && r.reached > 8 && r.reached < 16);
    record_free(&r);
    record_look_away(&v);
    scene_free(&s);
}

int main(void)
{
    return unit_run(
        "record",
        (struct unit_test[]){
            {"two bodies pass where straight lines say", test_pair},
            {"halfway through steps the rows are the same", test_parabola},
            {"a contact before a row's end is late by another half step",
             test_late},
            {"a row looked at aside has its time and collisions",
             test_asked},
            {"halfway runs keep their order", test_order},
            {"a sweep finds what was grazed, and counts its cost",
             test_sweep},
            {"watching counts against the limit", test_limit},
            {0}});
}
