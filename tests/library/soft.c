/* Contacts that are springs: the restitution of a dashpot and the time of
   Hertz's contact against their formulas, momentum, energy, walls, and what
   a row of balls does. */
#include "unit.h"

#include "forces/motion.h"

/* A row of balls of 1 kg with springs of 5000 N/m: 100/s for a pair. */
static void make(struct scene *s, size_t balls, enum scene_law touch,
                 double gap)
{
    UNIT_MUST(scene_create(s, balls));
    s->contact = true;
    s->law = touch;
    s->stiffness = 5000;
    for (size_t i = 0; i < balls; ++i) {
        s->radius[i] = 0.125;
        s->position[i] = (double)i * (0.25 + gap);
    }
    s->velocity[0] = 1;
}

/* e^(-pi zeta / sqrt(1 - zeta^2)). The dashpot begins and ends with a jump
   of 2 zeta omega u somewhere in a step: a share zeta omega dt each. */
TEST(test_restitution, "what a dashpot returns")
{
    static const double zeta[] = {0, 0.05, 0.2, 0.5};
    for (int k = 0; k < 4; ++k) {
        MADE(scene, s, make(&s, 2, SCENE_LINEAR, 0));
        s.dashpot = 2 * zeta[k] * 50;
        BEGUN(motion, m, "touch", &s, "leapfrog", 1e-6);
        motion_run(&m, 60000);
        UNIT_NEAR(s.velocity[1] - s.velocity[0],
                  exp(-acos(-1) * zeta[k] / sqrt(1 - zeta[k] * zeta[k])),
                  1e-8 + 2e-4 * zeta[k]);
        UNIT_NEAR(s.velocity[0] + s.velocity[1], 1, 1e-12);
    }
}

/* 2.94327 (5 mu u^2 / 4 K)^(2/5) / u; the number to 2e-6. */
TEST(test_hertz, "how long Hertz's balls touch")
{
    for (double u = 0.5; u < 3; u *= 2) {
        MADE(scene, s, make(&s, 2, SCENE_HERTZ, 0));
        s.velocity[0] = u;
        BEGUN(motion, m, "touch", &s, "rk4", 1e-5);
        do
            motion_run(&m, 1);
        while (s.position[1] - s.position[0] < 0.25);
        const double late = (s.position[1] - s.position[0] - 0.25) /
                            (s.velocity[1] - s.velocity[0]);
        const double exact =
            2.94327 * pow(2.5 * u * u / (4 * s.stiffness), 0.4) / u;
        UNIT_NEAR((motion_time(&m) - late) / exact, 1, 1e-5);
        UNIT_NEAR(s.velocity[1], u, 1e-6);
    }
}

/* What 1 m/s of the first k becomes, after it is all over. */
static void strike(enum scene_law touch, double gap, size_t k,
                   const double out[5], double within)
{
    double momentum = 0;
    MADE(scene, s, make(&s, 5, touch, gap));
    if (touch == SCENE_HERTZ)
        s.stiffness = 50000;
    for (size_t i = 0; i < k; ++i)
        s.velocity[i] = 1;
    BEGUN(motion, m, "touch", &s, "leapfrog", 1e-4);
    motion_run(&m, 5000);
    for (size_t i = 0; i < 5; ++i) {
        UNIT_NEAR(s.velocity[i], out[i], within);
        momentum += s.velocity[i];
    }
    UNIT_NEAR(momentum, k, 1e-13);
}

/* With gaps wider than u/omega = 0.01 m, k for k. Touching, a wave. */
TEST(test_cradle, "the cradle")
{
    static const double linear[] = {-0.1323, -0.0753, -0.0310, 0.2962,
                                    0.9424},
                        hertz[] = {-0.0711, -0.0303, -0.0145, 0.1270,
                                   0.9888};
    for (size_t k = 1; k <= 3; ++k) {
        double out[5];
        for (size_t i = 0; i < 5; ++i)
            out[i] = i + k >= 5;
        strike(SCENE_LINEAR, 0.03, k, out, 1e-3);
        strike(SCENE_HERTZ, 0.06, k, out, 1e-3);
    }
    strike(SCENE_LINEAR, 0, 1, linear, 1e-4);
    strike(SCENE_HERTZ, 0, 1, hertz, 1e-4);
}

/* A heap in a box, by a method of fourth order: what is pressed together
   is counted, so the energy stays. The force has a kink at the contact, an
   error of its own of the order of (omega dt)^2 of each. */
TEST(test_energy, "what is pressed has energy")
{
    for (int touch = SCENE_LINEAR; touch <= SCENE_HERTZ; ++touch) {
        MADE(scene, s, make(&s, 20, touch, 0.05));
        for (size_t k = 0; k < 3; ++k) {
            WALLS(s, k, k < 2 ? SCENE_HARD : SCENE_PERIODIC,
                  k < 1 ? -1 : -0.5, k < 1 ? 7 : 0.5);
        }
        s.gravity[1] = -1;
        BEGUN(motion, m, "touch", &s, "rk4", 1e-3);
        const struct motion_energy e = motion_energy(&m);
        double pressed = 0;
        for (int k = 0; k < 100; ++k) {
            motion_run(&m, 20);
            pressed = fmax(pressed, motion_energy(&m).springs);
        }
        UNIT_TRUE(pressed > 0.01);
        UNIT_NEAR(motion_kinetic(&m) + motion_potential(&m),
                  e.kinetic + e.gravity + e.springs + e.weight, 1e-3);
    }
}

