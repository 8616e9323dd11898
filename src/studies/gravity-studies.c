/* Measures bodies that attract each other, for the figures of chapter 9. */
#include "forces/celestial.h"
#include "forces/gravity.h"
#include "forces/jacobi.h"
#include "forces/kepler.h"
#include "forces/largest.h"
#include "forces/stepping.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "gravity-studies"

static struct {
    double orbits;              /* --orbits; 0: the study's default */
    double factor, moon, mixed; /* values for the ring */
    size_t kernel;
} own = {.factor = 1};

/* Returns the value of --orbits if given, otherwise `usual`. */
static double duration(double usual)
{
    return own.orbits > 0 ? own.orbits : usual;
}

/* A scene, its gravity, and its integration method. */
struct sky {
    struct scene scene;
    struct gravity gravity;
    struct stepping stepping;
};

/* Makes a scene of chapter 9 with the chosen values. */
static void make_scene(struct scene *s, const char *name,
                       const struct gallery_choice chosen[])
{
    program_check(gallery_choose(s, celestial_scenes, name, chosen));
}

static void begin_sky(struct sky *k, const char *name,
                      const struct gallery_choice chosen[],
                      const char *method, double dt)
{
    struct scene *s = &k->scene;
    make_scene(s, name, chosen);
    gravity_create(&k->gravity, s->bodies, s->mass, s->k2, s->softening);
    program_memory(stepping_begin(&k->stepping, stepping_find(method),
                                  gravity_forces(&k->gravity), dt,
                                  s->position, s->velocity),
                   NULL);
}

static void end_sky(struct sky *k)
{
    stepping_free(&k->stepping);
    gravity_free(&k->gravity);
    scene_free(&k->scene);
}

static double energy_of(const struct sky *k)
{
    const struct scene *s = &k->scene;
    double sum = 0;
    for (size_t i = 0; i < 3 * s->bodies; ++i)
        sum += s->mass[i % s->bodies] * s->velocity[i] * s->velocity[i];
    return sum / 2 + gravity_potential(&k->gravity, s->position);
}

/* Sets x[] and v[] to the position and velocity of body i relative to body
   0, the central body. */
static void relative_to_first(const struct scene *s, size_t i, double x[3],
                              double v[3])
{
    for (size_t k = 0; k < 3; ++k) {
        const size_t at = k * s->bodies;
        x[k] = s->position[at + i] - s->position[at];
        v[k] = s->velocity[at + i] - s->velocity[at];
    }
}

