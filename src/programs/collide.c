/* Computes one given collision, or tests many random collisions. */
#include "line/collide.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"
#include "toolbox/quad.h"
#include "toolbox/random.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

#define PROGRAM "collide"

enum { SHOWN = 10 }; /* more collisions are not printed */

static struct {
    bool velocities_given, masses_given;
    double velocities[2 * COLLIDE_DIMENSIONS], inverse_masses[2];
    double normal[COLLIDE_DIMENSIONS];
    size_t velocity_count, normal_count; /* 0: not given */
    size_t dimensions;
    uint64_t tests, seed;
    double mass_ratio; /* 0: draw inverse masses from 0.1 to 1.1 */
    double restitution;
    enum collide_form form;
    const char *output, *summary, *command;
} given = {.dimensions = 1,
           .tests = 10,
           .seed = 1,
           .restitution = 1,
           .form = COLLIDE_SMALLER,
           .summary = "/dev/null"};

static const struct options_entry entries[] = {
    {"velocities", 'v', "u1,u2",
     "of the two bodies; in D dimensions\n"
     "D numbers each"},
    {"inverse-masses", 'i', "a,b", "of the two bodies, 0 for a wall"},
    {"restitution", 'e', "e", "1 elastic to 0 sticking (1)"},
    {"form", 'f', "NAME",
     "cm, difference, impulse, complement\n"
     "or smaller (smaller)"},
    {OPTIONS_OUTPUT("report")},
    {OPTIONS_SUMMARY},
    {"", 0, NULL, "--velocities"},
    {"normal", 'n', "nx,ny[,nz]", "line of centres, of any length"},
    {"", 0, NULL, "no --velocities"},
    {"tests", 't', "N", "random collisions (10)"},
    {"dimensions", 'd', "D", "of the random collisions, 1 to 3 (1)"},
    {"mass-ratio", 'R', "R", "random mass ratios from 1/R to R"},
    {"seed", 's', "S", "of the random numbers (1)"},
    {0}};
static const struct table_key keys[] = {
    {"form", "word", "that was used"},
    {"", "", "if --tests:"},
    {"dimensions", "1", "of the collisions"},
    {"energy_error_max", "2^-52", "relative, of the worst collision"},
    {"energy_error_rms", "2^-52", "root mean square of all"},
    {"momentum_error_max", "2^-52",
     "over sum m|u|, of the worst collision"},
    {"momentum_error_rms", "2^-52", "root mean square of all"},
    {"", "", "if --velocities:"},
    {"v<body>_<axis>", "m/s", "after the collision"},
    {"energy_error", "2^-52", "relative; 2^-52 is a machine epsilon"},
    {"momentum_error", "2^-52", "over sum m|u|"},
    {0}};

struct pair {
    size_t dimensions;
    double im[2], normal[COLLIDE_DIMENSIONS];
    double before[2][COLLIDE_DIMENSIONS], after[2][COLLIDE_DIMENSIONS];
};

/* The conserved quantities, computed with 113 bits instead of 53, so any
   change in them comes from the rounding of velocities in collide.

   A wall has infinite momentum and energy and is left out. If there is a
   wall, energies are measured in its frame, where the ball's energy is
   conserved. The ball's momentum is not conserved, because the wall takes
   it. */
struct totals {
    quad energy;       /* in the wall's frame if there is a wall */
    quad energy_scale; /* scale of the rounding error of energy */
    quad momentum[COLLIDE_DIMENSIONS]; /* excludes a wall */
    quad scale;                        /* sum of m |v| */
};

struct errors { /* in units of DBL_EPSILON */
    double energy, momentum;
};

/* Returns the length of a vector in double precision, which suffices for a
   scale. */
static double length(size_t dimensions, const double v[])
{
    double square = 0;
    for (size_t i = 0; i < dimensions; ++i)
        square += v[i] * v[i];
    return sqrt(square);
}

/* Returns whether im is 0, which means a wall, or a valid inverse mass. The
   limits of masses and velocities admit every real body. Beyond them a
   square may overflow or underflow, and the result would be infinity or
   NaN. */
static bool is_inverse_mass(double im)
{
    return im == 0 || (im >= 1e-290 && im <= 1e290);
}

