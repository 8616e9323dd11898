/* From chapters/10-springs.nw: edit there, then run make tangle. */
/* checksum 1927206365 of the lines below */
/* Sums forces spring by spring, or in bands where they form a grid. */
#include "forces/springs.h"

#include "toolbox/room.h"
#include "toolbox/vector.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The stretched length over which a force is divided: never zero. */
static inline double stretched(double dx, double dy, double dz)
{
    return sqrt(dx * dx + dy * dy + dz * dz + DBL_MIN);
}

/* What draws body a towards body b, per metre of the way between them. */
static inline double tension(double stiffness, double length, double rest)
{
    return stiffness * (length - rest) / length;
}

/* The same with a dashpot along the axis; rate is the scalar product of
   the way from a to b and its rate of change, m^2/s. */
static inline double axial_tension(double stiffness, double damping,
                                   double length, double rest, double rate)
{
    const double pull = stiffness * (length - rest);
    return (pull + damping * (rate / length)) / length;
}

/* The force f of spring s on its body a. */
static void pull(const struct springs *p, const struct scene_spring *s,
                 const double x[], const double v[], double f[3])
{
    const struct scene_kind *kind = &p->kind[s->kind];
    const size_t y = p->bodies, z = 2 * y, a = s->a, b = s->b;
    const double dx = x[b] - x[a], dy = x[y + b] - x[y + a],
                 dz = x[z + b] - x[z + a];
    const double ux = v[b] - v[a], uy = v[y + b] - v[y + a],
                 uz = v[z + b] - v[z + a];
    const double length = stretched(dx, dy, dz), c = kind->damping;
    if (p->axial) {
        const double q = axial_tension(kind->stiffness, c, length, s->rest,
                                       dx * ux + dy * uy + dz * uz);
        f[0] = q * dx, f[1] = q * dy, f[2] = q * dz;
        return;
    }
    const double q = tension(kind->stiffness, length, s->rest);
    f[0] = q * dx + c * ux, f[1] = q * dy + c * uy, f[2] = q * dz + c * uz;
}

/* Sums the forces of the first count springs into p->force. */
static void scatter(struct springs *p, size_t count, const double x[],
                    const double v[])
{
    double *const fx = p->force, *const fy = fx + p->bodies;
    double *const fz = fy + p->bodies;
    memset(p->force, 0, 3 * p->bodies * sizeof *p->force);
    for (size_t i = 0; i < count; ++i) {
        const struct scene_spring *s = &p->spring[i];
        double f[3];
        pull(p, s, x, v, f);
        fx[s->a] += f[0], fy[s->a] += f[1], fz[s->a] += f[2];
        fx[s->b] -= f[0], fy[s->b] -= f[1], fz[s->b] -= f[2];
    }
}

/* Turns a spring so that a < b: the force changes its sign twice. */
static struct scene_spring forwards(struct scene_spring s)
{
    const uint32_t a = s.a;
    if (s.b < s.a) {
        s.a = s.b;
        s.b = a;
    }
    return s;
}

static int sign(double x, double y)
{
    return (x > y) - (x < y);
}

/* Order: by stride, by kind, by body; by rest length if all that is equal.
 */
static int before(const void *one, const void *other)
{
    const struct scene_spring *s = one, *t = other;
    const uint32_t stride = s->b - s->a, than = t->b - t->a;
    if (stride != than)
        return stride < than ? -1 : 1;
    if (s->kind != t->kind)
        return s->kind < t->kind ? -1 : 1;
    if (s->a != t->a)
        return s->a < t->a ? -1 : 1;
    return sign(s->rest, t->rest);
}

/* The scene's springs, turned and in order; NULL without memory. */
static struct scene_spring *in_order(const struct scene *s)
{
    struct scene_spring *all = malloc((s->springs + 1) * sizeof *all);
    if (!all)
        return NULL;
    for (size_t i = 0; i < s->springs; ++i)
        all[i] = forwards(s->spring[i]);
    qsort(all, s->springs, sizeof *all, before);
    return all;
}

