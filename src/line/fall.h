/* Times and speeds at which a falling body reaches a floor or a roof. */
#ifndef FALL_H
#define FALL_H

/* Returns the time (in s) until a body at the height x (m) above a floor
   reaches the floor (5.13, eq:fall-floor). v is its upward velocity (m/s)
   and g > 0 the downward acceleration (m/s2). If x <= 0, the body is
   already on the floor, and the time is 0 if v < 0. Returns INFINITY if x
   is infinite. */
double fall_to_floor(double x, double v, double g);

/* Returns the time (in s) until the body reaches a roof at the distance x
   (in m) above it (5.14, eq:fall-roof). Returns INFINITY if the body only
   touches the roof or does not reach it. */
double fall_to_roof(double x, double v, double g);

/* Returns the speed (in m/s) at which the body reaches the floor, or the
   roof if -x is passed for x. Returns 0 if rounding makes the square of
   the speed negative. */
double fall_speed(double x, double v, double g);

#endif
