/* Models in closed form: free motion, ellipses, vibrations. */
#include "choosing/models_parts.h"

#include "choosing/closed.h"
#include "choosing/particles.h"
#include "forces/kepler.h"
#include "forces/largest.h"
#include "forces/modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Every row is computed from the start, so errors do not add up from row to
   row. */

/* Work of moving a coordinate with friction, relative to free motion. */
enum { WITH_EXPONENTIAL = 10 };

static enum models_end row_free(struct models_run *r)
{
    struct scene *s = &r->scene;
    const size_t n = s->bodies;
    scene_take_state(s, &r->origin);
    for (size_t c = 0; c < 3 * n; ++c)
        if (s->freedom[c])
            closed_fly(r->elapsed,
                       s->damping > 0 ? s->damping / s->mass[c % n] : 0,
                       s->gravity[c / n], &s->position[c], &s->velocity[c]);
    r->work[MODELS_FLIGHT] +=
        (double)(3 * n) * (s->damping > 0 ? WITH_EXPONENTIAL : 1);
    return MODELS_DONE;
}

const struct models_model models_free = {
    .name = "free",
    .about = "every body flies alone, in closed form",
    .family = MODELS_CLOSED,
    .bears = BEARS_FRICTION,
    .engine = 1,
    .row = row_free};

/* Returns whether only the central body attracts bodies that can move, and
   all other bodies are free along all axes of the motion. Otherwise a body
   would not move on an ellipse: a body that is free along x but not along y
   slides on a wire.

   Bodies without mass do not attract, and with MODELS_NO_LIGHT neither do
   light bodies. For two bodies the formula includes both attractions (12.3,
   eq:light-ellipse). */
static bool is_central(const struct scene *s, const struct models_acts *a,
                       size_t centre)
{
    const unsigned axes = a->axes;
    const bool held = !(freedom_of(s, centre) & axes);
    const double most = models_heaviest(s);
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool quiet = s->mass[i] == 0 ||
                           ((a->cuts & MODELS_NO_LIGHT) &&
                            particles_is_light(s, i, most)) ||
                           s->bodies == 2;
        if (i != centre && (!quiet || axes & ~freedom_of(s, i)))
            return false;
    }
    return held || !(axes & ~freedom_of(s, centre));
}

/* Uniform gravity is allowed if all bodies can fall, since it does not
   change their relative motion. */
static const char *refuse_kepler(const struct scene *s,
                                 const struct models_acts *a)
{
    const size_t centre = models_central_body(s, a->axes);
    if (!a->gravity)
        return "nothing attracts";
    if (s->softening != 0)
        return "the attraction is softened";
    if (a->offset & ~a->axes)
        return "bodies are held beside the plane of their motion";
    if (!is_central(s, a, centre))
        return "more than one body pulls, or one is held";
    if (a->weight && !(freedom_of(s, centre) & a->axes))
        return "there is weight, and the centre is held";
    return NULL;
}

static void end_kepler(struct models_run *r)
{
    particles_free(r->engine);
}

/* Returns the positions at the start, followed by the velocities, in the
   order of the particles. */
static double *at_start(const struct models_run *r)
{
    const struct particles *l = r->engine;
    const struct scene *s = &r->origin;
    particles_gather(l, s, s->position, l->work);
    particles_gather(l, s, s->velocity, l->work + 3 * l->jacobi.bodies);
    return l->work;
}

/* The relative error of time that all twins share. 2 pi has a relative
   error of a third of 2^-53. Its product with the number of whole turns is
   rounded once. The number of turns is the same in all units. */
static const double clock_error = 0x1.6p-53;

/* Returns the relative error of time that all twins share. Returns INFINITY
   if this model cannot compute an orbit: a parabola, a hyperbola, or an
   ellipse so narrow that the body would practically fall into the centre.

   The result does not include the rounding error of the mean motion, which
   may be larger. That error depends on the last digits of r and v, so twins
   in other units reveal it. It is up to 13 a/r times 2^-53, since 1/a is
   the difference 2/r - v^2/mu of terms with relative errors of about 2^-53.
   The bound 4 a/r 2^-51 was tried for random orbits and was far too high:
   14 times the true error in the median, and 40 times for one orbit in
   ten. */
