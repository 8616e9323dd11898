/* Cells against pairs, byte for byte: the same disks are run by both. With
   the argument "bytes" cells run alone, and the bytes of their runs' ends,
   folded into a number, are printed for builds to be compared. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "box/cells.h"
#include "toolbox/random.h"

enum radii { EQUAL, TWO, SPREAD, GIANT, POINTS };
enum speeds { NORMAL, ONE_SPEED, AXIS, REST, ONE_MOVES };

struct scene {
    size_t dimensions, count;
    enum disks_boundary boundary;
    double packing; /* of disks all as wide as the widest one, nearly */
    enum radii radii;
    enum speeds speeds;
    double restitution;
    uint64_t collisions;
    double aspect; /* of the box; 0: 1 */
    bool random;   /* places; else on a lattice */
};

static double radius_of(enum radii radii, size_t i, struct random *r)
{
    switch (radii) {
    case TWO: return i % 3 ? 0.3 : 0.5;
    case SPREAD: return i == 1 ? 0.5 : random_between(r, 0.1, 0.5);
    case GIANT: return i == 2 ? 3 : 0.5;
    case POINTS: return i % 2 ? 0 : 0.5;
    case EQUAL: break;
    }
    return 0.5;
}

static void throw_them(struct disks *d, enum speeds speeds,
                       struct random *r)
{
    if (speeds == NORMAL)
        disks_set_temperature(d, 1, r);
    if (speeds == ONE_SPEED)
        disks_set_speed(d, 1, r);
    for (size_t i = 0; speeds == AXIS && i < d->count; ++i)
        d->disk[i].velocity[i % d->dimensions] =
            random_below(r, 2) ? 1 : -1;
    for (size_t i = 0; speeds == REST && i < d->count; i += 5)
        random_direction(r, d->dimensions, d->disk[i].velocity);
    if (speeds == ONE_MOVES)
        random_direction(r, d->dimensions, d->disk[0].velocity);
}

static void make_box(struct disks *d, const struct scene *s)
{
    const double pi = 3.14159265358979324;
    const double each = s->dimensions == 2 ? pi / 4 : pi / 6;
    const double big =
        s->radii == GIANT ? pow(6, (double)s->dimensions) : 0;
    const double volume = ((double)s->count + big) * each / s->packing;
    const double side = pow(volume, 1 / (double)s->dimensions);
    for (size_t k = 0; k < s->dimensions; ++k)
        d->box[k] = side;
    if (s->aspect > 0) {
        d->box[0] *= s->aspect;
        d->box[1] /= s->aspect;
    }
}

/* Whether no two overlap, by more than rounding. */
static bool is_apart(const struct disks *d)
{
    size_t a, b;
    return disks_fit(d, &a, &b);
}

static double weight; /* of the scenes to come: gravity, m/s2 */

/* Makes the same disks whenever it is called with the same numbers. */
static void make(struct disks *d, const struct scene *s, uint64_t seed)
{
    SEEDED(r, seed);
    UNIT_MUST(disks_create(d, s->dimensions, s->count));
    d->boundary = s->boundary;
    d->restitution = s->restitution;
    for (size_t i = 0; i < s->count; ++i) {
        const double a = radius_of(s->radii, i, &r);
        d->disk[i].radius = a;
        d->mass[i] = s->radii == EQUAL    ? 1
                     : s->radii == GIANT  ? (a > 1 ? 200 : 1)
                     : s->radii == POINTS ? 0.1 + a
                                          : random_between(&r, 0.5, 4);
    }
    make_box(d, s);
    d->gravity = weight;
    UNIT_MUST(s->random ? disks_place_random(d, &r)
                        : disks_place_lattice(d));
    UNIT_MUST(is_apart(d));
    throw_them(d, s->speeds, &r);
}

