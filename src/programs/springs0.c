/* From chapters/10-springs.nw: edit there, then run make tangle. */
/* checksum 2095245300 of the lines below */
/* Steps a membrane, a grid of masses and springs, by leapfrog. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 8, BODIES = SIDE * SIDE, SIZE = 3 * BODIES };
static const double stiffness = 50, gap = 2.0 / 7,
                    dt = 0.01; /* N/m, m, s */
static double x[SIZE], v[SIZE], force[SIZE], moves[BODIES];

/* Adds the force of a spring to its two ends (10.1, eq:spring-force). */
static void pull(int i, int j, double rest)
{
    const double *a = x + 3 * i, *b = x + 3 * j;
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double q = stiffness * (1 - rest / length);
    for (int k = 0; k < 3; ++k) {
        force[3 * i + k] += q * d[k];
        force[3 * j + k] -= q * d[k];
    }
}

static void pull_all(double rest)
{
    memset(force, 0, sizeof force);
    for (int i = 0; i < BODIES; ++i) {
        if (i % SIDE < SIDE - 1)
            pull(i, i + 1, rest);
        if (i / SIDE < SIDE - 1)
            pull(i, i + SIDE, rest);
    }
}

/* Adds h times rate[] to the coordinates y[] of bodies that can move. */
static void add(double y[], const double rate[], double h)
{
    for (int c = 0; c < SIZE; ++c)
        y[c] += moves[c / 3] * rate[c] * h;
}

/* Displaces a flat grid by the first mode of a drum with a fixed rim. */
static void lift(double height)
{
    const double wave = acos(-1) / (SIDE - 1);
    for (int i = 0; i < BODIES; ++i) {
        double *at = x + 3 * i, column = i % SIDE, row = i / SIDE;
        at[0] = column * gap - 1;
        at[1] = row * gap - 1;
        at[2] = height * sin(wave * column) * sin(wave * row);
        moves[i] = i % SIDE % (SIDE - 1) > 0 && i / SIDE % (SIDE - 1) > 0;
    }
}

static void show(void)
{
    const double *at = x;
    for (int i = 1; i <= BODIES; ++i, at += 3)
        printf("%.9g %.9g %.9g\n%s", at[0], at[1], at[2],
               i % SIDE > 0 ? "" : "\n");
    printf("\n");
}

int main(int argc, char *argv[])
{
    const double rest = argc == 2 ? atof(argv[1]) * gap : 0;
    if (!(rest > 0))
        return fprintf(stderr, "springs0: expected REST\n"), 2;
    lift(0.1);
    pull_all(rest);
    for (int n = 0; n <= 2400; ++n) {
        if (n % 800 == 0)
            show();
        add(v, force, dt / 2);
        add(x, v, dt);
        pull_all(rest);
        add(v, force, dt / 2);
    }
    return 0;
}
