/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 4117010685 of the lines below */
/* Memory that begins with a line of the cache. */
#ifndef TOOLBOX_ROOM_H
#define TOOLBOX_ROOM_H

#include <stddef.h>

enum { ROOM_LINE = 64 }; /* bytes */

/* Returns n doubles, all 0, that begin with a line of the cache; NULL
   without memory. Goes back with free(). */
double *room_doubles(size_t n);

#endif
