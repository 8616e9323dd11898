/* Finds contacts on polynomial paths; repeats steps to find their times. */
#include "forces/impact.h"

#include "forces/adaptive.h"
#include "forces/root.h"
#include "toolbox/aligned.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PATH = ADAPTIVE_DEGREE, DEGREE = 2 * PATH };
enum { MOST_TRIALS = 100, MOST_PARTS = 10000, MOST_PASSES = 1000 };
_Static_assert((int)DEGREE <= (int)ROOT_DEGREE, "of a pair's gap");

/* The relative rounding error of a position or a velocity: a few units in
   the last place. */
static const double ROUNDING = 0x1p-50;

/* A gap between two bodies or, if a == b, between a body and a wall, in the
   current part of the step. */
struct impact_gap {
    uint32_t a, b;
    size_t axis;                /* normal to the wall */
    double side,                /* -1: lower wall, 1: upper wall */
        edge;                   /* coordinate of the body's centre at
                                   contact, m */
    double image[SPHERES_AXES]; /* shift to the nearest image of b, m */
    double sum;                 /* of the radii of a pair, m */
    double start;               /* width when closed, m: 0, or negative
                                   if the bodies overlap initially */
    double rounding;            /* smaller widths count as 0, m */
    double root;                /* first root, as a fraction of the part */
    bool shut;                  /* closed at the end of the part */
    bool pressed;               /* closed, at rest, and under pressure */
    bool unclear;               /* pressed, or opening and closing again
                                   during the part */
};

/* Returns the value of coordinate c (in m) at which its body touches the
   wall on this side. */
static double edge_of(const struct scene *s, size_t c, double side)
{
    const size_t k = c / s->bodies;
    const double radius = s->radius[c % s->bodies];
    return side > 0 ? s->high[k] - radius : s->low[k] + radius;
}

/* Computes the accelerations due to all forces. A wall cancels the force on
   a body that rests on it. If this force points away from the wall, the
   coordinate is recorded in p->lifted. */
static void accelerate(void *what, const double x[], const double v[],
                       double a[])
{
    struct impact *p = what;
    p->forces.accelerate(p->forces.what, x, v, a);
    for (size_t c = 0; p->resting > 0 && c < p->forces.size; ++c)
        if (p->held[c] != 0) {
            if (p->held[c] * a[c] < 0)
                p->lifted = c;
            a[c] = 0;
        }
}

/* Sets *low and *high to the smallest and the largest coordinate (in m) of
   the bodies along an axis. */
static void spread(const struct scene *s, size_t k, double *low,
                   double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t c = k * s->bodies; c < (k + 1) * s->bodies; ++c) {
        *low = fmin(*low, s->position[c]);
        *high = fmax(*high, s->position[c]);
    }
}

/* Returns the axis along which the bodies are spread farthest. A sweep
   along this axis separates most pairs of paths. Periodic axes are ignored,
   since bodies cannot be sorted along them. If no axis remains, returns
   SPHERES_AXES. */
static size_t widest_axis(const struct scene *s)
{
    size_t widest = SPHERES_AXES;
    double most = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        double low, high;
        spread(s, k, &low, &high);
        if (s->wall[k] != SCENE_PERIODIC && high - low > most) {
            most = high - low;
            widest = k;
        }
    }
    return widest;
}

/* Divides the memory at p->note into arrays. */
static void divide_numbers(struct impact *p, size_t n)
{
    p->control = p->note + 5 * n + 1;
    p->low = p->control + (PATH + 1) * n;
    p->high = p->low + n;
    p->pull = p->high + n;
}

/* Replaces the forces of *s by accelerate() above. Removes its sweep, since
   a sweep would ignore walls. */
bool impact_create(struct impact *p, struct spheres *spheres,
                   struct stepping *s)
{
    const size_t n = s->forces.size;
    *p = (struct impact){.scene = spheres->scene,
                         .spheres = spheres,
                         .stepping = s,
                         .forces = s->forces,
                         .axis = widest_axis(spheres->scene)};
    p->held = calloc(n + 1, 1);
    p->order = malloc((n + 1) * sizeof *p->order);
    p->note = aligned_doubles(18 * n + 1);
    if (!p->held || !p->order || !p->note) {
        impact_free(p);
        return false;
    }
    divide_numbers(p, n);
    for (size_t i = 0; i < p->scene->bodies; ++i)
        p->order[i] = i;
    s->forces.accelerate = accelerate;
    s->forces.what = p;
    s->sweep = NULL;
    if (s->own)
        s->own->forces = s->forces;
    return true;
}

