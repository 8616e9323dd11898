/* Down the stairs: the next one is the cheapest of those that err less. */

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    double step = INFINITY;
    size_t m = 0;
    while (1) {
        const struct choice *next = NULL, *c;
        for (c = choice; c < choice + n; c++) {
            if (!(c->error < step))
                continue;
            if (!next || c->cost < next->cost ||
                (c->cost == next->cost && c->error < next->error))
                next = c;
        }
        if (!next)
            return m;
        for (c = choice; c < choice + n; c++)
            if (c->cost == next->cost && c->error == next->error)
                front[m++] = (size_t)(c - choice);
        step = next->error;
    }
}
