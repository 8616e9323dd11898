/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 1876602827 of the lines below */
/* Exact ways, two runs that agree, and ladders judged by them. */
#include "enough/choose.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is asked, and by what it is judged. */
struct task {
    const struct choose_request *q;
    struct record_view *view;
    struct reference *f;     /* which stands when candidates are tried */
    struct choose_choice *c; /* where what was seen is written down */
};

/* What is left to be spent, s by the price list. */
static double left_of(const struct task *t)
{
    return fmax(t->q->reason - t->c->spent, 0);
}

static double first_tolerance(const struct task *t)
{
    return fmax(1e-8, fmin(1e-3, pow(t->q->tolerance, 2.0 / 3)));
}

static const double share = 0.05; /* of e: that is nothing */

static struct record_order order_of(const struct task *t,
                                    struct models_plan plan, double limit)
{
    const double less = fmin(plan.tolerance / first_tolerance(t), 1);
    plan.little = share * t->q->tolerance * t->view->length * less;
    plan.left = (double)t->c->rows * t->q->every;
    plan.afford = fmax(left_of(t) / 2, 1e-9); /* a twin needs it, too */
    plan.margin =
        plan.tolerance > 0 ? t->q->tolerance * t->view->length : 0;
    return (struct record_order){.scene = t->q->scene,
                                 .plan = plan,
                                 .every = t->q->every,
                                 .rows = t->c->rows,
                                 .limit = fmin(limit, left_of(t))};
}

/* Adds a run to the bill. */
static void pay(const struct task *t, const struct record *r)
{
    t->c->spent += r->cost;
    if (t->q->watch)
        t->q->watch(t->q->with, t->c->spent);
}

static void run(const struct task *t, struct record *r,
                const struct record_order *o)
{
    record_run(r, t->view, o);
    pay(t, r);
}

static bool whole(const struct task *t, const struct record *r)
{
    return r->end == MODELS_DONE && r->reached == t->c->rows;
}

static double apart(const struct task *t, const struct record *a,
                    const struct record *b)
{
    return record_apart(t->view, a, b, 1, t->c->rows);
}

