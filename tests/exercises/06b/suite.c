/* The suite of exercise 06b, "A chain that forgets its rejections". */

#include "examiner/check.h"
#include "toolbox/random.h"
#include <setjmp.h>
#include <stdio.h>
#include "call.h"

enum { MOST = 4, SCRIPT = 36 };

/* A chain, where it begins, and its random numbers: a script first, and
   then a generator. */
struct job {
    size_t n;
    double radius, dish, step;
    size_t tries;
    double x[MOST], y[MOST];
    double script[SCRIPT];
    uint64_t seed; /* not 0: no script */
};

#define JOB(...) ((struct job){__VA_ARGS__})

/* The source of random numbers that the student's function draws from. */
static struct {
    size_t used, limit, scripted;
    const double *script;
    struct random random;
    jmp_buf too_many;
} source;

double uniform(void)
{
    if (source.used == source.limit)
        longjmp(source.too_many, 1);
    const size_t k = source.used++;
    return k < source.scripted ? source.script[k]
                               : random_uniform(&source.random);
}

void uniform_ahead(double u[], size_t count)
{
    struct random random = source.random;
    for (size_t i = 0; i < count; ++i) {
        const size_t k = source.used + i;
        u[i] = k < source.scripted ? source.script[k]
                                   : random_uniform(&random);
    }
}

struct answer {
    bool ended;
    double mean, accepted, numbers;
    double x[MOST], y[MOST];
};

typedef double chain(const struct job *j, double x[], double y[],
                     size_t *accepted);

/* Runs a chain; untouched places read as NaN. */
static struct answer run(chain *c, const struct job *j)
{
    static struct answer a;
    static size_t accepted;
    a = (struct answer){false, NAN, NAN, NAN, {0}, {0}};
    for (size_t i = 0; i < j->n; ++i) {
        a.x[i] = j->x[i];
        a.y[i] = j->y[i];
    }
    accepted = (size_t)-1;
    source.used = 0;
    source.limit = 60 * j->tries + 600;
    source.script = j->script;
    source.scripted = j->seed ? 0 : 3 * j->tries;
    random_seed(&source.random, j->seed);
    if (setjmp(source.too_many) == 0) {
        a.mean = c(j, a.x, a.y, &accepted);
        a.ended = true;
    }
    a.accepted = accepted == (size_t)-1 ? CHECK_EMPTY : (double)accepted;
    a.numbers = (double)source.used;
    return a;
}

/* For a lecturer's further tests, which may have more disks: a chain with
   these random numbers, three for each try. Returns whether it ended after
   it had asked for just so many. */
bool chain_scripted(size_t n, double radius, double dish, double step,
                    size_t tries, const double script[], double x[],
                    double y[], size_t *accepted, double *mean)
{
    source.used = 0;
    source.scripted = 3 * tries;
    source.limit = 60 * tries;
    source.script = script;
    random_seed(&source.random, 6);
    if (setjmp(source.too_many) != 0)
        return false;
    *mean = mean_square(n, radius, dish, step, tries, x, y, accepted);
    return source.used == 3 * tries;
}

static double student(const struct job *j, double x[], double y[],
                      size_t *accepted)
{
    return mean_square(j->n, j->radius, j->dish, j->step, j->tries, x, y,
                       accepted);
}

/* The slips; RIGHT makes none. */
enum kind {
    RIGHT,
    FORGOTTEN, /* only arrivals count */
    BY_ACCEPTED,
    BY_TRIES,
    REFUSED, /* a rejected try counts where it would have led */
    ANYWAY,  /* a rejected move takes place */
    HALF,    /* only x is put back */
    UNTIL,   /* tried until it is accepted */
    BEFORE,
    MOVER, /* one disk a try is averaged */
    ITSELF,
    ONE_SIDED,
    ALL_ACCEPTED,
    TO_THE_WALL,
    TOUCHING /* is refused */
};

static bool may(const struct job *j, enum kind kind, size_t i, double a,
                double b, const double x[], const double y[])
{
    const double room = j->dish - (kind == TO_THE_WALL ? 0 : j->radius);
    const double wall = a * a + b * b, far = room * room;
    bool free = kind == TOUCHING ? wall < far : wall <= far;
    for (size_t k = 0; k < j->n; ++k) {
        const double off = hypot(a - x[k], b - y[k]), reach = 2 * j->radius;
        if (k != i || kind == ITSELF)
            free = free && (kind == TOUCHING ? off > reach : off >= reach);
    }
    return free;
}

