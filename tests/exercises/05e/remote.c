/* The remote calls of exercise 05e: see examiner/remote.h. The
   program that is tried stays with the judge; the box asks for its runs. */
/* output: none */

#include "examiner/remote.h"
#include "examiner/check.h"
#include <stdlib.h>

struct state {
    double x, y, vx, vy;
};

typedef void program(struct state start, double tick, size_t samples,
                     struct state kept[]);

bool clock_is_right(double width, double height, program *run);

static void move_states(struct state s[], size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        remote_doubles(&s[i].x, 1);
        remote_doubles(&s[i].y, 1);
        remote_doubles(&s[i].vx, 1);
        remote_doubles(&s[i].vy, 1);
    }
}

#ifdef REMOTE_SERVER

static void run(struct state start, double tick, size_t samples,
                struct state kept[])
{
    remote_callback(0);
    move_states(&start, 1);
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    remote_callback_wait();
    move_states(kept, samples);
}

void remote_serve(void)
{
    double width, height;
    remote_doubles(&width, 1);
    remote_doubles(&height, 1);
    bool right = clock_is_right(width, height, run);
    remote_reply();
    remote_bools(&right, 1);
}

#else

static program *tried;

enum { MOST_SAMPLES = 1000000 }; /* that are given at once: 32 MB */

void remote_serve_callback(int which)
{
    struct state start;
    double tick;
    size_t samples;
    (void)which;
    move_states(&start, 1);
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    check_demand("samples", (double)samples, MOST_SAMPLES);
    struct state *kept = remote_array(samples, sizeof *kept);
    tried(start, tick, samples, kept);
    remote_callback_reply();
    move_states(kept, samples);
    free(kept);
}

bool clock_is_right(double width, double height, program *run)
{
    bool right;
    tried = run;
    remote_restart();
    remote_call();
    remote_doubles(&width, 1);
    remote_doubles(&height, 1);
    remote_wait();
    remote_bools(&right, 1);
    return right;
}

#endif
