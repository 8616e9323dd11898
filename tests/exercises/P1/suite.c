/* Project P1: rows of a whole program, stage by stage. */
#include "examiner/project.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 10, COLUMNS = 2 + 2 * MOST, TEXT = 1000 };

struct scene {
    int n;
    double m[MOST], x[MOST], v[MOST];
    double length, g, tc;
    int rows;
};

/* Ways to go wrong, of which the suite knows where they lead. */
enum fault { NONE, RECEDING, PULLED, KEPT, FALLING, FAULTS };

/* What must come out. */
struct table {
    double *rows;   /* t E x1 v1 ... */
    double *events; /* when something happened, as many as there are rows */
    long collisions, bounces;
    long high;      /* bounces at the upper stop */
    double nearest; /* how near an event comes to a row */
};

struct engine {
    const struct scene *s;
    enum fault fault;
    long double x[MOST], v[MOST];
};

static long double stop_below(const struct engine *e)
{
    const long double g = e->s->g, x = e->x[0], v = e->v[0];
    if (g == 0.0L)
        return v < 0.0L ? x / -v : INFINITY;
    const long double speed = sqrtl(fmaxl(v * v + 2.0L * g * x, 0.0L));
    if (e->fault == FALLING)
        return v - speed > 0.0L ? (v - speed) / g : INFINITY;
    const long double t =
        v > 0.0L ? (v + speed) / g : 2.0L * x / (speed - v);
    return t > 0.0L ? t : INFINITY;
}

static long double stop_above(const struct engine *e)
{
    const int top = e->s->n - 1;
    const long double room = e->s->length - e->x[top], v = e->v[top];
    const long double left = v * v - 2.0L * e->s->g * room;
    if (isinf(e->s->length) || v <= 0.0L || left < 0.0L)
        return INFINITY;
    return 2.0L * room / (v + sqrtl(left));
}

static long double pair(const struct engine *e, int i)
{
    const long double gap = fmaxl(e->x[i + 1] - e->x[i], 0.0L);
    const long double closing = e->v[i] - e->v[i + 1], g = e->s->g;
    if (e->fault == RECEDING)
        return gap > 1e-9L && closing != 0.0L ? gap / fabsl(closing)
                                              : INFINITY;
    if (e->fault == PULLED && g > 0.0L) {
        const long double root = sqrtl(closing * closing + 2.0L * g * gap);
        const long double t = (root - closing) / g;
        return gap > 1e-9L ? t : INFINITY;
    }
    return closing > 0.0L ? gap / closing : INFINITY;
}

/* The next event: its time from now, and which; pair i, or n for the stop
   below and n + 1 for the one above. */
static int next(const struct engine *e, long double *wait)
{
    const int n = e->s->n;
    int which = n;
    *wait = stop_below(e);
    if (stop_above(e) < *wait) {
        *wait = stop_above(e);
        which = n + 1;
    }
    for (int i = 0; i + 1 < n; ++i)
        if (pair(e, i) < *wait) {
            *wait = pair(e, i);
            which = i;
        }
    return which;
}

static void glide(struct engine *e, long double t)
{
    for (int i = 0; i < e->s->n; ++i) {
        e->x[i] += e->v[i] * t - e->s->g * t * t / 2.0L;
        if (e->fault != KEPT)
            e->v[i] -= e->s->g * t;
    }
}

static void happen(struct engine *e, int which)
{
    const int n = e->s->n, at = which == n ? 0 : n - 1;
    if (which >= n) {
        e->x[at] = which == n ? 0.0L : e->s->length;
        e->v[at] = -e->v[at];
        return;
    }
    const long double a = e->s->m[which], b = e->s->m[which + 1];
    const long double v = e->v[which], w = e->v[which + 1];
    const long double blow = 2.0L * a * b / (a + b) * (v - w);
    e->v[which] = v - blow / a;
    e->v[which + 1] = w + blow / b;
    if (e->fault == NONE)
        e->x[which + 1] = e->x[which];
}

static void put_row(const struct engine *e, double t, double *row)
{
    long double energy = 0.0L;
    for (int i = 0; i < e->s->n; ++i) {
        energy +=
            e->s->m[i] * (e->v[i] * e->v[i] / 2.0L + e->s->g * e->x[i]);
        row[2 + 2 * i] = (double)e->x[i];
        row[3 + 2 * i] = (double)e->v[i];
    }
    row[0] = t;
    row[1] = (double)energy;
}

