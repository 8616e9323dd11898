/* The suite of exercise 08b, "One more row in the tableau". */

#include "examiner/check.h"
#include <complex.h>
#include <string.h>
#include "call.h"

/* limit: 1 (stage, and one number) */
/* limit: 8 stages */
/* limit: 12 numbers */
enum { MOST_STAGES = 8, MOST = 12, ENTRIES = 16, WEIGHTS = 4 };

/* ---- the slopes ---- */

static struct {
    void (*law)(size_t n, double t, const double y[], double dy[]);
    size_t n, asked;
} slopes;

void slope(double t, const double y[], double dy[])
{
    double copy[MOST];
    memcpy(copy, y, slopes.n * sizeof *copy);
    slopes.law(slopes.n, t, copy, dy);
    ++slopes.asked;
}

struct table {
    size_t stages;
    double a[MOST_STAGES * MOST_STAGES], b[MOST_STAGES];
};

/* The student's step under this law; y has a place behind it. Returns how
   often the slopes were asked for. */
size_t step_under(void (*law)(size_t n, double t, const double y[],
                              double dy[]),
                  const struct table *table, size_t n, double t, double h,
                  double y[])
{
    slopes.law = law;
    slopes.n = n;
    slopes.asked = 0;
    y[n] = 4096.0;
    tableau_step(table->stages, table->a, table->b, n, t, h, y);
    return slopes.asked;
}

/* The student's own table, in four rows of four. */
struct table new_method(void)
{
    struct table table = {.stages = 4};
    double a[ENTRIES + 1], b[WEIGHTS + 1];
    for (int i = 0; i <= ENTRIES; ++i)
        a[i] = CHECK_EMPTY;
    for (int i = 0; i <= WEIGHTS; ++i)
        b[i] = CHECK_EMPTY;
    three_eighths(a, b);
    memcpy(table.a, a, sizeof a - sizeof *a);
    memcpy(table.b, b, sizeof b - sizeof *b);
    return table;
}

/* ---- the table ---- */

/* In thirds, as the sentences have it. */
static const int thirds[4][4] = {
    {0, 0, 0, 0}, {1, 0, 0, 0}, {-1, 3, 0, 0}, {3, -3, 3, 0}};

static const char *const sentence[] = {
    "the first stage stands at y", "the second at y + h k_1/3",
    "the third at y + h (k_2 - k_1/3)",
    "the fourth at y + h (k_1 - k_2 + k_3)"};

/* Tables that one may take for it. */
enum kind { INTEGERS, COLUMNS, CLASSICAL, FROM_START, KINDS };

static double entry(enum kind kind, int i, int j)
{
    switch (kind) {
    case INTEGERS: return thirds[i][j] / 3;
    case COLUMNS: return thirds[j][i] / 3.0;
    case CLASSICAL: return i != j + 1 ? 0.0 : i < 3 ? 0.5 : 1.0;
    default: return i == j + 1 ? i / 3.0 : 0.0;
    }
}

static bool is(const struct table *table, enum kind kind)
{
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!(fabs(table->a[4 * i + j] - entry(kind, i, j)) < 1e-9))
                return false;
    return true;
}

static void check_entry(const struct table *table, int i, int j)
{
    static const struct check_mistake known[KINDS] = {
        [INTEGERS] = {"integer-division", 0.0,
                      "The thirds of the table are 0. What is 1 / 3 in C?"},
        [COLUMNS] =
            {"columns-for-rows", 0.0,
             "In the whole table i and j are exchanged. Which of the two "
             "is the number of the stage, and which that of the slope?"},
        [CLASSICAL] = {"classical-table", 0.0,
                       "This is the table of the classical method. Which "
                       "sentences tell about the 3/8 rule?"},
        [FROM_START] = {"stages-from-the-start", 0.0,
                        "Each stage is reached with the slope before it "
                        "alone. Which other slopes are in the sentences?"}};
    const double got = table->a[4 * i + j], expected = thirds[i][j] / 3.0;
    struct check c = {
        .quantity = check_text("a_%d%d, which is a[%d]", i, j, 4 * i + j),
        .input = sentence[i],
        .expected = expected,
        .tolerance = DBL_EPSILON,
        .because = "a third is rounded once",
        .question = "Row i says how much of each slope leads to stage i. "
                    "Which place has this number in the sentence?",
        .mistakes = {
            {"sign-of-an-entry", -expected,
             "The sign is another one. What does the sentence say?"}}};
    for (int kind = 0, used = 1; kind < KINDS; ++kind)
        if (is(table, (enum kind)kind)) {
            c.mistakes[used] = known[kind];
            c.mistakes[used++].value = got;
        }
    check_near(got, c);
}

