/* The suite of exercise 11b, "What leaves the cradle?". */

#include "examiner/check.h"
#include <stdio.h>
#include "call.h"

enum { MOST = 100 };

struct row {
    size_t n;
    double mass[MOST], v[MOST];
};

/* The velocities at the end, and how many collisions there were. */
struct end {
    double v[MOST + 1];
    size_t collisions;
};

static const char *numbers(const double x[], size_t n)
{
    char text[300] = "";
    size_t used = 0;
    for (size_t i = 0; i < n && used < 280; ++i)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%.17g",
                                 i ? " " : "", x[i]);
    return check_text("%s", text);
}

/* What the student's function answers. Behind the last ball stands a heavy
   one that flies in and does not belong to the row. */
static struct end answer(const struct row *r)
{
    check_about(check_text("%zu balls: masses %s kg, velocities %s m/s",
                           r->n, numbers(r->mass, r->n),
                           numbers(r->v, r->n)));
    struct end e = {{0.0}, 0};
    double mass[MOST + 1];
    for (size_t i = 0; i < r->n; ++i) {
        mass[i] = r->mass[i];
        e.v[i] = r->v[i];
    }
    mass[r->n] = 1e3;
    e.v[r->n] = -99.0;
    e.collisions = cradle(r->n, mass, e.v);
    return e;
}

static double fastest(const struct row *r)
{
    double most = 0.0;
    for (size_t i = 0; i < r->n; ++i)
        most = fmax(most, fabs(r->v[i]));
    return most;
}

/* ---- another way: mirrors. Multiply the place of each ball by the root of
   its mass: then the places of all are one point that flies straight on,
   and for each pair there is a mirror where the two meet. When the point
   comes to a mirror we let it pass and reflect all other mirrors instead.
   What we have to know of a mirror is how far it was from the point at the
   start and how fast the point goes away from it, which changes as mirrors
   do. The angle between two neighbours stays, and others are at right
   angles. Times never begin anew. ---- */

struct mirrors {
    size_t count;
    long double far[MOST], away[MOST], width[MOST];
};

/* Minus the cosine between mirror k and the next. */
static long double slant(const struct row *r, const struct mirrors *m,
                         size_t k)
{
    return 1.0L / (r->mass[k + 1] * m->width[k] * m->width[k + 1]);
}

static struct mirrors put_up(const struct row *r)
{
    struct mirrors m = {.count = r->n - 1};
    for (size_t k = 0; k < m.count; ++k) {
        m.width[k] = sqrtl(1.0L / r->mass[k] + 1.0L / r->mass[k + 1]);
        m.far[k] = 1.0L / m.width[k];
        m.away[k] = ((long double)r->v[k + 1] - r->v[k]) / m.width[k];
    }
    return m;
}

static void pass(const struct row *r, struct mirrors *m, size_t k)
{
    for (size_t side = 0; side < 2; ++side) {
        const size_t j = side ? k + 1 : k - 1;
        if (j >= m->count)
            continue; /* k - 1 wraps round */
        const long double s = 2.0L * slant(r, m, side ? k : j);
        m->far[j] += s * m->far[k];
        m->away[j] += s * m->away[k];
    }
    m->far[k] = -m->far[k];
    m->away[k] = -m->away[k];
}

/* The mirror that is reached next; count for none. *clear becomes false
   where two neighbours are reached almost at the same time, or one is
   approached so slowly that rounding might decide. */
static size_t reached(const struct mirrors *m, long double unit,
                      bool *clear)
{
    size_t next = m->count;
    long double soonest = INFINITY, when[MOST];
    for (size_t k = 0; k < m->count; ++k) {
        const long double rate = m->away[k] * m->width[k];
        when[k] = INFINITY;
        if (fabsl(rate) > 1e-13L * unit && fabsl(rate) < 1e-6L * unit)
            *clear = false;
        if (rate < -1e-9L * unit)
            when[k] = -m->far[k] / m->away[k];
        if (when[k] < soonest) {
            soonest = when[k];
            next = k;
        }
    }
    for (size_t k = 0; k < m->count; ++k)
        if ((k + 1 == next || k == next + 1) &&
            when[k] - soonest < 1e-6L * (soonest + 1.0L / unit))
            *clear = false;
    return next;
}

