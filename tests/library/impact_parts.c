/* What contacts are looked for with: how far a step may go, along which
   axis bodies are sorted, where a curve in Bernstein's form goes below 0,
   how near it comes to that, and what counts as rounding; all by hand. */
#include "unit.h"

#include <forces/impact.c> /* of src: the parts */

#include "forces/motion.h"

static struct scene scene;
static struct stepping stepping;
static struct impact impact;

static void make(size_t n)
{
    UNIT_MUST(scene_create(&scene, n));
    for (size_t i = 0; i < n; ++i)
        scene.position[i] = (double)i;
    stepping = (struct stepping){.forces = {.size = 3 * n}};
    impact = (struct impact){.scene = &scene, .stepping = &stepping};
}

/* No further than the space is wide, or the bodies spread; than 2^14 of the
   smallest radius, points not counted; and in a periodic box than a quarter
   of a side less the largest radius, or a 64th of it if that is more. */
TEST(test_way, "how far a step may go")
{
    make(4);
    UNIT_EQUAL(longest_way(&impact), 3);
    scene.position[8] = -1.5; /* z of the first */
    scene.position[9] = 2.5;
    UNIT_EQUAL(longest_way(&impact), 4);
    scene.radius[1] = 0x1p-13;
    scene.radius[3] = 0x1p-14;
    UNIT_EQUAL(longest_way(&impact), 1);
    scene.radius[3] = 0x1p-13;
    UNIT_EQUAL(longest_way(&impact), 2);
    scene.radius[3] = 1;
    scene.radius[1] = 0;
    UNIT_EQUAL(longest_way(&impact), 4);
    WALLS(scene, 1, SCENE_HARD, -2, 5);
    UNIT_EQUAL(longest_way(&impact), 7);
    WALLS(scene, 2, SCENE_PERIODIC, -10, 6);
    UNIT_EQUAL(longest_way(&impact), 3);
    WALLS(scene, 2, SCENE_PERIODIC, 0, 4);
    UNIT_EQUAL(longest_way(&impact), 0.0625);
    scene_free(&scene);
    make(1);
    UNIT_TRUE(isinf(longest_way(&impact)));
    scene.radius[0] = 1;
    UNIT_EQUAL(longest_way(&impact), 0x1p14);
    scene_free(&scene);
}

/* As long as the way takes with the largest velocity, or with the largest
   acceleration from rest if that is sooner, once it is known. */
TEST(test_step, "and how long it may take")
{
    double v[10] = {[9] = 9}, a[10] = {[9] = 99}; /* no part of it */
    struct adaptive own = {.forces = {.size = 9}, .to = {.v = v, .a = a}};
    make(3); /* the way is 2 m */
    stepping.own = &own;
    UNIT_TRUE(isinf(longest_step(&impact)));
    v[4] = -0.5;
    a[3] = -32;
    UNIT_EQUAL(longest_step(&impact), 4);
    own.begun = true;
    UNIT_EQUAL(longest_step(&impact), sqrt(4 / 32.0));
    a[3] = -0.2;
    UNIT_EQUAL(longest_step(&impact), 4);
    a[3] = -0.3;
    UNIT_EQUAL(longest_step(&impact), sqrt(4 / 0.3));
    v[4] = 0;
    a[3] = 0.25;
    UNIT_EQUAL(longest_step(&impact), 4);
    scene_free(&scene);
}

TEST(test_axis, "bodies are sorted where they spread")
{
    make(3);
    UNIT_EQUAL(widest_axis(&scene), 0);
    scene.position[3] = -1;
    scene.position[5] = 1.5;
    UNIT_EQUAL(widest_axis(&scene), 1);
    WALLS(scene, 1, SCENE_PERIODIC, -2, 2);
    UNIT_EQUAL(widest_axis(&scene), 0);
    WALLS(scene, 0, SCENE_PERIODIC, -2, 2);
    UNIT_EQUAL(widest_axis(&scene), 3);
    WALLS(scene, 0, SCENE_HARD, -2, 2);
    UNIT_EQUAL(widest_axis(&scene), 0);
    scene_free(&scene);
}

/* s0 + s1 t + s2 t^2 + s3 t^3 by its control points. */
static void curve(double s0, double s1, double s2, double s3, double q[4])
{
    q[0] = s0;
    q[1] = s0 + s1 / 3;
    q[2] = s0 + 2 * s1 / 3 + s2 / 3;
    q[3] = s0 + s1 + s2 + s3;
}

