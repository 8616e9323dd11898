/* The suite of exercise 05d, "Pressure from a list of wall hits". */

#include "examiner/check.h"
#include <stdio.h>
#include "call.h"

enum { MOST = 256 };

struct record {
    const char *text; /* what it is, in words */
    double size[2];
    size_t disks;
    double energy, from, until;
    size_t n;
    struct wall_hit hit[MOST + 1];
};

/* What the student's function answers; untouched places read as NaN. Behind
   the list stands a heavy hit that does not belong to it. */
static double answer(const struct record *r, int k)
{
    double z[2] = {CHECK_EMPTY, CHECK_EMPTY};
    struct record q = *r;
    q.hit[r->n] = (struct wall_hit){r->until, LEFT, 1000.0, -10.0};
    wall_z(q.n, q.hit, q.size, q.disks, q.energy, q.from, q.until, z);
    return z[k];
}

static const char *input(const struct record *r)
{
    static const char *const name[] = {[LEFT] = "left",
                                       [RIGHT] = "right",
                                       [BOTTOM] = "bottom",
                                       [TOP] = "top"};
    char list[300] = "";
    size_t used = 0;
    for (size_t i = 0; i < r->n && used < 200; ++i)
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s%s at %g s: %g kg, %g m/s",
                                 i ? "; " : "", name[r->hit[i].wall],
                                 r->hit[i].t, r->hit[i].mass, r->hit[i].v);
    return check_text("%s, box %g m by %g m, N = %zu, energy %g J, from %g "
                      "until %g s; %zu hits: %s%s",
                      r->text, r->size[0], r->size[1], r->disks, r->energy,
                      r->from, r->until, r->n, list,
                      used < 200 ? "" : "; ...");
}

/* ---- the disks, which fly through each other ---- */

/* Puts a hit into the list where it belongs in time. */
static void put(struct record *r, struct wall_hit hit)
{
    size_t i = r->n++;
    for (; i > 0 && r->hit[i - 1].t > hit.t; --i)
        r->hit[i] = r->hit[i - 1];
    r->hit[i] = hit;
}

/* A disk with a free way of `way` along axis k: all its hits up to the time
   `last`; the first after the time `first`, with the velocity v. */
static void to_and_fro(struct record *r, int k, double mass, double way,
                       double first, double v, double last)
{
    for (double t = first; t <= last; t += way / fabs(v), v = -v)
        put(r, (struct wall_hit){t, (enum wall)(2 * k + (v > 0.0 ? 1 : 0)),
                                 mass, v});
}

/* ---- what comes of it, right and wrong ---- */

/* What a hit adds to the sum; and which hits do. */
enum what { MOMENTUM, NO_MASS, SIGNED, ENERGY };
enum which { COUNTED, ALL, NOT_BEFORE, NOT_AFTER, BOTH_ENDS, NEITHER_END };

static bool counts(const struct record *r, double t, enum which which)
{
    switch (which) {
    case ALL: return true;
    case NOT_BEFORE: return t > r->from;
    case NOT_AFTER: return t <= r->until;
    case BOTH_ENDS: return t >= r->from && t <= r->until;
    case NEITHER_END: return t > r->from && t < r->until;
    case COUNTED: break;
    }
    return t > r->from && t <= r->until;
}

static double part(const struct wall_hit *h, enum what what)
{
    switch (what) {
    case NO_MASS: return 2.0 * fabs(h->v);
    case SIGNED: return 2.0 * h->mass * h->v;
    case ENERGY: return 0.5 * h->mass * h->v * h->v;
    case MOMENTUM: break;
    }
    return 2.0 * h->mass * fabs(h->v);
}

static double sum(const struct record *r, int k, enum what what,
                  enum which which)
{
    double s = 0.0;
    for (size_t i = 0; i < r->n; ++i)
        if ((int)r->hit[i].wall / 2 == k && counts(r, r->hit[i].t, which))
            s += part(&r->hit[i], what);
    return s;
}

/* P V / (N kT) from a sum over hits; V / (2 size[1 - k]) is size[k] / 2,
   and N kT the energy. */
static double z_of(const struct record *r, int k, double s)
{
    return 0.5 * s * r->size[k] / (r->until - r->from) / r->energy;
}

