/* The suite of exercise 01e, "CHECKcollide". */

#include "examiner/check.h"

typedef void law(double m1, double m2, double *v1, double *v2);

bool passes(law *collide);

/* Both bodies change by a multiple of the velocity of approach; each has a
   share in it, and the right ones are a = 2 m2/(m1 + m2) and b = 2 m1/(m1 +
   m2). */
static void change(double *v1, double *v2, double a, double b)
{
    const double w = *v1 - *v2;
    *v1 -= a * w;
    *v2 += b * w;
}

static void by_difference(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, 2.0 * m2 / (m1 + m2), 2.0 * m1 / (m1 + m2));
}

static void by_centre(double m1, double m2, double *v1, double *v2)
{
    const double twice = 2.0 * (m1 * *v1 + m2 * *v2) / (m1 + m2);
    *v1 = twice - *v1;
    *v2 = twice - *v2;
}

static void by_masses(double m1, double m2, double *v1, double *v2)
{
    const double u = *v1, m = m1 + m2;
    *v1 = (m1 - m2) / m * u + 2.0 * m2 / m * *v2;
    *v2 = 2.0 * m1 / m * u - (m1 - m2) / m * *v2;
}

/* limit: 10 epsilons of the fastest, before or after */
/* How much the first velocity, and the second, are off by, in epsilons of
   the fastest: by nine a right one may be; by 4500, 1e-12, a wrong one is.
 */
static double epsilons[2];

static void inexact(double m1, double m2, double *v1, double *v2)
{
    double fast = fmax(fabs(*v1), fabs(*v2));
    by_difference(m1, m2, v1, v2);
    fast = DBL_EPSILON * fmax(fast, fmax(fabs(*v1), fabs(*v2)));
    *v1 += epsilons[0] * fast;
    *v2 += epsilons[1] * fast;
}

/* limit: 1e-3 kg */
static void not_light(double m1, double m2, double *v1, double *v2)
{
    by_difference(fmax(m1, 2e-3), fmax(m2, 2e-3), v1, v2);
}

/* limit: 1e3 kg */
static void not_heavy(double m1, double m2, double *v1, double *v2)
{
    by_difference(fmin(m1, 500.0), fmin(m2, 500.0), v1, v2);
}

static void nothing(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, 0.0 * m1, 0.0 * m2);
}

static void stuck(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, m2 / (m1 + m2), m1 / (m1 + m2));
}

static void in_the_lab(double m1, double m2, double *v1, double *v2)
{
    (void)m1;
    (void)m2;
    *v1 *= -1.0;
    *v2 *= -1.0;
}

static void inverse(double m1, double m2, double *v1, double *v2)
{
    by_centre(m2, m1, v1, v2);
}

static void swapped(double m1, double m2, double *v1, double *v2)
{
    (void)m1;
    (void)m2;
    change(v1, v2, 1.0, 1.0);
}

static void without_sign(double m1, double m2, double *v1, double *v2)
{
    const double side = *v1 < *v2 ? -1.0 : 1.0;
    change(v1, v2, side * 2.0 * m2 / (m1 + m2),
           side * 2.0 * m1 / (m1 + m2));
}

static void parting(double m1, double m2, double *v1, double *v2)
{
    if (*v1 > *v2)
        by_difference(m1, m2, v1, v2);
}

static void first_only(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, 2.0 * m2 / (m1 + m2), 0.0);
}

static void second_only(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, 0.0, 2.0 * m1 / (m1 + m2));
}

static void second_at_rest(double m1, double m2, double *v1, double *v2)
{
    *v2 = 0.0;
    by_difference(m1, m2, v1, v2);
}

static void no_number(double m1, double m2, double *v1, double *v2)
{
    by_difference(m1, m2, v1, v2);
    *v2 = m1 == m2 ? *v2 : NAN;
}

static void in_float(double m1, double m2, double *v1, double *v2)
{
    by_difference(m1, m2, v1, v2);
    *v1 = (double)(float)*v1;
    *v2 = (double)(float)*v2;
}

static void nearly_elastic(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, 1.9999 * m2 / (m1 + m2), 1.9999 * m1 / (m1 + m2));
}

static void whole_masses(double m1, double m2, double *v1, double *v2)
{
    by_difference(ceil(m1), ceil(m2), v1, v2);
}

static void twins_pass(double m1, double m2, double *v1, double *v2)
{
    if (fabs(m1 - m2) > 0.0)
        by_difference(m1, m2, v1, v2);
}

/* A share of the change is wrong, in the first body or in the second. */
static double factor[2];

static void off(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, factor[0] * m2 / (m1 + m2), factor[1] * m1 / (m1 + m2));
}

/* The functions of a test, in the order in which they are told of. They are
   asked about in another order, drawn each time, so that what is said of
   one cannot come from its place in the row; each in a process of its own.
   So a test goes through its functions twice: first they are put down, then
   they are told of. */
enum { MOST = 40 };

