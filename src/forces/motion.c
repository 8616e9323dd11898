/* Adds up the accelerations of a scene, and steps it with its contacts. */
#include "forces/motion.h"

#include "forces/twobody.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Subtracts the acceleration due to friction: (11.14, eq:motion). */
static void add_friction(const struct scene *s, const double v[],
                         double a[])
{
    const size_t n = s->bodies;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < n; ++i)
            a[k * n + i] -= s->damping / s->mass[i] * v[k * n + i];
}

/* Writes the accelerations of all bodies into a: (11.14, eq:motion).
   Uniform gravity comes first, because it overwrites a; all other forces
   are added. At the end the accelerations of fixed coordinates are set to
   zero. */
static void accelerate(void *what, const double x[], const double v[],
                       double a[])
{
    struct motion *m = what;
    const struct scene *s = m->scene;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < s->bodies; ++i)
            a[k * s->bodies + i] = s->gravity[k];
    if (m->attracts)
        gravity_add(&m->gravity, x, a);
    if (m->bound)
        springs_add(&m->springs, x, v, a);
    if (m->is_soft)
        soft_add(&m->soft, x, v, a);
    if (s->damping > 0)
        add_friction(s, v, a);
    for (size_t j = 0; j < m->fixed; ++j)
        a[m->held[j]] = 0;
}

/* A stepping_sweep for motions for which are_two returns true. */
static void sweep_two(void *what, const double x[], const double v[],
                      double a[], const struct stepping_ahead *ahead,
                      uint64_t steps)
{
    const struct motion *m = what;
    (void)x, (void)v, (void)ahead; /* twobody_sweep moves bodies itself */
    twobody_sweep(&m->gravity, &m->stepping, m->scene->gravity, m->held,
                  m->fixed, a, steps);
}

/* Returns whether the scene has two bodies, not both fixed, and no forces
   except their mutual gravity and uniform gravity. Such a scene uses
   sweep_two. */
static bool are_two(const struct motion *m, bool damped)
{
    return m->scene->bodies == 2 && m->fixed < 6 && m->attracts &&
           !m->gravity.source && !m->bound && !m->is_soft && !m->orbits &&
           !damped;
}

/* Creates the modules that the scene needs. Returns false if memory runs
   out; motion_end then frees the modules. */
static bool make_parts(struct motion *m)
{
    const struct scene *s = m->scene;
    if (s->k2 > 0)
        m->attracts = gravity_create(&m->gravity, s->bodies, s->mass, s->k2,
                                     s->softening);
    if (s->springs > 0)
        m->bound = springs_create(&m->springs, s);
    if (s->contact && s->law == SCENE_SUDDEN)
        m->collides = spheres_create(&m->spheres, s, SPHERES_ALL);
    else if (s->contact)
        m->is_soft = soft_create(&m->soft, s);
    return m->attracts == (s->k2 > 0) && m->bound == (s->springs > 0) &&
           (m->collides || m->is_soft) == s->contact;
}

/* Lists the fixed coordinates and sets their velocities to 0, whatever the
   scene says. Otherwise these coordinates would move uniformly. Returns
   false if memory runs out. */
static bool hold_coordinates(struct motion *m)
{
    struct scene *s = m->scene;
    m->held = malloc((3 * s->bodies + 1) * sizeof *m->held);
    for (size_t c = 0; m->held && c < 3 * s->bodies; ++c)
        if (!s->freedom[c]) {
            m->held[m->fixed++] = c;
            s->velocity[c] = 0;
        }
    return m->held != NULL;
}

/* Returns the acceleration that an earlier run saved in the scene (as its
   lines `kept`), or NULL if the method cannot use it. Only leapfrog with
   friction uses it; all other methods need only positions and velocities.

   The earlier run computed the acceleration for a velocity predicted over
   its own step, which is the scene's dt. A run with another step must not
   use it, since each such run would begin with an error proportional to
   dt. Halving dt repeatedly, always from the same saved scene, would then
   only halve the error each time instead of dividing it by four. */
