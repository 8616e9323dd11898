/* A scene set in motion: what acts is the sum of its parts; what is held
   stays; how a run is cut, saved or resumed changes no bit. */
#include "unit.h"

#include "library/scene_same.h"
#include "library/toolbox_child.h"
#include "forces/motion.h"
#include "toolbox/table.h"

#include <unistd.h>

/* Three bodies that feel everything; with contact they are in a box. */
static void build(struct scene *s, bool contact)
{
    static const double place[] = {0, 1, 0.2, 0, 0.1, 0.9, 0, -0.3, 0.4};
    UNIT_MUST(scene_create(s, 3));
    for (size_t c = 0; c < 9; ++c) {
        s->position[c] = place[c];
        s->velocity[c] = 0.1 * (double)c - 0.3;
    }
    s->mass[0] = 2;
    s->mass[2] = 0.5;
    s->freedom[3] = s->freedom[8] = 0; /* y of body 0, z of body 2 */
    s->k2 = 0.3;
    s->softening = 0.1;
    s->gravity[2] = -1.5;
    s->damping = 0.2;
    s->dt = 0.01;
    UNIT_MUST(scene_add_kind(s, 4, 0.3));
    UNIT_MUST(scene_add_spring(s, 0, 2, 0, 0.7));
    s->contact = contact;
    for (size_t k = 0; k < 3; ++k) {
        s->radius[k] = 0.2;
        WALLS(*s, k, contact ? SCENE_HARD : SCENE_OPEN, -2, 2);
    }
}

/* Equation (11.9), term by term, with formulas of its own. */
TEST(test_sum, "what acts is the sum of all that is in the scene")
{
    double a[9], d[3], w[3], expected[9];
    MADE(scene, s, build(&s, false));
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    m.stepping.forces.accelerate(m.stepping.forces.what, s.position,
                                 s.velocity, a);
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k)
            expected[3 * k + i] = s.gravity[k] - s.damping / s.mass[i] *
                                                     s.velocity[3 * k + i];
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            double r2 = 0.01, r3;
            for (size_t k = 0; k < 3; ++k) {
                d[k] = s.position[3 * k + j] - s.position[3 * k + i];
                r2 += d[k] * d[k];
            }
            r3 = r2 * sqrt(r2);
            for (size_t k = 0; k < 3 && i != j; ++k)
                expected[3 * k + i] += 0.3 * s.mass[j] * d[k] / r3;
        }
    double r = 0;
    for (size_t k = 0; k < 3; ++k) {
        d[k] = s.position[3 * k + 2] - s.position[3 * k];
        w[k] = s.velocity[3 * k + 2] - s.velocity[3 * k];
        r += d[k] * d[k];
    }
    r = sqrt(r);
    for (size_t k = 0; k < 3; ++k) {
        const double f = 4 * (r - 0.7) * d[k] / r + 0.3 * w[k];
        expected[3 * k] += f / s.mass[0];
        expected[3 * k + 2] -= f / s.mass[2];
    }
    expected[3] = expected[8] = 0;
    for (size_t c = 0; c < 9;
         ++c) /* a dozen roundings of numbers below 10 */
        UNIT_NEAR(a[c], expected[c], 1e-14);
    UNIT_EQUAL(s.velocity[3], 0);
}

/* Springs alone take a way of their own. */
TEST(test_springs_alone, "springs alone move as they do with others")
{
    FREED(scene) t;
    MADE(scene, s, build(&s, false));
    s.k2 = 0;
    UNIT_MUST(scene_copy(&t, &s));
    t.k2 = 1e-300;
    BEGUN(motion, m, "motion", &s, "rk4", 0);
    BEGUN(motion, n, "motion", &t, "rk4", 0);
    motion_run(&m, 100);
    motion_run(&n, 100);
    for (size_t c = 0; c < 9; ++c)
        UNIT_NEAR(s.position[c], t.position[c], 1e-14);
}

/* Two bodies alone take a shorter way, and a shorter one yet in the plane
   z = 0 without weights: to the same bits, and to the signs of zeros. */
enum {
    WEIGHED,
    HELD,
    PLANE,
    SOFT,
    PUSHED,
    LIFTED,
    RADIAL,
    BACKWARDS,
    MINUS,
    LEAVING,
    TWOS
};

