/* crashed: an index outside its array; the line is told */
/* needs: sanitizers */
/* says: index 3 out of bounds */
/* says: array.c:11 */
static volatile int i = 3;

double twice(double x)
{
    double row[3] = {0};
    row[0] = x;
    row[i] = x;
    return 2 * row[0];
}
