/* Finds the cheapest way to compute a scene within a tolerance. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "choosing/models.h"
#include "choosing/record.h"
#include "forces/observables.h"

enum { CHOOSE_TEXT = 160, CHOOSE_REFUSAL = 500, CHOOSE_SENTENCE = 600 };
enum { CHOOSE_BUDGET = 60 }; /* default cost limit, s */
enum { CHOOSE_MOST = STEPPING_MOST + 40, CHOOSE_POINTS = 400 };

/* A request: a scene, a time, a tolerance, and the observables. Unless
   `watch` is NULL, it is called after each run with the total cost so
   far. */
struct choose_request {
    const struct scene *scene;
    const char *program;             /* name of the program, for messages */
    double until, every;             /* time of the last row; interval; s */
    double tolerance;                /* allowed error / scale */
    const struct observables *asked; /* NULL: compare all positions */
    double budget;                   /* limit of the total cost, s */
    const struct models_plan *only;  /* NULL, or the only plan allowed */
    void (*watch)(void *with, double spent);
    void *with;
};

/* A model with its simplifications of the scene, and its results so far. */
struct choose_candidate {
    struct models_plan plan;
    double error, cost; /* error, as a fraction of the scale; cost, s */
    double foreseen;    /* predicted cost, s; INFINITY: unknown */
    bool holds;
    char text[CHOOSE_TEXT]; /* result, or why the candidate is excluded */
};

/* A run whose error has been measured. */
struct choose_point {
    struct models_plan plan;
    double error, cost;
};

/* Two bodies a and b whose distance (m) is below the tolerance because a
   third body, `far`, makes the scale so large. `without` (m) is the scale
   without the third body. If there are no such bodies, a == b. */
struct choose_hidden {
    size_t a, b, far;
    double distance, without;
};

/* The answer and how it was found. The chosen run is that of
   candidate[taken]. If the request is refused, `taken` equals
   `candidates`. */
struct choose_choice {
    struct choose_candidate candidate[CHOOSE_MOST];
    size_t candidates, taken;
    struct choose_point point[CHOOSE_POINTS];
    size_t points;
    struct models_acts acts;
    double scale; /* divisor of errors, in the unit of `judged` */
    const char *judged;
    struct choose_hidden hidden;
    size_t rows, columns;
    struct record run;            /* the chosen run */
    struct models_plan reference; /* its model is NULL if there is none */
    double doubt;                 /* bound on the error of the reference */
    double rounding;              /* bound on the error of an exact run */
    double horizon;               /* end of the predictable motion, s */
    double spent;                 /* total cost, s */
    char refusal[CHOOSE_REFUSAL];
};

/* Answers a request with a run or a refusal. Returns false, with nothing to
   free, if memory runs out or the motion of the scene cannot be prepared;
   then an error has been printed. */
bool choose(struct choose_choice *c, const struct choose_request *q);
void choose_free(struct choose_choice *c);

/* Writes a sentence about the chosen run and the next cheapest candidate,
   such as "pefrl:56: its fourth order meets 0.0001 at 56 steps a row;
   leapfrog would cost 20 times as much". If that cost is only predicted,
   the sentence says so. */
void choose_sentence(const struct choose_choice *c, double tolerance,
                     char text[CHOOSE_SENTENCE]);

#endif
