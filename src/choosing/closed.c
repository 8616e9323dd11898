/* Computes motions in closed form: flight, an oscillator, equal points. */
#include "choosing/closed.h"

#include "forces/kepler.h"

#include <math.h>
#include <stdlib.h>

/* Write x = n log 2 + r. Then e^x is 2^n e^r, and the power of two is
   exact. For e^r fourteen terms of the series suffice, as the next is
   r^15/15! <= 1e-19.

   To keep r accurate, log 2 is split into two parts, the first of 33 bits.
   As n has at most 11 bits, the product of n and the first part is exact.
   Its difference from x is also exact, as the two numbers are nearly equal.
   Only the small second part is rounded. */
double closed_exp(double x)
{
    const double part[] = {0x1.62e42feep-1, 0x1.a39ef35793c76p-33};
    const double n = floor(x / 0.69314718055994531 + 0.5);
    const double r = x - n * part[0] - n * part[1];
    double sum = 1;
    if (!(x > -746 && x < 710))
        return x < 0 ? 0 : x > 0 ? INFINITY : x;
    for (int k = 14; k > 0; --k)
        sum = 1 + r / k * sum;
    return ldexp(sum, (int)n);
}

/* Returns phi_2 = (e^-z - 1 + z) / z^2 for z from 0 to 1. For small z this
   formula would lose all digits, so a series is summed. phi_1 and e^-z can
   be computed from phi_2 without such a loss. */
static double phi2(double z)
{
    double sum = 1;
    for (int n = 18; n > 0; --n)
        sum = 1 - z / (n + 2) * sum;
    return sum / 2;
}

void closed_fly(double t, double rate, double g, double *x, double *v)
{
    if (rate == 0) { /* saves the exponential */
        *x += (*v + g / 2 * t) * t;
        *v += g * t;
        return;
    }
    const double z = rate * t;
    double left = closed_exp(-z), p1 = (1 - left) / z, p2 = (1 - p1) / z;
    if (z <= 1) {
        p2 = phi2(z);
        p1 = 1 - z * p2;
        left = 1 - z * p1;
    }
    *x += *v * t * p1 + g * t * t * p2;
    *v = *v * left + g * t * p1;
}

/* Returns the sum over n of (-z)^n / (2n + first)! for |z| <= 1. This is
   cos(sqrt(z)) if first is 0, and sin(sqrt(z)) / sqrt(z) if first is 1. */
static double series(double z, int first)
{
    double sum = 1;
    for (int n = 18; n > 0; n -= 2)
        sum = 1 - z / ((n + first) * (n + first - 1)) * sum;
    return sum;
}

/* For |z| <= 1 a single series in z covers weak and strong friction (12.5,
   eq:models-swing). For z > 1 a sine and a cosine are used, after the angle
   has been reduced to one turn.

   For z < -1 half the sum and half the difference of two decaying
   exponentials are used. A growing exponential times a small factor could
   become infinity times 0. The rate of the slower exponential is computed
   as a quotient, because a difference could lose digits. */
void closed_oscillate(double t, double square, double rate, double *y,
                      double *v)
{
    const double half = rate / 2, w = square - half * half, z = w * t * t;
    double c, s, decay = closed_exp(-half * t); /* s = t sin(x)/x */
    if (z > 1) {
        const double angle = sqrt(w) * t, whole = 2 * KEPLER_PI;
        kepler_turn(angle - whole * floor(angle / whole), &c, &s);
        s /= sqrt(w);
    } else if (z < -1) {
        const double k = sqrt(-w), fast = closed_exp(-(half + k) * t);
        const double slow = closed_exp(-square / (half + k) * t);
        c = (slow + fast) / 2;
        s = (slow - fast) / (2 * k);
        decay = 1;
    } else {
        c = series(z, 0);
        s = t * series(z, 1);
    }
    const double y0 = *y, v0 = *v;
    *y = decay * (c * y0 + s * (v0 + half * y0));
    *v = decay * (c * v0 - s * (half * v0 + square * y0));
}

struct point {
    double x, v;
};

/* Compares two points for qsort: by position, then by velocity. If two
   points have just met, the slower one is on the left. */
static int by_place(const void *one, const void *other)
{
    const struct point *a = one, *b = other;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return (a->v > b->v) - (a->v < b->v);
}

/* Maps a point on a circle of length 2 width, at u with velocity v, to the
   corresponding point between two walls. The first half of the circle leads
   from the lower wall to the upper wall, and the second half back. */
static struct point unfold(double low, double width, double u, double v)
{
    u -= 2 * width * floor(u / (2 * width));
    if (u > width)
        return (struct point){low + (2 * width - u), -v};
    if (u == 0)
        v = fabs(v);
    return (struct point){low + u, u == width ? -fabs(v) : v};
}

/* Reflects a point at the walls after it has moved freely. A single wall
   reflects it at most once. */
static struct point fold(double low, double high, struct point p)
{
    const bool left = low > -INFINITY, right = high < INFINITY;
    if (left && right)
        return unfold(low, high - low, p.x - low, p.v);
    if (left && (p.x < low || (p.x == low && p.v < 0)))
        return (struct point){low + (low - p.x), -p.v};
    if (right && (p.x > high || (p.x == high && p.v > 0)))
        return (struct point){high - (p.x - high), -p.v};
    return p;
}

/* Moves all points as if they did not collide, reflects them at the walls,
   and sorts them. The cost depends neither on t nor on the number of
   collisions. */
bool closed_relabel(double low, double high, size_t n, double x[],
                    double v[], double t)
{
    struct point *p = malloc((n + 1) * sizeof *p);
    if (!p)
        return false;
    for (size_t i = 0; i < n; ++i)
        p[i] = fold(low, high, (struct point){x[i] + v[i] * t, v[i]});
    qsort(p, n, sizeof *p, by_place);
    for (size_t i = 0; i < n; ++i) {
        x[i] = p[i].x;
        v[i] = p[i].v;
    }
    free(p);
    return true;
}

/* Returns by how many whole turns the faster of two points on a circle is
   ahead of the slower one. `way` and v are the differences of their
   positions and velocities.

   If there are fewer than two walls, the line counts as an infinite
   circle: the result is -1 while the faster point is behind, and 0 after
   that. */
static double turns_ahead(double way, double v, double circle)
{
    if (v == 0)
        return 0;
    if (v < 0)
        way = -way;
    return circle < INFINITY ? floor(way / circle) : way < 0 ? -1 : 0;
}

/* Returns the sum of turns_ahead over all pairs of points at time t (in s).
   With `images`, also counts pairs of a point and the mirror image of a
   point. The mirror image of (x, v) is at -x with velocity -v, where x is
   measured from the wall. */
static double count_until(size_t n, const double x[], const double v[],
                          double t, double wall, double circle, bool images)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            const double a = x[i] - wall + v[i] * t;
            const double b = x[j] - wall + v[j] * t;
            sum += turns_ahead(a - b, v[i] - v[j], circle);
            if (images)
                sum += turns_ahead(a + b, v[i] + v[j], circle);
        }
    return sum;
}

uint64_t closed_meetings(double low, double high, size_t n,
                         const double x[], const double v[], double t)
{
    const bool left = low > -INFINITY, right = high < INFINITY;
    const bool images = left || right;
    const double wall = left ? low : right ? high : 0;
    const double circle = left && right ? 2 * (high - low) : INFINITY;
    const double met = count_until(n, x, v, t, wall, circle, images) -
                       count_until(n, x, v, 0, wall, circle, images);
    return met < 0x1p64 ? (uint64_t)met : UINT64_MAX;
}
