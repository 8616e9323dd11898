/* Runs a scene with the cheapest model that meets a tolerance. */
#include "choosing/averages.h"
#include "choosing/choose.h"
#include "toolbox/progress.h"
#include "toolbox/program.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "bonk"

/* Settings from the command line. */
static struct {
    const char *scene;
    double until;     /* end of the run, s */
    double tolerance; /* largest error, as a fraction of the scale */
    double every;     /* time between rows, s; 0: run / 16 */
    double budget;    /* maximum cost of choosing and running, s */
    const char *observe, *model;
    bool explain;
    const char *chart, *output, *summary, *command;
} given = {.budget = CHOOSE_BUDGET,
           .until = NAN,
           .tolerance = NAN,
           .summary = "/dev/null"};

/* ROWS is the default number of rows: sixteen rows show where a run went
   wrong and can be read at a glance. Errors are judged at sixteen or more
   times, too. Two runs that are compared at a single time may agree
   although one of them is late by a whole period, and the cheapest run that
   agrees would often be such a run. */
enum { ROWS = 16, ROWS_MOST = 1000000 };

/* Prefix of an average in --observe. */
static const char mean_prefix[] = "mean:";
enum { MEANS_MOST = 16, PREFIX = sizeof mean_prefix - 1 };

struct mean {
    struct averages_quantity quantity;
    struct averages_found found;
};

/* A request and its result: either a run, in `choice`, or averages, in
   `mean`. */
struct run {
    struct scene scene;
    struct observables asked;
    struct choose_request request;
    size_t judged; /* number of compared rows per written row */
    struct choose_choice choice;
    struct models_plan plan; /* plan of --model */
    struct progress progress;
    struct mean mean[MEANS_MOST];
    size_t means; /* averages in --observe; 0 if a run is requested */
    struct table *out, *summary, *chart;
    FILE *explanation; /* output of --explain */
};

/* Sets the times of the rows. They divide the time from the scene's clock
   to --until into equal intervals, because a shorter last interval would
   need steps of another length. If an interval is longer than a sixteenth
   of the run, it is divided further, and errors are also judged between the
   written rows.

   The 1e-9 allows for rounding: 1 / 0.001 is accepted as an integer,
   although 0.001 is not exact in binary, and 1 / 0.3 is refused. */
static void set_rows(struct run *r)
{
    const double length = given.until - r->scene.time;
    if (!(length > 0))
        program_refuse(
            "--until: %.15g is not after the scene's time, %.15g",
            given.until, r->scene.time);
    const double every = given.every > 0 ? given.every : length / ROWS;
    const double rows = length / every;
    if (!(rows <= ROWS_MOST))
        program_refuse("--every: %g makes %.3g rows, more than %d", every,
                       rows, ROWS_MOST);
    if (rows < 0.5 || fabs(rows - floor(rows + 0.5)) > 1e-9 * rows)
        program_refuse("--every: the time from %.10g to %.10g is no whole "
                       "number of rows of %.10g",
                       r->scene.time, given.until, every);
    r->judged = rows < ROWS - 0.5 ? (size_t)ceil(ROWS / rows - 1e-9) : 1;
    r->request.every = every / (double)r->judged;
}

/* Reads the averages of --observe: mean:NAME,mean:NAME... Refuses a mixture
   of averages and values, because averages can be predicted for longer
   times than values. */
static void read_means(struct run *r)
{
    char message[AVERAGES_TEXT], name[64];
    for (const char *at = given.observe; *at;) {
        const size_t n = strcspn(at, ",");
        if (strncmp(at, mean_prefix, PREFIX) != 0)
            program_refuse("--observe: averages (mean:...) and values "
                           "cannot be asked for together, found '%.*s'",
                           (int)n, at);
        snprintf(name, sizeof name, "%.*s", (int)(n - PREFIX), at + PREFIX);
        if (r->means == MEANS_MOST)
            program_refuse("--observe: more than %d averages", MEANS_MOST);
        if (!averages_read(&r->mean[r->means].quantity, name, &r->scene,
                           message))
            program_refuse("--observe: mean:%s: %s", name, message);
        ++r->means;
        at += n + (at[n] == ',');
    }
}

static bool asks_for_means(void)
{
    return given.observe && strstr(given.observe, mean_prefix) != NULL;
}

/* Reads the scene and refuses it if it is invalid. motion_view checks this:
   it refuses no valid scene, because leapfrog can run all of them. */
