/* does not build: a minus sign that was copied from a page */
/* says: means  *Here is a character that C does not know */
double twice(double x)
{
    return x + x − 0;
}
