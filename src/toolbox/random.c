/* Implements xoshiro256**, a logarithm, and distributions based on both. */
#include "toolbox/random.h"

#include <assert.h>
#include <math.h>

/* Increases *counter and returns a word that a mixer computes from it. The
   increment is 2^64 divided by the golden ratio, rounded to an odd number,
   so the counter takes all 2^64 values before it repeats. Each step of the
   mixer is invertible, so different counters give different words. Of four
   successive words at most one is therefore zero, and the one forbidden
   state of xoshiro256**, four zeros, cannot occur.

   A state made of the seed and three zeros would be poor. random_bits
   returns a function of the second word only, so every sequence would begin
   with 0. Also, a state of mostly zeros stays mostly zeros for dozens of
   steps. */
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

/* Scrambles a word of the state (multiplies, rotates, multiplies), then
   steps. The step is linear over the field of two elements. Without the
   scrambling, tests of randomness would detect this. The constants of the
   step give the period 2^256 - 1. Computed by hand: the state (1, 2, 3, 4)
   gives 11520, then 0. */
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

/* Uses the upper 53 bits, which a double represents exactly. Rounding all
   64 bits would give 1 once in 2^54 calls, but the interval [0,1) excludes
   1. */
double random_uniform(struct random *r)
{
    return (double)(random_bits(r) >> 11) * 0x1p-53;
}

double random_between(struct random *r, double low, double high)
{
    assert(low <= high);
    return low + (high - low) * random_uniform(r);
}

/* Rejects the lowest `surplus' values of bits, where 2^64 = q n + surplus.
   Without rejection, the remainders below surplus would belong to q + 1
   values and the others to q. With rejection, every remainder belongs to
   exactly q values. */
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

/* Draws one of the octaves [2^k low, 2^(k+1) low). All octaves are equally
   likely, because the integral of dx/x over [a, 2a) is log 2 for every a.
   Within the octave, draws m uniformly from 1 to 2 and accepts it with
   probability 1/m. If the result is `high' or more, rejects it and draws
   the octave again, too. If there is only one octave, m is drawn from 1 to
   high / low instead: with m up to 2, a range such as 1 to 1.001 would
   reject nearly everything. At least log 2 / 2 of the draws, one in three,
   are accepted.

   The number of octaves is the smallest K with 2^K low >= high. frexp gives
   this number without rounding. The C library's log and exp cannot be used,
   because they differ between machines. */
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

/* Uses only + - * /, which IEEE 754 rounds alike everywhere. The C
   library's log differs in its last bits between machines. That is enough
   to make two runs of a gas differ completely.

   Let x = 2^e m with m from sqrt(1/2) to sqrt(2), and s = (m-1)/(m+1). The
   logarithm of m is 2 (s + s^3/3 + s^5/5 + ...), where s^2 <= 0.02944. The
   terms after s^19/19 add less than s^20 / (21 (1 - s^2)) = 2.4e-17 times
   s, which is 0.11 epsilon. The loop does not include the first term, s, so
   the rounding errors of the loop affect a correction of at most 1 %. log 2
   is a sum of two parts. The first part has 42 bits, so its product with
   the exponent (11 bits) is exact.

   Error: m - 1 is exact, and m + 1 and the quotient are rounded once each,
   so s is right within epsilon. The loop adds 0.05 epsilon, the series 0.11
   and, for exponent 0, the last addition 0.5. The total is less than 1.7
   epsilon, that is 3.4 units in the last place. For other exponents |log x|
   >= 0.347 and |2s| <= 0.343, so the error of the sum is at most 0.7
   epsilon, less than 3 units. The header therefore promises 4 units.
   Measured at four million points against long double: 2 units. */
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

/* Draws a point (u, v) uniformly from the unit disk. Let t = u^2 + v^2. The
   angle of the point is uniform and has the cosine u / sqrt(t). t is
   uniform in (0,1) and independent of the angle. So t can also determine
   the radius: the sum of the squares of two normal variates is distributed
   like -2 log t. A second variate could be computed from v, but the
   generator would have to store it in addition to its 256 bits. Two
   programs that draw in different orders could then not be compared. */
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

/* Rejects points outside the unit ball, because the corners of the cube
   would make some directions more likely. In three dimensions 52 % of the
   points are accepted. Also rejects points within 2^-20 of the centre:
   coordinates are multiples of 2^-52, so few directions exist there. */
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
