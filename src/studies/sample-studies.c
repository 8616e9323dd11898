/* Compares samplers: mistakes, memory, acceptance, cost of precision. */
#include "box/means.h"
#include "box/sampling.h"
#include "line/statistics.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "sample-studies"

enum {
    LIST = 16, /* maximum length of an option's list */
    BINS = 14, /* number of bins for a coordinate of a disk's centre */
    HALF = BINS / 2,
    WALLS = BINS, /* index of the left side of (6.5, eq:two-sides) */
    PAIRS,        /* index of the right side of (6.5) */
    QUANTITIES,
    PATIENCE = 200000000 /* maximum number of throws in study_acceptance */
};

static struct {
    size_t disks, radii, steps;
    double radius[LIST], step[LIST];
    uint64_t samples;
} own = {.disks = 4,
         .radii = 1,
         .radius = {0.15},
         .steps = 1,
         .step = {0.1},
         .samples = 100000};

static const struct options_entry entries[] = {
    {"samples", 'k', "K", "configurations or sweeps (100000)"},
    {"", 0, NULL, "--study acceptance"},
    {"disks", 'N', "N", "in a unit box with walls (4)"},
    {"", 0, NULL, "--study memory, acceptance, cost"},
    {"radii", 'r', "R1,..", "m (0.15)"},
    {"", 0, NULL, "--study memory, cost"},
    {"step", 'd', "D1,..", "of the chain, m (0.1)"},
    {0}};

static void memory_or_exit(bool got)
{
    if (!got)
        program_give_up("no memory; use fewer disks or samples");
}

/* Makes a unit box with own.disks disks. */
static void make_box(struct sampling *p, double radius)
{
    memory_or_exit(sampling_create(p, 2, DISKS_WALLS,
                                   (const double[]){1, 1}, own.disks,
                                   radius, 0, 0));
}

/* Starts a Markov chain and runs it for `sweeps` sweeps to remove the
   influence of the start. */
static void start_chain(struct sampling *p, double step, uint64_t sweeps,
                        struct random *r)
{
    if (!sampling_start(p, r))
        program_give_up("--radii: %g leaves no room",
                        p->disks.disk[0].radius);
    for (uint64_t k = 0; k < sweeps * p->disks.count; ++k)
        sampling_try(p, step, r);
}

/* Returns the bin of x, among BINS equal bins from r to 1 - r. */
static size_t bin_of(const struct sampling *p, double x)
{
    const double r = p->disks.disk[0].radius;
    const double bin = (x - r) / (1 - 2 * r) * BINS;
    return bin < 0 ? 0 : bin < BINS ? (size_t)bin : BINS - 1;
}

/* Adds a sample of both sides of (6.5, eq:two-sides), taken from one disk.
   Successive calls use successive disks. */
static void count_contacts(struct means *m, const struct sampling *p)
{
    const size_t count = p->disks.count;
    const size_t i = (m->blocks * m->length + m->filled) % count;
    const double r = p->disks.disk[i].radius;
    double pairs = 1;
    for (size_t j = 0; j < count; ++j)
        if (j != i)
            pairs += r * sampling_pair_density(p, i, j) / 2;
    means_add(m, WALLS,
              (1 - 2 * r) *
                  (sampling_wall_density(p, i, 0) +
                   sampling_wall_density(p, i, 1)) /
                  2);
    means_add(m, PAIRS, pairs);
}

/* Adds a sample of both sides of (6.5) and of the density of the
   coordinates. Each coordinate is weighted so that the mean of a bin is
   a density. */
static void count_places(struct means *m, const struct sampling *p)
{
    const size_t count = p->disks.count;
    const double width = (1 - 2 * p->disks.disk[0].radius) / BINS;
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 2; ++k)
            means_add(m, bin_of(p, p->disks.disk[i].position[k]),
                      1 / (width * 2 * (double)count));
    count_contacts(m, p);
    means_next(m);
}

enum way { THROWN, KEPT, CHAIN, MOVED, WAYS };
static const char *const way_names[WAYS] = {"thrown", "kept", "chain",
                                            "moved"};

/* Takes samples in one of four ways. THROWN and KEPT place disks at random.
   If a disk does not fit, THROWN places all disks again. KEPT places only
   that disk again, as disks_place_random does, which is wrong. CHAIN and
   MOVED run a Markov chain. CHAIN takes a sample after every trial move,
   and MOVED only after accepted moves, which is wrong. */
