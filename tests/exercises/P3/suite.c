/* Project P3: rows of a program that steps, and what it says of itself. */
#include "examiner/project.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8, PER_BODY = 4, COLUMNS = 2 + PER_BODY * MOST };

enum method { EULER, LEAPFROG, FOURTH };
static const char *const method_names[] = {"euler", "leapfrog", "fourth"};

struct scene {
    int n, springs;
    double m[MOST], r[MOST], x[2 * MOST], v[2 * MOST];
    struct {
        int a, b;
        double k, l;
    } spring[MOST];
    double g, dt;
    enum method method;
    int every, rows;
};

/* ---- what must come out, and what comes of mistakes ---- */

enum fault {
    NONE,
    EXPLICIT,
    PUSHES,
    NO_MASS,
    NO_REST,
    ALONE,
    POWER,
    OWN_MASS,
    ONE_BY_ONE,
    WHOLE_KICKS,
    OLD_FORCE,
    DRIFTS_FIRST,
    FAULTS
};

struct state {
    long double x[2 * MOST], v[2 * MOST];
};

static long double distance(const struct state *s, int i, int j)
{
    const long double *p = s->x + 2 * i, *q = s->x + 2 * j;
    return hypotl(q[0] - p[0], q[1] - p[1]);
}

/* Adds to a what a force does that pulls i to j with f times their
   distance. */
static void attract(const struct scene *s, const struct state *now,
                    enum fault fault, int i, int j, long double f,
                    long double a[])
{
    long double m = s->m[i], w = s->m[j];
    if (fault == OWN_MASS) {
        m = s->m[j];
        w = s->m[i];
    } else if (fault == NO_MASS) {
        m = w = 1.0L;
    }
    for (int c = 0; c < 2; ++c) {
        const long double way = now->x[2 * j + c] - now->x[2 * i + c];
        a[2 * i + c] += f * way / m;
        a[2 * j + c] -= fault == ALONE ? 0.0L : f * way / w;
    }
}

static void forces(const struct scene *s, const struct state *now,
                   enum fault fault, long double a[])
{
    for (int c = 0; c < 2 * s->n; ++c)
        a[c] = 0.0L;
    for (int i = 0; s->g > 0.0 && i < s->n; ++i)
        for (int j = i + 1; j < s->n; ++j) {
            const long double d = distance(now, i, j);
            attract(s, now, fault == NO_MASS ? NONE : fault, i, j,
                    s->g * s->m[i] * s->m[j] /
                        (fault == POWER ? d * d : d * d * d),
                    a);
        }
    for (int k = 0; k < s->springs; ++k) {
        const int i = s->spring[k].a, j = s->spring[k].b;
        const long double d = distance(now, i, j);
        const long double l = fault == NO_REST ? 0.0L : s->spring[k].l;
        const long double f = s->spring[k].k * (d - l) / d;
        attract(s, now, fault == OWN_MASS ? NONE : fault, i, j,
                fault == PUSHES ? -f : f, a);
    }
}

static void add(int count, long double to[], const long double rate[],
                long double t)
{
    for (int c = 0; c < count; ++c)
        to[c] += t * rate[c];
}

static void kick(const struct scene *s, struct state *now, enum fault fault,
                 long double t)
{
    long double a[2 * MOST];
    forces(s, now, fault, a);
    add(2 * s->n, now->v, a, t);
}

static void drift(const struct scene *s, struct state *now, long double t)
{
    add(2 * s->n, now->x, now->v, t);
}

/* Each body kicked and moved before the next one looks where it is. */
static void one_by_one(const struct scene *s, struct state *now,
                       long double t)
{
    for (int i = 0; i < s->n; ++i) {
        long double a[2 * MOST];
        forces(s, now, NONE, a);
        add(2, now->v + 2 * i, a + 2 * i, t);
        add(2, now->x + 2 * i, now->v + 2 * i, t);
    }
}

static void leap(const struct scene *s, struct state *now, enum fault fault,
                 long double t)
{
    const long double part = fault == WHOLE_KICKS ? t : t / 2.0L;
    long double a[2 * MOST];
    if (fault == DRIFTS_FIRST) {
        drift(s, now, t / 2.0L);
        kick(s, now, fault, t);
        drift(s, now, t / 2.0L);
        return;
    }
    forces(s, now, fault, a);
    kick(s, now, fault, part);
    drift(s, now, t);
    if (fault != OLD_FORCE)
        forces(s, now, fault, a);
    add(2 * s->n, now->v, a, part);
}

static void one_step(const struct scene *s, struct state *now,
                     enum fault fault)
{
    const struct state old = *now;
    if (s->method == LEAPFROG) {
        leap(s, now, fault, s->dt);
    } else if (fault == ONE_BY_ONE) {
        one_by_one(s, now, s->dt);
    } else {
        kick(s, now, fault, s->dt);
        drift(s, now, s->dt);
        for (int c = 0; fault == EXPLICIT && c < 2 * s->n; ++c)
            now->x[c] = old.x[c] + s->dt * old.v[c];
    }
}

static struct state begin(const struct scene *s)
{
    struct state now = {{0.0L}, {0.0L}};
    for (int c = 0; c < 2 * s->n; ++c) {
        now.x[c] = s->x[c];
        now.v[c] = s->v[c];
    }
    return now;
}

/* The parts of the energy: of motion, of pairs, of springs. */
static void energies(const struct scene *s, const struct state *now,
                     double e[3])
{
    e[0] = e[1] = e[2] = 0.0;
    for (int i = 0; i < s->n; ++i) {
        for (int c = 2 * i; c < 2 * i + 2; ++c)
            e[0] += (double)(s->m[i] * now->v[c] * now->v[c] / 2.0L);
        for (int j = 0; j < i; ++j)
            e[1] -=
                (double)(s->g * s->m[i] * s->m[j] / distance(now, i, j));
    }
    for (int k = 0; k < s->springs; ++k) {
        const long double longer =
            distance(now, s->spring[k].a, s->spring[k].b) - s->spring[k].l;
        e[2] += (double)(s->spring[k].k * longer * longer / 2.0L);
    }
}

