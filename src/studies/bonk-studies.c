/* From chapters/works/12-atlas.nw: edit there, then run make tangle. */
/* checksum 1614951627 of the lines below */
/* Maps of cost against true error, for every scene; prices of units. */
#include "enough/choose.h"
#include "scenes/gallery.h"
#include "enough/models.h"
#include "toolbox/bench.h"
#include "toolbox/quad.h"
#include "toolbox/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "bonk-studies"

struct settings {
    const char *scene; /* the only one, or NULL */
};

enum { ROWS = 16, KEYS = 4 };

/* A scene of the atlas: how it is made, and how long it runs. */
struct subject {
    const char *name, *scene;
    double until; /* s */
    struct {
        const char *key;
        double value;
    } set[KEYS];
};

static const struct subject subjects[] = {
    {"cradle", "cradle", 20, {{0}}},
    {"equal-line",
     "cradle",
     10,
     {{"balls", 50}, {"left", 20}, {"gap", 0.02}}},
    {"heavy-cradle", "cradle", 20, {{"first", 2}, {"last", 3}}},
    {"thermal", "thermal", 40, {{0}}},
    {"piston", "piston", 40, {{0}}},
    {"galperin", "galperin", 4, {{"mass-ratio", 10000}}},
    {"four-disks", "four-disks", 4, {{0}}},
    {"four-late", "four-disks", 12, {{0}}},
    {"break", "break", 0.4, {{"offset", 0.003}}},
    {"gas", "gas", 3, {{0}}},
    {"brownian", "brownian", 2, {{0}}},
    {"strings", "cradle", 10, {{"string", 1}}},
    {"sun-earth", "sun-earth", 3652.5, {{0}}},
    {"comet", "sun-earth", 730.5, {{"speed", 0.31622776601683794}}},
    {"solar-system", "solar-system", 4383, {{0}}},
    {"circumbinary", "circumbinary", 456, {{0}}},
    {"choreography", "choreography", 20, {{0}}},
    {"figure-eight", "figure-eight", 20, {{0}}},
    {"ring", "ring", 400, {{"particles", 30}}},
    {"oscillator", "oscillator", 20, {{0}}},
    {"pendulum", "double-pendulum", 8, {{0}}},
    {"stiff-springs",
     "double-pendulum",
     8,
     {{"stiffness1", 5e7}, {"stiffness2", 5e7}}},
    {"membrane", "membrane", 8, {{0}}},
    {"taut-membrane",
     "membrane",
     200,
     {{"free", 0}, {"rest", 0.5}, {"amplitude", 0.0025}, {"damping", 0}}},
    {"cantilever", "cantilever", 8, {{0}}},
    {0}};

_Noreturn static void fail(const char *why)
{
    program_give_up(PROGRAM, "%s", why);
}

static const struct gallery_scene *find_scene(const char *name)
{
    static const struct gallery_scene *const lists[] = {
        celestial_scenes, elastic_scenes, hard_scenes};
    const struct gallery_scene *g = NULL;
    for (size_t k = 0; k < 3 && !g; ++k)
        g = gallery_find(lists[k], name);
    if (!g)
        fail("there is no such scene");
    return g;
}

static void make_scene(struct scene *s, const struct subject *t)
{
    double value[GALLERY_KEYS + 1];
    const struct gallery_scene *g = find_scene(t->scene);
    gallery_usual(g, value);
    for (size_t k = 0; k < KEYS && t->set[k].key; ++k)
        value[gallery_key(g, t->set[k].key)] = t->set[k].value;
    const char *why = g->build(s, value);
    if (why)
        fail(why);
}

/* Where all bodies were, row by row. */
struct path {
    size_t size; /* coordinates: three for each body */
    double *x;   /* [ROWS * size] m */
    double cost; /* s by the price list; INFINITY: it did not begin */
};

static void make_path(struct path *p, const struct scene *s)
{
    p->size = 3 * s->bodies;
    p->x = malloc(ROWS * p->size * sizeof *p->x);
    if (!p->x)
        fail("no memory for a path");
}

/* Runs the plan for at most `limit` seconds by the price list. False: it
   did not come to its end. */
static bool follow(struct path *p, const struct models_plan *plan,
                   const struct scene *s, double every, double limit)
{
    struct models_run r;
    const char *why;
    enum models_end end = MODELS_DONE;
    p->cost = INFINITY;
    if (progress_signal() || !models_begin(&r, plan, s, every, &why))
        return false;
    r.limit = limit;
    for (size_t row = 0; row < ROWS && end == MODELS_DONE; ++row) {
        end = models_row(&r);
        memcpy(p->x + row * p->size, r.scene.position,
               p->size * sizeof *p->x);
    }
    p->cost = models_cost(r.work);
    models_end(&r);
    return end == MODELS_DONE;
}

