/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 1598700641 of the lines below */
/* Tries finer and finer steps of one method while these may be cheaper. */
#include "choosing/task.h"

#include <math.h>

static const double lost = 0.1; /* fraction of the scale; a run with a
                                   larger error is useless */

static bool is_lost(double error)
{
    return error > lost;
}

/* Returns whether finer steps have not reduced the error. `error` is the
   error of the newest run, and l->best is the run before it. */
static bool is_vain(const struct ladder *l, double error)
{
    const double before = l->best.error;
    return isinf(error) ? isinf(before)
                        : l->foot.cuts && !is_lost(error) &&
                              fabs(error - before) < 0.01 * error;
}

/* Returns whether the last error is too large for an extrapolation, so that
   much finer steps are tried next. In a simplified scene no finite error is
   too large, as it may be due to the simplification. */
static bool is_blind(const struct ladder *l)
{
    const double error = l->best.error;
    return isinf(error) || (is_lost(error) && !l->foot.cuts);
}

void climb_note(const struct task *t, struct ladder *l,
                struct choose_point r)
{
    const double fine = rung_fineness(&r.plan), e = t->q->tolerance;
    const bool holds = r.error <= e;
    if (!holds && is_vain(l, r.error))
        l->most = -INFINITY; /* finer steps do not help */
    if (isinf(r.cost) || holds)
        l->most = fmin(l->most, fine);
    else
        l->least = fmax(l->least, fine);
    if (isfinite(r.cost) && (holds || !(l->best.error <= e)))
        l->best = r;
}

static double order_of_method(const struct ladder *l)
{
    const struct stepping_method *m = l->foot.model->method;
    return m->adaptive ? 1 : m->order;
}

/* Returns log2 of the ratio of the last error to the tolerance, or INFINITY
   if the error is unknown. */
static double excess(const struct task *t, const struct ladder *l)
{
    return log2(l->best.error / t->q->tolerance);
}

/* Returns the predicted cost (in s) of a run whose steps are finer by the
   factor 2^more. */
static double price_of(const struct ladder *l, double more)
{
    return l->best.cost * exp2(l->rise * more);
}
enum { FAR = 4 };

static double octaves_up(const struct task *t, const struct ladder *l)
{
    const double more =
        is_blind(l) ? 1 / l->rise : excess(t, l) / order_of_method(l);
    return fmin(more, FAR);
}

/* Returns the cost (in s) of a run of this ladder within the tolerance, as
   predicted from its first run. */
double climb_price(const struct task *t, const struct ladder *l)
{
    return l->best.plan.model ? price_of(l, fmax(octaves_up(t, l), -FAR))
                              : INFINITY;
}

/* Returns the next plan of the ladder that is worth a run. Its model is
   NULL if there is none. */
static struct models_plan next_rung(const struct task *t,
                                    const struct ladder *l)
{
    const double one = 0.125; /* typical difference in fineness of plans */
    const double may = fmin(0.98 * task_best_cost(t), task_budget(t));
    const double now = rung_fineness(&l->best.plan);
    const double more = octaves_up(t, l);
    const double dear = log2(may / l->best.cost) / l->rise - one;
    const double want =
        now + more > l->least ? now + more : (l->least + l->most) / 2;
    const double go = fmax(fmin(want, now + dear), l->least + one / 2);
    struct models_plan next = rung_at(l->foot, go);
    const double far = excess(t, l), order = order_of_method(l);
    const double highest = l->foot.model->method->orbits ? 8 : 1.2 * order;
    const double nearest = fmin(far, log2(lost / t->q->tolerance)) /
                           (far > 0 || l->rise < 1 ? highest : order);
    if (!l->best.plan.model || !(rung_fineness(&next) < l->most) ||
        (l->best.error <= 1 && !(price_of(l, nearest) < may)) ||
        !(price_of(l, rung_fineness(&next) - now) < may))
        next.model = NULL;
    return next;
}

/* Stores the predicted cost of a run within the tolerance, if the last
   error is small enough for a prediction. Also stores why no such run was
   made, unless the last run has already stored a reason. */
static void foresee(const struct task *t, const struct ladder *l)
{
    struct choose_candidate *k = l->candidate;
    const bool vain = l->most == -INFINITY;
    const bool unknown = is_lost(l->best.error);
    if (l->best.plan.model && !vain && !unknown)
        k->foreseen = price_of(l, excess(t, l) / order_of_method(l));
    if (k->text[0] == '\0')
        task_explain(k, vain      ? "finer steps are no help"
                        : unknown ? "too far off to go on"
                                  : "by its order too expensive");
}

void climb(const struct task *t, struct ladder *l)
{
    struct models_plan next;
    while ((next = next_rung(t, l)).model)
        climb_note(t, l,
                   rung_try(t, l, next, task_best_cost(t), l->candidate));
    if (!l->candidate->holds)
        foresee(t, l);
}
