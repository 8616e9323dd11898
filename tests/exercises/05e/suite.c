/* The suite of exercise 05e, "A check that finds the clock". */

#include "examiner/check.h"

struct state {
    double x, y, vx, vy;
};

typedef void program(struct state start, double tick, size_t samples,
                     struct state kept[]);

bool clock_is_right(double width, double height, program *run);

/* The box of the programs, what a lossy clock loses at a bounce in ticks,
   and the bounces that all of them together have seen. */
static double width, height, lost;
static size_t bounces;

/* How long it is to the next wall on one axis. */
static double wait(double x, double v, double size)
{
    return v > 0.0   ? fmax(0.0, size - x) / v
           : v < 0.0 ? fmax(0.0, x) / -v
                     : INFINITY;
}

static double next(const struct state *s)
{
    return fmin(wait(s->x, s->vx, width), wait(s->y, s->vy, height));
}

static void fly(struct state *s, double time)
{
    s->x += time * s->vx;
    s->y += time * s->vy;
}

/* Whichever wall is due turns the disk round. */
static void bounce(struct state *s)
{
    ++bounces;
    if (wait(s->x, s->vx, width) <= wait(s->y, s->vy, height))
        s->vx = -s->vx;
    else
        s->vy = -s->vy;
}

/* What by_events does otherwise than a right program; and `lost`. */
enum {
    BACKWARDS = 1, /* flies to an event by what the article has for it */
    RECORDS = 2,   /* records an event like a tick */
    RESTARTS = 4,  /* begins a tick anew after an event */
    ONCE = 8       /* sees one event between two ticks, and no other */
};
static int habits;

static void by_events(struct state s, double tick, size_t samples,
                      struct state kept[])
{
    double left = tick; /* until the next tick */
    size_t events = 0;
    for (size_t k = 0; k < samples;) {
        const double event = next(&s);
        if (event >= left || events > 20 * samples) {
            fly(&s, left);
            left = tick;
            kept[k++] = s;
            continue;
        }
        ++events; /* a clock that restarts may never come to its end */
        fly(&s, habits & BACKWARDS ? event - 2.0 * tick : event);
        left -= event;
        bounce(&s);
        fly(&s, -lost * tick);
        if (habits & RECORDS)
            kept[k++] = s;
        if (habits & RESTARTS)
            left = tick;
        if (habits & ONCE) {
            fly(&s, left);
            left = tick;
            if (k < samples)
                kept[k++] = s;
        }
    }
}

/* One axis at any time: a mirrored box beside each box. */
static double folded(double x, double *v, double size, double time)
{
    const double turns = floor((x + *v * time) / size);
    const double rest = x + *v * time - turns * size;
    const bool odd = fmod(turns, 2.0) != 0.0;
    *v = odd ? -*v : *v;
    return odd ? size - rest : rest;
}

static void by_mirrors(struct state s, double tick, size_t samples,
                       struct state kept[])
{
    ++bounces; /* which it need not count */
    for (size_t k = 0; k < samples; ++k) {
        kept[k] = s;
        const double t = (double)(k + 1) * tick;
        kept[k].x = folded(s.x, &kept[k].vx, width, t);
        kept[k].y = folded(s.y, &kept[k].vy, height, t);
    }
}

/* Along y everything is a hundredth of a tick late. */
static void late_above(struct state s, double tick, size_t samples,
                       struct state kept[])
{
    by_mirrors(s, tick, samples, kept);
    for (size_t k = 0; k < samples; ++k) {
        kept[k].vy = s.vy;
        kept[k].y =
            folded(s.y, &kept[k].vy, height, ((double)k + 0.99) * tick);
    }
}

/* And here along x. */
static void late_across(struct state s, double tick, size_t samples,
                        struct state kept[])
{
    by_mirrors(s, tick, samples, kept);
    for (size_t k = 0; k < samples; ++k) {
        kept[k].vx = s.vx;
        kept[k].x =
            folded(s.x, &kept[k].vx, width, ((double)k + 0.99) * tick);
    }
}

/* limit: 1e-10 of the way (a right one may be off by less) */
/* limit: 1e-5 of the box (a wrong one is off by more) */
/* Off along both axes: by a part of the way that grows, and by a part of
   the box from the hundredth tick on. */
static double off_way, off_box;

static double shifted(double x, double by, double size)
{
    return x + by <= size ? x + by : x - by;
}

static void inexact(struct state s, double tick, size_t samples,
                    struct state kept[])
{
    by_mirrors(s, tick, samples, kept);
    for (size_t k = 0; k < samples; ++k) {
        const double way = hypot(s.vx, s.vy) * fabs(tick) * (double)(k + 1);
        const double box = k < 100 ? 0.0 : off_box;
        kept[k].x = shifted(kept[k].x, off_way * way + box * width, width);
        kept[k].y =
            shifted(kept[k].y, off_way * way + box * height, height);
    }
}

