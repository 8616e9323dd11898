/* Creates, renames and removes temporary files. */
/* If a program wrote directly to the final name, a run killed half way
   would leave a file that looks like a result, and the previous result
   would be lost. The file system renames a file within a folder in a single
   step. */
#include "toolbox/replace.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The temporary files to be removed if the process ends early; NULL marks a
   free entry. The entries are plain pointers, because a signal handler may
   read them at any moment, even during malloc. A child process inherits the
   list but must not remove the files of its parent. So `owner' is the
   process that filled the list. */
enum { MOST_FILES = 8 };
static char *volatile temporaries[MOST_FILES];
static pid_t owner;

/* unlink is one of the few functions that a signal handler may call. Only
   SIGKILL leaves a file bonkers.XXXXXX behind, and no signal leaves half a
   table under its final name. */
void replace_abandon(void)
{
    for (int i = 0; i < MOST_FILES && owner == getpid(); ++i)
        if (temporaries[i])
            unlink(temporaries[i]);
}

/* Adds new if old is NULL, and removes old if new is NULL. If the list is
   full, sets errno and returns false. */
static bool swap_temporary(const char *old, char *new)
{
    for (int i = 0; i < MOST_FILES; ++i)
        if (temporaries[i] == old) {
            temporaries[i] = new;
            return true;
        }
    errno = EMFILE;
    return false;
}

/* Removes the temporary files, then ends the process with the same signal,
   which tells the shell why the process ended. */
static void die_tidily(int number)
{
    replace_abandon();
    signal(number, SIG_DFL);
    raise(number);
}

/* A child process forgets the files of its parent but inherits the function
   registered with atexit. By default SIGPIPE (the reader of a pipe has
   ended) and SIGXFSZ (a file exceeds the size limit) kill a process without
   a message. If they are ignored, write returns an error instead, which can
   be reported. Other signals stay as they are if they are already handled
   or ignored, as under nohup. */
bool replace_prepare(void)
{
    static const int fatal[] = {SIGHUP,  SIGINT,  SIGQUIT,
                                SIGTERM, SIGABRT, SIGXCPU};
    struct sigaction old;
    if (owner == getpid())
        return false;
    if (owner == 0)
        atexit(replace_abandon);
    for (int i = 0; i < MOST_FILES; ++i)
        temporaries[i] = NULL;
    owner = getpid();
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; ++i)
        if (sigaction(fatal[i], NULL, &old) == 0 &&
            old.sa_handler == SIG_DFL)
            signal(fatal[i], die_tidily);
    return true;
}

/* Clears the entry of the list before the name is freed, because a signal
   may come in between. Saves errno, because unlink may overwrite it. */
static void forget(char *temporary, bool renamed)
{
    const int error = errno;
    if (temporary && !renamed)
        unlink(temporary);
    if (temporary)
        swap_temporary(temporary, NULL);
    free(temporary);
    errno = error;
}

void replace_cancel(char *temporary)
{
    forget(temporary, false);
}

int replace_above(int file)
{
    if (file < 0 || file > STDERR_FILENO)
        return file;
    const int high = fcntl(file, F_DUPFD, STDERR_FILENO + 1);
    close(file);
    return high;
}

/* The name of the temporary file is short: the final name with an ending
   could exceed the limit for file names, usually 255 bytes. The permissions
   must be set, because mkstemp creates a file that only its owner can read.
   umask is called twice, because reading the mask also sets it. */
int replace_begin(const char *path, mode_t mode, char **temporary)
{
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path + 1) : 0;
    const size_t size = (size_t)folder + sizeof "bonkers.XXXXXX";
    char *name = malloc(size);
    *temporary = NULL;
    if (!name)
        return -1;
    snprintf(name, size, "%.*sbonkers.XXXXXX", folder, path);
    const int file = mkstemp(name);
    if (file == -1) {
        free(name);
        return -1;
    }
    if (mode == REPLACE_USUAL) {
        const mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    if (swap_temporary(NULL, name) && fchmod(file, mode) == 0) {
        *temporary = name;
        return replace_above(file);
    }
    forget(name, false);
    close(file);
    return -1;
}

/* If only_new is true, calls link(), which fails if `path' exists. rename()
   would replace the file. */
bool replace_finish(char *temporary, const char *path, bool only_new)
{
    const bool done = only_new ? link(temporary, path) == 0
                               : rename(temporary, path) == 0;
    forget(temporary, done && !only_new);
    return done;
}

bool replace_file(const char *path, const void *bytes, size_t length,
                  mode_t mode, bool only_new)
{
    char *temporary;
    const char *rest = bytes, *end = rest + length;
    const int file = replace_begin(path, mode, &temporary);
    ssize_t written = file == -1 ? -1 : 0;
    while (written >= 0 && rest < end) {
        written = write(file, rest, (size_t)(end - rest));
        rest += written > 0 ? written : 0;
    }
    if (file != -1 && close(file) != 0)
        written = -1;
    if (written >= 0)
        return replace_finish(temporary, path, only_new);
    replace_cancel(temporary);
    return false;
}

bool replace_loses(const char *path, const char *input)
{
    struct stat in, out;
    if (!path || strcmp(path, "-") == 0)
        return false;
    const int found = strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in)
                                              : stat(input, &in);
    return found == 0 && S_ISREG(in.st_mode) && stat(path, &out) == 0 &&
           in.st_dev == out.st_dev && in.st_ino == out.st_ino;
}
