/* Random numbers that are the same on every machine. */
/* The C library's rand differs between machines, so this file has its own
   generator, logarithm and distributions. Do not use them for secrets,
   because a few outputs determine the rest. Two threads must not draw from
   one generator, because the order of their draws would be left to chance.
   Draw a seed for each run before the threads start. */
#ifndef TOOLBOX_RANDOM_H
#define TOOLBOX_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/* The state of the generator xoshiro256**, never all zero. A copy of the
   struct continues the same sequence. */
struct random {
    uint64_t state[4];
};

/* Returns the next 64 random bits. Source: xoshiro256**, Blackman and
   Vigna, ACM Transactions on Mathematical Software 47:36, 2021. */
uint64_t random_bits(struct random *r);

/* Computes the state from seed with splitmix64. Any seed is good. Equal
   seeds give equal sequences on every machine. Source: Steele, Lea and
   Flood, OOPSLA 2014, page 453. */
void random_seed(struct random *r, uint64_t seed);

/* Returns a random multiple of 2^-53 in [0,1). All are equally likely. */
double random_uniform(struct random *r);

/* Returns a uniformly distributed random number from low to high: low +
   (high - low) u with u from random_uniform. Only rounding can make the
   result equal to high. Requires low <= high and a finite difference. */
double random_between(struct random *r, double low, double high);

/* Returns a random whole number from 0 to n - 1. All are exactly equally
   likely. Requires n > 0. */
uint64_t random_below(struct random *r, uint64_t n);

/* Returns a random number x in [low, high) with a density proportional to
   1/x: all intervals from a to 2a in the range are equally likely. If low =
   high, returns low. Requires 0 < low <= high, both finite and not
   subnormal. */
double random_log_uniform(struct random *r, double low, double high);

/* Returns the natural logarithm of x with an error of at most 4 units in
   the last place, and with the same bits on every machine. Requires x > 0,
   finite. Source: the series of 2 artanh((x-1)/(x+1)). */
double random_log(double x);

/* Returns a normally distributed random number with mean 0 and variance 1.
   Source: the polar method, Marsaglia and Bray, SIAM Review 6:260, 1964. */
double random_normal(struct random *r);

/* Fills direction[0..dimensions-1] with a random unit vector. All
   directions are equally likely. The length of the vector is 1 within
   4e-16. Requires dimensions = 1, 2 or 3. Source: rejection, von Neumann,
   NBS Applied Mathematics Series 12:36, 1951. */
void random_direction(struct random *r, size_t dimensions,
                      double direction[]);

#endif
