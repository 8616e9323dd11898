/* The suite of exercise 04a, "Springs of air". */

#include "examiner/check.h"
#include "call.h"

struct box {
    int f;
    double length, mass, gas;
    double energy[2];
};

/* Where the piston is and how fast it moves. */
struct state {
    double x, v;
};

/* What the student's function answers; untouched places read as NaN. */
static struct state answer(const struct box *b, struct state s)
{
    const double state[2] = {s.x, s.v};
    double slope[2] = {CHECK_EMPTY, CHECK_EMPTY};
    piston_slopes(b->f, b->length, b->mass, b->gas, b->energy, state,
                  slope);
    return (struct state){slope[0], slope[1]};
}

static const char *input(const struct box *b, struct state s)
{
    return check_text(
        "f = %d, length = %g m, mass = %g kg, gas = %g kg, energy = {%g, "
        "%g} J in the middle; state = {%.10g m, %g m/s}",
        b->f, b->length, b->mass, b->gas, b->energy[0], b->energy[1], s.x,
        s.v);
}

/* The energy of gas 0 or 1 at the length l, if it goes with a power of
   1/l; 2/f is right. */
static double kinetic(const struct box *b, int i, double l, double power)
{
    return b->energy[i] * pow(0.5 * b->length / l, power);
}

static double push(const struct box *b, int i, double l)
{
    return 2.0 / b->f * kinetic(b, i, l, 2.0 / b->f) / l;
}

static double inertia(const struct box *b)
{
    return b->mass + b->gas / 3.0;
}

static double acceleration(const struct box *b, double x)
{
    return (push(b, 0, x) - push(b, 1, b->length - x)) / inertia(b);
}

/* A handful of roundings of either push; a length that is a difference
   errs by an epsilon of the box, and its cube by three of them. */
static double tolerance(const struct box *b, double x)
{
    const double pushes = push(b, 0, x) + push(b, 1, b->length - x);
    const double shorter = fmin(x, b->length - x);
    return 16.0 * DBL_EPSILON * pushes * b->length / shorter / inertia(b);
}

static const char because[] = "16 epsilons of the pushes, times how much "
                              "shorter a gas is than the box";

static const char dv_dt[] = "slope[1], dv/dt";

static const char empty[] =
    "Not a number: was something put into both places of slope?";

/* The first slope is the velocity itself, copied. */
static void check_velocity(const struct box *b, struct state s)
{
    static const char question[] = "How fast does the position change of "
                                   "something with the velocity v?";
    CHECK_NEAR(answer(b, s).x, .quantity = "slope[0], dx/dt", .unit = "m/s",
               .input = input(b, s), .expected = s.v,
               .because = "it is given", .question = question,
               .mistakes = {
                   {"position-for-velocity", s.x, question},
                   {"slopes-exchanged", acceleration(b, s.x),
                    "This is the acceleration. Which of the two slopes "
                    "belongs to the position, and which to the velocity?"},
                   {"left-empty", CHECK_EMPTY, empty}});
}

static void test_velocity(void)
{
    const struct box b = {1, 12.0, 40.0, 0.0, {3.0, 5.0}};
    check_velocity(&b, (struct state){5.0, 0.75});
    check_velocity(&b, (struct state){8.0, -1.25});
    check_velocity(&b, (struct state){8.0, 0.0});
}

/* limit: 1 (direction)
   No gas on either side, and a piston at rest. */
static void check_empty(void)
{
    static const char question[] =
        "There is no gas at all, or none that moves. What pushes the "
        "piston, and what would 0/0 be?";
    for (int f = 1; f <= 3; ++f)
        for (int i = 0; i < 3; ++i) {
            const struct box b = {f, 12.0, 40.0, i == 2 ? 6.0 : 0.0, {0}};
            const struct state s = {i ? 6.0 : 2.0, i == 1 ? 0.0 : 0.75};
            check_velocity(&b, s);
            CHECK_NEAR(
                answer(&b, s).v, .quantity = dv_dt, .unit = "m/s^2",
                .input = input(&b, s), .because = "nothing pushes",
                .question = question,
                .mistakes = {{"nothing-divided", CHECK_NAN, question}});
        }
}

