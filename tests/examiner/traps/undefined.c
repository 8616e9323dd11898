/* does not build: it calls a function that nobody has written */
/* says: Your file calls doubel, which is nowhere */
double doubel(double x);
double twice(double x);

double twice(double x)
{
    return doubel(x);
}
