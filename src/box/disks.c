/* From chapters/05-disks.nw: edit there, then run make tangle. */
/* checksum 591289763 of the lines below */
/* Event-driven motion: every pair looked at, or a plan remembered. */
#include "box/disks.h"

#include "line/collide.h"
#include "line/fall.h"
#include "toolbox/vector.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct disks_plan {
    double leash;              /* m */
    struct disks_event *event; /* of each disk */
    uint32_t *hits;            /* of the partner, when it was planned */
    double *time;              /* for answers */
};

bool disks_create(struct disks *d, size_t dimensions, size_t count)
{
    const size_t bytes = count * sizeof *d->disk;
    *d = (struct disks){
        .dimensions = dimensions, .count = count, .restitution = 1};
    d->disk = aligned_alloc(sizeof *d->disk, bytes);
    d->mass = malloc(count * sizeof *d->mass);
    d->hits = calloc(count, sizeof *d->hits);
    if (!d->disk || !d->mass || !d->hits) {
        disks_free(d);
        return false;
    }
    memset(d->disk, 0, bytes);
    for (size_t i = 0; i < count; ++i)
        d->mass[i] = 1;
    return true;
}

void disks_free(struct disks *d)
{
    if (d->plan) {
        free(d->plan->event);
        free(d->plan->hits);
        free(d->plan->time);
    }
    free(d->plan);
    free(d->disk);
    free(d->mass);
    free(d->hits);
    *d = (struct disks){0};
}

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double disks_wall_time(double x, double v, double radius, double length)
{
    const double way = v > 0 ? length - radius - x : radius - x;
    if (v == 0)
        return INFINITY;
    return way / v > 0 ? way / v : 0;
}

double disks_pair_time(const double apart[], const double closing[],
                       double distance)
{
    const double b = dot(apart, closing);
    const double c = dot(apart, apart) - distance * distance;
    const double disc = b * b - dot(closing, closing) * c;
    if (b >= 0 || disc < 0)
        return INFINITY;
    return c <= 0 ? 0 : c / (sqrt(disc) - b);
}

/* What gravity adds in a while to a place and a velocity, or NULL (5.12,
   eq:fall). */
static void fall(const struct disks *d, double wait, double place[],
                 double velocity[])
{
    place[1] -= d->gravity * wait / 2 * wait;
    if (velocity)
        velocity[1] -= d->gravity * wait;
}

/* The same for the way from a to b and its rate of change at the later of
   their times. */
static void fall_between(const struct disks *d, const struct disk *a,
                         const struct disk *b, double apart[],
                         double closing[])
{
    const double ahead = b->since - a->since, wait = fabs(ahead);
    const double lag = ahead > 0 ? d->gravity * wait : -d->gravity * wait;
    closing[1] += lag;
    apart[1] += lag / 2 * wait;
}

static double to_roof(const struct disks *d, const struct disk *a)
{
    return fall_to_roof(d->box[1] - a->radius - a->position[1],
                        a->velocity[1], d->gravity);
}

/* When disk a is at the floor or at the roof, from its last collision. */
static double floor_or_roof(const struct disks *d, const struct disk *a)
{
    return fmin(to_roof(d, a), fall_to_floor(a->position[1] - a->radius,
                                             a->velocity[1], d->gravity));
}

/* Moves disk a to the floor or the roof, where it is now. */
static void land(const struct disks *d, struct disk *a)
{
    const bool roof = to_roof(d, a) < INFINITY;
    const double y = roof ? d->box[1] - a->radius : a->radius;
    const double speed =
        fall_speed(a->position[1] - y, a->velocity[1], d->gravity);
    for (size_t k = 0; k < DISKS_AXES; ++k)
        a->position[k] += a->velocity[k] * (d->now - a->since);
    a->position[1] = y;
    a->velocity[1] = roof ? speed : -speed;
    a->since = d->now;
}

static double energy_of_heights(const struct disks *d)
{
    double energy = 0;
    for (size_t i = 0; i < d->count; ++i)
        energy += d->mass[i] * d->gravity *
                  (d->disk[i].position[1] - d->disk[i].radius);
    return energy;
}