static void read_scene(struct run *r)
{
    struct motion m;
    if (!scene_read(&r->scene, PROGRAM, given.scene) ||
        !motion_view(&m, PROGRAM, &r->scene))
        exit(OPTIONS_FAILURE);
    motion_end(&m);
    if (r->scene.law != SCENE_SUDDEN)
        program_refuse("%s: contacts that are springs are for step alone: "
                       "no line linear or hertz",
                       given.scene);
}

/* Shows the cost of choosing so far. choose() calls this function after
   each run. The unit is a millisecond, because progress is counted in
   integers. */
static void show_progress(void *with, double spent)
{
    const uint64_t ms = (uint64_t)(1e3 * spent);
    progress_update(with, ms, ms);
}

/* Checks the command against the scene. Refuses it with status 2 before any
   work is done: most mistakes, such as a missing body, a time in the past,
   or a model that cannot run the scene, can be found only with the scene. A
   --model with a number of steps is used unchanged. If --model is only the
   name of a method, the number of steps is chosen. */
static void begin_run(struct run *r)
{
    read_scene(r);
    r->request = (struct choose_request){.scene = &r->scene,
                                         .program = PROGRAM,
                                         .until = given.until,
                                         .tolerance = given.tolerance,
                                         .budget = given.budget,
                                         .watch = show_progress,
                                         .with = &r->progress};
    set_rows(r);
    if (asks_for_means()) {
        read_means(r);
        return;
    }
    char message[OBSERVABLES_MESSAGE];
    if (given.observe) {
        if (!observables_read(&r->asked, given.observe, r->scene.bodies,
                              message))
            program_refuse("--observe: %s", message);
        r->request.asked = &r->asked;
    }
    if (given.model) {
        char wrong[MODELS_MESSAGE];
        if (!models_read(&r->plan, given.model, wrong))
            program_refuse("--model: %s", wrong);
        const char *why = models_refuse(&r->plan, &r->scene);
        if (why)
            program_refuse("--model: %s does not suit this scene: %s",
                           given.model, why);
        r->request.only = &r->plan;
    }
}

/* Prints formatted text if --explain is given. */
static void explain(const struct run *r, const char *format, ...)
{
    va_list values;
    if (!given.explain)
        return;
    va_start(values, format);
    vfprintf(r->explanation, format, values);
    va_end(values);
}

/* Explains the interactions, the first part of the explanation. A scene
   without interactions is valid: its bodies move uniformly. */
static void explain_interactions(const struct run *r)
{
    const struct models_acts *a = &r->choice.acts;
    explain(r, "what acts:%s%s%s%s%s%s%s\n", a->gravity ? " gravity" : "",
            a->springs ? " springs" : "", a->weight ? " weight" : "",
            a->dashpots ? " dashpots" : "", a->friction ? " friction" : "",
            a->contact ? " contacts" : "",
            a->gravity || a->springs || a->weight || a->contact ||
                    a->friction || a->dashpots
                ? ""
                : " nothing");
    explain(r, "bodies that move: %zu of %zu, in %zu dimension%s\n",
            a->free, r->scene.bodies, a->dimensions,
            a->dimensions == 1 ? "" : "s");
}

/* Explains the request and the reference run, the second part of the
   explanation. Candidates are compared with the reference, whose doubt is
   its difference from a coarser reference. An exact model needs no
   reference and has no such line. */
static void explain_request(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    char plan[MODELS_TEXT];
    explain(
        r,
        "asked for: %s within %.3g of %.6g, in %zu rows up to t = %.10g\n",
        c->judged, given.tolerance, c->scale, c->rows, given.until);
    if (c->reference.model) {
        models_write(&c->reference, plan);
        explain(r, "compared with: %s, sure to %.1e\n", plan, c->doubt);
    }
    if (isfinite(c->horizon))
        explain(r, "horizon: t = %.10g\n", c->horizon);
}

/* Explains all candidates, the third part of the explanation. A star marks
   the chosen one. A candidate that was not run to its end has no cost, and
   the reason is printed instead. Even a candidate with a cost may have no
   error. */
static void explain_candidates(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    char plan[MODELS_TEXT], error[16];
    explain(r, "candidates:                     error      cost, s\n");
    for (size_t j = 0; j < c->candidates; ++j) {
        const struct choose_candidate *next = &c->candidate[j];
        models_write(&next->plan, plan);
        if (isinf(next->cost)) {
            explain(r, "  %-26s %s\n", plan, next->text);
            continue;
        }
        snprintf(error, sizeof error, isfinite(next->error) ? "%.2e" : "-",
                 next->error);
        explain(r, "%c %-26s %9s  %9.2e  %s\n", j == c->taken ? '*' : ' ',
                plan, error, next->cost, next->text);
    }
}

