/* The suite of exercise 08c, "Measure an order". */

#include "examiner/check.h"
#include <stdio.h>
#include "call.h"

enum { MOST = 40 };

struct runs {
    size_t n;
    double rounding;
    double h[MOST + 1], error[MOST + 1];
};

struct result {
    enum verdict verdict;
    double order;
};

/* What the student's function says; an untouched order reads as -99. Behind
   the runs stands one that does not belong to them. */
static struct result measured(const struct runs *r)
{
    struct runs q = *r;
    struct result result = {TOO_FEW, -99.0};
    q.h[r->n] = r->n > 0 ? 0.5 * r->h[r->n - 1] : 1.0;
    q.error[r->n] = 7.0;
    result.verdict =
        measure_order(q.n, q.h, q.error, q.rounding, &result.order);
    return result;
}

static const char *input(const struct runs *r)
{
    char list[300] = "";
    size_t used = 0;
    for (size_t i = 0; i < r->n && used < 240; ++i)
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s%g s: %g m", i ? "; " : "", r->h[i],
                                 r->error[i]);
    return check_text("%zu run%s, rounding %g m%s%s%s", r->n,
                      r->n == 1 ? "" : "s", r->rounding, r->n ? "; " : "",
                      list, used < 240 ? "" : "; ...");
}

/* ---- what comes out, right and wrong ---- */

static bool of_use(const struct runs *r, size_t i, double times)
{
    return isfinite(r->error[i]) && fabs(r->error[i]) > times * r->rounding;
}

/* The slope from one run to another on logarithmic paper. */
static double rise(const struct runs *r, size_t coarse, size_t fine)
{
    return (log(fabs(r->error[coarse])) - log(fabs(r->error[fine]))) /
           (log(r->h[coarse]) - log(r->h[fine]));
}

/* The slope of the last two runs whose error is large enough. */
static double last_rise(const struct runs *r, double times)
{
    size_t last[2] = {0, 0};
    int count = 0;
    for (size_t i = 0; i < r->n; ++i)
        if (of_use(r, i, times)) {
            last[0] = last[1];
            last[1] = i;
            ++count;
        }
    return count < 2 ? NAN : rise(r, last[0], last[1]);
}

/* The runs of use alone. */
static struct runs sifted(const struct runs *r)
{
    struct runs s = {.rounding = r->rounding};
    for (size_t i = 0; i < r->n; ++i)
        if (of_use(r, i, 1000.0)) {
            s.h[s.n] = r->h[i];
            s.error[s.n++] = r->error[i];
        }
    return s;
}

static struct runs positive(const struct runs *r)
{
    struct runs s = {.rounding = r->rounding};
    for (size_t i = 0; i < r->n; ++i)
        if (r->error[i] > 0.0) {
            s.h[s.n] = r->h[i];
            s.error[s.n++] = r->error[i];
        }
    return s;
}

enum { SLIPS = 12 };

/* Of a slip that has no value here. */
static const double never = -12345.0;

static void slips_of(const struct runs *r, struct check_mistake slip[SLIPS])
{
    const struct runs s = sifted(r), plus = positive(&s);
    const size_t m = s.n;
    const double p = m < 2 ? NAN : rise(&s, m - 2, m - 1);
    const double errors =
        m < 2 ? NAN : fabs(s.error[m - 2] / s.error[m - 1]);
    const double steps = m < 2 ? NAN : s.h[m - 2] / s.h[m - 1];
    const double end = r->n > 0 ? r->error[r->n - 1] : 0.0;
    const double blown = isinf(end) ? -INFINITY : isnan(end) ? NAN : never;
    const struct check_mistake all[SLIPS] = {
        {"sign-of-the-order", -p,
         "The size is right. Does the error of a good method get larger or "
         "smaller with a smaller step?"},
        {"upside-down", 1.0 / p,
         "This is 1/p. Which of the two logarithms is divided by which?"},
        {"steps-that-halve", log2(errors),
         "This is the order if each step were half of the one before it. "
         "Is it?"},
        {"ratio-for-order", errors,
         "This is how many times smaller the error became. Which power of "
         "the steps' ratio is it?"},
        {"ratio-of-ratios", errors / steps,
         "This is one ratio over the other. Which function turns a power "
         "into a factor?"},
        {"sign-of-an-error",
         m >= 2 && s.error[m - 2] * s.error[m - 1] < 0.0 ? CHECK_NAN
                                                         : never,
         "Not a number. What is the logarithm of a negative number, and "
         "does it matter here on which side the error is?"},
        {"negative-errors-passed-over", last_rise(&plus, 1000.0),
         "This leaves out the runs with negative errors. Is an error of -1 "
         "m smaller than one of 1 mm?"},
        {"largest-steps", m < 2 ? NAN : rise(&s, 0, 1),
         "This is the slope at the largest steps. Where is the line "
         "straight: at large steps, or at small ones?"},
        {"first-and-last", m < 2 ? NAN : rise(&s, 0, m - 1),
         "This is the slope from the largest step to the smallest. Which "
         "two runs were wanted?"},
        {"rounding-counted", last_rise(r, 0.0),
         "Runs count here whose errors are mostly rounding. How large must "
         "an error be to be of use?"},
        {"rounding-counted", last_rise(r, 1.0),
         "Runs count here whose errors are mostly rounding. How many times "
         "larger must an error be to be of use?"},
        {"blown-up-counted", blown,
         "What is the logarithm of an infinity, and of what is not a "
         "number? Which runs are of use?"}};
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = all[i];
}