/* The largest difference of two paths in their first rows, m. */
static double apart(const struct path *a, const struct path *b, size_t rows)
{
    double most = 0;
    for (size_t c = 0; c < rows * a->size; ++c) {
        const double d = fabs(a->x[c] - b->x[c]);
        if (!(d < INFINITY))
            return INFINITY;
        most = fmax(most, d);
    }
    return most;
}

/* What errors of positions are divided by: the diagonal of the box that
   holds all bodies and the walls. */
static double size_of(const struct scene *s)
{
    double square = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double *x = s->position + k * s->bodies;
        double low = s->wall[k] ? s->low[k] : x[0];
        double high = s->wall[k] ? s->high[k] : x[0];
        for (size_t i = 0; i < s->bodies; ++i) {
            low = fmin(low, x[i]);
            high = fmax(high, x[i]);
        }
        square += (high - low) * (high - low);
    }
    return sqrt(square);
}

/* When body i meets another, or a wall, next. */
struct meeting {
    quad t;
    size_t with; /* a body; or bodies + 2 * axis + side */
};

/* Bodies that fly straight between events, all known at the same time. */
struct flight {
    size_t bodies;
    const struct scene *scene;
    quad now, *x, *v; /* [3 * bodies] */
    quad *inverse;    /* [bodies] 1/kg, 0: held */
    struct meeting *next;
};

static quad root(quad square)
{
    quad r = sqrt((double)square);
    for (int k = 0; r > 0 && k < 2; ++k)
        r = (r + square / r) / 2;
    return r;
}

static quad scalar(const struct flight *f, const quad a[], const quad b[],
                   size_t i, size_t j)
{
    quad sum = 0;
    const size_t n = f->bodies;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        sum +=
            (a[k * n + j] - a[k * n + i]) * (b[k * n + j] - b[k * n + i]);
    return sum;
}

/* (5.3, eq:pair-time) */
static quad pair_time(const struct flight *f, size_t i, size_t j)
{
    const struct scene *s = f->scene;
    const quad sigma = (quad)s->radius[i] + s->radius[j];
    const quad b = scalar(f, f->x, f->v, i, j);
    if (b >= 0)
        return INFINITY;
    const quad a = scalar(f, f->v, f->v, i, j);
    const quad c = scalar(f, f->x, f->x, i, j) - sigma * sigma;
    const quad square = b * b - a * c;
    if (square < 0)
        return INFINITY;
    return f->now + (c > 0 ? c / (root(square) - b) : 0);
}

/* (5.1, eq:wall-time) */
static struct meeting wall_time(const struct flight *f, size_t i)
{
    const struct scene *s = f->scene;
    struct meeting first = {INFINITY, 0};
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t c = k * f->bodies + i;
        const bool up = f->v[c] > 0;
        if (s->wall[k] != SCENE_HARD || f->v[c] == 0)
            continue;
        const quad way = up ? s->high[k] - (quad)s->radius[i] - f->x[c]
                            : s->low[k] + (quad)s->radius[i] - f->x[c];
        const quad t = way / f->v[c];
        const quad when = f->now + (t > 0 ? t : 0);
        if (when < first.t)
            first = (struct meeting){when, f->bodies + 2 * k + up};
    }
    return first;
}

static void foresee(struct flight *f, size_t i)
{
    f->next[i] = wall_time(f, i);
    for (size_t j = 0; j < f->bodies; ++j) {
        if (j == i)
            continue;
        const quad t = pair_time(f, i, j);
        if (t < f->next[i].t)
            f->next[i] = (struct meeting){t, j};
        if (t < f->next[j].t)
            f->next[j] = (struct meeting){t, i};
    }
}

static void fly(struct flight *f, quad t)
{
    for (size_t c = 0; c < 3 * f->bodies; ++c)
        f->x[c] += (t - f->now) * f->v[c];
    f->now = t;
}

/* (1.10, eq:impulse) */
static void knock(struct flight *f, size_t i, size_t j)
{
    const size_t n = f->bodies;
    const quad push =
        (1 + (quad)f->scene->restitution) * scalar(f, f->x, f->v, i, j) /
        ((f->inverse[i] + f->inverse[j]) * scalar(f, f->x, f->x, i, j));
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const quad d = f->x[k * n + j] - f->x[k * n + i];
        f->v[k * n + i] += f->inverse[i] * push * d;
        f->v[k * n + j] -= f->inverse[j] * push * d;
    }
}

