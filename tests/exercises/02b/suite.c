/* The suite of exercise 02b, "A sampler that looks too often". */

#include "examiner/check.h"
#include <stdio.h>

struct event {
    double t, x, v;
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[]);

enum { MOST_EVENTS = 640, MOST_SAMPLES = 100000 };

/* A path and its sampling. */
struct job {
    size_t events;
    const struct event *path;
    double tick;
    size_t samples;
};

/* What the student's function answers; untouched places read as NaN, and
   so do one before the first and one behind the last. */
static const double *answer(const struct job *j)
{
    static double places[MOST_SAMPLES + 2];
    for (size_t k = 0; k < j->samples + 2; ++k)
        places[k] = CHECK_EMPTY;
    sample(j->events, j->path, j->tick, j->samples, places + 1);
    return places + 1;
}

static const char *input(const struct job *j)
{
    char list[300] = "";
    size_t used = 0;
    for (size_t e = 0; e < j->events && used < 240; ++e)
        used += (size_t)snprintf(
            list + used, sizeof list - used, "%s(%.9g s, %.9g m, %g m/s)",
            e ? ", " : "", j->path[e].t, j->path[e].x, j->path[e].v);
    return check_text("tick %.9g s, %zu samples, %zu events: %s%s", j->tick,
                      j->samples, j->events, list,
                      used < 240 ? "" : ", ...");
}

/* The last event that is not later than a time. */
static size_t passed(const struct job *j, double time)
{
    size_t e = 0;
    while (e + 1 < j->events && j->path[e + 1].t <= time)
        ++e;
    return e;
}

static double along(struct event e, double time)
{
    return (double)(e.x + (long double)e.v * ((long double)time - e.t));
}

/* Where the ball is after k ticks. The product of the tick and a whole
   number has at most 53 + 17 digits, of which a long double keeps 64. */
static double place(const struct job *j, size_t k)
{
    const long double time = (long double)k * j->tick;
    const struct event e = j->path[passed(j, (double)time)];
    return (double)(e.x + e.v * (time - e.t));
}

/* The slips, each worked out for the k-th tick. */

static double nearest(const struct job *j, size_t k)
{
    const double time = (double)k * j->tick;
    const size_t e = passed(j, time);
    const bool next =
        e + 1 < j->events && j->path[e + 1].t - time < time - j->path[e].t;
    return j->path[next ? e + 1 : e].x;
}

static double velocity_before(const struct job *j, size_t k)
{
    const double time = (double)k * j->tick;
    const size_t e = passed(j, time);
    struct event last = j->path[e];
    last.v = j->path[e > 0 ? e - 1 : 0].v;
    return along(last, time);
}

static double velocity_after_next(const struct job *j, size_t k)
{
    const double time = (double)k * j->tick;
    const size_t e = passed(j, time);
    return along(j->path[e + 1 < j->events ? e + 1 : e], time);
}

static double from_the_start(const struct job *j, size_t k)
{
    const double time = (double)k * j->tick;
    const struct event e = j->path[passed(j, time)];
    return e.x + e.v * time;
}

static double one_a_tick(const struct job *j, size_t k)
{
    size_t e = 0;
    for (size_t i = 1; i <= k; ++i)
        if (e + 1 < j->events && j->path[e + 1].t <= (double)i * j->tick)
            ++e;
    return along(j->path[e], (double)k * j->tick);
}

static double adds_up(const struct job *j, size_t k)
{
    double time = 0.0;
    for (size_t i = 1; i <= k; ++i)
        time += j->tick;
    return along(j->path[passed(j, time)], time);
}

/* The product of the tick and a number is rounded, by half an epsilon of
   the time; so is the time since the event, the way since then and the
   place. Twice that, for whoever goes another way. */
static double tolerance(const struct job *j, size_t k)
{
    double far = 0.0, fast = 0.0;
    for (size_t e = 0; e < j->events; ++e) {
        far = fmax(far, fabs(j->path[e].x));
        fast = fmax(fast, fabs(j->path[e].v));
    }
    return 4.0 * DBL_EPSILON * (far + fast * (double)k * j->tick);
}

static const char because[] =
    "4 epsilons of the farthest place, and of the way that the fastest "
    "flight would have made since the start";

