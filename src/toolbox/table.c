/* Writes to a temporary file, which is renamed when all is written. */
/* If a program wrote straight to the final name, a run killed half way
   would leave a file that looks like a result, and the good table of
   yesterday would be gone. Renaming in one folder is a single act of the
   file system: the name always means the old table or the whole new one. */
#define _XOPEN_SOURCE 700 /* for realpath, which follows links */

#include "toolbox/lines.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct table *tables; /* all that are open */

/* The temporaries to be removed if the process ends early: plain pointers,
   NULL for a free place, since a signal handler may read them at any
   moment, in the middle of malloc or printf. A child of fork inherits the
   list but must not remove what its parent is writing: hence `owner`. */
enum { MOST_FILES = 8 };
static char *volatile temporaries[MOST_FILES];
static pid_t owner;

/* unlink is one of the few functions that a signal handler may call. Only
   SIGKILL leaves a file bonkers.XXXXXX behind, and never half a table under
   its final name. */
void table_abandon(void)
{
    for (int i = 0; i < MOST_FILES && owner == getpid(); ++i)
        if (temporaries[i])
            unlink(temporaries[i]);
}

/* Replaces an entry: adds `new` with an `old` of NULL, removes `old` with a
   `new` of NULL. Returns false, with errno set, if the list is full. */
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
    table_abandon();
    signal(number, SIG_DFL);
    raise(number);
}

/* Prepares this process, once, for ending early. A child of fork is a new
   process: it forgets the files of its parent but has inherited the call at
   exit. SIGPIPE (the reader of a pipe has gone) and SIGXFSZ (a limit on the
   size of files) kill silently; ignored, they become errors of write, which
   can be reported. Signals that are ignored, as under nohup, or that
   somebody handles stay as they are. */
static void prepare_process(void)
{
    static const int fatal[] = {SIGHUP,  SIGINT,  SIGQUIT,
                                SIGTERM, SIGABRT, SIGXCPU};
    struct sigaction old;
    if (owner == getpid())
        return;
    if (owner == 0)
        atexit(table_abandon);
    for (int i = 0; i < MOST_FILES; ++i)
        temporaries[i] = NULL;
    tables = NULL;
    owner = getpid();
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; ++i)
        if (sigaction(fatal[i], NULL, &old) == 0 &&
            old.sa_handler == SIG_DFL)
            signal(fatal[i], die_tidily);
}

/* Prints the one line that tells why there is no table. */
static void complain(const char *program, const char *path,
                     const char *reason)
{
    fprintf(stderr, "%s: cannot write %s%s%s: %s\n", program,
            path ? "'" : "", path ? path : "standard output",
            path ? "'" : "", reason);
}

uint64_t table_sum(uint64_t sum, const char *bytes, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum = (sum ^ (unsigned char)bytes[i]) * UINT64_C(1099511628211);
    return sum;
}

bool table_sum_so_far(struct table *t, uint64_t *sum)
{
    char piece[BUFSIZ];
    lines_release_head(t);
    ssize_t n = fflush(t->stream) == 0 ? 1 : -1;
    *sum = TABLE_NOTHING;
    for (off_t done = 0; n > 0; done += n) {
        n = pread(fileno(t->stream), piece, sizeof piece, done);
        *sum = table_sum(*sum, piece, n > 0 ? (size_t)n : 0);
    }
    return n == 0;
}

static void free_table(struct table *t)
{
    if (!t)
        return;
    for (struct table **link = &tables; *link; link = &(*link)->next)
        if (*link == t) {
            *link = t->next;
            break;
        }
    free(t->name);
    free(t->path);
    free(t->temporary);
    free(t);
}

/* Removes the temporary unless it was renamed, and frees the table. The
   entry of `temporaries` is cleared before its name is freed, for a signal
   may come in between; no handler reads `tables`. */
static void forget_table(struct table *t, bool renamed)
{
    if (t->temporary && !renamed)
        unlink(t->temporary);
    if (t->temporary)
        swap_temporary(t->temporary, NULL);
    free_table(t);
}

