/* Compares the errors of time averages with the predicted errors. */
#include "choosing/averages.h"
#include "choosing/models.h"
#include "scenes/gallery.h"
#include "toolbox/study.h"

#include <math.h>

#define PROGRAM "averages-studies"

/* Makes the scene "four-disks" of chapter 5, but with only two disks. */
static void make_disks(struct scene *s, double seed)
{
    program_check(
        gallery_choose(s, hard_scenes, "four-disks",
                       GALLERY_CHOICES({"particles", 2}, {"seed", seed})));
}

/* Returns Z, the pressure averaged over a run of T seconds, computed from
   the virial (7.5, eq:virial). */
static double measure_pressure(const struct scene *s, double T)
{
    const struct models_plan plan = {.model = models_find("disks")};
    struct models_run r;
    const char *why;
    double energy = 0;
    if (!models_begin(&r, &plan, s, T, &why))
        program_give_up("%s", why);
    for (size_t c = 0; c < 2 * s->bodies; ++c) {
        const double v = s->velocity[c];
        energy += s->mass[c % s->bodies] * v * v / 2;
    }
    const bool done = models_row(&r) == MODELS_DONE;
    const double virial = done ? r.virial : NAN;
    models_end(&r);
    return 1 + virial / (2 * energy * T);
}

/* Returns the mean pressure over the time T, as estimated by averages_find
   with tolerance 0.01. */
static struct averages_found find_pressure(const struct scene *s, double T)
{
    const struct averages_request q = {
        .scene = s,
        .quantity = {.kind = AVERAGES_PRESSURE},
        .until = T,
        .tolerance = 0.01,
        .budget = AVERAGES_BUDGET};
    struct averages_found f;
    program_memory(averages_find(&f, &q), NULL);
    return f;
}

/* Writes a row with the pressure averaged over all of T and the estimate of
   averages_find. The estimate and its error are nan if averages_find gives
   no answer. The two runs are independent: their initial velocities differ
   by about one part in 1e12, so their paths separate after a few dozen
   collisions. */
static void study_pair(struct study *s, double T, double seed)
{
    struct scene pair;
    make_disks(&pair, seed);
    const struct averages_found f = find_pressure(&pair, T);
    for (size_t c = 0; c < 2 * pair.bodies; ++c)
        pair.velocity[c] *= 1 + 1e-12 * (double)(c + 1);
    const bool given = f.sure != AVERAGES_OUT;
    TABLE_ROW(s->out, T, seed, measure_pressure(&pair, T),
              given ? f.value : NAN, given ? f.error * f.scale : NAN,
              given ? f.time : NAN);
    scene_free(&pair);
}

/* Compares the mean over all of T with the estimate of averages_find, which
   simulates only part of T. Uses two disks, twenty initial states, and
   increasing times T. */
static void study_disks(struct study *s)
{
    TABLE_COLUMNS(s->out, {"T", "s", "time of the mean"},
                  {"seed", "", "of the start"},
                  {"Z", "", "mean pressure over all of T"},
                  {"answer", "", "what is said of it, nan: refused"},
                  {"error", "", "and its error"},
                  {"t", "s", "how much was simulated for that"});
    for (double T = 128; T < 2e5; T *= 4)
        for (int seed = 1; seed <= 20 && !progress_signal(); ++seed)
            study_pair(s, T, seed);
}

static const struct study_entry studies[] = {
    {"disks", study_disks, "two disks and ever longer times", NULL}, {0}};

STUDY_MAIN(.name = PROGRAM,
           .purpose = "Study means over a time, and what is said of them.",
           .events = "rows", .studies = studies, .usual = "disks")
