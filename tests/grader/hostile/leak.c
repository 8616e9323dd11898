/* passed: it takes memory and does not give it back, which is told */
/* earns: all */
#include "exercise.h"
#include <stdlib.h>

static void trick(void)
{
    volatile char *lost = malloc(40);
    lost[0] = 1;
    lost = NULL;
}
