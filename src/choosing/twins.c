/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 1123523642 of the lines below */
/* Bounds the rounding errors of a run by repeating it in other units. */
#include "choosing/task.h"

#include <math.h>

/* Runs a plan and its twin side by side. Returns whether they differ. */
bool twins_run(const struct task *t, struct record_setup one,
               struct record *a, struct record *b)
{
    const double most = t->q->tolerance / last_margin;
    struct record_setup other = one;
    other.twin = 2;
    record_both(a, b, t->view, &one, &other, most);
    task_bill(t, a);
    task_bill(t, b);
    const size_t held = record_agree(t->view, a, b, most);
    const bool parted = held < a->reached && held < b->reached;
    if (parted && one.plan.model->family == MODELS_EVENTS)
        task_note_horizon(t, held, one.every);
    return parted;
}

const double twins_margin[TWINS] = {4800, 43, 9.2, 4.3, 2.7, 2};
/* Runs another twin and returns how far it differs from the run. If `most`
   is positive, records the time at which the difference first exceeds
   `most`: the horizon. */
double twins_add(const struct task *t, const struct record *r,
                 unsigned number, double most)
{
    struct record twin;
    struct record_setup o = task_setup(t, r->plan, INFINITY);
    o.twin = number;
    task_run(t, &twin, &o);
    const double far = task_difference(t, r, &twin);
    if (most > 0)
        task_note_parting(t, r, &twin, most);
    record_free(&twin);
    return far;
}
/* Returns the error that an error of time causes in a run. All twins share
   this error, so they do not reveal it (12.11, eq:choose-slip). */
static double error_of_clock(const struct task *t, const struct record *r)
{
    const double late_by = 0x1p-40;
    struct record late;
    struct record_setup o = task_setup(t, r->plan, INFINITY);
    o.every *= 1 + late_by;
    if (r->clock == 0)
        return 0;
    task_run(t, &late, &o);
    const double by = r->clock / late_by * task_difference(t, r, &late);
    record_free(&late);
    return by;
}
static const double trifle = 1e-3; /* cost that is not worth saving, s */

/* Returns a bound on the error of run a; a and its twin b are complete. */
double twins_bound(const struct task *t, const struct record *a,
                   const struct record *b)
{
    const double e = t->q->tolerance, late = error_of_clock(t, a);
    const bool events = a->plan.model->family == MODELS_EVENTS;
    const bool cheap = TWINS * a->cost <= trifle;
    double far = task_difference(t, a, b);
    unsigned k = 1;
    while (k < TWINS && last_margin * far + late <= e &&
           (cheap || twins_margin[k - 1] * far + late > e))
        far = fmax(far, twins_add(t, a, b->twin + k++,
                                  events ? e / last_margin : 0));
    const bool lost = last_margin * far + late > e;
    return (lost ? last_margin : twins_margin[k - 1]) * far + late;
}
