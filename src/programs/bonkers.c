/* Runs bodies on a line: writes one run, or the mean of an ensemble. */
#include "line/bonkers.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"
#include "toolbox/random.h"

#include <math.h>
#ifdef _OPENMP
#include <omp.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define PROGRAM "bonkers"

enum { LISTED = 1000 }; /* maximum number of bodies in a list */

static struct {
    struct start_request request;
    bool preset;
    size_t listed;                       /* bodies in the lists, or 0 */
    const double *mass, *x, *v, *radius; /* lists, or NULL */
    double restitution, gravity, every, until;
    uint64_t samples, collisions, members, threads;
    enum bonkers_engine engine;
    const char *output, *summary, *command;
} given = {.request.seed = 1,
           .restitution = 1,
           .members = 1,
           .until = INFINITY,
           .samples = UINT64_MAX,
           .collisions = UINT64_MAX,
           .summary = "/dev/null"};

/* --members needs a preset that draws random numbers. It excludes
   --collisions, because the members are averaged at common times, and
   --restitution, because inelastic collapse would end a member early. */
static const struct options_entry entries[] = {
    {"preset", 'p', "NAME",
     "four, mixed, cradle, thermal, piston, adiabatic,\n"
     "two, random or galperin (four)"},
    {"masses", 'm', "M1,..", "of the movers from left to right, kg"},
    {"positions", 'x', "X1,..", "of their centres, m"},
    {"velocities", 'v', "V1,..", "m/s"},
    {"radii", 'a', "A1,..", "m (0)"},
    {"walls", 'w', "L,R", "their positions, m; L alone: no right wall"},
    {"gravity", 'G', "G", "towards the left wall, the floor, m/s2 (0)"},
    {"every", 'd', "DT", "a row at each multiple of this time, s"},
    {"until", 't', "T", "stop at this time, s"},
    {"engine", 'g' | OPTIONS_SILENT, "NAME",
     "auto, naive, scan, heap or slab (auto)"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"", 0, NULL, "--preset four, thermal, piston, adiabatic, random"},
    {"particles", 'N', "N", "movers"},
    {"", 0, NULL, "--preset piston, adiabatic, two, galperin; no --masses"},
    {"mass-ratio", 'R', "R",
     "two, galperin: of the second to the first;\n"
     "piston, adiabatic: of the piston to the mean other"},
    {"", 0, NULL, "--preset thermal, piston, adiabatic, random"},
    {"ensemble", 'E', "K", "average over this many seeds"},
    {"seed", 's', "S", "of the random numbers (1)"},
    {"", 0, NULL, "--ensemble"},
    {"threads", 'j' | OPTIONS_SILENT, "N", "how many (all cores)"},
    {"", 0, NULL, "no --ensemble"},
    {"collisions", 'c', "C", "stop at this collision"},
    {"restitution", 'e', "E", "of every collision (1)"},
    {"", 0, NULL, "--every"},
    {"samples", 'k', "K", "stop after so many rows behind the first"},
    {0}};

static const struct table_key keys[] = {
    {"collisions", "1", "of all members"},
    {"samples", "1", "rows"},
    {"time", "s", "at the end"},
    {"engine", "word", "that was used"},
    {"collisions_per_second", "1/s", "of processor time"},
    {"order_violations", "1", "pairs that rounding had put out of order"},
    {"", "", "if --restitution is 1:"},
    {"energy_error", "1", "relative; of the worst member"},
    {"", "", "if it is less:"},
    {"energy_change", "1", "the same"},
    {"", "", "if --ensemble:"},
    {"members", "1", "averaged over"},
    {0}};

/* Reads a list of numbers from `low` to `high` into values[]. The first
   list determines the number of bodies. */
static const double *read_list(struct options *o, double values[],
                               double low, double high)
{
    const size_t n = options_list(o, values, LISTED);
    for (size_t i = 0; i < n; ++i)
        if (!(values[i] >= low && values[i] <= high))
            options_fail(o, "number %zu is %g, expected %g to %g", i + 1,
                         values[i], low, high);
    if (given.listed > 0 && given.listed != n)
        options_fail(o,
                     "%zu numbers found, expected %zu as in the list "
                     "before",
                     n, given.listed);
    given.listed = n;
    return values;
}