static double length(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* Measures the Earth's period and the drift of the centre of mass in the
   paper's example, with the paper's time step. The period is interpolated:
   when the Earth is at height y above the axis and has the speed v_y, it
   crossed the axis y / v_y ago. */
static void measure_year(struct study *s)
{
    struct sky k;
    double x[3], v[3], a, e, t;
    begin_sky(&k, "sun-earth", NULL, "leapfrog", 0.03);
    const double *y = k.scene.position + 2, *m = k.scene.mass;
    const double pull = k.scene.k2 * (1 + m[1]);
    relative_to_first(&k.scene, 1, x, v);
    kepler_shape(pull, x, v, &a, &e);
    do {
        stepping_run(&k.stepping, 1);
        relative_to_first(&k.scene, 1, x, v);
        t = stepping_time(&k.stepping);
    } while (t < 100 || x[0] < 0 || x[1] < 0);
    TABLE_RESULTS(
        s->summary, {"axis", a}, {"eccentricity", e},
        {"period", t - x[1] / v[1]},
        {"closed_period", 2 * KEPLER_PI * sqrt(a * a * a / pull)},
        {"drift", (m[0] * y[0] + m[1] * y[1]) / (m[0] + m[1]) / t});
    end_sky(&k);
}

/* Writes five years of the Earth's motion, in steps of two days, computed
   by the closed form and by two methods. Compares the errors of the methods
   with theory. */
static void study_sun_earth(struct study *s)
{
    struct sky k[2];
    double x[3], v[3], u[3], after[3];
    begin_sky(&k[0], "sun-earth", NULL, "euler", 2);
    begin_sky(&k[1], "sun-earth", NULL, "leapfrog", 2);
    const double pull = k[0].scene.k2 * (1 + k[0].scene.mass[1]);
    relative_to_first(&k[0].scene, 1, x, v);
    TABLE_COLUMNS(s->out, {"t", "d", "time"},
                  {"x", "AU", "the Earth from the Sun, closed form"},
                  {"y", "AU", ""}, {"x_e", "AU", "Euler's method"},
                  {"y_e", "AU", ""}, {"x_l", "AU", "leapfrog"},
                  {"y_l", "AU", ""});
    for (int n = 0; n <= 912; ++n) {
        double row[7] = {2. * n, x[0], x[1]};
        for (int i = 0; i < 2; ++i) {
            relative_to_first(&k[i].scene, 1, after, u);
            row[3 + 2 * i] = after[0];
            row[4 + 2 * i] = after[1];
            stepping_run(&k[i].stepping, 1);
        }
        table_row(s->out, 7, row);
        kepler_move(pull, 2, x, v);
    }
    const double turned = sqrt(pull) * 913 * 2, h = sqrt(pull) * 2;
    relative_to_first(&k[0].scene, 1, after, u);
    TABLE_RESULTS(s->summary, {"euler_radius", length(after)},
                  {"euler_law", cbrt(1 + 6 * h * turned)});
    relative_to_first(&k[1].scene, 1, after, u);
    const double off[3] = {after[0] - x[0], after[1] - x[1], 0};
    TABLE_RESULTS(s->summary, {"leapfrog_error", length(off)},
                  {"leapfrog_law", turned * h * h / 3});
    end_sky(&k[0]);
    end_sky(&k[1]);
    measure_year(s);
}

/* Writes solutions of Kepler's equation against the mean anomaly, and then
   positions on an ellipse at 24 equally spaced times. */
static void study_anomaly(struct study *s)
{
    static const double e[] = {0.1, 0.5, 0.9, 0.99};
    table_column(s->out, "M", "rad", "mean anomaly");
    for (int i = 0; i < 4; ++i)
        table_column(s->out, "E", "rad", "eccentric anomaly");
    for (int n = 0; n <= 400; ++n) {
        double row[5] = {KEPLER_PI * n / 400};
        for (int i = 0; i < 4; ++i)
            row[i + 1] = kepler_anomaly(e[i], row[0]);
        table_row(s->out, 5, row);
    }
    table_print(s->out, "\n\n# e = 0.7 at 24 equal times: x y\n");
    for (int n = 0; n < 24; ++n) {
        struct kepler_elements o = {1, 0.7, 0, 0, 0, KEPLER_PI * n / 12};
        double x[3], v[3];
        kepler_place(1, &o, x, v);
        table_print(s->out, "%.6f %.6f\n", x[0], x[1]);
    }
}

/* Returns the distance between a planet's positions before and after one
   orbit from aphelion to aphelion, in units of the aphelion distance. */
static double orbit_error(double e, const char *method, double evaluations)
{
    struct sky k;
    const double speed = sqrt(1 - e), axis = 1 / (1 + e);
    const double period = 2 * KEPLER_PI / CELESTIAL_K * axis * sqrt(axis);
    const size_t stages = stepping_find(method)->stages;
    const uint64_t steps =
        (uint64_t)fmax(1, round(evaluations / (double)stages));
    begin_sky(&k, "sun-earth",
              GALLERY_CHOICES({"mass", 0}, {"speed", speed}), method,
              period / (double)steps);
    stepping_run(&k.stepping, steps);
    const double error =
        hypot(k.scene.position[1] - 1, k.scene.position[3]);
    end_sky(&k);
    return error;
}

/* Writes the errors of three methods against the eccentricity, each after
   one orbit of 1e4 evaluations. Then writes the path of an orbit. */
static void study_eccentric(struct study *s)
{
    static const char *const methods[] = {"leapfrog", "rk4", "kahan-li8"};
    static const double e[] = {0,  .1,  .2, .3,  .4,  .5,  .6,  .7,
                               .8, .85, .9, .93, .95, .97, .98, .99};
    table_column(s->out, "e", "", "eccentricity");
    for (int i = 0; i < 3; ++i)
        table_column(s->out, methods[i], "",
                     "error of place after an orbit");
    for (size_t n = 0; n < sizeof e / sizeof e[0]; ++n) {
        double row[4] = {e[n]};
        for (int i = 0; i < 3; ++i)
            row[1 + i] = orbit_error(e[n], methods[i], 1e4);
        table_row(s->out, 4, row);
        table_keyed(s->summary, row[3], "kahan-li8_%g", e[n]);
    }
    TABLE_RESULTS(s->summary,
                  {"leapfrog", orbit_error(.99, methods[0], 1e4)},
                  {"more", orbit_error(.99, methods[0], 1e6)});
    /* Write a path that starts at the aphelion, where the speed is sqrt(1 -
       e) times the circular speed. */
    struct sky k;
    const double axis = 1 / 1.95;
    const double period = 2 * KEPLER_PI / CELESTIAL_K * axis * sqrt(axis);
    begin_sky(&k, "sun-earth",
              GALLERY_CHOICES({"mass", 0}, {"speed", sqrt(0.05)}),
              "leapfrog", period / 1000);
    table_print(s->out,
                "\n\n# e = 0.95, leapfrog, 1000 steps an orbit: x y\n");
    for (int n = 0; n <= 6000; ++n) {
        table_print(s->out, "%.5f %.5f\n", k.scene.position[1],
                    k.scene.position[3]);
        stepping_run(&k.stepping, 1);
    }
    end_sky(&k);
}

/* Moves a massless planet from 1 AU past the Sun and back to 1 AU, on an
   ellipse of semi-major axis 1 AU and perihelion distance q (in AU). Sets
   *energy to the relative error of the energy, which includes the
   softening. Sets *place to the position error (in AU) relative to the
   orbit without softening. */
static void fly_by(double q, const char *method, double dt,
                   double softening, double *energy, double *place)
{
    struct sky k;
    const double half = KEPLER_PI / 2 - (1 - q);
    struct kepler_elements o = {1, 1 - q, 0, 0, 0, -half};
    double x[3], v[3], right[3];
    const double time = 2 * half / CELESTIAL_K;
    const uint64_t steps = (uint64_t)ceil(time / dt);
    begin_sky(&k, "sun-earth", GALLERY_CHOICES({"mass", 0}), method,
              time / (double)steps);
    k.gravity.softening = softening;
    kepler_place(CELESTIAL_K2, &o, x, v);
    for (size_t i = 0; i < 3; ++i) {
        k.scene.position[2 * i + 1] = x[i];
        k.scene.velocity[2 * i + 1] = v[i];
    }
    stepping_run(&k.stepping, steps);
    relative_to_first(&k.scene, 1, x, v);
    const double mu = CELESTIAL_K2, r0 = sqrt(1 + softening * softening);
    const double before = mu / 2 - mu / r0;
    const double r = sqrt(length(x) * length(x) + softening * softening);
    *energy = fabs(length(v) * length(v) / 2 - mu / r - before) / (mu / 2);
    o.mean_anomaly = half;
    kepler_place(CELESTIAL_K2, &o, right, v);
    for (size_t i = 0; i < 3; ++i)
        x[i] -= right[i];
    *place = length(x);
    end_sky(&k);
}

enum { FALLS = 3 };

static const char *const fall_columns[2 * FALLS] = {"dE_l", "dE_k", "dE_s",
                                                    "dx_l", "dx_k", "dx_s"};

/* Writes the errors of flights past the Sun. From one row to the next the
   perihelion distance is divided by 10^(1/4). kahan-li8 has 17 stages, so
   its steps are made 17 times as long as those of leapfrog. */
static void study_encounter(struct study *s)
{
    const double dt = 0.01;
    double worst[2] = {0};
    TABLE_COLUMNS(s->out, {"q", "AU", "closest approach"},
                  {fall_columns[0], "", "energy: leapfrog"},
                  {fall_columns[1], "", "energy: kahan-li8"},
                  {fall_columns[2], "", "energy: leapfrog, softened"},
                  {fall_columns[3], "AU", "place: leapfrog"},
                  {fall_columns[4], "AU", "place: kahan-li8"},
                  {fall_columns[5], "AU", "place: leapfrog, softened"});
    for (double q = 0.3; q > 2e-6; q /= sqrt(sqrt(10))) {
        double row[1 + 2 * FALLS] = {q}, *energy = row + 1,
                           *place = energy + FALLS;
        fly_by(q, "leapfrog", dt, 0, &energy[0], &place[0]);
        fly_by(q, "kahan-li8", dt * 17, 0, &energy[1], &place[1]);
        fly_by(q, "leapfrog", dt, 0.01, &energy[2], &place[2]);
        table_row(s->out, 1 + 2 * FALLS, row);
        for (int k = 0; k < 2 * FALLS; ++k)
            table_keyed(s->summary, row[1 + k], "%s_%.2g", fall_columns[k],
                        q);
        worst[0] = fmax(worst[0], energy[2]);
        worst[1] = fmax(worst[1], place[2]);
    }
    TABLE_RESULTS(s->summary, {"dE_s", worst[0]}, {"dx_s", worst[1]});
}

static const double jupiters[] = {1, 30, 100, 300};
enum { JUPITERS = 4 };

static double eccentricity_of(const struct scene *s, size_t i)
{
    double x[3], v[3], a, e;
    relative_to_first(s, i, x, v);
    kepler_shape(s->k2 * (s->mass[0] + s->mass[i]), x, v, &a, &e);
    return e;
}

/* Returns the relative energy change of all eight planets in a century,
   computed by leapfrog with Jupiter's mass multiplied by `jupiter`. */
static double century_with_jupiter(double jupiter)
{
    struct sky k;
    begin_sky(&k, "solar-system", GALLERY_CHOICES({"jupiter", jupiter}),
              "leapfrog", 365.25 / 180);
    const double before = energy_of(&k);
    stepping_run(&k.stepping, 18000);
    const double error = fabs(energy_of(&k) / before - 1);
    end_sky(&k);
    return error;
}

/* Writes the eccentricities of the Earth and of Mars every five years, with
   the mass of Jupiter multiplied by each factor of jupiters[]. */
static void study_planets(struct study *s)
{
    struct sky k[JUPITERS];
    double before[JUPITERS], error = 0;
    const double years = duration(1000);
    table_column(s->out, "t", "a", "time, in years of 365.25 days");
    for (int i = 0; i < JUPITERS; ++i) {
        begin_sky(&k[i], "solar-system",
                  GALLERY_CHOICES({"jupiter", jupiters[i]}, {"planets", 5}),
                  "kahan-li8", 365.25 / 60);
        before[i] = energy_of(&k[i]);
        TABLE_COLUMNS(s->out, {"e_E", "", "eccentricity of the Earth"},
                      {"e_M", "", "eccentricity of Mars"});
    }
    for (double t = 0; t <= years && !progress_signal(); t += 5) {
        double row[1 + 2 * JUPITERS] = {t};
        for (int i = 0; i < JUPITERS; ++i) {
            row[1 + 2 * i] = eccentricity_of(&k[i].scene, 3);
            row[2 + 2 * i] = eccentricity_of(&k[i].scene, 4);
            stepping_run(&k[i].stepping, 300);
        }
        table_row(s->out, 1 + 2 * JUPITERS, row);
        const int last = JUPITERS - 1;
        error = fmax(error, fabs(energy_of(&k[last]) / before[last] - 1));
    }
    TABLE_RESULTS(s->summary, {"energy_300", error},
                  {"eight", century_with_jupiter(300)});
    for (int i = 0; i < JUPITERS; ++i)
        end_sky(&k[i]);
}

/* Writes the daily positions of the two stars and of a planet. The planet
   starts at `distance` (in AU). */
static void write_paths(struct study *s, double distance, double days)
{
    struct sky k;
    begin_sky(&k, "circumbinary", GALLERY_CHOICES({"distance", distance}),
              "kahan-li8", 1);
    const double *x = k.scene.position;
    table_print(s->out, "\n\n# planet at %g AU: t x y of A, B, P\n",
                distance);
    for (int n = 0; n <= days; ++n) {
        table_print(s->out, "%d %.5f %.5f %.5f %.5f %.5f %.5f\n", n, x[0],
                    x[3], x[1], x[4], x[2], x[5]);
        stepping_run(&k.stepping, 1);
    }
    end_sky(&k);
}

/* Writes two paths of a planet of Kepler-16. The summary gets the initial
   velocities, and the planet's position error after 400 days, compared with
   a computation in quadruple precision. */
static void study_circumbinary(struct study *s)
{
    struct sky k;
    table_print(s->out, "# paths of Kepler-16, AU and days\n");
    write_paths(s, 0.7048, 240);
    write_paths(s, 0.445, 1900);
    begin_sky(&k, "circumbinary", NULL, "kahan-li8", 0.5);
    const double *v = k.scene.velocity;
    TABLE_RESULTS(s->summary, {"v_A", -v[3]}, {"v_B", v[4]}, {"v_P", v[5]});
    stepping_run(&k.stepping, 800);
    table_real(s->summary, "error",
               hypot(k.scene.position[2] - .13282865947670180,
                     k.scene.position[5] + .68512113197667507));
    end_sky(&k);
}

/* The distance between the stars of Kepler-16 (in AU) and their period (in
   days). */
static const double binary = 0.2243, binary_period = 41.0808939256;

/* Returns how many of 8 massless planets survive for `periods` periods of
   the stars. The planets start at the same distance from the centre but at
   different phases. A planet that comes within 0.05 of the centre or goes
   beyond 5 does not survive. The unit of length is the distance between the
   stars. Leapfrog with 100 steps per period is accurate enough, and only
   every tenth step is examined. */
static int survivors(double distance, double periods)
{
    int alive = 0;
    for (int phase = 0; phase < 8; ++phase) {
        struct sky k;
        begin_sky(&k, "circumbinary",
                  GALLERY_CHOICES({"distance", distance * binary},
                                  {"phase", phase / 8.}, {"planet", 0}),
                  "leapfrog", binary_period / 100);
        const double *x = k.scene.position;
        double r = distance;
        for (double t = 0; t < periods && r > .05 && r < 5; t += .1) {
            stepping_run(&k.stepping, 10);
            r = hypot(x[2], x[5]) / binary;
        }
        alive += r > .05 && r < 5;
        end_sky(&k);
    }
    return alive;
}

/* Writes the number of survivors against the initial distance, in
   increments of 0.04 times the distance between the stars. Finds the
   distance above which all planets survive. */
static void study_survival(struct study *s)
{
    const double periods = duration(1000);
    double safe = 0;
    TABLE_COLUMNS(s->out, {"a", "", "distance, the stars' being 1"},
                  {"r", "AU", "the same"},
                  {"n", "", "phases of 8 that survive"});
    for (int n = 0; n <= 20 && !progress_signal(); ++n) {
        const double distance = 1.8 + 0.04 * n;
        const int alive = survivors(distance, periods);
        if (alive < 8)
            safe = distance + 0.04;
        TABLE_ROW(s->out, distance, distance * binary, alive);
    }
    const double mu = 0.2026 / (0.6897 + 0.2026);
    const double law = 1.60 + 4.12 * mu - 5.09 * mu * mu;
    TABLE_RESULTS(s->summary, {"safe", safe}, {"safe_AU", safe * binary},
                  {"law", law}, {"law_AU", law * binary});
}

/* Sets *energy to the largest relative energy error in `periods` periods of
   the stars, with `evaluations` evaluations per period. Sets *place to the
   planet's position error (in AU) after 400 days, compared with a
   computation in quadruple precision. */
static void precision(const char *method, double evaluations,
                      double periods, double *energy, double *place)
{
    struct sky k;
    const struct stepping_method *m = stepping_find(method);
    const double step = binary_period * (double)m->stages / evaluations;
    const uint64_t steps = (uint64_t)ceil(400 / step);
    begin_sky(&k, "circumbinary", NULL, method, 400 / (double)steps);
    k.stepping.compensated = true;
    const double before = energy_of(&k), *x = k.scene.position;
    *energy = 0;
    while (stepping_time(&k.stepping) < periods * binary_period) {
        if (k.stepping.steps == steps)
            *place =
                hypot(x[2] - .13282865947670180, x[5] + .68512113197667507);
        stepping_run(&k.stepping, 1);
        *energy = fmax(*energy, fabs(energy_of(&k) / before - 1));
    }
    end_sky(&k);
}

/* Writes the errors of seven methods at equal numbers of evaluations.
   Leaves out runs with a relative energy error of 1 or more. */
static void study_work(struct study *s)
{
    static const char *const methods[] = {
        "symplectic-euler", "leapfrog", "rk4", "yoshida4", "pefrl",
        "yoshida6",         "kahan-li8"};
    const double periods = duration(100);
    TABLE_COLUMNS(s->out, {"f", "", "evaluations in a period of the stars"},
                  {"dE", "", "largest error of the energy"},
                  {"dx", "AU", "error of place after 400 d"});
    for (size_t i = 0; i < sizeof methods / sizeof methods[0]; ++i) {
        table_print(s->out, "%s# %s\n", i ? "\n\n" : "", methods[i]);
        for (double n = 50; n < 7000 && !progress_signal(); n *= sqrt(2)) {
            double energy, place = NAN;
            precision(methods[i], n, periods, &energy, &place);
            if (energy < 1)
                TABLE_ROW(s->out, n, energy, place);
            const int f = (int)round(n);
            char which[64];
            snprintf(which, sizeof which, "%s_%d", methods[i], f);
            if (f == 100 || f == 141 || f == 200 || f == 800 || f == 1600)
                TABLE_RESULTS_OF(s->summary, which, {"dE", energy},
                                 {"dx", place});
        }
    }
}

/* Returns the largest relative energy error up to the time t, from about a
   thousand samples. Sets *cost to the processor time, s. Frees *k. */
static double largest_energy_error(struct sky *k, double t, double *cost)
{
    struct jacobi j = {0};
    const uint64_t steps = (uint64_t)round(t / k->stepping.dt);
    const uint64_t portion = steps / 1000 + 1;
    const double before = energy_of(k);
    double worst = 0;
    if (k->stepping.method->orbits) { /* drifts follow ellipses */
        const struct scene *s = &k->scene;
        program_memory(jacobi_create(&j, s->bodies, s->mass, s->k2), NULL);
        k->stepping.forces = jacobi_forces(&j);
        k->stepping.flow = jacobi_flow;
    }
    *cost = -bench_seconds();
    for (uint64_t n = 0; n < steps; n += portion) {
        stepping_run(&k->stepping, portion);
        worst = fmax(worst, fabs(energy_of(k) / before - 1));
    }
    *cost += bench_seconds();
    jacobi_free(&j);
    end_sky(k);
    return worst;
}

/* Returns the largest relative energy error in a century of eight planets
   whose masses are multiplied by `factor`. `days` is the time between two
   kicks. */
static double century(const char *method, double days, double factor)
{
    struct sky k;
    double cost;
    const struct stepping_method *m = stepping_find(method);
    begin_sky(&k, "solar-system", NULL, method, days * (double)m->stages);
    for (size_t i = 1; i < k.scene.bodies; ++i)
        k.scene.mass[i] *= factor;
    return largest_energy_error(&k, 36525, &cost);
}

static const char *const along[] = {"leapfrog", "kahan-li8",
                                    "wisdom-holman", "sbab4"};
enum { ALONG = sizeof along / sizeof *along };

/* Writes the error against the time between two kicks and then against the
   masses of the planets. In the first block, leaves out errors of 1 and
   more, which mean that the orbits have been lost. */
static void study_ellipses(struct study *s)
{
    TABLE_COLUMNS(s->out, {"d", "d", "from kick to kick"},
                  {"m", "", "factor on the planets' masses"},
                  {"dE", "", "largest error of the energy"});
    for (int i = 0; i < ALONG; ++i) {
        table_print(s->out, "# %s\n", along[i]);
        for (double d = 0.25; d < 20 && !progress_signal(); d *= sqrt(2)) {
            const double e = century(along[i], d, 1);
            if (e < 1)
                TABLE_ROW(s->out, d, 1, e);
        }
        table_print(s->out, "\n\n");
    }
    for (size_t i = 0; i < ALONG; ++i) {
        double error[7];
        for (int n = 0; n < 7; ++n) {
            const double factor = pow(10, 0.5 * n - 2);
            error[n] = century(along[i], 2, factor);
            TABLE_ROW(s->out, 2, factor, error[n]);
        }
        table_real(s->summary, along[i], century(along[i], 4, 1));
        table_keyed(s->summary, log10(error[6] / error[4]), "%s_slope",
                    along[i]);
        table_print(s->out, "\n\n");
    }
}

/* Measures the processor time and the energy error for 1e4 periods of two
   stars with a planet. The result is one of the tables in plots/data. */
static void study_two_suns(struct study *s)
{
    static const struct {
        const char *method;
        int steps; /* steps per period */
    } row[] = {{"leapfrog", 200},     {"kahan-li8", 30},
               {"wisdom-holman", 30}, {"wisdom-holman", 100},
               {"sbab4", 10},         {"sbab4", 30}};
    bench_machine(s->out);
    table_print(s->out, "# rows: method and steps in a period\n");
    TABLE_COLUMNS(s->out, {"s", "s", "processor time, median of five"},
                  {"dE", "", "largest error of the energy"});
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        double cost[BENCH_ROUNDS], error = 0;
        for (int k = 0; k < BENCH_ROUNDS && !progress_signal(); ++k) {
            struct sky sky;
            begin_sky(&sky, "circumbinary", NULL, row[i].method,
                      binary_period / row[i].steps);
            error =
                largest_energy_error(&sky, 1e4 * binary_period, &cost[k]);
        }
        table_print(s->out, "%s-%d %.3g %.3g\n", row[i].method,
                    row[i].steps, bench_median(cost, BENCH_ROUNDS), error);
    }
}

