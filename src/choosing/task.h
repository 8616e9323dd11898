/* Declares what the files of the chooser share: request, cost, runs. */
#ifndef TASK_H
#define TASK_H

#include "choosing/choose.h"
#include "choosing/models.h"
#include "choosing/record.h"

/* A request, the view for comparing its runs, and the answer so far. */
struct task {
    const struct choose_request *q;
    struct record_view *view;
    struct reference *f;     /* the reference, once it is found */
    struct choose_choice *c; /* the answer, with all results */
};

/* The run with which all candidates are compared, and a bound on its error.
   It agrees with a run with coarser steps, which is kept as a candidate. */
struct reference {
    struct record run, coarser;
    double seen;    /* difference of the two runs */
    double doubt;   /* bound on the error of the finer run */
    unsigned twins; /* number of twins of the finer run */
};

/* The runs of a method with finer and finer steps: the best run so far, and
   bounds on the next number of steps. A fineness is the binary logarithm of
   the number of steps, or minus that of the tolerance of an adaptive
   method. */
struct ladder {
    struct choose_candidate *candidate;
    struct models_plan foot;
    struct choose_point best; /* coarsest run within the tolerance, or else
                                 the last run; its model is NULL if there is
                                 none */
    double least, most;       /* bounds on the fineness of the next run */
    double rise;  /* increase of log2(cost) per unit of fineness */
    double price; /* predicted cost of a run within the tolerance, s */
};

/* Fractions of the tolerance. Errors up to `negligible` do not matter, so
   if two adaptive reference runs differ by less, no bound is needed.
   `roughly` is the largest allowed difference of two reference runs with
   equal steps. No more twins are run once they bound the error by
   `roughly`. */
static const double negligible = 0.05;
static const double roughly = 0.2;

/* ---- task.c: the cost and the list of candidates */

/* Returns the rest of the budget, s. */
double task_budget(const struct task *t);

/* Returns the tolerance of the steps of the first reference. */
double task_first_tolerance(const struct task *t);

/* Returns the parameters of a run of a plan, with thresholds for passages
   and contacts. The cost limit is the smaller of `limit` and the rest of
   the budget. */
struct record_setup task_setup(const struct task *t,
                               struct models_plan plan, double limit);

/* Adds the cost of a run to the total, and calls the request's `watch`. */
void task_bill(const struct task *t, const struct record *r);

/* Makes a run and adds its cost to the total. Free the run with
   record_free. */
void task_run(const struct task *t, struct record *r,
              const struct record_setup *o);

/* Returns whether a run has all its rows, and so can be compared. */
bool task_complete(const struct task *t, const struct record *r);

/* Returns the largest difference between two runs, as a fraction of the
   scale, in all rows after the start. */
double task_difference(const struct task *t, const struct record *a,
                       const struct record *b);

/* Records a horizon: the motion is unpredictable after the first `held`
   rows, since runs differ. Only the earliest horizon is kept. */
void task_note_horizon(const struct task *t, size_t held, double every);

/* Records a horizon at the last row before two runs differ by more than
   `most`. Does nothing if one of them ends before they differ. */
void task_note_parting(const struct task *t, const struct record *a,
                       const struct record *b, double most);

/* Returns the candidate with the model and the simplifications (cuts) of a
   plan. Adds it if it is new. */
struct choose_candidate *task_candidate(const struct task *t,
                                        struct models_plan plan);

/* Stores the reason why a candidate is excluded. */
void task_explain(struct choose_candidate *k, const char *text);

/* Returns why a run ended before its last row, as a text. */
const char *task_ending(const struct record *r);

/* Returns the cost of the best run so far (in s), or INFINITY if there is
   none. */
double task_best_cost(const struct task *t);

/* Stores a run with its error as a point of the chart, and in its
   candidate unless the candidate has a better run. If the run is within
   the tolerance and the cheapest so far, it becomes the answer; its rows
   are moved there, and *r is left empty. */
void task_consider(const struct task *t, struct choose_candidate *k,
                   struct record *r, double error);

/* Writes a refusal of a plan for the reason `why`. If why is NULL, the plan
   is too expensive, and `role` says what it was needed for. */
void task_refuse_plan(const struct task *t, const struct models_plan *p,
                      const char *why, const char *role);

/* Writes a refusal and returns true if finer references are useless,
   because runs are too expensive or always end early. *stood must be 0 at
   first. If a run has ended because bodies came to rest on each other, sets
   *stood to 1 plus the number of its rows. */
bool task_gives_up(const struct task *t, const struct reference *f,
                   size_t *stood);

/* ---- rung.c: the numbers of steps, or tolerances, that may be tried */

/* Returns the fineness of the steps of a plan: the binary logarithm of the
   number of steps, or minus that of the tolerance. */
double rung_fineness(const struct models_plan *p);

/* Returns the coarsest plan of at least this fineness, with at most 2^52
   steps or a tolerance of at least 1e-15. */
struct models_plan rung_at(struct models_plan p, double fine);

/* Returns the coarsest useful plan. Equal steps are three fifths of the
   method's stability limit, but at most two radians at the largest rate; if
   there is no limit, one radian. The tolerance of an adaptive method is
   that of the request, but at most 1e-4. */
struct models_plan rung_lowest(const struct task *t, struct models_plan p);

/* Returns the distance of a run from the reference plus the error of the
   reference. */
double rung_error(const struct task *t, const struct record *r);

/* Runs a plan with the cost limit `limit` and stores its error. l is NULL
   or the plan's ladder. With a ladder, a run with a neighbouring number of
   steps must be within the tolerance, too. */
struct choose_point rung_try(const struct task *t, const struct ladder *l,
                             struct models_plan plan, double limit,
                             struct choose_candidate *k);

/* ---- twins.c: bounds on rounding errors, from runs in other units */

/* The largest number of twins of a run. If k twins differ from the run by
   at most d, then twins_margin[k - 1] * d bounds the error of the run. For
   each k this bound fails with probability 6.7e-5. */
enum { TWINS = 6 };
extern const double twins_margin[TWINS];
static const double last_margin = 2; /* twins_margin[TWINS - 1] */

/* Runs a plan and its twin side by side until they differ in a row.
   Returns whether they do. Free both records. */
bool twins_run(const struct task *t, struct record_setup one,
               struct record *a, struct record *b);

/* Runs another twin of a run and returns how far the two differ. If the
   difference exceeds `most`, and most > 0, records a horizon. */
double twins_add(const struct task *t, const struct record *r,
                 unsigned number, double most);

/* Returns a bound on the error of run a. Both a and its twin b must be
   complete. */
double twins_bound(const struct task *t, const struct record *a,
                   const struct record *b);

/* ---- reference_run.c: finds references */

/* Finds a reference. If there is none, records a horizon or a refusal and
   returns false. */
bool reference_find(const struct task *t, struct reference *f);

/* Runs twins of the finer reference run until they bound its error by
   `want`, differ by too much, or none are left. Returns whether the bound
   is at most half of the tolerance. */
bool reference_ask_twins(const struct task *t, struct reference *f,
                         double want);

/* ---- climb.c: tries finer and finer steps of a method */

/* Updates a ladder with the result of one of its runs. */
void climb_note(const struct task *t, struct ladder *l,
                struct choose_point r);

/* Returns the predicted cost (in s) of a run within the tolerance. The
   prediction is based on the order of the method. */
double climb_price(const struct task *t, const struct ladder *l);

/* Tries finer steps while these may be cheaper than the best run. */
void climb(const struct task *t, struct ladder *l);

#endif
