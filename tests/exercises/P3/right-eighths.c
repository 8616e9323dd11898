/* Another right answer to project P3, with Kutta's rule of three eighths,
   whose error on a whole eight falls with a power of 4.53. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };

struct state {
    double x[MOST][2], v[MOST][2], a[MOST][2];
};

static int n, springs;
static double g, mass[MOST], radius[MOST];
static struct spring {
    int i, j;
    double k, l;
} spring[MOST];

static void give_up(const char *what, const char *where)
{
    fprintf(stderr, "P3: %s: %s\n", what, where);
    exit(2);
}

static double number(const char *text)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !isfinite(value))
        give_up("expected a number, found", text);
    return value;
}

static long whole(const char *text, long least)
{
    if (!*text || strlen(text) > 15)
        give_up("expected a whole number, found", text);
    for (const char *t = text; *t; ++t)
        if (!isdigit((unsigned char)*t))
            give_up("expected a whole number, found", text);
    if (atol(text) < least)
        give_up("number too small", text);
    return atol(text);
}

static void read_bodies(const char *name, struct state *s)
{
    FILE *f = fopen(name, "r");
    char line[4096];
    if (!f)
        give_up("cannot open", name);
    while (fgets(line, sizeof line, f)) {
        char *word[7], *t = strchr(line, '#');
        int words = 0;
        if (t)
            *t = 0;
        for (t = strtok(line, " \t\r\n"); t; t = strtok(NULL, " \t\r\n")) {
            if (words == 6)
                give_up("too many words in a line of", name);
            word[words++] = t;
        }
        if (words == 0)
            continue;
        if (!strcmp(word[0], "spring")) {
            if (words != 5)
                give_up("a spring has four numbers; in", name);
            if (springs == MOST)
                give_up("more than 64 springs in", name);
            struct spring *p = &spring[springs++];
            p->i = (int)whole(word[1], 1) - 1;
            p->j = (int)whole(word[2], 1) - 1;
            p->k = number(word[3]);
            p->l = number(word[4]);
            if (p->i == p->j || p->k <= 0 || p->l < 0)
                give_up("a spring that is none in", name);
            continue;
        }
        if (words != 6)
            give_up("a body has six numbers; in", name);
        if (n == MOST)
            give_up("more than 64 bodies in", name);
        mass[n] = number(word[0]);
        radius[n] = number(word[1]);
        for (int k = 0; k < 2; ++k) {
            s->x[n][k] = number(word[2 + k]);
            s->v[n][k] = number(word[4 + k]);
        }
        if (mass[n] <= 0 || radius[n] < 0)
            give_up("mass or radius out of bounds in", name);
        ++n;
    }
    fclose(f);
    if (n == 0)
        give_up("no body in", name);
    for (int k = springs; k-- > 0;)
        if (spring[k].i >= n || spring[k].j >= n)
            give_up("a spring to nowhere in", name);
    for (int j = n; j-- > 0;)
        for (int i = j; i-- > 0;) {
            const double dx = s->x[j][0] - s->x[i][0];
            const double dy = s->x[j][1] - s->x[i][1];
            if (hypot(dx, dy) <= radius[i] + radius[j])
                give_up("two bodies touch at the start in", name);
        }
}

static void forces(struct state *s)
{
    memset(s->a, 0, sizeof s->a);
    for (int i = 0; i < n && g > 0; ++i)
        for (int j = i + 1; j < n; ++j) {
            const double dx = s->x[j][0] - s->x[i][0];
            const double dy = s->x[j][1] - s->x[i][1];
            const double d2 = dx * dx + dy * dy, f = g / (d2 * sqrt(d2));
            s->a[i][0] += f * mass[j] * dx;
            s->a[i][1] += f * mass[j] * dy;
            s->a[j][0] -= f * mass[i] * dx;
            s->a[j][1] -= f * mass[i] * dy;
        }
    for (int k = springs; k-- > 0;) {
        const int i = spring[k].i, j = spring[k].j;
        const double dx = s->x[j][0] - s->x[i][0];
        const double dy = s->x[j][1] - s->x[i][1];
        const double d = sqrt(dx * dx + dy * dy);
        if (d == 0)
            continue;
        const double f = spring[k].k * (d - spring[k].l) / d;
        s->a[i][0] += f * dx / mass[i];
        s->a[i][1] += f * dy / mass[i];
        s->a[j][0] -= f * dx / mass[j];
        s->a[j][1] -= f * dy / mass[j];
    }
}

static double energy(const struct state *s)
{
    double e = 0;
    for (int i = n; i-- > 0;) {
        e += mass[i] / 2 *
             (s->v[i][0] * s->v[i][0] + s->v[i][1] * s->v[i][1]);
        for (int j = i + 1; j < n; ++j)
            e -= g * mass[i] * mass[j] /
                 hypot(s->x[j][0] - s->x[i][0], s->x[j][1] - s->x[i][1]);
    }
    for (int k = springs; k-- > 0;) {
        const int i = spring[k].i, j = spring[k].j;
        const double d =
            hypot(s->x[j][0] - s->x[i][0], s->x[j][1] - s->x[i][1]) -
            spring[k].l;
        e += spring[k].k / 2 * d * d;
    }
    return e;
}

static void kick(struct state *s, double h)
{
    for (int c = 2 * n; c-- > 0;)
        s->v[c / 2][c % 2] += s->a[c / 2][c % 2] * h;
}

static void drift(struct state *s, double h)
{
    for (int c = 2 * n; c-- > 0;)
        s->x[c / 2][c % 2] += s->v[c / 2][c % 2] * h;
}

static void euler(struct state *s, double h)
{
    forces(s);
    kick(s, h);
    drift(s, h);
}

static void leapfrog(struct state *s, double h)
{
    forces(s);
    kick(s, h / 2);
    drift(s, h);
    forces(s);
    kick(s, h / 2);
}

/* Adds so much of a slope to places and velocities. */
static void go_along(struct state *s, const struct state *slope, double h)
{
    for (int c = 2 * n; c-- > 0;) {
        s->x[c / 2][c % 2] += h * slope->v[c / 2][c % 2];
        s->v[c / 2][c % 2] += h * slope->a[c / 2][c % 2];
    }
}