/* Returns where the springs that have stride and kind of s[from] end. */
static size_t alike(const struct scene_spring s[], size_t from,
                    size_t count)
{
    size_t end = from + 1;
    while (end < count && s[end].kind == s[from].kind &&
           s[end].b - s[end].a == s[from].b - s[from].a)
        ++end;
    return end;
}

/* Are n springs that are alike enough for a band: many, dense, no two of
   them between the same bodies? */
static bool regular(const struct scene_spring s[], size_t n)
{
    if (n < SPRINGS_BAND || 2 * n < s[n - 1].a - s[0].a + (size_t)1)
        return false;
    for (size_t i = 1; i < n; ++i)
        if (s[i].a == s[i - 1].a)
            return false;
    return true;
}

static bool make_band(struct springs *p, const struct scene_spring s[],
                      size_t n)
{
    const size_t first = s[0].a, end = s[n - 1].a + (size_t)1;
    struct springs_band *b = &p->band[p->bands];
    *b = (struct springs_band){.stride = s[0].b - s[0].a,
                               .first = first,
                               .end = end,
                               .stiffness = p->kind[s[0].kind].stiffness,
                               .damping = p->kind[s[0].kind].damping,
                               .rest =
                                   malloc((end - first) * sizeof *b->rest)};
    ++p->bands;
    if (!b->rest)
        return false;
    for (size_t i = 0; i < end - first; ++i)
        b->rest[i] = -1;
    for (size_t i = 0; i < n; ++i)
        b->rest[s[i].a - first] = s[i].rest;
    return true;
}

/* Fills p->spring from all, which is in order: first what lies in no band.
   Makes the bands. */
static bool sort_out(struct springs *p, const struct scene_spring all[])
{
    size_t bands = 0, at = 0, end;
    for (int banded = 0; banded < 2; ++banded) {
        p->listed = banded ? at : 0;
        if (banded && !(p->band = calloc(bands + 1, sizeof *p->band)))
            return false;
        for (size_t from = 0; from < p->count; from = end) {
            end = alike(all, from, p->count);
            const size_t n = end - from;
            if (regular(all + from, n) != banded) {
                bands += !banded;
                continue;
            }
            memcpy(p->spring + at, all + from, n * sizeof *all);
            at += n;
            if (banded && !make_band(p, all + from, n))
                return false;
        }
    }
    return true;
}

/* 1/m of the bodies, and gravity, where they are free. */
static void weigh(struct springs *p, const struct scene *s)
{
    p->quiet = p->friction == 0;
    p->even = true;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < p->bodies; ++i) {
            const size_t at = k * p->bodies + i;
            const bool pulled = s->freedom[at] && s->mass[i] > 0;
            p->weight[at] = pulled ? 1 / s->mass[i] : 0;
            p->fall[at] = s->freedom[at] ? s->gravity[k] : 0;
            p->quiet = p->quiet && p->fall[at] == 0;
            p->even = p->even && p->weight[at] == p->weight[i];
        }
}

bool springs_create(struct springs *p, const struct scene *s)
{
    struct scene_spring *all = in_order(s);
    *p = (struct springs){.bodies = s->bodies,
                          .count = s->springs,
                          .friction = s->damping,
                          .axial = s->axial};
    p->spring = malloc((p->count + 1) * sizeof *p->spring);
    p->kind = malloc((s->kinds + 1) * sizeof *p->kind);
    p->weight = room_doubles(3 * p->bodies);
    p->fall = room_doubles(3 * p->bodies);
    p->force = room_doubles(3 * p->bodies);
    bool made =
        all && p->spring && p->kind && p->weight && p->fall && p->force;
    if (made) {
        if (s->kinds)
            memcpy(p->kind, s->kind, s->kinds * sizeof *p->kind);
        weigh(p, s);
        made = sort_out(p, all) && springs_threads(p, 1);
    }
    free(all);
    if (!made)
        springs_free(p);
    return made;
}

