/* mistake: one-path-down */

#include "exercise.h"
#include <stddef.h>

struct event {
    double time;
    size_t i, j;
    unsigned count_i, count_j;
};

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    size_t k = 0;
    *stale = 0;
    while (k < n) {
        if (counts[heap[k].i] == heap[k].count_i &&
            counts[heap[k].j] == heap[k].count_j)
            return k;
        ++*stale;
        k = 2 * k + 1;
        if (k + 1 < n && heap[k + 1].time < heap[k].time)
            k++;
    }
    *stale = n;
    return n;
}
