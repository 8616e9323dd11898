/* Runs disks from event to event with neighbour lists and vector code. */
#include "box/cells.h"

#include "box/image.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef VECTOR_AVX2
#include <immintrin.h>
#endif

enum { BATCH = 4 }; /* anchors whose distances are computed together */

/* Returns the address of the x coordinate of the anchor of disk i. A cell
   stores the x of all its anchors, then all y, then all z, so y and z are
   c->room and 2 c->room floats later. */
static const float *place_of(const struct cells *c, uint32_t i)
{
    const struct cells_anchor *a = &c->anchor[i];
    return c->place + 3 * a->cell * c->room + a->spot;
}

/* x + SHIFT - SHIFT is the whole number nearest to x (see image.h). */
#define SHIFT 6755399441055744.0

/* Fills `way` with the displacement of disk i from its anchor (in m), and v
   with its velocity (in m/s). Repeats the code of disks_position and
   disks_separation, but without divisions. This makes runs of 10 000
   spheres 6 % faster, since every plan calls this function. disks_position
   is called only under gravity. */
static void from_anchor(const struct cells *c, uint32_t i, double way[],
                        double v[])
{
    const struct disk *a = &c->d->disk[i];
    const float *at = place_of(c, i);
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        v[k] = a->velocity[k];
        way[k] = a->position[k] + v[k] * (c->d->now - a->since);
    }
    if (c->d->gravity > 0) {
        disks_velocity(c->d, i, v);
        disks_position(c->d, i, way);
    }
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        way[k] -= (double)at[k * c->room];
        way[k] -= c->d->box[k] * (way[k] * c->inverse[k] + SHIFT - SHIFT);
    }
}

/* Returns the time (in s) at which disk i will be a skin away from its
   anchor (7.15, eq:skin-end). Returns INFINITY, without computing a root,
   if this time is not before `until`. Returns the present time if rounding
   has already put the disk there. Under gravity the exact time would be
   the root of a quartic. Instead, a quarter of the skin is reserved for
   falling, which is enough for the time `most`, and the straight part of
   the motion may use the other three quarters. */
static double skin_end(const struct cells *c, uint32_t i, double until)
{
    const double g = c->d->gravity;
    const double most = g > 0 ? sqrt(c->skin / (2 * g)) : INFINITY;
    const double skin = g > 0 ? 0.75 * c->skin : c->skin;
    double way[DISKS_AXES], v[DISKS_AXES];
    from_anchor(c, i, way, v);
    const double b = dot(way, v), vv = dot(v, v);
    const double left = skin * skin - dot(way, way);
    const double wait = until - c->d->now;
    if (wait * (2 * b + vv * wait) < left && wait <= most)
        return INFINITY;
    if (vv == 0)
        return c->d->now + most;
    if (left <= 0)
        return c->d->now;
    const double root = sqrt(b * b + vv * left); /* (7.15, eq:skin-end) */
    const double end = b > 0 ? left / (root + b) : (root - b) / vv;
    return c->d->now + fmin(end, most);
}

/* Replaces *first by the earliest meeting of disk i with a neighbour, if
   this comes before *first. */
static void meet_each(const struct cells *c, uint32_t i,
                      struct disks_event *first)
{
    const uint32_t *list = c->neighbour + i * c->seats;
    for (size_t k = 0; k < c->anchor[i].neighbours; ++k) {
        const struct disks_event pair = {
            disks_meeting(c->d, i, list[k], c->d->now), i, list[k]};
        if (pair.time <= first->time && disks_before(pair, *first))
            *first = pair;
    }
}

/* Code for four neighbours at once. It performs the operations of
   disks_meeting in the same order, and vector lanes round as scalars do, so
   the results are equal to the last bit. */
#ifdef VECTOR_AVX2
typedef __m256d v4;
typedef long long l4 __attribute__((vector_size(32)));

VECTOR_AVX2 static inline v4 all(double x)
{
    return _mm256_set1_pd(x);
}

VECTOR_AVX2 static inline void transpose(v4 a, v4 b, v4 c, v4 d,
                                         v4 column[4])
{
    const v4 ab = _mm256_unpacklo_pd(a, b), ba = _mm256_unpackhi_pd(a, b);
    const v4 cd = _mm256_unpacklo_pd(c, d), dc = _mm256_unpackhi_pd(c, d);
    column[0] = _mm256_permute2f128_pd(ab, cd, 0x20);
    column[1] = _mm256_permute2f128_pd(ba, dc, 0x20);
    column[2] = _mm256_permute2f128_pd(ab, cd, 0x31);
    column[3] = _mm256_permute2f128_pd(ba, dc, 0x31);
}

/* Loads four disks, each of which fills a cache line, into vectors: x, y, z
   and `since` into place, and the three components of the velocity and the
   radius into speed. */
VECTOR_AVX2 static inline void gather(const struct disk *disk,
                                      const uint32_t *list, v4 place[4],
                                      v4 speed[4])
{
    const double *a = disk[list[0]].position;
    const double *b = disk[list[1]].position;
    const double *c = disk[list[2]].position;
    const double *d = disk[list[3]].position;
    transpose(_mm256_load_pd(a), _mm256_load_pd(b), _mm256_load_pd(c),
              _mm256_load_pd(d), place);
    transpose(_mm256_load_pd(a + 4), _mm256_load_pd(b + 4),
              _mm256_load_pd(c + 4), _mm256_load_pd(d + 4), speed);
}

