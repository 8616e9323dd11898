/* Exercise 08b. One more row in the tableau (core, 30 minutes)

   A Runge-Kutta method is a table of numbers. It has s stages; the slope
   of each is taken where the slopes of the earlier ones lead,
       k_i = f(t + c_i h, y + h sum over j of a_ij k_j),
   where c_i is the sum of row i, and the step is their mean,
       y -> y + h sum over i of b_i k_i.
   Who has a program for any table gets a new method for a handful of
   numbers. Write that program, and give it a new method: Kutta's other one
   of order 4, from 1901, which is called the 3/8 rule.

   Its four stages are at the beginning of the step, at a third, at two
   thirds, and at the end. The slope of the second is taken at y + h k_1/3,
   that of the third at y + h (k_2 - k_1/3), that of the fourth at
   y + h (k_1 - k_2 + k_3). The weights are 1/8, 3/8, 3/8 and 1/8, which is
   Newton's rule for integrals.

   three_eighths() fills in this table:
     a        4 rows of 4, one after the other: a_ij, with i and j from 0,
              is a[4 * i + j]. Where there is nothing to add it is 0.
     b        the 4 weights
   tableau_step() makes one step with any table. Given:
     stages   how many, s, from 1 to 8
     a        s rows of s; no stage uses itself or a later one
     b        the s weights
     n        how many numbers y consists of, from 1 to 12
     t        where the step begins
     h        how long it is
     y        the numbers at t
   To fill in:
     y        the numbers at t + h

   slope(), which the check provides, is f: it fills in dy[0] to dy[n - 1]
   and leaves y as it is. It may be asked once for each stage.

   Check your answer with    make check EX=08b
   Hints, which ask before they tell:    make hint EX=08b */

#include "exercise.h"
#include <stddef.h>

enum { MOST_STAGES = 8, MOST = 12 };

void slope(double t, const double y[], double dy[]);

void three_eighths(double a[], double b[])
{
    /* TODO: replace the lines of both functions by your own. Which table
       does the classical method of Runge and Kutta have? */
    for (int i = 0; i < 16; ++i)
        a[i] = NOT_DONE_YET(0.0);
    b[0] = b[1] = b[2] = b[3] = 0.25;
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    (void)stages;
    (void)a;
    (void)b;
    (void)n;
    (void)t;
    y[0] = NOT_DONE_YET(h);
}
