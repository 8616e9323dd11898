/* Finds overlapping pairs of spheres, by testing all or by a sweep. */
#include "forces/pairs.h"

#include <math.h>
#include <stdlib.h>

enum { FEW = 16 }; /* most bodies for which all pairs are tested */

/* Computes the largest radius and, for find_passed, the smallest sum of two
   radii that is not 0. */
static void measure_radii(struct spheres *p)
{
    const struct scene *s = p->scene;
    double least = INFINITY; /* smallest radius so far that is not 0 */
    bool point = false;
    p->narrow = INFINITY;
    for (size_t i = 0; i < s->bodies; ++i) {
        p->widest = fmax(p->widest, s->radius[i]);
        p->narrow = fmin(p->narrow, s->radius[i] + least);
        if (s->radius[i] > 0)
            least = fmin(least, s->radius[i]);
        else
            point = true;
    }
    if (point)
        p->narrow = least;
}

bool pairs_begin(struct spheres *p)
{
    const size_t n = p->scene->bodies;
    p->edge = malloc(n * sizeof *p->edge + 1);
    for (size_t i = 0; p->edge && i < n; ++i) {
        p->edge[i].body = (uint32_t)i;
        p->edge[i].radius = p->scene->radius[i];
    }
    measure_radii(p);
    return p->edge != NULL;
}

void pairs_end(struct spheres *p)
{
    free(p->edge);
    free(p->pair);
}

/* Makes room for one more pair. Returns false if memory runs out. The list
   stays short because few pairs collide in a step. */
static bool make_room(struct spheres *p)
{
    if (p->pairs < p->capacity)
        return true;
    const size_t capacity = 2 * p->capacity + 16;
    void *pair = realloc(p->pair, capacity * sizeof *p->pair);
    if (!pair)
        return false;
    p->pair = pair;
    p->capacity = capacity;
    return true;
}

/* Adds a pair to the list if the gap between the bodies is less than
   p->margin. Positions are folded into the box, so every difference is less
   than the side of the box. A difference of more than half the side is
   replaced by the shorter way round. This gives the nearest image without
   rounding a quotient to a whole number of sides. Along axes that are not
   periodic p->half is infinite. */
static void test(struct spheres *p, const struct spheres_edge *a,
                 const struct spheres_edge *b)
{
    const double touching = a->radius + b->radius;
    const double near = touching + p->margin;
    double square = 0;
    ++p->tested;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        double d = fabs(b->place[k] - a->place[k]);
        if (d > p->half[k])
            d = 2 * p->half[k] - d;
        if (!(d < near))
            return;
        square += d * d;
    }
    if (square >= near * near || !make_room(p))
        return;
    struct spheres_pair *pair = &p->pair[p->pairs++];
    pair->a = a->body < b->body ? a->body : b->body;
    pair->b = a->body < b->body ? b->body : a->body;
    pair->depth = touching - sqrt(square);
}

static void find_in_all(struct spheres *p)
{
    for (size_t i = 0; i < p->scene->bodies; ++i)
        for (size_t j = i + 1; j < p->scene->bodies; ++j)
            test(p, &p->edge[i], &p->edge[j]);
}

/* Stores the positions of all bodies in p->edge, folded into the box along
   periodic axes. */
static void read_places(struct spheres *p, const double x[])
{
    const struct scene *s = p->scene;
    const size_t n = s->bodies;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const double side = s->high[k] - s->low[k];
        const bool periodic = s->wall[k] == SCENE_PERIODIC;
        p->half[k] = periodic ? side / 2 : INFINITY;
        for (size_t i = 0; i < n; ++i) {
            double *place = &p->edge[i].place[k];
            *place = x[k * n + p->edge[i].body];
            if (periodic)
                *place -= side * floor((*place - s->low[k]) / side);
        }
    }
}

/* Computes p->furthest, the largest distance (in m) by which two bodies
   can approach each other in a step. */
static void set_furthest(struct spheres *p, const double v[])
{
    const size_t n = p->scene->bodies;
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = fmax(most, v[i] * v[i] + v[n + i] * v[n + i] +
                              v[2 * n + i] * v[2 * n + i]);
    p->furthest = 2 * sqrt(most) * p->dt;
}

/* Sorts the bodies along an axis by insertion. The order hardly changes
   between steps, so this takes little more than one comparison per body. */
static void mend_order(struct spheres_edge edge[], size_t n, size_t axis)
{
    for (size_t i = 1; i < n; ++i) {
        const struct spheres_edge e = edge[i];
        size_t j = i;
        for (; j > 0 && edge[j - 1].place[axis] > e.place[axis]; --j)
            edge[j] = edge[j - 1];
        edge[j] = e;
    }
}

