/* From chapters/works/12-bonk.nw: edit there, then run make tangle. */
/* checksum 4025117658 of the lines below */
/* Carries a scene by the cheapest model that holds, and says why. */
#include "enough/averages.h"
#include "enough/choose.h"
#include "scenes/scene.h"
#include "toolbox/options.h"
#include "toolbox/progress.h"
#include "toolbox/program.h"
#include "toolbox/table.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "bonk"

struct settings {
    const char *scene;
    double until, tolerance, every, reason; /* s; share; s; s */
    const char *observe, *model;
    bool explain;
    const char *chart, *output, *summary, *command;
};

enum { ROWS = 16, ROWS_MOST = 1000000 };

static const char mean_mark[] = "mean:";
enum { MEANS_MOST = 16, MARK = sizeof mean_mark - 1 };

/* An average that is asked for. */
struct mean {
    struct averages_quantity quantity;
    struct averages_found found;
};

struct run {
    const struct settings *s;
    struct scene scene;
    struct observables asked;
    struct choose_request request;
    size_t judged; /* rows, of which the last one is written */
    struct choose_choice choice;
    struct models_plan plan; /* that was asked for */
    struct progress progress;
    struct mean mean[MEANS_MOST];
    size_t means; /* 0: a run is asked for */
    struct table *out, *summary, *chart;
    FILE *story; /* where --explain goes */
};

static void read_observe(struct run *r)
{
    char message[OBSERVABLES_MESSAGE];
    const char *text = r->s->observe;
    if (!text)
        return;
    if (!observables_read(&r->asked, text, r->scene.bodies, message))
        program_refuse(PROGRAM, "--observe: %s", message);
    r->request.asked = &r->asked;
}

/* Sets the rows: whole ones, from the start to the end. */
static void divide(struct run *r)
{
    const struct settings *s = r->s;
    const double length = s->until - r->scene.time;
    if (!(length > 0))
        program_refuse(
            PROGRAM, "--until: %.15g is not after the scene's time, %.15g",
            s->until, r->scene.time);
    const double every = s->every > 0 ? s->every : length / ROWS;
    const double rows = length / every;
    if (!(rows <= ROWS_MOST))
        program_refuse(PROGRAM, "--every: %g makes %.3g rows, more than %d",
                       every, rows, ROWS_MOST);
    if (rows < 0.5 || fabs(rows - floor(rows + 0.5)) > 1e-9 * rows)
        program_refuse(PROGRAM,
                       "--every: the time from %.10g to %.10g is no whole "
                       "number of rows of %.10g",
                       r->scene.time, s->until, every);
    r->judged = rows < ROWS - 0.5 ? (size_t)ceil(ROWS / rows - 1e-9) : 1;
    r->request.every = every / (double)r->judged;
}

static void read_model(struct run *r)
{
    char message[MODELS_MESSAGE];
    if (!r->s->model)
        return;
    if (!models_read(&r->plan, r->s->model, message))
        program_refuse(PROGRAM, "--model: %s", message);
    const char *why = models_refuse(&r->plan, &r->scene);
    if (why)
        program_refuse(PROGRAM, "--model: %s does not suit this scene: %s",
                       r->s->model, why);
    r->request.only = &r->plan;
}

/* Reads mean:NAME,mean:NAME... */
static void read_means(struct run *r)
{
    char message[AVERAGES_TEXT], name[64];
    for (const char *at = r->s->observe; *at;) {
        const size_t n = strcspn(at, ",");
        if (strncmp(at, mean_mark, MARK) != 0)
            program_refuse(PROGRAM,
                           "--observe: averages (mean:...) and values "
                           "cannot be asked for together, found '%.*s'",
                           (int)n, at);
        snprintf(name, sizeof name, "%.*s", (int)(n - MARK), at + MARK);
        if (r->means == MEANS_MOST)
            program_refuse(PROGRAM, "--observe: more than %d averages",
                           MEANS_MOST);
        if (!averages_read(&r->mean[r->means].quantity, name, &r->scene,
                           message))
            program_refuse(PROGRAM, "--observe: mean:%s: %s", name,
                           message);
        ++r->means;
        at += n + (at[n] == ',');
    }
}

static bool asks_for_means(const struct settings *s)
{
    return s->observe && strstr(s->observe, mean_mark) != NULL;
}

