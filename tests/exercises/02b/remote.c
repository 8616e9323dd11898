/* The remote calls of exercise 02b: see examiner/remote.h. */
/* output: sample x samples suite */

#include "examiner/remote.h"
#include <stdlib.h>

struct event {
    double t, x, v;
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[]);

static void move_path(size_t events, struct event path[])
{
    for (size_t e = 0; e < events; ++e) {
        remote_doubles(&path[e].t, 1);
        remote_doubles(&path[e].x, 1);
        remote_doubles(&path[e].v, 1);
    }
}

/* The suite looks one place before the first sample and one behind the
   last; these two cross as well, so that x has samples + 2 places. */

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t events, samples;
    double tick;
    remote_sizes(&events, 1);
    struct event *path = remote_array(events, sizeof path[0]);
    move_path(events, path);
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    double *x = remote_output_doubles("x", samples + 2);
    sample(events, path, tick, samples, x + 1);
    free(path);
    remote_reply();
    remote_doubles(x, samples + 2);
}

#else

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    remote_call();
    remote_sizes(&events, 1);
    move_path(events, (struct event *)path);
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    remote_doubles(x - 1, samples + 2);
    remote_wait();
    remote_doubles(x - 1, samples + 2);
}

#endif
