/* What tests of runs begin with: a plan from its text, and a body without
   mass on its way round another one. */
#ifndef PLANS_H
#define PLANS_H

#include "choosing/choose.h"
#include "unit.h"

/* A run that is ended, and a choice that is freed, at the end of its block.
 */
#define RUN __attribute__((cleanup(models_end))) struct models_run
#define CHOICE __attribute__((cleanup(choose_free))) struct choose_choice

static inline struct models_plan plan(const char *text)
{
    struct models_plan p = {0};
    char message[MODELS_MESSAGE];
    const bool good = models_read(&p, text, message);
    if (!good)
        printf("# %s: %s\n", text, message);
    UNIT_TRUE(good);
    return p;
}

/* So many rows of a scene by the plan. */
static inline struct models_run run_plan(const char *text,
                                         const struct scene *s,
                                         double every, uint64_t rows)
{
    const struct models_plan p = plan(text);
    struct models_run r;
    const char *why = "";
    const bool begun = models_begin(&r, &p, s, every, &why);
    if (!begun)
        printf("# %s: %s\n", text, why);
    UNIT_MUST(begun);
    while (r.rows < rows && models_row(&r) == MODELS_DONE)
        ;
    UNIT_EQUAL(r.rows, rows);
    UNIT_EQUAL(r.work[MODELS_ROW], rows);
    return r;
}

/* About a mass of 1 at the origin, with k = 1: from (distance, 0), with the
   velocity (0, speed). */
static inline struct scene light_orbit(double distance, double speed)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 2));
    s.mass[1] = 0;
    s.k2 = 1;
    s.position[1] = distance;
    s.velocity[3] = speed;
    return s;
}

#endif
