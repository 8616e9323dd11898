/* Computes scenes in time steps, by any of the methods of chapter 8. */
#include "choosing/models_parts.h"

#include "choosing/particles.h"
#include "forces/adaptive.h"
#include "forces/motion.h"
#include "forces/rods.h"

#include <math.h>
#include <stdlib.h>

/* Returns why no stepping method can compute the scene, or NULL. Rods and
   friction exclude each other. Only leapfrog supports rods, and for
   friction it would need a velocity that it has not yet computed. */
static const char *refuse_steps(const struct scene *s,
                                const struct models_acts *a)
{
    if (models_points_meet(s, a))
        return models_unseen;
    switch (motion_flaw(s, NULL)) {
    case MOTION_WALLS: return "there are walls, but no contact";
    case MOTION_MASSLESS: return "a body has no mass";
    case MOTION_RESTITUTION: return "contacts are springs";
    case MOTION_POINTS: return models_unseen;
    case MOTION_THICK: return "a body is thicker than the box";
    case MOTION_WELL: break;
    }
    return (a->cuts & MODELS_RODS) && (a->friction || a->dashpots)
               ? "rods and friction do not go together"
               : NULL;
}

/* Sorts the bodies by their distance from the central body. Methods that
   move bodies on ellipses need this order, and the order in a scene file is
   arbitrary. Returns false if memory runs out. */
static bool order_outwards(struct particles *l, const struct scene *s)
{
    return particles_create(l, s, INFINITY,
                            models_central_body(s, ALL_AXES), false);
}

/* Copies masses, positions and velocities, and sorts the bodies by `order`.
   If `back`, restores their original order instead. */
static void permute(struct scene *to, const struct scene *from,
                    const uint32_t order[], bool back)
{
    const size_t n = to->bodies;
    for (size_t i = 0; i < n; ++i) {
        const size_t b = back ? order[i] : i, c = back ? i : order[i];
        to->mass[b] = from->mass[c];
        for (size_t k = 0; k < 3 * n; k += n) {
            to->position[k + b] = from->position[k + c];
            to->velocity[k + b] = from->velocity[k + c];
        }
    }
}

static const char *refuse_orbits(const struct scene *s,
                                 const struct models_acts *a)
{
    const char *why = refuse_steps(s, a);
    struct scene other = {0};
    struct particles inside;
    if (why)
        return why;
    why = models_no_memory;
    if (scene_copy(&other, s) && order_outwards(&inside, s)) {
        permute(&other, s, inside.order, false);
        why = jacobi_refuses(&other);
        particles_free(&inside);
    }
    scene_free(&other);
    return why;
}

/* A run in time steps, with or without rods. */
struct steps {
    struct motion motion;
    struct scene scene; /* moving copy; its address must not change */
    struct models_plan plan;
    struct particles particles;
    struct rods rods;
    bool has_particles, ordered, rodded;
};

/* Frees the motion before the scene to which it refers. */
static void end_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    if (t->has_particles || t->ordered)
        particles_free(&t->particles);
    if (t->rodded)
        rods_free(&t->rods);
    motion_end(&t->motion);
    scene_free(&t->scene);
}

/* Returns whether momentum is conserved, as Jacobi coordinates require:
   nothing is fixed, and only gravity acts. */
static bool keeps_momentum(const struct scene *s,
                           const struct models_acts *a)
{
    for (size_t i = 0; i < s->bodies; ++i)
        if (a->axes & ~freedom_of(s, i))
            return false;
    return !a->contact && !a->springs && !a->friction;
}

/* Returns whether a close passage of two bodies must limit the time step,
   because it may move one of them by more than `negligible` in the
   remaining time (12.13, eq:choose-passage). a2 is the square of the
   relative acceleration. The closest distance is estimated from straight
   paths, and is reduced by the deflection of these paths. */
static bool passage_counts(const struct steps *t, const struct pair *p,
                           double pull, double a2)
{
    const double tau = fabs(p->rv) / p->v2;
    const double bend = sqrt(a2) * tau * tau / 2;
    const double b = fmax(sqrt(pair_nearest2(p)) - bend, 0);
    return 2 * pull * t->plan.time_left >
           t->plan.negligible * b * sqrt(p->v2);
}

