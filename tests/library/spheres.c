/* Spheres in steps: a pair by hand, what each rule keeps, the sweep against
   every pair, a row of balls against fractions worked out by hand (a heavy
   first ball: (1/3)^k), and chapter 7's identity between walls and virial.
 */
#include "unit.h"

#include "forces/hard.h"
#include "forces/spheres.h"
#include "toolbox/random.h"

static void make(struct scene *s, size_t bodies)
{
    UNIT_MUST(scene_create(s, bodies));
    s->contact = true;
    for (size_t i = 0; i < bodies; ++i)
        s->radius[i] = 0.5;
}

static void begin(struct spheres *p, const struct scene *s,
                  enum spheres_rule rule, enum spheres_shift shift,
                  double dt)
{
    UNIT_TRUE(spheres_create(p, s, rule));
    p->shift = shift;
    p->dt = dt;
}

static void fly(struct scene *s, double dt)
{
    for (size_t i = 0; i < SCENE_AXES * s->bodies; ++i)
        s->position[i] += s->velocity[i] * dt;
}

static void run(struct scene *s, struct spheres *p, int steps)
{
    for (int k = 0; k < steps; ++k) {
        fly(s, p->dt);
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

static double total(const struct scene *s, const double x[])
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i] * x[i];
    return sum;
}

/* Two of radius 0.5 whose centres are 0.75 apart, 3 kg against 1 kg. */
static void begin_pair(struct scene *s)
{
    make(s, 2);
    s->mass[0] = 3;
    s->position[1] = 0.75;
    PUT(s->velocity, 1, -1);
}

/* v = 1 and -1 with 3 kg and 1 kg: the centre moves at 1/2, so out come 0
   and 2. The depth is 0.25. They have touched 1/8 s ago, at -1/8 and 7/8;
   going back, the first has stood there since, and the second has gone on
   to 9/8. Nobody goes back for more than a step: pushed apart by mass
   instead.
 */
TEST(test_shares,
     "the depth is shared, or they go back to where they should be")
{
    static const struct {
        enum spheres_shift shift;
        double dt, first, second;
    } known[] = {{SPHERES_BY_RADIUS, 1, -0.125, 0.875},
                 {SPHERES_BY_MASS, 1, -0.0625, 0.9375},
                 {SPHERES_BACK, 1, -0.125, 1.125},
                 {SPHERES_BACK, 0.0625, -0.0625, 0.9375}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        FREED(spheres) p;
        MADE(scene, s, begin_pair(&s));
        begin(&p, &s, SPHERES_APPROACHING, known[k].shift, known[k].dt);
        UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 1);
        UNIT_LIST(s.velocity, 0, 0, 2);
        UNIT_LIST(s.position, 0, known[k].first, known[k].second);
        UNIT_EQUAL(p.depth, 0.25);
    }
}

/* Glancing hits, found late, against where both would be if they had been
   reflected in time: going back must put them there. Lengths in units of
   the distance of contact, 0.5. 1e-13: sums of a few numbers near 1, where
   the normal of a graze loses a digit or two. */
TEST(test_oblique, "oblique hits found late are made good")
{
    const double unit = 0.5;
    SEEDED(r, 5);
    for (int k = 0; k < 1000; ++k) {
        const double b = random_between(&r, -0.95, 0.95);
        const double tau = random_between(&r, 0, 0.3);
        const double along = sqrt(1 - b * b); /* contact at (along, b) */
        FREED(spheres) p;
        MADE(scene, s, make(&s, 2));
        PUT(s.radius, 0.2, 0.3);
        s.mass[1] = random_between(&r, 0.5, 2);
        s.position[1] = unit * (along - tau);
        s.position[3] = unit * b;
        s.velocity[1] = -unit;
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BACK, 1);
        if (spheres_resolve(&p, s.position, s.velocity) == 1) {
            const double J = 2 * along / (1 + 1 / s.mass[1]);
            const double J1 = J / s.mass[1];
            UNIT_NEAR(s.velocity[0] / unit, -J * along, 1e-13);
            UNIT_NEAR(s.velocity[2] / unit, -J * b, 1e-13);
            UNIT_NEAR(s.position[0] / unit, -J * along * tau, 1e-13);
            UNIT_NEAR(s.position[1] / unit, along + (J1 * along - 1) * tau,
                      1e-13);
            UNIT_NEAR(s.position[3] / unit, b + J1 * b * tau, 1e-13);
        } else /* through the rim: out again within tau */
            UNIT_TRUE(tau > 2 * along);
    }
}

