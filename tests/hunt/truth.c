/* The path of a scene in the widest numbers at hand, by extrapolation of
   midpoint steps (Gragg, Bulirsch and Stoer), contacts located; how far a
   table of bonk is from it, and how far it is from itself: with other steps
   and a wider tolerance. Shares the reader of scenes with the kit, and no
   force, contact or step.
   truth SCENE UNTIL ROWS TABLE SCALE
   With HUNT_FAST in long double, which is ten times as quick. */
#include "scenes/scene.h"
#include "toolbox/quad.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef HUNT_FAST
typedef long double real;
enum { DIGITS = LDBL_MANT_DIG };
#else
typedef quad real;
enum { DIGITS = QUAD_DIGITS };
#endif
#define EPS (DIGITS > 64 ? 1e-32 : 1e-19)

enum { MOST = 40, COLUMNS = 11, SAMPLES = 24 };
enum { CONTACTS = 20000 }; /* more: it gives up */
/* More of pairs, springs and gaps that were looked at: it gives up. That is
   some six seconds of a processor of 2026, and the same work on every
   machine. */
static const double WORK = DIGITS > 64 ? 1.2e7 : 1.3e8;

static struct scene s;
static size_t n, size;       /* bodies; 6 n */
static double length, speed; /* what is thought of as 1 */
static double far;           /* the largest coordinate */
static double tolerance;     /* of a step */
static double pace;          /* 1; below: it takes shorter steps */
static long contacts;
static double work;
static signed char held[3 * MOST]; /* -1, 1: by the wall below, above */
static const char *stuck;          /* why it gives up */

static real root(real x)
{
    if (!(x > 0))
        return 0;
    real r = sqrt((double)x);
    if (!(r > 0))
        return 0;
    r = (r + x / r) / 2;
    return (r + x / r) / 2;
}

static double size_of(real x)
{
    return fabs((double)x);
}

static void pull_bodies(const real y[], real a[])
{
    const real soft = (real)s.softening * s.softening;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            real d[3], r2 = soft;
            if (s.mass[i] == 0 && s.mass[j] == 0)
                continue;
            for (size_t k = 0; k < 3; ++k) {
                d[k] = y[k * n + j] - y[k * n + i];
                r2 += d[k] * d[k];
            }
            const real w = s.k2 / (r2 * root(r2));
            for (size_t k = 0; k < 3; ++k) {
                a[k * n + i] += w * s.mass[j] * d[k];
                a[k * n + j] -= w * s.mass[i] * d[k];
            }
        }
}

static void pull_springs(const real y[], real a[])
{
    const real *v = y + 3 * n;
    for (size_t j = 0; j < s.springs; ++j) {
        const struct scene_spring *p = &s.spring[j];
        const struct scene_kind *kind = &s.kind[p->kind];
        real d[3], u[3], r2 = DBL_MIN, ru = 0;
        for (size_t k = 0; k < 3; ++k) {
            d[k] = y[k * n + p->b] - y[k * n + p->a];
            u[k] = v[k * n + p->b] - v[k * n + p->a];
            r2 += d[k] * d[k];
            ru += d[k] * u[k];
        }
        const real r = root(r2);
        real q = kind->stiffness * (r - p->rest) / r;
        if (s.axial)
            q += kind->damping * ru / r2;
        for (size_t k = 0; k < 3; ++k) {
            const real f = q * d[k] + (s.axial ? 0 : kind->damping * u[k]);
            if (s.freedom[k * n + p->a])
                a[k * n + p->a] += f / s.mass[p->a];
            if (s.freedom[k * n + p->b])
                a[k * n + p->b] -= f / s.mass[p->b];
        }
    }
}

static void accelerate(const real y[], real a[])
{
    for (size_t c = 0; c < 3 * n; ++c)
        a[c] = s.gravity[c / n];
    if (s.k2 > 0)
        pull_bodies(y, a);
    if (s.springs > 0)
        pull_springs(y, a);
    for (size_t c = 0; s.damping > 0 && c < 3 * n; ++c)
        a[c] -= (real)s.damping / s.mass[c % n] * y[3 * n + c];
    for (size_t c = 0; c < 3 * n; ++c)
        if (!s.freedom[c] || held[c] * a[c] > 0)
            a[c] = 0;
}

