/* The models, which compute a scene row by row, and their costs. */
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
    MODELS_BODY,       /* pass over a body; several in each stage */
    MODELS_PAIR,       /* gravity of a pair; of 8 if above 32 bodies */
    MODELS_SPRING,     /* force of a spring; counts 10 outside bands */
    MODELS_ROD,        /* correction of a rod */
    MODELS_CONTACT,    /* body in a part of a step with contacts */
    MODELS_OVERLAP,    /* pair examined for contacts */
    MODELS_CURVE,      /* product for the polynomial of a gap */
    MODELS_ROOT,       /* polynomial of a gap that has a root */
    MODELS_LINE_EVENT, /* collision on a line */
    MODELS_LINE_SCAN,  /* gap examined on a line */
    MODELS_DISK_EVENT, /* collision of disks, or with a wall */
    MODELS_DISK_SCAN,  /* disk examined to predict a collision */
    MODELS_RENEWAL,    /* construction of a neighbour list */
    MODELS_ELLIPSE,    /* body moved along its ellipse */
    MODELS_FLIGHT,     /* free coordinate; counts 10 if damped or a mode */
    MODELS_ORDER,      /* comparison in sorting bodies */
    MODELS_MODE,       /* operation in finding and summing modes */
    MODELS_ROW,        /* output of a row */
    MODELS_UNITS
};

/* The price of a unit of work: a constant. */
struct models_price {
    const char *name, *what;
    double ns;
};
extern const struct models_price models_prices[MODELS_UNITS];

/* The simplifications of a scene: bits of a set. */
enum models_cut {
    MODELS_NO_LIGHT = 1, /* bodies lighter than a hundredth of the heaviest
                            attract no others */
    MODELS_RODS = 2,     /* springs a hundred times stiffer than the softest
                            become rods */
    /* Quantities of the scene that become 0: */
    MODELS_NO_SOFTENING = 4,
    MODELS_NO_FRICTION = 8, /* `damp` in a scene file */
    MODELS_NO_DASHPOTS = 16,
    MODELS_NO_WEAK = 32, /* less than a hundredth as stiff as the
                            stiffest */
    MODELS_NO_WEIGHT = 64,
    MODELS_NO_PULL = 128,
    MODELS_NO_ACROSS = 256, /* motion across the longest axis */
    MODELS_CUTS = 9         /* number of bits */
};

/* Names of the simplifications, from bit 0 on, then NULL. */
extern const char *const models_cut_names[MODELS_CUTS + 1];

/* The interactions in a scene, and the axes that matter. */
struct models_acts {
    bool contact; /* two bodies, or a body and a wall, may meet */
    bool gravity, springs, weight, friction, dashpots;
    unsigned axes;     /* bit k: something may move along axis k */
    unsigned offset;   /* bit k: positions differ along axis k */
    size_t dimensions; /* number of axes that matter */
    size_t free;       /* number of bodies that may move */
    unsigned cuts;     /* simplifications made */
};

/* A plan: a model, its simplifications of the scene, and its steps. As
   text: "kepler", "pefrl:24", "kepler,no-light". */
struct models_plan {
    const struct models_model *model;
    unsigned cuts;
    uint64_t steps;   /* steps in each row; 0 for models without steps */
    double tolerance; /* of an adaptive method */
    /* A passage of two bodies matters if it moves one of them by more than
       `negligible`, m, in the remaining time, s. */
    double negligible, time_left;
    double slack; /* fraction by which steps stay below their limits */
    /* Contacts made or missed by less than this are recorded, m. */
    double contact_margin;
    double start_limit; /* largest cost of a start, s; 0: no limit */
};

enum { MODELS_TEXT = 256, MODELS_MESSAGE = 2048 };
enum models_family { MODELS_CLOSED, MODELS_EVENTS, MODELS_STEPS };

/* How a row ended. */
enum models_end {
    MODELS_DONE,
    MODELS_BROKEN,     /* not finite, or stuck */
    MODELS_STANDSTILL, /* inelastic collapse */
    MODELS_COSTLY,     /* cost limit exceeded */
    MODELS_MEMORY
};

struct models_run;

/* A model: a row of the table, with the functions that begin, continue and
   end a run. All models are used alike. */
struct models_model {
    const char *name, *about;
    enum models_family family;
    unsigned bears; /* private: bits of models_parts.h */
    size_t engine;  /* private: bytes of its state, zeroed at the start */
    enum models_end (*row)(struct models_run *r);
    const char *(*begin)(struct models_run *r); /* NULL, or why not */
    void (*end)(struct models_run *r); /* after begin, even a failed one */
    /* Returns a further reason why the model cannot compute this scene
       (exactly up to rounding, or in steps), or NULL. The pointer is NULL
       if the model has no further reasons. */
    const char *(*refuses)(const struct scene *s,
                           const struct models_acts *a);
    bool approximate; /* not exact even for scenes it accepts */
    const struct stepping_method *method; /* of MODELS_STEPS, or NULL */
    void (*count)(struct models_run *r);  /* updates collisions; NULL: not
                                             needed */
};

/* The state of a run. All members but engine may be read. */
struct models_run {
    struct models_plan plan;
    struct scene scene;  /* copy, at the last row, without rods */
    struct scene origin; /* a copy, at the start */
    struct models_acts acts;
    double start, every; /* s */
    double elapsed;      /* time from the start to the next row, s */
    double clock;        /* bound of the relative error of time that a
                            closed form shares with its twins, or 0 */
    uint64_t rows;       /* number of rows so far */
    uint64_t collisions; /* for relabel use models_collisions */
    double least;        /* smallest gap of a near miss or, if negative,
                            shallowest contact, m */
    double virial;       /* as in struct disks, J s; NaN: unknown */
    double work[MODELS_UNITS];
    uint64_t all; /* rows of the whole run; 0: unknown. May be written */
    double limit; /* cost limit, s. May be written */
    void *engine;
};

/* Returns the cost of this work by the price list, s. */
double models_cost(const double work[MODELS_UNITS]);

/* Returns the simplifications that would change the scene and are tried
   without a request. */
unsigned models_cuts(const struct scene *s);

/* Finds the interactions in a scene. */
void models_analyse(struct models_acts *a, const struct scene *s);

/* Returns an estimate of the present largest angular frequency plus the
   largest rate of friction, 1/s, with these cuts; INFINITY if memory runs
   out. */
double models_rate(const struct scene *s, unsigned cuts);

/* Returns the square of the present distance of two bodies, m^2. */
double models_square(const struct scene *s, size_t i, size_t j);

/* Returns all models, with one for each method of stepping; the last row
   has the name NULL. The first call must be made by a single thread. */
const struct models_model *models_all(void);
const struct models_model *models_find(const char *name); /* or NULL */

/* Write a plan as text, and read it; models_read returns false, with an
   error in message, if it is wrong. */
void models_write(const struct models_plan *p, char text[MODELS_TEXT]);
bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE]);

/* Returns why the plan does not suit a scene, or NULL. */
const char *models_refuse(const struct models_plan *p,
                          const struct scene *s);

/* Copies the scene and prepares for rows every `every` s. On failure
   returns false, *why is the reason (a static text), and there is nothing
   to free; the work done until then remains in r->work. */
bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why);

/* Moves the run to its next row: the time start + rows * every. */
enum models_end models_row(struct models_run *r);
void models_end(struct models_run *r);

/* Returns the collisions up to the last row; UINT64_MAX if memory runs
   out. */
uint64_t models_collisions(struct models_run *r);

#endif
