/* failed: a number that two known mistakes give names neither */
/* says: got        1 m */
/* says: question   How much is one and one?$ */
double twice(double x);

double twice(double x)
{
    return x;
}
