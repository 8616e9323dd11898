/* From chapters/05-disks.nw: edit there, then run make tangle. */
/* checksum 2255702593 of the lines below */
/* Simulates four hard disks in a box and prints positions every TC. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static inline double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double disks_wall_time(double x, double v, double radius, double length)
{
    const double way = v > 0 ? length - radius - x : radius - x;
    if (v == 0)
        return INFINITY;
    return way / v > 0 ? way / v : 0;
}

double disks_pair_time(const double separation[], const double closing[],
                       double distance)
{
    const double b = dot(separation, closing);
    const double c = dot(separation, separation) - distance * distance;
    const double disc = b * b - dot(closing, closing) * c;
    if (b >= 0 || disc < 0)
        return INFINITY;
    return c <= 0 ? 0 : c / (sqrt(disc) - b);
}

enum { N = 4 };
static const double r = 0.15, L = 1; /* m */
static double x[N][3] = {{.25, .25}, {.75, .25}, {.25, .75}, {.75, .75}};
static double v[N][3] = {{.6, .8}, {-.8, .6}, {.28, -.96}, {-.96, -.28}};

/* Computes position (in m) and velocity (in m/s) of disk j relative to disk
   i. */
static void between(int i, int j, double separation[], double closing[])
{
    for (int k = 0; k < 3; ++k) {
        separation[k] = x[j][k] - x[i][k];
        closing[k] = v[j][k] - v[i][k];
    }
}

/* After `wait` (in s) disk i hits disk j or a wall normal to axis j - N. */
struct event {
    double wait;
    int i, j;
};

static struct event next_event(void)
{
    struct event first = {INFINITY, 0, N};
    for (int i = 0; i < N; ++i)
        for (int j = i + 1; j < N + 2; ++j) {
            double separation[3], closing[3], wait;
            if (j < N) {
                between(i, j, separation, closing);
                wait = disks_pair_time(separation, closing, 2 * r);
            } else
                wait = disks_wall_time(x[i][j - N], v[i][j - N], r, L);
            if (wait < first.wait)
                first = (struct event){wait, i, j};
        }
    return first;
}

static void let_happen(struct event e)
{
    double n[3], closing[3];
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < 2; ++k)
            x[i][k] += v[i][k] * e.wait;
    if (e.j >= N) {
        v[e.i][e.j - N] *= -1;
        return;
    }
    between(e.i, e.j, n, closing);
    for (int k = 0; k < 2; ++k) {
        const double part = dot(closing, n) / dot(n, n) * n[k];
        v[e.i][k] += part;
        v[e.j][k] -= part;
    }
}

int main(int argc, char *argv[])
{
    const double tc = argc > 1 ? atof(argv[1]) : 0.25;
    const long rows = argc > 2 ? atol(argv[2]) : 8;
    struct event e = next_event();
    double now = 0; /* time of x and v, s */
    for (long k = 0; k <= rows; ++k) {
        for (; now + e.wait <= k * tc; e = next_event()) {
            now += e.wait;
            let_happen(e);
        }
        printf("%5.2f", k * tc);
        for (int i = 0; i < 2 * N; ++i)
            printf(" %8.5f",
                   x[i / 2][i % 2] + v[i / 2][i % 2] * (k * tc - now));
        puts("");
    }
}
