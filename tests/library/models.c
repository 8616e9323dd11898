/* The models: each against steps that are fine enough or against values of
   18 digits; what each refuses; what is left out of a scene; what acts in
   it; plans as text; what is counted, and the limit of the cost. */
#include "unit.h"

#include "library/galleries.h"
#include "library/plans.h"
#include "choosing/models.h"
#include "forces/motion.h"
#include "toolbox/random.h"

static struct scene scene; /* each that is made takes its place */

/* A scene of the gallery; up to three keys, the last name NULL. */
struct wish {
    const char *key;
    double value;
};

static void make(const char *name, const struct wish wishes[])
{
    const struct gallery_scene *g = find_anywhere(name);
    double value[GALLERY_KEYS];
    gallery_usual(g, value);
    for (; wishes && wishes->key; ++wishes)
        value[gallery_key(g, wishes->key)] = wishes->value;
    scene_free(&scene);
    UNIT_TRUE(g->build(&scene, value) == NULL);
}

static void make_bodies(size_t n)
{
    scene_free(&scene);
    UNIT_MUST(scene_create(&scene, n));
}

static struct models_run run_of(const char *text, double every,
                                uint64_t rows)
{
    return run_plan(text, &scene, every, rows);
}

static double apart(const double a[], const double b[], size_t n)
{
    double most = 0;
    for (size_t c = 0; c < n; ++c)
        most = fabs(a[c] - b[c]) <= most ? most : fabs(a[c] - b[c]);
    return most;
}

/* How far places and velocities of two runs are apart after some rows. */
struct gap {
    double x, v;
};

static struct gap compare(const char *one, const char *other, double every,
                          uint64_t rows)
{
    RUN a = run_of(one, every, rows);
    RUN b = run_of(other, every, rows);
    const size_t n = 3 * scene.bodies;
    const struct gap gap = {apart(a.scene.position, b.scene.position, n),
                            apart(a.scene.velocity, b.scene.velocity, n)};
    UNIT_EQUAL(a.scene.time, b.scene.time);
    return gap;
}

/* Why a plan is refused, at sight or in the beginning; "" if it is not. */
static const char *refused(const char *text)
{
    const struct models_plan p = plan(text);
    struct models_run r;
    const char *why = models_refuse(&p, &scene), *again;
    const bool begun = models_begin(&r, &p, &scene, 1, &again);
    if (begun)
        models_end(&r);
    if (why) {
        UNIT_TRUE(!begun);
        UNIT_TRUE(!begun && strcmp(why, again) == 0);
    }
    return begun ? "" : again;
}

static void refuses(const char *text, const char *why)
{
    const char *said = refused(text);
    UNIT_SAYS(said, why);
}

/* Ten years of the Sun and the Earth in 34 digits, computed for this book
   (tests/programs/trajectories/sun-earth.dat): Sun and Earth, x and y. An
   angle of 63 rad rounded to 1e-14, and a motion of the Sun that is 3e-6 of
   it. */
TEST(test_kepler_known, "kepler: ten years of 18 digits")
{
    static const double known[] = {
        3.9738031271241174e-09, .99867539895762529, 1.8849379457678128e-04,
        -5.1264858927092814e-02};
    static const double speed[] = {
        -2.6549930109885706e-09, 8.8499767032952354e-04,
        6.8349414058141935e-11, 1.7177216861980619e-02};
    make("sun-earth", NULL);
    RUN r = run_of("kepler", 365, 10);
    for (size_t c = 0; c < 4; ++c) {
        UNIT_NEAR(r.scene.position[c], known[c], 5e-14);
        UNIT_NEAR(r.scene.velocity[c], speed[c], 1e-15);
    }
    UNIT_EQUAL(r.scene.time, 3650);
    UNIT_EQUAL(r.work[MODELS_ELLIPSE], 10);
}

/* The same in weight, with a Sun that is held, with equal masses, and with
   a third body of no mass. */
TEST(test_kepler_others,
     "kepler: weight, a held Sun, equal masses, no mass")
{
    struct gap gap;
    make("sun-earth", (struct wish[]){{"speed", 1.2}, {0}});
    memset(scene.freedom, 1, 6);
    scene.mass[1] = 1;
    PUT(scene.gravity + 1, -1e-5, 2e-5);
    gap = compare("kepler", "kahan-li8:400", 40, 5);
    UNIT_NEAR(gap.x, 0, 1e-12);
    UNIT_NEAR(gap.v, 0, 1e-13);
    scene.freedom[0] = scene.freedom[2] = scene.freedom[4] = 0;
    refuses("kepler", "there is weight, and the centre is held");
    scene.gravity[1] = scene.gravity[2] = 0;
    gap = compare("kepler", "kahan-li8:400", 40, 5);
    UNIT_NEAR(gap.x, 0, 1e-12);
    make("circumbinary", (struct wish[]){{"planet", 0}, {0}});
    PUT(scene.mass, 2, 0);
    gap = compare("kepler", "kahan-li8:400", 10, 5);
    UNIT_NEAR(gap.x, 0, 1e-12);
}

/* Without what light bodies pull, the ellipses are what steps do, and the
   centre of mass stays where it should; left out is of the order of the
   masses: a factor on Jupiter's is a factor on the difference. */
TEST(test_no_light, "no-light: ellipses and steps agree, the centre stays")
{
    double miss[2];
    make("solar-system", NULL);
    for (size_t c = 0; c < 27; ++c)
        scene.velocity[c] += 0.01;
    const struct gap gap =
        compare("kepler,no-light", "kahan-li8:200,no-light", 100, 5);
    UNIT_NEAR(gap.x, 0, 1e-11);
    UNIT_NEAR(gap.v, 0, 1e-12);
    for (int k = 0; k < 2; ++k) {
        make("solar-system",
             (struct wish[]){{"jupiter", k ? 0.1 : 1}, {0}});
        miss[k] = compare("kepler,no-light", "kahan-li8:20", 100, 5).x;
    }
    UNIT_TRUE(miss[0] > 1e-4 && miss[0] < 2e-3);
    UNIT_TRUE(miss[1] < miss[0] && miss[1] > 0.05 * miss[0]);
    RUN r = run_of("leapfrog:10,no-light", 100, 5);
    for (size_t k = 0; k < 3; ++k) {
        double sum = 0, mass = 0;
        for (size_t i = 0; i < 9; ++i) {
            sum += r.scene.mass[i] * r.scene.position[9 * k + i];
            mass += r.scene.mass[i];
        }
        UNIT_NEAR(sum / mass, 0, 1e-14); /* it was at rest at the origin */
    }
    UNIT_EQUAL(r.work[MODELS_PAIR], 51 * 8); /* one source, 8 others */
}