/* Reads the positions of the walls. The right wall may be missing, as in
   Galperin's problem. */
static void read_walls(struct options *o, struct start_request *w)
{
    if (options_list(o, w->wall, 2) == 1)
        w->wall[1] = INFINITY;
    if (!(w->wall[0] < w->wall[1]))
        options_fail(o, "'%s', expected the left one before the right one",
                     options_text(o));
    w->walls = true;
}

static void take_option(struct options *o, int letter)
{
    static double mass[LISTED], x[LISTED], v[LISTED], radius[LISTED];
    struct start_request *const q = &given.request;
    switch (letter) {
    case 'p':
        q->kind = (enum start_kind)options_choice(o, start_names);
        given.preset = true;
        break;
    case 'N': q->movers = options_count(o, 1, BONKERS_MOVERS); break;
    case 'm': given.mass = read_list(o, mass, 1e-100, 1e100); break;
    case 'x': given.x = read_list(o, x, -1e100, 1e100); break;
    case 'v': given.v = read_list(o, v, -1e100, 1e100); break;
    case 'a': given.radius = read_list(o, radius, 0, 1e100); break;
    case 'w': read_walls(o, q); break;
    case 'R': q->ratio = options_real(o, 1e-100, 1e100); break;
    case 's': q->seed = options_count(o, 0, UINT64_MAX); break;
    case 'e': given.restitution = options_real(o, 0, 1); break;
    case 'G': given.gravity = options_real(o, 0, 1e100); break;
    case 'd': given.every = options_positive(o, INFINITY); break;
    case 't': /* 0 writes only the start */
        given.until = options_real(o, 0, INFINITY);
        break;
    case 'k': given.samples = options_count(o, 1, UINT64_MAX - 1); break;
    case 'c': given.collisions = options_count(o, 0, UINT64_MAX - 1); break;
    case 'E': given.members = options_count(o, 2, 100000000); break;
    case 'j': given.threads = options_count(o, 1, 1024); break;
    case 'g':
        given.engine =
            (enum bonkers_engine)options_choice(o, bonkers_engine_names);
        break;
    case 'o': given.output = options_text(o); break;
    case 'S': given.summary = options_text(o); break;
    }
}

static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    options_begin(&o, PROGRAM, "Run bodies on a line between two walls.",
                  entries, argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        take_option(&o, option);
    given.command = options_command(&o);
    if (given.listed > 0) {
        options_refuse(&o, "particles", "with lists of them");
        given.request.movers = given.listed;
    }
    if (given.listed > 0 && !given.preset && !given.x)
        options_fail(&o, "lists without a preset need --positions");
    if (!(given.listed > 0 && !given.preset) &&
        !start_allows(given.request.kind, given.request.movers))
        options_fail(&o, "--particles: %s cannot have %zu movers",
                     start_names[given.request.kind], given.request.movers);
    program_apart(&o, given.output, given.summary, "table");
}

/* Creates the start from the preset and replaces its numbers by those of
   the lists. Without a preset all numbers come from the lists, and the box
   begins at 0 and ends 1 m beyond the last body, unless --walls is given.
   Returns false if there is no memory. */
static bool make_start(struct start *s, uint64_t seed)
{
    struct start_request request = given.request;
    request.seed = seed;
    const size_t size = given.listed * sizeof(double);
    if (given.preset || given.listed == 0) {
        if (!start_fill(s, &request))
            return false;
    } else if (!start_create(s, given.listed)) {
        return false;
    } else {
        s->wall[1] = given.x[given.listed - 1] + 1;
        s->until = 50;
        if (request.walls)
            memcpy(s->wall, request.wall, sizeof s->wall);
    }
    if (given.mass)
        memcpy(s->mass, given.mass, size);
    if (given.x)
        memcpy(s->x, given.x, size);
    if (given.v)
        memcpy(s->v, given.v, size);
    if (given.radius)
        memcpy(s->radius, given.radius, size);
    s->gravity = given.gravity;
    return true;
}