static double squares(const struct job *j, enum kind kind, size_t i,
                      const double x[], const double y[])
{
    double sum = 0.0;
    for (size_t k = 0; k < j->n; ++k)
        if (kind != MOVER || k == i)
            sum += x[k] * x[k] + y[k] * y[k];
    return kind == MOVER ? sum : sum / (double)j->n;
}

/* Moves one disk, if it may; adds to the sum what the kind would add, and
   returns whether the move was accepted. */
static bool try_once(const struct job *j, enum kind kind, double x[],
                     double y[], double *sum)
{
    const bool one_sided = kind == ONE_SIDED;
    const size_t i = (size_t)((double)j->n * uniform());
    const double old_x = x[i], old_y = y[i];
    const double before = squares(j, kind, i, x, y);
    x[i] += j->step * (one_sided ? uniform() : 2.0 * uniform() - 1.0);
    y[i] += j->step * (one_sided ? uniform() : 2.0 * uniform() - 1.0);
    const double refused = squares(j, kind, i, x, y);
    const bool accepted = may(j, kind, i, x[i], y[i], x, y);
    if (!accepted && kind != ANYWAY) {
        x[i] = old_x;
        y[i] = kind == HALF ? y[i] : old_y;
    }
    const bool only_accepted =
        kind == FORGOTTEN || kind == BY_TRIES || kind == UNTIL;
    if (kind == BEFORE)
        *sum += before;
    else if (kind == REFUSED)
        *sum += refused;
    else if (accepted || !only_accepted)
        *sum += squares(j, kind, i, x, y);
    return accepted;
}

static double slipped(const struct job *j, enum kind kind, double x[],
                      double y[], size_t *accepted)
{
    double sum = 0.0;
    size_t moves = 0, tries = 0;
    while ((kind == UNTIL ? moves : tries) < j->tries) {
        moves += try_once(j, kind, x, y, &sum);
        ++tries;
    }
    *accepted = kind == ALL_ACCEPTED ? tries : moves;
    return sum / (double)(kind == FORGOTTEN || kind == BY_ACCEPTED ||
                                  kind == UNTIL
                              ? moves
                              : tries);
}

static enum kind current;

static double with_slip(const struct job *j, double x[], double y[],
                        size_t *accepted)
{
    return slipped(j, current, x, y, accepted);
}

static struct answer run_with(enum kind kind, const struct job *j)
{
    current = kind;
    return run(with_slip, j);
}

/* What to tell those who make a slip. */
static const struct slip {
    struct check_mistake mistake;
    enum kind kind;
} slips[] = {
    {{"rejections-forgotten", 0.0,
      "Only the placings after an accepted move were counted. A try that "
      "is rejected takes its time too: where is the chain meanwhile?"},
     FORGOTTEN},
    {{"divided-by-accepted", 0.0,
      "Every try is in the sum, but you divided by the number of accepted "
      "moves. How many placings have you added up?"},
     BY_ACCEPTED},
    {{"accepted-over-tries", 0.0,
      "You divided by the number of tries, but added up only the accepted "
      "ones. What belongs into the sum for a rejected one?"},
     BY_TRIES},
    {{"refused-counted", 0.0,
      "A rejected try has counted the place to which it would have led. No "
      "disk was ever there. Where was it instead?"},
     REFUSED},
    {{"moved-anyway", 0.0,
      "A disk was left where it may not be: in the wall, or in another "
      "disk. What does the chain do when a move is rejected?"},
     ANYWAY},
    {{"half-put-back", 0.0,
      "After a rejected move one coordinate is the old one and the other "
      "is new. Is that a placing that was looked at?"},
     HALF},
    {{"tried-until-accepted", 0.0,
      "Each try was repeated until a move was accepted. How long did the "
      "chain stay in its old placing while you repeated, and who counts "
      "that?"},
     UNTIL},
    {{"before-the-try", 0.0,
      "The placings before each try, the start among them, give this. "
      "Which ones were wanted?"},
     BEFORE},
    {{"mover-only", 0.0,
      "After a try only the disk that was chosen was added up. Over which "
      "disks is the average wanted?"},
     MOVER},
    {{"compared-with-itself", 0.0,
      "No move at all was accepted. Which disk does every disk overlap, "
      "and need that be looked at?"},
     ITSELF},
    {{"one-sided", 0.0,
      "Your moves only go to the right and up. How would a disk come back, "
      "and what becomes of the balance then?"},
     ONE_SIDED},
    {{"tries-for-accepted", 0.0,
      "*accepted is the number of tries, and the average is right. How "
      "many of the moves took place?"},
     ALL_ACCEPTED},
    {{"to-the-wall", 0.0,
      "The centre of a disk came closer to the wall of the dish than the "
      "disk's radius. How far from the middle may a centre be?"},
     TO_THE_WALL},
    {{"touching-refused", 0.0,
      "A disk that only touches the wall or another disk was not let in. "
      "Does it reach out of the dish, or overlap?"},
     TOUCHING},
};

