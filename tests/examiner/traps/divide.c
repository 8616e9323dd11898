/* crashed: a whole number divided by zero */
/* says: zero */
static volatile int zero;

double twice(double x)
{
    return (int)x / zero;
}
