/* What crosses the border of exercise 07a: see examiner/border.h. */
/* place: cells_around around 9 */

#include "examiner/border.h"

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9]);

enum { MOST = 9 };

#ifdef BORDER_INSIDE

void border_answer(void)
{
    double box[2], at[2];
    size_t cells[2], count;
    border_doubles(box, 2);
    border_sizes(cells, 2);
    border_doubles(at, 2);
    size_t *around = border_place_sizes("around", MOST);
    count = cells_around(box, cells, at, around);
    border_reply();
    border_sizes(&count, 1);
    border_sizes(around, MOST);
}

#else

size_t cells_around(const double box[2], const size_t cells[2],
                    const double at[2], size_t around[9])
{
    double box_copy[2] = {box[0], box[1]}, at_copy[2] = {at[0], at[1]};
    size_t cells_copy[2] = {cells[0], cells[1]}, count;
    border_call();
    border_doubles(box_copy, 2);
    border_sizes(cells_copy, 2);
    border_doubles(at_copy, 2);
    border_sizes(around, MOST);
    border_wait();
    border_sizes(&count, 1);
    border_sizes(around, MOST);
    return count;
}

#endif
