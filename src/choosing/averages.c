/* Computes time averages from an exact law or from an event-driven run. */
#include "choosing/averages.h"

#include "box/blocks.h"
#include "choosing/models.h"
#include "line/statistics.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The name and symbol of each kind of quantity. They are empty for a
   position, whose name contains an axis and a body. */
static const struct {
    const char *name, *symbol;
} plain[] = {[AVERAGES_PRESSURE] = {"pressure", "Z"},
             [AVERAGES_PLACE] = {"", ""},
             [AVERAGES_KINETIC] = {"kinetic", "K"},
             [AVERAGES_TEMPERATURE] = {"temperature", "kT"}};

bool averages_read(struct averages_quantity *q, const char *name,
                   const struct scene *s, char message[AVERAGES_TEXT])
{
    for (unsigned k = 0; k < sizeof plain / sizeof plain[0]; ++k)
        if (*name && strcmp(name, plain[k].name) == 0) {
            *q = (struct averages_quantity){.kind = (enum averages_kind)k};
            return true;
        }
    char *end;
    /* strtoull accepts blanks and signs, so check for a digit first. */
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
    if (q->kind == AVERAGES_PLACE) {
        snprintf(symbol, 32, "%c:%zu", q->axis == 0 ? 'x' : 'y', q->body);
        return "length";
    }
    snprintf(symbol, 32, "%s", plain[q->kind].symbol);
    return q->kind == AVERAGES_PRESSURE ? "" : "mass length^2/time^2";
}

/* The request, the result, and the properties of the scene. */
struct search {
    const struct averages_request *q;
    struct averages_found *f;
    const struct scene *s;
    size_t n, axis, dimensions; /* number of bodies; first axis; number of
                                   axes */
    bool periodic;
    double box[2]; /* length of the box along each axis, m */
    double energy; /* kinetic energy, J; excludes the drift in a periodic
                      box */
    double mass;   /* total mass, kg */
    double radii;  /* sum of all radii, m */
    bool equal;    /* whether all masses are equal */
};

static double coordinate(const struct search *h, size_t i)
{
    return h->s->position[h->axis * h->n + i];
}

/* Returns twice the kinetic energy along an axis, J. In a periodic box the
   energy of the centre of mass is subtracted, as its uniform motion does
   not contribute to the pressure. */
static double energy_along(const struct search *h, size_t axis,
                           const double velocity[])
{
    const double *v = velocity + axis * h->n;
    double momentum = 0, sum = 0;
    for (size_t i = 0; i < h->n; ++i)
        momentum += h->s->mass[i] * v[i];
    const double drift = h->periodic ? momentum / h->mass : 0;
    for (size_t i = 0; i < h->n; ++i)
        sum += h->s->mass[i] * (v[i] - drift) * (v[i] - drift);
    return sum;
}

static void add_up(struct search *h)
{
    const struct scene *s = h->s;
    h->equal = true;
    for (size_t i = 0; i < h->n; ++i) {
        h->mass += s->mass[i];
        h->radii += s->radius[i];
        h->equal = h->equal && s->mass[i] == s->mass[0];
    }
    for (size_t d = 0; d < h->dimensions; ++d) {
        const size_t k = h->axis + d;
        h->box[d] = s->high[k] - s->low[k];
        h->energy += energy_along(h, k, s->velocity) / 2;
    }
}

/* Returns the mean position of a body at equilibrium, m. By symmetry, a
   disk between four walls is on average at the centre of the box. On a line
   all states are equally likely, so on average k/(n + 1) of the total gap
   length is to the left of the k-th of n bodies. To this are added the
   diameters of the bodies to its left and its own radius. */
static double settled_place(const struct search *h, size_t body)
{
    const size_t axis = h->q->quantity.axis;
    double shift = h->s->low[h->axis] + h->s->radius[body];
    size_t rank = 1;
    if (h->dimensions == 2)
        return (h->s->low[axis] + h->s->high[axis]) / 2;
    for (size_t i = 0; i < h->n; ++i)
        if (coordinate(h, i) < coordinate(h, body)) {
            shift += 2 * h->s->radius[i];
            ++rank;
        }
    return shift +
           (h->box[0] - 2 * h->radii) * (double)rank / (double)(h->n + 1);
}

