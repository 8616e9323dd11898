/* When a body that falls reaches a floor or a roof. */
#ifndef FALL_H
#define FALL_H

/* The time, s, until a body reaches the floor x (m) below it with velocity
   v upwards (m/s) and the acceleration g > 0 downwards (m/s2). A body that
   is not above the floor is on it: at once if v < 0. INFINITY for x
   infinite. Source: (5.13, eq:fall-floor). */
double fall_to_floor(double x, double v, double g);

/* The time, s, until the body reaches a roof at a distance x above it;
   INFINITY if it does not get there or only just touches it.
   Source: (5.14, eq:fall-roof). */
double fall_to_roof(double x, double v, double g);

/* The speed, m/s, at which it is then at the floor; with -x at the roof.
   0 where rounding would have it imaginary. */
double fall_speed(double x, double v, double g);

#endif
