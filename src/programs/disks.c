/* Simulates and measures hard disks or spheres in a box. */
#include "box/blocks.h"
#include "box/cells.h"
#include "box/disks.h"
#include "box/speeds.h"
#include "box/states.h"
#include "toolbox/bench.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "disks"

enum {
    NO_BOUNDARY = DISKS_BOUNDARIES, /* no --boundary */
    PARTS = 1000000                 /* units of progress in a run */
};

/* Settings from the command line. An option that was not given is 0, NULL
   or NaN, unless a default is set below. */
static struct {
    size_t disks, dimensions, axes; /* axes: how many numbers --box has */
    size_t boundary, engine, measure;
    double radius, packing, box[DISKS_AXES];
    double heavy[2]; /* mass, kg; radius, m */
    double speed, temperature, restitution, gravity;
    const char *species, *start;
    double warmup, until, every;
    uint64_t collisions, samples, seed;
    const char *output, *summary, *command;
} given = {.dimensions = 2,
           .boundary = NO_BOUNDARY,
           .restitution = 1,
           .start = "lattice",
           .warmup = NAN,
           .until = INFINITY,
           .collisions = UINT64_MAX,
           .samples = UINT64_MAX,
           .seed = 1,
           .summary = "/dev/null"};

/* Returns whether the start is read from a file. All names other than
   "lattice" and "random" are names of files. */
static bool starts_from_file(void)
{
    return strcmp(given.start, "lattice") != 0 &&
           strcmp(given.start, "random") != 0;
}

static const char *const engine_names[] = {"auto", "pairs", "cells", NULL};
enum { AUTO, PAIRS, CELLS };
enum { STATES, POSITIONS, SPEED_LAW, PRESSURE, RELAXATION, BROWNIAN };
static const char *const measure_names[] = {
    "states",     "positions", "speeds", "pressure",
    "relaxation", "brownian",  NULL};

static void read_heavy(struct options *o, double heavy[2])
{
    if (options_list(o, heavy, 2) != 2 ||
        !(heavy[0] > 0 && heavy[1] > 0 && fmax(heavy[0], heavy[1]) < 1e100))
        options_fail(o, "'%s' is not a mass and a radius", options_text(o));
}

static void make_sums(struct blocks *b, size_t width)
{
    program_memory(blocks_create(b, width), "for the sums");
}

enum { KINDS = 100 };

/* The kinds of disks. Disks of the same kind have consecutive numbers.
   Usually there is one kind. A heavy disk is a separate kind and comes
   first. */
struct mixture {
    size_t kinds, total;
    struct {
        size_t count;
        double mass, radius;
    } kind[KINDS];
};

/* Adds a kind. Returns false if the numbers, which may come from a file,
   are invalid. */
static bool add_kind(struct mixture *m, double count, double mass,
                     double radius)
{
    if (m->kinds == KINDS || !(count >= 1 && count <= DISKS_MOST) ||
        count != floor(count) || !(mass > 0 && mass < 1e100) ||
        !(radius >= 0 && radius < 1e100))
        return false;
    m->kind[m->kinds].count = (size_t)count;
    m->kind[m->kinds].mass = mass;
    m->kind[m->kinds++].radius = radius;
    m->total += (size_t)count;
    return m->total <= DISKS_MOST;
}

/* Reads a file of kinds, three numbers per line. A # starts a comment. */
static void read_kinds(struct mixture *m, const char *path)
{
    FILE *file = fopen(path, "r");
    char line[256];
    if (!file)
        program_refuse("--species: %s: %s", path, strerror(errno));
    for (size_t number = 1; fgets(line, sizeof line, file); ++number) {
        double count, mass, radius;
        char more;
        line[strcspn(line, "#\n")] = '\0';
        const int found =
            sscanf(line, "%lf %lf %lf %c", &count, &mass, &radius, &more);
        if (found > 0 && (found != 3 || !add_kind(m, count, mass, radius)))
            program_refuse("--species: %s:%zu: '%s', expected a line of "
                           "count, mass and radius",
                           path, number, line);
    }
    fclose(file);
}

/* Returns the side of a square of area `size` or of a cube of volume
   `size`. Uses Newton's method, whose rounded result, unlike that of
   cbrt(), is the same on all machines. It starts above the root and ends
   when it no longer descends. */
static double side_of(double size, size_t dimensions)
{
    if (dimensions == 2)
        return sqrt(size);
    double x = fmax(1, size), next = x;
    do {
        x = next;
        next = x - (x - size / (x * x)) / 3;
    } while (next < x);
    return x;
}

/* Sets the box. Any two of packing, radius and box determine the third. The
   box is first set to size 1, so that disks_packing is the total area or
   volume of the disks. */
static void choose_box(struct disks *d)
{
    for (size_t k = 0; k < d->dimensions; ++k)
        d->box[k] = given.axes ? given.box[k] : 1;
    if (given.packing == 0 || given.axes > 0)
        return;
    const double side =
        side_of(disks_packing(d) / given.packing, d->dimensions);
    for (size_t k = 0; k < d->dimensions; ++k)
        d->box[k] = side;
}

/* Returns the radius. If the packing and the box determine the radius, the
   area or volume of the heavy disk is subtracted first. */
static double choose_radius(void)
{
    const double pi = 3.14159265358979324;
    const double R = given.heavy[1],
                 unit = given.dimensions == 2 ? pi : 4 * pi / 3;
    double room = given.packing;
    if (given.radius > 0 || given.packing == 0)
        return given.radius > 0 ? given.radius : 0.15;
    if (given.axes == 0)
        return 0.5;
    for (size_t k = 0; k < given.dimensions; ++k)
        room *= given.box[k];
    room -= unit * R * R * (given.dimensions == 2 ? 1 : R);
    if (!(room > 0))
        program_refuse("--packing: %g is filled by the heavy disk alone",
                       given.packing);
    return side_of(room / unit / (double)given.disks, given.dimensions);
}

/* Creates the disks of all kinds and sets the box. */
static void fill_box(struct disks *d)
{
    struct mixture m = {0};
    if (given.heavy[0] > 0)
        add_kind(&m, 1, given.heavy[0], given.heavy[1]);
    if (given.species)
        read_kinds(&m, given.species);
    else
        add_kind(&m, (double)given.disks, 1, choose_radius());
    if (m.total == 0)
        program_refuse("--species: %s has no line", given.species);
    program_memory(disks_create(d, given.dimensions, m.total),
                   "for the disks");
    for (size_t kind = 0, i = 0; kind < m.kinds; ++kind)
        for (size_t n = 0; n < m.kind[kind].count; ++n, ++i) {
            d->mass[i] = m.kind[kind].mass;
            d->disk[i].radius = m.kind[kind].radius;
        }
    choose_box(d);
}

