/* What crosses the border of exercise 03d: see examiner/border.h. */
/* place: error_by_blocks error 1 */
/* place: error_by_blocks inefficiency 1 */

#include "examiner/border.h"
#include <stdlib.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency);

/* The numbers among the arguments; the series and the two places follow. */
struct call {
    size_t n, length;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_sizes(&c->length, 1);
}

static void move_answer(bool *told, double *error, double *inefficiency)
{
    border_bools(told, 1);
    border_doubles(error, 1);
    border_doubles(inefficiency, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *x = border_memory(c.n * sizeof *x);
    border_doubles(x, c.n);
    double *error = border_place_doubles("error", 1);
    double *inefficiency = border_place_doubles("inefficiency", 1);
    bool told = error_by_blocks(c.n, x, c.length, error, inefficiency);
    border_reply();
    move_answer(&told, error, inefficiency);
    free(x);
}

#else

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    struct call c = {n, length};
    bool told;
    border_call();
    move_arguments(&c);
    border_doubles((double *)x, n); /* which only reads on this side */
    border_doubles(error, 1);
    border_doubles(inefficiency, 1);
    border_wait();
    move_answer(&told, error, inefficiency);
    return told;
}

#endif
