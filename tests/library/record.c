/* Two bodies that pass; the rows of a run; and the same from elsewhere: in
   other units, with other last bits, seen from the other side. */
#include "library/plans.h"
#include "choosing/pair.h"
#include "choosing/record.h"
#include "unit.h"

static struct record_setup order(const struct scene *s, const char *text,
                                 double until, size_t rows)
{
    return (struct record_setup){.scene = s,
                                 .plan = plan(text),
                                 .every = until / (double)rows,
                                 .rows = rows,
                                 .limit = INFINITY};
}

static struct record recorded(struct record_view *v,
                              const struct record_setup *o)
{
    struct record r;
    record_run(&r, v, o);
    UNIT_TRUE(r.end == MODELS_DONE && r.reached == o->rows);
    return r;
}

/* A body at (3, 4) that flies with (-2, 0) passes the origin at 4, one that
   aims at it not at all. */
TEST(test_pair, "two bodies pass where straight lines say")
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
TEST(test_parabola, "a parabola, row by row")
{
    FREED(scene) s = falling();
    CREATED(record_view, v, "record", &s, NULL, 0.48);
    const struct record_setup o = order(&s, "leapfrog:7", 0.48, 16);
    FREED(record) r = recorded(&v, &o);
    for (size_t k = 0; k <= 16; ++k) {
        const double t = 0.03 * (double)k;
        UNIT_NEAR(r.value[k * v.columns + 1], 1.45 - 5 * t * t, 1e-13);
        UNIT_NEAR(r.value[k * v.columns + 4], -10 * t, 1e-13);
    }
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 1 + 16 * 7);
    UNIT_EQUAL(r.cost, models_cost(r.work));
}

/* The time and the collisions of each row, in a scene that begins at 3, but
   for the row at whose end they touch. Two roundings of times below 4 and
   some of times below 1 are 7e-16. */
TEST(test_asked, "rows have their time and collisions")
{
    FREED(scene) s = falling();
    struct observables asked;
    char message[OBSERVABLES_MESSAGE];
    s.time = 3;
    UNIT_TRUE(observables_read(&asked, "t,collisions", 2, message));
    CREATED(record_view, v, "record", &s, &asked, 0.52);
    const struct record_setup o = order(&s, "leapfrog:1", 0.52, 26);
    FREED(record) r = recorded(&v, &o);
    for (size_t k = 0; k <= 26; ++k) {
        UNIT_NEAR(r.value[k * v.columns], 3 + 0.02 * (double)k, 1e-15);
        UNIT_TRUE(k == 25 || r.value[k * v.columns + 1] == (k > 25));
    }
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
    WALLS(s, 0, SCENE_PERIODIC, -1, 5);
    return s;
}

/* In other units, and seen from the other side with the last body as the
   first, a run is the same but for rounding, and for some of it; places,
   velocities, the energy and what is counted. What it costs is the same,
   but for a root more or less that rounding makes it look for. */
TEST(test_twins, "from elsewhere a run differs by rounding")
{
    static const char *const names[] = {NULL, "energy,x:1,vy:2,collisions",
                                        NULL, "energy,z:1,vz:3"};
    FREED(scene) s = all_at_once();
    for (size_t k = 0; k < 4; ++k) {
        if (k == 2) { /* in space, without contacts */
            s.contact = false;
            s.wall[0] = s.wall[1] = SCENE_OPEN;
            s.gravity[2] = 0.2;
            for (size_t i = 0; i < 4; ++i) {
                s.position[8 + i] = i % 2 ? 0.2 : -0.4;
                s.velocity[8 + i] = 0.1 * (double)i;
            }
        }
        struct observables asked;
        char message[OBSERVABLES_MESSAGE];
        UNIT_TRUE(!names[k] ||
                  observables_read(&asked, names[k], 4, message));
        CREATED(record_view, v, "record", &s, names[k] ? &asked : NULL, 2);
        struct record_setup o = order(&s, "leapfrog:64", 2, 16);
        FREED(record) a = recorded(&v, &o);
        for (o.twin = 1; o.twin <= RECORD_TWINS; ++o.twin) {
            FREED(record) b = recorded(&v, &o);
            const double off = record_difference(&v, &a, &b, 0, 16);
            UNIT_TRUE(off > 0 && off < 1e-10);
            if (!(off > 0 && off < 1e-10))
                printf("# twin %u: %g\n", o.twin, off);
            UNIT_NEAR(b.cost, a.cost, o.twin == 1 ? 0 : 1e-3 * a.cost);
        }
    }
}