static void test_middle(void)
{
    static const char both[] = "Both gases push to the right here. On "
                               "which side of the piston is the right one?";
    const struct box b = {1, 12.0, 40.0, 0.0, {3.0, 3.0}};
    const struct state s = {6.0, 0.5};
    const double one = push(&b, 0, 6.0);
    CHECK_NEAR(
        answer(&b, s).v, .quantity = dv_dt, .unit = "m/s^2",
        .input = input(&b, s), .tolerance = tolerance(&b, s.x),
        .because = because,
        .question =
            "The two gases are alike. Why should the piston be moved?",
        .mistakes = {{"both-push-right", 2.0 * one / b.mass, both},
                     {"both-push-right", one / b.mass, both},
                     {"both-push-right", 2.0 * one, both},
                     {"left-empty", CHECK_EMPTY, empty}});
    check_empty();
}

static const char for_pressure[] =
    "This exponent belongs to the pressure. The force divides by the "
    "length once more: which exponent is left for the energy?";

/* The left gas alone, on a line. */
static void check_line(const struct box *b, double x, double expected)
{
    const struct state s = {x, 0.0};
    const double room =
        2.0 / 3.0 * kinetic(b, 0, x, 2.0 / 3.0) / x / b->mass;
    CHECK_NEAR(
        answer(b, s).v, .quantity = dv_dt, .unit = "m/s^2",
        .input = input(b, s), .expected = expected,
        .tolerance = tolerance(b, x), .because = because,
        .equation = "eq:adiabat",
        .question =
            "There is gas on the left only, on a line. How long was it, "
            "how long is it, and what does that make of its energy?",
        .mistakes = {
            {"energy-kept", 2.0 * b->energy[0] / x / b->mass,
             "This takes the energy as it was given, as if a bath kept the "
             "gas warm. For which length was it given, and who pays for "
             "the work done until now?"},
            {"gas-of-three-dimensions", room,
             "This is a gas in three directions. How many are there here, "
             "and how does your exponent know?"},
            {"gamma-for-the-energy",
             2.0 * kinetic(b, 0, x, 3.0) / x / b->mass, for_pressure},
            {"half-the-force", 0.5 * expected,
             "Half of it. Each particle that bounces off turns its "
             "momentum round: from mv to what? And K is half of m v^2."},
            {"pushed-the-wrong-way", -expected,
             "The gas on the left sucks the piston in. Which way does it "
             "push?"},
            {"squeeze-upside-down",
             2.0 * kinetic(b, 0, x, -2.0) / x / b->mass,
             "The gas loses energy here when it is squeezed. Which of the "
             "two lengths stands above the line?"},
            {"not-squared", 2.0 * kinetic(b, 0, x, 1.0) / x / b->mass,
             "Here K l stays the same. What does a particle's SPEED do "
             "when the length is halved, and what its energy?"},
            {"mass-forgotten", expected * b->mass,
             "This is the force. What is asked for is the rate at which "
             "the velocity changes. Which unit has that?"}});
}

static void test_line(void)
{
    const struct box b = {1, 12.0, 40.0, 0.0, {4.0, 0.0}};
    check_line(&b, 2.0, 36.0 * 2.0 / 2.0 / 40.0);
    check_line(&b, 9.0, 16.0 / 9.0 * 2.0 / 9.0 / 40.0);
}

