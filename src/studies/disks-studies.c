/* Measures hard disks: clocks, reversal, contacts, collapse and speed. */
#include "box/loop.h"
#include "toolbox/bench.h"
#include "toolbox/quad.h"
#include "toolbox/study.h"

#include <math.h>
#include <string.h>

#define PROGRAM "disks-studies"

enum { MOST_STARTS = 100000 };

static struct {
    uint64_t samples;
    uint64_t starts; /* 0: the study's default */
    double every;    /* time step, s */
} own = {.samples = 1000000, .every = 0.01};

/* Makes `count` disks of radius r and speed v in a square box with walls
   and sides `length`. Ends the program if there is no memory or no room. */
static void begin_or_exit(struct disks *d, size_t count, double r,
                          double length, double v, struct random *random)
{
    if (disks_create(d, 2, count)) {
        d->box[0] = d->box[1] = length;
        for (size_t i = 0; i < count; ++i)
            d->disk[i].radius = r;
        disks_set_speed(d, v, random);
        if (disks_place_lattice(d) && disks_plan(d))
            return;
    }
    program_give_up("no memory or no room for the disks");
}

static const double radius = 0.15; /* m; the box is 1 m wide */

static void begin_four(struct disks *d, double v, uint64_t seed)
{
    struct random r;
    random_seed(&r, seed);
    begin_or_exit(d, 4, radius, 1, v, &r);
}

enum { BINS = 100 };

/* Returns the bin of a position. A disk that has just hit a wall is exactly
   on the edge of a bin, so x is moved towards the middle by 1e-9. Otherwise
   rounding would choose the bin. */
static int bin_of(double x)
{
    const double inside = 0.5 + (x - 0.5) * (1 - 1e-9);
    return (int)fmin(fmax(floor(inside * BINS), 0), BINS - 1);
}

/* The three loops that are compared: ours, the loop of the hard-disk
   article, and the article's loop with its sign corrected (box/loop.h). */
enum { OURS, ARTICLE, MENDED, CLOCKS };

static const char *const clocks[CLOCKS] = {"clock", "article", "mended"};

/* Runs four disks with loop `way`. Counts their coordinates in bins[] and
   raises *overlap to the deepest overlap. Returns the initial energy. */
static double sample_by(int way, const struct study *s, struct loop *l,
                        double bins[BINS], double *overlap)
{
    begin_four(&l->d, 1, s->seed);
    const double energy = disks_energy(&l->d);
    l->next = disks_next(&l->d);
    for (uint64_t n = 1; n <= own.samples; ++n) {
        if (way == OURS)
            loop_go_to(l, (double)n * own.every);
        else
            loop_turn(l, own.every);
        for (size_t i = 0; i < l->d.count; ++i) {
            double place[DISKS_AXES];
            disks_position(&l->d, i, place);
            for (size_t k = 0; k < 2; ++k)
                bins[bin_of(place[k])] += 1;
        }
        *overlap = fmax(*overlap, loop_overlap(l));
    }
    return energy;
}

/* Writes the density of the coordinates as sampled by each loop. */
static void study_clock(struct study *s)
{
    static double bins[CLOCKS][BINS];
    table_column(s->out, "x", "m", "lower edge of the bin");
    for (int way = 0; way < CLOCKS; ++way) {
        struct loop l = {.offset = way == ARTICLE ? -1 : 1};
        double overlap = 0;
        const double energy = sample_by(way, s, &l, bins[way], &overlap);
        const double impulse = l.d.impulse[0] + l.d.impulse[1];
        const double nkt = disks_energy(&l.d); /* 2 E / D, D = 2 */
        const double edge = (bins[way][15] + bins[way][84]) / 16 * BINS;
        TABLE_RESULTS_OF(
            s->summary, clocks[way], {"Z", impulse / (4 * nkt * l.t)},
            {"overlap", overlap},
            {"energy", disks_energy(&l.d) / energy - 1},
            {"edge", (edge / (double)own.samples / 2.630625 - 1) * 100});
        disks_free(&l.d);
        table_column(s->out, clocks[way], "1/m", "density of a coordinate");
    }
    const double scale = BINS / (8 * (double)own.samples);
    for (int bin = 0; bin < BINS; ++bin) {
        double row[1 + CLOCKS] = {(double)bin / BINS};
        for (int way = 0; way < CLOCKS; ++way)
            row[1 + way] = bins[way][bin] * scale;
        table_row(s->out, 1 + CLOCKS, row);
    }
}

