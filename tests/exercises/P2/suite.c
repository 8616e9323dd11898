/* Project P2: disks that fly, disks that are thrown, and a force made of
   room. */
#include "examiner/project.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4, PER_DISK = 4, SLICES = 14, RINGS = 10, LONGEST = 20000 };

struct scene {
    int n;
    double r, tc, start[PER_DISK * MOST]; /* x y vx vy of each */
    int rows;
};

/* ---- what must come out, and what comes of mistakes ---- */

enum fault {
    NONE,
    RADIUS,
    CENTRES,
    LATER,
    SWAPPED,
    BOTH_TURN,
    ARTICLE,
    AT_EVENTS,
    FAULTS
};
static const struct {
    const char *name, *hint;
} faults[FAULTS] = {
    [RADIUS] = {"radius-for-diameter",
                "These two have met at the distance of one radius. How far "
                "apart are two centres when the disks touch?"},
    [CENTRES] = {"centre-at-the-wall",
                 "The centre has gone up to the wall. What of the disk "
                 "touches it first?"},
    [LATER] = {"later-root",
               "These two have flown through each other and met on the way "
               "out. A quadratic equation has two roots: which of them is "
               "when they begin to touch?"},
    [SWAPPED] = {"velocities-swapped",
                 "They have exchanged all of their velocities. Along which "
                 "line do smooth disks push each other, and what becomes "
                 "of the part across it?"},
    [BOTH_TURN] = {"wall-turns-both",
                   "The wall has turned both components round. Which of "
                   "them does a smooth wall touch?"},
    [ARTICLE] = {"article-clock",
                 "This is the article's clock: at an event the disks are "
                 "moved as if the last tick had not been, and the event is "
                 "recorded as though it were a tick. Where are the disks "
                 "when they collide, and whose time is a row's?"},
    [AT_EVENTS] =
        {"rows-at-events",
         "This row is that of an event. How does your program come to be "
         "at a row's time, in the middle of a flight?"},
};

struct engine {
    const struct scene *s;
    enum fault fault;
    long double x[2 * MOST], v[2 * MOST];
    int i, j; /* who is next; j is negative for a wall */
    long pairs, walls;
};

static long double meeting(const struct engine *e, int i, int j)
{
    const long double *x = e->x, *v = e->v;
    const long double dx = x[2 * j] - x[2 * i], w = v[2 * i] - v[2 * j];
    const long double dy = x[2 * j + 1] - x[2 * i + 1];
    const long double u = v[2 * i + 1] - v[2 * j + 1];
    const long double touch = (e->fault == RADIUS ? 1.0L : 2.0L) * e->s->r;
    const long double ww = w * w + u * u, closing = w * dx + u * dy;
    const long double near = closing / ww;
    const long double past = dx * u - w * dy;
    const long double half = touch * touch / ww - past * past / ww / ww;
    if (half < 0.0L || !(near > 0.0L))
        return INFINITY;
    return fmaxl(near + (e->fault == LATER ? 1.0L : -1.0L) * sqrtl(half),
                 0.0L);
}

static long double next(struct engine *e)
{
    const long double edge = e->fault == CENTRES ? 0.0L : e->s->r;
    long double first = INFINITY;
    e->i = 0;
    e->j = -1;
    for (int i = 0; i < e->s->n; ++i)
        for (int j = -2; j < i; ++j) {
            const int c = 2 * i + (j < 0 ? -1 - j : 0);
            const long double way =
                e->v[c] > 0.0L ? 1.0L - edge - e->x[c] : e->x[c] - edge;
            const long double t = j >= 0            ? meeting(e, i, j)
                                  : e->v[c] == 0.0L ? INFINITY
                                                    : way / fabsl(e->v[c]);
            if (t < first) {
                first = fmaxl(t, 0.0L);
                e->i = i;
                e->j = j;
            }
        }
    return first;
}

static void fly(struct engine *e, long double t)
{
    for (int c = 0; c < 2 * e->s->n; ++c)
        e->x[c] += t * e->v[c];
}

static void collide(struct engine *e)
{
    long double *v = e->v + 2 * e->i, *w = e->v + 2 * e->j;
    if (e->j < 0) {
        ++e->walls;
        for (int c = 0; c < 2; ++c)
            if (c == -1 - e->j || e->fault == BOTH_TURN)
                v[c] = -v[c];
        return;
    }
    ++e->pairs;
    if (e->fault == SWAPPED) {
        for (int c = 0; c < 2; ++c) {
            const long double other = v[c];
            v[c] = w[c];
            w[c] = other;
        }
        return;
    }
    const long double dx = e->x[2 * e->j] - e->x[2 * e->i];
    const long double dy = e->x[2 * e->j + 1] - e->x[2 * e->i + 1];
    const long double part =
        ((w[0] - v[0]) * dx + (w[1] - v[1]) * dy) / (dx * dx + dy * dy);
    v[0] += part * dx;
    v[1] += part * dy;
    w[0] -= part * dx;
    w[1] -= part * dy;
}

struct table {
    double row[LONGEST + 1][1 + PER_DISK * MOST];
    bool torn[LONGEST + 1]; /* an event falls on the row */
    long pairs, walls;
};

static void put_row(const struct engine *e, double t, double row[])
{
    row[0] = t;
    for (int c = 0; c < 2 * e->s->n; ++c) {
        row[1 + PER_DISK * (c / 2) + c % 2] = (double)e->x[c];
        row[3 + PER_DISK * (c / 2) + c % 2] = (double)e->v[c];
    }
}

