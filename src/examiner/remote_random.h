/* Gives the suite's random numbers to the student's function, in blocks. */
#ifndef REMOTE_RANDOM_H
#define REMOTE_RANDOM_H

#include "examiner/remote.h"

double uniform(void);

/* The number of random numbers in a block. Single numbers would take
   thousands of round trips. Blocks of 64 numbers take a tenth longer than
   this; blocks of more than 128 save nothing. */
enum { BLOCK = 128 };

#ifdef REMOTE_SERVER
static struct {
    double u[BLOCK];
    size_t left;
} block;

/* Receives a block of numbers, which the judge has copied without advancing
   its generator. The sandbox's answer says how many numbers of the last
   block are left; the judge then draws those that were used. */
static void take_block(void)
{
    remote_doubles(block.u, BLOCK);
    block.left = BLOCK;
}

double uniform(void)
{
    if (block.left == 0) {
        remote_callback(0);
        remote_callback_wait();
        take_block();
    }
    return block.u[BLOCK - block.left--];
}
#else
/* Copies the next `count` numbers of uniform() to u without advancing the
   generator. Defined by the suite. */
void uniform_ahead(double u[], size_t count);

static void give_block(void)
{
    double u[BLOCK];
    uniform_ahead(u, BLOCK);
    remote_doubles(u, BLOCK);
}

static void use_up(size_t left)
{
    for (size_t k = left; k < BLOCK; ++k)
        (void)uniform();
}

/* Draws the numbers of the last block, all of which were used, and sends
   the next block. */
void remote_serve_callback(int which)
{
    (void)which;
    use_up(0);
    remote_callback_reply();
    give_block();
}
#endif

#endif