void impact_free(struct impact *p)
{
    free(p->held);
    free(p->order);
    free(p->note);
    free(p->gap);
    *p = (struct impact){0};
}

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool is_wall(const struct impact_gap *g)
{
    return g->a == g->b;
}

/* Returns the width of a gap (in m), and sets *rate to its rate of change
   (in m/s). */
static double width(const struct impact *p, const struct impact_gap *g,
                    const double x[], const double v[], double *rate)
{
    const size_t n = p->scene->bodies, c = g->axis * n + g->a;
    double d[SPHERES_AXES], u[SPHERES_AXES];
    if (is_wall(g)) {
        *rate = -g->side * v[c];
        return g->side * (g->edge - x[c]);
    }
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        d[k] = x[k * n + g->b] - x[k * n + g->a] - g->image[k];
        u[k] = v[k * n + g->b] - v[k * n + g->a];
    }
    const double distance = sqrt(dot(d, d));
    *rate = distance > 0 ? dot(d, u) / distance : 0;
    return distance - g->sum;
}

/* Returns the possible rounding error of the rate of a gap (in m/s). A rate
   within this error counts as 0: two bodies that fly side by side do not
   approach each other, although their velocities may differ by rounding
   errors. */
static double rate_rounding(const struct impact *p,
                            const struct impact_gap *g, const double v[])
{
    const size_t n = p->scene->bodies;
    double most = 0;
    for (size_t k = 0; !is_wall(g) && k < SPHERES_AXES; ++k)
        most =
            fmax(most, fmax(fabs(v[k * n + g->a]), fabs(v[k * n + g->b])));
    return ROUNDING * most;
}

/* Computes the control points of the path of each coordinate in a part of
   length h (in s): (11.8, eq:gap-control). The paths are cubics. Returns
   the degree. */
static size_t draw_cubics(struct impact *p, double h)
{
    const struct stepping *s = p->stepping;
    const size_t n = s->forces.size;
    const double *x = p->note, *v = p->note + n;
    for (size_t c = 0; c < n; ++c) {
        double *q = p->control + (PATH + 1) * c;
        q[0] = x[c];
        q[1] = x[c] + h * v[c] / 3;
        q[2] = s->x[c] - h * s->v[c] / 3;
        q[3] = s->x[c];
    }
    return 3;
}

/* Computes the paths in a part of length h (in s): cubics, or the
   polynomials of an adaptive method. Also computes boxes around the paths,
   enlarged by the radius of the body, |p->least| and an allowance for
   rounding errors. */
static void draw_paths(struct impact *p, double h)
{
    const struct stepping *s = p->stepping;
    p->degree =
        s->own ? adaptive_path(s->own, p->control) : draw_cubics(p, h);
    for (size_t c = 0; c < s->forces.size; ++c) {
        const double *q = p->control + (PATH + 1) * c;
        double low = q[0], high = q[0];
        for (size_t j = 1; j <= p->degree; ++j) {
            low = fmin(low, q[j]);
            high = fmax(high, q[j]);
        }
        const double radius = p->scene->radius[c % p->scene->bodies];
        const double more =
            radius + fabs(p->least) +
            ROUNDING * (fmax(fabs(low), fabs(high)) + radius);
        p->low[c] = low - more;
        p->high[c] = high + more;
    }
}

/* Computes the control points of the gap at a wall. Returns the degree. */
static size_t wall_points(const struct impact *p,
                          const struct impact_gap *g, double q[])
{
    const size_t c = g->axis * p->scene->bodies + g->a;
    for (size_t j = 0; j <= p->degree; ++j)
        q[j] = g->side * (g->edge - p->control[(PATH + 1) * c + j]);
    return p->degree;
}

