/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 2139139055 of the lines below */
/* xoshiro256**, a logarithm of our own, and variates from both. */
#include "toolbox/random.h"

#include <assert.h>
#include <math.h>

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

double random_uniform(struct random *r)
{
    return (double)(random_bits(r) >> 11) * 0x1p-53;
}

double random_between(struct random *r, double low, double high)
{
    assert(low <= high);
    return low + (high - low) * random_uniform(r);
}

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
    const double high = 0x1.62e42fefa38p-1;  /* log 2, 42 bits of it */
    const double low = 0x1.ef35793c7673p-45; /* and what is left */
    return exponent * high + (2 * s + (2 * s * sum + exponent * low));
}

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
