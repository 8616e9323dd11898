/* What crosses the border of exercise 06b: see examiner/border.h, and for
   the random numbers examiner/supply.h. */
/* place: mean_square x n */
/* place: mean_square y n */
/* place: mean_square accepted 1 */

#include "examiner/supply.h"

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted);

/* Of the suite; here, too, so that src/examiner/check.mk finds them. */
double uniform(void);
void uniform_ahead(double u[], size_t count);

/* The arguments but for the three places. */
struct call {
    size_t n, tries;
    double radius, dish, step;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_sizes(&c->tries, 1);
    border_doubles(&c->radius, 1);
    border_doubles(&c->dish, 1);
    border_doubles(&c->step, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *x = border_place_doubles("x", c.n);
    double *y = border_place_doubles("y", c.n);
    size_t *accepted = border_place_sizes("accepted", 1);
    take_block();
    double mean =
        mean_square(c.n, c.radius, c.dish, c.step, c.tries, x, y, accepted);
    border_reply();
    border_doubles(&mean, 1);
    border_sizes(&block.left, 1);
    border_sizes(accepted, 1);
    border_doubles(x, c.n);
    border_doubles(y, c.n);
}

#else

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    struct call c = {n, tries, radius, dish, step};
    double mean;
    size_t left;
    border_call();
    move_arguments(&c);
    border_doubles(x, n);
    border_doubles(y, n);
    border_sizes(accepted, 1);
    give_block();
    border_wait();
    border_doubles(&mean, 1);
    border_sizes(&left, 1);
    border_sizes(accepted, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    use_up(left);
    return mean;
}

#endif