static void take(enum way way, struct means *m, struct sampling *p,
                 double step, struct random *r)
{
    const size_t count = p->disks.count;
    if (way == THROWN)
        while (sampling_throw(p, r) < count)
            ;
    if (way == KEPT)
        while (!disks_place_random(&p->disks, r))
            ;
    if (way <= KEPT)
        count_places(m, p);
    else
        for (size_t k = 0; k < count; ++k)
            if (sampling_try(p, step, r) || way == CHAIN)
                count_places(m, p);
}

/* Writes the error of the density `wrong` relative to `right`, in per cent,
   for bin b and its mirror image BINS - 1 - b together. */
static void write_bias(struct study *s, const char *key,
                       const struct means *wrong, const struct means *right,
                       size_t b)
{
    const double got =
        means_mean(wrong, b) + means_mean(wrong, BINS - 1 - b);
    const double due =
        means_mean(right, b) + means_mean(right, BINS - 1 - b);
    table_real(s->summary, key, 100 * (got / due - 1));
}

/* Writes the densities from the four ways of sampling, both sides of (6.5,
   eq:two-sides), and the relative errors of the wrong densities. */
static void write_mistakes(struct study *s, const struct means means[])
{
    const double width = (1 - 2 * own.radius[0]) / BINS;
    for (size_t b = 0; b < BINS; ++b) {
        double row[1 + 2 * WAYS] = {own.radius[0] +
                                    ((double)b + 0.5) * width};
        for (int way = 0; way < WAYS; ++way) {
            row[1 + 2 * way] = means_mean(&means[way], b);
            row[2 + 2 * way] = means_error(&means[way], b);
        }
        table_row(s->out, 1 + 2 * WAYS, row);
    }
    for (int way = 0; way < WAYS; ++way) {
        const struct means *m = &means[way];
        const char *const name = way_names[way];
        table_keyed(s->summary, means_mean(m, WALLS), "%s_walls", name);
        table_keyed(s->summary, means_error(m, WALLS), "%s_walls_error",
                    name);
        table_keyed(s->summary, means_mean(m, PAIRS), "%s_pairs", name);
        table_keyed(s->summary, means_error(m, PAIRS), "%s_pairs_error",
                    name);
    }
    write_bias(s, "kept_edge", &means[KEPT], &means[THROWN], 0);
    write_bias(s, "kept_middle", &means[KEPT], &means[THROWN], HALF - 1);
    write_bias(s, "moved_edge", &means[MOVED], &means[CHAIN], 0);
    write_bias(s, "moved_middle", &means[MOVED], &means[CHAIN], HALF - 1);
}

/* Compares two wrong ways of sampling with the right ones. Each way first
   runs a chain of a thousand sweeps, so that its start is independent of
   the way before it. */
static void study_mistakes(struct study *s)
{
    struct means means[WAYS];
    struct sampling p;
    make_box(&p, own.radius[0]);
    table_column(s->out, "x", "m", "middle of the bin");
    for (int way = 0; way < WAYS; ++way) {
        TABLE_COLUMNS(s->out, {way_names[way], "1/m", "density of x and y"},
                      {"e", "1/m", "its error"});
        memory_or_exit(means_create(&means[way], QUANTITIES));
        start_chain(&p, own.step[0], 1000, &s->random);
        for (uint64_t k = 0; k < own.samples && !progress_signal(); ++k)
            take((enum way)way, &means[way], &p, own.step[0], &s->random);
    }
    write_mistakes(s, means);
    for (int way = 0; way < WAYS; ++way)
        means_free(&means[way]);
    sampling_free(&p);
}

/* Runs a chain. After each sweep n, stores the x coordinate of disk 1 in
   x[n] and the fraction of coordinates in the outermost bins in edge[n].
   Returns the fraction of accepted moves. */
