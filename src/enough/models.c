/* From chapters/12-models.nw: edit there, then run make tangle. */
/* checksum 4053136694 of the lines below */
/* What acts, what can be left out, and how each model carries a scene. */
#include "enough/models.h"

#include "line/bonkers.h"
#include "box/cells.h"
#include "enough/closed.h"
#include "box/disks.h"
#include "forces/adaptive.h"
#include "forces/hard.h"
#include "forces/kepler.h"
#include "forces/largest.h"
#include "enough/light.h"
#include "forces/modes.h"
#include "forces/motion.h"
#include "forces/rods.h"
#include "forces/spheres.h"
#include "enough/pair.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct models_price models_prices[MODELS_UNITS] = {
    [MODELS_EVALUATION] = {"evaluation", "call of the forces", 18},
    [MODELS_BODY] = {"body", "body in a call of the forces", 3},
    [MODELS_PAIR] = {"pair", "pull between bodies", 6.5},
    [MODELS_SPRING] = {"spring", "force of a spring", 1.2},
    [MODELS_ROD] = {"rod", "correction of a rod", 15},
    [MODELS_CONTACT] = {"contact", "body looked at for contacts", 75},
    [MODELS_OVERLAP] = {"overlap", "pair looked at for a contact", 16},
    [MODELS_CURVE] = {"curve", "product for the curve of a gap", 4.9},
    [MODELS_ROOT] = {"root", "the same, if the curve has a root", 40},
    [MODELS_LINE_EVENT] = {"line-event", "collision on a line", 33},
    [MODELS_LINE_SCAN] = {"line-scan", "gap looked at for it", 0.3},
    [MODELS_DISK_EVENT] = {"disk-event", "collision of disks", 100},
    [MODELS_DISK_SCAN] = {"disk-scan", "disk looked at for it", 4.5},
    [MODELS_RENEWAL] = {"renewal", "list of a disk's neighbours", 450},
    [MODELS_ELLIPSE] = {"ellipse", "body moved along its ellipse", 210},
    [MODELS_FLIGHT] = {"flight", "coordinate moved freely", 3.6},
    [MODELS_ORDER] = {"order", "comparison of two bodies", 2.7},
    [MODELS_MODE] = {"mode", "operation on modes", 0.5},
    [MODELS_ROW] = {"row", "row of a run", 40},
};

double models_cost(const double work[MODELS_UNITS])
{
    double sum = 0;
    for (size_t k = 0; k < MODELS_UNITS; ++k)
        sum += work[k] * models_prices[k].ns;
    return sum / 1e9;
}

static size_t at(const struct scene *s, size_t k, size_t i)
{
    return k * s->bodies + i;
}

/* The first axis of a set; of none, x. */
static size_t first_axis(unsigned axes)
{
    return axes & 1 ? 0 : axes & 2 ? 1 : axes & 4 ? 2 : 0;
}

enum { ALL_AXES = 7 };

/* The axes along which body i may move. */
static unsigned freedom_of(const struct scene *s, size_t i)
{
    unsigned axes = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        axes |= (unsigned)(s->freedom[at(s, k, i)] != 0) << k;
    return axes;
}

/* Is there a body that can be pulled by another? */
static bool attracts(const struct scene *s)
{
    size_t pulling = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        pulling += s->mass[i] > 0;
    for (size_t i = 0; s->k2 != 0 && i < s->bodies; ++i)
        if (freedom_of(s, i) && pulling > (s->mass[i] > 0))
            return true;
    return false;
}

static bool is_active(const struct scene *s, const struct scene_spring *p)
{
    const struct scene_kind *kind = &s->kind[p->kind];
    return (kind->stiffness != 0 || kind->damping != 0) &&
           (freedom_of(s, p->a) || freedom_of(s, p->b));
}

/* Body j as body i sees it, if they are at x and move at v. */
static struct pair pair_of(const struct scene *s, size_t i, size_t j,
                           const double x[], const double v[])
{
    struct pair p = {.r2 = 0};
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t a = at(s, k, i), b = at(s, k, j);
        pair_add(&p, x[b] - x[a],
                 (s->freedom[b] ? v[b] : 0) - (s->freedom[a] ? v[a] : 0));
    }
    return p;
}

double models_square(const struct scene *s, size_t i, size_t j)
{
    return pair_of(s, i, j, s->position, s->velocity).r2;
}

void models_analyse(struct models_acts *a, const struct scene *s)
{
    const size_t n = s->bodies;
    unsigned free = 0, moves = 0, falls = 0, spread = 0, stretched = 0;
    *a = (struct models_acts){.gravity = attracts(s),
                              .friction = s->damping != 0};
    for (size_t i = 0; i < n; ++i)
        a->free += freedom_of(s, i) != 0;
    for (size_t c = 0; c < 3 * n; ++c) {
        const unsigned axis = 1u << c / n;
        spread |= s->position[c] != s->position[c / n * n] ? axis : 0;
        if (!s->freedom[c])
            continue;
        free |= axis;
        moves |= s->velocity[c] != 0 ? axis : 0;
        falls |= s->gravity[c / n] != 0 ? axis : 0;
    }
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        if (!is_active(s, p))
            continue;
        a->springs = true;
        a->dashpots |= s->kind[p->kind].damping != 0;
        for (size_t k = 0; k < SCENE_AXES; ++k)
            stretched |= (unsigned)(s->position[at(s, k, p->a)] !=
                                    s->position[at(s, k, p->b)])
                         << k;
    }
    a->weight = falls != 0;
    a->contact =
        s->contact && (n > 1 || s->wall[0] || s->wall[1] || s->wall[2]);
    const unsigned pushed =
        falls | (a->gravity || a->contact ? spread : 0) | stretched;
    a->axes = moves | (free & pushed);
    a->offset = spread;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        a->dimensions += a->axes >> k & 1;
}

static double heaviest(const struct scene *s)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        most = fmax(most, s->mass[i]);
    return most;
}

/* The square of the frequency of two bodies, if they circled. */
static double square_of_pair(const struct scene *s, size_t i, size_t j)
{
    const double square =
        s->softening * s->softening + models_square(s, i, j);
    return s->k2 * (s->mass[i] + s->mass[j]) / (square * sqrt(square));
}

enum { MOST_PAIRED = 4000 };

/* Of the fastest pair; of very many bodies, of pairs with a heavy one. */
static double square_of_gravity(const struct scene *s)
{
    const double heavy = heaviest(s);
    const bool all = s->bodies <= MOST_PAIRED;
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (all || !light_is(s, i, heavy))
            for (size_t j = all ? i + 1 : 0; j < s->bodies; ++j)
                if (j != i)
                    most = fmax(most, square_of_pair(s, i, j));
    return most;
}
/* Adds what a spring puts into the rows of its two bodies: its strength
   over their mass, and over the root of both masses. */
