/* What crosses the border of exercise 08b: see examiner/border.h. The
   slopes stay outside and are asked for. With the numbers comes the place
   behind them: the suite has put something there. */
/* place: three_eighths a 16 */
/* place: three_eighths b 4 */
/* place: tableau_step y n suite */

#include "examiner/border.h"
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
    border_ints(&c->which, 1);
    border_sizes(&c->stages, 1);
    border_sizes(&c->n, 1);
    border_doubles(&c->t, 1);
    border_doubles(&c->h, 1);
}

/* How many numbers the call that is under way has. */
static size_t present;

#ifdef BORDER_INSIDE

void slope(double t, const double y[], double dy[])
{
    double copy[MOST];
    memcpy(copy, y, present * sizeof *copy);
    border_ask(0);
    border_doubles(&t, 1);
    border_doubles(copy, present);
    border_hear();
    border_doubles(dy, present);
}

static double *take_doubles(size_t count)
{
    double *x = border_array(count, sizeof *x);
    border_doubles(x, count);
    return x;
}

static void answer_table(void)
{
    double *a = border_place_doubles("a", ENTRIES);
    double *b = border_place_doubles("b", WEIGHTS);
    three_eighths(a, b);
    border_reply();
    border_doubles(a, ENTRIES);
    border_doubles(b, WEIGHTS);
}

static void answer_step(const struct call *c)
{
    double *a = take_doubles(c->stages * c->stages);
    double *b = take_doubles(c->stages);
    double *y = border_place_doubles("y", c->n + 1);
    present = c->n;
    tableau_step(c->stages, a, b, c->n, c->t, c->h, y);
    border_reply();
    border_doubles(y, c->n + 1);
    free(a);
    free(b);
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    if (c.which == TABLE)
        answer_table();
    else
        answer_step(&c);
}

#else

void border_heed(int which)
{
    double t, y[MOST], dy[MOST];
    (void)which;
    border_doubles(&t, 1);
    border_doubles(y, present);
    slope(t, y, dy);
    border_tell();
    border_doubles(dy, present);
}

static void give_doubles(const double x[], size_t count)
{
    double *copy = border_array(count, sizeof *copy);
    memcpy(copy, x, count * sizeof *copy);
    border_doubles(copy, count);
    free(copy);
}

void three_eighths(double a[], double b[])
{
    struct call c = {.which = TABLE};
    border_call();
    move_arguments(&c);
    border_doubles(a, ENTRIES);
    border_doubles(b, WEIGHTS);
    border_wait();
    border_doubles(a, ENTRIES);
    border_doubles(b, WEIGHTS);
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    struct call c = {STEP, stages, n, t, h};
    present = n;
    border_call();
    move_arguments(&c);
    give_doubles(a, stages * stages);
    give_doubles(b, stages);
    border_doubles(y, n + 1);
    border_wait();
    border_doubles(y, n + 1);
}

#endif
