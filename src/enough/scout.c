/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 1757747978 of the lines below */
/* Steps that follow the largest rate of any pair, from row to row. */
#include "enough/scout.h"

#include "enough/models.h"
#include "forces/motion.h"
#include "scenes/pair.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two bodies that attract each other. */
struct meeting {
    struct pair pair; /* its r2 with the softening */
    double pull;      /* k^2 (m1 + m2) */
    double bend;      /* m: of the way, within a step from the nearest
                         point */
};

/* By how much the way of two bodies bends until the nearest point, or has
   bent since, m; 0 beyond a step. */
static double bend_of(const struct scout_sight *sight, size_t i, size_t j,
                      const struct pair *now)
{
    if (!sight->before || !pair_passes(now, sight->step))
        return 0;
    const struct pair then = pair_of(sight->before, i, j);
    const double tau = fabs(now->rv) / now->v2;
    return pair_changed(&then, now) / sight->step * tau * tau / 2;
}

static struct meeting meeting_of(const struct scene *s, size_t i, size_t j,
                                 const struct scout_sight *sight)
{
    struct meeting m = {.pair = pair_of(s, i, j),
                        .pull = s->k2 * (s->mass[i] + s->mass[j])};
    m.bend = bend_of(sight, i, j, &m.pair);
    m.pair.r2 += s->softening * s->softening;
    return m;
}

/* Puts a passage that is too weak by this factor away. */
static void put_away(double passed[], double weaker, double rate)
{
    size_t k = 0;
    for (; k < SCOUT_DRAWERS && weaker > 1; ++k)
        weaker /= 2;
    if (k < SCOUT_DRAWERS)
        passed[k] = fmax(passed[k], rate);
}

/* The squared rate of one pair: (12.12, eq:scout-rate). */
static double rate_of(const struct meeting *m,
                      const struct scout_sight *sight)
{
    const struct pair *p = &m->pair;
    const double round = m->pull / (p->r2 * sqrt(p->r2));
    const double b2 =
        pair_passes(p, sight->around) ? pair_nearest2(p) : p->r2;
    const double least = fmax(sqrt(b2) - m->bend, 0);
    const double moved = 2 * m->pull * sight->left;
    const double counts = sight->little * least * sqrt(p->v2);
    if (moved > counts) {
        if (sight->nearest)
            *sight->nearest = fmin(*sight->nearest, sqrt(b2));
        return fmax(round, p->v2 / p->r2);
    }
    if (sight->passed && moved > 0)
        put_away(sight->passed, counts / moved, sqrt(p->v2 / b2));
    return round;
}

double scout_rate(const struct scene *s, const struct scout_sight *sight)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = 0; j < i; ++j)
            if (s->mass[i] > 0 || s->mass[j] > 0) {
                const struct meeting m = meeting_of(s, i, j, sight);
                most = fmax(most, rate_of(&m, sight));
            }
    return sqrt(most);
}

/* rate * step, found after it: so many times what was aimed at, at most. */
static const double most_found = 5.0 / 3;
enum { FINEST = 40 }; /* halvings of a row */

/* A look ahead under way. */
struct going {
    struct scout *p;
    struct scene now, before;
    struct motion motion;
    bool moving;
    int halvings; /* of the row: the step */
    double place; /* in the row, from 0 to 1 */
    const struct scout_order *o;
    double nearest; /* passage so far in this row, m */
    double end;     /* of the run, s */
    double springs; /* their rate, 1/s */
};

static double step_of(const struct going *g)
{
    double step = g->o->every;
    for (int k = 0; k < g->halvings; ++k)
        step /= 2;
    return step;
}

static double rate_now(struct going *g, double time)
{
    const struct scout_sight sight = {.left = g->end - time,
                                      .little = g->o->little,
                                      .around = step_of(g) / g->o->aim,
                                      .before = &g->before,
                                      .step = step_of(g),
                                      .passed = g->p->passed,
                                      .nearest = &g->nearest};
    return fmax(scout_rate(&g->now, &sight), g->springs);
}

/* The halvings that the rate asks for, and from which this place can be
   left. */
static int halvings_for(const struct going *g, double rate)
{
    int k = 0;
    double step = g->o->every, steps = g->place;
    while (k < FINEST &&
           (rate * step > g->o->aim || steps != floor(steps))) {
        step /= 2;
        steps *= 2;
        ++k;
    }
    return k;
}

static bool change_step(struct going *g, int halvings)
{
    if (g->moving && g->halvings == halvings)
        return true;
    if (g->moving)
        motion_end(&g->motion);
    g->halvings = halvings;
    g->moving =
        motion_begin(&g->motion, "scout", &g->now, "pefrl", step_of(g));
    return g->moving;
}

