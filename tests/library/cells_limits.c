/* What cells promise beside the bits of pairs: which boxes suit them, how
   thick the skin is and how wide the cells, who is whose neighbour, and
   that no disk gets farther from its anchor than the skin. A skin of
   another length would have the same bits, as long as all this holds. */
#include "unit.h"

#include "box/cells.h"

/* Disks in a box, with no places yet. */
static void make(struct disks *d, size_t dimensions, size_t count,
                 enum disks_boundary boundary, const double box[],
                 double radius)
{
    UNIT_MUST(disks_create(d, dimensions, count));
    d->boundary = boundary;
    memcpy(d->box, box, dimensions * sizeof *box);
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = radius;
}

/* Anywhere in the box, which is far too much for overlaps to matter. */
static void scatter(struct disks *d, uint64_t seed)
{
    SEEDED(r, seed);
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < d->dimensions; ++k)
            d->disk[i].position[k] = random_between(&r, 0, d->box[k]);
}

/* Ten neighbours and the disk itself share a circle, twelve spheres a
   sphere; where that is too small, three tenths of a mean diameter are the
   least. Round a box the widest two must see each other by one image alone,
   and three cells have to have room: 0.999 of that. */
TEST(test_skin, "skin and cells have the sizes of the rules")
{
    static const struct {
        size_t dimensions, count;
        enum disks_boundary boundary;
        double box[3], radius[3], skin;
        size_t grid[3];
    } boxes[] = {
        /* far = sqrt(11 (200 / 100) / pi) = 2.6463 */
        {2,
         100,
         DISKS_WALLS,
         {20, 10},
         {.05, .05, .05},
         1.273142,
         {7, 3, 1}},
        /* cbrt(12 (6000 / 1000) / (4 pi / 3)) = 2.5808 */
        {3,
         1000,
         DISKS_PERIODIC,
         {10, 20, 30},
         {.1, .1, .1},
         1.190381,
         {3, 7, 11}},
        {2, 100, DISKS_WALLS, {8.5, 8.5}, {.5, .5, .5}, 0.3, {5, 5, 1}},
        {3, 27, DISKS_WALLS, {3, 3, 3}, {.5, .5, .5}, 0.3, {1, 1, 1}},
        /* (10 / 2 - 1) / 4 = 1, and 5 / 6 - 1 / 2 = 1 / 3 */
        {2, 4, DISKS_PERIODIC, {10, 50}, {.5, .5, .5}, .999, {3, 5, 1}},
        {2, 4, DISKS_PERIODIC, {50, 5}, {.5, .5, .5}, .333, {11, 3, 1}},
        /* only the first axis wraps */
        {2, 4, DISKS_FLOOR, {10, 5}, {.5, .5, .5}, .999, {3, 1, 1}},
        {3, 4, DISKS_FLOOR, {50, 5, 10}, {.5, .5, .5}, .999, {11, 1, 3}},
        /* means .8 / 3, .4 and .5 + .2, wherever the widest are */
        {2, 3, DISKS_PERIODIC, {10, 50}, {.5, .1, .2}, 1.073925, {3, 5, 1}},
        {2, 3, DISKS_PERIODIC, {10, 50}, {.2, .5, .1}, 1.073925, {3, 5, 1}},
        {2, 3, DISKS_PERIODIC, {10, 50}, {.1, .2, .5}, 1.073925, {3, 5, 1}},
        {2, 3, DISKS_WALLS, {3, 3}, {.5, .2, .5}, 1.22052, {1, 1, 1}},
        /* 3 + 2 x 2 cells are enough for two */
        {2, 2, DISKS_WALLS, {1000, 1}, {.1, .1, .1}, 20.8207, {7, 1, 1}}};
    for (size_t b = 0; b < sizeof boxes / sizeof boxes[0]; ++b) {
        double longest = 0;
        MADE(disks, d,
             make(&d, boxes[b].dimensions, boxes[b].count,
                  boxes[b].boundary, boxes[b].box, 0));
        for (size_t i = 0; i < d.count; ++i)
            d.disk[i].radius = boxes[b].radius[i % 3];
        scatter(&d, 1);
        CREATED(cells, c, &d);
        for (size_t k = 0; k < 3; ++k) {
            UNIT_EQUAL(c.grid[k], boxes[b].grid[k]);
            longest = fmax(longest, boxes[b].box[k]);
            UNIT_EQUAL(c.inverse[k], disks_wraps(&d, k) ? 1 / d.box[k] : 0);
        }
        UNIT_NEAR(c.skin, boxes[b].skin, 1e-5 * boxes[b].skin);
        UNIT_EQUAL(c.slack, 1e-6 * longest);
        UNIT_EQUAL(c.cells, c.grid[0] * c.grid[1] * c.grid[2]);
    }
}