static bool same(double got, double value)
{
    return isfinite(got) ? fabs(got - value) <= 1e-9 * (1.0 + fabs(value))
           : isnan(got)  ? isnan(value)
                         : got == value;
}

/* The tolerance is that of four logarithms over that of the steps. */
static double tolerance(const struct runs *r, double p)
{
    double logs = 2.0 + fabs(p);
    for (size_t i = 0; i < r->n; ++i)
        if (of_use(r, i, 1000.0))
            logs = fmax(logs,
                        fabs(log(fabs(r->error[i]))) +
                            (1.0 + fabs(p)) * (1.0 + fabs(log(r->h[i]))));
    return 32.0 * DBL_EPSILON * logs / log(1.05);
}

static void check_order(const struct runs *r, double got, double p)
{
    struct check_mistake slip[SLIPS];
    struct check c = {
        .quantity = "*order",
        .input = input(r),
        .expected = p,
        .tolerance = tolerance(r, p),
        .because =
            "some epsilons of four logarithms, over that of the steps"};
    slips_of(r, slip);
    for (int i = 0, used = 0; i < SLIPS && used < 8; ++i)
        if (same(got, slip[i].value))
            c.mistakes[used++] = slip[i];
    check_near(got, c);
}

static const char *verdict_name(enum verdict verdict)
{
    return verdict == TOO_FEW   ? "TOO_FEW"
           : verdict == NOT_YET ? "NOT_YET"
                                : "MEASURED";
}

/* A verdict, with the slips that go with this one. */
static void check_verdict(const struct runs *r, enum verdict got,
                          enum verdict expected, struct check_mistake one,
                          struct check_mistake other)
{
    CHECK_NEAR(
        (double)got,
        .quantity = "what is returned (0 TOO_FEW, 1 NOT_YET, 2 MEASURED)",
        .input = input(r), .expected = expected,
        .because = check_text("it should be %s", verdict_name(expected)),
        .mistakes = {one, other});
}

static const struct check_mistake nothing = {NULL, 0.0, NULL};

static void check_measured(const struct runs *r, double p)
{
    const struct result got = measured(r);
    const struct check_mistake few = {
        "wants-three", TOO_FEW,
        "Two runs of use are enough to see an order. What is different "
        "when there are three?"};
    const struct check_mistake yet = {"wants-three", NOT_YET, few.hint};
    const bool two = sifted(r).n == 2;
    check_order(r, got.order, p);
    check_verdict(r, got.verdict, MEASURED, two ? few : nothing,
                  two ? yet : nothing);
}

/* There are no two runs of use. */
static void check_few(const struct runs *r)
{
    const struct result got = measured(r);
    check_verdict(
        r, got.verdict, TOO_FEW,
        (struct check_mistake){"rounding-counted", MEASURED,
                               "How many of these runs are of use?"},
        nothing);
    CHECK_NEAR(
        isnan(got.order), .quantity = "is *order NAN? (1 yes, 0 no)",
        .input = input(r), .expected = 1.0, .because = "there is no order",
        .question =
            "No order could be measured. What was to stand in *order then?",
        .mistakes = {
            {"order-of-nothing", 0.0,
             "There is a number in *order, or nothing was put there. What "
             "was wanted when there are no two runs of use?"}});
}

/* ---- the tests ---- */

