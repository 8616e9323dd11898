/* A right answer: a zigzag is the arccosine of a cosine. */

static bool there(double x, double from, double v, double size, double t)
{
    double pi = acos(-1), at = acos(cos(pi * (from + v * t) / size));
    return fabs(x - at * size / pi) < 1e-6 * size;
}

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    struct state s = {width / 3, height / 5, 0, 0}, kept[300];
    int i, j;
    for (j = 1; j <= 3; j++) {
        s.vx = -0.37 * j * j * width;
        s.vy = 0.29 * j * j * height;
        run(s, 0.57, 300, kept);
        for (i = 0; i < 300; i++)
            if (!there(kept[i].x, s.x, s.vx, width, 0.57 * (i + 1)) ||
                !there(kept[i].y, s.y, s.vy, height, 0.57 * (i + 1)))
                return false;
    }
    return true;
}
