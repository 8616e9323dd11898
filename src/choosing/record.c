/* Runs models, if asked in rescaled units, and compares their rows. */
#include "choosing/record.h"

#include "toolbox/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Returns the extent (in m) of the scene along axis k, without the body
   `without`. Walls count like bodies, since a gas may fill its box or only
   a corner of it. Sets *near to the distance (in m) between the origin and
   this extent. */
static double spread_of(const struct scene *s, size_t k, size_t without,
                        double *near)
{
    const double *x = s->position + k * s->bodies;
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < s->bodies; ++i)
        if (i != without) {
            low = fmin(low, x[i]);
            high = fmax(high, x[i]);
        }
    if (s->wall[k] != SCENE_OPEN) {
        low = fmin(low, s->low[k]);
        high = fmax(high, s->high[k]);
    }
    *near = fmax(fmax(low, -high), 0);
    return fmax(high - low, 0);
}

/* Returns the diagonal (in m) of the box around the walls and all bodies
   except `without`. */
static double size_without(const struct scene *s, size_t without)
{
    double sum = 0, near;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double spread = spread_of(s, k, without, &near);
        sum += spread * spread;
    }
    return sqrt(sum);
}

double record_scale_without(const struct scene *s, size_t *far)
{
    double least = INFINITY;
    for (size_t i = 0; i < s->bodies; ++i) {
        const double size = size_without(s, i);
        if (size < least) {
            least = size;
            *far = i;
        }
    }
    return least;
}

static double speed_of_body(const struct scene *s, size_t i)
{
    const size_t n = s->bodies;
    const double *v = s->velocity + i;
    return sqrt(v[0] * v[0] + v[n] * v[n] + v[2 * n] * v[2 * n]);
}

/* The divisors of errors, in the units of a scene. */
struct scales {
    double length, speed, energy, momentum;
};

/* Returns a, or b if a is zero and thus no scale. For example, the energy
   of bodies at rest without forces is zero. */
static double or_next(double a, double b)
{
    return a > 0 ? a : b;
}

/* Computes the scales from the scene at the start. A single body has no
   size, so its scale of length is the distance that it covers in the run,
   or a metre if it rests. The scale of momentum is the sum of all |p|. The
   absolute value of the total momentum would be zero for two bodies about
   their centre of mass. */
static struct scales measure_scales(const struct record_view *v,
                                    double length)
{
    const struct scene *s = &v->scene;
    const struct motion_energy e = motion_energy(&v->motion);
    const double energy = e.kinetic + (e.gravity + e.springs + e.weight);
    struct scales to = {0};
    double mass = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        mass += s->mass[i];
        to.speed = fmax(to.speed, speed_of_body(s, i));
        to.momentum += s->mass[i] * speed_of_body(s, i);
    }
    to.length =
        or_next(size_without(s, s->bodies), or_next(to.speed * length, 1));
    to.speed = or_next(to.speed, or_next(to.length * models_rate(s, 0),
                                         to.length / length));
    to.energy =
        or_next(fmax(fabs(energy), e.kinetic), mass * to.speed * to.speed);
    to.momentum = or_next(to.momentum, mass * to.speed);
    return to;
}

/* Returns the scale of an observable with this unit, and sets *as to the
   name of the quantity. All kinds of energy have the scale of the total
   energy, as the error of the total is the sum of their errors. */
static double scale_of(const struct scales *to, const char *unit,
                       const char **as)
{
    const struct {
        const char *unit, *as;
        double scale;
    } known[] = {{"length", "positions", to->length},
                 {"length/time", "velocities", to->speed},
                 {"mass length^2/time^2", "energy", to->energy},
                 {"mass length/time", "momentum", to->momentum},
                 {"mass length^2/time", "angular momentum",
                  to->momentum * to->length},
                 {"time", "t", 1},
                 {"", "counts", 1}};
    size_t k = 0;
    while (strcmp(known[k].unit, unit) != 0)
        ++k;
    *as = known[k].as;
    return known[k].scale;
}