enum { SLIPS = sizeof slips / sizeof slips[0] };

static bool alike(double a, double b)
{
    return (isnan(a) && isnan(b)) || fabs(a - b) <= 1e-9;
}

/* The slip that gives all that the student has got, if it is the only one.
 */
static struct check_mistake behind(const struct job *j,
                                   const struct answer *a, double got)
{
    struct check_mistake found = {0};
    for (size_t s = 0; s < SLIPS; ++s) {
        const struct answer b = run_with(slips[s].kind, j);
        bool same =
            alike(a->mean, b.mean) && alike(a->accepted, b.accepted);
        for (size_t i = 0; i < j->n; ++i)
            same = same && alike(a->x[i], b.x[i]) && alike(a->y[i], b.y[i]);
        if (same && found.name)
            return (struct check_mistake){0};
        if (same) {
            found = slips[s].mistake;
            found.value = got;
        }
    }
    return found;
}

static const char *input(const struct job *j)
{
    char text[400];
    size_t used = (size_t)snprintf(
        text, sizeof text,
        "dish of %g m, disks of %g m, step %g m, %zu tries, start", j->dish,
        j->radius, j->step, j->tries);
    for (size_t i = 0; i < j->n; ++i)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 " (%g m, %g m)", j->x[i], j->y[i]);
    if (j->seed == 0)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "; uniform() gives");
    for (size_t k = 0; j->seed == 0 && k < 3 * j->tries && used < 380; ++k)
        used += (size_t)snprintf(text + used, sizeof text - used, " %g",
                                 j->script[k]);
    return check_text("%s", text);
}

/* A coordinate gathers at each try the rounding of a product and of a sum,
   of numbers up to the dish; a mean of squares what two coordinates and the
   sum over all tries gather. Twice that, for whoever writes it in another
   way. */
static double rounding(const struct job *j)
{
    return 4.0 * DBL_EPSILON * (double)j->tries * j->dish;
}

static void check_places(const struct job *j, const struct answer *a,
                         const struct answer *expected)
{
    for (size_t c = 0; c < 2 * j->n; ++c) {
        const double got = c % 2 ? a->y[c / 2] : a->x[c / 2];
        const double want = c % 2 ? expected->y[c / 2] : expected->x[c / 2];
        if (fabs(got - want) <= rounding(j))
            continue;
        CHECK_NEAR(got,
                   .quantity =
                       check_text("%s of disk %zu after the last try",
                                  c % 2 ? "y" : "x", c / 2),
                   .unit = "m", .input = input(j), .expected = want,
                   .tolerance = rounding(j),
                   .because = "4 epsilons of the dish for each try",
                   .mistakes = {behind(j, a, got)});
    }
}

static void check_ended(const struct job *j, const struct answer *a)
{
    CHECK_NEAR(a->ended,
               .quantity = "does it end before it has asked for 60 random "
                           "numbers a try? (1 yes, 0 no)",
               .input = input(j), .expected = 1.0, .because = "yes or no",
               .question = "Does a loop of yours wait for a move that is "
                           "allowed? What does it do where there is none?");
}

