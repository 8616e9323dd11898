/* A right answer: the event after each tick by bisection, and the straight
   line between the events on both sides. */

static double between(struct event a, struct event b, double t)
{
    double part = (t - a.t) / (b.t - a.t);
    return (1 - part) * a.x + part * b.x;
}

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    size_t k;
    for (k = 1; k <= samples; k++) {
        double t = k * tick;
        size_t low = 0, high = events;
        while (high - low > 1) {
            size_t middle = (low + high) / 2;
            if (path[middle].t > t)
                high = middle;
            else
                low = middle;
        }
        if (high == events)
            x[k - 1] = path[low].x + path[low].v * (t - path[low].t);
        else
            x[k - 1] = between(path[low], path[high], t);
    }
}
