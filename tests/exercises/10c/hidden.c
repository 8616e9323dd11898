/* The hidden tests of exercise 10c, "The frequencies of a membrane". */

#include "examiner/check.h"
#include <stdlib.h>
#include "call.h"

enum { MOST = 30 * 30 + 1 };

static void check(const struct grid *g, double got, double expected,
                  double tolerance, const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input =
                   check_text("%d by %d masses of %g kg, D = %g N/m, dx = "
                              "%g m, dy = %g m, rest lengths %g m and %g m",
                              g->nx, g->ny, g->mass, g->stiffness, g->dx,
                              g->dy, g->restx, g->resty),
               .expected = expected, .tolerance = tolerance,
               .because = "some 1e-12 of what is summed up");
}

static struct grid draw_any(double most)
{
    struct grid g = {check_draw_whole(3, 30), check_draw_whole(3, 30),
                     check_draw(0.1, 5.0),    check_draw(1.0, 90.0),
                     check_draw(0.1, 2.0),    check_draw(0.1, 2.0),
                     check_draw(0.0, most),   check_draw(0.0, most)};
    if (fabs(g.restx - 1.0) < 0.05)
        g.restx = 0.5;
    if (fabs(g.resty - 1.0) < 0.05)
        g.resty = 0.5;
    g.restx *= g.dx;
    g.resty *= g.dy;
    return g;
}

/* The sum of all w^2, with their signs, is that of what holds each mass:
   two springs along x and two along y. */
CHECK_TIMES(20, test_sum, i)
{
    const struct grid g = draw_any(2.0);
    const int count = (g.nx - 2) * (g.ny - 2);
    double omega[MOST], sum = 0.0, size = 0.0;
    (void)membrane_modes(&g, omega);
    for (int k = 0; k < count; ++k) {
        sum += omega[k] * fabs(omega[k]);
        size += omega[k] * omega[k];
    }
    const double x = g.stiffness / g.mass * (g.dx - g.restx) / g.dx;
    const double y = g.stiffness / g.mass * (g.dy - g.resty) / g.dy;
    size += 2.0 * count * (fabs(x) + fabs(y));
    check(&g, sum, 2.0 * count * (x + y), 4e-12 * size, "sum of all w |w|");
}

/* With no pull along y, the squares of one row of n springs, in units of
   its stiffness over the mass, multiply up to n. */
CHECK_TIMES(20, test_product, i)
{
    struct grid g = draw_any(0.9);
    g.resty = g.dy;
    const double x = g.stiffness / g.mass * (g.dx - g.restx) / g.dx;
    double omega[MOST], product = 1.0;
    (void)membrane_modes(&g, omega);
    const int row = check_draw_whole(0, g.ny - 3);
    for (int k = 0; k < g.nx - 2; ++k)
        product *=
            omega[row * (g.nx - 2) + k] * omega[row * (g.nx - 2) + k] / x;
    check(&g, product, g.nx - 1.0, 1e-10 * g.nx,
          "product of all w^2 of a row, in units of its stiffness over the "
          "mass");
}

/* A grid that lies on its other side has the same modes, with r and s
   exchanged, and the same step. */
CHECK_TIMES(20, test_side, i)
{
    const struct grid g = draw_any(i % 2 ? 2.0 : 0.9);
    const struct grid other = {g.ny, g.nx, g.mass,  g.stiffness,
                               g.dy, g.dx, g.resty, g.restx};
    double omega[MOST], turned[MOST];
    const double step = membrane_modes(&g, omega);
    const double again = membrane_modes(&other, turned);
    const double top =
        sqrt(8.0 * g.stiffness / g.mass *
             (fabs(1.0 - g.restx / g.dx) + fabs(1.0 - g.resty / g.dy)));
    for (int s = 0; s < g.ny - 2; ++s)
        for (int r = 0; r < g.nx - 2; ++r) {
            const double w = omega[s * (g.nx - 2) + r];
            const double t = turned[r * (g.ny - 2) + s];
            check(&g, w * fabs(w) - t * fabs(t), 0.0, 4e-12 * top * top,
                  "difference of a square, with the axes exchanged");
        }
    if (isfinite(step) || isfinite(again))
        check(&g, again / step, 1.0, 1e-11,
              "time step with the axes exchanged over that without");
}

/* In other units the same grid has the same frequencies. */
CHECK_TIMES(10, test_units, i)
{
    const struct grid g = draw_any(0.9);
    const double m = ldexp(1.0, check_draw_whole(-40, 40));
    const double kg = ldexp(1.0, check_draw_whole(-40, 40));
    const double s = ldexp(1.0, check_draw_whole(-40, 40));
    struct grid other = g;
    other.mass *= kg;
    other.stiffness *= kg / (s * s);
    other.dx *= m;
    other.dy *= m;
    other.restx *= m;
    other.resty *= m;
    double omega[MOST], again[MOST];
    const double step = membrane_modes(&g, omega);
    const double there = membrane_modes(&other, again);
    for (int k = 0; k < (g.nx - 2) * (g.ny - 2); ++k)
        check(&other, again[k] * s, omega[k], 4e-12 * omega[k],
              "frequency, in another unit");
    check(&other, there / s, step, 4e-12 * step,
          "time step, in another unit");
}

const struct check_test check_hidden[] = {
    {"the squares of all frequencies add up", test_sum, 1, 0},
    {"those of a row multiply up", test_product, 1, 0},
    {"a grid on its other side", test_side, 1, 0},
    {"a grid in other units", test_units, 1, 0},
    {0}};
