/* From chapters/12-pick.nw: edit there, then run make tangle. */
/* checksum 3567414868 of the lines below */
/* Scout, twin and horizon, what may go, ladders, the race, the check. */
#include "enough/choose.h"

#include "enough/scout.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    RUNGS = 40,
    CANDIDATES = 3 * (STEPPING_MOST + 16), /* room: thrice all models */
    MEASURED = 64                          /* effects remembered */
};
static const double margin = 1.05;  /* errors that were seen, below e */
static const double safety = 1.25;  /* errors that are extrapolated */
static const double rounding = 2;   /* times what other units change */
static const double share = 0.8;    /* of e, that cuts may use */
static const double looks = 4;      /* in the time that is reasonable */
static const double stiff = 0.1;    /* s: to look ahead so long is dear */
static const double patience = 0.3; /* s: a run that is not made for its own
                                       sake */
static const double near = 1.2; /* radii: of a step, at twice the speed */
static const double dear = 4;   /* times the best, on a stretch: out */

/* The next number of steps, eight to an octave: 1 to 16, 18, 20 ... 32,
   36 ... */
static uint64_t next_steps(uint64_t n)
{
    uint64_t more = 1;
    while (more * 16 <= n)
        more *= 2;
    return n + more;
}

/* The first of them that is not below x; 2^60 at most. */
static uint64_t steps_for(double x)
{
    uint64_t n = 1;
    while ((double)n * 2 <= x && n < (UINT64_C(1) << 60))
        n *= 2;
    while ((double)n < x && n < (UINT64_C(1) << 60))
        n = next_steps(n);
    return n;
}

static double power(double x, int n)
{
    double y = 1;
    for (; n > 0; --n)
        y *= x;
    return y;
}
static const double blurred = 0.1; /* of e, that a guide may be off */
static const double worth = 1.3;   /* times what was promised: ask others */

/* A method on its way up the ladder of steps. */
struct racer {
    size_t candidate;
    struct models_plan plan;
    double effect; /* of what it leaves out */
    struct rung {
        uint64_t steps;
        double error, cost; /* NAN: not known yet */
        double apart;       /* from the next rung */
    } rung[RUNGS];
    size_t rungs;
    struct record finest;
    int order;     /* measured, whole; 0: none yet */
    uint64_t need; /* steps that should hold */
    double error;  /* with them; NAN: not seen */
    double price;  /* of the run with so many; not above what it will be */
    bool tried;    /* on the stretch: */
    uint64_t foot; /* with so many steps, and twice as many, */
    double near[2], each; /* it erred so; and s for a step in all rows */
    enum { RUNNING, LOWER, READY, OUT } state;
};

struct chooser {
    const struct choose_request *q;
    struct choose_choice *c;
    struct record_view view;
    size_t rows;
    bool scouted;
    struct scout scout;
    double little;   /* m: a passage that moves by less does not count */
    bool settled;    /* two scouts have brought home the same */
    double passing;  /* 1/s: bodies that meet must not pass unseen */
    double turning;  /* 1/s: nor springs turn round */
    double swinging; /* 1/s: of springs that implicit methods must follow */
    bool kinked;     /* but they do, faster than steps can be short */
    uint64_t fine;   /* steps of a row with which jumps do not matter */
    bool ordered; /* the order of a plan has been seen, above the first */
    struct models_plan look;       /* the plan that looks ahead */
    struct record looked, rounded; /* by it; and in other units */
    struct record guide;           /* exact, if any is */
    double blur;                   /* but for this share of the scale */
    double
        bound[MODELS_CUTS]; /* of one cut, if its bit is set in bounded */
    unsigned bounded;
    struct {
        unsigned cuts;
        double effect;
    } measured[MEASURED];
    size_t measurements;
    struct record finer; /* the look, with twice the steps */
    struct racer *racer;
    size_t racers;
    bool sought;    /* has it been chosen, or seen that there is none? */
    size_t stretch; /* rows; 0: there is none */
    struct scene at;
    struct record reference; /* the stretch as it should be */
    double amplified; /* its errors, in the whole run; 0: not known */

    double best; /* the smallest cost that holds so far */
    bool failed; /* no memory */
};

static void say(struct choose_candidate *c, const char *text)
{
    snprintf(c->text, sizeof c->text, "%s", text);
}

/* A new candidate; the list has room for all. */
static struct choose_candidate *enter(struct chooser *h,
                                      struct models_plan plan)
{
    struct choose_choice *c = h->c;
    if (c->candidates == CANDIDATES)
        return NULL;
    struct choose_candidate *next = &c->candidate[c->candidates++];
    *next = (struct choose_candidate){.plan = plan,
                                      .sure = CHOOSE_OUT,
                                      .error = INFINITY,
                                      .cost = INFINITY};
    return next;
}

/* Keeps a run whose error is known; the list has room for all. */
static void plot(struct chooser *h, size_t candidate, uint64_t steps,
                 double error, double cost)
{
    struct choose_choice *c = h->c;
    if (isfinite(error) && c->points < CANDIDATES * RUNGS)
        c->point[c->points++] =
            (struct choose_point){candidate, steps, error, cost};
}

static struct record_order order_of(const struct chooser *h,
                                    struct models_plan plan, double limit)
{
    return (struct record_order){.scene = h->q->scene,
                                 .plan = plan,
                                 .every = h->q->every,
                                 .rows = h->rows,
                                 .limit = limit,
                                 .little = 0.1 * h->q->tolerance *
                                           h->view.length};
}

/* Runs, and counts what that cost. */
static bool run(struct chooser *h, struct record *r,
                const struct record_order *o)
{
    if (record_run(r, &h->view, o)) {
        h->c->deciding += r->cost + r->watching;
        return true;
    }
    h->failed = true;
    return false;
}

/* Are there two points that have to meet, being on one line? */
static bool points_meet(const struct chooser *h)
{
    const struct scene *s = h->q->scene;
    size_t points = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        points += s->radius[i] == 0;
    return h->c->acts.contact && h->c->acts.dimensions < 2 && points > 1;
}

/* Says whether they do; then the refusal says it, too. */
static bool overlaps(const struct chooser *h, char refusal[CHOOSE_REFUSAL])
{
    const double depth = models_overlap(h->q->scene);
    if (!(depth > h->q->tolerance * h->view.length))
        return false;
    snprintf(refusal, CHOOSE_REFUSAL,
             "at the start bodies overlap, or are outside of a wall, by "
             "%.3g, and what comes of that depends on the step; expected "
             "bodies that at most touch",
             depth);
    return true;
}

/* What the check of a model has found, if there was one; or NULL. */
static const struct choose_verdict *verdict_of(
    const struct choose_request *q, const struct models_model *m,
    unsigned cuts)
{
    for (size_t j = 0; j < q->verdicts; ++j) {
        const struct choose_verdict *v = &q->verdict[j];
        if (v->plan.model == m && v->plan.cuts == cuts)
            return v;
    }
    return NULL;
}

/* NULL, or why the model does not carry the scene without the cuts. */
static const char *refusal(const struct chooser *h,
                           const struct models_model *m, unsigned cuts)
{
    const struct choose_verdict *v = verdict_of(h->q, m, cuts);
    if (v && isinf(v->cost))
        return "its check has refused it";
    const struct models_plan plan = {m, cuts, m->method ? 1 : 0};
    if (m->family == MODELS_STEPS && points_meet(h))
        return "points on a line meet, and no step sees it: give them "
               "radii";
    return models_refuse(&plan, h->q->scene);
}

static const char *ending(const struct record *r)
{
    return r->why                        ? r->why
           : r->end == MODELS_STANDSTILL ? "collisions without end"
           : r->end == MODELS_COSTLY     ? "dearer than the best"
           : r->end == MODELS_MEMORY     ? "no memory"
           : r->end == MODELS_BROKEN     ? "breaks down"
                                         : "";
}

static bool whole(const struct chooser *h, const struct record *r)
{
    return r->end == MODELS_DONE && r->reached == h->rows;
}

static double until_of(const struct chooser *h, size_t row)
{
    return h->q->scene->time + (double)row * h->q->every;
}

/* Notes how far the run and the same in other units agree. */
static void note_rounding(struct chooser *h, const struct record *a,
                          const struct record *b)
{
    struct choose_choice *c = h->c;
    const double apart = record_apart(&h->view, a, b, 1, h->rows);
    c->rounding = rounding * apart;
    c->growth = apart / 0x1p-53;
    const size_t held =
        record_agree(&h->view, a, b, h->q->tolerance / rounding);
    c->horizon = held < h->rows ? until_of(h, held) : INFINITY;
}

/* What clocks do to what is asked for that are wrong by their roundings. */
static double slip(struct chooser *h, const struct record *r)
{
    const double late_by = 0x1p-40;
    struct record late;
    struct record_order o = order_of(h, r->plan, INFINITY);
    o.every *= 1 + late_by;
    if (r->clock == 0 || !run(h, &late, &o))
        return 0;
    const double apart = record_apart(&h->view, r, &late, 1, h->rows);
    record_free(&late);
    return r->clock / late_by * apart;
}

static void judge_exact(struct chooser *h, struct choose_candidate *c,
                        struct record *r, double effect)
{
    struct record other;
    struct record_order o = order_of(h, c->plan, INFINITY);
    o.converted = true;
    c->cost = r->cost;
    if (!run(h, &other, &o))
        return;
    const double apart =
        rounding * record_apart(&h->view, r, &other, 1, h->rows) +
        slip(h, r);
    c->error = effect + apart;
    c->effect = effect;
    c->sure = effect > 0 ? CHOOSE_ESTIMATE : CHOOSE_EXACT;
    if (effect == 0 && (c->error <= h->q->tolerance ||
                        c->plan.model->family == MODELS_EVENTS))
        note_rounding(h, r, &other);
    if (c->error > h->q->tolerance)
        snprintf(c->text, sizeof c->text, "%s",
                 effect > h->q->tolerance / 2 ? "leaves too much out"
                                              : "rounding grows beyond e");
    else
        snprintf(c->text, sizeof c->text, "rounding %.1e", apart);
    if (c->error <= h->q->tolerance)
        h->best = fmin(h->best, c->cost);
    plot(h, (size_t)(c - h->c->candidate), 0, c->error, c->cost);
    record_free(&other);
}

