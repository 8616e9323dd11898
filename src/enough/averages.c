/* From chapters/12-averages.nw: edit there, then run make tangle. */
/* checksum 3469685980 of the lines below */
/* Laws, springs, whole runs, samples and events; the cheapest is taken. */
#include "enough/averages.h"

#include "box/blocks.h"
#include "enough/closed.h"
#include "line/piston.h"
#include "box/sampling.h"
#include "line/statistics.h"
#include "toolbox/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    enum averages_kind kind;
} plain[] = {{"pressure", AVERAGES_PRESSURE},
             {"kinetic", AVERAGES_KINETIC},
             {"temperature", AVERAGES_TEMPERATURE}};

bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT])
{
    char *end;
    for (size_t k = 0; k < sizeof plain / sizeof plain[0]; ++k)
        if (strcmp(name, plain[k].name) == 0) {
            *q = (struct averages_quantity){.kind = plain[k].kind};
            return true;
        }
    if ((name[0] == 'x' || name[0] == 'y') && name[1] == ':' &&
        name[2] >= '0' && name[2] <= '9') {
        const unsigned long long body = strtoull(name + 2, &end, 10);
        *q = (struct averages_quantity){AVERAGES_PLACE, (size_t)body,
                                        name[0] == 'y'};
        if (*end == '\0' && body < s->bodies)
            return true;
    }
    snprintf(message, AVERAGES_TEXT,
             "'%.40s' is no average: pressure, temperature, kinetic and, "
             "with a body from 0 to %zu, x:0 or y:0 are",
             name, s->bodies - 1);
    return false;
}

const char *averages_name(const struct averages_quantity *q,
                          char symbol[32])
{
    static const char *const symbols[] = {"Z", "", "K", "kT"};
    if (q->kind != AVERAGES_PLACE) {
        snprintf(symbol, 32, "%s", symbols[q->kind]);
        return q->kind == AVERAGES_PRESSURE ? "" : "mass length^2/time^2";
    }
    snprintf(symbol, 32, "%c:%zu", q->axis == 0 ? 'x' : 'y', q->body);
    return "length";
}

/* A search under way. */
struct search {
    const struct averages_request *q;
    struct averages_found *f;
    const struct scene *s;
    size_t n, axis, dimensions; /* bodies; the first axis of 1 or 2 */
    bool periodic;
    double box[2];     /* from wall to wall, m */
    double energy;     /* kinetic, J; without walls: about the centre */
    double mass;       /* of all, kg */
    double radii;      /* sum, m */
    bool alike, equal; /* all radii, all masses are */
};

static double coordinate(const struct search *h, size_t i)
{
    return h->s->position[h->axis * h->n + i];
}

/* The velocity of all together along an axis. */
static double drift(const struct search *h, size_t k)
{
    double sum = 0;
    for (size_t i = 0; i < h->n; ++i)
        sum += h->s->mass[i] * h->s->velocity[k * h->n + i];
    return h->periodic ? sum / h->mass : 0;
}

/* What is no room for points between 0 and the place of a body, m; *rank
   is how many bodies are to its left. */
static double taken_out(const struct search *h, size_t body, size_t *rank)
{
    double shift = h->s->low[h->axis] + h->s->radius[body];
    *rank = 0;
    for (size_t i = 0; i < h->n; ++i)
        if (coordinate(h, i) < coordinate(h, body)) {
            shift += 2 * h->s->radius[i];
            ++*rank;
        }
    return shift;
}

static void add_up(struct search *h)
{
    const struct scene *s = h->s;
    h->alike = h->equal = true;
    for (size_t i = 0; i < h->n; ++i) {
        h->mass += s->mass[i];
        h->radii += s->radius[i];
        h->alike = h->alike && s->radius[i] == s->radius[0];
        h->equal = h->equal && s->mass[i] == s->mass[0];
    }
    for (size_t d = 0; d < h->dimensions; ++d) {
        const size_t k = h->axis + d;
        const double mean = drift(h, k);
        h->box[d] = s->high[k] - s->low[k];
        for (size_t i = 0; i < h->n; ++i) {
            const double v = s->velocity[k * h->n + i] - mean;
            h->energy += s->mass[i] * v * v / 2;
        }
    }
}

/* NULL, or why averages have no meaning here, or are not to be had. */
static const char *unfit(const struct scene *s, const struct models_acts *a)
{
    if (a->gravity || a->springs || a->weight || a->friction ||
        a->dashpots || !a->contact)
        return "averages are known here of bodies that collide and feel "
               "no force";
    if (s->restitution != 1)
        return "each collision loses energy: the scene comes to rest, and "
               "to no equilibrium";
    if (a->free < s->bodies)
        return "a body is held: averages are known of free ones";
    if (a->dimensions < 1 || a->axes > 3)
        return "averages are known of bodies that move on a line or in "
               "the plane of x and y";
    return NULL;
}

/* NULL, or what is wrong with the walls. */
static const char *unwalled(struct search *h)
{
    const enum scene_wall *wall = h->s->wall + h->axis;
    h->periodic = wall[0] == SCENE_PERIODIC;
    for (size_t d = 0; d < h->dimensions; ++d)
        if (wall[d] == SCENE_OPEN || wall[d] != wall[0])
            return "the box is not closed: bodies leave for ever, or it "
                   "has walls along one axis only";
    if (h->periodic && h->dimensions == 1)
        return "a line without walls is no box";
    if (h->q->quantity.kind != AVERAGES_PLACE)
        return NULL;
    if (h->periodic)
        return "in a periodic box no place is the mean";
    return h->q->quantity.axis >= h->axis &&
                   h->q->quantity.axis < h->axis + h->dimensions
               ? NULL
               : "nothing moves along this axis";
}

/* NULL with *h filled in, or why there is nothing to average. */
static const char *survey(struct search *h)
{
    struct models_acts acts;
    models_analyse(&acts, h->s);
    const char *why = unfit(h->s, &acts);
    if (why)
        return why;
    h->n = h->s->bodies;
    h->axis = acts.axes == 2;
    h->dimensions = acts.dimensions;
    if ((why = unwalled(h)))
        return why;
    add_up(h);
    return h->energy > 0 ? NULL : "nothing moves";
}

static struct averages_candidate *enter(struct search *h, const char *name)
{
    struct averages_candidate *c = &h->f->candidate[h->f->candidates++];
    *c = (struct averages_candidate){.name = name, .sure = AVERAGES_OUT};
    return c;
}

/* Says whether this way may be taken. */
static bool wanted(const struct search *h, const char *name)
{
    return !h->q->model || strcmp(h->q->model, name) == 0;
}

/* What a check against events may cost, s by the price list. */
static double patience(const struct search *h)
{
    return h->q->reason / 20;
}

/* What errors of this quantity are divided by, when its value is this. */
static double scale_of(const struct search *h, double value)
{
    const struct averages_quantity *q = &h->q->quantity;
    if (q->kind == AVERAGES_PRESSURE)
        return fabs(value) > 1 ? fabs(value) : 1;
    return q->kind == AVERAGES_PLACE ? h->box[q->axis - h->axis] : value;
}