/* Returns 1/T (in 1/s), where T is the shorter of two times: the time in
   which two bodies at their present relative velocity move by 0.7 of their
   distance, and the time in which they approach by as much with their
   present acceleration. */
static double passage_rate(const struct pair *p, double a2)
{
    const double way = 0.7 * sqrt(p->r2), fall = 2 * sqrt(a2) * way;
    const double nearer = fmax(-p->rv, 0) / sqrt(p->r2);
    return fmax(sqrt(p->v2), (nearer + sqrt(nearer * nearer + fall)) / 2) /
           way;
}

/* Returns the longest time step (in s) that cannot miss a close passage
   for which passage_counts is true. */
static double longest_step(void *what, const double x[], const double v[],
                           const double a[])
{
    const struct steps *t = what;
    const struct scene *s = &t->scene;
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = 0; j < i; ++j) {
            const double pull = s->k2 * (s->mass[i] + s->mass[j]);
            if (pull == 0 || !(freedom_of(s, i) || freedom_of(s, j)))
                continue;
            const struct pair p = pair_of(s, i, j, x, v);
            const double a2 = pair_of(s, i, j, a, a).r2;
            const double rate = passage_rate(&p, a2);
            if (rate > most && passage_counts(t, &p, pull, a2))
                most = rate;
        }
    return most > 0 ? 1 / most : INFINITY;
}

/* Returns the number of steps per row. For an adaptive method this is the
   number of calls. It is one, or LOOKS in scenes with contacts, because a
   call handles only a limited number of contacts. */
static uint64_t steps_of(const struct models_run *r)
{
    enum { LOOKS = 8 };
    if (!r->plan.model->method->adaptive)
        return r->plan.steps;
    return r->scene.contact ? LOOKS : 1;
}

/* Begins a run. Returns NULL, or why it fails.

   Springs that become rods are removed first, so they exert no forces.
   Without rods, contacts are located within a step. With
   MODELS_NO_LIGHT, light bodies move in Jacobi coordinates: only the heavy
   bodies are sources of gravity, and the acceleration of each body gets a
   factor. */
static const char *begin_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    struct scene *s = &t->scene;
    const struct models_plan *p = &t->plan;
    const size_t count = r->plan.cuts & MODELS_RODS
                             ? models_take_stiff(&r->scene, &r->origin)
                             : 0;
    t->plan = r->plan;
    if (!scene_copy(s, &r->scene))
        return models_no_memory;
    if (p->model->method->orbits) {
        if (!(t->ordered = order_outwards(&t->particles, &r->scene)))
            return models_no_memory;
        permute(s, &r->scene, t->particles.order, false);
    }
    if (!motion_begin(&t->motion, "models", s, p->model->name,
                      r->every / (double)steps_of(r)) ||
        (t->motion.collides && count == 0 && !motion_locate(&t->motion)))
        return models_no_memory;
    t->motion.impact.least = p->contact_margin;
    if (p->model->method->adaptive) {
        t->motion.stepping.tolerance = p->tolerance;
        t->motion.stepping.own->slack = p->slack;
        if (t->motion.attracts && p->negligible > 0) {
            t->motion.stepping.own->longest = longest_step;
            t->motion.stepping.own->with = t;
        }
    }
    if (t->motion.attracts && (p->cuts & MODELS_NO_LIGHT)) {
        struct gravity *g = &t->motion.gravity;
        t->has_particles =
            particles_create(&t->particles, s, models_heaviest(s),
                             s->bodies, keeps_momentum(s, &r->acts));
        if (!t->has_particles)
            return models_no_memory;
        particles_to_jacobi(&t->particles, s, s->position, s->velocity);
        g->source = t->particles.order;
        g->sources = t->particles.heavy;
        g->factor = t->particles.factor;
        /* sorting and the Jacobi coordinates cost as much as 5 sorts */
        models_count_sorting(r, s->bodies, 5);
    }
    if (count > 0) {
        t->rodded =
            rods_create(&t->rods, s, r->scene.spring + r->scene.springs,
                        count, t->motion.stepping.forces);
        t->motion.outside = rods_step;
        t->motion.with = &t->rods;
        if (!t->rodded)
            return models_no_memory;
    }
    return NULL;
}

/* Returns the number of pairs in an evaluation of gravity, weighted by
   their cost. For up to 32 bodies each pair is computed once. For more
   bodies each pair is computed twice, but eight are computed at once
   and count as one. With MODELS_NO_LIGHT, each heavy body attracts all
   others. */
