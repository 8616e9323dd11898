/* Measures the collisions per second of each engine for disks. */
#include "box/cells.h"
#include "toolbox/bench.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"

#include <math.h>
#include <string.h>

#define PROGRAM "disks-speed"

enum {
    SIZES = 16,        /* maximum number of rows in a table */
    PAIRS_MOST = 10000 /* maximum for the all-pairs engine */
};

/* Settings from the command line. */
static struct {
    size_t dimensions, sizes;
    double packing, particles[SIZES];
    bool steps;
    uint64_t collisions; /* per round; 0: run each round for 0.2 s */
    uint64_t seed;
    const char *output, *summary, *command;
} own = {.dimensions = 2,
         .sizes = 5,
         .particles = {1e2, 1e3, 1e4, 1e5, 1e6},
         .packing = 0.3,
         .summary = "/dev/null"};

/* Returns whether the lattice must be melted before the timing. A crystal
   would be faster than a fluid, because its disks keep their neighbours.
   There is no melting above the freezing density, or with --collisions,
   because the run is then too short to melt a dense lattice. */
static bool is_fluid(void)
{
    return own.packing <= (own.dimensions == 2 ? 0.70 : 0.494) &&
           !own.collisions;
}

/* Returns the initial diameter, m. A fluid starts as a thin gas of small
   disks, which warm_up grows to diameter 1. */
static double first_diameter(void)
{
    const double thin = fmin(0.3 / own.packing, 1);
    if (!is_fluid())
        return 1;
    return own.dimensions == 2 ? sqrt(thin) : cbrt(thin);
}

/* Places `count` disks of mass 1 kg, with kT = 1 J, on a lattice in a
   periodic box. Ends the program if there is no memory or no room. */
static void begin_or_exit(struct disks *d, size_t count)
{
    const double pi = 3.14159265358979324;
    const double each = own.dimensions == 2 ? pi / 4 : pi / 6;
    const double volume = (double)count * each / own.packing;
    struct random r;
    random_seed(&r, 1);
    program_memory(disks_create(d, own.dimensions, count), "for the disks");
    d->boundary = DISKS_PERIODIC;
    for (size_t k = 0; k < d->dimensions; ++k)
        d->box[k] = own.dimensions == 2 ? sqrt(volume) : cbrt(volume);
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = first_diameter() / 2;
    if (!disks_place_lattice(d))
        program_give_up("--packing: the disks have no room on a lattice");
    disks_set_temperature(d, 1, &r);
}

/* Copies all disks for the all-pairs engine. Ends the program if there is
   no memory. */
static void copy_or_exit(struct disks *to, const struct disks *from)
{
    const size_t n = from->count;
    program_memory(disks_create(to, from->dimensions, n), "for the disks");
    struct disk *disk = to->disk;
    double *mass = to->mass;
    uint32_t *hits = to->hits;
    *to = *from;
    to->plan = NULL;
    to->disk = memcpy(disk, from->disk, n * sizeof *disk);
    to->mass = memcpy(mass, from->mass, n * sizeof *mass);
    to->hits = memcpy(hits, from->hits, n * sizeof *hits);
    program_memory(disks_plan(to), "for the plans");
}

struct engines {
    struct disks pairs; /* run by the all-pairs engine */
    struct disks disks; /* run by `cells` */
    struct cells cells;
};

/* Runs `more` collisions in portions and checks for signals after each
   portion. */
static void run_collisions(struct engines *e, bool fast, uint64_t more)
{
    const struct disks *d = fast ? &e->disks : &e->pairs;
    const uint64_t end = d->collisions + more, portion = 100000;
    for (uint64_t next = d->collisions;
         d->collisions == next && next < end && !progress_signal();) {
        next += end - next < portion ? end - next : portion;
        if (fast)
            cells_run(&e->cells, INFINITY, next);
        else
            disks_run(&e->pairs, INFINITY, next);
    }
}

