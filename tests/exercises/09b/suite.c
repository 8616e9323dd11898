/* The suite of exercise 09b, "Speeds for a circle". */

#include "examiner/check.h"
#include "call.h"

/* limit: 1e-12 */
static const double tolerance = 1e-12;
static const char because[] = "what was asked for";

/* ---- two bodies ---- */

struct binary {
    double k2, mass[2], d;
};

static double speed(const struct binary *b, int which)
{
    double v[2] = {CHECK_EMPTY, CHECK_EMPTY};
    binary_speeds(b->k2, b->mass[0], b->mass[1], b->d, &v[0], &v[1]);
    return v[which];
}

static const char *binary_text(const struct binary *b)
{
    return check_text(
        "k2 = %g m^3/(kg s^2), m1 = %g kg, m2 = %g kg, d = %g m", b->k2,
        b->mass[0], b->mass[1], b->d);
}

static bool near(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fabs(b);
}

/* Both speeds; the slips are those that explain both. */
static void check_binary(const struct binary *b, const double expected[2])
{
    const double got[2] = {speed(b, 0), speed(b, 1)};
    const double all = b->mass[0] + b->mass[1];
    const double both = expected[0] + expected[1];
    const double heavy = sqrt(b->k2 / b->d);
    const double reduced = sqrt(b->mass[0] * b->mass[1]) / all;
    const struct {
        const char *name;
        double v[2];
        const char *hint;
    } slip[] = {
        {"relative-speed",
         {both, both},
         "This is how fast the two pass each other. Seen from the centre "
         "of mass, which part of it has each?"},
        {"speeds-exchanged",
         {expected[1], expected[0]},
         "The two are exchanged. Which of them is faster, the heavy one or "
         "the light one?"},
        {"other-stands-still",
         {heavy * sqrt(b->mass[1]), heavy * sqrt(b->mass[0])},
         "This is the speed around a body that stands still. Does the "
         "other one stand still, and how large is the circle?"},
        {"half-each",
         {0.5 * both, 0.5 * both},
         "Each has half of the relative speed here. Where is the centre of "
         "mass?"},
        {"k-for-k2",
         {expected[0] / sqrt(sqrt(b->k2)), expected[1] / sqrt(sqrt(b->k2))},
         "This takes the root of k2 for k2. What does the force contain?"},
        {"distance-squared",
         {expected[0] / sqrt(b->d), expected[1] / sqrt(b->d)},
         "Your d is outside of the root. Which unit has the result?"},
        {"escape-speed",
         {expected[0] * sqrt(2.0), expected[1] * sqrt(2.0)},
         "This is larger by the root of 2: so fast they leave each other "
         "for ever. Which force is needed for a circle?"},
        {"reduced-mass",
         {expected[0] * reduced, expected[1] * reduced},
         "The reduced mass stands where the sum of the masses should. On "
         "which side of the equation of motion is it, and what cancels?"}};
    for (int k = 0; k < 2; ++k) {
        struct check c = {.quantity = k == 0 ? "v1" : "v2",
                          .unit = "m/s",
                          .input = binary_text(b),
                          .expected = expected[k],
                          .tolerance = tolerance * expected[k],
                          .because = because,
                          .equation = "eq:binary-speeds"};
        for (size_t i = 0; i < sizeof slip / sizeof *slip; ++i)
            if (near(got[0], slip[i].v[0]) && near(got[1], slip[i].v[1]))
                c.mistakes[i] = (struct check_mistake){slip[i].name, got[k],
                                                       slip[i].hint};
        /* No name may stand before others. */
        for (size_t i = 0, used = 0; i < 8; ++i)
            if (c.mistakes[i].name)
                c.mistakes[used++] = c.mistakes[i];
        check_near(got[k], c);
    }
}

/* 25 m^3/(kg s^2) and 9 m: with 4 kg in all the relative speed is 10/3 m/s.
 */
static void test_paper(void)
{
    check_ask("Where is the centre of mass, how large are the two circles, "
              "and which acceleration keeps each body on its own?");
    const struct binary unequal = {25.0, {3.0, 1.0}, 9.0};
    const struct binary other = {25.0, {1.0, 3.0}, 9.0};
    const struct binary equal = {8.0, {2.0, 2.0}, 2.0};
    check_binary(&unequal, (const double[]){5.0 / 6.0, 2.5});
    check_binary(&other, (const double[]){2.5, 5.0 / 6.0});
    check_binary(&equal, (const double[]){2.0, 2.0});
}

