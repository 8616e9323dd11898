/* Measures an oscillator, a pendulum, membranes and beams of springs. */
#include "forces/elastic.h"
#include "forces/largest.h"
#include "forces/modes.h"
#include "forces/springs.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "springs-studies"

static struct {
    double until; /* duration of the run of --study membranes, s */
} own = {.until = 40};

static void memory_or_exit(bool got)
{
    if (!got)
        program_give_up("there is no memory");
}

/* A scene, its springs, and the method that steps it. */
struct run {
    struct scene scene;
    struct springs springs;
    struct stepping stepping;
};

/* Makes a scene of the gallery with the chosen values. */
static void make(struct scene *s, const char *name,
                 const struct gallery_choice chosen[])
{
    program_check(gallery_choose(s, elastic_scenes, name, chosen));
}

static void set_off(struct run *r, const struct stepping_method *method,
                    double dt)
{
    memory_or_exit(springs_create(&r->springs, &r->scene) &&
                   stepping_begin(&r->stepping, method,
                                  springs_forces(&r->springs), dt,
                                  r->scene.position, r->scene.velocity));
    r->stepping.sweep = springs_sweep;
}

static void tidy_up(struct run *r)
{
    stepping_free(&r->stepping);
    springs_free(&r->springs);
    scene_free(&r->scene);
}

static double kinetic(const struct scene *s)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        for (size_t i = 0; i < s->bodies; ++i) {
            const double v = s->velocity[k * s->bodies + i];
            sum += s->mass[i] * v * v / 2;
        }
    return sum;
}

/* Returns the energy, J. The gravitational energy is that of the bodies
   that can move, because springs_create sets the gravity of fixed bodies to
   0. */
static double energy(const struct run *r)
{
    const struct scene *s = &r->scene;
    double sum = kinetic(s) + springs_potential(&r->springs, s->position);
    for (size_t i = 0; i < 3 * s->bodies; ++i)
        sum -=
            r->springs.gravity[i] * s->mass[i % s->bodies] * s->position[i];
    return sum;
}

/* Returns the position (in m) of a damped oscillator with m = D = 1 that
   starts at rest at q = 1 m. Uses the textbook formulas: two exponentials,
   or a cosine with a phase. g is the damping divided by the critical
   damping. */
static double by_the_book(double g, double t)
{
    const double w = sqrt(fabs(g * g - 1));
    if (g == 1)
        return exp(-t) * (1 + t);
    if (g > 1) {
        const double slow = -g + w, fast = -g - w;
        return (slow * exp(fast * t) - fast * exp(slow * t)) /
               (slow - fast);
    }
    return exp(-g * t) / w * cos(w * t - atan2(g, w));
}

/* Returns the same position as by_the_book, computed from a power series in
   y = (w t)^2 that is valid for weak, critical and strong damping. The
   series converges for all t, but at long times it loses digits, because
   its terms alternate in sign. */
static double by_series(double g, double t)
{
    const double y = (1 - g) * (1 + g) * t * t;
    double term = 1, sum = 0;
    for (int k = 0; k < 150; ++k) {
        sum += term * (1 + g * t / (2 * k + 1));
        term *= -y / ((2 * k + 1) * (2 * k + 2));
    }
    return exp(-g * t) * sum;
}

/* Writes the positions of two oscillators, whose dampings are 1 + e and 1 -
   e times the critical damping. From one row to the next e is divided by
   10^(1/4). */
static void study_critical(struct study *s)
{
    const double t = 3;
    TABLE_COLUMNS(s->out,
                  {"e", "", "damping is 1 + e times the critical one"},
                  {"q", "m", "the place at t = 3 s, by a power series"},
                  {"book", "m", "the same by two exponentials"},
                  {"q_below", "m", "the place for 1 - e"},
                  {"book_below", "m", "the same by a cosine"});
    for (int k = 4; k <= 60; ++k) {
        const double e = pow(10, -0.25 * k);
        const double q = by_series(1 + e, t), book = by_the_book(1 + e, t);
        TABLE_ROW(s->out, e, q, book, by_series(1 - e, t),
                  by_the_book(1 - e, t));
        if (k == 40)
            table_real(s->summary, "book_error", fabs(book / q - 1));
    }
}

enum { DAMPINGS = 4 };

static const double dampings[DAMPINGS] = {0.2, 1, 2, 4}; /* kg/s */

/* Writes the positions of oscillators with four dampings, stepped by
   leapfrog, and their largest error. */
static void study_regimes(struct study *s)
{
    struct run r[DAMPINGS];
    double worst = 0;
    table_column(s->out, "t", "s", "time");
    for (int k = 0; k < DAMPINGS; ++k) {
        table_column(s->out, "q", "m", "place of the mass");
        make(&r[k].scene, "oscillator",
             GALLERY_CHOICES({"damping", dampings[k]}));
        set_off(&r[k], stepping_find("leapfrog"), 0.05);
    }
    for (int n = 0; n <= 150; ++n) {
        double row[1 + DAMPINGS] = {0.1 * n};
        for (int k = 0; k < DAMPINGS; ++k) {
            row[1 + k] = r[k].scene.position[1] - 4;
            const double exact = by_series(dampings[k] / 2, row[0]);
            worst = fmax(worst, fabs(row[1 + k] - exact));
            stepping_run(&r[k].stepping, 2);
        }
        table_row(s->out, 1 + DAMPINGS, row);
    }
    table_real(s->summary, "worst", worst);
    for (int k = 0; k < DAMPINGS; ++k)
        tidy_up(&r[k]);
}

enum { DUMBBELL_ROWS = 101 };

/* Makes a free dumbbell: two masses of 1 kg along x, joined by a spring
   that is stretched by a tenth. It rotates about z. */
static void make_dumbbell(struct scene *s, bool axial)
{
    memory_or_exit(scene_create(s, 2) && scene_add_kind(s, 100, 0.5));
    s->position[0] = -0.5;
    s->position[1] = 0.5;
    memory_or_exit(scene_add_spring(s, 0, 1, 0, -1));
    s->position[0] -= 0.05;
    s->position[1] += 0.05;
    s->velocity[2] = -1;
    s->velocity[3] = 1;
    s->axial = axial;
}

/* Returns the angular momentum along z, kg m^2/s. */
static double spin(const struct scene *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i] * (s->position[i] * s->velocity[s->bodies + i] -
                             s->position[s->bodies + i] * s->velocity[i]);
    return sum;
}