static void let_happen(struct flight *f, size_t i)
{
    const size_t n = f->bodies, j = f->next[i].with;
    fly(f, f->next[i].t);
    if (j < n)
        knock(f, i, j);
    else {
        const size_t c = (j - n) / 2 * n + i;
        f->v[c] = -f->v[c] * f->scene->restitution;
    }
    for (size_t k = 0; k < n; ++k)
        if (k == i || k == j || f->next[k].with == i ||
            (j < n && f->next[k].with == j))
            foresee(f, k);
}

static size_t find_next(const struct flight *f)
{
    size_t best = 0;
    for (size_t i = 1; i < f->bodies; ++i)
        if (f->next[i].t < f->next[best].t)
            best = i;
    return best;
}

static void take_off(struct flight *f, const struct scene *s)
{
    const size_t n = s->bodies;
    *f = (struct flight){.bodies = n, .scene = s};
    f->x = malloc(7 * n * sizeof *f->x);
    f->next = malloc(n * sizeof *f->next);
    if (!f->x || !f->next)
        fail("no memory for a flight");
    f->v = f->x + 3 * n;
    f->inverse = f->v + 3 * n;
    for (size_t c = 0; c < 3 * n; ++c) {
        f->x[c] = s->position[c];
        f->v[c] = s->freedom[c] ? s->velocity[c] : 0;
    }
    for (size_t i = 0; i < n; ++i) {
        f->inverse[i] = s->freedom[i] ? 1 / (quad)s->mass[i] : 0;
        f->next[i].t = INFINITY;
    }
    for (size_t i = 0; i < n; ++i)
        foresee(f, i);
}

static void follow_events(struct path *p, const struct scene *s,
                          double every)
{
    struct flight f;
    take_off(&f, s);
    for (size_t row = 0; row < ROWS; ++row) {
        const double until = (double)(row + 1) * every;
        for (size_t i; f.next[i = find_next(&f)].t <= until;)
            let_happen(&f, i);
        fly(&f, until);
        for (size_t c = 0; c < p->size; ++c)
            p->x[row * p->size + c] = (double)f.x[c];
    }
    free(f.x);
    free(f.next);
}

/* What is true, and how well that is known. */
struct truth {
    struct path path;
    double scale;  /* of positions, m */
    double unsure; /* share of it by which two ways to find out differ */
};

/* With sums that lose nothing. */
static bool follow_finely(struct path *p, struct models_plan plan,
                          const struct scene *s, double every)
{
    struct scene fine;
    if (!scene_copy(&fine, s))
        fail("no memory for a scene");
    if (!fine.carry)
        fine.carry = calloc(6 * s->bodies, sizeof *fine.carry);
    const bool done = follow(p, &plan, &fine, every, 10);
    scene_free(&fine);
    return done;
}

enum { LEVELS = 3, FIRST = 8, HALVINGS = 20 };

struct column {
    struct path entry[LEVELS];
};

/* From the column before, which has twice the steps' length. */
static void fill_column(struct column *now, const struct column *before,
                        size_t levels, const struct stepping_method *m)
{
    for (size_t j = 1; j < levels; ++j) {
        const int order = m->order + (int)(j - 1) * (m->symmetric ? 2 : 1);
        const double share = 1 / ((double)((uint64_t)1 << order) - 1);
        const double *fine = now->entry[j - 1].x;
        const double *coarse = before->entry[j - 1].x;
        double *x = now->entry[j].x;
        for (size_t c = 0; c < ROWS * now->entry[0].size; ++c)
            x[c] = fine[c] + (fine[c] - coarse[c]) * share;
    }
}

/* Halves the steps until the result no longer changes, or a run costs more
   than the budget, s; fills best, and returns its last change. */
static double converge(struct path *best, const char *method,
                       const struct scene *s, double every, double budget)
{
    struct column column[2];
    double change = INFINITY;
    size_t level = 0;
    for (size_t j = 0; j < 2 * LEVELS; ++j)
        make_path(&column[j / LEVELS].entry[j % LEVELS], s);
    for (int k = 0; k < HALVINGS; ++k) {
        struct column *now = &column[k % 2], *before = &column[1 - k % 2];
        const struct models_plan plan = {.model = models_find(method),
                                         .steps = (uint64_t)FIRST << k};
        const bool whole = follow_finely(&now->entry[0], plan, s, every);
        const size_t levels = !whole           ? 0
                              : level < LEVELS ? level + 1
                                               : LEVELS;
        fill_column(now, before, levels, stepping_find(method));
        if (level > 0 && levels > 0) {
            const struct path *last = &now->entry[levels - 1];
            const double d = apart(last, &before->entry[level - 1], ROWS);
            if (d < change) {
                change = d;
                memcpy(best->x, last->x,
                       ROWS * best->size * sizeof *best->x);
            } else if (change < 1e-9 * size_of(s))
                break;
        }
        if (now->entry[0].cost > budget)
            break;
        level = levels;
    }
    for (size_t j = 0; j < 2 * LEVELS; ++j)
        free(column[j / LEVELS].entry[j % LEVELS].x);
    return change;
}

