/* Two bodies that pass; the rows of a run; and the same from elsewhere: in
   other units, with other last bits, seen from the other side. */
#include "library/plans.h"
#include "scenes/pair.h"
#include "enough/record.h"
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
    record_run(&r, v, o);
    UNIT_TRUE(r.end == MODELS_DONE && r.reached == o->rows);
    return r;
}

/* A body at (3, 4) that flies with (-2, 0) passes the origin at 4, one that
   aims at it not at all. */
static void test_pair(void)
{
    struct pair p = {0};
    pair_add(&p, 3, -2);
    pair_add(&p, 4, 0);
    UNIT_EQUAL(p.r2, 25);
    UNIT_EQUAL(p.v2, 4);
    UNIT_EQUAL(p.rv, -6);
    UNIT_EQUAL(pair_nearest2(&p), 16);
    p = (struct pair){0};
    pair_add(&p, 3, -2);
    UNIT_EQUAL(pair_nearest2(&p), 0);
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

/* Leapfrog follows a parabola exactly: all rows are those of the parabola,
   but for some hundred roundings. A run of k steps asks for forces k + 1
   times. */
static void test_parabola(void)
{
    struct scene s = falling();
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 0.48));
    const struct record_order o = order(&s, "leapfrog:7", 0.48, 16);
    struct record r = recorded(&v, &o);
    for (size_t k = 0; k <= 16; ++k) {
        const double t = 0.03 * (double)k;
        UNIT_NEAR(r.value[k * v.columns + 1], 1.45 - 5 * t * t, 1e-13);
        UNIT_NEAR(r.value[k * v.columns + 4], -10 * t, 1e-13);
    }
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 1 + 16 * 7);
    UNIT_EQUAL(r.cost, models_cost(r.work));
    record_free(&r);
    record_look_away(&v);
    scene_free(&s);
}

/* The time and the collisions of each row, in a scene that begins at 3, but
   for the row at whose end they touch. Two roundings of times below 4 and
   some of times below 1 are 7e-16. */
static void test_asked(void)
{
    struct scene s = falling();
    struct record_view v;
    struct observables asked;
    char message[OBSERVABLES_MESSAGE];
    s.time = 3;
    UNIT_TRUE(observables_read(&asked, "t,collisions", 2, message));
    UNIT_TRUE(record_look(&v, "record", &s, &asked, 0.52));
    const struct record_order o = order(&s, "leapfrog:1", 0.52, 26);
    struct record r = recorded(&v, &o);
    for (size_t k = 0; k <= 26; ++k) {
        UNIT_NEAR(r.value[k * v.columns], 3 + 0.02 * (double)k, 1e-15);
        UNIT_TRUE(k == 25 || r.value[k * v.columns + 1] == (k > 25));
    }
    record_free(&r);
    record_look_away(&v);
    scene_free(&s);
}

/* Everything that has a unit or a side: springs between bodies that are not
   alike, gravity, friction, weight, walls, and something held. */
static struct scene all_at_once(void)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 4));
    UNIT_TRUE(scene_add_kind(&s, 3, 0.2));
    UNIT_TRUE(scene_add_spring(&s, 0, 1, 0, 1.1));
    UNIT_TRUE(scene_add_spring(&s, 2, 1, 0, 0.4));
    for (size_t i = 0; i < 4; ++i) {
        s.mass[i] = 1 + (double)i;
        s.position[i] = 1 + (double)(i * i) / 3;
        s.position[4 + i] = i % 2 ? 0.7 : 0.1;
        s.velocity[i] = i == 3 ? -0.9 : 0.3;
        s.radius[i] = 0.05;
    }
    s.freedom[0] = s.freedom[4] = s.freedom[8] = 0;
    s.k2 = 0.3;
    s.softening = 0.2;
    s.damping = 0.01;
    s.gravity[1] = -0.5;
    s.contact = true;
    s.wall[1] = SCENE_HARD;
    s.high[1] = 2;
    s.wall[0] = SCENE_PERIODIC;
    s.low[0] = -1;
    s.high[0] = 5;
    return s;
}

/* In other units, and seen from the other side with the last body as the
   first, a run is the same but for rounding, and for some of it; places,
   velocities, the energy and what is counted. */