/* Writes the angular momenta and energies of two dumbbells. Compares the
   angular momentum of the first with (10.2, eq:spin-decay), where c/mu is
   1/s here. */
static void study_spin(struct study *s)
{
    struct run r[2];
    double row[5] = {0}, start = 0, law = 0;
    TABLE_COLUMNS(s->out, {"t", "s", "time"},
                  {"L_full", "kg m^2/s", "dashpot as printed"},
                  {"L_axial", "kg m^2/s", "dashpot along the axis"},
                  {"E_full", "J", "energy, dashpot as printed"},
                  {"E_axial", "J", "energy, dashpot along the axis"});
    for (int k = 0; k < 2; ++k) {
        make_dumbbell(&r[k].scene, k == 1);
        set_off(&r[k], stepping_find("leapfrog"), 0.001);
        start = spin(&r[k].scene);
    }
    for (int i = 0; i < DUMBBELL_ROWS; ++i) {
        row[0] = stepping_time(&r[0].stepping);
        for (int k = 0; k < 2; ++k) {
            row[1 + k] = spin(&r[k].scene);
            row[3 + k] = energy(&r[k]);
            stepping_run(&r[k].stepping, 50);
        }
        law = fmax(law, fabs(row[1] / (start * exp(-row[0])) - 1));
        table_row(s->out, 5, row);
    }
    TABLE_RESULTS(s->summary, {"left", row[1] / start}, {"off_law", law},
                  {"axial_change", row[2] / start - 1},
                  {"axial_energy", row[4]});
    tidy_up(&r[0]);
    tidy_up(&r[1]);
}

/* Writes the path of the double pendulum. The method and the step are
   accurate enough for any figure. */
static void study_path(struct study *s)
{
    const double every = 0.02, until = 10;
    struct run r;
    make(&r.scene, "double-pendulum", NULL);
    set_off(&r, stepping_find("yoshida4"), every / 40);
    const double *x = r.scene.position, *z = x + 6, start = energy(&r);
    TABLE_COLUMNS(s->out, {"t", "s", "time"}, {"x1", "m", "upper body"},
                  {"z1", "m", "upper body"}, {"x2", "m", "lower body"},
                  {"z2", "m", "lower body"},
                  {"stretch", "m", "of the upper spring"});
    for (double row = 0; row * every <= until; ++row) {
        const double length = hypot(x[1], z[1] - 1);
        TABLE_ROW(s->out, row * every, x[1], z[1], x[2], z[2], length - 1);
        stepping_run(&r.stepping, 40);
    }
    table_real(s->summary, "energy", start);
    tidy_up(&r);
}

/* The coordinates x1, z1, x2, z2 (in m) of the double pendulum after 10 s,
   computed by another program in quadruple precision. */
static const double after_10[4] = {-.156264701442401, .0112096197458345,
                                   -.921375731195946, -1.25031461636596};

/* Sets place[] to these coordinates of a double pendulum. */
static void take_place(const struct scene *s, double place[4])
{
    const double *const x = s->position, *const z = x + 6;
    memcpy(place, (double[]){x[1], z[1], x[2], z[2]}, 4 * sizeof *place);
}

/* Runs the double pendulum for 10 s in n steps. Sets row[] to dt, number of
   evaluations, position error, energy change and processor time. Returns
   whether the run finished with an error below 3 m. */
static bool swing_of(const struct stepping_method *method, uint64_t n,
                     double row[5])
{
    struct run r;
    double place[4];
    make(&r.scene, "double-pendulum", NULL);
    set_off(&r, method, 10 / (double)n);
    const double before = energy(&r), start = bench_seconds();
    const enum stepping_end end = stepping_run(&r.stepping, n);
    row[4] = bench_seconds() - start;
    row[0] = r.stepping.dt;
    row[1] = (double)r.stepping.evaluations;
    take_place(&r.scene, place);
    row[2] = largest_difference(place, after_10, 4);
    row[3] = energy(&r) - before;
    tidy_up(&r);
    return end == STEPPING_DONE && row[2] < 3;
}

/* Writes the errors of all methods. The step starts at 0.2 s and is halved
   until the error is near the rounding error or there are too many
   evaluations. If `timed`, adds a column with the processor time. Without
   it, the table is the same on all machines. */
static void write_errors(struct study *s, bool timed)
{
    double row[5];
    if (timed)
        bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"dt", "s", "step"},
                  {"n", "", "evaluations of the forces"},
                  {"error", "m", "of a place, after 10 s"},
                  {"energy", "J", "change of the energy"});
    if (timed)
        table_column(s->out, "cost", "s", "processor time");
    for (const struct stepping_method *m = NULL; (m = stepping_next(m));) {
        table_print(s->out, "# %s\n", m->name);
        for (uint64_t n = 50; n <= 160000; n *= 2) {
            if (!swing_of(m, n, row) || progress_signal())
                continue;
            table_row(s->out, timed ? 5 : 4, row);
            if (row[2] < 3e-13 || row[1] > 1500000)
                break;
        }
        table_print(s->out, "\n\n");
    }
    swing_of(stepping_find("leapfrog"), 10000, row);
    table_real(s->summary, "leapfrog_1e-3", row[2]);
    swing_of(stepping_find("rk4"), 10000, row);
    table_real(s->summary, "rk4_1e-3", row[2]);
    swing_of(stepping_find("implicit-midpoint"), 100, row);
    table_real(s->summary, "midpoint_0.1", row[2]);
}

static const struct table_key pendulum_keys[] = {
    {"leapfrog_1e-3", "m", "error of place after 10 s, dt 1 ms"},
    {"rk4_1e-3", "m", "the same"},
    {"midpoint_0.1", "m", "the same, dt 0.1 s"},
    {0}};

static void study_errors(struct study *s)
{
    write_errors(s, false);
}

static void study_work(struct study *s)
{
    write_errors(s, true);
}

enum { WAYS = 3 };

static const char *const damping_ways[WAYS] = {"rk4", "leapfrog",
                                               "yoshida4"};
static const double damping_step = 0.025; /* s */

/* Writes the stretch of the stiff spring for RK4 and leapfrog with a step
   near the stability limit of RK4, and for Yoshida's method with a small
   step. The summary gets the range of the stretch in the last rows. */
