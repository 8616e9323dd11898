/* The suite of exercise 02a, "The next collision on a ring". */

#include "examiner/check.h"
#include <stdio.h>
#include "call.h"

enum { MOST = 8 };

struct ring {
    size_t n;
    double length;
    double x[MOST], v[MOST];
};

#define RING(...) ((struct ring){__VA_ARGS__})

/* What the student's function answers; an untouched place reads as NaN. */
struct answer {
    double time, left;
};

static struct answer answer(const struct ring *r)
{
    const size_t untouched = (size_t)-1;
    size_t left = untouched;
    struct answer a;
    a.time = next_meeting(r->n, r->length, r->x, r->v, &left);
    a.left = left == untouched ? CHECK_EMPTY : (double)left;
    return a;
}

static const char *input(const struct ring *r)
{
    char list[400] = "";
    size_t used = 0;
    for (size_t i = 0; i < r->n && used < sizeof list; ++i)
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s%.17g m (%g m/s)", i ? ", " : "",
                                 r->x[i], r->v[i]);
    return check_text("ring of %g m, beads at %s", r->length, list);
}

static double gap(const struct ring *r, size_t i)
{
    return i + 1 < r->n ? r->x[i + 1] - r->x[i]
                        : r->x[0] + r->length - r->x[i];
}

static double approach(const struct ring *r, size_t i)
{
    return r->v[i] - r->v[(i + 1) % r->n];
}

/* The pair that meets first, found by looking at them all. */
static size_t first_pair(const struct ring *r)
{
    size_t first = r->n;
    double soonest = INFINITY;
    for (size_t i = r->n; i-- > 0;) {
        const double time = fmax(0.0, gap(r, i)) / approach(r, i);
        if (approach(r, i) > 0.0 && time <= soonest) {
            soonest = time;
            first = i;
        }
    }
    return first;
}

/* The slips, each worked out for the ring at hand: the time that a slip
   gives a pair, or INFINITY where it sees no meeting. */

static double no_seam(const struct ring *r, size_t i)
{
    return i + 1 < r->n && approach(r, i) > 0.0
               ? fmax(0.0, gap(r, i)) / approach(r, i)
               : INFINITY;
}

static double seam_without_length(const struct ring *r, size_t i)
{
    const double way = i + 1 < r->n ? gap(r, i) : gap(r, i) - r->length;
    return approach(r, i) > 0.0 ? fmax(0.0, way) / approach(r, i)
                                : INFINITY;
}

static double without_sign(const struct ring *r, size_t i)
{
    return fmax(0.0, gap(r, i)) / fabs(approach(r, i));
}

static double untested(const struct ring *r, size_t i)
{
    return gap(r, i) / approach(r, i);
}

static double at_rest(const struct ring *r, size_t i)
{
    return r->v[i] > 0.0 ? fmax(0.0, gap(r, i)) / r->v[i] : INFINITY;
}

static double touching(const struct ring *r, size_t i)
{
    if (gap(r, i) <= 0.0)
        return 0.0;
    return approach(r, i) > 0.0 ? gap(r, i) / approach(r, i) : INFINITY;
}

static double in_the_past(const struct ring *r, size_t i)
{
    return approach(r, i) > 0.0 ? gap(r, i) / approach(r, i) : INFINITY;
}

static double skipped(const struct ring *r, size_t i)
{
    return gap(r, i) >= 0.0 ? in_the_past(r, i) : INFINITY;
}

static double soonest(const struct ring *r,
                      double (*slip)(const struct ring *, size_t))
{
    double time = INFINITY;
    for (size_t i = 0; i < r->n; ++i)
        time = fmin(time, slip(r, i));
    return time;
}

/* A gap is the difference of numbers up to the length, a velocity of
   approach that of two velocities; each is rounded once, and so is their
   ratio. Twice that, for whoever goes another way. */
static double tolerance(const struct ring *r, size_t i, double time)
{
    if (!(time > 0.0) || !(time < INFINITY))
        return 0.0;
    const double fast = fabs(r->v[i]) + fabs(r->v[(i + 1) % r->n]);
    return 2.0 * DBL_EPSILON *
           (time + (2.0 * r->length + time * fast) / approach(r, i));
}

static const char because[] =
    "the rounding of the gap and of the speed of approach, twice";

