/* From chapters/12-models.nw: edit there, then run make tangle. */
/* checksum 1122208463 of the lines below */
/* What acts, what can be left out, and how each model carries a scene. */
#include "enough/models.h"

#include "line/bonkers.h"
#include "box/cells.h"
#include "enough/closed.h"
#include "box/disks.h"
#include "forces/adaptive.h"
#include "forces/hard.h"
#include "forces/kepler.h"
#include "enough/light.h"
#include "forces/modes.h"
#include "forces/motion.h"
#include "forces/rods.h"
#include "forces/spheres.h"
#include "scenes/pair.h"

#include <assert.h>
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
    [MODELS_LINE_EVENT] = {"line-event", "collision on a line", 34},
    [MODELS_LINE_SCAN] = {"line-scan", "gap looked at for it", 0.95},
    [MODELS_DISK_EVENT] = {"disk-event", "collision of disks", 40},
    [MODELS_DISK_SCAN] = {"disk-scan", "disk looked at for it", 23},
    [MODELS_ELLIPSE] = {"ellipse", "body moved along its ellipse", 210},
    [MODELS_FLIGHT] = {"flight", "coordinate moved freely", 3.6},
    [MODELS_ORDER] = {"order", "comparison of two bodies", 2.7},
    [MODELS_MODE] = {"mode", "operation on modes", 0.5},
    [MODELS_TRIAL] = {"trial", "disk looked at for a trial move", 3},
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

/* May body i move along one of these axes? */
static bool is_free(const struct scene *s, size_t i, unsigned axes)
{
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if ((axes >> k & 1) && s->freedom[at(s, k, i)])
            return true;
    return false;
}

/* The same along all of them? */
static bool is_all_free(const struct scene *s, size_t i, unsigned axes)
{
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if ((axes >> k & 1) && !s->freedom[at(s, k, i)])
            return false;
    return true;
}

enum { ALL_AXES = 7 };

/* Is there a body that can be pulled by another? */
static bool attracts(const struct scene *s)
{
    size_t pulling = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        pulling += s->mass[i] > 0;
    for (size_t i = 0; s->k2 != 0 && i < s->bodies; ++i)
        if (is_free(s, i, ALL_AXES) && pulling > (s->mass[i] > 0))
            return true;
    return false;
}

static bool is_active(const struct scene *s, const struct scene_spring *p)
{
    const struct scene_kind *kind = &s->kind[p->kind];
    return (kind->stiffness != 0 || kind->damping != 0) &&
           (is_free(s, p->a, ALL_AXES) || is_free(s, p->b, ALL_AXES));
}

/* Are two bodies at different places along axis k? */
static bool is_spread(const struct scene *s, size_t k)
{
    const double *x = s->position + k * s->bodies;
    for (size_t i = 1; i < s->bodies; ++i)
        if (x[i] != x[0])
            return true;
    return false;
}

static bool is_stretched(const struct scene *s, size_t k)
{
    const double *x = s->position + k * s->bodies;
    for (size_t j = 0; j < s->springs; ++j)
        if (is_active(s, &s->spring[j]) &&
            x[s->spring[j].a] != x[s->spring[j].b])
            return true;
    return false;
}

/* May anything move along axis k, that is: does it move, or is it pushed?
 */
static bool is_alive(const struct scene *s, const struct models_acts *a,
                     size_t k)
{
    bool can = false, moves = false;
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool here = s->freedom[at(s, k, i)];
        can |= here;
        moves |= here && s->velocity[at(s, k, i)] != 0;
    }
    const bool pushed = (a->weight && s->gravity[k] != 0) ||
                        ((a->gravity || a->contact) && is_spread(s, k)) ||
                        (a->springs && is_stretched(s, k));
    return moves || (can && pushed);
}

/* Velocity along axis k; what is held has none. */
static double moves(const struct scene *s, size_t k, size_t i)
{
    return s->freedom[at(s, k, i)] ? s->velocity[at(s, k, i)] : 0;
}

/* Do two bodies that fly straight on for ever meet? When in doubt, yes. */
static bool will_meet(const struct scene *s, size_t i, size_t j)
{
    const double reach = s->radius[i] + s->radius[j];
    double b = 0, c = -reach * reach, square = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double d =
            s->position[at(s, k, j)] - s->position[at(s, k, i)];
        const double u = moves(s, k, j) - moves(s, k, i);
        b += d * u;
        c += d * d;
        square += u * u;
    }
    return c <= 0 || (b < 0 && b * b * (1 + 1e-12) >= square * c);
}

enum { MOST_LOOKED_AT = 1000 };

/* May anything meet? Of few bodies that fly straight, we know. */
static bool may_meet(const struct scene *s, const struct models_acts *a)
{
    const bool straight = !a->gravity && !a->springs && !a->weight &&
                          !a->friction && s->bodies <= MOST_LOOKED_AT &&
                          !s->wall[0] && !s->wall[1] && !s->wall[2];
    const bool walls = s->wall[0] || s->wall[1] || s->wall[2];
    if (!s->contact || !straight)
        return s->contact && (s->bodies > 1 || walls);
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = i + 1; j < s->bodies; ++j)
            if (will_meet(s, i, j))
                return true;
    return false;
}

static bool has_weight(const struct scene *s)
{
    for (size_t k = 0; k < SCENE_AXES; ++k)
        for (size_t i = 0; s->gravity[k] != 0 && i < s->bodies; ++i)
            if (s->freedom[at(s, k, i)])
                return true;
    return false;
}

static double largest_frequency(const struct scene *s,
                                const struct models_acts *a);

/* All but the largest frequency. */
static void look_at(struct models_acts *a, const struct scene *s)
{
    *a = (struct models_acts){.gravity = attracts(s),
                              .weight = has_weight(s),
                              .friction = s->damping != 0};
    for (size_t i = 0; i < s->bodies; ++i)
        a->free += is_free(s, i, ALL_AXES);
    for (size_t j = 0; j < s->springs; ++j)
        if (is_active(s, &s->spring[j])) {
            a->springs = true;
            a->dashpots |= s->kind[s->spring[j].kind].damping != 0;
        }
    a->contact = may_meet(s, a);
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        a->axes |= (unsigned)is_alive(s, a, k) << k;
        a->offset |= (unsigned)is_spread(s, k) << k;
        a->dimensions += a->axes >> k & 1;
    }
}

void models_analyse(struct models_acts *a, const struct scene *s)
{
    look_at(a, s);
    a->fastest = largest_frequency(s, a);
}
/* How far bodies that can be pushed are beyond hard walls that they do not
   come back from, m. */
static double beyond_walls(const struct scene *s)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const double x = s->position[at(s, k, i)], r = s->radius[i];
            const double v = s->velocity[at(s, k, i)];
            if (s->wall[k] != SCENE_HARD || !s->freedom[at(s, k, i)])
                continue;
            if (v <= 0)
                most = fmax(most, s->low[k] + r - x);
            if (v >= 0)
                most = fmax(most, x + r - s->high[k]);
        }
    return most;
}

double models_overlap(const struct scene *s)
{
    struct spheres p;
    struct scene copy;
    double depth = INFINITY;
    if (!s->contact)
        return 0;
    if (!scene_copy(&copy, s))
        return INFINITY;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if (copy.wall[k] == SCENE_HARD)
            copy.wall[k] = SCENE_OPEN;
    for (size_t i = 0; i < copy.bodies; ++i)
        copy.mass[i] = 1;
    if (spheres_create(&p, &copy, SPHERES_ALL)) {
        spheres_resolve(&p, copy.position, copy.velocity);
        depth = p.depth;
        spheres_free(&p);
    }
    scene_free(&copy);
    return fmax(depth, beyond_walls(s));
}

static double heaviest(const struct scene *s)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        most = fmax(most, s->mass[i]);
    return most;
}

static bool is_light(const struct scene *s, size_t i, double heaviest)
{
    return s->mass[i] * 100 < heaviest;
}

static bool has_light(const struct scene *s)
{
    const double most = heaviest(s);
    for (size_t i = 0; i < s->bodies; ++i)
        if (s->mass[i] > 0 && is_light(s, i, most))
            return true;
    return false;
}

