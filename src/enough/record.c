/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 3701225266 of the lines below */
/* Each column is judged by a scale; a run may be in other units. */
#include "enough/record.h"

#include "toolbox/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* From the lowest body or wall along an axis to the highest, m, without
   one of the bodies. */
static double spread_of(const struct scene *s, size_t k, size_t without)
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
    return fmax(high - low, 0);
}

enum { NOBODY = -1 };

/* The diagonal of the box that holds all bodies and walls, m. */
static double size_without(const struct scene *s, size_t without)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double spread = spread_of(s, k, without);
        sum += spread * spread;
    }
    return sqrt(sum);
}

static double size_of(const struct scene *s)
{
    return size_without(s, (size_t)NOBODY);
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
    const double x = s->velocity[i], y = s->velocity[n + i],
                 z = s->velocity[2 * n + i];
    return sqrt(x * x + y * y + z * z);
}

/* The largest speed, m/s. */
static double speed_of(const struct scene *s)
{
    double most = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        most = fmax(most, speed_of_body(s, i));
    return most;
}

static double momentum_of(const struct scene *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i] * speed_of_body(s, i);
    return sum;
}

static double mass_of(const struct scene *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i];
    return sum;
}

/* What errors are divided by. */
struct scales {
    double length, speed, energy, momentum, turning, one;
};

static double or_else(double a, double b)
{
    return a > 0 ? a : b;
}

static struct scales measure(const struct record_view *v, double length)
{
    const struct scene *s = &v->scene;
    const struct motion_energy e = motion_energy(&v->motion);
    const double energy = e.kinetic + (e.gravity + e.springs + e.weight);
    struct models_acts acts;
    models_analyse(&acts, s);
    struct scales to = {.one = 1};
    to.length = or_else(size_of(s), or_else(speed_of(s) * length, 1));
    to.speed = or_else(
        speed_of(s), or_else(to.length * acts.fastest, to.length / length));
    to.energy = fmax(fabs(energy), e.kinetic);
    to.energy = or_else(to.energy, mass_of(s) * to.speed * to.speed);
    to.momentum = or_else(momentum_of(s), mass_of(s) * to.speed);
    to.turning = to.momentum * to.length;
    return to;
}

/* Names of observables, what they are judged as, and by which scale. */
static const struct judgement {
    const char *name, *as;
    size_t scale;
} judgements[] = {
#define BY(field) offsetof(struct scales, field)
    {"t", "t", BY(one)},
    {"energy", "energy", BY(energy)},
    {"kinetic", "energy", BY(energy)},
    {"potential", "energy", BY(energy)},
    {"parts", "energy", BY(energy)},
    {"temperature", "energy", BY(energy)},
    {"momentum", "momentum", BY(momentum)},
    {"angular-momentum", "angular momentum", BY(turning)},
    {"centre", "positions", BY(length)},
    {"collisions", "counts", BY(one)},
    {"x:0", "positions", BY(length)},
    {"y:0", "positions", BY(length)},
    {"z:0", "positions", BY(length)},
    {"distance:0:0", "positions", BY(length)},
    {"vx:0", "velocities", BY(speed)},
    {"vy:0", "velocities", BY(speed)},
    {"vz:0", "velocities", BY(speed)},
    {"speed:0", "velocities", BY(speed)}};
enum { JUDGEMENTS = sizeof judgements / sizeof judgements[0] };

/* The judgement on an observable, and how many columns it has. */
static const struct judgement *find_judgement(const struct observable *o,
                                              size_t *width)
{
    char message[OBSERVABLES_MESSAGE];
    struct observables one;
    for (size_t j = 0; j < JUDGEMENTS; ++j)
        if (observables_read(&one, judgements[j].name, 1, message) &&
            one.list[0].kind == o->kind) {
            *width = one.columns;
            return &judgements[j];
        }
    return NULL;
}

static double scale_by(const struct scales *to, const struct judgement *j)
{
    return *(const double *)(const void *)((const char *)to + j->scale);
}

/* The length after which an observable is the same: of a coordinate across
   a periodic box; 0: there is none. */