static void check_time(const struct ring *r, double expected)
{
    CHECK_NEAR(
        answer(r).time, .quantity = "time until two beads meet",
        .unit = "s", .input = input(r), .expected = expected,
        .tolerance = tolerance(r, first_pair(r), expected),
        .because = because,
        .mistakes = {
            {"time-in-the-past", soonest(r, in_the_past),
             "The meeting of a pair that approaches would be in the past: "
             "a rounding has put it in the wrong order. Can the program go "
             "back to it? When can it still take place?"},
            {"wrong-order-ignored", soonest(r, skipped),
             "One pair approaches and stands in the wrong order already. "
             "Who will ever make these two collide if they are left out "
             "now?"},
            {"touching-is-meeting", soonest(r, touching),
             "Two beads touch here, or nearly, and do not approach. If "
             "they have just collided, what would your program do with "
             "them next, and after that?"},
            {"seam-forgotten", soonest(r, no_seam),
             "There are as many pairs of neighbours as beads. Whom does "
             "the last bead run into?"},
            {"seam-without-length", soonest(r, seam_without_length),
             "Across the seam the way is not x[0] - x[n - 1], which is "
             "negative. How far is it round to bead 0?"},
            {"parting-pairs-meet", soonest(r, without_sign),
             "The two beads of one pair go away from each other, and were "
             "taken for a pair that approaches. Which sign tells them "
             "apart?"},
            {"past-meeting", soonest(r, untested),
             "A pair that goes apart has met in the past, at a negative "
             "time, and that is not the next meeting. Which pairs are to "
             "be left out?"},
            {"neighbour-at-rest", soonest(r, at_rest),
             "That would be right if the bead in front stood still. How "
             "fast does the gap between the two shrink?"}});
}

static void check_left(const struct ring *r, size_t expected)
{
    const double time = fmax(0.0, gap(r, expected)) / approach(r, expected);
    size_t last = expected;
    for (size_t i = expected; i < r->n; ++i)
        if (approach(r, i) > 0.0 &&
            fmax(0.0, gap(r, i)) / approach(r, i) == time)
            last = i;
    CHECK_NEAR(
        answer(r).left, .quantity = "*left, the left one of the two",
        .input = input(r), .expected = (double)expected,
        .because = "a number of a bead is exact",
        .mistakes = {{"last-of-a-tie", (double)last,
                      "Several pairs meet at this time. Which of them was "
                      "wanted, and which one does your comparison keep?"},
                     {"right-partner", (double)((expected + 1) % r->n),
                      "This is the right one of the two that meet. Which "
                      "one runs into its right neighbour?"}});
}

static void check_both(struct ring r, double time, size_t left)
{
    check_time(&r, time);
    check_left(&r, left);
}

static void check_never(struct ring r)
{
    check_time(&r, INFINITY);
}

static void test_two(void)
{
    check_ask("The beads are 4 m apart and approach at 2 m/s. What do you "
              "do with these two numbers?");
    check_both(RING(2, 10.0, {3.0, 7.0}, {1.0, -1.0}), 2.0, 0);
}

static void test_three(void)
{
    check_ask("Every pair has its own time. Which is the smallest, and "
              "whose is it?");
    check_both(RING(3, 20.0, {1.0, 7.0, 11.0}, {1.0, 0.0, -2.0}), 2.0, 1);
    check_both(RING(3, 20.0, {1.0, 5.0, 11.0}, {3.0, 1.0, -1.0}), 2.0, 0);
}

static void test_never(void)
{
    check_ask("All beads move alike, so no gap ever changes. What was to "
              "be returned then, and what came of your division?");
    check_never(RING(3, 6.0, {0.0, 2.0, 3.0}, {0}));
    check_never(RING(3, 6.0, {0.5, 2.0, 2.0}, {-3, -3, -3}));
    check_ask("A bead alone on the ring: can it run into itself?");
    check_never(RING(1, 6.0, {4.0}, {2.5}));
}

static void test_seam(void)
{
    check_ask("The last bead runs towards the seam, and bead 0 comes up to "
              "it from the other side. How far apart are the two?");
    check_both(RING(3, 10.0, {1.0, 4.0, 8.0}, {-1.0, -1.5, 2.0}), 1.0, 2);
    check_both(RING(3, 10.0, {0.0, 1.0, 9.5}, {0, 0, 2.0}), 0.25, 2);
}

/* limit: 1 (bead, and two, each of which is the other's right neighbour) */
/* Two that touch and part meet behind their backs; two that touch and press
   on each other meet now; and so do two in the wrong order by a rounding.
   At rest, as seen from each other, they never meet. */
