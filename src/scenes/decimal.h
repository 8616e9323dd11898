/* Reads a decimal number as the nearest double. */
#ifndef DECIMAL_H
#define DECIMAL_H

#include <stddef.h>

enum { DECIMAL_LONGEST = 200 }; /* maximum length of a number */

/* How a number was read. */
enum decimal_way {
    DECIMAL_NONE,  /* not read: not a decimal number */
    DECIMAL_SHORT, /* read by one operation on exact doubles */
    DECIMAL_PAIR,  /* read as a sum of two doubles */
    DECIMAL_STRTOD /* read by the C library */
};

/* Reads a decimal number: an optional sign, digits with or without a point,
   and an optional exponent after e or E. Sets *value to the nearest double.
   Returns DECIMAL_NONE for any other text (nan, inf, a hexadecimal number),
   and for a number longer than DECIMAL_LONGEST or larger than every double.

   strtod alone would accept nan, inf and 0x1p3, and would read 0.1 or 0,1
   depending on the locale. It is also slow, which matters in a scene of a
   million bodies: for 17 digits strtod took 80 ns, this function 30 ns
   (plots/data/08-reading.dat has more). So strtod is called only where it
   is needed. Sources: Clinger, PLDI 1990 (one operation); Ziv, ACM
   Transactions on Mathematical Software 17:410, 1991 (compute with a little
   more precision than needed, and test whether it was enough). */
enum decimal_way decimal_read(const char *text, size_t length,
                              double *value);

#endif
