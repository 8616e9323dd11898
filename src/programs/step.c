/* Steps a scene through time and writes the observables, row by row. */
#include "forces/adaptive.h"
#include "forces/checkpoint.h"
#include "forces/motion.h"
#include "forces/observables.h"
#include "forces/opencl.h"
#include "forces/reference.h"
#include "toolbox/bench.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"
#include "toolbox/replace.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "step"

enum sums { SUMS_AUTO, SUMS_PLAIN, SUMS_COMPENSATED };
enum { STEPWISE, LOCATED }; /* contacts */

static const char *const contact_names[] = {"stepwise", "located", NULL};

static struct {
    const char *scene, *method;
    double dt;    /* s; 0: the scene's */
    double until; /* s; NaN: 1000 steps */
    double every; /* s; 0: 1/100 or 1/1000 of the run */
    const char *observe;
    const char *track;
    int threads, kernel;
    double theta;
    size_t contact, rule, shift, order; /* options for contacts */
    size_t sums;
    bool resume;
    double bound, tolerance;
    double checkpoint; /* wall-clock time between checkpoints, s */
    const char *output, *summary, *save, *command;
} given = {.method = "leapfrog",
           .until = NAN,
           .threads = 1,
           .theta = 0.5,
           .bound = 10,
           .tolerance = 1e-13,
           .checkpoint = 60,
           .summary = "/dev/null"};

/* Texts generated from the table of methods in stepping.c: the names and
   the help of --method, and the headings of the options for adaptive and
   for other methods. outside_name is the name of GSL's adaptive method,
   which is not in that table. */
static const char *method_names[STEPPING_MOST + 2];
static const char outside_name[] = "rk8pd";
static char method_help[128 * STEPPING_MOST] = "how to step:";
static char adaptive_names[64 * STEPPING_MOST];
static char adaptive_heading[80 * STEPPING_MOST];
static char equal_heading[80 * STEPPING_MOST];

static void list_methods(void)
{
    size_t n = 0;
    char *help = method_help + strlen(method_help);
    for (const struct stepping_method *m = stepping_methods; m->name; ++m) {
        method_names[n++] = m->name;
        help += sprintf(help, "\n%s, order %d: %s", m->name, m->order,
                        m->about);
    }
    method_names[n] = outside_name;
    sprintf(help, "\n%s: GSL's, adaptive within each step\n(leapfrog)",
            outside_name);
    char *names = adaptive_names;
    for (const struct stepping_method *m = stepping_methods; m->name; ++m)
        if (m->adaptive)
            names += sprintf(names, "%s%s", *adaptive_names ? ", " : "",
                             m->name);
    sprintf(adaptive_heading, "--method %s, %s", adaptive_names,
            outside_name);
    sprintf(equal_heading, "no --method %s, %s", adaptive_names,
            outside_name);
}

enum ending { WHOLE, INTERRUPTED, INFINITE, STUCK, TOO_MUCH, UNWRITTEN };

/* The energy during the run, J. */
struct watch {
    double start;    /* initial energy */
    double depth;    /* largest depth of the potential in any row */
    double worst;    /* largest |E - start| in any row */
    double seen;     /* last finite energy, in or between rows */
    double when;     /* time of `seen`, s */
    uint64_t passed; /* how often pairs passed through each other before
                        this process began */
    double overlap;  /* initial overlap of colliding bodies with each other
                        or with walls, m; 0 if due to rounding */
};

struct run {
    struct scene scene;
    struct motion motion;
    struct reference reference;
    struct opencl *device; /* sums gravity; NULL if the CPU does */
    struct observables observables;
    size_t *tracked, tracks, columns;
    double *row;
    struct table *out, *summary, *save;
    bool kept; /* rows go to FILE.rows, for checkpoints */
    struct checkpoint checkpoint;
    uint64_t every, last, rows; /* steps per row; steps in the run; rows */
    double last_step;           /* length of a shorter last step, s, or 0 */
    bool last_taken;            /* the last step has been taken */
    uint64_t evaluations;       /* evaluations before this process */
    uint64_t taken;             /* steps in this process */
    double sum;                 /* checksum of the scene's file */
    double energy, time;        /* at the last row */
    struct watch watch;
    double took;    /* wall-clock time of the last batch of steps, s */
    uint64_t timed; /* steps with measured CPU time */
    double stepped; /* CPU time of the `timed` steps, s */
    double seconds; /* CPU time including rows, s */
    struct progress progress;
};

static bool is_adaptive(void)
{
    const struct stepping_method *const m = stepping_find(given.method);
    return m && m->adaptive;
}

/* Returns whether there may be a located contact that is still in the
   future. This can happen if an adaptive method has already stepped beyond
   it. A checkpoint does not store such a contact, so these runs have no
   checkpoints. */
static bool contact_may_wait(void)
{
    return is_adaptive() && given.contact == LOCATED;
}

static bool use_reference(void *with, double dt, double x[], double v[])
{
    return reference_step(with, dt, x, v);
}

/* Opens the device of --kernel opencl. Ends the program if this fails. */
static void open_device(struct run *r)
{
    struct gravity *g = &r->motion.gravity;
    char message[OPENCL_MESSAGE];
    if (given.kernel < GRAVITY_OPENCL || !r->motion.attracts)
        return;
    const bool single = given.kernel == GRAVITY_OPENCL_FLOAT;
    const struct opencl_order order = {.bodies = g->bodies,
                                       .mass = g->mass,
                                       .k2 = g->k2,
                                       .softening = g->softening,
                                       .single = single};
    r->device = opencl_open(&order, message);
    if (!r->device)
        program_refuse("--kernel: opencl: %s", message);
    g->elsewhere = opencl_add;
    g->device = r->device;
}