/* Returns the number by which errors of the requested quantity are divided.
   `value` is the mean of the quantity. */
static double scale_of(const struct search *h, double value)
{
    const struct averages_quantity *q = &h->q->quantity;
    if (q->kind == AVERAGES_PRESSURE)
        return fabs(value) > 1 ? fabs(value) : 1;
    return q->kind == AVERAGES_PLACE ? h->box[q->axis - h->axis] : value;
}

/* Fills in *h from the scene. Returns NULL, or why the average cannot be
   computed.

   Scenes with forces, losses or fixed bodies are refused, since this file
   does not know their equilibria. A mean position is refused if it depends
   on the initial state however long the run is. This is the case for a
   single disk, for fewer than three bodies on a line, and for equal masses
   on a line, which only exchange their velocities. */
static const char *survey(struct search *h)
{
    const struct scene *s = h->s;
    const struct averages_quantity *q = &h->q->quantity;
    struct models_acts acts;
    models_analyse(&acts, s);
    if (acts.gravity || acts.springs || acts.weight || acts.friction ||
        !acts.contact)
        return "averages are known here of bodies that collide and feel "
               "no force";
    if (s->restitution != 1)
        return "each collision loses energy: the scene comes to rest, and "
               "to no equilibrium";
    if (acts.free < s->bodies)
        return "a body is held: averages are known of free ones";
    if (acts.dimensions < 1 || acts.axes > 3)
        return "averages are known of bodies that move on a line or in "
               "the plane of x and y";
    h->n = s->bodies;
    h->axis = acts.axes == 2;
    h->dimensions = acts.dimensions;
    const enum scene_wall *wall = s->wall + h->axis;
    h->periodic = wall[0] == SCENE_PERIODIC;
    for (size_t d = 0; d < h->dimensions; ++d)
        if (wall[d] == SCENE_OPEN || wall[d] != wall[0])
            return "the box is not closed: bodies leave for ever, or it "
                   "has walls along one axis only";
    if (h->periodic && h->dimensions == 1)
        return "a line without walls is no box";
    add_up(h);
    if (!(h->energy > 0))
        return "nothing moves";
    const bool place = q->kind == AVERAGES_PLACE;
    if (place && h->periodic)
        return "in a periodic box no place is the mean";
    if (place && (q->axis < h->axis || q->axis >= h->axis + h->dimensions))
        return "nothing moves along this axis";
    if (place && h->dimensions == 1 && h->equal)
        return "equal masses on a line only exchange their speeds: the "
               "mean place depends on the start for ever; ask for the "
               "rows of a run";
    if (place && h->n < 4 - h->dimensions)
        return "so few bodies need never forget how they began: the mean "
               "place depends on the start; ask for the rows of a run";
    return NULL;
}

/* Rounds x up to two significant digits, so that a number suggested in a
   refusal is large enough as printed. */
static double round_up(double x)
{
    const double unit = pow(10, floor(log10(x)) - 1);
    return ceil(x / unit) * unit;
}

/* Computes the answer from the total kinetic energy, which elastic contacts
   conserve. The total includes the drift and all three axes. */
static void answer_conserved(const struct search *h)
{
    struct averages_found *f = h->f;
    double energy = 0, free = 0;
    for (size_t i = 0; i < SCENE_AXES * h->n; ++i) {
        const double v = h->s->velocity[i];
        energy += h->s->mass[i % h->n] * v * v / 2;
        free += h->s->freedom[i];
    }
    /* The temperature excludes the energy of a drift. A difference within
       the rounding error of the sum does not count as a drift. */
    const bool drifts =
        h->periodic &&
        energy - h->energy > DBL_EPSILON * (double)h->n * energy;
    f->sure = AVERAGES_EXACT;
    f->value = h->q->quantity.kind == AVERAGES_KINETIC
                   ? energy
                   : 2 * (drifts ? h->energy : energy) / free;
    snprintf(f->text, AVERAGES_TEXT, "elastic contacts change neither");
}

/* Computes the answer from Tonks's law, with a proven bound on the
   deviation of a run from this law (12.16, eq:averages-bound). On a line
   NkT is 2K, so by the virial theorem Z is V divided by the total gap
   length. V is the length accessible to the centres: the box minus the
   radii of the two outer bodies. */