double models_square(const struct scene *s, size_t i, size_t j)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double d =
            s->position[at(s, k, i)] - s->position[at(s, k, j)];
        sum += d * d;
    }
    return sum;
}

/* The square of the frequency of two bodies, if they circled. */
static double square_of_pair(const struct scene *s, size_t i, size_t j)
{
    const double square =
        s->softening * s->softening + models_square(s, i, j);
    return s->k2 * (s->mass[i] + s->mass[j]) / (square * sqrt(square));
}

enum { MOST_PAIRED = 4000 };

/* Of two bodies round each other, the fastest pair; of very many bodies, of
   pairs with a heavy one. */
static double square_of_gravity(const struct scene *s)
{
    const double heavy = heaviest(s);
    const bool all = s->bodies <= MOST_PAIRED;
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (all || !is_light(s, i, heavy))
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
        weight[e] = is_free(s, end[e], ALL_AXES) && m > 0 ? 1 / m : 0;
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

/* Gershgorin's bounds of the squares of frequencies, and of the rates of
   dashpots; without memory, infinite. */
static void bound_springs(const struct scene *s, double *square,
                          double *rate)
{
    double *row = calloc(2 * s->bodies + 1, sizeof *row);
    *square = *rate = row ? 0 : INFINITY;
    if (!row)
        return;
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        add_rows(s, p, row, stiffness(s, p));
        add_rows(s, p, row + s->bodies, s->kind[p->kind].damping);
    }

    for (size_t i = 0; i < s->bodies; ++i) {
        *square = fmax(*square, row[i]);
        *rate = fmax(*rate, row[s->bodies + i]);
    }
    free(row);
}

static double largest_frequency(const struct scene *s,
                                const struct models_acts *a)
{
    double square = 0, rate = 0, slow = 0;
    if (a->springs)
        bound_springs(s, &square, &rate);
    if (a->gravity)
        square += square_of_gravity(s);
    for (size_t i = 0; a->friction && i < s->bodies; ++i)
        if (s->mass[i] > 0)
            slow = fmax(slow, s->damping / s->mass[i]);
    return sqrt(square) + rate + slow;
}

const char *const models_cut_names[MODELS_CUTS + 1] = {
    "no-softening", "no-light",  "no-friction", "no-dashpots", "no-weak",
    "rods",         "no-weight", "no-pull",     "no-across",   NULL};

/* The softest and the stiffest of the springs that act; 0 if none does. */
static void stiffnesses(const struct scene *s, double *least, double *most)
{
    *least = INFINITY;
    *most = 0;
    for (size_t j = 0; j < s->springs; ++j) {
        const double stiffness = s->kind[s->spring[j].kind].stiffness;
        if (stiffness > 0 && is_active(s, &s->spring[j])) {
            *least = fmin(*least, stiffness);
            *most = fmax(*most, stiffness);
        }
    }
    *least = fmin(*least, *most);
}

static bool is_weak(const struct scene *s, const struct scene_spring *p,
                    double most)
{
    return s->kind[p->kind].stiffness * 100 < most;
}

static bool is_stiff(const struct scene *s, const struct scene_spring *p,
                     double least, double most)
{
    const double stiffness = s->kind[p->kind].stiffness;
    return is_active(s, p) && stiffness > 0 &&
           (stiffness > 100 * least || least == most);
}

/* The axis along which the scene is longest; of points in one place, that
   along which they are fastest. */
static size_t longest_axis(const struct scene *s)
{
    double best[2] = {-1, -1};
    size_t axis = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        double low = INFINITY, high = -INFINITY, fast = 0;
        for (size_t i = 0; i < s->bodies; ++i) {
            low = fmin(low, s->position[at(s, k, i)]);
            high = fmax(high, s->position[at(s, k, i)]);
            fast = fmax(fast, fabs(moves(s, k, i)));
        }
        const double size = high - low;
        if (size > best[0] || (size == best[0] && fast > best[1])) {
            best[0] = size;
            best[1] = fast;
            axis = k;
        }
    }
    return axis;
}

static unsigned spring_cuts(const struct scene *s,
                            const struct models_acts *a)
{
    double least, most;
    unsigned cuts = a->dashpots ? MODELS_NO_DASHPOTS : 0;
    stiffnesses(s, &least, &most);
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        if (is_active(s, p) && is_weak(s, p, most))
            cuts |= MODELS_NO_WEAK;
        if (is_stiff(s, p, least, most))
            cuts |= MODELS_RODS;
    }
    return cuts;
}

unsigned models_cuts(const struct scene *s)
{
    struct models_acts a;
    look_at(&a, s);
    unsigned cuts = spring_cuts(s, &a);
    if (a.gravity)
        cuts |= MODELS_NO_PULL |
                (s->softening != 0 ? MODELS_NO_SOFTENING : 0) |
                (has_light(s) ? MODELS_NO_LIGHT : 0);
    if (a.friction)
        cuts |= MODELS_NO_FRICTION;
    if (a.weight)
        cuts |= MODELS_NO_WEIGHT;
    if ((a.axes | a.offset) & ~(1u << longest_axis(s)))
        cuts |= MODELS_NO_ACROSS;
    return cuts;
}

/* Keeps the springs that are not chosen; moves the others to taken, unless
   that is NULL. Returns how many those are. */
static size_t take_springs(struct scene *s, bool stiff,
                           struct scene_spring taken[])
{
    size_t kept = 0, count = 0;
    double least, most;
    stiffnesses(s, &least, &most);
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring p = s->spring[j];
        if (stiff ? is_stiff(s, &p, least, most) : is_weak(s, &p, most)) {
            if (taken)
                taken[count] = p;
            ++count;
        } else
            s->spring[kept++] = p;
    }
    s->springs = kept;
    return count;
}

double models_without_stiff(struct scene *s)
{
    double least, most, turning = 0;
    stiffnesses(s, &least, &most);
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *p = &s->spring[j];
        double square = 0;
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const double v =
                s->velocity[at(s, k, p->b)] - s->velocity[at(s, k, p->a)];
            square += v * v;
        }
        if (is_stiff(s, p, least, most))
            turning =
                fmax(turning, sqrt(square / models_square(s, p->a, p->b)));
    }
    take_springs(s, true, NULL);
    return turning;
}

static void flatten(struct scene *s)
{
    const size_t axis = longest_axis(s), n = s->bodies;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        for (size_t i = 0; k != axis && i < n; ++i) {
            s->position[k * n + i] = s->position[k * n];
            s->velocity[k * n + i] = 0;
            s->freedom[k * n + i] = 0;
        }
}

void models_cut(struct scene *s, unsigned cuts)
{
    if (cuts & MODELS_NO_ACROSS)
        flatten(s);
    if (cuts & MODELS_NO_SOFTENING)
        s->softening = 0;
    if (cuts & MODELS_NO_FRICTION)
        s->damping = 0;
    for (size_t k = 0; (cuts & MODELS_NO_DASHPOTS) && k < s->kinds; ++k)
        s->kind[k].damping = 0;
    if (cuts & MODELS_NO_WEAK)
        take_springs(s, false, NULL);
    for (size_t k = 0; (cuts & MODELS_NO_WEIGHT) && k < SCENE_AXES; ++k)
        s->gravity[k] = 0;
    if (cuts & MODELS_NO_PULL)
        s->k2 = 0;
}

static const char no_memory[] = "there is no memory";
static const char no_rods[] = "it knows no rods";

/* What nearly every closed form has to refuse. */
static const char *refuse_forces(const struct models_acts *a, bool springs,
                                 bool gravity)
{
    if (a->springs && !springs)
        return "springs act";
    if (a->gravity && !gravity)
        return "the bodies attract each other";
    return NULL;
}

static const char *refuse_cuts(unsigned cuts, unsigned known)
{
    if (cuts & ~known & MODELS_RODS)
        return no_rods;
    if (cuts & ~known & MODELS_NO_LIGHT)
        return "it does not ask who pulls";
    return NULL;
}

/* Where a closed form begins. */
struct origin {
    double *x, *v; /* [3 * bodies] */
    struct light light;
    bool lights;
};

static void free_origin(struct models_run *r)
{
    struct origin *o = r->engine;
    if (o->lights)
        light_free(&o->light);
    free(o->x);
    free(o);
}

