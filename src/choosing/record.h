/* The rows of a run, and how far those of two runs are apart. */
#ifndef RECORD_H
#define RECORD_H

#include "choosing/models.h"
#include "forces/observables.h"

/* The columns of the rows that are kept, and what errors in each are
   divided by: with the weights all have the same unit, a fraction. It owns
   a copy of the scene, set in motion only because observables ask a motion:
   it never takes a step. */
struct record_view {
    const struct observables *asked; /* NULL: all states, as step's rows */
    size_t columns;
    double *weight;     /* [columns] 1/scale; 0: is shown, but not judged */
    double *period;     /* [columns] places repeat after it; 0: never */
    double *rounding;   /* [columns] fraction it is rounded by; 0: counts */
    double scale;       /* of the first column that is judged */
    double length;      /* of places, m */
    const char *judged; /* and what that is: "positions", "energy", ... */
    /* ---- private */
    struct scene scene;
    struct motion motion;
    double origin[SCENE_AXES]; /* to which the scene is moved, m */
    double rounded; /* by how much rows are that are moved back */
};

/* A run of which every row is kept. */
struct record {
    struct models_plan plan;
    enum models_end end;
    size_t reached; /* rows, but for that of the start */
    double *value;  /* [(rows + 1) * columns], so far as reached */
    double work[MODELS_UNITS];
    uint64_t collisions; /* as the model counts them */
    double cost;         /* of the work, s by the price list */
    double seconds;      /* of processor time */
    double clock;        /* as in struct models_run */
    double least;        /* m, the same */
    unsigned twin;       /* as in the order */
    const char *why;     /* NULL, or why it could not begin */
};

enum { RECORD_TWINS = 7 }; /* of one run, each in units of its own */

/* How a run is to be done. */
struct record_setup {
    const struct scene *scene;
    struct models_plan plan;
    double every; /* s */
    size_t rows;
    double limit;  /* cost, s by the price list */
    double grow;   /* m, by which balls are larger */
    unsigned twin; /* 0: the run itself; 1 to RECORD_TWINS: a twin, which
                      is the same physically: rescaled, mirrored, renumbered
                      and with other last bits, so that it shows rounding */
};

/* Prepares to look at a run that lasts `length`, s. asked has to outlive v.
   Without memory it prints so, after the program's name, and returns false,
   with nothing to free. */
bool record_view_create(struct record_view *v, const char *program,
                        const struct scene *s,
                        const struct observables *asked, double length);
void record_view_free(struct record_view *v);

/* Runs a plan and keeps its rows. What became of the run stands in *r, to
   be freed with record_free. */
void record_run(struct record *r, struct record_view *v,
                const struct record_setup *o);
void record_free(struct record *r);

/* Two runs row by row, until they are more than `apart` of the scale apart,
   or one has ended; both together within the limit of the first. */
void record_both(struct record *a, struct record *b, struct record_view *v,
                 const struct record_setup *oa,
                 const struct record_setup *ob, double apart);

/* The largest difference of two records in all rows from the first to the
   last, as a fraction of its scale; INFINITY if one has not come so far. */
double record_difference(const struct record_view *v,
                         const struct record *a, const struct record *b,
                         size_t first, size_t last);

/* The size of the scene, m, without the body that most adds to it, *far. */
double record_scale_without(const struct scene *s, size_t *far);

/* How many rows the two agree to within e. */
size_t record_agree(const struct record_view *v, const struct record *a,
                    const struct record *b, double e);

#endif