/* Begins the motion and applies the settings to its parts. For GSL's
   method, leapfrog supplies the time and the forces, and only its steps are
   replaced.

   Small numbers of bodies are not divided among threads, because waking a
   thread takes as long as the attraction of several hundred bodies or the
   forces of several thousand springs, and much longer on a busy machine.
   The number of threads does not affect the results, but it is written to
   the summary. */
static void set_in_motion(struct run *r)
{
    struct motion *m = &r->motion;
    const bool outside = strcmp(given.method, outside_name) == 0;
    if (!motion_begin(m, PROGRAM, &r->scene,
                      outside ? "leapfrog" : given.method, given.dt))
        exit(OPTIONS_FAILURE);
    if (given.sums != SUMS_AUTO)
        m->stepping.compensated = given.sums == SUMS_COMPENSATED;
    m->stepping.tolerance = given.tolerance;
    m->gravity.kernel = (enum gravity_kernel)given.kernel;
    if (m->gravity.kernel == GRAVITY_TREE && m->attracts)
        program_memory(gravity_use_tree(&m->gravity, given.theta),
                       "for the tree");
    if (m->attracts && m->gravity.bodies >= GRAVITY_MANY)
        m->gravity.threads = given.threads;
    if (m->bound && m->springs.bodies >= SPRINGS_SHARE)
        program_memory(springs_threads(&m->springs, given.threads),
                       "for the threads");
    m->spheres.rule = (enum spheres_rule)given.rule;
    m->spheres.shift = (enum spheres_shift)given.shift;
    m->spheres.order = (enum spheres_order)given.order;
    if (outside) {
        program_memory(reference_begin(&r->reference, m->stepping.forces,
                                       given.tolerance),
                       "for the reference");
        m->outside = use_reference;
        m->with = &r->reference;
    }
    if (given.contact == LOCATED && m->collides)
        program_memory(motion_locate(m), "for the contacts");
}

/* Returns the number of steps of dt in `time`. Sets *whole if it is an
   integer. The quotient of two decimal times is rarely an integer in
   binary, so a relative deviation of 1e-9 is allowed, but at most a
   hundredth of a step. */
static uint64_t steps_in(double time, double dt, bool *whole)
{
    const double n = time / dt;
    if (!(n < 9e15))
        program_refuse("--dt: %g takes more than 9e15 steps for %g", dt,
                       time);
    *whole = fabs(n - round(n)) <= fmin(1e-9 * n, 0.01);
    return (uint64_t)(*whole ? round(n) : n);
}

/* Sets the numbers of steps in the run and between rows. The default is a
   thousand steps and as many rows as can be drawn. Because of rounding, a
   scene saved at the end of a run may be slightly before or after --until.
   Such a scene is accepted, but the run makes no step. */
static void set_rows(struct run *r, double start)
{
    const double dt = r->motion.stepping.dt;
    const double until =
        isnan(given.until) ? start + 1000 * dt : given.until;
    const uint64_t rows = r->tracks > 0 ? 100 : 1000;
    bool whole;
    if (!(until - start >= -1e-6 * dt))
        program_refuse("--until: %.15g is before the scene's time, %.15g",
                       until, start);
    r->last = steps_in(fmax(0, until - start), dt, &whole);
    r->last_step = whole ? 0 : until - (start + (double)r->last * dt);
    if (r->last_step < 1e-12 * fmax(fabs(start), fabs(until)))
        r->last_step = 0;
    r->every = r->last / rows > 0 ? r->last / rows : 1;
    if (given.every == 0)
        return;
    r->every = steps_in(given.every, dt, &whole);
    const double nearest = fmax(1, round(given.every / dt)) * dt;
    if (!whole || r->every == 0)
        program_refuse("--every: %g is no whole number of steps of %g; the "
                       "nearest is %.10g",
                       given.every, dt, nearest);
}

/* Reads the bodies of --track in the given order. */
static void track(struct run *r, const char *text)
{
    while (true) {
        char *end = NULL;
        const unsigned long long id =
            *text >= '0' && *text <= '9' ? strtoull(text, &end, 10) : 0;
        if (!end || (*end != ',' && *end != '\0') || id >= r->scene.bodies)
            program_refuse("--track: '%s' does not begin with one of the "
                           "bodies 0 to %zu",
                           text, r->scene.bodies - 1);
        if (r->tracks == r->scene.bodies)
            program_refuse("--track: more bodies than there are");
        r->tracked[r->tracks++] = (size_t)id;
        if (*end == '\0')
            return;
        text = end + 1;
    }
}

/* Chooses the columns of a row: time, observables, and the states of the
   bodies of --track, or of all bodies if there is neither --track nor
   --observe. */
static void choose_columns(struct run *r)
{
    char message[OBSERVABLES_MESSAGE];
    r->tracked = malloc(r->scene.bodies * sizeof *r->tracked);
    program_memory(r->tracked, "for the bodies that are tracked");
    if (given.observe && !observables_read(&r->observables, given.observe,
                                           r->scene.bodies, message))
        program_refuse("--observe: %s", message);
    if (given.track)
        track(r, given.track);
    else if (!given.observe)
        for (; r->tracks < r->scene.bodies; ++r->tracks)
            r->tracked[r->tracks] = r->tracks;
    r->columns = 1 + r->observables.columns + 6 * r->tracks;
    r->row = malloc(r->columns * sizeof *r->row);
    program_memory(r->row, "for a row");
}

/* Writes the table head. The seed is 0, because there are no random
   numbers. */
