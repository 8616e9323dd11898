/* The suite of exercise 08d, "Find a stability limit". */

#include "examiner/check.h"
#include <complex.h>

void step(double h, double y[2]);
double stability_limit(double most);

/* ---- the black boxes ---- */

enum kind {
    RUNGE_KUTTA, /* the exponential's terms up to z^order */
    LEAPFROG,    /* in one part, or in two unequal ones */
    THETA        /* implicit by this part: 1/2 is the midpoint */
};

struct method {
    const char *text;
    enum kind kind;
    int order;       /* RUNGE_KUTTA */
    double part;     /* LEAPFROG: of the first part; THETA */
    double friction; /* LEAPFROG: 1/s */
    double omega;    /* of the oscillator, 1/s */
    double unit;     /* of the velocity */
    double lean;     /* the velocity is told with so much of x in it */
};

static struct method box;

static void kick(double h, double y[2])
{
    y[1] -= h * box.omega * box.omega * y[0];
}

static void leap(double h, double y[2])
{
    const double brake = exp(-0.5 * box.friction * h);
    y[1] *= brake;
    kick(0.5 * h, y);
    y[0] += h * y[1];
    kick(0.5 * h, y);
    y[1] *= brake;
}

/* The oscillator turns the complex number omega x + i v. */
static double complex factor(double h)
{
    const double complex z = -I * box.omega * h;
    double complex sum = 1.0;
    if (box.kind == THETA)
        return (1.0 + (1.0 - box.part) * z) / (1.0 - box.part * z);
    for (int k = box.order; k > 0; --k)
        sum = 1.0 + z * sum / k;
    return sum;
}

static void turn(double h, double y[2])
{
    const double complex w = factor(h) * (box.omega * y[0] + I * y[1]);
    y[0] = creal(w) / box.omega;
    y[1] = cimag(w);
}

void step(double h, double y[2])
{
    y[1] = box.unit * (y[1] - box.lean * y[0]);
    if (box.kind == LEAPFROG) {
        leap(box.part * h, y);
        if (box.part < 1.0)
            leap((1.0 - box.part) * h, y);
    } else
        turn(h, y);
    y[1] = y[1] / box.unit + box.lean * y[0];
}

/* ---- what comes out, right and wrong ---- */

/* The student's limit of this method. */
double limit_of(const struct method *m, double most)
{
    box = *m;
    return stability_limit(most);
}

static const char *input(const struct method *m, double most)
{
    return check_text("%s, omega = %g/s, steps up to %g s", m->text,
                      m->omega, most);
}

/* |trace| <= 2 alone: where this ends for the Runge-Kutta methods of the
   orders 3 and 4. */
static double trace_alone(const struct method *m)
{
    return m->kind != RUNGE_KUTTA ? NAN
           : m->order == 3        ? 2.0 / m->omega
                                  : sqrt(12.0) / m->omega;
}

static double after_the_gap(const struct method *m)
{
    return m->kind == LEAPFROG && m->part < 1.0
               ? 2.0 / sqrt(m->part * (1.0 - m->part)) / m->omega
               : NAN;
}

/* limit: 1e-10 s */
/* Where the largest eigenvalue passes 1, it grows at least by 0.43 when
   omega times the step grows by 1 (Runge-Kutta of order 3, at sqrt(3)), and
   so it is 1 + 1e-11 later by at most 1.4e-11 of the limit. */
static const double width = 1e-10;

