/* From chapters/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 3980507904 of the lines below */
#include "toolbox/room.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

double *room_doubles(size_t n)
{
    if (n > SIZE_MAX / sizeof(double) - ROOM_LINE)
        return NULL;
    const size_t lines = n * sizeof(double) / ROOM_LINE + 1;
    double *const room = aligned_alloc(ROOM_LINE, lines * ROOM_LINE);
    if (room)
        memset(room, 0, lines * ROOM_LINE);
    return room;
}
