/* Says why a scene is not a system of planets around a star. */
#include "forces/jacobi.h"
#include "forces/kepler.h"

#include <math.h>

/* Returns whether fixed coordinates along this axis change the motion.
   They do not if they confine all bodies to one plane, since nothing would
   pull the bodies out of it. */
static bool is_held(const struct scene *s, size_t axis)
{
    const size_t n = s->bodies, from = axis * n;
    size_t held = 0, flat = 0;
    for (size_t i = 0; i < n; ++i) {
        held += !s->freedom[from + i];
        flat += s->position[from + i] == s->position[from];
    }
    return held > 0 && (held < n || flat < n);
}

/* Returns a message if the scene contains anything besides gravity between
   free points, otherwise NULL. */
static const char *find_more(const struct scene *s)
{
    if (s->contact)
        return "the scene has bodies that collide";
    if (s->springs > 0)
        return "the scene has springs";
    if (s->damping > 0)
        return "the scene has friction";
    if (s->gravity[0] != 0 || s->gravity[1] != 0 || s->gravity[2] != 0)
        return "the scene has a weight";
    if (s->softening != 0)
        return "the scene's gravity is softened";
    if (is_held(s, 0) || is_held(s, 1) || is_held(s, 2))
        return "the scene has bodies that are held";
    return NULL;
}

/* Returns whether body i is on an ellipse about the centre of mass of the
   bodies before it: (9.9, eq:jacobi). These have the total mass *mass, and
   their centre of mass is at x and has the velocity v. Afterwards x, v and
   *mass include body i. */
static bool is_bound(const struct scene *s, size_t i, double x[3],
                     double v[3], double *mass)
{
    double q[3], w[3], axis, eccentricity;
    *mass += s->mass[i];
    for (size_t k = 0; k < 3; ++k) {
        q[k] = s->position[k * s->bodies + i] - x[k];
        w[k] = s->velocity[k * s->bodies + i] - v[k];
        x[k] += s->mass[i] / *mass * q[k];
        v[k] += s->mass[i] / *mass * w[k];
    }
    kepler_shape(s->k2 * *mass, q, w, &axis, &eccentricity);
    return axis > 0 && axis < INFINITY;
}

const char *jacobi_refuses(const struct scene *s)
{
    double x[3], v[3], mass = s->mass[0];
    if (s->bodies < 2 || !(s->k2 > 0) || !(mass > 0))
        return "no two bodies of the scene attract each other";
    const char *const more = find_more(s);
    if (more)
        return more;
    for (size_t k = 0; k < 3; ++k) {
        x[k] = s->position[k * s->bodies];
        v[k] = s->velocity[k * s->bodies];
    }
    for (size_t i = 1; i < s->bodies; ++i) {
        if (s->mass[i] > s->mass[0])
            return "the first body of the scene is not the heaviest";
        if (!is_bound(s, i, x, v, &mass))
            return "a body of the scene is on no ellipse about those "
                   "before it";
    }
    return NULL;
}