static void add_rows(const struct scene *s, const struct scene_spring *p,
                     double row[], double strength)
{
    const size_t end[2] = {p->a, p->b};
    double weight[2];
    for (int e = 0; e < 2; ++e) {
        const double m = s->mass[end[e]];
        weight[e] = freedom_of(s, end[e]) && m > 0 ? 1 / m : 0;
    }
    for (int e = 0; e < 2; ++e)
        row[end[e]] += strength * (weight[e] + sqrt(weight[0] * weight[1]));
}

/* How stiff a spring is, along or across. */
static double stiffness(const struct scene *s, const struct scene_spring *p)
{
    const double length = sqrt(models_square(s, p->a, p->b));
    const double across = fabs(1 - p->rest / length);
    return s->kind[p->kind].stiffness *
           (across > 1 && across < INFINITY ? across : 1);
}

/* Stiff springs have more stiffness than this; INFINITY if none is. */
static double stiff_from(const struct scene *s)
{
    double least = INFINITY, most = 0;
    for (size_t j = 0; j < s->springs; ++j) {
        const double stiffness = s->kind[s->spring[j].kind].stiffness;
        if (stiffness > 0 && is_active(s, &s->spring[j])) {
            least = fmin(least, stiffness);
            most = fmax(most, stiffness);
        }
    }
    return least == most ? 0 : 100 * least;
}

static bool is_stiff(const struct scene *s, const struct scene_spring *p,
                     double from)
{
    return is_active(s, p) && s->kind[p->kind].stiffness > from;
}

double models_rate(const struct scene *s, unsigned cuts)
{
    double square = 0, rate = 0, turning = 0, slow = 0;
    double *row = calloc(2 * s->bodies + 1, sizeof *row);
    const double from = cuts & MODELS_RODS ? stiff_from(s) : INFINITY;
    if (!row)
        return INFINITY;
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        if (is_stiff(s, p, from)) {
            const struct pair ends =
                pair_of(s, p->a, p->b, s->position, s->velocity);
            turning = fmax(turning, sqrt(ends.v2 / ends.r2));
            continue;
        }
        add_rows(s, p, row, stiffness(s, p));
        add_rows(s, p, row + s->bodies, s->kind[p->kind].damping);
    }
    for (size_t i = 0; i < s->bodies; ++i) {
        square = fmax(square, row[i]);
        rate = fmax(rate, row[s->bodies + i]);
        if (s->mass[i] > 0)
            slow = fmax(slow, s->damping / s->mass[i]);
    }
    free(row);
    if (attracts(s))
        square += square_of_gravity(s);
    return fmax(sqrt(square) + rate + slow, turning);
}

const char *const models_cut_names[MODELS_CUTS + 1] = {
    "no-light", "rods",      "no-softening", "no-friction", "no-dashpots",
    "no-weak",  "no-weight", "no-pull",      "no-across",   NULL};

static void flatten(struct scene *s)
{
    const size_t n = s->bodies;
    double far = 0;
    size_t axis = 0;
    for (size_t c = 0; c < 3 * n; ++c) {
        const double way = fabs(s->position[c] - s->position[c / n * n]);
        axis = way > far ? c / n : axis;
        far = fmax(far, way);
    }
    for (size_t c = 0; c < 3 * n; ++c)
        if (c / n != axis) {
            s->position[c] = s->position[c / n * n];
            s->velocity[c] = 0;
            s->freedom[c] = 0;
        }
}

/* Makes 0 what is left out of the scene's own numbers. */
static void leave_out(struct scene *s, unsigned cuts)
{
    double most = 0;
    if (cuts & MODELS_NO_ACROSS)
        flatten(s);
    s->softening *= !(cuts & MODELS_NO_SOFTENING);
    s->damping *= !(cuts & MODELS_NO_FRICTION);
    s->k2 *= !(cuts & MODELS_NO_PULL);
    for (size_t k = 0; k < SCENE_AXES; ++k)
        s->gravity[k] *= !(cuts & MODELS_NO_WEIGHT);
    for (size_t j = 0; j < s->kinds; ++j)
        most = fmax(most, s->kind[j].stiffness);
    for (size_t j = 0; j < s->kinds; ++j) {
        const bool weak =
            (cuts & MODELS_NO_WEAK) && s->kind[j].stiffness * 100 < most;
        s->kind[j].stiffness *= !weak;
        s->kind[j].damping *= !weak && !(cuts & MODELS_NO_DASHPOTS);
    }
}

unsigned models_cuts(const struct scene *s)
{
    const double from = stiff_from(s), most = heaviest(s);
    const bool pulls = attracts(s);
    unsigned cuts = 0;
    for (size_t i = 0; pulls && i < s->bodies; ++i)
        if (s->mass[i] > 0 && light_is(s, i, most))
            cuts = MODELS_NO_LIGHT;
    for (size_t j = 0; j < s->springs; ++j)
        cuts |= is_stiff(s, &s->spring[j], from) ? MODELS_RODS : 0;
    return cuts;
}

/* Moves the stiff springs behind the others, out of the list. Returns how
   many those are. */
static size_t take_stiff(struct scene *s, const struct scene *origin)
{
    const double from = stiff_from(origin);
    size_t n = 0;
    for (int stiff = 0; stiff < 2; ++stiff) {
        s->springs = n;
        for (size_t j = 0; j < origin->springs; ++j)
            if (is_stiff(origin, &origin->spring[j], from) == stiff)
                s->spring[n++] = origin->spring[j];
    }
    return n - s->springs;
}

static const char no_memory[] = "there is no memory";

/* What acts, bit by bit, and what is said to those who cannot bear it. */
enum { RODS = 1, PULLERS = 2, SPRINGS = 4, PULLS = 8, MEETING = 16 };
enum { FRICTION = 32, ACTS = 6, ALL_ACTS = 63 };
static const char *const unborne[ACTS] = {
    "it knows no rods", "it does not ask who pulls",
    "springs act",      "the bodies attract each other",
    "bodies may meet",  "there is friction"};

/* NULL: the model carries the scene; or why not. */
static const char *refusal(const struct models_run *r)
{
    const struct models_model *m = r->plan.model;
    const struct models_acts *a = &r->acts;
    const unsigned cuts = a->cuts;
    const bool acts[ACTS] = {cuts & MODELS_RODS, cuts & MODELS_NO_LIGHT,
                             a->springs,         a->gravity,
                             a->contact,         a->friction};
    for (unsigned k = 0; k < ACTS; ++k)
        if (acts[k] && !(m->bears >> k & 1))
            return unborne[k];
    return m->refuses ? m->refuses(&r->scene, a) : NULL;
}

