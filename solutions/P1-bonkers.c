/* Project P1. Bonkers, upright (after David MacKay)

   P1 BEADS LENGTH G TC ROWS: beads on a wire between two stops, from event
   to event; rows at k TC. It watches every collision, and ends with 1 when
   one is none. */

#include "collide.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, BLOCKS = 100 };

static int n;
static double m[MOST], x[MOST], v[MOST];
static double length, g, tick, now;
static long rows, collisions, bounces;

static void refuse(const char *why)
{
    fprintf(stderr, "P1: %s\n", why);
    exit(2);
}

static void broken(const char *law)
{
    fflush(stdout);
    fprintf(stderr, "P1: collision %ld at %g s: %s\n", collisions, now,
            law);
    exit(1);
}

static double number(const char *text, const char *what)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || isnan(value))
        refuse(what);
    return value;
}

static void read_beads(const char *name)
{
    FILE *file = fopen(name, "r");
    char line[1024], rest[2];
    if (file == NULL)
        refuse("BEADS: there is no such file");
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "#")] = '\0';
        if (line[strspn(line, " \t\r\n")] == '\0')
            continue;
        if (n == MOST)
            refuse("BEADS: more than 64 beads");
        if (sscanf(line, "%lf %lf %lf %1s", &m[n], &x[n], &v[n], rest) != 3)
            refuse("BEADS: a line that is not three numbers");
        if (!(m[n] > 0) || !isfinite(m[n]) || !isfinite(v[n]))
            refuse("BEADS: a mass must be above 0");
        if (!(x[n] >= (n > 0 ? x[n - 1] : 0) && x[n] <= length) ||
            isinf(x[n]))
            refuse("BEADS: a place outside, or out of order");
        ++n;
    }
    fclose(file);
    if (n == 0)
        refuse("BEADS: no bead");
}

/* When this bead is next at a stop, if nobody is in its way. */
static double stop_time(int i)
{
    double down = INFINITY, up = INFINITY;
    if (i == 0 && g > 0) {
        const double landing = sqrt(v[i] * v[i] + 2 * g * x[i]);
        if (v[i] > 0)
            down = (v[i] + landing) / g;
        else if (landing > 0)
            down = 2 * x[i] / (landing - v[i]);
    } else if (i == 0 && v[i] < 0) {
        down = x[i] / -v[i];
    }
    if (i == n - 1 && isfinite(length) && v[i] > 0) {
        const double room = length - x[i],
                     left = v[i] * v[i] - 2 * g * room;
        if (left >= 0)
            up = 2 * room / (v[i] + sqrt(left));
    }
    return fmin(down, up);
}

static double pair_time(int i)
{
    const double gap = x[i + 1] - x[i], closing = v[i] - v[i + 1];
    if (closing <= 0)
        return INFINITY;
    return fmax(gap, 0) / closing;
}

static void fly(double t)
{
    for (int i = 0; i < n; ++i) {
        x[i] += (v[i] - g * t / 2) * t;
        v[i] -= g * t;
    }
}

static void meet(int i)
{
    const double p = m[i] * v[i] + m[i + 1] * v[i + 1];
    const double e = m[i] * v[i] * v[i] + m[i + 1] * v[i + 1] * v[i + 1];
    const double size = m[i] * fabs(v[i]) + m[i + 1] * fabs(v[i + 1]);
    const double closing = v[i] - v[i + 1];
    const double speeds = fabs(v[i]) + fabs(v[i + 1]);
    x[i] = x[i + 1] = (x[i] + x[i + 1]) / 2;
    ++collisions;
    collide(m[i], m[i + 1], &v[i], &v[i + 1]);
    if (!(fabs(m[i] * v[i] + m[i + 1] * v[i + 1] - p) <= 1e-10 * size))
        broken("the momentum has changed");
    if (!(fabs(m[i] * v[i] * v[i] + m[i + 1] * v[i + 1] * v[i + 1] - e) <=
          1e-10 * e))
        broken("the energy has changed");
    if (!(fabs(v[i] - v[i + 1] + closing) <= 1e-9 * speeds))
        broken("the relative velocity is not reversed");
}