/* Sun and Earth, as two of one mass: the size is that of the box; leapfrog
   with 8 and 16 steps to a row errs by four times as much. */
TEST(test_apart, "records are compared")
{
    FREED(scene) s = light_orbit(1, 1.1);
    CREATED(record_view, v, "record", &s, NULL, 8);
    UNIT_EQUAL(v.scale, 1);
    struct record_setup o = order(&s, "kepler", 8, 16);
    FREED(record) truth = recorded(&v, &o);
    double error[2];
    for (size_t k = 0; k < 2; ++k) {
        o.plan = plan(k ? "leapfrog:16" : "leapfrog:8");
        FREED(record) r = recorded(&v, &o);
        error[k] = record_difference(&v, &truth, &r, 1, 16);
        UNIT_EQUAL(record_agree(&v, &truth, &r, error[k]), 16);
        UNIT_TRUE(record_agree(&v, &truth, &r, error[k] / 100) < 16);
    }
    UNIT_NEAR(error[0] / error[1], 4, 0.1);
}

/* A limit on the cost ends a run early, and then it is infinitely far from
   all others. Two side by side have one limit, and part where they do. */
TEST(test_limit, "a run ends at its limit, and two at one")
{
    FREED(scene) s = light_orbit(1, 1.1);
    CREATED(record_view, v, "record", &s, NULL, 8);
    struct record_setup o = order(&s, "pefrl:16", 8, 16);
    FREED(record) a = recorded(&v, &o), b, c;
    o.limit = a.cost / 2;
    record_run(&b, &v, &o);
    UNIT_TRUE(b.end == MODELS_COSTLY && b.reached < 16);
    UNIT_TRUE(isinf(record_difference(&v, &a, &b, 1, 16)));
    record_free(&b);
    struct record_setup p = o;
    p.plan = plan("leapfrog:2");
    o.limit = 1.2 * a.cost;
    p.limit = INFINITY;
    record_both(&b, &c, &v, &o, &p, INFINITY);
    UNIT_TRUE(b.reached == 16 && c.reached == 16);
    const double off = record_difference(&v, &a, &c, 1, 16) / 3;
    record_free(&b);
    record_free(&c);
    record_both(&b, &c, &v, &o, &p, off);
    UNIT_TRUE(b.reached < 16 && b.reached == c.reached);
    UNIT_EQUAL(record_agree(&v, &b, &c, off), (double)b.reached - 1);
    record_free(&b);
    record_free(&c);
    p.plan = o.plan;
    record_both(&b, &c, &v, &o, &p, INFINITY);
    UNIT_TRUE(b.end == MODELS_COSTLY || c.end == MODELS_COSTLY);
    UNIT_TRUE(b.cost + c.cost < 1.4 * a.cost);
    record_free(&b);
    record_free(&c);
}

/* What the errors of one observable are divided by, and what they are said
   to be errors of. */
static double scale(const struct scene *s, const char *name, double length,
                    const char *judged)
{
    FREED(record_view) v;
    struct observables asked;
    char message[OBSERVABLES_MESSAGE];
    UNIT_TRUE(!name || observables_read(&asked, name, s->bodies, message));
    UNIT_TRUE(
        record_view_create(&v, "record", s, name ? &asked : NULL, length));
    UNIT_SAYS(v.judged, judged);
    UNIT_EQUAL(v.weight[0], 1 / v.scale);
    return v.scale;
}

/* Scales that can be found by hand: a body of 2 kg at (3, 0) with (0, 4)
   and one of 5 kg at (0, -4) with (0, -1), that feel nothing. */
