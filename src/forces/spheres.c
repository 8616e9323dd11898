/* From chapters/11-spheres.nw: edit there, then run make tangle. */
/* checksum 116898278 of the lines below */
/* Pairs found along an axis, reflected one by one, and shifted. */
#include "forces/spheres.h"

#include <math.h>
#include <stdlib.h>

bool spheres_create(struct spheres *p, const struct scene *s,
                    enum spheres_rule rule)
{
    const size_t n = s->bodies;
    *p = (struct spheres){.rule = rule, .scene = s, .dt = s->dt};
    p->restitution = s->restitution;
    p->inverse = malloc(SPHERES_AXES * n * sizeof *p->inverse + 1);
    p->edge = malloc(n * sizeof *p->edge + 1);
    if (!p->inverse || !p->edge) {
        spheres_free(p);
        return false;
    }
    double least = INFINITY; /* of the radii so far, but for points */
    bool point = false;
    p->narrow = INFINITY;
    for (size_t i = 0; i < n; ++i) {
        p->widest = fmax(p->widest, s->radius[i]);
        p->narrow = fmin(p->narrow, s->radius[i] + least);
        if (s->radius[i] > 0)
            least = fmin(least, s->radius[i]);
        else
            point = true;
        p->edge[i].body = (uint32_t)i;
        p->edge[i].radius = s->radius[i];
        for (size_t k = 0; k < SPHERES_AXES; ++k)
            p->inverse[k * n + i] =
                s->freedom[k * n + i] ? 1 / s->mass[i] : 0;
    }
    if (point)
        p->narrow = least;
    return true;
}

void spheres_free(struct spheres *p)
{
    free(p->inverse);
    free(p->edge);
    free(p->pair);
    *p = (struct spheres){0};
}

/* Makes room for one more pair, or returns false. */
static bool make_room(struct spheres *p)
{
    if (p->pairs < p->room)
        return true;
    const size_t room = 2 * p->room + 16;
    void *pair = realloc(p->pair, room * sizeof *p->pair);
    if (!pair)
        return false;
    p->pair = pair;
    p->room = room;
    return true;
}

/* Two bodies, seen from the first. */
struct contact {
    size_t a, b;
    double apart[SPHERES_AXES], closing[SPHERES_AXES]; /* m, m/s */
    double distance, touching;                         /* m */
    double normal[SPHERES_AXES]; /* as long as the distance */
    double back;                 /* how long ago they touched, s */
};

double spheres_way(const struct scene *s, const double x[], size_t a,
                   size_t b, size_t k)
{
    const double d = x[k * s->bodies + b] - x[k * s->bodies + a];
    const double side = s->high[k] - s->low[k];
    if (s->wall[k] != SCENE_PERIODIC)
        return d;
    return d - side * floor(d / side + 0.5);
}

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_normal(struct contact *c, const double apart[])
{
    c->distance = sqrt(dot(apart, apart));
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        c->normal[k] = apart[k];
    if (c->distance == 0)
        c->normal[0] = c->distance = 1e-9 * c->touching;
}

static struct contact look_at(const struct spheres *p,
                              struct spheres_pair pair, const double x[],
                              const double v[])
{
    const struct scene *s = p->scene;
    struct contact c = {.a = pair.a, .b = pair.b};
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        const size_t at = k * s->bodies;
        c.apart[k] = spheres_way(s, x, c.a, c.b, k);
        c.closing[k] = v[at + c.b] - v[at + c.a];
    }
    c.touching = s->radius[c.a] + s->radius[c.b];
    set_normal(&c, c.apart);
    return c;
}

static bool go_back(struct contact *c, double dt)
{
    const double b = dot(c->apart, c->closing);
    const double out = c->touching * c->touching - dot(c->apart, c->apart);
    const double u2 = dot(c->closing, c->closing);
    double then[SPHERES_AXES];
    c->back = out / (sqrt(b * b + u2 * out) - b);
    if (!(b < 0 && c->back <= dt))
        return false;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        then[k] = c->apart[k] - c->closing[k] * c->back;
    set_normal(c, then);
    return true;
}

