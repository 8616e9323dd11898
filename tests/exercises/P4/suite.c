/* Project P4: what a program picks, what that costs, and what it refuses.
 */
#include "examiner/project.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4, MOST_STEPS = 50000 };

/* The laws of remote.c, by their numbers. */
enum law { GRAVITY, SOFTENED, SPRINGS, NOTHING };
static const char *const law_names[] = {
    "the header's force", "a force that stays finite",
    "a force that grows with the distance", "a force of 0"};

struct request {
    int n;
    double m[MOST], x[2 * MOST], v[2 * MOST];
    double t, tol;
    enum law law;
    double constant; /* of the law, where it is asked for in another
                        process, or 0 */
    double most;     /* calls that are answered there */
};

/* What the laws that are linked with a program have for constants. */
static const double usual[] = {
    [GRAVITY] = 0.0, [SOFTENED] = 0.04, [SPRINGS] = 1.0, [NOTHING] = 0.0};

static long double constant_of(const struct request *q)
{
    return q->constant > 0.0 ? q->constant : usual[q->law];
}

static void pull(const void *of, const long double x[], long double a[])
{
    const struct request *q = of;
    for (int c = 0; c < 2 * q->n; ++c)
        a[c] = 0.0L;
    for (int i = 0; i < q->n && q->law != NOTHING; ++i)
        for (int j = 0; j < q->n; ++j) {
            const long double dx = x[2 * j] - x[2 * i];
            const long double dy = x[2 * j + 1] - x[2 * i + 1];
            const long double soft =
                q->law == SOFTENED ? constant_of(q) : 0.0L;
            const long double dd = dx * dx + dy * dy + soft;
            if (j == i)
                continue;
            const long double f =
                q->m[j] * (q->law == SPRINGS ? constant_of(q)
                                             : 1.0L / (dd * sqrtl(dd)));
            a[2 * i] += f * dx;
            a[2 * i + 1] += f * dy;
        }
}

struct state {
    long double x[PROJECT_PLACES], v[PROJECT_PLACES];
};

static struct state begin(const struct request *q)
{
    struct state s = {{0.0L}, {0.0L}};
    for (int c = 0; c < 2 * q->n; ++c) {
        s.x[c] = q->x[c];
        s.v[c] = q->v[c];
    }
    return s;
}

static struct state truth_of(const struct request *q)
{
    struct state s = begin(q);
    project_exactly(pull, q, 2 * q->n, s.x, s.v, q->t, 400);
    return s;
}

static double apart(const struct request *q, const struct state *a,
                    const struct state *b)
{
    double most = 0.0;
    for (int c = 0; c < 2 * q->n; c += 2)
        most = fmax(most, (double)hypotl(a->x[c] - b->x[c],
                                         a->x[c + 1] - b->x[c + 1]));
    return most;
}

/* ---- the three methods ---- */

static long cost(int order, long steps)
{
    return (order == 4 ? 3 : 1) * steps + (order > 1);
}

static void kick(const struct request *q, struct state *s,
                 const long double a[], long double h)
{
    for (int c = 0; c < 2 * q->n; ++c)
        s->v[c] += h * a[c];
}

static struct state after(const struct request *q, int order, long steps)
{
    struct state s = begin(q);
    const long double gamma = 1.0L / (2.0L - cbrtl(2.0L));
    const long double h = (long double)q->t / steps;
    const long double parts[] = {gamma, 1.0L - 2.0L * gamma, gamma};
    long double a[PROJECT_PLACES];
    pull(q, s.x, a);
    for (long k = 0; k < steps; ++k)
        for (int i = 0; i < (order == 4 ? 3 : 1); ++i) {
            const long double part = order == 4 ? h * parts[i] : h;
            kick(q, &s, a, order == 1 ? part : part / 2.0L);
            for (int c = 0; c < 2 * q->n; ++c)
                s.x[c] += part * s.v[c];
            pull(q, s.x, a);
            if (order > 1)
                kick(q, &s, a, part / 2.0L);
        }
    return s;
}

/* The least steps with which a method holds the tolerance, to one per cent;
   0 when they cost more than so many forces. */