static double clock_of_ellipses(const struct models_run *r)
{
    const struct jacobi *j = &((const struct particles *)r->engine)->jacobi;
    const size_t n = j->bodies;
    double *const x = at_start(r), *const v = x + 3 * n;
    jacobi_enter(j, x, x);
    jacobi_enter(j, v, v);
    for (size_t i = 1; i < n; ++i) {
        const double q[3] = {x[i], x[n + i], x[2 * n + i]};
        const double w[3] = {v[i], v[n + i], v[2 * n + i]};
        double axis, eccentricity;
        kepler_shape(j->mu[i], q, w, &axis, &eccentricity);
        if (!(axis > 0 && axis < INFINITY && eccentricity < 1 - 1e-9))
            return INFINITY;
    }
    return clock_error;
}

static const char *begin_kepler(struct models_run *r)
{
    const size_t centre = models_central_body(&r->scene, r->acts.axes);
    const bool moving = freedom_of(&r->scene, centre) & r->acts.axes;
    if (!particles_create(r->engine, &r->scene, INFINITY, centre, moving))
        return models_no_memory;
    r->clock = clock_of_ellipses(r);
    return r->clock < INFINITY ? NULL
                               : "an orbit is open, or as good as a fall";
}

/* Computes a row from the start by a single drift of Wisdom and Holman's
   method. A drift may cover any number of turns, so its cost does not
   depend on the time. Uniform gravity adds the same fall to all bodies. */
static enum models_end row_kepler(struct models_run *r)
{
    const struct particles *l = r->engine;
    struct jacobi j = l->jacobi;
    struct scene *s = &r->scene;
    const size_t n = j.bodies;
    double *const x = at_start(r), *const v = x + 3 * n, t = r->elapsed;
    jacobi_flow(&j, t, x, v);
    for (size_t c = 0; c < 3 * n; ++c) {
        const size_t to = at(s, c / n, l->order[c % n]);
        const double fall = s->freedom[to] ? s->gravity[c / n] * t : 0;
        s->position[to] = x[c] + fall / 2 * t;
        s->velocity[to] = v[c] + fall;
    }
    r->work[MODELS_ELLIPSE] += (double)(n - 1);
    return MODELS_DONE;
}

const struct models_model models_kepler = {
    .name = "kepler",
    .about = "ellipses round one body, in closed form",
    .family = MODELS_CLOSED,
    .bears = BEARS_GRAVITY | BEARS_PARTICLES,
    .engine = sizeof(struct particles),
    .row = row_kepler,
    .begin = begin_kepler,
    .end = end_kepler,
    .refuses = refuse_kepler};

/* Finding 400 modes takes a few seconds, and 1000 modes a minute. With so
   many modes other models are cheaper. */
enum { MOST_MODES = 400, MOST_TRIES = 30 };

/* Near equilibrium the motion of springs is a sum of modes, each of which
   is an oscillator. The error of this approximation is of second order in
   the displacement. It is found by a comparison with a run in time steps,
   since no formula gives it: a taut membrane has only linear modes, but a
   membrane at its rest length has hardly any.

   Friction is allowed if it damps all modes equally, that is, if c/m is the
   same for all bodies. Dashpots are allowed only with a single
   coordinate. */
static const char *refuse_modes(const struct scene *s,
                                const struct models_acts *a)
{
    double mass = 0;
    size_t coordinates = 0;
    if (!a->springs)
        return "no spring acts";
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        if (s->freedom[c] && (a->axes >> (c / s->bodies) & 1)) {
            const double m = s->mass[c % s->bodies];
            if (!(m > 0) || (a->friction && mass != 0 && m != mass))
                return m > 0 ? "friction mixes the modes of unequal masses"
                             : "a body has no mass";
            mass = m;
            ++coordinates;
        }
    if (a->dashpots && coordinates > 1)
        return "dashpots mix the modes";
    return coordinates > MOST_MODES ? "there are too many modes" : NULL;
}

/* On a line the motion is exactly linear as long as no spring reverses. A
   spring whose ends move sideways also gets longer, and the motion is then
   not linear. */
static const char *refuse_oscillator(const struct scene *s,
                                     const struct models_acts *a)
{
    return a->dimensions > 1 || (a->offset & ~a->axes)
               ? "it does not move along its springs only"
               : refuse_modes(s, a);
}

