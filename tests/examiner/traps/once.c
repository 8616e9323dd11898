/* passed: each test finds it as it was begun, not as another left it */
#include <stdlib.h>

double twice(double x)
{
    static int calls;
    if (calls++ > 0 || getenv("CALLED"))
        return 0;
    setenv("CALLED", "1", 1);
    return 2 * x;
}