static long least_steps(const struct request *q, const struct state *truth,
                        int order, long most)
{
    long below = 0, above = 1;
    for (;; below = above, above *= 2) {
        if (cost(order, below + 1) > most)
            return 0;
        const struct state s = after(q, order, above);
        if (apart(q, &s, truth) <= q->tol)
            break;
    }
    while (above - below > 1 + above / 200) {
        const long middle = (below + above) / 2;
        const struct state s = after(q, order, middle);
        *(apart(q, &s, truth) <= q->tol ? &above : &below) = middle;
    }
    return cost(order, above) > most ? 0 : above;
}

/* The least that any of the three costs, and what each does, or 0. */
struct known {
    long cheapest, of[5];
};

static struct known look(const struct request *q, const struct state *truth)
{
    static const int orders[] = {4, 2, 1};
    struct known k = {.cheapest = 3L * MOST_STEPS + 1};
    for (int i = 0; i < 3; ++i) {
        const int order = orders[i];
        const long room = order == 2 ? 4 * k.cheapest : k.cheapest;
        const long steps = least_steps(
            q, truth, order, room > MOST_STEPS ? 3 * MOST_STEPS : room);
        k.of[order] = steps ? cost(order, steps) : 0;
        if (steps && k.of[order] < k.cheapest)
            k.cheapest = k.of[order];
    }
    return k;
}

/* ---- requests ---- */

static struct request draw_eight(double turns, double tol)
{
    static const double x[] = {0.97000436, -0.24308753, -0.97000436,
                               0.24308753, 0.0,         0.0};
    static const double v[] = {0.466203685, 0.43236573,  0.466203685,
                               0.43236573,  -0.93240737, -0.86473146};
    const double metre = draw(0.5, 2.0), kilogram = draw(0.5, 2.0);
    const double second = sqrt(metre * metre * metre / kilogram);
    struct request q = {.n = 3};
    for (int c = 0; c < 6; ++c) {
        q.m[c / 2] = kilogram;
        q.x[c] = x[c] * metre;
        q.v[c] = v[c] * metre / second;
    }
    q.t = 6.32591398 * second * turns;
    q.tol = tol * metre;
    return q;
}

static struct request draw_planet(double turns, double tol)
{
    struct request q = {.n = 2, .m = {draw(0.5, 2.0), 1e-3}};
    const double axis = draw(0.5, 2.0), e = draw(0.2, 0.3);
    q.x[2] = axis * (1.0 - e);
    q.v[3] = sqrt((q.m[0] + q.m[1]) / axis * (1.0 + e) / (1.0 - e));
    q.v[1] = -q.v[3] * q.m[1] / q.m[0];
    q.t =
        turns * 6.283185307 * sqrt(axis * axis * axis / (q.m[0] + q.m[1]));
    q.tol = tol * axis;
    return q;
}

/* Four in a ring, for another law. */
static struct request draw_ring(enum law law, double t, double tol)
{
    struct request q = {.n = 4, .law = law, .tol = tol};
    double all = 0.0;
    for (int i = 0; i < 4; ++i) {
        const double turn = 1.5707963 * (i + draw(-0.2, 0.2));
        const double far = draw(0.8, 1.2), speed = draw(0.6, 0.8);
        q.m[i] = draw(0.5, 1.0);
        q.x[2 * i] = far * cos(turn);
        q.x[2 * i + 1] = far * sin(turn);
        q.v[2 * i] = -speed * sin(turn);
        q.v[2 * i + 1] = speed * cos(turn);
        all += q.m[i];
    }
    q.t = t / sqrt(all);
    return q;
}

/* Two on a long thin ellipse of a spring, so long that order 4 ends at one
   place with so many steps and with twice as many, a whole turn behind, and
   at another in truth. */
