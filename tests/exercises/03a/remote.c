/* The remote calls of exercise 03a: see examiner/remote.h. The law
   stays with the judge; the sandbox asks for it, value by value. Who asks
   in the middle of an interval will ask in the middle of one of its halves,
   and so on: with the value come those of the next four rounds, whichever
   halves are taken. */
/* output: equal_bins edge bins+1 */

#include "examiner/remote.h"
#include <math.h>

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[]);

/* The numbers among the arguments; the edges follow, bins + 1 of them. */
struct call {
    double low, high;
    size_t bins;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->low, 1);
    remote_doubles(&c->high, 1);
    remote_sizes(&c->bins, 1);
}

/* A place that was asked for, in an interval; and the middles that may be
   asked for next, each behind those from which it is reached. Middle 0 is
   the place itself. */
enum { MIDDLES = 31 };

struct search {
    double low, at, high;
    int rounded; /* in which of the two usual ways to write a middle */
    double middle[MIDDLES], below[MIDDLES];
};

static double between(double a, double b, int rounded)
{
    return rounded ? 0.5 * (a + b) : a + 0.5 * (b - a);
}

static void move_search(struct search *s)
{
    remote_doubles(&s->low, 1);
    remote_doubles(&s->at, 1);
    remote_doubles(&s->high, 1);
    remote_ints(&s->rounded, 1);
}

static void find_middles(struct search *s)
{
    double low[MIDDLES] = {s->low}, high[MIDDLES] = {s->high};
    s->middle[0] = s->at;
    for (int i = 0; 2 * i + 2 < MIDDLES; ++i)
        for (int k = 1; k <= 2; ++k) {
            low[2 * i + k] = k == 1 ? low[i] : s->middle[i];
            high[2 * i + k] = k == 1 ? s->middle[i] : high[i];
            s->middle[2 * i + k] =
                between(low[2 * i + k], high[2 * i + k], s->rounded);
        }
}

#ifdef REMOTE_SERVER

static struct search search;
static struct call whole;

static bool in_the_middle(double a, double b, double x)
{
    for (int way = 0; way < 2; ++way, search.rounded = !search.rounded)
        if (between(a, b, search.rounded) == x) {
            search.low = a;
            search.high = b;
            return true;
        }
    return false;
}

/* Of which interval is this the middle? Of a half of the last one; or a
   new search has begun, between the ends or from where the last one was. */
static void look_around(double x)
{
    const double low = search.low, at = search.at, high = search.high;
    (void)(in_the_middle(x < at ? low : at, x < at ? at : high, x) ||
           in_the_middle(whole.low, whole.high, x) ||
           in_the_middle(whole.low, high, x) ||
           in_the_middle(low, whole.high, x) ||
           in_the_middle(whole.low, at, x) ||
           in_the_middle(at, whole.high, x) ||
           (search.low = search.high = x, true));
    search.at = x;
}

static double distribution(double x)
{
    const bool inside = x >= whole.low && x <= whole.high;
    look_around(x);
    for (int i = 0; i < MIDDLES && inside; ++i)
        if (search.middle[i] == x)
            return search.below[i];
    remote_callback(0);
    move_search(&search);
    remote_callback_wait();
    remote_doubles(search.below, MIDDLES);
    find_middles(&search);
    return search.below[0];
}

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    whole = c;
    search.low = search.at = c.low;
    search.high = c.high;
    for (int i = 0; i < MIDDLES; ++i)
        search.middle[i] = NAN; /* none is known yet */
    double *edge = remote_output_doubles("edge", c.bins + 1);
    equal_bins(distribution, c.low, c.high, c.bins, edge);
    remote_reply();
    remote_doubles(edge, c.bins + 1);
}

#else

/* Of the call that is under way. */
static double (*law)(double x);
static struct call present;

/* The law is asked between the ends alone, or where the sandbox has asked.
 */
void remote_serve_callback(int which)
{
    struct search s;
    (void)which;
    move_search(&s);
    find_middles(&s);
    for (int i = 0; i < MIDDLES; ++i) {
        const double x = s.middle[i];
        const bool inside = x >= present.low && x <= present.high;
        s.below[i] = i == 0 || inside ? law(x) : 0.0;
    }
    remote_callback_reply();
    remote_doubles(s.below, MIDDLES);
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    struct call c = {low, high, bins};
    law = distribution;
    present = c;
    remote_call();
    move_arguments(&c);
    remote_doubles(edge, bins + 1);
    remote_wait();
    remote_doubles(edge, bins + 1);
}

#endif