static struct {
    law *collide;
    double factor[2], epsilons[2]; /* those of this one */
    double said;
    int calls;
} judged[MOST];
static int count, at;
static enum { PUT_DOWN, TELL, DONE } stage;

static law *tried;
static int calls;

static void counted(double m1, double m2, double *v1, double *v2)
{
    ++calls;
    tried(m1, m2, v1, v2);
}

static void begin(void)
{
    count = 0;
    stage = DONE;
}

/* Whether the functions are to be gone through, once more. */
static bool again(void)
{
    int order[MOST];
    if (stage == TELL)
        return false;
    stage = stage == DONE ? PUT_DOWN : TELL;
    check_shuffle(order, count);
    for (int k = 0; k < count; ++k) {
        const int i = order[k];
        calls = 0;
        tried = judged[i].collide;
        factor[0] = judged[i].factor[0];
        factor[1] = judged[i].factor[1];
        epsilons[0] = judged[i].epsilons[0];
        epsilons[1] = judged[i].epsilons[1];
        judged[i].said = passes(counted) ? 1.0 : 0.0;
        judged[i].calls = calls;
    }
    at = 0;
    return true;
}

/* Whether that is all for now. */
static bool put_down(law *collide)
{
    if (stage == PUT_DOWN && count < MOST) {
        judged[count].factor[0] = factor[0];
        judged[count].factor[1] = factor[1];
        judged[count].epsilons[0] = epsilons[0];
        judged[count].epsilons[1] = epsilons[1];
        judged[count++].collide = collide;
    }
    return stage == PUT_DOWN;
}

/* Who has judged without a look has found out nothing. */
static bool check_called(const char *how)
{
    static const char question[] =
        "You have said something of this function, and have not let it "
        "compute one collision. What do you know of it?";
    return CHECK_NEAR(
        judged[at].calls > 0 ? 1.0 : 0.0,
        .quantity = "1 if the function that you judge was called at all",
        .input = how, .expected = 1.0, .tolerance = 0.0,
        .because = "yes or no", .question = question,
        .mistakes = {{"never-called", 0.0, question}});
}

static bool check_right(law *collide, const char *how, const char *mistake,
                        const char *question)
{
    return put_down(collide) ||
           (check_called(how) &&
            CHECK_NEAR(
                judged[at++].said,
                .quantity =
                    "what you say of a right function (1 true, 0 false)",
                .input = how, .expected = 1.0, .tolerance = 0.0,
                .because = "yes or no", .question = question,
                .mistakes = {{mistake, 0.0, question}}));
}

static bool check_inexact(double first, double second)
{
    epsilons[0] = first;
    epsilons[1] = second;
    return check_right(
        inexact, "both velocities are off by nine epsilons",
        "rounding-refused",
        "This one is right: its velocities are off by nine epsilons of the "
        "fastest, and ten are allowed. How far off are then a momentum, "
        "and a difference of velocities?");
}

static bool check_rights(void)
{
    static const char digits[] =
        "This one is right, and you have taken another right one. They "
        "differ by a rounding or two. How do you compare two numbers?";
    return check_right(by_difference,
                       "each body changes by its share of the difference",
                       "right-one-refused",
                       "This one is right, and until you take it nothing "
                       "else counts. Which of your demands does it not "
                       "fulfil? Print both sides of the comparison.") &&
           check_right(by_centre, "reversed about the centre of mass",
                       "rounding-refused", digits) &&
           check_right(by_masses, "the two formulas of the textbooks",
                       "rounding-refused", digits) &&
           check_inexact(9.0, -9.0) && check_inexact(-9.0, 9.0);
}

static bool check_wrong(law *collide, const char *how, const char *mistake,
                        const char *question)
{
    return put_down(collide) ||
           (check_called(how) &&
            CHECK_NEAR(
                judged[at++].said,
                .quantity =
                    "what you say of a wrong function (1 true, 0 false)",
                .input = how, .expected = 0.0, .tolerance = 0.0,
                .because = "yes or no", .question = question,
                .mistakes = {{mistake, 1.0, question}}));
}

static void test_right(void)
{
    for (begin(); again();)
        check_rights();
}

static void test_energy(void)
{
    static const char question[] =
        "This one loses energy. Which quantity did you not compare?";
    for (begin(); again();)
        (void)(check_rights() && check_wrong(stuck, "both stick together",
                                             "energy-forgotten", question));
}

static void test_momentum(void)
{
    static const char question[] =
        "A lorry and a fly turn round, each with the velocity it had: no "
        "energy is lost. Which quantity did you not compare?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(in_the_lab, "both velocities change their signs",
                           "momentum-forgotten", question));
}

static void test_nothing(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(nothing, "nothing changes", "nothing-happens",
                           "This collide conserves energy and momentum. "
                           "What else does a collision do?"));
}

