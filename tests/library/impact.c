/* Contacts at their moments: a bouncing ball against its closed form, up to
   its last bounce; each method keeps its order through contacts; a thousand
   times the steps say the same; what rests, grazes, comes at once, crowds;
   steps of their own length meet what short steps meet.
 */
#include "unit.h"

#include "forces/largest.h"
#include "forces/motion.h"
#include "toolbox/random.h"

static void make(struct scene *s, size_t bodies, double dt)
{
    UNIT_MUST(scene_create(s, bodies));
    s->contact = true;
    s->dt = dt;
    for (size_t i = 0; i < bodies; ++i)
        s->radius[i] = 0.125;
}

static void begin(struct motion *m, struct scene *s, const char *method,
                  bool located)
{
    if (!motion_begin(m, "impact", s, method, 0) ||
        (located && !motion_locate(m)))
        exit(1);
    m->stepping.tolerance = 1e-13; /* of adaptive ones */
}

/* A ball 1 m above its floor at z = 0 falls at 2 m/s^2: for 1 s, then up
   and down in 2 s. */
static void drop(struct motion *m, struct scene *s, const char *method,
                 double e, double dt)
{
    make(s, 1, dt);
    WALLS(*s, 2, SCENE_HARD, -0.125, 100);
    s->position[2] = 1;
    s->gravity[2] = -2;
    s->restitution = e;
    begin(m, s, method, true);
}

/* The step divides nothing. 31 100 velocities are rounded by 1e-16 m/s, a
   walk to 2e-14 m/s, of which 1000 bounces make a delay of 1e-11 s. */
static void bounce(const char *method, double tolerance)
{
    FREED(scene) s;
    STARTED(motion, m, drop(&m, &s, method, 1, 0.064375));
    m.stepping.tolerance = tolerance;
    for (int k = 0; k < 311; ++k) {
        motion_run(&m, 100);
        const double since = fmod(motion_time(&m) + 1, 2);
        UNIT_NEAR(s.position[2], since * (2 - since), 2e-11);
    }
    UNIT_EQUAL(m.collisions, 1001);
}

TEST(test_thousand, "a thousand bounces")
{
    bounce("leapfrog", 0);
    bounce("dopri5", 1e-13);
    bounce("radau15", 1e-13);
    bounce("radau15", 0); /* steps of one length, begun anew */
}

/* Its last bounce is at 1 (1 + e) / (1 - e) = 9 s. It rests when it would
   rise by less than rounding, 1e-16 m: at 2e-8 m/s, 1e-7 s earlier. */
static void come_to_rest(const char *method)
{
    FREED(scene) s;
    STARTED(motion, m, drop(&m, &s, method, 0.8, 0.03125));
    motion_run(&m, 287);
    UNIT_TRUE(motion_shorten(&m, 9 - 0x1p-20 - motion_time(&m)));
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(m.impact.resting, 0);
    UNIT_TRUE(motion_shorten(&m, 0x1p-19));
    UNIT_EQUAL(motion_run(&m, 100000), STEPPING_DONE);
    UNIT_EQUAL(m.impact.resting, 1);
    UNIT_EQUAL(s.position[2], 0);
    UNIT_EQUAL(s.velocity[2], 0);
}

TEST(test_last_bounce, "the last bounce of e = 0.8")
{
    come_to_rest("leapfrog");
    come_to_rest("radau15");
}

static void make_three(struct scene *s, double k2, double dt)
{
    static const double x[] = {-0.6,  0.1, 0.7, 0,  0.05,
                               -0.05, 0.5, 0.9, 0.4},
                        v[] = {1.1, -0.5, -0.9, 0.2, -0.1,
                               0.1, 0.3,  0.2,  1};
    make(s, 3, dt);
    for (size_t c = 0; c < 9; ++c) {
        s->position[c] = x[c];
        s->velocity[c] = v[c];
    }
    PUT(s->mass + 1, 2, 0.5);
    for (size_t k = 0; k < 3; ++k)
        WALLS(*s, k, SCENE_HARD, k < 2 ? -1 : 0, k < 2 ? 1 : 2);
    s->gravity[2] = -2;
    s->k2 = k2;
    s->softening = 0.2;
}

