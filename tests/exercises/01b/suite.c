/* The suite of exercise 01b, "Weighing without a balance". */

#include "examiner/check.h"
#include "call.h"

/* What a camera has seen. */
struct seen {
    double u1, u2, v1, v2;
};

/* What the student's function answers; untouched places read as NaN. */
struct answer {
    bool told;
    double ratio, restitution;
};

static struct answer answer(struct seen s)
{
    check_about(check_text("u1 = %.10g m/s, u2 = %.10g m/s before, v1 = "
                           "%.10g m/s, v2 = %.10g m/s after",
                           s.u1, s.u2, s.v1, s.v2));
    struct answer a = {false, CHECK_EMPTY, CHECK_EMPTY};
    a.told =
        measure_collision(s.u1, s.u2, s.v1, s.v2, &a.ratio, &a.restitution);
    return a;
}

static double fastest(struct seen s)
{
    return fmax(fmax(fabs(s.u1), fabs(s.u2)), fmax(fabs(s.v1), fabs(s.v2)));
}

static void check_told(struct seen s, const char *asking)
{
    CHECK_NEAR(
        answer(s).told,
        .quantity =
            "what is returned: can the velocities tell? (1 true, 0 false)",
        .expected = 1.0, .because = "yes or no", .question = asking);
}

/* The second body's gain in velocity by the first one's loss. Each
   difference carries the rounding of the two velocities in it. */
static void check_ratio(struct seen s, double expected)
{
    const double loss = s.u1 - s.v1, gain = s.v2 - s.u2;
    const double in = s.u1 - s.u2, out = s.v1 - s.u2;
    const bool wall = loss == 0.0 || gain == 0.0;
    const double roundings =
        1.0 + fastest(s) / fabs(loss) + fastest(s) / fabs(gain);
    CHECK_NEAR(
        answer(s).ratio, .quantity = "mass ratio m1/m2",
        .expected = expected,
        .tolerance = wall ? 0.0 : 4.0 * DBL_EPSILON * expected * roundings,
        .because = wall ? "a velocity that has not changed is exact"
                        : "4 epsilons, times how much smaller a change of "
                          "velocity is than the velocities",
        .mistakes = {
            {"upside-down", loss / gain,
             "This is m2/m1. The body whose velocity changes less: is it "
             "the lighter one or the heavier one?"},
            {"both-gain", -gain / loss,
             "A negative mass? Momentum that one body gains the other "
             "loses. Did you count the change of both as after minus "
             "before?"},
            {"target-at-rest", s.v2 / loss,
             "That would be right if the second body had been at rest. It "
             "moved before: how much of v2 does it owe to the collision?"},
            {"assumed-elastic", (in + out) / (in - out),
             "This uses the formula for a collision that loses no energy. "
             "Some was lost here. Which law holds all the same?"}});
}

/* The differences v2 - v1 and u1 - u2 are each wrong by at most an epsilon
   of the fastest velocity. */
static void check_restitution(struct seen s, double expected)
{
    const double towards = s.u1 - s.u2, apart = s.v2 - s.v1;
    const double roundings = 1.0 + fastest(s) / fabs(towards);
    CHECK_NEAR(
        answer(s).restitution, .quantity = "restitution",
        .expected = expected,
        .tolerance = 4.0 * DBL_EPSILON * (1.0 + expected) * roundings,
        .because = "4 epsilons, times how much smaller the speed of "
                   "approach is than the velocities",
        .equation = "eq:restitution",
        .mistakes = {
            {"restitution-sign", -apart / towards,
             "The size is right. Before, the first body gains on the "
             "second; after, the second draws away from the first. Which "
             "velocity do you subtract from which, before and after?"},
            {"energy-for-speed", apart * apart / (towards * towards),
             "This is the share of the energy of approach that is left. "
             "Restitution compares speeds. How do the two hang together?"},
            {"target-at-rest", apart / s.u1,
             "That would be right if the second body had been at rest. "
             "With what speed did the two approach each other?"},
            {"restitution-upside-down", towards / apart,
             "More than one, though energy was lost? Restitution is the "
             "speed after divided by the speed before."}});
}

static void check_real(struct seen s)
{
    check_told(s, "These velocities belong to a real collision. Which of "
                  "your tests turns it away?");
}

static void check_both(struct seen s, double ratio, double restitution)
{
    check_real(s);
    check_ratio(s, ratio);
    check_restitution(s, restitution);
}

static void test_twins(void)
{
    check_ask("The two have exchanged their velocities. What kind of "
              "bodies do that, and with what loss?");
    check_both((struct seen){1.0, 0.0, 0.0, 1.0}, 1.0, 1.0);
}

static void test_known_value(void)
{
    check_ask("The second body gained 1.8 m/s, the first lost 0.2 m/s. "
              "What does that say about their masses?");
    check_both((struct seen){1.0, 0.0, 0.8, 1.8}, 9.0, 1.0);
}

static void test_lost_energy(void)
{
    check_ask("Energy is lost here. Which of the two laws is still good, "
              "and what takes the place of the other?");
    check_both((struct seen){5.0, 0.0, 3.125, 5.625}, 3.0, 0.5);
}

