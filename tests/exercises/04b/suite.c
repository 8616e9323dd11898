/* The suite of exercise 04b, "One blow at a time". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 400 };

struct job {
    size_t n;
    const struct sort *rain;
    double im, V;
    const char *name; /* NULL: the sorts are listed */
};

static const char *input(const struct job *j)
{
    const char *list = j->name ? j->name : "";
    for (size_t i = 0; !j->name && i < j->n; ++i) {
        const struct sort *s = &j->rain[i];
        list = check_text("%s%s%g kg at %g m/s (%g left, %g right)", list,
                          i ? ", " : "", s->m, s->v, s->left, s->right);
    }
    return check_text("%s; im = %g /kg, V = %g m/s", list, j->im, j->V);
}

/* What is known, or mistaken, about a blow. */
struct idea {
    double turned; /* 2: the particle is turned round; 1: it is stopped */
    double first;  /* how often V stands in the first order: 2 */
    double second; /* and in the second: 0 */
    bool rate;     /* blows in a second, and not in a metre */
    bool away;     /* those that fly away count as well */
    bool added;    /* both sides push to the right */
    bool stiff;    /* the wall has no mass of its own */
};

static const struct idea right = {2.0, 2.0, 0.0, true, false, false, false};

/* The sum over sorts and sides; `size` is that of all its terms. */
static double force(const struct job *j, struct idea k, double *size)
{
    double sum = 0.0, all = 0.0;
    for (size_t i = 0; i < 2 * j->n; ++i) {
        const struct sort *s = &j->rain[i / 2];
        const double side = i % 2 ? -1.0 : 1.0;
        const double many = i % 2 ? s->right : s->left;
        const double m = 1.0 / (1.0 / s->m + (k.stiff ? 0.0 : j->im));
        const double a = side * s->v, V = side * j->V;
        if (a <= 0.0 && !k.away)
            continue;
        const double blows = k.rate ? a : 1.0;
        const double push =
            k.turned * m * many *
            (blows * a - k.first * blows * V + k.second * V * V);
        sum += k.added ? push : side * push;
        all += fabs(push) + 4.0 * m * many * fabs(a * V);
    }
    if (size)
        *size = all;
    return sum;
}

static double wrong(const struct job *j, struct idea k)
{
    return force(j, k, NULL);
}

/* The sum of the frictions of both sides, or what is left of one when the
   other is taken away. */
static double friction(const struct job *j, bool against, bool stiff)
{
    double sum = 0.0;
    for (size_t i = 0; i < j->n; ++i) {
        const struct sort *s = &j->rain[i];
        const double m = 1.0 / (1.0 / s->m + (stiff ? 0.0 : j->im));
        sum += 4.0 * m * fmax(s->v, 0.0) * s->left;
        sum +=
            (against ? 1.0 : -1.0) * 4.0 * m * fmin(s->v, 0.0) * s->right;
    }
    return sum;
}

/* Each term has some eight roundings, and the sum one for each term. */
static double allowed(const struct job *j, double size)
{
    return (16.0 + (double)j->n) * DBL_EPSILON * size;
}

static const char because[] = "the roundings of each term and of their sum";

static double answer(const struct job *j, double *friction)
{
    *friction = CHECK_EMPTY;
    return rain_force(j->n, j->rain, j->im, j->V, friction);
}

static void check_force(const struct job *j)
{
    double size, slows;
    const double expected = force(j, right, &size);
    struct idea stopped = right, metre = right, away = right, added = right,
                harder = right, square = right, ground = right,
                stiff = right;
    stopped.turned = 1.0;
    metre.rate = false;
    metre.first = 1.0;
    away.away = true;
    added.added = true;
    harder.first = 1.0;
    square.second = 1.0;
    ground.first = 0.0;
    stiff.stiff = true;
    CHECK_NEAR(
        answer(j, &slows), .quantity = "mean force on the wall",
        .unit = "N", .input = input(j), .expected = expected,
        .tolerance = allowed(j, size), .because = because,
        .mistakes = {
            {"stopped-not-turned", wrong(j, stopped),
             "With this the particles would stick to the wall. With which "
             "momentum do they leave it?"},
            {"per-metre", wrong(j, metre),
             "You have one blow for each particle in a metre. How many of "
             "them arrive in a second?"},
            {"flying-away-counted", wrong(j, away),
             "Particles that fly away from the wall push it here. Which "
             "signs must a velocity have on the left, and on the right?"},
            {"both-to-the-right", wrong(j, added),
             "A particle that comes from the right pushes the wall as one "
             "from the left does. Which way does its momentum change?"},
            {"blows-as-often", wrong(j, harder),
             "The blows are weaker on a wall that recedes, and that you "
             "have. Do they also come as often as before?"},
            {"second-order-kept", wrong(j, square),
             "What was asked for is the first order in V. Which part of "
             "yours stays the same when V changes its sign?"},
            {"wall-at-rest", wrong(j, ground),
             "This is the force on a wall at rest. What does the particle "
             "see of the wall's velocity?"},
            {"wall-never-yields", wrong(j, stiff),
             "This wall has a mass, and each blow moves it a little. By "
             "how much less is the particle turned round then?"}});
}