/* Notes where two runs have parted: true, if they have. */
static bool note_loss(struct chooser *h, const struct record *a,
                      const struct record *b)
{
    const size_t held =
        record_agree(&h->view, a, b, h->q->tolerance / rounding);
    if (held >= b->reached)
        return false;
    h->c->horizon = until_of(h, held);
    h->c->rounding = record_apart(&h->view, a, b, 1, b->reached);
    return true;
}

enum { CLOSER = 8 };

/* Looks for a horizon within the first row: true, if there is one. If not,
 *price is what all rows will cost, s. */
static bool look_closer(struct chooser *h, double *price)
{
    struct choose_request first = *h->q;
    struct choose_choice c;
    first.until = until_of(h, 1);
    first.every = h->q->every / 16;
    first.verdicts = 0;
    first.spent = 0;
    *price = INFINITY;
    if (++first.closer > CLOSER || !choose(&c, &first))
        return false;
    const bool lost = c.horizon < INFINITY;
    *price = c.taken < c.candidates
                 ? c.candidate[c.taken].cost * (double)h->rows
                 : INFINITY;
    if (lost || h->c->horizon < INFINITY)
        h->c->horizon = fmin(c.horizon, first.until);
    h->c->rounding = fmax(c.rounding, h->c->rounding);
    h->c->deciding += c.deciding;
    choose_free(&c);
    return lost;
}

/* Looks for a horizon in the rows of a run that was cut short: true, if
   there is one. If not, *price is what all rows will cost, s. */
static bool lost_early(struct chooser *h, const struct record *r,
                       double *price)
{
    struct record other;
    struct record_order o = order_of(h, r->plan, patience);
    o.converted = true;
    if (r->reached == 0)
        return look_closer(h, price);
    *price = r->cost / (double)r->reached * (double)h->rows;
    o.rows = r->reached;
    if (!run(h, &other, &o))
        return false;
    const bool lost = note_loss(h, r, &other);
    record_free(&other);
    return lost;
}

static void try_exact(struct chooser *h, const struct models_model *m,
                      unsigned cuts, double effect)
{
    struct record r;
    struct choose_candidate *c =
        enter(h, (struct models_plan){.model = m, .cuts = cuts});
    struct record_order o = order_of(h, c->plan, h->q->reason);
    if (m->family == MODELS_EVENTS)
        o.limit = fmin(patience, o.limit);
    if (!run(h, &r, &o))
        return;
    if (r.end == MODELS_COSTLY && o.limit < h->q->reason) {
        double price = INFINITY;
        const bool lost = lost_early(h, &r, &price);
        record_free(&r);
        o.limit = h->q->reason;
        say(c, lost ? "rounding grows beyond e" : "too dear");
        if (lost || price > o.limit || !run(h, &r, &o))
            return;
    }

    if (!whole(h, &r))
        say(c, ending(&r));
    else
        judge_exact(h, c, &r, effect);
    if (cuts == 0 && c->error <= h->q->tolerance && !h->guide.value)
        h->guide = r;
    else
        record_free(&r);
}

static bool wanted(const struct chooser *h, const struct models_model *m)
{
    return !h->q->only || (h->q->only->model == m && h->q->only->cuts == 0);
}

static void try_all_exact(struct chooser *h)
{
    for (const struct models_model *m = models_all(); m->name && !h->failed;
         ++m) {
        if (m->family == MODELS_STEPS || m->approximate || !wanted(h, m))
            continue;
        const char *why = refusal(h, m, 0);
        if (!why)
            try_exact(h, m, 0, 0);
        else
            say(enter(h, (struct models_plan){.model = m}), why);
    }
}

/* How fast two bodies could pass through each other, 1/s, at the largest
   speed so far. */
static void note_passing(struct chooser *h, double speed)
{
    const struct scene *s = h->q->scene;
    double least = INFINITY;
    for (size_t i = 0; s->contact && i < s->bodies; ++i)
        if (s->radius[i] > 0)
            least = fmin(least, s->radius[i]);
    if (isfinite(least))
        h->passing = fmax(h->passing, 2 * speed / least);
}

/* Notes what a watched run has shown. */
static void note_watched(struct chooser *h, const struct record *r)
{
    note_passing(h, r->speed);
    if (r->missed > 0)
        h->passing = fmax(h->passing,
                          near * 2 * (double)r->plan.steps / h->q->every);
    h->swinging = fmax(h->swinging, r->swinging);
}

/* Is a row of so many steps fine enough for that? */
static bool sees_passing(const struct chooser *h, struct models_plan plan)
{
    const double n = (double)plan.steps;
    const bool implicit = plan.model->method->family == STEPPING_IMPLICIT;
    return h->passing * h->q->every <= near * n &&
           (!implicit || h->swinging * h->q->every <= 2 * n);
}

/* So many parts of a row, a power of two, that there are sixteen. */
static size_t parts_for(size_t rows)
{
    size_t parts = 1;
    while (parts * rows < 16)
        parts *= 2;
    return parts;
}

/* Sends a scout. False: there is no memory. */
static bool send_scout(struct chooser *h, struct scout *p, double aim)
{
    const size_t parts = parts_for(h->rows);
    const struct scout_order o = {.every = h->q->every / (double)parts,
                                  .rows = h->rows * parts,
                                  .little = h->little,
                                  .aim = aim,
                                  .limit = h->q->reason / looks};
    if (!scout_ahead(p, h->q->scene, &o)) {
        h->failed = true;
        return false;
    }
    h->c->deciding += p->cost;
    ++h->c->scouts;
    return true;
}

/* Sends scouts until two agree, or one does not come to the end. */
static void send_scouts(struct chooser *h)
{
    enum { HALVINGS = 8 };
    double aim = 0.6;
    if (h->scouted)
        scout_free(&h->scout);
    h->scouted = send_scout(h, &h->scout, aim);
    h->settled = false;
    for (int k = 0; h->scouted && h->scout.reached == h->scout.rows &&
                    !h->settled && k < HALVINGS;
         ++k) {
        struct scout finer;
        aim /= 2;
        if (!send_scout(h, &finer, aim))
            return;
        if (k > 0 && finer.reached < finer.rows) {
            scout_free(&finer);
            return;
        }
        h->settled = scout_agree(&h->scout, &finer);
        scout_free(&h->scout);
        h->scout = finer;
    }
}

static bool look_ahead(struct chooser *h)
{
    h->c->fastest = h->c->acts.fastest;
    note_passing(h, h->view.speed);
    h->settled = true;
    if (h->q->scene->k2 <= 0)
        return true;
    send_scouts(h);
    h->c->fastest = fmax(h->c->fastest, h->scout.most);
    return h->scouted && h->scout.reached == h->scout.rows;
}

/* Do forces jump, so that methods have no order? */
static bool is_rough(const struct chooser *h)
{
    return h->c->acts.contact || h->kinked;
}

static struct models_plan plan_of(const char *name, double steps)
{
    return (struct models_plan){.model = models_find(name),
                                .steps = steps_for(steps)};
}

/* The largest rate in the scene without what the plan leaves out, 1/s. */
static double rate_of(const struct chooser *h, struct models_plan plan)
{
    struct models_run run;
    const char *why;
    plan.steps = plan.model->method ? 1 : 0;
    if (!models_begin(&run, &plan, h->q->scene, h->q->every, &why))
        return h->c->fastest;
    models_analyse(&run.acts, &run.scene); /* which has lost its rods */
    const double rate = fmax(run.acts.fastest, h->scout.most);
    models_end(&run);
    return h->blur > 0
               ? rate
               : fmax(rate, fmax(h->passing, h->kinked ? 0 : h->turning));
}

static bool is_damped(const struct chooser *h)
{
    return h->c->acts.friction || h->c->acts.dashpots;
}

static struct models_plan even_plan(const struct chooser *h)
{
    const double rate = fmax(h->c->fastest, h->kinked ? 0 : h->turning);
    const double phase = h->q->every * fmax(rate, h->passing);
    return h->c->acts.contact ? plan_of("leapfrog", phase)
           : is_damped(h)     ? plan_of("rk4", phase / 0.5)
                              : plan_of("pefrl", phase / 0.5);
}

/* Will the run, refined until it settles, cost more than the limit? */
static bool hopeless(const struct chooser *h, const struct record_order *o,
                     double apart)
{
    const int p = h->c->acts.contact ? 1 : o->plan.model->method->order;
    const double needed = fmax(h->passing / near, h->swinging / 2);
    if (!sees_passing(h, o->plan) &&
        h->looked.cost * needed * h->q->every / (double)o->plan.steps >
            o->limit)
        return true;
    return isfinite(apart) && h->looked.cost > patience &&
           apart >
               h->q->tolerance / 4 * power(o->limit / h->looked.cost, p);
}

/* Doubles the steps of the run until that changes little. False: that would
   cost too much. */
static bool settle(struct chooser *h, struct record_order *o)
{
    struct record finer;
    double apart = INFINITY;
    while ((apart > h->q->tolerance / 4 || !sees_passing(h, o->plan)) &&
           h->looked.end != MODELS_COSTLY) {
        if (hopeless(h, o, apart) || o->plan.steps >> 58)
            return false;
        o->plan.steps *= 2;
        if (!run(h, &finer, o))
            return false;
        apart = record_apart(&h->view, &h->looked, &finer, 1, h->rows);
        record_free(&h->looked);
        h->looked = finer;
        note_watched(h, &finer);
    }
    h->look = o->plan;
    return whole(h, &h->looked);
}

/* Looks with a plan, at a cost below limit. */
static bool look_with(struct chooser *h, struct models_plan plan,
                      bool settled, double limit)
{
    struct record_order o = order_of(h, plan, limit);
    o.watched = h->q->scene->contact || h->q->scene->springs > 0;
    record_free(&h->looked);
    h->look = plan;
    if (!run(h, &h->looked, &o))
        return false;
    note_watched(h, &h->looked);
    return settled ? settle(h, &o) : whole(h, &h->looked);
}

