/* Project P2. Disks

   P2 fly, watch, throw or pair: disks that fly from event to event, all
   times found afresh after each; and disks that are thrown until they fit.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 16, SLICES = 14, RINGS = 10, BLOCKS = 100 };

static double radius;
static long looks; /* how often two disks were looked at */

static void refuse(const char *why)
{
    fprintf(stderr, "P2: %s\n", why);
    exit(2);
}

static double number(const char *text, double least, double most,
                     const char *why)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !(value >= least && value <= most))
        refuse(why);
    return value;
}

static long whole(const char *text, double least, const char *why)
{
    const double value = number(text, least, 1e9, why);
    if (value != floor(value))
        refuse(why);
    return (long)value;
}

/* ---- disks that fly ---- */

struct disk {
    double p[2], v[2];
};
static struct disk disk[MOST];
static int disks;
static double now;
static long pairs, walls;

static void read_disks(const char *name)
{
    char line[1000], more;
    FILE *file = fopen(name, "r");
    if (!file)
        refuse("DISKS: there is no such file");
    while (fgets(line, sizeof line, file)) {
        struct disk d;
        line[strcspn(line, "#")] = '\0';
        if (line[strspn(line, " \t\r\n")] == '\0')
            continue;
        if (disks == MOST || sscanf(line, "%lf %lf %lf %lf %c", d.p,
                                    d.p + 1, d.v, d.v + 1, &more) != 4)
            refuse("DISKS: a line that is not four numbers");
        if (!isfinite(d.v[0]) || !isfinite(d.v[1]))
            refuse("DISKS: a velocity that is not finite");
        for (int c = 0; c < 2; ++c)
            if (!(d.p[c] >= radius && d.p[c] <= 1 - radius))
                refuse("DISKS: a disk that is not inside");
        for (int i = 0; i < disks; ++i)
            if (hypot(d.p[0] - disk[i].p[0], d.p[1] - disk[i].p[1]) <
                2 * radius)
                refuse("DISKS: two that overlap");
        disk[disks++] = d;
    }
    fclose(file);
    if (disks == 0)
        refuse("DISKS: no disk");
}

static double to_wall(double place, double speed)
{
    if (speed > 0)
        return (1 - radius - place) / speed;
    return speed < 0 ? (place - radius) / -speed : INFINITY;
}

/* In the frame of one, the other flies along a line: how far is it to the
   point nearest to the first, and how far does that miss it? */
static double to_meet(const struct disk *one, const struct disk *other)
{
    const double dx = one->p[0] - other->p[0];
    const double dy = one->p[1] - other->p[1];
    const double ux = other->v[0] - one->v[0];
    const double uy = other->v[1] - one->v[1];
    const double speed = hypot(ux, uy);
    const double along = (ux * dx + uy * dy) / speed;
    const double beside = (uy * dx - ux * dy) / speed;
    const double inside = 4 * radius * radius - beside * beside;
    ++looks;
    if (!(along > 0) || inside < 0)
        return INFINITY;
    return fmax(along - sqrt(inside), 0) / speed;
}

static void fly(double time)
{
    for (struct disk *d = disk; d < disk + disks; ++d) {
        d->p[0] += time * d->v[0];
        d->p[1] += time * d->v[1];
    }
}

static void collide(struct disk *one, struct disk *other)
{
    const double dx = other->p[0] - one->p[0];
    const double dy = other->p[1] - one->p[1], d = hypot(dx, dy);
    const double speed =
        ((other->v[0] - one->v[0]) * dx + (other->v[1] - one->v[1]) * dy) /
        d;
    one->v[0] += speed * dx / d;
    one->v[1] += speed * dy / d;
    other->v[0] -= speed * dx / d;
    other->v[1] -= speed * dy / d;
}