/* Draws velocities. Random velocities have a random temperature, so they
   are rescaled to --temperature. */
static void set_velocities(struct disks *d, struct random *r)
{
    if (given.temperature == 0) {
        disks_set_speed(d, given.speed, r);
        return;
    }
    disks_set_temperature(d, given.temperature, r);
    const double factor = sqrt(given.temperature / disks_temperature(d));
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < d->dimensions; ++k)
            d->disk[i].velocity[k] *= factor;
}

/* Returns the largest radius, m. */
static double widest(const struct disks *d)
{
    double most = 0;
    for (size_t i = 0; i < d->count; ++i)
        most = fmax(most, d->disk[i].radius);
    return most;
}

/* Creates a start. Draws the positions and then the velocities from one
   seed. */
static void make_start(struct disks *d)
{
    struct random r;
    random_seed(&r, given.seed);
    fill_box(d);
    d->boundary = given.boundary == NO_BOUNDARY
                      ? DISKS_WALLS
                      : (enum disks_boundary)given.boundary;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_walled(d, k) && d->box[k] < 2 * widest(d))
            program_refuse("--box: a side of %.10g has no room between its "
                           "walls for a radius of %.10g",
                           d->box[k], widest(d));
    const bool lattice = strcmp(given.start, "lattice") == 0;
    if (!lattice && d->count > DISKS_RANDOM)
        program_refuse("--start: random places %d disks at most, not %zu",
                       DISKS_RANDOM, d->count);
    if (d->boundary == DISKS_PERIODIC && d->count < 2)
        program_refuse("--disks: a periodic box needs two at least");
    if (!(lattice ? disks_place_lattice(d) : disks_place_random(d, &r)))
        program_refuse(
            "--start: %zu disks that fill %.4g of the box find no place %s",
            d->count, disks_packing(d),
            lattice ? "on a lattice" : "at random");
    set_velocities(d, &r);
}

/* Reads a start and its box from a file. --box and --boundary override
   those of the file. */
static void read_start(struct disks *d)
{
    char message[STATES_MESSAGE];
    if (!states_read(d, given.start, message))
        program_refuse("--start: %s", message);
    if (given.axes > 0 && given.axes != d->dimensions)
        program_refuse(
            "--box has %zu sides, the disks of %s have %zu coordinates",
            given.axes, given.start, d->dimensions);
    if (given.axes > 0)
        memcpy(d->box, given.box, given.axes * sizeof d->box[0]);
    if (given.boundary != NO_BOUNDARY)
        d->boundary = (enum disks_boundary)given.boundary;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (!(d->box[k] > 0))
            program_refuse("--start: %s has no head like '# box 7.5 5 "
                           "walls', and there is no --box",
                           given.start);
}

/* A run: the disks, the engine that moves them, the sums for the pressure,
   and the progress of sampling. */
struct run {
    struct disks d;
    struct cells cells; /* engine if fast */
    bool fast;          /* use cells instead of all pairs */
    struct table *out;
    double kT, energy;         /* initial values, J */
    double common[DISKS_AXES]; /* velocity of the centre of mass, m/s */
    double begin;              /* start of the run, s */
    double piece;              /* initial averaging interval, s */
    double until;              /* end of the run, s */
    struct blocks pressure;
    double impulse[DISKS_AXES], virial; /* before this interval */
    uint64_t row, rows; /* index of the sampling time; samples taken */
    double seconds;
    enum disks_stop stop;
    struct progress progress;
    double drift; /* largest drift of an average, in standard errors */
    const char *drifting; /* average with the largest drift */
};

/* Up to FEW disks, examining all pairs is as fast as using cells. */
enum { FEW = 16 };

/* Chooses the engine. Cells are slower for few disks and do not fit into a
   small periodic box. Both engines give identical results, so tables do not
   name the engine. */
static void choose_engine(struct run *r)
{
    const bool suit = cells_suit(&r->d);
    if (given.engine == CELLS && !suit)
        program_refuse(
            "--engine: cells need a larger box, three cells wide");
    r->fast = suit && (given.engine == CELLS ||
                       (given.engine == AUTO && r->d.count > FEW));
}

/* Prepares the engine for the current state. Must be called again whenever
   the state has been changed by anything other than the engine. */
static void plan(struct run *r)
{
    cells_free(&r->cells);
    program_memory(r->fast ? cells_create(&r->cells, &r->d)
                           : disks_plan(&r->d),
                   "for the events");
}

/* Runs until `until` or `collisions`. Cells stop earlier only if there is
   no memory for longer neighbour lists. */
static enum disks_stop advance(struct run *r, double until,
                               uint64_t collisions)
{
    const enum disks_stop stop =
        r->fast ? cells_run(&r->cells, until, collisions)
                : disks_run(&r->d, until, collisions);
    if (stop == DISKS_COLLISIONS && r->d.collisions < collisions)
        program_give_up("no memory for the neighbours");
    return stop;
}

static double shortest(const struct disks *d)
{
    double least = d->box[0];
    for (size_t k = 1; k < d->dimensions; ++k)
        least = fmin(least, d->box[k]);
    return least;
}

/* Returns the initial averaging interval (in s) for the pressure: about the
   time between two collisions in the box. The intervals become longer when
   blocks are joined. */
static double first_piece(const struct disks *d)
{
    double mass = 0;
    for (size_t i = 0; i < d->count; ++i)
        mass += d->mass[i];
    const double speed = sqrt(2 * disks_heat(d) / mass);
    return shortest(d) / speed / (double)d->count;
}

/* Returns the time (in s) at which the current averaging interval ends. The
   division into intervals does not affect the results. If disks lose
   energy, no pressure is measured, and the intervals become longer as the
   disks slow down, because the time between collisions may double each
   time. If the disks are at rest, the interval is infinite. */
static double end_of_piece(const struct run *r)
{
    const size_t per = r->pressure.per;
    if (given.restitution == 1)
        return r->begin +
               (double)((r->pressure.count + 1) * per) * r->piece;
    return r->d.now + (double)(1000 + r->d.count) * first_piece(&r->d);
}

/* Runs until `until` or `collisions`, one averaging interval at a time. At
   the end of each, appends two results to the blocks: the momentum
   transferred to the walls along each axis, and the virial. Progress is
   shown as a fraction of the time or, if there is no time limit, of the
   collisions. */
