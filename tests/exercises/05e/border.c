/* What crosses the border of exercise 05e: see examiner/border.h. The
   program that is tried stays with the judge; the box asks for its runs. */
/* place: none */

#include "examiner/border.h"
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
        border_doubles(&s[i].x, 1);
        border_doubles(&s[i].y, 1);
        border_doubles(&s[i].vx, 1);
        border_doubles(&s[i].vy, 1);
    }
}

#ifdef BORDER_INSIDE

static void run(struct state start, double tick, size_t samples,
                struct state kept[])
{
    border_ask(0);
    move_states(&start, 1);
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    border_hear();
    move_states(kept, samples);
}

void border_answer(void)
{
    double width, height;
    border_doubles(&width, 1);
    border_doubles(&height, 1);
    bool right = clock_is_right(width, height, run);
    border_reply();
    border_bools(&right, 1);
}

#else

static program *tried;

enum { MOST_SAMPLES = 1000000 }; /* that are given at once: 32 MB */

void border_heed(int which)
{
    struct state start;
    double tick;
    size_t samples;
    (void)which;
    move_states(&start, 1);
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    check_demand("samples", (double)samples, MOST_SAMPLES);
    struct state *kept = border_array(samples, sizeof *kept);
    tried(start, tick, samples, kept);
    border_tell();
    move_states(kept, samples);
    free(kept);
}

bool clock_is_right(double width, double height, program *run)
{
    bool right;
    tried = run;
    border_anew();
    border_call();
    border_doubles(&width, 1);
    border_doubles(&height, 1);
    border_wait();
    border_bools(&right, 1);
    return right;
}

#endif
