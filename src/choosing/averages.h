/* Finds the mean of a quantity over a time, or says why it cannot. */
#ifndef AVERAGES_H
#define AVERAGES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum averages_kind {
    AVERAGES_PRESSURE,   /* Z = PV/NkT, V the room of the centres */
    AVERAGES_PLACE,      /* of a body along an axis, m */
    AVERAGES_KINETIC,    /* energy, J */
    AVERAGES_TEMPERATURE /* 2 K / free coordinates, J, with K relative to
                            the drift in a box without walls */
};

/* What the average is taken of. */
struct averages_quantity {
    enum averages_kind kind;
    size_t body, axis; /* of a place */
};

struct averages_request {
    const struct scene *scene;
    struct averages_quantity quantity;
    double until;      /* s: over which the mean is taken */
    double tolerance;  /* of the error, fraction of the scale */
    double budget;     /* what all may cost, s by the price list */
    const char *model; /* NULL, or the way that has to be the one */
};

/* How an error is known. */
enum averages_sure {
    AVERAGES_EXACT,    /* rounding apart there is none */
    AVERAGES_BOUND,    /* proved */
    AVERAGES_ESTIMATE, /* measured: two standard errors */
    AVERAGES_OUT       /* refused */
};
enum { AVERAGES_TEXT = 200, AVERAGES_REFUSAL = 400 };
enum { AVERAGES_BUDGET = 60 }; /* s by the price list: a usual .budget */

struct averages_found {
    const char *way; /* conserved, tonks or events; NULL: none */
    enum averages_sure sure;
    double value, error;      /* in its unit; fraction of the scale */
    double scale;             /* 1 or Z, the larger; the box; the value */
    double time, cost;        /* s simulated for it; s by the price list */
    char text[AVERAGES_TEXT]; /* what was seen */
    char refusal[AVERAGES_REFUSAL]; /* empty unless refused */
};

/* Reads pressure, kinetic, temperature, x:3 or y:0. If there is no such
   average of this scene returns false and says why in message. */
bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT]);

/* Writes the symbol of the quantity and returns its unit. */
const char *averages_name(const struct averages_quantity *q,
                          char symbol[32]);

/* Finds an average within the tolerance. A refusal is a result. Returns
   false if memory runs out. */
bool averages_find(struct averages_found *f,
                   const struct averages_request *q);

#endif
