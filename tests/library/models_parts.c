/* What the models are made of, each part by itself against what is found by
   hand: prices and bills, rates, what acts, what is left out, when a
   passage counts, and when a run has become too expensive. */
#include "unit.h"

/* All of src that is private to models. */
#include <choosing/models.c>
#include <choosing/models_acts.c>
#include <choosing/models_closed.c>
#include <choosing/models_line.c>
#include <choosing/models_disks.c>
#include <choosing/models_steps.c>

#include "library/plans.h"

/* The committed prices, in ns. Who measures better ones changes them here,
   too, and knows by that that all bills are others. */
TEST(test_prices, "the prices are those that were measured")
{
    static const struct {
        const char *name;
        double ns;
    } known[] = {
        {"evaluation", 18}, {"body", 3},        {"pair", 6.5},
        {"spring", 1.2},    {"rod", 15},        {"contact", 75},
        {"overlap", 16},    {"curve", 4.9},     {"root", 40},
        {"line-event", 33}, {"line-scan", 0.3}, {"disk-event", 100},
        {"disk-scan", 4.5}, {"renewal", 450},   {"ellipse", 210},
        {"flight", 3.6},    {"order", 2.7},     {"mode", 0.5},
        {"row", 40}};
    double work[MODELS_UNITS] = {0}, sum = 0;
    UNIT_EQUAL(MODELS_UNITS, sizeof known / sizeof *known);
    for (size_t u = 0; u < MODELS_UNITS; ++u) {
        UNIT_SAYS(models_prices[u].name, known[u].name);
        UNIT_EQUAL(models_prices[u].ns, known[u].ns);
        UNIT_TRUE(models_prices[u].what != NULL);
        work[u] = (double)(u + 1);
        sum += work[u] * known[u].ns;
    }
    UNIT_NEAR(models_cost(work), sum * 1e-9, 1e-20);
}

/* By the softened law two bodies would circle with k2 (m + M)/d^3 as the
   square of the frequency, where d^2 = 0.6^2 + 0.8^2 = 1. */
TEST(test_rate_of_gravity, "a pair's frequency is the rate")
{
    CREATED(scene, s, 3);
    s.k2 = 3;
    s.softening = 0.6;
    s.mass[0] = 4;
    s.mass[2] = 0;
    PUT(s.position + 1, 0.8, -8);
    UNIT_NEAR(models_rate(&s, 0), sqrt(15), 1e-14);
    s.softening = 0;
    UNIT_NEAR(models_rate(&s, 0), sqrt(15 / 0.512), 1e-14);
    s.k2 = -3; /* nothing circles where all repel each other */
    UNIT_EQUAL(models_rate(&s, 0), 0);
    s.k2 = 3;
    s.damping = 0.5; /* of what has mass, the lightest */
    UNIT_NEAR(models_rate(&s, 0), sqrt(15 / 0.512) + 0.5, 1e-14);
    scene_free(&s);
    /* Of more than 4000, pairs of light bodies are not looked at. */
    UNIT_MUST(scene_create(&s, 4001));
    s.k2 = 2;
    for (size_t i = 0; i < s.bodies; ++i) {
        s.mass[i] = i == 7 ? 100 : 0.5;
        s.position[i] = 10.0 * (double)i;
    }
    s.position[4000] = s.position[3999] + 1e-6;
    s.position[3] = s.position[7] - 1;
    UNIT_NEAR(models_rate(&s, 0), sqrt(2 * 100.5), 1e-12);
}

/* Two bodies of 1 and 4 kg on a spring of 36 N/m and 2 kg/s: the row of the
   first has 36 (1/1 + 1/2), and 2 (1 + 1/2) of friction. */
