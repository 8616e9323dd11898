/* Samples hard disks directly or by Markov chains. */
#include "box/means.h"
#include "box/sampling.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "sample"
#define LONGEST 1e6 /* maximum length in an option, m */

enum {
    MOST = 100000,    /* maximum number of disks (each try examines all) */
    PILOT = 100000,   /* throws for an estimate of the number needed */
    MOST_DIGITS = 15, /* refuse more than 10^MOST_DIGITS throws */
    SOME = 256        /* samples between updates of progress */
};
#define GIVE_UP 1e8         /* consecutive failed throws */
enum { PORTION = 1 << 16 }; /* throws between checks for signals */

enum method { DIRECT, MARKOV, CHAINS };
static const char *const method_names[] = {"direct", "markov", "chains",
                                           NULL};
static const char *const boundary_names[] = {"walls", "periodic", NULL};

enum measure { POSITIONS, DISTANCES, STATES };
static const char *const measure_names[] = {"positions", "distances",
                                            "states", NULL};

static struct {
    size_t method, boundary, measure;
    size_t dimensions, large, small, bins;
    double radius, small_radius, box[DISKS_AXES];
    double step, length; /* m; defaults: one radius, ten radii */
    uint64_t samples, seed;
    const char *output, *summary, *command;
} given = {.dimensions = 2,
           .large = 4,
           .bins = 100,
           .radius = 0.15,
           .box = {1, 1},
           .samples = 100000,
           .seed = 1,
           .summary = "/dev/null"};

static const struct options_entry entries[] = {
    {"method", 'm', "NAME", "direct, markov or chains (direct)"},
    {"disks", 'N', "N", "how many (4)"},
    {"radius", 'r', "R", "m (0.15)"},
    {"box", 'b', "Lx,Ly[,Lz]", "its sides, m (1,1)"},
    {"boundary", 'B', "NAME", "walls or periodic (walls)"},
    {"samples", 'k', "K",
     "direct: configurations; markov: sweeps of\n"
     "as many tries as there are disks; chains: these\n"
     "(100000)"},
    {"measure", 'M', "NAME", "positions, distances or states (positions)"},
    {"seed", 's', "S", "of the random numbers (1)"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"", 0, NULL, "--method direct, markov"},
    {"small", 'i', "R,COUNT", "as many ideal ones of radius R more"},
    {"", 0, NULL, "--method markov"},
    {"step", 'd', "D", "the longest move along an axis, m (R)"},
    {"", 0, NULL, "--method chains"},
    {"length", 'l', "L",
     "that the disks of a chain move in all, half as\n"
     "much to half as much again, m (10 R)"},
    {"", 0, NULL, "--measure positions, distances"},
    {"bins", 'n', "B", "over the whole length (100)"},
    {0}};

static const struct table_key keys[] = {
    {"samples", "1", "direct: configurations; markov: sweeps; chains"},
    {"tries", "1", "throws, moves or pushes"},
    {"acceptance", "1", "fraction of them"},
    {"acceptance_error", "1", "standard error"},
    {"", "", "if there are walls:"},
    {"Z_wall_<axis>", "1", "P V/(N kT) at the walls across this axis"},
    {"Z_wall_<axis>_error", "1", "standard error"},
    {"mean_x1", "m", "mean place of disk 1"},
    {"mean_x1_error", "m", "standard error"},
    {"", "", "if there are two disks or more:"},
    {"f_contact", "1/m", "density of the distance of two at contact"},
    {"f_contact_error", "1/m", "standard error"},
    {"", "", "the same without --small:"},
    {"Z_virial", "1",
     "P V/(N kT) from pairs; with walls V is the room\nof the centres: "
     "mean of Z_wall (1 - 2R/L)"},
    {"Z_virial_error", "1", "standard error"},
    {"", "", "if --method markov:"},
    {"moved", "m", "rms way of a disk from its start"},
    {"", "", "if --method chains:"},
    {"Z_chain", "1", "P V/(N kT) from how far a push comes"},
    {"Z_chain_error", "1", "standard error"},
    {0}};