static void rates(const real y[], real f[])
{
    work += (double)(n + s.springs + (s.k2 > 0 ? n * (n - 1) / 2 : 0));
    memcpy(f, y + 3 * n, 3 * n * sizeof *f);
    accelerate(y, f + 3 * n);
}

static double scaled(const real a[], const real b[])
{
    double x = 0, v = 0;
    for (size_t c = 0; c < 3 * n; ++c) {
        x = fmax(x, size_of(a[c] - b[c]));
        v = fmax(v, size_of(a[3 * n + c] - b[3 * n + c]));
        if (a[c] != a[c])
            return INFINITY;
    }
    return fmax(x / length, v / speed);
}

/* So many modified midpoint steps. */
static void midpoint(const real y[], const real f[], real h, int count,
                     real out[])
{
    real a[6 * MOST], b[6 * MOST], g[6 * MOST];
    const real d = h / count;
    for (size_t c = 0; c < size; ++c) {
        a[c] = y[c];
        b[c] = y[c] + d * f[c];
    }
    for (int j = 1; j <= count; ++j) {
        rates(b, g);
        if (j == count) {
            for (size_t c = 0; c < size; ++c)
                out[c] = (a[c] + b[c] + d * g[c]) / 2;
            return;
        }
        for (size_t c = 0; c < size; ++c) {
            const real next = a[c] + 2 * d * g[c];
            a[c] = b[c];
            b[c] = next;
        }
    }
}

/* Column k of the table, out of the ones before and the last steps. */
static void put_column(real t[COLUMNS][6 * MOST], int k, real here[])
{
    for (int j = 0; j < k; ++j) {
        const real r = (real)(k + 1) / (k - j), w = 1 / (r * r - 1);
        for (size_t c = 0; c < size; ++c) {
            const real up = t[j][c];
            t[j][c] = here[c];
            here[c] += (here[c] - up) * w;
        }
    }
    memcpy(t[k], here, size * sizeof *here);
}

/* One step; returns the column at which it settled, or 0. */
static int extrapolate(const real y[], real h, real out[])
{
    static real t[COLUMNS][6 * MOST];
    real f[6 * MOST], here[6 * MOST], last[6 * MOST];
    double before = INFINITY;
    rates(y, f);
    for (size_t c = 3 * n; c < size; ++c)
        speed = fmax(speed, size_of(y[c]));
    for (int k = 0; k < COLUMNS; ++k) {
        if (k > 0)
            memcpy(last, t[k - 1], size * sizeof *last);
        midpoint(y, f, h, 2 * (k + 1), here);
        put_column(t, k, here);
        if (k == 0)
            continue;
        const double error = scaled(here, last);
        if (error <= tolerance && k >= 2) {
            memcpy(out, here, size * sizeof *out);
            return k + 1;
        }
        if (!(error < 1e3 * before) || (k > 4 && error > 1e-3))
            return 0;
        before = error;
    }
    return 0;
}

static bool act(size_t i, size_t j)
{
    if (s.k2 > 0 && (s.mass[i] > 0 || s.mass[j] > 0))
        return true;
    for (size_t q = 0; q < s.springs; ++q)
        if ((s.spring[q].a == i && s.spring[q].b == j) ||
            (s.spring[q].a == j && s.spring[q].b == i))
            return true;
    return false;
}

/* Of two that act on each other none may leap past the other. */
static double longest_of(const real y[], const real a[], size_t i, size_t j)
{
    double r2 = 0, v2 = 0, a2 = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double d = (double)(y[k * n + i] - y[k * n + j]);
        const double u = (double)(y[(3 + k) * n + i] - y[(3 + k) * n + j]);
        const double b = (double)(a[k * n + i] - a[k * n + j]);
        r2 += d * d;
        v2 += u * u;
        a2 += b * b;
    }
    const double r = sqrt(r2) + s.softening + 1e-12 * length;
    return fmin(0.3 * r / sqrt(v2), 0.5 * sqrt(r / sqrt(a2)));
}

