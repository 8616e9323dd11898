/* Measures gases, cradles and a billiard break by steps and by events. */
#include "box/blocks.h"
#include "line/bonkers.h"
#include "box/cells.h"
#include "forces/hard.h"
#include "forces/largest.h"
#include "forces/motion.h"
#include "forces/spheres.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"

#include <math.h>
#include <string.h>

#define PROGRAM "spheres-studies"

enum { MOST_RUNS = 1000 };

static struct {
    uint64_t runs; /* runs with different seeds */
    double until;  /* duration of study_law's run, s */
} own = {.runs = 8, .until = 600};

static const double usual_length = 60; /* of runs in other studies, s */

/* Makes a scene of chapter 11 with the chosen values. */
static void make_scene(struct scene *s, const char *name,
                       const struct gallery_choice chosen[])
{
    program_check(gallery_choose(s, hard_scenes, name, chosen));
}

/* The ways to resolve overlaps after a step. PAPER collides all overlapping
   pairs, as in the paper. APPROACHING collides only pairs that approach
   each other. BACK does the same and also moves these pairs back to where
   they touched. */
enum { PAPER, APPROACHING, BACK, WAYS };

static const char *const ways[WAYS] = {"paper", "approaching", "back"};

struct run {
    struct scene scene;
    struct spheres spheres;
    double dt; /* step, s */
};

/* Prepares r for steps of dt, after which overlaps are resolved in the
   given way. */
static void begin(struct run *r, int way, double dt)
{
    r->dt = dt;
    program_memory(
        spheres_create(&r->spheres, &r->scene,
                       way == PAPER ? SPHERES_ALL : SPHERES_APPROACHING),
        "for the spheres");
    r->spheres.dt = dt;
    r->spheres.shift = way == BACK ? SPHERES_BACK : SPHERES_BY_RADIUS;
}

static void end(struct run *r)
{
    spheres_free(&r->spheres);
    scene_free(&r->scene);
}

/* Steps r for `time` seconds. No force acts during a step. */
static void steps(struct run *r, double time)
{
    struct scene *s = &r->scene;
    const long n = lround(time / r->dt);
    for (long k = 0; k < n && !progress_signal(); ++k) {
        for (size_t i = 0; i < SCENE_AXES * s->bodies; ++i)
            s->position[i] += s->velocity[i] * r->dt;
        spheres_resolve(&r->spheres, s->position, s->velocity);
    }
}

static double energy(const struct scene *s)
{
    double sum = 0;
    for (size_t i = 0; i < SCENE_AXES * s->bodies; ++i)
        sum += s->mass[i % s->bodies] * s->velocity[i] * s->velocity[i] / 2;
    return sum;
}

enum { Z_X, Z_Y, RATE, RECEDING, VIRIAL, FOURTH, ENERGY, MEASURED };

static const double warm_time = 20; /* warm-up before counting starts, s */

/* Resets the counts and sums that these studies read. */
static void reset_counts(struct spheres *p)
{
    p->collisions = p->receding = p->wall_collisions = 0;
    p->virial = 0;
    memset(p->impulse, 0, sizeof p->impulse);
}

/* Returns the mean of v^4 over the disks. */
static double fourth_power(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        const double v2 = s->velocity[i] * s->velocity[i] +
                          s->velocity[n + i] * s->velocity[n + i];
        sum += v2 * v2;
    }
    return sum / (double)n;
}

/* Runs a scene of disks in steps and sets value[] to its results. For
   disks, the energy E equals N kT. The mean of v^4 is taken over LOOKS
   samples. */
static void gas_by_steps(struct run *r, double until, double value[])
{
    enum { LOOKS = 100 };
    const struct spheres *p = &r->spheres;
    const double E = energy(&r->scene);
    const double time =
        LOOKS * r->dt * (double)lround(until / LOOKS / r->dt);
    steps(r, warm_time);
    reset_counts(&r->spheres);
    value[FOURTH] = 0;
    for (int k = 0; k < LOOKS; ++k) {
        steps(r, until / LOOKS);
        value[FOURTH] += fourth_power(&r->scene) / LOOKS;
    }
    for (size_t k = 0; k < 2; ++k)
        value[Z_X + k] = p->impulse[k] / (2 * time) *
                         (r->scene.high[k] - r->scene.low[k]) / E;
    value[RATE] = (double)(p->collisions - p->receding) / time;
    value[RECEDING] = (double)p->receding / time;
    value[VIRIAL] = p->virial / (2 * E * time);
    value[ENERGY] = fabs(energy(&r->scene) / E - 1);
}

/* Runs a gas with the event-driven engine of chapter 7 and sets value[] to
   its results. RECEDING and FOURTH are set to 0. */
static void gas_by_events(struct disks *d, double until, double value[])
{
    struct cells c;
    const double E = disks_energy(d);
    program_memory(cells_create(&c, d), "for the cells");
    cells_run(&c, warm_time, UINT64_MAX);
    const struct disks before = *d;
    cells_run(&c, warm_time + until, UINT64_MAX);
    for (size_t k = 0; k < 2; ++k)
        value[Z_X + k] = (d->impulse[k] - before.impulse[k]) / (2 * until) *
                         d->box[k] / E;
    value[RATE] = (double)(d->collisions - before.collisions) / until;
    value[VIRIAL] = (d->virial - before.virial) / (2 * E * until);
    value[ENERGY] = fabs(disks_energy(d) / E - 1);
    value[RECEDING] = value[FOURTH] = 0;
    cells_free(&c);
}

/* Sets mean[] and error[] to the averages over own.runs runs and their
   standard errors, which follow from the scatter of the runs. Each run has
   its own seed, so the runs are independent. mean[ENERGY] is the largest
   energy error. If way is WAYS, the runs are event-driven. */
static void average(const struct study *s, int way, double dt,
                    double mean[], double error[])
{
    static double values[MEASURED][MOST_RUNS];
    mean[ENERGY] = error[ENERGY] = 0;
    for (uint64_t i = 0; i < own.runs; ++i) {
        double value[MEASURED];
        struct run r;
        make_scene(&r.scene, "gas",
                   GALLERY_CHOICES({"seed", (double)(s->seed + i)}));
        if (way < WAYS) {
            begin(&r, way, dt);
            gas_by_steps(&r, usual_length, value);
            end(&r);
        } else {
            struct disks d;
            program_memory(hard_disks(&d, &r.scene), "for the disks");
            scene_free(&r.scene);
            gas_by_events(&d, usual_length, value);
            disks_free(&d);
        }
        for (int k = 0; k < MEASURED; ++k)
            values[k][i] = value[k];
        mean[ENERGY] = fmax(mean[ENERGY], value[ENERGY]);
    }
    for (int k = 0; k < ENERGY; ++k) {
        const struct blocks_average a =
            blocks_average_of(own.runs, values[k]);
        mean[k] = a.mean;
        error[k] = a.error;
    }
}

enum { DTS = 7, FITTED = 5 };

static const double dts[DTS] = {0.0025, 0.005, 0.01, 0.02,
                                0.04,   0.08,  0.16};

/* Values to be fitted by parabolas, and their errors. */
struct points {
    double y[3][DTS], error[3][DTS];
};

/* Writes a row with the results of all ways for steps of dt, or with
   event-driven results if dt is 0. Stores the values to be fitted at index
   `at`, unless points is NULL. */