/* Checks the sample number k, counted from 1: after k ticks. */
static void check_sample(const struct job *j, const double x[], size_t k,
                         double expected)
{
    CHECK_NEAR(
        x[k - 1],
        .quantity = check_text("x[%zu], the place after %zu tick%s", k - 1,
                               k, k == 1 ? "" : "s"),
        .unit = "m", .input = input(j), .expected = expected,
        .tolerance = tolerance(j, k), .because = because,
        .mistakes = {
            {"at-the-events", j->path[k < j->events ? k : j->events - 1].x,
             "This is the place of a collision. The clock asks at its own "
             "times. At which time is this sample wanted, and where in the "
             "path is that?"},
            {"nearest-event", nearest(j, k),
             "This is where the nearest collision took place, and the ball "
             "was there a little earlier or later. How far does it fly in "
             "between?"},
            {"not-flown", j->path[passed(j, (double)k * j->tick)].x,
             "This is where the last flight began. How long has the ball "
             "been flying since, and how fast?"},
            {"velocity-before", velocity_before(j, k),
             "This flight goes on as if the last collision had changed "
             "nothing. From which event on does a velocity hold?"},
            {"velocity-after-the-next", velocity_after_next(j, k),
             "This flight has the velocity that the next collision will "
             "give, though it has not taken place. Which event is the last "
             "before the tick?"},
            {"time-from-the-start", from_the_start(j, k),
             "Free flight takes the time since the event where it began. "
             "Which time did you multiply the velocity by?"},
            {"starts-at-zero", place(j, k - 1),
             "This is the place one tick before. The start was not wanted. "
             "After how many ticks is x[0] due?"},
            {"one-event-a-tick", one_a_tick(j, k),
             "Several collisions can take place between two ticks. How "
             "many of them does your program let go by?"}});
}

static void check_all(struct job j)
{
    const double *x = answer(&j);
    for (size_t k = 1; k <= j.samples; ++k)
        check_sample(&j, x, k, place(&j, k));
}

static void test_several(void)
{
    static const struct event path[] = {{0.0, 1.0, 4.0},
                                        {0.75, 4.0, -8.0},
                                        {1.25, 0.0, 2.0},
                                        {2.25, 2.0, -1.0},
                                        {3.5, 0.75, 3.0}};
    check_ask("Three collisions have taken place before the first tick. "
              "Which flight is the ball on, and since when?");
    check_all((struct job){5, path, 3.0, 1});
}

/* limit: 1 (event) */
static void test_no_collision(void)
{
    static const struct event path[] = {{0.0, 2.0, -0.5}};
    check_ask("Nothing happens to this ball. Where is it after one tick, "
              "where after two?");
    check_all((struct job){1, path, 2.0, 4});
}

/* Two walls; the left one sends the ball off at 3 m/s, the right one at
   1 m/s. */
static const struct event walls[] = {{0.0, 0.0, 3.0},
                                     {2.0, 6.0, -1.0},
                                     {8.0, 0.0, 3.0},
                                     {10.0, 6.0, -1.0},
                                     {16.0, 0.0, 3.0}};

static void test_many_ticks(void)
{
    check_ask("Many ticks fall into one flight. Which of the numbers that "
              "you keep may change from tick to tick, and which may not?");
    check_all((struct job){5, walls, 0.375, 42});
}

static void test_on_a_collision(void)
{
    check_ask("Some ticks fall on a collision. Where is the ball then, "
              "seen from the flight before, and from the one after?");
    check_all((struct job){5, walls, 2.0, 8});
}

static void test_after_the_last(void)
{
    check_ask(
        "The last event is over and the clock goes on. Does the ball stop, "
        "or does your program read an event that is not there?");
    check_all((struct job){2, walls, 1.25, 8});
}

static void check_empty(const struct job *j, double place)
{
    CHECK_NEAR(isnan(place) ? 0.0 : 1.0,
               .quantity = "samples more than were wanted",
               .input = input(j),
               .because = "a number of samples is exact");
}

static void test_how_many(void)
{
    const struct job three = {5, walls, 1.5, 3};
    const struct job none = {5, walls, 1.5, 0};
    const double *x = answer(&three);
    check_ask("Three samples were wanted. Which?");
    for (size_t k = 1; k <= three.samples; ++k)
        check_sample(&three, x, k, place(&three, k));
    check_ask("Something was written behind the last sample. Where does "
              "your loop end?");
    check_empty(&three, x[three.samples]);
    check_ask("Something was written before the first sample. Where does "
              "your loop begin?");
    check_empty(&three, x[-1]);
    check_ask("No sample was wanted here. What did your program write?");
    check_empty(&none, answer(&none)[0]);
}

/* A slow ball is caught between the wall at 10 m and a heavy neighbour at
   9 m for a short while; most of its collisions take place then. It ends
   where it began. */
static const struct event caught[] = {
    {0.0, 0.0, 1.0},     {10.0, 10.0, -8.0},  {10.125, 9.0, 8.0},
    {10.25, 10.0, -8.0}, {10.375, 9.0, 8.0},  {10.5, 10.0, -8.0},
    {10.625, 9.0, 8.0},  {10.75, 10.0, -8.0}, {10.875, 9.0, -1.0},
    {19.875, 0.0, 1.0}};

/* Ticks that end where they began take the average by the trapezium rule.
   It errs only where the velocity jumps, by no more than a jump times the
   tick squared over 8. */