static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    options_begin(&o, PROGRAM,
                  "Collide two bodies, or test random collisions.", entries,
                  argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        switch (option) {
        case 'v':
            given.velocity_count =
                options_list(&o, given.velocities, 2 * COLLIDE_DIMENSIONS);
            for (size_t i = 0; i < given.velocity_count; ++i)
                if (fabs(given.velocities[i]) > 1e150)
                    options_fail(&o, "'%s' has a number beyond 1e150",
                                 options_text(&o));
            given.velocities_given = true;
            break;
        case 'i':
            if (options_list(&o, given.inverse_masses, 2) != 2)
                options_fail(&o, "one number found, expected two: a,b");
            if (!(is_inverse_mass(given.inverse_masses[0]) &&
                  is_inverse_mass(given.inverse_masses[1])))
                options_fail(&o,
                             "'%s', expected two numbers, each 0 or from "
                             "1e-290 to 1e290",
                             options_text(&o));
            if (given.inverse_masses[0] == 0 &&
                given.inverse_masses[1] == 0)
                options_fail(&o, "both are zero: two walls cannot collide");
            given.masses_given = true;
            break;
        case 'n':
            memset(given.normal, 0, sizeof given.normal);
            given.normal_count =
                options_list(&o, given.normal, COLLIDE_DIMENSIONS);
            break;
        case 't': given.tests = options_count(&o, 1, 1000000000); break;
        case 'd':
            given.dimensions = options_count(&o, 1, COLLIDE_DIMENSIONS);
            break;
        case 'R': given.mass_ratio = options_real(&o, 1, 1e100); break;
        case 'e': given.restitution = options_real(&o, 0, 1); break;
        case 'f':
            given.form = options_choice(&o, collide_form_names);
            break;
        case 's': given.seed = options_count(&o, 0, UINT64_MAX); break;
        case 'o': given.output = options_text(&o); break;
        case 'S': given.summary = options_text(&o); break;
        }
    given.command = options_command(&o);
    if (given.velocities_given != given.masses_given)
        options_fail(&o,
                     "--velocities and --inverse-masses need each other");
    if (given.normal_count)
        given.dimensions = given.normal_count;
    else
        given.normal[0] = 1;
    if (given.velocities_given &&
        given.velocity_count != 2 * given.dimensions)
        options_fail(&o,
                     "--velocities: %zu numbers found, expected %zu (%zu "
                     "for each body; --normal says how many)",
                     given.velocity_count, 2 * given.dimensions,
                     given.dimensions);
    if (given.normal[0] == 0 && given.normal[1] == 0 &&
        given.normal[2] == 0)
        options_fail(&o, "--normal: is zero, expected the line of centres");
    program_apart(&o, given.output, given.summary, "report");
}

/* Returns the totals of a pair with velocities v. With a wall, energy_scale
   also includes the wall's speed times the ball's momentum, because the
   rounding error of a velocity depends on its size in the frame of the
   ground, not of the wall. */
static struct totals totals_of(struct pair *p,
                               double v[2][COLLIDE_DIMENSIONS])
{
    struct totals sum = {0, 0, {0}, 0};
    for (int body = 0; body < 2; ++body) {
        const double *frame = p->im[1 - body] > 0 ? NULL : v[1 - body];
        quad mass, square = 0;
        if (p->im[body] == 0)
            continue;
        mass = 1 / (quad)p->im[body];
        for (size_t i = 0; i < p->dimensions; ++i) {
            const quad w = (quad)v[body][i] - (frame ? frame[i] : 0);
            square += w * w;
            sum.momentum[i] += mass * v[body][i];
        }
        const double speed = length(p->dimensions, v[body]);
        sum.energy += mass * square / 2;
        sum.scale += mass * speed;
        sum.energy_scale += mass * square / 2;
        if (frame)
            sum.energy_scale += mass * speed * length(p->dimensions, frame);
    }
    return sum;
}

/* Returns the energy that an inelastic collision should lose (1.9,
   eq:energy-loss). */
static quad expected_loss(const struct pair *p)
{
    quad approach = 0, nn = 0;
    for (size_t i = 0; i < p->dimensions; ++i) {
        const quad n = p->normal[i];
        approach += ((quad)p->before[0][i] - p->before[1][i]) * n;
        nn += n * n;
    }
    const quad e = given.restitution;
    return (1 - e * e) / 2 * approach * approach / nn /
           ((quad)p->im[0] + p->im[1]);
}

/* Returns the change of momentum from a to b, divided by the sum of m |v|,
   in machine epsilons. It is not divided by the total momentum, which may
   be zero. */