/* Returns the difference between the largest and the smallest distance of a
   body from the centre. The bodies start on a circle of radius 1, so the
   difference grows from rounding errors. */
static double deviation(const struct scene *s)
{
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        const double r = hypot(s->position[i], s->position[s->bodies + i]);
        least = fmin(least, r);
        most = fmax(most, r);
    }
    return most - least;
}

enum { PARTS_OF_ORBIT = 20 };

/* The results of a choreography that breaks up. The deviation is the
   difference between the largest and the smallest radius. The growth rate
   is the slope of its logarithm between 1e-12 and 1e-4. */
struct broken {
    double orbits;       /* orbits until the radii differ by 0.1 */
    double rate;         /* growth rate / angular velocity */
    double early, first; /* number of orbits, and deviation, when the
                            deviation was last below 1e-12 */
};

/* Runs a choreography until its radii differ by 0.1 or twenty orbits have
   passed. Writes the deviation over time. Returns the results. */
static struct broken run_until_broken(struct study *s, size_t count)
{
    struct sky k;
    struct broken b = {0};
    const double period =
        2 * KEPLER_PI / sqrt(celestial_choreography(count) / sqrt(8));
    double before = 0;
    begin_sky(&k, "choreography",
              GALLERY_CHOICES({"particles", (double)count}), "kahan-li8",
              period / PARTS_OF_ORBIT / 5);
    table_print(s->out, "\n\n# %zu bodies: orbits, deviation\n", count);
    while (b.orbits < 20 && before < 0.1) {
        stepping_run(&k.stepping, 5);
        b.orbits = stepping_time(&k.stepping) / period;
        before = deviation(&k.scene);
        table_print(s->out, "%.4g %.4g\n", b.orbits, before);
        if (before < 1e-12)
            b.early = b.orbits, b.first = before;
        else if (before < 1e-4)
            b.rate = log(before / b.first) / (b.orbits - b.early) /
                     (2 * KEPLER_PI);
    }
    end_sky(&k);
    return b;
}