static bool suits(size_t dimensions, size_t count,
                  enum disks_boundary boundary, const double box[],
                  double radius)
{
    MADE(disks, d, make(&d, dimensions, count, boundary, box, radius));
    const bool suit = cells_suit(&d);
    return suit;
}

/* A skin of a tenth of a radius is too thin, and so is one of a millionth
   of the box: (6.6 / 6 - 1) 0.999 is a tenth. */
TEST(test_suit, "which boxes suit")
{
    const double box[] = {6.6007, 6.6007, 6.6007};
    const double narrow[] = {6.6005, 6.6005, 6.6005};
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions) {
        UNIT_TRUE(suits(dimensions, 4, DISKS_PERIODIC, box, 1));
        UNIT_TRUE(!suits(dimensions, 4, DISKS_PERIODIC, narrow, 1));
        UNIT_TRUE(suits(dimensions, 4, DISKS_WALLS, narrow, 1));
        for (int end = 0; end < 2; ++end) {
            const double limit = end ? 1e15 : 1e-12;
            for (int side = -1; side <= 1; ++side) {
                const double l = limit * (1 + 1e-3 * side);
                const double sides[] = {l / 2, l, l / 3};
                UNIT_TRUE(suits(dimensions, 4, DISKS_WALLS, sides, l / 9) ==
                          (end ? side < 0 : side > 0));
            }
        }
    }
    /* sqrt(11 (1 / 20) / pi) / 2 is 0.209, and a millionth of 1e6 is 1 */
    UNIT_TRUE(!suits(2, 20, DISKS_WALLS, (double[]){1e6, 1e-6}, 0));
    UNIT_TRUE(suits(2, 20, DISKS_WALLS, (double[]){1e4, 1e-6}, 0));
}

/* The anchor of disk i. */
static void anchor(const struct cells *c, size_t i, double at[])
{
    const struct cells_anchor *a = &c->anchor[i];
    for (size_t k = 0; k < DISKS_AXES; ++k)
        at[k] = (double)c->place[(3 * a->cell + k) * c->room + a->spot];
}

static double length(const double x[])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/* Counts neighbours that miss in a list, and others that are in it. */
static size_t wrong_neighbours(const struct cells *c)
{
    size_t wrong = 0;
    for (size_t i = 0; i < c->d->count; ++i)
        for (size_t j = 0; j < c->d->count; ++j) {
            double a[DISKS_AXES], b[DISKS_AXES], apart[DISKS_AXES];
            size_t listed = 0;
            anchor(c, i, a);
            anchor(c, j, b);
            disks_separation(c->d, a, b, apart);
            for (size_t k = 0; k < c->anchor[i].neighbours; ++k)
                listed += c->neighbour[i * c->seats + k] == j;
            const double reach =
                c->d->disk[i].radius + c->d->disk[j].radius + 2 * c->skin;
            const double far = length(apart) - reach;
            wrong += i == j                 ? listed
                     : far <= 0             ? listed != 1
                     : far > 1.5 * c->slack ? listed
                                            : listed > 1;
        }
    return wrong;
}

/* Counts disks that are farther from their anchors than the skin. */
static size_t runaways(const struct cells *c)
{
    size_t away = 0;
    for (size_t i = 0; i < c->d->count; ++i) {
        double a[DISKS_AXES], b[DISKS_AXES], apart[DISKS_AXES];
        anchor(c, i, a);
        disks_position(c->d, i, b);
        disks_separation(c->d, a, b, apart);
        away += !(length(apart) <= c->skin + c->slack);
    }
    return away;
}

/* Thin and dense, alike and mixed, at rest and in a crowd that comes to one
   corner; the lists when they are new and as they become, at every event.
 */
