/* The suite of exercise 05c, "Mend the clock". */

#include "examiner/check.h"

/* ---- the physics that the student's loop calls: remote.c has it, too,
   and no more of this file ---- */

enum { DISKS = 4 };

/* What a box begins with. */
struct disks {
    size_t n;
    double length[2], radius;
    double x[DISKS][2], v[DISKS][2];
    /* what is due: disk i meets disk j, or, when j is DISKS or DISKS + 1,
       the wall across the axis j - DISKS */
    size_t i, j;
    size_t left;    /* collisions, after which there are none */
    double impulse; /* given to the walls, masses are 1 kg */
};

static double wall_gap(const struct disks *d, size_t i, size_t k)
{
    return d->v[i][k] > 0.0 ? d->length[k] - d->radius - d->x[i][k]
                            : d->x[i][k] - d->radius;
}

static double pair_time(const struct disks *d, size_t i, size_t j)
{
    double rr = 0.0, rv = 0.0, vv = 0.0;
    for (int k = 0; k < 2; ++k) {
        const double r = d->x[j][k] - d->x[i][k];
        const double v = d->v[j][k] - d->v[i][k];
        rr += r * r, rv += r * v, vv += v * v;
    }
    const double gap = rr - 4.0 * d->radius * d->radius;
    const double disc = rv * rv - vv * gap;
    if (rv >= 0.0 || disc < 0.0)
        return INFINITY;
    return fmax(0.0, gap) / (sqrt(disc) - rv);
}

static void soonest(struct disks *d, double *time, double other, size_t i,
                    size_t j)
{
    if (other < *time) {
        *time = other;
        d->i = i;
        d->j = j;
    }
}

/* How long it is to what is due next. */
static inline double disks_next(struct disks *d)
{
    double time = INFINITY;
    for (size_t i = 0; i < d->n && d->left > 0; ++i) {
        for (size_t k = 0; k < 2; ++k)
            if (d->v[i][k] != 0.0)
                soonest(d, &time,
                        fmax(0.0, wall_gap(d, i, k)) / fabs(d->v[i][k]), i,
                        DISKS + k);
        for (size_t j = i + 1; j < d->n; ++j)
            soonest(d, &time, pair_time(d, i, j), i, j);
    }
    return time;
}

static inline void disks_fly(struct disks *d, double time)
{
    for (size_t i = 0; i < d->n; ++i)
        for (int k = 0; k < 2; ++k)
            d->x[i][k] += d->v[i][k] * time;
}

static double meet_wall(struct disks *d, size_t i, size_t k)
{
    const double gap = wall_gap(d, i, k);
    d->impulse += 2.0 * fabs(d->v[i][k]);
    d->v[i][k] = -d->v[i][k];
    return gap;
}

static double meet_disk(struct disks *d, size_t i, size_t j)
{
    const double r[2] = {d->x[j][0] - d->x[i][0], d->x[j][1] - d->x[i][1]};
    const double u[2] = {d->v[j][0] - d->v[i][0], d->v[j][1] - d->v[i][1]};
    const double rr = r[0] * r[0] + r[1] * r[1];
    const double share = (r[0] * u[0] + r[1] * u[1]) / rr;
    for (int k = 0; k < 2; ++k) {
        d->v[i][k] += share * r[k];
        d->v[j][k] -= share * r[k];
    }
    return sqrt(rr) - 2.0 * d->radius;
}

/* What is due; returns the distance between the two edges. */
static inline double disks_collide(struct disks *d)
{
    d->left -= d->left > 0;
    return d->j >= DISKS ? meet_wall(d, d->i, d->j - DISKS)
                         : meet_disk(d, d->i, d->j);
}

#ifndef ONLY_PHYSICS

enum { KEPT = 64 };

struct box {
    struct disks d; /* the first: remote.c wants them */
    /* ---- what the tests look at */
    long double flown; /* time that the disks have flown, s */
    size_t collisions, samples;
    double hit[KEPT];     /* time flown at the first collisions */
    double at[KEPT][2];   /* of disk 0 at the first samples */
    double claimed[KEPT]; /* times of the first samples */
    double tick;
    double largest_gap; /* between what collides, m */
    double clock_error; /* of a sample, s: its disks, or its time */
    double last;        /* time of the last sample, s */
};

