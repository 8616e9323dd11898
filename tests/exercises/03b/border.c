/* What crosses the border of exercise 03b: see examiner/border.h. */
/* place: bin_surprise z 1 */

#include "examiner/border.h"

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z);

/* The arguments; z follows. */
struct call {
    size_t count, samples;
    double probability, inefficiency;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->count, 1);
    border_sizes(&c->samples, 1);
    border_doubles(&c->probability, 1);
    border_doubles(&c->inefficiency, 1);
}

static void move_answer(bool *judged, double *z)
{
    border_bools(judged, 1);
    border_doubles(z, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *z = border_place_doubles("z", 1);
    bool judged =
        bin_surprise(c.count, c.samples, c.probability, c.inefficiency, z);
    border_reply();
    move_answer(&judged, z);
}

#else

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    struct call c = {count, samples, probability, inefficiency};
    bool judged;
    border_call();
    move_arguments(&c);
    border_doubles(z, 1);
    border_wait();
    move_answer(&judged, z);
    return judged;
}

#endif