TEST(test_scales, "scales by hand")
{
    CREATED(scene, s, 2);
    PUT(s.mass, 2, 5);
    s.position[0] = 3;
    s.position[3] = -4;
    PUT(s.velocity + 2, 4, -1);
    UNIT_EQUAL(scale(&s, NULL, 10, "positions"), 5);
    UNIT_EQUAL(scale(&s, "x:1", 10, "positions"), 5);
    UNIT_EQUAL(scale(&s, "vx:0", 10, "velocities"), 4);
    UNIT_EQUAL(scale(&s, "energy", 10, "energy"), 16 + 2.5);
    UNIT_EQUAL(scale(&s, "momentum", 10, "momentum"), 8 + 5);
    UNIT_EQUAL(scale(&s, "collisions", 10, "counts"), 1);
    UNIT_EQUAL(scale(&s, "t", 10, "t"), 1);
    s.wall[0] = SCENE_HARD; /* a wall is as far as a body */
    s.contact = true;
    s.low[0] = -1;
    s.high[0] = 2; /* but a body can be beyond */
    UNIT_EQUAL(scale(&s, NULL, 10, "positions"), sqrt(32));
    s.high[0] = 8;
    UNIT_EQUAL(scale(&s, NULL, 10, "positions"), sqrt(97));
    s.wall[0] = SCENE_OPEN;
    s.contact = false;
    /* One place: the way of the fastest; all at rest there: 1. */
    s.position[0] = s.position[3] = 0;
    UNIT_EQUAL(scale(&s, NULL, 10, "positions"), 40);
    s.velocity[2] = s.velocity[3] = 0;
    UNIT_EQUAL(scale(&s, NULL, 10, "positions"), 1);
    /* At rest, with nothing that acts: across the scene in that time. */
    s.position[0] = 3;
    UNIT_EQUAL(scale(&s, "vx:0", 10, "velocities"), 0.3);
    UNIT_NEAR(scale(&s, "energy", 10, "energy"), 7 * 0.09, 1e-15);
    UNIT_NEAR(scale(&s, "momentum", 10, "momentum"), 7 * 0.3, 1e-15);
    s.k2 = 5; /* they would circle in 2 pi/omega, omega^2 = 35/3^3 */
    UNIT_NEAR(scale(&s, "vx:0", 10, "velocities"), 3 * sqrt(35 / 27.),
              1e-14);
}

/* A light body on a parabola has no energy but its kinetic one and the same
   again below zero: 1e-6 J, not the rounding that is left of their sum. */
TEST(test_parabolic, "energies that cancel have a scale")
{
    CREATED(scene, s, 2);
    s.mass[1] = 1e-6;
    s.position[1] = 1;
    s.velocity[1] = 0.2;
    s.velocity[3] = 1.4;
    s.k2 = 1;
    UNIT_NEAR(scale(&s, "energy", 10, "energy"), 1e-6, 1e-20);
    s.velocity[1] = s.velocity[3] = 0; /* at rest: the energy itself */
    UNIT_NEAR(scale(&s, "energy", 10, "energy"), 1e-6, 1e-20);
}

/* Without the body that most adds to the size. */
TEST(test_without, "the body that is far away")
{
    static const double places[3][3] = {{0, 1, 10}, {-10, 0, 1}, {4, 0, 1}};
    static const size_t far[3] = {2, 0, 0};
    CREATED(scene, s, 3);
    for (size_t axis = 0; axis < 3; ++axis)
        for (size_t k = 0; k < 3; ++k) {
            size_t found = 9;
            for (size_t c = 0; c < 9; ++c)
                s.position[c] = c / 3 == axis ? places[k][c % 3] : 7;
            UNIT_EQUAL(record_scale_without(&s, &found), 1);
            UNIT_EQUAL(found, far[k]);
        }
}

/* Places far from the origin are known as well as they are written: half a
   unit in the last place there. Of what is asked for, that is not said, and
   not where the scene is as wide as it is far. */
TEST(test_grain, "far from the origin places are coarse")
{
    FREED(record_view) v;
    struct observables asked;
    char message[OBSERVABLES_MESSAGE];
    CREATED(scene, s, 2);
    UNIT_TRUE(observables_read(&asked, "x:0", 2, message));
    for (size_t axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            for (size_t c = 0; c < 6; ++c)
                s.position[c] = 0;
            s.position[2 * axis] = side * 1e7;
            s.position[2 * axis + 1] = side * 1e7 + 2;
            UNIT_TRUE(record_view_create(&v, "record", &s, NULL, 1));
            UNIT_NEAR(v.rounded, 0x1p-53 * 1e7 / 2, 1e-6 * v.rounded);
            /* And no two runs agree to less. */
            struct record_setup o = order(&s, "free", 1, 2);
            FREED(record) a = recorded(&v, &o), b = recorded(&v, &o);
            /* (With a rounding of the rows themselves, of 2 m.) */
            UNIT_NEAR(record_difference(&v, &a, &b, 0, 2), v.rounded,
                      0x1p-52);
            UNIT_EQUAL(a.value[axis], side * 1e7);
            UNIT_EQUAL(a.value[6 + axis], side * 1e7 + 2);
            UNIT_EQUAL(record_agree(&v, &a, &b, 1.01 * v.rounded), 2);
            UNIT_EQUAL(record_agree(&v, &a, &b, 0.9 * v.rounded), 0);
            record_view_free(&v);
            UNIT_TRUE(record_view_create(&v, "record", &s, &asked, 1));
            UNIT_EQUAL(v.rounded, 0);
            record_view_free(&v);
        }
    for (size_t c = 0; c < 6; ++c)
        s.position[c] = 0;
    s.position[0] = 1.9;
    s.position[1] = 3.9; /* 2 wide, 1.9 from the origin */
    UNIT_TRUE(record_view_create(&v, "record", &s, NULL, 1));
    UNIT_EQUAL(v.rounded, 0);
    record_view_free(&v);
    PUT(s.position, 2.1, 4.1);
    UNIT_TRUE(record_view_create(&v, "record", &s, NULL, 1));
    UNIT_EQUAL(v.rounded, 0x1p-53 * 2.1 / v.scale);
}