/* Where they are after 1 s, by so many steps. Returns the collisions. */
static double run_three(const char *method, double k2, bool located,
                        uint64_t steps, double x[9])
{
    MADE(scene, s, make_three(&s, k2, 1.0 / (double)steps));
    STARTED(motion, m, begin(&m, &s, method, located));
    m.spheres.rule = SPHERES_APPROACHING;
    m.spheres.shift = SPHERES_BACK;
    UNIT_EQUAL(motion_run(&m, steps), STEPPING_DONE);
    memcpy(x, s.position, 9 * sizeof *x);
    return m.collisions;
}

/* How much a quarter of the step helps, as a power of 4. */
static double order_of(const char *method, uint64_t steps, bool located)
{
    double exact[9], x[9], y[9];
    run_three("kahan-li8", 0.5, true, 1024, exact);
    run_three(method, 0.5, located, steps, x);
    run_three(method, 0.5, located, 4 * steps, y);
    return log2(largest_difference(x, exact, 9) /
                largest_difference(y, exact, 9)) /
           2;
}

/* The next term of an error in powers of the step may take a quarter, and
   one where contacts divide steps that are long. */
TEST(test_orders, "methods keep their order")
{
    UNIT_NEAR(order_of("leapfrog", 256, true), 2, 0.25);
    UNIT_NEAR(order_of("rk4", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("pefrl", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("gauss4", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("kahan-li8", 12, true), 8, 1);
}

/* Without attraction leapfrog's path is exact. A thousand times the steps,
   going back, are wrong by a collision's share of a step's way. */
TEST(test_steps, "a thousand times the steps agree")
{
    double x[9], y[9], fine[9];
    const double met = run_three("leapfrog", 0, true, 256, x);
    UNIT_EQUAL(met, run_three("leapfrog", 0, true, 300, y));
    UNIT_NEAR(largest_difference(x, y, 9), 0, 1e-13);
    UNIT_EQUAL(met, run_three("leapfrog", 0, false, 256000, fine));
    UNIT_NEAR(largest_difference(x, fine, 9), 0, 1e-5);
}

/* Leapfrog's way from a spring at rest is straight in its first step, but
   the path through its ends is ahead by half of s s (1 - s) of 1 m, and the
   body on the spring seems to come to the wall at 0.44 s; by leapfrog it
   comes at 0.53 s. The free one is there at 0.5 s, and turns round then.
   Its gap is shut to 2^-53 of place and radius, 2.25 m, which the way home
   has twice; with three sums of up to 2 m, rounded by 1.1e-16 m each, that
   is 8.3e-16 m. */
TEST(test_hidden, "an earlier root, hidden")
{
    MADE(scene, s, make(&s, 3, 1));
    WALLS(s, 0, SCENE_HARD, -5, 2.125);
    PUT(s.position, 1.5, 1.46875, -0.53125);
    s.position[3 + 1] = s.position[3 + 2] = 3;
    s.velocity[0] = s.velocity[1] = 1;
    s.freedom[2] = s.freedom[3 + 2] = s.freedom[6 + 2] = 0;
    UNIT_TRUE(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 1, 2, 0, 2));
    STARTED(motion, m, begin(&m, &s, "leapfrog", true));
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(m.collisions, 2);
    UNIT_NEAR(s.position[0], 1.5, 1e-15);
}

/* A ball meets an equal one on a spring and stops; that one comes back
   after half a period, pi/2 s, and sends it home. At 1 m/s each of the two
   moments may be wrong by what counts as nothing there, 2^-50 of 1.25 m in
   s, and the way home has it twice: 4.4e-15 m. The rest are the sums of 16
   steps, 1.1e-16 m each, and half a period of a spring to 1e-15. */
TEST(test_sprung, "a ball meets a sprung one")
{
    static const char *const methods[] = {"radau15", "dopri5"};
    for (int k = 0; k < 2; ++k) {
        MADE(scene, s, make(&s, 3, 0.25));
        PUT(s.position, -0.5, 1, 2);
        s.velocity[0] = 1;
        s.freedom[2] = s.freedom[3 + 2] = s.freedom[6 + 2] = 0;
        UNIT_TRUE(scene_add_kind(&s, 4, 0) &&
                  scene_add_spring(&s, 1, 2, 0, 1));
        STARTED(motion, m, begin(&m, &s, methods[k], true));
        UNIT_EQUAL(motion_run(&m, 16), STEPPING_DONE);
        UNIT_EQUAL(m.collisions, 2);
        UNIT_NEAR(s.position[0], 0.75 - 2.75 + acos(-1) / 2,
                  k == 0 ? 1e-14 : 1e-11);
        UNIT_NEAR(s.velocity[0], -1, k == 0 ? 1e-14 : 1e-11);
    }
}

/* Its own steps carry the three attracting balls as far as 1024 of order
   eight, whose error is some 1e-13 m; looks change no bit of that. */
TEST(test_own_steps, "steps of their own length")
{
    double exact[9], x[9], y[9];
    const double met = run_three("kahan-li8", 0.5, true, 1024, exact);
    UNIT_EQUAL(met, run_three("radau15", 0.5, true, 4, x));
    UNIT_EQUAL(met, run_three("radau15", 0.5, true, 64, y));
    UNIT_NEAR(largest_difference(x, exact, 9), 0, 2e-12);
    UNIT_EQUAL(largest_difference(x, y, 9), 0);
}

TEST(test_same_bits, "without contact the same bits")
{
    for (int way = 0; way < 2; ++way) {
        static double x[9];
        MADE(scene, s, make_three(&s, 0.5, 0.01));
        STARTED(motion, m, begin(&m, &s, "rk4", way == 1));
        motion_run(&m, 15);
        UNIT_EQUAL(m.collisions, 0);
        for (size_t c = 0; way == 1 && c < 9; ++c)
            UNIT_EQUAL(s.position[c], x[c]);
        memcpy(x, s.position, sizeof x);
    }
}

TEST(test_at_once, "a row that touches, at once")
{
    MADE(scene, s, make(&s, 5, 0.5));
    for (size_t i = 0; i < 5; ++i)
        s.position[i] = i > 0 ? (double)i / 4 : -1;
    s.velocity[0] = 4;
    STARTED(motion, m, begin(&m, &s, "leapfrog", true));
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(m.collisions, 4);
    UNIT_EQUAL(m.impact.simultaneous, 3);
    UNIT_EQUAL(s.position[4], 2);
    UNIT_EQUAL(s.velocity[4], 4);
}

TEST(test_touching, "two that touch already")
{
    static const char *const methods[] = {"leapfrog", "rk4", "radau15"};
    for (int k = 0; k < 3; ++k) {
        MADE(scene, s, make(&s, 2, 0.5));
        s.position[1] = 0.25;
        PUT(s.velocity, 1, -1);
        STARTED(motion, m, begin(&m, &s, methods[k], true));
        UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
        UNIT_EQUAL(m.collisions, 1);
        UNIT_LIST(s.position, 0, -0.5, 0.75);
    }
}

/* A body on a spring of omega = 1 leaves its middle at 1 m/s: by leapfrog
   parts of a step go straight, by h, with the velocity 1 - h^2/2; after
   1.45 s it is at 1.45 m, and comes back. The path through the ends comes
   as far as 1.45045 m, past a wall at 1.4503 m, which the method misses.
   That is clear after two looks, and a third puts it to the end. */
TEST(test_missed, "a wall that only the path meets")
{
    MADE(scene, s, make(&s, 2, 1.45));
    WALLS(s, 0, SCENE_HARD, -9, 1.4503);
    s.velocity[0] = 1;
    s.radius[0] = s.radius[1] = 0;
    s.freedom[1] = s.freedom[2 + 1] = s.freedom[4 + 1] = 0;
    UNIT_TRUE(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 0));
    STARTED(motion, m, begin(&m, &s, "leapfrog", true));
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(m.collisions, 0);
    UNIT_EQUAL(m.impact.grazing, 1);
    UNIT_EQUAL(s.position[0], 1.45);
    UNIT_TRUE(m.stepping.evaluations < 10);
}

/* Across a periodic box of 2 m two balls at 0.7 m and -0.7 m have a gap of
   0.35 m: at 1 m/s they meet after 0.175 s, and are back at 0.55 m after
   0.5 s. Along every axis, whichever comes first. */
TEST(test_across, "two meet across a periodic box")
{
    for (size_t k = 0; k < 3; ++k)
        for (size_t first = 0; first < 2; ++first) {
            MADE(scene, s, make(&s, 2, 0.5));
            WALLS(s, k, SCENE_PERIODIC, -1, 1);
            s.position[2 * k + first] = 0.7;
            s.velocity[2 * k + first] = 1;
            s.position[2 * k + 1 - first] = -0.7;
            s.velocity[2 * k + 1 - first] = -1;
            STARTED(motion, m, begin(&m, &s, "leapfrog", true));
            UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
            UNIT_EQUAL(m.collisions, 1);
            UNIT_NEAR(s.position[2 * k + first], 0.55, 4e-15);
            UNIT_NEAR(s.position[2 * k + 1 - first], -0.55, 4e-15);
        }
}

/* Two that pass: what is nearer than they are wide collides, what touches
   does not. */
TEST(test_graze, "to touch is not to collide")
{
    for (int nearer = 0; nearer < 2; ++nearer) {
        MADE(scene, s, make(&s, 2, 0.7));
        s.position[0] = -1;
        s.position[2 + 1] = nearer ? 0.25 - 0x1p-20 : 0.25;
        s.velocity[0] = 1;
        STARTED(motion, m, begin(&m, &s, "leapfrog", true));
        UNIT_EQUAL(motion_run(&m, 3), STEPPING_DONE);
        UNIT_EQUAL(m.collisions, nearer);
    }
}

/* Three of e = 0.9 come down, some on each other, and rest on the floor, or
   are thrown up again: nobody gets into it. */
TEST(test_heap, "nobody gets into the floor")
{
    static const double x[] = {0, 0.01, -0.02};
    MADE(scene, s, make(&s, 3, 0.01));
    for (size_t k = 0; k < 3; ++k)
        WALLS(s, k, SCENE_HARD, k < 2 ? -1 : 0, k < 2 ? 1 : 3);
    for (size_t i = 0; i < 3; ++i) {
        s.position[i] = x[i];
        s.position[6 + i] = 0.5 + 0.5 * (double)i;
    }
    s.gravity[2] = -2;
    s.restitution = 0.9;
    STARTED(motion, m, begin(&m, &s, "leapfrog", true));
    double lowest = 1;
    for (int k = 0; k < 4000; ++k) {
        UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
        for (size_t i = 0; i < 3; ++i)
            lowest = fmin(lowest, s.position[6 + i]);
    }
    UNIT_EQUAL(lowest, 0.125);
    UNIT_EQUAL(m.impact.resting, 3);
}

/* A rest that no wall gives: two that attract each other. */
TEST(test_crowd, "two that rest on each other crowd")
{
    MADE(scene, s, make(&s, 2, 0.01));
    s.position[1] = 1;
    s.k2 = 1;
    s.restitution = 0.5;
    STARTED(motion, m, begin(&m, &s, "rk4", true));
    UNIT_EQUAL(motion_run(&m, 1000), STEPPING_STUCK);
    UNIT_TRUE(m.impact.crowded);
    UNIT_EQUAL(m.impact.between[1], 1);
}

TEST(test_resume, "what rests is resumed")
{
    FREED(scene) s, saved;
    STARTED(motion, m, drop(&m, &s, "leapfrog", 0.5, 0.01));
    s.velocity[0] = 0.1;
    motion_run(&m, 500);
    UNIT_EQUAL(m.impact.resting, 1);
    UNIT_TRUE(motion_note(&m) && scene_copy(&saved, &s));
    STARTED(motion, again, begin(&again, &saved, "leapfrog", true));
    motion_run(&m, 50);
    motion_run(&again, 50);
    for (size_t c = 0; c < 3; ++c)
        UNIT_EQUAL(saved.position[c], s.position[c]);
    UNIT_EQUAL(again.impact.resting, 1);
    UNIT_EQUAL(saved.velocity[2], 0);
}

/* A body on a spring of omega = 1 swings by 1 m, before a wall that stands
   `before` m in front of where it would turn. Returns how wrong its place
   is after 20 s: what it does not pass of its circle it leaps over. */
static double swing(const char *method, double before, double steps)
{
    const double pi = acos(-1), leap = acos(1 - before);
    double angle = pi + 20;
    uint64_t met = 0;
    MADE(scene, s, make(&s, 2, 20 / steps));
    WALLS(s, 0, SCENE_HARD, -9, 1 - before);
    s.position[0] = -1;
    s.radius[0] = s.radius[1] = 0;
    s.freedom[1] = s.freedom[2 + 1] = s.freedom[4 + 1] = 0;
    UNIT_TRUE(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 0));
    STARTED(motion, m, begin(&m, &s, method, true));
    UNIT_EQUAL(motion_run(&m, (uint64_t)steps), STEPPING_DONE);
    for (; angle > 2 * pi - leap; ++met)
        angle -= 2 * (pi - leap);
    UNIT_EQUAL(m.collisions, met);
    return fabs(s.position[0] - cos(angle));
}

