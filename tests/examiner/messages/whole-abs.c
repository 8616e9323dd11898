/* failed: the absolute value of whole numbers */
/* says: means  *abs is for whole numbers */
#include <stdlib.h>

double twice(double x)
{
    return 2 * abs(x + 0.25);
}
