/* Contacts at their moments: a bouncing ball against its closed form, up to
   its last bounce; each method keeps its order through contacts; a thousand
   times the steps say the same; what rests, grazes, comes at once, crowds.
 */
#include "unit.h"

#include "forces/largest.h"
#include "forces/motion.h"

#include <stdlib.h>

static void make(struct scene *s, size_t bodies, double dt)
{
    if (!scene_create(s, bodies))
        exit(1);
    s->contact = true;
    s->dt = dt;
    for (size_t i = 0; i < bodies; ++i)
        s->radius[i] = 0.125;
}

static void put_walls(struct scene *s, size_t k, double low, double high)
{
    s->wall[k] = SCENE_HARD;
    s->low[k] = low;
    s->high[k] = high;
}

static void begin(struct motion *m, struct scene *s, const char *method,
                  bool located)
{
    if (!motion_begin(m, "impact", s, method, 0) ||
        (located && !motion_locate(m)))
        exit(1);
}

static void end(struct motion *m, struct scene *s)
{
    motion_end(m);
    scene_free(s);
}

static double count(uint64_t n)
{
    return (double)n;
}

/* A ball 1 m above its floor at z = 0 falls at 2 m/s^2: for 1 s, then up
   and down in 2 s. */
static void drop(struct motion *m, struct scene *s, double e, double dt)
{
    make(s, 1, dt);
    put_walls(s, 2, -0.125, 100);
    s->position[2] = 1;
    s->gravity[2] = -2;
    s->restitution = e;
    begin(m, s, "leapfrog", true);
}

/* The step divides nothing. 31 100 velocities are rounded by 1e-16 m/s, a
   walk to 2e-14 m/s, of which 1000 bounces make a delay of 1e-11 s. */
static void test_thousand(void)
{
    struct scene s;
    struct motion m;
    drop(&m, &s, 1, 0.064375);
    for (int k = 0; k < 311; ++k) {
        motion_run(&m, 100);
        const double since = fmod(motion_time(&m) + 1, 2);
        UNIT_NEAR(s.position[2], since * (2 - since), 2e-11);
    }
    UNIT_EQUAL(count(m.collisions), 1001);
    end(&m, &s);
}

/* Its last bounce is at 1 (1 + e) / (1 - e) = 9 s. It rests when it would
   rise by less than rounding, 1e-16 m: at 2e-8 m/s, 1e-7 s earlier. */
static void test_last_bounce(void)
{
    struct scene s;
    struct motion m;
    drop(&m, &s, 0.8, 0.03125);
    motion_run(&m, 287);
    UNIT_TRUE(motion_shorten(&m, 9 - 0x1p-20 - motion_time(&m)));
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(count(m.impact.resting), 0);
    UNIT_TRUE(motion_shorten(&m, 0x1p-19));
    UNIT_EQUAL(motion_run(&m, 100000), STEPPING_DONE);
    UNIT_EQUAL(count(m.impact.resting), 1);
    UNIT_EQUAL(s.position[2], 0);
    UNIT_EQUAL(s.velocity[2], 0);
    end(&m, &s);
}

/* Three balls that attract each other in a box. */
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
    s->mass[1] = 2;
    s->mass[2] = 0.5;
    for (size_t k = 0; k < 3; ++k)
        put_walls(s, k, k < 2 ? -1 : 0, k < 2 ? 1 : 2);
    s->gravity[2] = -2;
    s->k2 = k2;
    s->softening = 0.2;
}