/* Nothing is too shallow to be seen by a step as long as half a radian.
   Rounding, 1e-15 m, moves a moment by that over the speed, and each of up
   to three moments moves the next ones. dopri5's tolerance lets its places
   be wrong by 1e-11 m. */
TEST(test_shallow, "no contact is too shallow")
{
    for (double before = 0.1; before > 1e-13; before /= 10) {
        const double speed = sqrt(2 * before);
        UNIT_NEAR(swing("radau15", before, 8), 0, 1e-14 + 3e-15 / speed);
        UNIT_NEAR(swing("dopri5", before, 8), 0, 1e-11 / speed);
    }
}

/* How much a ball of this radius, dropped from 1 m, has asked of radau15
   after so many steps of half a second. Its floor stands so far below 0. */
static struct motion drop_far(double radius, uint64_t steps)
{
    MADE(scene, s, make(&s, 1, 0.5));
    WALLS(s, 2, SCENE_HARD, -radius, 100);
    s.radius[0] = radius;
    s.position[2] = 1;
    s.gravity[2] = -2;
    s.restitution = 0.8;
    STARTED(motion, m, begin(&m, &s, "radau15", true));
    UNIT_EQUAL(motion_run(&m, steps), STEPPING_DONE);
    /* A copy, as clang 17 returns m itself, after motion_end. */
    const struct motion counts = m;
    return counts;
}

