/* A right answer in plain C, with which wrong.diff begins. */

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    double p[2] = {0, 0}, kT = energy / disks;
    double time = until - from;
    size_t i;
    int k;
    for (i = 0; i < n; i++) {
        k = hits[i].wall >= BOTTOM;
        if (hits[i].t > from && hits[i].t <= until)
            p[k] += 2 * hits[i].mass * fabs(hits[i].v);
    }
    for (k = 0; k < 2; k++)
        z[k] = p[k] / time / (2 * size[1 - k]) * size[0] * size[1] /
               (disks * kT);
}
