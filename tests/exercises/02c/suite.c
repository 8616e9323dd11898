/* The suite of exercise 02c, "A million seconds, no collision". */

#include "examiner/check.h"
#include <stdio.h>
#include <stdlib.h>
#include "call.h"

enum { MOST = 8 };

struct gas {
    size_t n;
    double length;
    double x[MOST], v[MOST];
};

/* What the student's function answers; untouched places read as NaN. */
static struct gas answer(const struct gas *g, double t)
{
    struct gas a = {.n = g->n, .length = g->length};
    for (size_t k = 0; k < MOST; ++k)
        a.x[k] = a.v[k] = CHECK_EMPTY;
    positions_at(g->n, g->length, g->x, g->v, t, a.x, a.v);
    return a;
}

static const char *input(const struct gas *g, double t)
{
    char list[400] = "";
    size_t used = 0;
    for (size_t k = 0; k < g->n && used < sizeof list; ++k)
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s%g m (%g m/s)", k ? ", " : "", g->x[k],
                                 g->v[k]);
    return check_text("t = %g s, length = %g m, from %s", t, g->length,
                      list);
}

static double fastest(const struct gas *g)
{
    double fast = 0.0;
    for (size_t k = 0; k < g->n; ++k)
        fast = fmax(fast, fabs(g->v[k]));
    return fast;
}

/* limit: 4 epsilons */
static double tolerance(const struct gas *g, double t)
{
    return 4.0 * DBL_EPSILON * (g->length + fastest(g) * t);
}

static const char because[] =
    "4 epsilons of the length and of the way at top speed: the roundings "
    "of one product, of one sum and of the numbers given";

/* The slips: what becomes of the ghost of one body. A ghost has passed
   through everything but, perhaps, the walls. */
enum ghost {
    FOLDED,         /* none: it is reflected each time */
    UNFOLDED,       /* the walls let it pass */
    PERIOD_HALVED,  /* it comes in again at the other wall */
    REFLECTED_ONCE, /* the first reflection is the last */
    NEGATIVE        /* a negative remainder is taken as it comes */
};

static double ghost_place(const struct gas *g, size_t k, double t,
                          enum ghost slip)
{
    const double way = g->x[k] + g->v[k] * t;
    const double l = g->length, rest = fmod(way, 2.0 * l);
    switch (slip) {
    case UNFOLDED: return way;
    case PERIOD_HALVED: return way - l * floor(way / l);
    case REFLECTED_ONCE:
        return way < 0.0 ? -way : way > l ? 2.0 * l - way : way;
    case NEGATIVE: return rest > l ? 2.0 * l - rest : rest;
    case FOLDED: break;
    }
    return fabs(rest) > l ? 2.0 * l - fabs(rest) : fabs(rest);
}

static double ghost_velocity(const struct gas *g, size_t k, double t)
{
    const double way = g->x[k] + g->v[k] * t;
    const double rest =
        way - 2.0 * g->length * floor(way / 2.0 / g->length);
    return rest > g->length ? -g->v[k] : g->v[k];
}

/* The ghost that has k others on its left. */
static size_t ghost_at(const struct gas *g, size_t k, double t,
                       enum ghost slip)
{
    for (size_t i = 0; i < g->n; ++i) {
        size_t left = 0;
        for (size_t j = 0; j < g->n; ++j)
            if (ghost_place(g, j, t, slip) < ghost_place(g, i, t, slip))
                ++left;
        if (left == k)
            return i;
    }
    return k;
}

static double sorted_place(const struct gas *g, size_t k, double t,
                           enum ghost slip)
{
    return ghost_place(g, ghost_at(g, k, t, slip), t, slip);
}

static void check_place(const struct gas *g, double t, size_t k, double got,
                        double expected)
{
    CHECK_NEAR(
        got, .quantity = check_text("x[%zu]", k), .unit = "m",
        .input = input(g, t), .expected = expected,
        .tolerance = tolerance(g, t), .because = because,
        .mistakes = {
            {"walls-forgotten", sorted_place(g, k, t, UNFOLDED),
             "This is outside the box, or was put there by a ghost that "
             "is. What does a ghost do at a wall?"},
            {"reflected-once", sorted_place(g, k, t, REFLECTED_ONCE),
             "Here a body is reflected once, and then never again. How "
             "many walls does it meet in this time?"},
            {"period-of-one-length", sorted_place(g, k, t, PERIOD_HALVED),
             "Here a body that leaves by the one wall comes in by the "
             "other. After which distance does one that is reflected begin "
             "anew?"},
            {"negative-remainder", sorted_place(g, k, t, NEGATIVE),
             "fmod() keeps the sign: fmod(-3, 8) is -3. To which place in "
             "the period from 0 to twice the length does a body belong "
             "that went to the left?"},
            {"ghosts-for-bodies", ghost_place(g, k, t, FOLDED),
             "There is a body at this place, but another one: your bodies "
             "have passed through each other. Which of them is the k-th "
             "from the left, before and after?"},
            /* Two ghosts that have met are in the wrong order, too. */
            {"numbered-from-the-right",
             g->n == 2 ? expected
                       : sorted_place(g, g->n - 1 - k, t, FOLDED),
             "The bodies are in the wrong order: which one is number 0 at "
             "the start, the one on the left or the one on the right?"}});
}

