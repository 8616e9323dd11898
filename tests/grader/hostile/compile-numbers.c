/* does not build: a table of a hundred million numbers */
/* long */
#include "exercise.h"

int table[100000000] = {[0 ... 99999999] = 7};