static void explain_choice(const struct run *r)
{
    explain_interactions(r);
    explain_request(r);
    explain_candidates(r);
    if (r->choice.run.value) {
        const struct choose_choice *c = &r->choice;
        char text[CHOOSE_SENTENCE];
        choose_sentence(c, given.tolerance, text);
        explain(r, "taken %s\n", text);
        explain(r,
                "found: error %.2e, cost %.2e s\n"
                "besides: deciding %.2e s\n",
                c->candidate[c->taken].error, c->run.cost,
                c->spent - c->run.cost);
    }
}

/* Writes the table head. Its command must reproduce the same table, so the
   chosen plan is added unless --model was given. The default columns are
   the state of every body, as in the tables of `step`, so the same plotting
   programs can read both. */
static void write_head(struct run *r)
{
    char plan[MODELS_TEXT], command[8192];
    models_write(&r->choice.run.plan, plan);
    snprintf(command, sizeof command, "%s%s%s", given.command,
             given.model ? "" : " --model ", given.model ? "" : plan);
    table_begin(r->out, command, 0);
    table_print(r->out, "# model: %s\n", plan);
    table_column(r->out, "t", "time", "time, in the units of the scene");
    if (r->request.asked)
        observables_head(&r->asked, r->out);
    else
        observables_head_states(r->out, r->scene.bodies, NULL);
}

static bool write_rows(struct run *r)
{
    const struct choose_choice *c = &r->choice;
    double *row = malloc((c->columns + 1) * sizeof *row);
    bool good = row != NULL;
    for (size_t j = 0; good && j <= c->rows; j += r->judged) {
        row[0] = r->scene.time + (double)j * r->request.every;
        memcpy(row + 1, c->run.value + j * c->columns,
               c->columns * sizeof *row);
        good = table_row(r->out, c->columns + 1, row);
    }
    free(row);
    return good;
}

static void write_point(const struct run *r, struct models_plan plan,
                        double error, double cost, int taken)
{
    char text[MODELS_TEXT];
    models_write(&plan, text);
    table_print(r->chart, "%.6g %.6g %d %s\n", error, cost, taken, text);
}

static void write_chart_head(const struct run *r, const char *refusal)
{
    table_begin(r->chart, given.command, 0);
    table_print(r->chart, "# tolerance: %.17g\n", given.tolerance);
    if (refusal)
        table_print(r->chart, "# refused: %s\n", refusal);
    TABLE_COLUMNS(r->chart, {"error", "", "fraction of the scale"},
                  {"cost", "s", "by the price list"},
                  {"taken", "", "1: this one, and where it stands"},
                  {"plan", "", "its model, and what it leaves out"});
}

/* Writes the chart of error against cost. Successive runs of a model with
   the same simplifications form a block. Two blank lines between blocks
   make gnuplot start a new curve. The last block contains only the chosen
   run. After a refusal the chart still shows how close each model came. */
static void write_chart(const struct run *r, const char *refusal)
{
    const struct choose_choice *c = &r->choice;
    write_chart_head(r, refusal);
    for (size_t j = 0; j < c->points; ++j) {
        const struct choose_point *p = &c->point[j];
        if (j > 0 && (p->plan.model != p[-1].plan.model ||
                      p->plan.cuts != p[-1].plan.cuts))
            table_print(r->chart, "\n\n");
        write_point(r, p->plan, p->error, p->cost, 0);
    }
    if (c->taken == c->candidates)
        return;
    const struct choose_candidate *taken = &c->candidate[c->taken];
    table_print(r->chart, "\n\n");
    write_point(r, taken->plan, taken->error, taken->cost, 1);
}

/* Writes the summary. After a refusal `horizon` is the most useful
   result. Only `seconds`, the last line, depends on the machine. */
static void summarise(const struct run *r, const char *refusal)
{
    const struct choose_choice *c = &r->choice;
    struct table *t = r->summary;
    char plan[MODELS_TEXT] = "none";
    if (!refusal)
        models_write(&c->run.plan, plan);
    table_text(t, "end", refusal ? "refused" : "whole");
    table_text(t, "model", plan);
    table_real(t, "tolerance", given.tolerance);
    table_text(t, "judged", c->judged);
    TABLE_RESULTS(
        t, {"scale", c->scale},
        {"error_found", refusal ? INFINITY : c->candidate[c->taken].error},
        {"cost", c->run.cost}, {"deciding", c->spent - c->run.cost},
        {"doubt", c->doubt}, {"rounding", c->rounding},
        {"horizon", c->horizon}, {"seconds", c->run.seconds});
}