static void take_conserved(struct search *h)
{
    const bool warm = h->q->quantity.kind == AVERAGES_TEMPERATURE;
    struct averages_candidate *c;
    if (!warm && h->q->quantity.kind != AVERAGES_KINETIC)
        return;
    c = enter(h, "conserved");
    double energy = 0, free = 0;
    for (size_t i = 0; i < SCENE_AXES * h->n; ++i) {
        const double v = h->s->velocity[i];
        energy += h->s->mass[i % h->n] * v * v / 2;
        free += h->s->freedom[i];
    }
    c->value = warm ? 2 * energy / free : energy;
    c->sure = AVERAGES_EXACT;
    snprintf(c->text, AVERAGES_TEXT, "elastic contacts change neither");
}

/* Sets *first and *last to the radii of the bodies beside the walls. */
static void outer_radii(const struct search *h, double *first, double *last)
{
    size_t low = 0, high = 0;
    for (size_t i = 1; i < h->n; ++i) {
        if (coordinate(h, i) < coordinate(h, low))
            low = i;
        if (coordinate(h, i) > coordinate(h, high))
            high = i;
    }
    *first = h->s->radius[low];
    *last = h->s->radius[high];
}

static void take_tonks(struct search *h)
{
    double first, last;
    if (h->q->quantity.kind != AVERAGES_PRESSURE || h->dimensions > 1)
        return;
    struct averages_candidate *c = enter(h, "tonks");
    const double free = h->box[0] - 2 * h->radii;
    outer_radii(h, &first, &last);
    c->value = (h->box[0] - first - last) / free;
    c->error = free * sqrt(h->mass / (2 * h->energy)) / h->q->until;
    c->sure = AVERAGES_BOUND;
    snprintf(c->text, AVERAGES_TEXT,
             "free length %.6g; no run of this time is further off", free);
}

static void enter_two_disks(struct search *h,
                            struct averages_candidate **law)
{
    const struct averages_quantity *q = &h->q->quantity;
    const double sigma = 2 * h->s->radius[0];
    const double a = h->box[0] - sigma, b = h->box[1] - sigma, ab = a * b;
    if (h->dimensions != 2 || h->n != 2 || h->periodic || !h->alike ||
        !h->equal || sigma > a || sigma > b)
        return;
    struct averages_candidate *c = enter(h, "two-disks");
    const double pi = 3.14159265358979324, s2 = sigma * sigma;
    const double share = 1 - pi * s2 / ab +
                         4 * sigma * s2 * (a + b) / (3 * ab * ab) -
                         s2 * s2 / (2 * ab * ab);
    const double slope = -2 * pi * sigma / ab +
                         4 * s2 * (a + b) / (ab * ab) -
                         2 * sigma * s2 / (ab * ab);
    c->value = q->kind == AVERAGES_PRESSURE
                   ? 1 - sigma * slope / share / 4
                   : (h->s->low[q->axis] + h->s->high[q->axis]) / 2;
    snprintf(c->text, AVERAGES_TEXT,
             "two equal disks between walls mix (proved)");
    if (wanted(h, c->name))
        *law = c;
}

enum { ALIKE = 8 }; /* bodies whose places are compared */

/* A way that takes samples, one after the other. */
struct way {
    const char *name;
    struct search *h;
    struct blocks blocks;
    size_t width, body[ALIKE]; /* quantities; whose places they are */
    size_t columns;            /* these, and the share of the energy */
    double work[MODELS_UNITS];
    bool begun, over, dear; /* over: it cannot go on; dear: or may not */
    const char *why;        /* NULL, or why it is out */
    bool (*begin)(struct way *w);
    bool (*sample)(struct way *w, double value[]);
    double goal;  /* the error that will do */
    double least; /* cost of the first look, s by the price list */
    double free;  /* of an independent sample, could disks move freely */
    struct models_run run; /* by events */
    bool running;
    double pace, virial;
    struct sampling box; /* by a chain */
    struct random random;
    double step;
    double *point; /* of equal masses, see begin_instants */
    double shift;  /* of the body that is asked for, m */
    size_t rank;
    uint64_t sweeps;
    double mean, error; /* two standard errors, share of the scale */
    double least_error; /* as small as it may be */
    double inefficiency;
    uint64_t samples;
    bool looked, plateau, steady, mixed;
    bool contradicted;          /* a chain, by events */
    bool witness;               /* asked by a chain only */
    double first, sum, squares; /* of samples, from the first one on */
    double spread; /* of the means of bodies that are alike, m */
    uint64_t taken;
    double apart; /* how far the means of bodies that are alike are, m */
    double share; /* of the energy along the first axis, mean */
    bool shared;  /* it is a half */
    bool central; /* the mean place is the middle */
};

static double cost(const struct way *w)
{
    return models_cost(w->work);
}

/* The bodies whose places are sampled: the one that is asked for, and in
   the plane some that are just like it. */
static void compare_alike(struct way *w)
{
    const struct search *h = w->h;
    const size_t body = h->q->quantity.body;
    w->body[0] = body;
    w->width = 1;
    if (h->q->quantity.kind != AVERAGES_PLACE || h->dimensions == 1)
        return;
    for (size_t i = 0; i < h->n && w->width < ALIKE; ++i)
        if (i != body && h->s->mass[i] == h->s->mass[body] &&
            h->s->radius[i] == h->s->radius[body])
            w->body[w->width++] = i;
}

/* The time from one sample to the next, s. */
static double pace_of(const struct search *h)
{
    const double kT = 2 * h->energy / (double)(h->dimensions * h->n);
    const struct averages_quantity *q = &h->q->quantity;
    const double longest = h->q->until / 256;
    double pace, squares = 0;
    if (q->kind == AVERAGES_PLACE)
        pace =
            h->box[q->axis - h->axis] / 64 / sqrt(kT / h->s->mass[q->body]);
    else {
        for (size_t i = 0; i < h->n; ++i)
            squares += kT / h->s->mass[i];
        const double v = sqrt(squares / (double)h->n), n = (double)h->n;
        pace = (h->dimensions == 1 ? h->box[0] / n
                                   : sqrt(h->box[0] * h->box[1] / n)) /
               4 / v;
    }
    return pace < longest ? pace : longest;
}

static bool begin_events(struct way *w)
{
    const struct search *h = w->h;
    struct models_plan plan = {
        .model = models_find(h->dimensions == 1 ? "line" : "disks")};
    w->pace = pace_of(h);
    const char *why;
    w->running = models_begin(&w->run, &plan, h->s, w->pace, &why);
    w->why = w->running ? NULL : why;
    return w->running;
}

/* The share of the kinetic energy that is in the motion along x. */
static double share_of(const struct search *h, const double velocity[])
{
    const double mean = drift(h, h->axis);
    double sum = 0;
    for (size_t i = 0; i < h->n; ++i) {
        const double v = velocity[h->axis * h->n + i] - mean;
        sum += h->s->mass[i] * v * v / 2;
    }
    return sum / h->energy;
}

static bool sample_events(struct way *w, double value[])
{
    const struct search *h = w->h;
    const struct averages_quantity *q = &h->q->quantity;
    struct models_run *r = &w->run;
    if ((double)(r->rows + 1) * w->pace > h->q->until ||
        models_row(r) != MODELS_DONE)
        return false;
    memcpy(w->work, r->work, sizeof w->work);
    w->work[MODELS_FLIGHT] += (double)(r->rows * h->n * h->dimensions);
    if (q->kind == AVERAGES_PLACE)
        for (size_t k = 0; k < w->width; ++k)
            value[k] = r->scene.position[q->axis * h->n + w->body[k]];
    else {
        const double n = (double)h->n, gain = r->virial - w->virial;
        value[0] = 1 + gain * (h->periodic ? (n - 1) / n : 1) /
                           (2 * h->energy * w->pace);
        w->virial = r->virial;
    }
    if (w->columns > w->width)
        value[w->width] = share_of(h, r->scene.velocity);
    return true;
}

