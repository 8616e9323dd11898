/* Times and speeds at which a falling body reaches a floor or a roof. */
#ifndef FALL_H
#define FALL_H

/* Returns the time, s, until a body at height x (m) above a floor reaches
   it, with the velocity v upwards (m/s) and the acceleration g > 0
   downwards (m/s2) (5.13, eq:fall-floor). For x <= 0 the body is on the
   floor, and the time is 0 if v < 0. INFINITY if x is infinite. */
double fall_to_floor(double x, double v, double g);

/* Returns the time, s, until the body reaches a roof at a distance x, m,
   above it (5.14, eq:fall-roof); INFINITY if it at most touches the
   roof. */
double fall_to_roof(double x, double v, double g);

/* Returns the speed, m/s, at which the body reaches the floor, or with -x
   for x the roof; 0 if rounding makes the square of the speed negative. */
double fall_speed(double x, double v, double g);

#endif
