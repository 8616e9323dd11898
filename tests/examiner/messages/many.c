/* does not build: a call with too many values */
/* says: means  *The call has more values than the function takes */
static double add(double a, double b)
{
    return a + b;
}

double twice(double x)
{
    return add(x, x, x);
}