static void write_head(struct run *r)
{
    table_begin(r->out, given.command, 0);
    table_column(r->out, "t", "time", "time, in the units of the scene");
    observables_head(&r->observables, r->out);
    observables_head_states(r->out, r->tracks, r->tracked);
}

static double below_zero(double energy)
{
    return energy < 0 ? -energy : 0;
}

/* Returns the sum of the parts of the energy. If the sum is finite, stores
   it as the last energy seen. */
static double add_up(struct run *r, struct motion_energy e)
{
    const double sum = e.kinetic + (e.gravity + e.springs + e.weight);
    if (isfinite(sum)) {
        r->watch.seen = sum;
        r->watch.when = motion_time(&r->motion);
    }
    return sum;
}

/* Computes the energy of a row and updates the depth of the potential.
   Called for each row rather than for each step, because with many bodies
   it takes as long as a step. */
static void find_energy(struct run *r)
{
    const struct motion_energy e = motion_energy(&r->motion);
    r->energy = add_up(r, e);
    r->watch.depth =
        fmax(r->watch.depth, below_zero(e.gravity) + below_zero(e.springs) +
                                 below_zero(e.weight));
}

/* Returns the energy that the springs would have if each length had an
   error in the tenth digit. The depth starts at this value rather than at
   0, because springs at rest have the energy of their rounding errors,
   which may grow a hundredfold in a correct run. */
static double rounding_energy(const struct scene *s)
{
    double size = 0, sum = 0;
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        size = fmax(size, fabs(s->position[c]));
    for (size_t j = 0; j < s->springs; ++j)
        sum += s->kind[s->spring[j].kind].stiffness;
    return 1e-10 * size * (1e-10 * size) * sum;
}

/* Computes the initial energy. Refuses the scene if this energy is not
   finite, because shorter steps would not help. */
static void begin_watch(struct run *r)
{
    r->watch.depth = rounding_energy(&r->scene);
    find_energy(r);
    r->watch.start = r->energy;
    const double depth = r->motion.collides ? spheres_depth(&r->scene) : 0;
    r->watch.overlap = depth > 1e-9 * r->motion.spheres.widest ? depth : 0;
    if (!isfinite(r->energy))
        program_refuse("the energy at the start is %g, expected a number: "
                       "are two bodies in one place, without a line soft?",
                       r->energy);
}

/* Computes the energy of a row. Returns whether it is finite and within the
   bound (11.16, eq:energy-bound), which is relative to the scale of the
   previous rows. If the scale is 0, as in a scene that starts at rest at
   height 0, the bound is not applied: even a gain due to rounding would
   exceed it. */
static bool energy_is_in_bounds(struct run *r)
{
    struct watch *w = &r->watch;
    const double scale = fabs(w->start) + w->depth; /* before this row */
    find_energy(r);
    const double grown = r->energy - w->start;
    if (!isfinite(grown) || (scale > 0 && grown > given.bound * scale))
        return false;
    w->worst = fmax(w->worst, fabs(grown));
    return true;
}

/* Returns the number of steps to the next larger power of two. */
static uint64_t to_power_of_two(uint64_t steps)
{
    uint64_t power = 1;
    while (power <= steps)
        power *= 2;
    return power - steps;
}

/* Returns whether the energy should be constant: there is no friction, no
   dashpot, and no contact that is a spring or loses energy. Only then does
   find_complaint examine the energy and the step of a completed run.

   Both may reveal a fault. Under Euler's method an oscillator gains energy,
   but at first stays within the bound. Under leapfrog with omega dt = 2 it
   jumps from side to side at constant energy. */
static bool is_conservative(const struct run *r)
{
    const struct scene *s = &r->scene;
    bool keeps = s->damping == 0 && !r->motion.is_soft &&
                 (!s->contact || s->restitution == 1);
    for (size_t k = 0; keeps && k < s->kinds; ++k)
        keeps = s->kind[k].damping == 0;
    return keeps;
}

enum complaint {
    NO_NOTE,
    NOTE_STEP,
    NOTE_ENERGY,
    NOTE_PASSED,
    NOTE_OVERLAP
};

/* Returns the squared angular frequency, 1/s^2, of two bodies that
   oscillate along their spring while all others are at rest: D (w_1 + w_2),
   or 0 if the bodies coincide. */
static double omega_squared(const struct scene *s,
                            const struct scene_spring *l)
{
    const size_t n = s->bodies;
    double r2 = 0, sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t a = k * n + l->a, b = k * n + l->b;
        const double d = s->position[b] - s->position[a];
        r2 += d * d;
        sum += d * d * (s->freedom[a] ? 1 / s->mass[l->a] : 0);
        sum += d * d * (s->freedom[b] ? 1 / s->mass[l->b] : 0);
    }
    return r2 > 0 ? s->kind[l->kind].stiffness * sum / r2 : 0;
}

/* Returns the product of the step and the highest angular frequency of a
   spring between two bodies (see omega_squared). If no spring is
   compressed, the fastest motion of the scene is at least as fast, so no
   step is wrongly reported as too long. In a chain the fastest motion is
   faster by a factor of up to sqrt(2), so a step may be too long without
   being reported. Then only the energy reveals it. */
static double stiffest_omega_dt(const struct run *r)
{
    const struct scene *s = &r->scene;
    double most = 0;
    for (size_t j = 0; j < s->springs; ++j)
        most = fmax(most, omega_squared(s, s->spring + j));
    return sqrt(most) * r->motion.dt;
}

/* Returns how often two bodies have passed through each other within a
   step. */
