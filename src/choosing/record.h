/* Stores the rows of a run, and compares the rows of two runs. */
#ifndef RECORD_H
#define RECORD_H

#include "choosing/models.h"
#include "forces/observables.h"

/* The columns of the stored rows, and how they are compared. The difference
   of two numbers times the weight of their column is a fraction of the
   scale. `motion` is only used to compute observables, and takes no
   steps. */
struct record_view {
    const struct observables *asked; /* NULL: positions and velocities */
    size_t columns;
    double *weight;   /* [columns] 1/scale; 0: stored, not compared */
    double *period;   /* [columns] length of a periodic box, or 0 */
    double *rounding; /* [columns] relative rounding error; 0 for counts */
    double scale;     /* scale of the first compared column */
    double length;    /* scale of positions, m */
    const char *judged; /* compared quantity: "positions", "energy", ... */
    /* ---- private */
    struct scene scene;
    struct motion motion;
    double origin[SCENE_AXES]; /* shift of the scene, m */
    double rounded;            /* rounding error of shifting rows / scale */
};

/* A run with all its rows. */
struct record {
    struct models_plan plan;
    enum models_end end;
    size_t reached; /* number of rows after the start */
    double *value;  /* [(rows + 1) * columns], filled up to row `reached` */
    double work[MODELS_UNITS];
    uint64_t collisions; /* as counted by the model */
    double cost;         /* cost of the work, s */
    double seconds;      /* processor time, s */
    double clock;        /* as in struct models_run */
    double least;        /* as in struct models_run, m */
    unsigned twin;       /* as in record_setup */
    const char *why;     /* NULL, or why the run could not begin */
};

enum { RECORD_TWINS = 7 }; /* twins are numbered from 1 to this */

/* The parameters of a run. */
struct record_setup {
    const struct scene *scene;
    struct models_plan plan;
    double every; /* s */
    size_t rows;
    double limit;  /* cost limit, s */
    double grow;   /* added to all radii, m */
    unsigned twin; /* 0: the run itself; 1 to RECORD_TWINS: a twin, which
                      differs in its units, the order of bodies, the
                      orientation, and the last bits */
};

/* Prepares to store a run of the duration `length` (s). `asked` must
   outlive v. If memory runs out, prints an error that begins with
   `program`, and returns false, with nothing to free. */
bool record_view_create(struct record_view *v, const char *program,
                        const struct scene *s,
                        const struct observables *asked, double length);
void record_view_free(struct record_view *v);

/* Runs a plan, and stores in *r its rows and how it ended. Free *r with
   record_free. */
void record_run(struct record *r, struct record_view *v,
                const struct record_setup *o);
void record_free(struct record *r);

/* Runs two plans side by side, until a row of one differs from that of the
   other by more than `apart` (a fraction of the scale), or a run ends. The
   cost limit of oa applies to both runs together. */
void record_both(struct record *a, struct record *b, struct record_view *v,
                 const struct record_setup *oa,
                 const struct record_setup *ob, double apart);

/* Returns the largest difference between two records in the rows from
   `first` to `last`, as a fraction of the scale, or INFINITY if a record
   has fewer rows. */
double record_difference(const struct record_view *v,
                         const struct record *a, const struct record *b,
                         size_t first, size_t last);

/* Returns the size of the scene (in m) without the body that enlarges it
   most. Sets *far to the index of that body. */
double record_scale_without(const struct scene *s, size_t *far);

/* Returns the number of rows after the start in which two runs agree
   within e (a fraction of the scale). Counting stops at the first row in
   which they do not agree. */
size_t record_agree(const struct record_view *v, const struct record *a,
                    const struct record *b, double e);

#endif
