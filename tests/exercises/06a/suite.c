/* The suite of exercise 06a, "A sampler that keeps what fitted". */

#include "examiner/check.h"
#include "toolbox/random.h"
#include <setjmp.h>
#include <stdio.h>
#include "call.h"

enum { MOST = 4, SCRIPT = 32, RECENT = 2 * MOST };

/* All that one call may ask for. */
enum { MOST_NUMBERS = 100000 };

/* What is thrown, and the random numbers to throw it with: a script first,
   and then a generator. */
struct job {
    size_t n;
    double radius[MOST], width, height;
    size_t scripted;
    double script[SCRIPT];
};

#define JOB(...) ((struct job){__VA_ARGS__})

/* The source of random numbers that the student's function draws from. */
static struct {
    const double *script;
    size_t scripted, used, limit;
    struct random random;
    double recent[RECENT];
    jmp_buf too_many;
} source;

double uniform(void)
{
    if (source.used == source.limit)
        longjmp(source.too_many, 1);
    const double u = source.used < source.scripted
                         ? source.script[source.used]
                         : random_uniform(&source.random);
    source.recent[source.used++ % RECENT] = u;
    return u;
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

/* Begins a new sequence. */
static void source_begin(const struct job *j, uint64_t seed)
{
    source.script = j->script;
    source.scripted = j->scripted;
    random_seed(&source.random, seed);
}

typedef size_t sampler(const struct job *j, double x[], double y[]);

struct answer {
    bool ended;
    double throws, x[MOST], y[MOST];
};

/* Calls a sampler; untouched places read as NaN. */
static struct answer call(sampler *s, const struct job *j)
{
    static struct answer a;
    static size_t throws;
    a = (struct answer){false, NAN, {0}, {0}};
    for (size_t i = 0; i < MOST; ++i)
        a.x[i] = a.y[i] = CHECK_EMPTY;
    source.used = 0;
    source.limit = MOST_NUMBERS;
    if (setjmp(source.too_many) == 0) {
        throws = s(j, a.x, a.y);
        a.throws = (double)throws;
        a.ended = true;
    }
    return a;
}

static size_t student(const struct job *j, double x[], double y[])
{
    return throw_disks(j->n, j->radius, j->width, j->height, x, y);
}

/* For a lecturer's further tests, which may have more disks: one call with
   these random numbers. Returns whether it ended. */
bool throw_scripted(size_t n, const double radius[], const double size[2],
                    const double script[], size_t count, double x[],
                    double y[], size_t *throws)
{
    source.script = script;
    source.scripted = count;
    source.used = 0;
    source.limit = MOST_NUMBERS;
    random_seed(&source.random, 6);
    if (setjmp(source.too_many) != 0)
        return false;
    *throws = throw_disks(n, radius, size[0], size[1], x, y);
    return true;
}

/* The first call after the source has begun with the job's own script. */
static struct answer first(sampler *s, const struct job *j)
{
    source_begin(j, 6);
    return call(s, j);
}

static double along(double radius, double size, double u)
{
    return radius + (size - 2.0 * radius) * u;
}

static void place(const struct job *j, size_t i, double x[], double y[])
{
    x[i] = along(j->radius[i], j->width, uniform());
    y[i] = along(j->radius[i], j->height, uniform());
}

static bool touch(const struct job *j, size_t i, size_t k, const double x[],
                  const double y[])
{
    return hypot(x[i] - x[k], y[i] - y[k]) < j->radius[i] + j->radius[k];
}

/* How two disks may be compared, rightly and wrongly. */
typedef bool overlap(const struct job *j, size_t i, size_t k,
                     const double x[], const double y[]);

static bool neighbours(const struct job *j, size_t i, size_t k,
                       const double x[], const double y[])
{
    return i == k + 1 && touch(j, i, k, x, y);
}

static bool squares(const struct job *j, size_t i, size_t k,
                    const double x[], const double y[])
{
    const double reach = j->radius[i] + j->radius[k];
    return fabs(x[i] - x[k]) < reach && fabs(y[i] - y[k]) < reach;
}

static bool one_radius(const struct job *j, size_t i, size_t k,
                       const double x[], const double y[])
{
    return hypot(x[i] - x[k], y[i] - y[k]) < j->radius[i];
}

static bool equal_radii(const struct job *j, size_t i, size_t k,
                        const double x[], const double y[])
{
    return hypot(x[i] - x[k], y[i] - y[k]) < 2.0 * j->radius[i];
}

/* The first disk before i that it overlaps; i when there is none. */
static size_t hit(const struct job *j, size_t i, overlap *o,
                  const double x[], const double y[])
{
    size_t k = 0;
    while (k < i && !o(j, i, k, x, y))
        ++k;
    return k;
}

/* Disk after disk; at an overlap back to the disk with this number, or to
   the one that overlaps where that is smaller. */
static size_t back_to(size_t from, overlap *o, const struct job *j,
                      double x[], double y[])
{
    size_t throws = 1;
    for (size_t i = 0; i < j->n;) {
        place(j, i, x, y);
        if (hit(j, i, o, x, y) == i) {
            ++i;
        } else {
            i = i < from ? i : from;
            ++throws;
        }
    }
    return throws;
}

static size_t right(const struct job *j, double x[], double y[])
{
    return back_to(0, touch, j, x, y);
}

/* All are thrown; then the two of the first pair that overlaps, until there
   is none. */
static size_t two_again(const struct job *j, double x[], double y[])
{
    size_t throws = 1, i = 0;
    for (size_t k = 0; k < j->n; ++k)
        place(j, k, x, y);
    while (i < j->n) {
        const size_t k = hit(j, i, touch, x, y);
        if (k == i) {
            ++i;
            continue;
        }
        place(j, k, x, y);
        place(j, i, x, y);
        ++throws;
        i = 0;
    }
    return throws;
}

static size_t looked_once(const struct job *j, double x[], double y[])
{
    size_t throws = 1;
    for (size_t i = 0; i < j->n; ++i) {
        place(j, i, x, y);
        if (throws == 1 && hit(j, i, touch, x, y) < i) {
            throws = 2;
            i = (size_t)-1;
        }
    }
    return throws;
}

/* No distance is kept from the walls. */
static size_t no_walls(const struct job *j, double x[], double y[])
{
    size_t throws = 1;
    for (size_t i = 0; i < j->n;) {
        x[i] = j->width * uniform();
        y[i] = j->height * uniform();
        const bool bad = hit(j, i, touch, x, y) < i;
        i = bad ? 0 : i + 1;
        throws += bad;
    }
    return throws;
}

/* The slips, and what to tell those who make them. */
static const struct slip {
    struct check_mistake mistake;
    sampler *sampler; /* NULL: back_to, with these */
    size_t from;
    overlap *overlap;
} slips[] = {
    {{"last-thrown-again", 0.0,
      "The last disk was thrown again until it fitted, and those before it "
      "kept their places. Does a first disk in the middle of the box then "
      "come as often as one in a corner, though it leaves less room?"},
     NULL,
     MOST,
     touch},
    {{"first-kept", 0.0,
      "Disk 0 kept its place when two disks overlapped, and the others "
      "were thrown again. By what right does one disk stay, and how is its "
      "place spread over the box?"},
     NULL,
     1,
     touch},
    {{"two-thrown-again", 0.0,
      "Only the two disks that overlap were thrown again. The others stay "
      "where they were, and so the new placing depends on a forbidden one. "
      "What must be forgotten of it?"},
     two_again,
     0,
     NULL},
    {{"looked-once", 0.0,
      "All disks were thrown again after an overlap, and this was taken as "
      "it fell. May the second throw overlap too? Which statement of C "
      "looks as often as it must?"},
     looked_once,
     0,
     NULL},
    {{"neighbours-only", 0.0,
      "Each disk was compared with the one that was thrown just before it. "
      "Which other disks may it fall on?"},
     NULL,
     0,
     neighbours},
    {{"squares-for-disks", 0.0,
      "Two disks were taken for overlapping that are near in x and near in "
      "y, but do not touch. Which distance counts for round bodies?"},
     NULL,
     0,
     squares},
    {{"all-radii-alike", 0.0,
      "One radius was doubled, as if both disks had it. How far apart are "
      "the centres of a large and a small disk that touch?"},
     NULL,
     0,
     equal_radii},
    {{"one-radius", 0.0,
      "Two disks overlap here, and they were let through. How far apart "
      "are the centres of two disks that touch?"},
     NULL,
     0,
     one_radius},
    {{"walls-forgotten", 0.0,
      "The centres reach up to the walls, so the disks reach beyond them. "
      "Where must a centre be for the whole disk to be in the box?"},
     no_walls,
     0,
     NULL},
};

enum { SLIPS = sizeof slips / sizeof slips[0] };

/* The slip that is made now. */
static const struct slip *current;

static size_t with_slip(const struct job *j, double x[], double y[])
{
    return current->sampler
               ? current->sampler(j, x, y)
               : back_to(current->from, current->overlap, j, x, y);
}

static bool same_place(const struct job *j, const struct answer *a,
                       const struct answer *b)
{
    double off = 0.0;
    for (size_t i = 0; i < j->n; ++i)
        off = fmax(off,
                   fmax(fabs(a->x[i] - b->x[i]), fabs(a->y[i] - b->y[i])));
    return a->ended && b->ended && off <= 1e-12;
}

/* The slip that puts all disks where the student has put them, if it is the
   only one; the source goes on from where it stood before the call. */
static struct check_mistake behind(const struct job *j,
                                   const struct answer *a,
                                   struct random before, double got)
{
    struct check_mistake found = {0};
    for (size_t s = 0; s < SLIPS; ++s) {
        source.random = before;
        current = &slips[s];
        const struct answer b = call(with_slip, j);
        if (!same_place(j, a, &b))
            continue;
        if (found.name)
            return (struct check_mistake){0};
        found = slips[s].mistake;
        found.value = got;
    }
    return found;
}

static const char *input(const struct job *j)
{
    char text[400];
    size_t used = 0;
    used += (size_t)snprintf(text, sizeof text,
                             "box of %g m x %g m, radii in m:", j->width,
                             j->height);
    for (size_t i = 0; i < j->n; ++i)
        used += (size_t)snprintf(text + used, sizeof text - used, " %g",
                                 j->radius[i]);
    if (j->scripted > 0)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "; uniform() gives");
    for (size_t k = 0; k < j->scripted && used < 360; ++k)
        used += (size_t)snprintf(text + used, sizeof text - used, " %g",
                                 j->script[k]);
    return check_text("%s%s", text, j->scripted > 0 ? " ..." : "");
}

