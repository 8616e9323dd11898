/* The suite of exercise 04b: an exact decay, two points by hand, a limit,
   a clock that began elsewhere, errors that differ, points that are all
   noise, the error of the decay time, what does not decay, and decays
   drawn. */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma);

enum { MOST = 32 };

struct points {
    const char *name;
    double limit;
    size_t n;
    double t[MOST], share[MOST], error[MOST];
};

/* What the student's function answers; untouched places read as NaN. */
struct answer {
    bool told;
    double tau, sigma;
};

static struct answer answer(const struct points *p)
{
    struct answer a = {false, NAN, NAN};
    a.told = decay_time(p->n, p->t, p->share, p->error, p->limit, &a.tau,
                        &a.sigma);
    return a;
}

static const char *input(const struct points *p)
{
    return check_text("%zu points, %s, limit = %.10g", p->n, p->name,
                      p->limit);
}

/* A fit, right or wrong. The weight is y and error to these two powers;
   points up to so many errors are left out, or end it all. */
struct fit {
    int of_y, of_error;
    double cut;
    bool stops;
};

static const struct fit right = {2, -2, 3.0, false};

/* A fitted line: its slope and the sums that its error is made of. */
struct line {
    double slope, spread; /* the sum of w (t - <t>)^2 */
    double from_zero;     /* the sum of w t^2 */
    double rest;          /* the weighted squares that are left over */
    double points;
};

static struct line line(const struct points *p, struct fit f)
{
    double w[MOST], l[MOST], all = 0.0, t = 0.0, height = 0.0;
    struct line fitted = {0};
    bool open = true;
    for (size_t i = 0; i < p->n; ++i) {
        const double y = p->share[i] - p->limit, e = p->error[i];
        const bool low = !(y > 0.0 && y > f.cut * e);
        open = open && !(low && f.stops);
        l[i] = low ? 0.0 : log(y);
        w[i] = low || !open ? 0.0 : pow(y, f.of_y) * pow(e, f.of_error);
        all += w[i];
        t += w[i] * p->t[i];
        height += w[i] * l[i];
        fitted.points += w[i] > 0.0 ? 1.0 : 0.0;
    }
    t /= all;
    height /= all;
    for (size_t i = 0; i < p->n; ++i) {
        const double off = p->t[i] - t;
        fitted.spread += w[i] * off * off;
        fitted.from_zero += w[i] * p->t[i] * p->t[i];
        fitted.slope += w[i] * off * (l[i] - height);
    }
    fitted.slope /= fitted.spread;
    for (size_t i = 0; i < p->n; ++i)
        fitted.rest +=
            w[i] * pow(l[i] - height - fitted.slope * (p->t[i] - t), 2.0);
    return fitted;
}

static double time_of(const struct points *p, struct fit f)
{
    return -1.0 / line(p, f).slope;
}

/* The same as if the limit were 0. */
static double without_limit(const struct points *p)
{
    struct points q = *p;
    q.limit = 0.0;
    return time_of(&q, right);
}

static const double share_of_rounding = 1e-10;
static const char because[] =
    "1e-10 of it: rounding, and sums of large numbers that nearly cancel";

static bool check_told(const struct points *p)
{
    return CHECK_NEAR(answer(p).told ? 1.0 : 0.0,
                      .quantity =
                          "what is returned: is there a decay time? "
                          "(1 true, 0 false)",
                      .input = input(p), .expected = 1.0, .tolerance = 0.0,
                      .because = "yes or no", .equation = "eq:decay",
                      .question = "These points fall. Which of your tests "
                                  "turns them away?");
}

static bool check_weights(const struct points *p, double expected,
                          const char *question)
{
    return check_told(p) &&
           CHECK_NEAR(
               answer(p).tau, .quantity = "decay time tau", .unit = "s",
               .input = input(p), .expected = expected,
               .tolerance = share_of_rounding * expected,
               .because = because, .equation = "eq:decay",
               .question = question,
               .mistakes = {
                   {"unweighted",
                    time_of(p, (struct fit){0, 0, 3.0, false}),
                    "All points count the same here. Is the last logarithm "
                    "known as well as the first?"},
                   {"weights-upside-down",
                    time_of(p, (struct fit){-2, 2, 3.0, false}),
                    "The worst points hold the line here. Should a large "
                    "error make a weight large?"},
                   {"error-of-the-share",
                    time_of(p, (struct fit){0, -2, 3.0, false}),
                    "These weights come from the errors of the shares. The "
                    "line goes through logarithms: what error has the "
                    "logarithm of y when y has the error e?"},
                   {"weights-not-squared",
                    time_of(p, (struct fit){1, -1, 3.0, false}),
                    "A point that is known twice as well is worth four "
                    "others. How does the weight go with the error?"}});
}

