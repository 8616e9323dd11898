/* Computes bodies on a line, collision by collision or by sorting them. */
#include "choosing/models_parts.h"

#include "choosing/closed.h"
#include "choosing/particles.h"
#include "line/bonkers.h"

#include <math.h>
#include <stdlib.h>

/* The line on which the bodies of a scene move, and its ends. */
struct row_of_bodies {
    size_t axis;
    double sign;        /* -1: axis reversed, to make gravity point left */
    double gravity;     /* towards the left wall, m/s^2 */
    double left, right; /* surfaces of walls or fixed end bodies, m */
};

/* Returns the row of bodies along the axis of motion or, if nothing moves,
   along the axis on which the bodies lie. A fixed body at an end counts as
   a wall. If a fixed body is between others, which the engine does not
   allow, `left` is NaN. */
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
    /* positions of the outermost free bodies, m */
    double first = INFINITY, last = -INFINITY;
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

/* Returns why the engine cannot compute a scene, or NULL. Walls beside the
   line are allowed if no body overlaps them. */
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

/* A run by the engine of chapter 2. */
struct line {
    struct bonkers bonkers;
    struct row_of_bodies row;
    size_t *body;
    double *x, *v; /* positions, m, and velocities, m/s, of the engine's
                      bodies and two walls */
};

/* Fills *start with the free bodies, sorted from left to right, and stores
   their indices in l->body. Fixed bodies are left out, as they count as
   walls. Returns false if memory runs out. */
static bool start_row(struct line *l, struct start *start,
                      const struct scene *s)
{
    const struct row_of_bodies *row = &l->row;
    struct particles_place *bead = malloc((s->bodies + 1) * sizeof *bead);
    size_t movers = 0;
    l->body = malloc((s->bodies + 1) * sizeof *l->body);
    for (size_t i = 0; bead && i < s->bodies; ++i)
        if (s->freedom[at(s, row->axis, i)])
            bead[movers++] = (struct particles_place){
                row->sign * s->position[at(s, row->axis, i)], i};
    const bool made = bead && l->body && start_create(start, movers);
    if (made) {
        qsort(bead, movers, sizeof *bead, particles_compare);
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

/* Begins a run. Returns NULL, or why it fails. */
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
    models_count_sorting(r, start.movers, 3);
    start_free(&start);
    return !begun                     ? models_no_memory
           : wrong == l->bonkers.gaps ? NULL
                                      : "bodies overlap at the start";
}

/* Work of finding the next collision of more than 32 bodies, as a number of
   examined gaps. With fewer bodies the engine examines all gaps. */
enum { SLAB_WORTH = 30 };

static void count_line(struct models_run *r, const struct bonkers *b)
{
    const bool few = b->gaps <= BONKERS_SCANNED + 1;
    const double met = (double)b->collisions, rows = (double)r->rows + 1;
    r->work[MODELS_LINE_EVENT] = met;
    r->work[MODELS_LINE_SCAN] =
        (met + rows) * (few ? (double)b->gaps : SLAB_WORTH);
    r->work[MODELS_FLIGHT] = 3 * rows * (double)b->gaps;
}

/* Copies positions and velocities to the scene. The order of the bodies on
   the line never changes. */
static void take_from_line(struct models_run *r, const struct line *l)
{
    for (size_t j = 1; j < l->bonkers.gaps; ++j) {
        const size_t c = at(&r->scene, l->row.axis, l->body[j - 1]);
        r->scene.position[c] = l->row.sign * l->x[j];
        r->scene.velocity[c] = l->row.sign * l->v[j];
    }
    r->virial = NAN;
}

/* Runs to the next row in parts, and checks the cost after each part. The
   result is the same to the last bit as that of an undivided run. A run
   cannot continue after an inelastic collapse. */
static enum models_end row_line(struct models_run *r)
{
    struct line *l = r->engine;
    struct bonkers *b = &l->bonkers;
    enum bonkers_stop stop;
    do {
        const uint64_t before = b->collisions;
        stop = bonkers_run(b, r->elapsed, before + AT_A_TIME);
        count_line(r, b);
        if (models_is_costly(r))
            return MODELS_COSTLY;
    } while (stop == BONKERS_COLLISIONS);
    r->collisions = b->collisions;
    if (stop == BONKERS_COLLAPSE)
        return MODELS_STANDSTILL;
    bonkers_state(b, l->x, l->v);
    take_from_line(r, l);
    return MODELS_DONE;
}

const struct models_model models_line = {
    .name = "line",
    .about = "collisions on a line, one by one",
    .family = MODELS_EVENTS,
    .bears = BEARS_CONTACT,
    .engine = sizeof(struct line),
    .row = row_line,
    .begin = begin_line,
    .end = end_line,
    .refuses = refuse_line};

/* Returns NULL if the bodies on a line only exchange velocities, as equal
   bodies do, or why they do not. The conditions for any line are checked
   first. */
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

/* Fills l->x and l->v with the positions and velocities at the start. The
   engine has subtracted the radii from the positions (2.2, eq:rods).
   Returns the number of points. */
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
        return MODELS_BROKEN; /* no free space */
    if (!closed_relabel(l->x[0], x[n], n, x, v, r->elapsed))
        return MODELS_MEMORY;
    for (size_t j = 1; j <= n && l->bonkers.shift; ++j)
        l->x[j] += l->bonkers.shift[j];
    take_from_line(r, l);
    r->work[MODELS_FLIGHT] += (double)n;
    models_count_sorting(r, n, 1);
    return MODELS_DONE;
}

/* Counts the collisions up to the last row. It is called only on request,
   since it costs more than a row: all pairs, including mirror images, are
   examined at the start and at the last row. */
static void count_relabelled(struct models_run *r)
{
    const struct line *l = r->engine;
    const size_t n = put_points(l);
    r->collisions = closed_meetings(l->x[0], l->x[n + 1], n, l->x + 1,
                                    l->v + 1, (double)r->rows * r->every);
    r->work[MODELS_ORDER] += 2 * (double)n * (double)n;
}

const struct models_model models_relabel = {
    .name = "relabel",
    .about = "equal bodies on a line, put in order",
    .family = MODELS_CLOSED,
    .bears = BEARS_CONTACT,
    .engine = sizeof(struct line),
    .row = row_relabel,
    .begin = begin_line,
    .end = end_line,
    .refuses = refuse_relabel,
    .count = count_relabelled};
