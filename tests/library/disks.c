/* Hard disks: times of contact against hand-made cases, the plan against
   every pair looked at, and sums against what must balance. Pressures
   against direct sampling are in tests/programs/disks_answers.sh. */
#include "unit.h"

#include "box/disks.h"

#include <float.h>

/* Count disks of this radius in a box of equal sides. */
static void begin(struct disks *d, size_t dimensions, size_t count,
                  double radius, double side, enum disks_boundary boundary,
                  uint64_t seed)
{
    SEEDED(r, seed);
    size_t a, b;
    UNIT_MUST(disks_create(d, dimensions, count));
    d->boundary = boundary;
    for (size_t k = 0; k < dimensions; ++k)
        d->box[k] = side;
    for (size_t i = 0; i < count; ++i)
        d->disk[i].radius = radius;
    UNIT_TRUE(disks_place_lattice(d));
    UNIT_TRUE(disks_fit(d, &a, &b));
    disks_set_speed(d, 1, &r);
    UNIT_TRUE(disks_replan_distance(d) > 0 && disks_plan(d));
}

TEST(test_wall_time, "wall times")
{
    UNIT_EQUAL(disks_wall_time(0.5, 1, 0.25, 1), 0.25);
    UNIT_EQUAL(disks_wall_time(0.5, -2, 0.25, 1), 0.125);
    UNIT_TRUE(disks_wall_time(0.5, 0, 0.25, 1) == INFINITY);
    UNIT_TRUE(disks_wall_time(0.5, -0.0, 0.25, 1) == INFINITY);
    UNIT_EQUAL(disks_wall_time(0.25, -1, 0.25, 1), 0);
    UNIT_EQUAL(disks_wall_time(0.2, -1, 0.25, 1), 0); /* beyond: now */
    UNIT_EQUAL(disks_wall_time(0.2, 1, 0.25, 1), 0.55);
}

/* Head-on; 3-4-5 triangles in the plane and in space; misses. */
TEST(test_pair_time, "pair times of known triangles")
{
    UNIT_EQUAL(
        disks_pair_time((double[]){4, 0, 0}, (double[]){-2, 0, 0}, 1), 1.5);
    /* impact parameter 3 of 5: contact at x = 4, from x = 10 */
    UNIT_EQUAL(
        disks_pair_time((double[]){10, 3, 0}, (double[]){-1, 0, 0}, 5), 6);
    UNIT_EQUAL(
        disks_pair_time((double[]){3, 10, 0}, (double[]){0, -2, 0}, 5), 3);
    UNIT_EQUAL(
        disks_pair_time((double[]){0, 3, 10}, (double[]){0, 0, -4}, 5),
        1.5);
    UNIT_TRUE(disks_pair_time((double[]){10, 6, 0}, (double[]){-1, 0, 0},
                              5) == INFINITY);
    UNIT_TRUE(disks_pair_time((double[]){10, 3, 0}, (double[]){1, 0, 0},
                              5) == INFINITY);
    UNIT_TRUE(disks_pair_time((double[]){10, 3, 0}, (double[]){0, 0, 0},
                              5) == INFINITY);
    /* tangent: discriminant exactly zero */
    UNIT_EQUAL(
        disks_pair_time((double[]){8, 5, 0}, (double[]){-1, 0, 0}, 5), 8);
}

TEST(test_overlap, "overlaps collide now if they approach")
{
    const double in[] = {-1, 0.5, 0}, out[] = {1, 0.5, 0};
    const double side[] = {0, 1, 0};
    const double deep[] = {0.5, 0, 0}, touch[] = {1, 0, 0};
    const double hair[] = {1 - DBL_EPSILON, 0, 0};
    UNIT_EQUAL(disks_pair_time(deep, in, 1), 0);
    UNIT_EQUAL(disks_pair_time(touch, in, 1), 0);
    UNIT_EQUAL(disks_pair_time(hair, in, 1), 0);
    UNIT_TRUE(disks_pair_time(deep, out, 1) == INFINITY);
    UNIT_TRUE(disks_pair_time(hair, out, 1) == INFINITY);
    UNIT_TRUE(disks_pair_time(touch, side, 1) == INFINITY);
    UNIT_TRUE(disks_pair_time(deep, side, 1) == INFINITY);
}

/* Exact places: c = 2 g + g^2 has no rounding, t = g / v exactly, and a few
   roundings in the formula. The textbook's root keeps 8 digits here. */
TEST(test_small_gap, "a small gap keeps its digits")
{
    const double gap = ldexp(1, -26), v = 0.7;
    UNIT_NEAR(disks_pair_time((double[]){1 + gap, 0, 0},
                              (double[]){-v, 0, 0}, 1) /
                  (gap / v),
              1, 4 * DBL_EPSILON);
}

/* The time of a meeting is the same number whenever one asks. */
TEST(test_canonical, "meetings are canonical")
{
    MADE(disks, d, begin(&d, 2, 20, 0.5, 8, DISKS_PERIODIC, 3));
    disks_run(&d, INFINITY, 500);
    size_t meetings = 0;
    for (size_t i = 0; i < 20; ++i)
        for (size_t j = 0; j < 20; ++j) {
            const double at = d.now,
                         time = i == j ? INFINITY
                                       : disks_meeting(&d, i, j, at);
            if (!(time < at + 1))
                continue;
            ++meetings;
            for (int k = 0; k < 8; ++k)
                UNIT_EQUAL(
                    disks_meeting(&d, i, j, at + (time - at) * k / 8),
                    time);
            UNIT_EQUAL(disks_meeting(&d, j, i, at), time);
        }
    UNIT_TRUE(meetings > 10);
}

/* One trajectory, bit for bit, from every pair looked at and from a plan:
   masses and radii mixed, dilute so that images matter, and dense. */
