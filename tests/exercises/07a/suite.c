/* The suite of exercise 07a, "How fast is a disk?". */

#include "examiner/check.h"
#include "call.h"

/* limit: 1e-12 */
static const double tolerance = 1e-12;
static const char because[] = "what was asked for";

/* A value from mpmath, in 60 digits. */
struct known {
    int n;
    double mean, v, below;
};

static double below(int n, double mean, double v)
{
    double fourth = CHECK_EMPTY;
    return speed_below(n, mean, v, &fourth);
}

static const char *input(const struct known *k)
{
    return check_text("n = %d disks, mean square %g m^2/s^2, v = %.10g m/s",
                      k->n, k->mean, k->v);
}

/* Laws that go as 1 - (1 - x)^power, to know mistakes by. */
static double roughly(double x, double power)
{
    return 1.0 - pow(1.0 - x, power);
}

static double density(const struct known *k)
{
    const double n = k->n, all = n * k->mean;
    return 2.0 * k->v / all * (n - 1.0) *
           pow(1.0 - k->v * k->v / all, n - 2.0);
}

/* Digits are lost where some of the first are right, or where the answer
   would be right if it were not so small. */
static void check_digits(const struct known *k, double got)
{
    const double off = (got - k->below) / k->below;
    CHECK_NEAR(off, .quantity = "relative error of the probability below v",
               .input = input(k), .tolerance = tolerance,
               .because = because,
               .mistakes = {
                   {"digits-lost", off,
                    "The formula is right, and its last digits are gone, "
                    "or all of them. What is left of a small share in 1 "
                    "minus it, what makes a high power of that, and which "
                    "two functions of <math.h> do without the 1?"}});
}

static void check_below(const struct known *k)
{
    const double got = below(k->n, k->mean, k->v), off = got - k->below;
    const double bell = -expm1(-k->v * k->v / k->mean);
    const double n = k->n, share = k->v * k->v / (n * k->mean);
    const bool few = fabs(got - bell) > 1e-12 * bell;
    if (few && (fabs(off) < 1e-6 * k->below ||
                (share < 1e-3 && fabs(off) < 1e-9))) {
        check_digits(k, got);
        return;
    }
    CHECK_NEAR(
        got, .quantity = "probability of a speed below v",
        .input = input(k), .expected = k->below,
        .tolerance = tolerance * k->below, .because = because,
        .equation = few ? "eq:speed-law" : "eq:maxwell-2d",
        .mistakes = {
            {"maxwell-for-few", bell,
             k->n < 1000
                 ? "This is the law of Maxwell and Boltzmann, in which any "
                   "speed is possible. How fast can one of these disks be?"
                 : "This is the law of Maxwell and Boltzmann, and it is "
                   "near. How many of your digits are right, and how many "
                   "were asked for?"},
            {"above-for-below", 1.0 - k->below,
             "This is the probability of a speed above v. What is left for "
             "those below?"},
            {"law-of-one-more", roughly(share, n),
             "This is the law for one disk more. What should come out for "
             "two disks, which share the energy in all ways alike?"},
            {"exponent-of-the-density", roughly(share, n - 2.0),
             "The exponent that the density has gives this. What does "
             "integrating do to a power?"},
            {"share-of-the-mean", roughly(k->v * k->v / k->mean, n - 1.0),
             "Here v^2 is divided by the mean of the squares. Of what is "
             "it a share that cannot be larger than 1?"},
            {"speed-not-squared", roughly(sqrt(share), n - 1.0),
             "This takes the speed, divided by the largest, for the share. "
             "What is shared among the disks: speed, or something that "
             "goes with its square?"},
            {"energy-for-square", roughly(0.5 * share, n - 1.0),
             "Half of v^2 is compared with a mean of v^2. Where is the "
             "other half?"},
            {"density-for-distribution", density(k),
             "This is the density at v. What was asked for is all that "
             "lies below v: which operation leads from the one to the "
             "other?"}});
}

static void check_table(const struct known *k, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        check_below(&k[i]);
}

static void test_two(void)
{
    static const struct known table[] = {{2, 3.0, 1.5, 0.375},
                                         {2, 0.5, 0.25, 0.0625},
                                         {2, 8.0, 3.0, 0.5625}};
    check_ask("Two disks: any way of sharing the energy is as likely as "
              "any other. Which share belongs to the speed v?");
    check_table(table, sizeof table / sizeof table[0]);
}

static void test_some(void)
{
    static const struct known table[] = {
        {3, 1.5, 1.5, 0.75},
        {5, 1.0, 0.5, 0.18549375},
        {5, 2.25, 1.75, 0.7194597612787684804},
        {10, 1.0, 1.0, 0.612579511},
        {10, 1.0, 3.0, 0.999999999},
        {64, 1.0, 0.25, 0.0596973597410599470},
        {250, 1.0, 0.5, 0.2205171430260359630},
        {250, 1.0, 2.0, 0.9819789741595798385},
        {250, 4.0, 2.5, 0.7901020125597663890}};
    check_ask("How does the law of two disks change with each disk that is "
              "added? Try three on paper.");
    check_table(table, sizeof table / sizeof table[0]);
}