/* Computes the separations and relative velocities of four disks with
   respect to disk a, and their distances at contact. Returns the times to
   which the separations belong. */
VECTOR_AVX2 static inline v4 approach(const struct cells *c,
                                      const struct disk *a,
                                      const uint32_t *list, v4 apart[3],
                                      v4 closing[3], v4 *distance)
{
    v4 place[4], speed[4];
    gather(c->d->disk, list, place, speed);
    const v4 last = _mm256_max_pd(place[3], all(a->since));
    for (int k = 0; k < 3; ++k) {
        closing[k] = speed[k] - a->velocity[k];
        apart[k] = place[k] + speed[k] * (last - place[3]) -
                   (a->position[k] + a->velocity[k] * (last - a->since));
        apart[k] -=
            c->d->box[k] *
            ((apart[k] + closing[k] * (c->d->now - last)) * c->inverse[k] +
             SHIFT - SHIFT);
    }
    *distance = speed[3] + a->radius;
    return last;
}

VECTOR_AVX2 static inline v4 dot4(const v4 a[], const v4 b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns x in the chosen lanes and `otherwise` in the other lanes. */
VECTOR_AVX2 static inline v4 choose(v4 otherwise, v4 x, l4 chosen)
{
    return _mm256_blendv_pd(otherwise, x, (v4)chosen);
}

/* The earliest meeting in each lane: its time (in s) and the partner. */
struct lanes {
    v4 time;
    l4 who;
};

/* Updates *first by the meetings of disk a with four disks. Lanes cannot
   branch separately, so both results are computed and one is selected.
   Skipping the root when no lane has a meeting, which is common, was
   slower, since the processor mispredicts this branch too often. */
VECTOR_AVX2 static inline void meet_four(const struct cells *c,
                                         const struct disk *a,
                                         const uint32_t *list,
                                         struct lanes *first)
{
    v4 apart[3], closing[3], distance;
    const v4 last = approach(c, a, list, apart, closing, &distance);
    const v4 b = dot4(apart, closing);
    const v4 gap = dot4(apart, apart) - distance * distance;
    const v4 disc = b * b - dot4(closing, closing) * gap;
    const l4 meets = (b < all(0)) & (disc >= all(0));
    const v4 root = _mm256_sqrt_pd(_mm256_max_pd(disc, all(0)));
    const v4 flight = choose(all(0), gap / (root - b), gap > all(0));
    const v4 time = choose(all(INFINITY), last + flight, meets);
    const l4 who = {list[0], list[1], list[2], list[3]};
    const l4 sooner =
        (time < first->time) | ((time == first->time) & (who < first->who));
    first->time = choose(first->time, time, sooner);
    first->who = (l4)choose((v4)first->who, (v4)who, sooner);
}

/* Does what meet_each does. If the length of a list is not a multiple of
   four, it is padded with disk i itself, which disk i never meets. */
VECTOR_AVX2 static void meet_by_fours(const struct cells *c, uint32_t i,
                                      struct disks_event *first)
{
    const struct disk *a = &c->d->disk[i];
    const uint32_t *list = c->neighbour + i * c->seats;
    const uint32_t *end = list + c->anchor[i].neighbours;
    const long long wall = first->partner;
    struct lanes lanes = {all(first->time), {wall, wall, wall, wall}};
    for (; list < end; list += 4)
        meet_four(c, a, list, &lanes);
    for (int k = 0; k < 4; ++k) {
        const struct disks_event pair = {lanes.time[k], i,
                                         (uint32_t)lanes.who[k]};
        if (pair.time <= first->time && disks_before(pair, *first))
            *first = pair;
    }
}
#endif

/* Code for eight neighbours at once. A 512-bit register holds half of the
   data of each of two disks. The pairs of disks are chosen so that after
   the transposition the disks are in the order of the list. */
#ifdef VECTOR_AVX512
#define EIGHT VECTOR_LONG VECTOR_AVX512 static inline
typedef __m512d v8;

EIGHT void gather_eight(const struct disk *disk, const uint32_t *list,
                        size_t half, v8 column[4])
{
    v8 row[4];
    for (size_t k = 0; k < 4; ++k) {
        const uint32_t *pair = list + k + (k & 2); /* pair[0] and pair[2]
                                                      share a row */
        row[k] = _mm512_insertf64x4(
            _mm512_castpd256_pd512(
                _mm256_load_pd(disk[pair[0]].position + half)),
            _mm256_load_pd(disk[pair[2]].position + half), 1);
    }
    const v8 ab = _mm512_unpacklo_pd(row[0], row[1]);
    const v8 ba = _mm512_unpackhi_pd(row[0], row[1]);
    const v8 cd = _mm512_unpacklo_pd(row[2], row[3]);
    const v8 dc = _mm512_unpackhi_pd(row[2], row[3]);
    column[0] = _mm512_shuffle_f64x2(ab, cd, 0x88);
    column[1] = _mm512_shuffle_f64x2(ba, dc, 0x88);
    column[2] = _mm512_shuffle_f64x2(ab, cd, 0xdd);
    column[3] = _mm512_shuffle_f64x2(ba, dc, 0xdd);
}

/* The earliest meeting in each lane: its time (in s) and the partner.
   `ties` marks lanes in which two meetings had equal times. Such ties are
   very rare, so they are left to scalar code. Resolving them in each lane
   would cost 2 % of the time in a dense gas. */
struct lanes_eight {
    v8 time;
    __m512i who;
    __mmask8 ties;
};

#define IS(a, how, b) _mm512_cmp_pd_mask(a, b, _CMP_##how##_OQ)
#define DOT(a, b) (a[0] * b[0] + a[1] * b[1] + a[2] * b[2])

/* Updates *first by the meetings of disk a with eight disks of the list.
   Ignores disks whose bit in `asked` is 0. */
EIGHT void meet_eight(const struct cells *c, const struct disk *a,
                      const uint32_t *list, __mmask8 asked,
                      struct lanes_eight *first)
{
    const v8 zero = _mm512_setzero_pd();
    v8 place[4], speed[4], apart[3], closing[3];
    gather_eight(c->d->disk, list, 0, place);
    gather_eight(c->d->disk, list, 4, speed);
    const v8 last = _mm512_max_pd(place[3], _mm512_set1_pd(a->since));
    for (int k = 0; k < 3; ++k) {
        closing[k] = speed[k] - a->velocity[k];
        apart[k] = place[k] + speed[k] * (last - place[3]) -
                   (a->position[k] + a->velocity[k] * (last - a->since));
        apart[k] -=
            c->d->box[k] *
            ((apart[k] + closing[k] * (c->d->now - last)) * c->inverse[k] +
             SHIFT - SHIFT);
    }
    const v8 distance = speed[3] + a->radius, b = DOT(apart, closing);
    const v8 gap = DOT(apart, apart) - distance * distance;
    const v8 disc = b * b - DOT(closing, closing) * gap;
    const __mmask8 meets = asked & IS(b, LT, zero) & IS(disc, GE, zero);
    const v8 root = _mm512_maskz_sqrt_pd(meets, disc);
    const v8 time =
        last + _mm512_maskz_div_pd(IS(gap, GT, zero), gap, root - b);
    const __m512i who =
        _mm512_cvtepu32_epi64(_mm256_loadu_si256((const __m256i *)list));
    const __mmask8 sooner = meets & IS(time, LT, first->time);
    first->ties |= meets & IS(time, EQ, first->time);
    first->time = _mm512_mask_mov_pd(first->time, sooner, time);
    first->who = _mm512_mask_mov_epi64(first->who, sooner, who);
}

/* Does what meet_each does. Most disks have 9 to 16 neighbours, so the
   first two batches follow each other without a loop. The processor then
   starts the second batch before the roots of the first are done. The last
   batch is placed so that it ends at the end of the list, and it may
   overlap the batch before it. Neighbours that were already examined are
   masked out, since each would tie with itself. If there is a tie,
   meet_each is called. */
EIGHT void meet_by_eights(const struct cells *c, uint32_t i,
                          struct disks_event *first)
{
    const struct disk *a = &c->d->disk[i];
    const uint32_t *list = c->neighbour + i * c->seats;
    const size_t n = c->anchor[i].neighbours;
    struct lanes_eight lanes = {_mm512_set1_pd(first->time),
                                _mm512_set1_epi64(first->partner), 0};
    meet_eight(c, a, list, 255, &lanes);
    if (n > 8) {
        const size_t at = n < 16 ? n - 8 : 8;
        meet_eight(c, a, list + at, (__mmask8)(255 << (8 - at)), &lanes);
    }
    for (size_t k = 16; k < n; k += 8) {
        const size_t at = n < k + 8 ? n - 8 : k;
        meet_eight(c, a, list + at, (__mmask8)(255 << (k - at)), &lanes);
    }
    const double time = _mm512_reduce_min_pd(lanes.time);
    const __mmask8 those = IS(lanes.time, EQ, _mm512_set1_pd(time));
    if (!lanes.ties && !(time < first->time))
        return;
    if (lanes.ties || (those & (those - 1))) {
        meet_each(c, i, first);
        return;
    }
    const __m512i who = _mm512_maskz_compress_epi64(those, lanes.who);
    *first = (struct disks_event){
        time, i, (uint32_t)_mm_cvtsi128_si32(_mm512_castsi512_si128(who))};
}
#endif

size_t cells_lanes(void)
{
#ifdef VECTOR_AVX2
    return VECTOR_HAS("avx512f") ? 8 : VECTOR_HAS("avx2") ? 4 : 1;
#else
    return 1;
#endif
}

/* Updates *first by the meetings of disk i with its neighbours. Uses the
   widest vector code available. Vector code assumes straight flights, so
   under gravity the neighbours are examined one by one. */
static void meet_neighbours(const struct cells *c, uint32_t i,
                            struct disks_event *first)
{
#ifdef VECTOR_AVX2
    const size_t lanes = c->d->gravity > 0 ? 1 : c->lanes;
    if (lanes == 8)
        meet_by_eights(c, i, first);
    else if (lanes == 4)
        meet_by_fours(c, i, first);
    if (lanes > 1)
        return;
#endif
    meet_each(c, i, first);
}

/* FETCH loads a cache line in advance. A large system mostly waits for
   memory: the disks that collide next may be anywhere in memory, but they
   are known early. gcc treats a function that only prefetches as having no
   effect and drops its calls, so all such functions are inlined. */
#ifdef __GNUC__
#define FETCH(place) __builtin_prefetch(place)
#define FETCHING static inline __attribute__((always_inline))
#else
#define FETCH(place) ((void)(place))
#define FETCHING static inline
#endif

/* Thresholds for the number of disks. Fewer than FETCH_EARLY fit into the
   cache and need no prefetching. With FETCH_LATE disks or more, neighbours
   are fetched again right before they are needed. With fewer, look_ahead is
   enough. */
enum { FETCH_EARLY = 4000, FETCH_LATE = 50000 };
enum { FETCHED = 12 }; /* entries fetched; no list has fewer */

/* Prefetches the neighbours of disk i. Below FETCH_LATE disks it fetches
   twelve entries of the list, used or not, since the processor mispredicts
   the end of a loop of varying length. This is 4 % faster with 10 000
   spheres. With 100 000 spheres the memory bandwidth is too scarce for
   unused entries. */
FETCHING void fetch_list(const struct cells *c, uint32_t i)
{
    const uint32_t *list = c->neighbour + i * c->seats;
    const size_t seats =
        c->d->count < FETCH_LATE ? FETCHED : c->anchor[i].neighbours;
    FETCH(&c->calendar.event[i]);
    for (size_t k = 0; k < seats; ++k)
        FETCH(&c->d->disk[list[k]]);
}

FETCHING void fetch_neighbours(const struct cells *c, uint32_t i)
{
    if (c->d->count >= FETCH_LATE)
        fetch_list(c, i);
}

/* Prefetches the data of disk i and both ends of its neighbour list, which
   may be in two cache lines. */
FETCHING void fetch_disk(const struct cells *c, uint32_t i)
{
    FETCH(&c->d->disk[i]);
    FETCH(&c->d->hits[i]);
    FETCH(&c->anchor[i]);
    FETCH(&c->calendar.event[i]);
    FETCH(c->neighbour + i * c->seats);
    if (c->d->count < FETCH_LATE)
        FETCH(c->neighbour + i * c->seats + FETCHED);
}

/* Prefetches all disks that have an event on a day and their partners. If
   `neighbours` is true, prefetches the neighbours of both instead. */
FETCHING void fetch_day(const struct cells *c, size_t day, bool neighbours)
{
    const struct calendar_event *event = c->calendar.event;
    uint32_t i = c->calendar.day[day];
    for (; i < c->d->count; i = event[i].next) {
        const uint32_t with = event[i].partner;
        const uint32_t other = with < c->d->count ? with : i;
        if (neighbours) {
            fetch_list(c, i);
            fetch_list(c, other);
        } else {
            fetch_disk(c, i);
            fetch_disk(c, other);
        }
    }
}

/* Prefetches data for the next days whenever the calendar starts a new day:
   the first event of the day five days ahead, the second event of the day
   four days ahead, the disks of the day three days ahead, and the
   neighbours of tomorrow's disks. Each step thus finds the data that an
   earlier step has loaded. This saves a third of the time with 100 000
   disks. */
FETCHING void look_ahead(const struct cells *c, size_t today)
{
    const struct calendar_event *event = c->calendar.event;
    if (c->d->count < FETCH_EARLY || today + 5 >= c->calendar.days)
        return;
    const uint32_t far = c->calendar.day[today + 5];
    const uint32_t near = c->calendar.day[today + 4];
    FETCH(&event[far]);
    FETCH(&event[event[near].next]);
    fetch_day(c, today + 3, false);
    fetch_day(c, today + 1, true);
}

/* Plans the next event of disk i: a meeting with a wall or a neighbour, or
   the end of its skin, which is an event with i itself as the partner. */
static void plan(struct cells *c, uint32_t i)
{
    struct disks *d = c->d;
    size_t axis = 0;
    struct disks_event first = {disks_wall(d, i, &axis), i,
                                (uint32_t)(d->count + axis)};
    fetch_neighbours(c, i);
    meet_neighbours(c, i, &first);
    const double end = skin_end(c, i, first.time);
    if (end < first.time)
        first = (struct disks_event){end, i, i};
    struct calendar_event *e = &c->calendar.event[i];
    e->partner = first.partner;
    e->version = first.partner < d->count ? d->hits[first.partner] : 0;
    calendar_put(&c->calendar, i, first.time);
}

/* Lengthens all lists by four entries. The number of neighbours has no
   useful upper limit: a giant among small disks has hundreds. This happens
   a few times at the start of a run. The lists are moved in reverse order,
   so none is overwritten. Returns false if memory runs out. */
static bool lengthen_lists(struct cells *c)
{
    const size_t n = c->d->count, seats = c->seats + 4, old = c->seats;
    uint32_t *list = realloc(c->neighbour, n * seats * sizeof *list);
    if (!list)
        return false;
    for (size_t i = n; i-- > 0;)
        for (size_t k = seats; k-- > 0;)
            list[i * seats + k] = k < old ? list[i * old + k] : (uint32_t)i;
    c->neighbour = list;
    c->seats = seats;
    return true;
}

/* Appends `other` to the list of disk i. Returns false if memory runs out,
   or if i has more neighbours than 16 bits can count. */
static bool add_neighbour(struct cells *c, uint32_t i, uint32_t other)
{
    if (c->anchor[i].neighbours == UINT16_MAX ||
        (c->anchor[i].neighbours == c->seats && !lengthen_lists(c)))
        return false;
    c->neighbour[i * c->seats + c->anchor[i].neighbours++] = other;
    return true;
}

/* Removes `other` from the list of disk i. The last neighbour moves to the
   entry of `other`, as the order of a list has no effect on events. The
   loop visits all entries, four at a time. Stopping at the entry found
   would take longer, since that branch is usually mispredicted. */
static void remove_neighbour(struct cells *c, uint32_t i, uint32_t other)
{
    uint32_t *entry = c->neighbour + i * c->seats;
    const size_t last = --c->anchor[i].neighbours;
    const uint32_t name = entry[last];
    for (size_t k = 0; k < c->seats; k += BATCH)
        for (size_t l = 0; l < BATCH; ++l)
            entry[k + l] = entry[k + l] == other ? name : entry[k + l];
    entry[last] = i;
}

/* Removes disk i from all lists and empties its own list. */
static void clear_list(struct cells *c, uint32_t i)
{
    uint32_t *entry = c->neighbour + i * c->seats;
    for (size_t k = 0; k < c->anchor[i].neighbours; ++k) {
        remove_neighbour(c, entry[k], i);
        entry[k] = i;
    }
    c->anchor[i].neighbours = 0;
}

/* Returns the cell that contains a position (7.16, eq:cell-index). For a
   position just below the edge of the box, rounding can give an index one
   too large, which is replaced by the index of the last cell. */
static size_t cell_of(const struct cells *c, const double x[])
{
    size_t cell = 0, k = DISKS_AXES;
    while (k-- > 0) {
        const double part =
            c->grid[k] > 1 ? x[k] / c->d->box[k] * (double)c->grid[k] : 0;
        const size_t g = part > 0 ? (size_t)part : 0;
        cell = cell * c->grid[k] + (g < c->grid[k] ? g : c->grid[k] - 1);
    }
    return cell;
}

/* Gives all cells space for two more anchors. Moves the arrays of the cells
   apart, in reverse order. Returns false if memory runs out. */
static bool enlarge_cells(struct cells *c)
{
    const size_t old = c->room, room = old + 2;
    float *place =
        realloc(c->place, (c->cells * room * 3 + BATCH) * sizeof *place);
    if (place)
        c->place = place;
    uint32_t *who =
        realloc(c->who, (c->cells * room + BATCH) * sizeof *who);
    if (who)
        c->who = who;
    if (!place || !who)
        return false;
    for (size_t row = 3 * c->cells; row-- > 0;)
        memmove(place + row * room, place + row * old, old * sizeof *place);
    for (size_t cell = c->cells; cell-- > 0;)
        memmove(who + cell * room, who + cell * old, old * sizeof *who);
    c->room = room;
    return true;
}

/* Stores the anchor of disk i, with the coordinates x[0], x[step] and x[2
   step], as entry `at` of a cell. */
static void write_place(struct cells *c, size_t cell, size_t at, uint32_t i,
                        const float x[], size_t step)
{
    float *place = c->place + 3 * cell * c->room + at;
    for (size_t k = 0; k < DISKS_AXES; ++k)
        place[k * c->room] = x[k * step];
    c->who[cell * c->room + at] = i;
    c->anchor[i].cell = (uint32_t)cell;
    c->anchor[i].spot = (uint16_t)at;
}

/* Removes the anchor of disk i from its cell, and moves the last anchor of
   the cell to the free entry. */
static void leave_cell(struct cells *c, uint32_t i)
{
    const struct cells_anchor a = c->anchor[i];
    const uint32_t *who = c->who + a.cell * c->room;
    const uint32_t last = who[--c->full[a.cell]];
    write_place(c, a.cell, a.spot, last, place_of(c, last), c->room);
}

/* Sets the anchor of disk i to its present position, and stores it in the
   cell at this position. Returns false if memory runs out. */
static bool enter_cell(struct cells *c, uint32_t i)
{
    double x[DISKS_AXES];
    disks_position(c->d, i, x);
    disks_fold(c->d, x);
    const size_t cell = cell_of(c, x);
    if (c->full[cell] == UINT16_MAX ||
        (c->full[cell] == c->room && !enlarge_cells(c)))
        return false;
    const float at[] = {(float)x[0], (float)x[1], (float)x[2]};
    write_place(c, cell, c->full[cell]++, i, at, 1);
    return true;
}

/* A cell and its neighbours along an axis, and the shifts to be added to
   their anchors. In a periodic box the neighbour of an edge cell is the
   cell at the opposite edge. */
struct beside {
    size_t count, at[3];
    float shift[3]; /* m */
};

/* Returns cell g along axis k and its neighbours: one on each side, but
   none beyond a wall. */
static struct beside beside(const struct cells *c, size_t g, size_t k)
{
    const bool periodic = c->inverse[k] > 0;
    const float box = (float)c->d->box[k];
    const size_t last = c->grid[k] - 1;
    struct beside b = {1, {g, 0, 0}, {0, 0, 0}};
    if (g > 0 || periodic) {
        b.at[b.count] = g > 0 ? g - 1 : last;
        b.shift[b.count++] = g > 0 ? 0 : -box;
    }
    if (g < last || periodic) {
        b.at[b.count] = g < last ? g + 1 : 0;
        b.shift[b.count++] = g < last ? 0 : box;
    }
    return b;
}

/* Makes disks i and `other` neighbours if their anchors are close enough
   (7.14, eq:neighbours). `square` is the squared distance between the
   anchors, m^2. Returns false if memory runs out. */
static bool join_if_near(struct cells *c, uint32_t i, uint32_t other,
                         float square)
{
    const double reach = c->d->disk[i].radius + c->d->disk[other].radius +
                         2 * c->skin + c->slack;
    if (other == i || (double)square > reach * reach)
        return true;
    return add_neighbour(c, i, other) && add_neighbour(c, other, i);
}

/* NEAR: largest number of anchors collected; ROW: number of vector
   lanes. */
enum { NEAR = 64, ROW = 16 };

/* Anchors so close that their disks would be neighbours if both had the
   largest radius. */
struct near {
    size_t count;
    uint32_t who[NEAR + ROW];
    float square[NEAR + ROW]; /* squared distances, m^2 */
};

/* Calls join_if_near for all anchors in *near, and empties it. Returns
   false if memory runs out. */
static bool join_all(struct cells *c, uint32_t i, struct near *near)
{
    for (size_t k = 0; k < near->count; ++k)
        if (!join_if_near(c, i, near->who[k], near->square[k]))
            return false;
    near->count = 0;
    return true;
}

/* Computes the distances of all anchors of a cell (at most 16) at once, and
   appends the near anchors to *near. Entries written by unused lanes are
   overwritten by the next call. A dense gas of 10 000 spheres, in which
   every eleventh collision renews a list, runs 3 % faster. */
#ifdef VECTOR_AVX512
VECTOR_AVX512 static void search_row(const struct cells *c, size_t cell,
                                     const float from[], float farthest,
                                     struct near *near)
{
    const float *x = c->place + 3 * cell * c->room;
    const __mmask16 all = (__mmask16)((1u << c->full[cell]) - 1);
    const __m512i who =
        _mm512_maskz_loadu_epi32(all, c->who + cell * c->room);
    const __m512 u = _mm512_maskz_loadu_ps(all, x) - from[0];
    const __m512 v = _mm512_maskz_loadu_ps(all, x + c->room) - from[1];
    const __m512 w = _mm512_maskz_loadu_ps(all, x + 2 * c->room) - from[2];
    const __m512 square = u * u + v * v + w * w;
    const __mmask16 those = _mm512_mask_cmp_ps_mask(
        all, square, _mm512_set1_ps(farthest), _CMP_LE_OQ);
    _mm512_storeu_ps(near->square + near->count,
                     _mm512_maskz_compress_ps(those, square));
    _mm512_storeu_si512(near->who + near->count,
                        _mm512_maskz_compress_epi32(those, who));
    near->count += (size_t)__builtin_popcount(those);
}
#endif

/* Appends to *near the anchors of a cell whose squared distance from the
   position `from` is at most `farthest`, m^2. Returns false if memory runs
   out. Four distances are computed together, in a loop of fixed length that
   compilers vectorise. Entries beyond the last anchor of the cell never
   count. All four anchors are written to the list, but its count grows only
   for near anchors, so the next write replaces a distant one. Only one
   anchor in seven is near, and a mispredicted branch would cost more than a
   write. Together with remove_neighbour, this makes spheres at packing
   fraction 0.3 run a fifth faster. */
static bool search_cell(struct cells *c, uint32_t i, size_t cell,
                        const float from[], float farthest,
                        struct near *near)
{
    const float *x = c->place + 3 * cell * c->room;
    const float *y = x + c->room, *z = y + c->room;
    const uint32_t *who = c->who + cell * c->room;
    const size_t full = c->full[cell];
#ifdef VECTOR_AVX512
    if (c->lanes == 8 && full <= ROW) {
        if (near->count > NEAR && !join_all(c, i, near))
            return false;
        search_row(c, cell, from, farthest, near);
        return true;
    }
#endif
    for (size_t k = 0; k < full; k += BATCH) {
        float square[BATCH];
        if (near->count > NEAR && !join_all(c, i, near))
            return false;
        for (size_t l = 0; l < BATCH; ++l) {
            const float u = x[k + l] - from[0], v = y[k + l] - from[1];
            const float w = z[k + l] - from[2];
            square[l] = u * u + v * v + w * w;
        }
        size_t count = near->count;
        for (size_t l = 0; l < BATCH; ++l) {
            near->who[count] = who[k + l];
            near->square[count] = square[l];
            count += (square[l] <= farthest) & (k + l < full);
        }
        near->count = count;
    }
    return true;
}

/* Fills the neighbour list of disk i from the 9 or 27 cells around its
   anchor. Returns false if memory runs out. */
static bool find_neighbours(struct cells *c, uint32_t i)
{
    const size_t nx = c->grid[0], ny = c->grid[1];
    const size_t home = c->anchor[i].cell;
    const float *at = place_of(c, i);
    const float here[] = {at[0], at[c->room], at[2 * c->room]};
    const struct beside bx = beside(c, home % nx, 0);
    const struct beside by = beside(c, home / nx % ny, 1);
    const struct beside bz = beside(c, home / nx / ny, 2);
    const double reach =
        c->d->disk[i].radius + c->widest + 2 * c->skin + c->slack;
    struct near near;
    near.count = 0;
    for (size_t z = 0; z < bz.count; ++z)
        for (size_t y = 0; y < by.count; ++y)
            for (size_t x = 0; x < bx.count; ++x) {
                const float from[] = {here[0] - bx.shift[x],
                                      here[1] - by.shift[y],
                                      here[2] - bz.shift[z]};
                const size_t cell =
                    (bz.at[z] * ny + by.at[y]) * nx + bx.at[x];
                if (!search_cell(c, i, cell, from, (float)(reach * reach),
                                 &near))
                    return false;
            }
    return join_all(c, i, &near);
}

/* Sets the anchor of disk i to its present position and makes a new list.
   Returns false if memory runs out. */
static bool renew(struct cells *c, uint32_t i)
{
    clear_list(c, i);
    leave_cell(c, i);
    return enter_cell(c, i) && find_neighbours(c, i);
}

/* Desired mean number of neighbours in the plane and in space. These values
   were fastest for spheres at packing fractions from 0.3 to 0.5. Values
   larger by 50 % would cost little time, but more memory. */
enum { CROWD = 10, CROWD_3 = 11 };

/* Returns the skin, m. A circle or sphere of radius 2 (r + skin) should
   contain CROWD disks besides the disk at its centre. The skin is at least
   0.3 diameters, since in dense packings no disk gets far (spheres at
   packing fraction 0.49 then have 15 neighbours). A periodic box limits the
   skin in two ways. Each axis needs three cells. And when a plan is made,
   two neighbours are at most sigma + 4 skins apart, and this must be less
   than half the box, since they must meet as nearest images. */
static double choose_skin(const struct disks *d, double radius, double pair)
{
    double volume = 1, least = INFINITY;
    for (size_t k = 0; k < d->dimensions; ++k) {
        volume *= d->box[k];
        least = disks_wraps(d, k) ? fmin(least, d->box[k]) : least;
    }
    const double crowd = d->dimensions == 3 ? CROWD_3 : CROWD;
    const double around = (crowd + 1) * volume / (double)d->count;
    const double sphere = 4.18879020478639098, circle = 3.14159265358979324;
    const double far =
        d->dimensions == 3 ? cbrt(around / sphere) : sqrt(around / circle);
    const double skin = fmax((far - 2 * radius) / 2, 0.6 * radius);
    const double image = (least / 2 - pair) / 4,
                 cells = least / 6 - pair / 2;
    return fmin(skin, 0.999 * fmin(image, cells));
}

/* Radii of the disks, m: the largest, the sum of the two largest, the
   mean. */
struct sizes {
    double widest, pair, mean;
};

static struct sizes sizes(const struct disks *d)
{
    double first = 0, second = 0, sum = 0;
    for (size_t i = 0; i < d->count; ++i) {
        const double r = d->disk[i].radius;
        sum += r;
        second = fmax(second, fmin(r, first));
        first = fmax(first, r);
    }
    return (struct sizes){first, first + second, sum / (double)d->count};
}

/* Chooses the skin, and divides the box into cells as wide as the range
   within which the two widest disks are neighbours. (With twice the largest
   radius, a single giant would count twice.) There are at most about two
   cells for each disk, since more bring no gain. Returns whether the box is
   wide enough. A periodic axis needs three cells, since otherwise a cell
   would be on both sides of another. Between walls one cell is enough.
   slack allows for the rounding of anchors to floats. It is a millionth of
   the box; the rounding errors are at most a sixteen-millionth. */
static bool lay_grid(struct cells *c, const struct disks *d)
{
    const struct sizes s = sizes(d);
    c->widest = s.widest;
    c->skin = choose_skin(d, s.mean, s.pair);
    c->slack = 0;
    c->cells = 1;
    for (size_t k = 0; k < d->dimensions; ++k)
        c->slack = fmax(c->slack, 1e-6 * d->box[k]);
    bool suit = c->skin > 0.1 * s.mean && c->skin > c->slack;
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        const bool used = k < d->dimensions, periodic = disks_wraps(d, k);
        const double reach = s.pair + 2 * c->skin + c->slack;
        const double most = used ? floor(d->box[k] / reach) : 1;
        const double plenty = 3 + 2 * (double)d->count / (double)c->cells;
        c->grid[k] = most < 1 ? 1 : (size_t)fmin(most, plenty);
        c->inverse[k] = periodic ? 1 / d->box[k] : 0;
        c->cells *= c->grid[k];
        suit = suit && !(periodic && c->grid[k] < 3);
    }
    return suit;
}

