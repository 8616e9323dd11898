/* Live figure of chapter 8: an oscillator in steps, by two methods. */
#include "forces/motion.h"
#include "page/page.h"
#include "scenes/gallery.h"

#include <string.h>

enum { METHODS = 2, OWN = 8 }; /* OWN: values shown for each method */

/* Parameters: the step, s; the damping; the two methods, by their numbers
   in page_word. The scene is `oscillator` from the gallery, run as the
   program step runs it: `scene oscillator --damping 0 | step -` with the
   same method and step gives the same positions. */
double page_number[PAGE_NUMBERS];

static struct swing {
    struct scene scene;
    struct motion motion;
    double matrix[4]; /* maps (x, v) to its value a step later */
    bool begun, stopped;
} swing[METHODS];
static double seen[1 + METHODS * OWN];

/* Returns method `number`, counting neither methods that choose their own
   steps nor methods for planets. */
static const struct stepping_method *method_of(double number)
{
    const struct stepping_method *m = stepping_next(NULL);
    while (m && number-- > 0)
        m = stepping_next(m);
    return m;
}

const char *page_word(double number)
{
    const struct stepping_method *m = method_of(number);
    return m ? m->name : NULL;
}

static void end(struct swing *s)
{
    if (s->begun) {
        motion_end(&s->motion);
        scene_free(&s->scene);
    }
    s->begun = s->stopped = false;
}

static bool begin(struct swing *s, const char *method, double x, double v)
{
    const struct gallery_choice chosen[] = {{"damping", page_number[1]},
                                            {"displacement", x},
                                            {"velocity", v},
                                            {0}};
    end(s);
    if (gallery_choose(&s->scene, elastic_scenes, "oscillator", chosen))
        return false;
    s->begun = motion_begin(&s->motion, "swing", &s->scene, method,
                            page_number[0]);
    if (!s->begun)
        scene_free(&s->scene);
    return s->begun;
}

enum { REST = 4 }; /* length of the spring at rest, m */

static double place(const struct swing *s)
{
    return s->scene.position[1] - REST;
}

/* Measures the matrix (a b; c d) of one step by a step from (1, 0) and a
   step from (0, 1). If its determinant is 1, each step leaves the form c
   x^2 - (a - d) x v - b v^2 unchanged. The motion by this method then stays
   on the ellipse that this form defines, which the script draws. For
   leapfrog the form is a multiple of the modified energy (8.6,
   eq:modified-energy). */
static bool measure(struct swing *s, const char *method)
{
    for (int k = 0; k < 2; ++k) {
        if (!begin(s, method, k == 0, k == 1))
            return false;
        motion_run(&s->motion, 1);
        s->matrix[k] = place(s);
        s->matrix[2 + k] = s->scene.velocity[1];
    }
    return true;
}

bool page_begin(void)
{
    for (int k = 0; k < METHODS; ++k) {
        const char *method = page_word(page_number[2 + k]);
        if (!method || !measure(&swing[k], method) ||
            !begin(&swing[k], method, 1, 0))
            return false;
    }
    return true;
}

static double now(void)
{
    const double a = motion_time(&swing[0].motion);
    const double b = motion_time(&swing[1].motion);
    return a > b ? a : b;
}

/* Runs both methods; an event is a step. An oscillator stops when its
   numbers overflow. */
double page_run(double until, double events)
{
    double steps = 0;
    for (; steps < events && now() + page_number[0] <= until; ++steps) {
        for (int k = 0; k < METHODS; ++k)
            if (!swing[k].stopped)
                swing[k].stopped =
                    motion_run(&swing[k].motion, 1) != STEPPING_DONE;
        if (swing[0].stopped && swing[1].stopped)
            break;
    }
    return steps;
}

/* Returns the time and, for each method, x, v, the energy, whether it has
   stopped, and the matrix of a step. */
const double *page_look(void)
{
    seen[0] = now();
    for (int k = 0; k < METHODS; ++k) {
        const struct swing *s = &swing[k];
        double *own = seen + 1 + k * OWN;
        own[0] = place(s);
        own[1] = s->scene.velocity[1];
        own[2] = motion_kinetic(&s->motion) + motion_potential(&s->motion);
        own[3] = s->stopped;
        memcpy(own + 4, s->matrix, sizeof s->matrix);
    }
    return seen;
}