static void compare(size_t dimensions, size_t count, double side,
                    enum disks_boundary boundary)
{
    struct disks d[2];
    for (int k = 0; k < 2; ++k) {
        begin(&d[k], dimensions, count, 0.5, side, boundary, 7);
        for (size_t i = 0; i < count; ++i) {
            d[k].mass[i] = 1 + (double)(i % 3);
            d[k].disk[i].radius = i % 2 ? 0.5 : 0.4;
        }
        UNIT_TRUE(disks_plan(&d[k]));
    }
    disks_run(&d[0], INFINITY, 1500);
    while (d[1].collisions < 1500)
        disks_collide(&d[1], disks_next(&d[1]));
    UNIT_TRUE(memcmp(d[0].disk, d[1].disk, count * sizeof *d[0].disk) == 0);
    UNIT_EQUAL(d[0].now, d[1].now);
    UNIT_EQUAL(d[0].virial, d[1].virial);
    UNIT_EQUAL(d[0].wall_collisions, d[1].wall_collisions);
    disks_free(&d[0]);
    disks_free(&d[1]);
}

TEST(test_engines, "a plan has the bits of every pair looked at")
{
    for (int boundary = 0; boundary < DISKS_BOUNDARIES; ++boundary) {
        compare(2, 2, 5, boundary);
        compare(2, 12, 40, boundary);
        compare(2, 30, 8, boundary);
        compare(3, 5, 9, boundary);
        compare(3, 40, 5, boundary);
    }
}

TEST(test_pieces, "pieces of a run have the bits of the whole")
{
    double place[DISKS_AXES];
    MADE(disks, one, begin(&one, 2, 10, 0.5, 6, DISKS_PERIODIC, 5));
    MADE(disks, many, begin(&many, 2, 10, 0.5, 6, DISKS_PERIODIC, 5));
    UNIT_TRUE(disks_run(&one, 20, UINT64_MAX) == DISKS_TIME);
    for (int k = 1; k <= 2000; ++k) {
        disks_run(&many, k * 0.01, UINT64_MAX);
        disks_position(&many, (size_t)k % 10, place);
    }
    UNIT_EQUAL(one.now, 20);
    UNIT_EQUAL(many.now, 20);
    UNIT_TRUE(memcmp(one.disk, many.disk, 10 * sizeof *one.disk) == 0);
    UNIT_EQUAL(one.collisions, many.collisions);
}

/* m v (x - c) summed over the disks. */
static double moment(const struct disks *d)
{
    double sum = 0, place[DISKS_AXES];
    for (size_t i = 0; i < d->count; ++i) {
        disks_position(d, i, place);
        for (size_t k = 0; k < d->dimensions; ++k)
            sum += d->mass[i] * d->disk[i].velocity[k] *
                   (place[k] - d->box[k] / 2);
    }
    return sum;
}

/* The balance of eq:impulse-balance, exact but for rounding: n terms of
   order one each round to 2e-16, and their sum is a few thousand. */
static void balance(size_t dimensions, double e)
{
    MADE(disks, d, begin(&d, dimensions, 8, 0.5, 4, DISKS_WALLS, 11));
    for (size_t i = 0; i < 8; ++i)
        d.mass[i] = 1 + (double)i / 4;
    d.restitution = 1;
    disks_settle(&d);
    UNIT_TRUE(disks_plan(&d));
    const double before = moment(&d);
    const double energy = disks_energy(&d);
    disks_run(&d, e, UINT64_MAX);
    double walls = 0;
    for (size_t k = 0; k < dimensions; ++k)
        walls += (d.box[k] / 2 - 0.5) * d.impulse[k];
    UNIT_TRUE(d.collisions > 1000 && d.wall_collisions > 1000);
    UNIT_NEAR(moment(&d) - before, 2 * energy * d.now + d.virial - walls,
              1e-9);
    UNIT_NEAR(disks_energy(&d) / energy, 1, 1e-12);
}

TEST(test_balance, "virial, walls and energy balance")
{
    balance(2, 500);
    balance(3, 900);
}

/* In a periodic box energy and momentum; chapter 1's drift of the energy
   is below 1e-15 a collision. */
TEST(test_conserved, "energy and momentum are conserved")
{
    double sum[DISKS_AXES] = {0};
    MADE(disks, d, begin(&d, 3, 32, 0.5, 5, DISKS_PERIODIC, 2));
    UNIT_NEAR(disks_energy(&d), 16, 1e-12);
    disks_run(&d, INFINITY, 20000);
    UNIT_NEAR(disks_energy(&d), 16, 1e-10);
    UNIT_NEAR(disks_temperature(&d), 32.0 / 93, 1e-11);
    for (size_t i = 0; i < 32; ++i)
        for (size_t k = 0; k < 3; ++k)
            sum[k] += d.disk[i].velocity[k];
    for (size_t k = 0; k < 3; ++k)
        UNIT_NEAR(sum[k], 0, 1e-12);
    UNIT_EQUAL(d.wall_collisions, 0);
}

/* One disk alone: Z = L / (L - 2r) on each axis, exactly after whole round
   trips; 2 * 3 / 0.6 and 2 * 1 / 0.8 s for the axes of this one. */
TEST(test_one, "one disk: exact impulses")
{
    CREATED(disks, d, 2, 1);
    PUT(d.box, 4, 2);
    d.disk[0] = (struct disk){{1, 1, 0}, 0, {0.6, 0.8, 0}, 0.5};
    UNIT_TRUE(disks_plan(&d));
    disks_run(&d, 10, UINT64_MAX);
    UNIT_EQUAL(d.wall_collisions, 2 + 8);
    UNIT_LIST(d.impulse, 1e-14, 2 * 2 * 0.6, 8 * 2 * 0.8);
}