/* (t - a) (t - b) (c - t) times f. */
static void cubic(double a, double b, double c, double f, double q[4])
{
    curve(f * a * b * c, -f * (a * b + a * c + b * c), f * (a + b + c), -f,
          q);
}

/* Roots to 2^-24, the first of several, on either side of the middle; none
   where the curve only nears 0, or goes below it by rounding alone. */
TEST(test_roots, "the first root of a curve")
{
    double q[4];
    for (double a = 0.01; a < 0.9; a += 0.07) {
        cubic(a, a + 0.1, 3, 1, q);
        UNIT_NEAR(root_first(q, 3, 0, ROOT_HALVINGS), a, 0x1p-24);
    }
    cubic(0.4, 0.4, 3, 1, q); /* it touches */
    UNIT_TRUE(root_first(q, 3, 1e-12, ROOT_HALVINGS) > 1);
    cubic(0.4, 0.5, 3, 1, q); /* as low as some -.0064 */
    UNIT_TRUE(root_first(q, 3, 7e-3, ROOT_HALVINGS) > 1);
    UNIT_TRUE(root_first(q, 3, 5e-3, ROOT_HALVINGS) < 1);
    cubic(-1, 1.1, 1.2, -1, q);
    UNIT_TRUE(root_first(q, 3, 0, ROOT_HALVINGS) > 1);
    /* Closed at the start, and open up to 0.3; but for rounding. */
    cubic(0, 0.3, 2, -1, q);
    UNIT_NEAR(root_next(q, 3, 0.6, 0), 0.3, 0x1p-24);
    cubic(0, 0.3, 2, -1, q);
    for (int j = 0; j < 4; ++j)
        q[j] += 1e-9;
    UNIT_NEAR(root_next(q, 3, 0.6, 0), 0.3, 0x1p-24);
}

/* The control points of a pair's distance squared, by what they are for two
   that pass each other on straight lines: a parabola, raised to degree 6;
   and those of a wall's gap, from either side. */
TEST(test_points, "control points of gaps")
{
    double control[30 * 2] = {0}, q[DEGREE + 1];
    struct impact_gap g = {.a = 0, .b = 1, .sum = 2};
    make(2);
    impact.control = control;
    impact.degree = 3;
    for (size_t j = 0; j < 4; ++j) {
        control[j] = (double)j;          /* x of 0: 0 to 3 */
        control[10 + j] = 5 - (double)j; /* x of 1: 5 to 2 */
        control[50 + j] = 2;             /* z of 1 */
    }
    g.image[1] = 7;
    UNIT_EQUAL(pair_points(&impact, &g, q), 6);
    /* (5 - 6 t)^2 + 7^2 + 2^2 - 2^2 = 74 - 60 t + 36 t^2 */
    for (int j = 0; j < 7; ++j)
        UNIT_NEAR(q[j], 74 - 10 * j + 36 * j * (j - 1) / 30.0, 1e-13);
    g = (struct impact_gap){.a = 1, .b = 1, .side = 1, .edge = 9};
    UNIT_EQUAL(wall_points(&impact, &g, q), 3);
    UNIT_EQUAL(q[0], 4);
    UNIT_EQUAL(q[3], 7);
    g = (struct impact_gap){.a = 1, .b = 1, .axis = 2, .side = -1};
    wall_points(&impact, &g, q);
    UNIT_EQUAL(q[2], 2);
    scene_free(&scene);
}

/* What is noticed of a curve whose least value so far has been `least`. */
static double noticed(const double q[4], double least, double unit,
                      double rounding)
{
    impact.least = least;
    notice(&impact, q, 3, unit, rounding);
    return impact.least;
}

/* A gap that widens up to 0.2 and nearly closes at 0.8: its slope there is
   3 (t - 0.2) (t - 0.8), its depth below the start 0.064. It counts in
   units, below 0 only if it is more than rounding; not where it is not so
   near as another one, or nearest at an end. Control points are off a curve
   by an eighth of 2^-48 times its bend. */
