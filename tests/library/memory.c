/* Without memory: whatever request is refused, who made it says so, has
   freed what it had, and leaves the rest as it was. With memory, too, all
   of it goes back. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "library/heap.h"
#include "box/blocks.h"
#include "box/calendar.h"
#include "box/cells.h"
#include "box/means.h"
#include "box/sampling.h"
#include "box/states.h"
#include "choosing/averages.h"
#include "choosing/models.h"
#include "forces/modes.h"
#include "forces/motion.h"
#include "line/bonkers.h"
#include "line/laws.h"
#include "line/statistics.h"
#include "forces/rods.h"
#include "library/galleries.h"

static struct scene scene;

static void make(const char *name)
{
    scene_free(&scene);
    scene = made(name, NULL, 0);
}

/* What asks for memory, as heap_fails wants it. */
static bool copies(UNUSED void *unused)
{
    struct scene s;
    const bool well = scene_copy(&s, &scene);
    if (well)
        scene_free(&s);
    return well;
}

static bool builds(UNUSED void *unused)
{
    struct scene s;
    if (!scene_create(&s, 3))
        return false;
    const bool well = scene_add_kind(&s, 1, 0) &&
                      scene_add_kind(&s, 2, 0.1) &&
                      scene_add_spring(&s, 0, 1, 0, 1) &&
                      scene_add_spring(&s, 1, 2, 1, 1);
    scene_free(&s);
    return well;
}

static bool parses(void *unused)
{
    static const char text[] = "pos 0 0 0 0 1 0 .1\npos 1 1 0 0 1 0 .1\n"
                               "carry 0 1 2 3 4 5 6\n"
                               "s 0 5 0\ns 1 7 0\nsl 0 1 0\nsl 1 0 1\n";
    struct scene s;
    struct scene_error e;
    (void)unused;
    const bool well = scene_parse(&s, text, sizeof text - 1, &e);
    if (well)
        scene_free(&s);
    return well;
}

static bool moves(void *method)
{
    struct motion m;
    struct scene s;
    if (!scene_copy(&s, &scene))
        return false;
    bool well = motion_begin(&m, "memory", &s, method, 0.01);
    if (well) {
        well = motion_shorten(&m, 0.02) &&
               (!m.collides || motion_locate(&m)) && motion_note(&m);
        motion_end(&m);
    }
    scene_free(&s);
    return well;
}

static bool carries(void *text)
{
    struct models_plan p = {0};
    struct models_run r;
    char message[MODELS_MESSAGE];
    const char *why;
    if (!models_read(&p, text, message) ||
        !models_begin(&r, &p, &scene, 0.01, &why))
        return false;
    enum models_end end = MODELS_DONE;
    for (int k = 0; k < 3 && end == MODELS_DONE; ++k)
        end = models_row(&r);
    const bool counted = models_collisions(&r) < UINT64_MAX;
    models_end(&r);
    return end == MODELS_DONE && counted;
}

static bool averages(UNUSED void *unused)
{
    const struct averages_request q = {
        .scene = &scene, .until = 20, .tolerance = 0.3, .budget = 5};
    struct averages_found f;
    return averages_find(&f, &q) && f.refusal[0] == '\0';
}

static const struct gallery_scene *laid; /* which scene */

static bool lays(UNUSED void *unused)
{
    struct scene s;
    double value[GALLERY_KEYS];
    gallery_usual(laid, value);
    const char *why = laid->build(&s, value);
    if (!why)
        scene_free(&s);
    return !why;
}

static bool plants(UNUSED void *unused)
{
    struct gravity g;
    if (!gravity_create(&g, scene.bodies, scene.mass, 1, 0))
        return false;
    const bool well =
        gravity_use_tree(&g, 0.5) && gravity_use_tree(&g, 0.2);
    gravity_free(&g);
    return well;
}

static bool shares(UNUSED void *unused)
{
    struct springs p;
    if (!springs_create(&p, &scene))
        return false;
    const bool well = springs_threads(&p, 3);
    springs_free(&p);
    return well;
}