TEST(test_rate_of_springs, "so is that of springs, with their friction")
{
    CREATED(scene, s, 3);
    UNIT_TRUE(scene_add_kind(&s, 36, 2) && scene_add_kind(&s, 0.36, 0));
    UNIT_TRUE(scene_add_spring(&s, 0, 1, 0, 1));
    s.mass[1] = 4;
    s.position[1] = 1;
    s.position[5] = 1;
    UNIT_NEAR(models_rate(&s, 0), sqrt(54) + 3, 1e-14);
    s.spring[0].rest = 0; /* across, it is as stiff as along */
    UNIT_NEAR(models_rate(&s, 0), sqrt(54) + 3, 1e-14);
    s.spring[0].rest = 3; /* twice as stiff */
    UNIT_NEAR(models_rate(&s, 0), sqrt(108) + 3, 1e-14);
    s.position[1] = 0; /* no direction at all */
    UNIT_NEAR(models_rate(&s, 0), sqrt(54) + 3, 1e-14);
    s.position[1] = 1;
    s.spring[0].rest = 1;
    UNIT_TRUE(scene_add_spring(&s, 1, 2, 0, 1)); /* both: 9 + 18 + 9 + 18 */
    UNIT_NEAR(models_rate(&s, 0), sqrt(54) + 3, 1e-14);
    s.mass[1] = 1;
    UNIT_NEAR(models_rate(&s, 0), 12 + 8, 1e-13);
    s.freedom[1] = s.freedom[4] = s.freedom[7] = 0; /* the middle is held */
    UNIT_NEAR(models_rate(&s, 0), 6 + 2, 1e-14);
    /* A spring a hundred times as stiff as the softest is none yet, and
       beyond that a rod, which only turns: with 0.3 rad/s. */
    s.spring[1].kind = 1;
    s.velocity[3] = 0.3;
    UNIT_NEAR(models_rate(&s, MODELS_RODS), 6 + 2, 1e-14);
    s.kind[0].stiffness = 36.01;
    UNIT_NEAR(models_rate(&s, MODELS_RODS), 0.6, 1e-14);
    s.velocity[3] = 0.9;
    s.position[0] = -0.5;
    UNIT_NEAR(models_rate(&s, MODELS_RODS), 0.6, 1e-14);
    s.velocity[3] = 9;
    UNIT_NEAR(models_rate(&s, MODELS_RODS), 6, 1e-14);
}

/* A spring does not move what has no mass: of the other end's 4 kg the
   rate is sqrt(36/4), and 2/4 of friction. */
TEST(test_rate_without_mass, "a spring on what has no mass")
{
    CREATED(scene, s, 2);
    UNIT_TRUE(scene_add_kind(&s, 36, 2) &&
              scene_add_spring(&s, 0, 1, 0, 1));
    PUT(s.mass, 0, 4);
    s.position[1] = 1;
    UNIT_NEAR(models_rate(&s, 0), 3.5, 1e-14);
}

TEST(test_acts, "what acts")
{
    for (size_t n = 1; n < 3; ++n)
        for (size_t wall = 0; wall < 4; ++wall) {
            CREATED(scene, s, n);
            struct models_acts a;
            if (wall < 3)
                s.wall[wall] = SCENE_HARD;
            models_analyse(&a, &s);
            UNIT_TRUE(!a.contact);
            s.contact = true;
            models_analyse(&a, &s);
            UNIT_TRUE(a.contact == (n > 1 || wall < 3));
        }
    UNIT_EQUAL(BEARS_RODS + BEARS_PARTICLES + BEARS_SPRINGS +
                   BEARS_GRAVITY + BEARS_CONTACT + BEARS_FRICTION,
               BEARS_ALL);
    CREATED(scene, s, 2);
    s.mass[0] = 0;
    UNIT_TRUE(!attracts(&s)); /* without k2 nothing does */
    s.k2 = 1;
    UNIT_TRUE(attracts(&s));
    s.freedom[0] = s.freedom[4] = 0;
    UNIT_TRUE(attracts(&s)); /* along y it may move */
    s.freedom[2] = 0;
    UNIT_TRUE(!attracts(&s)); /* body 1 pulls one that is held */
    s.mass[0] = 1;
    UNIT_TRUE(attracts(&s));
}

/* What is a hundredth as stiff is not weak yet. Across goes all but the
   longest axis, along which nothing changes. */
