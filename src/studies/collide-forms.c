/* Measures rounding, energy drift and cost of five forms of a collision. */
#include "line/collide.h"
#include "toolbox/bench.h"
#include "toolbox/quad.h"
#include "toolbox/random.h"
#include "toolbox/study.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define PROGRAM "collide-forms"

static struct {
    double ratios[8], offset;
    size_t ratio_count;
    uint64_t tests, collisions, digits;
} own = {.ratios = {1000},
         .ratio_count = 1,
         .tests = 100000,
         .collisions = 1000000,
         .digits = 5};

/* Returns the next collision count after n at which the drift is written.
   The counts are 1000, 2000, 5000, 10000, ..., and also last / 10 and
   `last`, where the run ends. */
static uint64_t next_stop(uint64_t n, uint64_t last)
{
    static const uint64_t steps[] = {1, 2, 5};
    uint64_t stop = n < last / 10 ? last / 10 : last;
    for (uint64_t decade = 1000; decade < stop; decade *= 10)
        for (int i = 0; i < 3; ++i)
            if (decade * steps[i] > n && decade * steps[i] < stop)
                stop = decade * steps[i];
    return stop;
}

struct rounding {
    double energy_max, energy_square, momentum_max, velocity_max;
};

/* Compares a collision in the given form with (1.5, eq:difference) in
   113-bit arithmetic and adds its errors to *all. An error dv of a velocity
   v causes the momentum error m dv and the energy error m (v + dv/2) dv. */
static void measure_rounding(struct rounding *all, int form, double u1,
                             double u2, double im1, double im2)
{
    const quad m1 = 1 / (quad)im1, m2 = 1 / (quad)im2;
    const quad d = (quad)u1 - u2, sum = (quad)im1 + im2;
    double v1 = u1, v2 = u2;
    collide_by(form, &v1, &v2, im1, im2, 1);
    const quad e1 = v1 - (u1 - 2 * im1 / sum * d);
    const quad e2 = v2 - (u2 + 2 * im2 / sum * d);
    const quad momentum = m1 * e1 + m2 * e2;
    const quad energy = m1 * (v1 - e1 / 2) * e1 + m2 * (v2 - e2 / 2) * e2;
    const quad total = (m1 * u1 * u1 + m2 * u2 * u2) / 2;
    const quad scale = m1 * fabs(u1) + m2 * fabs(u2);
    const double relative = (double)(energy / total) / DBL_EPSILON;
    all->energy_square += relative * relative;
    all->energy_max = fmax(all->energy_max, fabs(relative));
    all->momentum_max = fmax(
        all->momentum_max, fabs((double)(momentum / scale)) / DBL_EPSILON);
    all->velocity_max =
        fmax(all->velocity_max, fmax(fabs((double)e1), fabs((double)e2)) /
                                    fmax(fabs(u1), fabs(u2)) / DBL_EPSILON);
}

static void study_rounding(struct study *s)
{
    struct random r;
    const char *eps = "2^-52";
    TABLE_COLUMNS(
        s->out, {"R", "", "mass ratios are drawn from 1/R to R"},
        {"form", "",
         "0 cm, 1 difference, 2 impulse, 3 complement, 4 smaller"},
        {"dE_max", eps, "worst relative error of energy"},
        {"dE_rms", eps, "root mean square of the same"},
        {"dP_max", eps, "worst error of momentum / sum m|u|"},
        {"dv_max", eps, "worst error of v / larger |u|"});
    progress_begin(&s->progress, PROGRAM, own.ratio_count * own.tests,
                   "pairs");
    for (size_t k = 0; k < own.ratio_count; ++k) {
        struct rounding all[COLLIDE_FORMS] = {{0, 0, 0, 0}};
        random_seed(&r, s->seed); /* the same pairs for every ratio */
        for (uint64_t i = 0; i < own.tests && !progress_signal(); ++i) {
            const double im1 = random_between(&r, 0.5, 1.5);
            const double ratio = own.ratios[k];
            const double im2 =
                im1 * random_log_uniform(&r, 1 / ratio, ratio);
            const double u1 = own.offset + random_between(&r, -1, 1);
            const double u2 = own.offset + random_between(&r, -1, 1);
            for (int form = 0; form < COLLIDE_FORMS; ++form)
                measure_rounding(&all[form], form, u1, u2, im1, im2);
            progress_update(&s->progress, k * own.tests + i,
                            k * own.tests + i);
        }
        if (progress_signal())
            return;
        for (int form = 0; form < COLLIDE_FORMS; ++form) {
            const struct rounding *a = &all[form];
            const double rms = sqrt(a->energy_square / (double)own.tests);
            TABLE_ROW(s->out, own.ratios[k], form, a->energy_max, rms,
                      a->momentum_max, a->velocity_max);
            if (k + 1 == own.ratio_count)
                TABLE_RESULTS_OF(s->summary, collide_form_names[form],
                                 {"energy_max", a->energy_max},
                                 {"energy_rms", rms},
                                 {"momentum_max", a->momentum_max},
                                 {"velocity_max", a->velocity_max});
        }
    }
}