/* By radau15; returns what a tolerance ten times as fine has changed. */
static double refine_lengths(struct path *best, const struct scene *s,
                             double every)
{
    struct path other;
    make_path(&other, s);
    struct models_plan plan = {
        .model = models_find("radau15"), .steps = 1, .tolerance = 1e-14};
    double change = INFINITY;
    if (follow(&other, &plan, s, every, 10)) {
        plan.tolerance = 1e-15;
        if (follow(best, &plan, s, every, 10))
            change = apart(best, &other, ROWS);
    }
    free(other.x);
    return change;
}

static bool only_contacts(const struct scene *s)
{
    struct models_acts a;
    models_analyse(&a, s);
    return a.contact && !(a.gravity || a.springs || a.weight || a.friction);
}

static void find_truth(struct truth *t, const struct scene *s, double every,
                       double budget)
{
    struct models_acts a;
    struct path other;
    models_analyse(&a, s);
    make_path(&t->path, s);
    t->scale = size_of(s);
    t->unsure = 0;
    if (only_contacts(s))
        follow_events(&t->path, s, every);
    else {
        make_path(&other, s);
        const bool damped = a.friction || a.dashpots;
        const double even = converge(
            &t->path, damped ? "gauss4" : "kahan-li8", s, every, budget);
        const double own = refine_lengths(&other, s, every);
        t->unsure = apart(&t->path, &other, ROWS) / t->scale;
        struct path *const worse = own < even ? &t->path : &other;
        const struct path found = own < even ? other : t->path;
        free(worse->x);
        t->path = found;
    }
}

enum { TOLERANCES = 3, MOST_POINTS = 4000 };
static const double tolerances[TOLERANCES] = {1e-3, 1e-6, 1e-9};

/* A way to carry the scene, and how it went. */
struct point {
    struct models_plan plan;
    double cost, error; /* s by the price list; share of the scale */
    bool front;         /* nothing is both as cheap and as good */
};

/* All of a scene. */
struct map {
    const struct subject *subject;
    struct scene scene;
    double every, limit; /* s; s by the price list */
    struct truth truth;
    struct path path; /* of the last run */
    struct point point[MOST_POINTS];
    size_t points;
};

/* Runs a plan and adds its point. Returns its error, INFINITY if the run
   did not end well. */
static double add_point(struct map *m, struct models_plan plan)
{
    if (m->points == MOST_POINTS)
        fail("there are too many points");
    if (!follow(&m->path, &plan, &m->scene, m->every, m->limit))
        return INFINITY;
    const double error =
        fmax(apart(&m->path, &m->truth.path, ROWS) / m->truth.scale, 1e-17);
    m->point[m->points++] =
        (struct point){plan, m->path.cost, error, false};
    return error;
}

/* One, and then twice as many steps each time, until they no longer help or
   cost too much. Returns the smallest error. */
static double climb(struct map *m, struct models_plan plan)
{
    double best = INFINITY, cost = 0, next = 0;
    int vain = 0;
    for (plan.steps = 1; vain < 2 && next < m->limit; plan.steps *= 2) {
        const double error = add_point(m, plan);
        next = cost > 0 ? 2 * m->path.cost - cost : 0;
        cost = m->path.cost;
        if (error == INFINITY && cost >= m->limit)
            break;
        vain = error > 0.8 * best && best < 0.01 ? vain + 1 : 0;
        best = fmin(best, error);
        if (best < m->truth.unsure || best < 1e-14)
            break;
    }
    return best;
}

/* From a tenth down to 1e-15, or until that no longer helps. */
static void climb_tolerances(struct map *m, struct models_plan plan)
{
    static const double digit[] = {1, 0.5, 0.2};
    double best = INFINITY;
    int vain = 0;
    plan.steps = 1;
    for (int k = 3; k < 46 && vain < 6; ++k) {
        plan.tolerance = digit[k % 3] / pow(10, k / 3);
        const double error = add_point(m, plan);
        if (error == INFINITY && m->path.cost >= m->limit)
            break;
        vain = error > 0.8 * best && best < 0.01 ? vain + 1 : 0;
        best = fmin(best, error);
    }
}

/* Between n/2 and n steps, in sixteenths of n. */
static void refine(struct map *m, struct models_plan plan, double tolerance)
{
    const uint64_t n = plan.steps;
    uint64_t low = 8, high = 16;
    while (n > 2 && low + 1 < high) {
        const uint64_t middle = (low + high) / 2;
        plan.steps = (n * middle + 15) / 16;
        if (add_point(m, plan) <= tolerance)
            high = middle;
        else
            low = middle;
    }
}

