/* Sums the forces of springs one by one, or in bands on a grid. */
#include "forces/springs.h"

#include "toolbox/aligned.h"
#include "toolbox/vector.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Returns the length of a spring (in m), by which its force is divided.
   DBL_MIN, the smallest normal number, is added to the square so that the
   quotient is finite for two bodies at the same position, and their force
   is 0. This does not change any length above 1e-145 m. */
static inline double stretched(double dx, double dy, double dz)
{
    return sqrt(dx * dx + dy * dy + dz * dz + DBL_MIN);
}

/* Returns the force of a spring divided by its length (in N/m). The product
   with the vector from body a to body b is the force on a. */
static inline double tension(double stiffness, double length, double rest)
{
    return stiffness * (length - rest) / length;
}

/* Returns the force of a spring with an axial dashpot, divided by the
   length (in N/m): (10.3, eq:axial-dashpot). rate is the scalar product of
   the vector from a to b and its rate of change (in m^2/s). */
static inline double axial_tension(double stiffness, double damping,
                                   double length, double rest, double rate)
{
    const double pull = stiffness * (length - rest);
    return (pull + damping * (rate / length)) / length;
}

/* Computes the force f (in N) of spring s on its body a: (10.1,
   eq:spring-force). */
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

/* Sums the forces of the first count springs into p->force, one by one. */
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

/* Returns a spring with its ends exchanged if necessary, so that a < b.
   This does not change the motion. */
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

/* Compares springs by stride, then kind, lower body and rest length. The
   order of the springs determines the order of all sums, in scatter and in
   the bands. Therefore only identical springs may compare as equal. */
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

/* Returns a sorted copy of the scene's springs, each with a < b, or NULL if
   memory runs out. */
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

/* Returns the end of the run of springs, from s[from] on, that have the
   same stride and kind. */
static size_t alike(const struct scene_spring s[], size_t from,
                    size_t count)
{
    size_t end = from + 1;
    while (end < count && s[end].kind == s[from].kind &&
           s[end].b - s[end].a == s[from].b - s[from].a)
        ++end;
    return end;
}

/* Returns whether n springs of one stride and kind should form a band. They
   should if their number is at least SPRINGS_BAND and at least half of the
   possible number, and if no two of them join the same bodies. Springs with
   equal lower bodies are adjacent. */
static bool regular(const struct scene_spring s[], size_t n)
{
    if (n < SPRINGS_BAND || 2 * n < s[n - 1].a - s[0].a + (size_t)1)
        return false;
    for (size_t i = 1; i < n; ++i)
        if (s[i].a == s[i - 1].a)
            return false;
    return true;
}

/* Creates a band of n springs. A missing spring gets a negative rest
   length, which no real spring has. Returns false if memory runs out. */
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

/* Fills p->spring from `all`, which is sorted: first the springs in no
   band, then the springs in bands. Creates the bands. Returns false if
   memory runs out. */
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

