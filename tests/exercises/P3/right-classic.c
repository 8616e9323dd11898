/* One long vector of places and velocities, its derivative, and the classic
   method of Runge and Kutta; the error is twice the difference of the ends,
   whatever the method. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    double y[256]; /* x, y of all, then vx, vy of all */
} vec;

static int n, ns, tie[64][2];
static double m[64], r[64], G, stiff[64][2];

static void die(int status, const char *s)
{
    fflush(stdout);
    fprintf(stderr, "P3: %s\n", s);
    exit(status);
}

static double arg(const char *s, double least, int integer)
{
    char *e;
    double x = strtod(s, &e);
    if (e == s || *e || !(x >= least) || x > 1e300 ||
        (integer && x != trunc(x)))
        die(2, "an argument is no number, or too small");
    return x;
}

static double gap(const vec *s, int i, int j, double *dx, double *dy)
{
    *dx = s->y[2 * j] - s->y[2 * i];
    *dy = s->y[2 * j + 1] - s->y[2 * i + 1];
    return sqrt(*dx * *dx + *dy * *dy);
}

static vec slope(const vec *s)
{
    vec d = {{0}};
    memcpy(d.y, s->y + 2 * n, 2 * n * sizeof(double));
    double *f = d.y + 2 * n;
    for (int k = -n * n; k < ns; ++k) {
        const int i = k < 0 ? (k + n * n) / n : tie[k][0];
        const int j = k < 0 ? (k + n * n) % n : tie[k][1];
        double dx, dy, strength;
        if (j <= i && k < 0)
            continue;
        const double l = gap(s, i, j, &dx, &dy);
        strength = k < 0 ? G * m[i] * m[j] / l / l
                         : stiff[k][0] * (l - stiff[k][1]);
        if (strength == 0)
            continue;
        f[2 * i] += strength / m[i] * dx / l;
        f[2 * i + 1] += strength / m[i] * dy / l;
        f[2 * j] -= strength / m[j] * dx / l;
        f[2 * j + 1] -= strength / m[j] * dy / l;
    }
    return d;
}

static vec plus(const vec *a, double h, const vec *b)
{
    vec c;
    for (int k = 0; k < 4 * n; ++k)
        c.y[k] = a->y[k] + h * b->y[k];
    return c;
}

static vec next(vec s, int order, double h)
{
    vec k1 = slope(&s);
    if (order < 4) {
        const double first = order == 1 ? h : 0.5 * h;
        for (int c = 0; c < 2 * n; ++c) {
            s.y[2 * n + c] += first * k1.y[2 * n + c];
            s.y[c] += h * s.y[2 * n + c];
        }
        if (order == 1)
            return s;
        k1 = slope(&s);
        for (int c = 2 * n; c < 4 * n; ++c)
            s.y[c] += 0.5 * h * k1.y[c];
        return s;
    }
    vec at = plus(&s, h / 2, &k1);
    const vec k2 = slope(&at);
    at = plus(&s, h / 2, &k2);
    const vec k3 = slope(&at);
    at = plus(&s, h, &k3);
    const vec k4 = slope(&at);
    at = plus(&s, h / 6, &k1);
    at = plus(&at, h / 3, &k2);
    at = plus(&at, h / 3, &k3);
    return plus(&at, h / 6, &k4);
}

static void meet(const vec *a, const vec *b, double t, double h)
{
    int one = 0, two = 0;
    double soon = 1.0000000001;
    for (int j = n; j-- > 1;)
        for (int i = j; i-- > 0;) {
            double ax, ay, bx, by;
            const double start = gap(a, i, j, &ax, &ay), size = r[i] + r[j];
            gap(b, i, j, &bx, &by);
            bx -= ax;
            by -= ay;
            /* A s^2 + 2 B s + C = 0 */
            const double A = bx * bx + by * by, B = ax * bx + ay * by;
            const double C = start * start - size * size;
            if (size > 0 && B < 0 && B * B > A * C) {
                const double s = (-B - sqrt(B * B - A * C)) / A;
                if (s < soon)
                    soon = s, one = i + 1, two = j + 1;
            }
        }
    if (one) {
        printf("# meet %d %d %.17g\n", one, two, t + soon * h);
        die(1, "two bodies meet");
    }
}

