/* The suite of exercise 09d, "Ellipses, and kicks from the others". */

#include "examiner/check.h"
#include <string.h>
#include "call.h"

enum { MOST = 5 };

struct planets {
    size_t n;
    double gm[MOST], sun, x[MOST][3], v[MOST][3];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* From the change of the eccentric anomaly, found by Newton's rule, for
   ellipses that are not long: all here have e < 0.6. */
void drift(double sun, double dt, double x[3], double v[3])
{
    const double r = sqrt(dot(x, x));
    const double a = 1.0 / (2.0 / r - dot(v, v) / sun);
    const double rate = sqrt(sun / a) / a;
    const double c = 1.0 - r / a, s = dot(x, v) / sqrt(sun * a);
    double E = rate * dt;
    for (int i = 0; i < 60; ++i)
        E -= (E - c * sin(E) + s * (1.0 - cos(E)) - rate * dt) /
             (1.0 - c * cos(E) + s * sin(E));
    const double far = a * (1.0 - c * cos(E) + s * sin(E));
    const double less = 1.0 - cos(E);
    const double f = 1.0 - a / r * less, g = dt - (E - sin(E)) / rate;
    const double df = -sqrt(sun * a) / (r * far) * sin(E);
    const double dg = 1.0 - a / far * less;
    for (int k = 0; k < 3; ++k) {
        const double from = x[k];
        x[k] = f * from + g * v[k];
        v[k] = df * from + dg * v[k];
    }
}

/* What somebody may do. */
struct idea {
    double first, last; /* parts of the kicks: a half each */
    double sign;        /* of a kick: 1 */
    bool sun;           /* pulls in the kicks, too */
    bool own;           /* the planet's own gm in place of the other's */
    bool once;          /* only the second of a pair is pulled */
    bool straight;      /* the drift */
};

static const struct idea right = {0.5,   0.5,   1.0,  false,
                                  false, false, false};

static void kick(struct planets *p, struct idea k, double dt)
{
    for (size_t i = 0; i < p->n; ++i) {
        if (k.sun) {
            const double r = sqrt(dot(p->x[i], p->x[i]));
            for (int a = 0; a < 3; ++a)
                p->v[i][a] -= dt * p->sun / (r * r * r) * p->x[i][a];
        }
        for (size_t j = 0; j < (k.once ? i : p->n); ++j) {
            double d[3];
            for (int a = 0; a < 3; ++a)
                d[a] = p->x[j][a] - p->x[i][a];
            const double r = sqrt(dot(d, d));
            for (int a = 0; a < 3 && i != j; ++a)
                p->v[i][a] +=
                    k.sign * dt * p->gm[k.own ? i : j] / (r * r * r) * d[a];
        }
    }
}

static void step(struct planets *p, struct idea k, double dt)
{
    kick(p, k, k.first * dt);
    for (size_t i = 0; i < p->n; ++i)
        if (k.straight)
            for (int a = 0; a < 3; ++a)
                p->x[i][a] += dt * p->v[i][a];
        else
            drift(p->sun, dt, p->x[i], p->v[i]);
    kick(p, k, k.last * dt);
}

static const char *list(const double a[3])
{
    return check_text("(%g, %g, %g)", a[0], a[1], a[2]);
}

static const char *input(const struct planets *p, double dt)
{
    const char *all = check_text("sun = %g, dt = %g d", p->sun, dt);
    for (size_t i = 0; i < p->n; ++i)
        all = check_text("%s; gm = %g, x = %s, v = %s", all, p->gm[i],
                         list(p->x[i]), list(p->v[i]));
    return all;
}

/* The number `at` of a planet's six, after a step as somebody makes it. */
static double would(const struct planets *from, struct idea k, double dt,
                    size_t i, int at)
{
    struct planets p = *from;
    step(&p, k, dt);
    return at < 3 ? p.x[i][at] : p.v[i][at - 3];
}

static void check_number(const struct planets *from, double dt, double got,
                         size_t i, int at, double size)
{
    struct idea whole = right, early = right, late = right, sun = right,
                own = right, away = right, once = right, straight = right;
    whole.first = whole.last = 1.0;
    early.first = late.last = 1.0;
    early.last = late.first = 0.0;
    sun.sun = own.own = once.once = true;
    straight.sun = straight.straight = true;
    away.sign = -1.0;
    CHECK_NEAR(
        got,
        .quantity =
            check_text("%s[%zu][%d]", at < 3 ? "x" : "v", i, at % 3),
        .unit = at < 3 ? "AU" : "AU/d", .input = input(from, dt),
        .expected = would(from, right, dt, i, at),
        .tolerance = 100.0 * DBL_EPSILON * size,
        .because = "a hundred epsilons: the roundings of a few pulls",
        .mistakes = {{"two-whole-kicks", would(from, whole, dt, i, at),
                      "Each of your kicks takes a whole step. How long do "
                      "the others pull in all?"},
                     {"kicks-not-symmetric", would(from, early, dt, i, at),
                      "The whole kick comes before the drift. Would a step "
                      "back undo this one?"},
                     {"kicks-not-symmetric", would(from, late, dt, i, at),
                      "The whole kick comes after the drift. Would a step "
                      "back undo this one?"},
                     {"sun-counted-twice", would(from, sun, dt, i, at),
                      "The Sun pulls in your kicks. Who else knows of it?"},
                     {"own-mass", would(from, own, dt, i, at),
                      "A planet's acceleration does not depend on its own "
                      "mass. Whose gm belongs here?"},
                     {"pushed-away", would(from, away, dt, i, at),
                      "Your planets push each other away. Which way does "
                      "the arrow point that you take?"},
                     {"one-of-a-pair", would(from, once, dt, i, at),
                      "One planet of a pair is pulled, and the other one "
                      "is not. What does the first one feel?"},
                     {"straight-drift", would(from, straight, dt, i, at),
                      "Between the kicks your planets fly straight on. "
                      "Which path does the given function know?"}});
}

static void check_step(const struct planets *from, double dt)
{
    struct planets p = *from;
    ellipses_and_kicks(p.n, p.gm, p.sun, dt, p.x, p.v);
    for (size_t i = 0; i < p.n; ++i) {
        const double far = sqrt(dot(from->x[i], from->x[i]));
        const double fast = sqrt(dot(from->v[i], from->v[i]));
        /* the velocities first, for these tell more about the kicks */
        for (int k = 0; k < 6; ++k) {
            const int at = (k + 3) % 6;
            check_number(from, dt, at < 3 ? p.x[i][at] : p.v[i][at - 3], i,
                         at,
                         at < 3 ? far + fabs(dt) * fast
                                : fast + fabs(dt) * p.sun / far / far);
        }
    }
}

static const struct planets pair = {2,
                                    {0.01, 0.002},
                                    1.0,
                                    {{1.0, 0.1, 0.0}, {-0.2, 1.6, 0.1}},
                                    {{0.0, 0.9, 0.1}, {-0.8, 0.0, 0.0}}};

/* limit: 1 (planet) */
static void test_one(void)
{
    struct planets p = pair;
    p.n = 1;
    check_ask("A planet alone goes along its ellipse, however long the "
              "step is. What disturbs it in yours?");
    for (double dt = -0.5; dt < 5.0; dt += 1.0)
        check_step(&p, dt);
}

static void test_two(void)
{
    check_ask("Half a kick, an ellipse, half a kick. Print what each of "
              "the three changes, and compare it with what it should.");
    check_step(&pair, 0.25);
}

/* limit: 0 (a planet without a mass feels the others, and pulls none) */
static void check_massless(void)
{
    struct planets p = pair;
    check_ask("One planet has no mass: its own gm is 0. Is anything of "
              "yours divided by that, or left out for it?");
    for (int i = 0; i < 2; ++i) {
        p.gm[i] = 0.0;
        struct planets q = p;
        ellipses_and_kicks(q.n, q.gm, q.sun, 0.25, q.x, q.v);
        CHECK_NEAR(
            isnan(q.v[i][0]) ? NAN : 0.0,
            .quantity = check_text("v[%d][0], if it is not a number", i),
            .unit = "AU/d", .input = input(&p, 0.25),
            .because = "a body without a mass has a velocity",
            .question = "Which of your numbers is zero here?",
            .mistakes = {
                {"divided-by-own-mass", CHECK_NAN,
                 "This body has no mass, and the Sun and the others pull "
                 "it all the same. By what do you divide, and need you?"}});
        check_step(&p, 0.25);
    }
    /* the second time both are without */
}

static void test_three(void)
{
    struct planets p = pair;
    p.n = 3;
    p.gm[2] = 0.005;
    memcpy(p.x[2], (double[3]){0.3, -2.0, -0.3}, sizeof p.x[2]);
    memcpy(p.v[2], (double[3]){0.7, 0.1, 0.05}, sizeof p.v[2]);
    check_ask("Three planets make three pairs. How many pulls are there?");
    check_step(&p, 0.25);
    check_massless();
}

/* Around circles, with gentle pulls, and never close to another. */
static void draw(struct planets *p)
{
    p->n = (size_t)check_draw_whole(2, MOST);
    p->sun = check_draw(0.5, 2.0);
    for (size_t i = 0; i < p->n; ++i) {
        const double r = 1.0 + 0.8 * (double)i, at = check_draw(0.0, 6.0);
        const double fast = sqrt(p->sun / r) * check_draw(0.9, 1.1);
        p->gm[i] = p->sun * check_draw(1e-4, 1e-2);
        p->x[i][0] = r * cos(at);
        p->x[i][1] = r * sin(at);
        p->x[i][2] = check_draw(-0.1, 0.1);
        p->v[i][0] = -fast * sin(at);
        p->v[i][1] = fast * cos(at);
        p->v[i][2] = check_draw(-0.1, 0.1);
    }
}

CHECK_TIMES(10, test_back, i)
{
    struct planets p, q;
    draw(&p);
    q = p;
    const double dt = check_draw(0.05, 0.5);
    ellipses_and_kicks(q.n, q.gm, q.sun, dt, q.x, q.v);
    CHECK_NEAR(fabs(q.x[0][0] - p.x[0][0]) > 1e-6,
               .quantity = "has x[0][0] changed? (1 yes, 0 no)",
               .input = input(&p, dt), .expected = 1.0,
               .because = "yes or no",
               .question = "Nothing has moved. Who moves the planets?");
    ellipses_and_kicks(q.n, q.gm, q.sun, -dt, q.x, q.v);
    for (size_t k = 0; k < p.n; ++k)
        for (int a = 0; a < 3; ++a)
            CHECK_NEAR(q.v[k][a],
                       .quantity = check_text(
                           "v[%zu][%d] after a step and a step back", k, a),
                       .unit = "AU/d", .input = input(&p, dt),
                       .expected = p.v[k][a], .tolerance = 1e-12,
                       .because = "the roundings of two steps",
                       .question = "The last half of a kick should be "
                                   "undone by the first half of the step "
                                   "back. From which places is it taken?");
}

static double turn(const struct planets *p)
{
    double sum = 0.0;
    for (size_t i = 0; i < p->n; ++i)
        sum +=
            p->gm[i] * (p->x[i][0] * p->v[i][1] - p->x[i][1] * p->v[i][0]);
    return sum;
}

/* A drift changes no planet's, and a pair's pulls are equal and opposite.
 */
static void test_turn(void)
{
    struct planets p;
    draw(&p);
    const struct planets from = p;
    for (int i = 0; i < 50; ++i)
        ellipses_and_kicks(p.n, p.gm, p.sun, 0.1, p.x, p.v);
    CHECK_NEAR(turn(&p) / turn(&from),
               .quantity =
                   "angular momentum after 50 steps, by that before",
               .input = input(&from, 0.1), .expected = 1.0,
               .tolerance = 1e-12, .because = "the roundings of 50 steps",
               .question =
                   "Two planets pull each other along one line. Are the "
                   "two pulls equal, when each is multiplied by the mass?");
}

CHECK_TIMES(20, test_drawn, i)
{
    check_ask("Up to five planets, forward and back. Which pull is "
              "missing, or comes too often?");
    struct planets p;
    draw(&p);
    check_step(&p, check_draw(-0.5, 0.5));
}

const struct check_suite check_suite = {
    .file = "09d-ellipses.c",
    .title = "Ellipses, and kicks from the others",
    .minutes = 30,
    .equation = "eq:wisdom-holman",
    .tests = {{"a planet alone keeps its ellipse", test_one, 1, 0},
              {"two planets pull each other", test_two, 2, 0},
              {"three planets make three pairs", test_three, 1, 0},
              {"a step back undoes a step", test_back, 1, 1},
              {"angular momentum is conserved", test_turn, 1, 0},
              {"drawn planets go where they should", test_drawn, 2, 2},
              {0}},
    .idle = {test_turn},
};
