/* From chapters/works/12-averages.nw: edit there, then run make tangle. */
/* checksum 563889573 of the lines below */
/* When a mean may be believed, and starts that mislead. */
#include "enough/averages.h"
#include "box/blocks.h"
#include "scenes/gallery.h"
#include "line/start.h"
#include "line/statistics.h"
#include "toolbox/random.h"
#include "toolbox/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "averages-studies"

/* Makes some of the four disks of chapter 5, each in the middle of its
   quarter of the box, thrown as the seed has it. */
static void make_disks(struct scene *s, double count, double radius,
                       double seed)
{
    const struct gallery_scene *g = gallery_find(hard_scenes, "four-disks");
    double value[GALLERY_KEYS];
    gallery_usual(g, value);
    value[gallery_key(g, "particles")] = count;
    value[gallery_key(g, "seed")] = seed;
    if (g->build(s, value))
        program_give_up(PROGRAM, "no memory");
    for (size_t i = 0; i < s->bodies; ++i) {
        s->radius[i] = radius;
        s->position[i] = i % 2 ? 0.75 : 0.25;
        s->position[s->bodies + i] = (i + i / 2) % 2 ? 0.75 : 0.25;
    }
}

/* Makes bodies of START_ADIABATIC a scene, with the piston moved to 0.35
   of the box and each gas with it. */
static void make_piston(struct scene *s, size_t bodies, double ratio)
{
    const struct start_wish wish = {.kind = START_ADIABATIC,
                                    .movers = bodies,
                                    .ratio = ratio,
                                    .seed = 1};
    struct start start;
    if (!start_fill(&start, &wish) || !scene_create(s, bodies))
        program_give_up(PROGRAM, "no memory");
    const double length = start.wall[1], middle = length / 2;
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = length;
    for (size_t i = 0; i < bodies; ++i) {
        const double x = start.x[i];
        s->mass[i] = start.mass[i];
        s->velocity[i] = start.v[i];
        s->position[i] =
            x <= middle ? 0.7 * x : length - 1.3 * (length - x);
        s->freedom[bodies + i] = s->freedom[2 * bodies + i] = 0;
    }
    start_free(&start);
}

/* Asks for an average by name. */
static struct averages_found ask(const struct scene *s, const char *name,
                                 double until, double tolerance,
                                 const char *model)
{
    struct averages_request q = {.scene = s,
                                 .until = until,
                                 .tolerance = tolerance,
                                 .reason = AVERAGES_REASON,
                                 .model = model};
    struct averages_found f;
    char message[AVERAGES_TEXT];
    if (!averages_read(&q.quantity, name, s, message))
        program_give_up(PROGRAM, "%s", message);
    if (!averages_find(&f, &q))
        program_give_up(PROGRAM, "no memory");
    return f;
}

/* What a way has found, or NULL. */
static const struct averages_candidate *candidate(
    const struct averages_found *f, const char *name)
{
    for (size_t k = 0; k < f->candidates; ++k)
        if (strcmp(f->candidate[k].name, name) == 0)
            return &f->candidate[k];
    return NULL;
}

static bool refused(const struct averages_found *f)
{
    return f->taken == f->candidates;
}

enum { STARTS = 200 };

/* How many of so many starts of two disks stop within half of their error,
   and within all of it. */
static void count_hits(double tolerance, double row[])
{
    const double law = 1.2401672; /* eq:averages-two */
    row[0] = tolerance;
    row[1] = row[2] = row[3] = 0;
    for (int seed = 1; seed <= STARTS && !progress_signal(); ++seed) {
        struct scene s;
        make_disks(&s, 2, 0.15, seed);
        const struct averages_found f =
            ask(&s, "pressure", 1e7, tolerance, "events");
        const double off = fabs(f.value - law) / f.scale;
        row[1] += off <= f.error / 2;
        row[2] += off <= f.error;
        row[3] += f.time / STARTS;
        scene_free(&s);
    }
}

static const struct table_key stop_keys[] = {
    {"all_<tolerance>", "1", "starts off by the error, at most"},
    {"half_<tolerance>", "1", "by half of it"},
    {0}};