/* Sets the scale of a column. `axis` is the axis of a coordinate, or
   SCENE_AXES for any other quantity. In a periodic box coordinates are
   compared modulo the length of the box, but distances and the centre of
   mass are not. */
static void scale_column(struct record_view *v, size_t column, double scale,
                         size_t axis)
{
    const struct scene *s = &v->scene;
    v->rounding[column] = strcmp(v->judged, "counts") == 0 ? 0 : 0x1p-53;
    v->weight[column] = 1 / scale;
    if (axis < SCENE_AXES && s->wall[axis] == SCENE_PERIODIC)
        v->period[column] = s->high[axis] - s->low[axis];
}

/* Sets the scale of each column. Without a list of observables, positions
   and velocities are stored, but only positions are compared: velocities
   keep the weight 0. With a list, v->scale is the scale of the first
   observable. */
static void find_scales(struct record_view *v, double length)
{
    const struct scales to = measure_scales(v, length);
    const size_t n = v->scene.bodies;
    v->length = v->scale = to.length;
    v->judged = "positions";
    for (size_t c = 0; !v->asked && c < SCENE_AXES * n; ++c)
        scale_column(v, 6 * (c % n) + c / n, to.length, c / n);
    size_t column = v->columns;
    for (size_t i = v->asked ? v->asked->count : 0; i-- > 0;) {
        const struct observables_sort o =
            observables_sort(&v->asked->list[i]);
        v->scale = scale_of(&to, o.unit, &v->judged);
        for (size_t k = 0; k < o.width; ++k)
            scale_column(v, --column, v->scale, o.axis);
    }
}

/* Finds the shift that moves the scene to the origin. Returns the rounding
   error of moving rows back, as a fraction of the scale, since runs that
   are compared may share this error. Returns 0 with observables.

   Rounding errors of positions are proportional to the distance from the
   origin, which may be larger than the scene. For example, whether two
   disks four kilometres away miss each other by 3e-13 m can be decided only
   near the origin. */
static double find_origin(struct record_view *v)
{
    const struct scene *s = &v->scene;
    double near, rounded = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if (spread_of(s, k, s->bodies, &near) < near) {
            v->origin[k] = s->position[k * s->bodies];
            rounded = fmax(rounded, 0x1p-53 * fabs(v->origin[k]));
        }
    return v->asked ? 0 : rounded / v->length;
}

bool record_view_create(struct record_view *v, const char *program,
                        const struct scene *s,
                        const struct observables *asked, double length)
{
    *v = (struct record_view){.asked = asked};
    v->columns = asked ? asked->columns : 6 * s->bodies;
    v->weight = calloc(3 * v->columns, sizeof *v->weight);
    const bool room = v->weight && scene_copy(&v->scene, s);
    if (!room)
        fprintf(stderr, "%s: no memory for %zu columns\n", program,
                v->columns);
    if (!room || !motion_view(&v->motion, program, &v->scene)) {
        record_view_free(v);
        return false;
    }
    v->period = v->weight + v->columns;
    v->rounding = v->period + v->columns;
    find_scales(v, length);
    v->rounded = find_origin(v);
    return true;
}

void record_view_free(struct record_view *v)
{
    motion_end(&v->motion);
    scene_free(&v->scene);
    free(v->weight);
    *v = (struct record_view){0};
}

/* The units of length (negative: mirrored), mass and time of the twins.

   If two simultaneous collisions share a body, their order depends on the
   order of the bodies or on the orientation of the axes. So all twins
   reverse the order of the bodies, and every other twin also mirrors the
   axes.

   No factor is a power of two, so every number is rounded differently in
   each twin. The only exception is the unit of time of twin 1, whose steps
   must end at exactly the same times as those of the run itself. */
static const struct units {
    double length, mass, time;
} units[] = {{1, 1, 1},        {-0.7, 1.3, 1},   {0.9, 0.6, 1.1},
             {-1.1, 1.7, 0.7}, {1.3, 0.9, 1.9},  {-0.6, 2.3, 1.3},
             {1.9, 1.1, 0.85}, {-0.85, 0.7, 0.6}};