/* Lets all that comes before the end happen, and flies on to there. */
static void go_on(double end)
{
    for (;;) {
        struct disk *first = NULL, *second = NULL;
        double wait = end - now, *turned = NULL;
        for (struct disk *d = disk + disks; d-- > disk;) {
            for (struct disk *e = disk; e < d; ++e) {
                const double t = to_meet(d, e);
                if (wait > t) {
                    first = d;
                    second = e;
                    wait = t;
                }
            }
            for (int c = 2; c-- > 0;) {
                const double left = to_wall(d->p[c], d->v[c]);
                if (wait > left) {
                    first = NULL;
                    turned = d->v + c;
                    wait = left;
                }
            }
        }
        fly(wait);
        now += wait;
        if (first) {
            collide(first, second);
            ++pairs;
        } else if (turned) {
            *turned = -*turned;
            ++walls;
        } else {
            break;
        }
    }
    now = end;
}

static void print_rows(double tc, long rows)
{
    for (long k = 0; k <= rows; ++k) {
        go_on((double)k * tc);
        printf("%.17g", (double)k * tc);
        for (int i = 0; i < disks; ++i)
            printf(" %.17g %.17g %.17g %.17g", disk[i].p[0], disk[i].p[1],
                   disk[i].v[0], disk[i].v[1]);
        putchar('\n');
    }
    printf("# pairs %ld\n# walls %ld\n", pairs, walls);
}

/* ---- what is counted, and how sure it is ---- */

/* Sums over units that know nothing of each other: of the places in each
   slice, of their squares; of those at the walls and in the middle. */
static double sum[SLICES], squares[SLICES], at_wall, in_middle, ww, wm, mm;
static long units;

static void add_unit(const double in[])
{
    const double w = in[0] + in[SLICES - 1];
    const double m = in[SLICES / 2 - 1] + in[SLICES / 2];
    for (int i = SLICES; i-- > 0;) {
        sum[i] += in[i];
        squares[i] += in[i] * in[i];
    }
    at_wall += w;
    in_middle += m;
    ww += pow(w, 2);
    wm += w * m;
    mm += pow(m, 2);
    ++units;
}

static void count_place(double in[], double place)
{
    const int i = (int)((place - radius) / (1 - 2 * radius) * SLICES);
    ++in[i < 0 ? 0 : i < SLICES ? i : SLICES - 1];
}

static void print_histogram(double places)
{
    const double width = (1 - 2 * radius) / SLICES;
    const double n = (double)units, q = at_wall / in_middle;
    for (int i = 0; i < SLICES; ++i)
        printf("%.17g %.17g %.17g\n", radius + (i + 0.5) * width,
               sum[i] / places / width,
               sqrt((squares[i] - sum[i] * sum[i] / n) * n / (n - 1)) /
                   places / width);
    const double error =
        sqrt((ww - 2 * q * wm + q * q * mm) * n / (n - 1)) / in_middle;
    printf("# ratio %.17g %.17g\n# looks %ld\n", q, error, looks);
    printf("# price %.17g\n", (double)looks * pow(100 * error / q, 2));
}

static void watch(double tc, long rows)
{
    double block[SLICES] = {0};
    const long each = rows / BLOCKS;
    for (long k = 1; k <= each * BLOCKS; ++k) {
        go_on((double)k * tc);
        for (int i = 2 * disks; i-- > 0;)
            count_place(block, disk[i / 2].p[i % 2]);
        if (k % each == 0) {
            add_unit(block);
            memset(block, 0, sizeof block);
        }
    }
    print_histogram((double)(each * BLOCKS) * 2 * disks);
}

/* ---- disks that are thrown ---- */

static uint64_t bits;

/* Marsaglia's xorshift, its high half after a multiplication. */
static double uniform(void)
{
    bits ^= bits >> 12;
    bits ^= bits << 25;
    bits ^= bits >> 27;
    return (double)((bits * 2685821657736338717u) >> 11) / 9007199254740992;
}

static void begin_with(long seed)
{
    bits = 88172645463325252u ^ ((uint64_t)seed * 2862933555777941757u);
    for (int i = 0; i < 20; ++i)
        uniform();
}

static int all_fit(int n, double x[], double y[])
{
    int i = 0;
    while (i < n) {
        x[i] = radius + uniform() * (1 - 2 * radius);
        y[i] = radius + uniform() * (1 - 2 * radius);
        for (int j = 0; j < i; ++j) {
            ++looks;
            if (hypot(x[i] - x[j], y[i] - y[j]) < 2 * radius)
                return 0;
        }
        ++i;
    }
    return 1;
}