/* Reads the scene, and asks whether it can be set in motion at all. */
static void read_scene(struct run *r)
{
    struct motion m;
    if (!scene_read(&r->scene, PROGRAM, r->s->scene) ||
        !motion_view(&m, PROGRAM, &r->scene))
        exit(OPTIONS_FAILURE);
    motion_end(&m);
    if (r->scene.touch != SCENE_SUDDEN)
        program_refuse(PROGRAM,
                       "%s: contacts that are springs are for step "
                       "alone: no line linear or hertz",
                       r->s->scene);
}

static void show_progress(void *with, double spent)
{
    const uint64_t ms = (uint64_t)(1e3 * spent);
    progress_update(with, ms, ms);
}

static void begin_run(struct run *r)
{
    const struct settings *s = r->s;
    read_scene(r);
    r->request = (struct choose_request){.scene = &r->scene,
                                         .program = PROGRAM,
                                         .until = s->until,
                                         .tolerance = s->tolerance,
                                         .reason = s->reason,
                                         .watch = show_progress,
                                         .with = &r->progress};
    divide(r);
    if (asks_for_means(s)) {
        read_means(r);
        return;
    }
    read_observe(r);
    read_model(r);
}

static void open_outputs(struct run *r)
{
    const struct settings *s = r->s;
    r->story = s->output && strcmp(s->output, "-") ? stdout : stderr;
    r->out = program_table(PROGRAM, s->output);
    r->summary = program_table(PROGRAM, s->summary);
    r->chart = s->chart ? program_table(PROGRAM, s->chart) : NULL;
}

static void tell(const struct run *r, const char *format, ...)
{
    va_list values;
    if (!r->s->explain)
        return;
    va_start(values, format);
    vfprintf(r->story, format, values);
    va_end(values);
}

static void tell_acts(const struct run *r)
{
    const struct models_acts *a = &r->choice.acts;
    tell(r, "what acts:%s%s%s%s%s%s%s\n", a->gravity ? " gravity" : "",
         a->springs ? " springs" : "", a->weight ? " weight" : "",
         a->dashpots ? " dashpots" : "", a->friction ? " friction" : "",
         a->contact ? " contacts" : "",
         a->gravity || a->springs || a->weight || a->contact ||
                 a->friction || a->dashpots
             ? ""
             : " nothing");
    tell(r, "bodies that move: %zu of %zu, in %zu dimension%s\n", a->free,
         r->scene.bodies, a->dimensions, a->dimensions == 1 ? "" : "s");
}

static void tell_asked(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    char plan[MODELS_TEXT];
    tell(r,
         "asked for: %s within %.3g of %.6g, in %zu rows up to t = %.10g\n",
         c->judged, r->s->tolerance, c->scale, c->rows, r->s->until);
    if (c->reference.model) {
        models_write(&c->reference, plan);
        tell(r, "compared with: %s, sure to %.1e\n", plan, c->doubt);
    }
    if (isfinite(c->horizon))
        tell(r, "horizon: t = %.10g\n", c->horizon);
}

static void tell_candidates(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    char plan[MODELS_TEXT], error[16];
    tell(r, "candidates:                     error      cost, s\n");
    for (size_t j = 0; j < c->candidates; ++j) {
        const struct choose_candidate *next = &c->candidate[j];
        models_write(&next->plan, plan);
        if (isinf(next->cost)) {
            tell(r, "  %-26s %s\n", plan, next->text);
            continue;
        }
        snprintf(error, sizeof error, isfinite(next->error) ? "%.2e" : "-",
                 next->error);
        tell(r, "%c %-26s %9s  %9.2e  %s\n", j == c->taken ? '*' : ' ',
             plan, error, next->cost, next->text);
    }
}

static void tell_taken(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    char text[CHOOSE_SENTENCE];
    choose_sentence(c, r->s->tolerance, text);
    tell(r, "taken %s\n", text);
    tell(r,
         "found: error %.2e, cost %.2e s\n"
         "besides: deciding %.2e s\n",
         c->candidate[c->taken].error, c->run.cost, c->spent - c->run.cost);
}

static void tell_choice(const struct run *r)
{
    tell_acts(r);
    tell_asked(r);
    tell_candidates(r);
    if (r->choice.run.value)
        tell_taken(r);
}

static void write_state_columns(struct run *r)
{
    static const char *const symbol[] = {"x", "y", "z", "vx", "vy", "vz"};
    char name[32];
    for (size_t i = 0; i < r->scene.bodies; ++i)
        for (size_t k = 0; k < 6; ++k) {
            snprintf(name, sizeof name, "%s:%zu", symbol[k], i);
            table_column(r->out, name, k < 3 ? "length" : "length/time",
                         k < 3 ? "place" : "velocity");
        }
}