/* The left gas alone, in more directions. */
static void check_room(const struct box *b, double x, double expected)
{
    const struct state s = {x, 0.0};
    const double f = b->f, once = 1.0 / (x * b->mass);
    CHECK_NEAR(
        answer(b, s).v, .quantity = dv_dt, .unit = "m/s^2",
        .input = input(b, s), .expected = expected,
        .tolerance = tolerance(b, x), .because = because,
        .equation = "eq:adiabat",
        .question = "The gas moves in f directions. What stays the same "
                    "when it is squeezed?",
        .mistakes = {
            {"gas-on-a-line", 2.0 * kinetic(b, 0, x, 2.0) * once,
             "This is the gas of the book, on a line. Here only a part of "
             "the energy is along the box. Which equations feel that?"},
            {"energy-kept", 2.0 / f * b->energy[0] * once,
             "This takes the energy as it was given. Is your exponent "
             "zero? What is 2/3 in C when both are whole numbers?"},
            {"all-energy-along-the-box",
             2.0 * kinetic(b, 0, x, 2.0 / f) * once,
             "All the energy pushes the piston here. How much of it is "
             "along the box?"},
            {"adiabat-of-a-line", 2.0 / f * kinetic(b, 0, x, 2.0) * once,
             "The force is right for the energy, and the energy is that of "
             "a gas on a line. Less force does less work: how fast does K "
             "grow now?"},
            {"gamma-for-the-energy",
             2.0 / f * kinetic(b, 0, x, 2.0 / f + 1.0) * once,
             for_pressure},
            {"whole-number-division", 0.0,
             "No force at all. What is 2/3 in C when both are whole "
             "numbers?"}});
}

/* In three directions 0.75 m are an eighth of 6 m, and the energy is four
   times as large; in two directions the energy goes with 1/l. */
static void test_room(void)
{
    const struct box three = {3, 12.0, 40.0, 0.0, {4.0, 0.0}};
    const struct box two = {2, 12.0, 40.0, 0.0, {4.0, 0.0}};
    check_room(&three, 0.75, 16.0 * 2.0 / 3.0 / 0.75 / 40.0);
    check_room(&two, 2.0, 12.0 / 2.0 / 40.0);
    check_room(&two, 8.0, 3.0 / 8.0 / 40.0);
}

static void check_two(const struct box *b, double x)
{
    const struct state s = {x, -0.5};
    const double left = push(b, 0, x), right = push(b, 1, b->length - x);
    CHECK_NEAR(
        answer(b, s).v, .quantity = dv_dt, .unit = "m/s^2",
        .input = input(b, s), .expected = acceleration(b, x),
        .tolerance = tolerance(b, x), .because = because,
        .mistakes = {{"left-length-for-both",
                      (left - push(b, 1, x)) / inertia(b),
                      "The right gas has the length of the left one here. "
                      "How long is it when the piston is at x?"},
                     {"both-push-right", (left + right) / inertia(b),
                      "Both gases push to the right here. On which side of "
                      "the piston is the right one?"}});
}

static void test_right(void)
{
    const struct box alone = {1, 12.0, 40.0, 0.0, {0.0, 4.0}};
    const struct box both = {5, 10.0, 25.0, 0.0, {3.0, 7.0}};
    check_ask("How long is the right gas, and which way does it push?");
    check_two(&alone, 9.0);
    check_two(&alone, 3.0);
    check_two(&both, 4.0);
    check_two(&both, 7.5);
}

static double stored(const struct box *b, double x)
{
    const double power = 2.0 / b->f;
    return kinetic(b, 0, x, power) + kinetic(b, 1, b->length - x, power);
}

/* A difference quotient errs by its step squared, times a sixth of the
   third derivative of the energy, which for K at a length l is at most
   24 K / l^3; and by the roundings of the energy, divided by the step. */
static void check_stored(const struct box *b, double x)
{
    const double h = 1e-4, l = fmin(x, b->length - x), u = stored(b, x);
    const struct state s = {x, 0.0};
    CHECK_NEAR(
        b->mass * answer(b, s).v,
        .quantity = "mass times slope[1], the force", .unit = "N",
        .input = input(b, s),
        .expected = (stored(b, x - h) - stored(b, x + h)) / (2.0 * h),
        .tolerance =
            4.0 * h * h * u / (l * l * l) + 16.0 * DBL_EPSILON * u / h,
        .because = "that of a difference quotient",
        .equation = "eq:piston-energy",
        .question =
            "The work done on the piston comes from the energy of the gas. "
            "Is your force the slope of that energy, downhill?");
}

