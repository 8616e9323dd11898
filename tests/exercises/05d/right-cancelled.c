/* A right answer: all that cancels is left out. */

static double sum(size_t n, const struct wall_hit *hit, double from,
                  double until, enum wall one, enum wall other)
{
    double s = 0;
    while (n--) {
        if (hit->t > from && hit->t <= until &&
            (hit->wall == one || hit->wall == other))
            s += fabs(hit->mass * hit->v);
        hit++;
    }
    return s;
}

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    double scale = energy * (until - from);
    (void)disks;
    z[0] = size[0] * sum(n, hits, from, until, LEFT, RIGHT) / scale;
    z[1] = size[1] * sum(n, hits, from, until, BOTTOM, TOP) / scale;
}