/* Beyond the largest speed, and below any. */
static void check_outside(int n, double mean, double v, double expected)
{
    const struct known k = {n, mean, v, expected};
    const double share = v / n * v / mean;
    static const char most[] =
        "No disk can be as fast as that: it would have more than all the "
        "energy. How many of the speeds lie below this v?";
    const bool fast = v > 0.0;
    CHECK_NEAR(
        below(n, mean, v), .quantity = "probability of a speed below v",
        .input = input(&k), .expected = expected,
        .because = "nothing is to be computed here",
        .question = fast ? most
                         : "No speed is negative. How many of them lie "
                           "below this v?",
        .mistakes = {{"not-clamped",
                      fast ? roughly(share, n - 1.0) : expected, most},
                     {"not-clamped", fast ? CHECK_NAN : expected, most},
                     {"sign-of-the-speed",
                      fast ? expected : roughly(fmin(1.0, share), n - 1.0),
                      "This is the probability of a speed below -v: the "
                      "square does not know the sign. Can a speed be below "
                      "a negative number?"}});
}

static void test_outside(void)
{
    for (int n = 2; n <= 6; n += 2) {
        check_outside(n, 1.0, 2.5, 1.0);
        check_outside(n, 4.0, 7.0, 1.0);
        check_outside(n, 1.0, INFINITY, 1.0);
        check_outside(n, 1.0, 0.0, 0.0);
        check_outside(n, 1.0, -0.5, 0.0);
        check_outside(n, 1.0, -7.0, 0.0);
        check_outside(n, 1.0, -INFINITY, 0.0);
    }
    check_outside(4, 1.0, 2.0, 1.0);
}

/* limit: 1 (disk) */
static void test_one(void)
{
    static const double v[] = {0.5, 1.75, 2.25, 5.0};
    for (size_t i = 0; i < sizeof v / sizeof v[0]; ++i) {
        const struct known k = {1, 4.0, v[i], v[i] < 2.0 ? 0.0 : 1.0};
        CHECK_NEAR(below(k.n, k.mean, k.v),
                   .quantity = "probability of a speed below v",
                   .input = input(&k), .expected = k.below,
                   .because = "there is only one speed",
                   .question =
                       "One disk alone keeps its energy, and so its speed. "
                       "Which is it, and is it below v?");
    }
}

/* limit: 1e-20 (a share of the energy, which the chapter asks about) */
static void test_slow(void)
{
    static const struct known table[] = {
        {5, 1.0, 0x1p-12, 4.768371496766122386e-8},
        {3, 1.0, 0x1p-30, 5.782411586589356981e-19},
        {10, 4.0, 0x1p-40, 1.861156378244312268e-25},
        {250, 1.0, 0x1p-20, 9.058567229654278845e-13},
        {2, 1.0, 0x1p-400, 7.498484069478154774e-242}};
    check_ask("A very slow disk is rare, but how rare? Which of your "
              "numbers is near 1, and need it be?");
    check_table(table, sizeof table / sizeof table[0]);
}

/* limit: 1000000000 disks */
static void test_many(void)
{
    static const struct known table[] = {
        {10000, 1.0, 1.0, 0.6321021637834484207},
        {1000000, 1.0, 0.5, 0.2211990465658849202},
        {1000000, 1.0, 1.0, 0.6321203748887297444},
        {1000000, 1.0, 3.0, 0.9998765940832859131},
        {1000000, 1.0, 0x1p-20, 9.094937922778128759e-13},
        {10000000, 4.0, 2.5, 0.7903886056844504524},
        {1000000000, 1.0, 0.75, 0.4302171750387155747}};
    check_ask(
        "The law of Maxwell and Boltzmann is near, and still not the same. "
        "What does a high power do with the rounding of 1 minus a share?");
    check_table(table, sizeof table / sizeof table[0]);
}

/* The integral over s = v^2, from 0 to the largest, of the probability of a
   speed above v is the mean of v^2. For three and four disks it is that of
   a polynomial of second and third degree, which Simpson's rule gives
   exactly. The roundings are those of three probabilities. */
static void check_mean(int n, double mean)
{
    const double all = n * mean;
    const double above[3] = {1.0 - below(n, mean, 0.0),
                             1.0 - below(n, mean, sqrt(0.5 * all)),
                             1.0 - below(n, mean, sqrt(all))};
    const struct known k = {n, mean, sqrt(0.5 * all), 0.0};
    CHECK_NEAR(all / 6.0 * (above[0] + 4.0 * above[1] + above[2]),
               .quantity = "mean of v^2, from your probabilities for 0, "
                           "this v, and the largest v",
               .unit = "m^2/s^2", .input = input(&k), .expected = mean,
               .tolerance = all * tolerance,
               .because = "that of the probabilities, summed up",
               .question = "The mean of the squares was given. Which "
                           "squares are too frequent in your law?");
}

