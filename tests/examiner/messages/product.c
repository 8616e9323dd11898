/* does not build: a product without its sign */
/* says: means  *A parenthesis behind a number or a variable calls it */
double twice(double x)
{
    return 2(x);
}