static void check_two(const char *question)
{
    const double hair = 4.0 * DBL_EPSILON;
    const struct ring back = {2, 10.0, {3.0, 3.0}, {-1.0, 1.0}};
    CHECK_NEAR(answer(&back).time, .quantity = "time until two beads meet",
               .unit = "s", .input = input(&back), .expected = 5.0,
               .tolerance = tolerance(&back, 1, 5.0), .because = because,
               .question = question,
               .mistakes = {{"one-pair-of-two", INFINITY,
                             "Bead 0 and bead 1 touch and part, and these "
                             "are all there are. Whom does each of them "
                             "run into, on the other side of the ring?"}});
    check_ask(question);
    check_both(back, 5.0, 1);
    check_both(RING(2, 10.0, {3.0, 3.0}, {1.0, -1.0}), 0.0, 0);
    check_both(RING(2, 10.0, {3.0 + hair, 3.0}, {-1.0, 1.0}), 5.0, 1);
    check_both(RING(2, 10.0, {3.0 + hair, 3.0}, {2.0, -1.0}), 0.0, 0);
    check_both(RING(2, 10.0, {0.0, 9.5}, {-1.0, 1.0}), 0.25, 1);
    check_ask("The two touch and move alike. Does that make them meet?");
    check_never(RING(2, 10.0, {3.0, 3.0}, {2.0, 2.0}));
}

static void test_both_ways(void)
{
    static const char question[] =
        "Two beads on a ring meet between them or behind their backs. Who "
        "is whose right neighbour here?";
    check_ask(question);
    check_both(RING(2, 10.0, {2.0, 6.0}, {-1.0, 1.0}), 3.0, 1);
    check_both(RING(2, 10.0, {2.0, 6.0}, {3.0, 1.0}), 2.0, 0);
    check_both(RING(2, 10.0, {2.0, 6.0}, {1.0, 3.0}), 3.0, 1);
    check_two(question);
}

static void test_catch_up(void)
{
    check_ask("All run the same way, and only the difference of the "
              "velocities closes a gap. Who catches up with whom?");
    check_both(RING(3, 12.0, {1.0, 3.0, 8.0}, {4.0, 3.0, 1.0}), 2.0, 0);
    check_both(RING(3, 12.0, {1.0, 3.0, 8.0}, {-1.0, -2.0, -5.0}),
               5.0 / 3.0, 1);
}

static void test_parting(void)
{
    check_ask("Beads 0 and 1 are near, but they go away from each other. "
              "Which pairs can meet at all?");
    check_both(RING(3, 10.0, {1.0, 2.0, 6.0}, {-1.0, 2.0, 1.0}), 2.5, 2);
}

static void test_touching(void)
{
    check_ask("Two beads stand at the same place. Whether they meet now is "
              "a matter of their velocities. What do these say?");
    check_both(RING(3, 10.0, {3.0, 3.0, 7.0}, {-1.0, 1.0, 0.5}), 4.0, 2);
    check_both(RING(3, 10.0, {3.0, 3.0, 7.0}, {1.0, 1.0, -1.0}), 2.0, 1);
    check_both(RING(3, 10.0, {3.0, 3.0, 7.0}, {1.0, -1.0, -9.0}), 0.0, 0);
}

static void test_wrong_order(void)
{
    check_ask(
        "A rounding has put one bead a hair beyond its neighbour. When do "
        "the two meet if they approach, and when if they do not?");
    const double hair = 4.0 * DBL_EPSILON;
    check_both(RING(3, 10.0, {2.0 + hair, 2.0, 7.0}, {1.0, -1.0, -2.0}),
               0.0, 0);
    check_both(RING(3, 10.0, {1.0, 2.0 + hair, 2.0}, {1.5, 3.0, -1.0}), 0.0,
               1);
    check_both(RING(3, 10.0, {3.0 + hair, 3.0, 7.0}, {-1.0, 1.0, 0.5}), 4.0,
               2);
}

static void test_ties(void)
{
    check_ask(
        "Several pairs meet at the same time. Which one was to be named?");
    check_both(RING(4, 8.0, {0.0, 2.0, 4.0, 6.0}, {1.0, -1.0, 1.0, -1.0}),
               1.0, 0);
    check_both(RING(4, 8.0, {1.0, 3.0, 5.0, 7.0}, {-1.0, 1.0, -1.0, 1.0}),
               1.0, 1);
}

/* All velocities larger by the same amount: the ring turns. No round
   numbers; and at the time found the two must be at one place. */
static void test_turning(void)
{
    const struct ring still = RING(5, 7.3, {0.41, 1.13, 2.71, 5.09, 6.67},
                                   {0.37, -0.53, 0.19, -0.71, 0.83});
    check_ask("Somebody who runs along the ring sees the same meetings. "
              "Which of your numbers minds?");
    for (int turn = -3; turn <= 3; ++turn) {
        struct ring r = still;
        for (size_t i = 0; i < r.n; ++i)
            r.v[i] += 1.9 * turn;
        const size_t i = first_pair(&r);
        check_both(r, gap(&r, i) / approach(&r, i), i);
    }
}

/* Rings made from the answer, as a film that is run backwards: in the end
   the beads stand in these gaps, and before that each gap was larger by
   what the two have approached each other since. All in whole numbers of
   1/128, so that nothing is rounded. */
struct film {
    size_t n;
    double time;
    double v[MOST], after[MOST]; /* the gap to the right of each bead */
};

