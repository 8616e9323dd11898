/* The suite of exercise 08a, "Drift, kick, drift". */

#include "examiner/check.h"
#include "call.h"

/* limit: 60 coordinates */
enum { MOST = 60 };

/* ---- what acts on the bodies ---- */

static struct {
    void (*law)(size_t n, const double x[], double a[]);
    size_t n, asked;
} forces;

void acceleration(const double x[], double a[])
{
    double copy[MOST];
    for (size_t i = 0; i < forces.n; ++i)
        copy[i] = x[i];
    forces.law(forces.n, copy, a);
    ++forces.asked;
}

/* A state, and the place behind it. */
struct state {
    double x[MOST + 1], v[MOST + 1];
};

/* The student's steps under this law. Returns how often the forces were
   asked for. */
size_t steps_under(void (*by)(size_t n, const double x[], double a[]),
                   size_t n, struct state *s, double dt, size_t steps)
{
    forces.law = by;
    forces.n = n;
    forces.asked = 0;
    s->x[n] = s->v[n] = 4096.0;
    drift_kick_drift(n, s->x, s->v, dt, steps);
    return forces.asked;
}

static void no_force(size_t n, const double x[], double a[])
{
    (void)x;
    for (size_t i = 0; i < n; ++i)
        a[i] = 0.0;
}

/* One coordinate with a spring to the origin, and a weight. */
static struct {
    double omega, weight;
} oscillator;

static double pull(double x)
{
    return -oscillator.omega * oscillator.omega * x + oscillator.weight;
}

static void spring_and_weight(size_t n, const double x[], double a[])
{
    for (size_t i = 0; i < n; ++i)
        a[i] = pull(x[i]);
}

/* ---- one coordinate: what comes out, and what the slips make of it ----
 */

struct point {
    double x, v;
};

struct slip {
    const char *name;
    struct point end;
    const char *hint;
};

enum { SLIPS = 9 };

static void slips_of(struct point p, double dt, struct slip slip[SLIPS])
{
    const double v = p.v, middle = p.x + 0.5 * dt * v;
    const double first = v + dt * pull(p.x), good = v + dt * pull(middle);
    const double kicked = v + 0.5 * dt * pull(p.x);
    const double weak = v + 0.5 * dt * pull(middle), far = p.x + dt * v;
    const double late = v + dt * pull(far);
    const double back = v - dt * pull(p.x - 0.5 * dt * v);
    const double leapt = p.x + dt * kicked;
    const struct slip all[SLIPS] = {
        {"kick-drift-kick",
         {leapt, kicked + 0.5 * dt * pull(leapt)},
         "This is the leapfrog of the book, which begins with a kick. "
         "Which of the two comes first here?"},
        {"two-whole-drifts",
         {far + dt * late, late},
         "Both drifts last a whole step here. For how much time should the "
         "coordinates move in one step?"},
        {"half-a-kick",
         {middle + 0.5 * dt * weak, weak},
         "The kick lasts half a step only. For how much time does the "
         "force act in one step?"},
        {"force-of-the-beginning",
         {middle + 0.5 * dt * first, first},
         "This is the force at the beginning of the step. Where are the "
         "coordinates when they are kicked?"},
        {"kick-then-drift",
         {p.x + dt * first, first},
         "This is one kick and one drift: the symplectic Euler method, of "
         "order 1. Where are the two halves of the drift?"},
        {"drift-then-kick",
         {far, late},
         "This is one drift and one kick: the symplectic Euler method, of "
         "order 1. Where are the two halves of the drift?"},
        {"velocity-of-the-beginning",
         {far, good},
         "Both halves of the drift were done with the old velocity. Which "
         "velocity is there after the kick?"},
        {"stops-half-way",
         {middle, good},
         "The coordinates have remained in the middle of the step. Which "
         "half of the drift is missing?"},
        {"always-forward",
         {p.x - dt * v + 0.5 * dt * dt * pull(p.x - 0.5 * dt * v), back},
         "This is a step forwards in time. Which sign had dt?"}};
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = all[i];
}

static bool near(double a, double b)
{
    return fabs(a - b) <= 1e-12 * (fabs(a) + fabs(b));
}

/* limit: 1 (coordinate) */
/* One step of one coordinate; expected is what has been worked out by
   hand. The slips are those that explain both x and v. */
