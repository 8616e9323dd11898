/* Declares the models, which compute scenes row by row, and their costs. */
#ifndef MODELS_H
#define MODELS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The units of work that are counted while a model computes a run. */
enum models_unit {
    MODELS_EVALUATION, /* call of the force function */
    MODELS_BODY,       /* update of a body; several per stage */
    MODELS_PAIR,       /* gravity of a pair (8 pairs above 32 bodies) */
    MODELS_SPRING,     /* force of a spring; counts as 10 outside a band */
    MODELS_ROD,        /* correction of a rod */
    MODELS_CONTACT,    /* body checked for contacts in a part of a step */
    MODELS_OVERLAP,    /* pair examined for contacts */
    MODELS_CURVE,      /* product in the polynomial of a gap */
    MODELS_ROOT,       /* the same, if that polynomial has a root */
    MODELS_LINE_EVENT, /* collision on a line */
    MODELS_LINE_SCAN,  /* gap examined on a line */
    MODELS_DISK_EVENT, /* collision of disks, or with a wall */
    MODELS_DISK_SCAN,  /* disk examined to predict a collision */
    MODELS_RENEWAL,    /* construction of a neighbour list */
    MODELS_ELLIPSE,    /* body moved along its ellipse */
    MODELS_FLIGHT,     /* coordinate moved freely; counts as 10 if damped */
    MODELS_ORDER,      /* comparison in sorting bodies */
    MODELS_MODE,       /* operation in finding or summing modes */
    MODELS_ROW,        /* output of a row */
    MODELS_UNITS
};

struct models_price {
    const char *name, *what;
    double ns;
};
extern const struct models_price models_prices[MODELS_UNITS];

/* Simplifications of a scene, which can be combined as bits of a set. */
enum models_cut {
    MODELS_NO_LIGHT = 1, /* bodies lighter than a hundredth of the heaviest
                            attract no others */
    MODELS_RODS = 2, /* springs more than a hundred times as stiff as the
                        softest become rods */
    /* The following bits set quantities of the scene to 0. */
    MODELS_NO_SOFTENING = 4,
    MODELS_NO_FRICTION = 8, /* `damp` in a scene file */
    MODELS_NO_DASHPOTS = 16,
    MODELS_NO_WEAK = 32, /* springs with less than a hundredth of the
                            largest stiffness */
    MODELS_NO_WEIGHT = 64,
    MODELS_NO_PULL = 128,
    MODELS_NO_ACROSS = 256, /* extent and motion across the longest axis */
    MODELS_CUTS = 9         /* number of bits */
};

/* Names of the simplifications, from bit 0 on, then NULL. */
extern const char *const models_cut_names[MODELS_CUTS + 1];

/* The interactions in a scene, and the axes along which bodies may move. */
struct models_acts {
    bool contact; /* two bodies, or a body and a wall, may meet */
    bool gravity, springs, weight, friction, dashpots;
    unsigned axes;     /* bit k: something may move along axis k */
    unsigned offset;   /* bit k: positions differ along axis k */
    size_t dimensions; /* number of axes in `axes` */
    size_t free;       /* number of bodies that may move */
    unsigned cuts;     /* applied simplifications */
};

/* A plan: a model, its simplifications of the scene, and its steps. As
   text: "kepler", "pefrl:24", "kepler,no-light". */
struct models_plan {
    const struct models_model *model;
    unsigned cuts;
    uint64_t steps;   /* time steps per row; 0 for models without steps */
    double tolerance; /* step tolerance of an adaptive method */
    /* A close encounter limits the time step only if it could change the
       position of a body by more than `negligible` (m) within `time_left`
       (s). */
    double negligible, time_left;
    double slack; /* steps are shorter than their upper limits by this
                     fraction */
    /* Contacts and near misses are recorded if the overlap or the gap is
       less than this (in m). */
    double contact_margin;
    double start_limit; /* cost limit of `begin`, s; 0: none */
};

enum { MODELS_TEXT = 256, MODELS_MESSAGE = 2048 };
enum models_family { MODELS_CLOSED, MODELS_EVENTS, MODELS_STEPS };

