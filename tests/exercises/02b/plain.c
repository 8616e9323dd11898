/* A right answer in plain C, with which wrong.diff begins. */

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    size_t e = 0, k;
    for (k = 0; k < samples; k++) {
        double now = (k + 1) * tick;
        while (e + 1 < events && path[e + 1].t <= now)
            e++;
        x[k] = path[e].x + path[e].v * (now - path[e].t);
    }
}
