/* The cheapest way to compute a scene within a tolerance, or a refusal. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "choosing/models.h"
#include "choosing/record.h"
#include "forces/observables.h"

enum { CHOOSE_TEXT = 160, CHOOSE_REFUSAL = 500, CHOOSE_SENTENCE = 600 };
enum { CHOOSE_BUDGET = 60 }; /* s by the price list: a usual .budget */
enum { CHOOSE_MOST = STEPPING_MOST + 40, CHOOSE_POINTS = 400 };

/* A question: a scene, a time, a tolerance, and what is looked at. */
struct choose_request {
    const struct scene *scene;
    const char *program;             /* its name, for messages */
    double until, every;             /* s: last row; interval of the rows */
    double tolerance;                /* fraction of the scale */
    const struct observables *asked; /* NULL: all positions */
    double budget; /* what all of it may cost, s by the price list */
    const struct models_plan *only; /* NULL, or what has to be taken */
    void (*watch)(void *with, double spent); /* NULL, or called with the
                                                cost so far */
    void *with;
};

/* A candidate: a model with what it leaves out, and what was seen of it. */
struct choose_candidate {
    struct models_plan plan;
    double error, cost; /* fraction of the scale; s by the price list */
    double foreseen;    /* s: what it would cost to hold; or INFINITY */
    bool holds;
    char text[CHOOSE_TEXT]; /* what was seen, or why it is out */
};

/* A run whose error was seen. */
struct choose_point {
    struct models_plan plan;
    double error, cost;
};

/* What the scale hides: bodies a and b are nearer than the tolerance;
   without body `far` it would be much shorter. a == b: nothing. */
struct choose_hidden {
    size_t a, b, far;
    double distance, without; /* m */
};

/* The answer: the run with its rows or a refusal, and how it was come
   by. */
struct choose_choice {
    struct choose_candidate candidate[CHOOSE_MOST];
    size_t candidates, taken; /* taken == candidates: refused */
    struct choose_point point[CHOOSE_POINTS];
    size_t points;
    struct models_acts acts;
    double scale; /* what errors are divided by: of judged */
    const char *judged;
    struct choose_hidden hidden;
    size_t rows, columns;
    struct record run;            /* of the taken one */
    struct models_plan reference; /* model NULL: there was none */
    double doubt;                 /* how far two references are apart */
    double rounding;              /* bound of the error of an exact run */
    double horizon;               /* s: beyond it nothing can be computed */
    double spent;                 /* on all, s by the price list */
    char refusal[CHOOSE_REFUSAL];
};

/* Takes the cheapest way; a refusal is a result. false: there is no memory,
   or the scene cannot be set in motion; says so, with nothing to free. */
bool choose(struct choose_choice *c, const struct choose_request *q);
void choose_free(struct choose_choice *c);

/* Says in words what was taken, and what another way would have cost:
   "pefrl:56: its fourth order meets 0.0001 at 56 steps a row; leapfrog
   would cost 20 times as much". Of a way that was not run until it held
   it says that this is what its order promises. */
void choose_sentence(const struct choose_choice *c, double tolerance,
                     char text[CHOOSE_SENTENCE]);

#endif