/* Runs circles of 3 to 10 bodies until they break up. Compares the growth
   rates and times with a theory that assumes an initial deviation of
   1e-16. */
static void study_choreography(struct study *s)
{
    struct broken b[11] = {{0}};
    for (size_t n = 3; n <= 10; ++n)
        b[n] = run_until_broken(s, n);
    table_print(s->out, "\n\n# N  S_N  v  growth rate: theory, measured  "
                        "orbits: theory, measured\n");
    for (size_t n = 2; n <= 10; ++n) {
        const double sum = celestial_choreography(n);
        const double rate = celestial_growth(n), v = sqrt(sum / sqrt(8));
        const double theory = log(0.1 / 1e-16) / (2 * KEPLER_PI * rate);
        if (n > 2)
            table_print(s->out, "%zu %.15g %.15g %.6f %.6f %.3f %.3f\n", n,
                        sum, v, rate, b[n].rate, theory, b[n].orbits);
        char bodies[8];
        snprintf(bodies, sizeof bodies, "%zu", n);
        TABLE_RESULTS_OF(s->summary, bodies, {"S", sum}, {"v", v},
                         {"rate", rate}, {"measured", b[n].rate},
                         {"theory", theory}, {"orbits", b[n].orbits});
    }
}

static const double eight_period = 6.32591398292621167758900033397;

/* Returns the largest change of a coordinate in one period of the
   figure-eight, which would be zero without errors. */
static double closure(const char *method, double steps, bool compensated)
{
    struct sky k;
    struct scene right;
    begin_sky(&k, "figure-eight", NULL, method, eight_period / steps);
    make_scene(&right, "figure-eight", NULL);
    k.stepping.compensated = compensated;
    stepping_run(&k.stepping, (uint64_t)steps);
    const double worst =
        largest_difference(k.scene.position, right.position, 9);
    scene_free(&right);
    end_sky(&k);
    return worst;
}

/* Writes the path of the figure-eight and then the errors of three methods
   with 100 to 2e5 evaluations. */
static void study_eight(struct study *s)
{
    static const char *const methods[] = {"leapfrog", "rk4", "kahan-li8"};
    struct sky k;
    begin_sky(&k, "figure-eight", NULL, "kahan-li8", eight_period / 240);
    const double *x = k.scene.position;
    table_print(s->out, "# t, x y of three bodies\n");
    for (int n = 0; n <= 240; ++n) {
        table_print(s->out, "%.5f %.5f %.5f %.5f %.5f %.5f %.5f\n",
                    stepping_time(&k.stepping), x[0], x[3], x[1], x[4],
                    x[2], x[5]);
        stepping_run(&k.stepping, 1);
    }
    end_sky(&k);
    for (int i = 0; i < 3; ++i) {
        const double stages = (double)stepping_find(methods[i])->stages;
        table_print(s->out, "\n\n# %s: evaluations, error after a period\n",
                    methods[i]);
        for (double n = 100; n < 2e5; n *= 2) {
            const double steps = round(n / stages);
            TABLE_ROW(s->out, steps * stages,
                      closure(methods[i], steps, true));
        }
    }
    table_real(s->summary, "closure", closure("kahan-li8", 2000, true));
}

/* Writes the speeds of circular orbits near a ring whose mass is 0.02 times
   the planet's, from equations (22) to (24) of the paper. */
static void study_ring_speeds(struct study *s)
{
    const double sigma = 0.02, inner = 2, outer = 2.5;
    const double area = KEPLER_PI * (outer - inner) * (outer + inner);
    TABLE_COLUMNS(s->out, {"r", "AU", "distance from the planet"},
                  {"v_0", "AU/d", "no ring"},
                  {"v", "AU/d", "a ring of 0.02 planets"},
                  {"v_l", "AU/d", "0.02 planets on every AU^2"});
    for (int n = 0; n <= 1200; ++n) {
        const double r = 1.5 + n / 800. + 1e-4;
        const double pull = celestial_ring_pull(sigma, inner, outer, r);
        TABLE_ROW(s->out, r, CELESTIAL_K * sqrt(1 / r),
                  CELESTIAL_K * sqrt(1 / r + r * pull),
                  CELESTIAL_K * sqrt(1 / r + r * area * pull));
    }
    for (int k = 2; k <= 8; k += 2)
        table_keyed(
            s->summary,
            celestial_ring_pull(sigma, inner, outer, outer + pow(10, -k)),
            "edge_%d", k);
    table_real(s->summary, "per_decade", 2 * log(10) * sigma / area);
}