enum { WITH_EXPONENTIAL = 10 }; /* what such a flight costs, in flights */

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

/* The body in the middle: one that is held, or else the heaviest. */
static size_t central_body(const struct scene *s, unsigned axes)
{
    size_t best = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (!(freedom_of(s, i) & axes) && s->mass[i] > 0)
            return i;
        else if (s->mass[i] > s->mass[best])
            best = i;
    return best;
}

/* Do all but the central body pull nobody who could give way? */
static bool is_central(const struct scene *s, const struct models_acts *a,
                       size_t centre)
{
    const unsigned axes = a->axes;
    const bool held = !(freedom_of(s, centre) & axes);
    const double most = heaviest(s);
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool quiet =
            s->mass[i] == 0 ||
            ((a->cuts & MODELS_NO_LIGHT) && light_is(s, i, most)) ||
            s->bodies == 2;
        if (i != centre && (!quiet || axes & ~freedom_of(s, i)))
            return false;
    }
    return held || !(axes & ~freedom_of(s, centre));
}

static const char *refuse_kepler(const struct scene *s,
                                 const struct models_acts *a)
{
    const size_t centre = central_body(s, a->axes);
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
    light_free(r->engine);
}

/* Places at the start, followed by velocities. */
static double *at_start(const struct models_run *r)
{
    const struct light *l = r->engine;
    const struct scene *s = &r->origin;
    light_gather(l, s, s->position, l->room);
    light_gather(l, s, s->velocity, l->room + 3 * l->jacobi.bodies);
    return l->room;
}

/* By what share of the time all clocks may be late alike, whatever the
   units: 2 pi is wrong by a third of 2^-53, and its product with the number
   of whole turns, which is the same in all units, is rounded once. */
static const double late_alike = 0x1.6p-53;

/* By what share of the time the places on ellipses may be late alike in all
   units; INFINITY: an orbit is none. What rounding makes of the mean motion
   is not in it. That is more, for 1/a is the difference 2/r - v^2/mu, of
   which either is wrong by some 2^-53, so that the mean motion is wrong by
   up to 13 a/r of them; but it depends on the last digits of r and v, so
   that twins in other units differ by it. A bound of that, 4 a/r 2^-51,
   added up what hardly ever adds up: it was 14 times the error that was
   made, median of random orbits, and 40 times that of one in ten. */
static double clock_of_ellipses(const struct models_run *r)
{
    const struct jacobi *j = &((const struct light *)r->engine)->jacobi;
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
    return late_alike;
}

static const char *begin_kepler(struct models_run *r)
{
    const size_t centre = central_body(&r->scene, r->acts.axes);
    const bool moving = freedom_of(&r->scene, centre) & r->acts.axes;
    if (!light_create(r->engine, &r->scene, INFINITY, centre, moving))
        return no_memory;
    r->clock = clock_of_ellipses(r);
    return r->clock < INFINITY ? NULL
                               : "an orbit is open, or as good as a fall";
}

static enum models_end row_kepler(struct models_run *r)
{
    const struct light *l = r->engine;
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

enum { MOST_MODES = 400, MOST_TRIES = 30 };

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

static const char *refuse_oscillator(const struct scene *s,
                                     const struct models_acts *a)
{
    return a->dimensions > 1 || (a->offset & ~a->axes)
               ? "it does not move along its springs only"
               : refuse_modes(s, a);
}

/* Modes, and how much of each there is. */
struct vibration {
    struct springs springs;
    struct modes modes;
    double *rest, *push;     /* [3 * bodies], [6 * bodies] */
    double *amount, *change; /* [size] of each mode at the start */
    double *pull;            /* [size] what pulls at it where it rests */
    double rate;             /* of friction, 1/s */
    double slack;            /* squares below that are none, 1/s^2 */
};

static void end_modes(struct models_run *r)
{
    struct vibration *w = r->engine;
    springs_free(&w->springs);
    modes_free(&w->modes);
    free(w->rest);
}

/* One of Newton's steps towards the place of rest, from w->rest. Returns
   how far it has led, or NaN without memory. */
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

/* Would finding the modes once more bring the bill of the start above what
   it may be? It costs the cube of the coordinates, up to thirty times. */
static bool is_start_dear(const struct models_run *r)
{
    double work[MODELS_UNITS], size = 0;
    for (size_t c = 0; c < 3 * r->scene.bodies; ++c)
        size += r->scene.freedom[c] != 0;
    memcpy(work, r->work, sizeof work);
    work[MODELS_MODE] += 20 * pow(size, 3);
    return r->plan.afford > 0 && models_cost(work) > r->plan.afford;
}

/* From w->rest to a place of rest that is stable. */
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

/* How much of each mode is in a displacement, or in its derivatives. */
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

/* Does no spring that has a length of its own turn round on this axis? */
static bool keeps_sides(const struct vibration *w, const struct scene *s,
                        size_t axis)
{
    const double *x = s->position + axis * s->bodies;
    const double *rest = w->rest + axis * s->bodies;
    double twice = 0; /* the energy */
    for (size_t j = 0; j < w->modes.size; ++j)
        if (w->modes.square[j] > w->slack)
            twice += w->change[j] * w->change[j] +
                     w->modes.square[j] * w->amount[j] * w->amount[j];
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        const double D = s->kind[p->kind].stiffness,
                     d = rest[p->b] - rest[p->a];
        if (is_active(s, p) && p->rest != 0 && D > 0 &&
            !(d * (x[p->b] - x[p->a]) > 0 && D * d * d > twice))
            return false;
    }
    return true;
}

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
        return no_memory;
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
        if (is_active(s, &s->spring[j]))
            damping += s->kind[s->spring[j].kind].damping;
    for (size_t c = 0; c < n; ++c)
        if (s->freedom[c])
            w->rate = damping / s->mass[c % s->bodies];
    const struct modes *const m = &w->modes;
    if (m->size > 0 && m->square[m->size - 1] > w->slack)
        r->clock = late_alike;
    return r->plan.model->approximate ||
                   keeps_sides(w, s, first_axis(r->acts.axes))
               ? NULL
               : "a spring may turn round";
}

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

/* Bodies on a line, from left to right. */
struct row_of_bodies {
    size_t axis;
    double sign; /* -1: seen from the other side, for weight to be down */
    double gravity;     /* m/s^2, down */
    double left, right; /* where what is held, or a wall, begins, m */
};