/* The modes of a scene, and their amplitudes. */
struct vibration {
    struct springs springs;
    struct modes modes;
    double *rest, *push;     /* [3 * bodies] equilibrium, m; [6 * bodies]
                                scratch */
    double *amount, *change; /* [size] amplitudes and their velocities at
                                the start */
    double *pull;            /* [size] force on each mode at equilibrium */
    double rate;             /* friction divided by mass, 1/s */
    double slack;            /* squared frequencies below this count as 0,
                                1/s^2 */
};

static void end_modes(struct models_run *r)
{
    struct vibration *w = r->engine;
    springs_free(&w->springs);
    modes_free(&w->modes);
    free(w->rest);
}

/* Improves the equilibrium positions w->rest by a Newton step: the modes
   at these positions give the displacement that cancels the remaining
   forces. Returns the largest displacement along an axis (in m), or NaN if
   memory runs out. Near equilibrium each step doubles the number of
   correct digits, so five or six steps are enough. */
static double approach_rest(struct vibration *w, struct models_run *r)
{
    const struct modes *m = &w->modes;
    const size_t n = 3 * r->scene.bodies;
    double *still = w->push, *gap = w->push + n;
    memset(still, 0, n * sizeof *still);
    springs_accelerate(&w->springs, w->rest, still, gap);
    modes_free(&w->modes);
    if (!modes_find(&w->modes, &w->springs, w->rest))
        return NAN;
    r->work[MODELS_MODE] += 20 * pow((double)m->size, 3);
    if (m->size == 0)
        return 0;
    w->slack = 1e-9 * fabs(m->square[m->size - 1]);
    modes_deflection(m, w->slack, gap, still);
    for (size_t i = 0; i < m->size; ++i)
        w->rest[m->coordinate[i]] += still[m->coordinate[i]];
    return largest(still, n);
}

/* Returns whether computing the modes once more would exceed the limit on
   the cost of starting the run. Each computation costs 20 times the cube
   of the number of free coordinates, and up to MOST_TRIES may be
   needed. */
static bool is_start_dear(const struct models_run *r)
{
    double work[MODELS_UNITS], size = 0;
    for (size_t c = 0; c < 3 * r->scene.bodies; ++c)
        size += r->scene.freedom[c] != 0;
    memcpy(work, r->work, sizeof work);
    work[MODELS_MODE] += 20 * pow(size, 3);
    return r->plan.start_limit > 0 &&
           models_cost(work) > r->plan.start_limit;
}

/* Moves w->rest to a stable equilibrium. Returns NULL, or why there is no
   stable equilibrium and thus no small vibration. At an unstable
   equilibrium the smallest squared frequency is clearly negative. */
static const char *find_rest(struct vibration *w, struct models_run *r)
{
    const double size = largest(w->rest, 3 * r->scene.bodies);
    double far = INFINITY;
    for (int k = 0; k < MOST_TRIES && !(far <= 1e-12 * size); ++k) {
        if (is_start_dear(r))
            return "its start costs more than is reasonable";
        far = approach_rest(w, r);
        if (!(far <= 10 * size))
            return "no place of rest was found";
    }
    if (!(far <= 1e-9 * size))
        return "no place of rest was found";
    return w->modes.size > 0 && w->modes.square[0] < -w->slack
               ? "the place of rest is not stable"
               : NULL;
}

/* Computes the amplitude of each mode in the displacement (x - `from`) or,
   if `from` is NULL, in the velocities x. Mode shapes are orthogonal, so
   each amplitude is a scalar product. */
static void take_apart(const struct modes *m, const double x[],
                       const double from[], double amount[])
{
    for (size_t j = 0; j < m->size; ++j) {
        amount[j] = 0;
        for (size_t i = 0; i < m->size; ++i) {
            const size_t c = m->coordinate[i];
            amount[j] += m->shape[j * m->size + i] *
                         (x[c] - (from ? from[c] : 0)) / sqrt(m->weight[i]);
        }
    }
}

/* Returns whether no spring with a rest length can reverse its direction on
   this axis.

   A spring that is longer or shorter by u than at equilibrium has the
   energy D u^2/2. This is at most the total energy of all modes, which
   friction only reduces. So a spring whose length at equilibrium is d
   cannot reverse if D d^2/2 exceeds this total. At the start it must also
   point in its direction at equilibrium. */