/* What the right neighbour of a bead gains on it. */
static double parting(const struct film *f, size_t i)
{
    return f->v[(i + 1) % f->n] - f->v[i];
}

/* A film in which all beads are apart, from the beginning to the end. */
static struct film draw_film(double time)
{
    struct film f = {.n = (size_t)check_draw_whole(2, MOST), .time = time};
    for (size_t i = 0; i < f.n; ++i)
        f.v[i] = check_draw_whole(-24, 24) / 8.0;
    for (size_t i = 0; i < f.n; ++i)
        f.after[i] = check_draw_whole(1, 48) / 16.0 +
                     fmax(0.0, parting(&f, i) * time);
    return f;
}

/* Lets a pair meet in the end, or all that can. Returns the first of them,
   or n. A film that takes no time begins with its end, and there the
   pair across the seam would be beyond the length. */
static size_t let_meet(struct film *f, bool all)
{
    const size_t start = (size_t)check_draw_whole(0, (int)f->n - 1);
    size_t left = f->n;
    for (size_t k = 0; k < f->n && (all || left == f->n); ++k) {
        const size_t i = (start + k) % f->n;
        if (parting(f, i) >= 0.0 || (f->time == 0.0 && i + 1 == f->n))
            continue;
        f->after[i] = 0.0;
        left = i < left ? i : left;
    }
    return left;
}

/* Pairs that do not approach touch in the beginning. */
static void let_touch(struct film *f)
{
    for (size_t i = 0; i + 1 < f->n; ++i)
        if (parting(f, i) >= 0.0)
            f->after[i] = parting(f, i) * f->time;
}

static struct ring first_picture(const struct film *f)
{
    struct ring r = {.n = f->n};
    for (size_t i = 0; i < f->n; ++i) {
        r.x[i] = r.length;
        r.v[i] = f->v[i];
        r.length += f->after[i] - parting(f, i) * f->time;
    }
    /* Move all beads into the gap across the seam. */
    const double turn = gap(&r, r.n - 1) * check_draw_whole(0, 3) / 4.0;
    for (size_t i = 0; i < r.n; ++i)
        r.x[i] += turn;
    return r;
}

/* Every third time all pairs that can meet do so at one time. */
CHECK_TIMES(60, test_drawn, take)
{
    check_ask(
        "This ring was made by running a film backwards from its meeting. "
        "How long has the film run, and who meets at its end?");
    struct film f = draw_film(check_draw_whole(1, 40) / 8.0);
    const size_t left = let_meet(&f, take % 3 == 2);
    const struct ring r = first_picture(&f);
    if (left == f.n)
        check_never(r);
    else
        check_both(r, f.time, left);
}

/* All pairs that do not approach touch, but not across the seam; every
   third time one of these, or of those that meet at once, is in the wrong
   order by a rounding. */
CHECK_TIMES(60, test_drawn_touching, take)
{
    check_ask("Several pairs touch here, or nearly. Which of them press on "
              "each other, which part, and who meets next?");
    struct film f =
        draw_film(take % 2 ? 0.0 : check_draw_whole(1, 40) / 8.0);
    const size_t left = let_meet(&f, false);
    if (left == f.n && f.time == 0.0)
        return;
    let_touch(&f);
    struct ring r = first_picture(&f);
    for (size_t i = 0; take % 3 == 0 && i + 1 < r.n; ++i)
        if (r.x[i] == r.x[i + 1]) {
            r.x[i] *= 1.0 + DBL_EPSILON;
            break;
        }
    if (left == f.n)
        check_never(r);
    else
        check_both(r, f.time, left);
}

const struct check_suite check_suite = {
    .file = "02a-ring.c",
    .title = "The next collision on a ring",
    .minutes = 15,
    .equation = "eq:gap-time",
    .tests =
        {{"two beads that approach meet", test_two, 1, 0},
         {"of three pairs the first to meet is found", test_three, 1, 0},
         {"beads that move alike never meet, and one alone meets nobody",
          test_never, 1, 0},
         {"the last bead meets the first across the seam", test_seam, 1, 0},
         {"two beads meet both ways round", test_both_ways, 1, 0},
         {"a fast bead catches up with a slow one", test_catch_up, 1, 0},
         {"beads that part do not meet", test_parting, 1, 0},
         {"beads that touch meet now or not at all", test_touching, 1, 0},
         {"a rounding that puts two in the wrong order does no harm",
          test_wrong_order, 1, 0},
         {"of pairs that meet at one time the first is named", test_ties, 1,
          0},
         {"a ring that turns changes nothing", test_turning, 1, 0},
         {"sixty films run backwards from a meeting", test_drawn, 1, 2},
         {"sixty rings on which pairs touch", test_drawn_touching, 1, 1},
         {0}},
};
