/* Places are complex numbers; a table of times at which pairs meet is kept,
   and only what an event has changed is found anew; the error of a ratio is
   that of its blocks or throws, taken from the means of all others. */
#include <complex.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double r;
static long pairs, walls, seen;

static int bad(const char *text)
{
    fprintf(stderr, "P2: %s\n", text);
    exit(2);
}

static bool real(const char *s, double *x)
{
    char c;
    return sscanf(s, "%lf %c", x, &c) == 1 && isfinite(*x);
}

static bool count(const char *s, long least, long *n)
{
    char *end;
    errno = 0;
    *n = strtol(s, &end, 10);
    return end != s && !*end && !errno && *n >= least;
}

/* ---- flight ---- */

static int n;
static double complex z[16], v[16];
static double at[16]; /* when z was true */
static double meet[16][16], leave[16][2];

static double complex place(int i, double t)
{
    return z[i] + (t - at[i]) * v[i];
}

static double meeting(int i, int j, double t)
{
    const double complex d = place(j, t) - place(i, t), w = v[j] - v[i];
    const double dw = creal(d * conj(w)), vv = creal(w * conj(w));
    const double more = creal(d * conj(d)) - 4.0 * r * r;
    const double under = dw * dw - vv * more;
    ++seen;
    if (dw >= 0.0 || under <= 0.0)
        return INFINITY;
    return t + fmax(0.0, -more / (dw - sqrt(under)));
}

static double wall(double x, double w, double t)
{
    return w == 0.0 ? INFINITY : t + ((w > 0.0) - x - copysign(r, w)) / w;
}

static void plan(int i, double t)
{
    leave[i][0] = wall(creal(place(i, t)), creal(v[i]), t);
    leave[i][1] = wall(cimag(place(i, t)), cimag(v[i]), t);
    for (int j = 0; j < n; ++j)
        if (j != i)
            meet[i][j] = meet[j][i] = meeting(i, j, t);
}

static void set(int i, double t)
{
    z[i] = place(i, t);
    at[i] = t;
}

static void until(double end)
{
    for (;;) {
        double t = end;
        int a = -1, b = -1;
        for (int i = n; i-- > 0;) {
            for (int j = i; j-- > 0;)
                if (t > meet[i][j]) {
                    a = i;
                    b = j;
                    t = meet[a][b];
                }
            for (int c = 2; c-- > 0;)
                if (t > leave[i][c]) {
                    a = i;
                    b = -1 - c;
                    t = leave[a][c];
                }
        }
        if (a < 0)
            return;
        set(a, t);
        if (b < 0) {
            v[a] = b == -1 ? -conj(v[a]) : conj(v[a]);
            ++walls;
        } else {
            set(b, t);
            double complex e = z[b] - z[a];
            e /= cabs(e);
            const double complex given = creal((v[b] - v[a]) * conj(e)) * e;
            v[a] += given;
            v[b] -= given;
            ++pairs;
            plan(b, t);
        }
        plan(a, t);
    }
}

static void load(const char *name)
{
    char text[4096];
    FILE *const f = fopen(name, "r");
    if (f == NULL)
        bad("no DISKS");
    while (fgets(text, sizeof text, f)) {
        double q[4];
        int used = 0;
        char *s = text;
        text[strcspn(text, "#\n")] = 0;
        while (s[strspn(s, " \t\r")] && used < 5) {
            char *next;
            const double x = strtod(s, &next);
            if (next == s || used == 4 || !isfinite(x))
                bad("DISKS: four numbers a line");
            q[used++] = x;
            s = next;
        }
        if (!used)
            continue;
        if (used != 4 || n == 16)
            bad("DISKS: four numbers a line, sixteen lines");
        z[n] = q[0] + I * q[1];
        v[n] = q[2] + I * q[3];
        if (fmin(q[0], q[1]) < r || fmax(q[0], q[1]) > 1.0 - r)
            bad("DISKS: outside");
        for (int i = 0; i < n; ++i)
            if (cabs(z[n] - z[i]) < 2.0 * r)
                bad("DISKS: overlap");
        ++n;
    }
    fclose(f);
    if (!n)
        bad("DISKS: none");
    for (int i = 0; i < n; ++i)
        plan(i, 0.0);
}