/* Returns the index of coordinate c after the order of n bodies is
   reversed. */
static size_t reversed(size_t n, size_t c)
{
    return c / n * n + (n - 1 - c % n);
}

/* Reverses each row of n numbers, and multiplies all numbers by `by`. */
static void reverse_rows(double a[], size_t rows, size_t n, double by)
{
    for (size_t c = 0; a && c < rows * n; ++c) {
        const size_t d = reversed(n, c);
        const double other = by * a[c];
        if (c > d)
            continue;
        a[c] = by * a[d];
        a[d] = c == d ? a[c] : other;
    }
}

/* Converts a scene to other units and reverses the order of the bodies. If
   the unit of length is negative, also mirrors the scene, so that the lower
   wall becomes the upper wall.

   Each quantity is multiplied by the factor of its dimension: stiffness
   (kg/s^2) by m/t^2, k^2 (m^3/(kg s^2)) by |l|^3/(m t^2), and friction
   (kg/s) by m/t. If a factor were missing, the twin would be so different
   that no tolerance would be met, which tests would detect. */
static void change_units(struct scene *s, const struct units *u)
{
    const double l = u->length, size = fabs(l), m = u->mass, t = u->time;
    const size_t n = s->bodies;
    reverse_rows(s->mass, 1, n, m);
    reverse_rows(s->charge, 1, n, 1);
    reverse_rows(s->radius, 1, n, size);
    reverse_rows(s->position, 3, n, l);
    reverse_rows(s->velocity, 3, n, l / t);
    reverse_rows(s->carry, 3, n, l);
    reverse_rows(s->carry ? s->carry + 3 * n : NULL, 3, n, l / t);
    reverse_rows(s->kept, 3, n, l / (t * t));
    s->time *= t;
    for (size_t c = 0; c < SCENE_AXES * n; ++c)
        if (c < reversed(n, c)) {
            const unsigned char other = s->freedom[c];
            s->freedom[c] = s->freedom[reversed(n, c)];
            s->freedom[reversed(n, c)] = other;
        }
    for (size_t j = 0; j < s->springs; ++j) {
        s->spring[j].a = (uint32_t)(n - 1 - s->spring[j].a);
        s->spring[j].b = (uint32_t)(n - 1 - s->spring[j].b);
        s->spring[j].rest *= size;
    }
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double low = l * s->low[k], high = l * s->high[k];
        s->low[k] = fmin(low, high);
        s->high[k] = fmax(low, high);
        s->gravity[k] *= l / (t * t);
    }
    for (size_t j = 0; j < s->kinds; ++j) {
        s->kind[j].stiffness *= m / (t * t);
        s->kind[j].damping *= m / t;
    }
    s->k2 *= size * size * size / (m * t * t);
    s->softening *= size;
    s->damping *= m / t;
}

/* Returns the relative change of velocity coordinate c in a twin: 2^-52 or
   -2^-52. The signs differ from twin to twin. */
static double last_bit(size_t c, unsigned twin)
{
    const uint64_t h = (c + 1) * UINT64_C(0x9e3779b97f4a7c15) +
                       (twin - 1) * UINT64_C(0xbf58476d1ce4e5b9);
    const uint64_t mixed = (h ^ h >> 29) * UINT64_C(0x94d049bb133111eb);
    const uint64_t drawn = twin == 1 ? h : mixed;
    return ((double)(drawn >> 62 & 1) * 2 - 1) * 0x1p-52;
}

/* Changes the last bits of all velocities along the axes that matter, so
   that events no longer coincide exactly in time or position. The change is
   proportional to the velocity component or, if larger, to a quarter of the
   speed of the body. With uniform gravity this speed is taken to be at
   least that of a fall through the scene. */