/* The candidate of a model and its cuts, a new one if there is none. */
static struct choose_candidate *enter(const struct task *t,
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

static void say(struct choose_candidate *c, const char *text)
{
    snprintf(c->text, sizeof c->text, "%s", text);
}

static const char *ending(const struct record *r)
{
    return r->why                        ? r->why
           : r->end == MODELS_STANDSTILL ? "collisions without end"
           : r->end == MODELS_COSTLY     ? "more expensive than the best"
           : r->end == MODELS_MEMORY     ? "no memory"
           : r->end == MODELS_BROKEN     ? "breaks down"
                                         : "";
}

/* The cost to beat, s by the price list. */
static double best(const struct task *t)
{
    return t->c->run.value ? t->c->run.cost : INFINITY;
}

/* Writes down a run whose error was seen. It is kept if it holds and is the
   cheapest so far: *r is then empty. */
static void offer(const struct task *t, struct choose_candidate *k,
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
    if (!holds || !(r->cost < best(t)))
        return;
    record_free(&c->run);
    c->run = *r;
    r->value = NULL;
    c->taken = (size_t)(k - c->candidate);
}

/* By what the largest distance of a run from k of its twins is multiplied
   to bound the error of the run. A run is off by X and twin i by X_i. All
   are sums of many roundings, each carried by the scene to the same place:
   draws of one bell curve about the truth, with the density p. Only the
   distances |X_i - X| are seen. With the factor f they mislead if each is
   less than |X|/f, which happens by chance if all twins err as the run
   does. Each of them does so with the chance 2 |X|/f p(X), to the first
   order in 1/f, so together the chance is P_k(f) = 2 Int_0^inf p(x) (2 x
   p(x)/f)^k dx = (2/f)^k Gamma((k + 1)/2) (pi (k + 1))^(-(k + 1)/2), which
   for one twin is 1/(pi f): the factor of two leaves 16 % of promises
   broken if the tolerance is as small as the bound, and a thousand would be
   needed. With six twins P_6(2) = 6.7e-5, and the factors for fewer leave
   the same chance. They are used in turn, until one holds, so that a
   tolerance may meet each of the six: drawn at random, the worst one (0.8
   times the spread of X) is broken once in 10 000. An error that comes in
   several directions is harder to miss; one that all runs share is not
   seen. */
static const double margin[] = {4800, 43, 9.2, 4.3, 2.7, 2};
enum { TWINS = sizeof margin / sizeof *margin };
static const double doubled = 2;    /* the last of them, and the least */
static const double trifle = 1e-3;  /* s: not worth being saved */
static const double patience = 0.1; /* s: a run that may be in vain */

/* So many rows held, and from there on it is the scene that parts runs. */
static void note_horizon(const struct task *t, size_t held, double every)
{
    const double until = t->q->scene->time + (double)held * every;
    t->c->horizon = fmin(t->c->horizon, until);
}

/* What clocks do that are late alike in all units: (12.11,
   eq:choose-slip). */
static double slip(const struct task *t, const struct record *r)
{
    const double late_by = 0x1p-40;
    struct record late;
    struct record_order o = order_of(t, r->plan, INFINITY);
    o.every *= 1 + late_by;
    if (r->clock == 0)
        return 0;
    run(t, &late, &o);
    const double by = r->clock / late_by * apart(t, r, &late);
    record_free(&late);
    return by;
}

/* A run and its twin, side by side until they part, if they do. */
static bool run_twins(const struct task *t, struct record_order one,
                      struct record *a, struct record *b)
{
    struct record_order other = one;
    other.twin = 2;
    record_both(a, b, t->view, &one, &other, t->q->tolerance / doubled);
    pay(t, a);
    pay(t, b);
    const size_t held =
        record_agree(t->view, a, b, t->q->tolerance / doubled);
    const bool parted = held < a->reached && held < b->reached;
    if (parted && one.plan.model->family == MODELS_EVENTS)
        note_horizon(t, held, one.every);
    return parted;
}

/* Twins have been stopped by our patience, the second in r: what would one
   of them cost, s? INFINITY: they part in the first row. */
static double price_of_twin(const struct task *t, const struct record *r)
{
    double cost = r->cost, part = 1;
    size_t reached = r->reached;
    while (reached == 0 && cost < INFINITY && part < 1e9) {
        struct record a, b;
        struct record_order o = order_of(t, r->plan, 2 * patience);
        part *= 16;
        o.every /= part;
        o.rows = 16;
        cost = run_twins(t, o, &a, &b) ? INFINITY : b.cost;
        reached = b.reached;
        record_free(&a);
        record_free(&b);
    }
    return reached > 0 ? cost * part * (double)t->c->rows / (double)reached
                       : INFINITY;
}

/* The first few rows may hold of a run that parts from another one. */
static void note_parting(const struct task *t, const struct record *a,
                         const struct record *b, double most)
{
    const size_t held = record_agree(t->view, a, b, most);
    if (held < a->reached && held < b->reached)
        note_horizon(t, held, t->q->every);
}

/* How far a run may be off that is whole, like its first twin b. Further
   twins are asked if the tolerance is met or missed by the number of twins,
   or if all of them cost next to nothing. */
static double bound_by_twins(const struct task *t, const struct record *a,
                             const struct record *b)
{
    const double e = t->q->tolerance, late = slip(t, a);
    const bool cheap = TWINS * a->cost <= trifle;
    double far = apart(t, a, b);
    unsigned k = 1;
    while (k < TWINS && doubled * far + late <= e &&
           (cheap || margin[k - 1] * far + late > e)) {
        struct record twin;
        struct record_order o = order_of(t, a->plan, INFINITY);
        o.twin = b->twin + k++;
        run(t, &twin, &o);
        far = fmax(far, apart(t, a, &twin));
        if (a->plan.model->family == MODELS_EVENTS)
            note_parting(t, a, &twin, e / doubled);
        record_free(&twin);
    }
    const bool lost = doubled * far + late > e;
    return (lost ? doubled : margin[k - 1]) * far + late;
}

static void judge_twins(const struct task *t, struct choose_candidate *k,
                        struct record *a, struct record *b, bool parted)
{
    if (whole(t, a) && whole(t, b)) {
        const double error = bound_by_twins(t, a, b);
        t->c->rounding = error;
        offer(t, k, a, error);
        snprintf(k->text, sizeof k->text, "rounding %.1e", error);
    } else if (parted)
        say(k, "its twin goes another way");
    else
        say(k, ending(a->end != MODELS_DONE ? a : b));
}

/* A model without steps, whose only error is what last bits do to it. */
static void try_exact(const struct task *t, const struct models_model *m)
{
    struct record a = {0}, b = {0};
    struct choose_candidate *k = enter(t, (struct models_plan){.model = m});
    const char *why = models_refuse(&k->plan, t->q->scene);
    if (why) {
        say(k, why);
        return;
    }
    const double limit = 2 * fmin(patience, best(t));
    bool parted = run_twins(t, order_of(t, k->plan, limit), &a, &b);
    if ((a.end == MODELS_COSTLY || b.end == MODELS_COSTLY) &&
        isinf(best(t)) && 2 * price_of_twin(t, &b) <= left_of(t)) {
        record_free(&a);
        record_free(&b);
        parted = run_twins(t, order_of(t, k->plan, INFINITY), &a, &b);
    }
    judge_twins(t, k, &a, &b, parted);
    record_free(&a);
    record_free(&b);
}

/* Rung n of a method, from 1 on: eight numbers of steps to an octave, 1 to
   16, 18, 20 ... 32, 36 ...; or tolerances of 1, 0.5, 0.2, 0.1 ... */
static struct models_plan rung(struct models_plan p, int n)
{
    static const double digit[] = {0.2, 1, 0.5};
    double power = 1; /* its inverse: these are as they are written */
    for (int k = 1; k <= (n - 1) / 3 && p.model->method->adaptive; ++k)
        power *= 10;
    if (p.model->method->adaptive)
        p.tolerance = digit[n % 3] / power;
    else
        p.steps =
            n < 8 ? (uint64_t)n : (uint64_t)(8 + n % 8) << (n / 8 - 1);
    return p;
}

/* How fine a rung is, in octaves. */
static double fineness(const struct models_plan *p)
{
    return p->tolerance > 0 ? -log2(p->tolerance) : log2((double)p->steps);
}

/* The coarsest rung as fine as this; 2^52 steps or 1e-15 at most. */
static struct models_plan rung_at(struct models_plan p, double fine)
{
    const int most = p.model->method->adaptive ? 46 : 400;
    int n = 1;
    for (p = rung(p, n); n < most && fineness(&p) < fine - 1e-9;)
        p = rung(p, ++n);
    return p;
}

/* A run to compare others with, and how far it may itself be off. */
struct reference {
    struct record run, coarser;
    double seen;    /* how far the two are apart */
    double doubt;   /* how far the finer one may be off */
    unsigned twins; /* how many have been asked, besides the coarser run */
};

/* A method on its ladder. */
struct ladder {
    struct choose_candidate *candidate;
    struct models_plan foot;
    struct choose_point best; /* the coarsest that holds, or the last that
                                 does not; model NULL: none was tried */
    double least, most; /* between these is the next one, in octaves */
    double rise;        /* octaves of cost to one of fineness */
    double price;       /* s: at which it may hold, after its first run */
};

/* Where a ladder begins: with steps that the method can bear. */
static struct models_plan foot_of(const struct task *t,
                                  struct models_plan p)
{
    const double limit = p.model->method->limit;
    const double bears = limit > 0 ? fmin(0.6 * limit, 2) : 1;
    const double rate = models_rate(t->q->scene, p.cuts);
    return rung_at(p, p.model->method->adaptive
                          ? -log2(fmin(t->q->tolerance, 1e-4))
                          : log2(t->q->every * rate / bears));
}

/* How far a run is from the reference, and that from the truth. */
static double off_by(const struct task *t, const struct record *r)
{
    return apart(t, r, &t->f->run) + t->f->doubt;
}

/* How far the next finer rung is off, which may have been tried. */
static double error_of_finer(const struct task *t, const struct ladder *l,
                             const struct models_plan *p)
{
    struct record r;
    struct record_order o = order_of(t, *p, INFINITY);
    o.plan = rung_at(o.plan, fineness(p) + 0.05);
    if (l->best.plan.steps == o.plan.steps)
        return l->best.error;
    run(t, &r, &o);
    const double error = off_by(t, &r);
    record_free(&r);
    return error;
}

/* Runs the next coarser rung into r and returns how far it is off. From 8
   steps on, rungs are 0.09 to 0.17 octaves apart; below, and where a rung
   is known to fail, nothing is run and the result is INFINITY. */
static double error_of_coarser(const struct task *t, const struct ladder *l,
                               const struct models_plan *p,
                               struct record *r)
{
    struct record_order o = order_of(t, *p, INFINITY);
    o.plan = rung_at(o.plan, fineness(p) - 0.19);
    if (o.plan.steps == p->steps || fineness(&o.plan) <= l->least)
        return INFINITY;
    run(t, r, &o);
    return off_by(t, r);
}

/* A number of steps may hold because its errors happen to cancel, so one of
   its neighbours has to hold, too. If that is the finer one, the run stands
   as it is; if it is the coarser one, which is cheaper, that takes its
   place. Otherwise the run is as bad as its finer neighbour. */
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

/* Runs a plan, and notes how far off it is; l: NULL, or its ladder. */
static struct choose_point try_plan(const struct task *t,
                                    const struct ladder *l,
                                    struct models_plan plan, double limit,
                                    struct choose_candidate *k)
{
    struct record r;
    struct choose_point seen = {plan, INFINITY, INFINITY}; /* too dear */
    const struct record_order o = order_of(t, plan, limit);
    run(t, &r, &o);
    if (r.end != MODELS_COSTLY)
        seen.cost = r.cost;
    if (whole(t, &r)) {
        seen.error = off_by(t, &r);
        if (l && plan.tolerance == 0 && r.cost < best(t) &&
            seen.error <= t->q->tolerance)
            ask_neighbours(t, l, &r, &seen);
        offer(t, k, &r, seen.error);
    } else if (!k->holds)
        say(k, ending(&r));
    record_free(&r);
    return seen;
}

/* A run that is off by more of the scale than this is on another way: it
   does not tell by what order finer steps become better. Inside of the
   scale they are at best as good as if it were off by this; a run that has
   left it, because its steps are unstable or have lost a pair, bounds
   nothing. */
static const double lost = 0.1;

static bool is_lost(double error)
{
    return error > lost;
}

/* Does the last run of a ladder tell nothing of its order? What is left out
   may be the whole error: then much finer steps are tried at once. */
static bool is_blind(const struct ladder *l)
{
    const double error = l->best.error;
    return isinf(error) || (is_lost(error) && !l->foot.cuts);
}

/* Are finer rungs no use? If one leaves the error as it was, it is that of
   what the ladder leaves out; without anything left out it was chance. And
   two runs in turn that break down are enough. */
static bool is_vain(const struct ladder *l, double error)
{
    const double before = l->best.error;
    return isinf(error) ? isinf(before)
                        : l->foot.cuts && !is_lost(error) &&
                              fabs(error - before) < 0.01 * error;
}

static void note(const struct task *t, struct ladder *l,
                 struct choose_point r)
{
    const double fine = fineness(&r.plan), target = t->q->tolerance;
    const bool holds = r.error <= target;
    if (!holds && is_vain(l, r.error))
        l->most = -INFINITY; /* finer steps are no help */
    if (isinf(r.cost) || holds)
        l->most = fmin(l->most, fine);
    else
        l->least = fmax(l->least, fine);
    if (isfinite(r.cost) && (holds || !(l->best.error <= target)))
        l->best = r;
}

static void try_rung(const struct task *t, struct ladder *l,
                     struct models_plan plan)
{
    note(t, l, try_plan(t, l, plan, best(t), l->candidate));
}

/* The order of a method; in the tolerance of its own steps, one. */
static double order_of_method(const struct ladder *l)
{
    const struct stepping_method *m = l->foot.model->method;
    return m->adaptive ? 1 : m->order;
}

/* By how many octaves the error has to fall; INFINITY: it is not known. */
static double excess(const struct task *t, const struct ladder *l)
{
    return log2(l->best.error / t->q->tolerance);
}

/* What a rung will cost that is so many octaves finer, s. */
static double price_of(const struct ladder *l, double more)
{
    return l->best.cost * exp2(l->rise * more);
}

enum { FAR = 4 }; /* octaves that are believed at once */

/* By how many octaves finer steps may hold. An error that says nothing of
   the order leads to twice the cost, whatever its size. */
static double octaves_up(const struct task *t, const struct ladder *l)
{
    const double more =
        is_blind(l) ? 1 / l->rise : excess(t, l) / order_of_method(l);
    return fmin(more, FAR);
}

/* The next rung that is worth a run; model NULL: none is. */
static struct models_plan next_rung(const struct task *t,
                                    const struct ladder *l)
{
    const double may = fmin(0.98 * best(t), left_of(t));
    const double far = excess(t, l), now = fineness(&l->best.plan);
    const double one = 0.125; /* octaves from rung to rung */
    const double dear = log2(may / l->best.cost) / l->rise - one;
    const double order = order_of_method(l);
    const double highest = l->foot.model->method->orbits ? 8 : 1.2 * order;
    const double nearest = fmin(far, log2(lost / t->q->tolerance)) /
                           (far > 0 || l->rise < 1 ? highest : order);
    const double more = octaves_up(t, l);
    const double want =
        now + more > l->least ? now + more : (l->least + l->most) / 2;
    const double go = fmax(fmin(want, now + dear), l->least + one / 2);
    struct models_plan next = rung_at(l->foot, go);
    if (!l->best.plan.model || !(fineness(&next) < l->most) ||
        (l->best.error <= 1 && !(price_of(l, nearest) < may)) ||
        !(price_of(l, fineness(&next) - now) < may))
        next.model = NULL;
    return next;
}

/* Notes what a ladder on which nothing holds would cost, if its last error
   tells, and why it goes no further, unless its last run has said so. */
static void foresee(const struct task *t, const struct ladder *l)
{
    struct choose_candidate *k = l->candidate;
    const bool vain = l->most == -INFINITY;
    const bool unknown = is_lost(l->best.error);
    if (l->best.plan.model && !vain && !unknown)
        k->foreseen = price_of(l, excess(t, l) / order_of_method(l));
    if (k->text[0] == '\0')
        say(k, vain      ? "finer steps are no help"
               : unknown ? "too far off to go on"
                         : "by its order too expensive");
}

/* Climbs on, as long as that may become cheaper than the best. */
static void climb(const struct task *t, struct ladder *l)
{
    struct models_plan next;
    while ((next = next_rung(t, l)).model)
        try_rung(t, l, next);
    if (!l->candidate->holds)
        foresee(t, l);
}

static int by_price(const void *a, const void *b)
{
    const struct ladder *one = a, *other = b;
    return one->price < other->price ? -1 : one->price > other->price;
}

static void add_ladder(const struct task *t, struct ladder ladder[],
                       size_t *count, const struct models_model *m,
                       unsigned cuts)
{
    const struct models_plan p = {.model = m, .cuts = cuts, .steps = 1};
    struct choose_candidate *k = enter(t, p);
    const char *why = models_refuse(&p, t->q->scene);
    if (why) {
        say(k, why);
        return;
    }
    struct ladder *l = &ladder[(*count)++];
    *l = (struct ladder){.candidate = k,
                         .foot = foot_of(t, p),
                         .best.error = 1e300, /* no run yet */
                         .least = -INFINITY,
                         .most = INFINITY};
    l->rise = p.model->method->adaptive ? 1.0 / 7 : 1;
    const struct reference *f = t->f;
    if (p.model == f->coarser.plan.model && cuts == 0) {
        note(t, l,
             (struct choose_point){f->coarser.plan, f->seen,
                                   f->coarser.cost});
        l->rise = log2(f->run.cost / f->coarser.cost) /
                  (fineness(&f->run.plan) - fineness(&f->coarser.plan));
    } else {
        /* Steps of their own length at the tolerance that is asked for are
           off by ten times as much or more, and will have to be finer: at
           a quarter of the best price they may still win. */
        const double may = l->rise < 1 ? best(t) / 4 : best(t);
        note(t, l, try_plan(t, l, l->foot, may, k));
    }
    l->price = INFINITY;
    if (l->best.plan.model)
        l->price = price_of(l, fmax(octaves_up(t, l), -FAR));
}

/* What leapfrog leaves out on ladders of its own. It suffices for the rest:
   what is left out is an error that no order makes smaller, and no other
   method knows rods. */
static const unsigned left_out[] = {0, MODELS_NO_LIGHT, MODELS_RODS};
enum { LEFT_OUT = sizeof left_out / sizeof *left_out };

/* The ladders of a model, if its method says that it is to be tried. */
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

/* All ladders of methods whose steps are equal, or of all others: their
   feet first, then one by one as far as it pays. */
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

static struct models_plan finer_reference(struct models_plan p)
{
    return rung_at(p, fineness(&p) + log2(100));
}

/* Refuses for a plan that is too expensive, or for another reason. */
static void refuse_plan(const struct task *t, const struct models_plan *p,
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
                 plan, role, t->q->reason, t->c->spent);
}

