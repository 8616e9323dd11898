/* crashed: it ends with a status of its own */
/* says: status 3, before the test */
#include <stdlib.h>

double twice(double x)
{
    exit(3 + (int)(x - x));
}