static void answer_tonks(const struct search *h)
{
    struct averages_found *f = h->f;
    const double free = h->box[0] - 2 * h->radii, *r = h->s->radius;
    size_t low = 0, high = 0;
    for (size_t i = 1; i < h->n; ++i) {
        low = coordinate(h, i) < coordinate(h, low) ? i : low;
        high = coordinate(h, i) > coordinate(h, high) ? i : high;
    }
    f->sure = AVERAGES_BOUND;
    f->value = (h->box[0] - r[low] - r[high]) / free;
    f->error = free * sqrt(h->mass / (2 * h->energy)) / h->q->until;
    snprintf(f->text, AVERAGES_TEXT,
             "free length %.6g; no run of this time is further off", free);
    if (f->error > h->q->tolerance)
        snprintf(f->refusal, AVERAGES_REFUSAL,
                 "a run of %.4g s may be off by %.2g from the law that "
                 "long runs obey; ask for that, or for %.4g s",
                 h->q->until, round_up(f->error),
                 round_up(f->error * h->q->until / h->q->tolerance));
}

/* Largest number of bodies whose mean positions are compared with their
   equilibrium values: the requested body and up to seven others. */
enum { WITNESSES = 8 };

/* An event-driven run, and the results of its last evaluation. */
struct measurement {
    const struct search *h;
    struct models_run run;
    struct blocks blocks;
    size_t columns, places, body[WITNESSES];
    double most, interval; /* number of samples in the averaging time; time
                              between samples, s */
    double virial;         /* virial up to the last sample, J s */
    bool over;             /* whether the run has ended */
    const char *why;       /* why the run is not at equilibrium, or NULL */
    double first;          /* mean of the first quarter */
    double mean, se;       /* mean of the other three quarters; its standard
                              error */
};

static double cost(const struct measurement *w)
{
    return models_cost(w->run.work);
}

/* Returns the number of samples in the averaging time T. It is at least
   256, to have enough blocks.

   A position is sampled only at an instant, so the interval between samples
   is short: a sixteenth of the flight time through the box. A pressure
   sample contains the virial of the whole interval, so its interval is a
   quarter of the flight time from one body to the next. */
static double samples_of(const struct search *h)
{
    const struct averages_quantity *q = &h->q->quantity;
    const double n = (double)h->n, T = h->q->until;
    const double kT = 2 * h->energy / ((double)h->dimensions * n);
    const bool place = q->kind == AVERAGES_PLACE;
    const double mass = place ? h->s->mass[q->body] : h->mass / n;
    const double way = place ? h->box[q->axis - h->axis] / 16
                             : sqrt(h->box[0] * h->box[1] / n) / 4;
    return fmax(256, ceil(T / way * sqrt(kT / mass)));
}

/* Selects the bodies whose mean positions are compared with their
   equilibrium values: first the requested body, then others. On a line
   these can be any bodies. In the plane they are disks of the same mass and
   radius, since these relax equally fast. */
static void choose_witnesses(struct measurement *w)
{
    const struct scene *s = w->h->s;
    const size_t body = w->h->q->quantity.body;
    if (w->h->q->quantity.kind != AVERAGES_PLACE)
        return;
    w->body[w->places++] = body;
    for (size_t i = 0; i < w->h->n && w->places < WITNESSES; ++i)
        if (i != body &&
            (w->h->dimensions == 1 || (s->mass[i] == s->mass[body] &&
                                       s->radius[i] == s->radius[body])))
            w->body[w->places++] = i;
}

/* Begins a run of bodies on a line or of disks in the plane. Returns NULL,
   or why it fails. A sample has a column for each position, or a single
   column for the pressure, and a last column for the result of
   `relaxation`. */
static const char *begin_measurement(struct measurement *w,
                                     const struct search *h)
{
    const struct models_plan plan = {
        .model = models_find(h->dimensions == 1 ? "line" : "disks")};
    const char *why = NULL;
    *w = (struct measurement){
        .h = h, .most = samples_of(h), .why = "no run"};
    choose_witnesses(w);
    w->columns = (w->places ? w->places : 1) + 1;
    w->interval = h->q->until / w->most;
    if (!blocks_create(&w->blocks, w->columns))
        return "no memory";
    if (!models_begin(&w->run, &plan, h->s, w->interval, &why))
        blocks_free(&w->blocks);
    w->run.limit = h->q->budget;
    return why;
}

