/* What crosses the border of exercise 12d: see examiner/border.h. With the
   bodies comes one behind the last: the suite has put something there. */
/* place: one_line along 3 */

#include "examiner/border.h"
#include <stdlib.h>
#include <string.h>

struct body {
    int x[3];
    int v[3];
};

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3]);

/* The arguments but for the bodies and the direction. */
struct call {
    size_t n;
    int weight[3];
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_ints(c->weight, 3);
}

static void move_bodies(struct body *body, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        border_ints(body[i].x, 3);
        border_ints(body[i].v, 3);
    }
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const int weight[3] = {c.weight[0], c.weight[1], c.weight[2]};
    struct body *body = border_memory((c.n + 1) * sizeof *body);
    move_bodies(body, c.n + 1);
    int *along = border_place_ints("along", 3);
    bool line = one_line(c.n, body, weight, along);
    free(body);
    border_reply();
    border_bools(&line, 1);
    border_ints(along, 3);
}

#else

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    struct call c = {n, {weight[0], weight[1], weight[2]}};
    struct body *copy = border_memory((n + 1) * sizeof *copy);
    bool line;
    memcpy(copy, body, (n + 1) * sizeof *copy);
    border_call();
    move_arguments(&c);
    move_bodies(copy, n + 1);
    free(copy);
    border_ints(along, 3);
    border_wait();
    border_bools(&line, 1);
    border_ints(along, 3);
    return line;
}

#endif