/* What looking ahead will cost if the rate stays as it is, s. */
static double look_price(const struct chooser *h)
{
    const struct scene *s = h->q->scene;
    const double n = (double)s->bodies;
    const struct models_plan plan = even_plan(h);
    const double e = (double)plan.steps * (double)h->rows *
                     (double)plan.model->method->stages;
    const double work[MODELS_UNITS] = {
        [MODELS_EVALUATION] = e,
        [MODELS_BODY] = e * n,
        [MODELS_PAIR] = s->k2 > 0 ? e * n * (n - 1) / 2 : 0,
        [MODELS_SPRING] = e * (double)s->springs};
    return models_cost(work);
}

/* The run that looks ahead with even steps. Springs may be too stiff for
   it; then an implicit method looks. */
static bool look_evenly(struct chooser *h)
{
    const struct models_acts *a = &h->c->acts;
    const double most = h->q->reason / looks;
    const bool springs = a->springs && !a->gravity && !a->contact;
    if (!springs)
        return look_price(h) < most &&
               look_with(h, even_plan(h), a->contact, most);
    return look_with(h, even_plan(h), false, fmin(stiff, most)) ||
           look_with(h, plan_of("gauss4", 4), true,
                     fmin(5 * stiff, most)) ||
           (look_price(h) < most &&
            look_with(h, even_plan(h), false, most));
}

/* Looks with even steps and in other units. */
static void look_twice(struct chooser *h)
{
    record_free(&h->rounded);
    if (!look_evenly(h) || h->failed) {
        record_free(&h->looked);
        return;
    }
    struct record_order o = order_of(h, h->look, INFINITY);
    o.converted = true;
    if (run(h, &h->rounded, &o))
        note_rounding(h, &h->looked, &h->rounded);
}

/* Is there something in the drawers that should have counted? */
static bool overlooked(const struct chooser *h)
{
    double weaker = 1;
    for (size_t k = 0; h->scouted && k < SCOUT_DRAWERS; ++k, weaker *= 2)
        if (weaker < 2 * h->c->growth &&
            h->scout.passed[k] > 2 * h->c->fastest)
            return true;
    return false;
}

/* Has a spring turned round faster than what the steps were made for? Then
   another look is needed, or there is no help: h->kinked. */
static bool turned(struct chooser *h)
{
    const double known = fmax(fmax(h->c->fastest, h->passing), h->turning);
    if (h->kinked || !(h->looked.turning > 2 * known))
        return false;
    h->turning = h->looked.turning;
    h->kinked = !(look_price(h) < h->q->reason / looks);
    return !h->kinked;
}

/* Looks ahead: scouts, then even steps, until nothing is overlooked. What
   was looked at stands in h->looked; nothing there: that is too dear. */
static void look_around(struct chooser *h)
{
    enum { TIMES = 4 };
    h->little = 0.01 * h->q->tolerance * h->view.length;
    for (int k = 0; k < TIMES && !h->failed; ++k) {
        record_free(&h->looked);
        if (!look_ahead(h))
            return;
        look_twice(h);
        if (!h->looked.value)
            return;
        const bool again = turned(h);
        if (!overlooked(h) && !again)
            return;
        if (!again)
            h->little /= fmax(2, h->c->growth);
    }
    h->settled = h->settled && !overlooked(h);
}

/* The velocities of two rows: the largest difference, m/s. */
static double speeds_apart(const struct chooser *h, const double a[],
                           const double b[])
{
    double most = 0;
    for (size_t c = 0; c < h->view.columns; ++c)
        if (c % 6 >= 3)
            most = fmax(most, fabs(a[c] - b[c]));
    return most;
}

/* What leaving out the cuts for one row, from row k on, does until the
   end: share of the scale. Source: (12.14, eq:choose-fan). */
static double blade(struct chooser *h, const struct scene *at,
                    unsigned cuts, size_t k)
{
    struct record r;
    struct record_order o = order_of(h, h->look, INFINITY);
    const size_t next = (k + 1) * h->view.columns;
    struct record kept = {
        .reached = 1, .value = h->looked.value + next - h->view.columns};
    o.scene = at;
    o.rows = 1;
    o.plan.cuts = cuts;
    if (!run(h, &r, &o))
        return INFINITY;
    if (r.end != MODELS_DONE || r.reached < 1) {
        record_free(&r);
        return INFINITY;
    }
    const double left = (double)(h->rows - k - 1) * h->q->every;
    const double bound = record_apart(&h->view, &kept, &r, 1, 1) +
                         left / h->view.length *
                             speeds_apart(h, h->looked.value + next,
                                          r.value + h->view.columns);
    record_free(&r);
    return fmax(1, h->c->growth) * bound;
}

/* Puts the bodies where the look had them in row k. */
static void put_at(const struct chooser *h, struct scene *at, size_t k)
{
    const double *row = h->looked.value + k * h->view.columns;
    const size_t n = at->bodies;
    free(at->carry);
    free(at->kept);
    at->carry = at->kept = NULL;
    for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < SCENE_AXES; ++c) {
            at->position[c * n + i] = row[6 * i + c];
            at->velocity[c * n + i] = row[6 * i + 3 + c];
        }
}

static double open_fan(struct chooser *h, struct scene *at, unsigned cut)
{
    double sum = 0;
    if (refusal(h, h->look.model, cut))
        return INFINITY;
    for (size_t k = 0; k < h->rows && sum < 1 && !h->failed; ++k) {
        put_at(h, at, k);
        sum += safety * blade(h, at, cut, k);
    }
    return sum;
}

/* The same of rods. Source: (12.15, eq:choose-swing). */
static double bound_rods(const struct chooser *h, struct scene *at)
{
    double swing = 0, turning = 0, rate;
    const struct models_plan rods = {models_find("leapfrog"), MODELS_RODS,
                                     1};
    for (size_t k = 0; k <= h->rows; ++k) {
        put_at(h, at, k);
        swing = fmax(swing, models_swing(at, &rate));
        turning = fmax(turning, rate);
    }
    const double turns =
        fmax(turning, rate_of(h, rods)) * (double)h->rows * h->q->every;
    return safety * swing / h->view.length *
           (1 + fmax(1, h->c->growth) * turns * turns / 2);
}

/* How much a cut may do at most. INFINITY: that would be as much as the
   scene is large, or nobody knows. */
static double find_bound(struct chooser *h, unsigned cut)
{
    struct scene at;
    if (h->q->asked)
        return INFINITY;
    if (!scene_copy(&at, h->q->scene)) {
        h->failed = true;
        return INFINITY;
    }
    const double bound =
        cut == MODELS_RODS ? bound_rods(h, &at) : open_fan(h, &at, cut);
    scene_free(&at);
    return bound < 1 ? bound : INFINITY;
}

/* The same of a set of cuts, each of which is looked at only once. */
static double bound_of(struct chooser *h, unsigned cuts)
{
    double sum = 0;
    for (unsigned k = 0; k < MODELS_CUTS; ++k) {
        const unsigned cut = 1u << k;
        if (cuts & cut & ~h->bounded)
            h->bound[k] = find_bound(h, cut);
        if (cuts & cut)
            sum += h->bound[k];
        h->bounded |= cuts & cut;
    }
    return sum;
}

/* What the cuts do to a run: how far the two are apart; INFINITY: more than
   the tolerance, or they cannot be made. */
static double cut_apart(struct chooser *h, const struct record *with,
                        unsigned cuts)
{
    struct record without = {0};
    double apart = INFINITY;
    struct record_order o = order_of(h, with->plan, INFINITY);
    o.plan.cuts = cuts;
    o.guide = with;
    o.apart = h->q->tolerance;
    if (run(h, &without, &o) && whole(h, &without))
        apart = record_apart(&h->view, with, &without, 1, h->rows);
    record_free(&without);
    return apart;
}

/* The look once more, with twice its steps; NULL: that is too dear. */
static const struct record *look_finer(struct chooser *h)
{
    struct models_plan plan = h->look;
    plan.steps *= 2;
    const struct record_order o = order_of(h, plan, h->q->reason / looks);
    if (h->finer.plan.steps != plan.steps && !run(h, &h->finer, &o))
        return NULL;
    return whole(h, &h->finer) ? &h->finer : NULL;
}

/* What the cuts do to the run that looks ahead, with so many times its
   steps: one or two. */
static double effect_at(struct chooser *h, unsigned cuts, uint64_t times)
{
    if (refusal(h, h->look.model, cuts))
        return INFINITY;
    const struct record *with = times == 1 ? &h->looked : look_finer(h);
    return with ? cut_apart(h, with, cuts) : INFINITY;
}

/* A run by leapfrog, extrapolated from two: the error is of the fourth
   order. Source: (8.3, eq:order). */
static bool extrapolated(struct chooser *h, struct record *r,
                         struct models_plan plan)
{
    struct record fine = {0};
    struct record_order o = order_of(h, plan, h->q->reason / looks);
    *r = (struct record){0};
    if (!run(h, r, &o) || !whole(h, r))
        return false;
    o.plan.steps *= 2;
    const bool good = run(h, &fine, &o) && whole(h, &fine);
    const size_t all = (h->rows + 1) * h->view.columns;
    for (size_t j = 0; good && j < all; ++j)
        r->value[j] = (4 * fine.value[j] - r->value[j]) / 3;
    record_free(&fine);
    return good;
}

/* Runs a plan with rods in shorter and shorter steps, until they do not
   matter any more. */
static bool settle_rods(struct chooser *h, struct record *r,
                        struct models_plan plan)
{
    struct record finer;
    double apart = INFINITY;
    plan.steps = steps_for(h->q->every * rate_of(h, plan));
    bool good = extrapolated(h, r, plan);
    while (good && apart > h->q->tolerance / 10) {
        plan.steps *= 2;
        good = extrapolated(h, &finer, plan);
        apart = record_apart(&h->view, r, &finer, 1, h->rows);
        record_free(r);
        *r = finer;
    }
    return good;
}

/* What rods do: their steps are dear and may be long, those of the springs
   in their place cheap and short. */
static double effect_of_rods(struct chooser *h, unsigned cuts)
{
    struct record springs = {0}, rods = {0};
    const struct models_plan plan = {models_find("leapfrog"), cuts, 1};
    const double phase = h->q->every * h->c->fastest;
    double apart = INFINITY;
    if (refusal(h, plan.model, cuts))
        return INFINITY;
    const struct models_plan fine = plan_of("leapfrog", phase / 0.2);
    const struct models_plan *by = &h->looked.plan;
    const double price = h->looked.cost * (double)fine.steps /
                         (double)by->steps /
                         (double)by->model->method->stages;
    if (price < h->q->reason / looks && extrapolated(h, &springs, fine) &&
        settle_rods(h, &rods, plan))
        apart = record_apart(&h->view, &springs, &rods, 1, h->rows);
    record_free(&springs);
    record_free(&rods);
    return apart;
}