/* NULL, or why a chain cannot be had. */
static const char *unsampled(const struct search *h)
{
    if (h->dimensions != 2)
        return "on a line the laws say more";
    if (!h->alike)
        return "sampling knows disks of one radius only";
    return h->n < 2 ? "a disk alone has no contacts" : NULL;
}

/* Sweeps once; returns the share of moves that were taken. */
static double sweep(struct way *w)
{
    const size_t n = w->h->n;
    size_t moved = 0;
    for (size_t k = 0; k < n; ++k)
        moved += sampling_try(&w->box, w->step, &w->random);
    w->work[MODELS_TRIAL] += (double)(n * n);
    return (double)moved / (double)n;
}

/* Notes what an independent place costs when it diffuses with this step,
   s by the price list. */
static bool expect_diffusion(struct way *w)
{
    const struct averages_quantity *q = &w->h->q->quantity;
    const double n = (double)w->h->n;
    if (q->kind == AVERAGES_PLACE) {
        const double way = w->h->box[q->axis] / w->step;
        double work[MODELS_UNITS] = {0};
        work[MODELS_TRIAL] = 3 * way * way * n * n;
        w->free = models_cost(work);
    }
    return true;
}

static bool begin_chain(struct way *w)
{
    const struct search *h = w->h;
    struct disks *d = &w->box.disks;
    random_seed(&w->random, 1);
    if (!sampling_create(&w->box, 2,
                         h->periodic ? DISKS_PERIODIC : DISKS_WALLS, h->box,
                         h->n, h->s->radius[0], 0, 0))
        return false;
    for (size_t i = 0; i < h->n; ++i)
        for (size_t k = 0; k < 2; ++k)
            d->disk[i].position[k] =
                h->s->position[k * h->n + i] - h->s->low[k];
    w->step = sqrt(h->box[0] * h->box[1] / (double)h->n) / 2;
    for (int k = 0; k < 32; ++k) {
        double taken = 0;
        size_t tries = 0;
        for (; tries < 256; tries += h->n)
            taken += sweep(w) * (double)h->n;
        w->step *= taken > 0.4 * (double)tries ? 1.25 : 0.8;
    }
    return expect_diffusion(w);
}

static bool sample_chain(struct way *w, double value[])
{
    const struct search *h = w->h;
    const struct averages_quantity *q = &h->q->quantity;
    const struct disk *disk = w->box.disks.disk;
    const size_t n = h->n, turn = w->sweeps++ % (n - 1);
    sweep(w);
    if (q->kind == AVERAGES_PLACE) {
        for (size_t k = 0; k < w->width; ++k)
            value[k] =
                h->s->low[q->axis] + disk[w->body[k]].position[q->axis];
        return true;
    }
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += sampling_pair_density(&w->box, i, (i + 1 + turn) % n);
    w->work[MODELS_TRIAL] += (double)(n * n * (h->periodic ? 20 : 4));
    value[0] = 1 + (double)(n - 1) / (double)n * sum * h->s->radius[0] / 2;
    return true;
}

/* Blocks a column from the first block on that counts. */
static bool block(const struct way *w, size_t column, size_t from,
                  double *mean, struct statistics_blocking *b)
{
    double x[BLOCKS_MOST];
    const size_t n = w->blocks.count - from;
    *mean = 0;
    for (size_t i = 0; i < n; ++i) {
        x[i] = w->blocks.sum[(from + i) * w->columns + column] /
               (double)w->blocks.per;
        *mean += x[i] / (double)n;
    }
    return statistics_blocking(n, x, b);
}

/* The difference of the means of the two halves from a block on. */
static double halves(const struct way *w, size_t from)
{
    const size_t half = (w->blocks.count - from) / 2;
    double sum = 0;
    for (size_t i = 0; i < half; ++i)
        sum += w->blocks.sum[(from + half + i) * w->columns] -
               w->blocks.sum[(from + i) * w->columns];
    return sum / (double)half / (double)w->blocks.per;
}

/* Samples to an independent one, when the mean has this error. */
static double inefficiency(const struct way *w, double error)
{
    const double n = (double)w->taken, mean = w->sum / n;
    const double variance = w->squares / n - mean * mean;
    return variance > 0 ? error * error * (double)w->samples / variance : 1;
}

/* Compares the means of bodies that are alike. */
static bool compare(struct way *w, size_t from, double error)
{
    struct statistics_blocking b;
    double mean, sum = 0, squares = 0;
    w->mixed = true;
    w->apart = 0;
    for (size_t k = 1; k < w->width; ++k) {
        if (!block(w, k, from, &mean, &b))
            return false;
        const double apart = mean - w->mean;
        w->apart = fmax(w->apart, fabs(apart));
        w->mixed = w->mixed && fabs(apart) <= 5 * (error + b.error);
        sum += apart;
        squares += apart * apart;
    }
    const double n = (double)w->width;
    w->spread = n > 1 ? sqrt((squares - sum * sum / n) / (n - 1)) : 0;
    return true;
}

/* Says whether one body is much heavier than the others. */
static bool has_heavy(const struct scene *s)
{
    double most = 0, sum = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        most = fmax(most, s->mass[i]);
        sum += s->mass[i];
    }
    return most * (double)(s->bodies - 1) > 8 * (sum - most);
}

/* Looks at what mixing would make a half, and the middle. Returns false
   without memory. */
static bool doubt(struct way *w, size_t from)
{
    const struct search *h = w->h;
    const struct averages_quantity *q = &h->q->quantity;
    struct statistics_blocking b;
    w->shared = w->central = true;
    if (w->columns > w->width) {
        if (!block(w, w->width, from, &w->share, &b))
            return false;
        w->shared = fabs(w->share - 0.5) <= 5 * b.error + 1e-9;
    }
    if (q->kind == AVERAGES_PLACE && h->dimensions == 1)
        w->central = !has_heavy(h->s);
    if (q->kind == AVERAGES_PLACE && h->dimensions == 2) {
        const double middle =
            (h->s->low[q->axis] + h->s->high[q->axis]) / 2;
        w->central = fabs(w->mean - middle) <=
                     1.5 * w->error * h->box[q->axis - h->axis];
    }
    return true;
}

/* Says whether the scene has not been everywhere, as far as is known. */
static bool doubted(const struct way *w)
{
    return w->looked && !(w->shared && w->central);
}

enum { WITNESSES = 90 }; /* independent samples that a plateau takes */

/* How many times as long as it is the run has to be, at least, for two
   standard errors of e. */
static double lengthen(const struct way *w, double e)
{
    const struct search *h = w->h;
    const struct averages_quantity *q = &h->q->quantity;
    const double r = w->error / e, n = (double)w->samples;
    const double longer = fmax(r * r, WITNESSES * w->inefficiency / n);
    if (q->kind != AVERAGES_PLACE || w->width < 2)
        return longer;
    const double box = h->box[q->axis - h->axis];
    const double room = box - 2 * h->s->radius[q->body];
    const double known = 2 * w->spread / (e * box);
    const double share = sqrt(12) * w->spread / room;
    return fmax(longer, fmax(known * known, WITNESSES * share * share));
}

