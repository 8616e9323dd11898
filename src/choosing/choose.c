/* Tries exact models first, then compares others with a reference. */
#include "choosing/choose.h"

#include "choosing/task.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Cost limit of a first attempt, s. */
static const double first_limit = 0.1;

/* Predicts the cost (in s) of one of two twins that were stopped at the
   cost limit. r is the slower twin; its cost is extrapolated from the rows
   that it has reached.

   If r has reached no row, the twins are run again over the first
   sixteenth of the first row, then over a sixteenth of that, and so on,
   until they reach a row. Returns INFINITY if they differ in such a
   shorter row. */
static double price_of_twin(const struct task *t, const struct record *r)
{
    double cost = r->cost, part = 1;
    size_t reached = r->reached;
    while (reached == 0 && cost < INFINITY && part < 1e9) {
        struct record a, b;
        struct record_setup o = task_setup(t, r->plan, 2 * first_limit);
        part *= 16;
        o.every /= part;
        o.rows = 16;
        cost = twins_run(t, o, &a, &b) ? INFINITY : b.cost;
        reached = b.reached;
        record_free(&a);
        record_free(&b);
    }
    return reached > 0 ? cost * part * (double)t->c->rows / (double)reached
                       : INFINITY;
}

/* Stores the result of an exact run a and its twin b in the candidate k.
   The result is the error of a if both runs are complete, or else a text:
   the runs differ, or the reason why one of them ended early. */
static void judge_twins(const struct task *t, struct choose_candidate *k,
                        struct record *a, struct record *b, bool parted)
{
    if (task_complete(t, a) && task_complete(t, b)) {
        const double error = twins_bound(t, a, b);
        t->c->rounding = error;
        task_consider(t, k, a, error);
        snprintf(k->text, sizeof k->text, "rounding %.1e", error);
    } else if (parted)
        task_explain(k, "its twin goes another way");
    else
        task_explain(k, task_ending(a->end != MODELS_DONE ? a : b));
}

/* Tries a model without time steps, which has only rounding errors.

   The first attempt has a small cost limit. If it exceeds this limit, and a
   full run may be within the budget, the model is run again. If an
   event-driven run and its twin differ, the motion is unpredictable from
   then on. If two runs of a formula differ, only the formula is
   inaccurate. */
static void try_exact(const struct task *t, const struct models_model *m)
{
    struct record a = {0}, b = {0};
    struct choose_candidate *k =
        task_candidate(t, (struct models_plan){.model = m});
    const char *why = models_refuse(&k->plan, t->q->scene);
    if (why) {
        task_explain(k, why);
        return;
    }
    const double limit = 2 * fmin(first_limit, task_best_cost(t));
    bool parted = twins_run(t, task_setup(t, k->plan, limit), &a, &b);
    if ((a.end == MODELS_COSTLY || b.end == MODELS_COSTLY) &&
        isinf(task_best_cost(t)) &&
        2 * price_of_twin(t, &b) <= task_budget(t)) {
        record_free(&a);
        record_free(&b);
        parted = twins_run(t, task_setup(t, k->plan, INFINITY), &a, &b);
    }
    judge_twins(t, k, &a, &b, parted);
    record_free(&a);
    record_free(&b);
}

static int by_price(const void *a, const void *b)
{
    const struct ladder *one = a, *other = b;
    return one->price < other->price ? -1 : one->price > other->price;
}

/* Adds a method to the list of ladders, and makes the first run of its
   ladder. A ladder is the series of a method's runs with finer and finer
   steps. The first run predicts the cost of a run within the tolerance.

   If the coarser reference run used this method, it serves as the first
   run, and the two reference runs show how the cost rises with finer steps.
   For adaptive methods the cost rises slowly: their order is about seven,
   so a tenth of the error needs only 40 % more steps. */
static void add_ladder(const struct task *t, struct ladder ladder[],
                       size_t *count, const struct models_model *m,
                       unsigned cuts)
{
    const struct models_plan p = {.model = m, .cuts = cuts, .steps = 1};
    struct choose_candidate *k = task_candidate(t, p);
    const char *why = models_refuse(&p, t->q->scene);
    if (why) {
        task_explain(k, why);
        return;
    }
    struct ladder *l = &ladder[(*count)++];
    *l = (struct ladder){.candidate = k,
                         .foot = rung_lowest(t, p),
                         .best.error = 1e300, /* no run yet */
                         .least = -INFINITY,
                         .most = INFINITY};
    l->rise = p.model->method->adaptive ? 1.0 / 7 : 1;
    const struct reference *f = t->f;
    if (p.model == f->coarser.plan.model && cuts == 0) {
        climb_note(t, l,
                   (struct choose_point){f->coarser.plan, f->seen,
                                         f->coarser.cost});
        l->rise =
            log2(f->run.cost / f->coarser.cost) /
            (rung_fineness(&f->run.plan) - rung_fineness(&f->coarser.plan));
    } else {
        /* The error of an adaptive method is at least ten times the
           tolerance of its steps, so finer steps must follow. The method
           can still win if this run costs at most a quarter of the best run
           so far. */
        const double may =
            l->rise < 1 ? task_best_cost(t) / 4 : task_best_cost(t);
        climb_note(t, l, rung_try(t, l, l->foot, may, k));
    }
    l->price = climb_price(t, l);
}