static bool keeps_sides(const struct vibration *w, const struct scene *s,
                        size_t axis)
{
    const double *x = s->position + axis * s->bodies;
    const double *rest = w->rest + axis * s->bodies;
    double twice = 0; /* twice the energy of all modes, J */
    for (size_t j = 0; j < w->modes.size; ++j)
        if (w->modes.square[j] > w->slack)
            twice += w->change[j] * w->change[j] +
                     w->modes.square[j] * w->amount[j] * w->amount[j];
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        const double D = s->kind[p->kind].stiffness,
                     d = rest[p->b] - rest[p->a];
        if (models_is_active(s, p) && p->rest != 0 && D > 0 &&
            !(d * (x[p->b] - x[p->a]) > 0 && D * d * d > twice))
            return false;
    }
    return true;
}

/* Finds the equilibrium, and the amplitudes of positions and velocities at
   the start. Fixes coordinates along axes without motion. Returns NULL, or
   why it fails. */
static const char *begin_modes(struct models_run *r)
{
    struct vibration *w = r->engine;
    struct scene *s = &r->scene;
    const size_t n = 3 * s->bodies;
    double damping = s->damping;
    for (size_t c = 0; c < n; ++c)
        s->freedom[c] &= r->acts.axes >> (c / s->bodies) & 1;
    w->rest = malloc((6 * n + 1) * sizeof *w->rest);
    if (!w->rest || !springs_create(&w->springs, s))
        return models_no_memory;
    w->push = w->rest + n;
    w->amount = w->rest + 3 * n;
    w->change = w->rest + 4 * n;
    w->pull = w->rest + 5 * n;
    memcpy(w->rest, s->position, n * sizeof *w->rest);
    const char *why = find_rest(w, r);
    if (why)
        return why;
    take_apart(&w->modes, s->position, w->rest, w->amount);
    take_apart(&w->modes, s->velocity, NULL, w->change);
    take_apart(&w->modes, w->push + n, NULL, w->pull);
    for (size_t j = 0; j < s->springs; ++j)
        if (models_is_active(s, &s->spring[j]))
            damping += s->kind[s->spring[j].kind].damping;
    for (size_t c = 0; c < n; ++c)
        if (s->freedom[c])
            w->rate = damping / s->mass[c % s->bodies];
    const struct modes *const m = &w->modes;
    if (m->size > 0 && m->square[m->size - 1] > w->slack)
        r->clock = clock_error;
    return r->plan.model->approximate ||
                   keeps_sides(w, s, first_axis(r->acts.axes))
               ? NULL
               : "a spring may turn round";
}

/* Every mode moves as an oscillator (12.5, eq:models-swing). Modes without
   stiffness, such as the centre of mass of a free chain, move freely under
   uniform gravity. */
static enum models_end row_modes(struct models_run *r)
{
    const struct vibration *w = r->engine;
    const struct modes *m = &w->modes;
    const double size = (double)m->size;
    struct scene *s = &r->scene;
    for (size_t i = 0; i < m->size; ++i) {
        s->position[m->coordinate[i]] = w->rest[m->coordinate[i]];
        s->velocity[m->coordinate[i]] = 0;
    }
    for (size_t j = 0; j < m->size; ++j) {
        double q = w->amount[j], p = w->change[j];
        if (m->square[j] > w->slack)
            closed_oscillate(r->elapsed, m->square[j], w->rate, &q, &p);
        else
            closed_fly(r->elapsed, w->rate, w->pull[j], &q, &p);
        for (size_t i = 0; i < m->size; ++i) {
            const double part =
                m->shape[j * m->size + i] * sqrt(m->weight[i]);
            s->position[m->coordinate[i]] += part * q;
            s->velocity[m->coordinate[i]] += part * p;
        }
    }
    r->work[MODELS_FLIGHT] += WITH_EXPONENTIAL * size;
    r->work[MODELS_MODE] += 2 * size * size;
    return MODELS_DONE;
}

const struct models_model models_oscillator = {
    .name = "oscillator",
    .about = "springs on one line, in closed form",
    .family = MODELS_CLOSED,
    .bears = BEARS_SPRINGS | BEARS_FRICTION,
    .engine = sizeof(struct vibration),
    .row = row_modes,
    .begin = begin_modes,
    .end = end_modes,
    .refuses = refuse_oscillator};

const struct models_model models_modes = {
    .name = "modes",
    .about = "small vibrations of springs about their rest",
    .family = MODELS_CLOSED,
    .bears = BEARS_SPRINGS | BEARS_FRICTION,
    .engine = sizeof(struct vibration),
    .row = row_modes,
    .begin = begin_modes,
    .end = end_modes,
    .refuses = refuse_modes,
    .approximate = true};