/* Returns a number, computed from the velocities, whose mean is 1 at
   equilibrium, where all states of equal energy are equally likely.

   In the plane, half of the energy belongs to the motion along each axis.
   On a line, let e_i be the fraction of the energy that body i has. The
   square roots of all e_i are the coordinates of a random point on the unit
   sphere in n dimensions, so the mean of the sum of e_i^2 is 3/(n + 2). */
static double relaxation(const struct search *h, const double velocity[])
{
    double sum = 0;
    if (h->n == 1)
        return 1;
    if (h->dimensions == 2)
        return energy_along(h, h->axis, velocity) / h->energy;
    for (size_t i = 0; i < h->n; ++i) {
        const double v = velocity[h->axis * h->n + i];
        const double part = h->s->mass[i] * v * v / (2 * h->energy);
        sum += part * part;
    }
    return sum * (double)(h->n + 2) / 3;
}

/* Takes the next sample, and counts the work of advancing all bodies to
   its time. Returns false if the run ends. In a periodic box the motion of
   the centre of mass is excluded. At equilibrium this motion has the
   energy of one body, so the sum in (7.5, eq:virial) is multiplied by
   (N - 1)/N. */
static bool sample(struct measurement *w, double value[])
{
    const struct search *h = w->h;
    struct models_run *r = &w->run;
    const double n = (double)h->n, part = h->periodic ? (n - 1) / n : 1;
    const double *place = r->scene.position + h->q->quantity.axis * h->n;
    if (models_row(r) != MODELS_DONE)
        return false;
    r->work[MODELS_FLIGHT] += (double)(h->n * h->dimensions);
    value[0] =
        1 + part * (r->virial - w->virial) / (2 * h->energy * w->interval);
    w->virial = r->virial;
    for (size_t k = 0; k < w->places; ++k)
        value[k] = place[w->body[k]];
    value[w->columns - 1] = relaxation(h, r->scene.velocity);
    return true;
}

/* Fills x with the means of a column in the blocks `from` to `to` - 1, and
   returns their average. */
static struct blocks_average part(const struct measurement *w,
                                  size_t column, size_t from, size_t to,
                                  double x[])
{
    const double *sum = w->blocks.sum + column;
    for (size_t i = from; i < to; ++i)
        x[i - from] = sum[i * w->columns] / (double)w->blocks.per;
    return blocks_average_of(to - from, x);
}

/* Returns how far mean positions are from their equilibrium values, m: the
   deviation of the requested body or, if larger, the root mean square over
   all selected bodies. The deviation of a single body may be small by
   chance. */
static double distance_from_law(const struct measurement *w, size_t from)
{
    double x[BLOCKS_MOST] = {0}, squares = 0, own = 0;
    for (size_t k = 0; k < w->places; ++k) {
        const double off = part(w, k, from, w->blocks.count, x).mean -
                           settled_place(w->h, w->body[k]);
        own = k == 0 ? fabs(off) : own;
        squares += off * off / (double)w->places;
    }
    return fmax(own, sqrt(squares));
}

/* Returns whether the velocities have relaxed, or false if memory runs out.
   The mean of `relaxation` must be 1 within its error. On a line a heavy
   body relaxes very slowly, so the block estimate of this error must also
   have a plateau. */
static bool has_relaxed(const struct measurement *w, size_t from)
{
    struct statistics_blocking b;
    double x[BLOCKS_MOST] = {0};
    const size_t n = w->blocks.count, last = w->columns - 1;
    const double off = part(w, last, from, n, x).mean - 1;
    return statistics_blocking(n - from, x, &b) &&
           (b.plateau || w->h->dimensions == 2) &&
           fabs(off) <= 5 * b.error + 1e-9;
}

/* Evaluates the last three quarters of the run; the first quarter still
   depends on the start. Returns false if memory runs out.

   The error is reliable if its block estimate has a plateau, the mean does
   not drift, and positions and velocities are at equilibrium. Twice the
   uncertainty of the block estimate is added to the error. Without this, a
   run would tend to stop when the estimate is too small by chance. */
