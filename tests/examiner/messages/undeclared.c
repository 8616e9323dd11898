/* does not build: a name that is misspelt */
/* says: means  *lenght is not known here. Is length meant?$ */
double twice(double length)
{
    double twofold = 2 * length;
    return twofold + 0 * lenght;
}