/* Looks at the last three quarters. Returns false without memory. */
static bool look(struct way *w)
{
    struct statistics_blocking b;
    const size_t from = (w->blocks.count + 3) / 4;
    if (!block(w, 0, from, &w->mean, &b))
        return false;
    const double sure = b.error + b.level[b.chosen].uncertainty;
    w->error = 2 * sure / scale_of(w->h, w->mean);
    if (w->point)
        w->error += 3 / (double)w->samples; /* what none has seen */
    if (w->sweeps > 0 && w->h->q->quantity.kind == AVERAGES_PRESSURE)
        w->error *= 1.5; /* the means of 1/l have a long tail */
    w->least_error = (2 * b.error / sure - 1) * w->error;
    w->looked = true;
    w->plateau = b.plateau;
    w->samples = (w->blocks.count - from) * w->blocks.per;
    w->inefficiency = inefficiency(w, b.error);
    w->steady = fabs(halves(w, from)) <= 6 * b.error;
    return compare(w, from, b.error) && doubt(w, from);
}

/* Says whether the error of a way can be believed. */
static bool settled(const struct way *w)
{
    return w->looked && w->plateau && w->steady && w->mixed;
}

static bool holds(const struct way *w)
{
    return settled(w) && w->error <= w->h->q->tolerance;
}

/* What the whole way will cost, s by the price list, as it looks now, when
   two standard errors of e are wanted; if it has not settled, at least. */
static double price(const struct way *w, double e)
{
    const double first =
        fmax(w->least, w->free * fmax(120, 4 / (9 * e * e)));
    const double r = w->error / e;
    if (!w->looked)
        return first;
    if (settled(w))
        return cost(w) * fmax(1.25, r * r);
    return fmax(first, cost(w) * fmax(2, lengthen(w, e)));
}

/* What a run will cost to the end of its time, s by the price list. */
static double to_the_end(const struct way *w)
{
    return cost(w) * w->h->q->until / ((double)w->run.rows * w->pace);
}

/* Says whether a way that holds is doubted, and not at the end of its time:
   that has not come, or nobody pays for it. */
static bool is_unfinished(const struct way *w)
{
    return holds(w) && doubted(w) && w->running && (!w->over || w->dear);
}

static double predicted(const struct way *w)
{
    if (is_unfinished(w))
        return to_the_end(w);
    return holds(w) ? cost(w) : price(w, w->goal);
}

/* Adds a sample to the sums of all, counted from the first one. */
static void note(struct way *w, double value)
{
    w->first = w->taken++ == 0 ? value : w->first;
    w->sum += value - w->first;
    w->squares += (value - w->first) * (value - w->first);
}

/* Goes on to the next look. Returns false without memory. */
static bool advance(struct way *w)
{
    double value[ALIKE + 1];
    if (!w->begun && !(w->begun = w->begin(w))) {
        w->over = true;
        return w->why != NULL;
    }
    do {
        w->dear = cost(w) > w->h->q->reason;
        if (w->dear || !w->sample(w, value)) {
            w->over = true;
            return w->blocks.count < 2 || look(w);
        }
        blocks_add(&w->blocks, value);
        note(w, value[0]);
    } while (w->blocks.filled > 0 || w->blocks.count % 64 > 0 ||
             w->blocks.count < 256);
    return look(w);
}

/* A heavy body between two gases, as chapter 4 sees it. */
struct swing {
    struct piston piston;
    double x, v, shift; /* at the start, m and m/s; of the place, m */
    double frequency;   /* at the start, 1/s */
    double mean, reach; /* of the springs alone, m: half the way */
    size_t left;        /* bodies on that side */
};

/* Adds what a body is to the gas that it belongs to. */
static void join_gas(struct swing *w, const struct search *h, size_t i)
{
    const size_t body = h->q->quantity.body;
    const bool left = coordinate(h, i) < coordinate(h, body);
    struct piston_gas *gas = left ? &w->piston.left : &w->piston.right;
    const double v = h->s->velocity[h->axis * h->n + i];
    gas->energy += h->s->mass[i] * v * v / 2;
    gas->mass += h->s->mass[i];
    w->left += left;
    w->shift += left ? 2 * h->s->radius[i] : 0;
}

/* How stiff the spring is that a gas makes, N/m. */
static double stiffness(const struct piston_gas *gas)
{
    return 6 * gas->energy / (gas->length * gas->length);
}

/* Fills in the springs. Returns NULL, or why the body is no piston. */
static const char *find_piston(struct swing *w, const struct search *h)
{
    const size_t body = h->q->quantity.body;
    struct piston *p = &w->piston;
    *w = (struct swing){.shift = h->s->low[h->axis] + h->s->radius[body]};
    p->mass = h->s->mass[body];
    for (size_t i = 0; i < h->n; ++i)
        if (i != body && h->s->mass[i] > p->mass / 10)
            return "the body is not ten times as heavy as all others";
        else if (i != body)
            join_gas(w, h, i);
    p->length = h->box[0] - 2 * h->radii;
    p->left.length = w->x = coordinate(h, body) - w->shift;
    p->right.length = p->length - w->x;
    w->v =
        h->s->velocity[h->axis * h->n + body] * p->mass / piston_inertia(p);
    w->frequency = sqrt((stiffness(&p->left) + stiffness(&p->right)) /
                        piston_inertia(p));
    return p->left.energy > 0 && p->right.energy > 0
               ? NULL
               : "a gas is missing or cold";
}

/* Lets the springs swing for this time in so many steps; sums the places,
   m, by the trapezoidal rule. Returns false when a step is too long. */
static bool swing_for(struct swing *w, double time, uint64_t steps,
                      double *mean)
{
    struct piston_state s = {w->x, w->v};
    double sum = w->x / 2, low = w->x, high = w->x;
    for (uint64_t k = 0; k < steps; ++k) {
        if (!piston_step(&w->piston, &s, time / (double)steps))
            return false;
        sum += s.x;
        low = s.x < low ? s.x : low;
        high = s.x > high ? s.x : high;
    }
    *mean = (sum - s.x / 2) / (double)steps;
    w->reach = (high - low) / 2;
    return true;
}

enum { SWING_MOST = 1 << 24 }; /* steps */

/* Halves the steps until the mean stays where it is; of a very long run
   some hundred swings will do. */
static bool settle_swing(struct swing *w, double time, double close,
                         double work[])
{
    const double longest = 4000 / w->frequency;
    const double wish =
        (time < longest ? time : longest) * w->frequency * 10;
    uint64_t steps = wish < 1024 ? 1024 : (uint64_t)wish;
    double before = INFINITY;
    for (; steps < SWING_MOST; steps *= 2) {
        work[MODELS_FLIGHT] += 2 * (double)steps;
        if (swing_for(w, time < longest ? time : longest, steps,
                      &w->mean)) {
            if (fabs(w->mean - before) <= close)
                return true;
            before = w->mean;
        }
    }
    return false;
}

enum { ROWS = 256, STEPS = 16 }; /* of the check; in each row */

/* How far, m, the springs are from the events in the next row; NAN if one
   of the two cannot go on. */
