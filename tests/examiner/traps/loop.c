/* timed out: it computes for ever */
/* says: loop that never ends */
/* says: The tests after it were not run */
double twice(double x)
{
    volatile int turning = 1;
    while (turning)
        ;
    return 2 * x;
}
