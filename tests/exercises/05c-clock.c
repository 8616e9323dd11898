/* The suite of exercise 05c: the energy, which sees nothing; one disk in a
   long box, with collisions within a tick, on a tick, several in a tick and
   two at one time; how many samples, and of which times; and four disks: do
   they touch when they collide, is the clock right after a long time, and
   what is the pressure on the walls? */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* ---- the physics that the student's loop calls ---- */

enum { DISKS = 4, KEPT = 64 };

struct box {
    size_t n;
    double length[2], radius;
    double x[DISKS][2], v[DISKS][2];
    /* what is due: disk i meets disk j, or, when j is DISKS or DISKS + 1,
       the wall across the axis j - DISKS */
    size_t i, j;
    /* ---- what the tests look at */
    long double flown; /* time that the disks have flown, s */
    size_t collisions, samples;
    double hit[KEPT];     /* time flown at the first collisions */
    double at[KEPT][2];   /* of disk 0 at the first samples */
    double claimed[KEPT]; /* times of the first samples */
    double tick;
    size_t most;        /* collisions, after which there are none */
    double largest_gap; /* between what collides, m */
    double clock_error; /* of a sample, s: its disks, or its time */
    double last;        /* time of the last sample, s */
    double impulse;     /* given to the walls, masses are 1 kg */
};

double box_next(struct box *b);
void box_fly(struct box *b, double time);
void box_collide(struct box *b);
void box_record(struct box *b, double t);
void box_run(struct box *b, double tick, size_t samples);

typedef void loop(struct box *b, double tick, size_t samples);

static double wall_gap(const struct box *b, size_t i, size_t k)
{
    return b->v[i][k] > 0.0 ? b->length[k] - b->radius - b->x[i][k]
                            : b->x[i][k] - b->radius;
}

static double pair_time(const struct box *b, size_t i, size_t j)
{
    double dd = 0.0, dv = 0.0, vv = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double d = b->x[j][k] - b->x[i][k];
        const double v = b->v[j][k] - b->v[i][k];
        dd += d * d, dv += d * v, vv += v * v;
    }
    const double gap = dd - 4.0 * b->radius * b->radius;
    const double disc = dv * dv - vv * gap;
    if (dv >= 0.0 || disc < 0.0)
        return INFINITY;
    return fmax(0.0, gap) / (sqrt(disc) - dv);
}

static void soonest(struct box *b, double *time, double other, size_t i,
                    size_t j)
{
    if (other < *time) {
        *time = other;
        b->i = i;
        b->j = j;
    }
}

double box_next(struct box *b)
{
    double time = INFINITY;
    for (size_t i = 0; i < b->n && b->collisions < b->most; ++i) {
        for (size_t k = 0; k < 2; ++k)
            if (b->v[i][k] != 0.0)
                soonest(b, &time,
                        fmax(0.0, wall_gap(b, i, k)) / fabs(b->v[i][k]), i,
                        DISKS + k);
        for (size_t j = i + 1; j < b->n; ++j)
            soonest(b, &time, pair_time(b, i, j), i, j);
    }
    return time;
}

void box_fly(struct box *b, double time)
{
    for (size_t i = 0; i < b->n; ++i)
        for (int k = 0; k < 2; ++k)
            b->x[i][k] += b->v[i][k] * time;
    b->flown += time;
}

static double meet_wall(struct box *b, size_t i, size_t k)
{
    const double gap = wall_gap(b, i, k);
    b->impulse += 2.0 * fabs(b->v[i][k]);
    b->v[i][k] = -b->v[i][k];
    return gap;
}

static double meet_disk(struct box *b, size_t i, size_t j)
{
    const double d[2] = {b->x[j][0] - b->x[i][0], b->x[j][1] - b->x[i][1]};
    const double u[2] = {b->v[j][0] - b->v[i][0], b->v[j][1] - b->v[i][1]};
    const double dd = d[0] * d[0] + d[1] * d[1];
    const double share = (d[0] * u[0] + d[1] * u[1]) / dd;
    for (int k = 0; k < 2; ++k) {
        b->v[i][k] += share * d[k];
        b->v[j][k] -= share * d[k];
    }
    return sqrt(dd) - 2.0 * b->radius;
}

void box_collide(struct box *b)
{
    if (b->collisions < KEPT)
        b->hit[b->collisions] = (double)b->flown;
    ++b->collisions;
    const double gap = b->j >= DISKS ? meet_wall(b, b->i, b->j - DISKS)
                                     : meet_disk(b, b->i, b->j);
    b->largest_gap = fmax(b->largest_gap, fabs(gap));
}