/* Returns the number of collisions per second in one round. A round has
   own.collisions collisions, if that is not zero. Otherwise it runs
   portions until 0.2 s have passed. The portions of the all-pairs engine
   are smaller, because it is slower. */
static double speed_of(struct engines *e, bool fast)
{
    const struct disks *d = fast ? &e->disks : &e->pairs;
    const uint64_t portion = own.collisions ? own.collisions
                             : fast         ? 10000
                                            : 1 + 100000 / d->count;
    const uint64_t before = d->collisions;
    const double start = bench_seconds();
    double seconds = 0;
    do {
        run_collisions(e, fast, portion);
        seconds = bench_seconds() - start;
    } while (!own.collisions && seconds < 0.2);
    return (double)(d->collisions - before) / seconds;
}

/* Measures the collisions per second of both engines. Sets *pairs to NaN if
   there are too many disks for the all-pairs engine. */
static void compare(struct engines *e, double *pairs, double *cells)
{
    const bool both = e->disks.count <= PAIRS_MOST;
    double speed[] = {0, NAN};
    BENCH_TURNS(k, both ? 2 : 1, speed, speed_of(e, k == 0));
    *cells = speed[0];
    *pairs = speed[1];
}

/* Returns the memory per disk in bytes. Call at the end of the run, when
   the cell and neighbour lists have reached their final size. */
static double bytes_each(const struct cells *c)
{
    const struct disks *d = c->d;
    const double disk = sizeof *d->disk + sizeof *d->mass + sizeof *d->hits;
    const double own =
        sizeof *c->anchor + (double)c->seats * sizeof *c->neighbour;
    const double event = sizeof *c->calendar.event;
    const double cell =
        sizeof *c->full +
        (double)c->room * (DISKS_AXES * sizeof *c->place + sizeof *c->who);
    const double days =
        ((double)c->calendar.days + 1) * sizeof *c->calendar.day;
    return disk + own + event +
           (cell * (double)c->cells + days) / (double)d->count;
}

/* Writes the table head. The columns `stale` and `renewed` count stale
   events and new neighbour lists per collision. They show, without a clock,
   that the work per collision does not depend on N. */
static void write_head(struct table *t)
{
    static const char *const asked[] = {"one by one", "four at a time",
                                        "eight at a time"};
    table_begin(t, own.command, 1);
    bench_machine(t);
    table_print(t, "# neighbours of cells: %s\n", asked[cells_lanes() / 4]);
    if (own.steps) {
        TABLE_COLUMNS(t, {"step", "", "what is there"},
                      {"speed", "1/us", "collisions of processor time"});
        return;
    }
    TABLE_COLUMNS(t, {"N", "", "disks or spheres"},
                  {"pairs", "1/s", "collisions a second of processor time"},
                  {"cells", "1/s", "collisions a second of processor time"},
                  {"bytes", "B", "of memory for a disk, with cells"},
                  {"stale", "", "stale events for a collision"},
                  {"renewed", "", "lists made anew for a collision"});
}

/* Measures the speed gained by each optimization of the chapter, by
   removing one after another. First the neighbours are examined one at a
   time instead of several at once. Then the calendar gets a single day of
   infinite length, so every search scans all events, as in the all-pairs
   engine. */
static void write_steps(struct engines *e, struct table *out)
{
    struct calendar *calendar = &e->cells.calendar;
    double pairs, lanes, cells, neighbours;
    compare(e, &pairs, &lanes);
    e->cells.lanes = 1;
    compare(e, &pairs, &cells);
    calendar->width = INFINITY;
    for (uint32_t i = 0; i < e->disks.count; ++i)
        calendar_put(calendar, i, calendar->event[i].time);
    compare(e, &pairs, &neighbours);
    table_print(out,
                "pairs %.3g\nneighbours %.3g\ncalendar %.3g\nlanes %.3g\n",
                pairs / 1e6, neighbours / 1e6, cells / 1e6, lanes / 1e6);
}