/* The simplifications with which leapfrog is tried. Other methods are tried
   without any, because the error of a simplification does not depend on the
   order of the method, and only leapfrog supports rods. */
static const unsigned left_out[] = {0, MODELS_NO_LIGHT, MODELS_RODS};
enum { LEFT_OUT = sizeof left_out / sizeof *left_out };

/* Adds the ladders of model m if it is a stepping method that the chooser
   compares, and if its kind (adaptive or not) is the requested one. */
static void add_model(const struct task *t, struct ladder ladder[],
                      size_t *count, const struct models_model *m,
                      bool adaptive)
{
    const unsigned possible = models_cuts(t->q->scene);
    if (!m->method || !m->method->raced || m->method->adaptive != adaptive)
        return;
    for (size_t j = 0; j < LEFT_OUT; ++j)
        if (!(left_out[j] & ~possible) &&
            (left_out[j] == 0 || stepping_is_leapfrog(m->method)))
            add_ladder(t, ladder, count, m, left_out[j]);
}

/* Tries all adaptive methods, or all methods with equal steps. Makes the
   run with the longest useful steps for each method first. Then tries finer
   steps, method by method, while a run may be cheaper than the best run so
   far. */
static void race(const struct task *t, bool adaptive)
{
    struct ladder ladder[STEPPING_MOST + LEFT_OUT];
    size_t count = 0;
    const struct models_plan *only = t->q->only;
    if (only && only->model->method->adaptive == adaptive)
        add_ladder(t, ladder, &count, only->model, only->cuts);
    for (const struct models_model *m = models_all(); !only && m->name; ++m)
        add_model(t, ladder, &count, m, adaptive);
    qsort(ladder, count, sizeof *ladder, by_price);
    for (size_t j = 0; j < count; ++j)
        climb(t, &ladder[j]);
}

/* Tries approximate models, and exact models with light bodies as test
   particles. */
static void try_approximate(const struct task *t)
{
    const unsigned light = models_cuts(t->q->scene) & MODELS_NO_LIGHT;
    for (const struct models_model *m = models_all(); m->name; ++m) {
        const struct models_plan plan = {
            .model = m, .cuts = m->approximate ? 0 : light};
        if (m->family != MODELS_STEPS && !t->q->only &&
            (m->approximate || light) && !models_refuse(&plan, t->q->scene))
            rung_try(t, NULL, plan, task_budget(t),
                     task_candidate(t, plan));
    }
}

/* Tries only the requested plan. If its error exceeds the tolerance, the
   refusal states that error. */
static void try_only(const struct task *t)
{
    const struct models_plan *only = t->q->only;
    struct choose_candidate *k = task_candidate(t, *only);
    char plan[MODELS_TEXT];
    const struct choose_point seen =
        rung_try(t, NULL, *only, task_budget(t), k);
    models_write(only, plan);
    if (!k->holds && isfinite(seen.error))
        snprintf(t->c->refusal, CHOOSE_REFUSAL,
                 "%s is off by %.3g of the scale, more than %.3g", plan,
                 seen.error, t->q->tolerance);
    else if (!k->holds)
        task_refuse_plan(t, only, isinf(seen.cost) ? NULL : k->text, "");
}

/* Tries all candidates that need a reference: simplified models, the
   coarser run of the reference, and the methods. */
static void compare(const struct task *t)
{
    struct reference *f = t->f;
    const struct models_plan *only = t->q->only;
    t->c->reference = f->run.plan;
    t->c->doubt = f->doubt;
    if (only && (only->model->family != MODELS_STEPS || only->steps > 0)) {
        try_only(t);
        return;
    }
    try_approximate(t);
    if (!only || (only->model == f->coarser.plan.model && !only->cuts))
        task_consider(t, task_candidate(t, f->coarser.plan), &f->coarser,
                      f->twins > 0 ? f->seen + f->doubt
                      : f->doubt > negligible * t->q->tolerance
                          ? last_margin * f->doubt
                          : (1 + negligible) * f->doubt);
    race(t, false);
    race(t, true);
}