/* The larger of two such effects, and a quarter more if they differ. */
static double measure_effect(struct chooser *h, unsigned cuts)
{
    if (cuts & MODELS_RODS)
        return effect_of_rods(h, cuts);
    const double a = effect_at(h, cuts, 1);
    if (!(a <= share * h->q->tolerance) || a == 0)
        return a;
    const double b = effect_at(h, cuts, 2);
    const double most = fmax(a, b);
    return most * (fabs(a - b) > most / 8 ? 1.25 : 1.05);
}

/* May the bound be enough? */
static bool is_little(const struct chooser *h, unsigned cuts, double bound)
{
    return !(cuts & MODELS_RODS) && bound <= 0.01 * h->q->tolerance;
}

/* The bound, if it is enough; or what was measured. */
static double bound_or_measure(struct chooser *h, unsigned cuts)
{
    const double bound = bound_of(h, cuts);
    if (is_little(h, cuts, bound) && effect_at(h, cuts, 1) <= bound)
        return bound;
    return measure_effect(h, cuts);
}

static double effect_of(struct chooser *h, unsigned cuts)
{
    for (size_t j = 0; j < h->measurements; ++j)
        if (h->measured[j].cuts == cuts)
            return h->measured[j].effect;
    const double effect = bound_or_measure(h, cuts);
    if (h->measurements < MEASURED) {
        h->measured[h->measurements].cuts = cuts;
        h->measured[h->measurements++].effect = effect;
    }
    return effect;
}

/* Cuts that make a step cheaper, or a larger one possible. */
static const unsigned for_steps = MODELS_NO_LIGHT | MODELS_NO_PULL |
                                  MODELS_NO_WEAK | MODELS_NO_FRICTION |
                                  MODELS_NO_DASHPOTS;

/* Does the cut, with others or alone, open the scene to a model without
   steps that would not carry it otherwise? */
static bool opens(const struct chooser *h, unsigned cut, unsigned all)
{
    for (const struct models_model *m = models_all(); m->name; ++m)
        for (unsigned set = all; m->family != MODELS_STEPS && set > 0;
             set = (set - 1) & all)
            if ((set & cut) && !refusal(h, m, set) &&
                refusal(h, m, set & ~cut))
                return true;
    return false;
}

static void measure_cuts(struct chooser *h)
{
    const unsigned all = models_cuts(h->q->scene);
    struct choose_choice *c = h->c;
    for (unsigned k = 0; k < MODELS_CUTS; ++k) {
        const unsigned cut = 1u << k;
        if (!(all & cut) ||
            (!(cut & (for_steps | MODELS_RODS)) && !opens(h, cut, all)))
            continue;
        struct choose_cut *next = &c->cut[c->cuts++];
        next->cut = cut;
        next->effect = effect_of(h, cut);
        next->bound = bound_of(h, cut);
        next->measured = isinf(next->effect) || next->effect != next->bound;
    }
}

/* The effects of a set, added; INFINITY if one is too much. */
static double sum_of(const struct choose_choice *c, unsigned cuts)
{
    double sum = 0;
    for (size_t j = 0; j < c->cuts; ++j)
        if (cuts & c->cut[j].cut)
            sum += c->cut[j].effect;
    return sum;
}

static unsigned affordable(const struct chooser *h)
{
    unsigned set = 0;
    for (size_t j = 0; j < h->c->cuts; ++j)
        if (h->c->cut[j].effect <= share * h->q->tolerance)
            set |= h->c->cut[j].cut;
    return set;
}

/* The set, out of these cuts, with which the model carries the scene at
   the smallest effect; 0: there is none. */
static unsigned best_set(struct chooser *h, const struct models_model *m,
                         unsigned from)
{
    unsigned best = 0;
    double least = share * h->q->tolerance;
    for (unsigned set = from; set > 0; set = (set - 1) & from) {
        const double sum = sum_of(h->c, set);
        if (sum > least || (sum == least && best) || refusal(h, m, set))
            continue;
        best = set;
        least = sum;
    }
    return best;
}

/* How far a model that is not exact is from the run that looks ahead. */
static double seen_from_look(struct chooser *h, const struct record *r)
{
    return safety * record_apart(&h->view, r, &h->looked, 1, h->rows);
}

static void try_approximate(struct chooser *h, const struct models_model *m)
{
    struct record r;
    struct choose_candidate *c = enter(h, (struct models_plan){.model = m});
    const struct record_order o = order_of(h, c->plan, h->q->reason);
    const char *why = refusal(h, m, 0);
    say(c, why ? why : "not exact: seen by looking ahead");
    if (why || !run(h, &r, &o))
        return;
    c->cost = r.cost;
    c->error = c->effect = seen_from_look(h, &r);
    if (c->error <= h->q->tolerance) {
        c->sure = CHOOSE_ESTIMATE;
        h->best = fmin(h->best, c->cost);
    }
    record_free(&r);
}

static void try_cut_exact(struct chooser *h)
{
    const unsigned from = affordable(h);
    for (const struct models_model *m = models_all(); m->name && !h->failed;
         ++m)
        if (m->approximate && wanted(h, m))
            try_approximate(h, m);
    for (const struct models_model *m = models_all(); m->name && !h->failed;
         ++m) {
        const bool exact =
            m->family != MODELS_STEPS && !m->approximate && wanted(h, m);
        if (!exact || !refusal(h, m, 0))
            continue;
        const unsigned set = best_set(h, m, from);
        if (set)
            try_exact(h, m, set, effect_of(h, set));
    }
}

static double target_of(const struct chooser *h, const struct racer *r)
{
    const double left = h->q->tolerance - r->effect;
    return h->blur > 0 ? share * left / margin : left / margin;
}

/* May something that swings be a radian early or late in the end, so that
   no order can be trusted? Source: (12.16, eq:choose-late). */
static bool is_stiff(const struct chooser *h, struct models_plan plan)
{
    const struct stepping_method *m = plan.model->method;
    const double angle = h->swinging * h->q->every;
    const double late = power(angle / (double)plan.steps, m->order) / 12;
    return !h->q->scene->contact && !(plan.cuts & MODELS_RODS) &&
           (m->family != STEPPING_SPLITTING || !h->ordered) &&
           (double)h->rows * angle * late > 1;
}

/* The steps at which a ladder begins: below what the method can bear, and
   no body may meet another between two of them. */
static uint64_t first_steps(const struct chooser *h,
                            struct models_plan plan)
{
    const double limit = plan.model->method->limit;
    const bool implicit = plan.model->method->family == STEPPING_IMPLICIT;
    const double rate =
        implicit ? fmax(fmax(h->scout.most, h->passing), h->swinging)
                 : rate_of(h, plan);
    plan.steps = steps_for(h->q->every * rate / fmin(0.6 * limit, 2));
    if (plan.model->method->family == STEPPING_EXPLICIT) {
        const uint64_t n = steps_for(h->q->every * h->scout.most / 0.5);
        plan.steps = n > plan.steps ? n : plan.steps;
    }
    while (plan.model->method->family != STEPPING_SPLITTING &&
           is_stiff(h, plan) && plan.steps < UINT64_C(1) << 58)
        plan.steps = next_steps(plan.steps);
    return plan.steps;
}

/* How often a method looks at each of its stages, about. */
static double sweeps(const struct stepping_method *m)
{
    return m->family == STEPPING_IMPLICIT ? 8 : 1;
}

/* What so many steps will cost at least, as far as the run that looked
   ahead tells, s. */
static double foretell(const struct chooser *h, struct models_plan plan)
{
    const struct stepping_method *m = plan.model->method;
    if (!h->looked.value)
        return 0;
    const struct models_plan *by = &h->looked.plan;
    const struct stepping_method *of = by->model->method;
    const double each = h->looked.cost / (double)by->steps /
                        (double)of->stages / sweeps(of);
    const double light = plan.cuts ? 0.1 : 0.8;
    return light * each * sweeps(m) * (double)m->stages *
           (double)plan.steps;
}

static void add_racer(struct chooser *h, const struct models_model *m,
                      unsigned cuts, double effect)
{
    struct racer *r = &h->racer[h->racers];
    const char *why = refusal(h, m, cuts);
    struct models_plan plan = {m, cuts, 1};
    plan.steps = why ? 1 : first_steps(h, plan);
    struct choose_candidate *c = enter(h, plan);
    if (!c)
        return;
    if (why) {
        say(c, why);
        return;
    }
    *r = (struct racer){.candidate = h->c->candidates - 1,
                        .plan = plan,
                        .effect = effect,
                        .need = plan.steps,
                        .foot = plan.steps,
                        .price = foretell(h, plan)};
    const struct choose_verdict *v = verdict_of(h->q, m, cuts);
    if (v) {
        r->state = READY;
        r->need = v->plan.steps;
        r->error = v->error - effect;
        r->price = v->cost;
        r->order = (int)v->order;
        h->best = fmin(h->best, v->cost);
        say(c, "as its check has found");
    }
    ++h->racers;
}

/* What to leave out while stepping: all that costs time and little else. */
static unsigned set_for_steps(struct chooser *h)
{
    unsigned set = 0;
    double sum = 0;
    for (size_t j = 0; j < h->c->cuts && !h->q->scene->contact; ++j) {
        const struct choose_cut *cut = &h->c->cut[j];
        if (!(cut->cut & for_steps) ||
            sum + cut->effect > h->q->tolerance / 2)
            continue;
        set |= cut->cut;
        sum += cut->effect;
    }
    return set;
}

/* The next finer run of a plan in a rough scene, half a step beside the one
   before. */
static bool look_closely(struct chooser *h, struct record_order *o)
{
    struct record finer;
    o->plan.steps = 2 * o->plan.steps + 1;
    o->halfway = !o->halfway;
    if (!run(h, &finer, o))
        return false;
    h->blur = whole(h, &finer) && h->guide.value
                  ? record_apart(&h->view, &h->guide, &finer, 1, h->rows)
                  : INFINITY;
    record_free(&h->guide);
    h->guide = finer;
    return whole(h, &finer);
}

