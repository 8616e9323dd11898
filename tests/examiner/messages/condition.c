/* failed: an assignment in a condition */
/* says: means  *A single = assigns; == compares */
double twice(double x)
{
    if (x = 2)
        return 4;
    return 2 * x;
}