/* The whole number nearest to x, for |x| < 2^51. */
static double whole(double x)
{
    const double shift = 6755399441055744; /* 1.5 * 2^52 */
    return x + shift - shift;
}

bool disks_wraps(const struct disks *d, size_t k)
{
    return k < d->dimensions && d->box[k] > 0 &&
           (d->boundary == DISKS_PERIODIC ||
            (d->boundary == DISKS_FLOOR && k != 1));
}

bool disks_walled(const struct disks *d, size_t k)
{
    return d->box[k] > 0 && (d->boundary == DISKS_WALLS ||
                             (d->boundary == DISKS_FLOOR && k == 1));
}

static double inverse(const struct disks *d, size_t k)
{
    return disks_wraps(d, k) ? 1 / d->box[k] : 0;
}

void disks_apart(const struct disks *d, const double a[], const double b[],
                 double apart[])
{
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        apart[k] = b[k] - a[k];
        apart[k] -= d->box[k] * whole(apart[k] * inverse(d, k));
    }
}

double disks_leash(const struct disks *d)
{
    double least = INFINITY, widest = 0;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_wraps(d, k))
            least = fmin(least, d->box[k]);
    for (size_t i = 0; i < d->count; ++i)
        widest = fmax(widest, d->disk[i].radius);
    const double spare = least / 2 - 2 * widest;
    return least == INFINITY       ? INFINITY
           : spare >= 1e-6 * least ? 0.999 * spare / 3
                                   : 0;
}

double disks_meeting(const struct disks *d, size_t i, size_t j, double at)
{
    const struct disk *a = &d->disk[i], *b = &d->disk[j];
    const double last = a->since > b->since ? a->since : b->since;
    const double wait = at - last;
    double apart[DISKS_AXES], closing[DISKS_AXES];
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        closing[k] = b->velocity[k] - a->velocity[k];
        apart[k] = (b->position[k] + b->velocity[k] * (last - b->since)) -
                   (a->position[k] + a->velocity[k] * (last - a->since));
        if (d->boundary != DISKS_WALLS) {
            const double then = apart[k] + closing[k] * wait;
            apart[k] -= d->box[k] * whole(then * inverse(d, k));
        }
    }
    if (d->gravity > 0)
        fall_between(d, a, b, apart, closing);
    return last + disks_pair_time(apart, closing, a->radius + b->radius);
}

/* How long disk a has flown when it meets its next wall, between walls
   and without gravity. */
static double wall_of_either(const struct disks *d, const struct disk *a,
                             size_t *axis)
{
    double first = INFINITY;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double x = a->position[k], v = a->velocity[k], r = a->radius;
        const double way[] = {r - x, d->box[k] - r - x};
        const double flight = way[v > 0] / v;
        const double time = flight > 0 ? flight : 0;
        if (v == 0 || d->box[k] == 0)
            continue;
        *axis = time < first ? k : *axis;
        first = time < first ? time : first;
    }
    return first;
}

double disks_wall(const struct disks *d, size_t i, size_t *axis)
{
    const struct disk *a = &d->disk[i];
    double first = INFINITY;
    *axis = 0;
    if (d->boundary == DISKS_PERIODIC)
        return first;
    if (d->boundary == DISKS_WALLS && !(d->gravity > 0))
        return a->since + wall_of_either(d, a, axis);
    for (size_t k = 0; k < d->dimensions; ++k) {
        if (!disks_walled(d, k))
            continue;
        const double time =
            d->gravity > 0 && k == 1
                ? floor_or_roof(d, a)
                : disks_wall_time(a->position[k], a->velocity[k], a->radius,
                                  d->box[k]);
        if (time < first) {
            first = time;
            *axis = k;
        }
    }
    return a->since + first;
}

static uint32_t low(struct disks_event e)
{
    return e.disk < e.partner ? e.disk : e.partner;
}

static uint32_t high(struct disks_event e)
{
    return e.disk < e.partner ? e.partner : e.disk;
}