/* What a bounce by steps of their own costs: one step and three or four
   shorter ones, each of a round at seven nodes and its end, as the weight
   is no surprise; and no start from small steps. */
TEST(test_price, "what a bounce costs")
{
    const struct motion m = drop_far(0.1, 24);
    UNIT_EQUAL(m.impact.resting, 1);
    UNIT_TRUE(m.stepping.evaluations < 5 * 8 * m.collisions);
}

/* A small ball comes with the rounding of 1 m to a floor near 0. A gap that
   had to be shut to less would be tried a hundred times, with 8 evaluations
   each. This way it takes some twelve, all steps counted. */
TEST(test_far, "what is far is rounded as such")
{
    const struct motion m = drop_far(0.01, 3);
    UNIT_EQUAL(m.collisions, 1);
    UNIT_TRUE(m.stepping.evaluations < 30 * 8);
}

/* A body that lies on the floor, with a spring on it and another body on
   that, which is thrown up: it is lifted, comes down and is lifted again,
   and never gets into the floor. z: where the two are after 2 s. Returns
   what rests. */
static size_t lift(const char *method, double speed, uint64_t steps,
                   double z[2])
{
    MADE(scene, s, make(&s, 2, 2 / (double)steps));
    WALLS(s, 2, SCENE_HARD, 0, 100);
    for (size_t c = 0; c < 4; ++c)
        s.freedom[c] = 0;
    PUT(s.position + 4, 0.125, 1.025);
    s.velocity[5] = speed;
    s.gravity[2] = -2;
    s.restitution = 0.5;
    UNIT_TRUE(scene_add_kind(&s, 20, 0) &&
              scene_add_spring(&s, 0, 1, 0, 1));
    STARTED(motion, m, begin(&m, &s, method, true));
    for (uint64_t k = 0; k < steps; ++k) {
        UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
        UNIT_TRUE(s.position[4] >= 0.125 * (1 - 0x1p-50));
    }
    memcpy(z, s.position + 4, 2 * sizeof *z);
    return m.impact.resting;
}

