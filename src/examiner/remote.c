/* Sends and receives numbers, with the same code on both sides. */
#include "examiner/remote.h"
#include "examiner/transport.h"

#include <stdint.h>
#include <stdlib.h>

bool transport_sending;

size_t remote_bytes(size_t count, size_t size)
{
    enum { ROOM = 8 }; /* margin: callers may double a count */
    if (count > SIZE_MAX / ROOM / size)
        transport_lost();
    return count * size;
}

void remote_doubles(double x[], size_t count)
{
    transport_move(x, remote_bytes(count, sizeof *x));
}

void remote_sizes(size_t x[], size_t count)
{
    transport_move(x, remote_bytes(count, sizeof *x));
}

void remote_ints(int x[], size_t count)
{
    transport_move(x, remote_bytes(count, sizeof *x));
}

void remote_unsigneds(unsigned x[], size_t count)
{
    transport_move(x, remote_bytes(count, sizeof *x));
}

/* Sends or receives bools as ints: a bool whose byte is neither 0 nor 1 may
   count as true in one place and as false in another. Doubles need no such
   care, since any eight bytes are a valid double. */
void remote_bools(bool x[], size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        int truth = transport_sending && x[i];
        transport_move(&truth, sizeof truth);
        if (!transport_sending)
            x[i] = truth != 0;
    }
}

unsigned long remote_blocks;

void *remote_memory(size_t bytes)
{
    void *memory = malloc(bytes);
    ++remote_blocks;
    if (!memory && bytes > 0)
        transport_lost();
    return memory;
}

void *remote_array(size_t count, size_t size)
{
    return remote_memory(remote_bytes(count, size));
}
