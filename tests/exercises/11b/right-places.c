/* A right answer: places, which are moved from one collision to the next,
   and the momentum that is exchanged. */

size_t cradle(size_t n, const double mass[], double v[])
{
    double x[128], top = 0;
    size_t i, hits = 0;
    for (i = 0; i < n; i++) {
        x[i] = 4.0 * i;
        if (fabs(v[i]) > top)
            top = fabs(v[i]);
    }
    while (1) {
        double t, soonest = -1, p;
        size_t who = 0;
        for (i = 0; i + 1 < n; i++) {
            if (v[i] - v[i + 1] <= 1e-9 * top)
                continue;
            t = (x[i + 1] - x[i]) / (v[i] - v[i + 1]);
            if (soonest < 0 || t < soonest) {
                soonest = t > 0 ? t : 0;
                who = i;
            }
        }
        if (soonest < 0)
            break;
        for (i = 0; i < n; i++)
            x[i] += v[i] * soonest;
        x[who + 1] = x[who];
        p = 2 * (v[who] - v[who + 1]) / (1 / mass[who] + 1 / mass[who + 1]);
        v[who] -= p / mass[who];
        v[who + 1] += p / mass[who + 1];
        hits++;
    }
    return hits;
}