static void test_rows(void)
{
    static const int order[] = {1, 2, 3, 0};
    const struct table table = new_method();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            check_entry(&table, order[i], j);
}

CHECK_TIMES(4, test_weights, i)
{
    static const double eighths[] = {1.0, 3.0, 3.0, 1.0};
    const struct table table = new_method();
    const bool classical = fabs(table.b[0] - 1.0 / 6.0) < 1e-9 &&
                           fabs(table.b[1] - 1.0 / 3.0) < 1e-9;
    CHECK_NEAR(
        table.b[i], .quantity = check_text("b[%d]", i),
        .input = "the weights are 1/8, 3/8, 3/8 and 1/8",
        .expected = eighths[i] / 8.0, .tolerance = DBL_EPSILON,
        .because = "eighths are exact in binary",
        .question =
            "What is the mean of four slopes that are all the same?",
        .mistakes = {{"integer-division", 0.0,
                      "Dividing whole numbers gives this. What is 3 / "
                      "8 in C?"},
                     {"weights-of-the-classical-table",
                      !classical         ? NAN
                      : eighths[i] < 2.0 ? 1.0 / 6.0
                                         : 1.0 / 3.0,
                      "This is a weight of the classical method. "
                      "What is the 3/8 rule called after?"}});
}

/* ---- steps of one number ---- */

/* y' = rate y + push t. */
static struct {
    double rate, push;
} line;

static double on_line(double t, double y)
{
    return line.rate * y + line.push * t;
}

static void straight(size_t n, double t, const double y[], double dy[])
{
    for (size_t i = 0; i < n; ++i)
        dy[i] = on_line(t, y[i]);
}

static const char *line_text(const struct table *table, double t, double h,
                             double y)
{
    char rows[200] = "";
    size_t used = 0;
    for (size_t i = 1; i < table->stages; ++i)
        for (size_t j = 0; j < i; ++j) {
            const char *entry = check_text(", a_%zu%zu = %g", i, j,
                                           table->a[i * table->stages + j]);
            if (used + strlen(entry) < sizeof rows) {
                strcpy(rows + used, entry);
                used += strlen(entry);
            }
        }
    for (size_t i = 0; i < table->stages; ++i) {
        const char *weight = check_text(", b_%zu = %g", i, table->b[i]);
        if (used + strlen(weight) < sizeof rows) {
            strcpy(rows + used, weight);
            used += strlen(weight);
        }
    }
    return check_text(
        "y' = %g y + %g t, y = %g at t = %g, h = %g; %zu stage%s%s",
        line.rate, line.push, y, t, h, table->stages,
        table->stages == 1 ? "" : "s", rows);
}

static void test_one(void)
{
    static const double t[] = {0.0, 2.0, -1.0}, h[] = {0.5, 0.25, -0.5};
    static const double expected[] = {3.0, 4.5, 2.5};
    struct table euler = {1, {0.0}, {1.0}};
    line.rate = 1.0;
    line.push = 2.0;
    for (int i = 0; i < 3; ++i) {
        double y[2] = {i == 0 ? 2.0 : i == 1 ? 2.8 : 1.0, 0.0};
        const double begin = y[0];
        (void)step_under(straight, &euler, 1, t[i], h[i], y);
        const double far = begin + on_line(t[i], begin);
        CHECK_NEAR(y[0], .quantity = "y after one step of the Euler method",
                   .input = line_text(&euler, t[i], h[i], begin),
                   .expected = i == 2 ? 1.5 : expected[i],
                   .tolerance = 1e-14, .because = "some epsilons",
                   .question = "One stage, of weight 1: this is the Euler "
                               "method. Where does its straight line lead?",
                   .mistakes = {{"weights-without-the-step", far,
                                 "This goes along the slope for a whole "
                                 "second. How long is the step?"}});
    }
}

enum { SLIPS = 7 };