/* Sets c[j] to the binomial coefficient "m choose j". */
static void choose(size_t m, double c[])
{
    c[0] = 1;
    for (size_t j = 0; j < m; ++j)
        c[j + 1] = c[j] * (double)(m - j) / (double)(j + 1);
}

/* Computes the control points of a pair's squared distance minus the
   squared sum of the radii. Returns the degree. The control points of a
   product of two curves are sums of products of the curves' control points,
   weighted with binomial coefficients. */
static size_t pair_points(const struct impact *p,
                          const struct impact_gap *g, double q[])
{
    const size_t n = p->scene->bodies, m = p->degree;
    double d[PATH + 1][SPHERES_AXES], once[PATH + 1], twice[DEGREE + 1];
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const double *a = p->control + (PATH + 1) * (k * n + g->a),
                     *b = p->control + (PATH + 1) * (k * n + g->b);
        for (size_t j = 0; j <= m; ++j)
            d[j][k] = b[j] - a[j] - g->image[k];
    }
    choose(m, once);
    choose(2 * m, twice);
    for (size_t j = 0; j <= 2 * m; ++j)
        q[j] = -g->sum * g->sum;
    for (size_t i = 0; i <= m; ++i)
        for (size_t j = 0; j <= m; ++j)
            q[i + j] += once[i] * once[j] / twice[i + j] * dot(d[i], d[j]);
    return 2 * m;
}

/* Returns whether a curve falls below the value `below`. */
static bool sinks(const double q[], size_t m, double below)
{
    return root_first(q, m, -below, ROOT_HALVINGS) <= 1;
}

/* Updates p->least: of all local minima of the widths of gaps, the one
   nearest to 0. If it is small, an error of a path may have caused or
   prevented a contact. Only curves with a minimum inside the part count.
   `unit` is the change of the curve per change of the width. A minimum
   that is below 0 only by a rounding error counts as 0. */
static void notice(struct impact *p, const double q[], size_t m,
                   double unit, double rounding)
{
    enum { BITS = 52 };
    double high = fabs(p->least), low = -high;
    const bool inside =
        (q[0] > high * unit || q[0] > q[1]) && q[m] > q[m - 1];
    if (!inside || !sinks(q, m, high * unit) || sinks(q, m, low * unit))
        return;
    for (int k = 0; k < BITS; ++k) {
        const double middle = (low + high) / 2;
        *(sinks(q, m, middle * unit) ? &high : &low) = middle;
    }
    p->least = high < 0 && high * unit >= -2 * rounding ? 0 : high;
}

/* Finds when a gap closes in a part of length h (in s):

   - A gap that is open closes at its first root.
   - A gap that is closed and closing is a contact now.
   - A gap that is closed and opening closes again at its next root.
   - A gap that is closed and at rest has no root.

   In the last two cases the gap may be closed at the end of the part
   although no root was found. Then the bodies are pressed together, or a
   body has risen and come back. Only a shorter part can show which.

   Bodies that overlap at the beginning count as touching at their initial
   distance. */
static void find_root(struct impact *p, struct impact_gap *g, double h)
{
    const struct stepping *s = p->stepping;
    const double *x = p->note, *v = x + s->forces.size;
    double q[DEGREE + 1], rate, end;
    const double w = width(p, g, x, v, &rate);
    const double unit = is_wall(g) ? 1 : 2 * (g->sum + w);
    const double slack = rate_rounding(p, g, v);
    const size_t m =
        is_wall(g) ? wall_points(p, g, q) : pair_points(p, g, q);
    if (p->least != 0 && w > g->rounding)
        notice(p, q, m, is_wall(g) ? 1 : 2 * g->sum, unit * g->rounding);
    g->start = w < -g->rounding ? w : 0;
    g->shut = width(p, g, s->x, s->v, &end) - g->start < -g->rounding;
    g->pressed = false;
    g->root = 0;
    if (w > g->rounding)
        g->root = root_first(q, m, unit * g->rounding, ROOT_HALVINGS);
    else if (rate > slack)
        g->root = root_next(q, m, h * rate * unit, unit * g->rounding);
    else if (rate >= -slack)
        g->root = INFINITY;
    g->unclear = g->root > 1 && w <= g->rounding && g->shut;
}

