/* Complex places; the truth by doubling the three leapfrogs until two runs
   agree to a tenth; each method by bisection between too few and enough. */
#include "force.h"
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef double complex point;
typedef struct {
    point z[8], v[8];
} sky;

static int n;
static double m[8], T, tol;
static sky first;
static long asked;

static void pull(const sky *s, point a[])
{
    double x[16], f[16];
    memcpy(x, s->z, sizeof x);
    force(n, m, x, f);
    asked++;
    for (int i = n; i--;)
        a[i] = (f[2 * i] + I * f[2 * i + 1]) / m[i];
}

static sky fly(int kind, long steps)
{
    const double g = kind == 4 ? 1 / (2 - cbrt(2)) : 1, h = T / steps;
    const double part[3] = {g * h, h - 2 * g * h, g * h};
    point a[8];
    sky s = first;
    if (kind > 1)
        pull(&s, a);
    for (long k = 0; k < steps * (kind == 4 ? 3 : 1); ++k) {
        const double t = part[kind == 4 ? k % 3 : 0];
        if (kind == 1)
            pull(&s, a);
        for (int i = n; i--;) {
            s.v[i] += a[i] * (kind == 1 ? t : t / 2);
            s.z[i] += s.v[i] * t;
        }
        if (kind == 1)
            continue;
        pull(&s, a);
        for (int i = n; i--;)
            s.v[i] += a[i] * t / 2;
    }
    return s;
}

static double off(const sky *a, const sky *b)
{
    double d = 0;
    for (int i = n; i--;)
        d = fmax(d, cabs(a->z[i] - b->z[i]));
    return d >= 0 && d < 1e300 ? d : 1e300;
}

static long cost(int kind, long steps)
{
    return (kind == 4 ? 3 * steps : steps) + (kind > 1);
}

static int fail(int status, const char *s)
{
    fprintf(stderr, "P4: %s\n", s);
    return status;
}

static int load(const char *name)
{
    FILE *f = fopen(name, "r");
    char s[500], c;
    double a, b, v, w;
    if (!f)
        return fail(2, "cannot open the bodies");
    while (fgets(s, 500, f)) {
        if (strchr(s, '#'))
            *strchr(s, '#') = 0;
        const int k =
            sscanf(s, "%lf%lf%lf%lf%lf %c", m + n, &a, &b, &v, &w, &c);
        if (k == EOF)
            continue;
        if (k != 5 || !(m[n] > 0) || !(fabs(a) + fabs(b) < 1e300) ||
            !(fabs(v) + fabs(w) < 1e300))
            return fail(2, "a body is five numbers");
        first.z[n] = a + I * b;
        first.v[n] = v + I * w;
        for (int i = n; i--;)
            if (first.z[i] == first.z[n])
                return fail(2, "two in one place");
        if (++n == 8)
            break;
    }
    fclose(f);
    return n ? 0 : fail(2, "no bodies");
}

int main(int argc, char **argv)
{
    char *e1 = "x", *e2 = "x";
    if (argc == 4)
        T = strtod(argv[2], &e1), tol = strtod(argv[3], &e2);
    if (*e1 || *e2 || !(T > 0) || !(tol > 0))
        return fail(2, "P4 BODIES T TOL");
    if (load(argv[1]))
        return 2;
    long N = 8;
    sky old = fly(4, N), truth = fly(4, 2 * N);
    double was = HUGE_VAL;
    while (off(&old, &truth) > tol / 10 || was > 4 * tol ||
           (off(&old, &truth) > was / 3 && was > tol / 100)) {
        if ((N *= 2) > 100000)
            return fail(1, "beyond the horizon");
        was = off(&old, &truth);
        old = truth;
        truth = fly(4, 2 * N);
    }
    long best = 0, least = 0;
    int kind = 0;
    const int kinds[] = {4, 2, 1};
    for (int i = 0; i < 3; ++i) {
        long low = 0, high = i == 0 ? N : kind ? cost(4, best) / 2 : 50000;
        if (i == 2)
            high = least < 40 ? least : 0;
        sky s = fly(kinds[i], high ? high : 1);
        while (i == 1 && off(&s, &truth) > 0.98 * tol &&
               2 * high < least + 1) {
            low = high;
            high = 2 * high;
            s = fly(2, high);
        }
        if (!high || off(&s, &truth) > 0.98 * tol)
            continue;
        while (high - low > 1 + high / 20) {
            const long mid = (low + high) / 2;
            s = fly(kinds[i], mid);
            *(off(&s, &truth) > 0.98 * tol ? &low : &high) = mid;
        }
        if (high <= 50000 && (!kind || cost(kinds[i], high) < least)) {
            best = high;
            kind = kinds[i];
            least = cost(kind, best);
        }
    }
    if (!kind)
        return fail(1, "beyond the horizon");
    const sky s = fly(kind, best);
    printf("%.17g", T);
    for (const point *z = s.z, *v = s.v; z < s.z + n; ++z, ++v)
        printf(" %.17g %.17g %.17g %.17g", creal(*z), cimag(*z), creal(*v),
               cimag(*v));
    printf("\n# pick %d %ld %ld\n", kind, best, asked);
    return 0;
}
