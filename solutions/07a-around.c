/* Exercise 07a, worked: the cells around a position.

   First the position is brought into the box. fmod does not round, so the
   rest has the digits that the position had; a negative one lies one side
   further on. This sum may be rounded, and for a hair below 0 it is the
   side itself, where no cell begins any more. Nor does a product such as
   x n/L always stay below n when x is the largest number below L: for
   L = 7.3 and n = 6 it does not. Both are cured by one comparison at the
   end: what has become n belongs to the last cell.

   A neighbour is the remainder of column + n - 1, column + n or column + n
   + 1, divided by n. The n is there because a size_t knows no -1. With one
   column all three are this one, with two the left neighbour is the right
   one as well. So each of the nine is put where it belongs in the ordered
   list, unless it stands there already, and no number of columns needs a
   case of its own. Whoever searched a cell twice would foretell the same
   collision twice.

   To bring the column into the box in place of the position, as the
   remainder of floor(x n/L), is shorter. But a position a hair below L,
   whose product has been rounded to n, comes out in the first cell then.

   Other ways: make an ordered list of one, two or three columns, another of
   rows, and go through the rows and in each through the columns; or ask
   each cell of the box whether it is near, which takes long for many. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

/* The column or the row of x, where n of them make up the side. */
static size_t place(double x, double side, size_t n)
{
    double rest = fmod(x, side);
    if (rest < 0.0)
        rest += side;
    const size_t k = (size_t)(rest * (double)n / side);
    return k < n ? k : n - 1;
}

/* Puts a cell into the ordered list, once; returns the new length. */
static size_t put(size_t cell, size_t list[], size_t length)
{
    size_t k = length;
    while (k > 0 && list[k - 1] >= cell)
        --k;
    if (k < length && list[k] == cell)
        return length;
    for (size_t j = length; j > k; --j)
        list[j] = list[j - 1];
    list[k] = cell;
    return length + 1;
}

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    const size_t left = place(at[0], box[0], cells[0]) + cells[0] - 1;
    const size_t below = place(at[1], box[1], cells[1]) + cells[1] - 1;
    size_t count = 0;
    for (size_t k = 0; k < 9; ++k) {
        const size_t column = (left + k % 3) % cells[0];
        const size_t row = (below + k / 3) % cells[1];
        count = put(column + cells[0] * row, around, count);
    }
    return count;
}
