/* does not build: a way through the function without a return */
/* says: means  *There is a way through the function */
double twice(double x)
{
    if (x > 1e9)
        return 2 * x;
}