/* Says what differs between two runs; NULL when no bit does. */
static const char *differs(const struct disks *a, const struct disks *b)
{
    const size_t n = a->count;
    return a->collisions != b->collisions ? "the collisions"
           : a->wall_collisions != b->wall_collisions
               ? "the collisions with walls"
           : memcmp(&a->now, &b->now, sizeof a->now)          ? "the clock"
           : memcmp(a->disk, b->disk, n * sizeof *a->disk)    ? "a disk"
           : memcmp(a->hits, b->hits, n * sizeof *a->hits)    ? "the hits"
           : memcmp(&a->virial, &b->virial, sizeof a->virial) ? "the virial"
           : memcmp(a->impulse, b->impulse, sizeof a->impulse)
               ? "the impulse"
               : NULL;
}

/* Folds the bytes of all that differs() looks at into one number. */
static uint64_t fold(uint64_t h, const void *from, size_t bytes)
{
    for (const unsigned char *b = from; bytes > 0; ++b, --bytes)
        h = (h ^ *b) * 1099511628211u;
    return h;
}

static uint64_t bytes_of(const struct disks *d)
{
    uint64_t h = 14695981039346656037u;
    h = fold(h, d->disk, d->count * sizeof *d->disk);
    h = fold(h, d->hits, d->count * sizeof *d->hits);
    h = fold(h, &d->virial, sizeof d->virial);
    h = fold(h, d->impulse, sizeof d->impulse);
    return fold(h, &d->now, sizeof d->now);
}

/* A run of both engines, cut into calls. */
struct race {
    struct disks pairs, cells;
    struct cells c;
    uint64_t ended[DISKS_COLLAPSE + 1]; /* calls, by what ended them */
};

/* As many lanes as the machine has, or fewer. */
static void take_lanes(struct cells *c, uint64_t seed)
{
    static const size_t lanes[] = {1, 8, 4};
    if (lanes[seed % 3] < c->lanes)
        c->lanes = lanes[seed % 3];
}

static void start(struct race *x, const struct scene *s, uint64_t seed)
{
    *x = (struct race){0};
    make(&x->pairs, s, seed);
    make(&x->cells, s, seed);
    if (!cells_suit(&x->cells))
        printf("# %zu-D, %zu disks, packing %g\n", s->dimensions, s->count,
               s->packing);
    UNIT_MUST(cells_suit(&x->cells));
    UNIT_MUST(disks_plan(&x->pairs) && cells_create(&x->c, &x->cells));
    take_lanes(&x->c, seed);
}

static void finish(struct race *x)
{
    cells_free(&x->c);
    disks_free(&x->pairs);
    disks_free(&x->cells);
}

static bool alone; /* without pairs, which take most of the time */

static const char *step(struct race *x, double until, uint64_t collisions)
{
    const enum disks_stop b = cells_run(&x->c, until, collisions);
    ++x->ended[b];
    if (alone)
        return NULL;
    const enum disks_stop a = disks_run(&x->pairs, until, collisions);
    return a != b ? "the end" : differs(&x->pairs, &x->cells);
}

/* Runs on to so many collisions, in calls of all lengths that end by the
   time or by the count; stops at a collapse, or when nobody moves. */
static const char *run_on(struct race *x, uint64_t collisions,
                          struct random *r)
{
    const char *wrong = NULL;
    while (!wrong && x->cells.collisions < collisions &&
           x->ended[DISKS_COLLAPSE] == 0) {
        const uint64_t before = x->cells.collisions;
        const uint64_t left = collisions - before;
        const uint64_t more = 1 + random_below(r, left);
        const double now = x->cells.now;
        const uint64_t calls = x->ended[DISKS_TIME];
        wrong = step(x, INFINITY, before + more);
        if (x->ended[DISKS_TIME] > calls)
            break; /* nothing happens any more */
        const double length = x->cells.now - now;
        if (!wrong && random_below(r, 2) && length > 0)
            wrong = step(x, x->cells.now + length * random_uniform(r),
                         UINT64_MAX);
    }
    return wrong;
}

/* How often j is in the list of i. */
static size_t times_listed(const struct cells *c, size_t i, size_t j)
{
    size_t n = 0;
    for (size_t k = 0; k < c->anchor[i].neighbours; ++k)
        n += c->neighbour[i * c->seats + k] == j;
    return n;
}