/* ---- counts: one row of slices for each block or throw ---- */

static double (*unit)[14];

static void put(long k, double x)
{
    int i = (int)floor((x - r) * 14.0 / (1.0 - 2.0 * r));
    unit[k][i < 0 ? 0 : i > 13 ? 13 : i] += 1.0;
}

static double ratio_of(const double s[14])
{
    return (s[0] + s[13]) / (s[6] + s[7]);
}

static void report(long units, double width)
{
    double all[14] = {0.0}, places = 0.0, spread = 0.0;
    for (int i = 14; i-- > 0; places += all[i])
        for (long k = units; k-- > 0;)
            all[i] += unit[k][i];
    for (int i = 0; i < 14; ++i) {
        double square = 0.0;
        for (long k = 0; k < units; ++k)
            square += pow(unit[k][i] - all[i] / (double)units, 2.0);
        printf("%.17g %.17g %.17g\n", r + (i + 0.5) * width,
               all[i] / places / width, sqrt(square) / places / width);
    }
    const double q = ratio_of(all);
    for (long k = 0; k < units; ++k) {
        double rest[14];
        for (int i = 0; i < 14; ++i)
            rest[i] = all[i] - unit[k][i];
        spread += pow(ratio_of(rest) - q, 2.0);
    }
    const double e = sqrt(spread);
    printf("# ratio %.17g %.17g\n# looks %ld\n# price %.17g\n", q, e, seen,
           (double)seen * 1e4 * e * e / (q * q));
}

/* ---- throws ---- */

static unsigned long long s[2];

/* Vigna's xorshift128+. */
static double u(void)
{
    unsigned long long a = s[0];
    const unsigned long long b = s[1];
    s[0] = b;
    a ^= a << 23;
    s[1] = a ^ b ^ (a >> 18) ^ (b >> 5);
    return (double)((s[1] + b) >> 12) / 4503599627370496.0;
}

static void throws(long disks, long samples)
{
    const double l = 1.0 - 2.0 * r;
    double complex c[16];
    long tries = 0;
    for (long k = 0; k < samples; ++tries) {
        bool fit = true;
        for (long i = 0; i < disks; ++i) {
            c[i] = r + l * u();
            c[i] += I * (r + l * u());
        }
        for (long i = 0; fit && i < disks; ++i)
            for (long j = i + 1; fit && j < disks; ++j, ++seen)
                fit = cabs(c[i] - c[j]) > 2.0 * r;
        for (long i = 0; fit && i < disks; ++i) {
            put(k, creal(c[i]));
            put(k, cimag(c[i]));
        }
        k += fit;
    }
    report(samples, l / 14.0);
    printf("# thrown %ld\n", tries);
}

static double room(double d, double x)
{
    const double pi = 3.14159265358979323846, h = d / 2.0;
    const double lens =
        h < x ? 2.0 * x * x * acos(h / x) - d * sqrt(x * x - h * h) : 0.0;
    return 1.0 - 2.0 * pi * x * x + lens;
}

/* Simpson. */
static double weight(double a, double b, long m, double x)
{
    double sum = 0.0;
    for (int i = 0; i <= 800; ++i) {
        const double d = a + (b - a) * i / 800.0;
        sum += (i % 800 == 0 ? 1.0
                : i % 2      ? 4.0
                             : 2.0) *
               d * pow(room(d, x), (double)m);
    }
    return sum * (b - a) / 2400.0;
}