static void build_two(struct scene *s, int way)
{
    const bool heavy = way == WEIGHED || way == HELD;
    UNIT_MUST(scene_create(s, 2));
    s->position[1] = 1;
    PUT(s->velocity + 2, 0.1, -0.4);
    s->velocity[5] = heavy ? 0.2 : way == LEAVING ? 1e-9 : 0;
    s->mass[1] = 0.3;
    s->freedom[3] = s->freedom[4] = way != HELD; /* y of 1, z of 0 */
    s->k2 = 0.3;
    s->softening = way == HELD || way == SOFT ? 0.1 : 0;
    s->gravity[0] = heavy || way == PUSHED ? 0.01 : 0;
    s->gravity[2] = heavy || way == LIFTED ? -0.02 : 0;
    s->dt = way == BACKWARDS ? -0.01 : 0.01;
    if (way == RADIAL || way == BACKWARDS) { /* apart along x, y is -0 */
        s->velocity[1] = s->dt < 0 ? -2 : 2;
        s->velocity[2] = s->velocity[3] = -0.;
    }
    if (way == MINUS)
        s->position[4] = s->velocity[5] = -0.;
}

TEST(test_two, "and two bodies alone, to the bit")
{
    for (int way = 0; way < TWOS; ++way) {
        FREED(scene) t;
        MADE(scene, s, build_two(&s, way));
        UNIT_MUST(scene_copy(&t, &s));
        BEGUN(motion, m, "motion", &s, "leapfrog", 0);
        BEGUN(motion, n, "motion", &t, "leapfrog", 0);
        UNIT_TRUE(m.stepping.sweep != NULL);
        n.stepping.sweep = NULL;
        for (int k = 0; k < 3; ++k) {
            motion_run(&m, 700);
            motion_run(&n, 700);
        }
        UNIT_TRUE(!memcmp(s.position, t.position, 6 * sizeof(double)));
        UNIT_TRUE(!memcmp(s.velocity, t.velocity, 6 * sizeof(double)));
        UNIT_TRUE(!memcmp(m.stepping.acceleration, n.stepping.acceleration,
                          6 * sizeof(double)));
    }
}

/* Has the motion of two bodies the shorter way, and not that of springs? */
static bool is_short(struct scene *s, const char *method)
{
    BEGUN(motion, m, "motion", s, method, 0);
    return m.stepping.sweep != NULL && m.stepping.sweep != springs_sweep;
}

/* It is for two bodies that attract each other, and for nothing else. */
TEST(test_not_two, "what is not two bodies alone")
{
    for (int what = 0; what < 7; ++what) {
        FREED(scene) s;
        if (what == 0) {
            build(&s, false); /* three */
            s.damping = s.kind[0].damping = 0;
        } else {
            build_two(&s, WEIGHED);
            UNIT_MUST(scene_add_kind(&s, 4, 0));
        }
        if (what == 1)
            s.k2 = 0;
        if (what == 2)
            s.damping = 0.1;
        if (what == 3)
            UNIT_MUST(scene_add_spring(&s, 0, 1, 0, 1));
        if (what == 4) {
            s.contact = true;
            s.law = SCENE_LINEAR;
            s.stiffness = 1;
            s.radius[0] = s.radius[1] = 0.1;
        }
        for (size_t c = 0; what == 5 && c < 6; ++c)
            s.freedom[c] = 0;
        UNIT_TRUE(is_short(&s, "leapfrog") == (what == 6));
    }
}

/* From order six on sums are compensated, where anything accelerates. */
TEST(test_compensated, "which sums are compensated")
{
    for (int what = 0; what < 8; ++what) {
        CREATED(scene, s, 2);
        s.position[1] = 1;
        s.velocity[0] = -1;
        s.dt = 0.1;
        if (what < 3)
            s.gravity[what] = 1;
        if (what == 3)
            s.k2 = 1;
        if (what == 4)
            s.damping = 1;
        if (what == 5) {
            UNIT_MUST(scene_add_kind(&s, 4, 0));
            UNIT_MUST(scene_add_spring(&s, 0, 1, 0, 1));
        }
        if (what == 6) {
            s.contact = true;
            s.law = SCENE_LINEAR;
            s.stiffness = 1;
            s.radius[0] = s.radius[1] = 0.1;
        }
        static const char *const methods[] = {"kahan-li8", "yoshida6",
                                              "pefrl", "radau15"};
        for (int k = 0; k < 4; ++k) {
            BEGUN(motion, m, "motion", &s, methods[k], 0);
            UNIT_TRUE(m.stepping.compensated == (k < 2 && what < 7));
        }
    }
}

