/* Springs: the force of one by hand, sums that must balance, the two ways
   to sum and any number of threads against each other bit for bit, and the
   damped oscillator against its closed form. The stiff double pendulum is
   in tests/programs/references.sh. */
#include "unit.h"

#include "choosing/closed.h"
#include "forces/elastic.h"
#include "forces/springs.h"

#include <float.h>

/* Two bodies of mass 1 and 2 on a spring of 10 N/m, 1 m, c = 3 kg/s; the
   second at (x, y, 0). */
static void make_pair(struct scene *s, double x, double y, bool axial)
{
    UNIT_MUST(scene_create(s, 2) && scene_add_kind(s, 10, 3) &&
              scene_add_spring(s, 0, 1, 0, 1));
    s->mass[1] = 2;
    s->position[1] = x;
    s->position[3] = y;
    s->axial = axial;
}

static void forces(const struct scene *s, double a[])
{
    CREATED(springs, p, s);
    springs_accelerate(&p, s->position, s->velocity, a);
}

static void begin(struct springs *p, struct stepping *t, struct scene *s,
                  const char *method, double dt)
{
    UNIT_MUST(springs_create(p, s) &&
              stepping_begin(t, stepping_find(method), springs_forces(p),
                             dt, s->position, s->velocity));
}

/* Stretched from 1 to 5 m along (3, 4): 40 N, and the second is heavier. */
TEST(test_pull, "a stretched spring draws its ends together")
{
    double a[6];
    MADE(scene, s, make_pair(&s, 3, 4, false));
    forces(&s, a);
    UNIT_NEAR(a[0], 24, 1e-14); /* towards the other: the right sign */
    UNIT_NEAR(a[2], 32, 1e-14);
    UNIT_NEAR(a[1], -12, 1e-14);
    UNIT_NEAR(a[3], -16, 1e-14);
    UNIT_EQUAL(a[4], 0);
}

/* At rest length: only the dashpots act. Moving across the axis the printed
   one brakes, the axial one does not; along the axis they agree. */
TEST(test_dashpots,
     "the printed dashpot brakes all, the axial one its axis")
{
    double full[6], axial[6];
    MADE(scene, s, make_pair(&s, 1, 0, false));
    s.velocity[1] = 0.5;
    s.velocity[3] = 2;
    forces(&s, full);
    s.axial = true;
    forces(&s, axial);
    UNIT_NEAR(full[0], 1.5, 1e-15);
    UNIT_LIST(full + 2, 1e-15, 6, -3);
    UNIT_LIST(axial, 1e-15, 1.5, -0.75);
    UNIT_EQUAL(axial[2], 0);
}

/* Two bodies in one place: no direction, so no elastic force, and nothing
   that is not a number. */
TEST(test_same_place, "two bodies in one place do no harm")
{
    double a[6];
    MADE(scene, s, make_pair(&s, 0, 0, false));
    forces(&s, a);
    for (int i = 0; i < 6; ++i)
        UNIT_EQUAL(a[i], 0);
    s.axial = true;
    s.velocity[1] = 1;
    forces(&s, a);
    for (int i = 0; i < 6; ++i)
        UNIT_EQUAL(a[i], 0);
}

TEST(test_held, "held axes, gravity and friction")
{
    double a[6], more[6] = {7, 7, 7, 7, 7, 7};
    MADE(scene, s, make_pair(&s, 3, 4, false));
    s.freedom[0] = s.freedom[3] = 0;
    s.gravity[1] = -9;
    s.damping = 0.5;
    s.velocity[1] = 1;
    forces(&s, a);
    UNIT_EQUAL(a[0], 0);
    UNIT_EQUAL(a[3], 0);
    UNIT_NEAR(a[2], 32 - 9, 1e-13);
    UNIT_NEAR(a[1], -12 - 1.5 - 0.25, 1e-14);
    CREATED(springs, p, &s);
    springs_add(&p, s.position, s.velocity, more);
    UNIT_EQUAL(more[0], 7);
    UNIT_NEAR(more[2], 7 + 32, 1e-13);
    UNIT_TRUE(springs_damped(&p) && springs_forces(&p).damped);
}

