/* passed: a right answer */
double twice(double x);

double twice(double x)
{
    return x + x;
}