static void run_to(struct run *r, double until, uint64_t collisions)
{
    const double start = bench_seconds();
    r->stop = DISKS_TIME;
    while (r->stop == DISKS_TIME && r->d.now < until &&
           !progress_signal()) {
        const double end = end_of_piece(r);
        r->stop = advance(r, fmin(end, until), collisions);
        if (r->stop == DISKS_TIME && end <= until) {
            double sample[DISKS_AXES + 1];
            for (size_t k = 0; k < DISKS_AXES; ++k) {
                sample[k] = r->d.impulse[k] - r->impulse[k];
                r->impulse[k] = r->d.impulse[k];
            }
            sample[DISKS_AXES] = r->d.virial - r->virial;
            r->virial = r->d.virial;
            blocks_append(&r->pressure, sample);
        }
        if (r->stop == DISKS_TIME && fmin(end, until) == INFINITY)
            r->stop = DISKS_COLLAPSE;
        if (r->until < INFINITY)
            progress_update(&r->progress,
                            (uint64_t)((r->d.now - r->begin) /
                                       (r->until - r->begin) * PARTS),
                            r->d.collisions);
        else if (collisions < UINT64_MAX)
            progress_update(&r->progress,
                            (uint64_t)((double)r->d.collisions /
                                       (double)collisions * PARTS),
                            r->d.collisions);
    }
    r->seconds += bench_seconds() - start;
}

/* Stores the drift of an average if it is the largest so far. report_drift
   reports it if the run was not steady. */
static void watch_drift(struct run *r, const char *of, double drift)
{
    if (r->drifting && !(fabs(drift) > fabs(r->drift)))
        return;
    r->drift = drift;
    r->drifting = isnan(drift) ? NULL : of;
}

/* Returns whether collisions can be expected. A disk that crosses the box
   hits each other disk with a probability of about (4r/L)^(D-1). Collisions
   are not expected if the average disk would cross the box more than 1e9
   times before a collision. */
static bool can_meet(const struct disks *d)
{
    const double across = 4 * widest(d) / shortest(d);
    const double fraction = d->dimensions == 2 ? across : across * across;
    return fraction * (double)(d->count - 1) > 1e-9 && disks_heat(d) > 0;
}

/* Runs until each disk has had `each` collisions on average and then a
   little longer, so that the run does not start at a collision. Sets all
   counts to zero. Runs in slices, so a signal is noticed even if collisions
   are rare. */
static void warm_up(struct run *r, double each)
{
    const double count = (double)r->d.count;
    const uint64_t last = (uint64_t)(each * count / 2);
    if (last == 0 || !can_meet(&r->d))
        return;
    plan(r);
    const double slice = 1000 * first_piece(&r->d);
    while (r->d.collisions < last && !progress_signal() &&
           r->stop != DISKS_COLLAPSE) {
        const uint64_t portion = r->d.collisions + 1000 + r->d.count;
        r->stop =
            advance(r, r->d.now + slice, portion < last ? portion : last);
    }
    if (r->stop != DISKS_COLLAPSE)
        advance(r, r->d.now * 1.01, UINT64_MAX);
    disks_settle(&r->d);
}

/* Prepares the engine and the sums after the warm-up. */
static void begin_run(struct run *r)
{
    make_sums(&r->pressure, DISKS_AXES + 1);
    plan(r);
    r->kT = disks_temperature(&r->d);
    disks_drift(&r->d, r->common);
    r->energy = disks_energy(&r->d);
    r->begin = r->d.now;
    r->piece = first_piece(&r->d);
}

/* Returns P V/(N kT) from the impulse on the two walls normal to axis k
   during `time`. Each has the area (or, in the plane, the length) V/L. */
static double Z_wall(const struct run *r, size_t k, double impulse,
                     double time)
{
    return impulse * r->d.box[k] / (2 * time * (double)r->d.count * r->kT);
}

/* Returns P V/(N kT) from the virial (7.5, eq:virial). This is the result
   in a periodic box. With walls, it is the mean of Z_wall (1 - 2R/L),
   because the centres stay a radius away from the walls (7.6,
   eq:gas-walls). */
static double Z_virial(const struct run *r, double virial, double time)
{
    return 1 +
           virial / ((double)(r->d.dimensions * r->d.count) * r->kT * time);
}

/* The measurements. Each has a function begin_ that is called before the
   run and a function sample_ that is called at each sampling time. Some
   also have a function end_ that is called after the run. */
static void begin_states(struct run *r)
{
    states_begin(r->out, &r->d);
}

static void sample_states(struct run *r)
{
    if (r->rows > 0)
        table_print(r->out, "\n\n");
    states_write(r->out, &r->d);
}

enum { BINS = 100 };

static const char *const axis_names[] = {"x", "y", "z"};

static struct blocks counted; /* positions or speeds */

/* Begins the table of positions, with BINS bins along each axis. The
   integral of each density over the box is 1. */
static void begin_positions(struct run *r)
{
    make_sums(&counted, r->d.dimensions * BINS);
    table_column(r->out, "x", "m", "lower end of the bin along x");
    for (size_t k = 0; k < r->d.dimensions; ++k) {
        char symbol[16], error[16];
        snprintf(symbol, sizeof symbol, "p(%s)", axis_names[k]);
        snprintf(error, sizeof error, "error(%s)", axis_names[k]);
        TABLE_COLUMNS(r->out,
                      {symbol, "1/m", "density of the disks' centres"},
                      {error, "1/m", "its standard error"});
    }
}

/* Counts the positions in bins. A position that is outside the box because
   of rounding is counted in the first or last bin. */
static void sample_positions(struct run *r)
{
    static double sample[DISKS_AXES * BINS];
    const struct disks *d = &r->d;
    memset(sample, 0, sizeof sample);
    for (size_t i = 0; i < d->count; ++i) {
        double place[DISKS_AXES];
        disks_position(d, i, place);
        disks_fold(d, place);
        for (size_t k = 0; k < d->dimensions; ++k) {
            const double fraction = place[k] / d->box[k] * BINS;
            const size_t bin = fraction > 0 ? (size_t)fraction : 0;
            sample[k * BINS + (bin < BINS ? bin : BINS - 1)] +=
                BINS / d->box[k] / (double)d->count;
        }
    }
    blocks_add(&counted, sample);
}

/* Writes the distribution of positions. The first column is the lower end
   of the bin along x. Along the other axes the bin has the same fraction of
   the box. */
static void end_positions(struct run *r, struct table *summary)
{
    (void)summary;
    for (size_t bin = 0; bin < BINS; ++bin) {
        double row[1 + 2 * DISKS_AXES] = {r->d.box[0] * (double)bin / BINS};
        for (size_t k = 0; k < r->d.dimensions; ++k) {
            const struct blocks_average p =
                blocks_average(&counted, k * BINS + bin);
            row[1 + 2 * k] = p.mean;
            row[2 + 2 * k] = p.error;
        }
        table_row(r->out, 1 + 2 * r->d.dimensions, row);
    }
}

/* Number of bins of the scaled speed from 0 to 4. With 42 bins the speed 1,
   at which MPPhys's gas starts, is in the middle of a bin. */
