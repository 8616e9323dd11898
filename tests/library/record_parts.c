/* What records are made of, each part by itself against what is found by
   hand: the units of twins, the last bits that they move, scales, and how
   far rows are apart. */
#include "unit.h"

#include <choosing/record.c> /* of src: most of its parts are private */

static bool is_power_of_two(double x)
{
    int exponent;
    return fabs(frexp(x, &exponent)) == 0.5;
}

/* Twin 1 keeps the times of rows to the bit; all else is rounded anew in
   each of the twins, and in each in another way. */
TEST(test_units, "the units of twins round anew")
{
    /* With other units runs end in other last digits: these are those of
       all outputs so far. */
    static const struct units known[] = {
        {1, 1, 1},        {-0.7, 1.3, 1},   {0.9, 0.6, 1.1},
        {-1.1, 1.7, 0.7}, {1.3, 0.9, 1.9},  {-0.6, 2.3, 1.3},
        {1.9, 1.1, 0.85}, {-0.85, 0.7, 0.6}};
    for (unsigned k = 0; k <= RECORD_TWINS; ++k)
        UNIT_TRUE(units[k].length == known[k].length &&
                  units[k].mass == known[k].mass &&
                  units[k].time == known[k].time);
    UNIT_EQUAL(sizeof units / sizeof *units, RECORD_TWINS + 1);
    UNIT_TRUE(units[0].length == 1 && units[0].mass == 1 &&
              units[0].time == 1);
    UNIT_EQUAL(units[1].time, 1);
    for (unsigned k = 1; k <= RECORD_TWINS; ++k) {
        const struct units *u = &units[k];
        UNIT_TRUE(!is_power_of_two(u->length) && !is_power_of_two(u->mass));
        UNIT_TRUE(k == 1 || !is_power_of_two(u->time));
        UNIT_TRUE(fabs(u->length) > 0.5 && fabs(u->length) < 2);
        UNIT_TRUE(u->mass > 0.5 && u->mass < 4);
        UNIT_TRUE(u->time > 0.5 && u->time < 2);
        for (unsigned j = 0; j < k; ++j)
            UNIT_TRUE(u->length != units[j].length &&
                      u->mass != units[j].mass &&
                      u->time != units[j].time * (k == 1 ? 2 : 1));
    }
}

/* A scene of three bodies in which every number is another one. */
static struct scene all_different(void)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 3));
    UNIT_TRUE(scene_add_kind(&s, 30, 31) && scene_add_kind(&s, 32, 33));
    UNIT_TRUE(scene_add_spring(&s, 0, 1, 0, 34) &&
              scene_add_spring(&s, 2, 0, 1, 35));
    s.carry = malloc(18 * sizeof *s.carry);
    s.kept = malloc(9 * sizeof *s.kept);
    UNIT_TRUE(s.carry && s.kept);
    for (size_t i = 0; i < 3; ++i) {
        s.mass[i] = 40 + (double)i;
        s.charge[i] = 50 + (double)i;
        s.radius[i] = 60 + (double)i;
    }
    for (size_t c = 0; c < 9; ++c) {
        s.position[c] = 100 + (double)c;
        s.velocity[c] = 200 + (double)c;
        s.kept[c] = 300 + (double)c;
        s.carry[c] = 400 + (double)c;
        s.carry[9 + c] = 500 + (double)c;
        s.freedom[c] = c == 0 || c == 4 || c == 6 || c == 7;
    }
    for (size_t k = 0; k < 3; ++k) {
        s.gravity[k] = 70 + (double)k;
        s.low[k] = -10 - (double)k;
        s.high[k] = 20 + (double)k;
    }
    s.time = 80;
    s.k2 = 81;
    s.softening = 82;
    s.damping = 83;
    return s;
}

/* By the dimensions: with l = -2, m = 4 and t = 8 for the units of length,
   mass and time all is exact; the last body comes first. */