/* Two stages: what the slips make of them. */
static void slips_of(const struct table *w, double t, double h, double y,
                     struct check_mistake slip[SLIPS])
{
    const double a = w->a[2], first = w->b[0], last = w->b[1];
    const double k = on_line(t, y), moved = y + h * first * k;
    const double end = h * last;
    const struct check_mistake all[SLIPS] = {
        {"y-moves-too-soon",
         moved + end * on_line(t + a * h, moved + h * a * k),
         "The second stage starts from a y that has moved already. From "
         "which y do all stages start?"},
        {"time-stands-still", moved + end * on_line(t, y + h * a * k),
         "The second slope is taken at the time of the first. At which "
         "time does its stage stand?"},
        {"time-without-the-step",
         moved + end * on_line(t + a, y + h * a * k),
         "The time of the stage moves by the sum of its row. In which unit "
         "is that: seconds, or steps?"},
        {"time-of-the-end", moved + end * on_line(t + h, y + h * a * k),
         "The second slope is taken at the end of the step. Which sum of "
         "its row says where it stands?"},
        {"table-read-by-columns",
         y + h * (first * on_line(t, y) + last * on_line(t, y)),
         "The second stage stands where the first one does. Which number "
         "of the table leads to it: that in row 1, column 0, or that in "
         "row 0, column 1?"},
        {"stages-without-the-step",
         moved + end * on_line(t + a * h, y + a * k),
         "The second stage goes along the first slope as if the step were "
         "1 s long. How long is it?"},
        {"weights-without-the-step",
         y + first * k + last * on_line(t + a * h, y + h * a * k),
         "The mean of the slopes is right. For how long does y follow "
         "it?"}};
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = all[i];
}

static void check_two(const struct table *w, double t, double h, double y,
                      double expected)
{
    double got[2] = {y, 0.0};
    (void)step_under(straight, w, 1, t, h, got);
    struct check c = {.quantity = "y after one step",
                      .input = line_text(w, t, h, y),
                      .expected = expected,
                      .tolerance =
                          1e-14 * (fabs(y) + fabs(expected) + 20.0),
                      .because = "some epsilons of all that is added up"};
    slips_of(w, t, h, y, c.mistakes);
    check_near(got[0], c);
}

/* By hand. The midpoint: k_1 = 5, the middle is 1 + 0.25 * 5 at t = 1.25,
   k_2 = 2 * 2.25 + 3 * 1.25 = 8.25. Heun's: k_1 = 5, y + h k_1 = 3.5 at
   1.5, k_2 = 11.5, the mean 8.25. Weights 3/4 and 1/2: k_1 = 5, the stage
   at 1 + 0.125 * 5 and t = 1.125, k_2 = 6.625. */
static void test_two(void)
{
    check_ask("Do the two stages by hand: where does the second one stand, "
              "and when? Which slope is there, and what is the mean?");
    const struct table middle = {2, {0.0, 0.0, 0.5, 0.0}, {0.0, 1.0}};
    const struct table heun = {2, {0.0, 0.0, 1.0, 0.0}, {0.5, 0.5}};
    const struct table other = {2, {0.0, 0.0, 0.25, 0.0}, {0.75, 0.5}};
    line.rate = 2.0;
    line.push = 3.0;
    check_two(&other, 1.0, 0.5, 1.0, 4.53125);
    check_two(&middle, 1.0, 0.5, 1.0, 5.125);
    check_two(&heun, 1.0, 0.5, 1.0, 5.125);
    check_two(&middle, 0.0, -0.25, 3.0, 1.96875);
}

/* Three stages, where the third uses the first slope too. With z = h rate
   the step is a polynomial in z whose terms one can see in the table: the
   weights; weights times entries; and the one chain of all three. */
static void test_three(void)
{
    static const double a10 = 0.5, a20 = -1.0, a21 = 2.0;
    const struct table kutta = {
        3, {0.0, 0.0, 0.0, a10, 0.0, 0.0, a20, a21, 0.0}, {0.25, 0.5, 0.5}};
    const double *b = kutta.b;
    line.rate = -2.0;
    line.push = 0.0;
    for (int i = 0; i < 4; ++i) {
        const double h = 0.25 * (i < 2 ? i + 1 : 1 - i), z = h * line.rate;
        double y[2] = {1.5, 0.0};
        (void)step_under(straight, &kutta, 1, 0.0, h, y);
        const double one = b[0] + b[1] + b[2];
        const double two = b[1] * a10 + b[2] * (a20 + a21);
        const double cube = z * z * z * b[2] * a21 * a10;
        CHECK_NEAR(
            y[0], .quantity = "y after one step",
            .input = line_text(&kutta, 0.0, h, 1.5),
            .expected = 1.5 * (1.0 + one * z + two * z * z + cube),
            .tolerance = 1e-14 * 20.0,
            .because = "some epsilons of all that is added up",
            .question = "The third stage uses two slopes. Are both kept "
                        "until then?",
            .mistakes = {{"previous-slope-only",
                          1.5 * (1.0 + one * z +
                                 (b[1] * a10 + b[2] * a21) * z * z + cube),
                          "The third stage uses the second slope alone. "
                          "What else is in its row?"}});
    }
}

