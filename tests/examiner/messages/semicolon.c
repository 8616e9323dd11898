/* does not build: a statement without its semicolon */
/* says: semicolon.c:[89]:.* error: expected */
/* says: means  *A statement ends with a semicolon */
double twice(double x);

double twice(double x)
{
    double two = 2 return two * x;
}
