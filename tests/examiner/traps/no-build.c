/* does not build: a name that nobody has declared */
/* says: no-build.c:8:12: error: */
/* says: and 1 more */
double twice(double x);

double twice(double x)
{
    return y + x + z;
}
