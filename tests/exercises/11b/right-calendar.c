/* A right answer: the time of the next collision of each pair is kept, and
   found anew only beside the pair that collided; a ball knows where it was
   at its last collision. */

struct ball {
    double m, v, x, t;
};

struct row {
    struct ball ball[100];
    double meets[100];
    double slow;
    size_t n;
};

static void foretell(struct row *r, size_t left, double now)
{
    struct ball *a = r->ball + left, *b = &a[1];
    double shrinks = a->v - b->v, gap;
    gap = (b->x + b->v * (now - b->t)) - (a->x + a->v * (now - a->t));
    r->meets[left] =
        shrinks > r->slow ? now + fmax(gap, 0) / shrinks : INFINITY;
}

static void bounce(struct ball *a, struct ball *b, double now)
{
    double u = (b->v - a->v) / (a->m + b->m), place;
    place = a->x + a->v * (now - a->t);
    a->x = b->x = place;
    a->t = b->t = now;
    a->v += 2 * b->m * u;
    b->v -= 2 * a->m * u;
}

size_t cradle(size_t n, const double mass[], double v[])
{
    struct row r = {.n = n};
    size_t i, k, count = 0;
    for (i = 0; i < n; i++) {
        r.ball[i] = (struct ball){mass[i], v[i], i, 0};
        r.slow = fmax(r.slow, 1e-9 * fabs(v[i]));
    }
    for (i = 0; i + 1 < n; i++)
        foretell(&r, i, 0);
    while (n > 1) {
        double now;
        for (i = k = 0; i + 1 < n; i++)
            if (r.meets[i] < r.meets[k])
                k = i;
        now = r.meets[k];
        if (isinf(now))
            break;
        bounce(&r.ball[k], &r.ball[k + 1], now);
        for (i = k ? k - 1 : 0; i <= k + 1 && i + 1 < n; i++)
            foretell(&r, i, now);
        count++;
    }
    for (i = 0; i < n; i++)
        v[i] = r.ball[i].v;
    return count;
}