/* Points that lie on a decay without any noise: every weight gives the
   same line. */
static bool check_exact(const struct points *p, double expected,
                        const char *question)
{
    return check_told(p) &&
           CHECK_NEAR(
               answer(p).tau, .quantity = "decay time tau", .unit = "s",
               .input = input(p), .expected = expected,
               .tolerance = share_of_rounding * expected,
               .because = because, .equation = "eq:decay",
               .question = question,
               .mistakes = {
                   {"rate-for-time", 1.0 / expected,
                    "This is the rate of the decay. Which unit has the "
                    "slope of the line, and which has tau?"},
                   {"sign-of-the-slope", -expected,
                    "The size is right. The line falls, so which sign has "
                    "its slope, and which should tau have?"},
                   {"log-of-ten", expected * log(10.0),
                    "After this time a tenth is left. Which logarithm "
                    "belongs to exp()?"},
                   {"half-life", expected * log(2.0),
                    "After this time one half is left. What share is left "
                    "after tau?"},
                   {"limit-forgotten", without_limit(p),
                    "The share falls to its limit and not to zero. Of "
                    "which quantity is the logarithm a straight line?"},
                   {"left-empty", NAN,
                    "Not a number: was something put into *tau?"}});
}

/* A decay from 0.16 above the limit. */
static struct points decay(const char *name, double limit, double tau,
                           double begin)
{
    struct points p = {.name = name, .limit = limit, .n = 12};
    for (size_t i = 0; i < p.n; ++i) {
        p.t[i] = begin + 40.0 * (double)i;
        p.share[i] = limit + 0.16 * exp(-40.0 * (double)i / tau);
        p.error[i] = 0.001;
    }
    return p;
}

static void test_exact(void)
{
    const struct points p =
        decay("an exact decay to zero", 0.0, 215.0, 0.0);
    check_exact(&p, 215.0,
                "The logarithms of these shares lie on a straight line. "
                "How is its slope tied to tau?");
}

static struct points two_points(void)
{
    return (struct points){.name = "an excess of 1 at 0 s and 1/2 at 100 s",
                           .n = 2,
                           .t = {0.0, 100.0},
                           .share = {1.0, 0.5},
                           .error = {0.01, 0.01}};
}

static void test_two(void)
{
    const struct points p = two_points();
    check_exact(&p, 100.0 / log(2.0),
                "A line through two points: work it out on paper.");
}

static void test_short(void)
{
    const struct points p = {.name = "an excess that halves every 1e-6 s",
                             .n = 3,
                             .t = {0.0, 1e-6, 2e-6},
                             .share = {1.0, 0.5, 0.25},
                             .error = {0.01, 0.01, 0.01}};
    check_exact(&p, 1e-6 / log(2.0),
                "A decay within microseconds. Is there a number in your "
                "function that belongs to seconds only?");
}

static void test_limit(void)
{
    const struct points p =
        decay("an exact decay", 1.0 / 11.0, 215.0, 50.0);
    check_exact(&p, 215.0,
                "The shares fall to a limit. What is it that falls to "
                "zero?");
}

static void test_clock(void)
{
    const struct points p = decay("an exact decay, begun at t = -3000 s",
                                  1.0 / 11.0, 320.0, -3000.0);
    check_exact(&p, 320.0,
                "Only differences of times can matter. Where do yours "
                "begin?");
}

/* As measured: a decay from 0.16 above 1/11 with tau = 215 s, and noise. */
static struct points measured(void)
{
    return (struct points){
        .name = "measured with errors that differ",
        .limit = 1.0 / 11.0,
        .n = 10,
        .t = {50, 100, 150, 200, 250, 300, 350, 450, 500, 550},
        .share = {0.2203, 0.1972, 0.1706, 0.1494, 0.1387, 0.1307, 0.1208,
                  0.1110, 0.1071, 0.1041},
        .error = {0.002, 0.004, 0.0015, 0.006, 0.002, 0.004, 0.0015, 0.002,
                  0.004, 0.0015}};
}