/* Finds the root of a gap, and adds the gap to the list for this part. */
static void add_gap(struct impact *p, struct impact_gap g, double h)
{
    if (p->gaps == p->capacity) {
        const size_t capacity = 2 * p->capacity + 16;
        void *gap = realloc(p->gap, capacity * sizeof *p->gap);
        if (!gap) {
            p->end = STEPPING_STUCK;
            return;
        }
        p->gap = gap;
        p->capacity = capacity;
    }
    find_root(p, &g, h);
    const size_t points = p->degree + 1;
    const size_t terms = is_wall(&g) ? points : points * points;
    p->curves += terms;
    p->roots += g.root > 0 && g.root <= 1 ? terms : 0;
    p->gap[p->gaps++] = g;
}

/* Adds the gap between a body and a wall if the body's path may pass the
   wall. */
static void add_wall(struct impact *p, size_t k, size_t i, double side,
                     double h)
{
    const struct scene *s = p->scene;
    const size_t c = k * s->bodies + i;
    const double edge = edge_of(s, c, side);
    const double out =
        side > 0 ? p->high[c] - s->high[k] : s->low[k] - p->low[c];
    double far = fmax(fabs(p->note[c]), fabs(edge)) + s->radius[i];
    if (!(out > 0 && s->freedom[c]))
        return;
    /* For a point at a wall at 0, both the position and the radius are 0
       and set no scale for rounding errors. The length of the path sets it
       instead. */
    const double way = p->high[c] - p->low[c];
    if (fabs(edge) + s->radius[i] <= ROUNDING * way)
        far = fmax(far, way);
    add_gap(p,
            (struct impact_gap){.a = (uint32_t)i,
                                .b = (uint32_t)i,
                                .axis = k,
                                .side = side,
                                .edge = edge,
                                .rounding = ROUNDING * far},
            h);
}

/* Returns the shift along axis k (in m) between b and the image of b that
   is nearest to a at the beginning of the part. */
static double image_of(const struct impact *p, size_t k, size_t a, size_t b)
{
    const struct scene *s = p->scene;
    const double *x = p->note + k * s->bodies;
    const double side = s->high[k] - s->low[k];
    return s->wall[k] == SCENE_PERIODIC
               ? side * floor((x[b] - x[a]) / side + 0.5)
               : 0;
}

/* Adds the gap of a pair if the boxes around both paths overlap. */
static void add_pair(struct impact *p, size_t a, size_t b, double h)
{
    const struct scene *s = p->scene;
    const size_t n = s->bodies;
    struct impact_gap g = {.a = (uint32_t)a,
                           .b = (uint32_t)b,
                           .sum = s->radius[a] + s->radius[b]};
    bool free = false;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const size_t i = k * n + a, j = k * n + b;
        g.image[k] = image_of(p, k, a, b);
        if (p->low[j] - g.image[k] > p->high[i] ||
            p->high[j] - g.image[k] < p->low[i])
            return;
        free = free || s->freedom[i] || s->freedom[j];
        g.rounding =
            fmax(g.rounding, fmax(fabs(p->high[i]), fabs(p->low[i])));
        g.rounding =
            fmax(g.rounding, fmax(fabs(p->high[j]), fabs(p->low[j])));
    }
    g.rounding = ROUNDING * (g.rounding + g.sum);
    if (free)
        add_gap(p, g, h);
}

/* Sorts the bodies by the lower limits of their paths along p->axis, by
   insertion as in pairs.c. */
static void sort_along(struct impact *p)
{
    const size_t n = p->scene->bodies;
    const double *low = p->low + p->axis * n;
    for (size_t i = 1; i < n; ++i) {
        const size_t body = p->order[i];
        size_t j = i;
        for (; j > 0; --j) {
            const size_t other = p->order[j - 1];
            if (low[other] <= low[body])
                break;
            p->order[j] = other;
        }
        p->order[j] = body;
    }
}

