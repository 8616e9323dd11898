/* does not build: a number in the place of an array */
/* says: means  *A number stands where an array or a pointer is expected */
static double first(const double *x)
{
    return x ? x[0] : 3;
}

double twice(double x)
{
    return x * first(0 * (int)x);
}
