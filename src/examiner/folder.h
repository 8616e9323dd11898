/* From chapters/works/B-examiner.nw: edit there, then run make tangle. */
/* checksum 2430027943 of the lines below */
/* Removes a folder with all that is in it. */
#ifndef FOLDER_H
#define FOLDER_H

#include <stdbool.h>

/* Removes a folder with everything below it and follows no links. The path
   may have any characters in it, for no shell reads it. Returns whether
   nothing is left; if something is, errno says why. */
bool folder_remove(const char *path);

#endif