/* Opens a stream on a descriptor above the standard three. A program
   started with standard output closed gets 1 for the first file it opens,
   and all that is meant for the screen would go into the table. */
static bool open_stream(struct table *t, int file)
{
    int high = file;
    if (0 <= file && file <= STDERR_FILENO) {
        high = fcntl(file, F_DUPFD, STDERR_FILENO + 1);
        close(file);
    }
    t->stream = high == -1 ? NULL : fdopen(high, "w");
    return t->stream != NULL;
}

/* Makes the temporary and opens it; returns false, with errno set and no
   file left. Its name is short and of its own: an ending behind the final
   name could pass the limit of a file name, mostly 255 bytes. mkstemp makes
   a file that only its owner can read, so the permissions are set. errno is
   saved because unlink may overwrite it. */
static bool open_temporary(struct table *t, mode_t mode)
{
    const int folder = (int)(strrchr(t->path, '/') - t->path);
    const size_t size = (size_t)folder + sizeof "/bonkers.XXXXXX";
    t->temporary = malloc(size);
    if (!t->temporary)
        return false;
    snprintf(t->temporary, size, "%.*s/bonkers.XXXXXX", folder, t->path);
    const int file = mkstemp(t->temporary);
    if (file == -1)
        return false;
    if (swap_temporary(NULL, t->temporary) && fchmod(file, mode) == 0 &&
        open_stream(t, file))
        return true;
    const int error = errno;
    unlink(t->temporary);
    swap_temporary(t->temporary, NULL);
    errno = error;
    return false;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* Returns whether an open table goes to the same place; errno is then 0,
   since the system has no number for that. Two tables on one file would
   replace each other silently. Names may differ (x, ./x, a link), so the
   resolved names are compared, and for existing files device and inode. A
   device may be opened twice. */
static bool is_taken(const struct table *t)
{
    errno = 0;
    for (const struct table *u = tables; u; u = u->next) {
        if (t->path && u->path && strcmp(t->path, u->path) == 0)
            return true;
        if (t->exists && u->exists && !S_ISCHR(t->file.st_mode) &&
            is_same(&t->file, &u->file))
            return true;
    }
    return false;
}

bool table_replaces(const char *path, const char *input)
{
    struct stat in, out;
    if (!path || strcmp(path, "-") == 0)
        return false;
    const int found = strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in)
                                              : stat(input, &in);
    return found == 0 && S_ISREG(in.st_mode) && stat(path, &out) == 0 &&
           is_same(&in, &out);
}

/* Returns the descriptor that already writes this file, or -1. Looks at 0
   to 9, which a shell can hand over. After `-o /dev/stdout >>log` a new
   file in log's place would lose what log had. A descriptor that only reads
   does not count: with `-o gas.dat <gas.dat` the old table can be read to
   its end while the new one grows beside it. */
static int find_descriptor(const struct stat *file)
{
    struct stat status;
    for (int i = 0; i < 10; ++i)
        if (fstat(i, &status) == 0 && is_same(&status, file) &&
            (fcntl(i, F_GETFL) & O_ACCMODE) != O_RDONLY)
            return i;
    return -1;
}

/* Returns whether a path leads to devices or processes, which are written
   in place. Files in /dev/shm are ordinary ones, kept in memory. */
static bool is_special(const char *path)
{
    if (strncmp(path, "/dev/shm/", 9) == 0)
        return false;
    return strncmp(path, "/dev/", 5) == 0 ||
           strncmp(path, "/proc/", 6) == 0;
}

/* Returns the final name of a file that does not exist yet, to be freed, or
   NULL: realpath needs an existing file, so it resolves the folder. */
static char *resolve_new(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *last = slash ? slash + 1 : path;
    char *folder = strndup(path, (size_t)(last - path)), *name = NULL;
    char *real = folder ? realpath(slash ? folder : ".", NULL) : NULL;
    const size_t size = real ? strlen(real) + strlen(last) + 2 : 0;
    if (real && (name = malloc(size)))
        snprintf(name, size, "%s/%s", real, last);
    free(folder);
    free(real);
    return name;
}