static void name_body(char text[], size_t size, size_t i, size_t gaps)
{
    if (i == 0 || i == gaps)
        snprintf(text, size, "the %s wall", i == 0 ? "left" : "right");
    else
        snprintf(text, size, "mover %zu", i);
}

/* Begins a run and sets *until to the default end time of this start. Ends
   the program if the start is impossible, before anything is written.
   Refuses speeds so low that their squares are subnormal, because subnormal
   numbers have fewer digits. Such speeds are accepted only for falling
   bodies, which become faster. Bodies at rest are accepted, too, because
   they never collide. */
static void begin_or_exit(struct bonkers *b, uint64_t seed, double *until)
{
    struct start s;
    size_t wrong = 0;
    program_memory(
        make_start(&s, seed) &&
            bonkers_begin(b, &s, given.restitution, given.engine, &wrong),
        "for the particles");
    if (wrong < b->gaps) {
        char left[40], right[40];
        name_body(left, sizeof left, wrong, b->gaps);
        name_body(right, sizeof right, wrong + 1, b->gaps);
        program_refuse(
            "--positions: %s and %s overlap; expected the bodies from left "
            "to right with room for their radii",
            left, right);
    }
    *until = s.until;
    start_free(&s);
    double most = 0;
    for (size_t i = 0; i <= b->gaps; ++i)
        most = fmax(most, fabs(b->body[i].v));
    if (most > 0 && most < BONKERS_SLOWEST && !(b->gravity > 0))
        program_refuse(
            "--velocities: the fastest has %g m/s, expected at least %.3g: "
            "squares of slower ones leave the range of numbers",
            most, BONKERS_SLOWEST);
}

/* A run. Between rows the engine runs in portions, short enough that a
   signal is noticed within a second. An engine can be stopped and continued
   anywhere, so the portions do not change the results. */
struct run {
    struct bonkers b;
    double until, every;
    uint64_t samples, rows; /* rows after the first: maximum; so far */
    double start_energy, seconds;
    enum bonkers_stop stop;
    bool over, timed;
    struct progress *progress; /* or NULL */
};

/* Begins a run. The run ends at the default end time of its start unless
   the command sets a limit. The clock is read only if there is a summary:
   reading it takes as long as several collisions, and an ensemble may have
   ten million rows. */
static void begin_run(struct run *r, uint64_t seed)
{
    double usual;
    *r = (struct run){.every = given.every, .samples = given.samples};
    r->timed = strcmp(given.summary, "/dev/null") != 0;
    begin_or_exit(&r->b, seed, &usual);
    const bool limited = given.until < INFINITY ||
                         given.samples < UINT64_MAX ||
                         given.collisions < UINT64_MAX;
    r->until = limited ? given.until : usual;
    r->start_energy = bonkers_energy(&r->b);
}

enum { PARTS = 1000000 };

/* Shows the fraction of the simulated time that is done. The fraction
   remains zero if the run is limited only by a number of collisions. */
static void show_progress(const struct run *r)
{
    const double end = fmin(r->until, r->samples < UINT64_MAX
                                          ? (double)r->samples * r->every
                                          : INFINITY);
    const double fraction = end < INFINITY ? r->b.now / end : 0;
    progress_update(r->progress, (uint64_t)(fraction * PARTS),
                    r->b.collisions);
}

/* Runs until `until` or `collisions`, whichever comes first. Divides the
   run into portions that take less than a second even on a slow computer.
   The portions of naive and scan are smaller, because these engines examine
   every gap at each collision. The term 4 * gaps makes the portions of the
   other engines longer than many slabs.

   Slabs can stop at a time at no cost. To stop at a collision, they must
   undo the last slab and let the heap run it again. Therefore, once the
   collision rate is known, a portion of slabs ends at an estimated time and
   is limited to twice the usual number of collisions. After a portion
   without a collision the next portion has no time limit. Only then can the
   engine find out that there will never be another collision.

   The comparison with `most` is written as a difference, which cannot
   overflow when there is no limit. */
