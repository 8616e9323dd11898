/* Removes a folder and everything in it. */
#ifndef FOLDER_H
#define FOLDER_H

#include <stdbool.h>

/* Removes a folder and everything below it, without following links.
   Returns whether nothing is left; if not, errno gives the reason. The path
   is not passed to a shell, where an apostrophe would begin a quotation. */
bool folder_remove(const char *path);

#endif