/* At most so many collisions. */
static struct end unfolded(const struct row *r, size_t most, bool *clear)
{
    struct end e = {{0.0}, 0};
    long double momentum = 0.0L, mass = 0.0L, ahead = 0.0L;
    struct mirrors m = put_up(r);
    size_t k;
    while (e.collisions < most &&
           (k = reached(&m, fastest(r), clear)) < m.count) {
        pass(r, &m, k);
        ++e.collisions;
    }
    for (size_t i = 0; i < r->n; ++i) {
        ahead += i > 0 ? m.away[i - 1] * m.width[i - 1] : 0.0L;
        e.v[i] = (double)ahead;
        momentum += r->mass[i] * (r->v[i] - ahead);
        mass += r->mass[i];
    }
    for (size_t i = 0; i < r->n; ++i)
        e.v[i] += (double)(momentum / mass);
    return e;
}

/* ---- the slips: who is taken for the next pair ---- */

enum slip { SWEEP, ROW, FASTEST, SLIPS };

static size_t taken(enum slip slip, const struct row *r, size_t from)
{
    const double slow = 1e-9 * fastest(r);
    size_t best = r->n;
    double most = slow;
    for (size_t i = 0; i + 1 < r->n; ++i) {
        const size_t k = slip == FASTEST ? i : (from + i) % (r->n - 1);
        const double rate = r->v[k] - r->v[k + 1];
        if (rate <= most || (slip == SWEEP && k < from))
            continue;
        if (slip != FASTEST)
            return k;
        most = rate;
        best = k;
    }
    return best;
}

static struct end slipped(enum slip slip, struct row r)
{
    struct end e = {{0.0}, 0};
    size_t from = 0, k;
    while (r.n > 1 && e.collisions < 2000 &&
           from + 1 < r.n + (slip != SWEEP) &&
           (k = taken(slip, &r, from)) < r.n) {
        const double change =
            2.0 * (r.v[k] - r.v[k + 1]) / (r.mass[k] + r.mass[k + 1]);
        r.v[k] -= change * r.mass[k + 1];
        r.v[k + 1] += change * r.mass[k];
        from = slip == SWEEP ? k + 1 : (k + 1) % (r.n - 1);
        ++e.collisions;
    }
    for (size_t i = 0; i < r.n; ++i)
        e.v[i] = r.v[i];
    return e;
}

/* ---- checks ---- */

static const char because[] = "1e-12 of the largest speed at the start";

static double tolerance(const struct row *r)
{
    return 1e-12 * fastest(r);
}

/* What a slip says of ball i, if all of the answer is as the slip has it.
 */
static double explained(const struct row *r, const struct end *slip,
                        const struct end *got, const struct end *expected,
                        size_t i)
{
    for (size_t k = 0; k < r->n; ++k)
        if (!(fabs(slip->v[k] - got->v[k]) <= 1e-9 * fastest(r)))
            return expected->v[i];
    return slip->v[i];
}

static void check_velocity(const struct row *r, size_t i,
                           const struct end *got,
                           const struct end *expected)
{
    bool clear;
    const struct end sweep = slipped(SWEEP, *r), row = slipped(ROW, *r);
    const struct end fast = slipped(FASTEST, *r);
    const struct end once = unfolded(r, r->n - 1, &clear);
#define EXPLAINED(slip) explained(r, &slip, got, expected, i)
    CHECK_NEAR(
        got->v[i],
        .quantity = check_text("v[%zu], of ball %zu at the end", i, i),
        .unit = "m/s", .expected = expected->v[i],
        .tolerance = tolerance(r), .because = because,
        .mistakes = {
            {"one-sweep", EXPLAINED(sweep),
             "This goes through the row once, from left to right. Is all "
             "over then, or does somebody still run into a neighbour?"},
            {"each-pair-once", EXPLAINED(once),
             "This is where they are after as many collisions as there are "
             "gaps. May two balls meet more than once?"},
            {"order-of-the-row", EXPLAINED(row),
             "This is what comes out when the pairs collide in the order "
             "of the row, again and again. Which pair is the first to "
             "meet, in time?"},
            {"gaps-never-change", EXPLAINED(fast),
             "This takes every gap to be as wide as at the start, so that "
             "the fastest pair comes first. What have the others done to "
             "their gaps until then?"}});
#undef EXPLAINED
}