static void write_place(struct study *s, struct loop *l)
{
    double place[DISKS_AXES];
    disks_position(&l->d, 0, place);
    TABLE_ROW(s->out, l->d.now, place[0], place[1]);
}

/* Writes the path of the first disk until 1.5 s in three blocks. Block 0
   has a row for each event, block 1 for each tick of the clock, and block 2
   for each record of the article's loop. All blocks begin with the same
   state, one second after a start on a lattice.

   A block has at most a thousand rows, because the article's loop does not
   end for a few seeds: it reverses an overlapping pair endlessly and its
   clock stops. */
static void study_timeline(struct study *s)
{
    TABLE_COLUMNS(s->out, {"t", "s", "events; clock times; the article's"},
                  {"x", "m", "of the first disk"},
                  {"y", "m", "of the first disk"});
    for (int way = 0; way < 3; ++way) {
        struct loop l = {.offset = -1};
        begin_four(&l.d, 1, s->seed);
        disks_run(&l.d, 1, UINT64_MAX);
        disks_settle(&l.d);
        l.next = disks_next(&l.d);
        write_place(s, &l);
        for (int k = 1; l.d.now < 1.5 && k < 1000; ++k) {
            if (way == 2)
                loop_turn(&l, own.every);
            else if (way == 1)
                loop_go_to(&l, k * own.every);
            else if (l.next.time <= 1.5)
                loop_event(&l);
            else
                l.d.now = 1.5;
            write_place(s, &l);
        }
        table_print(s->out, "\n\n");
        disks_free(&l.d);
    }
}

/* Runs for the time t, reverses all velocities and runs for t again.
   Returns the largest difference from an initial coordinate (in m), which
   would be zero without rounding. Adds the number of collisions before the
   reversal to *collisions. All disks are moved to the present time before
   the reversal; otherwise the way back would begin at other positions. */
static double miss(struct disks *d, double t, double *collisions)
{
    struct disk start[4];
    double worst = 0;
    memcpy(start, d->disk, sizeof start);
    disks_run(d, t, UINT64_MAX);
    *collisions += (double)d->collisions;
    disks_settle(d);
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < DISKS_AXES; ++k)
            d->disk[i].velocity[k] *= -1;
    if (!disks_plan(d))
        return INFINITY;
    disks_run(d, t, UINT64_MAX);
    disks_settle(d);
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < 2; ++k)
            worst = fmax(
                worst, fabs(d->disk[i].position[k] - start[i].position[k]));
    return worst;
}

/* Returns the median (in m) of the results of `miss` for many starts of
   four disks with total energy e. Sets *collisions to the mean number of
   collisions. */
static double median_miss(const struct study *s, double e, double t,
                          double *collisions)
{
    static double worst[MOST_STARTS];
    const uint64_t starts = own.starts ? own.starts : 101;
    *collisions = 0;
    for (uint64_t i = 0; i < starts; ++i) {
        struct disks d;
        begin_four(&d, sqrt(e / 2),
                   s->seed * 1000 + i + (uint64_t)(100 * e));
        worst[i] = miss(&d, t, collisions);
        disks_free(&d);
    }
    *collisions /= (double)starts;
    return bench_median(worst, starts);
}

/* Writes the results for the energies 1 J and 4 J side by side. At 4 J the
   speeds are doubled, so everything takes half the time. */
static void study_reverse(struct study *s)
{
    double one[16], four[16], n = 0, other;
    TABLE_COLUMNS(s->out,
                  {"t", "s", "times the root of E: there, and back"},
                  {"n", "", "collisions there, mean"},
                  {"miss_1", "m", "median miss, E = 1 J"},
                  {"miss_4", "m", "the same, E = 4 J"});
    for (int k = 0; k < 16; ++k) {
        const double t = 0.5 * (k + 1);
        one[k] = median_miss(s, 1, t, &n);
        four[k] = median_miss(s, 4, t / 2, &other);
        TABLE_ROW(s->out, t, n, one[k], four[k]);
    }
    TABLE_RESULTS(s->summary, {"miss_5", one[9]}, {"miss_8", one[15]},
                  {"collisions", n}, {"rate_1", log(one[14] / one[2]) / 6},
                  {"rate_4", log(four[14] / four[2]) / 3});
}

/* Makes a pair of disks that will collide in a random direction, with
   impact parameter `miss` and distance `gap` between their edges. The unit
   of length is sigma = 1. */
