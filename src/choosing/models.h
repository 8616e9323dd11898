/* The models, which compute a scene row by row, and what each costs. */
#ifndef MODELS_H
#define MODELS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The units of work that are counted while a model computes a run. */
enum models_unit {
    MODELS_EVALUATION, /* of all forces: the calls */
    MODELS_BODY,       /* a pass over a body; in stages more than one */
    MODELS_PAIR,       /* a pull of two bodies on each other; beyond 32
                          bodies, eight of one on one */
    MODELS_SPRING,     /* a spring's force; ten times if it is in no band */
    MODELS_ROD,        /* one correction of one rod */
    MODELS_CONTACT,    /* a body in a part of a step, with contacts */
    MODELS_OVERLAP,    /* and, for each pair that is looked at */
    MODELS_CURVE,      /* and, for each product of two coefficients in
                          computing the polynomial of a gap */
    MODELS_ROOT,       /* and, for each of these, if it has a root */
    MODELS_LINE_EVENT, /* a collision on a line */
    MODELS_LINE_SCAN,  /* and, for each gap that is looked at */
    MODELS_DISK_EVENT, /* a collision of disks, or with a wall */
    MODELS_DISK_SCAN,  /* and, for each disk that is looked at */
    MODELS_RENEWAL,    /* a disk's list of neighbours, made or made anew */
    MODELS_ELLIPSE,    /* a body moved along its ellipse */
    MODELS_FLIGHT,     /* a coordinate moved freely; ten of them: one with
                          friction, or on a spring */
    MODELS_ORDER,      /* a comparison in putting bodies in order */
    MODELS_MODE,       /* an operation in finding modes, and in summing */
    MODELS_ROW,        /* a row, whatever the model */
    MODELS_UNITS
};

/* What a unit costs: committed constants. */
struct models_price {
    const char *name, *what;
    double ns;
};
extern const struct models_price models_prices[MODELS_UNITS];

/* What can be left out of a scene: a set of these bits. */
enum models_cut {
    MODELS_NO_LIGHT = 1, /* bodies lighter than a hundredth of the heaviest
                            do not pull */
    MODELS_RODS = 2,     /* springs of more than a hundred times the softest
                            one's D become rods; all if alike */
    /* Numbers of the scene that become 0: */
    MODELS_NO_SOFTENING = 4,
    MODELS_NO_FRICTION = 8, /* the line damp */
    MODELS_NO_DASHPOTS = 16,
    MODELS_NO_WEAK = 32, /* springs below a hundredth of the stiffest */
    MODELS_NO_WEIGHT = 64,
    MODELS_NO_PULL = 128,
    MODELS_NO_ACROSS = 256, /* all that is beside the longest axis */
    MODELS_CUTS = 9         /* how many bits */
};

/* Their names, from bit 0 on, then NULL. */
extern const char *const models_cut_names[MODELS_CUTS + 1];

/* What acts in a scene, and where. */
struct models_acts {
    bool contact; /* two bodies, or a body and a wall, may meet */
    bool gravity, springs, weight, friction, dashpots;
    unsigned axes;     /* bit k: something may move along axis k */
    unsigned offset;   /* bit k: bodies are at different places along k */
    size_t dimensions; /* how many axes: exactly, not nearly */
    size_t free;       /* bodies that may move */
    unsigned cuts;     /* what has been left out */
};

/* A plan: a model, what it leaves out of the scene, and its steps. As text:
   "kepler", "pefrl:24", "kepler,no-light". */
struct models_plan {
    const struct models_model *model;
    unsigned cuts;
    uint64_t steps;   /* in each row; 0 for models without steps */
    double tolerance; /* of an adaptive method */
    /* Passages of two bodies count if they move somebody by more than
       `negligible`, m, in the time that is left, s. */
    double negligible, time_left;
    double slack; /* fraction by which steps keep from their bounds */
    /* Contacts made or missed by less than this are noticed, m. */
    double contact_margin;
    double start_limit; /* s by the price list, of a start; 0: none */
};