/* Finds pairs whose paths may meet. Like pairs.c, sweeps along one axis,
   but with paths instead of positions. If all axes are periodic, the bodies
   cannot be sorted, and every pair is examined. */
static void add_pairs(struct impact *p, double h)
{
    const size_t n = p->scene->bodies;
    const bool sorted = p->axis < SPHERES_AXES;
    const double *low = p->low + p->axis % SPHERES_AXES * n;
    const double *high = p->high + p->axis % SPHERES_AXES * n;
    if (sorted)
        sort_along(p);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            const size_t a = p->order[i], b = p->order[j];
            if (sorted && low[b] > high[a])
                break;
            ++p->pairs;
            add_pair(p, a < b ? a : b, a < b ? b : a, h);
        }
}

static int in_order(const void *a, const void *b)
{
    const struct impact_gap *g = a, *o = b;
    if (g->a != o->a)
        return g->a < o->a ? -1 : 1;
    return g->b < o->b ? -1 : g->b > o->b;
}

/* Collects all gaps that may close in the part: first the gaps at walls,
   then the gaps of pairs, sorted by the numbers of the bodies. Simultaneous
   contacts are resolved in this order. */
static void collect_gaps(struct impact *p, double h)
{
    const struct scene *s = p->scene;
    p->gaps = 0;
    ++p->parts;
    draw_paths(p, h);
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t i = 0; s->wall[k] == SCENE_HARD && i < s->bodies; ++i) {
            add_wall(p, k, i, -1, h);
            add_wall(p, k, i, 1, h);
        }
    const size_t walls = p->gaps;
    add_pairs(p, h);
    if (p->gaps > walls + 1)
        qsort(p->gap + walls, p->gaps - walls, sizeof *p->gap, in_order);
}

/* Repeats the step from the beginning of the part, with the length h (in
   s). */
static void go(struct impact *p, double h)
{
    struct stepping *s = p->stepping;
    if (s->own)
        adaptive_again(s->own, h, s->x, s->v);
    else
        stepping_recall(s, p->note);
    if (!s->own && h > 0)
        p->end = stepping_part(s, h);
}

/* Moves to the time h (in s) in the part. Returns the width of the gap
   minus g->start (in m), and sets *rate to its rate of change (in m/s). */
static double try(struct impact *p, const struct impact_gap *g, double h,
                  double *rate)
{
    go(p, h);
    return width(p, g, p->stepping->x, p->stepping->v, rate) - g->start;
}

/* Moves to the time *h <= most at which a gap closes: (11.9,
   eq:gap-newton). On entry *h is a guess. Returns false if the gap does not
   close. `shut` says whether the gap is closed at the time `most`. */
static bool close_gap(struct impact *p, const struct impact_gap *g,
                      double most, bool shut, double *h)
{
    double open = 0, last = INFINITY, rate;
    for (int k = 0; k < MOST_TRIALS && p->end == STEPPING_DONE; ++k) {
        if (!(*h > open && *h < most))
            *h = (open + most) / 2;
        const double w = try(p, g, *h, &rate), size = fabs(w);
        const bool parts = size <= g->rounding && rate >= 0;
        if (size <= g->rounding && rate < 0 &&
            (size <= g->rounding / 8 || size > last / 2))
            return true;
        if (parts && !shut)
            return false;
        if (parts || (w > 0 && (rate < 0 || shut)))
            open = *h;
        else
            most = *h;
        shut = shut || w < 0;
        if (!shut && rate < 0 && w > -rate * (most - open))
            return false;
        *h = parts ? most : *h - w / rate;
        last = size;
    }
    try(p, g, *h = most, &rate);
    return shut;
}

/* Returns the gap that closes first on the paths, or NULL. */
static struct impact_gap *first_gap(const struct impact *p)
{
    struct impact_gap *first = NULL;
    for (size_t i = 0; i < p->gaps; ++i)
        if (p->gap[i].root <= 1 && (!first || p->gap[i].root < first->root))
            first = &p->gap[i];
    return first;
}

/* Returns the gap that closed first before the time *h, or NULL if none
   did. Sets *h to an estimate of when it closed. Such a gap exists if two
   contacts are so close in time that the paths show them in the wrong
   order. */