static double longest(const real y[], const real a[])
{
    double least = INFINITY;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < i; ++j)
            if (act(i, j))
                least = fmin(least, longest_of(y, a, i, j));
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < n && s.wall[k] == SCENE_PERIODIC; ++i)
            least = fmin(least, (s.high[k] - s.low[k]) / 8 /
                                    size_of(y[(3 + k) * n + i]));
    return least;
}

/* Between two balls, one of them perhaps an image of itself; or between a
   ball and a wall: then a is b, and the side -1 below, 1 above. */
struct gap {
    size_t a, b, axis;
    double side;
    int image[3];
};
static struct gap gaps[MOST * (MOST - 1) / 2 * 27 + 6 * MOST];
static size_t count;

static void add_gaps(void)
{
    for (size_t k = 0; s.contact && k < 3; ++k)
        for (size_t i = 0; s.wall[k] == SCENE_HARD && i < n; ++i)
            if (s.freedom[k * n + i])
                for (int side = -1; side <= 1; side += 2)
                    gaps[count++] = (struct gap){i, i, k, side, {0}};
    for (size_t i = 0; s.contact && i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            int m[3];
            bool free = false;
            for (size_t k = 0; k < 3; ++k) {
                m[k] = s.wall[k] == SCENE_PERIODIC;
                free = free || s.freedom[k * n + i] || s.freedom[k * n + j];
            }
            for (int p = -m[0]; free && p <= m[0]; ++p)
                for (int q = -m[1]; q <= m[1]; ++q)
                    for (int r = -m[2]; r <= m[2]; ++r)
                        gaps[count++] = (struct gap){i, j, 0, 0, {p, q, r}};
        }
}

static real image(const struct gap *g, const real start[], size_t k)
{
    if (s.wall[k] != SCENE_PERIODIC)
        return 0;
    const double side = s.high[k] - s.low[k];
    const double d = (double)(start[k * n + g->b] - start[k * n + g->a]);
    return (real)side * (floor(d / side + 0.5) + g->image[k]);
}

static real width(const struct gap *g, const real start[], const real y[],
                  real *rate)
{
    if (g->a == g->b) {
        const size_t c = g->axis * n + g->a;
        const real edge = g->side > 0
                              ? (real)s.high[g->axis] - s.radius[g->a]
                              : (real)s.low[g->axis] + s.radius[g->a];
        *rate = -(real)g->side * y[3 * n + c];
        return (real)g->side * (edge - y[c]);
    }
    real r2 = 0, ru = 0;
    for (size_t k = 0; k < 3; ++k) {
        const real d =
            y[k * n + g->b] - y[k * n + g->a] - image(g, start, k);
        r2 += d * d;
        ru += d * (y[(3 + k) * n + g->b] - y[(3 + k) * n + g->a]);
    }
    const real r = root(r2);
    *rate = r > 0 ? ru / r : 0;
    return r - ((real)s.radius[g->a] + s.radius[g->b]);
}

/* A step between two states, in double: quintic in each coordinate. */
struct path {
    double h;
    double q[3 * MOST][6];
};

static void draw(struct path *p, const real y[], const real z[], double h)
{
    real a[3 * MOST], b[3 * MOST];
    accelerate(y, a);
    accelerate(z, b);
    p->h = h;
    for (size_t c = 0; c < 3 * n; ++c) {
        const double v = (double)y[3 * n + c] * h, u = (double)a[c] * h * h;
        const double x = (double)(z[c] - y[c]);
        const double d0 = x - v - u / 2;
        const double d1 = (double)z[3 * n + c] * h - v - u;
        const double d2 = (double)b[c] * h * h - u;
        double *q = p->q[c];
        q[0] = (double)y[c], q[1] = v, q[2] = u / 2;
        q[3] = 10 * d0 - 4 * d1 + d2 / 2;
        q[4] = -15 * d0 + 7 * d1 - d2;
        q[5] = 6 * d0 - 3 * d1 + d2 / 2;
    }
}