static const double *find_kept(const struct motion *m)
{
    const bool same_step = m->stepping.dt == m->scene->dt;
    return stepping_keeps(&m->stepping) && same_step ? m->scene->kept
                                                     : NULL;
}

/* Creates the module jacobi if the method drifts along ellipses. Returns
   false if memory runs out. */
static bool begin_orbits(struct motion *m,
                         const struct stepping_method *method)
{
    const struct scene *s = m->scene;
    m->orbits = method->orbits &&
                jacobi_create(&m->jacobi, s->bodies, s->mass, s->k2);
    return m->orbits == method->orbits;
}

/* Returns whether velocities can change between contacts. */
static bool accelerates(const struct motion *m)
{
    const double *const g = m->scene->gravity;
    return m->attracts || m->bound || m->is_soft || m->scene->damping > 0 ||
           g[0] != 0 || g[1] != 0 || g[2] != 0;
}

/* Sets the time step for contacts that are resolved after steps. Bodies are
   traced back by at most this time. Pairs that have passed through each
   other are sought only within the distance that bodies can move in this
   time. */
static void set_dt_of_contacts(struct motion *m, double dt)
{
    m->spheres.dt = dt;
    if (m->is_soft)
        m->soft.near->dt = dt;
}

/* Begins stepping. Returns false if memory runs out. If only springs act,
   their module also computes uniform gravity and friction, in one sweep
   over the bodies.

   Sums are compensated if an earlier run saved their rounding errors (as
   `carry` lines of the scene), and for methods of order six or more, whose
   truncation error is less than the rounding error. They are never
   compensated for adaptive methods. The caller may change s->compensated
   before the first step. */
static bool begin_stepping(struct motion *m,
                           const struct stepping_method *method, double dt)
{
    struct scene *s = m->scene;
    const bool damped = s->damping > 0 || (m->is_soft && s->dashpot > 0) ||
                        (m->bound && springs_damped(&m->springs));
    const bool alone = m->bound && !m->attracts && !m->is_soft;
    struct stepping_forces forces = {3 * s->bodies, damped, accelerate, m};
    if (alone)
        forces = springs_forces(&m->springs);
    if (m->orbits)
        forces = jacobi_forces(&m->jacobi);
    if (!stepping_begin(&m->stepping, method, forces, dt, s->position,
                        s->velocity))
        return false;
    if (alone)
        m->stepping.sweep = springs_sweep;
    if (are_two(m, damped))
        m->stepping.sweep = sweep_two;
    if (m->orbits)
        m->stepping.flow = jacobi_flow;
    m->stepping.start = s->time;
    m->dt = dt;
    set_dt_of_contacts(m, dt);
    m->stepping.compensated =
        !method->adaptive &&
        (s->carry || (method->order >= 6 && accelerates(m)));
    stepping_resume(&m->stepping, 0, s->carry, find_kept(m));
    return true;
}

/* Returns whether body i has no mass but may move. */
static bool is_massless(const struct scene *s, size_t i)
{
    const size_t n = s->bodies;
    return s->mass[i] == 0 &&
           (s->freedom[i] || s->freedom[n + i] || s->freedom[2 * n + i]);
}

/* Returns a free body without mass on which a force acts, or the number of
   bodies if there is none. A spring, friction or a contact would accelerate
   such a body infinitely; friction and contacts act on all bodies. Gravity
   may act on it, since that acceleration does not depend on the mass. */
static size_t find_massless(const struct scene *s)
{
    const bool all = s->damping > 0 || s->contact;
    for (size_t i = 0; all && i < s->bodies; ++i)
        if (is_massless(s, i))
            return i;
    for (size_t j = 0; j < s->springs; ++j) {
        if (is_massless(s, s->spring[j].a))
            return s->spring[j].a;
        if (is_massless(s, s->spring[j].b))
            return s->spring[j].b;
    }
    return s->bodies;
}

/* Returns a body that is wider than the box along an axis along which it
   may move, or the number of bodies if there is none. Two opposite walls
   would push such a body simultaneously, without end. */