static double right(const struct record *r, int k)
{
    return z_of(r, k, sum(r, k, MOMENTUM, COUNTED));
}

static double all_walls(const struct record *r)
{
    const double both =
        sum(r, 0, MOMENTUM, COUNTED) + sum(r, 1, MOMENTUM, COUNTED);
    return both / (2.0 * (r->size[0] + r->size[1])) * r->size[0] *
           r->size[1] / (r->until - r->from) / r->energy;
}

static double first_to_last(const struct record *r, int k)
{
    double first = INFINITY, last = -INFINITY;
    for (size_t i = 0; i < r->n; ++i)
        if (counts(r, r->hit[i].t, COUNTED)) {
            first = fmin(first, r->hit[i].t);
            last = fmax(last, r->hit[i].t);
        }
    return right(r, k) * (r->until - r->from) / (last - first);
}

/* All terms are positive, so that each addition costs half an epsilon at
   most, and so does each of the dozen operations after it. */
static double tolerance(const struct record *r, double expected)
{
    return ((double)r->n + 16.0) * DBL_EPSILON * expected;
}

static const char because[] =
    "an epsilon for each hit, and 16 for the rest";

static const char *name_of(int k)
{
    return k == 0 ? "z[0], from the walls left and right"
                  : "z[1], from the walls at bottom and top";
}

/* ---- the slips: more than a check has room for. Those of the time come
   first: where the time does not matter they are none. ---- */

enum { SLIPS = 20 };

static void slips_of(const struct record *r, int k,
                     struct check_mistake slip[SLIPS])
{
    const double z = right(r, k), n = (double)r->disks;
    const double time = r->until - r->from;
    const struct check_mistake all[SLIPS] = {
        {"all-hits", z_of(r, k, sum(r, k, MOMENTUM, ALL)),
         "All hits of the list were counted. Which of them are in the time "
         "that counts?"},
        {"before-the-time", z_of(r, k, sum(r, k, MOMENTUM, NOT_AFTER)),
         "The hits before the time that counts were counted too. What do "
         "the first seconds still know of the start?"},
        {"after-the-time", z_of(r, k, sum(r, k, MOMENTUM, NOT_BEFORE)),
         "The hits after the end were counted too. How long is the time by "
         "which you divide?"},
        {"time-from-zero", z * time / r->until,
         "You divide by `until`. How long is the time that counts when it "
         "begins later than at 0?"},
        {"first-hit-to-last", first_to_last(r, k),
         "You divide by the time from the first hit to the last one. "
         "Nothing hit a wall before and after these: is that not part of "
         "the time?"},
        {"both-ends", z_of(r, k, sum(r, k, MOMENTUM, BOTH_ENDS)),
         "A hit at the very beginning was counted. In the time before this "
         "one it is counted too, at the end. Which of the two was to have "
         "it?"},
        {"neither-end", z_of(r, k, sum(r, k, MOMENTUM, NEITHER_END)),
         "A hit at the very end was left out. In the time that follows it "
         "is not counted either. Who is to have it?"},
        {"half-the-pressure", 0.5 * z,
         "Half of it. How much momentum does the wall take from a disk "
         "that comes back as fast as it came? Or is your kT twice what it "
         "should be?"},
        {"one-wall-for-two", 2.0 * z,
         "Twice as much. On how many walls did these hits take place, and "
         "how long are they together? Or is your kT half of what it should "
         "be?"},
        {"wrong-length", z * r->size[1 - k] / r->size[k],
         "This divides by the other side of the box. How long is the wall "
         "on the left: as long as the box is wide, or as it is high?"},
        {"force-per-area", z * 2.0 / r->size[k],
         "This divides the force by the area of the box. In the plane, "
         "what does the gas press on?"},
        {"axes-exchanged", right(r, 1 - k),
         "This is the value of the other two walls. Which hits belong to "
         "the wall on the left and on the right?"},
        {"axes-exchanged", right(r, 1 - k) * r->size[1 - k] / r->size[k],
         "The hits of the other two walls give this. Which hits belong to "
         "the wall on the left and on the right?"},
        {"signs-cancel", z_of(r, k, sum(r, k, SIGNED, COUNTED)),
         "Left and right cancel here. In which direction is each wall "
         "pushed, and does that matter for the pressure?"},
        {"all-walls", all_walls(r),
         "This is one value for all four walls. Two were wanted. Which "
         "hits belong to the left and the right wall?"},
        {"number-of-disks", z * n,
         "This is too large by the number of disks. How often does N stand "
         "in P V / (N kT), and how often in kT?"},
        {"one-disk-less", n > 1.0 ? z * (n - 1.0) / n : z,
         "Your kT is that of N - 1 disks. That is right when the total "
         "momentum is fixed. Is it, between walls?"},
        {"three-dimensions", z * 1.5,
         "Your kT is that of a gas in space. How many components of "
         "velocity has a disk in the plane?"},
        {"mass-forgotten", z_of(r, k, sum(r, k, NO_MASS, COUNTED)),
         "Every hit counts here as if the disk had 1 kg. What is the "
         "momentum of a disk?"},
        {"energy-for-momentum", z_of(r, k, sum(r, k, ENERGY, COUNTED)),
         "The energies of the hits are added up here. What is force times "
         "time: an energy, or a momentum?"},
    };
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = all[i];
}