static double turn_of(const struct scene *s, const struct judgement *j)
{
    const size_t k = (size_t)(j->name[0] - 'x');
    return j->name[1] == ':' && k < SCENE_AXES &&
                   s->wall[k] == SCENE_PERIODIC
               ? s->high[k] - s->low[k]
               : 0;
}

static void judge_all(struct record_view *v, const struct scales *to)
{
    size_t next = 0, width = 0;
    for (size_t i = 0; i < v->asked->count; ++i) {
        const struct judgement *j =
            find_judgement(&v->asked->list[i], &width);
        for (size_t k = 0; k < width; ++k, ++next) {
            v->weight[next] = 1 / scale_by(to, j);
            v->turn[next] = turn_of(&v->scene, j);
        }
        if (i == 0) {
            v->scale = scale_by(to, j);
            v->judged = j->as;
        }
    }
}

static void judge_states(struct record_view *v, const struct scales *to)
{
    const struct scene *s = &v->scene;
    v->scale = to->length;
    v->judged = "positions";
    for (size_t i = 0; i < s->bodies; ++i)
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            v->weight[6 * i + k] = 1 / to->length;
            if (s->wall[k] == SCENE_PERIODIC)
                v->turn[6 * i + k] = s->high[k] - s->low[k];
        }
}

static void judge(struct record_view *v, double length)
{
    const struct scales to = measure(v, length);
    v->speed = speed_of(&v->scene);
    v->length = to.length;
    if (v->asked)
        judge_all(v, &to);
    else
        judge_states(v, &to);
}

static bool make_room(struct record_view *v)
{
    v->weight = calloc(2 * v->columns, sizeof *v->weight);
    if (!v->weight)
        return false;
    v->turn = v->weight + v->columns;
    return true;
}

bool record_look(struct record_view *v, const char *program,
                 const struct scene *s, const struct observables *asked,
                 double length)
{
    *v = (struct record_view){.asked = asked};
    v->columns = asked ? asked->columns : 6 * s->bodies;
    if (!scene_copy(&v->scene, s)) {
        fprintf(stderr, "%s: no memory for a scene\n", program);
        return false;
    }
    if (!motion_begin(&v->motion, program, &v->scene, "leapfrog", 1)) {
        scene_free(&v->scene);
        return false;
    }
    if (!make_room(v)) {
        fprintf(stderr, "%s: no memory for %zu columns\n", program,
                v->columns);
        record_look_away(v);
        return false;
    }
    judge(v, length);
    return true;
}

void record_look_away(struct record_view *v)
{
    motion_end(&v->motion);
    scene_free(&v->scene);
    free(v->weight);
    *v = (struct record_view){0};
}

/* The other units: of length and of mass. */
static const double unit_length = 0.7, unit_mass = 1.3;

static void convert_bodies(struct scene *s)
{
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        s->position[c] *= unit_length;
        s->velocity[c] *= unit_length;
        if (s->kept)
            s->kept[c] *= unit_length;
    }
    for (size_t i = 0; i < s->bodies; ++i) {
        s->mass[i] *= unit_mass;
        s->radius[i] *= unit_length;
    }
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        s->low[k] *= unit_length;
        s->high[k] *= unit_length;
    }
}

static void convert_forces(struct scene *s)
{
    const double l = unit_length, m = unit_mass;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        s->gravity[k] *= l;
    for (size_t j = 0; j < s->springs; ++j)
        s->spring[j].rest *= l;
    for (size_t j = 0; j < s->kinds; ++j) {
        s->kind[j].stiffness *= m;
        s->kind[j].damping *= m;
    }
    s->k2 *= l * l * l / m;
    s->softening *= l;
    s->damping *= m;
}

/* Coordinate c of a body, where the last body is the first one. */
static size_t renamed(size_t n, size_t c)
{
    return c / n * n + (n - 1 - c % n);
}

/* Puts rows of n numbers the other way round, and multiplies them. */
static void reverse(double a[], size_t rows, size_t n, double by)
{
    for (size_t r = 0; a && r < rows; ++r)
        for (size_t i = 0; i < n; ++i) {
            const size_t c = r * n + i, d = r * n + (n - 1 - i);
            if (c > d)
                continue;
            const double other = by * a[c];
            a[c] = by * a[d];
            a[d] = c == d ? a[c] : other;
        }
}