/* Looks for a guide where forces jump. */
static void find_guide(struct chooser *h)
{
    const double most =
        fmin(fmax(patience, 4 * h->looked.cost), h->q->reason / looks);
    struct record_order o = order_of(h, h->look, most);
    h->blur = INFINITY;
    o.plan.steps /= 2;
    bool good = true;
    while (good && h->blur > blurred * h->q->tolerance)
        good = 2 * h->guide.cost < most && look_closely(h, &o);
    h->fine = h->guide.plan.steps;
    if (!good || h->blur == 0) {
        record_free(&h->guide);
        h->blur = 0;
        h->fine = 0;
    }
}

static bool is_beaten(const struct chooser *h, const struct models_model *m)
{
    if (h->q->only)
        return false;
    if (m->method->order < 2)
        return !m->method->symplectic || h->blur == 0;
    return is_rough(h) && h->blur == 0 && strcmp(m->name, "leapfrog") != 0;
}

static void enter_methods(struct chooser *h)
{
    const struct models_plan *only = h->q->only;
    if (only && only->cuts) {
        add_racer(h, only->model, only->cuts, effect_of(h, only->cuts));
        return;
    }
    const unsigned set = set_for_steps(h);
    const double effect = set ? effect_of(h, set) : 0;
    const bool rods =
        (affordable(h) & MODELS_RODS) && !h->q->scene->contact;
    for (const struct models_model *m = models_all(); m->name; ++m) {
        if (m->family != MODELS_STEPS || !wanted(h, m) || is_beaten(h, m))
            continue;
        add_racer(h, m, 0, 0);
        if (!only && set && effect < share * h->q->tolerance)
            add_racer(h, m, set, effect);
        if (!only && rods && strcmp(m->name, "leapfrog") == 0)
            add_racer(h, m, MODELS_RODS, sum_of(h->c, MODELS_RODS));
    }
}

/* The whole order that two errors at n and 2n steps show. */
static int order_seen(double coarse, double fine, int most)
{
    int order = 0;
    double ratio = fine > 0 ? coarse / fine : INFINITY;
    for (; order < most && ratio >= 1.4142135623730951; ++order)
        ratio /= 2;
    return order;
}

static int order_at_most(const struct chooser *h, const struct racer *r)
{
    return h->kinked && h->blur == 0 ? 1 : r->plan.model->method->order;
}

/* The order by which a distance is made an error. */
static int safe_order(const struct stepping_method *m, int order)
{
    return m->symmetric || order < 2 ? order : order - 1;
}

/* The error of a run with n steps, from its distance to one with m > n and
   the order: (12.10, eq:choose-error). */
static double error_of(double apart, uint64_t n, uint64_t m, int order)
{
    const double finer = power((double)m / (double)n, order);
    return apart * finer / (finer - 1);
}

/* How much an error on the stretch has become in the whole run: the least
   that any method has shown. */
static void calibrate(struct chooser *h, const struct racer *r)
{
    const struct rung *first = &r->rung[0];
    if (first->steps != r->foot || !isfinite(first->error) ||
        !(r->near[0] > 0))
        return;
    const double times = fmax(1, first->error / r->near[0]);
    if (h->amplified == 0 || times < h->amplified)
        h->amplified = times;
}

/* Finds the error of a rung from the next one. */
static void learn(struct chooser *h, struct racer *r,
                  const struct record *fine)
{
    const size_t k = r->rungs - 1; /* the new one */
    if (h->guide.value) {
        r->rung[k].error =
            record_apart(&h->view, fine, &h->guide, 1, h->rows);
    } else if (k > 0) {
        const int p = safe_order(r->plan.model->method,
                                 r->order ? r->order : order_at_most(h, r));
        struct rung *last = &r->rung[k - 1];
        last->apart = record_apart(&h->view, &r->finest, fine, 1, h->rows);
        last->error =
            error_of(last->apart, last->steps, r->rung[k].steps, p);
    }
    const size_t last = h->guide.value ? k : k > 0 ? k - 1 : 0;
    if (last > 0 && isfinite(r->rung[last - 1].error))
        r->order = order_seen(r->rung[last - 1].error, r->rung[last].error,
                              order_at_most(h, r));
    if (r->rungs > 0 && r->tried)
        calibrate(h, r);
}

/* The last rung whose error is known; rungs: none. */
static size_t last_known(const struct racer *r)
{
    size_t k = r->rungs;
    while (k > 0 && isnan(r->rung[k - 1].error))
        --k;
    return k > 0 ? k - 1 : r->rungs;
}

/* The smallest number of steps that holds when `steps` have this error. */
static uint64_t extrapolate(uint64_t steps, double error, int order,
                            double target)
{
    const double low = (double)steps / 1.9;
    uint64_t n = error <= target ? steps_for(low) : steps;
    while (n < (UINT64_C(1) << 60) &&
           !(error * power((double)steps / (double)n, order) <= target))
        n = next_steps(n);
    return n;
}

/* What is needed at least when no rung is known to hold: what the errors
   promise, or, as long as they promise nothing, what the last rung has,
   whose error nobody knows yet. */
static void look_up(const struct chooser *h, struct racer *r, double target)
{
    const size_t known = last_known(r);
    const struct rung *last = &r->rung[r->rungs - 1];
    r->need = last->steps;
    if (known == r->rungs || !isfinite(r->rung[known].error) ||
        (r->order == 0 && known > 0))
        return;
    const int order = r->order > 0 ? r->order : order_at_most(h, r);
    r->need =
        extrapolate(r->rung[known].steps,
                    safety / margin * r->rung[known].error, order, target);
    if (r->order > 0 && last->cost > patience && r->need > last->steps &&
        (double)r->need <= 1.5 * (double)last->steps)
        r->state = READY;
}

/* The factor by which errors may be larger than they look. */
static double doubt(const struct chooser *h, const struct racer *r)
{
    return h->guide.value || r->order > 0 ? 1 : 2;
}

/* Foresees what the racer will need, and where it stands. */
static void foresee(const struct chooser *h, struct racer *r)
{
    const double target = target_of(h, r) / doubt(h, r);
    const struct rung *last = &r->rung[r->rungs - 1];
    size_t k = 0;
    while (k < r->rungs && !(r->rung[k].error <= target))
        ++k;
    if (k == r->rungs)
        look_up(h, r, target);
    else {
        r->need = r->rung[k].steps;
        r->error = r->rung[k].error;
        r->state = LOWER;
        r->order = k > 0 && r->order == 0 ? 1 : r->order;
    }
    r->price = last->cost / (double)last->steps * (double)r->need;
}

/* One run on the stretch. */
static bool run_stretch(struct chooser *h, struct record *r,
                        struct models_plan plan)
{
    struct record_order o = order_of(h, plan, h->q->reason / looks);
    o.scene = &h->at;
    o.rows = h->stretch;
    return run(h, r, &o);
}

/* Has a run on the stretch come to its end? */
static bool ends_stretch(const struct chooser *h, const struct record *r)
{
    return r->end == MODELS_DONE && r->reached == h->stretch;
}

/* The row at which a stretch of so many rows begins. */
static size_t begins_at(const struct chooser *h, size_t rows)
{
    const size_t hard =
        h->scouted ? h->scout.hardest / parts_for(h->rows) : 0;
    const size_t from = hard > rows / 2 ? hard - rows / 2 : 0;
    return from + rows > h->rows ? h->rows - rows : from;
}

/* Runs the stretch as it should be. False: it cannot be had. */
static bool run_reference(struct chooser *h)
{
    struct models_plan plan =
        plan_of(is_damped(h) ? "rk4" : "kahan-li8", 1);
    plan.steps = 4 * first_steps(h, plan);
    return run_stretch(h, &h->reference, plan) &&
           ends_stretch(h, &h->reference);
}

/* Chooses a stretch, unless there is none to be had. */
static void choose_stretch(struct chooser *h)
{
    const size_t rows = h->rows / 8;
    const bool none = !h->looked.value || h->q->asked || h->q->all ||
                      h->guide.value || is_rough(h);
    if (none || rows == 0)
        return;
    if (!scene_copy(&h->at, h->q->scene)) {
        h->failed = true;
        return;
    }
    const size_t from = begins_at(h, rows);
    put_at(h, &h->at, from);
    h->stretch = rows;
    if (run_reference(h)) {
        h->c->stretch = rows;
        h->c->stretch_from = until_of(h, from);
    } else {
        scene_free(&h->at);
        h->stretch = 0;
    }
}

/* Runs a racer on the stretch, and returns its error there; INFINITY: it
   has not come to the end. */
static double error_there(struct chooser *h, struct racer *r,
                          uint64_t steps)
{
    struct record now;
    struct models_plan plan = r->plan;
    double error = INFINITY;
    plan.steps = steps;
    if (!run_stretch(h, &now, plan))
        return INFINITY;
    if (ends_stretch(h, &now)) {
        error = record_apart(&h->view, &now, &h->reference, 1, h->stretch);
        r->each =
            now.cost / (double)steps / (double)h->stretch * (double)h->rows;
    }
    record_free(&now);
    return error;
}

/* A racer on the stretch, the second time in half the step. */
static void try_stretch(struct chooser *h, struct racer *r)
{
    enum { DOUBLINGS = 6 };
    r->tried = true;
    r->near[0] = error_there(h, r, r->foot);
    for (int k = 0; k < DOUBLINGS && isinf(r->near[0]); ++k) {
        r->foot *= 2;
        r->near[0] = error_there(h, r, r->foot);
    }
    r->need = r->foot;
    r->near[1] = error_there(h, r, 2 * r->foot);
    r->price = fmax(r->price, r->each * (double)r->foot);
}

/* How few steps may do, by halving, when `steps` have this error. */
static uint64_t fewer(uint64_t steps, double error, int order,
                      double target)
{
    uint64_t n = steps;
    while (n > 1 &&
           error * power(2 * (double)steps / (double)n, order) <= target)
        n /= 2;
    return n;
}

/* The order that it has shown there. */
static int order_there(const struct chooser *h, const struct racer *r)
{
    return isfinite(r->near[0])
               ? order_seen(r->near[0], r->near[1], order_at_most(h, r))
               : 0;
}