static void study_silent(struct study *s)
{
    double most[WAYS], least[WAYS];
    struct run r[WAYS];
    table_column(s->out, "t", "s", "time");
    for (int k = 0; k < WAYS; ++k) {
        table_column(s->out, damping_ways[k], "m",
                     "stretch of the upper spring");
        make(&r[k].scene, "double-pendulum", NULL);
        set_off(&r[k], stepping_find(damping_ways[k]),
                k == 2 ? damping_step / 50 : damping_step);
    }
    for (int i = 0; i <= 400; ++i) {
        double row[1 + WAYS] = {i * damping_step};
        for (int k = 0; k < WAYS; ++k) {
            const double *const x = r[k].scene.position;
            row[1 + k] = hypot(x[1], x[7] - 1) - 1;
            most[k] = i < 392 ? row[1 + k] : fmax(most[k], row[1 + k]);
            least[k] = i < 392 ? row[1 + k] : fmin(least[k], row[1 + k]);
            stepping_run(&r[k].stepping, k == 2 ? 50 : 1);
        }
        table_row(s->out, 1 + WAYS, row);
    }
    for (int k = 0; k < WAYS; ++k) {
        table_real(s->summary, damping_ways[k], most[k] - least[k]);
        tidy_up(&r[k]);
    }
}

/* A double pendulum whose bodies 0 and 1 are joined by a rod of 1 m
   instead of a spring. a[] contains the accelerations (in m/s^2) without
   the force of the rod, in the order of the scene's coordinates. */
struct rod {
    struct run run;
    double a[9];
};

/* Returns the scalar product, in the x-z plane, of the rod (the vector from
   body 0 to body 1, with positions r) and the velocity a of body 1. Body 0
   is at rest. */
static double along(const double r[], const double a[])
{
    return (r[1] - r[0]) * a[1] + (r[7] - r[6]) * a[7];
}

/* Returns the smaller root of (10.6, eq:rod). After a free drift from r to
   x, this multiple of the rod vector at r must be subtracted to make the
   rod 1 m long again. */
static double shorten(const double r[], const double x[])
{
    const double dx = x[1] - x[0], dz = x[7] - x[6];
    const double b = (r[1] - r[0]) * dx + (r[7] - r[6]) * dz;
    const double c = dx * dx + dz * dz - 1;
    return c / (b + sqrt(b * b - c));
}

/* Makes a step of RATTLE: kick, drift, length correction, kick, velocity
   correction. The coordinates x and z of body 1 have the indices 1 and
   7. */
static void rod_step(struct rod *o, double dt)
{
    double *const x = o->run.scene.position, *const v =
                                                 o->run.scene.velocity;
    double r[9];
    memcpy(r, x, sizeof r);
    for (size_t i = 0; i < 9; ++i) {
        v[i] += dt / 2 * o->a[i];
        x[i] += dt * v[i];
    }
    const double lambda = shorten(r, x);
    for (size_t i = 1; i < 9; i += 6) {
        x[i] -= lambda * (r[i] - r[i - 1]);
        v[i] -= lambda * (r[i] - r[i - 1]) / dt;
    }
    springs_accelerate(&o->run.springs, x, v, o->a);
    for (size_t i = 0; i < 9; ++i)
        v[i] += dt / 2 * o->a[i];
    const double rate = along(x, v);
    v[1] -= rate * (x[1] - x[0]);
    v[7] -= rate * (x[7] - x[6]);
}

/* Runs the pendulum with a rod for 10 s in n steps and sets place[] to its
   final coordinates. The upper spring has stiffness 0, because the rod
   replaces it. Returns whether the coordinates are finite. */
static bool rod_swing(uint64_t n, double place[4])
{
    struct rod o = {0};
    make(&o.run.scene, "double-pendulum",
         GALLERY_CHOICES({"stiffness1", 0}));
    set_off(&o.run, stepping_find("leapfrog"), 10 / (double)n);
    springs_accelerate(&o.run.springs, o.run.scene.position,
                       o.run.scene.velocity, o.a);
    for (uint64_t i = 0; i < n; ++i)
        rod_step(&o, 10 / (double)n);
    take_place(&o.run.scene, place);
    tidy_up(&o.run);
    return isfinite(place[0] + place[1] + place[2] + place[3]);
}

/* Sets place[] to the coordinates after 10 s of a double pendulum whose
   upper spring has the given stiffness (in N/m). A stiffer spring is
   computed with shorter steps. */
static void spring_swing(double stiffness, double place[4])
{
    const uint64_t n = (uint64_t)(10 * 100 * sqrt(stiffness / 100)) + 1000;
    struct run r;
    make(&r.scene, "double-pendulum",
         GALLERY_CHOICES({"stiffness1", stiffness}));
    set_off(&r, stepping_find("kahan-li8"), 10 / (double)n);
    stepping_run(&r.stepping, n);
    take_place(&r.scene, place);
    tidy_up(&r);
}

/* Writes two blocks: the error of the rod against the step, and the
   distance between the pendulums with spring and rod after 10 s against the
   stiffness of the spring. */
static void study_rod(struct study *s)
{
    double rigid[4], place[4];
    rod_swing(100000, rigid);
    TABLE_COLUMNS(s->out, {"dt", "s", "step; next block: stiffness, N/m"},
                  {"error", "m",
                   "of the rod's step; next block: from spring to rod"});
    for (uint64_t n = 10; n <= 20480; n *= 2)
        if (rod_swing(n, place))
            TABLE_ROW(s->out, 10 / (double)n,
                      largest_difference(place, rigid, 4));
    table_print(s->out, "\n\n");
    for (double stiffness = 100; stiffness < 2e6; stiffness *= sqrt(10)) {
        spring_swing(stiffness, place);
        TABLE_ROW(s->out, stiffness, largest_difference(place, rigid, 4));
    }
    table_real(s->summary, "spring_to_rod",
               largest_difference(after_10, rigid, 4));
    rod_swing(100, place);
    table_real(s->summary, "rod_0.1", largest_difference(place, rigid, 4));
    rod_swing(20, place);
    table_real(s->summary, "rod_0.5", largest_difference(place, rigid, 4));
}