TEST(test_held, "what is held stays")
{
    MADE(scene, s, build(&s, true));
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    UNIT_TRUE(motion_run(&m, 1000) == STEPPING_DONE);
    UNIT_EQUAL(s.position[3], 0);
    UNIT_EQUAL(s.position[8], 0.4);
    UNIT_TRUE(s.position[4] != 0.1);
    UNIT_NEAR(motion_time(&m), 10, 1e-12);
}

static bool is_same(const struct scene *a, const struct scene *b)
{
    const size_t size = 3 * a->bodies * sizeof *a->position;
    return memcmp(a->position, b->position, size) == 0 &&
           memcmp(a->velocity, b->velocity, size) == 0;
}

TEST(test_cuts, "how a run is cut changes no bit")
{
    for (int contact = 0; contact < 2; ++contact)
        for (const struct stepping_method *k = stepping_next(NULL); k;
             k = stepping_next(k)) {
            MADE(scene, s, build(&s, contact));
            MADE(scene, t, build(&t, contact));
            BEGUN(motion, m, "motion", &s, k->name, 0);
            BEGUN(motion, n, "motion", &t, k->name, 0);
            motion_run(&m, 300);
            for (uint64_t left = 300, bite = 1; left > 0; bite += 3) {
                motion_run(&n, bite < left ? bite : left);
                left -= bite < left ? bite : left;
            }
            UNIT_TRUE(is_same(&s, &t));
            UNIT_EQUAL(m.collisions, n.collisions);
            UNIT_TRUE(!contact || m.collisions > 0);
        }
}

static const char *const path = "build/tests/motion-saved.plist";

static void save(struct motion *m, struct scene *again)
{
    UNIT_MUST(motion_note(m));
    struct table *t = table_open("motion", path);
    UNIT_MUST(t != NULL);
    scene_write(m->scene, t);
    UNIT_MUST(table_close(t) && scene_read(again, "motion", path));
    UNIT_TRUE(scene_same(m->scene, again));
    unlink(path);
}

/* The ways in which a scene may be run. */
enum { DAMPED = 1, COMPENSATED = 2, CONTACT = 4, SPRINGS = 8, WAYS = 16 };

/* As build, without friction but with DAMPED; with SPRINGS nothing else
   acts but the weight, and springs_forces take the place of the sum. */
static void build_way(struct scene *s, int way)
{
    build(s, way & CONTACT);
    if (way & SPRINGS)
        s->k2 = s->damping = 0;
    if (!(way & DAMPED))
        s->damping = s->kind[0].damping = 0;
}

/* Leapfrog alone, under friction, goes on from an acceleration. */
static bool must_keep(const char *method, int way)
{
    return stepping_is_leapfrog(stepping_find(method)) && way & DAMPED;
}

/* Saved after `cut` steps and read, a run goes on to the same bits, and
   keeps an acceleration only where it must. Returns whether it has. */
static bool goes_on(const char *method, int way, uint64_t cut)
{
    FREED(scene) t;
    MADE(scene, s, build_way(&s, way));
    BEGUN(motion, m, "motion", &s, method, 0);
    m.stepping.compensated = way & COMPENSATED;
    motion_run(&m, cut);
    save(&m, &t);
    const bool kept = t.kept != NULL;
    UNIT_TRUE(!kept || must_keep(method, way));
    UNIT_EQUAL(t.time, motion_time(&m));
    BEGUN(motion, n, "motion", &t, method, 0);
    /* From order six on sums are compensated unless the caller says no. */
    UNIT_TRUE(n.stepping.compensated ==
              (way & COMPENSATED || stepping_find(method)->order >= 6));
    n.stepping.compensated = m.stepping.compensated;
    motion_run(&m, 150);
    motion_run(&n, 150);
    UNIT_MUST(motion_note(&m) && motion_note(&n));
    t.time = s.time; /* counted from another start: see below */
    UNIT_TRUE(scene_same(&s, &t));
    return kept;
}