/* Refuses where bodies come to rest on each other: runs of two tolerances
   have seen it after the same row, and that is neither rounding nor a
   fork. */
static void refuse_standstill(const struct task *t, const struct record *r)
{
    snprintf(t->c->refusal, CHOOSE_REFUSAL,
             "collisions without end: after t = %.10g bodies come to rest "
             "on each other, and no model here carries them on from there; "
             "spent: %.2g s",
             t->q->scene->time + (double)r->reached * t->q->every,
             t->c->spent);
}

/* Two runs in step, the second one finer, until they part. */
static void run_pair(const struct task *t, struct reference *f,
                     struct models_plan plan)
{
    const struct record_order a = order_of(t, plan, INFINITY);
    struct record_order b = order_of(t, finer_reference(plan), INFINITY);
    b.twin = 1;
    b.plan.slack = 0.2; /* no step is one of the first run's */
    record_both(&f->coarser, &f->run, t->view, &a, &b, t->q->tolerance);
    pay(t, &f->coarser);
    pay(t, &f->run);
}

static const double crude = 0.2; /* of e: of a cheap one */

/* Runs by one method, two in a row without a common measure of their steps,
   finer and finer. False: they would need to be finer than that. */
static bool find_even(const struct task *t, struct reference *f,
                      const char *name)
{
    struct models_plan p = {.model = models_find(name), .steps = 1};
    p = foot_of(t, p);
    for (int level = 0; level < 4; ++level) {
        const struct record_order o = order_of(t, p, INFINITY);
        record_free(&f->coarser);
        f->coarser = f->run;
        run(t, &f->run, &o);
        p.steps = 2 * p.steps + 1;
        f->doubt = f->seen = apart(t, &f->coarser, &f->run);
        const double far = f->doubt / (crude * t->q->tolerance);
        if (far <= 1)
            return true;
        if (level > 0 && !(far < exp2(2 * p.model->method->order)))
            break;
    }
    record_free(&f->coarser);
    record_free(&f->run);
    return false;
}