static void move_last_bits(struct scene *s, unsigned twin)
{
    struct models_acts acts;
    const size_t n = s->bodies;
    double falls = 0;
    models_analyse(&acts, s);
    for (size_t k = 0; acts.weight && k < SCENE_AXES; ++k)
        falls = fmax(falls, sqrt(fabs(s->gravity[k]) * size_without(s, n)));
    for (size_t i = 0; i < n; ++i) {
        const double speed = fmax(speed_of_body(s, i), falls);
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if ((acts.axes >> k & 1) && s->freedom[k * n + i])
                s->velocity[k * n + i] +=
                    last_bit(k * n + i, twin) *
                    fmax(0.25 * speed, fabs(s->velocity[k * n + i]));
    }
}

/* Returns |a - b| or, if turn > 0, the distance to the nearest periodic
   image: 0.1 and 9.9 in a box of 10 have the distance 0.2. */
static double distance(double a, double b, double turn)
{
    const double d = fabs(a - b);
    return turn > 0 ? fabs(d - turn * floor(d / turn + 0.5)) : d;
}

/* Returns the largest difference of two rows, where each column is divided
   by its scale. The result is at least the rounding error of the numbers,
   since two equal numbers may have been rounded alike. If a number is NaN,
   the result is INFINITY. */
static double row_difference(const struct record_view *v, const double a[],
                             const double b[])
{
    double most = v->rounded;
    for (size_t c = 0; c < v->columns; ++c) {
        const double far = distance(a[c], b[c], v->period[c]);
        const double rounded = v->rounding[c] * fabs(a[c]);
        const double d = v->weight[c] * (far <= rounded ? rounded : far);
        most = d <= most ? most : d == d ? d : INFINITY;
    }
    return most;
}

double record_difference(const struct record_view *v,
                         const struct record *a, const struct record *b,
                         size_t first, size_t last)
{
    double most = 0;
    if (a->reached < last || b->reached < last)
        return INFINITY;
    for (size_t r = first; r <= last; ++r)
        most = fmax(most, row_difference(v, a->value + r * v->columns,
                                         b->value + r * v->columns));
    return most;
}

size_t record_agree(const struct record_view *v, const struct record *a,
                    const struct record *b, double e)
{
    size_t r = 1;
    while (record_difference(v, a, b, r, r) <= e)
        ++r;
    return r - 1;
}

/* Writes a row of a run to r->value, in the units of the scene: positions
   and velocities, or the requested observables. `met` is the number of
   collisions so far. Stores the state of the run in v->scene. Observables
   are computed for the exact time of the row, which the sum of a method's
   steps may miss. */
static void write_row(struct record *r, struct record_view *v,
                      const struct record_setup *o, const struct scene *now,
                      uint64_t met)
{
    const struct units *const u = &units[o->twin];
    double *to = r->value + r->reached * v->columns;
    struct scene *s = &v->scene;
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        const size_t from = o->twin ? reversed(s->bodies, c) : c;
        s->position[c] =
            now->position[from] / u->length + v->origin[c / s->bodies];
        s->velocity[c] = now->velocity[from] / u->length * u->time;
    }
    if (v->asked) {
        v->motion.stepping.start =
            o->scene->time + (double)r->reached * o->every;
        v->motion.collisions = met;
        observables_values(v->asked, &v->motion, to);
    } else
        for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
            const size_t at = 6 * (c % s->bodies) + c / s->bodies;
            to[at] = s->position[c];
            to[at + SCENE_AXES] = s->velocity[c];
        }
}

/* A run in progress. */
struct pass {
    struct record *r;
    const struct record_setup *o;
    struct models_run run;
    struct scene twin;
    bool begun;
    double since;
};

/* Begins a run and stores the row of the start. For a twin, first converts
   the scene, and the lengths and the time in the plan, to other units. */