static const struct options_entry entries[] = {
    {"particles", 'N', "N1,N2,..", "numbers of disks (100,1000,..,1e6)"},
    {"packing", 'p', "P", "fraction of the box filled (0.3)"},
    {"dimensions", 'd', "D", "2 or 3 (2)"},
    {"steps", 'x', NULL, "time what each step of the chapter has bought"},
    {"collisions", 'c', "C", "of a round, unmelted (as many as in 0.2 s)"},
    {OPTIONS_OUTPUT("table")},
    {"", 0, NULL, "no --steps"},
    {OPTIONS_SUMMARY},
    {0}};

static const struct table_key keys[] = {
    {"", "", "if not --steps:"},
    {"cells_<N>", "1/s", "collisions, cells, N disks"},
    {"bytes_<N>", "B", "of memory for a disk"},
    {"cells/pairs_<N>", "1", "ratio of speeds; nan: too many for pairs"},
    {0}};

static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    options_begin(&o, PROGRAM, "Time the engines of disks.", entries, argc,
                  argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        switch (option) {
        case 'N':
            own.sizes = options_list(&o, own.particles, SIZES);
            for (size_t k = 0; k < own.sizes; ++k)
                if (!(own.particles[k] >= 3 &&
                      own.particles[k] <= DISKS_MOST) ||
                    own.particles[k] != floor(own.particles[k]))
                    options_fail(&o,
                                 "%g is not a whole number from 3 to %d",
                                 own.particles[k], DISKS_MOST);
            break;
        case 'p': own.packing = options_real(&o, 1e-9, 1); break;
        case 'd': own.dimensions = options_count(&o, 2, 3); break;
        case 'c':
            own.collisions = options_count(&o, 1, 1000000000000);
            break;
        case 'x': own.steps = true; break;
        case 'o': own.output = options_text(&o); break;
        case 'S': own.summary = options_text(&o); break;
        }
    own.command = options_command(&o);
    program_apart(&o, own.output, own.summary, "table");
}
static void make_cells(struct engines *e)
{
    cells_free(&e->cells);
    if (!cells_suit(&e->disks))
        program_give_up(
            "--particles: too few for three cells along each side");
    program_memory(cells_create(&e->cells, &e->disks), "for the cells");
}

/* Returns the new radius of disk i (in m), which fills nine tenths of the
   gap to its nearest neighbour. If it filled the whole gap, thousands of
   disks would touch and collide at the same time, and no calendar day
   would be short enough for so many events. */
static double grown_radius(const struct cells *c, size_t i)
{
    const struct disk *disk = c->d->disk;
    const uint32_t *list = c->neighbour + i * c->seats;
    double here[DISKS_AXES], there[DISKS_AXES], way[DISKS_AXES];
    double most = disk[i].radius + c->skin;
    disks_position(c->d, i, here);
    for (size_t k = 0; k < c->anchor[i].neighbours; ++k) {
        disks_position(c->d, list[k], there);
        disks_separation(c->d, here, there, way);
        const double square =
            way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
        most = fmin(most, sqrt(square) - disk[list[k]].radius);
    }
    const double gap = fmax(most - disk[i].radius, 0);
    return fmin(disk[i].radius + 0.9 * gap, 0.5);
}

/* Grows all disks. Returns whether every disk has reached its final size.
   The neighbour lists must be new: disks that are not in each other's lists
   are then at least two skins apart. They cannot overlap afterwards,
   because no radius grows by a whole skin. */
static bool grow(struct engines *e)
{
    bool whole = true;
    for (size_t i = 0; i < e->disks.count; ++i) {
        const double radius = grown_radius(&e->cells, i);
        e->disks.disk[i].radius = radius;
        whole = whole && radius == 0.5;
    }
    return whole;
}

/* Runs until the initial state has no influence. Only the engine with cells
   runs here, because the results of both are bit-identical and the
   all-pairs engine would take an hour.

   Small disks alternately grow and move. When they reach full size, they
   are still too close together: at packing 0.70, Z is 11.1 and takes
   several hundred collisions per disk to fall to the fluid's value of 10.3.
   Therefore three million collisions follow. */