/* Fills the table; all places are begun so far from where they are. */
static void simulate(const struct scene *s, enum fault fault, double off,
                     struct table *table)
{
    struct engine e = {.s = s, .fault = fault};
    long double now = 0.0L, last = -1.0L, event;
    for (int c = 0; c < 2 * s->n; ++c) {
        e.x[c] =
            s->start[PER_DISK * (c / 2) + c % 2] + (c % 3 ? off : -off);
        e.v[c] = s->start[PER_DISK * (c / 2) + 2 + c % 2];
    }
    put_row(&e, 0.0, table->row[0]);
    event = next(&e);
    for (int k = 1; k <= s->rows; ++k) {
        const long double tick = (double)k * s->tc;
        if (fault == ARTICLE) {
            now += s->tc;
            if (now < event) {
                fly(&e, s->tc);
            } else {
                fly(&e, event - now - s->tc);
                collide(&e);
                now = event;
                event = now + next(&e);
            }
        } else if (fault == AT_EVENTS) {
            fly(&e, event - now);
            now = event;
            collide(&e);
            event = now + next(&e);
        } else {
            for (; event <= tick; event = now + next(&e)) {
                fly(&e, event - now);
                last = now = event;
                collide(&e);
            }
            fly(&e, tick - now);
            now = tick;
        }
        put_row(&e, (double)now, table->row[k]);
        table->torn[k] = event - tick < 1e-9L || tick - last < 1e-9L;
    }
    table->pairs = e.pairs;
    table->walls = e.walls;
}

/* ---- runs of disks that fly ---- */

static const char for_ever[] = "How does your loop end? Can an event come "
                               "again and again, without any time between?";

static const struct run_order *order(const char *what,
                                     const struct scene *s)
{
    static char disks[1000], words[3][32];
    static struct run_order o;
    int at = 0;
    for (int i = 0; i < s->n; ++i) {
        const double *d = s->start + PER_DISK * i;
        at += snprintf(disks + at, sizeof disks - (size_t)at,
                       "%.17g %.17g %.17g %.17g\n", d[0], d[1], d[2], d[3]);
    }
    snprintf(words[0], 32, "%.17g", s->r);
    snprintf(words[1], 32, "%.17g", s->tc);
    snprintf(words[2], 32, "%d", s->rows);
    o = (struct run_order){
        .arguments = {what, "disks.txt", words[0], words[1], words[2]},
        .files = {{"disks.txt", disks}},
        .late = for_ever,
    };
    return &o;
}

static void check_count(const struct run *r, const char *words, long want,
                        long both)
{
    const char *question =
        "Which events have been counted, and up to which time?";
    const double got = project_remark(r, words, &question);
    CHECK_NEAR(got, .quantity = words, .expected = (double)want,
               .question = question,
               .mistakes = {{"all-events", (double)both,
                             "That is the number of all events. Which of "
                             "them belong here?"}});
}

/* The mistake whose rows are these for the longest time. */
static enum fault likeness(const struct scene *s, const struct run *r)
{
    static struct table other;
    const int columns = 1 + PER_DISK * s->n;
    enum fault best = NONE;
    int longest = 0;
    for (enum fault f = NONE; f < FAULTS && s->rows < 1000; ++f) {
        int same = 0;
        simulate(s, f, 0.0, &other);
        /* Some print the time that should be beside what should not. */
        while (same < columns * (s->rows + 1) &&
               (same % columns == 0 ||
                fabs(r->numbers[same] -
                     other.row[same / columns][same % columns]) < 1e-7))
            ++same;
        if (same > longest) {
            longest = same;
            best = f;
        }
    }
    return best;
}

/* The first number that is not right, or a check that all are. */
static void check_rows(const struct scene *s, const struct table *want,
                       const struct run *r)
{
    static const char *const names[] = {"x", "y", "vx", "vy"};
    static struct table other;
    const int columns = 1 + PER_DISK * s->n;
    for (int k = 0; k <= s->rows; ++k)
        for (int c = 0; c < columns; ++c) {
            const double late = c ? 0.0 : want->row[k][0];
            const double got = r->numbers[k * columns + c] - late;
            const double slack = c ? 1e-8 : 1e-9 * s->tc;
            if (fabs(got - want->row[k][c] + late) <= slack ||
                (want->torn[k] && c > 0 && (c - 1) % PER_DISK > 1))
                continue;
            double sum = 0.0;
            for (int i = 0; i < k; ++i)
                sum += s->tc;
            struct check check = {
                .quantity =
                    c ? check_text("%s of disk %d in row %d",
                                   names[(c - 1) % PER_DISK],
                                   1 + (c - 1) / PER_DISK, k)
                      : check_text("how late row %d is, after %d TC", k, k),
                .unit = c == 0                   ? "s"
                        : (c - 1) % PER_DISK < 2 ? "m"
                                                 : "m/s",
                .expected = want->row[k][c] - late,
                .tolerance = slack,
                .because = c ? "rounding, and what collisions make of it"
                             : "a product is rounded once",
                .equation = c ? "eq:pair-time" : "eq:disk-clock",
                .question = c ? "Which event was the last before this row, "
                                "and when was it?"
                              : "Which time is that of row k?",
            };
            if (c == 0)
                project_mistake(
                    &check, "clock-adds-up", sum - late,
                    "Each addition of TC is rounded, and the clock drifts. "
                    "How do you get the time of row k with one rounding?");
            const enum fault like = likeness(s, r);
            if (like != NONE) {
                simulate(s, like, 0.0, &other);
                project_mistake(&check, faults[like].name,
                                other.row[k][c] - late, faults[like].hint);
            }
            check_near(got, check);
        }
    CHECK_NEAR(0.0, .quantity = "rows that differ");
    if (!want->torn[s->rows]) {
        check_count(r, "# pairs", want->pairs, want->pairs + want->walls);
        check_count(r, "# walls", want->walls, want->pairs + want->walls);
    }
}

/* Compares as many rows as can be known: a change of the start by 1e-12
   grows to 1e-8 at most, and so rounding, of 1e-16, to a ten thousandth of
   what is allowed. */
static void check_flight(struct scene s)
{
    static struct table want, near;
    simulate(&s, NONE, 0.0, &want);
    simulate(&s, NONE, 1e-12, &near);
    for (int k = 0; k <= s.rows; ++k)
        for (int c = 1; c <= PER_DISK * s.n; ++c)
            if (fabs(near.row[k][c] - want.row[k][c]) > 1e-8)
                s.rows = k - 1;
    simulate(&s, NONE, 0.0, &want);
    const struct run *r = run_program(order("fly", &s));
    project_form(r, (size_t)s.rows + 1, 1 + PER_DISK * (size_t)s.n,
                 "A row is t, and x, y, vx and vy of each disk. Which of "
                 "them is missing, or what is there besides?");
    check_rows(&s, &want, r);
}

