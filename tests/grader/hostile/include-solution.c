/* does not build: it includes the worked solution */
#include "@ROOT@/solutions/01a-collide.c"
