/* Computes energies, temperatures and drifts; sets random velocities. */
#include "box/falling.h"
#include "box/image.h"

#include <float.h>
#include <math.h>

/* Returns the kinetic energy of the disks right after their last
   collisions, J. */
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
    return d->gravity > 0 ? kinetic(d) + falling_energy(d) : kinetic(d);
}

void disks_drift(const struct disks *d, double drift[])
{
    double mass = 0, square = 0;
    for (size_t i = 0; i < d->count; ++i)
        mass += d->mass[i];
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        /* Velocities are taken relative to that of the first disk, so the
           result is exact if all disks move alike. */
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
    for (size_t i = 0; i < d->count; ++i) {
        double v[DISKS_AXES];
        for (size_t k = 0; k < DISKS_AXES; ++k)
            v[k] = d->disk[i].velocity[k] - drift[k];
        heat += d->mass[i] * dot(v, v) / 2;
    }
    return d->gravity > 0 ? heat + falling_energy(d) : heat;
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

static void scale_velocities(struct disks *d, double factor)
{
    for (size_t i = 0; i < d->count; ++i)
        for (size_t k = 0; k < DISKS_AXES; ++k)
            d->disk[i].velocity[k] *= factor;
}

/* Removes the total momentum along periodic axes and restores the energy.
   Otherwise the disks would drift for ever, and the energy of the drift
   would count as heat. */
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