static uint64_t passed(const struct run *r)
{
    const struct motion *m = &r->motion;
    const struct spheres *p = motion_contacts(m);
    return r->watch.passed + (p ? p->passed : 0);
}

/* Returns the fault of a completed run, if any: the step is not below the
   stability limit of the method; bodies passed through each other; bodies
   overlapped at the start; or the energy error of a row exceeded a tenth of
   the scale (11.15, eq:energy-scale). Euler's and adaptive methods have the
   limit 0, which means that there is none: their faults show in the
   energy. */
static enum complaint find_complaint(const struct run *r)
{
    const double limit = r->motion.stepping.method->limit;
    const double scale = fabs(r->watch.start) + r->watch.depth;
    const bool keeps = is_conservative(r);
    if (keeps && !r->motion.outside && limit > 0 &&
        stiffest_omega_dt(r) >= limit * (1 - 1e-9))
        return NOTE_STEP;
    if (passed(r) > 0)
        return NOTE_PASSED;
    if (r->watch.overlap > 0)
        return NOTE_OVERLAP;
    return keeps && r->watch.worst > 0.1 * scale ? NOTE_ENERGY : NO_NOTE;
}

static void print_passed(const struct run *r)
{
    const struct spheres *p = motion_contacts(&r->motion);
    char first[64] = "";
    if (p && p->passed > 0)
        snprintf(first, sizeof first, " (bodies %u and %u for one)",
                 (unsigned)p->through[0], (unsigned)p->through[1]);
    const uint64_t n = passed(r);
    program_say("note: two bodies passed through each other within a step, "
                "%s%llu time%s%s: the step took them further than the sum "
                "of their radii; try a smaller --dt%s",
                n >= SPHERES_PASSED ? "at least " : "",
                (unsigned long long)n, n == 1 ? "" : "s", first,
                r->motion.collides ? ", or --contact located" : "");
}

static void print_note(const struct run *r)
{
    const enum complaint c = find_complaint(r);
    if (c == NOTE_STEP)
        program_say("note: omega dt of the stiffest spring is %.4g, and %s "
                    "bears less than %.4g: try a smaller --dt",
                    stiffest_omega_dt(r), given.method,
                    r->motion.stepping.method->limit);
    if (c == NOTE_PASSED)
        print_passed(r);
    if (c == NOTE_OVERLAP)
        program_say(
            "note: at the start bodies overlapped, or were outside of a "
            "wall, by %.3g, and what comes of that depends on the step",
            r->watch.overlap);
    if (c == NOTE_ENERGY)
        program_say(
            "note: the energy was wrong by up to %.3g %% of its scale, and "
            "nothing in the scene takes or gives any: try a smaller --dt",
            100 * r->watch.worst / (fabs(r->watch.start) + r->watch.depth));
}

/* Writes a checkpoint: the motion and the numbers that the scene does not
   contain. */
static bool keep_checkpoint(struct run *r)
{
    const struct checkpoint_numbers known = {
        .start = r->motion.stepping.start,
        .steps = (double)r->motion.stepping.steps,
        .collisions = (double)r->motion.collisions,
        .evaluations =
            (double)(r->evaluations + r->motion.stepping.evaluations +
                     r->reference.evaluations),
        .rows = (double)r->rows,
        .energy = r->watch.start,
        .depth = r->watch.depth,
        .worst = r->watch.worst,
        .passed = (double)passed(r),
        .overlap = r->watch.overlap,
        .last = r->energy,
        .scene = r->sum};
    return checkpoint_write(&r->checkpoint, &r->motion, known);
}

/* Writes a checkpoint if it is due. Returns false if writing failed. */
static bool keep_if_due(struct run *r, double *kept)
{
    const double now = r->kept ? bench_clock() : 0;
    if (!r->kept || now - *kept < given.checkpoint)
        return true;
    *kept = now;
    return keep_checkpoint(r);
}

static const char damaged[] =
    "%s.checkpoint: no checkpoint, or a damaged one";

/* Continues from a checkpoint. The number of rows must agree with the
   number of steps. */
static void resume(struct run *r, const struct checkpoint_numbers *n)
{
    const uint64_t steps = (uint64_t)n->steps;
    if (steps > r->last || n->rows != (double)(steps / r->every + 1))
        program_refuse(damaged, given.output);
    if (r->sum != 0 && r->sum != n->scene)
        program_refuse("%s: is not the scene that %s.checkpoint began "
                       "with; without --resume the run begins anew",
                       given.scene, given.output);
    r->sum = n->scene;
    motion_resume(&r->motion, n->start, steps);
    if (!checkpoint_recall(&r->checkpoint, &r->motion))
        program_refuse(damaged, given.output);
    r->motion.collisions = (uint64_t)n->collisions;
    r->evaluations = (uint64_t)n->evaluations;
    r->rows = (uint64_t)n->rows;
    r->energy = n->last;
    r->time =
        n->start + (n->rows - 1) * (double)r->every * r->motion.stepping.dt;
    r->watch = (struct watch){n->energy, n->depth, n->worst,
                              n->last,   r->time,  (uint64_t)n->passed,
                              n->overlap};
}

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static enum ending ending_of(enum stepping_end end)
{
    return end == STEPPING_DONE       ? WHOLE
           : end == STEPPING_INFINITE ? INFINITE
                                      : STUCK;
}

/* Makes at most *batch steps. Stops at the next row, at the next number of
   steps that is a power of two, and at the end. The division into batches
   does not affect the results. A batch takes about 1/30 s: short enough for
   Ctrl-C, progress and checkpoints, and long enough that these cost
   nothing.

   The speed in the summary is that of the steps alone. But reading the CPU
   clock takes as long as ten steps of two bodies, so a batch is timed only
   if the previous one took more than 10 microseconds. If few batches are
   timed, the speed includes the rows. */
