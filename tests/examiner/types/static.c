/* 03c does not build: its function is static */
/* says: .c:7:15: error: static declaration */
/* says: velocity_below is static here, and the tests cannot call it. The exercise gave: double velocity_below(int n, double u) */
#include "exercise.h"
#include <math.h>

static double velocity_below(int n, double u)
{
    return pow(0.5 * (1.0 + u), n);
}