static void check_ended(const struct job *j, const struct answer *a)
{
    CHECK_NEAR(a->ended,
               .quantity = "does it end before it has asked for 100000 "
                           "random numbers? (1 yes, 0 no)",
               .input = input(j), .expected = 1.0, .because = "yes or no");
}

/* A coordinate is a product and two sums of numbers up to the box's size,
   each rounded; twice that, for whoever writes it in another way. */
static void check_place(const struct job *j, const struct answer *a,
                        const struct answer *expected, struct random before)
{
    for (size_t c = 0; c < 2 * j->n; ++c) {
        const size_t i = c / 2;
        const bool is_x = c % 2 == 0;
        const double got = is_x ? a->x[i] : a->y[i];
        const double want = is_x ? expected->x[i] : expected->y[i];
        const double size = is_x ? j->width : j->height;
        const double tolerance = 4.0 * DBL_EPSILON * size;
        if (fabs(got - want) <= tolerance)
            continue;
        CHECK_NEAR(got,
                   .quantity =
                       check_text("%s of disk %zu", is_x ? "x" : "y", i),
                   .unit = "m", .input = input(j), .expected = want,
                   .tolerance = tolerance,
                   .because = "4 epsilons of the size of the box",
                   .mistakes = {behind(j, a, before, got)});
    }
}

