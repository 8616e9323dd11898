/* What the tests of averages share: they ask, and look at what comes. */
#ifndef ASKED_H
#define ASKED_H

#include "unit.h"

#include "choosing/averages.h"
#include "line/start.h"

static inline struct averages_found ask(const struct scene *s,
                                        const char *name, double until,
                                        double tolerance, const char *model)
{
    struct averages_request q = {.scene = s,
                                 .until = until,
                                 .tolerance = tolerance,
                                 .budget = 5,
                                 .model = model};
    struct averages_found f = {.sure = AVERAGES_OUT};
    char message[AVERAGES_TEXT];
    UNIT_TRUE(averages_read(&q.quantity, name, s, message));
    UNIT_TRUE(averages_find(&f, &q));
    return f;
}

static inline bool refused(const struct averages_found *f)
{
    return f->sure == AVERAGES_OUT && f->refusal[0] != '\0';
}

static inline bool taken(const struct averages_found *f, const char *name)
{
    return f->sure != AVERAGES_OUT && f->refusal[0] == '\0' &&
           strcmp(f->way, name) == 0;
}

/* A piston between two gases, at 0.35 of the box. */
static inline void make_piston(struct scene *s, size_t bodies, double ratio)
{
    const struct start_request request = {.kind = START_ADIABATIC,
                                          .movers = bodies,
                                          .ratio = ratio,
                                          .seed = 1};
    struct start start;
    if (!start_fill(&start, &request) || !scene_create(s, bodies))
        exit(1);
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = start.wall[1];
    for (size_t i = 0; i < bodies; ++i) {
        const double x = start.x[i], L = start.wall[1];
        s->mass[i] = start.mass[i];
        s->velocity[i] = start.v[i];
        s->position[i] = x <= L / 2 ? 0.7 * x : L - 1.3 * (L - x);
        s->freedom[bodies + i] = s->freedom[2 * bodies + i] = 0;
    }
    start_free(&start);
}

#endif