/* Neighbours know each other, once, and free seats hold the disk itself. */
static bool lists_are_fair(const struct cells *c)
{
    bool fair = true;
    for (size_t i = 0; i < c->d->count; ++i)
        for (size_t k = 0; k < c->seats; ++k) {
            const size_t j = c->neighbour[i * c->seats + k];
            fair = fair && (k < c->anchor[i].neighbours
                                ? j != i && times_listed(c, i, j) == 1 &&
                                      times_listed(c, j, i) == 1
                                : j == i);
        }
    return fair;
}

/* Runs a scene with both engines, in some starts; returns the bytes of
   the ends. */
static uint64_t compare(const struct scene *s, uint64_t seeds)
{
    uint64_t h = 0;
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
        struct race x;
        SEEDED(r, seed);
        start(&x, s, seed);
        const char *wrong = run_on(&x, s->collisions, &r);
        if (wrong)
            printf("# %zu-D, %zu disks, packing %g, radii %d, speeds %d, "
                   "e = %g, %s, seed %llu: %s differs after %llu "
                   "collisions, t = %.17g\n",
                   s->dimensions, s->count, s->packing, (int)s->radii,
                   (int)s->speeds, s->restitution,
                   s->boundary == DISKS_WALLS      ? "walls"
                   : s->boundary == DISKS_PERIODIC ? "periodic"
                                                   : "floor",
                   (unsigned long long)seed, wrong,
                   (unsigned long long)x.cells.collisions, x.cells.now);
        UNIT_TRUE(wrong == NULL);
        UNIT_TRUE(s->restitution < 1 || is_apart(&x.cells));
        UNIT_TRUE(lists_are_fair(&x.c));
        h = fold(h, &(uint64_t){bytes_of(&x.cells)}, sizeof h);
        finish(&x);
    }
    return h;
}

static uint64_t folded; /* of all that was compared */

static void compare_all(const struct scene scenes[], size_t n,
                        uint64_t seeds)
{
    for (size_t k = 0; k < n; ++k) {
        const uint64_t h = compare(&scenes[k], seeds);
        folded = fold(folded, &h, sizeof h);
    }
}

#define COMPARE(scenes, seeds)                                             \
    compare_all(scenes, sizeof scenes / sizeof scenes[0], seeds)

TEST(test_plane, "in the plane cells give the bits of pairs")
{
    static const struct scene scenes[] = {
        {2, 150, DISKS_PERIODIC, 0.02, EQUAL, NORMAL, 1, 800, 0, false},
        {2, 150, DISKS_PERIODIC, 0.3, EQUAL, NORMAL, 1, 2000, 0, true},
        {2, 180, DISKS_PERIODIC, 0.7, EQUAL, NORMAL, 1, 3000, 0, false},
        {2, 168, DISKS_PERIODIC, 0.88, EQUAL, ONE_SPEED, 1, 3000, 0.995,
         false},
        {2, 100, DISKS_WALLS, 0.01, EQUAL, ONE_SPEED, 1, 400, 0, false},
        {2, 200, DISKS_WALLS, 0.4, EQUAL, NORMAL, 1, 2000, 0, true},
        {2, 180, DISKS_WALLS, 0.7, EQUAL, NORMAL, 1, 3000, 0, false},
        {2, 7, DISKS_WALLS, 0.3, EQUAL, NORMAL, 1, 2000, 0, true},
        {2, 2, DISKS_WALLS, 0.2, EQUAL, NORMAL, 1, 500, 0, true},
        {2, 200, DISKS_PERIODIC, 0.1, EQUAL, NORMAL, 1, 1000, 3, false},
        {2, 200, DISKS_WALLS, 0.05, EQUAL, NORMAL, 1, 800, 5, false}};
    COMPARE(scenes, 2);
}