void box_run(struct box *b, double tick, size_t samples);

double box_next(struct box *b)
{
    return disks_next(&b->d);
}

void box_fly(struct box *b, double time)
{
    disks_fly(&b->d, time);
    b->flown += time;
}

/* The larger of two errors; one that is not a number is the largest. */
static double worse(double one, double other)
{
    return isnan(one) || other <= one ? one : other;
}

void box_collide(struct box *b)
{
    if (b->collisions < KEPT)
        b->hit[b->collisions] = (double)b->flown;
    ++b->collisions;
    b->largest_gap = worse(b->largest_gap, fabs(disks_collide(&b->d)));
}

void box_record(struct box *b, double t)
{
    const long double due = (long double)(b->samples + 1) * b->tick;
    if (b->samples < KEPT) {
        for (int k = 0; k < 2; ++k)
            b->at[b->samples][k] = b->d.x[0][k];
        b->claimed[b->samples] = t;
    }
    ++b->samples;
    b->clock_error = worse(b->clock_error, (double)fabsl(b->flown - due));
    b->clock_error = worse(b->clock_error, (double)fabsl(t - due));
    b->last = t;
}

/* ---- the slips: two loops with a slip in them ---- */

enum slip {
    TWO_BACK,
    ONE_BACK,
    ASKED_EARLY,
    LATE,
    ONE_A_TICK,
    AT_EVENTS,
    RESTARTS,
    REST_LOST,
    FROM_TICK,
    FROM_ZERO,
    TOO_MANY,
    SLIPS,
    STUDENT = SLIPS /* the student's own loop */
};

/* From the present to the next tick or to the collision, whatever comes
   first; the way to the collision is too short by `lag` ticks. */
static void by_steps(struct box *b, double tick, size_t samples, double lag,
                     bool at_events)
{
    double t = 0.0, event = box_next(b);
    while (b->samples < samples) {
        const bool meets = event <= t + tick;
        box_fly(b, meets ? event - t - lag * tick : tick);
        t = meets ? event : t + tick;
        if (meets) {
            box_collide(b);
            event = t + box_next(b);
        }
        if (at_events || !meets)
            box_record(b, t);
    }
}

/* From tick to tick, up to the last one. */
static void by_ticks(struct box *b, double tick, size_t last,
                     enum slip slip)
{
    const bool late = slip == LATE, once = late || slip == ONE_A_TICK;
    double t = 0.0, event = box_next(b);
    for (double k = 1.0; k <= (double)last; k += 1.0) {
        bool met = false;
        while (event <= k * tick && !(once && met)) {
            const double when = late ? k * tick : event;
            box_fly(b, when - t);
            const double early = slip == ASKED_EARLY ? box_next(b) : 0.0;
            box_collide(b);
            met = true;
            t = when;
            event = (slip == FROM_TICK ? k * tick : t) +
                    (slip == ASKED_EARLY ? early : box_next(b));
        }
        if (slip != REST_LOST || !met)
            box_fly(b, k * tick - t);
        t = k * tick;
        box_record(b, t);
    }
}

static void run(struct box *b, enum slip slip, double tick, size_t samples)
{
    switch (slip) {
    case STUDENT: box_run(b, tick, samples); break;
    case TWO_BACK: by_steps(b, tick, samples, 2.0, true); break;
    case ONE_BACK: by_steps(b, tick, samples, 1.0, true); break;
    case AT_EVENTS: by_steps(b, tick, samples, 0.0, true); break;
    case RESTARTS: by_steps(b, tick, samples, 0.0, false); break;
    case FROM_ZERO:
        box_record(b, 0.0);
        by_ticks(b, tick, samples - 1, slip);
        break;
    case TOO_MANY: by_ticks(b, tick, samples + 1, slip); break;
    default: by_ticks(b, tick, samples, slip);
    }
}

