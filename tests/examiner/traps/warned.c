/* failed: the compiler had seen it coming */
/* says: The compiler has a warning */
/* says: unused variable .result */
double twice(double x)
{
    double result = 2 * x;
    return x;
}