TEST(test_neighbours, "all neighbours are listed, and no others")
{
    static const double sides[] = {30, 20, 12};
    for (int n = 0; n < 48; ++n) {
        const size_t dimensions = n % 2 ? 2 : 3;
        const bool crowd = n % 3 == 2;
        SEEDED(r, (uint64_t)n);
        size_t wrong = 0, away = 0;
        MADE(disks, d, make(&d, dimensions, 60, n / 2 % 3, sides, 0.1));
        d.gravity = d.boundary != DISKS_PERIODIC && n / 6 % 2 ? 0.7 : 0;
        for (size_t i = 0; n % 4 < 2 && i < d.count; ++i)
            d.disk[i].radius = i == 9 ? 0.7 : 0.02 * (double)(i % 7);
        UNIT_MUST(disks_place_random(&d, &r) && cells_suit(&d));
        disks_set_speed(&d, n % 5 ? 1 : 0, &r);
        for (size_t i = 0; crowd && i < d.count; ++i)
            for (size_t k = 0; k < dimensions; ++k)
                d.disk[i].velocity[k] = (2 - d.disk[i].position[k]) / 9;
        CREATED(cells, c, &d);
        if (c.lanes > (n % 4 ? 1 : 8))
            c.lanes = n % 4 == 1 ? 1 : 4;
        wrong += wrong_neighbours(&c);
        for (int k = 1; k <= 60; ++k) {
            cells_run(&c, 0.15 * k, UINT64_MAX);
            away += runaways(&c);
            if (k % 6 == 0)
                wrong += wrong_neighbours(&c);
        }
        UNIT_EQUAL(wrong, 0);
        UNIT_EQUAL(away, 0);
        UNIT_TRUE(c.renewed > 0 || (n % 5 == 0 && !crowd));
    }
}

/* One disk that flies, and many points at rest in the farthest corner,
   which make the skin thin. The clock begins at as many seconds as there
   is gravity. */
static void begin_lonely(struct cells *c, struct disks *d, double gravity,
                         double x, const double v[2])
{
    enum { MANY = 100 };
    const double box[] = {200, 200};
    make(d, 2, MANY, DISKS_WALLS, box, 0);
    d->gravity = gravity;
    d->now = gravity;
    d->disk[0].radius = 0.125;
    PUT(d->disk[0].position, x, 128);
    memcpy(d->disk[0].velocity, v, 2 * sizeof *v);
    for (size_t i = 0; i < MANY; ++i)
        d->disk[i].since = d->now;
    for (size_t i = 1; i < MANY; ++i) {
        PUT(d->disk[i].position, 199, 199 - 0.01 * (double)i);
    }
    UNIT_MUST(cells_create(c, d));
}

/* A skin ends a thickness from the anchor: on a straight way, on the way
   back from a wall, and behind a wall that is met slantwise, each from an
   anchor 0.5 or so from the wall, which seven digits leave as it is. A disk
   at rest has no end. */
TEST(test_straight_end, "a straight flight ends a skin from the anchor")
{
    static const struct {
        double x, v[2], wall; /* s; the place of the wall is 0.125 */
    } ways[] = {{50, {3, 4}, 0},
                {50, {-0.5, 0}, 0},
                {0.625, {-2, 0}, 0.25},
                {0.625, {-1, 3}, 0.5},
                {0.625, {-1, 0.25}, 0.5}};
    for (size_t w = 0; w < sizeof ways / sizeof ways[0]; ++w) {
        FREED(disks) d;
        MADE(cells, c, begin_lonely(&c, &d, 0, ways[w].x, ways[w].v));
        const struct calendar_event *e = &c.calendar.event[0];
        const double speed = length(d.disk[0].velocity);
        double end = c.skin / speed;
        if (ways[w].wall > 0) {
            UNIT_EQUAL(e->time, ways[w].wall);
            UNIT_EQUAL(e->partner, d.count); /* across x */
            cells_run(&c, ways[w].wall, UINT64_MAX);
            UNIT_EQUAL(d.wall_collisions, 1);
            /* Where the skin ends, found by halving. */
            double low = ways[w].wall, high = 1e3;
            for (int k = 0; k < 60; ++k) {
                const double t = (low + high) / 2;
                const double x =
                    0.125 + fabs(ways[w].v[0]) * (t - ways[w].wall);
                const double way[] = {x - ways[w].x, ways[w].v[1] * t, 0};
                *(length(way) < c.skin ? &low : &high) = t;
            }
            end = low;
        }
        UNIT_NEAR(e->time, end, 1e-6 * end);
        UNIT_EQUAL(e->partner, 0); /* itself */
        cells_run(&c, end * (1 + 1e-5), UINT64_MAX);
        UNIT_EQUAL(c.renewed, 1);
        UNIT_TRUE(c.calendar.event[1].time == INFINITY);
    }
}

