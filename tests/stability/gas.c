/* What must hold in every run of a gas, to rounding: the virial theorem
   with walls (7.6, eq:gas-walls), for both engines; and what a state in a
   file keeps. */
#include "unit.h"

#include "box/cells.h"
#include "box/disks.h"
#include "box/states.h"

#include <stdlib.h>
#include <unistd.h>

/* Disks of radius 1/2 in a box, or spheres, at random speeds. */
static void make(struct disks *d, size_t dimensions, size_t count,
                 double side)
{
    SEEDED(r, 7);
    UNIT_MUST(disks_create(d, dimensions, count));
    for (size_t k = 0; k < dimensions; ++k)
        d->box[k] = side * (1 + 0.2 * (double)k);
    for (size_t i = 0; i < count; ++i) {
        d->disk[i].radius = 0.5;
        d->mass[i] = 1 + (double)(i % 3);
    }
    UNIT_TRUE(disks_place_lattice(d));
    disks_set_temperature(d, 1, &r);
}

/* The sum of mass times velocity times place, from the middle. */
static double virial_sum(const struct disks *d)
{
    double sum = 0;
    for (size_t i = 0; i < d->count; ++i) {
        double place[DISKS_AXES];
        disks_position(d, i, place);
        for (size_t k = 0; k < d->dimensions; ++k)
            sum += d->mass[i] * d->disk[i].velocity[k] *
                   (place[k] - d->box[k] / 2);
    }
    return sum;
}

static void check_virial(struct disks *d, bool fast)
{
    struct cells c;
    const double start = virial_sum(d), K = disks_energy(d);
    if (fast)
        UNIT_TRUE(cells_suit(d) && cells_create(&c, d));
    UNIT_TRUE(fast || disks_plan(d));
    for (double t = 1; t <= 20; ++t) {
        if (fast)
            cells_run(&c, t, UINT64_MAX);
        else
            disks_run(d, t, UINT64_MAX);
        double sum = 2 * K * t + d->virial;
        for (size_t k = 0; k < d->dimensions; ++k)
            sum -= (d->box[k] / 2 - 0.5) * d->impulse[k];
        UNIT_NEAR(virial_sum(d) - start, sum, 1e-12 * 2 * K * t);
    }
    UNIT_TRUE(d->collisions > 500 && d->wall_collisions > 200);
    if (fast)
        cells_free(&c);
    disks_free(d);
}

TEST(test_virial, "the virial theorem holds in every run")
{
    for (size_t fast = 0; fast < 2; ++fast) {
        struct disks d;
        make(&d, 2, 100, 15);
        check_virial(&d, fast);
        make(&d, 3, 120, 6);
        check_virial(&d, fast);
    }
}

/* Every bit of a state comes back, and the same disks fit. */
TEST(test_states, "a state in a file keeps every bit")
{
    for (size_t D = 2; D <= 3; ++D)
        for (size_t round = 0; round < 2; ++round) {
            char name[] = "/tmp/states-XXXXXX", message[STATES_MESSAGE];
            FREED(disks) d, e;
            size_t a, b;
            make(&d, D, 60, D == 2 ? 11 : 6);
            d.boundary = round ? DISKS_PERIODIC : DISKS_WALLS;
            UNIT_TRUE(disks_plan(&d));
            disks_run(&d, 10.0 / 3, UINT64_MAX);
            const int file = mkstemp(name);
            UNIT_TRUE(file >= 0);
            close(file);
            struct table *out = table_open("gas", name);
            states_begin(out, &d);
            states_write(out, &d);
            UNIT_TRUE(table_close(out));
            UNIT_TRUE(states_read(&e, name, message));
            unlink(name);
            UNIT_EQUAL(e.count, d.count);
            UNIT_EQUAL(e.dimensions, D);
            UNIT_TRUE(e.boundary == d.boundary);
            UNIT_EQUAL(e.now, d.now);
            UNIT_TRUE(memcmp(e.disk, d.disk, d.count * sizeof d.disk[0]) ==
                      0);
            UNIT_TRUE(memcmp(e.mass, d.mass, d.count * sizeof d.mass[0]) ==
                      0);
            UNIT_TRUE(memcmp(e.box, d.box, sizeof d.box) == 0);
            UNIT_TRUE(disks_fit(&e, &a, &b));
        }
}