/* How a row ended. */
enum models_end {
    MODELS_DONE,
    MODELS_BROKEN,     /* numbers not finite, or no progress */
    MODELS_STANDSTILL, /* inelastic collapse */
    MODELS_COSTLY,     /* cost limit exceeded */
    MODELS_MEMORY
};

struct models_run;

/* A row of the table of models: the functions that begin, continue and end
   a run. */
struct models_model {
    const char *name, *about;
    enum models_family family;
    unsigned bears; /* private: flags defined in models_parts.h */
    size_t engine;  /* private: bytes of its state, zeroed at the start */
    enum models_end (*row)(struct models_run *r);
    /* Begins a run. Returns NULL, or why it fails. */
    const char *(*begin)(struct models_run *r);
    void (*end)(struct models_run *r);
    /* Returns why the model cannot compute this scene, or NULL. Called only
       if the model supports all interactions. A NULL pointer means that
       nothing else needs a check. */
    const char *(*refuses)(const struct scene *s,
                           const struct models_acts *a);
    bool approximate; /* not exact, even for scenes that it accepts */
    const struct stepping_method *method; /* NULL if there are no steps */
    /* Updates r->collisions. NULL if `row` does this. */
    void (*count)(struct models_run *r);
};

/* The state of a run. Callers may read all members except engine, and may
   write only `all` and `limit`. */
struct models_run {
    struct models_plan plan;
    struct scene scene;  /* at the last row; its springs exclude rods */
    struct scene origin; /* at the start */
    struct models_acts acts;
    double start, every; /* s */
    double elapsed;      /* time from the start to the next row, s */
    double clock;  /* bound on the relative error of time that all twins
                      share, or 0 */
    uint64_t rows; /* rows so far */
    uint64_t collisions; /* see models_collisions */
    double least;  /* gap of the narrowest miss or, if negative, of the
                      shallowest contact, m */
    double virial; /* as in struct disks, J s; NaN: unknown */
    double work[MODELS_UNITS];
    uint64_t all; /* rows of the whole run; 0: unknown */
    double limit; /* cost limit, s */
    void *engine;
};

/* Returns the cost of this work by the price list. All costs are in seconds
   of processor time, computed from this list and not measured. */
double models_cost(const double work[MODELS_UNITS]);

/* Returns the simplifications that are tried by default: MODELS_NO_LIGHT
   and MODELS_RODS, if they change the scene. */
unsigned models_cuts(const struct scene *s);

/* Finds the interactions in a scene. */
void models_analyse(struct models_acts *a, const struct scene *s);

/* Returns an estimate (in 1/s) of the largest angular frequency of the
   scene in its present state plus the largest damping rate. The
   simplifications `cuts` are applied first. Returns INFINITY if memory
   runs out. */
double models_rate(const struct scene *s, unsigned cuts);

/* Returns the square of the present distance of two bodies, m^2. */
double models_square(const struct scene *s, size_t i, size_t j);

/* Returns the table of all models, including one for each stepping method.
   The last row has the name NULL. The first call is not thread-safe. */
const struct models_model *models_all(void);
const struct models_model *models_find(const char *name); /* or NULL */

/* models_write writes a plan as text, and models_read parses it. If the
   text is wrong, models_read writes an error to message and returns
   false. */
void models_write(const struct models_plan *p, char text[MODELS_TEXT]);
bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE]);

/* Returns why the plan cannot compute the scene, or NULL. */
const char *models_refuse(const struct models_plan *p,
                          const struct scene *s);

/* Copies the scene and prepares to compute rows at intervals of `every`
   (s). On failure sets *why to a static text and returns false, with
   nothing to free; r->work keeps the work done so far. */
bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why);

/* Advances the run to its next row. The time is then start + rows *
   every. */
enum models_end models_row(struct models_run *r);
void models_end(struct models_run *r);

/* Returns the number of collisions up to the last row. */
uint64_t models_collisions(struct models_run *r);

#endif