static struct impact_gap *earlier_gap(const struct impact *p, double *h)
{
    const double now = *h;
    struct impact_gap *first = NULL;
    for (size_t i = 0; i < p->gaps; ++i) {
        double rate;
        struct impact_gap *g = &p->gap[i];
        const double w =
            width(p, g, p->stepping->x, p->stepping->v, &rate) - g->start;
        const double then = now + w / fabs(rate);
        if (w < -g->rounding && (!first || then < *h)) {
            first = g;
            *h = then;
        }
    }
    return first;
}

/* Abandons the step, and records the two bodies of the gap that caused
   this. */
static void abandon_step(struct impact *p, const struct impact_gap *g)
{
    p->crowded = true;
    p->between[0] = g->a;
    p->between[1] = g->b;
    p->end = STEPPING_STUCK;
}

/* Puts a body at rest at a wall. The velocity perpendicular to the wall
   becomes 0, and from now on the wall cancels the force that presses the
   body against it. */
static void hold(struct impact *p, const struct impact_gap *g)
{
    const size_t c = g->axis * p->scene->bodies + g->a;
    p->stepping->v[c] = 0;
    p->resting += p->held[c] == 0;
    p->held[c] = (signed char)g->side;
}

/* Releases all bodies that move away from the walls that hold them. */
static void release(struct impact *p)
{
    for (size_t c = 0; p->resting > 0 && c < p->forces.size; ++c)
        if (p->held[c] * p->stepping->v[c] < 0) {
            p->held[c] = 0;
            --p->resting;
        }
}

/* Moves to the time h (in s) in the part. Returns whether the force on some
   resting body then points away from its wall. */
static bool lifts(struct impact *p, double h)
{
    p->lifted = p->forces.size;
    go(p, h);
    return p->lifted < p->forces.size;
}

/* Moves to the time h (in s) in the part and returns h. If the force on a
   resting body reverses earlier and would lift the body off its wall, moves
   only to the time of the reversal and returns that time. The part ends
   there, so no step contains a kink in the forces. If the force reverses at
   once, the body is released and the part has length 0. */
static double rest(struct impact *p, double h)
{
    enum { BITS = 52 };
    double low = 0, high = h;
    if (!lifts(p, h))
        return h;
    if (lifts(p, ldexp(h, -ROOT_HALVINGS))) {
        p->held[p->lifted] = 0;
        --p->resting;
        high = 0;
    }
    for (int k = 0; k < BITS && high > 0; ++k)
        if (lifts(p, (low + high) / 2))
            high = (low + high) / 2;
        else
            low = (low + high) / 2;
    go(p, low);
    return low;
}

/* Reflects a body at a wall. If it would then rise only to a height within
   rounding errors, puts it at rest at the wall: (11.10, eq:rest). */
static void bounce(struct impact *p, const struct impact_gap *g)
{
    struct stepping *s = p->stepping;
    const size_t c = g->axis * p->scene->bodies + g->a;
    spheres_bounce(p->spheres, g->a, g->axis, s->v);
    if (g->start == 0)
        s->x[c] = g->edge;
    p->forces.accelerate(p->forces.what, s->x, s->v, p->pull);
    ++s->evaluations;
    const double pressing = g->side * p->pull[c];
    if (s->v[c] * s->v[c] <= 2 * pressing * g->rounding && pressing > 0)
        hold(p, g);
}

/* Resolves each contact whose gap is closing now, once. Returns whether any
   contact was resolved. */
static bool settle_once(struct impact *p, uint64_t *met)
{
    const uint64_t before = *met;
    struct stepping *s = p->stepping;
    for (size_t i = 0; i < p->gaps; ++i) {
        struct impact_gap *g = &p->gap[i];
        double rate;
        const double w = width(p, g, s->x, s->v, &rate) - g->start;
        if (w > g->rounding || rate >= -rate_rounding(p, g, s->v))
            continue;
        if (is_wall(g))
            bounce(p, g);
        else
            spheres_reflect(p->spheres, g->a, g->b, s->x, s->v);
        ++*met;
    }
    return *met > before;
}

