/* Motions in closed form: flight, an oscillator, equal points on a line. */
#ifndef CLOSED_H
#define CLOSED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns e^x, with a relative error of 1e-15 for x > -708. The result is
   the same to the last bit on every machine. */
double closed_exp(double x);

/* Moves a body for the time t (s) with the acceleration g - rate v. g is in
   m/s^2; rate is in 1/s and not negative. Source: (12.4,
   eq:models-flight). */
void closed_fly(double t, double rate, double g, double *x, double *v);

/* Moves y (m) and v (m/s) for the time t (s) along the solution of y'' +
   rate y' + square y = 0. rate (1/s) and square (1/s^2) are not negative.
   Source: (12.5, eq:models-swing). */
void closed_oscillate(double t, double square, double rate, double *y,
                      double *v);

/* Moves points of equal mass on a line for the time t (s) between elastic
   walls at low and high (m). If there is no wall, low is -INFINITY or high
   is INFINITY. x and v are ordered from left to right, before and after.
   Returns false if memory runs out. */
bool closed_relabel(double low, double high, size_t n, double x[],
                    double v[], double t);

/* Returns the number of collisions of the points with each other and with
   the walls up to the time t (s). Contacts at the start are not counted. If
   the number is too large, returns UINT64_MAX. The cost is of the order of
   n^2. Source: (12.6, eq:closed-meetings). */
uint64_t closed_meetings(double low, double high, size_t n,
                         const double x[], const double v[], double t);

#endif
