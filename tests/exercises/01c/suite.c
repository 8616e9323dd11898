/* The suite of exercise 01c, "A stack of balls is dropped". */

#include "examiner/check.h"
#include <stdio.h>
#include "call.h"

static const char *input(size_t n, const double masses[], double speed,
                         double restitution)
{
    char list[200] = "";
    size_t used = 0;
    for (size_t k = 0; k < n && used < sizeof list; ++k)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%.10g",
                                 k ? ", " : "", masses[k]);
    return check_text("masses {%s} kg from the bottom up, speed = %g m/s, "
                      "restitution = %g",
                      list, speed, restitution);
}

/* The slips, each worked out for the stack at hand. */

static double masses_exchanged(size_t n, const double m[], double speed,
                               double e)
{
    double w = e * speed;
    for (size_t k = 1; k < n; ++k)
        w += ((1.0 + e) * m[k] / (m[k - 1] + m[k]) - 1.0) * (w + speed);
    return w;
}

static double only_the_last_pair(size_t n, const double m[], double speed,
                                 double e)
{
    if (n < 2)
        return e * speed;
    return (1.0 + e) * m[n - 2] / (m[n - 2] + m[n - 1]) * (1.0 + e) *
               speed -
           speed;
}

/* With a restitution of 0 some slips answer 0, as much else does: such a
   value tells nothing, and the expected one stands in for it. */
static double telling(double value, double expected)
{
    return value == 0.0 ? expected : value;
}

static void check_top(size_t n, const double masses[], double speed,
                      double e, double expected)
{
    CHECK_NEAR(
        top_velocity(n, masses, speed, e),
        .quantity = "velocity of the top ball, upwards", .unit = "m/s",
        .input = input(n, masses, speed, e), .expected = expected,
        .tolerance =
            4.0 * (double)n * DBL_EPSILON * (fabs(expected) + speed),
        .because = "4 epsilons for each ball, of the velocity seen from "
                   "the falling stack",
        .mistakes = {
            {"floor-forgotten", -speed,
             "The top ball falls on as if nothing had happened. Nothing "
             "happens indeed until the lowest ball has met something. "
             "What?"},
            {"fall-not-subtracted", expected + speed,
             "This is the speed at which the top ball parts from the "
             "falling stack. Somebody stands on the ground and watches. "
             "What does the top ball do for them?"},
            {"upper-ball-at-rest",
             telling(e / (1.0 + e) * (expected + speed), expected),
             "This would be right if each upper ball hung still when it is "
             "hit. How fast does it come down on the one below?"},
            {"masses-exchanged", masses_exchanged(n, masses, speed, e),
             "The masses have changed places. Is masses[0] the top ball or "
             "the lowest? And who gives whom a share, the heavy or the "
             "light?"},
            {"only-the-last-pair", only_the_last_pair(n, masses, speed, e),
             "The ball below the top one did not come straight from the "
             "floor. Who threw it up, and how fast was it then?"},
            {"floor-without-loss",
             2.0 / (1.0 + e) * (expected + speed) - speed,
             "The floor sends the lowest ball back as fast as it came. Is "
             "that so with this restitution?"},
            {"never-downwards", expected < 0.0 ? 0.0 : expected,
             "Nothing was to stop here. The blow from below only slows "
             "this ball, and it goes on falling. Which sign has that?"},
            {"masses-ignored",
             telling((pow(1.0 + e, (double)n) - 1.0) * speed, expected),
             "This is the limit in which each ball is far heavier than the "
             "next. Where do the masses come in when they are not?"}});
}

/* limit: 1 (ball; and the restitution, of 0 to 1) */
static void test_one_ball(void)
{
    check_ask("A single ball meets the floor, which is a wall. What does "
              "the restitution make of its speed?");
    const double masses[] = {0.5};
    check_top(1, masses, 4.0, 0.5, 2.0);
    check_top(1, masses, 3.0, 1.0, 3.0);
}

static void test_equal_balls(void)
{
    const double masses[] = {2.0, 2.0, 2.0, 2.0};
    check_ask("Equal masses exchange their velocities. What goes up the "
              "stack then, from ball to ball?");
    check_top(4, masses, 3.0, 1.0, 3.0);
}

static void test_two_balls(void)
{
    check_ask("Two balls only: one comes up from the floor, the other "
              "comes down. How fast do they approach, and what does the "
              "upper one get?");
    const double heavy_below[] = {7.0, 1.0}, heavy_above[] = {1.0, 3.0};
    check_top(2, heavy_below, 1.0, 1.0, 2.5);
    check_top(2, heavy_above, 1.0, 1.0, 0.0);
}

static void test_limit_of_two(void)
{
    const double x = 0x1p-20, masses[] = {1.0, x};
    check_ask(
        "With hardly any mass on top the lower ball is as good as a wall "
        "that comes up. How fast does a ball leave such a wall?");
    check_top(2, masses, 2.0, 1.0, 2.0 * (3.0 - x) / (1.0 + x));
}