static struct request draw_chance(int steps)
{
    struct request q = {
        .n = 2, .m = {draw(0.5, 1.0), draw(0.5, 1.0)}, .law = SPRINGS};
    const double mass = q.m[0] + q.m[1], omega = sqrt(mass);
    const double far = draw(0.8, 1.2), turn = draw(0.1, 1.4);
    const double across = omega * far * draw(0.1, 0.15);
    for (int i = 0; i < 2; ++i) {
        const double part = (i ? q.m[0] : -q.m[1]) / mass;
        q.x[2 * i] = part * far * cos(turn);
        q.x[2 * i + 1] = part * far * sin(turn);
        q.v[2 * i] = -part * across * sin(turn);
        q.v[2 * i + 1] = part * across * cos(turn);
    }
    q.tol = 0.02 * far;
    double best = 1.42, least = INFINITY;
    for (double wide = 0.12; wide > 1e-5; wide /= 60.0) {
        const double middle = best;
        for (int k = -60; k <= 60; ++k) {
            const double at = middle + k * wide / 60.0;
            struct state truth = begin(&q);
            q.t = at * steps / omega;
            for (int c = 0; c < 4; ++c)
                truth.x[c] = q.x[c] * cos(omega * q.t) +
                             q.v[c] / omega * sin(omega * q.t);
            const struct state few = after(&q, 4, steps);
            const struct state many = after(&q, 4, 2 * steps);
            const double gap = apart(&q, &few, &many);
            if (gap < least && apart(&q, &many, &truth) > 10.0 * q.tol) {
                least = gap;
                best = at;
            }
        }
    }
    q.t = best * steps / omega;
    return q;
}

enum { REQUESTS = 5 };

static void draw_requests(struct request q[REQUESTS])
{
    q[0] = draw_eight(draw(4.8, 4.95), draw(0.028, 0.034));
    q[1] = draw_eight(draw(0.85, 0.95), draw(0.8e-6, 1.2e-6));
    q[2] = draw_planet(draw(1.3, 1.7), draw(0.8e-4, 1.2e-4));
    q[3] = draw_ring(SPRINGS, draw(60.0, 65.0), draw(0.8e-3, 1.2e-3));
    q[4] = draw_ring(SOFTENED, draw(4.0, 5.0), draw(0.8e-5, 1.2e-5));
}

/* ---- runs ---- */

static const char for_ever[] = "How does your loop end when no number of "
                               "steps is enough? [never-gives-up]";

static const struct run_order *order_of(const struct request *q)
{
    static char bodies[2000], words[2][32];
    static struct run_order o;
    int at = 0;
    for (int i = 0; i < q->n; ++i)
        at += snprintf(bodies + at, sizeof bodies - (size_t)at,
                       "%.17g %.17g %.17g %.17g %.17g\n", q->m[i],
                       q->x[2 * i], q->x[2 * i + 1], q->v[2 * i],
                       q->v[2 * i + 1]);
    snprintf(words[0], 32, "%.17g", q->t);
    snprintf(words[1], 32, "%.17g", q->tol);
    o = (struct run_order){
        .arguments = {"bodies.txt", words[0], words[1]},
        .files = {{"bodies.txt", bodies}},
        .given = (int)q->law,
        .count = q->most > 0.0 ? RUN_OUTSIDE : RUN_INSIDE,
        .constant = (double)constant_of(q),
        .most = q->most,
        .late = for_ever,
    };
    return &o;
}

/* What a program has answered. */
struct answer {
    const struct run *run;
    int order;
    long steps;
    double calls; /* that it says it has made */
    struct state end;
};

static const char what_pick[] =
    "Behind # pick stand the order, 1, 2 or 4, the steps, and the calls.";

static const char wasteful[] =
    "Which of your runs teaches nothing that a shorter one would not? When "
    "is it clear that a method will not win?";

static const struct run *run_request(const struct request *q)
{
    const struct run *r = run_program(order_of(q));
    check_about(
        check_text("%s, and %.440s", law_names[q->law], check_about(NULL)));
    return r;
}

static const char *with_pick(const struct answer *a)
{
    return check_text("order %d with %ld steps; %.440s", a->order, a->steps,
                      check_about(NULL));
}

