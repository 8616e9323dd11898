/* does not build: one name for two variables */
/* says: means  *y is there twice */
double twice(double x)
{
    double y = x;
    double y = 2 * x;
    return y;
}
