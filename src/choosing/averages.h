/* Computes the time average of a quantity, or says why it cannot. */
#ifndef AVERAGES_H
#define AVERAGES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>

enum averages_kind {
    AVERAGES_PRESSURE,   /* PV/(NkT); V: volume accessible to centres */
    AVERAGES_PLACE,      /* mean position along an axis, m */
    AVERAGES_KINETIC,    /* kinetic energy, J */
    AVERAGES_TEMPERATURE /* kT = 2 K / (number of free coordinates), J; K
                            excludes the drift in a periodic box */
};

struct averages_quantity {
    enum averages_kind kind;
    size_t body, axis; /* used only for AVERAGES_PLACE */
};

struct averages_request {
    const struct scene *scene;
    struct averages_quantity quantity;
    double until;      /* averaging time, s */
    double tolerance;  /* allowed error, as a fraction of the scale */
    double budget;     /* cost limit, s */
    const char *model; /* NULL, or the only allowed method */
};

/* How the error of a mean is known. */
enum averages_sure {
    AVERAGES_EXACT,    /* rounding errors only */
    AVERAGES_BOUND,    /* a proven bound */
    AVERAGES_ESTIMATE, /* an estimate: two standard errors */
    AVERAGES_OUT       /* no answer */
};
enum { AVERAGES_TEXT = 200, AVERAGES_REFUSAL = 400 };
enum { AVERAGES_BUDGET = 60 }; /* default cost limit, s */

struct averages_found {
    const char *way; /* "conserved", "tonks" or "events"; NULL: none */
    enum averages_sure sure;
    double value, error;      /* error: a fraction of the scale */
    double scale;             /* max(1, Z), length of the box, or value */
    double time, cost;        /* simulated time, s; cost of the run, s */
    char text[AVERAGES_TEXT]; /* how the answer was found */
    char refusal[AVERAGES_REFUSAL]; /* empty unless refused */
};

/* Parses the name of a quantity: pressure, kinetic, temperature, or a mean
   position such as x:3 or y:0. If the scene has no such average, writes an
   error to message and returns false. */
bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT]);

/* Writes the symbol of the quantity and returns its unit. */
const char *averages_name(const struct averages_quantity *q,
                          char symbol[32]);

/* Computes an average within the tolerance, or refuses. Returns false only
   if memory runs out. */
bool averages_find(struct averages_found *f,
                   const struct averages_request *q);

#endif
