/* The hidden tests of exercise 05a, "The time to a round wall". */

#include "examiner/check.h"
#include "call.h"

struct flight {
    double box, radius, r[2], v[2];
};

/* Well inside, and not along the wall: the path passes the centre at less
   than 0.8 of the greatest distance. */
static struct flight draw_flight(void)
{
    struct flight f = {check_draw(1.0, 20.0), 0.0, {0.0}, {0.0}};
    f.radius = check_draw(0.05 * f.box, 0.7 * f.box);
    const double far = (f.box - f.radius) * check_draw(0.0, 0.8);
    const double where = check_draw(-3.1416, 3.1416);
    const double way = check_draw(-3.1416, 3.1416);
    const double speed = check_draw(0.01, 50.0);
    f.r[0] = far * cos(where);
    f.r[1] = far * sin(where);
    f.v[0] = speed * cos(way);
    f.v[1] = speed * sin(way);
    return f;
}

static double speed(const struct flight *f)
{
    return hypot(f->v[0], f->v[1]);
}

/* The unit gives lengths, the pace velocities; turned, the flight is what
   somebody sees who stands on his head or looks from below. */
static double answer(const struct flight *f, double unit, double pace,
                     int turned)
{
    const double x = f->r[0] * unit, y = f->r[1] * unit;
    const double u = f->v[0] * pace, w = f->v[1] * pace;
    const double r[4][2] = {{x, y}, {-y, x}, {-x, y}, {y, x}};
    const double v[4][2] = {{u, w}, {-w, u}, {-u, w}, {w, u}};
    return round_wall_time(f->box * unit, f->radius * unit, r[turned],
                           v[turned]);
}

static void check_same(const char *quantity, const struct flight *f,
                       double got, double expected)
{
    CHECK_NEAR(got, .quantity = quantity, .unit = "s",
               .input = check_text("box = %g m, radius = %g m, r = {%.17g, "
                                   "%.17g} m, v = {%.17g, %.17g} m/s",
                                   f->box, f->radius, f->r[0], f->r[1],
                                   f->v[0], f->v[1]),
               .expected = expected,
               .tolerance = 64.0 * DBL_EPSILON * f->box / speed(f),
               .because =
                   "64 epsilons of the time to fly the radius of the box");
}

/* Forwards and backwards together make the whole chord: by Pythagoras, half
   of it and the distance of the path from the centre make the radius of
   the circle. */
CHECK_TIMES(40, test_there_and_back, i)
{
    const struct flight f = draw_flight();
    const double both = answer(&f, 1.0, 1.0, 0) + answer(&f, 1.0, -1.0, 0);
    const double far = f.box - f.radius, v = speed(&f);
    const double beside = (f.r[0] * f.v[1] - f.r[1] * f.v[0]) / v;
    check_same("time from wall to wall: forwards and backwards", &f, both,
               2.0 * sqrt(far * far - beside * beside) / v);
}

CHECK_TIMES(40, test_turned, i)
{
    struct flight f = draw_flight();
    const double time = answer(&f, 1.0, 1.0, 0);
    const double x = f.r[0] + f.v[0] * time, y = f.r[1] + f.v[1] * time;
    check_same("from the centre to where the disk is then, at its speed",
               &f, hypot(x, y) / speed(&f), (f.box - f.radius) / speed(&f));
    check_same("0 if a disk at rest never comes to the wall", &f,
               answer(&f, 1.0, 0.0, 0) == INFINITY ? 0.0 : 1.0, 0.0);
    for (int turned = 1; turned < 4; ++turned)
        check_same("time in a box that is turned or mirrored", &f,
                   answer(&f, 1.0, 1.0, turned), time);
    check_same("time of all in millimetres and mm/s", &f,
               answer(&f, 1e3, 1e3, 1), time);
    check_same("time of all in kilometres and m/s, divided by 1000", &f,
               answer(&f, 1e-3, 1.0, 2) * 1e3, time);
    const double gone = time * check_draw(0.05, 0.9);
    f.r[0] += f.v[0] * gone;
    f.r[1] += f.v[1] * gone;
    check_same("time that is left when a part of it has gone by", &f,
               answer(&f, 1.0, 1.0, 0), time - gone);
}

const struct check_test check_hidden[] = {
    {"there and back is the whole chord", test_there_and_back, 2, 0},
    {"turned, mirrored, in other units or under way it is the same flight",
     test_turned, 2, 0},
    {0}};