TEST(test_no_light_others, "no-light: round two stars, round a held one")
{
    make("circumbinary", NULL);
    const double miss =
        compare("kahan-li8:50,no-light", "kahan-li8:50", 10, 10).x;
    UNIT_TRUE(miss > 1e-6 && miss < 3e-4); /* the planet: 0.318e-3 */
    refuses("kepler,no-light", "more than one body pulls, or one is held");
    make("sun-earth", NULL);
    UNIT_NEAR(compare("kahan-li8:200,no-light", "kahan-li8:200", 100, 5).x,
              0, 1e-12); /* one light body: exact */
    for (size_t k = 0; k < 3; ++k)
        scene.freedom[2 * k] = 0;
    UNIT_NEAR(compare("kahan-li8:200,no-light", "kahan-li8:200", 100, 5).x,
              0, 1e-12);
}

TEST(test_kepler_refuses, "kepler refuses what is no ellipse")
{
    make("figure-eight", NULL);
    refuses("kepler", "more than one body pulls, or one is held");
    scene.k2 = 0;
    refuses("kepler", "nothing attracts");
    make("sun-earth", NULL);
    scene.softening = 0.01;
    refuses("kepler", "the attraction is softened");
    scene.softening = 0;
    refuses("kepler", "");
    scene.damping = 1e-9;
    refuses("kepler", "there is friction");
    scene.damping = 0;
    scene.velocity[3] *= 1.4142; /* still an ellipse */
    refuses("kepler", "");
    scene.velocity[3] *= 1.0001;
    refuses("kepler", "an orbit is open, or as good as a fall");
    scene.velocity[3] = 0;
    refuses("kepler", "an orbit is open, or as good as a fall");
    scene.velocity[3] = 0.0172;
    scene.position[5] = 0.1; /* held along z */
    refuses("kepler", "bodies are held beside the plane of their motion");
}

TEST(test_free, "free: weight and friction, and what is held")
{
    make_bodies(3);
    scene.gravity[1] = -9.81;
    scene.damping = 0.7;
    for (size_t i = 0; i < 3; ++i) {
        scene.mass[i] = (double)i + 0.5;
        scene.velocity[i] = 3;
        scene.velocity[3 + i] = (double)i;
    }
    scene.freedom[1] = scene.freedom[5] = 0;
    const struct gap gap = compare("free", "gauss4:400", 0.5, 6);
    UNIT_NEAR(gap.x, 0, 1e-11);
    UNIT_NEAR(gap.v, 0, 1e-11);
    RUN r = run_of("free", 0.5, 1);
    UNIT_EQUAL(r.scene.velocity[1], 0);
    UNIT_EQUAL(r.scene.position[1], 0);
    scene.contact = true;
    refuses("free", "bodies may meet");
    make("oscillator", NULL);
    refuses("free", "springs act");
}

/* The oscillator of chapter 10 with everything, along any axis, and from
   the other side of its anchor. */
TEST(test_oscillator, "oscillator: along any axis, with everything")
{
    for (size_t k = 0; k < 3; ++k)
        for (int side = -1; side < 2; side += 2) {
            struct gap gap;
            make("oscillator", NULL);
            for (size_t i = 0; i < 2; ++i) {
                const double x = scene.position[i];
                scene.freedom[i] = 0;
                scene.position[i] = 0;
                scene.position[2 * k + i] = side * x;
                scene.freedom[2 * k + i] = i > 0;
            }
            scene.velocity[2 * k + 1] = 0.3;
            scene.gravity[k] = 0.2;
            scene.damping = 0.1;
            gap = compare("oscillator", "gauss4:800", 1, 10);
            UNIT_NEAR(gap.x, 0, 1e-11);
            UNIT_NEAR(gap.v, 0, 1e-11);
            scene.damping = scene.kind[0].damping = 0;
            gap = compare("oscillator", "kahan-li8:100", 1, 10);
            UNIT_NEAR(gap.x, 0, 1e-12);
            scene.velocity[2 * k + 1] = 10;
            refuses("oscillator", "a spring may turn round");
        }
    make("double-pendulum", NULL);
    refuses("oscillator", "it does not move along its springs only");
    make("oscillator", NULL);
    scene.freedom[3] = 1;
    refuses("oscillator", ""); /* nothing pushes it aside */
    scene.velocity[3] = 1e-9;
    refuses("oscillator", "it does not move along its springs only");
    scene.velocity[3] = 0;
    scene.spring[0].rest = 0;
    scene.velocity[1] = 10; /* straight through: still linear */
    refuses("oscillator", "");
}

/* Cradles in rationals, computed for this book: the velocities
   after the knock, by all models that can. */
TEST(test_cradle, "Newton's cradle in fractions, by three models")
{
    static const struct {
        double first, last, out[5];
        double collisions;
    } known[] = {{1, 1, {0, 0, 0, 0, 1}, 4},
                 {2, 1, {1. / 81, 4. / 81, 4. / 27, 4. / 9, 4. / 3}, 10},
                 {1, 2, {-1. / 3, 0, 0, 0, 2. / 3}, 7},
                 {3, 1, {1. / 16, 3. / 16, 3. / 8, 3. / 4, 3. / 2}, 10},
                 {0.5, 1, {-1. / 3, 0, 0, 0, 2. / 3}, 4}};
    const char *plans[] = {"line", "kahan-li8:8000", "relabel"};
    for (size_t i = 0; i < 5; ++i)
        for (size_t k = 0; k < (i ? 2 : 3); ++k) {
            make("cradle", (struct wish[]){{"first", known[i].first},
                                           {"last", known[i].last},
                                           {0}});
            scene.wall[0] = SCENE_OPEN;
            RUN r = run_of(plans[k], 2, 2);
            for (size_t b = 0; b < 5; ++b)
                UNIT_NEAR(r.scene.velocity[b], known[i].out[b], 2e-15);
            UNIT_EQUAL(models_collisions(&r), known[i].collisions);
        }
}

/* A scene on the line, in steps of contacts, along another axis and with
   bodies out of order. Contacts are found after the step and gone back to,
   so steps have no error but rounding if no two are in one step. */
