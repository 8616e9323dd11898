/* The suite of exercise 12c, "Leave a force out". */

#include "examiner/check.h"
#include "call.h"

/* A force, and what may be spent. */
struct force {
    double push, stretch, time, budget;
};

struct answer {
    bool may;
    double bound, budget;
};

/* What the student's function says; an untouched bound reads as -99. */
static struct answer asked(const struct force *f)
{
    struct answer a = {false, -99.0, f->budget};
    a.may = leave_out(f->push, f->stretch, f->time, &a.budget, &a.bound);
    return a;
}

static const char *input(const struct force *f)
{
    return check_text(
        "push %.15g m/s^2, stretch %.15g/s, time %.15g s, budget %.15g m",
        f->push, f->stretch, f->time, f->budget);
}

/* ---- the bound ---- */

static bool near(double a, double b, double share)
{
    return fabs(a - b) <= share * fabs(b);
}

/* The mistake behind a NaN. It is named only where infinities can meet, or
   where there is no stretch to divide by and other bounds are numbers. */
static struct check_mistake no_number(const struct force *f)
{
    const struct force stretched = {1.0, 1.0, 1.0, 1.0};
    const bool beyond = f->stretch * f->time > 700.0;
    if (f->push > 0.0 && f->stretch > 0.0)
        return (struct check_mistake){
            "overflow", beyond ? CHECK_NAN : NAN,
            "Not a number, where the bound is beyond all numbers. Which "
            "two infinities met?"};
    if (f->push > 0.0)
        return (struct check_mistake){
            "nothing-over-nothing",
            isnan(asked(&stretched).bound) ? NAN : CHECK_NAN,
            "Not a number. What do you divide by when there is no stretch, "
            "and what is the limit?"};
    return (struct check_mistake){
        "nothing-times-infinity", beyond ? CHECK_NAN : NAN,
        "There is no force here. Which two numbers did you multiply, and "
        "may a force go that is none?"};
}

/* A bound that has lost its digits, or is another one. */
static void check_bound(const struct force *f, double got, double expected)
{
    const double s = f->stretch, t = f->time, x = s * t;
    const double lost = x > 0.0 && got > 0.0 && isfinite(expected) &&
                                near(got, expected, 1.0) &&
                                (near(got, expected, 1e-4) || x < 1e-5)
                            ? got
                            : expected;
    const double fall = f->push * t * t;
    const double rate = x > 0.0 ? s : 1.0, root = sqrt(rate);
    struct check_mistake all[] = {
        no_number(f),
        {"half-forgotten", 2.0 * expected,
         "This is twice as much. How far does a constant acceleration "
         "carry a body in a time t?"},
        {"velocity-for-place",
         x > 0.0 ? f->push * sinh(x) / rate : f->push * t,
         "This is how fast d grows in the end. Which unit has it, and how "
         "far does it go meanwhile?"},
        {"stretch-forgotten", 0.5 * fall,
         "This is right where the other forces are the same everywhere. "
         "What happens to d once there is some?"},
        {"forces-that-hold",
         x > 0.0 ? 2.0 * f->push * pow(sin(0.5 * x) / rate, 2.0)
                 : 0.5 * fall,
         "Here the other forces pull d back, so that it swings. Which sign "
         "has stretch^2 d in the equation?"},
        {"one-not-subtracted",
         x > 0.0 ? f->push * cosh(x) / (rate * rate) : 0.5 * fall,
         "At the time 0 this is not 0. Which constant is missing?"},
        {"square-for-rate",
         x > 0.0 ? f->push * (cosh(root * t) - 1.0) / rate : 0.5 * fall,
         "Here stretch itself stands where its square should. What is its "
         "unit, and that of d\"/d?"},
        {"digits-lost", lost,
         "The formula is right and its digits go. Which two large numbers "
         "nearly cancel when stretch times time is small?"}};
    struct check c = {.quantity = "*bound",
                      .unit = "m",
                      .input = input(f),
                      .expected = expected,
                      .tolerance = isinf(expected) ? 0.0 : 1e-12 * expected,
                      .because = "what was asked for"};
    for (size_t i = 0, used = 0; i < sizeof all / sizeof *all; ++i)
        if (isnan(all[i].value) ? isnan(got) && i == 0
                                : near(got, all[i].value, 1e-9) &&
                                      !near(expected, all[i].value, 1e-12))
            c.mistakes[used++] = all[i];
    check_near(got, c);
}

/* Only the bound is looked at. */
static void check_force(double push, double stretch, double time,
                        double expected)
{
    const struct force f = {push, stretch, time, 1.0};
    check_bound(&f, asked(&f).bound, expected);
}

/* The time after which exp(stretch t) is 1 + d: then cosh(stretch t) - 1 is
   d^2/(2 + 2 d). */