TEST(test_notice, "what nearly closes is noticed")
{
    static const double by[] = {1e-5, -1e-5, 1e-9, -1e-9, 9e-4, -9e-4};
    double q[4];
    for (size_t k = 0; k < sizeof by / sizeof *by; ++k) {
        curve(0.064 + by[k], 0.48, -1.5, 1, q);
        UNIT_NEAR(noticed(q, 1e-3, 1, 0), by[k], 1e-14);
        UNIT_NEAR(noticed(q, -1e-3, 1, 0), by[k], 1e-14);
        UNIT_NEAR(noticed(q, 1e-3, 2, 0), by[k] / 2, 1e-14);
        UNIT_EQUAL(noticed(q, 0.99 * fabs(by[k]), 1, 0),
                   0.99 * fabs(by[k]));
        UNIT_NEAR(noticed(q, 1e-3, 1, 0.45 * fabs(by[k])), by[k], 1e-14);
        UNIT_NEAR(noticed(q, 1e-3, 1, 0.55 * fabs(by[k])), fmax(by[k], 0),
                  1e-14);
    }
    curve(0.066, 0.48, -1.5, 1, q);
    UNIT_EQUAL(noticed(q, 1e-3, 1, 0), 1e-3);
    curve(5e-4, -1, 1000, 0, q); /* it starts near, and comes nearer */
    UNIT_NEAR(noticed(q, 1e-3, 1, 0), 5e-4 - 1 / 4000.0, 1e-12);
    curve(1, -0.9999, 0, 0, q);
    UNIT_EQUAL(noticed(q, 1e-3, 1, 0), 1e-3);
    curve(1e-4, 1, 0, 0, q);
    UNIT_EQUAL(noticed(q, 1e-3, 1, 0), 1e-3);
}

/* Velocities are rounded by 2^-50 of the largest one of a pair's; one at a
   wall is what it is. */
TEST(test_rounding, "what of a rate is rounding")
{
    static const double v[] = {0, 1, 9, 0, -3, 9, 2, 0, 9, 9, 9, 9};
    struct impact_gap g = {.a = 0, .b = 1};
    make(3);
    UNIT_EQUAL(rate_rounding(&impact, &g, v), 3 * 0x1p-50);
    g.a = 1, g.b = 0;
    UNIT_EQUAL(rate_rounding(&impact, &g, v), 3 * 0x1p-50);
    g.b = 1;
    UNIT_EQUAL(rate_rounding(&impact, &g, v), 0);
    scene_free(&scene);
}

/* What counts as nothing in a gap: 2^-50 of the largest coordinate on the
   paths of both, and of the radii, whichever axis it lies on. */
TEST(test_slack, "what of a gap is")
{
    for (int far = 0; far < 6; ++far) {
        ENDED(motion) m;
        CREATED(scene, s, 2);
        s.contact = true;
        s.dt = 1;
        PUT(s.radius, 0.5, 0.25);
        s.position[1] = 1;
        s.velocity[0] = 1;
        const size_t k = (size_t)far / 2;
        const double by = far % 2 ? 100 : -100;
        s.position[2 * k] += by;
        s.position[2 * k + 1] += by;
        s.velocity[2 * k] += 3;
        s.velocity[2 * k + 1] += 3;
        UNIT_MUST(motion_begin(&m, "impact", &s, "leapfrog", 0) &&
                  motion_locate(&m));
        motion_run(&m, 1);
        double most = 0; /* the paths' ends, and what surrounds them */
        for (size_t c = 0; c < 6; ++c)
            most = fmax(
                most, fmax(fabs(m.impact.low[c]), fabs(m.impact.high[c])));
        UNIT_TRUE(m.impact.gaps > 0);
        for (size_t i = 0; i < m.impact.gaps; ++i) {
            const struct impact_gap *g = &m.impact.gap[i];
            if (!is_wall(g))
                UNIT_EQUAL(g->rounding, 0x1p-50 * (most + 0.75));
        }
    }
}

TEST(test_slack_at_0, "and of a point at a wall at 0")
{
    ENDED(motion) m;
    CREATED(scene, s, 2);
    s.contact = true;
    s.wall[0] = SCENE_HARD;
    s.high[0] = 100;
    s.position[1] = 50;
    s.radius[1] = 1;
    s.velocity[0] = 1;
    s.gravity[0] = -8;
    s.dt = 1;
    UNIT_MUST(motion_begin(&m, "impact", &s, "leapfrog", 0) &&
              motion_locate(&m));
    motion_run(&m, 1);
    UNIT_MUST(m.impact.gaps == 1);
    UNIT_EQUAL(m.impact.gap->rounding,
               0x1p-50 * (*m.impact.high - *m.impact.low));
    UNIT_EQUAL(m.impact.low[3], -1 - 0x1p-50); /* a box round body 1 */
}