static void simulate(const struct scene *s, enum fault fault,
                     struct table *t)
{
    enum { PATIENCE = 100000 };
    struct engine e = {.s = s, .fault = fault};
    const int columns = 2 + 2 * s->n;
    long double now = 0.0L;
    int events = 0;
    t->collisions = t->bounces = t->high = 0;
    t->nearest = 1.0;
    t->rows = realloc(t->rows, sizeof *t->rows * (size_t)columns *
                                   (size_t)(s->rows + 1));
    t->events =
        realloc(t->events, sizeof *t->events * (size_t)(s->rows + 1));
    for (int k = 0; k <= s->rows; ++k)
        t->events[k] = NAN;
    t->events[0] = 0.0;
    for (int i = 0; i < s->n; ++i) {
        e.x[i] = s->x[i];
        e.v[i] = s->v[i];
    }
    for (int k = 0; k <= s->rows; ++k) {
        long double wait;
        int which;
        while (which = next(&e, &wait),
               now + wait <= k * (long double)s->tc) {
            if (++events > PATIENCE)
                return;
            glide(&e, wait);
            now += wait;
            happen(&e, which);
            ++*(which < s->n - 1 ? &t->collisions : &t->bounces);
            t->high += which > s->n;
            if (events <= s->rows)
                t->events[events] = (double)now;
            const double off = remainder((double)now, s->tc);
            t->nearest = fmin(t->nearest, fabs(off) / s->tc);
        }
        glide(&e, k * (long double)s->tc - now);
        now = k * (long double)s->tc;
        put_row(&e, k * s->tc, t->rows + k * columns);
    }
}

/* What is run, as text. */
static const struct run_order *order(const struct scene *s, int given,
                                     const char *late)
{
    static char beads[TEXT], words[4][32];
    static struct run_order o;
    int at = 0;
    for (int i = 0; i < s->n; ++i)
        at += snprintf(beads + at, TEXT - (size_t)at, "%.10g %.10g %.10g\n",
                       s->m[i], s->x[i], s->v[i]);
    snprintf(words[0], 32, "%.10g", s->length);
    snprintf(words[1], 32, "%.10g", s->g);
    snprintf(words[2], 32, "%.10g", s->tc);
    snprintf(words[3], 32, "%d", s->rows);
    o = (struct run_order){
        .arguments = {"beads.txt", words[0], words[1], words[2], words[3]},
        .files = {{"beads.txt", beads}},
        .given = given,
        .late = late,
    };
    return &o;
}

static const char for_ever[] =
    "How does the time to the next event come to be 0 again and again? "
    "Print it, and which event it is.";
static void check_form(const struct scene *s, const struct run *r)
{
    project_form(r, (size_t)s->rows + 1, 2 + 2 * (size_t)s->n,
                 "A row is t, E, and x and v of each bead. Which of them "
                 "is missing, or what is there besides?");
}

/* Whether a bead alone comes back from its stop with less than it had. */
static bool leaks(const struct scene *s, const double *want,
                  const double *got)
{
    return s->n == 1 && s->g == 0.0 && got[1] < want[1] * (1.0 - 1e-11) &&
           got[1] > want[1] / 4.0;
}

/* What those get who make a mistake, at this row and this column. */
static void mistakes(struct check *w, const struct scene *s,
                     const struct table *t, const struct run *r, int k,
                     int c)
{
    static const struct {
        const char *name, *hint;
    } faults[] = {
        [RECEDING] = {"receding-pair",
                      "Two beads that go apart have met here. What must "
                      "the sign of their relative velocity be?"},
        [PULLED] = {"gravity-in-pair-time",
                    "The pairs meet too early or too late. Both beads "
                    "fall: write down how their distance changes with "
                    "time. What becomes of g?"},
        [KEPT] = {"velocity-kept",
                  "The places fall, and the velocities stay as they were. "
                  "Which of them changes between two events?"},
        [FALLING] =
            {"wrong-root",
             "The bead falls through its stop. A quadratic equation has "
             "two roots: which of them lies in the future?"},
    };
    static const char digits[] =
        "These digits have been cut off. Do you print with %.17g?";
    const int columns = 2 + 2 * s->n;
    const double *want = t->rows + k * columns;
    const double *got = r->numbers + k * columns;
    project_mistake(w, "printed-short", project_cut("%g", want[c]), digits);
    project_mistake(w, "printed-short", project_cut("%f", want[c]), digits);
    project_mistake(w, "printed-short", project_cut("%.15f", want[c]),
                    digits);
    if (c == 0) {
        double sum = 0.0;
        for (int i = 0; i < k; ++i)
            sum += s->tc;
        project_mistake(w, "rows-at-collisions", t->events[k],
                        "This is the time of an event, and not of the "
                        "clock. How does your program come to be at a "
                        "row's time, in the middle of a flight?");
        project_mistake(
            w, "clock-adds-up", sum,
            "Each addition of TC is rounded, and the clock drifts. How do "
            "you get the time of row k with one rounding?");
        return;
    }
    if (leaks(s, want, got))
        project_mistake(
            w, "wall-with-a-mass", got[c],
            "A little energy has stayed in the stop. What is the velocity "
            "after a stop that nothing can move, without any mass?");
    if (s->g > 0.0 && s->g < 1e-8)
        project_mistake(
            w, "small-g-cancels", got[c],
            "With hardly any gravity everything is as on a flat wire. "
            "Which difference of two nearly equal numbers do you take?");
    if (s->g == 1e-6) {
        struct scene none = *s;
        static struct table level;
        none.g = 0.0;
        simulate(&none, NONE, &level);
        project_mistake(w, "small-g-dropped", level.rows[k * columns + c],
                        "This g is small, and not 0. Below which one do "
                        "you leave it out, and what for?");
    }
    for (enum fault f = RECEDING; f < FAULTS; ++f) {
        static struct table other;
        if (s->g == 0.0 && f != RECEDING)
            continue;
        simulate(s, f, &other);
        project_mistake(w, faults[f].name, other.rows[k * columns + c],
                        faults[f].hint);
    }
}