/* Where they are after 1 s, by so many steps. Returns the collisions. */
static double run_three(const char *method, double k2, bool located,
                        uint64_t steps, double x[9])
{
    struct scene s;
    struct motion m;
    make_three(&s, k2, 1.0 / (double)steps);
    begin(&m, &s, method, located);
    m.spheres.rule = SPHERES_APPROACHING;
    m.spheres.shift = SPHERES_BACK;
    UNIT_EQUAL(motion_run(&m, steps), STEPPING_DONE);
    memcpy(x, s.position, 9 * sizeof *x);
    const double met = count(m.collisions);
    end(&m, &s);
    return met;
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
static void test_orders(void)
{
    UNIT_NEAR(order_of("leapfrog", 256, true), 2, 0.25);
    UNIT_NEAR(order_of("rk4", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("pefrl", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("gauss4", 256, true), 4, 0.25);
    UNIT_NEAR(order_of("kahan-li8", 12, true), 8, 1);
}

/* Without attraction leapfrog's path is exact. A thousand times the steps,
   going back, are wrong by a collision's share of a step's way. */
static void test_steps(void)
{
    double x[9], y[9], fine[9];
    const double met = run_three("leapfrog", 0, true, 256, x);
    UNIT_EQUAL(met, run_three("leapfrog", 0, true, 300, y));
    UNIT_NEAR(largest_difference(x, y, 9), 0, 1e-13);
    UNIT_EQUAL(met, run_three("leapfrog", 0, false, 256000, fine));
    UNIT_NEAR(largest_difference(x, fine, 9), 0, 1e-5);
}

/* No contact, no difference. */
static void test_same_bits(void)
{
    for (int way = 0; way < 2; ++way) {
        static double x[9];
        struct scene s;
        struct motion m;
        make_three(&s, 0.5, 0.01);
        begin(&m, &s, "rk4", way == 1);
        motion_run(&m, 15);
        UNIT_EQUAL(count(m.collisions), 0);
        for (size_t c = 0; way == 1 && c < 9; ++c)
            UNIT_EQUAL(s.position[c], x[c]);
        memcpy(x, s.position, sizeof x);
        end(&m, &s);
    }
}

/* A row that touches: the velocity goes through it at one moment. */
static void test_at_once(void)
{
    struct scene s;
    struct motion m;
    make(&s, 5, 0.5);
    for (size_t i = 0; i < 5; ++i)
        s.position[i] = i > 0 ? (double)i / 4 : -1;
    s.velocity[0] = 4;
    begin(&m, &s, "leapfrog", true);
    UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
    UNIT_EQUAL(count(m.collisions), 4);
    UNIT_EQUAL(count(m.impact.simultaneous), 3);
    UNIT_EQUAL(s.position[4], 2);
    UNIT_EQUAL(s.velocity[4], 4);
    end(&m, &s);
}

/* Two that pass: what is nearer than they are wide collides, what touches
   does not. */
static void test_graze(void)
{
    for (int nearer = 0; nearer < 2; ++nearer) {
        struct scene s;
        struct motion m;
        make(&s, 2, 0.7);
        s.position[0] = -1;
        s.position[2 + 1] = nearer ? 0.25 - 0x1p-20 : 0.25;
        s.velocity[0] = 1;
        begin(&m, &s, "leapfrog", true);
        UNIT_EQUAL(motion_run(&m, 3), STEPPING_DONE);
        UNIT_EQUAL(count(m.collisions), nearer);
        end(&m, &s);
    }
}

/* Three of e = 0.9 come down, some on each other, and rest on the floor, or
   are thrown up again: nobody gets into it. */
static void test_heap(void)
{
    static const double x[] = {0, 0.01, -0.02};
    struct scene s;
    struct motion m;
    make(&s, 3, 0.01);
    for (size_t k = 0; k < 3; ++k)
        put_walls(&s, k, k < 2 ? -1 : 0, k < 2 ? 1 : 3);
    for (size_t i = 0; i < 3; ++i) {
        s.position[i] = x[i];
        s.position[6 + i] = 0.5 + 0.5 * (double)i;
    }
    s.gravity[2] = -2;
    s.restitution = 0.9;
    begin(&m, &s, "leapfrog", true);
    double lowest = 1;
    for (int k = 0; k < 4000; ++k) {
        UNIT_EQUAL(motion_run(&m, 1), STEPPING_DONE);
        for (size_t i = 0; i < 3; ++i)
            lowest = fmin(lowest, s.position[6 + i]);
    }
    UNIT_EQUAL(lowest, 0.125);
    UNIT_EQUAL(count(m.impact.resting), 3);
    end(&m, &s);
}

/* A rest that no wall gives: two that attract each other. */
static void test_crowd(void)
{
    struct scene s;
    struct motion m;
    make(&s, 2, 0.01);
    s.position[1] = 1;
    s.k2 = 1;
    s.restitution = 0.5;
    begin(&m, &s, "rk4", true);
    UNIT_EQUAL(motion_run(&m, 1000), STEPPING_STUCK);
    UNIT_TRUE(m.impact.crowded);
    UNIT_EQUAL(count(m.impact.between[1]), 1);
    end(&m, &s);
}

/* What rests goes on resting when the run is resumed, to the same bits. */
static void test_resume(void)
{
    struct scene s, saved;
    struct motion m, again;
    drop(&m, &s, 0.5, 0.01);
    s.velocity[0] = 0.1;
    motion_run(&m, 500);
    UNIT_EQUAL(count(m.impact.resting), 1);
    UNIT_TRUE(motion_note(&m) && scene_copy(&saved, &s));
    begin(&again, &saved, "leapfrog", true);
    motion_run(&m, 50);
    motion_run(&again, 50);
    for (size_t c = 0; c < 3; ++c)
        UNIT_EQUAL(saved.position[c], s.position[c]);
    UNIT_EQUAL(count(again.impact.resting), 1);
    UNIT_EQUAL(saved.velocity[2], 0);
    end(&again, &saved);
    end(&m, &s);
}

int main(void)
{
    return unit_run("impact",
                    (struct unit_test[]){
                        {"a thousand bounces", test_thousand},
                        {"the last bounce of e = 0.8", test_last_bounce},
                        {"methods keep their order", test_orders},
                        {"a thousand times the steps agree", test_steps},
                        {"without contact the same bits", test_same_bits},
                        {"a row that touches, at once", test_at_once},
                        {"to touch is not to collide", test_graze},
                        {"nobody gets into the floor", test_heap},
                        {"two that rest on each other crowd", test_crowd},
                        {"what rests is resumed", test_resume},
                        {0}});
}
