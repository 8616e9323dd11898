/* failed: a wrong answer that is known */
/* says: hint       Twice is not squared. .squared. */
double twice(double x);

double twice(double x)
{
    return x > 1 ? x * x : 2 * x;
}
