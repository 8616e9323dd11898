/* What crosses the border of exercise 12a: see examiner/border.h. With the
   choices and the places for the front comes one more of each: the suite
   has put something there. */
/* place: pareto_front front n suite */

#include "examiner/border.h"
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
        border_doubles(&choice[i].cost, 1);
        border_doubles(&choice[i].error, 1);
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    border_sizes(&n, 1);
    struct choice *choice = border_array((n + 1), sizeof *choice);
    move_choices(choice, n + 1);
    size_t *front = border_place_sizes("front", n + 1);
    size_t count = pareto_front(n, choice, front);
    border_reply();
    border_sizes(&count, 1);
    border_sizes(front, n + 1);
    free(choice);
}

#else

size_t pareto_front(size_t n, const struct choice choice[], size_t front[])
{
    size_t count, many = n;
    struct choice *copy = border_array((n + 1), sizeof *copy);
    memcpy(copy, choice, (n + 1) * sizeof *copy);
    border_call();
    border_sizes(&many, 1);
    move_choices(copy, n + 1);
    border_sizes(front, n + 1);
    free(copy);
    border_wait();
    border_sizes(&count, 1);
    border_sizes(front, n + 1);
    return count;
}

#endif
