/* The remote calls of exercise 08c: see examiner/remote.h. With the
   runs comes the place behind them: the suite has put something there. */
/* output: measure_order order 1 */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

enum verdict { TOO_FEW, NOT_YET, MEASURED };

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order);

/* The arguments but for the runs and the order. */
struct call {
    size_t n;
    double rounding;
};

static void move_arguments(struct call *c)
{
    remote_sizes(&c->n, 1);
    remote_doubles(&c->rounding, 1);
}

#ifdef REMOTE_SERVER

static double *take_doubles(size_t count)
{
    double *x = remote_array(count, sizeof *x);
    remote_doubles(x, count);
    return x;
}

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *h = take_doubles(c.n + 1), *error = take_doubles(c.n + 1);
    double *order = remote_output_doubles("order", 1);
    int verdict = (int)measure_order(c.n, h, error, c.rounding, order);
    free(h);
    free(error);
    remote_reply();
    remote_ints(&verdict, 1);
    remote_doubles(order, 1);
}

#else

static void give_doubles(const double x[], size_t count)
{
    double *copy = remote_array(count, sizeof *copy);
    memcpy(copy, x, count * sizeof *copy);
    remote_doubles(copy, count);
    free(copy);
}

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    struct call c = {n, rounding};
    int verdict;
    remote_call();
    move_arguments(&c);
    give_doubles(h, n + 1);
    give_doubles(error, n + 1);
    remote_doubles(order, 1);
    remote_wait();
    remote_ints(&verdict, 1);
    remote_doubles(order, 1);
    return (enum verdict)verdict;
}

#endif
