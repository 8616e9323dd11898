/* What the grader also asks of exercise 04b: another clock and other units,
   errors that are all larger, and points measured twice. */

#include "examiner/check.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma);

enum { MOST = 48 };

struct points {
    size_t n;
    double limit, t[MOST], share[MOST], error[MOST];
};

/* A noisy decay, and its decay time; every excess is clearly above 3 errors
   or clearly below, also when errors are half as large again. */
static double draw_points(struct points *p, double noise)
{
    const double tau = check_draw(80.0, 600.0);
    p->limit = check_draw(0.0, 0.3);
    p->n = (size_t)check_draw_whole(6, MOST / 2);
    for (size_t i = 0; i < p->n; ++i) {
        const double y = 0.3 * exp(noise * check_draw(-0.2, 0.2) -
                                   2.5 * (double)i / p->n);
        const bool low = i > 3 && check_draw_whole(0, 4) == 0;
        p->t[i] = 2.5 * tau * (double)i / p->n;
        p->share[i] = p->limit + y;
        p->error[i] =
            y / (low ? check_draw(0.5, 2.8) : check_draw(5.0, 60.0));
    }
    return tau;
}

struct answer {
    double tau, sigma;
};

/* NaN where there is none: all these decay. */
static struct answer answer(const struct points *p)
{
    struct answer a = {NAN, NAN};
    if (!decay_time(p->n, p->t, p->share, p->error, p->limit, &a.tau,
                    &a.sigma))
        a.tau = a.sigma = NAN;
    return a;
}

static bool check_same(const char *quantity, const struct points *p,
                       double got, double expected)
{
    return CHECK_NEAR(
        got, .quantity = quantity, .unit = "s",
        .input = check_text("%zu points of a noisy decay, limit = %g", p->n,
                            p->limit),
        .expected = expected, .tolerance = 1e-9 * expected,
        .because = "1e-9 of it: rounding, twice over",
        .equation = "eq:decay",
        .question = "The same decay, told in two ways, has two answers. "
                    "Does yours depend on a unit, on where the clock "
                    "begins, or on how many errors you were given?");
}

/* Milliseconds, another beginning, per mille for shares, and the last point
   first. */
static void test_units(void)
{
    struct points p, q;
    for (int i = 0; i < 20; ++i) {
        const double tau = draw_points(&p, 0.0);
        if (!check_same("tau of points without noise", &p, answer(&p).tau,
                        tau))
            return;
        draw_points(&p, 1.0);
        const double begin = check_draw_whole(-3000, 3000);
        q = p;
        q.limit *= 1000.0;
        for (size_t k = 0; k < p.n; ++k) {
            const size_t from = p.n - 1 - k;
            q.t[k] = 1000.0 * (p.t[from] + begin);
            q.share[k] = 1000.0 * p.share[from];
            q.error[k] = 1000.0 * p.error[from];
        }
        const struct answer a = answer(&p), b = answer(&q);
        if (!(check_same("tau from milliseconds and shares in per mille",
                         &p, b.tau / 1000.0, a.tau) &&
              check_same("sigma from milliseconds and shares in per mille",
                         &p, b.sigma / 1000.0, a.sigma)))
            return;
    }
}

/* Larger errors make tau less certain and leave it what it is; all points
   twice make it more certain. */
static void test_errors(void)
{
    struct points p, q;
    for (int i = 0; i < 20; ++i) {
        draw_points(&p, 1.0);
        q = p;
        for (size_t k = 0; k < p.n; ++k)
            q.error[k] *= 1.5;
        const struct answer a = answer(&p), b = answer(&q);
        if (!(check_same("tau with all errors half as large again", &p,
                         b.tau, a.tau) &&
              check_same("sigma with all errors half as large again", &p,
                         b.sigma, 1.5 * a.sigma)))
            return;
        q = p;
        for (size_t k = 0; k < p.n; ++k) {
            q.t[p.n + k] = p.t[k];
            q.share[p.n + k] = p.share[k];
            q.error[p.n + k] = p.error[k];
        }
        q.n = 2 * p.n;
        const struct answer c = answer(&q);
        if (!(check_same("tau with every point twice", &p, c.tau, a.tau) &&
              check_same("sigma with every point twice", &p, c.sigma,
                         a.sigma / sqrt(2.0))))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"another clock and other units change nothing", test_units, 2, 0},
    {"the error goes with the errors given and their number", test_errors,
     2, 0},
    {0}};
