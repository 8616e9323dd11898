/* From chapters/works/12-models.nw: edit there, then run make tangle. */
/* checksum 2462982091 of the lines below */
/* Times runs of many units, and takes off what is known of the others. */
#include "enough/prices.h"

#include "scenes/gallery.h"
#include "box/sampling.h"
#include "toolbox/bench.h"

#include <math.h>

/* So many bodies in the same weight, one beside the other. */
static bool fall(struct scene *s, size_t bodies)
{
    if (!scene_create(s, bodies))
        return false;
    s->gravity[2] = -1;
    for (size_t i = 0; i < bodies; ++i)
        s->position[i] = (double)i;
    return true;
}

static bool fall_together(struct scene *s)
{
    return fall(s, 500);
}

static bool make(struct scene *s, const struct gallery_scene list[],
                 const char *name, const char *key, double value)
{
    return gallery_make(s, gallery_find(list, name), key, value) == NULL;
}

static bool make_circle(struct scene *s)
{
    return make(s, celestial_scenes, "choreography", "particles", 24);
}

static bool make_membrane(struct scene *s)
{
    return make(s, elastic_scenes, "membrane", "damping", 0);
}

static bool make_pendulum(struct scene *s)
{
    return make(s, elastic_scenes, "double-pendulum", NULL, 0);
}

static bool make_beam(struct scene *s)
{
    return make(s, elastic_scenes, "cantilever", "nx", 12);
}

static bool make_hundred(struct scene *s)
{
    return make(s, hard_scenes, "cradle", "balls", 100);
}

static bool make_brownian(struct scene *s)
{
    return make(s, hard_scenes, "brownian", NULL, 0);
}

static bool make_two(struct scene *s)
{
    return make(s, hard_scenes, "cradle", "balls", 2);
}

static bool make_line(struct scene *s)
{
    return make(s, hard_scenes, "thermal", "particles", 30);
}

static bool make_four(struct scene *s)
{
    return make(s, hard_scenes, "four-disks", NULL, 0);
}

static bool make_few(struct scene *s)
{
    return make(s, hard_scenes, "gas", "particles", 90);
}

static bool make_orbit(struct scene *s)
{
    return make(s, celestial_scenes, "sun-earth", NULL, 0);
}

static bool make_beads(struct scene *s)
{
    return make(s, hard_scenes, "cradle", "balls", 1000);
}

/* A run with much of one unit, and little of the others. */
struct bout {
    bool (*make)(struct scene *s);
    const char *plan;
    double every;
    uint64_t rows;
};

static const struct bout bouts[MODELS_UNITS] = {
    [MODELS_EVALUATION] = {make_orbit, "kahan-li8:1000", 10, 10},
    [MODELS_BODY] = {fall_together, "kahan-li8:40", 1, 10},
    [MODELS_PAIR] = {make_circle, "pefrl:100", 0.1, 10},
    [MODELS_SPRING] = {make_membrane, "pefrl:100", 1, 10},
    [MODELS_ROD] = {make_pendulum, "leapfrog:2000,rods", 1, 10},
    [MODELS_CONTACT] = {make_hundred, "leapfrog:1000", 1, 10},
    [MODELS_OVERLAP] = {make_brownian, "leapfrog:50", 0.05, 10},
    [MODELS_LINE_EVENT] = {make_two, "line", 1000, 10},
    [MODELS_LINE_SCAN] = {make_line, "line", 100, 10},
    [MODELS_DISK_EVENT] = {make_four, "disks", 100, 10},
    [MODELS_DISK_SCAN] = {make_few, "disks", 10, 10},
    [MODELS_ELLIPSE] = {make_orbit, "kepler", 10, 20000},
    [MODELS_FLIGHT] = {fall_together, "free", 1, 200},
    [MODELS_ORDER] = {make_beads, "relabel", 1, 50},
    [MODELS_MODE] = {make_beam, "modes", 1, 2},
};

/* Runs a bout; returns how long it took, s, and fills in the work. */
static double run_bout(const struct bout *b, double work[MODELS_UNITS])
{
    char message[MODELS_MESSAGE];
    const char *why;
    struct models_plan plan;
    struct models_run r;
    struct scene s;
    if (!models_read(&plan, b->plan, message) || !b->make(&s))
        return NAN;
    const double begin = bench_seconds();
    const bool begun = models_begin(&r, &plan, &s, b->every, &why);
    bool going = begun;
    while (going && r.rows < b->rows)
        going = models_row(&r) == MODELS_DONE;
    const double seconds = going ? bench_seconds() - begin : NAN;
    for (size_t k = 0; k < MODELS_UNITS; ++k)
        work[k] = begun ? r.work[k] : 0;
    if (begun)
        models_end(&r);
    scene_free(&s);
    return seconds;
}

/* What a unit costs if the others cost what the list says, ns. */
static double price_in(const struct bout *b, enum models_unit unit)
{
    double work[MODELS_UNITS];
    const double seconds = run_bout(b, work), units = work[unit];
    work[unit] = 0;
    return (seconds - models_cost(work)) / units * 1e9;
}

static double price_of_trials(void)
{
    enum { DISKS = 50, TRIALS = 100000 };
    const double box[] = {1, 1};
    struct sampling s;
    struct random r;
    random_seed(&r, 1);
    if (!sampling_create(&s, 2, DISKS_WALLS, box, DISKS, 0.03, 0, 0) ||
        !sampling_start(&s, &r))
        return NAN;
    const double begin = bench_seconds();
    for (int k = 0; k < TRIALS; ++k)
        sampling_try(&s, 0.05, &r);
    const double seconds = bench_seconds() - begin;
    sampling_free(&s);
    return seconds * 1e9 / ((double)TRIALS * DISKS);
}

double prices_measure(enum models_unit unit)
{
    double value[BENCH_ROUNDS];
    for (int round = -1; round < BENCH_ROUNDS; ++round) /* -1: warm-up */
        value[round < 0 ? 0 : round] = unit == MODELS_TRIAL
                                           ? price_of_trials()
                                           : price_in(&bouts[unit], unit);
    return bench_median(value, BENCH_ROUNDS);
}