TEST(test_turned, "a scene seen from the other side")
{
    const struct units u = {-2, 4, 8};
    FREED(scene) s = all_different(), old;
    UNIT_TRUE(scene_copy(&old, &s));
    change_units(&s, &u);
    for (size_t i = 0; i < 3; ++i) {
        UNIT_EQUAL(s.mass[i], 4 * (42 - (double)i));
        UNIT_EQUAL(s.charge[i], 52 - (double)i);
        UNIT_EQUAL(s.radius[i], 2 * (62 - (double)i));
        for (size_t k = 0; k < 3; ++k) {
            const size_t c = 3 * k + i, o = 3 * k + 2 - i;
            UNIT_EQUAL(s.position[c], -2 * (100 + (double)o));
            UNIT_EQUAL(s.velocity[c], -0.25 * (200 + (double)o));
            UNIT_EQUAL(s.kept[c], -0.03125 * (300 + (double)o));
            UNIT_EQUAL(s.carry[c], -2 * (400 + (double)o));
            UNIT_EQUAL(s.carry[9 + c], -0.25 * (500 + (double)o));
            UNIT_EQUAL(s.freedom[c], old.freedom[o]);
        }
    }
    for (size_t k = 0; k < 3; ++k) {
        UNIT_EQUAL(s.gravity[k], -0.03125 * (70 + (double)k));
        UNIT_EQUAL(s.low[k], -2 * (20 + (double)k));
        UNIT_EQUAL(s.high[k], 2 * (10 + (double)k));
    }
    UNIT_TRUE(s.spring[0].a == 2 && s.spring[0].b == 1);
    UNIT_TRUE(s.spring[1].a == 0 && s.spring[1].b == 2);
    UNIT_TRUE(s.spring[0].rest == 68 && s.spring[1].rest == 70);
    UNIT_EQUAL(s.kind[0].stiffness, 30 * 0.0625);
    UNIT_EQUAL(s.kind[0].damping, 31 * 0.5);
    UNIT_EQUAL(s.kind[1].stiffness, 32 * 0.0625);
    UNIT_EQUAL(s.kind[1].damping, 33 * 0.5);
    UNIT_EQUAL(s.time, 640);
    UNIT_EQUAL(s.k2, 81 * 8 / 256.0);
    UNIT_EQUAL(s.softening, 164);
    UNIT_EQUAL(s.damping, 83 * 0.5);
    scene_free(&old);
}

/* One unit in the last place of 1, up as often as down: of 64 fair coins
   more than 50 or less than 14 fall on one side once in a million. The
   twins' signs are not those of another one. */
TEST(test_last_bits, "last bits go up and down")
{
    for (unsigned twin = 1; twin <= RECORD_TWINS; ++twin) {
        int up = 0;
        for (size_t c = 0; c < 64; ++c) {
            UNIT_EQUAL(fabs(last_bit(c, twin)), 0x1p-52);
            up += last_bit(c, twin) > 0;
        }
        UNIT_TRUE(up >= 14 && up <= 50);
        for (unsigned other = 1; other < twin; ++other) {
            int same = 0;
            for (size_t c = 0; c < 64; ++c)
                same += last_bit(c, twin) == last_bit(c, other);
            UNIT_TRUE(same >= 14 && same <= 50);
        }
    }
}

/* Moved is what may move along an axis that lives: by a unit in the last
   place of its velocity, or of a quarter of its speed; and what is at rest,
   but falls, by that of the speed with which it falls through the scene. */
TEST(test_moved, "they are moved where something moves")
{
    struct scene old;
    CREATED(scene, s, 3);
    s.position[1] = 3;
    s.position[5] = 4;
    s.position[2] = 3;
    s.velocity[0] = 4; /* speed 5, along x and y */
    s.velocity[3] = 3;
    s.velocity[1] = 8;
    s.freedom[2] = s.freedom[5] = 0;
    for (int falls = 0; falls < 2; ++falls) {
        if (falls) /* sqrt(320 5) = 40 m/s */
            s.gravity[1] = -320;
        UNIT_TRUE(scene_copy(&old, &s));
        move_last_bits(&s, 3);
        const double by[] = {falls ? 10 : 4, falls ? 10 : 8, 0,
                             falls ? 10 : 3, falls ? 10 : 2, 0};
        for (size_t c = 0; c < 9; ++c)
            UNIT_NEAR(
                s.velocity[c],
                old.velocity[c] + (c < 6 ? last_bit(c, 3) * by[c] : 0), 0);
        scene_free(&s);
        s = old;
    }
}

