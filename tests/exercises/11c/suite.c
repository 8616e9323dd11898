/* The suite of exercise 11c, "Going back". */

#include "examiner/check.h"
#include <string.h>
#include "call.h"

struct pair {
    struct sphere a, b;
    double dt;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void minus(const double a[3], const double b[3], double to[3])
{
    for (int k = 0; k < 3; ++k)
        to[k] = a[k] - b[k];
}

static void fly(struct pair *p, double time)
{
    for (int k = 0; k < 3; ++k) {
        p->a.x[k] += time * p->a.v[k];
        p->b.x[k] += time * p->b.v[k];
    }
}

/* Velocities after a collision along the line d. */
static void collide(struct pair *p, const double d[3], double im1,
                    double im2)
{
    double u[3];
    minus(p->b.v, p->a.v, u);
    const double J = -2.0 * dot(d, u) / (im1 + im2) / dot(d, d);
    for (int k = 0; k < 3; ++k) {
        p->a.v[k] -= J * p->a.im * d[k];
        p->b.v[k] += J * p->b.im * d[k];
    }
}

/* Two that touch, with the line from a to b, and their velocities. They
   have flown on for the time `ago`; expected is what comes out. */
struct made {
    struct pair now, expected, touching;
    double ago, line[3];
};

static void make(struct made *m, double ago)
{
    m->ago = ago;
    m->now = m->touching;
    fly(&m->now, ago);
    m->expected = m->touching;
    collide(&m->expected, m->line, m->touching.a.im, m->touching.b.im);
    fly(&m->expected, ago);
}

static const char *list(const double a[3])
{
    return check_text("(%.6g, %.6g, %.6g)", a[0], a[1], a[2]);
}

static const char *input(const struct pair *p)
{
    return check_text("im = %g, r = %g, x = %s, v = %s; im = %g, r = %g, x "
                      "= %s, v = %s; dt = %g s",
                      p->a.im, p->a.r, list(p->a.x), list(p->a.v), p->b.im,
                      p->b.r, list(p->b.x), list(p->b.v), p->dt);
}

/* The time is a difference of squares, divided by a speed along the line:
   some ten roundings of the distance, divided by that speed. */
static double slack(const struct made *m)
{
    double u[3], far = m->now.a.r + m->now.b.r;
    minus(m->now.b.v, m->now.a.v, u);
    const double along = fabs(dot(u, m->line)) / far;
    const double size = far + sqrt(dot(m->now.a.x, m->now.a.x)) +
                        sqrt(dot(m->now.b.x, m->now.b.x));
    return 64.0 * DBL_EPSILON * size / along;
}

static void check_time(const struct made *m, double got)
{
    double d[3], u[3], out[3];
    minus(m->now.b.x, m->now.a.x, d);
    minus(m->now.b.v, m->now.a.v, u);
    minus(m->touching.b.x, m->touching.a.x, out);
    const double u2 = dot(u, u), in = dot(out, u);
    const double now = sqrt(dot(d, d)), far = m->now.a.r + m->now.b.r;
    CHECK_NEAR(
        got, .quantity = "how long ago they touched", .unit = "s",
        .input = input(&m->now), .expected = m->ago, .tolerance = slack(m),
        .because =
            "64 epsilons of places and radii, over the speed of approach",
        .mistakes = {
            {"other-root", m->ago + 2.0 * in / u2,
             "This is when they would come out at the other side. Which of "
             "the two roots lies in the past?"},
            {"depth-by-speed", (far - now) / -(dot(d, u) / now),
             "The depth divided by the speed is right head on. When they "
             "pass aside, does the distance shrink evenly?"},
            {"depth-by-whole-speed", (far - now) / sqrt(u2),
             "Here the depth was divided by the whole relative speed. Do "
             "they move along the line of their centres?"},
            {"own-velocity", (far - now) / (dot(m->now.a.v, d) / now),
             "This is what the first sphere's velocity alone would say. "
             "What would somebody say who rides on the second one?"},
            {"not-done", -1.0,
             "You say that there is nothing to be done here. Which of your "
             "conditions says so?"}});
}

/* One of the twelve numbers: places of a, velocities of a, then b's. */
static double number(const struct pair *p, int at)
{
    const struct sphere *s = at < 6 ? &p->a : &p->b;
    return at % 6 < 3 ? s->x[at % 3] : s->v[at % 3];
}

static void check_number(const struct made *m, const struct pair *got,
                         int at)
{
    double d[3];
    struct pair now = m->now, stays, swapped = m->touching, pushed, back;
    minus(m->now.b.x, m->now.a.x, d);
    collide(&now, d, now.a.im, now.b.im); /* along the line of now */
    stays = now;
    fly(&now, m->ago);
    for (int k = 0; k < 3; ++k) {
        now.a.x[k] = stays.a.x[k] + m->ago * (now.a.v[k] - m->now.a.v[k]);
        now.b.x[k] = stays.b.x[k] + m->ago * (now.b.v[k] - m->now.b.v[k]);
    }
    swapped.a.im = m->touching.b.im;
    swapped.b.im = m->touching.a.im;
    collide(&swapped, m->line, swapped.a.im, swapped.b.im);
    fly(&swapped, m->ago);
    pushed = m->expected;
    memcpy(pushed.a.x, m->now.a.x, sizeof pushed.a.x);
    memcpy(pushed.b.x, m->now.b.x, sizeof pushed.b.x);
    back = m->expected;
    fly(&back, -m->ago);
    const double fast = sqrt(dot(m->now.a.v, m->now.a.v)) +
                        sqrt(dot(m->now.b.v, m->now.b.v));
    const double far = m->now.a.r + m->now.b.r;
    const double off = slack(m) * fast;
    CHECK_NEAR(
        number(got, at),
        .quantity = check_text("%s's %s[%d]", at < 6 ? "a" : "b",
                               at % 6 < 3 ? "x" : "v", at % 3),
        .unit = at % 6 < 3 ? "m" : "m/s", .input = input(&m->now),
        .expected = number(&m->expected, at),
        .tolerance = at % 6 < 3
                         ? 4.0 * off
                         : 8.0 * fast * (off / far + 4.0 * DBL_EPSILON),
        .because = "what the error of the time does to it",
        .mistakes = {
            {"line-of-now", number(&now, at),
             "You exchange momentum along the line between the centres as "
             "it is now. Where were the centres when they touched?"},
            {"mass-for-inverse", number(&swapped, at),
             "The heavier one is turned more here. Whose velocity changes "
             "more, and which share of it is im?"},
            {"place-not-changed", number(&pushed, at),
             "They still overlap. Where would they be, had they flown with "
             "their new velocities since the contact?"},
            {"not-forward-again", number(&back, at),
             "This is where they were at the contact. What have they done "
             "since?"},
            {"velocity-not-changed",
             number(at % 6 < 3 ? &m->expected : &m->now, at),
             "The same number as before. Did they collide?"}});
}

static void check_made(struct made *m, double ago)
{
    make(m, ago);
    struct pair p = m->now;
    const double got = go_back(&p.a, &p.b, p.dt);
    check_time(m, got);
    for (int k = 0; k < 12; ++k) { /* velocities before places */
        const int at = k / 6 * 6 + (k + 3) % 6;
        check_number(m, &p, at);
    }
}

static void test_head_on(void)
{
    struct made m = {.touching = {{1.0, 0.25, {0.0}, {1.0, 0.0, 0.0}},
                                  {0.5, 0.75, {1.0}, {-3.0, 0.0, 0.0}},
                                  0.125},
                     .line = {1.0, 0.0, 0.0}};
    check_ask(
        "Head on, everything is on one line. How fast do they approach, "
        "how deep are they, and what is chapter 1's answer?");
    check_made(&m, 0.0625);
}

static void test_wall(void)
{
    struct made m = {.touching = {{0.0, 1.0, {0.0}, {0.25, 0.0, 0.0}},
                                  {4.0, 0.5, {0.0, 1.5}, {0.5, -2.0, 0.0}},
                                  0.25},
                     .line = {0.0, 1.5, 0.0}};
    check_ask("The first one is so heavy that nothing moves it. What does "
              "the second one do, as seen from it?");
    check_made(&m, 0.125);
}

static void test_aside(void)
{
    struct made m = {
        .touching = {{1.0, 0.5, {0.25, 0.5}, {1.5, 0.25, 0.0}},
                     {2.0, 0.5, {0.85, 1.3}, {-0.5, -1.0, 0.0}},
                     0.5},
        .line = {0.6, 0.8, 0.0}};
    check_ask("They meet aside. Draw where they are now, and where they "
              "were when they touched.");
    check_made(&m, 0.25);
}

static void draw(struct made *m)
{
    double u[3], along;
    struct pair *p = &m->touching;
    const double far = check_draw(0.5, 2.0), share = check_draw(0.2, 0.8);
    p->a.r = share * far;
    p->b.r = far - p->a.r;
    p->a.im = check_draw_whole(0, 4) ? check_draw(0.1, 5.0) : 0.0;
    p->b.im = check_draw(0.1, 5.0);
    do {
        for (int k = 0; k < 3; ++k)
            u[k] = check_draw(-1.0, 1.0);
    } while (dot(u, u) > 1.0 || dot(u, u) < 0.1);
    for (int k = 0; k < 3; ++k) {
        m->line[k] = far * u[k] / sqrt(dot(u, u));
        p->a.x[k] = check_draw(-2.0, 2.0);
        p->b.x[k] = p->a.x[k] + m->line[k];
    }
    do { /* never so that they only brush each other; both are drawn again,
            for to one in a corner no other may come near enough */
        for (int k = 0; k < 3; ++k) {
            p->a.v[k] = check_draw(-2.0, 2.0);
            p->b.v[k] = check_draw(-2.0, 2.0);
        }
        minus(p->b.v, p->a.v, u);
        along = dot(u, m->line) / far;
    } while (along > -0.4 * sqrt(dot(u, u)) || along > -0.2);
    p->dt = 0.5 * far / sqrt(dot(u, u)) * 0.4;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("Two spheres in space, made from where they touch. Which of "
              "the three axes is treated otherwise?");
    struct made m = {0};
    draw(&m);
    check_made(&m, check_draw(0.01, 0.9) * m.touching.dt);
}

static void check_left(const struct pair *p, const char *mistake,
                       const char *question)
{
    struct pair q = *p;
    const double got = go_back(&q.a, &q.b, q.dt);
    double changed = 0.0;
    for (int at = 0; at < 12; ++at)
        changed += number(&q, at) != number(p, at);
    CHECK_NEAR(got, .quantity = "what is returned", .unit = "s",
               .input = input(p), .expected = -1.0,
               .because = "-1 is exact", .question = question,
               .mistakes = {{mistake, got, question}});
    CHECK_NEAR(changed,
               .quantity = "how many numbers of the spheres have changed",
               .input = input(p), .because = "none should",
               .question = "You say that nothing is to be done, and do "
                           "something. In which order?",
               .mistakes = {{"changed-anyway", changed,
                             "You say that nothing is to be done, and do "
                             "something. In which order?"}});
}

/* limit: dt (more than that is too long ago; dt itself is not) */
/* Numbers that are whole parts of powers of two, so that no way of
   computing this rounds: the two touched just dt ago, a hair less, and a
   hair more. */
static void check_just_then(void)
{
    struct made m = {.touching = {{1.0, 0.25, {0.0}, {1.0, 0.0, 0.0}},
                                  {0.5, 0.75, {1.0}, {-3.0, 0.0, 0.0}},
                                  0.0625},
                     .line = {1.0, 0.0, 0.0}};
    static const char question[] =
        "These touched just when the step began, dt ago. Is that more than "
        "dt ago?";
    make(&m, 0.0625);
    struct pair p = m.now;
    const double got = go_back(&p.a, &p.b, p.dt);
    CHECK_NEAR(
        got, .quantity = "how long ago they touched", .unit = "s",
        .input = input(&m.now), .expected = m.ago, .tolerance = slack(&m),
        .because =
            "64 epsilons of places and radii, over the speed of approach",
        .question = question,
        .mistakes = {{"dt-itself-refused", -1.0, question}});
    m.touching.dt = 0.0625 * (1.0 + 1e-6);
    check_ask(question);
    check_made(&m, 0.0625);
    m.now.dt = 0.0625 * (1.0 - 1e-6);
    check_left(&m.now, "longer-than-the-step",
               "These touched a millionth of a step before it began. Did "
               "they come to where they are by flying?");
}

static void test_left(void)
{
    check_just_then();
    for (int i = 0; i < 20; ++i) {
        struct made m = {0};
        draw(&m);
        make(&m, 0.5 * m.touching.dt);
        struct pair parting = m.now, apart = m.touching, old = m.now;
        for (int k = 0; k < 3; ++k) {
            parting.a.v[k] = -m.now.a.v[k];
            parting.b.v[k] = -m.now.b.v[k];
        }
        parting.dt = 100.0; /* when they came in does not matter */
        fly(&apart, -0.25 * apart.dt);
        old.dt = 0.4 * m.touching.dt;
        check_left(
            &apart, "apart-treated",
            "These do not overlap. What is there to be done about them?");
        check_left(
            &parting, "parting-treated",
            "These part already. What would a collision do to them?");
        check_left(&old, "longer-than-the-step",
                   "These touched before the step began. Did they come to "
                   "where they are by flying?");
    }
}

const struct check_suite check_suite = {
    .file = "11c-back.c",
    .title = "Going back",
    .minutes = 35,
    .equation = "eq:back-time",
    .tests = {{"head on it is chapter 1's collision", test_head_on, 1, 0},
              {"a wall turns a sphere round", test_wall, 1, 0},
              {"aside they touched along another line", test_aside, 2, 0},
              {"others are left as they are", test_left, 2, 1},
              {"forty pairs in space come from their contact", test_drawn,
               2, 2},
              {0}},
};