void springs_free(struct springs *p)
{
    for (size_t i = 0; i < p->bands; ++i)
        free(p->band[i].rest);
    free(p->band);
    free(p->spring);
    free(p->kind);
    free(p->weight);
    free(p->fall);
    free(p->force);
    free(p->room);
    *p = (struct springs){0};
}

/* A stretch of a band: what its springs are, and how far apart the axes
   lie, of places and velocities (bodies) and of forces (room). */
struct stretch {
    const double *rest;
    size_t count, stride, bodies, room;
    double stiffness, damping;
};

/* x and v begin with the lower bodies of the stretch. */
static inline void stretch(const struct stretch *t,
                           const double *restrict x,
                           const double *restrict v, double *restrict f,
                           bool damped, bool axial)
{
    const size_t n = t->bodies, s = t->stride;
    const size_t y = n, z = 2 * n, fy = t->room, fz = 2 * t->room;
    for (size_t i = 0; i < t->count; ++i) {
        const double dx = x[i + s] - x[i], dy = x[y + i + s] - x[y + i],
                     dz = x[z + i + s] - x[z + i];
        const double length = stretched(dx, dy, dz);
        const double here = 0.5 + copysign(0.5, t->rest[i]);
        const double stiffness = here * t->stiffness;
        double ux = 0, uy = 0, uz = 0,
               q = tension(stiffness, length, t->rest[i]);
        if (damped) {
            const double c = here * t->damping;
            ux = v[i + s] - v[i];
            uy = v[y + i + s] - v[y + i];
            uz = v[z + i + s] - v[z + i];
            if (axial) {
                q = axial_tension(stiffness, c, length, t->rest[i],
                                  dx * ux + dy * uy + dz * uz);
                ux = uy = uz = 0;
            }
            ux *= c, uy *= c, uz *= c;
        }
        f[i] = q * dx + ux;
        f[fy + i] = q * dy + uy;
        f[fz + i] = q * dz + uz;
    }
}

/* The loop three times over, so that none of them asks what it is. */
VECTOR_LOOP static void stretch_plain(const struct stretch *t,
                                      const double *restrict x,
                                      const double *restrict v,
                                      double *restrict f)
{
    stretch(t, x, v, f, false, false);
}

VECTOR_LOOP static void stretch_damped(const struct stretch *t,
                                       const double *restrict x,
                                       const double *restrict v,
                                       double *restrict f)
{
    stretch(t, x, v, f, true, false);
}

VECTOR_LOOP static void stretch_axial(const struct stretch *t,
                                      const double *restrict x,
                                      const double *restrict v,
                                      double *restrict f)
{
    stretch(t, x, v, f, true, true);
}

/* Where a lies in the range from low to high. */
static ptrdiff_t clamp(ptrdiff_t a, ptrdiff_t low, ptrdiff_t high)
{
    return a < low ? low : a > high ? high : a;
}

/* The forces of the springs from body `from` on, count of them, into f,
   axis by axis, room apart: 0 where the band has no spring. */
static void band_forces(const struct springs *p,
                        const struct springs_band *b, const double x[],
                        const double v[], ptrdiff_t from, size_t count,
                        double f[], size_t room)
{
    const ptrdiff_t end = from + (ptrdiff_t)count;
    const ptrdiff_t low = clamp((ptrdiff_t)b->first, from, end);
    const ptrdiff_t high = clamp((ptrdiff_t)b->end, low, end);
    for (size_t k = 0; k < 3; ++k) {
        double *const axis = f + k * room;
        for (ptrdiff_t i = from; i < low; ++i)
            axis[i - from] = 0;
        for (ptrdiff_t i = high; i < end; ++i)
            axis[i - from] = 0;
    }
    if (low == high)
        return;
    const size_t in = (size_t)low - b->first;
    const struct stretch t = {
        b->rest + in, (size_t)(high - low), b->stride, p->bodies,
        room,         b->stiffness,         b->damping};
    if (b->damping == 0)
        stretch_plain(&t, x + low, v + low, f + (low - from));
    else if (p->axial)
        stretch_axial(&t, x + low, v + low, f + (low - from));
    else
        stretch_damped(&t, x + low, v + low, f + (low - from));
}