static void check_limit(const struct method *m, double most,
                        double expected)
{
    const double got = limit_of(m, most);
    const double off = fabs(got - expected);
    const bool endless = isinf(got) && !isinf(expected);
    const bool equal_areas = m->kind == LEAPFROG && m->friction <= 0.0;
    const double tolerance = width + 2e-11 * expected;
    static const char because[] =
        "the width that was asked for, and what a growth of 1 + 1e-11 "
        "makes of the limit";
    if (off > tolerance && off <= 0.01 && expected > 0.0)
        CHECK_NEAR(
            got - expected,
            .quantity = "the largest stable step, minus the right one",
            .unit = "s", .input = input(m, most), .tolerance = tolerance,
            .because = because,
            .mistakes = {
                {"not-halved", got - expected,
                 "Within 0.01 s of the limit. Between which two steps does "
                 "it lie, and how often must that be halved?"}});
    struct check c = {
        .quantity = "the largest stable step",
        .unit = "s",
        .input = input(m, most),
        .expected = expected,
        .tolerance = isinf(expected) ? 0.0 : tolerance,
        .because = because,
        .mistakes = {{"trace-only", trace_alone(m),
                      "This is where the trace alone has an absolute value "
                      "of 2. Is the determinant of this method 1?"},
                     {"beyond-a-gap", after_the_gap(m),
                      "This method is stable, then not, then stable again. "
                      "Which end of which interval have you found?"}}};
    const struct check_mistake more[] = {
        {"complex-passes", endless && m->kind == RUNGE_KUTTA ? got : NAN,
         "Every step seems stable. Which absolute value has a complex "
         "eigenvalue, and what is the root of a negative number in C?"},
        {"complex-root",
         got == 0.0 && m->kind == RUNGE_KUTTA && expected > 0.0 ? got : NAN,
         "Not even 0.01 s seems stable. What is the root of a negative "
         "number in C, and when are the eigenvalues complex?"},
        {"determinant-only",
         endless && m->kind == LEAPFROG && m->part < 1.0 ? got : NAN,
         "Every step seems stable. The determinant is the product of the "
         "eigenvalues: can it be 1 while one of them is large?"},
        {"negative-eigenvalue",
         endless && m->kind == LEAPFROG && m->part >= 1.0 ? got : NAN,
         "Every step seems stable. Beyond its limit this method flies from "
         "side to side: which sign has its largest eigenvalue?"},
        {"stable-step-refused",
         got <= 0.0 && equal_areas && expected > 0.0 ? got : NAN,
         "Not even 0.01 s seems stable, and this method keeps areas: its "
         "eigenvalues have the absolute value 1, but for rounding. Is it "
         "them that you compare, or the length of y, and with which "
         "number?"},
        {"no-room-for-rounding",
         got > 0.0 && got < expected - 0.01 && equal_areas ? got : NAN,
         "Smaller than the limit. The determinant of this method is 1 but "
         "for rounding. Which value was to pass for 1?"},
        {"limit-of-the-unstable",
         expected <= 0.0 && got > 0.0 && got < 0.01 ? got : NAN,
         "A step of 0.01 s is not stable. What was to be returned then?"},
        {"most-for-never", isinf(expected) && got >= most ? got : NAN,
         "All steps up to this one are stable. What was to be returned "
         "then?"}};
    for (size_t i = 0, used = 2; i < sizeof more / sizeof *more; ++i)
        if (!isnan(more[i].value) && used < 8)
            c.mistakes[used++] = more[i];
    check_near(got, c);
}

static struct method plain(const char *text, enum kind kind, int order,
                           double part)
{
    return (struct method){text, kind, order, part, 0.0, 1.0, 1.0, 0.0};
}

/* ---- the tests ---- */

/* With z = i h: |1 + z + z^2/2 + z^3/6|^2 = 1 - h^4/12 + h^6/36, and with
   the next term 1 - h^6/72 + h^8/576. */
static void test_runge_kutta(void)
{
    check_ask("The eigenvalues are a complex pair here. Which absolute "
              "value have they, and when is that 1?");
    const struct method three =
        plain("Runge-Kutta, order 3", RUNGE_KUTTA, 3, 0.0);
    const struct method four =
        plain("Runge-Kutta, order 4", RUNGE_KUTTA, 4, 0.0);
    check_limit(&three, 4.0, sqrt(3.0));
    check_limit(&four, 5.0, sqrt(8.0));
}

/* Two leapfrogs of half the step end at twice the limit, with +1. */
static void test_two_leaps(void)
{
    const struct method twice =
        plain("two leapfrogs of half the step", LEAPFROG, 0, 0.5);
    check_ask("When is one of the real eigenvalues above 1?");
    check_limit(&twice, 7.0, 4.0);
}

static void test_leapfrog(void)
{
    check_ask("At its limit the leapfrog flies from side to side: which "
              "eigenvalue is that?");
    struct method leapfrog = plain("the leapfrog", LEAPFROG, 0, 1.0);
    check_limit(&leapfrog, 5.0, 2.0);
    leapfrog.omega = 2.5;
    check_limit(&leapfrog, 3.0, 2.0 / 2.5);
    leapfrog.omega = 0.4;
    check_limit(&leapfrog, 8.0, 2.0 / 0.4);
}

/* With a brake before and after, of g, the trace is (1 + g^2)(1 - h^2/2)
   and the determinant g^2: an eigenvalue is -1 where 1 - h^2/2 is. */
static void test_friction(void)
{
    check_ask("With friction the determinant is less than 1. Which "
              "eigenvalue is the larger one?");
    struct method brake = plain("a leapfrog with friction", LEAPFROG, 0, 1);
    brake.friction = 0.7;
    check_limit(&brake, 5.0, 2.0);
    brake.friction = 0.05;
    check_limit(&brake, 5.0, 2.0);
}

/* Of parts p < q = 1 - p the trace is 2 - h^2 + p q h^4/4. It is -2 at
   h = 2/sqrt(q) and at 2/sqrt(p), and 2 at 2/sqrt(p q). */
static void test_gap(void)
{
    check_ask(
        "Which is the FIRST step that is not stable, counted from 0?");
    const struct method fifth =
        plain("a leapfrog of h/5 and one of 4h/5", LEAPFROG, 0, 0.2);
    const struct method third =
        plain("a leapfrog of 3h/10 and one of 7h/10", LEAPFROG, 0, 0.3);
    check_limit(&fifth, 9.0, 2.0 / sqrt(0.8));
    check_limit(&third, 8.0, 2.0 / sqrt(0.7));
}

