/* What crosses the border of exercise 02b: see examiner/border.h. */
/* place: sample x samples suite */

#include "examiner/border.h"
#include <stdlib.h>

struct event {
    double t, x, v;
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[]);

static void move_path(size_t events, struct event path[])
{
    for (size_t e = 0; e < events; ++e) {
        border_doubles(&path[e].t, 1);
        border_doubles(&path[e].x, 1);
        border_doubles(&path[e].v, 1);
    }
}

/* The suite looks one place before the first sample and one behind the
   last; these two cross as well, so that x has samples + 2 places. */

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t events, samples;
    double tick;
    border_sizes(&events, 1);
    struct event *path = border_array(events, sizeof path[0]);
    move_path(events, path);
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    double *x = border_place_doubles("x", samples + 2);
    sample(events, path, tick, samples, x + 1);
    free(path);
    border_reply();
    border_doubles(x, samples + 2);
}

#else

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    border_call();
    border_sizes(&events, 1);
    move_path(events, (struct event *)path);
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    border_doubles(x - 1, samples + 2);
    border_wait();
    border_doubles(x - 1, samples + 2);
}

#endif