/* Room of a band for one axis: the forces of the springs at a block's
   bodies, and before them of those that reach into the block. */
static size_t room_of(const struct springs_band *b)
{
    return b->stride + SPRINGS_BLOCK;
}

/* Room of a thread. */
static size_t room_of_all(const struct springs *p)
{
    size_t room = 0;
    for (size_t b = 0; b < p->bands; ++b)
        room += 3 * room_of(&p->band[b]);
    return room;
}

/* For n bodies: minus the force f[i] of the spring from below, plus that of
   the spring from here, f[i + s]; first of one band and then of another. */
VECTOR_LOOP static void sum_two(double *restrict sum,
                                const double *restrict f, size_t s,
                                const double *restrict g, size_t t,
                                size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum[i] = sum[i] - f[i] + f[i + s] - g[i] + g[i + t];
}

VECTOR_LOOP static void sum_one(double *restrict sum,
                                const double *restrict f, size_t s,
                                size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum[i] = sum[i] - f[i] + f[i + s];
}

/* The forces in room on n bodies from body `from` on, along axis k. */
static void sum_axis(const struct springs *p, size_t from, size_t n,
                     size_t k, const double room[], double sum[])
{
    const struct springs_band *b = p->band, *end = b + p->bands;
    if (p->listed > 0)
        memcpy(sum, p->force + k * p->bodies + from, n * sizeof *sum);
    else
        memset(sum, 0, n * sizeof *sum);
    for (; b < end; b += 2) {
        const double *const f = room + k * room_of(b);
        room += 3 * room_of(b);
        if (b + 1 == end) {
            sum_one(sum, f, b->stride, n);
            return;
        }
        sum_two(sum, f, b->stride, room + k * room_of(b + 1), b[1].stride,
                n);
        room += 3 * room_of(b + 1);
    }
}

/* From the forces to the accelerations a of n coordinates, where all arrays
   begin: added to a, written, or written on top of gravity and friction. */
VECTOR_LOOP static void add_weighed(double *restrict a,
                                    const double *restrict weight,
                                    const double *restrict force, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] += weight[i] * force[i];
}

VECTOR_LOOP static void write_weighed(double *restrict a,
                                      const double *restrict weight,
                                      const double *restrict force,
                                      size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] = 0 + weight[i] * force[i];
}

VECTOR_LOOP static void write_all(double *restrict a,
                                  const double *restrict weight,
                                  const double *restrict force,
                                  const double *restrict fall,
                                  double friction, const double *restrict v,
                                  size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] =
            fall[i] - friction * (weight[i] * v[i]) + weight[i] * force[i];
}

/* A task of adding forces to a, or of writing what acts there into a. */
struct task {
    const double *x, *v;
    double *a;
    bool writes;
    /* NULL, or who gets x and v ready, and whether a kick is owing: */
    const struct stepping_ahead *ahead;
    bool owing;
};

/* Finishes the task along axis k for n bodies from body `from` on, on which
   the springs exert these forces. Weights that are even are read once. */
static void finish(const struct springs *p, const struct task *t, size_t k,
                   size_t from, size_t n, const double force[])
{
    const size_t at = k * p->bodies + from;
    const double *const weight = p->weight + (p->even ? from : at);
    if (!t->writes)
        add_weighed(t->a + at, weight, force, n);
    else if (p->quiet)
        write_weighed(t->a + at, weight, force, n);
    else
        write_all(t->a + at, weight, force, p->fall + at, p->friction,
                  t->v + at, n);
}

static bool is_plain(const struct springs *p)
{
    return p->bands == 2 && p->listed == 0 && p->quiet;
}

VECTOR_LOOP static void weigh_two(double *restrict a,
                                  const double *restrict weight,
                                  const double *restrict f, size_t s,
                                  const double *restrict g, size_t t,
                                  size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] = 0 + weight[i] * (0 - f[i] + f[i + s] - g[i] + g[i + t]);
}