static void study_stop(struct study *s)
{
    static const double tolerances[] = {0.05, 0.02, 0.01, 0.005};
    table_column(s->out, "e", "", "tolerance");
    table_column(s->out, "half", "",
                 "of 200 starts, off by half the error");
    table_column(s->out, "all", "", "off by the error, at most");
    table_column(s->out, "t", "s", "simulated, mean");
    for (int k = 0; k < 4; ++k) {
        double row[4];
        char key[32];
        count_hits(tolerances[k], row);
        table_row(s->out, 4, row);
        snprintf(key, sizeof key, "all_%g", tolerances[k]);
        table_real(s->summary, key, row[2] / STARTS);
        snprintf(key, sizeof key, "half_%g", tolerances[k]);
        table_real(s->summary, key, row[1] / STARTS);
    }
}

static void make_pair(struct scene *s, double ratio, int seed)
{
    struct random r;
    random_seed(&r, (uint64_t)seed);
    if (!scene_create(s, 2))
        program_give_up(PROGRAM, "no memory");
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = 1;
    for (size_t i = 0; i < 2; ++i) {
        const double u = random_between(&r, -1, 1);
        s->mass[i] = i == 0 ? 1 : ratio;
        s->position[i] =
            random_between(&r, 0.5 * (double)i, 0.5 * (double)(i + 1));
        s->velocity[i] = ratio == 1 ? 1 + u / 100 : u;
        s->freedom[2 + i] = s->freedom[4 + i] = 0;
    }
}

enum { ROWS = 64 }; /* to a second, about one crossing of the box */

/* Looks at the last three quarters: mean and two standard errors. Returns
   false without a plateau. */
static bool look(const struct blocks *b, double *mean, double *error)
{
    struct statistics_blocking found;
    double x[BLOCKS_MOST];
    const size_t from = (b->count + 3) / 4, n = b->count - from;
    *mean = 0;
    for (size_t i = 0; i < n; ++i) {
        x[i] = b->sum[from + i] / (double)b->per;
        *mean += x[i] / (double)n;
    }
    if (!statistics_blocking(n, x, &found))
        program_give_up(PROGRAM, "no memory");
    *error = 2 * (found.error + found.level[found.chosen].uncertainty);
    return found.plateau;
}

/* Runs until blocks are believed: a plateau, and an error of at most e; if
   twice, again at twice the time, and the two agree. */
static bool believe(const struct scene *s, double until, double e,
                    bool twice, double *mean, double *error)
{
    const struct models_plan plan = {.model = models_find("line")};
    struct blocks b;
    struct models_run r;
    const char *why;
    double first = 0, bar = 0, time = 0; /* of the look to be confirmed */
    bool held = false;
    if (!blocks_create(&b, 1) ||
        !models_begin(&r, &plan, s, 1.0 / ROWS, &why))
        program_give_up(PROGRAM, "no run");
    while (!held && (double)r.rows < until * ROWS) {
        models_row(&r);
        blocks_add(&b, r.scene.position);
        const double now = (double)r.rows;
        if (b.filled > 0 || b.count % 64 > 0 || b.count < 256 ||
            !look(&b, mean, error) || *error > e ||
            (time > 0 && now < 2 * time))
            continue;
        held = !twice ||
               (time > 0 && fabs(*mean - first) <= 0.75 * (*error + bar));
        first = *mean;
        bar = *error;
        time = now;
    }
    models_end(&r);
    blocks_free(&b);
    return held;
}

/* Counts: runs believed, those beyond their error, and the worst of them in
   its errors; then the same of runs looked at twice. */
static void count_pair(double ratio, double row[6])
{
    enum { PAIRS = 6 };
    const double T = 1e4, e = 0.01;
    for (int seed = 1; seed <= PAIRS && !progress_signal(); ++seed) {
        struct scene s;
        double mean, error;
        make_pair(&s, ratio, seed);
        const double whole = ask(&s, "x:0", T, e, NULL).value;
        for (int k = 0; k < 6; k += 3)
            if (believe(&s, T, e, k > 0, &mean, &error)) {
                const double off = fabs(mean - whole) / error;
                row[k] += 1;
                row[k + 1] += off > 1;
                row[k + 2] = fmax(row[k + 2], off);
            }
        scene_free(&s);
    }
}

