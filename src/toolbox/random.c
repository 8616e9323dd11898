/* Implements xoshiro256**, a logarithm, and variates made with both. */
#include "toolbox/random.h"

#include <assert.h>
#include <math.h>

/* Increases a counter and returns a word that a mixer makes from it. The
   increment is 2^64 over the golden ratio, made odd, so the counter repeats
   only after all 2^64 values; each step of the mixer can be undone. So
   different counters give different words, and of four words in a row at
   most one is zero: the one forbidden state of xoshiro256**, four zeros,
   cannot occur. The seed itself would be a poor state: the scrambler sees
   only the second word, so every seed would begin with 0, and a state of
   mostly zeros stays so for dozens of linear steps. */
static uint64_t splitmix64(uint64_t *counter)
{
    uint64_t z = *counter += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

void random_seed(struct random *r, uint64_t seed)
{
    for (size_t i = 0; i < 4; ++i)
        r->state[i] = splitmix64(&seed);
}

static uint64_t rotate_left(uint64_t x, int by)
{
    return (x << by) | (x >> (64 - by));
}

/* Scrambles (multiplies, rotates, multiplies) a word of the state, then
   steps. The step is linear over the field of two elements and would be
   recognised without the scrambler. Its constants give the period 2^256 -
   1. By hand: the state (1, 2, 3, 4) gives 11520, then 0. */
uint64_t random_bits(struct random *r)
{
    uint64_t *s = r->state;
    const uint64_t result = rotate_left(s[1] * 5, 7) * 9;
    const uint64_t shifted = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = rotate_left(s[3], 45);
    return result;
}

/* Uses the upper 53 bits, which convert exactly. All 64 bits would be
   rounded, and once in 2^54 calls up to 1, which [0,1) excludes. */
double random_uniform(struct random *r)
{
    return (double)(random_bits(r) >> 11) * 0x1p-53;
}

double random_between(struct random *r, double low, double high)
{
    assert(low <= high);
    return low + (high - low) * random_uniform(r);
}

/* Rejects the lowest values drawn. With 2^64 = q n + surplus, plain
   remainders would favour the first `surplus` values; without the lowest
   `surplus` values each remainder has exactly q of them. */
uint64_t random_below(struct random *r, uint64_t n)
{
    uint64_t bits;
    assert(n > 0);
    const uint64_t surplus = (0 - n) % n; /* 2^64 mod n */
    do {
        bits = random_bits(r);
    } while (bits < surplus);
    return bits % n;
}

/* Draws one of the octaves [2^k low, 2^(k+1) low), all equally likely since
   the integral of dx/x over [a, 2a) is log 2 for every a, and in it m from
   1 to 2, kept with probability 1/m. A value of at least `high` is
   rejected, and the octave is drawn again, too. In a single octave m ends
   at high / low, or a range of 1 to 1.001 would reject nearly everything.
   At least log 2 / 2, one in three, of the draws are kept. The number of
   octaves is the smallest K with 2^K low >= high, from frexp, which does
   not round: log and exp of the C library differ between machines. */
double random_log_uniform(struct random *r, double low, double high)
{
    double x, m;
    int low_exponent, high_exponent;
    assert(low > 0 && low <= high);
    const double low_fraction = frexp(low, &low_exponent);
    const double high_fraction = frexp(high, &high_exponent);
    const int octaves =
        high_exponent - low_exponent + (high_fraction > low_fraction);
    if (octaves == 0)
        return low;
    const double widest = octaves == 1 ? high / low : 2.0;
    do {
        const int octave = (int)random_below(r, (uint64_t)octaves);
        m = random_between(r, 1.0, widest);
        x = ldexp(low, octave) * m;
    } while (random_uniform(r) * m >= 1.0 || x >= high);
    return x;
}

/* Uses only + - * /, which IEEE 754 rounds alike everywhere; the C
   library's log differs in its last bits, which is enough to make two runs
   of a gas differ altogether.

   x is 2^e m, with m from sqrt(1/2) to sqrt(2). For s = (m-1)/(m+1) the
   logarithm of m is 2 (s + s^3/3 + s^5/5 + ...), where s^2 <= 0.02944. The
   terms after s^19/19 add less than s^20 / (21 (1 - s^2)) = 2.4e-17 times
   s, which is 0.11 epsilon. s stays outside the loop, so that the rounding
   errors of the loop affect a correction of at most 1 %. log 2 is a sum of
   two parts, the first of 42 bits, so that its product with the exponent
   (11 bits) is exact.

   Error: m - 1 is exact, m + 1 and the quotient are rounded once each, so s
   is right within epsilon; the loop adds 0.05, the series 0.11, and for
   exponent 0 the last addition 0.5 epsilon: less than 1.7 epsilon, that is
   3.4 units in the last place. For other exponents |log x| >= 0.347 and
   |2s| <= 0.343, so the sum is off by at most 0.7 epsilon, less than 3
   units. Hence the header promises 4. Measured at four million points
   against long double: 2. */
double random_log(double x)
{
    int exponent;
    assert(x > 0 && isfinite(x));
    double m = frexp(x, &exponent);
    if (m < 0.70710678118654752) {
        m *= 2;
        --exponent;
    }
    const double s = (m - 1) / (m + 1), square = s * s;
    double sum = 0;
    for (int k = 19; k > 1; k -= 2)
        sum = (sum + 1.0 / k) * square;
    const double high = 0x1.62e42fefa38p-1;  /* upper 42 bits of log 2 */
    const double low = 0x1.ef35793c7673p-45; /* the rest of log 2 */
    return exponent * high + (2 * s + (2 * s * sum + exponent * low));
}

/* Draws a point (u, v) that is uniform in the unit disk. Its angle is
   uniform, with the cosine u / sqrt(t), and t = u^2 + v^2 is uniform in
   (0,1) and independent of the angle. So t serves for the radius as well:
   the square of the radius of two normal variates is distributed as -2 log
   t. The second variate, with v, is thrown away: to keep it the generator
   would have to remember more than its 256 bits, and two programs that draw
   in another order could no longer be compared. */
double random_normal(struct random *r)
{
    double u, v, t;
    do {
        u = 2 * random_uniform(r) - 1;
        v = 2 * random_uniform(r) - 1;
        t = u * u + v * v;
    } while (t >= 1 || t == 0);
    return u * sqrt(-2 * random_log(t) / t);
}

/* Rejects points outside the ball: uniform coordinates divided by their
   length would favour the corners of the cube. In three dimensions 52 % are
   kept. Points within 2^-20 of the centre are rejected, too: coordinates
   are multiples of 2^-52, so few directions exist there. */
void random_direction(struct random *r, size_t dimensions,
                      double direction[])
{
    double square;
    assert(1 <= dimensions && dimensions <= 3);
    do {
        square = 0;
        for (size_t i = 0; i < dimensions; ++i) {
            direction[i] = 2 * random_uniform(r) - 1;
            square += direction[i] * direction[i];
        }
    } while (square > 1 || square < 0x1p-40);
    const double length = sqrt(square);
    for (size_t i = 0; i < dimensions; ++i)
        direction[i] /= length;
}