static double weight(const struct spheres *p, const struct contact *c,
                     size_t i)
{
    const size_t n = p->scene->bodies;
    double w = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        w += c->normal[k] * c->normal[k] * p->inverse[k * n + i];
    return w;
}

/* Gives a body J times the normal, an impulse. */
static void kick(const struct spheres *p, const struct contact *c, size_t i,
                 double J, double v[])
{
    const size_t n = p->scene->bodies;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        v[k * n + i] += J * c->normal[k] * p->inverse[k * n + i];
}

static double along(const struct spheres *p, const struct contact *c,
                    size_t i, const double v[])
{
    double sum = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        sum += c->normal[k] * v[k * p->scene->bodies + i];
    return sum;
}

/* Returns what it adds to the sum of m x v of the two, J s. */
static double push_apart(const struct spheres *p, const struct contact *c,
                         double wa, double wb, double x[], const double v[])
{
    const double depth = (c->touching - c->distance) * c->distance;
    double a = depth / (wa + wb), b = a;
    if (p->shift == SPHERES_BY_RADIUS && wa > 0 && wb > 0) {
        a = depth * (p->scene->radius[c->a] / c->touching) / wa;
        b = depth * (p->scene->radius[c->b] / c->touching) / wb;
    }
    kick(p, c, c->a, -a, x);
    kick(p, c, c->b, b, x);
    return b * along(p, c, c->b, v) - a * along(p, c, c->a, v);
}

/* Returns the impulse over the distance. */
static double reflect(struct spheres *p, const struct contact *c,
                      double parting, double w, double v[])
{
    const double J = -(1 + p->restitution) * parting / w;
    kick(p, c, c->a, -J, v);
    kick(p, c, c->b, J, v);
    p->virial += J * c->distance * c->distance;
    ++p->collisions;
    return J;
}

static bool collide_pair(struct spheres *p, struct spheres_pair pair,
                         double x[], double v[])
{
    struct contact c = look_at(p, pair, x, v);
    const double depth = c.touching - c.distance;
    const bool back = p->shift == SPHERES_BACK && go_back(&c, p->dt);
    const double parting = dot(c.closing, c.normal);
    const double wa = weight(p, &c, c.a), wb = weight(p, &c, c.b);
    if (!(depth > 0 && wa + wb > 0))
        return false;
    if (parting >= 0 && p->rule == SPHERES_APPROACHING) {
        if (p->shift != SPHERES_BACK)
            p->virial += push_apart(p, &c, wa, wb, x, v);
        return false;
    }
    const double J = reflect(p, &c, parting, wa + wb, v);
    if (back) {
        kick(p, &c, c.a, -J * c.back, x);
        kick(p, &c, c.b, J * c.back, x);
    } else
        p->virial += push_apart(p, &c, wa, wb, x, v);
    p->receding += parting >= 0;
    p->depth = fmax(p->depth, depth);
    return true;
}

/* Adds a pair if it may overlap when its turn comes; without memory it
   waits for the next step. */
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

static double margin(struct spheres *p, const double v[])
{
    const size_t n = p->scene->bodies;
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = fmax(most, v[i] * v[i] + v[n + i] * v[n + i] +
                              v[2 * n + i] * v[2 * n + i]);
    p->furthest = 2 * sqrt(most) * p->dt;
    return fmin(p->furthest, p->widest);
}

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

/* The axis along which the bodies take most room. */
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

/* Turns round body i, which is out of the wall at `edge` on the side
   sign along axis k, with coordinate *x. Returns whether it did. */
static bool bounce(struct spheres *p, size_t i, size_t k, double sign,
                   double edge, double *x, double *v)
{
    const double out = sign * (*x - edge);
    if (!(out > 0 && sign * *v > 0 &&
          p->scene->freedom[k * p->scene->bodies + i]))
        return false;
    p->impulse[k] += p->scene->mass[i] * (1 + p->restitution) * fabs(*v);
    *v *= -p->restitution;
    *x = edge - sign * p->restitution * out;
    ++p->wall_collisions;
    return true;
}

