/* does not build: a header that is misspelt */
/* says: means  *There is no header of this name */
#include "exercize.h"

double twice(double x)
{
    return 2 * x;
}