/* The disks of the student lie where the last 2 n numbers put them? Those
   of a throw that is finished after an overlap and those of one that is
   not are different numbers, but each placing is the last ones. */
static void check_last(const struct job *j, const struct answer *a,
                       struct random before)
{
    struct answer expected = *a;
    for (size_t i = 0; i < j->n && source.used >= 2 * j->n; ++i) {
        const size_t k = source.used - 2 * (j->n - i);
        expected.x[i] =
            along(j->radius[i], j->width, source.recent[k % RECENT]);
        expected.y[i] =
            along(j->radius[i], j->height, source.recent[(k + 1) % RECENT]);
    }
    check_place(j, a, &expected, before);
}

/* How many single disks a right sampler throws that stops at an overlap. */
static double disks_thrown(const struct job *j)
{
    source_begin(j, 6);
    return call(right, j).ended ? 0.5 * (double)source.used : NAN;
}

/* A script of which every throw fails at its last disk, if it fails: those
   who stop at an overlap and those who do not use the same numbers. */
static void check_given(const struct job *j, const struct answer *expected)
{
    struct random before;
    random_seed(&before, 6);
    const struct answer a = first(student, j);
    check_ended(j, &a);
    check_place(j, &a, expected, before);
    CHECK_NEAR(
        a.throws, .quantity = "how often all disks were thrown",
        .input = input(j), .expected = expected->throws,
        .because = "a number of throws is exact",
        .mistakes = {{"counts-failures", expected->throws - 1.0,
                      "So many throws failed. Was the last one, which "
                      "fitted, not a throw?"},
                     {"counts-disks", disks_thrown(j),
                      "This is how many single disks were thrown. How "
                      "often were all of them thrown, or begun to be?"}});
}