static void throw_pair(struct random *r, double gap, double miss,
                       double apart[], double closing[])
{
    double e[DISKS_AXES] = {0};
    random_direction(r, 2, e);
    const double far = 1 + gap, along = sqrt(far * far - miss * miss);
    for (size_t k = 0; k < DISKS_AXES; ++k)
        closing[k] = -e[k];
    apart[0] = along * e[0] - miss * e[1];
    apart[1] = along * e[1] + miss * e[0];
    apart[2] = 0;
}

/* Computes the contact time of two disks with sigma = 1 from the textbook's
   root and from the stable root. Sets *book and *ours to their errors.
   Returns the error of the distance between the disks at the time from the
   stable root, or -1 if the disks do not collide. */
static double contact_errors(const double x[], const double v[],
                             double *book, double *ours)
{
    const double time = disks_pair_time(x, v, 1);
    const quad b = (quad)x[0] * v[0] + (quad)x[1] * v[1];
    const quad a = (quad)v[0] * v[0] + (quad)v[1] * v[1];
    const quad c = (quad)x[0] * x[0] + (quad)x[1] * x[1] - 1;
    const double lb = x[0] * v[0] + x[1] * v[1];
    const double la = v[0] * v[0] + v[1] * v[1];
    const double lc = x[0] * x[0] + x[1] * x[1] - 1;
    if (time == INFINITY || !(b * b - a * c > 0) || !(lb * lb >= la * lc))
        return -1;
    const quad exact = c / (quad_root(b * b - a * c) - b);
    *ours = fabs((double)(time - exact));
    *book = fabs((double)((-lb - sqrt(lb * lb - la * lc)) / la - exact));
    const quad dx = x[0] + v[0] * (quad)time, dy = x[1] + v[1] * (quad)time;
    return fabs((double)(quad_root(dx * dx + dy * dy) - 1));
}

/* Kinds of pairs: grazing, with a gap, and with a gap and positions that
   are exact in double precision. */
enum { GRAZE, GAP, EXACT, KINDS };

/* Draws random pairs of one kind and raises worst[] to their largest
   errors. For grazing pairs these are the time error of the stable root and
   the error of the distance at that time. For the other kinds they are the
   time errors of the textbook's root and of the stable root, divided by the
   gap. This approximates the relative error, because time and gap are about
   equal. */
static void worst_of(int kind, double size, struct random *r,
                     double worst[])
{
    const uint64_t pairs = own.starts ? own.starts : 1000;
    const double scale = kind == GRAZE ? 1 : size;
    for (uint64_t i = 0; i < pairs; ++i) {
        double x[3], v[3], book, ours;
        if (kind == GRAZE)
            throw_pair(r, 1, 1 - size, x, v);
        else
            throw_pair(r, size, random_uniform(r) * 0.9, x, v);
        if (kind == EXACT) {
            x[0] = 1 + size;
            v[0] = -random_between(r, 0.5, 2);
            x[1] = v[1] = 0;
        }
        const double off = contact_errors(x, v, &book, &ours);
        if (off < 0)
            continue;
        worst[0] = fmax(worst[0], (kind == GRAZE ? ours : book) / scale);
        worst[1] = fmax(worst[1], (kind == GRAZE ? off : ours) / scale);
    }
}

/* Writes the errors for the sizes 1/2, 1/4, ..., 2^-50. The size is the
   gap, or for grazing pairs the difference of sigma and the impact
   parameter. The summary gets the errors at 2^-40 for grazing pairs and at
   2^-26 for the others. */
static void study_contact(struct study *s)
{
    static const char *const keys[] = {"time", "place",      "book",
                                       "ours", "book_exact", "ours_exact"};
    TABLE_COLUMNS(s->out,
                  {"s", "", "gap, or what lacks to sigma; sigma = 1"},
                  {"time", "", "grazing: error of the time"},
                  {"place", "", "grazing: error of the distance then"},
                  {"book", "", "gap s: relative error, textbook's root"},
                  {"ours", "", "gap s: relative error, stable root"},
                  {"book'", "", "the textbook's, exact places"},
                  {"ours'", "", "the stable root, exact places"});
    for (int k = 1; k <= 50; ++k) {
        double row[1 + 2 * KINDS] = {ldexp(1, -k)};
        for (int kind = GRAZE; kind < KINDS; ++kind)
            worst_of(kind, row[0], &s->random, &row[1 + 2 * kind]);
        table_row(s->out, 1 + 2 * KINDS, row);
        for (int c = 0; c < 2 * KINDS; ++c)
            if (k == (c < 2 ? 40 : 26))
                table_real(s->summary, keys[c], row[1 + c]);
    }
}

/* Runs n disks for at most 100 n collisions. Returns whether they
   collapse. */
