/* Maps cost against error for all scenes and measures the price list. */
#include "choosing/choose.h"
#include "scenes/gallery.h"
#include "toolbox/bench.h"
#include "toolbox/quad.h"
#include "toolbox/study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "bonk-studies"

static struct {
    const char *scene; /* scene to map, or NULL for all */
} own;

enum { ROWS = 16, KEYS = 4 };

/* A scene of the atlas: its name on the map, its name in the gallery, its
   duration, and the values that differ from the gallery's defaults. */
struct subject {
    const char *name, *scene;
    double until; /* s */
    struct {
        const char *key;
        double value;
    } set[KEYS];
};

/* The scenes of the atlas. Times of celestial scenes are in days. In
   `break` the cue ball is shifted slightly, because a ball that hits two
   others at the same instant has no unique outcome. The comet starts at
   aphelion with sqrt(0.1) times the circular speed, so its orbit has
   eccentricity 0.9. */
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

/* Finds a scene in the three lists of the gallery. */
static const struct gallery_scene *find_scene(const char *name)
{
    static const struct gallery_scene *const lists[] = {
        celestial_scenes, elastic_scenes, hard_scenes};
    const struct gallery_scene *g = NULL;
    for (size_t k = 0; k < 3 && !g; ++k)
        g = gallery_find(lists[k], name);
    if (!g)
        program_give_up("there is no such scene");
    return g;
}

/* Makes the scene of t: the values of t->set, and the gallery's defaults
   for all other keys. */
static void make_scene(struct scene *s, const struct subject *t)
{
    double value[GALLERY_KEYS + 1];
    const struct gallery_scene *g = find_scene(t->scene);
    gallery_usual(g, value);
    for (size_t k = 0; k < KEYS && t->set[k].key; ++k)
        value[gallery_key(g, t->set[k].key)] = t->set[k].value;
    program_check(g->build(s, value));
}

/* The positions of all bodies at ROWS equally spaced times. Velocities are
   not stored, because an error in a velocity shows up in the positions of
   the next row. */
struct path {
    size_t size; /* coordinates in a row: 3 per body */
    double *x;   /* [ROWS * size] m */
    double cost; /* estimated, s; INFINITY if the run never began */
};

static void make_path(struct path *p, const struct scene *s)
{
    p->size = 3 * s->bodies;
    p->x = malloc(ROWS * p->size * sizeof *p->x);
    program_memory(p->x, "for a path");
}

/* Runs a plan until it finishes or its estimated cost exceeds `limit`
   seconds. Fills p with the cost and with the rows reached. Returns whether
   the run finished. */