static struct origin *make_origin(const struct scene *s)
{
    const size_t size = 3 * s->bodies;
    struct origin *o = calloc(1, sizeof *o);
    if (!o || !(o->x = malloc((2 * size + 1) * sizeof *o->x))) {
        free(o);
        return NULL;
    }
    o->v = o->x + size;
    memcpy(o->x, s->position, size * sizeof *o->x);
    memcpy(o->v, s->velocity, size * sizeof *o->v);
    return o;
}

static const char *begin_origin(struct models_run *r)
{
    r->engine = make_origin(&r->scene);
    return r->engine ? NULL : no_memory;
}

static const char *refuse_free(const struct scene *s,
                               const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_cuts(cuts, 0);
    (void)s;
    if (!why && a->contact)
        return "bodies may meet";
    return why ? why : refuse_forces(a, false, false);
}

/* What a flight costs that needs an exponential, in flights. */
enum { WITH_EXPONENTIAL = 10 };

static enum models_end row_free(struct models_run *r)
{
    const struct origin *o = r->engine;
    struct scene *s = &r->scene;
    const size_t n = s->bodies;
    for (size_t c = 0; c < 3 * n; ++c) {
        const double m = s->mass[c % n];
        s->position[c] = o->x[c];
        s->velocity[c] = o->v[c];
        if (s->freedom[c])
            closed_fly(r->elapsed, s->damping > 0 ? s->damping / m : 0,
                       s->gravity[c / n], &s->position[c], &s->velocity[c]);
    }
    r->work[MODELS_FLIGHT] +=
        (double)(3 * n) * (s->damping > 0 ? WITH_EXPONENTIAL : 1);
    return MODELS_DONE;
}

/* The body in the middle: one that is held, or else the heaviest. */
static size_t central_body(const struct scene *s, unsigned axes)
{
    size_t best = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (!is_free(s, i, axes) && s->mass[i] > 0)
            return i;
        else if (s->mass[i] > s->mass[best])
            best = i;
    return best;
}

/* Do all but the central body pull nobody who could give way? */
static bool is_central(const struct scene *s, size_t centre, unsigned axes,
                       unsigned cuts)
{
    const bool held = !is_free(s, centre, axes);
    const double most = heaviest(s);
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool quiet =
            s->mass[i] == 0 ||
            ((cuts & MODELS_NO_LIGHT) && is_light(s, i, most)) ||
            s->bodies == 2;
        if (i != centre && (!quiet || !is_all_free(s, i, axes)))
            return false;
    }
    return held || is_all_free(s, centre, axes);
}

/* Place and velocity of body i, seen from the centre of the picture. */
static void seen_from(const struct scene *s, const double q[],
                      size_t centre, size_t i, double way[3])
{
    for (size_t k = 0; k < 3; ++k)
        way[k] = q[at(s, k, i)] - q[at(s, k, centre)];
}

/* By what share of the time ellipses may be early or late; INFINITY when
   one of the orbits is none. */
static double clock_of_ellipses(const struct scene *s,
                                const struct light *l, const double px[],
                                const double pv[])
{
    double most = 0;
    for (size_t j = 0; j < l->lights; ++j) {
        double x[3], v[3], axis, eccentricity;
        seen_from(s, px, l->source[0], l->order[j], x);
        seen_from(s, pv, l->source[0], l->order[j], v);
        kepler_shape(s->k2 * l->inner[j], x, v, &axis, &eccentricity);
        if (!(axis > 0 && axis < INFINITY && eccentricity < 1 - 1e-9))
            return INFINITY;
        const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        most = fmax(most, 0x1p-51 * (1 + 4 * axis / r));
    }
    return most;
}

static const char *refuse_kepler(const struct scene *s,
                                 const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_cuts(cuts, MODELS_NO_LIGHT);
    if (why || (why = refuse_forces(a, false, true)))
        return why;
    const size_t centre = central_body(s, a->axes);
    if (!a->gravity)
        return "nothing attracts";
    if (a->contact)
        return "bodies may meet";
    if (a->friction)
        return "there is friction";
    if (s->softening != 0)
        return "the attraction is softened";
    if (a->offset & ~a->axes)
        return "bodies are held beside the plane of their motion";
    if (!is_central(s, centre, a->axes, cuts))
        return "more than one body pulls, or one is held";
    if (a->weight && !is_free(s, centre, a->axes))
        return "there is weight, and the centre is held";
    return NULL;
}

static bool make_light(struct light *l, const struct scene *s, bool moving,
                       size_t centre, bool alone)
{
    const double most = heaviest(s);
    bool *heavy = calloc(s->bodies + 1, sizeof *heavy);
    for (size_t i = 0; heavy && i < s->bodies; ++i)
        heavy[i] = alone ? i == centre : !is_light(s, i, most);
    const bool made = heavy && light_create(l, s, heavy, moving);
    free(heavy);
    return made;
}

static const char *begin_kepler(struct models_run *r)
{
    struct origin *o = make_origin(&r->scene);
    const size_t centre = central_body(&r->scene, r->acts.axes);
    const bool moving = is_free(&r->scene, centre, r->acts.axes);
    if (!(r->engine = o))
        return no_memory;
    o->lights = make_light(&o->light, &r->scene, moving, centre, true);
    if (!o->lights) {
        free_origin(r);
        return no_memory;
    }
    light_enter(&o->light, &r->scene, o->x, o->v);
    r->clock = clock_of_ellipses(&r->scene, &o->light, o->x, o->v);
    if (r->clock < INFINITY)
        return NULL;
    free_origin(r);
    return "an orbit is open, or as good as a fall";
}

static enum models_end row_kepler(struct models_run *r)
{
    const struct origin *o = r->engine;
    const struct light *l = &o->light;
    struct scene *s = &r->scene;
    const size_t n = s->bodies, centre = l->source[0];
    memcpy(s->position, o->x, 3 * n * sizeof *o->x);
    memcpy(s->velocity, o->v, 3 * n * sizeof *o->v);
    for (size_t j = 0; j < l->lights; ++j) {
        double x[3], v[3];
        seen_from(s, o->x, centre, l->order[j], x);
        seen_from(s, o->v, centre, l->order[j], v);
        kepler_move(s->k2 * l->inner[j], r->elapsed, x, v);
        for (size_t k = 0; k < 3; ++k) {
            s->position[at(s, k, l->order[j])] =
                o->x[at(s, k, centre)] + x[k];
            s->velocity[at(s, k, l->order[j])] =
                o->v[at(s, k, centre)] + v[k];
        }
    }
    light_leave(l, s, r->elapsed, s->position, s->velocity);
    r->work[MODELS_ELLIPSE] += (double)l->lights;
    return MODELS_DONE;
}

/* The only body that may move, or how many bodies there are. */
static size_t lone_mover(const struct scene *s)
{
    size_t found = s->bodies;
    for (size_t i = 0; i < s->bodies; ++i)
        if (is_free(s, i, ALL_AXES)) {
            if (found < s->bodies)
                return s->bodies;
            found = i;
        }
    return found;
}

/* The only spring that acts, or NULL. */
static const struct scene_spring *lone_spring(const struct scene *s)
{
    const struct scene_spring *found = NULL;
    for (size_t j = 0; j < s->springs; ++j)
        if (is_active(s, &s->spring[j])) {
            if (found)
                return NULL;
            found = &s->spring[j];
        }
    return found;
}

/* A body on a spring, along one axis. */
struct swing {
    size_t axis, body, anchor;
    double rest;         /* where nothing pushes it, along the axis */
    double square, rate; /* 1/s^2, 1/s */
    double y, v;         /* from rest, m and m/s */
    double reach;        /* it keeps within this of its rest, m */
    double room;         /* from there to the anchor, m */
};

