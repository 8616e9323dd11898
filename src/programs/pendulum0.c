/* From chapters/08-stepping.nw: edit there, then run make tangle. */
/* checksum 3718066744 of the lines below */
/* Steps a pendulum by one of four methods. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The angle and the angular velocity, 1/s. */
struct state {
    double x, v;
};

static struct state euler(struct state s, double dt)
{
    return (struct state){s.x + s.v * dt, s.v - sin(s.x) * dt};
}

static struct state symplectic_euler(struct state s, double dt)
{
    s.v -= sin(s.x) * dt;
    s.x += s.v * dt;
    return s;
}

static struct state leapfrog(struct state s, double dt)
{
    s.v -= sin(s.x) * dt / 2;
    s.x += s.v * dt;
    s.v -= sin(s.x) * dt / 2;
    return s;
}

/* Returns s plus dt times the rate of change in the state `at`. */
static struct state along(struct state s, struct state at, double dt)
{
    return (struct state){s.x + at.v * dt, s.v - sin(at.x) * dt};
}

static struct state rk4(struct state s, double dt)
{
    const struct state half = along(s, s, dt / 2);
    const struct state again = along(s, half, dt / 2);
    const struct state whole = along(s, again, dt);
    const struct state sum = along(s, s, dt / 6);
    return along(along(along(sum, half, dt / 3), again, dt / 3), whole,
                 dt / 6);
}

int main(int argc, char *argv[])
{
    const char *const method = argc == 5 ? argv[1] : "";
    struct state (*const step)(struct state, double) =
        strcmp(method, "euler") == 0              ? euler
        : strcmp(method, "symplectic-euler") == 0 ? symplectic_euler
        : strcmp(method, "leapfrog") == 0         ? leapfrog
        : strcmp(method, "rk4") == 0              ? rk4
                                                  : NULL;
    const double dt = step ? atof(argv[2]) : 0;
    if (!(dt > 0)) {
        fprintf(stderr, "pendulum0: expected METHOD STEP TIME ANGLE\n");
        return 2;
    }
    struct state s = {atof(argv[4]), 0};
    for (long k = 0; (double)k * dt < atof(argv[3]) + dt / 2; ++k) {
        printf("%.9g %.9g %.9g %.9g\n", (double)k * dt, s.x, s.v,
               s.v * s.v / 2 - cos(s.x));
        s = step(s, dt);
    }
    return 0;
}
