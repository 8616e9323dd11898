/* The hidden tests of exercise 07b, "Pressure without walls". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 200 };

/* A record, with one place behind it. */
struct record {
    int dimensions, axis;
    double box[3], energy, time;
    size_t n, count;
    struct collision c[MOST + 1];
};

/* What has been got must be Z and P, but for a rounding of each collision
   and a few of the rest. */
static void check(const struct record *r, double z)
{
    double pressure = NAN, volume = r->box[0] * r->box[1];
    const double got =
        compressibility(r->dimensions, r->box, r->n, r->energy, r->time,
                        r->count, r->c, &pressure);
    const double few = (64.0 + 4.0 * (double)r->count) * DBL_EPSILON;
    const char *input = check_text(
        "%d dimensions, n = %zu, %zu collisions along axis %d, masses %g "
        "and %g kg, box %g m by %g m by %g m, %g J, %g s",
        r->dimensions, r->n, r->count, r->axis, r->c[0].mass[0],
        r->c[0].mass[1], r->box[0], r->box[1], r->box[2], r->energy,
        r->time);
    if (r->dimensions == 3)
        volume *= r->box[2];
    const double free = r->dimensions * ((double)r->n - 1.0);
    const double p = z * (double)r->n * 2.0 * r->energy / free / volume;
    CHECK_NEAR(got, .quantity = "Z", .input = input, .expected = z,
               .tolerance = few * z,
               .because = "4 epsilons for each collision, 64 for the rest");
    CHECK_NEAR(pressure, .quantity = "*pressure",
               .unit = r->dimensions == 3 ? "N/m^2" : "N/m", .input = input,
               .expected = p, .tolerance = few * p,
               .because = "4 epsilons for each collision, 64 for the rest");
}

/* A box in which nothing has happened, in units of m, s and kg. */
static struct record draw_box(double m, double s, double kg)
{
    struct record r = {.dimensions = check_draw_whole(2, 3),
                       .n = (size_t)check_draw_whole(2, 1000),
                       .energy =
                           check_draw(0.1, 90.0) * kg * m * m / (s * s),
                       .time = check_draw(0.1, 20.0) * s,
                       .c = {{{kg, kg}, {m, m, m}, {m / s, 0, 0}, {0}}}};
    for (int k = 0; k < 3; ++k)
        r.box[k] = check_draw(5.0, 9.0) * m;
    return r;
}

static double draw_unit(void)
{
    return ldexp(1.0, check_draw_whole(-40, 40));
}

CHECK_TIMES(20, test_none, i)
{
    const double m = draw_unit(), s = draw_unit(), kg = draw_unit();
    const struct record r = draw_box(m, s, kg);
    check(&r, 1.0);
}

/* Two that meet, and meet again across the seam, with zero momentum and the
   relative velocity u: the way between two collisions is the side less
   twice the distance sigma of their centres. So in the time of `count`
   collisions Z is (side - sigma)/(side - 2 sigma), in the plane and in
   space, whatever the masses. */
static struct record to_and_fro(double m, double s, double kg, double *z)
{
    struct record r = draw_box(m, s, kg);
    const double sigma = check_draw(0.1, 2.0) * m;
    const double u = check_draw(0.1, 5.0) * m / s;
    const double m0 = kg, m1 = kg * pow(10.0, check_draw(-3.0, 3.0));
    r.n = 2;
    r.axis = check_draw_whole(0, r.dimensions - 1);
    r.count = (size_t)check_draw_whole(1, MOST);
    const double left = r.box[r.axis] - 2.0 * sigma;
    r.energy = 0.5 * u * u * m0 / (1.0 + m0 / m1);
    r.time = (double)r.count * left / u;
    for (size_t i = 0; i <= r.count; ++i) {
        const double way = i % 2 ? -1.0 : 1.0;
        struct collision c = {{m0, m1}, {0}, {0}, {0}};
        c.apart[r.axis] = way * sigma;
        c.first[r.axis] = way * u * m1 / (m0 + m1);
        c.second[r.axis] = -way * u * m0 / (m0 + m1);
        r.c[i] = c;
    }
    *z = 1.0 + sigma / left;
    return r;
}

CHECK_TIMES(30, test_to_and_fro, i)
{
    double z;
    const struct record r =
        to_and_fro(draw_unit(), draw_unit(), draw_unit(), &z);
    check(&r, z);
}

const struct check_test check_hidden[] = {
    {"two that go to and fro, in any unit", test_to_and_fro, 3, 0},
    {"a gas of any size without collisions", test_none, 1, 0},
    {0}};
