/* does not build: a brace that is never closed */
/* says: means  *A brace } is missing */
double twice(double x)
{
    if (x > 0) {
        return 2 * x;
        return x + x;
    }