/* Numbers of cells of a ring along the radius and the circumference. The
   cells divide r^2 and the angle evenly, so their areas are equal. */
enum { RADIAL = 4, AROUND = 96 };

/* Returns the variance of the number of particles per cell, divided by its
   mean. The ratio is 1 for independent positions. */
static double dispersion(const struct scene *s, size_t particles)
{
    static double count[RADIAL * AROUND];
    double sum = 0, squares = 0;
    memset(count, 0, sizeof count);
    for (size_t i = 1; i <= particles; ++i) {
        double x[3], v[3];
        relative_to_first(s, i, x, v);
        const double r = hypot(x[0], x[1]);
        const double turn = atan2(x[1], x[0]) / (2 * KEPLER_PI) + 0.5;
        const int a = (int)floor((r * r - 4) / 2.25 * RADIAL);
        const int b = (int)(turn * AROUND) % AROUND;
        if (a >= 0 && a < RADIAL)
            ++count[a * AROUND + b];
    }
    for (int i = 0; i < RADIAL * AROUND; ++i) {
        sum += count[i];
        squares += count[i] * count[i];
    }
    const double mean = sum / (RADIAL * AROUND);
    return (squares / (RADIAL * AROUND) - mean * mean) / mean;
}

/* Returns the root mean square radial velocity in units of the circular
   velocity. It measures how much the particles disturb each other, because
   they start on circles. */
static double stirring(const struct scene *s, size_t particles)
{
    double sum = 0;
    for (size_t i = 1; i <= particles; ++i) {
        double x[3], v[3];
        relative_to_first(s, i, x, v);
        const double r = length(x);
        const double out = (x[0] * v[0] + x[1] * v[1]) / r;
        sum += out * out * r / s->k2;
    }
    return sqrt(sum / (double)particles);
}

enum { PARTICLES = 3072 };

/* Runs a ring. Writes all its bodies and three numbers that describe the
   quality of the run. Unless --kernel names another, uses the fastest
   kernel for 3000 bodies. This kernel depends on the processor, and so may
   the table, whose header names the kernel. */
static void study_ring(struct study *s)
{
    const double period = 2 * KEPLER_PI / CELESTIAL_K * 2.25 * sqrt(2.25);
    const double orbits = duration(2);
    struct sky k;
    /* An orbit in the middle of the ring takes 200 steps. */
    begin_sky(&k, "ring",
              GALLERY_CHOICES({"factor", own.factor}, {"moon", own.moon},
                              {"moon-distance", 2.7}, {"mixed", own.mixed},
                              {"seed", (double)s->seed}),
              "leapfrog", period / 200);
    k.gravity.kernel = (enum gravity_kernel)own.kernel;
    const double before = energy_of(&k);
    while (stepping_time(&k.stepping) < (orbits - 1e-9) * period &&
           !progress_signal())
        stepping_run(&k.stepping, 10);
    table_print(
        s->out, "# kernel %s\n# x y of the planet, the ring%s; mass\n",
        gravity_kernels[own.kernel], own.moon > 0 ? ", the moon" : "");
    for (size_t i = 0; i < k.scene.bodies; ++i) {
        double x[3], v[3];
        relative_to_first(&k.scene, i, x, v);
        table_print(s->out, "%.4f %.4f %.3g\n", x[0], x[1],
                    k.scene.mass[i]);
    }
    const double energy = energy_of(&k) / before - 1;
    const double clumps = dispersion(&k.scene, PARTICLES);
    const double heat = stirring(&k.scene, PARTICLES);
    table_print(s->out, "\n\n# energy error, dispersion, stirring\n");
    table_print(s->out, "%.3g %.4g %.4g\n", energy, clumps, heat);
    TABLE_RESULTS(s->summary, {"energy", energy}, {"dispersion", clumps},
                  {"stirring", heat});
    end_sky(&k);
}

/* Returns the precession (in rad) due to softening in one orbit of
   eccentricity e. Stops after the first step beyond aphelion, where r . v
   changes sign. The path is nearly straight there, so the position at
   aphelion is extrapolated back along the velocity. */
static double precession(double e, double softening)
{
    struct sky k;
    const double axis = 1 / (1 + e);
    const double period = 2 * KEPLER_PI / CELESTIAL_K * axis * sqrt(axis);
    double x[3], v[3], before, now;
    begin_sky(&k, "sun-earth",
              GALLERY_CHOICES({"mass", 0}, {"speed", sqrt(1 - e)}),
              "kahan-li8", period / 400);
    k.gravity.softening = softening;
    now = 0;
    do { /* until the next aphelion */
        stepping_run(&k.stepping, 1);
        relative_to_first(&k.scene, 1, x, v);
        before = now;
        now = x[0] * v[0] + x[1] * v[1];
    } while (!(before > 0 && now <= 0));
    const double fraction = now / (now - before); /* of the last step */
    for (size_t i = 0; i < 3; ++i)
        x[i] = x[i] - fraction * k.stepping.dt * v[i];
    end_sky(&k);
    return atan2(x[1], x[0]);
}

/* Writes the precession of an ellipse due to softening, and the change of
   the period of a circular orbit, which is known in closed form. */
static void study_softening(struct study *s)
{
    TABLE_COLUMNS(s->out, {"eps", "AU", "softening"},
                  {"theory", "rad", "-3 pi (eps / p)^2"},
                  {"turn", "rad", "of the ellipse, e = 0.2"},
                  {"period", "", "of the circle, relative change"});
    for (double eps = 1e-3; eps < 0.5; eps *= sqrt(sqrt(10))) {
        const double p = 1 - 0.2;
        TABLE_ROW(s->out, eps, -3 * KEPLER_PI * eps * eps / (p * p),
                  precession(0.2, eps), pow(1 + eps * eps, 0.75) - 1);
    }
}

/* Adds to sum[] the x and y accelerations of body i caused by the bodies
   from first to last - 1, in single precision. Positions are in double
   precision, because only the sum is being tested. Uses compensated
   summation if compensation is not NULL. */
static void add_single(const struct scene *s, size_t i, size_t first,
                       size_t last, float sum[2], float compensation[2])
{
    const double *x = s->position, *y = x + s->bodies;
    const float least = (float)(s->softening * s->softening);
    for (size_t j = first; j < last; ++j) {
        if (j == i)
            continue;
        const float d[] = {(float)(x[j] - x[i]), (float)(y[j] - y[i])};
        const float square = d[0] * d[0] + d[1] * d[1] + least;
        const float w = (float)s->mass[j] / (square * sqrtf(square));
        for (int c = 0; c < 2; ++c) {
            const float old = sum[c];
            const float more =
                w * d[c] + (compensation ? compensation[c] : 0);
            sum[c] = old + more;
            if (compensation)
                compensation[c] = more - (sum[c] - old);
        }
    }
}

/* Accelerations of a body along x and y: planet[] is due to the planet
   (body 0), and ring[] is due to the ring. lost[] is the rounding error of
   the ring's terms in a model of single-precision summation. The model
   rounds each term to a multiple of the spacing of single-precision numbers
   near the planet's acceleration. */
struct pulls {
    double planet[2], ring[2], lost[2];
};

static struct pulls pulls_at(const struct scene *s, size_t i)
{
    const double *x = s->position, *y = x + s->bodies;
    struct pulls p = {{0, 0}, {0, 0}, {0, 0}};
    double spacing[2] = {0, 0};
    for (size_t j = 0; j < s->bodies; ++j) {
        const double d[] = {x[j] - x[i], y[j] - y[i]};
        const double square =
            d[0] * d[0] + d[1] * d[1] + s->softening * s->softening;
        const double w = s->mass[j] / (square * sqrt(square));
        for (int c = 0; c < 2 && j != i; ++c) {
            const double pull = w * d[c];
            int exponent;
            if (j == 0) {
                p.planet[c] = pull;
                frexp(pull, &exponent);
                spacing[c] = ldexp(1, exponent - 24);
                continue;
            }
            p.ring[c] += pull;
            p.lost[c] += rint(pull / spacing[c]) * spacing[c] - pull;
        }
    }
    return p;
}

/* Three ways to sum: planet first, planet last, and planet first with
   compensation. */