TEST(test_rest, "nothing happens at rest")
{
    MADE(disks, d, begin(&d, 2, 4, 0.15, 1, DISKS_WALLS, 1));
    for (size_t i = 0; i < 4; ++i)
        memset(d.disk[i].velocity, 0, sizeof d.disk[i].velocity);
    UNIT_TRUE(disks_plan(&d));
    UNIT_TRUE(disks_run(&d, INFINITY, 10) == DISKS_TIME);
    UNIT_EQUAL(d.now, 0);
    UNIT_TRUE(disks_run(&d, 5, 10) == DISKS_TIME);
    UNIT_EQUAL(d.now, 5);
}

/* Settling folds the disks into the box and starts all counts anew; an
   event that rounding has put into the past happens now. */
TEST(test_settle, "settling folds, and begins to count")
{
    double before[DISKS_AXES], after[DISKS_AXES];
    MADE(disks, d, begin(&d, 2, 6, 0.5, 5, DISKS_PERIODIC, 1));
    disks_run(&d, 50, UINT64_MAX);
    disks_position(&d, 3, before);
    disks_fold(&d, before);
    disks_collide(&d, (struct disks_event){49, 3, 3});
    UNIT_EQUAL(d.now, 50);
    disks_settle(&d);
    disks_position(&d, 3, after);
    for (size_t k = 0; k < 2; ++k)
        UNIT_EQUAL(after[k], before[k]);
    for (size_t i = 0; i < 6; ++i)
        for (size_t k = 0; k < 2; ++k)
            UNIT_TRUE(d.disk[i].position[k] >= 0 &&
                      d.disk[i].position[k] < 5);
    UNIT_EQUAL(d.now, 0);
    UNIT_EQUAL((double)d.collisions + d.virial, 0);
}

/* Head-on with e = 1/2: (v1 + v2)/2 -+ e (v1 - v2)/2; a wall gives half. */
TEST(test_restitution, "restitution")
{
    CREATED(disks, d, 2, 2);
    d.box[0] = d.box[1] = 10;
    d.restitution = 0.5;
    d.disk[0] = (struct disk){{2, 5, 0}, 0, {1, 0, 0}, 0.5};
    d.disk[1] = (struct disk){{4, 5, 0}, 0, {0, 0, 0}, 0.5};
    UNIT_TRUE(disks_plan(&d));
    UNIT_TRUE(disks_run(&d, INFINITY, 1) == DISKS_COLLISIONS);
    UNIT_EQUAL(d.now, 1);
    UNIT_EQUAL(d.disk[0].velocity[0], 0.25);
    UNIT_EQUAL(d.disk[1].velocity[0], 0.75);
    UNIT_EQUAL(d.virial, 0.75);
    disks_run(&d, 1 + 5.5 / 0.75 + 0.01, UINT64_MAX);
    UNIT_EQUAL(d.disk[1].velocity[0], -0.375);
    UNIT_EQUAL(d.impulse[0], 0.75 + 0.375);
}

TEST(test_open_axis, "an open axis has no wall")
{
    size_t axis;
    CREATED(disks, d, 2, 1);
    d.box[0] = 1;
    d.disk[0] = (struct disk){
        .position = {0.5, 0.5}, .velocity = {0.25, -1}, .radius = 0.25};
    UNIT_EQUAL(disks_wall(&d, 0, &axis), 1);
    UNIT_EQUAL(axis, 0);
    d.box[0] = 0;
    UNIT_TRUE(disks_wall(&d, 0, &axis) == INFINITY);
}

/* Disks in rows that fly along their rows, with places, speeds and times
   that have few binary digits: much happens at one time, and exactly. The
   plan takes it in the order of disks_before, as every look does. */
TEST(test_ties, "and a plan keeps to it")
{
    enum { SIDE = 5, COUNT = SIDE * SIDE };
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        struct disks d[2];
        SEEDED(r, seed);
        size_t at[COUNT];
        for (size_t i = 0; i < COUNT; ++i) { /* a shuffle */
            const size_t k = (size_t)random_below(&r, i + 1);
            at[i] = at[k];
            at[k] = i;
        }
        for (int e = 0; e < 2; ++e) {
            SEEDED(speeds, seed);
            UNIT_MUST(disks_create(&d[e], 2, COUNT));
            d[e].box[0] = d[e].box[1] = SIDE;
            for (size_t i = 0; i < COUNT; ++i) {
                struct disk *a = &d[e].disk[i];
                a->radius = 0.125;
                PUT(a->position, (double)(at[i] % SIDE) + 0.5,
                    (double)(at[i] / SIDE) + 0.5);
                a->velocity[0] = 2 * (double)random_below(&speeds, 4) - 3;
            }
        }
        UNIT_TRUE(disks_plan(&d[0]));
        for (uint64_t n = 1; n <= 100; ++n) {
            disks_run(&d[0], INFINITY, n);
            while (d[1].collisions < n)
                disks_collide(&d[1], disks_next(&d[1]));
            UNIT_EQUAL(d[0].wall_collisions, d[1].wall_collisions);
            UNIT_TRUE(memcmp(d[0].hits, d[1].hits,
                             COUNT * sizeof d[0].hits[0]) == 0);
            UNIT_TRUE(memcmp(d[0].disk, d[1].disk,
                             COUNT * sizeof d[0].disk[0]) == 0);
        }
        disks_free(&d[0]);
        disks_free(&d[1]);
    }
}

/* Equal times: the smaller number first, then the smaller partner. */
TEST(test_order, "equal times have an order")
{
    const struct disks_event a = {1, 3, 0}, b = {1, 0, 2}, c = {1, 1, 2};
    const struct disks_event wall = {1, 0, 4}, late = {2, 0, 1};
    UNIT_TRUE(disks_before(b, a) && !disks_before(a, b));
    UNIT_TRUE(disks_before(a, c) && !disks_before(c, a));
    UNIT_TRUE(disks_before(a, wall) && !disks_before(wall, a));
    UNIT_TRUE(disks_before(c, late) && !disks_before(late, c));
    UNIT_TRUE(!disks_before(a, a));
}