TEST(test_left_out, "what is left out")
{
    CREATED(scene, s, 2);
    for (size_t k = 0; k < 3; ++k)
        UNIT_TRUE(scene_add_kind(&s, (const double[]){1, 100, 0.99}[k],
                                 0.5 + (double)k));
    models_leave_out(&s, MODELS_NO_WEAK);
    UNIT_TRUE(s.kind[0].stiffness == 1 && s.kind[0].damping == 0.5);
    UNIT_TRUE(s.kind[1].stiffness == 100 && s.kind[1].damping == 1.5);
    UNIT_TRUE(s.kind[2].stiffness == 0 && s.kind[2].damping == 0);
    models_leave_out(&s, MODELS_NO_DASHPOTS);
    UNIT_TRUE(s.kind[1].stiffness == 100 && s.kind[1].damping == 0);
    for (size_t axis = 0; axis < 3; ++axis) {
        for (size_t c = 0; c < 6; ++c) {
            s.position[c] = 5 + (c % 2 ? c / 2 == axis ? -2.5 : 2 : 0);
            s.velocity[c] = 1 + (double)c;
            s.freedom[c] = 1;
        }
        models_leave_out(&s, MODELS_NO_ACROSS);
        for (size_t c = 0; c < 6; ++c) {
            const bool along = c / 2 == axis;
            UNIT_EQUAL(s.position[c], along && c % 2 ? 2.5 : 5);
            UNIT_EQUAL(s.velocity[c], along ? 1 + (double)c : 0);
            UNIT_EQUAL(s.freedom[c], along);
        }
    }
}

/* Closed forms: a flight for each coordinate, of ten times the price with
   an exponential; an ellipse for each body but the central one; modes of n
   coordinates cost 20 n^3 to find, twice for a spring whose place of rest
   is a step away, and 2 n^2 in each row. */
TEST(test_bills_of_forms, "bills of closed forms")
{
    CREATED(scene, s, 2);
    RUN r = run_plan("free", &s, 1, 2);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 2 * 6);
    models_end(&r);
    s.damping = 0.1;
    r = run_plan("free", &s, 1, 2);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 2 * 60);
    models_end(&r);
    scene_free(&s);
    s = light_orbit(1, 1);
    r = run_plan("kepler", &s, 1, 3);
    UNIT_EQUAL(r.work[MODELS_ELLIPSE], 3);
    models_end(&r);
    scene_free(&s);
    UNIT_MUST(scene_create(&s, 2));
    UNIT_TRUE(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 1));
    for (size_t k = 0; k < 3; ++k)
        s.freedom[2 * k] = 0;
    s.position[1] = 1.25;
    r = run_plan("oscillator", &s, 1, 3);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 3 * 10);
    UNIT_EQUAL(r.work[MODELS_MODE], 2 * 20 + 3 * 2);
}

/* A spring of 1 N/m and 1 m with 1 kg at 1 m/s reaches the place of its
   other end, and no farther: there it has no direction. */
TEST(test_border, "a spring that just turns round")
{
    RUN r;
    const char *why = "";
    CREATED(scene, s, 2);
    const struct models_plan p = plan("oscillator");
    UNIT_TRUE(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 1));
    for (size_t k = 0; k < 3; ++k)
        s.freedom[2 * k] = 0;
    s.position[1] = 1;
    s.velocity[1] = 1;
    UNIT_TRUE(!models_begin(&r, &p, &s, 1, &why));
    UNIT_SAYS(why, "a spring may turn round");
    s.velocity[1] = 1 - 1e-9;
    UNIT_TRUE(models_begin(&r, &p, &s, 1, &why));
}

/* Four hundred coordinates have modes, one more has too many. */
TEST(test_many_modes, "too many modes")
{
    const struct models_plan p = plan("modes");
    for (size_t n = 400; n < 402; ++n) {
        CREATED(scene, s, n);
        UNIT_TRUE(scene_add_kind(&s, 1, 0));
        for (size_t i = 0; i < n; ++i) {
            s.position[i] = (double)i;
            s.freedom[n + i] = s.freedom[2 * n + i] = 0;
            UNIT_TRUE(i == 0 || scene_add_spring(&s, i - 1, i, 0, 1));
        }
        const char *why = models_refuse(&p, &s);
        UNIT_TRUE(
            n == 400 ? !why
                     : why && strcmp(why, "there are too many modes") == 0);
    }
}

