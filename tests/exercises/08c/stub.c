/* Exercise 08c. Measure an order (core, 25 minutes)

   The error of a method of order p goes as h^p with the step h: once h is
   small enough, and for as long as the rounding errors are smaller still.
   Somebody has made runs with several steps. Which order do they show, and
   do they show one at all?

   Given:
     n         how many runs there are; there may be none
     h         their steps, in s, from the largest to the smallest
     error     what each run had at its end, less what it should have had,
               in m, of either sign; an infinity or not a number where the
               run blew up
     rounding  how large rounding errors may be in these differences, in m
   A run is of use when its error is finite, and more than 1000 times as
   large as `rounding`, whatever its sign. The others are passed over,
   wherever they stand.
   To fill in:
     order     p, from the two runs of use with the SMALLEST steps: error =
               C h^p goes through both. NAN when there are no two.
   Returns
     TOO_FEW   when there are no two runs of use
     NOT_YET   when p is less than 0.5: the error does not get smaller, or
               hardly. Or when there are three runs of use, and the second
               and the third smallest step of them give a p that is more
               than 0.2 away: the steps are not small enough yet.
     MEASURED  in all other cases

   Check your answer with    make check EX=08c
   Hints, which ask before they tell:    make hint EX=08c */

#include "exercise.h"
#include <stddef.h>

enum verdict { TOO_FEW, NOT_YET, MEASURED };

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    /* TODO: replace these lines by your own. Which quotient of two
       logarithms is p? */
    (void)n;
    (void)h;
    (void)error;
    *order = NOT_DONE_YET(rounding);
    return MEASURED;
}