static const struct {
    const char *name, *hint;
} slips[SLIPS] = {
    [TWO_BACK] =
        {"two-ticks-back",
         "On its way to the collision the disk flies back here, for the "
         "time event - t - tick. Which time belongs to the disks when that "
         "line is reached, and how far is it from there to the event?"},
    [ONE_BACK] =
        {"one-tick-back",
         "The clock t is a tick ahead of the disks when they are moved to "
         "the event, so that they go back. From which time do they start?"},
    [ASKED_EARLY] =
        {"asked-before-the-collision",
         "What comes next was asked before this collision had changed the "
         "velocities. Which of the two belongs first?"},
    [LATE] = {"collides-at-the-tick",
              "The collision takes place at the tick after its time, when "
              "the disks are in each other or in the wall. What must come "
              "first, the tick or the collision?"},
    [ONE_A_TICK] =
        {"one-collision-a-tick",
         "Two collisions fall into one tick here, and only one takes place "
         "in time. Which statement of C lets any number go by?"},
    [AT_EVENTS] = {"events-as-samples",
                   "The state is recorded at a collision, too. Who asked "
                   "for that? At which times were the samples wanted?"},
    [RESTARTS] = {"clock-restarts",
                  "After a collision the clock starts anew, and the next "
                  "sample is a whole tick later. When is the next tick of "
                  "a clock that takes no notice of collisions?"},
    [REST_LOST] =
        {"rest-of-the-tick-lost",
         "After a collision the disks stay where they are until the tick. "
         "How much of the tick is left, and what do they do in it?"},
    [FROM_TICK] =
        {"next-event-from-the-tick",
         "box_next counts from the time of the disks when it is asked. "
         "Which time was that: the tick, or the collision before it?"},
    [FROM_ZERO] = {"starts-at-zero",
                   "The first sample is that of the start, which was not "
                   "wanted. After how many ticks is the first one due?"},
    [TOO_MANY] = {"one-too-many",
                  "One sample more than was wanted. From which number does "
                  "your loop count, and to which?"}};

/* The first ones, or, where those two have been found out already, the
   last ones. */
enum { FIRST = 0, LAST = SLIPS - 8 };

/* ---- running, and looking at the run ---- */

static struct box after(struct box b, enum slip slip, double tick,
                        size_t samples, size_t most)
{
    b.tick = tick;
    b.d.left = most;
    for (size_t k = 0; k < KEPT; ++k)
        b.hit[k] = b.at[k][0] = b.at[k][1] = b.claimed[k] = NAN;
    run(&b, slip, tick, samples);
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
    for (size_t i = 0; i < b->d.n; ++i)
        sum += 0.5 *
               (b->d.v[i][0] * b->d.v[i][0] + b->d.v[i][1] * b->d.v[i][1]);
    return sum;
}

/* P V / (N kT) of equal disks in the plane: N kT is the energy, P the
   impulse over the time and all four walls. */
static double pressure(const struct box *b, size_t k)
{
    const double area = b->d.length[0] * b->d.length[1];
    const double walls = 2.0 * (b->d.length[0] + b->d.length[1]);
    (void)k;
    return b->d.impulse / (walls * b->last) * area / energy(b);
}

/* A run and what is asked about it. */
struct job {
    const struct box *start;
    const char *disks; /* in words */
    double tick;
    size_t samples;
};

enum { NO_END = 100000000, TIRED = 100000 };

/* What a slip makes of the same run. One that would never end tires. It
   does not explain a sample of another time. */
static struct check_mistake mistake(const struct job *j, look *see,
                                    size_t which, size_t slip,
                                    const struct box *student)
{
    const struct box b =
        after(*j->start, (enum slip)slip, j->tick, j->samples, TIRED);
    const bool other =
        (see == across || see == up) &&
        !(fabs(b.claimed[which] - student->claimed[which]) < 1e-9);
    return (struct check_mistake){slips[slip].name,
                                  other ? -INFINITY : see(&b, which),
                                  slips[slip].hint};
}

/* Fills in what all checks have in common; and the slips, from number
   `first` on, if they are asked for. */