static struct scene draw_disks(int n)
{
    struct scene s = {.n = n, .r = draw(0.13, 0.15)};
    for (int i = 0; i < n; ++i) {
        double *d = s.start + PER_DISK * i;
        d[0] = (i % 2 ? 0.73 : 0.27) + draw(-0.05, 0.05);
        d[1] = (i / 2 ? 0.73 : 0.27) + draw(-0.05, 0.05);
        d[2] = either_sign() * draw(0.4, 1.2);
        d[3] = either_sign() * draw(0.4, 1.2);
    }
    return s;
}

/* ---- stage 1 ---- */

/* limit: 16 disks */
/* As many as there may be, in four rows: only the last one moves. */
static void check_crowd(void)
{
    enum { ALL = 16, WIDTH = 1 + PER_DISK * ALL };
    static char disks[40 * ALL];
    for (int i = 0, at = 0; i < ALL; ++i)
        at += snprintf(disks + at, sizeof disks - (size_t)at,
                       "%g %g %g 0\n", 0.125 + 0.25 * (i % 4),
                       0.125 + 0.25 * (i / 4), i == ALL - 1 ? 0.05 : 0.0);
    const struct run_order o = {
        .arguments = {"fly", "disks.txt", "0.05", "0.5", "2"},
        .files = {{"disks.txt", disks}},
        .late = for_ever,
    };
    const struct run *r = run_program(&o);
    static const char question[] = "There are 16 disks, and so many are "
                                   "allowed. How many do your arrays hold?";
    project_form(r, 3, WIDTH, question);
    CHECK_NEAR(r->numbers[2 * WIDTH + 1 + PER_DISK * (ALL - 1)],
               .quantity = "x of disk 16 in row 2", .unit = "m",
               .expected = 0.925, .tolerance = 1e-9,
               .because = "it meets nobody", .question = question);
}

static void check_inputs(void)
{
    static const char one[] = "0.5 0.5 1 0.3\n";
    static const struct {
        const char *what, *disks, *words[4];
    } all[] = {
        {"no disk", "# none\n", {"fly", "0.1", "0.1", "1"}},
        {"three numbers", "0.5 0.5 1\n", {"fly", "0.1", "0.1", "1"}},
        {"five numbers", "0.5 0.5 1 0 0\n", {"fly", "0.1", "0.1", "1"}},
        {"a word", "0.5 half 1 0\n", {"fly", "0.1", "0.1", "1"}},
        {"a disk in a wall", "0.05 0.5 1 0\n", {"fly", "0.1", "0.1", "1"}},
        {"two that overlap",
         "0.5 0.5 1 0\n0.6 0.6 0 0\n",
         {"fly", "0.1", "0.1", "1"}},
        {"a radius of 0", one, {"fly", "0", "0.1", "1"}},
        {"a radius of 1/4 m", one, {"fly", "0.25", "0.1", "1"}},
        {"a tick of 0", one, {"fly", "0.1", "0", "1"}},
        {"ROWS that are not whole", one, {"fly", "0.1", "0.1", "1.5"}},
        {"a first word of no meaning", one, {"swim", "0.1", "0.1", "1"}},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        const struct run_order o = {
            .arguments = {all[i].words[0], "disks.txt", all[i].words[1],
                          all[i].words[2], all[i].words[3]},
            .files = {{"disks.txt", all[i].disks}},
            .late = for_ever,
        };
        project_refuses(&o, all[i].what);
    }
    project_refuses(&(struct run_order){.arguments = {"fly", "other.txt",
                                                      "0.1", "0.1", "1"},
                                        .late = for_ever},
                    "a file that is not there");
}

static void check_read(void)
{
    struct scene s = {.n = 1, .r = 0.1, .tc = 0.5, .rows = 2};
    struct run_order o = *order("fly", &s);
    o.files[0].text = "# x y vx vy\n\n\t.5 0.25   0.5 1e-1 # alone";
    const struct run *r = run_program(&o);
    project_reads(
        r, "A remark may fill a line, a line may be empty, and the last "
           "line need not end. Which of these does your program refuse?");
    project_form(r, 3, 5, "One disk: t and four numbers.");
}

/* To touch is not to overlap. */
static void check_touching(void)
{
    struct scene s = {.n = 2, .r = 0.125, .tc = 0.5, .rows = 2};
    struct run_order o = *order("fly", &s);
    o.files[0].text = "0.125 0.5 -0.3 0.2\n0.375 0.5 0.1 0\n";
    const struct run *r = run_program(&o);
    CHECK_NEAR(
        r->status, .quantity = "the status with which it ended",
        .question = "There is nothing wrong with this input.",
        .mistakes = {
            {"touching-refused", 2.0,
             "One of these touches a wall, and they touch each other. Is "
             "one of them not wholly inside, and do they overlap?"}});
    project_form(r, 3, 9, "Two disks: nine numbers.");
}

static void stage_special(void)
{
    struct scene one = draw_disks(1), two = draw_disks(2);
    struct scene past = draw_disks(2);
    one.tc = draw(0.1, 0.2);
    one.rows = 30;
    /* Head-on along x, at one height: they exchange their velocities. */
    two.start[5] = two.start[1];
    two.start[2] = draw(0.5, 1.0);
    two.start[6] = -draw(0.5, 1.0);
    two.start[3] = two.start[7] = 0.0;
    two.tc = draw(0.05, 0.1);
    two.rows = 30;
    /* One at rest is hit by a disk that would miss its centre. */
    past.start[5] = past.start[1] + draw(0.08, 0.12);
    past.start[2] = draw(0.5, 1.0);
    past.start[3] = past.start[6] = past.start[7] = 0.0;
    past.tc = draw(0.05, 0.1);
    past.rows = 20;
    check_read();
    check_touching();
    check_flight(one);
    check_flight(two);
    check_flight(past);
    check_inputs();
}

/* ---- stage 2 ---- */

