/* does not build: an array of a gigabyte, with numbers in it */
#include "exercise.h"

char array[1 << 30] = {1};