/* Makes the double pendulum, or a taut membrane, at rest. */
static void make_at_rest(struct scene *s, bool pendulum)
{
    if (!pendulum) {
        make(s, "membrane",
             GALLERY_CHOICES({"rest", 0.8}, {"amplitude", 0},
                             {"damping", 0}));
        return;
    }
    make(s, "double-pendulum",
         GALLERY_CHOICES({"angle1", 0}, {"angle2", 0}));
    s->position[7] = -2 * 1.8 / 5000;
    s->position[8] = s->position[7] - 1 - 1.8 / 5;
}

/* Displaces a scene at rest by 1e-9 times the shape of its fastest mode.
   Returns the angular frequency of this mode, rad/s. */
static double disturb(struct scene *s)
{
    struct springs p;
    struct modes m;
    memory_or_exit(springs_create(&p, s) &&
                   modes_find(&m, &p, s->position));
    const double *shape = m.shape + (m.size - 1) * m.size;
    for (size_t i = 0; i < m.size; ++i)
        s->position[m.coordinate[i]] += 1e-9 * shape[i];
    const double fastest = sqrt(m.square[m.size - 1]);
    modes_free(&m);
    springs_free(&p);
    return fastest;
}

/* Returns whether a disturbance of 1e-9 m grows within `steps` steps with
   omega dt = phase. It grows if it reaches 1 cm, or if its maximum in the
   last quarter of the steps is more than 1.5 times both its initial size
   and its maximum in the second quarter.

   The factor 1.5 is small because growth is slow: for RK4 at 1 + d times
   the limit, the amplitude grows by a factor of only 1 + 7d per step. A
   factor of a thousand would give a limit that is 2e-4 too high. With 1.5
   and 4000 steps the limit is accurate to 3e-5. */
static bool grows(const struct stepping_method *method, bool pendulum,
                  double phase, uint64_t steps)
{
    struct run r;
    struct scene rest;
    double far[4] = {0}; /* largest displacement in each quarter, m */
    make_at_rest(&r.scene, pendulum);
    memory_or_exit(scene_copy(&rest, &r.scene));
    const double fastest = disturb(&r.scene);
    const size_t size = 3 * rest.bodies;
    const double start =
        largest_difference(r.scene.position, rest.position, size);
    set_off(&r, method, phase / fastest);
    bool small = true;
    for (uint64_t k = 0; k < steps && small; k += 50) {
        double *most = &far[4 * k / steps];
        small = stepping_run(&r.stepping, 50) == STEPPING_DONE;
        const double now =
            largest_difference(r.scene.position, rest.position, size);
        *most = fmax(*most, now);
        small = small && now < 1e-2;
    }
    tidy_up(&r);
    scene_free(&rest);
    return !small || far[3] > 1.5 * fmax(start, far[1]);
}

/* Returns the stability limit of omega dt, or 0 if the method is unstable
   even at `low`, or INFINITY if it is stable up to 20. Increases omega dt
   from `low` by 1 per cent until the method is unstable, and then bisects.

   The increments must be smaller than the narrowest unstable interval,
   because some methods are stable again above it. The narrowest interval is
   that of Kahan and Li, 3.0965 to 3.1401. Increments of 2 per cent missed
   it and gave 5.6. */