/* The energy's slope is the force: central differences, error h^2. */
TEST(test_potential, "the slope of the energy is the force")
{
    double a[6];
    MADE(scene, s, make_pair(&s, 0.3, 0.5, false));
    s.position[4] = 0.7;
    forces(&s, a);
    CREATED(springs, p, &s);
    for (int i = 0; i < 6; ++i) {
        const double h = 1e-5, here = s.position[i];
        s.position[i] = here + h;
        const double up = springs_potential(&p, s.position);
        s.position[i] = here - h;
        const double down = springs_potential(&p, s.position);
        s.position[i] = here;
        UNIT_NEAR(-(up - down) / (2 * h) / s.mass[i % 2], a[i], 1e-8);
    }
}

/* Of two springs that hang on the last bodies, either way round: stretched
   from 1 to 5 m along (3, 4), and compressed to 0.5 m. */
TEST(test_stored, "and what springs have stored")
{
    FREED(scene) s;
    UNIT_MUST(scene_create(&s, 4) && scene_add_kind(&s, 10, 0) &&
              scene_add_spring(&s, 1, 2, 0, 1) &&
              scene_add_spring(&s, 3, 2, 0, 1));
    s.position[0] = 9;
    s.position[2] = s.position[3] = 3;
    s.position[6] = s.position[7] = 4;
    s.position[11] = 0.5;
    CREATED(springs, p, &s);
    UNIT_EQUAL(springs_potential(&p, s.position), 80 + 1.25);
}

/* ---- the two ways, and threads ----------------------------------------
 */

static unsigned long long noise_state = 1;

static double noise(void)
{
    noise_state =
        noise_state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(noise_state >> 11) / 9007199254740992.0 - 0.5;
}

static void shake(struct scene *s)
{
    for (size_t i = 0; i < 3 * s->bodies; ++i) {
        s->position[i] += 0.2 * noise();
        s->velocity[i] += noise();
    }
}

/* A step of which nothing is ready: x and v are not numbers until then. */
struct waiting {
    const struct scene *scene;
    double *x, *v;
    int *times; /* that a coordinate was asked for */
};

static void arrive(void *step, size_t from, size_t n, bool owing)
{
    const struct waiting *w = step;
    UNIT_TRUE(!owing);
    memcpy(w->x + from, w->scene->position + from, n * sizeof *w->x);
    memcpy(w->v + from, w->scene->velocity + from, n * sizeof *w->v);
    for (size_t i = from; i < from + n; ++i)
        ++w->times[i];
}

/* A sweep has each coordinate made ready once, and before it looks. */
static void sweeps(struct springs *p, const struct scene *s,
                   const double expected[])
{
    const size_t n = 3 * s->bodies;
    double *room = calloc(3 * n, sizeof *room);
    int *times = calloc(n, sizeof *times);
    UNIT_MUST(room && times);
    struct waiting w = {s, room, room + n, times};
    for (size_t i = 0; i < 3 * n; ++i)
        room[i] = NAN;
    springs_sweep(p, w.x, w.v, room + 2 * n,
                  &(struct stepping_ahead){arrive, &w}, 1);
    UNIT_TRUE(memcmp(room + 2 * n, expected, n * sizeof *room) == 0);
    bool once = true;
    for (size_t i = 0; i < n; ++i)
        once = once && times[i] == 1;
    UNIT_TRUE(once);
    free(room);
    free(times);
}

