/* Begins, restarts and ends runs on the line; reads their state. */
#include "line/engine.h"
#include "line/gap.h"
#include "line/slab.h"
#include "line/start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const bonkers_engine_names[BONKERS_ENGINES + 1] = {
    "auto", "naive", "scan", "heap", "slab", NULL};

/* Prepares a run like bonkers_create, but allocates only the arrays that
   this run needs. Only bodies with radii need shifts. Only inelastic runs
   count repeats. Only the scan and slab engines use fractions. The heap has
   room for all gaps in the heap engine, but only for those of one island in
   the slab engine. */
static bool create(struct bonkers *b, size_t movers, double restitution,
                   enum bonkers_engine engine, bool points)
{
    *b = (struct bonkers){.gaps = movers + 1, .restitution = restitution};
    b->engine = engine != BONKERS_AUTO      ? engine
                : movers <= BONKERS_SCANNED ? BONKERS_SCAN
                                            : BONKERS_SLAB;
    bool complete = (b->body = calloc(movers + 2, sizeof *b->body)) &&
                    (b->due = malloc(b->gaps * sizeof *b->due));
    if (!points)
        complete = complete &&
                   (b->shift = malloc((movers + 2) * sizeof *b->shift));
    if (restitution < 1)
        complete =
            complete && (b->repeats = calloc(b->gaps, sizeof *b->repeats));
    if (b->engine == BONKERS_SCAN || b->engine == BONKERS_SLAB)
        complete = complete &&
                   (b->fraction = malloc(b->gaps * sizeof *b->fraction));
    if (b->engine == BONKERS_HEAP)
        complete =
            complete && schedule_create(&b->schedule, b->gaps, b->gaps);
    if (b->engine == BONKERS_SLAB)
        complete = complete &&
                   schedule_create(&b->schedule, b->gaps,
                                   b->gaps < SLAB_WAITING ? b->gaps
                                                          : SLAB_WAITING) &&
                   (b->slab = slab_create(b));
    if (!complete)
        bonkers_free(b);
    return complete;
}

void bonkers_free(struct bonkers *b)
{
    slab_free(b->slab);
    free(b->body);
    free(b->due);
    free(b->shift);
    free(b->repeats);
    free(b->fraction);
    schedule_free(&b->schedule);
    *b = (struct bonkers){0};
}

bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine)
{
    return create(b, movers, restitution, engine, false);
}

/* Subtracts the shifts s_i of (2.2, eq:rods) from the positions. radius and
   b->shift may be the same array. */
static void take_out_radii(struct bonkers *b, const double radius[])
{
    double sum = 0;
    for (size_t i = 0; i <= b->gaps; ++i) {
        const double r = radius[i];
        b->shift[i] = sum + r;
        b->body[i].x -= b->shift[i];
        sum += 2 * r;
    }
}

/* Subtracting the radii may make touching bodies overlap by a rounding
   error, which is corrected here. A larger overlap or a NaN is an error of
   the caller. */
size_t bonkers_start(struct bonkers *b, const double radius[])
{
    b->extent = 0;
    for (size_t i = 0; i <= b->gaps; ++i)
        if (isfinite(b->body[i].x))
            b->extent = fmax(b->extent, fabs(b->body[i].x));
    if (radius) {
        take_out_radii(b, radius);
    } else {
        free(b->shift);
        b->shift = NULL;
    }
    for (size_t i = 0; i < b->gaps; ++i) {
        struct bonkers_body *left = &b->body[i], *right = left + 1;
        if (!(right->x - left->x >= -engine_rounding(b, i + 1)))
            return i;
        if (right->x < left->x)
            right->x = left->x; /* the overlap is a rounding error */
        b->due[i] = time_due(b, i);
        if (b->fraction)
            b->fraction[i] = fraction(b, i);
        if (b->engine == BONKERS_HEAP)
            engine_reschedule(b, i);
    }
    return b->gaps;
}

/* Mover i of s becomes body i + 1. b->shift first contains the radii, which
   bonkers_start replaces by the shifts. If all radii are 0, b->shift is
   NULL, so the run does not read an array of zeros. */
bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong)
{
    bool points = true;
    for (size_t i = 0; i < s->movers; ++i)
        points = points && s->radius[i] == 0;
    if (!create(b, s->movers, restitution, engine, points))
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

/* Returns whether no gap will ever close. Without gravity, a gap of finite
   length closes if its left body has the greater velocity. This can be
   decided without the positions at a common time. */
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

/* Sums over the bodies from left to right in every engine, since another
   order would give other rounding errors. The walls are not included. */
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
