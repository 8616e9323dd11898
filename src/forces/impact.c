/* From chapters/11-spheres.nw: edit there, then run make tangle. */
/* checksum 2312945122 of the lines below */
/* Gaps followed along a step in Bernstein's form, then by the method. */
#include "forces/impact.h"

#include "toolbox/room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEGREE = 6, HALVINGS = 24, MOST_TRIALS = 100 };
enum { MOST_PARTS = 10000, MOST_PASSES = 1000 };

/* What may be rounding, of a place or of a velocity: some units in the last
   place. */
static const double ROUNDING = 0x1p-50;

/* Between two bodies, or, with a == b, between one and a wall. */
struct impact_gap {
    uint32_t a, b;
    size_t axis;                /* of a wall */
    double side, edge;          /* -1 or 1; where a centre is stopped, m */
    double image[SPHERES_AXES]; /* of b in a periodic box, m */
    double sum;                 /* of the radii of a pair, m */
    double start;               /* what counts as closed, 0 or below, m */
    double rounding;            /* what counts as nothing, m */
    double root;                /* first, in units of the part */
    bool shut;                  /* at the end of the part */
    bool pressed;               /* closed, at rest, and drawn together */
};

/* The forces that are left where walls take up what presses on them. */
static void accelerate(void *what, const double x[], const double v[],
                       double a[])
{
    const struct impact *p = what;
    p->forces.accelerate(p->forces.what, x, v, a);
    for (size_t c = 0; p->resting > 0 && c < p->forces.size; ++c)
        if (p->held[c] * a[c] > 0)
            a[c] = 0;
}

/* Along which axis of walls, or open, the bodies take most room. */
static size_t widest_axis(const struct scene *s)
{
    size_t widest = SPHERES_AXES;
    double most = 0;
    for (size_t k = 0; k < SPHERES_AXES; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (size_t c = k * s->bodies; c < (k + 1) * s->bodies; ++c) {
            low = fmin(low, s->position[c]);
            high = fmax(high, s->position[c]);
        }
        if (s->wall[k] != SCENE_PERIODIC && high - low > most) {
            most = high - low;
            widest = k;
        }
    }
    return widest;
}

static void share_out(struct impact *p, size_t n)
{
    p->control = p->note + 5 * n + 1;
    p->low = p->control + 4 * n;
    p->high = p->low + n;
    p->pull = p->high + n;
}

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
    p->note = room_doubles(12 * n + 1);
    if (!p->held || !p->order || !p->note) {
        impact_free(p);
        return false;
    }
    share_out(p, n);
    for (size_t i = 0; i < p->scene->bodies; ++i)
        p->order[i] = i;
    s->forces.accelerate = accelerate;
    s->forces.what = p;
    s->sweep = NULL;
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

/* How wide a gap is, m; *rate: how fast it opens, m/s. */
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

/* How much of the rate of a gap may be rounding, m/s. */
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

/* The path of each coordinate in a part of length h: (11.8,
   eq:gap-control). */
static void draw_paths(struct impact *p, double h)
{
    const struct stepping *s = p->stepping;
    const size_t n = s->forces.size;
    const double *x = p->note, *v = p->note + n;
    for (size_t c = 0; c < n; ++c) {
        double *q = p->control + 4 * c;
        q[0] = x[c];
        q[1] = x[c] + h * v[c] / 3;
        q[2] = s->x[c] - h * s->v[c] / 3;
        q[3] = s->x[c];
        const double low = fmin(fmin(q[0], q[1]), fmin(q[2], q[3]));
        const double high = fmax(fmax(q[0], q[1]), fmax(q[2], q[3]));
        const double radius = p->scene->radius[c % p->scene->bodies];
        const double more =
            radius + ROUNDING * (fmax(fabs(low), fabs(high)) + radius);
        p->low[c] = low - more;
        p->high[c] = high + more;
    }
}

/* The control points of a wall's gap along the part. */
static size_t wall_points(const struct impact *p,
                          const struct impact_gap *g, double q[])
{
    const size_t c = g->axis * p->scene->bodies + g->a;
    for (size_t j = 0; j <= 3; ++j)
        q[j] = g->side * (g->edge - p->control[4 * c + j]);
    return 3;
}

/* Those of a pair's, of the square of its distance less that of sum. */
static size_t pair_points(const struct impact *p,
                          const struct impact_gap *g, double q[])
{
    static const double choose3[] = {1, 3, 3, 1},
                        choose6[] = {1, 6, 15, 20, 15, 6, 1};
    const size_t n = p->scene->bodies;
    double d[4][SPHERES_AXES];
    for (size_t k = 0; k < SPHERES_AXES; ++k)
        for (size_t j = 0; j <= 3; ++j)
            d[j][k] = p->control[4 * (k * n + g->b) + j] -
                      p->control[4 * (k * n + g->a) + j] - g->image[k];
    for (size_t j = 0; j <= 6; ++j)
        q[j] = -g->sum * g->sum;
    for (size_t i = 0; i <= 3; ++i)
        for (size_t j = 0; j <= 3; ++j)
            q[i + j] +=
                choose3[i] * choose3[j] / choose6[i + j] * dot(d[i], d[j]);
    return 6;
}

