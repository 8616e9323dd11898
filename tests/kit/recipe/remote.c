/* The remote calls of exercise 01f: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"

double energy_at_stake(double u1, double u2, double im1, double im2);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    double in[4], out;
    remote_doubles(in, 4);
    out = energy_at_stake(in[0], in[1], in[2], in[3]);
    remote_reply();
    remote_doubles(&out, 1);
}

#else

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    double in[4] = {u1, u2, im1, im2}, out;
    remote_call();
    remote_doubles(in, 4);
    remote_wait();
    remote_doubles(&out, 1);
    return out;
}

#endif