TEST(test_space, "in space cells give the bits of pairs")
{
    static const struct scene scenes[] = {
        {3, 300, DISKS_PERIODIC, 0.02, EQUAL, NORMAL, 1, 600, 0, false},
        {3, 256, DISKS_PERIODIC, 0.3, EQUAL, NORMAL, 1, 2000, 0, false},
        {3, 256, DISKS_PERIODIC, 0.49, EQUAL, NORMAL, 1, 3000, 0, false},
        {3, 500, DISKS_PERIODIC, 0.7, EQUAL, ONE_SPEED, 1, 1500, 0, false},
        {3, 200, DISKS_WALLS, 0.02, EQUAL, NORMAL, 1, 600, 0, true},
        {3, 200, DISKS_WALLS, 0.3, EQUAL, NORMAL, 1, 2000, 0, false},
        {3, 3, DISKS_WALLS, 0.1, EQUAL, NORMAL, 1, 1000, 0, true},
        {3, 300, DISKS_PERIODIC, 0.1, EQUAL, NORMAL, 1, 2000, 1.2, false}};
    COMPARE(scenes, 2);
}

TEST(test_mixed, "mixed radii and masses give the same bits")
{
    static const struct scene scenes[] = {
        {2, 150, DISKS_PERIODIC, 0.4, TWO, NORMAL, 1, 3000, 0, true},
        {2, 150, DISKS_WALLS, 0.6, TWO, NORMAL, 1, 3000, 0, false},
        {2, 150, DISKS_PERIODIC, 0.5, SPREAD, NORMAL, 1, 3000, 0, false},
        {2, 150, DISKS_WALLS, 0.4, SPREAD, ONE_SPEED, 1, 3000, 0, true},
        {3, 200, DISKS_PERIODIC, 0.4, SPREAD, NORMAL, 1, 3000, 0, false},
        {3, 200, DISKS_WALLS, 0.3, TWO, NORMAL, 1, 3000, 0, false},
        {2, 150, DISKS_PERIODIC, 0.3, POINTS, NORMAL, 1, 3000, 0, true},
        {3, 200, DISKS_WALLS, 0.2, POINTS, NORMAL, 1, 3000, 0, true}};
    COMPARE(scenes, 2);
}

TEST(test_giant, "a heavy giant gives the same bits")
{
    static const struct scene scenes[] = {
        {2, 300, DISKS_PERIODIC, 0.3, GIANT, NORMAL, 1, 2000, 0, false},
        {2, 300, DISKS_WALLS, 0.3, GIANT, NORMAL, 1, 2000, 0, false},
        {2, 300, DISKS_PERIODIC, 0.6, GIANT, ONE_SPEED, 1, 2000, 0, false},
        {2, 40, DISKS_WALLS, 0.1, GIANT, NORMAL, 1, 3000, 0, true},
        {3, 500, DISKS_WALLS, 0.3, GIANT, NORMAL, 1, 2000, 0, false},
        {3, 900, DISKS_PERIODIC, 0.1, GIANT, NORMAL, 1, 800, 0, false}};
    COMPARE(scenes, 2);
}

TEST(test_inelastic, "inelastic disks give the same bits")
{
    static const struct scene scenes[] = {
        {2, 150, DISKS_PERIODIC, 0.3, EQUAL, NORMAL, 0.95, 2500, 0, true},
        {2, 150, DISKS_WALLS, 0.3, SPREAD, NORMAL, 0.9, 2500, 0, true},
        {2, 150, DISKS_PERIODIC, 0.2, EQUAL, NORMAL, 0.5, 4000, 0, true},
        {2, 60, DISKS_WALLS, 0.5, EQUAL, NORMAL, 0.1, 4000, 0, false},
        {2, 60, DISKS_PERIODIC, 0.3, EQUAL, NORMAL, 0, 3000, 0, false},
        {3, 200, DISKS_PERIODIC, 0.2, EQUAL, NORMAL, 0.7, 3000, 0, false},
        {3, 200, DISKS_WALLS, 0.3, TWO, NORMAL, 0.2, 3000, 0, false}};
    COMPARE(scenes, 2);
}

/* Light and heavy gravity, for ways that bend a little or a lot, between
   four walls and on a floor alone; in the last scene most disks never rise
   by their own diameter. */