static void test_mean(void)
{
    check_mean(3, 1.0);
    check_mean(4, 1.0);
    check_mean(3, 2.5);
    check_mean(4, 0.3);
}

static void check_fourth(int n, double mean, double v)
{
    const struct known k = {n, mean, v, 0.0};
    const double count = n, square = mean * mean;
    double got = CHECK_EMPTY;
    (void)speed_below(n, mean, v, &got);
    CHECK_NEAR(
        got, .quantity = "*fourth, the mean of v^4", .unit = "m^4/s^4",
        .input = input(&k),
        .expected = square * (count / (count + 1.0) * 2.0),
        .tolerance = tolerance * square * (count / (count + 1.0) * 2.0),
        .because = because,
        .question = "Integrate v^4 times the density, or 4 v^3 times the "
                    "probability of a speed above v. What comes out for "
                    "two disks, on paper?",
        .mistakes = {
            {"fourth-of-maxwell", 2.0 * square,
             "This is the mean for the law of Maxwell and Boltzmann. Can "
             "few disks have speeds as large as that law allows?"},
            {"fourth-of-equal-speeds", square,
             "This is the square of the mean of v^2, as if all speeds were "
             "equal. Are they, after some collisions? Or have you written "
             "2 * n / (n + 1), and what is that for whole numbers?"},
            {"fourth-on-a-line", 3.0 * count / (count + 2.0) * square,
             "This is the mean for velocities on a line. How many "
             "directions share the energy of a disk?"},
            {"mean-not-squared", 2.0 * count / (count + 1.0) * mean,
             "The number of disks is right. Which unit has v^4, and which "
             "has your answer?"},
            {"left-empty", CHECK_EMPTY,
             "Not a number: is *fourth filled in whatever v is, before any "
             "return?"}});
}

static void test_fourth(void)
{
    check_fourth(3, 1.25, 1.0);
    check_fourth(2, 1.5, 1.0);
    check_fourth(2, 0.7, 9.0);
    check_fourth(5, 1.5, -1.0);
    check_fourth(250, 1.0, 0.5);
    check_fourth(1, 1.5, 1.0);
    check_fourth(1, 3.0, 2.0);
    check_fourth(1000000, 2.0, 1.0);
    check_fourth(1000000000, 2.0, 1.0);
}

/* The integral over s = v^2 of 2 s times the probability of a speed above v
   is the mean of v^4; for three disks, a polynomial of third degree. Its
   two ends are zero, for s and for the probability. */
static void test_agree(void)
{
    const struct known k = {3, 2.5, sqrt(3.75), 0.0};
    double fourth = CHECK_EMPTY;
    const double above = 1.0 - speed_below(k.n, k.mean, k.v, &fourth);
    const double all = 7.5;
    CHECK_NEAR(
        fourth, .quantity = "*fourth", .unit = "m^4/s^4",
        .input = input(&k),
        .expected = all / 6.0 * 4.0 * (2.0 * 0.5 * all * above),
        .tolerance = 8.0 * all * all * tolerance,
        .because =
            "that of a probability, times 4 (7.5 m^2/s^2)^2/6, and its own",
        .question =
            "Your probability below this v gives the expected number, and "
            "*fourth is another one. Do both come from one law?");
}

/* A speed that is made for its probability: as small as one likes, and
   nearly 1. When the n - 1 others each leave e^-x/(n-1) of the probability
   of a speed above v, all of them leave e^-x; the first of these numbers
   says which share of the energy v is. */
static struct known draw_known(void)
{
    const int n = 2 + (int)pow(10.0, check_draw(0.0, 8.9));
    const double x = pow(10.0, check_draw(-25.0, 1.4));
    const double mean = check_draw(0.1, 9.0);
    const double share = -expm1(-x / (n - 1.0));
    return (struct known){n, mean, sqrt(share * n * mean), -expm1(-x)};
}

CHECK_TIMES(50, test_drawn, i)
{
    check_ask("Many disks or few, fast or slow: where in your formula do "
              "digits get lost?");
    const struct known k = draw_known();
    check_below(&k);
    check_fourth(k.n, k.mean, k.v);
}

const struct check_suite check_suite = {
    .file = "07a-speeds.c",
    .title = "How fast is a disk?",
    .minutes = 25,
    .equation = "eq:speed-law",
    .tests = {{"two disks: every share is equally likely", test_two, 1, 0},
              {"three to 250 disks agree with a table", test_some, 2, 0},
              {"no disk has more than all the energy", test_outside, 1, 0},
              {"one disk alone has one speed", test_one, 1, 0},
              {"slow disks keep all digits", test_slow, 1, 0},
              {"many disks keep all digits", test_many, 2, 0},
              {"the mean square is the one that was given", test_mean, 1,
               0},
              {"the fourth power has its mean, few disks or many",
               test_fourth, 1, 0},
              {"the fourth power and the probabilities agree", test_agree,
               1, 0},
              {"a speed made for its probability has it", test_drawn, 2, 3},
              {0}},
};
