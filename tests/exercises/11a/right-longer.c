/* A right answer: the line is made longer, about a point that stays. */

#include <stdbool.h>

static bool fixed(const struct sphere *s)
{
    return s->mass > 1e308;
}

double part_spheres(struct sphere *a, struct sphere *b)
{
    double reach = a->radius + b->radius, u, v, w, now, more, pa, pb;
    u = b->x[0] - a->x[0];
    v = b->x[1] - a->x[1];
    w = b->x[2] - a->x[2];
    now = sqrt(u * u + v * v + w * w);
    if (now >= reach)
        return 0;
    pa = fixed(a) ? 0 : fixed(b) ? 1 : 1 / (1 + a->mass / b->mass);
    pb = fixed(b) ? 0 : fixed(a) ? 1 : 1 / (1 + b->mass / a->mass);
    if (now == 0) {
        if (!fixed(a))
            a->x[0] -= reach * pa;
        if (!fixed(b))
            b->x[0] += reach * pb;
        return reach;
    }
    more = reach / now - 1;
    if (!fixed(a)) {
        a->x[0] -= pa * more * u;
        a->x[1] -= pa * more * v;
        a->x[2] -= pa * more * w;
    }
    if (!fixed(b)) {
        b->x[0] += pb * more * u;
        b->x[1] += pb * more * v;
        b->x[2] += pb * more * w;
    }
    return reach - now;
}
