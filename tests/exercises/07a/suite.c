/* The suite of exercise 07a: the middle of a box, its sides and corners,
   positions outside, edges, a hair below an edge, few columns or rows, and
   drawn boxes. */

#include "examiner/check.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9]);

struct job {
    double box[2];
    size_t cells[2];
    double at[2];
};

enum { MOST = 9 };

/* Untouched places hold a number that no cell has. */
static const size_t untouched = (size_t)-1;

struct list {
    size_t count, cell[MOST];
};

/* What the student makes of a list that holds something already. */
static struct list answer(const struct job *j, struct list l)
{
    l.count = cells_around(j->box, j->cells, j->at, l.cell);
    return l;
}

static struct list unfilled(void)
{
    struct list l = {0};
    for (size_t k = 0; k < MOST; ++k)
        l.cell[k] = untouched;
    return l;
}

static const char *input(const struct job *j)
{
    return check_text("box %g m by %g m, %zu columns and %zu rows, "
                      "position (%.17g m, %.17g m)",
                      j->box[0], j->box[1], j->cells[0], j->cells[1],
                      j->at[0], j->at[1]);
}

/* Where a slip is made; each of them gives a list of its own. */
enum slip {
    NONE,
    CUT,     /* rounds towards zero */
    ROUNDED, /* rounds to the nearest */
    CLAMPED, /* takes what is outside into the cell at the side */
    END,     /* has the side itself in the last cell */
    HAIR,    /* has a hair below a side in the first cell */
    WIDTH,   /* cells as high as they are wide */
    BY_ROW,  /* number = row + rows times column */
    WALLS    /* no neighbours across the sides */
};

/* A position that no formula but a careful one leaves below the side. */
static bool is_a_hair_below(double x, double side)
{
    return (x < 0.0 && x + side == side) || x == nextafter(side, 0.0);
}

/* The last column that begins at or before x, in a box that is folded. */
static long exact(double x, double side, long n)
{
    long k = n - 1;
    x = fmod(x, side);
    x = x < 0.0 ? x + side : x;
    while (k > 0 && (double)k * side / (double)n > x)
        --k;
    return k;
}

static long place(double x, double side, long n, enum slip slip)
{
    const double part = x * (double)n / side;
    const long last = n - 1, right = exact(x, side, n);
    /* Where these look like the slips of an edge, they tell nothing. */
    if (slip < END && (x == side || is_a_hair_below(x, side)))
        return right;
    switch (slip) {
    case CUT: return (((long)part) % n + n) % n;
    case ROUNDED: return ((long)floor(part + 0.5) % n + n) % n;
    case CLAMPED: return part < 0.0 ? 0 : part >= (double)n ? last : right;
    case END: return x == side ? last : right;
    case HAIR: return is_a_hair_below(x, side) ? 0 : right;
    default: return right;
    }
}

/* Whether columns a and b of n are the same or touch. */
static bool touch(long a, long b, long n, enum slip slip)
{
    const long apart = labs(a - b);
    return apart <= 1 || (slip != WALLS && apart >= n - 1);
}

/* All cells are asked, in the order of their numbers. */
static struct list searched(const struct job *j, enum slip slip)
{
    const long nx = (long)j->cells[0], ny = (long)j->cells[1];
    const double high =
        slip == WIDTH ? j->box[0] / (double)nx * (double)ny : j->box[1];
    const long column = place(j->at[0], j->box[0], nx, slip);
    const long row = place(j->at[1], high, ny, slip);
    struct list l = {0};
    for (long k = 0; k < nx * ny; ++k) {
        const bool by_row = slip == BY_ROW;
        const long x = by_row ? k / ny : k % nx;
        const long y = by_row ? k % ny : k / nx;
        if (touch(x, column, nx, slip) && touch(y, row, ny, slip) &&
            l.count < MOST)
            l.cell[l.count++] = (size_t)k;
    }
    return l;
}

