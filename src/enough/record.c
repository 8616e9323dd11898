/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 3683204114 of the lines below */
/* Each column is judged by a scale; a run may be in other units. */
#include "enough/record.h"

#include "scenes/pair.h"
#include "toolbox/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* From the lowest body or wall along an axis to the highest, m. */
static double spread_of(const struct scene *s, size_t k)
{
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
    return high - low;
}

/* The diagonal of the box that holds all bodies and walls, m. */
static double size_of(const struct scene *s)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k)
        sum += spread_of(s, k) * spread_of(s, k);
    return sqrt(sum);
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

static double unit_of(const struct record_order *o)
{
    return o->converted ? unit_length : 1;
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
    const double unit = unit_of(o);
    double *to = r->value + r->reached * v->columns;
    struct scene *s = &v->scene;
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        s->position[c] = now->position[c] / unit;
        s->velocity[c] = now->velocity[c] / unit;
    }
    if (v->asked) {
        v->motion.stepping.start =
            o->scene->time + (double)r->reached * o->every;
        v->motion.collisions = met;
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
static double spring_turns(const struct pair *ends, double step)
{
    if (!pair_passes(ends, step))
        return 0;
    return sqrt(ends->v2 / pair_nearest2(ends));
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

/* Does the direction of a spring matter? It does if it has a length, or a
   dashpot along it: in a step times the time that there is, s^2. */
static bool spring_points(const struct scene *s,
                          const struct scene_spring *spring,
                          const struct pair *ends, double step_time,
                          double little)
{
    const double c = s->axial ? s->kind[spring->kind].damping : 0;
    return spring->rest != 0 ||
           c * ease_of(s, spring) * sqrt(ends->v2) * step_time >
               10 * little;
}

/* How far it may swing, or push what is slower, in the time that there is,
   m. */
static double spring_swings(const struct scene_spring *spring,
                            const struct pair *ends, double rate,
                            double time)
{
    const double length = sqrt(ends->r2);
    if (!(length > 0))
        return spring->rest;
    const double far =
        fmax(fabs(length - spring->rest), fabs(ends->rv) / length / rate);
    const double way = far * rate * time;
    return fmax(far, way * way / (2 * length));
}

static void note_springs(struct record *r, const struct scene *s,
                         double step, const struct record_order *o)
{
    const double time = o->every * (double)o->rows;
    for (size_t j = 0; j < s->springs; ++j) {
        const struct scene_spring *spring = &s->spring[j];
        const struct pair ends = pair_of(s, spring->a, spring->b);
        const double rate =
            sqrt(s->kind[spring->kind].stiffness * ease_of(s, spring));
        if (spring_points(s, spring, &ends, step * time, o->little))
            r->turning = fmax(r->turning, spring_turns(&ends, step));
        if (rate > r->swinging &&
            spring_swings(spring, &ends, rate, time) > o->little)
            r->swinging = rate;
    }
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

static void count_looks(struct record *r, enum models_unit unit,
                        double times)
{
    r->watching += 1e-9 * models_prices[unit].ns * times;
}

/* What moves nobody by more than a little in the whole run, m/s. */
static double alive(const struct record_order *o)
{
    return o->little / (o->every * (double)o->rows);
}

static void watch(struct record *r, const struct models_run *run,
                  const struct record_order *o)
{
    const struct scene *s = &run->scene;
    r->speed = fmax(r->speed, speed_of(s) / unit_of(o));
    note_springs(r, s, run->every, o);
    note_damping(r, s, alive(o));
    count_looks(r, MODELS_EVALUATION, 1);
    count_looks(r, MODELS_BODY, (double)s->bodies);
    count_looks(r, MODELS_SPRING, (double)s->springs);
}

/* What a contact would have done to two bodies that have passed through
   each other in this step, m/s; 0: they have not. */
static double graze(const struct pair *before, const struct pair *after,
                    double touching, double step)
{
    const struct pair way = pair_way(before, after);
    const double R = touching - pair_changed(before, after) * step / 8;
    if (!(-way.rv > 0 && -way.rv < way.v2 && R > 0))
        return 0;
    const double b2 = pair_nearest2(&way);
    return b2 < R * R ? sqrt(1 - b2 / (R * R)) * sqrt(way.v2) / step : 0;
}

/* What a body sweeps in a step, m. */
struct sweep {
    double low[SCENE_AXES], high[SCENE_AXES]; /* along each axis */
    double from, to; /* along that of the order, and in a periodic box */
    size_t body;
};

/* The ways of a step. */
struct ways {
    struct scene before; /* the state where they begin */
    size_t axis;         /* of the order */
    double side;         /* of a periodic box along this axis, m; or 0 */
    struct sweep *sweep; /* [bodies], in order of from */
};

/* A copy of the scene that can take states from the middle of a run. */
static bool copy_for_states(struct scene *to, const struct scene *s)
{
    if (!scene_copy(to, s))
        return false;
    free(to->kept);
    free(to->carry);
    to->kept = to->carry = NULL;
    return true;
}

static void find_sweep(struct sweep *p, const struct ways *w,
                       const struct scene *now)
{
    const double radius = now->radius[p->body];
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t at = k * now->bodies + p->body;
        const double x = w->before.position[at], y = now->position[at];
        p->low[k] = fmin(x, y) - radius;
        p->high[k] = fmax(x, y) + radius;
    }
    p->from = p->low[w->axis];
    p->to = p->high[w->axis];
    if (w->side > 0) {
        const double far = p->from - now->low[w->axis];
        const double shift = w->side * floor(far / w->side);
        p->from -= shift;
        p->to -= shift;
    }
}

static size_t longest_axis(const struct scene *s)
{
    size_t longest = 0;
    for (size_t k = 1; k < SCENE_AXES; ++k)
        if (spread_of(s, k) > spread_of(s, longest))
            longest = k;
    return longest;
}

static int by_from(const void *a, const void *b)
{
    const struct sweep *p = a, *q = b;
    if (p->from != q->from)
        return p->from < q->from ? -1 : 1;
    return p->body < q->body ? -1 : p->body > q->body;
}

static bool make_ways(struct ways *w, const struct scene *s)
{
    *w = (struct ways){.axis = longest_axis(s)};
    w->sweep = malloc(s->bodies * sizeof *w->sweep + 1);
    if (!w->sweep || !copy_for_states(&w->before, s))
        return false;
    if (s->wall[w->axis] == SCENE_PERIODIC)
        w->side = s->high[w->axis] - s->low[w->axis];
    for (size_t i = 0; i < s->bodies; ++i) {
        w->sweep[i].body = i;
        find_sweep(&w->sweep[i], w, s);
    }
    qsort(w->sweep, s->bodies, sizeof *w->sweep, by_from);
    return true;
}

static void free_ways(struct ways *w)
{
    scene_free(&w->before);
    free(w->sweep);
}

/* Returns how many comparisons that took. */
static uint64_t put_in_order(struct sweep sweep[], size_t n)
{
    uint64_t compared = 0;
    for (size_t i = 1; i < n; ++i) {
        const struct sweep now = sweep[i];
        size_t j = i;
        for (; j > 0 && sweep[j - 1].from > now.from; --j)
            sweep[j] = sweep[j - 1];
        sweep[j] = now;
        compared += i - j + 1;
    }
    return compared;
}

static bool is_far(const struct sweep *a, const struct sweep *b,
                   const struct scene *s)
{
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if (s->wall[k] != SCENE_PERIODIC &&
            (a->high[k] < b->low[k] || b->high[k] < a->low[k]))
            return true;
    return false;
}

/* Have the two passed through each other, in a contact that matters? */
static bool is_grazed(const struct ways *w, const struct scene *now,
                      const struct sweep *a, const struct sweep *b,
                      double step, double matters)
{
    const size_t i = a->body, j = b->body;
    if (is_far(a, b, now))
        return false;
    struct pair from = pair_of(&w->before, i, j), to = pair_of(now, i, j);
    for (size_t k = 0; k < SCENE_AXES; ++k)
        if (now->wall[k] == SCENE_PERIODIC) {
            const double side = now->high[k] - now->low[k];
            const double shift = side * floor(from.r[k] / side + 0.5);
            from.r[k] -= shift;
            to.r[k] -= shift;
        }
    return graze(&from, &to, now->radius[i] + now->radius[j], step) >
           matters;
}

/* How many contacts that matter ways have had; *asked: of so many pairs. */
static uint64_t count_grazed(const struct ways *w, const struct scene *now,
                             double step, double matters, uint64_t *asked)
{
    const size_t n = now->bodies;
    const struct sweep *p = w->sweep;
    uint64_t grazed = 0;
    for (size_t i = 0; i < n; ++i) {
        const double past = w->side > 0 ? p[i].to - w->side : -INFINITY;
        for (size_t j = i + 1; j < n && p[j].from < p[i].to; ++j, ++*asked)
            grazed += is_grazed(w, now, &p[i], &p[j], step, matters);
        for (size_t j = 0; j < i && p[j].from < past; ++j, ++*asked)
            grazed += is_grazed(w, now, &p[i], &p[j], step, matters);
    }
    return grazed;
}

/* Counts the contacts that matter and that the last step has missed, of
   which it has found so many. */
static void note_missed(struct record *r, struct ways *w,
                        const struct models_run *run,
                        const struct record_order *o, uint64_t found)
{
    const struct scene *now = &run->scene;
    uint64_t asked = 0;
    for (size_t j = 0; j < now->bodies; ++j)
        find_sweep(&w->sweep[j], w, now);
    const uint64_t compared = put_in_order(w->sweep, now->bodies);
    const uint64_t grazed =
        count_grazed(w, now, run->every, alive(o), &asked);
    r->missed += grazed > found ? grazed - found : 0;
    count_looks(r, MODELS_CONTACT, (double)now->bodies);
    count_looks(r, MODELS_ORDER, (double)compared);
    count_looks(r, MODELS_OVERLAP, (double)asked);
}

/* How many parts a row is run in. */
static uint64_t parts_of(const struct record_order *o)
{
    return o->watched && o->plan.steps > 1 ? o->plan.steps : 1;
}

static bool is_halfway(const struct record_order *o)
{
    return o->halfway && !o->watched && o->plan.steps > 0;
}

/* Runs a part of a row, and watches for contacts that it misses, unless
   ways is NULL. */
static enum models_end one_part(struct record *r,
                                const struct record_order *o,
                                struct models_run *run, struct ways *ways)
{
    if (!ways)
        return models_row(run);
    const uint64_t met = models_collisions(run);
    scene_take_state(&ways->before, &run->scene);
    const enum models_end end = models_row(run);
    if (end == MODELS_DONE)
        note_missed(r, ways, run, o, models_collisions(run) - met);
    return end;
}

/* Runs one row, in its parts. */
static enum models_end one_row(struct record *r,
                               const struct record_order *o,
                               struct models_run *run, struct ways *ways)
{
    for (uint64_t parts = parts_of(o); parts > 0; --parts) {
        const enum models_end end = one_part(r, o, run, ways);
        if (end != MODELS_DONE)
            return end;
        if (o->watched)
            watch(r, run, o);
        run->limit = o->limit - r->watching;
    }
    return MODELS_DONE;
}

static void carry(struct record *r, struct record_view *v,
                  const struct record_order *o, struct models_run *run,
                  struct ways *ways)
{
    if (o->watched)
        watch(r, run, o);
    while (r->reached < o->rows) {
        r->end = one_row(r, o, run, ways);
        if (r->end != MODELS_DONE)
            return;
        ++r->reached;
        look(r, v, o, &run->scene, v->asked ? models_collisions(run) : 0);
        if (strays(r, v, o))
            return;
    }
}

/* Begins a run by the plan of the order, with rows and steps of its own. */
static bool begin_run(struct models_run *run, struct record *r,
                      const struct record_order *o, const struct scene *s,
                      uint64_t steps, double every)
{
    struct models_plan plan = o->plan;
    plan.steps = steps;
    if (models_begin(run, &plan, s, every, &r->why)) {
        run->limit = o->limit;
        r->clock = run->clock;
        return true;
    }
    r->end = MODELS_BROKEN;
    return false;
}

static void end_run(struct models_run *run, struct record *r)
{
    for (size_t u = 0; u < MODELS_UNITS; ++u)
        r->work[u] += run->work[u];
    models_end(run);
}

/* Carries a scene by half a step; adds its collisions to *met. */
static bool leap(struct record *r, const struct record_order *o,
                 struct scene *s, uint64_t *met)
{
    struct models_run run;
    const double step = o->every / (double)o->plan.steps;
    if (!begin_run(&run, r, o, s, 1, step / 2))
        return false;
    r->end = models_row(&run);
    *met += models_collisions(&run);
    scene_take_state(s, &run.scene);
    end_run(&run, r);
    return r->end == MODELS_DONE;
}

/* Looks half a step ahead, where the row ends, of a run that has met so
   many until it began. */
static bool look_aside(struct record *r, struct record_view *v,
                       const struct record_order *o, struct models_run *run,
                       struct scene *aside, uint64_t met)
{
    met += models_collisions(run);
    scene_take_state(aside, &run->scene);
    if (!leap(r, o, aside, &met))
        return false;
    ++r->reached;
    look(r, v, o, aside, met);
    return true;
}

/* So many steps, each a row of this run. */
static bool go_on(struct record *r, struct models_run *run, uint64_t steps)
{
    for (; steps > 0 && r->end == MODELS_DONE; --steps)
        r->end = models_row(run);
    return r->end == MODELS_DONE;
}

static void carry_halfway(struct record *r, struct record_view *v,
                          const struct record_order *o, struct scene *aside)
{
    struct models_run run;
    uint64_t met = 0;
    const uint64_t steps = o->plan.steps;
    if (!leap(r, o, aside, &met) ||
        !begin_run(&run, r, o, aside, 1, o->every / (double)steps))
        return;
    while (go_on(r, &run, steps - 1) &&
           look_aside(r, v, o, &run, aside, met) && r->reached < o->rows &&
           !strays(r, v, o))
        r->end = models_row(&run);
    end_run(&run, r);
}

static bool carry_aside(struct record *r, struct record_view *v,
                        const struct record_order *o, const struct scene *s)
{
    struct scene aside;
    if (!copy_for_states(&aside, s))
        return false;
    carry_halfway(r, v, o, &aside);
    scene_free(&aside);
    return true;
}

static bool carry_watched(struct record *r, struct record_view *v,
                          const struct record_order *o,
                          struct models_run *run, const struct scene *s)
{
    struct ways ways;
    const bool good = make_ways(&ways, s);
    if (good)
        carry(r, v, o, run, &ways);
    free_ways(&ways);
    return good;
}

/* Carries a run that has begun. False: no memory. */
static bool carry_begun(struct record *r, struct record_view *v,
                        const struct record_order *o,
                        struct models_run *run, const struct scene *s)
{
    look(r, v, o, &run->scene, 0);
    r->speed = speed_of(&v->scene);
    if (is_halfway(o))
        return carry_aside(r, v, o, s);
    if (o->watched && s->contact && o->plan.steps > 0)
        return carry_watched(r, v, o, run, s);
    carry(r, v, o, run, NULL);
    return true;
}

static bool set_out(struct record *r, struct record_view *v,
                    const struct record_order *o, const struct scene *s)
{
    struct models_run run;
    const uint64_t parts = parts_of(o);
    if (!begin_run(&run, r, o, s, o->plan.steps / parts,
                   o->every / (double)parts))
        return true;
    r->value = malloc((o->rows + 1) * v->columns * sizeof *r->value);
    const bool good = r->value && carry_begun(r, v, o, &run, s);
    end_run(&run, r);
    r->cost = models_cost(r->work);
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
