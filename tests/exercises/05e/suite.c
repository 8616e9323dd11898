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

/* What a program does otherwise than a right one. */
struct habits {
    bool backwards; /* flies to an event by what the article has for it */
    bool records;   /* records an event like a tick */
    bool restarts;  /* begins a tick anew after an event */
    bool once;      /* sees one event between two ticks, and no other */
    double loses;   /* of a tick, at each event */
};

static void go(struct habits h, struct state s, double tick, size_t samples,
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
        fly(&s, h.backwards ? event - 2.0 * tick : event);
        left -= event;
        bounce(&s);
        fly(&s, -h.loses * tick);
        if (h.records)
            kept[k++] = s;
        if (h.restarts)
            left = tick;
        if (h.once) {
            fly(&s, left);
            left = tick;
            if (k < samples)
                kept[k++] = s;
        }
    }
}

static void by_events(struct state s, double tick, size_t samples,
                      struct state kept[])
{
    go((struct habits){0}, s, tick, samples, kept);
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

static void article(struct state s, double tick, size_t samples,
                    struct state kept[])
{
    go((struct habits){true, true, true, false, 0.0}, s, tick, samples,
       kept);
}

static void mended(struct state s, double tick, size_t samples,
                   struct state kept[])
{
    go((struct habits){false, true, true, false, 0.0}, s, tick, samples,
       kept);
}

static void recording(struct state s, double tick, size_t samples,
                      struct state kept[])
{
    go((struct habits){false, true, false, false, 0.0}, s, tick, samples,
       kept);
}

static void restarting(struct state s, double tick, size_t samples,
                       struct state kept[])
{
    go((struct habits){false, false, true, false, 0.0}, s, tick, samples,
       kept);
}

static void once(struct state s, double tick, size_t samples,
                 struct state kept[])
{
    go((struct habits){false, false, false, true, 0.0}, s, tick, samples,
       kept);
}

static void losing(struct state s, double tick, size_t samples,
                   struct state kept[])
{
    go((struct habits){false, false, false, false, lost}, s, tick, samples,
       kept);
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

/* The programs of a test, in the order in which they are told of. They are
   asked about in another order, drawn each time, so that what is said of
   one cannot come from its place in the row; each in a process of its own.
   So a test goes through its programs twice: first they are put down, then
   they are told of. */
enum { MOST = 80 };

static struct {
    program *run;
    double width, height, lost, off_way, off_box; /* for this one */
    double said;
    int calls;
    size_t bounces;
} judged[MOST];
static int count, at;
static enum { PUT_DOWN, TELL, DONE } stage;

static program *tried;
static int calls;

static void counted(struct state s, double tick, size_t samples,
                    struct state kept[])
{
    ++calls;
    tried(s, tick, samples, kept);
}

static void ask(int i)
{
    width = judged[i].width;
    height = judged[i].height;
    lost = judged[i].lost;
    off_way = judged[i].off_way;
    off_box = judged[i].off_box;
    tried = judged[i].run;
    bounces = 0;
    calls = 0;
    judged[i].said = clock_is_right(width, height, counted) ? 1.0 : 0.0;
    judged[i].calls = calls;
    judged[i].bounces = bounces;
}

static void begin(void)
{
    count = 0;
    stage = DONE;
}

/* Whether the programs are to be gone through, once more. */
static bool again(void)
{
    int order[MOST];
    if (stage == TELL)
        return false;
    stage = stage == DONE ? PUT_DOWN : TELL;
    check_shuffle(order, count);
    for (int k = 0; k < count; ++k)
        ask(order[k]);
    at = 0;
    return true;
}

/* Whether that is all for now. */
static bool put_down(program *run, double w, double h)
{
    if (stage == PUT_DOWN && count < MOST) {
        judged[count].width = w;
        judged[count].height = h;
        judged[count].lost = lost;
        judged[count].off_way = off_way;
        judged[count].off_box = off_box;
        judged[count++].run = run;
    }
    return stage == PUT_DOWN;
}

/* Who has judged without a look has found out nothing. */
static bool check_called(const char *how)
{
    static const char question[] =
        "You have said something of this program, and have not run it "
        "once. What do you know of it?";
    return CHECK_NEAR(judged[at].calls > 0 ? 1.0 : 0.0,
                      .quantity =
                          "1 if the program that you judge was run at all",
                      .input = how, .expected = 1.0, .tolerance = 0.0,
                      .because = "yes or no", .question = question,
                      .mistakes = {{"never-called", 0.0, question}});
}

static bool check_right(program *run, const char *how, const char *mistake,
                        const char *question)
{
    return put_down(run, 3.0, 2.0) ||
           (check_called(how) &&
            CHECK_NEAR(
                judged[at++].said,
                .quantity =
                    "what you say of a right program (1 true, 0 false)",
                .input = how, .expected = 1.0, .tolerance = 0.0,
                .because = "yes or no", .question = question,
                .mistakes = {{mistake, 0.0, question}}));
}

static bool check_rights(void)
{
    return check_right(by_mirrors,
                       "a right program, which works with mirrors",
                       "right-one-refused",
                       "This one is right, and until you take it nothing "
                       "else counts. Where do you say the disk is, and "
                       "where is it? Begin with the first tick.") &&
           check_right(by_events, "a right program, from bounce to bounce",
                       "rounding-refused",
                       "This one is right, and rounds at each bounce and "
                       "each tick. How near is near?") &&
           (off_way = 0.9e-10, off_box = 0.0,
            check_right(inexact,
                        "a right program, off by 0.9e-10 of the way",
                        "rounding-refused",
                        "This one is right: it is off by less than 1e-10 "
                        "of the way. How long is the way in your runs, and "
                        "how far off may the disk be at its end?"));
}

static bool check_wrong(program *run, const char *how, const char *mistake,
                        const char *question)
{
    static const char none[] =
        "Not one of your runs has seen a bounce. What can a clock do wrong "
        "when nothing happens?";
    if (put_down(run, 3.0, 2.0))
        return true;
    if (!check_called(how))
        return false;
    const size_t seen = judged[at].bounces;
    const double got = judged[at++].said;
    return CHECK_NEAR(
        got,
        .quantity = "what you say of a wrong program (1 true, 0 false)",
        .input = how, .expected = 0.0, .tolerance = 0.0,
        .because = "yes or no", .question = question,
        .mistakes = {{"no-bounce", seen > 0 ? 0.0 : got, none},
                     {mistake, seen > 0 ? got : 0.0, question}});
}

static void test_right(void)
{
    for (begin(); again();)
        check_rights();
}

static void test_article(void)
{
    static const char question[] =
        "The article's program jumps back in time at each bounce, and its "
        "speeds are right to the last digit. Which of its numbers belong "
        "to a time?";
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(article, "the article's program", "energy-only",
                           question));
}

static void test_mended(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(mended, "the article's, with its sign mended",
                           "place-not-compared",
                           "This disk is always inside, always on its way, "
                           "and turns round at the walls. Is it there at "
                           "the right time?") &&
               check_wrong(recording, "each bounce is recorded like a tick",
                           "place-not-compared",
                           "Some of these samples belong to bounces. To "
                           "which time does number k belong?"));
}

