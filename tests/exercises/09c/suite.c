/* The suite of exercise 09c, "Kepler's equation". */

#include "examiner/check.h"
#include "call.h"

static const double pi = 3.141592653589793;

/* limit: 8 epsilons */
/* How far a few epsilons in the equation move its solution. */
static double tolerance(double e, double mean, double solution)
{
    return 8.0 * DBL_EPSILON * (1.0 + fabs(mean)) /
           (1.0 - e * cos(solution));
}

/* The mean anomaly of a solution, rounded; and the solution that belongs to
   the rounded one: one tangent further, in long double. */
double mean_of(double e, double solution, double *exact)
{
    const long double E = solution;
    const long double mean = E - e * sinl(E);
    const long double slope = 1.0L - e * cosl(E);
    *exact = (double)(E + ((double)mean - mean) / slope);
    return (double)mean;
}

static const char *input(double e, double mean)
{
    return check_text("e = %.10g, M = %.10g", e, mean);
}

/* A result that is near: how far off it is, over what is allowed. */
static void check_digits(double e, double mean, double solution, double got)
{
    const double off = (got - solution) / tolerance(e, mean, solution);
    CHECK_NEAR(
        off, .quantity = "error of E, over the largest that passes",
        .input = input(e, mean), .tolerance = 1.0,
        .because = check_text("8 epsilons of 1 + |M|, over 1 - e cos(E); E "
                              "= %.17g, found %.17g",
                              solution, got),
        .mistakes = {
            {"stopped-too-soon", off,
             "The first digits are right, and the last ones are not. Does "
             "your loop go on until nothing changes any more, whatever e "
             "and M are, and has each number in it all its digits?"}});
}

static double when(bool condition, double got)
{
    return condition ? got : NAN;
}

static bool solves(double left, double mean)
{
    return fabs(left - mean) <= 1e-8 * (1.0 + fabs(mean));
}

/* From E to the angle that is seen from the sun. */
static double seen(double e, double solution)
{
    const double b = e / (1.0 + sqrt(1.0 - e * e));
    return solution +
           2.0 * atan2(b * sin(solution), 1.0 - b * cos(solution));
}

void check_anomaly(double e, double mean, double solution)
{
    const double got = eccentric_anomaly(e, mean);
    const double turns = (got - solution) / (2.0 * pi);
    const bool lost = fabs(turns) > 0.5 && fabs(got) <= fabs(mean) + 4.0 &&
                      fabs(turns - round(turns)) <= 1e-8;
    const double first = mean + e * sin(mean);
    const double tangent = mean + e * sin(mean) / (1.0 - e * cos(mean));
    struct check c = {.quantity = "E",
                      .input = input(e, mean),
                      .expected = solution,
                      .tolerance = tolerance(e, mean, solution),
                      .because =
                          "8 epsilons of 1 + |M|, over 1 - e cos(E)"};
    const struct check_mistake known[] = {
        {"mean-for-eccentric", mean,
         "This is M itself. What is the difference of E and M?"},
        {"fixed-point-once", first,
         "This is M + e sin(M). Is it a solution? Put it in."},
        {"newton-once", tangent,
         "This is one step of Newton's rule. Is it a solution? Put it in."},
        {"revolutions-lost", when(lost, got),
         "This is right but for whole revolutions. In which one is M?"},
        {"negative-lost", mean < 0.0 ? -solution : NAN,
         "The sign is lost. What happens to E when M changes its sign?"},
        {"sign-in-the-equation",
         when(solves(got + e * sin(got), mean), got),
         "This solves E + e sin(E) = M. What is the sign in the equation?"},
        {"cosine-for-sine", when(solves(got - e * cos(got), mean), got),
         "This solves an equation with a cosine. Which E belongs to M = 0 "
         "on any ellipse?"},
        {"e-beside-the-sine", when(solves(got - sin(e * got), mean), got),
         "This solves E - sin(e E) = M. Where does e stand in the "
         "equation?"},
        {"true-anomaly", seen(e, solution),
         "This is the angle that is seen from the sun, the true anomaly. "
         "Which one was asked for?"},
        {"degrees", solution * 180.0 / pi,
         "This is in degrees. In which unit was M?"}};
    /* Told only where nothing else explains it, and on no circle, where the
       curve is as steep everywhere. */
    const struct check_mistake ran_away = {
        "ran-away", when(e > 0.0 && fabs(got - mean) > 1.01 * e, got),
        "This is further from M than e, which no solution is. Where did "
        "your search begin, where does the tangent lead from there, and "
        "had it arrived when it ended?"};
    size_t used = 0;
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i)
        if (used < 8 && solves(got, known[i].value))
            c.mistakes[used++] = known[i];
    if (used == 0)
        c.mistakes[0] = ran_away;
    if (used == 0 && fabs(got - solution) < 0.05) {
        check_digits(e, mean, solution, got);
        return;
    }
    check_near(got, c);
}

/* ---- the tests ---- */

