/* The hidden tests of exercise 04a, "Springs of air". */

#include "examiner/check.h"
#include "call.h"

struct box {
    int f;
    double length, mass, gas, left, right, x, v;
};

static struct box draw_box(void)
{
    struct box b = {check_draw_whole(1, 6), check_draw(2.0, 40.0),
                    check_draw(1.0, 50.0),  check_draw(0.0, 30.0),
                    check_draw(0.5, 9.0),   check_draw(0.5, 9.0),
                    check_draw(0.2, 0.8),   check_draw(-2.0, 2.0)};
    b.x *= b.length;
    return b;
}

static const char *input(const struct box *b)
{
    return check_text(
        "f = %d, length = %g m, mass = %g kg, gas = %g kg, energy = {%g, "
        "%g} J in the middle; state = {%g m, %g m/s}",
        b->f, b->length, b->mass, b->gas, b->left, b->right, b->x, b->v);
}

struct slopes {
    double x, v;
};

static struct slopes answer(const struct box *b)
{
    const double energy[2] = {b->left, b->right}, state[2] = {b->x, b->v};
    double slope[2] = {NAN, NAN};
    piston_slopes(b->f, b->length, b->mass, b->gas, energy, state, slope);
    return (struct slopes){slope[0], slope[1]};
}

/* The energies have grown by less than 2.5^2 = 6.25 on a line where a gas
   is a fifth of the box, and push over as much of it. */
static double tolerance(const struct box *b)
{
    return 16.0 * DBL_EPSILON * 2.0 * 6.25 * 25.0 * (b->left + b->right) /
           (b->f * b->length * b->mass);
}

static void check_same(const char *quantity, const struct box *b,
                       double got, double expected)
{
    CHECK_NEAR(
        got, .quantity = quantity, .input = input(b), .expected = expected,
        .tolerance = tolerance(b) + 4.0 * DBL_EPSILON * fabs(expected),
        .because =
            "16 epsilons of what the gases push at most, times how much "
            "shorter a gas is than the box, and 4 of the slope");
}

/* In the middle the energies are those given, and no power is needed. */
static void check_middle(struct box b)
{
    b.x = 0.5 * b.length;
    check_same("slope[1] in the middle", &b, answer(&b).v,
               12.0 * (b.left - b.right) /
                   (b.f * b.length * (3.0 * b.mass + b.gas)));
}

CHECK_TIMES(30, test_mirror, i)
{
    const struct box b = draw_box();
    check_middle(b);
    const struct box mirror = {b.f,     b.length, b.mass,         b.gas,
                               b.right, b.left,   b.length - b.x, -b.v};
    const struct box small = {b.f,         b.length * 1e3, b.mass * 1e6,
                              b.gas * 1e6, b.left * 1e12,  b.right * 1e12,
                              b.x * 1e3,   b.v * 1e3};
    const struct slopes a = answer(&b), m = answer(&mirror),
                        s = answer(&small);
    check_same("slope[1] of the box in a mirror", &b, m.v, -a.v);
    check_same("slope[1] in m/s^2, when all is given in mm, mg and s", &b,
               s.v * 1e-3, a.v);
    check_same("slope[0] in m/s, when all is given in mm, mg and s", &b,
               s.x * 1e-3, b.v);
}

/* Stored in the gases, and moving: of the gas one third counts. */
static double energy(const struct box *b)
{
    const double half = 0.5 * b->length, power = 2.0 / b->f;
    return b->left * pow(half / b->x, power) +
           b->right * pow(half / (b->length - b->x), power) +
           (0.5 * b->mass + b->gas / 6.0) * b->v * b->v;
}

/* One step of Heun's method of third order. */
static void step(struct box *b, double dt)
{
    struct box there = *b;
    const struct slopes first = answer(&there);
    there.x = b->x + dt / 3.0 * first.x;
    there.v = b->v + dt / 3.0 * first.v;
    const struct slopes second = answer(&there);
    there.x = b->x + 2.0 * dt / 3.0 * second.x;
    there.v = b->v + 2.0 * dt / 3.0 * second.v;
    const struct slopes third = answer(&there);
    b->x += dt * (0.25 * first.x + 0.75 * third.x);
    b->v += dt * (0.25 * first.v + 0.75 * third.v);
}

/* Let go at rest, a third from a wall or nearer the middle, for a time in
   which the piston crosses the box a few times at most. */
CHECK_TIMES(4, test_swing, i)
{
    struct box b = draw_box();
    b.x = b.length * check_draw(0.35, 0.65);
    b.v = 0.0;
    b.right = b.left * check_draw(0.8, 1.25);
    const struct box start = b;
    const double whole = energy(&b);
    const double fast = sqrt((b.left + b.right) / (b.mass + b.gas / 3));
    for (int k = 0; k < 500; ++k)
        step(&b, 0.004 * b.length / fast);
    CHECK_NEAR(energy(&b) / whole,
               .quantity = "energy of piston and gases after a swing with "
                           "your slopes, in units of that before",
               .input = input(&start), .expected = 1.0, .tolerance = 1e-5,
               .because = "the method alone errs by less than 5e-6",
               .equation = "eq:piston-energy");
}

const struct check_test check_hidden[] = {
    {"mirror and units change nothing", test_mirror, 2, 0},
    {"swings in all kinds of boxes conserve the energy", test_swing, 2, 0},
    {0}};
