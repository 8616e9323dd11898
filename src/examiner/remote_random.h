/* Gives the student's function the suite's random numbers, in blocks. */
#ifndef REMOTE_RANDOM_H
#define REMOTE_RANDOM_H

#include "examiner/remote.h"

double uniform(void);

/* Random numbers are sent in blocks, because thousands of single ones
   would each need a round trip. Blocks of 64 took a tenth longer; larger
   ones than 128 save nothing. */
enum { BLOCK = 128 };

#ifdef REMOTE_SERVER
static struct {
    double u[BLOCK];
    size_t left;
} block;

/* With its answer the sandbox sends how many numbers of the last block are
   left. The judge has only looked ahead, and now draws the numbers that
   were used. */
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
/* In the suite: the numbers that uniform() will give next. */
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

/* Draws the last block, which is used up, and sends the next one. */
void remote_serve_callback(int which)
{
    (void)which;
    use_up(0);
    remote_callback_reply();
    give_block();
}
#endif

#endif
