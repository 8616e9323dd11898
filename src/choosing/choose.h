/* Finds the cheapest way to compute a scene within a tolerance. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "choosing/models.h"
#include "choosing/record.h"
#include "forces/observables.h"

enum { CHOOSE_TEXT = 160, CHOOSE_REFUSAL = 500, CHOOSE_SENTENCE = 600 };
enum { CHOOSE_BUDGET = 60 }; /* default cost limit, s */
enum { CHOOSE_MOST = STEPPING_MOST + 40, CHOOSE_POINTS = 400 };

/* The question: a scene, a time, a tolerance, and the observables. Unless
   watch is NULL, it is called with the total cost after each run. */
struct choose_request {
    const struct scene *scene;
    const char *program;             /* name of the program, for messages */
    double until, every;             /* time of the last row; interval; s */
    double tolerance;                /* allowed error / scale */
    const struct observables *asked; /* NULL: judge all positions */
    double budget;                   /* limit of the total cost, s */
    const struct models_plan *only;  /* NULL, or the only plan allowed */
    void (*watch)(void *with, double spent);
    void *with;
};

/* A model with its simplifications, and its results so far. */
struct choose_candidate {
    struct models_plan plan;
    double error, cost; /* error / scale; cost, s */
    double foreseen;    /* predicted cost, s; INFINITY: unknown */
    bool holds;
    char text[CHOOSE_TEXT]; /* result, or why the candidate is excluded */
};

/* A run whose error has been measured. */
struct choose_point {
    struct models_plan plan;
    double error, cost;
};

/* Two bodies, a and b, that are closer than the tolerance because body
   `far` makes the scale so large. If there are no such bodies, a == b.
   distance (m) is that of a and b, and without (m) is the scale without
   body `far`. */
struct choose_hidden {
    size_t a, b, far;
    double distance, without;
};

/* The answer and how it was found. The chosen run is that of
   candidate[taken]. If the request is refused, taken equals candidates. */
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
    struct models_plan reference; /* model is NULL if there is none */
    double doubt;                 /* bound on the error of the reference */
    double rounding;              /* bound on the error of an exact run */
    double horizon;               /* end of the predictable motion, s */
    double spent;                 /* total cost, s */
    char refusal[CHOOSE_REFUSAL];
};

/* Answers a request with a run or a refusal. If memory runs out or the
   scene cannot be set in motion, prints an error and returns false, with
   nothing to free. */
bool choose(struct choose_choice *c, const struct choose_request *q);
void choose_free(struct choose_choice *c);

/* Writes a sentence about the chosen candidate and the cost of the next
   one, such as "pefrl:56: its fourth order meets 0.0001 at 56 steps a row;
   leapfrog would cost 20 times as much". If that cost is only predicted,
   the sentence says so. */
void choose_sentence(const struct choose_choice *c, double tolerance,
                     char text[CHOOSE_SENTENCE]);

#endif
