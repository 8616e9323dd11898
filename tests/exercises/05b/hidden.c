/* The hidden tests of exercise 05b, "Two disks that fall". */

#include "examiner/check.h"
#include "call.h"

struct pair {
    double g;
    struct thrown a, b;
};

/* Disk b comes from some way off and would pass the centre of a at no more
   than 0.8 of the contact distance. */
static struct pair draw_pair(void)
{
    struct pair p = {check_draw(0.0, 15.0),
                     {check_draw(-4.0, 4.0), check_draw(-4.0, 4.0),
                      check_draw(-5.0, 5.0), check_draw(-5.0, 5.0),
                      check_draw(0.1, 1.0)},
                     {0.0, 0.0, 0.0, 0.0, check_draw(0.1, 1.0)}};
    const double s = p.a.radius + p.b.radius;
    const double way = check_draw(-3.1416, 3.1416);
    const double speed = check_draw(0.5, 6.0);
    const double far = s * check_draw(1.2, 6.0);
    const double beside = s * check_draw(-0.8, 0.8);
    p.b.vx = p.a.vx - speed * cos(way);
    p.b.vy = p.a.vy - speed * sin(way);
    p.b.x = p.a.x + far * cos(way) + beside * sin(way);
    p.b.y = p.a.y + far * sin(way) - beside * cos(way);
    return p;
}

static const char *disk(const struct thrown *d)
{
    return check_text("(%.17g, %.17g) m, (%.17g, %.17g) m/s, radius %g m",
                      d->x, d->y, d->vx, d->vy, d->radius);
}

struct answer {
    double time, height;
};

static struct answer answer(double g, const struct thrown *a,
                            const struct thrown *b)
{
    struct answer told = {NAN, NAN};
    told.time = falling_pair_time(g, a, b, &told.height);
    return told;
}

/* Lengths and times of the order of ten metres and ten seconds, and a path
   that meets the other at an angle: some hundred epsilons; more where they
   fall far meanwhile. */
static void check_same(const char *how, const struct pair *p,
                       struct answer got, struct answer expected)
{
    const char *input = check_text("g = %g m/s^2; a: %s; b: %s", p->g,
                                   disk(&p->a), disk(&p->b));
    const double tolerance = 1e-12 * (1.0 + expected.time);
    CHECK_NEAR(got.time, .quantity = check_text("time, %s", how),
               .unit = "s", .input = input, .expected = expected.time,
               .tolerance = tolerance,
               .because = "some thousand roundings of metres",
               .equation = "eq:pair-quadratic");
    CHECK_NEAR(got.height, .quantity = check_text("height, %s", how),
               .unit = "m", .input = input, .expected = expected.height,
               .tolerance =
                   tolerance * (20.0 + p->g * (1.0 + expected.time)),
               .because = "that of the time, times the speeds",
               .equation = "eq:pair-quadratic");
}

static struct thrown scaled(struct thrown d, double unit, double mirror)
{
    return (struct thrown){d.x * unit * mirror, d.y * unit,
                           d.vx * unit * mirror, d.vy * unit,
                           d.radius * unit};
}

CHECK_TIMES(40, test_told_otherwise, i)
{
    const struct pair p = draw_pair();
    const struct answer first = answer(p.g, &p.a, &p.b);
    const double unit = i % 2 ? 1e3 : 1e-3;
    const double x = p.b.x - p.a.x + (p.b.vx - p.a.vx) * first.time;
    const double y = p.b.y - p.a.y + (p.b.vy - p.a.vy) * first.time;
    const struct thrown a = scaled(p.a, unit, -1.0);
    const struct thrown b = scaled(p.b, unit, -1.0);
    struct answer other = answer(p.g * unit, &a, &b);
    other.height /= unit;
    CHECK_NEAR(hypot(x, y),
               .quantity = "distance of the centres at the time found",
               .unit = "m",
               .input = check_text("a: %s; b: %s", disk(&p.a), disk(&p.b)),
               .expected = p.a.radius + p.b.radius,
               .tolerance = 1e-11 * (1.0 + first.time),
               .because = "that of the time, times the speed",
               .equation = "eq:pair-quadratic");
    check_same("with a and b exchanged", &p, answer(p.g, &p.b, &p.a),
               first);
    check_same(check_text("in a mirror, and with lengths in units of %g m",
                          1.0 / unit),
               &p, other, first);
}

/* After a part of the time the rest is left, and the contact is where it
   was: both have fallen meanwhile. */
CHECK_TIMES(40, test_under_way, i)
{
    const struct pair p = draw_pair();
    struct pair later = p;
    struct answer first = answer(p.g, &p.a, &p.b);
    const double gone = check_draw(0.1, 0.9) * first.time;
    struct thrown *const disks[] = {&later.a, &later.b};
    for (int k = 0; k < 2; ++k) {
        struct thrown *const d = disks[k];
        d->x += d->vx * gone;
        d->y += d->vy * gone - 0.5 * p.g * gone * gone;
        d->vy -= p.g * gone;
    }
    struct answer rest = answer(p.g, &later.a, &later.b);
    rest.time += gone;
    check_same("begun anew when a part of the way is done", &p, rest,
               first);
    CHECK_NEAR(first.time < INFINITY,
               .quantity = "do they meet? (1 yes, 0 never)",
               .expected = 1.0, .because = "yes or no");
}

const struct check_test check_hidden[] = {
    {"the two may be exchanged, mirrored and measured in other units",
     test_told_otherwise, 2, 0},
    {"a pair under way has the rest of the way to go", test_under_way, 2,
     0},
    {0}};
