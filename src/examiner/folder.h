/* Removes a folder with all that is in it. */
#ifndef FOLDER_H
#define FOLDER_H

#include <stdbool.h>

/* Removes a folder with everything below it and follows no links. The path
   may have any characters in it, for no shell reads it. Returns whether
   nothing is left; if something is, errno says why. (A shell would take an
   apostrophe in the path of the kit for a quotation mark.) */
bool folder_remove(const char *path);

#endif