TEST(test_weight, "under gravity cells give the bits of pairs")
{
    static const double weights[] = {0, 1e-3, 0.1, 3};
    struct scene scenes[] = {
        {2, 100, DISKS_WALLS, 0.01, EQUAL, ONE_SPEED, 1, 400, 0, false},
        {2, 200, DISKS_WALLS, 0.4, EQUAL, NORMAL, 1, 2000, 0, true},
        {2, 150, DISKS_WALLS, 0.1, SPREAD, NORMAL, 1, 2000, 0.3, true},
        {3, 200, DISKS_WALLS, 0.1, EQUAL, NORMAL, 1, 2000, 0, true},
        {2, 150, DISKS_WALLS, 0.3, TWO, NORMAL, 0.97, 2500, 0, true}};
    for (int on_floor = 0; on_floor < 2; ++on_floor) {
        for (size_t i = 0; on_floor && i < 5; ++i)
            scenes[i].boundary = DISKS_FLOOR;
        for (size_t k = 0; k < 4; ++k) {
            weight = weights[k];
            COMPARE(scenes, 1);
        }
    }
    weight = 0;
}

/* Disks that rest until they are hit: times that are no number lurk. */
TEST(test_rest, "disks at rest give the same bits")
{
    static const struct scene scenes[] = {
        {2, 150, DISKS_PERIODIC, 0.3, EQUAL, REST, 1, 1500, 0, true},
        {2, 150, DISKS_WALLS, 0.6, TWO, REST, 1, 1500, 0, false},
        {2, 150, DISKS_WALLS, 0.2, EQUAL, ONE_MOVES, 1, 1500, 0, true},
        {2, 150, DISKS_PERIODIC, 0.4, EQUAL, ONE_MOVES, 0.6, 2500, 0,
         false},
        {3, 200, DISKS_PERIODIC, 0.3, EQUAL, REST, 0.8, 2500, 0, false},
        {3, 200, DISKS_WALLS, 0.3, SPREAD, ONE_MOVES, 1, 1500, 0, false}};
    COMPARE(scenes, 2);
}

/* Squares of disks at whole numbers, all speeds 1 along an axis: many
   events at each time, and no number is rounded. */
static void make_square(struct disks *d, size_t side,
                        enum disks_boundary boundary, double radius,
                        uint64_t seed, bool diagonal)
{
    SEEDED(r, seed);
    UNIT_MUST(disks_create(d, 2, side * side));
    d->boundary = boundary;
    d->box[0] = d->box[1] = (double)side + (radius < 0.5 ? 0 : 1);
    for (size_t i = 0; i < d->count; ++i) {
        struct disk *a = &d->disk[i];
        PUT(a->position, (double)(i % side) + 0.5,
            (double)(i / side) + 0.5);
        a->radius = radius;
        a->velocity[random_below(&r, 2)] = random_below(&r, 2) ? 1 : -1;
        if (diagonal)
            for (size_t k = 0; k < 2; ++k)
                a->velocity[k] = random_below(&r, 2) ? 1 : -1;
    }
}

static void race_square(size_t side, enum disks_boundary boundary,
                        double radius, uint64_t seed, bool diagonal,
                        uint64_t collisions)
{
    struct race x = {0};
    const char *wrong = NULL;
    make_square(&x.pairs, side, boundary, radius, seed, diagonal);
    make_square(&x.cells, side, boundary, radius, seed, diagonal);
    UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
    take_lanes(&x.c, seed);
    for (uint64_t k = 1;
         !wrong && k <= collisions && x.ended[DISKS_COLLAPSE] == 0;
         k += 1 + k / 50)
        wrong = k % 3
                    ? step(&x, INFINITY, k)
                    : step(&x, floor(x.cells.now * 8 + 1) / 8, UINT64_MAX);
    if (wrong)
        printf("# side %zu, boundary %d, radius %g, seed %llu: %s differs "
               "after %llu collisions, t = %.17g\n",
               side, (int)boundary, radius, (unsigned long long)seed, wrong,
               (unsigned long long)x.cells.collisions, x.cells.now);
    UNIT_TRUE(wrong == NULL);
    UNIT_TRUE(radius == 0.5 || x.ended[DISKS_COLLAPSE] == 0);
    UNIT_TRUE(is_apart(&x.cells));
    folded = fold(folded, &(uint64_t){bytes_of(&x.cells)}, sizeof folded);
    finish(&x);
}