static bool run_plan(struct path *p, const struct models_plan *plan,
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

/* Returns the largest difference between coordinates in the first `rows`
   rows of two paths (in m), or INFINITY if a difference is not finite. */
static double distance(const struct path *a, const struct path *b,
                       size_t rows)
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

/* Returns the diagonal of the box that contains all bodies and walls, m.
   Position errors are divided by this length. The program under test has
   such a function, too; it is not used here, so that a mistake in either
   function shows up as a disagreement. */
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

/* The next collision of a body. */
struct meeting {
    quad t;
    size_t with; /* body, or bodies + 2 * axis + side for a wall */
};

/* Hard bodies that move in straight lines between events. They give the
   true path, in 113-bit arithmetic, of scenes in which only contacts act.
   The simulation is as simple as possible: all positions refer to the same
   time, each body stores only its next collision, and there is no calendar
   or grid. It also serves for bodies on a line, where the square root of
   (5.3, eq:pair-time) is exact. */
struct flight {
    size_t bodies;
    const struct scene *scene;
    quad now, *x, *v; /* [3 * bodies] */
    quad *inverse;    /* [bodies] 1/kg; 0: fixed */
    struct meeting *next;
};

/* Returns the scalar product (a_j - a_i) . (b_j - b_i), which occurs in all
   collision equations. a and b are positions or velocities of all
   bodies. */
static quad scalar_product(const struct flight *f, const quad a[],
                           const quad b[], size_t i, size_t j)
{
    quad sum = 0;
    const size_t n = f->bodies;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        sum +=
            (a[k * n + j] - a[k * n + i]) * (b[k * n + j] - b[k * n + i]);
    return sum;
}

/* Returns the time at which bodies i and j collide, or INFINITY if they
   miss each other (5.3, eq:pair-time). */
static quad pair_time(const struct flight *f, size_t i, size_t j)
{
    const struct scene *s = f->scene;
    const quad sigma = (quad)s->radius[i] + s->radius[j];
    const quad b = scalar_product(f, f->x, f->v, i, j);
    if (b >= 0)
        return INFINITY;
    const quad a = scalar_product(f, f->v, f->v, i, j);
    const quad c = scalar_product(f, f->x, f->x, i, j) - sigma * sigma;
    const quad square = b * b - a * c;
    if (square < 0)
        return INFINITY;
    return f->now + (c > 0 ? c / (quad_root(square) - b) : 0);
}

/* Returns the first collision of body i with a wall (5.1, eq:wall-time). If
   rounding has put the body beyond a wall, the collision is immediate. */
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

/* Finds the next collision of body i. Also updates each body that would
   collide with body i before its own next collision. */
static void predict(struct flight *f, size_t i)
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

static void move_to(struct flight *f, quad t)
{
    for (size_t c = 0; c < 3 * f->bodies; ++c)
        f->x[c] += (t - f->now) * f->v[c];
    f->now = t;
}

/* Applies the impulse of a collision of i and j along their line of centres
   (1.10, eq:impulse). A fixed body has inverse mass 0 and stays at rest. */
static void collide(struct flight *f, size_t i, size_t j)
{
    const size_t n = f->bodies;
    const quad push = (1 + (quad)f->scene->restitution) *
                      scalar_product(f, f->x, f->v, i, j) /
                      ((f->inverse[i] + f->inverse[j]) *
                       scalar_product(f, f->x, f->x, i, j));
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const quad d = f->x[k * n + j] - f->x[k * n + i];
        f->v[k * n + i] += f->inverse[i] * push * d;
        f->v[k * n + j] -= f->inverse[j] * push * d;
    }
}

/* Moves all bodies to the next event, which is that of body i, and carries
   it out. Then predicts new collisions for the bodies involved and for all
   bodies whose next collision was with one of them. */
static void handle_event(struct flight *f, size_t i)
{
    const size_t n = f->bodies, j = f->next[i].with;
    move_to(f, f->next[i].t);
    if (j < n)
        collide(f, i, j);
    else {
        const size_t c = (j - n) / 2 * n + i;
        f->v[c] = -f->v[c] * f->scene->restitution;
    }
    for (size_t k = 0; k < n; ++k)
        if (k == i || k == j || f->next[k].with == i ||
            (j < n && f->next[k].with == j))
            predict(f, k);
}

static size_t find_next(const struct flight *f)
{
    size_t best = 0;
    for (size_t i = 1; i < f->bodies; ++i)
        if (f->next[i].t < f->next[best].t)
            best = i;
    return best;
}

/* Starts a flight. Treats the scene's doubles as exact, because their
   rounding is not an error of a method. */
static void begin_flight(struct flight *f, const struct scene *s)
{
    const size_t n = s->bodies;
    *f = (struct flight){.bodies = n, .scene = s};
    f->x = malloc(7 * n * sizeof *f->x);
    f->next = malloc(n * sizeof *f->next);
    program_memory(f->x && f->next, "for a flight");
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
        predict(f, i);
}

/* Fills p with the true path, computed in 113-bit arithmetic and rounded to
   double only when stored. */
static void run_events(struct path *p, const struct scene *s, double every)
{
    struct flight f;
    begin_flight(&f, s);
    for (size_t row = 0; row < ROWS; ++row) {
        const double until = (double)(row + 1) * every;
        for (size_t i; f.next[i = find_next(&f)].t <= until;)
            handle_event(&f, i);
        move_to(&f, until);
        for (size_t c = 0; c < p->size; ++c)
            p->x[row * p->size + c] = (double)f.x[c];
    }
    free(f.x);
    free(f.next);
}

/* The true path and its uncertainty. */
struct truth {
    struct path path;
    double scale;  /* unit of errors, m */
    double unsure; /* difference of two computed paths, in units of scale */
};

/* Runs a plan with compensated summation, which is used for every scene
   that has `carry` arrays. If s has none, runs a copy of s with carries of
   zero. */
