/* Bodies along ellipses that are kicked: what is exact, what is kept, how
   the error goes with the step and with the masses, and what is refused. */
#include "unit.h"

#include "forces/celestial.h"
#include "forces/jacobi.h"
#include "forces/kepler.h"
#include "forces/largest.h"
#include "forces/motion.h"

#include <float.h>

/* A star of mass 1 and two planets of these masses, on ellipses. */
static void build(struct scene *s, double mass, double eccentricity)
{
    const struct kepler_elements o[] = {
        {1, eccentricity, 0.05, 0.3, 1, 0.5},
        {2.3, eccentricity / 2, 0.02, 2, 0.4, 4}};
    UNIT_MUST(scene_create(s, 3));
    s->k2 = 1;
    s->dt = 0.1;
    for (size_t i = 1; i < 3; ++i) {
        double x[3], v[3];
        kepler_place(1 + mass, &o[i - 1], x, v);
        s->mass[i] = mass;
        for (size_t k = 0; k < 3; ++k) {
            s->position[3 * k + i] = x[k];
            s->velocity[3 * k + i] = v[k];
        }
    }
}

/* Runs a scene to t, steps of either sign. */
static void go(struct scene *s, const char *method, double dt, double t)
{
    BEGUN(motion, m, "jacobi", s, method, fabs(dt));
    UNIT_MUST(motion_shorten(&m, dt));
    UNIT_TRUE(motion_run(&m, (uint64_t)round(t / fabs(dt))) ==
              STEPPING_DONE);
}

/* How far the bodies of two scenes are apart, at most. */
static double apart(const struct scene *a, const struct scene *b)
{
    return largest_difference(a->position, b->position, 3 * a->bodies);
}

/* Two bodies: 50 steps of any length are where the closed form is in one.
   A step rounds by some DBL_EPSILON in phase, and an error of the velocity
   grows with the time, here up to 200. */
static void check_pair(const char *method, double dt)
{
    FREED(scene) s;
    double x[3], v[3];
    UNIT_MUST(gallery_choose(&s, celestial_scenes, "sun-earth",
                             (struct gallery_choice[]){{"mass", 0.1},
                                                       {"speed", 0.8},
                                                       {"centred", 1},
                                                       {0}}) == NULL);
    for (size_t k = 0; k < 3; ++k) {
        x[k] = s.position[2 * k + 1] - s.position[2 * k];
        v[k] = s.velocity[2 * k + 1] - s.velocity[2 * k];
    }
    go(&s, method, dt, 50 * dt);
    kepler_move(1.1 * s.k2, 50 * dt, x, v);
    for (size_t k = 0; k < 3; ++k)
        UNIT_NEAR(s.position[2 * k + 1] - s.position[2 * k], x[k], 3e-12);
}

TEST(test_pair, "two bodies are exact at any step")
{
    static const double steps[] = {0.1, 10, 100, 237};
    for (size_t k = 0; k < 4; ++k) {
        check_pair("wisdom-holman", steps[k]);
        check_pair("sbab4", steps[k]);
    }
}

/* The error at t = 10 against Kahan and Li's method in short steps. */
static double error_of(const char *method, double dt, double mass)
{
    FREED(scene) s, right;
    build(&s, mass, 0.1);
    UNIT_MUST(scene_copy(&right, &s));
    go(&right, "kahan-li8", 0.01, 10);
    go(&s, method, dt, 10);
    const double error = apart(&s, &right);
    return error;
}

/* It is the same motion, and the order of it is 2. Masses of a hundredth,
   for which the part of the second order in them is seen of both. */
TEST(test_order, "more are where Kahan and Li say, in order 2")
{
    static const char *const names[] = {"wisdom-holman", "sbab4"};
    for (size_t k = 0; k < 2; ++k) {
        const double far = error_of(names[k], 0.1, 0.01);
        const double near = error_of(names[k], 0.05, 0.01);
        UNIT_TRUE(far < 1e-3);
        UNIT_NEAR(log2(far / near), 2, 0.2);
    }
}

/* Ten times lighter planets: leapfrog's error stays, Wisdom and Holman's is
   ten times, the other a hundred times less. */
TEST(test_masses, "errors go as powers of the planets' masses")
{
    static const char *const names[] = {"leapfrog", "wisdom-holman",
                                        "sbab4"};
    for (int k = 0; k < 3; ++k) {
        const double heavy = error_of(names[k], 0.1, 1e-3);
        const double light = error_of(names[k], 0.1, 1e-4);
        UNIT_NEAR(log10(heavy / light), k, 0.15);
    }
}