static double count_pulls(const struct steps *t)
{
    const double n = (double)t->motion.scene->bodies;
    if (!t->motion.attracts)
        return 0;
    if (t->has_particles)
        return (n - 1) * (double)t->particles.heavy;
    return n <= 32 ? n * (n - 1) / 2 : n * (n - 1) / 8;
}

/* Returns the measured cost of an evaluation with n bodies, as a number of
   updates of a body (MODELS_BODY). A stage of an explicit method combines
   all previous stages. An implicit method combines all stages repeatedly.
   An embedded pair also estimates its error. */
static double body_passes(const struct stepping_method *m, double n)
{
    switch (m->family) {
    case STEPPING_EXPLICIT: return 2 * n;
    case STEPPING_IMPLICIT: return (2 + (double)m->stages) * n;
    case STEPPING_PAIR: return 8 * n;
    case STEPPING_RADAU: return 4 * (n + 8);
    default: return n;
    }
}

/* Cost of a spring outside all bands, relative to one in a band. It is high
   because the forces of such springs are scattered in memory. All springs
   of a pendulum and most springs of a small beam are outside bands. */
enum { LISTED = 10 };

/* Counts the work of `asked` force evaluations. */
static void count_evaluations(const struct models_run *r,
                              const struct steps *t, double asked,
                              double work[MODELS_UNITS])
{
    const struct springs *p = &t->motion.springs;
    const double n = (double)r->scene.bodies;
    work[MODELS_EVALUATION] = asked;
    work[MODELS_BODY] = asked * body_passes(r->plan.model->method, n);
    work[MODELS_PAIR] = asked * count_pulls(t);
    work[MODELS_SPRING] =
        asked * ((double)p->count + (LISTED - 1) * (double)p->listed);
}

/* Cost of converting a body from Jacobi coordinates for a row, as a number
   of updates of a body (MODELS_BODY). */
enum { LEAVING = 5 };

/* Computes the total work since the start from the counts of all modules.

   An adaptive method evaluates its polynomial at the end of each call, at
   the cost of eighteen updates of a body. Solving Kepler's equation costs
   only 0.8 of its price, because successive points on an ellipse are close
   together.

   If contacts are located, a step is divided into parts. Each part has
   a path for every body, pairs that are close along the widest axis, the
   polynomials of their gaps, and roots. If contacts are handled only
   after each step, as with rods, the cost is 0.3 of this.

   With rods, all corrections are counted, plus three passes over all rods
   in each step. */
static void count_steps(struct models_run *r, const struct steps *t)
{
    const struct stepping *p = &t->motion.stepping;
    const struct stepping_method *method = p->method;
    const double n = (double)r->scene.bodies, steps = (double)p->steps;
    count_evaluations(
        r, t, (double)(t->rodded ? t->rods.evaluations : p->evaluations),
        r->work);
    if (method->adaptive)
        r->work[MODELS_BODY] += 18 * n * steps;
    if (t->has_particles)
        r->work[MODELS_BODY] += LEAVING * n * ((double)r->rows + 1);
    if (t->motion.orbits)
        r->work[MODELS_ELLIPSE] =
            0.8 * (n - 1) * steps * (double)method->drifts;
    const struct impact *const i = &t->motion.impact;
    if (t->motion.located) {
        r->work[MODELS_CONTACT] = n * (double)i->parts;
        r->work[MODELS_OVERLAP] = (double)i->pairs;
        r->work[MODELS_CURVE] = (double)i->curves;
        r->work[MODELS_ROOT] = (double)i->roots;
    } else if (t->motion.collides) {
        r->work[MODELS_CONTACT] = 0.3 * n * steps;
        r->work[MODELS_OVERLAP] = 0.3 * (double)t->motion.spheres.tested;
    }

    if (t->rodded)
        r->work[MODELS_ROD] =
            (double)t->rods.corrections + 3 * steps * (double)t->rods.count;
}

enum { STEPS_AT_A_TIME = 256 };

/* Returns whether the run, extrapolated from its cost so far, will exceed
   its cost limit by a tenth. For an adaptive method the
   predicted cost must be twice the limit: the cost varies along the run,
   and the last step may end beyond the row. */