/* The lattice holds what the packing of a commensurate box allows. */
TEST(test_lattice, "lattices hold the closest packing")
{
    size_t a, b;
    /* 4 x 2 cells of width 1 and height sqrt(3): packing .9069 */
    CREATED(disks, d, 2, 16);
    d.boundary = DISKS_PERIODIC;
    PUT(d.box, 4 * (1 + 1e-12), 2 * sqrt(3) * (1 + 1e-12));
    for (size_t i = 0; i < 16; ++i)
        d.disk[i].radius = 0.5;
    UNIT_TRUE(disks_place_lattice(&d) && disks_fit(&d, &a, &b));
    UNIT_NEAR(disks_packing(&d), acos(-1) / (2 * sqrt(3)), 1e-10);
    d.box[0] = 3.99;
    UNIT_TRUE(!disks_place_lattice(&d));
}

/* One big disk among small ones goes to the middle, up to packing .7. */
TEST(test_guest, "a guest stands in the middle")
{
    for (int boundary = 0; boundary < DISKS_BOUNDARIES; ++boundary)
        for (int dense = 2; dense <= 7; ++dense) {
            size_t a = 0, b = 0;
            CREATED(disks, d, 2, 401);
            d.boundary = boundary;
            d.box[0] = d.box[1] = sqrt((100 + 4) * acos(-1) * 10 / dense);
            for (size_t i = 0; i < 401; ++i)
                d.disk[i].radius = i == 200 ? 2 : 0.5;
            UNIT_TRUE(disks_place_lattice(&d));
            UNIT_TRUE(disks_fit(&d, &a, &b));
            UNIT_EQUAL(d.disk[200].position[0], d.box[0] / 2);
        }
}

TEST(test_random_start, "random starts fit or are refused")
{
    SEEDED(r, 1);
    size_t a, b;
    MADE(disks, d, begin(&d, 2, 40, 0.5, 9, DISKS_WALLS, 1));
    UNIT_TRUE(disks_place_random(&d, &r) && disks_fit(&d, &a, &b));
    for (size_t i = 0; i < 40; ++i)
        d.disk[i].radius = 0.7;
    UNIT_TRUE(!disks_place_random(&d, &r));
    d.disk[0].radius = 5;
    UNIT_TRUE(!disks_place_random(&d, &r));
}

TEST(test_fit, "misfits are named")
{
    size_t a, b;
    MADE(disks, d, begin(&d, 2, 4, 0.15, 1, DISKS_WALLS, 1));
    memcpy(d.disk[3].position, d.disk[1].position, sizeof(double[3]));
    UNIT_TRUE(!disks_fit(&d, &a, &b) && a == 1 && b == 3);
    d.disk[0].position[1] = 0.1499;
    UNIT_TRUE(!disks_fit(&d, &a, &b) && a == 0 && b == 4);
    d.disk[0].position[1] = NAN;
    UNIT_TRUE(!disks_fit(&d, &a, &b) && a == 0);
}

/* Images: nearest, and folded. A box of 4 radii is too narrow. */
TEST(test_images, "nearest images")
{
    double apart[DISKS_AXES], place[DISKS_AXES] = {-0.5, 31.25, 0};
    MADE(disks, d, begin(&d, 2, 2, 0.5, 3, DISKS_PERIODIC, 1));
    disks_separation(&d, (double[]){0.25, 0, 0}, (double[]){2.75, 1, 0},
                     apart);
    UNIT_LIST(apart, 0, -0.5, 1, 0);
    disks_fold(&d, place);
    UNIT_LIST(place, 0, 2.5, 1.25);
    place[0] = -1e-20; /* and not at the other end */
    place[1] = 3;
    disks_fold(&d, place);
    UNIT_LIST(place, 0, 0, 0);
    d.box[1] = 2;
    UNIT_TRUE(!(disks_replan_distance(&d) > 0));
    d.boundary = DISKS_WALLS;
    UNIT_TRUE(disks_replan_distance(&d) == INFINITY);
}

/* Maxwell's velocities: <m v^2> = kT for each mass, to 4 sigma. */
TEST(test_temperature, "temperature and speed of a start")
{
    enum { N = 20000 };
    SEEDED(r, 4);
    double square[2] = {0};
    CREATED(disks, d, 2, N);
    d.box[0] = d.box[1] = 1000;
    for (size_t i = 0; i < N; ++i)
        d.mass[i] = i % 2 ? 5 : 1;
    disks_set_temperature(&d, 0.3, &r);
    for (size_t i = 0; i < N; ++i)
        for (size_t k = 0; k < 2; ++k)
            square[i % 2] += d.mass[i] * pow(d.disk[i].velocity[k], 2) / N;
    UNIT_LIST(square, 0.3 * 4 * sqrt(2.0 / N), 0.3, 0.3);
    d.boundary = DISKS_PERIODIC;
    const double energy = disks_energy(&d);
    disks_set_speed(&d, 2, &r);
    UNIT_NEAR(disks_energy(&d), 2 * 3 * N, 1e-7);
    UNIT_TRUE(energy > 0);
}

static void boost(struct disks *d, double x, double y)
{
    for (size_t i = 0; i < d->count; ++i) {
        d->disk[i].velocity[0] += x;
        d->disk[i].velocity[1] += y;
    }
}

/* A drift along periodic axes is no heat; across a wall it is, since the
   wall takes it. Rounding of the speeds: 1e3 epsilons, twice in a square.
 */
