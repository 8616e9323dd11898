/* Tests that go through all methods of stepping, whichever there are. */
#ifndef METHODS_H
#define METHODS_H

#include "forces/stepping.h"
#include "unit.h"

/* Checks every row; of those that are wrong says which they are. */
static inline void each_method(
    void (*check)(const struct stepping_method *m))
{
    for (const struct stepping_method *m = stepping_methods; m->name; ++m) {
        const unsigned before = CU_get_number_of_failures();
        check(m);
        if (CU_get_number_of_failures() > before)
            printf("# so it is by %s\n", m->name);
    }
    UNIT_TRUE(stepping_methods[0].name != NULL);
}

#endif