TEST(test_ties, "many events at one time give the same bits")
{
    for (uint64_t seed = 1; seed <= 4; ++seed) {
        const bool diagonal = seed % 2;
        race_square(12, DISKS_PERIODIC, 0.25, seed, diagonal, 2000);
        race_square(12, DISKS_WALLS, 0.25, seed, diagonal, 2000);
        race_square(9, DISKS_WALLS, 0.5, seed, diagonal, 1500);
        race_square(10, DISKS_PERIODIC, 0.5, seed, diagonal, 1500);
        race_square(8, DISKS_PERIODIC, 0.125, seed, diagonal, 2000);
    }
    /* Of two hundred the one where eight lanes at a time have to see that
       two meet at one time in one lane: mostly another's plan mends it. */
    race_square(10, DISKS_PERIODIC, 0.5, 169, true, 1000);
}

/* The narrowest boxes that suit: three cells along an axis, so that the
   cells on both sides of a cell are all there are. */
TEST(test_three_cells, "three cells along an axis are enough")
{
    size_t three = 0;
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions)
        for (size_t n = 3; n < 60; n += 1 + n / 3) {
            struct scene s = {
                dimensions, n,   DISKS_PERIODIC, 0.6, EQUAL, NORMAL, 1, 400,
                0,          true};
            struct disks d = {0};
            do { /* wider */
                disks_free(&d);
                s.packing *= 0.97;
                s.random = s.packing < 0.25;
                UNIT_MUST(disks_create(&d, dimensions, n));
                for (size_t i = 0; i < n; ++i)
                    d.disk[i].radius = 0.5;
                d.boundary = DISKS_PERIODIC;
                make_box(&d, &s);
            } while (!cells_suit(&d) || !disks_place_lattice(&d));
            struct cells c;
            UNIT_MUST(cells_create(&c, &d));
            three += c.grid[0] == 3 && c.grid[1] == 3 &&
                     c.grid[2] == (dimensions == 3 ? 3 : 1);
            cells_free(&c);
            disks_free(&d);
            compare_all(&s, 1, 2);
        }
    UNIT_TRUE(three >= 10);
}

TEST(test_suit, "a box too narrow does not suit")
{
    CREATED(disks, d, 2, 4);
    for (size_t i = 0; i < 4; ++i)
        d.disk[i].radius = 0.5;
    d.boundary = DISKS_PERIODIC;
    PUT(d.box, 100, 2.9);
    UNIT_TRUE(!cells_suit(&d));
    d.boundary = DISKS_WALLS;
    UNIT_TRUE(cells_suit(&d));
    d.boundary = DISKS_PERIODIC;
    d.box[1] = 100;
    UNIT_TRUE(cells_suit(&d));
    d.disk[0].radius = 40;
    UNIT_TRUE(!cells_suit(&d));
}

/* A run that is taken up again: places far outside of the box, a clock
   that does not begin at 0, disks that have hit at other times. */
