/* The remote calls of exercise 08b: see examiner/remote.h. The
   slopes stay outside and are asked for. With the numbers comes the place
   behind them: the suite has put something there. */
/* output: three_eighths a 16 */
/* output: three_eighths b 4 */
/* output: tableau_step y n suite */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

void slope(double t, const double y[], double dy[]);
void three_eighths(double a[], double b[]);
void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[]);

enum { MOST = 12, ENTRIES = 16, WEIGHTS = 4 };

/* Which function is called; and the arguments of a step but for arrays. */
enum { TABLE, STEP };

struct call {
    int which;
    size_t stages, n;
    double t, h;
};

static void move_arguments(struct call *c)
{
    remote_ints(&c->which, 1);
    remote_sizes(&c->stages, 1);
    remote_sizes(&c->n, 1);
    remote_doubles(&c->t, 1);
    remote_doubles(&c->h, 1);
}

/* How many numbers the call that is under way has. */
static size_t present;

#ifdef REMOTE_SERVER

void slope(double t, const double y[], double dy[])
{
    double copy[MOST];
    memcpy(copy, y, present * sizeof *copy);
    remote_callback(0);
    remote_doubles(&t, 1);
    remote_doubles(copy, present);
    remote_callback_wait();
    remote_doubles(dy, present);
}

static double *take_doubles(size_t count)
{
    double *x = remote_array(count, sizeof *x);
    remote_doubles(x, count);
    return x;
}

static void answer_table(void)
{
    double *a = remote_output_doubles("a", ENTRIES);
    double *b = remote_output_doubles("b", WEIGHTS);
    three_eighths(a, b);
    remote_reply();
    remote_doubles(a, ENTRIES);
    remote_doubles(b, WEIGHTS);
}

static void answer_step(const struct call *c)
{
    double *a = take_doubles(c->stages * c->stages);
    double *b = take_doubles(c->stages);
    double *y = remote_output_doubles("y", c->n + 1);
    present = c->n;
    tableau_step(c->stages, a, b, c->n, c->t, c->h, y);
    remote_reply();
    remote_doubles(y, c->n + 1);
    free(a);
    free(b);
}

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    if (c.which == TABLE)
        answer_table();
    else
        answer_step(&c);
}

#else

void remote_serve_callback(int which)
{
    double t, y[MOST], dy[MOST];
    (void)which;
    remote_doubles(&t, 1);
    remote_doubles(y, present);
    slope(t, y, dy);
    remote_callback_reply();
    remote_doubles(dy, present);
}

static void give_doubles(const double x[], size_t count)
{
    double *copy = remote_array(count, sizeof *copy);
    memcpy(copy, x, count * sizeof *copy);
    remote_doubles(copy, count);
    free(copy);
}

void three_eighths(double a[], double b[])
{
    struct call c = {.which = TABLE};
    remote_call();
    move_arguments(&c);
    remote_doubles(a, ENTRIES);
    remote_doubles(b, WEIGHTS);
    remote_wait();
    remote_doubles(a, ENTRIES);
    remote_doubles(b, WEIGHTS);
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    struct call c = {STEP, stages, n, t, h};
    present = n;
    remote_call();
    move_arguments(&c);
    give_doubles(a, stages * stages);
    give_doubles(b, stages);
    remote_doubles(y, n + 1);
    remote_wait();
    remote_doubles(y, n + 1);
}

#endif
