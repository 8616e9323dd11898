/* Further tests of exercise 07a, for the lecturer: many cells in boxes of
   any size, positions on edges, and positions a hair below a side. */

#include "examiner/check.h"
#include <math.h>
#include <stddef.h>

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9]);

/* A position, and the column and the row that it is in. */
struct job {
    double box[2], at[2];
    size_t cells[2];
    long own[2];
};

static const char *input(const struct job *j)
{
    return check_text("box %.17g m by %.17g m, %zu columns and %zu rows, "
                      "position (%.17g m, %.17g m)",
                      j->box[0], j->box[1], j->cells[0], j->cells[1],
                      j->at[0], j->at[1]);
}

static bool check(const struct job *j, double got, double expected,
                  const char *quantity, const char *question)
{
    return CHECK_NEAR(got, .quantity = quantity, .input = input(j),
                      .expected = expected, .tolerance = 0.0,
                      .because = "whole numbers are exact",
                      .equation = "eq:cell-index", .question = question);
}

/* Whether number a of n stands next to number b, or is the same. */
static bool is_next(long a, long b, size_t n)
{
    return fabs(remainder((double)(a - b), (double)n)) <= 1.0;
}

/* The rows that are near, and in them the columns that are near. */
static bool check_job(const struct job *j, const char *question)
{
    size_t around[9] = {0}, expected = 0;
    const size_t count = cells_around(j->box, j->cells, j->at, around);
    bool good = true;
    for (size_t y = 0; y < j->cells[1] && good; ++y) {
        if (!is_next((long)y, j->own[1], j->cells[1]))
            continue;
        for (size_t x = 0; x < j->cells[0] && good; ++x)
            if (is_next((long)x, j->own[0], j->cells[0])) {
                good = check(j, (double)around[expected],
                             (double)(y * j->cells[0] + x),
                             check_text("around[%zu]", expected), question);
                ++expected;
            }
    }
    return good && check(j, (double)count, (double)expected,
                         "how many cells were found", question);
}

/* Columns and rows by the hundred, or one or two of them, in any unit. */
static void test_many(void)
{
    for (int i = 0; i < 60; ++i) {
        const double unit = ldexp(1.0, check_draw_whole(-60, 60));
        struct job j;
        for (int k = 0; k < 2; ++k) {
            const int n = check_draw_whole(1, i % 2 == k ? 600 : 3);
            j.own[k] = check_draw_whole(0, n - 1);
            j.cells[k] = (size_t)n;
            j.box[k] = check_draw(1.0, 20.0) * unit;
            j.at[k] = (check_draw_whole(-9, 9) +
                       ((double)j.own[k] + check_draw(0.05, 0.95)) / n) *
                      j.box[k];
        }
        if (!check_job(&j, "Many columns, or few, in a box of another "
                           "size. Which numbers of yours depend on that?"))
            return;
    }
}

/* The numbers of columns and rows are powers of two, and so is the width of
   a cell: nothing is rounded, in whatever order one computes. */
static void test_edges(void)
{
    for (int i = 0; i < 60; ++i) {
        struct job j;
        for (int k = 0; k < 2; ++k) {
            const int n = 1 << check_draw_whole(0, 5);
            const double width = ldexp(1.0, check_draw_whole(-3, 3));
            j.own[k] = check_draw_whole(0, n - 1);
            j.cells[k] = (size_t)n;
            j.box[k] = n * width;
            j.at[k] =
                (double)(check_draw_whole(-9, 9) * n + j.own[k]) * width;
        }
        if (!check_job(&j, "The position is on a corner of four cells, "
                           "perhaps some periods away. Which of them owns "
                           "it?"))
            return;
    }
}

/* Just below the side, or just below zero, by less than can be added. */
static void test_hair(void)
{
    for (int i = 0; i < 60; ++i) {
        struct job j;
        for (int k = 0; k < 2; ++k) {
            const int n = check_draw_whole(1, 60);
            j.own[k] = n - 1;
            j.cells[k] = (size_t)n;
            j.box[k] = check_draw(1.0, 20.0);
            j.at[k] = check_draw_whole(0, 1)
                          ? nextafter(j.box[k], 0.0)
                          : -check_draw(0.1, 1.0) * 1e-17;
        }
        if (!check_job(&j, "The position is a hair below a side. Where "
                           "does your program round it to, and which cell "
                           "is the last?"))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"columns and rows by the hundred, and one or two", test_many, 1, 0},
    {"corners of four cells, periods away", test_edges, 2, 0},
    {"a hair below the side of any box", test_hair, 2, 0},
    {0}};