bool disks_before(struct disks_event a, struct disks_event b)
{
    if (a.time != b.time)
        return a.time < b.time;
    if (low(a) != low(b))
        return low(a) < low(b);
    return high(a) < high(b);
}

static struct disks_event meet(size_t i, size_t j, double time)
{
    return (struct disks_event){time, (uint32_t)i, (uint32_t)j};
}

/* The first of what disk i does without another: it meets a wall, or has
   flown as far as the leash. */
static struct disks_event alone(const struct disks *d, size_t i,
                                double leash)
{
    const double *v = d->disk[i].velocity;
    size_t axis;
    double vv = 0;
    const double time = disks_wall(d, i, &axis);
    const struct disks_event wall = meet(i, d->count + axis, time);
    if (leash == INFINITY)
        return wall;
    for (size_t k = 0; k < d->dimensions; ++k)
        vv += disks_wraps(d, k) ? v[k] * v[k] : 0;
    const struct disks_event look = meet(i, i, d->now + leash / sqrt(vv));
    return look.time < time ? look : wall;
}

struct disks_event disks_next(const struct disks *d)
{
    const double leash = disks_leash(d);
    struct disks_event first = alone(d, 0, leash);
    for (size_t i = 0; i < d->count; ++i) {
        const struct disks_event own = alone(d, i, leash);
        if (disks_before(own, first))
            first = own;
        for (size_t j = i + 1; j < d->count; ++j) {
            const struct disks_event pair =
                meet(i, j, disks_meeting(d, i, j, d->now));
            if (disks_before(pair, first))
                first = pair;
        }
    }
    return first;
}

static void move_to(const struct disks *d, struct disk *a, double time)
{
    for (size_t k = 0; k < DISKS_AXES; ++k)
        a->position[k] += a->velocity[k] * (time - a->since);
    if (d->gravity > 0)
        fall(d, time - a->since, a->position, a->velocity);
    a->since = time;
}

static void meet_wall(struct disks *d, size_t i, size_t k)
{
    struct disk *a = &d->disk[i];
    if (d->gravity > 0 && k == 1)
        land(d, a);
    else
        move_to(d, a, d->now);
    const double v = a->velocity[k];
    ++d->hits[i];
    a->velocity[k] = -d->restitution * v;
    d->impulse[k] += d->mass[i] * fabs(v - a->velocity[k]);
    ++d->wall_collisions;
}

static void meet_disk(struct disks *d, size_t i, size_t j)
{
    struct disk *a = &d->disk[i], *b = &d->disk[j];
    double normal[DISKS_AXES], before[DISKS_AXES], moved = 0;
    move_to(d, a, d->now);
    move_to(d, b, d->now);
    ++d->hits[i];
    ++d->hits[j];
    disks_apart(d, a->position, b->position, normal);
    memcpy(before, a->velocity, sizeof before);
    collide_along(DISKS_AXES, normal, a->velocity, b->velocity,
                  1 / d->mass[i], 1 / d->mass[j], d->restitution);
    for (size_t k = 0; k < DISKS_AXES; ++k)
        moved += (before[k] - a->velocity[k]) * normal[k];
    d->virial += d->mass[i] * moved;
    ++d->collisions;
}

void disks_collide(struct disks *d, struct disks_event e)
{
    const double now = e.time > d->now ? e.time : d->now;
    d->standing = now > d->now ? 0 : d->standing + 1;
    d->now = now;
    if (e.partner >= d->count)
        meet_wall(d, e.disk, e.partner - d->count);
    else if (e.partner != e.disk)
        meet_disk(d, low(e), high(e));
}

