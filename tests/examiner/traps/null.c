/* crashed: a pointer that leads nowhere */
/* needs: sanitizers */
/* says: null pointer */
double twice(double x)
{
    double *volatile nowhere = 0;
    return *nowhere + x;
}