enum { FIRST, LAST, CARRIED, ORDERS };

/* Sets row[] to the number of particles of a ring and the root mean square
   errors of their acceleration, for the three ways to sum and for the
   model. Samples about 250 particles. The unit is the root mean square
   acceleration due to the ring. */
static void compare_singly(const struct scene *s, double row[2 + ORDERS])
{
    const size_t every = s->bodies > 256 ? s->bodies / 256 : 1;
    double size = 0, error[1 + ORDERS] = {0};
    for (size_t i = 1; i < s->bodies; i += every) {
        const struct pulls p = pulls_at(s, i);
        float sum[ORDERS][2] = {{0}}, compensation[2] = {0, 0};
        add_single(s, i, 0, s->bodies, sum[FIRST], NULL);
        add_single(s, i, 1, s->bodies, sum[LAST], NULL);
        add_single(s, i, 0, 1, sum[LAST], NULL);
        add_single(s, i, 0, s->bodies, sum[CARRIED], compensation);
        for (int c = 0; c < 2; ++c) {
            const double right = p.planet[c] + p.ring[c];
            size += p.ring[c] * p.ring[c];
            error[ORDERS] += p.lost[c] * p.lost[c];
            for (int k = 0; k < ORDERS; ++k)
                error[k] += (sum[k][c] - right) * (sum[k][c] - right);
        }
    }
    row[0] = (double)s->bodies - 1;
    for (int k = 0; k <= ORDERS; ++k)
        row[1 + k] = sqrt(error[k] / size);
}

/* Sets a[] to accelerations summed in single precision. The study tests
   whether their errors show in the energy. */
static void accelerate_single(void *what, const double x[],
                              const double v[], double a[])
{
    const struct scene *s = what;
    const size_t n = s->bodies;
    (void)x, (void)v; /* x is s->position */
    for (size_t i = 0; i < n; ++i) {
        float sum[2] = {0, 0};
        add_single(s, i, 0, n, sum, NULL);
        a[i] = s->k2 * (double)sum[0];
        a[n + i] = s->k2 * (double)sum[1];
        a[2 * n + i] = 0;
    }
}

/* Begins a run of a ring whose mass does not depend on its number of
   particles. */
static void begin_single(struct sky *k, double particles)
{
    const double step = 2 * KEPLER_PI / CELESTIAL_K * 3.375 / 200;
    begin_sky(k, "ring",
              GALLERY_CHOICES({"particles", particles},
                              {"factor", 3072 / particles}),
              "leapfrog", step);
}

/* Returns the relative energy change of a ring of 3072 particles in 20
   steps, a tenth of an orbit. */
static double energy_singly(bool single)
{
    struct sky k;
    begin_single(&k, 3072);
    if (single) {
        k.stepping.forces.accelerate = accelerate_single;
        k.stepping.forces.what = &k.scene;
    }
    const double before = energy_of(&k);
    stepping_run(&k.stepping, 20);
    const double change = energy_of(&k) / before - 1;
    end_sky(&k);
    return fabs(change);
}

/* Writes the error of the acceleration due to the ring against its number
   of particles, for a ring of constant mass. */
static void study_single(struct study *s)
{
    struct sky k;
    TABLE_COLUMNS(s->out, {"N", "", "particles of a ring of one mass"},
                  {"first", "", "error of its own pull, planet first"},
                  {"last", "", "planet last"},
                  {"carried", "", "compensated, planet first"},
                  {"model", "", "pulls rounded as the planet's"});
    for (double n = 192; n < 65536 && !progress_signal(); n *= 4) {
        double row[2 + ORDERS];
        begin_single(&k, n);
        compare_singly(&k.scene, row);
        char which[24];
        snprintf(which, sizeof which, "%.0f", row[0]);
        TABLE_RESULTS_OF(s->summary, which, {"first", row[1]},
                         {"last", row[2]}, {"carried", row[3]},
                         {"model", row[4]});
        table_row(s->out, 2 + ORDERS, row);
        end_sky(&k);
    }
    TABLE_RESULTS(s->summary, {"energy", energy_singly(true)},
                  {"double", energy_singly(false)});
}

#ifdef VECTOR_AVX512
#include <immintrin.h>

/* Performs 20 n floating-point operations in each of four lanes, to measure
   the peak speed of the machine. Ten independent chains of fused
   multiply-adds keep all execution units busy. The chains stay in registers
   only if the inner loop is unrolled. This requires VECTOR_LONG, which sets
   gcc's optimization level 3. */
VECTOR_LONG
__attribute__((target("avx2,fma"))) static double peak4(uint64_t n)
{
    const __m256d m = _mm256_set1_pd(0.999), c = _mm256_set1_pd(0.001);
    __m256d a[10];
    for (int i = 0; i < 10; ++i)
        a[i] = _mm256_set1_pd(i);
    for (uint64_t k = 0; k < n; ++k)
        for (int i = 0; i < 10; ++i)
            a[i] = _mm256_fmadd_pd(a[i], m, c);
    for (int i = 1; i < 10; ++i)
        a[0] = _mm256_add_pd(a[0], a[i]);
    return _mm256_cvtsd_f64(a[0]);
}

/* Does the same as peak4 with eight lanes. */
VECTOR_LONG
__attribute__((target("avx512f"))) static double peak8(uint64_t n)
{
    const __m512d m = _mm512_set1_pd(0.999), c = _mm512_set1_pd(0.001);
    __m512d a[10];
    for (int i = 0; i < 10; ++i)
        a[i] = _mm512_set1_pd(i);
    for (uint64_t k = 0; k < n; ++k)
        for (int i = 0; i < 10; ++i)
            a[i] = _mm512_fmadd_pd(a[i], m, c);
    for (int i = 1; i < 10; ++i)
        a[0] = _mm512_add_pd(a[0], a[i]);
    return _mm512_reduce_add_pd(a[0]);
}

#endif

/* Performs 20 n operations in plain C, for the portable kernel. The loop is
   unrolled by hand, because VECTOR_LONG does not work with all
   compilers. */
