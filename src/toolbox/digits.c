/* Formats doubles with 128-bit integers or, outside their range, printf. */
#include "toolbox/digits.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Returns a b / 2^shift, rounded to the nearest integer, ties to even. The
   result must fit into 64 bits. Requires 1 <= shift <= 63. */
static uint64_t scaled(uint64_t a, uint64_t b, int shift)
{
    const uint64_t a0 = a & UINT32_MAX, a1 = a >> 32;
    const uint64_t b0 = b & UINT32_MAX, b1 = b >> 32;
    const uint64_t second = a1 * b0 + (a0 * b0 >> 32);
    const uint64_t third = a0 * b1 + (second & UINT32_MAX);
    const uint64_t high = a1 * b1 + (second >> 32) + (third >> 32);
    const uint64_t low = third << 32 | (a0 * b0 & UINT32_MAX);
    const uint64_t whole = high << (64 - shift) | low >> shift;
    const uint64_t rest = low << (64 - shift), half = UINT64_C(1) << 63;
    return whole + (rest > half || (rest == half && whole % 2 == 1));
}

enum { DIGITS = 17, HALF = 8 };

/* Writes n 10^(point - 16) as a decimal number and returns the end of the
   text. n has 17 digits. Omits zeros at the end of a fraction, as %.17g
   does. The loop converts eight upper and eight lower digits independently,
   so a processor can work on both at once. */
static char *write_digits(char *c, uint64_t n, int point)
{
    char digit[DIGITS];
    uint32_t high = (uint32_t)(n / 100000000);
    uint32_t low = (uint32_t)(n % 100000000);
    for (int i = HALF; i > 0; --i, high /= 10, low /= 10) {
        digit[i + HALF] = (char)('0' + low % 10);
        digit[i] = (char)('0' + high % 10);
    }
    digit[0] = (char)('0' + high);
    int last = DIGITS - 1;
    while (last > point && last > 0 && digit[last] == '0')
        --last;
    for (int i = point; i < 0; ++i) {
        *c++ = '0';
        if (i == point)
            *c++ = '.';
    }
    for (int i = 0; i <= last; ++i) {
        if (i > 0 && i == point + 1)
            *c++ = '.';
        *c++ = digit[i];
    }
    *c = '\0';
    return c;
}

/* Returns 5^k, computed by repeated squaring. Requires 1 <= k <= 21. */
static uint64_t five_to(int k)
{
    uint64_t power = k % 2 == 1 ? 5 : 1;
    for (uint64_t square = 25; k > 1; square *= square)
        if ((k /= 2) % 2 == 1)
            power *= square;
    return power;
}

/* Splits a normal number: size = b 2^(*e - 53) with an integer b. Returns
   b. */
static uint64_t take_apart(double size, int *e)
{
    uint64_t bits;
    memcpy(&bits, &size, sizeof bits);
    *e = (int)(bits >> 52) - 1022;
    return (bits & UINT64_C(0xfffffffffffff)) | UINT64_C(1) << 52;
}

/* Multiplies x, the absolute value, by a power of ten in integer
   arithmetic. If 10^p <= x < 10^(p+1), the digits of x are those of
   10^(16-p) x. For x = b 2^(e-53), that product is b 5^(16-p) / 2^(37+p-e).
   From 1e-4 to 1e15 the power of five has at most 49 bits and the product
   at most 102. The power of two is 2^1 to 2^45, so the division is a shift,
   and the bits shifted out determine the rounding exactly.

   p is floor((e-1) log10 2) or one more. If the first p is too small, the
   result has 18 digits. The result also has 18 digits if it rounds up to
   10^17. In both cases p + 1 is right. */
size_t digits_write(char text[DIGITS_ROOM], double value)
{
    const double size = fabs(value);
    text[0] = '-';
    char *begin = signbit(value) ? text + 1 : text;
    if (value == 0) {
        memcpy(begin, "0", 2);
        return (size_t)(begin + 1 - text);
    }
    if (!(1e-4 <= size && size < 1e15))
        return (size_t)snprintf(text, DIGITS_ROOM, "%.17g", value);
    int e;
    const uint64_t bits = take_apart(size, &e);
    int point = (int)(5 + (e - 1) * 0.30102999566398120) - 5;
    uint64_t n = scaled(bits, five_to(16 - point), 37 + point - e);
    if (n >= UINT64_C(100000000000000000)) {
        ++point;
        n = scaled(bits, five_to(16 - point), 37 + point - e);
    }
    return (size_t)(write_digits(begin, n, point) - text);
}