static void check_script(struct job j, double throws)
{
    struct answer expected = first(right, &j);
    expected.throws = throws;
    check_given(&j, &expected);
}

static void test_at_once(void)
{
    check_ask("Nothing overlaps here. Where may the centre of a disk be, "
              "and which numbers say where it is?");
    check_script(JOB(1, {0.25}, 1.0, 2.0, 2, {0.5, 0.25}), 1.0);
    check_script(JOB(3, {0.125, 0.125, 0.125}, 1.0, 1.0, 6,
                     {0.0, 0.0, 0.9, 0.1, 0.3, 0.8}),
                 1.0);
}

/* The third falls on the first, and then on the second; a slip that keeps
   any of them puts the three elsewhere than any other does. */
static void test_three(void)
{
    check_ask("The third disk fell on another. Which of the three may keep "
              "its place?");
    check_script(
        JOB(3, {0.15, 0.15, 0.15}, 1.0, 1.0, 12,
            {0.1, 0.1, 0.9, 0.9, 0.2, 0.2, 0.3, 0.1, 0.9, 0.5, 0.35, 0.95}),
        2.0);
    check_script(
        JOB(3, {0.15, 0.15, 0.15}, 1.0, 1.0, 12,
            {0.1, 0.1, 0.9, 0.9, 0.8, 0.7, 0.2, 0.9, 0.5, 0.3, 0.95, 0.85}),
        2.0);
}

static void test_two(void)
{
    check_ask("The second disk fell on the first. Which of the two must be "
              "thrown again?");
    check_script(JOB(2, {0.2, 0.2}, 1.0, 1.0, 8,
                     {0.5, 0.5, 0.6, 0.7, 0.1, 0.2, 0.8, 0.9}),
                 2.0);
    check_ask(
        "The two disks are near in x and near in y. Do they overlap?");
    check_script(JOB(2, {0.2, 0.2}, 1.0, 1.0, 4, {0.2, 0.1, 0.75, 0.65}),
                 1.0);
}

static void test_again(void)
{
    check_ask("Three throws failed, one after the other. What does your "
              "program do when a new throw overlaps too?");
    check_script(JOB(3, {0.1, 0.1, 0.1}, 1.0, 1.0, 24,
                     {0.0, 0.0, 1.0, 0.5, 0.9, 0.5,  //
                      0.2, 0.2, 0.8, 0.2, 0.2, 0.3,  //
                      0.5, 0.5, 0.1, 0.9, 0.0, 0.95, //
                      0.6, 0.1, 0.3, 0.8, 0.7, 0.7}),
                 4.0);
}

