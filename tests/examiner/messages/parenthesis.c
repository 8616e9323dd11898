/* does not build: a parenthesis that is not closed */
/* says: means  *A parenthesis is missing */
double twice(double x)
{
    return 2 * (x + 0;
}