static enum ending run_batch(struct run *r, uint64_t *batch)
{
    const bool timed = r->took > 1e-5;
    const double start = bench_clock();
    const double begun = timed ? bench_seconds() : 0;
    const uint64_t steps = r->motion.stepping.steps;
    const uint64_t ahead =
        least(least(r->every - steps % r->every, r->last - steps),
              to_power_of_two(steps));
    const enum stepping_end end =
        motion_run(&r->motion, least(*batch, ahead));
    if (timed) {
        r->stepped += bench_seconds() - begun;
        r->timed += r->motion.stepping.steps - steps;
    }
    r->took = bench_clock() - start;
    if (r->took > 0.05 && *batch > 1)
        *batch /= 2;
    else if (r->took < 0.02 && *batch < ahead)
        *batch *= 2;
    return ending_of(end);
}

/* Writes a row, unless its energy is out of bounds. If checkpoints are
   possible, the row goes to FILE.rows, otherwise directly into the table.
   The energy of the first row has already been examined. */
static enum ending add_row(struct run *r)
{
    if (r->rows > 0 && !energy_is_in_bounds(r))
        return TOO_MUCH;
    r->row[0] = r->time = motion_time(&r->motion);
    observables_values(&r->observables, &r->motion, r->row + 1);
    observables_states(&r->motion, r->tracks, r->tracked,
                       r->row + 1 + r->observables.columns);
    ++r->rows;
    const bool good =
        r->kept ? checkpoint_row(&r->checkpoint, r->columns, r->row)
                : table_row(r->out, r->columns, r->row);
    return good ? WHOLE : UNWRITTEN;
}

/* Makes the last step, which is shorter than the others, and writes its
   row. The last checkpoint is written before this step, so a resumed run
   repeats the step. */
static enum ending take_last_step(struct run *r)
{
    if (r->kept && !keep_checkpoint(r))
        return UNWRITTEN;
    program_memory(motion_shorten(&r->motion, r->last_step),
                   "for the last step");
    r->last_taken = true;
    const enum ending end = ending_of(motion_run(&r->motion, 1));
    return end == WHOLE ? add_row(r) : end;
}

/* Runs to the end. No checkpoint is written between a step and its row, so
   no row is lost if the run is resumed.

   The energy is also computed between rows, at steps whose numbers are
   powers of two. Otherwise a run that blows up before its second row would
   have no energy to report. These steps are few and depend only on the
   number of steps. The bound and the energy error refer only to rows. */
static enum ending run_on(struct run *r)
{
    const uint64_t *steps = &r->motion.stepping.steps;
    const double start = bench_seconds();
    const uint64_t before = *steps;
    uint64_t batch = 1;
    double kept = r->kept ? bench_clock() : 0;
    enum ending end = r->rows == 0 ? add_row(r) : WHOLE;
    while (end == WHOLE && *steps < r->last) {
        end = progress_signal() ? INTERRUPTED : run_batch(r, &batch);
        if (end == WHOLE && *steps % r->every == 0)
            end = add_row(r);
        else if (end == WHOLE && (*steps & (*steps - 1)) == 0)
            add_up(r, motion_energy(&r->motion));
        if (end == WHOLE && !keep_if_due(r, &kept))
            end = UNWRITTEN;
        progress_update(&r->progress, *steps, *steps);
    }
    r->taken = *steps - before;
    if (end == WHOLE && r->last_step > 0)
        end = take_last_step(r);
    r->seconds = bench_seconds() - start;
    return end;
}

/* Prints why a run failed, the time of the last row, and what to try first.
   For a completed run, prints the fault, if any. */
static void explain(const struct run *r, enum ending end)
{
    const size_t *body = r->motion.impact.between;
    char other[32] = "a wall";
    if (body[0] != body[1])
        snprintf(other, sizeof other, "body %zu", body[1]);
    if (end == STUCK && r->motion.impact.crowded)
        program_say("after t = %.10g contacts of body %zu and %s crowd: "
                    "only walls hold what rests; try --contact stepwise",
                    r->time, body[0], other);
    else if (end == STUCK)
        program_say("%s found no solution after t = %.10g: %s",
                    given.method, r->time,
                    is_adaptive() ? "no step is short enough"
                                  : "try a smaller --dt");
    const char *failed = r->device ? opencl_failure(r->device) : NULL;
    if (failed)
        program_say("--kernel: opencl: after t = %.10g %s", r->time,
                    failed);
    else if (end == INFINITE)
        program_say("blew up after t = %.10g (%s", r->time,
                    r->motion.orbits
                        ? "an orbit has opened): try another --method"
                        : "infinite coordinates): try a smaller --dt");
    if (end == TOO_MUCH)
        program_say("blew up after t = %.10g (energy %.4g, now %.4g): try "
                    "a smaller --dt",
                    r->time, r->watch.start, r->energy);
    if (end == WHOLE)
        print_note(r);
}

/* Opens all outputs before the run, so that an hour of computing is not
   lost because a folder is not writable. If the rows go to FILE.rows, the
   table is discarded for now and opened again at the end, because a killed
   process would leave the table's temporary file behind. */
static void open_outputs(struct run *r)
{
    r->out = program_table(given.output);
    r->summary = program_table(given.summary);
    r->save = given.save ? program_table(given.save) : NULL;
    if (!r->kept)
        return;
    table_discard(r->out);
    r->out = NULL;
}

/* Ends the program if the scene is a companion file of the output
   (FILE.rows or FILE.checkpoint) and would be overwritten. */
