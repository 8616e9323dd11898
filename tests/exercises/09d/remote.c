/* The remote calls of exercise 09d: see examiner/remote.h. The drift
   stays with the judge; the box asks for it. */
/* output: ellipses_and_kicks x n */
/* output: ellipses_and_kicks v n */

#include "examiner/remote.h"
#include <stdlib.h>

void drift(double sun, double dt, double x[3], double v[3]);
void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3]);

static void move_drift(double *sun, double *dt, double x[3], double v[3])
{
    remote_doubles(sun, 1);
    remote_doubles(dt, 1);
    remote_doubles(x, 3);
    remote_doubles(v, 3);
}

#ifdef REMOTE_SERVER

void drift(double sun, double dt, double x[3], double v[3])
{
    remote_callback(0);
    move_drift(&sun, &dt, x, v);
    remote_callback_wait();
    remote_doubles(x, 3);
    remote_doubles(v, 3);
}

void remote_serve(void)
{
    size_t n;
    double sun, dt;
    remote_sizes(&n, 1);
    remote_doubles(&sun, 1);
    remote_doubles(&dt, 1);
    double *gm = remote_array(n, sizeof *gm);
    remote_doubles(gm, n);
    double *x = remote_output_doubles("x", 3 * n);
    double *v = remote_output_doubles("v", 3 * n);
    ellipses_and_kicks(n, gm, sun, dt, (double(*)[3])x, (double(*)[3])v);
    remote_reply();
    remote_doubles(x, 3 * n);
    remote_doubles(v, 3 * n);
    free(gm);
}

#else

void remote_serve_callback(int which)
{
    double sun, dt, x[3], v[3];
    (void)which;
    move_drift(&sun, &dt, x, v);
    drift(sun, dt, x, v);
    remote_callback_reply();
    remote_doubles(x, 3);
    remote_doubles(v, 3);
}

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles(&sun, 1);
    remote_doubles(&dt, 1);
    remote_doubles((double *)gm, n); /* which only reads on this side */
    remote_doubles(x[0], 3 * n);
    remote_doubles(v[0], 3 * n);
    remote_wait();
    remote_doubles(x[0], 3 * n);
    remote_doubles(v[0], 3 * n);
}

#endif