static void test_twins(void)
{
    static const char *const names[] = {NULL, "energy,x:1,vy:2,collisions"};
    struct scene s = all_at_once();
    for (size_t k = 0; k < 2; ++k) {
        struct observables asked;
        char message[OBSERVABLES_MESSAGE];
        struct record_view v;
        UNIT_TRUE(!names[k] ||
                  observables_read(&asked, names[k], 4, message));
        UNIT_TRUE(
            record_look(&v, "record", &s, names[k] ? &asked : NULL, 2));
        struct record_order o = order(&s, "leapfrog:64", 2, 16);
        struct record a = recorded(&v, &o);
        o.twin = true;
        struct record b = recorded(&v, &o);
        const double off = record_apart(&v, &a, &b, 0, 16);
        UNIT_TRUE(off > 0 && off < 1e-10);
        UNIT_EQUAL(b.cost, a.cost);
        record_free(&b);
        record_free(&a);
        record_look_away(&v);
    }
    scene_free(&s);
}

/* Sun and Earth, as two of one mass: the size is that of the box; leapfrog
   with 8 and 16 steps to a row errs by four times as much. */
static void test_apart(void)
{
    struct scene s = light_orbit(1, 1.1);
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 8));
    UNIT_EQUAL(v.scale, 1);
    struct record_order o = order(&s, "kepler", 8, 16);
    struct record truth = recorded(&v, &o);
    double error[2];
    for (size_t k = 0; k < 2; ++k) {
        o.plan = plan(k ? "leapfrog:16" : "leapfrog:8");
        struct record r = recorded(&v, &o);
        error[k] = record_apart(&v, &truth, &r, 1, 16);
        UNIT_EQUAL((double)record_agree(&v, &truth, &r, error[k]), 16);
        UNIT_TRUE(record_agree(&v, &truth, &r, error[k] / 100) < 16);
        record_free(&r);
    }
    UNIT_NEAR(error[0] / error[1], 4, 0.1);
    record_free(&truth);
    record_look_away(&v);
    scene_free(&s);
}

/* A limit on the cost ends a run early, and then it is infinitely far from
   all others. Two side by side have one limit, and part where they do. */
static void test_limit(void)
{
    struct scene s = light_orbit(1, 1.1);
    struct record_view v;
    UNIT_TRUE(record_look(&v, "record", &s, NULL, 8));
    struct record_order o = order(&s, "pefrl:16", 8, 16);
    struct record a = recorded(&v, &o), b, c;
    o.limit = a.cost / 2;
    record_run(&b, &v, &o);
    UNIT_TRUE(b.end == MODELS_COSTLY && b.reached < 16);
    UNIT_TRUE(isinf(record_apart(&v, &a, &b, 1, 16)));
    record_free(&b);
    struct record_order p = o;
    p.plan = plan("leapfrog:2");
    o.limit = 1.2 * a.cost;
    p.limit = INFINITY;
    record_both(&b, &c, &v, &o, &p, INFINITY);
    UNIT_TRUE(b.reached == 16 && c.reached == 16);
    const double off = record_apart(&v, &a, &c, 1, 16) / 3;
    record_free(&b);
    record_free(&c);
    record_both(&b, &c, &v, &o, &p, off);
    UNIT_TRUE(b.reached < 16 && b.reached == c.reached);
    UNIT_EQUAL((double)record_agree(&v, &b, &c, off),
               (double)b.reached - 1);
    record_free(&b);
    record_free(&c);
    p.plan = o.plan;
    record_both(&b, &c, &v, &o, &p, INFINITY);
    UNIT_TRUE(b.end == MODELS_COSTLY || c.end == MODELS_COSTLY);
    UNIT_TRUE(b.cost + c.cost < 1.4 * a.cost);
    record_free(&a);
    record_free(&b);
    record_free(&c);
    record_look_away(&v);
    scene_free(&s);
}

int main(void)
{
    return unit_run(
        "record",
        (struct unit_test[]){
            {"two bodies pass where straight lines say", test_pair},
            {"a parabola, row by row", test_parabola},
            {"rows have their time and collisions", test_asked},
            {"from elsewhere a run differs by rounding", test_twins},
            {"records are compared", test_apart},
            {"a run ends at its limit, and two at one", test_limit},
            {0}});
}