static char model_help[128 * STEPPING_MOST] =
    "instead of choosing: one of these; with steps in\n"
    "each row (or in each part of one longer than a\n"
    "sixteenth of the run) or a tolerance of its own\n"
    "steps, and what to leave out: pefrl:24,no-light";

static const struct options_entry entries[] = {
    {"", 0, "SCENE", "a scene file; - is standard input"},
    {"until", 't', "T", "the time at which to stop"},
    {"tolerance", 'e', "E",
     "the largest error, a fraction of the scale of\n"
     "what is asked for; of a mean, the scale is the\n"
     "larger of 1 and Z, the side of the box along x\n"
     "or y, or the value of kinetic or temperature"},
    {"every", 'd', "DT", "time from row to row (a sixteenth of the run)"},
    {"observe", 'O', "NAMES",
     "instead of all states: energy, momentum, x:3\n"
     "and others of step; or averages: mean:NAME"},
    {"model", 'm', "PLAN", model_help},
    {"reason", 'r', "S",
     "what deciding and the run may cost together,\n"
     "seconds by the price list (60)"},
    {"explain", 'x' | OPTIONS_SILENT, NULL,
     "say what was looked at, and why; with -o FILE\n"
     "to standard output, else to standard error"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"chart", 'c' | OPTIONS_SILENT | OPTIONS_WRITES, "FILE",
     "write the candidates: error and cost"},
    {0}};

static const struct table_key keys[] = {
    {"end", "word", "whole or refused"},
    {"model", "word", "that was taken; none, several"},
    {"tolerance", "1", "as asked for"},
    {"error_found", "1", "as a fraction of the scale"},
    {"cost", "s", "of the run, by the price list"},
    {"deciding", "s", "of choosing, the same"},
    {"", "", "if --observe names no mean:"},
    {"judged", "word", "what the error is of"},
    {"scale", "its own", "what it is a fraction of"},
    {"doubt", "1", "of the run to compare others with; 0: none"},
    {"rounding", "1", "what rounding does to a run without steps"},
    {"horizon", "time", "beyond which nothing can be said"},
    {"seconds", "s", "processor time of the run"},
    {0}};

/* Returns whether two outputs would overwrite each other. */
static bool same_file(const char *a, const char *b)
{
    return a && b && strcmp(a, b) == 0 && strcmp(a, "/dev/null") != 0;
}

/* Refuses a command that is incomplete or contradicts itself. The tolerance
   has no default, because users would seldom change a default and only they
   know the error they can accept. */
static void check_settings(struct options *o)
{
    const char *output = given.output ? given.output : "-";
    if (!given.scene)
        options_fail(o, "a scene is needed, as in build/bin/scene "
                        "sun-earth | bonk - --until 365 --tolerance 1e-3");
    if (isnan(given.until))
        options_fail(o, "--until is needed: the time at which to stop");
    if (isnan(given.tolerance))
        options_fail(o, "--tolerance is needed: how wrong may it be?");
    if (asks_for_means())
        options_refuse(o, "every", "with an average, which has no rows");
    if (same_file(given.summary, output) ||
        same_file(given.chart, output) ||
        same_file(given.chart, given.summary))
        options_fail(o, "the table, --summary and --chart need files of "
                        "their own");
}

/* Appends the names of the models to model_help and reads the command line.
   A time may be negative, because the scene's clock may be. */
static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    char *help = model_help + strlen(model_help);
    for (const struct models_model *m = models_all(); m->name; ++m)
        help += sprintf(help, "\n%s: %s", m->name, m->about);
    help += sprintf(help, "\nleaving out:");
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        help +=
            sprintf(help, k % 4 == 3 ? "\n%s" : " %s", models_cut_names[k]);
    options_begin(&o, PROGRAM,
                  "Carry a scene through time at the least cost that holds "
                  "a tolerance.",
                  entries, argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        switch (option) {
        case OPTIONS_ARGUMENT:
            given.scene = options_only(&o, given.scene, "scene");
            break;
        case 't':
            given.until = options_real(&o, -INFINITY, INFINITY);
            break;
        case 'e': given.tolerance = options_positive(&o, INFINITY); break;
        case 'd': given.every = options_positive(&o, INFINITY); break;
        case 'O': given.observe = options_text(&o); break;
        case 'm': given.model = options_text(&o); break;
        case 'r': given.budget = options_positive(&o, INFINITY); break;
        case 'x': given.explain = true; break;
        case 'c': given.chart = options_text(&o); break;
        case 'o': given.output = options_text(&o); break;
        case 'S': given.summary = options_text(&o); break;
        }
    given.command = options_command(&o);
    check_settings(&o);
}

