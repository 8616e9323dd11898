/* 01f as half the impulse of a full stop times the velocity of approach. */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    const double slow = u1 < u2 ? u1 : u2, fast = u1 < u2 ? u2 : u1;
    const double impulse = (fast - slow) / (im1 + im2);
    return (fast - slow) * impulse / 2.0;
}
