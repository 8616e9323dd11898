/* does not build: an else whose if has ended */
/* says: error: */
/* says: means */
double twice(double x)
{
    if (x > 0)
        ;
    x = 2 * x;
    else x = x + x;
    return x;
}