static void read_box(struct options *o)
{
    given.dimensions = options_list(o, given.box, DISKS_AXES);
    for (size_t k = 0; k < given.dimensions; ++k)
        if (given.dimensions < 2 ||
            !(given.box[k] > 0 && given.box[k] <= LONGEST))
            options_fail(o, "'%s', expected two or three lengths up to %g",
                         options_text(o), LONGEST);
}

static void read_small(struct options *o)
{
    double pair[2];
    if (options_list(o, pair, 2) != 2 ||
        !(pair[0] >= 0 && pair[0] <= LONGEST && pair[1] >= 0 &&
          pair[1] <= MOST && pair[1] == (double)(size_t)pair[1]))
        options_fail(o,
                     "'%s', expected a radius and a whole number up to %d",
                     options_text(o), MOST);
    given.small_radius = pair[0];
    given.small = (size_t)pair[1];
}

static void read_settings(struct options *o, int argc, char *argv[])
{
    int option;
    options_begin(o, PROGRAM, "Sample the places of hard disks in a box.",
                  entries, argc, argv);
    options_keys(o, keys);
    while ((option = options_next(o)) != -1)
        switch (option) {
        case 'm': given.method = options_choice(o, method_names); break;
        case 'N': given.large = options_count(o, 1, MOST); break;
        case 'r': given.radius = options_positive(o, LONGEST); break;
        case 'b': read_box(o); break;
        case 'B': given.boundary = options_choice(o, boundary_names); break;
        case 'i': read_small(o); break;
        case 'k':
            given.samples = options_count(o, 1, UINT64_MAX / 4);
            break;
        case 'd': given.step = options_positive(o, LONGEST); break;
        case 'l': given.length = options_positive(o, LONGEST); break;
        case 'M': given.measure = options_choice(o, measure_names); break;
        case 'n': given.bins = options_count(o, 1, 100000); break;
        case 's': given.seed = options_count(o, 0, UINT64_MAX); break;
        case 'o': given.output = options_text(o); break;
        case 'S': given.summary = options_text(o); break;
        }
    given.command = options_command(o);
    if (given.step == 0)
        given.step = given.radius;
    if (given.length == 0)
        given.length = 10 * given.radius;
    if (given.method == CHAINS && given.boundary != DISKS_PERIODIC)
        options_fail(o, "--method: chains need --boundary periodic, since "
                        "a wall hands nothing on");
    program_apart(o, given.output, given.summary, "table");
}

/* Returns whether the large disks certainly do not fit between the walls.
   Their centres are in a rectangle with the sides a = Lx - 2 r and b = Ly -
   2 r. Two disks fit only if the diagonal is at least sigma = 2 r. Oler
   proved in 1961 that the rectangle contains at most 2 a b / (sqrt(3)
   sigma^2) + (a + b) / sigma + 1 points whose distances are at least
   sigma. */
static bool is_too_full(void)
{
    const double sigma = 2 * given.radius;
    double area = 1, half = 0, square = 0;
    for (size_t k = 0; k < given.dimensions; ++k) {
        const double side = (given.box[k] - sigma) / sigma;
        area *= side;
        half += side;
        square += side * side;
    }
    const double most = 2 / sqrt(3) * area + half + 1;
    return given.boundary == DISKS_WALLS &&
           ((given.large > 1 && square < 1 - 1e-12) ||
            (given.dimensions == 2 && (double)given.large > most + 1e-9));
}

/* Ends the program if the disks cannot fit: if one is wider than the box,
   or if their packing exceeds the densest one, pi/sqrt(12) = 0.9069 in the
   plane and pi/sqrt(18) = 0.7405 in space. */
static void check_room(struct options *o, const struct sampling *p)
{
    const double widest =
        fmax(given.radius, given.small > 0 ? given.small_radius : 0);
    const double most = given.dimensions == 2 ? 0.9069 : 0.7405;
    struct disks large = p->disks;
    large.count = given.large;
    const double packing = disks_packing(&large);
    for (size_t k = 0; k < given.dimensions; ++k) {
        if (given.boundary == DISKS_WALLS && !(given.box[k] > 2 * widest))
            options_fail(
                o, "--box: a side of %g has no room for a radius of %g",
                given.box[k], widest);
        if (given.boundary == DISKS_PERIODIC &&
            !(given.box[k] >= 4 * widest))
            options_fail(
                o,
                "--box: a side of %g, but a periodic one must be at "
                "least four radii, %g, so that a disk meets "
                "another one once",
                given.box[k], 4 * widest);
    }
    if (packing > most)
        options_fail(
            o,
            "--disks: %zu of radius %g would fill %.4g of the box, "
            "and no packing fills more than %g",
            given.large, given.radius, packing, most);
    if (is_too_full())
        options_fail(o,
                     "--disks: %zu of radius %g have no room between these "
                     "walls",
                     given.large, given.radius);
}

