/* failed: something is computed and thrown away */
/* says: means  *This line computes something and throws it away */
double twice(double x)
{
    double y = x;
    2 * y;
    return y;
}
