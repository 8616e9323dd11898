/* Sends and receives numbers of each type, the same code for both sides. */
#include "examiner/border.h"
#include "examiner/wire.h"

#include <stdint.h>
#include <stdlib.h>

bool wire_speaking;

size_t border_bytes(size_t count, size_t size)
{
    enum { ROOM = 8 }; /* for what is added to it, or made twice as long */
    if (count > SIZE_MAX / ROOM / size)
        wire_lost();
    return count * size;
}

void border_doubles(double x[], size_t count)
{
    wire_move(x, border_bytes(count, sizeof *x));
}

void border_sizes(size_t x[], size_t count)
{
    wire_move(x, border_bytes(count, sizeof *x));
}

void border_ints(int x[], size_t count)
{
    wire_move(x, border_bytes(count, sizeof *x));
}

void border_unsigneds(unsigned x[], size_t count)
{
    wire_move(x, border_bytes(count, sizeof *x));
}

/* Sends or receives truth values. A byte other than 0 and 1 in a bool may
   be true in one place and false in the next, so it crosses as an int. Any
   eight bytes are some double. */
void border_bools(bool x[], size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        int truth = wire_speaking && x[i];
        wire_move(&truth, sizeof truth);
        if (!wire_speaking)
            x[i] = truth != 0;
    }
}

unsigned long border_blocks;

void *border_memory(size_t bytes)
{
    void *memory = malloc(bytes);
    ++border_blocks;
    if (!memory && bytes > 0)
        wire_lost();
    return memory;
}

void *border_array(size_t count, size_t size)
{
    return border_memory(border_bytes(count, size));
}
