/* crashed: it gives up */
/* says: SIGABRT */
#include <stdlib.h>

double twice(double x)
{
    return x < 0 ? 0 : (abort(), x);
}