static double energy(const double row[], int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        sum += row[3 + PER_DISK * i] * row[3 + PER_DISK * i] +
               row[4 + PER_DISK * i] * row[4 + PER_DISK * i];
    return sum / 2.0;
}

/* How deep disks overlap each other or a wall. */
static double depth(const double row[], int n, double r)
{
    double most = 0.0;
    for (int i = 0; i < n; ++i) {
        const double *a = row + 1 + PER_DISK * i;
        for (int c = 0; c < 2; ++c)
            most = fmax(most, fmax(r - a[c], a[c] - 1.0 + r));
        for (int j = 0; j < i; ++j) {
            const double *b = row + 1 + PER_DISK * j;
            most = fmax(most, 2.0 * r - hypot(a[0] - b[0], a[1] - b[1]));
        }
    }
    return most;
}

/* Beyond what can be known: energy and room. */
static void check_long(void)
{
    struct scene s = draw_disks(4);
    s.tc = draw(0.2, 0.3);
    s.rows = 2000;
    const struct run *r = run_program(order("fly", &s));
    project_form(r, 2001, 17, "Four disks: 17 numbers.");
    double change = 0.0, deepest = 0.0;
    for (int k = 0; k <= s.rows; ++k) {
        const double *row = r->numbers + 17 * k;
        change = fmax(change,
                      fabs(energy(row, 4) / energy(r->numbers, 4) - 1.0));
        deepest = fmax(deepest, depth(row, 4, s.r));
    }
    CHECK_NEAR(change, .quantity = "largest change of the energy",
               .tolerance = 1e-9,
               .because = "rounding of some thousand collisions",
               .question = "Which event changes the energy?");
    CHECK_NEAR(
        deepest, .quantity = "deepest overlap", .unit = "m",
        .tolerance = 1e-9, .because = "rounding",
        .equation = "eq:pair-time",
        .question =
            "Two disks, or a disk and a wall, are in each other. Which "
            "event was not seen: one that comes at once after another?");
}

static void stage_general(void)
{
    for (int n = 3; n <= 4; ++n) {
        struct scene s = draw_disks(n);
        s.tc = draw(0.05, 0.08);
        s.rows = 30;
        check_flight(s);
    }
    check_crowd();
    check_long();
}

/* ---- stage 3 ---- */

static void stage_clock(void)
{
    struct scene slow = draw_disks(1), busy = draw_disks(4);
    struct scene far = draw_disks(1);
    slow.tc = draw(0.01, 0.02);
    slow.rows = 200;
    busy.tc = draw(0.4, 0.5);
    busy.rows = 4;
    far.tc = draw(0.1, 0.2);
    far.rows = LONGEST;
    check_flight(slow);
    check_flight(busy);
    check_flight(far);
}

/* ---- what throws must give ---- */

/* (6.2, eq:two-disks) and (6.3, eq:two-profile), in a room of the side a,
   for a distance sigma of contact. */
static double fit(double a, double sigma)
{
    const double s = sigma / a;
    return 1.0 - acos(-1.0) * s * s + 8.0 / 3.0 * s * s * s -
           s * s * s * s / 2.0;
}

static double profile(double x, double a, double sigma)
{
    double kept_out = 0.0;
    for (int side = 0; side < 2; ++side) {
        const double t = fmin(side ? a - x : x, sigma);
        kept_out += (t * sqrt(sigma * sigma - t * t) +
                     sigma * sigma * asin(t / sigma)) /
                        a -
                    (sigma * sigma * t - t * t * t / 3.0) / (a * a);
    }
    return (1.0 - kept_out / a) / (fit(a, sigma) * a);
}

static double in_slice(int i, double a, double sigma)
{
    double sum = 0.0;
    for (int k = 0; k < 200; ++k)
        sum += profile((i + (k + 0.5) / 200.0) * a / SLICES, a, sigma);
    return sum / 200.0;
}

/* What comes of keeping the first disk and throwing the second again, in a
   slice: half of it is level. The other half is found by the same throws,
   from equidistant numbers that do not repeat: 40000 of them know it to one
   per cent. */
static double fitted_alone(int i, double a, double sigma)
{
    long in = 0;
    uint64_t state = 1;
    double u[4];
    for (int k = 0; k < 40000; ++k) {
        bool first = true;
        do {
            for (int c = first ? 0 : 2; c < 4; ++c) {
                state = state * 3935559000370003845u + 1u;
                u[c] = (double)(state >> 11) / 9007199254740992.0;
            }
            first = false;
        } while (hypot(u[0] - u[2], u[1] - u[3]) * a < sigma);
        const int slice = (int)(u[2] * SLICES);
        in += slice == i || slice == SLICES - 1 - i;
        in += (int)(u[3] * SLICES) == i ||
              (int)(u[3] * SLICES) == SLICES - 1 - i;
    }
    return 0.5 / a + (double)in / 160000.0 * SLICES / a / 2.0;
}

static const struct run_order *order_throw(int n, double r, int seed,
                                           int samples)
{
    static char words[4][32];
    static struct run_order o;
    snprintf(words[0], 32, "%d", n);
    snprintf(words[1], 32, "%.17g", r);
    snprintf(words[2], 32, "%d", seed);
    snprintf(words[3], 32, "%d", samples);
    o = (struct run_order){
        .arguments = {"throw", words[0], words[1], words[2], words[3]},
        .late =
            "How does your throwing end? What do you do when two overlap?",
    };
    return &o;
}

/* A histogram with all that stands under it. */
struct counted {
    double density[SLICES], error[SLICES];
    double ratio, its_error, looks;
};