TEST(test_drift, "a drift is no heat, but across a wall")
{
    enum { N = 50 };
    SEEDED(r, 4);
    double drift[DISKS_AXES];
    CREATED(disks, d, 2, N);
    d.box[0] = d.box[1] = 1000;
    for (size_t i = 0; i < N; ++i)
        d.mass[i] = i % 2 ? 5 : 1;
    for (int gravity = 0; gravity <= 1; ++gravity)
        for (unsigned b = 0; b < DISKS_BOUNDARIES; ++b) {
            d.boundary = (enum disks_boundary)b;
            d.gravity = b == DISKS_PERIODIC ? 0 : gravity;
            disks_set_temperature(&d, 0.3, &r);
            const double kT = disks_temperature(&d), E = disks_energy(&d);
            const bool x = b != DISKS_WALLS, y = b == DISKS_PERIODIC;
            UNIT_EQUAL(disks_heat(&d), E);
            disks_drift(&d, drift);
            UNIT_LIST(drift, 0, 0, 0);
            boost(&d, x ? 1e3 : 0, y ? -1e3 : 0);
            disks_drift(&d, drift);
            UNIT_LIST(drift, 1e-12, x ? 1e3 : 0, y ? -1e3 : 0);
            UNIT_NEAR(disks_heat(&d), E, 1e-11 * E);
            UNIT_NEAR(disks_temperature(&d), kT, 1e-11 * kT);
            UNIT_TRUE(!x || disks_energy(&d) > 1e3 * E);
            boost(&d, 0, y ? 0 : 1e3);
            UNIT_TRUE(y || disks_temperature(&d) > 1e3 * kT);
        }
    memset(d.disk, 0, N * sizeof d.disk[0]);
    d.boundary = DISKS_PERIODIC;
    boost(&d, 1.1, 0.3);
    UNIT_EQUAL(disks_heat(&d), 0);
}

/* ---- under gravity */

/* Count disks in a box of one metre, thrown at 1 m/s. */
static void begin_fall(struct disks *d, enum disks_boundary boundary,
                       size_t dimensions, size_t count, double radius,
                       double gravity)
{
    begin(d, dimensions, count, radius, 1, boundary, 4);
    d->gravity = gravity;
    UNIT_TRUE(disks_plan(d));
}

/* One disk: to and fro along x, and along y a ball that bounces, with a
   roof in its reach or not. */
TEST(test_ball, "a disk that bounces")
{
    for (int roof = 0; roof < 2; ++roof) {
        const double g = 9.81, v = roof ? 5 : 3, room = 0.8;
        double place[3], velocity[3];
        MADE(disks, d, begin_fall(&d, DISKS_WALLS, 2, 1, 0.1, g));
        memcpy(d.disk[0].position, (double[]){0.1, 0.1, 0}, 24);
        memcpy(d.disk[0].velocity, (double[]){0.25, v, 0}, 24);
        disks_plan(&d);
        const double top = v * v - 2 * g * room;
        const double up = roof ? 2 * room / (v + sqrt(top)) : v / g;
        UNIT_TRUE(roof == (top > 0));
        for (int k = 1; k <= 400; ++k) {
            const double t = 0.37 * k, phase = fmod(t, 2 * up);
            const double since = fmin(phase, 2 * up - phase);
            const double x = fmod(0.25 * t, 1.6);
            UNIT_TRUE(disks_run(&d, t, UINT64_MAX) == DISKS_TIME);
            disks_position(&d, 0, place);
            disks_velocity(&d, 0, velocity);
            UNIT_NEAR(place[0], 0.1 + fmin(x, 1.6 - x), 1e-12);
            UNIT_NEAR(place[1], 0.1 + since * (v - g * since / 2), 1e-11);
            UNIT_NEAR(fabs(velocity[1]), v - g * since, 1e-10);
        }
        UNIT_NEAR(disks_energy(&d), 0.25 * 0.25 / 2 + v * v / 2, 1e-13);
    }
}

TEST(test_common_fall, "disks that fall meet as if they did not")
{
    struct disks d[2];
    double place[2][3];
    for (int k = 0; k < 2; ++k) {
        SEEDED(r, 3);
        UNIT_TRUE(disks_create(&d[k], 2, 30));
        d[k].gravity = k ? 2 : 0;
        d[k].box[0] = d[k].box[1] = 1000;
        for (int i = 0; i < 30; ++i) {
            struct disk *a = &d[k].disk[i];
            a->radius = 0.3 + 0.01 * i;
            PUT(a->position, 500 + 2 * (i % 6) - 5,
                500 + 2 * (i / 6) - 5.0);
            /* all to the middle, with some disorder */
            a->velocity[0] =
                500 - a->position[0] + random_between(&r, -1, 1);
            a->velocity[1] =
                500 - a->position[1] + random_between(&r, -1, 1);
        }
        UNIT_TRUE(disks_plan(&d[k]));
        disks_run(&d[k], 2, UINT64_MAX);
    }
    UNIT_TRUE(d[0].collisions > 20);
    UNIT_EQUAL(d[1].collisions, d[0].collisions);
    for (size_t i = 0; i < 30; ++i) {
        disks_position(&d[0], i, place[0]);
        disks_position(&d[1], i, place[1]);
        UNIT_LIST(place[1], 1e-6, place[0][0], place[0][1] - 4);
    }
    disks_free(&d[0]);
    disks_free(&d[1]);
}

/* The plan has the bits of every pair looked at, pieces those of the
   whole, and the energy stays; without sides the momentum along them, too,
   for which one degree of freedom is missing. */