/* If two reference runs differ by less than tolerance/seldom, no further
   test is needed. If their errors were as large as the tolerance, they
   would agree so well only once in pi/2 * seldom = 630 cases (the
   probability P_1 for one twin in the book). This is about as rare as a
   wrong result of is_near_floor. */
static const double seldom = 400;

/* Returns whether a twin of the chosen run differs from it by more than a
   300th of the tolerance. If not, rounding errors are taken to be below the
   tolerance.

   If they were not, there would be two coincidences. The probability of so
   small a difference from the twin is less than 1/100. The probability that
   the two references agree to a twentieth of the tolerance is 1/12. Both
   together are rare enough. */
static bool is_near_floor(const struct task *t)
{
    struct record twin;
    struct record_setup o = task_setup(t, t->c->run.plan, INFINITY);
    o.twin = 1;
    task_run(t, &twin, &o);
    const double far = task_difference(t, &t->c->run, &twin);
    record_free(&twin);
    return 300 * far > t->q->tolerance;
}

/* Compares all candidates with the reference. If rounding errors may be
   near the tolerance, runs more twins of the reference to obtain a safer,
   larger bound on its error. If the chosen run is outside the tolerance
   with this bound, compares all candidates again. */
static void compare_surely(const struct task *t)
{
    struct choose_choice *c = t->c;
    struct reference *f = t->f;
    const size_t candidates = c->candidates, points = c->points;
    compare(t);
    if (!c->run.value || f->twins > 0 ||
        seldom * f->seen <= t->q->tolerance || !is_near_floor(t))
        return;
    const bool sure = reference_ask_twins(t, f, roughly * t->q->tolerance);
    const double error = rung_error(t, &c->run);
    c->doubt = f->doubt;
    if (sure && error <= t->q->tolerance) {
        c->candidate[c->taken].error = error;
        return;
    }
    record_free(&c->run);
    if (!sure)
        return;
    c->candidates = candidates;
    c->points = points;
    if (!f->coarser.value) { /* rows were moved to the answer and freed */
        const struct record_setup o =
            task_setup(t, f->coarser.plan, INFINITY);
        task_run(t, &f->coarser, &o);
    }
    compare(t);
}

/* Finds the answer. Exact models are tried first, as they need no
   reference. An exact run within the tolerance is chosen at once: the
   search for a cheaper run would cost more than it could save. If an exact
   model finds that the motion becomes unpredictable, no model with steps is
   tried in a scene with only collisions. */
static void decide(const struct task *t)
{
    const struct models_plan *only = t->q->only;
    for (const struct models_model *m = models_all(); m->name; ++m)
        if (m->family != MODELS_STEPS && !m->approximate &&
            (!only || (only->model == m && !only->cuts)))
            try_exact(t, m);
    const struct models_acts *a = &t->c->acts;
    const bool falls = a->gravity || a->springs || a->weight || a->friction;
    if (t->c->run.value && t->c->horizon < INFINITY &&
        t->c->run.plan.model->family == MODELS_EVENTS)
        record_free(&t->c->run); /* another model has found the motion
                                    unpredictable */
    if (!t->c->run.value && (t->c->horizon == INFINITY || falls) &&
        task_budget(t) > 0 && reference_find(t, t->f))
        compare_surely(t);
}

/* Marks the answer as refused, and writes a reason unless there is one. */
static void refuse(const struct task *t)
{
    struct choose_choice *c = t->c;
    c->taken = c->candidates;
    if (c->refusal[0] != '\0')
        return;
    if (c->horizon < INFINITY)
        snprintf(
            c->refusal, sizeof c->refusal,
            "horizon: after t = %.10g rounding%s decides by more than %.3g "
            "what happens; spent: %.2g s",
            c->horizon,
            c->acts.contact ? " or the order of collisions at one moment"
                            : "",
            t->q->tolerance, c->spent);
    else if (task_budget(t) < 0.1 * t->q->budget)
        snprintf(
            c->refusal, sizeof c->refusal,
            "beyond reason: no run and its proof cost less than %.3g s "
            "by the price list; spent: %.2g s",
            t->q->budget, c->spent);
    else
        snprintf(c->refusal, sizeof c->refusal,
                 "no model holds %.3g; spent: %.2g s by the price list",
                 t->q->tolerance, c->spent);
}

/* Returns whether bodies overlap at the start by more than the tolerance.
   If so, writes a refusal, since the motion would depend on the time
   step. */