static bool collapses(struct disks *d, size_t n, double restitution,
                      uint64_t seed)
{
    struct random r;
    random_seed(&r, seed);
    begin_or_exit(d, n, 0.5, sqrt((double)n * 2.8), 1, &r);
    d->restitution = restitution;
    return disks_run(d, INFINITY, 100 * n) == DISKS_COLLAPSE;
}

/* Writes the fraction of runs that collapse, for each coefficient of
   restitution. Then writes the final state of one run. The disks in the
   collapse are those that collide at the final time. */
static void study_collapse(struct study *s)
{
    static const size_t sizes[] = {10, 30, 100};
    const uint64_t starts = own.starts ? own.starts : 10;
    struct disks d;
    TABLE_COLUMNS(s->out, {"e", "", "restitution"},
                  {"p_10", "", "fraction of starts that collapse, N = 10"},
                  {"p_30", "", "the same, N = 30"},
                  {"p_100", "", "the same, N = 100"});
    for (double e = 0.05; e < 0.99 && !progress_signal(); e += 0.05) {
        double row[4] = {e};
        for (int k = 0; k < 3; ++k) {
            double collapsed = 0;
            for (uint64_t i = 0; i < starts; ++i) {
                collapsed += collapses(&d, sizes[k], e, s->seed + i);
                disks_free(&d);
            }
            row[k + 1] = collapsed / (double)starts;
        }
        table_row(s->out, 4, row);
    }
    double last = 0;
    table_print(s->out, "\n\n# the end: x y, 1 if it collides for ever\n");
    collapses(&d, 100, 0.4, s->seed);
    for (size_t i = 0; i < d.count; ++i) {
        double place[DISKS_AXES];
        disks_position(&d, i, place);
        table_print(s->out, "%.6f %.6f %d\n", place[0], place[1],
                    d.disk[i].since == d.now);
        last += d.disk[i].since == d.now;
    }
    TABLE_RESULTS(s->summary, {"bound", last}, {"time", d.now},
                  {"collisions", (double)d.collisions});
    disks_free(&d);
}

/* Runs the slow engine, which examines all pairs before every collision. */
static void run_pairs(struct disks *d, uint64_t collisions)
{
    while (d->collisions < collisions)
        disks_collide(d, disks_next(d));
}

/* Returns the collisions per second of processor time, including collisions
   with walls, measured over at least 0.05 s. */
static double speed_of(struct disks *d, bool plan)
{
    const uint64_t before = d->collisions + d->wall_collisions;
    const double start = bench_seconds();
    const double portion = plan ? 1 + 1e6 / (double)d->count
                                : 1 + 1e6 / pow((double)d->count, 2);
    double seconds = 0;
    while (seconds < 0.05) {
        const uint64_t goal = d->collisions + (uint64_t)portion;
        if (plan)
            disks_run(d, INFINITY, goal);
        else
            run_pairs(d, goal);
        seconds = bench_seconds() - start;
    }
    return (double)(d->collisions + d->wall_collisions - before) / seconds;
}

/* Measures the speed of both engines. Each engine has its own gas and
   continues its run from round to round. */
static void study_speed(struct study *s)
{
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"N", "", "disks"},
                  {"pairs", "1/s", "collisions, every pair looked at"},
                  {"plan", "1/s", "collisions, a plan remembered"});
    for (size_t n = 4; n <= 1024 && !progress_signal(); n *= 2) {
        const double length = sqrt((double)n * 0.785398163397448 / 0.3);
        double row[] = {(double)n, 0, 0};
        struct random r;
        struct disks d[2];
        for (int way = 0; way < 2; ++way) {
            random_seed(&r, s->seed);
            begin_or_exit(&d[way], n, 0.5, length, 1, &r);
        }
        BENCH_TURNS(way, 2, row + 1, speed_of(&d[way], way == 1));
        disks_free(&d[0]);
        disks_free(&d[1]);
        table_row(s->out, 3, row);
    }
}

/* Returns Z = P V/(N kT) of a run of `collisions` collisions and adds its
   processor time to *seconds. The result is biased by about one event,
   because the run ends at a collision. This bias is below the noise even in
   the shortest runs. */
static double pressure_of(uint64_t collisions, uint64_t seed, bool plan,
                          double *seconds)
{
    struct disks d;
    begin_four(&d, 1, seed);
    disks_run(&d, INFINITY, 400);
    disks_settle(&d);
    if (!disks_plan(&d))
        return 0;
    const double start = bench_seconds();
    if (plan)
        disks_run(&d, INFINITY, collisions);
    else
        run_pairs(&d, collisions);
    *seconds += bench_seconds() - start;
    const double z =
        (d.impulse[0] + d.impulse[1]) / (4 * disks_energy(&d) * d.now);
    disks_free(&d);
    return z;
}