static void falling_runs(enum disks_boundary boundary)
{
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions) {
        const double sides =
            boundary == DISKS_FLOOR ? (double)dimensions - 1 : 0;
        FREED(disks) plan, look, cut;
        begin_fall(&plan, boundary, dimensions, 12, 0.06, 3);
        begin_fall(&look, boundary, dimensions, 12, 0.06, 3);
        begin_fall(&cut, boundary, dimensions, 12, 0.06, 3);
        const double energy = disks_energy(&plan);
        UNIT_NEAR(disks_temperature(&plan),
                  2 * energy / (12 * (dimensions + 2.0) - sides), 1e-15);
        disks_run(&plan, 20, UINT64_MAX);
        for (;;) {
            const struct disks_event e = disks_next(&look);
            if (e.time > 20)
                break;
            disks_collide(&look, e);
        }
        for (int k = 1; k <= 300; ++k)
            disks_run(&cut, k / 15.0, UINT64_MAX);
        UNIT_TRUE(plan.collisions > 100);
        UNIT_EQUAL(plan.collisions, look.collisions);
        for (size_t i = 0; i < 12; ++i) {
            UNIT_TRUE(
                !memcmp(&plan.disk[i], &look.disk[i], sizeof plan.disk[i]));
            UNIT_TRUE(
                !memcmp(&plan.disk[i], &cut.disk[i], sizeof plan.disk[i]));
        }
        UNIT_NEAR(disks_energy(&plan) / energy, 1, 1e-13);
        size_t a, b;
        UNIT_TRUE(disks_fit(&plan, &a, &b));
        disks_settle(&plan);
        UNIT_NEAR(disks_energy(&plan) / energy, 1, 1e-13);
        for (size_t k = 0; sides > 0 && k < dimensions; k += 2) {
            double momentum = 0;
            for (size_t i = 0; i < 12; ++i)
                momentum += plan.disk[i].velocity[k];
            /* 12 times a rounding, and one a collision */
            UNIT_NEAR(momentum, 0, 1e-13);
        }
    }
}

TEST(test_falling_runs, "falling, the plan has the bits of every pair")
{
    falling_runs(DISKS_WALLS);
    falling_runs(DISKS_FLOOR);
}

/* Two that fly apart in a box without sides meet behind its seam, 0.06 of
   0.2 m/s later, and then every 4.6 s; none meets a side. */
TEST(test_no_sides, "without sides they meet behind the seam")
{
    double place[3];
    MADE(disks, d, begin_fall(&d, DISKS_FLOOR, 2, 2, 0.02, 1));
    for (size_t i = 0; i < 2; ++i) {
        memcpy(d.disk[i].position, (double[]){i ? 0.95 : 0.05, 0.02, 0},
               24);
        memcpy(d.disk[i].velocity, (double[]){i ? 0.1 : -0.1, 0.8, 0}, 24);
    }
    disks_plan(&d);
    UNIT_TRUE(disks_run(&d, INFINITY, 1) == DISKS_COLLISIONS);
    UNIT_NEAR(d.now, 0.3, 1e-15);
    disks_run(&d, 0.3 + 4.6 * 10 + 0.05, UINT64_MAX);
    UNIT_EQUAL(d.collisions, 11);
    UNIT_EQUAL(d.wall_collisions, 2 * 28);
    UNIT_EQUAL(d.impulse[0], 0);
    for (size_t i = 0; i < 2; ++i) {
        disks_position(&d, i, place);
        UNIT_NEAR(place[0], i ? 0.975 : 0.025, 1e-12);
    }
}

TEST(test_lying, "a disk that lies is reported")
{
    MADE(disks, d, begin_fall(&d, DISKS_WALLS, 2, 1, 0.1, 1));
    memcpy(d.disk[0].position, (double[]){0.5, 0.1, 0}, 24);
    memcpy(d.disk[0].velocity, (double[]){0, 0, 0}, 24);
    disks_plan(&d);
    UNIT_TRUE(disks_run(&d, 10, UINT64_MAX) == DISKS_COLLAPSE);
}

/* All speeds are the one asked for, and nothing else changes; the momentum
   goes where it is kept, along periodic axes, and the energy stays. */
TEST(test_speeds, "speeds and momentum of a start")
{
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions)
        for (int b = 0; b < DISKS_BOUNDARIES; ++b)
            for (int warm = 0; warm < 2; ++warm) {
                SEEDED(r, 2);
                double total[DISKS_AXES] = {0}, mass = 0, energy = 0;
                MADE(disks, d, begin(&d, dimensions, 5, 0.25, 8, b, 1));
                for (size_t i = 0; i < 5; ++i)
                    d.mass[i] = 1 + (double)i;
                if (warm)
                    disks_set_temperature(&d, 0.7, &r);
                else
                    disks_set_speed(&d, 3, &r);
                for (size_t i = 0; i < 5; ++i) {
                    double square = 0;
                    mass += d.mass[i];
                    for (size_t k = 0; k < DISKS_AXES; ++k) {
                        const double v = d.disk[i].velocity[k];
                        UNIT_TRUE((v == 0) == (k >= dimensions));
                        total[k] += d.mass[i] * v;
                        square += v * v;
                    }
                    UNIT_EQUAL(d.disk[i].radius, 0.25);
                    if (b == DISKS_WALLS && !warm)
                        UNIT_NEAR(square, 9, 1e-14);
                    energy += d.mass[i] * square / 2;
                }
                if (!warm)
                    UNIT_NEAR(energy, mass * 9 / 2, 1e-12);
                for (size_t k = 0; k < dimensions; ++k) {
                    if (disks_wraps(&d, k))
                        UNIT_NEAR(total[k], 0, 1e-13);
                    else
                        UNIT_TRUE(fabs(total[k]) > 1e-3);
                }
            }
    /* There is none to take out of one disk alone. */
    SEEDED(r, 2);
    double drift[DISKS_AXES];
    CREATED(disks, one, 2, 1);
    one.boundary = DISKS_PERIODIC;
    one.box[0] = one.box[1] = 10;
    disks_set_speed(&one, 3, &r);
    UNIT_NEAR(disks_energy(&one), 4.5, 1e-14);
    disks_drift(&one, drift);
    for (size_t k = 0; k < DISKS_AXES; ++k)
        UNIT_EQUAL(drift[k], one.disk[0].velocity[k]);
    UNIT_EQUAL(disks_heat(&one), 0);
    UNIT_EQUAL(disks_temperature(&one), 0);
}