static void check(const struct job *j, look *see, size_t which,
                  size_t first, struct check c)
{
    const size_t room = sizeof c.mistakes / sizeof c.mistakes[0];
    const struct box b =
        after(*j->start, STUDENT, j->tick, j->samples, NO_END);
    const double got = see(&b, which);
    c.input = check_text("%s; tick %g s, %zu samples", j->disks, j->tick,
                         j->samples);
    if (!(fabs(got - c.expected) <= c.tolerance))
        for (size_t i = 0; i < room && first + i < SLIPS; ++i)
            c.mistakes[i] = mistake(j, see, which, first + i, &b);
    check_near(got, c);
}

#define CHECK_SEEN(j, see, which, first, ...)                              \
    check(j, see, which, first, (struct check){__VA_ARGS__})

/* Ten flights, and each place or time is the sum of what was flown before:
   an epsilon of at most 16 for each. */
static const double few = 160.0 * DBL_EPSILON;
static const char of_few[] = "ten flights of at most 16 m, an epsilon each";

/* One disk in a box of 4 m by 4 m, of radius 0.5 m, at 1 m/s: 0.8 s to the
   right wall, and then 3 s from wall to wall. */
static const struct box lonely = {.d = {.n = 1,
                                        .length = {4.0, 4.0},
                                        .radius = 0.5,
                                        .x = {{2.7, 2.0}},
                                        .v = {{1.0, 0.0}}}};
static const char lonely_disk[] =
    "one disk of radius 0.5 m at (2.7, 2) m with (1, 0) m/s between walls "
    "at 0 and 4 m";

/* Where it is: unfolded, it comes back every 6 m. */
static double lonely_place(double t)
{
    const double way = fmod(2.2 + t, 6.0);
    return 0.5 + (way > 3.0 ? 6.0 - way : way);
}

static void check_hit(double tick, size_t samples, size_t which,
                      double expected)
{
    const struct job j = {&lonely, lonely_disk, tick, samples};
    CHECK_SEEN(
        &j, hit, which, FIRST,
        .quantity = check_text(
            "time that the disk has flown when collision %zu takes place",
            which + 1),
        .unit = "s", .expected = expected, .tolerance = few,
        .because = of_few);
}

static void check_places(double tick, size_t samples)
{
    const struct job j = {&lonely, lonely_disk, tick, samples};
    for (size_t k = 0; k < samples; ++k)
        CHECK_SEEN(
            &j, across, k, LAST,
            .quantity = check_text("x of the disk in sample %zu", k + 1),
            .unit = "m", .expected = lonely_place((double)(k + 1) * tick),
            .tolerance = few, .because = of_few);
}

static void test_first(void)
{
    check_ask("The wall is 0.8 m ahead. How long has the disk flown when "
              "it collides?");
    check_hit(0.5, 4, 0, 0.8);
}

static void test_second(void)
{
    check_ask("From wall to wall it is 3 m. Since when has the disk been "
              "flying, and who tells your program when it arrives?");
    check_hit(0.5, 12, 1, 3.8);
    check_hit(0.5, 20, 2, 6.8);
}

static void test_places(void)
{
    check_ask("Where is the disk at that tick? Draw its path over time.");
    check_places(0.5, 20);
    check_ask("Some ticks fall into a flight, some just behind a "
              "collision. Where is the disk?");
    check_places(0.3, 30);
}

static void test_several(void)
{
    check_ask("Two or three collisions fall into one tick. How many does "
              "your loop let go by?");
    check_places(3.5, 20);
    check_places(7.0, 10);
}

/* Both walls of a corner at one time; after 0.8 s, and again after 3 s. */
static void test_corner(void)
{
    struct box corner = lonely;
    corner.d.x[0][1] = 2.7;
    corner.d.v[0][1] = 1.0;
    const struct job j = {&corner,
                          "one disk of radius 0.5 m at (2.7, 2.7) m with "
                          "(1, 1) m/s between walls at 0 and 4 m",
                          0.5, 20};
    for (size_t k = 0; k < j.samples; ++k)
        for (int axis = 0; axis < 2; ++axis)
            CHECK_SEEN(
                &j, axis ? up : across, k, LAST,
                .quantity = check_text("%s of the disk in sample %zu",
                                       axis ? "y" : "x", k + 1),
                .unit = "m",
                .expected = lonely_place((double)(k + 1) * j.tick),
                .tolerance = few, .because = of_few,
                .question = "The disk runs into the corner: two collisions "
                            "at one time, one for each wall. What does "
                            "box_next say after the first of them?");
}