/* Of two balls no rounding makes a second collision. */
static void check_count(size_t balls, size_t got, size_t expected)
{
    CHECK_NEAR((double)got, .quantity = "number of collisions",
               .expected = (double)expected, .because = "a number is exact",
               .mistakes = {
                   {"rounding-counted",
                    balls > 2 && got > expected ? (double)got : NAN,
                    "More than there are. Two of them may be as fast as "
                    "each other, but for a rounding: do they approach?"}});
}

static void check_end(const struct row *r, const struct end *expected)
{
    const struct end e = answer(r);
    for (size_t i = 0; i < r->n; ++i)
        check_velocity(r, i, &e, expected);
    check_count(r->n, e.collisions, expected->collisions);
    CHECK_NEAR(
        e.v[r->n], .quantity = "what stands behind the last velocity",
        .expected = -99.0, .because = "it does not belong to the row",
        .question =
            "Who is the last ball, and has it a neighbour on the right?");
}

/* Two balls: the rule of chapter 1. */
static void check_two(double m0, double m1, double v0, double v1, double u0,
                      double u1)
{
    const struct row r = {2, {m0, m1}, {v0, v1}};
    const struct end e = answer(&r);
    const double both = (m0 * v0 + m1 * v1) / (m0 + m1);
    const double change = 2.0 * (v1 - v0) / (m0 + m1);
    for (int i = 0; i < 2; ++i)
        CHECK_NEAR(
            e.v[i],
            .quantity = check_text("v[%d], of ball %d at the end", i, i),
            .unit = "m/s", .expected = i ? u1 : u0,
            .tolerance = tolerance(&r), .because = because,
            .question =
                "Two balls meet once. What does each give to the other?",
            .mistakes = {{"velocities-exchanged", i ? v0 : v1,
                          "An exchange of the velocities gives this. Do "
                          "balls of different masses make one?"},
                         {"they-stick", both,
                          "This is the velocity of their centre of mass. "
                          "Do they stick, or bounce?"},
                         {"masses-exchanged",
                          i ? v1 - change * m1 : v0 + change * m0,
                          "The masses have changed places. Which of the "
                          "two velocities changes more: that of the heavy "
                          "ball or of the light one?"}});
    check_ask("Two balls meet once, and part. How often is that?");
    check_count(2, e.collisions, 1);
}

static void test_two(void)
{
    check_two(2.0, 3.0, 7.5, -2.5, -4.5, 5.5);
    check_two(1.0, 3.0, 2.0, 0.0, -1.0, 1.0);
    check_two(3.0, 1.0, 1.0, -1.0, 0.0, 2.0);
    check_two(0.5, 1.5, 1.0, -3.0, -5.0, -1.0);
    check_two(2.0, 2.0, 5.0, 1.0, 1.0, 5.0);
    check_two(1.0, 3.0, 1.0, 1.0 - 2e-9, 1.0 - 3e-9, 1.0 - 1e-9);
    check_two(4.0, 4.0, 3e-20, 1e-20, 1e-20, 3e-20);
}

/* Equal masses hand their velocities on. */
static struct row equal_row(size_t n, size_t left, double mass, double v)
{
    struct row r = {.n = n};
    for (size_t i = 0; i < n; ++i) {
        r.mass[i] = mass;
        r.v[i] = i < left ? v : 0.0;
    }
    return r;
}

