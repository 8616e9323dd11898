/* Tests that go through all methods of stepping, whichever there are. */
#ifndef METHODS_H
#define METHODS_H

#include "forces/stepping.h"
#include "unit.h"

/* The first row at m or behind whose steps are equal; the others have tests
   of their own, in adaptive.c. */
static inline const struct stepping_method *fixed_row(
    const struct stepping_method *m)
{
    while (m->name && m->adaptive)
        ++m;
    return m;
}

/* Checks every row of equal steps; of those that are wrong says which they
 * are. */
static inline void each_method(
    void (*check)(const struct stepping_method *m))
{
    for (const struct stepping_method *m = fixed_row(stepping_methods);
         m->name; m = fixed_row(m + 1)) {
        const unsigned before = CU_get_number_of_failures();
        check(m);
        if (CU_get_number_of_failures() > before)
            printf("# so it is by %s\n", m->name);
    }
    UNIT_TRUE(stepping_methods[0].name != NULL);
}

#endif
