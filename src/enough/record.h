/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 2644823301 of the lines below */
/* The rows of a run, and how far those of two runs are apart. */
#ifndef RECORD_H
#define RECORD_H

#include "enough/models.h"
#include "forces/observables.h"

/* What is looked at, row by row, and what its errors are divided by. */
struct record_view {
    const struct observables *asked; /* NULL: all states, as step's rows */
    size_t columns;
    double *weight; /* [columns] 1/scale; 0: is shown, but not judged */
    double *turn;  /* [columns] after which a place is the same; 0: never */
    double scale;  /* of the first column that is judged */
    double length; /* of places, m */
    double speed;  /* the largest at the start, m/s */
    const char *judged; /* and what that is: "positions", "energy", ... */
    /* ---- private */
    struct scene scene;
    struct motion motion;
};

/* What happened in a run. */
struct record {
    struct models_plan plan;
    enum models_end end;
    size_t reached; /* rows, but for that of the start */
    double *value;  /* [(rows + 1) * columns], so far as reached */
    double work[MODELS_UNITS];
    double cost;     /* of them, s by the price list */
    double speed;    /* the largest at any row, m/s; watched: at any step */
    double watching; /* watched: of the looking itself, s by the price list;
                        not in cost */
    double seconds;  /* of this processor */
    double turning;  /* watched: how fast a spring with a length turned
                        round at most, 1/s */
    double clock;    /* as in struct models_run */
    uint64_t missed; /* watched: contacts that no step has seen */
    double swinging; /* watched: the rate of the fastest spring that can
                        swing, or of what is damped and moves, 1/s */
    const char *why; /* NULL, or why it could not begin */
};

/* How a run is to be done. */
struct record_order {
    const struct scene *scene;
    struct models_plan plan;
    double every; /* s */
    size_t rows;
    double limit;   /* cost, s by the price list */
    bool converted; /* computed in other units, which no bit should know */
    bool watched;   /* a row is cut into its steps, to see all speeds */
    bool halfway;   /* rows end in the middle of a step: of a model with
                       steps, if not watched */
    double little;  /* m: what moves nobody by more does not matter, be it
                       a missed contact or a spring that is stretched */
    /* NULL, or what it is compared with, to be given up beyond `apart` */
    const struct record *guide;
    double apart;
};

/* Prepares to look at a run of the scene that lasts `length`, s. On failure
   says why on standard error, after program, and returns false with
   nothing to free. asked has to outlive *v. */
bool record_look(struct record_view *v, const char *program,
                 const struct scene *s, const struct observables *asked,
                 double length);
void record_look_away(struct record_view *v);

/* Runs a plan and keeps its rows. Returns false when there is no memory;
   what became of the run stands in *r, to be freed with record_free. */
bool record_run(struct record *r, struct record_view *v,
                const struct record_order *o);
void record_free(struct record *r);

/* The largest difference of two records in all rows from the first to the
   last one, as a share of its scale; INFINITY if one has not come so far.
 */
double record_apart(const struct record_view *v, const struct record *a,
                    const struct record *b, size_t first, size_t last);

/* How many rows the two agree to within e. */
size_t record_agree(const struct record_view *v, const struct record *a,
                    const struct record *b, double e);

#endif
