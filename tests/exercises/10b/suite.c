/* The suite of exercise 10b, "The oscillator in closed form". */

#include "examiner/check.h"
#include "call.h"

/* What is expected at the time t. */
struct known {
    struct oscillator o;
    double t, x, v;
};

static const char *input(const struct known *k)
{
    return check_text("m = %g kg, c = %.17g kg/s, D = %.17g N/m, at first "
                      "x = %g m, v = %g m/s, t = %g s",
                      k->o.mass, k->o.damping, k->o.stiffness, k->o.x,
                      k->o.v, k->t);
}

static double own_frequency(const struct oscillator *o)
{
    return sqrt(o->stiffness / o->mass);
}

/* Damping in units of the critical one. */
static double ratio(const struct oscillator *o)
{
    return 0.5 * o->damping / sqrt(o->mass * o->stiffness);
}

/* What the exercise measures errors by. */
static double scale(const struct oscillator *o)
{
    return fabs(o->x) + fabs(o->v) / own_frequency(o);
}

/* ---- another way: x and v obey one equation of first order for two
   numbers, and their change in a short time, a matrix, is squared again and
   again. In long double, where that is longer. ---- */

struct matrix {
    long double m[2][2];
};

static struct matrix product(struct matrix a, struct matrix b)
{
    struct matrix c = {{{0.0L, 0.0L}, {0.0L, 0.0L}}};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k)
                c.m[i][j] += a.m[i][k] * b.m[k][j];
    return c;
}

/* The change in a time so short that ten terms of its series will do. */
static struct matrix short_time(struct matrix rates)
{
    struct matrix sum = {{{1.0L, 0.0L}, {0.0L, 1.0L}}}, term = sum;
    for (int order = 1; order <= 10; ++order) {
        term = product(term, rates);
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                sum.m[i][j] += term.m[i][j] /= order;
    }
    return sum;
}

/* An oscillator with x" = - square x - drag x', at the time t. Good for
   moderate damping and times. */
static struct known evolved(long double drag, long double square,
                            const struct oscillator *start, double t)
{
    struct known k = {*start, t, 0.0, 0.0};
    long double step = t;
    int doublings = 0;
    for (; step * (1.0L + drag + square) > 0.01L; ++doublings)
        step *= 0.5L;
    struct matrix m = short_time(
        (struct matrix){{{0, step}, {-square * step, -drag * step}}});
    for (; doublings > 0; --doublings)
        m = product(m, m);
    k.x = (double)(m.m[0][0] * start->x + m.m[0][1] * start->v);
    k.v = (double)(m.m[1][0] * start->x + m.m[1][1] * start->v);
    return k;
}

/* ---- the slips ---- */

enum slip { WHOLE, FEEDS, ROOT, START, STILL, FREQUENCY, SLIPS };

static void slips_of(const struct known *k, struct known slip[SLIPS])
{
    const struct oscillator *o = &k->o;
    const long double drag = (long double)o->damping / o->mass;
    const long double square = (long double)o->stiffness / o->mass;
    const double g = (double)drag * 0.5;
    const struct oscillator still = {.x = o->x};
    const struct oscillator later = {.x = o->x, .v = o->v - g * o->x};
    const struct oscillator sooner = {.x = o->x, .v = o->v + g * o->x};
    slip[WHOLE] = evolved(2.0L * drag, square, o, k->t);
    slip[FEEDS] = evolved(-drag, square, o, k->t);
    slip[ROOT] = evolved(drag, square * square, o, k->t);
    slip[START] = evolved(drag, square, &later, k->t);
    slip[STILL] = evolved(drag, square, &still, k->t);
    slip[FREQUENCY] = evolved(0.0L, square, &sooner, k->t);
    slip[FREQUENCY].x *= exp(-g * k->t);
    slip[FREQUENCY].v = NAN;
}

static const char because[] = "what was asked for";

/* limit: 1e-12 */
/* Some of the first digits are right. */
static void check_digits(const struct known *k, double off,
                         const char *quantity)
{
    const bool much = ratio(&k->o) > 2.0;
    CHECK_NEAR(
        off, .quantity = quantity, .input = input(k), .tolerance = 1e-12,
        .because = because,
        .mistakes = {
            {"digits-lost", off,
             much ? "The formula is right and its digits go. The slow one "
                    "of the two rates is a small difference of two large "
                    "numbers. What is the product of the two rates?"
                  : "The formula is right and its digits go. Which two "
                    "large numbers nearly cancel when the two rates are "
                    "nearly the same? Divide by their difference only "
                    "where something small stands above it."}});
}