/* As sum_axis and finish, for two bands and no more. */
static void write_two(const struct springs *p, double a[], size_t k,
                      size_t from, size_t n, const double room[])
{
    const struct springs_band *const one = p->band, *const two = one + 1;
    const size_t at = k * p->bodies + from;
    const double *const f = room + k * room_of(one);
    const double *const g = room + 3 * room_of(one) + k * room_of(two);
    weigh_two(a + at, p->weight + (p->even ? from : at), f, one->stride, g,
              two->stride, n);
}

/* The forces of all bands for n bodies from body `from` on. At first the
   room holds those of the springs that reach into the block; in the end, of
   those that reach into the next. */
static void gather_block(const struct springs *p, const struct task *t,
                         size_t from, size_t n, double room[])
{
    double sum[SPRINGS_BLOCK], *f = room;
    for (size_t b = 0; b < p->bands; ++b) {
        const size_t size = room_of(&p->band[b]);
        band_forces(p, &p->band[b], t->x, t->v, (ptrdiff_t)from, n,
                    f + p->band[b].stride, size);
        f += 3 * size;
    }
    for (size_t k = 0; k < 3; ++k) {
        if (t->writes && is_plain(p)) {
            write_two(p, t->a, k, from, n, room);
            continue;
        }
        sum_axis(p, from, n, k, room, sum);
        finish(p, t, k, from, n, sum);
    }
    f = room;
    for (size_t b = 0; b < p->bands; ++b)
        for (size_t k = 0; k < 3; ++k, f += room_of(&p->band[b]))
            memmove(f, f + n, p->band[b].stride * sizeof *f);
}

/* Has the bodies from `from` to before end moved. */
static void get_ready(const struct springs *p, const struct task *t,
                      size_t from, size_t end)
{
    for (size_t k = 0; k < 3 && from < end; ++k)
        t->ahead->ready(t->ahead->step, k * p->bodies + from, end - from,
                        t->owing);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}
static size_t reach(const struct springs *p)
{
    size_t longest = 0;
    for (size_t b = 0; b < p->bands; ++b)
        if (p->band[b].stride > longest)
            longest = p->band[b].stride;
    return longest;
}

/* The forces that reach into the block at body `from`. */
static void reach_in(const struct springs *p, const struct task *t,
                     size_t from, double room[])
{
    for (size_t b = 0; b < p->bands; ++b) {
        const size_t stride = p->band[b].stride;
        band_forces(p, &p->band[b], t->x, t->v,
                    (ptrdiff_t)from - (ptrdiff_t)stride, stride, room,
                    room_of(&p->band[b]));
        room += 3 * room_of(&p->band[b]);
    }
}

/* The task for the bodies from `from` to before end. */
static void gather(const struct springs *p, const struct task *t,
                   size_t from, size_t end, double room[])
{
    reach_in(p, t, from, room);
    for (size_t at = from, n; at < end; at += n) {
        n = end - at < SPRINGS_BLOCK ? end - at : SPRINGS_BLOCK;
        gather_block(p, t, at, n, room);
    }
}

/* The task for so many steps in one sweep, at most depth_of(p). No spring
   reaches into the first block: the rooms for that are zero when they are
   made, and again after a sweep, as none goes on behind the last body. */
static void march(const struct springs *p, struct task t, size_t steps)
{
    const size_t n = p->bodies, far = reach(p), size = room_of_all(p);
    size_t moved[SPRINGS_DEPTH] = {0}, summed[SPRINGS_DEPTH] = {0};
    const bool owing = t.owing;
    while (summed[steps - 1] < n)
        for (size_t k = 0; k < steps; ++k) {
            const size_t at = summed[k], rest = n - at;
            const size_t block = least(rest, SPRINGS_BLOCK);
            const size_t seen = at + least(rest, block + far);
            if (rest == 0 || (k > 0 && seen > summed[k - 1]))
                continue;
            t.owing = owing || k > 0;
            get_ready(p, &t, moved[k], seen);
            gather_block(p, &t, at, block, p->room + k * size);
            moved[k] = seen;
            summed[k] = at + block;
        }
}

