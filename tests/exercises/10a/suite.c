/* The suite of exercise 10a, "A dashpot along the axis". */

#include "examiner/check.h"
#include "call.h"

/* Two bodies, and what is expected of the dashpot between them. */
struct pair {
    double c;
    struct body a, b;
    double on_a[3], heat;
};

struct answer {
    double on_a[3], on_b[3], heat;
};

static const char *vector(const double v[3])
{
    return check_text("(%g, %g, %g)", v[0], v[1], v[2]);
}

/* What the student's function answers; untouched places read as NaN. */
static struct answer answer(const struct pair *p)
{
    check_about(check_text(
        "c = %g kg/s, a at %s m with %s m/s, b at %s m with %s m/s", p->c,
        vector(p->a.x), vector(p->a.v), vector(p->b.x), vector(p->b.v)));
    struct answer r = {{CHECK_EMPTY, CHECK_EMPTY, CHECK_EMPTY},
                       {CHECK_EMPTY, CHECK_EMPTY, CHECK_EMPTY},
                       CHECK_EMPTY};
    const struct body a = p->a, b = p->b;
    r.heat = dashpot(p->c, &a, &b, r.on_a, r.on_b);
    return r;
}

static double dot(const double p[3], const double q[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
        sum += p[k] * q[k];
    return sum;
}

/* From a to b: the place and the velocity that a sees. */
static struct body seen(const struct pair *p)
{
    struct body s;
    for (int k = 0; k < 3; ++k) {
        s.x[k] = p->b.x[k] - p->a.x[k];
        s.v[k] = p->b.v[k] - p->a.v[k];
    }
    return s;
}

/* The terms of c (u n) n are c u at most. A product of two vectors adds
   four roundings, and so does their length; we allow 16 in all. */
static double tolerance(const struct pair *p)
{
    const struct body s = seen(p);
    return 16.0 * DBL_EPSILON * p->c * sqrt(dot(s.v, s.v));
}

static const char because[] = "16 epsilons of c times the relative speed";

/* The force on body a along axis k. */
static void check_force(const struct pair *p, double got, int k)
{
    const double right = p->on_a[k];
    const struct body s = seen(p);
    const double square = dot(s.x, s.x), r = sqrt(square);
    const double whole = p->c * s.v[k];
    const double own = dot(s.x, p->b.v) / square;
    const double speed =
        r > 0.0 ? p->c * sqrt(dot(s.v, s.v)) * s.x[k] / r : right;
    CHECK_NEAR(
        got,
        .quantity =
            check_text("on_a[%d], the force on a along %c", k, "xyz"[k]),
        .unit = "N", .expected = right, .tolerance = tolerance(p),
        .because = because,
        .mistakes = {
            {"no-axis", r > 0.0 ? NAN : CHECK_NAN,
             "Not a number: is every place filled in, and what do you "
             "divide by when the two are at the same place?"},
            {"whole-velocity", whole,
             "This is c times the whole relative velocity: the printed "
             "damper. Which part of it changes the distance of the two?"},
            {"axis-too-long", right * r,
             "The force grows with the distance here. How long is the "
             "vector that gives the direction, and how long should it be?"},
            {"axis-too-long", right * square,
             "The force grows with the square of the distance here. How "
             "long is the vector that gives the direction? It stands in "
             "the formula twice."},
            {"across-the-axis", right == 0.0 ? right : whole - right,
             "This is the part of the velocity across the axis: the one "
             "that turns the dashpot. Which part stretches it?"},
            {"speed-for-rate", speed,
             "This takes the relative speed for the rate at which the "
             "length changes. Is all of that speed along the axis, and can "
             "a speed be negative?"},
            {"wrong-sign", fabs(speed + right) < 1e-9 ? right : -right,
             "The size is right, and the sign is not. When the two fly "
             "apart, which way does a dashpot pull each of them?"},
            {"one-velocity", r > 0.0 ? p->c * own * s.x[k] : right,
             "This looks at the velocity of one body alone. Whose motion "
             "changes the distance?"}});
}

/* Body b feels the opposite of what body a does. */
static void check_opposite(const struct pair *p, double got, int k)
{
    const double right = -p->on_a[k];
    CHECK_NEAR(got,
               .quantity = check_text("on_b[%d], the force on b along %c",
                                      k, "xyz"[k]),
               .unit = "N", .expected = right, .tolerance = tolerance(p),
               .because = because,
               .question = "What one of the two feels, the other feels as "
                           "well. In which direction?",
               .mistakes = {
                   {"both-the-same", -right,
                    "This is the very force on a. What becomes of the "
                    "total momentum when both are pulled the same way?"}});
}

static void check_heat(const struct pair *p, double got)
{
    const struct body s = seen(p);
    const double u = sqrt(dot(s.v, s.v));
    CHECK_NEAR(
        got, .quantity = "power turned into heat", .unit = "W",
        .expected = p->heat, .tolerance = 2.0 * tolerance(p) * u,
        .because =
            "32 epsilons of c times the square of the relative speed",
        .mistakes = {
            {"half-the-power", 0.5 * p->heat,
             "Half of it. Is this an energy, or a force times a rate?"},
            {"power-negative", -p->heat,
             "This is what the two bodies gain. How much does the heat "
             "gain?"},
            {"power-of-the-whole-velocity", p->c * u * u,
             "The force is right, and the power is that of the whole "
             "relative velocity. Does a force do work across itself?"},
            {"force-for-power", sqrt(p->c * p->heat),
             "This is the size of the force. What is missing on the way to "
             "a power?"},
            {"no-axis", dot(s.x, s.x) > 0.0 ? NAN : CHECK_NAN,
             "Not a number: what do you divide by when the two are at the "
             "same place?"}});
}

static void check_pair(const struct pair *p)
{
    const struct answer r = answer(p);
    for (int k = 0; k < 3; ++k)
        check_force(p, r.on_a[k], k);
    for (int k = 0; k < 3; ++k)
        check_opposite(p, r.on_b[k], k);
}

/* Two bodies on the axis k, at 1 m from each other. */
static struct pair on_axis(int k, double va, double vb)
{
    struct pair p = {.c = 0.5};
    p.a.x[k] = 2.0;
    p.b.x[k] = 3.0;
    p.a.v[k] = va;
    p.b.v[k] = vb;
    p.on_a[k] = 0.5 * (vb - va);
    p.heat = 0.5 * (vb - va) * (vb - va);
    return p;
}

CHECK_TIMES(3, test_axis, k)
{
    check_ask("Two bodies on a line, 1 m apart: how fast does the distance "
              "grow, and how large is the force then?");
    const struct pair apart = on_axis(k, 1.0, 4.0);
    const struct pair nearer = on_axis(k, 2.0, -0.5);
    const struct pair together = on_axis(k, 1.5, 1.5);
    check_pair(&apart);
    check_pair(&nearer);
    check_pair(&together);
}

/* As far apart as we like, in the same direction. */
/* limit: 1e-100 m */
/* limit: 1e100 m */
CHECK_TIMES(5, test_distance, i)
{
    static const double far[] = {0.25, 3.0, 1000.0, 1e-100, 1e100};
    struct pair p = {.c = 2.0,
                     .b = {.x = {0.0, far[i], 0.0}, .v = {1.0, 0.75, 3.0}},
                     .on_a = {0.0, 1.5, 0.0},
                     .heat = 1.125};
    check_ask("The same velocities at another distance: does the length "
              "change at another rate?");
    check_pair(&p);
    check_ask("Does the power know of the distance?");
    check_heat(&p, answer(&p).heat);
}

/* A dumbbell that turns about its middle, or about another point: the
   distance stays. */
CHECK_TIMES(4, test_turning, i)
{
    static const double axis[][3] = {{2.0, 0.0, 0.0},
                                     {0.0, -3.0, 4.0},
                                     {1.0, 2.0, -2.0},
                                     {-6.0, 3.0, 2.0}};
    static const double turn[][3] = {{0.0, 0.0, 1.0},
                                     {2.0, 0.0, 0.0},
                                     {0.5, 1.0, 0.25},
                                     {1.0, 2.0, 4.0}};
    check_ask(
        "These two only turn about a point. Does their distance change?");
    for (int j = 0; j < 4; ++j) {
        struct pair p = {.c = 3.0, .a = {.x = {1.0, 1.0, 1.0}}};
        for (int k = 0; k < 3; ++k)
            p.b.x[k] = p.a.x[k] + axis[i][k];
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            p.a.v[k] = turn[j][l] * p.a.x[m] - turn[j][m] * p.a.x[l];
            p.b.v[k] = turn[j][l] * p.b.x[m] - turn[j][m] * p.b.x[l];
        }
        check_pair(&p);
    }
}

