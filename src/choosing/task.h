/* Shared by the files of the chooser: the question, the cost, the runs. */
#ifndef TASK_H
#define TASK_H

#include "choosing/choose.h"
#include "choosing/models.h"
#include "choosing/record.h"

/* A question, the view for comparing its runs, and the answer so far. */
struct task {
    const struct choose_request *q;
    struct record_view *view;
    struct reference *f;     /* found before candidates are compared */
    struct choose_choice *c; /* the answer, with all results */
};

/* A run with which others are compared, and its own error. The coarser of
   its two runs is kept as well, as a candidate. */
struct reference {
    struct record run, coarser;
    double seen;    /* difference of the two runs */
    double doubt;   /* bound of the error of the finer run */
    unsigned twins; /* number of twins of the finer run */
};

/* The runs of one method with finer and finer steps: the best of them and
   bounds of the next one. */
struct ladder {
    struct choose_candidate *candidate;
    struct models_plan foot;
    struct choose_point best; /* coarsest within the tolerance, or else
                                 last; model NULL: none */
    double least, most;       /* bounds of the next fineness, octaves */
    double rise;              /* octaves of cost per octave of fineness */
    double price;             /* predicted cost within the tolerance, s */
};

/* Fractions of the tolerance: errors up to `negligible` do not matter, and
   references that agree so well need no bound; `roughly` suffices for
   references with equal steps, and as a bound found by twins. */
static const double negligible = 0.05;
static const double roughly = 0.2;

/* ---- task.c: the cost and the list of candidates */

/* Returns the rest of the budget, s by the price list. */
double task_budget(const struct task *t);

/* Returns the tolerance of the steps of the first reference. */
double task_first_tolerance(const struct task *t);

/* Returns the parameters of a run of a plan: its cost limit, the smaller of
   `limit` and the rest of the budget, and thresholds for passages and
   contacts. */
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
   in all rows after the start. */
double task_difference(const struct task *t, const struct record *a,
                       const struct record *b);

/* Records that runs differ after the first `held` rows: this is a horizon
   of the scene, and the earliest one is kept. */
void task_note_horizon(const struct task *t, size_t held, double every);

/* Records the horizon after which two runs differ by more than `most`, if
   they do before one of them ends. */
void task_note_parting(const struct task *t, const struct record *a,
                       const struct record *b, double most);

/* Returns the candidate with a plan's model and cuts, a new one if
   needed. */
struct choose_candidate *task_candidate(const struct task *t,
                                        struct models_plan plan);

/* Stores the reason why a candidate is excluded. */
void task_explain(struct choose_candidate *k, const char *text);

/* Returns text that says how a run without all its rows ended. */
const char *task_ending(const struct record *r);

/* Returns the cost of the best run so far, s by the price list. */
double task_best_cost(const struct task *t);

/* Stores a run with its error: as a point of the chart; in its candidate,
   if it is the cheapest within the tolerance; and if it is the cheapest of
   all, the answer takes over its rows (*r is then empty), so that nothing
   is run again. */
void task_consider(const struct task *t, struct choose_candidate *k,
                   struct record *r, double error);

/* Writes a refusal of a plan: for the reason `why` or, if that is NULL, as
   too expensive in its `role`. */
void task_refuse_plan(const struct task *t, const struct models_plan *p,
                      const char *why, const char *role);

/* Writes a refusal and returns true if finer references are useless: they
   are too expensive, or always end early. *stood is 0 at first, then 1 plus
   the rows of the last run that ended because bodies came to rest on each
   other. */
bool task_gives_up(const struct task *t, const struct reference *f,
                   size_t *stood);

/* ---- rung.c: the numbers of steps of a method */

/* Returns the fineness of the steps of a plan, in octaves: one octave is
   twice as many steps, or half the tolerance. */
double rung_fineness(const struct models_plan *p);

/* Returns the coarsest rung of at least this fineness, with at most 2^52
   steps or a tolerance of at least 1e-15. */
struct models_plan rung_at(struct models_plan p, double fine);

/* Returns the lowest rung: the longest useful steps, three fifths of the
   method's stability limit or a radian of the largest rate. */
struct models_plan rung_lowest(const struct task *t, struct models_plan p);

/* Returns the distance of a run from the reference plus the error of the
   reference. */
double rung_error(const struct task *t, const struct record *r);

/* Runs a plan up to the cost `limit` and stores its error. l: NULL, or the
   plan's ladder: then a neighbouring rung must be within the tolerance,
   too. */
struct choose_point rung_try(const struct task *t, const struct ladder *l,
                             struct models_plan plan, double limit,
                             struct choose_candidate *k);

/* ---- twins.c: rounding errors of a run */

/* The largest number of twins of a run. The largest distance of k of them
   from the run, times twins_margin[k - 1], bounds the error of the run; for
   each k this fails with probability 6.7e-5. */
enum { TWINS = 6 };
extern const double twins_margin[TWINS];
static const double last_margin = 2; /* the last twins_margin */

/* Runs a plan and its twin row by row until they differ; returns whether
   they do. Both are to be freed. */
bool twins_run(const struct task *t, struct record_setup one,
               struct record *a, struct record *b);

/* Runs another twin of a run and returns their distance. If it exceeds
   `most`, a horizon is recorded, unless most is 0. */
double twins_add(const struct task *t, const struct record *r,
                 unsigned number, double most);

/* Returns a bound of the error of run a, which like its twin b is
   complete. */
double twins_bound(const struct task *t, const struct record *a,
                   const struct record *b);

/* ---- reference_run.c: references */

/* Finds a reference. Returns false if there is none; then a horizon or a
   refusal is recorded. */
bool reference_find(const struct task *t, struct reference *f);

/* Compares the finer run with twins of it, until they bound its error by
   `want`, or there are no more, or they differ by too much. Returns whether
   the bound is at most half of the tolerance. */
bool reference_ask_twins(const struct task *t, struct reference *f,
                         double want);

/* ---- climb.c: finer and finer steps of a method */

/* Updates a ladder with the result of a run of one of its rungs. */
void climb_note(const struct task *t, struct ladder *l,
                struct choose_point r);

/* Returns the cost of a run within the tolerance, as predicted from the
   order, s by the price list. */
double climb_price(const struct task *t, const struct ladder *l);

/* Tries finer rungs, as long as one may be cheaper than the best run. */
void climb(const struct task *t, struct ladder *l);

#endif