enum { SPEEDS = 42 };

static double edge_of(size_t bin)
{
    return (double)bin * 4 / SPEEDS;
}

static size_t bin_of(double u)
{
    const double bin = u * (SPEEDS / 4.0);
    return bin < SPEEDS ? (size_t)bin : SPEEDS;
}

/* Returns the speed of disk i in units of sqrt(2kT/m), where m is its mass.
   Sets parts[] to the absolute values of the components. */
static double scaled_speed(const struct run *r, size_t i, double parts[])
{
    const double *v = r->d.disk[i].velocity;
    const double scale = sqrt(r->d.mass[i] / (2 * r->kT));
    double square = 0;
    for (size_t k = 0; k < r->d.dimensions; ++k) {
        parts[k] = fabs(v[k] - r->common[k]) * scale;
        square += parts[k] * parts[k];
    }
    return sqrt(square);
}

/* Begins the table of speeds. A sample consists of the distributions of the
   scaled speed u and of a component's absolute value, and the means of u
   and u^4. */
static void begin_speeds(struct run *r)
{
    make_sums(&counted, 2 * SPEEDS + 2);
    TABLE_COLUMNS(r->out, {"u", "", "lower end of a bin, v sqrt(m/(2kT))"},
                  {"p(u)", "", "density of the speed"},
                  {"error", "", "its standard error"},
                  {"finite", "", "exact law of so many disks"},
                  {"Maxwell", "", "law of infinitely many"},
                  {"p(|ux|)", "", "density of a component's modulus"},
                  {"error", "", "its standard error"},
                  {"finite", "", "exact law of so many disks"},
                  {"Maxwell", "", "law of infinitely many"});
}

/* Counts the speeds and the velocity components. All components have the
   same distribution and are counted together. */
static void sample_speeds(struct run *r)
{
    static double sample[2 * SPEEDS + 2];
    const double D = (double)r->d.dimensions, N = (double)r->d.count;
    memset(sample, 0, sizeof sample);
    for (size_t i = 0; i < r->d.count; ++i) {
        double parts[DISKS_AXES];
        const double u = scaled_speed(r, i, parts);
        if (bin_of(u) < SPEEDS)
            sample[bin_of(u)] += 1 / (N * edge_of(1));
        for (size_t k = 0; k < r->d.dimensions; ++k)
            if (bin_of(parts[k]) < SPEEDS)
                sample[SPEEDS + bin_of(parts[k])] +=
                    1 / (N * D * edge_of(1));
        sample[2 * SPEEDS] += u / N;
        sample[2 * SPEEDS + 1] += u * u * u * u / N;
    }
    blocks_add(&counted, sample);
}

enum { FINITE, MAXWELL, SPEED = 0, PART = 2, LAWS = 4 };

/* Returns chi-square of the speeds against a law and sets *bins to the
   number of bins in the sum. Omits bins with a density of 1e-3 or less,
   which contain too few disks for a reliable error. */
static double chi_square(const double density[], size_t *bins)
{
    double sum = 0;
    *bins = 0;
    for (size_t bin = 0; bin < SPEEDS; ++bin) {
        const struct blocks_average p = blocks_average(&counted, bin);
        if (!(p.mean > 1e-3 && p.error > 0))
            continue;
        const double z = (p.mean - density[bin]) / p.error;
        sum += z * z;
        ++*bins;
    }
    return sum;
}

/* Writes the measured distributions and those of both laws. The summary
   gets the means. */
static void end_speeds(struct run *r, struct table *summary)
{
    static double density[LAWS][SPEEDS];
    struct speeds_law law[LAWS];
    double mean[LAWS];
    const size_t D = r->d.dimensions, N = r->d.count;
    const bool resting = r->d.boundary == DISKS_PERIODIC;
    law[SPEED + FINITE] = speeds_exact(D, N, resting, false);
    law[SPEED + MAXWELL] = speeds_maxwell(D, false);
    law[PART + FINITE] = speeds_exact(D, N, resting, true);
    law[PART + MAXWELL] = speeds_maxwell(D, true);
    for (size_t k = 0; k < LAWS; ++k)
        mean[k] = speeds_bins(&law[k], edge_of(1), SPEEDS, density[k]);
    for (size_t bin = 0; bin < SPEEDS; ++bin) {
        const struct blocks_average p = blocks_average(&counted, bin);
        const struct blocks_average q =
            blocks_average(&counted, SPEEDS + bin);
        TABLE_ROW(r->out, edge_of(bin), p.mean, p.error,
                  density[SPEED + FINITE][bin],
                  density[SPEED + MAXWELL][bin], q.mean, q.error,
                  density[PART + FINITE][bin],
                  density[PART + MAXWELL][bin]);
    }
    const struct blocks_average v = blocks_average(&counted, 2 * SPEEDS);
    const struct blocks_average v4 =
        blocks_average(&counted, 2 * SPEEDS + 1);
    size_t bins;
    watch_drift(r, "mean_speed", v.drift);
    watch_drift(r, "v4", v4.drift);
    TABLE_RESULTS(
        summary, {"mean_speed", v.mean}, {"mean_speed_error", v.error},
        {"mean_speed_finite", mean[SPEED + FINITE]},
        {"mean_speed_maxwell", mean[SPEED + MAXWELL]}, {"v4", v4.mean},
        {"v4_error", v4.error},
        {"v4_finite", speeds_fourth(&law[SPEED + FINITE])},
        {"v4_maxwell", speeds_fourth(&law[SPEED + MAXWELL])},
        {"chi2_finite", chi_square(density[SPEED + FINITE], &bins)},
        {"chi2_maxwell", chi_square(density[SPEED + MAXWELL], &bins)});
    table_count(summary, "bins", bins);
}

static void begin_relaxation(struct run *r)
{
    TABLE_COLUMNS(r->out, {"t", "s", "time"},
                  {"c", "", "collisions of a disk until then"},
                  {"ratio", "", "<v^4>/<v^2>^2, v scaled by sqrt(m)"},
                  {"H", "", "Boltzmann's H, v in sqrt(2kT/m)"});
}

/* Returns the area or volume, in velocity space, of the shell that belongs
   to a bin of speeds. Boltzmann's H is a sum over these shells. */
static double shell(size_t bin, size_t dimensions)
{
    const double pi = 3.14159265358979324;
    const double a = edge_of(bin), b = edge_of(bin + 1);
    return dimensions == 2 ? pi * (b * b - a * a)
                           : 4 * pi / 3 * (b * b * b - a * a * a);
}

/* Writes a row. H is computed with velocities in units of sqrt(2kT/m).
   Speeds beyond the last bin are counted in the last bin. */
