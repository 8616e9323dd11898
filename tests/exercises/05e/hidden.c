/* The hidden tests of exercise 05e, "A check that finds the clock". */

#include "examiner/check.h"

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

struct judged {
    program *run;
    bool right;
    const char *how;
};

static program *tried;
static int calls;

static void counted(struct state s, double tick, size_t samples,
                    struct state kept[])
{
    ++calls;
    tried(s, tick, samples, kept);
}

/* Asks about both, in an order that is drawn; then tells. */
static void check_both(const struct judged both[2])
{
    int order[2], called[2];
    double said[2];
    size[0] = 1.5;
    size[1] = 2.5;
    check_shuffle(order, 2);
    for (int k = 0; k < 2; ++k) {
        tried = both[order[k]].run;
        calls = 0;
        said[order[k]] =
            clock_is_right(size[0], size[1], counted) ? 1.0 : 0.0;
        called[order[k]] = calls;
    }
    for (int i = 0; i < 2; ++i) {
        CHECK_NEAR(
            called[i] > 0,
            .quantity = "1 if the program that you judge was run at all",
            .input = both[i].how, .expected = 1.0, .because = "yes or no");
        CHECK_NEAR(
            said[i],
            .quantity = "what you say of a program (1 true, 0 false)",
            .input = both[i].how, .expected = both[i].right ? 1.0 : 0.0,
            .because = "yes or no");
    }
}

static void test_first(void)
{
    static const struct judged both[] = {
        {right, true, "a right program"},
        {from_zero, false, "one whose first sample is the start"}};
    check_both(both);
}

static void test_axis(void)
{
    static const struct judged both[] = {
        {right, true, "a right program"},
        {late, false, "one whose y lags behind by 0.01 ticks"}};
    check_both(both);
}

const struct check_test check_hidden[] = {
    {"one that records the start is refused", test_first, 1, 0},
    {"one whose y is late is refused", test_axis, 1, 0},
    {0}};