/* Do the two agree on the closest of all contacts? */
static bool is_decided(const struct reference *f)
{
    const double a = f->coarser.least, b = f->run.least;
    return 2 * fabs(a - b) < fmin(fabs(a), fabs(b));
}

/* Compares the finer run with twins of its own, until they bound its error
   by `want`, or there are no more, or they differ by too much for that. The
   coarser run counts as one of them: rounding moves it no less. Returns
   whether the bound is at most half of the tolerance. */
static bool ask_twins(const struct task *t, struct reference *f,
                      double want)
{
    const double most = t->q->tolerance / doubled;
    double far = f->doubt;
    unsigned k = 1;
    while (k < TWINS && doubled * far <= most &&
           margin[k - 1] * far > want) {
        struct record twin;
        struct record_order o = order_of(t, f->run.plan, INFINITY);
        o.twin = f->run.twin + k++;
        run(t, &twin, &o);
        far = fmax(far, apart(t, &f->run, &twin));
        note_parting(t, &f->run, &twin, most / doubled);
        record_free(&twin);
    }
    f->twins = k;
    f->doubt = (doubled * far > most ? doubled : margin[k - 1]) * far;
    return f->doubt <= most;
}

/* The largest difference of the two and of two more, of balls that are a
   little smaller and larger, if a contact is undecided. */