static void sample_relaxation(struct run *r)
{
    const double N = (double)r->d.count;
    double two = 0, four = 0, H = 0, fraction[SPEEDS] = {0};
    for (size_t i = 0; i < r->d.count; ++i) {
        double parts[DISKS_AXES];
        const double u = scaled_speed(r, i, parts);
        const size_t bin = bin_of(u);
        two += u * u / N;
        four += u * u * u * u / N;
        fraction[bin < SPEEDS ? bin : SPEEDS - 1] += 1 / N;
    }
    for (size_t bin = 0; bin < SPEEDS; ++bin)
        if (fraction[bin] > 0)
            H += fraction[bin] *
                 random_log(fraction[bin] / shell(bin, r->d.dimensions));
    TABLE_ROW(r->out, r->d.now, 2 * (double)r->d.collisions / N,
              four / (two * two), H);
}

static struct {
    double time, impulse[DISKS_AXES], virial;
} previous;

/* Begins the table of the pressure. Each row contains the pressure averaged
   over the time since the previous row. */
static void begin_pressure(struct run *r)
{
    const bool walls = r->d.boundary == DISKS_WALLS;
    previous.time = r->d.now;
    table_column(r->out, "t", "s", "end of the interval");
    for (size_t k = 0; walls && k < r->d.dimensions; ++k) {
        char symbol[16];
        snprintf(symbol, sizeof symbol, "Z_wall_%s", axis_names[k]);
        table_column(r->out, symbol, "",
                     "P V/(N kT) of the walls across this axis");
    }
    table_column(r->out, "Z_virial", "",
                 walls ? "mean of Z_wall (1 - 2R/L), from collisions"
                       : "P V/(N kT) from collisions");
}

/* Writes a row with the pressure since the previous row. Writes nothing at
   the first sampling time, when no time has passed. */
static void sample_pressure(struct run *r)
{
    const struct disks *d = &r->d;
    const double time = d->now - previous.time;
    double row[2 + DISKS_AXES] = {d->now};
    size_t n = 1;
    if (!(time > 0))
        return;
    if (d->boundary == DISKS_WALLS)
        for (size_t k = 0; k < d->dimensions; ++k)
            row[n++] =
                Z_wall(r, k, d->impulse[k] - previous.impulse[k], time);
    row[n++] = Z_virial(r, d->virial - previous.virial, time);
    table_row(r->out, n, row);
    previous.time = d->now;
    previous.virial = d->virial;
    memcpy(previous.impulse, d->impulse, sizeof previous.impulse);
}

static struct {
    size_t rows, space;
    double (*row)[2 * DISKS_AXES];
} path;

/* Begins the table of Brownian motion. The heavy disk is disk 0.
   sample_heavy stores its velocity, and its position without folding it
   back into the periodic box. */
static void begin_brownian(struct run *r)
{
    TABLE_COLUMNS(r->out, {"lag", "s", "a time"},
                  {"C", "m2/s2", "<V(t) V(t+lag)> of a component"},
                  {"error", "m2/s2", "its standard error"},
                  {"MSD", "m2", "<(X(t+lag)-X(t))^2>, all components"},
                  {"error", "m2", "its standard error"});
}

/* Appends a state of the heavy disk to the path. */
static void sample_heavy(struct run *r)
{
    if (path.rows == path.space) {
        path.space = 2 * path.space + 1024;
        path.row = realloc(path.row, path.space * sizeof path.row[0]);
        program_memory(path.row, "for the path of the heavy disk");
    }
    double *row = path.row[path.rows++];
    disks_position(&r->d, 0, row);
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        row[k] -= r->common[k] * (r->d.now - r->begin);
        row[DISKS_AXES + k] = r->d.disk[0].velocity[k] - r->common[k];
    }
}

static double product_of(const double a[], const double b[], size_t D)
{
    double sum = 0;
    for (size_t k = 0; k < D; ++k)
        sum += a[DISKS_AXES + k] * b[DISKS_AXES + k];
    return sum / (double)D;
}

static double square_of(const double a[], const double b[], size_t D)
{
    double sum = 0;
    for (size_t k = 0; k < D; ++k)
        sum += (b[k] - a[k]) * (b[k] - a[k]);
    return sum;
}

typedef double of_rows(const double a[], const double b[], size_t D);

/* Returns the average of f over all pairs of rows that are `lag` apart,
   with an error from blocking. */
static struct blocks_average over_path(of_rows *f, size_t lag, size_t D,
                                       double x[])
{
    const size_t n = path.rows - lag;
    for (size_t i = 0; i < n; ++i)
        x[i] = f(path.row[i], path.row[i + lag], D);
    return blocks_average_of(n, x);
}

/* Returns -dC/dt of the velocity autocorrelation C at lag 0. Computes twice
   the slope to the first lag minus the slope to the second lag, in which
   the curvature of C cancels. */
static struct blocks_average first_slope(const struct run *r, double x[])
{
    const size_t D = r->d.dimensions, n = path.rows - 2;
    const double scale = 1 / (2 * (double)D * given.every);
    for (size_t i = 0; i < n; ++i) {
        const double *now = path.row[i] + DISKS_AXES;
        const double one = square_of(now, path.row[i + 1] + DISKS_AXES, D);
        const double two = square_of(now, path.row[i + 2] + DISKS_AXES, D);
        x[i] = (2 * one - two / 2) * scale;
    }
    return blocks_average_of(n, x);
}

/* Writes the correlation and the mean square displacement for lags that
   grow by a seventh each time. The initial decay can be compared with
   theory, which needs only the measured collision rate. With walls no
   theoretical value is written, because the rate would include collisions
   with walls, which have another reduced mass. */
static void end_brownian(struct run *r, struct table *summary)
{
    const size_t D = r->d.dimensions;
    double *x = malloc(path.rows * sizeof x[0]);
    program_memory(x, "for the path of the heavy disk");
    for (size_t lag = 0; lag <= path.rows / 10; lag += 1 + lag / 7) {
        const struct blocks_average C = over_path(product_of, lag, D, x);
        const struct blocks_average M = over_path(square_of, lag, D, x);
        TABLE_ROW(r->out, (double)lag * given.every, C.mean, C.error,
                  M.mean, M.error);
    }
    const struct blocks_average V2 = over_path(product_of, 0, D, x);
    const double M = r->d.mass[0], m = r->d.mass[r->d.count - 1];
    const double time = r->d.now - r->begin;
    double all = 0;
    for (size_t i = 0; i < r->d.count; ++i)
        all += r->d.mass[i];
    watch_drift(r, "V2", V2.drift);
    TABLE_RESULTS(
        summary, {"V2", V2.mean}, {"V2_error", V2.error},
        {"V2_exact",
         r->kT / M * (r->d.boundary == DISKS_PERIODIC ? 1 - M / all : 1)});
    const double nu = r->d.hits[0] / time;
    if (path.rows > 32) {
        const struct blocks_average slope = first_slope(r, x);
        TABLE_RESULTS(summary, {"slope", slope.mean},
                      {"slope_error", slope.error});
    }
    table_real(summary, "heavy_rate", nu);
    if (r->d.boundary == DISKS_PERIODIC)
        table_real(summary, "slope_exact",
                   4 / (double)D * (M * m / (M + m)) * nu * r->kT /
                       (M * M));
    free(x);
}