static bool judge(struct measurement *w)
{
    const size_t n = w->blocks.count, from = (n + 3) / 4;
    struct statistics_blocking b;
    double x[BLOCKS_MOST] = {0};
    if (n < 64)
        return true;
    w->first = part(w, 0, 0, from, x).mean;
    const struct blocks_average a = part(w, 0, from, n, x);
    if (!statistics_blocking(n - from, x, &b))
        return false;
    w->mean = a.mean;
    const double off = distance_from_law(w, from);
    const double se = b.error + 2 * b.level[b.chosen].uncertainty;
    w->se = fmax(se, off);
    w->why = off > 3 * se ? "bodies are far from where they end up"
             : !b.plateau ? "long blocks still remember each other"
             : a.drift > BLOCKS_STEADY ? "the mean still drifts"
             : !has_relaxed(w, from) ? "velocities still remember the start"
                                     : NULL;
    return true;
}

/* Returns the simulated fraction of the averaging time T. */
static double fraction_run(const struct measurement *w)
{
    return (double)(w->blocks.count * w->blocks.per) / w->most;
}

/* Computes the mean over the averaging time T and its error (12.14,
   eq:averages-over). */
static void conclude(struct averages_found *f, const struct measurement *w)
{
    const double s = fraction_run(w), q = s / 4;
    const double square = (1 - q) * (1 - q) + 3 * q * q + 0.75 * s;
    f->value = q * w->first + (1 - q) * w->mean;
    f->error = 2 * w->se * sqrt(square) / scale_of(w->h, f->value);
}

/* Returns the factor by which the run must become longer to reach the error
   e.

   Even a run of length T has an error, since the mean over T varies from
   run to run. If the square of this error is more than half of e^2, T is
   too short and the result is INFINITY. For a run that is not at
   equilibrium the result is finite and at least 2. */
static double longer_by(const struct measurement *w, double e)
{
    const double two = 2 * w->se / scale_of(w->h, w->mean);
    const double square = two * two,
                 scatter = 0.75 * fraction_run(w) * square;
    if (w->why)
        return fmax(2, square / (e * e));
    return e * e < 2 * scatter ? INFINITY
                               : fmax(1.25, square / (e * e - scatter));
}

/* Continues the run up to `to` samples, or to the end of T or of the
   budget, and evaluates it. Returns false if memory runs out. */
static bool advance(struct measurement *w, double to)
{
    double value[WITNESSES + 1];
    while (!w->over && (double)w->run.rows < fmin(to, w->most)) {
        w->over = cost(w) > w->h->q->budget || !sample(w, value);
        if (!w->over)
            blocks_add(&w->blocks, value);
    }
    w->over = w->over || (double)w->run.rows >= w->most;
    return judge(w);
}

/* Continues the run until the error is small enough, or until it is clear
   that the budget does not suffice. Returns false if memory runs out.

   A run that is not at equilibrium is extended to twice its length. A run
   at equilibrium is extended to the predicted length, so that few
   evaluations are needed. Predicted costs are rough and errors are
   overestimated. So a run at equilibrium continues even if its predicted
   cost is up to 1.5 times the budget, and no run is given up before it has
   cost a two-hundredth of the budget. */
static bool go_on_until_sure(struct averages_found *f,
                             struct measurement *w)
{
    const double e = w->h->q->tolerance, reason = w->h->q->budget;
    for (double to = 256, longer; !w->over;
         to = (double)w->run.rows * (w->why ? 2 : longer)) {
        if (!advance(w, to))
            return false;
        conclude(f, w);
        if (!w->why && f->error <= e) {
            f->sure = AVERAGES_ESTIMATE;
            return true;
        }
        longer = longer_by(w, e);
        if (!(cost(w) * longer <= (w->why ? 1 : 1.5) * reason)) {
            if (2 * cost(w) > reason / 100)
                return true;
            longer = 2;
        }
    }
    return true;
}

/* Writes why a run at equilibrium gives no answer. If `brief`, T is too
   short; if not, the run is too expensive. Suggests the smallest error
   that T and the budget allow. As predicted costs are rough, the
   suggestion leaves a safety factor of three in cost. */
