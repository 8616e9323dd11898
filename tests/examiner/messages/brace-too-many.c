/* does not build: a brace too many */
/* says: means  *This stands outside of every function */
double twice(double x)
{
    if (x > 0)
        return 2 * x;
}
return x + x;
}
