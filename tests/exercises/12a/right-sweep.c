/* All are sorted; then one walks from the cheapest to the dearest. */

#include <stdlib.h>

static int in_order(const void *p, const void *q)
{
    const struct choice *a = *(const struct choice *const *)p;
    const struct choice *b = *(const struct choice *const *)q;
    int by_cost = (a->cost > b->cost) - (b->cost > a->cost);
    int by_error = (a->error > b->error) - (b->error > a->error);
    return by_cost ? by_cost : by_error ? by_error : a < b ? -1 : 1;
}

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    const struct choice **sorted = malloc((n + 1) * sizeof *sorted), *last;
    size_t use = 0, count = 0;
    if (!sorted)
        abort();
    for (size_t i = n; i-- > 0;)
        if (isfinite(choice[i].error))
            sorted[use++] = choice + i;
    qsort(sorted, use, sizeof *sorted, in_order);
    last = NULL;
    for (size_t i = 0; i < use; ++i) {
        if (last && sorted[i]->error >= last->error &&
            (sorted[i]->error > last->error ||
             sorted[i]->cost > last->cost))
            continue;
        last = sorted[i];
        front[count++] = (size_t)(last - choice);
    }
    free(sorted);
    return count;
}
