/* Adds gravity, downwards along the second axis, to disks in a box. */
#include "box/falling.h"

#include "line/fall.h"

#include <float.h>
#include <math.h>

static double to_roof(const struct disks *d, const struct disk *a)
{
    return fall_to_roof(d->box[1] - a->radius - a->position[1],
                        a->velocity[1], d->gravity);
}

double falling_wall(const struct disks *d, const struct disk *a)
{
    return fmin(to_roof(d, a), fall_to_floor(a->position[1] - a->radius,
                                             a->velocity[1], d->gravity));
}

/* As for bodies on the line, the speed is computed from the energy and not
   from the time, so that rounding loses no energy. */
void falling_land(const struct disks *d, struct disk *a)
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

/* Uses the heights at the last collisions, since the kinetic energy is
   computed from the velocities at the last collisions. The sum of the two
   energies is constant during a flight. */
double falling_energy(const struct disks *d)
{
    double energy = 0;
    for (size_t i = 0; i < d->count; ++i)
        energy += d->mass[i] * d->gravity *
                  (d->disk[i].position[1] - d->disk[i].radius);
    return energy;
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