static enum bonkers_stop run_portions(struct run *r, double until,
                                      uint64_t collisions)
{
    struct bonkers *b = &r->b;
    const bool reads_all =
        b->engine == BONKERS_NAIVE || b->engine == BONKERS_SCAN;
    const uint64_t portion = reads_all ? 100000000 / b->gaps + 1
                                       : 1000000 + 4 * (uint64_t)b->gaps;
    enum bonkers_stop stop;
    double pause;
    uint64_t before = 0;
    const clock_t start = r->timed ? clock() : 0;
    do {
        const bool timed_portion =
            b->engine == BONKERS_SLAB && b->collisions > before;
        const uint64_t most = timed_portion ? 2 * portion : portion;
        const uint64_t next = collisions - b->collisions > most
                                  ? b->collisions + most
                                  : collisions;
        before = b->collisions;
        pause = timed_portion
                    ? fmin(until,
                           b->now * (1 + (double)portion / (double)before))
                    : until;
        stop = bonkers_run(b, pause, next);
        if (r->progress)
            show_progress(r);
    } while ((stop == BONKERS_COLLISIONS ||
              (stop == BONKERS_TIME && pause < until)) &&
             b->collisions < collisions && !progress_signal());
    if (r->timed)
        r->seconds += (double)(clock() - start) / CLOCKS_PER_SEC;
    return stop;
}

/* Runs to the next row. Sets r->over if it is the last row. The time of a
   row is a product, not a sum (2.4, eq:clock). If rounding separates the
   last row from the end of the run, the row is moved to the end. A run that
   is limited only by a number of collisions also ends when there will be no
   more collisions, because otherwise it would write rows forever. */
static void run_to_row(struct run *r, uint64_t collisions)
{
    const double clock =
        r->every > 0 ? (double)(r->rows + 1) * r->every : INFINITY;
    const bool last = clock >= r->until - 1e-9 * r->every;
    r->stop = run_portions(r, last ? r->until : clock, collisions);
    ++r->rows;
    r->over = last || r->stop != BONKERS_TIME || r->rows == r->samples ||
              (r->until == INFINITY && r->samples == UINT64_MAX &&
               bonkers_is_still(&r->b)) ||
              progress_signal();
}

/* Describes the columns, `per` columns for each body. The walls have the
   letters L and R instead of numbers. */
static void name_columns(struct table *out, const struct bonkers *b,
                         const char *const symbols[],
                         const char *const units[],
                         const char *const words[], size_t per)
{
    const size_t gaps = b->gaps;
    TABLE_COLUMNS(out, {"t", "s", "time"},
                  {"energy", "J",
                   b->gravity > 0 && per == 2
                       ? "energy of the movers, kinetic and potential"
                       : "kinetic energy of the movers"});
    for (size_t i = 0; i <= gaps; ++i)
        for (size_t k = 0; k < per; ++k) {
            char symbol[32], meaning[64], whose[40];
            name_body(whose, sizeof whose, i, gaps);
            if (i == 0 || i == gaps)
                snprintf(symbol, sizeof symbol, "%s%c", symbols[k],
                         i == 0 ? 'L' : 'R');
            else
                snprintf(symbol, sizeof symbol, "%s%zu", symbols[k], i);
            snprintf(meaning, sizeof meaning, "%s of %s", words[k], whose);
            table_column(out, symbol, units[k], meaning);
        }
}

/* Writes the masses into the table head, because energies cannot be
   computed from velocities alone. Omits them if there are more than LISTED.
   A body stores 1/m, and 1/(1/m) is off by a bit or two. Therefore each
   mass is written with as few digits as reproduce 1/m exactly; otherwise
   --masses 49 would be written as 49.000000000000007. */
static void name_masses(struct table *out, const struct bonkers *b)
{
    if (b->gaps > LISTED)
        return;
    table_print(out, "# masses:");
    for (size_t i = 1; i < b->gaps; ++i) {
        char text[32];
        int digits = 15;
        do {
            snprintf(text, sizeof text, "%.*g", digits, 1 / b->body[i].im);
        } while (1 / strtod(text, NULL) != b->body[i].im && ++digits <= 17);
        table_print(out, " %s", text);
    }
    table_print(out, "\n");
}