static void check_given(const struct job *j, const struct answer *expected)
{
    const struct answer a = run(student, j);
    check_ended(j, &a);
    CHECK_NEAR(a.accepted, .quantity = "accepted moves, *accepted",
               .input = input(j), .expected = expected->accepted,
               .because = "a number of moves is exact",
               .mistakes = {behind(j, &a, a.accepted)});
    check_places(j, &a, expected);
    CHECK_NEAR(a.mean, .quantity = "average of x^2 + y^2", .unit = "m^2",
               .input = input(j), .expected = expected->mean,
               .tolerance = 4.0 * j->dish * rounding(j),
               .because = "16 epsilons of the dish squared for each try",
               .equation = "eq:balance",
               .mistakes = {behind(j, &a, a.mean)});
    CHECK_NEAR(a.numbers, .quantity = "random numbers that were asked for",
               .input = input(j), .expected = 3.0 * (double)j->tries,
               .because = "three for each try",
               .question = "A try asks for three numbers. Does yours also "
                           "when it is rejected?");
}

static void check(struct job j)
{
    const struct answer expected = run_with(RIGHT, &j);
    check_given(&j, &expected);
}

/* limit: 1 (disk, and one try) */
static void test_accepted(void)
{
    check_ask("All of these moves are allowed. Which placings does the "
              "chain go through, and which of them count?");
    check(JOB(.n = 1, .radius = 0.25, .dish = 1.0, .step = 0.5, .tries = 1,
              .script = {0.5, 0.75, 0.25}));
    check(JOB(.n = 1, .radius = 0.25, .dish = 1.0, .step = 0.5, .tries = 3,
              .x = {-0.25},
              .script = {0.5, 0.75, 0.125, 0.25, 0.625, 0.5, 0.0, 0.125,
                         0.75}));
}

static void test_wall(void)
{
    check_ask("One of these moves leads into the wall. Where is the disk "
              "after that try, and what does the try add to the average?");
    check(JOB(.n = 1, .radius = 0.25, .dish = 1.0, .step = 0.5, .tries = 3,
              .x = {0.5},
              .script = {0.5, 0.25, 0.75, 0.5, 0.25, 0.875, 0.5, 0.75,
                         0.375}));
    check(JOB(.n = 1, .radius = 0.25, .dish = 1.0, .step = 0.5, .tries = 4,
              .x = {0.5}, .y = {0.25},
              .script = {0.5, 0.875, 0.5, 0.5, 0.875, 0.75, 0.5, 0.25,
                         0.375, 0.5, 0.0, 0.5}));
}

static void test_disk(void)
{
    check_ask("Some of these moves lead into the other disk. Which placing "
              "counts after such a try?");
    check(JOB(.n = 2, .radius = 0.25, .dish = 1.0, .step = 0.5, .tries = 4,
              .x = {-0.5, 0.25},
              .script = {0.25, 0.875, 0.5, 0.75, 0.75, 0.625, 0.25, 0.75,
                         0.25, 0.5, 0.25, 0.25}));
}

/* A disk comes to the wall, and to another disk, and just touches it. */
static void test_just_fits(void)
{
    check_ask("The disk just touches what it has come to. Does it reach "
              "out of the dish, or overlap?");
    check(JOB(.n = 1, .radius = 0.25, .dish = 1.0, .step = 1.0, .tries = 1,
              .script = {0.0, 0.875, 0.5}));
    check(JOB(.n = 2, .radius = 0.25, .dish = 1.0, .step = 1.0, .tries = 1,
              .x = {-0.5, 0.5}, .script = {0.0, 0.75, 0.5}));
}

static void test_caught(void)
{
    check_ask("No move takes place here at all. Where is the disk at each "
              "of the tries? What do you divide by?");
    check(
        JOB(.n = 1, .radius = 0.5, .dish = 1.0, .step = 0.25, .tries = 3,
            .x = {0.5},
            .script = {0.0, 0.75, 0.5, 0.5, 0.625, 0.75, 0.5, 0.75, 0.25}));
}

static const struct job many = {.n = 4,
                                .radius = 0.25,
                                .dish = 1.0,
                                .step = 0.25,
                                .tries = 1000,
                                .x = {-0.5, 0.5, 0.0, 0.0},
                                .y = {0.0, 0.0, -0.5, 0.5},
                                .seed = 62};

/* limit: 100 disks */
/* A hundred disks in ten rows; each moves up and to the right, in its turn.
 */
