/* Project P3: nothing crosses but its arguments, its file and its table,
   see examiner/run.h; and it is given nothing. */
/* output: none */

#include "examiner/run.h"
