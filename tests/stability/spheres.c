/* Where spheres in steps fail, chapter 11. Each case must go on failing as
   the chapter says it does. */
#include "unit.h"

#include "box/disks.h"
#include "forces/hard.h"
#include "forces/motion.h"
#include "forces/spheres.h"

static void make(struct scene *s, const char *name, const char *key,
                 double value)
{
    UNIT_MUST(
        !gallery_make(s, gallery_find(hard_scenes, name), key, value));
}

static void begin(struct spheres *p, const struct scene *s,
                  enum spheres_shift shift, double dt)
{
    UNIT_TRUE(spheres_create(p, s, SPHERES_APPROACHING));
    p->shift = shift;
    p->dt = dt;
}

static void run(struct scene *s, struct spheres *p, double time)
{
    for (long k = lround(time / p->dt); k > 0; --k) {
        for (size_t i = 0; i < SCENE_AXES * s->bodies; ++i)
            s->position[i] += s->velocity[i] * p->dt;
        spheres_resolve(p, s->position, s->velocity);
    }
}

static double energy(const struct scene *s)
{
    double sum = 0;
    for (size_t i = 0; i < SCENE_AXES * s->bodies; ++i)
        sum += s->mass[i % s->bodies] * s->velocity[i] * s->velocity[i] / 2;
    return sum;
}

/* The pressure of the gas from the virial, mean of both axes, after 10 s of
   warm-up and for 60 s. By events 1.62075(31), computed for this book by a
   program of its own; one run of 60 s scatters by 0.003. The law says
   -0.043 of it at a step of 0.1 diameters. */
static double pressure(enum spheres_shift shift, double *change)
{
    MADE(scene, s, make(&s, "gas", NULL, 0));
    MADE(spheres, p, begin(&p, &s, shift, 0.02));
    const double E = energy(&s);
    run(&s, &p, 10);
    p.virial = 0;
    run(&s, &p, 60);
    const double Z = 1 + p.virial / (2 * E * 60);
    *change = fabs(energy(&s) / E - 1);
    return Z;
}

TEST(test_pressure, "perfect energy, wrong pressure")
{
    double change;
    const double pushed = pressure(SPHERES_BY_RADIUS, &change);
    UNIT_NEAR(change, 0, 1e-13);
    UNIT_NEAR(pushed / 1.62075 - 1, -0.043, 0.01);
    const double back = pressure(SPHERES_BACK, &change);
    UNIT_NEAR(change, 0, 1e-13);
    UNIT_NEAR(back / 1.62075 - 1, -0.005, 0.007);
}

/* Two disks fly through each other, and the energy has no complaint. */
TEST(test_tunnelling, "long steps go through")
{
    for (int slow = 0; slow < 2; ++slow) {
        CREATED(scene, s, 2);
        s.contact = true;
        s.radius[0] = s.radius[1] = 0.1;
        PUT(s.position, -0.15, 0.15);
        PUT(s.velocity, 1, -1);
        MADE(spheres, p, begin(&p, &s, SPHERES_BACK, slow ? 0.1 : 0.3));
        run(&s, &p, 0.3);
        UNIT_EQUAL(p.collisions, slow);
        UNIT_NEAR(s.velocity[0], slow ? -1 : 1, 1e-15);
        UNIT_NEAR(energy(&s), 1, 1e-15);
    }
}

/* Five touching balls, hit from both sides; the middle one of this mass.
   What leaves, in this order of pairs. */
static void strike(double mass, enum spheres_order order, double v[])
{
    const struct gallery_scene *g = gallery_find(hard_scenes, "cradle");
    double value[GALLERY_KEYS], momentum = 0;
    FREED(scene) s;
    gallery_usual(g, value);
    value[gallery_key(g, "right")] = 1;
    value[gallery_key(g, "gap")] = 0;
    value[gallery_key(g, "middle")] = mass;
    UNIT_TRUE(!g->build(&s, value));
    s.wall[0] = SCENE_OPEN;
    MADE(spheres, p, begin(&p, &s, SPHERES_BY_MASS, 0.001));
    p.order = order;
    run(&s, &p, 8);
    for (size_t i = 0; i < 5; ++i) {
        v[i] = s.velocity[i];
        momentum += s.mass[i] * v[i];
    }
    UNIT_NEAR(momentum, 0, 1e-14);
    UNIT_NEAR(energy(&s), 1, 1e-14);
}

TEST(test_touching, "a heavy middle ball: the order decides")
{
    double up[5], down[5];
    strike(1, SPHERES_ASCENDING, up);
    strike(1, SPHERES_DESCENDING, down);
    for (int i = 0; i < 5; ++i)
        UNIT_NEAR(up[i], down[i], 1e-14);
    strike(2, SPHERES_ASCENDING, up);
    strike(2, SPHERES_DESCENDING, down);
    UNIT_TRUE(fabs(up[4] - down[4]) > 0.1);
    UNIT_TRUE(fabs(up[4] + up[0]) > 0.01); /* not symmetric */
}

/* The break by events, the rack displaced by 1e-12 m at most: places of the
   ball with the largest number after 0.5 s. */
