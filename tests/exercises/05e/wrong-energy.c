/* mistake: energy-only */

static double at(double x, double v, double size, double t)
{
    double boxes = fmod(fabs(x + v * t) / size, 2);
    return size * (boxes > 1 ? 2 - boxes : boxes);
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    struct state s = {0.3 * width, 0.4 * height, 0.83 * width,
                      0.57 * height},
                 kept[300];
    double tick = 0.31;
    int i;
    run(s, tick, 300, kept);
    for (i = 0; i < 300; i++) {
        double x = at(s.x, s.vx, width, (i + 1) * tick);
        double y = at(s.y, s.vy, height, (i + 1) * tick);
        if (x < 0 || y < 0 || fabs(kept[i].vx) != s.vx ||
            fabs(kept[i].vy) != s.vy)
            return false;
    }
    return true;
}