/* The limits of the sides keep squares of distances in the range of
   floats. */
bool cells_suit(const struct disks *d)
{
    struct cells c;
    double longest = 0;
    for (size_t k = 0; k < d->dimensions; ++k)
        longest = fmax(longest, d->box[k]);
    return lay_grid(&c, d) && longest > 1e-12 && longest < 1e15;
}

void cells_free(struct cells *c)
{
    free(c->neighbour);
    free(c->anchor);
    free(c->place);
    free(c->who);
    free(c->full);
    calendar_free(&c->calendar);
    *c = (struct cells){0};
}

/* Allocates the lists and the calendar for n disks. Returns false if memory
   runs out. The first guess of the length of a day need not be good: it is
   the time in which a disk crosses its skin, divided by n. */
static bool make_lists(struct cells *c, size_t n)
{
    double vv = 0;
    for (size_t i = 0; i < n; ++i)
        vv += dot(c->d->disk[i].velocity, c->d->disk[i].velocity);
    const double v = sqrt(vv / (double)n);
    const double day = v > 0 ? c->skin / v / (double)n : 1;
    c->seats = c->d->dimensions == 3 ? 16 : 12;
    c->room = 6;
    c->neighbour = malloc(n * c->seats * sizeof *c->neighbour);
    c->anchor = calloc(n, sizeof *c->anchor);
    c->place = calloc(c->cells * c->room * 3 + BATCH, sizeof *c->place);
    c->who = calloc(c->cells * c->room + BATCH, sizeof *c->who);
    c->full = calloc(c->cells, sizeof *c->full);
    return c->neighbour && c->anchor && c->place && c->who && c->full &&
           calendar_create(&c->calendar, n, c->d->now, day);
}