static void check_velocity(const struct gas *g, double t, size_t k,
                           double got, double expected)
{
    const size_t ghost = ghost_at(g, k, t, FOLDED);
    CHECK_NEAR(
        got, .quantity = check_text("v[%zu]", k), .unit = "m/s",
        .input = input(g, t), .expected = expected,
        .because =
            "a velocity is handed on and turned round, never computed",
        .mistakes = {
            {"velocity-not-reflected", g->v[ghost],
             "This is how fast the ghost moved at first. At the time t it "
             "is on its way back from a wall. In which half of its period "
             "is that so?"},
            {"velocity-left-behind", ghost_velocity(g, k, t),
             "The places were sorted and the velocities were not. Whose "
             "velocity has the body that is at this place now?"}});
}

static void check_gas(const struct gas *g, double t, const double x[],
                      const double v[])
{
    const struct gas a = answer(g, t);
    for (size_t k = 0; k < g->n; ++k) {
        check_place(g, t, k, a.x[k], x[k]);
        check_velocity(g, t, k, a.v[k], v[k]);
    }
}

static void check_one(double x0, double v0, double t, double x, double v)
{
    const struct gas g = {1, 4.0, {x0}, {v0}};
    check_ask("One body, two walls at 0 and 4 m. Follow it with a finger: "
              "which walls does it meet, and when?");
    check_gas(&g, t, &x, &v);
}

/* A body alone, several times to and fro. */
/* limit: 1 (body) */
static void test_walls(void)
{
    check_one(1.0, 1.0, 2.0, 3.0, 1.0);
    check_one(1.0, 1.0, 4.5, 2.5, -1.0);
    check_one(1.0, 1.0, 18.5, 3.5, 1.0);
    check_one(1.0, 1.0, 21.5, 1.5, -1.0);
    check_one(1.0, -2.0, 5.0, 1.0, 2.0);
    check_one(1.0, -2.0, 1.5, 2.0, 2.0);
    check_one(2.5, -3.0, 14.0, 0.5, -3.0);
    check_one(1.0, 0.0, 7.0, 1.0, 0.0);
}

static void test_start(void)
{
    const struct gas g = {
        4, 5.0, {0.5, 1.25, 3.0, 4.5}, {2.0, -1.5, 0.0, 0.5}};
    check_ask("No time has passed. What was there to change?");
    check_gas(&g, 0.0, g.x, g.v);
}

static void test_two(void)
{
    const struct gas g = {2, 8.0, {2.0, 5.0}, {1.0, -1.0}};
    const struct gas h = {2, 8.0, {2.0, 5.0}, {4.0, 1.0}};
    check_ask("The two have met and exchanged their velocities. Which of "
              "them is on the left, as before, and how fast is it now?");
    check_gas(&g, 2.0, (const double[]){3.0, 4.0},
              (const double[]){-1.0, 1.0});
    check_gas(&h, 1.25, (const double[]){6.25, 7.0},
              (const double[]){1.0, 4.0});
}

/* The ghosts are at 1.5 m (on the way back), 3, 0.5, 2.25 and 2.5 m (on the
   way back). */
static void test_by_hand(void)
{
    const struct gas g = {
        5, 4.0, {0.5, 1.0, 1.5, 2.25, 3.0}, {3.0, 1.0, -0.5, 0.0, 1.25}};
    check_ask("Work this one out on paper: five ghosts, each with its "
              "walls only. In which order do they stand at last?");
    check_gas(&g, 2.0, (const double[]){0.5, 1.5, 2.25, 2.5, 3.0},
              (const double[]){-0.5, -3.0, 0.0, -1.25, 1.0});
}

static const struct gas odd = {
    6,
    1.7,
    {0.1, 0.35, 0.6, 0.93, 1.2, 1.59},
    {0.73137, -0.45713, 0.26359, -0.11903, 0.98721, -0.31327}};

static double energy(const double v[], size_t n)
{
    double sum = 0.0;
    for (size_t k = 0; k < n; ++k)
        sum += 0.5 * v[k] * v[k];
    return sum;
}