TEST(test_saved, "a saved run goes on to the same bits")
{
    for (const struct stepping_method *m = stepping_next(NULL); m;
         m = stepping_next(m))
        for (int way = 0; way < WAYS; ++way) {
            size_t kept = 0;
            for (uint64_t cut = 1; cut < 400; cut += 57)
                kept += goes_on(m->name, way, cut);
            UNIT_TRUE(must_keep(m->name, way) == (kept > 0));
        }
}

/* Saved right after a contact there is nothing to keep: the acceleration is
   that of before, and either run asks for a new one. */
TEST(test_saved_after_contact, "saved right after a contact as well")
{
    FREED(scene) t;
    MADE(scene, s, build_way(&s, DAMPED | CONTACT));
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    for (int k = 0; k < 1000 && m.collisions == 0; ++k)
        motion_run(&m, 1);
    UNIT_TRUE(m.collisions > 0);
    save(&m, &t);
    UNIT_TRUE(t.kept == NULL);
    BEGUN(motion, n, "motion", &t, "leapfrog", 0);
    motion_run(&m, 5);
    motion_run(&n, 5);
    UNIT_TRUE(is_same(&s, &t));
}

/* As a checkpoint has it, start and steps besides: the times are the same
   as well. Without what sums carry, or the acceleration, all is not. */
static void resume(uint64_t cut, bool carry, bool kept, bool same)
{
    FREED(scene) t;
    MADE(scene, s, build(&s, false));
    s.time = 0.7;
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    m.stepping.compensated = true;
    motion_run(&m, cut);
    save(&m, &t);
    if (!carry)
        memset(t.carry, 0, 18 * sizeof *t.carry);
    if (!kept) {
        free(t.kept);
        t.kept = NULL;
    }
    BEGUN(motion, n, "motion", &t, "leapfrog", 0);
    motion_resume(&n, 0.7, cut);
    motion_run(&m, 500);
    motion_run(&n, 500);
    UNIT_TRUE(is_same(&s, &t) == same);
    UNIT_EQUAL(motion_time(&m), motion_time(&n));
}

TEST(test_resume, "and a resumed one to the same times")
{
    for (uint64_t cut = 1; cut < 400; cut += 37)
        resume(cut, true, true, true);
    resume(100, false, true, false);
    resume(100, true, false, false);
}

/* An acceleration that is nonsense is in the scene: does it change a bit of
   the motion? */
static bool heeds(const char *method, int way, double dt)
{
    FREED(scene) t;
    MADE(scene, s, build_way(&s, way));
    UNIT_MUST(scene_copy(&t, &s));
    t.kept = calloc(9, sizeof *t.kept);
    UNIT_MUST(t.kept != NULL);
    for (size_t c = 0; c < 9; ++c)
        t.kept[c] = 1e3;
    BEGUN(motion, m, "motion", &s, method, dt);
    BEGUN(motion, n, "motion", &t, method, dt);
    UNIT_TRUE(motion_run(&m, 3) == motion_run(&n, 3));
    const bool heeded = !is_same(&s, &t);
    UNIT_MUST(motion_note(&m) && motion_note(&n));
    UNIT_TRUE(heeded || scene_same(&s, &t));
    return heeded;
}

TEST(test_heeded, "an acceleration that was kept is heeded where it counts")
{
    for (const struct stepping_method *m = stepping_next(NULL); m;
         m = stepping_next(m))
        for (int way = 0; way < WAYS; ++way)
            UNIT_TRUE(heeds(m->name, way, 0) == must_keep(m->name, way));
    UNIT_TRUE(heeds("leapfrog", DAMPED, 0.01));
    UNIT_TRUE(!heeds("leapfrog", DAMPED, 0.005));
}

/* What was kept is kept over no step at all, and forgotten by a method that
   has no use for it. */