static void check_friction(const struct job *j)
{
    const double expected = friction(j, false, false);
    double slows;
    answer(j, &slows);
    CHECK_NEAR(
        slows, .quantity = "friction", .unit = "kg/s", .input = input(j),
        .expected = expected, .tolerance = allowed(j, expected),
        .because = because,
        .mistakes = {
            {"left-empty", CHECK_EMPTY,
             "Not a number. Has anything been put into *friction?"},
            {"half-the-friction", 0.5 * expected,
             "Half of it. V makes the blows weaker, and what else does it "
             "do to them?"},
            {"frictions-cancel", friction(j, true, false),
             "The pressures of both sides cancel. But when the wall moves "
             "to the right, are there more blows from there, or fewer, and "
             "which way do they push?"},
            {"sign-of-friction", -expected,
             "A force that grows with V would drive the wall faster and "
             "faster. Does it fall or grow here?"},
            {"wall-never-yields", friction(j, false, true),
             "This wall has a mass, and each blow moves it a little. By "
             "how much less is the particle turned round then?"}});
}

static void test_rest(void)
{
    static const struct sort one[] = {{2.0, 3.0, 5.0, 0.0}};
    static const struct sort two[] = {{2.0, 3.0, 5.0, 0.0},
                                      {0.5, 8.0, 0.25, 0.0}};
    check_ask("Work this one out on paper: what does one particle leave "
              "with the wall, and how many arrive in a second?");
    check_force(&(struct job){1, one, 0, 0, NULL});
    check_force(&(struct job){2, two, 0, 0, NULL});
}

static void test_right(void)
{
    static const struct sort other[] = {{2.0, -3.0, 0.0, 5.0}};
    static const struct sort both[] = {{2.0, 3.0, 5.0, 0.0},
                                       {1.0, -4.0, 0.0, 7.0}};
    check_ask("Look at it in a mirror: what has another sign there?");
    check_force(&(struct job){1, other, 0, 0, NULL});
    check_force(&(struct job){2, both, 0, 0, NULL});
}

static void test_away(void)
{
    static const struct sort rain[] = {
        {2.0, 3.0, 5.0, 4.0}, {1.0, -4.0, 6.0, 9.0}, {3.0, 0.0, 2.0, 2.0}};
    check_ask("Particles of each sort are on both sides. Which of them "
              "ever come to the wall?");
    check_force(&(struct job){3, rain, 0, 0, NULL});
}

static void test_moves(void)
{
    static const struct sort rain[] = {{2.0, 3.0, 5.0, 0.0}};
    check_ask("The wall recedes, or comes to meet the rain. What changes "
              "about one blow, and what about their number?");
    const struct job recedes = {1, rain, 0, 0.125, NULL};
    const struct job comes = {1, rain, 0, -0.125, NULL};
    check_force(&recedes);
    check_friction(&recedes);
    check_force(&comes);
    check_friction(&comes);
}

static void test_both(void)
{
    static const struct sort rain[] = {{2.0, 3.0, 5.0, 5.0},
                                       {2.0, -3.0, 5.0, 5.0},
                                       {1.0, 0.0, 9.0, 9.0},
                                       {1.0, -2.0, 1.0, 4.0}};
    const struct job j = {4, rain, 0, 0.25, NULL};
    check_ask("Two gases that press alike, and a wall that moves. Which "
              "side pushes more, and what is left of each?");
    check_force(&j);
    check_friction(&j);
}

static void test_light(void)
{
    static const struct sort rain[] = {{2.0, 3.0, 5.0, 0.0},
                                       {0.5, -8.0, 0.0, 1.0}};
    check_ask(
        "A wall as light as a particle takes its velocity, not twice as "
        "much. What does one blow give to a wall of inverse mass im?");
    const struct job rest = {2, rain, 0.5, 0, NULL};
    const struct job moves = {2, rain, 2.0, 0.25, NULL};
    check_force(&rest);
    check_force(&moves);
    check_friction(&moves);
}

