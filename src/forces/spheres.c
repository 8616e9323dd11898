/* From chapters/11-spheres.nw: edit there, then run make tangle. */
/* checksum 3269773515 of the lines below */
/* Reflects spheres that overlap after a step, and moves them apart. */
#include "forces/spheres.h"

#include "forces/pairs.h"

#include <math.h>
#include <stdlib.h>

bool spheres_create(struct spheres *p, const struct scene *s,
                    enum spheres_rule rule)
{
    const size_t n = s->bodies;
    *p = (struct spheres){.rule = rule, .scene = s, .dt = s->dt};
    p->restitution = s->restitution;
    p->inverse = malloc(SPHERES_AXES * n * sizeof *p->inverse + 1);
    if (!p->inverse || !pairs_begin(p)) {
        spheres_free(p);
        return false;
    }
    for (size_t c = 0; c < SPHERES_AXES * n; ++c)
        p->inverse[c] = s->freedom[c] ? 1 / s->mass[c % n] : 0;
    return true;
}

void spheres_free(struct spheres *p)
{
    free(p->inverse);
    pairs_end(p);
    *p = (struct spheres){0};
}

/* Two bodies in contact. All vectors point from the first body to the
   second. */
struct contact {
    size_t a, b;
    double d[SPHERES_AXES], u[SPHERES_AXES]; /* relative position, m, and
                                                velocity, m/s */
    double sigma, distance;                  /* sum of radii, distance, m */
    double normal[SPHERES_AXES];             /* has the length `distance` */
    double back;                             /* time since the contact, s */
};

double spheres_way(const struct scene *s, const double x[], size_t a,
                   size_t b, size_t k)
{
    const double d = x[k * s->bodies + b] - x[k * s->bodies + a];
    const double side = s->high[k] - s->low[k];
    if (s->wall[k] != SCENE_PERIODIC)
        return d;
    return d - side * floor(d / side + 0.5);
}

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_normal(struct contact *c, const double d[])
{
    c->distance = sqrt(dot(d, d));
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        c->normal[k] = d[k];
    if (c->distance == 0)
        c->normal[0] = c->distance = 1e-9 * c->sigma;
}

static struct contact look_at(const struct spheres *p,
                              struct spheres_pair pair, const double x[],
                              const double v[])
{
    const struct scene *s = p->scene;
    struct contact c = {.a = pair.a, .b = pair.b};
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const size_t at = k * s->bodies;
        c.d[k] = spheres_way(s, x, c.a, c.b, k);
        c.u[k] = v[at + c.b] - v[at + c.a];
    }
    c.sigma = s->radius[c.a] + s->radius[c.b];
    set_normal(&c, c.d);
    return c;
}

/* Computes c->back, (11.2, eq:back-time), and sets the normal to its value
   at the time of contact. Returns false if the bodies did not touch within
   the last dt. */
static bool go_back(struct contact *c, double dt)
{
    const double b = dot(c->d, c->u), u2 = dot(c->u, c->u);
    const double out = c->sigma * c->sigma - dot(c->d, c->d);
    double then[SPHERES_AXES];
    c->back = out / (sqrt(b * b + u2 * out) - b);
    if (!(b < 0 && c->back <= dt))
        return false;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        then[k] = c->d[k] - c->u[k] * c->back;
    set_normal(c, then);
    return true;
}

/* Adds J times the normal times the inverse mass to the velocity v of body
   i. v may also be an array of positions. */
static void kick(const struct spheres *p, const struct contact *c, size_t i,
                 double J, double v[])
{
    const size_t n = p->scene->bodies;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        v[k * n + i] += J * c->normal[k] * p->inverse[k * n + i];
}

/* Returns the inverse mass of body i along the normal times the squared
   distance (in m^2/kg). */
static double inverse_along(const struct spheres *p,
                            const struct contact *c, size_t i)
{
    const size_t n = p->scene->bodies;
    double w = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        w += c->normal[k] * c->normal[k] * p->inverse[k * n + i];
    return w;
}

/* Reflects the pair, and returns the impulse divided by the distance. */
static double reflect(struct spheres *p, const struct contact *c,
                      double parting, double w, double v[])
{
    const double J = -(1 + p->restitution) * parting / w;
    kick(p, c, c->a, -J, v);
    kick(p, c, c->b, J, v);
    p->virial += J * c->distance * c->distance;
    ++p->collisions;
    return J;
}