/* To put n in order takes n times the bits of n - 1, and n at least. */
TEST(test_sorting, "to put in order has a price")
{
    static const double bits[][2] = {
        {1, 1}, {2, 1},  {3, 2},  {4, 2},     {5, 3},    {8, 3},
        {9, 4}, {16, 4}, {17, 5}, {1024, 10}, {1025, 11}};
    for (size_t k = 0; k < sizeof bits / sizeof *bits; ++k) {
        struct models_run r = {.rows = 1};
        r.work[MODELS_ORDER] = 7;
        models_count_sorting(&r, (size_t)bits[k][0], 3);
        UNIT_EQUAL(r.work[MODELS_ORDER], 7 + 3 * bits[k][0] * bits[k][1]);
    }
    CREATED(scene, s, 3);
    s.contact = true;
    for (size_t i = 0; i < 3; ++i) {
        s.position[i] = (double)i;
        s.velocity[i] = 1 - (double)i;
        s.freedom[3 + i] = s.freedom[6 + i] = 0;
    }
    RUN r = run_plan("relabel", &s, 1, 4);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 4 * 3);
    UNIT_EQUAL(r.work[MODELS_ORDER], 3 * 6 + 4 * 6);
    UNIT_EQUAL(models_collisions(&r), 3);
    UNIT_EQUAL(r.work[MODELS_ORDER], 3 * 6 + 4 * 6 + 2 * 9);
}

/* On a line all gaps are looked at after each collision and in each row, up
   to 33 of them; of more there are slabs, which are worth thirty. */
TEST(test_bill_of_line, "the bill of a line")
{
    static const double looks[][2] = {{4, 4}, {33, 33}, {34, 30}};
    for (size_t k = 0; k < 3; ++k) {
        const struct bonkers b = {.gaps = (size_t)looks[k][0],
                                  .collisions = 11};
        struct models_run r = {.rows = 3};
        count_line(&r, &b);
        UNIT_EQUAL(r.work[MODELS_LINE_EVENT], 11);
        UNIT_EQUAL(r.work[MODELS_LINE_SCAN], (11 + 4) * looks[k][1]);
        UNIT_EQUAL(r.work[MODELS_FLIGHT], 3 * 4 * looks[k][0]);
    }
}

/* A body on a line that falls away from the engine's own down, along an
   axis from left to right: from 5 m with 1 m/s, by 2 m/s^2. */
TEST(test_upwards, "along a line that rises")
{
    static const struct {
        double mass;
        bool held;
        const char *why;
    } known[] = {{1, false, NULL},
                 {0, false, "a body has no mass"},
                 {1, true, "nothing is free, or too much"}};
    const struct models_plan p = plan("line");
    for (size_t k = 0; k < 3; ++k) {
        CREATED(scene, s, 1);
        s.contact = true;
        s.wall[0] = SCENE_HARD;
        s.high[0] = 10;
        s.position[0] = 5;
        s.velocity[0] = 1;
        s.gravity[0] = 2;
        s.mass[0] = known[k].mass;
        s.freedom[0] = !known[k].held;
        s.freedom[1] = s.freedom[2] = 0;
        const char *why = models_refuse(&p, &s);
        UNIT_TRUE(why == known[k].why ||
                  (why && strcmp(why, known[k].why) == 0));
        if (!known[k].why) {
            RUN r = run_plan("line", &s, 1, 1);
            UNIT_NEAR(r.scene.position[0], 7, 1e-14);
            UNIT_NEAR(r.scene.velocity[0], 3, 1e-14);
        }
    }
}

/* A pendulum of 1 m on a stiff spring that is a rod stays as long; at the
   bottom it has all of its energy: 2 g h = v^2. */
TEST(test_rod, "a rod")
{
    CREATED(scene, s, 2);
    UNIT_TRUE(scene_add_kind(&s, 1e6, 0));
    UNIT_TRUE(scene_add_spring(&s, 0, 1, 0, 1));
    for (size_t k = 0; k < 3; ++k)
        s.freedom[2 * k] = 0;
    s.position[1] = 1;
    s.gravity[2] = -1;
    RUN r = run_plan("leapfrog:400,rods", &s, 1.5, 1);
    const double x = r.scene.position[1], z = r.scene.position[5];
    const double v = r.scene.velocity[1], w = r.scene.velocity[5];
    UNIT_NEAR(x * x + z * z, 1, 1e-9);
    UNIT_NEAR(v * v + w * w, -2 * z, 1e-4);
    UNIT_TRUE(z < -0.7 && r.work[MODELS_ROD] > 0);
}