static void pressure_row(struct study *s, double dt, int at,
                         struct points points[])
{
    static const int fitted[3] = {Z_X, Z_Y, VIRIAL};
    double row[1 + WAYS * (2 * ENERGY + 1)] = {dt};
    size_t n = 1;
    for (int way = 0; way < WAYS; ++way) {
        double mean[MEASURED], error[MEASURED];
        average(s, dt > 0 ? way : WAYS, dt, mean, error);
        for (int k = 0; k < ENERGY; ++k) {
            row[n++] = mean[k];
            row[n++] = error[k];
        }
        row[n++] = mean[ENERGY];
        for (int k = 0; k < 3 && points; ++k) {
            points[way].y[k][at] = mean[fitted[k]];
            points[way].error[k][at] = error[fitted[k]];
        }
    }
    table_row(s->out, n, row);
}

struct parabola {
    double a, b, a_error, b_error;
};

/* Fits the parabola a + b t + c t^2 by weighted least squares. Returns a
   and b with their standard errors. */
static struct parabola fit(size_t n, const double t[], const double y[],
                           const double error[])
{
    double s[5] = {0}, r[3] = {0};
    for (size_t i = 0; i < n; ++i) {
        double w = 1 / (error[i] * error[i]);
        for (int k = 0; k < 5; ++k, w *= t[i]) {
            s[k] += w;
            if (k < 3)
                r[k] += w * y[i];
        }
    }
    const double c[5] = {
        s[2] * s[4] - s[3] * s[3], s[2] * s[3] - s[1] * s[4],
        s[1] * s[3] - s[2] * s[2], s[0] * s[4] - s[2] * s[2],
        s[1] * s[2] - s[0] * s[3]};
    const double det = s[0] * c[0] + s[1] * c[1] + s[2] * c[2];
    return (struct parabola){
        (c[0] * r[0] + c[1] * r[1] + c[2] * r[2]) / det,
        (c[1] * r[0] + c[3] * r[1] + c[4] * r[2]) / det, sqrt(c[0] / det),
        sqrt(c[3] / det)};
}

/* Writes a row for the event-driven run (dt = 0), one row for each step
   length, and the parabolas fitted to the latter. */
static void study_pressure(struct study *s)
{
    static struct points points[WAYS];
    static const char *const symbols[] = {"Z_x",      "Z_y",    "rate",
                                          "receding", "virial", "v4"};
    table_column(s->out, "dt", "s", "step; 0: by events");
    for (int way = 0; way < WAYS; ++way) {
        for (int k = 0; k < ENERGY; ++k) {
            const char *unit = k == RATE || k == RECEDING ? "1/s" : "";
            TABLE_COLUMNS(s->out, {symbols[k], unit, ways[way]},
                          {"error", unit, "its error"});
        }
        table_column(s->out, "dE/E", "", "the energy's worst error");
    }
    bench_machine(s->out);
    pressure_row(s, 0, 0, NULL);
    for (int i = 0; i < DTS && !progress_signal(); ++i) {
        pressure_row(s, dts[i], i, points);
        progress_update(&s->progress, (uint64_t)i + 1, (uint64_t)i + 1);
    }
    table_print(s->out, "\n\n# parabolas up to 0.04 s: way, then of Z_x, "
                        "Z_y, virial: value at 0, error, slope, error\n");
    for (int way = 0; way < WAYS; ++way) {
        table_print(s->out, "%s", ways[way]);
        for (int k = 0; k < 3; ++k) {
            const struct parabola p =
                fit(FITTED, dts, points[way].y[k], points[way].error[k]);
            table_print(s->out, " %.17g %.17g %.17g %.17g", p.a, p.a_error,
                        p.b, p.b_error);
        }
        table_print(s->out, "\n");
    }
}

enum { SHELLS = 25, MOST_DISKS = 250 };

/* Adds to shell[k] the number of pairs whose gap is k to k + 1 per cent of
   the diameter. */
static void count_pairs(const struct disks *d, double shell[])
{
    const double touching = 2 * d->disk[0].radius;
    const double far = touching * (1 + SHELLS / 100.0);
    double place[MOST_DISKS][DISKS_AXES];
    for (size_t i = 0; i < d->count; ++i) {
        disks_position(d, i, place[i]);
        for (size_t j = 0; j < i; ++j) {
            const double x = place[i][0] - place[j][0],
                         y = place[i][1] - place[j][1];
            const double square = x * x + y * y;
            if (square >= far * far)
                continue;
            const double r = sqrt(square) / touching;
            shell[r < 1 ? 0 : (int)((r - 1) * 100) % SHELLS] += 1;
        }
    }
}

/* Runs an event-driven simulation of a gas. Ten times per second, counts
   the pairs in each distance shell, which takes longer than the run
   itself. Returns Z - 1 from the virial. */
static double fill_shells(const struct study *s, double shell[])
{
    const double seed = (double)s->seed;
    struct run r;
    struct disks d;
    struct cells c;
    make_scene(&r.scene, "gas", GALLERY_CHOICES({"seed", seed}));
    program_memory(hard_disks(&d, &r.scene), "for the disks");
    scene_free(&r.scene);
    const double E = disks_energy(&d), end = own.until;
    program_memory(cells_create(&c, &d), "for the cells");
    cells_run(&c, warm_time, UINT64_MAX);
    const double before = d.virial;
    for (double at = 0.1; at <= end && !progress_signal(); at += 0.1) {
        cells_run(&c, warm_time + at, UINT64_MAX);
        count_pairs(&d, shell);
    }
    const double virial = (d.virial - before) / (2 * E * end);
    cells_free(&c);
    disks_free(&d);
    return virial;
}

/* Returns the slope d ln g / d ln r at contact and sets *error to its
   standard error. The slope is that of a parabola fitted to ln g, where the
   pair density g is the count in a shell divided by the shell's area. */
static double contact_slope(const double shell[], double *error)
{
    double t[SHELLS], y[SHELLS], e[SHELLS];
    for (int k = 0; k < SHELLS; ++k) {
        t[k] = (k + 0.5) / 100;
        y[k] = log(shell[k] / (1 + t[k]));
        e[k] = 1 / sqrt(shell[k]);
    }
    const struct parabola p = fit(SHELLS, t, y, e);
    *error = p.b_error;
    return p.b;
}

/* Writes the terms of the first-order law (11.5, eq:step-law). The slope
   that occurs in the law is measured. */
static void study_law(struct study *s)
{
    const double pi = 3.14159265358979324, eta = 250 * pi * 0.01 / 37.5;
    double shell[SHELLS] = {0}, error;
    const double virial = fill_shells(s, shell);
    const double slope = contact_slope(shell, &error);
    const double density =
        2 * eta / (1 - eta) - 7 * eta / 16 / (1 - 7 * eta / 16);
    const double hit = sqrt(2 / pi);
    const double rate = (2 * density - slope) / (2 * sqrt(2 * pi));
    const double share = virial / (1 + virial);
    const double law = share * (hit + rate);
    const struct table_result found[] = {
        {"slope", slope},
        {"error", error},
        {"density", density},
        {"hit", hit},
        {"rate", rate},
        {"share", share},
        {"law", law},
        {"virial_slope", -virial * (hit + rate) / 0.2},
        {0}};
    double row[8];
    for (size_t k = 0; k < 8; ++k) {
        table_column(s->out, found[k].key, "", "of the law of first order");
        row[k] = found[k].value;
    }
    table_results(s->summary, found);
    table_row(s->out, 8, row);
}