static void test_two(void)
{
    check_ask(
        "By which factor did the step shrink, and by which the error?");
    const struct runs third = {2, 0.0, {0.3, 0.1}, {0.27, 0.03}};
    const struct runs fifth = {2, 1e-9, {1.0, 0.2}, {2.5, 0.0008}};
    const struct runs tenth = {2, 1e-9, {0.5, 0.05}, {3e-3, 3e-4}};
    check_measured(&third, 2.0);
    check_measured(&fifth, 5.0);
    check_measured(&tenth, 1.0);
}

static void test_signs(void)
{
    check_ask("An error of -1 m is as large as one of 1 m. Does your order "
              "ask for the sign?");
    const struct runs below = {2, 1e-9, {0.3, 0.1}, {-0.27, -0.03}};
    const struct runs across = {2, 1e-9, {0.4, 0.1}, {-0.64, 0.01}};
    const struct runs one = {
        4, 1e-9, {0.8, 0.4, 0.2, 0.1}, {0.0561, 0.00683, -0.0008, 0.0001}};
    check_measured(&one, 3.0);
    check_measured(&below, 2.0);
    check_measured(&across, 3.0);
}

/* Made so that the slope is 2.5 at the largest steps, and 2.1 and then 2 at
   the smallest. */
static void test_smallest(void)
{
    struct runs r = {4, 1e-12, {0.8, 0.4, 0.2, 0.05}, {0.0}};
    r.error[3] = 0.001;
    r.error[2] = r.error[3] * 16.0;
    r.error[1] = r.error[2] * pow(2.0, 2.1);
    r.error[0] = r.error[1] * pow(2.0, 2.5);
    check_ask("Large steps show terms of higher order. Which two runs are "
              "the best?");
    check_measured(&r, 2.0);
}

static void test_rounding(void)
{
    check_ask(
        "Some of these errors are mostly rounding. Which runs are of use?");
    const struct runs most = {5,
                              1e-6,
                              {0.9, 0.3, 0.1, 0.03, 0.01},
                              {0.81, 0.09, 0.01, 2e-5, -3e-7}};
    const struct runs zero = {
        4, 0.0, {0.4, 0.2, 0.1, 0.05}, {0.64, 0.08, 0.01, 0.0}};
    const struct runs within = {5,
                                1e-6,
                                {0.9, 0.3, 0.2, 0.1, 0.05},
                                {0.81, 0.09, 0.0009, 0.01, 0.00099}};
    check_measured(&most, 2.0);
    check_measured(&within, 2.0);
    check_measured(&zero, 3.0);
}

/* A little above 1000 times the rounding, just that, and a little below. */
/* limit: 1000 times the rounding */
static void test_limit(void)
{
    static const double r = 1.0 / 1024.0;
    const struct runs above = {
        2, r, {0.2, 0.1}, {8.0 * 1000.5 * r, 1000.5 * r}};
    const struct runs just = {
        3, r, {0.4, 0.2, 0.1}, {5.0, 1000.0 * r, -1000.0 * r}};
    const struct runs below = {
        3, r, {0.4, 0.2, 0.1}, {5.0, -999.5 * r, 999.5 * r}};
    check_ask("Both errors are more than 1000 times the rounding. Are they "
              "of use?");
    check_measured(&above, 3.0);
    check_ask("An error of just 1000 times the rounding is not more than "
              "that. Is it of use?");
    check_few(&just);
    check_ask("These errors are a little less than 1000 times the "
              "rounding. Are they of use?");
    check_few(&below);
}

static void test_blown_up(void)
{
    check_ask(
        "Some of these runs blew up. What do they say about the order?");
    const struct runs three = {5,
                               1e-9,
                               {1.6, 0.8, 0.4, 0.2, 0.1},
                               {INFINITY, NAN, 0.16, 0.04, 0.01}};
    const struct runs two = {
        4, 1e-9, {1.6, 0.8, 0.4, 0.2}, {NAN, -INFINITY, 0.064, 0.008}};
    const struct runs last = {
        4, 1e-9, {0.8, 0.4, 0.2, 0.1}, {0.64, 0.16, 0.04, INFINITY}};
    check_measured(&last, 2.0);
    check_measured(&three, 2.0);
    check_measured(&two, 3.0);
}