static struct row_of_bodies row_of(const struct scene *s,
                                   const struct models_acts *a)
{
    const size_t axis = first_axis(a->axes ? a->axes : a->offset);
    const double *x = s->position + axis * s->bodies;
    const unsigned char *free = s->freedom + axis * s->bodies;
    const bool walls = s->wall[axis] == SCENE_HARD;
    const double g = a->weight ? s->gravity[axis] : 0;
    struct row_of_bodies row = {axis, g > 0 ? -1 : 1, fabs(g),
                                walls ? s->low[axis] : -INFINITY,
                                walls ? s->high[axis] : INFINITY};
    double first = INFINITY, last = -INFINITY; /* of the free ones */
    for (size_t i = 0; i < s->bodies; ++i)
        if (free[i]) {
            first = fmin(first, x[i]);
            last = fmax(last, x[i]);
        }
    for (size_t i = 0; i < s->bodies; ++i)
        if (!free[i] && x[i] <= first)
            row.left = fmax(row.left, x[i] + s->radius[i]);
        else if (!free[i] && x[i] >= last)
            row.right = fmin(row.right, x[i] - s->radius[i]);
        else if (!free[i])
            row.left = NAN;
    return row;
}

/* What keeps a scene off the line. */
static const char *refuse_line(const struct scene *s,
                               const struct models_acts *a)
{
    const struct row_of_bodies row = row_of(s, a);
    size_t movers = 0;
    if (!s->contact)
        return "nothing collides";
    if (a->dimensions > 1 || (a->offset & ~(1u << row.axis)))
        return "the bodies are not on one line";
    if (s->wall[row.axis] == SCENE_PERIODIC)
        return "the line is periodic";
    if (row.gravity > 0 && isinf(row.sign > 0 ? row.left : row.right))
        return "bodies fall for ever";
    if (isnan(row.left))
        return "a body is held between others";
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool mover = s->freedom[at(s, row.axis, i)];
        movers += mover;
        if (mover && !(s->mass[i] > 0))
            return "a body has no mass";
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if (k != row.axis && s->wall[k] == SCENE_HARD &&
                !(s->position[at(s, k, i)] - s->radius[i] >= s->low[k] &&
                  s->position[at(s, k, i)] + s->radius[i] <= s->high[k]))
                return "a wall beside the line is in the way";
    }
    return movers > 0 && movers <= BONKERS_MOVERS
               ? NULL
               : "nothing is free, or too much";
}

/* The engine of chapter 2, and who is who in it. */
struct line {
    struct bonkers bonkers;
    struct row_of_bodies row;
    size_t *body;
    double *x, *v; /* of the engine's bodies; the walls are two */
};

/* The start of chapter 2, and in body who is who. False without memory. */
static bool start_row(struct line *l, struct start *start,
                      const struct scene *s)
{
    const struct row_of_bodies *row = &l->row;
    struct light_place *bead = malloc((s->bodies + 1) * sizeof *bead);
    size_t movers = 0;
    l->body = malloc((s->bodies + 1) * sizeof *l->body);
    for (size_t i = 0; bead && i < s->bodies; ++i)
        if (s->freedom[at(s, row->axis, i)])
            bead[movers++] = (struct light_place){
                row->sign * s->position[at(s, row->axis, i)], i};
    const bool made = bead && l->body && start_create(start, movers);
    if (made) {
        qsort(bead, movers, sizeof *bead, light_compare);
        for (size_t j = 0; j < movers; ++j) {
            const size_t i = l->body[j] = bead[j].body;
            start->x[j] = bead[j].key;
            start->v[j] = row->sign * s->velocity[at(s, row->axis, i)];
            start->mass[j] = s->mass[i];
            start->radius[j] = s->radius[i];
        }
        start->wall[0] = row->sign > 0 ? row->left : -row->right;
        start->wall[1] = row->sign > 0 ? row->right : -row->left;
        start->gravity = row->gravity;
    }
    free(bead);
    return made;
}

static void end_line(struct models_run *r)
{
    struct line *l = r->engine;
    bonkers_free(&l->bonkers);
    free(l->body);
    free(l->x);
}

/* So many times, n bodies are put in order. */
static void count_sorting(struct models_run *r, size_t n, double times)
{
    double bits = 1;
    for (size_t m = n; m > 2; m = (m + 1) / 2)
        ++bits;
    r->work[MODELS_ORDER] += times * (double)n * bits;
}

static const char *begin_line(struct models_run *r)
{
    struct start start = {0};
    struct line *l = r->engine;
    size_t wrong = 0;
    l->row = row_of(&r->scene, &r->acts);
    bool begun = start_row(l, &start, &r->scene);
    const size_t bodies = start.movers + 2;
    l->x = malloc(2 * bodies * sizeof *l->x);
    l->v = l->x ? l->x + bodies : NULL;
    begun = begun && l->x &&
            bonkers_begin(&l->bonkers, &start, r->scene.restitution,
                          BONKERS_AUTO, &wrong);
    count_sorting(r, start.movers, 3);
    start_free(&start);
    return !begun                     ? no_memory
           : wrong == l->bonkers.gaps ? NULL
                                      : "bodies overlap at the start";
}

/* So many collisions at a time, between which the cost is looked at. */
enum { AT_A_TIME = 4096, SLAB_WORTH = 30 /* gaps */ };

static bool is_costly(const struct models_run *r)
{
    return models_cost(r->work) > r->limit;
}

static void count_line(struct models_run *r, const struct bonkers *b)
{
    const bool few = b->gaps <= BONKERS_SCANNED + 1;
    const double met = (double)b->collisions, rows = (double)r->rows + 1;
    r->work[MODELS_LINE_EVENT] = met;
    r->work[MODELS_LINE_SCAN] =
        (met + rows) * (few ? (double)b->gaps : SLAB_WORTH);
    r->work[MODELS_FLIGHT] = 3 * rows * (double)b->gaps;
}

static void take_from_line(struct models_run *r, const struct line *l)
{
    for (size_t j = 1; j < l->bonkers.gaps; ++j) {
        const size_t c = at(&r->scene, l->row.axis, l->body[j - 1]);
        r->scene.position[c] = l->row.sign * l->x[j];
        r->scene.velocity[c] = l->row.sign * l->v[j];
    }
    r->virial = NAN;
}

static enum models_end row_line(struct models_run *r)
{
    struct line *l = r->engine;
    struct bonkers *b = &l->bonkers;
    enum bonkers_stop stop;
    do {
        const uint64_t before = b->collisions;
        stop = bonkers_run(b, r->elapsed, before + AT_A_TIME);
        count_line(r, b);
        if (is_costly(r))
            return MODELS_COSTLY;
    } while (stop == BONKERS_COLLISIONS);
    r->collisions = b->collisions;
    if (stop == BONKERS_COLLAPSE)
        return MODELS_STANDSTILL;
    bonkers_state(b, l->x, l->v);
    take_from_line(r, l);
    return MODELS_DONE;
}