static void ask_balls(const struct task *t, struct reference *f)
{
    const double hair = 0x1p-40 * t->view->length;
    const double most = t->q->tolerance / doubled / doubled;
    struct record_order o = order_of(t, f->run.plan, INFINITY);
    for (int side = -1; side <= 1 && !is_decided(f); side += 2) {
        struct record third;
        o.swell = side * fmax(2 * fabs(f->run.least), hair);
        run(t, &third, &o);
        f->doubt = fmax(f->doubt, apart(t, &third, &f->run));
        f->doubt = fmax(f->doubt, apart(t, &third, &f->coarser));
        note_parting(t, &third, &f->run, most);
        note_parting(t, &third, &f->coarser, most);
        record_free(&third);
    }
}

/* Finer and finer runs, until two agree. False: they do not; if that is
   no horizon, the refusal says what it is. */
static bool find_reference(const struct task *t, struct reference *f)
{
    struct models_plan plan = {.model = models_find("radau15"), .steps = 1};
    plan = rung_at(plan, -log2(first_tolerance(t)));
    size_t stood = 0; /* rows of the last run that stood still, and 1 */
    if (!t->c->acts.gravity && !t->q->scene->contact &&
        (find_even(t, f, "leapfrog") || find_even(t, f, "kahan-li8")))
        return true;
    for (;; plan = finer_reference(plan)) {
        run_pair(t, f, plan);
        const struct record *bad =
            f->coarser.end != MODELS_DONE ? &f->coarser : &f->run;
        const bool both = f->coarser.end == MODELS_BROKEN &&
                          f->run.end == MODELS_BROKEN &&
                          f->coarser.reached == f->run.reached;
        if (bad->end == MODELS_STANDSTILL && bad->reached + 1 == stood) {
            refuse_standstill(t, bad);
            return false;
        }
        stood = bad->end == MODELS_STANDSTILL ? bad->reached + 1 : 0;
        if (bad->end == MODELS_COSTLY || bad->end == MODELS_MEMORY ||
            bad->why || both) {
            refuse_plan(t, &bad->plan,
                        bad->end == MODELS_COSTLY ? NULL : ending(bad),
                        ", to compare others with,");
            return false;
        }
        f->doubt = f->seen = apart(t, &f->coarser, &f->run);
        if (f->doubt <= share * t->q->tolerance && is_decided(f))
            return true;
        if (f->run.plan.tolerance < 2e-15)
            break;
        record_free(&f->coarser);
        record_free(&f->run);
    }
    if (f->doubt <= t->q->tolerance / doubled)
        ask_balls(t, f);
    if (ask_twins(t, f, crude * t->q->tolerance))
        return true;
    note_parting(t, &f->coarser, &f->run,
                 t->q->tolerance / doubled / doubled);
    return false;
}