static void test_few(void)
{
    check_ask("How many of these runs are of use, and how many does an "
              "order need?");
    const struct runs none = {0, 1e-9, {0.0}, {0.0}};
    const struct runs one = {1, 1e-9, {0.1}, {0.25}};
    const struct runs rounded = {
        3, 1e-6, {0.4, 0.2, 0.1}, {0.5, 9e-4, -4e-6}};
    const struct runs blown = {
        3, 1e-6, {0.4, 0.2, 0.1}, {NAN, INFINITY, 0.01}};
    const struct runs perfect = {3, 0.0, {0.4, 0.2, 0.1}, {0.0, 0.0, 0.0}};
    check_few(&rounded);
    check_few(&none);
    check_few(&one);
    check_few(&blown);
    check_few(&perfect);
}

static void check_doubt(const struct runs *r, double p, const char *name,
                        const char *hint)
{
    const struct result got = measured(r);
    check_ask("Look at these errors from the largest step to the smallest. "
              "Do they follow one straight line on logarithmic paper, and "
              "does it fall?");
    check_order(r, got.order, p);
    check_verdict(r, got.verdict, NOT_YET,
                  (struct check_mistake){name, MEASURED, hint}, nothing);
}

/* limit: 0.5 */
static void test_constant(void)
{
    static const char hint[] =
        "The error hardly changes with the step. Which p is that, and what "
        "was to be said when it is less than 0.5?";
    const struct runs same = {3, 1e-9, {0.4, 0.2, 0.1}, {0.3, 0.3, 0.3}};
    const struct runs two = {2, 1e-9, {0.4, 0.1}, {0.4, 0.3}};
    const struct runs just = {
        2, 1e-9, {0.2, 0.1}, {0.3 * pow(2.0, 0.49), 0.3}};
    const struct runs more = {
        2, 1e-9, {0.2, 0.1}, {0.3 * pow(2.0, 0.51), 0.3}};
    const struct runs worse = {
        3, 1e-9, {0.4, 0.2, 0.1}, {0.01, 0.02, 0.04}};
    check_doubt(&two, log(4.0 / 3.0) / log(4.0), "no-convergence-unnoticed",
                hint);
    check_doubt(&just, 0.49, "no-convergence-unnoticed", hint);
    check_ask("This order is more than 0.5, and there are two runs. Is it "
              "measured?");
    check_measured(&more, 0.51);
    check_doubt(&same, 0.0, "no-convergence-unnoticed", hint);
    check_doubt(&worse, -1.0, "no-convergence-unnoticed", hint);
}

/* The same slope, 2, after one of 1, of 4, of 2.3, of 1.7; and with a run
   between that is of no use. */
/* limit: 0.2 */
static void test_doubt(void)
{
    static const double before[] = {4.0, 1.0, 2.3, 1.7, 2.21, 1.79};
    static const char hint[] =
        "The two pairs of runs have different slopes, so at least one is "
        "no order. Which run was not asked?";
    for (int i = 0; i < 6; ++i) {
        struct runs r = {3, 1e-9, {0.4, 0.2, 0.1}, {0.0, 0.04, 0.01}};
        r.error[0] = 0.04 * pow(2.0, before[i]);
        check_doubt(
            &r, 2.0,
            before[i] < 2.0 ? "order-that-grows" : "third-run-unused",
            before[i] < 2.0
                ? "The slope before this one was smaller, and that is "
                  "doubtful too. Which differences have you looked for?"
                : hint);
    }
    const struct runs gap = {
        4, 1e-9, {0.8, 0.4, 0.2, 0.1}, {0.08, NAN, 0.04, 0.01}};
    check_doubt(&gap, 2.0, "third-run-unused", hint);
}

/* Slopes that differ by less than 0.2 are none to doubt. */
CHECK_TIMES(4, test_agree, i)
{
    static const double before[] = {2.19, 1.81, 2.05, 2.0};
    check_ask("The two slopes differ by less than 0.2. Is that enough?");
    struct runs r = {3, 1e-9, {0.4, 0.2, 0.1}, {0.0, 0.04, 0.01}};
    r.error[0] = 0.04 * pow(2.0, before[i]);
    check_measured(&r, 2.0);
}

/* The leapfrog on an oscillator turns a circle by 2 asin(h/2) in each step:
   after 1 s, in ten steps and then in twice as many each time, the error
   falls as h^2 until it is lost. */