static void check_hundred(void)
{
    enum { N = 100, ROW = 10 };
    static double script[3 * N], x[N], y[N];
    const double step = 0.02, a = 0.13;
    double now = 0.0, expected = 0.0, mean = NAN;
    size_t accepted = 0;
    for (int i = 0; i < N; ++i) {
        x[i] = (i % ROW - 4.5) * a;
        y[i] = (i / ROW - 4.5) * a;
        now += x[i] * x[i] + y[i] * y[i];
        script[3 * i] = (i + 0.5) / N;
        script[3 * i + 1] = script[3 * i + 2] = 0.75;
    }
    for (int i = 0; i < N; ++i) {
        now += step * (x[i] + y[i]) + 0.5 * step * step;
        expected += now / N / N;
    }
    const bool ended = chain_scripted(N, 0.03, 1.0, step, N, script, x, y,
                                      &accepted, &mean);
    static const char question[] =
        "There may be up to 100 disks, and here there are. Is there room "
        "for all of them in your program, and does each have its turn?";
    static const char text[] =
        "100 disks of 0.03 m in ten rows, in a dish of 1 m; each moves by "
        "0.01 m along x and y, one after the other";
    CHECK_NEAR(ended ? (double)accepted : NAN,
               .quantity = "accepted moves, *accepted", .input = text,
               .expected = N, .because = "a number of moves is exact",
               .question = question);
    CHECK_NEAR(mean, .quantity = "average of x^2 + y^2", .unit = "m^2",
               .input = text, .expected = expected,
               .tolerance = 16.0 * DBL_EPSILON * N,
               .because = "16 epsilons of the dish squared for each try",
               .equation = "eq:balance", .question = question);
}

static void test_many(void)
{
    check_hundred();
    check_ask("A thousand tries, with four disks. Does your chain go the "
              "same way, and count each of its placings?");
    check(many);
}

/* How much room there is at least around disk i at (a, b): to the wall and
   to the others. Negative where it overlaps. */
static double least_room(const struct job *j, size_t i, double a, double b)
{
    double room = j->dish - j->radius - hypot(a, b);
    for (size_t k = 0; k < j->n; ++k)
        if (k != i)
            room = fmin(room,
                        hypot(a - j->x[k], b - j->y[k]) - 2.0 * j->radius);
    return room;
}

/* Three numbers for a try of disk i, drawn until it is clear by a
   hundredth of a metre whether the move is allowed. Returns whether it is,
   and where it leads. */
static bool draw_try(const struct job *j, size_t i, double u[3],
                     double place[2])
{
    double room;
    do {
        u[0] =
            round(1e4 * ((double)i + check_draw(0.1, 0.9)) / (double)j->n) /
            1e4;
        u[1] = check_draw(0.0, 0.9999);
        u[2] = check_draw(0.0, 0.9999);
        place[0] = j->x[i] + j->step * (2.0 * u[1] - 1.0);
        place[1] = j->y[i] + j->step * (2.0 * u[2] - 1.0);
        room = least_room(j, i, place[0], place[1]);
    } while (fabs(room) < 0.01);
    return room > 0.0;
}