/* The drift is measured with four bodies in a row between two walls. The
   next gap to close is random, but the same random numbers are used for
   every form. */
enum { MOVERS = 4, BODIES = MOVERS + 2 };

static const double row_im[BODIES] = {0,         1 / 11.23, 1 / 21.23,
                                      1 / 31.23, 1 / 41.23, 0};

/* Returns the index of a random gap whose two bodies approach each other.
   There always is such a gap. Otherwise no velocity would exceed the
   velocity to its right. As both walls are at rest, all velocities would
   then be zero, but the four bodies have energy. */
static uint64_t row_draw(struct random *r, const double v[BODIES])
{
    for (;;) {
        const uint64_t i = random_below(r, BODIES - 1);
        if (v[i] > v[i + 1])
            return i;
    }
}

static quad row_energy(const double v[BODIES])
{
    quad energy = 0;
    for (int i = 1; i <= MOVERS; ++i)
        energy += (quad)v[i] * v[i] / row_im[i] / 2;
    return energy;
}

/* Returns the energy that the difference form gains in a collision of gap
   i, because its two fractions add up to 1 + delta instead of 1. The energy
   is 2 delta d^2 / (a + b) (1.11, eq:bias). The sum over a run predicts the
   drift. */
static double row_bias(uint64_t i, const double v[BODIES])
{
    const double a = row_im[i], b = row_im[i + 1], sum = a + b;
    const double delta = (double)((quad)(a / sum) + (b / sum) - 1);
    const double d = v[i] - v[i + 1];
    return 2 * delta * d * d / sum;
}

/* Measures the energy drift of each form. The forms take turns of a million
   collisions each, so an interrupted run ends soon. */
static void study_drift(struct study *s)
{
    double v[COLLIDE_FORMS][BODIES], error[COLLIDE_FORMS + 1];
    double tenth[COLLIDE_FORMS] = {0}, predicted = 0;
    struct random r[COLLIDE_FORMS];
    progress_begin(&s->progress, PROGRAM, own.collisions, "collisions");
    table_column(s->out, "n", "", "collisions");
    for (int f = 0; f < COLLIDE_FORMS; ++f) {
        table_column(s->out, collide_form_names[f], "",
                     "relative error of the energy in this form");
        memcpy(v[f], (double[BODIES]){0, 1, 2, 3, 4, 0}, sizeof v[f]);
        random_seed(&r[f], s->seed);
    }
    const quad start = row_energy(v[0]);
    for (uint64_t n = 0; n < own.collisions;) {
        const uint64_t stop = next_stop(n, own.collisions);
        while (n < stop) {
            const uint64_t turn = stop - n < 1000000 ? stop - n : 1000000;
            for (int f = 0; f < COLLIDE_FORMS; ++f)
                for (uint64_t i = 0; i < turn; ++i) {
                    const uint64_t gap = row_draw(&r[f], v[f]);
                    if (f == COLLIDE_DIFFERENCE)
                        predicted += row_bias(gap, v[f]);
                    collide_by(f, &v[f][gap], &v[f][gap + 1], row_im[gap],
                               row_im[gap + 1], 1);
                }
            n += turn;
            progress_update(&s->progress, n, COLLIDE_FORMS * n);
            if (progress_signal())
                return;
        }
        error[0] = (double)n;
        for (int f = 0; f < COLLIDE_FORMS; ++f) {
            error[f + 1] = (double)(row_energy(v[f]) / start - 1);
            if (n == own.collisions / 10)
                tenth[f] = error[f + 1];
        }
        table_row(s->out, COLLIDE_FORMS + 1, error);
    }
    for (int f = 0; f < COLLIDE_FORMS; ++f)
        TABLE_RESULTS_OF(s->summary, collide_form_names[f],
                         {"energy_error", error[f + 1]},
                         {"energy_error_tenth", tenth[f]});
    TABLE_RESULTS(
        s->summary, {"predicted_difference", predicted / (double)start},
        {"slope",
         error[COLLIDE_DIFFERENCE + 1] / tenth[COLLIDE_DIFFERENCE]},
        {"improvement",
         fabs(error[COLLIDE_DIFFERENCE + 1] / error[COLLIDE_SMALLER + 1])});
}