static void test_massless(void)
{
    check_ask(
        "One of the bodies has no mass. Where is the centre of mass then?");
    const struct binary first = {2.0, {0.0, 8.0}, 4.0};
    const struct binary second = {2.0, {8.0, 0.0}, 4.0};
    check_binary(&first, (const double[]){2.0, 0.0});
    check_binary(&second, (const double[]){0.0, 2.0});
}

/* The momenta are equal: the small speed is the large one times the
   quotient of the masses. */
static void test_unequal(void)
{
    for (int i = 1; i <= 12; ++i) {
        const double light = pow(10.0, -i), large = sqrt(5.0 / (1 + light));
        struct binary b = {5.0, {1.0, light}, 1.0};
        const double off = speed(&b, 0) / (large * light) - 1.0;
        CHECK_NEAR(
            off, .quantity = "relative error of v1",
            .input = binary_text(&b), .tolerance = tolerance,
            .because = because, .equation = "eq:binary-speeds",
            .question = "One is much heavier, and hardly moves. Are all "
                        "digits of its speed right?",
            .mistakes = {{"digits-lost", fabs(off) < 0.01 ? off : NAN,
                          "The first digits are right and the last ones "
                          "are lost. Is there a difference of two speeds "
                          "that are nearly the same?"}});
    }
}

/* From the answer: two speeds and a period. The circles are v T/(2 pi), the
   masses are to each other as the speeds of the others, and Kepler's third
   law says what k2 must be. */
CHECK_TIMES(30, test_drawn_binaries, i)
{
    static const double pi = 3.141592653589793;
    check_ask("Two bodies of any masses: which of the numbers is shared "
              "out, and in which proportion?");
    const double v[2] = {pow(10.0, check_draw(-4.0, 4.0)),
                         pow(10.0, check_draw(-4.0, 4.0))};
    const double period = check_draw(0.1, 100.0);
    const double unit = pow(10.0, check_draw(-5.0, 5.0));
    const struct binary b = {(v[0] + v[1]) * (v[0] + v[1]) * period /
                                 (2.0 * pi * unit),
                             {unit * v[1], unit * v[0]},
                             (v[0] + v[1]) * period / (2.0 * pi)};
    check_binary(&b, v);
}

/* ---- on one circle ---- */

struct ring {
    double k2;
    size_t n;
    double mass, radius;
};

/* The pull of all bodies on the one at (R, 0), as vectors: body j is at the
   angle a, and 1 - cos a is 2 sin^2 of half of it, which keeps the digits.
 */
static double pull(const struct ring *r)
{
    const long double pi = acosl(-1.0L);
    long double inwards = 0.0L;
    for (size_t j = 1; j < r->n; ++j) {
        const long double half = pi * (long double)j / (long double)r->n;
        const long double x = 2.0L * r->radius * sinl(half) * sinl(half);
        const long double y = r->radius * sinl(2.0L * half);
        const long double distance = sqrtl(x * x + y * y);
        inwards += r->k2 * (r->mass * x) / (distance * distance * distance);
    }
    return (double)inwards;
}

/* The slips as factors of the sum of 1/sin(pi j/n). */
static double sum_of(size_t n, int power, int turns)
{
    const double step = acos(-1.0) * turns / (double)n;
    double sum = 0.0;
    for (size_t j = 1; j < n; ++j)
        sum += pow(fabs(sin((double)j * step)), -power);
    return sum;
}

static void check_ring(const struct ring *r, double expected)
{
    const double n = (double)r->n,
                 unit = 0.5 * sqrt(r->k2 * r->mass / r->radius);
    const bool many = r->n > 3;
    const double got = choreography_speed(r->k2, r->n, r->mass, r->radius);
    const double next = 1.0 / sin(acos(-1.0) / n);
    CHECK_NEAR(got, .quantity = "the speed of each body", .unit = "m/s",
               .input = check_text(
                   "k2 = %g m^3/(kg s^2), n = %zu, %g kg each, radius %g m",
                   r->k2, r->n, r->mass, r->radius),
               .expected = expected, .tolerance = tolerance * expected,
               .because = because,
               .mistakes = {
                   {"neighbours-only", many ? unit * sqrt(2.0 * next) : NAN,
                    "Only the two neighbours pull here. How many others "
                    "are there?"},
                   {"pull-not-projected",
                    r->n > 2 ? unit * sqrt(sum_of(r->n, 2, 1)) : NAN,
                    "This adds up the whole pulls. How much of each points "
                    "to the centre?"},
                   {"whole-angle",
                    r->n % 2               ? unit * sqrt(sum_of(r->n, 1, 2))
                    : got > 1e3 * expected ? got
                                           : NAN,
                    "This takes the sine of the angle seen from the "
                    "centre. How long is the chord over it?"},
                   {"one-too-many", unit * sqrt(sum_of(r->n, 1, 1) + next),
                    "There is one term too many. How many OTHER bodies are "
                    "there?"},
                   {"mass-of-all", expected / sqrt(n),
                    "The mass is shared out among all bodies here. Whose "
                    "mass was given?"},
                   {"chord-without-the-two", 2.0 * expected,
                    "Twice as fast. How long is the way from a body to the "
                    "one across the circle: R, or 2 R?"},
                   {"all-in-the-middle", 2.0 * unit * sqrt(n - 1.0),
                    "This is the speed around a middle in which all the "
                    "others are. Where are they?"}});
}