/* Forces that take a body off a wall have no bend within a step: a thousand
   steps of order eight and steps of their own say the same, to the 2e-14 of
   (omega dt)^8 and what the last of some thirty bounces makes of it. Steps
   of up to a quarter of a swing come to an end. */
TEST(test_lift, "what rests is lifted")
{
    for (double speed = 0.5; speed < 4; speed += 0.5) {
        double x[2], y[2];
        const size_t resting = lift("radau15", speed, 8, x);
        UNIT_EQUAL(resting, lift("kahan-li8", speed, 1000, y));
        UNIT_LIST(x, 1e-12, y[0], y[1]);
        lift("dopri5", speed, 8, y);
        UNIT_NEAR(x[1], y[1], 1e-10);
    }
}

TEST(test_coarse, "by coarse steps too")
{
    static const char *const methods[] = {"leapfrog", "rk4", "pefrl",
                                          "symplectic-euler"};
    double z[2];
    for (double speed = 0.5; speed < 4; speed += 0.25)
        for (int k = 0; k < 4; ++k) {
            lift(methods[k], speed, 8, z);
            lift(methods[k], speed, 39, z);
        }
}

/* A ball that lies on the floor is hit by a smaller one that slides on it:
   the way from one centre to the other has the slope 3/4, and up goes the
   ball, by its weight alone. */