static bool is_same(const struct models_plan *a,
                    const struct models_plan *b)
{
    return a->model == b->model && a->cuts == b->cuts;
}

static bool is_a_little_finer(const struct models_plan *a,
                              const struct models_plan *b)
{
    if (a->tolerance > 0)
        return a->tolerance < b->tolerance &&
               a->tolerance >= 0.099 * b->tolerance;
    return a->steps > b->steps && a->steps <= 2 * b->steps;
}

static bool is_luck(const struct map *m, const struct point *p,
                    double tolerance)
{
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *q = &m->point[i];
        if (is_same(&p->plan, &q->plan) && q->error > tolerance &&
            is_a_little_finer(&q->plan, &p->plan))
            return true;
    }
    return false;
}

/* The cheapest that holds of those that are like plan, or, if plan is NULL,
   of all without the model; NULL: none does. */
static const struct point *cheapest_of(const struct map *m,
                                       const struct models_plan *plan,
                                       const struct models_model *without,
                                       double tolerance)
{
    const struct point *best = NULL;
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *p = &m->point[i];
        if (p->error <= tolerance && p->plan.model != without &&
            (!plan || is_same(&p->plan, plan)) &&
            (!best || p->cost < best->cost) && !is_luck(m, p, tolerance))
            best = p;
    }
    return best;
}
static void be_content(struct map *m, const struct models_plan *plan)
{
    const bool exact = plan->model->family != MODELS_STEPS;
    const struct point *fine =
        cheapest_of(m, plan, NULL, exact ? INFINITY : 1e-10);
    if (fine)
        m->limit = fmin(m->limit, fmax(1e-3, 10 * fine->cost));
}

static void climb_finely(struct map *m, struct models_plan plan)
{
    if (plan.model->method->adaptive)
        climb_tolerances(m, plan);
    else
        climb(m, plan);
    be_content(m, &plan);
    for (int k = 0; k < TOLERANCES; ++k) {
        const struct point *p = cheapest_of(m, &plan, NULL, tolerances[k]);
        const struct point *all = cheapest_of(m, NULL, NULL, tolerances[k]);
        if (p && p->plan.tolerance == 0 && p->cost < 2 * all->cost)
            refine(m, p->plan, tolerances[k]);
    }
}

static bool is_front(const struct map *m, const struct point *p)
{
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *q = &m->point[i];
        if (q->cost <= p->cost && q->error <= p->error &&
            (q->cost < p->cost || q->error < p->error))
            return false;
    }
    return true;
}

static bool is_plain(const struct point *p, enum models_family family)
{
    return p->plan.cuts == 0 && p->plan.model->family == family;
}

/* The cheapest plain way to 1e-11, or to twice the least error of all such;
   NULL: there is none. */
static const struct point *finest(const struct map *m)
{
    const struct point *best = NULL;
    const enum models_family f =
        only_contacts(&m->scene) ? MODELS_EVENTS : MODELS_STEPS;
    double least = INFINITY;
    for (size_t i = 0; i < m->points; ++i)
        if (is_plain(&m->point[i], f))
            least = fmin(least, m->point[i].error);
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *p = &m->point[i];
        if (is_plain(p, f) && p->error <= fmax(1e-11, 2 * least) &&
            (!best || p->cost < best->cost))
            best = p;
    }
    return best;
}

static struct point halved(const struct map *m, double tolerance)
{
    const bool events = only_contacts(&m->scene);
    const struct models_model *leapfrog = models_find("leapfrog");
    struct point best = {.cost = INFINITY, .error = INFINITY};
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *p = &m->point[i];
        const uint64_t n = p->plan.steps;
        if (p->plan.cuts == 0 &&
            (events ? p->plan.model->family == MODELS_EVENTS
                    : p->plan.model == leapfrog && (n & (n - 1)) == 0) &&
            p->error < best.error && best.error > tolerance)
            best = *p;
    }
    for (; !events && best.error > tolerance; best.error /= 4) {
        best.cost *= 2;
        best.plan.steps *= 2;
    }
    return best;
}

/* All models with steps, or all others, with these cuts. */
static void try_models(struct map *m, unsigned cuts, bool steps)
{
    size_t k = 0;
    while (models_all()[k].name)
        ++k;
    while (k-- > 0) {
        const struct models_plan plan = {
            .model = &models_all()[k], .cuts = cuts, .steps = steps};
        if ((plan.model->family == MODELS_STEPS) != steps ||
            models_refuse(&plan, &m->scene))
            continue;
        if (steps)
            climb_finely(m, plan);
        else if (add_point(m, plan) < INFINITY && !plan.model->approximate)
            be_content(m, &plan);
    }
}

