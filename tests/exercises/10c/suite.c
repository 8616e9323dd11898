/* The suite of exercise 10c, "The frequencies of a membrane". */

#include "examiner/check.h"
#include <stdlib.h>
#include "call.h"

static const double pi = 3.14159265358979323846;

static size_t modes(const struct grid *g)
{
    return (size_t)(g->nx - 2) * (size_t)(g->ny - 2);
}

/* What the student's function answers; untouched places read as NaN, and
   one more place follows them. */
struct answer {
    double *omega, step;
};

static struct answer answer(const struct grid *g)
{
    check_about(check_text("%d by %d masses of %g kg, D = %g N/m, dx = %g "
                           "m, dy = %g m, rest lengths %g m and %g m",
                           g->nx, g->ny, g->mass, g->stiffness, g->dx,
                           g->dy, g->restx, g->resty));
    const struct grid copy = *g;
    struct answer a = {malloc((modes(g) + 1) * sizeof(double)), NAN};
    if (!a.omega)
        abort();
    for (size_t i = 0; i <= modes(g); ++i)
        a.omega[i] = CHECK_EMPTY;
    a.step = membrane_modes(&copy, a.omega);
    return a;
}

/* ---- another way: the energy. Bent into a wave, a row of springs has the
   energy k/2 times the sum of the squares of its steps, and the masses, if
   they swing through with the frequency w, have w^2 m/2 times the sum of
   the squares of their heights. Both are the same in a mode. ---- */

static double steps_over_heights(int waves, int masses)
{
    long double steps = 0.0L, heights = 0.0L, before = 0.0L;
    for (int i = 1; i < masses; ++i) {
        const long double turn = (long double)waves * i / (masses - 1);
        const long double z =
            i == masses - 1 ? 0.0L : sinl(3.14159265358979323846L * turn);
        steps += (z - before) * (z - before);
        heights += z * z;
        before = z;
    }
    return (double)(steps / heights);
}

/* How stiff a spring is across its own direction, in N/m. */
static double across(double stiffness, double length, double rest)
{
    return stiffness * (length - rest) / length;
}

/* The square of a frequency, and how large its parts are. */
struct square {
    double along_x, along_y;
};

static struct square square_of(const struct grid *g, int r, int s)
{
    const double x = across(g->stiffness, g->dx, g->restx);
    const double y = across(g->stiffness, g->dy, g->resty);
    return (struct square){x / g->mass * steps_over_heights(r, g->nx),
                           y / g->mass * steps_over_heights(s, g->ny)};
}

static double with_sign(double square)
{
    return square < 0.0 ? -sqrt(-square) : sqrt(square);
}

static double frequency(const struct grid *g, int r, int s)
{
    const struct square q = square_of(g, r, s);
    return with_sign(q.along_x + q.along_y);
}

/* limit: 1e-12 */
/* The square may be off by 1e-12 of its parts; the root by that over the
   sum of both roots, which is one of them at least. */
static double tolerance(const struct grid *g, int r, int s)
{
    const struct square q = square_of(g, r, s);
    const double off = 1e-12 * (fabs(q.along_x) + fabs(q.along_y));
    const double root = sqrt(fabs(q.along_x + q.along_y));
    return off / fmax(root, sqrt(off) + DBL_MIN);
}

static const char because[] =
    "1e-12 of the parts of the square, over the frequency";

/* ---- the slips ---- */

/* Both axes with other angles and stiffnesses. */
static double slipped(const struct grid *g, double kx, double ax, double ky,
                      double ay)
{
    const double x = 2.0 * sin(ax), y = 2.0 * sin(ay);
    return with_sign(kx / g->mass * x * x + ky / g->mass * y * y);
}

static void check_digits(int r, int s, double off)
{
    CHECK_NEAR(
        off,
        .quantity = check_text(
            "relative error of the frequency of mode (%d, %d)", r, s),
        .tolerance = 1e-12, .because = "what was asked for",
        .mistakes = {{"digits-lost", off,
                      "The formula is right and its last digits are gone. "
                      "What is left of 1 - cos(x) for a small x, and which "
                      "square is the same on paper?"}});
}