enum {
    CHECK_ENERGY,
    CHECK_IDENTITY,
    CHECK_SPEEDS,
    CHECK_RATE,
    CHECK_PRESSURE,
    CHECK_NEAR,
    CHECK_CENTRE,
    CHECK_SPIN,
    CHECK_BACK,
    CHECKS
};

static const char *const checks[CHECKS] = {"energy", "identity", "speeds",
                                           "rate",   "pressure", "near",
                                           "centre", "spin",     "back"};

/* Returns the sum of m x v over bodies and axes, where x is measured from
   the middle of the box. */
static double moment(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t k = 0; k < 2; ++k)
        for (size_t i = 0; i < n; ++i)
            sum += s->mass[i] * s->velocity[k * n + i] *
                   (s->position[k * n + i] - (s->low[k] + s->high[k]) / 2);
    return sum;
}

/* Returns the number of pairs closer than 1.02 times the sum of their
   radii. */
static double near_pairs(const struct scene *s)
{
    const size_t n = s->bodies;
    double count = 0;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < i; ++j) {
            const double far = 1.02 * (s->radius[i] + s->radius[j]);
            const double x = s->position[i] - s->position[j],
                         y = s->position[n + i] - s->position[n + j];
            count += x * x + y * y < far * far;
        }
    return count;
}

/* Makes an event-driven run and returns the mean number of near pairs in
   200 samples. */
static double near_by_events(struct run *r)
{
    struct disks d;
    struct cells c;
    double near = 0;
    program_memory(hard_disks(&d, &r->scene), "for the disks");
    program_memory(cells_create(&c, &d), "for the cells");
    for (int k = 0; k < 200; ++k) {
        cells_run(&c, warm_time + 0.2 * k, UINT64_MAX);
        for (size_t i = 0; i < d.count; ++i) {
            double place[DISKS_AXES];
            disks_position(&d, i, place);
            for (size_t axis = 0; axis < 2; ++axis)
                r->scene.position[axis * d.count + i] = place[axis];
        }
        near += near_pairs(&r->scene) / 200;
    }
    cells_free(&c);
    disks_free(&d);
    return near;
}

static double near_by_steps(struct run *r)
{
    double near = 0;
    steps(r, warm_time);
    for (int k = 0; k < 200; ++k) {
        steps(r, 0.2);
        near += near_pairs(&r->scene) / 200;
    }
    return near;
}

/* Returns the error of (7.6, eq:gas-walls) after 20 s: the absolute
   difference between its two sides, divided by 2 K t. */
static double identity(struct run *r)
{
    const double time = 20, radius = 0.1;
    const struct spheres *p = &r->spheres;
    reset_counts(&r->spheres);
    const double before = moment(&r->scene), E = energy(&r->scene);
    steps(r, time);
    double rest = moment(&r->scene) - before - 2 * E * time - p->virial;
    for (size_t k = 0; k < 2; ++k)
        rest += p->impulse[k] *
                ((r->scene.high[k] - r->scene.low[k]) / 2 - radius);
    return fabs(rest) / (2 * E * time);
}

static void begin_gas(struct run *r, const char *name, uint64_t seed,
                      enum scene_wall wall, int way, double dt)
{
    make_scene(&r->scene, name, GALLERY_CHOICES({"seed", (double)seed}));
    r->scene.wall[0] = r->scene.wall[1] = wall;
    begin(r, way, dt);
}

/* Returns the mass-weighted mean of x[]: one coordinate of the centre of
   mass, or of its velocity. */
static double centre(const struct scene *s, const double x[])
{
    double sum = 0, mass = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        sum += s->mass[i] * x[i];
        mass += s->mass[i];
    }
    return sum / mass;
}

/* Returns the deviation of the centre of mass from uniform motion along x
   after 2 s in a periodic box, in units of a light disk's radius. */
static double moved_centre(uint64_t seed, int way, double dt)
{
    struct run r;
    begin_gas(&r, "brownian", seed, SCENE_PERIODIC, way, dt);
    const double before = centre(&r.scene, r.scene.position) +
                          2 * centre(&r.scene, r.scene.velocity);
    steps(&r, 2);
    const double moved = centre(&r.scene, r.scene.position) - before;
    end(&r);
    return fabs(moved) / 0.1;
}

/* Returns the angular momentum about the origin. */
static double spin(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += s->mass[i] * (s->position[i] * s->velocity[n + i] -
                             s->position[n + i] * s->velocity[i]);
    return sum;
}

/* Returns the change of the angular momentum of a gas without walls in 2 s,
   divided by the diameter and the square root of the number of collisions.
   The gas expands, so its collision rate falls to a quarter in this
   time. */
static double lost_spin(uint64_t seed, int way, double dt)
{
    struct run r;
    begin_gas(&r, "gas", seed, SCENE_OPEN, way, dt);
    const double before = spin(&r.scene);
    steps(&r, 2);
    const double lost = fabs(spin(&r.scene) - before);
    const double collisions = (double)r.spheres.collisions;
    end(&r);
    return lost / sqrt(collisions) / 0.2;
}

/* Returns the median distance (in diameters) of the disks from their
   initial positions after 0.2 s forwards and 0.2 s with reversed
   velocities. */
static double missed_way_back(uint64_t seed, int way, double dt)
{
    enum { DISKS = 250 };
    double x[2 * DISKS], miss[DISKS];
    struct run r;
    begin_gas(&r, "gas", seed, SCENE_HARD, way, dt);
    steps(&r, 1);
    memcpy(x, r.scene.position, sizeof x);
    steps(&r, 0.2);
    for (size_t i = 0; i < 2 * DISKS; ++i)
        r.scene.velocity[i] *= -1;
    steps(&r, 0.2);
    for (size_t i = 0; i < DISKS; ++i)
        miss[i] = hypot(r.scene.position[i] - x[i],
                        r.scene.position[DISKS + i] - x[DISKS + i]);
    end(&r);
    return bench_median(miss, DISKS) / 0.2;
}

/* Sets found[] to the results of all checks for one way and one step
   length. Results are compared with their exact values or, if these are
   unknown, with event-driven runs. */
static void do_checks(struct study *s, int way, double dt,
                      const double truth[], double near, double found[])
{
    double mean[MEASURED], error[MEASURED];
    struct run r;
    average(s, way, dt, mean, error);
    found[CHECK_ENERGY] = mean[ENERGY];
    found[CHECK_SPEEDS] = fabs(mean[FOURTH] / (2 * 250 / 251.0) - 1);
    found[CHECK_RATE] = fabs(mean[RATE] / truth[RATE] - 1);
    found[CHECK_PRESSURE] = fabs(mean[Z_X] / truth[Z_X] - 1);
    begin_gas(&r, "gas", s->seed, SCENE_HARD, way, dt);
    found[CHECK_NEAR] = fabs(near_by_steps(&r) / near - 1);
    found[CHECK_IDENTITY] = identity(&r);
    end(&r);
    found[CHECK_CENTRE] = found[CHECK_SPIN] = found[CHECK_BACK] = 0;
    for (uint64_t i = 0; i < 10; ++i) {
        found[CHECK_CENTRE] += moved_centre(s->seed + i, way, dt) / 10;
        found[CHECK_SPIN] += lost_spin(s->seed + i, way, dt) / 10;
        found[CHECK_BACK] += missed_way_back(s->seed + i, way, dt) / 10;
    }
}