static void test_times(void)
{
    const struct job j = {&lonely, lonely_disk, 0.5, 20};
    for (size_t k = 0; k < j.samples; ++k)
        CHECK_SEEN(
            &j, claimed, k, LAST,
            .quantity = check_text("time of sample %zu", k + 1),
            .unit = "s", .expected = (double)(k + 1) * j.tick,
            .tolerance = few, .because = of_few,
            .question =
                "A clock ticks, whatever the disks do. When is this tick?");
}

static void test_how_many(void)
{
    const struct job j = {&lonely, lonely_disk, 0.5, 20};
    CHECK_SEEN(&j, count, 0, LAST, .quantity = "samples recorded",
               .expected = (double)j.samples,
               .because = "a number of samples is exact",
               .question = "How often is box_record called?");
    CHECK_SEEN(
        &j, flown, 0, LAST, .quantity = "time flown in the whole run",
        .unit = "s", .expected = (double)j.samples * j.tick,
        .tolerance = few, .because = of_few,
        .question = "The run ends with the last sample. When is that?");
}

/* ---- one disk, with drawn numbers ---- */

/* Some of these are drawn, here and by a lecturer's further tests. */
struct alone {
    double length[2], radius, x[2], v[2], tick;
    size_t samples;
};

/* Unfolded, a disk that runs between two walls flies straight on: it is
   back after twice the free way. */
static double unfolded(const struct alone *a, int k, double t)
{
    const double free = a->length[k] - 2.0 * a->radius;
    const double way = a->x[k] - a->radius + a->v[k] * t;
    const double there = fabs(remainder(way, 2.0 * free));
    return a->radius + there;
}

/* Each flight rounds a time and a place by half an epsilon. There are as
   many as samples and collisions. */
static double alone_tolerance(const struct alone *a, int k)
{
    const double last = (double)a->samples * a->tick;
    double flights = (double)a->samples + 2.0;
    for (int i = 0; i < 2; ++i)
        flights += fabs(a->v[i]) * last / (a->length[i] - 2.0 * a->radius);
    return 2.0 * DBL_EPSILON * flights *
           (a->length[k] + fabs(a->v[k]) * last);
}

static struct box alone_box(const struct alone *a)
{
    struct box b = {.d = {.n = 1, .radius = a->radius}};
    for (int k = 0; k < 2; ++k) {
        b.d.length[k] = a->length[k];
        b.d.x[0][k] = a->x[k];
        b.d.v[0][k] = a->v[k];
    }
    return b;
}

static const char *alone_text(const struct alone *a)
{
    return check_text("one disk of radius %g m at (%g, %g) m with (%g, %g) "
                      "m/s, box %g m by %g m",
                      a->radius, a->x[0], a->x[1], a->v[0], a->v[1],
                      a->length[0], a->length[1]);
}

/* Where it is in sample `which`, along axis k. */
static void alone_place(const struct alone *a, const struct box *b,
                        size_t which, int k)
{
    const double expected = unfolded(a, k, (double)(which + 1) * a->tick);
    const double tolerance = alone_tolerance(a, k);
    const struct box start = alone_box(a);
    const struct job j = {&start, alone_text(a), a->tick, a->samples};
    if (fabs(b->at[which][k] - expected) <= tolerance)
        return;
    CHECK_SEEN(
        &j, k ? up : across, which, LAST,
        .quantity = check_text("%s of the disk in sample %zu",
                               k ? "y" : "x", which + 1),
        .unit = "m", .expected = expected, .tolerance = tolerance,
        .because =
            "2 epsilons of the size and of the way, for each flight");
}

