/* How the function of exercise 05f is called: see tests/remote.awk. */
/* output: next_valid stale 1 */

struct event {
    double time;
    size_t i, j;
    unsigned count_i, count_j;
};

/* How many bodies the events of a heap tell of: nobody says how many there
   are, and no other counter can be asked for. */
static inline size_t bodies_in(size_t n, const struct event heap[])
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

size_t next_valid(size_t n, const struct event heap[n],
                  const unsigned counts[bodies_in(n, heap)], size_t *stale);