static void test_leapfrog(void)
{
    struct runs r = {.n = 26, .rounding = 2e-16};
    for (size_t i = 0; i < r.n; ++i) {
        const double steps = ldexp(10.0, (int)i);
        r.h[i] = 1.0 / steps;
        r.error[i] = cos(2.0 * steps * asin(0.5 * r.h[i])) - cos(1.0);
    }
    const struct result got = measured(&r);
    CHECK_NEAR(
        got.order, .quantity = "*order",
        .input =
            "the leapfrog on an oscillator, with steps from 0.1 s to 3 ns",
        .expected = 2.0, .tolerance = 0.02,
        .because = "rounding, less than a thousandth of the error, and a "
                   "few of them",
        .question = "The smallest steps have errors that are only "
                    "rounding. Are they passed over?",
        .mistakes = {{"rounding-counted", last_rise(&r, 0.0),
                      "Runs count here whose errors are mostly rounding. "
                      "How large must an error be to be of use?"},
                     {"rounding-counted", last_rise(&r, 1.0),
                      "Runs count here whose errors are mostly rounding. "
                      "How many times larger must an error be?"}});
    check_ask("Two pairs of runs agree. Is the order measured?");
    check_verdict(&r, got.verdict, MEASURED, nothing, nothing);
}

/* ---- drawn runs ---- */

/* Puts a run with a smaller step behind the others. */
static void add_run(struct runs *r, double error)
{
    r->h[r->n] = r->n == 0 ? check_draw(0.5, 2.0)
                           : r->h[r->n - 1] / check_draw(1.2, 3.0);
    r->error[r->n++] = error;
}

/* Runs that are of no use: these blew up, those become small later. */
static void add_useless(struct runs *r)
{
    static const double error[] = {INFINITY, -INFINITY, NAN, 0.0, 0.0};
    while (check_draw_whole(0, 2) == 0 && r->n < 30)
        add_run(r, error[check_draw_whole(0, 4)]);
}

/* Two or three runs of use, with these slopes from one to the next, and
   useless ones between them. */
static struct runs draw_runs(int count, const double slope[])
{
    struct runs r = {.n = 0};
    double error = pow(10.0, check_draw(-3.0, 3.0)), last = 0.0;
    double smallest = error;
    for (int k = 0; k < count; ++k) {
        add_useless(&r);
        add_run(&r, 1.0);
        const double h = r.h[r.n - 1];
        if (k > 0)
            error *= pow(h / last, slope[k - 1]);
        last = h;
        smallest = fmin(smallest, error);
        r.error[r.n - 1] = check_draw_whole(0, 1) ? error : -error;
    }
    add_useless(&r);
    r.rounding = smallest * check_draw(1e-7, 9e-4);
    for (size_t i = 0; i < r.n; ++i)
        if (fabs(r.error[i]) <= 0.0)
            r.error[i] = r.rounding * check_draw(-900.0, 900.0);
    return r;
}

CHECK_TIMES(50, test_drawn, i)
{
    check_ask("Which runs are of use, which two of them have the smallest "
              "steps, and does the third one agree?");
    const double p = check_draw(0.6, 8.0), off = check_draw(0.25, 1.0);
    const int count = check_draw_whole(2, 3);
    const bool doubt = count == 3 && check_draw_whole(0, 1);
    const double before = !doubt ? p + check_draw(-0.15, 0.15)
                          : check_draw_whole(0, 1) ? p + off
                                                   : p - off;
    const double slope[] = {count == 2 ? p : before, p};
    const struct runs r = draw_runs(count, slope);
    const struct result got = measured(&r);
    check_order(&r, got.order, p);
    check_verdict(&r, got.verdict, doubt ? NOT_YET : MEASURED, nothing,
                  nothing);
}

const struct check_suite check_suite = {
    .file = "08c-order.c",
    .title = "Measure an order",
    .minutes = 25,
    .equation = "eq:order",
    .tests = {{"two runs have a slope", test_two, 2, 0},
              {"errors of either sign", test_signs, 1, 0},
              {"the smallest steps count", test_smallest, 1, 0},
              {"rounding shows no order", test_rounding, 1, 0},
              {"a thousand times the rounding", test_limit, 1, 0},
              {"a run that blew up shows no order", test_blown_up, 1, 0},
              {"fewer than two runs", test_few, 1, 0},
              {"an error that does not get smaller", test_constant, 1, 0},
              {"a third run that disagrees", test_doubt, 2, 0},
              {"a third run that agrees", test_agree, 1, 0},
              {"the leapfrog, down to rounding", test_leapfrog, 1, 0},
              {"drawn runs, with useless ones between", test_drawn, 2, 3},
              {0}},
};
