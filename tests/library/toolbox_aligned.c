/* The toolbox's room: where it begins, what is in it, and too much of it.
 */
#include "toolbox/aligned.h"
#include "unit.h"

#include <stdint.h>

TEST(test_lines, "zeros from the beginning of a line")
{
    for (size_t n = 0; n < 40; ++n) {
        double *room = aligned_doubles(n);
        UNIT_TRUE(room != NULL);
        UNIT_EQUAL((uintptr_t)room % ALIGNED_LINE, 0);
        for (size_t i = 0; i < n; ++i) {
            UNIT_EQUAL(room[i], 0);
            room[i] = 1; /* so that what comes back is not zero */
        }
        free(room);
    }
}

TEST(test_too_much, "more than there is")
{
    UNIT_TRUE(aligned_doubles(SIZE_MAX) == NULL);
    UNIT_TRUE(aligned_doubles(SIZE_MAX / sizeof(double)) == NULL);
    UNIT_TRUE(aligned_doubles(SIZE_MAX / sizeof(double) - ALIGNED_LINE) ==
              NULL);
}