/* Whether each cell of the one list is in the other. */
static bool holds(const struct list *all, const struct list *some)
{
    for (size_t k = 0; k < some->count; ++k) {
        size_t i = 0;
        while (i < all->count && all->cell[i] != some->cell[k])
            ++i;
        if (i == all->count)
            return false;
    }
    return true;
}

/* Whether two lists have the same cells, whatever their order. */
static bool same_cells(const struct list *a, const struct list *b)
{
    return a->count <= MOST && b->count <= MOST && holds(a, b) &&
           holds(b, a);
}

static bool check_count(const struct job *j, const struct list *got,
                        const struct list *wanted, const char *question)
{
    const double count = (double)got->count, right = (double)wanted->count;
    const bool twice = count > right && same_cells(got, wanted);
    return CHECK_NEAR(
        count, .quantity = "how many cells were found", .unit = "",
        .input = input(j), .expected = right, .tolerance = 0.0,
        .because = "a number of cells is exact",
        .equation = "eq:cell-index", .question = question,
        .mistakes = {
            {"cell-twice", twice ? count : right,
             "All the cells are there, some more than once. With two "
             "columns, which one is on the left of the first, and which on "
             "its right? What would a gas do with a collision that is "
             "foretold twice?"},
            {"sides-not-joined", (double)searched(j, WALLS).count,
             "At the side of the box some cells are missing, as if it had "
             "walls. What is on the left of the first column?"},
            {"corners-forgotten", right == 9.0 ? 5.0 : right,
             "These are the cells that share a side with the position's "
             "own, and that one. Can two disks touch across a corner?"},
            {"own-cell-forgotten", right - 1.0,
             "One is missing. Where is a partner that is in the same cell "
             "as the position?"}});
}

static double number(const struct list *l, size_t k)
{
    return k < MOST && l->cell[k] != untouched ? (double)l->cell[k] : NAN;
}

/* What stands at k if the whole list is the one that a slip gives, or else
   what is right, which no mistake is known by. */
static double slipped(const struct job *j, enum slip slip,
                      const struct list *got, size_t k)
{
    const struct list made = searched(j, slip), right = searched(j, NONE);
    return number(same_cells(&made, got) ? &made : &right, k);
}

static bool check_cell(const struct job *j, const struct list *got,
                       const struct list *wanted, size_t k,
                       const char *question)
{
    const double right = number(wanted, k);
    const bool disorder = same_cells(got, wanted);
    return CHECK_NEAR(
        number(got, k), .quantity = check_text("around[%zu]", k),
        .unit = "", .input = input(j), .expected = right, .tolerance = 0.0,
        .because = "a number of a cell is exact",
        .equation = "eq:cell-index", .question = question,
        .mistakes = {
            {"not-in-order", disorder ? number(got, k) : right,
             "All the cells are there, in another order. Which of two "
             "neighbours has the smaller number when one of them is across "
             "the seam?"},
            {"column-first", slipped(j, BY_ROW, got, k),
             "This counts the cells up the first column, then up the next. "
             "By how much does a number grow from one column to the next, "
             "and by how much from a row to the one above?"},
            {"hair-in-first-cell", slipped(j, HAIR, got, k),
             "A position a hair below a side has come out in the first "
             "cell. Where did rounding turn it into the side itself, or "
             "its column into n, and which cell is the last?"},
            {"end-in-last-cell", slipped(j, END, got, k),
             "The side itself is where the box begins again. Is it > or >= "
             "that brings it back to 0?"},
            {"one-width-for-both", slipped(j, WIDTH, got, k),
             "The row would be right if the cells were as high as they are "
             "wide. Which side and which number belong to y?"},
            {"cut-towards-zero", slipped(j, CUT, got, k),
             "The conversion to a whole number makes -1 of -1.25. In which "
             "column is a position a little to the left of the box?"},
            {"outside-clamped", slipped(j, CLAMPED, got, k),
             "A position outside was taken into the nearest cell at the "
             "side. Of which place in the box is it a copy, perhaps by "
             "more than one period?"},
            {"rounded-to-nearest", slipped(j, ROUNDED, got, k),
             "This rounds to the nearest whole number. How far does the "
             "first column reach, and what do you get just before its "
             "end?"}});
}

