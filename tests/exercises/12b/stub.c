/* Exercise 12b. A step from two errors (core, 25 minutes)

   Two runs were made by a method of order p, with a larger step and a
   smaller one, and their errors are known. Which step is small enough for a
   tolerance, and no smaller than it must be? And do the two errors look as
   if one could say that at all?

   Given:
     p          the order that the method has
     h          the steps of the two runs, in s; h[0] is the larger one
     error      what each run had at its end, less what it should have had,
                in m, of either sign; an infinity or not a number where the
                run blew up
     rounding   how large rounding errors may be in these, in m; may be 0
     tolerance  how large the error may be, in m; more than 0
   To fill in:
     step       a curve error = C h^p goes through the run with the SMALLER
                step. Where it reaches the tolerance, make 1.2 times as many
                steps, for a margin. But no step is larger than h[0]: nobody
                has seen what happens there. NAN when none is chosen.
   Returns the first of these that is true:
     OUT_OF_REACH  the tolerance is not more than 10 times `rounding`: no
                   step is small enough
     TOO_FINE      at least one of the errors, whatever its sign, is not
                   more than 10 times `rounding`: it shows no order
     NO_ORDER      a run blew up, or the order that the two errors show,
                   with error = C h^q, differs from p by more than 0.3, up
                   or down
     CHOSEN        none of these

   Check your answer with    make check EX=12b
   Hints, which ask before they tell:    make hint EX=12b */

#include "exercise.h"

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    /* TODO: replace these lines by your own. By which factor must the error
       change, and by which the step then? */
    (void)p;
    (void)error;
    (void)rounding;
    (void)tolerance;
    *step = NOT_DONE_YET(h[0]);
    return CHOSEN;
}