/* Divides what is zero at the start by the time. */
static size_t divide_by_time(double q[], size_t m)
{
    for (size_t j = 0; j < m; ++j)
        q[j] = q[j + 1] * (double)m / (double)(j + 1);
    return m - 1;
}

static bool is_positive(const double q[], size_t m)
{
    for (size_t j = 0; j <= m; ++j)
        if (!(q[j] > 0))
            return false;
    return true;
}

/* Halves a curve: q becomes its first half, r its second. */
static void halve(double q[], double r[], size_t m)
{
    for (size_t level = 0; level <= m; ++level) {
        r[m - level] = q[m];
        size_t j = m;
        while (j > level) {
            q[j] = (q[j - 1] + q[j]) / 2;
            --j;
        }
    }
}

/* The first place from 0 to 1 where a curve with q[0] > 0 may come to 0:
   INFINITY if there is none. */
static double first_root(const double q[], size_t m, int halvings)
{
    double left[DEGREE + 1], right[DEGREE + 1];
    if (is_positive(q, m))
        return INFINITY;
    if (halvings == 0)
        return 0.5;
    memcpy(left, q, (m + 1) * sizeof *q);
    halve(left, right, m);
    const double before = first_root(left, m, halvings - 1);
    return before <= 1 ? before / 2
                       : (1 + first_root(right, m, halvings - 1)) / 2;
}

/* Does a curve go below 0 by more than rounding? */
static bool goes_below(const double q[], size_t m, double rounding)
{
    for (size_t j = 0; j <= m; ++j)
        if (q[j] < -rounding)
            return true;
    return false;
}

/* The root of a gap that is closed at the start and does not close
   further: the next one. The slope there is known. */
static double next_root(struct impact_gap *g, double q[], size_t m,
                        double slope, double rounding)
{
    for (size_t j = m + 1; j-- > 0;)
        q[j] -= q[0];
    m = divide_by_time(q, m);
    q[0] = slope;
    if (slope > 0)
        return goes_below(q, m, rounding) ? first_root(q, m, HALVINGS)
                                          : INFINITY;
    q[0] = 0;
    m = divide_by_time(q, m);
    g->pressed = q[0] < -(double)(DEGREE * DEGREE) * rounding || g->shut;
    return g->pressed ? 0 : INFINITY;
}

/* Where in a part of length h a gap closes. */
static void find_root(const struct impact *p, struct impact_gap *g,
                      double h)
{
    const struct stepping *s = p->stepping;
    const double *x = p->note, *v = x + s->forces.size;
    double q[DEGREE + 1], rate, end;
    const double w = width(p, g, x, v, &rate);
    const double unit = is_wall(g) ? 1 : 2 * (g->sum + w);
    const double slack = rate_rounding(p, g, v);
    const size_t m =
        is_wall(g) ? wall_points(p, g, q) : pair_points(p, g, q);
    g->start = w < -g->rounding ? w : 0;
    g->shut = width(p, g, s->x, s->v, &end) - g->start < -g->rounding;
    g->pressed = false;
    g->root = 0;
    if (w > g->rounding)
        g->root = goes_below(q, m, unit * g->rounding)
                      ? first_root(q, m, HALVINGS)
                      : INFINITY;
    else if (rate >= -slack)
        g->root = next_root(g, q, m, rate > slack ? h * rate * unit : 0,
                            unit * g->rounding);
}

/* Adds a gap to those of the part, if it closes or has closed. */
static void add_gap(struct impact *p, struct impact_gap g, double h)
{
    if (p->gaps == p->room) {
        const size_t room = 2 * p->room + 16;
        void *gap = realloc(p->gap, room * sizeof *p->gap);
        if (!gap) {
            p->end = STEPPING_STUCK;
            return;
        }
        p->gap = gap;
        p->room = room;
    }
    find_root(p, &g, h);
    p->gap[p->gaps++] = g;
}

static void add_wall(struct impact *p, size_t k, size_t i, double side,
                     double h)
{
    const struct scene *s = p->scene;
    const size_t c = k * s->bodies + i;
    const double edge =
        side > 0 ? s->high[k] - s->radius[i] : s->low[k] + s->radius[i];
    const double out =
        side > 0 ? p->high[c] - s->high[k] : s->low[k] - p->low[c];
    if (!(out > 0 && s->freedom[c]))
        return;
    add_gap(p,
            (struct impact_gap){.a = (uint32_t)i,
                                .b = (uint32_t)i,
                                .axis = k,
                                .side = side,
                                .edge = edge,
                                .rounding =
                                    ROUNDING * (fabs(edge) + s->radius[i])},
            h);
}

/* How far b's nearest image is from b, m. */
static double image_of(const struct impact *p, size_t k, size_t a, size_t b)
{
    const struct scene *s = p->scene;
    const double *x = p->note + k * s->bodies;
    const double side = s->high[k] - s->low[k];
    return s->wall[k] == SCENE_PERIODIC
               ? side * floor((x[b] - x[a]) / side + 0.5)
               : 0;
}

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

