/* Declares what the files of models share: axes, pairs, costs and rows. */
#ifndef MODELS_PARTS_H
#define MODELS_PARTS_H

#include "choosing/models.h"
#include "choosing/pair.h"

/* Coordinates are stored axis by axis: all x, then all y, then all z. A set
   of axes is a number with a bit for each axis. */
/* Returns the index of coordinate k of body i. */
static inline size_t at(const struct scene *s, size_t k, size_t i)
{
    return k * s->bodies + i;
}

/* Returns the first axis of a set, or 0 if it is empty. */
static inline size_t first_axis(unsigned axes)
{
    return axes & 1 ? 0 : axes & 2 ? 1 : axes & 4 ? 2 : 0;
}

enum { ALL_AXES = 7 };

/* Returns the set of axes along which body i may move. */
static inline unsigned freedom_of(const struct scene *s, size_t i)
{
    unsigned axes = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        axes |= (unsigned)(s->freedom[at(s, k, i)] != 0) << k;
    return axes;
}

/* Returns the motion of body j relative to body i, for positions x and
   velocities v. */
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

/* Interactions and simplifications that a model supports, as bits of a
   set. */
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

/* Returns whether the run has cost more than its limit. */
bool models_is_costly(const struct models_run *r);

/* Number of collisions after which event-driven engines stop to check the
   cost, since a gas may have very many collisions before the next row. */
enum { AT_A_TIME = 4096 };

/* Adds to r->work the work of `times` sorts of n bodies. */
void models_count_sorting(struct models_run *r, size_t n, double times);

/* ---- models_acts.c */

/* Returns whether a spring acts: it has a stiffness or a dashpot, and a
   free end. */
bool models_is_active(const struct scene *s, const struct scene_spring *p);

double models_heaviest(const struct scene *s);

/* Returns the central body: the first that has mass and is fixed along all
   of these axes or, if there is none, the heaviest. */
size_t models_central_body(const struct scene *s, unsigned axes);

/* Applies the simplifications in `cuts` that set quantities of the scene to
   0. The others, for light bodies and rods, are applied by the models. */
void models_leave_out(struct scene *s, unsigned cuts);

/* Reorders the springs of s: first those that remain springs, then those
   that become rods. Sets s->springs to the number of the former, and
   returns the number of rods. */
size_t models_take_stiff(struct scene *s, const struct scene *origin);

/* Returns whether bodies of radius 0 may meet on a line. Rounding errors
   keep models with time steps from detecting such contacts. So only `line`
   and `relabel` accept these scenes, and other models refuse them with the
   text models_unseen. */
bool models_points_meet(const struct scene *s, const struct models_acts *a);
extern const char models_unseen[];

/* ---- models without time steps, defined next to their functions */

/* models_closed.c: formulas, and small vibrations */
extern const struct models_model models_free, models_kepler,
    models_oscillator, models_modes;
/* models_line.c, models_disks.c: collisions */
extern const struct models_model models_relabel, models_line, models_disks;
/* models_steps.c: returns the model of a stepping method */
struct models_model models_of_method(const struct stepping_method *m);

#endif