static double momentum_error(struct pair *p, const struct totals *a,
                             const struct totals *b)
{
    double change[COLLIDE_DIMENSIONS];
    for (size_t i = 0; i < p->dimensions; ++i)
        change[i] = (double)((b->momentum[i] - a->momentum[i]) / a->scale);
    return length(p->dimensions, change) / DBL_EPSILON;
}

/* Collides the pair. Returns the rounding errors of its energy and
   momentum. */
static struct errors collide_pair(struct pair *p)
{
    struct errors error = {0, 0};
    memcpy(p->after, p->before, sizeof p->after);
    const bool collided =
        p->dimensions == 1 && p->normal[0] == 1
            ? collide_by(given.form, p->after[0], p->after[1], p->im[0],
                         p->im[1], given.restitution)
            : collide_along_by(given.form, p->dimensions, p->normal,
                               p->after[0], p->after[1], p->im[0], p->im[1],
                               given.restitution);
    assert(collided); /* read_settings refuses all other input */
    (void)collided;
    const struct totals a = totals_of(p, p->before);
    const struct totals b = totals_of(p, p->after);
    const quad gain = b.energy - a.energy + expected_loss(p);
    if (a.energy_scale > 0)
        error.energy = (double)(gain / a.energy_scale) / DBL_EPSILON;
    if (a.scale > 0 && p->im[0] > 0 && p->im[1] > 0)
        error.momentum = momentum_error(p, &a, &b);
    return error;
}

static void print_vector(struct table *out, size_t n, const double v[])
{
    for (size_t i = 0; i < n; ++i)
        table_print(out, "%s%.6g", i ? "," : "", v[i]);
}

static void print_body(struct table *out, struct pair *p, int body)
{
    if (p->im[body] > 0)
        table_print(out, "  body %d, mass %.6g: velocity ", body + 1,
                    1 / p->im[body]);
    else
        table_print(out, "  body %d, a wall: velocity ", body + 1);
    print_vector(out, p->dimensions, p->before[body]);
    table_print(out, " -> ");
    print_vector(out, p->dimensions, p->after[body]);
    table_print(out, "\n");
}

/* Prints a collision. The percentages are computed with 113 bits from the
   rounded velocities, so they are seldom exactly zero. */
static void print_collision(struct table *out, struct pair *p)
{
    const struct totals a = totals_of(p, p->before);
    const struct totals b = totals_of(p, p->after);
    const bool wall = p->im[0] == 0 || p->im[1] == 0;
    print_body(out, p, 0);
    print_body(out, p, 1);
    for (size_t i = 0; i < p->dimensions; ++i) {
        const double change = (double)(b.momentum[i] - a.momentum[i]);
        table_print(out, "  momentum %.6g -> %.6g, ", (double)a.momentum[i],
                    (double)b.momentum[i]);
        if (wall)
            table_print(out, "the wall takes %.6g\n", -change);
        else
            table_print(out, "change %.2g %%\n",
                        a.scale > 0 ? 100 * (change / (double)a.scale) : 0);
    }
    const quad percent = a.energy > 0 ? 100 / a.energy : 0;
    table_print(out, "  energy %.6g -> %.6g%s, change %.2g %%",
                (double)a.energy, (double)b.energy,
                wall ? " seen from the wall" : "",
                (double)((b.energy - a.energy) * percent));
    if (given.restitution < 1)
        table_print(out, " (expected %.2g %%)",
                    -(double)(expected_loss(p) * percent));
    table_print(out, "\n");
}

/* Draws a pair of bodies. Without --mass-ratio each inverse mass is uniform
   from 0.1 to 1.1. With --mass-ratio R the logarithm of the mass ratio is
   uniform from log(1/R) to log R. The normal has a random direction and a
   length from 1/2 to 3/2, so a collision formula that forgets to divide by
   n.n is noticed. */
static void draw_pair(struct random *r, struct pair *p)
{
    p->dimensions = given.dimensions;
    p->im[0] = random_between(r, 0.1, 1.1);
    p->im[1] = random_between(r, 0.1, 1.1);
    if (given.mass_ratio > 0)
        p->im[1] = p->im[0] * random_log_uniform(r, 1 / given.mass_ratio,
                                                 given.mass_ratio);
    for (int body = 0; body < 2; ++body)
        for (size_t i = 0; i < p->dimensions; ++i)
            p->before[body][i] = random_between(r, -0.5, 0.5);
    p->normal[0] = 1;
    if (p->dimensions == 1)
        return;
    random_direction(r, p->dimensions, p->normal);
    const double length = random_between(r, 0.5, 1.5);
    for (size_t i = 0; i < p->dimensions; ++i)
        p->normal[i] *= length;
}

