/* Places are complex numbers; five leapfrogs of order 4 after Suzuki; the
   limit is found by trying: the longest step that one oscillator survives.
 */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct body {
    double m, r;
    double complex z, v, pulled;
};
struct wire {
    int from, to;
    double k, l;
};
static struct body start[64];
static struct wire wires[64];
static int bodies, count;
static double G;

static int bad(const char *text)
{
    fprintf(stderr, "P3: %s\n", text);
    return 2;
}

static int real(const char *s, double *x)
{
    char *end;
    *x = strtod(s, &end);
    return *s && !*end && isfinite(*x);
}

static void feel(struct body b[])
{
    for (int i = 0; i < bodies; ++i)
        b[i].pulled = 0;
    for (struct wire *w = wires + count; w-- > wires;) {
        struct body *p = b + w->from, *q = b + w->to;
        const double complex to = q->z - p->z;
        const double complex f = w->k * (to - w->l * to / cabs(to));
        p->pulled += f / p->m;
        q->pulled -= f / q->m;
    }
    if (G == 0)
        return;
    for (struct body *p = b + bodies; p-- > b;)
        for (struct body *q = b + bodies; q-- > b;)
            if (p != q) {
                const double complex to = q->z - p->z;
                p->pulled +=
                    G * q->m * to / (cabs(to) * cabs(to)) / cabs(to);
            }
}

static void go(struct body b[], double push, double fly)
{
    if (push != 0)
        feel(b);
    for (struct body *p = b + bodies; p-- > b;) {
        p->v += push * p->pulled;
        p->z += fly * p->v;
    }
}

static int parts(char method, double part[])
{
    const double s = 1 / (4 - pow(4, 1.0 / 3));
    if (method != 'f') {
        part[0] = 1;
        return 1;
    }
    for (int i = 0; i < 5; ++i)
        part[i] = i == 2 ? 1 - 4 * s : s;
    return 5;
}

static void advance(struct body b[], char method, double h)
{
    double part[5];
    const int all = parts(method, part);
    for (int i = all; i-- > 0;)
        if (method == 'e') {
            go(b, h, h);
        } else {
            go(b, part[i] * h / 2, part[i] * h);
            go(b, part[i] * h / 2, 0);
        }
}

/* Whether an oscillator of one radian a second is stable: the trace of the
   matrix of a step. */
static int survives(char method, double h)
{
    double part[5], column[2][2];
    const int all = parts(method, part);
    for (int c = 2; c-- > 0;) {
        double x = c == 0, v = c == 1;
        for (int i = all; i-- > 0;) {
            const double t = h * part[i];
            v -= x * (method == 'e' ? t : t / 2);
            x += v * t;
            v -= method == 'e' ? 0 : x * t / 2;
        }
        column[c][0] = x;
        column[c][1] = v;
    }
    return fabs(column[0][0] + column[1][1]) < 2;
}

static double longest(char method)
{
    double h = 0;
    while (survives(method, h + 1e-3))
        h += 1e-3;
    return h;
}

/* No vibration is faster than twice the sum of K/m at one body. */
static double bound(void)
{
    double most = 0;
    for (int i = bodies; i-- > 0;) {
        double sum = 0;
        for (int k = count; k-- > 0;)
            if (wires[k].from == i || wires[k].to == i)
                sum += 2 * wires[k].k / start[i].m;
        most = fmax(most, sum);
    }
    return sqrt(most);
}

static double first_touch(struct body a[], struct body b[], int who[])
{
    double first = 2;
    for (int j = bodies; j-- > 1;)
        for (int i = j; i-- > 0;) {
            const double s = a[i].r + a[j].r;
            const double complex d = a[j].z - a[i].z;
            const double complex w = b[j].z - b[i].z - d;
            const double speed = cabs(w);
            if (s == 0 || speed == 0)
                continue;
            const double along = -creal(d * conj(w)) / speed;
            const double beside = fabs(cimag(d * conj(w))) / speed;
            if (along <= 0 || beside > s)
                continue;
            const double part =
                (along - sqrt(s * s - beside * beside)) / speed;
            if (part < first) {
                first = part;
                who[0] = i + 1;
                who[1] = j + 1;
            }
        }
    return first;
}