static void fails(const char *what, bool (*does)(void *), const char *with,
                  bool spared)
{
    char words[64];
    snprintf(words, sizeof words, "%s", with);
    /* (Under a sanitizer none is refused.) */
    const long requests = heap_fails(what, does, words, spared);
    UNIT_TRUE(requests >= 0);
}

TEST(test_scenes, "scenes")
{
    make("membrane");
    fails("a copy", copies, "", false);
    fails("a scene", builds, "", false);
    fails("a text", parses, "", false);
    for (size_t i = 0; i < GALLERIES; ++i)
        for (laid = galleries[i]; laid->name; ++laid)
            fails(laid->name, lays, "", false);
}

TEST(test_forces, "forces")
{
    make("membrane");
    fails("a tree", plants, "", false);
    fails("springs by threads", shares, "", false);
}

TEST(test_motion, "motion, by each method")
{
    static const char *const names[] = {"four-disks", "double-pendulum",
                                        "membrane", "figure-eight", "ring"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
        make(names[k]);
        fails(names[k], moves, "leapfrog", false);
    }
    make("figure-eight");
    for (const struct stepping_method *m = stepping_next(NULL); m;
         m = stepping_next(m))
        if (!m->orbits)
            fails("figure-eight", moves, m->name, false);
}

TEST(test_models, "models")
{
    static const struct {
        const char *scene, *plan;
    } plans[] = {{"sun-earth", "kepler"},
                 {"four-disks", "disks"},
                 {"cradle", "line"},
                 {"oscillator", "oscillator"},
                 {"cradle", "relabel"},
                 {"double-pendulum", "modes"},
                 {"double-pendulum", "leapfrog:3,rods"},
                 {"sun-earth", "wisdom-holman:3"},
                 {"four-disks", "leapfrog:3"},
                 {"sun-earth", "leapfrog:3"},
                 {"oscillator", "dopri5:1e-6"},
                 {"sun-earth", "radau15:1e-6"}};
    for (size_t k = 0; k < sizeof plans / sizeof plans[0]; ++k) {
        make(plans[k].scene);
        fails(plans[k].scene, carries, plans[k].plan, false);
    }
}

TEST(test_averages, "averages")
{
    make("four-disks");
    /* The error of a mean that nobody asks for may be missing. */
    fails("averages", averages, "", true);
}

/* ---- disks, gases and bodies on a line */

/* Disks in a box of side 20, dense enough for long lists and full cells. */
static bool pack(struct disks *d, size_t dimensions, size_t count)
{
    SEEDED(r, 3);
    if (!disks_create(d, dimensions, count))
        return false;
    d->boundary = DISKS_PERIODIC;
    for (size_t k = 0; k < dimensions; ++k)
        d->box[k] = 20;
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = 0.5;
    UNIT_TRUE(disks_place_lattice(d));
    disks_set_speed(d, 1, &r);
    return true;
}

/* Asks for memory only where it makes plans. */
static bool plans(UNUSED void *unused)
{
    struct disks d;
    if (!pack(&d, 2, 40))
        return false;
    const bool well = disks_plan(&d);
    if (well)
        disks_run(&d, 1, UINT64_MAX);
    disks_free(&d);
    return well;
}

/* All fly to the middle, where cells and lists have to grow; a run that
   gets no memory for it stops before its time. */
static bool runs_cells(UNUSED void *unused)
{
    struct disks d;
    struct cells c;
    if (!pack(&d, 2, 100))
        return false;
    for (size_t i = 0; i < d.count; ++i) {
        d.disk[i].radius = 1e-3;
        for (size_t k = 0; k < 2; ++k)
            d.disk[i].velocity[k] = 10 - d.disk[i].position[k];
    }
    bool well = cells_create(&c, &d);
    if (well) {
        const size_t room = c.room, seats = c.seats;
        well = cells_run(&c, 0.95, UINT64_MAX) == DISKS_TIME;
        UNIT_TRUE(!well || (c.room > room && c.seats > seats));
        cells_free(&c);
    }
    disks_free(&d);
    return well;
}