/* What is no number says where it comes from. */
static struct check_mistake not_a_number(const struct known *k)
{
    if (fabs(ratio(&k->o) - 1.0) < 1e-9)
        return (struct check_mistake){
            "critical-divided", CHECK_NAN,
            "Not a number. At the critical damping the two rates are the "
            "same: what do you divide by, and what is the limit?"};
    if (ratio(&k->o) * own_frequency(&k->o) * k->t < 500.0)
        return (struct check_mistake){
            "root-of-a-negative", ratio(&k->o) > 1.0 ? CHECK_NAN : NAN,
            "Not a number: is there a root of a negative number in it? "
            "With much damping it does not swing. Which functions take the "
            "place of the cosine and the sine?"};
    return (struct check_mistake){
        "overflow", CHECK_NAN,
        "Not a number. How large is cosh(1000) in a double, and how small "
        "is the envelope that you multiply it by? Can you put them "
        "together before either is computed?"};
}

/* Wrong by much: is it one of the slips? They are worked out only where
   their way is good. */
static void check_large(const struct known *k, const char *quantity,
                        double got, bool place)
{
    const struct oscillator *o = &k->o;
    const double w = own_frequency(o), unit = place ? 1.0 : w;
    const double expected = place ? k->x : k->v;
    struct known slip[SLIPS];
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = *k;
    if (ratio(o) < 100.0 && w * k->t < 1000.0)
        slips_of(k, slip);
#define SLIP(i) (place ? slip[i].x : slip[i].v)
    CHECK_NEAR(
        got, .quantity = quantity, .unit = place ? "m" : "m/s",
        .input = input(k), .expected = expected,
        .tolerance = 1e-12 * unit * scale(o), .because = because,
        .mistakes = {
            not_a_number(k),
            {"whole-damping", SLIP(WHOLE),
             "The damping is twice what it should be. The envelope is that "
             "of the amplitude: with c/m it would be that of the energy."},
            {"damping-feeds", SLIP(FEEDS),
             "Here the damping drives the oscillator. Which sign has its "
             "force when v is positive?"},
            {"root-forgotten", SLIP(ROOT),
             "D/m is taken for a frequency here. Which unit has it?"},
            {"start-without-damping", SLIP(START),
             "The oscillator starts with another velocity than the one "
             "given. Differentiate your formula at t = 0: what does the "
             "envelope add?"},
            {"velocity-at-the-start-forgotten", SLIP(STILL),
             "This is the oscillator that is let go at rest. Where is the "
             "velocity at the start?"},
            {"frequency-without-damping", place ? slip[FREQUENCY].x : k->v,
             "The envelope is right. With damping, does it still swing as "
             "fast as without?"},
            {"envelope-not-differentiated",
             place ? k->x : k->v + o->damping * k->x / (2.0 * o->mass),
             "The place is right. The velocity is its derivative: two "
             "factors depend on t, the swing and the envelope."}});
#undef SLIP
}

static void check_one(const struct known *k, double got, bool place)
{
    const double unit = scale(&k->o) * (place ? 1.0 : own_frequency(&k->o));
    const double off = (got - (place ? k->x : k->v)) / unit;
    if (fabs(off) > 1e-12 && fabs(off) < 1e-4) {
        check_digits(
            k, off,
            place ? "error of the place, in units of |x| + |v|/w"
                  : "error of the velocity, in units of w |x| + |v|");
        return;
    }
    check_large(k,
                place ? "place at the time t" : "*velocity, at the time t",
                got, place);
}

static void check_known(const struct known *k)
{
    double v = CHECK_EMPTY;
    const double x = oscillate(&k->o, k->t, &v);
    check_one(k, x, true);
    check_one(k, v, false);
}

static void check_table(const struct known *k, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        check_known(&k[i]);
}

/* ---- the tests ---- */

/* One radian, and some turns; x + i v/w turns clockwise. */
/* limit: 100 s at sqrt(D/m) = 1/s */
static void test_free(void)
{
    static const double turns[] = {1.0, 2.5, 30.0, 100.0};
    check_ask("Without damping: which function has x for its value and v "
              "for its slope at t = 0?");
    for (size_t i = 0; i < sizeof turns / sizeof turns[0]; ++i) {
        const double c = cos(turns[i]), s = sin(turns[i]);
        const struct known a = {
            {2.0, 0.0, 8.0, 0.5, 0.0}, 0.5 * turns[i], 0.5 * c, -s};
        const struct known b = {
            {2.0, 0.0, 8.0, 0.0, 3.0}, 0.5 * turns[i], 1.5 * s, 3.0 * c};
        const struct known both = {{1.0, 0.0, 0.25, 2.0, -1.0},
                                   2.0 * turns[i],
                                   2.0 * c - 2.0 * s,
                                   -c - s};
        check_known(&a);
        check_known(&b);
        check_known(&both);
    }
}