static void measure_swing(struct swing *w, const struct scene *s,
                          const struct models_acts *a)
{
    const struct scene_spring *p = lone_spring(s);
    const struct scene_kind *kind = &s->kind[p->kind];
    w->body = lone_mover(s);
    w->anchor = p->a == w->body ? p->b : p->a;
    w->axis = a->axes & 2 ? 1 : a->axes & 4 ? 2 : 0;
    const double m = s->mass[w->body];
    const double x = s->position[at(s, w->axis, w->body)];
    const double from = s->position[at(s, w->axis, w->anchor)];
    w->square = kind->stiffness / m;
    w->rate = (kind->damping + s->damping) / m;
    w->rest = from + (x < from ? -p->rest : p->rest) +
              s->gravity[w->axis] / w->square;
    w->y = x - w->rest;
    w->v = s->velocity[at(s, w->axis, w->body)];
    w->reach = sqrt(w->y * w->y + w->v * w->v / w->square);
    w->room = p->rest == 0                     ? INFINITY
              : (x < from) == (w->rest < from) ? fabs(w->rest - from)
                                               : 0;
}

static const char *refuse_oscillator(const struct scene *s,
                                     const struct models_acts *a,
                                     unsigned cuts)
{
    struct swing w;
    const char *why = refuse_cuts(cuts, 0);
    const struct scene_spring *p = lone_spring(s);
    const size_t mover = lone_mover(s);
    if (why || (why = refuse_forces(a, true, false)))
        return why;
    if (!p || (p->a != mover && p->b != mover) || mover == s->bodies)
        return "it is not one body on one spring";
    if (a->contact)
        return "the body may meet another, or a wall";
    if (a->dimensions > 1 || (a->offset & ~a->axes))
        return "it does not move along its spring only";
    if (!(s->kind[p->kind].stiffness > 0 && s->mass[mover] > 0))
        return "there is a dashpot without a spring, or a spring without a "
               "mass";
    if (a->dimensions == 0)
        return NULL;
    measure_swing(&w, s, a);
    return w.reach < w.room ? NULL : "the body may pass through its anchor";
}

static enum models_end row_oscillator(struct models_run *r)
{
    const struct origin *o = r->engine;
    struct scene *s = &r->scene;
    struct swing w;
    memcpy(s->position, o->x, 3 * s->bodies * sizeof *o->x);
    memcpy(s->velocity, o->v, 3 * s->bodies * sizeof *o->v);
    if (r->acts.dimensions > 0) {
        measure_swing(&w, s, &r->acts);
        closed_oscillate(r->elapsed, w.square, w.rate, &w.y, &w.v);
        s->position[at(s, w.axis, w.body)] = w.rest + w.y;
        s->velocity[at(s, w.axis, w.body)] = w.v;
    }
    r->work[MODELS_FLIGHT] += 3 * WITH_EXPONENTIAL;
    return MODELS_DONE;
}

/* Bodies on a line, from left to right. */
struct row_of_bodies {
    size_t axis;
    bool walls;  /* there are hard walls at both ends */
    double sign; /* -1: seen from the other side, for weight to be down */
    double gravity;     /* m/s^2, down */
    double left, right; /* where what is held, or a wall, begins, m */
};

static struct row_of_bodies row_of(const struct scene *s,
                                   const struct models_acts *a)
{
    const unsigned axes = a->axes ? a->axes : a->offset;
    struct row_of_bodies row = {.axis = axes & 1   ? 0
                                        : axes & 2 ? 1
                                        : axes & 4 ? 2
                                                   : 0};
    const double *x = s->position + row.axis * s->bodies;
    row.walls = s->wall[row.axis] == SCENE_HARD;
    row.left = row.walls ? s->low[row.axis] : -INFINITY;
    row.right = row.walls ? s->high[row.axis] : INFINITY;
    const double g = a->weight ? s->gravity[row.axis] : 0;
    row.sign = g > 0 ? -1 : 1;
    row.gravity = fabs(g);
    double first = INFINITY, last = -INFINITY; /* of the free ones */
    for (size_t i = 0; i < s->bodies; ++i)
        if (s->freedom[at(s, row.axis, i)]) {
            first = fmin(first, x[i]);
            last = fmax(last, x[i]);
        }
    for (size_t i = 0; i < s->bodies; ++i)
        if (!s->freedom[at(s, row.axis, i)]) {
            if (x[i] <= first)
                row.left = fmax(row.left, x[i] + s->radius[i]);
            else if (x[i] >= last)
                row.right = fmin(row.right, x[i] - s->radius[i]);
            else
                row.left = NAN;
        }
    return row;
}

static const char *row_fault(const struct scene *s,
                             const struct row_of_bodies *row)
{
    size_t movers = 0;
    if (isnan(row->left))
        return "a body is held between others";
    for (size_t i = 0; i < s->bodies; ++i) {
        const bool mover = s->freedom[at(s, row->axis, i)];
        movers += mover;
        if (mover && !(s->mass[i] > 0))
            return "a body has no mass";
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if (k != row->axis && s->wall[k] == SCENE_HARD &&
                !(s->position[at(s, k, i)] - s->radius[i] >= s->low[k] &&
                  s->position[at(s, k, i)] + s->radius[i] <= s->high[k]))
                return "a wall beside the line is in the way";
    }
    if (movers == 0 || movers > BONKERS_MOVERS)
        return "nothing is free, or too much";
    return NULL;
}

/* The start of chapter 2 for a row, and in body who is who. False without
   memory. */
static bool start_row(struct start *start, size_t **body,
                      const struct scene *s,
                      const struct row_of_bodies *row)
{
    struct light_place *bead = malloc((s->bodies + 1) * sizeof *bead);
    size_t movers = 0;
    *body = malloc((s->bodies + 1) * sizeof **body);
    for (size_t i = 0; bead && i < s->bodies; ++i)
        if (s->freedom[at(s, row->axis, i)])
            bead[movers++] = (struct light_place){
                row->sign * s->position[at(s, row->axis, i)], i};
    if (!bead || !*body || !start_create(start, movers)) {
        free(bead);
        free(*body);
        *body = NULL;
        return false;
    }
    qsort(bead, movers, sizeof *bead, light_compare);
    for (size_t j = 0; j < movers; ++j) {
        const size_t i = (*body)[j] = bead[j].body;
        start->x[j] = bead[j].key;
        start->v[j] = row->sign * s->velocity[at(s, row->axis, i)];
        start->mass[j] = s->mass[i];
        start->radius[j] = s->radius[i];
    }
    start->wall[0] = row->sign > 0 ? row->left : -row->right;
    start->wall[1] = row->sign > 0 ? row->right : -row->left;
    start->gravity = row->gravity;
    free(bead);
    return true;
}

static const char *refuse_line(const struct scene *s,
                               const struct models_acts *a, unsigned cuts);

