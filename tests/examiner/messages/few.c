/* does not build: a call with too few values */
/* says: means  *The call has fewer values than the function takes */
static double add(double a, double b)
{
    return a + b;
}

double twice(double x)
{
    return add(x);
}
