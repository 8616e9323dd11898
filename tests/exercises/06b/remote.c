/* The remote calls of exercise 06b: see examiner/remote.h, and for
   the random numbers examiner/remote_random.h. */
/* output: mean_square x n */
/* output: mean_square y n */
/* output: mean_square accepted 1 */

#include "examiner/remote_random.h"

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
    remote_sizes(&c->n, 1);
    remote_sizes(&c->tries, 1);
    remote_doubles(&c->radius, 1);
    remote_doubles(&c->dish, 1);
    remote_doubles(&c->step, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *x = remote_output_doubles("x", c.n);
    double *y = remote_output_doubles("y", c.n);
    size_t *accepted = remote_output_sizes("accepted", 1);
    take_block();
    double mean =
        mean_square(c.n, c.radius, c.dish, c.step, c.tries, x, y, accepted);
    remote_reply();
    remote_doubles(&mean, 1);
    remote_sizes(&block.left, 1);
    remote_sizes(accepted, 1);
    remote_doubles(x, c.n);
    remote_doubles(y, c.n);
}

#else

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    struct call c = {n, tries, radius, dish, step};
    double mean;
    size_t left;
    remote_call();
    move_arguments(&c);
    remote_doubles(x, n);
    remote_doubles(y, n);
    remote_sizes(accepted, 1);
    give_block();
    remote_wait();
    remote_doubles(&mean, 1);
    remote_sizes(&left, 1);
    remote_sizes(accepted, 1);
    remote_doubles(x, n);
    remote_doubles(y, n);
    use_up(left);
    return mean;
}

#endif