static void put_row(const struct scene *s, const struct state *now, int k,
                    double *row)
{
    double e[3];
    energies(s, now, e);
    row[0] = (double)k * s->every * s->dt;
    row[1] = e[0] + e[1] + e[2];
    for (int i = 0; i < s->n; ++i)
        for (int c = 0; c < 2; ++c) {
            row[2 + PER_BODY * i + c] = (double)now->x[2 * i + c];
            row[4 + PER_BODY * i + c] = (double)now->v[2 * i + c];
        }
}

/* The rows of euler or leapfrog, for the caller to keep. */
static void simulate(const struct scene *s, enum fault fault, double **rows)
{
    const int columns = 2 + PER_BODY * s->n;
    struct state now = begin(s);
    *rows = realloc(*rows, sizeof **rows * (size_t)columns *
                               (size_t)(s->rows + 1));
    for (int k = 0; k <= s->rows; ++k) {
        put_row(s, &now, k, *rows + k * columns);
        for (int i = 0; i < s->every; ++i)
            one_step(s, &now, fault);
    }
}

/* Where they are truly. */
static void pull(const void *of, const long double x[], long double a[])
{
    struct state now;
    memcpy(now.x, x, sizeof now.x);
    forces(of, &now, NONE, a);
}

static struct state exactly(const struct scene *s, double t, int parts)
{
    struct state now = begin(s);
    project_exactly(pull, s, 2 * s->n, now.x, now.v, t, parts);
    return now;
}

/* ---- runs ---- */

static const char for_ever[] = "How many steps did you ask for? ROWS times "
                               "EVERY, and twice as many for the error.";

static const struct run_order *order(const struct scene *s)
{
    static char bodies[4000], words[5][32];
    static struct run_order o;
    int at = 0;
    const int room = sizeof bodies;
    for (int i = 0; i < s->n; ++i)
        at += snprintf(bodies + at, (size_t)(room - at),
                       "%.17g %.10g %.17g %.17g %.17g %.17g\n", s->m[i],
                       s->r[i], s->x[2 * i], s->x[2 * i + 1], s->v[2 * i],
                       s->v[2 * i + 1]);
    for (int k = 0; k < s->springs; ++k)
        at += snprintf(bodies + at, (size_t)(room - at),
                       "spring %d %d %.10g %.17g\n", s->spring[k].a + 1,
                       s->spring[k].b + 1, s->spring[k].k, s->spring[k].l);
    snprintf(words[0], 32, "%.17g", s->g);
    snprintf(words[1], 32, "%s", method_names[s->method]);
    snprintf(words[2], 32, "%.17g", s->dt);
    snprintf(words[3], 32, "%d", s->every);
    snprintf(words[4], 32, "%d", s->rows);
    o = (struct run_order){
        .arguments = {"bodies.txt", words[0], words[1], words[2], words[3],
                      words[4]},
        .files = {{"bodies.txt", bodies}},
        .late = for_ever,
    };
    return &o;
}

static void check_form(const struct scene *s, const struct run *r)
{
    project_form(r, (size_t)s->rows + 1, 2 + PER_BODY * (size_t)s->n,
                 "A row is t, E, and x, y, vx and vy of each body. Which "
                 "of them is missing, or what is there besides?");
}

/* What those get who make one of these mistakes, at this row and column. */
static void mistakes(struct check *check, const struct scene *s, int k,
                     int c, const enum fault *faults)
{
    static const struct {
        const char *name, *hint;
    } all[] = {
        [EXPLICIT] = {"explicit-euler",
                      "Your bodies drift with the velocity that they had "
                      "before the kick. Which velocity does the contract "
                      "say, and what would this one do to an orbit?"},
        [PUSHES] = {"spring-pushes",
                    "A spring that is too long pulls its ends together. "
                    "Which way does yours?"},
        [NO_MASS] =
            {"force-as-acceleration",
             "A spring pulls both of its ends with one force. What does "
             "that force do to a heavy end, and to a light one?"},
        [NO_REST] =
            {"rest-length-forgotten",
             "When this spring is as long as its L, what is its force?"},
        [ALONE] = {"no-reaction",
                   "One of the two feels the force and the other does not. "
                   "What becomes of the momentum?"},
        [POWER] = {"square-of-the-distance",
                   "The force falls as 1/d^2. You multiply it by the whole "
                   "way from one body to the other: how long is that?"},
        [OWN_MASS] =
            {"own-mass",
             "Two bodies fall differently though they are in the same "
             "place. Whose mass decides how fast a body falls?"},
        [ONE_BY_ONE] =
            {"one-by-one",
             "The second body is pulled to where the first one is after "
             "its step. Where was it when the step began?"},
        [WHOLE_KICKS] = {"whole-kicks",
                         "Two kicks a step, each as long as the step: how "
                         "far is the velocity ahead?"},
        [OLD_FORCE] =
            {"old-force",
             "The second half of the kick is done with the forces of the "
             "first. Where are the bodies by then?"},
        [DRIFTS_FIRST] =
            {"drift-first",
             "This is a leapfrog, too, with a drift on either side of its "
             "kick. Which one does the contract ask for?"},
    };
    const int columns = 2 + PER_BODY * s->n, at = k * columns + c;
    static double *other;
    for (; *faults != NONE; ++faults) {
        simulate(s, *faults, &other);
        project_mistake(check, all[*faults].name, other[at],
                        all[*faults].hint);
    }
    if (s->method == LEAPFROG) {
        struct scene slow = *s;
        slow.method = EULER;
        simulate(&slow, NONE, &other);
        project_mistake(check, "leapfrog-is-euler", other[at],
                        "These are the rows of euler. What does a leapfrog "
                        "do in another way?");
    }
    project_mistake(
        check, "printed-short", project_cut("%g", check->expected),
        "These digits have been cut off. Do you print with %.17g?");
    project_mistake(
        check, "printed-short", project_cut("%f", check->expected),
        "These digits have been cut off. Do you print with %.17g?");
}