static const char *refuse_relabel(const struct scene *s,
                                  const struct models_acts *a,
                                  unsigned cuts)
{
    const char *why = refuse_line(s, a, cuts);
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

/* Equal bodies as points, their radii taken out. */
struct relabel {
    struct start start;
    size_t *body, axis;
    double *shift; /* what the radii have taken, of each */
    double *place, *speed;
    double left, right; /* m; of the points */
};

static void free_relabel(struct models_run *r)
{
    struct relabel *b = r->engine;
    start_free(&b->start);
    free(b->body);
    free(b->shift);
    free(b);
}

/* (2.2, eq:rods) */
static bool take_out_radii(struct relabel *b)
{
    struct start *s = &b->start;
    const double rounding =
        1e-12 * fmax(fabs(s->x[0]), fabs(s->x[s->movers - 1]));
    double taken = 0, last = b->left = s->wall[0];
    for (size_t j = 0; j < s->movers; ++j) {
        b->shift[j] = taken + s->radius[j];
        taken += 2 * s->radius[j];
        s->x[j] -= b->shift[j];
        if (!(s->x[j] >= last - rounding))
            return false;
        last = s->x[j] = fmax(s->x[j], last);
    }
    b->right = s->wall[1] - taken;
    return b->right >= last - rounding && b->right > b->left;
}

/* So many times, n bodies are put in order. */
static void count_sorting(struct models_run *r, size_t n, double times)
{
    double bits = 1;
    for (size_t m = n; m > 2; m = (m + 1) / 2)
        ++bits;
    r->work[MODELS_ORDER] += times * (double)n * bits;
}

static const char *begin_relabel(struct models_run *r)
{
    const struct row_of_bodies row = row_of(&r->scene, &r->acts);
    struct relabel *b = calloc(1, sizeof *b);
    if (!b || !start_row(&b->start, &b->body, &r->scene, &row)) {
        free(b);
        return no_memory;
    }
    const size_t n = b->start.movers;
    r->engine = b;
    count_sorting(r, n, 3);
    b->axis = row.axis;
    b->shift = malloc((3 * n + 1) * sizeof *b->shift);
    if (b->shift) {
        b->place = b->shift + n;
        b->speed = b->place + n;
        if (take_out_radii(b))
            return NULL;
    }
    const char *why = b->shift ? "bodies overlap at the start" : no_memory;
    free_relabel(r);

    return why;
}

static enum models_end row_relabel(struct models_run *r)
{
    struct relabel *b = r->engine;
    const size_t n = b->start.movers;
    if (!closed_relabel(b->left, b->right, n, b->start.x, b->start.v,
                        r->elapsed, b->place, b->speed))
        return MODELS_MEMORY;
    for (size_t j = 0; j < n; ++j) {
        const size_t c = at(&r->scene, b->axis, b->body[j]);
        r->scene.position[c] = b->place[j] + b->shift[j];
        r->scene.velocity[c] = b->speed[j];
    }
    r->work[MODELS_FLIGHT] += (double)n;
    count_sorting(r, n, 1);
    r->virial = NAN;
    return MODELS_DONE;
}

static void count_relabelled(struct models_run *r)
{
    const struct relabel *b = r->engine;
    const size_t n = b->start.movers;
    r->collisions = closed_meetings(b->left, b->right, n, b->start.x,
                                    b->start.v, (double)r->rows * r->every);
    count_sorting(r, n, 8);
}

/* What keeps a scene off the line. */
static const char *refuse_line(const struct scene *s,
                               const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_cuts(cuts, 0);
    const struct row_of_bodies row = row_of(s, a);
    if (why || (why = refuse_forces(a, false, false)))
        return why;
    if (!s->contact)
        return "nothing collides";
    if (a->friction)
        return "bodies do not fly evenly";
    if (a->dimensions > 1 || (a->offset & ~(1u << row.axis)))
        return "the bodies are not on one line";
    if (s->wall[row.axis] == SCENE_PERIODIC)
        return "the line is periodic";
    if (row.gravity > 0 && isinf(row.sign > 0 ? row.left : row.right))
        return "bodies fall for ever";
    return row_fault(s, &row);
}

/* The engine of chapter 2, and who is who in it. */
struct line {
    struct bonkers bonkers;
    size_t *body, axis;
    double *x, *v, sign;
};

static void end_line(struct models_run *r)
{
    struct line *l = r->engine;
    bonkers_free(&l->bonkers);
    free(l->body);
    free(l->x);
    free(l);
}

/* Makes room for states, and begins the engine; *wrong as bonkers_start
   returns it. False: no memory. */
static bool prepare_line(struct line *l, const struct scene *s,
                         const struct row_of_bodies *row, size_t *wrong)
{
    struct start start;
    if (!start_row(&start, &l->body, s, row))
        return false;
    const size_t bodies = start.movers + 2;
    l->axis = row->axis;
    l->sign = row->sign;
    l->x = malloc(2 * bodies * sizeof *l->x);
    l->v = l->x ? l->x + bodies : NULL;
    const bool begun =
        l->x && bonkers_begin(&l->bonkers, &start, s->restitution,
                              BONKERS_AUTO, wrong);
    start_free(&start);
    return begun;
}

static const char *begin_line(struct models_run *r)
{
    const struct row_of_bodies row = row_of(&r->scene, &r->acts);
    struct line *l = calloc(1, sizeof *l);
    size_t wrong = 0;
    if (!(r->engine = l))
        return no_memory;
    const bool begun = prepare_line(l, &r->scene, &row, &wrong);
    if (begun)
        count_sorting(r, l->bonkers.gaps, 3);
    if (begun && wrong == l->bonkers.gaps)
        return NULL;
    end_line(r);
    return begun ? "bodies overlap at the start" : no_memory;
}

/* Engines of events are asked for so many collisions at a time, between
   which the cost is looked at. */
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
    r->virial = NAN;
    if (stop == BONKERS_COLLAPSE)
        return MODELS_STANDSTILL;
    bonkers_state(b, l->x, l->v);
    for (size_t j = 1; j < b->gaps; ++j) {
        const size_t c = at(&r->scene, l->axis, l->body[j - 1]);
        r->scene.position[c] = l->sign * l->x[j];
        r->scene.velocity[c] = l->sign * l->v[j];
    }
    return MODELS_DONE;
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

static const char *view_fault(const struct scene *s,
                              const struct models_acts *a,
                              const struct view *w)
{
    const bool floor = wall_of(s, w, 1) == SCENE_HARD;
    size_t falls = 0;
    for (size_t j = 0; j < w->axes; ++j)
        falls += s->gravity[w->axis[j]] != 0;
    if (a->weight && (falls > 1 || !floor))
        return floor ? "there is weight along two axes"
                     : "bodies fall for ever";
    return w->count[SCENE_PERIODIC] == 0 || w->count[SCENE_HARD] == 0 ||
                   (floor && w->count[SCENE_HARD] == 1)
               ? NULL
               : "the walls differ";
}

static const char unseen[] = "points on a line collide only as in line";

/* Are there points on one line that may meet? */
static bool points_meet(const struct scene *s, const struct models_acts *a)
{
    size_t points = 0, free = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (s->radius[i] == 0) {
            ++points;
            free += is_free(s, i, a->axes);
        }
    return a->contact && a->dimensions == 1 && !(a->offset & ~a->axes) &&
           points > 1 && free > 0;
}

static const char *refuse_disks(const struct scene *s,
                                const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_cuts(cuts, 0);
    const struct view w = view_of(s, a);
    if (why || (why = refuse_forces(a, false, false)))
        return why;
    if (!s->contact)
        return "nothing collides";
    if (a->friction)
        return "bodies do not fly evenly";
    if (points_meet(s, a))
        return unseen;
    if ((why = view_fault(s, a, &w)))
        return why;
    for (size_t i = 0; i < s->bodies; ++i) {
        if (!is_all_free(s, i, a->axes | a->offset))
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
    free(d);
}

enum { SCANNED = 100 }; /* disks up to which all are looked at */

static const char *prepare_disks(struct room *d)
{
    const bool open = d->view.count[SCENE_OPEN] > 0;
    size_t a, b;
    if (!(disks_leash(&d->disks) > 0))
        return "the box is too narrow to be periodic";
    if (!open && d->disks.count > SCANNED && cells_suit(&d->disks))
        d->celled = cells_create(&d->cells, &d->disks);
    if (d->celled ? !cells_fit(&d->cells, &a, &b)
                  : !disks_fit(&d->disks, &a, &b))
        return "bodies overlap at the start";
    if (disks_lying(&d->disks) < d->disks.count)
        return "a body lies on the floor";
    return d->celled || disks_plan(&d->disks) ? NULL : no_memory;
}

static double looks_for(const struct room *d)
{
    return (double)(d->celled ? d->cells.seats : d->disks.count);
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

static const char *begin_disks(struct models_run *r)
{
    const struct scene *s = &r->scene;
    struct room *d = calloc(1, sizeof *d);
    const struct view w = view_of(s, &r->acts);
    if (!d || !disks_create(&d->disks, w.axes, s->bodies)) {
        free(d);
        return no_memory;
    }
    r->engine = d;
    d->view = w;
    d->disks.boundary = w.count[SCENE_PERIODIC] == 0 ? DISKS_WALLS
                        : w.count[SCENE_HARD] > 0    ? DISKS_FLOOR
                                                     : DISKS_PERIODIC;
    d->disks.restitution = s->restitution;
    d->disks.gravity = r->acts.weight ? fabs(s->gravity[w.axis[1]]) : 0;
    put_in_box(d, s);
    const char *why = prepare_disks(d);
    if (why)
        end_disks(r);
    return why;
}

static void count_disks(struct models_run *r, const struct room *d)
{
    const double met = (double)d->disks.collisions;
    const double hit = (double)d->disks.wall_collisions;
    const double renewed = d->celled ? (double)d->cells.renewed : 0;
    r->work[MODELS_DISK_EVENT] = met + hit;
    r->work[MODELS_DISK_SCAN] = looks_for(d) * ((double)d->disks.count / 2 +
                                                2 * met + hit + renewed);
    r->work[MODELS_FLIGHT] =
        ((double)r->rows + 1) * (double)(d->view.axes * d->disks.count);
}

/* How often in a second would a disk that meets nobody cross the room? */
static double crossings(const struct room *d, size_t i)
{
    double rate = 0;
    for (size_t k = 0; k < d->view.axes; ++k)
        if (d->disks.box[k] > 0)
            rate += fabs(d->disks.disk[i].velocity[k]) / d->disks.box[k];
    return rate;
}

/* Will the crossings alone be dear, with those of the row that comes? */
static bool is_endless(const struct models_run *r, struct room *d)
{
    const double time = r->elapsed - d->disks.now;
    const double price = 1e-9 * models_prices[MODELS_DISK_EVENT].ns;
    for (size_t i = 0; i < d->disks.count; ++i)
        d->crossed += crossings(d, i) * time;
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

enum { MOST_MODES = 400, MOST_TRIES = 30 };

static const char *refuse_modes(const struct scene *s,
                                const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_cuts(cuts, 0);
    double mass = 0;
    size_t coordinates = 0;
    if (why || (why = refuse_forces(a, true, false)))
        return why;
    if (!a->springs || a->contact || a->dashpots)
        return !a->springs  ? "no spring acts"
               : a->contact ? "bodies may meet"
                            : "there are dashpots";
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        if (s->freedom[c]) {
            const double m = s->mass[c % s->bodies];
            if (!(m > 0) || (a->friction && mass != 0 && m != mass))
                return m > 0 ? "friction mixes the modes of unequal masses"
                             : "a body has no mass";
            mass = m;
            ++coordinates;
        }
    return coordinates > MOST_MODES ? "there are too many modes" : NULL;
}

/* Modes, and how much of each there is. */
struct vibration {
    struct springs springs;
    struct modes modes;
    double *rest, *push;     /* [3 * bodies], [6 * bodies] */
    double *amount, *change; /* [size] of each mode at the start */
    double rate;             /* of friction, 1/s */
};

static void end_modes(struct models_run *r)
{
    struct vibration *w = r->engine;
    springs_free(&w->springs);
    modes_free(&w->modes);
    free(w->rest);
    free(w);
}

/* The largest part of a vector. */
static double largest(const double a[], size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = fmax(most, fabs(a[i]));
    return most;
}

/* One of Newton's steps towards the place of rest, from w->rest. Returns
   how far it has led, or NaN without memory. */
static double approach_rest(struct vibration *w, struct models_run *r)
{
    const size_t n = 3 * r->scene.bodies;
    double *still = w->push, *gap = w->push + n;
    memset(still, 0, n * sizeof *still);
    springs_accelerate(&w->springs, w->rest, still, gap);
    modes_free(&w->modes);
    if (!modes_find(&w->modes, &w->springs, w->rest))
        return NAN;
    const double size = (double)w->modes.size;
    r->work[MODELS_MODE] += 20 * size * size * size;
    if (w->modes.size == 0)
        return 0;
    modes_deflection(&w->modes,
                     1e-9 * fabs(w->modes.square[w->modes.size - 1]), gap,
                     still);
    for (size_t i = 0; i < w->modes.size; ++i)
        w->rest[w->modes.coordinate[i]] += still[w->modes.coordinate[i]];
    return largest(still, n);
}

/* From w->rest to a place of rest that is stable. */
static const char *find_rest(struct vibration *w, struct models_run *r)
{
    const double size = largest(w->rest, 3 * r->scene.bodies);
    double far = INFINITY;
    for (int k = 0; k < MOST_TRIES && !(far <= 1e-12 * size); ++k) {
        far = approach_rest(w, r);
        if (!(far <= 10 * size))
            return "no place of rest was found";
    }
    if (!(far <= 1e-9 * size))
        return "no place of rest was found";
    const size_t n = w->modes.size;
    if (n > 0 && w->modes.square[0] < -1e-9 * w->modes.square[n - 1])
        return "the place of rest is not stable";

    return NULL;
}

/* How much of each mode is in a displacement, or in velocities. */
static void take_apart(const struct vibration *w, const double x[],
                       const double from[], double amount[])
{
    const struct modes *m = &w->modes;
    for (size_t j = 0; j < m->size; ++j) {
        amount[j] = 0;
        for (size_t i = 0; i < m->size; ++i) {
            const size_t c = m->coordinate[i];
            amount[j] += m->shape[j * m->size + i] *
                         (x[c] - (from ? from[c] : 0)) / sqrt(m->weight[i]);
        }
    }
}

static const char *prepare_modes(struct vibration *w, struct models_run *r)
{
    const struct scene *s = &r->scene;
    const size_t n = 3 * s->bodies;
    w->rest = malloc((5 * n + 1) * sizeof *w->rest);
    if (!w->rest || !springs_create(&w->springs, s))
        return no_memory;
    w->push = w->rest + n;
    w->amount = w->rest + 3 * n;
    w->change = w->rest + 4 * n;
    memcpy(w->rest, s->position, n * sizeof *w->rest);
    const char *why = find_rest(w, r);
    if (why)
        return why;
    for (size_t c = 0; c < n; ++c)
        if (s->freedom[c])
            w->rate = s->damping / s->mass[c % s->bodies];
    take_apart(w, s->position, w->rest, w->amount);
    take_apart(w, s->velocity, NULL, w->change);
    return NULL;
}

static const char *begin_modes(struct models_run *r)
{
    struct vibration *w = calloc(1, sizeof *w);
    if (!(r->engine = w))
        return no_memory;
    const char *why = prepare_modes(w, r);
    if (why)
        end_modes(r);
    return why;
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
        closed_oscillate(r->elapsed, fmax(m->square[j], 0), w->rate, &q,
                         &p);
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

static const char *refuse_steps(const struct scene *s,
                                const struct models_acts *a, unsigned cuts)
{
    if (points_meet(s, a))
        return unseen;
    switch (motion_flaw(s, NULL)) {
    case MOTION_WALLS: return "there are walls, but no contact";
    case MOTION_LIGHT: return "a body has no mass";
    case MOTION_TWICE: return "contacts are springs";
    case MOTION_WELL: break;
    }
    return cuts & MODELS_RODS ? no_rods : NULL;
}

static const char *refuse_leapfrog(const struct scene *s,
                                   const struct models_acts *a,
                                   unsigned cuts)
{
    const char *why = refuse_steps(s, a, cuts & ~(unsigned)MODELS_RODS);
    if (!why && (cuts & MODELS_RODS) && (a->friction || a->dashpots))
        return "rods and friction do not go together";
    return why;
}

/* The heaviest body, then the others from the inside outwards, whatever
   their numbers are. NULL without memory. */
static struct light_place *order_outwards(const struct scene *s)
{
    struct light_place *order = malloc(s->bodies * sizeof *order);
    size_t centre = 0;
    for (size_t i = 1; i < s->bodies; ++i)
        if (s->mass[i] > s->mass[centre])
            centre = i;
    for (size_t i = 0; order && i < s->bodies; ++i)
        order[i] = (struct light_place){models_square(s, i, centre), i};
    if (order)
        qsort(order, s->bodies, sizeof *order, light_compare);
    return order;
}

static void put_in_order(struct scene *to, const struct scene *from,
                         const struct light_place order[])
{
    const size_t n = to->bodies;
    for (size_t i = 0; i < n; ++i) {
        to->mass[i] = from->mass[order[i].body];
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const size_t c = at(from, k, order[i].body);
            to->position[k * n + i] = from->position[c];
            to->velocity[k * n + i] = from->velocity[c];
        }
    }
}

static void put_back(struct scene *to, const struct scene *from,
                     const struct light_place order[])
{
    const size_t n = to->bodies;
    for (size_t i = 0; i < n; ++i)
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            const size_t c = at(to, k, order[i].body);
            to->position[c] = from->position[k * n + i];
            to->velocity[c] = from->velocity[k * n + i];
        }
}

static const char *refuse_orbits(const struct scene *s,
                                 const struct models_acts *a, unsigned cuts)
{
    const char *why = refuse_steps(s, a, cuts);
    struct scene other;
    if (!why && (cuts & MODELS_NO_LIGHT))
        why = "it does not ask who pulls";
    if (why)
        return why;
    struct light_place *order = order_outwards(s);
    if (!order || !scene_copy(&other, s)) {
        free(order);
        return no_memory;
    }
    put_in_order(&other, s, order);
    why = jacobi_refuses(&other);
    scene_free(&other);
    free(order);
    return why;
}

/* Steps of one of chapter 8's methods, or of rods. */
struct steps {
    struct motion motion;
    struct scene scene; /* what is stepped: a run may move to another place
                           in memory, and its scene with it */
    struct light light;
    struct rods rods;
    struct passages {
        const struct scene *scene;
        double little, left;
    } passages;
    struct light_place *order; /* of orbits, or NULL */
    bool lights, rodded;
};

static void end_steps(struct models_run *r)
{
    struct steps *t = r->engine;
    if (t->lights)
        light_free(&t->light);
    if (t->rodded)
        rods_free(&t->rods);
    free(t->order);
    motion_end(&t->motion);
    scene_free(&t->scene);
    free(t);
}

/* May the centre of mass be used: is nothing held, and is there nothing but
   gravity and weight? */
static bool has_centre(const struct scene *s, const struct models_acts *a)
{
    for (size_t i = 0; i < s->bodies; ++i)
        if (!is_all_free(s, i, a->axes))
            return false;
    return !a->contact && !a->springs && !a->friction;
}

static bool lighten(struct steps *t, struct models_run *r)
{
    struct gravity *g = &t->motion.gravity;
    struct scene *s = &t->scene;
    t->lights = make_light(&t->light, s, has_centre(s, &r->acts), 0, false);
    if (!t->lights)
        return false;
    light_enter(&t->light, s, s->position, s->velocity);
    g->source = t->light.source;
    g->sources = t->light.heavy;
    g->share = t->light.share;
    return true;
}

/* Makes rods of the stiff springs. */
static bool stiffen(struct steps *t, struct scene *s,
                    const struct scene_spring rod[], size_t count)
{
    t->rodded =
        rods_create(&t->rods, s, rod, count, t->motion.stepping.forces);
    t->motion.outside = rods_step;
    t->motion.with = &t->rods;
    return t->rodded;
}

/* Adds what two bodies are apart along an axis to the sums of p, and to
 *a2 the square of their acceleration towards each other. */
static struct pair relative(const struct scene *s, size_t i, size_t j,
                            const double x[], const double v[],
                            const double a[], double *a2)
{
    struct pair p = {.r2 = 0};
    *a2 = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t one = at(s, k, i), other = at(s, k, j);
        const double r = x[other] - x[one];
        const double u = v[other] - v[one];
        const double f = a[other] - a[one];
        pair_add(&p, r, u);
        *a2 += f * f;
    }
    return p;
}

/* Does the passage of two bodies move any body by more than a little, in
   the time that is left? Its distance is that of straight ways, less by
   what they bend. */
static bool counts(const struct passages *g, const struct pair *p,
                   double pull, double a2)
{
    const double tau = fabs(p->rv) / p->v2;
    const double bend = sqrt(a2) * tau * tau / 2;
    const double b = fmax(sqrt(pair_nearest2(p)) - bend, 0);
    return 2 * pull * g->left > g->little * b * sqrt(p->v2);
}

/* The longest step that no passage which counts can hide in. */
static double longest(void *what, const double x[], const double v[],
                      const double a[])
{
    const struct passages *g = what;
    const struct scene *s = g->scene;
    double most = 0, a2;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = 0; j < i; ++j) {
            const double pull = s->k2 * (s->mass[i] + s->mass[j]);
            if (pull == 0 ||
                !(is_free(s, i, ALL_AXES) || is_free(s, j, ALL_AXES)))
                continue;
            const struct pair p = relative(s, i, j, x, v, a, &a2);
            if (p.v2 > most * p.r2 && counts(g, &p, pull, a2))
                most = p.v2 / p.r2;
        }
    return most > 0 ? 0.7 / sqrt(most) : INFINITY;
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

/* Steps of any length: how long they may be. */
static void choose_lengths(struct steps *t, const struct models_plan *p)
{
    struct stepping *s = &t->motion.stepping;
    s->tolerance = p->tolerance;
    if (t->motion.attracts && p->little > 0) {
        t->passages = (struct passages){&t->scene, p->little, p->left};
        s->own->longest = longest;
        s->own->with = &t->passages;
    }
}

static bool begin_motion(struct steps *t, struct models_run *r,
                         struct scene_spring rod[])
{
    const bool lights = r->plan.cuts & MODELS_NO_LIGHT;
    const size_t count =
        r->plan.cuts & MODELS_RODS ? take_springs(&r->scene, true, rod) : 0;
    struct scene *s = &t->scene;
    if (!scene_copy(s, &r->scene))
        return false;
    if (r->plan.model->method->orbits) {
        if (!(t->order = order_outwards(&r->scene)))
            return false;
        put_in_order(s, &r->scene, t->order);
    }
    if (!motion_begin(&t->motion, "models", s, r->plan.model->name,
                      r->every / (double)steps_of(r)))
        return false;
    if (t->motion.collides && count == 0 && !motion_locate(&t->motion))
        return false;
    if (r->plan.model->method->adaptive)
        choose_lengths(t, &r->plan);
    return (!t->motion.attracts || !lights || lighten(t, r)) &&
           (count == 0 || stiffen(t, s, rod, count));
}

static const char *begin_steps(struct models_run *r)
{
    struct steps *t = calloc(1, sizeof *t);
    struct scene_spring *rod = malloc((r->scene.springs + 1) * sizeof *rod);
    if (!(r->engine = t) || !rod || !begin_motion(t, r, rod)) {
        if (t)
            end_steps(r);
        free(rod);
        return no_memory;
    }
    free(rod);
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

static double count_springs(const struct steps *t)
{
    const struct springs *p = &t->motion.springs;
    return (double)p->count + (LISTED - 1) * (double)p->listed;
}

/* What so many evaluations are, with all that belongs to them. */
static void count_evaluations(const struct models_run *r,
                              const struct steps *t, double asked,
                              double work[MODELS_UNITS])
{
    const double n = (double)r->scene.bodies;
    work[MODELS_EVALUATION] = asked;
    work[MODELS_BODY] = asked * body_passes(r->plan.model->method, n);
    work[MODELS_PAIR] = asked * count_pulls(t);
    work[MODELS_SPRING] = asked * count_springs(t);
}

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

/* How far it is, in rows: a step of its own length may be beyond. */
static double rows_done(const struct models_run *r, const struct steps *t,
                        uint64_t left)
{
    const double row = (double)steps_of(r);
    const struct adaptive *own = t->motion.stepping.own;
    const double done = (double)r->rows + (row - (double)left) / row;
    return own ? fmax(done, own->t / r->every) : done;
}

/* Will the run cost twice what it may, if it goes on like this? */
static bool is_hopeless(const struct models_run *r, const struct steps *t,
                        uint64_t left)
{
    const double done = rows_done(r, t, left);
    const double cost = models_cost(r->work);
    const double all = cost / done * (double)r->all;
    return r->plan.model->method->adaptive
               ? cost > fmin(r->limit / 2, 1) && all > 2 * r->limit
               : all > 1.1 * r->limit;
}

/* What one evaluation of all forces costs, with all that comes with it, s.
 */
static double price_of_evaluation(const struct models_run *r,
                                  const struct steps *t)
{
    double work[MODELS_UNITS] = {0};
    count_evaluations(r, t, 1, work);
    const double asked = fmax(r->work[MODELS_EVALUATION], 1);
    return fmax(models_cost(work), models_cost(r->work) / asked);
}

/* Lets steps that choose their length go on as long as they may: one look
   may take what is left, and a small part of what all may. */
static void bound_evaluations(const struct models_run *r, struct steps *t)
{
    const double left = r->limit - models_cost(r->work);
    const double one = 8 * r->limit / (double)(r->all * steps_of(r));
    const double may = r->all > 0 ? fmin(left, fmax(one, 0.1)) : left;
    const double more = may / price_of_evaluation(r, t);
    struct adaptive *own = t->motion.stepping.own;
    own->most = more < 1e15 ? own->evaluations + (uint64_t)more + 100 : 0;
}

/* A run of steps has ended early: why? */
static enum models_end broken(const struct steps *t)
{
    const struct adaptive *own = t->motion.stepping.own;
    return own && own->most > 0 && own->evaluations > own->most
               ? MODELS_COSTLY
               : MODELS_BROKEN;
}

static enum models_end run_steps(struct models_run *r, struct steps *t)
{
    const bool own = r->plan.model->method->adaptive;
    uint64_t left = steps_of(r);
    while (left > 0) {
        const uint64_t now = own                      ? 1
                             : left < STEPS_AT_A_TIME ? left
                                                      : STEPS_AT_A_TIME;
        if (own)
            bound_evaluations(r, t);
        const enum stepping_end end = motion_run(&t->motion, now);
        count_steps(r, t);
        if (end != STEPPING_DONE)
            return broken(t);
        left -= now;
        if (is_costly(r) || is_hopeless(r, t, left))
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
    if (t->order)
        put_back(&r->scene, s, t->order);
    else
        scene_take_state(&r->scene, s);
    if (t->lights)
        light_leave(&t->light, s, r->elapsed, r->scene.position,
                    r->scene.velocity);
    r->collisions = t->motion.collisions;
    r->virial = t->motion.collides ? t->motion.spheres.virial : 0;
    return end;
}

static const struct models_model stepless[] = {
    {"free", "every body flies alone, in closed form", MODELS_CLOSED, false,
     NULL, refuse_free, begin_origin, row_free, free_origin},
    {"kepler", "ellipses round one body, in closed form", MODELS_CLOSED,
     false, NULL, refuse_kepler, begin_kepler, row_kepler, free_origin},
    {"oscillator", "one body on one spring, in closed form", MODELS_CLOSED,
     false, NULL, refuse_oscillator, begin_origin, row_oscillator,
     free_origin},
    {"relabel", "equal bodies on a line, put in order", MODELS_CLOSED,
     false, NULL, refuse_relabel, begin_relabel, row_relabel, free_relabel},
    {"modes", "small vibrations of springs about their rest", MODELS_CLOSED,
     true, NULL, refuse_modes, begin_modes, row_modes, end_modes},
    {"line", "collisions on a line, one by one", MODELS_EVENTS, false, NULL,
     refuse_line, begin_line, row_line, end_line},
    {"disks", "collisions of disks or spheres, one by one", MODELS_EVENTS,
     false, NULL, refuse_disks, begin_disks, row_disks, end_disks},
};
enum { STEPLESS = sizeof stepless / sizeof *stepless };

static struct models_model model_of(const struct stepping_method *m)
{
    const bool leaps = stepping_is_leapfrog(m);
    return (struct models_model){.name = m->name,
                                 .about = m->about,
                                 .family = MODELS_STEPS,
                                 .method = m,
                                 .refuses = m->orbits ? refuse_orbits
                                            : leaps   ? refuse_leapfrog
                                                      : refuse_steps,
                                 .begin = begin_steps,
                                 .row = row_steps,
                                 .end = end_steps};
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

static bool is_adaptive(const struct models_plan *p)
{
    return p->model->method && p->model->method->adaptive;
}

void models_write(const struct models_plan *p, char text[MODELS_TEXT])
{
    size_t used = (size_t)snprintf(text, MODELS_TEXT, "%s", p->model->name);
    if (p->tolerance > 0)
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%g",
                                 p->tolerance);
    else if (p->steps > 0 && !is_adaptive(p))
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%llu",
                                 (unsigned long long)p->steps);
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        if (p->cuts >> k & 1)
            used += (size_t)snprintf(text + used, MODELS_TEXT - used, ",%s",
                                     models_cut_names[k]);
}

/* The next word of a plan, up to a comma; false: it is too long. */
static bool next_word(const char **text, char word[MODELS_TEXT])
{
    const size_t length = strcspn(*text, ",");
    if (length >= 40)
        return false;
    memcpy(word, *text, length);
    word[length] = '\0';
    *text += length;
    return true;
}

static bool read_cut(const char *word, unsigned *cuts)
{
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        if (strcmp(word, models_cut_names[k]) == 0) {
            *cuts |= 1u << k;
            return true;
        }
    return false;
}

/* A whole number from 1 to 10^12, or 0: it is none. */
static uint64_t read_steps(const char *text)
{
    uint64_t steps = 0;
    if (*text == '0' || !*text)
        return 0;
    for (; *text >= '0' && *text <= '9' && steps <= 100000000000; ++text)
        steps = 10 * steps + (uint64_t)(*text - '0');
    return *text || steps > 1000000000000 ? 0 : steps;
}

static bool complain(char message[MODELS_MESSAGE], const char *word,
                     const char *what)
{
    snprintf(message, MODELS_MESSAGE, "found '%.40s', expected %s", word,
             what);
    return false;
}

static bool list_models(char message[MODELS_MESSAGE], const char *word)
{
    char names[MODELS_MESSAGE - 64] = ""; /* the rest: what was found */
    for (const struct models_model *m = models_all(); m->name; ++m) {
        const size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s",
                 used ? ", " : "one of ", m->name);
    }
    return complain(message, word, names);
}

static bool read_tolerance(struct models_plan *p, const char *text,
                           char message[MODELS_MESSAGE])
{
    char *end;
    p->steps = 1;
    p->tolerance = strtod(text, &end);
    if (end != text && !*end && p->tolerance >= 1e-16 && p->tolerance <= 1)
        return true;
    return complain(message, text,
                    "a tolerance of its own steps from 1e-16 to 1");
}

/* The first word: a model, and its steps where it has steps. */
static bool read_model(struct models_plan *p, char word[MODELS_TEXT],
                       char message[MODELS_MESSAGE])
{
    char *const colon = strchr(word, ':');
    if (colon)
        *colon = '\0';
    p->model = models_find(word);
    if (!p->model)
        return list_models(message, word);
    if (colon && p->model->family != MODELS_STEPS)
        return complain(message, colon + 1, "no steps with this model");
    if (colon && p->model->method->adaptive)
        return read_tolerance(p, colon + 1, message);
    p->steps = colon ? read_steps(colon + 1) : 0;
    if (colon && p->steps == 0)
        return complain(message, colon + 1,
                        "a whole number of steps from 1 to 10^12");
    return true;
}

bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE])
{
    char word[MODELS_TEXT];
    *p = (struct models_plan){0};
    if (!next_word(&text, word))
        return list_models(message, text);
    if (!read_model(p, word, message))
        return false;
    while (*text == ',') {
        ++text;
        if (!next_word(&text, word) || !read_cut(word, &p->cuts))
            return complain(message,
                            text - strcspn(text, ",") < text ? text : word,
                            "what to leave out, as in no-friction");
    }
    return true;
}