static void try_cuts(struct map *m)
{
    const unsigned all = models_cuts(&m->scene);
    const struct point *fine = finest(m);
    for (unsigned cuts = 1; fine && cuts <= all; ++cuts) {
        struct models_plan plan = fine->plan;
        plan.cuts = cuts;
        if (cuts & ~all)
            continue;
        try_models(m, cuts, false);
        if ((cuts & MODELS_RODS) || (!models_refuse(&plan, &m->scene) &&
                                     add_point(m, plan) < tolerances[0]))
            try_models(m, cuts, true);
    }
}

/* What was picked for a tolerance, and how it did. */
struct pick {
    struct point point; /* cost NAN: refused */
    double deciding;    /* s by the price list */
    double horizon;     /* s; INFINITY: none was met */
};

static void take_pick(struct pick *p, struct map *m, const struct record *r)
{
    if (!r->value || !follow(&m->path, &r->plan, &m->scene, m->every, 100))
        return;
    p->point = (struct point){
        r->plan, m->path.cost,
        fmax(apart(&m->path, &m->truth.path, ROWS) / m->truth.scale, 1e-17),
        false};
}

static void ask(struct pick *p, struct map *m, double tolerance)
{
    const struct choose_request q = {.scene = &m->scene,
                                     .program = PROGRAM,
                                     .until = ROWS * m->every,
                                     .every = m->every,
                                     .tolerance = tolerance,
                                     .reason = CHOOSE_REASON};
    struct choose_choice c;
    *p = (struct pick){.point = {.cost = NAN, .error = NAN}};
    if (!choose(&c, &q))
        fail("no memory to choose");
    p->deciding = c.spent - c.run.cost;
    p->horizon = c.horizon;
    take_pick(p, m, &c.run);
    choose_free(&c);
}

static void write_way(const struct point *p, struct table *out)
{
    char text[MODELS_TEXT] = "-";
    if (p)
        models_write(&p->plan, text);
    table_print(out, " %s %.3g %.4g", text, p ? p->error : NAN,
                p ? p->cost : NAN);
}

static void write_pick(const struct map *m, const struct pick *p, int k,
                       struct table *out)
{
    const bool granted = p->point.cost > 0;
    const struct point *best = cheapest_of(m, NULL, NULL, tolerances[k]);
    const struct models_model *model = granted ? p->point.plan.model
                                       : best  ? best->plan.model
                                               : NULL;
    table_print(out, "%s-%d", m->subject->name, 3 + 3 * k);
    write_way(granted ? &p->point : NULL, out);
    write_way(best, out);
    write_way(cheapest_of(m, NULL, model, tolerances[k]), out);
    write_way(finest(m), out);
    const struct point classic = halved(m, tolerances[k]);
    write_way(&classic, out);
    table_print(out, " %.4g %.4g\n", p->deciding, p->horizon);
}

static int cheaper(const void *one, const void *other)
{
    const struct point *a = one, *b = other;
    return a->cost != b->cost
               ? (a->cost < b->cost ? -1 : 1)
               : (a->error > b->error) - (a->error < b->error);
}

static void write_points(const struct map *m, struct table *out)
{
    enum { OFF = 30 };
    for (size_t i = 0; i < m->points; ++i) {
        const struct point *p = &m->point[i];
        if (!(p->error < OFF))
            continue;
        table_print(out, "%s %d", m->subject->name, p->front);
        write_way(p, out);
        table_print(out, "\n");
    }
}

static void write_head(struct table *out)
{
    table_print(out,
                "# picks: name and digits of the tolerance; then plan, "
                "error, cost (s)\n");
    table_print(out, "# of the pick, of the cheapest that holds, of the "
                     "cheapest with another\n");
    table_print(out, "# model, of the finest plain way, of the classic "
                     "method with steps halved;\n");
    table_print(out, "# what deciding cost (s); the horizon (s)\n");
    table_print(out, "# others: name; 1 if on the front; plan, error, "
                     "cost\n");
}

/* A run with much of one unit, and little of the others. */
struct bout {
    const char *name, *key;
    double value;
    const char *plan;
    double every;
    uint64_t rows;
};

