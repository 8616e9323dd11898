/* Every bead keeps the moment of its own last event; the next ones stand in
   a list, and only those of the beads concerned are computed again. */
#include "collide.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bead {
    double mass, since, place, velocity;
};

static struct bead bead[66]; /* 1 to count */
static double due[66];       /* of what happens between i and i + 1 */
static int count;
static double wire, gravity;
static long meetings[2];

static double where(const struct bead *b, double t)
{
    const double age = t - b->since;
    return b->place + b->velocity * age - 0.5 * gravity * age * age;
}

static double speed(const struct bead *b, double t)
{
    return b->velocity - gravity * (t - b->since);
}

static int root(double b, double c, double *low, double *high)
{
    /* of g/2 t t - b t - c = 0 */
    const double under = b * b + 2 * gravity * c;
    if (under < 0)
        return 0;
    const double q = b + (b < 0 ? -1 : 1) * sqrt(under);
    *low = q != 0 ? -2 * c / q : 0;
    *high = q / gravity;
    if (*low > *high) {
        const double swap = *low;
        *low = *high;
        *high = swap;
    }
    return 1;
}

static double foresee(int i, double t)
{
    double low, high;
    if (i == 0) {
        const double x = where(&bead[1], t), v = speed(&bead[1], t);
        if (gravity == 0)
            return v < 0 ? t + x / -v : HUGE_VAL;
        return root(v, x > 0 ? x : 0, &low, &high) && high > 0 ? t + high
                                                               : HUGE_VAL;
    }
    if (i == count) {
        const double x = where(&bead[i], t), v = speed(&bead[i], t);
        if (v <= 0 || wire == HUGE_VAL)
            return HUGE_VAL;
        if (gravity == 0)
            return t + (wire - x) / v;
        return root(v, x - wire, &low, &high) && low > 0 ? t + low
                                                         : HUGE_VAL;
    }
    const double nearing = speed(&bead[i], t) - speed(&bead[i + 1], t);
    const double apart = where(&bead[i + 1], t) - where(&bead[i], t);
    return nearing > 0 ? t + (apart > 0 ? apart / nearing : 0) : HUGE_VAL;
}

static void settle(int i, double t)
{
    bead[i].place = where(&bead[i], t);
    bead[i].velocity = speed(&bead[i], t);
    bead[i].since = t;
}

static int differ(double a, double b, double size)
{
    return !(fabs(a - b) <= 1e-9 * size);
}

static void act(int i, double t)
{
    if (i > 0)
        settle(i, t);
    if (i < count)
        settle(i + 1, t);
    ++meetings[i == 0 || i == count];
    if (i == 0 || i == count) {
        struct bead *b = i == 0 ? &bead[1] : &bead[count];
        b->place = i == 0 ? 0 : wire;
        b->velocity *= -1;
    } else {
        struct bead *a = &bead[i], *b = a + 1;
        const double u = a->velocity, w = b->velocity;
        const double M = a->mass + b->mass,
                     cm = (a->mass * u + b->mass * w) / M;
        collide(a->mass, b->mass, &a->velocity, &b->velocity);
        const double wanted = u - w, got = b->velocity - a->velocity;
        const double now =
            (a->mass * a->velocity + b->mass * b->velocity) / M;
        if (differ(now, cm, fabs(u) + fabs(w)) ||
            differ(wanted, got, fabs(u) + fabs(w))) {
            fflush(stdout);
            fputs("P1: that was no elastic collision\n", stderr);
            exit(1);
        }
        b->place = a->place;
    }
    for (int k = i - 1; k <= i + 1; ++k)
        if (k >= 0 && k <= count)
            due[k] = foresee(k, t);
}

static double total(double t)
{
    double kinetic = 0, potential = 0;
    for (int i = 1; i <= count; ++i) {
        kinetic += bead[i].mass * pow(speed(&bead[i], t), 2);
        potential += bead[i].mass * gravity * where(&bead[i], t);
    }
    return kinetic / 2 + potential;
}

static int complain(const char *text)
{
    fprintf(stderr, "P1: %s\n", text);
    return 2;
}

static int number(const char *s, double *x)
{
    char *end;
    *x = strtod(s, &end);
    return *s && !*end && *x == *x;
}

