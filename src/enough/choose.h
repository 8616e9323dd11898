/* From chapters/12-pick.nw: edit there, then run make tangle. */
/* checksum 3560849763 of the lines below */
/* The cheapest way to carry a scene within a tolerance, or a reason. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "enough/models.h"
#include "forces/observables.h"
#include "enough/record.h"

enum { CHOOSE_TEXT = 160, CHOOSE_REFUSAL = 500, CHOOSE_VERDICTS = 8 };

/* What the check of a plan has found. */
struct choose_verdict {
    struct models_plan plan; /* with the steps that it came to */
    double error, cost;      /* INFINITY: it was refused */
    double order;            /* by which it was checked; 0: none */
};

/* What is asked for. */
struct choose_request {
    const struct scene *scene;
    const char *program;             /* before what goes wrong */
    double until, every;             /* s: the last row, from row to row */
    double tolerance;                /* share of the scale */
    const struct observables *asked; /* NULL: all positions */
    double reason; /* the dearest run that is reasonable, s by the price
                      list */
    const struct models_plan *only; /* NULL, or the model to be taken, and
                                       what it is to leave out */
    bool all; /* candidates that have lost are measured, too: for charts */
    int closer; /* private: how often a first row has been divided */
    struct choose_verdict verdict[CHOOSE_VERDICTS]; /* of choices before */
    size_t verdicts;
    double spent; /* by them, s by the price list */
};

/* How sure an error is. */
enum choose_sure { CHOOSE_EXACT, CHOOSE_ESTIMATE, CHOOSE_OUT };

/* A way to carry the scene that was looked at. */
struct choose_candidate {
    struct models_plan plan;
    enum choose_sure sure;
    double error, cost; /* share of the scale; s by the price list: both of
                           this plan */
    double effect;      /* of the error, by what is left out */
    double order;       /* measured; 0: none */
    char text[CHOOSE_TEXT]; /* what was seen, or why it is out */
};

/* Something that could be left out, and what that does to the run. */
struct choose_cut {
    unsigned cut;
    double bound;  /* share of the scale, estimated; INFINITY: there is none
                      that says anything */
    double effect; /* measured, or the bound where that is enough;
                      INFINITY: beyond the tolerance */
    bool measured;
};

/* A run whose error was seen. */
struct choose_point {
    size_t candidate;
    uint64_t steps;
    double error, cost; /* share of the scale; s by the price list */
};

/* What a method has shown on a stretch of the run. */
struct choose_promise {
    size_t candidate;
    double error; /* with these steps, on the stretch; share of the scale */
    uint64_t steps;
    int order;       /* that it has shown there; 0: none */
    uint64_t needed; /* steps that should hold in the whole run */
    double cost;     /* of that, s by the price list */
};

struct choose_choice {
    struct choose_candidate *candidate;
    size_t candidates, taken; /* taken == candidates: refused */
    struct choose_cut cut[MODELS_CUTS];
    size_t cuts;
    struct choose_point *point;
    size_t points;
    struct choose_promise *promise;
    size_t promises, stretch; /* how many; so many rows */
    double stretch_from;      /* the time at which they begin, s */
    struct models_acts acts;
    double scale; /* what errors are divided by: of judged */
    const char *judged;
    size_t rows;
    double rounding; /* what rounding does to the run: share of the scale */
    double growth;   /* of a displacement at the start, in the run */
    double horizon;  /* s; INFINITY: the run is inside it */
    double fastest;  /* 1/s: the largest rate that was met */
    int scouts;      /* that were sent */
    double meeting;  /* 1/s: of it, by attraction */
    double passing;  /* 1/s: the rate at which balls could pass unseen */
    double turning;  /* 1/s: at which springs with a length turn round;
                        INFINITY: faster than any step */
    double swinging; /* 1/s: of the fastest spring that is stretched */
    uint64_t fine;   /* steps to a row with which jumps have settled */
    double deciding; /* cost of all this, s by the price list */
    char refusal[CHOOSE_REFUSAL];
};

/* What a choice has taught about a plan, for its check. */
struct choose_known {
    double effect;           /* of what it leaves out */
    double order;            /* that was seen; 0: none */
    double meeting, passing; /* 1/s, as above */
    double turning, swinging;
    uint64_t fine; /* steps to a row with which the guide has settled */
};

/* A run that has been checked. */
struct choose_run {
    struct models_plan plan; /* with the steps that it came to */
    size_t columns, rows;    /* row 0 is the start */
    double *value;           /* [(rows + 1) * columns]; NULL: refused */
    double error;            /* found, share of the scale */
    double effect;           /* of it, by what was left out */
    double scale;            /* of judged */
    const char *judged;
    double cost, checking; /* s by the price list */
    double seconds;        /* of this processor, of the run alone */
    double work[MODELS_UNITS];
    int tightened; /* how often the steps were */
    bool checked;  /* it has been held against a companion */
    char refusal[CHOOSE_REFUSAL];
};

/* Looks for the cheapest way. Returns false when there is no memory, or
   the scene cannot be set in motion: says so, with nothing to free. A
   refusal is a result. */
bool choose(struct choose_choice *c, const struct choose_request *q);
void choose_free(struct choose_choice *c);

/* Runs a plan and checks it; unless fixed, tightens the steps until it
   holds, or refuses. known: what was learnt of it in choosing, or NULL: it
   is learnt now, and the order is the method's. Returns as choose does. */
bool choose_carry(struct choose_run *r, const struct choose_request *q,
                  const struct models_plan *plan,
                  const struct choose_known *known, bool fixed);
struct choose_known choose_known(const struct choose_choice *c,
                                 size_t candidate);

/* Is there reason to choose once more, when the taken candidate has been
   carried? Then the request knows of it, and the choice may be freed. */
bool choose_again(struct choose_request *q, const struct choose_choice *c,
                  const struct choose_run *r);
void choose_run_free(struct choose_run *r);

#endif