static void check_growth(double push, double stretch, double d)
{
    const double share = d / stretch;
    check_force(push, stretch, log1p(d) / stretch,
                0.5 * push * share * share / (1.0 + d));
}

/* ---- the verdict and the budget ---- */

static void check_may(const struct force *f, const struct answer *a,
                      bool expected, struct check_mistake mistake)
{
    CHECK_NEAR(a->may, .quantity = "may the force go? (1 yes, 0 no)",
               .input = input(f), .expected = expected,
               .because =
                   "it may go if its bound is not more than the budget",
               .mistakes = {mistake});
}

static void check_budget(const struct force *f, const struct answer *a,
                         double expected)
{
    const double whole = f->budget;
    CHECK_NEAR(
        a->budget, .quantity = "*budget, afterwards", .unit = "m",
        .input = input(f), .expected = expected, .tolerance = 2e-12 * whole,
        .because = "1e-12 of the bound, and rounding",
        .mistakes = {
            {"budget-not-spent", whole > expected ? whole : NAN,
             "The force goes, and the budget is what it was. How much is "
             "left for the next force?"},
            {"spent-all-the-same",
             whole > expected ? NAN : whole - a->bound,
             "The force stays, and its bound is taken from the budget all "
             "the same. What does it cost to compute with it?"}});
}

static const struct check_mistake nothing = {NULL, 0.0, NULL};

/* Whether a force whose bound is 1 m may go on a budget of less, and may
   not on one of more. */
static bool other_way_round(void)
{
    const struct force much = {2.0, 0.0, 1.0, 4.0};
    const struct force little = {2.0, 0.0, 1.0, 0.75};
    return !asked(&much).may && asked(&little).may;
}

/* The whole answer, for a force of this bound. */
static void check_all(const struct force *f, double bound)
{
    const struct answer a = asked(f);
    const bool may = bound <= f->budget;
    check_bound(f, a.bound, bound);
    check_may(f, &a, may,
              (struct check_mistake){
                  "the-other-way-round", other_way_round() ? !may : NAN,
                  "Should a force go whose bound is small, or "
                  "one whose bound is large?"});
    check_budget(f, &a, may ? f->budget - bound : f->budget);
}

/* ---- the tests ---- */

static void test_push(void)
{
    check_ask("Nothing stretches here: d\" is the push. How far is it "
              "after that time?");
    check_force(0.25, 0.0, 3.0, 1.125);
    check_force(2.0, 0.0, 1.0, 1.0);
    check_force(9.81, 0.0, 1e-3, 4.905e-6);
    check_force(1e-12, 0.0, 1e4, 5e-5);
}

/* After ln 2/stretch the cosine is 5/4, after ln 3/stretch 5/3. */
static void test_pencil(void)
{
    check_ask("A pencil on its tip, and somebody pushes it: which function "
              "has itself, and a constant, for its second derivative?");
    check_growth(1.0, 1.0, 1.0);
    check_growth(3.0, 1.0, 2.0);
    check_growth(2.0, 0.25, 1.0);
    check_growth(0.7, 5.0, 9.0);
    check_growth(0.7, 5.0, 1e6);
}

/* limit: 1e-9 (stretch times time; from 1e-12 to 0.1) */
/* limit: 1e-12 of the bound */
/* The first x is 1e-7: there cosh(x) - 1 has lost digits, but is not 0. */
static void test_little(void)
{
    check_ask("Little stretch is nearly none. How many digits of cosh(x) - "
              "1 are left when x is small?");
    for (int i = 12; i > 0; --i) {
        const double x = pow(10.0, -1 - (i + 6) % 12), q = x * x;
        check_force(2.0, x, 1.0,
                    1.0 + q / 12.0 * (1.0 + q / 30.0 * (1.0 + q / 56)));
        check_growth(2.0, 1.0, x);
    }
}

static void test_nothing(void)
{
    check_ask("No force, or no time: how far does anything go?");
    check_force(0.0, 0.0, 5.0, 0.0);
    check_force(0.0, 2.0, 5.0, 0.0);
    check_force(3.0, 2.0, 0.0, 0.0);
    check_force(3.0, 0.0, 0.0, 0.0);
    check_force(0.0, 2.0, 5000.0, 0.0);
}

/* limit: 1000 (stretch times time) */
static void test_much(void)
{
    check_ask("Here d grows by a factor of e in each 1/stretch, and there "
              "are many of these. How large can a number be?");
    check_growth(1e-9, 2.0, 1e12);
    check_growth(1e-9, 2.0, 1e100);
    check_force(1e-9, 2.0, 500.0, INFINITY);
    check_force(1e-9, 1.0, 2000.0, INFINITY);
    check_force(5.0, 100.0, 1e6, INFINITY);
}