/* Both gases have Maxwell's velocities, in strips of h = 0.05 thermal ones;
   the middle of a strip stands for it. On either side of the kink of |v|
   that adds the part h^2/24 = 1.04e-4 to the integral of u exp(-u^2/2). */
static void test_maxwell(void)
{
    static struct sort rain[MOST];
    const double h = 0.05, m = 1.5, kT = 6.0, each = 2.5;
    const double thermal = sqrt(kT / m), pi = acos(-1.0);
    for (int i = 0; i < MOST; ++i) {
        const double u = (i - MOST / 2 + 0.5) * h;
        const double many = each * h * exp(-0.5 * u * u) / sqrt(2.0 * pi);
        rain[i] = (struct sort){m, u * thermal, many, many};
    }
    const struct job j = {MOST, rain, 0, 1e-3 * thermal,
                          "Maxwell's velocities on both sides, 2.5 "
                          "particles of 1.5 kg in a metre, kT = 6 J"};
    const double expected = 4.0 * each * sqrt(2.0 * m * kT / pi);
    double slows;
    answer(&j, &slows);
    CHECK_NEAR(slows, .quantity = "friction", .unit = "kg/s",
               .input = input(&j), .expected = expected,
               .tolerance = 2e-4 * expected,
               .because = "strips of 0.05 thermal velocities",
               .question = "In the book this is 4 m n <|v|>. Where does a "
                           "factor go astray when you add up sorts?");
}

/* The mean force itself, blow by blow, from the frame of the wall: exact as
   long as no particle is overtaken. It is a parabola in V, so its middle
   and its two ends tell its slope. */
static double exact(const struct job *j, double V)
{
    double sum = 0.0;
    for (size_t i = 0; i < j->n; ++i) {
        const struct sort *s = &j->rain[i];
        const double w = s->v - V, M = 1.0 / j->im;
        const double blow =
            j->im > 0.0 ? 2.0 * s->m * M / (s->m + M) * w : 2.0 * s->m * w;
        sum += blow * fabs(w) * (s->v > 0.0 ? s->left : s->right);
    }
    return sum;
}

CHECK_TIMES(40, test_drawn, i)
{
    struct sort rain[4];
    struct job j = {(size_t)check_draw_whole(1, 4), rain,
                    i % 4 ? check_draw(0.01, 3.0) : 0.0,
                    check_draw(-0.1, 0.1), NULL};
    double size, slows;
    for (size_t k = 0; k < j.n; ++k)
        rain[k] = (struct sort){check_draw(0.01, 5.0),
                                (check_draw_whole(0, 1) ? 1.0 : -1.0) *
                                    check_draw(1.0, 50.0),
                                check_draw(0.0, 9.0), check_draw(0.0, 9.0)};
    force(&j, right, &size);
    const double h = 0.5;
    const double slope = (exact(&j, -h) - exact(&j, h)) / (2.0 * h);
    const double expected = exact(&j, 0.0) - slope * j.V;
    const double got = answer(&j, &slows);
    check_ask("The force was found blow by blow, for a wall at rest and "
              "for one that moves to and fro. Which sorts push, and how?");
    CHECK_NEAR(got, .quantity = "mean force on the wall", .unit = "N",
               .input = input(&j), .expected = expected,
               .tolerance = 8.0 * allowed(&j, size), .because = because);
    CHECK_NEAR(slows, .quantity = "friction", .unit = "kg/s",
               .input = input(&j), .expected = slope,
               .tolerance = 16.0 * allowed(&j, size), .because = because);
    check_force(&j);
    check_friction(&j);
}

const struct check_suite check_suite = {
    .file = "04b-rain.c",
    .title = "One blow at a time",
    .minutes = 25,
    .equation = "eq:friction",
    .tests =
        {{"a wall at rest is pressed by what comes from the left",
          test_rest, 1, 0},
         {"what comes from the right pushes back", test_right, 1, 0},
         {"what flies away, or rests, never comes", test_away, 1, 0},
         {"a wall that moves meets more blows, or fewer, and other ones",
          test_moves, 2, 0},
         {"the frictions of both sides add up", test_both, 2, 0},
         {"a light wall gives way", test_light, 1, 0},
         {"Maxwell's rain has the friction of the book", test_maxwell, 1,
          0},
         {"forty rains press as they do blow by blow", test_drawn, 2, 2},
         {0}},
};