/* 7 m apart, because 2, 3, 6 and 7 make squares; and b flies off. */
static void test_oblique(void)
{
    check_ask(
        "The axis is oblique: which part of the velocity lies along it?");
    const struct pair p = {.c = 0.5,
                           .a = {{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}},
                           .b = {{3.0, 4.0, 7.0}, {7.0, 0.0, 7.0}},
                           .on_a = {0.5 * 8.0 * 2.0 / 7.0,
                                    0.5 * 8.0 * 3.0 / 7.0,
                                    0.5 * 8.0 * 6.0 / 7.0}};
    const struct pair q = {.c = 4.0,
                           .a = {{3.0, 0.0, 1.0}, {-5.0, 2.0, 9.0}},
                           .b = {{0.0, 4.0, 1.0}, {5.0, 2.0, -7.0}},
                           .on_a = {14.4, -19.2, 0.0}};
    check_pair(&p);
    check_pair(&q);
}

/* What holds whatever the formula: the momentum stays, and so does the
   angular momentum, when the force on a is along the axis. */
static void test_momenta(void)
{
    const struct pair p = {.c = 1.5,
                           .a = {{0.5, -1.0, 2.0}, {3.0, 0.0, -1.0}},
                           .b = {{2.5, 1.0, 1.0}, {-1.0, 2.0, 0.5}},
                           .on_a = {-11.0 / 6.0, -11.0 / 6.0, 11.0 / 12.0},
                           .heat = 1.5 * 5.5 * 5.5 / 9.0};
    const struct answer r = answer(&p);
    const struct body s = seen(&p);
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        check_opposite(&p, r.on_b[k], k);
        CHECK_NEAR(s.x[l] * r.on_b[m] - s.x[m] * r.on_b[l],
                   .quantity = check_text("torque of both forces about %c",
                                          "xyz"[k]),
                   .unit = "N m", .tolerance = tolerance(&p) * 6.0,
                   .because = "that of the forces, times 2 * 3 m",
                   .question = "Your dashpot turns the pair. Which way "
                               "does its force point?");
    }
    check_ask("Is this force along the axis?");
    check_pair(&p);
}