/* Compares row by row; the energy, which is made of the others, last. */
static void check_rows(const struct scene *s, const struct table *t,
                       const struct run *r, double slack,
                       const char *question)
{
    const int columns = 2 + 2 * s->n;
    double size[COLUMNS] = {0.0};
    for (int k = 0; k <= s->rows; ++k)
        for (int c = 0; c < columns; ++c)
            size[c < 2 ? c : c % 2] = fmax(size[c < 2 ? c : c % 2],
                                           fabs(t->rows[k * columns + c]));
    for (int k = 0; k <= s->rows; ++k)
        for (int step = 0; step < columns; ++step) {
            const int c = step == 0             ? 0
                          : step == columns - 1 ? 1
                                                : step + 1;
            const double want = t->rows[k * columns + c];
            const double got = r->numbers[k * columns + c];
            const double scale = c < 2 ? size[c] : size[c % 2];
            const double most = c == 0 ? 1e-9 * s->tc : slack * scale;
            if (fabs(got - want) <= most)
                continue;
            struct check check = {
                .quantity = check_text("%s%.0d in row %d, at %.10g s",
                                       c == 0   ? "t"
                                       : c == 1 ? "E"
                                       : c % 2  ? "v"
                                                : "x",
                                       c < 2 ? 0 : c / 2, k, k * s->tc),
                .unit = c == 0   ? "s"
                        : c == 1 ? "J"
                        : c % 2  ? "m/s"
                                 : "m",
                .expected = want,
                .tolerance = most,
                .because = "rounding, and what the collisions make of it",
                .equation = "eq:gap-time",
                .question = c != 1 ? question
                            : s->g > 0.0
                                ? "All places and velocities are right. "
                                  "What does a height add to the energy?"
                                : "All velocities are right. What is the "
                                  "energy made of?",
            };
            mistakes(&check, s, t, r, k, c);
            check_near(got, check);
        }
}

static void check_remark(const struct run *r, const char *words,
                         double want, const char *question)
{
    const double got = project_remark(r, words, &question);
    CHECK_NEAR(got, .quantity = words, .expected = want,
               .equation = "eq:gap-time", .question = question);
}

/* Runs a scene and compares all of it. */
static void check_scene(const struct scene *s, double slack, bool counts,
                        const char *question)
{
    static struct table t;
    const struct run *r = run_program(order(
        s, 0,
        s->g > 0.0 ? "A bead that has just left the stop is at 0, and 0 is "
                     "a root of its equation. Which of the two roots is "
                     "the bounce to come? [root-zero-again]"
                   : for_ever));
    simulate(s, NONE, &t);
    check_form(s, r);
    check_rows(s, &t, r, slack, question);
    if (counts) {
        check_remark(r, "# collisions", (double)t.collisions,
                     "The rows are right. What do you count as a "
                     "collision: pairs, and nothing else?");
        check_remark(r, "# bounces", (double)t.bounces,
                     "The rows are right. What do you count as a bounce: "
                     "both stops?");
    }
}

/* A bead in each n-th of the wire, in another place each year. */
static struct scene draw_scene(int n, double length, double g, bool equal)
{
    struct scene s = {.n = n, .length = length, .g = g};
    const double part = isinf(length) ? 1.0 : length / n;
    const double mass = draw(0.5, 3.0);
    for (int i = 0; i < n; ++i) {
        s.m[i] = equal ? mass : draw(0.5, 8.0);
        s.x[i] = draw((i + 0.1) * part, (i + 0.9) * part);
        s.v[i] = draw(0.3, 1.5) * either_sign();
    }
    return s;
}

/* The same, with rows at which nobody touches anything. */
static struct scene draw_apart(int n, double length, double g, bool equal,
                               int rows)
{
    static struct table t;
    struct scene s;
    do {
        s = draw_scene(n, length, g, equal);
        s.tc = draw(0.08, 0.2);
        s.rows = rows;
        simulate(&s, NONE, &t);
    } while (t.nearest < 1e-5);
    return s;
}

static void stage_special(void)
{
    const struct scene one = draw_apart(1, draw(1.0, 3.0), 0.0, true, 60);
    const struct scene five = draw_apart(5, draw(2.0, 4.0), 0.0, true, 60);
    check_scene(&one, 1e-10, false,
                "A bead alone goes to and fro. When is it at a stop, and "
                "what does the stop change?");
    check_scene(&five, 1e-10, true,
                "Beads of equal mass pass through each other, if nobody "
                "looks at their numbers. Where would they be then?");
}

/* Beads that lie where the contract lets them lie, as their file has it. */
static void check_read(const struct scene *s, const char *beads)
{
    static struct table t;
    struct run_order o = *order(s, 0, for_ever);
    o.files[0].text = beads;
    const struct run *r = run_program(&o);
    simulate(s, NONE, &t);
    project_reads(r, "A remark may fill a line, a line may be empty, a "
                     "bead may lie on a stop, and two may share a place. "
                     "Which of these does your program refuse?");
    check_form(s, r);
    check_rows(s, &t, r, 1e-9,
               "Two beads in one place meet only if they come nearer. "
               "Which velocities say so?");
}