static void turn(int i)
{
    ++bounces;
    x[i] = v[i] < 0 ? 0 : length;
    v[i] = -v[i];
}

static void go_to(double end)
{
    for (;;) {
        double wait = INFINITY;
        int pair = 0, who = -1;
        for (int i = 0; i < n; ++i) {
            const double t = i == 0 || i == n - 1 ? stop_time(i) : INFINITY;
            if (t < wait)
                wait = t, who = i, pair = 0;
            if (i + 1 < n && pair_time(i) < wait)
                wait = pair_time(i), who = i, pair = 1;
        }
        if (who < 0 || now + wait > end)
            break;
        fly(wait);
        now += wait;
        if (pair)
            meet(who);
        else
            turn(who);
    }
    fly(end - now);
    now = end;
}

static double energy(void)
{
    double sum = 0;
    for (int i = n; i-- > 0;)
        sum += m[i] * (v[i] * v[i] / 2 + g * x[i]);
    return sum;
}

/* What the theory of chapter 3 asks for: mean squares, in blocks. */
static double squares[2][BLOCKS];
static long counted[BLOCKS];
static int light, heavy;

static void count(long row)
{
    const int block = (int)(BLOCKS * (row - 1) / rows);
    squares[0][block] += v[light] * v[light];
    squares[1][block] += v[heavy] * v[heavy];
    ++counted[block];
}

static void report(double total)
{
    double mean[2] = {0, 0}, spread[3] = {0, 0, 0}, rms[2];
    const double part = isinf(length) ? 2.0 / 3.0 : 2.0;
    const double share = (g > 0) == isinf(length) ? total / n * part : NAN;
    const double a = sqrt(share / m[light]), b = sqrt(share / m[heavy]);
    for (int block = BLOCKS; block-- > 0;) {
        mean[0] += squares[0][block] / (double)rows;
        mean[1] += squares[1][block] / (double)rows;
    }
    for (int i = 0; i < BLOCKS; ++i) {
        double off[2];
        for (int k = 1; k >= 0; --k) {
            off[k] = squares[k][i] / (double)counted[i] / mean[k] - 1;
            spread[k] += off[k] * off[k];
        }
        spread[2] += (off[0] - off[1]) * (off[0] - off[1]);
    }
    for (int k = 0; k < 3; ++k)
        spread[k] = sqrt(spread[k] / BLOCKS / (BLOCKS - 1)) / 2;
    rms[0] = sqrt(mean[0]);
    rms[1] = sqrt(mean[1]);
    printf("# lightest %.17g %.17g", rms[0], rms[0] * spread[0]);
    printf(" %.17g\n# heaviest %.17g %.17g", a, rms[1], rms[1] * spread[1]);
    printf(" %.17g\n# ratio %.17g", b, rms[0] / rms[1]);
    printf(" %.17g %.17g\n", rms[0] / rms[1] * spread[2], a / b);
}

static void print_row(double t)
{
    printf("%.17g %.17g", t, energy());
    for (int i = 0; i < n; ++i)
        printf(" %.17g %.17g", x[i], v[i]);
    putchar('\n');
}

int main(int argc, char **argv)
{
    char *end;
    if (argc != 6)
        refuse("usage: P1 BEADS LENGTH G TC ROWS");
    length = number(argv[2], "LENGTH is no number");
    g = number(argv[3], "G is no number");
    tick = number(argv[4], "TC is no number");
    rows = strtol(argv[5], &end, 10);
    if (!(length > 0) || !(g >= 0) || isinf(g) || !(tick > 0) ||
        isinf(tick) || end == argv[5] || *end || rows < 0)
        refuse("LENGTH and TC must be above 0, G and ROWS not below");
    read_beads(argv[1]);
    for (int i = 1; i < n; ++i) {
        light = m[i] < m[light] ? i : light;
        heavy = m[i] > m[heavy] ? i : heavy;
    }
    const double total = energy();
    print_row(0);
    for (long k = 1; k <= rows; ++k) {
        go_to((double)k * tick);
        print_row((double)k * tick);
        if (rows >= 1000)
            count(k);
    }
    printf("# collisions %ld\n# bounces %ld\n", collisions, bounces);
    if (rows >= 1000)
        report(total);
    return 0;
}
