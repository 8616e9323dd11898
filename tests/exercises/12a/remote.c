/* The remote calls of exercise 12a: see examiner/remote.h. With the
   choices and the places for the front comes one more of each: the suite
   has put something there. */
/* output: pareto_front front n suite */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

struct choice {
    double cost;
    double error;
};

size_t pareto_front(size_t n, const struct choice choice[], size_t front[]);

static void move_choices(struct choice *choice, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        remote_doubles(&choice[i].cost, 1);
        remote_doubles(&choice[i].error, 1);
    }
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    remote_sizes(&n, 1);
    struct choice *choice = remote_array((n + 1), sizeof *choice);
    move_choices(choice, n + 1);
    size_t *front = remote_output_sizes("front", n + 1);
    size_t count = pareto_front(n, choice, front);
    remote_reply();
    remote_sizes(&count, 1);
    remote_sizes(front, n + 1);
    free(choice);
}

#else

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    size_t count, many = n;
    struct choice *copy = remote_array((n + 1), sizeof *copy);
    memcpy(copy, choice, (n + 1) * sizeof *copy);
    remote_call();
    remote_sizes(&many, 1);
    move_choices(copy, n + 1);
    remote_sizes(front, n + 1);
    free(copy);
    remote_wait();
    remote_sizes(&count, 1);
    remote_sizes(front, n + 1);
    return count;
}

#endif