static double lag(const struct swing *w, const struct search *h,
                  struct models_run *r, struct piston_state *s)
{
    const size_t at = h->axis * h->n + h->q->quantity.body;
    bool well = models_row(r) == MODELS_DONE;
    for (int j = 0; well && j < STEPS; ++j)
        well = piston_step(&w->piston, s, r->every / STEPS);
    return well ? r->scene.position[at] - w->shift - s->x : NAN;
}

/* The largest difference, m, of the means by events and by springs, from
   the start on, in the second half of a stretch of this length, s. NAN if
   there is none. */
static double check_swing(const struct swing *w, const struct search *h,
                          double stretch, int rows)
{
    const struct models_plan plan = {.model = models_find("line")};
    struct piston_state s = {w->x, w->v};
    struct models_run r;
    const char *why;
    double sum = 0, worst = 0;
    if (!models_begin(&r, &plan, h->s, stretch / rows, &why))
        return NAN;
    for (int k = 1; k <= rows && !isnan(sum); ++k) {
        sum += lag(w, h, &r, &s);
        if (2 * k > rows && fabs(sum / k) > worst)
            worst = fabs(sum / k);
    }
    for (size_t u = 0; u < MODELS_UNITS; ++u)
        h->f->work[u] += r.work[u];
    models_end(&r);
    return isnan(sum) ? NAN : worst;
}

/* How far the mean may have moved, m, when the piston has come so far on
   its way to equilibrium as it will in this time. */
static double wander(const struct swing *w, const struct search *h)
{
    const struct piston *p = &w->piston;
    const double inertia = piston_inertia(p), pi = 3.14159265358979324;
    const double law =
        p->length * (double)(w->left + 1) / (double)(h->n + 1);
    const double friction =
        4 * (sqrt(p->left.mass * p->left.energy / pi) / p->left.length +
             sqrt(p->right.mass * p->right.energy / pi) / p->right.length);
    const double u = 12 * w->reach / p->length *
                     (p->left.mass + p->right.mass) / inertia;
    const double share = u * u / 2 < 1 ? u * u / 2 : 1;
    const double gone = h->q->until * friction * share / inertia;
    return (gone < 1 ? gone : 1) * (w->reach + fabs(w->mean - law));
}

static void take_springs(struct search *h)
{
    const double T = h->q->until, close = h->q->tolerance * h->box[0] / 50;
    struct swing w;
    double own[MODELS_UNITS] = {0};
    if (h->q->quantity.kind != AVERAGES_PLACE || h->dimensions != 1)
        return;
    struct averages_candidate *c = enter(h, "springs");
    const char *why = find_piston(&w, h);
    if (why || !settle_swing(&w, T, close, own)) {
        snprintf(c->text, AVERAGES_TEXT, "%s",
                 why ? why : "the swing takes too many steps");
        return;
    }
    const double periods = 4 * 3.14159265358979324 / w.frequency;
    const double before = models_cost(h->f->work), drift = wander(&w, h);
    double stretch = periods < T / 4 ? periods : T / 4;
    double off = check_swing(&w, h, stretch, ROWS);
    const double price = models_cost(h->f->work) - before;
    const double times = fmin(T / stretch, patience(h) / price);
    if (times > 1 && off <= h->q->tolerance * h->box[0]) {
        stretch *= times;
        off = check_swing(&w, h, stretch, (int)fmin(ROWS * times, 1e6));
    }
    c->value = w.shift + w.mean;
    const double unseen = T / stretch;
    c->error = (off * unseen * unseen + drift) / h->box[0];
    c->sure = isnan(off) ? AVERAGES_OUT : AVERAGES_ESTIMATE;
    for (size_t u = 0; u < MODELS_UNITS; ++u)
        h->f->work[u] += own[u];
    c->cost = models_cost(own);
    snprintf(
        c->text, AVERAGES_TEXT,
        "off by %.2g of the box in %.4g s beside events; on the way to "
        "equilibrium it may move by %.2g",
        off / h->box[0], stretch, drift / h->box[0]);
}

/* How many rows a run takes, for the mean place of its body to be off by
   at most half the tolerance (eq:averages-bends). */
static double rows_needed(const struct search *h, double *error)
{
    const struct averages_request *q = h->q;
    const double free = h->box[0] - 2 * h->radii, T = q->until;
    const double v = sqrt(2 * h->energy / h->mass);
    const double bends = h->energy / (2 * free * h->box[0]) /
                         h->s->mass[q->quantity.body] *
                         (1 + 2 * free / (v * T));
    const double rows = ceil(T * sqrt(2 * bends / q->tolerance));
    *error = bends * (T / rows) * (T / rows);
    return rows;
}

/* Multiplies all lengths of a scene. */
static void convert(struct scene *s, double unit)
{
    for (size_t c = 0; c < SCENE_AXES * s->bodies; ++c) {
        s->position[c] *= unit;
        s->velocity[c] *= unit;
    }
    for (size_t i = 0; i < s->bodies; ++i)
        s->radius[i] *= unit;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        s->low[k] *= unit;
        s->high[k] *= unit;
    }
}

/* What two runs of so many rows will cost, s by the price list, as it
   looks now. */
static double foreseen(const struct models_run *r, double rows)
{
    return 2 * models_cost(r->work) * rows / (double)r->rows;
}

/* The mean place in a run of so many rows, by the trapezoidal rule. NAN if
   it ends before: it is too dear, or stuck. */
static double sum_rows(const struct search *h, struct models_run *r,
                       double rows)
{
    const size_t at = h->axis * h->n + h->q->quantity.body;
    double sum = r->scene.position[at] / 2;
    while ((double)r->rows < rows) {
        if (models_row(r) != MODELS_DONE ||
            (r->rows > 1024 && foreseen(r, rows) > h->q->reason))
            return NAN;
        r->work[MODELS_FLIGHT] += (double)h->n;
        sum += r->scene.position[at];
    }
    return (sum - r->scene.position[at] / 2) / rows;
}

/* The mean place, m, in a run of so many rows in units of which a metre
   has so many; NAN if there is none. Adds its work, and sets what both
   runs will cost. */
static double run_whole(const struct search *h, double unit, double rows,
                        double work[], double *price)
{
    const struct models_plan plan = {.model = models_find("line")};
    struct models_run r;
    struct scene s;
    const char *why;
    double mean = NAN;
    if (!scene_copy(&s, h->s))
        return NAN;
    convert(&s, unit);
    if (models_begin(&r, &plan, &s, h->q->until / rows, &why)) {
        mean = sum_rows(h, &r, rows) / unit;
        for (size_t u = 0; u < MODELS_UNITS; ++u)
            work[u] += r.work[u];
        *price = foreseen(&r, rows);
        models_end(&r);
    }
    scene_free(&s);
    return mean;
}

/* Says whether the places that are asked for never mix. */
static bool never_mixes(const struct search *h)
{
    return h->q->quantity.kind == AVERAGES_PLACE && h->dimensions == 1 &&
           (h->n < 3 || h->equal);
}

