/* The hidden tests of 06b, "A chain that forgets its rejections". */

#include "examiner/check.h"

enum { MOST = 12, TRIES = 60 };

/* In the suite: a chain with these random numbers, three for each try.
   Returns whether it ended after it had asked for just so many. */
bool chain_scripted(size_t n, double radius, double dish, double step,
                    size_t tries, const double script[], double x[],
                    double y[], size_t *accepted, double *mean);

/* Each disk has a spoke of its own, and is at some distance from the middle
   of the dish, in units of the dish's radius. A disk has a tenth of that.
   There may be 12 disks between 0.5 and 0.8 of the radius. */
struct ring {
    int n;
    double unit, far[MOST];
    double script[TRIES][3];
    int moved;
    double sum; /* of the squares of all distances, after each try */
};

enum { STEP = 3 };

static double angle(const struct ring *r, int i)
{
    return 6.28318530717958647693 * i / r->n;
}

/* The numbers that try to take disk i from its spoke to that of disk k, at
   the distance d. */
static void aim(struct ring *r, int t, int i, int k, double d)
{
    const double dx = d * cos(angle(r, k)) - r->far[i] * cos(angle(r, i));
    const double dy = d * sin(angle(r, k)) - r->far[i] * sin(angle(r, i));
    r->script[t][0] = (i + 0.5) / r->n;
    r->script[t][1] = 0.5 + dx / (2.0 * STEP);
    r->script[t][2] = 0.5 + dy / (2.0 * STEP);
}

/* In one of three tries a disk moves along its spoke; in the others it
   would come into another disk, or out of the dish. */
static void draw_tries(struct ring *r)
{
    for (int t = 0; t < TRIES; ++t) {
        const int i = check_draw_whole(0, r->n - 1);
        const int other = (i + check_draw_whole(1, r->n - 1)) % r->n;
        const double along = check_draw(0.5, 0.8);
        switch (check_draw_whole(0, 2)) {
        case 0:
            aim(r, t, i, i, along);
            r->far[i] = along;
            ++r->moved;
            break;
        case 1: aim(r, t, i, other, r->far[other]); break;
        default: aim(r, t, i, i, check_draw(0.92, 1.5)); break;
        }
        for (int k = 0; k < r->n; ++k)
            r->sum += r->far[k] * r->far[k];
    }
}

static void check(const struct ring *r, double got, double expected,
                  double tolerance, const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input =
                   check_text("%d disks of %g m in a ring, dish of %g m, "
                              "%d tries, a third of which are allowed",
                              r->n, 0.1 * r->unit, r->unit, TRIES),
               .expected = expected, .tolerance = tolerance,
               .because = "a few epsilons of the step for each try; what "
                          "is counted is exact",
               .equation = "eq:balance");
}

static void check_ring(double unit)
{
    struct ring r = {.n = check_draw_whole(2, MOST), .unit = unit};
    double x[MOST], y[MOST], mean = NAN;
    size_t moved = 0;
    for (int i = 0; i < r.n; ++i) {
        r.far[i] = check_draw(0.5, 0.8);
        x[i] = unit * r.far[i] * cos(angle(&r, i));
        y[i] = unit * r.far[i] * sin(angle(&r, i));
    }
    draw_tries(&r);
    const double few = 16.0 * DBL_EPSILON * TRIES * STEP * unit;
    check(&r,
          chain_scripted((size_t)r.n, 0.1 * unit, unit, STEP * unit, TRIES,
                         r.script[0], x, y, &moved, &mean),
          1.0, 0.0,
          "does it end, after three numbers for each try? (1 yes, 0 no)");
    check(&r, (double)moved, r.moved, 0.0, "accepted moves");
    check(&r, mean, unit * unit * r.sum / (r.n * TRIES), few * unit,
          "average of x^2 + y^2, in m^2");
    for (int i = 0; i < r.n; ++i) {
        check(&r, x[i], unit * r.far[i] * cos(angle(&r, i)), few,
              check_text("x of disk %d, in m", i));
        check(&r, y[i], unit * r.far[i] * sin(angle(&r, i)), few,
              check_text("y of disk %d, in m", i));
    }
}

CHECK_TIMES(20, test_ring, i)
{
    static const double unit[] = {1.0, 1e3, 1e-3, 1e-9, 1e9};
    check_ring(unit[i % 5]);
}

const struct check_test check_hidden[] = {
    {"a ring of disks, in metres or kilometres", test_ring, 3, 0}, {0}};
