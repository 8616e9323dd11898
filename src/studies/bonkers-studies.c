/* Measures engines for bodies on a line: speed, drift, reversal, steps. */
#include "line/bonkers.h"
#include "line/collide.h"
#include "toolbox/bench.h"
#include "toolbox/quad.h"
#include "toolbox/random.h"
#include "toolbox/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PROGRAM "bonkers-studies"

static struct {
    uint64_t most; /* maximum number of collisions; in study_speed, of
                      particles */
    double until;
} own = {.most = 1000000, .until = 10};

/* Makes the bodies of a request and starts a run. Ends the program if there
   is no memory. */
static void begin_or_exit(struct bonkers *b,
                          const struct start_request *request,
                          enum bonkers_engine engine)
{
    struct start start;
    size_t wrong = 0;
    program_memory(start_fill(&start, request) &&
                       bonkers_begin(b, &start, 1, engine, &wrong) &&
                       wrong >= b->gaps,
                   "for the particles");
    start_free(&start);
}

/* A small engine that examines all gaps. It computes in the compiler's
   widest floating-point type. It either keeps this precision, which gives
   the true motion, or rounds every result to a lower one. Results rounded
   to float are exactly those of single-precision hardware: if float has p
   digits, the widest type has more than 2 p + 2, and rounding first to the
   widest type and then to float gives the same as rounding once. */
enum { LINE_BODIES = 32 }; /* maximum number of bodies in a line */

enum line_kind {
    LINE_WIDE,   /* the widest precision: the true motion */
    LINE_SINGLE, /* float */
    LINE_BIASED  /* double, difference form (1.8, eq:restitution) */
};

struct line {
    size_t gaps;
    enum line_kind kind;
    uint64_t collisions;
    quad now, x[LINE_BODIES], v[LINE_BODIES], im[LINE_BODIES];
};

/* Rounds a result to the precision of the line. All results pass through
   this function. The precision has no other effect, except on the choice of
   the collision formula. */
static quad rounded(const struct line *l, quad value)
{
    return l->kind == LINE_SINGLE   ? (quad)(float)value
           : l->kind == LINE_BIASED ? (quad)(double)value
                                    : value;
}

static void line_copy(struct line *l, const struct bonkers *b,
                      enum line_kind kind)
{
    *l = (struct line){.gaps = b->gaps, .kind = kind};
    for (size_t i = 0; i <= b->gaps && i < LINE_BODIES; ++i) {
        l->x[i] = rounded(l, b->body[i].x);
        l->v[i] = rounded(l, b->body[i].v);
        l->im[i] = rounded(l, b->body[i].im);
    }
}

/* Returns the time until the next gap closes, or a negative number if no
   gap closes. Sets *first to that gap. */
static quad line_wait(const struct line *l, size_t *first)
{
    quad least = -1;
    for (size_t i = 0; i < l->gaps; ++i) {
        const quad approach = rounded(l, l->v[i] - l->v[i + 1]);
        const quad gap = rounded(l, l->x[i + 1] - l->x[i]);
        if (!(approach > 0))
            continue;
        const quad wait = gap > 0 ? rounded(l, gap / approach) : 0;
        if (least < 0 || wait < least) {
            least = wait;
            *first = i;
        }
    }
    return least;
}

static void line_move(struct line *l, quad wait)
{
    for (size_t i = 0; i <= l->gaps; ++i)
        l->x[i] = rounded(l, l->x[i] + rounded(l, l->v[i] * wait));
    l->now = rounded(l, l->now + wait);
}

/* Collides the neighbours of gap i by (1.12, eq:smaller), or by the
   difference form if the line is LINE_BIASED. */
static void line_collide(struct line *l, size_t i)
{
    const quad a = l->im[i], b = l->im[i + 1], sum = rounded(l, a + b);
    const quad change = rounded(l, 2 * (l->v[i] - l->v[i + 1]));
    quad part_a = rounded(l, change * rounded(l, a / sum));
    quad part_b = rounded(l, change * rounded(l, b / sum));
    if (l->kind != LINE_BIASED && a < b)
        part_b = rounded(l, change - part_a);
    else if (l->kind != LINE_BIASED)
        part_a = rounded(l, change - part_b);
    l->v[i] = rounded(l, l->v[i] - part_a);
    l->v[i + 1] = rounded(l, l->v[i + 1] + part_b);
    ++l->collisions;
}

/* Runs until n collisions have taken place. Returns the line. The bodies
   are between two walls, so there is always another collision. */
static struct line *line_run(struct line *l, uint64_t n)
{
    while (l->collisions < n) {
        size_t first = 0;
        line_move(l, line_wait(l, &first));
        line_collide(l, first);
    }
    return l;
}

