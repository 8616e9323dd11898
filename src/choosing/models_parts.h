/* What the files of models share: axes, pairs of bodies, costs, rows. */
#ifndef MODELS_PARTS_H
#define MODELS_PARTS_H

#include "choosing/models.h"
#include "choosing/pair.h"

/* Coordinates lie axis by axis: all x, then all y, then all z. A set of
   axes is a number of three bits. */
/* Returns the index of coordinate k of body i. */
static inline size_t at(const struct scene *s, size_t k, size_t i)
{
    return k * s->bodies + i;
}

/* Returns the first axis of a set; of none, x. */
static inline size_t first_axis(unsigned axes)
{
    return axes & 1 ? 0 : axes & 2 ? 1 : axes & 4 ? 2 : 0;
}

enum { ALL_AXES = 7 };

/* Returns the axes along which body i may move. */
static inline unsigned freedom_of(const struct scene *s, size_t i)
{
    unsigned axes = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        axes |= (unsigned)(s->freedom[at(s, k, i)] != 0) << k;
    return axes;
}

/* Returns body j as body i sees it, if they are at x and move at v. */
static inline struct pair pair_of(const struct scene *s, size_t i, size_t j,
                                  const double x[], const double v[])
{
    struct pair p = {.r2 = 0};
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t a = at(s, k, i), b = at(s, k, j);
        pair_add(&p, x[b] - x[a],
                 (s->freedom[b] ? v[b] : 0) - (s->freedom[a] ? v[a] : 0));
    }
    return p;
}

/* What may act, bit by bit, and so what a model can bear: rods, light
   bodies as test particles, springs, gravity, contacts, friction. What only
   a run in steps can leave out counts among what acts. */
enum {
    BEARS_RODS = 1,
    BEARS_PARTICLES = 2,
    BEARS_SPRINGS = 4,
    BEARS_GRAVITY = 8,
    BEARS_CONTACT = 16,
    BEARS_FRICTION = 32,
    BEARS_ALL = 63
};

/* ---- models.c */

extern const char models_no_memory[];

/* Returns whether the run has already cost more than its limit. */
bool models_is_costly(const struct models_run *r);

/* Event-driven engines are stopped after this number of collisions to check
   the cost so far: a gas can have very many before the next row. */
enum { AT_A_TIME = 4096 };

/* Counts the comparisons in sorting n bodies `times` times. */
void models_count_sorting(struct models_run *r, size_t n, double times);

/* ---- models_acts.c */

/* Does a spring act: is one of its ends free, and has it a stiffness or a
   dashpot? */
bool models_is_active(const struct scene *s, const struct scene_spring *p);

double models_heaviest(const struct scene *s);

/* Returns the body in the middle: one that is held along these axes and has
   mass, or else the heaviest. */
size_t models_central_body(const struct scene *s, unsigned axes);

/* Sets to 0 those numbers of the scene that are left out. Light bodies and
   rods, which are no numbers of it, are left out by the models. */
void models_leave_out(struct scene *s, unsigned cuts);

/* Moves the springs that become rods behind the others, out of the list.
   Returns how many those are. */
size_t models_take_stiff(struct scene *s, const struct scene *origin);

/* Are there points on one line that may meet? Whether two points beside it
   meet is a matter of rounding, so they are left to `line` and `relabel`,
   and others refuse them with these words. */
bool models_points_meet(const struct scene *s, const struct models_acts *a);
extern const char models_unseen[];

/* ---- the rows of the table of models: each stands with its functions */

/* models_closed.c: formulas, and small vibrations */
extern const struct models_model models_free, models_kepler,
    models_oscillator, models_modes;
/* models_line.c, models_disks.c: events */
extern const struct models_model models_relabel, models_line, models_disks;
/* models_steps.c: the row of a method of stepping */
struct models_model models_of_method(const struct stepping_method *m);

#endif
