/* The suite of exercise 12b, "Other units". */

#include "examiner/check.h"

struct world {
    double g, k, q;
};

typedef void stepper(struct world w, double h, double *x, double *v);

double apart(stepper *step, struct world w, double h, int n, double x,
             double v, double *end);

struct job {
    struct world w;
    double h;
    int n;
    double x, v;
};

/* A run that the student's function has made: what its first step was
   given, where the last one ended, and how many there were. */
struct seen {
    struct world w;
    double h, x, v, at, with;
    int steps;
};

enum { MOST = 8 };

static struct seen seen[MOST];
static int runs;
static bool looking; /* ahead: nobody has asked for this step yet */

static void note(struct world w, double h, double x, double v, double at,
                 double with)
{
    if (looking)
        return;
    for (int i = 0; i < runs; ++i) {
        struct seen *s = &seen[i];
        if (s->at == x && s->with == v && s->h == h && s->w.g == w.g) {
            s->at = at;
            s->with = with;
            ++s->steps;
            return;
        }
    }
    if (runs < MOST)
        seen[runs++] = (struct seen){w, h, x, v, at, with, 1};
}

/* Velocity first, then the place with the new velocity. Nothing is computed
   in advance from the constants, so that every unit has its own roundings.
 */
static void step(struct world w, double h, double *x, double *v)
{
    const double from = *x, with = *v;
    *v += h * (w.g - *x * (w.k + w.q * *x * *x));
    *x += h * *v;
    note(w, h, from, with, *x, *v);
}

/* A step that is not counted as made: for a grader, which hands out many
   at once. */
void step_ahead(stepper *step, struct world w, double h, double *x,
                double *v);

void step_ahead(stepper *step, struct world w, double h, double *x,
                double *v)
{
    looking = true;
    step(w, h, x, v);
    looking = false;
}

static double plain(const struct job *j, int n)
{
    double x = j->x, v = j->v;
    for (int i = 0; i < n; ++i) {
        v += j->h * (j->w.g - x * (j->w.k + j->w.q * x * x));
        x += j->h * v;
    }
    return x;
}

/* The same without roundings, or with 2000 times smaller ones. */
static long double finely(const struct job *j)
{
    long double x = j->x, v = j->v;
    for (int i = 0; i < j->n; ++i) {
        v += j->h * (j->w.g - x * (j->w.k + j->w.q * x * x));
        x += j->h * v;
    }
    return x;
}

static double answer(const struct job *j, double *end)
{
    check_about(check_text("g = %g m/s^2, k = %g /s^2, q = %g /(m^2 s^2), "
                           "%d steps of %g s from x = %g m, v = %g m/s",
                           j->w.g, j->w.k, j->w.q, j->n, j->h, j->x, j->v));
    *end = CHECK_EMPTY;
    runs = 0;
    return apart(step, j->w, j->h, j->n, j->x, j->v, end);
}

static bool close(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fmax(fabs(a), fabs(b));
}

static bool power_of_two(double a)
{
    int exponent;
    return fabs(frexp(a, &exponent)) == 0.5;
}

/* The run in other units, and these: x was divided by `length`, h by
   `time`. NULL when there is none. */
static const struct seen *other(const struct job *j, double *length,
                                double *time)
{
    for (int i = 0; i < runs; ++i) {
        const struct seen *s = &seen[i];
        *length = j->x / s->x;
        *time = j->h / s->h;
        if (!close(*length, 1.0) || !close(*time, 1.0))
            return s;
    }
    return NULL;
}

enum fault { NONE, SAME, TWO, SHORTER, VELOCITY, G, K, Q };

static enum fault fault(const struct job *j)
{
    double a, b;
    const struct seen *s = other(j, &a, &b);
    if (!s)
        return SAME;
    if (s->steps > j->n && close(a, 1.0))
        return SHORTER;
    if (!close(s->v * a / b, j->v))
        return VELOCITY;
    if (!close(s->w.g * a / (b * b), j->w.g))
        return G;
    if (!close(s->w.k / (b * b), j->w.k))
        return K;
    if (!close(s->w.q / (a * a * b * b), j->w.q))
        return Q;
    return power_of_two(a) && power_of_two(b) ? TWO : NONE;
}

/* Of 200 steps none can make more than a few epsilons of the largest number
   in it, and an oscillator does not let them grow faster than the number of
   steps: 1e-10 of the whole is far more than rounding. */
static void check_same(const struct job *j)
{
    double end;
    const double got = answer(j, &end);
    const enum fault f = fault(j);
    const double size = fabs(j->x) + fabs(j->v) + fabs(j->w.g);
    const bool all = isfinite(got) && (f == NONE || f == TWO || f == SAME);
    CHECK_NEAR(
        got, .quantity = "how far the two runs are apart", .unit = "m",
        .tolerance = 1e-10 * size,
        .because = "much more than rounding can do",
        .mistakes = {
            {"velocity-in-old-units", f == VELOCITY ? got : 0.0,
             "Your second run does not begin with the same velocity. What "
             "is 1 m/s in your units?"},
            {"g-in-old-units", f == G ? got : 0.0,
             "The constant g has a length in its unit. What is it in "
             "yours?"},
            {"k-in-new-units", f == K ? got : 0.0,
             "k is in 1/s^2. Which of your units does it know?"},
            {"q-in-old-units", f == Q ? got : 0.0,
             "q is in 1/(m^2 s^2). If your unit of length is shorter than "
             "a metre, is its number larger or smaller, and by which "
             "power?"},
            {"not-converted-back", all ? got : 0.0,
             "The second run was right, and its end is in your units. "
             "Where is that in metres?"},
            {"shorter-steps", f == SHORTER ? got : 0.0,
             "With other steps it is another run: what you see is the "
             "error of the method. How does one see rounding alone?"}});
}