/* A velocity goes through a row of narrow gaps in one step, if the order is
   that of the row; the third is touched by nobody before its turn. */
TEST(test_in_one_step, "a velocity goes through a row in a step")
{
    MADE(scene, s, make(&s, 3));
    s.position[1] = 0.875;
    s.position[2] = 1.9375; /* a gap of 1/16 to where 1 goes back from */
    s.velocity[0] = 1;
    MADE(spheres, p, begin(&p, &s, SPHERES_APPROACHING, SPHERES_BACK, 1));
    UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 2);
    UNIT_EQUAL(s.velocity[2], 1);
    UNIT_LIST(s.position, 0, -0.125, 0.9375, 2);
}

/* 1 and the heavy 0 come at each other with 1 m/s in steps of 0.1 s, and
   are 0.19 m deep in each other, which only 1 gives way for; so it is
   pushed on to 2, which stands 0.18 m from it. In the same step those
   collide. */
TEST(test_pushed, "who is pushed meets the next")
{
    for (int way = 0; way < 12; ++way) {
        FREED(spheres) p;
        const size_t heavy = way % 2 ? 2 : 0, far = 2 - heavy;
        const size_t k = (size_t)(way / 4);
        MADE(scene, s, make(&s, 3));
        double *const x = s.position + 3 * k, *const v = s.velocity + 3 * k;
        s.mass[heavy] = 1e9;
        x[heavy] = 0;
        x[1] = 0.62;
        x[far] = 1.98;
        v[heavy] = 4;
        v[1] = -4;
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, 0.05);
        p.search = way / 2 % 2 ? SPHERES_SWEEP : SPHERES_PAIRS;
        p.order = heavy ? SPHERES_DESCENDING : SPHERES_ASCENDING;
        UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 2);
        UNIT_NEAR(v[far], 12, 1e-7);
    }
}

/* The way to the nearest image, on either side of half a box of 2 m. */
TEST(test_nearest, "images are the nearest")
{
    static const double at[] = {0.95, 1.05, -0.95, -1.05, 2.9, -3.1},
                        way[] = {0.95, -0.95, -0.95, 0.95, 0.9, 0.9};
    MADE(scene, s, make(&s, 2));
    WALLS(s, 1, SCENE_PERIODIC, 5, 7);
    for (size_t i = 0; i < sizeof at / sizeof at[0]; ++i) {
        s.position[1] = s.position[3] = at[i];
        UNIT_NEAR(spheres_way(&s, s.position, 0, 1, 1), way[i], 1e-15);
        UNIT_NEAR(spheres_way(&s, s.position, 1, 0, 1), -way[i], 1e-15);
        UNIT_EQUAL(spheres_way(&s, s.position, 0, 1, 0), at[i]);
    }
}

/* Parting pairs: the paper throws them back, the other rule does not. */
TEST(test_parting, "only the paper reflects pairs that part")
{
    for (int rule = SPHERES_ALL; rule <= SPHERES_APPROACHING; ++rule) {
        MADE(scene, s, begin_pair(&s));
        PUT(s.velocity, -1, 1);
        MADE(spheres, p, begin(&p, &s, rule, SPHERES_BY_MASS, 1));
        spheres_resolve(&p, s.position, s.velocity);
        UNIT_EQUAL(s.velocity[1], rule == SPHERES_ALL ? -2 : 1);
        UNIT_EQUAL(p.receding, rule == SPHERES_ALL);
        UNIT_EQUAL(s.position[1] - s.position[0], 1);
    }
}

static void collide(struct scene *s)
{
    FREED(spheres) p;
    begin(&p, s, SPHERES_APPROACHING, SPHERES_BY_RADIUS, 1);
    spheres_resolve(&p, s->position, s->velocity);
}

/* A fixed body is a wall; one that is free along x only moves along x, and
   the energy is kept. By hand: the normal is (3, 4)/5, 1 kg at (0, -1)
   comes down on it: J = 2 (4/5) / (9/25 + 1). */