static void test_radii(void)
{
    check_ask("A large disk and a small one. Do they overlap, and where "
              "may each of them be?");
    check_script(JOB(2, {0.3, 0.05}, 1.0, 1.0, 8,
                     {0.0, 0.0, 0.5, 0.2, 1.0, 0.5, 0.1, 0.3}),
                 2.0);
    check_script(JOB(2, {0.05, 0.3}, 1.0, 1.0, 4, {0.1, 0.1, 0.8, 0.3}),
                 1.0);
    check_ask("The two disks touch, and no more. Is that an overlap?");
    check_script(
        JOB(2, {0.25, 0.125}, 1.25, 1.25, 4, {0.0, 0.0, 0.5, 0.125}), 1.0);
}

/* The first disk in the middle: no corner is far enough away. */
static void test_no_room(void)
{
    check_ask(
        "The first disk fell into the middle of a small box, and no other "
        "can ever fit beside it. Whose place must be given up?");
    check_script(JOB(2, {0.28, 0.28}, 1.0, 1.0, 8,
                     {0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0}),
                 2.0);
}

/* Where a side of the box is left to a disk in one half of it, as a number
   from uniform(). */
static double in_half(double radius, double size, bool upper)
{
    const double most = (0.5 * size - 2.0 * radius) / (size - 2.0 * radius);
    const double u = check_draw(0.0, 0.97 * most);
    return upper ? 1.0 - u : u;
}

/* Each disk in a quarter of the box that no other has. Returns where the
   numbers of this throw are in the script. */
static double *throw_apart(struct job *j)
{
    double *u = &j->script[j->scripted];
    const size_t turn = (size_t)check_draw_whole(0, 3);
    for (size_t i = 0; i < j->n; ++i) {
        const size_t quarter = (i + turn) % 4;
        u[2 * i] = in_half(j->radius[i], j->width, quarter % 2);
        u[2 * i + 1] = in_half(j->radius[i], j->height, quarter / 2);
    }
    j->scripted += 2 * j->n;
    return u;
}

/* The number, in four digits, that puts a centre at the place x, or as near
   to it as the walls allow. */
static double number_for(double radius, double size, double x)
{
    const double u = (x - radius) / (size - 2.0 * radius);
    return round(1e4 * fmin(0.9999, fmax(0.0, u))) / 1e4;
}

/* The last disk falls on one of the others, on its inner side: 0.2 to 0.6
   of the distance at which they would touch away from it along x, and along
   y at most by 0.55, where the wall shifts it. */
static void throw_badly(struct job *j)
{
    double *u = throw_apart(j);
    const size_t last = j->n - 1;
    const size_t on = (size_t)check_draw_whole(0, (int)last - 1);
    const double x = along(j->radius[on], j->width, u[2 * on]);
    const double y = along(j->radius[on], j->height, u[2 * on + 1]);
    const double off =
        check_draw(0.2, 0.6) * (j->radius[on] + j->radius[last]);
    u[2 * last] = number_for(j->radius[last], j->width,
                             x < 0.5 * j->width ? x + off : x - off);
    u[2 * last + 1] = number_for(j->radius[last], j->height, y);
}

/* Two disks that are near in x and near in y, but 1.05 to 1.35 times the
   distance at which they would touch from each other. */
static double *throw_diagonally(struct job *j)
{
    double *u = throw_apart(j);
    const double x = along(j->radius[0], j->width, u[0]);
    const double y = along(j->radius[0], j->height, u[1]);
    const double off =
        check_draw(1.05, 1.35) * (j->radius[0] + j->radius[1]) / sqrt(2.0);
    u[2] = number_for(j->radius[1], j->width,
                      x < 0.5 * j->width ? x + off : x - off);
    u[3] = number_for(j->radius[1], j->height,
                      y < 0.5 * j->height ? y + off : y - off);
    return u;
}

/* A few disks in some box; in a box of 1 m by 1 m they fit in one throw out
   of thirty or more. */
static struct job draw_job(void)
{
    struct job j =
        JOB(.n = (size_t)check_draw_whole(2, MOST),
            .width = check_draw(1.0, 2.0), .height = check_draw(1.0, 2.0));
    for (size_t i = 0; i < j.n; ++i)
        j.radius[i] = check_draw(0.05, 0.15);
    return j;
}

