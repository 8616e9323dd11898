/* Project P3. Steps

   P3 BODIES G METHOD DT EVERY ROWS: bodies that attract each other, and
   springs between them, in steps of DT. It says how wrong its last row is,
   which step its springs allow, and stops when two bodies meet. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };

static int n, springs;
static double mass[MOST], radius[MOST], gravity;
static struct {
    int a, b;
    double k, rest;
} spring[MOST];

/* x and y of body i are [2 * i] and [2 * i + 1]. */
struct state {
    double x[2 * MOST], v[2 * MOST];
};

enum method { EULER, LEAPFROG, FOURTH };

static void refuse(const char *why)
{
    fprintf(stderr, "P3: %s\n", why);
    exit(2);
}

/* ---- what is given ---- */

static double number(const char *text, const char *why)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !isfinite(value))
        refuse(why);
    return value;
}

static long whole(const char *text, long least, const char *why)
{
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || value < least)
        refuse(why);
    return value;
}

/* The numbers of a line: how many there are, or -1 if one is none. */
static int split(char *line, double to[], int most)
{
    int count = 0;
    for (char *w = strtok(line, " \t\r\n"); w;
         w = strtok(NULL, " \t\r\n")) {
        char *end;
        const double value = strtod(w, &end);
        if (*end || !isfinite(value) || count == most)
            return -1;
        to[count++] = value;
    }
    return count;
}

static void read_spring(char *line)
{
    double f[4];
    if (split(line, f, 4) != 4 || springs == MOST)
        refuse("a spring is two numbers of bodies, K and L");
    if (f[0] != floor(f[0]) || f[1] != floor(f[1]) || !(f[0] >= 1) ||
        !(f[1] >= 1) || f[0] > MOST || f[1] > MOST || f[0] == f[1])
        refuse("a spring is between two bodies, counted from 1");
    if (!(f[2] > 0) || !(f[3] >= 0))
        refuse("K must be above 0, and L not below");
    spring[springs].a = (int)f[0] - 1;
    spring[springs].b = (int)f[1] - 1;
    spring[springs].k = f[2];
    spring[springs++].rest = f[3];
}

static void read_bodies(const char *name, struct state *s)
{
    FILE *file = fopen(name, "r");
    char line[1024];
    if (file == NULL)
        refuse("BODIES: there is no such file");
    while (fgets(line, sizeof line, file)) {
        double f[6];
        line[strcspn(line, "#")] = '\0';
        char *begin = line + strspn(line, " \t\r\n");
        if (strncmp(begin, "spring", 6) == 0) {
            read_spring(begin + 6);
            continue;
        }
        const int count = split(begin, f, 6);
        if (count == 0)
            continue;
        if (count != 6 || n == MOST)
            refuse("a body is mass, radius, x, y, vx, vy");
        if (!(f[0] > 0) || !(f[1] >= 0))
            refuse("a mass must be above 0, a radius not below");
        mass[n] = f[0];
        radius[n] = f[1];
        memcpy(s->x + 2 * n, f + 2, 2 * sizeof *f);
        memcpy(s->v + 2 * n++, f + 4, 2 * sizeof *f);
    }
    fclose(file);
    if (n == 0)
        refuse("BODIES: no body");
    for (int k = springs; k-- > 0;)
        if (spring[k].a >= n || spring[k].b >= n)
            refuse("a spring has a body that is not there");
}

static double apart(const struct state *s, int i, int j)
{
    return hypot(s->x[2 * j] - s->x[2 * i],
                 s->x[2 * j + 1] - s->x[2 * i + 1]);
}

static void see_that_they_are_apart(const struct state *s)
{
    for (int i = n; i-- > 1;)
        for (int j = i; j-- > 0;)
            if (apart(s, i, j) <= radius[i] + radius[j])
                refuse("two bodies touch at the start");
}

/* ---- forces ---- */