static void look(const struct path *p, double r, real y[])
{
    for (size_t c = 0; c < 3 * n; ++c) {
        const double *q = p->q[c];
        y[c] = q[0] +
               r * (q[1] + r * (q[2] + r * (q[3] + r * (q[4] + r * q[5]))));
        y[3 * n + c] =
            (q[1] + r * (2 * q[2] +
                         r * (3 * q[3] + r * (4 * q[4] + r * 5 * q[5])))) /
            p->h;
    }
}

static void reach(const real y[], real h, real out[])
{
    if (h == 0) {
        memcpy(out, y, size * sizeof *out);
        return;
    }
    if (extrapolate(y, h, out))
        return;
    memcpy(out, y, size * sizeof *out);
    if (stuck)
        return;
    real mid[6 * MOST];
    static int depth;
    if (++depth > 30)
        stuck = "a part does not settle";
    else {
        reach(y, h / 2, mid);
        reach(mid, h / 2, out);
    }
    --depth;
}

static real true_width(const struct gap *g, const real y[], real h,
                       real *rate)
{
    real z[6 * MOST];
    reach(y, h, z);
    return width(g, y, z, rate);
}

/* Where the rate changes its sign between lo and hi. */
static real turn(const struct gap *g, const real y[], real lo, real hi,
                 bool rises)
{
    real rate;
    for (int k = 0; k < 80 && hi - lo > (real)1e-24 * hi; ++k) {
        const real mid = (lo + hi) / 2;
        true_width(g, y, mid, &rate);
        *((rate > 0) == rises ? &lo : &hi) = mid;
    }
    return (lo + hi) / 2;
}

/* w > 0 at lo, <= 0 at hi. */
static real find(const struct gap *g, const real y[], real lo, real hi)
{
    real rate, a = true_width(g, y, lo, &rate),
               b = true_width(g, y, hi, &rate);
    int side = 0;
    for (int k = 0; k < 200 && hi - lo > (real)1e-28 * hi; ++k) {
        real mid = (lo * b - hi * a) / (b - a);
        if (k % 8 == 7 || !(mid > lo && mid < hi))
            mid = (lo + hi) / 2;
        const real w = true_width(g, y, mid, &rate);
        if (size_of(w) < 1e-27 * length) {
            hi = mid;
            break;
        }
        if (w > 0) {
            lo = mid, a = w;
            if (side == 1)
                b /= 2;
            side = 1;
        } else {
            hi = mid, b = w;
            if (side == -1)
                a /= 2;
            side = -1;
        }
    }
    return hi;
}

#define TOUCH (1e-15 * length + 100 * EPS * far)

/* A part of a step, as the path has it. */
struct part {
    double lo, hi; /* shares of the step */
    real rate[2];  /* of the gap, at both */
    real width;    /* at hi */
};

/* May the gap be shut somewhere in this part, as far as the path knows? */
static bool may_close(const struct gap *g, const struct path *p,
                      const real y[], const struct part *q, double margin)
{
    real z[6 * MOST], rate, least = q->width;
    double a = q->lo, b = q->hi;
    if (least <= margin || !(q->rate[0] < 0 && q->rate[1] > 0))
        return least <= margin;
    for (int j = 0; j < 40; ++j) {
        look(p, (a + b) / 2, z);
        least = width(g, y, z, &rate);
        *(rate < 0 ? &a : &b) = (a + b) / 2;
    }
    return least <= margin;
}

/* When it shuts between these two moments; -1: it does not. One that is
   fresh touches at 0 and opens there. */
static real close_in(const struct gap *g, const real y[], real from,
                     real to, bool fresh)
{
    real ra, rb, wa = true_width(g, y, from, &ra);
    if (true_width(g, y, to, &rb) > 0) {
        if (!(ra < 0 && rb > 0))
            return -1;
        to = turn(g, y, from, to, false);
        if (true_width(g, y, to, &rb) > 0)
            return -1;
    }
    if (fresh) {
        if (ra > 0)
            from = turn(g, y, from, to, true);
        wa = true_width(g, y, from, &ra);
        if (wa <= 0) /* it goes on touching, or presses */
            return ra >= 0 && rb >= 0 ? -1 : 0;
    }
    return wa <= 0 ? from : find(g, y, from, to);
}