/* Ends the program if direct sampling would need more than 10^15 throws,
   which take years, or more than five million throws per sample. The
   estimate uses its own random generator, so it does not change the run. */
static void check_throws(struct options *o, struct sampling *p)
{
    struct random r;
    random_seed(&r, ~given.seed);
    const double once = -sampling_log_acceptance(p, PILOT, &r) / log(10);
    const double tries = once + log((double)given.samples) / log(10);
    if (tries > MOST_DIGITS || once > log(GIVE_UP / 20) / log(10))
        options_fail(
            o,
            "--method: direct would need more than 10^%.0f throws; "
            "use markov",
            floor(tries));
}

struct run {
    struct sampling p;
    struct random r;
    struct progress progress;
    struct means bins, numbers;
    uint64_t done, tries, accepted;
    double *start; /* positions of the large disks after the warm-up */
    double *row;   /* buffer for a table row */
    double high;   /* maximum distance counted, m */
    struct table *out;
    bool hopeless; /* too many consecutive throws failed */
};

/* Indices of the means in run.numbers. */
enum number {
    ACCEPTANCE, /* fraction of moves accepted; throws per sample if direct
                 */
    MEAN_X,     /* x of disk 1, m */
    WALL,       /* density at the walls normal to each axis, 1/m */
    PAIR = WALL + DISKS_AXES, /* density of pair distances at contact,
                                 1/m */
    GAIN,                     /* Z - 1 from event chains, see next_chain */
    NUMBERS
};

/* Returns the maximum distance that is counted. With walls, all distances
   are counted. In a periodic box, distances are counted up to half of the
   shortest side, so that a circle (sphere) of that radius is inside the
   box. */
static double longest_distance(void)
{
    double square = 0, least = INFINITY;
    for (size_t k = 0; k < given.dimensions; ++k) {
        const double way = given.box[k] - 2 * given.radius;
        square += way * way;
        least = fmin(least, given.box[k] / 2);
    }
    return given.boundary == DISKS_PERIODIC ? least : sqrt(square);
}

/* Allocates the memory of a run. Without enough memory, prints a message
   and returns false. */
static bool begin_run(struct run *run)
{
    const size_t count = given.large + given.small;
    const size_t bins = given.measure == POSITIONS
                            ? given.dimensions * given.bins
                            : given.bins;
    *run = (struct run){.high = longest_distance()};
    random_seed(&run->r, given.seed);
    run->start = calloc(given.large, DISKS_AXES * sizeof(double));
    run->row = malloc((1 + DISKS_AXES * count) * sizeof(double));
    if (run->start && run->row &&
        sampling_create(&run->p, given.dimensions,
                        (enum disks_boundary)given.boundary, given.box,
                        given.large, given.radius, given.small,
                        given.small_radius) &&
        means_create(&run->bins, bins) &&
        means_create(&run->numbers, NUMBERS))
        return true;
    program_say("no memory for %zu disks", count);
    return false;
}

/* Throws until all disks fit. Returns false after a signal, or after
   GIVE_UP failed throws, because no rule predicts whether the disks fit. At
   an acceptance of 2e-7, a hundred million throws, which take a few
   seconds, all fail with a probability of e^-20. The mean number of throws
   per sample is the inverse of the acceptance. The numbers of throws of
   successive samples are independent. */
static bool next_direct(struct run *run)
{
    uint64_t throws = 1;
    while (sampling_throw(&run->p, &run->r) < run->p.disks.count)
        if (throws++ % PORTION == 0) {
            progress_update(&run->progress, run->done, run->tries + throws);
            run->hopeless = throws > GIVE_UP;
            if (progress_signal() || run->hopeless) {
                run->tries += throws - 1;
                return false;
            }
        }
    run->tries += throws;
    ++run->accepted;
    means_add(&run->numbers, ACCEPTANCE, (double)throws);
    return true;
}