TEST(test_line, "line: along any axis, in any order")
{
    make("thermal", NULL);
    const size_t n = scene.bodies;
    for (size_t i = 0; i < n; ++i) {
        const size_t to = n + (i * 7 % n);
        scene.position[to] = scene.position[i];
        scene.velocity[to] = scene.velocity[i];
        scene.freedom[to] = 1;
    }
    double mass[64];
    memcpy(mass, scene.mass, n * sizeof *mass);
    for (size_t i = 0; i < n; ++i) {
        scene.mass[i * 7 % n] = mass[i];
        scene.position[i] = 5;
        scene.velocity[i] = 0;
    }
    WALLS(scene, 1, scene.wall[0], scene.low[0], scene.high[0]);
    scene.wall[0] = SCENE_OPEN;
    UNIT_NEAR(compare("line", "leapfrog:20000", 1, 4).x, 0, 1e-9);
    scene.mass[3] += 1e-9;
    refuses("relabel", "the masses differ");
    scene.velocity[0] = 1e-9;
    refuses("line", "the bodies are not on one line");
    scene.velocity[0] = 0;
    scene.freedom[0] = 0; /* along x it is held anyway */
    refuses("line", "");
    scene.position[0] = 6;
    refuses("line", "the bodies are not on one line");
    make("galperin", NULL);
    RUN r = run_of("line", 100, 1);
    UNIT_EQUAL(r.collisions, 31); /* mass ratio 100: digits of pi */
    UNIT_EQUAL(r.work[MODELS_LINE_EVENT], 31);
    UNIT_EQUAL(r.work[MODELS_LINE_SCAN], 96); /* 31 times, and in the row */
    UNIT_EQUAL(r.work[MODELS_ROW], 1);
}

TEST(test_line_refuses, "line and relabel refuse what is no line")
{
    make("cradle", NULL);
    refuses("relabel", "");
    scene.restitution = 0.9;
    refuses("relabel", "collisions lose energy");
    refuses("line", "");
    scene.freedom[2] = 0;
    refuses("line", "a body is held between others");
    scene.freedom[2] = 1;
    scene.position[1] = 0.15 - 0.5; /* the first is at -0.5 */
    refuses("line", "bodies overlap at the start");
    scene.restitution = 1;
    refuses("relabel", "bodies overlap at the start");
    make_bodies(2); /* without any room between walls */
    scene.contact = true;
    PUT(scene.radius, 0.5, 0.5);
    PUT(scene.position, 0.5, 1.5);
    scene.wall[0] = SCENE_HARD;
    scene.high[0] = 2;
    for (size_t c = 2; c < 6; ++c)
        scene.freedom[c] = 0;
    const struct models_plan p = plan("relabel");
    const char *why;
    RUN r;
    UNIT_MUST(models_begin(&r, &p, &scene, 1, &why));
    UNIT_EQUAL(models_row(&r), MODELS_BROKEN);
    scene.wall[0] = SCENE_PERIODIC;
    refuses("line", "the line is periodic");
    scene.wall[0] = SCENE_HARD;
    WALLS(scene, 1, SCENE_HARD, 0, 1);
    refuses("line", "a wall beside the line is in the way");
    scene.wall[1] = SCENE_OPEN;
    scene.damping = 1;
    refuses("line", "there is friction");
    scene.damping = 0;
    scene.contact = false;
    scene.wall[0] = SCENE_OPEN;
    refuses("line", "nothing collides");
    refuses("disks", "nothing collides");
    refuses("leapfrog:10,no-light", "");
}

/* Twenty scenes of equal rods between walls, with one held as a wall. */
TEST(test_relabel, "relabel: rods of all lengths, as line does them")
{
    SEEDED(random, 5);
    for (int round = 0; round < 20; ++round) {
        const size_t n = 2 + random_below(&random, 12);
        make_bodies(n);
        scene.contact = true;
        for (size_t i = 0; i < n; ++i) {
            scene.position[n - 1 - i] =
                (double)i + random_between(&random, 0.2, 0.8);
            scene.velocity[i] = random_between(&random, -2, 2);
            scene.radius[i] = random_between(&random, 0, 0.1);
        }
        if (round % 2) {
            WALLS(scene, 0, SCENE_HARD, -1, (double)n);
        }
        if (round % 3 == 0)
            scene.freedom[0] = 0; /* the rightmost */
        RUN a = run_of("relabel", 1.7, 6);
        RUN b = run_of("line", 1.7, 6);
        UNIT_NEAR(apart(a.scene.position, b.scene.position, 3 * n), 0,
                  1e-12);
        UNIT_EQUAL(models_collisions(&a), b.collisions);
    }
}

/* Weight along either axis and either way, with walls, or a floor and a
   roof only, against steps of a high order. */
static void test_falling_disks(void)
{
    make("four-disks", NULL);
    for (int way = 0; way < 12; ++way) {
        const size_t down = way & 1, other = 1 - down;
        scene.gravity[down] = way & 2 ? 2 : -2;
        scene.gravity[other] = 0;
        scene.wall[down] = SCENE_HARD;
        scene.wall[other] = (enum scene_wall)(way / 4);
        RUN r = run_of("disks", 0.5, 2);
        UNIT_TRUE(r.collisions > 2);
        UNIT_NEAR(compare("disks", "kahan-li8:1000", 0.5, 2).x, 0, 1e-10);
        UNIT_NEAR(compare("disks", "kahan-li8:1000", 0.5, 2).v, 0, 1e-9);
    }
}

/* Disks in a box, by both engines of events, in an open plane, in a
   periodic box and in space, against steps that go back to the contact: no
   two contacts of a body in one step, no error but rounding. */
TEST(test_disks, "disks: boxes, periodic, open, in space, by cells")
{
    make("gas", (struct wish[]){{"particles", 40}, {0}});
    UNIT_NEAR(compare("disks", "leapfrog:4000", 1, 2).x, 0, 1e-9);
    scene.wall[0] = scene.wall[1] = SCENE_PERIODIC;
    UNIT_NEAR(compare("disks", "leapfrog:4000", 1, 2).x, 0, 1e-9);
    for (int kinds = 0; kinds < 9; ++kinds) { /* all there are, in pairs */
        scene.wall[0] = (enum scene_wall)(kinds % 3);
        scene.wall[1] = (enum scene_wall)(kinds / 3);
        UNIT_NEAR(compare("disks", "leapfrog:4000", 1, 2).x, 0, 1e-9);
    }
    scene.wall[0] = scene.wall[1] = SCENE_OPEN;
    for (size_t i = 0; i < 40; ++i) {
        scene.freedom[80 + i] = 1;
        scene.position[80 + i] = 0.1 * (double)(i % 3);
    }
    scene.velocity[85] = 0.3;
    UNIT_NEAR(compare("disks", "leapfrog:4000", 1, 2).x, 0, 1e-9);
    scene.freedom[3] = 0;
    refuses("disks", "a body is held");
    scene.freedom[3] = 1;
    scene.gravity[1] = 1;
    refuses("disks", "bodies fall for ever");
    scene.wall[2] = SCENE_HARD;
    scene.wall[0] = scene.wall[1] = SCENE_PERIODIC;
    refuses("disks", "bodies fall for ever");
    scene.wall[0] = scene.wall[1] = SCENE_HARD;
    scene.wall[2] = SCENE_PERIODIC;
    refuses("disks", "the walls differ");
    scene.wall[2] = SCENE_HARD;
    scene.gravity[0] = 1;
    refuses("disks", "there is weight along two axes");
    test_falling_disks();
    make("gas", NULL); /* 250: cells */
    UNIT_NEAR(compare("disks", "leapfrog:4000", 0.1, 3).x, 0, 1e-9);
    RUN r = run_of("disks", 0.1, 3);
    UNIT_TRUE(r.collisions > 100 && r.virial > 0);
    UNIT_EQUAL(r.work[MODELS_DISK_EVENT], r.collisions);
    scene.position[0] = scene.position[1];
    scene.position[250] = scene.position[251];
    refuses("disks", "bodies overlap at the start");
}

