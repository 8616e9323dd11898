/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 86863988 of the lines below */
/* Whole numbers of two words where they suffice, else the C library. */
#include "toolbox/digits.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>

/* Returns a b / 2^shift, rounded to the nearest whole number, a half to the
   even one. It must fit into 64 bits; shift is 1 to 63. */
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

enum { DIGITS = 17 };

/* Writes n, of 17 digits, as a number between 10^point and ten times that;
   returns the end. */
static char *write_digits(char *c, uint64_t n, int point)
{
    char digit[DIGITS];
    int last = 0;
    for (int i = DIGITS - 1; i >= 0; --i, n /= 10) {
        digit[i] = (char)('0' + n % 10);
        last = last == 0 && n % 10 > 0 ? i : last;
    }
    for (int i = point; i < 0; ++i) {
        *c++ = '0';
        if (i == point)
            *c++ = '.';
    }
    for (int i = 0; i <= last || i <= point; ++i) {
        if (i > 0 && i == point + 1)
            *c++ = '.';
        *c++ = digit[i];
    }
    *c = '\0';
    return c;
}

static uint64_t five_to(int k)
{
    uint64_t power = 1;
    for (; k > 0; --k)
        power *= 5;
    return power;
}

size_t digits_write(char text[DIGITS_ROOM], double value)
{
    const double size = fabs(value);
    if (!(1e-4 <= size && size < 1e15))
        return (size_t)snprintf(text, DIGITS_ROOM, "%.17g", value);
    int e;
    const uint64_t bits = (uint64_t)ldexp(frexp(size, &e), 53);
    int point = (int)floor((e - 1) * 0.30102999566398120);
    uint64_t n = scaled(bits, five_to(16 - point), 37 + point - e);
    if (n >= UINT64_C(100000000000000000)) {
        ++point;
        n = scaled(bits, five_to(16 - point), 37 + point - e);
    }
    text[0] = '-';
    char *begin = value < 0 ? text + 1 : text;
    return (size_t)(write_digits(begin, n, point) - text);
}
