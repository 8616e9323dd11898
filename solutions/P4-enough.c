/* Project P4. Enough

   P4 BODIES T TOL: first it finds out where the bodies are, by the method
   of the highest order; then it tries each method with more and fewer steps
   until its end is as far from there as TOL allows. */

#include "force.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8, LIMIT = 50000 };

static int n;
static double mass[MOST], start[4 * MOST], end_time, tolerance;
static long calls;

static void give_up(int status, const char *why)
{
    fprintf(stderr, "P4: %s\n", why);
    exit(status);
}

static double number(const char *text, const char *why)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !isfinite(value) || !(value > 0))
        give_up(2, why);
    return value;
}

static void read_bodies(const char *name)
{
    char line[1000], more;
    FILE *file = fopen(name, "r");
    if (!file)
        give_up(2, "BODIES: there is no such file");
    while (fgets(line, sizeof line, file)) {
        double m = 0, *z = start + 4 * n;
        line[strcspn(line, "#")] = '\0';
        if (line[strspn(line, " \t\r\n")] == '\0')
            continue;
        if (n == MOST || sscanf(line, "%lf %lf %lf %lf %lf %c", &m, z,
                                z + 1, z + 2, z + 3, &more) != 5)
            give_up(2, "BODIES: a line that is not five numbers");
        if (!(m > 0) || !isfinite(m + z[0] + z[1]) ||
            !isfinite(z[2] + z[3]))
            give_up(2, "BODIES: a mass not above 0, or no number");
        for (int i = n; i-- > 0;)
            if (z[0] == start[4 * i] && z[1] == start[4 * i + 1])
                give_up(2, "BODIES: two in one place");
        mass[n++] = m;
    }
    fclose(file);
    if (n == 0)
        give_up(2, "BODIES: no body");
}

/* A run: places in x, velocities in v. */
struct run {
    double x[2 * MOST], v[2 * MOST], f[2 * MOST];
};

static void ask(struct run *r)
{
    ++calls;
    force(n, mass, r->x, r->f);
}

static void push(struct run *r, double h)
{
    for (int c = 2 * n; c-- > 0;)
        r->v[c] += h * r->f[c] / mass[c / 2];
}

static void glide(struct run *r, double h)
{
    for (int c = 2 * n; c-- > 0;)
        r->x[c] += h * r->v[c];
}

static void hop(struct run *r, double h)
{
    push(r, h / 2);
    glide(r, h);
    ask(r);
    push(r, h / 2);
}

static struct run go(int order, long steps)
{
    const double h = end_time / (double)steps;
    const double outer = 1 / (2 - pow(2, 1.0 / 3));
    struct run r;
    for (int i = n; i-- > 0;) {
        memcpy(r.x + 2 * i, start + 4 * i, 2 * sizeof *start);
        memcpy(r.v + 2 * i, start + 4 * i + 2, 2 * sizeof *start);
    }
    if (order > 1)
        ask(&r);
    for (long k = steps; k-- > 0;) {
        if (order == 1) {
            ask(&r);
            push(&r, h);
            glide(&r, h);
        } else if (order == 2) {
            hop(&r, h);
        } else {
            hop(&r, outer * h);
            hop(&r, h - 2 * outer * h);
            hop(&r, outer * h);
        }
    }
    return r;
}

static double price(int order, double steps)
{
    return order == 1 ? steps : order == 2 ? steps + 1 : 3 * steps + 1;
}

static double between(const struct run *a, const struct run *b)
{
    double most = 0;
    for (int c = 2 * (n - 1); c >= 0; c -= 2)
        most =
            fmax(most, hypot(a->x[c] - b->x[c], a->x[c + 1] - b->x[c + 1]));
    return most;
}

/* Where they are, to a sixtieth of the tolerance: two runs agree, of which
   one has half the steps, and that one with one of a quarter as well as the
   power of the method lets it. They may have more than the pick. */
static struct run find_truth(void)
{
    double before = INFINITY;
    struct run last = go(4, 16);
    for (long steps = 32; steps <= 4 * LIMIT; steps *= 2) {
        const struct run now = go(4, steps);
        const double gap = between(&now, &last);
        if (gap <= tolerance / 4 && before <= 4 * tolerance)
            return now;
        before = gap;
        last = now;
    }
    give_up(1, "no method holds TOL with 50000 steps");
    return last;
}

struct pick {
    int order;
    long steps;
    double error;
    struct run end;
};

static struct pick try_with(int order, long steps, const struct run *truth)
{
    struct pick p = {order, steps, 0, go(order, steps)};
    p.error = between(&p.end, truth);
    return p;
}

/* Makes *best the method if it is cheaper: it doubles the steps until they
   are enough, then goes where its power says that TOL is, from either side.
   What is more than twice as expensive by its power has lost, once its
   error falls by that. */
static void see_whether_cheaper(int order, const struct run *truth,
                                struct pick *best)
{
    struct pick few = {.error = INFINITY}, many = try_with(order, 1, truth);
    while (!(many.error <= tolerance)) {
        const double power = pow(many.error / tolerance, 1.0 / order);
        const double fall = few.error / many.error / pow(2, order);
        const double most = price(best->order, (double)best->steps);
        few = many;
        if (few.steps > LIMIT || price(order, (double)few.steps) >= most ||
            (fabs(fall - 1) < 0.15 &&
             price(order, (double)few.steps * power) > 4 * most))
            return;
        many = try_with(order, 2 * few.steps, truth);
    }
    while (many.steps - few.steps > 1 + few.steps / 100 &&
           many.error < pow(0.87, order) * tolerance) {
        const double power = log(few.error / many.error) /
                             log((double)many.steps / (double)few.steps);
        const double guess = (double)few.steps *
                             pow(few.error / (0.93 * tolerance), 1 / power);
        const double room = (double)(many.steps - few.steps) / 10;
        const struct pick p = try_with(
            order,
            (long)fmax((double)few.steps + fmax(room, 1),
                       fmin((double)many.steps - fmax(room, 1), guess)),
            truth);
        *(p.error > tolerance ? &few : &many) = p;
    }
    if (many.steps <= LIMIT &&
        price(order, many.steps) < price(best->order, best->steps))
        *best = many;
}

int main(int argc, char **argv)
{
    struct pick best = {.order = 4, .steps = LIMIT + 1};
    if (argc != 4)
        give_up(2, "usage: P4 BODIES T TOL");
    end_time = number(argv[2], "T must be a number above 0");
    /* The truth is not known better than to a sixtieth of it. */
    tolerance = 0.97 * number(argv[3], "TOL must be a number above 0");
    read_bodies(argv[1]);
    const struct run truth = find_truth();
    see_whether_cheaper(4, &truth, &best);
    see_whether_cheaper(2, &truth, &best);
    see_whether_cheaper(1, &truth, &best);
    if (best.steps > LIMIT)
        give_up(1, "no method holds TOL with 50000 steps");
    const struct run *r = &best.end;
    printf("# pick %d %ld", best.order, best.steps);
    printf(" %ld\n%.17g", calls, end_time);
    for (int c = 0; c < 2 * n; c += 2)
        printf(" %.17g %.17g %.17g %.17g", r->x[c], r->x[c + 1], r->v[c],
               r->v[c + 1]);
    putchar('\n');
    return 0;
}
