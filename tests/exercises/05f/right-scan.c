/* A right answer: a look at every event, and another one. */

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    size_t best = n, k;
    for (k = n; k > 0; k--) {
        const struct event *e = heap + k - 1;
        if (e->count_i != counts[e->i] || e->count_j != counts[e->j])
            continue;
        if (best == n || e->time <= heap[best].time)
            best = k - 1;
    }
    *stale = 0;
    for (k = 0; k < n; k++)
        *stale += best == n || heap[k].time < heap[best].time;
    return best;
}
