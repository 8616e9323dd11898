/* Exercise 09e. The small ones count (core, 25 minutes)

   The Sun pulls, and a million grains of dust pull. Each grain's pull is
   too small to change the last digit of the Sun's, and all of them together
   are not. Add up so that the small ones count.

   Given:
     n     how many numbers, which may be 0
     part  part[0] to part[n - 1]: of any sizes and signs, in any order
   Returns their sum, 0 if there are none. It may be wrong by two epsilons
   of itself, and by (n epsilon)^2 of the sum of all sizes: as if it had
   been added up with twice the digits and rounded once. An infinity among
   the numbers makes the sum this infinity.

   There is no type with twice the digits that every computer has, and none
   is needed.

   Check your answer with    make check EX=09e
   Hints, which ask before they tell:    make hint EX=09e */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double sum_up(size_t n, const double part[])
{
    /* TODO: replace these lines by your own. When a small number is added
       to a large one, what of it is lost, and can one compute how much? */
    (void)part;
    return NOT_DONE_YET((double)n);
}