/* Pulls i and j together with f times their distance. */
static void pull(const struct state *s, double a[], int i, int j, double f)
{
    for (int axis = 0; axis < 2; ++axis) {
        const double along = f * (s->x[2 * j + axis] - s->x[2 * i + axis]);
        a[2 * i + axis] += along / mass[i];
        a[2 * j + axis] -= along / mass[j];
    }
}

static void accelerate(const struct state *s, double a[])
{
    for (int c = 2 * n; c-- > 0;)
        a[c] = 0;
    for (int i = n; gravity > 0 && i-- > 1;)
        for (int j = 0; j < i; ++j)
            pull(s, a, i, j,
                 gravity * mass[i] * mass[j] / pow(apart(s, i, j), 3));
    for (int k = 0; k < springs; ++k) {
        const int i = spring[k].a, j = spring[k].b;
        pull(s, a, i, j,
             spring[k].k * (1 - spring[k].rest / apart(s, i, j)));
    }
}

static double energy(const struct state *s)
{
    double sum = 0;
    for (int i = n; i-- > 0;) {
        const double vx = s->v[2 * i], vy = s->v[2 * i + 1];
        sum += mass[i] * (vx * vx + vy * vy) / 2;
        for (int j = 0; gravity > 0 && j < i; ++j)
            sum -= gravity * mass[i] * mass[j] / apart(s, i, j);
    }
    for (int k = springs; k-- > 0;) {
        const double longer =
            apart(s, spring[k].a, spring[k].b) - spring[k].rest;
        sum += spring[k].k * longer * longer / 2;
    }
    return sum;
}

/* ---- steps ---- */

static void kick(struct state *s, double t)
{
    double a[2 * MOST];
    accelerate(s, a);
    for (int c = 2 * n; c-- > 0;)
        s->v[c] += a[c] * t;
}

static void drift(struct state *s, double t)
{
    for (int c = 2 * n; c-- > 0;)
        s->x[c] += t * s->v[c];
}

static void leap(struct state *s, double t)
{
    kick(s, 0.5 * t);
    drift(s, t);
    kick(s, 0.5 * t);
}

static void step(struct state *s, enum method method, double t)
{
    if (method == EULER) {
        kick(s, t);
        drift(s, t);
    } else if (method == LEAPFROG) {
        leap(s, t);
    } else {
        const double out = 1 / (2 - cbrt(2));
        leap(s, out * t);
        leap(s, (1 - 2 * out) * t);
        leap(s, out * t);
    }
}

/* ---- which step is short enough ---- */

/* The square of the fastest vibration of the springs: they are made to
   swing, and what is fastest grows fastest. */
static double fastest(const struct state *s)
{
    double u[2 * MOST] = {0}, square = 0;
    for (int c = 0; c < 2 * n; ++c)
        u[c] = sin(3 * c * c + 1);
    for (int round = 0; round < 3000; ++round) {
        double w[2 * MOST] = {0}, uw = 0, uu = 0, ww = 0;
        for (int k = springs; k-- > 0;) {
            const int i = spring[k].a, j = spring[k].b;
            const double d = apart(s, i, j);
            const double ex = (s->x[2 * j] - s->x[2 * i]) / d;
            const double ey = (s->x[2 * j + 1] - s->x[2 * i + 1]) / d;
            const double f =
                spring[k].k * (ex * (u[2 * j] - u[2 * i]) +
                               ey * (u[2 * j + 1] - u[2 * i + 1]));
            w[2 * i] -= f * ex / mass[i];
            w[2 * i + 1] -= f * ey / mass[i];
            w[2 * j] += f * ex / mass[j];
            w[2 * j + 1] += f * ey / mass[j];
        }
        for (int c = 2 * n; c-- > 0;) {
            uw += mass[c / 2] * u[c] * w[c];
            uu += mass[c / 2] * u[c] * u[c];
            ww += mass[c / 2] * w[c] * w[c];
        }
        square = uw / uu;
        for (int c = 0; c < 2 * n; ++c)
            u[c] = w[c] / sqrt(ww);
    }
    return square;
}