void box_record(struct box *b, double t)
{
    const long double due = (long double)(b->samples + 1) * b->tick;
    if (b->samples < KEPT) {
        for (int k = 0; k < 2; ++k)
            b->at[b->samples][k] = b->x[0][k];
        b->claimed[b->samples] = t;
    }
    ++b->samples;
    b->clock_error = fmax(b->clock_error, (double)fabsl(b->flown - due));
    b->clock_error = fmax(b->clock_error, (double)fabsl(t - due));
    b->last = t;
}

/* ---- the slips, each of them a loop ---- */

static void article(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 0; k < samples; ++k) {
        t += tick;
        if (t < event) {
            box_fly(b, tick);
        } else {
            box_fly(b, event - t - tick);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
        box_record(b, t);
    }
}

static void one_tick_back(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 0; k < samples; ++k) {
        t += tick;
        if (t < event) {
            box_fly(b, tick);
        } else {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
        box_record(b, t);
    }
}

static void events_as_samples(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 0; k < samples; ++k) {
        if (t + tick < event) {
            box_fly(b, tick);
            t += tick;
        } else {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
        box_record(b, t);
    }
}

static void clock_restarts(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 0; k < samples;) {
        if (t + tick < event) {
            box_fly(b, tick);
            t += tick;
            box_record(b, t);
            ++k;
        } else {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
    }
}

static void one_a_tick(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 1; k <= samples; ++k) {
        const double sample = (double)k * tick;
        if (event <= sample) {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
        box_fly(b, sample - t);
        t = sample;
        box_record(b, t);
    }
}

static void at_the_tick(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 0; k < samples; ++k) {
        box_fly(b, tick);
        t += tick;
        if (event <= t) {
            box_collide(b);
            event = t + box_next(b);
        }
        box_record(b, t);
    }
}

static void rest_lost(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 1; k <= samples; ++k) {
        const double sample = (double)k * tick;
        if (event > sample)
            box_fly(b, sample - t);
        while (event <= sample) {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = t + box_next(b);
        }
        t = sample;
        box_record(b, t);
    }
}

static void from_the_tick(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 1; k <= samples; ++k) {
        const double sample = (double)k * tick;
        while (event <= sample) {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
            event = sample + box_next(b);
        }
        box_fly(b, sample - t);
        t = sample;
        box_record(b, t);
    }
}

static void mended(struct box *b, double tick, size_t samples)
{
    double t = 0.0, event = box_next(b);
    for (size_t k = 1; k <= samples; ++k) {
        for (; event <= (double)k * tick; event = t + box_next(b)) {
            box_fly(b, event - t);
            box_collide(b);
            t = event;
        }
        box_fly(b, (double)k * tick - t);
        t = (double)k * tick;
        box_record(b, t);
    }
}

static void starts_at_zero(struct box *b, double tick, size_t samples)
{
    box_record(b, 0.0);
    mended(b, tick, samples - 1);
}

static void one_too_many(struct box *b, double tick, size_t samples)
{
    mended(b, tick, samples + 1);
}

static const struct {
    const char *name;
    loop *run;
    const char *hint;
} slips[] = {
    {"two-ticks-back", article,
     "On its way to the collision the disk flies back here, for the time "
     "event - t - tick. Which time belongs to the disks when that line is "
     "reached, and how far is it from there to the event?"},
    {"one-tick-back", one_tick_back,
     "The clock t is a tick ahead of the disks when they are moved to the "
     "event, so that they go back. From which time do they start?"},
    {"collides-at-the-tick", at_the_tick,
     "The collision takes place at the tick after its time, when the disks "
     "are in each other or in the wall. What must come first, the tick or "
     "the collision?"},
    {"one-collision-a-tick", one_a_tick,
     "Two collisions fall into one tick here, and only one takes place in "
     "time. Which statement of C lets any number go by?"},
    {"events-as-samples", events_as_samples,
     "The state is recorded at a collision, too. Who asked for that? At "
     "which times were the samples wanted?"},
    {"clock-restarts", clock_restarts,
     "After a collision the clock starts anew, and the next sample is a "
     "whole tick later. When is the next tick of a clock that takes no "
     "notice of collisions?"},
    {"rest-of-the-tick-lost", rest_lost,
     "After a collision the disks stay where they are until the tick. How "
     "much of the tick is left, and what do they do in it?"},
    {"next-event-from-the-tick", from_the_tick,
     "box_next counts from the time of the disks when it is asked. Which "
     "time was that: the tick, or the collision before it?"},
    {"starts-at-zero", starts_at_zero,
     "The first sample is that of the start, which was not wanted. After "
     "how many ticks is the first one due?"},
    {"one-too-many", one_too_many,
     "One sample more than was wanted. From which number does your loop "
     "count, and to which?"}};