static int along_axis(const void *a, const void *b, size_t k)
{
    const struct spheres_edge *p = a, *q = b;
    if (p->place[k] != q->place[k])
        return p->place[k] < q->place[k] ? -1 : 1;
    return p->body < q->body ? -1 : p->body > q->body;
}

/* Compares two edges along x. Each axis needs its own function, since qsort
   passes no further argument. */
static int along_x(const void *a, const void *b)
{
    return along_axis(a, b, 0);
}

static int along_y(const void *a, const void *b)
{
    return along_axis(a, b, 1);
}

static int along_z(const void *a, const void *b)
{
    return along_axis(a, b, 2);
}

static size_t longest_axis(const struct spheres *p)
{
    size_t longest = 0;
    double most = -1;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < p->scene->bodies; ++i) {
            low = fmin(low, p->edge[i].place[k]);
            high = fmax(high, p->edge[i].place[k]);
        }
        if (high - low > most) {
            most = high - low;
            longest = k;
        }
    }
    return longest;
}

/* Sorts the edges. Uses qsort the first time, since insertion would take a
   time proportional to the square of the number of bodies. Later the edges
   are nearly sorted, and insertion is faster. */
static void sort_edges(struct spheres *p)
{
    static int (*const along[SPHERES_AXES])(const void *, const void *) = {
        along_x, along_y, along_z};
    const size_t n = p->scene->bodies;
    if (p->sorted) {
        mend_order(p->edge, n, p->axis);
        return;
    }
    p->axis = longest_axis(p);
    qsort(p->edge, n, sizeof *p->edge, along[p->axis]);
    p->sorted = true;
}

/* Tests each body with those that follow it along the axis within its own
   radius plus the largest radius and the margin. Along a periodic axis the
   last body is followed by the first, shifted by the side of the box. In a
   box of only a few diameters a pair may be found twice. */
static void sweep(struct spheres *p)
{
    const size_t n = p->scene->bodies, k = p->axis;
    const double side = 2 * p->half[k];
    for (size_t i = 0; i < n; ++i) {
        const struct spheres_edge *a = &p->edge[i];
        const double reach =
            a->place[k] + a->radius + p->widest + p->margin;
        for (size_t j = i + 1; j < n && p->edge[j].place[k] < reach; ++j)
            test(p, a, &p->edge[j]);
        for (size_t j = 0; j < i && p->edge[j].place[k] + side < reach; ++j)
            test(p, a, &p->edge[j]);
    }
}

static int ascending(const void *a, const void *b)
{
    const struct spheres_pair *p = a, *q = b;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    return p->b < q->b ? -1 : p->b > q->b;
}

static int descending(const void *a, const void *b)
{
    return ascending(b, a);
}

static int deepest(const void *a, const void *b)
{
    const struct spheres_pair *p = a, *q = b;
    if (p->depth != q->depth)
        return p->depth > q->depth ? -1 : 1;
    return ascending(a, b);
}

/* Returns whether all pairs are tested, not only neighbours along an
   axis. */
static bool is_every_pair(const struct spheres *p)
{
    return p->search == SPHERES_PAIRS ||
           (p->search == SPHERES_AUTO && p->scene->bodies <= FEW);
}

/* Returns whether pair i of the sorted list equals pair i - 1. */
static bool is_again(const struct spheres_pair pair[], size_t i)
{
    return i > 0 && pair[i].a == pair[i - 1].a &&
           pair[i].b == pair[i - 1].b;
}

/* Finds the pairs that are nearer than the margin, each once. Sorts them,
   so that the result does not depend on the order in which they were
   found. */
static void find_near(struct spheres *p, const double x[])
{
    static int (*const orders[SPHERES_ORDERS])(
        const void *, const void *) = {ascending, descending, deepest};
    size_t n = 0;
    p->pairs = 0;
    read_places(p, x);
    if (is_every_pair(p))
        find_in_all(p);
    else {
        sort_edges(p);
        sweep(p);
    }
    if (p->pairs > 1)
        qsort(p->pair, p->pairs, sizeof *p->pair, orders[p->order]);
    for (size_t i = 0; i < p->pairs; ++i)
        if (!is_again(p->pair, i))
            p->pair[n++] = p->pair[i];
    p->pairs = n;
}

/* Returns whether body i was between the walls before the step, assuming a
   straight path. */
static bool was_inside(const struct spheres *p, size_t i, const double x[],
                       const double v[])
{
    const struct scene *s = p->scene;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const size_t c = k * s->bodies + i;
        const double then = x[c] - v[c] * p->dt, r = s->radius[i];
        const double slack = 1e-9 * (s->high[k] - s->low[k]);
        if (s->wall[k] == SCENE_HARD &&
            (then < s->low[k] + r - slack || then > s->high[k] - r + slack))
            return false;
    }
    return true;
}