static double find_limit(const struct stepping_method *m, bool pendulum,
                         uint64_t steps, double low)
{
    double high = low;
    if (grows(m, pendulum, low, steps))
        return 0;
    do {
        low = high;
        high *= 1.01;
    } while (high < 20 && !grows(m, pendulum, high, steps));
    if (high >= 20)
        return INFINITY;
    while (high - low > 1e-5 * low) {
        const double middle = (low + high) / 2;
        if (grows(m, pendulum, middle, steps))
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* Sets limit[] to the limits of omega dt for the pendulum and the membrane.
   The search for the membrane's limit starts just below that of the
   pendulum. Implicit methods are only tested with one large step length. */
static void find_limits(const struct stepping_method *m, double limit[2])
{
    if (m->family == STEPPING_IMPLICIT) {
        const bool stable = !grows(m, true, 20, 4000);
        limit[0] = limit[1] = stable ? INFINITY : 0;
        return;
    }
    limit[0] = limit[1] = find_limit(m, true, 4000, 0.5);
    if (limit[0] > 0)
        limit[1] = find_limit(m, false, 2000, 0.95 * limit[0]);
}

static void study_limits(struct study *s)
{
    TABLE_COLUMNS(s->out, {"limit", "", "omega dt, from the theory"},
                  {"pendulum", "", "omega dt, found with the pendulum"},
                  {"dt_1", "s", "the same step"},
                  {"membrane", "", "omega dt, found on the membrane"},
                  {"dt_2", "s", "the same step"});
    for (const struct stepping_method *m = stepping_next(NULL);
         m && !progress_signal(); m = stepping_next(m)) {
        double limit[2];
        find_limits(m, limit);
        /* The divisors are the frequencies of the fastest modes, from
           (10.5, eq:pendulum-limit) and from (10.9, eq:membrane-dispersion)
           with D along one axis. */
        const double dt[2] = {limit[0] / 70.74605996, limit[1] / 15.103518};
        table_print(s->out, "# %s\n", m->name);
        TABLE_ROW(s->out, m->limit, limit[0], dt[0], limit[1], dt[1]);
        TABLE_RESULTS_OF(s->summary, m->name, {"pendulum", dt[0]},
                         {"membrane", dt[1]});
    }
}

/* Makes three bodies in a row along x, joined by two springs at rest length
   (10.7, eq:loose). The middle body moves only along z and starts at z =
   a. */
static void put_between(struct scene *s, double a)
{
    memory_or_exit(scene_create(s, 3) && scene_add_kind(s, 50, 0));
    for (size_t i = 0; i < 3; ++i) {
        s->position[i] = 2.0 / 7 * (double)i;
        for (size_t k = 0; k < 3; ++k)
            s->freedom[3 * k + i] = i == 1 && k == 2;
    }
    memory_or_exit(scene_add_spring(s, 0, 1, 0, -1) &&
                   scene_add_spring(s, 1, 2, 0, -1));
    s->position[7] = a;
}

/* Returns the period (in s) of a mass between two springs at rest length
   that is displaced sideways by `a`. The period is the time between its
   first and its third passage through the middle. */
static double period(double a)
{
    const double guess = 0.3 / a;
    struct run r;
    double before = a, t[3];
    int times = 0;
    put_between(&r.scene, a);
    const double *z = &r.scene.position[7], *v = &r.scene.velocity[7];
    set_off(&r, stepping_find("yoshida6"), guess / 1024);
    while (times < 3) {
        stepping_run(&r.stepping, 1);
        if (before * *z < 0)
            t[times++] = stepping_time(&r.stepping) - *z / *v;
        before = *z;
    }
    tidy_up(&r);
    return t[2] - t[0];
}

static void study_quartic(struct study *s)
{
    TABLE_COLUMNS(s->out, {"A", "m", "amplitude"}, {"T", "s", "period"},
                  {"AT", "m s", "their product"});
    for (double a = 0.4; a > 0.002; a /= sqrt(2)) {
        const double t = period(a);
        TABLE_ROW(s->out, a, t, a * t);
    }
    TABLE_RESULTS(s->summary, {"T_0.1", period(0.1)},
                  {"AT", 0.002 * period(0.002)});
}

/* Returns the amplitude (in m) of the mode with r half waves along x and
   `half` along y in the displacement of an n x n membrane along z.
   Projects the displacement on the shape of the mode, which is orthogonal
   on the grid to the shapes of all other modes. */
static double amplitude(const struct scene *s, size_t n, size_t r,
                        size_t half)
{
    const double *const z = s->position + 2 * s->bodies;
    const double pi = acos(-1), step = pi / (double)(n - 1);
    double sum = 0;
    for (size_t i = 0; i < n * n; ++i)
        sum += z[i] * sin(step * (double)(r * (i % n))) *
               sin(step * (double)(half * (i / n)));
    return 4 * sum / (double)((n - 1) * (n - 1));
}

/* Returns the root of the sum of the squared amplitudes of all modes except
   the first, divided by `a`. */
static double others(const struct scene *s, size_t n, double a)
{
    const double *const z = s->position + 2 * s->bodies;
    const double first = amplitude(s, n, 1, 1);
    double sum = 0;
    for (size_t i = 0; i < n * n; ++i)
        sum += z[i] * z[i];
    sum = 4 * sum / (double)((n - 1) * (n - 1)) - first * first;
    return sqrt(fmax(sum, 0)) / a;
}

enum { MEMBRANES = 3 };

/* Initial amplitudes of the three membranes, m. Two are at rest length; the
   first of these moves only along z and the second along all axes. The
   third is taut. */
static const double lifted[MEMBRANES] = {0.1, 0.1, 0.01};

static void study_membranes(struct study *s)
{
    struct run r[MEMBRANES];
    table_column(s->out, "t", "s", "time");
    for (int k = 0; k < MEMBRANES; ++k) {
        TABLE_COLUMNS(s->out,
                      {"a", "", "of the first mode, over the start"},
                      {"rest", "", "of the other modes, the same"});
        make(&r[k].scene, "membrane",
             GALLERY_CHOICES({"rest", k == 2 ? 0.8 : 1},
                             {"amplitude", lifted[k]}, {"damping", 0},
                             {"free", k > 0}));
        set_off(&r[k], stepping_find("pefrl"), 0.02);
    }
    for (int row = 0; 0.1 * row <= own.until; ++row) {
        double values[1 + 2 * MEMBRANES] = {0.1 * row};
        for (int k = 0; k < MEMBRANES; ++k) {
            values[2 * k + 1] = amplitude(&r[k].scene, 8, 1, 1) / lifted[k];
            values[2 * k + 2] = others(&r[k].scene, 8, lifted[k]);
            stepping_run(&r[k].stepping, 5);
        }
        table_row(s->out, 1 + 2 * MEMBRANES, values);
        char which[16];
        snprintf(which, sizeof which, "%d", row / 10);
        if (row == 10 || row == 50 || row == 100 || row == 400 ||
            row == 4000)
            TABLE_RESULTS_OF(s->summary, which, {"a", values[1]},
                             {"rest", values[2]}, {"free_rest", values[4]},
                             {"taut_rest", values[6]});
    }
    for (int k = 0; k < MEMBRANES; ++k)
        tidy_up(&r[k]);
}

/* Turns the displacement of a membrane from z to `axis`. Returns the body
   with the largest displacement and sets *home to the rest position of this
   body along that axis. */
static size_t turn_to(struct scene *s, size_t axis, double *home)
{
    double *const z = s->position + 2 * s->bodies;
    double *const moved = s->position + axis * s->bodies;
    size_t body = 0;
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        const double a = z[i];
        if (fabs(a) > most) {
            body = i;
            most = fabs(a);
            *home = axis == 2 ? 0 : moved[i];
        }
        z[i] = 0;
        moved[i] += a;
    }
    return body;
}

/* Returns the duration (in s) of ten half periods in which coordinate `at`
   oscillates about `home`. Interpolates linearly within a step. */
static double ten_halves(struct run *r, size_t at, double home)
{
    double first = 0, before = r->scene.position[at] - home;
    for (int times = 0;;) {
        stepping_run(&r->stepping, 1);
        const double now = r->scene.position[at] - home;
        if (before * now < 0) {
            const double t =
                stepping_time(&r->stepping) - now / r->scene.velocity[at];
            if (times == 0)
                first = t;
            if (times++ == 10)
                return t - first;
        }
        before = now;
    }
}

/* Returns the measured angular frequency (in rad/s) of mode (r, half) of a
   taut n x n membrane with small displacements along `axis`. */
static double measured(size_t n, size_t r, size_t half, size_t axis)
{
    struct run o;
    double home = 0;
    make(&o.scene, "membrane",
         GALLERY_CHOICES({"nx", (double)n}, {"ny", (double)n},
                         {"rest", 0.8}, {"amplitude", 1e-5}, {"damping", 0},
                         {"r", (double)r}, {"s", (double)half}));
    const size_t body = turn_to(&o.scene, axis, &home);
    set_off(&o, stepping_find("pefrl"), 0.01);
    const double time = ten_halves(&o, axis * n * n + body, home);
    tidy_up(&o);
    return 10 * acos(-1) / time;
}

static void study_dispersion(struct study *s)
{
    const size_t n = 8;
    double worst = 0;
    TABLE_COLUMNS(s->out, {"r", "", "half waves along x; one along y"},
                  {"across", "rad/s", "measured, motion along z"},
                  {"along", "rad/s", "measured, motion along x"});
    for (size_t r = 1; r <= n - 2; ++r) {
        const double row[] = {(double)r, measured(n, r, 1, 2),
                              measured(n, r, 1, 0)};
        const double a = sin(acos(-1) * (double)r / 14);
        const double b = sin(acos(-1) / 14);
        const double law = sqrt(40 * (a * a + b * b));
        worst = fmax(worst, fabs(row[1] / law - 1));
        table_row(s->out, 3, row);
        if (r == 1)
            table_real(s->summary, "first", row[1]);
    }
    table_real(s->summary, "worst", worst);
}

/* Returns the sag (in m) at the middle of a membrane without tension after
   friction has brought it to rest under the gravity g. Copies the scene to
   *s if s is not NULL. */
static double sag(struct scene *s, double g)
{
    struct run r;
    make(&r.scene, "membrane",
         GALLERY_CHOICES({"nx", 9}, {"ny", 9}, {"amplitude", 0},
                         {"gravity", g}, {"friction", 1.5},
                         {"damping", 0}));
    set_off(&r, stepping_find("leapfrog"), 0.05);
    stepping_run(&r.stepping, 20000);
    const double depth = -r.scene.position[2 * 81 + 40];
    memory_or_exit(!s || scene_copy(s, &r.scene));
    tidy_up(&r);
    return depth;
}

static void study_sag(struct study *s)
{
    struct run r;
    const double depth = sag(&r.scene, 0.5);
    double most = 0;
    r.scene.gravity[2] = r.scene.damping = 0;
    set_off(&r, stepping_find("pefrl"), 0.02);
    TABLE_COLUMNS(s->out, {"t", "s", "since gravity and friction ended"},
                  {"z", "m", "of the body in the middle"},
                  {"a11", "m", "amplitude of the mode (1, 1)"},
                  {"rest", "m", "all other modes, root mean square"});
    for (int row = 0; row <= 600; ++row) {
        most = fmax(most, others(&r.scene, 9, 1));
        TABLE_ROW(s->out, 0.1 * row, r.scene.position[2 * 81 + 40],
                  amplitude(&r.scene, 9, 1, 1), others(&r.scene, 9, 1));
        stepping_run(&r.stepping, 5);
    }
    table_real(s->summary, "rest", most);
    tidy_up(&r);
    TABLE_RESULTS(s->summary, {"depth", depth},
                  {"ratio", sag(NULL, 0.004) / sag(NULL, 0.0005)});
}

/* Steps r until friction has brought it to rest. This gives a rest position
   that does not depend on linear theory. */
static void settle(struct run *r)
{
    for (int i = 0; i < 400; ++i) {
        double fastest = 0;
        stepping_run(&r->stepping, 500);
        for (size_t k = 0; k < 3 * r->scene.bodies; ++k)
            fastest = fmax(fastest, fabs(r->scene.velocity[k]));
        if (fastest < 1e-13)
            return;
    }
}

/* Steps r until the velocity of `body` along y changes sign. Returns the
   time (in s) of this turning point, interpolated linearly. */
static double fall(struct run *r, size_t body)
{
    const double *const v = r->scene.velocity + r->scene.bodies + body;
    double before;
    stepping_run(&r->stepping, 1);
    do {
        before = *v;
        stepping_run(&r->stepping, 1);
    } while (*v < 0);
    return stepping_time(&r->stepping) -
           r->stepping.dt * *v / (*v - before);
}

/* Writes the positions of a grid of bodies twice: row by row, and then
   column by column. */
static void draw(struct study *s, const struct scene *scene, size_t nx)
{
    const double *const x = scene->position, *const y = x + scene->bodies;
    const size_t ny = scene->bodies / nx;
    for (size_t j = 0; j < ny; ++j, table_print(s->out, "\n"))
        for (size_t i = 0; i < nx; ++i)
            TABLE_ROW(s->out, x[j * nx + i], y[j * nx + i]);
    for (size_t i = 0; i < nx; ++i, table_print(s->out, "\n"))
        for (size_t j = 0; j < ny; ++j)
            TABLE_ROW(s->out, x[j * nx + i], y[j * nx + i]);
    table_print(s->out, "\n");
}

/* Writes the shapes of beams with 2, 1 and 0 diagonals, at the turning
   point and at rest. */
static void study_shapes(struct study *s)
{
    TABLE_COLUMNS(s->out, {"x", "m", "place of a body"},
                  {"y", "m", "place of a body"});
    for (int diagonals = 2; diagonals >= 0; --diagonals)
        for (int still = 0; still < 2; ++still) {
            struct run r;
            make(&r.scene, "cantilever",
                 GALLERY_CHOICES({"gravity", 3}, {"diagonals", diagonals},
                                 {"friction", still ? 2 : 0}));
            set_off(&r, stepping_find("leapfrog"), 0.01);
            if (still)
                settle(&r);
            else
                fall(&r, 5);
            draw(s, &r.scene, 6);
            tidy_up(&r);
        }
}

/* A beam: the choices that make it different from the default beam, and its
   results. `linear`, `still` and `lowest` are deflections (in m), and
   `time` is in s. */
struct beam {
    const char *name;
    struct gallery_choice choice[3];
    double frequency, second, third, fastest; /* rad/s */
    double linear, still, lowest, time;
    size_t loose; /* modes without stiffness */
};

/* Computes the frequencies of a beam. Also computes, by linear theory, the
   deflection at the lower corner of the free end. */
static void find_linear(struct beam *b, const struct scene *s, size_t nx)
{
    struct springs p;
    struct modes m;
    memory_or_exit(springs_create(&p, s) &&
                   modes_find(&m, &p, s->position));
    double *const u = calloc(3 * s->bodies, sizeof *u);
    memory_or_exit(u);
    for (b->loose = 0; m.square[b->loose] < 1e-6;)
        ++b->loose;
    b->frequency = sqrt(m.square[b->loose]);
    b->second = sqrt(m.square[b->loose + 1]);
    b->third = sqrt(m.square[b->loose + 2]);
    b->fastest = sqrt(m.square[m.size - 1]);
    modes_deflection(&m, 1e-6, p.gravity, u);
    b->linear = b->loose > 0 ? NAN : u[s->bodies + nx - 1];
    free(u);
    modes_free(&m);
    springs_free(&p);
}

/* Finds the turning point of a falling beam and its deflection at rest. The
   friction that brings it to rest is proportional to its lowest
   frequency. */
static void find_turn(struct beam *b)
{
    struct run r;
    make(&r.scene, "cantilever", b->choice);
    const size_t nx = 6;
    const double start = r.scene.position[r.scene.bodies + nx - 1];
    find_linear(b, &r.scene, nx);
    set_off(&r, stepping_find("leapfrog"), 0.005);
    b->time = fall(&r, nx - 1);
    b->lowest = r.scene.position[r.scene.bodies + nx - 1] - start;
    tidy_up(&r);
    make(&r.scene, "cantilever", b->choice);
    r.scene.damping = r.scene.mass[0] * b->frequency;
    set_off(&r, stepping_find("leapfrog"), 0.01);
    settle(&r);
    b->still = r.scene.position[r.scene.bodies + nx - 1] - start;
    tidy_up(&r);
}

enum { BEAMS = 9 };

/* The default beam, and eight beams that differ from it in one key each. */
static struct beam beams[BEAMS] = {
    {.name = "usual"},
    {.name = "mass", .choice = {{"mass", 2}}},
    {.name = "stiffness", .choice = {{"stiffness", 2000}}},
    {.name = "dx", .choice = {{"dx", 2}}},
    {.name = "dy", .choice = {{"dy", 2}}},
    {.name = "one_diagonal", .choice = {{"diagonals", 1}}},
    {.name = "light", .choice = {{"gravity", 0.1}}},
    {.name = "heavy", .choice = {{"gravity", 10}}},
    {.name = "no_diagonals", .choice = {{"diagonals", 0}}}};

static void study_beams(struct study *s)
{
    TABLE_COLUMNS(s->out, {"w", "rad/s", "lowest frequency above 0"},
                  {"loose", "", "modes without stiffness"},
                  {"linear", "m", "the end's deflection, linear"},
                  {"still", "m", "the end's deflection at rest"},
                  {"lowest", "m", "at the turning point"},
                  {"t", "s", "when it is there"});
    for (struct beam *b = beams; b < beams + BEAMS; ++b) {
        find_turn(b);
        table_print(s->out, "# %s\n", b->name);
        TABLE_ROW(s->out, b->frequency, (double)b->loose, b->linear,
                  b->still, b->lowest, b->time);
        TABLE_RESULTS_OF(s->summary, b->name, {"w", b->frequency});
        if (isfinite(b->linear))
            TABLE_RESULTS_OF(s->summary, b->name, {"linear", -b->linear});
        TABLE_RESULTS_OF(s->summary, b->name, {"still", -b->still},
                         {"lowest", -b->lowest}, {"t", b->time},
                         {"loose", (double)b->loose});
    }
    TABLE_RESULTS(s->summary, {"second", beams[0].second},
                  {"third", beams[0].third}, {"fastest", beams[0].fastest});
}

/* Adds to f[] the forces of a band's springs on the bodies at one end of
   each spring: the end with the larger index if side is 1, otherwise the
   other end. Dashpots act as printed in MPPhys. This is the method that the
   bands replaced: each body looks up all its neighbours, so every spring
   force is computed twice. */
VECTOR_LOOP static void look_up(const struct springs *p,
                                const struct springs_band *b,
                                const double *restrict x,
                                const double *restrict v,
                                double *restrict f, int side)
{
    const size_t n = p->bodies, s = b->stride, to = side ? 0 : s;
    const size_t from = b->first + (side ? s : 0), end = b->end - b->first;
    for (size_t j = 0; j < end; ++j) {
        const size_t i = from + j, o = b->first + j + to;
        const double dx = x[o] - x[i], dy = x[n + o] - x[n + i],
                     dz = x[2 * n + o] - x[2 * n + i];
        const double length = sqrt(dx * dx + dy * dy + dz * dz);
        const double here = 0.5 + copysign(0.5, b->rest[j]);
        const double q =
            here * b->stiffness * (length - b->rest[j]) / length;
        const double c = here * b->damping;
        f[i] += q * dx + c * (v[o] - v[i]);
        f[n + i] += q * dy + c * (v[n + o] - v[n + i]);
        f[2 * n + i] += q * dz + c * (v[2 * n + o] - v[2 * n + i]);
    }
}

/* Sets a[] to the accelerations, computed by look_up. In each band, the
   springs to bodies of smaller index come first, as in (10.11,
   eq:gather). */
static void accelerate_twice(void *springs, const double x[],
                             const double v[], double a[])
{
    struct springs *const p = springs;
    memset(a, 0, 3 * p->bodies * sizeof *a);
    for (size_t b = 0; b < p->bands; ++b)
        for (int side = 1; side >= 0; --side)
            look_up(p, &p->band[b], x, v, a, side);
    for (size_t i = 0; i < 3 * p->bodies; ++i)
        a[i] *= p->inverse[i];
}

/* The ways to compute forces that are compared. TRIPS is GATHER without
   sweeps, and TWICE uses look_up. */
enum { SCATTER, GATHER, TRIPS, TWICE, SPEEDS };

/* Makes a free membrane of n x n bodies with the default dashpots, stepped
   in the given way. */
static void make_fast(struct run *r, size_t n, int way)
{
    make(&r->scene, "membrane",
         GALLERY_CHOICES({"nx", (double)n}, {"ny", (double)n}));
    set_off(r, stepping_find("leapfrog"), 1e-3);
    r->springs.engine = way == SCATTER ? SPRINGS_SCATTER : SPRINGS_GATHER;
    if (way == TRIPS || way == TWICE)
        r->stepping.sweep = NULL;
    if (way == TWICE)
        r->stepping.forces.accelerate = accelerate_twice;
}

/* Returns the number of bodies stepped per second of the clock `seconds`,
   measured over at least two million body steps. */
static double speed_of(struct run *r, double (*seconds)(void))
{
    const uint64_t steps = 2000000 / r->scene.bodies + STEPPING_WATCH;
    const double start = seconds();
    stepping_run(&r->stepping, steps);
    return (double)(steps * r->scene.bodies) / (seconds() - start);
}

static void study_speed(struct study *s)
{
    double most = 0, least = INFINITY;
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"n", "", "bodies on a side"},
                  {"scatter", "1/s", "steps of a body, spring by spring"},
                  {"gather", "1/s", "by bands, in sweeps"},
                  {"trips", "1/s", "by bands, in two trips"},
                  {"twice", "1/s", "each body looks at all its springs"});
    for (size_t n = 8; n <= 512 && !progress_signal(); n *= 2) {
        double row[1 + SPEEDS] = {(double)n};
        struct run r[SPEEDS];
        for (int way = 0; way < SPEEDS; ++way)
            make_fast(&r[way], n, way);
        BENCH_TURNS(way, SPEEDS, row + 1, speed_of(&r[way], bench_seconds));
        for (int way = 0; way < SPEEDS; ++way)
            tidy_up(&r[way]);
        table_row(s->out, 1 + SPEEDS, row);
        most = fmax(most, row[1 + GATHER]);
        if (n >= 64)
            least = fmin(least, row[1 + GATHER] / row[1 + SCATTER]);
    }
    TABLE_RESULTS(s->summary, {"most", most},
                  {"least_ratio_from_64", least});
}