static const struct {
    void (*begin)(struct run *r);
    void (*sample)(struct run *r);
    void (*end)(struct run *r, struct table *summary);
} measures[] = {{begin_states, sample_states, NULL},
                {begin_positions, sample_positions, end_positions},
                {begin_speeds, sample_speeds, end_speeds},
                {begin_pressure, sample_pressure, NULL},
                {begin_relaxation, sample_relaxation, NULL},
                {begin_brownian, sample_heavy, end_brownian}};

static const struct options_entry entries[] = {
    {"start", 'x', "PLACES",
     "lattice, random, or a file of states (lattice)"},
    {"box", 'b', "LX,LY,..", "its sides, m (1,1)"},
    {"boundary", 'B', "NAME",
     "walls, periodic, or floor: walls across y only\n"
     "(walls)"},
    {"warmup", 'w', "C",
     "collisions of a disk that do not count (100;\n"
     "0 for a file, for restitution and for relaxation)"},
    {"until", 't', "T", "stop at this time, s"},
    {"collisions", 'c', "C",
     "stop at this collision of two disks\n"
     "(100 of each disk, if no end is given)"},
    {"every", 'd', "DT",
     "look at each multiple of this time, s; states\n"
     "and pressure can do without"},
    {"measure", 'm', "NAME",
     "states, positions, speeds, pressure,\n"
     "relaxation or brownian (states)"},
    {"engine", 'g' | OPTIONS_SILENT, "NAME", "auto, pairs or cells (auto)"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"", 0, NULL, "--start lattice, random"},
    {"dimensions", 'D', "D", "2: disks, 3: spheres (2)"},
    {"packing", 'p', "ETA",
     "fraction of the box filled; without\n"
     "--box it gives the box, with R = 0.5"},
    {"species", 'f', "FILE", "a mixture: lines of count, mass, radius"},
    {"heavy", 'H', "M,R", "one disk more, of this mass and radius"},
    {"temperature", 'T', "KT", "draw Maxwell's velocities, J"},
    {"seed", 's', "S", "of the random numbers (1)"},
    {"", 0, NULL, "--start lattice, random; no --species"},
    {"disks", 'N', "N", "how many (4)"},
    {"radius", 'r', "R", "of the disks, m (0.15)"},
    {"", 0, NULL, "--start lattice, random; no --temperature"},
    {"speed", 'v', "V", "of all disks at the start, m/s (1)"},
    {"", 0, NULL, "--measure states"},
    {"restitution", 'e', "E", "of every collision (1)"},
    {"", 0, NULL, "--boundary walls, floor; --measure states, positions"},
    {"gravity", 'G', "G", "along y, towards the wall at 0, m/s2 (0)"},
    {"", 0, NULL, "--every"},
    {"samples", 'k', "K", "stop after so many looks behind the first"},
    {0}};

static const struct table_key keys[] = {
    {"disks", "1", "or spheres"},
    {"collisions", "1", "of two disks, behind the warm-up"},
    {"wall_collisions", "1", "of a disk and a wall"},
    {"samples", "1", "looks"},
    {"time", "s", "behind the warm-up"},
    {"kT", "J", "temperature"},
    {"packing", "1", "fraction of the box that is filled"},
    {"engine", "word", "that was used"},
    {"collisions_per_second", "1/s", "of processor time, walls counted"},
    {"", "", "if --restitution is 1:"},
    {"energy_error", "1", "relative"},
    {"", "", "if it is less:"},
    {"energy_change", "1", "relative"},
    {"", "", "if the run takes time:"},
    {"collision_rate", "1/s", "of a disk: two disks to a collision"},
    {"", "", "the same with --restitution 1, no --gravity, no floor:"},
    {"Z_virial", "1",
     "P V/(N kT) from collisions; with walls V is the\nroom of the "
     "centres: mean of Z_wall (1 - 2R/L)"},
    {"Z_virial_error", "1", "standard error"},
    {"drift", "1",
     "last third less first, in errors: the largest of\nall means; "
     "beyond 6 the run was not steady"},
    {"", "", "the same with walls:"},
    {"Z_wall_<axis>", "1", "P V/(N kT) at the walls across this axis"},
    {"Z_wall_<axis>_error", "1", "standard error"},
    {"", "", "if --measure speeds, u = v sqrt(m/(2 kT)):"},
    {"mean_speed", "1", "mean u"},
    {"mean_speed_error", "1", "standard error"},
    {"mean_speed_finite", "1", "by the law for so many disks"},
    {"mean_speed_maxwell", "1", "by Maxwell's"},
    {"v4", "1", "mean u^4"},
    {"v4_error", "1", "standard error"},
    {"v4_finite", "1", "by the law for so many disks"},
    {"v4_maxwell", "1", "by Maxwell's"},
    {"chi2_finite", "1", "of the speeds against that law"},
    {"chi2_maxwell", "1", "against Maxwell's"},
    {"bins", "1", "that both count"},
    {"", "", "if --measure brownian:"},
    {"V2", "m2/s2", "mean square of a component"},
    {"V2_error", "m2/s2", "standard error"},
    {"V2_exact", "m2/s2", "by equipartition"},
    {"heavy_rate", "1/s", "collisions of the heavy disk"},
    {"", "", "the same with more than 32 looks:"},
    {"slope", "m2/s3", "-dC/dt at lag 0"},
    {"slope_error", "m2/s3", "standard error"},
    {"", "", "the same in a periodic box:"},
    {"slope_exact", "m2/s3", "from heavy_rate"},
    {0}};

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'N': given.disks = options_count(o, 1, DISKS_MOST); break;
    case 'D': given.dimensions = options_count(o, 2, 3); break;
    case 'r': given.radius = options_positive(o, 1e100); break;
    case 'p': given.packing = options_positive(o, 1); break;
    case 'f': given.species = options_input(o); break;
    case 'b': given.axes = options_list(o, given.box, DISKS_AXES); break;
    case 'B': given.boundary = options_choice(o, states_boundaries); break;
    case 'x':
        given.start = options_text(o);
        if (starts_from_file())
            options_input(o);
        break;
    case 'v': given.speed = options_positive(o, 1e100); break;
    case 'T': given.temperature = options_positive(o, 1e100); break;
    case 'H': read_heavy(o, given.heavy); break;
    case 's': given.seed = options_count(o, 0, UINT64_MAX); break;
    case 'e': given.restitution = options_real(o, 0, 1); break;
    case 'G': given.gravity = options_real(o, 0, 1e100); break;
    case 'w': given.warmup = options_real(o, 0, 1e12); break;
    case 't': given.until = options_real(o, 0, INFINITY); break;
    case 'c': given.collisions = options_count(o, 0, UINT64_MAX - 1); break;
    case 'd': given.every = options_positive(o, INFINITY); break;
    case 'k': given.samples = options_count(o, 1, UINT64_MAX - 1); break;
    case 'm': given.measure = options_choice(o, measure_names); break;
    case 'g': given.engine = options_choice(o, engine_names); break;
    case 'o': given.output = options_text(o); break;
    case 'S': given.summary = options_text(o); break;
    }
}