/* Modes: exact for the linear spring, and an error that falls as the square
   of the swing for a beam. */
TEST(test_modes, "modes: exact if linear, second order if not")
{
    double miss[2];
    make("oscillator", (struct wish[]){{"damping", 0}, {0}});
    scene.damping = 0.3;
    UNIT_NEAR(compare("modes", "oscillator", 1, 10).x, 0, 1e-13);
    for (int k = 0; k < 2; ++k) {
        make("cantilever", (struct wish[]){{"gravity", k ? 1e-3 : 1e-2},
                                           {"friction", 0.1},
                                           {0}});
        miss[k] = compare("modes", "gauss4:400", 0.5, 4).x;
    }
    UNIT_TRUE(miss[0] < 1e-5);
    UNIT_NEAR(miss[0] / miss[1], 100, 20);
    UNIT_TRUE(models_find("modes")->approximate);
    UNIT_TRUE(!models_find("free")->approximate);
    make("membrane", NULL);
    refuses("modes", "dashpots mix the modes");
    make("cantilever", (struct wish[]){{"friction", 0.1}, {0}});
    scene.mass[3] = 2;
    refuses("modes", "friction mixes the modes of unequal masses");
    scene.damping = 0;
    refuses("modes", "");
    make_bodies(3); /* pressed between two walls */
    UNIT_TRUE(scene_add_kind(&scene, 1, 0));
    scene.position[0] = -1;
    scene.position[2] = 1;
    for (size_t k = 0; k < 3; ++k)
        scene.freedom[3 * k] = scene.freedom[3 * k + 2] = 0;
    UNIT_TRUE(scene_add_spring(&scene, 0, 1, 0, 2));
    UNIT_TRUE(scene_add_spring(&scene, 1, 2, 0, 2));
    refuses("modes", ""); /* nothing pushes it aside */
    scene.velocity[4] = 1e-9;
    refuses("modes", "the place of rest is not stable");
}

/* How fast the stiff spring turns that would become a rod: at 2 m/s over
   its length. What it is stretched by does not count; and it is taken out.
 */
TEST(test_turning, "how fast a stiff spring turns")
{
    for (int k = 0; k < 3; ++k) {
        make("double-pendulum",
             (struct wish[]){{"angle1", 0}, {"angle2", 0}, {0}});
        const size_t n = scene.bodies;
        scene.position[1] = scene.position[0] = 0;
        scene.position[n + 1] = scene.position[n] = 0;
        scene.position[2 * n] = 0;
        scene.position[2 * n + 1] = -1.003;
        scene.velocity[2 * n + 1] = k == 1 ? -0.2 : 0;
        scene.velocity[1] = k == 2 ? 2 : 0;
        for (size_t j = 0; j < scene.kinds; ++j)
            if (scene.kind[j].stiffness < 1000)
                scene.kind[j].stiffness = 0;
        UNIT_TRUE(models_rate(&scene, 0) > 10);
        UNIT_NEAR(models_rate(&scene, MODELS_RODS),
                  k == 0   ? 0
                  : k == 1 ? 0.2 / 1.003
                           : 2 / 1.003,
                  1e-12);
    }
}

/* Rods for the stiff spring: chapter 10 found the end of the pendulum 3.8
   to 4.0 mm away after ten seconds (section What a rod buys), and 0.1 s a
   step accurate to 9 to 13 mm. */
TEST(test_rods, "rods: chapter 10's numbers, and a hanging cradle")
{
    make("double-pendulum", NULL);
    const double apart_ten =
        compare("leapfrog:4000,rods", "kahan-li8:1000", 10, 1).x;
    UNIT_TRUE(apart_ten > 0.0038 && apart_ten < 0.0040);
    const double coarse =
        compare("leapfrog:100,rods", "leapfrog:8000,rods", 10, 1).x;
    UNIT_TRUE(coarse > 0.009 && coarse < 0.013);
    RUN r = run_of("leapfrog:100,rods", 10, 1);
    UNIT_EQUAL(r.scene.springs, 1);
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 101);
    UNIT_TRUE(r.work[MODELS_ROD] > 300);
    refuses("rk4:10,rods", "it knows no rods");
    scene.damping = 0.1;
    refuses("leapfrog:10,rods", "rods and friction do not go together");
    make("cradle", (struct wish[]){{"string", 2}, {0}});
    const double hung =
        compare("leapfrog:100,rods", "kahan-li8:1000", 0.1, 10).x;
    UNIT_TRUE(hung < 1e-3); /* the strings' D is 1e5 N/m */
}

TEST(test_acts, "what acts is told exactly")
{
    struct models_acts a;
    make("sun-earth", NULL);
    models_analyse(&a, &scene);
    UNIT_TRUE(a.gravity && !a.springs && !a.weight && !a.contact);
    UNIT_EQUAL(a.axes, 3);
    UNIT_EQUAL(a.dimensions, 2);
    UNIT_EQUAL(a.free, 2);
    UNIT_NEAR(models_rate(&scene, 0), 0.0172, 1e-6);
    scene.mass[0] = scene.mass[1] = 0;
    models_analyse(&a, &scene);
    UNIT_TRUE(!a.gravity);
    UNIT_EQUAL(a.axes, 2); /* the Earth flies on along y */
    make("cradle", NULL);
    models_analyse(&a, &scene);
    UNIT_TRUE(a.contact && !a.gravity);
    UNIT_EQUAL(a.axes, 1);
    UNIT_EQUAL(a.offset, 1);
    scene.freedom[5 + 2] = 1;
    models_analyse(&a, &scene);
    UNIT_EQUAL(a.axes, 1);
    scene.velocity[5 + 2] = 1e-300;
    models_analyse(&a, &scene);
    UNIT_EQUAL(a.axes, 3);
    make("membrane", NULL);
    models_analyse(&a, &scene);
    UNIT_TRUE(a.springs && a.dashpots && !a.friction);
    const double fastest = models_rate(&scene, 0); /* sqrt(8 D/m) */
    UNIT_TRUE(fastest >= 20 && fastest < 20.1);
    scene.wall[0] = SCENE_HARD;
    refuses("leapfrog:10", "there are walls, but no contact");
    make("double-pendulum", NULL); /* at rest; x and z are pushed */
    models_analyse(&a, &scene);
    UNIT_EQUAL(a.axes, 5);
    for (size_t i = 0; i < 3; ++i)
        scene.position[i] = 0; /* it hangs: only z is */
    models_analyse(&a, &scene);
    UNIT_EQUAL(a.axes, 4);
}

