/* Finds the interactions in a scene, their rates, and simplifications. */
#include "choosing/models_parts.h"

#include "choosing/particles.h"

#include <math.h>
#include <stdlib.h>

/* Returns whether gravity acts: a body must be free, and another must have
   mass. */
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

bool models_is_active(const struct scene *s, const struct scene_spring *p)
{
    const struct scene_kind *kind = &s->kind[p->kind];
    return (kind->stiffness != 0 || kind->damping != 0) &&
           (freedom_of(s, p->a) || freedom_of(s, p->b));
}

double models_square(const struct scene *s, size_t i, size_t j)
{
    return pair_of(s, i, j, s->position, s->velocity).r2;
}

/* An interaction is absent only if it is exactly zero.

   An axis matters if a body moves along it at the start, or if a force may
   act along it. There is no such force if there is no uniform gravity along
   the axis and if all bodies that interact have equal positions along it.
   This holds without rounding errors: forces act along the line between two
   bodies or along their relative velocity, and the difference of two equal
   numbers is 0. Friction only slows bodies down.

   If bodies attract each other or may collide, any two of them may
   interact, so the positions of all bodies are compared. A spring acts only
   on its two ends, so only these are compared. Thus a flat membrane stays
   flat. */
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
        if (!models_is_active(s, p))
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

double models_heaviest(const struct scene *s)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        most = fmax(most, s->mass[i]);
    return most;
}

size_t models_central_body(const struct scene *s, unsigned axes)
{
    size_t best = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (!(freedom_of(s, i) & axes) && s->mass[i] > 0)
            return i;
        else if (s->mass[i] > s->mass[best])
            best = i;
    return best;
}

/* Returns the square of the angular frequency (in 1/s^2) of two bodies on
   a circular orbit at their present distance. */
static double square_of_pair(const struct scene *s, size_t i, size_t j)
{
    const double square =
        s->softening * s->softening + models_square(s, i, j);
    return s->k2 * (s->mass[i] + s->mass[j]) / (square * sqrt(square));
}

enum { MOST_PAIRED = 4000 };

/* Returns the largest square_of_pair, 1/s^2. For up to four thousand bodies
   it examines all pairs; their eight million square roots take a few
   hundredths of a second. For more bodies it examines only pairs with a
   heavy body, which suffices for an estimate. */
static double square_of_gravity(const struct scene *s)
{
    const double heavy = models_heaviest(s);
    const bool all = s->bodies <= MOST_PAIRED;
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        if (all || !particles_is_light(s, i, heavy))
            for (size_t j = all ? i + 1 : 0; j < s->bodies; ++j)
                if (j != i)
                    most = fmax(most, square_of_pair(s, i, j));
    return most;
}

/* Adds the contribution of a spring to row[a] and row[b], where a and b are
   its two bodies. row[i] is the sum of the absolute values in the matrix
   row of body i. By Gershgorin's theorem the largest of these sums bounds
   the eigenvalues (section on the fastest time). The contribution is the
   strength divided by the mass of the body, plus the strength divided by
   the root of the product of both masses. */
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

/* Returns the effective stiffness of a spring, N/m: the larger eigenvalue
   of its stiffness matrix. For a spring of stiffness D, rest length l and
   present length r, the eigenvalues are D along the spring and D(1 - l/r)
   across it. The latter has the larger absolute value if r is less than
   half of l. */
static double stiffness(const struct scene *s, const struct scene_spring *p)
{
    const double length = sqrt(models_square(s, p->a, p->b));
    const double across = fabs(1 - p->rest / length);
    return s->kind[p->kind].stiffness *
           (across > 1 && across < INFINITY ? across : 1);
}

/* Returns the stiffness (in N/m) above which springs count as stiff: a
   hundred times the smallest stiffness. If all stiffnesses are equal,
   returns 0: all springs count as stiff, and the plan decides whether they
   become rods. Returns INFINITY if no spring acts. */
static double stiff_from(const struct scene *s)
{
    double least = INFINITY, most = 0;
    for (size_t j = 0; j < s->springs; ++j) {
        const double stiffness = s->kind[s->spring[j].kind].stiffness;
        if (stiffness > 0 && models_is_active(s, &s->spring[j])) {
            least = fmin(least, stiffness);
            most = fmax(most, stiffness);
        }
    }
    return least == most ? 0 : 100 * least;
}

static bool is_stiff(const struct scene *s, const struct scene_spring *p,
                     double from)
{
    return models_is_active(s, p) && s->kind[p->kind].stiffness > from;
}

/* The stiffnesses of parallel springs add up, and so do the effects of a
   spring and gravity. So squares of frequencies are added. Damping rates
   are added to the frequency. `row` contains a number for the springs of
   each body, then one for the dashpots of each body.

   A spring that becomes a rod does not vibrate. Its rate is that of its
   rotation: at most the relative speed of its ends divided by its length.

   The result is only a first estimate for the time step, since rates
   change, for instance when a comet approaches its star. The chosen method
   does not depend on it, since the choice is made by comparing runs. */
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

/* Finds the axis along which a body is farthest from the first body. Along
   the other axes, gives all bodies the position of the first body and fixes
   them. */
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

void models_leave_out(struct scene *s, unsigned cuts)
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

/* Simplifications that change nothing are not returned. The masses of light
   bodies matter only with gravity, and bodies without mass attract nothing
   anyway. */
unsigned models_cuts(const struct scene *s)
{
    const double from = stiff_from(s), most = models_heaviest(s);
    const bool pulls = attracts(s);
    unsigned cuts = 0;
    for (size_t i = 0; pulls && i < s->bodies; ++i)
        if (s->mass[i] > 0 && particles_is_light(s, i, most))
            cuts = MODELS_NO_LIGHT;
    for (size_t j = 0; j < s->springs; ++j)
        cuts |= is_stiff(s, &s->spring[j], from) ? MODELS_RODS : 0;
    return cuts;
}

size_t models_take_stiff(struct scene *s, const struct scene *origin)
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

const char models_unseen[] = "points on a line collide only as in line";

bool models_points_meet(const struct scene *s, const struct models_acts *a)
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
