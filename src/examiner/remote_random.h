/* Gives the suite's random numbers to the student's function, in blocks. */
#ifndef REMOTE_RANDOM_H
#define REMOTE_RANDOM_H

#include "examiner/remote.h"

double uniform(void);

/* Numbers in a block. Single numbers would need thousands of round trips.
   Blocks of 64 took a tenth longer; larger ones than 128 save nothing. */
enum { BLOCK = 128 };

#ifdef REMOTE_SERVER
static struct {
    double u[BLOCK];
    size_t left;
} block;

/* Receives a block. With its answer the sandbox sends how many numbers of
   the last block are left: the judge has only looked ahead, and then draws
   those that were used. */
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
/* Copies the numbers that uniform() will return next; defined by the
   suite. */
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

/* Draws the last block, since all of it was used, and sends the next
   one. */
void remote_serve_callback(int which)
{
    (void)which;
    use_up(0);
    remote_callback_reply();
    give_block();
}
#endif

#endif