/* Checks PAPER and BACK with two step lengths each. */
static void study_checks(struct study *s)
{
    double truth[MEASURED], error[MEASURED];
    struct run r;
    average(s, WAYS, 0, truth, error);
    begin_gas(&r, "gas", s->seed, SCENE_HARD, PAPER, 1);
    const double near = near_by_events(&r);
    end(&r);
    TABLE_COLUMNS(s->out, {"way", "", "0 paper, 1 approaching, 2 back"},
                  {"dt", "s", "step"});
    for (int k = 0; k < CHECKS; ++k)
        table_column(s->out, checks[k], "", "what it finds");
    for (int way = 0; way < WAYS; way += 2)
        for (int fine = 1; fine >= 0; --fine) {
            double row[2 + CHECKS] = {way, fine ? 0.02 : 0.04};
            do_checks(s, way, row[1], truth, near, row + 2);
            table_row(s->out, 2 + CHECKS, row);
            for (int k = 0; k < CHECKS; ++k)
                table_keyed(s->summary, row[2 + k], "%s_%s_%d", checks[k],
                            ways[way], fine ? 2 : 4);
        }
}

/* Initial states of five balls: the number of moving balls at each end, and
   the masses of the first, last and middle ball, kg. */
static const struct {
    const char *name;
    double left, right, first, last, middle;
} rows[] = {{"one", 1, 0, 1, 1, 1},    {"two", 2, 0, 1, 1, 1},
            {"three", 3, 0, 1, 1, 1},  {"both", 1, 1, 1, 1, 1},
            {"double", 1, 0, 2, 1, 1}, {"triple", 1, 0, 3, 1, 1},
            {"half", 1, 0, 0.5, 1, 1}, {"last", 1, 0, 1, 2, 1},
            {"middle", 1, 1, 1, 1, 2}};

enum { ROWS = sizeof rows / sizeof *rows, BALLS = 5, DOUBLE = 4 };

static void make_row(struct scene *s, int row, double gap,
                     double restitution)
{
    make_scene(s, "cradle",
               GALLERY_CHOICES(
                   {"left", rows[row].left}, {"right", rows[row].right},
                   {"first", rows[row].first}, {"last", rows[row].last},
                   {"middle", rows[row].middle}, {"gap", gap},
                   {"restitution", restitution}));
}

static void begin_events(struct bonkers *b, const struct scene *s)
{
    struct start start;
    size_t wrong;
    program_memory(
        hard_start(&start, s) &&
            bonkers_begin(b, &start, s->restitution, BONKERS_SCAN, &wrong),
        "for a row");
    start_free(&start);
}

/* Makes an event-driven run of a row. Sets x[] and v[] to the positions and
   velocities at the time `until`. Returns the number of collisions. There
   are no walls, so a ball that leaves the row does not come back. */
static uint64_t row_by_events(int row, double gap, double until, double x[],
                              double v[])
{
    struct scene s;
    struct bonkers b;
    double places[BALLS + 2], velocities[BALLS + 2];
    make_row(&s, row, gap, 1);
    s.wall[0] = SCENE_OPEN;
    begin_events(&b, &s);
    bonkers_run(&b, until, UINT64_MAX);
    bonkers_state(&b, places, velocities);
    memcpy(x, places + 1, BALLS * sizeof *x);
    memcpy(v, velocities + 1, BALLS * sizeof *v);
    const uint64_t collisions = b.collisions;
    bonkers_free(&b);
    scene_free(&s);
    return collisions;
}

/* How a row is stepped: its initial gap (in m), its step (in s), and the
   way and the order in which overlaps are resolved. */
struct stepped {
    int way;
    enum spheres_order order;
    double gap, dt;
};

/* Makes a time-stepped run of a row. Sets x[] and v[] to the positions and
   velocities at the time `until`. */
static void row_by_steps(int row, struct stepped how, double until,
                         double x[], double v[])
{
    struct run r;
    make_row(&r.scene, row, how.gap, 1);
    r.scene.wall[0] = SCENE_OPEN;
    begin(&r, how.way, how.dt);
    r.spheres.order = how.order;
    steps(&r, until);
    memcpy(x, r.scene.position, BALLS * sizeof *x);
    memcpy(v, r.scene.velocity, BALLS * sizeof *v);
    end(&r);
}

/* Sets v[] to the velocities after simultaneous collisions at all contacts.
   J[c + 1] is the impulse at contact c. The impulses solve a tridiagonal
   system of equations. */
static void row_at_once(int row, double v[])
{
    struct scene s;
    double diagonal[BALLS], J[BALLS + 1] = {0};
    make_row(&s, row, 0, 1);
    for (size_t c = 0; c + 1 < BALLS; ++c) {
        const double before = c > 0 ? 1 / s.mass[c] / diagonal[c - 1] : 0;
        diagonal[c] =
            1 / s.mass[c] + 1 / s.mass[c + 1] - before / s.mass[c];
        J[c + 1] = 2 * (s.velocity[c] - s.velocity[c + 1]) + before * J[c];
    }
    for (size_t c = BALLS - 1; c-- > 0;) {
        const double after = c + 2 < BALLS ? J[c + 2] / s.mass[c + 1] : 0;
        J[c + 1] = (J[c + 1] + after) / diagonal[c];
    }
    for (size_t i = 0; i < BALLS; ++i)
        v[i] = s.velocity[i] +
               (J[i] - (i + 1 < BALLS ? J[i + 1] : 0)) / s.mass[i];
    scene_free(&s);
}

static void write_velocities(struct study *s, const char *kind, int row,
                             const double v[])
{
    for (int i = 0; i < BALLS; ++i)
        table_keyed(s->summary, v[i], "%s_%s_%d", kind, rows[row].name,
                    i + 1);
}

enum { KINDS = 4 };

static const struct {
    const char *name;
    struct stepped how;
} kinds[KINDS] = {
    {"wide", {APPROACHING, SPHERES_ASCENDING, 0.01, 0.001}},
    {"narrow", {APPROACHING, SPHERES_ASCENDING, 0.0001, 0.001}},
    {"up", {APPROACHING, SPHERES_ASCENDING, 0, 0.001}},
    {"down", {APPROACHING, SPHERES_DESCENDING, 0, 0.001}}};

/* Sets line[] to the number of the row, its number of collisions, and the
   largest velocity error of each kind of stepped run. The event-driven run
   is exact. Writes all velocities to the summary, including those after
   simultaneous collisions. */
static void compare_row(struct study *s, int row, double line[2 + KINDS])
{
    double x[BALLS], exact[BALLS], v[BALLS];
    const uint64_t n = row_by_events(row, 0.01, 100, x, exact);
    table_keyed(s->summary, (double)n, "n_%s", rows[row].name);
    write_velocities(s, "events", row, exact);
    line[0] = row;
    line[1] = (double)n;
    for (int k = 0; k < KINDS; ++k) {
        row_by_steps(row, kinds[k].how, 10, x, v);
        line[2 + k] = largest_difference(v, exact, BALLS);
        write_velocities(s, kinds[k].name, row, v);
    }
    row_at_once(row, v);
    write_velocities(s, "once", row, v);
}

/* Compares stepped with event-driven runs for nine initial states of the
   row. The gaps are wide, or a tenth of the distance that a ball moves in a
   step, or zero. The largest differences in the summary exclude the last
   state, which is a special case. */
