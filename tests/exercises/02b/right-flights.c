/* A right answer: flight by flight, and all the ticks in each. */

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    size_t done = 0, e;
    for (e = 0; e < events && done < samples; e++) {
        while (done < samples &&
               (e == events - 1 || tick * (done + 1.0) < path[e + 1].t)) {
            double t = tick * (done + 1.0) - path[e].t;
            x[done++] = path[e].v * t + path[e].x;
        }
    }
}