/* Two in one place, two at the stops, remarks and an empty line. */
static void check_places(void)
{
    const struct scene s = {.n = 4,
                            .m = {1.0, 2.0, 3.0, 4.0},
                            .x = {0.0, 0.5, 0.5, 1.0},
                            .v = {1.0, -0.5, 0.25, -1.0},
                            .length = 1.0,
                            .tc = 0.07,
                            .rows = 20};
    check_read(&s, "# m x v\n\n1 0 1 # on its stop\n2 0.5 -0.5\n  # and "
                   "another there\n3 0.5 0.25\n4 1 -1\n");
}

/* Two that fly as one: only one of them can be first at a stop. */
static void check_abreast(void)
{
    struct scene s = {.n = 2,
                      .m = {1.0, 2.0},
                      .x = {0.5, 0.5},
                      .v = {1.0, 1.0},
                      .length = 1.0,
                      .tc = 0.07,
                      .rows = 10};
    check_read(&s, "1 0.5 1\n2 0.5 1\n");
    s.v[0] = s.v[1] = -1.0;
    check_read(&s, "1 0.5 -1\n2 0.5 -1\n");
}

/* limit: 64 beads */
/* As many beads as there may be. */
static void check_crowd(void)
{
    enum { CROWD = 64 };
    static char beads[64 * CROWD];
    const struct scene s = {
        .n = CROWD, .length = CROWD, .tc = 0.5, .rows = 20};
    struct run_order o = *order(&(struct scene){0}, 0, for_ever);
    const char *const words[] = {"64", "0", "0.5", "20"};
    for (int i = 0, at = 0; i < CROWD; ++i)
        at += snprintf(beads + at, sizeof beads - (size_t)at,
                       "%d %d.5 %d\n", 1 + i % 3, i, i % 2 ? -1 : 1);
    o.files[0].text = beads;
    memcpy(o.arguments + 1, words, sizeof words);
    check_form(&s, run_program(&o));
}

/* An input that makes no sense: beads, or one of the words behind them. */
struct nonsense {
    const char *what, *beads;
    enum { LENGTH, G, TC, ROWS } which;
    const char *word; /* NULL: all words are fine */
};

static void check_refused(const struct nonsense *bad)
{
    const char *words[] = {"1", "0", "0.1", "3"};
    if (bad->word)
        words[bad->which] = bad->word;
    const struct run_order o = {
        .arguments = {"beads.txt", words[0], words[1], words[2], words[3]},
        .files = {{bad->beads ? "beads.txt" : NULL, bad->beads}},
        .late = for_ever,
    };
    project_refuses(&o, bad->what);
}