TEST(test_forgotten, "and forgotten where it does not")
{
    for (int way = 0; way < 2; ++way) {
        FREED(scene) t;
        MADE(scene, s, build(&s, false));
        BEGUN(motion, m, "motion", &s, "leapfrog", 0);
        motion_run(&m, 10);
        save(&m, &t);
        UNIT_TRUE(t.kept != NULL && t.kept[5] != 0);
        motion_end(&m);
        UNIT_MUST(
            motion_begin(&m, "motion", &t, way ? "rk4" : "leapfrog", 0));
        UNIT_MUST(motion_note(&m));
        UNIT_TRUE(way ? t.kept == NULL : scene_same(&s, &t));
    }
}

/* A step after a contact begins with the acceleration where the bodies are
   now: half a kick and a drift by it give the next place. */
TEST(test_contact, "after a contact the method looks again")
{
    bool met = false;
    MADE(scene, s, build(&s, true));
    s.damping = 0;
    s.kind[0].damping = 0;
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    for (int k = 0; k < 3000; ++k) {
        double a[9], expected[9];
        const uint64_t before = m.collisions;
        motion_run(&m, 1);
        if (m.collisions == before)
            continue;
        m.stepping.forces.accelerate(m.stepping.forces.what, s.position,
                                     s.velocity, a);
        for (size_t c = 0; c < 9; ++c)
            expected[c] =
                s.position[c] + 0.01 * (s.velocity[c] + 0.005 * a[c]);
        const uint64_t then = m.collisions;
        motion_run(&m, 1);
        for (size_t c = 0; c < 9 && m.collisions == then; ++c)
            UNIT_NEAR(s.position[c], expected[c],
                      1e-15); /* an ulp or two */
        met = true;
    }
    UNIT_TRUE(met);
}

/* n bodies of radius 0.1 in a row along x, 1 m apart, held but along x. */
static void row(struct scene *s, size_t n)
{
    UNIT_MUST(scene_create(s, n));
    for (size_t i = 0; i < n; ++i) {
        s->position[i] = (double)i;
        s->radius[i] = 0.1;
        s->freedom[n + i] = s->freedom[2 * n + i] = 0;
    }
}

static void has(const struct scene *s, enum motion_flaw flaw, size_t body)
{
    size_t found = 77;
    UNIT_EQUAL(motion_flaw(s, &found), flaw);
    UNIT_EQUAL(motion_flaw(s, NULL), flaw);
    if (flaw != MOTION_WELL && flaw != MOTION_WALLS &&
        flaw != MOTION_RESTITUTION)
        UNIT_EQUAL(found, body);
}

/* A body without mass that something acts on is refused, if it is free. */
TEST(test_light, "what has no mass")
{
    for (size_t axis = 0; axis < 3; ++axis)
        for (size_t light = 0; light < 3; ++light) {
            MADE(scene, s, row(&s, 3));
            s.mass[light] = 0;
            has(&s, MOTION_WELL, 0);
            s.freedom[light] = 0;
            s.freedom[3 * axis + light] = 1;
            s.damping = 0.1;
            has(&s, MOTION_MASSLESS, light);
            s.freedom[3 * axis + light] = 0;
            has(&s, MOTION_WELL, 0);
            s.freedom[3 * axis + light] = 1;
            s.damping = 0;
            s.contact = true;
            has(&s, MOTION_MASSLESS, light);
            s.contact = false;
            UNIT_MUST(scene_add_kind(&s, 1, 0));
            UNIT_MUST(scene_add_spring(&s, 0, 2, 0, 1));
            has(&s, light == 1 ? MOTION_WELL : MOTION_MASSLESS, light);
        }
}

/* Walls want contacts; what is thicker than the box does not move in it,
   and as thick as it is is thin enough; springs have no restitution. */
TEST(test_box, "what is in a box")
{
    for (size_t k = 0; k < 3; ++k)
        for (int wall = SCENE_OPEN; wall <= SCENE_PERIODIC; ++wall) {
            MADE(scene, s, row(&s, 2));
            WALLS(s, k, (enum scene_wall)wall, -1, 2);
            s.freedom[2 * k] = 0;
            s.freedom[2 * k + 1] = 1;
            has(&s, wall ? MOTION_WALLS : MOTION_WELL, 0);
            s.contact = true;
            s.radius[0] = s.radius[1] = 1.5;
            has(&s, MOTION_WELL, 0);
            s.radius[0] = s.radius[1] = 1.5 * (1 + 1e-11);
            has(&s, wall ? MOTION_THICK : MOTION_WELL, 1);
            s.freedom[2 * k + 1] = 0;
            has(&s, MOTION_WELL, 0);
            s.restitution = 0.9;
            has(&s, MOTION_WELL, 0);
            s.law = SCENE_LINEAR;
            has(&s, MOTION_RESTITUTION, 0);
            s.restitution = 1;
            has(&s, MOTION_WELL, 0);
        }
}