TEST(test_taken_up, "a run taken up again gives the same bits")
{
    static const struct scene scenes[] = {
        {2, 150, DISKS_PERIODIC, 0.4, TWO, NORMAL, 1, 0, 0, true},
        {2, 150, DISKS_WALLS, 0.4, EQUAL, NORMAL, 1, 0, 0, true},
        {3, 200, DISKS_PERIODIC, 0.3, EQUAL, NORMAL, 1, 0, 0, false}};
    for (size_t k = 0; k < 3; ++k) {
        struct race x;
        start(&x, &scenes[k], 5);
        UNIT_TRUE(!step(&x, INFINITY, 1500));
        UNIT_TRUE(!step(&x, x.cells.now * 1.001, UINT64_MAX));
        cells_free(&x.c);
        if (scenes[k].boundary == DISKS_PERIODIC)
            for (size_t i = 0; i < x.cells.count; ++i) {
                const double far = 1000 * (double)(i % 7) - 3000;
                x.pairs.disk[i].position[1] += far * x.pairs.box[1];
                x.cells.disk[i].position[1] += far * x.cells.box[1];
            }
        UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
        UNIT_TRUE(!step(&x, INFINITY, 3000));
        disks_settle(&x.pairs);
        disks_settle(&x.cells);
        cells_free(&x.c);
        UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
        UNIT_TRUE(!step(&x, INFINITY, 1500));
        UNIT_TRUE(is_apart(&x.cells));
        folded =
            fold(folded, &(uint64_t){bytes_of(&x.cells)}, sizeof folded);
        finish(&x);
    }
}

/* Two disks that part in an endless silence, and none that moves at all:
   the clock goes where it is asked to, but not to infinity. */
TEST(test_silence, "when nothing happens the clock stays finite")
{
    struct scene s = {2,         20, DISKS_WALLS, 0.1, EQUAL,
                      ONE_MOVES, 1,  0,           0,   false};
    for (int k = 0; k < 2; ++k) {
        struct race x;
        start(&x, &s, 1);
        if (k == 0)
            for (size_t i = 0; i < 2; ++i)
                x.pairs.disk[0].velocity[i] = x.cells.disk[0].velocity[i] =
                    0;
        cells_free(&x.c);
        UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
        UNIT_TRUE(!step(&x, 0.25, UINT64_MAX));
        UNIT_EQUAL(x.cells.now, 0.25);
        UNIT_TRUE(!step(&x, 0.125, UINT64_MAX)); /* no way back */
        UNIT_EQUAL(x.cells.now, 0.25);
        UNIT_TRUE(!step(&x, 1e9, 5));
        UNIT_TRUE(!step(&x, 2e9, 0));
        UNIT_TRUE(!step(&x, k == 0 ? INFINITY : x.cells.now, UINT64_MAX));
        UNIT_TRUE(isfinite(x.cells.now));
        finish(&x);
    }
}

/* Fast and slow, light and heavy: the calendar's first guess is wrong. */
TEST(test_units, "any unit gives the same bits")
{
    static const double units[][3] = {/* of length, time and mass */
                                      {1e-9, 1e-12, 1e-26},
                                      {1e9, 1e3, 1e24},
                                      {1e-3, 1e5, 1e-9}};
    for (size_t u = 0; u < 3; ++u)
        for (size_t dimensions = 2; dimensions <= 3; ++dimensions) {
            struct scene s = {
                dimensions, 200, DISKS_PERIODIC, 0.3, SPREAD, NORMAL, 1,
                0,          0,   false};
            struct race x;
            start(&x, &s, u);
            cells_free(&x.c);
            for (int both = 0; both < 2; ++both) {
                struct disks *d = both ? &x.pairs : &x.cells;
                for (size_t k = 0; k < DISKS_AXES; ++k)
                    d->box[k] *= units[u][0];
                for (size_t i = 0; i < d->count; ++i) {
                    d->mass[i] *= units[u][2];
                    d->disk[i].radius *= units[u][0];
                    for (size_t k = 0; k < DISKS_AXES; ++k) {
                        d->disk[i].position[k] *= units[u][0];
                        d->disk[i].velocity[k] *= units[u][0] / units[u][1];
                    }
                }
            }
            UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
            UNIT_TRUE(!step(&x, INFINITY, 3000));
            UNIT_TRUE(is_apart(&x.cells));
            finish(&x);
        }
}

/* Two disks, not alone, that fly at each other and meet as both come to
   the ends of their skins: nearly out of reach. */
