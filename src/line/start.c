/* Fills in the starts of runs: fixed, random or thermal. */
#include "line/start.h"

#include "toolbox/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const start_names[START_KINDS + 1] = {
    "four",      "mixed", "cradle", "thermal",  "piston",
    "adiabatic", "two",   "random", "galperin", NULL};

/* All four arrays share a block of memory. */
bool start_create(struct start *s, size_t movers)
{
    *s = (struct start){.movers = movers};
    s->mass = calloc(4 * movers, sizeof *s->mass);
    if (!s->mass)
        return false;
    s->x = s->mass + movers;
    s->v = s->x + movers;
    s->radius = s->v + movers;
    for (size_t i = 0; i < movers; ++i)
        s->mass[i] = 1;
    return true;
}

void start_free(struct start *s)
{
    free(s->mass);
    *s = (struct start){0};
}

/* Fills x with n uniform random points between a and b, in order. No
   sorting is needed, since the n + 1 gaps between such points are
   distributed like exponential variates divided by their sum. (Before the
   division the gaps are independent, which is why the free space of a line
   behaves like an ideal gas.) */
static void throw_points(struct random *r, size_t n, double a, double b,
                         double x[])
{
    double sum = 0;
    for (size_t i = 0; i <= n; ++i) {
        sum -= random_log(1 - random_uniform(r));
        if (i < n)
            x[i] = sum;
    }
    for (size_t i = 0; i < n; ++i)
        x[i] = a + (b - a) * (x[i] / sum);
}

/* Draws velocities for movers i to i + n - 1 from normal distributions with
   variances proportional to 1/m. Scales them to a total kinetic energy of
   `energy`, J. */
static void warm(struct random *r, struct start *s, size_t i, size_t n,
                 double energy)
{
    double sum = 0;
    for (size_t k = i; k < i + n; ++k) {
        s->v[k] = random_normal(r) / sqrt(s->mass[k]);
        sum += s->mass[k] * s->v[k] * s->v[k] / 2;
    }
    for (size_t k = i; k < i + n; ++k)
        s->v[k] *= sqrt(energy / sum);
}

/* Fills in the four heavy bodies of MacKay's C++ program, or another number
   of bodies by the same rule. */
static void fill_four(struct start *s)
{
    s->wall[1] = (double)s->movers + 1;
    s->until = 50;
    for (size_t i = 0; i < s->movers; ++i) {
        s->x[i] = s->v[i] = (double)i + 1;
        s->mass[i] = 10 * s->x[i] + 1.23;
        s->radius[i] = 0.1;
    }
}

/* Fills in the first run of MacKay's Octave program. The masses are 9 kg
   and 1 kg. Some of them are changed by a tenth, since equal bodies would
   only exchange velocities. */
static void fill_mixed(struct start *s)
{
    static const double v[] = {2, 2.21, 2.621, 2, -0.2, -0.27, -0.37, -0.2};
    static const double im[] = {1.1, 1.0, 0.9, 1.0};
    s->wall[0] = 1;
    s->wall[1] = 10;
    s->until = 30;
    for (size_t i = 0; i < 8; ++i) {
        s->x[i] = (double)i + 2;
        s->mass[i] = (i < 4 ? 9 : 1) / im[i % 4];
        s->v[i] = v[i];
    }
}

/* Fills in the second run of MacKay's Octave program: two heavy bodies fly
   to the left wall, away from a row of six light bodies at rest. */
static void fill_cradle(struct start *s)
{
    s->wall[1] = 35;
    s->until = 100;
    for (size_t i = 0; i < 8; ++i)
        s->x[i] = (double)i + 14;
    s->mass[0] = 4.123;
    s->mass[1] = 9.0123;
    s->v[0] = s->v[1] = -2;
}

static void fill_two(struct start *s, double ratio)
{
    s->wall[1] = 3;
    s->until = 100;
    s->mass[1] = ratio > 0 ? ratio : 9;
    s->x[0] = 1;
    s->x[1] = 2;
    s->v[0] = 1;
    s->v[1] = -0.3;
}

/* Fills in Galperin's experiment. There is no right wall; the run ends
   after the last collision. */
static void fill_galperin(struct start *s, double ratio)
{
    s->wall[1] = INFINITY;
    s->until = INFINITY;
    s->mass[1] = ratio > 0 ? ratio : 100;
    s->x[0] = 1;
    s->x[1] = 2;
    s->v[1] = -1;
}

/* Fills in a gas with 1/2 J and 1 m per particle. In the left half the
   masses are within a tenth of 1 kg, in the right half within a tenth of 4
   kg. */
