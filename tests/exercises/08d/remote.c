/* The remote calls of exercise 08d: see examiner/remote.h. The
   method stays outside and its steps are asked for. Who has asked for a
   step from (1, 0) mostly asks for the one from (0, 1) next, as long, and
   then for both of the next length on the way up: these are given at
   once. */
/* output: none */

#include "examiner/remote.h"
#include <math.h>

void step(double h, double y[2]);
double stability_limit(double most);

/* Both steps of a length. */
struct pair {
    double h, of_x[2], of_v[2];
};

enum { AHEAD = 32 };

static struct {
    size_t count;
    struct pair pairs[AHEAD];
} ahead;

static void move_ahead(void)
{
    remote_sizes(&ahead.count, 1);
    for (size_t i = 0; i < ahead.count && i < AHEAD; ++i) {
        remote_doubles(&ahead.pairs[i].h, 1);
        remote_doubles(ahead.pairs[i].of_x, 2);
        remote_doubles(ahead.pairs[i].of_v, 2);
    }
}

#ifdef REMOTE_SERVER

static const double *find(double h, const double y[2])
{
    const bool x = y[0] == 1.0 && y[1] == 0.0;
    const bool v = y[0] == 0.0 && y[1] == 1.0;
    for (size_t i = 0; i < ahead.count && (x || v); ++i)
        if (ahead.pairs[i].h == h)
            return x ? ahead.pairs[i].of_x : ahead.pairs[i].of_v;
    return NULL;
}

void step(double h, double y[2])
{
    const double *known = find(h, y);
    if (known) {
        y[0] = known[0];
        y[1] = known[1];
        return;
    }
    remote_callback(0);
    remote_doubles(&h, 1);
    remote_doubles(y, 2);
    remote_callback_wait();
    remote_doubles(y, 2);
    move_ahead();
}

void remote_serve(void)
{
    double most, limit;
    ahead.count = 0;
    remote_doubles(&most, 1);
    limit = stability_limit(most);
    remote_reply();
    remote_doubles(&limit, 1);
}

#else

static void look(double h)
{
    struct pair p = {h, {1.0, 0.0}, {0.0, 1.0}};
    step(h, p.of_x);
    step(h, p.of_v);
    if (ahead.count < AHEAD)
        ahead.pairs[ahead.count++] = p;
}

/* From h up, where it is one of the steps that the exercise wants tried;
   some say 0.01 k for it, and some k/100, which may be rounded otherwise.
 */
static void look_ahead(double h)
{
    double k = h > 0.0 && h < 1e3 ? floor(100.0 * h + 0.5) : 0.0;
    ahead.count = 0;
    look(h);
    if (h != 0.01 * k && h != k / 100.0)
        return;
    while (ahead.count < AHEAD) {
        k += 1.0;
        look(0.01 * k);
        if (0.01 * k != k / 100.0)
            look(k / 100.0);
    }
}

void remote_serve_callback(int which)
{
    double h, y[2];
    (void)which;
    remote_doubles(&h, 1);
    remote_doubles(y, 2);
    look_ahead(h);
    step(h, y);
    remote_callback_reply();
    remote_doubles(y, 2);
    move_ahead();
}

double stability_limit(double most)
{
    double limit;
    remote_call();
    remote_doubles(&most, 1);
    remote_wait();
    remote_doubles(&limit, 1);
    return limit;
}

#endif
