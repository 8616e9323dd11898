/* What the parts of the chooser share: the question, the cost, and runs. */
#ifndef TASK_H
#define TASK_H

#include "choosing/choose.h"
#include "choosing/models.h"
#include "choosing/record.h"

/* A question, what its runs are judged by, and the answer so far. */
struct task {
    const struct choose_request *q;
    struct record_view *view;
    struct reference *f;     /* stands when candidates are tried */
    struct choose_choice *c; /* where what was seen is written down */
};

/* A run to compare others with, and how far it may itself be off. The
   coarser one of two is kept as well: it is a candidate like others. */
struct reference {
    struct record run, coarser;
    double seen;    /* how far the two are apart */
    double doubt;   /* how far the finer one may be off */
    unsigned twins; /* how many were run, besides the coarser run */
};

/* The runs of one method with finer and finer steps. Kept are the best of
   them and the bounds between which the next one has to lie. */
struct ladder {
    struct choose_candidate *candidate;
    struct models_plan foot;
    struct choose_point best; /* the coarsest within the tolerance, or else
                                 the last; model NULL: none was tried */
    double least, most;       /* bounds of the next fineness, in
                                 octaves */
    double rise;              /* octaves of cost per octave of fineness */
    double price; /* s: estimated after the first run, of a run within
                     the tolerance */
};

/* Fractions of the tolerance: what is nothing beside it, and how well two
   references agree; and what cheap ones do. */
static const double negligible = 0.05;
static const double roughly = 0.2;

/* ---- task.c: the bill and the list of candidates */

/* Returns what is left to be spent, s by the price list. */
double task_budget(const struct task *t);

/* Returns the tolerance of the steps of the first reference. */
double task_first_tolerance(const struct task *t);

/* Writes down how a plan is to be run: for what it may cost at most, what
   is left and the limit, and with which passages and contacts count. */
struct record_setup task_setup(const struct task *t,
                               struct models_plan plan, double limit);

/* Adds the cost of a run to the total, and calls the request's `watch`. */
void task_bill(const struct task *t, const struct record *r);

/* Makes a run and adds its cost to the total; free it with record_free. */
void task_run(const struct task *t, struct record *r,
              const struct record_setup *o);

/* Returns whether a run has all its rows: only then can it be compared. */
bool task_complete(const struct task *t, const struct record *r);

/* Returns the largest difference of two runs, as a fraction of the scale,
   from the first row after the start, where all are alike. */
double task_difference(const struct task *t, const struct record *a,
                       const struct record *b);

/* Records that runs differ after the first `held` rows: this is the horizon
   of the scene, and the nearest one seen counts. */
void task_note_horizon(const struct task *t, size_t held, double every);

/* Records the horizon, as task_note_horizon does, of two runs if they
   differ by more than `most`; their first rows may agree nevertheless. */
void task_note_parting(const struct task *t, const struct record *a,
                       const struct record *b, double most);

/* Returns the candidate of a plan's model and cuts, a new one if there is
   none. The list has room for more than there are. */
struct choose_candidate *task_candidate(const struct task *t,
                                        struct models_plan plan);

/* Stores the reason why a candidate is excluded. */
void task_explain(struct choose_candidate *k, const char *text);

/* Returns in words how a run ended that has not all its rows. */
const char *task_ending(const struct record *r);

/* Returns the cost to beat, s by the price list. */
double task_best_cost(const struct task *t);

/* Writes down a run whose error was seen: as a point of the chart; with its
   candidate, if it is the cheapest of that which holds; and if it is the
   cheapest of all, the answer takes its rows over (*r is then empty), so
   that nothing has to be run again. */
void task_consider(const struct task *t, struct choose_candidate *k,
                   struct record *r, double error);

/* Refuses, as a plan is too expensive (why NULL), or for another reason. */
void task_refuse_plan(const struct task *t, const struct models_plan *p,
                      const char *why, const char *role);

/* Refuses if it is no use to look for finer references: *f is too
   expensive, or it is the scene that ends them. *stood: 0 at first; the
   rows of the last run that ended since bodies came to rest on each other,
   and 1. */
bool task_gives_up(const struct task *t, const struct reference *f,
                   size_t *stood);

/* ---- rung.c: how fine the steps of a method may be, one by one */

/* Returns how fine the steps of a plan are, in octaves: one octave is twice
   as many steps, or half the tolerance. */
double rung_fineness(const struct models_plan *p);

/* Returns the coarsest rung that is as fine as this, with 2^52 steps or a
   tolerance of 1e-15 at most. */
struct models_plan rung_at(struct models_plan p, double fine);

/* Returns the lowest rung: the longest steps that make sense, three fifths
   of what the method can bear or a radian of the largest rate. */
struct models_plan rung_lowest(const struct task *t, struct models_plan p);

/* Returns how far a run is from the reference, and that from the truth. */
double rung_error(const struct task *t, const struct record *r);

/* Runs a plan, up to a cost, and writes down how far off it is. l: NULL, or
   the ladder that it is a rung of: then a neighbour has to hold, too. */
struct choose_point rung_try(const struct task *t, const struct ladder *l,
                             struct models_plan plan, double limit,
                             struct choose_candidate *k);

/* ---- twins.c: what rounding does to a run */

/* The largest number of twins of a run. The largest distance from k of
   them, times a factor, bounds the error of the run; for each k the chance
   that it does not is 6.7e-5. */
enum { TWINS = 6 };
extern const double twins_margin[TWINS];
static const double last_margin = 2; /* the last of them, and the least */

/* Runs a plan and its twin side by side until they part; returns whether
   they have. Both are to be freed. */
bool twins_run(const struct task *t, struct record_setup one,
               struct record *a, struct record *b);

/* Runs another twin of a run and returns their distance. Where they are
   more than `most` apart that is noted as a horizon; 0: it is none. */
double twins_add(const struct task *t, const struct record *r,
                 unsigned number, double most);

/* Returns how far a run may be off that is complete, like its first
   twin. */
double twins_bound(const struct task *t, const struct record *a,
                   const struct record *b);

/* ---- reference_run.c: a run that proves itself */

/* Finds a reference. false: there is none; if that is no horizon, the
   refusal says why. */
bool reference_find(const struct task *t, struct reference *f);

/* Compares the finer run with twins of its own, until they bound its error
   by `want`, or there are no more, or they differ by too much. Returns
   whether the bound is at most half of the tolerance. */
bool reference_ask_twins(const struct task *t, struct reference *f,
                         double want);

/* ---- climb.c: finer steps, as long as they may pay */

/* Notes on a ladder what a run of one of its rungs has shown. */
void climb_note(const struct task *t, struct ladder *l,
                struct choose_point r);

/* Returns what is expected to hold, by the order, s by the price list. */
double climb_price(const struct task *t, const struct ladder *l);

/* Tries finer rungs, as long as one may become cheaper than the best. */
void climb(const struct task *t, struct ladder *l);

#endif
