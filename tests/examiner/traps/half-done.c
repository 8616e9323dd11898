/* failed: a gap in one case, and a wrong number in another */
/* says: test       twice three is six */
#include "exercise.h"

double twice(double x)
{
    return x < 2 ? NOT_DONE_YET(x) : x;
}