static bool near(double complex a, double complex b, double reach)
{
    const double x = fabs(creal(a) - creal(b));
    const double y = fabs(cimag(a) - cimag(b));
    return hypot(fmin(x, 1.0 - x), fmin(y, 1.0 - y)) < reach;
}

static void two(long m, double d, long samples)
{
    const double w = (0.5 - 2.0 * r) / 10.0;
    long in[10] = {0}, kept = 0;
    while (kept < samples) {
        double complex a = u(), b = u();
        a += I * u();
        b += I * u();
        bool fit = !near(a, b, 2.0 * r) && near(a, b, 0.5);
        for (long k = 0; fit && k < m; ++k) {
            double complex c = u();
            c += I * u();
            fit = !near(c, a, r + d) && !near(c, b, r + d);
        }
        if (!fit)
            continue;
        const double x = fabs(creal(a - b)), y = fabs(cimag(a - b));
        const int i =
            (int)((hypot(fmin(x, 1.0 - x), fmin(y, 1.0 - y)) - 2.0 * r) /
                  w);
        ++in[i > 9 ? 9 : i];
        ++kept;
    }
    const double all = weight(2.0 * r, 2.0 * r + 10.0 * w, m, r + d);
    for (int i = 0; i < 10; ++i) {
        const double a = 2.0 * r + i * w;
        const double p = (double)in[i] / (double)samples;
        printf("%.17g %.17g %.17g %.17g %.17g\n", a, a + w, p / w,
               sqrt(p * (1.0 - p) / (double)(samples - 1)) / w,
               weight(a, a + w, m, r + d) / all / w);
    }
}

int main(int argc, char **argv)
{
    double tc, d = 0.0;
    long rows, m, seed, samples;
    if (argc < 6 || !real(argv[3], &r) || !(r > 0.0 && r < 0.25))
        return bad("a word, a place for disks, a RADIUS below 1/4, ...");
    const bool look = strcmp(argv[1], "watch") == 0;
    if (argc == 6 && (look || strcmp(argv[1], "fly") == 0)) {
        if (!real(argv[4], &tc) || tc <= 0.0 ||
            !count(argv[5], look ? 1000 : 0, &rows))
            return bad("TC, ROWS");
        load(argv[2]);
        if (look && !(unit = calloc(80, sizeof *unit)))
            return 1;
        for (long k = look; k <= rows; ++k) {
            const double t = (double)k * tc;
            until(t);
            if (!look)
                printf("%.17g", t);
            for (int i = 0; i != n; i++) {
                const double complex p = place(i, t);
                if (look) {
                    put((k - 1) * 80 / rows, creal(p));
                    put((k - 1) * 80 / rows, cimag(p));
                } else {
                    printf(" %.17g %.17g %.17g %.17g", creal(p), cimag(p),
                           creal(v[i]), cimag(v[i]));
                }
            }
            if (!look)
                printf("\n");
        }
        if (look)
            report(80, (1.0 - 2.0 * r) / 14.0);
        else
            printf("# pairs %ld\n# walls %ld\n", pairs, walls);
        return 0;
    }
    const bool pair = strcmp(argv[1], "pair") == 0;
    if (argc != 6 + pair || (!pair && strcmp(argv[1], "throw") != 0) ||
        !count(argv[2], !pair, &m) || (!pair && m > 16) ||
        !count(argv[4 + pair], 0, &seed) ||
        !count(argv[5 + pair], 2, &samples) ||
        (pair && (!real(argv[4], &d) || d < 0.0 || r + d > 0.25)))
        return bad("N, SEED, SAMPLES");
    s[0] = 0x9e3779b97f4a7c15u * (unsigned long long)(seed + 1);
    s[1] = 0x2545f4914f6cdd1du;
    for (int i = 0; i < 50; ++i)
        u();
    if (pair)
        two(m, d, samples);
    else if ((unit = calloc((size_t)samples, sizeof *unit)))
        throws(m, samples);
    return 0;
}