/* Numbers that have nothing to do with each other, each at its own rate. */
static void rates(size_t n, double t, const double y[], double dy[])
{
    (void)t;
    for (size_t i = 0; i < n; ++i)
        dy[i] = ((double)i - 2.0) * y[i];
}

static void check_number(size_t n, size_t i, double got)
{
    const double z = 0.5 * ((double)i - 2.0);
    CHECK_NEAR(
        got, .quantity = check_text("y[%zu]", i),
        .input = check_text("%zu numbers, y[i] = i + 1 with y' = (i - 2) "
                            "y[i]; the midpoint method, h = 0.5",
                            n),
        .expected =
            i < n ? ((double)i + 1.0) * (1.0 + z + 0.5 * z * z) : 4096.0,
        .tolerance = 1e-12, .because = "some epsilons of all the terms",
        .question =
            "Each of the numbers goes its own way. How many of them does a "
            "slope have, and what stands behind the last?",
        .mistakes = {
            {"first-number-only", i < n ? (double)i + 1.0 : NAN,
             "This number has not moved. How many numbers has y?"}});
}

static void test_numbers(void)
{
    const struct table middle = {2, {0.0, 0.0, 0.5, 0.0}, {0.0, 1.0}};
    for (size_t n = 2; n <= MOST; n += 5) {
        double y[MOST + 1];
        for (size_t i = 0; i < n; ++i)
            y[i] = (double)i + 1.0;
        const size_t asked = step_under(rates, &middle, n, 0.0, 0.5, y);
        for (size_t i = 0; i <= n; ++i)
            check_number(n, i, y[i]);
        CHECK_NEAR((double)asked,
                   .quantity = "how often the slopes were asked for",
                   .input = check_text("%zu numbers, two stages", n),
                   .expected = 2.0, .because = "a number is exact",
                   .question = "One call gives the slopes of all numbers. "
                               "How many stages are there?");
    }
}

/* ---- drawn tables ---- */

struct table draw_table(size_t stages)
{
    struct table table = {.stages = stages};
    for (size_t i = 0; i < stages; ++i) {
        for (size_t j = 0; j < i; ++j)
            table.a[stages * i + j] = check_draw(-1.0, 1.0);
        table.b[i] = check_draw(-1.0, 1.0);
    }
    return table;
}

/* On y' = rate y the term of z^m is the sum over all chains of m stages, of
   which each uses the next: a product of entries. */
static double chains(const struct table *w, size_t stage, int length)
{
    double sum = 0.0;
    if (length == 1)
        return 1.0;
    for (size_t j = 0; j < stage; ++j)
        sum += w->a[w->stages * stage + j] * chains(w, j, length - 1);
    return sum;
}

static double polynomial(const struct table *w, double z)
{
    double sum = 1.0, power = 1.0;
    for (int m = 1; m <= (int)w->stages; ++m) {
        power *= z;
        for (size_t i = 0; i < w->stages; ++i)
            sum += power * w->b[i] * chains(w, i, m);
    }
    return sum;
}

/* y' = cos(t) does not ask for y, and the slopes stand where the rows' sums
   say. */
static void cosine(size_t n, double t, const double y[], double dy[])
{
    (void)y;
    for (size_t i = 0; i < n; ++i)
        dy[i] = cos(t);
}

static double integral(const struct table *w, double t, double h)
{
    double sum = 0.0;
    for (size_t i = 0; i < w->stages; ++i) {
        double c = 0.0;
        for (size_t j = i; j-- > 0;)
            c += w->a[i * w->stages + j];
        sum += h * w->b[i] * cos(t + h * c);
    }
    return sum;
}

/* Entries, weights and z of at most 1: with s stages there are 2^s chains,
   and s roundings in each. */