static const struct bout bouts[MODELS_UNITS] = {
    [MODELS_EVALUATION] = {"sun-earth", NULL, 0, "kahan-li8:1000", 10, 10},
    [MODELS_BODY] = {"ring", "particles", 500, "kahan-li8:40", 1, 10},
    [MODELS_PAIR] = {"choreography", "particles", 24, "pefrl:100", 0.1, 10},
    [MODELS_SPRING] = {"cantilever", "nx", 8, "pefrl:100", 0.001, 10},
    [MODELS_ROD] = {"double-pendulum", NULL, 0, "leapfrog:2000,rods", 1,
                    10},
    [MODELS_CONTACT] = {"cradle", "balls", 100, "leapfrog:1000", 1, 2},
    [MODELS_OVERLAP] = {"gas", NULL, 0, "leapfrog:100", 0.1, 4},
    [MODELS_CURVE] = {"gas", "particles", 60, "radau15:1e-6", 0.1, 10},
    [MODELS_ROOT] = {"thermal", "particles", 30, "radau15:1e-6", 0.1, 40},
    [MODELS_LINE_EVENT] = {"cradle", "balls", 2, "line", 1000, 10},
    [MODELS_LINE_SCAN] = {"thermal", "particles", 30, "line", 100, 10},
    [MODELS_DISK_EVENT] = {"four-disks", NULL, 0, "disks", 100, 10},
    [MODELS_DISK_SCAN] = {"gas", "particles", 90, "disks", 10, 10},
    [MODELS_RENEWAL] = {"gas", "particles", 120, "disks", 20, 10},
    [MODELS_ELLIPSE] = {"sun-earth", NULL, 0, "kepler", 10, 20000},
    [MODELS_FLIGHT] = {"ring", "particles", 500, "free", 1, 200},
    [MODELS_ORDER] = {"cradle", "balls", 1000, "relabel", 1, 50},
    [MODELS_MODE] = {"cantilever", "nx", 12, "modes", 1, 2},
    [MODELS_ROW] = {"cradle", "balls", 2, "relabel", 1, 20000},
};
/* Makes the run, and returns what it has taken, s. Bodies that are alone do
   not attract each other. */
static double run_bout(const struct bout *b, bool alone,
                       double work[MODELS_UNITS])
{
    char message[MODELS_MESSAGE];
    struct models_plan plan;
    struct models_run r;
    struct scene s;
    const char *why =
        gallery_make(&s, find_scene(b->name), b->key, b->value);
    if (why || !models_read(&plan, b->plan, message))
        fail(why ? why : message);
    s.k2 = alone ? 0 : s.k2;
    const double begin = bench_seconds();
    if (!models_begin(&r, &plan, &s, b->every, &why))
        fail(why);
    while (r.rows < b->rows)
        if (models_row(&r) != MODELS_DONE)
            fail("a run that measures a price has not come to its end");
    const double seconds = bench_seconds() - begin;
    memcpy(work, r.work, sizeof r.work);
    models_end(&r);
    scene_free(&s);
    return seconds;
}

/* What a unit costs if the others cost what the list says, ns. */
static double price_in(const struct bout *b, enum models_unit unit)
{
    double work[MODELS_UNITS];
    const bool alone = strcmp(b->name, "ring") == 0;
    const double seconds = run_bout(b, alone, work), units = work[unit];
    work[unit] = 0;
    return (seconds - models_cost(work)) / units * 1e9;
}

/* Whole runs, short ones as well, whose bill has to be about right: of many
   bodies the start and the rows are a part of it. */
static const struct bout whole_runs[] = {
    {"gas", "particles", 100, "disks", 1e-4, 16},
    {"gas", "particles", 100, "disks", 0.5, 16},
    {"gas", "radius", 0.03, "disks", 0.5, 16},
    {"gas", "radius", 0.15, "disks", 0.5, 16},
    {"gas", "particles", 500, "disks", 1e-4, 16},
    {"gas", "particles", 500, "disks", 0.1, 16},
    {"ring", "particles", 100, "leapfrog:3,no-light", 25, 16},
    {"ring", "particles", 1000, "leapfrog:1,no-light", 25, 16},
    {"ring", "particles", 100, "leapfrog:3", 25, 16},
    {0}};

static void explore(struct map *m, const struct subject *t)
{
    *m = (struct map){.subject = t, .every = t->until / ROWS, .limit = 0.2};
    make_scene(&m->scene, t);
    make_path(&m->path, &m->scene);
    find_truth(&m->truth, &m->scene, m->every, 0.3);
    try_models(m, 0, false);
    try_models(m, 0, true);
    try_cuts(m);
    for (size_t i = 0; i < m->points; ++i)
        m->point[i].front = is_front(m, &m->point[i]);
    qsort(m->point, m->points, sizeof m->point[0], cheaper);
}

static bool is_refusal_right(struct map *m, const struct pick *p,
                             double tolerance)
{
    const struct point *most = finest(m);
    const double rows = p->horizon / m->every + 1e-9;
    if (cheapest_of(m, NULL, NULL, tolerance))
        return false;
    if (!most || !(rows < ROWS))
        return true;
    return follow(&m->path, &most->plan, &m->scene, m->every, 100) &&
           apart(&m->path, &m->truth.path, (size_t)rows) <=
               tolerance * m->truth.scale;
}

