/* failed: a variable without a value */
/* says: means  *y has no value yet */
double twice(double x)
{
    double y;
    return y * x;
}
