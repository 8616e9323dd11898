/* Around a run on the line: from a start to it and back, energy, rest. */
#include "line/engine.h"
#include "line/gap.h"
#include "line/start.h"

#include <math.h>
#include <string.h>

const char *const bonkers_engine_names[BONKERS_ENGINES + 1] = {
    "auto", "naive", "scan", "heap", "slab", NULL};

bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine)
{
    return engine_create(b, movers, restitution, engine, false);
}

/* Mover i of a start is body i + 1 of the line, between two walls of
   infinite mass. A million points should not pay for radii that they do not
   have; others need a shift each, whose place will do for the radius until
   then. */
bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong)
{
    bool points = true;
    for (size_t i = 0; i < s->movers; ++i)
        points = points && s->radius[i] == 0;
    if (!engine_create(b, s->movers, restitution, engine, points))
        return false;
    b->gravity = s->gravity;
    b->body[0].x = s->wall[0];
    b->body[b->gaps].x = s->wall[1];
    for (size_t i = 0; i < s->movers; ++i)
        b->body[i + 1] =
            (struct bonkers_body){s->x[i], s->v[i], 0, 1 / s->mass[i]};
    if (!points) {
        memcpy(b->shift + 1, s->radius, s->movers * sizeof *b->shift);
        b->shift[0] = b->shift[b->gaps] = 0;
    }
    *wrong = bonkers_start(b, b->shift);
    return true;
}

void bonkers_settle(struct bonkers *b)
{
    for (size_t i = 0; i <= b->gaps; ++i) {
        b->body[i] = body_at(b, i, b->now);
        b->body[i].x += b->shift ? b->shift[i] : 0;
        b->body[i].since = 0;
        if (b->repeats && i < b->gaps)
            b->repeats[i] = 0;
    }
    b->now = 0;
    b->collisions = 0;
    schedule_clear(&b->schedule);
}

/* No gap will close: where the left body gains on the right one, it has
   infinitely far to go. No time is asked for, and the clocks may differ. */
bool bonkers_is_still(const struct bonkers *b)
{
    for (size_t i = 0; i < b->gaps; ++i)
        if (b->gravity > 0 ? weight_time_of_gap(b, i) < INFINITY
                           : b->body[i].v > b->body[i + 1].v &&
                                 b->body[i + 1].x - b->body[i].x < INFINITY)
            return false;
    return true;
}

bool bonkers_is_cold(const struct bonkers *b)
{
    for (size_t i = 0; i < b->gaps; ++i)
        if (b->repeats && b->repeats[i] >= most_repeats(b))
            return false;
    return true;
}

/* The sum goes from the left in every engine, for another order would have
   other roundings. A wall has no energy that it could give away. */
double bonkers_energy(const struct bonkers *b)
{
    const double low = b->body[0].x, floor = low > -INFINITY ? low : 0;
    double sum = 0;
    for (size_t i = 1; i < b->gaps; ++i) {
        const struct bonkers_body *a = &b->body[i];
        sum += (a->v * a->v + 2 * b->gravity * (a->x - floor)) / a->im;
    }
    return sum / 2;
}
