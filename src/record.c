/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 225593879 of the lines below */
#include "record.h"

#include "toolbox/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The diagonal of the box that holds all bodies and walls, m. */
static double size_of(const struct scene *s)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double *x = s->position + k * s->bodies;
        double low = x[0], high = x[0];
        for (size_t i = 1; i < s->bodies; ++i) {
            low = fmin(low, x[i]);
            high = fmax(high, x[i]);
        }
        if (s->wall[k] != SCENE_OPEN) {
            low = fmin(low, s->low[k]);
            high = fmax(high, s->high[k]);
        }
        sum += (high - low) * (high - low);
    }
    return sqrt(sum);
}

/* The largest speed, m/s. */
static double speed_of(const struct scene *s)
{
    const size_t n = s->bodies;
    double most = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = s->velocity[i], y = s->velocity[n + i],
                     z = s->velocity[2 * n + i];
        most = fmax(most, x * x + y * y + z * z);
    }
    return sqrt(most);
}

static double momentum_of(const struct scene *s)
{
    const size_t n = s->bodies;
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        const double x = s->velocity[i], y = s->velocity[n + i],
                     z = s->velocity[2 * n + i];
        sum += s->mass[i] * sqrt(x * x + y * y + z * z);
    }
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

/* Looks at a run as it is now. */
static void look(struct record_view *v, struct models_run *run, double unit,
                 double to[])
{
    struct scene *s = &v->scene;
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        s->position[c] = run->scene.position[c] / unit;
        s->velocity[c] = run->scene.velocity[c] / unit;
    }
    v->motion.stepping.start = run->start + (double)run->rows * run->every;
    if (v->asked) {
        v->motion.collisions = models_collisions(run);
        observables_values(v->asked, &v->motion, to);
    } else
        copy_states(s, to);
}

static bool strays(const struct record *r, const struct record_view *v,
                   const struct record_order *o)
{
    const size_t at = r->reached * v->columns;
    return o->guide && o->guide->reached >= r->reached &&
           !(row_apart(v, r->value + at, o->guide->value + at) <= o->apart);
}

/* How fast the ends of a spring pass each other, or have passed, within
   this step, 1/s; 0: they do not. */
static double spring_turns(const struct scene *s,
                           const struct scene_spring *spring, double step)
{
    const size_t n = s->bodies, i = spring->a, j = spring->b;
    double r2 = 0, v2 = 0, rv = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double d = s->position[k * n + j] - s->position[k * n + i];
        const double v = s->velocity[k * n + j] - s->velocity[k * n + i];
        r2 += d * d;
        v2 += v * v;
        rv += d * v;
    }
    if (spring->rest == 0 || !(fabs(rv) <= step * v2) || v2 == 0)
        return 0;
    return sqrt(v2 / fmax(r2 - rv * rv / v2, 0));
}

/* What a contact would have done to two bodies that have passed through
   each other in this step, m; 0: they have not. */
static double graze(const struct scene *from, const struct scene *to,
                    size_t i, size_t j, double step)
{
    const size_t n = to->bodies;
    double r2 = 0, d2 = 0, rd = 0, bend2 = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t a = k * n + i, b = k * n + j;
        const double r = from->position[b] - from->position[a];
        const double d = to->position[b] - to->position[a] - r;
        const double u = to->velocity[b] - to->velocity[a] -
                         (from->velocity[b] - from->velocity[a]);
        r2 += r * r;
        d2 += d * d;
        rd += r * d;
        bend2 += u * u;
    }
    const double R = to->radius[i] + to->radius[j] - sqrt(bend2) * step / 8;
    const double b2 = r2 - rd * rd / d2;
    return -rd > 0 && -rd < d2 && R > 0 && b2 < R * R
               ? sqrt(1 - b2 / (R * R)) * sqrt(d2) / step
               : 0;
}

/* How many contacts that matter the step from one state to the other has
   missed, of which it has found so many. */
static uint64_t missed_of(const struct scene *from, const struct scene *to,
                          double step, double matters, uint64_t found)
{
    uint64_t passed = 0;
    for (size_t i = 0; i < to->bodies; ++i)
        for (size_t j = 0; j < i; ++j)
            passed += graze(from, to, i, j, step) > matters;
    return passed > found ? passed - found : 0;
}

/* How easily the ends of a spring are moved against each other, 1/kg. */
static double ease_of(const struct scene *s,
                      const struct scene_spring *spring)
{
    const size_t n = s->bodies, ends[] = {spring->a, spring->b};
    double ease = 0;
    for (size_t e = 0; e < 2; ++e) {
        const size_t i = ends[e];
        if (s->freedom[i] || s->freedom[n + i] || s->freedom[2 * n + i])
            ease += 1 / s->mass[i];
    }
    return ease;
}

/* How far it may swing, m. */
static double spring_swing(const struct scene *s,
                           const struct scene_spring *spring, double rate)
{
    const size_t n = s->bodies, i = spring->a, j = spring->b;
    double r2 = 0, rv = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double d = s->position[k * n + j] - s->position[k * n + i];
        r2 += d * d;
        rv += d * (s->velocity[k * n + j] - s->velocity[k * n + i]);
    }
    const double length = sqrt(r2);
    return fmax(fabs(length - spring->rest),
                length > 0 ? fabs(rv) / length / rate : 0);
}

