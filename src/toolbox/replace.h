/* Writes files that are whole or absent, under a temporary name first. */
#ifndef TOOLBOX_REPLACE_H
#define TOOLBOX_REPLACE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* mode of a new file: 0666 without the bits of the process's umask */
#define REPLACE_USUAL ((mode_t)(-1))

/* Creates a file with these permissions in the folder of path, under a
   unique name, bonkers.XXXXXX. Returns its descriptor, above the standard
   three, and its name in *temporary; or -1, with errno set and no file
   left. At most 8 are open at once. replace_finish or replace_cancel must
   follow; both free the name. */
int replace_begin(const char *path, mode_t mode, char **temporary);

/* Gives the file its final name, so that the name always means the old file
   or the whole new one; with `only_new` it fails, with EEXIST, if a file of
   this name exists. On failure removes the temporary and returns false,
   with errno set. The file is not forced to disk (fsync): a power cut may
   spoil it. */
bool replace_finish(char *temporary, const char *path, bool only_new);

/* Removes the temporary file and frees its name; keeps errno; ignores
   NULL. */
void replace_cancel(char *temporary);

/* Moves a descriptor above the standard three and returns it, or -1. A
   program started with standard output closed gets 1 for the first file it
   opens, and all that is meant for the screen would go into that file. */
int replace_above(int file);

/* Writes these bytes to path, replacing it in one step; on failure leaves
   path as it was and returns false, with errno set. mode and only_new are
   as for replace_begin and replace_finish. */
bool replace_file(const char *path, const void *bytes, size_t length,
                  mode_t mode, bool only_new);

/* Prepares this process for ending early: an exit and the signals that end
   it then remove the temporaries first, and writing to a closed pipe is an
   error instead of a signal. Returns false if that was done before. */
bool replace_prepare(void);

/* Removes every temporary of this process. May be called in a signal
   handler. The process must end afterwards. */
void replace_abandon(void);

/* Returns whether a file written to path (NULL, "-": standard output) would
   replace the regular file that is read as input ("-": standard input), as
   when somebody types a scene's name where an output belongs. */
bool replace_loses(const char *path, const char *input);

#endif
