/* does not build: it includes a device that never ends */
#include "/dev/zero"
