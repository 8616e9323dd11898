/* Numbers as decimal.c reads them, against strtod. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "unit.h"

#include "scenes/decimal.h"
#include "toolbox/random.h"

#include <locale.h>
#include <sys/mman.h>
#include <unistd.h>

static size_t ways[DECIMAL_STRTOD + 1]; /* how often each was taken */

/* NAN when it is refused. */
static double read_one(const char *text)
{
    double value = 0;
    const enum decimal_way way = decimal_read(text, strlen(text), &value);
    ++ways[way];
    return way == DECIMAL_NONE ? NAN : value;
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Compares with strtod; says whether the bits are equal. */
static bool is_right(const char *text)
{
    const double expected = strtod(text, NULL), got = read_one(text);
    if (!isfinite(expected) ? isnan(got) : same(got, expected))
        return true;
    printf("not ok decimal: %s - it is %.17g, not %.17g\n", text, got,
           expected);
    return false;
}

/* Numbers that are hard to round, from the literature on it: next to the
   middle of two doubles, at both ends of their range. */
TEST(test_hard, "numbers that are hard to round")
{
    static const char hard[] =
        "9007199254740993 9007199254740992.99999999 "
        "9007199254740993.00000000000000000000001 "
        "2.2250738585072011e-308 2.2250738585072014e-308 4.94e-324 "
        "2.47e-324 2.48e-324 1e-400 1.7976931348623157e308 "
        "1.7976931348623158e308 1.7976931348623159e308 5e-324 -0 0e999 "
        "-0.0e-999 123456789012345678901234567890 0.1e22 1e22 1e23 "
        "8.5e22 6.0221407600000004e23 179769313486231570000000000000 "
        "1448997445238699 3.518437208883201171875e13 "
        "30078505129381147446200 9214843084008499 6929495644600919.5 +5 "
        "5. .5 00000000000000000000000000012 1E5 1e+5 1e-05 "
        "0.000000000000000000000000000012 18446744073709551615 "
        "18446744073709551616 1844674407370955161 1e-22 1e-23 "
        "1.00000000000000011102230246251565404236316680908203125 "
        "1.00000000000000011102230246251565404236316680908203124 "
        "1.00000000000000011102230246251565404236316680908203126";
    char text[64];
    int length, read = 0;
    for (const char *at = hard; sscanf(at, "%63s%n", text, &length) == 1;
         at += length, ++read)
        UNIT_TRUE(is_right(text));
    UNIT_EQUAL(read, 44);
    UNIT_TRUE(same(read_one("-0"), -0.0));
}

TEST(test_refused, "what is no number is refused")
{
    static const char *const no[] = {
        "",      "-",        "+",     ".",      "-.",
        "e5",    "1e",       "1e+",   "1e-",    "1.2.3",
        "1e5.",  "1e5e5",    "--1",   "+-1",    "1-",
        "0x10",  "0x1p3",    "nan",   "NAN",    "inf",
        "-Inf",  "infinity", "1,5",   "1 ",     " 1",
        "1d5",   "1f",       "1e999", "-1e309", "1e99999999999999999999",
        "1_000", "\xd9\xa1"};
    for (size_t i = 0; i < sizeof no / sizeof no[0]; ++i) {
        if (!isnan(read_one(no[i])))
            printf("not ok decimal: '%s' is read\n", no[i]);
        UNIT_TRUE(isnan(read_one(no[i])));
    }
    char text[DECIMAL_LONGEST + 2];
    memset(text, '1', sizeof text);
    text[DECIMAL_LONGEST] = '\0';
    UNIT_TRUE(is_right(text));
    text[DECIMAL_LONGEST] = '1';
    text[DECIMAL_LONGEST + 1] = '\0';
    UNIT_TRUE(isnan(read_one(text)));
}

TEST(test_random, "numbers as programs write them")
{
    SEEDED(r, 4);
    char text[64];
    int bad = 0;
    memset(ways, 0, sizeof ways);
    for (int i = 0; i < 200000; ++i) {
        const uint64_t bits = random_bits(&r);
        const int digits = (int)random_below(&r, 20);
        double x =
            ldexp(random_uniform(&r) - 0.5, (int)random_below(&r, 60) - 40);
        if (i % 4 == 0)
            memcpy(&x, &bits, sizeof x); /* any exponent, nan too */
        if (isfinite(x)) {
            snprintf(text, sizeof text, i % 2 ? "%.*e" : "%.*g", digits, x);
            bad += !is_right(text);
        }
    }
    UNIT_EQUAL(bad, 0);
    UNIT_TRUE(ways[DECIMAL_SHORT] > 50000 && ways[DECIMAL_PAIR] > 10000 &&
              ways[DECIMAL_STRTOD] > 10000);
}

/* The middle of two doubles, and one more or less in the 19th digit. */
TEST(test_middles, "the middle of two doubles")
{
    SEEDED(r, 5);
    char text[64];
    int bad = 0;
    memset(ways, 0, sizeof ways);
    for (int i = 0; i < 200000; ++i) {
        /* 54 bits, the last of them 1: times 100 at most 19 digits */
        const uint64_t middle = (random_bits(&r) >> 10) | 1;
        const int exponent = 2 + (int)random_below(&r, 21);
        snprintf(
            text, sizeof text, "%llue-%d",
            (unsigned long long)(middle * 100 + random_below(&r, 3) - 1),
            i % 2 ? 2 : exponent);
        bad += !is_right(text);
    }
    UNIT_EQUAL(bad, 0);
    /* Exact middles are left to the library: of those with an exponent of
       -2 (every other one, and one in 21 of the rest) a third has neither
       more nor less, and half of these have all 54 bits. 6 standard
       deviations are allowed. */
    UNIT_NEAR(ways[DECIMAL_STRTOD], 1e5 * (1 + 1 / 21.) / 6,
              6 * sqrt(1e5 / 6));
    UNIT_EQUAL(ways[DECIMAL_NONE], 0);
}

/* A locale with a comma changes nothing. Where there is none, nothing is
   tested but that. */
TEST(test_locale, "a point is a point in every country")
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE",
                                        "fr_FR.UTF-8", "C"};
    size_t i = 0;
    while (!setlocale(LC_NUMERIC, names[i]))
        ++i;
    UNIT_EQUAL(read_one("1234.5e-40"), 1234.5e-40);
    UNIT_TRUE(isnan(read_one("1,5")));
    setlocale(LC_NUMERIC, "C");
}