TEST(test_meeting, "points on a line meet as in line only")
{
    static const char unseen[] = "points on a line collide only as in line";
    make_bodies(2);
    scene.contact = true;
    scene.position[1] = 1;
    scene.velocity[0] = 1.5;
    refuses("line", "");
    refuses("disks", unseen);
    refuses("leapfrog:10", unseen);
    refuses("radau15:1e-6", unseen);
    scene.radius[0] = 1e-9;
    refuses("leapfrog:10", "");
    scene.radius[0] = 0;
    scene.velocity[2] = 1; /* beside each other, without radii */
    refuses("disks", "");
}

/* A body so fast that its row would not end costs too much at once, though
   it meets only walls. */
TEST(test_endless, "a row without end ends at once")
{
    const struct models_plan p = plan("disks");
    const char *why;
    RUN r;
    make_bodies(1);
    scene.contact = true;
    scene.wall[0] = scene.wall[1] = SCENE_HARD;
    scene.high[0] = scene.high[1] = 1;
    scene.position[0] = scene.position[1] = 0.5;
    PUT(scene.velocity, 1e12, 3e11);
    UNIT_TRUE(models_begin(&r, &p, &scene, 1, &why));
    r.limit = 1;
    UNIT_EQUAL(models_row(&r), MODELS_COSTLY);
}

/* Overlaps at the start, whichever way the bodies go; walls, beyond which
   a body does not come back from; and those that touch. */
TEST(test_overlap, "how deep bodies overlap at the start")
{
    make("four-disks", NULL);
    const size_t n = scene.bodies;
    UNIT_EQUAL(spheres_depth(&scene), 0);
    scene.position[0] = scene.low[0] + scene.radius[0] - 0.03;
    scene.velocity[0] = -1;
    UNIT_NEAR(spheres_depth(&scene), 0.03, 1e-15);
    scene.freedom[0] = 0; /* it cannot be pushed */
    UNIT_EQUAL(spheres_depth(&scene), 0);
    scene.freedom[0] = 1;
    scene.velocity[0] = 1; /* comes back, and bounces from nothing */
    UNIT_EQUAL(spheres_depth(&scene), 0);
    const double reach = scene.radius[0] + scene.radius[1];
    scene.position[1] = scene.position[0] + 0.75 * reach;
    scene.position[n + 1] = scene.position[n];
    for (int way = -1; way <= 1; ++way) {
        scene.velocity[1] = 1 + way;
        UNIT_NEAR(spheres_depth(&scene), 0.25 * reach, 1e-15);
    }
    scene.position[1] = scene.position[0] + reach;
    UNIT_TRUE(spheres_depth(&scene) < 1e-15);
    scene.position[1] = scene.position[0] + 0.75 * reach;
    scene.contact = false;
    UNIT_EQUAL(spheres_depth(&scene), 0);
}

/* Beyond a wall for good are bodies that are at rest there and those that
   move on, at either wall, along each axis; not those that come back, and
   not where there is no wall to come back to. */
TEST(test_beyond, "who is beyond a wall for good")
{
    make("four-disks", NULL);
    const size_t n = scene.bodies;
    for (size_t i = 0; i < 3 * n; ++i)
        scene.velocity[i] = 0;
    for (size_t k = 0; k < 2; ++k)
        for (int side = -1; side <= 1; side += 2)
            for (int way = -1; way <= 1; ++way) {
                double *x = &scene.position[k * n], was = *x;
                *x = side < 0 ? scene.low[k] + scene.radius[0] - 0.05
                              : scene.high[k] - scene.radius[0] + 0.05;
                scene.velocity[k * n] = way * 1e-9;
                /* Others do not matter here. */
                scene.contact = true;
                for (size_t i = 1; i < n; ++i)
                    scene.position[(1 - k) * n + i] =
                        scene.position[(1 - k) * n];
                for (size_t i = 1; i < n; ++i)
                    scene.radius[i] = 1e-3;
                for (size_t i = 1; i < n; ++i)
                    scene.position[k * n + i] = 0.4 + 0.05 * (double)i;
                UNIT_NEAR(spheres_depth(&scene), way == -side ? 0 : 0.05,
                          1e-15);
                scene.wall[k] = SCENE_OPEN;
                UNIT_EQUAL(spheres_depth(&scene), 0);
                scene.wall[k] = SCENE_HARD;
                scene.velocity[k * n] = 0;
                *x = was;
            }
}

/* A ball of radius 0.05 that flies at 1 m/s between held ones of radius 0.1
   and 0.2 at 0 and 1 has its places from 0.15 to 0.75: after T it is where
   a saw of that length is. Along any axis, from either side, by each model.
 */
TEST(test_between_held, "between held balls")
{
    static const char *const plans[] = {"line", "relabel"};
    for (size_t k = 0; k < 3; ++k)
        for (int side = -1; side < 2; side += 2)
            for (size_t p = 0; p < 2; ++p) {
                make_bodies(3);
                scene.contact = true;
                for (size_t c = 0; c < 9; ++c)
                    scene.freedom[c] = c == 3 * k + 1;
                PUT(scene.radius, 0.1, 0.05, 0.2);
                scene.position[3 * k + 1] = side * 0.4;
                scene.position[3 * k + 2] = side;
                scene.velocity[3 * k + 1] = side;
                RUN r = run_of(plans[p], 0.37, 20);
                const double way = fmod(0.25 + 20 * 0.37, 1.2);
                UNIT_NEAR(side * r.scene.position[3 * k + 1],
                          0.15 + (way < 0.6 ? way : 1.2 - way), 1e-13);
                UNIT_EQUAL(models_collisions(&r),
                           floor((0.25 + 20 * 0.37) / 0.6));
            }
}

/* A mass on a spring of length l turns the spring round if its energy is
   that of the spring shortened to nothing: m v^2 + D A^2 = D l^2. Just
   below that the closed form is right, just above it the motion is another
   one. */