/* The steps that should hold in the whole run. */
static uint64_t needed(const struct chooser *h, const struct racer *r)
{
    const double target = target_of(h, r) / fmax(1, h->amplified);
    const int order = order_there(h, r);
    if (order == 0)
        return r->foot;
    if (r->near[0] <= target)
        return fewer(r->foot, r->near[0], order, target);
    return extrapolate(2 * r->foot, r->near[1], order, target);
}

/* And what they would cost, s. */
static double expected(const struct chooser *h, const struct racer *r)
{
    return r->each > 0 ? r->each * (double)needed(h, r) : r->price;
}

/* Writes down what the stretch has promised. */
static void note_promise(struct chooser *h, const struct racer *r)
{
    struct choose_choice *c = h->c;
    if (c->promises < CANDIDATES)
        c->promise[c->promises++] = (struct choose_promise){
            r->candidate,      r->near[0],   r->foot,
            order_there(h, r), needed(h, r), expected(h, r)};
}

/* Not above what it may come to: the steps that hold may be half as
   many. */
static double optimistic(const struct chooser *h, const struct racer *r)
{
    if (r->tried && r->rungs < 2)
        return fmin(fmax(0.5 * r->price, expected(h, r) / dear),
                    expected(h, r));
    if (r->state == LOWER && r->need == r->rung[0].steps)
        return 0.5 * r->price *
               (double)fewer(r->need, r->error, order_at_most(h, r),
                             target_of(h, r)) /
               (double)r->need;
    return (r->state == LOWER || r->rungs < 2 ? 0.5 : 0.8) * r->price;
}

/* Is there a stretch to be run? */
static bool has_stretch(struct chooser *h)
{
    bool begun = false;
    size_t fresh = 0;
    for (size_t j = 0; j < h->racers; ++j) {
        const struct racer *r = &h->racer[j];
        begun = begun || r->rungs > 1;
        fresh += r->rungs == 0 && optimistic(h, r) <= h->best;
    }
    if (begun && fresh > 2 && !h->sought) {
        h->sought = true;
        choose_stretch(h);
    }
    return h->stretch > 0;
}

/* What a racer is expected to cost, by all that is known of it. */
static double promise(const struct chooser *h, const struct racer *r)
{
    return r->tried && r->rungs < 2 ? expected(h, r) : optimistic(h, r);
}

static void give_out(struct chooser *h, struct racer *r, const char *text)
{
    struct choose_candidate *c = &h->c->candidate[r->candidate];
    r->state = OUT;
    say(c, text);
}

/* Writes into the list of candidates what is known of a racer. */
static void publish(struct chooser *h, struct racer *r)
{
    for (size_t k = 0; k < r->rungs; ++k)
        plot(h, r->candidate, r->rung[k].steps,
             r->effect + r->rung[k].error, r->rung[k].cost);
    struct choose_candidate *c = &h->c->candidate[r->candidate];
    c->plan.steps = r->need;
    c->cost = r->price;
    c->order = r->order;
    c->effect = r->effect;
    const size_t known = last_known(r);
    if (known < r->rungs)
        c->error = r->effect +
                   r->rung[known].error *
                       power((double)r->rung[known].steps / (double)r->need,
                             r->order > 0 ? r->order : 1);
    if (r->state != READY)
        return;
    c->sure = CHOOSE_ESTIMATE;
    if (r->error > 0)
        c->error = r->effect + r->error;
    if (c->text[0] == '\0')
        snprintf(c->text, sizeof c->text,
                 r->order ? "order %d" : "the largest step that holds",
                 r->order);
}

/* Adds a rung to the ladder; the run becomes the finest. */
static void add_rung(struct chooser *h, struct racer *r,
                     struct record *next)
{
    r->rung[r->rungs++] =
        (struct rung){next->plan.steps, NAN, next->cost, NAN};
    if (!whole(h, next) && r->rungs > 1)
        r->rung[r->rungs - 2].error = INFINITY;
    else if (r->rungs > 1 || h->guide.value)
        learn(h, r, next);
    record_free(&r->finest);
    r->finest = *next;
    foresee(h, r);
}

/* One rung higher. */
static void climb(struct chooser *h, struct racer *r)
{
    struct record next;
    struct record_order o = order_of(h, r->plan, h->q->reason);
    if (r->rungs == RUNGS || r->need >> 58) {
        give_out(h, r, "no step is small enough");
        return;
    }
    o.plan.steps = r->rungs ? 2 * r->rung[r->rungs - 1].steps : r->need;
    o.halfway = is_rough(h) && h->blur == 0;
    if (!h->q->all) /* a rung tells the errors of fewer steps */
        o.limit = fmin(o.limit, 4.2 * h->best);
    if (0.8 * r->each * (double)o.plan.steps > o.limit) {
        r->price = fmax(r->price, r->each * (double)o.plan.steps);
        give_out(h, r, "dearer than the best");
        return;
    }
    if (!run(h, &next, &o))
        return;
    if (next.why || next.end == MODELS_COSTLY ||
        next.end == MODELS_MEMORY) {
        r->price = fmax(r->price, next.cost);
        give_out(h, r, ending(&next));
        record_free(&next);
    } else
        add_rung(h, r, &next);
}

/* Is the error at the bottom, where rounding keeps it? */
static bool at_the_bottom(const struct chooser *h, const struct racer *r)
{
    const size_t k = last_known(r);
    return k < r->rungs && k > 0 && r->state == RUNNING &&
           r->rung[k].error > r->rung[k - 1].error / 1.5 &&
           r->rung[k].error < 10 * h->c->rounding;
}

/* How far a run with fewer steps is from the finest, or from the guide. */
static double apart_with(struct chooser *h, const struct racer *r,
                         uint64_t steps)
{
    struct record now = {0};
    struct models_plan plan = r->plan;
    plan.steps = steps;
    struct record_order o = order_of(h, plan, INFINITY);
    o.halfway = is_rough(h) && h->blur == 0;
    if (!run(h, &now, &o))
        return INFINITY;
    const double apart =
        record_apart(&h->view, &now,
                     h->guide.value ? &h->guide : &r->finest, 1, h->rows);
    record_free(&now);
    return apart;
}

/* The error that shows. */
static double error_from(const struct chooser *h, const struct racer *r,
                         double apart, uint64_t steps)
{
    return h->guide.value
               ? apart
               : error_of(apart, steps, r->finest.plan.steps,
                          safe_order(r->plan.model->method,
                                     r->order > 0 ? r->order : 1));
}

/* The order, if these are half the steps of the first rung. */
static void learn_late(const struct chooser *h, struct racer *r,
                       double apart, uint64_t steps)
{
    struct rung *first = &r->rung[0];
    if (h->guide.value || r->order > 0 || 2 * steps != first->steps ||
        r->rungs != 2)
        return;
    r->order =
        order_seen(apart - first->apart, first->apart, order_at_most(h, r));
    r->error = first->error = error_from(h, r, first->apart, first->steps);
}

/* The fewest steps that are known not to do; 0: none. */
static uint64_t too_few(const struct chooser *h, const struct racer *r)
{
    uint64_t low = 0;
    for (size_t k = 0; k < r->rungs && r->rung[k].steps < r->need; ++k)
        if (r->rung[k].error > target_of(h, r))
            low = r->rung[k].steps;
    return low;
}

/* Looks for fewer steps, between those that cannot hold and those that
   do. */
static void descend(struct chooser *h, struct racer *r)
{
    const double each = r->price / (double)r->need;
    uint64_t low = too_few(h, r), high = r->need;
    while (next_steps(low) < high && !h->failed) {
        uint64_t n = steps_for((double)(low + high) / 2);
        if (n >= high)
            n = next_steps(low);
        const double apart = apart_with(h, r, n);
        learn_late(h, r, apart, n);
        const double error = error_from(h, r, apart, n);
        if (error <= target_of(h, r)) {
            high = n;
            r->error = error;
        } else
            low = n;
    }
    r->need = high;
    r->price = each * (double)high;
    r->state = READY;
}

/* For a chart every method may climb to this cost, s. */
static const double charted = 0.02;

/* The racer that may still be the cheapest, or NULL. */
static struct racer *front(struct chooser *h)
{
    struct racer *best = NULL;
    const double most = h->q->all ? fmax(30 * h->best, charted) : h->best;
    for (size_t j = 0; j < h->racers; ++j) {
        struct racer *r = &h->racer[j];
        if ((r->state == RUNNING || r->state == LOWER) &&
            optimistic(h, r) <= most &&
            (!best || promise(h, r) < promise(h, best)))
            best = r;
    }
    return best;
}

static void race(struct chooser *h)
{
    struct racer *r;
    while (!h->failed && (r = front(h)) != NULL) {
        if (r->state == LOWER)
            descend(h, r);
        else if (r->rungs == 0 && !r->tried && has_stretch(h))
            try_stretch(h, r);
        else if (r->rungs && r->price > h->q->reason)
            give_out(h, r, "too dear");
        else
            climb(h, r);
        if (at_the_bottom(h, r))
            give_out(h, r, "rounding: no step makes the error smaller");
        if (r->state == READY)
            h->best = fmin(h->best, r->price);
    }
}

static void end_race(struct chooser *h)
{
    for (size_t j = 0; j < h->racers; ++j) {
        struct racer *r = &h->racer[j];
        const bool far =
            r->tried && r->rungs < 2 && expected(h, r) > dear * h->best;
        if (r->state == RUNNING || r->state == LOWER)
            say(&h->c->candidate[r->candidate],
                far ? "dear on a stretch" : "behind");
        if (r->tried)
            note_promise(h, r);
        if (r->rungs || r->state == READY)
            publish(h, r);
        record_free(&r->finest);
    }
}

static bool holds(const struct chooser *h, const struct choose_candidate *c)
{
    return c->sure != CHOOSE_OUT && c->error <= h->q->tolerance &&
           c->cost <= h->q->reason;
}

static bool is_better(const struct choose_candidate *a,
                      const struct choose_candidate *b)
{
    if (a->cost != b->cost)
        return a->cost < b->cost;
    return a->plan.cuts == 0 && b->plan.cuts != 0;
}