/* Two disks of 1 kg that fly apart at 1 m/s, and drift: with sqrt(eps / 2),
   1.05e-8 m/s, the energy of the drift is half a last bit of theirs. */
TEST(test_least_drift, "a drift below the last bit is none")
{
    for (size_t k = 0; k < 2; ++k)
        for (int more = 0; more < 2; ++more) {
            const double v = more ? 1.06e-8 : 1.04e-8;
            double drift[DISKS_AXES];
            CREATED(disks, d, 2, 2);
            d.boundary = DISKS_PERIODIC;
            d.box[0] = d.box[1] = 10;
            d.disk[0].velocity[k] = 1 + v;
            d.disk[1].velocity[k] = -1 + v;
            disks_drift(&d, drift);
            UNIT_NEAR(drift[k], more ? v : 0, 1e-16);
        }
}

/* The square of the fastest speed, of it times the widest radius, or of it
   times the root of the mass: 2^-900 is not cold, and less is. */
TEST(test_cold, "which speeds are too cold")
{
    static const struct {
        double radius, mass;
        int power; /* of the speed, 2^power */
    } limits[] = {{1, 1, -450},    {0, 1, -450},     {4, 16, -450},
                  {0.25, 1, -448}, {0.25, 16, -448}, {1, 0.25, -449},
                  {0, 0.25, -449}, {16, 0.25, -449}, {0.5, 0.0625, -448}};
    for (size_t n = 0; n < sizeof limits / sizeof limits[0]; ++n)
        for (size_t who = 0; who < 2; ++who) {
            CREATED(disks, d, 2, 2);
            UNIT_TRUE(!disks_cold(&d)); /* all are at rest */
            d.restitution = 0.5;
            d.disk[1 - n % 2].radius = limits[n].radius;
            d.mass[who] = limits[n].mass;
            const double v = ldexp(1, limits[n].power);
            d.disk[who].velocity[n % 2] = v;
            UNIT_TRUE(!disks_cold(&d) && !disks_over(&d, who));
            d.disk[who].velocity[n % 2] = v * (1 - DBL_EPSILON);
            UNIT_TRUE(disks_cold(&d) && disks_over(&d, who));
            d.restitution = 1; /* what loses no energy ends in no cold */
            UNIT_TRUE(!disks_over(&d, who));
            d.restitution = 0.5;
            d.gravity = 1;
            UNIT_TRUE(!disks_cold(&d));
        }
}

/* A thousand collisions at one time, and ten for each disk, are none. */
TEST(test_collapsed, "how long a clock may stand")
{
    MADE(disks, d, begin(&d, 2, 7, 0.15, 4, DISKS_PERIODIC, 1));
    d.now = 2;
    for (int k = 1; k <= 1071; ++k) {
        disks_collide(&d, (struct disks_event){k % 2 ? 2 : 1.5, 3, 3});
        UNIT_EQUAL(d.standing, k);
        UNIT_TRUE(disks_collapsed(&d) == (k > 1070));
    }
    UNIT_TRUE(disks_over(&d, 3));
    disks_collide(&d, (struct disks_event){2.5, 3, 3});
    UNIT_EQUAL(d.standing, 0);
}

/* A third of half the narrowest periodic side, less two of the widest radii
   together; 0 from where that is a millionth of the side. */
TEST(test_disks_replan_distance, "how far a disk flies before it looks")
{
    CREATED(disks, d, 3, 3);
    for (int widest = 0; widest < 3; ++widest) {
        for (int i = 0; i < 3; ++i)
            d.disk[i].radius = i == widest ? 1 : 0.5 + 0.1 * i;
        PUT(d.box, 10, 7, 12);
        d.boundary = DISKS_PERIODIC;
        UNIT_NEAR(disks_replan_distance(&d), 0.999 * 1.5 / 3, 1e-15);
        d.boundary = DISKS_FLOOR; /* the second axis has walls */
        UNIT_NEAR(disks_replan_distance(&d), 0.999 * 3 / 3, 1e-15);
        d.boundary = DISKS_WALLS;
        UNIT_TRUE(disks_replan_distance(&d) == INFINITY);
        d.boundary = DISKS_PERIODIC;
        d.box[0] = 4 * (1 + 2.1e-6);
        UNIT_TRUE(disks_replan_distance(&d) > 0);
        d.box[0] = 4 * (1 + 1.9e-6);
        UNIT_EQUAL(disks_replan_distance(&d), 0);
    }
}

TEST(test_from_wall_to_wall, "a lattice goes from wall to wall")
{
    for (size_t dimensions = 2; dimensions <= 3; ++dimensions)
        for (size_t count = 8; count < 200; count += count) {
            FREED(disks) d;
            begin(&d, dimensions, count, 0.05, 2, DISKS_WALLS, 1);
            for (size_t k = 0; k < dimensions; ++k) {
                double low = 2, high = 0;
                for (size_t i = 0; i < count; ++i) {
                    low = fmin(low, d.disk[i].position[k]);
                    high = fmax(high, d.disk[i].position[k]);
                }
                UNIT_NEAR(low, 0.05, 1e-15);
                UNIT_NEAR(high, 1.95, 2e-15);
            }
        }
}

/* What overlaps by less than 1e-9 of its distance, or sticks out by less
   than 1e-9 of the box, does so by rounding. */