/* Reads the command line and refuses options that contradict each other.
   There is no default warm-up for a gas that cools, for a measurement of
   relaxation, or for a start from a file. */
static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    options_begin(&o, PROGRAM, "Run hard disks or spheres in a box.",
                  entries, argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        take_option(&o, option);
    given.command = options_command(&o);
    if (given.packing > 0 && given.axes > 0 &&
        (given.radius > 0 || given.species))
        options_fail(&o, "--packing: the box and the radii are given");
    if (given.axes > 0 && !starts_from_file() &&
        given.axes != given.dimensions)
        options_fail(&o, "--box has %zu sides, expected %zu", given.axes,
                     given.dimensions);
    if (given.measure != STATES && given.measure != PRESSURE &&
        given.every == 0)
        options_fail(&o, "--measure %s needs --every",
                     measure_names[given.measure]);
    for (size_t k = 0; k < given.axes; ++k)
        if (!(given.box[k] > 0 && given.box[k] < 1e100))
            options_fail(&o, "--box: side %zu is %g, expected more than 0",
                         k + 1, given.box[k]);
    if (given.measure == BROWNIAN && given.heavy[0] == 0 &&
        !starts_from_file())
        options_fail(&o, "--measure brownian needs --heavy");
    program_apart(&o, given.output, given.summary, "table");
    if (given.disks == 0)
        given.disks = 4;
    if (given.speed == 0)
        given.speed = 1;
    if (isnan(given.warmup))
        given.warmup = starts_from_file() || given.measure == RELAXATION ||
                               given.restitution < 1
                           ? 0
                           : 100;
}

/* Writes the results common to all measurements. The key of the energy
   depends on whether the energy is meant to change. The pressure is written
   only for a gas that conserves energy. It is given as the compressibility
   over the whole run, from the walls and from the virial, with errors from
   blocking. */
static void summarise(struct run *r, struct table *out)
{
    const double time = r->d.now - r->begin;
    const double all =
        (double)r->d.collisions + (double)r->d.wall_collisions;
    table_count(out, "disks", r->d.count);
    table_count(out, "collisions", r->d.collisions);
    table_count(out, "wall_collisions", r->d.wall_collisions);
    table_count(out, "samples", r->rows);
    TABLE_RESULTS(
        out, {"time", time}, {"kT", r->kT},
        {"packing", disks_packing(&r->d)},
        {given.restitution < 1 ? "energy_change" : "energy_error",
         r->energy > 0 ? disks_energy(&r->d) / r->energy - 1 : 0});
    if (given.restitution == 1 && time > 0 && r->d.gravity == 0 &&
        r->d.boundary != DISKS_FLOOR && r->kT > 0) {
        const bool walls = r->d.boundary == DISKS_WALLS;
        for (size_t k = 0; walls && k < r->d.dimensions; ++k) {
            const struct blocks_average a = blocks_average(&r->pressure, k);
            table_keyed(out, Z_wall(r, k, r->d.impulse[k], time),
                        "Z_wall_%s", axis_names[k]);
            table_keyed(out, Z_wall(r, k, a.error, r->piece),
                        "Z_wall_%s_error", axis_names[k]);
            watch_drift(r, "Z_wall", a.drift);
        }
        const struct blocks_average a =
            blocks_average(&r->pressure, DISKS_AXES);
        TABLE_RESULTS(
            out, {"Z_virial", Z_virial(r, r->d.virial, time)},
            {"Z_virial_error", Z_virial(r, a.error, r->piece) - 1});
        watch_drift(r, "Z_virial", a.drift);
        table_real(out, "drift", r->drift);
    }
    if (time > 0)
        table_real(out, "collision_rate",
                   2 * (double)r->d.collisions / (double)r->d.count / time);
    table_text(out, "engine", r->fast ? "cells" : "pairs");
    table_real(out, "collisions_per_second",
               r->seconds > 0 ? all / r->seconds : 0);
}

/* Prints a note if an average changed during the run by more than its error
   explains. Prints nothing if the run writes no averages. */
static void report_drift(const struct run *r)
{
    const bool averages =
        strcmp(given.summary, "/dev/null") != 0 ||
        (given.measure != STATES && given.measure != RELAXATION);
    if (averages && fabs(r->drift) > BLOCKS_STEADY)
        program_say(
            "note: the last third of the run has a %s %s than the first, "
            "by %.3g errors: not steady, a longer --warmup or run may help",
            r->drift > 0 ? "higher" : "lower", r->drifting, fabs(r->drift));
}

/* Runs from one sampling time to the next and takes a sample at each.
   Sampling times are multiples of --every counted from time 0, so a
   continued run has the same sampling times as an uninterrupted run.

   If the run ends at a collision, a histogram excludes the last state, in
   which two disks touch. A list of states includes it, and a pressure
   without --every is averaged over the whole run. */
static void run_and_sample(struct run *r)
{
    const double every = given.every;
    const uint64_t collisions = given.collisions;
    measures[given.measure].sample(r);
    ++r->rows;
    for (bool over = false; !over && !progress_signal();) {
        ++r->row;
        double clock = every > 0 ? (double)r->row * every : INFINITY;
        over = !(clock < r->until - 1e-9 * every);
        if (over && !(clock <= r->until + 1e-9 * every))
            clock = r->until;
        run_to(r, clock, collisions);
        over = over || r->stop != DISKS_TIME;
        const bool regular = r->d.now == (double)r->row * every;
        const bool at_end = given.measure == STATES || every == 0;
        if (!progress_signal() && (regular || at_end)) {
            measures[given.measure].sample(r);
            ++r->rows;
        }
    }
}

/* Sets the end of the run and the index of its first sampling time. A time
   that is just below a multiple of --every, because of rounding, counts as
   that multiple. */