CHECK_TIMES(3, test_run, i)
{
    const struct job j = {{0.5, 4.0, 0.25}, 0.0625, 10 << i, 1.5, -0.5};
    double end;
    answer(&j, &end);
    CHECK_NEAR(
        end, .quantity = "*end", .unit = "m", .expected = plain(&j, j.n),
        .because = "the same steps have the same roundings",
        .question = "This is the run in m and s. How many steps has it?",
        .mistakes = {{"one-step-fewer", plain(&j, j.n - 1),
                      "One step is missing. With n steps, how often is the "
                      "function called for this run?"},
                     {"one-step-more", plain(&j, j.n + 1),
                      "That is one step too many. How often is the "
                      "function called for this run?"},
                     {"end-not-set", CHECK_EMPTY,
                      "Not a number. Has anything been put into *end?"}});
}

static void test_spring(void)
{
    const struct job j = {{0.0, 4.0, 0.0}, 0.0625, 40, 1.5, -0.5};
    check_ask("A spring, and nothing else. In other units, which of x, v, "
              "k and h have another number?");
    check_same(&j);
}

static void test_constants(void)
{
    const struct job falls = {{-9.5, 0.0, 0.0}, 0.0625, 20, 1.5, 4.5},
                     hard = {{0.0, 0.0, 0.75}, 0.0625, 40, 1.5, -0.5};
    check_ask("A body falls. In which unit is g?");
    check_same(&falls);
    check_ask("A spring that grows hard. In which unit is q?");
    check_same(&hard);
}

static void draw_job(struct job *j)
{
    *j = (struct job){
        {check_draw(-2.0, 2.0), check_draw(1.0, 9.0), check_draw(0.1, 3.0)},
        check_draw(0.01, 0.1),
        100,
        check_draw(0.5, 2.0),
        check_draw(-2.0, 2.0)};
}

/* How far the student's second run, and the first, ended from the truth.
   The constants of the second were rounded when they were converted: it has
   the error of another world as well, which a yard and a minute make larger
   than that of the steps. It is known, since the end of the run was seen.
   What is not known is how the student converted: x there and the end back,
   each rounded once or twice. */
static double squares(const struct job *j, double end)
{
    double length, time;
    const struct seen *s = other(j, &length, &time);
    const long double truth = finely(j);
    const double first = (double)(end - truth);
    const double second =
        s ? (double)(s->at * ((long double)j->x / s->x) - truth) : first;
    const double converted = DBL_EPSILON * end;
    return first * first + second * second + converted * converted;
}

/* Where the errors of the two runs are e and e', the distance is |e - e'|,
   and (e - e')^2 / (e^2 + e'^2) = 1 - 2 e e' / (e^2 + e'^2): between 0 and
   2 whatever the units are, and 1 on average where either error has its
   sign by chance. The mean of 60 such numbers has a standard deviation of
   at most 1/sqrt(60) = .13. What conversion adds to the divisor takes away
   .2 at most. (Of 22 pairs of units and 60 seeds each: .57 to 1.15,
   standard deviation .08; with the same digits in both runs it is 0.) */
static void test_size(void)
{
    enum { RUNS = 60 };
    double got = 0.0;
    enum fault f = NONE;
    for (int i = 0; i < RUNS; ++i) {
        struct job j;
        double end;
        draw_job(&j);
        const double d = answer(&j, &end);
        got += d * d / squares(&j, plain(&j, j.n)) / RUNS;
        f = fault(&j);
        CHECK_NEAR(d < 0.0 ? d : 0.0,
                   .quantity = "how far apart, if that is negative",
                   .unit = "m", .because = "no distance is negative",
                   .question = "What is a distance without its sign?",
                   .mistakes = {{"signed", d,
                                 "A distance has no sign. On which side is "
                                 "your second run?"}});
    }
    CHECK_NEAR(
        got,
        .quantity = "square of your distance, by the sum of the squares of "
                    "the true errors of both runs (mean)",
        .input = "60 runs of 100 steps, drawn", .expected = 1.0,
        .tolerance = 0.7,
        .because = "the squares of two independent errors add; five "
                   "standard deviations of 60 such runs",
        .question =
            "What you find is not what rounding does. Is everything in one "
            "system of units, in each of the runs?",
        .mistakes = {{"powers-of-two", f == TWO ? got : 1.0,
                      "All digits are the same. What does a factor of 2, "
                      "or of a quarter, do to a binary number?"},
                     {"same-run-twice", f == SAME ? got : 1.0,
                      "Both runs got the same numbers. What should have "
                      "been different, if not the physics?"}});
}

CHECK_TIMES(30, test_drawn, i)
{
    check_ask(
        "All constants at once. Which one of them is in the old units?");
    struct job j;
    draw_job(&j);
    check_same(&j);
}

const struct check_suite check_suite = {
    .file = "12b-units.c",
    .title = "Other units",
    .minutes = 25,
    .equation = "eq:choose-slip",
    .tests =
        {{"the run in metres ends where its steps lead", test_run, 1, 0},
         {"a spring in other units is the same spring", test_spring, 1, 0},
         {"so is a fall, and a spring that grows hard", test_constants, 2,
          0},
         {"the distance is as large as rounding is", test_size, 3, 2},
         {"thirty runs come out the same in other units", test_drawn, 1, 1},
         {0}},
    .idle = {test_spring, test_constants, test_drawn},
};
