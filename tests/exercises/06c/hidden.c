/* The hidden tests of exercise 06c, "Pushed together by nothing". */

#include "examiner/check.h"
#include "call.h"

static const double pi = 3.14159265358979323846;

/* Two zones, around bodies that leave room for both distances below. */
struct zones {
    int dimensions;
    double R1, R2, small, unit, density;
};

static struct zones draw_zones(int dimensions, double unit)
{
    return (struct zones){dimensions,
                          check_draw(0.5, 2.0) * unit,
                          check_draw(0.5, 2.0) * unit,
                          check_draw(0.3, 2.0) * unit,
                          unit,
                          check_draw(0.1, 5.0) / pow(unit, dimensions)};
}

/* The distance at which the two touch, but for a part f of what is left to
   where the zones end. */
static double distance(const struct zones *z, double f)
{
    return z->R1 + z->R2 + 2.0 * z->small * f;
}

static double overlap(const struct zones *z, double f)
{
    double shared = NAN;
    (void)depletion(z->dimensions, z->R1, z->R2, z->small, z->density,
                    distance(z, f), &shared);
    return shared;
}

static const char *input(const struct zones *z, double f)
{
    return check_text("%d dimensions, R1 = %g m, R2 = %g m, small = %g m, "
                      "density %g m^-%d, r = %.10g m",
                      z->dimensions, z->R1, z->R2, z->small, z->density,
                      z->dimensions, distance(z, f));
}

/* Where two edges cross: Heron's area of the triangle of the two centres
   and the crossing is half the distance times half the chord. */
static double across(const struct zones *z, double f)
{
    const double r = distance(z, f);
    const double a = z->R1 + z->small, b = z->R2 + z->small;
    const double area =
        0.25 * sqrt((a + b + r) * (a + b - r) * (r + a - b) * (r + b - a));
    const double half = 2.0 * area / r;
    return z->dimensions == 2 ? 2.0 * half : pi * half * half;
}

/* When the distance shrinks, the overlap grows by the chord, or by the disk
   in which two spheres cross. Between two distances it grows by the
   integral of that: Gauss with five points, for part of the way only, so
   that what is integrated is smooth: the worst of 20000 drawn pairs had an
   error of 2e-9 of the result, and of 5e-8 up to where the zones end. */
static void check_growth(const struct zones *z, double near, double far)
{
    static const double x[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    static const double w[] = {0.5688888888888889, 0.4786286704993665,
                               0.2369268850561891};
    const double middle = 0.5 * (near + far), half = 0.5 * (far - near);
    double expected = w[0] * across(z, middle);
    for (int k = 1; k < 3; ++k)
        expected += w[k] * (across(z, middle - half * x[k]) +
                            across(z, middle + half * x[k]));
    expected *= half * 2.0 * z->small;
    CHECK_NEAR(
        overlap(z, near) - overlap(z, far),
        .quantity =
            check_text("by how much *overlap grows up to r = %.10g m",
                       distance(z, near)),
        .unit = z->dimensions == 2 ? "m^2" : "m^3", .input = input(z, far),
        .expected = expected, .tolerance = 1e-6 * expected,
        .because = "the error of the integral, of 5 points");
}

CHECK_TIMES(20, test_growth, i)
{
    const struct zones z = draw_zones(2 + i % 2, 1.0);
    check_growth(&z, 0.0, 0.25);
    check_growth(&z, 0.25, 0.5);
    check_growth(&z, 0.5, 0.75);
}

/* In any unit; for spheres up to where the zones end. There the growth of a
   lens of disks begins with a square root, which is not smooth. */
CHECK_TIMES(20, test_units, i)
{
    static const double unit[] = {1e3, 1e-3, 1e-9, 1e9};
    const struct zones z = draw_zones(2 + i % 2, unit[i % 4]);
    double shared = NAN;
    const double u = depletion(z.dimensions, z.R1, z.R2, z.small, z.density,
                               distance(&z, 0.25), &shared);
    check_growth(&z, 0.0, 0.25);
    if (z.dimensions == 3)
        check_growth(&z, 0.25, 1.0);
    CHECK_NEAR(u, .quantity = "the potential", .unit = "kT",
               .input = input(&z, 0.25), .expected = -z.density * shared,
               .tolerance = 1e-12 * z.density * shared,
               .because = "a multiple of kT has no unit of length");
}

const struct check_test check_hidden[] = {
    {"the lens grows by its chord", test_growth, 2, 0},
    {"in other units as well", test_units, 2, 0},
    {0}};