static const struct table_key pairs_keys[] = {
    {"believed", "1", "runs, all ratios but 1"},
    {"beyond", "1", "of them, off by more than the error"},
    {"worst", "e", "largest difference"},
    {"twice", "1", "the same after two looks"},
    {"twice_beyond", "1", "the same"},
    {"twice_worst", "e", "the same"},
    {"<key>_<ratio>", "its own", "at this ratio of the masses"},
    {0}};

static void study_pairs(struct study *s)
{
    static const double ratios[] = {1, 1.1, 2, 3, 10, 30, 100, 1000};
    static const char *const keys[] = {"believed",     "beyond",
                                       "worst",        "twice",
                                       "twice_beyond", "twice_worst"};
    double all[6] = {0};
    table_column(s->out, "m2/m1", "", "ratio of the masses");
    for (int k = 0; k < 2; ++k) {
        table_column(s->out, "n", "",
                     k ? "believed after two looks"
                       : "runs believed, of 6");
        table_column(s->out, "beyond", "",
                     "of them, off by more than the error");
        table_column(s->out, "worst", "e", "the largest difference");
    }
    for (int k = 0; k < 8 && !progress_signal(); ++k) {
        double row[7] = {ratios[k]};
        count_pair(ratios[k], row + 1);
        table_row(s->out, 7, row);
        for (int j = 0; j < 6; ++j) {
            char key[32];
            snprintf(key, sizeof key, "%s_%g", keys[j], ratios[k]);
            table_real(s->summary, key, row[1 + j]);
            if (k > 0)
                all[j] = j % 3 == 2 ? fmax(all[j], row[1 + j])
                                    : all[j] + row[1 + j];
        }
    }
    for (int j = 0; j < 6; ++j)
        table_real(s->summary, keys[j], all[j]);
}

static void make_line(struct scene *s, double share, int seed)
{
    const size_t n = 3 + (size_t)seed % 6;
    struct random r;
    random_seed(&r, (uint64_t)seed);
    if (!scene_create(s, n))
        program_give_up(PROGRAM, "no memory");
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = (double)n;
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = 1 + share * random_between(&r, -1, 1);
        s->position[i] = (double)i + random_between(&r, 0, 1);
        s->velocity[i] = random_between(&r, -1, 1);
        s->freedom[n + i] = s->freedom[2 * n + i] = 0;
    }
}

/* What two looks at a run have seen of the first body: the first look with
   a plateau and an error of at most e, if any, and the last. */
struct looks {
    bool believed;
    double mean, error, last, bar; /* m, with two standard errors */
};

static struct looks look_twice(const struct scene *s, double until,
                               double e)
{
    enum { EVERY = 4 }; /* to a second */
    const struct models_plan plan = {.model = models_find("line")};
    struct looks w = {.believed = false};
    struct blocks b;
    struct models_run r;
    const char *why;
    if (!blocks_create(&b, 1) ||
        !models_begin(&r, &plan, s, 1.0 / EVERY, &why))
        program_give_up(PROGRAM, "no run");
    while ((double)r.rows < until * EVERY) {
        models_row(&r);
        blocks_add(&b, r.scene.position);
        if (!w.believed && b.filled == 0 && b.count % 64 == 0 &&
            b.count >= 256)
            w.believed = look(&b, &w.mean, &w.error) && w.error <= e;
    }
    look(&b, &w.last, &w.bar);
    models_end(&r);
    blocks_free(&b);
    return w;
}

/* Counts: looks believed, those whose mean the last look finds beyond the
   errors of both; looks that agree with the law, and those of them where
   the last one does not. */