static const char *refuse_relabel(const struct scene *s,
                                  const struct models_acts *a)
{
    const char *why = refuse_line(s, a);
    const size_t axis = row_of(s, a).axis;
    double mass = 0;
    if (why)
        return why;
    if (a->weight)
        return "bodies do not fly evenly";
    if (s->restitution != 1)
        return "collisions lose energy";
    for (size_t i = 0; i < s->bodies; ++i)
        if (s->freedom[at(s, axis, i)]) {
            if (mass != 0 && s->mass[i] != mass)
                return "the masses differ";
            mass = s->mass[i];
        }
    return NULL;
}

/* Where the points are at the start; returns how many there are. */
static size_t put_points(const struct line *l)
{
    for (size_t j = 0; j <= l->bonkers.gaps; ++j) {
        l->x[j] = l->bonkers.body[j].x;
        l->v[j] = l->bonkers.body[j].v;
    }
    return l->bonkers.gaps - 1;
}

static enum models_end row_relabel(struct models_run *r)
{
    const struct line *l = r->engine;
    const size_t n = put_points(l);
    double *const x = l->x + 1, *const v = l->v + 1;
    if (!(l->x[0] < x[n]))
        return MODELS_BROKEN; /* no room at all */
    if (!closed_relabel(l->x[0], x[n], n, x, v, r->elapsed))
        return MODELS_MEMORY;
    for (size_t j = 1; j <= n && l->bonkers.shift; ++j)
        l->x[j] += l->bonkers.shift[j];
    take_from_line(r, l);
    r->work[MODELS_FLIGHT] += (double)n;
    count_sorting(r, n, 1);
    return MODELS_DONE;
}

static void count_relabelled(struct models_run *r)
{
    const struct line *l = r->engine;
    const size_t n = put_points(l);
    r->collisions = closed_meetings(l->x[0], l->x[n + 1], n, l->x + 1,
                                    l->v + 1, (double)r->rows * r->every);
    r->work[MODELS_ORDER] += 2 * (double)n * (double)n;
}

/* A scene's axes, as those of the engine. */
struct view {
    size_t axes, axis[SCENE_AXES];
    size_t count[3]; /* of the walls of each kind */
    unsigned live;
};

static enum scene_wall wall_of(const struct scene *s, const struct view *w,
                               size_t j)
{
    const size_t k = w->axis[j];
    return w->live >> k & 1 ? s->wall[k] : SCENE_OPEN;
}

static struct view view_of(const struct scene *s,
                           const struct models_acts *a)
{
    struct view w = {.live = a->axes | a->offset};
    for (unsigned dead = 0; dead < 2; ++dead)
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if ((~w.live >> k & 1) == dead && w.axes < 3 - dead) {
                w.axis[w.axes] = k;
                ++w.count[wall_of(s, &w, w.axes++)];
            }
    for (size_t j = 0; j < w.axes; ++j)
        if (a->weight ? s->gravity[w.axis[j]] != 0
                      : w.count[SCENE_PERIODIC] > 0 &&
                            wall_of(s, &w, j) == SCENE_HARD) {
            const size_t second = w.axis[j];
            w.axis[j] = w.axis[1];
            w.axis[1] = second;
        }
    return w;
}

static const char unseen[] = "points on a line collide only as in line";

/* Are there points on one line that may meet? */
static bool points_meet(const struct scene *s, const struct models_acts *a)
{
    size_t points = 0, free = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (s->radius[i] == 0) {
            ++points;
            free += (freedom_of(s, i) & a->axes) != 0;
        }
    return a->contact && a->dimensions == 1 && !(a->offset & ~a->axes) &&
           points > 1 && free > 0;
}

static const char *refuse_disks(const struct scene *s,
                                const struct models_acts *a)
{
    const struct view w = view_of(s, a);
    const bool floor = wall_of(s, &w, 1) == SCENE_HARD;
    size_t falls = 0;
    for (size_t j = 0; j < w.axes; ++j)
        falls += s->gravity[w.axis[j]] != 0;
    if (!s->contact)
        return "nothing collides";
    if (points_meet(s, a))
        return unseen;
    if (a->weight && (falls > 1 || !floor))
        return floor ? "there is weight along two axes"
                     : "bodies fall for ever";
    if (w.count[SCENE_PERIODIC] > 0 && w.count[SCENE_HARD] > 0 &&
        !(floor && w.count[SCENE_HARD] == 1))
        return "the walls differ";
    for (size_t i = 0; i < s->bodies; ++i) {
        if ((a->axes | a->offset) & ~freedom_of(s, i))
            return "a body is held";
        if (!(s->mass[i] > 0))
            return "a body has no mass";
    }
    return s->bodies > DISKS_MOST || s->bodies == 0
               ? "there are too many bodies, or none"
               : NULL;
}

/* One of the two engines of part II. */
struct room {
    struct disks disks;
    struct cells cells;
    bool celled;
    struct view view;
    double sign[SCENE_AXES], origin[SCENE_AXES]; /* of the engine's axes */
    double crossed; /* how often a disk must have crossed the box */
};

static void end_disks(struct models_run *r)
{
    struct room *d = r->engine;
    if (d->celled)
        cells_free(&d->cells);
    disks_free(&d->disks);
}

static void put_in_box(struct room *d, const struct scene *s)
{
    struct disks *all = &d->disks;
    for (size_t j = 0; j < d->view.axes; ++j) {
        const size_t k = d->view.axis[j];
        const bool open = wall_of(s, &d->view, j) == SCENE_OPEN;
        const bool turned = j == 1 && all->gravity > 0 && s->gravity[k] > 0;
        d->sign[j] = turned ? -1 : 1;
        d->origin[j] = open ? 0 : turned ? s->high[k] : s->low[k];
        all->box[j] = open ? 0 : s->high[k] - s->low[k];
        for (size_t i = 0; i < all->count; ++i) {
            all->disk[i].position[j] =
                d->sign[j] * (s->position[at(s, k, i)] - d->origin[j]);
            all->disk[i].velocity[j] =
                d->sign[j] * s->velocity[at(s, k, i)];
        }
    }
    for (size_t i = 0; i < all->count; ++i) {
        all->mass[i] = s->mass[i];
        all->disk[i].radius = s->radius[i];
    }
}

enum { SCANNED = 100 }; /* disks up to which all are looked at */