/* A check has room for 8: the first ones, or, where those two have been
   found out already, the last ones. */
enum {
    SLIPS = sizeof slips / sizeof slips[0],
    FIRST = 0,
    LAST = SLIPS - 8
};

/* ---- running, and looking at the run ---- */

static struct box after(struct box b, loop *run, double tick,
                        size_t samples, size_t most)
{
    b.tick = tick;
    b.most = most;
    for (size_t k = 0; k < KEPT; ++k)
        b.hit[k] = b.at[k][0] = b.at[k][1] = b.claimed[k] = NAN;
    run(&b, tick, samples);
    return b;
}

/* Something to look at in a run that is over; which one of several. */
typedef double look(const struct box *b, size_t which);

static double hit(const struct box *b, size_t k)
{
    return b->hit[k];
}

static double across(const struct box *b, size_t k)
{
    return b->at[k][0];
}

static double up(const struct box *b, size_t k)
{
    return b->at[k][1];
}

static double claimed(const struct box *b, size_t k)
{
    return b->claimed[k];
}

static double count(const struct box *b, size_t k)
{
    (void)k;
    return (double)b->samples;
}

static double flown(const struct box *b, size_t k)
{
    (void)k;
    return (double)b->flown;
}

static double gap(const struct box *b, size_t k)
{
    (void)k;
    return b->largest_gap;
}

static double clock_error(const struct box *b, size_t k)
{
    (void)k;
    return b->clock_error;
}

static double energy(const struct box *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < b->n; ++i)
        sum += 0.5 * (b->v[i][0] * b->v[i][0] + b->v[i][1] * b->v[i][1]);
    return sum;
}

/* P V / (N kT) of equal disks in the plane: N kT is the energy, P the
   impulse over the time and all four walls. */
static double pressure(const struct box *b, size_t k)
{
    const double area = b->length[0] * b->length[1];
    const double walls = 2.0 * (b->length[0] + b->length[1]);
    (void)k;
    return b->impulse / (walls * b->last) * area / energy(b);
}

/* A run and what is asked about it. */
struct job {
    const struct box *start;
    const char *disks; /* in words */
    double tick;
    size_t samples;
};

enum { NO_END = 100000000, TIRED = 100000 };

/* What a slip, from number `first` on, makes of the same run. One that
   would never end tires. */
static struct check_mistake mistake(const struct job *j, look *see,
                                    size_t which, size_t slip)
{
    const struct box b =
        after(*j->start, slips[slip].run, j->tick, j->samples, TIRED);
    return (struct check_mistake){slips[slip].name, see(&b, which),
                                  slips[slip].hint};
}

/* Fills in what all checks have in common; and the slips, from number
   `first` on, if they are asked for. */
static bool check(const struct job *j, look *see, size_t which,
                  size_t first, struct check c)
{
    const size_t room = sizeof c.mistakes / sizeof c.mistakes[0];
    const struct box b =
        after(*j->start, box_run, j->tick, j->samples, NO_END);
    const double got = see(&b, which);
    c.input = check_text("%s; tick %g s, %zu samples", j->disks, j->tick,
                         j->samples);
    if (!c.equation)
        c.equation = "eq:disk-clock";
    if (!(fabs(got - c.expected) <= c.tolerance))
        for (size_t i = 0; i < room && first + i < SLIPS; ++i)
            c.mistakes[i] = mistake(j, see, which, first + i);
    return check_near(__FILE__, __LINE__, got, c);
}

/* Ten flights, and each place or time is the sum of what was flown before:
   an epsilon of at most 16 for each. */
static const double few = 160.0 * DBL_EPSILON;
static const char of_few[] = "ten flights of at most 16 m, an epsilon each";

/* One disk in a box of 4 m by 4 m, of radius 0.5 m, at 1 m/s: 0.8 s to the
   right wall, and then 3 s from wall to wall. */
static const struct box lonely = {.n = 1,
                                  .length = {4.0, 4.0},
                                  .radius = 0.5,
                                  .x = {{2.7, 2.0}},
                                  .v = {{1.0, 0.0}}};
static const char lonely_disk[] =
    "one disk of radius 0.5 m at (2.7, 2) m with (1, 0) m/s between walls "
    "at 0 and 4 m";

/* Where it is: unfolded, it comes back every 6 m. */
static double lonely_place(double t)
{
    const double way = fmod(2.2 + t, 6.0);
    return 0.5 + (way > 3.0 ? 6.0 - way : way);
}

