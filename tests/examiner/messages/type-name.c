/* does not build: a type that is misspelt */
/* says: means  *doubel is not known here. Is double meant?$ */
double twice(double x)
{
    doubel y = x;
    return x + y;
}