/* Whether there is an answer that can be read. */
static void answered(const struct request *q, struct answer *a)
{
    const struct run *r = a->run = run_request(q);
    if (q->most > 0.0)
        CHECK_NEAR(r->calls, .quantity = "all calls of force, counted",
                   .expected = fmin(r->calls, q->most),
                   .because =
                       "60 times the cheapest known; more are not answered",
                   .equation = "eq:choose-cost", .question = wasteful);
    double pick[3] = {NAN, NAN, NAN};
    CHECK_NEAR(
        r->status, .quantity = "the status with which it ended",
        .question = "What did it complain about? This request can be held.",
        .mistakes = {
            {"refused-in-vain", 1.0,
             "This request can be held with 50000 steps. After which of "
             "its runs does your program give up, and why?"}});
    project_form(
        r, 1, 1 + 4 * (size_t)q->n,
        "The row is t, and x, y, vx and vy of each body at the end. Which "
        "of them is missing, or what is there besides?");
    const int count = run_remark(r, "# pick", pick, 3);
    CHECK_NEAR(count, .quantity = "numbers behind # pick", .expected = 3.0,
               .question = what_pick);
    CHECK_NEAR(pick[0] == 1.0 || pick[0] == 2.0 || pick[0] == 4.0,
               .quantity = "1 if the order is 1, 2 or 4", .expected = 1.0,
               .question = what_pick);
    CHECK_NEAR(pick[1] >= 1.0 && pick[1] <= MOST_STEPS,
               .quantity = "1 if the steps are 1 to 50000", .expected = 1.0,
               .question = what_pick);
    a->order = (int)pick[0];
    a->steps = (long)pick[1];
    a->calls = pick[2];
    for (int c = 0; c < 2 * q->n; ++c) {
        a->end.x[c] = r->numbers[1 + 4 * (c / 2) + c % 2];
        a->end.v[c] = r->numbers[3 + 4 * (c / 2) + c % 2];
    }
    const long least = cost(a->order, a->steps);
    CHECK_NEAR(r->calls, .quantity = "1 if force was called at all",
               .expected = fmax(r->calls, 1.0),
               .question = "Which forces did this run take?",
               .mistakes = {{"own-force", 0.0,
                             "Your program has not asked the header's "
                             "force. Which law can it know by itself?"}});
    CHECK_NEAR(
        r->calls, .quantity = "calls of force, counted",
        .input = with_pick(a), .expected = fmax(r->calls, (double)least),
        .because = "the pick needs so many", .equation = "eq:choose-cost",
        .question = "This method needs more calls for so many steps. Where "
                    "do the other forces come from?");
}

/* How far velocities are apart at most, in units of the largest: those of
   the answer, and of a state that is still without so much of a kick. */
static double late(const struct request *q, const struct answer *a,
                   const struct state *own, double kick_left)
{
    long double f[PROJECT_PLACES];
    double most = 0.0, size = 0.0;
    pull(q, own->x, f);
    for (int c = 0; c < 2 * q->n; ++c) {
        most = fmax(most, fabs((double)(a->end.v[c] - own->v[c] +
                                        kick_left * f[c])));
        size = fmax(size, fabs((double)own->v[c]));
    }
    return most / size;
}

static void check_velocities(const struct request *q,
                             const struct answer *a,
                             const struct state *own)
{
    const double part =
        a->order == 4 ? 1.0 / (2.0 - cbrt(2.0)) : a->order == 2;
    const double kick_left = part * q->t / a->steps / 2.0;
    const double got = late(q, a, own, 0.0);
    struct check check = {
        .quantity = "how far the velocities of the row are from those of "
                    "its pick, in the largest of them",
        .input = with_pick(a),
        .tolerance = 1e-6,
        .because = "the same steps, but for rounding",
        .equation = "eq:triple-jump",
        .question = "The places are right. At which time are these the "
                    "velocities, and in which order do they stand?",
    };
    if (got > 1e-6 && late(q, a, own, kick_left) < 1e-6)
        project_mistake(
            &check, "last-kick-forgotten", got,
            "The last half kick is missing. If two half kicks are made "
            "into one, what is left to do at the end?");
    check_near(got, check);
}

