/* does not build: a main program of its own */
/* says: multiple definition of .main */
double twice(double x)
{
    return 2 * x;
}

int main(void)
{
    return 0;
}