/* A disk that is found beyond its end, as by a rounding, renews its anchor
   at once. Here its anchor has been moved aside, and the wall turns it to a
   way on which it would never come within reach. */
TEST(test_beyond, "beyond the skin an anchor is renewed at once")
{
    FREED(disks) d;
    MADE(cells, c, begin_lonely(&c, &d, 0, 0.625, (const double[]){-1, 0}));
    const struct cells_anchor *a = &c.anchor[0];
    c.place[(3 * a->cell + 1) * c.room + a->spot] +=
        (float)(1.001 * c.skin);
    cells_run(&c, 0.5, 0);
    UNIT_EQUAL(runaways(&c), 1);
    cells_run(&c, 0.5, UINT64_MAX);
    UNIT_EQUAL(d.wall_collisions, 1);
    UNIT_EQUAL(c.renewed, 1);
    UNIT_EQUAL(runaways(&c), 0);
}

/* Under gravity a quarter of the skin is for falling, which takes at most
   the root of l / 2g, and three quarters are for the straight way. What
   falls fastest within that time comes nearest to the end, and not beyond.
 */
TEST(test_falling_end, "a fall stays within the skin")
{
    const double g = 2;
    for (int k = 0; k <= 20; ++k) {
        FREED(disks) d;
        double v[2] = {0, 0};
        MADE(cells, c, begin_lonely(&c, &d, g, 100, v));
        const double most = sqrt(c.skin / (2 * g));
        const double speed = 0.2 * k * 0.75 * c.skin / most;
        const double end = k > 0 ? fmin(0.75 * c.skin / speed, most) : most;
        cells_free(&c);
        disks_free(&d);
        v[k % 3 > 0] = -speed;
        begin_lonely(&c, &d, g, 100, v);
        UNIT_NEAR(c.calendar.event[0].time, g + end, 1e-5 * end);
        UNIT_EQUAL(c.calendar.event[0].partner, 0);
        cells_run(&c, g + end * (1 - 1e-4), UINT64_MAX);
        UNIT_EQUAL(c.renewed, 0);
        UNIT_EQUAL(runaways(&c), 0);
        cells_run(&c, g + end * (1 + 1e-4), UINT64_MAX);
        UNIT_TRUE(c.renewed > 0);
    }
}

/* So many disks that memory is asked for early. It changes no bit: one lane
   at a time, another time from four or eight, and nobody leaves its skin.
 */
TEST(test_many, "many disks, for which memory is fetched early")
{
    uint64_t hits[2] = {0};
    double last[2] = {0};
    for (int all = 0; all < 2; ++all) {
        struct cells c;
        SEEDED(r, 4);
        const double box[] = {80, 80};
        MADE(disks, d, make(&d, 2, 5000, DISKS_PERIODIC, box, 0.4));
        UNIT_TRUE(disks_place_lattice(&d));
        disks_set_speed(&d, 1, &r);
        UNIT_MUST(cells_create(&c, &d));
        c.lanes = all ? c.lanes : 1;
        UNIT_TRUE(cells_run(&c, INFINITY, 8000) == DISKS_COLLISIONS);
        for (size_t i = 0; i < d.count; ++i) {
            hits[all] += d.hits[i] * (i + 1);
            last[all] += d.disk[i].position[0] * (double)(i % 7);
        }
        UNIT_NEAR(disks_energy(&d), 2500, 1e-9);
        UNIT_EQUAL(runaways(&c), 0);
        cells_free(&c);
        cells_free(&c); /* twice is harmless */
        disks_free(&d);
    }
    UNIT_TRUE(hits[0] == hits[1] && last[0] == last[1]);
}