TEST(test_reversal, "steps back lead back")
{
    static const char *const names[] = {"wisdom-holman", "sbab4"};
    for (size_t k = 0; k < 2; ++k) {
        FREED(scene) s, before;
        build(&s, 0.01, 0.2);
        UNIT_MUST(scene_copy(&before, &s));
        go(&s, names[k], 0.3, 60);
        UNIT_TRUE(apart(&s, &before) > 0.1);
        go(&s, names[k], -0.3, 60);
        UNIT_TRUE(apart(&s, &before) < 1e-11);
    }
}

/* Sum of mass times place, or velocity, along an axis. */
static double moment(const struct scene *s, const double x[], size_t axis)
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i] * x[axis * s->bodies + i];
    return sum;
}

/* Momentum stays and the centre of mass goes straight on, but for a
   rounding in each of a thousand steps, at worst all of one sign. */
TEST(test_momentum, "momentum and the centre of mass are kept")
{
    static const char *const names[] = {"wisdom-holman", "sbab4"};
    for (size_t k = 0; k < 2; ++k) {
        FREED(scene) s, before;
        build(&s, 0.01, 0.2);
        s.velocity[0] = 0.3;
        UNIT_MUST(scene_copy(&before, &s));
        go(&s, names[k], 0.1, 100);
        for (size_t c = 0; c < 3; ++c) {
            const double p = moment(&before, before.velocity, c);
            const double x = moment(&before, before.position, c);
            UNIT_NEAR(moment(&s, s.velocity, c), p, 1000 * DBL_EPSILON);
            UNIT_NEAR(moment(&s, s.position, c), x + 100 * p,
                      1e5 * DBL_EPSILON);
        }
    }
}

TEST(test_light, "a body without mass disturbs nobody")
{
    FREED(scene) s, t;
    build(&s, 1e-3, 0.1);
    s.mass[2] = 0;
    UNIT_MUST(scene_copy(&t, &s));
    go(&s, "wisdom-holman", 0.02, 20);
    go(&t, "kahan-li8", 0.02, 20);
    UNIT_TRUE(apart(&s, &t) < 1e-6);
}

TEST(test_open, "an orbit that opens ends the run")
{
    MADE(scene, s, build(&s, 1e-3, 0.1));
    BEGUN(motion, m, "jacobi", &s, "wisdom-holman", 0.1);
    s.velocity[5] += 3;
    UNIT_TRUE(motion_run(&m, 1000) == STEPPING_INFINITE);
}

static void refuses(struct scene *s, const char *why)
{
    const char *said = jacobi_refuses(s);
    UNIT_TRUE(said && strcmp(said, why) == 0);
}

TEST(test_refusals, "what is no system of planets is refused")
{
    MADE(scene, s, build(&s, 0.01, 0.1));
    UNIT_TRUE(jacobi_refuses(&s) == NULL);
    s.contact = true;
    refuses(&s, "the scene has bodies that collide");
    s.contact = false;
    s.damping = 1;
    refuses(&s, "the scene has friction");
    s.damping = 0;
    s.gravity[1] = -1;
    refuses(&s, "the scene has a weight");
    s.gravity[1] = 0;
    s.softening = 0.1;
    refuses(&s, "the scene's gravity is softened");
    s.softening = 0;
    s.freedom[4] = 0;
    refuses(&s, "the scene has bodies that are held");
    for (size_t i = 0; i < 3; ++i)
        s.position[3 + i] = 0; /* one is held in a plane */
    refuses(&s, "the scene has bodies that are held");
    s.freedom[3] = s.freedom[5] = 0; /* and all in it: they stay there */
    UNIT_TRUE(jacobi_refuses(&s) == NULL);
    s.position[5] = 0.1; /* or not in it */
    refuses(&s, "the scene has bodies that are held");
    scene_free(&s);
    build(&s, 0.01, 0.1);
    s.mass[2] = 2;
    refuses(&s, "the first body of the scene is not the heaviest");
    s.mass[2] = 0.01;
    s.velocity[5] += 3;
    refuses(&s,
            "a body of the scene is on no ellipse about those before it");
    s.velocity[5] -= 3;
    for (size_t i = 0; i < s.bodies; ++i)
        s.velocity[s.bodies + i] += 3; /* all of them fly along */
    UNIT_TRUE(jacobi_refuses(&s) == NULL);
    s.k2 = 0;
    refuses(&s, "no two bodies of the scene attract each other");
    s.k2 = 1;
    UNIT_TRUE(jacobi_refuses(&s) == NULL);
    UNIT_MUST(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 1));
    refuses(&s, "the scene has springs");
}