/* The first moment in the step at which a gap closes; h: none. */
static real first_root(const struct gap *g, const struct path *p,
                       const real y[], real h, double margin)
{
    real z[6 * MOST];
    struct part q = {0};
    if (g->a == g->b && held[g->axis * n + g->a] == (int)g->side)
        return h;
    const real start = width(g, y, y, &q.rate[1]);
    const bool fresh = size_of(start) <= TOUCH && q.rate[1] >= 0;
    for (int k = 1; k <= SAMPLES; ++k) {
        q.lo = q.hi;
        q.hi = (double)k / SAMPLES;
        q.rate[0] = q.rate[1];
        look(p, q.hi, z);
        q.width = width(g, y, z, &q.rate[1]);
        if (!may_close(g, p, y, &q, margin))
            continue;
        const real t = close_in(g, y, q.lo * h, k == SAMPLES ? h : q.hi * h,
                                k == 1 && fresh);
        if (t >= 0)
            return t;
    }
    return h;
}

static void reflect(const struct gap *g, const real start[], real y[])
{
    real *v = y + 3 * n, d[3], w[2] = {0, 0}, closing = 0;
    if (g->a == g->b) {
        const size_t c = g->axis * n + g->a;
        v[c] *= -(real)s.restitution;
        return;
    }
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = k * n + g->a, j = k * n + g->b;
        d[k] = y[j] - y[i] - image(g, start, k);
        closing += d[k] * (v[j] - v[i]);
        w[0] += s.freedom[i] ? d[k] * d[k] / s.mass[g->a] : 0;
        w[1] += s.freedom[j] ? d[k] * d[k] / s.mass[g->b] : 0;
    }
    if (!(w[0] + w[1] > 0))
        return;
    const real J = -(1 + (real)s.restitution) * closing / (w[0] + w[1]);
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = k * n + g->a, j = k * n + g->b;
        if (s.freedom[i])
            v[i] -= J * d[k] / s.mass[g->a];
        if (s.freedom[j])
            v[j] += J * d[k] / s.mass[g->b];
        if (v[i] != 0)
            held[i] = 0;
        if (v[j] != 0)
            held[j] = 0;
    }
}

/* What is left of a collision is too little to rise by: it rests. */
static void come_to_rest(const struct gap *g, real y[])
{
    real a[3 * MOST], rate;
    accelerate(y, a);
    if (g->a == g->b) {
        const size_t c = g->axis * n + g->a;
        const double press = g->side * (double)a[c];
        const double u = (double)y[3 * n + c];
        if (press > 0 && u * u <= 2 * press * 1e-22 * length) {
            y[3 * n + c] = 0;
            held[c] = (signed char)g->side;
        }
    } else {
        width(g, y, y, &rate);
        if (rate < 1e-11 * speed)
            stuck = "a pair comes to rest";
    }
}

/* Does it touch, and approach? */
static bool collides(const struct gap *g, const real y[])
{
    real rate;
    if (g->a == g->b && held[g->axis * n + g->a] == (int)g->side &&
        y[(3 + g->axis) * n + g->a] == 0)
        return false;
    const real w = width(g, y, y, &rate);
    return w <= TOUCH && w > -1e-9 * length &&
           rate < -(real)1e3 * EPS * speed;
}

static void settle(real y[])
{
    bool any = true;
    for (int pass = 0; any; ++pass) {
        any = false;
        for (size_t j = 0; j < count; ++j) {
            if (!collides(&gaps[j], y))
                continue;
            reflect(&gaps[j], y, y);
            any = true;
            ++contacts;
            come_to_rest(&gaps[j], y);
        }
        if (pass > 500) {
            stuck = "collisions without end";
            return;
        }
    }
}

/* What lies on a wall at the start stays there. */
static void rest_at_start(const real y[])
{
    real a[3 * MOST], rate;
    accelerate(y, a);
    for (size_t j = 0; j < count; ++j) {
        const struct gap *g = &gaps[j];
        if (g->a == g->b && size_of(width(g, y, y, &rate)) <= TOUCH &&
            rate == 0 && g->side * (double)a[g->axis * n + g->a] > 0)
            held[g->axis * n + g->a] = (signed char)g->side;
    }
}