static void refuse_scene_as_companion(const char *suffix)
{
    char name[4096];
    snprintf(name, sizeof name, "%s%s", given.output, suffix);
    if (replace_loses(name, given.scene))
        program_refuse("--output: '%s' is the scene, which would be lost",
                       name);
}

/* Ends the program if `file`, a summary or a saved scene, has the name of a
   companion file. */
static void refuse_companion(const char *option, const char *file)
{
    const char *const suffix[] = {".rows", ".checkpoint"};
    const size_t n = strlen(given.output);
    for (size_t i = 0; file && i < 2; ++i)
        if (strncmp(file, given.output, n) == 0 &&
            strcmp(file + n, suffix[i]) == 0)
            program_refuse("--%s: '%s' is a companion of the table", option,
                           file);
}

/* Opens the checkpoint to be resumed and returns true, or reads the scene
   and returns false. */
static bool read_start(struct run *r, struct checkpoint_numbers *known)
{
    r->kept = checkpoint_possible(given.output) && !contact_may_wait();
    if (r->kept) {
        refuse_scene_as_companion(".rows");
        refuse_scene_as_companion(".checkpoint");
        refuse_companion("summary", given.summary);
        refuse_companion("save", given.save);
    }
    r->sum = checkpoint_sum(given.scene);
    const bool again =
        given.resume && r->kept && checkpoint_exists(given.output);
    if (again ? !checkpoint_resume(&r->checkpoint, PROGRAM, given.command,
                                   given.output, &r->scene, known)
              : !scene_read(&r->scene, PROGRAM, given.scene))
        exit(OPTIONS_FAILURE);
    return again;
}

/* Ends the program if an option has no effect in this scene. */
static void refuse_unused(struct options *o, const struct motion *m)
{
    const bool pulls =
        m->attracts && !m->orbits && m->gravity.bodies > GRAVITY_FEW;
    if (!pulls)
        options_refuse(o, "kernel",
                       "without gravity of more than 32 bodies");
    if (!pulls && !m->bound)
        options_refuse(o, "threads",
                       "without springs or gravity of more than 32 bodies");
    if (m->collides)
        return;
    options_refuse(o, "contact",
                   "in a scene without contacts that are sudden");
    options_refuse(o, "rule", "in a scene without contacts");
    options_refuse(o, "shift", "in a scene without contacts");
    options_refuse(o, "order", "in a scene without contacts");
}

/* Checks the command and the scene before any file is opened for writing,
   then begins or resumes the run. */
static void begin_run(struct run *r, struct options *o)
{
    struct checkpoint_numbers known = {0};
    const bool again = read_start(r, &known);
    set_in_motion(r);
    refuse_unused(o, &r->motion);
    open_device(r);
    choose_columns(r);
    set_rows(r, again ? known.start : r->scene.time);
    if (!again)
        begin_watch(r);
    open_outputs(r);
    if (again)
        resume(r, &known);
    else if (r->kept && !checkpoint_begin(&r->checkpoint, PROGRAM,
                                          given.command, given.output))
        program_leave(r->checkpoint.locked ? OPTIONS_FAILURE
                                           : EXIT_FAILURE);
}

/* Writes the table: the head and then the rows from FILE.rows. */
static bool make_table(struct run *r)
{
    r->out = table_open(PROGRAM, given.output);
    if (!r->out)
        return false;
    write_head(r);
    if (checkpoint_copy(&r->checkpoint, r->out))
        return table_close(r->out);
    table_discard(r->out);
    return false;
}

/* Completes the table and the saved scene. Returns whether everything was
   written.

   After an interruption or a failed write the checkpoint is kept, so the
   run can be continued. It is first brought up to date if the run was
   interrupted, or if the run was completed but its table could not be
   written. A run that blew up writes no checkpoint. */
static bool close_outputs(struct run *r, enum ending end)
{
    bool good = r->kept ? make_table(r) : table_close(r->out);
    const bool later = !good || end == INTERRUPTED || end == UNWRITTEN;
    if (r->kept && !r->last_taken &&
        (end == INTERRUPTED || (end == WHOLE && !good)))
        keep_checkpoint(r);
    if (r->kept)
        checkpoint_end(&r->checkpoint, later);
    if (good && r->save && (end == WHOLE || end == INTERRUPTED)) {
        program_memory(motion_note(&r->motion),
                       "for the scene to be saved");
        scene_write(&r->scene, r->save);
        good = table_close(r->save);
    } else
        table_discard(r->save);
    return good && end != UNWRITTEN;
}

/* Writes the summary. For a run that blew up, the summary contains the last
   finite energy and its time. Timings are written here and never in the
   table. */
