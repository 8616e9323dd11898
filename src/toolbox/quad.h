/* The widest floating-point type that the compiler has. */
#ifndef TOOLBOX_QUAD_H
#define TOOLBOX_QUAD_H

#include <float.h>
#include <math.h>

/* The widest floating-point type available, used to see the rounding errors
   of double. QUAD_DIGITS is the number of bits of its mantissa: 113, or
   those of long double (64 on x86-64) where no compiler has more, so a
   program that judges rounding errors prints it. __extension__ keeps the
   compiler from calling __float128 a violation of the standard. */
#if LDBL_MANT_DIG < 113 && defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 quad;
#define QUAD_DIGITS 113
#else
typedef long double quad;
#define QUAD_DIGITS LDBL_MANT_DIG
#endif

/* Returns the square root; the C library has none with this precision.
   Newton's iteration doubles the number of right bits, so two rounds
   suffice after the 53 bits of sqrt(). */
static inline quad quad_root(quad square)
{
    quad r = (quad)sqrt((double)square);
    for (int k = 0; r > 0 && k < 2; ++k)
        r = (r + square / r) / 2;
    return r;
}

#endif