static void check_inputs(void)
{
    static const char one[] = "1 0.5 1\n";
    static const struct nonsense all[] = {
        {"a file without beads", "# nobody\n", 0, NULL},
        {"a mass of 0", "0 0.5 1\n", 0, NULL},
        {"a place outside", "1 1.5 1\n", 0, NULL},
        {"places out of order", "1 0.5 1\n1 0.4 1\n", 0, NULL},
        {"a place below 0", "1 -0.1 1\n", 0, NULL},
        {"a line with a word", "1 0.5 fast\n", 0, NULL},
        {"a letter behind a number", "1 0.5 1x\n", 0, NULL},
        {"a line with four numbers", "1 0.5 1 1\n", 0, NULL},
        {"a mass that is no number", "nan 0.5 1\n", 0, NULL},
        {"a mass that is not finite", "inf 0.5 1\n", 0, NULL},
        {"a place that is not finite", "1 inf 1\n", LENGTH, "inf"},
        {"a velocity that is not finite", "1 0.5 inf\n", 0, NULL},
        {"ROWS that are no number", one, ROWS, "three"},
        {"a clock that goes backwards", one, TC, "-0.1"},
        {"a clock that stands still", one, TC, "0"},
        {"a wire of no length", "1 0 1\n", LENGTH, "0"},
        {"a G below 0", one, G, "-1"},
        {"a G that is no number", one, G, "down"},
        {"ROWS below 0", one, ROWS, "-1"},
        {"ROWS that are not whole", one, ROWS, "2.5"},
        {"ROWS that are an empty word", one, ROWS, ""},
        {"a letter behind ROWS", one, ROWS, "3x"},
        {"a unit behind LENGTH", one, LENGTH, "1m"},
        {"a G that is an empty word", one, G, ""},
        {"a file that is not there", NULL, 0, NULL}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        check_refused(&all[k]);
}

/* Too long to be compared: nothing may be lost, and nobody may pass. */
static void check_long(void)
{
    struct scene s = draw_scene(MOST, draw(1.0, 2.0), 0.0, false);
    s.tc = 0.5;
    s.rows = 2000;
    const struct run *r = run_program(order(&s, 0, for_ever));
    check_form(&s, r);
    for (size_t k = 0; k < r->rows; ++k) {
        const double *row = r->numbers + k * r->columns;
        double last = 0.0, energy = 0.0;
        for (int i = 0; i < s.n; ++i) {
            const double here = row[2 + 2 * i];
            energy += s.m[i] * row[3 + 2 * i] * row[3 + 2 * i] / 2.0;
            CHECK_NEAR(here < last - 1e-9 ? here - last : 0.0,
                       .quantity =
                           check_text("how far bead %d has passed its "
                                      "neighbour or its stop in row %zu",
                                      i + 1, k),
                       .unit = "m", .equation = "eq:gap-time",
                       .question = "Which collision was missed?");
            last = here;
        }
        const double off = last > s.length + 1e-9 ? last - s.length : 0.0;
        CHECK_NEAR(off,
                   .quantity = check_text(
                       "how far the last bead is outside in row %zu", k),
                   .unit = "m", .equation = "eq:gap-time",
                   .question = "Which bounce was missed?");
        CHECK_NEAR(
            energy,
            .quantity =
                check_text("the energy of the velocities in row %zu", k),
            .unit = "J", .expected = r->numbers[1],
            .tolerance = 1e-9 * fabs(r->numbers[1]),
            .because = "rounding in each of the collisions",
            .equation = "eq:energy",
            .question =
                "Which event changes the energy? Print it after each.");
    }
}

static void check_galperin(void)
{
    const struct scene s = {.n = 2,
                            .m = {1.0, 10000.0},
                            .x = {1.0, 2.0},
                            .v = {0.0, -1.0},
                            .length = INFINITY,
                            .tc = 0.5,
                            .rows = 40};
    const struct run *r = run_program(order(&s, 0, for_ever));
    double pairs = NAN, stops = NAN;
    check_form(&s, r);
    run_remark(r, "# collisions", &pairs, 1);
    run_remark(r, "# bounces", &stops, 1);
    CHECK_NEAR(pairs + stops, .quantity = "collisions and bounces",
               .expected = 314.0, .because = "they can be counted on paper",
               .equation = "eq:galperin",
               .question =
                   "Behind # collisions and # bounces stand their numbers. "
                   "Is every pair, and every stop, counted once? And if "
                   "LENGTH is inf, where is the upper stop?");
}

static void stage_general(void)
{
    const struct scene s = draw_apart(6, draw(1.5, 3.0), 0.0, false, 30);
    check_scene(&s, 1e-7, true,
                "One bead alone and equal masses are right. Which event "
                "comes first, and who takes part in it?");
    check_galperin();
    check_long();
    check_places();
    check_abreast();
    check_crowd();
    check_inputs();
}

/* Whether all times are k TC with 15 digits, or with so many behind the
   point: in one row alone a sum might have the same. */
static bool short_times(const struct run *r, double tc, int rows)
{
    bool digits = true, places = true;
    for (int k = 0; k <= rows; ++k) {
        const double got = r->numbers[4 * k];
        digits =
            digits && !(fabs(got - project_cut("%.15g", k * tc)) > 0.0);
        places =
            places && !(fabs(got - project_cut("%.15f", k * tc)) > 0.0);
    }
    return digits || places;
}

static void stage_clock(void)
{
    enum { ROWS = 50000 };
    struct scene s = draw_scene(1, draw(1.0, 3.0), 0.0, true);
    s.tc = 0.1;
    s.rows = ROWS;
    const struct run *r = run_program(order(&s, 0, for_ever));
    check_form(&s, r);
    const bool cut = short_times(r, s.tc, ROWS);
    double sum = 0.0;
    for (int k = 0; k <= ROWS; ++k, sum += s.tc)
        CHECK_NEAR(
            r->numbers[4 * k] - k * s.tc,
            .quantity = check_text("t in row %d, less %d TC", k, k),
            .unit = "s", .because = "k TC is one multiplication",
            .equation = "eq:clock",
            .question =
                "How does the program know what time it is in this row?",
            .mistakes = {
                {"printed-short", cut ? r->numbers[4 * k] - k * s.tc : 0.0,
                 "The last digits of the times are cut off. Do you print "
                 "with %.17g?"},
                {"clock-adds-up", sum - k * s.tc,
                 "Each addition of TC is rounded, and the clock drifts. "
                 "How do you get the time of row k with one rounding?"}});
    for (int k = 0; k <= ROWS; k += 100) {
        const double way = s.x[0] + s.v[0] * (k * s.tc);
        const double off = fabs(remainder(way, 2.0 * s.length));
        CHECK_NEAR(r->numbers[4 * k + 2],
                   .quantity = check_text("x1 in row %d", k), .unit = "m",
                   .expected = off, .tolerance = 1e-8,
                   .because = "ten thousand bounces, each rounded",
                   .equation = "eq:clock",
                   .question = "The times are right. From which time on "
                               "has this bead been flying?");
    }
}

/* Pairs that meet with no momentum, from light ones to heavy ones: the sums
   are rounded, and the rounding is no part of the momentum. */
static struct scene draw_pairs(void)
{
    struct scene s = {.n = MOST, .length = 50.0, .tc = 0.02, .rows = 10};
    for (int i = 0; i < MOST; i += 2) {
        const double unit = i < 2 ? 1e-9 : i < 4 ? 1.0 : 1e9;
        const double a = draw(0.5, 8.0), b = draw(0.5, 8.0);
        s.m[i] = a * unit;
        s.m[i + 1] = b * unit;
        s.v[i] = b;
        s.v[i + 1] = -a;
        s.x[i] = 5.0 * i + 4.9;
        s.x[i + 1] = 5.0 * i + 5.0;
    }
    return s;
}

enum { LAWS = 8, SLIGHT = 1, NO_NUMBER = 2, TURNS = 4, LATE = 6 };

/* What a program that ends with the other status has made of it. */
static struct check_mistake misjudged(bool right, int law)
{
    if (right)
        return (struct check_mistake){
            "false-alarm", 1.0,
            "This collide is right. Two momenta may cancel, and beads "
            "weigh what they like: with what do you compare the rounding?"};
    if (law == NO_NUMBER)
        return (struct check_mistake){
            "no-number-passes", 0.0,
            "Your program did not notice. Is nan > tolerance true?"};
    if (law == LATE)
        return (struct check_mistake){"check-gives-up", 0.0,
                                      "Your program did not notice. Up to "
                                      "which collision does it look?"};
    return (struct check_mistake){
        "check-missing", 0.0,
        "Your program did not notice. What should be the same before and "
        "after each collision? And compared with what, when the beads are "
        "light?"};
}

static void check_law(const struct scene *s, int law)
{
    static const char *const laws[LAWS] = {
        "is the header's",
        "loses a millionth of the relative velocity",
        "answers with what is no number",
        "does nothing at all",
        "turns both round",
        "exchanges the velocities, whatever the masses",
        "is right three thousand times, and then loses a hundredth",
        "is right, and rounds in another way"};
    const bool right = law == 0 || law == LAWS - 1;
    const struct run *r = run_program(
        order(s, law,
              "This collide conserves energy and momentum. What else does "
              "a collision do? [nothing-happened]"));
    check_about(check_text("a collide that %.60s, and %.390s", laws[law],
                           check_about(NULL)));
    CHECK_NEAR(r->status, .quantity = "the status with which it ended",
               .expected = right ? 0.0 : 1.0, .equation = "eq:difference",
               .question = "With which status does your program end when "
                           "it finds something wrong?",
               .mistakes = {misjudged(right, law)});
    CHECK_NEAR(*r->complaint != '\0', .quantity = "a line on stderr",
               .expected = !right,
               .question = "It should say what broke, and only then.");
}

static void stage_check(void)
{
    static const int turn[LAWS] = {7, 5,     LATE,   NO_NUMBER,
                                   3, TURNS, SLIGHT, 0};
    const struct scene pairs = draw_pairs();
    struct scene slow =
        pairs; /* momenta that all but cancel, in micro m/s */
    slow.tc *= 1e6;
    for (int i = 0; i < MOST; ++i)
        slow.v[i] *= i % 2 ? 1.001e-6 : 1e-6;
    struct scene fast = pairs; /* and every other bead at rest */
    fast.tc *= 1e-6;
    for (int i = 0; i < MOST; ++i)
        fast.v[i] *= i % 2 ? 1e6 : 0.0;
    struct scene s = draw_scene(MOST, draw(1.0, 2.0), 0.0, false);
    struct scene light = s;
    s.tc = light.tc = 0.5;
    s.rows = light.rows = 500;
    for (int i = 0; i < MOST; ++i)
        light.m[i] *= 1e-9;
    for (int i = 0; i < LAWS; ++i) {
        const int law = turn[i];
        const bool right = law == 0 || law == LAWS - 1;
        if (right) {
            check_law(&pairs, law);
            check_law(&s, law);
            check_law(&fast, law);
        }
        if (!right)
            check_law(law == SLIGHT  ? &light
                      : law == TURNS ? &slow
                                     : &s,
                      law);
    }
}

/* A clock so slow that a bead flies many times between two rows; and a slow
   bead, of less than 1 m/s. */
static struct scene draw_rare(void)
{
    static struct table t;
    struct scene s;
    do {
        s = draw_apart(1, INFINITY, draw(1, 10), true, 10);
        s.x[0] *= 0.02;
        s.v[0] *= 0.2;
        s.tc *= 10.0;
        simulate(&s, NONE, &t);
    } while (t.nearest < 1e-5);
    return s;
}

/* A wire so short that its bead reaches the upper stop. */
static struct scene draw_low(void)
{
    static struct table t;
    struct scene s;
    do {
        s = draw_apart(1, draw(0.3, 0.6), draw(0.5, 1.5), true, 60);
        simulate(&s, NONE, &t);
    } while (t.high == 0);
    return s;
}

static void stage_upright(void)
{
    static const char fall[] =
        "Between two events every bead falls. What happens to its place, "
        "and what to its velocity? And when is it at a stop?";
    const struct scene one = draw_apart(1, INFINITY, draw(1, 10), true, 60);
    const struct scene low = draw_low();
    const struct scene five =
        draw_apart(5, INFINITY, draw(0.5, 2.0), true, 40);
    const struct scene any =
        draw_apart(4, draw(4.0, 6.0), draw(0.3, 2.0), false, 40);
    const struct scene rare = draw_rare();
    const struct scene weak =
        draw_apart(4, draw(1.0, 2.0), 1e-6, false, 30);
    struct scene flat = draw_apart(4, draw(1.0, 2.0), 0.0, false, 30);
    check_scene(&one, 1e-10, true, fall);
    check_scene(&low, 1e-9, true,
                "Here the bead reaches the upper stop, too. Which root is "
                "it there?");
    check_scene(&five, 1e-8, true,
                "Equal masses pass through each other, upright as well. "
                "What changes in the time of a pair?");
    check_scene(&any, 1e-6, true, fall);
    check_scene(&rare, 1e-8, true,
                "The bead flies more than once between two rows. When does "
                "a bead that goes up come down?");
    static const double hardly[] = {1e-12, 1e-16, 1e-30};
    check_scene(&weak, 1e-7, true, fall);
    for (int i = 0; i < 3; ++i) {
        flat.g = hardly[i];
        check_scene(
            &flat, 1e-7, true,
            "With hardly any gravity everything is as on a flat wire. "
            "Which difference of two nearly equal numbers do you take?");
    }
}

/* Four beads of known shares, in units of the year. What is true of the
   errors was found from 250 runs of each kind, as a part of the value:
   lightest, heaviest, ratio. */
static const double true_errors[2][3] = {{0.0105, 0.0118, 0.0200},
                                         {0.0128, 0.0106, 0.0203}};

static double rounded(double x)
{
    char text[32];
    snprintf(text, sizeof text, "%.5g", x);
    return strtod(text, NULL);
}

static struct scene draw_shared(bool upright)
{
    static const double masses[] = {9.0, 5.0, 2.0, 1.0};
    const double kilogram = draw(0.5, 2.0), metre = draw(0.5, 2.0);
    const double second = draw(0.5, 2.0);
    double fast = 0.0, high = 0.0;
    struct scene s = {.n = 4, .rows = 40000};
    for (int i = 0; i < s.n; ++i) {
        s.x[i] = draw(0.1 + 0.2 * i, 0.25 + 0.2 * i);
        s.v[i] = draw(0.3, 1.0) * either_sign();
        fast += masses[i] * s.v[i] * s.v[i] / 2.0;
        high += masses[i] * s.x[i];
    }
    for (int i = 0; i < s.n; ++i) {
        s.m[i] = rounded(masses[i] * kilogram);
        s.x[i] = rounded(s.x[i] * metre * (upright ? 6.0 / high : 1.0));
        s.v[i] = rounded(s.v[i] * sqrt(2.0 / fast) * metre / second);
    }
    s.length = upright ? INFINITY : metre;
    s.g = upright ? rounded(metre / second / second) : 0.0;
    s.tc = rounded((upright ? 0.06 : 0.04) * second);
    return s;
}

/* The root of the mean square in the rows, and the error that it would have
   if they were independent. */
static double of_rows(const struct run *r, int column, double *error)
{
    double two = 0.0, four = 0.0;
    const double n = (double)(r->rows - 1);
    for (size_t k = 1; k < r->rows; ++k) {
        const double v = r->numbers[k * r->columns + (size_t)column];
        two += v * v / n;
        four += v * v * v * v / n;
    }
    *error = sqrt((four - two * two) / n) / (2.0 * sqrt(two));
    return sqrt(two);
}

static void check_numbers(const char *name, bool upright,
                          const double got[3], double theory, double run,
                          double naive, double spread)
{
    const double error = got[1] / (theory * spread);
    CHECK_NEAR(got[2], .quantity = check_text("the theory of %s", name),
               .expected = theory, .tolerance = 1e-6 * theory,
               .because = "the digits of the masses",
               .equation = "eq:equipartition",
               .question =
                   *name == 'r' ? "Is it lightest over heaviest?"
                   : upright ? "How many squares are there in the energy? "
                               "A height is no square: what is its share?"
                             : "How many squares are there in the energy, "
                               "and which share of it has each?");
    CHECK_NEAR(got[0], .quantity = check_text("the run of %s", name),
               .expected = run, .tolerance = 1e-3 * run,
               .because = "it was computed again from the rows",
               .equation = "eq:equipartition",
               .question = "The root of the mean of the squares: of which "
                           "bead, and over which rows?");
    CHECK_NEAR(
        error,
        .quantity =
            check_text("the error of %s, in units of the true one", name),
        .expected = 1.0, .tolerance = error < 1.0 ? 0.42 : 0.6,
        .because = "found from 250 runs; an error has an error",
        .equation = "eq:block",
        .question = "How long are your blocks, and how many? And is it the "
                    "error of the root, or of the square?",
        .mistakes = {
            {"rows-as-if-independent", naive / (theory * spread),
             "One row knows the row before it. How often does a bead "
             "forget, and what do means over long blocks say?"}});
    CHECK_NEAR(
        (got[0] - theory) / got[1],
        .quantity = check_text("%s: run less theory, in errors", name),
        .tolerance = 5.0,
        .because = "beyond lies less than one run in a hundred thousand",
        .equation = "eq:equipartition",
        .question = "Theory and run do not agree. Which of them do you "
                    "believe, and why?");
}

/* limit: 1000 rows */
/* With 1000 rows, and of equals the lowest; with 999 nothing. */
static void check_thousand(void)
{
    struct scene s = draw_apart(2, draw(1.0, 2.0), 0.0, true, 999);
    for (; s.rows <= 1000; ++s.rows) {
        const struct run *r = run_program(order(&s, 0, for_ever));
        double got[3] = {0.0}, naive;
        check_form(&s, r);
        const int count = run_remark(r, "# lightest", got, 3);
        CHECK_NEAR(
            count, .quantity = "numbers behind # lightest",
            .expected = s.rows < 1000 ? 0.0 : 3.0,
            .question =
                "From how many ROWS on does the contract ask for them?");
        const double run = of_rows(r, 3, &naive);
        if (count == 3)
            CHECK_NEAR(got[0], .quantity = "the run of lightest",
                       .expected = run, .tolerance = 1e-3 * run,
                       .because = "it was computed again from the rows",
                       .question = "Both weigh the same: which of them "
                                   "does the contract take?");
    }
}

/* Which beads are the lightest and the heaviest, if neither is the first or
   the last. */
static void check_among(void)
{
    static const char *const names[] = {"# lightest", "# heaviest"};
    struct scene s = draw_apart(4, draw(1.0, 2.0), 0.0, false, 1000);
    const int heavy = check_draw_whole(1, 2);
    s.m[heavy] = 9.0;
    s.m[3 - heavy] = 0.4;
    const struct run *r = run_program(order(&s, 0, for_ever));
    check_form(&s, r);
    for (int k = 0; k < 2; ++k) {
        double got[3] = {NAN, NAN, NAN}, naive;
        const int bead = k ? heavy : 3 - heavy;
        const double run = of_rows(r, 3 + 2 * bead, &naive);
        run_remark(r, names[k], got, 3);
        CHECK_NEAR(got[0],
                   .quantity = check_text("the run of %s", names[k]),
                   .expected = run, .tolerance = 1e-3 * run,
                   .because = "it was computed again from the rows",
                   .question = "Which of these beads is it?");
    }
}

static void stage_theory(void)
{
    double mean_log = 0.0;
    check_thousand();
    check_among();
    for (int upright = 0; upright < 2; ++upright) {
        const struct scene s = draw_shared(upright);
        const double *spread = true_errors[upright];
        double got[3][3], naive[3], run[3], energy = 0.0, theory[3];
        const struct run *r = run_program(order(&s, 0, for_ever));
        check_form(&s, r);
        for (int i = 0; i < s.n; ++i)
            energy += s.m[i] * (s.v[i] * s.v[i] / 2.0 + s.g * s.x[i]);
        const double share = energy / s.n * (upright ? 2.0 / 3.0 : 2.0);
        run[0] = of_rows(r, 2 + 2 * 3 + 1, &naive[0]);
        run[1] = of_rows(r, 2 + 1, &naive[1]);
        run[2] = run[0] / run[1];
        naive[2] = run[2] * hypot(naive[0] / run[0], naive[1] / run[1]);
        theory[0] = sqrt(share / s.m[3]);
        theory[1] = sqrt(share / s.m[0]);
        theory[2] = theory[0] / theory[1];
        static const char *const names[] = {"lightest", "heaviest",
                                            "ratio"};
        for (int i = 0; i < 3; ++i) {
            const char *words = check_text("# %s", names[i]);
            const int count = run_remark(r, words, got[i], 3);
            CHECK_NEAR(
                count, .quantity = check_text("numbers behind %s", words),
                .expected = 3.0, .equation = "eq:equipartition",
                .question = "The contract asks for the run, its standard "
                            "error, and the theory, when ROWS >= 1000.");
            check_numbers(names[i], upright, got[i], theory[i], run[i],
                          naive[i], spread[i]);
            mean_log += log(got[i][1] / (theory[i] * spread[i])) / 6.0;
        }
        /* Six errors know more together than each: of a hundred blocks the
           mean of their logarithms scatters by 0.05. */
        if (upright)
            CHECK_NEAR(
                exp(mean_log),
                .quantity =
                    "the six errors together, in units of the true ones",
                .expected = 1.0, .tolerance = 0.25,
                .because = "found from 250 runs; and an error has an error",
                .equation = "eq:block",
                .question = "Each error alone could be chance, all of them "
                            "together are not. What is the error of a "
                            "root, when that of the square is known?");
    }
}

const struct check_suite check_suite = {
    .file = "P1-bonkers.c",
    .title = "Bonkers, upright",
    .minutes = 180,
    .tests = {{"1 special cases: one bead flat, equal masses flat",
               stage_special, 4, 0},
              {"2 then generalize: any masses, flat", stage_general, 5, 2},
              {"3 the clock: rows neither drift nor sit on collisions",
               stage_clock, 2, 0},
              {"4 check: the program watches itself", stage_check, 4, 0},
              {"5 upright: beads that fall", stage_upright, 5, 3},
              {"6 make a theory: who is fast, and how sure are we",
               stage_theory, 5, 0},
              {0}},
};