static const char *begin_disks(struct models_run *r)
{
    const struct scene *s = &r->scene;
    struct room *d = r->engine;
    const struct view w = view_of(s, &r->acts);
    size_t a, b;
    if (!disks_create(&d->disks, w.axes, s->bodies))
        return no_memory;
    d->view = w;
    d->disks.boundary = w.count[SCENE_PERIODIC] == 0 ? DISKS_WALLS
                        : w.count[SCENE_HARD] > 0    ? DISKS_FLOOR
                                                     : DISKS_PERIODIC;
    d->disks.restitution = s->restitution;
    d->disks.gravity = r->acts.weight ? fabs(s->gravity[w.axis[1]]) : 0;
    put_in_box(d, s);
    if (!(disks_leash(&d->disks) > 0))
        return "the box is too narrow to be periodic";
    if (w.count[SCENE_OPEN] == 0 && s->bodies > SCANNED &&
        cells_suit(&d->disks))
        d->celled = cells_create(&d->cells, &d->disks);
    if (d->celled ? !cells_fit(&d->cells, &a, &b)
                  : !disks_fit(&d->disks, &a, &b))
        return "bodies overlap at the start";
    if (disks_lying(&d->disks) < d->disks.count)
        return "a body lies on the floor";
    return d->celled || disks_plan(&d->disks) ? NULL : no_memory;
}

/* The start is on the bill, too: by the scan every pair is asked whether it
   overlaps and when it meets, at twice the price of a look; in cells every
   disk gets a list of its neighbours, as it does each time it leaves its
   leash. */
static void count_disks(struct models_run *r, const struct room *d)
{
    const double met = (double)d->disks.collisions;
    const double hit = (double)d->disks.wall_collisions;
    const double renewed = d->celled ? (double)d->cells.renewed : 0;
    const double n = (double)d->disks.count;
    const size_t looks = d->celled ? d->cells.seats : d->disks.count;
    r->work[MODELS_DISK_EVENT] = met + hit;
    r->work[MODELS_DISK_SCAN] =
        (double)looks *
        ((d->celled ? n / 2 : 3 * n / 2) + 2 * met + hit + renewed);
    r->work[MODELS_RENEWAL] = d->celled ? n + renewed : 0;
    r->work[MODELS_FLIGHT] =
        ((double)r->rows + 1) * (double)(d->view.axes * d->disks.count);
}

/* Will the crossings alone be dear, with those of the row that comes? */
static bool is_endless(const struct models_run *r, struct room *d)
{
    const double time = r->elapsed - d->disks.now;
    const double price = 1e-9 * models_prices[MODELS_DISK_EVENT].ns;
    for (size_t i = 0; i < d->disks.count; ++i)
        for (size_t k = 0; k < d->view.axes; ++k)
            if (d->disks.box[k] > 0)
                d->crossed += time * fabs(d->disks.disk[i].velocity[k]) /
                              d->disks.box[k];
    return models_cost(r->work) + price * d->crossed > r->limit;
}

static enum models_end row_disks(struct models_run *r)
{
    struct room *d = r->engine;
    struct disks *all = &d->disks;
    enum disks_stop stop;
    if (is_endless(r, d))
        return MODELS_COSTLY;
    do {
        const uint64_t pairs = all->collisions;
        stop = d->celled
                   ? cells_run(&d->cells, r->elapsed, pairs + AT_A_TIME)
                   : disks_run(all, r->elapsed, pairs + AT_A_TIME);
        count_disks(r, d);
        if (stop == DISKS_COLLISIONS && all->collisions < pairs + AT_A_TIME)
            return MODELS_MEMORY;
        if (is_costly(r))
            return MODELS_COSTLY;
    } while (stop == DISKS_COLLISIONS);
    r->collisions = all->collisions + all->wall_collisions;
    r->virial = all->virial;
    if (stop == DISKS_COLLAPSE)
        return MODELS_STANDSTILL;
    for (size_t i = 0; i < all->count; ++i) {
        double place[DISKS_AXES], velocity[DISKS_AXES];
        disks_position(all, i, place);
        disks_velocity(all, i, velocity);
        for (size_t j = 0; j < d->view.axes; ++j) {
            const size_t c = at(&r->scene, d->view.axis[j], i);
            r->scene.position[c] = d->origin[j] + d->sign[j] * place[j];
            r->scene.velocity[c] = d->sign[j] * velocity[j];
        }
    }
    return MODELS_DONE;
}

static const char *refuse_steps(const struct scene *s,
                                const struct models_acts *a)
{
    if (points_meet(s, a))
        return unseen;
    switch (motion_flaw(s, NULL)) {
    case MOTION_WALLS: return "there are walls, but no contact";
    case MOTION_LIGHT: return "a body has no mass";
    case MOTION_TWICE: return "contacts are springs";
    case MOTION_POINTS: return unseen;
    case MOTION_THICK: return "a body is thicker than the box";
    case MOTION_WELL: break;
    }
    return (a->cuts & MODELS_RODS) && (a->friction || a->dashpots)
               ? "rods and friction do not go together"
               : NULL;
}

/* The heaviest body first, then the others from the inside outwards. */
static bool order_outwards(struct light *l, const struct scene *s)
{
    return light_create(l, s, INFINITY, central_body(s, ALL_AXES), false);
}

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
    struct light light;
    if (why)
        return why;
    why = no_memory;
    if (scene_copy(&other, s) && order_outwards(&light, s)) {
        permute(&other, s, light.order, false);
        why = jacobi_refuses(&other);
        light_free(&light);
    }
    scene_free(&other);
    return why;
}

/* Steps of one of chapter 8's methods, or of rods. */
struct steps {
    struct motion motion;
    struct scene scene; /* what is stepped: a run may move to another place
                           in memory, and its scene with it */
    struct models_plan plan;
    struct light light;
    struct rods rods;
    bool lights, ordered, rodded;
};

static void end_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    if (t->lights || t->ordered)
        light_free(&t->light);
    if (t->rodded)
        rods_free(&t->rods);
    motion_end(&t->motion);
    scene_free(&t->scene);
}

/* Is nothing held, and is there nothing but gravity and weight? */
static bool has_centre(const struct scene *s, const struct models_acts *a)
{
    for (size_t i = 0; i < s->bodies; ++i)
        if (a->axes & ~freedom_of(s, i))
            return false;
    return !a->contact && !a->springs && !a->friction;
}

/* Does a passage move any body by more than a little, in the time that is
   left? Its distance is that of straight ways, less by what they bend. */
static bool counts(const struct steps *t, const struct pair *p, double pull,
                   double a2)
{
    const double tau = fabs(p->rv) / p->v2;
    const double bend = sqrt(a2) * tau * tau / 2;
    const double b = fmax(sqrt(pair_nearest2(p)) - bend, 0);
    return 2 * pull * t->plan.left > t->plan.little * b * sqrt(p->v2);
}