/* Whether the end is within the tolerance, and that of the pick. */
static void held(const struct request *q, const struct answer *a,
                 const struct state *truth)
{
    const double error = apart(q, &a->end, truth) / q->tol;
    const struct state own = after(q, a->order, a->steps);
    const struct state half = after(q, a->order, 2 * a->steps);
    const double other = apart(q, &a->end, &own) / q->tol;
    struct check check = {
        .quantity = "how far the row is from that of its pick, in TOL",
        .input = with_pick(a),
        .tolerance = 1e-3 + 1e-9 / q->tol,
        .because = "the same steps, but for rounding",
        .equation = "eq:triple-jump",
        .question = "These steps of this method end elsewhere. Is the row "
                    "that of another run, or the method another one?",
    };
    const double all = apart(q, &half, &own) / q->tol;
    if (all > 0.01)
        project_mistake(&check, "row-of-the-other-run", all,
                        "This row is that of twice the steps. Which run "
                        "have you picked, and which one printed?");
    CHECK_NEAR(a->run->numbers[0], .quantity = "t", .unit = "s",
               .expected = q->t, .tolerance = 1e-9 * q->t,
               .because = "it is T",
               .question = "At which time is the row?");
    check_near(other, check);
    check_velocities(q, a, &own);
    CHECK_NEAR(error > 1.0 ? error : 1.0,
               .quantity = "the error of the worst place, in TOL",
               .expected = 1.0, .tolerance = 1e-9,
               .because = "what was asked for", .equation = "eq:order",
               .question =
                   "The tolerance is not held. From which of your runs do "
                   "you know the error of this one, and is that error "
                   "already falling with the power of the method?");
}

/* ---- stages ---- */

static void check_read(void)
{
    const struct request q = {.n = 2,
                              .m = {2.0, 1.0},
                              .x = {1.0, 2.0, 1.0, 3.0},
                              .v = {0.5, -0.25, 0.5, 0.0},
                              .t = 4.0,
                              .tol = 1e-3,
                              .law = NOTHING};
    struct run_order o = *order_of(&q);
    o.files[0].text =
        "# m x y vx vy\n\n\t2 1   2 0.5 -0.25 # below\n1 1 3 0.5 0";
    const struct run *r = run_program(&o);
    project_reads(r, "A remark may fill a line, a line may be empty, two "
                     "bodies may have one x, and the last line need not "
                     "end. Which of these does your program refuse?");
    project_form(r, 1, 9, "Two bodies: nine numbers.");
}

/* limit: 8 bodies */
/* As many as there may be, which do nothing to each other. */
static void check_crowd(void)
{
    enum { ALL = 8, PER_BODY = 4, WIDTH = 1 + PER_BODY * ALL };
    static char bodies[40 * ALL];
    const struct request q = {.n = 2,
                              .m = {1.0, 1.0},
                              .x = {0.0, 0.0, 1.0, 0.0},
                              .t = 4.0,
                              .tol = 1e-3,
                              .law = NOTHING};
    struct run_order o = *order_of(&q);
    for (int i = 0, at = 0; i < ALL; ++i)
        at += snprintf(bodies + at, sizeof bodies - (size_t)at,
                       "1 %d 0 0.25 0.5\n", i);
    o.files[0].text = bodies;
    const struct run *r = run_program(&o);
    static const char question[] = "There are 8 bodies, and so many are "
                                   "allowed. How many do your arrays hold?";
    project_form(r, 1, WIDTH, question);
    CHECK_NEAR(r->numbers[1 + PER_BODY * (ALL - 1)],
               .quantity = "x of body 8", .unit = "m",
               .expected = ALL - 1 + 0.25 * q.t, .tolerance = q.tol,
               .because = "nothing pulls", .question = question);
}

