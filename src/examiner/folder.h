/* Removes a folder with all that is in it. */
#ifndef FOLDER_H
#define FOLDER_H

#include <stdbool.h>

/* Removes a folder with everything below it and follows no links. Returns
   whether nothing is left; if something is, errno says why. No shell reads
   the path, since an apostrophe in it would begin a quotation there. */
bool folder_remove(const char *path);

#endif