static void energy_mistakes(struct check *check, const struct scene *s,
                            const double *row)
{
    struct state now;
    double e[3];
    for (int i = 0; i < s->n; ++i)
        for (int c = 0; c < 2; ++c) {
            now.x[2 * i + c] = row[2 + PER_BODY * i + c];
            now.v[2 * i + c] = row[4 + PER_BODY * i + c];
        }
    energies(s, &now, e);
    project_mistake(check, "pairs-twice", e[0] + 2.0 * e[1] + e[2],
                    "The energy of two that attract each other belongs to "
                    "the pair. How often have you counted it?");
    project_mistake(check, "springs-without-energy", e[0] + e[1],
                    "Something holds energy that you have not counted. "
                    "What did it take to stretch a spring?");
    project_mistake(check, "attraction-repels", e[0] - e[1] + e[2],
                    "Far apart, two bodies that attract each other have "
                    "the energy 0. Nearer, is it more or less?");
}

/* Compares row by row; the energy, which is made of the others, last. */
static void check_rows(const struct scene *s, const double *want,
                       const struct run *r, const enum fault *faults,
                       const char *question)
{
    /* Rounding: a step errs by some 1e-16 of each number, and neighbours
       part in these short runs by less than a factor of 1e3 in 200 steps.
     */
    const double slack = 1e-9;
    const int columns = 2 + PER_BODY * s->n;
    double size[4] = {0.0};
    for (int i = 0; i < (s->rows + 1) * columns; ++i) {
        const int c = i % columns;
        const int kind = c < 2 ? c : 2 + (c - 2) % PER_BODY / 2;
        size[kind] = fmax(size[kind], fabs(want[i]));
    }
    for (int k = 0; k <= s->rows; ++k)
        for (int step = 0; step < columns; ++step) {
            const int c = step == 0             ? 0
                          : step == columns - 1 ? 1
                                                : step + 1;
            const int kind = c < 2 ? c : 2 + (c - 2) % PER_BODY / 2;
            const double expected = want[k * columns + c];
            const double got = r->numbers[k * columns + c];
            const double most = c == 0 ? 1e-9 * s->dt : slack * size[kind];
            if (fabs(got - expected) <= most)
                continue;
            static const char *const names[] = {"x", "y", "vx", "vy"};
            static const char *const units[] = {"s", "J", "m", "m/s"};
            struct check check = {
                .quantity =
                    c < 2
                        ? check_text("%s in row %d", c ? "E" : "t", k)
                        : check_text("%s of body %d in row %d, at %.10g s",
                                     names[(c - 2) % PER_BODY],
                                     (c - 2) / PER_BODY + 1, k,
                                     want[k * columns]),
                .unit = units[kind],
                .expected = expected,
                .tolerance = most,
                .because = "rounding, and what the forces make of it",
                .equation = s->method == EULER ? "eq:symplectic-euler"
                                               : "eq:verlet",
                .question = c == 0 ? "Row k stands at the time k EVERY DT. "
                                     "What is printed here?"
                            : c == 1 ? "All places and velocities are "
                                       "right. Which parts has the energy?"
                                     : question,
            };
            if (c == 1)
                energy_mistakes(&check, s, r->numbers + k * columns);
            else if (c > 1)
                mistakes(&check, s, k, c, faults);
            check_near(got, check);
        }
}

static void check_scene(const struct scene *s, const enum fault *faults,
                        const char *question)
{
    static double *want;
    const struct run *r = run_program(order(s));
    simulate(s, NONE, &want);
    check_form(s, r);
    check_rows(s, want, r, faults, question);
}

/* ---- stage 1: special cases ---- */

static struct scene draw_flight(void)
{
    struct scene s = {.n = 1, .every = 3, .rows = 20};
    s.m[0] = draw(0.5, 3.0);
    s.dt = draw(0.01, 0.1);
    for (int c = 0; c < 2; ++c) {
        s.x[c] = draw(-2.0, 2.0);
        s.v[c] = draw(0.5, 1.5) * either_sign();
    }
    return s;
}

/* Two on a spring along x, in steps of a thirtieth of their period. */
static struct scene draw_pair(void)
{
    struct scene s = {.n = 2, .springs = 1, .every = 2, .rows = 40};
    s.m[0] = draw(0.5, 1.0);
    s.m[1] = draw(1.5, 4.0);
    s.spring[0].b = 1;
    s.spring[0].k = draw(1.0, 20.0);
    s.spring[0].l = draw(0.5, 1.5);
    s.x[0] = draw(-1.0, 0.0);
    s.x[2] = s.x[0] + s.spring[0].l * draw(1.1, 1.4);
    s.v[0] = s.v[2] = draw(0.1, 0.3);
    s.dt = 0.2 / sqrt(s.spring[0].k * (1.0 / s.m[0] + 1.0 / s.m[1]));
    return s;
}

static void stage_special(void)
{
    static const enum fault none[] = {NONE};
    static const enum fault spring[] = {EXPLICIT, PUSHES, NO_MASS,
                                        NO_REST,  ALONE,  NONE};
    const struct scene flight = draw_flight(), pair = draw_pair();
    check_scene(&flight, none,
                "One body, and nothing that pulls it: where is it after "
                "EVERY steps of DT?");
    check_scene(&pair, spring,
                "Kick, then drift. What is the force of this spring at the "
                "start, and what is the acceleration of either end?");
}

/* ---- stage 2: then generalize ---- */

static bool near_each_other(const struct scene *s, double least)
{
    static double *rows;
    simulate(s, NONE, &rows);
    for (int k = 0; k <= s->rows; ++k) {
        const double *x = rows + k * (2 + PER_BODY * s->n) + 2;
        for (int i = 0; i < s->n; ++i)
            for (int j = 0; j < i; ++j)
                if (hypot(x[4 * i] - x[4 * j],
                          x[4 * i + 1] - x[4 * j + 1]) < least)
                    return true;
    }
    return false;
}

/* Four in a ring that attract each other, two springs across. */
static struct scene draw_ring(enum method method)
{
    struct scene s;
    do {
        s = (struct scene){
            .n = 4, .springs = 2, .method = method, .every = 5, .rows = 30};
        for (int i = 0; i < 4; ++i) {
            const double turn = 1.5707963 * (i + draw(-0.2, 0.2));
            const double far = draw(0.8, 1.5);
            s.m[i] = draw(0.5, 3.0);
            s.x[2 * i] = far * cos(turn);
            s.x[2 * i + 1] = far * sin(turn);
            s.v[2 * i] = draw(-0.5, 0.5);
            s.v[2 * i + 1] = draw(-0.5, 0.5);
        }
        for (int k = 0; k < 2; ++k) {
            s.spring[k].a = k ? 3 : 0;
            s.spring[k].b = k ? 1 : 2;
            s.spring[k].k = draw(1.0, 5.0);
            s.spring[k].l = draw(0.5, 1.5);
        }
        s.g = draw(0.1, 0.4);
        s.dt = draw(0.008, 0.012);
    } while (near_each_other(&s, 0.3));
    return s;
}

