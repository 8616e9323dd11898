/* does not build: an array in the place of a number */
/* says: means  *The types do not fit */
double twice(double x)
{
    double y[2] = {x, x};
    double sum = y;
    return sum;
}
