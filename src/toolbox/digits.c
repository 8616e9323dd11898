/* Formats doubles in 128-bit integers, or by the C library. */
#include "toolbox/digits.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Returns a b / 2^shift, rounded to the nearest whole number, and a tie to
   the even one. The result must fit into 64 bits; shift is 1 to 63. */
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

/* Writes n, which has 17 digits, as the decimal number n 10^(point - 16),
   and returns the end of the text. Zeros at the end of a fraction are left
   out, as %.17g does. The two halves of the digits are independent, so a
   processor works at both at once. */
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

/* Returns 5^k for k from 1 to 21, by squaring. */
static uint64_t five_to(int k)
{
    uint64_t power = k % 2 == 1 ? 5 : 1;
    for (uint64_t square = 25; k > 1; square *= square)
        if ((k /= 2) % 2 == 1)
            power *= square;
    return power;
}

/* Splits a normal number b 2^(e - 53): returns the integer b and sets
 *e. */
static uint64_t take_apart(double size, int *e)
{
    uint64_t bits;
    memcpy(&bits, &size, sizeof bits);
    *e = (int)(bits >> 52) - 1022;
    return (bits & UINT64_C(0xfffffffffffff)) | UINT64_C(1) << 52;
}

/* Multiplies by a power of ten in integers. If 10^p <= x < 10^(p+1), the
   digits are those of 10^(16-p) x, and for x = b 2^(e-53) that is b
   5^(16-p) / 2^(37+p-e). From 1e-4 to 1e15 the power of five has at most 49
   bits, the product 102, and the power of two is 2^1 to 2^45: the division
   is a shift, and the bits shifted out say exactly how to round. The first
   p is floor((e-1) log10 2) or one more. One more gives 18 digits, and so
   does a number that rounds up to 10^17: then the next p is right. */
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
