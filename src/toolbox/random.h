/* Random numbers that are the same on every machine. */
/* The C library's rand differs from machine to machine, so generator,
   logarithm and variates are our own. They are not for secrets: a few
   outputs determine the rest. Two threads must not draw from one generator,
   since the order of their draws would be chance: draw a seed for each run
   before the threads start. */
#ifndef TOOLBOX_RANDOM_H
#define TOOLBOX_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/* A generator: the 256 bits of xoshiro256**, never all zero. Nothing else
   is remembered, so a copy of the struct continues the same sequence. */
struct random {
    uint64_t state[4];
};

/* Returns the next 64 bits. Source: xoshiro256**, Blackman and Vigna,
   ACM Transactions on Mathematical Software 47:36, 2021. */
uint64_t random_bits(struct random *r);

/* Sets the state from one number, through splitmix64. Any seed is good;
   equal seeds give equal sequences on every machine. Source: Steele, Lea
   and Flood, OOPSLA 2014, page 453. */
void random_seed(struct random *r, uint64_t seed);

/* Returns a multiple of 2^-53 in [0,1), each equally likely. */
double random_uniform(struct random *r);

/* Returns low + (high - low) u with u from random_uniform. Requires low <=
   high with a finite difference. Only rounding can give high itself. */
double random_between(struct random *r, double low, double high);

/* Returns a whole number from 0 to n-1, each exactly equally likely.
   Requires n > 0. */
uint64_t random_below(struct random *r, uint64_t n);

/* Returns a number from [low, high) with density proportional to 1/x, so
   that every factor of two in the range is equally likely. If low = high,
   returns low. Requires 0 < low <= high, finite and not subnormal. */
double random_log_uniform(struct random *r, double low, double high);

/* Returns the natural logarithm of x within 4 units in the last place, the
   same bits on every machine. Requires x > 0, finite. Source: the series
   of 2 artanh((x-1)/(x+1)). */
double random_log(double x);

/* Returns a normal variate of mean 0 and variance 1. Source: the polar
   method, Marsaglia and Bray, SIAM Review 6:260, 1964. */
double random_normal(struct random *r);

/* Fills direction[0..dimensions-1] with a unit vector, every direction
   equally likely; its length is 1 within 4e-16. Requires dimensions 1, 2
   or 3. Source: rejection, von Neumann, NBS Applied Mathematics Series
   12:36, 1951. */
void random_direction(struct random *r, size_t dimensions,
                      double direction[]);

#endif
