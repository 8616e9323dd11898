/* Runs plans with numbers of steps, or tolerances, from a fixed list. */
#include "choosing/task.h"

#include <math.h>
#include <stdint.h>

/* Returns plan n of a method, n >= 1, from a fixed list. Similar requests
   thus get equal plans. The numbers of steps are 1 to 16, 18, 20 ... 32,
   36 ..., that is, eight per factor of two. The tolerances of an adaptive
   method are 1, 0.5, 0.2, 0.1 ... */
static struct models_plan nth_rung(struct models_plan p, int n)
{
    static const double digit[] = {0.2, 1, 0.5};
    /* Division by a power of ten gives the double nearest to the decimal
       number; repeated multiplication by 0.1 does not. */
    double power = 1;
    for (int k = 1; k <= (n - 1) / 3 && p.model->method->adaptive; ++k)
        power *= 10;
    if (p.model->method->adaptive)
        p.tolerance = digit[n % 3] / power;
    else
        p.steps =
            n < 8 ? (uint64_t)n : (uint64_t)(8 + n % 8) << (n / 8 - 1);
    return p;
}

double rung_fineness(const struct models_plan *p)
{
    return p->tolerance > 0 ? -log2(p->tolerance) : log2((double)p->steps);
}

struct models_plan rung_at(struct models_plan p, double fine)
{
    const int most = p.model->method->adaptive ? 46 : 400;
    int n = 1;
    for (p = nth_rung(p, n); n < most && rung_fineness(&p) < fine - 1e-9;)
        p = nth_rung(p, ++n);
    return p;
}

struct models_plan rung_lowest(const struct task *t, struct models_plan p)
{
    const double limit = p.model->method->limit;
    const double bears = limit > 0 ? fmin(0.6 * limit, 2) : 1;
    const double rate = models_rate(t->q->scene, p.cuts);
    return rung_at(p, p.model->method->adaptive
                          ? -log2(fmin(t->q->tolerance, 1e-4))
                          : log2(t->q->every * rate / bears));
}

double rung_error(const struct task *t, const struct record *r)
{
    return task_difference(t, r, &t->f->run) + t->f->doubt;
}

/* Returns the error of the plan with the next larger number of steps. Runs
   this plan, unless it is the best run of the ladder. */
static double error_of_finer(const struct task *t, const struct ladder *l,
                             const struct models_plan *p)
{
    struct record r;
    struct record_setup o = task_setup(t, *p, INFINITY);
    o.plan = rung_at(o.plan, rung_fineness(p) + 0.05);
    if (l->best.plan.steps == o.plan.steps)
        return l->best.error;
    task_run(t, &r, &o);
    const double error = rung_error(t, &r);
    record_free(&r);
    return error;
}

/* Runs the plan with the next smaller number of steps into *r and returns
   its error. Returns INFINITY without a run if that plan is known to fail,
   or if p has at most 8 steps: smaller numbers are then too far apart. */
static double error_of_coarser(const struct task *t, const struct ladder *l,
                               const struct models_plan *p,
                               struct record *r)
{
    struct record_setup o = task_setup(t, *p, INFINITY);
    o.plan = rung_at(o.plan, rung_fineness(p) - 0.19);
    if (o.plan.steps == p->steps || rung_fineness(&o.plan) <= l->least)
        return INFINITY;
    task_run(t, r, &o);
    return rung_error(t, r);
}

/* Tests whether a run is within the tolerance only by chance: with one more
   step, its error might be ten times as large. So a run with the next
   larger or smaller number of steps must be within the tolerance, too.

   If the run with more steps passes, *r is kept. If only the run with fewer
   steps passes, it replaces *r, as it is cheaper. If neither passes, *r
   gets the error of the run with more steps. Adaptive methods need no such
   test, as all their steps change with the tolerance. */
static void ask_neighbours(const struct task *t, const struct ladder *l,
                           struct record *r, struct choose_point *seen)
{
    const double e = t->q->tolerance;
    const double finer = error_of_finer(t, l, &r->plan);
    struct record other = {0};
    if (finer <= e)
        return;
    const double coarser = error_of_coarser(t, l, &r->plan, &other);
    seen->error = coarser <= e ? coarser : finer;
    if (!(coarser <= e)) {
        record_free(&other);
        return;
    }
    record_free(r);
    *r = other;
    seen->plan.steps = r->plan.steps;
    seen->cost = r->cost;
}

struct choose_point rung_try(const struct task *t, const struct ladder *l,
                             struct models_plan plan, double limit,
                             struct choose_candidate *k)
{
    struct record r;
    struct choose_point seen = {plan, INFINITY, INFINITY};
    const struct record_setup o = task_setup(t, plan, limit);
    task_run(t, &r, &o);
    if (r.end != MODELS_COSTLY)
        seen.cost = r.cost;
    if (task_complete(t, &r)) {
        seen.error = rung_error(t, &r);
        if (l && plan.tolerance == 0 && r.cost < task_best_cost(t) &&
            seen.error <= t->q->tolerance)
            ask_neighbours(t, l, &r, &seen);
        task_consider(t, k, &r, seen.error);
    } else if (!k->holds)
        task_explain(k, task_ending(&r));
    record_free(&r);
    return seen;
}