static double run_chain(struct sampling *p, double step, uint64_t sweeps,
                        double x[], double edge[], struct random *r)
{
    const size_t count = p->disks.count;
    uint64_t moved = 0;
    for (uint64_t n = 0; n < sweeps; ++n) {
        size_t at_edge = 0;
        for (size_t k = 0; k < count; ++k)
            moved += sampling_try(p, step, r);
        for (size_t k = 0; k < 2 * count; ++k) {
            const double place = p->disks.disk[k / 2].position[k % 2];
            at_edge += bin_of(p, place) % (BINS - 1) == 0;
        }
        x[n] = p->disks.disk[0].position[0];
        edge[n] = (double)at_edge / (2 * (double)count);
    }
    return (double)moved / (double)(sweeps * count);
}

/* Returns the statistical inefficiency of a series: how many of its samples
   carry as much information as one independent sample. */
static double inefficiency(size_t n, const double x[])
{
    static struct statistics_blocking b;
    memory_or_exit(statistics_blocking(n, x, &b));
    return b.inefficiency;
}

/* Runs chain k, which has the k-th combination of radius and step. x has
   room for two series. The keys of the results end in k + 1. */
static void study_chain(struct study *s, size_t k, double x[])
{
    const double radius = own.radius[k / own.steps];
    const double step = own.step[k % own.steps];
    const size_t n = own.samples;
    struct sampling p;
    make_box(&p, radius);
    start_chain(&p, step, n / 10, &s->random);
    const double acceptance = run_chain(&p, step, n, x, x + n, &s->random);
    const double g_x = inefficiency(n, x), g_edge = inefficiency(n, x + n);
    char which[24];
    snprintf(which, sizeof which, "%zu", k + 1);
    TABLE_ROW(s->out, radius, step, acceptance, g_x, g_edge,
              statistics_moments(n, x).mean);
    TABLE_RESULTS_OF(s->summary, which, {"acceptance", acceptance},
                     {"g_x", g_x}, {"g_edge", g_edge});
    sampling_free(&p);
}

static void study_memory(struct study *s)
{
    double *x = malloc(2 * own.samples * sizeof *x);
    memory_or_exit(x);
    TABLE_COLUMNS(s->out, {"r", "m", "radius"},
                  {"step", "m", "longest move along an axis"},
                  {"acceptance", "", "of moves"},
                  {"gx", "sweeps", "inefficiency of x of disk 1"},
                  {"ge", "sweeps", "of the fraction in the end bins"},
                  {"mean", "m", "mean x of disk 1"});
    const size_t chains = own.radii * own.steps;
    for (size_t k = 0; k < chains && !progress_signal(); ++k)
        study_chain(s, k, x);
    free(x);
}

/* Measures the fraction of random configurations that have no overlaps.
   Stops after own.samples configurations without overlaps, or after
   PATIENCE configurations in total. */
static void study_acceptance(struct study *s)
{
    TABLE_COLUMNS(s->out, {"r", "m", "radius"},
                  {"packing", "", "fraction of the box that is filled"},
                  {"acceptance", "", "fraction of throws"},
                  {"e", "", "its error"});
    for (size_t k = 0; k < own.radii && !progress_signal(); ++k) {
        struct sampling p;
        uint64_t fitted = 0, throws = 0;
        make_box(&p, own.radius[k]);
        for (; fitted < own.samples && throws < PATIENCE; ++throws) {
            if (progress_signal())
                break;
            fitted += sampling_throw(&p, &s->random) == own.disks;
        }
        const double acceptance = (double)fitted / (double)throws;
        if (fitted > 0)
            TABLE_ROW(s->out, own.radius[k], disks_packing(&p.disks),
                      acceptance, acceptance / sqrt((double)fitted));
        sampling_free(&p);
    }
}

enum method { DIRECT, MARKOV, DYNAMICS, METHODS };
static const char *const method_names[METHODS] = {"direct", "markov",
                                                  "dynamics"};
enum {
    TIMES = 7, /* processor times at which errors are measured, each four
                  times the previous */
    SEEDS = 8, /* runs averaged for each error */
    TRIES = 64 /* tries between clock readings */
};
static const double first_time = 0.00025; /* s */

/* Makes one random throw, one Markov sweep, or 0.1 s of dynamics. Returns
   whether the result is a valid sample. Only a throw can fail. */
static bool next_try(enum method method, struct sampling *p, double step,
                     struct random *r)
{
    switch (method) {
    case DIRECT: return sampling_throw(p, r) == p->disks.count;
    case MARKOV:
        for (size_t k = 0; k < p->disks.count; ++k)
            sampling_try(p, step, r);
        return true;
    default:
        disks_run(&p->disks, p->disks.now + 0.1, UINT64_MAX);
        return true;
    }
}