static void turn_box(struct scene *s)
{
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double low = s->low[k];
        s->low[k] = -s->high[k];
        s->high[k] = -low;
        s->gravity[k] *= -1;
    }
}

/* The scene from the other side, with the last body as the first one. */
static void turn_round(struct scene *s)
{
    const size_t n = s->bodies;
    reverse(s->mass, 1, n, 1);
    reverse(s->charge, 1, n, 1);
    reverse(s->radius, 1, n, 1);
    reverse(s->position, 3, n, -1);
    reverse(s->velocity, 3, n, -1);
    reverse(s->carry, 6, n, -1);
    reverse(s->kept, 3, n, -1);
    for (size_t c = 0; c < SCENE_AXES * n; ++c)
        if (c < renamed(n, c)) {
            const unsigned char other = s->freedom[c];
            s->freedom[c] = s->freedom[renamed(n, c)];
            s->freedom[renamed(n, c)] = other;
        }
    for (size_t j = 0; j < s->springs; ++j) {
        s->spring[j].a = (uint32_t)(n - 1 - s->spring[j].a);
        s->spring[j].b = (uint32_t)(n - 1 - s->spring[j].b);
    }
    turn_box(s);
}

static double between(double a, double b, double turn)
{
    const double d = fabs(a - b);
    return turn > 0 ? fabs(d - turn * floor(d / turn + 0.5)) : d;
}

/* How far a row is from another. */
static double row_apart(const struct record_view *v, const double a[],
                        const double b[])
{
    double most = 0;
    for (size_t c = 0; c < v->columns; ++c) {
        const double d = v->weight[c] * between(a[c], b[c], v->turn[c]);
        most = d <= most ? most : d == d ? d : INFINITY;
    }
    return most;
}

double record_apart(const struct record_view *v, const struct record *a,
                    const struct record *b, size_t first, size_t last)
{
    double most = 0;
    if (a->reached < last || b->reached < last)
        return INFINITY;
    for (size_t r = first; r <= last; ++r)
        most = fmax(most, row_apart(v, a->value + r * v->columns,
                                    b->value + r * v->columns));
    return most;
}

size_t record_agree(const struct record_view *v, const struct record *a,
                    const struct record *b, double e)
{
    size_t r = 1;
    while (r <= a->reached && r <= b->reached &&
           row_apart(v, a->value + r * v->columns,
                     b->value + r * v->columns) <= e)
        ++r;
    return r - 1;
}

static void copy_states(const struct scene *s, double to[])
{
    const size_t n = s->bodies;
    for (size_t i = 0; i < n; ++i)
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            to[6 * i + k] = s->position[k * n + i];
            to[6 * i + 3 + k] = s->velocity[k * n + i];
        }
}

/* Looks at a run as it is at the end of the row that was reached; met: its
   collisions so far. */
static void look(struct record *r, struct record_view *v,
                 const struct record_order *o, const struct scene *now,
                 uint64_t met)
{
    const double unit = o->twin ? -unit_length : 1;
    double *to = r->value + r->reached * v->columns;
    struct scene *s = &v->scene;
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        const size_t from = o->twin ? renamed(s->bodies, c) : c;
        s->position[c] = now->position[from] / unit;
        s->velocity[c] = now->velocity[from] / unit;
    }
    if (v->asked) {
        v->motion.stepping.start =
            o->scene->time + (double)r->reached * o->every;
        v->motion.collisions = met;
        observables_values(v->asked, &v->motion, to);
    } else
        copy_states(s, to);
}

/* By so much a velocity is moved, of 1: up, down or not at all. */
static double last_bit(size_t c)
{
    const uint64_t h = (c + 1) * UINT64_C(0x9e3779b97f4a7c15);
    return ((double)(h >> 62 & 1) * 2 - 1) * 0x1p-52;
}

/* Moves the last bits of what flies, along the axes that live, so that what
   is exactly at the same time, or on one line, is so no longer. */
