/* does not build: a constant whose header is missing */
/* says: means  *NAN comes with <math.h>. Is #include <math.h> at the top */
double twice(double x)
{
    return x > 0 ? 2 * x : NAN;
}