/* Writes how many bodies one thread and two threads step per second of
   wall-clock time. Also writes the median ratio of the rounds, so that a
   temporary slowdown of the machine affects only one ratio. */
static void study_threads(struct study *s)
{
    bench_machine(s->out);
    table_print(s->out, "# 2 threads\n");
    TABLE_COLUMNS(s->out, {"n", "", "bodies on a side"},
                  {"one", "1/s", "steps of a body, by the clock"},
                  {"many", "1/s", "by as many threads as there are"},
                  {"ratio", "", "median of the rounds'"});
    for (size_t n = 8; n <= 512 && !progress_signal(); n *= 2) {
        double speed[2][BENCH_ROUNDS], ratio[BENCH_ROUNDS];
        struct run r[2];
        for (int way = 0; way < 2; ++way) {
            make_fast(&r[way], n, GATHER);
            memory_or_exit(!way || springs_threads(&r[way].springs, 2));
        }
        for (int round = -1; round < BENCH_ROUNDS; ++round) {
            const int at =
                round < 0 ? 0 : round; /* round -1 is the warm-up */
            for (int way = 0; way < 2; ++way)
                speed[way][at] = speed_of(&r[way], bench_clock);
            ratio[at] = speed[1][at] / speed[0][at];
        }
        TABLE_ROW(s->out, (double)n, bench_median(speed[0], BENCH_ROUNDS),
                  bench_median(speed[1], BENCH_ROUNDS),
                  bench_median(ratio, BENCH_ROUNDS));
        tidy_up(&r[0]);
        tidy_up(&r[1]);
    }
}