static inline void meet_all(const struct disks *d, size_t i, double *time,
                            bool round)
{
    const struct disk a = d->disk[i];
    const double sides[] = {inverse(d, 0), inverse(d, 1), inverse(d, 2)};
    for (size_t j = 0; j < d->count; ++j) {
        const struct disk *b = &d->disk[j];
        const double last = a.since > b->since ? a.since : b->since;
        double apart[DISKS_AXES], closing[DISKS_AXES];
        for (size_t k = 0; k < DISKS_AXES; ++k) {
            closing[k] = b->velocity[k] - a.velocity[k];
            apart[k] =
                (b->position[k] + b->velocity[k] * (last - b->since)) -
                (a.position[k] + a.velocity[k] * (last - a.since));
            if (round) {
                const double then = apart[k] + closing[k] * (d->now - last);
                apart[k] -= d->box[k] * whole(then * sides[k]);
            }
        }
        const double distance = a.radius + b->radius;
        const double rate = dot(apart, closing);
        const double gap = dot(apart, apart) - distance * distance;
        const double disc = rate * rate - dot(closing, closing) * gap;
        const double root = sqrt(disc > 0 ? disc : 0);
        const double flight = gap / (root - rate);
        const double met = last + (gap > 0 ? flight : 0);
        time[j] = ((rate < 0) & (disc >= 0)) ? met : INFINITY;
    }
}

VECTOR_LOOP static void meet_all_walls(const struct disks *d, size_t i,
                                       double *restrict time)
{
    meet_all(d, i, time, false);
}

VECTOR_LOOP static void meet_all_round(const struct disks *d, size_t i,
                                       double *restrict time)
{
    meet_all(d, i, time, true);
}

/* time[j]: when disk i meets disk j, for all j but i, as seen now. */
static void meetings(const struct disks *d, size_t i, double time[])
{
    if (d->boundary == DISKS_WALLS && !(d->gravity > 0))
        meet_all_walls(d, i, time);
    else if (!(d->gravity > 0))
        meet_all_round(d, i, time);
    else
        for (size_t j = 0; j < d->count; ++j)
            time[j] = disks_meeting(d, i, j, d->now);
}

/* The smallest of n times, and whose it is: *first, n if all are
   INFINITY. */
static double soonest(const double time[], size_t n, size_t *first)
{
    double least = INFINITY;
    *first = n;
    for (size_t j = 0; j < n; ++j) {
        *first = time[j] < least ? j : *first;
        least = time[j] < least ? time[j] : least;
    }
    return least;
}

/* Plans what disk i does next as seen at d->now. */
static void plan_disk(struct disks *d, size_t i)
{
    struct disks_plan *p = d->plan;
    struct disks_event first = alone(d, i, p->leash);
    meetings(d, i, p->time);
    p->time[i] = INFINITY;
    size_t j;
    const double time = soonest(p->time, d->count, &j);
    const struct disks_event pair = meet(i, j, time);
    if (disks_before(pair, first))
        first = pair;
    p->event[i] = first;
    p->hits[i] = first.partner < d->count ? d->hits[first.partner] : 0;
}

bool disks_plan(struct disks *d)
{
    if (!d->plan && !(d->plan = calloc(1, sizeof *d->plan)))
        return false;
    struct disks_plan *p = d->plan;
    if (!p->event)
        p->event = malloc(d->count * sizeof *p->event);
    if (!p->hits)
        p->hits = malloc(d->count * sizeof *p->hits);
    if (!p->time)
        p->time = malloc(d->count * sizeof *p->time);
    if (!p->event || !p->hits || !p->time)
        return false;
    p->leash = disks_leash(d);
    assert(p->leash > 0);
    for (size_t i = 0; i < d->count; ++i)
        plan_disk(d, i);
    return true;
}

static struct disks_event earliest(const struct disks *d)
{
    const struct disks_event *event = d->plan->event;
    double time = event[0].time;
    size_t first = 0, ties = 0;
    for (size_t i = 1; i < d->count; ++i) {
        const double t = event[i].time;
        ties += t == time;
        first = t < time ? i : first;
        time = t < time ? t : time;
    }
    for (size_t i = first + 1; ties > 0 && i < d->count; ++i)
        if (event[i].time == time && disks_before(event[i], event[first]))
            first = i;
    return event[first];
}

static bool still_true(const struct disks *d, struct disks_event e)
{
    return e.partner >= d->count ||
           (e.partner != e.disk &&
            d->plan->hits[e.disk] == d->hits[e.partner]);
}