static void begin(real y[])
{
    for (size_t c = 0; c < 3 * n; ++c) {
        y[c] = s.position[c];
        y[3 * n + c] = s.freedom[c] ? s.velocity[c] : 0;
    }
}

static void release(const real y[])
{
    for (size_t c = 0; c < 3 * n; ++c)
        if (held[c] && held[c] * y[3 * n + c] < 0)
            held[c] = 0;
}

/* How far a path is from the truth in the middle of its step. */
static double off_path(const struct path *p, const real y[], real h)
{
    real mid[6 * MOST], m[6 * MOST];
    double off = 0;
    reach(y, h / 2, mid);
    look(p, 0.5, m);
    for (size_t c = 0; c < 3 * n; ++c)
        off = fmax(off, size_of(m[c] - mid[c]));
    return off;
}

/* To the first contact at `least`, which is dealt with. */
static void meet(const struct gap *g, real y[], real least)
{
    real z[6 * MOST];
    if (least == 0 && g->a != g->b) {
        stuck = "a pair is pressed";
    } else if (least == 0) {
        const size_t c = g->axis * n + g->a;
        y[3 * n + c] = 0;
        held[c] = (signed char)g->side;
    } else {
        reach(y, least, z);
        memcpy(y, z, size * sizeof *y);
        settle(y);
        release(y);
        if (contacts > CONTACTS)
            stuck = "very many contacts";
    }
}

/* The gap that closes first on the way from y to z, if any, and when. If
   the path is too crude to say: *least is negative. */
static const struct gap *first_gap(const real y[], const real z[], real h,
                                   real *least)
{
    struct path p;
    const struct gap *who = NULL;
    *least = h;
    if (count == 0)
        return NULL;
    draw(&p, y, z, (double)h);
    const double off = off_path(&p, y, h);
    if (off > 1e-4 * length) {
        *least = -1;
        return NULL;
    }
    for (size_t j = 0; j < count && !stuck; ++j) {
        const real r =
            first_root(&gaps[j], &p, y, h, 1e-13 * length + 6 * off);
        if (r < *least) {
            *least = r;
            who = &gaps[j];
        }
    }
    return who;
}

/* How long a step is good, after one of length h that took k columns. */
static double next_step(double h, int k)
{
    return k <= 6 ? 2 * h : k <= 8 ? 1.3 * h : k > 9 ? 0.8 * h : h;
}

/* One step from *t, at most to the end. */
static void step_on(real y[], real *t, real end, double *next, double every)
{
    real a[3 * MOST], z[6 * MOST], least;
    accelerate(y, a);
    work += (double)count;
    const double most = fmin(*next, pace * fmin(longest(y, a), every));
    const bool last = (double)(end - *t) <= most;
    const real h = last ? end - *t : (real)most;
    if (!(h > (real)1e-20 * every)) {
        stuck = "too short a step";
        return;
    }
    const int k = extrapolate(y, h, z);
    if (k == 0) {
        *next = (double)h / 2.5;
        return;
    }
    const struct gap *const g = first_gap(y, z, h, &least);
    *next = (double)h / 2;
    if (stuck || least < 0)
        return;
    if (g) {
        meet(g, y, least);
        *t += least;
        *next = (double)h;
        return;
    }
    memcpy(y, z, size * sizeof *y);
    release(y);
    *t = last ? end : *t + h;
    *next = next_step((double)h, k);
}

/* Follows the scene through the rows. Returns how many were reached. */
static size_t follow(double every, size_t rows, double out[])
{
    double next = INFINITY;
    real y[6 * MOST], t = 0;
    contacts = 0;
    work = 0;
    stuck = NULL;
    memset(held, 0, sizeof held);
    begin(y);
    if (count > 0) {
        rest_at_start(y);
        settle(y);
    }
    for (size_t row = 0; row < rows; ++row) {
        while (t < (real)every * row) {
            if (!stuck && work > WORK)
                stuck = "too long for the truth";
            if (stuck)
                return row;
            step_on(y, &t, (real)every * row, &next, every);
        }
        for (size_t i = 0; i < n; ++i)
            for (size_t k = 0; k < 3; ++k)
                out[(row * n + i) * 3 + k] = (double)y[k * n + i];
    }
    return rows;
}