TEST(test_fixed, "what is fixed along an axis stays")
{
    MADE(scene, s, make(&s, 2));
    s.freedom[2] = s.freedom[4] = 0; /* body 0 along y, z */
    s.position[1] = 0.54;
    s.position[3] = 0.72; /* 0.9 apart */
    s.velocity[3] = -1;
    collide(&s);
    const double J = 1.6 / 1.36;
    UNIT_NEAR(s.velocity[0], -0.6 * J, 1e-15);
    UNIT_EQUAL(s.velocity[2], 0);
    UNIT_NEAR(s.velocity[1], 0.6 * J, 1e-15);
    UNIT_NEAR(s.velocity[3], 0.8 * J - 1, 1e-15);
    UNIT_NEAR(energy(&s), 0.5, 1e-15);
    UNIT_EQUAL(s.position[2], 0);
    s.freedom[0] = 0; /* now wholly fixed */
    PUT(s.position, 0, 0.9);
    s.position[3] = s.velocity[0] = s.velocity[3] = 0;
    s.velocity[1] = -1;
    collide(&s);
    UNIT_EQUAL(s.velocity[1], 1);
    UNIT_EQUAL(s.position[0], 0);
    UNIT_NEAR(s.position[1], 1, 1e-15);
    s.freedom[0] = 1; /* and the other way round */
    s.freedom[1] = 0;
    s.position[1] = 0.9;
    PUT(s.velocity, 1, 0);
    collide(&s);
    UNIT_EQUAL(s.velocity[0], -1);
    UNIT_NEAR(s.position[0], -0.1, 1e-15);
    UNIT_EQUAL(s.position[1], 0.9);
}

/* What locates contacts asks for: velocities and counts alone. 2 kg at
   4 m/s and e = 1/2: 12 Ns at a wall; on 2 kg at rest 6 Ns, of which the
   virial has that times the distance, 1 m. */
TEST(test_asked, "contacts that others find")
{
    FREED(spheres) p;
    MADE(scene, s, make(&s, 2));
    s.mass[0] = s.mass[1] = 2;
    s.restitution = 0.5;
    s.position[3] = 1;
    s.velocity[2] = 4;
    begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, 1);
    spheres_reflect(&p, 0, 1, s.position, s.velocity);
    UNIT_LIST(s.velocity + 2, 0, 1, 3);
    UNIT_EQUAL(p.virial, 6);
    UNIT_EQUAL(p.collisions, 1);
    s.velocity[3] = -4;
    spheres_bounce(&p, 1, 1, s.velocity);
    UNIT_EQUAL(s.velocity[3], 2);
    UNIT_EQUAL(p.impulse[1], 12);
    UNIT_EQUAL(p.impulse[0], 0);
    UNIT_EQUAL(p.wall_collisions, 1);
}

/* Mirrored, with restitution, and left alone on the way in. */
TEST(test_walls, "walls mirror, and lose what they should")
{
    MADE(scene, s, make(&s, 1));
    s.mass[0] = 2;
    WALLS(s, 0, SCENE_HARD, -1, 3);
    s.restitution = 0.5;
    s.position[0] = 2.75; /* 0.25 beyond */
    s.velocity[0] = 4;
    MADE(spheres, p, begin(&p, &s, SPHERES_ALL, SPHERES_BY_RADIUS, 1));
    UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 1);
    UNIT_EQUAL(s.position[0], 2.375);
    UNIT_EQUAL(s.velocity[0], -2);
    UNIT_EQUAL(p.impulse[0], 12);
    s.position[0] = -0.75;
    s.velocity[0] = 1;
    UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 0);
    UNIT_EQUAL(s.position[0], -0.75);
}

/* Two bodies at one place, a body alone, no body at all. */
TEST(test_awkward, "awkward scenes do no harm")
{
    FREED(spheres) p;
    MADE(scene, s, make(&s, 2));
    s.velocity[0] = 1;
    begin(&p, &s, SPHERES_APPROACHING, SPHERES_BACK, 1e-3);
    spheres_resolve(&p, s.position, s.velocity);
    UNIT_EQUAL(s.velocity[1], 1);
    UNIT_NEAR(s.position[1] - s.position[0], 1, 1e-8);
    spheres_free(&p);
    s.freedom[0] = s.freedom[1] = 0;
    s.position[0] = s.position[1] = 0;
    begin(&p, &s, SPHERES_ALL, SPHERES_BY_MASS, 1e-3);
    UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 0);
    spheres_free(&p);
    scene_free(&s);
    make(&s, 0);
    begin(&p, &s, SPHERES_ALL, SPHERES_BY_MASS, 1e-3);
    p.search = SPHERES_SWEEP;
    UNIT_EQUAL(spheres_resolve(&p, s.position, s.velocity), 0);
}