static void take_whole(struct search *h)
{
    double bound, own[MODELS_UNITS] = {0}, price = INFINITY;
    if (!never_mixes(h) || h->equal)
        return;
    struct averages_candidate *c = enter(h, "whole");
    const double rows = rows_needed(h, &bound);
    if (!wanted(h, c->name)) {
        snprintf(c->text, AVERAGES_TEXT, "another way was asked for");
        return;
    }
    c->value = run_whole(h, 1, rows, own, &price);
    if (!isnan(c->value)) {
        const double twin = run_whole(h, 0.7, rows, own, &price);
        const double off = fabs(twin - c->value) / h->box[0];
        c->error = bound + 4 * off;
        c->sure = isnan(off) ? AVERAGES_OUT : AVERAGES_ESTIMATE;
        h->f->time = h->q->until;
        snprintf(c->text, AVERAGES_TEXT,
                 "all of the run, as two alone on a line may never forget; "
                 "%.2g of the box off in other units",
                 off);
    }
    c->cost = models_cost(own);
    for (size_t u = 0; u < MODELS_UNITS; ++u)
        h->f->work[u] += own[u];
    const double room = 0.7 * h->q->reason / price;
    if (c->sure == AVERAGES_OUT)
        snprintf(c->text, AVERAGES_TEXT,
                 "two alone on a line may never forget: only all of the "
                 "run tells, and %.4g s of it cost %.2g s by the price "
                 "list, of %.3g; ask for %.1g s",
                 h->q->until, price, h->q->reason, h->q->until * room);
}

/* Makes points of the bodies: n places without radii, n velocities, and
   room for both at another time. */
static bool begin_instants(struct way *w)
{
    const struct search *h = w->h;
    w->point = malloc(4 * h->n * sizeof *w->point);
    if (!w->point)
        return false;
    for (size_t i = 0; i < h->n; ++i) {
        w->point[i] = coordinate(h, i) - taken_out(h, i, &w->rank);
        w->point[h->n + i] = h->s->velocity[h->axis * h->n + i];
    }
    w->shift = taken_out(h, h->q->quantity.body, &w->rank);
    random_seed(&w->random, 1);
    return true;
}

static bool sample_instants(struct way *w, double value[])
{
    const struct search *h = w->h;
    const size_t n = h->n;
    double *x = w->point, *v = x + n, *place = v + n, *speed = place + n;
    const double t = random_between(&w->random, 0, h->q->until);
    w->work[MODELS_FLIGHT] += (double)n;
    for (size_t m = n; m > 0; m /= 2) /* n log n comparisons */
        w->work[MODELS_ORDER] += (double)n;
    if (!closed_relabel(0, h->box[0] - 2 * h->radii, n, x, v, t, place,
                        speed))
        return false;
    value[0] = w->shift + place[w->rank];
    return true;
}

static void enter_order(struct search *h, struct averages_candidate **law)
{
    const struct averages_quantity *q = &h->q->quantity;
    size_t rank;
    if (q->kind != AVERAGES_PLACE || h->dimensions != 1)
        return;
    struct averages_candidate *c = enter(h, "order");
    const double shift = taken_out(h, q->body, &rank);
    c->value = shift + (h->box[0] - 2 * h->radii) * (double)(rank + 1) /
                           (double)(h->n + 1);
    if (h->n < 3)
        snprintf(c->text, AVERAGES_TEXT, "fewer than three do not mix");
    else if (h->equal)
        snprintf(c->text, AVERAGES_TEXT,
                 "equal masses only exchange their speeds");
    else
        *law = c;
}

/* Says whether events have settled, and agree with the law. */
static bool agree(const struct averages_candidate *law, const struct way *w,
                  const struct search *h)
{
    const double off = fabs(w->mean - law->value) / scale_of(h, law->value);
    return settled(w) && w->error <= fmax(0.01, h->q->tolerance) &&
           off <= 1.5 * w->error;
}

/* Says whether events, which have settled, bear the law out: a bet, for as
   long as may be looked. */
static bool borne_out(const struct averages_candidate *law,
                      const struct way *w, const struct search *h)
{
    const bool bet = strcmp(law->name, "order") == 0;
    const bool seen = w->over || cost(w) >= patience(h);
    return agree(law, w, h) && (!bet || seen);
}

/* Says whether the law is to be taken, or what the way has found; where
   the law contradicts it, only after all of the time. */
static bool trusted(const struct way *w,
                    const struct averages_candidate *law)
{
    if (doubted(w) && !w->over)
        return false;
    if (law && borne_out(law, w, w->h) && wanted(w->h, law->name))
        return true;
    return holds(w) && wanted(w->h, w->name) &&
           (!law || w->over || agree(law, w, w->h));
}

/* Says whether a way is, as far as can be seen, too dear. */
static bool beyond(const struct way *w)
{
    const double r = w->looked ? w->least_error / w->error : 1;
    const double sure = w->looked && !settled(w) ? 2 * cost(w) : cost(w);
    return fmax(sure, predicted(w) * r * r) > w->h->q->reason;
}

enum { STUCK = 1 << 22 }; /* sweeps without a plateau */

/* The way that promises to be the cheapest, or NULL: all are over. */
static struct way *most_promising(struct way way[], size_t ways)
{
    struct way *best = NULL;
    for (size_t k = 0; k < ways; ++k) {
        struct way *w = &way[k];
        w->over = w->over || w->why ||
                  (w->sweeps > STUCK && !(w->plateau && w->mixed));
        w->dear = w->dear || (!w->over && beyond(w));
        w->over = w->over || w->dear;
        if (!w->over && !w->witness &&
            (!best || predicted(w) < predicted(best)))
            best = w;
    }
    return best;
}

/* Does the motion, as far as it has been looked at, what the chain says? */
static bool agrees(const struct way *chain, const struct way *events)
{
    const struct search *h = chain->h;
    const double off =
        fabs(chain->mean - events->mean) / scale_of(h, chain->mean);
    return settled(events) && events->error <= 4 * h->q->tolerance &&
           off <= 1.5 * (chain->error + events->error);
}

/* Lets events go on until they bear a chain out, or are over. Returns false
   without memory. */
static bool ask_events(struct way way[2], bool *good)
{
    struct way *events = &way[0], *chain = &way[1];
    *good = events->why != NULL;
    while (!*good && !events->over) {
        if (!advance(events))
            return false;
        *good = agrees(chain, events);
        events->over = events->over || beyond(events);
    }
    chain->contradicted = !*good;
    chain->over = chain->over || chain->contradicted;
    return true;
}

/* Lets the ways go on, always the one that promises most, until one holds
   or bears the law out: *winner, NULL if none. Returns false without
   memory. */
static bool race(struct way way[], size_t ways,
                 struct averages_candidate *law, struct way **winner)
{
    struct way *w;
    *winner = NULL;
    while ((w = most_promising(way, ways))) {
        if (!advance(w))
            return false;
        bool good = trusted(w, law);
        if (good && w == &way[1] && !ask_events(way, &good))
            return false;
        if (good || (w->contradicted && trusted(&way[0], law))) {
            *winner = good ? w : &way[0];
            break;
        }
    }
    return true;
}

