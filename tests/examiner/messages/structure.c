/* does not build: a structure without its semicolon, above a header */
/* says: semicolon */
struct length {
    double metres;
}
#include <stdlib.h>

double
twice(double x)
{
    return 2 * x;
}