/* Writes a row with the position and velocity of each body side by side.
   `row` has space for 2 + 3 * bodies numbers. The engine writes all
   positions into the second half of the row, followed by the velocities.
   Each position is moved to its column before that place is overwritten. */
static void write_row(struct table *out, struct bonkers *b, double row[])
{
    double *x = row + 2 + b->gaps + 1, *v = x + b->gaps + 1;
    bonkers_state(b, x, v);
    row[0] = b->now;
    row[1] = bonkers_energy(b);
    for (size_t i = 0; i <= b->gaps; ++i) {
        row[2 + 2 * i] = x[i];
        row[3 + 2 * i] = v[i];
    }
    table_row(out, 2 + 2 * (b->gaps + 1), row);
}

static bool write_run(struct table *out, struct run *r)
{
    double *row = malloc((2 + 3 * (r->b.gaps + 1)) * sizeof *row);
    if (!row) {
        program_say("no memory for a row");
        return false;
    }
    name_masses(out, &r->b);
    name_columns(out, &r->b, (const char *const[]){"x", "v"},
                 (const char *const[]){"m", "m/s"},
                 (const char *const[]){"position", "velocity"}, 2);
    write_row(out, &r->b, row);
    while (!r->over) {
        run_to_row(r, given.collisions);
        write_row(out, &r->b, row);
    }
    free(row);
    return true;
}

/* Number of members in a batch. Members of an ensemble differ only in their
   seeds, and each processor core runs its own member. Floating-point sums
   depend on the order of their terms, but the mean must not depend on the
   number of cores. Therefore the cores fill a batch of fixed size, and then
   one core sums it in the order of the members. */
enum { BATCH = 16 };

/* Statistics over the members. For each row and body, `mean` has four
   numbers: the sums of x and of v, the mean of the kinetic energy T, and
   the sum of the squared deviations of T. `batch` has three: x, v and T. */
struct ensemble {
    size_t rows, bodies;
    uint64_t members;
    double *time, *mean;   /* [rows]; [rows * bodies * 4] */
    double *batch[BATCH];  /* [rows * bodies * 3] each */
    struct run run[BATCH]; /* members of the current batch */
};

/* Runs one member and stores its rows in its own part of the batch, so no
   core waits for another. */
static void run_member(struct ensemble *e, int place, uint64_t seed)
{
    struct run *r = &e->run[place];
    double *x = malloc(2 * e->bodies * sizeof *x), *v = x + e->bodies;
    begin_run(r, seed);
    for (size_t row = 0; x && row < e->rows; ++row) {
        double *to = e->batch[place] + 3 * e->bodies * row;
        if (row > 0)
            run_to_row(r, UINT64_MAX);
        bonkers_state(&r->b, x, v);
        for (size_t i = 0; i < e->bodies; ++i, to += 3) {
            const double im = r->b.body[i].im;
            to[0] = x[i];
            to[1] = v[i];
            to[2] = im > 0 ? v[i] * v[i] / im / 2 : 0;
        }
        if (place == 0) /* all members have the same times */
            e->time[row] = r->b.now;
    }
    free(x);
}

/* Adds a member to the means. Squared deviations are summed by Welford's
   rule, which never subtracts two large numbers: with the mean M_k of the
   first k values, the sum grows by (T_k - M_(k-1)) (T_k - M_k). */
static void add_member(struct ensemble *e, int place)
{
    const double k = (double)++e->members;
    const size_t entries = e->rows * e->bodies;
    for (size_t i = 0; i < entries; ++i) {
        const double *of = e->batch[place] + 3 * i;
        double *to = e->mean + 4 * i;
        const double deviation = of[2] - to[2];
        to[0] += of[0];
        to[1] += of[1];
        to[2] += deviation / k;
        to[3] += deviation * (of[2] - to[2]);
    }
}

/* Runs `count` members in parallel, then adds them to the means in order.
   Returns the number of members added, which is 0 after a signal, because
   some members may be incomplete. */