enum disks_stop disks_run(struct disks *d, double until,
                          uint64_t collisions)
{
    while (d->collisions < collisions) {
        const struct disks_event e = earliest(d);
        if (e.time > until || e.time == INFINITY) {
            if (until < INFINITY)
                d->now = fmax(d->now, until);
            return DISKS_TIME;
        }
        if (still_true(d, e)) {
            disks_collide(d, e);
            if (disks_over(d, e.disk))
                return DISKS_COLLAPSE;
            if (e.partner < d->count)
                plan_disk(d, e.partner);
        } else
            d->now = fmax(d->now, e.time);
        plan_disk(d, e.disk);
    }
    return DISKS_COLLISIONS;
}

bool disks_collapsed(const struct disks *d)
{
    return d->standing > 1000 + 10 * d->count;
}

static double square_of_speed(const struct disk *a)
{
    return dot(a->velocity, a->velocity);
}

bool disks_cold(const struct disks *d)
{
    double widest = 0;
    bool moves = false;
    for (size_t i = 0; i < d->count; ++i)
        widest = fmax(widest, d->disk[i].radius);
    for (size_t i = 0; i < d->count; ++i) {
        const struct disk *a = &d->disk[i];
        const double scale =
            fmin(widest > 0 ? widest * widest : 1, d->mass[i]);
        if (square_of_speed(a) * fmin(1, scale) >= 0x1p-900)
            return false;
        for (size_t k = 0; k < d->dimensions; ++k)
            moves = moves || a->velocity[k] != 0;
    }
    return moves && !(d->gravity > 0);
}

/* The same, asked after each collision, of disk i: nearly always in no
   time, since it is fast itself. Only what loses energy gets cold. */
static bool may_be_cold(const struct disks *d, size_t i)
{
    return d->restitution < 1 && square_of_speed(&d->disk[i]) < 1e-100 &&
           disks_cold(d);
}

bool disks_over(const struct disks *d, size_t i)
{
    return disks_collapsed(d) || may_be_cold(d, i);
}

void disks_position(const struct disks *d, size_t i, double place[])
{
    const struct disk *a = &d->disk[i];
    for (size_t k = 0; k < DISKS_AXES; ++k)
        place[k] = a->position[k] + a->velocity[k] * (d->now - a->since);
    if (d->gravity > 0)
        fall(d, d->now - a->since, place, NULL);
}

void disks_fold(const struct disks *d, double place[])
{
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_wraps(d, k)) {
            place[k] -= d->box[k] * floor(place[k] / d->box[k]);
            if (place[k] >= d->box[k])
                place[k] = 0;
        }
}

void disks_velocity(const struct disks *d, size_t i, double velocity[])
{
    const struct disk *a = &d->disk[i];
    for (size_t k = 0; k < DISKS_AXES; ++k)
        velocity[k] = a->velocity[k];
    if (d->gravity > 0)
        velocity[1] -= d->gravity * (d->now - a->since);
}

size_t disks_lying(const struct disks *d)
{
    for (size_t i = 0; i < d->count && d->gravity > 0; ++i) {
        double place[DISKS_AXES], velocity[DISKS_AXES];
        disks_position(d, i, place);
        disks_velocity(d, i, velocity);
        const double flight = 2 * fabs(velocity[1]) / d->gravity;
        const double high = place[1] - d->disk[i].radius;
        if (high <= 4 * DBL_EPSILON * d->box[1] &&
            flight <= 4 * DBL_EPSILON * d->now)
            return i;
    }
    return d->count;
}

static double kinetic(const struct disks *d)
{
    double energy = 0;
    for (size_t i = 0; i < d->count; ++i)
        energy +=
            d->mass[i] * dot(d->disk[i].velocity, d->disk[i].velocity) / 2;
    return energy;
}

double disks_energy(const struct disks *d)
{
    return d->gravity > 0 ? kinetic(d) + energy_of_heights(d) : kinetic(d);
}