static bool overlaps(const struct task *t)
{
    const double depth = spheres_depth(t->q->scene);
    if (!(depth > t->q->tolerance * t->view->length))
        return false;
    snprintf(t->c->refusal, sizeof t->c->refusal,
             "at the start bodies overlap, or are outside of a wall, by "
             "%.3g, and what comes of that depends on the step; expected "
             "bodies that at most touch",
             depth);
    return true;
}

/* Largest number of bodies for which all distances are computed. With more
   bodies this would take longer than finding the answer. */
enum { PAIRS_MOST = 2000 };

/* Records the closest pair of bodies if their distance is below the
   tolerance only because a distant body makes the scale so large. */
static void look_for_hidden(const struct task *t)
{
    const struct scene *s = t->q->scene;
    struct choose_hidden h = {.distance = INFINITY};
    for (size_t i = 0; i < s->bodies && s->bodies <= PAIRS_MOST; ++i)
        for (size_t j = 0; j < i; ++j) {
            const double d = sqrt(models_square(s, i, j));
            if (d > 0 && d < h.distance)
                h = (struct choose_hidden){.a = i, .b = j, .distance = d};
        }
    h.without = record_scale_without(s, &h.far);
    if (h.distance < t->q->tolerance * t->view->length &&
        h.without < t->view->length / 10)
        t->c->hidden = h;
}

bool choose(struct choose_choice *c, const struct choose_request *q)
{
    struct record_view view;
    struct reference f = {0};
    const double length = q->until - q->scene->time;
    *c = (struct choose_choice){.horizon = INFINITY};
    if (!record_view_create(&view, q->program, q->scene, q->asked, length))
        return false;
    const struct task t = {q, &view, &f, c};
    c->rows = (size_t)(length / q->every + 0.5);
    c->columns = view.columns;
    c->scale = view.scale;
    c->judged = view.judged;
    models_analyse(&c->acts, q->scene);
    if (strcmp(c->judged, "positions") == 0)
        look_for_hidden(&t);
    if (!overlaps(&t))
        decide(&t);
    if (!c->run.value)
        refuse(&t);
    record_free(&f.run);
    record_free(&f.coarser);
    record_view_free(&view);
    return true;
}

void choose_free(struct choose_choice *c)
{
    record_free(&c->run);
    *c = (struct choose_choice){0};
}

/* Words for the orders of methods with equal steps, which are at most
   eight. */
static const char *const order_in_words[] = {"",      "first",   "second",
                                             "third", "fourth",  "fifth",
                                             "sixth", "seventh", "eighth"};

/* Returns the cheapest candidate that costs more than the chosen run, and
   sets *price to its actual or predicted cost. */
static const struct choose_candidate *next_best(
    const struct choose_choice *c, double *price)
{
    const struct choose_candidate *best = NULL;
    *price = INFINITY;
    for (size_t j = 0; j < c->candidates; ++j) {
        const struct choose_candidate *k = &c->candidate[j];
        const double is = k->holds ? k->cost : k->foreseen;
        if (j != c->taken && is < *price && is > c->run.cost) {
            *price = is;
            best = k;
        }
    }
    return best;
}

void choose_sentence(const struct choose_choice *c, double tolerance,
                     char text[CHOOSE_SENTENCE])
{
    const struct models_plan *p = &c->run.plan;
    const struct stepping_method *m = p->model->method;
    char plan[MODELS_TEXT];
    double price;
    models_write(p, plan);
    const int used =
        !m ? snprintf(text, CHOOSE_SENTENCE, "%s: %s", plan,
                      p->model->about)
        : m->adaptive
            ? snprintf(text, CHOOSE_SENTENCE,
                       "%s: steps of its own length meet %g", plan,
                       tolerance)
            : snprintf(text, CHOOSE_SENTENCE,
                       "%s: its %s order meets %g at %llu step%s a row",
                       plan, order_in_words[m->order], tolerance,
                       (unsigned long long)p->steps,
                       p->steps == 1 ? "" : "s");
    const struct choose_candidate *other = next_best(c, &price);
    if (!other)
        return;
    const double ratio = price / c->run.cost;
    struct models_plan way = other->plan;
    char times[40] = "";
    way.steps = 0;
    way.tolerance = 0;
    models_write(&way, plan);
    if (ratio > 1000)
        snprintf(times, sizeof times, "over a thousand times ");
    else if (ratio > 1.05)
        snprintf(times, sizeof times,
                 ratio < 99 ? "%.2g times " : "%.0f times ", ratio);
    snprintf(text + used, CHOOSE_SENTENCE - (size_t)used,
             other->holds ? "; %s would cost %sas much"
                          : "; by its order %s would cost %sas much",
             plan, times);
}