static bool run_with_carries(struct path *p, struct models_plan plan,
                             const struct scene *s, double every)
{
    struct scene fine;
    program_memory(scene_copy(&fine, s), "for a scene");
    if (!fine.carry)
        fine.carry = calloc(6 * s->bodies, sizeof *fine.carry);
    const bool done = run_plan(p, &plan, &fine, every, 10);
    scene_free(&fine);
    return done;
}

enum { LEVELS = 3, FIRST = 8, HALVINGS = 20 };

/* A column of a Richardson table. Entry 0 is the path of a run. Each
   further entry is more accurate by one term of the error. */
struct column {
    struct path entry[LEVELS];
};

/* Fills a column from its run and from the previous column, whose steps are
   twice as long, by Richardson extrapolation. A run of order p with steps h
   ends at x(h) = x + a h^p + b h^q + ..., so

   x(h/2) + (x(h/2) - x(h)) / (2^p - 1) = x + b' h^q + ...

   The next entry removes the term h^q in the same way. For a symmetric
   method q = p + 2, because the error is the same for h and -h. Otherwise q
   = p + 1. */
static void fill_column(struct column *now, const struct column *before,
                        size_t levels, const struct stepping_method *m)
{
    for (size_t j = 1; j < levels; ++j) {
        const int order = m->order + (int)(j - 1) * (m->symmetric ? 2 : 1);
        const double factor = 1 / ((double)((uint64_t)1 << order) - 1);
        const double *fine = now->entry[j - 1].x;
        const double *coarse = before->entry[j - 1].x;
        double *x = now->entry[j].x;
        for (size_t c = 0; c < ROWS * now->entry[0].size; ++c)
            x[c] = fine[c] + (fine[c] - coarse[c]) * factor;
    }
}