/* Models that leave something out, or nearly nothing. */
static void try_approximate(const struct task *t)
{
    const unsigned light = models_cuts(t->q->scene) & MODELS_NO_LIGHT;
    for (const struct models_model *m = models_all(); m->name; ++m) {
        const struct models_plan plan = {
            .model = m, .cuts = m->approximate ? 0 : light};
        if (m->family != MODELS_STEPS && !t->q->only &&
            (m->approximate || light) && !models_refuse(&plan, t->q->scene))
            try_plan(t, NULL, plan, left_of(t), enter(t, plan));
    }
}

/* A plan that was asked for, as it is. */
static void try_only(const struct task *t)
{
    const struct models_plan *only = t->q->only;
    struct choose_candidate *k = enter(t, *only);
    char plan[MODELS_TEXT];
    const struct choose_point seen =
        try_plan(t, NULL, *only, left_of(t), k);
    models_write(only, plan);
    if (!k->holds && isfinite(seen.error))
        snprintf(t->c->refusal, CHOOSE_REFUSAL,
                 "%s is off by %.3g of the scale, more than %.3g", plan,
                 seen.error, t->q->tolerance);
    else if (!k->holds)
        refuse_plan(t, only, isinf(seen.cost) ? NULL : k->text, "");
}

/* All that has to be compared with a reference. */
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
        offer(t, enter(t, f->coarser.plan), &f->coarser,
              f->twins > 0 ? f->seen + f->doubt
              : f->doubt > share * t->q->tolerance
                  ? doubled * f->doubt
                  : (1 + share) * f->doubt);
    race(t, false);
    race(t, true);
}

