/* The suite of exercise 09a, "The potential of the softened force". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 64 };

struct bodies {
    const char *text;
    size_t n;
    double k2, softening;
    double mass[MOST], x[3 * MOST];
};

#define BODIES(...) ((struct bodies){__VA_ARGS__})

/* Body i to a place; all bodies must be counted first. */
static void place(struct bodies *b, size_t i, double x, double y, double z)
{
    b->x[i] = x;
    b->x[b->n + i] = y;
    b->x[2 * b->n + i] = z;
}

/* What the student's function says: the potential of body i, or the energy
   for i = n; and for i = n + 1 what stands behind the potentials. */
double answer_of(const struct bodies *b, size_t i)
{
    double potential[MOST + 1];
    for (size_t k = 0; k <= b->n; ++k)
        potential[k] = k < b->n ? CHECK_EMPTY : 4096.0;
    const double energy = potential_energy(b->n, b->mass, b->x, b->k2,
                                           b->softening, potential);
    return i < b->n ? potential[i] : i == b->n ? energy : potential[b->n];
}

/* ---- what comes out, right and wrong ---- */

enum kind {
    RIGHT,
    HARD,
    ADDED,
    NOT_SQUARED,
    POWER,
    FORCE,
    REPELS,
    ROOT,
    FLAT,
    BY_BODY
};

/* Of a kilogram at this squared distance from one. */
static long double share(const struct bodies *b, enum kind kind,
                         long double rr)
{
    const long double e = b->softening, soft = rr + e * e, k2 = b->k2;
    switch (kind) {
    case HARD: return -k2 / sqrtl(rr);
    case ADDED: return -k2 / (sqrtl(rr) + e);
    case NOT_SQUARED: return -k2 / sqrtl(rr + e);
    case POWER: return -k2 / (soft * sqrtl(soft));
    case FORCE: return -k2 * rr / (soft * sqrtl(soft));
    case REPELS: return k2 / sqrtl(soft);
    case ROOT: return -sqrtl(k2) / sqrtl(soft);
    default: return -k2 / sqrtl(soft);
    }
}

static long double apart(const struct bodies *b, size_t i, size_t j,
                         enum kind kind)
{
    const size_t axes = kind == FLAT ? 2 : 3;
    long double rr = 0.0L;
    for (size_t k = axes; k-- > 0;) {
        const long double d =
            kind == BY_BODY
                ? (long double)b->x[3 * i + k] - b->x[3 * j + k]
                : (long double)b->x[k * b->n + i] - b->x[k * b->n + j];
        rr += d * d;
    }
    return rr;
}

/* The potential of body i, or half the sum of all. */
static double value(const struct bodies *b, enum kind kind, size_t i)
{
    long double sum = 0.0L;
    if (i < b->n) {
        for (size_t j = b->n; j-- > 0;)
            sum += j == i
                       ? 0.0L
                       : b->mass[j] * share(b, kind, apart(b, i, j, kind));
        return (double)sum;
    }
    for (size_t j = 0; j < b->n; ++j)
        sum += 0.5L * b->mass[j] * value(b, kind, j);
    return (double)sum;
}

static double own(const struct bodies *b, size_t i)
{
    double mass = 0.0;
    for (size_t j = 0; j < b->n; ++j)
        mass += j == i ? 0.0 : b->mass[j];
    return value(b, RIGHT, i) / mass * b->mass[i];
}

static double massless(const struct bodies *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < b->n; ++i)
        sum += 0.5 * value(b, RIGHT, i);
    return sum;
}

static double with_itself(const struct bodies *b, size_t i)
{
    if (i < b->n)
        return value(b, RIGHT, i) - b->k2 * b->mass[i] / b->softening;
    double energy = value(b, RIGHT, i);
    for (size_t j = 0; j < b->n; ++j)
        energy -= 0.5 * b->k2 * b->mass[j] * b->mass[j] / b->softening;
    return energy;
}

static bool near(double a, double b)
{
    return a == b || fabs(a - b) <= 1e-11 * (fabs(a) + fabs(b));
}

enum { SLIPS = 14 };

