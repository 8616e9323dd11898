/* mistake: passed-on-the-way */

#include "exercise.h"
#include <stddef.h>

struct event {
    double time;
    size_t i, j;
    unsigned count_i, count_j;
};

static size_t search(size_t n, const struct event heap[],
                     const unsigned counts[], size_t k, size_t *stale)
{
    size_t a, b;
    if (k >= n)
        return n;
    if (counts[heap[k].i] == heap[k].count_i &&
        counts[heap[k].j] == heap[k].count_j)
        return k;
    ++*stale;
    a = search(n, heap, counts, 2 * k + 1, stale);
    b = search(n, heap, counts, 2 * k + 2, stale);
    if (a == n || (b < n && heap[b].time < heap[a].time))
        return b;
    return a;
}

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    *stale = 0;
    return search(n, heap, counts, 0, stale);
}