static void line_run_to(struct line *l, quad t)
{
    size_t first = 0;
    quad wait;
    while ((wait = line_wait(l, &first)) >= 0 && l->now + wait < t) {
        line_move(l, wait);
        line_collide(l, first);
    }
    line_move(l, t - l->now);
}

/* Returns the energy. The sum is not rounded to the line's precision,
   because it must be more accurate than the errors it measures. */
static double line_energy(const struct line *l)
{
    quad sum = 0;
    for (size_t i = 1; i < l->gaps; ++i)
        sum += l->v[i] * l->v[i] / l->im[i];
    return (double)(sum / 2);
}

/* Returns the number of collisions per second, measured over at least 0.05
   s. The two slow engines run for a number of collisions instead of a time.
   With a million bodies, finding out that the next collision is too late
   takes as long as a collision. */
static double speed_of(struct bonkers *b)
{
    const double n = (double)b->gaps, portion = fmax(4, 1e5 / n);
    const uint64_t before = b->collisions;
    const double start = bench_seconds();
    double seconds = 0;
    while (seconds < 0.05) {
        if (b->engine < BONKERS_HEAP)
            bonkers_run(b, INFINITY,
                        b->collisions + 1 + (uint64_t)(1e6 / n));
        else
            bonkers_run(b, b->now + portion, UINT64_MAX);
        seconds = bench_seconds() - start;
    }
    return (double)(b->collisions - before) / seconds;
}

/* Runs the same gas with all engines. Sets speed[e] to the median speed of
   engine e in collisions per second, and speed[0] to the percentage of
   collisions that the slab engine computed twice. The engines take turns,
   because the clock rate of a processor changes. The first round is a
   warm-up. */
