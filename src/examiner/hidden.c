/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 3127572923 of the lines below */
#include "examiner/check.h"

#include <stddef.h>

const struct check_test check_hidden[] = {{NULL, NULL, 0, 0}};