/* Disks by the scan: at the start all pairs, three times the price of half
   of them; two rows of looks for a collision and one for a wall. In cells
   each row has as many seats, and lists are made at the start and anew. */
TEST(test_bill_of_disks, "the bill of disks")
{
    struct box_run d = {.view.axes = 2};
    struct models_run r = {.rows = 4};
    d.disks.count = 6;
    d.disks.collisions = 10;
    d.disks.wall_collisions = 7;
    d.cells.renewed = 100;
    d.cells.seats = 3;
    count_disks(&r, &d);
    UNIT_EQUAL(r.work[MODELS_DISK_EVENT], 17);
    UNIT_EQUAL(r.work[MODELS_DISK_SCAN], 6 * (9 + 20 + 7));
    UNIT_EQUAL(r.work[MODELS_RENEWAL], 0);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 5 * 12);
    d.celled = true;
    count_disks(&r, &d);
    UNIT_EQUAL(r.work[MODELS_DISK_EVENT], 17);
    UNIT_EQUAL(r.work[MODELS_DISK_SCAN], 3 * (3 + 20 + 7 + 100));
    UNIT_EQUAL(r.work[MODELS_RENEWAL], 106);
    UNIT_EQUAL(r.work[MODELS_FLIGHT], 5 * 12);
}

/* A disk that flies v t has crossed a box of L at least v t/L times, each
   for the price of a collision with a wall. */
TEST(test_endless, "crossings are foreseen")
{
    struct disk one[2] = {{.velocity = {30, -8}}, {.velocity = {0, 2}}};
    struct box_run d = {.view.axes = 2};
    struct models_run r = {.elapsed = 5};
    d.disks.count = 2;
    d.disks.disk = one;
    d.disks.now = 3;
    d.disks.box[0] = 4;
    d.disks.box[1] = 0;      /* open */
    r.work[MODELS_ROW] = 10; /* 400 ns */
    r.limit = 400e-9 + 15 * 100e-9 * 1.001;
    UNIT_TRUE(!is_endless(&r, &d));
    UNIT_EQUAL(d.crossed, 15);
    d.crossed = 0;
    r.limit = 400e-9 + 15 * 100e-9 * 0.999;
    UNIT_TRUE(is_endless(&r, &d));
    d.disks.box[1] = 8;
    d.crossed = 1;
    is_endless(&r, &d);
    UNIT_EQUAL(d.crossed, 1 + 15 + 2 + 0.5);
}

static const struct stepping_method *method(const char *name)
{
    return models_find(name)->method;
}

/* Steps: passes over bodies by family, pairs, springs; and in a row what
   belongs to the method, contacts, rods and light bodies. */