/* Points on a line that they cannot leave collide unseen, if one may move
   and not all of them hang on springs. Off the line they pass. */
TEST(test_points, "points on a line")
{
    MADE(scene, s, row(&s, 4));
    s.contact = true;
    s.radius[1] = 0;
    has(&s, MOTION_WELL, 0);
    s.radius[3] = 0;
    has(&s, MOTION_POINTS, 1);
    s.contact = false;
    has(&s, MOTION_WELL, 0);
    s.contact = true;
    for (size_t k = 1; k < 3; ++k) { /* apart, and ways off the line */
        s.position[4 * k] = 1e-9;
        has(&s, MOTION_WELL, 0);
        s.position[4 * k] = 0;
        s.velocity[4 * k + 2] = 1;
        has(&s, MOTION_POINTS, 1);
        s.freedom[4 * k + 2] = 1;
        has(&s, MOTION_WELL, 0);
        s.velocity[4 * k + 2] = 0;
        has(&s, MOTION_POINTS, 1);
        s.gravity[k] = -1;
        has(&s, MOTION_WELL, 0);
        s.freedom[4 * k + 2] = 0;
        has(&s, MOTION_POINTS, 1);
        s.gravity[k] = 0;
    }
    s.freedom[1] = 0;
    has(&s, MOTION_POINTS, 1);
    s.freedom[3] = 0;
    has(&s, MOTION_WELL, 0);
    s.freedom[1] = s.freedom[3] = 1;
    UNIT_MUST(scene_add_kind(&s, 1, 0));
    UNIT_MUST(scene_add_spring(&s, 1, 2, 0, 1));
    has(&s, MOTION_POINTS, 1);
    UNIT_MUST(scene_add_spring(&s, 0, 3, 0, 1));
    has(&s, MOTION_WELL, 0);
    s.radius[0] = 0; /* one of three, on a spring too */
    has(&s, MOTION_WELL, 0);
}

/* Steps of another length: the time goes on, and so do counts, the sums'
   rounding errors and the quicker ways. With the same length no bit is
   another. */
TEST(test_shorten, "steps may change their length")
{
    static const char *const methods[] = {"leapfrog", "rk4", "radau15"};
    for (int k = 0; k < 3; ++k)
        for (int two = 0; two < 2; ++two) {
            FREED(scene) s, t;
            if (two)
                build_two(&s, SOFT);
            else
                build_way(&s, 0);
            UNIT_MUST(scene_copy(&t, &s));
            BEGUN(motion, m, "motion", &s, methods[k], 0);
            BEGUN(motion, n, "motion", &t, methods[k], 0);
            m.stepping.compensated = n.stepping.compensated = k < 2 && !two;
            motion_run(&m, 150);
            motion_run(&n, 100);
            const uint64_t before = n.stepping.evaluations;
            stepping_sweep *const sweep = n.stepping.sweep;
            UNIT_TRUE(motion_shorten(&n, 0.01));
            UNIT_NEAR(motion_time(&n), 1, 1e-15);
            UNIT_TRUE(n.stepping.sweep == sweep);
            UNIT_TRUE(n.stepping.evaluations == before);
            motion_run(&n, 50);
            UNIT_NEAR(motion_time(&n), 1.5, 1e-15);
            UNIT_TRUE(is_same(&s, &t));
            UNIT_TRUE(motion_shorten(&n, 0.25));
            motion_run(&n, 2);
            UNIT_NEAR(motion_time(&n), 2, 1e-15);
        }
}

/* The energies by hand: 2 (3^2 + 4^2)/2 and 1 (2^2)/2; gravity 3 * 2 / 0.5;
   a spring stretched by 0.25 and one of the contact pressed by 0.5; weight
   along the axes that are free. */