static void check_inputs(void)
{
    static const char one[] = "1 0 0 1 0\n";
    static const struct {
        const char *what, *bodies, *t, *tol;
    } all[] = {
        {"a file without bodies", "# nothing\n", "1", "0.1"},
        {"a mass of 0", "0 0 0 1 0\n", "1", "0.1"},
        {"four numbers", "1 0 0 1\n", "1", "0.1"},
        {"six numbers", "1 0 0 1 0 0\n", "1", "0.1"},
        {"a word for a number", "1 0 zero 1 0\n", "1", "0.1"},
        {"a place that is no number", "1 nan 0 1 0\n", "1", "0.1"},
        {"a velocity that is not finite", "1 0 0 inf 0\n", "1", "0.1"},
        {"a velocity upwards that is no number", "1 0 0 0 nan\n", "1",
         "0.1"},
        {"two bodies in one place", "1 0 0 1 0\n1 0 0 0 1\n", "1", "0.1"},
        {"the third body in the place of the second",
         "1 0 0 1 0\n1 2 1 0 1\n1 2 1 0 0\n", "1", "0.1"},
        {"a T of 0", one, "0", "0.1"},
        {"a T that is a word", one, "long", "0.1"},
        {"a TOL below 0", one, "1", "-0.1"},
        {"a unit behind TOL", one, "1", "0.1m"},
        {"a TOL that is an empty word", one, "1", ""},
        {"a file that is not there", NULL, "1", "0.1"}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        const struct run_order o = {
            .arguments = {"bodies.txt", all[k].t, all[k].tol},
            .files = {{all[k].bodies ? "bodies.txt" : NULL, all[k].bodies}},
            .late = for_ever};
        project_refuses(&o, all[k].what);
    }
}

static void stage_special(void)
{
    struct request flight = draw_planet(1.0, 1e-3);
    struct request swing = draw_ring(SPRINGS, draw(3.0, 4.0), 1e-2);
    struct answer a;
    flight.law = NOTHING;
    const struct request *const both[] = {&flight, &swing};
    for (int i = 0; i < 2; ++i) {
        const struct state truth = truth_of(both[i]);
        answered(both[i], &a);
        held(both[i], &a, &truth);
        if (i == 0)
            CHECK_NEAR(
                (double)cost(a.order, a.steps),
                .quantity = "forces of the pick", .expected = 1.0,
                .tolerance = 3.0,
                .because = "one step is exact, by any method",
                .question =
                    "Nothing pulls. How many steps does a straight line "
                    "need, and what keeps your program from seeing it?");
    }
    check_read();
    check_crowd();
    check_inputs();
}

static void stage_hold(void)
{
    struct request q[REQUESTS];
    struct answer a;
    draw_requests(q);
    for (int i = 0; i < REQUESTS; ++i) {
        const struct state truth = truth_of(&q[i]);
        answered(&q[i], &a);
        held(&q[i], &a, &truth);
    }
    for (int i = 0; i < 2; ++i) {
        const struct request chance = draw_chance(i ? 80 : 64);
        const struct state truth = truth_of(&chance);
        answered(&chance, &a);
        const double error = apart(&chance, &a.end, &truth) / chance.tol;
        CHECK_NEAR(
            error > 1.0 ? error : 1.0,
            .quantity = "the error of the worst place, in TOL",
            .expected = 1.0, .tolerance = 1e-9,
            .because = "what was asked for", .equation = "eq:order",
            .question = "From which of your runs do you know the error of "
                        "this one?",
            .mistakes = {
                {"agreed-by-chance", error > 10.0 ? error : NAN,
                 "With few steps there are two runs here that agree, and "
                 "both are wrong. Which third run would not have agreed? "
                 "Does the error fall as it should?"}});
        held(&chance, &a, &truth);
    }
}

/* Whether all picks hold, and cost at most so many times the cheapest. */
static void check_picks(double most)
{
    struct request q[REQUESTS];
    struct answer a;
    draw_requests(q);
    for (int i = 0; i < REQUESTS; ++i) {
        const struct state truth = truth_of(&q[i]);
        answered(&q[i], &a);
        held(&q[i], &a, &truth);
        const struct known k = look(&q[i], &truth);
        const double times = (double)cost(a.order, a.steps) / k.cheapest;
        struct check check = {
            .quantity = "forces of the pick, over those of the cheapest",
            .input = with_pick(&a),
            .expected = 1.0,
            .tolerance = most - 1.0 + 0.01,
            .because = "so many times the cheapest known",
            .equation = "eq:choose-cost",
        };
        if (a.order == 4 && k.of[2] == k.cheapest)
            project_mistake(
                &check, "second-order-is-cheaper", times,
                "Here a method of order 2 needs fewer forces. Has your "
                "program tried it, and does it count what a step costs?");
        if (a.order == 2 && k.of[4] == k.cheapest)
            project_mistake(&check, "fourth-order-is-cheaper", times,
                            "Here a method of order 4 needs fewer forces. "
                            "Has your program tried it?");
        check_near(times, check);
    }
}