/* Returns whether a step has missed the collision of two bodies: they
   overlap neither before nor after the step, but did so in between, and
   moved relative to each other by more than the sum of their radii. Paths
   are taken as straight. A body that has just bounced off a wall is
   ignored, since its path has a corner. */
static bool has_passed(const struct spheres *p, size_t i, size_t j,
                       const double x[], const double v[])
{
    const size_t n = p->scene->bodies;
    const double sum = p->scene->radius[i] + p->scene->radius[j];
    const double touching = sum * sum, dt = p->dt;
    double now = 0, b = 0, u2 = 0; /* d.d, d.u, u.u of the relative position
                                      d and velocity u */
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const double d = spheres_way(p->scene, x, i, j, k);
        const double u = v[k * n + j] - v[k * n + i];
        now += d * d;
        b += d * u;
        u2 += u * u;
    }
    const double then = now - 2 * b * dt + u2 * dt * dt;
    return u2 * dt * dt > touching && b > 0 && b < u2 * dt &&
           now >= touching && then >= touching &&
           now - b * b / u2 < touching * (1 - 1e-9) &&
           was_inside(p, i, x, v) && was_inside(p, j, x, v);
}

/* Counts the pairs that moved through each other in the step. */
static void find_passed(struct spheres *p, const double x[],
                        const double v[])
{
    const size_t n = p->scene->bodies, k = p->axis;
    const double reach = p->furthest + 2 * p->widest;
    const bool all = is_every_pair(p) || reach >= p->half[k];
    for (size_t i = 0; i < n; ++i)
        for (size_t m = 1; m < n && p->passed < SPHERES_PASSED; ++m) {
            const size_t j = i + m < n ? i + m : i + m - n;
            const struct spheres_edge *a = &p->edge[i], *b = &p->edge[j];
            const double turn = j < i ? 2 * p->half[k] : 0;
            if (all ? j < i : !(b->place[k] + turn - a->place[k] < reach))
                break;
            const uint32_t low = a->body < b->body ? a->body : b->body;
            const uint32_t high = a->body < b->body ? b->body : a->body;
            if (!has_passed(p, low, high, x, v))
                continue;
            if (p->passed == 0) {
                p->through[0] = low;
                p->through[1] = high;
            }
            ++p->passed;
        }
}

/* Also lists pairs that do not overlap but are within a margin, since
   pushing one pair apart may make another pair overlap. spheres.c tests
   each listed pair again when its turn comes. The double loop of MPPhys
   detects such a new overlap only if the turn of that pair is still to
   come. */
void pairs_find(struct spheres *p, const double x[], const double v[])
{
    set_furthest(p, v);
    p->margin = fmin(p->furthest, p->widest);
    find_near(p, x);
    if (p->furthest > p->narrow)
        find_passed(p, x, v);
}

void spheres_watch(struct spheres *p, const double x[], const double v[])
{
    set_furthest(p, v);
    if (!(p->furthest > p->narrow))
        return;
    find_near(p, x);
    find_passed(p, x, v);
}

size_t spheres_overlaps(struct spheres *p, const double x[])
{
    p->margin = 0;
    p->order = SPHERES_ASCENDING;
    find_near(p, x);
    return p->pairs;
}

/* Returns the largest depth (in m) by which a body is beyond a hard wall
   without moving back. */
static double beyond_walls(const struct scene *s)
{
    double most = 0;
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        const size_t i = c % s->bodies, k = c / s->bodies;
        const double x = s->position[c], r = s->radius[i];
        if (s->wall[k] != SCENE_HARD || !s->freedom[c])
            continue;
        if (s->velocity[c] <= 0)
            most = fmax(most, s->low[k] + r - x);
        if (s->velocity[c] >= 0)
            most = fmax(most, x + r - s->high[k]);
    }
    return most;
}

static bool can_move(const struct scene *s, size_t i)
{
    bool can = false;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        can = can || s->freedom[k * s->bodies + i] != 0;
    return can;
}

double spheres_depth(const struct scene *s)
{
    struct spheres p;
    if (!s->contact)
        return 0;
    if (!spheres_create(&p, s, SPHERES_ALL))
        return INFINITY;
    double depth = beyond_walls(s);
    spheres_overlaps(&p, s->position);
    for (size_t j = 0; j < p.pairs; ++j)
        if (can_move(s, p.pair[j].a) || can_move(s, p.pair[j].b))
            depth = fmax(depth, p.pair[j].depth);
    spheres_free(&p);
    return depth;
}