static bool check_hit(double tick, size_t samples, size_t which,
                      double expected, const char *question)
{
    const struct job j = {&lonely, lonely_disk, tick, samples};
    return check(&j, hit, which, FIRST,
                 (struct check){.quantity = check_text(
                                    "time that the disk has flown "
                                    "when collision %zu takes place",
                                    which + 1),
                                .unit = "s",
                                .expected = expected,
                                .tolerance = few,
                                .because = of_few,
                                .question = question});
}

static bool check_places(double tick, size_t samples, const char *question)
{
    const struct job j = {&lonely, lonely_disk, tick, samples};
    for (size_t k = 0; k < samples; ++k)
        if (!check(&j, across, k, LAST,
                   (struct check){
                       .quantity =
                           check_text("x of the disk in sample %zu", k + 1),
                       .unit = "m",
                       .expected = lonely_place((double)(k + 1) * tick),
                       .tolerance = few,
                       .because = of_few,
                       .question = question}))
            return false;
    return true;
}

static void test_first(void)
{
    check_hit(
        0.5, 4, 0, 0.8,
        "The wall is 0.8 m ahead. How long has the disk flown when it "
        "collides?");
}

static void test_second(void)
{
    static const char question[] =
        "From wall to wall it is 3 m. Since when has the disk been flying, "
        "and who tells your program when it arrives?";
    (void)(check_hit(0.5, 12, 1, 3.8, question) &&
           check_hit(0.5, 20, 2, 6.8, question));
}

static void test_places(void)
{
    (void)(check_places(
               0.5, 20,
               "Where is the disk at that tick? Draw its path over "
               "time.") &&
           check_places(0.3, 30,
                        "Some ticks fall into a flight, some just "
                        "behind a collision. Where is the disk?"));
}

static void test_several(void)
{
    check_places(7.0, 10,
                 "Two or three collisions fall into each tick. How many "
                 "does your loop let go by?");
}

/* Both walls of a corner at one time; after 0.8 s, and again after 3 s. */
static void test_corner(void)
{
    static const char question[] =
        "The disk runs into the corner: two collisions at one time, one "
        "for each wall. What does box_next say after the first of them?";
    struct box corner = lonely;
    corner.x[0][1] = 2.7;
    corner.v[0][1] = 1.0;
    const struct job j = {&corner,
                          "one disk of radius 0.5 m at (2.7, 2.7) m with "
                          "(1, 1) m/s between walls at 0 and 4 m",
                          0.5, 20};
    for (size_t k = 0; k < j.samples; ++k)
        for (int axis = 0; axis < 2; ++axis)
            if (!check(&j, axis ? up : across, k, LAST,
                       (struct check){.quantity = check_text(
                                          "%s of the disk in sample %zu",
                                          axis ? "y" : "x", k + 1),
                                      .unit = "m",
                                      .expected = lonely_place(
                                          (double)(k + 1) * j.tick),
                                      .tolerance = few,
                                      .because = of_few,
                                      .question = question}))
                return;
}

static void test_times(void)
{
    const struct job j = {&lonely, lonely_disk, 0.5, 20};
    for (size_t k = 0; k < j.samples; ++k)
        if (!check(&j, claimed, k, LAST,
                   (struct check){
                       .quantity = check_text("time of sample %zu", k + 1),
                       .unit = "s",
                       .expected = (double)(k + 1) * j.tick,
                       .tolerance = few,
                       .because = of_few,
                       .question = "A clock ticks, whatever the disks do. "
                                   "When is this tick?"}))
            return;
}

static void test_how_many(void)
{
    const struct job j = {&lonely, lonely_disk, 0.5, 20};
    (void)(check(&j, count, 0, LAST,
                 (struct check){.quantity = "samples recorded",
                                .expected = (double)j.samples,
                                .because = "a number of samples is exact",
                                .question = "How often is box_record "
                                            "called?"}) &&
           check(&j, flown, 0, LAST,
                 (struct check){.quantity = "time flown in the whole run",
                                .unit = "s",
                                .expected = (double)j.samples * j.tick,
                                .tolerance = few,
                                .because = of_few,
                                .question = "The run ends with the last "
                                            "sample. When is that?"}));
}

/* ---- four disks ---- */

/* The four disks of the chapter, radius 0.15 m, in a box of 1 m by 1 m;
   energy 1 J. */
