/* not begun: two tests pass, and the last one meets a gap */
/* says: 2 of  3 points */
/* says: is under way$ */
#include "exercise.h"

double twice(double x)
{
    return x < 0 ? NOT_DONE_YET(x) : 2 * x;
}