/* Fills best with the extrapolated path that changed least from one halving
   of the steps to the next, and returns this change, m. Stops if a run
   costs more than `budget` seconds. Also stops if the change grows once the
   result has nine correct digits, because the growth is then due to
   rounding. If a run fails because its steps are too long, the table starts
   again with the next run. */
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
        const bool whole = run_with_carries(&now->entry[0], plan, s, every);
        const size_t levels = !whole           ? 0
                              : level < LEVELS ? level + 1
                                               : LEVELS;
        fill_column(now, before, levels, stepping_find(method));
        if (level > 0 && levels > 0) {
            const struct path *last = &now->entry[levels - 1];
            const double d =
                distance(last, &before->entry[level - 1], ROWS);
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

/* Fills best with a run of radau15, which chooses its own step lengths, at
   tolerance 1e-15. Returns the largest difference from a run at tolerance
   1e-14, m. */
static double refine_lengths(struct path *best, const struct scene *s,
                             double every)
{
    struct path other;
    make_path(&other, s);
    struct models_plan plan = {
        .model = models_find("radau15"), .steps = 1, .tolerance = 1e-14};
    double change = INFINITY;
    if (run_plan(&other, &plan, s, every, 10)) {
        plan.tolerance = 1e-15;
        if (run_plan(best, &plan, s, every, 10))
            change = distance(best, &other, ROWS);
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

/* Finds the true path. If only contacts act, it is computed from events in
   113-bit arithmetic. Otherwise two very different methods compute it:
   extrapolation of runs with equal steps, and radau15, whose steps vary.
   The path that changed less in its last refinement is used. Its distance
   from the other path is its uncertainty.

   The equal steps are symmetric: kahan-li8, or gauss4 if there is friction,
   which kahan-li8 cannot integrate. */
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
        run_events(&t->path, s, every);
    else {
        make_path(&other, s);
        const bool damped = a.friction || a.dashpots;
        const double even = converge(
            &t->path, damped ? "gauss4" : "kahan-li8", s, every, budget);
        const double own = refine_lengths(&other, s, every);
        t->unsure = distance(&t->path, &other, ROWS) / t->scale;
        struct path *const worse = own < even ? &t->path : &other;
        const struct path found = own < even ? other : t->path;
        free(worse->x);
        t->path = found;
    }
}

enum { TOLERANCES = 3, MOST_POINTS = 4000 };
static const double tolerances[TOLERANCES] = {1e-3, 1e-6, 1e-9};

/* A plan with its cost and its error. */
struct point {
    struct models_plan plan;
    double cost, error; /* estimated, s; in units of truth.scale */
    bool front;         /* on the Pareto front (is_front) */
};

/* The points and the true path of a scene. */
struct map {
    const struct subject *subject;
    struct scene scene;
    double every; /* time between two rows, s */
    double limit; /* maximum estimated cost of a run, s */
    struct truth truth;
    struct path path; /* path of the last run */
    struct point point[MOST_POINTS];
    size_t points;
};

/* Returns the error of the last run. Errors below 1e-17 are raised to
   1e-17, because the map has logarithmic axes and ends there. */
static double error_of(const struct map *m)
{
    return fmax(distance(&m->path, &m->truth.path, ROWS) / m->truth.scale,
                1e-17);
}

/* Runs a plan and adds its point to the map. Returns its error, or INFINITY
   if the run did not finish. */
static double add_point(struct map *m, struct models_plan plan)
{
    if (m->points == MOST_POINTS)
        program_give_up("there are too many points");
    if (!run_plan(&m->path, &plan, &m->scene, m->every, m->limit))
        return INFINITY;
    const double error = error_of(m);
    m->point[m->points++] =
        (struct point){plan, m->path.cost, error, false};
    return error;
}

/* Runs a plan with 1, 2, 4, ... steps per row and returns the smallest
   error. Stops if two doublings have not helped: the remaining error then
   comes from rounding, from a cut, or from the uncertainty of the truth.
   Also stops if the next run would exceed the cost limit. The cost of that
   run is predicted from the rule that each doubling adds at least as much
   cost as the previous one. */
static double double_steps(struct map *m, struct models_plan plan)
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

/* Runs a method with variable steps with lower and lower tolerances until
   the error no longer decreases. The tolerances are 1, 0.5 and 0.2 times
   powers of ten, from 0.1 to 1e-15. */
static void lower_tolerance(struct map *m, struct models_plan plan)
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

/* Finds by bisection how many steps, between n/2 and n = plan.steps, are
   needed to meet the tolerance. The result is accurate to n/16. Adds the
   points of all runs to the map. */
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

/* Returns whether two plans have the same model and the same cuts, which
   are the parts of the physics that they leave out. */
static bool is_same(const struct models_plan *a,
                    const struct models_plan *b)
{
    return a->model == b->model && a->cuts == b->cuts;
}

/* Returns whether plan a is slightly finer than b: it has more steps, but
   at most twice as many, or a smaller tolerance, but at least a tenth of
   b's. */
static bool is_a_little_finer(const struct models_plan *a,
                              const struct models_plan *b)
{
    if (a->tolerance > 0)
        return a->tolerance < b->tolerance &&
               a->tolerance >= 0.099 * b->tolerance;
    return a->steps > b->steps && a->steps <= 2 * b->steps;
}

/* Returns whether p meets the tolerance only by luck, that is, whether a
   slightly finer run of the same model and cuts fails. Luck is possible
   because the error may change sign as the steps get shorter: 144 steps may
   meet a tolerance that 160 do not. Therefore a number of steps is accepted
   only if all larger numbers on the map, up to twice as many, also meet the
   tolerance. */
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

/* Returns the cheapest point that meets the tolerance, and not by luck, or
   NULL if there is none. If plan is not NULL, considers only points with
   its model and cuts. Ignores points of the model `without`. */
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
/* Lowers the cost limit of all further runs to ten times the cost of this
   model, if the model is exact or has reached an error of 1e-10. */
static void lower_limit(struct map *m, const struct models_plan *plan)
{
    const bool exact = plan->model->family != MODELS_STEPS;
    const struct point *fine =
        cheapest_of(m, plan, NULL, exact ? INFINITY : 1e-10);
    if (fine)
        m->limit = fmin(m->limit, fmax(1e-3, 10 * fine->cost));
}

/* Adds the points of a model that makes steps. For each tolerance, refines
   the model's cheapest point if it costs less than twice the cheapest point
   on the map. */
static void try_steps(struct map *m, struct models_plan plan)
{
    if (plan.model->method->adaptive)
        lower_tolerance(m, plan);
    else
        double_steps(m, plan);
    lower_limit(m, &plan);
    for (int k = 0; k < TOLERANCES; ++k) {
        const struct point *p = cheapest_of(m, &plan, NULL, tolerances[k]);
        const struct point *all = cheapest_of(m, NULL, NULL, tolerances[k]);
        if (p && p->plan.tolerance == 0 && p->cost < 2 * all->cost)
            refine(m, p->plan, tolerances[k]);
    }
}

/* Returns whether p is on the Pareto front: no other point is at least as
   cheap and at least as accurate, and better in one of the two. */
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

/* Returns whether a point is plain: its plan has no cuts, and its model
   belongs to `family`. Users who do not compare models choose such a plan,
   with events if only contacts act and otherwise with steps. */
static bool is_plain(const struct point *p, enum models_family family)
{
    return p->plan.cuts == 0 && p->plan.model->family == family;
}

/* Returns the cheapest plain point with an error of at most 1e-11, or NULL
   if there is no plain point. If twice the smallest error of all plain
   points is larger than 1e-11, this is the limit instead: four disks do not
   reach 1e-11. */
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

/* Returns the point of the classic method: events, or leapfrog with steps
   halved until the tolerance is met. If no leapfrog run on the map meets
   the tolerance, extrapolates: leapfrog is of second order, so twice as
   many steps have a quarter of the error. */
static struct point classic_way(const struct map *m, double tolerance)
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

/* Tries all models with these cuts: if `steps`, the models that make steps,
   and otherwise all others. Starts with the last models of the table, which
   are of high order. They soon lower the cost limit, which keeps the runs
   of low order short. */
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
            try_steps(m, plan);
        else if (add_point(m, plan) < INFINITY && !plan.model->approximate)
            lower_limit(m, &plan);
    }
}