static void test_energy(void)
{
    const double t = 12.3;
    const struct gas a = answer(&odd, t);
    CHECK_NEAR(
        energy(a.v, odd.n),
        .quantity = "energy of all bodies, of 1 kg each", .unit = "J",
        .input = input(&odd, t), .expected = energy(odd.v, odd.n),
        .tolerance = 8.0 * DBL_EPSILON * energy(odd.v, odd.n),
        .because = "8 epsilons of the energy: a sum in another order",
        .question = "Velocities are handed on and turned round. Which one "
                    "have you lost, or given twice?");
}

/* In 6 s each of these goes through a whole number of periods of 6 m. */
static void test_return(void)
{
    const struct gas g = {
        4, 3.0, {0.25, 1.0, 1.5, 2.75}, {1.0, -2.0, 0.0, 3.0}};
    check_ask("After 6 s each ghost is where it began. What has become of "
              "the bodies?");
    check_gas(&g, 6.0, g.x, g.v);
    check_ask("All is as it was after 6 s, and so it is after 600000 s. "
              "What remembers the time in your program?");
    check_gas(&g, 6e5, g.x, g.v);
}

/* The same in whole nanometres and nm/s: no rounding at all. Fills in where
   each body is; false when two of them, or a body and a wall, are
   within a micrometre. */
static bool exact_places(const struct gas *g, long long seconds, double x[])
{
    const long long length = llround(g->length * 1e9), micro = 1000;
    long long place[MOST + 1] = {0}; /* the left wall, then the bodies */
    for (size_t i = 0; i < g->n; ++i) {
        const long long way =
            llround(g->x[i] * 1e9) + llround(g->v[i] * 1e9) * seconds;
        const long long rest = llabs(way) % (2 * length);
        long long here = rest > length ? 2 * length - rest : rest;
        for (size_t k = 1; k <= i; ++k)
            if (place[k] > here) {
                const long long farther = place[k];
                place[k] = here;
                here = farther;
            }
        place[i + 1] = here;
    }
    bool apart = length - place[g->n] > micro;
    for (size_t k = 0; k < g->n; ++k) {
        apart = apart && place[k + 1] - place[k] > micro;
        x[k] = (double)place[k + 1] / 1e9;
    }
    return apart;
}

/* What comes of taking the periods off one by one. */
static double singly(const struct gas *g, size_t k, double t)
{
    struct gas ghosts = *g;
    const double period = 2.0 * g->length;
    for (size_t i = 0; i < g->n; ++i) {
        double way = g->x[i] + g->v[i] * t;
        while (way >= period)
            way -= period;
        while (way < 0.0)
            way += period;
        ghosts.x[i] = way;
    }
    return sorted_place(&ghosts, k, 0.0, FOLDED);
}

/* The places of the gas above and velocities that are drawn, one of them
   near 1 m/s; a time of whole seconds at which nobody touches anything. */
static void test_million(void)
{
    struct gas g = odd;
    double x[MOST];
    long long seconds;
    for (size_t k = 0; k < g.n; ++k)
        g.v[k] = check_draw_whole(k == 4 ? 900000 : -999999, 999999) / 1e6;
    do
        seconds = check_draw_whole(900000, 1100000);
    while (!exact_places(&g, seconds, x));
    const double t = (double)seconds;
    const struct gas a = answer(&g, t);
    check_ask(
        "The place is right. Which velocity has the ghost that is there?");
    for (size_t k = 0; k < g.n; ++k) {
        CHECK_NEAR(
            a.x[k] - x[k],
            .quantity =
                check_text("how far x[%zu] is from the true place", k),
            .unit = "m", .input = input(&g, t),
            .tolerance = tolerance(&g, t), .because = because,
            .question =
                "Which of your operations is done again and again in a "
                "million seconds, and adds its rounding each time?",
            .mistakes = {
                {"periods-one-by-one", singly(&g, k, t) - x[k],
                 "Each subtraction of a period is rounded, and there are "
                 "hundreds of thousands, nearly all alike. Which single "
                 "operation gives the remainder of a division?"}});
        check_velocity(&g, t, k, a.v[k],
                       ghost_velocity(&g, ghost_at(&g, k, t, FOLDED), t));
    }
}