void disks_drift(const struct disks *d, double drift[])
{
    double mass = 0, square = 0;
    for (size_t i = 0; i < d->count; ++i)
        mass += d->mass[i];
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        /* Seen from one of them: no rounding where all fly alike. */
        const double seen = d->disk[0].velocity[k];
        double sum = 0;
        for (size_t i = 0; i < d->count && disks_wraps(d, k); ++i)
            sum += d->mass[i] * (d->disk[i].velocity[k] - seen);
        drift[k] = disks_wraps(d, k) ? seen + sum / mass : 0;
        square += drift[k] * drift[k];
    }
    if (mass * square / 2 <= DBL_EPSILON / 2 * kinetic(d))
        drift[0] = drift[1] = drift[2] = 0;
}

double disks_heat(const struct disks *d)
{
    double drift[DISKS_AXES], heat = 0;
    disks_drift(d, drift);
    if (drift[0] == 0 && drift[1] == 0 && drift[2] == 0)
        return disks_energy(d);
    for (size_t i = 0; i < d->count; ++i) {
        double v[DISKS_AXES];
        for (size_t k = 0; k < DISKS_AXES; ++k)
            v[k] = d->disk[i].velocity[k] - drift[k];
        heat += d->mass[i] * dot(v, v) / 2;
    }
    return d->gravity > 0 ? heat + energy_of_heights(d) : heat;
}

double disks_temperature(const struct disks *d)
{
    size_t free = (d->dimensions + (d->gravity > 0 ? 2 : 0)) * d->count;
    for (size_t k = 0; k < d->dimensions; ++k)
        free -= disks_wraps(d, k);
    return free > 0 ? 2 * disks_heat(d) / (double)free : 0;
}

double disks_packing(const struct disks *d)
{
    const double pi = 3.14159265358979324;
    double filled = 0, box = 1;
    for (size_t k = 0; k < d->dimensions; ++k)
        box *= d->box[k];
    for (size_t i = 0; i < d->count; ++i) {
        const double r = d->disk[i].radius;
        filled += d->dimensions == 2 ? pi * r * r : pi * r * r * r * 4 / 3;
    }
    return filled / box;
}

static bool within_walls(const struct disks *d, const double place[],
                         double r)
{
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_walled(d, k) && !(place[k] >= r - 1e-9 * d->box[k] &&
                                    place[k] <= d->box[k] * (1 + 1e-9) - r))
            return false;
    return true;
}

bool disks_clash(const struct disks *d, size_t a, size_t b)
{
    double here[DISKS_AXES], there[DISKS_AXES], apart[DISKS_AXES];
    const double r = d->disk[a].radius;
    disks_position(d, a, here);
    if (b == d->count)
        return !within_walls(d, here, r);
    const double least = (r + d->disk[b].radius) * (1 - 1e-9);
    disks_position(d, b, there);
    disks_apart(d, here, there, apart);
    return !(dot(apart, apart) >= least * least);
}

bool disks_fit(const struct disks *d, size_t *a, size_t *b)
{
    for (*a = 0; *a < d->count; ++*a) {
        *b = d->count;
        if (disks_clash(d, *a, *b))
            return false;
        for (*b = *a + 1; *b < d->count; ++*b)
            if (disks_clash(d, *a, *b))
                return false;
    }
    return true;
}

struct lattice {
    size_t cells[DISKS_AXES], basis;
    double from[DISKS_AXES], step[DISKS_AXES], nearest;
};