static void check_step(struct point p, double dt, struct point expected)
{
    struct state s = {.x = {p.x}, .v = {p.v}};
    struct slip slip[SLIPS];
    (void)steps_under(spring_and_weight, 1, &s, dt, 1);
    slips_of(p, dt, slip);
    for (int k = 0; k < 2; ++k) {
        const double got = k == 0 ? s.x[0] : s.v[0];
        const double size =
            fabs(p.x) + fabs(p.v) + fabs(expected.x) + fabs(expected.v);
        struct check c = {
            .quantity = k == 0 ? "x after one step" : "v after one step",
            .unit = k == 0 ? "m" : "m/s",
            .input = check_text(
                "x = %g m, v = %g m/s, dt = %g s, a(x) = %g - %g x", p.x,
                p.v, dt, oscillator.weight,
                oscillator.omega * oscillator.omega),
            .expected = k == 0 ? expected.x : expected.v,
            .tolerance = 16.0 * DBL_EPSILON * size,
            .because = "16 epsilons of all that is added up"};
        for (size_t i = 0, used = 0; i < SLIPS; ++i)
            if (near(s.x[0], slip[i].end.x) && near(s.v[0], slip[i].end.v))
                c.mistakes[used++] =
                    (struct check_mistake){slip[i].name, got, slip[i].hint};
        check_near(got, c);
    }
}

/* ---- the tests ---- */

/* A coordinate of many that fly freely. */
static void check_free(size_t n, size_t i, double got, double expected,
                       const char *quantity)
{
    CHECK_NEAR(
        got, .quantity = check_text("%s[%zu]", quantity, i),
        .input = check_text("%zu coordinates without forces, three steps "
                            "of 0.5 s; x[i] = i m and v[i] = 2 - i m/s",
                            n, i),
        .expected = expected,
        .because = "these numbers are exact in binary",
        .question = "Nothing acts on these bodies. Where is each of them "
                    "after 1.5 s, and what stands behind the last one?",
        .mistakes = {
            {"two-whole-drifts",
             i < n && *quantity == 'x' ? i + 3.0 * (2.0 - i) : NAN,
             "They have flown for 3 s. How long does each of the two "
             "drifts of a step last?"},
            {"stops-half-way",
             i < n && *quantity == 'x' ? i + 0.75 * (2.0 - i) : NAN,
             "They have flown for half the time. Which half of the drift "
             "is missing?"},
            {"one-step-only",
             i < n && *quantity == 'x' ? i + 0.5 * (2.0 - i) : NAN,
             "They have flown for 0.5 s. How many steps were wanted?"}});
}

static void test_free(void)
{
    for (size_t n = 1; n <= 4; n += 3) {
        struct state s;
        for (size_t i = 0; i < n; ++i) {
            s.x[i] = (double)i;
            s.v[i] = 2.0 - (double)i;
        }
        (void)steps_under(no_force, n, &s, 0.5, 3);
        for (size_t i = 0; i <= n; ++i) {
            check_free(n, i, s.x[i],
                       i < n ? 1.5 * (2.0 - (double)i) + (double)i : 4096.0,
                       "x");
            check_free(n, i, s.v[i], i < n ? 2.0 - (double)i : 4096.0, "v");
        }
    }
}

/* x0 + v t - 5 t^2: a parabola is exact. */
static void test_stone(void)
{
    oscillator.omega = 0.0;
    oscillator.weight = -10.0;
    check_ask(
        "A stone is thrown upwards with 12 m/s. Where is it half a second "
        "later, and where after the other half, with the new velocity?");
    check_step((struct point){0.0, 12.0}, 1.0, (struct point){7.0, 2.0});
    check_ask("A stone on its parabola: which velocity has each half of "
              "the drift?");
    check_step((struct point){2.0, 3.0}, 0.5, (struct point){2.25, -2.0});
    check_ask("The step goes back in time. Where did the stone come from?");
    check_step((struct point){2.25, -2.0}, -0.5, (struct point){2.0, 3.0});
}

/* By hand, with omega = 1/s: from x = 1 and v = 2 and dt = 1/2 the middle
   is 3/2, the kick -3/4, and so the end 3/2 + 5/16. From x = 1 and v = 0
   and dt = 1 the kick is -1 at x = 1, and the second half drift goes by
   -1/2. From x = 0 and v = 1 the middle is 1/2, the kick -1/2, the end 1/2
   + 1/4. */
static void test_oscillator(void)
{
    oscillator.omega = 1.0;
    oscillator.weight = 0.0;
    check_ask("Follow the step on paper: half a drift, a kick, half a "
              "drift. Where is the coordinate after each?");
    check_step((struct point){1.0, 2.0}, 0.5, (struct point){1.8125, 1.25});
    check_ask(
        "Begin at x = 0: where is the middle of the step, how large is the "
        "kick there, and where does the second half of the drift end?");
    check_step((struct point){0.0, 1.0}, 1.0, (struct point){0.75, 0.5});
    check_ask("Begin at rest: in which half of the step does the "
              "coordinate move?");
    check_step((struct point){1.0, 0.0}, 1.0, (struct point){0.5, -1.0});
}