static void test_stored(void)
{
    for (int f = 1; f <= 6; ++f)
        for (double x = 2.5; x < 8.0; x += 2.5) {
            const struct box b = {f, 10.0, 25.0, 0.0, {3.0, 7.0}};
            check_stored(&b, x);
        }
}

/* One part in a million of the half length: then what bends the force is
   below the roundings, which the small difference of two pushes makes a
   million times as large. */
static void check_swing(int f, double twelve)
{
    const double h = 6.0, k = 10.0 / 3.0, away = 1e-6 * h;
    const struct box b = {f, 2.0 * h, 40.0, 0.0, {k, k}};
    const struct state s = {h + away, 0.0};
    CHECK_NEAR(-answer(&b, s).v / away,
               .quantity = "minus slope[1] divided by x - 6 m: the square "
                           "of the frequency",
               .unit = "/s^2", .input = input(&b, s),
               .expected = twelve * k / (b.mass * h * h),
               .tolerance = 2.0 * tolerance(&b, h) / away,
               .because = "that of slope[1], divided by the distance",
               .equation = "eq:piston-small",
               .question = "Near the middle the two gases act as one "
                           "spring. How hard is it?");
}

/* Twelve on a line; with more directions 2 (2/f) (2/f + 1). */
static void test_small_swing(void)
{
    check_swing(1, 12.0);
    check_swing(3, 20.0 / 9.0);
}

static double total(const struct box *b, struct state s)
{
    return 0.5 * b->mass * s.v * s.v + stored(b, s.x);
}

static struct state ahead(struct state s, double dt, struct state slope)
{
    return (struct state){s.x + dt * slope.x, s.v + dt * slope.v};
}

/* One step of the Runge-Kutta method of fourth order. */
static struct state step(const struct box *b, struct state s, double dt)
{
    const struct state k1 = answer(b, s);
    const struct state k2 = answer(b, ahead(s, 0.5 * dt, k1));
    const struct state k3 = answer(b, ahead(s, 0.5 * dt, k2));
    const struct state k4 = answer(b, ahead(s, dt, k3));
    s = ahead(s, dt / 6.0, k1);
    s = ahead(s, dt / 3.0, k2);
    s = ahead(s, dt / 3.0, k3);
    return ahead(s, dt / 6.0, k4);
}

/* From the middle at 1 m/s, far out and back, as the eleven particles of
   the chapter do. The method itself loses 4e-10 J with this step; what it
   loses falls with the fifth power of the step. */
static void test_large_swing(void)
{
    const struct box b = {1, 12.0, 40.0, 0.0, {10.0 / 3.0, 10.0 / 3.0}};
    const struct state start = {6.0, 1.0};
    struct state s = start;
    for (int i = 0; i < 1000; ++i)
        s = step(&b, s, 0.02);
    CHECK_NEAR(total(&b, s),
               .quantity = "energy of piston and gas after 20 s of a "
                           "Runge-Kutta method with your slopes",
               .unit = "J", .input = input(&b, start),
               .expected = total(&b, start), .tolerance = 1e-8,
               .because = "the method alone errs by 4e-10 J",
               .equation = "eq:piston-energy",
               .question =
                   "Whatever the gas gives, the piston gets. Where does "
                   "energy come from, or go, in your equations?");
}

static void test_gas_rides(void)
{
    const struct box b = {1, 12.0, 40.0, 13.5, {4.0, 3.0}};
    const struct state s = {4.0, 0.25};
    const double force = inertia(&b) * acceleration(&b, s.x);
    CHECK_NEAR(answer(&b, s).v, .quantity = dv_dt, .unit = "m/s^2",
               .input = input(&b, s), .expected = acceleration(&b, s.x),
               .tolerance = tolerance(&b, s.x), .because = because,
               .equation = "eq:added-mass",
               .question = "The gas near the piston moves with it, that at "
                           "the walls does not. How much of it counts?",
               .mistakes = {
                   {"gas-left-behind", force / b.mass,
                    "The piston moves as if the gas had no mass. What must "
                    "the gas beside it do when it moves?"},
                   {"whole-gas-rides", force / (b.mass + b.gas),
                    "All the gas moves with the piston here. Does the gas "
                    "at the wall?"},
                   {"half-the-gas-rides", force / (b.mass + 0.5 * b.gas),
                    "On average the gas moves half as fast as the piston. "
                    "But what counts is its energy: what is the mean of "
                    "the SQUARE of a velocity that grows from 0 to 1?"}});
}

