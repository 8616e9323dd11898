/* does not build: a power as one writes it on paper */
/* says: means  *The signs ^ and % are for whole numbers */
double twice(double x)
{
    return 2 * x + 0 * x ^ 2;
}