/* From mpmath, in 40 digits. */
static void test_swings(void)
{
    static const struct known table[] = {{{1.0, 0.25, 1.0, 1.0, 0.0},
                                          3.0,
                                          -0.6637078168119896278,
                                          -0.1138649384701560546},
                                         {{2.0, 1.0, 8.0, 0.0, 1.5},
                                          2.5,
                                          -0.3922011535385431303,
                                          0.2954399351239783148},
                                         {{0.5, 0.125, 3.0, -1.0, 2.0},
                                          7.0,
                                          -0.2514754231060708227,
                                          -1.096573220790431098},
                                         {{4.0, 2.0, 1.0, 1.0, -1.0},
                                          30.0,
                                          0.0001099794973993205773,
                                          -0.0005041067038608385033}};
    check_ask("Put exp(-g t) times a swing into the equation of motion: "
              "which g, and which frequency, does it ask for?");
    check_table(table, sizeof table / sizeof table[0]);
}

static void test_creeps(void)
{
    static const struct known table[] = {{{1.0, 3.0, 2.0, 1.0, 0.0},
                                          1.5,
                                          0.3964732519289957149,
                                          -0.3466861835611317719},
                                         {{2.0, 8.0, 3.0, 0.0, 1.0},
                                          0.75,
                                          0.2094216862792759275,
                                          -0.01955566290797594444},
                                         {{0.5, 4.0, 1.0, -1.0, 2.0},
                                          6.0,
                                          -0.1628405768807708579,
                                          0.04206866017061724807},
                                         {{1.0, 64.0, 1.0, 1.0, 1.0},
                                          10.0,
                                          0.8688924437687194234,
                                          -0.01357976061494239544}};
    check_ask("With this much damping there are two rates, and both decay. "
              "How much of each is in the state at the start?");
    check_table(table, sizeof table / sizeof table[0]);
}

/* Twice the same rate: (x + (v + g x) t) exp(-g t). */
CHECK_TIMES(3, test_critical, i)
{
    check_ask("Both rates are the same, and one exponential is not enough "
              "for two numbers at the start. What else decays as fast?");
    static const double rate[] = {1.0, 0.5, 3.0};
    for (double t = 0.5; t < 40.0; t *= 3.0) {
        const double g = rate[i], e = exp(-g * t);
        const struct known k = {{2.0, 4.0 * g, 2.0 * g * g, 1.0, -2.0},
                                t,
                                (1.0 + (g - 2.0) * t) * e,
                                (-2.0 - g * (g - 2.0) * t) * e};
        check_known(&k);
    }
}

static struct known near_critical(double m, double square, double off,
                                  double x, double v, double t)
{
    const struct oscillator o = {m, 2.0 * m * sqrt(square) * (1.0 + off),
                                 m * square, x, v};
    return evolved((long double)o.damping / o.mass,
                   (long double)o.stiffness / o.mass, &o, t);
}

static void test_near_critical(void)
{
    for (double off = 0.1; off > 1e-17; off *= 0.1)
        for (double t = 0.5; t < 20.0; t *= 3.0) {
            const struct known more =
                near_critical(0.5, 2.0, off, 1.0, -0.5, t);
            const struct known less =
                near_critical(3.0, 0.75, -off, -0.25, 1.0, t);
            check_ask(
                "A hair beside the critical damping nothing much happens "
                "to the oscillator. What happens to your formula?");
            check_known(&more);
            check_known(&less);
        }
}

/* An oscillator that is made for its two rates, and for how much of each is
   in it. */
static struct known creeping(double m, double slow, double fast, double a,
                             double b, double t)
{
    return (struct known){{m, m * (slow + fast), m * (slow * fast), a + b,
                           -(slow * a + fast * b)},
                          t,
                          a * exp(-slow * t) + b * exp(-fast * t),
                          -slow * a * exp(-slow * t) -
                              fast * b * exp(-fast * t)};
}

/* The fast rate is up to 2^60 times as large as the slow one. What is lost
   when the two are added up does not change either of them by more than an
   epsilon of itself. */
