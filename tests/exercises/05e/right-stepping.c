/* A right answer: the way of a tick, and what is beyond a wall comes back.
 */

static void on(double *x, double *v, double size, double t)
{
    *x += *v * t;
    while (*x < 0 || *x > size) {
        *x = *x < 0 ? -*x : 2 * size - *x;
        *v = -*v;
    }
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    struct state s = {0.4 * width, 0.1 * height, 7.77 * width,
                      3.21 * height};
    struct state kept[200];
    int i;
    run(s, 0.0917, 200, kept);
    for (i = 0; i < 200; i++) {
        on(&s.x, &s.vx, width, 0.0917);
        on(&s.y, &s.vy, height, 0.0917);
        if (!(fabs(s.x - kept[i].x) / width < 1e-7 &&
              fabs(s.y - kept[i].y) / height < 1e-7))
            return false;
    }
    run(s, 0.2713, 200, kept);
    for (i = 0; i < 200; i++) {
        on(&s.x, &s.vx, width, 0.2713);
        on(&s.y, &s.vy, height, 0.2713);
        if (!(fabs(s.x - kept[i].x) / width < 1e-7 &&
              fabs(s.y - kept[i].y) / height < 1e-7))
            return false;
    }
    return true;
}