/* Inserts the disks one by one. Each finds its neighbours among the disks
   inserted before it. */
bool cells_create(struct cells *c, struct disks *d)
{
    const uint32_t n = (uint32_t)d->count;
    *c = (struct cells){.d = d, .lanes = cells_lanes()};
    lay_grid(c, d);
    bool memory = make_lists(c, n);
    for (size_t entry = 0; memory && entry < n * c->seats; ++entry)
        c->neighbour[entry] = (uint32_t)(entry / c->seats);
    for (uint32_t i = 0; memory && i < n; ++i)
        memory = enter_cell(c, i) && find_neighbours(c, i);
    if (!memory)
        cells_free(c);
    for (uint32_t i = 0; memory && i < n; ++i)
        plan(c, i);
    return memory;
}

/* Before the first run, two disks that overlap are always neighbours. */
bool cells_fit(const struct cells *c, size_t *a, size_t *b)
{
    const size_t n = c->d->count;
    bool clash = false;
    for (size_t i = 0; i < n && !clash; ++i) {
        const uint32_t *list = c->neighbour + i * c->seats;
        *a = i;
        *b = n;
        clash = disks_clash(c->d, i, n);
        for (size_t k = 0; k < c->anchor[i].neighbours && !clash; ++k)
            if (list[k] < *b && disks_clash(c->d, i, list[k]))
                *b = list[k];
        clash = clash || *b < n;
    }
    return !clash;
}