const char *models_refuse(const struct models_plan *p,
                          const struct scene *s)
{
    struct models_acts acts;
    struct scene cut;
    if (!scene_copy(&cut, s))
        return no_memory;
    models_cut(&cut, p->cuts);
    look_at(&acts, &cut);
    const char *why = p->model->refuses(&cut, &acts, p->cuts);
    scene_free(&cut);
    return why;
}

bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why)
{
    *r = (struct models_run){
        .plan = *p, .start = s->time, .every = every, .limit = INFINITY};
    *why = no_memory;
    if (!scene_copy(&r->scene, s))
        return false;
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        if (!s->freedom[c])
            r->scene.velocity[c] = 0;
    models_cut(&r->scene, p->cuts);
    look_at(&r->acts, &r->scene);
    if (p->model->family == MODELS_CLOSED && r->acts.springs)
        r->clock = 0x5p-53;
    *why = !(every > 0) ? "rows must be apart"
           : p->model->family == MODELS_STEPS && p->steps == 0
               ? "it needs a number of steps"
               : p->model->refuses(&r->scene, &r->acts, p->cuts);
    if (!*why)
        *why = p->model->begin(r);
    if (!*why)
        return true;
    scene_free(&r->scene);
    return false;
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
    r->plan.model->end(r);
    scene_free(&r->scene);
    *r = (struct models_run){0};
}
