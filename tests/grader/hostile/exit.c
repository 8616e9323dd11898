/* crashed: it leaves with status 0 */
/* earns: all but the first */
#include "exercise.h"
#include <stdlib.h>

static void trick(void)
{
    exit(0);
}