TEST(test_bill_of_steps, "the bill of steps")
{
    CREATED(scene, s, 4);
    CREATED(scene, many, 33);
    struct steps t = {.plan = plan("leapfrog:1")};
    struct models_run r = {.scene = s, .plan = t.plan, .rows = 2};
    double work[MODELS_UNITS] = {0};
    t.motion.scene = &s;
    t.motion.attracts = true;
    t.motion.springs.count = 7;
    t.motion.springs.listed = 2;
    count_evaluations(&r, &t, 10, work);
    UNIT_EQUAL(work[MODELS_EVALUATION], 10);
    UNIT_EQUAL(work[MODELS_BODY], 40);
    UNIT_EQUAL(work[MODELS_PAIR], 60);
    UNIT_EQUAL(work[MODELS_SPRING], 10 * (5 + 20));
    t.has_particles = true; /* with two heavy ones */
    t.particles.heavy = 2;
    UNIT_EQUAL(count_pulls(&t), 6);
    t.motion.attracts = false;
    UNIT_EQUAL(count_pulls(&t), 0);
    t.has_particles = false;
    t.motion.attracts = true;
    t.motion.scene = &many;
    UNIT_EQUAL(count_pulls(&t), 33 * 4); /* eight lanes */
    many.bodies = 32;
    UNIT_EQUAL(count_pulls(&t), 16 * 31);
    many.bodies = 33;
    static const struct {
        enum stepping_family family;
        double passes;
    } known[] = {{STEPPING_EXPLICIT, 10},
                 {STEPPING_IMPLICIT, 25},
                 {STEPPING_PAIR, 40},
                 {STEPPING_RADAU, 52}};
    for (size_t k = 0; k < 4; ++k)
        UNIT_EQUAL(
            body_passes(&(struct stepping_method){.family = known[k].family,
                                                  .stages = 3},
                        5),
            known[k].passes);
    UNIT_EQUAL(body_passes(method("leapfrog"), 5), 5);
    t.motion = (struct motion){.scene = &s, .orbits = false};
    t.motion.stepping.method = method("leapfrog");
    t.motion.stepping.steps = 20;
    t.motion.stepping.evaluations = 21;
    count_steps(&r, &t);
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 21);
    UNIT_EQUAL(r.work[MODELS_BODY], 84);
    UNIT_EQUAL(r.work[MODELS_CONTACT] + r.work[MODELS_OVERLAP] +
                   r.work[MODELS_CURVE] + r.work[MODELS_ROOT] +
                   r.work[MODELS_ROD] + r.work[MODELS_ELLIPSE],
               0);
    t.has_particles = true;
    count_steps(&r, &t);
    UNIT_EQUAL(r.work[MODELS_BODY], 84 + 3 * 5 * 4);
    t.has_particles = false;
    t.motion.impact.parts = 30;
    t.motion.impact.pairs = 31;
    t.motion.impact.curves = 32;
    t.motion.impact.roots = 33;
    t.motion.spheres.tested = 50;
    t.motion.collides = true;
    count_steps(&r, &t);
    UNIT_NEAR(r.work[MODELS_CONTACT], 24, 1e-13);
    UNIT_NEAR(r.work[MODELS_OVERLAP], 15, 1e-13);
    t.motion.located = true;
    count_steps(&r, &t);
    UNIT_EQUAL(r.work[MODELS_CONTACT], 4 * 30);
    UNIT_EQUAL(r.work[MODELS_OVERLAP], 31);
    UNIT_EQUAL(r.work[MODELS_CURVE], 32);
    UNIT_EQUAL(r.work[MODELS_ROOT], 33);
    t.rodded = true;
    t.rods.evaluations = 5;
    t.rods.corrections = 100;
    t.rods.count = 2;
    count_steps(&r, &t);
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 5);
    UNIT_EQUAL(r.work[MODELS_ROD], 100 + 3 * 20 * 2);
    t.rodded = false;
    t.motion.orbits = true;
    t.motion.stepping.method = method("wisdom-holman");
    count_steps(&r, &t);
    UNIT_NEAR(r.work[MODELS_ELLIPSE],
              0.8 * 3 * 20 * (double)method("wisdom-holman")->drifts,
              1e-12);
    r.plan = t.plan = plan("radau15:1e-9");
    t.motion.stepping.method = method("radau15");
    count_steps(&r, &t);
    UNIT_EQUAL(r.work[MODELS_BODY], 21 * 48 + 20 * 18 * 4);
    scene_free(&many);
}

TEST(test_steps_of_row, "steps asked for in a row")
{
    struct models_run r = {.plan = plan("pefrl:12")};
    UNIT_EQUAL(steps_of(&r), 12);
    r.plan = plan("radau15:1e-9");
    UNIT_EQUAL(steps_of(&r), 1);
    r.scene.contact = true;
    UNIT_EQUAL(steps_of(&r), 8);
}

/* By hand: a run that has cost c in 9.5 of 100 rows will cost 100 c/9.5;
   equal steps may promise 1.1 of the limit, others twice, and only after
   they have cost half of it, or a second. */
