/* The double that is nearest to a decimal number. */
#ifndef DECIMAL_H
#define DECIMAL_H

#include <stddef.h>

enum { DECIMAL_LONGEST = 200 }; /* most characters of a number */

/* The ways to read a number. */
enum decimal_way {
    DECIMAL_NONE,  /* not read: it is no number */
    DECIMAL_SHORT, /* read by one operation on exact doubles */
    DECIMAL_PAIR,  /* read as a sum of two doubles */
    DECIMAL_STRTOD /* read by the C library */
};

/* Reads a decimal number, which fills a text of this length: a sign or
   none, digits with a point or without, and perhaps an exponent after e or
   E. Sets *value to the nearest double. Returns DECIMAL_NONE for anything
   else (nan, inf, a hexadecimal number), and for a number longer than
   DECIMAL_LONGEST or larger than every double.

   strtod would do it, but takes nan, inf and 0x1p3 for numbers, reads 0.1
   or 0,1 according to the locale, and is slow: 17 digits took 80 ns, 30 ns
   here (plots/data/08-reading.dat has more), which counts in a scene of a
   million bodies. So it is kept for the cases that need it. Sources:
   Clinger, PLDI 1990 (one operation); Ziv, ACM Transactions on Mathematical
   Software 17:410, 1991 (compute with a little more precision than needed,
   and test whether it was enough). */
enum decimal_way decimal_read(const char *text, size_t length,
                              double *value);

#endif