static void study_rows(struct study *s)
{
    double worst[KINDS] = {0}, line[2 + KINDS];
    TABLE_COLUMNS(s->out, {"row", "", "one two three both double ..."},
                  {"n", "", "collisions, by events"});
    for (int k = 0; k < KINDS; ++k)
        table_column(s->out, kinds[k].name, "m/s",
                     "worst difference, by steps");
    for (int row = 0; row < ROWS; ++row) {
        compare_row(s, row, line);
        table_row(s->out, 2 + KINDS, line);
        for (int k = 0; k < KINDS && row + 1 < ROWS; ++k)
            worst[k] = fmax(worst[k], line[2 + k]);
    }
    for (int k = 0; k < KINDS; ++k)
        table_real(s->summary, kinds[k].name, worst[k]);
}

/* Writes errors after 3 s against the step length, for the row whose first
   ball has twice the mass. */
static void study_late(struct study *s)
{
    const double until = 3;
    double x[BALLS], v[BALLS], place[BALLS], velocity[BALLS];
    table_column(s->out, "dt", "s", "step; v = 1 m/s, 2r = 0.2 m");
    for (int way = 0; way < WAYS; ++way)
        TABLE_COLUMNS(s->out, {"dv", "m/s", ways[way]},
                      {"dx", "m", "of the last ball"});
    row_by_events(DOUBLE, 0.01, until, x, v);
    for (double n = 3e4; n >= 4; n = floor(n / 1.17)) {
        double line[1 + 2 * WAYS] = {until / n};
        for (int way = 0; way < WAYS; ++way) {
            const struct stepped how = {way, SPHERES_ASCENDING, 0.01,
                                        line[0]};
            row_by_steps(DOUBLE, how, until, place, velocity);
            line[1 + 2 * way] = largest_difference(velocity, v, BALLS);
            line[2 + 2 * way] = fabs(place[BALLS - 1] - x[BALLS - 1]);
        }
        table_row(s->out, 1 + 2 * WAYS, line);
    }
}

/* Runs a row with restitution 0.9 between two walls, event-driven and in
   steps. Writes both energies every 0.05 s. */
static void study_rest(struct study *s)
{
    const double every = 0.05, until = usual_length;
    struct run r;
    struct bonkers b;
    make_row(&r.scene, 0, 0.001, 0.9);
    begin(&r, APPROACHING, 0.0005);
    begin_events(&b, &r.scene);
    TABLE_COLUMNS(s->out, {"t", "s", "time"},
                  {"events", "J", "energy by events"},
                  {"steps", "J", "energy by steps"});
    for (int i = 0; i < BALLS; ++i)
        table_column(s->out, "x", "m", "of a ball, by steps");
    for (int k = 0; k * every <= until && !progress_signal(); ++k) {
        double x[BALLS + 2], v[BALLS + 2];
        bonkers_run(&b, k * every, UINT64_MAX);
        bonkers_state(&b, x, v);
        double line[3 + BALLS] = {k * every, bonkers_energy(&b),
                                  energy(&r.scene)};
        memcpy(line + 3, r.scene.position, BALLS * sizeof *line);
        table_row(s->out, 3 + BALLS, line);
        steps(&r, every);
    }
    TABLE_RESULTS(
        s->summary,
        {"difference", fabs(energy(&r.scene) / bonkers_energy(&b) - 1)},
        {"left", energy(&r.scene) / 0.5});
    bonkers_free(&b);
    end(&r);
}

enum { RACK = 16, OUTCOMES = 100 };

static void make_break(struct scene *s, double jitter, uint64_t seed)
{
    make_scene(s, "break",
               GALLERY_CHOICES({"jitter", jitter}, {"seed", (double)seed}));
}

static const double usual_break = 0.5; /* duration of a break, s */

/* Sets x[] to the positions after the break of a rack of balls, computed by
   steps that resolve overlaps by BACK. */
static void break_by_steps(enum spheres_order order, double dt, double x[])
{
    struct run r;
    make_break(&r.scene, 0, 1);
    begin(&r, BACK, dt);
    r.spheres.order = order;
    steps(&r, usual_break);
    memcpy(x, r.scene.position, 2 * RACK * sizeof *x);
    end(&r);
}

/* Sets x[] to the positions after the break, computed by an event-driven
   run in a box so large that its walls have no effect. The origin of x[] is
   the middle of the table, not the corner of the box. */
static void break_by_events(double jitter, uint64_t seed, double x[])
{
    const double far = 50; /* m */
    struct scene scene;
    struct disks d;
    make_break(&scene, jitter, seed);
    for (size_t k = 0; k < 2; ++k) {
        scene.wall[k] = SCENE_HARD;
        scene.low[k] = -far;
        scene.high[k] = far;
    }
    program_memory(hard_disks(&d, &scene), "for the disks");
    program_memory(disks_plan(&d), "for the break");
    disks_run(&d, usual_break, UINT64_MAX);
    for (size_t i = 0; i < RACK; ++i) {
        double place[DISKS_AXES];
        disks_position(&d, i, place);
        for (size_t k = 0; k < 2; ++k)
            x[k * RACK + i] = place[k] - far;
    }
    disks_free(&d);
    scene_free(&scene);
}

/* Returns the largest distance between the positions of a ball in two
   outcomes. */
static double distance(const double x[], const double y[])
{
    double most = 0;
    for (size_t i = 0; i < RACK; ++i)
        most = fmax(most, hypot(x[i] - y[i], x[RACK + i] - y[RACK + i]));
    return most;
}

/* Returns the number of outcomes that differ by more than 1 mm from every
   earlier outcome. */
static size_t distinct(double outcome[][2 * RACK], size_t n)
{
    size_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        bool fresh = true;
        for (size_t j = 0; j < i; ++j)
            fresh = fresh && distance(outcome[i], outcome[j]) > 1e-3;
        count += fresh;
    }
    return count;
}

static double nearest(const double x[], double outcome[][2 * RACK])
{
    double least = INFINITY;
    for (size_t i = 0; i < OUTCOMES; ++i)
        least = fmin(least, distance(x, outcome[i]));
    return least;
}

enum { BREAKS = 4 };

/* Compares four time-stepped breaks with a hundred event-driven ones. */
static void study_break(struct study *s)
{
    static double stepped[BREAKS][2 * RACK], outcome[OUTCOMES][2 * RACK];
    break_by_steps(SPHERES_ASCENDING, 1e-5, stepped[0]);
    break_by_steps(SPHERES_DESCENDING, 1e-5, stepped[1]);
    break_by_steps(SPHERES_ASCENDING, 0.5e-5, stepped[2]);
    break_by_steps(SPHERES_DEEPEST, 1e-5, stepped[3]);
    for (size_t i = 0; i < OUTCOMES; ++i)
        break_by_events(1e-12, i, outcome[i]);
    /* Write the outcomes for the three orders in which pairs are
       resolved. */
    TABLE_COLUMNS(s->out, {"x", "m", "steps, ascending; then by events"},
                  {"y", "m", ""}, {"x'", "m", "steps, descending"},
                  {"y'", "m", ""}, {"x''", "m", "steps, the deepest first"},
                  {"y''", "m", ""});
    for (size_t i = 0; i < RACK; ++i)
        TABLE_ROW(s->out, stepped[0][i], stepped[0][RACK + i],
                  stepped[1][i], stepped[1][RACK + i], stepped[3][i],
                  stepped[3][RACK + i]);
    /* Write the positions after all event-driven breaks. */
    table_print(s->out, "\n\n");
    for (size_t k = 0; k < OUTCOMES; ++k)
        for (size_t i = 0; i < RACK; ++i)
            table_print(s->out, "%.9g %.9g\n", outcome[k][i],
                        outcome[k][RACK + i]);
    TABLE_RESULTS(s->summary, {"orders", distance(stepped[0], stepped[1])},
                  {"halved", distance(stepped[0], stepped[2])},
                  {"ascending", nearest(stepped[0], outcome)},
                  {"deepest", nearest(stepped[3], outcome)});
    table_count(s->summary, "outcomes", distinct(outcome, OUTCOMES));
}