/* A crowd of unequal spheres in space, in each kind of box. */
static void make_crowd(struct scene *s, enum scene_wall wall, uint64_t seed)
{
    SEEDED(r, seed);
    make(s, 200);
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        s->wall[k] = wall;
        s->low[k] = -5;
        s->high[k] = k == 1 ? 9 : 6;
    }
    for (size_t i = 0; i < s->bodies; ++i) {
        s->radius[i] = random_between(&r, 0.1, 0.8);
        s->mass[i] = random_between(&r, 0.5, 2);
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            s->position[k * s->bodies + i] =
                random_between(&r, s->low[k] + 1, s->high[k] - 1);
            s->velocity[k * s->bodies + i] = random_normal(&r);
        }
    }
}

TEST(test_sweep, "the sweep finds what every pair finds")
{
    for (int wall = SCENE_OPEN; wall <= SCENE_PERIODIC; ++wall)
        for (int order = 0; order < SPHERES_ORDERS; ++order) {
            FREED(spheres) pa, pb;
            MADE(scene, a, make_crowd(&a, wall, 1));
            MADE(scene, b, make_crowd(&b, wall, 1));
            begin(&pa, &a, SPHERES_APPROACHING, SPHERES_BACK, 0.02);
            begin(&pb, &b, SPHERES_APPROACHING, SPHERES_BACK, 0.02);
            pa.order = pb.order = order;
            pa.search = SPHERES_PAIRS;
            pb.search = SPHERES_SWEEP;
            run(&a, &pa, 100);
            run(&b, &pb, 100);
            UNIT_TRUE(memcmp(a.position, b.position,
                             600 * sizeof *a.position) == 0);
            UNIT_TRUE(memcmp(a.velocity, b.velocity,
                             600 * sizeof *a.velocity) == 0);
            UNIT_TRUE(pa.collisions == pb.collisions &&
                      pa.collisions > 100);
        }
}

/* In a periodic box of four radii a pair is near on both sides. */
TEST(test_tiny_box, "a pair that is near twice collides once")
{
    FREED(scene) a, b;
    struct scene *scene[] = {&a, &b};
    for (int i = 0; i < 2; ++i) {
        make_crowd(scene[i], SCENE_PERIODIC, 3);
        for (size_t k = 0; k < SCENE_AXES; ++k)
            scene[i]->high[k] = scene[i]->low[k] + 1.6;
    }
    MADE(spheres, pa, begin(&pa, &a, SPHERES_ALL, SPHERES_BY_RADIUS, 0.02));
    MADE(spheres, pb, begin(&pb, &b, SPHERES_ALL, SPHERES_BY_RADIUS, 0.02));
    pa.search = SPHERES_PAIRS;
    pb.search = SPHERES_SWEEP;
    run(&a, &pa, 2);
    run(&b, &pb, 2);
    UNIT_TRUE(pa.collisions == pb.collisions && pa.collisions > 100);
    UNIT_TRUE(memcmp(a.velocity, b.velocity, 600 * sizeof *a.velocity) ==
              0);
}

/* Energy and momentum by every rule and shift; the centre of mass by all
   but the shares of the radii. 1e-12: some thousand collisions. */
TEST(test_kept, "energy, momentum, centre of mass are kept")
{
    for (int shift = SPHERES_BY_RADIUS; shift <= SPHERES_BACK; ++shift)
        for (int rule = SPHERES_ALL; rule <= SPHERES_APPROACHING; ++rule) {
            MADE(scene, s, make_crowd(&s, SCENE_PERIODIC, 2));
            MADE(spheres, p, begin(&p, &s, rule, shift, 0.02));
            const double E = energy(&s), P = total(&s, s.velocity),
                         X = total(&s, s.position);
            run(&s, &p, 100);
            UNIT_NEAR(energy(&s) / E, 1, 1e-12);
            UNIT_NEAR(total(&s, s.velocity), P, 1e-12 * s.bodies);
            const double off = fabs(total(&s, s.position) - X - 2 * P);
            UNIT_TRUE(shift == SPHERES_BY_RADIUS ? off > 0.01 : off < 1e-9);
        }
}

/* Walls against flight and virial, (7.8): to rounding, at any step, by any
   rule, but for going back with parting pairs in the way. */