static void take_best(struct chooser *h)
{
    struct choose_choice *c = h->c;
    c->taken = c->candidates;
    for (size_t j = 0; j < c->candidates; ++j)
        if (holds(h, &c->candidate[j]) &&
            (c->taken == c->candidates ||
             is_better(&c->candidate[j], &c->candidate[c->taken])))
            c->taken = j;
}

static void refuse_horizon(struct chooser *h)
{
    struct choose_choice *c = h->c;
    const double e = h->q->tolerance;
    double price;
    if (c->horizon <= h->q->scene->time && c->rounding > e)
        look_closer(h, &price);
    snprintf(
        c->refusal, sizeof c->refusal,
        "rounding alone grows to %.2g of the scale, so no run can hold "
        "%.3g: the horizon is t = %.10g; ask for a shorter time, or for "
        "averages (--observe mean:...)",
        c->rounding, e, c->horizon);
}

static void refuse_look(struct chooser *h)
{
    const double price = look_price(h), rate = h->c->fastest;
    if (h->looked.why)
        snprintf(h->c->refusal, sizeof h->c->refusal,
                 "no model carries this scene (--explain says why), and "
                 "steps do not: %s",
                 h->looked.why);
    else if (price > h->q->reason / looks)
        snprintf(
            h->c->refusal, sizeof h->c->refusal,
            "so long a time is beyond reason: to look ahead once, with "
            "steps for what changes at a rate of %.2g, would cost "
            "about %.2g s by the price list, of %.3g s that are "
            "reasonable for all; ask for a shorter time, or for "
            "averages",
            fmax(rate, h->passing), price, h->q->reason);
    else
        snprintf(
            h->c->refusal, sizeof h->c->refusal,
            "looking ahead does not settle: shorter steps keep changing "
            "the run by more than %.3g, and to go on until they do not "
            "is beyond reason (%.3g s by the price list); ask for a "
            "shorter time, or for averages",
            h->q->tolerance / 4, h->q->reason);
}

static void refuse_unsettled(struct chooser *h)
{
    snprintf(
        h->c->refusal, sizeof h->c->refusal,
        "looking ahead does not settle: runs with ever shorter steps "
        "meet ever faster passages (%.3g per unit of time), so no error "
        "could be trusted; ask for a shorter time, or for averages",
        h->scout.most);
}

static void refuse_cost(struct chooser *h)
{
    struct choose_choice *c = h->c;
    double least = INFINITY;
    char plan[MODELS_TEXT] = "none";
    for (size_t j = 0; j < c->candidates; ++j)
        if (c->candidate[j].cost < least &&
            (c->candidate[j].plan.model->family == MODELS_STEPS ||
             !(c->candidate[j].error > h->q->tolerance))) {
            least = c->candidate[j].cost;
            models_write(&c->candidate[j].plan, plan);
        }
    const bool none = isinf(least); /* but a forecast, perhaps */
    for (size_t k = 0; none && k < h->racers; ++k)
        if (h->racer[k].price > 0 && h->racer[k].price < least) {
            least = h->racer[k].price;
            models_write(&h->racer[k].plan, plan);
        }
    if (isinf(least))
        snprintf(c->refusal, sizeof c->refusal,
                 "no model carries this scene (--explain says why)");
    else
        snprintf(
            c->refusal, sizeof c->refusal,
            "no way was found that holds %.3g for less than %.3g s by the "
            "price list (the nearest, %s, would cost %.3g s): ask for "
            "a larger tolerance, a shorter time, or for averages",
            h->q->tolerance, h->q->reason, plan, least);
}

/* Refuses, if looking ahead has shown that it must: true. */
static bool must_refuse(struct chooser *h)
{
    if (!h->looked.value)
        refuse_look(h);
    else if (h->c->horizon < INFINITY)
        refuse_horizon(h);
    else if (!h->settled)
        refuse_unsettled(h);
    return h->c->refusal[0] != '\0';
}

/* Looks ahead, and at what can be left out. Unless something has been found
   already, returns false when it has refused. */
static bool prepare(struct chooser *h, bool found)
{
    const struct models_acts *a = &h->c->acts;
    const bool springs = a->springs && !a->gravity && !a->contact;
    note_passing(h, h->view.speed);
    if (springs || look_price(h) < h->q->reason / looks)
        look_around(h);
    if (!found && !h->failed && must_refuse(h))
        return false;
    if (!h->failed && h->looked.value) {
        measure_cuts(h);
        try_cut_exact(h);
        if (is_rough(h) && !h->guide.value)
            find_guide(h);
    }
    return true;
}

static void decide(struct chooser *h)
{
    struct choose_choice *c = h->c;
    c->fastest = c->acts.fastest;
    if (overlaps(h, c->refusal))
        return;
    try_all_exact(h);
    const bool found = isfinite(h->best);
    const bool enough = found && (!h->q->all || c->acts.contact);
    if (!found && c->horizon < INFINITY) {
        refuse_horizon(h);
        return;
    }
    if (!enough && !h->failed && !prepare(h, found))
        return;
    if (!h->failed)
        enter_methods(h);
    race(h);
    end_race(h);
    take_best(h);
    if (c->taken == c->candidates)
        refuse_cost(h);
}

static void end(struct chooser *h)
{
    record_free(&h->looked);
    record_free(&h->rounded);
    record_free(&h->finer);
    record_free(&h->guide);
    record_free(&h->reference);
    if (h->stretch > 0)
        scene_free(&h->at);
    if (h->scouted)
        scout_free(&h->scout);
    free(h->racer);
    record_look_away(&h->view);
}

static size_t rows_of(const struct choose_request *q)
{
    return (size_t)((q->until - q->scene->time) / q->every + 0.5);
}

bool choose(struct choose_choice *c, const struct choose_request *q)
{
    struct chooser h = {
        .q = q, .c = c, .rows = rows_of(q), .best = INFINITY};
    *c = (struct choose_choice){
        .horizon = INFINITY, .rows = h.rows, .deciding = q->spent};
    if (!record_look(&h.view, q->program, q->scene, q->asked,
                     q->until - q->scene->time))
        return false;
    c->scale = h.view.scale;
    c->judged = h.view.judged;
    models_analyse(&c->acts, q->scene);
    c->candidate = calloc(CANDIDATES, sizeof *c->candidate);
    h.racer = calloc(CANDIDATES, sizeof *h.racer);
    c->point = calloc(CANDIDATES * RUNGS, sizeof *c->point);
    c->promise = calloc(CANDIDATES, sizeof *c->promise);
    h.failed = !c->candidate || !h.racer || !c->point || !c->promise;
    if (!h.failed)
        decide(&h);
    if (c->refusal[0] != '\0')
        c->taken = c->candidates;
    c->meeting = h.scout.most;
    c->passing = h.passing;
    c->turning = h.kinked ? INFINITY : h.turning;
    c->swinging = h.swinging;
    c->fine = h.fine;
    end(&h);
    if (h.failed) {
        fprintf(stderr, "%s: no memory to choose\n", q->program);
        choose_free(c);
    }
    return !h.failed;
}

void choose_free(struct choose_choice *c)
{
    free(c->candidate);
    free(c->point);
    free(c->promise);
    *c = (struct choose_choice){0};
}

enum { TIGHTENINGS = 6 };

/* Makes the record the run that is handed out. */
static void keep_run(struct choose_run *r, struct record *from)
{
    free(r->value);
    r->plan = from->plan;
    r->value = from->value;
    r->cost = from->cost;
    r->seconds = from->seconds;
    memcpy(r->work, from->work, sizeof r->work);
    from->value = NULL;
}

static void refuse_run(struct choose_run *r, const char *why)
{
    char plan[MODELS_TEXT];
    models_write(&r->plan, plan);
    snprintf(r->refusal, sizeof r->refusal, "%s: %s", plan, why);
}

static void refuse_price(struct choose_run *r, const char *what,
                         double price)
{
    char why[CHOOSE_TEXT];
    snprintf(why, sizeof why,
             "%s is beyond reason: %.2g s by the price list, or more", what,
             price);
    refuse_run(r, why);
}

/* Says how far off the run is, and what it held to. */
static void refuse_error(struct chooser *h, struct choose_run *r,
                         const struct record *a, const struct record *b)
{
    char plan[MODELS_TEXT];
    const double e = h->q->tolerance;
    const size_t held = record_agree(&h->view, a, b, e / 2);
    models_write(&r->plan, plan);
    if (r->effect > e)
        snprintf(r->refusal, sizeof r->refusal,
                 "%s leaves out what matters more than %.3g", plan, e);
    else
        snprintf(r->refusal, sizeof r->refusal,
                 "%s is off by %.3g of the scale, more than %.3g; up to t "
                 "= %.10g it holds",
                 plan, r->error, e, until_of(h, held));
}

/* Is its error a sum of two orders? */
static bool is_mixed(const struct chooser *h, struct models_plan plan)
{
    const struct stepping_method *m = plan.model->method;
    return plan.steps > 0 && is_damped(h) && m->order > 2 &&
           m->family == STEPPING_SPLITTING;
}

/* The order by which the error of a run is found from its companion's. */
static int check_order(const struct chooser *h, struct models_plan plan,
                       const struct choose_known *known)
{
    if (plan.steps == 0)
        return 0;
    if (is_mixed(h, plan) && known && known->order > 1)
        return 2;
    if (known && known->order > 0)
        return (int)known->order;
    return known || h->q->scene->contact ? 1 : plan.model->method->order;
}

/* How many steps a companion has where forces jump. */
static uint64_t many(const struct chooser *h, uint64_t times,
                     uint64_t steps)
{
    const uint64_t n = times * (steps > 128 ? steps : 128) + 1;
    return n > h->fine ? n : h->fine + 1;
}

/* A plan that follows all that swings. */
static struct models_plan follow(const struct chooser *h, unsigned cuts)
{
    const double rate = fmax(h->swinging, h->c->acts.fastest);
    struct models_plan plan =
        is_damped(h) ? plan_of("rk4", h->q->every * rate / 0.2)
                     : plan_of("kahan-li8", h->q->every * rate);
    plan.cuts = cuts;
    return plan;
}