/* Resolves closing contacts until none is left, since one collision may
   cause another at the same time, as in a row of touching balls. Before
   that, puts each body that is pressed against a wall at rest there. If two
   bodies are pressed together, abandons the step. */
static void settle(struct impact *p, uint64_t *met)
{
    uint64_t now = 0;
    int passes = 0;
    for (size_t i = 0; i < p->gaps; ++i)
        if (p->gap[i].pressed && p->gap[i].root == 0) {
            if (is_wall(&p->gap[i]))
                hold(p, &p->gap[i]);
            else
                abandon_step(p, &p->gap[i]);
        }
    while (p->end == STEPPING_DONE && settle_once(p, &now))
        if (++passes == MOST_PASSES)
            abandon_step(p, &p->gap[0]);
    p->simultaneous += now > 1 ? now - 1 : 0;
    *met += now;
    if (!p->stepping->own)
        stepping_disturb(p->stepping);
}

/* Moves to the first contact of the part, sets *h to its time (in s), and
   returns true. If there is no contact, moves to the end of the part and
   returns false. Skips contacts that occur on the polynomial paths but are
   not confirmed when the method itself moves the bodies. */
static bool find_contact(struct impact *p, double *h)
{
    const double most = *h;
    struct impact_gap *g;
    double rate;
    while ((g = first_gap(p)) && p->end == STEPPING_DONE) {
        *h = g->root * most;
        if (g->root == 0)
            try(p, g, 0, &rate);
        if (g->root == 0 || close_gap(p, g, most, g->shut, h))
            return true;
        g->root = INFINITY;
        ++p->grazing;
        *h = most;
        try(p, g, most, &rate);
    }
    return false;
}

/* Like find_contact, but also ensures that no other gap closes earlier.
   Such a gap may appear when the method moves the bodies, since its paths
   differ slightly from the polynomials. */
static bool find_first(struct impact *p, double *h)
{
    struct impact_gap *g;
    if (!find_contact(p, h))
        return false;
    double most = *h;
    for (size_t i = 0; i < p->gaps && (g = earlier_gap(p, h)) &&
                       close_gap(p, g, most, true, h);
         ++i)
        most = *h;
    return true;
}

/* Returns whether a shorter part is needed to decide whether bodies are
   pressed together. If `last` is true, no shorter part will be tried, and
   bodies in doubt count as pressed together. */
static bool is_unclear(struct impact *p, bool last)
{
    bool unclear = false;
    for (size_t i = 0; i < p->gaps; ++i) {
        struct impact_gap *g = &p->gap[i];
        unclear = unclear || g->unclear;
        g->pressed = g->unclear;
        g->root = g->unclear ? 0 : g->root;
    }
    return unclear && !last && p->end == STEPPING_DONE;
}

/* Advances by the rest of the step, or by the part before the first
   contact, and returns the time advanced (in s). While it is unclear
   whether bodies are pressed together, the part is halved, up to
   ROOT_HALVINGS times. A body that does not rise even in the shortest part
   is treated as pressed. */
static double take_part(struct impact *p, double left, uint64_t *met)
{
    double h = left;
    stepping_note(p->stepping, p->note);
    for (int k = 0;; ++k, h /= 2) {
        h = rest(p, h);
        collect_gaps(p, h);
        if (!is_unclear(p, k == ROOT_HALVINGS))
            break;
    }
    if (p->end == STEPPING_DONE && find_first(p, &h))
        settle(p, met);
    release(p);
    return h;
}

/* Returns the longest distance (in m) that a body may move in a step of an
   adaptive method. The last digits of the polynomials must distinguish a
   contact from a near miss. Therefore no body may cross the whole scene or
   move by more than 2^14 times the smallest radius, and two bodies must
   approach each other by less than half a periodic box. */
static double longest_way(const struct impact *p)
{
    const struct scene *s = p->scene;
    double wide = 0, way = INFINITY, radius = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        radius = fmax(radius, s->radius[i]);
        if (s->radius[i] > 0)
            way = fmin(way, 0x1p14 * s->radius[i]);
    }
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        double low = s->low[k], high = s->high[k];
        if (s->wall[k] == SCENE_OPEN)
            spread(s, k, &low, &high);
        const double side = high - low;
        if (s->wall[k] == SCENE_PERIODIC)
            way = fmin(way, fmax(side / 4 - radius, side / 64));
        wide = fmax(wide, side);
    }
    return wide > 0 ? fmin(way, wide) : way;
}