static void check_mode(const struct grid *g, const double omega[], int r,
                       int s)
{
    const double got =
        omega[(size_t)(s - 1) * (size_t)(g->nx - 2) + (size_t)(r - 1)];
    const double right = frequency(g, r, s), allowed = tolerance(g, r, s);
    const double kx = across(g->stiffness, g->dx, g->restx);
    const double ky = across(g->stiffness, g->dy, g->resty);
    const double x = 0.5 * pi * r, y = 0.5 * pi * s;
    const int nx = g->nx, ny = g->ny;
    const double D = g->stiffness;
    const double smooth = with_sign((kx * pow(2.0 * x / (nx - 1), 2) +
                                     ky * pow(2.0 * y / (ny - 1), 2)) /
                                    g->mass);
    const double waves = slipped(g, kx, x / nx, ky, y / ny);
    const bool counted = fabs(got - waves) <= allowed;
    /* which (r, s) stands here when the axes are exchanged */
    const int place = (s - 1) * (nx - 2) + r - 1;
    const double exchanged =
        frequency(g, place / (ny - 2) + 1, place % (ny - 2) + 1);
    const double off = got / right - 1.0;
    if (fabs(got - right) > allowed && fabs(off) < 1e-6 &&
        fabs(got - smooth) > 1e-9 * fabs(right)) {
        check_digits(r, s, off);
        return;
    }
    CHECK_NEAR(
        got, .quantity = check_text("omega of mode (%d, %d)", r, s),
        .unit = "rad/s", .expected = right, .tolerance = allowed,
        .because = because,
        .mistakes = {
            {"root-of-a-negative", right < 0.0 ? CHECK_NAN : right,
             "Not a number. Here the springs push outwards. What does the "
             "mode do when the square of its frequency is negative?"},
            {"masses-for-springs",
             counted ? waves
                     : slipped(g, kx, x / (nx - 2), ky, y / (ny - 2)),
             "These waves do not end at the fixed masses. Draw three "
             "masses in a row, the outer two fixed: how many springs are "
             "there?"},
            {"half-angle-forgotten",
             slipped(g, kx, 2.0 * x / (nx - 1), ky, 2.0 * y / (ny - 1)),
             "The angle from one mass to the next is right. In the square "
             "of a sine it stands halved: where does that come from?"},
            {"tension-forgotten",
             slipped(g, D, x / (nx - 1), D, y / (ny - 1)),
             "This is how stiff the springs are along their own direction. "
             "The masses move across it: which force pulls them back when "
             "a spring only turns?"},
            {"tension-for-stiffness",
             slipped(g, kx * g->dx, x / (nx - 1), ky * g->dy, y / (ny - 1)),
             "The tension is a force, in N, and a stiffness is wanted, in "
             "N/m. By which length does it turn?"},
            {"root-forgotten", right * fabs(right),
             "This is the square of the frequency, with its sign."},
            {"hertz", 0.5 * right / pi,
             "This counts whole swings in a second. Which unit was asked "
             "for?"},
            fabs(got - smooth) <= 1e-9 * fabs(smooth)
                ? (struct check_mistake){"smooth-skin", smooth,
                                         "This is the frequency of a "
                                         "smooth skin. A grid is not "
                                         "smooth: what does the sum over "
                                         "both neighbours make of a wave?"}
            : right < 0.0
                ? (struct check_mistake){"growth-for-swing", -right,
                                         "This mode does not swing, it "
                                         "grows. Which sign does the "
                                         "exercise ask for?"}
                : (struct check_mistake){
                      "axes-exchanged", exchanged,
                      "This is the frequency of another mode. Which number "
                      "counts first in omega[], and how many modes are "
                      "there along x?"}});
}

/* All modes, or only every `stride`th of them. */
static void check_modes(const struct grid *g, int stride)
{
    const struct answer a = answer(g);
    for (int s = 1; s < g->ny - 1; ++s)
        for (int r = 1; r < g->nx - 1; r += stride)
            check_mode(g, a.omega, r, s);
    free(a.omega);
}

/* ---- the time step ---- */

/* The highest and the lowest frequency of those that swing, or 0. */
static void limits(const struct grid *g, double *highest, double *lowest)
{
    *highest = 0.0;
    *lowest = INFINITY;
    for (int s = 1; s < g->ny - 1; ++s)
        for (int r = 1; r < g->nx - 1; ++r) {
            const double w = frequency(g, r, s);
            *highest = fmax(*highest, w);
            if (w > 0.0)
                *lowest = fmin(*lowest, w);
        }
}