static void test_both_move(void)
{
    check_ask("These are the velocities of the test before, filmed from a "
              "trolley that moves at 1 m/s. Should the masses care?");
    check_both((struct seen){4.0, -1.0, 2.125, 4.625}, 3.0, 0.5);
}

static void test_from_the_right(void)
{
    check_ask("The same collision in a mirror: every velocity has changed "
              "its sign. Which of your differences minds that?");
    check_both((struct seen){-5.0, 0.0, -3.125, -5.625}, 3.0, 0.5);
}

static void test_stick(void)
{
    check_ask("The two leave together. How fast do they separate?");
    check_both((struct seen){2.0, -1.0, 1.0, 1.0}, 2.0, 0.0);
}

/* Velocities that are no round numbers, for the two tests that follow. The
   restitution is 0.7899 / 0.93, about 0.85. */
static const struct seen filmed = {0.7, -0.23, -0.0531, 0.7368};

static void test_momentum(void)
{
    const struct seen s = filmed;
    check_real(s);
    const double m1 = answer(s).ratio, m2 = 1.0;
    CHECK_NEAR(
        m1 * s.v1 + m2 * s.v2,
        .quantity =
            "momentum after, with your mass ratio for m1 and 1 kg for m2",
        .unit = "kg m/s", .expected = m1 * s.u1 + m2 * s.u2,
        .tolerance = 16.0 * DBL_EPSILON * (1.0 + fabs(m1)) * fastest(s),
        .because = "16 epsilons of the sum of m |v|",
        .question = "Put your masses into the momentum before and after. "
                    "Where does the difference come from?");
}

static void test_energy(void)
{
    const struct seen s = filmed;
    check_real(s);
    const struct answer a = answer(s);
    const double m1 = a.ratio, e = a.restitution, d = s.u1 - s.u2;
    const double before = 0.5 * (m1 * s.u1 * s.u1 + s.u2 * s.u2);
    CHECK_NEAR(
        0.5 * (1.0 - e * e) * m1 / (1.0 + m1) * d * d,
        .quantity =
            "energy lost according to your restitution, with m2 = 1 kg",
        .unit = "J",
        .expected = before - 0.5 * (m1 * s.v1 * s.v1 + s.v2 * s.v2),
        .tolerance = 64.0 * DBL_EPSILON * fabs(before),
        .because = "64 epsilons of the energy before",
        .equation = "eq:energy-loss",
        .question = "The loss is the share 1 - e e of the energy of "
                    "approach. Is your e a ratio of speeds?");
}

static void check_wall(struct seen s, double ratio, double restitution)
{
    check_told(s, "One body is a wall here, and that can be told. Which of "
                  "your tests turns it away?");
    check_ask(
        "One velocity did not change at all. A ratio with that change in "
        "it is 0 or infinite: which of the two, and with which sign?");
    check_ratio(s, ratio);
    check_restitution(s, restitution);
}

/* A wall moves at c, and a body comes up to it and leaves it with e times
   that speed. */
static void check_drawn_wall(int i)
{
    const double e = check_draw_whole(0, 16) / 16.0;
    const double c = check_draw_whole(-40, 40) / 4.0;
    const double in = (i % 2 ? -1.0 : 1.0) * check_draw_whole(1, 40) / 4.0;
    const double before = c + in, after = c - e * in;
    if (i % 4 < 2)
        check_wall((struct seen){before, c, after, c}, 0.0, e);
    else
        check_wall((struct seen){c, before, c, after}, INFINITY, e);
}

static void test_walls(void)
{
    check_wall((struct seen){3.0, 0.0, -1.5, 0.0}, 0.0, 0.5);
    check_wall((struct seen){-3.0, 0.0, 1.5, 0.0}, 0.0, 0.5);
    check_wall((struct seen){0.0, -3.0, 0.0, 1.5}, INFINITY, 0.5);
    check_wall((struct seen){0.0, 3.0, 0.0, -1.5}, INFINITY, 0.5);
    for (int i = 0; i < 40; ++i)
        check_drawn_wall(i);
}

static void test_far_apart(void)
{
    check_ask(
        "One velocity has hardly changed, but it has changed: that body is "
        "very heavy and no wall. From where on do you take it for one?");
    check_both((struct seen){1.0, 0.0, 0.9999985, 1.5}, 1e6, 0.5000015);
    check_both((struct seen){0.0, 1.0, 1.5, 0.9999985}, 1e-6, 0.5000015);
}

static void check_refused(struct seen s, const char *slip, const char *why)
{
    CHECK_NEAR(
        answer(s).told,
        .quantity =
            "what is returned: can the velocities tell? (1 true, 0 false)",
        .because = "yes or no",
        .question = "Can these four velocities belong to a collision?",
        .mistakes = {{slip, 1.0, why}});
}

/* limit: alike */
/* Two that approach at 4.5e-12 m/s have met as surely as two at 5 m/s, with
   which they share every digit; two that move alike have not, however
   slowly they move. */
