/* failed: an infinity where a number is expected */
/* says: got        inf m */
#include <math.h>

double twice(double x);

double twice(double x)
{
    return fabs(x) * INFINITY;
}
