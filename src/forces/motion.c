/* From chapters/11-step.nw: edit there, then run make tangle. */
/* checksum 3740126551 of the lines below */
/* Accelerations are added up; bodies collide between two steps. */
#include "forces/motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add_friction(const struct scene *s, const double v[],
                         double a[])
{
    const size_t n = s->bodies;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < n; ++i)
            a[k * n + i] -= s->damping / s->mass[i] * v[k * n + i];
}

/* (11.14, eq:motion) */
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
    if (m->touches)
        touch_add(&m->touch, x, v, a);
    if (s->damping > 0)
        add_friction(s, v, a);
    for (size_t j = 0; j < m->fixed; ++j)
        a[m->held[j]] = 0;
}

typedef double pair __attribute__((vector_size(16), aligned(8), may_alias));

/* One coordinate of two bodies under way, and what a kick multiplies. */
struct axis {
    pair x, v, a, kick, weight;
};

/* Half a kick and the drift, as in stepping.c; returns how far they are
   apart. */
static inline pair move(struct axis *k, double dt, bool owing)
{
    const pair half = k->kick * k->a;
    if (owing)
        k->v += half;
    k->v += half;
    k->x += dt * k->v;
    return (pair){k->x[1], k->x[1]} - (pair){k->x[0], k->x[0]};
}

static void run_two(const struct gravity *g, double dt, uint64_t steps,
                    struct axis axis[3], bool plain)
{
    const double k2 = g->k2, least = g->softening * g->softening;
    const pair mass = {g->mass[1], -g->mass[0]};
    struct axis z = axis[2], y = axis[1], x = axis[0];
    for (uint64_t k = 0; k < steps; ++k) {
        const pair dx = move(&x, dt, k > 0), dy = move(&y, dt, k > 0);
        pair dz, square = dx * dx + dy * dy;
        if (!plain) {
            dz = move(&z, dt, k > 0);
            square = square + dz * dz + least;
        }
        const double s = square[0], w = k2 / (s * sqrt(s));
        const pair pull = w * mass;
        x.a = pull * dx;
        y.a = pull * dy;
        if (!plain) {
            z.a = z.weight + pull * dz;
            x.a += x.weight;
            y.a += y.weight;
        }
    }
    if (plain) {
        x.a += x.weight;
        y.a += y.weight;
    }
    axis[0] = x;
    axis[1] = y;
    axis[2] = z;
}

static bool is_nothing(pair p) /* not even a sign */
{
    return memcmp(&p, &(pair){0, 0}, sizeof p) == 0;
}

static bool has_minus_zero(pair p)
{
    return (p[0] == 0 && signbit(p[0])) || (p[1] == 0 && signbit(p[1]));
}

static bool is_plain(const struct gravity *g, const struct axis axis[3])
{
    const struct axis *x = axis, *y = axis + 1, *z = axis + 2;
    return g->softening == 0 && is_nothing(x->weight) &&
           is_nothing(y->weight) && is_nothing(z->weight) &&
           is_nothing(z->x) && is_nothing(z->v) && is_nothing(z->a) &&
           !has_minus_zero(x->v) && !has_minus_zero(y->v);
}

static void sweep_two(void *what, const double x[], const double v[],
                      double a[], const struct stepping_ahead *ahead,
                      uint64_t steps)
{
    const struct motion *m = what;
    const struct stepping *s = &m->stepping;
    const double half = s->dt / 2;
    double kick[] = {half, half, half, half, half, half};
    struct axis axis[3];
    (void)ahead;
    for (size_t j = 0; j < m->fixed; ++j)
        kick[m->held[j]] = 0;
    for (size_t k = 0; k < 3; ++k)
        axis[k] =
            (struct axis){*(const pair *)(x + 2 * k),
                          *(const pair *)(v + 2 * k),
                          *(pair *)(a + 2 * k),
                          *(pair *)(kick + 2 * k),
                          {m->scene->gravity[k], m->scene->gravity[k]}};
    run_two(&m->gravity, s->dt, steps, axis, is_plain(&m->gravity, axis));
    for (size_t k = 0; k < 3; ++k) {
        *(pair *)(s->x + 2 * k) = axis[k].x;
        *(pair *)(s->v + 2 * k) = axis[k].v;
        *(pair *)(a + 2 * k) = axis[k].a;
    }
    for (size_t j = 0; j < m->fixed; ++j)
        a[m->held[j]] = 0;
}

/* Two that nothing else moves, and of which not all is held. */
static bool are_two(const struct motion *m, bool damped)
{
    return m->scene->bodies == 2 && m->fixed < 6 && m->attracts &&
           !m->gravity.source && !m->bound && !m->touches && !m->orbits &&
           !damped;
}

static bool make_parts(struct motion *m)
{
    const struct scene *s = m->scene;
    if (s->k2 > 0)
        m->attracts = gravity_create(&m->gravity, s->bodies, s->mass, s->k2,
                                     s->softening);
    if (s->springs > 0)
        m->bound = springs_create(&m->springs, s);
    if (s->contact && s->touch == SCENE_SUDDEN)
        m->collides = spheres_create(&m->spheres, s, SPHERES_ALL);
    else if (s->contact)
        m->touches = touch_create(&m->touch, s);
    return m->attracts == (s->k2 > 0) && m->bound == (s->springs > 0) &&
           (m->collides || m->touches) == s->contact;
}

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

/* The acceleration in the scene, if the method can go on with it, or
   NULL. */