/* Prepares a method. Dynamics starts from the end of a Markov chain with
   all speeds equal to 1 m/s. The other methods do not use speeds. */
static void begin_method(enum method method, struct sampling *p,
                         double step, struct random *r)
{
    disks_set_speed(&p->disks, 0, r);
    disks_settle(&p->disks);
    start_chain(p, step, method == DIRECT ? 0 : 1000, r);
    if (method != DYNAMICS)
        return;
    disks_set_speed(&p->disks, 1, r);
    memory_or_exit(disks_plan(&p->disks));
}

/* Counts the current coordinates by their distance from the nearer wall. */
static void add_places(const struct sampling *p, double counts[HALF])
{
    for (size_t i = 0; i < p->disks.count; ++i) {
        double place[DISKS_AXES];
        disks_position(&p->disks, i, place);
        for (size_t k = 0; k < 2; ++k) {
            const size_t b = bin_of(p, place[k]);
            ++counts[b < HALF ? b : BINS - 1 - b];
        }
    }
}

/* Returns the mean square deviation of the density `counts` from
   `reference`, in units of the mean density squared. */
static double deviation(const double counts[HALF],
                        const double reference[HALF])
{
    double total = 0, of = 0, sum = 0;
    for (size_t b = 0; b < HALF; ++b) {
        total += counts[b];
        of += reference[b];
    }
    for (size_t b = 0; b < HALF; ++b) {
        const double fraction = total > 0 ? counts[b] / total : 0;
        const double off = HALF * (fraction - reference[b] / of);
        sum += off * off;
    }
    return sum / HALF;
}

/* Runs a method and adds the squared deviation of its density to sum[] at
   each of the TIMES times. */
static void run_method(enum method method, struct sampling *p, double step,
                       struct random *r, const double reference[HALF],
                       double sum[TIMES])
{
    double counts[HALF] = {0}, until = first_time;
    begin_method(method, p, step, r);
    const double start = bench_seconds();
    for (int t = 0; t < TIMES; ++t, until *= 4) {
        while (bench_seconds() - start < until && !progress_signal())
            for (int k = 0; k < TRIES; ++k)
                if (next_try(method, p, step, r))
                    add_places(p, counts);
        sum[t] += deviation(counts, reference);
    }
}

/* Measures the error of each method against processor time: the root mean
   square of SEEDS runs, after one warm-up run. The reference is a much
   longer run of dynamics. It can be trusted, because the error of direct
   sampling, which is correct by construction, decreases steadily up to the
   longest time. */
static void study_cost(struct study *s)
{
    bench_machine(s->out);
    TABLE_COLUMNS(
        s->out, {"method", "", "and radius"}, {"r", "m", "radius"},
        {"time", "s", "of the processor, for a run"},
        {"error", "", "rms of the density, in units of its mean"});
    for (size_t k = 0; k < own.radii && !progress_signal(); ++k) {
        double reference[HALF] = {0};
        struct sampling p;
        make_box(&p, own.radius[k]);
        begin_method(DYNAMICS, &p, own.step[0], &s->random);
        for (uint64_t n = 0; n < own.samples && !progress_signal(); ++n) {
            next_try(DYNAMICS, &p, own.step[0], &s->random);
            add_places(&p, reference);
        }
        for (unsigned method = 0; method < METHODS; ++method) {
            const double radius = p.disks.disk[0].radius;
            double until = first_time, sum[TIMES] = {0};
            for (int seed = -1; seed < SEEDS; ++seed) {
                if (seed == 0)
                    memset(sum, 0, sizeof sum); /* discard the warm-up */
                run_method((enum method)method, &p, own.step[0], &s->random,
                           reference, sum);
            }
            for (int t = 0; t < TIMES; ++t, until *= 4)
                table_print(s->out, "%s-%g %g %.9g %.4g\n",
                            method_names[method], radius, radius, until,
                            sqrt(sum[t] / SEEDS));
        }
        sampling_free(&p);
    }
}

/* Methods that measure the pressure of 64 disks in a periodic box. A Markov
   chain uses the densities at contact, dynamics uses collisions, and event
   chains use the distances gained at contacts. */