static double along(const struct spheres *p, const struct contact *c,
                    size_t i, const double v[])
{
    double sum = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        sum += c->normal[k] * v[k * p->scene->bodies + i];
    return sum;
}

/* Moves the bodies apart, and returns the increase of the sum over both
   of m x . v (in J s), where x is the position. */
static double push_apart(const struct spheres *p, const struct contact *c,
                         double wa, double wb, double x[], const double v[])
{
    const double depth = (c->sigma - c->distance) * c->distance;
    double a = depth / (wa + wb), b = a;
    if (p->shift == SPHERES_BY_RADIUS && wa > 0 && wb > 0) {
        a = depth * (p->scene->radius[c->a] / c->sigma) / wa;
        b = depth * (p->scene->radius[c->b] / c->sigma) / wb;
    }
    kick(p, c, c->a, -a, x);
    kick(p, c, c->b, b, x);
    return b * along(p, c, c->b, v) - a * along(p, c, c->a, v);
}

static bool collide_pair(struct spheres *p, struct spheres_pair pair,
                         double x[], double v[])
{
    struct contact c = look_at(p, pair, x, v);
    const double depth = c.sigma - c.distance;
    const bool back = p->shift == SPHERES_BACK && go_back(&c, p->dt);
    const double parting = dot(c.u, c.normal);
    const double wa = inverse_along(p, &c, c.a);
    const double wb = inverse_along(p, &c, c.b);
    if (!(depth > 0 && wa + wb > 0))
        return false;
    if (parting >= 0 && p->rule == SPHERES_APPROACHING) {
        if (p->shift != SPHERES_BACK)
            p->virial += push_apart(p, &c, wa, wb, x, v);
        return false;
    }
    const double J = reflect(p, &c, parting, wa + wb, v);
    if (back) {
        kick(p, &c, c.a, -J * c.back, x);
        kick(p, &c, c.b, J * c.back, x);
    } else
        p->virial += push_apart(p, &c, wa, wb, x, v);
    p->receding += parting >= 0;
    p->depth = fmax(p->depth, depth);
    return true;
}

/* Reflects body i if its coordinate *x is beyond `edge` and the body moves
   outwards. At `edge` it touches the wall on the side `sign` along axis k.
   Returns whether the body was reflected. */
static bool bounce(struct spheres *p, size_t i, size_t k, double sign,
                   double edge, double *x, double *v)
{
    const double out = sign * (*x - edge);
    if (!(out > 0 && sign * *v > 0 &&
          p->scene->freedom[k * p->scene->bodies + i]))
        return false;
    p->impulse[k] += p->scene->mass[i] * (1 + p->restitution) * fabs(*v);
    *v *= -p->restitution;
    *x = edge - sign * p->restitution * out;
    ++p->wall_collisions;
    return true;
}

static uint64_t collide_walls(struct spheres *p, double x[], double v[])
{
    const struct scene *s = p->scene;
    const uint64_t before = p->wall_collisions;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t i = 0; s->wall[k] == SCENE_HARD && i < s->bodies; ++i) {
            const size_t at = k * s->bodies + i;
            if (!bounce(p, i, k, -1, s->low[k] + s->radius[i], &x[at],
                        &v[at]))
                bounce(p, i, k, 1, s->high[k] - s->radius[i], &x[at],
                       &v[at]);
        }
    return p->wall_collisions - before;
}

uint64_t spheres_resolve(struct spheres *p, double x[], double v[])
{
    uint64_t count = collide_walls(p, x, v);
    pairs_find(p, x, v);
    for (size_t i = 0; i < p->pairs; ++i)
        count += collide_pair(p, p->pair[i], x, v);
    return count;
}

void spheres_reflect(struct spheres *p, size_t a, size_t b,
                     const double x[], double v[])
{
    const struct spheres_pair pair = {(uint32_t)a, (uint32_t)b, 0};
    const struct contact c = look_at(p, pair, x, v);
    const double w = inverse_along(p, &c, a) + inverse_along(p, &c, b);
    if (w > 0)
        reflect(p, &c, dot(c.u, c.normal), w, v);
}

void spheres_bounce(struct spheres *p, size_t i, size_t k, double v[])
{
    double *u = &v[k * p->scene->bodies + i];
    p->impulse[k] += p->scene->mass[i] * (1 + p->restitution) * fabs(*u);
    *u *= -p->restitution;
    ++p->wall_collisions;
}