static void refuse_settled(char *to, const struct measurement *w,
                           double price, bool brief)
{
    const struct averages_request *q = w->h->q;
    const double two = 2 * w->se / scale_of(w->h, w->mean);
    const double least = 1.2 * two * sqrt(1.5 * fraction_run(w));
    const double paid = two * sqrt(3 * cost(w) / q->budget);
    const double fits = round_up(fmax(least, paid)), e = q->tolerance;
    const int n =
        brief ? snprintf(to, AVERAGES_REFUSAL,
                         "the mean over %.4g s may be off by more than "
                         "%.2g, that over %.2g s need not",
                         q->until, e, q->until * pow(least / e, 2))
              : snprintf(to, AVERAGES_REFUSAL,
                         "%.2g would cost about %.2g s by the price list, "
                         "of %.3g that are reasonable",
                         e, price, q->budget);
    snprintf(to + n, AVERAGES_REFUSAL - (size_t)n,
             fits < 0.25 ? "; %.2g fits" : "; no tolerance fits", fits);
}

/* Writes why an event-driven run gives no answer. A run that is not at
   equilibrium may never reach it, and its mean depends on the start, so the
   message suggests requesting the rows of a run instead. */
static void refuse(char *to, const struct measurement *w)
{
    const struct averages_request *q = w->h->q;
    const bool over = (double)w->run.rows >= w->most;
    const double price = cost(w) * longer_by(w, q->tolerance);
    char more[AVERAGES_TEXT] =
        "ask for a longer time, or for the rows of a run";
    if (!w->why) {
        refuse_settled(to, w, price, over || isinf(price));
        return;
    }
    if (!over)
        snprintf(more, sizeof more,
                 "to go on costs at least %.2g s by the price list, of "
                 "%.3g that are reasonable",
                 price, q->budget);
    snprintf(to, AVERAGES_REFUSAL, "it does not settle in %.4g s: %s; %s",
             (double)w->run.rows * w->interval, w->why, more);
}

/* Computes the answer from an event-driven run. Returns false if memory
   runs out. */
static bool measure(const struct search *h)
{
    struct averages_found *f = h->f;
    struct measurement w;
    const char *why = begin_measurement(&w, h);
    if (why) {
        snprintf(f->refusal, AVERAGES_REFUSAL, "%s", why);
        return true;
    }
    const bool well = go_on_until_sure(f, &w);
    if (well && f->sure == AVERAGES_OUT)
        refuse(f->refusal, &w);
    f->time = (double)w.run.rows * w.interval;
    f->cost = cost(&w);
    snprintf(f->text, AVERAGES_TEXT, "%.4g s by events%s%s", f->time,
             w.why ? ": " : "", w.why ? w.why : "");
    models_end(&w.run);
    blocks_free(&w.blocks);
    return well;
}

/* Computes the answer by the method that suits the quantity and the scene.
   Writes a refusal if another method was requested by name. Returns false
   if memory runs out. */
static bool answer(const struct search *h)
{
    const enum averages_kind kind = h->q->quantity.kind;
    const bool tonks = kind == AVERAGES_PRESSURE && h->dimensions == 1;
    const bool run = kind == AVERAGES_PLACE ||
                     (kind == AVERAGES_PRESSURE && h->dimensions == 2);
    const char *way = run ? "events" : tonks ? "tonks" : "conserved";
    h->f->way = way;
    if (h->q->model && strcmp(h->q->model, way) != 0) {
        snprintf(h->f->refusal, AVERAGES_REFUSAL,
                 "'%.40s' is no way to this average of this scene; %s is",
                 h->q->model, way);
        return true;
    }
    if (run)
        return measure(h);
    (tonks ? answer_tonks : answer_conserved)(h);
    return true;
}

bool averages_find(struct averages_found *f,
                   const struct averages_request *q)
{
    struct search h = {.q = q, .f = f, .s = q->scene};
    bool well = true;
    *f = (struct averages_found){.sure = AVERAGES_OUT};
    const char *why = survey(&h);
    if (why)
        snprintf(f->refusal, AVERAGES_REFUSAL, "%s", why);
    else
        well = answer(&h);
    f->sure = f->refusal[0] ? AVERAGES_OUT : f->sure;
    f->scale = why ? 1 : scale_of(&h, f->value);
    return well;
}