static void check_step(const struct grid *g)
{
    const struct answer a = answer(g);
    double highest, lowest;
    limits(g, &highest, &lowest);
    free(a.omega);
    const double right = 2.0 / highest;
    const double corner = frequency(g, g->nx - 2, g->ny - 2);
    CHECK_NEAR(
        a.step, .quantity = "largest time step of leapfrog", .unit = "s",
        .expected = right, .tolerance = highest > 0.0 ? 1e-11 * right : 0.0,
        .because = "some times what is allowed for the highest frequency",
        .mistakes = {
            {"corner-for-the-highest",
             corner <= 0.0 ? (right > 1e300 ? NAN : INFINITY)
                           : 2.0 / corner,
             "This belongs to the mode with the most waves along x and y. "
             "Where the springs push, do more waves make it faster?"},
            {"lowest-for-the-highest",
             lowest < INFINITY ? 2.0 / lowest : NAN,
             "This belongs to the slowest mode. Which of them is the first "
             "to blow up when the step gets longer?"},
            {"half-the-step", 1.0 / highest,
             "Half of it. At which product of step and frequency does "
             "leapfrog blow up?"},
            {"period-for-the-step", 2.0 * pi / highest,
             "This is a whole swing of the fastest mode. How many steps at "
             "least does leapfrog need for it?"}});
}

/* ---- the tests ---- */

/* Along a row of three the squares are 2 - sqrt 2, 2 and 2 + sqrt 2. */
static void test_row(void)
{
    check_ask("Three masses in a row move as one, two against each other, "
              "or the middle one against both. What is the force on each?");
    const struct grid row = {5, 3, 1.0, 6.0, 0.2, 1.0, 0.1, 1.0};
    const struct grid column = {3, 5, 1.0, 6.0, 2.0, 0.2, 1.0, 0.1};
    check_modes(&row, 1);
    check_modes(&column, 1);
}

/* One mass between four springs: each pulls it back with T z/d. */
static void test_one_mass(void)
{
    check_ask("One mass, four springs: by how much does each of them pull "
              "it back, and what is the force on it?");
    const struct grid square = {3, 3, 2.0, 16.0, 1.0, 1.0, 0.75, 0.75};
    const struct grid oblong = {3, 3, 0.5, 10.0, 0.5, 2.0, 0.3, 1.5};
    check_modes(&square, 1);
    check_modes(&oblong, 1);
}

static void test_oblong(void)
{
    check_ask("More masses along x than along y: which mode stands where?");
    const struct grid wide = {9, 5, 1.5, 50.0, 0.3, 0.2, 0.2, 0.15};
    const struct grid high = {4, 7, 0.2, 20.0, 0.4, 0.5, 0.1, 0.4};
    check_modes(&wide, 1);
    check_modes(&high, 1);
}

/* Without length at rest, at half of it, and with no tension along y. */
CHECK_TIMES(3, test_tension, i)
{
    static const double rest[][2] = {
        {0.0, 0.0}, {0.5, 0.25}, {0.125, 0.75}};
    check_ask("How far is each spring stretched while the grid lies flat?");
    const struct grid g = {6,   6,    1.0,        8.0,
                           1.0, 0.75, rest[i][0], rest[i][1]};
    check_modes(&g, 1);
}

/* With springs at rest nothing pulls back. */
static void test_slack(void)
{
    const struct grid g = {5, 4, 1.0, 50.0, 0.25, 0.5, 0.25, 0.5};
    check_ask("No spring pulls while the grid lies flat. What is left for "
              "small motions?");
    check_modes(&g, 1);
}

static void test_pressed(void)
{
    check_ask("Springs that are pressed push a mass out of the plane. "
              "Which of the modes grow?");
    const struct grid along_x = {7, 5, 1.0, 10.0, 1.0, 1.0, 1.25, 0.5};
    const struct grid along_y = {4, 8, 2.0, 10.0, 0.5, 1.0, 0.25, 1.125};
    const struct grid both = {4, 4, 1.0, 10.0, 1.0, 1.0, 1.5, 1.25};
    check_modes(&along_x, 1);
    check_modes(&along_y, 1);
    check_modes(&both, 1);
}

/* In a long row with no pull along y: the angle x = pi r/(nx - 1) from one
   mass to the next is small, and 4 sin^2(x/2) is x^2 - x^4/12 + x^6/360. */
CHECK_TIMES(3, test_long, i)
{
    static const int lengths[] = {1001, 20002, 100001};
    check_ask("A long row has slow modes. What is near 1 in your formula, "
              "and need it be?");
    const struct grid g = {lengths[i], 3, 1.0, 32.0, 0.5, 1.0, 0.25, 1.0};
    const struct answer a = answer(&g);
    for (int r = 1; r <= 10; r += 3) {
        const double x = pi * r / (g.nx - 1), xx = x * x;
        const double right =
            4.0 * sqrt(xx * (1.0 - xx / 12.0 * (1.0 - xx / 30.0)));
        const double got = a.omega[r - 1], off = got / right - 1.0;
        if (fabs(off) < 1e-4)
            check_digits(r, 1, off);
        else
            CHECK_NEAR(
                got, .quantity = check_text("omega of mode (%d, 1)", r),
                .unit = "rad/s", .expected = right,
                .tolerance = 1e-12 * right, .because = "what was asked for",
                .question =
                    "A long row of masses: how long is the slowest wave?");
    }
    free(a.omega);
}