/* Makes bodies with contacts and gravity but without walls. */
static void make_bodies(struct scene *s, size_t bodies, double radius)
{
    program_memory(scene_create(s, bodies), "for the balls");
    s->contact = true;
    s->gravity[2] = -2;
    for (size_t i = 0; i < bodies; ++i)
        s->radius[i] = radius;
}

static void set_walls(struct scene *s, size_t k, double low, double high)
{
    s->wall[k] = SCENE_HARD;
    s->low[k] = low;
    s->high[k] = high;
}

/* Makes three balls in a box. They attract each other if k2 > 0. */
static void make_three(struct scene *s, double k2)
{
    static const double start[] = {-0.6,  0.1, 0.7, 0,  0.05,
                                   -0.05, 0.5, 0.9, 0.4},
                        speed[] = {1.1, -0.5, -0.9, 0.2, -0.1,
                                   0.1, 0.3,  0.2,  1};
    make_bodies(s, 3, 0.125);
    memcpy(s->position, start, sizeof start);
    memcpy(s->velocity, speed, sizeof speed);
    s->mass[1] = 2;
    s->mass[2] = 0.5;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        set_walls(s, k, k < 2 ? -1 : 0, k < 2 ? 1 : 2);
    s->k2 = k2;
    s->softening = 0.2;
}

/* Prepares a motion with all forces of a scene. If `located`, contacts are
   located in time within a step. */
static void move(struct motion *m, struct scene *s, const char *method,
                 double dt, bool located)
{
    program_memory(motion_begin(m, PROGRAM, s, method, dt) &&
                       (!located || motion_locate(m)),
                   "for a motion");
    m->spheres.rule = SPHERES_APPROACHING;
    m->spheres.shift = SPHERES_BACK;
}

/* Sets x[] to the positions of the three balls after 1 s. Returns the
   number of collisions. */
static uint64_t move_three(const char *method, double k2, bool located,
                           uint64_t steps, double x[9])
{
    struct scene s;
    struct motion m;
    make_three(&s, k2);
    move(&m, &s, method, 1 / (double)steps, located);
    motion_run(&m, steps);
    memcpy(x, s.position, 9 * sizeof *x);
    const uint64_t met = m.collisions;
    motion_end(&m);
    scene_free(&s);
    return met;
}

/* Drops a ball from 1 m above the floor. If e is 1, returns its largest
   position error up to 2001 s. The exact height at the time t after a
   bounce is t (2 - t). If e is less than 1, returns the number of bounces
   until the ball rests. */
static double drop_ball(double e)
{
    struct scene s;
    struct motion m;
    double worst = 0;
    make_bodies(&s, 1, 0.125);
    set_walls(&s, 2, -0.125, 100);
    s.position[2] = 1;
    s.restitution = e;
    move(&m, &s, "leapfrog", 0.064375, true);
    while (motion_time(&m) < 2001 && m.impact.resting == 0) {
        motion_run(&m, 1);
        const double since = fmod(motion_time(&m) + 1, 2);
        worst = fmax(worst, fabs(s.position[2] - since * (2 - since)));
    }
    const double bounces = (double)m.collisions;
    motion_end(&m);
    scene_free(&s);
    return e == 1 ? worst : bounces;
}

static const struct {
    const char *name, *method;
    bool located;
    uint64_t coarse; /* steps of the coarser run in moment_order */
} moments[] = {{"stepwise", "leapfrog", false, 64},
               {"leapfrog", "leapfrog", true, 64},
               {"rk4", "rk4", true, 64},
               {"kahan-li8", "kahan-li8", true, 16}};

enum { MOMENTS = sizeof moments / sizeof *moments };

static double moment_error(int way, uint64_t steps, const double exact[9])
{
    double x[9];
    move_three(moments[way].method, 0.5, moments[way].located, steps, x);
    return largest_difference(x, exact, 9);
}

/* Returns the order of convergence, from the errors at two step lengths
   that differ by a factor of 16, or of 8 for the method of order eight. */
static double moment_order(int way, const double exact[9])
{
    const uint64_t n = moments[way].coarse;
    const double times = n > 16 ? 16 : 8;
    const double coarse = moment_error(way, n, exact);
    const double fine = moment_error(way, n * (uint64_t)times, exact);
    return log2(coarse / fine) / log2(times);
}

/* Writes the errors of three balls after 1 s against the step length, for
   each entry of moments[]. The summary gets the orders of convergence, the
   errors of three balls without attraction, and the results of a single
   ball. */
static void study_moment(struct study *s)
{
    double exact[9], row[1 + MOMENTS];
    table_column(s->out, "dt", "s", "step");
    for (int way = 0; way < MOMENTS; ++way)
        table_column(s->out, moments[way].name, "m", "largest error");
    move_three("kahan-li8", 0.5, true, 2048, exact);
    for (double n = 4; n < 5000; n *= 1.189207115002721) {
        const uint64_t steps = (uint64_t)lround(n);
        row[0] = 1 / (double)steps;
        for (int way = 0; way < MOMENTS; ++way)
            row[1 + way] = moment_error(way, steps, exact);
        table_row(s->out, 1 + MOMENTS, row);
    }
    double x[9], y[9], fine[9];
    for (int way = 0; way < MOMENTS; ++way)
        table_keyed(s->summary, moment_order(way, exact), "order_%s",
                    moments[way].name);
    table_count(s->summary, "collisions",
                move_three("leapfrog", 0.5, true, 4096, x));
    move_three("leapfrog", 0, true, 256, x);
    move_three("leapfrog", 0, false, 256, y);
    move_three("kahan-li8", 0, true, 300, fine);
    TABLE_RESULTS(s->summary, {"located", largest_difference(x, fine, 9)},
                  {"stepwise", largest_difference(y, fine, 9)},
                  {"bounce", drop_ball(1)}, {"bounces", drop_ball(0.8)});
}

enum { TOUCHING = 3 };

/* Contact laws. The stiffness is in N/m, or in N/m^1.5 for Hertz's law. The
   gap between balls is in m. */
static const struct {
    const char *name;
    enum scene_law law;
    double stiffness, gap;
} touchings[TOUCHING] = {{"linear", SCENE_LINEAR, 5000, 0},
                         {"hertz", SCENE_HERTZ, 50000, 0},
                         {"gaps", SCENE_LINEAR, 5000, 0.03}};

static const double pair_omega = 100; /* 1/s, of a linear contact */