/* Returns the diagonal (in m) of the box that contains all bodies in all
   rows of the run. Leaves out periodic axes. */
static double size_of_run(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (size_t at = k; at < (c->rows + 1) * c->columns; at += 6) {
            low = fmin(low, c->run.value[at]);
            high = fmax(high, c->run.value[at]);
        }
        if (r->scene.wall[k] != SCENE_PERIODIC)
            sum += (high - low) * (high - low);
    }
    return sqrt(sum);
}

/* Prints a note if the bodies spread much farther than at the start, as on
   an orbit that starts at its pericentre. Position errors are fractions of
   the initial size, but the user may have meant a fraction of the larger
   size. */
static void warn_of_scale(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    if (!c->run.value || r->request.asked)
        return;
    const double size = size_of_run(r), e = given.tolerance;
    if (size > 10 * c->scale)
        program_say("%s: note: %g is a fraction of %.6g, the size of the "
                    "scene at the start; in the run it becomes %.6g, and "
                    "that fraction of it is --tolerance %.2g",
                    given.scene, e, c->scale, size, e * size / c->scale);
}

/* Prints a note if one distant body makes the scale so large that the
   tolerance does not resolve the distance between two other bodies.
   Suggests a tolerance that does. The note is printed even without
   --explain: the result meets the tolerance as written, but probably not as
   meant. */
static void warn_of_hidden_pair(const struct run *r)
{
    const struct choose_hidden *h = &r->choice.hidden;
    const double e = given.tolerance;
    if (h->a == h->b)
        return;
    program_say("%s: note: %g of the scale, %.6g, is more than what bodies "
                "%zu and %zu are apart at the start, %.3g; without body "
                "%zu the scale would be %.3g: --tolerance %.2g",
                given.scene, e, r->choice.scale, h->a, h->b, h->distance,
                h->far, h->without, e * h->without / r->choice.scale);
}

/* Writes the rows of the run. After a refusal prints the reason and writes
   no table. Returns false if the table could not be written. */
static bool write_run(struct run *r, const char *refusal)
{
    if (refusal) {
        program_say("%s: %s", given.scene, refusal);
        table_discard(r->out);
        return true;
    }
    write_head(r);
    const bool good = write_rows(r);
    return table_close(r->out) && good;
}

static const char *const sure_names[] = {"exact", "bound", "estimate",
                                         "out"};

/* Explains how an average was found: its method, value and error, and
   whether the error is exact, a bound or an estimate. */
static void explain_mean(const struct run *r, const struct mean *m)
{
    const struct averages_found *f = &m->found;
    char symbol[32];
    averages_name(&m->quantity, symbol);
    if (!f->way)
        return;
    explain(r, "%s: %s\n  %s, %s, cost %.2e s\n", symbol, f->way, f->text,
            sure_names[f->sure], f->cost);
    if (isfinite(f->value) && (f->cost > 0 || f->sure != AVERAGES_OUT))
        explain(r,
                "  found: %.6g, error %.2e, a fraction of %.2e of %.4g\n",
                f->value, f->error * f->scale, f->error, f->scale);
}

/* Finds one average. Returns NULL, or the reason for a refusal. Each
   average has its own request, because two averages of a scene may be found
   in different ways, such as the energy from a law and the pressure from
   events. */
static const char *find_mean(struct run *r, struct mean *m)
{
    const struct averages_request q = {.scene = &r->scene,
                                       .quantity = m->quantity,
                                       .until = given.until - r->scene.time,
                                       .tolerance = given.tolerance,
                                       .budget = given.budget,
                                       .model = given.model};
    program_memory(averages_find(&m->found, &q), "for averages");
    explain_mean(r, m);
    return m->found.sure == AVERAGES_OUT ? m->found.refusal : NULL;
}

/* Returns the name of the method that found the averages, or "several" if
   the methods differ. */
static const char *mean_model(const struct run *r)
{
    const char *name = NULL;
    for (size_t j = 0; j < r->means; ++j) {
        const char *next = r->mean[j].found.way;
        name = !name || strcmp(name, next) == 0 ? next : "several";
    }
    return name;
}