static void test_average(void)
{
    enum { EVENTS = 10, SAMPLES = 300 };
    const double end = caught[EVENTS - 1].t;
    const struct job j = {EVENTS, caught, end / SAMPLES, SAMPLES};
    double area = 0.0, jumps = 0.0, sum = 0.0, at_collisions = 0.0;
    for (size_t e = 1; e < EVENTS; ++e) {
        area += 0.5 * (caught[e - 1].x + caught[e].x) *
                (caught[e].t - caught[e - 1].t);
        jumps += fabs(caught[e].v - caught[e - 1].v);
        at_collisions += caught[e].x / (EVENTS - 1);
    }
    const double *x = answer(&j);
    for (size_t k = 0; k < SAMPLES; ++k)
        sum += x[k];
    CHECK_NEAR(
        sum / SAMPLES, .quantity = "average of all samples", .unit = "m",
        .input = input(&j), .expected = area / end,
        .tolerance = jumps * j.tick * j.tick / (8.0 * end),
        .because = "all jumps of the velocity, times the tick squared over "
                   "8 times the whole time",
        .question = "The average over time is the area under the path. "
                    "Which part of the path have you looked at too often?",
        .mistakes = {{"at-the-events", at_collisions,
                      "This is the average over the collisions, and most "
                      "of them take place in one corner. How much of its "
                      "time does the ball spend there?"}});
}

/* Two walls 30 m apart; the ball has a speed of its own for each way. The
   true place is that within one round, and nothing is summed up. A tick of
   a whole number of ms, but not of 1/8 s, is always rounded. */
static void test_long_run(void)
{
    static struct event path[MOST_EVENTS];
    const double there = check_draw(0.6, 1.5), back = check_draw(0.6, 1.5);
    const double tick = check_draw_whole(101, 124) / 1000.0;
    const long double right = 30.0L / there, left = 30.0L / back;
    struct job j = {0, path, tick, MOST_SAMPLES};
    for (; j.events < MOST_EVENTS; ++j.events) {
        const size_t round = j.events / 2;
        const long double start = round * (right + left);
        path[j.events] =
            j.events % 2
                ? (struct event){(double)(start + right), 30.0, -back}
                : (struct event){(double)start, 0.0, there};
    }
    const double *x = answer(&j);
    for (size_t k = 10000; k <= j.samples; k += 10000) {
        const long double phase =
            fmodl((long double)k * tick, right + left);
        const double true_place =
            (double)(phase < right ? there * phase
                                   : back * (right + left - phase));
        CHECK_NEAR(
            x[k - 1] - true_place,
            .quantity =
                check_text("how far x[%zu] is from the true place", k - 1),
            .unit = "m", .input = input(&j), .tolerance = tolerance(&j, k),
            .because = because,
            .question =
                "All was well for a few ticks, and now it is not. Which of "
                "your numbers remembers the roundings of all ticks before?",
            .mistakes = {
                {"clock-adds-up", adds_up(&j, k) - true_place,
                 "The clock is wrong. tick + tick + tick and so on is "
                 "rounded at each step, and there were many. Which single "
                 "operation gives the time of a tick?"}});
    }
}

/* A path that is walked in steps of 1/64 s, each of them added to the place
   before. Places are whole numbers of 1/512 m, so that nothing is rounded.
 */
enum { MOST_WALKED = 12, MOST_STEPS = 1000 };

struct walk {
    size_t events, steps;
    struct event path[MOST_WALKED];
    double place[MOST_STEPS]; /* after each step, the start first */
};

static struct walk draw_walk(void)
{
    struct walk w = {.events = (size_t)check_draw_whole(1, MOST_WALKED)};
    double place = check_draw_whole(-40, 40) / 8.0;
    for (size_t e = 0; e < w.events; ++e) {
        const double v = check_draw_whole(-40, 40) / 8.0;
        int flight = check_draw_whole(1, 60);
        w.path[e] = (struct event){(double)w.steps / 64.0, place, v};
        if (e + 1 == w.events)
            flight += 200; /* nobody ends it */
        for (; flight > 0; --flight) {
            w.place[w.steps++] = place;
            place += v / 64.0;
        }
    }
    return w;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("This path was walked in small steps. At which of its events "
              "does your ball lose the way?");
    const struct walk w = draw_walk();
    const size_t steps = (size_t)check_draw_whole(1, 90);
    const struct job j = {w.events, w.path, (double)steps / 64.0,
                          (w.steps - 1) / steps};
    const double *x = answer(&j);
    for (size_t k = 1; k <= j.samples; ++k)
        check_sample(&j, x, k, w.place[k * steps]);
}

const struct check_suite check_suite = {
    .file = "02b-sampler.c",
    .title = "A sampler that looks too often",
    .minutes = 20,
    .equation = "eq:clock",
    .tests = {{"after several collisions the ball is on its present flight",
               test_several, 2, 0},
              {"a ball that meets nobody flies on", test_no_collision, 1,
               0},
              {"many ticks fall into one flight", test_many_ticks, 1, 0},
              {"a tick may fall on a collision", test_on_a_collision, 1, 0},
              {"the last flight never ends", test_after_the_last, 1, 0},
              {"as many samples are taken as were wanted", test_how_many, 1,
               0},
              {"the samples have the average of the whole path",
               test_average, 2, 0},
              {"after a hundred thousand ticks the clock is right",
               test_long_run, 2, 1},
              {"forty paths are where somebody who walks them is",
               test_drawn, 1, 2},
              {0}},
};
