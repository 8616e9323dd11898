/* Rods: a pendulum against its period, chapter 10's double pendulum, a
   chain and a triangle that keep their lengths, energy and momentum, order
   two and the way back, and steps that are too long. */
#include "unit.h"

#include "library/forces.h"
#include "choosing/models.h"
#include "forces/rods.h"

static double weight;
static struct scene scene;

/* Only weight acts, along z, on what is free. */
FORCES(fall)
{
    const size_t n = scene.bodies;
    for (size_t c = 0; c < 3 * n; ++c)
        a[c] = c >= 2 * n && scene.freedom[c] ? -weight : 0;
}

static struct rods rods;

static void begin(void)
{
    const struct stepping_forces forces = {3 * scene.bodies, false, fall,
                                           NULL};
    UNIT_TRUE(
        rods_create(&rods, &scene, scene.spring, scene.springs, forces));
}

static void end(void)
{
    rods_free(&rods);
    scene_free(&scene);
}

static bool run(double dt, int steps)
{
    for (int k = 0; k < steps; ++k)
        if (!rods_step(&rods, dt, scene.position, scene.velocity))
            return false;
    return true;
}

/* n bodies in a row along x, one metre apart, from body 0, which is held if
   `held`, joined by rods. */
static void make_chain(size_t n, bool held)
{
    UNIT_TRUE(scene_create(&scene, n));
    UNIT_TRUE(scene_add_kind(&scene, 1, 0));
    for (size_t i = 0; i < n; ++i)
        scene.position[i] = (double)i;
    for (size_t k = 0; k < 3; ++k)
        scene.freedom[k * n] = !held;
    for (size_t i = 1; i < n; ++i)
        UNIT_TRUE(scene_add_spring(&scene, i - 1, i, 0, -1));
}

static double farthest_from_length(void)
{
    const size_t n = scene.bodies;
    double worst = 0;
    for (size_t j = 0; j < scene.springs; ++j) {
        const struct scene_spring *s = &scene.spring[j];
        double square = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double d =
                scene.position[k * n + s->b] - scene.position[k * n + s->a];
            square += d * d;
        }
        worst = fmax(worst, fabs(sqrt(square) - s->rest));
    }
    return worst;
}

static double energy(void)
{
    const size_t n = scene.bodies;
    double sum = 0;
    for (size_t c = 0; c < 3 * n; ++c)
        sum +=
            scene.mass[c % n] * scene.velocity[c] * scene.velocity[c] / 2;
    for (size_t i = 0; i < n; ++i)
        sum += scene.mass[i] * weight * scene.position[2 * n + i];
    return sum;
}

/* Let go from the horizontal with g = l = 1 it is at the bottom after
   K(1/sqrt 2) = 1.8540746773013719 (the lemniscate's constant over sqrt 2),
   where v = sqrt 2. A quarter of the error for half the step. */
TEST(test_pendulum, "a pendulum of a rod has its period, in second order")
{
    double miss[2];
    weight = 1;
    for (int k = 0; k < 2; ++k) {
        const int steps = 400 << k;
        make_chain(2, true);
        scene.mass[1] = 2;
        begin();
        UNIT_TRUE(run(1.8540746773013719 / steps, steps));
        miss[k] = scene.position[1];
        UNIT_NEAR(scene.velocity[1], -sqrt(2), 1e-5);
        UNIT_NEAR(farthest_from_length(), 0, 1e-14);
        end();
    }
    UNIT_NEAR(miss[0], 0, 1e-5);
    UNIT_NEAR(miss[0] / miss[1], 4, 0.05);
}

/* A free triangle turns for ever: lengths, momentum, spin and energy. */
TEST(test_triangle, "a triangle of rods turns and flies")
{
    weight = 0;
    make_chain(3, false);
    scene.position[2] = 0.5;
    scene.position[5] = 1;
    scene.spring[1].rest = sqrt(1.25);
    UNIT_TRUE(scene_add_spring(&scene, 0, 2, 0, -1));
    scene.mass[1] = 3;
    PUT(scene.velocity + 6, 0.5, -0.25, 1);
    begin();
    UNIT_TRUE(rods_project(&rods, scene.position, scene.velocity));
    const double before = energy();
    UNIT_TRUE(run(0.01, 2000));
    UNIT_NEAR(energy(), before, 1e-4 * before);
    UNIT_NEAR(farthest_from_length(), 0, 1e-13);
    const double *v = scene.velocity;
    UNIT_NEAR(v[0] + 3 * v[1] + v[2], 0, 1e-11);
    UNIT_NEAR(v[6] + 3 * v[7] + v[8], 0.75, 1e-11);
    end();
}