static void note_swinging(struct record *r, const struct scene *s,
                          double little)
{
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *spring = &s->spring[j];
        const double rate =
            sqrt(s->kind[spring->kind].stiffness * ease_of(s, spring));
        if (rate > r->swinging &&
            spring_swing(s, &s->spring[j], rate) > little)
            r->swinging = rate;
    }
}

static double speed_of_body(const struct scene *s, size_t i)
{
    const size_t n = s->bodies;
    const double x = s->velocity[i], y = s->velocity[n + i],
                 z = s->velocity[2 * n + i];
    return sqrt(x * x + y * y + z * z);
}

static void note_damping(struct record *r, const struct scene *s,
                         double alive)
{
    for (size_t i = 0; s->damping > 0 && i < s->bodies; ++i)
        if (s->mass[i] > 0 && speed_of_body(s, i) > alive)
            r->swinging = fmax(r->swinging, s->damping / s->mass[i]);
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *spring = &s->spring[j];
        const double c = s->kind[spring->kind].damping;
        if (c > 0 &&
            speed_of_body(s, spring->a) + speed_of_body(s, spring->b) >
                alive)
            r->swinging = fmax(r->swinging, c * ease_of(s, spring));
    }
}

static void watch(struct record *r, const struct models_run *run,
                  double unit, const struct record_order *o)
{
    const struct scene *s = &run->scene;
    r->speed = fmax(r->speed, speed_of(s) / unit);
    for (size_t j = 0; j < s->springs; ++j)
        r->turning =
            fmax(r->turning, spring_turns(s, &s->spring[j], run->every));
    note_swinging(r, s, o->little);
    note_damping(r, s, o->little / (o->every * (double)o->rows));
}

/* How many parts a row is run in. */
static uint64_t parts_of(const struct record_order *o)
{
    return o->watched && o->plan.steps > 1 ? o->plan.steps : 1;
}

/* Runs a part of a row, and watches for contacts that it misses. */
static enum models_end one_part(struct record *r,
                                const struct record_order *o,
                                struct models_run *run,
                                struct scene *before)
{
    const size_t size =
        SCENE_AXES * before->bodies * sizeof *before->position;
    const uint64_t met = models_collisions(run);
    memcpy(before->position, run->scene.position, size);
    memcpy(before->velocity, run->scene.velocity, size);
    const enum models_end end = models_row(run);
    if (end == MODELS_DONE)
        r->missed += missed_of(before, &run->scene, run->every,
                               o->little / (o->every * (double)o->rows),
                               models_collisions(run) - met);
    return end;
}

/* Runs one row, in its parts. */
static enum models_end one_row(struct record *r,
                               const struct record_order *o,
                               struct models_run *run, struct scene *before)
{
    const double unit = o->converted ? unit_length : 1;
    for (uint64_t parts = parts_of(o); parts > 0; --parts) {
        const enum models_end end = before->bodies > 0
                                        ? one_part(r, o, run, before)
                                        : models_row(run);
        if (end != MODELS_DONE)
            return end;
        if (o->watched)
            watch(r, run, unit, o);
    }
    return MODELS_DONE;
}

static void carry(struct record *r, struct record_view *v,
                  const struct record_order *o, struct models_run *run,
                  struct scene *before)
{
    const double unit = o->converted ? unit_length : 1;
    run->limit = o->limit;
    look(v, run, unit, r->value);
    r->speed = speed_of(&v->scene);
    while (r->reached < o->rows && r->end == MODELS_DONE) {
        r->end = one_row(r, o, run, before);
        if (r->end != MODELS_DONE)
            break;
        ++r->reached;
        look(v, run, unit, r->value + r->reached * v->columns);
        if (strays(r, v, o))
            break;
    }
    memcpy(r->work, run->work, sizeof r->work);
    r->cost = models_cost(r->work);
}

static bool set_out(struct record *r, struct record_view *v,
                    const struct record_order *o, const struct scene *s)
{
    struct models_run run;
    struct models_plan plan = o->plan;
    const uint64_t parts = parts_of(o);
    plan.steps /= parts;
    if (!models_begin(&run, &plan, s, o->every / (double)parts, &r->why)) {
        r->end = MODELS_BROKEN;
        return true;
    }
    struct scene before = {0};
    const bool contacts = o->watched && s->contact && plan.steps > 0;
    r->value = malloc((o->rows + 1) * v->columns * sizeof *r->value);
    const bool good = r->value && (!contacts || scene_copy(&before, s));
    if (good)
        carry(r, v, o, &run, &before);
    scene_free(&before);
    models_end(&run);
    return good;
}

/* The same in other units. */
static bool set_out_converted(struct record *r, struct record_view *v,
                              const struct record_order *o)
{
    struct scene other;
    if (!scene_copy(&other, o->scene))
        return false;
    convert_bodies(&other);
    convert_forces(&other);
    const bool good = set_out(r, v, o, &other);
    scene_free(&other);
    return good;
}

bool record_run(struct record *r, struct record_view *v,
                const struct record_order *o)
{
    const double start = bench_seconds();
    *r = (struct record){.plan = o->plan};
    const bool good = o->converted ? set_out_converted(r, v, o)
                                   : set_out(r, v, o, o->scene);
    r->seconds = bench_seconds() - start;
    return good;
}

void record_free(struct record *r)
{
    free(r->value);
    *r = (struct record){0};
}
