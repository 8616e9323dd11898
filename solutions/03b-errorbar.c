/* Exercise 03b, worked: an error bar that keeps its word.

   Nothing need be known of the memory but that it is shorter than a block.
   Cut the series into BLOCKS pieces, each far longer than the memory. Their
   means are nearly independent, whatever happens within them: a memory
   makes them scatter more, values that alternate make them scatter less.
   So the ordinary formula is right for the means of blocks: their variance,
   divided by their number, is the square of the error of the mean.

   How many blocks? Two mistakes stand against each other. Blocks of length
   B miss the part g/(2B) of the square, for values on either side of a cut
   do know each other. And m blocks know their own variance only to a part
   sqrt(2/m): an error that is now too large and now too small keeps its
   word less often than one that is always right, since the truth is more
   often at twice the error than the bell curve knows (Student's law). With
   m = 32 there are at least three times n/100 places in a block. A tenth of
   that memory counts, so 0.02 of an error is missing, and it is known to
   0.13.

   What fills no block belongs to the mean all the same.

   Other ways: the correlations, summed up to n/100 places, with weights
   that fall to zero; blocks that overlap; or blocks of all lengths, from
   which the program of this chapter chooses. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum { BLOCKS = 32 };

double mean_and_error(size_t n, const double x[], double *error)
{
    const size_t length = n / BLOCKS;
    double rest = 0.0;
    double block[BLOCKS] = {0};
    for (size_t i = n; i-- > 0;)
        if (i / length < BLOCKS)
            block[i / length] += x[i] - x[0];
        else
            rest += x[i] - x[0];
    double middle = 0.0;
    for (int b = 0; b < BLOCKS; ++b)
        middle = middle + block[b] / BLOCKS;
    double squares = 0.0;
    for (int b = 0; b < BLOCKS; ++b)
        squares += pow((block[b] - middle) / (double)length, 2.0);
    *error = sqrt(squares / (BLOCKS * (BLOCKS - 1.0)));
    return x[0] + (middle * BLOCKS + rest) / (double)n;
}
