/* The suite of exercise 01a, "Two bodies meet". */

#include "examiner/check.h"
#include "call.h"

/* What the student's function answers; untouched places read as NaN. */
struct after {
    double v[2];
};

static struct after answer(double u1, double u2, double im1, double im2)
{
    check_about(
        check_text("u1 = %g m/s, u2 = %g m/s, im1 = %g /kg, im2 = %g /kg",
                   u1, u2, im1, im2));
    struct after a = {{CHECK_EMPTY, CHECK_EMPTY}};
    velocities_after(u1, u2, im1, im2, a.v);
    return a;
}

/* Five operations or so, each rounded by at most half an epsilon of a
   number no larger than four times the faster velocity; and the difference
   itself is rounded once. */
static double tolerance(double u1, double u2)
{
    return 12.0 * DBL_EPSILON * fmax(fabs(u1), fabs(u2));
}

static const char because[] =
    "12 epsilons of the faster velocity: a handful of roundings";

static const char *const quantity[] = {"v[0], the first body after",
                                       "v[1], the second body after"};

/* Beside a body at rest some slips answer 0, as much else does: such a
   value tells nothing, and the expected one stands in for it. */
static double telling(double value, double expected)
{
    return value == 0.0 ? expected : value;
}

/* Checks the velocity of one body (0 or 1) against the expected one, and
   knows what the usual slips would have answered here. */
static void check_body(int body, double u1, double u2, double im1,
                       double im2, double expected)
{
    const double own = body == 0 ? u1 : u2, other = body == 0 ? u2 : u1;
    /* Half-way between before and after; and what the other weights give.
       Without its sign a difference changes a velocity the other way. */
    const double centre = 0.5 * (own + expected);
    const double crossed = u1 + u2 - centre;
    const double without_sign = u1 < u2 ? 2.0 * own - expected : expected;
    const double got = answer(u1, u2, im1, im2).v[body];
    CHECK_NEAR(
        got, .quantity = quantity[body], .unit = "m/s",
        .expected = expected, .tolerance = tolerance(u1, u2),
        .because = because,
        .mistakes = {
            {"stuck-together", centre,
             "This is the velocity of the centre of mass itself, as if the "
             "two had stuck together. In the centre's frame each body "
             "turns round: how far beyond the centre's velocity does that "
             "take it?"},
            {"reversed-in-the-lab", telling(-own, expected),
             "Turning the velocity round is right for someone who moves "
             "with the centre of mass, and only for them. What is the "
             "velocity before, as they see it?"},
            {"inverse-mass-as-mass", 2.0 * crossed - own,
             "Here the lighter body counts for more. The centre of mass "
             "weights each velocity with the mass; what does that weight "
             "become when only inverse masses are known?"},
            {"always-swapped", telling(other, expected),
             "The two exchange their velocities only when their masses are "
             "equal. What does a lorry do that meets a fly?"},
            {"sign-of-the-difference", without_sign,
             "This is right when the first body is the faster one to the "
             "right, as in the tests before. Here u1 - u2 is negative. "
             "What becomes of that sign in your formula?"},
            {"taken-for-parting",
             u1 < u2 ? telling(own, expected) : expected,
             "Your bodies go on as if they had missed each other. But the "
             "first one may just as well come from the right: does the "
             "formula ask which of them stands on the left?"},
            {"left-empty", CHECK_EMPTY,
             "Not a number. Either nothing was ever put into this place, "
             "or something like 0/0 was. Do both v[0] and v[1] stand on "
             "the left of an = in your function?"}});
}

static void check_both(double u1, double u2, double im1, double im2,
                       double v1, double v2)
{
    check_body(0, u1, u2, im1, im2, v1);
    check_body(1, u1, u2, im1, im2, v2);
}

/* The same when one of the two is a wall. Most of the slips above cannot
   come so far, and others first show here. */