enum gauging { SLIDES, COLLISIONS, CHAINS, GAUGINGS };
static const char *const gauging_names[GAUGINGS] = {"markov", "dynamics",
                                                    "chains"};

/* A running measurement of Z - 1. */
struct gauge {
    struct sampling p;
    struct random r;
    double step, sum; /* step, m; sum of Z - 1 over the samples */
    uint64_t samples;
};

static void begin_gauge(struct gauge *g, enum gauging way, double packing,
                        double step)
{
    const size_t count = 64;
    const double radius = sqrt(packing / (acos(-1) * (double)count));
    memory_or_exit(sampling_create(&g->p, 2, DISKS_PERIODIC,
                                   (const double[]){1, 1}, count, radius, 0,
                                   0));
    g->step = step * radius;
    g->sum = 0;
    g->samples = 0;
    start_chain(&g->p, g->step, 3000, &g->r);
    if (way != COLLISIONS)
        return;
    disks_set_speed(&g->p.disks, 1, &g->r);
    disks_settle(&g->p.disks);
    memory_or_exit(disks_plan(&g->p.disks));
}

/* Makes a sweep. Returns an estimate of Z - 1 from the contact densities of
   one disk with three others, as in the program `sample`. */
static double slide(struct gauge *g)
{
    const size_t n = g->p.disks.count, i = g->samples % n;
    double sum = 0;
    for (size_t k = 0; k < n; ++k)
        sampling_try(&g->p, g->step, &g->r);
    for (size_t k = 0; k < 3; ++k) {
        const size_t turn = (g->samples / n * 3 + k) % (n - 1);
        sum += sampling_pair_density(&g->p, i, (i + 1 + turn) % n) / 3;
    }
    return sum * (double)(n - 1) * g->p.disks.disk[0].radius / 2;
}

/* Returns an estimate of Z - 1 from an event chain about five diameters
   long. */
static double follow_chain(struct gauge *g, size_t axis)
{
    const double length =
        10 * g->p.disks.disk[0].radius * random_between(&g->r, 0.5, 1.5);
    double gained = 0;
    sampling_chain(&g->p, axis, length, &g->r, &gained);
    return gained / length;
}

/* Returns Z - 1 from the samples so far. Dynamics uses the virial of all
   collisions since the start instead (7.5, eq:virial). */
static double gauge_value(struct gauge *g, enum gauging way)
{
    const struct disks *d = &g->p.disks;
    if (way != COLLISIONS)
        return g->sum / (double)g->samples;
    return d->virial /
           (2 * (double)d->count * disks_temperature(d) * d->now);
}

static void take_one(struct gauge *g, enum gauging way)
{
    if (way == COLLISIONS)
        disks_run(&g->p.disks, g->p.disks.now + 0.02, UINT64_MAX);
    else
        g->sum += way == SLIDES ? slide(g)
                                : follow_chain(g, random_below(&g->r, 2));
    ++g->samples;
}

enum { MARKS = 5, GAUGES = 16 };

/* Runs a measurement of Z - 1. At each of the MARKS times adds its squared
   error, divided by GAUGES, to square[t]. */
static void measure_gauge(enum gauging way, double packing, double step,
                          double truth, struct random *r,
                          double square[MARKS])
{
    struct gauge g = {.r = *r};
    begin_gauge(&g, way, packing, step);
    const double start = bench_seconds();
    double until = 0.004;
    for (int t = 0; t < MARKS; ++t, until *= 4) {
        do
            take_one(&g, way);
        while (bench_seconds() - start < until && !progress_signal());
        const double off = gauge_value(&g, way) - truth;
        square[t] += off * off / GAUGES;
    }
    *r = g.r;
    sampling_free(&g.p);
}

/* Returns the reference value of Z - 1, the mean over `chains` event
   chains. */
static double find_truth(double packing, double step, uint64_t chains,
                         struct random *r)
{
    struct gauge g = {.r = *r};
    begin_gauge(&g, CHAINS, packing, step);
    while (g.samples < chains && !progress_signal())
        take_one(&g, CHAINS);
    const double truth = gauge_value(&g, CHAINS);
    *r = g.r;
    sampling_free(&g.p);
    return truth;
}

