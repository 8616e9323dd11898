/* Exercise 03b, worked: is the dimple real?

   Each independent sample falls into the bin with the probability p, or it
   does not. The share of the bin among n such samples has the variance
   p (1 - p) / n. Ours are not independent: n_eff = n / g of them are. So
   the share scatters with the variance p (1 - p) g / n, while what we
   observed is count / n with ALL the samples: dependent samples have the
   right mean, and only their scatter is larger.

   The law's own p stands in the variance. The question is whether the law
   could have made this count, so the scatter is the one the law expects,
   and an empty bin does not get an error of zero.

   Why is a g below 1 taken as 1? It says that neighbours are less alike
   than strangers: the walls turn each velocity round, and a mean velocity
   gains by it. A bin does not ask for the sign: fast stays fast when it is
   turned round. With the g of the velocity we would claim more independent
   samples than there are, and see dimples that are none.

   And why five? The normal law is a poor picture of a count of one or two;
   a z of -2 would not be as rare as it sounds.

   Another way: in counts, the expected number is n p and its standard
   deviation sqrt(n p (1 - p) g). It is the same fraction, multiplied above
   and below by n. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    const double outside = 1.0 - probability;
    const double independent = (double)samples / fmax(inefficiency, 1.0);
    if (!(independent * fmin(probability, outside) >= 5.0))
        return false;
    const double share = (double)count / (double)samples;
    *z = (share - probability) / sqrt(probability * outside / independent);
    return true;
}