static void throw_disks(int n, long samples)
{
    double x[MOST], y[MOST];
    long thrown = 0;
    while (units < samples) {
        double in[SLICES] = {0};
        do
            ++thrown;
        while (!all_fit(n, x, y));
        for (int i = n; i-- > 0;) {
            count_place(in, x[i]);
            count_place(in, y[i]);
        }
        add_unit(in);
    }
    print_histogram(2.0 * n * (double)samples);
    printf("# thrown %ld\n", thrown);
}

/* ---- two big ones among small ones ---- */

static double law(double s, int n, double reach)
{
    const double half = s / 2;
    double overlap = 0;
    if (half < reach)
        overlap = 2 * (reach * reach * acos(half / reach) -
                       half * sqrt(reach * reach - half * half));
    return s * pow(1 - 2 * acos(-1) * reach * reach + overlap, (double)n);
}

static double integral(double low, double high, int n, double reach)
{
    enum { PARTS = 2000 };
    double all = 0;
    for (int i = 0; i < PARTS; ++i)
        all += law(low + (i + 0.5) * (high - low) / PARTS, n, reach);
    return all * (high - low) / PARTS;
}

static double nearest_image(double way)
{
    return way - floor(way + 0.5);
}

static void throw_pairs(int n, double small, long samples)
{
    const double reach = radius + small, least = 2 * radius;
    const double width = (0.5 - least) / RINGS;
    const double whole_law = integral(least, 0.5, n, reach);
    long in[RINGS] = {0};
    for (long kept = 0; kept < samples;) {
        const double x = uniform() - 0.5, y = uniform() - 0.5;
        const double s = hypot(x, y);
        int k = 0;
        if (s < least || s > 0.5)
            continue;
        for (; k < n; ++k) {
            const double a = uniform() - 0.5, b = uniform() - 0.5;
            if (hypot(a, b) < reach ||
                hypot(nearest_image(a - x), nearest_image(b - y)) < reach)
                break;
        }
        if (k < n)
            continue;
        k = (int)((s - least) / width);
        ++in[k < RINGS ? k : RINGS - 1];
        ++kept;
    }
    for (int i = 0; i < RINGS; ++i) {
        const double share = (double)in[i] / (double)samples;
        const double low = least + i * width;
        printf("%.17g %.17g %.17g %.17g %.17g\n", low, low + width,
               share / width,
               sqrt(share * (1 - share) / (double)samples) / width,
               integral(low, low + width, n, reach) / width / whole_law);
    }
}

int main(int argc, char *argv[])
{
    const char *what = argc > 1 ? argv[1] : "";
    const int moves = !strcmp(what, "fly") || !strcmp(what, "watch");
    if (!(argc == 6 && (moves || !strcmp(what, "throw"))) &&
        !(argc == 7 && !strcmp(what, "pair")))
        refuse("fly, watch, throw or pair, and four or five words");
    radius = number(argv[3], 1e-9, 0.2499999999, "RADIUS: 0 to 1/4");
    if (moves) {
        const double tc = number(argv[4], 1e-300, 1e300, "TC: above 0");
        const long rows = whole(argv[5], 0, "ROWS: a whole number");
        read_disks(argv[2]);
        if (what[0] == 'f')
            print_rows(tc, rows);
        else if (rows < 1000)
            refuse("ROWS: 1000 to watch");
        else
            watch(tc, rows);
        return 0;
    }
    const int n =
        (int)whole(argv[2], what[0] == 'p' ? 0 : 1, "N: a whole number");
    begin_with(whole(argv[argc - 2], 0, "SEED: a whole number"));
    const long samples = whole(argv[argc - 1], 2, "SAMPLES: 2 at least");
    if (what[0] == 't' && n > MOST)
        refuse("N: 16 at most");
    if (what[0] == 't')
        throw_disks(n, samples);
    else {
        const double small = number(argv[4], 0, 0.25, "SMALL: 0 or more");
        if (radius + small > 0.25)
            refuse("SMALL: with RADIUS 1/4 at most");
        throw_pairs(n, small, samples);
    }
    return 0;
}