/* Collides random pairs and writes the largest and the root-mean-square
   error. The root mean square determines how the errors of many collisions
   accumulate. Returns false after an interruption. */
static bool run_tests(struct table *out, struct table *summary)
{
    struct errors worst = {0, 0}, rms = {0, 0};
    struct random r;
    struct progress progress;
    uint64_t done = 0;
    random_seed(&r, given.seed);
    progress_begin(&progress, PROGRAM, given.tests, "collisions");
    while (done < given.tests && !progress_signal()) {
        struct pair p = {0};
        draw_pair(&r, &p);
        const struct errors error = collide_pair(&p);
        if (given.tests <= SHOWN) {
            table_print(out, "collision %llu\n",
                        (unsigned long long)(done + 1));
            print_collision(out, &p);
        }
        worst.energy = fmax(worst.energy, fabs(error.energy));
        worst.momentum = fmax(worst.momentum, error.momentum);
        rms.energy += error.energy * error.energy;
        rms.momentum += error.momentum * error.momentum;
        if (++done % 1024 == 0)
            progress_update(&progress, done, done);
    }
    const bool complete = progress_end(&progress);
    if (done > 0) {
        rms.energy = sqrt(rms.energy / (double)done);
        rms.momentum = sqrt(rms.momentum / (double)done);
    }
    table_print(out,
                "%llu collisions, form %s; errors in machine epsilons:\n"
                "             worst      rms\n"
                "  momentum %7.2f  %7.3f\n  energy   %7.2f  %7.3f\n",
                (unsigned long long)done, collide_form_names[given.form],
                worst.momentum, rms.momentum, worst.energy, rms.energy);
    table_text(summary, "form", collide_form_names[given.form]);
    table_count(summary, "dimensions", given.dimensions);
    TABLE_RESULTS(summary, {"energy_error_max", worst.energy},
                  {"energy_error_rms", rms.energy},
                  {"momentum_error_max", worst.momentum},
                  {"momentum_error_rms", rms.momentum});
    return complete;
}

/* Collides the pair given on the command line. Prints a note if the bodies
   move apart along the normal. The formula gives a result (with e = 1 the
   state before their last collision), but probably not the intended one.

   Prints a warning if an error exceeds 16 machine epsilons, because
   rounding cannot explain it: the largest error in a million random
   collisions is 2.9 on a line and 7.7 in space. The limit is relative, so
   it does not depend on the units. An absolute limit, such as 1e-4, would
   miss errors of small bodies and warn of correct results for large
   bodies. */
static void run_by_hand(struct table *out, struct table *summary)
{
    struct pair p = {.dimensions = given.dimensions};
    double approach = 0;
    memcpy(p.im, given.inverse_masses, sizeof p.im);
    memcpy(p.normal, given.normal, sizeof p.normal);
    for (size_t i = 0; i < p.dimensions; ++i) {
        p.before[0][i] = given.velocities[i];
        p.before[1][i] = given.velocities[p.dimensions + i];
        approach += (p.before[0][i] - p.before[1][i]) * p.normal[i];
    }
    const struct errors error = collide_pair(&p);
    print_collision(out, &p);
    if (approach < 0)
        program_say("note: the bodies move apart along the normal: nothing "
                    "follows from this");
    if (fabs(error.energy) > 16 || error.momentum > 16)
        program_say("warning: energy off by %.3g and momentum by %.3g "
                    "machine epsilons",
                    error.energy, error.momentum);
    char key[] = "v1_x";
    for (int body = 0; body < 2; ++body)
        for (size_t i = 0; i < p.dimensions; ++i) {
            key[1] = (char)('1' + body);
            key[3] = "xyz"[i];
            table_real(summary, key, p.after[body][i]);
        }
    table_text(summary, "form", collide_form_names[given.form]);
    TABLE_RESULTS(summary, {"energy_error", error.energy},
                  {"momentum_error", error.momentum});
}

int main(int argc, char *argv[])
{
    read_settings(argc, argv);
    struct table *out, *summary;
    program_open(given.output, given.summary, keys, &out, &summary);
    bool complete = true;
    if (given.velocities_given)
        run_by_hand(out, summary);
    else
        complete = run_tests(out, summary);
    return program_close(out, summary, complete);
}