static double break_by_events(double seed)
{
    const struct gallery_scene *g = gallery_find(hard_scenes, "break");
    double value[GALLERY_KEYS], place[DISKS_AXES];
    FREED(scene) s;
    FREED(disks) d;
    gallery_usual(g, value);
    value[gallery_key(g, "jitter")] = 1e-12;
    value[gallery_key(g, "seed")] = seed;
    UNIT_TRUE(!g->build(&s, value));
    for (size_t k = 0; k < 2; ++k) {
        WALLS(s, k, SCENE_HARD, -50, 50);
    }
    UNIT_TRUE(hard_disks(&d, &s) && disks_plan(&d));
    disks_run(&d, 0.5, UINT64_MAX);
    disks_position(&d, 15, place);
    return place[0] - 50;
}

static double break_by_steps(enum spheres_order order)
{
    MADE(scene, s, make(&s, "break", NULL, 0));
    MADE(spheres, p, begin(&p, &s, SPHERES_BACK, 1e-5));
    p.order = order;
    run(&s, &p, 0.5);
    const double x = s.position[15];
    return x;
}

TEST(test_break, "the break has two answers")
{
    double least = INFINITY, most = -INFINITY;
    for (int seed = 0; seed < 8; ++seed) {
        const double x = break_by_events(seed);
        least = fmin(least, x);
        most = fmax(most, x);
        UNIT_TRUE(x - least < 1e-6 || most - x < 1e-6); /* one of two */
    }
    UNIT_TRUE(most - least > 0.5);
    UNIT_TRUE(fabs(break_by_steps(SPHERES_ASCENDING) -
                   break_by_steps(SPHERES_DESCENDING)) > 0.5);
    const double x = break_by_steps(SPHERES_DEEPEST);
    UNIT_TRUE(fabs(x - least) < 1e-6 || fabs(x - most) < 1e-6);
}

/* A heavy disk among light ones: with shares by radius the centre of mass
   of all is moved, by mass it is not. */
TEST(test_shoved, "a heavy disk is shoved")
{
    for (int shift = SPHERES_BY_RADIUS; shift <= SPHERES_BACK; ++shift) {
        double before = 0, P = 0, after = 0;
        MADE(scene, s, make(&s, "brownian", NULL, 0));
        s.wall[0] = s.wall[1] = SCENE_PERIODIC;
        MADE(spheres, p, begin(&p, &s, shift, 0.02));
        for (size_t i = 0; i < s.bodies; ++i) {
            before += s.mass[i] * s.position[i];
            P += s.mass[i] * s.velocity[i];
        }
        run(&s, &p, 2);
        for (size_t i = 0; i < s.bodies; ++i)
            after += s.mass[i] * s.position[i];
        const double moved = fabs(after - before - 2 * P);
        UNIT_TRUE(shift == SPHERES_BY_RADIUS ? moved > 0.01
                                             : moved < 1e-10);
    }
}

/* A body on a spring turns 1 cm behind a wall. With 1.6 / omega from one
   look to the next the cubic stays before the wall, and the contact is
   missed; with half of that it is found. */
TEST(test_turn, "a turn behind a wall is missed")
{
    for (int parts = 1; parts <= 2; ++parts) {
        FREED(scene) s;
        ENDED(motion) m;
        UNIT_MUST(scene_create(&s, 2) && scene_add_kind(&s, 1, 0) &&
                  scene_add_spring(&s, 0, 1, 0, 9));
        s.contact = true;
        WALLS(s, 0, SCENE_HARD, -20, 0.99);
        s.position[0] = cos(0.8);
        s.velocity[0] = sin(0.8);
        s.position[1] = -9;
        for (size_t k = 0; k < 3; ++k)
            s.freedom[2 * k + 1] = 0;
        UNIT_TRUE(
            motion_begin(&m, "spheres", &s, "kahan-li8", 1.6 / parts) &&
            motion_locate(&m));
        motion_run(&m, (uint64_t)parts);
        UNIT_EQUAL(m.collisions, parts - 1);
        UNIT_NEAR(s.position[0],
                  cos(parts > 1 ? 0.8 + 2 * acos(0.99) : 0.8), 1e-3);
    }
}

/* Two balls with springs of omega = 100/s, in steps of 2/omega and of a
   tenth of that: the first makes energy, the other keeps it to a per cent.
 */
TEST(test_stiff, "a stiff contact makes energy")
{
    for (int fine = 0; fine < 2; ++fine) {
        CREATED(scene, s, 2);
        s.contact = true;
        s.law = SCENE_LINEAR;
        s.stiffness = 5000;
        s.radius[0] = s.radius[1] = 0.1;
        s.position[1] = 0.2001;
        s.velocity[0] = 1;
        BEGUN(motion, m, "spheres", &s, "leapfrog", fine ? 0.002 : 0.02);
        motion_run(&m, 200);
        const double energy = motion_kinetic(&m);
        UNIT_NEAR(energy, 0.5, fine ? 0.005 : 100);
        UNIT_TRUE(fine || energy > 2);
    }
}