static void measure(void)
{
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < n; ++i) {
            low = fmin(low, s.position[k * n + i]);
            high = fmax(high, s.position[k * n + i]);
        }
        if (s.wall[k]) {
            low = fmin(low, s.low[k]);
            high = fmax(high, s.high[k]);
        }
        sum += (high - low) * (high - low);
    }
    length = sqrt(sum);
    real y[6 * MOST], a[3 * MOST];
    begin(y);
    accelerate(y, a);
    double v = 0, g = 0;
    for (size_t c = 0; c < 3 * n; ++c) {
        v = fmax(v, fabs(s.velocity[c]));
        g = fmax(g, size_of(a[c]));
        far = fmax(far, fabs(s.position[c]));
    }
    if (!(length > 0))
        length = 1;
    speed = fmax(v, sqrt(g * length) * 0.1);
    if (!(speed > 0))
        speed = 1;
}

/* Reads the rows of a table: t x y z vx vy vz ... Returns whether they are
   those that were asked for. */
static bool read_table(const char *name, double every, size_t rows,
                       double got[])
{
    static char line[1 << 17];
    FILE *f = fopen(name, "r");
    size_t row = 0;
    bool good = f;
    while (good && fgets(line, sizeof line, f)) {
        if (line[0] == '#' || line[0] == '\n')
            continue;
        char *at = line;
        const double t = s.time + every * (double)row;
        good = row < rows && fabs(strtod(at, &at) - t) <= 1e-9 * every;
        for (size_t i = 0; good && i < n; ++i)
            for (size_t k = 0; k < 6; ++k) {
                const double x = strtod(at, &at);
                if (k < 3)
                    got[(row * n + i) * 3 + k] = x;
            }
        ++row;
    }
    if (f)
        fclose(f);
    return good && row == rows;
}

/* The largest distance between two tables, and its row; NONSENSE: one of
   them is no number somewhere. */
#define NONSENSE 1e99
static double apart(const double a[], const double b[], size_t rows,
                    double scale, size_t *where)
{
    double most = 0;
    for (size_t c = 0; c < 3 * n * rows; ++c) {
        double d = fabs(a[c] - b[c]) / scale;
        const size_t k = c % 3;
        if (s.wall[k] == SCENE_PERIODIC) {
            const double side = (s.high[k] - s.low[k]) / scale;
            d = fabs(d - side * floor(d / side + 0.5));
        }
        if (!(d < NONSENSE))
            d = NONSENSE;
        if (d > most) {
            most = d;
            *where = c / (3 * n);
        }
    }
    return most;
}

static double *new_table(size_t rows)
{
    double *const x = calloc(3 * n * rows, sizeof *x);
    if (!x)
        exit(2);
    return x;
}

int main(int argc, char **argv)
{
    if (argc != 6 || !scene_read(&s, "truth", argv[1]) || s.bodies > MOST)
        return 2;
    n = s.bodies;
    size = 6 * n;
    const size_t rows = (size_t)atol(argv[3]) + 1;
    const double every = (atof(argv[2]) - s.time) / (double)(rows - 1);
    const double scale = atof(argv[5]);
    double *const path = new_table(rows), *const again = new_table(rows),
                  *const table = new_table(rows);
    size_t at = 0, none;
    measure();
    add_gaps();
    tolerance = DIGITS > 64 ? 1e-22 : fmax(5e-16, 30 * EPS * far / length);
    pace = 1;
    size_t reached = follow(every, rows, path);
    const char *const why = stuck;
    tolerance *= DIGITS > 64 ? 100 : 10;
    pace = 0.55;
    if (reached > 0)
        reached = follow(every, reached, again);
    const double own = apart(path, again, reached, scale, &none);
    const double error = read_table(argv[4], every, rows, table)
                             ? apart(path, table, reached, scale, &at)
                             : NONSENSE;
    printf("error %.3e in row %zu, own %.1e, rows %zu of %zu: %s\n", error,
           at, own, reached, rows,
           reached == rows ? "all"
           : why           ? why
                           : stuck);
    return 0;
}