static void study_pressure(struct study *s)
{
    static const double packing[] = {0.3, 0.65}, step[] = {1.2, 0.3};
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"method", "", "and packing"},
                  {"time", "s", "of the processor, for a run"},
                  {"error", "", "rms of Z"});
    for (int k = 0; k < 2; ++k) {
        const double truth =
            find_truth(packing[k], step[k], own.samples, &s->random);
        table_print(s->out, "# packing %g: Z %.5f\n", packing[k],
                    1 + truth);
        for (int way = 0; way < GAUGINGS; ++way) {
            double square[MARKS] = {0}, until = 0.004;
            for (int n = 0; n < GAUGES && !progress_signal(); ++n)
                measure_gauge((enum gauging)way, packing[k], step[k], truth,
                              &s->random, square);
            for (int t = 0; t < MARKS; ++t, until *= 4)
                table_print(s->out, "%s-%g %.4g %.4g\n", gauging_names[way],
                            packing[k], until, sqrt(square[t]));
        }
    }
}

/* Measures the pressure with event chains along x only, starting on a
   lattice. Every disk stays in its row, so some configurations are never
   reached. */
static void study_one_way(struct study *s)
{
    struct means m;
    struct gauge g;
    const double both = find_truth(0.65, 0.3, own.samples, &s->random);
    g.r = s->random;
    begin_gauge(&g, CHAINS, 0.65, 0.3);
    start_chain(&g.p, g.step, 0, &g.r);
    memory_or_exit(means_create(&m, 1));
    for (uint64_t n = 0; n < own.samples && !progress_signal(); ++n) {
        means_add(&m, 0, follow_chain(&g, 0));
        means_next(&m);
    }
    TABLE_RESULTS(s->summary, {"Z_both", 1 + both},
                  {"Z_x", 1 + means_mean(&m, 0)},
                  {"Z_x_error", means_error(&m, 0)});
    means_free(&m);
    sampling_free(&g.p);
}

static const struct study_entry studies[] = {
    {"mistakes", study_mistakes, "two of them, and the right ways",
     STUDY_KEYS({"kept_edge", "%", "density in the end bins, off thrown"},
                {"kept_middle", "%", "the same in the middle"},
                {"moved_edge", "%", "density in the end bins, off chain"},
                {"moved_middle", "%", "the same in the middle"},
                {"<way>_walls", "1", "left side of (6.5)"},
                {"<way>_walls_error", "1", "its standard error"},
                {"<way>_pairs", "1", "right side of (6.5)"},
                {"<way>_pairs_error", "1", "its standard error"})},
    {"memory", study_memory, "how long a chain's is",
     STUDY_KEYS(
         {"acceptance_<k>", "1", "chain k: fraction of moves accepted"},
         {"g_x_<k>", "sweeps", "inefficiency of x of disk 1"},
         {"g_edge_<k>", "sweeps",
          "the same of the fraction in the end bins"})},
    {"acceptance", study_acceptance, "how many throws fit", NULL},
    {"cost", study_cost, "error against processor time", NULL},
    {"pressure", study_pressure, "the same of a gas and a crowd", NULL},
    {"one-way", study_one_way, "event chains along one axis",
     STUDY_KEYS({"Z_both", "1", "P V/(N kT) by chains along both axes"},
                {"Z_x", "1", "the same along x alone"},
                {"Z_x_error", "1", "its standard error"})},
    {0}};

/* Reads a list of lengths between 0 and `limit` into x[]. Returns the
   number of lengths. */
static size_t read_lengths(struct options *o, double x[], double limit)
{
    const size_t n = options_list(o, x, LIST);
    for (size_t k = 0; k < n; ++k)
        if (!(x[k] > 0 && x[k] < limit))
            options_fail(o, "%g, expected more than 0 and less than %g",
                         x[k], limit);
    return n;
}

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'N': own.disks = options_count(o, 1, 1000); break;
    case 'r': own.radii = read_lengths(o, own.radius, 0.5); break;
    case 'd': own.steps = read_lengths(o, own.step, 1); break;
    case 'k': own.samples = options_count(o, 100, 1000000000); break;
    }
}

STUDY_MAIN(.name = PROGRAM,
           .purpose = "Compare samplers of disks in a box.",
           .events = "samples", .studies = studies, .seeds = UINT64_MAX,
           .options = entries, .take = take_option)