static void test_backwards(void)
{
    static const char question[] =
        "All velocities were turned round at the time t, and the same time "
        "has passed again. Where are the bodies, and how do they move?";
    const double t = 1234.5;
    struct gas back = answer(&odd, t);
    for (size_t k = 0; k < odd.n; ++k)
        back.v[k] = -back.v[k];
    const struct gas a = answer(&back, t);
    for (size_t k = 0; k < odd.n; ++k) {
        CHECK_NEAR(a.x[k], .quantity = check_text("x[%zu]", k), .unit = "m",
                   .input = input(&back, t), .expected = odd.x[k],
                   .tolerance = 2.0 * tolerance(&odd, t),
                   .because = "twice 4 epsilons of the length and of the "
                              "way at top speed",
                   .question = question);
        CHECK_NEAR(a.v[k], .quantity = check_text("v[%zu]", k),
                   .unit = "m/s", .input = input(&back, t),
                   .expected = -odd.v[k],
                   .because = "a velocity is never computed",
                   .question = question);
    }
}

/* What the exercise spares: every collision, one after the other, with more
   digits. Gap k is to the left of body k, or of the right wall. */
struct box {
    size_t n;
    long double x[MOST + 2]; /* with the walls at both ends */
    double v[MOST + 2];
};

static void fly(struct box *b, long double time)
{
    for (size_t k = 1; k <= b->n; ++k)
        b->x[k] += b->v[k] * time;
}

/* The gap that closes next, and when; 0 where none does within the time. */
static size_t next_gap(const struct box *b, long double *time)
{
    size_t next = 0;
    for (size_t k = 1; k <= b->n + 1; ++k) {
        const long double gap = fmaxl(0.0L, b->x[k] - b->x[k - 1]);
        const double closing = b->v[k - 1] - b->v[k];
        if (closing > 0.0 && gap < closing * *time) {
            *time = gap / closing;
            next = k;
        }
    }
    return next;
}

/* A wall sends a body back, and two bodies exchange their velocities. */
static void collide(struct box *b, size_t gap)
{
    const double left = b->v[gap - 1], right = b->v[gap];
    if (gap > 1)
        b->v[gap - 1] = gap > b->n ? -left : right;
    if (gap <= b->n)
        b->v[gap] = gap > 1 ? left : -right;
}

static struct box collided(const struct gas *g, double t)
{
    struct box b = {.n = g->n};
    long double rest = t;
    b.x[g->n + 1] = g->length;
    for (size_t k = 0; k < g->n; ++k) {
        b.x[k + 1] = g->x[k];
        b.v[k + 1] = g->v[k];
    }
    for (;;) {
        long double wait = rest;
        const size_t gap = next_gap(&b, &wait);
        fly(&b, wait);
        if (gap == 0)
            return b;
        rest -= wait;
        collide(&b, gap);
    }
}

/* Whether two bodies, or a body and a wall, are within a micrometre. */
static bool touches(const struct box *b)
{
    for (size_t k = 1; k <= b->n + 1; ++k)
        if (b->x[k] - b->x[k - 1] < 1e-6L)
            return true;
    return false;
}

/* Places in whole millimetres, one body in each n-th of the box. */
static struct gas draw_gas(void)
{
    struct gas g = {.n = (size_t)check_draw_whole(1, MOST)};
    const int length = check_draw_whole(2000, 9000);
    const int part = length / (int)g.n;
    g.length = length / 1000.0;
    for (size_t k = 0; k < g.n; ++k) {
        g.x[k] = ((int)k * part + check_draw_whole(1, part - 1)) / 1000.0;
        g.v[k] = check_draw(-3.0, 3.0);
    }
    return g;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask(
        "Every collision in this box has been carried out, one after the "
        "other. Which body, and which wall, have your ghosts not come to?");
    const struct gas g = draw_gas();
    double t, x[MOST];
    struct box b;
    do {
        t = check_draw(0.0, 40.0);
        b = collided(&g, t);
    } while (touches(&b));
    for (size_t k = 0; k < g.n; ++k)
        x[k] = (double)b.x[k + 1];
    check_gas(&g, t, x, b.v + 1);
}

const struct check_suite check_suite = {
    .file = "02c-relabel.c",
    .title = "A million seconds, no collision",
    .minutes = 30,
    .equation = "eq:flight",
    .tests = {{"at time 0 nothing has changed", test_start, 1, 0},
              {"a body alone goes to and fro between its walls", test_walls,
               2, 0},
              {"two that meet exchange their velocities", test_two, 1, 0},
              {"five bodies are where they are on paper", test_by_hand, 2,
               0},
              {"the energy stays what it was", test_energy, 1, 0},
              {"after a whole number of periods all is as it was",
               test_return, 1, 0},
              {"after a million seconds every place is right", test_million,
               2, 1},
              {"turned round in time the bodies come back", test_backwards,
               1, 0},
              {"forty boxes are as all their collisions leave them",
               test_drawn, 1, 3},
              {0}},
    .idle = {test_start, test_energy, test_return, test_backwards},
};