/* One of the two values; the slips are those that explain it. */
static void check_z(const struct record *r, int k, double expected)
{
    const double got = answer(r, k);
    struct check c = {.quantity = name_of(k),
                      .input = input(r),
                      .expected = expected,
                      .tolerance = tolerance(r, expected),
                      .because = because};
    const size_t room = sizeof c.mistakes / sizeof c.mistakes[0];
    struct check_mistake slip[SLIPS];
    size_t used = 0;
    slips_of(r, k, slip);
    for (size_t i = 0; i < SLIPS && used < room; ++i)
        if (fabs(got - slip[i].value) <= 1e-12 * (fabs(got) + expected))
            c.mistakes[used++] = slip[i];
    check_near(got, c);
}

/* One disk of 6 kg and radius 0.5 m, 1 m/s: between walls that are 5 m
   apart it has 4 m to fly, and hits one after 1, 5 and 9 s. */
static struct record along(int k)
{
    struct record r = {.text = "one disk to and fro",
                       .size = {5.0, 5.0},
                       .disks = 1,
                       .energy = 3.0,
                       .until = 11.0};
    r.size[1 - k] = 3.0;
    to_and_fro(&r, k, 6.0, 4.0, 1.0, 1.0, 11.0);
    return r;
}

/* 36 N s in 11 s, on 6 m of wall, and 15 m^2 over 3 J. */
static void test_one_disk(void)
{
    check_ask("Three hits in 11 s, of 6 kg at 1 m/s each: what is the "
              "force on both walls together, and what the pressure?");
    const struct record wide = along(0), high = along(1);
    check_z(&wide, 0, 30.0 / 11.0);
    check_z(&high, 1, 30.0 / 11.0);
}

static void test_other_axis(void)
{
    check_ask(
        "Nothing ever hits these two walls. What is the pressure on them?");
    const struct record wide = along(0), high = along(1);
    check_z(&wide, 1, 0.0);
    check_z(&high, 0, 0.0);
}

/* Three disks of 2 kg in a box of 5 m by 3 m, of radius 0.5 m, without
   regard for each other: along x they have 4 m, along y 2 m. 8 s are whole
   journeys there and back for all of them. */
static struct record three_disks(void)
{
    struct record r = {.text = "three disks",
                       .size = {5.0, 3.0},
                       .disks = 3,
                       .energy = 1.0 + 4.0 + 1.0 + 0.25 + 0.25,
                       .until = 16.0};
    to_and_fro(&r, 0, 2.0, 4.0, 0.7, 1.0, 16.0);
    to_and_fro(&r, 0, 2.0, 4.0, 1.3, -2.0, 16.0);
    to_and_fro(&r, 1, 2.0, 2.0, 0.9, 1.0, 16.0);
    to_and_fro(&r, 1, 2.0, 2.0, 2.1, -0.5, 16.0);
    to_and_fro(&r, 1, 2.0, 2.0, 3.3, 0.5, 16.0);
    return r;
}

