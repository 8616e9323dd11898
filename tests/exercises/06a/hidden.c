/* The hidden tests of exercise 06a, "A sampler that keeps what fitted". */

#include "examiner/check.h"

enum { ROWS = 3, DISKS = ROWS * ROWS, THROWS = 3 };

/* In the suite: one call of the student's function with these random
   numbers. Returns whether it ended. */
bool throw_scripted(size_t n, const double radius[], const double size[2],
                    const double script[], size_t count, double x[],
                    double y[], size_t *throws);

/* A place for each disk, and the random numbers of it. */
struct placing {
    double at[DISKS][2], number[DISKS][2];
};

/* Disk i in a part of its own, so far from its edges that it stays in. */
static struct placing apart(const double radius[], const double size[2])
{
    struct placing p;
    const int turn = check_draw_whole(0, DISKS - 1);
    const int step = check_draw_whole(0, 1) ? 1 : 2; /* has no factor 3 */
    for (int i = 0; i < DISKS; ++i) {
        const int part = (i * step + turn) % DISKS;
        const int cell[2] = {part % ROWS, part / ROWS};
        for (int k = 0; k < 2; ++k) {
            const double side = size[k] / ROWS, room = side - 2 * radius[i];
            p.at[i][k] =
                cell[k] * side + radius[i] + check_draw(0.02, 0.98) * room;
            p.number[i][k] =
                (p.at[i][k] - radius[i]) / (size[k] - 2.0 * radius[i]);
        }
    }
    return p;
}

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *input)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = tolerance,
               .because = "8 epsilons of the size of the box; a number of "
                          "throws is exact");
}

static void check_places(const struct placing *p, const double size[2],
                         const double x[], const double y[],
                         const char *input)
{
    for (int i = 0; i < DISKS; ++i) {
        check(x[i], p->at[i][0], 8.0 * DBL_EPSILON * size[0],
              check_text("x of disk %d", i), input);
        check(y[i], p->at[i][1], 8.0 * DBL_EPSILON * size[1],
              check_text("y of disk %d", i), input);
    }
}

/* Two throws in which the last disk falls where some other is, and one in
   which all fit. */
static void check_nine(double unit)
{
    const double size[2] = {unit * check_draw(3.0, 6.0),
                            unit * check_draw(3.0, 6.0)};
    double radius[DISKS], x[DISKS], y[DISKS];
    double script[THROWS][DISKS][2];
    struct placing p;
    size_t throws = 0;
    for (int i = 0; i < DISKS; ++i)
        radius[i] = unit * 0.4;
    for (int t = 0; t < THROWS; ++t) {
        const int on = check_draw_whole(0, DISKS - 2);
        p = apart(radius, size);
        for (int i = 0; i < DISKS; ++i)
            for (int k = 0; k < 2; ++k)
                script[t][i][k] = p.number[i][k];
        for (int k = 0; k < 2 && t + 1 < THROWS; ++k)
            script[t][DISKS - 1][k] = p.number[on][k];
    }
    const char *input = check_text(
        "nine disks of %g m in a box of %g m by %g m; in two throws the "
        "last one falls on another, in the third all fit",
        unit * 0.4, size[0], size[1]);
    check(throw_scripted(DISKS, radius, size, script[0][0],
                         sizeof script / sizeof(double), x, y, &throws),
          1.0, 0.0, "does it end? (1 yes, 0 no)", input);
    check_places(&p, size, x, y, input);
    check((double)throws, THROWS, 0.0, "how often all disks were thrown",
          input);
}

CHECK_TIMES(20, test_nine, i)
{
    static const double unit[] = {1.0, 1e3, 1e-3, 1e-9, 1e12};
    check_nine(unit[i % 5]);
}

/* A disk as wide as its box: along x there is only one place. */
CHECK_TIMES(10, test_full, i)
{
    const double radius = check_draw(0.1, 5.0);
    const double free = check_draw(0.1, 5.0);
    const double size[2] = {2.0 * radius, 2.0 * radius + free};
    const double script[2] = {check_draw(0.0, 0.9), check_draw(0.0, 0.9)};
    const char *input = check_text(
        "one disk of %g m in a box of %g m by %g m; uniform() gives %g %g",
        radius, size[0], size[1], script[0], script[1]);
    double x = NAN, y = NAN;
    size_t throws = 0;
    check(throw_scripted(1, &radius, size, script, 2, &x, &y, &throws), 1.0,
          0.0, "does it end? (1 yes, 0 no)", input);
    check(x, radius, 8.0 * DBL_EPSILON * size[0], "x of the disk", input);
    check(y, radius + script[1] * free, 8.0 * DBL_EPSILON * size[1],
          "y of the disk", input);
    check((double)throws, 1.0, 0.0, "how often all disks were thrown",
          input);
}

const struct check_test check_hidden[] = {
    {"nine disks, in metres or kilometres", test_nine, 2, 0},
    {"a disk as wide as its box", test_full, 1, 0},
    {0}};
