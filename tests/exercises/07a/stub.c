/* Exercise 07a. The cells around a position (warm-up, 20 minutes)

   A periodic box is cut into cells, all alike, so that a disk need only ask
   its own cell and the eight around it for partners. What leaves the box on
   one side comes in again on the other, so the last column of cells has the
   first one for its right neighbour, and the last row the first one above.
   Columns are counted from the left, rows from below, both from 0, and the
   number of a cell is its column plus cells[0] times its row. A cell owns
   its left and its lower edge. Which cells must be searched?

   Given:
     box     the sides of the box, in m: from 0 to box[0] and to box[1]
     cells   the number of columns, cells[0], and of rows, cells[1], each at
             least 1
     at      the position, in m, finite. It may be outside of the box, by
             some periods, and means then the place in the box that it is a
             copy of.
   To fill in:
     around  the numbers of the position's own cell and of those that touch
             it, corners too: each of them once, in ascending order
   Returns how many these are. There are fewer than nine where the box has
   fewer than three columns or rows.

   A position a hair below 0 is in the last column, and so is one a hair
   below box[0], however your program rounds; at box[0] itself it is in the
   first. The same goes for rows.

   Check your answer with    make check EX=07a
   Hints, which ask before they tell:    make hint EX=07a */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    /* TODO: replace these lines by your own. In which column and in which
       row is the position? Who are the neighbours of the first column, and
       of the only one? */
    (void)box;
    (void)at;
    around[0] = 0;
    return NOT_DONE_YET(cells[0]);
}