/* Returns the time (in s) in which the fastest body would move by
   longest_way. If the body with the largest acceleration would do so
   earlier, starting from rest, returns that time instead. */
static double longest_step(const struct impact *p)
{
    const struct adaptive *own = p->stepping->own;
    const double way = longest_way(p);
    double v = 0, a = 0, h = INFINITY;
    for (size_t c = 0; c < own->forces.size; ++c) {
        v = fmax(v, fabs(own->to.v[c]));
        a = fmax(a, own->begun ? fabs(own->to.a[c]) : 0);
    }
    if (v > 0)
        h = way / v;
    if (a * h * h > 2 * way)
        h = sqrt(2 * way / a);
    return h;
}

/* Takes a step whose length the adaptive method chooses, and searches it
   for contacts. The step ends at the first contact, which is resolved
   later. */
static void take_own(struct impact *p)
{
    struct stepping *s = p->stepping;
    const size_t n = s->forces.size;
    double h = longest_step(p);
    memcpy(p->note, s->own->to.x, n * sizeof *s->x);
    memcpy(p->note + n, s->own->to.v, n * sizeof *s->v);
    for (int k = 0;; ++k) {
        if (!adaptive_step(s->own, h)) {
            p->end = STEPPING_STUCK;
            return;
        }
        adaptive_look(s->own, s->own->t, s->x, s->v);
        h = p->resting > 0 ? rest(p, s->own->h) : s->own->h;
        collect_gaps(p, h);
        if (!is_unclear(p, k == ROOT_HALVINGS))
            break;
        go(p, 0);
        adaptive_turn(s->own, s->x, s->v);
        h /= 2;
    }
    p->waiting = p->end == STEPPING_DONE && find_first(p, &h);
    if (h == 0 && !p->waiting)
        adaptive_turn(s->own, s->x, s->v);
}

/* Resolves the contact at which the last adaptive step ended. */
static void turn_own(struct impact *p, uint64_t *met)
{
    struct stepping *s = p->stepping;
    adaptive_look(s->own, s->own->t, s->x, s->v);
    settle(p, met);
    release(p);
    adaptive_turn(s->own, s->x, s->v);
    p->waiting = false;
}

/* Does the work of impact_step for an adaptive method. The method chooses
   its steps, which usually end beyond the requested time and must not
   depend on it. These steps are searched for contacts and end at them. A
   contact is resolved when a later time is requested. */
static enum stepping_end reach_look(struct impact *p, uint64_t *met)
{
    struct stepping *s = p->stepping;
    struct adaptive *own = s->own;
    const uint64_t before = own->evaluations;
    const double t = s->start + (double)(s->steps + 1) * s->dt;
    if (stepping_anew(s))
        p->waiting = false;
    for (int parts = 0; own->t < t && p->end == STEPPING_DONE; ++parts) {
        if (p->waiting)
            turn_own(p, met);
        if (p->end == STEPPING_DONE)
            take_own(p);
        if (parts == MOST_PARTS && p->gaps > 0)
            abandon_step(p, &p->gap[0]);
    }
    s->evaluations += own->evaluations - before;
    if (p->end == STEPPING_DONE) {
        adaptive_look(own, t, s->x, s->v);
        ++s->steps;
    }
    return p->end;
}

enum stepping_end impact_step(struct impact *p, uint64_t *met)
{
    double left = p->stepping->dt;
    p->crowded = false;
    p->end = STEPPING_DONE;
    if (p->stepping->own)
        return reach_look(p, met);
    for (int parts = 0; left > 0 && p->end == STEPPING_DONE; ++parts) {
        left -= take_part(p, left, met);
        if (parts == MOST_PARTS && p->gaps > 0)
            abandon_step(p, &p->gap[0]);
    }
    p->stepping->steps += p->end == STEPPING_DONE;
    return p->end;
}