/* If event e is not a collision, makes a new plan and returns true. It is
   not a collision if the disk has moved as far as the skin of its neighbour
   list allows, or if its plan is stale, since its partner has collided
   after the plan was made. Sets *memory to false if memory runs out. */
static bool replan(struct cells *c, struct disks_event e, bool *memory)
{
    struct disks *d = c->d;
    const bool end = e.partner == e.disk;
    const bool stale =
        !end && e.partner < d->count &&
        c->calendar.event[e.disk].version != d->hits[e.partner];
    if (!end && !stale)
        return false;
    d->now = e.time > d->now ? e.time : d->now;
    c->renewed += end;
    c->stale += stale;
    if (end)
        *memory = renew(c, e.disk);
    plan(c, e.disk);
    return true;
}

/* Like disks_run, but takes the next event from the calendar and plans
   events only with neighbours. disks_collide is the same. */
enum disks_stop cells_run(struct cells *c, double until,
                          uint64_t collisions)
{
    struct disks *d = c->d;
    bool memory = true;
    size_t today = SIZE_MAX;
    while (d->collisions < collisions && memory) {
        const uint32_t i = calendar_first(&c->calendar);
        if (today != c->calendar.today)
            look_ahead(c, today = c->calendar.today);
        if (i == CALENDAR_NONE || c->calendar.event[i].time > until) {
            if (until < INFINITY && until > d->now)
                d->now = until;
            return DISKS_TIME;
        }
        const struct disks_event e = {c->calendar.event[i].time, i,
                                      c->calendar.event[i].partner};
        if (replan(c, e, &memory))
            continue;
        if (e.partner < d->count)
            fetch_neighbours(c, e.partner);
        disks_collide(d, e);
        if (disks_over(d, e.disk))
            return DISKS_COLLAPSE;
        plan(c, i);
        if (e.partner < d->count)
            plan(c, e.partner);
    }
    return DISKS_COLLISIONS;
}
