/* A right answer: each wall by itself, and the mean of two that face each
   other. */

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    double p[4] = {0}, kT = energy / disks, volume = size[0] * size[1];
    size_t i;
    for (i = 0; i < n && hits[i].t <= until; i++) {
        double v = hits[i].v < 0 ? -hits[i].v : hits[i].v, length;
        if (hits[i].t <= from)
            continue;
        switch (hits[i].wall) {
        case LEFT:
        case RIGHT: length = size[1]; break;
        default: length = size[0];
        }
        p[hits[i].wall] += 2 * hits[i].mass * v / length / (until - from);
    }
    z[0] = (p[LEFT] + p[RIGHT]) / 2 * volume / (disks * kT);
    z[1] = (p[BOTTOM] + p[TOP]) / 2 * volume / (disks * kT);
}