/* The plan of the companion. */
static struct models_plan companion(const struct chooser *h,
                                    struct models_plan plan)
{
    const bool contact = h->q->scene->contact;
    if (plan.steps > 0 && is_stiff(h, plan))
        return follow(h, plan.cuts);
    if (plan.steps > 0) {
        const uint64_t least = first_steps(h, plan) + contact;
        const uint64_t finer = (is_mixed(h, plan) ? 4 : 2) * plan.steps;
        const uint64_t n = contact ? many(h, 8, plan.steps) : finer;
        plan.steps = n > least ? n : least;
    }
    return plan;
}

/* The cost of a companion, by that of the run. */
static double foreseen(const struct chooser *h, const struct record *a,
                       const struct record_order *o)
{
    if (a->plan.steps == 0)
        return a->cost;
    if (o->plan.model == a->plan.model)
        return a->cost * (double)o->plan.steps / (double)a->plan.steps;
    return a->cost / a->work[MODELS_EVALUATION] * (double)h->rows *
           (double)o->plan.steps * (double)o->plan.model->method->stages;
}

/* Do forces jump within one of so many steps? */
static bool is_jumping(const struct chooser *h, uint64_t steps)
{
    return h->q->scene->contact || h->turning * h->q->every > (double)steps;
}

/* Do forces change too fast for an order that nobody has seen? */
static bool has_kinks(const struct chooser *h, uint64_t steps)
{
    return is_jumping(h, steps) ||
           (!h->ordered && h->turning > 2 * h->c->fastest);
}

/* Runs the companion of a run. False: no memory. */
static bool run_companion(struct chooser *h, struct record *b,
                          const struct record *a)
{
    struct record_order o = order_of(h, companion(h, a->plan),
                                     fmax(h->q->reason, 10 * a->cost));
    o.converted = a->plan.steps == 0;
    o.watched =
        !o.converted && (h->q->scene->contact || h->q->scene->springs > 0);
    for (;;) {
        if (foreseen(h, a, &o) > o.limit) {
            *b = (struct record){.plan = o.plan,
                                 .end = MODELS_COSTLY,
                                 .cost = foreseen(h, a, &o)};
            return true;
        }
        if (!run(h, b, &o))
            return false;
        const uint64_t steps = o.plan.steps;
        if (o.watched && whole(h, b)) {
            note_watched(h, b);
            h->turning = fmax(h->turning, b->turning);
            if (is_stiff(h, a->plan))
                o.plan = follow(h, a->plan.cuts);
            else if (!sees_passing(h, o.plan))
                o.plan = companion(h, o.plan);
            else if (is_jumping(h, steps))
                o.plan.steps = many(h, 8, a->plan.steps);
        }
        if (o.plan.steps <= steps && o.plan.model == b->plan.model)
            return true;
        record_free(b);
    }
}

/* How far a run is from another one, with so many steps; twice as dear as
   `like` at most. */
static double witness(struct chooser *h, const struct record *a,
                      uint64_t steps, const struct record *like)
{
    struct record other = {0};
    struct record_order o = order_of(h, a->plan, 2 * like->cost);
    o.plan.steps = steps;
    o.halfway = true;
    if (!run(h, &other, &o))
        return INFINITY;
    const double apart = record_apart(&h->view, a, &other, 1, h->rows);
    record_free(&other);
    return apart;
}

/* Compares a run with its companion: half the step, or other units. */
static void check(struct chooser *h, struct choose_run *r,
                  const struct record *a, int order)
{
    struct record b = {0};
    if (!run_companion(h, &b, a))
        return;
    if (b.end == MODELS_COSTLY) {
        const double most = fmax(h->q->reason, 10 * a->cost);
        refuse_price(r, "to check it", fmax(b.cost, most));
        record_free(&b);
        return;
    }
    double apart = record_apart(&h->view, a, &b, 1, h->rows);
    if (a->plan.steps > 0 && is_jumping(h, b.plan.steps))
        apart = fmax(apart, witness(h, a, many(h, 5, a->plan.steps), &b)) +
                witness(h, &b, b.plan.steps, &b);
    r->checked = true;
    r->error = r->effect;
    if (a->plan.steps == 0)
        r->error += rounding * apart + slip(h, a);
    else if (b.plan.model != a->plan.model)
        r->error += margin * apart;
    else
        r->error += error_of(apart, a->plan.steps, b.plan.steps,
                             has_kinks(h, b.plan.steps)
                                 ? 1
                                 : safe_order(b.plan.model->method, order));
    if (!(r->error <= h->q->tolerance))
        refuse_error(h, r, a, &b);
    record_free(&b);
}

/* One attempt. r->error is what was found. */
static void attempt(struct chooser *h, struct choose_run *r, int order)
{
    struct record a = {0};
    const struct record_order o = order_of(h, r->plan, h->q->reason);
    r->error = INFINITY;
    r->refusal[0] = '\0';
    if (!run(h, &a, &o))
        return;
    h->c->deciding -= a.cost;
    if (whole(h, &a)) {
        check(h, r, &a, order);
        keep_run(r, &a);
    } else
        refuse_run(r, ending(&a));
    record_free(&a);
}

/* The steps for another attempt. */
static uint64_t tighter(const struct chooser *h, const struct choose_run *r,
                        int order)
{
    const uint64_t n = r->plan.steps;
    const double target =
        (h->q->tolerance - r->effect) / (h->fine ? margin : safety);
    const uint64_t next =
        isfinite(r->error) && target > 0
            ? extrapolate(n, r->error - r->effect, order, target)
            : 2 * n;
    return next > n ? next : next_steps(n);
}

/* What is left out is measured; a model that is not exact is compared. */
static void find_effect(struct chooser *h, struct choose_run *r,
                        const struct choose_known *known)
{
    struct record a = {0};
    const struct models_model *m = r->plan.model;
    if (known)
        r->effect = known->effect;
    if (known || (r->plan.cuts == 0 && !m->approximate))
        return;
    look_around(h);
    if (h->failed || !h->looked.value) {
        r->effect = INFINITY;
        return;
    }
    r->effect = r->plan.cuts ? effect_of(h, r->plan.cuts) : 0;
    const struct record_order o = order_of(h, r->plan, h->q->reason);
    if (m->approximate && run(h, &a, &o))
        r->effect += seen_from_look(h, &a);
    record_free(&a);
}

/* Learns what a companion has to see. False, with a refusal: that is not
   to be had. */
static bool find_meetings(struct chooser *h, struct choose_run *r,
                          const struct choose_known *known)
{
    h->kinked = true;
    if (known) {
        h->scout.most = known->meeting;
        h->passing = known->passing;
        h->turning = known->turning;
        h->swinging = known->swinging;
        h->fine = known->fine;
        h->kinked = isinf(known->turning);
    } else if (r->plan.steps > 0 && !h->scouted) {
        h->little = 0.01 * h->q->tolerance * h->view.length;
        if (!look_ahead(h))
            refuse_price(r, "to look ahead once", look_price(h));
    }
    if (!h->settled)
        refuse_run(r, "looking ahead does not settle, so no error could "
                      "be trusted");
    return r->refusal[0] == '\0';
}

static void carry_on(struct chooser *h, struct choose_run *r,
                     const struct choose_known *known, bool fixed)
{
    const int order = check_order(h, r->plan, known);
    h->ordered = known && known->order > 1;
    r->error = INFINITY;
    if (overlaps(h, r->refusal))
        return;
    find_effect(h, r, known);
    if (!find_meetings(h, r, known))
        return;
    for (r->tightened = 0; !h->failed; ++r->tightened) {
        attempt(h, r, order);
        if (r->error <= h->q->tolerance || fixed || r->plan.steps == 0 ||
            r->tightened == TIGHTENINGS || h->c->deciding > h->q->reason)
            return;
        const uint64_t next = tighter(h, r, order);
        const double price = r->cost * (double)next / (double)r->plan.steps;
        if (price > h->q->reason)
            return;
        h->c->deciding += r->cost;
        r->cost = 0;
        r->plan.steps = next;
    }
}

static void note_view(struct choose_run *r, struct chooser *h)
{
    r->rows = h->rows;
    r->columns = h->view.columns;
    r->scale = h->c->scale = h->view.scale;
    r->judged = h->view.judged;
}

bool choose_carry(struct choose_run *r, const struct choose_request *q,
                  const struct models_plan *plan,
                  const struct choose_known *known, bool fixed)
{
    struct choose_choice c = {.horizon = INFINITY};
    struct chooser h = {
        .q = q, .c = &c, .rows = rows_of(q), .settled = true};
    *r = (struct choose_run){.plan = *plan};
    if (!record_look(&h.view, q->program, q->scene, q->asked,
                     q->until - q->scene->time))
        return false;
    note_view(r, &h);
    models_analyse(&c.acts, q->scene);
    carry_on(&h, r, known, fixed);
    r->checking = c.deciding;
    end(&h);
    if (h.failed)
        fprintf(stderr, "%s: no memory to carry the scene\n", q->program);
    if (h.failed || r->refusal[0] != '\0') {
        free(r->value);
        r->value = NULL;
    }
    return !h.failed;
}

struct choose_known choose_known(const struct choose_choice *c,
                                 size_t candidate)
{
    const struct choose_candidate *of = &c->candidate[candidate];
    return (struct choose_known){of->effect, of->order,  c->meeting,
                                 c->passing, c->turning, c->swinging,
                                 c->fine};
}

/* Has another candidate promised less than this, s? */
static bool has_rival(const struct choose_choice *c, double cost)
{
    for (size_t j = 0; j < c->candidates; ++j)
        if (j != c->taken && c->candidate[j].cost > 0 &&
            c->candidate[j].cost < cost)
            return true;
    return false;
}

bool choose_again(struct choose_request *q, const struct choose_choice *c,
                  const struct choose_run *r)
{
    const struct choose_candidate *of = &c->candidate[c->taken];
    if (!r->checked || q->only || q->verdicts == CHOOSE_VERDICTS ||
        verdict_of(q, r->plan.model, r->plan.cuts) ||
        (r->value &&
         (r->cost <= worth * of->cost || !has_rival(c, r->cost))))
        return false;
    q->verdict[q->verdicts++] = (struct choose_verdict){
        r->plan, r->error, r->value ? r->cost : INFINITY, of->order};
    q->spent = c->deciding + r->checking + r->cost;
    return true;
}

void choose_run_free(struct choose_run *r)
{
    free(r->value);
    *r = (struct choose_run){0};
}