static void test_asked(void)
{
    for (size_t steps = 1; steps <= 7; steps += 2) {
        struct state s = {.x = {0.5, 1.0, -1.0, 0.25}};
        oscillator.omega = 1.0;
        oscillator.weight = 0.5;
        const double asked =
            (double)steps_under(spring_and_weight, 4, &s, 0.25, steps);
        CHECK_NEAR(
            asked, .quantity = "how often the forces were asked for",
            .input = check_text("4 coordinates, %zu step%s", steps,
                                steps == 1 ? "" : "s"),
            .expected = (double)steps, .because = "a number is exact",
            .question = "Forces are what costs time in a large run. How "
                        "many kicks has a step?",
            .mistakes = {
                {"one-after-the-other", 4.0 * (double)steps,
                 "Four times a step: once for each coordinate. Where must "
                 "ALL of them be when the force on one is asked for?"},
                {"asks-twice", 2.0 * (double)steps,
                 "Twice a step. Have the coordinates moved between the "
                 "two?"},
                {"one-step-only", 1.0,
                 "Once in all. How many steps were wanted?"}});
    }
}

/* One coordinate after many steps. On an oscillator each step turns a
   circle by 2 asin(omega dt/2), once v is measured in units of omega x /
   sqrt(1 - (omega dt/2)^2): that is the matrix of the step in its powers.
   A rounding of some epsilons in each step adds up. */
static struct point turned(struct point p, double z, double omega,
                           size_t steps)
{
    const double flat = sqrt((1.0 - 0.5 * z) * (1.0 + 0.5 * z));
    const double angle = 2.0 * (double)steps * asin(0.5 * z);
    const double up = flat * p.v / omega, c = cos(angle), s = sin(angle);
    return (struct point){c * p.x + s * up,
                          (c * up - s * p.x) * omega / flat};
}

CHECK_TIMES(20, test_many, i)
{
    const struct point p = {check_draw(-3.0, 3.0), check_draw(-3.0, 3.0)};
    const double z = check_draw(0.1, 1.6);
    const double dt = check_draw(0.1, 4.0);
    const size_t steps = (size_t)check_draw_whole(2, 300);
    struct state s = {.x = {p.x}, .v = {p.v}};
    oscillator.omega = z / dt;
    oscillator.weight = 0.0;
    const struct point end = turned(p, z, z / dt, steps);
    const struct point one = turned(p, z, z / dt, 1);
    const double size = 2.0 * (fabs(p.x) + fabs(p.v) * dt / z);
    const double tolerance =
        (8.0 * (double)steps + 16.0) * DBL_EPSILON * size;
    const char *input = check_text(
        "a(x) = -(%.17g)^2 x, from x = %g m, v = %g m/s, %zu steps of %g s",
        z / dt, p.x, p.v, steps, dt);
    (void)steps_under(spring_and_weight, 1, &s, dt, steps);
    CHECK_NEAR(
        s.x[0], .quantity = "x at the end", .unit = "m", .input = input,
        .expected = end.x, .tolerance = tolerance,
        .because = "8 epsilons of the amplitude a step",
        .question =
            "One step was right. What is different in the second one?",
        .mistakes = {
            {"one-step-only", one.x,
             "This is where one step leads. How many were wanted?"}});
    CHECK_NEAR(
        s.v[0], .quantity = "v at the end", .unit = "m/s", .input = input,
        .expected = end.v, .tolerance = tolerance * z / dt / 0.6,
        .because = "8 epsilons of the amplitude a step",
        .question =
            "x is right at the end. Does v belong to the same time?");
}

/* Coordinates that all pull at each other: seen in a mirror, which is
   across the direction u, each is an oscillator by itself. */
static struct {
    double u[MOST], omega[MOST];
} modes;

static void mirror(size_t n, const double x[], double image[])
{
    double along = 0.0, uu = 0.0;
    for (size_t i = 0; i < n; ++i) {
        along += modes.u[i] * x[i];
        uu += modes.u[i] * modes.u[i];
    }
    for (size_t i = 0; i < n; ++i)
        image[i] = x[i] - 2.0 * along / uu * modes.u[i];
}

static void coupled(size_t n, const double x[], double a[])
{
    double q[MOST];
    mirror(n, x, q);
    for (size_t i = 0; i < n; ++i)
        q[i] *= -modes.omega[i] * modes.omega[i];
    mirror(n, q, a);
}

