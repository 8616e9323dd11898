/* timed out: it comes back to where it was, by way of four numbers */
/* earns: all but the first */
#include "exercise.h"

static void trick(void)
{
    for (volatile double x = 2.0; x != 1.0;)
        x = x == 2.0 ? 5.0 : x == 5.0 ? 7.0 : x == 7.0 ? 4.0 : 2.0;
}
