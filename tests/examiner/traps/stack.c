/* crashed: a function that calls itself without end */
/* says: itself */
static volatile int more = 1;

double twice(double x)
{
    volatile double room[100];
    room[more] = more ? twice(x + 1) : x;
    return room[more] + 1;
}
