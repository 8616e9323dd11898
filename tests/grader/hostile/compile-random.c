/* does not build: it includes a device that never ends, nor repeats */
/* long */
#include "/dev/urandom"
