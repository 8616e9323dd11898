/* does not build: a name that is nowhere */
/* says: means  *zzyx is not known here. Is it spelt right */
double twice(double x)
{
    return zzyx * x;
}
