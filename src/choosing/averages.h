/* Computes the mean of a quantity over time, or says why it cannot. */
#ifndef AVERAGES_H
#define AVERAGES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum averages_kind {
    AVERAGES_PRESSURE,   /* Z = PV/NkT, V open to the centres */
    AVERAGES_PLACE,      /* mean position along an axis, m */
    AVERAGES_KINETIC,    /* kinetic energy, J */
    AVERAGES_TEMPERATURE /* kT = 2 K / (free coordinates), J; in a periodic
                            box K is relative to the drift */
};

/* The quantity whose mean is requested. */
struct averages_quantity {
    enum averages_kind kind;
    size_t body, axis; /* used only for AVERAGES_PLACE */
};

struct averages_request {
    const struct scene *scene;
    struct averages_quantity quantity;
    double until;      /* time over which the mean is taken, s */
    double tolerance;  /* largest error, as a fraction of the scale */
    double budget;     /* largest cost, s by the price list */
    const char *model; /* NULL, or the name of the only method allowed */
};

/* The kinds of error of a mean. */
enum averages_sure {
    AVERAGES_EXACT,    /* rounding errors only */
    AVERAGES_BOUND,    /* a proven bound */
    AVERAGES_ESTIMATE, /* measured: two standard errors */
    AVERAGES_OUT       /* no answer */
};
enum { AVERAGES_TEXT = 200, AVERAGES_REFUSAL = 400 };
enum { AVERAGES_BUDGET = 60 }; /* default budget, s by the price list */

struct averages_found {
    const char *way; /* method: conserved, tonks or events; NULL: none */
    enum averages_sure sure;
    double value, error;      /* value in its unit; error over scale */
    double scale;             /* divisor: max(1, Z), box or value */
    double time, cost;        /* simulated time; price-list cost; s */
    char text[AVERAGES_TEXT]; /* how the answer was found */
    char refusal[AVERAGES_REFUSAL]; /* empty unless refused */
};

/* Parses the name of a quantity: pressure, kinetic, temperature, or a mean
   position such as x:3 or y:0. Returns false, with an error in message, if
   the scene has no such average. */
bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT]);

/* Writes the symbol of the quantity and returns its unit. */
const char *averages_name(const struct averages_quantity *q,
                          char symbol[32]);

/* Computes an average within the tolerance; a refusal counts as a result.
   Returns false if memory runs out. */
bool averages_find(struct averages_found *f,
                   const struct averages_request *q);

#endif