/* Tries all sets of cuts. A cut is a part of the physics that a plan may
   leave out, and a set of cuts is a bit mask.

   For each set, first runs the finest plain plan with these cuts. If its
   error is not below the largest tolerance, tries only models without
   steps. Sets with MODELS_RODS are always tried with steps, because rods
   need leapfrog. */
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

/* The chooser's plan for a tolerance, and the result of running it. */
struct pick {
    struct point point; /* cost NAN if the chooser refused */
    double deciding;    /* estimated cost of choosing, s */
    double horizon;     /* time up to which motion is predictable, s, or
                           INFINITY */
};

/* Calls the chooser with the budget that bonk uses and runs its plan.
   Ignores the chooser's own error estimate, because the map knows the true
   path. */
static void ask_chooser(struct pick *p, struct map *m, double tolerance)
{
    const struct choose_request q = {.scene = &m->scene,
                                     .program = PROGRAM,
                                     .until = ROWS * m->every,
                                     .every = m->every,
                                     .tolerance = tolerance,
                                     .budget = CHOOSE_BUDGET};
    struct choose_choice c;
    *p = (struct pick){.point = {.cost = NAN, .error = NAN}};
    program_memory(choose(&c, &q), "to choose");
    p->deciding = c.spent - c.run.cost;
    p->horizon = c.horizon;
    if (c.run.value &&
        run_plan(&m->path, &c.run.plan, &m->scene, m->every, 100))
        p->point =
            (struct point){c.run.plan, m->path.cost, error_of(m), false};
    choose_free(&c);
}

/* Writes plan, error and cost, or "- nan nan" if p is NULL. */
static void write_way(const struct point *p, struct table *out)
{
    char text[MODELS_TEXT] = "-";
    if (p)
        models_write(&p->plan, text);
    table_print(out, " %s %.3g %.4g", text, p ? p->error : NAN,
                p ? p->cost : NAN);
}

/* Writes the row of a pick. Its columns are the name that the book cites
   (the scene and the digits of the tolerance), the pick, the cheapest point
   that meets the tolerance, the cheapest such point of any other model, the
   finest plain point (see `finest`), the classic method, and the chooser's
   cost and horizon. */
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
    const struct point classic = classic_way(m, tolerances[k]);
    write_way(&classic, out);
    table_print(out, " %.4g %.4g\n", p->deciding, p->horizon);
}

/* Compares points by cost for qsort, so that a plot can join the points of
   the front by a line. */
static int cheaper(const void *one, const void *other)
{
    const struct point *a = one, *b = other;
    return a->cost != b->cost
               ? (a->cost < b->cost ? -1 : 1)
               : (a->error > b->error) - (a->error < b->error);
}