static const double *find_kept(const struct motion *m)
{
    const bool same_step = m->stepping.dt == m->scene->dt;
    return stepping_keeps(&m->stepping) && same_step ? m->scene->kept
                                                     : NULL;
}

static bool begin_orbits(struct motion *m,
                         const struct stepping_method *method)
{
    const struct scene *s = m->scene;
    m->orbits = method->orbits &&
                jacobi_create(&m->jacobi, s->bodies, s->mass, s->k2);
    return m->orbits == method->orbits;
}

/* Does anything change a velocity? */
static bool accelerates(const struct motion *m)
{
    const double *const g = m->scene->gravity;
    return m->attracts || m->bound || m->touches || m->scene->damping > 0 ||
           g[0] != 0 || g[1] != 0 || g[2] != 0;
}

/* Contacts after steps go back no further than a step, and look no further
   for what a step has left out. */
static void set_dt_of_contacts(struct motion *m, double dt)
{
    m->spheres.dt = dt;
    if (m->touches)
        m->touch.near->dt = dt;
}

static bool begin_stepping(struct motion *m,
                           const struct stepping_method *method, double dt)
{
    struct scene *s = m->scene;
    const bool damped = s->damping > 0 || (m->touches && s->dashpot > 0) ||
                        (m->bound && springs_damped(&m->springs));
    const bool alone = m->bound && !m->attracts && !m->touches;
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

static bool is_light(const struct scene *s, size_t i)
{
    const size_t n = s->bodies;
    return s->mass[i] == 0 &&
           (s->freedom[i] || s->freedom[n + i] || s->freedom[2 * n + i]);
}

/* A free body without mass on which a force acts, or the bodies' number. */
static size_t find_light(const struct scene *s)
{
    const bool all = s->damping > 0 || s->contact;
    for (size_t i = 0; all && i < s->bodies; ++i)
        if (is_light(s, i))
            return i;
    for (size_t j = 0; j < s->springs; ++j) {
        if (is_light(s, s->spring[j].a))
            return s->spring[j].a;
        if (is_light(s, s->spring[j].b))
            return s->spring[j].b;
    }
    return s->bodies;
}

/* A body that is thicker than the box along an axis where it may move, or
   the bodies' number. What two opposite walls push at once ends nowhere. */
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

/* May something take bodies along axis k, or are they apart along it? */
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

/* The first of several points that share a line which they cannot leave, if
   one of them moves; or the bodies' number. Springs are often hung up at
   points, and what they join is meant to swing through: a point on no
   spring has to be among them. */
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
    const size_t of[] = {find_light(s), find_thick(s), find_point(s)};
    const enum motion_flaw flaw[] = {MOTION_LIGHT, MOTION_THICK,
                                     MOTION_POINTS};
    if ((s->wall[0] || s->wall[1] || s->wall[2]) && !s->contact)
        return MOTION_WALLS;
    if (s->touch != SCENE_SUDDEN && s->restitution != 1)
        return MOTION_TWICE;
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

/* Can the scene be set in motion? If not, says why. */
static bool check_scene(const char *program, const struct scene *s)
{
    char message[200];
    size_t body;
    switch (motion_flaw(s, &body)) {
    case MOTION_WELL: return true;
    case MOTION_WALLS:
        return complain(program, "the scene has walls but no line contact, "
                                 "without which nothing minds them");
    case MOTION_TWICE:
        return complain(program, "the scene has a line restitution, but "
                                 "contacts that are springs: a dashpot is "
                                 "what takes energy from them");
    case MOTION_LIGHT:
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
           : m->touches               ? m->touch.near
                                      : NULL;
}

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
    if (m->touches)
        touch_free(&m->touch);
    if (m->orbits)
        jacobi_free(&m->jacobi);
    stepping_free(&m->stepping);
    free(m->held);
    *m = (struct motion){0};
}

/* Does the method take several steps for one, so that no straight line
   leads back from its end? */
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

enum stepping_end motion_run(struct motion *m, uint64_t steps)
{
    enum stepping_end end = STEPPING_DONE;
    if (!m->collides && !m->touches && !m->outside)
        return stepping_run(&m->stepping, steps);
    for (; steps > 0 && end == STEPPING_DONE; --steps) {
        end = m->located ? impact_step(&m->impact, &m->collisions)
                         : step_once(m);
        if (end == STEPPING_DONE && m->touches && !is_split(m))
            spheres_watch(m->touch.near, m->stepping.x, m->stepping.v);
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

/* Makes *to a copy of n numbers, or NULL of NULL. false: no memory. */
static bool note(double **to, const double from[], size_t n)
{
    free(*to);
    *to = from ? malloc(n * sizeof *from) : NULL;
    if (*to)
        memcpy(*to, from, n * sizeof *from);
    return !*to == !from;
}

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

static double weigh(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; s->gravity[k] != 0 && i < n; ++i)
            if (s->freedom[k * n + i])
                sum -= s->mass[i] * s->gravity[k] * s->position[k * n + i];
    return sum;
}

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
    if (m->touches)
        springs += touch_potential(&m->touch, x);
    return (struct motion_energy){
        motion_kinetic(m),
        m->attracts ? gravity_potential(&m->gravity, x) : 0, springs,
        weigh(m->scene)};
}

double motion_potential(const struct motion *m)
{
    const struct motion_energy e = motion_energy(m);
    return e.gravity + e.springs + e.weight;
}