/* A program to judge. */
struct judged {
    program *run;
    int habits;
    double lost, off_way, off_box;
    const char *how;                /* what it does, in words */
    const char *mistake, *question; /* for who judges it wrongly */
    double width, height;
    /* ---- what was found out */
    double said;
    int calls;
    size_t bounces;
};

static program *tried;
static int calls;

static void counted(struct state s, double tick, size_t samples,
                    struct state kept[])
{
    ++calls;
    tried(s, tick, samples, kept);
}

enum { MOST = 80 };

/* Asks about all programs, in another order than they are told of, drawn
   each time, so that what is said of one cannot come from its place in the
   row; each in a process of its own. */
static void ask(struct judged all[], int count)
{
    int order[MOST];
    check_shuffle(order, count);
    for (int k = 0; k < count; ++k) {
        struct judged *j = &all[order[k]];
        width = j->width;
        height = j->height;
        habits = j->habits;
        lost = j->lost;
        off_way = j->off_way;
        off_box = j->off_box;
        tried = j->run;
        bounces = 0;
        calls = 0;
        j->said = clock_is_right(width, height, counted) ? 1.0 : 0.0;
        j->calls = calls;
        j->bounces = bounces;
    }
}

/* Who has judged without a look has found out nothing. */
static void check_called(const struct judged *j)
{
    static const char question[] =
        "You have said something of this program, and have not run it "
        "once. What do you know of it?";
    CHECK_NEAR(j->calls > 0,
               .quantity = "1 if the program that you judge was run at all",
               .input = j->how, .expected = 1.0, .because = "yes or no",
               .question = question,
               .mistakes = {{"never-called", 0.0, question}});
}

static void check_right(const struct judged *j)
{
    check_called(j);
    CHECK_NEAR(j->said,
               .quantity =
                   "what you say of a right program (1 true, 0 false)",
               .input = j->how, .expected = 1.0, .because = "yes or no",
               .question = j->question,
               .mistakes = {{j->mistake, 0.0, j->question}});
}

static void check_wrong(const struct judged *j)
{
    const bool seen = j->bounces > 0;
    check_called(j);
    CHECK_NEAR(
        j->said,
        .quantity = "what you say of a wrong program (1 true, 0 false)",
        .input = j->how, .because = "yes or no", .question = j->question,
        .mistakes = {{"no-bounce", seen ? 0.0 : j->said,
                      "Not one of your runs has seen a bounce. What can a "
                      "clock do wrong when nothing happens?"},
                     {j->mistake, seen ? j->said : 0.0, j->question}});
}

/* Versions 14 and 19 of clang-format disagree about these braces. */
/* clang-format off */
#define JUDGED(run, habits, lost, off_way, off_box, ...) \
    {run, habits, lost, off_way, off_box, __VA_ARGS__, 3, 2, 0, 0, 0}
/* clang-format on */

static const struct judged right[] = {
    JUDGED(by_mirrors, 0, 0, 0, 0,
           "a right program, which works with mirrors", "right-one-refused",
           "This one is right, and until you take it nothing else counts. "
           "Where do you say the disk is, and where is it? Begin with the "
           "first tick."),
    JUDGED(by_events, 0, 0, 0, 0, "a right program, from bounce to bounce",
           "rounding-refused",
           "This one is right, and rounds at each bounce and each tick. "
           "How near is near?"),
    JUDGED(inexact, 0, 0, 0.9e-10, 0,
           "a right program, off by 0.9e-10 of the way", "rounding-refused",
           "This one is right: it is off by less than 1e-10 of the way. "
           "How long is the way in your runs, and how far off may the disk "
           "be at its end?")};

enum { RIGHT = sizeof right / sizeof *right };

/* Judges the right programs and then some wrong ones, up to one that is
   NULL. */
static void judge(const struct judged wrong[])
{
    struct judged all[MOST];
    int count = 0;
    while (count < RIGHT || wrong[count - RIGHT].run) {
        all[count] = count < RIGHT ? right[count] : wrong[count - RIGHT];
        ++count;
    }
    ask(all, count);
    for (int i = 0; i < count; ++i)
        if (i < RIGHT)
            check_right(&all[i]);
        else
            check_wrong(&all[i]);
}

/* Defines a test that judges these and the right ones. */
#define JUDGE(test, ...)                                                   \
    static void test(void)                                                 \
    {                                                                      \
        judge((const struct judged[]){__VA_ARGS__, {0}});                  \
    }

static void test_right(void)
{
    judge(&(const struct judged){0});
}

