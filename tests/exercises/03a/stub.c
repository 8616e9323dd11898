/* Exercise 03a. Bins of equal probability (warm-up, 15 minutes)

   A histogram with bins of equal width has crowded bins in the middle and
   nearly empty ones at the ends, where a test of a law then fails for want
   of counts. Choose the edges so that the law expects the same number in
   each bin.

   Given:
     distribution  the law's distribution function: distribution(x) is the
                   probability of a value below x. It is continuous and
                   nowhere falls; it may be flat, and it may be steep.
     low, high     where it is exactly 0 and exactly 1; low < high. Do not
                   ask it outside.
     bins          how many bins, at least 1
   To fill in:
     edge[0] to edge[bins], rising: edge[0] is low and edge[bins] is high,
     to the last bit, and each bin between two edges has the probability
     1/bins, as nearly as numbers of the type double can tell. (Where the
     law is flat any place of the flat piece will do for an inner edge.)

   Check your answer with    make check EX=03a
   Hints, which ask before they tell:    make hint EX=03a */

#include "exercise.h"
#include <stddef.h>

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    /* TODO: replace these lines by your own. Between which two places must
       an edge lie, and how does one question to the distribution function
       halve that piece? */
    (void)distribution;
    (void)high;
    (void)bins;
    edge[0] = NOT_DONE_YET(low);
}