static double peak1(uint64_t n)
{
    const double m = 0.999, c = 0.001;
    double a[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, sum = 0;
    for (uint64_t k = 0; k < n; ++k) {
        a[0] = a[0] * m + c;
        a[1] = a[1] * m + c;
        a[2] = a[2] * m + c;
        a[3] = a[3] * m + c;
        a[4] = a[4] * m + c;
        a[5] = a[5] * m + c;
        a[6] = a[6] * m + c;
        a[7] = a[7] * m + c;
        a[8] = a[8] * m + c;
        a[9] = a[9] * m + c;
    }
    for (int i = 0; i < 10; ++i)
        sum += a[i];
    return sum;
}

/* The measure of a kernel's speed: a loop of pure multiply-adds in `lanes`
   lanes. `operations` is the kernel's number of operations per pair. A
   fused multiply-add counts as two operations, and a root, quotient or
   estimate as one. */
struct yardstick {
    double operations, lanes;
    double (*peak)(uint64_t n);
};

static struct yardstick yardstick(enum gravity_kernel kernel)
{
    const double operations = kernel == GRAVITY_AVX512 ? 28 : 18;
#ifdef VECTOR_AVX512
    if (VECTOR_HAS("avx512f"))
        return (struct yardstick){operations, 8, peak8};
    if (VECTOR_HAS("avx2") && VECTOR_HAS("fma"))
        return (struct yardstick){operations, 4, peak4};
#endif
    return (struct yardstick){operations, 1, peak1};
}

/* Returns the operations per second of the loop. The result is volatile,
   because otherwise the compiler would remove the loop. */
static double measure_peak(const struct yardstick *y)
{
    const uint64_t n = 5000000;
    const double begin = bench_seconds();
    volatile double sum = y->peak(n);
    (void)sum;
    return (double)n * 20 * y->lanes / (bench_seconds() - begin);
}

/* Returns the number of ordered pairs per second of a kernel. Repeats the
   kernel for 0.1 s of the clock `seconds`. */
static double measure_pairs(struct gravity *g, double (*seconds)(void),
                            const double x[], double a[])
{
    const double n = (double)g->bodies, begin = seconds();
    double runs = 0;
    do {
        gravity_add(g, x, a);
        ++runs;
    } while (seconds() - begin < 0.1);
    return runs * n * (n - 1) / (seconds() - begin);
}

/* Returns the largest error of the x acceleration over every 37th body,
   compared with a long double sum. The error is divided by the sum of the
   absolute values of the terms. */
static double kernel_error(struct gravity *g, const double x[], double a[])
{
    const size_t n = g->bodies;
    double worst = 0;
    memset(a, 0, 3 * n * sizeof a[0]);
    gravity_add(g, x, a);
    for (size_t i = 0; i < n; i += 37) {
        long double sum = 0, size = 0;
        for (size_t j = 0; j < n; ++j) {
            const long double dx = (long double)x[j] - x[i];
            const long double dy = (long double)x[n + j] - x[n + i];
            const long double s = dx * dx + dy * dy +
                                  (long double)g->softening * g->softening;
            const long double w = g->k2 * g->mass[j] / (s * sqrtl(s));
            sum += w * dx;
            size += fabsl(w * dx);
        }
        worst = fmax(worst, (double)(fabsl(sum - a[i]) / size));
    }
    return worst;
}

/* Runs the simplest leapfrog for two bodies, to measure the overhead of the
   stepping module. Returns a coordinate, which keeps the compiler from
   removing the loop. */
static double step_by_hand(double x[6], double v[6], const double m[2],
                           double k2, double h, uint64_t steps)
{
    double d[3], a = 0;
    for (uint64_t n = 0; n <= steps; ++n) {
        d[0] = x[1] - x[0], d[1] = x[3] - x[2], d[2] = x[5] - x[4];
        const double s = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        a = k2 / (s * sqrt(s)) * (n > 0 && n < steps ? h : h / 2);
        v[0] += a * m[1] * d[0], v[1] -= a * m[0] * d[0];
        v[2] += a * m[1] * d[1], v[3] -= a * m[0] * d[1];
        v[4] += a * m[1] * d[2], v[5] -= a * m[0] * d[2];
        if (n < steps)
            for (int k = 0; k < 6; ++k)
                x[k] += h * v[k];
    }
    return x[1];
}

/* Returns the time of a leapfrog step of the Sun and the Earth (in ns),
   with step_by_hand or with the stepping module. */
static double measure_two(bool by_hand)
{
    const uint64_t steps = 2000000;
    volatile double last = 0; /* keeps the loop */
    struct sky k;
    begin_sky(&k, "sun-earth", NULL, "leapfrog", 0.03);
    const double begin = bench_seconds();
    if (by_hand)
        last = step_by_hand(k.scene.position, k.scene.velocity,
                            k.scene.mass, k.scene.k2, 0.03, steps);
    else
        stepping_run(&k.stepping, steps);
    const double seconds = bench_seconds() - begin;
    (void)last;
    end_sky(&k);
    return seconds / (double)steps * 1e9;
}

/* Measures a kernel and writes its row, which includes the peak speed of
   the machine. */
static void measure_kernel(struct study *s, struct sky *k, double a[],
                           enum gravity_kernel kernel)
{
    const struct yardstick y = yardstick(kernel);
    double v[2]; /* peak, operations/s; kernel, pairs/s */
    k->gravity.kernel = kernel;
    const double error = kernel_error(&k->gravity, k->scene.position, a);
    BENCH_TURNS(way, 2, v,
                way == 0 ? measure_peak(&y)
                         : measure_pairs(&k->gravity, bench_seconds,
                                         k->scene.position, a));
    table_print(s->out, "%-9s %.4g %.3g %.4g %.3g %.2g\n",
                gravity_kernels[kernel], v[1], y.operations, v[0],
                100 * v[1] * y.operations / v[0], error);
}

/* Measures all kernels of this machine that sum over pairs, using a ring.
   Then measures the leapfrog step of two bodies. */
static void study_speed(struct study *s)
{
    struct sky k;
    double ns[2];
    begin_sky(&k, "ring", NULL, "leapfrog", 4);
    double *a = malloc(3 * k.scene.bodies * sizeof *a);
    program_memory(a, NULL);
    bench_machine(s->out);
    table_print(s->out,
                "# %zu bodies\n# kernel, ordered pairs a second, "
                "operations a pair,\n# operations a second of a loop of "
                "nothing else, per cent of it, error\n",
                k.scene.bodies);
    for (int i = GRAVITY_PORTABLE; i < GRAVITY_TREE; ++i)
        if (gravity_can((enum gravity_kernel)i))
            measure_kernel(s, &k, a, (enum gravity_kernel)i);
    BENCH_TURNS(way, 2, ns, measure_two(way == 1));
    table_print(s->out,
                "# ns a step of two bodies: stepping, by hand, "
                "ratio\ntwo       %.3g %.3g %.3g\n",
                ns[0], ns[1], ns[0] / ns[1]);
    free(a);
    end_sky(&k);
}

/* Writes the pairs per second with one thread and with two, for rings of 63
   to 4095 particles. Also writes the median ratio of the rounds, so that a
   temporary slowdown of the machine affects only one ratio. */
static void study_threads(struct study *s)
{
    bench_machine(s->out);
    table_print(s->out, "# kernel %s, 2 threads\n",
                gravity_kernels[own.kernel]);
    TABLE_COLUMNS(s->out, {"N", "", "bodies of a ring"},
                  {"one", "1/s", "pairs, one thread, by the clock"},
                  {"many", "1/s", "pairs, as many as there are"},
                  {"ratio", "", "median of the rounds'"});
    for (size_t n = 63; n < 5000 && !progress_signal(); n = 4 * n + 3) {
        struct sky k;
        begin_sky(&k, "ring", GALLERY_CHOICES({"particles", (double)n}),
                  "leapfrog", 4);
        k.gravity.kernel = (enum gravity_kernel)own.kernel;
        double *a = calloc(3 * k.scene.bodies, sizeof *a);
        program_memory(a, NULL);
        double pairs[2][BENCH_ROUNDS], ratio[BENCH_ROUNDS];
        for (int round = -1; round < BENCH_ROUNDS; ++round) {
            const int at =
                round < 0 ? 0 : round; /* round -1 is the warm-up */
            for (int way = 0; way < 2; ++way) {
                k.gravity.threads = way ? 2 : 1;
                pairs[way][at] = measure_pairs(&k.gravity, bench_clock,
                                               k.scene.position, a);
            }
            ratio[at] = pairs[1][at] / pairs[0][at];
        }
        TABLE_ROW(s->out, (double)k.scene.bodies,
                  bench_median(pairs[0], BENCH_ROUNDS),
                  bench_median(pairs[1], BENCH_ROUNDS),
                  bench_median(ratio, BENCH_ROUNDS));
        free(a);
        end_sky(&k);
    }
}

enum { DIRECT, LANES, NARROW, WIDE, WAYS };

/* Computes all accelerations in a[]. Returns the time (in ms), including
   the construction of a tree. */
static double time_forces(struct sky *k, int way, double a[])
{
    struct gravity *g = &k->gravity;
    g->kernel = way == DIRECT ? GRAVITY_PORTABLE : gravity_fastest();
    if (way >= NARROW && !gravity_use_tree(g, way == NARROW ? 0.2 : 0.5))
        program_give_up("no memory for the tree");
    memset(a, 0, 3 * g->bodies * sizeof *a);
    const double begin = bench_seconds();
    gravity_add(g, k->scene.position, a);
    return (bench_seconds() - begin) * 1e3;
}

/* Sets ring[] to the acceleration of body i due to the ring alone, that is,
   a[] without the planet's part. The planet's part is so large that,
   relative to it, the error of any tree would look small. */
static void without_planet(const struct sky *k, size_t i, const double a[],
                           double ring[3])
{
    const struct scene *s = &k->scene;
    double d[3], r2 = s->softening * s->softening;
    for (size_t c = 0; c < 3; ++c) {
        d[c] = s->position[c * s->bodies] - s->position[c * s->bodies + i];
        r2 += d[c] * d[c];
    }
    for (size_t c = 0; c < 3; ++c)
        ring[c] = a[c * s->bodies + i] -
                  s->k2 * s->mass[0] / (r2 * sqrt(r2)) * d[c];
}

/* Returns the root mean square difference of the tree's accelerations a[]
   from the direct sum b[], in units of the root mean square acceleration
   due to the ring. */
static double tree_error(const struct sky *k, const double a[],
                         const double b[])
{
    const size_t n = k->scene.bodies;
    double error = 0, size = 0, ring[3];
    for (size_t i = 1; i < n; ++i) {
        without_planet(k, i, b, ring);
        for (size_t c = 0; c < 3; ++c) {
            const double d = a[c * n + i] - b[c * n + i];
            error += d * d;
            size += ring[c] * ring[c];
        }
    }
    return sqrt(error / size);
}

/* Writes a row with the number of particles, the times of two direct sums,
   and the times, errors and speed-ups of two trees. */
static void compare_tree(struct study *s, size_t particles)
{
    struct sky k;
    begin_sky(&k, "ring", GALLERY_CHOICES({"particles", (double)particles}),
              "leapfrog", 4);
    double *a = malloc(WAYS * 3 * k.scene.bodies * sizeof *a);
    program_memory(a, NULL);
    const size_t n = 3 * k.scene.bodies;
    double t[WAYS];
    BENCH_TURNS(w, WAYS, t, time_forces(&k, w, a + (size_t)w * n));
    table_print(s->out, "%zu %.4g %.4g", particles, t[DIRECT], t[LANES]);
    for (int w = NARROW; w < WAYS; ++w)
        table_print(s->out, " %.4g %.2g %.2g", t[w],
                    tree_error(&k, a + (size_t)w * n, a), t[LANES] / t[w]);
    table_print(s->out, "\n");
    free(a);
    end_sky(&k);
}

static void study_tree(struct study *s)
{
    bench_machine(s->out);
    table_print(s->out,
                "# times in ms. N, direct: portable and %s;\n# tree with "
                "theta = 0.2: time, error, times as fast as %s; with 0.5\n",
                gravity_kernels[gravity_fastest()],
                gravity_kernels[gravity_fastest()]);
    for (size_t n = 125; n < 33000 && !progress_signal(); n *= 2)
        compare_tree(s, n);
}

static const struct study_entry studies[] = {
    {"sun-earth", study_sun_earth, "five years by two methods",
     STUDY_KEYS({"axis", "AU", "of the first ellipse"},
                {"eccentricity", "1", "the same"},
                {"period", "d", "of leapfrog"},
                {"closed_period", "d", "Kepler's"},
                {"drift", "AU/d", "speed of the centre of mass"},
                {"euler_radius", "AU", "after five years by euler"},
                {"euler_law", "AU", "the same by the law"},
                {"leapfrog_error", "AU", "of place after five years"},
                {"leapfrog_law", "AU", "the same by the law"})},
    {"anomaly", study_anomaly, "Kepler's equation", NULL},
    {"eccentric", study_eccentric, "errors on long ellipses",
     STUDY_KEYS(
         {"kahan-li8_<e>", "AU", "error after an orbit of eccentricity e"},
         {"leapfrog", "AU", "the same at 0.99"},
         {"more", "AU", "the same, 100 times the steps"})},
    {"encounter", study_encounter, "falls past the Sun",
     STUDY_KEYS({"dE_s", "1", "largest error of energy, softened"},
                {"dx_s", "AU", "largest error of place, softened"},
                {"dE_<fall>_<q>", "1",
                 "energy: l leapfrog, k kahan-li8, s softened"},
                {"dx_<fall>_<q>", "AU", "place: the same"})},
    {"planets", study_planets, "a heavier Jupiter",
     STUDY_KEYS({"energy_300", "1", "relative error, Jupiter x 300"},
                {"eight", "1", "the same by leapfrog in a century"})},
    {"circumbinary", study_circumbinary, "the planet of two stars",
     STUDY_KEYS({"v_A", "AU/d", "first star, at the start"},
                {"v_B", "AU/d", "second star"}, {"v_P", "AU/d", "planet"},
                {"error", "AU", "of the planet's place after 400 d"})},
    {"survival", study_survival, "how close it may come",
     STUDY_KEYS({"safe", "1", "least safe distance, the stars' being 1"},
                {"safe_AU", "AU", "the same"},
                {"law", "1", "by the fitted law"},
                {"law_AU", "AU", "the same"})},
    {"work", study_work, "seven methods on its orbit",
     STUDY_KEYS({"dE_<method>_<n>", "1",
                 "error of energy, n evaluations a period"},
                {"dx_<method>_<n>", "AU", "error of place after 400 d"})},
    {"ellipses", study_ellipses, "planets that are kicked",
     STUDY_KEYS({"<method>", "1", "error of energy, 4 d from kick to kick"},
                {"<method>_slope", "1",
                 "2 d, masses times 1 to 10: power of them"})},
    {"two-suns", study_two_suns, "their cost beside others'", NULL},
    {"choreography", study_choreography, "circles that break",
     STUDY_KEYS({"S_<N>", "1", "the sum of N bodies"},
                {"v_<N>", "1", "speed on the circle"},
                {"rate_<N>", "1", "growth over angular velocity, theory"},
                {"measured_<N>", "1", "the same, measured"},
                {"theory_<N>", "1", "orbits until it breaks, theory"},
                {"orbits_<N>", "1", "the same, measured; 0 for N = 2"})},
    {"figure-eight", study_eight, "three bodies on an eight",
     STUDY_KEYS({"closure", "1", "miss after a period, kahan-li8"})},
    {"ring-speeds", study_ring_speeds, "circles in a ring",
     STUDY_KEYS({"edge_<k>", "1/AU^2", "pull of the ring 10^-k AU outside"},
                {"per_decade", "1/AU^2", "its growth, by the law"})},
    {"ring", study_ring, "3072 particles and their weight",
     STUDY_KEYS({"energy", "1", "relative change"},
                {"dispersion", "1", "variance / mean of the cells' counts"},
                {"stirring", "1", "rms radial velocity / circle's"})},
    {"softening", study_softening, "how it turns an orbit", NULL},
    {"single", study_single, "a ring's pull in single precision",
     STUDY_KEYS({"first_<N>", "1", "error of the pull of N on each other"},
                {"model_<N>", "1", "the same, by the model"},
                {"last_<N>", "1", "the planet last"},
                {"carried_<N>", "1", "compensated"},
                {"energy", "1", "its error, 3072, a tenth of an orbit"},
                {"double", "1", "the same in double precision"})},
    {"speed", study_speed, "pairs a second of the kernels", NULL},
    {"threads", study_threads, "the same on several threads", NULL},
    {"tree", study_tree, "when it would pay", NULL},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study planets, survival, work, ring"},
    {"orbits", 'n', "N",
     "planets: years (1000); survival (1000), work (100):\n"
     "periods of the stars; ring: orbits (2)"},
    {"", 0, NULL, "--study ring"},
    {"factor", 'f', "F", "on the masses of the particles (1)"},
    {"moon", 'm', "M", "mass of a moon (0: none)"},
    {"mixed", 'x', "D", "decades of different masses (0)"},
    {"kernel", 'k', "NAME", "auto, portable or avx512 (the fastest here)"},
    {0}};

/* Takes an option. Refuses a kernel that this processor lacks. */
static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'n': own.orbits = options_positive(o, 1e6); break;
    case 'f': own.factor = options_real(o, 0, 1e5); break;
    case 'm': own.moon = options_real(o, 0, 0.1); break;
    case 'x': own.mixed = (double)options_count(o, 0, 6); break;
    case 'k':
        own.kernel = options_choice(o, gravity_kernels);
        if (!gravity_can((enum gravity_kernel)own.kernel))
            options_fail(o, "this processor has no %s", options_text(o));
        if (own.kernel == GRAVITY_TREE)
            options_fail(o, "--kernel: a tree is measured by --study tree");
    }
}

int main(int argc, char *argv[])
{
    own.kernel = gravity_fastest();
    const struct study_program program = {
        .name = PROGRAM,
        .purpose = "Measure bodies that attract each other.",
        .events = "rows",
        .studies = studies,
        .seeds = 1000000000000000,
        .drawing = "--study ring",
        .options = entries,
        .take = take_option};
    return study_main(&program, argc, argv);
}