/* How often, in 1/s, two bodies can fly 0.7 of their distance, or come
   nearer by so much with what pulls them. */
static double hurry(const struct pair *p, double a2)
{
    const double way = 0.7 * sqrt(p->r2), fall = 2 * sqrt(a2) * way;
    const double nearer = fmax(-p->rv, 0) / sqrt(p->r2);
    return fmax(sqrt(p->v2), (nearer + sqrt(nearer * nearer + fall)) / 2) /
           way;
}

/* The longest step that no passage which counts can hide in. */
static double longest(void *what, const double x[], const double v[],
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
            const double rate = hurry(&p, a2);
            if (rate > most && counts(t, &p, pull, a2))
                most = rate;
        }
    return most > 0 ? 1 / most : INFINITY;
}

/* In a row; of steps that choose their length we ask for its end only, but
   with contacts, of which a call takes just so many. */
static uint64_t steps_of(const struct models_run *r)
{
    enum { LOOKS = 8 };
    if (!r->plan.model->method->adaptive)
        return r->plan.steps;
    return r->scene.contact ? LOOKS : 1;
}

static const char *begin_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    struct scene *s = &t->scene;
    const struct models_plan *p = &t->plan;
    const size_t count =
        r->plan.cuts & MODELS_RODS ? take_stiff(&r->scene, &r->origin) : 0;
    t->plan = r->plan;
    if (!scene_copy(s, &r->scene))
        return no_memory;
    if (p->model->method->orbits) {
        if (!(t->ordered = order_outwards(&t->light, &r->scene)))
            return no_memory;
        permute(s, &r->scene, t->light.order, false);
    }
    if (!motion_begin(&t->motion, "models", s, p->model->name,
                      r->every / (double)steps_of(r)) ||
        (t->motion.collides && count == 0 && !motion_locate(&t->motion)))
        return no_memory;
    t->motion.impact.least = p->margin;
    if (p->model->method->adaptive) {
        t->motion.stepping.tolerance = p->tolerance;
        t->motion.stepping.own->slack = p->slack;
        if (t->motion.attracts && p->little > 0) {
            t->motion.stepping.own->longest = longest;
            t->motion.stepping.own->with = t;
        }
    }
    if (t->motion.attracts && (p->cuts & MODELS_NO_LIGHT)) {
        struct gravity *g = &t->motion.gravity;
        t->lights = light_create(&t->light, s, heaviest(s), s->bodies,
                                 has_centre(s, &r->acts));
        if (!t->lights)
            return no_memory;
        light_enter(&t->light, s, s->position, s->velocity);
        g->source = t->light.order;
        g->sources = t->light.heavy;
        g->share = t->light.share;
        count_sorting(r, s->bodies, 5); /* and to enter the picture */
    }
    if (count > 0) {
        t->rodded =
            rods_create(&t->rods, s, r->scene.spring + r->scene.springs,
                        count, t->motion.stepping.forces);
        t->motion.outside = rods_step;
        t->motion.with = &t->rods;
        if (!t->rodded)
            return no_memory;
    }
    return NULL;
}

static double count_pulls(const struct steps *t)
{
    const double n = (double)t->motion.scene->bodies;
    if (!t->motion.attracts)
        return 0;
    if (t->lights)
        return (n - 1) * (double)t->light.heavy;
    return n <= 32 ? n * (n - 1) / 2 : n * (n - 1) / 8;
}

/* Passes over n bodies for each evaluation, in bodies. */
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

enum { LISTED = 10 }; /* what a spring in no band counts */

/* What so many evaluations are, with all that belongs to them. */
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

/* Light bodies that do not pull are stepped in a picture of their own. Each
   row takes them out of it, for as much as so many passes over a body. */
enum { LEAVING = 5 };

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
    if (t->lights)
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

/* Will the run cost twice what it may, if it goes on like this? A step of
   its own length may be beyond the row. */
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

/* Lets steps that choose their length go on as long as they may: one look
   may take what is left, and a small part of what all may. */
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
        work[MODELS_CONTACT] = n / 4; /* a guess: all pairs, once in four */
        work[MODELS_OVERLAP] = n * (n - 1) / 8;
    }
    const double asked = fmax(r->work[MODELS_EVALUATION], 1);
    const double more = may / fmax(models_cost(work), cost / asked);
    own->most = more < 1e15 ? own->evaluations + (uint64_t)more + 100 : 0;
}

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
        if (is_costly(r) || is_hopeless(r, t, left - now))
            return MODELS_COSTLY;
    }
    return MODELS_DONE;
}

static enum models_end row_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    const enum models_end end = run_steps(r, t);
    const struct scene *s = t->motion.scene;
    if (end == MODELS_DONE && t->rodded &&
        !rods_project(&t->rods, s->position, s->velocity))
        return MODELS_BROKEN;
    if (t->ordered)
        permute(&r->scene, s, t->light.order, true);
    else
        scene_take_state(&r->scene, s);
    if (t->lights)
        light_leave(&t->light, s, r->elapsed, r->scene.position,
                    r->scene.velocity);
    r->collisions = t->motion.collisions;
    r->least = t->motion.impact.least;
    r->virial = t->motion.collides ? t->motion.spheres.virial : 0;
    return end;
}

static const struct models_model stepless[] = {
    {"free", "every body flies alone, in closed form", MODELS_CLOSED,
     FRICTION, 1, row_free, NULL, NULL, NULL, false, NULL},
    {"kepler", "ellipses round one body, in closed form", MODELS_CLOSED,
     PULLS | PULLERS, sizeof(struct light), row_kepler, begin_kepler,
     end_kepler, refuse_kepler, false, NULL},
    {"oscillator", "springs on one line, in closed form", MODELS_CLOSED,
     SPRINGS | FRICTION, sizeof(struct vibration), row_modes, begin_modes,
     end_modes, refuse_oscillator, false, NULL},
    {"relabel", "equal bodies on a line, put in order", MODELS_CLOSED,
     MEETING, sizeof(struct line), row_relabel, begin_line, end_line,
     refuse_relabel, false, NULL},
    {"modes", "small vibrations of springs about their rest", MODELS_CLOSED,
     SPRINGS | FRICTION, sizeof(struct vibration), row_modes, begin_modes,
     end_modes, refuse_modes, true, NULL},
    {"line", "collisions on a line, one by one", MODELS_EVENTS, MEETING,
     sizeof(struct line), row_line, begin_line, end_line, refuse_line,
     false, NULL},
    {"disks", "collisions of disks or spheres, one by one", MODELS_EVENTS,
     MEETING, sizeof(struct room), row_disks, begin_disks, end_disks,
     refuse_disks, false, NULL},
};
enum { STEPLESS = sizeof stepless / sizeof *stepless };

