/* What crosses the border of exercise 01f: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"

double energy_at_stake(double u1, double u2, double im1, double im2);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    double in[4], out;
    border_doubles(in, 4);
    out = energy_at_stake(in[0], in[1], in[2], in[3]);
    border_reply();
    border_doubles(&out, 1);
}

#else

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    double in[4] = {u1, u2, im1, im2}, out;
    border_call();
    border_doubles(in, 4);
    border_wait();
    border_doubles(&out, 1);
    return out;
}

#endif