/* Once with an unfilled list, and once with one that holds the right cells
   beforehand. */
static bool check_list(const struct job *j, const struct list *wanted,
                       const char *question)
{
    const struct list got = answer(j, unfilled());
    if (!check_count(j, &got, wanted, question))
        return false;
    for (size_t k = 0; k < wanted->count; ++k)
        if (!check_cell(j, &got, wanted, k, question))
            return false;
    const struct list again = answer(j, *wanted);
    return check_count(j, &again, wanted,
                       "Whatever `around` holds beforehand means nothing. "
                       "Do you read a place before you have filled it?");
}

/* Against a list by hand. */
static bool check_by_hand(struct job j, struct list wanted,
                          const char *question)
{
    return check_list(&j, &wanted, question);
}

/* Against a look at every cell. */
static bool check_searched(struct job j, const char *question)
{
    const struct list wanted = searched(&j, NONE);
    return check_list(&j, &wanted, question);
}

/* Eight columns, 2 m wide, and five rows, 3 m high. */
static struct job at(double x, double y)
{
    return (struct job){{16.0, 15.0}, {8, 5}, {x, y}};
}

static void test_middle(void)
{
    static const char question[] =
        "The position is in the middle of a cell, and no side of the box "
        "is near. Column, row, number: which comes from which?";
    (void)(check_by_hand(
               at(9.0, 7.5),
               (struct list){9, {11, 12, 13, 19, 20, 21, 27, 28, 29}},
               question) &&
           check_by_hand(
               at(3.75, 11.5),
               (struct list){9, {16, 17, 18, 24, 25, 26, 32, 33, 34}},
               question));
}

static void test_sides(void)
{
    static const char question[] =
        "What is on the left of the first column, and what above the last "
        "row? And where in an ascending list do these cells stand?";
    (void)(check_by_hand(
               at(0.5, 7.5),
               (struct list){9, {8, 9, 15, 16, 17, 23, 24, 25, 31}},
               question) &&
           check_by_hand(at(15.5, 4.5),
                         (struct list){9, {0, 6, 7, 8, 14, 15, 16, 22, 23}},
                         question) &&
           check_by_hand(
               at(5.0, 14.0),
               (struct list){9, {1, 2, 3, 25, 26, 27, 33, 34, 35}},
               question) &&
           check_by_hand(
               at(15.0, 14.0),
               (struct list){9, {0, 6, 7, 24, 30, 31, 32, 38, 39}},
               question) &&
           check_by_hand(at(0.25, 0.5),
                         (struct list){9, {0, 1, 7, 8, 9, 15, 32, 33, 39}},
                         question));
}

static void test_outside(void)
{
    static const char question[] =
        "Move the position by whole sides until it is in the box: where is "
        "it? How many sides does your program move it by, and for which "
        "sign?";
    static const double away[][2] = {{17.0, 7.5},   {-2.5, 7.5},
                                     {9.0, -1.0},   {-5.0, 20.0},
                                     {41.0, -36.5}, {-57.0, 100.0}};
    for (size_t k = 0; k < sizeof away / sizeof away[0]; ++k)
        if (!check_searched(at(away[k][0], away[k][1]), question))
            return;
}

static void test_edges(void)
{
    static const char question[] =
        "A cell owns its left and its lower edge. Whose is this position, "
        "and what is the same as the upper end of the box?";
    static const double edge[][2] = {
        {6.0, 7.5},   {9.0, 6.0},   {0.0, 0.0},    {16.0, 7.5}, {9.0, 15.0},
        {16.0, 15.0}, {32.0, 30.0}, {-16.0, 45.0}, {-2.0, -3.0}};
    for (size_t k = 0; k < sizeof edge / sizeof edge[0]; ++k)
        if (!check_searched(at(edge[k][0], edge[k][1]), question))
            return;
}

/* With these sides and numbers x n/L, x/(L/n) and x (n/L) are all rounded
   up to n for the largest x below L. */