struct nonsense {
    const char *what, *bodies;
    enum { G, METHOD, DT, EVERY, ROWS, WORDS } which;
    const char *word; /* NULL: all words are fine */
};

static void check_refused(const struct nonsense *bad)
{
    const char *words[WORDS] = {"1", "euler", "0.1", "1", "3"};
    if (bad->word)
        words[bad->which] = bad->word;
    const struct run_order o = {
        .arguments = {"bodies.txt", words[0], words[1], words[2], words[3],
                      words[4]},
        .files = {{bad->bodies ? "bodies.txt" : NULL, bad->bodies}},
        .late = for_ever,
    };
    project_refuses(&o, bad->what);
}

/* limit: 1 (EVERY) */
static void check_inputs(void)
{
    static const char one[] = "1 0 0 0 1 0\n";
    static const char two[] = "1 0 0 0 1 0\n1 0 1 0 1 0\n";
    static const struct nonsense all[] = {
        {"a file without bodies", "# nothing\n", 0, NULL},
        {"a mass of 0", "0 0 0 0 1 0\n", 0, NULL},
        {"a radius below 0", "1 -1 0 0 1 0\n", 0, NULL},
        {"five numbers", "1 0 0 0 1\n", 0, NULL},
        {"seven numbers", "1 0 0 0 1 0 0\n", 0, NULL},
        {"a word for a number", "1 0 0 zero 1 0\n", 0, NULL},
        {"a letter behind a number", "1 0 0 0 1 0x\n", 0, NULL},
        {"a mass that is no number", "nan 0 0 0 1 0\n", 0, NULL},
        {"a place that is not finite", "1 0 inf 0 1 0\n", 0, NULL},
        {"two bodies in one place", "1 0 0 0 1 0\n1 0 0 0 2 0\n", 0, NULL},
        {"two that overlap", "1 1 0 0 1 0\n1 0.5 1.2 0 2 0\n", 0, NULL},
        {"a spring from a body to itself",
         "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 2 2 1 1\n", 0, NULL},
        {"a spring to a body that is not there",
         "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 1 3 1 1\n", 0, NULL},
        {"a spring to body 0", "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 0 1 1 1\n",
         0, NULL},
        {"a spring without its L",
         "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 1 2 1\n", 0, NULL},
        {"a spring that has no K",
         "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 1 2 0 1\n", 0, NULL},
        {"a spring that is less than nothing long",
         "1 0 0 0 1 0\n1 0 1 0 1 0\nspring 1 2 1 -1\n", 0, NULL},
        {"a G below 0", one, G, "-1"},
        {"a G that is a word", one, G, "earth"},
        {"a method that there is not", two, METHOD, "fifth"},
        {"a step of 0", one, DT, "0"},
        {"a step backwards", one, DT, "-0.1"},
        {"a unit behind the step", one, DT, "0.1s"},
        {"an EVERY of 0", one, EVERY, "0"},
        {"an EVERY that is a word", one, EVERY, "second"},
        {"an EVERY that is not whole", one, EVERY, "1.5"},
        {"ROWS below 0", one, ROWS, "-1"},
        {"ROWS that are not whole", one, ROWS, "2.5"},
        {"ROWS that are an empty word", one, ROWS, ""},
        {"a letter behind ROWS", one, ROWS, "3x"},
        {"a file that is not there", NULL, 0, NULL}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        check_refused(&all[k]);
}

/* Remarks, empty lines, and a spring before its bodies. */
static void check_read(void)
{
    struct scene s = {.n = 2,
                      .springs = 1,
                      .m = {1.0, 2.0},
                      .x = {0.0, 0.5, 1.0, 0.5},
                      .v = {0.0, 0.25, 0.0, -0.25},
                      .spring = {{0, 1, 2.0, 0.75}},
                      .g = 1.0,
                      .dt = 0.0625,
                      .every = 1,
                      .rows = 5};
    static const enum fault none[] = {NONE};
    static double *want;
    struct run_order o = *order(&s);
    o.files[0].text =
        "# m r x y vx vy\n\nspring 1 2 2 0.75 # a remark\n1 0 0 0.5 0 "
        "0.25\n  # and another\n\t2 0   1 0.5 0 -0.25";
    const struct run *r = run_program(&o);
    simulate(&s, NONE, &want);
    project_reads(r,
                  "A remark may fill a line, a line may be empty, a spring "
                  "may stand before its bodies, and the last line need not "
                  "end. Which of these does your program refuse?");
    check_form(&s, r);
    check_rows(&s, want, r, none,
               "Bodies are counted from 1, in the order of their lines.");
}

/* limit: 64 bodies, and as many springs */
/* As many as there may be: springs
   at their lengths, from each to the next one, and the last to the first.
   They fly together. */
static void check_room(void)
{
    enum { ALL = 64, WIDTH = 2 + PER_BODY * ALL };
    static char bodies[6000];
    const size_t room = sizeof bodies;
    size_t at = 0;
    for (int i = 0; i < ALL; ++i)
        at += (size_t)snprintf(bodies + at, room - at,
                               "1 0 %d 0 0.25 0.5\n", i);
    for (int i = 0; i < ALL; ++i)
        at += (size_t)snprintf(
            bodies + at, room - at, "spring %d %d 1 %d\n", i + 1,
            (i + 1) % ALL + 1, i == ALL - 1 ? ALL - 1 : 1);
    const struct run_order o = {
        .arguments = {"bodies.txt", "0", "leapfrog", "0.0625", "4", "2"},
        .files = {{"bodies.txt", bodies}},
        .late = for_ever,
    };
    const struct run *r = run_program(&o);
    static const char question[] =
        "There are 64 bodies and 64 springs, and so many are allowed. How "
        "many does each of your arrays hold?";
    CHECK_NEAR(r->status, .quantity = "the status with which it ended",
               .question = question,
               .mistakes = {{"too-little-room", 2.0, question}});
    project_form(r, 3, WIDTH, question);
    CHECK_NEAR(r->numbers[2 * WIDTH + 2 + PER_BODY * (ALL - 1)],
               .quantity = "x of body 64 in row 2", .unit = "m",
               .expected = ALL - 1 + 0.125, .tolerance = 1e-9,
               .because = "no spring pulls", .equation = "eq:verlet",
               .question =
                   "All springs are at their lengths, and all bodies have "
                   "one velocity. What pulls this one?");
}

static void stage_general(void)
{
    static const enum fault pairs[] = {POWER, OWN_MASS, ONE_BY_ONE, ALONE,
                                       NONE};
    static const enum fault halves[] = {WHOLE_KICKS, OLD_FORCE,
                                        DRIFTS_FIRST, NONE};
    const struct scene slow = draw_ring(EULER), fast = draw_ring(LEAPFROG);
    check_scene(&slow, pairs,
                "Springs are right. What is the force between two that "
                "attract each other, and how many pairs are there?");
    check_scene(&fast, halves,
                "euler is right. Half a kick, a drift, half a kick: with "
                "which forces?");
    check_read();
    check_room();
    check_inputs();
}

/* ---- stage 3: the order ---- */

/* A planet from where it is nearest to its sun, once round. */
static struct scene draw_planet(void)
{
    struct scene s = {.n = 2, .g = 6.674e-11};
    const double axis = 1.496e11 * draw(0.5, 2.0), e = draw(0.1, 0.3);
    const double sun = 1.989e30 * draw(0.5, 2.0), planet = sun / 1000.0;
    const double share = planet / (sun + planet);
    const double near = axis * (1.0 - e);
    const double speed =
        sqrt(s.g * (sun + planet) / axis * (1.0 + e) / (1.0 - e));
    s.m[0] = sun;
    s.m[1] = planet;
    s.x[0] = -share * near;
    s.x[2] = near + s.x[0];
    s.v[1] = -share * speed;
    s.v[3] = speed + s.v[1];
    s.dt =
        2.0 * acos(-1.0) * sqrt(axis * axis * axis / s.g / (sun + planet));
    return s;
}

/* Three on an eight, in other units each year; dt is its period. */
static struct scene draw_eight(void)
{
    static const double x[] = {0.97000436, -0.24308753, -0.97000436,
                               0.24308753, 0.0,         0.0};
    static const double v[] = {0.466203685, 0.43236573,  0.466203685,
                               0.43236573,  -0.93240737, -0.86473146};
    const double metre = draw(0.5, 2.0), kilogram = draw(0.5, 2.0);
    struct scene s = {.n = 3, .g = draw(0.5, 2.0)};
    const double second = sqrt(metre * metre * metre / (s.g * kilogram));
    for (int c = 0; c < 6; ++c) {
        s.m[c / 2] = kilogram;
        s.x[c] = x[c] * metre;
        s.v[c] = v[c] * metre / second;
    }
    s.dt = 6.32591398 * second;
    return s;
}

/* How far the body that is farthest off is in the last row. */
static double error_of(const struct scene *s, const struct run *r,
                       const struct state *truth)
{
    const double *row =
        r->numbers + (r->rows - 1) * r->columns; /* its form is right */
    double most = 0.0;
    for (int i = 0; i < s->n; ++i)
        most = fmax(
            most,
            hypot(row[2 + PER_BODY * i] - (double)truth->x[2 * i],
                  row[3 + PER_BODY * i] - (double)truth->x[2 * i + 1]));
    return most;
}

/* fourth with so many steps in the time dt of the scene, which it has made
   before with half as many. */
static void check_order(struct scene s, int steps, const char *what)
{
    const struct state truth = exactly(&s, s.dt, 100);
    const double whole = s.dt;
    double error[2];
    s.method = FOURTH;
    s.rows = 1;
    for (int k = 0; k < 2; ++k) {
        s.every = steps * (k + 1);
        s.dt = whole / s.every;
        const struct run *r = run_program(order(&s));
        check_form(&s, r);
        error[k] = error_of(&s, r, &truth);
    }
    const double size = hypot(s.x[2], s.x[3]);
    CHECK_NEAR(log2(error[0] / error[1]),
               .quantity = check_text("the order of fourth, from %s", what),
               .expected = 4.0, .tolerance = 0.5,
               .because = "the next power of the step",
               .equation = "eq:order",
               .question =
                   "Half the step should leave a sixteenth of the error. "
                   "Which line of your method is not that of the book? Try "
                   "it on one spring, where you know what must come out.",
               .mistakes = {{"second-order", 2.0,
                             "Half the step leaves a quarter of the error. "
                             "Which method has that?"},
                            {"first-order", 1.0,
                             "Half the step leaves half of the error: only "
                             "the first power. Which forces, or which "
                             "times, are not those of the method?"}});
    CHECK_NEAR(
        error[1] / size,
        .quantity = check_text(
            "how far from its place the worst body is, after %s", what),
        .tolerance = 2e-3,
        .because =
            "a part of the orbit's size; methods of order 4 differ much",
        .equation = "eq:order",
        .question = "The order is 4 and the error is large. Which of the "
                    "methods of chapter 8 is this?");
}

static void stage_order(void)
{
    const struct scene planet = draw_planet();
    struct scene eight = draw_eight();
    /* Where the eight closes the errors of Runge-Kutta methods of order 4
       cancel in part, and with 200 and 400 steps they fall with powers of
       4.47 to 4.78. At six tenths these are 4.07 to 4.27, and 4.00 for
       splittings. */
    eight.dt *= 0.6;
    check_order(eight, 200, "six tenths of an eight");
    check_order(planet, 200, "a planet once round its sun");
}

/* ---- stage 4: how wrong is it? ---- */

static void check_stated(const struct scene *s, double t)
{
    const struct state truth = exactly(s, t, 200);
    const struct state half = exactly(s, t / 2.0, 100);
    const struct run *r = run_program(order(s));
    const char *question =
        "Run once more with half the step, over the same time. The "
        "difference of the two ends is which part of the error?";
    check_form(s, r);
    static const int power[] = {1, 2, 4};
    const int p = power[s->method];
    const double *last = r->numbers + (r->rows - 1) * r->columns;
    const double error = error_of(s, r, &truth);
    double early = 0.0, first = 0.0;
    for (int i = s->n; i-- > 0;) {
        first = hypot(last[2 + 4 * i] - (double)truth.x[2 * i],
                      last[3 + 4 * i] - (double)truth.x[2 * i + 1]);
        early =
            fmax(early, hypot(last[2 + 4 * i] - (double)half.x[2 * i],
                              last[3 + 4 * i] - (double)half.x[2 * i + 1]));
    }
    const double stated = project_remark(r, "# error", &question);
    struct check check = {
        .quantity = "log10 of the stated error over the true one",
        .tolerance = log10(3.0),
        .because = "a factor of 3",
        .equation = "eq:order",
        .question = question,
    };
    project_mistake(&check, "half-the-time", log10(early / error),
                    "Half the step and as many steps: at which time has "
                    "that run ended?");
    if (p > 1)
        project_mistake(&check, "error-of-the-half-step",
                        log10(pow(0.5, p)),
                        "That is the error of the run with half the step. "
                        "Which run's rows have you printed?");
    project_mistake(
        &check, "error-of-the-energy",
        log10(fabs(last[1] - r->numbers[1]) / fabs(r->numbers[1]) / error),
        "That is how far the energy is off. What does the energy say about "
        "where on its orbit a planet is?");
    project_mistake(
        &check, "one-body-alone", log10(first / error),
        "That is the error of one body. Which body is farthest off?");
    check_near(log10(stated / error), check);
}

/* Two on a spring, free to turn. */
static struct scene draw_dumbbell(void)
{
    struct scene s = draw_pair();
    s.v[1] = draw(0.2, 0.4);
    s.v[3] = -draw(0.2, 0.4);
    s.dt *= 5.0 * draw(6.0, 9.0); /* one to one and a half periods */
    return s;
}

static void stage_error(void)
{
    /* So many steps that the next power of the step is a tenth at most. */
    static const int steps[3][3] = {
        {4000, 500, 300}, {8000, 1000, 400}, {2000, 200, 60}};
    struct scene all[] = {draw_planet(), draw_eight(), draw_dumbbell()};
    for (int k = 0; k < 3; ++k)
        for (int method = EULER; method <= FOURTH; ++method) {
            struct scene s = all[k];
            const double part = k < 2 ? draw(0.7, 0.95) : 1.0;
            const double t = s.dt * part;
            s.method = (enum method)method;
            s.rows = 4;
            s.every = steps[k][method] / 4;
            s.dt = t / (s.every * s.rows);
            check_stated(&s, t);
        }
}

/* ---- stage 5: which step is short enough? ---- */

/* The fastest vibration of bodies on a line, of which spring k joins k and
   k + 1: from a matrix that is its own image in a mirror, by turning. */
static double fastest(const struct scene *s)
{
    double a[MOST][MOST] = {{0.0}};
    for (int k = 0; k < s->springs; ++k) {
        const double m = s->m[k], w = s->m[k + 1], K = s->spring[k].k;
        a[k][k] += K / m;
        a[k + 1][k + 1] += K / w;
        a[k][k + 1] = a[k + 1][k] = -K / sqrt(m * w);
    }
    double most = 0.0;
    for (int sweep = 0; sweep < 30; ++sweep)
        for (int i = 0; i < s->n; ++i)
            for (int j = i + 1; j < s->n; ++j) {
                const double turn =
                    atan2(2.0 * a[i][j], a[j][j] - a[i][i]) / 2.0;
                const double co = cos(turn), si = sin(turn);
                for (int c = 0; c < s->n; ++c) {
                    const double p = a[i][c], q = a[j][c];
                    a[i][c] = co * p - si * q;
                    a[j][c] = si * p + co * q;
                }
                for (int c = 0; c < s->n; ++c) {
                    const double p = a[c][i], q = a[c][j];
                    a[c][i] = co * p - si * q;
                    a[c][j] = si * p + co * q;
                }
            }
    for (int i = 0; i < s->n; ++i)
        most = fmax(most, a[i][i]);
    return sqrt(most);
}

/* A straight chain, hardly out of its rest. */
static struct scene draw_chain(int n, enum method method)
{
    struct scene s = {.n = n,
                      .springs = n - 1,
                      .method = method,
                      .every = 10,
                      .rows = 40};
    const double turn = draw(1.05, 1.2);
    const double ex = cos(turn), ey = sin(turn);
    for (int i = 0; i < n; ++i) {
        s.m[i] = draw(0.9, 1.1);
        const double speed = draw(-1.0, 1.0) * 1e-3;
        s.v[2 * i] = speed * ex;
        s.v[2 * i + 1] = speed * ey;
        if (i == 0)
            continue;
        s.spring[i - 1].a = i - 1;
        s.spring[i - 1].b = i;
        s.spring[i - 1].k = draw(90.0, 110.0);
        s.spring[i - 1].l = draw(0.5, 1.5);
        s.x[2 * i] = s.x[2 * i - 2] + s.spring[i - 1].l * ex;
        s.x[2 * i + 1] = s.x[2 * i - 1] + s.spring[i - 1].l * ey;
    }
    return s;
}

static const char limit_question[] =
    "A step that is stable for the fastest vibration is so for all. How "
    "fast is that, and what does your method allow?";

/* What the program names, in units of 1/omega; NAN unless it has ended with
   this status. */
static double named(const struct scene *s, int status)
{
    const struct run_order *o = order(s);
    const char *question = limit_question;
    const struct run *r = run_program(o);
    const double got = project_remark(r, "# limit", &question);
    CHECK_NEAR(
        r->status, .quantity = "the status with which it ended",
        .expected = status, .equation = "eq:stability-limit",
        .question = status ? "With this step the springs blow up. What "
                             "should the program do before its first row?"
                           : "This step is short enough: it is four tenths "
                             "of what the method allows.",
        .mistakes = {
            {status ? "blows-up" : "refused-in-vain", status ? 0.0 : 1.0,
             status ? "Your program has made steps that no spring "
                      "survives. What is the longest one that it may make?"
                    : "Your program refuses a step that is short enough. "
                      "Where does its limit come from?"}});
    CHECK_NEAR(status ? (double)r->rows : 0.0,
               .quantity = "rows of a run that is refused",
               .question = "It is refused before it begins.");
    CHECK_NEAR(*r->complaint != '\0', .quantity = "a line on stderr",
               .expected = status,
               .question = "It should say why it stops, and only then.");
    if (!status)
        check_form(s, r);
    CHECK_NEAR(isnan(got), .quantity = "a # limit that is missing",
               .question = question);
    return got * fastest(s);
}

/* Whether it refuses a step beyond 2/omega, and names one from which on it
   does: no shorter than a bound from sums of K/m can be, 0.7 of it. */
static void check_limit(struct scene s)
{
    double alone = 0.0;
    for (int k = 0; k < s.springs; ++k)
        alone =
            fmax(alone, s.spring[k].k * (1.0 / s.m[k] + 1.0 / s.m[k + 1]));
    s.dt = 0.8 / fastest(&s);
    const double with = named(&s, 0);
    struct check check = {
        .quantity = "the limit that it names, in units of the true one",
        .expected = 0.85,
        .tolerance = 0.151,
        .because = "a bound may be too careful by a root of 2",
        .equation = "eq:stability-limit",
        .question = limit_question,
    };
    project_mistake(
        &check, "half-the-limit", 0.5,
        "That is 1/omega. Where does the matrix of a step cease to turn?");
    project_mistake(&check, "period-for-frequency", acos(-1.0),
                    "Is what you have divided by a frequency in turns, or "
                    "an angle, a second?");
    project_mistake(
        &check, "along-x-only", s.spring[0].l / s.x[2],
        "These springs do not lie along x. How much of a push along y does "
        "a spring feel, and which way does it pull back?");
    if (s.n > 2)
        project_mistake(&check, "one-spring-alone",
                        fastest(&s) / sqrt(alone),
                        "That is the limit of the hardest spring, if it "
                        "were alone. What do its neighbours do when all "
                        "bodies swing against each other?");
    else
        project_mistake(&check, "one-end-fixed",
                        fastest(&s) / sqrt(s.spring[0].k / s.m[0]),
                        "That would be right if the other end stood still. "
                        "How fast do two swing that are both free?");
    check_near(with / 2.0, check);
    s.dt = 2.05 / fastest(&s);
    named(&s, 1);
}

/* The limit that it names for its own method: it holds there, and beyond it
   refuses. */
static void check_own_limit(void)
{
    struct scene s = draw_chain(2, FOURTH);
    s.dt = 0.3 / fastest(&s);
    const double limit = named(&s, 0);
    CHECK_NEAR(limit < 1.0 ? 1.0 - limit : 0.0,
               .quantity = "how far below 1/omega the limit is",
               .equation = "eq:stability-limit",
               .question =
                   "Every method of order 4 in the book goes further. "
                   "Where does the matrix of yours cease to be stable?");
    s.dt = 0.98 * limit / fastest(&s);
    const struct run *r = run_program(order(&s));
    check_form(&s, r);
    /* Just below its limit a method may let the energy swing widely; what
       is unstable grows by a fifth a step, in 400 of them without end. */
    double most = 0.0;
    for (size_t k = 0; k < r->rows; ++k) {
        const double e = r->numbers[k * r->columns + 1];
        most = isnan(e) ? INFINITY : fmax(most, fabs(e));
    }
    CHECK_NEAR(most < 1e4 * r->numbers[1],
               .quantity =
                   "1 if the energy stays within 10000 times what it was",
               .expected = 1.0, .equation = "eq:stability-limit",
               .question = "This step is just below the limit that your "
                           "program has named.",
               .mistakes = {
                   {"limit-of-another-method", 0.0,
                    "At 0.98 of the limit that your program names, its own "
                    "method blows up. For which method is that limit?"}});
    s.dt = 1.02 * limit / fastest(&s);
    named(&s, 1);
}

static void stage_stiff(void)
{
    check_limit(draw_chain(2, EULER));
    check_limit(draw_chain(2, LEAPFROG));
    check_limit(draw_chain(6, LEAPFROG));
    check_own_limit();
}

/* ---- stage 6: who meets ---- */

/* Two that fly at each other, past by so many sums of their radii, so fast
   that a step is many of these; sets *t to when they touch. */
static struct scene draw_shot(double past, double *t)
{
    struct scene s = {.n = 2, .every = 1, .rows = 20};
    const double far = draw(15.0, 16.0), speed = draw(3.0, 4.0);
    const double turn = draw(0.1, 1.4);
    const double ex = cos(turn), ey = sin(turn);
    for (int i = 0; i < 2; ++i) {
        s.m[i] = draw(0.5, 3.0);
        s.r[i] = draw(0.1, 0.2);
        s.v[2 * i] = draw(-0.3, 0.3);
        s.v[2 * i + 1] = draw(-0.3, 0.3);
    }
    const double sigma = s.r[0] + s.r[1], b = past * sigma;
    s.x[2] = far * ex - b * ey;
    s.x[3] = far * ey + b * ex;
    s.v[2] = s.v[0] - speed * ex;
    s.v[3] = s.v[1] - speed * ey;
    *t = (far - sqrt(fmax(sigma * sigma - b * b, 0.0))) / speed;
    /* The nearest point lies in the middle of a step of ten radii. */
    s.dt = far / speed / (0.5 + (int)(far / (5.0 * sigma)));
    return s;
}

static void check_meeting(const struct scene *s, int i, int j, double t,
                          double slack, double nearest)
{
    static const struct check_mistake through = {
        "tunnelled", 0.0,
        "Two bodies have gone through each other. They are apart before "
        "this step and after it: what have they been in between?"};
    static const struct check_mistake point = {
        "points-meet-nothing", 0.0,
        "One of these two has a radius, and the other is a point. Which "
        "two can never touch?"};
    const struct run *r = run_program(order(s));
    double got[3] = {NAN, NAN, NAN};
    run_remark(r, "# meet", got, 3);
    const double ends = ceil(t / s->dt) * s->dt;
    CHECK_NEAR(r->status, .quantity = "the status with which it ended",
               .expected = 1.0, .equation = "eq:back-time",
               .question = "Two of these bodies meet.",
               .mistakes = {*(s->r[i] > 0.0 ? &through : &point)});
    CHECK_NEAR(*r->complaint != '\0', .quantity = "a line on stderr",
               .expected = 1.0, .question = "It should say why it stops.");
    CHECK_NEAR(got[0] * 10.0 + got[1],
               .quantity = "the two numbers behind # meet, as ten times "
                           "the first and the second",
               .expected = 10.0 * (i + 1) + j + 1,
               .equation = "eq:back-time",
               .question = "Which two are they, the lower number first?",
               .mistakes = {{"first-pair", s->n > 2 ? 12.0 : NAN,
                             "These two meet as well, later in the same "
                             "step. Who is first?"}});
    CHECK_NEAR(
        got[2], .quantity = "the time at which they meet", .unit = "s",
        .expected = t, .tolerance = slack, .equation = "eq:back-time",
        .because = slack > 1e-6 * s->dt ? "how much a path bends in a step"
                                        : "they fly straight",
        .question = "The two begin to touch where the distance of their "
                    "centres is the sum of their radii. Between the ends "
                    "of a step, how does that distance change?",
        .mistakes = {{"end-of-the-step", ends,
                      "That is the end of the step in which they meet. How "
                      "much of it was over?"},
                     {"start-of-the-step", ends - s->dt,
                      "That is the start of the step in which they meet. "
                      "How much of it was over?"},
                     {"nearest-approach", nearest,
                      "There they are nearest to each other, and one "
                      "inside the other. When do they begin to touch?"}});
    CHECK_NEAR((double)r->rows, .quantity = "rows before they meet",
               .expected = floor(t / (s->every * s->dt)) + 1.0,
               .question =
                   "Rows up to the meeting stand, and none after it.");
}

static void check_miss(const struct scene *s,
                       struct check_mistake false_alarm)
{
    const struct run *r = run_program(order(s));
    CHECK_NEAR(r->status, .quantity = "the status with which it ended",
               .equation = "eq:back-time", .question = "These do not meet.",
               .mistakes = {false_alarm});
    check_form(s, r);
}

/* Four: the two that meet first have the higher numbers. */
static void check_two_pairs(void)
{
    double t;
    struct scene s = draw_shot(0.3, &t);
    const struct scene other = s;
    s.n = 4;
    for (int i = 0; i < 2; ++i) {
        s.m[2 + i] = s.m[i];
        s.r[2 + i] = s.r[i];
        for (int c = 0; c < 2; ++c) {
            s.x[4 + 2 * i + c] = other.x[2 * i + c] + 100.0;
            s.v[4 + 2 * i + c] = other.v[2 * i + c];
        }
    }
    /* The first two come a little later. */
    for (int c = 0; c < 2; ++c)
        s.x[2 + c] -= 0.02 * s.dt * (s.v[2 + c] - s.v[c]);
    check_meeting(&s, 2, 3, t, 1e-9 * t, NAN);
}

/* A stone that falls past a star, and is bent into it. */
static void check_bent(void)
{
    double t;
    struct scene s = draw_shot(0.3, &t);
    const double sigma = s.r[0] + s.r[1];
    const double speed = hypot(s.v[2] - s.v[0], s.v[3] - s.v[1]);
    s.method = LEAPFROG;
    s.g = 0.02 * speed * speed * sigma / (s.m[0] + s.m[1]);
    s.dt *= 0.2;
    s.every = 3;
    s.rows = 40;
    struct state now = begin(&s);
    double before = 0.0, after = 1.01 * t;
    for (int i = 0; i < 40; ++i) {
        const double middle = (before + after) / 2.0;
        now = exactly(&s, middle, 40);
        *(distance(&now, 0, 1) > sigma ? &before : &after) = middle;
    }
    /* A step is as long as sigma. In it the path differs from a straight
       line by a dt^2/8, with an a of 0.02 v^2/sigma or less: 0.0025 of a
       step; ten times as much is left for the method. */
    check_meeting(&s, 0, 1, after, 0.03 * s.dt, NAN);
}

static void stage_meeting(void)
{
    static const struct check_mistake near = {
        "false-meeting", 1.0,
        "These two pass each other at 1.05 times the sum of their radii, "
        "and do not touch. How near does your program think they come?"};
    static const struct check_mistake past = {
        "meeting-in-the-past", 1.0,
        "These two fly apart, from the start. On the line on which they "
        "fly they would have touched before: which times count?"};
    static const struct check_mistake nothing = {
        "points-touch", 1.0,
        "These two are points and fly through each other. What have they "
        "got that could touch?"};
    /* Numbers that no step rounds. */
    static const struct scene points = {.n = 2,
                                        .m = {1.0, 1.0},
                                        .x = {0.0, 0.0, 8.0, 0.0},
                                        .v = {1.0, 0.0, -1.0, 0.0},
                                        .dt = 0.5,
                                        .every = 1,
                                        .rows = 20};
    double t, never;
    const struct scene hit = draw_shot(0.4, &t);
    const struct scene miss = draw_shot(1.05, &never);
    struct scene point = hit, apart = hit;
    point.r[0] = 0.0;
    point.r[1] = hit.r[0] + hit.r[1];
    for (int c = 0; c < 4; ++c)
        apart.v[c] = -hit.v[c];
    const double far = hypot(hit.x[2], hit.x[3]);
    const double b = 0.4 * (hit.r[0] + hit.r[1]);
    const double speed = hypot(hit.v[2] - hit.v[0], hit.v[3] - hit.v[1]);
    check_meeting(&hit, 0, 1, t, 1e-9 * t, sqrt(far * far - b * b) / speed);
    check_meeting(&point, 0, 1, t, 1e-9 * t,
                  sqrt(far * far - b * b) / speed);
    check_miss(&miss, near);
    check_miss(&apart, past);
    check_miss(&points, nothing);
    check_two_pairs();
    check_bent();
}

const struct check_suite check_suite = {
    .file = "P3-steps.c",
    .title = "Steps",
    .minutes = 240,
    .tests =
        {{"1 special cases: one body, one spring", stage_special, 3, 0},
         {"2 then generalize: bodies and springs, and leapfrog",
          stage_general, 5, 2},
         {"3 the order: a planet and an eight close", stage_order, 4, 0},
         {"4 how wrong is it: the program states its own error",
          stage_error, 6, 3},
         {"5 too stiff: a step that no spring survives", stage_stiff, 4, 0},
         {"6 tunnelling: two that meet inside a step", stage_meeting, 3, 0},
         {0}},
};