/* The same with the points that are all noise, in between and after. */
static struct points with_low_points(void)
{
    return (struct points){
        .name = "measured, some below 3 errors",
        .limit = 1.0 / 11.0,
        .n = 18,
        .t = {50, 100, 150, 200, 250, 300, 350, 400, 450, 500, 550, 600,
              650, 700, 750, 800, 1600, 2400},
        .share = {0.2203, 0.1972, 0.1706, 0.1494, 0.1387, 0.1307, 0.1208,
                  0.1072, 0.1110, 0.1071, 0.1041, 0.0952, 0.0987, 0.0968,
                  0.0898, 0.0969, 0.0990, 0.0871},
        .error = {0.002, 0.004, 0.0015, 0.006, 0.002, 0.004, 0.0015, 0.006,
                  0.002, 0.004, 0.0015, 0.006, 0.004, 0.004, 0.004, 0.004,
                  0.004, 0.004}};
}

static void test_weights(void)
{
    const struct points p = measured();
    check_weights(&p, time_of(&p, right),
                  "Each point has an error of its own. How large is the "
                  "error of its logarithm, and which weight does it get?");
}

static void test_low_points(void)
{
    const struct points p = with_low_points();
    const double expected = time_of(&p, right);
    (void)(check_told(&p) &&
           CHECK_NEAR(
               answer(&p).tau, .quantity = "decay time tau", .unit = "s",
               .input = input(&p), .expected = expected,
               .tolerance = share_of_rounding * expected,
               .because = because, .equation = "eq:decay",
               .question = "The points of the test before, and some with "
                           "an excess of less than 3 errors. Which of them "
                           "still come in?",
               .mistakes = {
                   {"all-points-kept",
                    time_of(&p, (struct fit){2, -2, 0.0, false}),
                    "Every point with a positive excess was kept. Where "
                    "all is noise, which half of the points is that, and "
                    "which way do they turn the line?"},
                   {"stops-at-a-low-point",
                    time_of(&p, (struct fit){2, -2, 3.0, true}),
                    "Your function ends at the first point that is too "
                    "low. Are there good ones behind it?"},
                   {"log-of-a-negative", NAN,
                    "Not a number: some of the shares are below the limit, "
                    "by chance. What is their logarithm?"}}));
}

/* An excess of just 3 errors, to the last bit, is not greater. */
static void test_just_three(void)
{
    static const char why[] =
        "The last point has an excess of just 3 errors. Is that greater "
        "than 3 errors?";
    const struct points p = {
        .name = "an excess of 1, 1/2 and 3/8 with errors of 1/8 each",
        .limit = 0.25,
        .n = 3,
        .t = {0.0, 10.0, 20.0},
        .share = {1.25, 0.75, 0.625},
        .error = {0.125, 0.125, 0.125}};
    const double expected = 10.0 / log(2.0);
    (void)(check_told(&p) &&
           CHECK_NEAR(answer(&p).tau, .quantity = "decay time tau",
                      .unit = "s", .input = input(&p), .expected = expected,
                      .tolerance = share_of_rounding * expected,
                      .because = because, .equation = "eq:decay",
                      .question = why));
}

static bool check_sigma(const struct points *p, double expected,
                        const char *question)
{
    const struct line l = line(p, right);
    const double tau = -1.0 / l.slope;
    const double scatter =
        l.points > 2.0 ? sqrt(l.rest / (l.points - 2.0)) : 1.0;
    return CHECK_NEAR(
        answer(p).sigma, .quantity = "standard error of tau", .unit = "s",
        .input = input(p), .expected = expected,
        .tolerance = share_of_rounding * expected, .because = because,
        .equation = "eq:decay", .question = question,
        .mistakes = {
            {"error-of-the-rate", 1.0 / sqrt(l.spread),
             "This is the error of the slope. When the slope changes by so "
             "much, by how much does tau?"},
            {"relative-error", tau / sqrt(l.spread),
             "This is the error as a share of tau. Which unit should it "
             "have?"},
            {"sigma-squared", expected * expected,
             "This is the square of the error. Which unit should it "
             "have?"},
            {"intercept-taken-as-known", tau * tau / sqrt(l.from_zero),
             "Your line can turn only about its point at t = 0, as if that "
             "were known. About which point does the best line turn?"},
            {"from-the-scatter", expected * scatter,
             "This error comes from how far the points are off the line. "
             "What do the errors say that were given with the points?"},
            {"left-empty", NAN,
             "Not a number: was something put into *sigma?"}});
}