static void move_last_bits(struct scene *s)
{
    struct models_acts acts;
    const size_t n = s->bodies;
    models_analyse(&acts, s);
    for (size_t i = 0; i < n; ++i) {
        double falls = 0;
        for (size_t k = 0; acts.weight && k < SCENE_AXES; ++k)
            falls = fmax(falls, sqrt(fabs(s->gravity[k]) * size_of(s)));
        const double speed = fmax(speed_of_body(s, i), falls);
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if ((acts.axes >> k & 1) && s->freedom[k * n + i])
                s->velocity[k * n + i] +=
                    last_bit(k * n + i) *
                    fmax(0.25 * speed, fabs(s->velocity[k * n + i]));
    }
}

/* A run on its way. */
struct way {
    struct record *r;
    const struct record_order *o;
    struct models_run run;
    struct scene twin;
    bool begun;
    double since;
};

static void begin_way(struct way *w, struct record_view *v)
{
    const struct record_order *o = w->o;
    struct record *r = w->r;
    *r = (struct record){.plan = o->plan, .end = MODELS_MEMORY};
    w->since = bench_seconds();
    if (!scene_copy(&w->twin, o->scene))
        return;
    struct models_plan plan = o->plan;
    if (o->twin) {
        convert_bodies(&w->twin);
        convert_forces(&w->twin);
        move_last_bits(&w->twin);
        turn_round(&w->twin);
        plan.little *= unit_length;
    }
    r->value = malloc((o->rows + 1) * v->columns * sizeof *r->value);
    if (r->value) {
        w->begun =
            models_begin(&w->run, &plan, &w->twin, o->every, &r->why);
        r->end = w->begun ? MODELS_DONE : MODELS_BROKEN;
    }
    if (w->begun) {
        w->run.limit = o->limit;
        w->run.all = o->rows;
        r->clock = w->run.clock;
        look(r, v, o, &w->run.scene, 0);
    }
}

/* A row further; false: it ends here. */
static bool go_on(struct way *w, struct record_view *v)
{
    struct record *r = w->r;
    if (r->end != MODELS_DONE || r->reached == w->o->rows)
        return false;
    r->end = models_row(&w->run);
    if (r->end != MODELS_DONE)
        return false;
    ++r->reached;
    look(r, v, w->o, &w->run.scene,
         v->asked ? models_collisions(&w->run) : 0);
    return true;
}

static void end_way(struct way *w)
{
    if (w->begun) {
        memcpy(w->r->work, w->run.work, sizeof w->r->work);
        w->r->collisions = w->run.collisions;
        models_end(&w->run);
    }
    scene_free(&w->twin);
    w->r->cost = models_cost(w->r->work);
    w->r->seconds = bench_seconds() - w->since;
}

bool record_run(struct record *r, struct record_view *v,
                const struct record_order *o)
{
    struct way w = {.r = r, .o = o};
    begin_way(&w, v);
    while (go_on(&w, v))
        ;
    end_way(&w);
    return r->end != MODELS_MEMORY;
}

/* Goes on while another one may have spent some of what both may. */
static bool go_on_beside(struct way *w, const struct way *other,
                         double limit, struct record_view *v)
{
    w->run.limit = limit - models_cost(other->run.work);
    return go_on(w, v);
}

bool record_both(struct record *a, struct record *b, struct record_view *v,
                 const struct record_order *oa,
                 const struct record_order *ob, double apart)
{
    struct way x = {.r = a, .o = oa}, y = {.r = b, .o = ob};
    begin_way(&x, v);
    begin_way(&y, v);
    while (go_on_beside(&x, &y, oa->limit, v) &&
           go_on_beside(&y, &x, oa->limit, v) &&
           row_apart(v, a->value + a->reached * v->columns,
                     b->value + a->reached * v->columns) <= apart)
        ;
    end_way(&x);
    end_way(&y);
    return a->end != MODELS_MEMORY && b->end != MODELS_MEMORY;
}

void record_free(struct record *r)
{
    free(r->value);
    *r = (struct record){0};
}