static int run_batch(struct ensemble *e, const uint64_t seeds[], int count)
{
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (int place = 0; place < count; ++place)
        run_member(e, place, seeds[place]);
    const int added = progress_signal() ? 0 : count;
    for (int place = 0; place < added; ++place)
        add_member(e, place);
    return added;
}

/* Allocates an ensemble. All members have the same number of rows, which is
   computed from the settings of r. Returns false if the rows do not fit
   into memory. */
static bool make_ensemble(struct ensemble *e, const struct run *r)
{
    const double until = fmin(r->until, r->samples < UINT64_MAX
                                            ? (double)r->samples * r->every
                                            : INFINITY);
    const double rows = r->every > 0 ? ceil(until / r->every - 1e-9) : 1;
    if (!(rows < 1e9))
        return false;
    *e = (struct ensemble){.rows = (size_t)rows + 1,
                           .bodies = r->b.gaps + 1};
    const size_t entries = e->rows * e->bodies;
    bool enough = (e->time = malloc(e->rows * sizeof *e->time)) &&
                  (e->mean = calloc(4 * entries, sizeof *e->mean));
    for (int place = 0; place < BATCH; ++place)
        enough = enough &&
                 (e->batch[place] = malloc(3 * entries * sizeof(double)));
    return enough;
}

/* Writes the rows of an ensemble. The standard error of the mean of T is
   sqrt(S / (k - 1) / k), where S is the sum of the squared deviations of T
   over k members. */
static void write_ensemble(struct table *out, const struct ensemble *e,
                           double row[])
{
    const double k = (double)e->members;
    for (size_t n = 0; n < e->rows; ++n) {
        const double *mean = e->mean + 4 * n * e->bodies;
        row[0] = e->time[n];
        row[1] = 0;
        for (size_t i = 0; i < e->bodies; ++i, mean += 4) {
            double *to = row + 2 + 4 * i;
            to[0] = mean[0] / k;
            to[1] = mean[1] / k;
            row[1] += to[2] = mean[2];
            to[3] = sqrt(mean[3] / (k - 1) / k);
        }
        table_row(out, 2 + 4 * e->bodies, row);
    }
}

/* Totals over all members of an ensemble. `energy_error` is the largest
   error of any member. */
struct totals {
    uint64_t collisions, disorder, rows;
    double time, seconds, energy_error;
};

static void add_run(struct totals *t, const struct run *r)
{
    const double energy = bonkers_energy(&r->b);
    const double error =
        r->start_energy > 0 ? energy / r->start_energy - 1 : 0;
    t->collisions += r->b.collisions;
    t->disorder += r->b.disorder;
    t->rows = r->rows;
    t->time = r->b.now;
    t->seconds += r->seconds;
    if (fabs(error) > fabs(t->energy_error))
        t->energy_error = error;
}

/* Writes the summary. If collisions lose energy, the energy change is not
   an error, so its key is energy_change. */
static void write_summary(struct table *out, const struct totals *t,
                          enum bonkers_engine engine)
{
    table_count(out, "collisions", t->collisions);
    table_count(out, "samples", t->rows);
    TABLE_RESULTS(out, {"time", t->time},
                  {given.restitution < 1 ? "energy_change" : "energy_error",
                   t->energy_error});
    table_text(out, "engine", bonkers_engine_names[engine]);
    table_real(out, "collisions_per_second",
               t->seconds > 0 ? (double)t->collisions / t->seconds : 0);
    table_count(out, "order_violations", t->disorder);
    if (given.members > 1)
        table_count(out, "members", given.members);
}

/* Runs the members in batches and writes the averaged rows. The seeds are
   drawn in order, so a longer ensemble starts with the members of a shorter
   one. Returns false after an interruption. */