static void make_last_moment(struct disks *d, uint64_t seed, double skin)
{
    SEEDED(r, seed);
    double e[DISKS_AXES] = {0};
    UNIT_MUST(disks_create(d, seed % 2 ? 2 : 3, 8));
    d->boundary = seed % 3 ? DISKS_PERIODIC : DISKS_WALLS;
    random_direction(&r, d->dimensions, e);
    for (size_t i = 0; i < 8; ++i)
        d->disk[i].radius = 0.1;
    d->disk[0].radius = 0.5;
    d->disk[1].radius = seed % 4 ? 0.5 : 0.3;
    for (size_t k = 0; k < d->dimensions; ++k) {
        d->box[k] = 40;
        const double x =
            d->boundary == DISKS_WALLS ? 20 : random_between(&r, 0, 40);
        for (size_t i = 2; i < 8; ++i)
            d->disk[i].position[k] =
                fmod(x + 18 + 0.3 * (double)i * (k == 0), 39) + 0.5;
        for (size_t i = 0; i < 2; ++i) {
            struct disk *a = &d->disk[i];
            const double far = a->radius + 0.9999 * skin;
            a->position[k] = x + (i ? far : -far) * e[k];
            a->velocity[k] = i ? -e[k] : e[k];
        }
    }
}

TEST(test_last_moment, "a meeting at the ends of both skins")
{
    for (uint64_t seed = 1; seed <= 120; ++seed) {
        struct race x = {0};
        struct disks d;
        struct cells c;
        make_last_moment(&d, seed, 0);
        UNIT_MUST(cells_create(&c, &d));
        make_last_moment(&x.pairs, seed, c.skin);
        make_last_moment(&x.cells, seed, c.skin);
        UNIT_MUST(disks_plan(&x.pairs) && cells_create(&x.c, &x.cells));
        UNIT_TRUE(is_apart(&x.cells));
        UNIT_TRUE(!step(&x, INFINITY, 1));
        UNIT_NEAR(x.cells.now, c.skin, 1e-3 * c.skin);
        UNIT_TRUE(is_apart(&x.cells));
        cells_free(&c);
        disks_free(&d);
        finish(&x);
    }
}

/* Puts disk b a hair too near to disk a. */
static void plant(struct disks *d, size_t a, size_t b, double hair)
{
    const double least =
        (d->disk[a].radius + d->disk[b].radius) * (1 - hair);
    memcpy(d->disk[b].position, d->disk[a].position,
           sizeof d->disk[b].position);
    d->disk[b].position[0] += least * 0.6;
    d->disk[b].position[1] += least * 0.8;
}

TEST(test_fit, "cells find an overlap where pairs find it")
{
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions)
        for (uint64_t seed = 1; seed <= 60; ++seed) {
            const struct scene s = {
                dimensions, 150,    seed % 2 ? DISKS_WALLS : DISKS_PERIODIC,
                0.2,        SPREAD, NORMAL,
                1,          0,      0,
                true};
            SEEDED(r, seed);
            size_t a = 0, b = 0, p = 0, q = 0;
            MADE(disks, d, make(&d, &s, seed));
            if (seed > 4) {
                const size_t i = seed % 4 ? random_below(&r, 150) : 0;
                const size_t j = seed % 4 ? random_below(&r, 150) : 1;
                if (i != j)
                    plant(&d, i, j, seed % 3 ? 1e-5 : 1e-12);
            }
            if (seed % 5 == 0)
                d.disk[seed].position[0] = d.box[0] - 0.01;
            if (seed % 7 == 0)
                d.disk[seed].position[1] += 5 * d.box[1];
            CREATED(cells, c, &d);
            const bool pairs = disks_fit(&d, &a, &b);
            const bool cells = cells_fit(&c, &p, &q);
            UNIT_TRUE(pairs == cells);
            UNIT_TRUE(pairs || (a == p && b == q));
            UNIT_TRUE(seed > 4 || pairs);
        }
}

int main(int argc, char *argv[])
{
    alone = argc > 1 && strcmp(argv[1], "bytes") == 0;
    const int status = unit_run("cells");
    if (alone)
        printf("%zu %016llx\n", cells_lanes(), (unsigned long long)folded);
    return status;
}
