/* The hidden tests of exercise 08a, "Drift, kick, drift". */

#include "examiner/check.h"

enum { MOST = 60 };

struct state {
    double x[MOST + 1], v[MOST + 1];
};

/* In the suite: the student's steps under a law. */
size_t steps_under(void (*by)(size_t n, const double x[], double a[]),
                   size_t n, struct state *s, double dt, size_t steps);

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *input)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = tolerance,
               .because = "some epsilons a step of all that is added up");
}

/* A planet, whose force points to the sun whatever its strength. */
static void to_the_sun(size_t n, const double x[], double a[])
{
    const double r = hypot(x[0], x[1]);
    for (size_t i = 0; i < n; ++i)
        a[i] = i < 2 ? -x[i] / (r * r * r) : 0.0;
}

/* Drifts and central kicks keep the area that is swept in a second. In a
   step the product of r and v is rounded a few times. */
CHECK_TIMES(10, test_areas, i)
{
    const double r = check_draw(0.7, 1.3), angle = check_draw(0.0, 6.0);
    const double fast = check_draw(0.8, 1.2);
    const double dt = check_draw(0.01, 0.1);
    const size_t steps = (size_t)check_draw_whole(20, 200);
    struct state s = {.x = {r * cos(angle), r * sin(angle), 0.5},
                      .v = {-fast * sin(angle), fast * cos(angle), 0.25}};
    const char *input =
        check_text("a planet at %g m with %g m/s across, %zu steps of %g s",
                   r, fast, steps, dt);
    (void)steps_under(to_the_sun, 3, &s, dt, steps);
    check(s.x[0] * s.v[1] - s.x[1] * s.v[0], r * fast,
          (double)(steps + 4) * 1e-14, "angular momentum", input);
    check(s.x[2], 0.5 + 0.25 * dt * (double)steps,
          (double)(steps + 4) * 1e-14, "z", input);
}

/* Bodies on a ring that act on their neighbours alone. */
static void ring(size_t n, const double x[], double a[])
{
    for (size_t i = 0; i < n; ++i) {
        const double ahead = x[(i + 1) % n] - x[i];
        const double behind = x[(i + n - 1) % n] - x[i];
        a[i] = ahead / (1.0 + ahead * ahead) +
               behind / (1.0 + behind * behind);
    }
}

CHECK_TIMES(5, test_together, i)
{
    struct state s;
    double x = 0.0, v = 0.0, x_end = 0.0, v_end = 0.0;
    const double dt = check_draw(-0.5, 0.5);
    const size_t steps = (size_t)check_draw_whole(1, 100);
    for (size_t k = 0; k < MOST; ++k) {
        x += s.x[k] = check_draw(-5.0, 5.0);
        v += s.v[k] = check_draw(-1.0, 2.0);
    }
    (void)steps_under(ring, MOST, &s, dt, steps);
    for (size_t k = 0; k < MOST; ++k) {
        x_end += s.x[k];
        v_end += s.v[k];
    }
    const char *input = check_text("a ring of %d bodies, %zu steps of %g s",
                                   MOST, steps, dt);
    check(v_end, v, 1e-11, "sum of all v", input);
    check(x_end, x + v * dt * (double)steps, 1e-9, "sum of all x", input);
}

static double unit_of_time = 1.0;

static void cubic(size_t n, const double x[], double a[])
{
    for (size_t i = 0; i < n; ++i)
        a[i] = -x[i] * x[i] * x[i] / (unit_of_time * unit_of_time);
}

/* Another unit of time, a power of two, shifts exponents only. */
static void test_units(void)
{
    for (int i = 0; i < 10; ++i) {
        const double x = check_draw(0.5, 1.5), v = check_draw(-1.0, 1.0);
        const double dt = check_draw(0.01, 0.3);
        const size_t steps = (size_t)check_draw_whole(1, 50);
        struct state s = {.x = {x}, .v = {v}}, other = s;
        unit_of_time = 1.0;
        (void)steps_under(cubic, 1, &s, dt, steps);
        unit_of_time = ldexp(1.0, check_draw_whole(-60, 60));
        other.v[0] /= unit_of_time;
        (void)steps_under(cubic, 1, &other, dt * unit_of_time, steps);
        const char *input =
            check_text("a(x) = -x^3, x = %g, v = %g, %zu steps of %g, and "
                       "the same with %g times the unit of time",
                       x, v, steps, dt, unit_of_time);
        check(other.x[0], s.x[0], 1e-13, "x in the other units", input);
        check(other.v[0] * unit_of_time, s.v[0], 1e-13,
              "v in the other units", input);
    }
    unit_of_time = 1.0;
}

const struct check_test check_hidden[] = {
    {"equal areas in equal times", test_areas, 2, 0},
    {"many bodies move together as one", test_together, 2, 0},
    {"seconds or years", test_units, 1, 0},
    {0}};