/* Sites of a cell, in its widths. */
static const double sites[4][DISKS_AXES] = {
    {0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};

static double nearest_site(const struct lattice *l, size_t dimensions)
{
    double least = INFINITY;
    for (size_t k = 0; k < dimensions; ++k)
        if (l->cells[k] > 1)
            least = fmin(least, l->step[k] * l->step[k]);
    for (size_t s = 1; s < l->basis; ++s) {
        double square = 0;
        for (size_t k = 0; k < dimensions; ++k) {
            const double x = sites[s][k] * l->step[k];
            square += x * x;
        }
        least = fmin(least, square);
    }
    return sqrt(least);
}

/* Stretches the lattice over the box, for disks of radius r. */
static void stretch(const struct disks *d, double r, struct lattice *l)
{
    for (size_t k = 0; k < d->dimensions; ++k) {
        const bool walls = disks_walled(d, k);
        const double cells = (double)l->cells[k];
        l->from[k] = walls ? r : 0;
        l->step[k] =
            walls ? (d->box[k] - 2 * r) / (cells - .5) : d->box[k] / cells;
    }
    l->nearest = nearest_site(l, d->dimensions);
}

/* Tries all lattices of so many layers of cells, for `need` cells. */
static void try_layers(const struct disks *d, double r, size_t need,
                       struct lattice l, struct lattice *best)
{
    const size_t layer = (need + l.cells[2] - 1) / l.cells[2];
    const double row = sqrt((double)layer * d->box[0] / d->box[1]);
    for (l.cells[0] = 1;
         l.cells[0] <= layer && (double)l.cells[0] <= 2 + 4 * row;
         ++l.cells[0]) {
        l.cells[1] = (layer + l.cells[0] - 1) / l.cells[0];
        stretch(d, r, &l);
        if (l.nearest > best->nearest * (1 + 1e-12))
            *best = l;
    }
}

/* The lattice with so many places, or more, and the widest spacing. */
static struct lattice best_lattice(const struct disks *d, double r,
                                   size_t places)
{
    struct lattice best = {.nearest = 0}, l = {.cells = {1, 1, 1}};
    l.basis = d->dimensions == 2 ? 2 : 4;
    const size_t need = (places + l.basis - 1) / l.basis;
    const double cube =
        (double)need * d->box[2] * d->box[2] / (d->box[0] * d->box[1]);
    for (double n = -1; n <= 0 || n * n * n <= 8 * cube; ++n) {
        try_layers(d, r, need, l, &best);
        ++l.cells[2];
        if (d->dimensions == 2)
            break;
    }
    return best;
}

static void place_of_site(const struct disks *d, const struct lattice *l,
                          size_t site, double place[])
{
    const double *part = sites[site % l->basis];
    site /= l->basis;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const size_t cell = site % l->cells[k];
        site /= l->cells[k];
        place[k] = l->from[k] + ((double)cell + part[k]) * l->step[k];
    }
}

/* The number of the widest disk, if it is the only one so wide and not the
   only one; or count. *r: the widest radius of the others. */
static size_t odd_one_out(const struct disks *d, double *r)
{
    size_t big = 0;
    *r = d->count > 1 ? 0 : d->disk[0].radius;
    for (size_t i = 1; i < d->count; ++i)
        if (d->disk[i].radius > d->disk[big].radius)
            big = i;
    for (size_t i = 0; i < d->count; ++i)
        if (i != big)
            *r = fmax(*r, d->disk[i].radius);
    return d->disk[big].radius > *r ? big : d->count;
}

static bool covered(const struct disks *d, size_t big, double r,
                    const double place[])
{
    double square = 0;
    if (big == d->count)
        return false;
    const double reach = d->disk[big].radius + r;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double x = place[k] - d->box[k] / 2;
        square += x * x;
    }
    return square < reach * reach;
}

static size_t count_free(const struct disks *d, const struct lattice *l,
                         size_t big, double r)
{
    const size_t all = l->basis * l->cells[0] * l->cells[1] * l->cells[2];
    double place[DISKS_AXES];
    size_t free = 0;
    for (size_t site = 0; site < all; ++site) {
        place_of_site(d, l, site, place);
        free += !covered(d, big, r, place);
    }
    return free;
}

/* Puts the disks, but for the big one, on the free sites. */
static void fill_lattice(struct disks *d, const struct lattice *l,
                         size_t big, double r, size_t free)
{
    const size_t small = d->count - (big < d->count);
    double place[DISKS_AXES] = {0};
    size_t put = 0, seen = 0;
    for (size_t site = 0; put < small; ++site) {
        place_of_site(d, l, site, place);
        if (covered(d, big, r, place))
            continue;
        if (seen == (size_t)((uint64_t)put * free / small)) {
            struct disk *to = &d->disk[put + (put >= big)];
            memcpy(to->position, place, sizeof place);
            ++put;
        }
        ++seen;
    }
}

