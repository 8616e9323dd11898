/* The suite of exercise 01e, "CHECKcollide". */

#include "examiner/check.h"
#include <stdio.h>

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

/* What `inexact` and `off` do to the first body, and to the second. */
static double by[2];

/* limit: 10 epsilons of the fastest, before or after */
/* Both velocities are off by so many epsilons of the fastest: by nine a
   right one may be; by 4500, 1e-12, a wrong one is. */
static void inexact(double m1, double m2, double *v1, double *v2)
{
    double fast = fmax(fabs(*v1), fabs(*v2));
    by_difference(m1, m2, v1, v2);
    fast = DBL_EPSILON * fmax(fast, fmax(fabs(*v1), fabs(*v2)));
    *v1 += by[0] * fast;
    *v2 += by[1] * fast;
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

/* The factors of the two changes, where 2 belongs. */
static void off(double m1, double m2, double *v1, double *v2)
{
    change(v1, v2, by[0] * m2 / (m1 + m2), by[1] * m1 / (m1 + m2));
}

/* A function to judge. */
struct judged {
    law *collide;
    double first, second;           /* for `by` */
    const char *how;                /* what it does, in words */
    const char *mistake, *question; /* for who judges it wrongly */
};

static const char digits[] =
    "This one is right, and you have taken another right one. They differ "
    "by a rounding or two. How do you compare two numbers?";
static const char nine[] =
    "This one is right: its velocities are off by nine epsilons of the "
    "fastest, and ten are allowed. How far off are then a momentum, and a "
    "difference of velocities?";

static const struct judged right[] = {
    {by_difference, 0, 0,
     "each body changes by its share of the difference",
     "right-one-refused",
     "This one is right, and until you take it nothing else counts. Which "
     "of your demands does it not fulfil? Print both sides of the "
     "comparison."},
    {by_centre, 0, 0, "reversed about the centre of mass",
     "rounding-refused", digits},
    {by_masses, 0, 0, "the two formulas of the textbooks",
     "rounding-refused", digits},
    {inexact, 9.0, -9.0, "both velocities are off by nine epsilons",
     "rounding-refused", nine},
    {inexact, -9.0, 9.0, "both velocities are off by nine epsilons",
     "rounding-refused", nine}};

enum { RIGHT = sizeof right / sizeof *right, MOST = 40 };

static law *tried;
static int calls;

static void counted(double m1, double m2, double *v1, double *v2)
{
    ++calls;
    tried(m1, m2, v1, v2);
}

/* Who has judged without a look has found out nothing. */
static void check_called(int called, const char *how)
{
    static const char question[] =
        "You have said something of this function, and have not let it "
        "compute one collision. What do you know of it?";
    CHECK_NEAR(called > 0,
               .quantity =
                   "1 if the function that you judge was called at all",
               .input = how, .expected = 1.0, .because = "yes or no",
               .question = question,
               .mistakes = {{"never-called", 0.0, question}});
}

static void check_said(double said, bool is_right, const struct judged *j)
{
    CHECK_NEAR(
        said,
        .quantity =
            is_right ? "what you say of a right function (1 true, 0 false)"
                     : "what you say of a wrong function (1 true, 0 false)",
        .input = j->how, .expected = is_right ? 1.0 : 0.0,
        .because = "yes or no", .question = j->question,
        .mistakes = {{j->mistake, is_right ? 0.0 : 1.0, j->question}});
}

/* Asks about the right functions and some wrong ones, up to one that is
   NULL, and then tells what was said, the right ones first. They are asked
   about in another order, drawn each time, each in a process of its own, so
   that what is said of one cannot come from its place in the row. */
static void judge(const struct judged wrong[])
{
    const struct judged *all[MOST];
    int count = 0, order[MOST], called[MOST];
    double said[MOST];
    while (count < RIGHT || wrong[count - RIGHT].collide) {
        all[count] = count < RIGHT ? &right[count] : &wrong[count - RIGHT];
        ++count;
    }
    check_shuffle(order, count);
    for (int k = 0; k < count; ++k) {
        const int i = order[k];
        tried = all[i]->collide;
        by[0] = all[i]->first;
        by[1] = all[i]->second;
        calls = 0;
        said[i] = passes(counted) ? 1.0 : 0.0;
        called[i] = calls;
    }
    for (int i = 0; i < count; ++i) {
        check_called(called[i], all[i]->how);
        check_said(said[i], i < RIGHT, all[i]);
    }
}

/* Defines a test that judges these and the right ones. */
#define JUDGE(test, ...)                                                   \
    static void test(void)                                                 \
    {                                                                      \
        judge((const struct judged[]){__VA_ARGS__, {0}});                  \
    }

static void test_right(void)
{
    judge(&(const struct judged){0});
}

JUDGE(test_energy,
      {stuck, 0, 0, "both stick together", "energy-forgotten",
       "This one loses energy. Which quantity did you not compare?"})

JUDGE(test_momentum,
      {in_the_lab, 0, 0, "both velocities change their signs",
       "momentum-forgotten",
       "A lorry and a fly turn round, each with the velocity it had: no "
       "energy is lost. Which quantity did you not compare?"})

JUDGE(test_nothing, {nothing, 0, 0, "nothing changes", "nothing-happens",
                     "This collide conserves energy and momentum. What "
                     "else does a collision do?"})

static const char unequal_question[] =
    "This one is right for equal masses. Which masses did you try?";

JUDGE(test_unequal,
      {swapped, 0, 0, "the two exchange their velocities",
       "equal-masses-only", unequal_question},
      {inverse, 0, 0, "the lighter body counts for more",
       "equal-masses-only", unequal_question})

static const char sides_question[] =
    "This one is right when the first body is the faster one to the right. "
    "Did you ever let the second one come from the left?";

JUDGE(test_sides,
      {without_sign, 0, 0, "the difference has lost its sign",
       "one-side-only", sides_question},
      {parting, 0, 0, "nothing happens unless v1 > v2", "one-side-only",
       sides_question})

static const char both_question[] =
    "One of the two bodies never changes its velocity. Which numbers did "
    "you look at afterwards?";

JUDGE(test_both,
      {first_only, 0, 0, "only the first body changes", "one-body-only",
       both_question},
      {second_only, 0, 0, "only the second body changes", "one-body-only",
       both_question})

JUDGE(test_moving,
      {second_at_rest, 0, 0, "the second body is taken to be at rest",
       "second-at-rest",
       "This one is right when the second body is at rest. Have both of "
       "yours moved, ever?"})

JUDGE(test_special,
      {twins_pass, 0, 0, "bodies of equal mass do not collide", "no-twins",
       "This one is right for all masses but equal ones. It is a special "
       "case: did you try it?"},
      {whole_masses, 0, 0, "masses are rounded up to kilograms",
       "whole-masses",
       "This one is right for whole kilograms. Which masses did you try?"},
      {not_light, 0, 0, "masses below 2 g are taken for 2 g",
       "not-all-masses",
       "This one is wrong for a gram alone. From which mass on, and up to "
       "which, was it to be right?"},
      {not_heavy, 0, 0, "masses above 500 kg are taken for 500 kg",
       "not-all-masses",
       "This one is wrong for a ton alone. From which mass on, and up to "
       "which, was it to be right?"})

static const char digits_question[] =
    "A right function errs by ten epsilons, 2e-15; this one by much more. "
    "How much do you let pass?";

JUDGE(test_digits,
      {nearly_elastic, 0, 0,
       "one part in ten thousand of the approach is lost",
       "small-error-passes", digits_question},
      {in_float, 0, 0, "the result is rounded to a float",
       "small-error-passes", digits_question},
      {inexact, 4500.0, 0.0, "the first velocity is off by 1e-12",
       "small-error-passes", digits_question},
      {inexact, 0.0, -4500.0, "the second velocity is off by 1e-12",
       "small-error-passes", digits_question})

JUDGE(test_nan,
      {no_number, 0, 0, "the second velocity is NaN", "nan-passes",
       "This one answers NaN. Is NaN larger than your tolerance, or "
       "smaller? Which way round must the question be asked?"})

static void test_drawn(void)
{
    struct judged drawn[31] = {{0}};
    char how[30][80];
    for (int i = 0; i < 30; ++i) {
        const double wrong = check_draw_whole(0, 1)
                                 ? check_draw(1.0, 1.9999)
                                 : check_draw(2.0001, 3.0);
        const double first = i % 3 == 1 ? 2.0 : wrong;
        const double second = i % 3 == 2 ? 2.0 : wrong;
        snprintf(how[i], sizeof how[i],
                 "factors %.10g and %.10g where 2 belongs", first, second);
        drawn[i] = (struct judged){
            off,
            first,
            second,
            how[i],
            NULL,
            "In this one a share of the velocity is wrong. Which of your "
            "comparisons sees a wrong share of the first body, and which "
            "one of the second?"};
    }
    judge(drawn);
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