TEST(test_rounding_fits, "what rounding may overlap")
{
    CREATED(disks, d, 3, 2);
    for (size_t k = 0; k < 3; ++k)
        d.box[k] = 10 * (double)(k + 1);
    d.disk[0].radius = 1;
    d.disk[1].radius = 0.5;
    for (size_t k = 0; k < 3; ++k)
        for (int side = 0; side < 4; ++side) {
            const double box = d.box[k], out = side % 2 ? 1.1 : 0.9;
            for (size_t l = 0; l < 3; ++l) {
                d.disk[0].position[l] = 5;
                d.disk[1].position[l] = 5;
            }
            d.disk[1].position[k] += 1.5 * (1 - 1e-9 * out);
            UNIT_TRUE(disks_clash(&d, 0, 1) == (out > 1));
            UNIT_TRUE(disks_clash(&d, 1, 0) == (out > 1));
            UNIT_TRUE(!disks_clash(&d, 0, 2) && !disks_clash(&d, 1, 2));
            d.disk[0].position[k] = side / 2 ? box - 1 + 1e-9 * box * out
                                             : 1 - 1e-9 * box * out;
            UNIT_TRUE(disks_clash(&d, 0, 2) == (out > 1));
            d.disk[0].position[k] = NAN;
            UNIT_TRUE(disks_clash(&d, 0, 2) && disks_clash(&d, 0, 1));
        }
}

/* Less than four last bits of the box above the floor, and of a flight that
   is as short beside the clock: that is to lie. Which of them it is, is
   said. */
TEST(test_where_it_lies, "and which disk lies")
{
    for (size_t who = 0; who < 3; ++who) {
        MADE(disks, d, begin_fall(&d, DISKS_WALLS, 2, 3, 0.0625, 8));
        d.now = 4;
        for (size_t i = 0; i < 3; ++i) {
            d.disk[i].since = 4;
            d.disk[i].position[1] = 0.5;
        }
        struct disk *a = &d.disk[who];
        a->position[1] = 0.0625 + 4 * DBL_EPSILON;
        a->velocity[1] = 4 * 4 * 4 * DBL_EPSILON;
        UNIT_EQUAL(disks_lying(&d), who);
        a->velocity[1] *= -1;
        UNIT_EQUAL(disks_lying(&d), who);
        a->velocity[1] *= 1.001;
        UNIT_EQUAL(disks_lying(&d), 3);
        a->velocity[1] = 0;
        a->position[1] += DBL_EPSILON;
        UNIT_EQUAL(disks_lying(&d), 3);
        a->position[1] = 0.0625;
        d.gravity = 0;
        UNIT_EQUAL(disks_lying(&d), 3);
    }
}

/* The widest lattice, by trying all: how near its sites are. Along an axis
   cells are box / n wide, between walls less: from one wall to the other
   are n - 1/2 of them. */
static double widest_lattice(const struct disks *d, double r)
{
    const bool plane = d->dimensions == 2;
    const size_t basis = plane ? 2 : 4;
    const size_t need = (d->count + basis - 1) / basis;
    double widest = 0;
    for (size_t x = 1; x <= need; ++x)
        for (size_t y = 1; y <= need; ++y) {
            const size_t z =
                plane ? 1 : (need + x * y - 1) / (x * y); /* at least */
            const size_t n[] = {x, y, z};
            double step[3] = {0}, least = INFINITY;
            if (x * y * z < need)
                continue;
            for (size_t k = 0; k < d->dimensions; ++k) {
                const double cells = (double)n[k];
                step[k] = disks_walled(d, k)
                              ? (d->box[k] - 2 * r) / (cells - 0.5)
                              : d->box[k] / cells;
                if (n[k] > 1)
                    least = fmin(least, step[k]);
            }
            for (size_t k = 0; k < (plane ? 1 : 3); ++k)
                least = fmin(least, hypot(step[k], step[(k + 1) % 3]) / 2);
            widest = fmax(widest, least);
        }
    return widest;
}

/* Disks that just fit on the widest lattice are placed, a little wider ones
   are not, in boxes of all shapes. */
TEST(test_widest_lattice, "of all lattices it is the widest")
{
    static const double boxes[][3] = {
        {10, 10, 10}, {10, 1, 3},   {1, 10, 2}, {7, 8, 9},
        {3, 30, 1},   {30, 3, 0.7}, {1, 2, 25}, {4, 3.4641016, 5}};
    for (size_t b = 0; b < sizeof boxes / sizeof boxes[0]; ++b)
        for (size_t dimensions = 2; dimensions <= 3; ++dimensions)
            for (size_t count = 1; count < 60; count += 1 + count / 2)
                for (int boundary = 0; boundary < DISKS_BOUNDARIES;
                     ++boundary) {
                    double low = 0, high = 40;
                    CREATED(disks, d, dimensions, count);
                    d.boundary = (enum disks_boundary)boundary;
                    memcpy(d.box, boxes[b], dimensions * sizeof d.box[0]);
                    for (size_t k = 0; k < dimensions; ++k)
                        if (disks_walled(&d, k))
                            high = fmin(high, d.box[k] / 2);
                    for (int k = 0; k < 40; ++k) {
                        const double r = (low + high) / 2;
                        *(widest_lattice(&d, r) >= 2 * r ? &low : &high) =
                            r;
                    }
                    for (int wider = 0; wider < 2; ++wider) {
                        size_t p, q;
                        for (size_t i = 0; i < count; ++i)
                            d.disk[i].radius =
                                low * (wider ? 1 + 1e-6 : 1 - 1e-6);
                        const bool placed = disks_place_lattice(&d);
                        UNIT_TRUE(placed != wider);
                        UNIT_TRUE(!placed || count == 1 ||
                                  disks_fit(&d, &p, &q));
                    }
                }
}