/* All samples of one disk, KEPT at most, and how long it has flown. */
void clock_check_alone(const struct alone *a)
{
    const struct box start = alone_box(a);
    const struct job j = {&start, alone_text(a), a->tick, a->samples};
    const struct box b = after(start, STUDENT, a->tick, a->samples, NO_END);
    const double last = (double)a->samples * a->tick;
    for (size_t i = 0; i < a->samples; ++i)
        for (int k = 0; k < 2; ++k)
            alone_place(a, &b, i, k);
    CHECK_SEEN(&j, flown, 0, LAST,
               .quantity = "time flown in the whole run", .unit = "s",
               .expected = last,
               .tolerance =
                   alone_tolerance(a, 0) / a->length[0] * last + few * last,
               .because = "2 epsilons of it for each flight");
}

/* Long and short flights, and ticks with many collisions or none. */
static struct alone draw_alone(void)
{
    struct alone a = {.radius = check_draw(0.1, 0.8),
                      .tick = check_draw(0.05, 2.5),
                      .samples = (size_t)check_draw_whole(20, 40)};
    for (int k = 0; k < 2; ++k) {
        a.length[k] = check_draw(2.0, 9.0);
        a.x[k] = check_draw(0.85, a.length[k] - 0.85);
        a.v[k] = check_draw(0.3, 3.0) * (check_draw_whole(0, 1) ? 1 : -1);
    }
    return a;
}

CHECK_TIMES(20, test_alone, i)
{
    const struct alone a = draw_alone();
    check_ask("Fold the plane at the walls, and the disk flies straight "
              "on. Where is it at this tick?");
    clock_check_alone(&a);
}

/* ---- four disks ---- */

/* The four disks of the chapter, radius 0.15 m, in a box of 1 m by 1 m;
   energy 1 J. */
static struct box four(void)
{
    static const double v[DISKS][2] = {
        {0.61, -0.23}, {-0.94, 0.37}, {0.29, 0.83}, {-0.17, -0.71}};
    struct box b = {
        .d = {.n = DISKS, .length = {1.0, 1.0}, .radius = 0.15}};
    for (size_t i = 0; i < DISKS; ++i)
        for (int k = 0; k < 2; ++k) {
            b.d.x[i][k] = (k == 0 ? i % 2 : i / 2) == 0 ? 0.25 : 0.75;
            b.d.v[i][k] = v[i][k];
        }
    const double scale = sqrt(1.0 / energy(&b));
    for (size_t i = 0; i < DISKS; ++i)
        for (int k = 0; k < 2; ++k)
            b.d.v[i][k] *= scale;
    return b;
}

static const char four_disks[] = "four disks of 1 kg and radius 0.15 m in "
                                 "a box of 1 m by 1 m, energy 1 J";

/* Each collision rounds the energy by a few epsilons, some up, some down;
   there are 16 in a second. */
static void test_energy(void)
{
    const struct box start = four();
    const struct box b = after(start, STUDENT, 0.01, 10000, NO_END);
    CHECK_NEAR(
        energy(&b), .quantity = "energy after 100 s", .unit = "J",
        .input = check_text("%s; tick 0.01 s", four_disks),
        .expected = energy(&start), .tolerance = 1e-12,
        .because =
            "4 epsilons for each of 1600 collisions, with room to spare",
        .equation = "eq:energy",
        .question =
            "This test passes with the wrong clock, and should pass with "
            "yours. What have you done to the velocities?");
}

static void check_contact(const struct box *start, const char *disks,
                          size_t samples, const char *because)
{
    const struct job j = {start, disks, 0.01, samples};
    CHECK_SEEN(&j, gap, 0, FIRST,
               .quantity =
                   "largest distance between two edges that collide",
               .unit = "m", .tolerance = 64.0 * DBL_EPSILON * 20.0,
               .because = because,
               .question = "Do things touch when they collide? If not, "
                           "where have the disks been moved to?");
}

/* The clock counts to 20 s and is rounded at each flight; the disks are no
   faster than sqrt(2) m/s. */
static void test_contact(void)
{
    const struct box start = four();
    check_contact(&start, four_disks, 2000,
                  "a collision follows the last one after a dozen flights, "
                  "each with a rounding of the 20 s");
}

