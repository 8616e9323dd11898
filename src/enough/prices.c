/* From chapters/works/12-models.nw: edit there, then run make tangle. */
/* checksum 1100548626 of the lines below */
/* Times runs of many units, and takes off what is known of the others. */
#include "enough/prices.h"

#include "scenes/gallery.h"
#include "toolbox/bench.h"

#include <math.h>
#include <string.h>

/* A run with much of one unit, and little of the others. */
struct bout {
    const char *name, *key;
    double value;
    const char *plan;
    double every;
    uint64_t rows;
};

static const struct bout bouts[MODELS_UNITS] = {
    [MODELS_EVALUATION] = {"sun-earth", NULL, 0, "kahan-li8:1000", 10, 10},
    [MODELS_BODY] = {"ring", "particles", 500, "kahan-li8:40", 1, 10},
    [MODELS_PAIR] = {"choreography", "particles", 24, "pefrl:100", 0.1, 10},
    [MODELS_SPRING] = {"cantilever", "nx", 8, "pefrl:100", 0.001, 10},
    [MODELS_ROD] = {"double-pendulum", NULL, 0, "leapfrog:2000,rods", 1,
                    10},
    [MODELS_CONTACT] = {"cradle", "balls", 100, "leapfrog:1000", 1, 2},
    [MODELS_OVERLAP] = {"gas", NULL, 0, "leapfrog:100", 0.1, 4},
    [MODELS_CURVE] = {"gas", "particles", 60, "radau15:1e-6", 0.1, 10},
    [MODELS_ROOT] = {"thermal", "particles", 30, "radau15:1e-6", 0.1, 40},
    [MODELS_LINE_EVENT] = {"cradle", "balls", 2, "line", 1000, 10},
    [MODELS_LINE_SCAN] = {"thermal", "particles", 30, "line", 100, 10},
    [MODELS_DISK_EVENT] = {"four-disks", NULL, 0, "disks", 100, 10},
    [MODELS_DISK_SCAN] = {"gas", "particles", 90, "disks", 10, 10},
    [MODELS_ELLIPSE] = {"sun-earth", NULL, 0, "kepler", 10, 20000},
    [MODELS_FLIGHT] = {"ring", "particles", 500, "free", 1, 200},
    [MODELS_ORDER] = {"cradle", "balls", 1000, "relabel", 1, 50},
    [MODELS_MODE] = {"cantilever", "nx", 12, "modes", 1, 2},
    [MODELS_ROW] = {"cradle", "balls", 2, "relabel", 1, 20000},
};

static bool make(struct scene *s, const struct bout *b)
{
    const struct gallery_scene *const all[] = {celestial_scenes,
                                               elastic_scenes, hard_scenes};
    const struct gallery_scene *found = NULL;
    for (size_t k = 0; k < 3 && !found; ++k)
        found = gallery_find(all[k], b->name);
    const bool made = gallery_make(s, found, b->key, b->value) == NULL;
    if (strcmp(b->name, "ring") == 0)
        s->k2 = 0; /* bodies on which nothing acts */
    return made;
}

/* Runs a bout; returns how long it took, s, and fills in the work. */
static double run_bout(const struct bout *b, double work[MODELS_UNITS])
{
    char message[MODELS_MESSAGE];
    const char *why;
    struct models_plan plan;
    struct models_run r;
    struct scene s;
    if (!models_read(&plan, b->plan, message) || !make(&s, b))
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

double prices_measure(enum models_unit unit)
{
    double value[BENCH_ROUNDS];
    for (int round = -1; round < BENCH_ROUNDS; ++round) /* -1: warm-up */
        value[round < 0 ? 0 : round] = price_in(&bouts[unit], unit);
    return bench_median(value, BENCH_ROUNDS);
}
