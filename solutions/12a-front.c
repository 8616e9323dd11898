/* Exercise 12a, worked: the Pareto front.

   "Beats" is an order in which two choices need not be comparable: a cheap
   and bad one and a dear and good one both have their use. Better in one of
   the numbers and not worse in the other: the second comparison is one with
   "or equal", so that a tie in one number is decided by the other, and the
   first is one without, so that what is equal in both does not beat itself.

   A comparison with not-a-number is false, and an infinity is no better
   than anything; so what blew up beats nobody that is finite. Nor does
   anybody need to beat it: that it is not on the front has to be asked
   separately, since what is cheap and wrong would stay there.

   Each choice is held against all others, which are n^2 comparisons: for
   the few hundred points of a chart this is nothing. Who stays is put among
   those that are there already, by its cost. No second look at the error is
   needed: along the front it falls where the cost grows. And an equal one
   goes behind those that came before it, since only dearer ones move up.

   Another way: sort all by cost, and by error among equal costs, and walk
   once from the cheapest to the dearest. On the front is who errs less than
   everybody so far. That takes n log n steps, and some care with equals. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct choice {
    double cost;  /* in s */
    double error; /* as a share of the scene's size */
};

static bool beats(const struct choice *a, const struct choice *b)
{
    const bool cheaper = a->cost < b->cost, better = a->error < b->error;
    return (cheaper && a->error <= b->error) ||
           (better && a->cost <= b->cost);
}

/* Whether one of the n choices beats this one. */
static bool beaten(const struct choice *one, size_t n,
                   const struct choice choice[])
{
    while (n > 0 && !beats(&choice[n - 1], one))
        --n;
    return n > 0;
}

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    size_t count = 0;
    for (size_t place, i = 0; i < n; ++i) {
        const double cost = choice[i].cost;
        if (!isfinite(choice[i].error) || beaten(&choice[i], n, choice))
            continue;
        place = count++;
        while (place > 0 && choice[front[place - 1]].cost > cost) {
            front[place] = front[place - 1];
            --place;
        }
        front[place] = i;
    }
    return count;
}