/* Makes as many tries as there are disks. Returns the number of tries that
   moved a disk. */
static size_t sweep(struct run *run)
{
    const size_t count = run->p.disks.count;
    size_t moved = 0;
    for (size_t k = 0; k < count; ++k)
        moved += sampling_try(&run->p, given.step, &run->r);
    return moved;
}

static bool next_markov(struct run *run)
{
    const size_t count = run->p.disks.count;
    const size_t moved = sweep(run);
    run->tries += count;
    run->accepted += moved;
    means_add(&run->numbers, ACCEPTANCE, (double)moved / (double)count);
    return true;
}

/* Makes an event chain along a random axis, with a random length. If all
   chains were five diameters long, eight disks in a box four diameters wide
   would never leave the sites of the lattice on which they start. No move
   is ever rejected, so the acceptance is 1. */
static bool next_chain(struct run *run)
{
    const size_t axis = random_below(&run->r, given.dimensions);
    const double length = given.length * random_between(&run->r, 0.5, 1.5);
    double gained = 0;
    const uint64_t pushes =
        1 + sampling_chain(&run->p, axis, length, &run->r, &gained);
    run->tries += pushes;
    run->accepted += pushes;
    means_add(&run->numbers, ACCEPTANCE, 1);
    means_add(&run->numbers, GAIN, gained / length);
    return true;
}

static bool next_sample(struct run *run)
{
    switch (given.method) {
    case DIRECT: return next_direct(run);
    case MARKOV: return next_markov(run);
    default: return next_chain(run);
    }
}

/* Finds a start and equilibrates for a tenth of the number of samples
   without measuring, because the first configurations are still close to
   the lattice. Returns false if no start is found. */
static bool warm_up(struct run *run)
{
    const struct disks *d = &run->p.disks;
    if (!sampling_start(&run->p, &run->r)) {
        program_say("no start found for %zu disks of radius %g and %zu "
                    "small ones; use fewer",
                    given.large, given.radius, given.small);
        return false;
    }
    for (uint64_t k = 0; k < given.samples / 10 && !progress_signal();
         ++k) {
        if (given.method == MARKOV)
            sweep(run);
        else
            next_chain(run);
        if (k % SOME == 0)
            progress_update(&run->progress, 0, k * d->count);
    }
    for (size_t i = 0; i < run->p.large; ++i)
        memcpy(run->start + DISKS_AXES * i, d->disk[i].position,
               DISKS_AXES * sizeof(double));
    memset(run->numbers.sum, 0, NUMBERS * sizeof *run->numbers.sum);
    run->tries = run->accepted = 0;
    return true;
}

/* Returns the bin of x, among `bins` equal bins from 0 to `length`. These
   bins are the same for all methods. */
static size_t bin_of(double x, double length, size_t bins)
{
    const double bin = x / length * (double)bins;
    return bin < (double)bins ? (size_t)bin : bins - 1;
}

static void count_positions(struct run *run)
{
    const struct disks *d = &run->p.disks;
    for (size_t i = 0; i < run->p.large; ++i) {
        double place[DISKS_AXES];
        disks_position(d, i, place);
        disks_fold(d, place);
        for (size_t k = 0; k < d->dimensions; ++k) {
            const size_t bin = bin_of(place[k], d->box[k], given.bins);
            means_add(&run->bins, k * given.bins + bin, 1);
        }
    }
}

/* Counts the distance between the nearest images of each pair once. */
static void count_distances(struct run *run)
{
    const struct disks *d = &run->p.disks;
    for (size_t i = 0; i < run->p.large; ++i)
        for (size_t j = 0; j < i; ++j) {
            double apart[DISKS_AXES], square = 0;
            disks_separation(d, d->disk[i].position, d->disk[j].position,
                             apart);
            for (size_t k = 0; k < d->dimensions; ++k)
                square += apart[k] * apart[k];
            if (square <= run->high * run->high)
                means_add(&run->bins,
                          bin_of(sqrt(square), run->high, given.bins), 1);
        }
}

