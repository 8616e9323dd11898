/* A right answer: one event after the other in the order of time. The next
   one is the earliest whose parent has been seen. */

static size_t following(size_t n, const struct event heap[], double now)
{
    size_t k = 0, best = n;
    while (k < n) {
        double t = heap[k].time;
        double parent = k ? heap[(k - 1) / 2].time : now;
        if (t > now && parent <= now && (best == n || t < heap[best].time))
            best = k;
        k++;
    }
    return best;
}

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    double now = -INFINITY;
    for (*stale = 0; *stale < n; ++*stale) {
        size_t k = following(n, heap, now);
        const struct event e = heap[k];
        if (counts[e.i] - e.count_i == 0 && counts[e.j] - e.count_j == 0)
            return k;
        now = e.time;
    }
    return n;
}