static uint64_t collide_walls(struct spheres *p, double x[], double v[])
{
    const struct scene *s = p->scene;
    const uint64_t before = p->wall_collisions;
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t i = 0; s->wall[k] == SCENE_HARD && i < s->bodies; ++i) {
            const size_t at = k * s->bodies + i;
            if (!bounce(p, i, k, -1, s->low[k] + s->radius[i], &x[at],
                        &v[at]))
                bounce(p, i, k, 1, s->high[k] - s->radius[i], &x[at],
                       &v[at]);
        }
    return p->wall_collisions - before;
}

static bool is_again(const struct spheres_pair pair[], size_t i)
{
    return i > 0 && pair[i].a == pair[i - 1].a &&
           pair[i].b == pair[i - 1].b;
}

enum { FEW = 16 };

/* Says whether every pair is looked at, and not only those along an axis.
 */
static bool is_every_pair(const struct spheres *p)
{
    return p->search == SPHERES_PAIRS ||
           (p->search == SPHERES_AUTO && p->scene->bodies <= FEW);
}

static void find_pairs(struct spheres *p, const double x[])
{
    static int (*const orders[SPHERES_ORDERS])(
        const void *, const void *) = {ascending, descending, deepest};
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
}

/* Was body i between the walls a step ago, on a straight line back? */
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

/* Says whether two bodies, which overlap neither now nor a step ago, were
   in each other in between, and the step took them further than the sum of
   their radii: nothing has seen them meet. Their paths are taken as
   straight lines back in time; one who has just turned at a wall is not
   looked at, since his are two. */
static bool has_passed(const struct spheres *p, struct spheres_pair pair,
                       const double x[], const double v[])
{
    const struct contact c = look_at(p, pair, x, v);
    const double b = dot(c.apart, c.closing), dt = p->dt;
    const double u2 = dot(c.closing, c.closing);
    const double now = dot(c.apart, c.apart);
    const double touching = c.touching * c.touching;
    const double then = now - 2 * b * dt + u2 * dt * dt;
    return u2 * dt * dt > touching && b > 0 && b < u2 * dt &&
           now >= touching && then >= touching &&
           now - b * b / u2 < touching * (1 - 1e-9) &&
           was_inside(p, c.a, x, v) && was_inside(p, c.b, x, v);
}

/* Counts the pairs that the step took through each other. */
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
            const struct spheres_pair pair = {
                a->body < b->body ? a->body : b->body,
                a->body < b->body ? b->body : a->body, 0};
            if (!has_passed(p, pair, x, v))
                continue;
            if (p->passed == 0) {
                p->through[0] = pair.a;
                p->through[1] = pair.b;
            }
            ++p->passed;
        }
}

uint64_t spheres_resolve(struct spheres *p, double x[], double v[])
{
    uint64_t count = collide_walls(p, x, v);
    p->margin = margin(p, v);
    find_pairs(p, x);
    if (p->furthest > p->narrow)
        find_passed(p, x, v);
    for (size_t i = 0; i < p->pairs; ++i)
        if (!is_again(p->pair, i))
            count += collide_pair(p, p->pair[i], x, v);
    return count;
}

void spheres_watch(struct spheres *p, const double x[], const double v[])
{
    margin(p, v);
    if (!(p->furthest > p->narrow))
        return;
    find_pairs(p, x);
    find_passed(p, x, v);
}

void spheres_reflect(struct spheres *p, size_t a, size_t b,
                     const double x[], double v[])
{
    const struct spheres_pair pair = {(uint32_t)a, (uint32_t)b, 0};
    const struct contact c = look_at(p, pair, x, v);
    const double w = weight(p, &c, a) + weight(p, &c, b);
    if (w > 0)
        reflect(p, &c, dot(c.closing, c.normal), w, v);
}

void spheres_bounce(struct spheres *p, size_t i, size_t k, double v[])
{
    double *u = &v[k * p->scene->bodies + i];
    p->impulse[k] += p->scene->mass[i] * (1 + p->restitution) * fabs(*u);
    *u *= -p->restitution;
    ++p->wall_collisions;
}

size_t spheres_overlaps(struct spheres *p, const double x[])
{
    size_t n = 0;
    p->margin = 0;
    p->order = SPHERES_ASCENDING;
    find_pairs(p, x);
    for (size_t i = 0; i < p->pairs; ++i)
        if (!is_again(p->pair, i))
            p->pair[n++] = p->pair[i];
    return p->pairs = n;
}

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