static bool run_ensemble(struct table *out, struct ensemble *e,
                         struct totals *t, struct progress *p)
{
    struct random r;
    double *row = malloc((2 + 4 * e->bodies) * sizeof *row);
    uint64_t seeds[BATCH];
    int done = BATCH;
    random_seed(&r, given.request.seed);
    for (uint64_t k = 0; row && k < given.members && done > 0; k += BATCH) {
        const uint64_t left = given.members - k;
        const int count = left < BATCH ? (int)left : BATCH;
        for (int i = 0; i < count; ++i)
            seeds[i] = random_bits(&r);
        done = run_batch(e, seeds, count);
        for (int i = 0; i < done; ++i)
            add_run(t, &e->run[i]);
        for (int i = 0; i < count; ++i)
            bonkers_free(&e->run[i].b);
        progress_update(p, k + (uint64_t)done, t->collisions);
    }
    if (row && e->members > 1)
        write_ensemble(out, e, row);
    free(row);
    return done > 0;
}

/* Creates, runs, writes and frees an ensemble. Returns whether it is
   complete. */
static bool average_ensemble(struct table *out, const struct run *first,
                             struct totals *t, struct progress *p)
{
    static struct ensemble e;
    bool done = make_ensemble(&e, first);
    if (!done)
        program_say("no memory for the rows; use fewer");
    if (done) {
        name_masses(out, &first->b);
        name_columns(out, &first->b,
                     (const char *const[]){"x", "v", "T", "s"},
                     (const char *const[]){"m", "m/s", "J", "J"},
                     (const char *const[]){"mean position", "mean velocity",
                                           "mean kinetic energy",
                                           "standard error of T"},
                     4);
        done = run_ensemble(out, &e, t, p);
    }
    for (int place = 0; place < BATCH; ++place)
        free(e.batch[place]);
    free(e.mean);
    free(e.time);
    return done;
}

/* If a run could not continue to its end, reports this and returns true.
   The program then exits with a failure. The table is kept, because it is
   correct as far as it goes. */
static bool say_collapse(const struct run *r)
{
    const bool cold = r->stop == BONKERS_COLLAPSE && bonkers_is_cold(&r->b);
    const bool late = r->stop == BONKERS_STILL && !bonkers_is_still(&r->b);
    if (r->stop != BONKERS_COLLAPSE && !late)
        return false;
    program_say("%s at t = %.6g s after %llu collisions",
                late ? "the next collision is later than any number"
                : cold
                    ? "too cold to go on: squares of the speeds leave the "
                      "range of numbers"
                    : "inelastic collapse",
                r->b.now, (unsigned long long)r->b.collisions);
    return true;
}

/* Ends the program if the run would have more than 9e15 rows, which a
   double cannot count. If the run has no end time, counts the rows up to
   the first collision. */
static void check_rows(const struct run *r)
{
    double end = r->until;
    for (size_t i = 0; r->until == INFINITY && i < r->b.gaps; ++i)
        end = fmin(end, r->b.due[i]);
    if (r->every == 0 || r->samples < UINT64_MAX ||
        !(end < INFINITY && end / r->every > 9e15))
        return;
    program_refuse("--every: %g s makes more than 9e15 rows in %g s; use a "
                   "longer time, or --samples",
                   r->every, end);
}

/* Runs bonkers. Even for an ensemble it begins a single run, to check the
   start and to find the number of rows. */
int main(int argc, char *argv[])
{
    struct run r;
    struct totals t = {0};
    struct progress p;
    read_settings(argc, argv);
    begin_run(&r, given.request.seed);
    check_rows(&r);
    struct table *out, *summary;
    program_open(given.output, given.summary, keys, &out, &summary);
#ifdef _OPENMP
    if (given.threads > 0)
        omp_set_num_threads((int)given.threads);
#endif
    table_begin(out, given.command, given.request.seed);
    progress_begin(&p, PROGRAM, given.members > 1 ? given.members : PARTS,
                   "collisions");
    r.progress = &p;
    const bool done = given.members > 1 ? average_ensemble(out, &r, &t, &p)
                                        : write_run(out, &r);
    if (given.members == 1)
        add_run(&t, &r);
    const bool complete = progress_end(&p) && done;
    const bool collapsed = given.members == 1 && say_collapse(&r);
    write_summary(summary, &t, r.b.engine);
    bonkers_free(&r.b);
    const int status = program_close(out, summary, complete);
    return collapsed ? EXIT_FAILURE : status;
}