static void choose_end(struct run *r)
{
    const double per_clock = r->d.now / given.every;
    if (given.every > 0)
        r->row = (uint64_t)(per_clock + 1e-9 * fmax(1, per_clock));
    r->until = given.until;
    if (given.samples < UINT64_MAX)
        r->until =
            fmin(r->until, (double)(r->row + given.samples) * given.every);
    if (r->until < INFINITY)
        return;
    if (!can_meet(&r->d))
        program_refuse("--until: needed for disks that never meet");
    if (given.collisions == UINT64_MAX)
        given.collisions = 50 * (uint64_t)r->d.count;
}

/* Returns whether all disks are inside the box and no two overlap.
   Otherwise sets *a and *b to two overlapping disks, or *a to a disk
   outside the box and *b to the number of disks. Cells speed up the
   comparison if there are many disks. */
static bool is_valid_start(struct run *r, size_t *a, size_t *b)
{
    if (!r->fast)
        return disks_fit(&r->d, a, b);
    *b = r->d.count;
    for (*a = 0; *a < r->d.count; ++*a)
        if (disks_clash(&r->d, *a, *b))
            return false;
    plan(r);
    return cells_fit(&r->cells, a, b);
}

/* Refuses a run with more rows than a double can count. If the run has no
   end time, counts the rows over about the time between two collisions. */
static void check_rows(const struct run *r)
{
    const struct disks *d = &r->d;
    const double end =
        given.until < INFINITY ? given.until : d->now + first_piece(d);
    if (given.every > 0 && given.samples == UINT64_MAX && end < INFINITY &&
        fmax(end, d->now) / given.every > 9e15)
        program_refuse("--every: %g s makes more than 9e15 rows in %g s; "
                       "use a longer time, or --samples",
                       given.every, end);
}

static double shortest_periodic(const struct disks *d)
{
    double least = INFINITY;
    for (size_t k = 0; k < d->dimensions; ++k)
        least = disks_wraps(d, k) ? fmin(least, d->box[k]) : least;
    return least;
}

/* Refuses a start that is invalid or does not allow the requested
   measurement. A periodic box must be so wide that only one image of a disk
   can be the nearest. Only disks from a file can overlap or be outside the
   box, so only these are checked for it. */
static void check_start(struct run *r)
{
    const struct disks *d = &r->d;
    size_t a, b;
    if (!(disks_replan_distance(d) > 0))
        program_refuse(
            "--boundary: a side of %.10g is too narrow to be periodic: "
            "with a radius of %.10g it must be more than %.10g",
            shortest_periodic(d), widest(d), 4 * widest(d));
    if (d->gravity > 0 && d->boundary == DISKS_PERIODIC)
        program_refuse("--gravity needs a floor; %s is periodic, expected "
                       "--boundary walls or floor",
                       given.start);
    if (d->boundary == DISKS_FLOOR && given.measure != STATES &&
        given.measure != POSITIONS)
        program_refuse("--measure %s: not in a box with a floor and no "
                       "sides, expected states or positions",
                       measure_names[given.measure]);
    if (given.measure == SPEED_LAW &&
        d->count < (d->boundary == DISKS_PERIODIC ? 3 : 2))
        program_refuse("--measure speeds needs more disks: %zu have no law",
                       d->count);
    check_rows(r);
    if (disks_cold(d))
        program_refuse("--%s: the speeds are too low: their squares leave "
                       "the range of numbers; with radii and masses of 1 "
                       "expected at least 3.5e-136 m/s",
                       starts_from_file()      ? "start"
                       : given.temperature > 0 ? "temperature"
                                               : "speed");
    if (given.measure != STATES && given.measure != POSITIONS &&
        !(disks_heat(d) > 0))
        program_refuse("--measure %s: no disk moves relative to the "
                       "others: there is no temperature to compare with",
                       measure_names[given.measure]);
    if (!starts_from_file())
        return;
    a = disks_lying(d);
    if (a < d->count)
        program_refuse("--start: %s: disk %zu lies on the floor at rest, "
                       "expected one that moves: events end there",
                       given.start, a + 1);
    if (is_valid_start(r, &a, &b))
        return;
    if (b == d->count)
        program_refuse("--start: %s: disk %zu is not inside the box",
                       given.start, a + 1);
    program_refuse("--start: %s: disks %zu and %zu overlap", given.start,
                   a + 1, b + 1);
}

/* Switches gravity on. First updates the positions, because the disks have
   moved uniformly since their last collisions. */
static void begin_to_fall(struct disks *d, double gravity)
{
    for (size_t i = 0; i < d->count && gravity > 0; ++i) {
        disks_position(d, i, d->disk[i].position);
        d->disk[i].since = d->now;
    }
    d->gravity = gravity;
}

/* Prints why a run ended early: a disk at rest on the floor, inelastic
   collapse, speeds that are too low, or all disks at rest. */
static void report_collapse(const struct disks *d)
{
    const size_t lying = disks_lying(d);
    if (lying < d->count)
        fprintf(stderr, PROGRAM ": disk %zu lies on the floor", lying + 1);
    else
        fprintf(stderr, PROGRAM ": %s",
                disks_collapsed(d) ? "inelastic collapse"
                : disks_cold(d)
                    ? "too cold to go on: squares of the speeds leave the "
                      "range of numbers"
                    : "all are at rest");
    fprintf(stderr, " at t = %.6g s after %llu collisions\n", d->now,
            (unsigned long long)d->collisions);
}

/* Runs disks. Creates the start before opening files, so a refused start
   leaves no file. Writes the head before the warm-up, so a run that is
   interrupted during the warm-up leaves a table. An interrupted run has no
   summary. */
int main(int argc, char *argv[])
{
    static struct run r;
    read_settings(argc, argv);
    if (starts_from_file())
        read_start(&r.d);
    else
        make_start(&r.d);
    r.d.restitution = given.restitution;
    begin_to_fall(&r.d, given.gravity);
    choose_engine(&r);
    check_start(&r);
    struct table *summary;
    program_open(given.output, given.summary, keys, &r.out, &summary);
    table_begin(r.out, given.command, given.seed);
    progress_begin(&r.progress, PROGRAM, PARTS, "collisions");
    warm_up(&r, given.warmup);
    choose_end(&r);
    begin_run(&r);
    measures[given.measure].begin(&r);
    run_and_sample(&r);
    if (measures[given.measure].end)
        measures[given.measure].end(&r, summary);
    summarise(&r, summary);
    const bool whole = progress_end(&r.progress);
    if (r.stop == DISKS_COLLAPSE)
        report_collapse(&r.d);
    if (whole)
        report_drift(&r);
    cells_free(&r.cells);
    disks_free(&r.d);
    const int status = program_close(r.out, summary, whole);
    return r.stop == DISKS_COLLAPSE ? EXIT_FAILURE : status;
}
