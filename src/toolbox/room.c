/* Allocates doubles that begin with a line of the cache. */
#include "toolbox/room.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* For n = 0 takes one byte, so that NULL always means that there is no
   memory; otherwise no more than asked for, so that a sanitizer notices
   whoever reads behind the end. */
double *room_doubles(size_t n)
{
    void *room;
    if (n > SIZE_MAX / sizeof(double) ||
        posix_memalign(&room, ROOM_LINE, n > 0 ? n * sizeof(double) : 1))
        return NULL;
    return memset(room, 0, n * sizeof(double));
}