TEST(test_energies, "energies by hand")
{
    CREATED(scene, s, 2);
    s.mass[0] = 2;
    s.position[1] = 0.5;
    s.position[4] = s.position[5] = 3;
    s.velocity[0] = 3;
    s.velocity[2] = 4;
    s.velocity[5] = 2;
    s.k2 = 3;
    s.gravity[0] = 1;
    s.gravity[2] = -10;
    s.freedom[1] = 0;
    s.dt = 0.1;
    UNIT_MUST(scene_add_kind(&s, 32, 0));
    UNIT_MUST(scene_add_spring(&s, 0, 1, 0, 0.25));
    s.contact = true;
    s.law = SCENE_LINEAR;
    s.stiffness = 8;
    s.radius[0] = s.radius[1] = 0.5;
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    const struct motion_energy e = motion_energy(&m);
    UNIT_EQUAL(e.kinetic, 25 + 2);
    UNIT_EQUAL(e.gravity, -3 * 2 / 0.5);
    UNIT_EQUAL(e.springs, 32 * 0.25 * 0.25 / 2 + 8 * 0.5 * 0.5 / 2);
    UNIT_EQUAL(e.weight, 2 * 10 * 3 + 10 * 3);
    UNIT_EQUAL(motion_potential(&m), e.gravity + e.springs + e.weight);
    UNIT_TRUE(motion_contacts(&m) == m.soft.near);
}

static bool from_outside(void *with, double dt, double x[], double v[])
{
    *(double *)with += dt;
    x[0] += v[0] * dt;
    return *(double *)with < 0.995;
}

TEST(test_outside, "another stepper can take the method's place")
{
    double clock = 0;
    CREATED(scene, s, 1);
    s.velocity[0] = 2;
    s.dt = 0.25;
    BEGUN(motion, m, "motion", &s, "leapfrog", 0);
    m.outside = from_outside;
    m.with = &clock;
    UNIT_TRUE(motion_run(&m, 3) == STEPPING_DONE);
    UNIT_EQUAL(s.position[0], 1.5);
    UNIT_EQUAL(motion_time(&m), 0.75);
    UNIT_TRUE(motion_run(&m, 2) == STEPPING_STUCK);
}

struct start {
    struct scene s;
    const char *method;
};

static int begin_refused(void *with)
{
    struct start *w = with;
    struct motion m;
    return motion_begin(&m, "motion", &w->s, w->method, 0) ? 4 : 3;
}

TEST(test_refused, "what cannot be stepped is refused, with a reason")
{
    static const char *const why[] = {
        "there is no method 'no-such'",
        "wisdom-holman: ",
        "the scene has no line dt, and no time step was given",
        "the scene has walls but no line contact",
        "the scene has a line restitution, but contacts that are springs",
        "body 2 has no mass",
        "body 1, of radius 2.5, is thicker than the box",
        "body 0 and another on its line are points"};
    for (size_t k = 0; k < sizeof why / sizeof *why; ++k) {
        struct start w = {.method = k == 0   ? "no-such"
                                    : k == 1 ? "wisdom-holman"
                                             : "leapfrog"};
        struct scene *const s = &w.s;
        build(s, k == 3 || k == 6);
        s->dt = k == 2 ? 0 : 0.01;
        s->contact = k > 3 && k != 5;
        s->law = k == 4 ? SCENE_LINEAR : SCENE_SUDDEN;
        s->restitution = k == 4 ? 0.5 : 1;
        s->mass[2] = k == 5 ? 0 : 1;
        s->radius[1] = k == 6 ? 2.5 : 0.2;
        for (size_t i = 0; i < 3 && k == 7; ++i) {
            s->radius[i] = s->position[3 + i] = s->position[6 + i] = 0;
            s->freedom[3 + i] = s->freedom[6 + i] = 0;
        }
        const struct child c = child_run(begin_refused, &w, NULL);
        UNIT_EQUAL(c.status, 3);
        UNIT_TRUE(strncmp(c.err, "motion: ", 8) == 0 &&
                  strncmp(c.err + 8, why[k], strlen(why[k])) == 0 &&
                  strchr(c.err, '\n') == c.err + strlen(c.err) - 1);
        scene_free(s);
    }
}