TEST(test_tied, "they are not where a closed form ties nothing")
{
    for (unsigned k = 0; k < 4; ++k) {
        FREED(scene) s = all_different(), t;
        s.contact = k % 2;
        s.k2 = 0;
        struct models_plan plan = {
            .model = models_find(k < 2 ? "leapfrog" : "free"), .steps = 1};
        const struct record_setup o = {
            .scene = &s, .plan = plan, .every = 1, .twin = 1};
        FREED(record) r;
        struct pass w = {.r = &r, .o = &o};
        FREED(record_view) v;
        UNIT_MUST(plan.model && scene_copy(&t, &s) &&
                  record_view_create(&v, "record", &s, NULL, 1));
        begin_pass(&w, &v);
        change_units(&t, &units[1]);
        UNIT_EQUAL(memcmp(w.twin.velocity, t.velocity,
                          9 * sizeof *t.velocity) != 0,
                   k != 2);
        end_pass(&w);
        scene_free(&t);
    }
}

/* Along a ring of 6 m places are never more than 3 m apart. */
TEST(test_between, "distances along a ring")
{
    static const double known[][4] = {
        {1, 3, 0, 2},       {3, 1, 0, 2}, {1, 3, 6, 2}, {0, 5, 6, 1},
        {-1, 12.5, 6, 1.5}, {0, 3, 6, 3}, {0, 6, 6, 0}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
        UNIT_EQUAL(distance(known[k][0], known[k][1], known[k][2]),
                   known[k][3]);
}

/* Two columns, of scales 2 and 8, and one that is not judged. Numbers that
   differ by less than they are rounded may have been rounded alike. */
TEST(test_apart, "how far rows are apart")
{
    double weight[] = {0.5, 0.125, 0}, turn[3] = {0};
    double last[] = {0x1p-10, 0, 0x1p-10};
    struct record_view v = {
        .columns = 3, .weight = weight, .period = turn, .rounding = last};
    static const double known[][7] = {
        {16, 8, 1, 17, 8, 1, 0.5},
        {16, 8, 1, 16.5, 16, 1, 1},
        {16, 8, 1, 16, 8, 5, 0x1p-7}, /* 16 2^-10/2 */
        {-16, 8, 1, -16, 8, 5, 0x1p-7},
        {16, 8, 1, 16 + 0x1p-6, 8, 1, 0x1p-7},
        {16, 8, 1, 16 + 0x1.01p-6, 8, 1, 0x1.01p-7},
        {0, 0, 1, 0, 0, 1, 0x1p-20}, /* no less than rows are rounded */
        {0, NAN, 1, 0, 0, 1, INFINITY}};
    v.rounded = 0x1p-20;
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        const double d = row_difference(&v, known[k], known[k] + 3);
        UNIT_TRUE(d == known[k][6]);
    }
}

TEST(test_scales, "scales of units")
{
    const struct scales to = {2, 3, 5, 7};
    static const struct {
        const char *unit, *as;
        double scale;
    } known[] = {{"length", "positions", 2},
                 {"length/time", "velocities", 3},
                 {"mass length^2/time^2", "energy", 5},
                 {"mass length/time", "momentum", 7},
                 {"mass length^2/time", "angular momentum", 14},
                 {"time", "t", 1},
                 {"", "counts", 1}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        const char *as = NULL;
        UNIT_EQUAL(scale_of(&to, known[k].unit, &as), known[k].scale);
        UNIT_SAYS(as, known[k].as);
    }
    UNIT_EQUAL(or_next(0, 4), 4);
    UNIT_EQUAL(or_next(3, 4), 3);
}

TEST(test_speed, "how fast a body is")
{
    CREATED(scene, s, 2);
    for (size_t k = 0; k < 3; ++k) {
        s.velocity[2 * k + 1] = (const double[]){2, -3, 6}[k];
        s.velocity[2 * k] = 50;
    }
    UNIT_EQUAL(speed_of_body(&s, 1), 7);
}