/* Brings the bodies into the order in which their paths begin. */
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

/* All gaps that may close in the part: walls, then pairs, in order. */
static void collect_gaps(struct impact *p, double h)
{
    const struct scene *s = p->scene;
    p->gaps = 0;
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

/* The method's own path: to h after the note. How wide the gap is there,
   m. */
static double try(struct impact *p, const struct impact_gap *g, double h,
                  double *rate)
{
    struct stepping *s = p->stepping;
    stepping_recall(s, p->note);
    if (h > 0)
        p->end = stepping_part(s, h);
    return width(p, g, s->x, s->v, rate) - g->start;
}

/* Goes to the moment *h, of at most `most`, at which a gap closes; *h
   begins as a guess. false: it does not. (11.9, eq:gap-newton) */
static bool close_gap(struct impact *p, const struct impact_gap *g,
                      double most, bool shut, double *h)
{
    double open = 0, last = INFINITY, rate;
    for (int k = 0; k < MOST_TRIALS && p->end == STEPPING_DONE; ++k) {
        if (!(*h > open && *h < most))
            *h = (open + most) / 2;
        const double w = try(p, g, *h, &rate), size = fabs(w);
        if (size <= g->rounding &&
            (rate >= 0 || size <= g->rounding / 8 || size > last / 2))
            return rate < 0;
        if (w > 0 && (rate < 0 || shut))
            open = *h;
        else
            most = *h;
        shut = shut || w < 0;
        if (!shut && rate < 0 && w > -rate * (most - open))
            return false;
        *h -= w / rate;
        last = size;
    }
    try(p, g, *h = most, &rate);
    return shut;
}

/* The gap that closes first, on the paths. */
static struct impact_gap *first_gap(const struct impact *p)
{
    struct impact_gap *first = NULL;
    for (size_t i = 0; i < p->gaps; ++i)
        if (p->gap[i].root <= 1 && (!first || p->gap[i].root < first->root))
            first = &p->gap[i];
    return first;
}

/* A gap that the method has closed before, at about *h; or NULL. */
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

/* Gives the step up. */
static void crowd(struct impact *p, const struct impact_gap *g)
{
    p->crowded = true;
    p->between[0] = g->a;
    p->between[1] = g->b;
    p->end = STEPPING_STUCK;
}

/* A wall takes up from now on what presses the body on it. */
static void hold(struct impact *p, const struct impact_gap *g)
{
    const size_t c = g->axis * p->scene->bodies + g->a;
    p->stepping->v[c] = 0;
    p->resting += p->held[c] == 0;
    p->held[c] = (signed char)g->side;
}

/* Walls no longer hold what moves away from them. */
static void release(struct impact *p)
{
    for (size_t c = 0; p->resting > 0 && c < p->forces.size; ++c)
        if (p->held[c] * p->stepping->v[c] < 0) {
            p->held[c] = 0;
            --p->resting;
        }
}

/* A body meets a wall, and stays there if it would not rise by more than
   rounding: (11.10, eq:rest). */
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

/* Resolves what touches and approaches, now. Returns whether there was
   anything. */
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

static void settle(struct impact *p, uint64_t *met)
{
    uint64_t now = 0;
    int passes = 0;
    for (size_t i = 0; i < p->gaps; ++i)
        if (p->gap[i].pressed && p->gap[i].root == 0) {
            if (is_wall(&p->gap[i]))
                hold(p, &p->gap[i]);
            else
                crowd(p, &p->gap[i]);
        }
    while (p->end == STEPPING_DONE && settle_once(p, &now))
        if (++passes == MOST_PASSES)
            crowd(p, &p->gap[0]);
    p->simultaneous += now > 1 ? now - 1 : 0;
    *met += now;
    stepping_disturb(p->stepping);
}

/* Goes to the first contact of the part, *h long, which becomes shorter.
   false: there is none, and the part is behind us. */
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

/* Takes what is left of a step, or what lies before its first contact.
   Returns how much that was, s. */
static double take_part(struct impact *p, double left, uint64_t *met)
{
    double h = left;
    stepping_note(p->stepping, p->note);
    p->end = stepping_part(p->stepping, left);
    collect_gaps(p, left);
    if (p->end == STEPPING_DONE && find_contact(p, &h)) {
        struct impact_gap *g;
        double most = h;
        while ((g = earlier_gap(p, &h)) && close_gap(p, g, most, true, &h))
            most = h;
        settle(p, met);
    }
    release(p);
    return h;
}

enum stepping_end impact_step(struct impact *p, uint64_t *met)
{
    double left = p->stepping->dt;
    p->crowded = false;
    p->end = STEPPING_DONE;
    for (int parts = 0; left > 0 && p->end == STEPPING_DONE; ++parts) {
        left -= take_part(p, left, met);
        if (parts == MOST_PARTS && p->gaps > 0)
            crowd(p, &p->gap[0]);
    }
    p->stepping->steps += p->end == STEPPING_DONE;
    return p->end;
}