static void check_slow(void)
{
    const double unit = 0x1p-40;
    const struct seen s = {4.0 * unit, -1.0 * unit, 2.125 * unit,
                           4.625 * unit};
    static const char question[] =
        "These two approach at 4.5e-12 m/s: slowly, but they do. From "
        "which speed on do you take it that two move alike?";
    CHECK_NEAR(
        answer(s).told,
        .quantity =
            "what is returned: can the velocities tell? (1 true, 0 false)",
        .expected = 1.0, .because = "yes or no", .question = question,
        .mistakes = {{"slow-taken-for-alike", 0.0, question}});
    check_ask(question);
    check_ratio(s, 3.0);
    check_restitution(s, 0.5);
    check_refused((struct seen){unit, unit, 2.0 * unit, 0.0},
                  "never-refuses",
                  "The two moved alike before, slowly. With what speed of "
                  "approach is the restitution to be taken?");
}

static void test_no_collision(void)
{
    check_slow();
    check_refused((struct seen){1.0, 1.0, 1.0, 1.0}, "never-refuses",
                  "Here 0/0 was taken for a measurement. The two moved "
                  "alike and never met: what can they tell?");
    check_refused((struct seen){2.0, 0.0, 2.0, 0.0}, "never-refuses",
                  "Neither velocity has changed, so the two have missed "
                  "each other. What is 0/0 worth?");
    check_refused((struct seen){1.0, 1.0, 2.0, 0.0}, "never-refuses",
                  "The two moved alike before. With what speed of approach "
                  "is the restitution to be taken?");
}

static void test_impossible(void)
{
    static const char why[] =
        "Both bodies lost velocity, or both gained it. Which pair of "
        "positive masses could keep the momentum?";
    check_refused((struct seen){2.0, 0.0, 1.0, -1.0}, "negative-mass", why);
    check_refused((struct seen){0.0, -2.0, 1.0, 1.0}, "negative-mass", why);
}

/* Made from the answer. Seen from the centre of mass, which moves at c,
   each body comes in with the other's mass times p, and leaves with e times
   that in the opposite direction. All of it without a rounding. */
CHECK_TIMES(40, test_drawn, i)
{
    const double m1 = check_draw_whole(1, 20);
    const double m2 = check_draw_whole(1, 20);
    const double e = check_draw_whole(0, 16) / 16.0;
    const double c = check_draw_whole(-40, 40) / 4.0;
    const double p = (i % 2 ? -1.0 : 1.0) * check_draw_whole(1, 8) / 4.0;
    check_ask(check_text("The centre of mass of these two moves at %g m/s. "
                         "What does somebody see who moves with it?",
                         c));
    check_both((struct seen){c + p * m2, c - p * m1, c - e * p * m2,
                             c + e * p * m1},
               m1 / m2, e);
}

/* Two that move alike before, two that miss each other, and two that both
   lose a and b, or gain them. */
CHECK_TIMES(40, test_drawn_refused, i)
{
    const double u = check_draw(-9.0, 9.0), w = check_draw(-9.0, 9.0);
    const double sign = i % 2 ? -1.0 : 1.0;
    const double a = sign * check_draw(0.01, 5.0);
    const double b = sign * check_draw(0.01, 5.0);
    check_refused(
        (struct seen){u, u, u - a, u + b}, "never-refuses",
        "The two moved alike before. Who could have caught up with whom?");
    check_refused((struct seen){u, w, u, w}, "never-refuses",
                  "Nothing has changed here. What can be learned of bodies "
                  "that nothing has happened to?");
    check_refused((struct seen){u, w, u - a, w - b}, "negative-mass",
                  "Both velocities have changed in the same direction. Who "
                  "lost the momentum, and who gained it?");
}

const struct check_suite check_suite = {
    .file = "01b-measure.c",
    .title = "Weighing without a balance",
    .minutes = 20,
    .equation = "eq:momentum",
    .tests =
        {{"bodies that exchange their velocities weigh the same",
          test_twins, 1, 0},
         {"a body nine times as heavy is found out", test_known_value, 1,
          0},
         {"the masses are right when energy is lost", test_lost_energy, 1,
          0},
         {"a moving camera finds the same masses", test_both_move, 1, 0},
         {"a mirror finds the same masses", test_from_the_right, 1, 0},
         {"bodies that stick together have no restitution", test_stick, 1,
          0},
         {"the masses found conserve the momentum", test_momentum, 1, 0},
         {"the restitution found accounts for the lost energy", test_energy,
          1, 0},
         {"a wall is a body of infinite mass", test_walls, 1, 1},
         {"a body a million times as heavy is no wall", test_far_apart, 1,
          0},
         {"bodies that never met tell nothing", test_no_collision, 1, 0},
         {"masses are never negative", test_impossible, 1, 0},
         {"forty collisions give away their masses", test_drawn, 1, 2},
         {"what forty pairs did was no collision", test_drawn_refused, 1,
          1},
         {0}},
    .idle = {test_twins, test_impossible, test_drawn_refused},
};
