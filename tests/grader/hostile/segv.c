/* crashed: it writes where there is nothing */
/* earns: all but the first */
#include "exercise.h"

static void trick(void)
{
    int *volatile nowhere = (int *)8;
    *nowhere = 1;
}
