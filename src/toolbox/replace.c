/* Creates temporary files, renames them, removes them at an early end. */
/* If a program wrote straight to the final name, a run killed half way
   would leave a file that looks like a result, and the previous result
   would be lost. Renaming within a folder is a single act of the file
   system. */
#include "toolbox/replace.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The temporaries to be removed if the process ends early: plain pointers,
   NULL for a free place, since a signal handler may read them at any
   moment, in the middle of malloc or printf. A child of fork inherits the
   list but must not remove what its parent is writing: hence `owner`, the
   process that filled the list. */
enum { MOST_FILES = 8 };
static char *volatile temporaries[MOST_FILES];
static pid_t owner;

/* Removes the files by unlink, one of the few functions that a signal
   handler may call. Only SIGKILL leaves a file bonkers.XXXXXX behind, and
   never half a table under its final name. */
void replace_abandon(void)
{
    for (int i = 0; i < MOST_FILES && owner == getpid(); ++i)
        if (temporaries[i])
            unlink(temporaries[i]);
}

/* Replaces an entry: adds `new` if `old` is NULL, removes `old` if `new` is
   NULL. Returns false, with errno set, if the list is full. */
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

/* Removes the temporaries, then ends the process by the same signal, so
   that the shell learns what ended it. */
static void die_tidily(int number)
{
    replace_abandon();
    signal(number, SIG_DFL);
    raise(number);
}

/* Forgets, in a child of fork, the files of its parent; the call at exit is
   inherited. SIGPIPE (the reader of a pipe has gone) and SIGXFSZ (a limit
   on the size of files) kill silently; ignored, they become errors of
   write, which can be reported. Signals that are ignored, as under nohup,
   or handled already stay as they are. */
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

/* Removes a temporary, or forgets one that was renamed. Its entry in the
   list is cleared before the name is freed, since a signal may come in
   between. errno is saved because unlink may overwrite it. */
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

/* Creates a file with a short name: the final name with an ending could
   exceed the limit for file names, mostly 255 bytes. Sets the permissions,
   since only the owner can read what mkstemp creates. The process's mask is
   set twice, since it can be read in no other way. */
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

/* Calls link for only_new: it fails if the name exists, where rename would
   replace the file. */
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
