/* The hidden tests of exercise 09c, "Kepler's equation". */

#include "examiner/check.h"
#include "call.h"

/* In the suite. */
void check_anomaly(double e, double mean, double solution);
double mean_of(double e, double solution, double *exact);

static const double pi = 3.141592653589793;

static void check(double got, double expected, double tolerance,
                  const char *quantity, double e, double mean)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input = check_text("e = %g, M = %.10g", e, mean),
               .expected = expected, .tolerance = tolerance,
               .because = "some epsilons, over 1 - e cos(E)");
}

/* From the angle that is seen from the sun: tan(E/2) is that of half the
   angle times sqrt((1 - e)/(1 + e)). */
CHECK_TIMES(50, test_seen, i)
{
    const double e = 1.0 - pow(10.0, check_draw(-6.0, -0.05));
    const double angle = check_draw(-3.1, 3.1);
    double exact;
    const double E =
        2.0 * atan(sqrt((1.0 - e) / (1.0 + e)) * tan(0.5 * angle));
    const double mean = mean_of(e, E, &exact);
    check_anomaly(e, mean, exact);
}

/* E - M is the same in every revolution, and changes its sign with M. */
CHECK_TIMES(30, test_again, i)
{
    const double e = check_draw(0.0, 0.99);
    const double mean = check_draw(-3.1, 3.1);
    const int turns = check_draw_whole(-1000, 1000);
    const double far = mean + 2.0 * pi * turns;
    const double here = eccentric_anomaly(e, mean) - mean;
    const double slope = 1.0 - e * cos(mean + here);
    const double size = fabs(far) + 8.0;
    check(eccentric_anomaly(e, far) - far, here,
          32.0 * DBL_EPSILON * size / slope,
          check_text("E - M after %d revolutions", turns), e, far);
    check(eccentric_anomaly(e, -mean) + mean, -here,
          32.0 * DBL_EPSILON * 8.0 / slope, "E - M for -M", e, -mean);
}

/* The later the time, the larger is E; and the area that a ray from the sun
   has swept, summed up in fine triangles, is M/2 of an ellipse with the
   half axes 1 and sqrt(1 - e^2). */
CHECK_TIMES(5, test_areas, i)
{
    enum { PARTS = 2000 };
    const double e = check_draw(0.1, 0.97), mean = check_draw(0.3, 6.0);
    const double b = sqrt(1.0 - e * e);
    const double end = eccentric_anomaly(e, mean);
    double swept = 0.0, x = 1.0 - e, y = 0.0;
    for (int k = 1; k <= PARTS; ++k) {
        const double E = end * k / PARTS;
        const double to_x = cos(E) - e, to_y = b * sin(E);
        swept += 0.5 * (x * to_y - y * to_x);
        x = to_x;
        y = to_y;
    }
    check(swept, 0.5 * b * mean, 1e-5,
          "the area that was swept from the perihelion on", e, mean);
    check(eccentric_anomaly(e, 1.001 * mean) > end, 1.0, 0.0,
          "is E larger a little later? (1 yes, 0 no)", e, 1.001 * mean);
}

const struct check_test check_hidden[] = {
    {"from the angle that is seen", test_seen, 2, 0},
    {"revolution after revolution", test_again, 1, 0},
    {"equal areas", test_areas, 1, 0},
    {0}};