TEST(test_kicked, "what rests is hit")
{
    static const char *const methods[] = {"leapfrog", "radau15"};
    for (int k = 0; k < 2; ++k) {
        MADE(scene, s, make(&s, 2, 0.5));
        WALLS(s, 2, SCENE_HARD, 0, 100);
        PUT(s.radius, 4, 1);
        PUT(s.position + 4, 4, 1);
        s.position[1] = -6; /* at -4 the centres are 5 apart, after 1 s */
        s.velocity[1] = 2;
        s.mass[1] = 1e9;
        s.gravity[2] = -2;
        STARTED(motion, m, begin(&m, &s, methods[k], true));
        UNIT_EQUAL(motion_run(&m, 3), STEPPING_DONE);
        UNIT_EQUAL(m.impact.resting, 1);
        /* 2 x 2 m/s x 4/5 along (4/5, 3/5), for 0.5 s */
        UNIT_NEAR(s.position[4], 4 + 0.5 * 3.2 * 0.6 - 0.25, 1e-7);
    }
}

/* Is there room for body i among those before it? */
static bool is_free(const struct scene *s, size_t i)
{
    const size_t n = s->bodies;
    for (size_t j = 0; j < i; ++j) {
        double square = 0;
        for (size_t k = 0; k < 3; ++k) {
            double d = s->position[k * n + i] - s->position[k * n + j];
            if (s->wall[k] == SCENE_PERIODIC)
                d -= floor(d / (s->high[k] - s->low[k]) + 0.5) *
                     (s->high[k] - s->low[k]);
            square += d * d;
        }
        if (square < 0.07)
            return false;
    }
    return true;
}

/* A small scene at random: up to four balls on a line, in the plane or in
   space, between walls or in part not; weight, attraction, springs. */