static const struct study_entry studies[] = {
    {"critical", study_critical, "digits lost at the border",
     STUDY_KEYS(
         {"book_error", "1", "two exponentials, relative, e = 1e-10"})},
    {"regimes", study_regimes, "the oscillator at four dampings",
     STUDY_KEYS({"worst", "m", "distance from the exact motion"})},
    {"spin", study_spin, "what dashpots do to a spin",
     STUDY_KEYS(
         {"left", "1", "share of the spin, dashpot as printed"},
         {"off_law", "1", "largest relative error of the law"},
         {"axial_change", "1", "of the spin, dashpot along the axis"},
         {"axial_energy", "J", "then"})},
    {"path", study_path, "of the double pendulum",
     STUDY_KEYS({"energy", "J", "at the start"})},
    {"errors", study_errors, "methods on it, by step", pendulum_keys},
    {"work", study_work, "the same by processor time", pendulum_keys},
    {"rod", study_rod, "in place of the stiff spring",
     STUDY_KEYS({"spring_to_rod", "m", "distance of places after 10 s"},
                {"rod_0.1", "m", "error of the rod, dt 0.1 s"},
                {"rod_0.5", "m", "the same, 0.5 s"})},
    {"limits", study_limits, "the largest stable steps",
     STUDY_KEYS({"pendulum_<method>", "s", "largest stable step"},
                {"membrane_<method>", "s", "the same"})},
    {"silent", study_silent, "a method that damps",
     STUDY_KEYS(
         {"<method>", "m", "range of the stretch in the last 0.2 s"})},
    {"quartic", study_quartic, "a mode without stiffness",
     STUDY_KEYS({"T_0.1", "s", "period, amplitude 0.1 m"},
                {"AT", "m s", "amplitude x period, 2 mm"})},
    {"membranes", study_membranes, "at rest length and taut",
     STUDY_KEYS({"", "", "if --until reaches t (1, 5, 10, 40, 400):"},
                {"a_<t>", "1", "first mode / start, at rest length"},
                {"rest_<t>", "1", "other modes / start, at rest length"},
                {"free_rest_<t>", "1", "the same, free to move along"},
                {"taut_rest_<t>", "1", "the same, taut"})},
    {"dispersion", study_dispersion, "a membrane's frequencies",
     STUDY_KEYS({"first", "rad/s", "of the lowest mode"},
                {"worst", "1", "largest relative error of the law"})},
    {"sag", study_sag, "a membrane that hangs",
     STUDY_KEYS({"depth", "m", "of the middle, at rest"},
                {"rest", "m", "modes but the first, most"},
                {"ratio", "1", "of depths, gravity 8 times"})},
    {"shapes", study_shapes, "a beam, bent", NULL},
    {"beams", study_beams, "nine of them in numbers",
     STUDY_KEYS({"second", "rad/s", "the usual beam"},
                {"third", "rad/s", "the same"},
                {"fastest", "rad/s", "the same"},
                {"linear_<beam>", "m", "deflection of the end, linear"},
                {"still_<beam>", "m", "at rest"},
                {"lowest_<beam>", "m", "at the turning point"},
                {"loose_<beam>", "1", "modes without stiffness"},
                {"w_<beam>", "rad/s", "lowest frequency above 0"},
                {"t_<beam>", "s", "when it is at the turning point"})},
    {"speed", study_speed, "steps of a body in a second",
     STUDY_KEYS({"most", "1/s", "steps of a body, gather"},
                {"least_ratio_from_64", "1",
                 "gather / scatter, from 64 on a side on"})},
    {"threads", study_threads, "the same on several threads", NULL},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study membranes"},
    {"until", 't', "T", "end, s (40)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    if (letter == 't')
        own.until = options_real(o, 1e-3, 1e6);
}

STUDY_MAIN(.name = PROGRAM, .purpose = "Measure springs, and what fails.",
           .events = "studies", .studies = studies, .options = entries,
           .take = take_option)
