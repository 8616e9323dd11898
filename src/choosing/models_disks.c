/* Simulates disks and spheres in a box, collision by collision. */
#include "choosing/models_parts.h"

#include "box/cells.h"

#include <math.h>
#include <stdlib.h>

/* The axes of the scene in the order used by the engine. First come the
   axes along which bodies move or their positions differ. The other axes
   count as open, whatever their walls.

   The axis of gravity is second, as in the engine of chapter 5. Without
   gravity, in a box that is otherwise periodic, the second axis is the one
   with walls. */
struct box_axes {
    size_t axes, axis[SCENE_AXES];
    size_t count[3]; /* number of axes with each kind of wall */
    unsigned live;
};

static enum scene_wall wall_of(const struct scene *s,
                               const struct box_axes *w, size_t j)
{
    const size_t k = w->axis[j];
    return w->live >> k & 1 ? s->wall[k] : SCENE_OPEN;
}

static struct box_axes box_axes_of(const struct scene *s,
                                   const struct models_acts *a)
{
    struct box_axes w = {.live = a->axes | a->offset};
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

/* Returns why the engine cannot compute a scene, or NULL. Bodies that are
   fixed along an axis are refused: they would need a different mass along
   each axis, which the engine does not support. */
static const char *refuse_disks(const struct scene *s,
                                const struct models_acts *a)
{
    const struct box_axes w = box_axes_of(s, a);
    const bool floor = wall_of(s, &w, 1) == SCENE_HARD;
    size_t falls = 0;
    for (size_t j = 0; j < w.axes; ++j)
        falls += s->gravity[w.axis[j]] != 0;
    if (!s->contact)
        return "nothing collides";
    if (models_points_meet(s, a))
        return models_unseen;
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

/* A run by one of the two engines of part II: with neighbour lists from
   cells, or without. */
struct box_run {
    struct disks disks;
    struct cells cells;
    bool celled;
    struct box_axes view;
    double sign[SCENE_AXES], origin[SCENE_AXES]; /* from scene to engine
                                                    coordinates */
    double crossed; /* estimated number of crossings of the box */
};

static void end_disks(struct models_run *r)
{
    struct box_run *d = r->engine;
    if (d->celled)
        cells_free(&d->cells);
    disks_free(&d->disks);
}

/* Puts the bodies into the engine's box. A corner of this box is the
   origin, and gravity acts downwards. */
static void put_in_box(struct box_run *d, const struct scene *s)
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

enum { SCANNED = 100 }; /* largest number of disks without cells */

/* Begins a run. Returns NULL, or why it fails. Cells are used if there are
   many disks and the box is suitable. Without cells all disks are examined
   to predict a collision. */
static const char *begin_disks(struct models_run *r)
{
    const struct scene *s = &r->scene;
    struct box_run *d = r->engine;
    const struct box_axes w = box_axes_of(s, &r->acts);
    size_t a, b;
    if (!disks_create(&d->disks, w.axes, s->bodies))
        return models_no_memory;
    d->view = w;
    d->disks.boundary = w.count[SCENE_PERIODIC] == 0 ? DISKS_WALLS
                        : w.count[SCENE_HARD] > 0    ? DISKS_FLOOR
                                                     : DISKS_PERIODIC;
    d->disks.restitution = s->restitution;
    d->disks.gravity = r->acts.weight ? fabs(s->gravity[w.axis[1]]) : 0;
    put_in_box(d, s);
    if (!(disks_replan_distance(&d->disks) > 0))
        return "the box is too narrow to be periodic";
    if (w.count[SCENE_OPEN] == 0 && s->bodies > SCANNED &&
        cells_suit(&d->disks))
        d->celled = cells_create(&d->cells, &d->disks);
    if (d->celled ? !cells_fit(&d->cells, &a, &b)
                  : !disks_fit(&d->disks, &a, &b))
        return "bodies overlap at the start";
    if (disks_lying(&d->disks) < d->disks.count)
        return "a body lies on the floor";
    return d->celled || disks_plan(&d->disks) ? NULL : models_no_memory;
}

/* Counts the work since the start: events and examined disks.

   A collision of two disks requires new predictions for both of them, a
   collision with a wall only one. A prediction examines all disks or, with
   cells, a neighbour list. A disk that has moved too far since its list
   was made gets a new one.

   The work at the start is included. Without cells, every pair is examined
   once for an overlap and twice for a collision. With cells, a list is
   made for each disk and half of its entries are examined. */
static void count_disks(struct models_run *r, const struct box_run *d)
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

/* Returns whether the work so far, plus that of the crossings of the box up
   to the next row, exceeds the cost limit. In the time t a disk that does
   not collide crosses the box |v| t/L times along each axis. At each
   crossing it meets a wall or, in a periodic box, needs a new
   prediction. */
static bool is_endless(const struct models_run *r, struct box_run *d)
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

/* Runs to the next row. If the engine stops before AT_A_TIME collisions,
   memory for longer lists has run out. As in the models with time steps,
   positions in a periodic box are not folded back into it. */
static enum models_end row_disks(struct models_run *r)
{
    struct box_run *d = r->engine;
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
        if (models_is_costly(r))
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

const struct models_model models_disks = {
    .name = "disks",
    .about = "collisions of disks or spheres, one by one",
    .family = MODELS_EVENTS,
    .bears = BEARS_CONTACT,
    .engine = sizeof(struct box_run),
    .row = row_disks,
    .begin = begin_disks,
    .end = end_disks,
    .refuses = refuse_disks};
