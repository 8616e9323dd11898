/* What crosses the border of exercise 12b: see examiner/border.h. The step
   stays with the judge; the box asks for it, and gets the steps that follow
   as well. With its next question it says how many of these were used. */
/* place: apart end 1 */

#include "examiner/border.h"

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
    border_doubles(&c->w.g, 1);
    border_doubles(&c->w.k, 1);
    border_doubles(&c->w.q, 1);
    border_doubles(&c->h, 1);
    border_doubles(&c->x, 1);
    border_doubles(&c->v, 1);
}

/* Steps in a row: the first one of them was asked for. */
struct row {
    struct call of;
    double x[ROW], v[ROW];
    size_t used;
};

static struct row row;

static void move_row(void)
{
    border_doubles(row.x, ROW);
    border_doubles(row.v, ROW);
}

#ifdef BORDER_INSIDE

static bool is_next(const struct call *c)
{
    const struct call *of = &row.of;
    const size_t last = row.used - 1;
    return row.used > 0 && row.used < ROW && c->h == of->h &&
           c->w.g == of->w.g && c->w.k == of->w.k && c->w.q == of->w.q &&
           c->x == row.x[last] && c->v == row.v[last];
}

static void step(struct world w, double h, double *x, double *v)
{
    struct call c = {w, h, *x, *v};
    if (!is_next(&c)) {
        border_ask(0);
        border_sizes(&row.used, 1);
        move_call(&c);
        border_hear();
        move_row();
        row.of = c;
        row.used = 0;
    }
    *x = row.x[row.used];
    *v = row.v[row.used++];
}

void border_answer(void)
{
    struct call c;
    int n;
    row.used = 0;
    move_call(&c);
    border_ints(&n, 1);
    double *end = border_place_doubles("end", 1);
    double far = apart(step, c.w, c.h, n, c.x, c.v, end);
    border_reply();
    border_sizes(&row.used, 1);
    border_doubles(&far, 1);
    border_doubles(end, 1);
}

#else

static void (*taken)(struct world w, double h, double *x, double *v);

/* In the suite. */
void step_ahead(void (*step)(struct world w, double h, double *x,
                             double *v),
                struct world w, double h, double *x, double *v);

static void use(size_t used)
{
    struct call *c = &row.of;
    for (size_t i = 0; i < used && i < ROW; ++i)
        taken(c->w, c->h, &c->x, &c->v);
}

void border_heed(int which)
{
    struct call c;
    size_t used;
    (void)which;
    border_sizes(&used, 1);
    move_call(&c);
    use(used);
    row.of = c;
    for (size_t i = 0; i < ROW; ++i) {
        step_ahead(taken, c.w, c.h, &c.x, &c.v);
        row.x[i] = c.x;
        row.v[i] = c.v;
    }
    border_tell();
    move_row();
}

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    struct call c = {w, h, x, v};
    double far;
    size_t used;
    taken = step;
    border_call();
    move_call(&c);
    border_ints(&n, 1);
    border_doubles(end, 1);
    border_wait();
    border_sizes(&used, 1);
    border_doubles(&far, 1);
    border_doubles(end, 1);
    use(used);
    return far;
}

#endif