static void test_circle(void)
{
    static const double mean[] = {0.0, 1.0, 3.0, -2.0, 6.0, 100.0};
    check_ask("On a circle the planet goes evenly. What is E then?");
    for (size_t i = 0; i < sizeof mean / sizeof *mean; ++i)
        check_anomaly(0.0, mean[i], mean[i]);
}

/* The sine of pi/6 is 1/2, that of pi/2 is 1. */
static void test_some(void)
{
    check_ask("Put your E into the equation. What is E - e sin(E)?");
    check_anomaly(0.5, pi / 2.0 - 0.5, pi / 2.0);
    check_anomaly(0.25, pi / 6.0 - 0.125, pi / 6.0);
    check_anomaly(0.5, 5.0 * pi / 6.0 - 0.25, 5.0 * pi / 6.0);
    check_anomaly(0.75, 3.0 * pi / 2.0 + 0.75, 3.0 * pi / 2.0);
}

static void test_ends(void)
{
    static const double e[] = {0.1, 0.5, 0.9, 0.99, 0.9999};
    for (size_t i = 0; i < sizeof e / sizeof *e; ++i) {
        check_ask("Nearest to the sun: E and M are both 0.");
        check_anomaly(e[i], 0.0, 0.0);
        check_ask("Farthest from the sun: E and M are both pi. Is that so "
                  "in your program?");
        check_anomaly(e[i], pi, pi);
    }
}

static void check_solution(double e, double solution)
{
    double exact;
    const double mean = mean_of(e, solution, &exact);
    check_anomaly(e, mean, exact);
}

static void test_signs(void)
{
    check_ask("What happens to E when M changes its sign?");
    for (int i = 1; i <= 6; ++i)
        check_solution(0.6, -0.5 * i);
}

static void test_revolutions(void)
{
    static const double solution[] = {5.0, 7.0, -9.0, 40.0, -1000.0, 1e5};
    check_ask("The planet has been round some times. By how much does E "
              "grow in each revolution?");
    for (size_t i = 0; i < sizeof solution / sizeof *solution; ++i)
        check_solution(0.3, solution[i]);
}

/* Round the ellipse in small parts of it. */
static void test_ellipses(void)
{
    static const double e[] = {0.05, 0.2, 0.5, 0.7, 0.9};
    check_ask("Put your E into the equation. What is E - e sin(E)?");
    for (size_t i = 0; i < sizeof e / sizeof *e; ++i)
        for (int k = 1; k <= 60; ++k)
            check_solution(e[i], 0.1 * k + 0.05);
}

/* Comets, mostly near the sun. */
/* limit: 1 (what e is below: 1 - 1e-8) */
static void test_comets(void)
{
    static const double e[] = {0.99, 0.967, 0.999, 0.9999, 0.999999};
    for (size_t i = 0; i < sizeof e / sizeof *e; ++i) {
        for (int k = 0; k < 60; ++k) {
            check_ask("A comet near the sun: the curve is flat there. From "
                      "where does your search begin, and can it run away?");
            check_solution(e[i], pi * pow(0.8, k));
            check_ask("A comet before it comes near the sun: from where "
                      "does your search begin?");
            check_solution(e[i], -3.0 * pow(0.9, k));
        }
    }
}

/* Nearer and nearer to the perihelion. */
static void test_small(void)
{
    static const double e[] = {0.1, 0.5, 0.9, 0.99, 0.9999};
    check_ask("M is small. When is your loop done, and are the digits of a "
              "small E right then?");
    for (size_t i = 0; i < sizeof e / sizeof *e; ++i)
        for (int k = 1; k <= 40; ++k)
            check_solution(e[i], pow(0.5, k));
}

/* E and e first. */
CHECK_TIMES(100, test_drawn, i)
{
    const double e = i % 2 ? check_draw(0.0, 0.95)
                           : 1.0 - pow(10.0, check_draw(-8.0, -1.0));
    const double solution =
        i % 4 < 2 ? check_draw(-3.1, 3.1) : check_draw(-300.0, 300.0);
    check_ask("Any ellipse, any time: can your search fail, and does it go "
              "on to the last digits?");
    check_solution(e, solution);
}

const struct check_suite check_suite = {
    .file = "09c-kepler.c",
    .title = "Kepler's equation",
    .minutes = 30,
    .equation = "eq:kepler",
    .tests = {{"a circle", test_circle, 1, 0},
              {"ellipses with a known solution", test_some, 2, 0},
              {"the two ends of the ellipse", test_ends, 1, 0},
              {"before the sun and after", test_signs, 1, 0},
              {"many revolutions", test_revolutions, 1, 0},
              {"round five ellipses", test_ellipses, 2, 0},
              {"comets near the sun", test_comets, 3, 0},
              {"small mean anomalies", test_small, 1, 0},
              {"drawn planets and comets", test_drawn, 2, 3},
              {0}},
    .idle = {test_circle, test_ends},
};
