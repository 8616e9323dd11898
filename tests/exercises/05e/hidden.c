/* What the grader also asks of exercise 05e: a program that takes a step
   behind the wall, one that has forgotten y, and one that begins too late.
 */

#include "examiner/check.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct state {
    double x, y, vx, vy;
};

typedef void program(struct state start, double tick, size_t samples,
                     struct state kept[]);

bool clock_is_right(double width, double height, program *run);

static double size[2];

/* A zigzag between 0 and the length, from a remainder. */
static double zigzag(double x, double length)
{
    const double rest =
        fmod(fmod(x, 2.0 * length) + 2.0 * length, 2.0 * length);
    return length - fabs(length - rest);
}

static double slope(double x, double length)
{
    return fmod(fmod(x, 2.0 * length) + 2.0 * length, 2.0 * length) < length
               ? 1.0
               : -1.0;
}

static void shifted(struct state s, double tick, size_t samples,
                    struct state kept[], double first, double late)
{
    for (size_t k = 0; k < samples; ++k) {
        const double t = ((double)k + first) * tick;
        const double x = s.x + s.vx * t, y = s.y + s.vy * (t - late);
        kept[k] = (struct state){zigzag(x, size[0]), zigzag(y, size[1]),
                                 s.vx * slope(x, size[0]),
                                 s.vy * slope(y, size[1])};
    }
}

static void right(struct state s, double tick, size_t samples,
                  struct state kept[])
{
    shifted(s, tick, samples, kept, 1.0, 0.0);
}

static void from_zero(struct state s, double tick, size_t samples,
                      struct state kept[])
{
    shifted(s, tick, samples, kept, 0.0, 0.0);
}

static void late(struct state s, double tick, size_t samples,
                 struct state kept[])
{
    shifted(s, tick, samples, kept, 1.0, 0.01 * tick);
}

static bool check(program *run, bool expected, const char *how)
{
    size[0] = 1.5;
    size[1] = 2.5;
    return CHECK_NEAR(
        clock_is_right(size[0], size[1], run) ? 1.0 : 0.0,
        .quantity = "what you say of a program (1 true, 0 "
                    "false)",
        .input = how, .expected = expected ? 1.0 : 0.0, .tolerance = 0.0,
        .because = "yes or no", .equation = "eq:disk-clock",
        .question = "Which sample would tell, and do you look "
                    "at both of its coordinates?");
}

static void test_first(void)
{
    (void)(check(right, true, "a right program") &&
           check(from_zero, false, "one whose first sample is the start"));
}

static void test_axis(void)
{
    (void)(check(right, true, "a right program") &&
           check(late, false, "one whose y lags behind by 0.01 ticks"));
}

const struct check_test check_hidden[] = {
    {"one that records the start is refused", test_first, 1, 0},
    {"one whose y is late is refused", test_axis, 1, 0},
    {0}};
