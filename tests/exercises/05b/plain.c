/* A right answer in plain C, with which wrong.diff begins. */

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    double x = b->x - a->x, y = b->y - a->y;
    double vx = b->vx - a->vx, vy = b->vy - a->vy;
    double s = a->radius + b->radius;
    double v2 = vx * vx + vy * vy;
    double p = x * vx + y * vy;
    double c = x * x + y * y - s * s;
    double disc = p * p - v2 * c, t;
    if (p >= 0 || disc < 0)
        return INFINITY;
    t = fmax(0, c) / (sqrt(disc) - p);
    *height =
        a->y + a->vy * t + (y + vy * t) * a->radius / s - g * t * t / 2;
    return t;
}