static void count(const struct run_order *o, double r, struct counted *h)
{
    const struct run *run = run_program(o);
    project_form(
        run, SLICES, 3,
        "A row is the middle of a slice, the density in it and its error.");
    double all = 0.0, remark[2] = {NAN, NAN};
    for (int i = 0; i < SLICES; ++i) {
        const double *row = run->numbers + 3 * i;
        h->density[i] = row[1];
        h->error[i] = row[2];
        all += row[1] * (1.0 - 2.0 * r) / SLICES;
        CHECK_NEAR(row[0],
                   .quantity = check_text("the middle of slice %d", i + 1),
                   .unit = "m",
                   .expected = r + (i + 0.5) * (1.0 - 2.0 * r) / SLICES,
                   .tolerance = 1e-9, .question = "Where can a centre be?");
    }
    const int numbers = run_remark(run, "# ratio", remark, 2);
    const double q = (h->density[0] + h->density[SLICES - 1]) /
                     (h->density[6] + h->density[7]);
    const char *question = "How often does your program look at two disks, "
                           "and where does it count that?";
    h->ratio = remark[0];
    h->its_error = remark[1];
    h->looks = project_remark(run, "# looks", &question);
    CHECK_NEAR(all, .quantity = "the whole of the density", .expected = 1.0,
               .tolerance = 1e-6, .because = "each centre is somewhere",
               .question = "By what do you divide a count to get the "
                           "density of one coordinate?",
               .mistakes = {{"counts-of-all", 2.0,
                             "Together that is twice too much. How many "
                             "coordinates has a disk?"}});
    CHECK_NEAR(numbers, .quantity = "numbers behind # ratio",
               .expected = 2.0,
               .question = "The ratio and its error are asked for.");
    CHECK_NEAR(
        h->ratio, .quantity = "the ratio", .expected = q,
        .tolerance = 1e-6 * q,
        .because = "it was computed again from the table",
        .question = "Which slices are at a wall, and which in the middle?",
        .mistakes = {{"one-wall", q / 2.0,
                      "That is half of the ratio. How many slices are in "
                      "the middle, and how many at a wall?"}});
    CHECK_NEAR(h->looks > 0.0 || h->looks == 0.0,
               .quantity = "1 if # looks has a number", .expected = 1.0,
               .question = question);
}

static void check_thrown(int n, double r, int seed, int samples)
{
    const struct run_order *o = order_throw(n, r, seed, samples);
    const char *question =
        "Does every throw count, also the one that is thrown away?";
    const double a = 1.0 - 2.0 * r, width = a / SLICES;
    struct counted h;
    count(o, r, &h);
    const struct run *run = run_program(o);
    const double alpha = n == 1 ? 1.0 : fit(a, 2.0 * r);
    const double thrown = project_remark(run, "# thrown", &question);
    for (int i = 0; i < SLICES; ++i) {
        const double want = n == 1 ? 1.0 / a : in_slice(i, a, 2.0 * r);
        const double p = want * width;
        /* Of two disks a slice has rather less spread than of so many
           places that know nothing of each other. */
        const double spread =
            sqrt(p * (1.0 - p) / (2.0 * n * samples)) / width;
        struct check check = {
            .quantity = check_text("the density in slice %d", i + 1),
            .unit = "1/m",
            .expected = want,
            .tolerance = 6.5 * spread,
            .because = "6.5 of its errors",
            .equation = "eq:two-profile",
            .question = "Where may a centre be, and which throws are kept?",
        };
        if (n == 2 && fabs(h.density[i] - want) > check.tolerance) {
            project_mistake(&check, "thrown-alone",
                            fitted_alone(i, a, 2.0 * r),
                            "Only the disk that did not fit has been "
                            "thrown again. What must be thrown again, so "
                            "that all that is allowed is equally likely?");
            project_mistake(&check, "overlap-within-a-radius",
                            in_slice(i, a, r),
                            "These disks may overlap by half. At which "
                            "distance do two centres touch?");
            project_mistake(&check, "never-overlap-tested", 1.0 / a,
                            "The disks see nothing of each other. Which "
                            "throws are thrown away?");
        }
        const double word = h.error[i] / spread;
        const double of_one =
            fabs(word / sqrt(samples) - 1.0) < 0.35 ? word : NAN;
        check_near(h.density[i], check);
        CHECK_NEAR(
            word,
            .quantity = check_text("the error of slice %d, in units of "
                                   "that of independent places",
                                   i + 1),
            .expected = 1.0, .tolerance = 0.35,
            .because = "places of one throw are not quite independent",
            .question = "How many places does a throw bring, and how far "
                        "do two such runs differ?",
            .mistakes = {{"spread-of-one-throw", of_one,
                          "That is how far one throw differs from the "
                          "next. How sure is a mean of so many?"}});
    }
    CHECK_NEAR(thrown, .quantity = "# thrown", .expected = samples / alpha,
               .tolerance =
                   6.0 * sqrt(samples * (1.0 - alpha)) / alpha + 1e-6,
               .because = "six of its errors", .equation = "eq:two-disks",
               .question = question);
}

static void check_seeds(double r)
{
    struct counted a, b, again;
    count(order_throw(2, r, 1, 1000), r, &a);
    count(order_throw(2, r, 2, 1000), r, &b);
    count(order_throw(2, r, 1, 1000), r, &again);
    const bool same = !memcmp(a.density, b.density, sizeof a.density);
    CHECK_NEAR(
        same, .quantity = "1 if the seeds 1 and 2 give the same",
        .question = "What does your program do with SEED?",
        .mistakes = {
            {"seed-ignored", 1.0,
             "Two seeds have given one table. Where does SEED come in?"}});
    CHECK_NEAR(memcmp(a.density, again.density, sizeof a.density),
               .quantity = "0 if a seed gives the same table twice",
               .question =
                   "What else than SEED is your generator begun with?");
}

/* Inputs that make no sense, each with what is wrong with it. */
struct nonsense {
    const char *what, *disks, *words[6];
};
static void check_refusals(const struct nonsense all[])
{
    for (; all->what; ++all) {
        struct run_order o = {
            .late = "Which of these numbers is out of its bounds, and "
                    "where does your program look at it?"};
        for (int i = 0; i < 6; ++i)
            o.arguments[i] = all->words[i];
        if (all->disks)
            o.files[0] = (struct run_file){"disks.txt", all->disks};
        project_refuses(&o, all->what);
    }
}

/* limit: 2 samples */
/* Of so few, the table says nothing; but they are allowed. */
static void check_least(void)
{
    const struct run_order *o = order_throw(1, 0.1, 1, 2);
    CHECK_NEAR(run_program(o)->status,
               .quantity = "the status with which it ended",
               .question = "Two samples are few, and enough. Who refuses "
                           "them, or what breaks?");
}

