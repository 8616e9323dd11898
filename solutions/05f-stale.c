/* Exercise 05f, worked: what is still true in a heap.

   Every event is the top of a smaller heap, made of itself, its children,
   their children and so on, and none of these is earlier. So an event that
   is not stale speaks for its whole heap: we need not look below it. One
   that is stale says nothing about its two children, and both must be
   asked; the earlier answer counts. That is a function that calls itself,
   down to the places where the array ends.

   A stale event on the left may well hide an event that comes before
   everything on the right. Following only the earlier child is therefore
   wrong, and so is stopping at the first good event met.

   Counting is easier than it looks: whatever is earlier than the earliest
   good event is stale, or it would be the earliest itself. So nobody needs
   to be asked for the counters again; and an event that is not earlier has
   nothing earlier below it. The times alone decide where to stop.

   Counters are compared for being equal, not for being larger. A counter
   that is full goes on from 0 and is then smaller than it was.

   Another way: look at the whole array once for the earliest good event and
   once for those before it. That costs n steps, each as cheap as a step can
   be; in a heap of a few dozen events nothing is faster. Or throw away the
   stale tops of a copy, one after the other. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct event {
    double time;               /* in s */
    size_t i, j;               /* the two bodies that would collide */
    unsigned count_i, count_j; /* their counters when it was foretold */
};

static bool is_valid(const struct event *e, const unsigned counts[])
{
    return counts[e->i] == e->count_i && counts[e->j] == e->count_j;
}

/* The earliest valid event in the heap below and with number k, or n. */
static size_t earliest(size_t n, const struct event heap[],
                       const unsigned counts[], size_t k)
{
    if (k >= n)
        return n;
    if (is_valid(&heap[k], counts))
        return k;
    const size_t one = earliest(n, heap, counts, 2 * k + 1);
    const size_t other = earliest(n, heap, counts, 2 * k + 2);
    if (one == n || other == n)
        return one < other ? one : other;
    return heap[one].time < heap[other].time ? one : other;
}

/* How many events there are before number next, at number k and below. */
static size_t before(size_t n, const struct event heap[], size_t next,
                     size_t k)
{
    if (k >= n || (next < n && heap[k].time >= heap[next].time))
        return 0;
    return 1 + before(n, heap, next, 2 * k + 1) +
           before(n, heap, next, 2 * k + 2);
}

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    const size_t next = earliest(n, heap, counts, 0);
    *stale = before(n, heap, next, 0);
    return next;
}
