/* What crosses the border of exercise 05f: see examiner/border.h. */
/* place: next_valid stale 1 */

#include "examiner/border.h"
#include <stdlib.h>

struct event {
    double time;
    size_t i, j;
    unsigned count_i, count_j;
};

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale);

static void move_heap(size_t n, struct event heap[])
{
    for (size_t k = 0; k < n; ++k) {
        border_doubles(&heap[k].time, 1);
        border_sizes(&heap[k].i, 1);
        border_sizes(&heap[k].j, 1);
        border_unsigneds(&heap[k].count_i, 1);
        border_unsigneds(&heap[k].count_j, 1);
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n, bodies, next;
    border_sizes(&n, 1);
    struct event *heap = border_array(n, sizeof heap[0]);
    move_heap(n, heap);
    border_sizes(&bodies, 1);
    unsigned *counts = border_array(bodies, sizeof counts[0]);
    border_unsigneds(counts, bodies);
    size_t *stale = border_place_sizes("stale", 1);
    next = next_valid(n, heap, counts, stale);
    free(heap);
    free(counts);
    border_reply();
    border_sizes(&next, 1);
    border_sizes(stale, 1);
}

#else

/* How many bodies the events of a heap tell of: nobody says how many there
   are, and no other counter can be asked for. */
static size_t bodies_in(size_t n, const struct event heap[])
{
    size_t bodies = 0;
    for (size_t k = 0; k < n; ++k) {
        if (heap[k].i >= bodies)
            bodies = heap[k].i + 1;
        if (heap[k].j >= bodies)
            bodies = heap[k].j + 1;
    }
    return bodies;
}

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    size_t bodies = bodies_in(n, heap), next;
    border_call();
    border_sizes(&n, 1);
    move_heap(n, (struct event *)heap);
    border_sizes(&bodies, 1);
    border_unsigneds((unsigned *)counts, bodies);
    border_sizes(stale, 1);
    border_wait();
    border_sizes(&next, 1);
    border_sizes(stale, 1);
    return next;
}

#endif