/* Fills in inverse and gravity, and sets quiet and even (see springs.h). */
static void read_masses(struct springs *p, const struct scene *s)
{
    p->quiet = p->friction == 0;
    p->even = true;
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < p->bodies; ++i) {
            const size_t at = k * p->bodies + i;
            const bool pulled = s->freedom[at] && s->mass[i] > 0;
            p->inverse[at] = pulled ? 1 / s->mass[i] : 0;
            p->gravity[at] = s->freedom[at] ? s->gravity[k] : 0;
            p->quiet = p->quiet && p->gravity[at] == 0;
            p->even = p->even && p->inverse[at] == p->inverse[i];
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
    p->inverse = aligned_doubles(3 * p->bodies);
    p->gravity = aligned_doubles(3 * p->bodies);
    p->force = aligned_doubles(3 * p->bodies);
    bool made =
        all && p->spring && p->kind && p->inverse && p->gravity && p->force;
    if (made) {
        if (s->kinds)
            memcpy(p->kind, s->kind, s->kinds * sizeof *p->kind);
        read_masses(p, s);
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
    free(p->inverse);
    free(p->gravity);
    free(p->force);
    free(p->buffer);
    *p = (struct springs){0};
}

/* A section of a band. Successive axes are `bodies` numbers apart in the
   arrays of positions and velocities, and `row` numbers apart in the array
   of forces. */
struct stretch {
    const double *rest;
    size_t count, stride, bodies, row;
    double stiffness, damping;
};

/* Computes the forces f of the springs of a section along three axes. This
   is the inner loop of the module. x and v begin with the lower body of the
   first spring. Memory is read and written in order.

   To avoid a branch, the force of a missing spring, which has a negative
   rest length, is also computed. It is multiplied by `here`, which is 0 for
   such a spring and otherwise 1. The operations and their order are those
   of pull, so the bits are equal. */
static inline void stretch(const struct stretch *t,
                           const double *restrict x,
                           const double *restrict v, double *restrict f,
                           bool damped, bool axial)
{
    const size_t n = t->bodies, s = t->stride;
    const size_t y = n, z = 2 * n, fy = t->row, fz = 2 * t->row;
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

/* Compile the loop three times, with constants for damped and axial, so
   that the loop tests neither. */
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

/* Returns a, limited to the range from low to high. */
static ptrdiff_t clamp(ptrdiff_t a, ptrdiff_t low, ptrdiff_t high)
{
    return a < low ? low : a > high ? high : a;
}

/* Writes into f, axis by axis, the forces of `count` springs, beginning
   with the spring whose lower body is `from`. The axes are `row` numbers
   apart. The force is 0 where the band has no spring. `from` is negative
   for springs that would reach into the first block. */
static void band_forces(const struct springs *p,
                        const struct springs_band *b, const double x[],
                        const double v[], ptrdiff_t from, size_t count,
                        double f[], size_t row)
{
    const ptrdiff_t end = from + (ptrdiff_t)count;
    const ptrdiff_t low = clamp((ptrdiff_t)b->first, from, end);
    const ptrdiff_t high = clamp((ptrdiff_t)b->end, low, end);
    for (size_t k = 0; k < 3; ++k) {
        double *const axis = f + k * row;
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
        row,          b->stiffness,         b->damping};
    if (b->damping == 0)
        stretch_plain(&t, x + low, v + low, f + (low - from));
    else if (p->axial)
        stretch_axial(&t, x + low, v + low, f + (low - from));
    else
        stretch_damped(&t, x + low, v + low, f + (low - from));
}

/* Returns the length of a row. A row contains the forces of a band along
   one axis: first those of the springs that end in a block, then those of
   the springs that begin there. For body i of the block, (10.11, eq:gather)
   therefore reads row[i] for the spring that ends at the body, and row[i +
   stride] for the spring that begins there. */
static size_t row_size(const struct springs_band *b)
{
    return b->stride + SPRINGS_BLOCK;
}

/* Returns how many numbers a thread needs for all rows. Each band has three
   rows. */
static size_t buffer_size(const struct springs *p)
{
    size_t size = 0;
    for (size_t b = 0; b < p->bands; ++b)
        size += 3 * row_size(&p->band[b]);
    return size;
}

/* Adds the forces of one band on n bodies: (10.11, eq:gather). The spring
   that ends at body i contributes -f[i]; the spring that begins there
   contributes +f[i + s]. */
VECTOR_LOOP static void sum_one(double *restrict sum,
                                const double *restrict f, size_t s,
                                size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum[i] = sum[i] - f[i] + f[i + s];
}

/* Like sum_one, but adds the forces of two bands, one after the other. */
VECTOR_LOOP static void sum_two(double *restrict sum,
                                const double *restrict f, size_t s,
                                const double *restrict g, size_t t,
                                size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum[i] = sum[i] - f[i] + f[i + s] - g[i] + g[i + t];
}

/* Sums the forces in buffer on n bodies from body `from` on, along axis k.
   The forces of scatter come first, if there are any, then the forces of
   the bands in order. Taking two bands in each pass halves the number of
   passes over the sums. */
static void sum_axis(const struct springs *p, size_t from, size_t n,
                     size_t k, const double buffer[], double sum[])
{
    const struct springs_band *b = p->band, *end = b + p->bands;
    if (p->listed > 0)
        memcpy(sum, p->force + k * p->bodies + from, n * sizeof *sum);
    else
        memset(sum, 0, n * sizeof *sum);
    for (; b < end; b += 2) {
        const double *const f = buffer + k * row_size(b);
        buffer += 3 * row_size(b);
        if (b + 1 == end) {
            sum_one(sum, f, b->stride, n);
            return;
        }
        sum_two(sum, f, b->stride, buffer + k * row_size(b + 1),
                b[1].stride, n);
        buffer += 3 * row_size(b + 1);
    }
}

/* Compute the accelerations of n coordinates from the forces. The first
   function adds them to a[], the second writes them into a[], and the
   third also includes gravity and friction. The first two read only the
   arrays that they need, since memory limits the speed for large grids. */
VECTOR_LOOP static void add_scaled(double *restrict a,
                                   const double *restrict inverse,
                                   const double *restrict force, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] += inverse[i] * force[i];
}

VECTOR_LOOP static void write_scaled(double *restrict a,
                                     const double *restrict inverse,
                                     const double *restrict force, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] = 0 + inverse[i] * force[i]; /* 0 + turns -0 into +0, as adding
                                             would */
}