static void check_beside_wall(int body, double u1, double u2, double im1,
                              double im2, double expected)
{
    const double own = body == 0 ? u1 : u2;
    const bool is_wall = (body == 0 ? im1 : im2) == 0.0;
    CHECK_NEAR(
        answer(u1, u2, im1, im2).v[body], .quantity = quantity[body],
        .unit = "m/s", .expected = expected, .tolerance = tolerance(u1, u2),
        .because = because,
        .question = "Sit on the wall: the body comes in, and goes out as "
                    "fast. What does that look like from the ground, when "
                    "the wall moves?",
        .mistakes = {
            {"wall-at-rest", is_wall ? 0.0 : -own,
             "This is right for a wall at rest. Here the wall moves, and "
             "goes on as if nothing had happened. How fast does the body "
             "come in, and leave, for somebody who sits on it?"},
            {"mass-of-a-wall", CHECK_NAN,
             "Not a number: somewhere 0/0 or infinity/infinity was "
             "computed. The mass of a wall is infinite, its inverse mass "
             "is just 0. Can the formula be written without any 1/im?"}});
}

static void test_nothing_happens(void)
{
    check_ask("Both move alike, so they never press on each other. What is "
              "the velocity of their centre of mass?");
    check_both(3.0, 3.0, 1.0, 0.5, 3.0, 3.0);
}

static void test_equal_masses(void)
{
    check_ask("The bodies are twins. If you looked away during the "
              "collision, which velocities would you find after it?");
    check_both(2.0, -1.0, 0.25, 0.25, -1.0, 2.0);
    check_both(1.0, 0.0, 1.0, 1.0, 0.0, 1.0);
}

static void test_known_values(void)
{
    check_ask(
        "Work this one out on paper: what is the velocity of the centre of "
        "mass, and what does each body do as seen from there?");
    check_both(2.0, -1.0, 1.0 / 3.0, 0.5, -0.4, 2.6);
    check_both(1.0, 0.0, 1.0 / 9.0, 1.0, 0.8, 1.8);
    check_both(1.0, 0.0, 1.0, 0.25, -0.6, 0.4);
}

/* Two of these in a mirror, and one without round numbers. Its centre moves
   at (0.31 * 0.37 + 0.83 * 1.91) / (0.31 + 0.83) = 1.7 / 1.14, for in whole
   numbers 31 * 37 + 83 * 191 = 17000. */
static void test_mirror(void)
{
    check_ask(
        "Here u1 is less than u2: the first body comes from the right and "
        "the two meet all the same. Which step of yours minds that?");
    check_both(-2.0, 1.0, 1.0 / 3.0, 0.5, 0.4, -2.6);
    check_both(-1.0, 0.0, 1.0 / 9.0, 1.0, -0.8, -1.8);
    check_ask("These are no round numbers. How many digits of yours are "
              "right, and what has become of the rest?");
    check_both(0.37, 1.91, 0.83, 0.31, 3.4 / 1.14 - 0.37,
               3.4 / 1.14 - 1.91);
}

static void test_momentum(void)
{
    const double u1 = 1.5, u2 = -0.75, im1 = 0.125, im2 = 0.5;
    const struct after a = answer(u1, u2, im1, im2);
    CHECK_NEAR(a.v[0] / im1 + a.v[1] / im2,
               .quantity = "momentum of both bodies after",
               .unit = "kg m/s", .expected = u1 / im1 + u2 / im2,
               .tolerance =
                   8.0 * DBL_EPSILON * (fabs(u1) / im1 + fabs(u2) / im2),
               .because = "8 epsilons of the sum of m |u|",
               .equation = "eq:momentum",
               .question =
                   "No force acts from outside, so what one body gains the "
                   "other loses. Do your two changes of momentum cancel?");
}