static void make_any(struct scene *s, uint64_t seed)
{
    SEEDED(r, seed);
    const size_t n = 1 + (size_t)random_between(&r, 0, 4);
    const size_t axes = n < 3 ? 1 + seed % 3 : 2 + seed % 2;
    make(s, n, 0.25);
    for (size_t k = 0; k < 3; ++k)
        WALLS(*s, k, SCENE_HARD, -0.6, 0.6 + 0.3 * (double)k);
    if (seed % 5 < 2 && axes > 1)
        s->wall[0] = seed % 5 == 0 ? SCENE_OPEN : SCENE_PERIODIC;
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = random_between(&r, 0.3, 3);
        s->radius[i] = random_between(&r, 0.05, 0.125);
        for (size_t k = axes; k < 3; ++k)
            s->freedom[k * n + i] = 0;
        do
            for (size_t k = 0; k < axes; ++k) {
                s->position[k * n + i] = random_between(&r, -0.45, 0.45);
                s->velocity[k * n + i] = random_between(&r, -1, 1);
            }
        while (!is_free(s, i));
    }
    if (seed % 3 > 0)
        s->gravity[axes - 1] = -random_between(&r, 0, 10);
    if (seed % 7 < 3)
        s->k2 = random_between(&r, 0, 0.5);
    s->softening = 0.05;
    if (seed % 11 < 6 && n > 1 && s->wall[0] != SCENE_PERIODIC)
        UNIT_TRUE(scene_add_kind(s, random_between(&r, 1, 1000), 0) &&
                  scene_add_spring(s, 0, n - 1, 0, 0.3));
    if (seed % 13 < 4)
        s->restitution = random_between(&r, 0.5, 1);
}

static enum stepping_end run_any(uint64_t seed, const char *method,
                                 uint64_t steps, double x[12],
                                 struct motion *counts)
{
    MADE(scene, s, make_any(&s, seed));
    s.dt = 1 / (double)steps;
    STARTED(motion, m, begin(&m, &s, method, true));
    const enum stepping_end ended = motion_run(&m, steps);
    memset(x, 0, 12 * sizeof *x);
    memcpy(x, s.position, 3 * s.bodies * sizeof *x);
    *counts = m;
    return ended;
}

/* Two hundred scenes, 1 s each, against a thousand steps of order eight:
   those are wrong by 1e-10 m where a spring is stiffest, (omega dt)^8 of a
   swing of 1 m, and a collision between balls makes ten times as much of
   it, of which there are a few in a second. Bounces before a rest are too
   many to count, to one or two; and two that would have to rest on each
   other end both. */
TEST(test_any, "two hundred scenes at random")
{
    for (uint64_t seed = 0; seed < 200; ++seed) {
        double x[12], y[12], most = 0;
        struct motion own, fine;
        const enum stepping_end ended =
            run_any(seed, "radau15", 4, x, &own);
        UNIT_EQUAL(ended, run_any(seed, "kahan-li8", 1000, y, &fine));
        UNIT_EQUAL(own.impact.resting, fine.impact.resting);
        if (fine.impact.resting == 0 && ended == STEPPING_DONE)
            UNIT_EQUAL(own.collisions, fine.collisions);
        for (int c = 0; c < 12; ++c)
            most = fmax(most, fabs(x[c] - y[c]));
        if (ended == STEPPING_DONE)
            UNIT_NEAR(most, 0, 1e-7);
    }
}

/* A ball flies past a held one at 1/4 m plus `by`, or rises to as far below
   a ceiling: what is noticed is by, to some roundings of 1 m^2 and the
   square of by, over 2/4 m; but from 1e-3 m on nothing. */
static void notice(const char *method, double by, bool ceiling)
{
    MADE(scene, s, make(&s, ceiling ? 1 : 2, 0.3));
    s.position[0] = ceiling ? 0 : -1;
    s.velocity[0] = ceiling ? 2 : 1;
    if (ceiling) {
        WALLS(s, 0, SCENE_HARD, -9, 1.125 + by);
        s.gravity[0] = -2;
    } else {
        s.position[2] = 0.25 + by;
        s.freedom[1] = s.freedom[3] = s.freedom[5] = false;
    }
    STARTED(motion, m, begin(&m, &s, method, true));
    m.impact.least = 1e-3;
    motion_run(&m, 6);
    UNIT_EQUAL(m.collisions, by < 0);
    UNIT_NEAR(m.impact.least, fabs(by) < 1e-3 ? by : 1e-3,
              1e-15 + 2.1 * by * by);
}

TEST(test_least, "by how little it is")
{
    static const double by[] = {1e-4,  -1e-4,  1e-7, -1e-7,
                                1e-11, -1e-11, 2e-3, -2e-3};
    for (size_t k = 0; k < sizeof by / sizeof *by; ++k)
        for (int ceiling = 0; ceiling < 2; ++ceiling) {
            notice("leapfrog", by[k], ceiling);
            notice("radau15", by[k], ceiling);
        }
}