TEST(test_identity, "walls balance flight and virial")
{
    for (int shift = SPHERES_BY_RADIUS; shift <= SPHERES_BACK; ++shift)
        for (int coarse = 0; coarse < 2; ++coarse) {
            FREED(scene) s;
            const double dt = coarse ? 0.08 : 0.01;
            double rest = 0;
            UNIT_TRUE(!gallery_make(&s, gallery_find(hard_scenes, "gas"),
                                    NULL, 0));
            MADE(spheres, p, begin(&p, &s, SPHERES_APPROACHING, shift, dt));
            const double E = energy(&s);
            for (int end = 0; end < 2; ++end) {
                for (size_t i = 0; i < 500; ++i)
                    rest += (end ? 1 : -1) * s.velocity[i] *
                            (s.position[i] - s.high[i / 250] / 2);
                if (!end)
                    run(&s, &p, coarse ? 100 : 800);
            }
            rest -= 2 * E * 8 + p.virial;
            for (size_t k = 0; k < 2; ++k)
                rest += p.impulse[k] * (s.high[k] / 2 - 0.1);
            UNIT_NEAR(rest / (2 * E * 8), 0, 1e-12);
        }
}

/* What leaves the cradle: by hand, from the collision of two. */
TEST(test_cradle, "what leaves the cradle")
{
    static const struct {
        double left, right, first, last, out[5];
    } rows[] = {{1, 0, 1, 1, {0, 0, 0, 0, 1}},
                {2, 0, 1, 1, {0, 0, 0, 1, 1}},
                {3, 0, 1, 1, {0, 0, 1, 1, 1}},
                {1, 1, 1, 1, {-1, 0, 0, 0, 1}},
                {1, 0, 2, 1, {1 / 81., 4 / 81., 4 / 27., 4 / 9., 4 / 3.}},
                {1, 0, 3, 1, {1 / 16., 3 / 16., 3 / 8., 3 / 4., 3 / 2.}},
                {1, 0, 0.5, 1, {-1 / 3., 0, 0, 0, 2 / 3.}},
                {1, 0, 1, 2, {-1 / 3., 0, 0, 0, 2 / 3.}}};
    const struct gallery_scene *g = gallery_find(hard_scenes, "cradle");
    for (size_t row = 0; row < sizeof rows / sizeof *rows; ++row)
        for (int way = 0; way < 6; ++way) {
            double value[GALLERY_KEYS];
            FREED(scene) s;
            FREED(spheres) p;
            gallery_usual(g, value);
            value[gallery_key(g, "left")] = rows[row].left;
            value[gallery_key(g, "right")] = rows[row].right;
            value[gallery_key(g, "first")] = rows[row].first;
            value[gallery_key(g, "last")] = rows[row].last;
            value[gallery_key(g, "gap")] = way % 2 ? 0 : 0.01;
            UNIT_TRUE(!g->build(&s, value));
            s.wall[0] = SCENE_OPEN;
            begin(&p, &s, SPHERES_APPROACHING, way / 2, 0.001);
            p.order = row % SPHERES_ORDERS;
            run(&s, &p, 8000);
            for (int i = 0; i < 5; ++i)
                UNIT_NEAR(s.velocity[i], rows[row].out[i], 1e-14);
        }
}

/* Body 1, of 2 kg, is hit from both sides at once. By hand: 0 first makes
   (-1/3, 2/3), then 1 on 2, closing with 5/3, 2/3 - 10/9. The deepest
   first: the later pair; of equal ones the first, though the sweep, from
   the left, finds it last. */
TEST(test_order_of_pairs, "the order of pairs decides, or their depth")
{
    static const struct {
        enum spheres_order order;
        double x[3], out[2]; /* out: of 0 and of 2 */
    } known[] = {
        {SPHERES_ASCENDING, {-0.9, 0, 0.9}, {-1 / 3., 20 / 9. - 1}},
        {SPHERES_DESCENDING, {-0.9, 0, 0.9}, {1 - 20 / 9., 1 / 3.}},
        {SPHERES_DEEPEST, {-0.95, 0, 0.9}, {1 - 20 / 9., 1 / 3.}},
        {SPHERES_DEEPEST, {0.9, 0, -0.9}, {1 / 3., 1 - 20 / 9.}}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        FREED(spheres) p;
        MADE(scene, s, make(&s, 3));
        s.mass[1] = 2;
        memcpy(s.position, known[k].x, sizeof known[k].x);
        s.velocity[0] = s.position[0] < 0 ? 1 : -1;
        s.velocity[2] = -s.velocity[0];
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BACK, 1);
        p.order = known[k].order;
        if (p.order == SPHERES_DEEPEST)
            p.search = SPHERES_SWEEP;
        spheres_resolve(&p, s.position, s.velocity);
        UNIT_NEAR(s.velocity[0], known[k].out[0], 1e-15);
        UNIT_NEAR(s.velocity[2], known[k].out[1], 1e-15);
    }
}

