/* The hidden tests of exercise 10b, "The oscillator in closed form". */

#include "examiner/check.h"
#include "call.h"

static void check(const struct oscillator *o, double t, double got,
                  double expected, double tolerance, const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input = check_text(
                   "m = %g kg, c = %.17g kg/s, D = %.17g N/m, at first x = "
                   "%.17g m, v = %.17g m/s, t = %g s",
                   o->mass, o->damping, o->stiffness, o->x, o->v, t),
               .expected = expected, .tolerance = tolerance,
               .because = "some 1e-12 of the largest that can be expected");
}

/* Damping of any kind, in units of the critical one. */
static double draw_ratio(int kind)
{
    switch (kind % 4) {
    case 0: return check_draw(0.0, 1.0);
    case 1: return 1.0 + pow(10.0, -check_draw(1.0, 15.0));
    case 2: return 1.0 - pow(10.0, -check_draw(1.0, 15.0));
    default: return pow(10.0, check_draw(0.0, 6.0));
    }
}

static struct oscillator draw_oscillator(int kind)
{
    const double m = check_draw(0.1, 9.0), d = check_draw(0.1, 9.0);
    return (struct oscillator){m, 2.0 * sqrt(m * d) * draw_ratio(kind), d,
                               check_draw(-2.0, 2.0),
                               check_draw(-2.0, 2.0)};
}

/* It does not know when it was started: two times one after the other are
   as good as both at once. */
CHECK_TIMES(40, test_halfway, i)
{
    const struct oscillator o = draw_oscillator(i);
    const double w = sqrt(o.stiffness / o.mass);
    const double size = fabs(o.x) + fabs(o.v) / w;
    const double t = check_draw(0.0, 40.0) / w;
    const double late = check_draw(0.0, 40.0) / w;
    struct oscillator halfway = o;
    double v = NAN, both = NAN;
    halfway.x = oscillate(&o, t, &halfway.v);
    const double x = oscillate(&halfway, late, &v);
    const double at_once = oscillate(&o, t + late, &both);
    check(&o, t + late, x, at_once, 4e-12 * size,
          "place, by way of a state halfway, in m");
    check(&o, t + late, v, both, 4e-12 * w * size,
          "velocity, by way of a state halfway, in m/s");
}

/* What the energy has lost is c times the sum of v^2 over the time: that of
   Gauss with three points, over times so short that it is as good as
   exact. */
CHECK_TIMES(20, test_energy, i)
{
    const double off = sqrt(0.6);
    struct oscillator o = draw_oscillator(i);
    if (o.damping > 8.0 * sqrt(o.mass * o.stiffness))
        return;
    const double w = sqrt(o.stiffness / o.mass), step = 0.02 / w;
    double lost = 0.0, x = o.x, v = o.v, now = NAN;
    for (int k = 0; k < 100; ++k) {
        const double middle = (k + 0.5) * step;
        for (int j = -1; j <= 1; ++j) {
            (void)oscillate(&o, middle + 0.5 * step * j * off, &now);
            lost += (j ? 5.0 : 8.0) / 18.0 * step * o.damping * now * now;
        }
    }
    const double start = o.mass * v * v + o.stiffness * x * x;
    x = oscillate(&o, 100 * step, &v);
    const double end = o.mass * v * v + o.stiffness * x * x;
    check(&o, 100 * step, end + 2.0 * lost, start, 4e-9 * start,
          "twice the energy, with what was lost, in J");
}

/* The same oscillator by other clocks and scales. */
CHECK_TIMES(40, test_units, i)
{
    const struct oscillator o = draw_oscillator(i);
    const double w = sqrt(o.stiffness / o.mass);
    const double t = check_draw(0.0, 40.0) / w;
    const double kg = ldexp(1.0, check_draw_whole(-60, 60));
    const double s = ldexp(1.0, check_draw_whole(-60, 60));
    const double m = ldexp(1.0, check_draw_whole(-60, 60));
    const struct oscillator other = {o.mass * kg, o.damping * kg / s,
                                     o.stiffness * kg / (s * s), o.x * m,
                                     o.v * m / s};
    const double size = fabs(o.x) + fabs(o.v) / w;
    double v = NAN, again = NAN;
    const double x = oscillate(&o, t, &v);
    const double there = oscillate(&other, t * s, &again);
    check(&other, t * s, there / m, x, 2e-12 * size, "place, in this unit");
    check(&other, t * s, again / m * s, v, 2e-12 * w * size,
          "velocity, in this unit");
}

const struct check_test check_hidden[] = {
    {"a time cut in two", test_halfway, 2, 0},
    {"what the energy loses is turned into heat", test_energy, 1, 0},
    {"other clocks and scales", test_units, 1, 0},
    {0}};
