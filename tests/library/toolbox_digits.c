/* Digits against printf's, byte for byte. */
#include "unit.h"

#include "toolbox/digits.h"
#include "toolbox/random.h"

#include <stdint.h>

static bool is_same(double x)
{
    char got[DIGITS_ROOM], expected[DIGITS_ROOM];
    const size_t n = digits_write(got, x);
    snprintf(expected, sizeof expected, "%.17g", x);
    if (strcmp(got, expected) == 0 && n == strlen(expected))
        return true;
    printf("# %s, not %s\n", got, expected);
    return false;
}

static bool both_signs(double x)
{
    return is_same(x) && is_same(-x);
}

TEST(test_powers, "powers and their neighbours")
{
    for (int base = 2; base <= 10; base += 8)
        for (int k = -30; k <= 60; ++k) {
            double x = pow(base, k);
            for (int i = 0; i < 3; ++i)
                x = nextafter(x, 0);
            for (int i = -3; i <= 3; ++i, x = nextafter(x, INFINITY))
                UNIT_TRUE(both_signs(x));
        }
}

/* Of a number of few bits the digits end, many of them halfway between two
   numbers of 17 digits. */
TEST(test_halves, "halves go to the even one")
{
    SEEDED(r, 1);
    for (int i = 0; i < 100000; ++i)
        UNIT_TRUE(both_signs(ldexp((double)random_below(&r, 1 << 16),
                                   (int)random_below(&r, 80) - 70)));
    for (int k = 0; k < 400; ++k)
        UNIT_TRUE(is_same(k) && is_same(k / 8.0) && is_same(k * 1e6));
}

TEST(test_every_size, "numbers of every size")
{
    SEEDED(r, 2);
    for (int i = 0; i < 400000; ++i)
        UNIT_TRUE(both_signs(pow(10, random_between(&r, -6, 18))));
    for (int i = 0; i < 100000; ++i)
        UNIT_TRUE(is_same(random_between(&r, -4, 4)));
}

TEST(test_others, "what is left to printf")
{
    static const double others[] = {0,        5e-324,   1e-300, 9.9e-5,
                                    1e15,     1.5e16,   1e17,   1e300,
                                    INFINITY, 2.2e-308, 1e-4};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i)
        UNIT_TRUE(both_signs(others[i]));
}