static void summarise(const struct run *r, enum ending end)
{
    static const char *const names[] = {
        "whole", "interrupted", "infinite", "stuck", "energy", "unwritten"};
    const struct motion *m = &r->motion;
    const struct stepping *p = &m->stepping;
    static const char *const notes[] = {"none", "step", "energy", "passed",
                                        "overlap"};
    struct table *t = r->summary;
    table_text(t, "end", names[end]);
    table_text(t, "note",
               notes[end == WHOLE ? find_complaint(r) : NO_NOTE]);
    table_count(t, "bodies", r->scene.bodies);
    table_text(t, "method", given.method);
    table_text(t, "sums",
               p->own || p->compensated ? "compensated" : "plain");
    TABLE_RESULTS(t, {"dt", m->dt},
                  {"last_step", r->last_taken ? r->last_step : m->dt});
    table_count(t, "steps", r->last_taken ? r->last + 1 : p->steps);
    table_count(t, "rows", r->rows);
    table_count(t, "evaluations",
                r->evaluations + p->evaluations + r->reference.evaluations);
    table_count(t, "collisions", m->collisions);
    table_text(t, "contact", contact_names[given.contact]);
    table_count(t, "simultaneous", m->impact.simultaneous);
    table_count(t, "grazing", m->impact.grazing);
    table_count(t, "resting", m->impact.resting);
    const bool lost = end == INFINITE || end == STUCK || end == TOO_MUCH;
    const struct watch *w = &r->watch;
    const double worst =
        lost ? fmax(w->worst, fabs(w->seen - w->start)) : w->worst;
    TABLE_RESULTS(
        t, {"time", lost ? w->when : r->time}, {"energy_start", w->start},
        {"energy", lost ? w->seen : r->energy},
        {"energy_error", w->start != 0 ? worst / fabs(w->start) : worst});
    table_text(t, "kernel",
               m->attracts ? gravity_summed_by(&m->gravity) : "none");
    table_text(t, "vectors", vector_kind());
    const int pulling = m->attracts ? m->gravity.threads : 1;
    const int bound = m->bound ? m->springs.threads : 1;
    TABLE_RESULTS(t, {"threads", pulling > bound ? pulling : bound},
                  {"seconds", r->seconds},
                  {"steps_per_second",
                   r->timed > r->taken / 10 ? (double)r->timed / r->stepped
                   : r->seconds > 0         ? (double)r->taken / r->seconds
                                            : 0});
    if (!p->own)
        return;
    table_count(t, "own_steps", p->own->taken);
    table_count(t, "refused", p->own->refused);
    table_real(t, "shortest", p->own->shortest);
}

static const struct options_entry entries[] = {
    {"", 0, "SCENE", "a scene file; - is standard input"},
    {"until", 't', "T",
     "the time at which to stop (1000 steps); the last\n"
     "step may be shorter than the others"},
    {"method", 'm', "NAME", method_help},
    {"dt", 's', "H", "the time step (the scene's)"},
    {"every", 'd', "DT",
     "time from row to row, a whole number of steps\n"
     "(a hundredth of the run; without states a\n"
     "thousandth)"},
    {"observe", 'O', "NAMES",
     "instead of all states: t, energy, kinetic,\n"
     "potential, parts, momentum, angular-momentum,\n"
     "centre, temperature, collisions, x:ID, y:ID,\n"
     "z:ID, vx:ID, vy:ID, vz:ID, speed:ID,\n"
     "distance:ID:ID"},
    {"track", 'T', "ID,..", "the states of these bodies only"},
    {"kernel", 'k', "NAME",
     "of gravity: auto, portable, avx512, tree, or on a\n"
     "device opencl, opencl-float (auto)"},
    {"threads", 'j' | OPTIONS_SILENT, "N",
     "how many, for gravity from 1000 bodies on,\n"
     "springs from 10000 (1)"},
    {"bound", 'B', "B",
     "end when the energy has grown by B times\n"
     "what there was (10)"},
    {"save", 'w' | OPTIONS_WRITES, "FILE",
     "write the last state as a scene"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"", 0, NULL, "--output"},
    {"checkpoint", 'C', "S",
     "seconds from one checkpoint to the next (60)"},
    {"resume", 'R' | OPTIONS_SILENT, NULL,
     "go on from the checkpoint of -o FILE, if any"},
    {"", 0, NULL, equal_heading},
    {"sums", 'c', "NAME",
     "plain; compensated: they carry their rounding\n"
     "errors; auto: so from order six on (auto)"},
    {"", 0, NULL, "no --method rk8pd"},
    {"contact", 'l', "NAME",
     "stepwise, after each step, or located within it,\n"
     "at its moment (stepwise)"},
    {"", 0, NULL, "no --contact located"},
    {"rule", 'r', "NAME",
     "contacts: all pairs that overlap, or those\n"
     "approaching (all)"},
    {"shift", 'x', "NAME",
     "contacts: apart by radius, apart by mass, or\n"
     "back (radius)"},
    {"order", 'p', "NAME",
     "contacts: ascending, descending or deepest\n"
     "(ascending)"},
    {"", 0, NULL, "--kernel tree"},
    {"theta", 'W', "X",
     "a cell pulls as one mass from where its width is\n"
     "less than X of its distance, up to 0.57; not with\n"
     "adaptive or implicit methods (0.5)"},
    {"", 0, NULL, adaptive_heading},
    {"tolerance", 'a', "E",
     "for the estimated error of a step, as a share\n"
     "of the largest coordinate or velocity; for\n"
     "radau15 a scale, not a bound (1e-13)"},
    {0}};

static const struct table_key keys[] = {
    {"end", "word", "whole, or how the run ended early"},
    {"note", "word",
     "none, step, energy, passed or overlap: what is\nwrong with it"},
    {"bodies", "1", "of the scene"},
    {"method", "word", "of stepping"},
    {"sums", "word", "plain, or compensated"},
    {"dt", "time", "step; all units are the scene's"},
    {"last_step", "time", "the same, or shorter"},
    {"steps", "1", "taken"},
    {"rows", "1", "of the table"},
    {"evaluations", "1", "of the forces"},
    {"collisions", "1", "contacts, resolved"},
    {"contact", "word", "stepwise or located"},
    {"simultaneous", "1", "of them at once with another, located"},
    {"grazing", "1", "looked for within a step, and not there"},
    {"resting", "1", "coordinates held by walls at the end"},
    {"time", "time", "of the last row; if it blew up, last seen"},
    {"energy_start", "energy", "kinetic and potential"},
    {"energy", "energy", "at that time"},
    {"energy_error", "1", "largest, relative; of 0: in energy"},
    {"kernel", "word", "that summed gravity, or none"},
    {"vectors", "word", "instructions of plain loops here"},
    {"threads", "1", "that shared the bodies"},
    {"seconds", "s", "processor time"},
    {"steps_per_second", "1/s", "without rows, unless these are dense"},
    {"", "", "if the method is adaptive:"},
    {"own_steps", "1", "steps that it took"},
    {"refused", "1", "steps that it tried in vain"},
    {"shortest", "time", "the shortest of its steps"},
    {0}};

