/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 2051662579 of the lines below */
/* Finds the cheaper of two models within a tolerance. */
#include "forces/jacobi.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The Sun, Jupiter and Saturn. Arrays list all x, then all y, then all z.
   Units: solar mass, AU, year. */
enum { N = 3, SIZE = 3 * N, ROWS = 16 };
static const struct bodies {
    double x[SIZE], v[SIZE];
} start = {{0, 5.2, 0, 0, 0, 9.58}, {0, 0, -2.03, 0, 2.755, 0}};
static const double mass[N] = {1, 1 / 1047.0, 1 / 3498.0};
static const double k2 = 39.478417604357434, every = 7.5, scale = 10.9003;

/* The rows of a run, and its cost by the price list, ns. */
struct run {
    struct bodies row[ROWS];
    double cost;
};

static void accelerate(const double x[], double a[])
{
    for (int i = 0; i < N; ++i) {
        a[i] = a[N + i] = a[2 * N + i] = 0;
        for (int j = 0; j < N; ++j) {
            const double dx = x[j] - x[i], dy = x[N + j] - x[N + i];
            const double r2 = dx * dx + dy * dy;
            const double w = i == j ? 0 : k2 * mass[j] / (r2 * sqrt(r2));
            a[i] += w * dx;
            a[N + i] += w * dy;
        }
    }
}

static struct run leapfrog(int steps)
{
    const double h = every / steps;
    struct run r = {.cost = 40 * ROWS};
    struct bodies b = start;
    double a[SIZE];
    accelerate(b.x, a);
    for (int s = 0; s < ROWS * steps; ++s) {
        for (int c = 0; c < SIZE; ++c)
            b.x[c] += h * (b.v[c] += h / 2 * a[c]);
        accelerate(b.x, a);
        for (int c = 0; c < SIZE; ++c)
            b.v[c] += h / 2 * a[c];
        r.row[s / steps] = b; /* the last step of a row is kept */
    }
    r.cost += (ROWS * steps + 1) * (18 + 3 * N + 6.5 * N * (N - 1) / 2);
    return r;
}

static struct run ellipses(void)
{
    struct run r = {.cost = ROWS * (40 + 210 * (N - 1))};
    struct jacobi j;
    if (!jacobi_create(&j, N, mass, k2))
        exit(1);
    for (int k = 0; k < ROWS; ++k) {
        r.row[k] = start;
        jacobi_flow(&j, (k + 1) * every, r.row[k].x, r.row[k].v);
    }
    jacobi_free(&j);
    return r;
}

static double difference(const struct run *a, const struct run *b)
{
    double far = 0;
    for (int k = 0; k < ROWS; ++k)
        for (int c = 0; c < SIZE; ++c)
            far = fmax(far, fabs(a->row[k].x[c] - b->row[k].x[c]) / scale);
    return far;
}

int main(int argc, char *argv[])
{
    const double e = argc == 2 ? atof(argv[1]) : 0;
    struct run r, last, fine = leapfrog(16);
    double doubt = 1, best = INFINITY;
    if (!(e >= 1e-6 && e < 1))
        return fputs("bonk0: expected a tolerance, 1e-6 to 1\n", stderr), 2;
    for (int n = 33; doubt > e / 20; n = 2 * n + 1) {
        last = fine;
        fine = leapfrog(n);
        doubt = difference(&last, &fine);
        printf("%g reference:%d %.3g %.1f\n", e, n, doubt, fine.cost);
    }
    for (int n = 0; (r = n ? leapfrog(n) : ellipses()).cost < best;) {
        const double error = difference(&r, &fine) + doubt;
        printf("%g %s:%d %.3g %.1f%s\n", e, n ? "leapfrog" : "ellipses", n,
               error, r.cost, error <= e ? " holds" : "");
        best = error <= e ? r.cost : best;
        const double want = error > 0.1 ? 2 * n : n * sqrt(error / e);
        const double rung = exp2(fmax(ceil(log2(want / 16)), 0));
        n = n ? (int)(ceil(want / rung) * rung) : 1;
    }
    return 0;
}