static void slips_of(const struct bodies *b, size_t i,
                     struct check_mistake slip[SLIPS])
{
    const bool all = i == b->n;
    const struct check_mistake known[SLIPS] = {
        {"softening-forgotten", value(b, HARD, i),
         "This is the potential without softening. Of which force is it?"},
        {"softening-beside-the-root", value(b, ADDED, i),
         "The softening is added to the distance. What is the derivative "
         "of that, and is it the force that was given?"},
        {"softening-not-squared", value(b, NOT_SQUARED, i),
         "The softening stands under the root as it is. Which unit has it, "
         "and which has r^2?"},
        {"power-of-the-force", value(b, POWER, i),
         "This has the power 3/2 of the force. What does integrating do to "
         "a power?"},
        {"force-for-potential", value(b, FORCE, i),
         "This is force times distance. For which force would that be the "
         "potential, and is it this one?"},
        {"sign-of-the-potential", value(b, REPELS, i),
         "The size is right. Bodies fall towards each other: does the "
         "potential rise or fall on the way?"},
        {"k-for-k2", value(b, ROOT, i),
         "This takes the root of k2. What does the force contain?"},
        {"only-in-the-plane", value(b, FLAT, i),
         "This is the potential as seen from above. How many coordinates "
         "has a body?"},
        {"body-by-body", value(b, BY_BODY, i),
         "This reads x as x, y, z of body 0, then those of body 1. In "
         "which order do the numbers stand in x?"},
        {"half-at-each-body", all ? NAN : 0.5 * value(b, RIGHT, i),
         "Half of it. A pair has one energy; but what is the potential of "
         "one body at the place of the other?"},
        {"own-mass", all ? NAN : own(b, i),
         "This takes the mass of the body that feels. For each kilogram "
         "there: which masses act on it?"},
        {"pairs-counted-twice", all ? 2.0 * value(b, RIGHT, i) : NAN,
         "Twice as much. The stone and the Earth: have they one energy, or "
         "two?"},
        {"energy-without-mass", all ? massless(b) : NAN,
         "This adds up potentials. How much energy has a body of 2 kg "
         "there?"},
        {"itself-counted", b->softening > 0.0 ? with_itself(b, i) : NAN,
         "Each body feels itself here. Whose potential was wanted?"}};
    for (int k = 0; k < SLIPS; ++k)
        slip[k] = known[k];
}

/* Body i, or the energy for i = n. All terms have one sign: a rounding for
   each, and a dozen for the distances. */
static void check_value(const struct bodies *b, size_t i, double expected)
{
    const double got = answer_of(b, i);
    struct check_mistake slip[SLIPS];
    struct check c = {
        .quantity = i < b->n ? check_text("potential[%zu]", i)
                             : "the potential energy",
        .unit = i < b->n ? "m^2/s^2" : "J",
        .input = check_text("%s; k2 = %g m^3/(kg s^2), softening %g m",
                            b->text, b->k2, b->softening),
        .expected = expected,
        .tolerance =
            (2.0 * (double)b->n + 16.0) * DBL_EPSILON * fabs(expected),
        .because = "2 epsilons for each body, and 16 for the distances"};
    slips_of(b, i, slip);
    for (size_t k = 0, used = 0; k < SLIPS && used < 8; ++k)
        if (near(got, slip[k].value))
            c.mistakes[used++] = slip[k];
    check_near(got, c);
}

static void check_behind(const struct bodies *b)
{
    CHECK_NEAR(
        answer_of(b, b->n + 1), .quantity = "what stands behind potential",
        .input = b->text, .expected = 4096.0, .because = "it is nobody's",
        .question = "How many bodies are there, and which is the last?");
}

static void check_all(const struct bodies *b)
{
    for (size_t i = 0; i <= b->n; ++i)
        check_value(b, i, value(b, RIGHT, i));
    check_behind(b);
}

/* ---- the tests ---- */

/* 3 m apart, and 4 m of softening: the root is 5 m. */
static void test_two(void)
{
    check_ask(
        "Two bodies, 3 m apart: which root belongs to a softening of 4 m, "
        "and which potential has each at the place of the other?");
    struct bodies b = BODIES("2 kg and 6 kg, 3 m apart along x", 2, 15.0,
                             4.0, {2.0, 6.0}, {1.0, 4.0});
    check_value(&b, 0, -18.0);
    check_value(&b, 1, -6.0);
    check_value(&b, 2, -36.0);
    check_behind(&b);
}

/* The way is (2, 3, 6) m, 7 m long, and 24 m of softening make 25. */
CHECK_TIMES(3, test_axes, i)
{
    check_ask("The way from one to the other has three parts. Where in x "
              "stands each of them?");
    static const char *const text[] = {
        "5 kg and 1 kg, a way of (2, 3, 6) m from one to the other",
        "5 kg and 1 kg, a way of (3, 6, 2) m from one to the other",
        "5 kg and 1 kg, a way of (6, 2, 3) m from one to the other"};
    static const double way[] = {2.0, 3.0, 6.0};
    struct bodies b = {text[i], 2, 100.0, 24.0, {5.0, 1.0}, {0.0}};
    place(&b, 0, 1.0, -2.0, 0.5);
    place(&b, 1, 1.0 + way[i], -2.0 + way[(i + 1) % 3],
          0.5 + way[(i + 2) % 3]);
    check_value(&b, 0, -4.0);
    check_value(&b, 1, -20.0);
    check_value(&b, 2, -20.0);
}