static void stage_throws(void)
{
    static const struct nonsense all[] = {
        {"throws of no disk", NULL, {"throw", "0", "0.1", "1", "10"}},
        {"17 disks", NULL, {"throw", "17", "0.01", "1", "10"}},
        {"a radius of 1/4 m", NULL, {"throw", "2", "0.25", "1", "10"}},
        {"a SEED below 0", NULL, {"throw", "2", "0.1", "-1", "10"}},
        {"a SEED that is not whole",
         NULL,
         {"throw", "2", "0.1", "1.5", "10"}},
        {"one sample", NULL, {"throw", "2", "0.1", "1", "1"}},
        {"samples that are not whole",
         NULL,
         {"throw", "2", "0.1", "1", "2.5"}},
        {0}};
    const double r = draw(0.15, 0.2);
    struct counted most;
    check_thrown(1, draw(0.1, 0.2), 3, 20000);
    check_seeds(r);
    check_thrown(2, r, check_draw_whole(1, 1000), 100000);
    count(order_throw(16, 0.02, 1, 1000), 0.02, &most);
    check_least();
    check_refusals(all);
}

/* ---- stage 5 ---- */

/* The ratio for four disks, and its spread from throw to throw in units of
   it: at radii of 0.13, 0.135, ... 0.15 from 6e7 thrown configurations
   each, which know the ratio to 1.4e-4 of itself. */
enum { KNOWN = 5 };
static const double ratios[KNOWN] = {1.610423, 1.705055, 1.825135, 1.988063,
                                     2.226297};
static const double spreads[KNOWN] = {1.0899, 1.0722, 1.0585, 1.0551,
                                      1.0729};

static double between(const double known[KNOWN], double r)
{
    const double at = (r - 0.13) / 0.005;
    double sum = 0.0;
    for (int i = 0; i < KNOWN; ++i) {
        double share = 1.0;
        for (int j = 0; j < KNOWN; ++j)
            if (j != i)
                share *= (at - j) / (i - j);
        sum += share * known[i];
    }
    return sum;
}

/* The relative error of a run of 1000 s at a mean square of the speed of
   1 m^2/s^2, from 250 runs at each of three radii: 0.0157, 0.0135, 0.0143.
   Rows 0.02 s apart, were they independent, would have 0.0048. */
static const double flown = 0.0145;

/* That of the density in a slice, geometric mean over the slices, from 60
   runs at each of three radii: 0.0140, 0.0153, 0.0134; for independent rows
   and places it would be 0.0057. What 100 blocks state of it differs by two
   per cent from run to run. */
static const double flown_slice = 0.0142, slice_alone = 0.0057;

static void check_remarks(const struct run_order *o,
                          const struct counted *h)
{
    const char *question = "An error falls as the root of the work. How "
                           "much work is an error of one per cent?";
    const struct run *run = run_program(o);
    const double part = 100.0 * h->its_error / h->ratio;
    const double want = h->looks * part * part;
    const double got = project_remark(run, "# price", &question);
    CHECK_NEAR(got, .quantity = "the price of one per cent",
               .expected = want, .tolerance = 1e-6 * want,
               .because = "from the ratio, its error and the looks",
               .question = question,
               .mistakes = {{"price-without-square", h->looks * part,
                             "Twice the work does not halve an error. With "
                             "which power of the work does it fall?"}});
}

static void check_ratio(const struct counted *h, double want, double error)
{
    CHECK_NEAR(h->ratio, .quantity = "wall over middle", .expected = want,
               .tolerance = 6.5 * error,
               .because = "6.5 of the true errors of such a run",
               .equation = "eq:throw",
               .question = "Are these states of the clock, or throws of "
                           "all four at once?");
}

/* word: the mean logarithm of what four runs state, in units of the true
   error; the mistakes likewise, 0 where there is none, and as near. */
static void check_word(const char *what, double word, double slack,
                       double coordinates, double rows, double one)
{
    struct check check = {
        .quantity = check_text(
            "how many times too %s the errors of %s are, mean of four runs",
            word < 0.0 ? "small" : "large", what),
        .expected = 1.0,
        .tolerance = exp(slack) - 1.0,
        .because = "an error has an error",
        .equation = "eq:block",
        .question = "How far do runs with other seeds, or from other "
                    "starts, truly lie apart?",
    };
    if (rows != 0.0 && fabs(word - rows) < slack)
        project_mistake(
            &check, "rows-independent", exp(fabs(word)),
            "That is the error of rows that know nothing of each other. "
            "How long does a disk stay in a slice?");
    if (coordinates != 0.0 && fabs(word - coordinates) < slack)
        project_mistake(&check, "places-independent", exp(fabs(word)),
                        "That is the error of eight places that know "
                        "nothing of each other. Which unit is thrown?");
    if (one != 0.0 && fabs(word - one) < slack)
        project_mistake(&check, "spread-of-one-throw", exp(fabs(word)),
                        "That is how far one throw differs from the next. "
                        "How sure is a mean of so many?");
    /* In a flight: 1/sqrt(200) or more instead of the slices' error. */
    if (word > 1.3 && one == 0.0)
        project_mistake(&check, "size-for-spread", exp(word),
                        "Do your blocks differ so much, or are they so "
                        "large? From where is a spread measured?");
    check_near(exp(fabs(word)), check);
}

/* The looks that a flight lacks: a disk that has met another or a wall
   flies on another way, and meets the others at other times. */
