/* Exercise 12a. The Pareto front (warm-up, 20 minutes)

   A scene was computed in many ways: each has a cost and an error. Most of
   them nobody should take, whatever the tolerance is. Which are left?

   One choice beats another when it costs no more and errs no more, and is
   better in at least one of the two. Those that nobody beats are the front.

   Given:
     n        how many choices there are; there may be none
     choice   their costs and errors, in no order at all. A cost is finite
              and not negative. An error is not negative, but for runs that
              blew up: theirs is an infinity, or not a number. These are
              never on the front, and beat nobody.
   To fill in:
     front    which of them are on the front, as indices into choice, from
              the cheapest to the dearest. There is room for n. Choices that
              are equal in both numbers do not beat each other; of these the
              smaller index comes first.
   Returns how many are on the front.

   Check your answer with    make check EX=12a
   Hints, which ask before they tell:    make hint EX=12a */

#include "exercise.h"
#include <stddef.h>

struct choice {
    double cost;  /* in s */
    double error; /* as a share of the scene's size */
};

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    /* TODO: replace these lines by your own. Begin with the question
       whether one choice beats another. */
    (void)n;
    (void)choice;
    front[0] = NOT_DONE_YET(0);
    return 0;
}