TEST(test_turns_round, "how much energy turns a spring round")
{
    static const struct {
        double mass, stiffness, displacement, velocity; /* on the border */
    } border[] = {{1, 1, 4, 0},         {1, 9, 0, 12},
                  {4, 1, 0, -2},        {4, 9, 2.4, 4.8},
                  {0.25, 4, -3.2, 9.6}, {2, 0.5, 2.4, 1.6}};
    for (size_t k = 0; k < sizeof border / sizeof border[0]; ++k)
        for (int beyond = 0; beyond < 2; ++beyond) {
            const double share = beyond ? 1.0001 : 0.9999;
            make("oscillator",
                 (struct wish[]){{"mass", border[k].mass},
                                 {"stiffness", border[k].stiffness},
                                 {"damping", 0},
                                 {0}});
            scene.position[1] = 4 + share * border[k].displacement;
            scene.velocity[1] = share * border[k].velocity;
            refuses("oscillator", beyond ? "a spring may turn round" : "");
            for (size_t i = 0; i < 2; ++i) /* seen from elsewhere */
                scene.position[i] -= 16;
            refuses("oscillator", beyond ? "a spring may turn round" : "");
            for (size_t i = 0; i < 2; ++i)
                scene.position[i] = -scene.position[i];
            scene.velocity[1] = -scene.velocity[1];
            refuses("oscillator", beyond ? "a spring may turn round" : "");
        }
}

/* Light bodies, and stiff springs. */
TEST(test_cuts, "what can be left out, and that it is")
{
    make("ring", (struct wish[]){{"particles", 10}, {0}});
    UNIT_EQUAL(models_cuts(&scene), MODELS_NO_LIGHT);
    const double heavy = scene.mass[0];
    for (size_t i = 1; i < 11; ++i)
        scene.mass[i] = heavy / 99;
    UNIT_EQUAL(models_cuts(&scene), 0);
    scene.mass[4] = heavy / 101;
    UNIT_EQUAL(models_cuts(&scene), MODELS_NO_LIGHT);
    scene.mass[4] = 0; /* pulls nobody anyway */
    UNIT_EQUAL(models_cuts(&scene), 0);
    scene.mass[4] = heavy / 101;
    scene.k2 = 0;
    UNIT_EQUAL(models_cuts(&scene), 0);
    make("double-pendulum", NULL);
    UNIT_EQUAL(models_cuts(&scene), MODELS_RODS);
    scene.kind[0].stiffness = scene.kind[1].stiffness;
    UNIT_EQUAL(models_cuts(&scene), MODELS_RODS); /* all are alike */
    scene.kind[0].stiffness *= 99;
    UNIT_EQUAL(models_cuts(&scene), 0);
}

/* What makes another scene of it is asked for by name: each plan does in
   the scene what it does in one without that, to the bit. */
TEST(test_leaving_out, "what makes another scene can be left out by name")
{
    static const char *const names[] = {"no-softening", "no-friction",
                                        "no-dashpots",  "no-weak",
                                        "no-weight",    "no-pull"};
    for (size_t k = 0; k < 6; ++k) {
        char text[64];
        make_bodies(3);
        UNIT_TRUE(scene_add_kind(&scene, 5, 0.3));
        UNIT_TRUE(scene_add_kind(&scene, 0.04, 0));
        UNIT_TRUE(scene_add_spring(&scene, 0, 1, 0, 0.7));
        UNIT_TRUE(scene_add_spring(&scene, 1, 2, 1, 0.7));
        scene.position[1] = scene.position[5] = 1;
        scene.k2 = scene.softening = scene.damping = 0.2;
        scene.gravity[1] = -1;
        snprintf(text, sizeof text, "gauss4:9,%s", names[k]);
        RUN with = run_of("gauss4:9", 0.5, 2);
        RUN a = run_of(text, 0.5, 2);
        UNIT_TRUE(apart(a.scene.position, with.scene.position, 9) > 1e-4);
        scene.softening *= k != 0;
        scene.damping *= k != 1;
        scene.kind[0].damping *= k != 2;
        scene.kind[1].stiffness *= k != 3;
        scene.gravity[1] *= k != 4;
        scene.k2 *= k != 5;
        RUN b = run_of("gauss4:9", 0.5, 2);
        UNIT_EQUAL(apart(a.scene.position, b.scene.position, 9), 0);
    }
    make("sun-earth", NULL);
    scene.softening = 0.01;
    refuses("kepler,no-softening", "");
}

/* A cradle along any axis with a ball that is aside, one that moves there,
   and weight: without what is across it is the cradle, to the bit. */
TEST(test_across, "what is across a line is left out")
{
    make("cradle", NULL);
    const size_t n = scene.bodies;
    scene.wall[0] = SCENE_OPEN;
    RUN straight = run_of("line", 1, 5);
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t beside = (axis + 1) % 3 * n;
        for (size_t i = 0; i < n; ++i)
            for (size_t k = 0; k < 3; ++k) {
                const size_t c = k * n + i;
                scene.freedom[c] = 1;
                scene.position[c] =
                    k == axis ? straight.origin.position[i] : 0;
                scene.velocity[c] =
                    k == axis ? straight.origin.velocity[i] : 0;
            }
        scene.position[beside + 2] = 0.01;
        scene.velocity[beside + 1] = 0.01;
        for (size_t k = 0; k < 3; ++k)
            scene.gravity[k] = k == axis ? 0 : -1;
        refuses("line", "the bodies are not on one line");
        RUN r = run_of("line,no-across", 1, 5);
        UNIT_EQUAL(
            apart(r.scene.position + axis * n, straight.scene.position, n),
            0);
        for (size_t i = 0; i < n; ++i)
            UNIT_TRUE(r.scene.position[beside + i] == 0 &&
                      r.scene.velocity[beside + i] == 0);
    }
}

TEST(test_text, "plans are read as they were written")
{
    static const char *const same[] = {"free", "pefrl:24",
                                       "kepler,no-light",
                                       "leapfrog:1000000000000,rods"};
    char text[MODELS_TEXT];
    for (size_t i = 0; i < 4; ++i) {
        struct models_plan p = plan(same[i]);
        models_write(&p, text);
        UNIT_SAYS(text, same[i]);
    }
    struct models_plan all = plan("implicit-midpoint:1000000000000");
    all.cuts = (1u << MODELS_CUTS) - 1;
    models_write(&all, text);
    const struct models_plan again = plan(text);
    UNIT_TRUE(again.model == all.model && again.cuts == all.cuts &&
              again.steps == all.steps);
}

/* A model that there is not hears of all that there are. */
static void check_list(const char *wrong)
{
    char message[MODELS_MESSAGE], list[MODELS_MESSAGE];
    struct models_plan p;
    int used = sprintf(list,
                       "found '%s', expected one of free, kepler, "
                       "oscillator, relabel, modes, line, disks",
                       wrong);
    for (const struct stepping_method *m = stepping_methods; m->name; ++m)
        used += sprintf(list + used, ", %s", m->name);
    UNIT_TRUE(!models_read(&p, wrong, message));
    UNIT_SAYS(message, list);
}

