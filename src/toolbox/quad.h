/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 2219520957 of the lines below */
/* The widest floating-point type that the compiler has. */
#ifndef TOOLBOX_QUAD_H
#define TOOLBOX_QUAD_H

#include <float.h>

/* quad: the widest floating-point number at hand, used to see what double
   has rounded away. QUAD_DIGITS is the number of bits of its mantissa:
   113, or fewer where there is no such type. */
#if LDBL_MANT_DIG < 113 && defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 quad;
#define QUAD_DIGITS 113
#else
typedef long double quad;
#define QUAD_DIGITS LDBL_MANT_DIG
#endif

#endif
