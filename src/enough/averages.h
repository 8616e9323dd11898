/* From chapters/12-averages.nw: edit there, then run make tangle. */
/* checksum 1038485358 of the lines below */
/* The cheapest way to the mean of a quantity, or why there is none. */
#ifndef AVERAGES_H
#define AVERAGES_H

#include "enough/models.h"
#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum averages_kind {
    AVERAGES_PRESSURE,   /* Z = PV/NkT, V the room of the centres */
    AVERAGES_PLACE,      /* of a body along an axis, m */
    AVERAGES_KINETIC,    /* energy, J */
    AVERAGES_TEMPERATURE /* 2 K / free coordinates, J */
};

/* What the average is taken of. */
struct averages_quantity {
    enum averages_kind kind;
    size_t body, axis; /* of a place */
};

struct averages_request {
    const struct scene *scene;
    struct averages_quantity quantity;
    double until;      /* s: the run that is meant, and the longest */
    double tolerance;  /* of two standard errors, share of the scale */
    double reason;     /* the dearest run, s by the price list */
    const char *model; /* NULL, or the way to take */
};

/* How an error is known. */
enum averages_sure {
    AVERAGES_EXACT,    /* rounding apart there is none */
    AVERAGES_BOUND,    /* proved */
    AVERAGES_ESTIMATE, /* measured: two standard errors, or a check */
    AVERAGES_OUT       /* not a way for this scene, or not far enough */
};
enum { AVERAGES_TEXT = 200, AVERAGES_MOST = 8, AVERAGES_REFUSAL = 400 };
enum { AVERAGES_REASON = 60 }; /* s by the price list: a usual .reason */

/* A way to the average. */
struct averages_candidate {
    const char *name; /* conserved, tonks, two-disks, springs, whole,
                         order, events, instants, sampling or steps */
    enum averages_sure sure;
    double value, error; /* in its unit; share of the scale */
    double cost;         /* of the whole way, s by the price list */
    char text[AVERAGES_TEXT];
};

struct averages_found {
    struct averages_candidate candidate[AVERAGES_MOST];
    size_t candidates, taken;  /* taken == candidates: refused */
    double value, error;       /* as of the candidate that was taken */
    double scale;              /* 1 or Z, the larger; the box; the value */
    double time;               /* s that events have simulated for it */
    uint64_t samples;          /* after the warm-up; 0: a closed form */
    double inefficiency;       /* samples to one independent one */
    double cost, deciding;     /* of that way; of all else: s by the list */
    double work[MODELS_UNITS]; /* of both */
    char refusal[AVERAGES_REFUSAL]; /* empty unless refused */
};

/* Reads pressure, kinetic, temperature, x:3 or y:0. If there is no such
   average of this scene returns false and says why in message. */
bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT]);

/* Writes the symbol of the quantity and returns its unit. */
const char *averages_name(const struct averages_quantity *q,
                          char symbol[32]);

/* Looks for the cheapest way to the average that holds the tolerance and
   takes it. A refusal is a result. Returns false without memory. */
bool averages_find(struct averages_found *f,
                   const struct averages_request *q);

#endif