/* Up to three throws that fail, and one that fits. */
CHECK_TIMES(30, test_drawn, i)
{
    check_ask("In the first throws, if there are any, the last disk falls "
              "on another; in the last one no two touch. Which numbers "
              "make the placing?");
    struct job j = draw_job();
    struct answer a = {.ended = true};
    const int failed = check_draw_whole(0, 3);
    for (int k = 0; k < failed; ++k)
        throw_badly(&j);
    const double *u = j.n == 2 ? throw_diagonally(&j) : throw_apart(&j);
    for (size_t k = 0; k < j.n; ++k) {
        a.x[k] = along(j.radius[k], j.width, u[2 * k]);
        a.y[k] = along(j.radius[k], j.height, u[2 * k + 1]);
    }
    a.throws = failed + 1.0;
    check_given(&j, &a);
}

/* The numbers are those of a generator. */
static void check_many(const struct job *j)
{
    check_ask("Some disks lie where an earlier throw had put them. Which "
              "random numbers make a placing?");
    for (int sample = 0; sample < 20; ++sample) {
        const struct random before = source.random;
        const struct answer a = call(student, j);
        check_ended(j, &a);
        check_last(j, &a, before);
        for (size_t i = 0; i < j->n; ++i)
            CHECK_NEAR(
                (double)hit(j, i, touch, a.x, a.y),
                .quantity = check_text(
                    "the first disk that disk %zu overlaps (%zu: none)", i,
                    i),
                .input = input(j), .expected = (double)i,
                .because = "a number of a disk is exact",
                .question =
                    "Two of the disks overlap. Who looks, and when?",
                .mistakes = {behind(j, &a, before,
                                    (double)hit(j, i, touch, a.x, a.y))});
    }
}

/* limit: 1 (disk, in the throw of one number) */
/* limit: 100 disks */
/* A hundred disks in ten rows. In a first throw the last one falls on
   another, so that all hundred are thrown again. */
static void check_hundred(void)
{
    enum { N = 100, ROW = 10 };
    static double radius[N], script[4 * N], x[N], y[N];
    const double r = 0.04, size[2] = {1.0, 1.0};
    size_t throws = 0;
    for (int i = 0; i < N; ++i) {
        radius[i] = r;
        for (int k = 0; k < 2; ++k) {
            const double at = (k ? i / ROW : i % ROW) * 0.1 + 0.05;
            script[2 * i + k] = script[2 * (N + i) + k] =
                (at - r) / (1.0 - 2.0 * r);
        }
    }
    script[2 * N - 2] = script[2 * 42];
    script[2 * N - 1] = script[2 * 42 + 1];
    const bool ended =
        throw_scripted(N, radius, size, script, 4 * N, x, y, &throws);
    static const char question[] =
        "There may be up to 100 disks, and here there are. Is there room "
        "for all of them in your program, and is each compared with each?";
    static const char text[] =
        "100 disks of 0.04 m in ten rows, in a box of 1 m by 1 m; in a "
        "first throw the last one falls on another";
    CHECK_NEAR(ended ? (double)throws : NAN, .quantity = "throws",
               .input = text, .expected = 2.0,
               .because = "a number of throws is exact",
               .question = question);
    for (int i = 0; i < N; ++i)
        CHECK_NEAR(x[i] + 10.0 * y[i],
                   .quantity = check_text("x + 10 y of disk %d", i),
                   .unit = "m", .input = text,
                   .expected = 0.1 * (i % ROW) + i / ROW + 0.55,
                   .tolerance = 128.0 * DBL_EPSILON,
                   .because = "8 epsilons of 11 m, and some",
                   .question = question);
}

static void test_many(void)
{
    check_hundred();
    for (int i = 0; i < 10; ++i) {
        const struct job j = draw_job();
        source_begin(&j, (uint64_t)check_draw_whole(1, 1000000));
        check_many(&j);
    }
}

/* The acceptance of two equal disks whose centres move in a square of the
   side a; d is the distance at which they touch: the exact closed form of
   the chapter. */
static double acceptance(double a, double d)
{
    const double pi = 3.14159265358979323846, s = d / a;
    return 1.0 - s * s * (pi - 8.0 / 3.0 * s + 0.5 * s * s);
}

/* The throws of a success have the mean 1/p and the standard deviation
   sqrt(1 - p)/p, so the share of m successes scatters by p sqrt((1 - p)/m).
   Four of these: a right sampler fails once in 16000 seeds. */
