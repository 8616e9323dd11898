/* From chapters/11-spheres.nw: edit there, then run make tangle. */
/* checksum 495174128 of the lines below */
/* Simulates a billiard break in steps, moving overlapping balls back. */
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BALLS = 16, STEPS = 50000 };
static const double radius = 0.028575, gap = 1e-4, dt = 1e-5; /* m, m, s */
static double x[BALLS][2], v[BALLS][2];

/* Places the cue ball, then the other balls in a triangle. */
static void rack(void)
{
    const double side = 2 * radius + gap;
    int i = 0;
    x[i][0] = -1.27;
    v[i][0] = 8;
    for (int row = 0; row < 5; ++row)
        for (int place = 0; place <= row; ++place) {
            x[++i][0] = row * side * sqrt(0.75);
            x[i][1] = (place - row / 2.0) * side;
        }
}

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* Returns the time (in s) since two overlapping balls that approach each
   other touched, or 0 if this time exceeds the step (11.2,
   eq:back-time). */
static double time_back(const double d[], const double u[])
{
    const double b = dot(d, u), c = dot(d, d) - 4 * radius * radius;
    const double back = -c / (sqrt(b * b - dot(u, u) * c) - b);
    return back <= dt ? back : 0;
}

/* Collides balls i and j if they overlap and approach each other. The
   impulse acts where they touched (11.1, eq:contact-impulse). From there
   the balls move on. */
static void collide(int i, int j)
{
    double d[2], u[2], n[2];
    for (int k = 0; k <= 1; ++k) {
        d[k] = x[j][k] - x[i][k];
        u[k] = v[j][k] - v[i][k];
    }
    if (dot(d, d) >= 4 * radius * radius || dot(d, u) >= 0)
        return;
    const double back = time_back(d, u);
    for (int k = 0; k <= 1; ++k)
        n[k] = d[k] - back * u[k];
    const double change = -dot(u, n) / dot(n, n); /* factor of n if e = 1 */
    for (int k = 0; k < 2; ++k) {
        v[i][k] -= change * n[k];
        v[j][k] += change * n[k];
        x[i][k] -= change * n[k] * back;
        x[j][k] += change * n[k] * back;
    }
}

/* Collides all pairs in ascending or descending order of their indices. */
static void collide_all(int down)
{
    for (int p = 0; p < BALLS; ++p) {
        const int i = down ? BALLS - 1 - p : p;
        for (int q = 1; q < BALLS - i; ++q)
            collide(i, down ? BALLS - q : i + q);
    }
}

int main(int argc, char *argv[])
{
    const int down = argc == 2 && strcmp(argv[1], "descending") == 0;
    if (!down && (argc != 2 || strcmp(argv[1], "ascending") != 0)) {
        fprintf(stderr, "spheres0: expected ascending or descending\n");
        return 2;
    }
    rack();
    for (int n = 0; n < STEPS; ++n) {
        for (int i = 0; i < BALLS; ++i)
            for (int k = 0; k < 2; ++k)
                x[i][k] += v[i][k] * dt;
        collide_all(down);
    }
    for (int i = 0; i <= BALLS - 1; ++i)
        printf("%.9g %.9g %.9g %.9g\n", x[i][0], x[i][1], v[i][0], v[i][1]);
    return 0;
}