static void fill_thermal(struct start *s, struct random *r)
{
    const size_t n = s->movers;
    s->until = 100;
    for (size_t i = 0; i < n; ++i)
        s->mass[i] = (i < n / 2 ? 1 : 4) * random_between(r, 0.9, 1.1);
    throw_points(r, n, s->wall[0], s->wall[1], s->x);
    warm(r, s, 0, n, (double)n / 2);
}

/* Fills in a gas like that of fill_thermal, but with masses spread evenly
   from 1 kg to 9 kg, in random order. The inside-out shuffle of Fisher and
   Yates puts the i-th mass at a random index k <= i, and moves the mass at
   k to i. */
static void fill_random(struct start *s, struct random *r)
{
    const size_t n = s->movers;
    s->until = 100;
    for (size_t i = 0; i < n; ++i) {
        const size_t k = (size_t)random_below(r, i + 1);
        s->mass[i] = s->mass[k];
        s->mass[k] = n > 1 ? 1 + 8 * (double)i / (double)(n - 1) : 1;
    }
    throw_points(r, n, s->wall[0], s->wall[1], s->x);
    warm(r, s, 0, n, (double)n / 2);
}

/* Fills in a piston of 40 kg in the middle of 12 m, and other bodies with a
   total mass of 40/3 kg. If not `warmed`, all bodies move to the right at 1
   m/s. Their energy is 80/3 J, of which the piston has three quarters. If
   `warmed`, each gas has 10/3 J and the piston moves at 0.1 m/s. On the
   left of the piston the masses increase from a tenth below to a tenth
   above their mean. On the right they decrease over a smaller range, so the
   two gases have equal masses but are not mirror images. */
static void fill_piston(struct start *s, struct random *r, double ratio,
                        bool warmed)
{
    const size_t n = s->movers / 2; /* number of bodies on each side */
    const double middle = (s->wall[0] + s->wall[1]) / 2;
    s->until = 200;
    for (size_t i = 0; i < s->movers; ++i) {
        const double place =
            n > 1 ? 2 * (double)(i % (n + 1)) / (double)(n - 1) - 1 : 0;
        s->mass[i] = 20 / (3 * (double)n) *
                     (1 + (i < n ? 0.1 : 0.08) * (i > n ? -place : place));
        s->v[i] = 1;
    }
    s->mass[n] = ratio > 0 ? ratio * 20 / (3 * (double)n) : 40;
    s->x[n] = middle;
    throw_points(r, n, s->wall[0], middle, s->x);
    throw_points(r, n, middle, s->wall[1], s->x + n + 1);
    if (warmed) {
        warm(r, s, 0, n, 10.0 / 3);
        warm(r, s, n + 1, n, 10.0 / 3);
        s->v[n] = 0.1;
    }
}

/* The default, smallest and largest number of movers of each kind. Starts
   with a piston need an odd number, so that the piston is in the middle. */
static const struct {
    size_t usual, least, most;
    bool odd;
} kinds[START_KINDS] = {[START_FOUR] = {4, 1, 10000000, false},
                        [START_MIXED] = {8, 8, 8, false},
                        [START_CRADLE] = {8, 8, 8, false},
                        [START_THERMAL] = {10, 2, 10000000, false},
                        [START_PISTON] = {11, 3, 9999999, true},
                        [START_ADIABATIC] = {401, 3, 9999999, true},
                        [START_TWO] = {2, 2, 2, false},
                        [START_RANDOM] = {10, 1, 10000000, false},
                        [START_GALPERIN] = {2, 2, 2, false}};

bool start_allows(enum start_kind kind, size_t movers)
{
    return movers == 0 ||
           (movers >= kinds[kind].least && movers <= kinds[kind].most &&
            (!kinds[kind].odd || movers % 2 == 1));
}

/* Sets requested walls twice: first for the kinds that place random points
   between them, and again after filling in the start, for the kinds that
   set walls of their own. */
bool start_fill(struct start *s, const struct start_request *w)
{
    struct random r;
    if (!start_create(s, w->movers ? w->movers : kinds[w->kind].usual))
        return false;
    random_seed(&r, w->seed);
    s->wall[1] = kinds[w->kind].odd ? 12 : (double)s->movers + 1;
    if (w->walls)
        memcpy(s->wall, w->wall, sizeof s->wall);
    switch (w->kind) {
    case START_FOUR: fill_four(s); break;
    case START_MIXED: fill_mixed(s); break;
    case START_CRADLE: fill_cradle(s); break;
    case START_THERMAL: fill_thermal(s, &r); break;
    case START_PISTON: fill_piston(s, &r, w->ratio, false); break;
    case START_TWO: fill_two(s, w->ratio); break;
    case START_RANDOM: fill_random(s, &r); break;
    case START_GALPERIN: fill_galperin(s, w->ratio); break;
    default: fill_piston(s, &r, w->ratio, true);
    }
    if (w->walls)
        memcpy(s->wall, w->wall, sizeof s->wall);
    return true;
}
