/* does not build: a point where an arrow belongs */
/* says: means  *Behind a pointer a member is written with an arrow */
struct length {
    double metres;
};

double twice(double x)
{
    struct length a = {x}, *b = &a;
    return 2 * b.metres;
}