static void row(const vec *s, double t)
{
    double E = 0, dx, dy;
    for (int i = n; i-- > 1;)
        for (int j = i; j-- > 0;)
            if (G > 0)
                E -= G * m[i] * m[j] / gap(s, i, j, &dx, &dy);
    for (int k = ns; k-- > 0;)
        E += stiff[k][0] / 2 *
             pow(gap(s, tie[k][0], tie[k][1], &dx, &dy) - stiff[k][1], 2);
    for (int i = n; i-- > 0;)
        E +=
            m[i] / 2 *
            (pow(s->y[2 * n + 2 * i], 2) + pow(s->y[2 * n + 2 * i + 1], 2));
    printf("%.17g %.17g", t, E);
    for (const double *x = s->y; x < s->y + 2 * n; x += 2)
        printf(" %.17g %.17g %.17g %.17g", x[0], x[1], x[2 * n],
               x[2 * n + 1]);
    printf("\n");
}

static vec load(const char *name)
{
    static double v[64][2];
    char text[4096], junk;
    double x[6], dx, dy;
    vec s = {{0}};
    FILE *f = fopen(name, "r");
    if (!f)
        die(2, "no such file");
    while (fgets(text, sizeof text, f)) {
        char *hash = strchr(text, '#');
        if (hash)
            strcpy(hash, "\n");
        int c = sscanf(text, " spring %d %d %lf %lf %c", &tie[ns][0],
                       &tie[ns][1], &stiff[ns][0], &stiff[ns][1], &junk);
        if (c == 4) {
            if (tie[ns][0]-- == tie[ns][1]-- || !(stiff[ns][0] > 0) ||
                !(stiff[ns][1] >= 0))
                die(2, "that is no spring");
            ++ns;
            continue;
        }
        if (c > 0)
            die(2, "spring I J K L");
        c = sscanf(text, "%lf%lf%lf%lf%lf%lf %c", x, x + 1, x + 2, x + 3,
                   x + 4, x + 5, &junk);
        if (c == EOF)
            continue;
        if (c != 6 || !(x[0] > 0) || !(x[1] >= 0))
            die(2, "six numbers, the first above 0");
        for (int k = 0; k < 6; ++k)
            if (!isfinite(x[k]))
                die(2, "a number that is none");
        m[n] = x[0];
        r[n] = x[1];
        s.y[2 * n] = x[2];
        s.y[2 * n + 1] = x[3];
        v[n][0] = x[4];
        v[n++][1] = x[5];
    }
    fclose(f);
    if (!n)
        die(2, "no bodies");
    memcpy(s.y + 2 * n, v, 2 * n * sizeof(double));
    for (int k = 2 * ns; k-- > 0;)
        if (tie[k / 2][k % 2] < 0 || tie[k / 2][k % 2] >= n)
            die(2, "no such body");
    for (int i = n; i-- > 1;)
        for (int j = i; j-- > 0;)
            if (gap(&s, i, j, &dx, &dy) <= r[i] + r[j])
                die(2, "they overlap");
    return s;
}

int main(int argc, char **argv)
{
    if (argc != 7)
        die(2, "six words");
    G = arg(argv[2], 0, 0);
    const double h = arg(argv[4], 1e-300, 0);
    const long every = (long)arg(argv[5], 1, 1);
    const long rows = (long)arg(argv[6], 0, 1);
    const int p = !strcmp(argv[3], "euler")      ? 1
                  : !strcmp(argv[3], "leapfrog") ? 2
                  : !strcmp(argv[3], "fourth")   ? 4
                                                 : 0;
    if (!p)
        die(2, "no such method");
    vec s = load(argv[1]), fine = s;
    if (ns) {
        double sum[64] = {0}, most = 0;
        for (int k = 0; k < 2 * ns; ++k) {
            const int end = tie[k / 2][k % 2];
            sum[end] += 2 * stiff[k / 2][0] / m[end];
        }
        for (int i = n; i-- > 0;)
            if (sum[i] > most)
                most = sum[i];
        /* Runge and Kutta: to the root of 8 */
        const double limit = (p == 4 ? 2.8 : 2) / sqrt(most);
        printf("# limit %.17g\n", limit);
        if (h > limit)
            die(1, "the step is beyond the limit");
    }
    row(&s, 0);
    for (long k = 1; k <= rows; ++k) {
        for (long e = 0; e < every; ++e) {
            const vec before = s;
            s = next(s, p, h);
            meet(&before, &s, ((k - 1) * every + e) * h, h);
            fine = next(fine, p, h / 2);
            fine = next(fine, p, h / 2);
        }
        row(&s, k * every * h);
    }
    double worst = 0;
    for (int i = n; i-- > 0;)
        worst = fmax(worst, hypot(s.y[2 * i] - fine.y[2 * i],
                                  s.y[2 * i + 1] - fine.y[2 * i + 1]));
    printf("# error %.3g\n", 2 * worst);
    return 0;
}