static void write_head(struct run *r)
{
    char plan[MODELS_TEXT], command[8192];
    models_write(&r->choice.run.plan, plan);
    snprintf(command, sizeof command, "%s%s%s", r->s->command,
             r->s->model ? "" : " --model ", r->s->model ? "" : plan);
    table_begin(r->out, command, 0);
    table_print(r->out, "# model: %s\n", plan);
    table_column(r->out, "t", "time", "time, in the units of the scene");
    if (r->request.asked)
        observables_head(&r->asked, r->out);
    else
        write_state_columns(r);
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
    table_begin(r->chart, r->s->command, 0);
    table_print(r->chart, "# tolerance: %.17g\n", r->s->tolerance);
    if (refusal)
        table_print(r->chart, "# refused: %s\n", refusal);
    table_column(r->chart, "error", "", "share of the scale");
    table_column(r->chart, "cost", "s", "by the price list");
    table_column(r->chart, "taken", "", "1: this one, and where it stands");
    table_column(r->chart, "plan", "", "its model, and what it leaves out");
}

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

static void summarise(const struct run *r, const char *refusal)
{
    const struct choose_choice *c = &r->choice;
    struct table *t = r->summary;
    char plan[MODELS_TEXT] = "none";
    if (!refusal)
        models_write(&c->run.plan, plan);
    table_text(t, "end", refusal ? "refused" : "whole");
    table_text(t, "model", plan);
    table_real(t, "tolerance", r->s->tolerance);
    table_text(t, "judged", c->judged);
    table_real(t, "scale", c->scale);
    table_real(t, "error_found",
               refusal ? INFINITY : c->candidate[c->taken].error);
    table_real(t, "cost", c->run.cost);
    table_real(t, "deciding", c->spent - c->run.cost);
    table_real(t, "doubt", c->doubt);
    table_real(t, "rounding", c->rounding);
    table_real(t, "horizon", c->horizon);
    table_real(t, "seconds", c->run.seconds);
}

static char model_help[128 * STEPPING_MOST] =
    "instead of choosing: one of these; with steps in\n"
    "each row (or in each part of one longer than a\n"
    "sixteenth of the run) or a tolerance of its own\n"
    "steps, and what to leave out: pefrl:24,no-light";

/* The table of models is the only list of them. */
static void list_models(void)
{
    char *help = model_help + strlen(model_help);
    for (const struct models_model *m = models_all(); m->name; ++m)
        help += sprintf(help, "\n%s: %s", m->name, m->about);
    help += sprintf(help, "\nleaving out:");
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        help +=
            sprintf(help, k % 4 == 3 ? "\n%s" : " %s", models_cut_names[k]);
}

