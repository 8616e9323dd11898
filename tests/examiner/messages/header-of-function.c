/* does not build: a function whose header is missing */
/* says: means  *sqrt comes with <math.h> */
double twice(double x)
{
    return 2 * sqrt(x * x);
}