static size_t depth_of(const struct springs *p)
{
    const size_t depth = SPRINGS_WINDOW / (reach(p) + SPRINGS_BLOCK);
    return depth < 1 ? 1 : least(depth, SPRINGS_DEPTH);
}

static void gather_shared(struct springs *p, const struct task *task)
{
    const size_t size = room_of_all(p), threads = (size_t)p->threads;
    const size_t n = p->bodies;
    if (threads == 1) {
        gather(p, task, 0, n, p->room);
        return;
    }
#ifdef _OPENMP
#pragma omp parallel num_threads(p->threads)
#endif
    {
#ifdef _OPENMP
#pragma omp for schedule(static, 1)
#endif
        for (size_t t = 0; t < threads; ++t)
            if (task->ahead)
                get_ready(p, task, n * t / threads, n * (t + 1) / threads);
#ifdef _OPENMP
#pragma omp for schedule(static, 1)
#endif
        for (size_t t = 0; t < threads; ++t)
            gather(p, task, n * t / threads, n * (t + 1) / threads,
                   p->room + t * size);
    }
}

bool springs_threads(struct springs *p, int threads)
{
    const size_t rooms = threads > 1 ? (size_t)threads : depth_of(p);
    assert(threads > 0);
    double *const room = room_doubles(room_of_all(p) * rooms);
    if (!room)
        return false;
    free(p->room);
    p->room = room;
    p->threads = threads;
    return true;
}

static void act(struct springs *p, const struct task *t)
{
    const bool gathers = p->engine == SPRINGS_GATHER && p->bands > 0;
    const size_t one_by_one = gathers ? p->listed : p->count;
    if (one_by_one > 0 || !gathers)
        scatter(p, one_by_one, t->x, t->v);
    if (gathers) {
        gather_shared(p, t);
        return;
    }
    finish(p, t, 0, 0, 3 * p->bodies, p->force);
}

/* So many steps of the task, whose ahead is not NULL. */
static void act_ahead(struct springs *p, struct task t, uint64_t steps)
{
    const struct stepping_ahead *const ahead = t.ahead;
    const bool whole =
        p->engine != SPRINGS_GATHER || p->bands == 0 || p->listed > 0;
    const bool alone = !whole && p->threads == 1;
    for (size_t k; steps > 0; steps -= k, t.owing = true) {
        k = alone ? least(depth_of(p), steps) : 1;
        t.ahead = ahead;
        if (alone) {
            march(p, t, k);
            continue;
        }
        if (whole) {
            get_ready(p, &t, 0, p->bodies);
            t.ahead = NULL;
        }
        act(p, &t);
    }
}

void springs_add(struct springs *p, const double x[], const double v[],
                 double a[])
{
    act(p, &(struct task){x, v, a, .writes = false});
}

void springs_accelerate(void *springs, const double x[], const double v[],
                        double a[])
{
    act(springs, &(struct task){x, v, a, .writes = true});
}

void springs_sweep(void *springs, const double x[], const double v[],
                   double a[], const struct stepping_ahead *ahead,
                   uint64_t steps)
{
    act_ahead(springs, (struct task){x, v, a, true, ahead, false}, steps);
}

struct stepping_forces springs_forces(struct springs *p)
{
    return (struct stepping_forces){.size = 3 * p->bodies,
                                    .damped = p->friction > 0 ||
                                              springs_damped(p),
                                    .accelerate = springs_accelerate,
                                    .what = p};
}

bool springs_damped(const struct springs *p)
{
    for (size_t i = 0; i < p->count; ++i)
        if (p->kind[p->spring[i].kind].damping > 0)
            return true;
    return false;
}

double springs_potential(const struct springs *p, const double x[])
{
    double sum = 0;
    for (size_t i = 0; i < p->count; ++i) {
        const struct scene_spring *s = &p->spring[i];
        double d[3];
        for (size_t k = 0; k < 3; ++k)
            d[k] = x[k * p->bodies + s->b] - x[k * p->bodies + s->a];
        const double more = stretched(d[0], d[1], d[2]) - s->rest;
        sum += p->kind[s->kind].stiffness * more * more / 2;
    }
    return sum;
}