static void check_flight_looks(const struct scene *s,
                               const struct counted *h)
{
    struct engine e = {.s = s};
    const long double end = (long double)s->rows * s->tc;
    for (int c = 0; c < 2 * s->n; ++c) {
        e.x[c] = s->start[PER_DISK * (c / 2) + c % 2];
        e.v[c] = s->start[PER_DISK * (c / 2) + 2 + c % 2];
    }
    for (long double now = 0.0L, wait; now < end; now += wait) {
        fly(&e, wait = next(&e));
        collide(&e);
    }
    const double each = round(h->looks / (double)e.pairs);
    CHECK_NEAR(
        fmax(0.0, 3.0 - each),
        .quantity = "looks that are missing, for each two that have met",
        .because = "both have other ways from then on, and two others each",
        .question = "Which looks are not counted?",
        .mistakes = {
            {"looks-of-collisions", 2.0,
             "There is one look for each collision. How did your program "
             "find out that no other pair was first?"},
            {"looks-of-events", 1.0,
             "There is one look for each event. At how many pairs has your "
             "program looked before it knew which event was next?"}});
}

/* A disk alone is where it must be in each row, and so are the counts. */
static void check_watched(void)
{
    static struct table want;
    struct scene s = draw_disks(1);
    struct counted h;
    s.tc = draw(0.1, 0.2);
    s.rows = 1000;
    simulate(&s, NONE, 0.0, &want);
    const double a = 1.0 - 2.0 * s.r, one = SLICES / a / (2.0 * s.rows);
    double in[3][SLICES] = {{0.0}}, unsure[SLICES] = {0.0};
    for (int k = 0; k <= s.rows; ++k)
        for (int c = 1; c <= 2; ++c) {
            const double at = (want.row[k][c] - s.r) / a * SLICES;
            const int i = (int)fmin(fmax(at, 0.0), SLICES - 1.0);
            in[0][i] += k > 0;
            in[1][i] += k < s.rows;
            in[2][i] += s.rows / (s.rows + 1.0);
            unsure[i] += fabs(at - round(at)) < 1e-6;
        }
    count(order("watch", &s), s.r, &h);
    for (int i = 0; i < SLICES; ++i) {
        struct check check = {
            .quantity = check_text("the density in slice %d", i + 1),
            .unit = "1/m",
            .expected = in[0][i] * one,
            .tolerance = (0.5 + unsure[i]) * one,
            .because = "half a count",
            .equation = "eq:disk-clock",
            .question = "One disk, 1000 rows, two coordinates in each: "
                        "2000 counts. Which are they?",
        };
        for (int k = 1; k <= 2; ++k)
            if (fabs(in[k][i] - in[0][i]) > 0.5)
                project_mistake(
                    &check, "row-0-counted", in[k][i] * one,
                    "The start was chosen, and has not come about. Which "
                    "row is the first to be counted, and which the last?");
        check_near(h.density[i], check);
    }
}

static struct scene draw_unit_speeds(double r)
{
    struct scene s = draw_disks(4);
    double sum = 0.0;
    for (int i = 0; i < 16; ++i)
        sum += i % 4 < 2 ? 0.0 : s.start[i] * s.start[i];
    for (int i = 0; i < 16; ++i)
        s.start[i] *= i % 4 < 2 ? 1.0 : sqrt(4.0 / sum);
    s.r = r;
    s.tc = 0.02;
    s.rows = 50000;
    return s;
}

/* limit: 1000 rows to watch */
static const struct nonsense few_rows[] = {
    {"999 rows to watch",
     "0.5 0.5 1 0.3\n",
     {"watch", "disks.txt", "0.1", "0.1", "999"}},
    {0}};

static void stage_ratio(void)
{
    enum { SAMPLES = 10000, RUNS = 4 };
    const double r = draw(0.13, 0.15), q = between(ratios, r);
    const double thrown = between(spreads, r) / sqrt(SAMPLES);
    const int seed = check_draw_whole(1, 1000);
    const char *question = "How many throws did it take?";
    struct counted h[2];
    double word = 0.0, slices = 0.0;
    check_watched();
    check_refusals(few_rows);
    for (int k = 0; k < RUNS; ++k) {
        const struct run_order *o = order_throw(4, r, seed + k, SAMPLES);
        count(o, r, &h[0]);
        check_ratio(&h[0], q, q * thrown);
        check_remarks(o, &h[0]);
        const double all =
            project_remark(run_program(o), "# thrown", &question);
        /* There must have been this many looks at pairs, or more. */
        CHECK_NEAR(
            fmax(0.0, 5.0 * SAMPLES + all - h[0].looks),
            .quantity = "looks at a pair that are not counted",
            .because = "a throw that is kept has six pairs, and one that "
                       "is not was looked at, too",
            .question = "Which looks are not counted?",
            .mistakes = {
                {"looks-of-the-kept", all - SAMPLES,
                 "These are the looks at what was kept. How did your "
                 "program find out that it would not keep the others?"}});
        word += log(h[0].its_error / h[0].ratio / thrown) / RUNS;
    }
    /* What it would be if a count were as sure as that of so many throws
       of a coin. */
    const double in_middle = 2.0 / SLICES * 0.75, at_wall = q * in_middle;
    const double coins =
        sqrt((1.0 / at_wall + 1.0 / in_middle) / (8.0 * SAMPLES));
    check_word("the ratio", word, 0.12, log(coins / thrown), 0.0,
               log(SAMPLES) / 2.0);
    word = 0.0;
    for (int k = 0; k < RUNS; ++k) {
        const struct scene s = draw_unit_speeds(r);
        const struct run_order *o = order("watch", &s);
        count(o, r, &h[1]);
        check_ratio(&h[1], q, q * flown);
        check_remarks(o, &h[1]);
        check_flight_looks(&s, &h[1]);
        word += log(h[1].its_error / h[1].ratio / flown) / RUNS;
        for (int i = 0; i < SLICES; ++i)
            slices += log(h[1].error[i] / h[1].density[i] / flown_slice) /
                      SLICES / RUNS;
    }
    check_word("the ratio", word, 0.36, 0.0,
               log(between(spreads, r) / sqrt(50000.0) / flown), 0.0);
    check_word("the densities", slices, 0.36, 0.0,
               log(slice_alone / flown_slice), 0.0);
    for (int i = 0; i < SLICES; ++i)
        CHECK_NEAR(
            h[1].density[i],
            .quantity =
                check_text("the density of flight in slice %d", i + 1),
            .unit = "1/m", .expected = h[0].density[i],
            .tolerance = 7.0 * hypot(h[0].error[i], h[1].error[i]),
            .because = "seven of your errors, from that of your throws",
            .equation = "eq:throw",
            .question = "Which of the two is wrong at a wall: which states "
                        "are counted?");
}