/* Returns the number of collisions of a heavy ball, a light ball and a
   wall. Stops at `limit`, because rounding may make the collisions endless.
   The wall is a body at rest with inverse mass zero. */
static uint64_t count_galperin(int form, double im_heavy, uint64_t limit)
{
    double heavy = -1, light = 0;
    uint64_t n = 0;
    for (; n < limit && !progress_signal(); ++n)
        if (light > heavy)
            collide_by(form, &light, &heavy, 1, im_heavy, 1);
        else if (light < 0)
            collide_by(form, &light, &(double){0}, 1, 0, 1);
        else
            break;
    return n;
}

/* Does the same as count_galperin in single precision, with the most
   accurate form, `smaller`. */
static uint64_t count_galperin_float(float im_heavy, uint64_t limit)
{
    float heavy = -1, light = 0;
    uint64_t n = 0;
    for (; n < limit && !progress_signal(); ++n)
        if (light > heavy) {
            const float change = 2 * (light - heavy);
            const float small = change * (im_heavy / (1 + im_heavy));
            light -= change - small;
            heavy += small;
        } else if (light < 0) {
            light = -light;
        } else {
            break;
        }
    return n;
}

static void study_galperin(struct study *s)
{
    double ratio = 1, row[COLLIDE_FORMS + 3];
    TABLE_COLUMNS(s->out, {"k", "", "the mass ratio is 100^k"},
                  {"N", "", "exact number of collisions"});
    for (int f = 0; f < COLLIDE_FORMS; ++f)
        table_column(s->out, collide_form_names[f], "",
                     "counted in this form");
    table_column(s->out, "float", "", "smaller, in single precision");
    progress_begin(&s->progress, PROGRAM, own.digits, "mass ratios");
    for (uint64_t k = 0; k <= own.digits; ++k, ratio *= 100) {
        row[0] = (double)k;
        row[1] = ceil(acos(-1) / atan(sqrt(1 / ratio))) - 1;
        const uint64_t limit = 2 * (uint64_t)row[1];
        for (int f = 0; f < COLLIDE_FORMS; ++f)
            row[f + 2] = (double)count_galperin(f, 1 / ratio, limit);
        row[COLLIDE_FORMS + 2] =
            (double)count_galperin_float((float)(1 / ratio), limit);
        if (progress_signal())
            return;
        progress_update(&s->progress, k, k);
        table_row(s->out, COLLIDE_FORMS + 3, row);
    }
    table_real(s->summary, "exact", row[1]);
    for (int f = 0; f < COLLIDE_FORMS; ++f)
        TABLE_RESULTS_OF(s->summary, collide_form_names[f],
                         {"count", row[f + 2]});
    table_real(s->summary, "count_float", row[COLLIDE_FORMS + 2]);
}
/* Writes velocities before and after a collision, for random states of
   energy 1/2 in which the bodies approach each other. Each state is a
   random direction in the plane with the coordinates sqrt(m1) u1 and
   sqrt(m2) u2. */
static void study_map(struct study *s)
{
    const double im[] = {1, 0.25};
    progress_begin(&s->progress, PROGRAM, own.tests, "pairs");
    TABLE_COLUMNS(s->out, {"u1", "m/s", "before, body 1"},
                  {"u2", "m/s", "before, body 2"},
                  {"v1", "m/s", "after, body 1"},
                  {"v2", "m/s", "after, body 2"});
    for (uint64_t n = 0; n < own.tests && !progress_signal();) {
        double u[2], v[2];
        random_direction(&s->random, 2, u);
        for (int i = 0; i < 2; ++i)
            v[i] = u[i] *= sqrt(im[i]);
        if (!(u[0] > u[1]))
            continue;
        collide(&v[0], &v[1], im[0], im[1], 1);
        TABLE_ROW(s->out, u[0], u[1], v[0], v[1]);
        ++n;
    }
}

enum { PAIRS = 4096 };

struct bench {
    double u[PAIRS][2], im[PAIRS][2];
};

/* Returns the mean processor time of a collision, ns. */
static double time_form(const struct bench *b, int form, uint64_t passes)
{
    static double v[PAIRS][2];
    const double start = bench_seconds();
    memcpy(v, b->u, sizeof v);
    for (uint64_t k = 0; k < passes && !progress_signal(); ++k)
        for (int i = 0; i < PAIRS; ++i)
            collide_by(form, &v[i][0], &v[i][1], b->im[i][0], b->im[i][1],
                       1);
    return (bench_seconds() - start) * 1e9 / ((double)passes * PAIRS);
}