/* Writes the points with errors below OFF, in units of truth.scale. */
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

/* A run that measures the price of one unit of work. It does much work of
   that kind and little of any other. */
struct price_run {
    const char *name, *key;
    double value;
    const char *plan;
    double every;
    uint64_t rows;
};

/* The runs that measure the price list. A run takes from 0.5 ms to a few
   hundredths of a second: long enough for a clock with a resolution of a
   microsecond, and short enough to measure every unit six times.

   Each scene does much of one kind of work. The choreography has 276 pairs.
   Most springs of a short beam do not form bands. In a row of a hundred
   balls hardly any pair comes close; in a gas many do. The paths of radau15
   are polynomials of degree nine: sixty disks need many of them, and on a
   line most of them have a root. Two balls have one gap and thirty have 29.
   A collision of four disks examines few pairs and a collision of ninety
   examines many. */
static const struct price_run price_runs[MODELS_UNITS] = {
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
    [MODELS_ROW] = {"cradle", "balls", 2, "relabel", 1, 20000}};
/* Performs the run. Returns its processor time (in s) and sets work[] to
   the number of units of each kind. Includes the time for starting, which
   accounts for most of the work of `modes`. If `alone`, gravity is off, so
   the bodies of a ring move freely. */
static double time_run(const struct price_run *b, bool alone,
                       double work[MODELS_UNITS])
{
    char message[MODELS_MESSAGE];
    struct models_plan plan;
    struct models_run r;
    struct scene s;
    const char *why;
    program_check(gallery_make(&s, find_scene(b->name), b->key, b->value));
    if (!models_read(&plan, b->plan, message))
        program_give_up("%s", message);
    s.k2 = alone ? 0 : s.k2;
    const double begin = bench_seconds();
    if (!models_begin(&r, &plan, &s, b->every, &why))
        program_give_up("%s", why);
    while (r.rows < b->rows)
        if (models_row(&r) != MODELS_DONE)
            program_give_up(
                "a run that measures a price has not come to its end");
    const double seconds = bench_seconds() - begin;
    memcpy(work, r.work, sizeof r.work);
    models_end(&r);
    scene_free(&s);
    return seconds;
}

/* Returns the cost of a unit, ns. For the other units of the run, assumes
   the prices of the list. */
static double price_in(const struct price_run *b, enum models_unit unit)
{
    double work[MODELS_UNITS];
    const bool alone = strcmp(b->name, "ring") == 0;
    const double seconds = time_run(b, alone, work), units = work[unit];
    work[unit] = 0;
    return (seconds - models_cost(work)) / units * 1e9;
}

/* Complete runs, which test the predicted cost. If there are many bodies,
   starting the run and computing the rows add to the cost. */
