/* The hidden tests of exercise 11a, "Push two spheres apart". */

#include "examiner/check.h"
#include "call.h"

static void check(const struct sphere s[2], double got, double expected,
                  double tolerance, const char *quantity)
{
    CHECK_NEAR(
        got, .quantity = quantity, .unit = "m",
        .input = check_text("a: %g kg, radius %g m, at (%g, %g, %g) m; b: "
                            "%g kg, radius %g m, at (%g, %g, %g) m",
                            s[0].mass, s[0].radius, s[0].x[0], s[0].x[1],
                            s[0].x[2], s[1].mass, s[1].radius, s[1].x[0],
                            s[1].x[1], s[1].x[2]),
        .expected = expected, .tolerance = tolerance,
        .because = "16 epsilons of the largest of coordinates and radii");
}

/* Two that overlap, all of it in the unit given. */
static void draw_spheres(struct sphere s[2], double unit)
{
    double square;
    do {
        square = 0.0;
        for (int k = 0; k < 3; ++k) {
            s[0].x[k] = unit * check_draw_whole(-99, 99) / 16.0;
            s[1].x[k] = unit * check_draw_whole(-99, 99) / 16.0;
            square += pow((s[0].x[k] - s[1].x[k]) / unit, 2);
        }
    } while (square == 0.0);
    const double reach = unit * sqrt(square) * check_draw(1.01, 3.0);
    s[0].radius = reach * check_draw(0.01, 0.99);
    s[1].radius = reach - s[0].radius;
    s[0].mass = check_draw(0.1, 9.0);
    s[1].mass = check_draw(0.1, 9.0);
}

static double tolerance(const struct sphere s[2])
{
    double most = s[0].radius + s[1].radius;
    for (int k = 0; k < 3; ++k)
        most = fmax(most, fmax(fabs(s[0].x[k]), fabs(s[1].x[k])));
    return 16.0 * DBL_EPSILON * most;
}

static void check_same(const struct sphere before[2],
                       const struct sphere *got,
                       const struct sphere *expected, double unit,
                       const char *name)
{
    for (int k = 0; k < 3; ++k)
        check(before, got->x[k] / unit, expected->x[k], tolerance(before),
              check_text("%s, along %c", name, "xyz"[k]));
}

/* Once pushed, they touch: there is nothing left to do but rounding. */
CHECK_TIMES(30, test_again, i)
{
    struct sphere s[2], once[2];
    draw_spheres(s, 1.0);
    once[0] = s[0];
    once[1] = s[1];
    (void)part_spheres(&once[0], &once[1]);
    struct sphere twice[2] = {once[0], once[1]};
    const double depth = part_spheres(&twice[0], &twice[1]);
    check(s, depth, 0.0, tolerance(s),
          "depth of what is left of the overlap");
    check_same(s, &twice[0], &once[0], 1.0,
               "centre of a after a second push");
    check_same(s, &twice[1], &once[1], 1.0,
               "centre of b after a second push");
}

CHECK_TIMES(30, test_names, i)
{
    struct sphere s[2];
    draw_spheres(s, 1.0);
    struct sphere one[2] = {s[0], s[1]}, other[2] = {s[0], s[1]};
    const double depth = part_spheres(&one[0], &one[1]);
    const double again = part_spheres(&other[1], &other[0]);
    check(s, again, depth, tolerance(s), "depth, with the names exchanged");
    check_same(s, &other[0], &one[0], 1.0,
               "centre of a, with the names exchanged");
    check_same(s, &other[1], &one[1], 1.0,
               "centre of b, with the names exchanged");
}

/* Very heavy is as good as immovable. */
CHECK_TIMES(20, test_heavy, i)
{
    struct sphere s[2];
    draw_spheres(s, 1.0);
    const int heavy = i % 2;
    struct sphere very[2] = {s[0], s[1]}, never[2] = {s[0], s[1]};
    s[heavy].mass = very[heavy].mass = check_draw(1.0, 9.0) * 1e25;
    never[heavy].mass = INFINITY;
    (void)part_spheres(&very[0], &very[1]);
    (void)part_spheres(&never[0], &never[1]);
    check_same(s, &very[0], &never[0], 1.0,
               "centre of a, against one that is immovable");
    check_same(s, &very[1], &never[1], 1.0,
               "centre of b, against one that is immovable");
}

CHECK_TIMES(30, test_units, i)
{
    const double unit = ldexp(1.0, check_draw_whole(-200, 200));
    const double kg = ldexp(1.0, check_draw_whole(-200, 200));
    struct sphere s[2], one[2], other[2];
    draw_spheres(s, 1.0);
    for (int j = 0; j < 2; ++j) {
        one[j] = other[j] = s[j];
        other[j].mass *= kg;
        other[j].radius *= unit;
        for (int k = 0; k < 3; ++k)
            other[j].x[k] *= unit;
    }
    const double depth = part_spheres(&one[0], &one[1]);
    const double there = part_spheres(&other[0], &other[1]);
    check(s, there / unit, depth, tolerance(s),
          check_text("depth, in units of %g m and %g kg", unit, kg));
    check_same(s, &other[0], &one[0], unit, "centre of a, in other units");
    check_same(s, &other[1], &one[1], unit, "centre of b, in other units");
}

const struct check_test check_hidden[] = {
    {"a second push finds nothing to do", test_again, 1, 0},
    {"the names of the two spheres exchanged", test_names, 1, 0},
    {"very heavy is as good as immovable", test_heavy, 1, 0},
    {"spheres as large as stars, or as atoms", test_units, 1, 0},
    {0}};
