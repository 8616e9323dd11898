/* The remote calls of exercise 05f: see examiner/remote.h. */
/* output: next_valid stale 1 */

#include "examiner/remote.h"
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
        remote_doubles(&heap[k].time, 1);
        remote_sizes(&heap[k].i, 1);
        remote_sizes(&heap[k].j, 1);
        remote_unsigneds(&heap[k].count_i, 1);
        remote_unsigneds(&heap[k].count_j, 1);
    }
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n, bodies, next;
    remote_sizes(&n, 1);
    struct event *heap = remote_array(n, sizeof heap[0]);
    move_heap(n, heap);
    remote_sizes(&bodies, 1);
    unsigned *counts = remote_array(bodies, sizeof counts[0]);
    remote_unsigneds(counts, bodies);
    size_t *stale = remote_output_sizes("stale", 1);
    next = next_valid(n, heap, counts, stale);
    free(heap);
    free(counts);
    remote_reply();
    remote_sizes(&next, 1);
    remote_sizes(stale, 1);
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
    remote_call();
    remote_sizes(&n, 1);
    move_heap(n, (struct event *)heap);
    remote_sizes(&bodies, 1);
    remote_unsigneds((unsigned *)counts, bodies);
    remote_sizes(stale, 1);
    remote_wait();
    remote_sizes(&next, 1);
    remote_sizes(stale, 1);
    return next;
}

#endif
