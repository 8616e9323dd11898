/* does not build: the function has another name */
/* says: Was it renamed */
/* says: undefined reference to .twice */
double thrice(double x);

double thrice(double x)
{
    return 3 * x;
}