/* A bound of 1 m, and budgets above, below, and just that. */
static void test_verdict(void)
{
    static const struct check_mistake strict = {
        "just-the-budget", 0.0,
        "The bound is just the budget, and that is not more than it. May "
        "the force go, and is it the budget as it was that you compare "
        "with, or what is left?"};
    const struct force above = {2.0, 0.0, 1.0, 4.0};
    const struct force below = {2.0, 0.0, 1.0, 0.75};
    const struct force just = {2.0, 0.0, 1.0, 1.0};
    const struct force none = {0.0, 3.0, 1.0, 0.0};
    const struct force never = {1e-9, 3.0, 1000.0, 1e9};
    const struct answer a = asked(&just), b = asked(&none);
    check_ask("The bound is 1 m. Is that more than the budget?");
    check_all(&above, 1.0);
    check_all(&below, 1.0);
    check_may(&just, &a, true, strict);
    check_budget(&just, &a, 0.0);
    check_ask("There is no force: may it go?");
    check_may(&none, &b, true, strict);
    check_ask("The bound is beyond all numbers. May the force go?");
    check_all(&never, INFINITY);
}

/* One budget for all: the second would fit alone, and the fourth is as
   large as what is left. */
static void test_budget(void)
{
    static const double push[] = {0.5, 1.0, 0.25, 0.25, 0.0625};
    static const bool may[] = {true, false, true, true, false};
    double budget = 0.5;
    for (int i = 0; i < 5; ++i) {
        const struct force f = {push[i], 0.0, 1.0, budget};
        const struct answer a = asked(&f);
        check_ask("The forces are left out one after the other, and bounds "
                  "add. How much is left of the budget for this one?");
        budget = may[i] ? budget - 0.5 * push[i] : budget;
        check_bound(&f, a.bound, 0.5 * push[i]);
        check_may(&f, &a, may[i], nothing);
        check_budget(&f, &a, budget);
    }
}

/* What friction does to a body that flies freely is known: it stays behind
   by v t - v (1 - exp(-k t))/k, with k = c/m; k v is the largest push. */
static void test_friction(void)
{
    for (int i = 1; i <= 8; ++i) {
        const double k = pow(10.0, -i), v = 3.0, t = 2.0;
        const struct force f = {k * v, 0.0, t, 1.0};
        const double behind = v * (t + expm1(-k * t) / k);
        CHECK_NEAR(asked(&f).bound / behind,
                   .quantity = "*bound, in units of what friction does",
                   .input = check_text("a body of 3 m/s, for 2 s, with a "
                                       "friction of c/m = %g/s: %s",
                                       k, input(&f)),
                   .expected = 1.0 + k * t / 3.0,
                   .tolerance = k * k * t * t + 1e-15 / (k * t),
                   .because = "the next term of a series, and rounding of "
                              "what friction does",
                   .question = "The bound must not be less than what "
                               "happens, and not much more. Which is it?");
    }
}

/* ---- drawn forces ---- */

CHECK_TIMES(50, test_drawn_bound, i)
{
    check_ask(
        "Does your formula keep its digits for any stretch and any time?");
    const double push = pow(10.0, check_draw(-12.0, 2.0));
    const double stretch = pow(10.0, check_draw(-3.0, 3.0));
    const double d = pow(10.0, check_draw(-9.0, 9.0));
    check_growth(push, stretch, d);
}

/* A budget, and forces until it is nearly gone. Pushes are such that their
   bounds are clear of what is left. */
CHECK_TIMES(20, test_drawn_budget, i)
{
    check_ask(
        "What is left of the budget, and is it enough for this force?");
    struct force f = {0.0, check_draw(0.1, 2.0), 0.0, 0.0};
    const double d = check_draw(0.5, 9.0);
    f.time = log1p(d) / f.stretch;
    f.budget = check_draw(0.1, 5.0);
    const double unit = 0.5 * d * d / (f.stretch * f.stretch * (1 + d));
    for (int k = 0; k < 8; ++k) {
        const bool go = check_draw_whole(0, 2) > 0;
        const double bound =
            f.budget * (go ? check_draw(0.01, 0.8) : check_draw(1.01, 3.0));
        f.push = bound / unit;
        check_all(&f, bound);
        f.budget -= go ? bound : 0.0;
    }
}

const struct check_suite check_suite = {
    .file = "12c-without.c",
    .title = "Leave a force out",
    .minutes = 25,
    .equation = "eq:models-left-out",
    .tests = {{"a push, and nothing that stretches", test_push, 2, 0},
              {"a pencil on its tip is pushed", test_pencil, 2, 0},
              {"no force, or no time", test_nothing, 1, 0},
              {"little stretch", test_little, 2, 0},
              {"much stretch", test_much, 1, 0},
              {"whether the force may go", test_verdict, 1, 0},
              {"one budget for all forces", test_budget, 2, 0},
              {"friction on a body that flies freely", test_friction, 1, 0},
              {"drawn bounds", test_drawn_bound, 1, 2},
              {"drawn forces on one budget", test_drawn_budget, 1, 2},
              {0}},
};