bool disks_place_lattice(struct disks *d)
{
    double r;
    const size_t big = odd_one_out(d, &r);
    const size_t small = d->count - (big < d->count);
    struct lattice l;
    size_t places = small, free;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_walled(d, k) && d->box[k] < 2 * r)
            return false;
    do {
        l = best_lattice(d, r, places);
        if (!(l.nearest >= 2 * r))
            return false;
        free = count_free(d, &l, big, r);
        places += free < small ? small - free : 0;
    } while (free < small);
    fill_lattice(d, &l, big, r, free);
    for (size_t k = 0; big < d->count && k < d->dimensions; ++k)
        d->disk[big].position[k] = d->box[k] / 2;
    return big == d->count || !disks_clash(d, big, d->count);
}

/* Whether disk i overlaps one with a smaller number. */
static bool overlaps(const struct disks *d, size_t i)
{
    const struct disk *a = &d->disk[i];
    for (size_t j = 0; j < i; ++j) {
        const double least = a->radius + d->disk[j].radius;
        double apart[DISKS_AXES];
        disks_apart(d, d->disk[j].position, a->position, apart);
        if (dot(apart, apart) < least * least)
            return true;
    }
    return false;
}

static bool throw_disk(const struct disks *d, struct disk *a,
                       struct random *r)
{
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double edge = disks_walled(d, k) ? a->radius : 0;
        if (!(d->box[k] >= 2 * edge))
            return false;
        a->position[k] = random_between(r, edge, d->box[k] - edge);
    }
    return true;
}

bool disks_place_random(struct disks *d, struct random *r)
{
    enum { TRIES = 10000 };
    for (size_t i = 0; i < d->count; ++i) {
        int tries = 0;
        do {
            if (tries++ == TRIES || !throw_disk(d, &d->disk[i], r))
                return false;
        } while (overlaps(d, i));
    }
    return true;
}

static void scale_velocities(struct disks *d, double factor)
{
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < DISKS_AXES; ++k)
            d->disk[i].velocity[k] *= factor;
}

static void take_out_momentum(struct disks *d)
{
    double total[DISKS_AXES] = {0}, mass = 0;
    const double before = kinetic(d);
    if (!disks_wraps(d, 0) || d->count < 2)
        return;
    for (size_t i = 0; i < d->count; ++i) {
        mass += d->mass[i];
        for (size_t k = 0; k < DISKS_AXES; ++k)
            if (disks_wraps(d, k))
                total[k] += d->mass[i] * d->disk[i].velocity[k];
    }
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < DISKS_AXES; ++k)
            d->disk[i].velocity[k] -= total[k] / mass;
    const double after = kinetic(d);
    if (after > 0)
        scale_velocities(d, sqrt(before / after));
}

void disks_set_speed(struct disks *d, double v, struct random *r)
{
    for (size_t i = 0; i < d->count; ++i) {
        random_direction(r, d->dimensions, d->disk[i].velocity);
        for (size_t k = 0; k < d->dimensions; ++k)
            d->disk[i].velocity[k] *= v;
    }
    take_out_momentum(d);
}

void disks_set_temperature(struct disks *d, double kT, struct random *r)
{
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < d->dimensions; ++k)
            d->disk[i].velocity[k] =
                sqrt(kT / d->mass[i]) * random_normal(r);
    take_out_momentum(d);
}

void disks_settle(struct disks *d)
{
    for (size_t i = 0; i < d->count; ++i) {
        struct disk *a = &d->disk[i];
        move_to(d, a, d->now);
        a->since = 0;
        disks_fold(d, a->position);
        d->hits[i] = 0;
    }
    d->now = 0;
    d->collisions = d->wall_collisions = d->standing = 0;
    d->virial = 0;
    memset(d->impulse, 0, sizeof d->impulse);
}