/* Ends the program if settings contradict each other. A tree is refused for
   adaptive and implicit methods, because its forces are discontinuous where
   a body comes so close that a cell is opened. A method that estimates its
   error from differences would mistake the jumps for errors and shorten its
   steps in vain. The equations of an implicit step might have no
   solution. */
static void check_settings(struct options *o)
{
    if (!given.scene)
        options_fail(o, "a scene is needed, as in build/bin/scene "
                        "sun-earth | step - --until 365");
    if (given.kernel < GRAVITY_OPENCL &&
        !gravity_can((enum gravity_kernel)given.kernel))
        options_fail(o, "--kernel: this machine has no %s",
                     gravity_kernels[given.kernel]);
    const struct stepping_method *const m = stepping_find(given.method);
    if (given.kernel == GRAVITY_TREE &&
        (!m || m->adaptive || m->family == STEPPING_IMPLICIT))
        options_fail(o,
                     "--kernel: the forces of a tree jump where a cell is "
                     "opened, and --method %s wants smooth ones",
                     given.method);
    if (strcmp(given.method, outside_name) == 0 && !reference_available)
        options_fail(o, "--method: this build has no rk8pd; install GSL "
                        "(apt-get install --no-install-recommends "
                        "libgsl-dev), then make");
    if (contact_may_wait()) {
        options_refuse(o, "checkpoint", "with located adaptive steps");
        options_refuse(o, "resume", "with located adaptive steps");
    }
    if (!checkpoint_possible(given.output)) {
        options_refuse(o, "checkpoint", "without -o FILE, a regular file");
        options_refuse(o, "resume", "without -o FILE, a regular file");
    }
    program_apart(o, given.output, given.summary, "table");
}

static const char *const rule_names[] = {"all", "approaching", NULL};
static const char *const shift_names[] = {"radius", "mass", "back", NULL};
static const char *const order_names[] = {"ascending", "descending",
                                          "deepest", NULL};
static const char *const sums_names[] = {"auto", "plain", "compensated",
                                         NULL};

static void read_settings(struct options *o, int argc, char *argv[])
{
    int option;
    list_methods();
    options_begin(o, PROGRAM, "Step a scene through time.", entries, argc,
                  argv);
    options_keys(o, keys);
    while ((option = options_next(o)) != -1)
        switch (option) {
        case OPTIONS_ARGUMENT:
            given.scene = options_only(o, given.scene, "scene");
            break;
        case 't': given.until = options_real(o, -INFINITY, INFINITY); break;
        case 'm':
            given.method = method_names[options_choice(o, method_names)];
            break;
        case 's': given.dt = options_positive(o, INFINITY); break;
        case 'd': given.every = options_positive(o, INFINITY); break;
        case 'O': given.observe = options_text(o); break;
        case 'T': given.track = options_text(o); break;
        case 'c': given.sums = options_choice(o, sums_names); break;
        case 'k':
            given.kernel = (int)options_choice(o, gravity_kernels);
            break;
        case 'W': given.theta = options_real(o, 0, GRAVITY_WIDEST); break;
        case 'j': given.threads = (int)options_count(o, 1, 1024); break;
        case 'r': given.rule = options_choice(o, rule_names); break;
        case 'x': given.shift = options_choice(o, shift_names); break;
        case 'l': given.contact = options_choice(o, contact_names); break;
        case 'p': given.order = options_choice(o, order_names); break;
        case 'B': given.bound = options_positive(o, INFINITY); break;
        case 'a': given.tolerance = options_real(o, 1e-15, 1); break;
        case 'w': given.save = options_text(o); break;
        case 'C': given.checkpoint = options_real(o, 0, INFINITY); break;
        case 'R': given.resume = true; break;
        case 'o': given.output = options_text(o); break;
        case 'S': given.summary = options_text(o); break;
        }
    given.command = options_command(o);
    check_settings(o);
}

/* Runs step. A run that blew up has a summary, because the way it ended is
   a result. An interrupted run has none. */
int main(int argc, char *argv[])
{
    static struct run r;
    struct options o;
    read_settings(&o, argc, argv);
    begin_run(&r, &o);
    table_keys(r.summary, keys);
    progress_catch_signals();
    progress_begin(&r.progress, PROGRAM, r.last, "steps");
    if (r.last_step > 0)
        program_say("--until: %.15g is no whole number of steps of %.15g: "
                    "the last one is shorter, %g",
                    given.until, r.motion.dt, r.last_step);
    if (!r.kept)
        write_head(&r);
    const enum ending end = run_on(&r);
    const bool whole = progress_end(&r.progress) || end != INTERRUPTED;
    explain(&r, end);
    const bool written = close_outputs(&r, end);
    summarise(&r, end);
    if (!whole || !written)
        table_discard(r.summary);
    else if (!table_close(r.summary))
        return EXIT_FAILURE;
    motion_end(&r.motion);
    opencl_close(&r.device);
    scene_free(&r.scene);
    return whole && written && end == WHOLE ? EXIT_SUCCESS : EXIT_FAILURE;
}