/* limit: 100 balls */
static void test_one(void)
{
    check_ask("One ball flies into a row of its like. Follow the velocity "
              "from ball to ball.");
    for (size_t n = 3; n <= MOST; n += n < 9 ? 2 : 91) {
        const struct row r = equal_row(n, 1, 2.0, 1.5);
        struct end e = {.collisions = n - 1};
        e.v[n - 1] = 1.5;
        check_end(&r, &e);
    }
}

/* As many out as in; and one from either side. */
static void test_some(void)
{
    check_ask("Several fly in. Which of them meets the row first, and who "
              "is next?");
    static const double speed[] = {1.5, 1e-15, 1e15};
    for (size_t n = 4; n <= 8; ++n)
        for (size_t left = 2; left < n; ++left) {
            const double v = speed[n % 3];
            const struct row r = equal_row(n, left, 0.1, v);
            struct end e = {.collisions = left * (n - left)};
            for (size_t i = n - left; i < n; ++i)
                e.v[i] = v;
            check_end(&r, &e);
        }
    struct row both = equal_row(5, 1, 0.7, 1.5);
    both.v[4] = -1.0;
    const struct end e = {{-1.0, 0.0, 0.0, 0.0, 1.5}, 7};
    check_end(&both, &e);
}

/* limit: 1e-9 of the largest speed */
static void test_none(void)
{
    check_ask("Nobody runs into a neighbour here. What is left to do?");
    static const struct row rows[] = {
        {.n = 0},
        {1, {2.0}, {3.0}},
        {3, {1.0, 2.0, 3.0}, {-1.0, 0.5, 0.5}},
        {4, {1.0, 1.0, 5.0, 1.0}, {2.0, 2.0, 2.0, 2.0}},
        {2, {1.0, 4.0}, {1.0, 1.0 - 5e-10}},
        {3, {1.0, 4.0, 1.0}, {-1.0, 0.0, -1e-10}}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
        struct end e = {.collisions = 0};
        for (size_t i = 0; i < rows[k].n; ++i)
            e.v[i] = rows[k].v[i];
        check_end(&rows[k], &e);
    }
}

/* A first ball of M kg and n - 1 of 1 kg: each knock takes away
   (M - 1)/(M + 1) of its velocity, and 2 M/(M + 1) of it goes through the
   row to the last ball that is still at rest. A light one knocks once. */
static struct end knocked(double M, size_t n, double v)
{
    struct end e = {.collisions = 0};
    for (size_t i = n - 1; i > 0; --i) {
        if (M <= 1.0 && i < n - 1)
            continue;
        e.v[i] = v * (2.0 * M / (M + 1.0));
        v *= (M - 1.0) / (M + 1.0);
        e.collisions += i;
    }
    e.v[0] = v;
    return e;
}

static struct row first_of(double M, size_t n, double v)
{
    struct row r = {.n = n, .mass = {M}, .v = {v}};
    for (size_t i = 1; i < n; ++i)
        r.mass[i] = 1.0;
    return r;
}

CHECK_TIMES(4, test_heavy, i)
{
    static const double mass[] = {2.0, 3.0, 0.5, 7.0};
    check_ask("After the first knock a heavy ball still flies on. What "
              "does it meet?");
    for (size_t n = 3; n <= 7; ++n) {
        const struct row r = first_of(mass[i], n, 1.0);
        const struct end e = knocked(mass[i], n, 1.0);
        check_end(&r, &e);
    }
}

