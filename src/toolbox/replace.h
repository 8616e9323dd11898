/* Writes files under temporary names and renames them when complete. */
#ifndef TOOLBOX_REPLACE_H
#define TOOLBOX_REPLACE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* Mode of a new file: 0666 without the bits of the process's umask. */
#define REPLACE_USUAL ((mode_t)(-1))

/* Creates a temporary file with the permissions `mode' in the folder of
   path, with a unique name, bonkers.XXXXXX. Returns its descriptor, which
   is above 2, and sets *temporary to its name. On failure returns -1, sets
   errno and leaves no file. At most 8 temporary files exist at once. After
   success the caller must call replace_finish or replace_cancel; both free
   the name. */
int replace_begin(const char *path, mode_t mode, char **temporary);

/* Renames the temporary file to `path' in a single step, so path always
   names the old file or the complete new file. If only_new is true and path
   exists, fails with EEXIST. On failure removes the temporary file, sets
   errno and returns false. The file is not forced to disk (fsync), so a
   power cut may damage it. */
bool replace_finish(char *temporary, const char *path, bool only_new);

/* Removes the temporary file and frees its name. Keeps errno. Ignores
   NULL. */
void replace_cancel(char *temporary);

/* Returns the descriptor `file' if it is above 2. Otherwise moves it above
   2 and returns the new descriptor, or -1 on failure. If a program is
   started with standard output closed, the first file that it opens gets
   the descriptor 1, and all output meant for the screen would go into that
   file. */
int replace_above(int file);

/* Writes length bytes to path and replaces an existing file in a single
   step. On failure leaves path as it was, sets errno and returns false. See
   replace_begin for mode and replace_finish for only_new. */
bool replace_file(const char *path, const void *bytes, size_t length,
                  mode_t mode, bool only_new);

/* Prepares this process for ending early. From then on, exit() and fatal
   signals first remove the temporary files, and writing to a closed pipe is
   an error instead of a signal. Returns false if the process is already
   prepared. */
bool replace_prepare(void);

/* Removes all temporary files of this process. May be called in a signal
   handler. The process must end afterwards. */
void replace_abandon(void);

/* Returns whether writing to path (NULL or "-": standard output) would
   replace the regular file that is read as `input' ("-": standard input).
   This happens if a user gives the name of an input file as the output. */
bool replace_loses(const char *path, const char *input);

#endif
