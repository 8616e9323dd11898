/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 1829636510 of the lines below */
#include "scout.h"

#include "models.h"
#include "motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of one pair: (12.11, eq:scout-rate). */
static double pair_rate(const struct scene *s, size_t i, size_t j,
                        double left, double little)
{
    const size_t n = s->bodies;
    const double pull = s->k2 * (s->mass[i] + s->mass[j]);
    double r2 = s->softening * s->softening, v2 = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double d = s->position[k * n + j] - s->position[k * n + i];
        const double v = s->velocity[k * n + j] - s->velocity[k * n + i];
        r2 += d * d;
        v2 += v * v;
    }
    const double r = sqrt(r2), v = sqrt(v2);
    const double round = pull / (r2 * r);
    const double moved = 2 * pull * left;
    if (!(moved > little * r * v))
        return round;
    return fmax(round, v2 / r2);
}

double scout_rate(const struct scene *s, double left, double little)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t j = 0; j < i; ++j)
            if (s->mass[i] > 0 || s->mass[j] > 0)
                most = fmax(most, pair_rate(s, i, j, left, little));
    return sqrt(most);
}

/* rate * step: aimed at, and at most found after it. */
static const double aim = 0.3, most_found = 0.5;
enum { FINEST = 40 }; /* halvings of a row */

/* A look ahead under way. */
struct going {
    struct scout *p;
    struct scene now, before;
    struct motion motion;
    bool moving;
    int halvings; /* of the row: the step */
    double place; /* in the row, from 0 to 1 */
    double every, end, little, limit;
    double springs; /* their rate, 1/s */
};

static double rate_now(const struct going *g, double time)
{
    return fmax(scout_rate(&g->now, g->end - time, g->little), g->springs);
}

/* The halvings that the rate asks for, and from which this place can be
   left. */
static int halvings_for(const struct going *g, double rate)
{
    int k = 0;
    double step = g->every, steps = g->place;
    while (k < FINEST && (rate * step > aim || steps != floor(steps))) {
        step /= 2;
        steps *= 2;
        ++k;
    }
    return k;
}

static double step_of(const struct going *g)
{
    double step = g->every;
    for (int k = 0; k < g->halvings; ++k)
        step /= 2;
    return step;
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

/* Takes the scene's state from another one. */
static void take_state(struct scene *to, const struct scene *from)
{
    const size_t size = SCENE_AXES * from->bodies * sizeof *from->position;
    memcpy(to->position, from->position, size);
    memcpy(to->velocity, from->velocity, size);
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
    if (end == STEPPING_DONE && *met * step <= most_found) {
        g->place += step / g->every;
        g->now.time = start + step;
        return true;
    }
    take_state(&g->now, &g->before);
    stepping_disturb(&g->motion.stepping);
    return false;
}

/* One step from the place in the row, as fine as it must be; false: there
   is none, or the cost is over the limit. */
static bool step_on(struct going *g, size_t row, double *rate)
{
    const double start = g->now.time;
    double met;
    take_state(&g->before, &g->now);
    for (int halvings = halvings_for(g, *rate);
         halvings < FINEST && g->p->cost <= g->limit; ++halvings) {
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

static void go(struct going *g)
{
    struct scout *p = g->p;
    const double start = g->now.time;
    double rate = p->rate[0] = rate_now(g, start);
    for (size_t row = 1; row <= p->rows; ++row) {
        g->place = 0;
        g->now.time = start + (double)(row - 1) * g->every;
        p->rate[row] = rate;
        while (g->place < 1)
            if (!step_on(g, row, &rate))
                return;
        p->reached = row;
        if (p->rate[row] > p->most) {
            p->most = p->rate[row];
            p->hardest = row;
        }
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

bool scout_ahead(struct scout *p, const struct scene *s, double every,
                 size_t rows, double little, double limit)
{
    struct going g = {.p = p,
                      .every = every,
                      .little = little,
                      .limit = limit,
                      .springs = springs_of(s),
                      .end = s->time + (double)rows * every};
    *p = (struct scout){.rows = rows};
    p->rate = calloc(rows + 1, sizeof *p->rate);
    const bool now = p->rate && scene_copy(&g.now, s);
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