/* In the corners of a square of 3 m, with softening 4 m; the diagonal adds
   18 to 16. A heavy one is in the middle. */
static void test_five(void)
{
    struct bodies b = BODIES("four of 1 kg in the corners of a square of 3 "
                             "m, and one of 2 kg in its middle",
                             5, 1.0, 4.0, {1.0, 1.0, 1.0, 1.0, 2.0}, {0.0});
    for (size_t i = 0; i < 4; ++i)
        place(&b, i, i % 2 ? 3.0 : 0.0, 0.0, i / 2 ? 3.0 : 0.0);
    place(&b, 4, 1.5, 0.0, 1.5);
    const double side = 1.0 / 5.0, across = 1.0 / sqrt(34.0);
    const double half = 1.0 / sqrt(20.5);
    check_ask("Each body has four others. How many pairs are there, and is "
              "each counted once in the energy?");
    check_value(&b, 0, -2.0 * side - across - 2.0 * half);
    check_value(&b, 4, -4.0 * half);
    check_value(&b, 5, -4.0 * side - 2.0 * across - 8.0 * half);
}

static void test_hard(void)
{
    struct bodies b = BODIES(
        "2 kg, 3 kg and 4 kg at (0, 0, 0), (3, 4, 0) and (0, 0, -12) m", 3,
        2.0, 0.0, {2.0, 3.0, 4.0}, {0.0});
    place(&b, 1, 3.0, 4.0, 0.0);
    place(&b, 2, 0.0, 0.0, -12.0);
    check_ask("Without softening the potential is -k2 m/r. And what is it "
              "of a body at its own place?");
    check_value(&b, 0, -2.0 * (3.0 / 5.0 + 4.0 / 12.0));
    check_value(&b, 1, -2.0 * (2.0 / 5.0 + 4.0 / 13.0));
    check_value(&b, 3, -2.0 * (6.0 / 5.0 + 8.0 / 12.0 + 12.0 / 13.0));
    check_behind(&b);
}

/* The softened potential has a bottom. */
static void test_one_place(void)
{
    struct bodies b =
        BODIES("three bodies at one place, of 1 kg, 2 kg and 4 kg", 3, 3.0,
               0.5, {1.0, 2.0, 4.0}, {0.0});
    for (size_t i = 0; i < 3; ++i)
        place(&b, i, 7.0, -1.0, 2.0);
    check_ask("No distance at all, and a softening: what is left under the "
              "root?");
    check_value(&b, 0, -36.0);
    check_value(&b, 2, -18.0);
    check_value(&b, 3, -84.0);
}

static void test_few(void)
{
    struct bodies b = {"one body alone", 1, 3.0, 0.0, {5.0}, {1.0}};
    check_ask("There is no pair. What is the energy, and the potential of "
              "the others?");
    check_value(&b, 0, 0.0);
    check_value(&b, 1, 0.0);
    b.softening = 0.25;
    check_value(&b, 0, 0.0);
    check_value(&b, 1, 0.0);
    b.n = 0;
    b.text = "no body";
    check_value(&b, 0, 0.0);
    check_behind(&b);
}

/* A body without mass feels and is not felt. */
static void test_massless(void)
{
    struct bodies b =
        BODIES("a body of 10 kg, and one without mass 3 m from it", 2, 1.0,
               4.0, {10.0, 0.0}, {0.0, 3.0});
    check_ask(
        "A body without mass acts on nobody. What does it feel itself?");
    check_value(&b, 0, 0.0);
    check_value(&b, 1, -2.0);
    check_value(&b, 2, 0.0);
}

/* n equal bodies on a circle: a chord over the part j/n of it has the
   length 2 R sin(pi j/n). Its roundings are those of the places. */
