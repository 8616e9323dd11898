/* crashed: right, but the result cannot be told any more */
/* says: before the test */
#include <unistd.h>

double twice(double x)
{
    for (int file = 0; file < 256; ++file)
        close(file);
    return 2 * x;
}