/* All ways to sum give the same bits, for adding and for writing. */
static void same_bits(const struct scene *s, size_t bands)
{
    const size_t n = 3 * s->bodies;
    double *one = calloc(n, sizeof *one), *other = calloc(n, sizeof *other);
    struct springs p;
    UNIT_MUST(one && other && springs_create(&p, s));
    UNIT_EQUAL(p.bands, bands);
    for (int adds = 0; adds < 2; ++adds) {
        p.engine = SPRINGS_SCATTER;
        for (size_t i = 0; i < n; ++i)
            one[i] = 0.1 * (double)(i % 7);
        adds ? springs_add(&p, s->position, s->velocity, one)
             : springs_accelerate(&p, s->position, s->velocity, one);
        if (!adds)
            sweeps(&p, s, one);
        p.engine = SPRINGS_GATHER;
        for (int threads = 1; threads <= 5; ++threads) {
            UNIT_TRUE(springs_threads(&p, threads));
            for (size_t i = 0; i < n; ++i)
                other[i] = 0.1 * (double)(i % 7);
            adds ? springs_add(&p, s->position, s->velocity, other)
                 : springs_accelerate(&p, s->position, s->velocity, other);
            UNIT_TRUE(memcmp(one, other, n * sizeof *one) == 0);
            if (!adds)
                sweeps(&p, s, one);
        }
    }
    springs_free(&p);
    free(one);
    free(other);
}

static void make_membrane(struct scene *s, size_t nx, size_t ny, double c)
{
    const struct elastic_membrane m = {nx,  ny, 1.5, 50,   c, 0.9,
                                       0.1, 1,  1,   true, 0, 0};
    UNIT_MUST(!elastic_membrane(s, &m));
    shake(s);
}

TEST(test_same_bits, "scatter, gather and threads give the same bits")
{
    static const size_t size[][2] = {{5, 4},   {8, 8},   {33, 7},  {7, 40},
                                     {64, 64}, {50, 61}, {1500, 3}};
    for (size_t i = 0; i < sizeof size / sizeof *size; ++i)
        for (int way = 0; way < 5; ++way) {
            FREED(scene) s;
            make_membrane(&s, size[i][0], size[i][1], way % 3);
            s.axial = way == 2;
            s.gravity[2] = way > 2 ? -1 : 0;
            s.damping = way > 3 ? 0.3 : 0;
            same_bits(&s, size[i][0] * size[i][1] == 20 ? 1 : 2);
        }
}

/* A net so wide that no two steps of it would stay in the cache. */
TEST(test_wide, "on a wide net too")
{
    MADE(scene, s, make_membrane(&s, 8000, 3, 0));
    same_bits(&s, 2);
}

/* Steps of leapfrog, in pieces of `piece`, swept or not. */
static void leap(const struct scene *from, uint64_t steps, uint64_t piece,
                 bool swept, struct scene *s)
{
    FREED(stepping) stepping;
    make_membrane(s, 40, 30, 0.5);
    memcpy(s->position, from->position, 3600 * sizeof *s->position);
    memcpy(s->velocity, from->velocity, 3600 * sizeof *s->velocity);
    s->damping = from->damping;
    for (size_t i = 0; i < s->kinds; ++i)
        s->kind[i] = from->kind[i];
    MADE(springs, p, begin(&p, &stepping, s, "leapfrog", 0.01));
    stepping.sweep = swept ? springs_sweep : NULL;
    for (uint64_t k = 0; k < steps; k += piece)
        stepping_run(&stepping, piece);
    UNIT_EQUAL(stepping.evaluations, (double)steps + 1);
}

/* With dashpots, with friction, without both; the last kick of a piece is
   owed to the next one. */
TEST(test_leapfrog, "leapfrog swept and in pieces, the same bits")
{
    for (int way = 0; way < 3; ++way) {
        FREED(scene) s, one;
        make_membrane(&s, 40, 30, way == 0 ? 0.5 : 0);
        s.damping = way == 1 ? 0.2 : 0;
        leap(&s, 140, 1, false, &one);
        static const uint64_t pieces[] = {1, 7, 140};
        for (int i = 0; i < 3; ++i)
            for (int swept = 0; swept < 2; ++swept) {
                FREED(scene) other;
                leap(&s, 140, pieces[i], swept, &other);
                UNIT_TRUE(memcmp(one.position, other.position,
                                 3600 * sizeof *one.position) == 0);
                UNIT_TRUE(memcmp(one.velocity, other.velocity,
                                 3600 * sizeof *one.velocity) == 0);
            }
    }
}

