/* A right answer: how far along the line of relative motion, and how far
   beside it. */

static double drop(double g, double y, double v, double t)
{
    return y + v * t - g * t * t / 2;
}

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    double s = a->radius + b->radius, t = INFINITY;
    double x = a->x - b->x, y = a->y - b->y;
    double u = b->vx - a->vx, w = b->vy - a->vy, speed = hypot(u, w);
    double along, beside, half;
    if (speed == 0)
        return t;
    along = (x * u + y * w) / speed;
    beside = fabs(x * w - y * u) / speed;
    if (along > 0 && beside <= s) {
        half = sqrt((s - beside) * (s + beside));
        t = (x * x + y * y - s * s) / (along + half) / speed;
        if (t < 0)
            t = 0;
        *height = (b->radius * drop(g, a->y, a->vy, t) +
                   a->radius * drop(g, b->y, b->vy, t)) /
                  s;
    }
    return t;
}
