/* A right answer in plain C, with which wrong.diff begins. */

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    size_t best = n, k;
    for (k = 0; k < n; k++) {
        struct event e = heap[k];
        if ((e.count_i == counts[e.i] && e.count_j == counts[e.j]) &&
            (best == n || e.time < heap[best].time))
            best = k;
    }
    *stale = 0;
    for (k = 0; k < n; k++)
        if (best == n || heap[k].time < heap[best].time)
            ++*stale;

    return best;
}