/* ---- stage 6 ---- */

/* (6.11, eq:canonical) with (6.14, eq:lens). */
static double law(double s, int n, double reach, bool power)
{
    double lens = 0.0;
    if (s < 2.0 * reach)
        lens = 2.0 * reach * reach * acos(s / 2.0 / reach) -
               s / 2.0 * sqrt(4.0 * reach * reach - s * s);
    const double far = 1.0 - 2.0 * acos(-1.0) * reach * reach;
    return s * (power ? pow(1.0 + lens / far, n) : exp(n * lens / far));
}

static double of_ring(int i, double r, int n, double reach, bool power,
                      bool without_s)
{
    enum { PARTS = 1000 };
    const double width = (0.5 - 2.0 * r) / RINGS;
    double all = 0.0, mine = 0.0;
    for (int k = 0; k < RINGS * PARTS; ++k) {
        const double s = 2.0 * r + (k + 0.5) * width / PARTS;
        const double p = law(s, n, reach, power) / (without_s ? s : 1.0);
        all += p;
        if (k / PARTS == i)
            mine += p;
    }
    return mine / all / width;
}

static void check_pair(int n, double r, double small)
{
    enum { SAMPLES = 16000 };
    const double width = (0.5 - 2.0 * r) / RINGS;
    char words[5][32];
    snprintf(words[0], 32, "%d", n);
    snprintf(words[1], 32, "%.17g", r);
    snprintf(words[2], 32, "%.17g", small);
    snprintf(words[3], 32, "%d", check_draw_whole(1, 1000));
    snprintf(words[4], 32, "%d", SAMPLES);
    const struct run_order o = {
        .arguments = {"pair", words[0], words[1], words[2], words[3],
                      words[4]},
        .late = "How many small ones do you throw before you look at the "
                "first?",
    };
    const struct run *run = run_program(&o);
    project_form(
        run, RINGS, 5,
        "A row is the ends of a slice, density, error and theory.");
    for (int i = 0; i < RINGS; ++i) {
        const double *row = run->numbers + 5 * i;
        const double low = 2.0 * r + i * width;
        const double want = of_ring(i, r, n, r + small, true, false);
        const double level = of_ring(i, r, 0, r + small, true, false);
        const double p = want * width;
        const double spread = sqrt(p * (1.0 - p) / SAMPLES) / width;
        struct check theory = {
            .quantity = check_text("the theory of slice %d", i + 1),
            .unit = "1/m",
            .expected = want,
            .tolerance = 1e-6 * want,
            .because = "a mean over the slice",
            .equation = "eq:canonical",
            .question = "Take special cases: what is left without small "
                        "ones, and far apart?",
        };
        struct check run_of_it = {
            .quantity = check_text("P in slice %d", i + 1),
            .unit = "1/m",
            .expected = want,
            .tolerance = 6.5 * spread,
            .because = "6.5 of its errors",
            .equation = "eq:canonical",
            .question = "Where may the centre of a small one be, and what "
                        "is thrown again when one does not fit?",
        };
        if (fabs(row[4] - want) > theory.tolerance) {
            project_mistake(&theory, "without-circumference",
                            of_ring(i, r, n, r + small, true, true),
                            "Two places at the distance s: on which line "
                            "does the second lie, and how long is it?");
            project_mistake(&theory, "infinite-box",
                            of_ring(i, r, n, r + small, false, false),
                            "That is the limit of many small ones in a "
                            "large box. What is exact for so many?");
            project_mistake(&theory, "reach-of-two-radii",
                            of_ring(i, r, n, r + 2.0 * small, true, false),
                            "How near may the centre of a small one come "
                            "to that of a big one?");
        }
        if (n > 0)
            project_mistake(
                &run_of_it, "no-force-from-room", level,
                "All distances are as likely as without small ones. If one "
                "does not fit, what must be thrown again: that one, or "
                "all, the big ones too?");
        CHECK_NEAR(
            fmax(fabs(row[0] - low), fabs(row[1] - low - width)),
            .quantity =
                check_text("how far the ends of slice %d are off", i + 1),
            .unit = "m", .tolerance = 1e-9,
            .question =
                "From which distance to which do the ten slices go?");
        check_near(row[4], theory);
        check_near(row[2], run_of_it);
        CHECK_NEAR(
            row[3] / spread,
            .quantity = check_text(
                "the error in slice %d, in units of the true one", i + 1),
            .expected = 1.0, .tolerance = 0.25,
            .because = "it follows from the number of samples",
            .question = "SAMPLES are kept: from how many does this table "
                        "come? Each of them is in this slice or not, and "
                        "knows nothing of the others.");
    }
}

static void stage_pair(void)
{
    static const struct nonsense all[] = {
        {"a big one and a small one as wide as 0.3 m",
         NULL,
         {"pair", "3", "0.1", "0.2", "1", "10"}},
        {"N below 0", NULL, {"pair", "-1", "0.1", "0.1", "1", "10"}},
        {"a SMALL below 0", NULL, {"pair", "3", "0.1", "-0.1", "1", "10"}},
        {0}};
    const double r = draw(0.09, 0.1), small = draw(0.07, 0.08);
    check_pair(0, r, small);
    check_pair(check_draw_whole(18, 22), r, small);
    check_refusals(all);
}

const struct check_suite check_suite = {
    .file = "P2-disks.c",
    .title = "Disks",
    .minutes = 270,
    .tests = {{"1 special cases: one disk, and two that meet",
               stage_special, 4, 0},
              {"2 then generalize: four disks by events", stage_general, 6,
               3},
              {"3 the clock: rows neither drift nor sit on events",
               stage_clock, 3, 0},
              {"4 throw: all again if two overlap", stage_throws, 4, 2},
              {"5 wall and middle: two errors that keep their word",
               stage_ratio, 5, 0},
              {"6 a force made of room: two big ones among small ones",
               stage_pair, 3, 0},
              {0}},
};