static size_t find_thick(const struct scene *s)
{
    for (size_t c = 0; s->contact && c < SCENE_AXES * s->bodies; ++c) {
        const size_t k = c / s->bodies, i = c % s->bodies;
        const double side = s->high[k] - s->low[k];
        if (s->wall[k] != SCENE_OPEN && s->freedom[c] &&
            2 * s->radius[i] > side * (1 + 1e-12))
            return i;
    }
    return s->bodies;
}

/* Returns whether the bodies have different coordinates along axis k, or
   one of them may move along this axis. */
static bool is_used(const struct scene *s, size_t k)
{
    const double *x = s->position + k * s->bodies;
    const double *v = s->velocity + k * s->bodies;
    const unsigned char *free = s->freedom + k * s->bodies;
    bool used = false;
    for (size_t i = 0; i < s->bodies; ++i)
        used = used || x[i] != x[0] ||
               (free[i] && (v[i] != 0 || s->gravity[k] != 0));
    return used;
}

static bool is_sprung(const struct scene *s, size_t i)
{
    for (size_t j = 0; j < s->springs; ++j)
        if (s->spring[j].a == i || s->spring[j].b == i)
            return true;
    return false;
}

/* Returns the first point (body without radius) if points could collide,
   otherwise the number of bodies. Steps cannot detect such collisions.
   Points can collide if all bodies of the scene lie on one line and a point
   may move along it. But if all points are joined to springs, they are
   usually meant to pass through each other, and nothing is reported. */
static size_t find_point(const struct scene *s)
{
    size_t axis = SCENE_AXES, axes = 0, points = 0, free = 0, loose = 0;
    size_t first = s->bodies;
    for (size_t k = 0; s->contact && k < SCENE_AXES; ++k)
        if (is_used(s, k)) {
            axis = k;
            ++axes;
        }
    for (size_t i = 0; axes == 1 && i < s->bodies; ++i)
        if (s->radius[i] == 0) {
            first = points++ == 0 ? i : first;
            free += s->freedom[axis * s->bodies + i] != 0;
            loose += loose == 0 && !is_sprung(s, i);
        }
    return points > 1 && free > 0 && loose > 0 ? first : s->bodies;
}

enum motion_flaw motion_flaw(const struct scene *s, size_t *body)
{
    const size_t of[] = {find_massless(s), find_thick(s), find_point(s)};
    const enum motion_flaw flaw[] = {MOTION_MASSLESS, MOTION_THICK,
                                     MOTION_POINTS};
    if ((s->wall[0] || s->wall[1] || s->wall[2]) && !s->contact)
        return MOTION_WALLS;
    if (s->law != SCENE_SUDDEN && s->restitution != 1)
        return MOTION_RESTITUTION;
    for (size_t f = 0; f < sizeof of / sizeof of[0]; ++f) {
        if (body)
            *body = of[f];
        if (of[f] < s->bodies)
            return flaw[f];
    }
    return MOTION_WELL;
}

static bool complain(const char *program, const char *what)
{
    fprintf(stderr, "%s: %s\n", program, what);
    return false;
}

/* Returns whether the scene can be stepped. If not, prints the reason. */
static bool check_scene(const char *program, const struct scene *s)
{
    char message[200];
    size_t body;
    switch (motion_flaw(s, &body)) {
    case MOTION_WELL: return true;
    case MOTION_WALLS:
        return complain(program, "the scene has walls but no line contact, "
                                 "without which nothing minds them");
    case MOTION_RESTITUTION:
        return complain(program, "the scene has a line restitution, but "
                                 "contacts that are springs: a dashpot is "
                                 "what takes energy from them");
    case MOTION_MASSLESS:
        snprintf(message, sizeof message,
                 "body %zu has no mass, expected one, since a spring, "
                 "friction or a contact acts on it",
                 body);
        break;
    case MOTION_THICK:
        snprintf(message, sizeof message,
                 "body %zu, of radius %.10g, is thicker than the box along "
                 "an axis where it may move; expected room for it",
                 body, s->radius[body]);
        break;
    case MOTION_POINTS:
        snprintf(message, sizeof message,
                 "body %zu and another on its line are points, whose "
                 "collisions no step sees; expected radii of more than 0, "
                 "or another program: bonk, bonkers",
                 body);
        break;
    }
    return complain(program, message);
}