static void test_hair(void)
{
    static const char question[] =
        "The position is below the side by less than your numbers can "
        "tell. In which cell is it, and what do you do when rounding says "
        "n?";
    const double x = nextafter(7.3, 0.0), y = nextafter(15.3, 0.0);
    static const double box[2] = {7.3, 15.3};
    const double place[][2] = {{-1e-20, 4.0},     {4.0, -1e-20},
                               {-1e-300, -1e-18}, {x, 4.0},
                               {4.0, y},          {x, y}};
    for (size_t k = 0; k < sizeof place / sizeof place[0]; ++k) {
        const struct job j = {
            {box[0], box[1]}, {6, 5}, {place[k][0], place[k][1]}};
        if (!check_searched(j, question))
            return;
    }
}

static bool check_few(size_t columns, size_t rows, struct list wanted)
{
    const struct job j = {{12.0, 12.0}, {columns, rows}, {7.0, 5.0}};
    return check_list(&j, &wanted,
                      "With so few columns or rows, who is a neighbour of "
                      "whom, and on how many sides?");
}

static void test_few(void)
{
    (void)(check_few(1, 1, (struct list){1, {0}}) &&
           check_few(2, 1, (struct list){2, {0, 1}}) &&
           check_few(2, 2, (struct list){4, {0, 1, 2, 3}}) &&
           check_few(3, 3, (struct list){9, {0, 1, 2, 3, 4, 5, 6, 7, 8}}) &&
           check_few(2, 6, (struct list){6, {2, 3, 4, 5, 6, 7}}) &&
           check_few(6, 1, (struct list){3, {2, 3, 4}}) &&
           check_few(1, 6, (struct list){3, {1, 2, 3}}) &&
           check_few(4, 3,
                     (struct list){9, {1, 2, 3, 5, 6, 7, 9, 10, 11}}));
}

/* Every cell is asked how many columns and rows it is away, on a ring of so
   many. */
static struct list next_to(const struct job *j, int column, int row)
{
    const int nx = (int)j->cells[0], ny = (int)j->cells[1];
    struct list l = {0};
    for (int k = 0; k < nx * ny; ++k)
        if (fabs(remainder(k % nx - column, nx)) <= 1.0 &&
            fabs(remainder(k / nx - row, ny)) <= 1.0)
            l.cell[l.count++] = (size_t)k;
    return l;
}

/* A box, and a cell in it: at first of a few, later of many. The position
   is in the inner nine tenths of the cell, so that no rounding matters, and
   up to three periods away. */
static void test_drawn(void)
{
    for (int i = 0; i < 200; ++i) {
        struct job j;
        int own[2];
        for (int k = 0; k < 2; ++k) {
            const int n = check_draw_whole(1, i < 100 ? 5 : 30);
            own[k] = check_draw_whole(0, n - 1);
            j.cells[k] = (size_t)n;
            j.box[k] = check_draw(1.0, 20.0);
            j.at[k] = (check_draw_whole(-3, 3) +
                       (own[k] + check_draw(0.05, 0.95)) / n) *
                      j.box[k];
        }
        const struct list wanted = next_to(&j, own[0], own[1]);
        if (!check_list(&j, &wanted,
                        "Here your list is not that of somebody who looked "
                        "at every cell. Which cell is missing, or too "
                        "much?"))
            return;
    }
}

const struct check_suite check_suite = {
    .file = "07a-around.c",
    .title = "The cells around a position",
    .minutes = 20,
    .tests = {{"in the middle of the box nine cells are around",
               test_middle, 1, 0},
              {"opposite sides of the box are joined", test_sides, 2, 0},
              {"outside of the box everything repeats", test_outside, 1, 0},
              {"a cell owns its left and its lower edge", test_edges, 1, 0},
              {"a hair below a side is still in the last cell", test_hair,
               1, 0},
              {"with few columns or rows each cell comes once", test_few, 2,
               0},
              {"drawn boxes give what a look at every cell gives",
               test_drawn, 2, 3},
              {0}},
};