/* 0: well; 1: it does not hold; 2: too dear; 3: wrongly refused. */
static int judge(struct map *m, const struct pick *p, double tolerance)
{
    const struct point *best = cheapest_of(m, NULL, NULL, tolerance);
    if (!(p->point.cost > 0))
        return is_refusal_right(m, p, tolerance) ? 0 : 3;
    if (!(p->point.error <= tolerance))
        return 1;
    return best && p->point.cost > 1.13 * best->cost ? 2 : 0;
}

static void write_map(struct map *m, struct study *s, size_t faults[4])
{
    for (int k = 0; k < TOLERANCES; ++k) {
        struct pick pick;
        ask(&pick, m, tolerances[k]);
        write_pick(m, &pick, k, s->out);
        ++faults[judge(m, &pick, tolerances[k])];
    }
    write_points(m, s->out);
}

static void write_summary(const size_t faults[4], double unsure,
                          struct table *out)
{
    table_real(out, "unsure", unsure);
    table_count(out, "good", faults[0]);
    table_count(out, "beyond", faults[1]);
    table_count(out, "dear", faults[2]);
    table_count(out, "refused", faults[3]);
}

static const struct table_key atlas_keys[] = {
    {"unsure", "1", "error of the truth, largest"},
    {"good", "1", "choices"},
    {"beyond", "1", "choices beyond the tolerance"},
    {"dear", "1", "more than 1.13 times the cheapest"},
    {"refused", "1", "wrongly"},
    {0}};

static void study_atlas(struct study *s)
{
    const struct settings *own = s->own;
    static struct map m;
    size_t faults[4] = {0};
    double unsure = 0;
    write_head(s->out);
    for (size_t i = 0; subjects[i].name && !progress_signal(); ++i) {
        if (own->scene && strcmp(own->scene, subjects[i].name) != 0)
            continue;
        explore(&m, &subjects[i]);
        write_map(&m, s, faults);
        unsure = fmax(unsure, m.truth.unsure);
        free(m.truth.path.x);
        free(m.path.x);
        scene_free(&m.scene);
    }
    table_print(s->out,
                "#= unsure %.3g\n#= good %zu\n#= beyond %zu\n"
                "#= dear %zu\n#= refused %zu\n",
                unsure, faults[0], faults[1], faults[2], faults[3]);
    write_summary(faults, unsure, s->summary);
}

static void study_scenes(struct study *s)
{
    for (size_t i = 0; subjects[i].name; ++i)
        table_print(s->out, "%s\n", subjects[i].name);
}

static void study_prices(struct study *s)
{
    bench_machine(s->out);
    table_print(s->out,
                "# unit, price in the list (ns), measured, ratio\n");
    for (int k = 0; k < MODELS_UNITS && !progress_signal(); ++k) {
        double value[BENCH_ROUNDS];
        for (int round = -1; round < BENCH_ROUNDS; ++round)
            value[round < 0 ? 0 : round] =
                price_in(&bouts[k], (enum models_unit)k);
        const double found = bench_median(value, BENCH_ROUNDS);
        table_print(s->out, "%s %.3g %.3g %.3g\n", models_prices[k].name,
                    models_prices[k].ns, found,
                    found / models_prices[k].ns);
    }
    table_print(s->out,
                "# whole runs: scene, plan, bill (s), seconds over bill\n");
    for (const struct bout *b = whole_runs; b->name; ++b) {
        double value[BENCH_ROUNDS], work[MODELS_UNITS];
        for (int round = -1; round < BENCH_ROUNDS; ++round)
            value[round < 0 ? 0 : round] = run_bout(b, false, work);
        const double bill = models_cost(work);
        table_print(s->out, "# %s/%s=%g %s %.3g %.2f\n", b->name, b->key,
                    b->value, b->plan, bill,
                    bench_median(value, BENCH_ROUNDS) / bill);
    }
}

static void take_option(struct options *o, int letter, void *own)
{
    struct settings *s = own;
    (void)letter;
    s->scene = options_text(o);
}

int main(int argc, char *argv[])
{
    static const struct study_entry studies[] = {
        {"atlas", study_atlas, "error and cost of all models", atlas_keys},
        {"scenes", study_scenes, "the scenes of the atlas", NULL},
        {"prices", study_prices, "what the units of cost cost here", NULL},
        {0}};
    static const struct options_entry own[] = {
        {"", 0, NULL, "--study atlas"},
        {"scene", 'c', "NAME", "this scene only"},
        {0}};
    struct settings settings = {0};
    const struct study_program p = {.name = PROGRAM,
                                    .purpose = "Measure what is enough.",
                                    .events = "runs",
                                    .studies = studies,
                                    .options = own,
                                    .take = take_option,
                                    .own = &settings};
    return study_main(&p, argc, argv);
}