const struct spheres *motion_contacts(const struct motion *m)
{
    return m->collides && !m->located ? &m->spheres
           : m->is_soft               ? m->soft.near
                                      : NULL;
}

/* Sets up the motion of a scene that check_scene accepts. On failure prints
   an error and returns false, with nothing to free. */
static bool begin(struct motion *m, const char *program, struct scene *s,
                  const char *method, double dt)
{
    char message[128];
    const struct stepping_method *found = stepping_find(method);
    snprintf(message, sizeof message, "there is no method '%.40s'", method);
    if (!found)
        return complain(program, message);
    if (found->orbits && jacobi_refuses(s)) {
        snprintf(message, sizeof message, "%s: %s", method,
                 jacobi_refuses(s));
        return complain(program, message);
    }
    if (dt == 0 && s->dt == 0)
        return complain(program, "the scene has no line dt, and no time "
                                 "step was given");
    if (make_parts(m) && hold_coordinates(m) && begin_orbits(m, found) &&
        begin_stepping(m, found, dt > 0 ? dt : s->dt))
        return true;
    motion_end(m);
    return complain(program, "no memory for the motion");
}

bool motion_begin(struct motion *m, const char *program, struct scene *s,
                  const char *method, double dt)
{
    *m = (struct motion){.scene = s};
    return check_scene(program, s) && begin(m, program, s, method, dt);
}

bool motion_view(struct motion *m, const char *program, struct scene *s)
{
    const bool points = motion_flaw(s, NULL) == MOTION_POINTS;
    *m = (struct motion){.scene = s};
    return (points || check_scene(program, s)) &&
           begin(m, program, s, "leapfrog", 1);
}

void motion_end(struct motion *m)
{
    if (m->attracts)
        gravity_free(&m->gravity);
    if (m->bound)
        springs_free(&m->springs);
    if (m->located)
        impact_free(&m->impact);
    if (m->collides)
        spheres_free(&m->spheres);
    if (m->is_soft)
        soft_free(&m->soft);
    if (m->orbits)
        jacobi_free(&m->jacobi);
    stepping_free(&m->stepping);
    free(m->held);
    *m = (struct motion){0};
}

/* Returns whether the method may divide dt into several steps. The paths of
   the bodies during dt are then not straight, so spheres_watch cannot find
   pairs that have passed through each other. */
static bool is_split(const struct motion *m)
{
    return m->stepping.own || m->outside;
}

static enum stepping_end step_once(struct motion *m)
{
    struct stepping *s = &m->stepping;
    if (!m->outside)
        return stepping_run(s, 1);
    if (!m->outside(m->with, s->dt, s->x, s->v))
        return STEPPING_STUCK;
    ++s->steps;
    stepping_disturb(s);
    return STEPPING_DONE;
}

bool motion_locate(struct motion *m)
{
    m->located = impact_create(&m->impact, &m->spheres, &m->stepping);
    return m->located;
}

/* Calls stepping_disturb after a contact: the velocities have changed, so
   the acceleration stored by the method is invalid. */
enum stepping_end motion_run(struct motion *m, uint64_t steps)
{
    enum stepping_end end = STEPPING_DONE;
    if (!m->collides && !m->is_soft && !m->outside)
        return stepping_run(&m->stepping, steps);
    for (; steps > 0 && end == STEPPING_DONE; --steps) {
        end = m->located ? impact_step(&m->impact, &m->collisions)
                         : step_once(m);
        if (end == STEPPING_DONE && m->is_soft && !is_split(m))
            spheres_watch(m->soft.near, m->stepping.x, m->stepping.v);
        if (end != STEPPING_DONE || !m->collides || m->located)
            continue;
        const uint64_t met =
            spheres_resolve(&m->spheres, m->stepping.x, m->stepping.v);
        m->collisions += met;
        if (met > 0)
            stepping_disturb(&m->stepping);
    }
    return end;
}