static void write_state(struct run *run)
{
    const struct disks *d = &run->p.disks;
    size_t n = 0;
    run->row[n++] = (double)run->done;
    for (size_t i = 0; i < d->count; ++i) {
        double place[DISKS_AXES];
        disks_position(d, i, place);
        disks_fold(d, place);
        for (size_t k = 0; k < d->dimensions; ++k)
            run->row[n++] = place[k];
    }
    table_row(run->out, n, run->row);
}

/* Measures the contact densities of one disk with the walls and with up to
   three other disks. Successive samples use successive disks and pairs,
   because measuring all of them would take longer than making the
   sample. */
static void count_contacts(struct run *run)
{
    const size_t n = run->p.large, i = run->done % n;
    const size_t pairs = n - 1 < 3 ? n - 1 : 3;
    if (given.boundary == DISKS_WALLS)
        for (size_t k = 0; k < given.dimensions; ++k)
            means_add(&run->numbers, WALL + k,
                      sampling_wall_density(&run->p, i, k));
    for (size_t k = 0; k < pairs; ++k) {
        const size_t turn = (run->done / n * pairs + k) % (n - 1);
        means_add(&run->numbers, PAIR,
                  sampling_pair_density(&run->p, i, (i + 1 + turn) % n) /
                      (double)pairs);
    }
    means_add(&run->numbers, MEAN_X, run->p.disks.disk[0].position[0]);
}

/* Takes samples until all are taken or a signal arrives. */
static void take_samples(struct run *run)
{
    while (run->done < given.samples && !progress_signal() &&
           next_sample(run)) {
        count_contacts(run);
        if (given.measure == POSITIONS)
            count_positions(run);
        else if (given.measure == DISTANCES)
            count_distances(run);
        else
            write_state(run);
        means_next(&run->bins);
        means_next(&run->numbers);
        if (++run->done % SOME == 0)
            progress_update(&run->progress, run->done, run->tries);
    }
}

static const char *const axis_names[] = {"x", "y", "z"};

static void name_columns(struct run *run)
{
    const size_t count = given.large + given.small;
    char symbol[40], meaning[80];
    if (given.measure == DISTANCES) {
        TABLE_COLUMNS(run->out, {"s", "m", "lower edge of the bin"},
                      {"f", "1/m", "density of the distances"},
                      {"e", "1/m", "its error"});
    } else if (given.measure == POSITIONS) {
        table_column(run->out, "x", "m", "lower edge of the bin");
        for (size_t k = 0; k < given.dimensions; ++k) {
            snprintf(symbol, sizeof symbol, "p%s", axis_names[k]);
            snprintf(meaning, sizeof meaning,
                     "density of %s, in bin i from i L/B", axis_names[k]);
            table_column(run->out, symbol, "1/m", meaning);
            snprintf(symbol, sizeof symbol, "e%s", axis_names[k]);
            table_column(run->out, symbol, "1/m", "its error");
        }
    } else {
        table_column(run->out, "n", "", "number of the sample");
        for (size_t i = 0; i < count * given.dimensions; ++i) {
            const size_t k = i % given.dimensions,
                         disk = i / given.dimensions;
            snprintf(symbol, sizeof symbol, "%s%zu", axis_names[k],
                     disk + 1);
            table_column(run->out, symbol, "m", "");
        }
    }
}

/* Writes the densities: counts divided by the width of a bin and by the
   number of disks or pairs. */
static void write_bins(struct run *run)
{
    const size_t axes = given.measure == POSITIONS ? given.dimensions : 1;
    const double n = (double)given.large, bins = (double)given.bins;
    const double many = given.measure == POSITIONS ? n : n * (n - 1) / 2;
    for (size_t b = 0; b < given.bins; ++b) {
        double row[1 + 2 * DISKS_AXES];
        for (size_t k = 0; k < axes; ++k) {
            const double high =
                given.measure == POSITIONS ? given.box[k] : run->high;
            const double unit = bins / high / many;
            const size_t q = k * given.bins + b;
            if (k == 0)
                row[0] = high * (double)b / bins;
            row[1 + 2 * k] = unit * means_mean(&run->bins, q);
            row[2 + 2 * k] = unit * means_error(&run->bins, q);
        }
        table_row(run->out, 1 + 2 * axes, row);
    }
}

/* Writes `more` plus `factor` times the mean of a quantity, and its
   error. */