static struct models_model model_of(const struct stepping_method *m)
{
    const unsigned no =
        (m->orbits ? PULLERS : 0) | (stepping_is_leapfrog(m) ? 0 : RODS);
    return (struct models_model){m->name,
                                 m->about,
                                 MODELS_STEPS,
                                 ALL_ACTS & ~no,
                                 sizeof(struct steps),
                                 row_steps,
                                 begin_steps,
                                 end_steps,
                                 m->orbits ? refuse_orbits : refuse_steps,
                                 false,
                                 m};
}

const struct models_model *models_all(void)
{
    static struct models_model all[STEPLESS + STEPPING_MOST + 1];
    if (all->name)
        return all;
    size_t n = STEPLESS;
    for (const struct stepping_method *m = stepping_methods; m->name; ++m)
        all[n++] = model_of(m);
    memcpy(all, stepless, sizeof stepless);
    return all;
}

const struct models_model *models_find(const char *name)
{
    for (const struct models_model *m = models_all(); m->name; ++m)
        if (strcmp(m->name, name) == 0)
            return m;
    return NULL;
}

void models_write(const struct models_plan *p, char text[MODELS_TEXT])
{
    size_t used = (size_t)snprintf(text, MODELS_TEXT, "%s", p->model->name);
    if (p->tolerance > 0)
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%g",
                                 p->tolerance);
    else if (p->steps > 0 && !p->model->method->adaptive)
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%llu",
                                 (unsigned long long)p->steps);
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        if (p->cuts >> k & 1)
            used += (size_t)snprintf(text + used, MODELS_TEXT - used, ",%s",
                                     models_cut_names[k]);
}

/* Name k of the models, or of what can be left out; NULL behind them. */
static const char *name_of(size_t k, bool cuts)
{
    return cuts ? models_cut_names[k] : models_all()[k].name;
}

/* what: what was expected; NULL: one of the names. */
static bool complain(char message[MODELS_MESSAGE], const char *word,
                     const char *what, bool cuts)
{
    int used =
        snprintf(message, MODELS_MESSAGE, "found '%.40s', expected %s",
                 word, what ? what : "one of ");
    for (size_t k = 0; !what && name_of(k, cuts); ++k)
        used += snprintf(message + used, MODELS_MESSAGE - (size_t)used,
                         "%s%s", k ? ", " : "", name_of(k, cuts));
    return false;
}

/* What stands behind the colon. Returns NULL, or what was expected. */
static const char *read_number(struct models_plan *p, const char *text)
{
    char *end;
    const double x = strtod(text, &end);
    const bool read = end != text && !*end;
    if (p->model->family != MODELS_STEPS)
        return "no steps with this model";
    p->steps = 1;
    p->tolerance = x;
    if (p->model->method->adaptive)
        return read && x >= 1e-16 && x <= 1
                   ? NULL
                   : "a tolerance of its own steps from 1e-16 to 1";
    p->tolerance = 0;
    if (!read || text[strspn(text, "0123456789")] || *text == '0' ||
        x > 1e12)
        return "a whole number of steps from 1 to 10^12";
    p->steps = (uint64_t)x;
    return NULL;
}

/* Ends a word at a mark; returns what follows, or NULL. */
static char *end_word(char *word, char mark)
{
    char *const at = strchr(word, mark);
    if (at)
        *at = '\0';
    return at ? at + 1 : NULL;
}

bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE])
{
    char words[MODELS_TEXT], *next;
    *p = (struct models_plan){0};
    if (strlen(text) >= sizeof words)
        return complain(message, text, NULL, false);
    strcpy(words, text);
    next = end_word(words, ',');
    const char *const number = end_word(words, ':');
    if (!(p->model = models_find(words)))
        return complain(message, words, NULL, false);
    const char *const expected = number ? read_number(p, number) : NULL;
    if (expected)
        return complain(message, number, expected, false);
    for (char *word = next; word; word = next) {
        size_t k = 0;
        next = end_word(word, ',');
        while (k < MODELS_CUTS && strcmp(word, models_cut_names[k]) != 0)
            ++k;
        if (k == MODELS_CUTS)
            return complain(message, word, NULL, true);
        p->cuts |= 1u << k;
    }
    return true;
}

/* Returns NULL, or why the plan of the run cannot carry the scene. */
static const char *copy_scene(struct models_run *r, const struct scene *s)
{
    struct scene *own = &r->scene;
    if (!scene_copy(own, s))
        return no_memory;
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        if (!s->freedom[c])
            own->velocity[c] = 0;
    leave_out(own, r->plan.cuts);
    models_analyse(&r->acts, own);
    r->acts.cuts = r->plan.cuts;
    return refusal(r);
}

const char *models_refuse(const struct models_plan *p,
                          const struct scene *s)
{
    struct models_run r = {.plan = *p};
    const char *why = copy_scene(&r, s);
    scene_free(&r.scene);
    return why;
}

bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why)
{
    *r = (struct models_run){
        .plan = *p, .start = s->time, .every = every, .limit = INFINITY};
    *why = !(every > 0) ? "rows must be apart"
           : p->model->family == MODELS_STEPS && p->steps == 0
               ? "it needs a number of steps"
               : copy_scene(r, s);
    if (!*why) {
        r->engine = calloc(1, p->model->engine);
        if (!r->engine || !scene_copy(&r->origin, &r->scene))
            *why = no_memory;
        else if (p->model->begin)
            *why = p->model->begin(r);
    }
    if (*why) { /* what has been done for it stays on the bill */
        double work[MODELS_UNITS];
        memcpy(work, r->work, sizeof work);
        models_end(r);
        memcpy(r->work, work, sizeof work);
    }
    return !*why;
}

enum models_end models_row(struct models_run *r)
{
    r->elapsed = (double)(r->rows + 1) * r->every;
    const enum models_end end = r->plan.model->row(r);
    if (end != MODELS_DONE)
        return end;
    ++r->rows;
    ++r->work[MODELS_ROW];
    r->scene.time = r->start + r->elapsed;
    return is_costly(r) ? MODELS_COSTLY : MODELS_DONE;
}

uint64_t models_collisions(struct models_run *r)
{
    if (r->plan.model->row == row_relabel)
        count_relabelled(r);
    return r->collisions;
}

void models_end(struct models_run *r)
{
    if (r->engine && r->plan.model->end)
        r->plan.model->end(r);
    free(r->engine);
    scene_free(&r->origin);
    scene_free(&r->scene);
    *r = (struct models_run){0};
}
