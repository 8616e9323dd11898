/* Writes files that are whole or absent, under a temporary name first. */
#ifndef TOOLBOX_REPLACE_H
#define TOOLBOX_REPLACE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* As the mode of a new file: what the process's mask leaves of 0666. */
#define REPLACE_USUAL ((mode_t)(-1))

/* Makes a file with these permissions in the folder of path, under a name
   of its own, bonkers.XXXXXX. Returns its descriptor, above the standard
   three, and its name in *temporary; or -1, with errno set and no file
   left. At most 8 are open at once. One of the two functions below has to
   follow; both free the name. */
int replace_begin(const char *path, mode_t mode, char **temporary);

/* Gives the file its final name, so that the name always means the old file
   or the whole new one; with `only_new` that fails, with EEXIST, if there
   is a file of this name already. Returns false, with errno set and the
   temporary removed, if it cannot. Nothing waits for the disk: a power cut
   may spoil the file. */
bool replace_finish(char *temporary, const char *path, bool only_new);

/* Removes the temporary; errno stays. NULL is nothing to remove. */
void replace_cancel(char *temporary);

/* Moves a descriptor above the standard three and returns it, or -1. A
   program started with standard output closed gets 1 for the first file it
   opens, and all that is meant for the screen would go into the file. */
int replace_above(int file);

/* Writes these bytes to path, which is replaced in one step, or not at all;
   returns false then, with errno set. */
bool replace_file(const char *path, const void *bytes, size_t length,
                  mode_t mode, bool only_new);

/* Prepares this process for ending early: an exit and the signals that end
   it then remove the temporaries first, and writing to a closed pipe is an
   error instead of a signal. Returns false if that was done before. */
bool replace_prepare(void);

/* Removes every temporary of this process. May be called in a signal
   handler. After it the process has to end. */
void replace_abandon(void);

/* Returns whether a file written to path (NULL, "-": standard output) would
   replace the regular file that is read as input ("-": standard input):
   whoever types a scene's name where an output belongs would lose it. */
bool replace_loses(const char *path, const char *input);

#endif