/* Two are a binary of equal masses. Of three each pair is sqrt(3) R apart,
   and the pulls have half of sqrt(3) of them inwards: twice 1/3 of that.
   Four: two at the side with sqrt(1/8) and one across with 1/4. */
static void test_some(void)
{
    check_ask("Draw the bodies on their circle. How far is each of the "
              "others, and how much of its pull points to the centre?");
    const struct ring three = {1.0, 3, 1.0, 1.0};
    const struct ring four = {2.0, 4, 3.0, 0.5};
    const struct ring two = {4.0, 2, 9.0, 1.0};
    check_ring(&three, sqrt(1.0 / sqrt(3.0)));
    check_ring(&four, sqrt(12.0 * (0.25 + sqrt(0.5))));
    check_ring(&two, 3.0);
}

/* limit: 1 (body) */
static void test_one(void)
{
    const struct ring alone = {2.0, 1, 3.0, 0.5};
    CHECK_NEAR(
        choreography_speed(alone.k2, alone.n, alone.mass, alone.radius),
        .quantity = "the speed of one body alone", .unit = "m/s",
        .input = "k2 = 2 m^3/(kg s^2), n = 1, 3 kg, radius 0.5 m",
        .because = "nothing pulls",
        .question =
            "Nobody pulls at it. How fast must it go to stay where it is?");
}

static void test_many(void)
{
    static const size_t count[] = {5, 6, 7, 12, 101, 1000, 4001};
    check_ask("Many bodies: whose pull is the largest, and are the digits "
              "of all terms right?");
    for (size_t i = 0; i < sizeof count / sizeof *count; ++i) {
        const struct ring r = {1.5, count[i], 0.25, 2.0};
        check_ring(&r, sqrt(pull(&r) * r.radius));
    }
}

CHECK_TIMES(30, test_drawn_rings, i)
{
    check_ask("The pull of all others, towards the centre, is v^2/R. Is it "
              "so here?");
    const struct ring r = {pow(10.0, check_draw(-4.0, 4.0)),
                           (size_t)check_draw_whole(2, 400),
                           check_draw(0.01, 9.0), check_draw(0.1, 50.0)};
    check_ring(&r, sqrt(pull(&r) * r.radius));
}

/* A choreography of two is a binary. */
CHECK_TIMES(10, test_agree, i)
{
    const double k2 = check_draw(0.1, 9.0), mass = check_draw(0.1, 9.0);
    const struct binary b = {k2, {mass, mass}, check_draw(0.1, 9.0)};
    const double one = choreography_speed(k2, 2, mass, 0.5 * b.d);
    CHECK_NEAR(
        one, .quantity = "speed of a choreography of two with radius d/2",
        .unit = "m/s", .input = binary_text(&b), .expected = speed(&b, 0),
        .tolerance = 2.0 * tolerance * speed(&b, 0),
        .because = "what was asked for, twice",
        .question = "The one function says this speed and the other that. "
                    "Which is right?");
}

const struct check_suite check_suite = {
    .file = "09b-speeds.c",
    .title = "Speeds for a circle",
    .minutes = 20,
    .equation = "eq:choreography-speed",
    .tests = {{"binaries on paper", test_paper, 2, 0},
              {"a body without mass", test_massless, 1, 0},
              {"a heavy one hardly moves", test_unequal, 1, 0},
              {"two, three and four on a circle", test_some, 2, 0},
              {"one alone on its circle", test_one, 1, 0},
              {"many on a circle", test_many, 1, 0},
              {"drawn binaries", test_drawn_binaries, 1, 1},
              {"drawn choreographies", test_drawn_rings, 1, 1},
              {"two on a circle are a binary", test_agree, 1, 1},
              {0}},
    .idle = {test_one},
};