VECTOR_LOOP static void write_all(double *restrict a,
                                  const double *restrict inverse,
                                  const double *restrict force,
                                  const double *restrict gravity,
                                  double friction, const double *restrict v,
                                  size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] = gravity[i] - friction * (inverse[i] * v[i]) +
               inverse[i] * force[i];
}

/* A task is to compute the accelerations at x and v. They are added to a[]
   or, if `writes` is true, written into a[] together with gravity and
   friction. */
struct task {
    const double *x, *v;
    double *a;
    bool writes;
    /* If `ahead` is not NULL, it moves bodies just before the springs read
       them. `owing` says whether the last step still lacks half a kick. */
    const struct stepping_ahead *ahead;
    bool owing;
};

/* Completes the task along axis k for n bodies from body `from` on. `force`
   has the forces of the springs. If inverse masses are equal along all
   axes, they are read from one array, which stays in the cache. */
static void finish(const struct springs *p, const struct task *t, size_t k,
                   size_t from, size_t n, const double force[])
{
    const size_t at = k * p->bodies + from;
    const double *const inverse = p->inverse + (p->even ? from : at);
    if (!t->writes)
        add_scaled(t->a + at, inverse, force, n);
    else if (p->quiet)
        write_scaled(t->a + at, inverse, force, n);
    else
        write_all(t->a + at, inverse, force, p->gravity + at, p->friction,
                  t->v + at, n);
}

/* Returns whether the springs form two bands and nothing else acts, as in a
   membrane. One loop, scale_two, then computes the accelerations from the
   forces of the bands without storing their sum. */
static bool is_plain(const struct springs *p)
{
    return p->bands == 2 && p->listed == 0 && p->quiet;
}

VECTOR_LOOP static void scale_two(double *restrict a,
                                  const double *restrict inverse,
                                  const double *restrict f, size_t s,
                                  const double *restrict g, size_t t,
                                  size_t n)
{
    for (size_t i = 0; i < n; ++i)
        a[i] = 0 + inverse[i] * (0 - f[i] + f[i + s] - g[i] + g[i + t]);
}

/* Sums two bands and completes the task in one loop. Requires is_plain. */
static void write_two(const struct springs *p, double a[], size_t k,
                      size_t from, size_t n, const double buffer[])
{
    const struct springs_band *const one = p->band, *const two = one + 1;
    const size_t at = k * p->bodies + from;
    const double *const f = buffer + k * row_size(one);
    const double *const g = buffer + 3 * row_size(one) + k * row_size(two);
    scale_two(a + at, p->inverse + (p->even ? from : at), f, one->stride, g,
              two->stride, n);
}

/* Does the task for a block of n bodies from body `from` on. Before, the
   buffer contains the forces of the springs that reach into this block from
   earlier bodies; afterwards, those of the springs that reach into the next
   block. Strides may exceed n, so the copied ranges may overlap. */
static void gather_block(const struct springs *p, const struct task *t,
                         size_t from, size_t n, double buffer[])
{
    double sum[SPRINGS_BLOCK], *f = buffer;
    for (size_t b = 0; b < p->bands; ++b) {
        const size_t size = row_size(&p->band[b]);
        band_forces(p, &p->band[b], t->x, t->v, (ptrdiff_t)from, n,
                    f + p->band[b].stride, size);
        f += 3 * size;
    }
    for (size_t k = 0; k < 3; ++k) {
        if (t->writes && is_plain(p)) {
            write_two(p, t->a, k, from, n, buffer);
            continue;
        }
        sum_axis(p, from, n, k, buffer, sum);
        finish(p, t, k, from, n, sum);
    }
    f = buffer;
    for (size_t b = 0; b < p->bands; ++b)
        for (size_t k = 0; k < 3; ++k, f += row_size(&p->band[b]))
            memmove(f, f + n, p->band[b].stride * sizeof *f);
}