enum { MODELS_TEXT = 256, MODELS_MESSAGE = 2048 };
enum models_family { MODELS_CLOSED, MODELS_EVENTS, MODELS_STEPS };

/* How a row ended. */
enum models_end {
    MODELS_DONE,
    MODELS_BROKEN,     /* no longer finite, or stuck */
    MODELS_STANDSTILL, /* inelastic collapse */
    MODELS_COSTLY,     /* over the limit */
    MODELS_MEMORY
};

struct models_run;

/* A model: a row of the table, with the functions that begin, carry and end
   a run. Who uses it need not know which it is. */
struct models_model {
    const char *name, *about;
    enum models_family family;
    unsigned bears; /* private: what may act, as in models_parts.h */
    size_t engine;  /* private: bytes, all 0 when a run begins */
    enum models_end (*row)(struct models_run *r);
    const char *(*begin)(struct models_run *r); /* NULL, or why not */
    void (*end)(struct models_run *r); /* whatever begin has done */
    /* Beyond that: why it cannot compute this scene, exactly but for
       rounding or in steps; NULL: it can. No function: it always can. */
    const char *(*refuses)(const struct scene *s,
                           const struct models_acts *a);
    bool approximate; /* not exact even where it does not refuse */
    const struct stepping_method *method; /* of MODELS_STEPS, or NULL */
    void (*count)(struct models_run *r);  /* brings collisions up to date;
                                             NULL: they are */
};

/* A scene under way. To be read: all but engine. */
struct models_run {
    struct models_plan plan;
    struct scene scene;  /* a copy, in the state of the last row; without
                            the springs that are replaced by rods */
    struct scene origin; /* that at the start */
    struct models_acts acts;
    double start, every; /* s */
    double elapsed;      /* from the start to the row asked for, s */
    double clock;        /* bound of the relative error of times in closed
                            forms that all twins share; 0: there is none */
    uint64_t rows;       /* so far */
    uint64_t collisions; /* not those of relabel: models_collisions */
    double least;  /* m: the closest miss of a contact, or, below 0, the
                      shallowest that was made */
    double virial; /* as in struct disks, J s; NaN if not known */
    double work[MODELS_UNITS];
    uint64_t all; /* rows in the end; 0: not known. May be written */
    double limit; /* s: what costs more is MODELS_COSTLY. May be written */
    void *engine;
};

/* Returns the seconds that so much work costs by the price list. */
double models_cost(const double work[MODELS_UNITS]);

/* Returns the cuts that would change the scene and are tried unasked. */
unsigned models_cuts(const struct scene *s);

/* Looks at what acts in a scene. */
void models_analyse(struct models_acts *a, const struct scene *s);

/* Returns the largest angular frequency now, about, plus the largest rate
   of friction, 1/s, with these cuts. INFINITY if memory runs out. */
double models_rate(const struct scene *s, unsigned cuts);

/* Returns the square of the distance of two bodies now, m^2. */
double models_square(const struct scene *s, size_t i, size_t j);

/* All models, a method of stepping each one; a name NULL ends them. To be
   called for the first time by one thread alone. */
const struct models_model *models_all(void);
const struct models_model *models_find(const char *name); /* or NULL */

/* A plan as text, and back; false: no plan, and message says why. */
void models_write(const struct models_plan *p, char text[MODELS_TEXT]);
bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE]);

/* Returns why the plan does not suit a scene, or NULL. */
const char *models_refuse(const struct models_plan *p,
                          const struct scene *s);

/* Copies the scene and prepares rows that are `every` apart, s. On failure
 *why says why (a static text), and there is nothing to free; the work that
   was done until then stays in r->work. */
bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why);

/* Carries it to the next row: the time start + rows * every. */
enum models_end models_row(struct models_run *r);
void models_end(struct models_run *r);

/* Returns the collisions up to the last row; UINT64_MAX if memory runs
   out. */
uint64_t models_collisions(struct models_run *r);

#endif