/* What overlaps, and how deep: found from the distances of the nearest
   images, wherever the bodies lie, several boxes away too. Coordinates up
   to 50 m are rounded by 7e-15 m, and their differences by as much. */
TEST(test_overlaps, "what overlaps, and how deep")
{
    enum { N = 30 };
    for (int round = 0; round < 18; ++round) {
        SEEDED(r, (uint64_t)round);
        FREED(spheres) p;
        size_t found = 0;
        MADE(scene, s, make(&s, N));
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const double side = (int)k == round / 3 % 3 ? 7 : 3;
            WALLS(s, k, (enum scene_wall)(round % 3), -9, side - 9);
            for (size_t i = 0; i < N; ++i)
                s.position[k * N + i] =
                    s.low[k] + side * random_between(&r, 0, 1) +
                    (round % 3 == SCENE_PERIODIC
                         ? side * floor(random_between(&r, -5, 5))
                         : 0);
        }
        for (size_t i = 0; i < N; ++i)
            s.radius[i] = random_between(&r, 0.3, 0.7);
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, 1);
        p.search = round < 9 ? SPHERES_PAIRS : SPHERES_SWEEP;
        const size_t pairs = spheres_overlaps(&p, s.position);
        if (round >= 9)
            UNIT_EQUAL(p.axis, round / 3 % 3);
        for (size_t i = 0; i < N; ++i)
            for (size_t j = i + 1; j < N; ++j) {
                double square = 0;
                for (size_t k = 0; k < SCENE_AXES; ++k) {
                    const double side = s.high[k] - s.low[k];
                    double d =
                        s.position[k * N + j] - s.position[k * N + i];
                    if (s.wall[k] == SCENE_PERIODIC)
                        d = remainder(d, side);
                    square += d * d;
                }
                const double depth =
                    s.radius[i] + s.radius[j] - sqrt(square);
                if (depth <= 0)
                    continue;
                UNIT_TRUE(found < pairs && p.pair[found].a == i &&
                          p.pair[found].b == j);
                if (found < pairs)
                    UNIT_NEAR(p.pair[found].depth, depth, 3e-14);
                ++found;
            }
        UNIT_EQUAL(pairs, found);
        UNIT_TRUE(found > 3);
    }
}

/* An overlap counts if one of the two can get out of it. */
TEST(test_depth, "an overlap of what is held is none")
{
    for (int held = 0; held < 4; ++held) {
        MADE(scene, s, begin_pair(&s));
        for (size_t i = 0; i < 2; ++i)
            for (size_t k = 0; k < SCENE_AXES; ++k)
                s.freedom[2 * k + i] = !(held >> i & 1) && k == 1;
        UNIT_EQUAL(spheres_depth(&s), held == 3 ? 0 : 0.25);
        s.contact = false;
        UNIT_EQUAL(spheres_depth(&s), 0);
    }
}

/* How many pairs were in each other in the last step, which took them
   further than the sum of their radii, and neither before nor after it:
   found from where they were. Those that have met a wall are left out. */
static size_t count_passed(const struct scene *s, const double before[],
                           const double flown[], double dt)
{
    const size_t n = s->bodies;
    size_t passed = 0;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            double dd = 0, du = 0, uu = 0, ee = 0;
            bool turned = false;
            for (size_t k = 0; k < SCENE_AXES; ++k) {
                const size_t a = k * n + i, b = k * n + j;
                const double d = spheres_way(s, before, i, j, k);
                const double u =
                    (flown[b] - before[b] - flown[a] + before[a]) / dt;
                dd += d * d;
                du += d * u;
                uu += u * u;
                ee += (d + u * dt) * (d + u * dt);
                if (s->wall[k] == SCENE_HARD)
                    turned = turned ||
                             fabs(flown[a] - 4) > 4 - s->radius[i] ||
                             fabs(flown[b] - 4) > 4 - s->radius[j];
            }
            const double R = s->radius[i] + s->radius[j];
            passed += !turned && uu * dt * dt > R * R && dd >= R * R &&
                      ee >= R * R && du < 0 && -du < uu * dt &&
                      dd - du * du / uu < R * R;
        }
    return passed;
}

