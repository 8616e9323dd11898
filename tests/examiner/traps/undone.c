/* not begun: changed, but the gap is still reached */
/* says: NOT_DONE_YET still stands at undone.c:8 */
#include "exercise.h"

double twice(double x)
{
    const double sum = x + x;
    return NOT_DONE_YET(sum);
}