static void count_line(double share, int seed, double row[4])
{
    struct scene s;
    make_line(&s, share, seed);
    const double n = (double)s.bodies, law = n / (n + 1);
    const struct looks w = look_twice(&s, 3e4, 0.01 * n);
    const double off = fabs(w.mean - w.last);
    const bool agree = fabs(w.mean - law) <= 1.5 * w.error;
    scene_free(&s);
    if (!w.believed)
        return;
    row[0] += 1;
    row[1] += off > hypot(w.error, w.bar);
    row[2] += agree;
    row[3] += agree && fabs(w.last - law) > 1.5 * w.bar;
}

static const struct table_key bets_keys[] = {
    {"believed", "1", "looks believed"},
    {"off", "1", "beyond both errors at the end"},
    {"agree", "1", "with the law"},
    {"contradicted", "1", "of them, by the end of the run"},
    {0}};

static void study_bets(struct study *s)
{
    enum { LINES = 40 };
    static const double shares[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3};
    static const char *const keys[] = {"believed", "off", "agree",
                                       "contradicted"};
    double all[4] = {0};
    table_column(s->out, "share", "", "by which masses differ, at most");
    table_column(s->out, "believed", "", "looks believed, of 40");
    table_column(s->out, "off", "",
                 "of them beyond both errors at the end");
    table_column(s->out, "agree", "", "looks that agree with the law");
    table_column(s->out, "contradicted", "",
                 "of them, by the end of the run");
    for (int k = 0; k < 6 && !progress_signal(); ++k) {
        double row[5] = {shares[k]};
        for (int seed = 1; seed <= LINES; ++seed)
            count_line(shares[k], seed, row + 1);
        table_row(s->out, 5, row);
        for (int j = 0; j < 4; ++j)
            all[j] += row[1 + j];
    }
    for (int j = 0; j < 4; ++j)
        table_real(s->summary, keys[j], all[j]);
}

/* The mean place from the start on, at times that double. */
static void run_piston(const struct scene *s, size_t body, int times,
                       double mean[])
{
    enum { EVERY = 4 }; /* s */
    const struct models_plan plan = {.model = models_find("line")};
    struct models_run r;
    const char *why;
    double sum = 0;
    if (!models_begin(&r, &plan, s, EVERY, &why))
        program_give_up(PROGRAM, "%s", why);
    for (int k = 0; k < times && !progress_signal(); ++k) {
        for (; (double)(r.rows * EVERY) < 256 * ldexp(1, k);) {
            models_row(&r);
            sum += r.scene.position[body];
        }
        mean[k] = sum / (double)r.rows;
    }
    models_end(&r);
}

static void study_patience(struct study *s)
{
    enum { BODIES = 41, PISTON = 20, TIMES = 10 };
    struct scene piston;
    double mean[TIMES] = {0};
    make_piston(&piston, BODIES, 600);
    run_piston(&piston, PISTON, TIMES, mean);
    table_column(s->out, "T", "s", "time of the run");
    table_column(s->out, "mean", "m", "place of the piston, events to T");
    table_column(s->out, "x", "m", "the answer, nan: refused");
    table_column(s->out, "error", "m", "and its error");
    table_column(s->out, "way", "", "1: springs, 2: law, 3: events");
    table_column(s->out, "springs", "m", "mean place by springs alone");
    table_column(s->out, "springs_error", "", "and its error, of the box");
    for (int k = 0; k < TIMES && !progress_signal(); ++k) {
        const double T = 256 * ldexp(1, k);
        const struct averages_found f = ask(&piston, "x:20", T, 0.01, NULL);
        const struct averages_candidate *springs = candidate(&f, "springs");
        const char *name = refused(&f) ? "" : f.candidate[f.taken].name;
        const double row[] = {T,
                              mean[k],
                              refused(&f) ? NAN : f.value,
                              f.error * f.scale,
                              *name == 's'   ? 1
                              : *name == 'o' ? 2
                              : *name == 'e' ? 3
                                             : 0,
                              springs->value,
                              springs->error};
        table_row(s->out, 7, row);
    }
    scene_free(&piston);
}