/* Rows made by hand, in a box that is periodic along x, 6 m, and has walls
   along y, 2 m apart: places once round are the same, by whatever many
   turns, velocities are not, and what is no number is infinitely far. */
TEST(test_rows, "rows are compared round the box")
{
    FREED(scene) s = all_at_once();
    CREATED(record_view, v, "record", &s, NULL, 2);
    const double scale = sqrt(6 * 6 + 2 * 2);
    UNIT_NEAR(v.scale, scale, 1e-14);
    double one[3 * 24], other[3 * 24];
    struct record a = {.reached = 2, .value = one};
    struct record b = {.reached = 2, .value = other};
    static const struct {
        size_t column; /* of six for each body */
        double off, apart;
    } known[] = {
        {0, 0.25, 0.25}, {0, 6, 0},          {6, -5.75, 0.25},
        {6, 18.5, 0.5},  {0, 3, 3},          {0, -3.5, 2.5},
        {1, 0.25, 0.25}, {1, 6, 6},          {19, -6, 6},
        {2, 6, 6},       {0, NAN, INFINITY}, {1, INFINITY, INFINITY},
        {23, NAN, 0}};
    UNIT_EQUAL(v.columns, 24);
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k)
        for (size_t row = 0; row < 3; ++row) {
            for (size_t c = 0; c < 72; ++c)
                one[c] = other[c] = 0.1 * (double)c;
            if (known[k].column == 23)
                continue; /* velocities are not judged by */
            other[24 * row + known[k].column] += known[k].off;
            const double d = record_difference(&v, &a, &b, 0, 2);
            if (isinf(known[k].apart))
                UNIT_TRUE(isinf(d));
            else
                UNIT_NEAR(d, known[k].apart / scale, 1e-14);
            UNIT_TRUE((record_difference(&v, &a, &b, 0, 0) > 1e-14) ==
                      (row == 0 && known[k].apart > 0));
            UNIT_TRUE((record_difference(&v, &a, &b, 1, 2) > 1e-14) ==
                      (row > 0 && known[k].apart > 0));
            /* The first row is that of the start, which agrees anyway. */
            if (known[k].apart > 0)
                UNIT_EQUAL(record_agree(&v, &a, &b, 1e-14),
                           row == 0 ? 2 : (double)row - 1);
        }
    b.reached = 1;
    UNIT_TRUE(isinf(record_difference(&v, &a, &b, 0, 2)));
    UNIT_TRUE(isinf(record_difference(&v, &b, &a, 0, 2)));
    UNIT_TRUE(record_difference(&v, &a, &b, 0, 1) < INFINITY);
}

/* Two balls of radius 0.1 that pass at 0.2 + g, in steps: both the run and
   its twin tell by how little they missed, or that they met; with balls
   that are larger by s, of which each has as much, by 2 s less. */
TEST(test_least, "by how little two missed, seen twice")
{
    static const double gaps[] = {1e-3, -1e-3};
    for (size_t k = 0; k < 2; ++k) {
        CREATED(scene, s, 2);
        s.contact = true;
        s.radius[0] = s.radius[1] = 0.1;
        s.position[0] = -1;
        s.position[2] = 0.2 + gaps[k];
        s.velocity[0] = 1.5;
        CREATED(record_view, v, "record", &s, NULL, 1.2);
        struct record_setup o = order(&s, "leapfrog:16", 1.2, 3);
        o.plan.contact_margin = 0.01;
        for (int twin = 0; twin < 2; ++twin)
            for (int swollen = 0; swollen < 2; ++swollen) {
                o.twin = twin;
                o.grow = swollen ? 1e-4 : 0;
                FREED(record) r = recorded(&v, &o);
                const double way = 0.2 + gaps[k];
                const double touching = 0.2 + 2 * o.grow;
                UNIT_NEAR(fabs(r.least),
                          fabs(way * way - touching * touching) /
                              (2 * touching),
                          1e-9);
            }
    }
}