JUDGE(test_article,
      JUDGED(by_events, BACKWARDS | RECORDS | RESTARTS, 0, 0, 0,
             "the article's program", "energy-only",
             "The article's program jumps back in time at each bounce, and "
             "its speeds are right to the last digit. Which of its numbers "
             "belong to a time?"))

JUDGE(test_mended,
      JUDGED(by_events, RECORDS | RESTARTS, 0, 0, 0,
             "the article's, with its sign mended", "place-not-compared",
             "This disk is always inside, always on its way, and turns "
             "round at the walls. Is it there at the right time?"),
      JUDGED(by_events, RECORDS, 0, 0, 0,
             "each bounce is recorded like a tick", "place-not-compared",
             "Some of these samples belong to bounces. To which time does "
             "number k belong?"))

JUDGE(test_restarting,
      JUDGED(by_events, RESTARTS, 0, 0, 0,
             "the tick begins anew after a bounce", "place-not-compared",
             "Between two samples with a bounce more than a tick goes by. "
             "Do you look at those?"))

JUDGE(test_once,
      JUDGED(by_events, ONCE, 0, 0, 0,
             "one bounce a tick is seen, and no more", "one-bounce-a-tick",
             "This program forgets the second bounce between two ticks. Is "
             "there ever more than one in your runs?"))

static const char losing_question[] =
    "This program loses a little time at each bounce, and the differences "
    "grow. How much do you let pass, and how long do you look?";

JUDGE(test_losing,
      JUDGED(by_events, 0, 0.1, 0, 0, "each bounce loses 0.1 ticks",
             "small-error-passes", losing_question),
      JUDGED(by_events, 0, 1e-3, 0, 0, "each bounce loses 0.001 ticks",
             "small-error-passes", losing_question),
      JUDGED(inexact, 0, 0, 0, 1.2e-5,
             "from the hundredth tick on all is off by 1.2e-5 of the box",
             "small-error-passes",
             "This program is off by more than 1e-5 of the box, later on. "
             "How much do you let pass, and how long do you look?"))

JUDGE(
    test_axes,
    JUDGED(
        late_above, 0, 0, 0, 0, "along y all is 0.01 ticks late",
        "one-axis-only",
        "Along x this program is right. Which coordinates do you look at?"),
    JUDGED(
        late_across, 0, 0, 0, 0, "along x all is 0.01 ticks late",
        "one-axis-only",
        "Along y this program is right. Which coordinates do you look at?"))

/* limit: 1e-9 m */
/* limit: 1e9 m */
/* limit: 1000 ticks and bounces (of which a right one keeps its word) */
/* Boxes of any size, from a molecule's to a planet's, with a right program
   and one that loses time. */
static void test_drawn(void)
{
    static const char question[] =
        "A box of another size. Which lengths, tolerances, velocities and "
        "times of yours are those of a box of a metre?";
    struct judged all[MOST] = {{0}};
    for (int i = 0; i < MOST; i += 4) {
        const double unit =
            i < 8 ? (i ? 1e9 : 1e-9) : pow(10.0, check_draw(-9.0, 9.0));
        all[i].width = unit * check_draw(0.5, 2.0);
        all[i].height = unit * check_draw(0.5, 2.0);
        const double loses = check_draw(0.01, 0.5);
        for (int k = 0; k < 4; ++k) {
            all[i + k] = all[i];
            all[i + k].run = k == 1 ? by_mirrors : by_events;
            all[i + k].lost = k == 2 ? loses : 0.0;
            all[i + k].habits = k == 3 ? RECORDS | RESTARTS : 0;
        }
    }
    ask(all, MOST);
    for (int i = 0; i < MOST; ++i) {
        struct judged *j = &all[i];
        const bool good = i % 4 < 2;
        j->how = check_text("a box of %g m by %g m", j->width, j->height);
        check_called(j);
        CHECK_NEAR(
            j->said,
            .quantity = good ? "what you say of a right program"
                             : "what you say of a wrong program",
            .input = j->how, .expected = good ? 1.0 : 0.0,
            .because = "yes or no", .question = question,
            .mistakes = {{"only-this-box", good ? 0.0 : 1.0, question}});
    }
}

const struct check_suite check_suite = {
    .file = "05e-finds.c",
    .title = "A check that finds the clock",
    .minutes = 35,
    .equation = "eq:disk-clock",
    .tests =
        {{"two right programs are right", test_right, 1, 0},
         {"the article's program is refused", test_article, 2, 0},
         {"programs that record bounces are refused", test_mended, 1, 0},
         {"one whose clock restarts is refused", test_restarting, 1, 0},
         {"one that sees one bounce a tick is refused", test_once, 2, 0},
         {"those that lose time at a bounce are refused", test_losing, 2,
          0},
         {"those that are late along one axis are refused", test_axes, 1,
          0},
         {"boxes of all sizes", test_drawn, 1, 2},
         {0}},
    .idle = {test_right},
};
