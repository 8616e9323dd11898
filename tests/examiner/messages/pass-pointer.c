/* does not build: a pointer is handed over for a number */
/* says: means  *The types do not fit */
static double add(double a, double b)
{
    return a + b;
}

double twice(double x)
{
    return add(&x, x);
}