/* Two references whose errors were as large as the tolerance would differ
   by less than this part of it once in pi/2 agree = 630 times, by chance
   (P_1 at `margin`): is_near_floor leaves no less, and is not asked. */
static const double agree = 400;

/* Does rounding move what was taken by a 300th of the tolerance, or more?
   If not, but the spread of its errors were such that they could break the
   promise, the twin would have come so near by chance: in less than one of
   a hundred cases; and the two references, too, to less than a twentieth,
   in one of a dozen. Each without the other does no harm. */
static bool is_near_floor(const struct task *t)
{
    struct record twin;
    struct record_order o = order_of(t, t->c->run.plan, INFINITY);
    o.twin = 1;
    run(t, &twin, &o);
    const double far = apart(t, &t->c->run, &twin);
    record_free(&twin);
    return 300 * far > t->q->tolerance;
}

/* Compares with the reference; near the floor of rounding once more, when
   that has been compared with twins. */
static void compare_surely(const struct task *t)
{
    struct choose_choice *c = t->c;
    struct reference *f = t->f;
    const size_t candidates = c->candidates, points = c->points;
    compare(t);
    if (!c->run.value || f->twins > 0 ||
        agree * f->seen <= t->q->tolerance || !is_near_floor(t))
        return;
    const bool sure = ask_twins(t, f, crude * t->q->tolerance);
    const double error = off_by(t, &c->run);
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
    if (!f->coarser.value) { /* it was taken, or was offered */
        const struct record_order o =
            order_of(t, f->coarser.plan, INFINITY);
        run(t, &f->coarser, &o);
    }
    compare(t);
}

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
        record_free(&t->c->run); /* another way has seen it fork */
    if (!t->c->run.value && (t->c->horizon == INFINITY || falls) &&
        left_of(t) > 0 && find_reference(t, t->f))
        compare_surely(t);
}

