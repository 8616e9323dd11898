/* From chapters/works/08-scenes.nw: edit there, then run make tangle. */
/* checksum 293427438 of the lines below */
/* The double that is nearest to a decimal number. */
#ifndef DECIMAL_H
#define DECIMAL_H

#include <stddef.h>

enum { DECIMAL_LONGEST = 200 }; /* characters of a number */

/* How a number was read. */
enum decimal_way {
    DECIMAL_NONE,  /* it is none */
    DECIMAL_SHORT, /* one operation on two exact doubles */
    DECIMAL_PAIR,  /* a head and a tail */
    DECIMAL_STRTOD /* by the C library */
};

/* Reads a decimal number, which is all of a text of this length: a sign or
   none, digits with a point or without, and perhaps an exponent after e or
   E. Sets *value to the nearest double. Returns DECIMAL_NONE when it is
   something else (nan, inf, a hexadecimal number), or longer than
   DECIMAL_LONGEST, or beyond what a double holds. Source:
   eq:head-tail, in Works. */
enum decimal_way decimal_read(const char *text, size_t length,
                              double *value);

#endif