static void begin_pass(struct pass *w, struct record_view *v)
{
    const struct record_setup *o = w->o;
    struct record *r = w->r;
    *r = (struct record){
        .plan = o->plan, .end = MODELS_MEMORY, .twin = o->twin};
    w->since = bench_seconds();
    if (!scene_copy(&w->twin, o->scene))
        return;
    struct models_plan plan = o->plan;
    const struct units *const u = &units[o->twin];
    const double every = o->every * u->time;
    for (size_t c = 0; c < SCENE_AXES * w->twin.bodies; ++c)
        w->twin.position[c] -= v->origin[c / w->twin.bodies];
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        w->twin.low[k] -= v->origin[k];
        w->twin.high[k] -= v->origin[k];
    }
    for (size_t i = 0; i < w->twin.bodies; ++i)
        if (w->twin.radius[i] > 0)
            w->twin.radius[i] = fmax(w->twin.radius[i] + o->grow, 0);
    if (o->twin) {
        /* A formula without contacts has no coincidences to remove, and
           changed last bits would only hide its rounding errors. */
        if (plan.model->family != MODELS_CLOSED || o->scene->contact)
            move_last_bits(&w->twin, o->twin);
        change_units(&w->twin, u);
        plan.negligible *= fabs(u->length);
        plan.contact_margin *= fabs(u->length);
        plan.time_left *= u->time;
    }
    r->value = malloc((o->rows + 1) * v->columns * sizeof *r->value);
    if (!r->value)
        return;
    w->begun = models_begin(&w->run, &plan, &w->twin, every, &r->why);
    r->end = w->begun ? MODELS_DONE : MODELS_BROKEN;
    if (!w->begun)
        return;
    w->run.limit = o->limit;
    w->run.all = o->rows;
    r->clock = w->run.clock;
    write_row(r, v, o, &w->run.scene, 0);
}

/* Computes and stores the next row. Returns false if the run has ended. */
static bool next_row(struct pass *w, struct record_view *v)
{
    struct record *r = w->r;
    if (r->end != MODELS_DONE || r->reached == w->o->rows)
        return false;
    r->end = models_row(&w->run);
    if (r->end != MODELS_DONE)
        return false;
    ++r->reached;
    write_row(r, v, w->o, &w->run.scene,
              v->asked ? models_collisions(&w->run) : 0);
    return true;
}

/* Ends a run and stores its cost. */
static void end_pass(struct pass *w)
{
    memcpy(w->r->work, w->run.work, sizeof w->r->work);
    if (w->begun) {
        w->r->collisions = w->run.collisions;
        w->r->least = w->run.least / fabs(units[w->o->twin].length);
        models_end(&w->run);
    }
    scene_free(&w->twin);
    w->r->cost = models_cost(w->r->work);
    w->r->seconds = bench_seconds() - w->since;
}

void record_run(struct record *r, struct record_view *v,
                const struct record_setup *o)
{
    struct pass w = {.r = r, .o = o};
    begin_pass(&w, v);
    while (next_row(&w, v))
        ;
    end_pass(&w);
}

/* Computes the next row of a run that shares its cost limit with
   `other`. */
static bool next_row_beside(struct pass *w, const struct pass *other,
                            double limit, struct record_view *v)
{
    w->run.limit = limit - models_cost(other->run.work);
    return next_row(w, v);
}

void record_both(struct record *a, struct record *b, struct record_view *v,
                 const struct record_setup *oa,
                 const struct record_setup *ob, double apart)
{
    struct pass x = {.r = a, .o = oa}, y = {.r = b, .o = ob};
    begin_pass(&x, v);
    begin_pass(&y, v);
    while (next_row_beside(&x, &y, oa->limit, v) &&
           next_row_beside(&y, &x, oa->limit, v) &&
           row_difference(v, a->value + a->reached * v->columns,
                          b->value + a->reached * v->columns) <= apart)
        ;
    end_pass(&x);
    end_pass(&y);
    /* Both clocks have measured the two runs together, so divide the time
       in proportion to the costs. */
    const double seconds = fmax(a->seconds, b->seconds);
    const double bill = a->cost + b->cost;
    a->seconds = bill > 0 ? seconds * (a->cost / bill) : seconds / 2;
    b->seconds = seconds - a->seconds;
}

void record_free(struct record *r)
{
    free(r->value);
    *r = (struct record){0};
}