static const struct options_entry entries[] = {
    {"", 0, "SCENE", "a scene file; - is standard input"},
    {"until", 't', "T", "the time at which to stop"},
    {"tolerance", 'e', "E",
     "the largest error, a share of the scale of\n"
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
    {"explain", 'x', NULL,
     "say what was looked at, and why; with -o FILE\n"
     "to standard output, else to standard error"},
    {"output", 'o', "FILE", "for the table (standard output)"},
    {"summary", 'S', "FILE", "for the results as lines: key value"},
    {"chart", 'c', "FILE", "write the candidates: error and cost"},
    {0}};

static const struct table_key keys[] = {
    {"end", "word", "whole or refused"},
    {"model", "word", "that was taken; none, several"},
    {"tolerance", "1", "as asked for"},
    {"error_found", "1", "as a share of the scale"},
    {"cost", "s", "of the run, by the price list"},
    {"deciding", "s", "of choosing, the same"},
    {"", "", "if --observe names no mean:"},
    {"judged", "word", "what the error is of"},
    {"scale", "its own", "what it is a share of"},
    {"doubt", "1", "of the run to compare others with; 0: none"},
    {"rounding", "1", "what rounding does to a run without steps"},
    {"horizon", "time", "beyond which nothing can be said"},
    {"seconds", "s", "processor time of the run"},
    {0}};

static bool same_file(const char *a, const char *b)
{
    return a && b && strcmp(a, b) == 0 && strcmp(a, "/dev/null") != 0;
}

static void check_settings(struct options *o, const struct settings *s)
{
    const char *output = s->output ? s->output : "-";
    if (!s->scene)
        options_fail(o, "a scene is needed, as in build/bin/scene "
                        "sun-earth | bonk - --until 365 --tolerance 1e-3");
    if (isnan(s->until))
        options_fail(o, "--until is needed: the time at which to stop");
    if (isnan(s->tolerance))
        options_fail(o, "--tolerance is needed: how wrong may it be?");
    if (asks_for_means(s))
        options_refuse(o, "every", "with an average, which has no rows");
    if (same_file(s->summary, output) || same_file(s->chart, output) ||
        same_file(s->chart, s->summary))
        options_fail(o, "the table, --summary and --chart need files of "
                        "their own");
}

static void take_option(struct options *o, struct settings *s, int option)
{
    switch (option) {
    case OPTIONS_ARGUMENT:
        s->scene = options_only(o, s->scene, "scene");
        break;
    case 't': s->until = options_real(o, -INFINITY, INFINITY); break;
    case 'e':
        s->tolerance = options_real(o, OPTIONS_POSITIVE, INFINITY);
        break;
    case 'd': s->every = options_real(o, OPTIONS_POSITIVE, INFINITY); break;
    case 'O': s->observe = options_text(o); break;
    case 'm': s->model = options_text(o); break;
    case 'r':
        s->reason = options_real(o, OPTIONS_POSITIVE, INFINITY);
        break;
    case 'x': s->explain = true; break;
    case 'c': s->chart = options_text(o); break;
    case 'o': s->output = options_text(o); break;
    case 'S': s->summary = options_text(o); break;
    }
}

static void read_settings(struct settings *s, int argc, char *argv[])
{
    struct options o;
    int option;
    list_models();
    *s = (struct settings){.reason = CHOOSE_REASON,
                           .until = NAN,
                           .tolerance = NAN,
                           .summary = "/dev/null"};
    options_begin(&o, PROGRAM,
                  "Carry a scene through time at the least cost that holds "
                  "a tolerance.",
                  entries, argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        take_option(&o, s, option);
    s->command = options_command(&o);
    check_settings(&o, s);
}

/* The diagonal of the box that holds all bodies in all rows of the run, m,
   but for axes on which they go round. */
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

/* Errors of places are shares of the scene's size at the start. If the run
   becomes much larger, as that of an orbit which begins at its nearest
   point, its reader may have thought of a share of that. */
static void warn_of_scale(const struct run *r)
{
    const struct choose_choice *c = &r->choice;
    if (!c->run.value || r->request.asked)
        return;
    const double size = size_of_run(r), e = r->s->tolerance;
    if (size > 10 * c->scale)
        fprintf(stderr,
                PROGRAM
                ": %s: note: %g is a share of %.6g, the size of the "
                "scene at the start; in the run it becomes %.6g, "
                "and that share of it is --tolerance %.2g\n",
                r->s->scene, e, c->scale, size, e * size / c->scale);
}

static void warn(const struct run *r)
{
    const struct choose_hidden *h = &r->choice.hidden;
    const double e = r->s->tolerance;
    if (h->a == h->b)
        return;
    fprintf(stderr,
            PROGRAM ": %s: note: %g of the scale, %.6g, is more than what "
                    "bodies %zu and %zu are apart at the start, %.3g; "
                    "without body %zu the scale would be %.3g: --tolerance "
                    "%.2g\n",
            r->s->scene, e, r->choice.scale, h->a, h->b, h->apart, h->far,
            h->without, e * h->without / r->choice.scale);
}

/* Returns NULL, or why there is no run. */
static const char *carry(struct run *r)
{
    progress_begin(&r->progress, PROGRAM, (uint64_t)(1e3 * r->s->reason),
                   "ms by the price list");
    if (!choose(&r->choice, &r->request))
        program_leave(EXIT_FAILURE);
    progress_end(&r->progress);
    warn(r);
    warn_of_scale(r);
    tell_choice(r);
    return r->choice.run.value ? NULL : r->choice.refusal;
}

/* Hands out the rows, or says why there are none. */
static bool hand_out(struct run *r, const char *refusal)
{
    if (refusal) {
        fprintf(stderr, PROGRAM ": %s: %s\n", r->s->scene, refusal);
        table_discard(r->out);
        return true;
    }
    write_head(r);
    const bool good = write_rows(r);
    return table_close(r->out) && good;
}

static const char *const sure_names[] = {"exact", "bound", "estimate",
                                         "out"};

static void tell_mean(const struct run *r, const struct mean *m)
{
    const struct averages_found *f = &m->found;
    char symbol[32];
    averages_name(&m->quantity, symbol);
    if (!f->way)
        return;
    tell(r, "%s: %s\n  %s, %s, cost %.2e s\n", symbol, f->way, f->text,
         sure_names[f->sure], f->cost);
    if (isfinite(f->value) && (f->cost > 0 || f->sure != AVERAGES_OUT))
        tell(r, "  found: %.6g, error %.2e, a share of %.2e of %.4g\n",
             f->value, f->error * f->scale, f->error, f->scale);
}

/* Finds one average. Returns NULL, or why there is none. */
static const char *find_mean(struct run *r, struct mean *m)
{
    const struct settings *s = r->s;
    const struct averages_request q = {.scene = &r->scene,
                                       .quantity = m->quantity,
                                       .until = s->until - r->scene.time,
                                       .tolerance = s->tolerance,
                                       .reason = s->reason,
                                       .model = s->model};
    if (!averages_find(&m->found, &q))
        program_give_up(PROGRAM, "no memory for averages");
    tell_mean(r, m);
    return m->found.sure == AVERAGES_OUT ? m->found.refusal : NULL;
}

/* The way that was taken, the same for all or "several". */
static const char *mean_model(const struct run *r)
{
    const char *name = NULL;
    for (size_t j = 0; j < r->means; ++j) {
        const char *next = r->mean[j].found.way;
        name = !name || strcmp(name, next) == 0 ? next : "several";
    }
    return name;
}

static bool write_means(struct run *r)
{
    double row[2 * MEANS_MOST];
    char symbol[32], error[48], text[96];
    table_begin(r->out, r->s->command, 0);
    table_print(r->out, "# model: %s\n", mean_model(r));
    for (size_t j = 0; j < r->means; ++j) {
        const struct averages_found *f = &r->mean[j].found;
        const char *unit = averages_name(&r->mean[j].quantity, symbol);
        snprintf(error, sizeof error, "error_%s", symbol);
        table_column(r->out, symbol, unit, "average");
        snprintf(text, sizeof text,
                 "two standard errors, or a bound; asked: %.4g of %.4g",
                 r->s->tolerance, f->scale);
        table_column(r->out, error, unit, text);
        row[2 * j] = f->value;
        /* In the unit of its column: f->error is a share of the scale. */
        row[2 * j + 1] = f->error * f->scale;
    }
    const bool good = table_row(r->out, 2 * r->means, row);
    return table_close(r->out) && good;
}

static void chart_means(const struct run *r, const char *refusal)
{
    write_chart_head(r, refusal);
    for (size_t j = 0; j < r->means; ++j) {
        const struct averages_found *f = &r->mean[j].found;
        if (f->way && f->cost > 0)
            table_print(r->chart, "%.6g %.6g %d %s\n\n\n", f->error,
                        f->cost, f->sure != AVERAGES_OUT, f->way);
    }
}

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
    table_real(t, "tolerance", r->s->tolerance);
    table_real(t, "error_found", most);
    table_real(t, "cost", cost);
    table_real(t, "deciding", 0);
}

/* Averages: all are found, or none is handed out. */
static bool answer_means(struct run *r, const char **refusal)
{
    bool good = true;
    for (size_t j = 0; j < r->means && !*refusal; ++j)
        *refusal = find_mean(r, &r->mean[j]);
    if (*refusal) {
        fprintf(stderr, PROGRAM ": %s: %s\n", r->s->scene, *refusal);
        table_discard(r->out);
    } else
        good = write_means(r);
    if (r->chart)
        chart_means(r, *refusal);
    summarise_means(r, *refusal);
    return good;
}

static bool answer_run(struct run *r, const char **refusal)
{
    *refusal = carry(r);
    if (r->chart)
        write_chart(r, *refusal);
    const bool good = hand_out(r, *refusal);
    summarise(r, *refusal);
    choose_free(&r->choice);
    return good;
}

int main(int argc, char *argv[])
{
    static struct settings s;
    static struct run r;
    const char *refusal = NULL;
    read_settings(&s, argc, argv);
    r.s = &s;
    begin_run(&r);
    open_outputs(&r);
    table_keys(r.summary, keys);
    bool good =
        r.means > 0 ? answer_means(&r, &refusal) : answer_run(&r, &refusal);
    good = table_close(r.chart) && good;
    good = table_close(r.summary) && good;
    scene_free(&r.scene);
    return good && !refusal ? EXIT_SUCCESS : EXIT_FAILURE;
}