/* Writes one row with all averages and their errors. */
static bool write_means(struct run *r)
{
    double row[2 * MEANS_MOST];
    char symbol[32], error[48], text[96];
    table_begin(r->out, given.command, 0);
    table_print(r->out, "# model: %s\n", mean_model(r));
    for (size_t j = 0; j < r->means; ++j) {
        const struct averages_found *f = &r->mean[j].found;
        const char *unit = averages_name(&r->mean[j].quantity, symbol);
        snprintf(error, sizeof error, "error_%s", symbol);
        table_column(r->out, symbol, unit, "average");
        snprintf(text, sizeof text,
                 "two standard errors, or a bound; asked: %.4g of %.4g",
                 given.tolerance, f->scale);
        table_column(r->out, error, unit, text);
        row[2 * j] = f->value;
        /* f->error is relative. The column has the average's unit. */
        row[2 * j + 1] = f->error * f->scale;
    }
    const bool good = table_row(r->out, 2 * r->means, row);
    return table_close(r->out) && good;
}

/* Writes the summary of the averages: the sum of their costs and the
   largest of their errors. The summary of a run has the same keys, so one
   script can read both. */
static void summarise_means(const struct run *r, const char *refusal)
{
    struct table *t = r->summary;
    double cost = 0, most = 0;
    for (size_t j = 0; j < r->means; ++j) {
        cost += r->mean[j].found.cost;
        most = fmax(most, r->mean[j].found.error);
    }
    table_text(t, "end", refusal ? "refused" : "whole");
    table_text(t, "model", refusal ? "none" : mean_model(r));
    TABLE_RESULTS(t, {"tolerance", given.tolerance}, {"error_found", most},
                  {"cost", cost}, {"deciding", 0});
}

/* Finds all averages and writes them, and a point for each of them in the
   chart. If one of them is refused, writes no row and sets *refusal to the
   reason. Returns false if a file could not be written. */
static bool answer_means(struct run *r, const char **refusal)
{
    bool good = true;
    for (size_t j = 0; j < r->means && !*refusal; ++j)
        *refusal = find_mean(r, &r->mean[j]);
    if (*refusal) {
        program_say("%s: %s", given.scene, *refusal);
        table_discard(r->out);
    } else
        good = write_means(r);
    if (r->chart) {
        write_chart_head(r, *refusal);
        for (size_t j = 0; j < r->means; ++j) {
            const struct averages_found *f = &r->mean[j].found;
            if (f->way && f->cost > 0)
                table_print(r->chart, "%.6g %.6g %d %s\n\n\n", f->error,
                            f->cost, f->sure != AVERAGES_OUT, f->way);
        }
    }
    summarise_means(r, *refusal);
    return good;
}

/* Chooses a model, runs the scene with it, and writes the results. Sets
   *refusal to the reason if there is no run. Returns false if a file could
   not be written. */
static bool answer_run(struct run *r, const char **refusal)
{
    progress_begin(&r->progress, PROGRAM, (uint64_t)(1e3 * given.budget),
                   "ms by the price list");
    if (!choose(&r->choice, &r->request))
        program_leave(EXIT_FAILURE);
    progress_end(&r->progress);
    warn_of_hidden_pair(r);
    warn_of_scale(r);
    explain_choice(r);
    *refusal = r->choice.run.value ? NULL : r->choice.refusal;
    if (r->chart)
        write_chart(r, *refusal);
    const bool good = write_run(r, *refusal);
    summarise(r, *refusal);
    choose_free(&r->choice);
    return good;
}

/* Runs bonk. Opens all outputs before the work begins, so a missing folder
   is noticed immediately and not after ten minutes. */
int main(int argc, char *argv[])
{
    static struct run r;
    const char *refusal = NULL;
    read_settings(argc, argv);
    begin_run(&r);
    /* Keep the explanation and the table in different streams. */
    r.explanation =
        given.output && strcmp(given.output, "-") ? stdout : stderr;
    r.out = program_table(given.output);
    r.summary = program_table(given.summary);
    r.chart = given.chart ? program_table(given.chart) : NULL;
    table_keys(r.summary, keys);
    bool good =
        r.means > 0 ? answer_means(&r, &refusal) : answer_run(&r, &refusal);
    good = table_close(r.chart) && good;
    good = table_close(r.summary) && good;
    scene_free(&r.scene);
    return good && !refusal ? EXIT_SUCCESS : EXIT_FAILURE;
}