/* Measures the time of a collision in each form. The forms take turns, so a
   temporary slowdown of the machine affects all of them. Round -1 is a
   warm-up, and its time is overwritten by round 0. */
static void study_cost(struct study *s)
{
    static struct bench b;
    double times[COLLIDE_FORMS][BENCH_ROUNDS];
    const uint64_t passes = own.collisions / PAIRS + 1;
    for (int i = 0; i < PAIRS; ++i)
        for (int body = 0; body < 2; ++body) {
            b.u[i][body] = random_between(&s->random, -1, 1);
            b.im[i][body] = random_between(&s->random, 0.5, 1.5);
        }
    progress_begin(&s->progress, PROGRAM, BENCH_ROUNDS, "rounds");
    for (int round = -1; round < BENCH_ROUNDS; ++round)
        for (int f = 0; f < COLLIDE_FORMS; ++f) {
            const double ns = time_form(&b, f, passes);
            times[f][round < 0 ? 0 : round] = ns;
        }
    if (progress_signal())
        return;
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"form", "", "a form of the collision formula"},
                  {"median", "ns", "processor time a collision"},
                  {"least", "ns", "the shortest of five"});
    for (int f = 0; f < COLLIDE_FORMS; ++f) {
        const double median = bench_median(times[f], BENCH_ROUNDS);
        table_print(s->out, "%-10s %6.2f %6.2f\n", collide_form_names[f],
                    median, times[f][0]);
        TABLE_RESULTS_OF(s->summary, collide_form_names[f], {"ns", median});
    }
}

static const struct study_entry studies[] = {
    {"rounding", study_rounding, "errors of one collision",
     STUDY_KEYS(
         {"energy_max_<form>", "2^-52", "worst relative error of energy"},
         {"energy_rms_<form>", "2^-52", "root mean square of the same"},
         {"momentum_max_<form>", "2^-52",
          "worst error of momentum / sum m|u|"},
         {"velocity_max_<form>", "2^-52",
          "worst error of v / larger |u|"})},
    {"drift", study_drift, "of the energy in many",
     STUDY_KEYS(
         {"energy_error_tenth_<form>", "1",
          "after a tenth of the collisions"},
         {"energy_error_<form>", "1", "relative error of the energy"},
         {"predicted_difference", "1", "the same of difference, summed up"},
         {"slope", "1", "difference: error / error after a tenth"},
         {"improvement", "1", "error of difference / error of smaller"})},
    {"galperin", study_galperin, "the digits of pi",
     STUDY_KEYS(
         {"exact", "1", "collisions at the last mass ratio"},
         {"count_float", "1", "counted by smaller, single precision"},
         {"count_<form>", "1", "counted in this form"})},
    {"map", study_map, "in the plane of velocities", NULL},
    {"cost", study_cost, "time of one collision",
     STUDY_KEYS({"ns_<form>", "ns", "processor time a collision, median"})},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study rounding"},
    {"mass-ratio", 'R', "R1,..", "ratios from 1/R to R (1000)"},
    {"offset", 'O', "V", "a common velocity (0)"},
    {"", 0, NULL, "--study rounding, map"},
    {"tests", 'n', "N", "random pairs (100000)"},
    {"", 0, NULL, "--study drift, cost"},
    {"collisions", 'c', "N", "how many (1000000)"},
    {"", 0, NULL, "--study galperin"},
    {"digits", 'k', "K", "mass ratios up to 100^K (5)"},
    {0}};

static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'R':
        own.ratio_count = options_list(o, own.ratios, 8);
        for (size_t i = 0; i < own.ratio_count; ++i)
            if (!(own.ratios[i] >= 1 && own.ratios[i] <= 1e100))
                options_fail(o, "'%s' has a ratio outside 1 to 1e100",
                             options_text(o));
        break;
    case 'O': own.offset = options_real(o, -1e100, 1e100); break;
    case 'n': own.tests = options_count(o, 1, 1000000000); break;
    case 'c': own.collisions = options_count(o, 1000, 1000000000000); break;
    case 'k': own.digits = options_count(o, 0, 10); break;
    }
}

STUDY_MAIN(.name = PROGRAM, .purpose = "Compare five forms of a collision.",
           .events = "collisions", .studies = studies, .seeds = UINT64_MAX,
           .drawing = "--study rounding, drift, map", .options = entries,
           .take = take_option)
