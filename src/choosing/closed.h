/* Motions in closed form: flight, an oscillator, equal points on a line. */
#ifndef CLOSED_H
#define CLOSED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns e to the power x, with a relative error of 1e-15 for x > -708 and
   bitwise identical on every machine. */
double closed_exp(double x);

/* Moves a body by the time t (s) under a constant acceleration g (m/s^2)
   and a friction of -rate v (rate in 1/s, not negative). Source: (12.4,
   eq:models-flight). */
void closed_fly(double t, double rate, double g, double *x, double *v);

/* Moves y (m) and v (m/s) by the time t (s) along the solution of y'' +
   rate y' + square y = 0; rate in 1/s and square in 1/s^2, not negative.
   Source: (12.5, eq:models-swing). */
void closed_oscillate(double t, double square, double rate, double *y,
                      double *v);

/* Moves equal points on a line by the time t, s, between elastic walls at
   low and high (m; -INFINITY, INFINITY: no wall). x and v are in order from
   left to right, before and after. Returns false if memory runs out. */
bool closed_relabel(double low, double high, size_t n, double x[],
                    double v[], double t);

/* Returns how often the points have met each other and the walls by the
   time t, s, not counting contacts at the start; UINT64_MAX if the number
   is larger. The cost is of the order of n^2. Source: (12.6,
   eq:closed-meetings). */
uint64_t closed_meetings(double low, double high, size_t n,
                         const double x[], const double v[], double t);

#endif