/* A few disks in the middle of four parts of a dish. */
static struct job draw_start(void)
{
    static const double way[MOST][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    struct job j =
        JOB(.n = (size_t)check_draw_whole(1, MOST),
            .radius = check_draw(0.1, 0.25), .dish = check_draw(1.0, 2.0),
            .step = check_draw(0.2, 0.9), .tries = SCRIPT / 3);
    for (size_t i = 0; i < j.n; ++i) {
        j.x[i] = 0.5 * way[i][0];
        j.y[i] = 0.5 * way[i][1];
    }
    return j;
}

/* A place of a disk counts for each try from the one that led to it up to
   the one before it is left: from `since` on. */
static struct job draw_chain(struct answer *expected)
{
    const struct job start = draw_start();
    struct job j = start, chain = start;
    double sum = 0.0, since[MOST] = {0.0};
    expected->accepted = 0.0;
    for (size_t t = 0; t < j.tries; ++t) {
        const size_t i = (size_t)check_draw_whole(0, (int)j.n - 1);
        double place[2];
        if (!draw_try(&j, i, &chain.script[3 * t], place))
            continue;
        sum += ((double)t - since[i]) * pow(hypot(j.x[i], j.y[i]), 2);
        since[i] = (double)t;
        j.x[i] = place[0];
        j.y[i] = place[1];
        expected->accepted += 1.0;
    }
    for (size_t i = 0; i < j.n; ++i) {
        sum += ((double)j.tries - since[i]) * pow(hypot(j.x[i], j.y[i]), 2);
        expected->x[i] = j.x[i];
        expected->y[i] = j.y[i];
    }
    expected->mean = sum / (double)(j.n * j.tries);
    return chain;
}

CHECK_TIMES(30, test_drawn, i)
{
    check_ask("For each disk, write down from which try to which it is at "
              "each of its places. What is the average then?");
    struct answer expected = {.ended = true};
    const struct job j = draw_chain(&expected);
    check_given(&j, &expected);
}

/* The share of a disk of the radius d around a point at the distance r from
   the middle that lies in a disk of the radius a, as an area. */
static double lens(double a, double d, double r)
{
    const double pi = 3.14159265358979323846;
    if (r <= a - d)
        return pi * d * d;
    const double c = (r * r + a * a - d * d) / (2.0 * r), e = r - c;
    return a * a * acos(c / a) + d * d * acos(e / d) -
           r * sqrt(a * a - c * c);
}

/* The exact mean of x^2 + y^2 of one of two disks: the probability of a
   place is in proportion to the room that it leaves to the other. By the
   midpoint rule with 2000 points, whose error is below 1e-6. */
static double exact_two(double a, double d)
{
    enum { POINTS = 2000 };
    const double pi = 3.14159265358979323846;
    double all = 0.0, sum = 0.0;
    for (int k = 0; k < POINTS; ++k) {
        const double r = a * (k + 0.5) / POINTS;
        const double weight = r * (pi * a * a - lens(a, d, r));
        all += weight;
        sum += weight * r * r;
    }
    return sum / all;
}

static void check_mean(const struct job *j, double expected, double scatter)
{
    const struct answer a = run(student, j);
    check_ended(j, &a);
    CHECK_NEAR(
        a.mean, .quantity = "average of x^2 + y^2", .unit = "m^2",
        .input = input(j), .expected = expected, .tolerance = 4.0 * scatter,
        .because = "4 times the scatter of such averages",
        .equation = "eq:balance", .mistakes = {behind(j, &a, a.mean)});
}

/* A single disk is evenly spread: the mean is (dish - radius)^2/2. The
   averages of 400 seeds scatter by 0.0021; without the rejections they are
   0.033 too small. */
static void test_one(void)
{
    const struct job j = JOB(.n = 1, .radius = 0.25, .dish = 1.0,
                             .step = 0.75, .tries = 20000, .seed = 63);
    check_ask("One disk alone is as often at one place as at any other. Is "
              "yours at the wall as often as in the middle?");
    check_mean(&j, 0.28125, 0.0021);
}

/* The averages of 200 seeds scatter by 0.0028; without the rejections they
   are 0.0148 too small. */
static void test_two(void)
{
    const struct job j =
        JOB(.n = 2, .radius = 0.2, .dish = 1.0, .step = 0.4, .tries = 20000,
            .x = {-0.4, 0.4}, .seed = 64);
    check_ask("Two disks crowd each other towards the wall, and there most "
              "moves are rejected. How often do those placings count?");
    check_mean(&j, exact_two(0.8, 0.4), 0.0028);
}

const struct check_suite check_suite = {
    .file = "06b-rejected.c",
    .title = "A chain that forgets its rejections",
    .minutes = 25,
    .equation = "eq:metropolis",
    .tests =
        {{"an accepted move counts the new placing", test_accepted, 1, 0},
         {"a move into the wall counts the old one again", test_wall, 2, 0},
         {"so does a move into another disk", test_disk, 2, 0},
         {"to touch is no overlap", test_just_fits, 1, 0},
         {"a disk that cannot move is where it is", test_caught, 1, 0},
         {"a thousand tries go the right way", test_many, 1, 0},
         {"each place counts for as long as it lasts", test_drawn, 2, 3},
         {"one disk is evenly spread over the dish", test_one, 2, 0},
         {"two disks are as far out as they must be", test_two, 2, 0},
         {0}},
    .idle = {test_accepted, test_just_fits},
};
