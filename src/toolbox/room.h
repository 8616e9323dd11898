/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 455798779 of the lines below */
#ifndef TOOLBOX_ROOM_H
#define TOOLBOX_ROOM_H

#include <stddef.h>

enum { ROOM_LINE = 64 }; /* bytes */

/* Returns n doubles, all 0, that begin with a line of the cache; NULL
   without memory. Goes back with free(). */
double *room_doubles(size_t n);

#endif
