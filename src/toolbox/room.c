/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 447200842 of the lines below */
/* Whole lines of the cache, all zero. */
#include "toolbox/room.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

double *room_doubles(size_t n)
{
    void *room;
    if (n > SIZE_MAX / sizeof(double) ||
        posix_memalign(&room, ROOM_LINE, n > 0 ? n * sizeof(double) : 1))
        return NULL;
    return memset(room, 0, n * sizeof(double));
}