double motion_time(const struct motion *m)
{
    return stepping_time(&m->stepping);
}

void motion_resume(struct motion *m, double start, uint64_t steps)
{
    m->stepping.start = start;
    stepping_resume(&m->stepping, steps, NULL, find_kept(m));
}

/* Keeps the compensated sums, but restarts the method with the new step:
   the acceleration that leapfrog stores belongs to one length of step (see
   find_kept). The steps of an adaptive method do not change, only the times
   of output. */
bool motion_shorten(struct motion *m, double dt)
{
    struct stepping old = m->stepping, *s = &m->stepping;
    if (s->own) {
        s->start = stepping_time(s);
        s->steps = 0;
        s->dt = dt;
        set_dt_of_contacts(m, dt);
        return true;
    }
    if (!stepping_begin(s, old.method, old.forces, dt, old.x, old.v)) {
        *s = old;
        return false;
    }
    s->start = stepping_time(&old);
    s->compensated = old.compensated;
    s->sweep = old.sweep;
    s->flow = old.flow;
    s->evaluations = old.evaluations;
    stepping_resume(s, 0, old.compensated ? old.carry : NULL, NULL);
    stepping_free(&old);
    set_dt_of_contacts(m, dt);
    return true;
}

/* Replaces *to by a copy of from[n], or by NULL if from is NULL. Returns
   false if memory runs out. */
static bool note(double **to, const double from[], size_t n)
{
    free(*to);
    *to = from ? malloc(n * sizeof *from) : NULL;
    if (*to)
        memcpy(*to, from, n * sizeof *from);
    return !*to == !from;
}

/* Also stores the rounding errors of compensated sums. Each is less than
   the last digit, but without them a resumed run differs after a thousand
   steps. Also stores the acceleration that leapfrog keeps, except after a
   contact, when an uninterrupted run computes a new one, too.

   The times in the first column of a resumed run may differ in their last
   digits from those of an uninterrupted run, without effect on the motion.
   They are t0 + n dt, where t0 is the time of the saved scene. A checkpoint
   stores the original t0 and n, and so reproduces the times. */
bool motion_note(struct motion *m)
{
    struct scene *s = m->scene;
    const struct stepping *p = &m->stepping;
    const bool keeps = stepping_keeps(p) && p->fresh && p->dt == m->dt;
    s->time = motion_time(m);
    s->dt = m->dt;
    return note(&s->carry, p->compensated ? p->carry : NULL,
                6 * s->bodies) &&
           note(&s->kept, keeps ? p->acceleration : NULL, 3 * s->bodies);
}

/* Returns the potential energy in uniform gravity (in J), summed over the
   free coordinates only. Fixed coordinates would add a constant. */
static double weight_energy(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; s->gravity[k] != 0 && i < n; ++i)
            if (s->freedom[k * n + i])
                sum -= s->mass[i] * s->gravity[k] * s->position[k * n + i];
    return sum;
}

/* Adds the energies in the order of the bodies' numbers, so that the
   rounding error is always the same. */
double motion_kinetic(const struct motion *m)
{
    const struct scene *s = m->scene;
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = s->velocity[i], y = s->velocity[n + i],
                     z = s->velocity[2 * n + i];
        sum += s->mass[i] * (x * x + y * y + z * z) / 2;
    }
    return sum;
}

struct motion_energy motion_energy(const struct motion *m)
{
    const double *x = m->scene->position;
    double springs = m->bound ? springs_potential(&m->springs, x) : 0;
    if (m->is_soft)
        springs += soft_potential(&m->soft, x);
    return (struct motion_energy){
        motion_kinetic(m),
        m->attracts ? gravity_potential(&m->gravity, x) : 0, springs,
        weight_energy(m->scene)};
}

double motion_potential(const struct motion *m)
{
    const struct motion_energy e = motion_energy(m);
    return e.gravity + e.springs + e.weight;
}