/* The autocorrelation summed up to where it is lost in the noise. */
static double uncertainty(const double *a, long n)
{
    double mean = 0, sum = 0, c0 = 0;
    for (long i = n; i-- > 0;)
        mean += a[i] / n;
    for (long i = n; i-- > 0;)
        c0 += pow(a[i] - mean, 2) / n;
    for (long lag = 1; lag < n / 20 && lag < 6 * (1 + 2 * sum); ++lag) {
        double c = 0;
        for (long i = n - lag; i-- > 0;)
            c += (a[i + lag] - mean) * (a[i] - mean) / (n - lag);
        sum += c / c0;
    }
    return sqrt(c0 * (1 + 2 * sum) / n);
}

int main(int argc, char **argv)
{
    double tick, wanted;
    char text[999], *cut;
    FILE *f;
    if (argc != 6 || !number(argv[2], &wire) ||
        !number(argv[3], &gravity) || !number(argv[4], &tick) ||
        !number(argv[5], &wanted))
        return complain("P1 BEADS LENGTH G TC ROWS, and all but the first "
                        "are numbers");
    if (wire <= 0 || gravity < 0 || tick <= 0 || wanted < 0 ||
        wanted != floor(wanted))
        return complain("LENGTH or TC is not above 0, or G or ROWS below");
    if (!(f = fopen(argv[1], "r")))
        return complain("no such file");
    for (double lowest = 0; fgets(text, sizeof text, f);) {
        struct bead b = {0};
        char more;
        if ((cut = strchr(text, '#')))
            *cut = 0;
        const int got = sscanf(text, "%lf %lf %lf %c", &b.mass, &b.place,
                               &b.velocity, &more);
        if (got == EOF)
            continue;
        if (got != 3 || !(b.mass > 0) ||
            !(b.mass * fabs(b.velocity) < HUGE_VAL))
            return complain("three numbers a bead, the first above 0");
        if (b.place < lowest || b.place > wire || b.place == HUGE_VAL ||
            count == 64)
            return complain("beads out of place");
        lowest = b.place;
        bead[++count] = b;
    }
    if (count == 0)
        return complain("nobody there");
    for (int i = 0; i <= count; ++i)
        due[i] = foresee(i, 0);
    const long rows = (long)wanted;
    int few = 1, most = 1;
    double *series[3];
    for (int i = 1; i <= count; ++i) {
        if (bead[i].mass < bead[few].mass)
            few = i;
        if (bead[i].mass > bead[most].mass)
            most = i;
    }
    for (int k = 0; k < 3; ++k)
        series[k] = malloc((rows + 1) * sizeof(double));
    double all = total(0);
    for (long k = 0; k <= rows; ++k) {
        const double t = k * tick;
        for (;;) {
            int first = count;
            for (int i = count; i-- > 0;)
                if (due[i] <= due[first])
                    first = i;
            if (!(due[first] <= t))
                break;
            act(first, due[first]);
        }
        printf("%.17g %.17g", t, total(t));
        for (int i = 1; i < count + 1; ++i)
            printf(" %.17g %.17g", where(&bead[i], t), speed(&bead[i], t));
        puts("");
        if (k > 0) {
            series[0][k - 1] = pow(speed(&bead[few], t), 2);
            series[1][k - 1] = pow(speed(&bead[most], t), 2);
        }
    }
    printf("# collisions %ld\n# bounces %ld\n", meetings[0], meetings[1]);
    if (rows < 1000)
        return 0;
    double mean[2] = {0, 0}, theory[2];
    for (int k = 0; k < 2; ++k)
        for (long i = 0; i < rows; ++i)
            mean[k] += series[k][i] / rows;
    for (long i = 0; i < rows; ++i)
        series[2][i] = series[0][i] / mean[0] - series[1][i] / mean[1];
    const double squares = gravity > 0 ? 3 * count : count;
    if ((gravity > 0) != (wire == HUGE_VAL))
        all = NAN; /* no theory is asked for */
    theory[0] = sqrt(2 * all / squares / bead[few].mass);
    theory[1] = sqrt(2 * all / squares / bead[most].mass);
    for (int k = 0; k < 2; ++k)
        printf("# %s %.12g %.12g %.12g\n", k ? "heaviest" : "lightest",
               sqrt(mean[k]),
               uncertainty(series[k], rows) / 2 / sqrt(mean[k]), theory[k]);
    const double ratio = sqrt(mean[0] / mean[1]);
    printf("# ratio %.12g %.12g %.12g\n", ratio,
           ratio * uncertainty(series[2], rows) / 2, theory[0] / theory[1]);
    for (int k = 0; k < 3; ++k)
        free(series[k]);
    return 0;
}
