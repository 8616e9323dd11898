/* Exercise 05f. What is still true in a heap (core, 25 minutes)

   A program foretells collisions and keeps them in a heap: an array in
   which no event comes before its parent, and the parent of number k is
   number (k - 1) / 2, rounded down. Each body has a counter of the
   collisions it has had. An event holds the counters that its two bodies
   had when it was foretold; when either has collided since, the event is
   stale: it will not take place. Nobody has removed it. Which event takes
   place next, and how many stale ones stand before it?

   Given:
     n        the number of events in the heap, which may be 0
     heap     the events, in s; no two have the same time
     counts   counts[b] is how many collisions body b has had. A counter
              that is full goes on from 0.
   To fill in:
     *stale   the number of events that are earlier than the one returned:
              those that a program would have to throw away first. It is n
              when n is returned.
   Returns the number of the earliest event that is not stale: its place in
   the array, from 0 to n - 1; and n when there is none.

   You may look at every event. Can you find it without?

   Check your answer with    make check EX=05f
   Hints, which ask before they tell:    make hint EX=05f */

#include "exercise.h"
#include <stddef.h>

struct event {
    double time;               /* in s */
    size_t i, j;               /* the two bodies that would collide */
    unsigned count_i, count_j; /* their counters when it was foretold */
};

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    /* TODO: replace these lines by your own. When is an event stale? If the
       top one is, where in the heap can the next one stand? */
    (void)heap;
    (void)counts;
    *stale = 0;
    return NOT_DONE_YET(n);
}