/* Only 2 s: slow disks make more flights between two collisions, but each
   has a tenth of the rounding of 20 s. */
CHECK_TIMES(5, test_any_four, i)
{
    struct box start = four();
    const char *text = "four disks, radius 0.15 m, in a box of 1 m by 1 m, "
                       "velocities in m/s:";
    for (size_t d = 0; d < DISKS; ++d) {
        for (int k = 0; k < 2; ++k)
            start.d.v[d][k] = check_draw(-1.0, 1.0);
        text = check_text("%s (%g, %g)", text, start.d.v[d][0],
                          start.d.v[d][1]);
    }
    const struct job j = {&start, text, 0.01, 200};
    check_contact(&start, text, 200,
                  "a hundred flights, each with a rounding of the 2 s, and "
                  "room to spare");
    CHECK_SEEN(
        &j, clock_error, 0, LAST,
        .quantity = "how far a sample is from its tick, at most",
        .unit = "s", .tolerance = 1000.0 * DBL_EPSILON * 2.0,
        .because = "1000 flights, each with a rounding of 2 s",
        .question =
            "Whatever happens in the box, sample number k is that of k "
            "ticks. What has your clock to do with the collisions?");
}

/* As long as the pressure takes, see below. */
enum { TICKS = 25000 };
static const double tick = 0.02;

/* 40000 flights, each with a rounding of a time up to 500 s. */
static void test_long_clock(void)
{
    const struct box start = four();
    const struct job j = {&start, four_disks, tick, TICKS};
    CHECK_SEEN(
        &j, clock_error, 0, LAST,
        .quantity = "how far a sample is from its tick, by the time given "
                    "or by what the disks have flown, at most",
        .unit = "s", .tolerance = 40000.0 * DBL_EPSILON * 500.0,
        .because = "40000 flights, each with a rounding of 500 s",
        .question =
            "Whatever happens in the box, sample number k is that of k "
            "ticks. What has your clock to do with the collisions?");
}

/* The value is that of placing four disks at random 5e9 times and keeping
   those that fit: the density at the wall, 2.69889 with a standard error of
   0.0003 (measured for this kit). 200 runs of this length with
   other velocities had the mean 2.6988 and the standard deviation 0.018.
   With two ticks too little it was 2.03, with one 2.32. */
static void test_pressure(void)
{
    const struct box start = four();
    const struct job j = {&start, four_disks, tick, TICKS};
    CHECK_SEEN(
        &j, pressure, 0, FIRST,
        .quantity =
            "P V / (N kT), from the momentum given to the walls in 500 s",
        .expected = 2.69889, .tolerance = 0.09,
        .because = "5 standard deviations of runs of this length",
        .equation = "eq:wall-pressure",
        .question = "Do the disks come to the walls as often as they "
                    "should, and do they touch them when they collide?");
}

const struct check_suite check_suite = {
    .file = "05c-clock.c",
    .title = "Mend the clock",
    .minutes = 30,
    .equation = "eq:disk-clock",
    .tests =
        {{"the energy is conserved, and with a wrong clock too",
          test_energy, 1, 0},
         {"the first collision takes place at the wall", test_first, 1, 0},
         {"the next ones follow in time", test_second, 1, 0},
         {"the disk is where it is at each tick", test_places, 2, 0},
         {"several collisions fall into one tick", test_several, 2, 0},
         {"two collisions take place at one time", test_corner, 1, 0},
         {"each sample has the time of its tick", test_times, 1, 0},
         {"as many samples are taken as were wanted", test_how_many, 1, 0},
         {"four disks touch whenever they collide", test_contact, 1, 0},
         {"in any box a disk is where its straight way is folded to",
          test_alone, 2, 2},
         {"any four disks touch when they collide, and keep the clock",
          test_any_four, 1, 2},
         {"after a long time the clock is right", test_long_clock, 1, 0},
         {"the pressure on the walls is right", test_pressure, 1, 0},
         {0}},
    .idle = {test_energy, test_how_many, test_contact, test_any_four,
             test_long_clock},
};

#endif
