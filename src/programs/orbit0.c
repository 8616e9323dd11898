/* From chapters/08-stepping.nw: edit there, then run make tangle. */
/* checksum 1474263890 of the lines below */
/* Steps a planet around the sun by one of three methods. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Position (in AU) and velocity (in AU/year). The sun is at the origin. */
struct planet {
    double x, y, vx, vy;
};

/* GM of the sun (in AU^3/year^2): an orbit of radius 1 AU takes a year. */
static const double sun = 39.478417604357434;

static void drift(struct planet *p, double dt)
{
    p->x += p->vx * dt;
    p->y += p->vy * dt;
}

static void kick(struct planet *p, double dt)
{
    const double r = sqrt(p->x * p->x + p->y * p->y);
    const double pull = sun / (r * r * r);
    p->vx -= pull * p->x * dt;
    p->vy -= pull * p->y * dt;
}

static void euler(struct planet *p, double dt)
{
    struct planet old = *p;
    drift(p, dt);
    kick(&old, dt);
    p->vx = old.vx;
    p->vy = old.vy;
}

static void symplectic_euler(struct planet *p, double dt)
{
    kick(p, dt);
    drift(p, dt);
}

static void leapfrog(struct planet *p, double dt)
{
    kick(p, dt / 2);
    drift(p, dt);
    kick(p, dt / 2);
}

static void show(double t, const struct planet *p)
{
    const double r = sqrt(p->x * p->x + p->y * p->y);
    printf("%.9g %.9g %.9g %.9g\n", t, p->x, p->y,
           (p->vx * p->vx + p->vy * p->vy) / 2 - sun / r);
}

int main(int argc, char *argv[])
{
    const char *const method = argc == 4 ? argv[1] : "";
    const double dt = argc == 4 ? atof(argv[2]) : 0;
    void (*const step)(struct planet *, double) =
        strcmp(method, "euler") == 0              ? euler
        : strcmp(method, "symplectic-euler") == 0 ? symplectic_euler
        : strcmp(method, "leapfrog") == 0         ? leapfrog
                                                  : NULL;
    struct planet p = {1, 0, 0, sqrt(sun)};
    if (!step || !(dt > 0)) {
        fprintf(stderr, "orbit0: expected METHOD STEP YEARS\n");
        return 2;
    }
    for (long k = 0; (double)k * dt < atof(argv[3]) + dt / 2; ++k) {
        show((double)k * dt, &p);
        step(&p, dt);
    }
    return 0;
}
