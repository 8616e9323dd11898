/* Exercise 03b. Is the dimple real? (core, 25 minutes)

   A histogram has a dimple: fewer samples in its middle bin than the law
   expects. How many standard deviations too few? The samples were taken
   from one long run, one after the other, and neighbours are alike; so they
   are worth fewer independent ones.

   Given:
     count         the samples in the bin
     samples       all samples, at least 1; count is not larger
     probability   of a sample in the bin, according to the law
     inefficiency  g: so many samples of the run are worth one independent
                   sample. Where it is below 1, take 1.
   To fill in:
     *z            by how many standard deviations of the count the bin has
                   too many samples; negative when it has too few. The
                   standard deviation is the one that the law expects.
   Returns true when *z means something, and false when it does not: when
   the probability is 0 or 1 (or no probability at all), and when fewer than
   5 INDEPENDENT samples are expected in the bin, or fewer than 5 outside
   it. What stands in *z then does not matter.

   Check your answer with    make check EX=03b
   Hints, which ask before they tell:    make hint EX=03b */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    /* TODO: replace these lines by your own. How far would the share of the
       bin scatter if the samples were independent, and how far does it
       when only some of them count? */
    (void)count;
    (void)samples;
    (void)probability;
    *z = NOT_DONE_YET(inefficiency);
    return true;
}