/* Says why nothing was taken, if nobody has. */
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
    else if (left_of(t) < 0.1 * t->q->reason)
        snprintf(
            c->refusal, sizeof c->refusal,
            "beyond reason: no run and its proof cost less than %.3g s "
            "by the price list; spent: %.2g s",
            t->q->reason, c->spent);
    else
        snprintf(c->refusal, sizeof c->refusal,
                 "no model holds %.3g; spent: %.2g s by the price list",
                 t->q->tolerance, c->spent);
}

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

enum { SEEN = 2000 }; /* bodies, at most, whose pairs are looked at */

/* Is there a pair that the tolerance could tell apart but for one body? */
static void look_for_hidden(const struct task *t)
{
    const struct scene *s = t->q->scene;
    struct choose_hidden h = {.apart = INFINITY};
    for (size_t i = 0; i < s->bodies && s->bodies <= SEEN; ++i)
        for (size_t j = 0; j < i; ++j) {
            const double d = sqrt(models_square(s, i, j));
            if (d > 0 && d < h.apart)
                h = (struct choose_hidden){.a = i, .b = j, .apart = d};
        }
    h.without = record_scale_without(s, &h.far);
    if (h.apart < t->q->tolerance * t->view->length &&
        h.without < t->view->length / 10)
        t->c->hidden = h;
}

bool choose(struct choose_choice *c, const struct choose_request *q)
{
    struct record_view view;
    struct reference f = {0};
    const double length = q->until - q->scene->time;
    *c = (struct choose_choice){.horizon = INFINITY};
    if (!record_look(&view, q->program, q->scene, q->asked, length))
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
    record_look_away(&view);
    return true;
}

void choose_free(struct choose_choice *c)
{
    record_free(&c->run);
    *c = (struct choose_choice){0};
}

/* Of the methods whose steps have one length, none has a higher one. */
static const char *const order_in_words[] = {"",      "first",   "second",
                                             "third", "fourth",  "fifth",
                                             "sixth", "seventh", "eighth"};

/* The cheapest that was not taken, by what it costs or would. */
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