static double total(struct body b[])
{
    double e = 0;
    for (int i = bodies; i-- > 0;) {
        e += b[i].m * creal(b[i].v * conj(b[i].v)) / 2;
        for (int j = i + 1; G > 0 && j < bodies; ++j)
            e -= G * b[i].m * b[j].m / cabs(b[i].z - b[j].z);
    }
    for (int k = count; k-- > 0;)
        e += wires[k].k / 2 *
             pow(cabs(b[wires[k].from].z - b[wires[k].to].z) - wires[k].l,
                 2);
    return e;
}

static void show(struct body b[], double t)
{
    printf("%.17g %.17g", t, total(b));
    for (struct body *p = b, *end = b + bodies; p < end; ++p)
        printf(" %.17g %.17g %.17g %.17g", creal(p->z), cimag(p->z),
               creal(p->v), cimag(p->v));
    puts("");
}

static int read_file(const char *name)
{
    char line[2000];
    FILE *f;
    if (!(f = fopen(name, "r")))
        return bad("no file");
    while (fgets(line, sizeof line, f)) {
        double x[7];
        char *at = line, *end;
        int got = 0;
        line[strcspn(line, "#\r\n")] = 0;
        at += strspn(at, " \t");
        const int is_spring = !strncmp(at, "spring", 6);
        at += 6 * is_spring;
        while (got < 7 && (x[got] = strtod(at, &end), end != at)) {
            at = end;
            if (!isfinite(x[got++]))
                return bad("not finite");
        }
        if (at[strspn(at, " \t")])
            return bad("a line that is not all numbers");
        if (is_spring) {
            struct wire w = {(int)x[0] - 1, (int)x[1] - 1, x[2], x[3]};
            if (got != 4 || w.k <= 0 || w.l < 0 || w.from == w.to ||
                count == 64)
                return bad("no spring");
            wires[count++] = w;
        } else if (got) {
            if (got != 6 || x[0] <= 0 || x[1] < 0 || bodies == 64)
                return bad("no body");
            start[bodies++] = (struct body){x[0], x[1], x[2] + I * x[3],
                                            x[4] + I * x[5], 0};
        }
    }
    fclose(f);
    for (int k = count; k-- > 0;)
        if (wires[k].from < 0 || wires[k].from >= bodies ||
            wires[k].to < 0 || wires[k].to >= bodies)
            return bad("a spring in the air");
    for (int i = bodies; i-- > 1;)
        for (int j = i; j-- > 0;)
            if (cabs(start[i].z - start[j].z) <= start[i].r + start[j].r)
                return bad("two in one place");
    return bodies ? 0 : bad("nothing there");
}

int main(int argc, char **argv)
{
    double h, every, rows;
    if (argc != 7 || !real(argv[2], &G) || !real(argv[4], &h) ||
        !real(argv[5], &every) || !real(argv[6], &rows) || G < 0 ||
        h <= 0 || every < 1 || rows < 0 || every != rint(every) ||
        rows != rint(rows))
        return bad("P3 BODIES G METHOD DT EVERY ROWS");
    if (strcmp(argv[3], "euler") && strcmp(argv[3], "leapfrog") &&
        strcmp(argv[3], "fourth"))
        return bad("METHOD");
    const char method = argv[3][0];
    if (read_file(argv[1]))
        return 2;
    static struct body now[64], old[64], fine[64];
    int status = 0;
    memcpy(now, start, sizeof start);
    memcpy(fine, start, sizeof start);
    const double limit = count ? longest(method) / bound() : HUGE_VAL;
    const long steps = (long)(every * rows);
    if (h > limit) {
        fprintf(stderr, "P3: %g is too long a step for these springs\n", h);
        status = 1;
    }
    for (long k = 0; !status && k <= steps; ++k) {
        int who[2];
        if (k % (long)every == 0)
            show(now, k * h);
        if (k == steps)
            break;
        memcpy(old, now, sizeof start);
        advance(now, method, h);
        const double part = first_touch(old, now, who);
        if (part <= 1) {
            printf("# meet %d %d %.15g\n", who[0], who[1], (k + part) * h);
            status = bad("two meet") - 1;
        }
        advance(fine, method, h / 2);
        advance(fine, method, h / 2);
    }
    double error = 0;
    for (int i = bodies; i-- > 0;)
        error = fmax(cabs(fine[i].z - now[i].z), error);
    if (!status)
        printf("# error %g\n",
               method == 'e'
                   ? 2 * error
                   : error * (method == 'l' ? 4 / 3.0 : 16 / 15.0));
    if (count)
        printf("# limit %.10g\n", limit);
    return status;
}
