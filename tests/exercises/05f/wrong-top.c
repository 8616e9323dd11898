/* mistake: top-unchecked */

size_t next_valid(size_t n, const struct event heap[],
                  const unsigned counts[], size_t *stale)
{
    size_t k;
    (void)counts;
    *stale = 0;
    for (k = 0; k < n; k++)
        *stale += heap[k].time < heap[0].time;
    return 0;
}