static const struct table_key places_keys[] = {
    {"<way>_error_<r>", "m", "as blocks see it"},
    {"<way>_given_<r>", "1", "1: given, 0: refused"},
    {"<way>_<r>", "m", "mean x of disk 0"},
    {0}};

static void study_places(struct study *s)
{
    static const double radii[] = {0.1, 0.15, 0.18, 0.2, 0.22};
    static const char *const ways[] = {"events", "sampling"};
    table_column(s->out, "r", "m", "radius of the four disks");
    for (int k = 0; k < 2; ++k) {
        table_column(s->out, "x", "m",
                     k ? "the same by sampling"
                       : "mean x of disk 0 by events");
        table_column(s->out, "error", "m", "as blocks see it");
        table_column(s->out, "answer", "", "1: given, 0: refused");
    }
    for (int k = 0; k < 5 && !progress_signal(); ++k) {
        double row[7] = {radii[k]};
        for (int w = 0; w < 2; ++w) {
            struct scene four;
            char key[32];
            make_disks(&four, 4, radii[k], 1);
            const struct averages_found f =
                ask(&four, "x:0", 1e4, 0.02, ways[w]);
            const struct averages_candidate *c = candidate(&f, ways[w]);
            row[1 + 3 * w] = c->value;
            row[2 + 3 * w] = c->error;
            row[3 + 3 * w] = !refused(&f);
            snprintf(key, sizeof key, "%s_%g", ways[w], radii[k]);
            table_real(s->summary, key, c->value);
            snprintf(key, sizeof key, "%s_error_%g", ways[w], radii[k]);
            table_real(s->summary, key, c->error);
            snprintf(key, sizeof key, "%s_given_%g", ways[w], radii[k]);
            table_real(s->summary, key, row[3 + 3 * w]);
            scene_free(&four);
        }
        table_row(s->out, 7, row);
    }
}

/* What it costs to hold a tolerance by this way alone, s by the price
   list, or NAN. */
static double price(const struct scene *s, const char *name,
                    double tolerance, const char *model)
{
    const struct averages_found f = ask(s, name, 1e9, tolerance, model);
    return refused(&f) ? NAN : f.cost;
}

static void study_digits(struct study *s)
{
    static const double tolerances[] = {0.1, 0.05, 0.02, 0.01, 0.005};
    struct scene gas, four;
    if (gallery_make(&gas, gallery_find(hard_scenes, "gas"), NULL, 0))
        program_give_up(PROGRAM, "no memory");
    make_disks(&four, 4, 0.15, 1);
    table_column(s->out, "e", "", "tolerance");
    table_column(s->out, "Z_events", "s", "pressure of 250 disks, price");
    table_column(s->out, "Z_chain", "s", "the same by sampling");
    table_column(s->out, "x_events", "s", "place of one of four, price");
    table_column(s->out, "x_chain", "s", "the same by sampling");
    for (int k = 0; k < 5 && !progress_signal(); ++k) {
        const double e = tolerances[k];
        const double row[] = {
            e, price(&gas, "pressure", e, "events"),
            e < 0.02 ? NAN : price(&gas, "pressure", e, "sampling"),
            price(&four, "x:0", e, "events"),
            price(&four, "x:0", e, "sampling")};
        table_row(s->out, 5, row);
    }
    scene_free(&gas);
    scene_free(&four);
}

static const struct study_entry studies[] = {
    {"stop", study_stop, "how often a mean is within its error", stop_keys},
    {"pairs", study_pairs, "two on a line, and blocks that agree",
     pairs_keys},
    {"bets", study_bets, "random lines and the law of places", bets_keys},
    {"patience", study_patience, "a heavy piston and ever longer runs",
     NULL},
    {"places", study_places, "disks that change places, or do not",
     places_keys},
    {"digits", study_digits, "what a tolerance costs, by two ways", NULL},
    {0}};

int main(int argc, char *argv[])
{
    const struct study_program program = {
        .name = PROGRAM,
        .purpose = "Study averages: when to stop, and what misleads.",
        .events = "rows",
        .studies = studies};
    return study_main(&program, argc, argv);
}