static void check_coupled(size_t n)
{
    struct state s, end;
    double q[MOST], w[MOST];
    const double dt = check_draw(0.1, 2.0);
    const size_t steps = (size_t)check_draw_whole(1, 50);
    for (size_t i = 0; i < n; ++i) {
        modes.u[i] = check_draw(0.2, 1.0);
        modes.omega[i] = check_draw(0.1, 1.6) / dt;
        s.x[i] = check_draw(-3.0, 3.0);
        s.v[i] = check_draw(-3.0, 3.0) / dt;
    }
    mirror(n, s.x, q);
    mirror(n, s.v, w);
    for (size_t i = 0; i < n; ++i) {
        const struct point p =
            turned((struct point){q[i], w[i]}, modes.omega[i] * dt,
                   modes.omega[i], steps);
        q[i] = p.x;
        w[i] = p.v;
    }
    mirror(n, q, end.x);
    mirror(n, w, end.v);
    (void)steps_under(coupled, n, &s, dt, steps);
    /* Amplitudes are below 3 + 3/0.1 each, and up to n of them and the
       roundings of two mirrors meet in one coordinate. */
    const double tolerance =
        (8.0 * (double)steps + 4.0 * (double)n + 16.0) * DBL_EPSILON *
        33.0 * (double)n;
    for (size_t i = 0; i < n; ++i)
        for (int k = 0; k < 2; ++k)
            CHECK_NEAR(
                k == 0 ? s.x[i] : s.v[i] * dt,
                .quantity =
                    check_text(k == 0 ? "x[%zu]" : "v[%zu] times dt", i),
                .unit = "m",
                .input = check_text(
                    "%zu oscillators that are coupled, %zu steps of %g s",
                    n, steps, dt),
                .expected = k == 0 ? end.x[i] : end.v[i] * dt,
                .tolerance = tolerance,
                .because = "some epsilons of all the amplitudes",
                .question = "Each coordinate pulls at all the others. "
                            "Where are they when the force is asked for?");
}

static void test_coupled(void)
{
    static const size_t n[] = {2, 3, 2, 5, 3, 8, 13, MOST};
    for (size_t i = 0; i < sizeof n / sizeof n[0]; ++i)
        check_coupled(n[i]);
}

/* A chain of pendulums. */
static void pendulums(size_t n, const double x[], double a[])
{
    for (size_t i = 0; i < n; ++i)
        a[i] = -sin(x[i]) + sin(x[(i + 1) % n] - x[i]) +
               sin(x[(i + n - 1) % n] - x[i]);
}

/* Neighbours that swing apart lose digits: over 4 s a rounding grows by
   e^(2 s/s * 4 s) at most, which is less than 3000. */
CHECK_TIMES(5, test_back, i)
{
    struct state s;
    double x[5], v[5];
    const double dt = check_draw(0.05, 0.2);
    const size_t steps = (size_t)(4.0 / dt);
    for (int k = 0; k < 5; ++k) {
        s.x[k] = x[k] = check_draw(-2.0, 2.0);
        s.v[k] = v[k] = check_draw(-1.0, 1.0);
    }
    (void)steps_under(pendulums, 5, &s, dt, steps);
    (void)steps_under(pendulums, 5, &s, -dt, steps);
    for (int k = 0; k < 5; ++k)
        CHECK_NEAR(
            s.x[k], .quantity = check_text("x[%d]", k),
            .input = check_text("five pendulums, %zu steps of %g and %zu "
                                "of -%g; v[%d] was %g",
                                steps, dt, steps, dt, k, v[k]),
            .expected = x[k], .tolerance = 1e-10,
            .because =
                "a rounding grows 3000 times at most, in each of 160 steps",
            .question = "Forth and back again: read your step backwards. "
                        "Is it the same step?");
}

static void test_none(void)
{
    struct state s = {.x = {1.0, 2.0}, .v = {3.0, 4.0}};
    oscillator.omega = 1.0;
    oscillator.weight = 1.0;
    const double asked =
        (double)steps_under(spring_and_weight, 2, &s, 0.5, 0);
    const double got[] = {s.x[0], s.x[1], s.v[0], s.v[1], asked};
    static const double expected[] = {1.0, 2.0, 3.0, 4.0, 0.0};
    static const char *const quantity[] = {
        "x[0]", "x[1]", "v[0]", "v[1]",
        "how often the forces were asked for"};
    for (int k = 0; k < 5; ++k)
        CHECK_NEAR(got[k], .quantity = quantity[k],
                   .input = "2 coordinates, no step",
                   .expected = expected[k],
                   .because = "nothing is to be done",
                   .question = "No step: what has to change?");
}

const struct check_suite check_suite = {
    .file = "08a-drift.c",
    .title = "Drift, kick, drift",
    .minutes = 20,
    .equation = "eq:verlet",
    .tests = {{"without forces bodies fly straight on", test_free, 1, 0},
              {"one step of an oscillator, as on paper", test_oscillator, 2,
               0},
              {"a stone flies along its parabola", test_stone, 2, 0},
              {"the forces are asked for once a step", test_asked, 1, 0},
              {"no step changes nothing", test_none, 1, 0},
              {"many steps of an oscillator turn a circle", test_many, 2,
               2},
              {"coordinates that act on each other", test_coupled, 2, 2},
              {"forth and back again", test_back, 1, 1},
              {0}},
    .idle = {test_none, test_back},
};