CHECK_TIMES(40, test_drawn, i)
{
    const size_t stages = (size_t)check_draw_whole(1, MOST_STAGES);
    const struct table table = draw_table(stages);
    const double h = check_draw(0.1, 1.0), t = check_draw(-2.0, 2.0);
    double y[2] = {check_draw(0.5, 2.0), 0.0}, begin = y[0];
    line.rate = check_draw(-1.0, 1.0);
    line.push = 0.0;
    (void)step_under(straight, &table, 1, t, h, y);
    CHECK_NEAR(y[0], .quantity = "y after one step",
               .input = line_text(&table, t, h, begin),
               .expected = begin * polynomial(&table, line.rate * h),
               .tolerance = 1e-12,
               .because = "an epsilon for each of 256 chains, 16 times",
               .question = "A table of this size: are all slopes kept, and "
                           "all rows read?");
    y[0] = begin;
    (void)step_under(cosine, &table, 1, t, h, y);
    CHECK_NEAR(
        y[0] - begin, .quantity = "y after one step, less y before it",
        .input = check_text(
            "y' = cos(t), t = %g, h = %g, %zu stages of a drawn table", t,
            h, stages),
        .expected = integral(&table, t, h), .tolerance = 1e-13,
        .because = "some epsilons of 8 cosines",
        .question = "Only the time matters here. At which times does this "
                    "table take its slopes?");
}

/* ---- the new method itself ---- */

static double spin;

static void wheel(size_t n, double t, const double y[], double dy[])
{
    (void)n;
    (void)t;
    dy[0] = -spin * y[1];
    dy[1] = spin * y[0];
}

/* In the complex plane a wheel is y' = i spin y, and four stages of order 4
   give the first terms of the exponential. */
CHECK_TIMES(20, test_wheel, i)
{
    const struct table table = new_method();
    const double h = check_draw(0.05, 1.5);
    double y[3] = {check_draw(-1.0, 1.0), check_draw(-1.0, 1.0), 0.0};
    spin = check_draw(-1.0, 1.0);
    const double complex z = I * spin * h;
    const double complex end =
        (y[0] + I * y[1]) *
        (1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
    const char *input = check_text("y' = %g i y, y = %g + %g i, h = %g",
                                   spin, y[0], y[1], h);
    (void)step_under(wheel, &table, 2, 0.0, h, y);
    for (int k = 0; k < 2; ++k)
        CHECK_NEAR(y[k],
                   .quantity = k == 0 ? "y[0], by your table and your step"
                                      : "y[1], by your table and your step",
                   .input = input,
                   .expected = k == 0 ? creal(end) : cimag(end),
                   .tolerance = 1e-14 * 10.0,
                   .because = "some epsilons of ten terms",
                   .question = "Four stages of order 4 give 1 + z + z^2/2 "
                               "+ z^3/6 + z^4/24. Does every y, and every "
                               "slope, have the number that it should?");
}

/* y' = -2 t y^2 with y = 1 at t = 0 has the solution 1/(1 + t^2). */
static void bell(size_t n, double t, const double y[], double dy[])
{
    for (size_t i = 0; i < n; ++i)
        dy[i] = -2.0 * t * y[i] * y[i];
}

static double error_at_end(const struct table *table, int steps)
{
    double y[2] = {1.0, 0.0};
    for (int i = 0; i < steps; ++i)
        (void)step_under(bell, table, 1, 2.0 * i / steps, 2.0 / steps, y);
    return fabs(y[0] - 0.2);
}

static void test_order(void)
{
    const struct table table = new_method();
    const double ratio =
        error_at_end(&table, 40) / error_at_end(&table, 80);
    CHECK_NEAR(log2(ratio),
               .quantity = "order of your method, from 40 steps and 80",
               .input = "y' = -2 t y^2 from y = 1 at t = 0 to t = 2",
               .expected = 4.0, .tolerance = 0.15,
               .because = "steps of finite size",
               .question =
                   "Half the step: how much smaller should the error be? "
                   "This law asks for the time and for y.");
}

const struct check_suite check_suite = {
    .file = "08b-tableau.c",
    .title = "One more row in the tableau",
    .minutes = 30,
    .equation = "eq:runge-kutta",
    .tests = {{"the rows of the 3/8 rule", test_rows, 2, 0},
              {"its weights", test_weights, 1, 0},
              {"one stage is the Euler method", test_one, 1, 0},
              {"two stages, as on paper", test_two, 2, 0},
              {"the third stage uses two slopes", test_three, 1, 0},
              {"many numbers in one step", test_numbers, 1, 0},
              {"any table", test_drawn, 3, 3},
              {"the 3/8 rule turns a wheel", test_wheel, 1, 1},
              {"the 3/8 rule is of order 4", test_order, 1, 0},
              {0}},
};