TEST(test_ends, "a text has a length")
{
    static const struct {
        const char *text;
        size_t length;
        double value; /* NaN: it is no number */
    } known[] = {{"12e5", 2, 12},  {"12E5", 2, 12},  {"1e5", 2, NAN},
                 {"1e-5", 2, NAN}, {"1e-5", 3, NAN}, {"1e56", 3, 1e5},
                 {"-5", 0, NAN},   {"-5", 1, NAN},   {"-56", 2, -5},
                 {"1.5", 2, 1},    {"1.5", 1, 1},    {"1e5-", 3, 1e5}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        double value = 7;
        const bool read = decimal_read(known[k].text, known[k].length,
                                       &value) != DECIMAL_NONE;
        UNIT_TRUE(read == !isnan(known[k].value));
        UNIT_TRUE(!read || value == known[k].value);
    }
}

/* Which way a number goes: up to 2^53 at once; up to where one more digit
   might be too much for 64 bits in a pair; beyond that by the library. */
TEST(test_ways, "ways to round")
{
    static const struct {
        const char *text;
        enum decimal_way way;
    } known[] = {{"9007199254740992", DECIMAL_SHORT},
                 {"9007199254740993.1", DECIMAL_PAIR},
                 {"9007199254740994", DECIMAL_PAIR},
                 {"18446744073709551597", DECIMAL_PAIR},
                 {"18446744073709551600", DECIMAL_STRTOD},
                 {"1e22", DECIMAL_SHORT},
                 {"1e23", DECIMAL_STRTOD},
                 {"1e-22", DECIMAL_SHORT},
                 {"1e-23", DECIMAL_STRTOD}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        double value = 0;
        const enum decimal_way way =
            decimal_read(known[k].text, strlen(known[k].text), &value);
        if (way != known[k].way)
            printf("# %s\n", known[k].text);
        UNIT_TRUE(way == known[k].way);
        UNIT_TRUE(value == strtod(known[k].text, NULL));
    }
}

/* Nothing is read behind the end of a text, which stands at the end of a
   page that no readable one follows. */
TEST(test_end, "nothing is read behind the end")
{
    static const char *const texts[] = {"1e", "1e-", "-", "1", "1.", "2e7"};
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    char *const pages = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    CU_ASSERT_FATAL(pages != MAP_FAILED);
    CU_ASSERT_FATAL(mprotect(pages + page, page, PROT_NONE) == 0);
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; ++k) {
        const size_t length = strlen(texts[k]);
        double value = 0;
        memcpy(pages + page - length, texts[k], length);
        const enum decimal_way way =
            decimal_read(pages + page - length, length, &value);
        UNIT_TRUE((way == DECIMAL_NONE) == (k < 3));
        UNIT_EQUAL(value, k == 5 ? 2e7 : k > 2 ? 1 : 0);
    }
    munmap(pages, 2 * page);
}
