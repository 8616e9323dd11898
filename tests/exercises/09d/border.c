/* What crosses the border of exercise 09d: see examiner/border.h. The drift
   stays with the judge; the box asks for it. */
/* place: ellipses_and_kicks x n */
/* place: ellipses_and_kicks v n */

#include "examiner/border.h"
#include <stdlib.h>

void drift(double sun, double dt, double x[3], double v[3]);
void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3]);

static void move_drift(double *sun, double *dt, double x[3], double v[3])
{
    border_doubles(sun, 1);
    border_doubles(dt, 1);
    border_doubles(x, 3);
    border_doubles(v, 3);
}

#ifdef BORDER_INSIDE

void drift(double sun, double dt, double x[3], double v[3])
{
    border_ask(0);
    move_drift(&sun, &dt, x, v);
    border_hear();
    border_doubles(x, 3);
    border_doubles(v, 3);
}

void border_answer(void)
{
    size_t n;
    double sun, dt;
    border_sizes(&n, 1);
    border_doubles(&sun, 1);
    border_doubles(&dt, 1);
    double *gm = border_array(n, sizeof *gm);
    border_doubles(gm, n);
    double *x = border_place_doubles("x", 3 * n);
    double *v = border_place_doubles("v", 3 * n);
    ellipses_and_kicks(n, gm, sun, dt, (double(*)[3])x, (double(*)[3])v);
    border_reply();
    border_doubles(x, 3 * n);
    border_doubles(v, 3 * n);
    free(gm);
}

#else

void border_heed(int which)
{
    double sun, dt, x[3], v[3];
    (void)which;
    move_drift(&sun, &dt, x, v);
    drift(sun, dt, x, v);
    border_tell();
    border_doubles(x, 3);
    border_doubles(v, 3);
}

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    border_call();
    border_sizes(&n, 1);
    border_doubles(&sun, 1);
    border_doubles(&dt, 1);
    border_doubles((double *)gm, n); /* which only reads on this side */
    border_doubles(x[0], 3 * n);
    border_doubles(v[0], 3 * n);
    border_wait();
    border_doubles(x[0], 3 * n);
    border_doubles(v[0], 3 * n);
}

#endif
