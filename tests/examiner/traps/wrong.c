/* failed: a wrong answer that nobody has foreseen */
/* says: quantity   twice the length */
/* says: input      x = 1 m */
/* says: expected   2 m */
/* says: got        3 m */
/* says: tolerance  1e-12 m: nothing is rounded */
/* says: question   How much is one and one? */
/* says: also       twice three is six (failed) */
double twice(double x);

double twice(double x)
{
    return 3 * x;
}