/* Small fast ones pass through each other unseen: every pair that does is
   counted, with all walls, by both ways of looking; slow ones never. */
TEST(test_passed, "who passes through another is counted")
{
    enum { N = 40 };
    SEEDED(r, 7);
    size_t all = 0;
    for (int round = 0; round < 60; ++round) {
        FREED(spheres) p, q;
        double before[3 * N], flown[3 * N], v[3 * N];
        MADE(scene, s, make(&s, N));
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            WALLS(s, k, (enum scene_wall)(round % 3), 0, 8);
        }
        for (size_t c = 0; c < 3 * N; ++c) {
            s.position[c] = random_between(&r, 0.5, c < 2 * N ? 7.5 : 0.8);
            s.velocity[c] = c < 2 * N ? random_between(&r, -1, 1) : 0;
            s.radius[c % N] = random_between(&r, 0.1, 0.3);
        }
        const double dt = round % 2 ? 0.9 : 0.05;
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, dt);
        begin(&q, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, dt);
        p.search = SPHERES_PAIRS;
        q.search = SPHERES_SWEEP;
        memcpy(before, s.position, sizeof before);
        fly(&s, dt);
        memcpy(flown, s.position, sizeof flown);
        const size_t passed = count_passed(&s, before, flown, dt);
        all += passed;
        memcpy(v, s.velocity, sizeof v);
        spheres_resolve(&p, s.position, s.velocity);
        spheres_resolve(&q, flown, v);
        UNIT_EQUAL(p.passed, passed);
        UNIT_EQUAL(q.passed, passed);
        UNIT_TRUE(round % 2 || passed == 0);
    }
    UNIT_TRUE(all > 100);
}

/* A ball at 1.7 m has moved by 2 m in the step, away from a wall at 0. On
   a straight way it would have come from -0.3 m, through the ball at rest
   at 0.9 m; but it turned at the wall, so the pair is not counted. It is
   counted without the wall, or where the wall lies beyond that way. The
   same holds along each axis, at the upper wall, and for either body. */
TEST(test_turned, "but not who has turned at a wall")
{
    static const struct {
        double low;
        bool wall, passed;
    } known[] = {{0, true, false},
                 {0, false, true},
                 {-0.39, true, false},
                 {-0.41, true, true}};
    for (size_t round = 0; round < 4 * SPHERES_AXES * 4; ++round) {
        const size_t k = round / 4 % SPHERES_AXES, who = round % 2;
        const bool high = round / 2 % 2;
        const size_t row = round / (4 * SPHERES_AXES);
        FREED(spheres) p;
        MADE(scene, s, make(&s, 2));
        s.radius[0] = s.radius[1] = 0.1;
        WALLS(s, k, known[row].wall ? SCENE_HARD : SCENE_OPEN,
              high ? 0 : known[row].low, high ? 10 - known[row].low : 10);
        s.position[2 * k + who] = high ? 8.3 : 1.7;
        s.velocity[2 * k + who] = high ? -2 : 2;
        s.position[2 * k + 1 - who] = high ? 9.1 : 0.9;
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, 1);
        spheres_watch(&p, s.position, s.velocity);
        UNIT_EQUAL(p.passed, known[row].passed);
    }
}

/* Two rows of 32 go through each other in a step: 1024 pairs have passed,
   of which 1000 are counted. */
TEST(test_many_passed, "nor for ever")
{
    for (int search = SPHERES_PAIRS; search <= SPHERES_SWEEP; ++search) {
        FREED(spheres) p;
        MADE(scene, s, make(&s, 64));
        for (size_t i = 0; i < 64; ++i) {
            s.radius[i] = 1e-3;
            s.velocity[i] = i < 32 ? 1 : -1;
            s.position[i] = 0.01 * (double)i + (i < 32 ? 1 : -1);
        }
        begin(&p, &s, SPHERES_APPROACHING, SPHERES_BY_MASS, 1);
        p.search = (enum spheres_search)search;
        spheres_resolve(&p, s.position, s.velocity);
        UNIT_EQUAL(p.passed, SPHERES_PASSED);
    }
}