/* Opens what `path` names (NULL: standard output). Returns false with errno
   set, or 0 if another table goes there.

   - fstat notices a closed standard output before an hour is computed.
   - A file that this process writes already is opened by a copy of the
     descriptor: both share one position, so nothing is written over.
   - What must not be replaced is opened with O_APPEND, which adds to what
     is there, and without O_CREAT, so that the mistyped /dev/nul is an
     error and no new file.
   - Replacing a file needs permission for its folder only; but a table made
     read-only is meant to stay, so access() asks for the file as well.
   - A name that lstat finds and stat does not is a link to nothing; an
     empty name comes from an unset variable of a script. Both are refused
     now and not after the run.
   - The mask of the process can only be read by setting it, twice. */
static bool open_table(struct table *t, const char *path)
{
    if (!path) {
        t->stream = stdout;
        t->exists = fstat(STDOUT_FILENO, &t->file) == 0;
        return t->exists && !is_taken(t);
    }
    t->name = strdup(path);
    if (!t->name)
        return false;
    t->exists = stat(path, &t->file) == 0;
    const int given = t->exists ? find_descriptor(&t->file) : -1;
    if (given != -1)
        return !is_taken(t) && open_stream(t, dup(given));
    if ((t->exists && !S_ISREG(t->file.st_mode)) || is_special(path))
        return !is_taken(t) &&
               open_stream(t, open(path, O_WRONLY | O_APPEND));
    struct stat link;
    if (t->exists && access(path, W_OK) != 0)
        return false;
    if (!t->exists &&
        (errno != ENOENT || *path == '\0' || lstat(path, &link) == 0))
        return false;
    t->path = t->exists ? realpath(path, NULL) : resolve_new(path);
    if (!t->path)
        return false;
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = t->exists ? t->file.st_mode & 0777 : 0666 & ~mask;
    return !is_taken(t) && open_temporary(t, mode);
}

/* Keeps the head in memory until there is a row. A program often finds what
   is wrong with a command or a file only after it has begun a table: then a
   head alone on standard output would look like the result of a run. */
static void hold_head(struct table *t)
{
    FILE *memory = open_memstream(&t->head, &t->head_size);
    if (!memory) /* then it is written at once */
        return;
    t->held = t->stream;
    t->stream = memory;
}

struct table *table_open(const char *program, const char *path)
{
    struct table *t = calloc(1, sizeof *t);
    prepare_process();
    if (path && strcmp(path, "-") == 0)
        path = NULL;
    if (t && open_table(t, path)) {
        hold_head(t);
        t->program = program;
        t->next = tables;
        tables = t;
        return t;
    }
    complain(program, path,
             errno ? strerror(errno) : "another output goes there already");
    free_table(t);
    return NULL;
}

void table_keys(struct table *t, const struct table_key keys[])
{
    t->keys = keys;
}

/* Returns whether all keys before the first heading have been written. */
static bool is_complete(const struct table *t)
{
    const struct table_key *k = t->keys;
    while (k && k->name && t->written >> (k - t->keys) & 1)
        ++k;
    return !k || !k->name || !*k->name;
}

/* Only now is it known whether all was written: the buffer is flushed and
   the file closed before the temporary takes the final name. */
bool table_close(struct table *t)
{
    if (!t)
        return true;
    assert(is_complete(t));
    lines_release_head(t);
    lines_note_error(t, fflush(t->stream) == 0 && !ferror(t->stream));
    if (t->name)
        lines_note_error(t, fclose(t->stream) == 0);
    if (t->temporary && t->error == 0)
        lines_note_error(t, rename(t->temporary, t->path) == 0);
    const bool good = t->error == 0;
    if (!good)
        complain(t->program, t->name, strerror(t->error));
    forget_table(t, good);
    return good;
}

void table_discard(struct table *t)
{
    if (t && t->held) { /* a head without rows is not written */
        fclose(t->stream);
        free(t->head);
        t->stream = t->held;
    }
    if (t && t->name)
        fclose(t->stream);
    if (t)
        forget_table(t, false);
}