/* Diagonals, springs written backwards, springs of another kind, doubled
   springs, one across the grid, and holes. */
TEST(test_odd_lists, "so they do for lists that are no grid")
{
    FREED(scene) s;
    const double values[] = {20, 9, 1, 1.5, 1, 1000, 0.5, 2, 1, 0.1};
    UNIT_MUST(
        !gallery_find(elastic_scenes, "cantilever")->build(&s, values));
    shake(&s);
    same_bits(&s, 4);
    for (size_t i = 0; i < s.springs; i += 3) {
        const uint32_t a = s.spring[i].a;
        s.spring[i].a = s.spring[i].b;
        s.spring[i].b = a;
    }
    same_bits(&s, 4);
    UNIT_MUST(scene_add_kind(&s, 300, 1) &&
              scene_add_spring(&s, 0, 179, 1, 2) &&
              scene_add_spring(&s, 90, 3, 0, 1) &&
              scene_add_spring(&s, 5, 6, 1, 0.5));
    same_bits(&s, 4);
    UNIT_MUST(scene_add_spring(&s, 5, 6, 0, 0.5)); /* a second: no band */
    same_bits(&s, 3);
    for (size_t i = 0; i < s.springs; ++i)
        if (i % 5 == 1)
            s.spring[i].kind = 1;
    UNIT_TRUE(s.springs > 500);
    same_bits(&s, 3);
}

TEST(test_momentum, "inner forces keep the momentum")
{
    FREED(scene) s;
    const double values[] = {9, 5, 1, 1, 2, 100, 0.5, 2, 0, 0};
    UNIT_MUST(
        !gallery_find(elastic_scenes, "cantilever")->build(&s, values));
    for (size_t i = 0; i < 3 * s.bodies; ++i)
        s.freedom[i] = 1;
    shake(&s);
    for (int axial = 0; axial < 2; ++axial) {
        FREED(stepping) t;
        double before[3] = {0}, after[3] = {0};
        s.axial = axial;
        MADE(springs, p, begin(&p, &t, &s, "leapfrog", 0.01));
        for (size_t i = 0; i < 3 * s.bodies; ++i)
            before[i / s.bodies] += s.velocity[i];
        stepping_run(&t, 1000);
        for (size_t i = 0; i < 3 * s.bodies; ++i)
            after[i / s.bodies] += s.velocity[i];
        for (int k = 0; k < 3; ++k) /* 1e6 sums of size 1 to 10 */
            UNIT_NEAR(after[k], before[k], 1e-11);
    }
}

/* A spinning dumbbell: L falls as exp(-c t / mu) with the printed dashpot,
   whatever the spring does, and stays with the axial one. */
TEST(test_spin, "what dashpots do to rotation")
{
    for (int axial = 0; axial < 2; ++axial) {
        FREED(stepping) t;
        MADE(scene, s, make_pair(&s, 1.2, 0, axial));
        s.kind[0].damping = 0.3;
        s.velocity[2] = -1; /* y velocities: no momentum */
        s.velocity[3] = 0.5;
        MADE(springs, p, begin(&p, &t, &s, "yoshida4", 1e-3));
        double spin[2];
        for (int k = 0; k < 2; ++k) {
            const double *x = s.position, *v = s.velocity;
            spin[k] =
                x[0] * v[2] - x[2] * v[0] + 2 * (x[1] * v[3] - x[3] * v[1]);
            stepping_run(&t, 3000);
        }
        /* mu = 2/3 kg; 3 s; the error of a step with damping, some 3e-9 */
        UNIT_NEAR(spin[1] / spin[0], axial ? 1 : exp(-0.3 * 3 * 1.5), 1e-8);
    }
}
