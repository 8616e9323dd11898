/* The hidden tests of exercise 02b, "A sampler that looks too often". */

#include "examiner/check.h"

struct event {
    double t, x, v;
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[]);

/* The border carries one place before the samples and one behind them:
   every array here has these, too. */
enum { EVENTS = 20, SAMPLES = 200, CROWD = 4000 };

/* There and back again: the events in the opposite order, each with the
   velocity before it, turned round, at the time that was left. The ticks of
   the one are those of the other, read from the end. */
CHECK_TIMES(30, test_backwards, i)
{
    struct event path[EVENTS], back[EVENTS];
    double x[SAMPLES + 2], y[SAMPLES + 2];
    double t = 0.0, place = check_draw_whole(-64, 64);
    for (size_t e = 0; e < EVENTS; ++e) {
        const double v = check_draw_whole(-32, 32) / 4.0;
        const double flight = check_draw_whole(1, 64) / 16.0;
        path[e] = (struct event){t, place, v};
        t += flight;
        place += v * flight;
        back[EVENTS - 1 - e] = (struct event){-t, place, -v};
    }
    const double end = ceil(t); /* the last flight lasts so long */
    place += path[EVENTS - 1].v * (end - t);
    for (size_t e = 0; e < EVENTS; ++e)
        back[e].t = e > 0 ? back[e].t + end : 0.0;
    back[0].x = place;
    const double tick = end / SAMPLES;
    for (size_t k = 0; k < SAMPLES + 2; ++k)
        x[k] = y[k] = NAN;
    sample(EVENTS, path, tick, SAMPLES, x + 1);
    sample(EVENTS, back, tick, SAMPLES, y + 1);
    for (size_t k = 1; k < SAMPLES; ++k)
        CHECK_NEAR(
            y[SAMPLES - k],
            .quantity =
                check_text("x[%zu] of the path backwards", SAMPLES - k - 1),
            .unit = "m",
            .input =
                check_text("tick %g s, %d events in %g s from %g m to %g m",
                           tick, EVENTS, end, place, path[0].x),
            .expected = x[k], .tolerance = 1e-10,
            .because = "a tenth of a nanometre: both clocks are rounded");
}

/* A ball between two walls that are near to each other: hundreds of
   collisions between two ticks, all in whole numbers, and in any unit. */
CHECK_TIMES(10, test_crowd, i)
{
    static struct event path[CROWD];
    const double metre = ldexp(1.0, check_draw_whole(-40, 40));
    const double second = ldexp(1.0, check_draw_whole(-40, 40));
    const int flight = check_draw_whole(3, 30);
    const int tick = check_draw_whole(500, 5000);
    for (int e = 0; e < CROWD; ++e)
        path[e] = (struct event){e * flight * second,
                                 e % 2 ? flight * metre : 0.0,
                                 (e % 2 ? -metre : metre) / second};
    const size_t samples = (size_t)((CROWD - 1) * flight / tick);
    double x[SAMPLES + 300];
    for (size_t k = 0; k < samples + 2; ++k)
        x[k] = NAN;
    sample(CROWD, path, tick * second, samples, x + 1);
    for (size_t k = 1; k <= samples; ++k) {
        const int rest = (int)k * tick % (2 * flight);
        const int place = rest > flight ? 2 * flight - rest : rest;
        CHECK_NEAR(
            x[k], .quantity = check_text("x[%zu]", k - 1), .unit = "m",
            .input =
                check_text("tick %g s, flights of %g s over %g m",
                           tick * second, flight * second, flight * metre),
            .expected = place * metre,
            .tolerance = 8.0 * DBL_EPSILON * CROWD * flight * metre,
            .because = "8 epsilons of the whole way");
    }
}

const struct check_test check_hidden[] = {
    {"a path that is run backwards has the same samples", test_backwards, 2,
     0},
    {"hundreds of collisions between two ticks", test_crowd, 1, 0},
    {0}};