/* A tolerance of a method with steps of its own is from 1e-16 to 1. */
TEST(test_text_tolerance, "tolerances in a plan")
{
    static const struct {
        const char *text;
        double tolerance; /* NAN: refused */
    } known[] = {{"dopri5:1", 1},        {"dopri5:1e-16", 1e-16},
                 {"radau15:0.25", 0.25}, {"dopri5:1.001", NAN},
                 {"dopri5:2", NAN},      {"dopri5:9e-17", NAN},
                 {"dopri5:0", NAN},      {"dopri5:-1", NAN},
                 {"dopri5:x", NAN},      {"dopri5:", NAN},
                 {"dopri5:nan", NAN},    {"dopri5:inf", NAN}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        struct models_plan p = {0};
        char message[MODELS_MESSAGE] = "", text[MODELS_TEXT];
        const bool good = models_read(&p, known[k].text, message);
        if (good == isnan(known[k].tolerance))
            printf("# %s: %s\n", known[k].text, message);
        UNIT_TRUE(good != isnan(known[k].tolerance));
        UNIT_TRUE(good == (message[0] == '\0'));
        if (!good)
            continue;
        UNIT_EQUAL(p.tolerance, known[k].tolerance);
        models_write(&p, text);
        UNIT_TRUE(models_read(&p, text, message));
        UNIT_EQUAL(p.tolerance, known[k].tolerance);
    }
}