/* By hand: along x 2 K_x L / (L - 1 m) / K, and along y likewise. */
static void test_three_disks(void)
{
    const struct record r = three_disks();
    check_ask("Add up what the walls on the left and on the right take. "
              "How long are they, and how long is the time?");
    check_z(&r, 0, 2.0 * 5.0 / 6.5 * 5.0 / 4.0);
    check_ask("Add up what the walls at the bottom and at the top take. "
              "How long are they, and how long is the time?");
    check_z(&r, 1, 2.0 * 1.5 / 6.5 * 3.0 / 2.0);
}

/* Four disks of four masses. */
static struct record mixture(void)
{
    struct record r = {.text = "four disks of four masses",
                       .size = {5.0, 3.0},
                       .disks = 4,
                       .until = 20.0};
    for (int i = 0; i < 4; ++i) {
        const double mass = 0.75 + i, v = 2.1 - 0.4 * i;
        r.energy += 0.5 * mass * (1.0 + 0.49) * v * v;
        to_and_fro(&r, 0, mass, 4.5, 0.3 + 0.4 * i, i % 2 ? v : -v, 20.0);
        to_and_fro(&r, 1, mass, 2.5, 0.1 + 0.3 * i, 0.7 * v, 20.0);
    }
    return r;
}

static void test_masses(void)
{
    const struct record r = mixture();
    check_ask("The disks are of different masses, and fast or slow. What "
              "does each of them give to a wall?");
    check_z(&r, 0, right(&r, 0));
    check_z(&r, 1, right(&r, 1));
}

/* Points that fly as fast across as up are an ideal gas, whatever their
   masses: 12 s are whole journeys for all of them. */
static void test_points(void)
{
    struct record r = {.text = "points of 1, 2 and 5 kg",
                       .size = {6.0, 2.0},
                       .disks = 3,
                       .until = 12.0};
    for (int i = 0; i < 3; ++i) {
        static const double mass[] = {1.0, 2.0, 5.0}, v[] = {3.0, 2.0, 1.0};
        to_and_fro(&r, 0, mass[i], 6.0, 0.5 + 0.1 * i, v[i], 12.0);
        to_and_fro(&r, 1, mass[i], 2.0, 0.2 + 0.1 * i, -v[i], 12.0);
        r.energy += mass[i] * v[i] * v[i];
    }
    for (int k = 0; k < 2; ++k)
        CHECK_NEAR(answer(&r, k), .quantity = name_of(k),
                   .input = input(&r), .expected = 1.0,
                   .tolerance = tolerance(&r, 1.0), .because = because,
                   .question = "Points that never meet are an ideal gas. "
                               "What is P V / (N kT) of that?");
}

static void check_time(struct record r, double from, double until)
{
    r.from = from;
    r.until = until;
    check_z(&r, 0, right(&r, 0));
    check_z(&r, 1, right(&r, 1));
}

static void test_time(void)
{
    check_ask("The list is longer than the time that counts. Which hits "
              "are in that, and how long is it?");
    check_time(mixture(), 4.15, 13.35);
    check_time(mixture(), 6.55, 20.5);
    check_time(mixture(), 0.0, 11.05);
}

/* Hits at 1, 5, 9, 13 and 17 s. */
static void test_ends(void)
{
    struct record r = along(0);
    r.n = 0;
    to_and_fro(&r, 0, 6.0, 4.0, 1.0, 1.0, 19.0);
    check_ask("A hit falls on the beginning or on the end of the time. "
              "Does it count?");
    check_time(r, 5.0, 18.0);
    check_time(r, 2.0, 17.0);
    check_time(r, 1.0, 13.0);
}

/* Time times pressure is a sum over hits, and each hit is in one part. */
static void test_parts(void)
{
    const struct record whole = mixture();
    struct record part = whole;
    double total = 0.0;
    for (int i = 0; i < 8; ++i) {
        part.from = whole.until * i / 8.0;
        part.until = whole.until * (i + 1) / 8.0;
        total += answer(&part, 0) * (part.until - part.from);
    }
    CHECK_NEAR(
        total / whole.until,
        .quantity = "mean of z[0] over eight times that follow each other",
        .input = input(&whole), .expected = right(&whole, 0),
        .tolerance = 8.0 * tolerance(&whole, right(&whole, 0)),
        .because = because,
        .question = "The pressure in a long time is the mean of that in "
                    "its parts. Is every hit in one of them?");
}