static void test_much(void)
{
    check_ask("Much damping: one rate is very fast, the other one very "
              "slow. Which operation of yours does not survive that?");
    for (int power = 6; power <= 60; power += 9)
        for (double t = 0.25; t < 5.0; t *= 2.0) {
            const double fast = ldexp(1.1, power);
            const struct known slow = creeping(1.0, 0.7, fast, 1, 0, t);
            const struct known both = creeping(0.5, 0.9, fast, 2, -1, t);
            const struct known soon =
                creeping(2.0, 0.5, fast, 1, 1, t / fast);
            check_known(&slow);
            check_known(&both);
            check_known(&soon);
        }
}

/* After so long nothing is left. */
CHECK_TIMES(4, test_late, i)
{
    static const double late[] = {1e4, 1e9, 1e30, 1e150};
    static const double damping[] = {4.0, 5.0, 1e3};
    check_ask("After all this time nothing is left. What do you multiply "
              "by what?");
    for (int j = 0; j < 3; ++j) {
        const struct known k = {{1.0, damping[j], 4.0, 1.0, 1.0},
                                late[i] * damping[j],
                                0.0,
                                0.0};
        check_known(&k);
    }
}

CHECK_TIMES(5, test_start, i)
{
    static const double damping[] = {0.0, 0.5, 4.0, 4.0000001, 1e6};
    check_ask("No time has passed. Where is it?");
    const struct known k = {
        {1.0, damping[i], 4.0, -1.5, 2.5}, 0.0, -1.5, 2.5};
    check_known(&k);
}

/* Made for its envelope and its frequency: all of few binary digits, so
   that the oscillator has just these. */
static struct known draw_swinging(void)
{
    const double g = check_draw_whole(0, 60) / 64.0;
    const double n = check_draw_whole(1, 200) / 64.0;
    const double m = check_draw_whole(1, 99) / 8.0;
    const double a = check_draw_whole(-50, 50) / 16.0;
    const double b = check_draw_whole(-50, 50) / 16.0;
    const double square = g * g + n * n;
    const double t = check_draw(0.0, g > n ? 9.0 : 99.0) / sqrt(square);
    const double e = exp(-g * t), c = cos(n * t), s = sin(n * t);
    return (struct known){{m, 2.0 * g * m, m * square, a, n * b - g * a},
                          t,
                          e * (a * c + b * s),
                          e * ((n * b - g * a) * c - (n * a + g * b) * s)};
}

CHECK_TIMES(40, test_drawn_swinging, i)
{
    check_ask("Little damping: are the envelope, the frequency and the "
              "start right for any of them?");
    const struct known k = draw_swinging();
    check_known(&k);
}

CHECK_TIMES(40, test_drawn_creeping, i)
{
    check_ask("Much damping: are both rates right, and how much of each is "
              "in it?");
    const double slow = check_draw(0.02, 1.0);
    const double more =
        ldexp(check_draw(0.02, 1.0), check_draw_whole(0, 30));
    const double a = check_draw_whole(-50, 50) / 16.0;
    const struct known k =
        creeping(check_draw_whole(1, 99) / 8.0, slow, slow + more, a,
                 i % 2 ? -a : check_draw_whole(-50, 50) / 16.0,
                 check_draw(0.0, 3.0) / (i % 3 ? slow : slow + more));
    check_known(&k);
}

CHECK_TIMES(40, test_drawn_critical, i)
{
    check_ask("Near the critical damping: do all digits survive?");
    const double w = check_draw(0.2, 4.0);
    const double off = pow(10.0, -check_draw(1.0, 17.0));
    const struct known k =
        near_critical(check_draw(0.1, 5.0), w * w, i % 2 ? off : -off,
                      check_draw(-2.0, 2.0), check_draw(-2.0, 2.0),
                      check_draw(0.0, 20.0) / w);
    check_known(&k);
}

const struct check_suite check_suite = {
    .file = "10b-oscillator.c",
    .title = "The oscillator in closed form",
    .minutes = 30,
    .equation = "eq:oscillator",
    .tests = {{"without damping it swings for ever", test_free, 1, 0},
              {"with some damping it swings and dies away", test_swings, 2,
               0},
              {"with more it creeps back", test_creeps, 2, 0},
              {"critical damping is a limit of both", test_critical, 2, 0},
              {"near it no digits are lost", test_near_critical, 2, 0},
              {"with very much damping none are lost either", test_much, 2,
               0},
              {"in the end nothing is left", test_late, 1, 0},
              {"in the beginning nothing has happened", test_start, 1, 0},
              {"any that swings", test_drawn_swinging, 1, 2},
              {"any that creeps", test_drawn_creeping, 1, 2},
              {"any near the critical damping", test_drawn_critical, 1, 2},
              {0}},
};