static const struct price_run whole_runs[] = {
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

/* Fills the map of a scene. Sorts the points last, because sorting
   invalidates pointers to points. */
static void make_map(struct map *m, const struct subject *t)
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

/* Returns whether the chooser was right to refuse. No point on the map may
   meet the tolerance. If the predicted horizon is within the run, the
   finest plain plan must also meet the tolerance up to the horizon. */
static bool is_refusal_right(struct map *m, const struct pick *p,
                             double tolerance)
{
    const struct point *most = finest(m);
    const double rows = p->horizon / m->every + 1e-9;
    if (cheapest_of(m, NULL, NULL, tolerance))
        return false;
    if (!most || !(rows < ROWS))
        return true;
    return run_plan(&m->path, &most->plan, &m->scene, m->every, 100) &&
           distance(&m->path, &m->truth.path, (size_t)rows) <=
               tolerance * m->truth.scale;
}

/* Returns 0 if the pick is right, 1 if it misses the tolerance, 2 if it
   costs more than 1.13 times the cheapest point that meets the tolerance,
   and 3 if the chooser refused wrongly. */
static int judge(struct map *m, const struct pick *p, double tolerance)
{
    const struct point *best = cheapest_of(m, NULL, NULL, tolerance);
    if (!(p->point.cost > 0))
        return is_refusal_right(m, p, tolerance) ? 0 : 3;
    if (!(p->point.error <= tolerance))
        return 1;
    return best && p->point.cost > 1.13 * best->cost ? 2 : 0;
}

/* Maps all scenes, or only the scene given by --scene, so that several
   machines can share the work. For each scene, writes its picks and then
   all its points. `make atlas` joins the tables into one that is identical
   to that of a single run: it adds the counts of the last lines and takes
   the largest error of the truth. */
static void study_atlas(struct study *s)
{
    static struct map m;
    size_t faults[4] = {0};
    double unsure = 0;
    table_print(s->out,
                "# picks: name and digits of the tolerance; then plan, "
                "error, cost (s)\n# of the pick, of the cheapest that "
                "holds, of the cheapest with another\n# model, of the "
                "finest plain way, of the classic method with steps "
                "halved;\n# what deciding cost (s); the horizon (s)\n"
                "# others: name; 1 if on the front; plan, error, cost\n");
    for (size_t i = 0; subjects[i].name && !progress_signal(); ++i) {
        if (own.scene && strcmp(own.scene, subjects[i].name) != 0)
            continue;
        make_map(&m, &subjects[i]);
        for (int k = 0; k < TOLERANCES; ++k) {
            struct pick pick;
            ask_chooser(&pick, &m, tolerances[k]);
            write_pick(&m, &pick, k, s->out);
            ++faults[judge(&m, &pick, tolerances[k])];
        }
        write_points(&m, s->out);
        unsure = fmax(unsure, m.truth.unsure);
        free(m.truth.path.x);
        free(m.path.x);
        scene_free(&m.scene);
    }
    table_print(s->out,
                "#= unsure %.3g\n#= good %zu\n#= beyond %zu\n"
                "#= dear %zu\n#= refused %zu\n",
                unsure, faults[0], faults[1], faults[2], faults[3]);
    TABLE_RESULTS(
        s->summary, {"unsure", unsure}, {"good", (double)faults[0]},
        {"beyond", (double)faults[1]}, {"dear", (double)faults[2]},
        {"refused", (double)faults[3]});
}

static void study_scenes(struct study *s)
{
    for (size_t i = 0; subjects[i].name; ++i)
        table_print(s->out, "%s\n", subjects[i].name);
}

/* Measures the price list. Each price is the median of several rounds. The
   first round is discarded. */
static void study_prices(struct study *s)
{
    bench_machine(s->out);
    table_print(s->out,
                "# unit, price in the list (ns), measured, ratio\n");
    for (int k = 0; k < MODELS_UNITS && !progress_signal(); ++k) {
        double found;
        BENCH_TURNS(i, 1, &found,
                    price_in(&price_runs[k], (enum models_unit)k));
        table_print(s->out, "%s %.3g %.3g %.3g\n", models_prices[k].name,
                    models_prices[k].ns, found,
                    found / models_prices[k].ns);
    }
    table_print(s->out,
                "# whole runs: scene, plan, bill (s), seconds over bill\n");
    for (const struct price_run *b = whole_runs; b->name; ++b) {
        double seconds, work[MODELS_UNITS];
        BENCH_TURNS(i, 1, &seconds, time_run(b, false, work));
        const double bill = models_cost(work);
        table_print(s->out, "# %s/%s=%g %s %.3g %.2f\n", b->name, b->key,
                    b->value, b->plan, bill, seconds / bill);
    }
}

static void take_option(struct options *o, int letter)
{
    (void)letter;
    own.scene = options_text(o);
}

static const struct study_entry studies[] = {
    {"atlas", study_atlas, "error and cost of all models",
     STUDY_KEYS({"unsure", "1", "error of the truth, largest"},
                {"good", "1", "choices"},
                {"beyond", "1", "choices beyond the tolerance"},
                {"dear", "1", "more than 1.13 times the cheapest"},
                {"refused", "1", "wrongly"})},
    {"scenes", study_scenes, "the scenes of the atlas", NULL},
    {"prices", study_prices, "what the units of cost cost here", NULL},
    {0}};

static const struct options_entry entries[] = {
    {"", 0, NULL, "--study atlas"},
    {"scene", 'c', "NAME", "this scene only"},
    {0}};

STUDY_MAIN(.name = PROGRAM, .purpose = "Measure what is enough.",
           .events = "runs", .studies = studies, .options = entries,
           .take = take_option)