static bool is_hopeless(const struct models_run *r, const struct steps *t,
                        uint64_t left)
{
    const double row = (double)steps_of(r);
    const struct adaptive *own = t->motion.stepping.own;
    const double done = (double)r->rows + (row - (double)left) / row;
    const double cost = models_cost(r->work), all = (double)r->all;
    return own ? cost > fmin(r->limit / 2, 1) &&
                     cost / fmax(done, own->t / r->every) * all >
                         2 * r->limit
               : cost / done * all > 1.1 * r->limit;
}

/* Limits the evaluations in a call of an adaptive method. A call must not
   exceed the rest of the cost limit. If the number of rows is known, a
   single row must not use up the whole limit either. So a call costs at
   most eight times its equal share of the limit, or 0.1 s if this is
   more. */
static void bound_evaluations(const struct models_run *r, struct steps *t)
{
    struct adaptive *own = t->motion.stepping.own;
    const double cost = models_cost(r->work), left = r->limit - cost;
    const double one = 8 * r->limit / (double)(r->all * steps_of(r));
    const double may = r->all > 0 ? fmin(left, fmax(one, 0.1)) : left;
    double work[MODELS_UNITS] = {0};
    count_evaluations(r, t, 1, work);
    if (t->motion.located && cost == 0) {
        const double n = (double)r->scene.bodies;
        /* guess: all pairs, in every fourth evaluation */
        work[MODELS_CONTACT] = n / 4;
        work[MODELS_OVERLAP] = n * (n - 1) / 8;
    }
    const double asked = fmax(r->work[MODELS_EVALUATION], 1);
    const double more = may / fmax(models_cost(work), cost / asked);
    own->most = more < 1e15 ? own->evaluations + (uint64_t)more + 100 : 0;
}

/* Takes the steps of a row, and checks the cost after every few steps. */
static enum models_end run_steps(struct models_run *r, struct steps *t)
{
    const struct adaptive *own = t->motion.stepping.own;
    uint64_t now, left = steps_of(r);
    for (; left > 0; left -= now) {
        now = own ? 1 : left < STEPS_AT_A_TIME ? left : STEPS_AT_A_TIME;
        if (own)
            bound_evaluations(r, t);
        const enum stepping_end end = motion_run(&t->motion, now);
        count_steps(r, t);
        if (end != STEPPING_DONE)
            return own && own->most > 0 && own->evaluations > own->most
                       ? MODELS_COSTLY
                   : t->motion.impact.crowded ? MODELS_STANDSTILL
                                              : MODELS_BROKEN;
        if (models_is_costly(r) || is_hopeless(r, t, left - now))
            return MODELS_COSTLY;
    }
    return MODELS_DONE;
}

/* Moves to the next row. If the run uses Jacobi coordinates, it keeps them,
   and only the row is converted back. With rods, the relative velocities
   along them are removed at the end of each row. */
static enum models_end row_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    const enum models_end end = run_steps(r, t);
    const struct scene *s = t->motion.scene;
    if (end == MODELS_DONE && t->rodded &&
        !rods_project(&t->rods, s->position, s->velocity))
        return MODELS_BROKEN;
    if (t->ordered)
        permute(&r->scene, s, t->particles.order, true);
    else
        scene_take_state(&r->scene, s);
    if (t->has_particles)
        particles_from_jacobi(&t->particles, s, r->elapsed,
                              r->scene.position, r->scene.velocity);
    r->collisions = t->motion.collisions;
    r->least = t->motion.impact.least;
    r->virial = t->motion.collides ? t->motion.spheres.virial : 0;
    return end;
}

/* Makes the model of a stepping method from its row in the table of chapter
   8. Only leapfrog supports rods. Methods with ellipses do not support test
   particles. */
struct models_model models_of_method(const struct stepping_method *m)
{
    const unsigned no = (m->orbits ? BEARS_PARTICLES : 0) |
                        (stepping_is_leapfrog(m) ? 0 : BEARS_RODS);
    return (struct models_model){.name = m->name,
                                 .about = m->about,
                                 .family = MODELS_STEPS,
                                 .bears = BEARS_ALL & ~no,
                                 .engine = sizeof(struct steps),
                                 .row = row_steps,
                                 .begin = begin_steps,
                                 .end = end_steps,
                                 .refuses = m->orbits ? refuse_orbits
                                                      : refuse_steps,
                                 .method = m};
}