static void write_number(struct table *out, const struct run *run,
                         const char *key, size_t quantity, double factor,
                         double more)
{
    char with[40];
    snprintf(with, sizeof with, "%s_error", key);
    TABLE_RESULTS(
        out, {key, more + factor * means_mean(&run->numbers, quantity)},
        {with, factor * means_error(&run->numbers, quantity)});
}

/* Returns the root mean square distance of the large disks from their
   positions after the warm-up, m. It shows whether a Markov chain moves at
   all. */
static double distance_moved(const struct run *run)
{
    double sum = 0;
    for (size_t i = 0; i < run->p.large; ++i)
        for (size_t k = 0; k < given.dimensions; ++k) {
            const double way = run->p.disks.disk[i].position[k] -
                               run->start[DISKS_AXES * i + k];
            sum += way * way;
        }
    return sqrt(sum / (double)run->p.large);
}

/* Writes the summary. Omits results that are undefined for one disk or with
   small disks. The acceptance of direct sampling is the inverse of the mean
   number of throws per sample, so its error is acceptance^2 times the error
   of this mean. By symmetry, the mean x of any disk is the middle of the
   box, so the mean x of disk 1 shows whether a chain has forgotten its
   start. */
static void write_summary(struct table *out, const struct run *run)
{
    static const char *const walls[] = {"Z_wall_x", "Z_wall_y", "Z_wall_z"};
    const double per_contact =
        (double)(given.large - 1) * given.radius / (double)given.dimensions;
    const double acceptance = (double)run->accepted / (double)run->tries;
    const double error = means_error(&run->numbers, ACCEPTANCE);
    const double slope =
        given.method == DIRECT ? acceptance * acceptance : 1;
    table_count(out, "samples", run->done);
    table_count(out, "tries", run->tries);
    TABLE_RESULTS(out, {"acceptance", acceptance},
                  {"acceptance_error", slope * error});
    if (given.boundary == DISKS_WALLS)
        for (size_t k = 0; k < given.dimensions; ++k)
            write_number(out, run, walls[k], WALL + k, given.box[k], 0);
    if (given.large > 1)
        write_number(out, run, "f_contact", PAIR, 1, 0);
    if (given.large > 1 && given.small == 0)
        write_number(out, run, "Z_virial", PAIR, per_contact, 1);
    if (given.boundary == DISKS_WALLS)
        write_number(out, run, "mean_x1", MEAN_X, 1, 0);
    if (given.method == MARKOV)
        table_real(out, "moved", distance_moved(run));
    if (given.method == CHAINS)
        write_number(out, run, "Z_chain", GAIN, 1, 1);
}

/* Writes the results and returns the exit status. A run interrupted by a
   signal keeps its table, but its summary is discarded, because it would
   look like that of a complete run. If there is no configuration, the table
   is discarded, too. */
static int finish(struct run *run, struct table *summary)
{
    const bool complete = progress_end(&run->progress) && !run->hopeless;
    const bool empty = run->done == 0;
    if (run->hopeless)
        program_say("nothing fitted in %.0e throws in a row; use --method "
                    "markov, or a smaller --radius",
                    GIVE_UP);
    else if (empty)
        program_say("no configuration in %llu throws, no table",
                    (unsigned long long)run->tries);
    else if (given.measure != STATES)
        write_bins(run);
    if (!empty)
        write_summary(summary, run);
    if (empty)
        program_leave(EXIT_FAILURE);
    return program_close(run->out, summary, complete);
}

int main(int argc, char *argv[])
{
    struct options o;
    struct run run;
    read_settings(&o, argc, argv);
    if (!begin_run(&run))
        return EXIT_FAILURE;
    check_room(&o, &run.p);
    if (given.method == DIRECT)
        check_throws(&o, &run.p);
    struct table *summary;
    program_open(given.output, given.summary, keys, &run.out, &summary);
    progress_begin(&run.progress, PROGRAM, given.samples, "tries");
    table_begin(run.out, given.command, given.seed);
    name_columns(&run);
    if (given.method != DIRECT && !warm_up(&run))
        program_leave(EXIT_FAILURE);
    take_samples(&run);
    const int status = finish(&run, summary);
    sampling_free(&run.p);
    means_free(&run.bins);
    means_free(&run.numbers);
    free(run.start);
    free(run.row);
    return status;
}