TEST(test_text_errors, "what is no plan")
{
    static const char *const wrong[][2] = {
        {"rk4:", "found '', expected a whole number of steps from 1 to "
                 "10^12"},
        {"rk4:0", "found '0', expected a whole number of steps from 1 to "
                  "10^12"},
        {"rk4:1e3", "found '1e3', expected a whole number of steps from 1 "
                    "to 10^12"},
        {"rk4:1000000000001", "found '1000000000001', expected a whole "
                              "number of steps from 1 to 10^12"},
        {"kepler:3", "found '3', expected no steps with this model"},
        {"rk4:2,no-lights",
         "found 'no-lights', expected one of no-light, rods, "
         "no-softening, no-friction, no-dashpots, no-weak, no-weight, "
         "no-pull, no-across"},
        {"rk4:2,", "found '', expected one of no-light, rods, "
                   "no-softening, no-friction, no-dashpots, no-weak, "
                   "no-weight, no-pull, no-across"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        struct models_plan p;
        char message[MODELS_MESSAGE];
        UNIT_TRUE(!models_read(&p, wrong[i][0], message));
        UNIT_SAYS(message, wrong[i][1]);
    }
    for (int longer = 0; longer < 2; ++longer) { /* than there is room */
        char text[MODELS_TEXT + 1], message[MODELS_MESSAGE];
        struct models_plan p;
        size_t used = (size_t)sprintf(text, longer ? "rk4:12" : "rk4:2");
        while (used + 5 <= MODELS_TEXT)
            used += (size_t)sprintf(text + used, ",rods");
        UNIT_EQUAL(used, MODELS_TEXT - 1 + longer);
        UNIT_EQUAL(models_read(&p, text, message), !longer);
    }
    check_list("");
    check_list("keppler");
    make("sun-earth", NULL);
    refuses("rk4", "it needs a number of steps");
    refuses("line,no-light", "it does not ask who pulls");
}

/* The last models are the methods of chapter 8, in its order; leapfrog
   alone can have rods. */
TEST(test_table, "the table has every method of chapter 8")
{
    const struct models_model *m = models_all();
    for (; m->name && !m->method; ++m)
        UNIT_TRUE(m->family != MODELS_STEPS && models_find(m->name) == m);
    make("double-pendulum", NULL);
    for (const struct stepping_method *k = stepping_methods; k->name;
         ++k, ++m) {
        const struct models_plan rods = {
            .model = m, .cuts = MODELS_RODS, .steps = 1};
        UNIT_TRUE(m->family == MODELS_STEPS && !m->approximate);
        UNIT_TRUE(m->method == k);
        UNIT_TRUE(m->name == m->method->name && models_find(m->name) == m);
        UNIT_TRUE((models_refuse(&rods, &scene) == NULL) ==
                  stepping_is_leapfrog(m->method));
    }
    UNIT_TRUE(m->name == NULL);
}

/* What a run by each method books is what it did: the places are those of
   the method of this name, and the evaluations those of its row. */
TEST(test_books, "and each one books what it does")
{
    make("sun-earth", NULL);
    for (const struct stepping_method *k = stepping_next(NULL); k;
         k = stepping_next(k)) {
        char text[64];
        FREED(scene) s;
        ENDED(motion) m;
        snprintf(text, sizeof text, "%s:64", k->name);
        RUN r = run_of(text, 64, 1);
        UNIT_TRUE(scene_copy(&s, &scene) &&
                  motion_begin(&m, "models", &s, k->name, 1));
        UNIT_TRUE(motion_run(&m, 64) == STEPPING_DONE);
        const double asked = r.work[MODELS_EVALUATION];
        const size_t size = 6 * sizeof *s.position;
        UNIT_TRUE(memcmp(r.scene.position, s.position, size) == 0);
        UNIT_EQUAL(asked, m.stepping.evaluations);
        UNIT_TRUE(k->family == STEPPING_IMPLICIT
                      ? asked > 64.0 * (double)k->stages
                      : asked - 64.0 * (double)k->stages <= 1);
    }
}

/* Work is what was done, whatever the number of rows; at the limit of the
   cost a row ends. */
TEST(test_work, "work is counted, and limited")
{
    make("choreography", (struct wish[]){{"particles", 5}, {0}});
    RUN r = run_of("pefrl:50", 0.1, 3);
    UNIT_EQUAL(r.work[MODELS_EVALUATION], 600);
    UNIT_EQUAL(r.work[MODELS_BODY], 3000);
    UNIT_EQUAL(r.work[MODELS_PAIR], 6000);
    UNIT_NEAR(models_cost(r.work),
              (600 * models_prices[MODELS_EVALUATION].ns +
               3000 * models_prices[MODELS_BODY].ns +
               6000 * models_prices[MODELS_PAIR].ns +
               3 * models_prices[MODELS_ROW].ns) *
                  1e-9,
              1e-18);
    r.limit = models_cost(r.work) * 1.01;
    UNIT_EQUAL(models_row(&r), MODELS_COSTLY);
    models_end(&r);
    make("gas", NULL);
    r = run_of("disks", 0.1, 1);
    r.limit = models_cost(r.work) * 1.01;
    UNIT_EQUAL(models_row(&r), MODELS_COSTLY);
    models_end(&r);
    /* Contacts within a step divide it, and each part has its paths. */
    r = run_of("leapfrog:10", 0.1, 1);
    UNIT_TRUE(r.collisions > 40 && r.collisions < 200);
    UNIT_TRUE(r.work[MODELS_CONTACT] > 2500 + 250 * 40.0);
    UNIT_TRUE(r.work[MODELS_CONTACT] <=
              2500 + 250.0 * (double)r.collisions);
    models_end(&r);
    /* Nobody meets or comes near another in the first 0.1 s: five paths a
       step. A stage of rk4 counts twice, and a pendulum's springs, in no
       band, ten times. */
    make("cradle", NULL);
    r = run_of("rk4:50", 0.1, 1);
    UNIT_EQUAL(r.collisions, 0);
    UNIT_EQUAL(r.work[MODELS_CONTACT], 250);
    UNIT_EQUAL(r.work[MODELS_OVERLAP], 0);
    UNIT_EQUAL(r.work[MODELS_BODY], 50 * 4 * 5 * 2);
    models_end(&r);
    /* Steps of its own length: their work, and the look at the end of each
       row, which is worth 18 passes over two bodies. */
    make("sun-earth", NULL);
    struct models_run few = run_of("radau15:1e-10", 1000, 1);
    r = run_of("radau15:1e-10", 10, 100);
    const double asked = r.work[MODELS_EVALUATION];
    UNIT_TRUE(asked > 200 && asked == few.work[MODELS_EVALUATION]);
    UNIT_EQUAL(r.work[MODELS_BODY] - few.work[MODELS_BODY], 99 * 2 * 18);
    models_end(&few);
    models_end(&r);
    make("double-pendulum", NULL);
    r = run_of("symplectic-euler:50", 0.1, 1);
    UNIT_EQUAL(r.work[MODELS_SPRING], 50 * 2 * 10);
}

/* Two bodies fall side by side, and one passes the other from -100 to 100
   at a distance of 1. Beside their weight what attracts them is nothing, so
   it is only 0.7 r/v that bounds a step. By hand that is so many steps,
   from a first one of a hundredth of a second and none of more than five
   times the one before. */
TEST(test_passage, "steps of their own length see a passage")
{
    const char *why;
    RUN r;
    double steps = 0, h = 0.01;
    for (double x = -100; x < 100; x += h, ++steps)
        h = fmin(steps > 0 ? 5 * h : h, 0.7 * sqrt(x * x + 1));
    scene_free(&scene);
    scene = light_orbit(-100, 0);
    scene.position[3] = 1;
    scene.velocity[1] = 1;
    scene.velocity[3] = 0;
    scene.gravity[1] = -1;
    scene.k2 = 1e-9;
    struct models_plan p = plan("radau15:1");
    p.negligible = 1e-12;
    p.time_left = 200;
    UNIT_TRUE(models_begin(&r, &p, &scene, 200, &why));
    UNIT_TRUE(models_row(&r) == MODELS_DONE);
    UNIT_NEAR(r.work[MODELS_EVALUATION], 8 * steps, 8);
}

TEST(test_ends, "runs that break down or stand still")
{
    const char *why;
    struct models_run r;
    make("double-pendulum", NULL);
    struct models_plan p = plan("leapfrog:2000");
    UNIT_TRUE(models_begin(&r, &p, &scene, 100, &why));
    UNIT_EQUAL(models_row(&r), MODELS_BROKEN);
    models_end(&r);
    make("cradle", (struct wish[]){{"restitution", 0.1}, {"gap", 0}, {0}});
    p = plan("line");
    UNIT_TRUE(models_begin(&r, &p, &scene, 100, &why));
    enum models_end end = MODELS_DONE;
    for (int k = 0; k < 20 && end == MODELS_DONE; ++k)
        end = models_row(&r);
    UNIT_EQUAL(end, MODELS_STANDSTILL);
    models_end(&r);
    UNIT_TRUE(!models_begin(&r, &p, &scene, 0, &why));
}

/* Of many bodies the start and the rows are a part of the bill. Of ninety
   disks each is three times looked at by half of the others. 250 get lists
   of neighbours, at the start and whenever one has left its skin, which in
   10 s at 1 m/s all have ten times, as a skin is thinner than a metre. In
   each row light bodies that do not pull are five passes each, besides the
   pass of each call of the forces. */
TEST(test_start_and_rows, "the start and the rows are on the bill")
{
    make("gas", (struct wish[]){{"particles", 90}, {0}});
    RUN r = run_of("disks", 1e-9, 1);
    UNIT_EQUAL(r.work[MODELS_RENEWAL], 0);
    UNIT_EQUAL(r.work[MODELS_DISK_SCAN], 90 * 135);
    models_end(&r);
    make("gas", (struct wish[]){{"particles", 250}, {0}});
    r = run_of("disks", 1e-9, 1);
    UNIT_EQUAL(r.work[MODELS_RENEWAL], 250);
    models_end(&r);
    r = run_of("disks", 10, 1);
    UNIT_TRUE(r.work[MODELS_RENEWAL] > 10 * 250);
    models_end(&r);
    make("ring", (struct wish[]){{"particles", 300}, {0}});
    const double n = (double)scene.bodies;
    r = run_of("leapfrog:2,no-light", 1, 4);
    UNIT_EQUAL(r.work[MODELS_BODY],
               n * r.work[MODELS_EVALUATION] + 4 * 5 * n);
    UNIT_TRUE(r.work[MODELS_ORDER] >= 5 * n * 8);
    models_end(&r);
    r = run_of("leapfrog:2", 1, 4);
    UNIT_EQUAL(r.work[MODELS_BODY], n * r.work[MODELS_EVALUATION]);
    UNIT_EQUAL(r.work[MODELS_ORDER], 0);
}

/* To find modes costs as the cube of the coordinates, again and again. A
   start that fails stays on the bill, and one that may cost no more than
   one and a half of these stops after the first. */
TEST(test_start_bounded, "a start that fails is paid, and bounded")
{
    make("cantilever", NULL);
    struct models_plan p = plan("modes");
    struct models_run r;
    const char *why;
    UNIT_TRUE(models_begin(&r, &p, &scene, 1, &why));
    const double all = r.work[MODELS_MODE];
    models_end(&r);
    double size = 0;
    for (size_t c = 0; c < 3 * scene.bodies; ++c)
        size += scene.freedom[c] && c < 2 * scene.bodies;
    const double once = 20 * size * size * size;
    UNIT_TRUE(all >= 2 * once);
    p.start_limit = 1.5 * once * 1e-9 * models_prices[MODELS_MODE].ns;
    UNIT_TRUE(!models_begin(&r, &p, &scene, 1, &why));
    UNIT_EQUAL(r.work[MODELS_MODE], once);
    UNIT_SAYS(why, "its start costs more than is reasonable");
}
