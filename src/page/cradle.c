/* Live figure of chapter 11: a cradle by events, steps and springs. */
#include "forces/hard.h"
#include "forces/motion.h"
#include "line/bonkers.h"
#include "page/page.h"
#include "scenes/gallery.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 12, WAYS = 3 };

/* The scene cradle runs three times, side by side: by events (line/), in
   steps with instantaneous contacts, and in steps with springs as contacts.
   Parameters: the number of balls; the number of balls that fly in; the
   gap, m; the step of the second run, s; 1 if the springs of the third run
   follow Hertz's law, 0 if they are linear; the stiffness of the springs;
   the step of the third run, s. */
double page_number[PAGE_NUMBERS];

static struct bonkers events;
static struct way {
    struct scene scene;
    struct motion motion;
    bool begun;
} steps, springs;
static double seen[2 + WAYS * (2 + 2 * MOST)];

static const char *make_cradle(struct scene *s)
{
    const struct gallery_choice chosen[] = {{"balls", page_number[0]},
                                            {"left", page_number[1]},
                                            {"gap", page_number[2]},
                                            {"dt", page_number[3]},
                                            {0}};
    return gallery_choose(s, hard_scenes, "cradle", chosen);
}

static bool begin_way(struct way *w, bool by_springs)
{
    if (w->begun) {
        motion_end(&w->motion);
        scene_free(&w->scene);
    }
    w->begun = false;
    if (make_cradle(&w->scene))
        return false;
    if (by_springs) {
        w->scene.law = page_number[4] != 0 ? SCENE_HERTZ : SCENE_LINEAR;
        w->scene.stiffness = page_number[5];
        w->scene.dt = page_number[6];
    }
    w->begun = motion_begin(&w->motion, "cradle", &w->scene, "leapfrog", 0);
    if (!w->begun)
        scene_free(&w->scene);
    return w->begun;
}

/* Begins the run by events from the scene, as the program bonk does. */
static bool begin_events(void)
{
    struct scene scene;
    struct start start = {0};
    size_t wrong;
    bonkers_free(&events);
    if (make_cradle(&scene))
        return false;
    bool good = hard_start(&start, &scene);
    good = good &&
           bonkers_begin(&events, &start, 1, BONKERS_SCAN, &wrong) &&
           wrong == events.gaps;
    start_free(&start);
    scene_free(&scene);
    return good;
}

bool page_begin(void)
{
    return page_number[0] <= MOST && begin_events() &&
           begin_way(&steps, false) && begin_way(&springs, true);
}

static void step_to(struct way *w, double until)
{
    while (motion_time(&w->motion) + w->motion.stepping.dt <= until)
        if (motion_run(&w->motion, 1) != STEPPING_DONE)
            break;
}

/* Runs all three; an event is a step of the second run, whose time the
   other two follow. */
double page_run(double until, double number)
{
    const double before = (double)steps.motion.stepping.steps;
    const double dt = steps.motion.stepping.dt;
    step_to(&steps, fmin(until, (before + number + 0.5) * dt));
    const double now = motion_time(&steps.motion);
    bonkers_run(&events, now, UINT64_MAX);
    step_to(&springs, now);
    return (double)steps.motion.stepping.steps - before;
}

/* Writes the number of collisions, the energy, all x and all v to next.
   Returns a pointer to the first number after them. */
static double *look_at(const struct way *w, double *next)
{
    const struct scene *s = &w->scene;
    *next++ = (double)w->motion.collisions;
    *next++ = motion_kinetic(&w->motion) + motion_potential(&w->motion);
    memcpy(next, s->position, s->bodies * sizeof *next);
    memcpy(next + s->bodies, s->velocity, s->bodies * sizeof *next);
    return next + 2 * s->bodies;
}

/* Returns the time and the number of balls; then, for the runs by events,
   in steps and with springs, the number of collisions, the energy, all x
   and all v. */
const double *page_look(void)
{
    double x[MOST + 2], v[MOST + 2], *next = seen + 4;
    const size_t balls = steps.scene.bodies;
    seen[0] = motion_time(&steps.motion);
    seen[1] = (double)balls;
    seen[2] = (double)events.collisions;
    seen[3] = bonkers_energy(&events);
    bonkers_state(&events, x, v);
    memcpy(next, x + 1, balls * sizeof *next);
    memcpy(next + balls, v + 1, balls * sizeof *next);
    look_at(&springs, look_at(&steps, next + 2 * balls));
    return seen;
}
