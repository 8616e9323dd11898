/* does not build: what is given is changed */
/* says: means  *This is const */
double twice(double x)
{
    const double y = x;
    y = 2 * x;
    return y;
}