static void count(struct going *g, uint64_t evaluations)
{
    const struct scene *s = &g->now;
    const double n = (double)s->bodies, e = (double)evaluations;
    const double work[MODELS_UNITS] = {
        [MODELS_EVALUATION] = e,
        [MODELS_BODY] = e * n,
        [MODELS_PAIR] = s->k2 > 0 ? (e + 1) * n * (n - 1) : 0,
        [MODELS_SPRING] = e * (double)s->springs};
    g->p->cost += models_cost(work);
    ++g->p->steps;
}

/* Tries one step; *met is the rate after it. False: it was too long. */
static bool try_step(struct going *g, double start, double *met)
{
    const uint64_t before = g->motion.stepping.evaluations;
    const enum stepping_end end = motion_run(&g->motion, 1);
    const double step = step_of(g);
    count(g, g->motion.stepping.evaluations - before);
    *met = rate_now(g, start + step);
    if (end == STEPPING_DONE && *met * step <= most_found * g->o->aim) {
        g->place += step / g->o->every;
        g->now.time = start + step;
        return true;
    }
    scene_take_state(&g->now, &g->before);
    stepping_disturb(&g->motion.stepping);
    return false;
}

/* One step from the place in the row, as fine as it must be; false: there
   is none, or the cost is over the limit. */
static bool step_on(struct going *g, size_t row, double *rate)
{
    const double start = g->now.time;
    double met;
    scene_take_state(&g->before, &g->now);
    for (int halvings = halvings_for(g, *rate);
         halvings < FINEST && g->p->cost <= g->o->limit; ++halvings) {
        g->now.time = start;
        if (!change_step(g, halvings))
            return false;
        if (!try_step(g, start, &met))
            continue;
        *rate = met;
        g->p->rate[row] = fmax(g->p->rate[row], met);
        return true;
    }
    return false;
}

static void note_row(struct going *g, size_t row)
{
    struct scout *p = g->p;
    memcpy(p->place + row * p->coordinates, g->now.position,
           p->coordinates * sizeof *p->place);
    p->nearest[row] = g->nearest;
    p->reached = row;
    if (p->rate[row] > p->most) {
        p->most = p->rate[row];
        p->hardest = row;
    }
}

static void go(struct going *g)
{
    struct scout *p = g->p;
    const double start = g->now.time;
    g->nearest = INFINITY;
    double rate = p->rate[0] = rate_now(g, start);
    note_row(g, 0);
    for (size_t row = 1; row <= p->rows; ++row) {
        g->place = 0;
        g->nearest = INFINITY;
        g->now.time = start + (double)(row - 1) * g->o->every;
        p->rate[row] = rate;
        while (g->place < 1)
            if (!step_on(g, row, &rate))
                return;
        note_row(g, row);
    }
}

static double springs_of(const struct scene *s)
{
    struct scene springs;
    struct models_acts acts;
    if (s->springs == 0 || !scene_copy(&springs, s))
        return 0;
    springs.k2 = 0;
    models_analyse(&acts, &springs);
    scene_free(&springs);
    return acts.fastest;
}

static bool make_scout(struct scout *p, const struct scene *s, size_t rows)
{
    *p =
        (struct scout){.rows = rows, .coordinates = SCENE_AXES * s->bodies};
    p->rate = calloc((rows + 1) * (2 + p->coordinates), sizeof *p->rate);
    if (!p->rate)
        return false;
    p->nearest = p->rate + rows + 1;
    p->place = p->nearest + rows + 1;
    return true;
}

bool scout_ahead(struct scout *p, const struct scene *s,
                 const struct scout_order *o)
{
    struct going g = {.p = p,
                      .o = o,
                      .springs = springs_of(s),
                      .end = s->time + (double)o->rows * o->every};
    const bool now = make_scout(p, s, o->rows) && scene_copy(&g.now, s);
    const bool before = now && scene_copy(&g.before, s);
    if (before)
        go(&g);
    if (g.moving)
        motion_end(&g.motion);
    if (before)
        scene_free(&g.before);
    if (now)
        scene_free(&g.now);
    if (!before)
        scout_free(p);
    return before;
}

void scout_free(struct scout *p)
{
    free(p->rate);
    *p = (struct scout){0};
}

/* The largest difference of a coordinate at the end of a row, m. */
static double places_apart(const struct scout *a, const struct scout *b,
                           size_t row)
{
    const double *x = a->place + row * a->coordinates;
    const double *y = b->place + row * b->coordinates;
    double most = 0;
    for (size_t c = 0; c < a->coordinates; ++c)
        most = fmax(most, fabs(x[c] - y[c]));
    return most;
}

bool scout_agree(const struct scout *a, const struct scout *b)
{
    static const double sharp = 3;
    if (a->reached < a->rows || b->reached < b->rows)
        return false;
    for (size_t row = 1; row <= a->rows; ++row) {
        const double nearest = fmin(a->nearest[row], b->nearest[row]);
        if (!(sharp * places_apart(a, b, row - 1) <= nearest))
            return false;
    }
    return true;
}
