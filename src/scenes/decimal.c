/* Reads decimal numbers, if possible without calling the C library. */
#include "scenes/decimal.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* The number (-1)^negative * digits * 10^exponent. */
struct decimal {
    uint64_t digits; /* the first 19 digits, or 20 if these fit */
    int exponent;
    bool negative, whole; /* whole: no digit was left out */
};

static bool is_digit(char c)
{
    return '0' <= c && c <= '9';
}

/* Reads digits with or without a point. Returns where they end, or NULL if
   there is no digit. A digit after the point lowers the exponent; a digit
   before the point for which d->digits has no room raises it. */
static const char *read_digits(const char *c, const char *end,
                               struct decimal *d)
{
    bool point = false, any = false;
    for (; c < end && (is_digit(*c) || (*c == '.' && !point)); ++c) {
        if (*c == '.') {
            point = true;
            continue;
        }
        any = true;
        if (d->digits < UINT64_MAX / 10 - 1) {
            d->digits = 10 * d->digits + (uint64_t)(*c - '0');
            d->exponent -= point;
        } else {
            d->whole = false;
            d->exponent += !point;
        }
    }
    return any ? c : NULL;
}

/* Adds the exponent that follows an e to d->exponent. Returns where it
   ends, or NULL if it has no digit. Large exponents such as e99999999999
   are valid, so their value is limited to avoid an overflow. */
static const char *read_exponent(const char *c, const char *end,
                                 struct decimal *d)
{
    int exponent = 0;
    const bool negative = c < end && *c == '-';
    if (c < end && (*c == '-' || *c == '+'))
        ++c;
    if (c == end || !is_digit(*c))
        return NULL;
    for (; c < end && is_digit(*c); ++c)
        if (exponent < 100000)
            exponent = 10 * exponent + (*c - '0');
    d->exponent += negative ? -exponent : exponent;
    return c;
}

/* Splits a text into sign, digits and exponent. Returns false if it
   contains anything else. */
static bool find_decimal(const char *c, size_t length, struct decimal *d)
{
    const char *end = c + length;
    *d = (struct decimal){.whole = true};
    if (c < end && (*c == '-' || *c == '+'))
        d->negative = *c++ == '-';
    c = read_digits(c, end, d);
    if (c && c < end && (*c == 'e' || *c == 'E'))
        c = read_exponent(c + 1, end, d);
    return c == end;
}

/* The powers of ten that are exact doubles. The largest is 10^22 = 2^22
   5^22, since 5^22 < 2^53. */
enum { POWERS = 23 };
static const double power[POWERS] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* Returns whether all digits were kept and the power of ten is an exact
   double. The test of FLT_EVAL_METHOD excludes the wider arithmetic of
   x87. */
static bool is_easy(const struct decimal *d)
{
    return FLT_EVAL_METHOD == 0 && d->whole && abs(d->exponent) < POWERS;
}

/* Returns the double nearest to digits * 10^exponent, for digits <= 2^53.
   Both operands are exact. Only their product or quotient is rounded, and
   IEEE 754 rounds it to the nearest double. */
static double round_short(const struct decimal *d)
{
    const double w = (double)d->digits, p = power[abs(d->exponent)];
    return d->exponent < 0 ? w / p : w * p;
}

/* Returns a * b - product, the exact rounding error of product = a * b.
   Each factor is split into halves of 26 bits, whose products are exact.
   Source: Dekker, Numerische Mathematik 18:224, 1971. */
static double lost_product(double a, double b, double product)
{
    const double split = 134217729; /* 2^27 + 1 */
    const double a1 = split * a - (split * a - a), a2 = a - a1;
    const double b1 = split * b - (split * b - b), b2 = b - b1;
    return ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
}

/* Sets *value to the double nearest to digits * 10^exponent. The digits
   have more than 53 bits, and the power of ten p is exact. Returns false if
   it is not certain which double is nearest.

   The digits are the sum of two doubles, high and low, where low has the
   lowest eleven bits.

   Multiplication: high * p is known exactly as a sum of two doubles, and
   low * p is added to it.

   Division: head is the rounded quotient high / p, and back is the rounded
   product head * p. As back is close to high, their difference is exact.
   The remainder high - head * p is exact as well, since it is a double.

   In both cases the number is head + tail + rest, with |tail| <= 2^-41
   |head|. The tail is rounded two or three times to its own 53 bits, so
   |rest| < 2^-90 |head|. If head + (tail - 2^-90 head) and head + (tail +
   2^-90 head) round to the same double, so does every number between them.
   For random digits they round differently about once in 2^36 numbers. */
static bool round_pair(const struct decimal *d, double *value)
{
    const double high = (double)(d->digits & ~(uint64_t)2047);
    const double low = (double)(d->digits & 2047);
    const double p = power[abs(d->exponent)];
    const double head = d->exponent < 0 ? high / p : high * p;
    double tail;
    if (d->exponent < 0) {
        const double back = head * p;
        tail = ((high - back) - lost_product(head, p, back) + low) / p;
    } else {
        tail = lost_product(high, p, head) + low * p;
    }
    const double doubt = 0x1p-90 * head;
    *value = head + tail;
    return head + (tail - doubt) == head + (tail + doubt);
}

/* Returns the number as strtod converts it. Removes its decimal point
   first: 12.5e-40 becomes 125e-41, which strtod reads correctly in every
   locale. */
static double round_by_library(const char *c, size_t length)
{
    char text[DECIMAL_LONGEST + 16];
    const char *end = c + length;
    struct decimal d = {.whole = true};
    bool point = false;
    size_t n = 0;
    for (; c < end && *c != 'e' && *c != 'E'; ++c)
        if (*c == '.') {
            point = true;
        } else {
            text[n++] = *c;
            d.exponent -= point;
        }
    if (c < end)
        read_exponent(c + 1, end, &d);
    snprintf(text + n, sizeof text - n, "e%d", d.exponent);
    return strtod(text, NULL);
}

enum decimal_way decimal_read(const char *text, size_t length,
                              double *value)
{
    const uint64_t exact = (uint64_t)1 << 53;
    enum decimal_way way = DECIMAL_STRTOD;
    struct decimal d;
    if (length > DECIMAL_LONGEST || !find_decimal(text, length, &d))
        return DECIMAL_NONE;
    if (is_easy(&d) && d.digits <= exact) {
        way = DECIMAL_SHORT;
        *value = round_short(&d);
    } else if (is_easy(&d) && round_pair(&d, value)) {
        way = DECIMAL_PAIR;
    } else {
        *value = fabs(round_by_library(text, length));
    }
    if (d.negative)
        *value = -*value;
    return isfinite(*value) ? way : DECIMAL_NONE;
}