/* What is known of a way when all is over. */
static void report(const struct way *w, struct averages_candidate *c)
{
    const struct search *h = w->h;
    c->value = w->looked ? w->mean : NAN;
    c->error = w->looked ? w->error : NAN;
    c->cost = predicted(w);
    c->sure =
        holds(w) && !w->contradicted ? AVERAGES_ESTIMATE : AVERAGES_OUT;
    if (w->why)
        snprintf(c->text, AVERAGES_TEXT, "%s", w->why);
    else if (!w->looked)
        snprintf(c->text, AVERAGES_TEXT, "dearer before its first look");
    else if (w->contradicted)
        snprintf(c->text, AVERAGES_TEXT,
                 "the motion does not go where the chain goes");
    else if (!w->mixed)
        snprintf(c->text, AVERAGES_TEXT,
                 "bodies that are just alike have means up to %.3g of the "
                 "box apart: they do not change places",
                 w->apart / scale_of(h, 0));
    else
        snprintf(c->text, AVERAGES_TEXT,
                 "%llu samples, %.3g to an independent one%s%s",
                 (unsigned long long)w->samples, w->inefficiency,
                 w->plateau ? "" : ", or more: no plateau",
                 w->steady ? "" : "; the halves disagree");
}

/* How far a way has come, in its own measure. */
static const char *way_gone(const struct way *w, char text[64])
{
    if (w->sweeps > 0)
        snprintf(text, 64, "%llu sweeps", (unsigned long long)w->sweeps);
    else
        snprintf(text, 64, "%.4g s", (double)w->run.rows * w->pace);
    return text;
}

/* Says what keeps a run that has come so far from an answer. */
static void unsettled(char *to, const struct way *w, const char *gone)
{
    if (!w->mixed)
        snprintf(to, AVERAGES_REFUSAL,
                 "it does not mix: in %s bodies that are just alike have "
                 "kept to places whose means are %.3g of the box apart; "
                 "the pressure does not care which is which: ask for that",
                 gone, w->apart / scale_of(w->h, 0));
    else
        snprintf(to, AVERAGES_REFUSAL,
                 "it does not settle in %s: %s; two standard errors are at "
                 "least %.2g; ask for a longer time",
                 gone,
                 w->steady ? "long blocks still remember each other"
                           : "the two halves of the run disagree",
                 w->error);
}

/* A number with two digits, not less than x. */
static double round_up(double x)
{
    const double unit = pow(10, floor(log10(x)) - 1);
    return ceil(x / unit) * unit;
}

/* The sharpest tolerance, to two digits, whose price is reasonable as far
   as can be seen; INFINITY if there is none. */
static double affordable(const struct way *w)
{
    for (double e = w->h->q->tolerance; e < 0.25; e *= 1.05)
        if (3 * price(w, e) <= w->h->q->reason)
            return round_up(e);
    return INFINITY;
}

/* Says which tolerance could be asked for at a reasonable price. */
static const char *offer(const struct way *w, char text[64])
{
    const double e = affordable(w);
    if (isfinite(e))
        snprintf(text, 64, "%.2g %s", e, settled(w) ? "fits" : "may fit");
    else
        snprintf(text, 64, "no tolerance fits%s",
                 w->h->q->quantity.kind == AVERAGES_PLACE
                     ? ": ask for the pressure"
                     : "");
    return text;
}

/* Says what a way would cost that is dearer than is reasonable. */
static void too_dear(char *to, const struct way *w, const char *gone)
{
    char text[64];
    int n = 0;
    if (w->looked && !w->mixed)
        n = snprintf(to, AVERAGES_REFUSAL,
                     "in %s bodies that are just alike have kept to places "
                     "whose means are %.3g of the box apart: ",
                     gone, w->apart / scale_of(w->h, 0));
    snprintf(to + n, AVERAGES_REFUSAL - (size_t)n,
             "%.2g would cost %s %.2g s by the price list, of %.3g that "
             "are reasonable; %s",
             w->goal, settled(w) ? "about" : "at least", price(w, w->goal),
             w->h->q->reason, offer(w, text));
}

/* Says what is doubtful about a way that has settled. */
static void come_round(char *to, const struct way *w, const char *gone)
{
    int n;
    if (!w->shared)
        n = snprintf(to, AVERAGES_REFUSAL,
                     "it does not mix: in %s the motion along x has %.2g "
                     "of the energy, and not a half",
                     gone, w->share);
    else if (w->h->dimensions == 1)
        n = snprintf(to, AVERAGES_REFUSAL,
                     "%s are too few to be sure of: one body is so much "
                     "heavier than the others that it remembers for long",
                     gone);
    else
        n = snprintf(to, AVERAGES_REFUSAL,
                     "it does not mix: in %s the mean is %.4g, and not the "
                     "middle of the box",
                     gone, w->mean);
    snprintf(to + n, AVERAGES_REFUSAL - (size_t)n,
             "; all of the time would cost %.2g s by the price list, of "
             "%.3g that are reasonable: ask for a shorter one",
             to_the_end(w), w->h->q->reason);
}

/* Says why a way that has taken samples gives no answer. */
static void refuse(struct search *h, const struct way *w)
{
    char *to = h->f->refusal, gone[64];
    const double e = h->q->tolerance, r = w->error / e;
    way_gone(w, gone);
    if (w->why || !(w->looked || w->dear))
        snprintf(to, AVERAGES_REFUSAL, "%s",
                 w->why ? w->why : "the run ended before its first look");
    else if (w->contradicted)
        snprintf(to, AVERAGES_REFUSAL,
                 "the motion does not go where the chain goes: ask for "
                 "events, or a longer time");
    else if (is_unfinished(w))
        come_round(to, w, gone);
    else if (w->dear)
        too_dear(to, w, gone);
    else if (!settled(w))
        unsettled(to, w, gone);
    else
        snprintf(to, AVERAGES_REFUSAL,
                 "two standard errors are %.2g after %s; %.2g would take "
                 "%.3g times as long, at a cost of %.3g s by the price "
                 "list",
                 w->error, gone, e, r * r, cost(w) * r * r);
}

/* Takes a closed form whose error is small enough. */
static bool take_closed(struct search *h)
{
    struct averages_found *f = h->f;
    for (size_t k = 0; k < f->candidates; ++k) {
        const struct averages_candidate *c = &f->candidate[k];
        if (c->sure == AVERAGES_OUT || !wanted(h, c->name) ||
            !(c->error <= h->q->tolerance))
            continue;
        f->taken = k;
        f->value = c->value;
        f->error = c->error;
        f->cost = c->cost;
        return true;
    }
    return false;
}

/* What the first look of a chain costs at least, s by the price list. */
static double first_look(const struct search *h)
{
    const bool slides = h->q->quantity.kind == AVERAGES_PRESSURE;
    const double n = (double)h->n;
    double work[MODELS_UNITS] = {0};
    work[MODELS_TRIAL] = 256 * n * n * (slides ? 5 : 1);
    return models_cost(work);
}