static void stage_four(void)
{
    check_ask("Which method is it, and how much smaller than TOL is the "
              "error of your run?");
    check_picks(4.0);
}

static void stage_two(void)
{
    check_ask("Who doubles the steps until it is enough has up to twice as "
              "many as are needed. What does the last run say about the "
              "number that would just do?");
    check_picks(2.0);
}

static void stage_best(void)
{
    check_ask("How near to TOL does your program dare to go? How well does "
              "it know the error that it will make?");
    check_picks(1.2);
}

/* For the third request and the last the forces come from another process,
   which counts the calls: neither that count nor the constant of the
   softened law can be known to the program. A call then costs some ten
   microseconds; for all five it would be half of the time that a P4 takes
   to grade. */
static void stage_search(void)
{
    struct request q[REQUESTS];
    struct answer a;
    draw_requests(q);
    q[4].constant = draw(0.03, 0.05);
    for (int i = 0; i < REQUESTS; ++i) {
        const struct state truth = truth_of(&q[i]);
        const struct known k = look(&q[i], &truth);
        q[i].most = i == 2 || i == 4 ? 60.0 * (double)k.cheapest : 0.0;
        answered(&q[i], &a);
        held(&q[i], &a, &truth);
        CHECK_NEAR(a.calls, .quantity = "CALLS", .expected = a.run->calls,
                   .because = "it was counted",
                   .question = "Where does your program count, and is "
                               "there a call that it does not?",
                   .mistakes = {{"calls-of-the-pick",
                                 (double)cost(a.order, a.steps),
                                 "That is what the pick costs. What did it "
                                 "cost to find it?"}});
        CHECK_NEAR(a.run->calls / (double)k.cheapest,
                   .quantity = "all calls, over the cheapest known",
                   .expected = 1.0, .tolerance = 59.0,
                   .because = "60 times the cheapest known",
                   .equation = "eq:choose-cost", .question = wasteful);
    }
}

/* Bodies that meet so often that paths part: at TOL the doubles' last digit
   would have to be multiplied by less than it is. */
/* limit: 50000 steps */
static void stage_horizon(void)
{
    const struct request far = draw_ring(SOFTENED, 900.0, 1e-4);
    const struct request long_way = draw_planet(draw(38.0, 42.0), 1e-4);
    struct answer a;
    const struct run *r = run_request(&far);
    CHECK_NEAR(
        r->status, .quantity = "the status with which it ended",
        .expected = 1.0, .equation = "eq:order",
        .question = "No run of 50000 steps knows where these bodies are.",
        .mistakes = {{"beyond-the-horizon", 0.0,
                      "No run of 50000 steps knows where these bodies are. "
                      "What do two of your runs say of each other, with "
                      "steps of different length?"}});
    CHECK_NEAR((double)r->rows, .quantity = "rows",
               .question = "What is refused has no row.");
    CHECK_NEAR(*r->complaint != '\0', .quantity = "a line on stderr",
               .expected = 1.0,
               .question = "It should say why it gives up.");
    const struct state truth = truth_of(&long_way);
    answered(&long_way, &a);
    held(&long_way, &a, &truth);
}

const struct check_suite check_suite = {
    .file = "P4-enough.c",
    .title = "Enough",
    .minutes = 210,
    .tests =
        {{"1 special cases: nothing pulls, and other forces", stage_special,
          4, 0},
         {"2 hold it: the row is within the tolerance", stage_hold, 6, 2},
         {"3 the pick: at most four times the cheapest", stage_four, 3, 0},
         {"4 the pick: at most twice the cheapest", stage_two, 3, 2},
         {"5 the pick: at most 1.2 times the cheapest", stage_best, 2, 0},
         {"6 the search: all calls, counted", stage_search, 4, 1},
         {"7 the horizon: what cannot be held is refused", stage_horizon, 3,
          0},
         {0}},
};