/* Worked out with fractions. */
static void test_fractions(void)
{
    static const struct {
        struct row row;
        struct end end;
    } known[] = {
        {{3, {2, 3, 1}, {1}}, {{-0.2, 0.4, 1.2}, 2}},
        {{4, {2, 1, 3, 1}, {1}}, {{-1.0 / 3, 1.0 / 6, 0.5, 1.0}, 5}},
        {{4, {1, 2, 1, 3}, {1}},
         {{-1.0 / 3, -2.0 / 9, 4.0 / 9, 4.0 / 9}, 4}},
        {{4, {3, 2, 1, 1}, {1}},
         {{11.0 / 75, 16.0 / 75, 8.0 / 15, 1.6}, 5}},
        {{4, {5, 1, 2, 1}, {1}},
         {{14.0 / 81, 35.0 / 81, 10.0 / 9, 40.0 / 27}, 6}},
        {{4, {3, 1, 3, 1}, {3}}, {{-0.375, 0.0, 2.25, 3.375}, 5}},
        {{3, {2, 1, 3}, {2, 0, -1}}, {{-5.0 / 3, 1.0 / 3, 4.0 / 3}, 4}},
        {{4, {3, 1, 2, 4}, {3, 0, 0, -1}},
         {{-37.0 / 18, 17.0 / 18, 44.0 / 27, 47.0 / 27}, 8}}};
    check_ask("Follow these few balls with pencil and paper. Who meets "
              "whom, and when?");
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i)
        check_end(&known[i].row, &known[i].end);
}

/* Worked out with fractions; in another order something else comes out. */
static void test_order(void)
{
    static const struct {
        struct row row;
        struct end end;
    } known[] = {
        {{5, {4, 1, 2, 1, 3}, {1}},
         {{-26167.0 / 455625, 13696.0 / 151875, 21568.0 / 91125,
           608.0 / 2025, 2272.0 / 2025},
          12}},
        {{4, {1, 3, 1, 3}, {2, 0, 0, -1}},
         {{-35.0 / 32, -33.0 / 32, 0.5625, 0.875}, 6}},
        {{4, {3, 1, 1, 3}, {2, 0, 0, -1}}, {{-1.0, 0.0, 0.0, 2.0}, 7}},
        {{4, {4, 1, 2, 1}, {1, 0, 0, -3}},
         {{-239.0 / 225, 32.0 / 75, 176.0 / 135, 299.0 / 135}, 6}},
        {{5, {3, 1, 2, 1, 3}, {2, 0, 0, 0, -1}},
         {{-13.0 / 9, 13.0 / 81, 241.0 / 243, 289.0 / 243, 4.0 / 3}, 12}}};
    check_ask("Two pairs are about to meet: which of them does so first? "
              "Draw the places against time.");
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i)
        check_end(&known[i].row, &known[i].end);
}

/* Three balls, of which the first moves, are the point of light between
   two mirrors at an angle: it comes in along the one and meets the other at
   the angle, then the first at twice the angle, and so on, up to half a
   turn. The sine of each angle is the speed of approach. */
static double angle_of(const double m[3])
{
    return atan(sqrt(m[1] * (m[0] + m[1] + m[2]) / (m[0] * m[2])));
}

static struct end by_angles(const struct row *r)
{
    const double *m = r->mass, angle = angle_of(m);
    const double width[2] = {sqrt(1.0 / m[0] + 1.0 / m[1]),
                             sqrt(1.0 / m[1] + 1.0 / m[2])};
    const double speed = r->v[0] / (width[0] * sin(angle));
    const size_t last = (size_t)(acos(-1.0) / angle);
    struct end e = {.collisions = last};
    double apart[2];
    apart[(last + 1) % 2] = speed * sin(last * angle);
    apart[last % 2] = -speed * sin((last + 1) * angle);
    e.v[1] = width[0] * apart[0];
    e.v[2] = e.v[1] + width[1] * apart[1];
    const double shift = (m[0] * r->v[0] - m[1] * e.v[1] - m[2] * e.v[2]) /
                         (m[0] + m[1] + m[2]);
    for (int i = 0; i < 3; ++i)
        e.v[i] += shift;
    return e;
}

CHECK_TIMES(3, test_between, i)
{
    static const double heavy[] = {10.0, 100.0, 1e4};
    check_ask("A light ball is caught between two heavy ones. How often "
              "does it go to and fro?");
    const struct row r = {3, {heavy[i], 1.0, heavy[i]}, {0.5}};
    const struct end e = by_angles(&r);
    check_end(&r, &e);
}