static void test_restarting(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(restarting,
                           "the tick begins anew after a bounce",
                           "place-not-compared",
                           "Between two samples with a bounce more than a "
                           "tick goes by. Do you look at those?"));
}

static void test_once(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(
                   once, "one bounce a tick is seen, and no more",
                   "one-bounce-a-tick",
                   "This program forgets the second bounce between two "
                   "ticks. Is there ever more than one in your runs?"));
}

static void test_losing(void)
{
    static const double share[] = {0.1, 1e-3};
    for (begin(); again();) {
        bool fine = check_rights();
        for (int i = 0; i < 2 && fine; ++i) {
            lost = share[i];
            fine = check_wrong(
                losing, check_text("each bounce loses %g ticks", lost),
                "small-error-passes",
                "This program loses a little time at each bounce, and the "
                "differences grow. How much do you let pass, and how long "
                "do you look?");
        }
        off_way = 0.0;
        off_box = 1.2e-5;
        (void)(fine && check_wrong(inexact,
                                   "from the hundredth tick on all is off "
                                   "by 1.2e-5 of the box",
                                   "small-error-passes",
                                   "This program is off by more than 1e-5 "
                                   "of the box, later on. How much do you "
                                   "let pass, and how long do you look?"));
    }
}

static void test_axes(void)
{
    for (begin(); again();)
        (void)(check_rights() &&
               check_wrong(late_above, "along y all is 0.01 ticks late",
                           "one-axis-only",
                           "Along x this program is right. Which "
                           "coordinates do you look at?") &&
               check_wrong(late_across, "along x all is 0.01 ticks late",
                           "one-axis-only",
                           "Along y this program is right. Which "
                           "coordinates do you look at?"));
}

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
    program *const four[] = {by_events, by_mirrors, losing, mended};
    double w[20], h[20], loses[20];
    for (int i = 0; i < 20; ++i) {
        const double unit =
            i < 2 ? (i ? 1e9 : 1e-9) : pow(10.0, check_draw(-9.0, 9.0));
        w[i] = unit * check_draw(0.5, 2.0);
        h[i] = unit * check_draw(0.5, 2.0);
        loses[i] = check_draw(0.01, 0.5);
    }
    for (begin(); again();)
        for (int i = 0; i < 80; ++i) {
            const int k = i % 4;
            lost = loses[i / 4];
            if (put_down(four[k], w[i / 4], h[i / 4]))
                continue;
            const char *box =
                check_text("a box of %g m by %g m", w[i / 4], h[i / 4]);
            if (!check_called(box) ||
                !CHECK_NEAR(judged[at++].said,
                            .quantity =
                                k < 2 ? "what you say of a right program"
                                      : "what you say of a wrong program",
                            .input = box, .expected = k < 2 ? 1.0 : 0.0,
                            .tolerance = 0.0, .because = "yes or no",
                            .question = question,
                            .mistakes = {{"only-this-box",
                                          k < 2 ? 0.0 : 1.0, question}}))
                return;
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