static struct box four(void)
{
    static const double v[DISKS][2] = {
        {0.61, -0.23}, {-0.94, 0.37}, {0.29, 0.83}, {-0.17, -0.71}};
    struct box b = {.n = DISKS, .length = {1.0, 1.0}, .radius = 0.15};
    for (size_t i = 0; i < DISKS; ++i)
        for (int k = 0; k < 2; ++k) {
            b.x[i][k] = (k == 0 ? i % 2 : i / 2) == 0 ? 0.25 : 0.75;
            b.v[i][k] = v[i][k];
        }
    const double scale = sqrt(1.0 / energy(&b));
    for (size_t i = 0; i < DISKS; ++i)
        for (int k = 0; k < 2; ++k)
            b.v[i][k] *= scale;
    return b;
}

static const char four_disks[] =
    "four disks of 1 kg and radius 0.15 m in a box of 1 m by 1 m, energy "
    "1 J";

/* Each collision rounds the energy by a few epsilons, some up, some down;
   there are 16 in a second. */
static void test_energy(void)
{
    const struct box start = four();
    const struct box b = after(start, box_run, 0.01, 10000, NO_END);
    CHECK_NEAR(energy(&b), .quantity = "energy after 100 s", .unit = "J",
               .input = check_text("%s; tick 0.01 s", four_disks),
               .expected = energy(&start), .tolerance = 1e-12,
               .because = "4 epsilons for each of 1600 collisions, with "
                          "room to spare",
               .equation = "eq:energy",
               .question = "This test passes with the wrong clock, and "
                           "should pass with yours. What have you done to "
                           "the velocities?");
}

/* The clock counts to 20 s and is rounded at each flight; the disks are no
   faster than sqrt(2) m/s. */
static void test_contact(void)
{
    const struct box start = four();
    const struct job j = {&start, four_disks, 0.01, 2000};
    check(&j, gap, 0, FIRST,
          (struct check){
              .quantity = "largest distance between two edges that collide",
              .unit = "m",
              .tolerance = 64.0 * DBL_EPSILON * 20.0,
              .because = "a collision follows the last one after a dozen "
                         "flights, each with a rounding of the 20 s",
              .question =
                  "Do things touch when they collide? If not, where "
                  "have the disks been moved to?"});
}

/* As long as the pressure takes, see below. */
enum { TICKS = 200000 };
static const double tick = 0.01;

/* 250000 flights, each with a rounding of a time up to 2000 s. */
static void test_long_clock(void)
{
    const struct box start = four();
    const struct job j = {&start, four_disks, tick, TICKS};
    check(&j, clock_error, 0, LAST,
          (struct check){
              .quantity = "how far a sample is from its tick, by the time "
                          "given or by what the disks have flown, at most",
              .unit = "s",
              .tolerance = 250000.0 * DBL_EPSILON * 2000.0,
              .because = "250000 flights, each with a rounding of 2000 s",
              .question = "Whatever happens in the box, sample number k is "
                          "that of k ticks. What has your clock to do with "
                          "the collisions?"});
}

/* The value is that of placing four disks at random 5e9 times and keeping
   those that fit: the density at the wall, 2.69889 with a standard error of
   0.0003 (measured for this kit). 300 runs of this length with
   other velocities had the mean 2.6981 and the standard deviation 0.0094.
   With two ticks too little the mean was 2.314, with one 2.492. */
static void test_pressure(void)
{
    const struct box start = four();
    const struct job j = {&start, four_disks, tick, TICKS};
    check(&j, pressure, 0, FIRST,
          (struct check){
              .quantity = "P V / (N kT), from the momentum given to the "
                          "walls in 2000 s",
              .expected = 2.69889,
              .tolerance = 0.05,
              .because = "5 standard deviations of runs of this length",
              .equation = "eq:wall-pressure",
              .question = "Do the disks come to the walls as often as they "
                          "should, and do they touch them when they "
                          "collide?"});
}

const struct check_suite check_suite = {
    .exercise = "05c",
    .title = "Mend the clock",
    .minutes = 30,
    .tests =
        {{"the energy is conserved, and with a wrong clock too",
          test_energy, 1, 0},
         {"the first collision takes place at the wall", test_first, 1, 0},
         {"the next ones follow in time", test_second, 1, 0},
         {"the disk is where it is at each tick", test_places, 1, 0},
         {"several collisions fall into one tick", test_several, 1, 0},
         {"two collisions take place at one time", test_corner, 1, 0},
         {"each sample has the time of its tick", test_times, 1, 0},
         {"as many samples are taken as were wanted", test_how_many, 1, 0},
         {"four disks touch whenever they collide", test_contact, 1, 0},
         {"after a long time the clock is right", test_long_clock, 1, 0},
         {"the pressure on the walls is right", test_pressure, 1, 0},
         {0}},
};