/* By hand: the logarithms of the two points have the errors 0.01 and 0.02,
   and the slope the error of their difference over 100 s. */
static void test_sigma(void)
{
    static const char question[] =
        "How well is the slope known, and what does that mean for tau?";
    const struct points two = two_points();
    const struct points p = measured(), q = with_low_points();
    const double tau = time_of(&p, right);
    const double expected = tau * tau / sqrt(line(&p, right).spread);
    const double by_hand =
        pow(100.0 / log(2.0), 2.0) * sqrt(0.0005) / 100.0;
    (void)(check_sigma(&two, by_hand,
                       "What are the errors of the two logarithms, and "
                       "what is that of their difference?") &&
           check_sigma(&p, expected, question) &&
           check_sigma(&q, expected, question));
}

static bool check_refused(const struct points *p, const char *mistake,
                          const char *why)
{
    return CHECK_NEAR(answer(p).told ? 1.0 : 0.0,
                      .quantity =
                          "what is returned: is there a decay time? "
                          "(1 true, 0 false)",
                      .input = input(p), .expected = 0.0, .tolerance = 0.0,
                      .because = "yes or no", .equation = "eq:decay",
                      .question = why, .mistakes = {{mistake, 1.0, why}});
}

static void test_too_few(void)
{
    static const char why[] =
        "How many different times are left, and how many does a line "
        "need?";
    const struct points one = {.name = "a single one above 3 errors",
                               .n = 3,
                               .t = {0.0, 10.0, 20.0},
                               .share = {0.5, 0.01, -0.01},
                               .error = {0.01, 0.01, 0.01}};
    const struct points same = {.name = "all at the same time",
                                .n = 2,
                                .t = {4.0, 4.0},
                                .share = {0.5, 0.25},
                                .error = {0.01, 0.01}};
    const struct points none = {.name = "all of them noise",
                                .n = 2,
                                .t = {0.0, 4.0},
                                .share = {0.01, -0.01},
                                .error = {0.01, 0.01}};
    (void)(check_refused(&one, "never-refuses", why) &&
           check_refused(&same, "never-refuses", why) &&
           check_refused(&none, "never-refuses", why));
}

/* What is drawn, and what follows from it. */
struct drawn {
    struct points p;
    double tau, sigma;
};

static void put(struct points *p, double t, double share, double error)
{
    const size_t to = (size_t)check_draw_whole(0, (int)p->n);
    p->t[p->n] = p->t[to], p->t[to] = t;
    p->share[p->n] = p->share[to], p->share[to] = share;
    p->error[p->n] = p->error[to], p->error[to] = error;
    ++p->n;
}

static const char *listed(const char *name, const double x[], size_t n)
{
    const char *list = check_text("%s = {%.17g", name, x[0]);
    for (size_t i = 1; i < n; ++i)
        list = check_text("%s, %.17g", list, x[i]);
    return check_text("%s}", list);
}

/* The points lie in pairs, as long before some time as after it, and both
   of a pair have the same weight. Each pair is lifted off the line, and
   turned about its middle; the last is turned back by so much that all
   turns, times their weights and distances, add up to nothing. So the best
   line has the slope that we began with, and the weights give its error.
   Two points that are all noise come on top; the order is any. */