static bool samples(UNUSED void *unused)
{
    const double box[] = {5, 5};
    struct sampling s;
    struct means m;
    SEEDED(r, 2);
    if (!sampling_create(&s, 2, DISKS_WALLS, box, 3, 0.5, 4, 0.1))
        return false;
    UNIT_TRUE(sampling_start(&s, &r));
    bool well = sampling_log_acceptance(&s, 100, &r) < 0;
    if (well && (well = means_create(&m, 3)))
        means_free(&m);
    sampling_free(&s);
    return well;
}

static bool keeps(UNUSED void *unused)
{
    struct calendar c;
    struct blocks b;
    if (!calendar_create(&c, 9, 0, 1))
        return false;
    const bool well = blocks_create(&b, 2);
    if (well)
        blocks_free(&b);
    calendar_free(&c);
    return well;
}

static bool reads(void *path)
{
    struct disks d;
    char message[STATES_MESSAGE];
    if (!states_read(&d, path, message))
        return false;
    disks_free(&d);
    return true;
}

/* An engine, with points or rods and with or without losses. */
struct line {
    enum bonkers_engine engine;
    double restitution, radius;
};

static bool collides(void *what)
{
    const struct line *l = what;
    const struct start_request request = {
        .kind = START_RANDOM, .movers = 40, .seed = 7};
    struct start s;
    struct bonkers b;
    size_t wrong;
    if (!start_fill(&s, &request))
        return false;
    for (size_t i = 0; i < s.movers; ++i)
        s.radius[i] = l->radius;
    const bool well =
        bonkers_begin(&b, &s, l->restitution, l->engine, &wrong);
    start_free(&s);
    if (!well)
        return false;
    bonkers_run(&b, 3, UINT64_MAX);
    bonkers_free(&b);
    return true;
}

/* The scan of the same run: a slab that gets no memory for its log goes by
   the heap, and has the same bits. */
static double last_place(const struct line *l)
{
    const struct start_request request = {
        .kind = START_RANDOM, .movers = 40, .seed = 7};
    struct start s;
    FREED(bonkers) b;
    size_t wrong;
    double x[42], v[42];
    const long failing = heap_failing;
    heap_failing = -1;
    start_fill(&s, &request);
    bonkers_begin(&b, &s, l->restitution, l->engine, &wrong);
    start_free(&s);
    heap_failing = failing;
    bonkers_run(&b, 3, UINT64_MAX);
    bonkers_state(&b, x, v);
    return x[20];
}

static bool slabs(void *expected)
{
    const struct line slab = {BONKERS_SLAB, 1, 0};
    return last_place(&slab) == *(double *)expected;
}

static bool measures(void *what)
{
    double x[64], y[64];
    struct statistics_description d;
    struct statistics_dependence p;
    struct statistics_blocking b;
    struct law law = {0};
    struct law_test t;
    SEEDED(r, 1);
    for (size_t i = 0; i < 64; ++i) {
        x[i] = random_uniform(&r);
        y[i] = random_uniform(&r);
    }
    switch (*(const char *)what) {
    case 'd': return statistics_describe(64, x, true, &d);
    case 'p': return statistics_dependence(64, x, y, 4, true, &p);
    case 'b': return statistics_blocking(64, x, &b);
    case 'l':
        UNIT_TRUE(!laws_read("beta:1,1", &law));
        laws_complete(&law, 0, 1);
        return laws_test(&law, 64, x, 1, 4, 0, &t);
    }
    struct statistics_histogram *h = statistics_histogram_create(0, 1, 5);
    free(h);
    return h;
}

TEST(test_disks, "disks")
{
    static const char path[] = "build/tests/memory.states";
    fails("disks with a plan", plans, "", false);
    fails("cells", runs_cells, "", false);
    fails("samples", samples, "", false);
    fails("a calendar and blocks", keeps, "", false);
    FILE *file = fopen(path, "w");
    for (int i = 0; i < 70; ++i) /* more than a first block of rows */
        fprintf(file, "0 %d 1 .1 %d 1 0 0\n", i, i);
    fclose(file);
    /* A file may do without a buffer. */
    fails("states", reads, path, true);
    remove(path);
}