/* ---- who meets ---- */

/* The part of a step, between these two, after which i and j touch; above 1
   if they do not. Between the ends they fly straight. */
static double touch(const struct state *from, const struct state *to, int i,
                    int j)
{
    const double x = from->x[2 * j] - from->x[2 * i];
    const double y = from->x[2 * j + 1] - from->x[2 * i + 1];
    const double wx = to->x[2 * j] - to->x[2 * i] - x;
    const double wy = to->x[2 * j + 1] - to->x[2 * i + 1] - y;
    const double sigma = radius[i] + radius[j];
    const double b = x * wx + y * wy, ww = wx * wx + wy * wy;
    const double c = x * x + y * y - sigma * sigma;
    const double under = b * b - ww * c;
    if (sigma == 0 || b >= 0 || under < 0)
        return INFINITY;
    return c / (sqrt(under) - b);
}

static void see_who_meets(const struct state *from, const struct state *to,
                          double t, double dt)
{
    double first = INFINITY;
    int who[2] = {0, 0};
    for (int j = 1; j < n; ++j)
        for (int i = j; i-- > 0;) {
            const double part = touch(from, to, i, j);
            if (part < first) {
                first = part;
                who[0] = i;
                who[1] = j;
            }
        }
    if (first > 1)
        return;
    printf("# meet %d %d %.17g\n", who[0] + 1, who[1] + 1, t + first * dt);
    fflush(stdout);
    fprintf(stderr, "P3: bodies %d and %d meet\n", who[0] + 1, who[1] + 1);
    exit(1);
}

static void print_row(const struct state *s, double t)
{
    printf("%.17g %.17g", t, energy(s));
    for (int i = 0; i < 2 * n; i += 2)
        printf(" %.17g %.17g %.17g %.17g", s->x[i], s->x[i + 1], s->v[i],
               s->v[i + 1]);
    putchar('\n');
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"euler", "leapfrog", "fourth"};
    static const int order[] = {1, 2, 4};
    /* steps of 1/omega: of the last one chapter 8 has the number */
    static const double stable[] = {2, 2, 1.573};
    static struct state now, before, half;
    int method = 0;
    if (argc != 7)
        refuse("usage: P3 BODIES G METHOD DT EVERY ROWS");
    gravity = number(argv[2], "G is no number");
    while (method < 3 && strcmp(argv[3], names[method]) != 0)
        ++method;
    const double dt = number(argv[4], "DT is no number");
    const long every = whole(argv[5], 1, "EVERY is no number above 0");
    const long rows = whole(argv[6], 0, "ROWS is no number, or below 0");
    if (method == 3)
        refuse("METHOD is none of euler, leapfrog, fourth");
    if (gravity < 0 || !(dt > 0))
        refuse("G is below 0, or DT not above");
    read_bodies(argv[1], &now);
    see_that_they_are_apart(&now);
    half = now;
    if (springs > 0) {
        const double limit = stable[method] / sqrt(fastest(&now));
        printf("# limit %.17g\n", limit);
        if (dt > limit) {
            fflush(stdout);
            fprintf(stderr, "P3: DT must be below %g\n", limit);
            return 1;
        }
    }
    print_row(&now, 0);
    for (long k = 1; k <= rows * every; ++k) {
        before = now;
        step(&now, (enum method)method, dt);
        see_who_meets(&before, &now, (double)(k - 1) * dt, dt);
        if (k % every == 0)
            print_row(&now, (double)k * dt);
    }
    double error = 0;
    for (long k = 0; k < 2 * rows * every; ++k)
        step(&half, (enum method)method, dt / 2);
    for (int i = n; i-- > 0;)
        error = fmax(error, hypot(now.x[2 * i] - half.x[2 * i],
                                  now.x[2 * i + 1] - half.x[2 * i + 1]));
    printf("# error %.17g\n", error / (1 - pow(0.5, order[method])));
    return 0;
}