static void draw_pairs(struct drawn *d, double rate)
{
    const double middle = check_draw_whole(-2000, 4000);
    const double height = check_draw(0.05, 0.4);
    double spread = 0.0, turned = 0.0;
    *d = (struct drawn){.tau = 1.0 / rate};
    d->p.limit = check_draw(0.0, 0.4);
    for (int k = 1; k <= 3; ++k) {
        const double sure =
            check_draw(k < 3 ? 3.1 : 25.0, k == 2 ? 4.0 : 50.0);
        const double far = floor(d->tau * (k - check_draw(0.1, 0.7)) * 0.6);
        const double lever = sure * sure * far;
        const double lift = check_draw(-0.3, 0.3);
        const double turn = k < 3 ? check_draw(-0.3, 0.3) : -turned / lever;
        turned += lever * turn;
        spread += 2.0 * lever * far;
        for (int side = -1; side <= 1; side += 2) {
            const double off = lift + side * turn - side * far * rate;
            const double y = height * exp(off);
            put(&d->p, middle + side * far, d->p.limit + y, y / sure);
        }
    }
    for (int k = 0; k < 2; ++k) {
        const double error = check_draw(0.01, 0.02);
        put(&d->p, middle + check_draw_whole(-900, 900),
            d->p.limit + error * check_draw(-2.0, 2.5), error);
    }
    d->sigma = d->tau * d->tau / sqrt(spread);
    d->p.name = check_text("%s s, %s, %s", listed("t", d->p.t, d->p.n),
                           listed("share", d->p.share, d->p.n),
                           listed("error", d->p.error, d->p.n));
}

static void test_drawn(void)
{
    struct drawn d;
    for (int i = 0; i < 30; ++i) {
        draw_pairs(&d, 1.0 / check_draw(50.0, 900.0));
        if (!check_weights(&d.p, d.tau,
                           "Which points are left out here, and which "
                           "weight has each of the others?"))
            return;
    }
}

static void test_drawn_error(void)
{
    struct drawn d;
    for (int i = 0; i < 30; ++i) {
        draw_pairs(&d, 1.0 / check_draw(50.0, 900.0));
        if (!check_sigma(&d.p, d.sigma,
                         "How well do the weights fix the slope, and what "
                         "does that mean for tau?"))
            return;
    }
}

static void test_growth(void)
{
    static const char why[] =
        "These shares rise. What would a negative decay time mean?";
    const struct points p = {.name = "shares that rise",
                             .n = 3,
                             .t = {0.0, 10.0, 20.0},
                             .share = {0.1, 0.2, 0.4},
                             .error = {0.01, 0.01, 0.01}};
    const struct points fast = {.name = "shares that double every 1e-6 s",
                                .n = 3,
                                .t = {0.0, 1e-6, 2e-6},
                                .share = {0.1, 0.2, 0.4},
                                .error = {0.01, 0.01, 0.01}};
    const struct points level = {.name = "an excess that stays 1",
                                 .limit = 0.25,
                                 .n = 3,
                                 .t = {0.0, 10.0, 20.0},
                                 .share = {1.25, 1.25, 1.25},
                                 .error = {0.01, 0.01, 0.01}};
    struct drawn d;
    bool passed = check_refused(&p, "growth-for-decay", why) &&
                  check_refused(&fast, "growth-for-decay", why) &&
                  check_refused(&level, "growth-for-decay",
                                "These shares stay what they are. When "
                                "would they have fallen?");
    for (int i = 0; passed && i < 20; ++i) {
        draw_pairs(&d, -1.0 / check_draw(50.0, 900.0));
        passed = check_refused(&d.p, "growth-for-decay", why);
    }
}

const struct check_suite check_suite = {
    .file = "04b-decay.c",
    .title = "A decay time from noisy shares",
    .minutes = 35,
    .tests =
        {{"an exact decay to zero has its decay time", test_exact, 1, 0},
         {"two points are as worked out by hand", test_two, 1, 0},
         {"a decay to a limit has its decay time", test_limit, 1, 0},
         {"it does not matter when the clock began", test_clock, 1, 0},
         {"a decay within microseconds is one", test_short, 1, 0},
         {"well known points count for more", test_weights, 2, 0},
         {"points that are all noise are left out", test_low_points, 2, 0},
         {"three errors are not more than three", test_just_three, 1, 0},
         {"the error comes from the errors given", test_sigma, 2, 0},
         {"too few points tell nothing", test_too_few, 1, 0},
         {"what rises does not decay", test_growth, 1, 1},
         {"pairs of points that balance do not turn the line", test_drawn,
          3, 3},
         {"pairs of points fix the error", test_drawn_error, 2, 2},
         {0}},
    .idle = {test_too_few, test_growth},
};