TEST(test_hopeless, "what will cost too much is seen")
{
    static const double border[][4] = {
        /* limit, where the step has led (in rows), from which cost on,
           0 or 1: with steps of their own length */
        {1, 0, 1.1 * 9.5 / 100, 0},
        {5, 0, 5.5 * 9.5 / 100, 0},
        {1, 0, 0.5, 1},
        {8, 0, 1.52, 1},
        {4, 0, 1, 1},
        {8, 50, 8, 1},
        {8, 5, 1.52, 1}};
    struct adaptive own = {0};
    struct models_run r = {
        .plan = plan("pefrl:4"), .every = 2, .all = 100, .rows = 9};
    for (size_t k = 0; k < sizeof border / sizeof *border; ++k)
        for (int beyond = 0; beyond < 2; ++beyond) {
            struct steps t = {.rodded = false};
            own.t = 2 * border[k][1];
            t.motion.stepping.own = border[k][3] > 0 ? &own : NULL;
            r.limit = border[k][0];
            r.work[MODELS_ROW] =
                border[k][2] * (beyond ? 1.001 : 0.999) / 40e-9;
            UNIT_TRUE(is_hopeless(&r, &t, 2) == beyond);
        }
}

/* By the price list a call for two bodies without forces that are stepped
   by radau15 costs 18 + 4 (2 + 8) 3 = 138 ns. One look may take what is
   left; in a run of many rows eight of the shares of one, but a tenth of a
   second at least. A hundred calls more do no harm. */
TEST(test_look, "how long a look may take")
{
    CREATED(scene, s, 2);
    struct adaptive own = {.evaluations = 50};
    struct steps t = {.plan = plan("radau15:1e-9")};
    struct models_run r = {.scene = s, .plan = t.plan, .limit = 3};
    t.motion.scene = &s;
    t.motion.stepping.own = &own;
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + 3 / 138e-9, 1);
    r.all = 40;
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + 0.6 / 138e-9, 1);
    r.all = 4000;
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + 0.1 / 138e-9, 1);
    r.scene.contact = true; /* a row is asked for in eight parts */
    r.all = 20;
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + 0.15 / 138e-9, 1);
    r.scene.contact = false;
    r.all = 0;
    t.motion.located = true; /* and a guess: half a body, a quarter pair */
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + 3 / (138e-9 + 37.5e-9 + 4e-9), 1);
    r.work[MODELS_ROW] = 1e6 / 40; /* 1 ms so far, for ten calls */
    r.work[MODELS_EVALUATION] = 10;
    bound_evaluations(&r, &t);
    UNIT_NEAR(own.most, 150 + (3 - 0.00100018) / 0.000100018, 1);
    r.limit = INFINITY;
    bound_evaluations(&r, &t);
    UNIT_EQUAL(own.most, 0); /* no bound */
}

/* Two that see each other at sqrt(2) m, and pass in a second at 1 m, which
   a pull bends by up to sqrt(a2)/2. */
TEST(test_counts, "passages that count")
{
    static const double known[][3] = {
        /* a2, what is a little from which on the passage counts no more,
           sign of rv */
        {0, 6, -1},
        {0.25, 8, -1},
        {1, 12, -1},
        {1, 12, 1}};
    for (size_t k = 0; k < 4; ++k) {
        const struct pair p = {.r2 = 2, .v2 = 1, .rv = known[k][2]};
        struct steps t = {.plan.time_left = 3};
        t.plan.negligible = 0.999 * known[k][1];
        UNIT_TRUE(passage_counts(&t, &p, 1, known[k][0]));
        t.plan.negligible = known[k][1];
        UNIT_TRUE(!passage_counts(&t, &p, 1, known[k][0]));
        UNIT_TRUE(passage_counts(&t, &p, 1.001, known[k][0]));
        /* Twice as fast they are bent a quarter as much. */
        const struct pair fast = {.r2 = 2, .v2 = 4, .rv = 2 * known[k][2]};
        t.plan.negligible = 3.001 / (1 - sqrt(known[k][0]) / 8);
        UNIT_TRUE(!passage_counts(&t, &fast, 1, known[k][0]));
        t.plan.negligible = 2.999 / (1 - sqrt(known[k][0]) / 8);
        UNIT_TRUE(passage_counts(&t, &fast, 1, known[k][0]));
    }
    const struct pair p = {.r2 = 2, .v2 = 1, .rv = -1};
    struct steps t = {.plan.time_left = 3, .plan.negligible = 1e300};
    UNIT_TRUE(passage_counts(&t, &p, 1, 16)); /* they may well meet */
}

