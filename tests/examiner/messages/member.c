/* does not build: a member that is not there */
/* says: means  *The structure has no such member */
struct length {
    double metres;
};

double twice(double x)
{
    struct length a = {x};
    return 2 * a.feet;
}