CHECK_TIMES(3, test_ring, i)
{
    static const double pi = 3.141592653589793;
    static const size_t count[] = {3, 8, MOST};
    const size_t n = count[i];
    struct bodies b = BODIES(
        check_text(
            "%zu bodies of 2 kg on a circle of 3 m around the y axis", n),
        n, 1.5, 0.25 * i, {0.0}, {0.0});
    double sum = 0.0;
    for (size_t j = 0; j < n; ++j) {
        const double angle = 2.0 * pi * (double)j / (double)n;
        b.mass[j] = 2.0;
        place(&b, j, 3.0 * cos(angle), 1.0, 3.0 * sin(angle));
        if (j > 0)
            sum -= 3.0 / hypot(6.0 * sin(0.5 * angle), b.softening);
    }
    for (size_t j = 0; j <= n; j += j < 2 || j == n ? 1 : n - j)
        CHECK_NEAR(
            answer_of(&b, j),
            .quantity = j < n ? check_text("potential[%zu]", j)
                              : "the potential energy",
            .unit = j < n ? "m^2/s^2" : "J",
            .input = check_text("%s; k2 = %g m^3/(kg s^2), softening %g m",
                                b.text, b.k2, b.softening),
            .expected = j < n ? sum : sum * (double)n,
            .tolerance = 1e-12 * (double)n * fabs(sum),
            .because = "roundings of the places",
            .question = "On a ring all bodies feel the same potential. How "
                        "many pairs are there?");
}

/* ---- drawn bodies ---- */

struct bodies draw_bodies(size_t n)
{
    struct bodies b = BODIES(.n = n, .k2 = check_draw(0.1, 5.0),
                             .softening = check_draw(0.1, 2.0));
    for (size_t i = 0; i < n; ++i) {
        b.mass[i] = check_draw(0.1, 5.0);
        place(&b, i, check_draw(-3.0, 3.0), check_draw(-3.0, 3.0),
              check_draw(-3.0, 3.0));
    }
    b.text = check_text("%zu drawn bodies", n);
    return b;
}

/* The acceleration that was given, times the mass. */
static double force_on(const struct bodies *b, size_t i, size_t axis)
{
    double sum = 0.0;
    for (size_t j = 0; j < b->n; ++j) {
        const double soft =
            hypot(sqrt((double)apart(b, i, j, RIGHT)), b->softening);
        sum += b->mass[j] *
               (b->x[axis * b->n + j] - b->x[axis * b->n + i]) /
               pow(soft, 3.0);
    }
    return b->k2 * b->mass[i] * sum;
}

/* The energy at four places along an axis gives its slope with an error of
   fourth order: 4 h^4 times its fifth derivative, which is below 120 |u|/
   softening^5 for a pair; h is a thousandth of the softening, and rounding
   is divided by it. */
CHECK_TIMES(10, test_gradient, i)
{
    const size_t n = (size_t)check_draw_whole(2, 6);
    const struct bodies b = draw_bodies(n);
    const size_t body = (size_t)check_draw_whole(0, (int)n - 1);
    const size_t axis = (size_t)check_draw_whole(0, 2);
    const double h = 1e-3 * b.softening;
    double energy[4];
    for (int k = 0; k < 4; ++k) {
        static const double at[] = {-2.0, -1.0, 1.0, 2.0};
        struct bodies moved = b;
        moved.x[axis * n + body] += h * at[k];
        energy[k] = answer_of(&moved, n);
    }
    const double slope =
        (energy[0] - 8.0 * energy[1] + 8.0 * energy[2] - energy[3]) /
        (12.0 * h);
    const double size = fabs(value(&b, RIGHT, n)) / b.softening;
    CHECK_NEAR(
        -slope,
        .quantity = check_text(
            "minus the slope of your energy along %c of body %zu",
            "xyz"[axis], body),
        .unit = "N",
        .input = check_text("%s; k2 = %g m^3/(kg s^2), softening %g m",
                            b.text, b.k2, b.softening),
        .expected = force_on(&b, body, axis), .tolerance = 2e-9 * size,
        .because =
            "the energy's rounding over a thousandth of the softening",
        .question =
            "Move one body a little: the energy should change by minus "
            "force times way. Which potential has this force?");
}

CHECK_TIMES(12, test_drawn, i)
{
    check_ask("Many bodies of many masses: who acts on whom, and how often "
              "is a pair counted?");
    const struct bodies b =
        draw_bodies((size_t)(i < 10 ? check_draw_whole(2, 9) : MOST));
    check_all(&b);
}

const struct check_suite check_suite = {
    .file = "09a-potential.c",
    .title = "The potential of the softened force",
    .minutes = 20,
    .equation = "eq:softened-force",
    .tests = {{"two bodies", test_two, 2, 0},
              {"three directions", test_axes, 1, 0},
              {"five bodies and ten pairs", test_five, 2, 0},
              {"without softening", test_hard, 1, 0},
              {"bodies at one place", test_one_place, 1, 0},
              {"one body, or none", test_few, 1, 0},
              {"a body without mass", test_massless, 1, 0},
              {"a ring", test_ring, 1, 0},
              {"minus the slope is the force", test_gradient, 2, 2},
              {"drawn bodies", test_drawn, 2, 2},
              {0}},
};