static void test_heat(void)
{
    check_ask("How much energy do both bodies lose in one second?");
    const struct pair apart = on_axis(1, 1.0, 4.0);
    const struct pair nearer = on_axis(2, 1.0, -1.0);
    const struct pair oblique = {.c = 0.5,
                                 .a = {{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}},
                                 .b = {{3.0, 4.0, 7.0}, {7.0, 0.0, 7.0}},
                                 .heat = 32.0};
    const struct pair still = {.c = 4.0, .b = {{1.0, 0, 0}, {0, 1.0, 0}}};
    check_heat(&apart, answer(&apart).heat);
    check_heat(&nearer, answer(&nearer).heat);
    check_heat(&oblique, answer(&oblique).heat);
    check_heat(&still, answer(&still).heat);
}

static void test_same_place(void)
{
    check_ask("There is no direction from a place to itself. What did the "
              "exercise ask for?");
    const struct pair p = {.c = 2.0,
                           .a = {{1.0, 2.0, 3.0}, {1.0, 0.0, 0.0}},
                           .b = {{1.0, 2.0, 3.0}, {0.0, 1.0, 5.0}}};
    const struct pair q = {.c = 2.0};
    check_pair(&p);
    check_heat(&p, answer(&p).heat);
    check_pair(&q);
    check_heat(&q, answer(&q).heat);
}

/* Whole numbers whose squares add up to a square, from any four: a vector
   with a whole number for its length, which is returned. */
static double draw_axis(double d[3])
{
    double q[4], square = 0.0;
    do {
        square = 0.0;
        for (int k = 0; k < 4; ++k) {
            q[k] = check_draw_whole(-5, 5);
            square += q[k] * q[k];
        }
    } while (square == 0.0);
    d[0] = q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3];
    d[1] = 2.0 * (q[0] * q[3] + q[1] * q[2]);
    d[2] = 2.0 * (q[1] * q[3] - q[0] * q[2]);
    return square;
}

/* A pair that is made for its force: b is seen from a along d, and moves
   along it at the rate wanted; and across it as it likes, by a product of
   vectors with d; and both together. All sums are of few binary digits, and
   so exact. */
static struct pair draw_pair(void)
{
    struct pair p = {.c = check_draw(0.1, 5.0)};
    double d[3], w[3];
    const double length = draw_axis(d);
    const double stretch = check_draw_whole(-40, 40) / 64.0;
    const double size = ldexp(1.0, check_draw_whole(-6, 6));
    for (int k = 0; k < 3; ++k) {
        w[k] = check_draw_whole(-20, 20) / 64.0;
        p.a.x[k] = check_draw_whole(-99, 99) * size;
        p.a.v[k] = check_draw_whole(-99, 99) / 16.0;
    }
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        p.b.x[k] = p.a.x[k] + size * d[k];
        p.b.v[k] = p.a.v[k] + stretch * d[k] + (w[l] * d[m] - w[m] * d[l]);
        p.on_a[k] = p.c * (stretch * d[k]);
    }
    p.heat = p.c * (stretch * length) * (stretch * length);
    return p;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("Any direction, any velocities: is the force c times the "
              "rate of the length, along it?");
    const struct pair p = draw_pair();
    check_pair(&p);
}

CHECK_TIMES(40, test_drawn_heat, i)
{
    check_ask("The force times the rate at which the length changes: is "
              "this what you return?");
    const struct pair p = draw_pair();
    check_heat(&p, answer(&p).heat);
}

const struct check_suite check_suite = {
    .file = "10a-dashpot.c",
    .title = "A dashpot along the axis",
    .minutes = 20,
    .equation = "eq:axial-dashpot",
    .tests = {{"two bodies on a line are braked", test_axis, 2, 0},
              {"the distance does not matter", test_distance, 2, 0},
              {"what turns is left to turn", test_turning, 2, 0},
              {"an oblique axis takes its part of the velocity",
               test_oblique, 2, 0},
              {"momentum and angular momentum stay", test_momenta, 1, 0},
              {"the heat is what the bodies lose", test_heat, 1, 0},
              {"at the same place there is no force", test_same_place, 1,
               0},
              {"any two bodies", test_drawn, 2, 2},
              {"the heat of any two", test_drawn_heat, 1, 1},
              {0}},
    .idle = {test_turning},
};
