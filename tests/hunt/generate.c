/* Random scenes of a kind, to hunt wrong answers with. The first line is
   the request, as a comment.
   generate KIND SEED */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state;

static double uniform(void)
{
    uint64_t z = (state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

static double from(double a, double b)
{
    return a + (b - a) * uniform();
}

static double power(double a, double b)
{
    return pow(10, from(a, b));
}

static bool chance(double p)
{
    return uniform() < p;
}

static size_t below(size_t n)
{
    return (size_t)(uniform() * (double)n);
}

enum { MOST = 16, LINES = 64 };

static struct {
    size_t n, kinds, springs;
    double x[MOST][3], v[MOST][3], m[MOST], r[MOST];
    bool fixed[MOST][3];
    double D[LINES], c[LINES];
    size_t a[LINES], b[LINES], kind[LINES];
    double rest[LINES]; /* below 0: none is given */
    double k2, soft, grav[3], damp, restitution;
    bool axial, contact;
    int wall[3];
    double low[3], high[3];
    double until;
} s;

static bool coarse;   /* numbers as people write them */
static unsigned flat; /* axes that are dead */

static double number(double x)
{
    return coarse ? round(4 * x) / 4 : x;
}

static double distance(size_t i, size_t j)
{
    double r2 = 0;
    for (size_t k = 0; k < 3; ++k)
        r2 += (s.x[i][k] - s.x[j][k]) * (s.x[i][k] - s.x[j][k]);
    return sqrt(r2);
}

/* Anywhere, but where another is. */
static void place(size_t i, double size, double fast)
{
    for (size_t k = 0; k < 3; ++k) {
        s.x[i][k] = flat >> k & 1 ? 0 : number(from(-size, size));
        s.v[i][k] = flat >> k & 1 ? 0 : number(from(-fast, fast));
    }
    for (size_t j = 0; j < i; ++j)
        if (distance(i, j) == 0)
            s.x[i][0] += 0.3 * (double)(i + 1);
}

static void hold(size_t i)
{
    for (size_t k = 0; k < 3; ++k) {
        s.fixed[i][k] = true;
        s.v[i][k] = 0;
    }
}

static void join(size_t a, size_t b, size_t kind, double rest)
{
    const size_t j = s.springs++;
    s.a[j] = a, s.b[j] = b, s.kind[j] = kind, s.rest[j] = rest;
}

static void any_flat(void)
{
    flat = chance(0.5) ? 4 : chance(0.2) ? 6 : chance(0.5) ? 0 : 4;
}

/* Bodies that attract and pass close. */
static void close_passages(void)
{
    s.n = 2 + below(4);
    s.k2 = 1;
    any_flat();
    for (size_t i = 0; i < s.n; ++i) {
        place(i, 1, 0.4);
        s.m[i] = chance(0.25)  ? 0
                 : chance(0.3) ? power(-6, 0)
                               : from(0.2, 1);
        if (chance(0.3))
            s.v[i][0] = s.v[i][1] = s.v[i][2] = 0;
    }
    if (chance(0.2))
        s.soft = power(-4, -1);
    if (chance(0.15))
        hold(0);
    if (chance(0.15))
        s.damp = s.m[0] > 0 ? power(-4, -1) : 0;
    for (size_t i = 0; i < s.n; ++i)
        if (s.damp > 0 && s.m[i] == 0)
            s.m[i] = 0.1;
    s.until = power(-1, 1);
}

/* An eccentric pair, and a comet or a companion far away. */
static void eccentric(void)
{
    s.n = 2 + below(3);
    s.k2 = 1;
    flat = chance(0.5) ? 4 : 0;
    const double a = 1, e = chance(0.5) ? 1 - power(-5, -1) : from(0, 0.9);
    s.m[0] = 1;
    s.m[1] = chance(0.4) ? 0 : power(-6, 0);
    const double far = a * (1 + e),
                 v = sqrt((1 + s.m[1]) / a * (1 - e) / (1 + e));
    s.x[1][0] = far;
    s.v[1][1] = v;
    for (size_t i = 2; i < s.n; ++i) {
        place(i, chance(0.5) ? 3 : 10, 0.5);
        s.m[i] = chance(0.4) ? 0 : power(-9, 0);
    }
    if (chance(0.5)) {
        /* into the middle of mass */
        double p = s.m[1] * v / (1 + s.m[1]),
               q = s.m[1] * far / (1 + s.m[1]);
        for (size_t i = 0; i < 2; ++i)
            s.x[i][0] -= q, s.v[i][1] -= p;
    }
    s.until = 6.2831853 * (chance(0.3) ? power(-2, 0) : power(0, 1.5));
}

/* A star, planets, grains. */
static void planets(void)
{
    s.n = 2 + below(5);
    s.k2 = 1;
    flat = chance(0.5) ? 4 : 0;
    s.m[0] = 1;
    for (size_t i = 1; i < s.n; ++i) {
        const double r = pow(1.6, (double)i) * from(0.9, 1.1),
                     w = from(0, 6.283),
                     e = chance(0.3) ? from(0, 0.6) : 0.05;
        const double v = sqrt((1 + e) / r),
                     t = chance(0.5) ? from(-0.3, 0.3) : 0;
        s.x[i][0] = r * cos(w), s.x[i][1] = r * sin(w);
        s.v[i][0] = -v * sin(w), s.v[i][1] = v * cos(w);
        if (!flat)
            s.v[i][2] = t * v;
        s.m[i] = chance(0.3) ? 0 : power(-8, -2);
        if (chance(0.1)) { /* a moon */
            s.x[i][0] = s.x[i - 1][0] + 0.01;
            s.x[i][1] = s.x[i - 1][1];
            s.v[i][0] = s.v[i - 1][0];
            s.v[i][1] = s.v[i - 1][1] + sqrt(s.m[i - 1] / 0.01);
        }
    }
    s.until = 6.2831853 * power(-1, 2.3);
}

/* Bodies on springs. */
static void springs(void)
{
    s.n = 2 + below(5);
    any_flat();
    s.kinds = 1 + below(3);
    for (size_t k = 0; k < s.kinds; ++k) {
        s.D[k] = chance(0.3) ? power(2, 5) : power(-1, 2);
        s.c[k] = chance(0.3) ? power(-3, 0) : 0;
    }
    s.axial = chance(0.4);
    for (size_t i = 0; i < s.n; ++i) {
        place(i, 1, chance(0.5) ? 1 : 0);
        s.m[i] = chance(0.5) ? 1 : power(-2, 1);
    }
    if (chance(0.6))
        hold(0);
    for (size_t i = 1; i < s.n; ++i)
        join(chance(0.7) ? i - 1 : below(i), i, below(s.kinds),
             chance(0.3)   ? 0
             : chance(0.5) ? -1
                           : number(from(0, 1.5)));
    for (size_t i = 0; i + 2 < s.n; ++i)
        if (chance(0.4))
            join(i, i + 2, below(s.kinds),
                 chance(0.3) ? 0 : number(from(0, 1.5)));
    if (chance(0.4))
        s.grav[1] = coarse ? -10 : -power(-1, 1);
    if (chance(0.2))
        s.damp = power(-3, 0);
    if (chance(0.25)) { /* straight through the middle, or nearly */
        const double by = chance(0.5) ? 0 : power(-12, -2);
        const size_t j = below(s.springs), a = s.a[j], b = s.b[j];
        for (size_t k = 0; k < 3; ++k)
            s.v[b][k] = s.v[a][k] - 3 * (s.x[b][k] - s.x[a][k]);
        if (!(flat & 2))
            s.v[b][1] += by;
        s.rest[j] = from(0, 0.5);
    }
    if (chance(0.1)) {
        s.k2 = power(-3, 0);
        s.soft = chance(0.5) ? 0.05 : 0;
    }
    s.until = power(-1, 1.3);
}

/* A chain of stiff springs and weights: pendulums. */
static void pendulums(void)
{
    s.n = 2 + below(4);
    flat = chance(0.7) ? 4 : 0;
    s.kinds = 2;
    s.D[0] = power(3, 7);
    s.D[1] = power(-1, 1);
    s.c[0] = chance(0.2) ? power(-1, 1) : 0;
    s.axial = chance(0.5);
    double x = 0, y = 0;
    for (size_t i = 0; i < s.n; ++i) {
        const double w = from(0, 6.283), l = from(0.5, 1);
        s.x[i][0] = x, s.x[i][1] = y;
        x += l * cos(w), y += l * sin(w);
        if (!flat)
            s.v[i][2] = from(-0.3, 0.3);
        s.m[i] = from(0.3, 1);
        if (i > 0)
            join(i - 1, i, 0, -1);
    }
    if (chance(0.8))
        hold(0);
    if (chance(0.3) && s.n > 2)
        join(0, s.n - 1, 1, chance(0.5) ? -1 : 0.5);
    if (chance(0.3))
        s.damp = power(-3, -1);
    s.grav[1] = -power(-0.5, 1);
    s.until = power(-0.5, 1);
}

/* Does ball i overlap no wall and no ball before it? */
static bool has_room(size_t i)
{
    for (size_t k = 0; k < 3; ++k)
        if (s.wall[k] && (s.x[i][k] < s.low[k] + s.r[i] ||
                          s.x[i][k] > s.high[k] - s.r[i]))
            return false;
    for (size_t j = 0; j < i; ++j)
        if (distance(i, j) < s.r[i] + s.r[j])
            return false;
    return true;
}

/* Puts balls where they have room; fewer, if there is none. */
static void put_balls(double size, double fast)
{
    for (size_t i = 0; i < s.n; ++i) {
        int trials = 0;
        s.r[i] = chance(0.5) ? 0.125 : from(0.03, 0.2);
        s.m[i] = chance(0.5) ? 1 : power(-1, 1);
        do
            place(i, size, fast);
        while (!has_room(i) && ++trials < 200);
        if (trials == 200)
            s.n = i;
    }
}

static void any_walls(double size)
{
    for (size_t k = 0; k < 3; ++k) {
        s.low[k] = -size, s.high[k] = size;
        s.wall[k] = flat >> k & 1  ? 0
                    : chance(0.6)  ? 1
                    : chance(0.15) ? 2
                                   : 0;
    }
}

/* Weight, with this chance; one that is held; damping. */
static void any_outside(double weight, double damped)
{
    if (chance(weight))
        s.grav[flat & 2 ? 0 : 1] = coarse ? -10 : -power(-1, 1);
    if (chance(0.3))
        hold(below(s.n));
    if (chance(damped))
        s.damp = power(-2, 0);
}

/* Balls, some held, most under weight: they bounce and graze. */
static void balls(void)
{
    s.n = 1 + below(5);
    s.contact = true;
    any_flat();
    s.restitution = chance(0.6) ? 1 : chance(0.2) ? 0 : from(0.3, 0.99);
    any_walls(1);
    put_balls(1, chance(0.7) ? 1 : 0);
    any_outside(0.8, 0.15);
    s.until = power(-0.5, 1);
}

/* A ball thrown so that it just touches another, or just does not, but for
   what a third one does to it. */
static void graze(void)
{
    s.n = 2 + below(2);
    s.contact = true;
    flat = 4;
    s.restitution = chance(0.7) ? 1 : from(0.5, 1);
    const double g = chance(0.8) ? power(-1, 1) : 0, t = power(-1, 0.3);
    const double w = from(0, 6.283), v = power(-0.5, 0.7);
    const double deep = (chance(0.5) ? 1 : -1) * power(-12, -1);
    s.grav[1] = -g;
    s.r[0] = 0.1, s.r[1] = from(0.05, 0.3);
    s.m[0] = s.m[1] = 1;
    /* at t ball 0 is at 0, with the velocity v in the direction w */
    s.v[0][0] = v * cos(w), s.v[0][1] = v * sin(w) + g * t;
    s.x[0][0] = -v * cos(w) * t;
    s.x[0][1] = -v * sin(w) * t - g * t * t / 2;
    const double side = chance(0.5) ? 1 : -1;
    const double r = (s.r[0] + s.r[1]) * (1 - deep);
    s.x[1][0] = -side * sin(w) * r;
    s.x[1][1] = side * cos(w) * r;
    hold(1);
    if (s.n > 2) {
        s.r[2] = 0.1, s.m[2] = power(-1, 1);
        s.x[2][0] = s.x[1][0] + from(1, 3);
        s.x[2][1] = s.x[1][1] + from(-3, 3);
        if (chance(0.5))
            s.k2 = power(-7, -2);
    }
    s.until = t * from(0.8, 4);
}

/* Balls with springs, or that attract. */
static void bound_balls(void)
{
    s.n = 2 + below(4);
    s.contact = true;
    any_flat();
    s.restitution = chance(0.6) ? 1 : from(0.3, 0.99);
    if (chance(0.6))
        any_walls(1);
    put_balls(1, chance(0.6) ? 1 : 0);
    if (chance(0.5)) {
        s.k2 = power(-2, 0);
        s.soft = chance(0.2) ? 0.05 : 0;
    }
    if (s.k2 == 0 || chance(0.5)) {
        s.kinds = 1;
        s.D[0] = power(-1, 3);
        s.c[0] = chance(0.3) ? power(-3, 0) : 0;
        s.axial = chance(0.5);
        for (size_t i = 1; i < s.n; ++i)
            if (i == 1 || chance(0.6))
                join(below(i), i, 0,
                     chance(0.3)   ? 0
                     : chance(0.5) ? -1
                                   : from(0, 1.5));
    }
    any_outside(0.4, 0.2);
    s.until = power(-0.7, 0.7);
}

/* Beads on a wire. */
static void beads(void)
{
    s.n = 2 + below(7);
    s.contact = true;
    s.restitution = chance(0.6) ? 1 : from(0.5, 1);
    flat = 6;
    double x = 0;
    const bool equal = chance(0.5), touching = chance(0.1);
    for (size_t i = 0; i < s.n; ++i) {
        s.r[i] = chance(0.5) ? 0.125 : 0.015625;
        if (i > 0)
            x +=
                s.r[i] + s.r[i - 1] + (touching ? 0 : number(from(0.3, 1)));
        s.x[i][0] = x;
        s.v[i][0] = number(from(-1, 1));
        s.m[i] = equal ? 1 : power(-1, 1);
    }
    s.wall[0] = chance(0.5) ? 1 : chance(0.3) ? 2 : 0;
    s.low[0] = -1, s.high[0] = x + 1;
    if (chance(0.3))
        s.grav[0] = -power(-1, 1);
    if (chance(0.1))
        s.damp = power(-2, 0);
    if (chance(0.1))
        hold(below(s.n));
    if (chance(0.15)) {
        s.kinds = 1;
        s.D[0] = power(-1, 2);
        join(0, s.n - 1, 0, chance(0.5) ? -1 : 0);
    }
    s.until = power(-0.5, 1.3);
}

/* Everything but contacts, and one that flies free. */
static void mixtures(void)
{
    springs();
    s.k2 = power(-3, 0.5);
    s.soft = chance(0.3) ? power(-3, -1) : 0;
    if (chance(0.5) && s.n < MOST) {
        const size_t i = s.n++;
        place(i, 4, 1);
        s.m[i] = chance(0.5) && s.damp == 0 ? 0 : power(-2, 1);
    }
    if (chance(0.3))
        hold(below(s.n));
    if (chance(0.3))
        for (size_t i = 0; i < s.n; ++i)
            if (chance(0.3))
                s.fixed[i][below(3)] = true;
    s.until = power(-1, 1);
}

/* A fast body that passes close to a slow one, or hits it, among others:
   what steps of one length could leap over. */
static void meetings(bool contact)
{
    s.n = 2 + below(4);
    s.k2 = 1;
    s.contact = contact;
    s.restitution = chance(0.7) ? 1 : from(0.5, 1);
    flat = chance(0.5) ? 4 : 0;
    const double r = contact ? power(-4, -1) : 0;
    for (size_t i = 0; i < s.n; ++i) {
        place(i, 1, 0.1);
        s.m[i] = power(-6, i == 0 ? 0 : -1);
        s.r[i] = r;
    }
    s.x[0][0] = s.x[0][1] = s.x[0][2] = 0;
    if (chance(0.3))
        hold(0);
    const double far = power(-0.3, 1), fast = power(-0.5, 1.5);
    const double b = contact && chance(0.5) ? from(0, 2 * r)
                                            : 2 * r + power(-5, -0.5),
                 w = from(0, 6.28);
    s.x[1][0] = far * cos(w) - b * sin(w);
    s.x[1][1] = far * sin(w) + b * cos(w);
    s.x[1][2] = 0;
    s.v[1][0] = -fast * cos(w), s.v[1][1] = -fast * sin(w), s.v[1][2] = 0;
    for (size_t i = 2; i < s.n; ++i)
        if (s.r[i] > 0 || chance(0.5))
            for (size_t k = 0; k < 3; ++k)
                s.x[i][k] *= 3;
    s.until = far / fast * from(1.2, 5);
    if (contact && chance(0.2))
        s.grav[1] = -power(-2, 0);
}

static void fast_contacts(void)
{
    meetings(true);
}

static void fast_passages(void)
{
    meetings(false);
}

/* A body that swings on a spring past others that are held, often. Where
   the spring ends a ball is hit; a point, which attracts without end, is
   missed. */
static void swinging(void)
{
    s.n = 3 + below(3);
    flat = chance(0.6) ? 4 : 0;
    s.kinds = 1;
    s.D[0] = power(1, 4);
    s.k2 = 1;
    for (size_t i = 0; i < s.n; ++i) {
        place(i, 1, 0);
        s.m[i] = i < 2 ? 1 : power(-5, -1);
        if (i != 1)
            hold(i);
    }
    s.x[0][0] = s.x[0][1] = s.x[0][2] = 0;
    s.contact = chance(0.4);
    s.x[1][0] = 2, s.x[1][2] = 0;
    s.x[1][1] = s.contact && chance(0.5) ? 0 : power(-3, -1);
    join(0, 1, 0, 0);
    for (size_t i = 2; i < s.n; ++i) {
        s.x[i][0] = from(-1.5, 1.5);
        s.x[i][1] = (chance(0.5) ? 1 : -1) * power(-3, -0.7);
        s.x[i][2] = 0;
    }
    for (size_t i = 0; s.contact && i < s.n; ++i)
        s.r[i] = 1e-4;
    s.until = 6.2831853 / sqrt(s.D[0]) * power(-0.5, 1.5);
}

/* Two bodies, for long: on a spring, in orbit, or in flight. */
static void two(void)
{
    s.n = 2;
    flat = chance(0.5) ? 4 : chance(0.5) ? 6 : 0;
    for (size_t i = 0; i < 2; ++i) {
        place(i, 1, 1);
        s.m[i] = power(-1, 1);
    }
    const size_t what = below(4);
    if (chance(0.5) || what == 0)
        hold(0);
    if (what == 0 || what == 3) {
        s.kinds = 1;
        s.D[0] = power(-1, 3);
        s.c[0] = chance(0.4) ? power(-3, 1) : 0;
        s.axial = chance(0.5);
        join(0, 1, 0, chance(0.6) ? 0 : from(0, 2));
        s.until = 6.28 * sqrt(s.m[1] / s.D[0]) * power(-1, 3);
        if (what == 3)
            s.rest[0] = -1;
    } else if (what == 1) {
        s.k2 = power(-1, 1);
        if (chance(0.3))
            s.m[1] = 0;
        s.v[1][1] =
            s.v[0][1] + sqrt(s.k2 * (s.m[0] + s.m[1]) / distance(0, 1));
        s.until = power(-1, 2.5);
    } else
        s.until = power(-1, 2);
    if (chance(0.4))
        s.grav[1] = -power(-1, 1);
    if (chance(0.3) && s.m[1] > 0)
        s.damp = power(-3, 1);
}

/* Balls that lie on the floor and on each other, and some that fall. */
static void heaps(void)
{
    s.n = 1 + below(5);
    s.contact = true;
    flat = chance(0.7) ? 4 : chance(0.5) ? 5 : 0;
    s.restitution = chance(0.4) ? 1 : chance(0.2) ? 0 : from(0.1, 0.99);
    const double r = 0.125;
    for (size_t k = 0; k < 3; ++k) {
        s.low[k] = -1, s.high[k] = 1;
        s.wall[k] = k == 1 || (!(flat >> k & 1) && chance(0.6));
    }
    for (size_t i = 0; i < s.n; ++i) {
        const bool lies = chance(0.4);
        s.r[i] = r, s.m[i] = chance(0.7) ? 1 : power(-1, 1);
        s.x[i][0] = flat & 1 ? 0 : -0.75 + 0.3 * (double)i;
        s.x[i][1] = lies ? -1 + r : number(from(-0.85, 0.85));
        if (flat & 1)
            s.x[i][2] = -0.75 + 0.3 * (double)i;
        const double up = i > 0 ? s.x[i - 1][1] + 2 * r : 1;
        if (chance(0.3) && up <= 1 - r) { /* on the last one, or above */
            s.x[i][0] = s.x[i - 1][0];
            s.x[i][2] = s.x[i - 1][2];
            s.x[i][1] = chance(0.5) ? up : from(up, 1 - r);
        }
        s.v[i][0] = flat & 1 || chance(0.5) ? 0 : number(from(-1, 1));
        s.v[i][1] = lies || chance(0.5) ? 0 : number(from(-1, 1));
    }
    s.grav[1] = coarse ? -10 : -power(-0.5, 1);
    if (chance(0.2))
        s.damp = power(-2, 0);
    if (s.n > 1 && chance(0.15)) {
        s.kinds = 1;
        s.D[0] = power(0, 3);
        join(0, s.n - 1, 0, chance(0.5) ? -1 : 0.1);
    }
    s.until = power(-0.5, 1);
}

/* Disks in a box that forget their start: after a while rounding decides
   where they are, and how much of it has grown depends on when one looks.
 */
static void forgetful(void)
{
    s.n = 3 + below(5);
    s.contact = true;
    flat = 4;
    for (size_t k = 0; k < 2; ++k) {
        s.low[k] = 0, s.high[k] = 1;
        s.wall[k] = 1;
    }
    for (size_t i = 0; i < s.n; ++i) {
        int trials = 0;
        s.r[i] = from(0.05, 0.12);
        s.m[i] = from(1, 4);
        do
            for (size_t k = 0; k < 2; ++k) {
                s.x[i][k] = from(s.r[i], 1 - s.r[i]);
                s.v[i][k] = from(-2, 2);
            }
        while (!has_room(i) && ++trials < 200);
        if (trials == 200)
            s.n = i;
    }
    s.until = from(0.5, 2.2);
}

/* What is asked for near the floor of rounding: one half forgetful disks,
   one half all that is carried in steps or bounces under weight. */
static void near_floor(void)
{
    static void (*const others[])(void) = {
        close_passages, eccentric,     planets,       springs,
        pendulums,      balls,         graze,         bound_balls,
        mixtures,       fast_contacts, fast_passages, two};
    if (chance(0.5))
        forgetful();
    else
        others[below(sizeof others / sizeof *others)]();
}

static const struct {
    const char *name;
    void (*make)(void);
} kinds[] = {{"close", close_passages}, {"eccentric", eccentric},
             {"planets", planets},      {"springs", springs},
             {"pendulums", pendulums},  {"balls", balls},
             {"graze", graze},          {"bound", bound_balls},
             {"beads", beads},          {"mixtures", mixtures},
             {"hits", fast_contacts},   {"passes", fast_passages},
             {"swinging", swinging},    {"two", two},
             {"heaps", heaps},          {"floor", near_floor}};

/* Other units of length and mass, and another origin. */
static void convert(void)
{
    const double l = chance(0.25) ? power(-3, 3) : 1,
                 m = chance(0.25) ? power(-3, 3) : 1;
    const double off = chance(0.1) ? power(0, 4) : 0;
    for (size_t i = 0; i < s.n; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            s.x[i][k] = l * (s.x[i][k] + (k == 0 ? off : 0));
            s.v[i][k] *= l;
        }
        s.r[i] *= l, s.m[i] *= m;
    }
    for (size_t k = 0; k < 3; ++k) {
        s.low[k] = l * (s.low[k] + (k == 0 ? off : 0));
        s.high[k] = l * (s.high[k] + (k == 0 ? off : 0));
        s.grav[k] *= l;
    }
    for (size_t j = 0; j < s.springs; ++j)
        s.rest[j] *= l;
    for (size_t j = 0; j < s.kinds; ++j)
        s.D[j] *= m, s.c[j] *= m;
    s.k2 *= l * l * l / m;
    s.soft *= l, s.damp *= m;
}

static void print(void)
{
    static const char *const wall[] = {"open", "hard", "periodic"};
    for (size_t i = 0; i < s.n; ++i)
        printf("pos %zu %.17g %.17g %.17g %.17g 0 %.17g\n", i, s.x[i][0],
               s.x[i][1], s.x[i][2], s.m[i], s.r[i]);
    for (size_t i = 0; i < s.n; ++i)
        if (s.v[i][0] != 0 || s.v[i][1] != 0 || s.v[i][2] != 0)
            printf("vel %zu %.17g %.17g %.17g\n", i, s.v[i][0], s.v[i][1],
                   s.v[i][2]);
    for (size_t i = 0; i < s.n; ++i)
        if (s.fixed[i][0] || s.fixed[i][1] || s.fixed[i][2])
            printf("vfix %zu %d %d %d\n", i, !s.fixed[i][0], !s.fixed[i][1],
                   !s.fixed[i][2]);
    for (size_t j = 0; j < s.kinds; ++j)
        printf("s %zu %.17g %.17g\n", j, s.D[j], s.c[j]);
    for (size_t j = 0; j < s.springs; ++j) {
        printf("sl %zu %zu %zu", s.a[j], s.b[j], s.kind[j]);
        if (s.rest[j] >= 0)
            printf(" %.17g", s.rest[j]);
        printf("\n");
    }
    if (s.axial && s.springs)
        printf("dashpot axial\n");
    if (s.grav[0] != 0 || s.grav[1] != 0 || s.grav[2] != 0)
        printf("grav %.17g %.17g %.17g\n", s.grav[0], s.grav[1], s.grav[2]);
    if (s.damp > 0)
        printf("damp %.17g\n", s.damp);
    if (s.k2 > 0)
        printf("k2 %.17g\n", s.k2);
    if (s.soft > 0)
        printf("soft %.17g\n", s.soft);
    if (s.wall[0] || s.wall[1] || s.wall[2]) {
        printf("box %.17g %.17g %.17g %.17g %.17g %.17g\n", s.low[0],
               s.high[0], s.low[1], s.high[1], s.low[2], s.high[2]);
        printf("walls %s %s %s\n", wall[s.wall[0]], wall[s.wall[1]],
               wall[s.wall[2]]);
    }
    if (s.contact)
        printf("contact\n");
    if (s.contact && s.restitution != 1)
        printf("restitution %.17g\n", s.restitution);
}

int main(int argc, char **argv)
{
    static const int rows_of[] = {1, 2, 5, 16, 16, 16, 40, 200, 1000};
    if (argc < 3)
        return 2;
    state = strtoull(argv[2], NULL, 10) * UINT64_C(0x2545f4914f6cdd1d) +
            UINT64_C(88172645463325252);
    for (int k = 0; argv[1][k]; ++k)
        state = state * 31 + (uint64_t)argv[1][k];
    uniform();
    coarse = chance(0.3);
    s.restitution = 1;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k)
        if (strcmp(kinds[k].name, argv[1]) == 0)
            kinds[k].make();
    if (s.n == 0)
        return 2;
    for (size_t i = 0; i < s.n; ++i)
        for (size_t k = 0; k < 3; ++k)
            if (s.fixed[i][k])
                s.v[i][k] = 0;
    convert();
    const int rows = rows_of[below(sizeof rows_of / sizeof *rows_of)];
    if (strcmp(argv[1], "floor") == 0) /* the tolerance: times the floor */
        printf("# until %.17g tolerance %.3g rows %d\n", s.until,
               power(-1, 2), rows < 16 ? rows : 16);
    else
        printf("# until %.17g tolerance %.2g rows %d\n", s.until,
               power(-9, -2), rows);
    print();
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