/* limit: 1 (the largest eigenvalue) */
/* limit: 1e-11 (and what passes for 1) */
/* limit: 0.01 s (the first step) */
/* The Euler method grows by (omega h)^2/2. At 0.01 s a growth by 2e-12 is
   to pass for rounding, whether the eigenvalue or its square is compared; a
   growth by 4e-11 is not. */
static void check_rounding(void)
{
    struct method slow = plain("the Euler method", RUNGE_KUTTA, 1, 0.0);
    slow.omega = 2e-4;
    check_ask("The oscillator grows by 2e-12 in a step, less than what was "
              "to pass for rounding. Which value do you compare with 1?");
    check_limit(&slow, 0.015, INFINITY);
    slow.omega = 9e-4;
    check_ask("The oscillator grows by 4e-11 in a step, and 1e-11 was to "
              "pass. How much do you let pass?");
    check_limit(&slow, 0.015, 0.0);
}

static void test_never(void)
{
    const struct method euler =
        plain("the Euler method", RUNGE_KUTTA, 1, 0.0);
    const struct method two =
        plain("Runge-Kutta, order 2", RUNGE_KUTTA, 2, 0.0);
    check_ask("This method lets the oscillator grow with every step. What "
              "does it do at 0.01 s?");
    check_limit(&euler, 3.0, 0.0);
    check_limit(&two, 3.0, 0.0);
    check_rounding();
}

static void test_always(void)
{
    check_ask("Is there any step in this range that is not stable?");
    const struct method middle =
        plain("the implicit midpoint", THETA, 0, 0.5);
    const struct method euler =
        plain("the implicit Euler method", THETA, 0, 1.0);
    const struct method leapfrog = plain("the leapfrog", LEAPFROG, 0, 1.0);
    check_limit(&middle, 20.0, INFINITY);
    check_limit(&euler, 20.0, INFINITY);
    check_limit(&leapfrog, 1.995, INFINITY);
}

/* A step of 0.01 s counts even if it is the only one; and the second. */
static void test_short(void)
{
    check_ask("Which steps were to be tried, up to this one?");
    struct method leapfrog = plain("the leapfrog", LEAPFROG, 0, 1.0);
    leapfrog.omega = 300.0;
    check_limit(&leapfrog, 0.015, 0.0);
    leapfrog.omega = 130.0;
    check_limit(&leapfrog, 0.0105, INFINITY);
    check_limit(&leapfrog, 0.02, 2.0 / 130.0);
}

/* A method in drawn units, and a velocity with some x in it: that changes
   no eigenvalue. Returns the limit. */
double draw_method(struct method *m)
{
    static const struct method known[] = {
        {.text = "Runge-Kutta, order 3", .kind = RUNGE_KUTTA, .order = 3},
        {.text = "Runge-Kutta, order 4", .kind = RUNGE_KUTTA, .order = 4},
        {.text = "the leapfrog", .kind = LEAPFROG, .part = 1.0},
        {.text = "a leapfrog with friction", .kind = LEAPFROG, .part = 1.0},
        {.text = "two unequal leapfrogs", .kind = LEAPFROG}};
    static const double h2[] = {3.0, 8.0, 4.0, 4.0};
    const int which = check_draw_whole(0, 4);
    *m = known[which];
    m->omega = check_draw(0.3, 3.0);
    m->unit = check_draw(0.2, 5.0);
    m->lean = check_draw(-2.0, 2.0);
    if (which == 3)
        m->friction = check_draw(0.01, 0.5) * m->omega;
    if (which < 4)
        return sqrt(h2[which]) / m->omega;
    m->part = check_draw(0.1, 0.4);
    return 2.0 / sqrt(1.0 - m->part) / m->omega;
}

CHECK_TIMES(20, test_drawn, i)
{
    check_ask("The units of x and v, and how they are told, are other ones "
              "here. Do the eigenvalues know?");
    struct method m;
    const double limit = draw_method(&m);
    const bool seen = check_draw_whole(0, 3) > 0;
    const double most =
        limit * (seen ? check_draw(1.07, 3.0) : check_draw(0.3, 0.95));
    check_limit(&m, most, seen ? limit : INFINITY);
}

const struct check_suite check_suite = {
    .file = "08d-limit.c",
    .title = "Find a stability limit",
    .minutes = 30,
    .equation = "eq:stability-limit",
    .tests = {{"Runge-Kutta methods: a complex pair", test_runge_kutta, 2,
               0},
              {"two leapfrogs end at +1", test_two_leaps, 1, 0},
              {"the leapfrog ends at -1", test_leapfrog, 2, 0},
              {"a brake at both ends", test_friction, 1, 0},
              {"stable, unstable, and stable again", test_gap, 2, 0},
              {"methods that are never stable", test_never, 1, 0},
              {"methods that are always stable", test_always, 1, 0},
              {"one step, or two", test_short, 1, 0},
              {"drawn methods and units", test_drawn, 2, 3},
              {0}},
};