static void fourth(struct state *s, double h)
{
    static const double A[4][3] = {
        {0}, {1 / 3.0}, {-1 / 3.0, 1}, {1, -1, 1}};
    static const double w[] = {1 / 8.0, 3 / 8.0, 3 / 8.0, 1 / 8.0};
    static struct state k[4], sum;
    sum = *s;
    for (int c = 0; c < 4; ++c) {
        k[c] = *s;
        for (int e = c; e-- > 0;)
            go_along(&k[c], &k[e], h * A[c][e]);
        forces(&k[c]);
        go_along(&sum, &k[c], h * w[c]);
    }
    *s = sum;
}

static const struct method {
    const char *name;
    int order;
    double limit; /* of omega dt */
    void (*step)(struct state *, double);
} methods[] = {{"euler", 1, 2, euler},
               {"leapfrog", 2, 2, leapfrog},
               {"fourth", 4, 2.8284, fourth}};

/* The longest stable step, s; the fastest vibration is bounded by sums. */
static double limit(const struct method *m)
{
    double most = 0;
    for (int i = n; i-- > 0;) {
        double sum = 0;
        for (int k = springs; k-- > 0;)
            if (spring[k].i == i || spring[k].j == i)
                sum += 2 * spring[k].k / mass[i];
        most = fmax(most, sum);
    }
    return m->limit / sqrt(most);
}

/* The part of the step after which two bodies touch, or infinity. */
static double touch(const struct state *a, const struct state *b,
                    int *first, int *second)
{
    double when = INFINITY;
    for (int j = n; j-- > 0;)
        for (int i = j; i-- > 0;) {
            const double sigma = radius[i] + radius[j];
            double p = 0, q = 0, c = -sigma * sigma;
            if (sigma == 0)
                continue;
            for (int k = 2; k-- > 0;) {
                const double d = a->x[j][k] - a->x[i][k];
                const double e = b->x[j][k] - b->x[i][k] - d;
                p += e * e;
                q += d * e;
                c += d * d;
            }
            const double disc = q * q - p * c;
            if (q >= 0 || disc < 0)
                continue;
            const double s = c <= 0 ? 0 : c / (sqrt(disc) - q);
            if (s <= 1 && s < when) {
                when = s;
                *first = i;
                *second = j;
            }
        }
    return when;
}

static void print(double t, const struct state *s)
{
    printf("%.17g %.17g", t, energy(s));
    for (int c = 0; c < 4 * n; ++c)
        printf(" %.17g", (c & 2 ? s->v : s->x)[c / 4][c & 1]);
    puts("");
}

int main(int argc, char *argv[])
{
    static struct state s, old, half;
    const struct method *m = NULL;
    if (argc != 7)
        give_up("usage", "P3 BODIES G METHOD DT EVERY ROWS");
    read_bodies(argv[1], &s);
    g = number(argv[2]);
    if (g < 0)
        give_up("G below 0", argv[2]);
    for (int k = 0; k < 3; ++k)
        if (!strcmp(argv[3], methods[k].name))
            m = &methods[k];
    if (!m)
        give_up("no such method", argv[3]);
    const double dt = number(argv[4]);
    if (dt <= 0)
        give_up("step not above 0", argv[4]);
    const long every = whole(argv[5], 1), rows = whole(argv[6], 0);
    if (springs) {
        printf("# limit %.17g\n", limit(m));
        if (dt > limit(m)) {
            fprintf(stderr, "P3: a step of %g s is above the limit, %g s\n",
                    dt, limit(m));
            return 1;
        }
    }
    half = s;
    print(0, &s);
    for (long k = 1; k <= every * rows; ++k) {
        int i = 0, j = 0;
        old = s;
        m->step(&s, dt);
        const double when = touch(&old, &s, &i, &j);
        if (when <= 1) {
            printf("# meet %d %d %.17g\n", i + 1, j + 1,
                   (k - 1 + when) * dt);
            fprintf(stderr, "P3: bodies %d and %d meet\n", i + 1, j + 1);
            return 1;
        }
        if (k % every == 0)
            print(k * dt, &s);
    }
    for (long k = 0; k < 2 * every * rows; ++k)
        m->step(&half, dt / 2);
    double most = 0;
    for (int i = n; i-- > 0;)
        most = fmax(most, hypot(s.x[i][0] - half.x[i][0],
                                s.x[i][1] - half.x[i][1]));
    const double power = pow(2, m->order);
    printf("# error %.17g\n", most * power / (power - 1));
    return 0;
}
