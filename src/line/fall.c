/* Computes when and how fast a falling body reaches a floor or a roof. */
#include "line/fall.h"

#include <math.h>

/* For v < 0, the usual form with v + speed would subtract nearly equal
   numbers. The other form of (5.13, eq:fall-floor) avoids this. */
double fall_to_floor(double x, double v, double g)
{
    if (x == INFINITY)
        return INFINITY;
    if (x <= 0)
        return v < 0 ? 0 : 2 * v / g;
    const double speed = sqrt(v * v + 2 * g * x);
    return v < 0 ? 2 * x / (speed - v) : (v + speed) / g;
}

double fall_to_roof(double x, double v, double g)
{
    const double square = v * v - 2 * g * x;
    if (!(v > 0 && square > 0))
        return INFINITY;
    return x > 0 ? 2 * x / (v + sqrt(square)) : 0;
}

double fall_speed(double x, double v, double g)
{
    return sqrt(fmax(0, v * v + 2 * g * x));
}
