/* Supplies an empty list to exercises that have no hidden tests. */
#include "examiner/check.h"

#include <stddef.h>

const struct check_test check_hidden[] = {{NULL, NULL, 0, 0}};
