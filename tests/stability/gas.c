/* What must hold in every run of a gas, to rounding: the virial theorem
   with walls (7.6, eq:gas-walls), for both engines. */
#include "unit.h"

#include "box/cells.h"
#include "box/disks.h"

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
}

TEST(test_virial, "the virial theorem holds in every run")
{
    for (size_t fast = 0; fast < 2; ++fast) {
        MADE(disks, plane, make(&plane, 2, 100, 15));
        check_virial(&plane, fast);
        MADE(disks, space, make(&space, 3, 120, 6));
        check_virial(&space, fast);
    }
}