static void test_energy(void)
{
    const double u1 = 1.5, u2 = -0.75, im1 = 0.125, im2 = 0.5;
    const struct after a = answer(u1, u2, im1, im2);
    const double energy = 0.5 * (u1 * u1 / im1 + u2 * u2 / im2);
    CHECK_NEAR(0.5 * (a.v[0] * a.v[0] / im1 + a.v[1] * a.v[1] / im2),
               .quantity = "kinetic energy of both bodies after",
               .unit = "J", .expected = energy,
               .tolerance = 16.0 * DBL_EPSILON * energy,
               .because = "16 epsilons of the energy: squaring doubles the "
                          "relative error of a velocity",
               .equation = "eq:energy",
               .question = "In the centre of mass the speeds must be the "
                           "same before and after. Are yours?");
}

/* The wall, then the body: a wall at rest or moving, as either of the two,
   and in a mirror. */
static void test_wall(void)
{
    check_beside_wall(1, 1.0, -2.0, 1.0, 0.0, -2.0);
    check_beside_wall(0, 1.0, -2.0, 1.0, 0.0, -5.0);
    check_beside_wall(0, 0.0, -3.0, 0.0, 4.0, 0.0);
    check_beside_wall(1, 0.0, -3.0, 0.0, 4.0, 3.0);
    check_beside_wall(0, 2.0, -1.0, 0.0, 4.0, 2.0);
    check_beside_wall(1, 2.0, -1.0, 0.0, 4.0, 5.0);
    check_beside_wall(0, -2.0, 1.0, 0.0, 4.0, -2.0);
    check_beside_wall(1, -2.0, 1.0, 0.0, 4.0, -5.0);
}

/* Made from the answer. The centre moves at c, and seen from it each body
   is as fast as the inverse mass times w, so that their momenta cancel. A
   collision turns both round. All of it in sixteenths, without a rounding;
   every fourth pair are twins. */
CHECK_TIMES(40, test_drawn, i)
{
    const double c = check_draw_whole(-80, 80) / 8.0;
    const double w = (i % 2 ? -1.0 : 1.0) * check_draw_whole(1, 12) / 4.0;
    const double im1 = check_draw_whole(1, 20) / 4.0;
    const double im2 = i % 4 == 3 ? im1 : check_draw_whole(1, 20) / 4.0;
    check_ask(check_text(
        "The centre of mass of these two moves at %g m/s. How fast is each "
        "body for somebody who moves with it, before and after?",
        c));
    check_both(c + w * im1, c - w * im2, im1, im2, c - w * im1,
               c + w * im2);
}

/* Somebody who sits on the wall sees u_body - u_wall come in and the same
   go out. */
CHECK_TIMES(40, test_drawn_wall, i)
{
    const double wall = check_draw(-9.0, 9.0);
    const double body = check_draw(-9.0, 9.0);
    const double im = check_draw(0.01, 50.0);
    const double after = wall - (body - wall);
    if (i % 2) {
        check_beside_wall(0, wall, body, 0.0, im, wall);
        check_beside_wall(1, wall, body, 0.0, im, after);
    } else {
        check_beside_wall(0, body, wall, im, 0.0, after);
        check_beside_wall(1, body, wall, im, 0.0, wall);
    }
}

const struct check_suite check_suite = {
    .file = "01a-collide.c",
    .title = "Two bodies meet",
    .minutes = 10,
    .equation = "eq:reverse",
    .tests = {{"nothing happens to bodies with the same velocity",
               test_nothing_happens, 1, 0},
              {"equal masses exchange their velocities", test_equal_masses,
               1, 0},
              {"unequal masses leave as worked out by hand",
               test_known_values, 1, 0},
              {"the first body may come from the right", test_mirror, 1, 0},
              {"momentum is conserved", test_momentum, 1, 0},
              {"energy is conserved", test_energy, 1, 0},
              {"a wall keeps its velocity and turns the body round",
               test_wall, 1, 0},
              {"forty pairs turn round in their centre of mass", test_drawn,
               1, 2},
              {"forty bodies come back from a wall", test_drawn_wall, 1, 1},
              {0}},
    .idle = {test_nothing_happens, test_momentum, test_energy},
};