/* Disks that fly through each other, with drawn masses, radii and journeys:
   each goes to and fro a whole number of times in the time that counts, and
   the list begins before that and ends after it. No hit is near its ends.
   In a journey of 2 w/|v| a disk gives 4 m |v|, and so with the energy K in
   its motion along an axis of length L it adds 2 K L/w to the sum that is
   divided by the energy of all. */
static struct record draw_disks(double expected[2])
{
    struct record r = {.text = "drawn disks",
                       .size = {check_draw(3.0, 9.0), check_draw(3.0, 9.0)},
                       .disks = (size_t)check_draw_whole(1, 4),
                       .from = check_draw(1.0, 4.0)};
    const double time = check_draw(2.0, 20.0);
    r.until = r.from + time;
    expected[0] = expected[1] = 0.0;
    for (size_t i = 0; i < r.disks; ++i) {
        const double mass = check_draw(0.2, 5.0);
        const double radius = check_draw(0.1, 1.0);
        for (int k = 0; k < 2; ++k) {
            const double way = r.size[k] - 2.0 * radius;
            const int journeys = check_draw_whole(1, 4);
            const double v = 2.0 * journeys * way / time;
            const double wait = check_draw(0.1, 0.9) * way / v;
            const double energy = 0.5 * mass * v * v;
            to_and_fro(&r, k, mass, way, r.from + wait - 2.0 * way / v,
                       check_draw_whole(0, 1) ? v : -v, r.until + way / v);
            r.energy += energy;
            expected[k] += 2.0 * energy * r.size[k] / way;
        }
    }
    for (int k = 0; k < 2; ++k)
        expected[k] /= r.energy;
    return r;
}

CHECK_TIMES(20, test_drawn, i)
{
    check_ask("Each disk makes whole journeys to and fro in the time that "
              "counts. How much does it give in one journey, and how long "
              "does that take?");
    double expected[2];
    const struct record r = draw_disks(expected);
    for (int k = 0; k < 2; ++k)
        check_z(&r, k, expected[k]);
}

static void test_no_hits(void)
{
    const struct record none = {.text = "an empty list",
                                .size = {4.0, 2.0},
                                .disks = 2,
                                .energy = 1.5,
                                .until = 12.0};
    struct record quiet = along(0);
    quiet.from = 5.5;
    quiet.until = 8.5;
    for (int k = 0; k < 2; ++k)
        CHECK_NEAR(answer(&none, k), .quantity = name_of(k),
                   .input = input(&none), .because = "nothing was hit",
                   .question = "Nothing was hit in this time. What is the "
                               "pressure, and was it filled in?",
                   .mistakes = {{"nothing-over-nothing", CHECK_NAN,
                                 "Not a number, and nothing was hit in "
                                 "this time. By what do you divide?"}});
    CHECK_NEAR(
        answer(&quiet, 0), .quantity = name_of(0), .input = input(&quiet),
        .because = "nothing was hit",
        .question =
            "No hit falls into this time. What is the pressure in it?");
}

const struct check_suite check_suite = {
    .file = "05d-pressure.c",
    .title = "Pressure from a list of wall hits",
    .minutes = 25,
    .equation = "eq:wall-pressure",
    .tests =
        {{"one disk presses as worked out by hand", test_one_disk, 2, 0},
         {"it does not press on the other walls", test_other_axis, 1, 0},
         {"three disks press as worked out by hand", test_three_disks, 2,
          0},
         {"heavy and light disks count by their momentum", test_masses, 1,
          0},
         {"points are an ideal gas", test_points, 1, 0},
         {"only the time that counts is counted", test_time, 2, 0},
         {"a hit at the end counts, one at the beginning does not",
          test_ends, 1, 0},
         {"a time is the sum of its parts", test_parts, 1, 0},
         {"whole journeys press as the energy says", test_drawn, 2, 3},
         {"where nothing is hit there is no pressure", test_no_hits, 1, 0},
         {0}},
};