static void warm_up(struct engines *e)
{
    const uint64_t n = e->disks.count;
    bool whole = e->disks.disk[0].radius == 0.5;
    make_cells(e);
    run_collisions(e, true, own.collisions ? own.collisions : 5 * n);
    while (!whole && !progress_signal()) {
        disks_settle(&e->disks);
        make_cells(e);
        whole = grow(e);
        make_cells(e);
        run_collisions(e, true, whole ? 5 * n + 3000000 : n);
    }
}

/* Returns the number of tiles along each axis, or 1 for a box without
   tiles. Melting a million disks would take minutes, so only a few thousand
   are melted, as a tile that is then copied side by side. */
static size_t tiles_along(size_t count)
{
    size_t along = 1;
    for (size_t k = 2; is_fluid(); ++k) {
        const size_t tiles = own.dimensions == 2 ? k * k : k * k * k;
        if (count / tiles < 4000)
            break;
        along = count % tiles == 0 ? k : along;
    }
    return along;
}

/* Replaces the disks by copies of them, arranged side by side. Each copy
   gets its own random velocities, so no two tiles are alike after five
   collisions per disk. */
static void lay_tiles(struct engines *e, size_t along, size_t count)
{
    struct disks tile = e->disks, *d = &e->disks;
    begin_or_exit(d, count);
    for (size_t k = 0; k < d->dimensions; ++k)
        d->box[k] = (double)along * tile.box[k];
    for (size_t i = 0; i < count; ++i) {
        size_t at = i / tile.count;
        const struct disk *like = &tile.disk[i % tile.count];
        d->disk[i].radius = like->radius;
        for (size_t k = 0; k < d->dimensions; ++k, at /= along)
            d->disk[i].position[k] =
                like->position[k] + (double)(at % along) * tile.box[k];
    }
    disks_free(&tile);
}

/* Makes the disks that are timed. With --collisions the warm-up has
   as many collisions as a round. */
static void make_fluid(struct engines *e, size_t count)
{
    const size_t along = tiles_along(count);
    const size_t plane = along * along;
    begin_or_exit(&e->disks,
                  count / (own.dimensions == 2 ? plane : plane * along));
    warm_up(e);
    if (along == 1)
        return;
    disks_settle(&e->disks);
    lay_tiles(e, along, count);
    make_cells(e);
    run_collisions(e, true, 5 * count);
}

static void time_size(size_t count, struct table *out,
                      struct table *summary)
{
    struct engines e = {0};
    double pairs, cells;
    make_fluid(&e, count);
    if (count <= PAIRS_MOST)
        copy_or_exit(&e.pairs, &e.disks);
    if (own.steps)
        write_steps(&e, out);
    else {
        compare(&e, &pairs, &cells);
        const double n = (double)e.disks.count;
        const double collisions = (double)e.disks.collisions;
        table_print(out, "%-8.0f %9.4g %9.4g %6.1f %6.3f %6.3f\n", n, pairs,
                    cells, bytes_each(&e.cells),
                    (double)e.cells.stale / collisions,
                    (double)e.cells.renewed / collisions);
        table_keyed(summary, cells, "cells_%.0f", n);
        table_keyed(summary, bytes_each(&e.cells), "bytes_%.0f", n);
        table_keyed(summary, cells / pairs, "cells/pairs_%.0f", n);
    }
    cells_free(&e.cells);
    disks_free(&e.disks);
    disks_free(&e.pairs);
}

int main(int argc, char *argv[])
{
    struct progress progress;
    read_settings(argc, argv);
    struct table *out, *summary;
    program_open(own.output, own.summary, keys, &out, &summary);
    progress_begin(&progress, PROGRAM, own.sizes, "sizes");
    write_head(out);
    for (size_t k = 0; k < own.sizes && !progress_signal(); ++k) {
        time_size((size_t)own.particles[k], out, summary);
        progress_update(&progress, k + 1, k + 1);
    }
    return program_close(out, summary, progress_end(&progress));
}