static void compare_engines(struct study *s, size_t movers,
                            double speed[BONKERS_ENGINES])
{
    const struct start_request request = {
        .kind = START_RANDOM, .movers = movers, .seed = s->seed};
    struct bonkers b[BONKERS_ENGINES];
    for (int e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        begin_or_exit(&b[e], &request, (enum bonkers_engine)e);
    BENCH_TURNS(e, BONKERS_ENGINES - BONKERS_NAIVE, speed + BONKERS_NAIVE,
                speed_of(&b[BONKERS_NAIVE + e]));
    const struct bonkers *slab = &b[BONKERS_SLAB];
    speed[0] = 100 * (double)slab->redone / (double)slab->collisions;
    for (int e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        bonkers_free(&b[e]);
}

/* Numbers of particles. The small numbers are closely spaced, to show where
   other engines overtake the scan. */
static const size_t sizes[] = {4,    10,    30,     100,
                               1000, 10000, 100000, 1000000};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

/* Writes the results that require the speeds for all sizes, up to a million
   particles. */
static void note_large(struct table *summary,
                       double speed[SIZES][BONKERS_ENGINES])
{
    double most = 0, least = INFINITY;
    for (int k = 4; k < 8; ++k) {
        most = fmax(most, speed[k][BONKERS_SLAB]);
        least = fmin(least, speed[k][BONKERS_SLAB]);
    }
    const double *thousand = speed[4], *million = speed[7];
    TABLE_RESULTS(
        summary,
        {"slab/naive", million[BONKERS_SLAB] / million[BONKERS_NAIVE]},
        {"heap-slowdown", thousand[BONKERS_HEAP] / million[BONKERS_HEAP]},
        {"slab-spread", most / least}, {"redone-percent", million[0]});
}

static void study_speed(struct study *s)
{
    double speed[SIZES][BONKERS_ENGINES];
    size_t n = 0;
    bench_machine(s->out);
    table_column(s->out, "N", "", "particles");
    for (int e = BONKERS_NAIVE; e < BONKERS_ENGINES; ++e)
        table_column(s->out, bonkers_engine_names[e], "1/s",
                     "collisions a second of processor time");
    progress_begin(&s->progress, PROGRAM, SIZES, "sizes");
    for (; n < SIZES && sizes[n] <= own.most && !progress_signal(); ++n) {
        compare_engines(s, sizes[n], speed[n]);
        table_print(s->out, "%-7zu %9.4g %9.4g %9.4g %9.4g\n", sizes[n],
                    speed[n][1], speed[n][2], speed[n][3], speed[n][4]);
        /* Compare each engine with the previous one. */
        for (int e = BONKERS_SCAN; e < BONKERS_ENGINES; ++e)
            table_keyed(s->summary, speed[n][e] / speed[n][e - 1],
                        "%s/%s-%zu", bonkers_engine_names[e],
                        bonkers_engine_names[e - 1], sizes[n]);
        table_keyed(s->summary,
                    speed[n][BONKERS_SLAB] / speed[n][BONKERS_SCAN],
                    "slab/scan-%zu", sizes[n]);
        progress_update(&s->progress, n, 0);
    }
    if (n == SIZES)
        note_large(s->summary, speed);
}

/* Collides two masses with random velocities. Writes the percentage of
   collisions in which g - q is exactly halfway between two doubles, and the
   percentage of these ties that are rounded up. Section "A coin that is not
   fair" explains g and q.

   The widest type stores the exact difference. In a tie, the rounding error
   of `rest` is half the distance to the next double. */
static void throw_coins(struct table *summary, const char *name,
                        double mass1, double mass2)
{
    enum { THROWS = 1000000 };
    const double a = 1 / mass1, b = 1 / mass2;
    const double smaller = (a < b ? a : b) / (a + b);
    struct random r;
    int ties = 0, up = 0;
    random_seed(&r, 1);
    for (int k = 0; k < THROWS; ++k) {
        const double u1 = random_normal(&r), u2 = random_normal(&r);
        const double g = 2 * fabs(u1 - u2), q = g * smaller, rest = g - q;
        const double error = (double)(rest - ((quad)g - q));
        const bool tie =
            fabs(error) == (nextafter(rest, INFINITY) - rest) / 2;
        ties += tie;
        up += tie && error > 0;
    }
    table_keyed(summary, 100.0 * ties / THROWS, "ties_%s", name);
    table_keyed(summary, ties > 0 ? 100.0 * up / ties : 0, "up_%s", name);
}

enum { SINGLE_MOST = 200000 }; /* limit for single precision */

/* Returns the smallest of the numbers 1, 2, 5, 10, ... that is greater than
   n. They are almost evenly spaced on a logarithmic axis. */
static uint64_t next_stop(uint64_t n)
{
    uint64_t decade = 1;
    while (10 * decade <= n)
        decade *= 10;
    return n < 2 * decade   ? 2 * decade
           : n < 5 * decade ? 5 * decade
                            : 10 * decade;
}

/* Measures the energy error in three runs: START_MIXED in double precision,
   three bodies whose energy drifts from the beginning, and START_MIXED in
   single precision, which is slow and stops after SINGLE_MOST collisions.

   The errors in double precision start at zero, because the initial energy
   comes from the same function as the later ones. The single-precision run
   is compared with the same initial energy. Its error starts at 1e-8,
   because its initial state is rounded. */
static void study_drift(struct study *s)
{
    const struct start_request request = {.kind = START_MIXED};
    struct bonkers mixed, whole;
    struct line single;
    double error[3] = {0};
    begin_or_exit(&mixed, &request, BONKERS_SCAN);
    line_copy(&single, &mixed, LINE_SINGLE);
    program_memory(bonkers_create(&whole, 3, 1, BONKERS_SCAN),
                   "for the particles");
    whole.body[1] = (struct bonkers_body){1, 1, 0, 1};
    whole.body[2] = (struct bonkers_body){2, -0.3, 0, 0.5};
    whole.body[3] = (struct bonkers_body){3, 0.77, 0, 1 / 1.5};
    whole.body[4].x = 4;
    bonkers_start(&whole, NULL);
    const double mixed_energy = bonkers_energy(&mixed);
    const double whole_energy = bonkers_energy(&whole);
    progress_begin(&s->progress, PROGRAM, own.most, "collisions");
    TABLE_COLUMNS(s->out, {"n", "", "collisions"},
                  {"double", "", "relative error of the energy"},
                  {"whole", "", "the same, masses 1, 2 and 1.5"},
                  {"float", "", "the same in single precision"});
    for (uint64_t n = 100; n <= own.most && !progress_signal();
         n = next_stop(n)) {
        bonkers_run(&mixed, INFINITY, n);
        bonkers_run(&whole, INFINITY, n);
        error[0] = bonkers_energy(&mixed) / mixed_energy - 1;
        error[1] = bonkers_energy(&whole) / whole_energy - 1;
        if (n <= SINGLE_MOST)
            error[2] = line_energy(line_run(&single, n)) / mixed_energy - 1;
        TABLE_ROW(s->out, (double)n, error[0], error[1],
                  n <= SINGLE_MOST ? error[2] : NAN);
        progress_update(&s->progress, n, n);
    }
    TABLE_RESULTS(s->summary, {"energy_error", error[0]},
                  {"energy_error_whole", error[1]},
                  {"energy_error_float", error[2]});
    throw_coins(s->summary, "whole", 1, 2);
    throw_coins(s->summary, "mixed", 1, 1 / 0.9);
    bonkers_free(&mixed);
    bonkers_free(&whole);
}

/* Runs n collisions, reverses all velocities and runs for the same time
   again. Returns the largest distance of a body from its initial position
   (in m), which would be zero without rounding. The initial positions are
   those of `start`: equal requests give bit-identical bodies. */
static double miss(enum bonkers_engine engine, uint64_t n)
{
    const struct start_request request = {.kind = START_MIXED};
    struct bonkers b, start;
    double worst = 0;
    begin_or_exit(&b, &request, engine);
    begin_or_exit(&start, &request, engine);
    bonkers_run(&b, INFINITY, n);
    const double t = b.now;
    /* Move all bodies to the present time, so that the reversal is
       correct. */
    bonkers_settle(&b);
    for (size_t i = 0; i <= b.gaps; ++i)
        b.body[i].v = -b.body[i].v;
    bonkers_start(&b, NULL);
    bonkers_run(&b, t, UINT64_MAX);
    bonkers_settle(&b);
    for (size_t i = 0; i <= b.gaps; ++i)
        worst = fmax(worst, fabs(b.body[i].x - start.body[i].x));
    bonkers_free(&b);
    bonkers_free(&start);
    return worst;
}

/* Returns the result of `miss` for a struct line. A line moves all bodies
   at every collision, so they need not be moved before the reversal. */
static double line_miss(enum line_kind kind, uint64_t n)
{
    const struct start_request request = {.kind = START_MIXED};
    struct bonkers b;
    struct line l;
    double worst = 0;
    begin_or_exit(&b, &request, BONKERS_SCAN);
    line_copy(&l, &b, kind);
    const double t = (double)line_run(&l, n)->now;
    for (size_t i = 0; i <= l.gaps; ++i)
        l.v[i] = -l.v[i];
    l.now = 0;
    line_run_to(&l, t);
    for (size_t i = 0; i <= l.gaps; ++i)
        worst = fmax(worst, fabs((double)l.x[i] - b.body[i].x));
    bonkers_free(&b);
    return worst;
}

/* Measures how far from its initial state a reversed run ends. A struct
   line is slow, because it rounds every operation, so it runs fewer
   collisions. */
static void study_reverse(struct study *s)
{
    progress_begin(&s->progress, PROGRAM, own.most, "collisions");
    TABLE_COLUMNS(s->out, {"n", "", "collisions there, and as many back"},
                  {"naive", "m", "largest error of a position"},
                  {"scan", "m", "the same"},
                  {"biased", "m", "the same, difference form"},
                  {"float", "m", "the same in single precision"});
    for (uint64_t n = 100; n <= own.most && !progress_signal();
         n = next_stop(n)) {
        const double row[] = {(double)n, miss(BONKERS_NAIVE, n),
                              miss(BONKERS_SCAN, n),
                              n <= 200000 ? line_miss(LINE_BIASED, n) : NAN,
                              n <= 10000 ? line_miss(LINE_SINGLE, n) : NAN};
        table_row(s->out, 5, row);
        progress_update(&s->progress, n, 2 * n);
        char which[24];
        snprintf(which, sizeof which, "%d", (int)n);
        if (n == 1000 || n == 5000 || n == 10000 || n == 100000 ||
            n == 1000000)
            TABLE_RESULTS_OF(s->summary, which, {"scan", row[2]},
                             {"biased", row[3]}, {"float", row[4]});
    }
}

/* Makes `steps` steps of dt. Each step moves all bodies and then collides
   all neighbours that overlap and approach each other. */
static void walk(struct bonkers_body body[], size_t gaps, uint64_t steps,
                 double dt)
{
    for (uint64_t k = 0; k < steps; ++k) {
        for (size_t i = 0; i <= gaps; ++i)
            body[i].x += body[i].v * dt;
        for (size_t i = 0; i < gaps; ++i) {
            struct bonkers_body *l = &body[i], *r = l + 1;
            if (l->x > r->x && l->v > r->v)
                collide(&l->v, &r->v, l->im, r->im, 1);
        }
    }
}

/* Returns the root mean square distance (in m) of the moving bodies from
   their true positions. First moves each body to the time of `truth`. */
static double distance(const struct line *truth,
                       const struct bonkers_body body[])
{
    double sum = 0;
    for (size_t i = 1; i < truth->gaps; ++i) {
        const double flight = (double)truth->now - body[i].since;
        const quad x = body[i].x + body[i].v * flight;
        const double d = (double)(x - truth->x[i]);
        sum += d * d;
    }
    return sqrt(sum / (double)(truth->gaps - 1));
}

/* Returns the mean processor time (in s) of a time-stepped run until the
   time `until`. Stores the final state in body[]. Repeats the run for at
   least 0.02 s, because a single run may be too short for the clock. */
static double time_walk(double until, const struct bonkers *b, double dt,
                        struct bonkers_body body[])
{
    const uint64_t steps = (uint64_t)(until / dt + 0.5);
    const double start = bench_seconds();
    double seconds = 0;
    int times = 0;
    for (; seconds < 0.02; ++times) {
        memcpy(body, b->body, (b->gaps + 1) * sizeof body[0]);
        walk(body, b->gaps, steps, dt);
        seconds = bench_seconds() - start;
    }
    for (size_t i = 0; i <= b->gaps; ++i)
        body[i].since = until;
    return seconds / times;
}

/* Does the same as time_walk for an event-driven run. Each repetition needs
   new bodies, because a run changes them. Making them is not timed. */
static double time_events(double until, const struct start_request *request,
                          struct bonkers_body body[], uint64_t *collisions)
{
    double seconds = 0;
    int times = 0;
    for (; seconds < 0.02; ++times) {
        struct bonkers b;
        begin_or_exit(&b, request, BONKERS_SCAN);
        const double start = bench_seconds();
        bonkers_run(&b, until, UINT64_MAX);
        seconds += bench_seconds() - start;
        *collisions = b.collisions;
        memcpy(body, b.body, (b.gaps + 1) * sizeof body[0]);
        bonkers_free(&b);
    }
    return seconds / times;
}

static void name_steps(struct table *out)
{
    bench_machine(out);
    TABLE_COLUMNS(out, {"dt", "s", "step; 0: event-driven"},
                  {"seconds", "s", "processor time of one run"},
                  {"error", "m", "root mean square error of positions"});
}

/* Writes a row for the event-driven run, which has dt = 0, and then a row
   for each time step. The steps are halved until they are less than 1e-6
   s. */
static void study_steps(struct study *s)
{
    const struct start_request request = {.kind = START_MIXED};
    struct bonkers_body body[LINE_BODIES];
    struct bonkers b;
    struct line truth;
    uint64_t n = 0;
    begin_or_exit(&b, &request, BONKERS_SCAN);
    line_copy(&truth, &b, LINE_WIDE);
    line_run_to(&truth, own.until);
    name_steps(s->out);
    double seconds = time_events(own.until, &request, body, &n), dt = 0.1;
    const double error = distance(&truth, body);
    table_print(s->out, "%-9d %9.4g %9.4g\n", 0, seconds, error);
    for (; dt > 0.9e-6 && !progress_signal(); dt /= 2) {
        seconds = time_walk(own.until, &b, dt, body);
        table_print(s->out, "%-9.4g %9.4g %9.4g\n", dt, seconds,
                    distance(&truth, body));
    }
    table_count(s->summary, "collisions", n);
    TABLE_RESULTS(s->summary, {"error_events", error},
                  {"smallest_step", 2 * dt});
    bonkers_free(&b);
}

/* Returns the number of collisions of two balls with each other and with a
   wall on their left. Returns 0 if the balls collapse, that is, collide
   infinitely often. */
static uint64_t count_until_still(double restitution)
{
    struct bonkers b;
    uint64_t n = 0;
    if (!bonkers_create(&b, 2, restitution, BONKERS_SCAN))
        return 0;
    b.body[1] = (struct bonkers_body){1, 0, 0, 1};
    b.body[2] = (struct bonkers_body){2, -1, 0, 1};
    b.body[3].x = INFINITY;
    bonkers_start(&b, NULL);
    if (bonkers_run(&b, INFINITY, UINT64_MAX) == BONKERS_STILL)
        n = b.collisions;
    bonkers_free(&b);
    return n;
}

/* Counts the collisions for many coefficients of restitution. Theory
   predicts pi/phi rounds of two collisions (2.7, eq:collapse). */
static void study_collapse(struct study *s)
{
    const double pi = acos(-1);
    double border = 0;
    uint64_t next = 0;
    TABLE_COLUMNS(s->out, {"e", "", "restitution"},
                  {"n", "", "collisions; 0: without end"},
                  {"theory", "", "two to a round, pi/phi rounds"});
    for (int k = 40; k <= 300 && !progress_signal(); ++k) {
        const double e = k / 500.0;
        const double cosine = (1 - e) * (1 - e) / (4 * e);
        const uint64_t n = count_until_still(e);
        if (n == 0)
            border = e;
        else if (next == 0)
            next = n;
        TABLE_ROW(s->out, e, (double)n,
                  cosine < 1 ? 2 * pi / acos(cosine) : NAN);
    }
    table_real(s->summary, "border", border);
    table_count(s->summary, "next", next);
}

static const double pull = 9.81, long_run = 900; /* m/s^2; s */

/* Returns the state at the time `long_run` of a ball dropped from 1 m,
   computed with `steps` leapfrog steps. Leapfrog is exact for a falling
   body. The only error is that the bounce takes place at the end of a
   step. */
static struct bonkers_body bounce_in_steps(uint64_t steps)
{
    struct bonkers_body a = {.x = 1};
    const double dt = long_run / (double)steps;
    for (uint64_t k = 0; k < steps; ++k) {
        a.x += a.v * (dt / 2);
        a.v -= pull * dt;
        a.x += a.v * (dt / 2);
        if (a.x < 0 && a.v < 0)
            a.v = -a.v;
    }
    return a;
}

/* Returns the exact height (in m) of a ball at the time `until` after it
   was dropped from `height`. The motion is periodic, so only the time
   since the last bounce matters. */
static double bounced(double height, double until)
{
    const double v = sqrt(2 * pull * height), phase = v / pull + until;
    const double t = fmod(phase, 2 * v / pull);
    return t * (v - pull * t / 2);
}

static struct bonkers_body bounce_by_events(uint64_t *bounces)
{
    struct bonkers b;
    double x[3], v[3];
    program_memory(bonkers_create(&b, 1, 1, BONKERS_SCAN), "for a ball");
    b.gravity = pull;
    b.body[1] = (struct bonkers_body){1, 0, 0, 1};
    b.body[2].x = INFINITY;
    bonkers_start(&b, NULL);
    bonkers_run(&b, long_run, UINT64_MAX);
    bonkers_state(&b, x, v);
    *bounces = b.collisions;
    bonkers_free(&b);
    return (struct bonkers_body){x[1], v[1], 0, 0};
}

/* Equal beads dropped from 0.2 m, 0.4 m, ... Equal beads exchange their
   velocities, so they move like ten independent balls sorted by height. */
enum { BEADS = 10 };

/* Returns the root mean square error of the beads' positions, m. */
static double error_of_beads(const struct bonkers_body body[], double until)
{
    double truth[BEADS], sum = 0;
    for (int i = 0; i < BEADS; ++i)
        truth[i] = bounced(0.2 * (i + 1), until);
    bench_median(truth, BEADS); /* sorts them */
    for (int i = 0; i < BEADS; ++i)
        sum += (body[i + 1].x - truth[i]) * (body[i + 1].x - truth[i]);
    return sqrt(sum / BEADS);
}

/* Makes time steps of dt under gravity. Each step moves the beads by half a
   step, changes their velocities, and calls walk for the second half, which
   also carries out the collisions. */
static void walk_upright(struct bonkers_body body[], double until,
                         double dt)
{
    const uint64_t steps = (uint64_t)(until / dt + 0.5);
    for (uint64_t k = 0; k < steps; ++k) {
        for (int i = 1; i <= BEADS; ++i) {
            body[i].x += body[i].v * (dt / 2);
            body[i].v -= pull * dt;
        }
        walk(body, BEADS + 1, 1, dt / 2);
    }
}

/* Writes a table row for time steps of dt, or for events if dt is 0.
   Repeats the run until it is long enough for the clock. */
static void time_beads(struct table *out, double until, double dt)
{
    struct bonkers_body body[BEADS + 2];
    double seconds = 0;
    int times = 0;
    for (; seconds < 0.02; ++times) {
        struct bonkers b;
        double x[BEADS + 2], v[BEADS + 2];
        program_memory(bonkers_create(&b, BEADS, 1, BONKERS_SCAN),
                       "for the beads");
        for (int i = 1; i <= BEADS; ++i)
            b.body[i] = (struct bonkers_body){0.2 * i, 0, 0, 1};
        b.gravity = pull;
        b.body[BEADS + 1].x = INFINITY;
        bonkers_start(&b, NULL);
        memcpy(body, b.body, sizeof body);
        const double start = bench_seconds();
        if (dt > 0)
            walk_upright(body, until, dt);
        else
            bonkers_run(&b, until, UINT64_MAX);
        seconds += bench_seconds() - start;
        bonkers_state(&b, x, v);
        for (int i = 1; i <= BEADS && dt == 0; ++i)
            body[i].x = x[i];
        bonkers_free(&b);
    }
    table_print(out, "%-9.4g %9.4g %9.4g\n", dt, seconds / times,
                error_of_beads(body, until));
}

static void note_ball(struct table *summary, const char *key,
                      const struct bonkers_body *a)
{
    table_real(summary, key, a->x - bounced(1, long_run));
    table_keyed(summary, a->v * a->v / (2 * pull) + a->x - 1, "%s_energy",
                key);
}

static void study_bounce(struct study *s)
{
    uint64_t bounces;
    const struct bonkers_body by_events = bounce_by_events(&bounces);
    table_count(s->summary, "bounces", bounces);
    note_ball(s->summary, "events", &by_events);
    name_steps(s->out);
    time_beads(s->out, own.until, 0);
    for (double dt = 0.1; dt > 0.9e-6 && !progress_signal(); dt /= 2)
        time_beads(s->out, own.until, dt);
    for (uint64_t n = 90000; n < 100000000 && !progress_signal(); n *= 10) {
        const struct bonkers_body a = bounce_in_steps(n);
        char key[40];
        snprintf(key, sizeof key, "steps_%d", (int)n);
        note_ball(s->summary, key, &a);
    }
}

/* Launches the first body of a row of n bodies at rest (if `right`, the
   last) towards the others at 1 m/s. Returns the number of collisions. The
   masses are random, from 1 to 5 kg, and `gap` is the distance
   between neighbours, m. */
static uint64_t strike(size_t n, uint64_t seed, double gap, bool right)
{
    struct bonkers b;
    struct random r;
    uint64_t count = 0;
    random_seed(&r, seed);
    if (!bonkers_create(&b, n, 1, BONKERS_SCAN))
        return 0;
    b.body[0].x = -INFINITY;
    b.body[n + 1].x = INFINITY;
    for (size_t i = 1; i <= n; ++i)
        b.body[i] = (struct bonkers_body){(double)i * gap, 0, 0,
                                          1 / random_between(&r, 1, 5)};
    b.body[right ? n : 1].v = right ? -1 : 1;
    bonkers_start(&b, NULL);
    bonkers_run(&b, INFINITY, 100000000);
    count = b.collisions;
    bonkers_free(&b);
    return count;
}

static void study_row(struct study *s)
{
    TABLE_COLUMNS(s->out, {"N", "", "bodies in the row"},
                  {"left", "", "collisions, struck from the left"},
                  {"right", "", "collisions, struck from the right"},
                  {"apart", "", "the same, the bodies 1 nm apart"});
    for (size_t n = 10; n <= 160 && !progress_signal(); n *= 2) {
        const double row[] = {(double)n,
                              (double)strike(n, s->seed, 0, false),
                              (double)strike(n, s->seed, 0, true),
                              (double)strike(n, s->seed, 1e-9, true)};
        table_row(s->out, 4, row);
        if (n == 160)
            TABLE_RESULTS(s->summary, {"left", row[1]}, {"right", row[2]},
                          {"apart", row[3]});
    }
}

enum { SHOWN = 60, EVENTS = 32 };

/* The positions of a body at the start, at its collisions and at the end.
   Points beyond EVENTS are dropped; the figure does not need them. */
struct trail {
    size_t count;
    double x[EVENTS], t[EVENTS];
};

static void add_point(struct trail *trail, double x, double t)
{
    if (trail->count < EVENTS) {
        trail->x[trail->count] = x;
        trail->t[trail->count++] = t;
    }
}

static struct {
    struct trail trail[SHOWN + 2];
    size_t hits[SHOWN + 1]; /* collisions of each gap */
} slab;

/* Fills the trails from a run of the scan engine. The run stops at every
   collision, which does not affect the results. */
static void fill_slab(struct bonkers *b, double until)
{
    for (size_t i = 0; i <= b->gaps; ++i)
        add_point(&slab.trail[i], b->body[i].x, 0);
    while (bonkers_run(b, until, b->collisions + 1) != BONKERS_TIME) {
        /* Find the gap of this collision. Its two bodies were both updated
           at the present time. */
        size_t i = 0;
        while (i + 1 < b->gaps && (b->body[i].since != b->now ||
                                   b->body[i + 1].since != b->now))
            ++i;
        ++slab.hits[i];
        add_point(&slab.trail[i], b->body[i].x, b->now);
        add_point(&slab.trail[i + 1], b->body[i].x, b->now);
    }
    for (size_t i = 0; i <= b->gaps; ++i)
        add_point(&slab.trail[i],
                  b->body[i].x + b->body[i].v * (b->now - b->body[i].since),
                  b->now);
}

/* Writes the collisions of gap i with its island number. A collision is in
   the trails of both neighbours, with the same time. */
static void write_gap(struct table *out, size_t i, size_t island)
{
    const struct trail *t = &slab.trail[i], *next = t + 1;
    for (size_t k = 1; k + 1 < t->count; ++k)
        for (size_t j = 1; j + 1 < next->count; ++j)
            if (t->t[k] == next->t[j])
                table_print(out, "%.6f %.6f %zu %zu\n", t->x[k], t->t[k],
                            island, i);
}

/* Writes all collisions and returns the number of islands. Two gaps with
   collisions belong to the same island if at most one other gap is between
   them (2.6, eq:islands). */
static size_t write_islands(struct table *out, size_t gaps)
{
    size_t island = 0, last = 0;
    table_print(out, "\n# x, t of a collision, its island, its gap\n");
    for (size_t i = 0; i < gaps; ++i) {
        if (slab.hits[i] == 0)
            continue;
        if (island == 0 || i > last + 2)
            ++island;
        last = i;
        write_gap(out, i, island);
    }
    return island;
}

static void study_islands(struct study *s)
{
    const struct start_request request = {
        .kind = START_RANDOM, .movers = SHOWN, .seed = s->seed};
    struct bonkers b;
    begin_or_exit(&b, &request, BONKERS_SCAN);
    fill_slab(&b, own.until);
    table_print(s->out,
                "# x [m], t [s] of a body; an empty line after each\n");
    for (size_t i = 0; i <= b.gaps; ++i) {
        const struct trail *t = &slab.trail[i];
        for (size_t k = 0; k < t->count; ++k)
            table_print(s->out, "%.6f %.6f\n", t->x[k], t->t[k]);
        table_print(s->out, "\n");
    }
    table_count(s->summary, "islands", write_islands(s->out, b.gaps));
    table_count(s->summary, "collisions", b.collisions);
    bonkers_free(&b);
}

static const struct study_entry studies[] = {
    {"speed", study_speed, "collisions in a second, by engine",
     STUDY_KEYS(
         {"<engine>/<engine>-<N>", "1",
          "ratio of their speeds at N particles"},
         {"", "", "if --particles reaches 1000000:"},
         {"slab/naive", "1", "their speeds at a million particles"},
         {"heap-slowdown", "1", "heap: speed at 1000 / at a million"},
         {"slab-spread", "1", "slab: greatest / least speed from 1000 on"},
         {"redone-percent", "%",
          "slab: collisions done twice at a million"})},
    {"drift", study_drift, "of the energy",
     STUDY_KEYS(
         {"energy_error", "1", "relative, masses of preset mixed"},
         {"energy_error_whole", "1", "the same, masses 1, 2 and 1.5"},
         {"energy_error_float", "1", "mixed, single precision"},
         {"ties_<masses>", "%", "of throws: exact halves to be rounded"},
         {"up_<masses>", "%", "of ties: rounded up"})},
    {"reverse", study_reverse, "how the way back is missed",
     STUDY_KEYS(
         {"", "", "if --collisions reaches n (1000, 5000, 1e4, 1e5, 1e6):"},
         {"<line>_<n>", "m",
          "largest miss after n and back; nan: not run"})},
    {"steps", study_steps, "walking instead of events",
     STUDY_KEYS({"collisions", "1", "in the run"},
                {"error_events", "m", "by events, rms error of positions"},
                {"smallest_step", "s", "of the walks"})},
    {"collapse", study_collapse, "two balls and a wall",
     STUDY_KEYS({"border", "1", "greatest restitution that collapses"},
                {"next", "1", "collisions at the one after it"})},
    {"bounce", study_bounce, "a ball by events and in steps",
     STUDY_KEYS({"bounces", "1", "in 900 s"},
                {"events", "m", "error of the place, by events"},
                {"events_energy", "1", "relative error of the energy"},
                {"steps_<n>", "m", "error of the place, in n steps"},
                {"steps_<n>_energy", "1", "relative error of the energy"})},
    {"islands", study_islands, "the collisions of a slab",
     STUDY_KEYS({"islands", "1", "groups of gaps with collisions"},
                {"collisions", "1", "of all"})},
    {"row", study_row, "of bodies that touch",
     STUDY_KEYS({"left", "1", "collisions of 160, struck from the left"},
                {"right", "1", "the same from the right"},
                {"apart", "1", "from the right, bodies 1 nm apart"})},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study drift, reverse"},
    {"collisions", 'c', "N", "most of them (1000000)"},
    {"", 0, NULL, "--study speed"},
    {"particles", 'N', "N", "most of them (1000000)"},
    {"", 0, NULL, "--study steps, bounce, islands"},
    {"until", 't', "T", "length of the run, s (10)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'c': own.most = options_count(o, 100, 1000000000000); break;
    case 'N': own.most = options_count(o, 4, BONKERS_MOVERS); break;
    case 't': own.until = options_real(o, 1e-3, 1000); break;
    }
}

STUDY_MAIN(.name = PROGRAM, .purpose = "Measure the engines of bonkers.",
           .events = "collisions", .studies = studies, .seeds = UINT64_MAX,
           .drawing = "--study islands, row", .options = entries,
           .take = take_option)