static void begin_ways(struct search *h, struct way way[2],
                       const struct averages_candidate *law)
{
    const bool lawful = law && wanted(h, law->name);
    const double e = h->q->tolerance;
    way[0] = (struct way){.name = "events",
                          .h = h,
                          .begin = begin_events,
                          .sample = sample_events};
    way[1] = (struct way){.name = "sampling",
                          .h = h,
                          .begin = begin_chain,
                          .sample = sample_chain,
                          .why = unsampled(h)};
    if (h->dimensions == 1 && h->q->quantity.kind == AVERAGES_PRESSURE)
        way[0].why = "on a line Tonks's law says more";
    if (law && h->dimensions == 2)
        way[1].why = "a chain cannot say how soon the motion mixes";
    way[1].least = first_look(h);
    if (never_mixes(h) && h->equal) {
        way[0].name = "instants";
        way[0].begin = begin_instants;
        way[0].sample = sample_instants;
    } else if (never_mixes(h))
        way[0].why = "two alone on a line may never forget: blocks do not "
                     "tell";
    for (int k = 0; k < 2; ++k) {
        compare_alike(&way[k]);
        way[k].columns =
            way[k].width + (k == 0 && h->dimensions == 2 && h->n > 1);
        way[k].goal = lawful ? fmax(0.01, e) : e;
        way[k].witness = k == 0 && !lawful && wanted(h, way[1].name) &&
                         !wanted(h, way[0].name);
        if (!wanted(h, way[k].name) && !(k == 0 && lawful) &&
            !way[k].witness)
            way[k].why = "another way was asked for";
    }
}

static void end_way(struct way *w, struct averages_found *f)
{
    for (size_t u = 0; u < MODELS_UNITS; ++u)
        f->work[u] += w->work[u];
    if (w->running)
        models_end(&w->run);
    if (w->begun && w->box.blocked)
        sampling_free(&w->box);
    free(w->point);
    blocks_free(&w->blocks);
}

/* Writes down what the winner has found. */
static void crown(struct search *h, const struct way *w,
                  const struct averages_candidate *law)
{
    struct averages_found *f = h->f;
    const bool by_law = !(holds(w) && wanted(h, w->name));
    f->taken = f->candidates;
    for (size_t k = 0; k < f->candidates; ++k)
        if (by_law ? &f->candidate[k] == law
                   : f->candidate[k].name == w->name)
            f->taken = k;
    const struct averages_candidate *c = &f->candidate[f->taken];
    f->value = c->value;
    f->error = c->error;
    f->cost = by_law ? 0 : cost(w);
    f->samples = w->samples;
    f->inefficiency = w->inefficiency;
    f->time = (double)w->run.rows * w->pace;
}

/* Notes what the events say of the law. */
static void judge(struct averages_candidate *law, const struct way *w)
{
    law->sure = borne_out(law, w, w->h) ? AVERAGES_ESTIMATE : AVERAGES_OUT;
    snprintf(law->text, AVERAGES_TEXT,
             agree(law, w, w->h)
                 ? "if it mixes in this time; events agree: %.2g off, "
                   "error %.2g"
                 : "if it mixes in this time; events do not bear it "
                   "out: %.2g off, error %.2g",
             w->looked
                 ? fabs(w->mean - law->value) / scale_of(w->h, law->value)
                 : NAN,
             w->looked ? w->error : NAN);
}

/* The way that speaks for all when none has won: the one that was asked
   for, the one that time has ended, or the cheaper one. */
static const struct way *speaker(const struct search *h,
                                 const struct way way[2])
{
    if (h->q->model)
        return &way[strcmp(h->q->model, "sampling") == 0];
    if (way[1].why || !way[0].dear)
        return &way[0];
    return &way[predicted(&way[1]) < predicted(&way[0])];
}

/* Takes samples, where no closed form will do. */
static bool take_samples(struct search *h)
{
    struct averages_candidate *law = NULL;
    struct way way[2], *winner = NULL;
    enter_order(h, &law);
    enter_two_disks(h, &law);
    begin_ways(h, way, law);
    bool well = blocks_create(&way[0].blocks, way[0].columns);
    well = blocks_create(&way[1].blocks, way[1].columns) && well;
    well = well && race(way, 2, law, &winner);
    if (well && law)
        judge(law, &way[0]);
    for (int k = 0; well && k < 2; ++k)
        report(&way[k], enter(h, way[k].name));
    h->f->taken = h->f->candidates;
    if (well && winner)
        crown(h, winner, law);
    else if (well)
        refuse(h, speaker(h, way));
    end_way(&way[0], h->f);
    end_way(&way[1], h->f);
    return well;
}

/* Says what steps would do, which are never taken: (11.6,
   eq:step-law-number). */
static void warn_of_steps(struct search *h)
{
    const double r = h->s->radius[0], dt = h->s->dt;
    if (h->q->quantity.kind != AVERAGES_PRESSURE || h->dimensions != 2 ||
        !h->alike || dt == 0 || r == 0 || h->f->taken == h->f->candidates)
        return;
    struct averages_candidate *c = enter(h, "steps");
    const double v = sqrt(2 * h->energy / h->mass);
    c->value = NAN;
    c->error = (h->f->value - 1) * v * dt / (2 * r) / h->f->scale;
    snprintf(c->text, AVERAGES_TEXT,
             "a bias of the first order, that no number of samples mends");
}

/* What the way that was asked for has to say for itself. */
static void explain_refusal(struct search *h)
{
    struct averages_found *f = h->f;
    const char *name = h->q->model;
    if (!name || strcmp(name, "events") == 0 ||
        strcmp(name, "sampling") == 0)
        return;
    snprintf(f->refusal, AVERAGES_REFUSAL,
             "'%.40s' is no way to this average of this scene; there are",
             name);
    for (size_t k = 0; k < f->candidates; ++k) {
        const struct averages_candidate *c = &f->candidate[k];
        const size_t used = strlen(f->refusal);
        snprintf(f->refusal + used, AVERAGES_REFUSAL - used, "%s %s",
                 k > 0 ? "," : "", c->name);
        if (strcmp(c->name, name) == 0) {
            snprintf(f->refusal, AVERAGES_REFUSAL, "%s: error %.2g; %s",
                     name, c->error, c->text);
            return;
        }
    }
}

static void explain_bound(struct search *h)
{
    struct averages_found *f = h->f;
    for (size_t k = 0; k < f->candidates; ++k) {
        const struct averages_candidate *c = &f->candidate[k];
        if (strcmp(c->name, "whole") == 0 && wanted(h, c->name)) {
            if (c->sure == AVERAGES_OUT)
                snprintf(f->refusal, AVERAGES_REFUSAL, "%s", c->text);
            else
                snprintf(f->refusal, AVERAGES_REFUSAL,
                         "%s: rounding decides where it goes; ask for "
                         "%.2g, or for a shorter time",
                         c->text, round_up(2 * c->error));
        } else if (c->sure == AVERAGES_BOUND && wanted(h, c->name))
            snprintf(f->refusal, AVERAGES_REFUSAL,
                     "a run of %.4g s may be off by %.2g from the law that "
                     "long runs obey; ask for that, or for %.4g s",
                     h->q->until, round_up(c->error),
                     round_up(c->error * h->q->until / h->q->tolerance));
    }
}

bool averages_find(struct averages_found *f,
                   const struct averages_request *q)
{
    struct search h = {.q = q, .f = f, .s = q->scene};
    bool well = true;
    *f = (struct averages_found){0};
    const char *why = survey(&h);
    if (why) {
        snprintf(f->refusal, AVERAGES_REFUSAL, "%s", why);
        return true;
    }
    take_conserved(&h);
    take_tonks(&h);
    take_springs(&h);
    take_whole(&h);
    if (!take_closed(&h)) {
        well = take_samples(&h);
        if (f->taken == f->candidates) {
            explain_refusal(&h);
            explain_bound(&h);
        }
    }
    f->scale = scale_of(&h, f->value);
    f->deciding = models_cost(f->work) - f->cost;
    warn_of_steps(&h);
    return well;
}