static void test_acceptance(void)
{
    enum { PLACINGS = 5000 };
    const struct job two =
        JOB(.n = 2, .radius = {0.15, 0.15}, .width = 1, .height = 1);
    const double p = acceptance(0.7, 0.3);
    double throws = 0.0;
    source_begin(&two, 602);
    check_ask("Two disks have much room here.");
    for (int sample = 0; sample < PLACINGS; ++sample) {
        const struct answer a = call(student, &two);
        check_ended(&two, &a);
        throws += a.throws;
    }
    CHECK_NEAR(
        PLACINGS / throws, .quantity = "share of the throws that fitted",
        .input = check_text("5000 placings, %s", input(&two)),
        .expected = p, .tolerance = 4.0 * p * sqrt((1.0 - p) / PLACINGS),
        .because = "4 standard errors of 5000 placings",
        .equation = "eq:two-disks",
        .question =
            "If the first disk had been placed rightly, the share would be "
            "that of the formula. What do you count as a throw?");
}

/* Four disks, many times. */
static const struct job four = {
    .n = 4, .radius = {0.15, 0.15, 0.15, 0.15}, .width = 1, .height = 1};

/* <((x - 1/2)/0.7)^2>: in 5e9 throws of four disks, 1.8e8 of which fitted,
   it was 0.1082915 with an error of 2.4e-6; evenly spread disks have 1/12.
   The mean over 1000 placings scatters from seed to seed by 0.0006
   (measured with 400 seeds); four times that is allowed. To throw only the
   last disk again gives 0.1018, and to keep the first 0.1053. */
static double second_moment(sampler *s, bool *ended)
{
    enum { PLACINGS = 1000 };
    double sum = 0.0;
    source_begin(&four, 603);
    *ended = true;
    for (int sample = 0; sample < PLACINGS && *ended; ++sample) {
        const struct answer a = call(s, &four);
        for (size_t i = 0; i < four.n; ++i)
            sum +=
                pow((a.x[i] - 0.5) / 0.7, 2) + pow((a.y[i] - 0.5) / 0.7, 2);
        *ended = a.ended;
    }
    return sum / (2.0 * 4.0 * PLACINGS);
}

static void test_crowd(void)
{
    bool ended;
    const double expected = 0.1082915, tolerance = 4.0 * 0.0006;
    const double got = second_moment(student, &ended);
    struct check_mistake m = {0};
    for (size_t s = 0; s < 3 && fabs(got - expected) > tolerance; ++s) {
        bool slip_ended;
        current = &slips[s];
        const double slipped = second_moment(with_slip, &slip_ended);
        if (fabs(slipped - got) < 1e-9) {
            m = slips[s].mistake;
            m.value = got;
        }
    }
    CHECK_NEAR(got, .quantity = "mean of ((x - width/2)/0.7 m)^2",
               .input = check_text("1000 placings, %s", input(&four)),
               .expected = expected, .tolerance = tolerance,
               .because = "4 times the scatter of 1000 placings",
               .question =
                   "The disks keep away from the walls more than they "
                   "should. Which placings have most room, and does your "
                   "sampler find them as often as the others?",
               .mistakes = {m});
}

const struct check_suite check_suite = {
    .file = "06a-throw.c",
    .title = "A sampler that keeps what fitted",
    .minutes = 20,
    .equation = "eq:throw",
    .tests = {{"disks that fit at once stay where they fell", test_at_once,
               1, 0},
              {"when two of three overlap, all three are thrown again",
               test_three, 2, 0},
              {"round disks overlap where their edges cross", test_two, 1,
               0},
              {"a new throw may fail as well", test_again, 2, 0},
              {"disks need not be equal, and may touch", test_radii, 1, 0},
              {"a first disk that leaves no room is given up", test_no_room,
               1, 0},
              {"throws that fail leave nothing behind", test_drawn, 2, 2},
              {"a placing is made of the last numbers alone", test_many, 1,
               1},
              {"two disks fit as often as the formula says",
               test_acceptance, 2, 0},
              {"four disks crowd the walls", test_crowd, 1, 0},
              {0}},
    .idle = {test_at_once},
};