/* So that it is clear whether there is one collision more. */
static struct row draw_three(void)
{
    struct row r = {.n = 3};
    double turns;
    do {
        for (int i = 0; i < 3; ++i)
            r.mass[i] = pow(10.0, check_draw(-1.0, 1.0));
        turns = acos(-1.0) / angle_of(r.mass);
    } while (fabs(turns - round(turns)) < 1e-3);
    r.v[0] = check_draw(0.1, 5.0);
    return r;
}

CHECK_TIMES(40, test_drawn_three, i)
{
    check_ask("The ball in the middle goes to and fro between the others. "
              "For how long?");
    const struct row r = draw_three();
    const struct end e = by_angles(&r);
    check_end(&r, &e);
}

CHECK_TIMES(20, test_drawn_heavy, i)
{
    check_ask("A first ball of another mass: how often does it knock?");
    const double M = check_draw(i % 2 ? 1.2 : 0.05, i % 2 ? 9.0 : 0.9);
    const double v = check_draw(0.1, 5.0);
    const size_t n = (size_t)check_draw_whole(2, 8);
    const struct row r = first_of(M, n, v);
    const struct end e = knocked(M, n, v);
    check_end(&r, &e);
}

/* Equal masses: the velocities are sorted in the end, and each collision
   puts one pair of them into the right order. */
CHECK_TIMES(20, test_drawn_equal, i)
{
    check_ask("Equal masses with any velocities: what does each collision "
              "do to them?");
    struct row r = equal_row((size_t)check_draw_whole(2, 10), 0,
                             check_draw(0.1, 5.0), 0.0);
    struct end e = {.collisions = 0};
    for (size_t k = 0; k < r.n; ++k) {
        size_t at = k;
        r.v[k] = check_draw_whole(-1000, 1000) / 16.0 + k * 0x1p-10;
        for (; at > 0 && e.v[at - 1] > r.v[k]; --at)
            e.v[at] = e.v[at - 1];
        e.v[at] = r.v[k];
        e.collisions += k - at;
    }
    check_end(&r, &e);
}

/* Any row in which it is clear who comes first. */
static struct row draw_row(bool strike, struct end *e)
{
    struct row r;
    bool clear;
    do {
        r = (struct row){.n = (size_t)check_draw_whole(3, 7)};
        for (size_t i = 0; i < r.n; ++i) {
            r.mass[i] = check_draw(0.2, 5.0);
            r.v[i] = strike && i > 0 ? 0.0 : check_draw(-3.0, 3.0);
        }
        r.v[0] = fabs(r.v[0]) + 0.5;
        clear = true;
        *e = unfolded(&r, 1000, &clear);
    } while (!clear);
    return r;
}

CHECK_TIMES(40, test_drawn_row, i)
{
    check_ask("Any masses, and any velocities: does each pair meet when "
              "its time has come, until none does?");
    struct end e;
    const struct row r = draw_row(i % 2 == 0, &e);
    check_end(&r, &e);
}

const struct check_suite check_suite = {
    .file = "11b-cradle.c",
    .title = "What leaves the cradle?",
    .minutes = 30,
    .equation = "eq:cradle",
    .tests =
        {{"two balls bounce off each other", test_two, 2, 0},
         {"one in, one out", test_one, 1, 0},
         {"as many out as in", test_some, 2, 0},
         {"who does not approach does not collide", test_none, 1, 0},
         {"a heavy first ball knocks again and again", test_heavy, 2, 0},
         {"few balls are as worked out on paper", test_fractions, 2, 0},
         {"who meets first collides first", test_order, 2, 0},
         {"a light ball between heavy ones goes to and fro", test_between,
          1, 0},
         {"any three", test_drawn_three, 1, 1},
         {"any first ball before a row of others", test_drawn_heavy, 1, 1},
         {"any velocities of equal balls", test_drawn_equal, 1, 1},
         {"any row", test_drawn_row, 1, 3},
         {0}},
    .idle = {test_none},
};
