/* Adds up the chooser's cost, stores candidates, prepares runs. */
#include "choosing/task.h"

#include <math.h>
#include <stdio.h>

double task_budget(const struct task *t)
{
    return fmax(t->q->budget - t->c->spent, 0);
}

double task_first_tolerance(const struct task *t)
{
    return fmax(1e-8, fmin(1e-3, pow(t->q->tolerance, 2.0 / 3)));
}

/* A close passage of two bodies must be resolved if it moves one of them by
   more than a twentieth of the tolerance before the end of the run (12.13,
   eq:choose-passage). For finer references this threshold is lower, since
   two runs that both miss a passage would agree. */
struct record_setup task_setup(const struct task *t,
                               struct models_plan plan, double limit)
{
    const double less = fmin(plan.tolerance / task_first_tolerance(t), 1);
    plan.negligible = negligible * t->q->tolerance * t->view->length * less;
    plan.time_left = (double)t->c->rows * t->q->every;
    plan.start_limit =
        fmax(task_budget(t) / 2, 1e-9); /* half, since a twin also starts */
    plan.contact_margin =
        plan.tolerance > 0 ? t->q->tolerance * t->view->length : 0;
    return (struct record_setup){.scene = t->q->scene,
                                 .plan = plan,
                                 .every = t->q->every,
                                 .rows = t->c->rows,
                                 .limit = fmin(limit, task_budget(t))};
}

void task_bill(const struct task *t, const struct record *r)
{
    t->c->spent += r->cost;
    if (t->q->watch)
        t->q->watch(t->q->with, t->c->spent);
}

void task_run(const struct task *t, struct record *r,
              const struct record_setup *o)
{
    record_run(r, t->view, o);
    task_bill(t, r);
}

bool task_complete(const struct task *t, const struct record *r)
{
    return r->end == MODELS_DONE && r->reached == t->c->rows;
}

double task_difference(const struct task *t, const struct record *a,
                       const struct record *b)
{
    return record_difference(t->view, a, b, 1, t->c->rows);
}

void task_note_horizon(const struct task *t, size_t held, double every)
{
    const double until = t->q->scene->time + (double)held * every;
    t->c->horizon = fmin(t->c->horizon, until);
}

void task_note_parting(const struct task *t, const struct record *a,
                       const struct record *b, double most)
{
    const size_t held = record_agree(t->view, a, b, most);
    if (held < a->reached && held < b->reached)
        task_note_horizon(t, held, t->q->every);
}

struct choose_candidate *task_candidate(const struct task *t,
                                        struct models_plan plan)
{
    struct choose_choice *c = t->c;
    for (size_t j = 0; j < c->candidates; ++j)
        if (c->candidate[j].plan.model == plan.model &&
            c->candidate[j].plan.cuts == plan.cuts)
            return &c->candidate[j];
    struct choose_candidate *next = &c->candidate[c->candidates++];
    *next = (struct choose_candidate){.plan = plan,
                                      .error = INFINITY,
                                      .cost = INFINITY,
                                      .foreseen = INFINITY};
    return next;
}

void task_explain(struct choose_candidate *k, const char *text)
{
    snprintf(k->text, sizeof k->text, "%s", text);
}

const char *task_ending(const struct record *r)
{
    return r->why                        ? r->why
           : r->end == MODELS_STANDSTILL ? "collisions without end"
           : r->end == MODELS_COSTLY     ? "more expensive than the best"
           : r->end == MODELS_MEMORY     ? "no memory"
           : r->end == MODELS_BROKEN     ? "breaks down"
                                         : "";
}

double task_best_cost(const struct task *t)
{
    return t->c->run.value ? t->c->run.cost : INFINITY;
}

void task_consider(const struct task *t, struct choose_candidate *k,
                   struct record *r, double error)
{
    struct choose_choice *c = t->c;
    const bool holds = error <= t->q->tolerance;
    if (c->points < CHOOSE_POINTS && isfinite(error))
        c->point[c->points++] =
            (struct choose_point){r->plan, error, r->cost};
    if (k->holds && (!holds || r->cost >= k->cost))
        return;
    k->plan = r->plan;
    k->error = error;
    k->cost = r->cost;
    k->holds = holds;
    if (!holds || !(r->cost < task_best_cost(t)))
        return;
    record_free(&c->run);
    c->run = *r;
    r->value = NULL;
    c->taken = (size_t)(k - c->candidate);
}

void task_refuse_plan(const struct task *t, const struct models_plan *p,
                      const char *why, const char *role)
{
    char *to = t->c->refusal, plan[MODELS_TEXT];
    models_write(p, plan);
    if (why)
        snprintf(to, CHOOSE_REFUSAL, "%s: %s", plan, why);
    else
        snprintf(to, CHOOSE_REFUSAL,
                 "beyond reason: %s%s would bring the bill above %.3g s by "
                 "the price list; spent: %.2g s",
                 plan, role, t->q->budget, t->c->spent);
}

/* Refuses a scene whose bodies come to rest on each other. Rounding and the
   order of simultaneous collisions cannot be the cause, since runs with two
   tolerances have stopped after the same number of rows. */
static void refuse_standstill(const struct task *t, const struct record *r)
{
    snprintf(t->c->refusal, CHOOSE_REFUSAL,
             "collisions without end: after t = %.10g bodies come to rest "
             "on each other, and no model here carries them on from there; "
             "spent: %.2g s",
             t->q->scene->time + (double)r->reached * t->q->every,
             t->c->spent);
}

bool task_gives_up(const struct task *t, const struct reference *f,
                   size_t *stood)
{
    const struct record *bad =
        f->coarser.end != MODELS_DONE ? &f->coarser : &f->run;
    const bool both = f->coarser.end == MODELS_BROKEN &&
                      f->run.end == MODELS_BROKEN &&
                      f->coarser.reached == f->run.reached;
    const bool stands = bad->end == MODELS_STANDSTILL;
    if (stands && bad->reached + 1 == *stood) {
        refuse_standstill(t, bad);
        return true;
    }
    *stood = stands ? bad->reached + 1 : 0;
    if (bad->end != MODELS_COSTLY && bad->end != MODELS_MEMORY &&
        !bad->why && !both)
        return false;
    task_refuse_plan(t, &bad->plan,
                     bad->end == MODELS_COSTLY ? NULL : task_ending(bad),
                     ", to compare others with,");
    return true;
}