/* Makes a row of balls of 1 kg. The first ball moves at 1 m/s. */
static void make_touching(struct scene *s, int way, size_t balls)
{
    make_bodies(s, balls, 0.1);
    s->gravity[2] = 0;
    s->law = touchings[way].law;
    s->stiffness = touchings[way].stiffness;
    for (size_t i = 0; i < balls; ++i)
        s->position[i] = (double)i * (0.2 + touchings[way].gap);
    s->velocity[0] = 1;
}

/* Returns the speed (in m/s) at which two balls separate after approaching
   each other at 1 m/s. `gap` (in m) is added to their initial distance. */
static double parting_speed(int way, double dashpot, double gap, double dt)
{
    struct scene s;
    struct motion m;
    make_touching(&s, way, 2);
    s.dashpot = dashpot;
    s.position[1] += gap;
    move(&m, &s, "leapfrog", dt, false);
    motion_run(&m, 2 + (uint64_t)((gap + 6 / pair_omega) / dt));
    const double parting = s.velocity[1] - s.velocity[0];
    motion_end(&m);
    scene_free(&s);
    return parting;
}

/* Returns the duration of a contact of two balls under Hertz's law, s. The
   time at which the gap is zero again is interpolated linearly. */
static double hertz_time(void)
{
    struct scene s;
    struct motion m;
    const double dt = 1e-5;
    make_touching(&s, 1, 2);
    move(&m, &s, "leapfrog", dt, false);
    do
        motion_run(&m, 1);
    while (s.position[1] - s.position[0] < 0.2);
    const double late = (s.position[1] - s.position[0] - 0.2) /
                        (s.velocity[1] - s.velocity[0]);
    const double time = motion_time(&m) - late;
    motion_end(&m);
    scene_free(&s);
    return time;
}

/* Writes the velocities of a row at intervals of 0.1 / pair_omega. */
static void touch_row(struct study *s, int way)
{
    struct scene scene;
    struct motion m;
    make_touching(&scene, way, BALLS);
    move(&m, &scene, "leapfrog", 0.01 / pair_omega, false);
    for (int k = 0; k <= 300; ++k) {
        table_print(s->out, "%.9g", motion_time(&m));
        for (int i = 0; i < BALLS; ++i)
            table_print(s->out, " %.9g", scene.velocity[i]);
        table_print(s->out, "\n");
        motion_run(&m, 10);
    }
    table_print(s->out, "\n\n");
    table_real(s->summary, touchings[way].name,
               largest_difference(scene.velocity,
                                  (double[BALLS]){0, 0, 0, 0, 1}, BALLS));
    for (int i = 0; i < BALLS; ++i)
        table_keyed(s->summary, scene.velocity[i], "%s_%d",
                    touchings[way].name, i + 1);
    motion_end(&m);
    scene_free(&scene);
}

/* Sets *least and *most to the smallest and the largest fraction of energy
   that a contact returns. The fraction depends on the phase of the step at
   which the contact starts. */
static void energy_range(double omega_dt, double *least, double *most)
{
    *least = INFINITY;
    *most = 0;
    for (int phase = 0; phase < 100; ++phase) {
        const double dt = omega_dt / pair_omega;
        const double parting =
            parting_speed(0, 0, dt * (phase + 0.5) / 100, dt);
        *least = fmin(*least, parting * parting);
        *most = fmax(*most, parting * parting);
    }
}

/* Returns the largest error of the parting speed, which should be e. A
   contact lasts `time` seconds, which is `steps` steps to within half a
   step. The step length varies because, with a whole number of steps,
   contacts would begin and end at the same phase of a step and some errors
   would cancel. */
static double worst_parting_speed(int way, double dashpot, double time,
                                  int steps, double e)
{
    double worst = 0;
    for (int k = 0; k < 400; ++k) {
        const double dt = time / (steps + (k % 20 - 9.5) / 20);
        const double gap = dt * (floor(k / 20.0) + 0.5) / 20;
        worst = fmax(worst, fabs(parting_speed(way, dashpot, gap, dt) - e));
    }
    return worst;
}

static void write_worst_speeds(struct study *s, double linear, double hertz,
                               double dashpot, double e)
{
    static const int lengths[] = {3, 6, 15, 30, 60, 150};
    for (int k = 0; k < 6; ++k) {
        const int n = lengths[k];
        table_keyed(s->summary,
                    worst_parting_speed(0, dashpot, linear, n, e),
                    "linear_in_%d", n);
        table_keyed(s->summary, worst_parting_speed(1, 0, hertz, n, 1),
                    "hertz_in_%d", n);
    }
}

/* Writes the velocities of rows whose contacts are stiff springs. The
   summary gets the errors of such contacts against their number of
   steps. */
static void study_touch(struct study *s)
{
    const double pi = 3.141592653589793, zeta = 0.2;
    double least, most;
    table_column(s->out, "t", "s", "blocks: linear, Hertz, with gaps");
    for (int i = 0; i < BALLS; ++i)
        table_column(s->out, "v", "m/s", "velocity of a ball");
    for (int way = 0; way < TOUCHING; ++way)
        touch_row(s, way);
    TABLE_RESULTS(s->summary,
                  {"formula", exp(-pi * zeta / sqrt(1 - zeta * zeta))},
                  {"restitution",
                   parting_speed(0, 2 * zeta * 50, 0, 0.001 / pair_omega)},
                  {"hertz_formula",
                   2.94327 * pow(2.5 / (4 * touchings[1].stiffness), 0.4)},
                  {"hertz_time", hertz_time()});
    energy_range(0.1, &least, &most);
    table_real(s->summary, "energy_01", fmax(1 - least, most - 1));
    energy_range(2, &least, &most);
    TABLE_RESULTS(s->summary, {"least_2", least}, {"most_2", most});
    write_worst_speeds(s, pi / (pair_omega * sqrt(1 - zeta * zeta)),
                       hertz_time(), 2 * zeta * 50,
                       exp(-pi * zeta / sqrt(1 - zeta * zeta)));
}

enum { LOCATED = WAYS + 1 }; /* WAYS is an event-driven run */

/* Returns the duration of a run, s. Locating contacts is slow, so LOCATED
   runs last only a fifth of the usual time. */
static double length_of(int way, double usual)
{
    return way == LOCATED ? usual / 5 : usual;
}

/* Returns Z - 1 of a gas with located contacts, from its virial. No force
   acts between contacts, so leapfrog is exact. */
static double gas_located(struct scene *s, double dt, double until)
{
    struct motion m;
    const double E = energy(s);
    const double before = length_of(LOCATED, warm_time);
    const uint64_t counted = (uint64_t)lround(until / dt);
    move(&m, s, "leapfrog", dt, true);
    motion_run(&m, (uint64_t)lround(before / dt));
    reset_counts(&m.spheres);
    motion_run(&m, counted);
    const double virial = m.spheres.virial / (2 * E * (double)counted * dt);
    motion_end(&m);
    return virial;
}

/* Runs a gas. Returns Z - 1 from the virial. Sets *seconds to the processor
   time of the run without its preparation. */
static double time_run(struct scene *scene, int way, double dt,
                       double until, double *seconds)
{
    double value[MEASURED];
    struct run r = {.scene = *scene};
    struct disks d;
    program_memory(hard_disks(&d, scene), "for the disks");
    begin(&r, way, dt);
    const double start = bench_seconds();
    if (way < WAYS)
        gas_by_steps(&r, until, value);
    else if (way == LOCATED)
        value[VIRIAL] = gas_located(&r.scene, dt, until);
    else
        gas_by_events(&d, until, value);
    *seconds = bench_seconds() - start;
    disks_free(&d);
    end(&r);
    return value[VIRIAL];
}