TEST(test_line, "bodies on a line")
{
    for (int engine = BONKERS_NAIVE; engine < BONKERS_ENGINES; ++engine)
        for (int k = 0; k < 4; ++k) {
            struct line l = {(enum bonkers_engine)engine, k % 2 ? 0.9 : 1,
                             k / 2 ? 0.01 : 0};
            /* A slab without a log goes on by the heap. */
            const bool spared = engine == BONKERS_SLAB;
            UNIT_TRUE(heap_fails(bonkers_engine_names[engine], collides, &l,
                                 spared) >= 0);
        }
    const struct line scan = {BONKERS_SCAN, 1, 0};
    double expected = last_place(&scan);
    UNIT_TRUE(heap_fails("slabs", slabs, &expected, true) >= 0);
    static const char *const what[] = {"describe", "pair", "blocking",
                                       "law", "histogram"};
    for (size_t k = 0; k < 5; ++k)
        fails(what[k], measures, what[k], false);
}

TEST(test_freed_twice, "freed twice")
{
    const double sides[] = {5, 5};
    struct disks d;
    struct blocks b;
    struct sampling s;
    struct means m;
    struct schedule q;
    struct start w;
    struct bonkers line;
    UNIT_TRUE(disks_create(&d, 2, 3) && blocks_create(&b, 2) &&
              sampling_create(&s, 2, DISKS_WALLS, sides, 2, 0.5, 1, 0.1) &&
              means_create(&m, 2) && schedule_create(&q, 3, 3) &&
              start_create(&w, 2) &&
              bonkers_create(&line, 2, 0.5, BONKERS_SLAB));
    for (int k = 0; k < 2; ++k) {
        disks_free(&d);
        blocks_free(&b);
        sampling_free(&s);
        means_free(&m);
        schedule_free(&q);
        start_free(&w);
        bonkers_free(&line);
        UNIT_TRUE(!d.disk && !b.sum && !s.blocked && !m.sum && !q.heap &&
                  !w.mass && !line.body);
    }
}

/* The same of what moves bodies; contacts that are springs are empty. */
TEST(test_forces_twice, "freed twice, what moves bodies")
{
    struct motion m;
    make("four-disks");
    UNIT_TRUE(motion_begin(&m, "memory", &scene, "radau15", 0.01) &&
              motion_locate(&m));
    struct impact i = m.impact;
    struct spheres p = m.spheres;
    impact_free(&i);
    impact_free(&i);
    spheres_free(&p);
    spheres_free(&p);
    m.located = m.collides = false;
    motion_end(&m);
    motion_end(&m);
    scene.law = SCENE_LINEAR;
    struct soft t;
    UNIT_TRUE(soft_create(&t, &scene));
    soft_free(&t);
    UNIT_TRUE(!t.near && !t.scene);
    make("double-pendulum");
    struct springs s;
    struct modes n;
    struct rods r;
    UNIT_TRUE(springs_create(&s, &scene) &&
              modes_find(&n, &s, scene.position));
    modes_free(&n);
    modes_free(&n);
    springs_free(&s);
    springs_free(&s);
    UNIT_TRUE(rods_create(&r, &scene, scene.spring, scene.springs,
                          (struct stepping_forces){0}));
    rods_free(&r);
    rods_free(&r);
    scene_free(&scene);
    scene_free(&scene);
    const double mass[] = {2, 1, 1};
    FREED(gravity) g;
    FREED(jacobi) j;
    UNIT_TRUE(gravity_create(&g, 3, mass, 1, 0) &&
              gravity_use_tree(&g, 0.5) && jacobi_create(&j, 3, mass, 1));
    gravity_free(&g);
    jacobi_free(&j);
}

int main(void)
{
    if (!freopen("/dev/null", "w", stderr))
        return 1;
    fputs("its buffer, once for all\n", stderr);
    return unit_run("memory");
}
