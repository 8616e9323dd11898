/* The remote calls of exercise 12b: see examiner/remote.h. The step
   stays with the judge; the box asks for it, and gets the steps that follow
   as well, a row of them. Two worlds may take turns, so there are two rows.
   With its next question the box says how many steps were used. */
/* output: apart end 1 */

#include "examiner/remote.h"

enum { ROW = 32 };

struct world {
    double g, k, q;
};

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end);

/* The constants, the step, and a place with a velocity. */
struct call {
    struct world w;
    double h, x, v;
};

static void move_call(struct call *c)
{
    remote_doubles(&c->w.g, 1);
    remote_doubles(&c->w.k, 1);
    remote_doubles(&c->w.q, 1);
    remote_doubles(&c->h, 1);
    remote_doubles(&c->x, 1);
    remote_doubles(&c->v, 1);
}

/* Steps in a row: the first one of them was asked for. */
struct row {
    struct call of; /* where it begins; for the judge, where it is */
    double x[ROW], v[ROW];
    size_t used, told; /* and how many of these the judge knows */
};

static struct row rows[2];

static void move_row(struct row *row)
{
    remote_doubles(row->x, ROW);
    remote_doubles(row->v, ROW);
}

#ifdef REMOTE_SERVER

static bool same_world(const struct call *a, const struct call *b)
{
    return a->h == b->h && a->w.g == b->w.g && a->w.k == b->w.k &&
           a->w.q == b->w.q;
}

static bool is_next(const struct row *row, const struct call *c)
{
    const size_t last = row->used - 1;
    return row->used > 0 && row->used < ROW && same_world(c, &row->of) &&
           c->x == row->x[last] && c->v == row->v[last];
}

static void tell_used(void)
{
    for (struct row *row = rows; row < rows + 2; ++row) {
        size_t more = row->used - row->told;
        remote_sizes(&more, 1);
        row->told = row->used;
    }
}

/* Into the row of the same world, or else the one that was not filled
   last. */
static struct row *ask(struct call *c)
{
    static int last;
    if (!same_world(c, &rows[last].of))
        last = !last;
    remote_callback(last);
    tell_used();
    move_call(c);
    remote_callback_wait();
    move_row(&rows[last]);
    rows[last].of = *c;
    rows[last].used = rows[last].told = 0;
    return &rows[last];
}

static void step(struct world w, double h, double *x, double *v)
{
    struct call c = {w, h, *x, *v};
    struct row *row = is_next(&rows[0], &c)   ? &rows[0]
                      : is_next(&rows[1], &c) ? &rows[1]
                                              : ask(&c);
    *x = row->x[row->used];
    *v = row->v[row->used++];
}

void remote_serve(void)
{
    struct call c;
    int n;
    for (int i = 0; i < 2; ++i)
        rows[i].used = rows[i].told = 0;
    move_call(&c);
    remote_ints(&n, 1);
    double *end = remote_output_doubles("end", 1);
    double far = apart(step, c.w, c.h, n, c.x, c.v, end);
    remote_reply();
    tell_used();
    remote_doubles(&far, 1);
    remote_doubles(end, 1);
}

#else

static void (*taken)(struct world w, double h, double *x, double *v);

/* In the suite. */
void step_ahead(void (*step)(struct world w, double h, double *x,
                             double *v),
                struct world w, double h, double *x, double *v);

static void hear_used(void)
{
    size_t used[2];
    remote_sizes(used, 2);
    for (int r = 0; r < 2; ++r)
        for (size_t i = 0; i < used[r] && i < ROW; ++i) {
            struct call *c = &rows[r].of;
            taken(c->w, c->h, &c->x, &c->v);
        }
}

void remote_serve_callback(int which)
{
    struct row *row = &rows[which & 1];
    hear_used();
    move_call(&row->of);
    struct call c = row->of;
    for (size_t i = 0; i < ROW; ++i) {
        step_ahead(taken, c.w, c.h, &c.x, &c.v);
        row->x[i] = c.x;
        row->v[i] = c.v;
    }
    remote_callback_reply();
    move_row(row);
}

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    struct call c = {w, h, x, v};
    double far;
    taken = step;
    remote_call();
    move_call(&c);
    remote_ints(&n, 1);
    remote_doubles(end, 1);
    remote_wait();
    hear_used();
    remote_doubles(&far, 1);
    remote_doubles(end, 1);
    return far;
}

#endif
