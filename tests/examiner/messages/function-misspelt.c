/* does not build: a function that is misspelt */
/* says: function-misspelt.c:6:16: error: */
/* says: means  *fabz is not known here */
double twice(double x)
{
    return x + fabz(x);
}