static void test_limit_of_five(void)
{
    const double x = 0x1p-7;
    const double masses[] = {1.0, x, x * x, x * x * x, x * x * x * x};
    const double share = 1.0 / (1.0 + x);
    check_ask(
        "In the limit each ball makes twice the speed plus one out of the "
        "speed of the one below. Where does your chain break?");
    check_top(5, masses, 1.0, 1.0,
              32.0 * share * share * share * share - 1.0);
}

static void test_energy(void)
{
    const double masses[] = {30.0, 10.0, 5.0, 3.0};
    const double speed = 1.5;
    const double w = top_velocity(4, masses, speed, 1.0);
    check_ask("In this stack each ball stops dead when it has hit the "
              "next. Is that so in your chain?");
    check_top(4, masses, speed, 1.0, 6.0);
    CHECK_NEAR(
        0.5 * 3.0 * w * w, .quantity = "energy of the top ball after",
        .unit = "J", .input = input(4, masses, speed, 1.0),
        .expected = 0.5 * 48.0 * speed * speed,
        .tolerance = 64.0 * DBL_EPSILON * 54.0,
        .because = "64 epsilons of the energy", .equation = "eq:energy",
        .question = "All the others have stopped and nothing was lost. Who "
                    "has the energy of the whole stack?");
}

static void test_loss(void)
{
    check_ask("Every impact loses energy here. In which of your steps does "
              "the restitution stand, and does the floor know it?");
    const double masses[] = {7.0, 1.0}, three[] = {4.0, 2.0, 1.0};
    check_top(2, masses, 4.0, 0.5, 3.875);
    check_top(3, three, 9.0, 0.5, 4.5);
    check_top(2, masses, 4.0, 0.0, -0.5);
}

static void test_too_heavy(void)
{
    check_ask("The upper ball is the heavier one. Which way does it go on, "
              "and which sign has that?");
    const double two[] = {1.0, 15.0}, three[] = {1.0, 7.0, 1.0};
    check_top(2, two, 2.0, 1.0, -1.5);
    check_top(3, three, 2.0, 1.0, -0.25);
}

/* Made from the answer. Ride down with the stack: the floor comes up and
   gives the lowest ball (1 + e) times the speed. We draw with which
   velocity each ball shall leave the one below, and give it the mass with
   which it does: of the momentum m w that comes up, the lower ball keeps
   what it needs to be slower by e times the upper one's velocity. */
CHECK_TIMES(40, test_drawn, i)
{
    enum { MOST = 6 };
    check_ask("Follow the blow from ball to ball. With which velocity does "
              "each one part from the falling stack?");
    const size_t n = 1 + (size_t)i % MOST;
    const double speed = check_draw(0.5, 20.0);
    const double e = i % 4 == 3 ? 1.0 : check_draw(0.2, 1.0);
    double masses[MOST] = {check_draw(0.1, 5.0)};
    double w = speed + e * speed;
    for (size_t k = 1; k < n; ++k) {
        const double up = w * (1.0 + e) * check_draw(0.2, 0.9);
        masses[k] = masses[k - 1] * (w - (up - e * w)) / up;
        w = up;
    }
    check_top(n, masses, speed, e, w - speed);
}

/* Each ball has q times the mass of the one below: then every step
   multiplies by the same number, and a power does for all. */
CHECK_TIMES(40, test_drawn_powers, i)
{
    enum { MOST = 8 };
    const size_t n = 1 + (size_t)i % MOST;
    const double speed = check_draw(0.5, 20.0);
    const double e = check_draw(0.0, 1.0);
    const double q = check_draw_whole(1, 12) / 4.0;
    double masses[MOST];
    for (size_t k = 0; k < n; ++k)
        masses[k] = pow(q, (double)k);
    const double times = pow((1.0 + e) / (1.0 + q), (double)n) * (1.0 + q);
    check_ask(
        check_text("Each ball has %g times the mass of the one below it. "
                   "Which share of its velocity does a ball give on?",
                   q));
    check_top(n, masses, speed, e, (times - 1.0) * speed);
}

const struct check_suite check_suite = {
    .file = "01c-stack.c",
    .title = "A stack of balls is dropped",
    .minutes = 25,
    .equation = "eq:restitution",
    .tests =
        {{"a single ball bounces back from the floor", test_one_ball, 1, 0},
         {"equal balls only pass the bounce on", test_equal_balls, 1, 0},
         {"two balls leave as worked out by hand", test_two_balls, 2, 0},
         {"a very light ball on a heavy one leaves three times as fast",
          test_limit_of_two, 1, 0},
         {"five ever lighter balls come near to 31 times the speed",
          test_limit_of_five, 1, 0},
         {"a stack can hand all its energy to the top ball", test_energy, 1,
          0},
         {"every impact loses its share when the restitution is below 1",
          test_loss, 2, 0},
         {"a ball too heavy to be thrown up goes on falling",
          test_too_heavy, 1, 0},
         {"forty stacks leave as they were meant to", test_drawn, 1, 3},
         {"forty stacks of one ratio leave with a power of it",
          test_drawn_powers, 1, 1},
         {0}},
    .idle = {test_equal_balls},
};