/* Two at 2 m: 0.7 of that is 1.4 m. */
TEST(test_hurry, "how soon two may meet")
{
    const struct pair still = {.r2 = 4};
    UNIT_EQUAL(passage_rate(&still, 0), 0);
    UNIT_NEAR(passage_rate(&still, 25), sqrt(14) / 2 / 1.4, 1e-15);
    const struct pair nearer = {.r2 = 4, .v2 = 4, .rv = -4};
    UNIT_NEAR(passage_rate(&nearer, 0), 2 / 1.4, 1e-15);
    UNIT_NEAR(passage_rate(&nearer, 25), (2 + sqrt(18)) / 2 / 1.4, 1e-15);
    const struct pair away = {.r2 = 4, .v2 = 4, .rv = 4};
    UNIT_NEAR(passage_rate(&away, 25), 2 / 1.4, 1e-15);
    UNIT_NEAR(passage_rate(&away, 100), sqrt(28) / 2 / 1.4, 1e-15);
}

/* The longest step is that of the pair in the greatest hurry; those that do
   not attract each other, and those that are held, are in none. */
TEST(test_longest, "the longest step")
{
    struct steps t = {.plan.time_left = 1};
    struct scene *s = &t.scene;
    UNIT_MUST(scene_create(s, 4));
    double a[12] = {0};
    PUT(s->position + 1, 2, 12);
    s->position[3] = 12.1; /* the last two have no mass */
    s->mass[2] = s->mass[3] = 0;
    PUT(s->velocity + 1, -1, -3, 50);
    s->k2 = 1;
    for (size_t i = 0; i < 4; ++i)
        s->freedom[4 + i] = s->freedom[8 + i] = 0;
    /* 0 and 3: 50/(0.7 12.1); 1 and 3: 51/(0.7 10.1) */
    UNIT_NEAR(longest_step(&t, s->position, s->velocity, a),
              0.7 * 10.1 / 51, 1e-15);
    s->velocity[3] = 0; /* 0 and 1: 1/1.4 */
    UNIT_NEAR(longest_step(&t, s->position, s->velocity, a), 1.4, 1e-15);
    a[0] = 3;
    a[1] = -22; /* relative to each other, 25 */
    UNIT_NEAR(longest_step(&t, s->position, s->velocity, a),
              1.4 / ((1 + sqrt(1 + 2 * 25 * 1.4)) / 2), 1e-15);
    a[0] = a[1] = 0;
    s->freedom[0] = s->freedom[1] = 0; /* 1 and 2: 3/(0.7 10) */
    UNIT_NEAR(longest_step(&t, s->position, s->velocity, a), 7 / 3.0,
              1e-15);
    s->freedom[2] = s->freedom[3] = 0;
    UNIT_TRUE(isinf(longest_step(&t, s->position, s->velocity, a)));
    s->freedom[0] = 1;
    s->k2 = 0;
    UNIT_TRUE(isinf(longest_step(&t, s->position, s->velocity, a)));
    scene_free(s);
}

/* A method that follows orbits has bodies in an order of its own: what it
   brings back stands where it was, and costs what is said. */
TEST(test_order, "bodies in the order of their orbits")
{
    CREATED(scene, s, 3);
    static const double x[] = {4, 0, 1}, v[] = {0.5, 0, 1};
    s.k2 = 1;
    for (size_t i = 0; i < 3; ++i) {
        s.mass[i] = i == 1 ? 1 : 1e-9;
        s.position[i] = x[i];
        s.velocity[3 + i] = v[i];
    }
    RUN r = run_plan("wisdom-holman:50", &s, 0.5, 2);
    UNIT_NEAR(r.work[MODELS_ELLIPSE],
              0.8 * 2 * 100 * (double)method("wisdom-holman")->drifts,
              1e-9);
    /* On circles, of radius 4 and 1. */
    UNIT_NEAR(r.scene.position[0], 4 * cos(0.125), 1e-7);
    UNIT_NEAR(r.scene.position[2], cos(1), 1e-7);
    UNIT_NEAR(r.scene.position[5], sin(1), 1e-7);
    UNIT_NEAR(r.scene.velocity[3], 0.5 * cos(0.125), 1e-7);
    UNIT_EQUAL(r.scene.mass[1], 1);
}