/* Ten links far from the origin, for long, and back again. */
TEST(test_chain, "a chain of ten keeps its lengths, and comes back")
{
    weight = 1;
    make_chain(11, true);
    for (size_t i = 0; i < 11; ++i)
        scene.position[i] += 1000;
    begin();
    const double before = energy();
    UNIT_TRUE(run(0.005, 400));
    UNIT_NEAR(energy(), before, 1e-3);
    UNIT_NEAR(farthest_from_length(), 0, 1e-11);
    for (size_t c = 0; c < 33; ++c)
        scene.velocity[c] = -scene.velocity[c];
    UNIT_TRUE(run(0.005, 400));
    for (size_t i = 0; i < 11; ++i) {
        UNIT_NEAR(scene.position[i], 1000 + (double)i, 1e-7);
        UNIT_NEAR(scene.position[22 + i], 0, 1e-7);
    }
    end();
}

/* The pendulum would have to turn by more than a quarter in a step. */
TEST(test_too_long, "a step that is too long is refused")
{
    weight = 1;
    make_chain(2, true);
    scene.velocity[5] = -3;
    begin();
    UNIT_TRUE(!run(1, 1));
    end();
}

TEST(test_counts, "forces are asked for once in a step")
{
    weight = 1;
    make_chain(2, true);
    begin();
    UNIT_TRUE(run(0.01, 10));
    UNIT_EQUAL(rods.evaluations, 11);
    scene.position[2 * 2 + 1] = nextafter(scene.position[2 * 2 + 1], 1);
    UNIT_TRUE(run(0.01, 1));
    UNIT_EQUAL(rods.evaluations, 13);
    end();
}

/* What rests without weight asks for its forces once, and is corrected
   nowhere. A single rod is mended by one correction, whatever rounding has
   left of its ends' velocities, which here should be 0. */
TEST(test_at_once, "what needs little gets little")
{
    weight = 0;
    make_chain(4, false);
    begin();
    UNIT_TRUE(run(0.01, 10));
    UNIT_EQUAL(rods.evaluations, 1);
    UNIT_EQUAL(rods.corrections, 0);
    end();
    for (int k = 1; k < 20; ++k) {
        make_chain(2, false);
        scene.mass[1] = 1 + 0.3 * k;
        for (size_t c = 0; c < 6; c += 2) {
            scene.position[c + 1] = 0.1 + 0.17 * (double)c * k;
            scene.velocity[c + 1] = 0.7 * scene.position[c + 1];
            scene.velocity[c] = -scene.mass[1] * scene.velocity[c + 1];
        }
        begin();
        UNIT_TRUE(rods_project(&rods, scene.position, scene.velocity));
        UNIT_EQUAL(rods.corrections, 1);
        end();
    }
}

/* Three in a row with a rod from end to end can only turn as one: where the
   middle moves off, no lengths are right. In a triangle that is nearly so
   flat velocities are found as slowly. Both are given up after 4000 rounds
   of the three rods. */
TEST(test_given_up, "what cannot be mended is given up")
{
    weight = 0;
    make_chain(3, false);
    UNIT_TRUE(scene_add_spring(&scene, 0, 2, 0, -1));
    scene.velocity[4] = 1;
    begin();
    UNIT_TRUE(!rods_step(&rods, 0.01, scene.position, scene.velocity));
    UNIT_EQUAL(rods.corrections, 12000);
    end();
    make_chain(3, false);
    UNIT_TRUE(scene_add_spring(&scene, 0, 2, 0, -1));
    scene.position[4] = 1e-3;
    scene.velocity[4] = 1;
    begin();
    UNIT_TRUE(!rods_project(&rods, scene.position, scene.velocity));
    UNIT_EQUAL(rods.corrections, 12000);
    end();
}
