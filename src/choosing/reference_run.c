/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 3196782259 of the lines below */
/* Finds a reference run, which agrees with a run with coarser steps. */
#include "choosing/task.h"

#include <math.h>

static struct models_plan finer(struct models_plan p)
{
    return rung_at(p, rung_fineness(&p) + log2(100));
}

/* Makes two runs side by side, the second with finer steps and in other
   units, until they differ by more than the tolerance. */
static void run_pair(const struct task *t, struct reference *f,
                     struct models_plan plan)
{
    const struct record_setup a = task_setup(t, plan, INFINITY);
    struct record_setup b = task_setup(t, finer(plan), INFINITY);
    b.twin = 1;
    b.plan.slack = 0.2; /* no step of one run equals one of the other */
    record_both(&f->coarser, &f->run, t->view, &a, &b, t->q->tolerance);
    task_bill(t, &f->coarser);
    task_bill(t, &f->run);
}

/* Returns whether the two runs roughly agree on the gap of the narrowest
   miss, or on the overlap of the shallowest contact. */
static bool is_decided(const struct reference *f)
{
    const double a = f->coarser.least, b = f->run.least;
    return 2 * fabs(a - b) < fmin(fabs(a), fabs(b));
}

/* Repeats the finer run in other units until these twins bound its error by
   `want`. Returns whether the bound is at most half of the tolerance. */
bool reference_ask_twins(const struct task *t, struct reference *f,
                         double want)
{
    const double most = t->q->tolerance / last_margin;
    double far = f->doubt;
    unsigned k = 1;
    while (k < TWINS && last_margin * far <= most &&
           twins_margin[k - 1] * far > want)
        far = fmax(far, twins_add(t, &f->run, f->run.twin + k++,
                                  most / last_margin));
    const bool lost = last_margin * far > most;
    f->twins = k;
    f->doubt = (lost ? last_margin : twins_margin[k - 1]) * far;
    return f->doubt <= most;
}
static void ask_balls(const struct task *t, struct reference *f)
{
    const double hair = 0x1p-40 * t->view->length;
    const double most = t->q->tolerance / last_margin / last_margin;
    struct record_setup o = task_setup(t, f->run.plan, INFINITY);
    for (int side = -1; side <= 1 && !is_decided(f); side += 2) {
        struct record third;
        o.grow = side * fmax(2 * fabs(f->run.least), hair);
        task_run(t, &third, &o);
        f->doubt = fmax(f->doubt, task_difference(t, &third, &f->run));
        f->doubt = fmax(f->doubt, task_difference(t, &third, &f->coarser));
        task_note_parting(t, &third, &f->run, most);
        task_note_parting(t, &third, &f->coarser, most);
        record_free(&third);
    }
}

/* Returns whether the error of the reference is below half of the
   tolerance, although no finer run is possible. */
static bool is_sure(const struct task *t, struct reference *f)
{
    if (f->doubt <= t->q->tolerance / last_margin)
        ask_balls(t, f);
    if (reference_ask_twins(t, f, roughly * t->q->tolerance))
        return true;
    task_note_parting(t, &f->coarser, &f->run,
                      t->q->tolerance / last_margin / last_margin);
    return false;
}

/* Makes pairs of runs with finer and finer steps until a pair agrees.
   Returns false if none agrees. */
static bool find_adaptive(const struct task *t, struct reference *f)
{
    struct models_plan plan = {.model = models_find("radau15"), .steps = 1};
    size_t stood = 0; /* 0, or 1 + rows before the last standstill */
    plan = rung_at(plan, -log2(task_first_tolerance(t)));
    for (;; plan = finer(plan)) {
        run_pair(t, f, plan);
        if (task_gives_up(t, f, &stood))
            return false;
        f->doubt = f->seen = task_difference(t, &f->coarser, &f->run);
        if (f->doubt <= negligible * t->q->tolerance && is_decided(f))
            return true;
        if (f->run.plan.tolerance < 2e-15)
            return is_sure(t, f);
        record_free(&f->coarser);
        record_free(&f->run);
    }
}

/* Runs one method with finer and finer steps until two successive runs
   agree. Returns false if they do not agree even with the finest steps. The
   numbers of steps of successive runs, n and 2n + 1, have no common
   divisor. */
static bool find_even(const struct task *t, struct reference *f,
                      const char *name)
{
    struct models_plan p = {.model = models_find(name), .steps = 1};
    p = rung_lowest(t, p);
    for (int level = 0; level < 4; ++level) {
        const struct record_setup o = task_setup(t, p, INFINITY);
        record_free(&f->coarser);
        f->coarser = f->run;
        task_run(t, &f->run, &o);
        p.steps = 2 * p.steps + 1;
        f->doubt = f->seen = task_difference(t, &f->coarser, &f->run);
        const double far = f->doubt / (roughly * t->q->tolerance);
        if (far <= 1)
            return true;
        if (level > 0 && !(far < exp2(2 * p.model->method->order)))
            break;
    }
    record_free(&f->coarser);
    record_free(&f->run);
    return false;
}

bool reference_find(const struct task *t, struct reference *f)
{
    if (!t->c->acts.gravity && !t->q->scene->contact &&
        (find_even(t, f, "leapfrog") || find_even(t, f, "kahan-li8")))
        return true;
    return find_adaptive(t, f);
}