static void test_unequal(void)
{
    static const char question[] =
        "This one is right for equal masses. Which masses did you try?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(swapped, "the two exchange their velocities",
                           "equal-masses-only", question) &&
               check_wrong(inverse, "the lighter body counts for more",
                           "equal-masses-only", question));
}

static void test_sides(void)
{
    static const char question[] =
        "This one is right when the first body is the faster one to the "
        "right. Did you ever let the second one come from the left?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(without_sign, "the difference has lost its sign",
                           "one-side-only", question) &&
               check_wrong(parting, "nothing happens unless v1 > v2",
                           "one-side-only", question));
}

static void test_both(void)
{
    static const char question[] =
        "One of the two bodies never changes its velocity. Which numbers "
        "did you look at afterwards?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(first_only, "only the first body changes",
                           "one-body-only", question) &&
               check_wrong(second_only, "only the second body changes",
                           "one-body-only", question));
}

static void test_moving(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(second_at_rest,
                           "the second body is taken to be at rest",
                           "second-at-rest",
                           "This one is right when the second body is at "
                           "rest. Have both of yours moved, ever?"));
}

static void test_special(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(twins_pass,
                           "bodies of equal mass do not collide",
                           "no-twins",
                           "This one is right for all masses but equal "
                           "ones. It is a special case: did you try it?") &&
               check_wrong(whole_masses,
                           "masses are rounded up to kilograms",
                           "whole-masses",
                           "This one is right for whole kilograms. Which "
                           "masses did you try?") &&
               check_wrong(
                   not_light, "masses below 2 g are taken for 2 g",
                   "not-all-masses",
                   "This one is wrong for a gram alone. From which mass "
                   "on, and up to which, was it to be right?") &&
               check_wrong(
                   not_heavy, "masses above 500 kg are taken for 500 kg",
                   "not-all-masses",
                   "This one is wrong for a ton alone. From which mass on, "
                   "and up to which, was it to be right?"));
}

static void test_digits(void)
{
    static const char question[] =
        "A right function errs by ten epsilons, 2e-15; this one by much "
        "more. How much do you let pass?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(
                   nearly_elastic,
                   "one part in ten thousand of the approach is lost",
                   "small-error-passes", question) &&
               check_wrong(in_float, "the result is rounded to a float",
                           "small-error-passes", question) &&
               (epsilons[0] = 4500.0, epsilons[1] = 0.0,
                check_wrong(inexact, "the first velocity is off by 1e-12",
                            "small-error-passes", question)) &&
               (epsilons[0] = 0.0, epsilons[1] = -4500.0,
                check_wrong(inexact, "the second velocity is off by 1e-12",
                            "small-error-passes", question)));
}

static void test_nan(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(no_number, "the second velocity is NaN",
                           "nan-passes",
                           "This one answers NaN. Is NaN larger than your "
                           "tolerance, or smaller? Which way round must "
                           "the question be asked?"));
}

/* The factors of a function that is wrong, where 2 belongs. */
static void test_drawn(void)
{
    static const char question[] =
        "In this one a share of the velocity is wrong. Which of your "
        "comparisons sees a wrong share of the first body, and which one "
        "of the second?";
    double drawn[30][2];
    for (int i = 0; i < 30; ++i) {
        const double wrong = check_draw_whole(0, 1)
                                 ? check_draw(1.0, 1.9999)
                                 : check_draw(2.0001, 3.0);
        drawn[i][0] = i % 3 == 1 ? 2.0 : wrong;
        drawn[i][1] = i % 3 == 2 ? 2.0 : wrong;
    }
    for (begin(); again();) {
        bool fine = check_rights();
        for (int i = 0; i < 30 && fine; ++i) {
            factor[0] = drawn[i][0];
            factor[1] = drawn[i][1];
            fine = check_wrong(
                off,
                check_text("factors %.10g and %.10g where 2 belongs",
                           factor[0], factor[1]),
                NULL, question);
        }
    }
}

const struct check_suite check_suite = {
    .file = "01e-check.c",
    .title = "CHECKcollide",
    .minutes = 30,
    .equation = "eq:reverse",
    .tests = {{"three right functions are right", test_right, 1, 0},
              {"one that loses energy is refused", test_energy, 1, 0},
              {"one that loses momentum is refused", test_momentum, 1, 0},
              {"one that does nothing is refused", test_nothing, 2, 0},
              {"those that are right for equal masses are refused",
               test_unequal, 1, 0},
              {"those that know only one side are refused", test_sides, 1,
               0},
              {"those that change one body are refused", test_both, 1, 0},
              {"one that forgets the second velocity is refused",
               test_moving, 1, 0},
              {"those that fail in special cases are refused", test_special,
               1, 0},
              {"those that are wrong in the fifth digit, or the eighth, "
               "are refused",
               test_digits, 1, 0},
              {"one that answers NaN is refused", test_nan, 1, 0},
              {"thirty that are wrong by a factor are refused", test_drawn,
               1, 2},
              {0}},
    .idle = {test_right},
};