/* By how much the particles of a gas get faster when its length shrinks to
   1/squeeze: f such factors make the squeeze. Found by halving. */
static double faster(int f, double squeeze)
{
    double low = 0.0, high = squeeze + 1.0;
    for (int i = 0; i < 100; ++i) {
        const double s = 0.5 * (low + high);
        double product = s;
        for (int k = 1; k < f; ++k)
            product *= s;
        *(product > squeeze ? &high : &low) = s;
    }
    return low;
}

/* The force of a gas at the length l. The energy goes with the square of
   the velocities, and one part in f of it is along the box. */
static double force(const struct box *b, int i, double l)
{
    const double s = faster(b->f, 0.5 * b->length / l);
    return b->energy[i] * s * s / (0.5 * b->f * l);
}

static struct box draw_box(void)
{
    struct box b = {check_draw_whole(1, 7),
                    check_draw(0.5, 90.0),
                    check_draw(0.2, 80.0),
                    0.0,
                    {0.0, 0.0}};
    b.gas = check_draw_whole(0, 2) ? check_draw(0.1, 90.0) : 0.0;
    b.energy[0] = check_draw(0.1, 9.0);
    b.energy[1] = check_draw(0.1, 9.0);
    return b;
}

static void check_drawn(const struct box *b, struct state s)
{
    const double left = force(b, 0, s.x);
    const double right = force(b, 1, b->length - s.x);
    const double moved = b->mass + b->gas / 3.0;
    CHECK_NEAR(
        answer(b, s).v, .quantity = dv_dt, .unit = "m/s^2",
        .input = input(b, s), .expected = (left - right) / moved,
        .tolerance = tolerance(b, s.x), .because = because,
        .question = "Work out the two forces on paper. Which of them is "
                    "not yours, and what does the piston carry along?",
        .mistakes = {{"both-push-right", (left + right) / moved,
                      "Both gases push to the right here. On which side of "
                      "the piston is the right one?"},
                     {"left-length-for-both",
                      (left - force(b, 1, s.x)) / moved,
                      "The right gas has the length of the left one here. "
                      "How long is it when the piston is at x?"},
                     {"gas-left-behind", (left - right) / b->mass,
                      "The piston moves as if the gas had no mass. What "
                      "must the gas beside it do when it moves?"},
                     {"mass-forgotten", left - right,
                      "This is the force. What is asked for is the rate at "
                      "which the velocity changes. Which unit has that?"}});
}

CHECK_TIMES(40, test_drawn, i)
{
    const struct box b = draw_box();
    const struct state s = {check_draw(0.12, 0.88) * b.length,
                            check_draw(-3.0, 3.0)};
    check_velocity(&b, s);
    check_drawn(&b, s);
}

const struct check_suite check_suite = {
    .file = "04a-air.c",
    .title = "Springs of air",
    .minutes = 30,
    .equation = "eq:piston-force",
    .tests =
        {{"the position changes as fast as the velocity says",
          test_velocity, 1, 0},
         {"equal gases leave the piston in the middle alone", test_middle,
          1, 0},
         {"a gas on a line pushes as worked out by hand", test_line, 2, 0},
         {"more directions make a softer spring", test_room, 2, 0},
         {"the right gas pushes to the left", test_right, 2, 0},
         {"the force is the slope of the stored energy", test_stored, 1, 0},
         {"small swings have the frequency worked out by hand",
          test_small_swing, 1, 0},
         {"a large swing conserves the energy", test_large_swing, 1, 0},
         {"a third of the gas rides along", test_gas_rides, 2, 0},
         {"boxes drawn agree with velocities that gain by a squeeze",
          test_drawn, 3, 3},
         {0}},
    .idle = {test_velocity, test_middle},
};