enum { RUNS = 32 };

static const double reference = 2.69889; /* direct sampling, +- 0.00031 */

/* Fills row[1], ..., row[4] with the mean times of both engines and with
   the error and the bias of Z, for runs of row[0] collisions. Returns the
   number of runs in which Z differs between the engines. A difference of a
   single bit anywhere in a run would eventually change Z. */
static double find_errors(uint64_t seed, double row[5])
{
    const uint64_t count = (uint64_t)row[0];
    double different = 0;
    for (uint64_t run = 0; run < RUNS; ++run) {
        const double z = pressure_of(count, seed + run, true, &row[2]);
        const double off = z - reference;
        different += z != pressure_of(count, seed + run, false, &row[1]);
        row[3] += off * off;
        row[4] += off;
    }
    for (int k = 1; k < 5; ++k)
        row[k] /= RUNS;
    row[3] = sqrt(row[3]);
    return different;
}

static void study_pressure(struct study *s)
{
    double different = 0;
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"n", "", "collisions of a run"},
                  {"pairs", "s", "processor time, every pair looked at"},
                  {"plan", "s", "processor time, a plan remembered"},
                  {"error", "", "rms of Z - 2.69889"},
                  {"bias", "", "mean of Z - 2.69889"});
    for (double n = 100; n <= (double)own.samples && !progress_signal();
         n *= sqrt(10)) {
        double row[5] = {floor(n)};
        different += find_errors(s->seed, row);
        table_row(s->out, 5, row);
    }
    table_real(s->summary, "different", different);
}

static const struct study_entry studies[] = {
    {"clock", study_clock, "three programs, right and wrong",
     STUDY_KEYS({"Z_<program>", "1", "P V/(N kT) at the walls across x"},
                {"overlap_<program>", "m", "deepest seen"},
                {"energy_<program>", "1", "relative change"},
                {"edge_<program>", "%",
                 "density at the edge, off direct sampling"})},
    {"timeline", study_timeline, "what they write down", NULL},
    {"reverse", study_reverse, "how soon the way back is lost",
     STUDY_KEYS({"miss_5", "m", "1 J: median miss, 5 s and back"},
                {"miss_8", "m", "1 J: the same, 8 s"},
                {"collisions", "1", "1 J: mean of 8 s, one way"},
                {"rate_1", "1/s", "growth of the miss, 1 J"},
                {"rate_4", "1/s", "the same, 4 J"})},
    {"contact", study_contact, "errors of the time of contact",
     STUDY_KEYS({"time", "1", "grazing by 2^-40: error of the time"},
                {"place", "1", "the same: error of the distance then"},
                {"book", "1", "gap 2^-26: relative error, textbook's root"},
                {"ours", "1", "the same, stable root"},
                {"book_exact", "1", "textbook's root, exact places"},
                {"ours_exact", "1", "stable root, exact places"})},
    {"collapse", study_collapse, "disks that collide for ever",
     STUDY_KEYS({"bound", "1", "of 100 disks: collide for ever"},
                {"time", "s", "of the collapse"},
                {"collisions", "1", "until then"})},
    {"speed", study_speed, "collisions in a second", NULL},
    {"pressure", study_pressure, "its error against time",
     STUDY_KEYS({"different", "1", "runs in which the engines differ"})},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study clock, timeline"},
    {"every", 'e', "DT", "time step, s (0.01)"},
    {"", 0, NULL, "--study clock, pressure"},
    {"samples", 'k', "K",
     "clock: how many; pressure: longest run (1000000)"},
    {"", 0, NULL, "--study reverse, contact, collapse"},
    {"starts", 'n', "N",
     "how many: reverse (101), contact: pairs (1000),\n"
     "collapse (10)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'e': own.every = options_real(o, 1e-6, 1); break;
    case 'k': own.samples = options_count(o, 1, 1000000000); break;
    case 'n': own.starts = options_count(o, 1, MOST_STARTS); break;
    }
}

STUDY_MAIN(.name = PROGRAM,
           .purpose = "Measure hard disks, and what fails.",
           .events = "collisions", .studies = studies, .seeds = UINT64_MAX,
           .drawing = "--study clock, timeline, reverse, contact, "
                      "collapse, pressure",
           .options = entries, .take = take_option)
