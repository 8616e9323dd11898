/* crashed: an assertion of its own is false, and says which */
/* says: SIGABRT */
/* says: | .*Assertion.*x > 2 */
#include <assert.h>

double twice(double x)
{
    assert(x > 2);
    return 2 * x;
}
