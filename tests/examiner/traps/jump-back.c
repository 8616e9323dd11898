/* timed out: it jumps back into a call that is still there, for ever */
#include <setjmp.h>

static jmp_buf place;

static void back(void)
{
    longjmp(place, 1);
}

double twice(double x)
{
    setjmp(place);
    back();
    return 2 * x;
}
