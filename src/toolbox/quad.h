/* The widest floating-point type that the compiler has. */
#ifndef TOOLBOX_QUAD_H
#define TOOLBOX_QUAD_H

#include <float.h>
#include <math.h>

/* The widest floating-point type available. Programs use it to measure the
   rounding errors of double. They print QUAD_DIGITS, the number of bits in
   the mantissa of quad: 113 or, with compilers that have no such type, the
   bits of long double (64 on x86-64). __extension__ suppresses the warning
   that __float128 is not standard C. */
#if LDBL_MANT_DIG < 113 && defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 quad;
#define QUAD_DIGITS 113
#else
typedef long double quad;
#define QUAD_DIGITS LDBL_MANT_DIG
#endif

/* Returns the square root of `square', which sqrt() computes only to 53
   bits. Each round of Newton's iteration doubles the number of right bits,
   so two rounds suffice. */
static inline quad quad_root(quad square)
{
    quad r = (quad)sqrt((double)square);
    for (int k = 0; r > 0 && k < 2; ++k)
        r = (r + square / r) / 2;
    return r;
}

#endif