static void test_step(void)
{
    check_ask("Which of the modes is the fastest, and how long may a step "
              "of leapfrog be for it?");
    const struct grid one = {3, 3, 2.0, 16.0, 1.0, 1.0, 0.75, 0.75};
    const struct grid many = {8, 6, 1.0, 50.0, 0.25, 0.5, 0.2, 0.3};
    const struct grid pushed = {7, 5, 1.0, 10.0, 1.0, 1.0, 1.25, 0.5};
    const struct grid grows = {4, 4, 1.0, 10.0, 1.0, 1.0, 1.5, 1.25};
    const struct grid slack = {5, 4, 1.0, 50.0, 0.25, 0.5, 0.25, 0.5};
    const struct grid soft = {4, 5, 9.0, 0.125, 1.0, 1.0, 0.5, 0.25};
    check_step(&one);
    check_step(&many);
    check_step(&pushed);
    check_step(&grows);
    check_step(&soft);
    check_ask("Nothing swings. Which step is too long?");
    check_step(&slack);
}

/* The place behind the last mode is somebody else's. */
static void test_places(void)
{
    const struct grid g = {6, 4, 1.0, 8.0, 1.0, 1.0, 0.5, 0.25};
    const struct answer a = answer(&g);
    const double last = a.omega[modes(&g) - 1];
    const double behind = isnan(a.omega[modes(&g)]) ? 0.0 : 1.0;
    free(a.omega);
    CHECK_NEAR(last, .quantity = "omega of mode (4, 2), the last one",
               .unit = "rad/s", .expected = frequency(&g, 4, 2),
               .tolerance = tolerance(&g, 4, 2), .because = because,
               .question = "How many modes has a grid, and where does the "
                           "last of them belong?");
    CHECK_NEAR(
        behind,
        .quantity =
            "is anything written behind the last place? (1 yes, 0 no)",
        .because = "yes or no",
        .question =
            "The masses at the edge are fixed. How many are left to move?");
}

/* Any grid; each axis stretched or pressed by 5 percent at least, so that
   no tension is a small difference. */
static struct grid draw_grid(bool x_pressed, bool y_pressed)
{
    struct grid g = {check_draw_whole(3, 12), check_draw_whole(3, 9),
                     check_draw(0.1, 5.0),    check_draw(1.0, 90.0),
                     check_draw(0.1, 2.0),    check_draw(0.1, 2.0),
                     check_draw(0.0, 0.94),   check_draw(0.0, 0.94)};
    g.restx = g.dx * (x_pressed ? 2.0 - g.restx : g.restx);
    g.resty = g.dy * (y_pressed ? 2.0 - g.resty : g.resty);
    return g;
}

CHECK_TIMES(12, test_drawn, i)
{
    check_ask("Any grid that is stretched: is every mode right?");
    const struct grid g = draw_grid(false, false);
    check_modes(&g, 1);
}

CHECK_TIMES(12, test_drawn_pressed, i)
{
    check_ask(
        "A grid that is pressed along x, y or both: is every mode right?");
    const struct grid g = draw_grid(i % 3 != 1, i % 3 != 0);
    check_modes(&g, 1);
}

CHECK_TIMES(12, test_drawn_step, i)
{
    check_ask("Which of these modes is the fastest?");
    const struct grid g = draw_grid(i % 4 == 1, i % 4 == 2);
    check_step(&g);
}

const struct check_suite check_suite = {
    .file = "10c-membrane.c",
    .title = "The frequencies of a membrane",
    .minutes = 30,
    .equation = "eq:membrane-dispersion",
    .tests = {{"three in a row have three modes", test_row, 2, 0},
              {"one mass hangs between four springs", test_one_mass, 1, 0},
              {"every mode stands in its place", test_oblong, 1, 0},
              {"the tension makes the stiffness", test_tension, 1, 0},
              {"springs at rest let go", test_slack, 1, 0},
              {"pressed springs make modes grow", test_pressed, 2, 0},
              {"a long row keeps its digits", test_long, 1, 0},
              {"the fastest mode that swings limits the step", test_step, 2,
               0},
              {"no place but those of the modes is filled", test_places, 1,
               0},
              {"any grid", test_drawn, 2, 2},
              {"any grid that is pressed", test_drawn_pressed, 1, 1},
              {"the step of any grid", test_drawn_step, 1, 1},
              {0}},
};