/* Lets the stepping method move bodies `from` to end - 1. */
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

/* Returns the longest stride, which is how far ahead the springs read
   bodies. */
static size_t reach(const struct springs *p)
{
    size_t longest = 0;
    for (size_t b = 0; b < p->bands; ++b)
        if (p->band[b].stride > longest)
            longest = p->band[b].stride;
    return longest;
}

/* Computes the forces of the springs that reach into the block at body
   `from` from earlier bodies. The thread that handles those bodies may be
   another one. It computes the same forces with equal bits, so nothing is
   summed across threads. */
static void reach_in(const struct springs *p, const struct task *t,
                     size_t from, double buffer[])
{
    for (size_t b = 0; b < p->bands; ++b) {
        const size_t stride = p->band[b].stride;
        band_forces(p, &p->band[b], t->x, t->v,
                    (ptrdiff_t)from - (ptrdiff_t)stride, stride, buffer,
                    row_size(&p->band[b]));
        buffer += 3 * row_size(&p->band[b]);
    }
}

/* Completes the task for bodies `from` to end - 1, block by block. */
static void gather(const struct springs *p, const struct task *t,
                   size_t from, size_t end, double buffer[])
{
    reach_in(p, t, from, buffer);
    for (size_t at = from, n; at < end; at += n) {
        n = end - at < SPRINGS_BLOCK ? end - at : SPRINGS_BLOCK;
        gather_block(p, t, at, n, buffer);
    }
}

/* Takes `steps` steps of the task, at most depth_of(p), in one sweep over
   the bodies. Each step has its own buffer and counts the bodies it has
   moved and the bodies whose forces it has summed. A step advances by a
   block as soon as the previous step has passed all bodies that the block
   reads.

   The buffers begin with zeros, since no spring reaches into the first
   block. At the end of a sweep they contain zeros again, since no spring
   reaches beyond the last body. */
static void march(const struct springs *p, struct task t, size_t steps)
{
    const size_t n = p->bodies, far = reach(p), size = buffer_size(p);
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
            gather_block(p, &t, at, block, p->buffer + k * size);
            moved[k] = seen;
            summed[k] = at + block;
        }
}

/* Returns how many steps a sweep takes at once. The data of all bodies from
   the first to the last of these steps must fit into the second-level
   cache. A body has about 200 bytes, including the forces in the
   buffers. */
static size_t depth_of(const struct springs *p)
{
    const size_t depth = SPRINGS_WINDOW / (reach(p) + SPRINGS_BLOCK);
    return depth < 1 ? 1 : least(depth, SPRINGS_DEPTH);
}

/* Gives each thread a contiguous part of the bodies. The first springs of a
   part read bodies of the previous part, and the last springs those of the
   next part. If there are several threads, each first moves its bodies and
   waits for the others. */
static void gather_shared(struct springs *p, const struct task *task)
{
    const size_t size = buffer_size(p), threads = (size_t)p->threads;
    const size_t n = p->bodies;
    if (threads == 1) {
        gather(p, task, 0, n, p->buffer);
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
                   p->buffer + t * size);
    }
}

/* Allocates a buffer for each thread, or for each step of a sweep. Must be
   called before a run, not during one. */
bool springs_threads(struct springs *p, int threads)
{
    const size_t buffers = threads > 1 ? (size_t)threads : depth_of(p);
    assert(threads > 0);
    double *const buffer = aligned_doubles(buffer_size(p) * buffers);
    if (!buffer)
        return false;
    free(p->buffer);
    p->buffer = buffer;
    p->threads = threads;
    return true;
}

/* Does the task with p->engine. Unless there are bands to gather, all
   forces come from scatter. One call of finish then completes all axes,
   which are contiguous in all arrays. */
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

/* Takes `steps` steps of the task, whose `ahead` is not NULL. If any
   springs are summed by scatter, which accesses bodies in the order of the
   springs, all bodies are moved before it. */
static void act_ahead(struct springs *p, struct task t, uint64_t steps)
{
    const struct stepping_ahead *const ahead = t.ahead;
    const bool whole = p->engine != SPRINGS_GATHER || p->listed > 0;
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
