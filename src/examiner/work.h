/* Makes a temporary folder, and writes files whole or not at all. */
#ifndef WORK_H
#define WORK_H

#include <stdbool.h>
#include <stddef.h>

/* Returns the path of a temporary folder, made at the first call and
   removed at the end. */
const char *work_folder(void);

/* Writes a file so that it is there whole, or as it was before. Returns
   whether that worked; if not, errno says why. */
bool work_write(const char *path, const char *text, size_t length);

#endif