/* Sets *virial to the average of Z - 1 over the runs. Sets *cost to the
   median processor time per simulated second, where the warm-up counts as
   simulated time. */
static void cost_of(const struct study *s, double packing, int way,
                    double dt, struct blocks_average *virial, double *cost)
{
    static double values[MOST_RUNS], seconds[MOST_RUNS];
    const double until = length_of(way, usual_length);
    for (uint64_t i = 0; i < own.runs; ++i) {
        struct scene scene;
        const double area = 250 * 3.14159265358979324 * 0.01 / packing;
        const double height = sqrt(area / 1.5);
        make_scene(&scene, "gas",
                   GALLERY_CHOICES({"width", 1.5 * height},
                                   {"height", height}, {"lattice", 1},
                                   {"seed", (double)(s->seed + i)}));
        values[i] = time_run(&scene, way, dt, until, &seconds[i]);
    }
    *virial = blocks_average_of(own.runs, values);
    *cost = bench_median(seconds, own.runs) /
            (length_of(way, warm_time) + until);
}

static const int cost_ways[] = {APPROACHING, BACK, LOCATED};

static const struct {
    const char *name, *text;
} cost_columns[] = {
    {"approaching", "processor time of a second"},
    {"back", "processor time of a second"},
    {"located", "the same, of 4 + 16 s, the others 20 + 60 s"}};

enum { COSTS = 14 };

/* Completes and writes a row that contains event-driven results. It begins
   with the name that the book cites. The error of located contacts does not
   depend on the step, so they are run only if `all` is true. */
static void compare_step(struct study *s, double dt, bool all,
                         double row[COSTS])
{
    struct blocks_average found;
    row[1] = dt;
    for (int k = 0; k < 3; ++k) {
        double *at = &row[5 + 3 * k];
        at[0] = at[1] = at[2] = NAN;
        if (cost_ways[k] == LOCATED && !all)
            continue;
        cost_of(s, row[0], cost_ways[k], dt, &found, at);
        at[1] = fabs(1 + found.mean - row[3]) / row[3];
        at[2] = hypot(found.error, row[4]) / row[3];
    }
    table_print(s->out, "%g-%g", row[0], dt);
    for (int c = 0; c < COSTS; ++c)
        table_print(s->out, " %.9g", row[c]);
    table_print(s->out, "\n");
}

/* Writes the error of Z and the cost for four packings and seven steps.
   At packing 0.7, locating each contact in time would take too long. */
static void study_cost(struct study *s)
{
    static const double packings[] = {0.1, 0.3, 0.5, 0.7};
    TABLE_COLUMNS(s->out, {"row", "", "packing and dt"},
                  {"packing", "", "of 250 disks of radius 0.1 m"},
                  {"dt", "s", "step; v = 1 m/s"},
                  {"events", "s", "processor time of a second"},
                  {"Z", "", "1 + virial/(2 N kT), by events"},
                  {"error", "", "its statistical error"});
    for (int k = 0; k < 3; ++k)
        TABLE_COLUMNS(s->out,
                      {cost_columns[k].name, "s", cost_columns[k].text},
                      {"dZ/Z", "", "relative error of Z, absolute"},
                      {"error", "", "its statistical error"});
    bench_machine(s->out);
    for (size_t k = 0; k < 4 && !progress_signal(); ++k) {
        struct blocks_average truth;
        double row[COSTS] = {packings[k]};
        cost_of(s, packings[k], WAYS, 1, &truth, &row[2]);
        row[3] = 1 + truth.mean;
        row[4] = truth.error;
        for (int i = 0; i < DTS; ++i)
            compare_step(s, dts[i], i % 2 == 1 && packings[k] < 0.6, row);
        table_print(s->out, "\n\n");
    }
}

static const struct study_entry studies[] = {
    {"pressure", study_pressure, "of the gas, by steps and events", NULL},
    {"law", study_law, "what the pressure loses",
     STUDY_KEYS({"slope", "1", "d ln g/d ln r at contact"},
                {"error", "1", "its standard error"},
                {"density", "1", "d ln g/d ln eta"},
                {"hit", "1", "what a collision yields less"},
                {"rate", "1", "how many fewer collisions"},
                {"share", "1", "(Z - 1)/Z"},
                {"law", "1", "loss of Z, relative, in units of v dt/2r"},
                {"virial_slope", "1/s", "of Z in dt, by the law"})},
    {"checks", study_checks, "and what they see",
     STUDY_KEYS(
         {"<check>_<way>_<dt>", "1", "what it finds; dt in 1/100 s"})},
    {"rows", study_rows, "what leaves a row of balls",
     STUDY_KEYS(
         {"wide", "m/s", "worst difference from events"},
         {"narrow", "m/s", "the same"}, {"up", "m/s", "the same"},
         {"down", "m/s", "the same"},
         {"n_<row>", "1", "collisions, by events"},
         {"<way>_<row>_<i>", "m/s", "velocity of ball i at the end"})},
    {"late", study_late, "and when", NULL},
    {"rest", study_rest, "a cradle's energy",
     STUDY_KEYS({"difference", "1", "of the energies, relative"},
                {"left", "1", "share of the energy, by steps"})},
    {"break", study_break, "the first shot of a game",
     STUDY_KEYS({"orders", "m", "ascending from descending"},
                {"halved", "m", "step from half of it"},
                {"ascending", "m", "from the nearest outcome by events"},
                {"deepest", "m", "the same"},
                {"outcomes", "1", "by events, more than 1 mm apart"})},
    {"moment", study_moment, "of contact, found inside a step",
     STUDY_KEYS(
         {"order_<way>", "1", "of the error, over a range of steps"},
         {"collisions", "1", "of three balls in 1 s"},
         {"located", "m", "largest error of them without attraction"},
         {"stepwise", "m", "the same"},
         {"bounce", "m", "largest error of a ball, 1000 bounces"},
         {"bounces", "1", "until one rests"})},
    {"touch", study_touch, "of stiff springs",
     STUDY_KEYS(
         {"formula", "1", "restitution at zeta = 0.2"},
         {"restitution", "1", "by steps"},
         {"hertz_formula", "s", "contact of two"},
         {"hertz_time", "s", "by steps"},
         {"<way>", "m/s", "worst difference from what events say"},
         {"<way>_<i>", "m/s", "velocity of ball i at the end"},
         {"energy_01", "1", "worst error of a blow, omega dt = 0.1"},
         {"least_2", "1", "energy that comes back, omega dt = 2"},
         {"most_2", "1", "the same"},
         {"<way>_in_<n>", "m/s", "worst error of a blow in n steps"})},
    {"cost", study_cost, "error against processor time", NULL},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study pressure, checks, cost"},
    {"runs", 'n', "N", "with different starts (8)"},
    {"", 0, NULL, "--study law"},
    {"until", 'u', "T", "how long, s (600)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'n': own.runs = options_count(o, 2, MOST_RUNS); break;
    case 'u': own.until = options_real(o, 0.01, 1e6); break;
    }
}

STUDY_MAIN(.name = PROGRAM,
           .purpose = "Measure spheres in steps, and what fails.",
           .events = "rows", .studies = studies, .seeds = 1000000000,
           .drawing = "--study pressure, law, checks, cost",
           .options = entries, .take = take_option)