/* With a dashpot it lies on the floor, as deep as its weight presses it. */
TEST(test_rest, "to rest is to be pressed")
{
    MADE(scene, s, make(&s, 1, SCENE_LINEAR, 0));
    s.dashpot = 50;
    s.velocity[0] = 0;
    s.gravity[2] = -2;
    WALLS(s, 2, SCENE_HARD, -0.25, 9);
    BEGUN(motion, m, "touch", &s, "leapfrog", 1e-3);
    motion_run(&m, 20000);
    UNIT_NEAR(s.position[2], -0.125 - 2 / s.stiffness, 1e-15);
    UNIT_NEAR(s.velocity[2], 0, 1e-13);
}

TEST(test_twice, "restitution or springs")
{
    MADE(scene, s, make(&s, 2, SCENE_LINEAR, 0));
    UNIT_EQUAL(motion_flaw(&s, NULL), MOTION_WELL);
    s.restitution = 0.5;
    UNIT_EQUAL(motion_flaw(&s, NULL), MOTION_RESTITUTION);
}

/* What is stored is what the force gives back: the difference of the
   potential over a little way is the force times that way, for pairs and
   walls, of either kind; the error is of second order in the way, 1e-6 of
   depths of 1e-2 and more. */
TEST(test_stored, "what is stored comes back")
{
    static const enum scene_law kinds[] = {SCENE_LINEAR, SCENE_HERTZ};
    for (size_t kind = 0; kind < 2; ++kind) {
        double x[9], v[9] = {0}, a[9] = {0};
        MADE(scene, s, make(&s, 3, kinds[kind], -0.03));
        for (size_t i = 0; i < 3; ++i) {
            s.mass[i] = 1 + (double)i;
            s.position[3 + i] = 0.015 * (double)(i * (i + 1));
        }
        s.wall[0] = s.wall[1] = SCENE_HARD;
        s.low[0] = -0.1; /* of the first one's -0.125 */
        s.high[0] = 0.54;
        s.low[1] = -0.1;
        s.high[1] = 0.21;
        CREATED(soft, t, &s);
        memcpy(x, s.position, sizeof x);
        soft_add(&t, x, v, a);
        for (size_t c = 0; c < 9; ++c) {
            const double way = 1e-6;
            x[c] += way;
            const double above = soft_potential(&t, x);
            x[c] -= 2 * way;
            const double below = soft_potential(&t, x);
            x[c] = s.position[c];
            UNIT_NEAR(-(above - below) / (2 * way), s.mass[c % 3] * a[c],
                      1e-4);
        }
        for (size_t c = 0; c < 6; ++c)
            UNIT_TRUE(a[c] != 0);
        for (size_t i = 0; i < 3; ++i)
            x[i] = 10 * (double)i; /* nobody touches a body */
        s.wall[0] = SCENE_OPEN;
        for (size_t i = 0; i < 3; ++i)
            x[3 + i] = 0.05;
        UNIT_EQUAL(soft_potential(&t, x), 0);
    }
}

/* Two of radius 0.25, 0.25 m apart along (0, 3, 4)/5, part with 0.5 m/s:
   8 N/m times 0.25 m less 2 kg/s times 0.5 m/s is 1 N, on 2 kg and 4 kg. In
   one place they have no direction, and no force. */
TEST(test_by_hand, "two by hand")
{
    static const double force[] = {0, 0, 0, 0, -0.3, 0.15, 0, -0.4, 0.2};
    double a[9] = {0};
    MADE(scene, s, make(&s, 3, SCENE_LINEAR, 9));
    s.stiffness = 8;
    s.dashpot = 2;
    PUT(s.mass + 1, 2, 4);
    s.radius[1] = s.radius[2] = 0.25;
    s.position[2] = s.position[1];
    s.position[5] = 0.15;
    s.position[8] = 0.2;
    s.velocity[1] = s.velocity[2] = 7;
    PUT(s.velocity + 4, 1, 1.3);
    PUT(s.velocity + 7, -2, -1.6);
    CREATED(soft, t, &s);
    soft_add(&t, s.position, s.velocity, a);
    for (size_t c = 0; c < 9; ++c)
        UNIT_NEAR(a[c], force[c], 2e-15);
    memset(a, 0, sizeof a);
    s.position[5] = s.position[8] = 0;
    s.wall[1] = SCENE_HARD; /* which two just touch, on their way up */
    s.low[1] = -9;
    s.high[1] = 0.25;
    soft_add(&t, s.position, s.velocity, a);
    for (size_t c = 0; c < 9; ++c)
        UNIT_EQUAL(a[c], 0);
}
