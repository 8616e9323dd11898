/* failed: equal in ten digits, and still not equal */
/* says: expected   2 m */
/* says: got        2.00000000001 */
double twice(double x);

double twice(double x)
{
    return 2 * x + 1e-11;
}
